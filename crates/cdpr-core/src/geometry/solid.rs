//! Distance from a surface of triangles, signed if the surface encloses a body: a hierarchy of boxes finds the nearest
//! triangle, and the normal of its nearest feature (face, edge or corner) determines on which side a point is.
//!
//! Source of the normals: J. A. Bærentzen, H. Aanæs, "Signed distance computation using the angle weighted
//! pseudonormal", IEEE TVCG 11(3), 2005.

use super::{Aabb, Point, Vector};
use crate::error::Error;
use crate::watch::Watch;

/// Number of triangles in a leaf.
const LEAF: usize = 4;

/// Maximum depth of the hierarchy: enough to halve four thousand million triangles.
const DEPTH: usize = 64;

/// Rounds between two checks of the watch.
pub(super) const LOOK: usize = 1 << 12;

/// A box around triangles: either two boxes, the next one and `second`, or the `count` triangles from `second` on.
struct Node {
    aabb: Aabb,
    second: u32,
    count: u32,
}

/// The nearest feature of a triangle.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Feature {
    Face,
    /// The edge from this corner to the next.
    Edge(usize),
    Corner(usize),
}

/// A surface prepared for distance queries.
pub struct SignedDistance {
    corners: Vec<[Point; 3]>,
    nodes: Vec<Node>,
    /// Normals of each triangle, of its edges and of its corners; empty if the surface encloses nothing.
    normals: Vec<[Vector; 7]>,
}

impl SignedDistance {
    /// A surface of triangles over points; `closed` if they enclose a body, counter-clockwise seen from outside. `None`
    /// without triangles.
    ///
    /// # Errors
    /// The errors of the watch.
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
        let normals = if closed { normals(points, triangles, &order, watch)? } else { Vec::new() };
        Ok(Some(SignedDistance { corners, nodes, normals }))
    }

    /// Distance of a point, m, negative inside the body, and the nearest point of the surface.
    pub fn at(&self, point: &Point) -> (f64, Point) {
        self.near(point, f64::INFINITY)
    }

    /// The same, faster if the distance is known to be at most `bound`, m.
    pub fn near(&self, point: &Point, bound: f64) -> (f64, Point) {
        self.counted(point, bound, &mut 0)
    }

    /// The same; adds the number of triangles examined to a count.
    pub(super) fn counted(&self, point: &Point, bound: f64, count: &mut usize) -> (f64, Point) {
        let mut best = (bound * bound * (1.0 + 1e-9), usize::MAX, Feature::Face, *point);
        if !self.search(point, 0.0, &mut best, count) {
            best.0 = f64::INFINITY; // the bound was too low by rounding
            self.search(point, 0.0, &mut best, count);
        }
        let (_, k, feature, nearest) = best;
        let away = point - nearest;
        let distance = away.norm();
        let Some(normals) = self.normals.get(k) else { return (distance, nearest) };
        let normal = match feature {
            Feature::Face => normals[0],
            Feature::Edge(e) => normals[1 + e],
            Feature::Corner(c) => normals[4 + c],
        };
        (if normal.dot(&away) < 0.0 { -distance } else { distance }, nearest)
    }

    /// Whether the surface comes closer to a point than this, m. Stops at any such place; adds the number of triangles
    /// examined to a count.
    pub(super) fn within(&self, point: &Point, limit: f64, count: &mut usize) -> bool {
        let squared = limit * limit;
        limit > 0.0 && self.search(point, squared, &mut (squared, usize::MAX, Feature::Face, *point), count)
    }

    /// Searches for something closer than the best so far, which holds the squared distance; ends once that is below
    /// `enough`.
    fn search(&self, point: &Point, enough: f64, best: &mut (f64, usize, Feature, Point), count: &mut usize) -> bool {
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
                    let (nearest, feature) = nearest_in(point, &self.corners[t as usize]);
                    let squared = (nearest - point).norm_squared();
                    if squared < best.0 {
                        *best = (squared, t as usize, feature, nearest);
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

/// Normals of triangles in this order: of the face, of the three edges (the sum of both faces'), of the three corners
/// (the sum of all faces', by their angles).
fn normals(
    points: &[Point],
    triangles: &[[usize; 3]],
    order: &[u32],
    watch: &Watch,
) -> Result<Vec<[Vector; 7]>, Error> {
    let mut at_corners = vec![Vector::zeros(); points.len()];
    let mut faces = Vec::with_capacity(triangles.len());
    let mut edges = Vec::with_capacity(3 * triangles.len());
    for (k, t) in triangles.iter().enumerate() {
        if k % LOOK == 0 {
            watch.check()?;
        }
        let [a, b, c] = t.map(|i| points[i]);
        let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or(Vector::zeros());
        faces.push(normal);
        for e in 0..3 {
            let [here, next, last] = [t[e], t[(e + 1) % 3], t[(e + 2) % 3]];
            at_corners[here] += normal * (points[next] - points[here]).angle(&(points[last] - points[here]));
            edges.push((here.min(next) as u32, here.max(next) as u32, (3 * k + e) as u32));
        }
    }
    sorted(&mut edges, watch)?;
    let mut at_edges = vec![Vector::zeros(); edges.len()];
    for (k, same) in edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).enumerate() {
        if k % LOOK == 0 {
            watch.check()?;
        }
        let sum: Vector = same.iter().map(|(_, _, use_)| faces[*use_ as usize / 3]).sum();
        same.iter().for_each(|(_, _, use_)| at_edges[*use_ as usize] = sum);
    }
    let all = |k: &u32| {
        let k = *k as usize;
        let [a, b, c] = triangles[k].map(|i| at_corners[i]);
        [faces[k], at_edges[3 * k], at_edges[3 * k + 1], at_edges[3 * k + 2], a, b, c]
    };
    Ok(order.iter().map(all).collect())
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
pub(super) fn nearest_on_triangle(p: &Point, triangle: &[Point; 3]) -> Point {
    nearest_in(p, triangle).0
}

fn nearest_in(p: &Point, &[a, b, c]: &[Point; 3]) -> (Point, Feature) {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (a, Feature::Corner(0));
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return (b, Feature::Corner(1));
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (a + ab * (d1 / (d1 - d3)), Feature::Edge(0));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return (c, Feature::Corner(2));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (a + ac * (d2 / (d2 - d6)), Feature::Edge(2));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return (b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), Feature::Edge(1));
    }
    let sum = va + vb + vc;
    if !(sum > 0.0) {
        return (a, Feature::Corner(0));
    }
    (a + ab * (vb / sum) + ac * (vc / sum), Feature::Face)
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
}
