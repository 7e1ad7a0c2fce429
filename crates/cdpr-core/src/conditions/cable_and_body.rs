//! A cable and a convex body: code shared by the cable-obstacle and cable-platform conditions.
//!
//! A cable that ends on a body always touches it. It enters the body if its direction is below all facets that are
//! active at that end (`Demand::Leave`). If the cable can take several shapes, each facet counts by the shape that goes lowest.

use super::fattened::between;
use super::region::ForbiddenPolyhedron;
use crate::geometry::gjk::{nearer_than, overlap, proximity, shape_distance};
use crate::geometry::{ConvexShape, HalfSpace, Point, Polytope, Shadow, SupportMap, Vector, shadow};
use crate::tolerances::{ON_SURFACE, PARALLEL, TOUCH_DEPTH};

/// Number of dimensions of a cable.
pub const CABLE: usize = 1;

/// How a cable must stay clear of a convex body.
#[derive(Debug, Clone, PartialEq)]
pub enum CableDemand {
    /// The cable's axis keeps at least `gap` metres from the body; 0 means it must not enter the interior.
    Apart {
        /// Required distance, m.
        gap: f64,
    },
    /// The cable enters the body, which closes a seam, by at most `touch` metres. The adjacent parts enforce the
    /// clearance.
    Outside {
        /// Depth that still counts as touching, m.
        touch: f64,
    },
    /// The cable ends on the body's surface. It enters the body iff its direction points below *every* facet that is
    /// active at that end.
    Leave {
        /// Outward unit normals of the active facets.
        normals: Vec<Vector>,
    },
}

impl CableDemand {
    /// Whether the demand limits the gap between cable and body.
    pub fn is_about_gap(&self) -> bool {
        matches!(self, CableDemand::Apart { .. })
    }

    /// The required distance of the cable's axis, m, if there is one.
    pub fn distance(&self) -> Option<f64> {
        match self {
            CableDemand::Apart { gap } if *gap > 0.0 => Some(*gap),
            _ => None,
        }
    }

    /// The required distance between surfaces, m. If the cable only has to stay outside the body, this applies to its
    /// axis.
    pub fn required(&self, radius: f64) -> f64 {
        match self {
            CableDemand::Apart { gap } => gap - radius,
            CableDemand::Outside { .. } | CableDemand::Leave { .. } => -radius,
        }
    }

    /// Whether the cable ends on the body. The distance is then zero and does not measure the slack.
    pub fn ends_on_body(&self) -> bool {
        matches!(self, CableDemand::Leave { .. })
    }

    /// The required distance, and the depth that still counts as touching, m.
    #[inline]
    pub fn gap_and_touch(&self) -> [f64; 2] {
        match self {
            CableDemand::Apart { gap } => [*gap, TOUCH_DEPTH],
            CableDemand::Outside { touch } => [0.0, *touch],
            CableDemand::Leave { .. } => [0.0, TOUCH_DEPTH],
        }
    }

    /// Whether a moving cable breaks the demand, from what it sweeps or, for a cable that ends on the body, from its
    /// direction at the start and the end of the motion and how much lower it can go along a normal.
    #[inline]
    pub fn broken_by<S: ConvexShape>(
        &self,
        sweep: impl FnOnce() -> S,
        along: [Vector; 2],
        lower: impl Fn(&Vector) -> f64,
        body: &Polytope,
    ) -> bool {
        if let CableDemand::Leave { normals } = self {
            return goes_below_all(normals, along[0], along[1], lower);
        }
        let [gap, touch] = self.gap_and_touch();
        let cable = sweep();
        !cable.aabb().apart_by(body.aabb(), gap) && too_close(&cable, body, gap, touch)
    }

    /// How far a cable is from breaking the demand, m, from the cable as a body or, for a cable that ends on the body, from
    /// its direction and how much lower it can go along a normal.
    pub fn slack<S: ConvexShape>(
        &self,
        cable: impl FnOnce() -> S,
        along: &Vector,
        lower: impl Fn(&Vector) -> f64,
        body: &Polytope,
    ) -> f64 {
        if let CableDemand::Leave { normals } = self {
            return normals.iter().map(|n| n.dot(along) - lower(n)).fold(f64::NEG_INFINITY, f64::max);
        }
        let [gap, touch] = self.gap_and_touch();
        shape_distance(&cable(), body).signed() - gap + (touch - TOUCH_DEPTH)
    }

    /// Whether a bound proves that a moving cable keeps the demand, from what its chord sweeps and the largest deviation from
    /// it or, for a cable that ends on the body, from its direction at both ends and the
    /// deviation of its other end along a normal.
    pub fn kept<S: ConvexShape>(
        &self,
        chord: impl FnOnce() -> (S, f64),
        along: [Vector; 2],
        sag: impl Fn(&Vector) -> f64,
        body: &Polytope,
    ) -> bool {
        if let CableDemand::Leave { normals } = self {
            return !goes_below_all(normals, along[0], along[1], sag);
        }
        let [gap, touch] = self.gap_and_touch();
        let (chord, sag) = chord();
        let wanted = if gap > 0.0 { gap - TOUCH_DEPTH } else { -touch } + sag;
        chord.aabb().distance(body.aabb()) > wanted.max(0.0) || apart_by(&chord, body, wanted)
    }

