//! Distance from a surface of triangles, and the winding number of a closed surface around a point, which tells inside
//! from outside. Both search a hierarchy of boxes.
//!
//! The winding number (A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using generalized
//! winding numbers", ACM TOG 32(4), 2013) of a closed surface is an integer: the number of times that a ray from the
//! point leaves the surface, less the number of times that it enters. Unlike the normal of the nearest triangle, it does
//! not depend on how the surface is divided into triangles; where a surface intersects itself or has triangles without
//! area, it still is the number of layers around the point.

use crate::error::Error;
use crate::geometry::{Aabb, Point, Vector};
use crate::tolerances::RAY_ROUNDING;
use crate::watch::Watch;

/// Number of triangles in a leaf.
const LEAF: usize = 4;

/// Maximum depth of the hierarchy: enough to halve four thousand million triangles.
const DEPTH: usize = 64;

/// Rounds between two checks of the watch.
pub(in crate::geometry) const LOOK: usize = 1 << 12;

/// Directions of rays, one tried after the other: none is likely to lie in a face, or to meet an edge, of a drawing.
const RAYS: [[f64; 3]; 8] = [
    [0.769_14, 0.533_31, 0.351_97],
    [-0.413_73, 0.811_09, 0.413_39],
    [0.287_31, -0.617_73, 0.732_07],
    [0.614_03, 0.317_17, -0.722_71],
    [-0.703_37, -0.389_19, 0.594_83],
    [0.137_93, -0.912_41, -0.385_37],
    [-0.531_17, 0.271_93, -0.802_43],
    [0.933_71, -0.107_27, -0.341_59],
];

/// A box around triangles: either two boxes, the next one and `second`, or the `count` triangles from `second` on.
struct Node {
    aabb: Aabb,
    second: u32,
    count: u32,
}

/// A surface prepared for distance queries.
pub struct SignedDistance {
    corners: Vec<[Point; 3]>,
    nodes: Vec<Node>,
    /// Whether the surface is closed.
    closed: bool,
}

