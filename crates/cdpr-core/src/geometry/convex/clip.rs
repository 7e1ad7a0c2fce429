//! Intersection of a box with half-spaces, as a closed mesh.
//!
//! Rounding affects the positions of corners, but never the topology: a cut removes a connected set of corners and
//! leaves a connected set. The faces of a convex body cover a sphere, so no face is cut twice, the cut runs around
//! once, and closing it with one new face gives a sphere again. Planes through corners, touching planes, duplicates
//! and slivers need no special treatment; edges of zero length are contracted at the end.
//!
//! Source: topology before numbers, after K. Sugihara, "A robust and consistent algorithm for intersecting convex
//! polyhedra", Computer Graphics Forum 13(3), 1994.

use crate::geometry::{Aabb, HalfSpace, Point, TriangleMesh, Vector};
use crate::tolerances::{PARALLEL, SAME_POINT, TOUCH_DEPTH};

/// The part of a box that lies in all half-spaces; `None` if nothing thicker than [`TOUCH_DEPTH`] is left.
///
/// The mesh is one closed surface, convex up to rounding, its triangles counter-clockwise seen from outside.
///
/// # Example
/// ```
/// use cdpr_core::{Point, Vector, geometry::{Aabb, HalfSpace, convex_mesh}};
/// let cube = Aabb { min: Point::origin(), max: Point::new(2.0, 2.0, 2.0) };
/// let below = HalfSpace::through(&Point::new(0.0, 0.0, 0.5), Vector::z());
/// let mesh = convex_mesh(&[below], &cube).unwrap();
/// assert!(mesh.is_watertight() && mesh.triangles.len() == 12);
/// assert_eq!(mesh.volume(), 2.0);
/// ```
pub fn convex_mesh(half_spaces: &[HalfSpace], within: &Aabb) -> Option<TriangleMesh> {
    let mut body = Polyhedron::cuboid(within)?;
    for half_space in half_spaces {
        body.cut(half_space)?;
    }
    let mesh = TriangleMesh::of_faces(body.vertices, &body.faces).without_short_edges(SAME_POINT);
    // Twice the volume over the area is the thickness of a plate.
    (mesh.volume() > 0.5 * TOUCH_DEPTH * mesh.area()).then_some(mesh)
}

/// The volume of the part of a box that lies in all half-spaces, m³; each cut may move corners by [`TOUCH_DEPTH`].
pub fn convex_volume(half_spaces: &[HalfSpace], within: &Aabb) -> f64 {
    let body = || {
        let mut body = Polyhedron::cuboid(within)?;
        half_spaces.iter().try_for_each(|half_space| body.cut(half_space))?;
        Some(body)
    };
    body().map_or(0.0, |body| body.volume(&within.min))
}

/// The part in a box of a wedge without volume, { apex + s a + t b, s and t nonnegative }, as a two-sided surface;
/// `None` if a and b are parallel or the wedge misses the box.
pub fn wedge_mesh(apex: &Point, [a, b]: [Vector; 2], within: &Aabb) -> Option<TriangleMesh> {
    let (a, b) = (a.try_normalize(0.0)?, b.try_normalize(0.0)?);
    let across = |along: &Vector, v: &Vector| (v - along * along.dot(v)).try_normalize(PARALLEL);
    let (right, up) = (a, across(&a, &b)?);
    let sides = [HalfSpace::through(apex, -up), HalfSpace::through(apex, -across(&b, &a)?)];
    let (centre, half) = (nalgebra::center(&within.min, &within.max), 0.5 * (within.max - within.min).norm());
    let normal = right.cross(&up);
    let middle = centre - normal * normal.dot(&(centre - apex));
    let square = [(-half, -half), (half, -half), (half, half), (-half, half)];
    let square = square.map(|(x, y)| middle + right * x + up * y).to_vec();
    let cut = |polygon: Vec<Point>, side: &HalfSpace| cut_polygon(&polygon, side);
    let polygon = box_sides(within).iter().chain(&sides).fold(square, cut);
    two_sided(polygon)
}

/// A convex body that is being cut; removed corners stay in the list.
#[derive(Clone)]
pub(in crate::geometry) struct Polyhedron {
    pub vertices: Vec<Point>,
    /// Corners in counter-clockwise order seen from outside.
    pub faces: Vec<Vec<usize>>,
}

