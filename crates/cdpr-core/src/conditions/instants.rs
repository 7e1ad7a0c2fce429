//! Instants of a motion at which linear and quadratic functions of time are extreme, zero or positive.

use crate::tolerances::TOUCH_DEPTH;

/// Where the quotient of two quadratics has slope zero: N' D - N D' = 0, itself a quadratic. A missing root is not
/// finite.
pub fn stationary_points(n: &[f64; 3], d: &[f64; 3]) -> [f64; 2] {
    let a = n[2] * d[1] - n[1] * d[2];
    let b = 2.0 * (n[2] * d[0] - n[0] * d[2]);
    let c = n[1] * d[0] - n[0] * d[1];
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let q = -0.5 * (b + root.copysign(b));
    [q / a, c / q]
}

/// First and last instant at which a motion is in a plane, given linear heights over it from `s0` to `s1`: the instant
/// of crossing, extended to an end that already touches the plane.
pub fn instants_in_plane(s0: f64, s1: f64) -> Option<(f64, f64)> {
    let crossing = ((s0 > 0.0) != (s1 > 0.0)).then(|| s0 / (s0 - s1));
    match (s0.abs() <= TOUCH_DEPTH, s1.abs() <= TOUCH_DEPTH) {
        (true, true) => Some((0.0, 1.0)),
        (true, false) => Some((0.0, crossing.unwrap_or(0.0))),
        (false, true) => Some((crossing.unwrap_or(1.0), 1.0)),
        (false, false) => crossing.map(|t| (t, t)),
    }
}

/// Whether two linear functions, given at both ends of an interval, are both positive somewhere on it.
pub fn both_positive_somewhere(a: [f64; 2], b: [f64; 2]) -> bool {
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for (start, end) in [(a[0], b[0]), (a[1], b[1])] {
        match (start > 0.0, end > 0.0) {
            (true, true) => {}
            (false, false) => return false,
            (false, true) => low = low.max(start / (start - end)),
            (true, false) => high = high.min(start / (start - end)),
        }
    }
    low < high
}
