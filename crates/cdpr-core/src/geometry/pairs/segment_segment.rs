//! Closest points of two segments, closed form with clamping. Source: Ericson, Real-Time Collision Detection, 5.1.9.

use crate::geometry::{Point, Vector};
use crate::tolerances::PARALLEL;

/// Nearest points `p0 + s (p1 - p0)` and `q0 + r (q1 - q0)`.
#[derive(Debug, Clone, Copy)]
pub struct SegmentPair {
    /// Distance of the nearest points, m.
    pub distance: f64,
    /// Fraction of the first segment at its nearest point.
    pub s: f64,
    /// Fraction of the second segment at its nearest point.
    pub r: f64,
    /// From the first nearest point to the second, m.
    pub offset: Vector,
}

/// Closest points of the segments `p0 p1` and `q0 q1`; either may be a point, and they may be parallel.
pub fn closest(p0: &Point, p1: &Point, q0: &Point, q1: &Point) -> SegmentPair {
    let (d1, d2, w) = (p1 - p0, q1 - q0, p0 - q0);
    let (a, e, b) = (d1.norm_squared(), d2.norm_squared(), d1.dot(&d2));
    let (c, f) = (d1.dot(&w), d2.dot(&w));
    let at = |s: f64, r: f64| {
        let offset = (q0 + d2 * r) - (p0 + d1 * s);
        SegmentPair { distance: offset.norm(), s, r, offset }
    };
    let on_first = |r: f64| if a > 0.0 { ((b * r - c) / a).clamp(0.0, 1.0) } else { 0.0 };
    let on_second = |s: f64| if e > 0.0 { ((b * s + f) / e).clamp(0.0, 1.0) } else { 0.0 };
    // The nearest pair contains an end of a segment, or lies inside both; every candidate is a valid pair of points.
    let mut best = at(on_first(0.0), 0.0);
    let mut consider = |pair: SegmentPair| {
        if pair.distance < best.distance {
            best = pair;
        }
    };
    consider(at(on_first(1.0), 1.0));
    consider(at(0.0, on_second(0.0)));
    consider(at(1.0, on_second(1.0)));
    let determinant = a * e - b * b;
    if determinant > PARALLEL * PARALLEL * a * e {
        let s = ((b * f - c * e) / determinant).clamp(0.0, 1.0);
        let r = on_second(s);
        consider(at(on_first(r), r));
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64, z: f64) -> Point {
        Point::new(x, y, z)
    }

    #[test]
    fn crossing_parallel_collinear_and_point_segments() {
        let skew = closest(&p(-1., 0., 0.), &p(1., 0., 0.), &p(0., -1., 0.5), &p(0., 1., 0.5));
        assert_eq!((skew.distance, skew.s, skew.r), (0.5, 0.5, 0.5));
        assert_eq!(closest(&p(0., 0., 0.), &p(1., 0., 0.), &p(0.2, 0.3, 0.), &p(5., 0.3, 0.)).distance, 0.3);
        assert_eq!(closest(&p(0., 0., 0.), &p(1., 0., 0.), &p(3., 0., 0.), &p(2., 0., 0.)).distance, 1.0);
        assert_eq!(closest(&p(0., 0., 0.), &p(0., 0., 0.), &p(0., 3., 4.), &p(0., 3., 4.)).distance, 5.0);
    }
}