impl Polyhedron {
    pub fn cuboid(Aabb { min, max }: &Aabb) -> Option<Self> {
        if !(0..3).all(|axis| max[axis] - min[axis] > TOUCH_DEPTH) {
            return None;
        }
        let corner =
            |k: usize| Point::from(std::array::from_fn(|axis| if k >> axis & 1 == 1 { max } else { min }[axis]));
        let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        Some(Polyhedron { vertices: (0..8).map(corner).collect(), faces: faces.map(Vec::from).to_vec() })
    }

    /// The volume, as a sum of tetrahedra with a corner at this point.
    fn volume(&self, apex: &Point) -> f64 {
        let at = |k: usize| self.vertices[k] - apex;
        let fan = |face: &Vec<usize>| {
            let first = face.first().map_or(Vector::zeros(), |k| at(*k));
            face.windows(2).map(|edge| first.dot(&at(edge[0]).cross(&at(edge[1])))).sum::<f64>()
        };
        self.faces.iter().map(fan).sum::<f64>() / 6.0
    }

    /// The corners that are left.
    pub fn corners(&self) -> impl Iterator<Item = Point> + '_ {
        let mut left: Vec<usize> = self.faces.iter().flatten().copied().collect();
        left.sort_unstable();
        left.dedup();
        left.into_iter().map(|k| self.vertices[k])
    }

    /// The mean of the corners that are left, an interior point.
    pub fn middle(&self) -> Point {
        let (mut sum, mut count) = (Vector::zeros(), 0.0);
        self.corners().for_each(|v| {
            sum += v.coords;
            count += 1.0;
        });
        Point::from(sum / count)
    }

    /// Cuts off everything outside a half-space; `None` if nothing is left. Corners up to [`TOUCH_DEPTH`] outside may
    /// stay.
    pub fn cut(&mut self, half_space: &HalfSpace) -> Option<()> {
        let heights: Vec<f64> = self.vertices.iter().map(|v| half_space.height(v)).collect();
        let corners = || self.faces.iter().flatten().copied();
        let highest = corners().max_by(|i, j| heights[*i].total_cmp(&heights[*j]))?;
        let lowest = corners().min_by(|i, j| heights[*i].total_cmp(&heights[*j]))?;
        if !(heights[highest] > TOUCH_DEPTH) {
            return Some(());
        }
        if !(heights[lowest] < -TOUCH_DEPTH) {
            return None;
        }
        let off = self.connected(highest, |v| heights[v] > TOUCH_DEPTH);
        let kept = self.connected(lowest, |v| !off[v]);
        self.remove(&kept, &heights);
        Some(())
    }

    /// The corners connected to `from` by edges through corners that satisfy `belongs`.
    fn connected(&self, from: usize, belongs: impl Fn(usize) -> bool) -> Vec<bool> {
        let mut found = vec![false; self.vertices.len()];
        found[from] = true;
        loop {
            let mut more = false;
            for [i, j] in self.faces.iter().flat_map(|face| edges(face)) {
                if found[i] && !found[j] && belongs(j) {
                    (found[j], more) = (true, true);
                }
            }
            if !more {
                return found;
            }
        }
    }

    /// Removes the corners that are not kept and closes the hole with a new face.
    fn remove(&mut self, kept: &[bool], heights: &[f64]) {
        // For each edge that leaves the rest, its new corner; and the edges of the new face.
        let mut on_edge: Vec<((usize, usize), usize)> = Vec::new();
        let mut rim: Vec<(usize, usize)> = Vec::new();
        let mut faces = Vec::with_capacity(self.faces.len() + 1);
        for face in &self.faces {
            let mut rest = Vec::with_capacity(face.len() + 1);
            let (mut leaves, mut returns) = (None, None);
            for [i, j] in edges(face) {
                if kept[i] {
                    rest.push(i);
                }
                if kept[i] != kept[j] {
                    let (inner, outer) = if kept[i] { (i, j) } else { (j, i) };
                    let known = on_edge.iter().find(|(edge, _)| *edge == (inner, outer));
                    let new = known.map_or(self.vertices.len(), |(_, corner)| *corner);
                    if new == self.vertices.len() {
                        let [a, b] = [inner, outer].map(|v| (self.vertices[v], heights[v]));
                        self.vertices.push(crossing(a, b));
                        on_edge.push(((inner, outer), new));
                    }
                    rest.push(new);
                    *(if kept[i] { &mut leaves } else { &mut returns }) = Some(new);
                }
            }
            if let (Some(leaves), Some(returns)) = (leaves, returns) {
                rim.push((returns, leaves)); // the new face has the opposite direction along this edge
            }
            if !rest.is_empty() {
                faces.push(rest);
            }
        }
        let first = rim.iter().map(|(corner, _)| *corner).min();
        let next = |corner: &usize| rim.iter().rev().find(|(from, _)| from == corner).map(|(_, to)| *to);
        faces.push(std::iter::successors(first, |corner| next(corner).filter(|c| Some(*c) != first)).collect());
        self.faces = faces;
    }
}

