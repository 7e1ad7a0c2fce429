//! The forbidden polyhedra for string pulling, slightly enlarged so that a path along their surface is free.

use rand::{Rng, RngExt};

use super::polygon::{Frame, Polygon};
use crate::geometry::{HalfSpace, Point, Vector};
use crate::tolerances::{GRAZING, ON_SURFACE, PARALLEL, STANDOFF};

/// A convex polyhedron of positions that a path must avoid.
#[derive(Debug, Clone, PartialEq)]
pub struct HPolyhedron {
    planes: Vec<HalfSpace>,
}

/// How much of a box a hull contains.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overlap {
    /// None of the box.
    None,
    /// Possibly some of the box.
    Part,
    /// All of the box, with a margin.
    All,
}

/// A part of an edge: its beginning, the vector to its end, and the two planes that meet in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    from: Point,
    along: Vector,
    planes: [usize; 2],
}

impl HPolyhedron {
    /// The polyhedron with its planes moved outward by [`STANDOFF`].
    pub fn around(half_spaces: Vec<HalfSpace>) -> Self {
        HPolyhedron { planes: half_spaces.into_iter().map(|h| h.widened(STANDOFF)).collect() }
    }

    /// The planes that bound the polyhedron, with outward normals.
    pub fn planes(&self) -> &[HalfSpace] {
        &self.planes
    }

    /// How much of a box, given by its centre and half its sides, the polyhedron contains, as far as each plane alone
    /// shows.
    pub fn overlap(&self, center: &Point, half: &Vector) -> Overlap {
        let mut overlap = Overlap::All;
        for plane in &self.planes {
            let (height, reach) = (plane.height(center), plane.normal.abs().dot(half));
            if height - reach >= 0.0 {
                return Overlap::None;
            }
            if height + reach >= -ON_SURFACE {
                overlap = Overlap::Part;
            }
        }
        overlap
    }

    /// Whether a single plane has all these points outside or on it.
    pub fn apart(&self, points: &[Point]) -> bool {
        self.planes.iter().any(|plane| points.iter().all(|p| plane.height(p) >= -GRAZING))
    }

    /// The polyhedron without enlargement.
    pub fn exact(half_spaces: Vec<HalfSpace>) -> Self {
        HPolyhedron { planes: half_spaces }
    }

    /// The interval of t for which `from + t along`, a line in one of the planes, is on the polyhedron's surface; if
    /// another plane is equal to that one up to rounding, the line belongs to both.
    pub fn side(&self, from: &Point, along: &Vector) -> Option<[f64; 2]> {
        inside(&self.planes, from, along, EVERYWHERE, GRAZING)
    }

    /// Whether a point is strictly inside.
    pub fn holds(&self, point: &Point) -> bool {
        self.planes.iter().all(|plane| plane.height(point) < -ON_SURFACE)
    }

    /// The interval of t for which `from + t along` is inside; `None` if it never is.
    pub fn inside(&self, from: &Point, along: &Vector) -> Option<[f64; 2]> {
        inside(&self.planes, from, along, EVERYWHERE, -GRAZING)
    }

    /// The part of an interval of t for which `from + t along` is inside; `None` if it never is.
    pub fn inside_within(&self, from: &Point, along: &Vector, window: [f64; 2]) -> Option<[f64; 2]> {
        inside(&self.planes, from, along, window, -GRAZING)
    }

    /// The interval of t in [0, 1] for which `from + t along`, on an edge in which two planes meet, is inside or on the face that
    /// lies in one of these planes; `None` if the polyhedron has both planes and so the same edge.
    pub fn inside_or_on_face(&self, planes: &[HalfSpace; 2], from: &Point, along: &Vector) -> Option<[f64; 2]> {
        if planes.iter().all(|plane| self.planes.contains(plane)) {
            return None;
        }
        let others: Vec<HalfSpace> = self.planes.iter().filter(|plane| !planes.contains(plane)).copied().collect();
        inside(&others, from, along, [0.0, 1.0], -GRAZING)
    }

