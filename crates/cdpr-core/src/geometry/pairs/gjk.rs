//! Algorithm 2 of the paper: GJK between convex sets of any two dimensions, with parry's simplex. This file and
//! `hull` are where parry's (glam) vectors meet ours (nalgebra).
//!
//! The loop keeps two bounds on the distance that are valid regardless of rounding: `lower` from the best separating
//! direction so far, `upper` from a pair of points of the two sets. Callers decide by the bounds, never by whether
//! the iteration converged, so an iteration cap or a stalled simplex can cost time but not safety.
//!
//! Sources: the paper, section 2.3; Gilbert, Johnson, Keerthi 1988; van den Bergen, Collision Detection in
//! Interactive 3D Environments, 2003, section 4.3 (termination).

use parry3d_f64::math::Vector as Glam;
use parry3d_f64::query::gjk::{CsoPoint, VoronoiSimplex};

use super::features;
use super::separating_axes::separation;
use crate::geometry::{ConvexShape, Point, Polytope, SupportMap, Triangle, Vector};
use crate::limits::GJK_ITERATIONS;
use crate::tolerances::{GJK_DISTANCE, ON_SURFACE, TOUCH_DEPTH};

/// Two-sided bounds on the distance of two sets, m, with their certificates.
#[derive(Debug, Clone, Copy)]
pub struct Proximity {
    /// Lower bound of the distance (negative if no separating direction was found).
    pub lower: f64,
    /// Upper bound of the distance: the distance between `on_a` and `on_b`.
    pub upper: f64,
    /// Unit direction from `a` to `b` along which the gap is `lower`.
    pub axis: Vector,
    /// A point of `a`, at most `upper` from `on_b`.
    pub on_a: Point,
    /// A point of `b`, at most `upper` from `on_a`.
    pub on_b: Point,
}

/// Bounds on the distance of two sets, refined until `lower > apart`, or `upper < close`, or the bounds meet.
pub fn proximity(a: &impl SupportMap, b: &impl SupportMap, apart: f64, close: f64) -> Proximity {
    let mut toward = b.center() - a.center();
    if !(toward.norm_squared() > 0.0) {
        toward = Vector::x();
    }
    let first = minkowski_support(a, b, &toward);
    let mut best = Proximity {
        lower: f64::NEG_INFINITY,
        upper: from_glam_vector(first.point).norm(),
        axis: toward.normalize(),
        on_a: from_glam(first.orig1),
        on_b: from_glam(first.orig2),
    };
    let mut simplex = VoronoiSimplex::new(); // W_0
    simplex.reset(first);
    let mut nearest = simplex.project_origin_and_reduce(); // w_i: the point of the simplex with minimal norm
    for _ in 0..GJK_ITERATIONS {
        let to_origin = -from_glam_vector(nearest);
        let norm = to_origin.norm();
        if !(norm > GJK_DISTANCE) {
            break; // w_i == O: the sets meet
        }
        let axis = to_origin / norm;
        let vertex = minkowski_support(a, b, &axis); // v_i = s_A(-w_i) - s_B(w_i)
        let lower = -from_glam_vector(vertex.point).dot(&axis);
        if lower > best.lower {
            (best.lower, best.axis) = (lower, axis);
        }
        if best.lower > apart || best.upper < close || best.upper - best.lower <= GJK_DISTANCE {
            break; // w_i == v_i: nothing closer exists in this direction
        }
        if !simplex.add_point(vertex) {
            break; // the simplex cannot distinguish the new vertex from an old one
        }
        nearest = simplex.project_origin_and_reduce();
        best.tighten_upper(&simplex);
        if simplex.dimension() == 3 {
            break; // the origin is inside the simplex
        }
    }
    best
}

impl Proximity {
    /// Uses the witness points of `simplex` if they are closer to each other.
    fn tighten_upper(&mut self, simplex: &VoronoiSimplex) {
        let corners = &std::array::from_fn::<_, 4, _>(|i| *simplex.point(i.min(simplex.dimension())));
        let weights: [f64; 4] = if simplex.dimension() == 3 {
            barycentric_of_origin(corners)
        } else {
            std::array::from_fn(|i| if i <= simplex.dimension() { simplex.proj_coord(i) } else { 0.0 })
        };
        if !weights.iter().all(|w| *w >= 0.0) {
            return; // not a point of the sets
        }
        let total: f64 = weights.iter().sum();
        let (mut on_a, mut on_b) = (Vector::zeros(), Vector::zeros());
        for (corner, weight) in corners.iter().zip(weights) {
            on_a += from_glam_vector(corner.orig1) * (weight / total);
            on_b += from_glam_vector(corner.orig2) * (weight / total);
        }
        let upper = (on_b - on_a).norm();
        if upper < self.upper {
            (self.upper, self.on_a, self.on_b) = (upper, Point::from(on_a), Point::from(on_b));
        }
    }
}

/// Weights of the four corners whose mean is the origin; not all positive if the origin is outside.
fn barycentric_of_origin(corners: &[CsoPoint; 4]) -> [f64; 4] {
    let [a, b, c, d] = corners.map(|corner| from_glam_vector(corner.point));
    let volume = |a: Vector, b: Vector, c: Vector| a.dot(&b.cross(&c));
    let parts = [volume(b, c, d), -volume(a, c, d), volume(a, b, d), -volume(a, b, c)];
    let total: f64 = parts.iter().sum();
    parts.map(|part| part / total)
}

