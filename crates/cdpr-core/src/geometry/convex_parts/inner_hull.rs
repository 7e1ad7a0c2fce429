//! The convex hull of many points from inside, corner by corner: a polytope over some of them that grows until no point
//! is farther outside than a given height.
//!
//! Quickhull with one change: the next corner is always the point that is farthest outside. Growing can therefore stop
//! at any height, and a round body needs only as many corners as its roundness requires. No guarantee depends on the
//! result: planes that touch all points enclose them for any directions, see [`super::wrap`].
//!
//! Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The quickhull algorithm for convex hulls", ACM TOMS 22(4), 1996.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::tolerances::{COPLANAR_RELATIVE, FLAT};
use crate::watch::Watch;

/// A triangle of the polytope, with the points outside it that no other face has taken.
struct Face {
    corners: [usize; 3],
    /// The face across the edge from corner k to the next.
    beside: [usize; 3],
    normal: Vector,
    offset: f64,
    outside: Vec<usize>,
    highest: Option<(f64, usize)>,
    alive: bool,
}

impl Face {
    fn new(points: &[Point], corners: [usize; 3]) -> Self {
        let [a, b, c] = corners.map(|i| points[i]);
        let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or(Vector::zeros());
        let offset = normal.dot(&a.coords).max(normal.dot(&b.coords)).max(normal.dot(&c.coords));
        Face { corners, beside: [usize::MAX; 3], normal, offset, outside: Vec::new(), highest: None, alive: true }
    }

    #[inline]
    fn height(&self, p: &Point) -> f64 {
        self.normal.dot(&p.coords) - self.offset
    }
}

/// A face by the height of its highest point; ties by index, so that the order is deterministic.
struct Highest(f64, usize);

impl PartialEq for Highest {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Highest {}

impl PartialOrd for Highest {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Highest {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(other.1.cmp(&self.1))
    }
}

/// A polytope over some of the points.
pub(super) struct InnerHull<'a> {
    points: &'a [Point],
    faces: Vec<Face>,
    open: BinaryHeap<Highest>,
    corners: Vec<usize>,
    /// Points up to this height count as inside, m.
    rounding: f64,
}

impl<'a> InnerHull<'a> {
    /// The initial tetrahedron; `None` if the points lie in a plane (up to [`FLAT`]).
    pub fn new(points: &'a [Point]) -> Option<Self> {
        let farthest = |height: &dyn Fn(&Point) -> f64| {
            let heights = points.iter().map(height).enumerate();
            heights.fold((0, f64::NEG_INFINITY), |best, (k, h)| if h > best.1 { (k, h) } else { best })
        };
        let (first, _) = farthest(&|p| p.x);
        let a = *points.get(first)?;
        let (second, reach) = farthest(&|p| (p - a).norm_squared());
        let along = (points[second] - a).try_normalize(FLAT)?;
        let (third, _) = farthest(&|p| (p - a - along * along.dot(&(p - a))).norm_squared());
        let normal = along.cross(&(points[third] - a)).try_normalize(FLAT)?;
        let (fourth, height) = farthest(&|p| normal.dot(&(p - a)).abs());
        if !(height > FLAT) {
            return None;
        }
        let above = normal.dot(&(points[fourth] - a)) > 0.0;
        let [i, j, k] = if above { [first, third, second] } else { [first, second, third] };
        let rounding = COPLANAR_RELATIVE * reach.sqrt();
        let mut hull = InnerHull {
            points,
            faces: [[i, j, k], [i, fourth, j], [j, fourth, k], [k, fourth, i]].map(|c| Face::new(points, c)).into(),
            open: BinaryHeap::new(),
            corners: vec![i, j, k, fourth],
            rounding,
        };
        hull.faces[0].beside = [1, 2, 3];
        for (face, around) in [(1, [3, 2, 0]), (2, [1, 3, 0]), (3, [2, 1, 0])] {
            hull.faces[face].beside = around;
        }
        hull.share_out((0..points.len()).collect(), 0);
        Some(hull)
    }

