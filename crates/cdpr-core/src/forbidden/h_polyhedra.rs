//! A spatial index of the hulls of a scene: an octree over the box of positions, refined only where it is queried. A
//! path meets only a few of the thousands of hulls of a large scene, and only these cost time.

use std::sync::OnceLock;

use rand::{Rng, RngExt};

use super::h_polyhedron::{Edge, HPolyhedron, Overlap};
use super::polygon::Polygon;
use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::tolerances::{FLAT, ON_SURFACE, STANDOFF};
use crate::watch::Watch;

/// Polyhedra with a spatial index.
#[derive(Debug)]
pub struct HPolyhedra {
    list: Vec<HPolyhedron>,
    low: Point,
    high: Point,
    root: Node,
    root_members: Vec<u32>,
}

/// A box of the octree. Its hulls are those hulls of its parent that reach into it.
#[derive(Debug)]
struct Node {
    center: Point,
    half: Vector,
    members: OnceLock<Vec<u32>>,
    children: OnceLock<Box<[Node; 8]>>,
}

/// Scratch memory for one search of the octree, reused for the next.
#[derive(Debug, Default)]
pub struct Near {
    /// Indices of the hulls found, without duplicates.
    found: Vec<u32>,
    seen: Vec<u32>,
    search: u32,
}

/// Boxes with at most this many hulls are not divided.
const FEW: usize = 8;
/// Boxes smaller than this share of the query's extent are not divided.
const FINE: f64 = 1.0 / 8.0;
/// Maximum number of levels below the root: boxes of a 256th of the whole.
const LEVELS: usize = 8;
/// Boxes are enlarged by this distance, m: hulls that touch a box count as reaching into it.
const MARGIN: f64 = 2.0 * ON_SURFACE;
/// Distance from a drawn point on an edge within which free pieces are searched, as a share of the size of the box.
const NEARBY: f64 = 1.0 / 16.0;
/// Maximum number of edges drawn before one has a free and promising piece.
const DRAWS: usize = 8;

impl HPolyhedra {
    /// The hulls that reach into the box from `low` to `high`.
    pub fn new(hulls: impl Iterator<Item = HPolyhedron>, low: Point, high: Point) -> Self {
        let root = Node::new(nalgebra::center(&low, &high), (high - low) * 0.5 + Vector::repeat(MARGIN));
        let list: Vec<HPolyhedron> =
            hulls.filter(|hull| hull.overlap(&root.center, &root.half) != Overlap::None).collect();
        let root_members = (0..list.len() as u32).collect();
        HPolyhedra { list, low, high, root, root_members }
    }

    /// The hulls of the index.
    pub fn list(&self) -> &[HPolyhedron] {
        &self.list
    }

    /// Number of hulls in the index.
    pub fn count(&self) -> usize {
        self.list.len()
    }

