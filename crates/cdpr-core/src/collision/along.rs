//! Searches along a motion, parametrized by the fraction covered, from 0 to 1.

use crate::geometry::Point;
use crate::limits::BISECTION_STEPS;

/// The position at the fraction `t` of a motion.
pub fn at(from: &Point, to: &Point, t: f64) -> Point {
    if t >= 1.0 { *to } else { from + (to - from) * t }
}

/// The ends of a motion in an order that does not depend on its direction. Rounding may decide where bodies overlap by exactly
/// as much as touching allows; with its ends in this order, a motion is valid if and only if the motion back is.
#[inline]
pub fn either_way<'a>(from: &'a Point, to: &'a Point) -> [&'a Point; 2] {
    if (to.x, to.y, to.z) < (from.x, from.y, from.z) { [to, from] } else { [from, to] }
}

/// The first t in [0, 1] where a monotonic test becomes true; it must be true at 1.
pub fn first_true(test: impl Fn(f64) -> bool) -> f64 {
    if test(0.0) {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..BISECTION_STEPS {
        let middle = 0.5 * (low + high);
        if test(middle) { high = middle } else { low = middle }
    }
    high
}

/// A value of a function, and where it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Least {
    /// Parameter at which the value is attained.
    pub at: f64,
    /// Value of the function.
    pub value: f64,
}

impl Least {
    /// The smaller of two values, the first if they are equal; NaN is larger than any number.
    pub fn or(self, other: Least) -> Least {
        if other.value < self.value || self.value.is_nan() { other } else { self }
    }
}

/// Smallest value of a function in an interval: evenly spaced samples, then golden-section search around each local
/// minimum of them. Exact up to rounding for the depth of the platform, which has one minimum along a line.
pub fn least_between(low: f64, high: f64, intervals: usize, value: impl Fn(f64) -> f64) -> Least {
    let step = (high - low).max(0.0) / intervals as f64;
    let sampled: Vec<Least> =
        (0..=intervals).map(|k| low + step * k as f64).map(|at| Least { at, value: value(at) }).collect();
    let around = |k: usize| [k.saturating_sub(1), (k + 1).min(intervals)].map(|k| sampled[k]);
    let valleys = (0..=intervals).filter(|&k| around(k).iter().all(|neighbour| sampled[k].value <= neighbour.value));
    let refined = valleys.map(|k| golden_sections(around(k).map(|end| end.at), sampled[k], &value));
    refined.fold(Least { at: low, value: f64::INFINITY }, Least::or)
}

/// Smallest value found in an interval by golden-section search; exact if there is one minimum.
pub fn golden_sections([mut a, mut b]: [f64; 2], known: Least, value: &impl Fn(f64) -> f64) -> Least {
    const SECTIONS: usize = 40;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    (0..SECTIONS).fold(known, |least, _| {
        let [left, right] = [b - golden * (b - a), a + golden * (b - a)].map(|at| Least { at, value: value(at) });
        if left.value <= right.value {
            b = right.at
        } else {
            a = left.at
        }
        least.or(left).or(right)
    })
}