    /// The points where a cable from `apex` cannot end: the given shadow of the body or, if the cable starts on the body, the
    /// region below its surface, raised by how much lower the cable can go along a normal.
    pub fn behind(
        &self,
        shadow: impl FnOnce() -> Option<Shadow>,
        apex: &Point,
        lower: impl Fn(&Vector) -> f64,
    ) -> Option<ForbiddenPolyhedron> {
        if let CableDemand::Leave { normals } = self {
            let below = |n: &Vector| HalfSpace::through(apex, *n).widened(lower(n));
            return Some(ForbiddenPolyhedron::exact(normals.iter().map(below).collect()));
        }
        let found = shadow()?;
        Some(ForbiddenPolyhedron { half_spaces: found.half_spaces, tilt: found.tilt })
    }
}

/// Whether two shapes are closer than `gap` or, if that is 0, overlap by more than `touch`, m.
#[inline]
pub fn too_close(a: &impl ConvexShape, b: &impl ConvexShape, gap: f64, touch: f64) -> bool {
    if !a.is_exact() {
        let limit = if gap > 0.0 { gap - TOUCH_DEPTH } else { -touch };
        return proximity(a, b, limit, limit.max(0.0)).lower < limit;
    }
    if gap > 0.0 { nearer_than(a, b, gap) } else { overlap(a, b, touch) }
}

/// Whether GJK shows that two shapes are at least `gap` metres apart or, if that is negative, overlap by no more.
#[inline]
pub fn apart_by(a: &impl SupportMap, b: &impl SupportMap, gap: f64) -> bool {
    proximity(a, b, gap, gap).lower >= gap
}

/// Whether a direction that changes linearly from `start` to `end`, except for a deviation, may at some instant be below all
/// planes through the origin with these normals. `sag` is the largest deviation along a normal.
fn goes_below_all(normals: &[Vector], start: Vector, end: Vector, sag: impl Fn(&Vector) -> f64) -> bool {
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for normal in normals {
        let touch = TOUCH_DEPTH - sag(normal);
        let (a, b) = (normal.dot(&start) + touch, normal.dot(&end) + touch);
        match (a < 0.0, b < 0.0) {
            (true, true) => {}
            (false, false) => return false,
            (false, true) => low = low.max(a / (a - b)),
            (true, false) => high = high.min(a / (a - b)),
        }
    }
    low < high
}

/// The shadow of all points closer than `gap` to a body, seen from a point: planes that face the point, and planes
/// through it. `directions` are the body's [`directions`](super::fattened::directions).
pub fn rounded_shadow(body: &Polytope, apex: &Point, gap: f64, directions: &[Vector]) -> Option<Vec<HalfSpace>> {
    let around = |n: Vector| HalfSpace::around(body.vertices(), n).widened(gap);
    let exact = shadow(body, apex).filter(|_| body.has_volume())?;
    let facing = directions.iter().copied().map(around).filter(|plane| plane.height(apex) > 0.0);
    let axis = (nalgebra::Point::from(
        body.vertices().iter().map(|v| v.coords).sum::<Vector>() / body.vertices().len() as f64,
    ) - apex)
        .try_normalize(PARALLEL)?;
    let sides: Vec<Vector> =
        exact.half_spaces.iter().filter(|h| h.height(apex).abs() <= ON_SURFACE).map(|h| h.normal).collect();
    let across = sides.first()?.cross(&axis).try_normalize(PARALLEL)?;
    let up = axis.cross(&across);
    let angles = sides.iter().map(|n| f64::atan2(n.dot(&up), n.dot(&across)));
    let mut by_angle: Vec<(f64, Vector)> = angles.zip(sides.iter().copied()).collect();
    by_angle.sort_by(|a, b| a.0.total_cmp(&b.0));
    let sides: Vec<Vector> = by_angle.into_iter().map(|(_, n)| n).collect();
    let corners = (0..sides.len()).flat_map(|k| between(&sides[k], &sides[(k + 1) % sides.len()])).collect::<Vec<_>>();
    let cone: Option<Vec<HalfSpace>> =
        sides.iter().chain(&corners).map(|n| tangent(body, apex, n, &axis, gap)).collect();
    Some(facing.chain(cone?).collect())
}

/// The plane through a point, with the normal `n` turned away from the axis just far enough to keep `gap` from a body.
fn tangent(body: &Polytope, apex: &Point, n: &Vector, axis: &Vector, gap: f64) -> Option<HalfSpace> {
    let forward = (axis - n * n.dot(axis)).try_normalize(PARALLEL)?;
    // With the normal n cos φ - forward sin φ, a corner has the height A cos φ - C sin φ, which must be at most -gap.
    // For a corner at distance R within this plane, φ must be at least asin(gap / R) + atan2(A, C). Between -π/2 and
    // π/2, comparing sines is the same as comparing angles.
    let (mut sine, mut cosine) = (0.0, 1.0);
    for corner in body.vertices() {
        let (a, c) = (n.dot(&(corner - apex)), forward.dot(&(corner - apex)));
        let reach = (a * a + c * c).sqrt();
        if !(reach > gap) {
            return None;
        }
        let (s, t) = (gap / reach, ((reach - gap) * (reach + gap)).sqrt() / reach);
        let (sin, cos) = ((s * c + t * a) / reach, (t * c - s * a) / reach);
        if !(cos > 0.0) {
            // Beyond +90° there is no such plane; beyond -90° this corner sets no bound.
            if s.asin() + f64::atan2(a, c) > 0.0 {
                return None;
            }
        } else if sin > sine {
            (sine, cosine) = (sin, cos);
        }
    }
    Some(HalfSpace::through(apex, (n * cosine - forward * sine).normalize()))
}