    /// The hulls near the convex hull of one, two or three points inside the box of positions.
    pub fn near<'h, 'n>(
        &'h self,
        corners: &[Point],
        near: &'n mut Near,
    ) -> impl Iterator<Item = &'h HPolyhedron> + use<'h, 'n> {
        self.near_within(corners, 0.0, near).iter().map(|&index| &self.list[index as usize])
    }

    /// The indices of the hulls within some distance, m, of the convex hull of one, two or three points, as far as that
    /// is in the box of positions.
    pub fn near_within<'n>(&self, corners: &[Point], distance: f64, near: &'n mut Near) -> &'n [u32] {
        self.search(corners, distance, near, &mut || false);
        &near.found
    }

    /// The hulls of [`HPolyhedra::near`]; `None` if time runs out, since the first searches of a large scene take milliseconds.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn near_in_time<'h, 'n>(
        &'h self,
        corners: &[Point],
        near: &'n mut Near,
        watch: &Watch,
    ) -> Result<Option<impl Iterator<Item = &'h HPolyhedron> + use<'h, 'n>>, Error> {
        let mut expired = Ok(false);
        self.search(corners, 0.0, near, &mut || {
            expired = watch.expired();
            !matches!(expired, Ok(false))
        });
        Ok((!expired?).then(|| near.found.iter().map(|&index| &self.list[index as usize])))
    }

    fn search(&self, corners: &[Point], distance: f64, near: &mut Near, stop: &mut impl FnMut() -> bool) {
        near.begin(self.list.len());
        let query = Query::new(corners, distance);
        self.root.search(&self.root_members, &self.list, (&query, 0), near, stop);
    }

    /// A promising point on a free piece of an edge; `None` if none is found soon. First draws a promising point on an
    /// edge, then one of the free pieces near it, so that narrow pieces are hardly less likely than wide ones.
    pub fn sample(
        &self,
        promising: &dyn Fn(&Point) -> bool,
        rng: &mut dyn Rng,
        Room { near, polygon, edges }: &mut Room,
    ) -> Option<Point> {
        (0..DRAWS.min(DRAWS * self.list.len())).find_map(|_| {
            let hull = &self.list[rng.random_range(0..self.list.len())];
            self.edges(hull, rng.random_range(0..hull.planes().len()), polygon, edges);
            let edge = edges.get(rng.random_range(0..edges.len().max(1)))?;
            let share = rng.random::<f64>();
            if !promising(&edge.at(share)) {
                return None;
            }
            let part = edge.around(share, NEARBY * (self.high - self.low).norm());
            let least = if self.is_flat() { STANDOFF.min(part.length()) } else { STANDOFF };
            let pieces = part.outside(self.near(&part.ends(), near), least);
            let piece = pieces.get(rng.random_range(0..pieces.len().max(1)))?;
            Some(piece.sample(rng)).filter(promising)
        })
    }
}

impl HPolyhedra {
    /// Whether the box is practically flat along some axis.
    fn is_flat(&self) -> bool {
        (self.high - self.low).min() <= FLAT
    }

    /// The edges of a face of a hull in the box. A flat box cuts most of them to points, and rounding leaves nothing of
    /// the face itself; in this case the face is first cut by a thicker box.
    pub fn edges(&self, hull: &HPolyhedron, face: usize, polygon: &mut Polygon, edges: &mut Vec<Edge>) {
        if !self.is_flat() {
            return hull.face_edges(face, &self.low, &self.high, polygon, edges);
        }
        let thicker = (self.high - self.low).map(|size| if size <= FLAT { MARGIN } else { 0.0 });
        hull.face_edges(face, &(self.low - thicker), &(self.high + thicker), polygon, edges);
        *edges = edges.iter().filter_map(|edge| edge.within(&self.low, &self.high)).collect();
    }
}

/// Scratch memory for sampling, reused for the next sample.
#[derive(Debug, Default)]
pub struct Room {
    near: Near,
    polygon: Polygon,
    edges: Vec<Edge>,
}

impl Near {
    fn begin(&mut self, count: usize) {
        if self.seen.len() != count || self.search == u32::MAX {
            (self.seen, self.search) = (vec![0; count], 0);
        }
        self.search += 1;
        self.found.clear();
    }

    fn take(&mut self, members: &[u32]) {
        for &member in members {
            let seen = &mut self.seen[member as usize];
            if *seen != self.search {
                *seen = self.search;
                self.found.push(member);
            }
        }
    }
}

impl Node {
    fn new(center: Point, half: Vector) -> Self {
        Node { center, half, members: OnceLock::new(), children: OnceLock::new() }
    }