/// Directed edges around a face.
fn edges(face: &[usize]) -> impl Iterator<Item = [usize; 2]> + '_ {
    (0..face.len()).map(|k| [face[k], face[(k + 1) % face.len()]])
}

/// The part of a convex polygon whose points have no positive height, which is a linear function (Sutherland and Hodgman,
/// "Reentrant polygon clipping", 1974).
pub(in crate::geometry) fn clipped(polygon: &[Point], height: impl Fn(&Point) -> f64) -> Vec<Point> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (k, p) in polygon.iter().enumerate() {
        let q = &polygon[(k + 1) % polygon.len()];
        let (hp, hq) = (height(p), height(q));
        if hp <= 0.0 {
            kept.push(*p);
        }
        if (hp < 0.0 && hq > 0.0) || (hp > 0.0 && hq < 0.0) {
            kept.push(p + (q - p) * (hp / (hp - hq)));
        }
    }
    kept
}

/// The point where the segment from an inside point to an outside point crosses the plane, given their heights; an end
/// if rounding put both on one side.
fn crossing((inner, below): (Point, f64), (outer, above): (Point, f64)) -> Point {
    let share = if above > below { (-below / (above - below)).clamp(0.0, 1.0) } else { 0.0 };
    inner + (outer - inner) * share
}

pub(in crate::geometry) fn box_sides(Aabb { min, max }: &Aabb) -> [HalfSpace; 6] {
    let [x, y, z] = [Vector::x(), Vector::y(), Vector::z()];
    [(max, x), (max, y), (max, z), (min, -x), (min, -y), (min, -z)].map(|(corner, n)| HalfSpace::through(corner, n))
}

fn cut_polygon(corners: &[Point], half_space: &HalfSpace) -> Vec<Point> {
    let height = |k: usize| half_space.height(&corners[k % corners.len()]);
    let mut rest = Vec::with_capacity(corners.len() + 1);
    for k in 0..corners.len() {
        let (here, next) = ((corners[k], height(k)), (corners[(k + 1) % corners.len()], height(k + 1)));
        let (inside, stays) = (here.1 <= TOUCH_DEPTH, next.1 <= TOUCH_DEPTH);
        if inside {
            rest.push(here.0);
        }
        if inside != stays {
            rest.push(if inside { crossing(here, next) } else { crossing(next, here) });
        }
    }
    rest
}

/// Both sides of a convex polygon; `None` if it is nowhere wider than [`TOUCH_DEPTH`].
fn two_sided(mut corners: Vec<Point>) -> Option<TriangleMesh> {
    corners.dedup_by(|a, b| (*a - *b).norm() <= SAME_POINT);
    while corners.len() > 1 && (corners[corners.len() - 1] - corners[0]).norm() <= SAME_POINT {
        corners.pop();
    }
    let n = corners.len();
    if n < 3 {
        return None;
    }
    // Fans from neighbouring corners: the two sides share only the rim.
    let front = (0..n).collect();
    let back = (0..n).rev().map(|k| (k + 2) % n).collect();
    let mesh = TriangleMesh::of_faces(corners, &[front, back]);
    let rim: f64 = (0..n).map(|k| (mesh.vertices[(k + 1) % n] - mesh.vertices[k]).norm()).sum();
    // The area of one side over half the rim is the width of a strip.
    (mesh.area() > TOUCH_DEPTH * rim).then_some(mesh)
}
