//! A convex body around points that has few faces and extends little beyond their hull.
//!
//! A small set of points with few corners gets its hull. Other sets are enclosed by planes that touch the points, added
//! one by one: the corner of the body that is farthest from the hull is cut off, along the face of the hull that it is
//! highest over. Every plane has all points behind it, so the body encloses them wherever the planes are. Its distance
//! from the hull is largest at a corner, since the distance from a convex set is a convex function.

use nalgebra::{Matrix3, Rotation3};

use super::inner_hull::InnerHull;
use super::reach::Bounded;
use crate::error::Error;
use crate::geometry::convex::clip::{Polyhedron, box_sides};
use crate::geometry::convex::hull::flat_ring;
use crate::geometry::surface::solid::nearest_on_triangle;
use crate::geometry::{Aabb, HalfSpace, Point, Polytope, Vector};
use crate::limits::{MOST_PART_CORNERS, MOST_WRAP_PLANES};
use crate::tolerances::{GAP_TOLERANCE, ON_SURFACE, SHEET, TOUCH_DEPTH};
use crate::watch::Watch;

/// Number of corners up to which the inner hull is grown to find planes.
const INNER_CORNERS: usize = 600;

/// Allowance for rounding beyond the planes of a body when its reach is proved, m.
const ROOM: f64 = 0.2 * GAP_TOLERANCE;

/// Minimum distances of corners from the hull of the others, tried one after another if the hull of all of them cannot
/// be built, m: less than a body may miss of its points.
const CORNERS_APART: [f64; 3] = [1e-10, 1e-9, 1e-8];

/// A convex body around points.
#[derive(Clone)]
pub(super) struct Wrap {
    /// The body: the intersection of these half-spaces and the box.
    pub planes: Vec<HalfSpace>,
    pub aabb: Aabb,
    /// The points, without many of those that are not corners of their hull.
    pub points: Vec<Point>,
    /// Some interior point.
    pub middle: Point,
    /// Approximate volume of the points' hull, m³.
    pub volume: f64,
    /// Whether the body is the points' hull itself.
    pub exact: bool,
    /// Corners of the body.
    corners: Vec<Point>,
}

/// A body with volume around points that do not lie in a plane; it extends about `room` metres beyond their hull.
/// `None` if the points lie in a plane.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub(super) fn wrap(points: &[Point], room: f64, watch: &Watch) -> Result<Option<Wrap>, Error> {
    let Some(mut inner) = InnerHull::new(points) else { return Ok(None) };
    let left = inner.grow(0.5 * ON_SURFACE, MOST_PART_CORNERS, watch)?;
    if left <= 0.5 * ON_SURFACE
        && let Ok(body) = Polytope::hull_of(&inner.corners())
    {
        let candidates = inner.candidates();
        if is_sound(&body, &candidates) {
            return Ok(Some(Wrap::exact(&body, inner.volume())));
        }
    }
    inner.grow(0.2 * room, INNER_CORNERS, watch)?;
    let points = inner.candidates();
    let aabb = Aabb::around(&points);
    let triangles: Vec<([Point; 3], Vector)> = inner.triangles().filter(|(_, n)| *n != Vector::zeros()).collect();
    let (planes, corners) = tightened(&points, &aabb, &triangles, room, watch)?;
    let middle = mean(&inner.corners());
    Ok(Some(Wrap { planes, aabb, middle, volume: inner.volume(), points, exact: false, corners }))
}

/// The points of a thin sheet, thickened by [`SHEET`] to all sides, so that they have volume.
pub(super) fn thickened(points: &[Point]) -> Vec<Point> {
    let inner = InnerHull::new(points).map(|inner| inner.candidates());
    let ring = || flat_ring(points).unwrap_or_else(|| points.to_vec());
    let few = inner.unwrap_or_else(ring);
    let axes = frame(&few);
    let corner = |k: usize| (0..3).map(|a| axes[a] * if k >> a & 1 == 1 { SHEET } else { -SHEET }).sum::<Vector>();
    let corners: [Vector; 8] = std::array::from_fn(corner);
    few.iter().flat_map(|p| corners.map(|c| p + c)).collect()
}

