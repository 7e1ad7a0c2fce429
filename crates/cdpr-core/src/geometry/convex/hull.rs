//! Faces of the convex hull of a point set in any dimension, with coplanar triangles merged.
//!
//! parry computes the triangles; this module turns them into facets with all their corners and verifies the result:
//! every point inside every facet, every edge between exactly two facets, and Euler's formula.

use parry3d_f64::math::Vector as Glam;
use parry3d_f64::transformation::try_convex_hull;

use crate::geometry::{Point, Vector};
use crate::tolerances::{COPLANAR_AT_MOST, COPLANAR_RELATIVE, FLAT, STANDS_OUT};

/// A flat face: all points x of the body satisfy `normal · x <= offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Facet {
    /// Unit outward normal.
    pub normal: Vector,
    /// Distance of the face's plane from the origin along the normal, m.
    pub offset: f64,
    /// Corners in counter-clockwise order seen from outside, as indices into the body's vertices.
    pub corners: Vec<usize>,
}

impl Facet {
    /// The facet with these corners in counter-clockwise order; the normal is Newell's.
    pub(super) fn through(vertices: &[Point], corners: Vec<usize>) -> Self {
        let anchor = vertices[corners[0]];
        let spoke = |i: usize| vertices[corners[i]] - anchor;
        let area: Vector = (1..corners.len() - 1).map(|i| spoke(i).cross(&spoke(i + 1))).sum();
        let normal = area.normalize();
        let offset = corners.iter().map(|&i| normal.dot(&vertices[i].coords)).fold(f64::NEG_INFINITY, f64::max);
        Facet { normal, offset, corners }
    }

    /// Height of a point above the face's plane, m; negative inside the body.
    #[inline]
    pub fn height(&self, point: &Point) -> f64 {
        self.normal.dot(&point.coords) - self.offset
    }

    /// Directed edges around the facet.
    pub fn edges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let n = self.corners.len();
        (0..n).map(move |k| [self.corners[k], self.corners[(k + 1) % n]])
    }
}

/// Corners of a hull, and its facets.
pub(super) struct Hull {
    pub corners: Vec<Point>,
    pub facets: Vec<Facet>,
}

/// Affine frame of a point set: its dimension and its axes.
pub(super) struct Extent {
    pub dimension: usize,
    origin: Point,
    axes: [Vector; 3],
    reach: [f64; 3],
}

impl Extent {
    /// Measures a non-empty point set: farthest point, farthest from the line, farthest from the plane.
    pub fn of(points: &[Point]) -> Self {
        let origin = points[0];
        let mut extent = Extent { dimension: 0, origin, axes: [Vector::zeros(); 3], reach: [0.0; 3] };
        for k in 0..3 {
            let offsets = points.iter().map(|p| extent.remainder(p));
            let farthest = offsets.max_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared())).expect("not empty");
            if farthest.norm() <= FLAT {
                break;
            }
            extent.axes[k] = farthest.normalize();
            extent.reach[k] = farthest.norm();
            extent.dimension = k + 1;
        }
        extent
    }

    /// Coordinates along the axes in units of the reach: an affine image in which the body is about as thick as long.
    fn evened(&self, point: &Point) -> Glam {
        let offset = point - self.origin;
        let [x, y, z] = std::array::from_fn(|k| self.axes[k].dot(&offset) / self.reach[k]);
        Glam::new(x, y, z)
    }

    /// The component of `point - origin` orthogonal to the axes found so far.
    fn remainder(&self, point: &Point) -> Vector {
        let mut offset = point - self.origin;
        for axis in &self.axes[..self.dimension] {
            offset -= axis * axis.dot(&offset);
        }
        offset
    }
}

/// Hull of points on a line: its two ends.
pub(super) fn segment_hull(points: &[Point], extent: &Extent) -> Hull {
    let along = |p: &Point| (p - extent.origin).dot(&extent.axes[0]);
    let first = points.iter().min_by(|a, b| along(a).total_cmp(&along(b))).expect("not empty");
    let last = points.iter().max_by(|a, b| along(a).total_cmp(&along(b))).expect("not empty");
    Hull { corners: vec![*first, *last], facets: Vec::new() }
}

/// Hull of points in a plane: a polygon with two faces; `None` if no corner list covers all points.
pub(super) fn polygon_hull(points: &[Point], extent: &Extent) -> Option<Hull> {
    let flat = flattened(points, extent);
    let corners: Vec<Point> = convex_ring(&flat)?.iter().map(|&i| points[i]).collect();
    let front: Vec<usize> = (0..corners.len()).collect();
    let back: Vec<usize> = front.iter().rev().copied().collect();
    let facets = vec![Facet::through(&corners, front), Facet::through(&corners, back)];
    Some(Hull { corners, facets })
}

