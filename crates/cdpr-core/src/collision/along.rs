//! Searches along a motion, parametrized by the fraction covered, from 0 to 1.

use crate::geometry::Point;
use crate::numerics::BISECTION_STEPS;

/// The position at the fraction `t` of a motion.
pub fn at(from: &Point, to: &Point, t: f64) -> Point {
    if t >= 1.0 { *to } else { from + (to - from) * t }
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

/// Smallest value of a function in an interval: samples, then golden-section search around each local minimum. Exact up
/// to rounding for the depth of the platform, which has one minimum along a line.
pub fn least_between(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const SAMPLES: usize = 16;
    let step = (high - low).max(0.0) / SAMPLES as f64;
    let sampled: [f64; SAMPLES + 1] = std::array::from_fn(|k| value(low + step * k as f64));
    let around = |k: usize| [k.saturating_sub(1), (k + 1).min(SAMPLES)];
    let valleys = (0..=SAMPLES).filter(|&k| around(k).iter().all(|&neighbour| sampled[k] <= sampled[neighbour]));
    let refined = valleys.map(|k| {
        let [a, b] = around(k).map(|k| low + step * k as f64);
        golden_sections(a, b, sampled[k], &value)
    });
    refined.fold(f64::INFINITY, f64::min)
}

/// Smallest value found in an interval by golden-section search; exact if there is one minimum.
fn golden_sections(mut a: f64, mut b: f64, known: f64, value: &impl Fn(f64) -> f64) -> f64 {
    const SECTIONS: usize = 40;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    (0..SECTIONS).fold(known, |least, _| {
        let (left, right) = (b - golden * (b - a), a + golden * (b - a));
        let (at_left, at_right) = (value(left), value(right));
        if at_left <= at_right {
            b = right
        } else {
            a = left
        }
        least.min(at_left).min(at_right)
    })
}