impl SignedDistance {
    /// A surface of triangles over points. `closed` if triangles that share an edge run through it as often in one
    /// direction as in the other; then the inside is where the winding number is not zero. `None` without triangles.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn new(points: &[Point], triangles: &[[usize; 3]], closed: bool, watch: &Watch) -> Result<Option<Self>, Error> {
        if triangles.is_empty() {
            return Ok(None);
        }
        let mut order: Vec<u32> = (0..triangles.len() as u32).collect();
        let middles: Vec<Point> =
            triangles.iter().map(|t| Point::from(t.iter().map(|i| points[*i].coords).sum::<Vector>() / 3.0)).collect();
        watch.check()?;
        let mut nodes = Vec::with_capacity(2 * triangles.len() / LEAF + 1);
        let around = |list: &[u32]| {
            let first = points[triangles[list[0] as usize][0]];
            let corners = list.iter().flat_map(|k| triangles[*k as usize]).map(|i| points[i]);
            corners.fold(Aabb { min: first, max: first }, |b, p| Aabb { min: b.min.inf(&p), max: b.max.sup(&p) })
        };
        // Ranges of triangles that still need a box, each with the box whose second half it is.
        let mut open = vec![(0, triangles.len(), None::<usize>)];
        while let Some((from, to, parent)) = open.pop() {
            if nodes.len() % 64 == 0 || to - from > LOOK {
                watch.check()?;
            }
            let here = nodes.len();
            if let Some(parent) = parent {
                let node: &mut Node = &mut nodes[parent];
                node.second = here as u32;
            }
            let aabb = around(&order[from..to]);
            if to - from <= LEAF {
                nodes.push(Node { aabb, second: from as u32, count: (to - from) as u32 });
                continue;
            }
            nodes.push(Node { aabb, second: 0, count: 0 });
            let list = &mut order[from..to];
            let spread = Aabb {
                min: list.iter().fold(aabb.max, |m, k| m.inf(&middles[*k as usize])),
                max: list.iter().fold(aabb.min, |m, k| m.sup(&middles[*k as usize])),
            };
            let axis = (spread.max - spread.min).imax();
            let half = list.len() / 2;
            let key = |k: &u32| middles[*k as usize][axis];
            list.select_nth_unstable_by(half, |a, b| key(a).total_cmp(&key(b)).then(a.cmp(b)));
            open.push((from + half, to, Some(here)));
            open.push((from, from + half, None));
        }
        watch.check()?;
        let corners = order.iter().map(|k| triangles[*k as usize].map(|i| points[i])).collect();
        Ok(Some(SignedDistance { corners, nodes, closed }))
    }

    /// Distance of a point, m, negative inside the body, and the nearest point of the surface.
    pub fn at(&self, point: &Point) -> (f64, Point) {
        let (distance, nearest) = self.to_surface(point, f64::INFINITY, &mut 0);
        (if self.encloses(point) { -distance } else { distance }, nearest)
    }

    /// Distance of a point from the surface, m, and the nearest point of it; faster if the distance is known to be at most
    /// `bound`. Adds the number of triangles examined to a count.
    pub(in crate::geometry) fn to_surface(&self, point: &Point, bound: f64, count: &mut usize) -> (f64, Point) {
        let mut best = (bound * bound * (1.0 + 1e-9), *point);
        if !self.search(point, 0.0, &mut best, count) {
            best.0 = f64::INFINITY; // the bound was too low by rounding
            self.search(point, 0.0, &mut best, count);
        }
        ((point - best.1).norm(), best.1)
    }

    /// Whether a point is inside the body: the surface is closed, and its winding number around the point is not zero.
    pub fn encloses(&self, point: &Point) -> bool {
        self.closed && self.winding(point) != 0
    }

    /// The winding number of a closed surface around a point.
    fn winding(&self, point: &Point) -> i64 {
        let by_ray = RAYS.iter().find_map(|ray| self.crossings(point, &Vector::from(*ray)));
        by_ray.unwrap_or_else(|| {
            let angles: f64 = self.corners.iter().map(|t| solid_angle(point, t)).sum();
            (angles / (4.0 * std::f64::consts::PI)).round() as i64
        })
    }

    /// How often a ray leaves the surface, less how often it enters; `None` if it passes too close to an edge to tell.
    fn crossings(&self, from: &Point, ray: &Vector) -> Option<i64> {
        let inverse = ray.map(|x| 1.0 / x);
        let meets = |aabb: &Aabb| {
            let (low, high) = (aabb.min - from, aabb.max - from);
            let (a, b) = (low.component_mul(&inverse), high.component_mul(&inverse));
            let (enters, leaves) = (a.inf(&b).max(), a.sup(&b).min());
            let room = RAY_ROUNDING * (low.amax() + high.amax());
            leaves >= -room && enters <= leaves + room
        };
        let mut open = [0u32; DEPTH];
        let mut height = 1;
        let mut sum = 0;
        while height > 0 {
            height -= 1;
            let k = open[height];
            let node = &self.nodes[k as usize];
            if !meets(&node.aabb) {
                continue;
            }
            if node.count == 0 {
                (open[height], open[height + 1]) = (node.second, k + 1);
                height += 2;
                continue;
            }
            for t in node.second..node.second + node.count {
                sum += crossing(&self.corners[t as usize].map(|corner| corner - from), ray)?;
            }
        }
        Some(sum)
    }

    /// Whether the surface comes closer to a point than this, m. Stops at any such place; adds the number of triangles
    /// examined to a count.
    pub(in crate::geometry) fn within(&self, point: &Point, limit: f64, count: &mut usize) -> bool {
        let squared = limit * limit;
        limit > 0.0 && self.search(point, squared, &mut (squared, *point), count)
    }

    /// Searches for something closer than the best so far, which holds the squared distance; ends once that is below
    /// `enough`.
    fn search(&self, point: &Point, enough: f64, best: &mut (f64, Point), count: &mut usize) -> bool {
        let mut open = [(0u32, 0.0); DEPTH];
        let mut height = 1;
        open[0] = (0, squared_distance(&self.nodes[0].aabb, point));
        let mut found = false;
        while height > 0 {
            height -= 1;
            let (k, distance) = open[height];
            if distance >= best.0 {
                continue;
            }
            let node = &self.nodes[k as usize];
            if node.count > 0 {
                *count += node.count as usize;
                for t in node.second..node.second + node.count {
                    let nearest = nearest_on_triangle(point, &self.corners[t as usize]);
                    let squared = (nearest - point).norm_squared();
                    if squared < best.0 {
                        *best = (squared, nearest);
                        found = true;
                    }
                }
                if best.0 < enough {
                    return true;
                }
                continue;
            }
            let [a, b] = [k + 1, node.second].map(|c| (c, squared_distance(&self.nodes[c as usize].aabb, point)));
            let (near, far) = if a.1 <= b.1 { (a, b) } else { (b, a) };
            open[height] = far;
            open[height + 1] = near;
            height += 2;
        }
        found
    }
}