/// Principal axes of points; the last one is the direction in which they are thinnest.
fn frame(points: &[Point]) -> [Vector; 3] {
    let a = points[0];
    let longest = |remainder: &dyn Fn(Vector) -> Vector| {
        let offsets = points.iter().map(|p| remainder(p - a));
        offsets.fold(Vector::zeros(), |best, v| if v.norm_squared() > best.norm_squared() { v } else { best })
    };
    let any = |v: &Vector| Vector::ith(v.iamin(), 1.0);
    let u = longest(&|v| v).try_normalize(TOUCH_DEPTH).unwrap_or(Vector::x());
    let v = longest(&|v| v - u * u.dot(&v)).try_normalize(TOUCH_DEPTH);
    let v = v.unwrap_or_else(|| u.cross(&any(&u)).normalize());
    // The longest distance in a rectangle is its diagonal, so align the axes with the longest edge instead.
    let normal = u.cross(&v).normalize();
    let side = points.windows(2).map(|w| w[1] - w[0]).map(|e| e - normal * normal.dot(&e));
    let edge = side.fold(Vector::zeros(), |best, e| if e.norm_squared() > best.norm_squared() { e } else { best });
    let u = edge.try_normalize(TOUCH_DEPTH).unwrap_or(u);
    [u, normal.cross(&u), normal]
}

/// Whether a body covers the points and can be rebuilt from its corners.
pub(super) fn is_sound(body: &Polytope, points: &[Point]) -> bool {
    let covers = || points.iter().all(|p| body.depth_of(p) >= -0.5 * GAP_TOLERANCE);
    body.has_volume() && covers() && Polytope::from_vertices(body.vertices()).is_ok_and(|again| again.has_volume())
}

/// Adds planes around points until no corner of the enclosed body is farther than `room` from the triangles of the
/// hull; also returns those corners.
fn tightened(
    points: &[Point],
    aabb: &Aabb,
    triangles: &[([Point; 3], Vector)],
    room: f64,
    watch: &Watch,
) -> Result<(Vec<HalfSpace>, Vec<Point>), Error> {
    let mut planes: Vec<HalfSpace> = Vec::new();
    let Some(mut body) = Polyhedron::cuboid(aabb) else { return Ok((planes, box_corners(aabb))) };
    let mut distances: Vec<f64> = Vec::new();
    let mut used = vec![false; triangles.len()];
    while planes.len() < MOST_WRAP_PLANES {
        watch.check()?;
        for v in &body.vertices[distances.len()..] {
            distances.push(distance(v, triangles));
        }
        let farthest =
            body.faces.iter().flatten().copied().max_by(|i, j| distances[*i].total_cmp(&distances[*j]).then(j.cmp(i)));
        let Some(corner) = farthest.filter(|k| distances[*k] > room) else { break };
        let v = body.vertices[corner];
        let heights = || triangles.iter().map(|([a, ..], n)| n.dot(&(v - a)));
        let highest = heights().fold(0.0, f64::max);
        let area = |k: usize| {
            let [a, b, c] = triangles[k].0;
            (b - a).cross(&(c - a)).norm_squared()
        };
        let high = heights().enumerate().filter(|(k, h)| *h >= 0.98 * highest && !used[*k]).map(|(k, _)| k);
        let Some(face) = high.max_by(|i, j| area(*i).total_cmp(&area(*j)).then(j.cmp(i))) else {
            distances[corner] = 0.0; // every plane near it has been added
            continue;
        };
        used[face] = true;
        let plane = HalfSpace::around(points, triangles[face].1);
        if plane.height(&v) > TOUCH_DEPTH {
            let before = body.vertices.len();
            if body.cut(&plane).is_none() {
                break;
            }
            debug_assert!(body.vertices.len() >= before);
            planes.push(plane);
        }
    }
    let corners = body.corners().collect();
    Ok((planes, corners))
}