    /// The two planes that bound the polyhedron at an edge: of all planes through it, those that are turned most from each other.
    /// The others are redundant.
    pub fn wedge(&self, edge: &Edge) -> [HalfSpace; 2] {
        let ends = edge.ends();
        let here = |plane: &&HalfSpace| ends.iter().all(|end| plane.height(end).abs() < ON_SURFACE);
        let here: Vec<&HalfSpace> = self.planes.iter().filter(here).collect();
        let pairs = here.iter().enumerate().flat_map(|(k, a)| here[k + 1..].iter().map(move |b| [**a, **b]));
        let turned = |pair: &[HalfSpace; 2]| pair[0].normal.dot(&pair[1].normal);
        let own = edge.planes().map(|plane| self.planes[plane]);
        pairs.chain([own]).min_by(|a, b| turned(a).total_cmp(&turned(b))).expect("its own planes")
    }

    /// The directions of the polyhedron's edges through a point.
    pub fn edges_at(&self, place: &Point) -> Vec<Vector> {
        if self.planes.iter().any(|plane| plane.height(place) > ON_SURFACE) {
            return Vec::new();
        }
        let here: Vec<&HalfSpace> = self.planes.iter().filter(|plane| plane.height(place) > -ON_SURFACE).collect();
        let pairs = here.iter().enumerate().flat_map(|(k, a)| here[k + 1..].iter().map(move |b| (a, b)));
        pairs.filter_map(|(a, b)| edge_direction(a, b)).collect()
    }

    /// The edges of one face of the polyhedron, clipped to a box. If several planes coincide up to rounding, the face
    /// belongs to the first of them.
    pub fn face_edges(&self, face: usize, low: &Point, high: &Point, polygon: &mut Polygon, edges: &mut Vec<Edge>) {
        edges.clear();
        let own = &self.planes[face];
        let center = nalgebra::center(low, high);
        let along = own.normal.cross(&Vector::ith(own.normal.iamin(), 1.0)).normalize();
        let across = own.normal.cross(&along);
        let frame = Frame { origin: center - own.normal * own.height(&center), along, across };
        let reach = 0.5 * (high - low).norm(); // a square around the part of the face in the box
        polygon.begin([[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]]);
        for axis in 0..3 {
            for (side, sign) in [(low, -1.0), (high, 1.0)] {
                polygon.clip(frame.height(&HalfSpace::through(side, Vector::ith(axis, sign))), None);
            }
        }
        for (index, plane) in self.planes.iter().enumerate().filter(|(index, _)| *index != face) {
            let [a, b, c] = frame.height(plane);
            let same = a.abs().max(b.abs()) < PARALLEL && c.abs() < GRAZING;
            if !(same && plane.normal.dot(&own.normal) > 0.0 && face < index) {
                polygon.clip([a, b, c], Some(index));
            }
            if polygon.corners().is_empty() {
                return;
            }
        }
        edges.extend(polygon.with_previous().filter_map(|[before, corner]| {
            let from = frame.point(&before.place);
            Some(Edge { from, along: frame.point(&corner.place) - from, planes: [face, before.line?] })
        }));
    }
}

impl Edge {
    /// The part of the edge in a box, possibly a single point; `None` if it misses the box.
    pub fn within(&self, low: &Point, high: &Point) -> Option<Edge> {
        let length = self.along.norm();
        let direction = self.along.try_normalize(0.0)?;
        let [from, to] = in_box(low, high, &self.from, &direction);
        let range = [from.max(0.0), to.min(length)];
        let [from, to] = range.map(|t| (self.from + direction * t).sup(low).inf(high));
        (range[0] <= range[1]).then_some(Edge { from, along: to - from, ..*self })
    }

    /// The point at a fraction of the edge's length.
    pub fn at(&self, share: f64) -> Point {
        self.from + self.along * share
    }