fn squared_distance(aabb: &Aabb, p: &Point) -> f64 {
    (aabb.min - p).sup(&(p - aabb.max)).sup(&Vector::zeros()).norm_squared()
}

/// Whether a ray from the origin leaves (1) or enters (-1) a triangle, or neither (0); `None` if it passes too close to its
/// rim to tell.
///
/// The sides of the triangle on which the ray's line passes are triple products that change only their sign when an edge
/// is run through in the other direction, so triangles that share an edge agree on it (S. Woop, C. Benthin, I. Wald,
/// "Watertight ray/triangle intersection", JCGT 2(1), 2013).
fn crossing([a, b, c]: &[Vector; 3], ray: &Vector) -> Option<i64> {
    let side = |p: &Vector, q: &Vector| {
        let side = ray.dot(&p.cross(q));
        let clear = side.abs() > RAY_ROUNDING * (p.norm_squared() + q.norm_squared());
        (side, if clear { side.signum() as i64 } else { 0 })
    };
    let sides = [side(a, b), side(b, c), side(c, a)];
    if sides.iter().any(|s| s.1 > 0) && sides.iter().any(|s| s.1 < 0) {
        return Some(0);
    }
    if sides.iter().any(|s| s.1 == 0) {
        // Where it is behind the origin, its edges do not matter.
        return if [a, b, c].iter().all(|corner| ray.dot(corner) < 0.0) { Some(0) } else { None };
    }
    let along: f64 = sides.iter().map(|s| s.0).sum(); // the ray's direction times the normal
    let ahead = a.dot(&b.cross(c)) / along > 0.0;
    Some(if ahead { sides[0].1 } else { 0 })
}

/// Solid angle of a triangle seen from a point, positive from inside (A. Van Oosterom, J. Strackee, "The solid angle of a
/// plane triangle", IEEE Trans. Biomed. Eng. 30(2), 1983).
fn solid_angle(from: &Point, triangle: &[Point; 3]) -> f64 {
    let [a, b, c] = triangle.map(|corner| corner - from);
    let (x, y, z) = (a.norm(), b.norm(), c.norm());
    let across = x * y * z + a.dot(&b) * z + b.dot(&c) * x + c.dot(&a) * y;
    2.0 * a.dot(&b.cross(&c)).atan2(across)
}