/// Coordinates in the plane of the first two axes.
fn flattened(points: &[Point], extent: &Extent) -> Vec<[f64; 2]> {
    let [u, v, _] = extent.axes;
    points.iter().map(|p| [(p - extent.origin).dot(&u), (p - extent.origin).dot(&v)]).collect()
}

/// Counter-clockwise hull of points in the plane, as indices, without corners that are due to rounding.
///
/// The chain sorts along one direction, and points that differ along it only by rounding can make it lose a true
/// corner. So the result is verified (every point within rounding of the polygon); otherwise another direction is
/// tried.
fn convex_ring(points: &[[f64; 2]]) -> Option<Vec<usize>> {
    const DIRECTIONS: [f64; 5] = [0.3, 1.1, 2.0, 0.7, 2.7]; // rad, none of them likely in a drawing
    DIRECTIONS.into_iter().find_map(|angle| {
        let (sin, cos) = f64::sin_cos(angle);
        let turned: Vec<[f64; 2]> = points.iter().map(|[x, y]| [cos * x - sin * y, sin * x + cos * y]).collect();
        let ring = monotone_chain(&turned);
        [thinned(&turned, &ring), ring].into_iter().find(|ring| covers(&turned, ring))
    })
}

/// A ring without the corners that lie on the chord of their neighbours.
fn thinned(points: &[[f64; 2]], ring: &[usize]) -> Vec<usize> {
    let mut ring = ring.to_vec();
    let mut k = 0;
    while k < ring.len() && ring.len() > 3 {
        let n = ring.len();
        let [before, at, after] = [(k + n - 1) % n, k, (k + 1) % n].map(|i| points[ring[i]]);
        if height(before, after, at).abs() <= STANDS_OUT {
            ring.remove(k);
        } else {
            k += 1;
        }
    }
    ring
}

/// Whether every point lies within rounding of the polygon.
fn covers(points: &[[f64; 2]], ring: &[usize]) -> bool {
    let n = ring.len();
    let inside =
        |p: &[f64; 2]| (0..n).all(|k| height(points[ring[k]], points[ring[(k + 1) % n]], *p) >= -2.0 * STANDS_OUT);
    n >= 3 && points.iter().all(inside)
}

/// Height of `c` to the left of the line from `a` to `b`.
fn height(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let (ab, ac) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    (ab[0] * ac[1] - ab[1] * ac[0]) / ab[0].hypot(ab[1])
}

/// Andrew's monotone chain without any tolerance, which would remove true corners.
fn monotone_chain(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| points[i][0].total_cmp(&points[j][0]).then(points[i][1].total_cmp(&points[j][1])));
    let turns_left =
        |ring: &[usize], k: usize| height(points[ring[ring.len() - 2]], points[ring[ring.len() - 1]], points[k]) > 0.0;
    let half = |order: &mut dyn Iterator<Item = usize>| {
        let mut ring: Vec<usize> = Vec::new();
        for k in order {
            while ring.len() >= 2 && !turns_left(&ring, k) {
                ring.pop();
            }
            ring.push(k);
        }
        ring.pop();
        ring
    };
    let mut ring = half(&mut order.iter().copied());
    ring.extend(half(&mut order.iter().rev().copied()));
    ring
}

/// Hull of points with volume; `None` if it is not a closed convex surface.
pub(super) fn solid_hull(points: &[Point], extent: &Extent) -> Option<Hull> {
    // Affine maps do not change which points are on the hull, but parry treats a slab a thousand times longer than
    // thick as flat, so it gets an image of even extent.
    let even: Vec<Glam> = points.iter().map(|p| extent.evened(p)).collect();
    let (kept, triangles) = try_convex_hull(&even).ok()?;
    let original = |v: &Glam| even.iter().position(|e| e == v).map(|k| points[k]);
    let vertices: Vec<Point> = kept.iter().map(original).collect::<Option<_>>()?;
    let triangles: Vec<[usize; 3]> = triangles.iter().map(|t| t.map(|i| i as usize)).collect();
    // Coordinates rounded to a few decimals have faces that are flat up to that rounding, and merging gives a closed
    // surface only if the tolerance is well above or well below it: widen it step by step, and finally merge nothing.
    let tight = (COPLANAR_RELATIVE * extent.reach[0]).min(0.01 * COPLANAR_AT_MOST);
    [tight, 10.0 * tight, 100.0 * tight, COPLANAR_AT_MOST, 0.0].into_iter().find_map(|tolerance| {
        let hull = corners_and_facets(&vertices, &merged_planes(&vertices, &triangles, tolerance))?;
        let inside = |p: &Point| hull.facets.iter().all(|f| f.height(p) <= 2.0 * COPLANAR_AT_MOST);
        (is_closed(&hull) && points.iter().all(inside)).then_some(hull)
    })
}

/// Corners of the hull of points that lie in a plane, up to rounding; `None` if they lie on a line.
pub(in crate::geometry) fn flat_ring(points: &[Point]) -> Option<Vec<Point>> {
    let extent = Extent::of(points);
    let ring = |extent| monotone_chain(&flattened(points, extent)).into_iter().map(|i| points[i]).collect();
    (extent.dimension >= 2).then(|| ring(&extent))
}

