//! The edges of forbidden polyhedra on which a shortest path may bend: those outside all other polyhedra, near enough to
//! start and goal.

use std::collections::HashMap;

use crate::error::Error;
use crate::forbidden::{HPolyhedra, HPolyhedron, Near, Polygon, gaps};
use crate::geometry::{HalfSpace, Point, Vector};
use crate::tolerances::{SAME_POINT, SIMILAR_LINE, TINY_EDGE};
use crate::watch::Watch;

/// A free part of an edge, and the planes that meet in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeEdge {
    pub from: Point,
    pub to: Point,
    pub planes: [HalfSpace; 2],
}

/// A ball around the tiny free edges near a corner. Where planes of several polyhedra should meet in one point, they meet only
/// approximately, because of rounding and because they were moved outward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    pub center: Point,
    pub radius: f64,
}

/// Where shortest paths may bend.
#[derive(Debug, Default)]
pub struct FreeEdges {
    pub edges: Vec<FreeEdge>,
    pub corners: Vec<Corner>,
}

/// All positions x with |x - start| + |x - goal| ≤ `length`.
#[derive(Debug, Clone)]
pub struct Ellipsoid {
    pub start: Point,
    pub goal: Point,
    pub length: f64,
}

impl Ellipsoid {
    /// Length of the shortest path from start to goal through a point, if nothing were in the way, m.
    pub fn via(&self, point: &Point) -> f64 {
        (point - self.start).norm() + (point - self.goal).norm()
    }

    /// The part of a segment within the ellipsoid, as fractions.
    pub fn part(&self, from: &Point, to: &Point) -> Option<[f64; 2]> {
        let via = |t: f64| self.via(&(from + (to - from) * t)) - SAME_POINT;
        if via(0.0).max(via(1.0)) <= self.length {
            return Some([0.0, 1.0]);
        }
        // The sum of distances is convex: find its minimum, then the crossings on both sides.
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..SEARCH_STEPS {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if via(a) <= via(b) { high = b } else { low = a }
        }
        let middle = [0.0, 1.0, 0.5 * (low + high)].into_iter().min_by(|a, b| via(*a).total_cmp(&via(*b)))?;
        if via(middle) > self.length {
            return None;
        }
        let outermost = |end: f64| {
            let [mut inside, mut outside] = [middle, end];
            if via(end) <= self.length {
                return end;
            }
            for _ in 0..SEARCH_STEPS {
                let half = 0.5 * (inside + outside);
                if via(half) <= self.length { inside = half } else { outside = half }
            }
            outside
        };
        Some([outermost(0.0), outermost(1.0)])
    }

    /// Whether the whole ellipsoid lies outside one of these planes.
    pub fn misses(&self, planes: &[HalfSpace]) -> bool {
        planes.iter().any(|plane| self.heights(plane)[0] >= SAME_POINT)
    }

    /// Whether a plane may cut the ellipsoid.
    fn meets(&self, plane: &HalfSpace) -> bool {
        let [lowest, highest] = self.heights(plane);
        lowest <= SAME_POINT && highest >= -SAME_POINT
    }

    /// Smallest and largest height of the ellipsoid above a plane, m.
    fn heights(&self, plane: &HalfSpace) -> [f64; 2] {
        let way = self.goal - self.start;
        let minor = 0.25 * (self.length * self.length - way.norm_squared()).max(0.0);
        let reach = (minor + 0.25 * plane.normal.dot(&way).powi(2)).sqrt();
        let center = plane.height(&nalgebra::center(&self.start, &self.goal));
        [center - reach, center + reach]
    }
}

/// Steps of a search along an edge.
const SEARCH_STEPS: usize = 60;

/// The free edges within an ellipsoid, with tiny ones combined into corners.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn free_edges(hulls: &HPolyhedra, within: &Ellipsoid, watch: &Watch) -> Result<FreeEdges, Error> {
    let (mut polygon, mut edges, mut near) = (Polygon::default(), Vec::new(), Near::default());
    let mut lines = Lines::default();
    for hull in hulls.list() {
        watch.check()?;
        for face in (0..hull.planes().len()).filter(|face| within.meets(&hull.planes()[*face])) {
            hulls.edges(hull, face, &mut polygon, &mut edges);
            for edge in &edges {
                let [from, to] = edge.ends();
                let Some([low, high]) = within.part(&from, &to) else { continue };
                let ends = [low, high].map(|t| edge.at(t));
                let others = hulls.near(&ends, &mut near).filter(|other| !std::ptr::eq(*other, hull));
                let planes = hull.wedge(edge);
                for [from, to] in uncovered(ends, &planes, others) {
                    lines.add(FreeEdge { from, to, planes });
                }
            }
        }
    }
    Ok(gathered(lines.free))
}