    /// Finds the hulls near a query. `stop` is asked before each division of a box, and ends the search by returning true.
    fn search(
        &self,
        members: &[u32],
        hulls: &[HPolyhedron],
        (query, level): (&Query, usize),
        near: &mut Near,
        stop: &mut impl FnMut() -> bool,
    ) {
        if members.is_empty() || query.apart(&self.center, &self.half) {
            return;
        }
        if members.len() <= FEW || level == LEVELS || self.half.max() <= FINE * query.extent {
            return near.take(members);
        }
        for child in self.children.get_or_init(|| self.divided()).iter() {
            if child.members.get().is_none() && stop() {
                return;
            }
            let own = child.members.get_or_init(|| child.reached_by(members, hulls));
            child.search(own, hulls, (query, level + 1), near, stop);
        }
    }

    fn divided(&self) -> Box<[Node; 8]> {
        let margin = Vector::repeat(MARGIN);
        let half = (self.half - margin) * 0.5;
        let side = |k: usize, axis: usize| if k >> axis & 1 == 1 { half[axis] } else { -half[axis] };
        let center = |k: usize| self.center + Vector::from_fn(|axis, _| side(k, axis));
        Box::new(std::array::from_fn(|k| Node::new(center(k), half + margin)))
    }

    /// The hulls, out of some, that reach into the box; if one of them contains all of the box, the others are omitted.
    fn reached_by(&self, members: &[u32], hulls: &[HPolyhedron]) -> Vec<u32> {
        let mut own = Vec::new();
        for &member in members {
            match hulls[member as usize].overlap(&self.center, &self.half) {
                Overlap::None => {}
                Overlap::Part => own.push(member),
                Overlap::All => return vec![member],
            }
        }
        own
    }
}

/// A query: a point, a segment or a triangle.
struct Query {
    low: Point,
    high: Point,
    extent: f64,
    /// Boxes closer than this count as met, m.
    distance: f64,
    /// The start of a segment, and the reciprocal of the vector to its end.
    segment: Option<(Point, Vector)>,
    /// A triangle's plane: unit normal and offset.
    plane: Option<(Vector, f64)>,
}

impl Query {
    fn new(corners: &[Point], distance: f64) -> Self {
        let low = corners.iter().fold(corners[0], |low, p| low.inf(p));
        let high = corners.iter().fold(corners[0], |high, p| high.sup(p));
        let segment = if let [a, b] = corners { Some((*a, (b - a).map(|way| 1.0 / way))) } else { None };
        let plane = match corners {
            [a, b, c] => (b - a).cross(&(c - a)).try_normalize(0.0).map(|normal| (normal, normal.dot(&a.coords))),
            _ => None,
        };
        let extent = (high - low).max() + 2.0 * distance;
        Query { low, high, extent, distance, segment, plane }
    }

    fn apart(&self, center: &Point, half: &Vector) -> bool {
        let half = &half.add_scalar(self.distance);
        let beside =
            |axis: usize| self.low[axis] > center[axis] + half[axis] || self.high[axis] < center[axis] - half[axis];
        if (0..3).any(beside) {
            return true;
        }
        // If the segment has no extent along an axis, values are infinite, or NaN on the box's surface; min and max
        // ignore NaN.
        let missed = |(from, inverse): &(Point, Vector)| {
            let (mut first, mut last) = (0.0f64, 1.0f64);
            for axis in 0..3 {
                let middle = center[axis] - from[axis];
                let (a, b) = ((middle - half[axis]) * inverse[axis], (middle + half[axis]) * inverse[axis]);
                first = first.max(a.min(b));
                last = last.min(a.max(b));
            }
            first > last
        };
        let above = |(normal, offset): &(Vector, f64)| {
            (normal.dot(&center.coords) - offset).abs() > normal.abs().dot(half) + ON_SURFACE
        };
        self.segment.as_ref().is_some_and(missed) || self.plane.as_ref().is_some_and(above)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polytope, Rotation};
    use rand::SeedableRng;