/// Sorts a long list, checking the watch now and then.
pub(super) fn sorted<T: Ord>(list: &mut [T], watch: &Watch) -> Result<(), Error> {
    let mut open: Vec<&mut [T]> = vec![list];
    while let Some(part) = open.pop() {
        watch.check()?;
        if part.len() <= 1 << 15 {
            part.sort_unstable();
        } else {
            let middle = part.len() / 2;
            part.select_nth_unstable(middle);
            let (low, high) = part.split_at_mut(middle);
            open.extend([low, high]);
        }
    }
    Ok(())
}

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, section 5.1.5).
pub(in crate::geometry) fn nearest_on_triangle(p: &Point, &[a, b, c]: &[Point; 3]) -> Point {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let sum = va + vb + vc;
    if !(sum > 0.0) {
        return a;
    }
    a + ab * (vb / sum) + ac * (vc / sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::convex_mesh;
    use rand::{RngExt, SeedableRng};

    #[test]
    fn within_agrees_with_the_distance() {
        let mesh = convex_mesh(&[], &Aabb { min: Point::origin(), max: Point::new(1.0, 2.0, 0.5) }).unwrap();
        let surface = SignedDistance::new(&mesh.vertices, &mesh.triangles, true, &Watch::NONE).unwrap().unwrap();
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(3);
        for _ in 0..10_000 {
            let point = Point::from(Vector::from_fn(|_, _| rng.random_range(-2.0..2.0)));
            let (distance, limit) = (surface.at(&point).0.abs(), rng.random_range(-0.5..2.0));
            assert_eq!(surface.within(&point, limit, &mut 0), distance < limit, "{point} {limit}");
        }
    }

    #[test]
    fn the_winding_number_counts_layers_as_solid_angles_do() {
        let cube = |from: f64, to: f64| {
            let corner = |x: f64| Point::new(x, x, x);
            convex_mesh(&[], &Aabb { min: corner(from), max: corner(to) }).unwrap()
        };
        let mut mesh = cube(0.0, 2.0);
        mesh.append(&cube(1.0, 3.0)); // overlaps the first
        let mut hollow = cube(0.25, 0.75);
        hollow.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        mesh.append(&hollow);
        let surface = SignedDistance::new(&mesh.vertices, &mesh.triangles, true, &Watch::NONE).unwrap().unwrap();
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(4);
        let lattice = |x: f64| (4.0 * x).round() / 4.0 + 1e-6;
        for k in 0..20_000 {
            let point = Point::from(Vector::from_fn(|_, _| rng.random_range(-0.5..3.5)));
            let point = if k % 2 == 0 { point } else { point.map(lattice) };
            let angles: f64 = surface.corners.iter().map(|t| solid_angle(&point, t)).sum();
            let layers = (angles / (4.0 * std::f64::consts::PI)).round() as i64;
            assert_eq!(surface.winding(&point), layers, "{point}");
        }
        let at = |x: f64| surface.at(&Point::new(x, x, x + 0.1)).0;
        assert!(at(1.5) < 0.0 && at(0.2) < 0.0 && at(0.5) > 0.0 && at(3.2) > 0.0);
    }

    #[test]
    fn rays_through_edges_and_corners_use_solid_angles() {
        // Seen from the middle, every ray of the list meets a corner of the fan of triangles that runs to its tip.
        let mesh =
            convex_mesh(&[], &Aabb { min: Point::new(-1.0, -1.0, -1.0), max: Point::new(1.0, 1.0, 1.0) }).unwrap();
        let (mut vertices, mut triangles) = (mesh.vertices, mesh.triangles);
        for ray in RAYS {
            let ray = Vector::from(ray);
            let tip = Point::from(ray / ray.amax());
            let on = |t: &[usize; 3], p: &Point| {
                let [a, b, c] = t.map(|i| vertices[i] - p);
                let n = (b - a).cross(&(c - a));
                n.dot(&a).abs() < 1e-9 && [a.cross(&b), b.cross(&c), c.cross(&a)].iter().all(|side| n.dot(side) >= 0.0)
            };
            let hit = triangles.iter().position(|t| on(t, &tip)).unwrap();
            let [a, b, c] = triangles.swap_remove(hit);
            vertices.push(tip);
            let tip = vertices.len() - 1;
            triangles.extend([[a, b, tip], [b, c, tip], [c, a, tip]]);
        }
        let surface = SignedDistance::new(&vertices, &triangles, true, &Watch::NONE).unwrap().unwrap();
        let middle = Point::origin();
        assert!(RAYS.iter().all(|ray| surface.crossings(&middle, &Vector::from(*ray)).is_none()));
        assert_eq!(surface.winding(&middle), 1);
    }
}