fn distance(p: &Point, triangles: &[([Point; 3], Vector)]) -> f64 {
    let squared = |t: &[Point; 3]| (nearest_on_triangle(p, t) - p).norm_squared();
    let outside = triangles.iter().filter(|([a, ..], n)| n.dot(&(p - a)) > 0.0);
    let nearest = outside.map(|(t, _)| squared(t)).fold(f64::INFINITY, f64::min);
    if nearest.is_finite() { nearest.sqrt() } else { 0.0 }
}

/// A body with these corners in the frame in which it is thinnest along the last axis.
pub(super) fn along_its_axes(body: Bounded, corners: &[Point]) -> Bounded {
    let frame = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&frame(corners)));
    let turned = |plane: HalfSpace| HalfSpace { normal: frame.inverse() * plane.normal, ..plane };
    let planes = body.planes.into_iter().chain(box_sides(&body.aabb)).map(turned).collect();
    let corners: Vec<Point> = corners.iter().map(|v| frame.inverse() * v).collect();
    Bounded { planes, aabb: widened(&Aabb::around(&corners)), frame: Some(frame) }
}

fn widened(aabb: &Aabb) -> Aabb {
    let room = Vector::repeat(ROOM);
    Aabb { min: aabb.min - room, max: aabb.max + room }
}

fn mean(points: &[Point]) -> Point {
    Point::from(points.iter().map(|p| p.coords).sum::<Vector>() / points.len() as f64)
}

/// Points without some of those that are at most `apart` metres outside the hull of the others.
fn without_nearly_inner(points: &[Point], apart: f64) -> Option<Vec<Point>> {
    let mut inner = InnerHull::new(points)?;
    inner.grow(apart, points.len(), &Watch::NONE).ok()?;
    Some(inner.corners())
}

/// A box a little larger than the given one.
pub(super) fn box_around(aabb: &Aabb) -> Polytope {
    Polytope::hull_of(&box_corners(aabb)).expect("a box")
}

fn box_corners(Aabb { min, max }: &Aabb) -> Vec<Point> {
    let corner = |k: usize| Point::from(std::array::from_fn(|a| if k >> a & 1 == 1 { max } else { min }[a]));
    (0..8).map(corner).collect()
}

impl Wrap {
    fn exact(body: &Polytope, volume: f64) -> Self {
        Wrap {
            planes: body.half_spaces(),
            aabb: *body.aabb(),
            points: body.vertices().to_vec(),
            middle: body.centroid(),
            volume,
            exact: true,
            corners: body.vertices().to_vec(),
        }
    }

    /// The body with an allowance for rounding: what is proved of it holds for [`Wrap::polytope`], if that reports so.
    pub fn widened(&self) -> Bounded {
        let planes = self.planes.iter().map(|plane| plane.widened(ROOM)).collect();
        Bounded { planes, aabb: widened(&self.aabb), frame: None }
    }

    /// The body with its corners and faces, and whether it lies behind the widened planes. If rounding prevents the
    /// faces from closing, the result is a box.
    pub fn polytope(&self) -> (Polytope, bool) {
        let sound = |corners: &[Point]| Polytope::hull_of(corners).ok().filter(|body| is_sound(body, &self.points));
        // Corners that are hardly outside the hull of the others may be what keeps the faces from closing.
        let fewer = || CORNERS_APART.iter().find_map(|apart| sound(&without_nearly_inner(&self.corners, *apart)?));
        let body = sound(&self.corners).or_else(fewer).unwrap_or_else(|| box_around(&self.aabb));
        let Bounded { planes, aabb, .. } = self.widened();
        let in_box = |v: &Point| (0..3).all(|k| aabb.min[k] <= v[k] && v[k] <= aabb.max[k]);
        let behind = |v: &Point| in_box(v) && planes.iter().all(|plane| plane.height(v) <= 0.0);
        let within = body.vertices().iter().all(behind);
        (body, within)
    }

    /// The body's corners, the ends of [`Wrap::widened`] in any direction.
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }
}