    fn hall(count: usize, seed: u64) -> (Vec<HPolyhedron>, HPolyhedra) {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let list: Vec<HPolyhedron> = (0..count)
            .map(|_| {
                let body = Polytope::cuboid([0; 3].map(|_| rng.random_range(0.01..0.6))).unwrap();
                let at = Vector::from_fn(|_, _| rng.random_range(-0.2..2.2));
                HPolyhedron::around(
                    body.transformed(&Rotation::new(Vector::new(rng.random(), rng.random(), 0.3)), &at).half_spaces(),
                )
            })
            .collect();
        let hulls = HPolyhedra::new(list.iter().cloned(), Point::origin(), Point::new(2.0, 2.0, 2.0));
        (list, hulls)
    }

    #[test]
    fn a_segment_meets_the_same_hulls_as_without_the_octree() {
        let (list, hulls) = hall(150, 1);
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(2);
        let mut near = Near::default();
        let (mut met, mut asked) = (0, 0);
        let every: Vec<&HPolyhedron> = list.iter().collect();
        for _ in 0..3000 {
            let from = Point::from(Vector::from_fn(|_, _| rng.random_range(0.0..2.0)));
            let size = [0.02, 0.3, 3.0][rng.random_range(0..3)];
            let to = (from + Vector::from_fn(|_, _| rng.random_range(-size..size)))
                .sup(&Point::origin())
                .inf(&Point::new(2.0, 2.0, 2.0));
            let along = to - from;
            let cut = |hull: &HPolyhedron| hull.inside(&from, &along).is_some_and(|[a, b]| a < 1.0 && b > 0.0);
            let found: Vec<&HPolyhedron> = hulls.near(&[from, to], &mut near).collect();
            let covered = |t: f64, hulls: &[&HPolyhedron]| {
                hulls.iter().any(|hull| hull.inside(&from, &along).is_some_and(|[a, b]| a < t && t < b))
            };
            for k in 0..=20 {
                let t = k as f64 / 20.0;
                let all = covered(t, &every);
                assert_eq!(all, covered(t, &found), "{from} {to} {t}");
            }
            met += list.iter().filter(|hull| cut(hull)).count();
            asked += found.len();
        }
        assert!(met > 1000 && asked < 3000 * 75, "{met} {asked}");
    }

    #[test]
    fn samples_lie_on_edges_outside_of_all_hulls() {
        let (list, hulls) = hall(60, 3);
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(4);
        let (mut room, promising) = (Room::default(), |p: &Point| p.x < 1.5);
        let samples: Vec<Point> = (0..500).filter_map(|_| hulls.sample(&promising, &mut rng, &mut room)).collect();
        assert!(samples.len() > 450 && samples.iter().all(promising));
        for sample in samples {
            assert!(list.iter().all(|hull| !hull.holds(&sample)), "{sample}");
            assert!(list.iter().any(|hull| !hull.edges_at(&sample).is_empty()), "{sample}");
        }
    }

    #[test]
    fn a_search_that_ran_out_of_time_leaves_the_index_whole() {
        let (_, hulls) = hall(300, 3);
        let (_, fresh) = hall(300, 3);
        let corners = [Point::new(0.1, 0.1, 0.1), Point::new(1.9, 1.0, 0.2), Point::new(1.0, 1.9, 1.8)];
        let mut near = Near::default();
        let late = Watch::NONE.with_budget(Some(std::time::Duration::ZERO));
        assert!(hulls.near_in_time(&corners, &mut near, &late).unwrap().is_none());
        let stop = || true;
        assert!(hulls.near_in_time(&corners, &mut near, &Watch::on(&stop)).is_err());
        let mut asked = 0;
        hulls.search(&corners, 0.0, &mut near, &mut || {
            asked += 1;
            asked > 20
        });
        let planes = |found: Vec<&HPolyhedron>| found.iter().map(|hull| hull.planes().to_vec()).collect::<Vec<_>>();
        let again = hulls.near_in_time(&corners, &mut near, &Watch::NONE).unwrap().unwrap().collect();
        let expected: Vec<&HPolyhedron> = fresh.near(&corners, &mut Near::default()).collect();
        assert!(expected.len() > 20 && planes(again) == planes(expected));
    }
}
