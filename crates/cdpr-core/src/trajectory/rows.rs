//! Limits on the motion along a curve, as limits on two numbers.
//!
//! With q(s) the curve and s(t) the progress on it, velocity and acceleration are q' ṡ and q' s̈ + q'' ṡ². So at each
//! parameter every limit but that of jerk is linear in (u, x) = (s̈, ṡ²), or an ellipse (the norm of the acceleration). The same
//! holds where the platform turns, with the angular rate Ω per parameter: velocity and acceleration are Ω ṡ and Ω s̈ + Ω' ṡ². Standing
//! still, (0, 0), keeps all of them.
//!
//! Source: J. E. Bobrow, S. Dubowsky and J. S. Gibson, "Time-optimal control of robotic manipulators along specified paths",
//! International Journal of Robotics Research 4(3), 1985; tensions as facets of the available wrench set as in
//! [`crate::wrench::zonotope`].

use super::jet::Jet;
use super::winches::{Line, Winches};
use crate::geometry::Vector;
use crate::model::spec::MotionSpec;

/// A linear limit `a u + b x ≤ c`, with c ≥ 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Coefficient of u = s̈.
    pub a: f64,
    /// Coefficient of x = ṡ².
    pub b: f64,
    /// Upper limit of the sum.
    pub c: f64,
}

impl Row {
    /// Whether the row limits x alone.
    fn limits_x(&self) -> bool {
        self.a == 0.0 && self.b > 0.0
    }
}

/// The limit `|first u + second x| ≤ radius`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    /// Coefficient of u = s̈.
    pub first: Vector,
    /// Coefficient of x = ṡ².
    pub second: Vector,
    /// Upper limit of the norm.
    pub radius: f64,
}

/// All limits at one parameter of a curve.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rows {
    /// Linear limits.
    pub linear: Vec<Row>,
    /// The limit of the platform's acceleration, if there is one.
    pub ellipse: Option<Ellipse>,
    /// The limit of the platform's angular acceleration where the angular rate changes, if there is one.
    pub turn: Option<Ellipse>,
}

impl Rows {
    /// The limits at places of a curve. An error is the index of the first place at which the cables cannot hold the platform
    /// at rest, or one cannot leave its pulley.
    pub fn along(jets: &[Jet], limits: &MotionSpec, winches: &Winches) -> Result<Vec<Self>, usize> {
        let stuck = |jet: &Jet| {
            let lost = |cable: &Line| cable.pulley.is_some() && cable.length(&jet.position, &jet.orientation).is_nan();
            winches.cables().iter().any(lost)
        };
        if let Some(k) = jets.iter().position(stuck) {
            return Err(k);
        }
        let mut rows: Vec<Rows> = jets.iter().map(|jet| Rows::kinematic(jet, limits, winches)).collect();
        let places: Vec<(Jet, [f64; 2])> = jets.iter().zip(&rows).map(|(jet, rows)| (*jet, rows.most())).collect();
        winches.for_each_tension_limit(&places, |k, [a, b, c]| rows[k].linear.push(Row { a, b, c }))?;
        rows.iter_mut().for_each(Rows::prune);
        Ok(rows)
    }

    /// The largest |u| and x that the limits of speed and acceleration allow; infinite if these do not limit x.
    fn most(&self) -> [f64; 2] {
        let Some(ellipse) = &self.ellipse else { return [f64::INFINITY; 2] };
        let alone = self.linear.iter().filter(|row| row.limits_x()).map(|row| row.c / row.b);
        let most_x = alone.fold(ellipse.widest(), f64::min);
        if !most_x.is_finite() {
            return [f64::INFINITY; 2];
        }
        [(ellipse.radius + ellipse.second.norm() * most_x) / ellipse.first.norm(), most_x]
    }

    /// Removes rows that the limits of speed and acceleration make redundant.
    fn prune(&mut self) {
        let [most_u, most_x] = self.most();
        if most_x.is_finite() {
            let reached = |row: &Row| row.a.abs() * most_u + row.b.max(0.0) * most_x > row.c;
            self.linear.retain(|row| row.limits_x() && row.c / row.b <= most_x || !row.limits_x() && reached(row));
        }
    }

    /// Whether the rows limit how fast the progress accelerates.
    pub fn limits_acceleration(&self) -> bool {
        let linear = self.linear.iter().any(|row| row.a.abs() * LARGEST > row.c);
        self.ellipses().any(|ellipse| ellipse.first.norm() * LARGEST > ellipse.radius) || linear
    }

    fn ellipses(&self) -> impl Iterator<Item = &Ellipse> {
        self.ellipse.iter().chain(&self.turn)
    }