/// Replaces edges shorter than [`TINY_EDGE`] by corners.
fn gathered(edges: Vec<FreeEdge>) -> FreeEdges {
    let (tiny, edges): (Vec<FreeEdge>, _) =
        edges.into_iter().partition(|edge| (edge.to - edge.from).norm() < TINY_EDGE);
    let mut corners: Vec<Corner> = Vec::new();
    let mut known = HashMap::new();
    for FreeEdge { from, to, .. } in tiny {
        let place = from.coords.map(|x| (x / TINY_EDGE).round() as i64);
        let at = *known.entry(<[i64; 3]>::from(place)).or_insert(corners.len());
        if at == corners.len() {
            corners.push(Corner { center: from, radius: 0.0 });
        }
        let Corner { center, radius } = &mut corners[at];
        *radius = radius.max((from - *center).norm()).max((to - *center).norm());
    }
    FreeEdges { edges, corners }
}

/// The parts of an edge outside of polyhedra, including single points between two of them. Where the edge lies in a face of
/// another polyhedron, everything free is on one side of that face, so no shortest path bends there.
fn uncovered<'h>(
    [from, to]: [Point; 2],
    planes: &[HalfSpace; 2],
    others: impl Iterator<Item = &'h HPolyhedron>,
) -> Vec<[Point; 2]> {
    let along = to - from;
    let seam = SAME_POINT / along.norm().max(SAME_POINT);
    let covered = others.filter_map(|other| other.inside_or_on_face(planes, &from, &along));
    let covered = covered.map(|[a, b]| [a + seam, b - seam]).filter(|[a, b]| a < b).collect();
    gaps(covered, 1.0 + seam).into_iter().map(|gap| gap.map(|t| from + along * t.min(1.0))).collect()
}

/// Free edges without duplicates: edges of the platform's and of the cables' regions often coincide.
#[derive(Default)]
struct Lines {
    free: Vec<FreeEdge>,
    by_line: HashMap<[i64; 6], Vec<usize>>,
}

impl Lines {
    fn add(&mut self, edge: FreeEdge) {
        let same = self.by_line.entry(key(&edge)).or_default();
        let mut parts = vec![[edge.from, edge.to]];
        for &other in same.iter() {
            parts = parts.into_iter().flat_map(|part| beyond(part, &self.free[other])).collect();
        }
        for [from, to] in parts {
            same.push(self.free.len());
            self.free.push(FreeEdge { from, to, ..edge });
        }
    }
}

/// The line of an edge, as a key.
fn key(edge: &FreeEdge) -> [i64; 6] {
    let along = (edge.to - edge.from).try_normalize(SAME_POINT).unwrap_or(Vector::zeros());
    let along = if along[along.iamax()] < 0.0 { -along } else { along };
    let moment = edge.from.coords.cross(&along);
    let moment = if along == Vector::zeros() { edge.from.coords } else { moment };
    std::array::from_fn(|k| ((if k < 3 { along[k] } else { moment[k - 3] }) / SIMILAR_LINE).round() as i64)
}

/// The parts of a segment beyond the ends of an edge on the same line; the segment itself if the line is another.
fn beyond([from, to]: [Point; 2], edge: &FreeEdge) -> Vec<[Point; 2]> {
    let Some(along) = (edge.to - edge.from).try_normalize(SAME_POINT) else {
        let same = (from - edge.from).norm().max((to - edge.from).norm()) < SAME_POINT;
        return if same { Vec::new() } else { vec![[from, to]] };
    };
    let place = |point: &Point| along.dot(&(point - edge.from));
    let off = |point: &Point| (point - (edge.from + along * place(point))).norm();
    if off(&from).max(off(&to)) > SAME_POINT {
        return vec![[from, to]];
    }
    let length = (edge.to - edge.from).norm();
    let (a, b) = (place(&from), place(&to));
    let (first, last, first_end, last_end) = if a <= b { (a, b, from, to) } else { (b, a, to, from) };
    let mut left = Vec::new();
    if first < -SAME_POINT {
        left.push([first_end, if last <= 0.0 { last_end } else { edge.from }]);
    }
    if last > length + SAME_POINT {
        left.push([if first >= length { first_end } else { edge.to }, last_end]);
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};

    #[test]
    fn corners_contain_the_tiny_edges_that_they_replace() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let mut some = |extent: f64| Vector::from_fn(|_, _| rng.random_range(-extent..extent));
        let places: Vec<Point> = (0..30).map(|_| Point::from(some(3.0))).collect();
        let planes = [Vector::x(), Vector::y()].map(|normal| HalfSpace::through(&Point::origin(), normal));
        let mut edge = |from: Point, extent: f64| FreeEdge { from, to: from + some(extent), planes };
        let long: Vec<FreeEdge> = places.iter().map(|place| edge(*place, 1.0)).collect();
        let tiny: Vec<FreeEdge> = places.iter().cycle().take(300).map(|place| edge(*place, 1e-7)).collect();
        let FreeEdges { edges, corners } = gathered(long.iter().chain(&tiny).copied().collect());
        assert_eq!(edges, long);
        assert!((30..60).contains(&corners.len()) && corners.iter().all(|corner| corner.radius < TINY_EDGE));
        for FreeEdge { from, to, .. } in tiny {
            let holds =
                |Corner { center, radius }: &Corner| (from - center).norm().max((to - center).norm()) <= *radius;
            assert!(corners.iter().any(holds));
        }
    }
}