/// A plane of a hull: its outward normal and the vertices on it.
type Plane = (Vector, Vec<usize>);

/// The planes of the hull. The largest triangle of a plane defines it, and the plane absorbs every triangle whose
/// corners it contains.
fn merged_planes(vertices: &[Point], triangles: &[[usize; 3]], tolerance: f64) -> Vec<Plane> {
    let outward = handedness(vertices, triangles);
    let area = |t: &[usize; 3]| outward * doubled_area(vertices, t);
    // Slivers have no direction of their own.
    let mut faces: Vec<(Vector, [usize; 3])> = triangles.iter().map(|t| (area(t), *t)).collect();
    faces.retain(|(area, t)| area.norm() > 10.0 * tolerance * longest_side(vertices, t));
    faces.sort_by(|a, b| b.0.norm_squared().total_cmp(&a.0.norm_squared()));
    let mut planes: Vec<Plane> = Vec::new();
    for (area, own) in faces {
        let normal = area.normalize();
        let held_by = |(n, held): &Plane| n.dot(&normal) > 0.0 && own.iter().all(|i| held.contains(i));
        let height = |i: usize| (vertices[i] - vertices[own[0]]).dot(&normal);
        // A triangle between two points of an edge and a third beside it may be tilted by rounding; it is no face of
        // the body.
        let supports = || tolerance == 0.0 || (0..vertices.len()).all(|i| height(i) <= 2.0 * tolerance);
        if !planes.iter().any(held_by) && supports() {
            let near = |i: &usize| own.contains(i) || height(*i).abs() <= tolerance;
            planes.push((normal, (0..vertices.len()).filter(near).collect()));
        }
    }
    planes
}

/// Twice the area of a triangle along its normal.
fn doubled_area(vertices: &[Point], [a, b, c]: &[usize; 3]) -> Vector {
    (vertices[*b] - vertices[*a]).cross(&(vertices[*c] - vertices[*a]))
}

fn longest_side(vertices: &[Point], [a, b, c]: &[usize; 3]) -> f64 {
    let side = |i: &usize, j: &usize| (vertices[*j] - vertices[*i]).norm();
    side(a, b).max(side(b, c)).max(side(c, a))
}

/// 1 if the triangles turn counter-clockwise seen from outside, else -1 (the axes of the even image may mirror).
fn handedness(vertices: &[Point], triangles: &[[usize; 3]]) -> f64 {
    let middle = vertices.iter().map(|v| v.coords).sum::<Vector>() / vertices.len() as f64;
    let volume: f64 = triangles.iter().map(|t| doubled_area(vertices, t).dot(&(vertices[t[0]].coords - middle))).sum();
    volume.signum()
}

/// Keeps the vertices where at least three planes meet, and orders each facet's corners around its normal.
fn corners_and_facets(vertices: &[Point], planes: &[(Vector, Vec<usize>)]) -> Option<Hull> {
    let planes_at = |i: usize| planes.iter().filter(|(_, on)| on.contains(&i)).count();
    let kept: Vec<usize> = (0..vertices.len()).filter(|&i| planes_at(i) >= 3).collect();
    let corners: Vec<Point> = kept.iter().map(|&i| vertices[i]).collect();
    let mut facets = Vec::with_capacity(planes.len());
    for (normal, on) in planes {
        let members: Vec<usize> = (0..kept.len()).filter(|&k| on.contains(&kept[k])).collect();
        if members.len() < 3 {
            return None;
        }
        facets.push(Facet::through(&corners, around(&corners, members, normal)));
    }
    Some(Hull { corners, facets })
}

/// Sorts corners of a convex facet counter-clockwise as seen from the tip of `normal`.
pub(super) fn around(corners: &[Point], mut members: Vec<usize>, normal: &Vector) -> Vec<usize> {
    let middle = members.iter().map(|&i| corners[i].coords).sum::<Vector>() / members.len() as f64;
    let u = (corners[members[0]].coords - middle).normalize();
    let v = normal.cross(&u);
    let angle = |i: usize| {
        let offset = corners[i].coords - middle;
        offset.dot(&v).atan2(offset.dot(&u))
    };
    members.sort_by(|&i, &j| angle(i).total_cmp(&angle(j)));
    members
}

pub(super) fn is_closed(hull: &Hull) -> bool {
    let mut edges: Vec<[usize; 2]> = hull.facets.iter().flat_map(Facet::edges).collect();
    let forward = edges.len();
    edges.sort_unstable();
    edges.dedup();
    let twins = edges.iter().all(|[i, j]| edges.binary_search(&[*j, *i]).is_ok());
    edges.len() == forward && twins && hull.corners.len() + hull.facets.len() == forward / 2 + 2
}