    /// All limits at a place except those of tensions.
    fn kinematic(jet: &Jet, limits: &MotionSpec, winches: &Winches) -> Self {
        let mut linear = Vec::with_capacity(ROWS_OF_PLATFORM + ROWS_OF_CABLE * winches.cables().len());
        if let Some(speed) = limits.speed {
            linear.push(Row { a: 0.0, b: jet.first.norm_squared(), c: speed * speed });
        }
        if let Some(jerk) = limits.jerk.filter(|_| jet.third.norm() > 0.0) {
            // At constant progress; the rest of the jerk is known only once the timing is.
            linear.push(Row { a: 0.0, b: 1.0, c: (jerk / jet.third.norm()).powf(2.0 / 3.0) });
        }
        if jet.spin != Vector::zeros() {
            linear.extend(turn_rows(jet, limits));
        }
        let changes = |_: &f64| jet.spin_change != Vector::zeros();
        let turn = limits.turn_acceleration.filter(changes);
        let turn = turn.and_then(|most| Ellipse::limiting([jet.spin, jet.spin_change], most, &mut linear));
        for cable in winches.cables() {
            let arm = cable.arm(&jet.orientation);
            let [first, second] = jet.of_point(&arm);
            let [rate, bend] = cable.rates(&(jet.position + arm), [&first, &second]);
            if let Some(speed) = limits.cable_speed {
                linear.push(Row { a: 0.0, b: rate * rate, c: speed * speed });
            }
            if let Some(most) = limits.cable_acceleration {
                linear.push(Row { a: rate, b: bend, c: most });
                linear.push(Row { a: -rate, b: -bend, c: most });
            }
        }
        let ellipse = limits.acceleration;
        let ellipse = ellipse.and_then(|most| Ellipse::limiting([jet.first, jet.second], most, &mut linear));
        Rows { linear, ellipse, turn }
    }

    /// Divides these limits by a factor: motions that keep the original limits may exceed the new ones by the factor,
    /// in forces and squared speeds.
    pub fn tighten(&mut self, factor: f64) {
        self.linear.iter_mut().for_each(|row| row.c /= factor);
        self.ellipse.iter_mut().chain(&mut self.turn).for_each(|ellipse| ellipse.radius /= factor);
    }
}

/// The limits of angular speed and, where the angular rate does not change, acceleration.
fn turn_rows(jet: &Jet, limits: &MotionSpec) -> impl Iterator<Item = Row> {
    let (spin, steady) = (jet.spin.norm(), jet.spin_change == Vector::zeros());
    let speed = limits.turn_speed.map(|speed| Row { a: 0.0, b: spin * spin, c: speed * speed });
    let acceleration =
        limits.turn_acceleration.filter(|_| steady).map(|most| [spin, -spin].map(|a| Row { a, b: 0.0, c: most }));
    speed.into_iter().chain(acceleration.into_iter().flatten())
}

/// About as many rows as there are for the platform and for each cable.
const ROWS_OF_PLATFORM: usize = 8;
const ROWS_OF_CABLE: usize = 3;

/// Coefficients of u below this share of those of x count as zero: the row limits x alone.
const NEGLIGIBLE: f64 = 1e-12;

/// The limits that hold while u is constant between two parameters, given the x at the first: those at both ends, and those
/// of the x that may be reached.
#[derive(Debug, Default)]
pub struct Interval {
    /// u ≤ α − β x: upper limits as (α, β).
    upper: Vec<[f64; 2]>,
    /// u ≥ α − β x: lower limits.
    lower: Vec<[f64; 2]>,
    ellipses: [Option<Ellipse>; 4],
    /// The largest x that rows without u allow.
    most: f64,
}

/// The range of u at some x, and how its ends change with x.
#[derive(Debug, Clone, Copy)]
struct Range {
    low: f64,
    low_slope: f64,
    high: f64,
    high_slope: f64,
}

impl Interval {
    /// The limits between two parameters `step` apart. At the second one x is at most `reach`.
    pub fn set(&mut self, first: &Rows, second: &Rows, step: f64, reach: f64) {
        self.upper.clear();
        self.lower.clear();
        self.most = f64::INFINITY;
        for row in &first.linear {
            self.push(row.a, row.b, row.c);
        }
        // At the second parameter x is x + 2 step u.
        for row in &second.linear {
            self.push(row.a + 2.0 * step * row.b, row.b, row.c);
        }
        self.push(2.0 * step, 1.0, reach);
        self.push(-2.0 * step, -1.0, 0.0);
        // Where an angular rate reverses, its first vector may vanish.
        let mut rows = Vec::new();
        let mut moved = |Ellipse { first, second, radius }| {
            Ellipse::limiting([first + second * (2.0 * step), second], radius, &mut rows)
        };
        let later = [second.ellipse, second.turn].map(|ellipse| ellipse.and_then(&mut moved));
        self.ellipses = [first.ellipse, later[0], first.turn, later[1]];
        rows.iter().for_each(|row| self.push(row.a, row.b, row.c));
        for ellipse in self.ellipses.iter().flatten() {
            self.most = self.most.min(ellipse.widest());
        }
    }

    fn push(&mut self, a: f64, b: f64, c: f64) {
        if a.abs() <= NEGLIGIBLE * b.abs() {
            if b > 0.0 {
                self.most = self.most.min(c / b);
            }
        } else if a > 0.0 {
            self.upper.push([c / a, b / a]);
        } else if a < 0.0 {
            self.lower.push([c / a, b / a]);
        }
    }