/// Support point of the Minkowski difference A ⊖ B along `direction`.
#[inline]
fn minkowski_support(a: &impl SupportMap, b: &impl SupportMap, direction: &Vector) -> CsoPoint {
    CsoPoint::new(to_glam(&a.support(direction)), to_glam(&b.support(&-direction)))
}

/// parry's simplex drops vertices that are closer than absolute thresholds made for metre-sized bodies (1e-8 m² for an
/// edge's cross product). In finer units the same bodies are large; scaling by a power of two keeps every number exact.
const UNITS_PER_METRE: f64 = 1_048_576.0;

#[inline]
fn to_glam(p: &Point) -> Glam {
    Glam::new(p.x, p.y, p.z) * UNITS_PER_METRE
}

#[inline]
fn from_glam(v: Glam) -> Point {
    Point::from(from_glam_vector(v))
}

#[inline]
fn from_glam_vector(v: Glam) -> Vector {
    Vector::new(v.x, v.y, v.z) / UNITS_PER_METRE
}

/// Distance of two shapes with nearest points, or their overlap depth.
#[derive(Debug, Clone, Copy)]
pub struct Distance {
    /// Distance of the shapes, m; zero if they meet.
    pub distance: f64,
    /// Nearest point of the first shape; if they meet, an approximate common point from GJK.
    pub on_a: Point,
    /// Nearest point of the second shape.
    pub on_b: Point,
    /// How far one shape must be moved to separate them, m; zero if they are apart or only touch.
    pub depth: f64,
    /// Unit direction from `a` to `b` along which they are nearest, or along which the shortest translation separates
    /// them.
    pub axis: Vector,
}

impl Distance {
    /// Distance if the shapes are apart, minus the depth if they overlap, m.
    pub fn signed(&self) -> f64 {
        if self.depth > 0.0 { -self.depth } else { self.distance }
    }
}

/// Distance or depth of any two shapes.
pub fn shape_distance(a: &impl ConvexShape, b: &impl ConvexShape) -> Distance {
    let Proximity { lower, upper, on_a, on_b, axis } = proximity(a, b, f64::INFINITY, -1.0);
    if lower > TOUCH_DEPTH && upper - lower <= TOUCH_DEPTH {
        return Distance { distance: upper, on_a, on_b, depth: 0.0, axis };
    }
    let (gap, axis) = separation(a, b);
    if gap <= 0.0 && lower <= 0.0 {
        return Distance { distance: 0.0, on_a, on_b, depth: -gap, axis };
    }
    let (distance, on_a, on_b) = features::closest(&a.boundary(), &b.boundary());
    let axis = (on_b - on_a).try_normalize(GJK_DISTANCE).unwrap_or(axis);
    Distance { distance, on_a, on_b, depth: 0.0, axis }
}

/// Whether two shapes overlap by more than `touch`, m, the depth up to which they only touch.
///
/// GJK's certified separating direction decides most cases; separating axes decide the rest.
pub fn overlap(a: &impl ConvexShape, b: &impl ConvexShape, touch: f64) -> bool {
    proximity(a, b, -touch, -1.0).lower <= -touch && super::separating_axes::overlap_deeper_than(a, b, touch)
}

/// Whether two shapes are closer to each other than `gap`, m (> 0), by more than [`TOUCH_DEPTH`].
pub fn nearer_than(a: &impl ConvexShape, b: &impl ConvexShape, gap: f64) -> bool {
    let limit = gap - TOUCH_DEPTH;
    let found = proximity(a, b, limit, limit);
    if found.lower >= limit || found.upper < limit {
        return found.lower < limit;
    }
    shape_distance(a, b).signed() < limit
}

/// GJK between two convex polytopes of any dimensions (point, segment, polygon, polyhedron): whether they intersect,
/// their distance and nearest points.
///
/// # Source
/// The paper, Algorithm 2 and section 2.3.
///
/// # Example
/// ```
/// use cdpr_core::{Point, geometry::{Polytope, distance}};
/// let segment = Polytope::from_vertices(&[Point::new(0.0, 0.0, 2.0), Point::new(1.0, 0.0, 2.0)])?;
/// let cube = Polytope::cuboid([2.0; 3])?;
/// let found = distance(&segment, &cube);
/// assert!((found.distance - 1.0).abs() < 1e-12);
/// assert!((found.on_b.z - 1.0).abs() < 1e-12);
/// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
/// ```
pub fn distance(a: &Polytope, b: &Polytope) -> Distance {
    shape_distance(a, b)
}

impl Polytope {
    /// Outward normals of the facets that `point` lies on; empty if it does not lie on the surface (within
    /// [`ON_SURFACE`]) of a body with volume.
    pub fn active_normals(&self, point: &Point) -> Vec<Vector> {
        // Low over all planes does not imply close: beyond a sharp edge the planes continue together.
        let here = Triangle::new(*point, *point, *point);
        if !(self.depth_of(point).abs() <= ON_SURFACE && shape_distance(&here, self).distance <= ON_SURFACE) {
            return Vec::new();
        }
        self.facets().iter().filter(|f| f.height(point).abs() <= ON_SURFACE).map(|f| f.normal).collect()
    }
}
