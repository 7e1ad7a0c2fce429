//! A cable and a convex body: what the conditions on cables and obstacles, and on cables and platform, have in common.

use super::fattened::between;
use super::region::Forbidden;
use crate::geometry::gjk::{nearer_than, overlap};
use crate::geometry::{Aabb, ConvexShape, HalfSpace, Point, Polytope, Triangle, Vector, shadow};
use crate::numerics::{ON_SURFACE, PARALLEL, TOUCH_DEPTH};

/// How a cable must keep away from a convex body.
#[derive(Debug, Clone, PartialEq)]
pub enum Demand {
    /// At least `gap` metres between the cable's line and the body; 0: the body's interior is not entered.
    Apart {
        /// Least distance, m.
        gap: f64,
    },
    /// The body, which closes a seam, is not entered by more than `touch` metres; the parts around it keep the distance.
    Outside {
        /// Depth that still counts as touching, m.
        touch: f64,
    },
    /// The cable ends on the body's surface. It enters the body iff its direction from there goes below *every* facet
    /// that is active at that end.
    Leave {
        /// Outward unit normals of the active facets.
        normals: Vec<Vector>,
    },
}

impl Demand {
    /// Whether it is about the gap between cable and body.
    pub fn is_about_gap(&self) -> bool {
        matches!(self, Demand::Apart { .. })
    }

    /// The distance of the cable's line that it demands, m, where it demands one.
    pub fn distance(&self) -> Option<f64> {
        match self {
            Demand::Apart { gap } if *gap > 0.0 => Some(*gap),
            _ => None,
        }
    }

    /// The least distance of surfaces that keeps it, m. Where the cable need only stay outside of the body, it is its middle
    /// line that does.
    pub fn required(&self, radius: f64) -> f64 {
        match self {
            Demand::Apart { gap } => gap - radius,
            Demand::Outside { .. } | Demand::Leave { .. } => -radius,
        }
    }

    /// Whether the end of the cable is on the body, so that no distance says how far the demand is from being broken.
    pub fn ends_on_body(&self) -> bool {
        matches!(self, Demand::Leave { .. })
    }

    /// The distance to keep, and the depth that still counts as touching, m.
    #[inline]
    pub fn gap_and_touch(&self) -> [f64; 2] {
        match self {
            Demand::Apart { gap } => [*gap, TOUCH_DEPTH],
            Demand::Outside { touch } => [0.0, *touch],
            Demand::Leave { .. } => [0.0, TOUCH_DEPTH],
        }
    }

    /// Whether a moving cable breaks it: by the triangle it sweeps, or by its direction (at the start and at the end of the
    /// motion) from where it ends on the body.
    #[inline]
    pub fn broken_by(&self, sweep: impl FnOnce() -> Triangle, along: [Vector; 2], body: &Polytope) -> bool {
        if let Demand::Leave { normals } = self {
            return goes_below_all(normals, along[0], along[1]);
        }
        let [gap, touch] = self.gap_and_touch();
        let cable = sweep();
        !Aabb::around(&cable.corners).apart_by(body.aabb(), gap) && too_close(&cable, body, gap, touch)
    }

    /// Where a cable from `apex` cannot end because of a body: in its shadow, or, if it starts on the body, below the
    /// surface.
    pub fn behind(&self, body: &Polytope, apex: &Point) -> Option<Forbidden> {
        if let Demand::Leave { normals } = self {
            return Some(Forbidden::exact(normals.iter().map(|n| HalfSpace::through(apex, *n)).collect()));
        }
        let found = shadow(body, apex)?;
        Some(Forbidden { half_spaces: found.half_spaces, tilt: found.tilt })
    }
}

/// Whether two shapes are nearer to each other than `gap`, or, if that is 0, overlap by more than `touch`, m.
#[inline]
pub fn too_close(a: &impl ConvexShape, b: &impl ConvexShape, gap: f64, touch: f64) -> bool {
    if gap > 0.0 { nearer_than(a, b, gap) } else { overlap(a, b, touch) }
}

/// Whether a direction that goes linearly from `start` to `end` lies below all planes through the origin at some instant.
fn goes_below_all(normals: &[Vector], start: Vector, end: Vector) -> bool {
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for normal in normals {
        let (a, b) = (normal.dot(&start) + TOUCH_DEPTH, normal.dot(&end) + TOUCH_DEPTH);
        match (a < 0.0, b < 0.0) {
            (true, true) => {}
            (false, false) => return false,
            (false, true) => low = low.max(a / (a - b)),
            (true, false) => high = high.min(a / (a - b)),
        }
    }
    low < high
}

/// What is hidden from a point by everything nearer than `gap` to a body: planes that face the point, and planes through it.
/// `directions` are those of the body.
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

/// The plane through a point, turned from the normal `n` away from the axis just so far that it keeps `gap` from a body.
fn tangent(body: &Polytope, apex: &Point, n: &Vector, axis: &Vector, gap: f64) -> Option<HalfSpace> {
    let forward = (axis - n * n.dot(axis)).try_normalize(PARALLEL)?;
    // For normals n cos φ - forward sin φ a corner is at A cos φ - C sin φ, which must be at most -gap: for a corner at the
    // distance R in this plane φ is at least asin(gap / R) + atan2(A, C). Of angles between -π/2 and π/2 the sines have the
    // same order.
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
            // Beyond a right angle to one side there is no such plane, to the other any will do.
            if s.asin() + f64::atan2(a, c) > 0.0 {
                return None;
            }
        } else if sin > sine {
            (sine, cosine) = (sin, cos);
        }
    }
    Some(HalfSpace::through(apex, (n * cosine - forward * sine).normalize()))
}