    /// The range of u at some x.
    fn range(&self, x: f64) -> Range {
        let mut range = Range { low: f64::NEG_INFINITY, low_slope: 0.0, high: f64::INFINITY, high_slope: 0.0 };
        for [alpha, beta] in &self.upper {
            let value = alpha - beta * x;
            if value < range.high {
                (range.high, range.high_slope) = (value, -beta);
            }
        }
        for [alpha, beta] in &self.lower {
            let value = alpha - beta * x;
            if value > range.low {
                (range.low, range.low_slope) = (value, -beta);
            }
        }
        for ellipse in self.ellipses.iter().flatten() {
            let own = ellipse.range(x);
            if own.high < range.high {
                (range.high, range.high_slope) = (own.high, own.high_slope);
            }
            if own.low > range.low {
                (range.low, range.low_slope) = (own.low, own.low_slope);
            }
        }
        range
    }

    /// The largest x at the first parameter for which some u is allowed: low(x) − high(x) is convex, so its root lies
    /// between that of its tangent at a larger x and that of its chord from a smaller one.
    pub fn most_x(&self) -> f64 {
        let excess = |x: f64| {
            let Range { low, low_slope, high, high_slope } = self.range(x);
            (low - high - ROOT * (low.abs() + high.abs()), low_slope - high_slope)
        };
        let (mut good, mut bad) = (0.0, self.most.min(LARGEST));
        let (mut at_good, (mut at_bad, mut slope)) = (excess(good).0, excess(bad));
        if at_bad <= 0.0 || at_good > 0.0 {
            return if at_bad <= 0.0 { bad } else { 0.0 };
        }
        while bad - good > ROOT * bad {
            let width = bad - good;
            let by_chord = good - at_good * width / (at_bad - at_good);
            let by_tangent = bad - at_bad / slope;
            for x in [by_tangent, by_chord, 0.5 * (good + bad)] {
                if !(good < x && x < bad) || bad - good < 0.5 * width {
                    continue;
                }
                let (value, steepness) = excess(x);
                match value {
                    value if value <= 0.0 => (good, at_good) = (x, value),
                    value => (bad, at_bad, slope) = (x, value, steepness),
                }
            }
            if bad - good >= width {
                break;
            }
        }
        good
    }

    /// The largest u at some x that [`Interval::most_x`] allows.
    pub fn most_u(&self, x: f64) -> f64 {
        let Range { low, high, .. } = self.range(x.min(self.most));
        if high >= low { high } else { 0.5 * (high + low) }
    }
}

/// Squared speeds, m²/s², and accelerations, m/s², of this size count as unlimited.
const LARGEST: f64 = 1e12;
/// Relative difference of the two ends of a range that counts as one point.
const ROOT: f64 = 1e-13;

impl Ellipse {
    /// The limit of |first u + second x|. If the first vector is zero, as in a turn on the spot, u has no effect and the limit is
    /// linear: it becomes a row.
    fn limiting([first, second]: [Vector; 2], radius: f64, linear: &mut Vec<Row>) -> Option<Self> {
        if first.norm_squared() > 0.0 {
            return Some(Ellipse { first, second, radius });
        }
        let bend = second.norm();
        if bend > 0.0 {
            linear.push(Row { a: 0.0, b: bend, c: radius });
        }
        None
    }

    /// The largest x that the ellipse allows.
    fn widest(&self) -> f64 {
        // The part of `second` across `first`, which no u can compensate.
        let along = self.first.dot(&self.second) / self.first.norm_squared();
        let across = (self.second - self.first * along).norm();
        if across > 0.0 { self.radius / across } else { f64::INFINITY }
    }

    /// |first u + second x|² ≤ radius², solved for u.
    fn range(&self, x: f64) -> Range {
        let (p, r) = (self.first.norm_squared(), self.first.dot(&self.second));
        let across = (self.second - self.first * (r / p)).norm_squared() * p;
        let root = (p * self.radius * self.radius - across * x * x).max(0.0).sqrt();
        let slope = if root > 0.0 { across * x / root } else { LARGEST };
        Range {
            low: (-r * x - root) / p,
            low_slope: (-r + slope) / p,
            high: (-r * x + root) / p,
            high_slope: (-r - slope) / p,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ellipse_with_a_vanishing_first_vector_still_limits() {
        let step = 0.25;
        // The acceleration is u − (x + 2 step u) / (2 step), in which u cancels.
        let vanishing = Ellipse { first: Vector::x(), second: Vector::x() * (-0.5 / step), radius: 1.0 };
        for [ellipse, turn] in [[Some(vanishing), None], [None, Some(vanishing)]] {
            let later = Rows { linear: Vec::new(), ellipse, turn };
            let mut interval = Interval::default();
            interval.set(&Rows::default(), &later, step, f64::INFINITY);
            assert!((interval.most_x() - 2.0 * step).abs() < 1e-9, "{}", interval.most_x());
        }
    }
}