    /// Adds corners until no point is farther outside than this height, m, or until the maximum number of corners.
    /// Returns the remaining height.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn grow(&mut self, height: f64, most_corners: usize, watch: &Watch) -> Result<f64, Error> {
        while let Some(Highest(highest, face)) = self.open.pop() {
            if !self.faces[face].alive {
                continue;
            }
            if highest <= height || self.corners.len() >= most_corners {
                self.open.push(Highest(highest, face));
                return Ok(highest);
            }
            watch.check()?;
            self.add(face);
        }
        Ok(0.0)
    }

    /// Adds the highest point of a face as a corner; drops the point if rounding leaves no clean horizon.
    fn add(&mut self, face: usize) {
        let (_, apex) = self.faces[face].highest.expect("a face in the queue has points");
        let (seen, horizon) = self.horizon(face, &self.points[apex]);
        if !is_ring(&horizon) {
            let open = &mut self.faces[face];
            open.outside.retain(|i| *i != apex);
            self.rate(face);
            return;
        }
        let first = self.faces.len();
        let count = horizon.len();
        for (k, &(from, to, beyond)) in horizon.iter().enumerate() {
            let mut new = Face::new(self.points, [from, to, apex]);
            new.beside = [beyond, first + (k + 1) % count, first + (k + count - 1) % count];
            self.faces.push(new);
            let edge = (0..3).find(|e| self.faces[beyond].corners[*e] == to).expect("the edge the other way round");
            self.faces[beyond].beside[edge] = first + k;
        }
        let mut outside = Vec::new();
        for gone in seen {
            self.faces[gone].alive = false;
            outside.append(&mut self.faces[gone].outside);
        }
        outside.retain(|i| *i != apex);
        self.corners.push(apex);
        self.share_out(outside, first);
    }

    /// The faces visible from a point, and the edges around them in order, each with the face beyond it.
    #[allow(clippy::type_complexity)]
    fn horizon(&self, face: usize, apex: &Point) -> (Vec<usize>, Vec<(usize, usize, usize)>) {
        let mut seen = vec![face];
        let mut edges = Vec::new();
        let mut k = 0;
        while k < seen.len() {
            let here = &self.faces[seen[k]];
            for edge in 0..3 {
                let beyond = here.beside[edge];
                if seen.contains(&beyond) {
                    continue;
                }
                if self.faces[beyond].height(apex) > self.rounding {
                    seen.push(beyond);
                } else {
                    edges.push((here.corners[edge], here.corners[(edge + 1) % 3], beyond));
                }
            }
            k += 1;
        }
        // A visible face found later removes its edges from the horizon.
        edges.retain(|(_, _, beyond)| !seen.contains(beyond));
        for k in 1..edges.len() {
            if let Some(next) = (k..edges.len()).find(|n| edges[*n].0 == edges[k - 1].1) {
                edges.swap(k, next);
            }
        }
        (seen, edges)
    }

    /// Distributes points over the faces from `first` on, each to the one it is highest over; points inside are
    /// dropped.
    fn share_out(&mut self, points: Vec<usize>, first: usize) {
        for i in points {
            let p = &self.points[i];
            let (mut best, mut height) = (usize::MAX, self.rounding);
            for (k, face) in self.faces.iter().enumerate().skip(first) {
                let h = face.height(p);
                if h > height {
                    (best, height) = (k, h);
                }
            }
            if let Some(face) = self.faces.get_mut(best) {
                face.outside.push(i);
                if face.highest.is_none_or(|(h, _)| height > h) {
                    face.highest = Some((height, i));
                }
            }
        }
        for k in first..self.faces.len() {
            if let Some((height, _)) = self.faces[k].highest {
                self.open.push(Highest(height, k));
            }
        }
    }

    fn rate(&mut self, face: usize) {
        let this = &self.faces[face];
        let heights = this.outside.iter().map(|i| (this.height(&self.points[*i]), *i));
        let highest = heights.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        self.faces[face].highest = highest;
        if let Some((height, _)) = highest {
            self.open.push(Highest(height, face));
        }
    }

    /// The corners so far.
    pub fn corners(&self) -> Vec<Point> {
        self.corners.iter().map(|i| self.points[*i]).collect()
    }

    /// The points that may be corners of the full hull: the corners so far, and the points still outside.
    pub fn candidates(&self) -> Vec<Point> {
        let outside = self.alive().flat_map(|f| &f.outside);
        self.corners.iter().chain(outside).map(|i| self.points[*i]).collect()
    }

    fn alive(&self) -> impl Iterator<Item = &Face> {
        self.faces.iter().filter(|f| f.alive)
    }

    /// Corners and unit normal of every face.
    pub fn triangles(&self) -> impl Iterator<Item = ([Point; 3], Vector)> + '_ {
        self.alive().map(|f| (f.corners.map(|i| self.points[i]), f.normal))
    }

    /// Volume so far, m³.
    pub fn volume(&self) -> f64 {
        let origin = self.points[self.corners[0]];
        let cone = |[a, b, c]: [Point; 3]| (a - origin).dot(&(b - origin).cross(&(c - origin)));
        self.triangles().map(|(t, _)| cone(t)).sum::<f64>() / 6.0
    }
}

/// Whether the edges, in order, form a single closed loop without repeated corners.
fn is_ring(edges: &[(usize, usize, usize)]) -> bool {
    let n = edges.len();
    let mut starts: Vec<usize> = edges.iter().map(|e| e.0).collect();
    starts.sort_unstable();
    starts.dedup();
    n >= 3 && starts.len() == n && (0..n).all(|k| edges[k].1 == edges[(k + 1) % n].0)
}