    /// The part of the edge within a distance, m, on both sides of the point at a fraction.
    pub fn around(&self, share: f64, distance: f64) -> Edge {
        let reach = distance / self.along.norm().max(distance);
        let [low, high] = [(share - reach).max(0.0), (share + reach).min(1.0)];
        Edge { from: self.at(low), along: self.along * (high - low), ..*self }
    }

    /// Both ends of the edge.
    pub fn ends(&self) -> [Point; 2] {
        [self.from, self.from + self.along]
    }

    /// The indices of the two planes that meet in the edge.
    pub fn planes(&self) -> [usize; 2] {
        self.planes
    }

    /// Length of the edge, m.
    pub fn length(&self) -> f64 {
        self.along.norm()
    }

    /// A uniform random point on the edge.
    pub fn sample(&self, rng: &mut dyn Rng) -> Point {
        self.from + self.along * rng.random::<f64>()
    }

    /// The pieces of the edge outside all hulls that have at least the length `least`, m.
    pub fn outside<'h>(&self, hulls: impl Iterator<Item = &'h HPolyhedron>, least: f64) -> Vec<Edge> {
        let covered = hulls.filter_map(|hull| hull.inside_within(&self.from, &self.along, [0.0, 1.0]));
        let free = gaps(covered.collect(), 1.0).into_iter();
        let pieces = free.map(|[a, b]| Edge { from: self.at(a), along: self.along * (b.min(1.0) - a), ..*self });
        pieces.filter(|piece| piece.along.norm() >= least).collect()
    }
}

/// The gaps that ranges leave from zero to an end.
pub fn gaps(mut covered: Vec<[f64; 2]>, end: f64) -> Vec<[f64; 2]> {
    covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut at = 0.0;
    let mut gaps = Vec::new();
    for [start, end] in covered.into_iter().chain([[end, end]]) {
        if start > at {
            gaps.push([at, start]);
        }
        at = at.max(end);
    }
    gaps
}

/// The whole line.
const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// The interval of a line in an intersection of half-spaces and a window; `None` if it is empty. If a plane is parallel
/// to the line, the line counts as outside if it is higher than `rim`, m.
fn inside(planes: &[HalfSpace], from: &Point, along: &Vector, window: [f64; 2], rim: f64) -> Option<[f64; 2]> {
    let [mut low, mut high] = window;
    for plane in planes {
        let (height, slope) = (plane.height(from), plane.normal.dot(along));
        if slope > PARALLEL {
            high = high.min(-height / slope);
        } else if slope < -PARALLEL {
            low = low.max(-height / slope);
        } else if height >= rim {
            return None;
        }
        if low >= high {
            return None;
        }
    }
    Some([low, high])
}

/// The interval of a line in a box; possibly empty.
pub fn in_box(low: &Point, high: &Point, from: &Point, along: &Vector) -> [f64; 2] {
    let mut range = [f64::NEG_INFINITY, f64::INFINITY];
    for axis in 0..3 {
        if along[axis].abs() > PARALLEL {
            let [a, b] = [low, high].map(|end| (end[axis] - from[axis]) / along[axis]);
            range = [range[0].max(a.min(b)), range[1].min(a.max(b))];
        }
    }
    range
}

/// The line in which two planes intersect: a point and a unit vector.
pub fn meeting_line(a: &HalfSpace, b: &HalfSpace) -> Option<(Point, Vector)> {
    let along = edge_direction(a, b)?;
    let system = nalgebra::Matrix3::from_rows(&[a.normal.transpose(), b.normal.transpose(), along.transpose()]);
    let point = system.lu().solve(&Vector::new(a.offset, b.offset, 0.0))?;
    Some((Point::from(point), along))
}

/// The unit vector along the edge of two planes; `None` if they are nearly parallel.
pub fn edge_direction(a: &HalfSpace, b: &HalfSpace) -> Option<Vector> {
    a.normal.cross(&b.normal).try_normalize(crate::tolerances::NEARLY_PARALLEL)
}
