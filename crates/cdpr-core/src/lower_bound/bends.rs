//! Where a shortest path may bend, for a certificate: the free parts of edges, and corners.
//!
//! A checker derives the same places in exact arithmetic and expects all of them to be listed. So a part counts as covered here
//! only if it is at least [`COVERED_DEPTH`] deep inside, which exceeds rounding errors, and nothing is merged.

use std::collections::BTreeMap;

use super::free_edges::Ellipsoid;
use crate::error::Error;
use crate::forbidden::{HPolyhedra, HPolyhedron, Near, Polygon, gaps};
use crate::geometry::{HalfSpace, Point};
use crate::tolerances::{COVERED_DEPTH, SAME_CORNER};
use crate::watch::Watch;

/// A part of an edge that is not certainly covered, and the two planes that meet in it, by index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreePart {
    /// Index of the polyhedron.
    pub hull: usize,
    /// Indices of the two planes of the polyhedron that meet in the edge.
    pub planes: [usize; 2],
    /// Both ends of the part.
    pub ends: [Point; 2],
}

/// All parts of edges and all corners where a path within an ellipsoid may bend.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn bends(
    hulls: &HPolyhedra,
    [low, high]: [&Point; 2],
    within: &Ellipsoid,
    watch: &Watch,
) -> Result<(Vec<FreePart>, Vec<Point>), Error> {
    let (mut parts, mut corners, mut near) = (Vec::new(), Corners::default(), Near::default());
    for (index, hull) in hulls.list().iter().enumerate() {
        watch.check()?;
        let own = edges_of(hulls, hull);
        for (planes, ends) in &own {
            let others = hulls.near(ends, &mut near).map(|other| (position_of(other, hulls), other));
            let pair = planes.map(|plane| hull.planes()[plane]);
            let along = ends[1] - ends[0];
            let covered = others.filter(|(at, _)| *at != index);
            let covered = covered.filter_map(|(at, other)| covered_by(other, at < index, &pair, ends)).collect();
            for gap in gaps(covered, 1.0 + f64::EPSILON) {
                let ends = gap.map(|t| ends[0] + along * t.min(1.0));
                if within.part(&ends[0], &ends[1]).is_some() {
                    parts.push(FreePart { hull: index, planes: *planes, ends });
                }
            }
        }
        for corner in own.values().flatten().filter(|corner| within.via(corner) <= within.length) {
            let wall = (0..3).any(|k| (corner[k] - low[k]).min(high[k] - corner[k]).abs() < COVERED_DEPTH);
            let mut others = hulls.near(&[*corner], &mut near).map(|other| (position_of(other, hulls), other));
            if may_bend_at(corner, (index, hull), wall, &mut others) {
                corners.add(*corner);
            }
        }
    }
    Ok((parts, corners.0))
}

/// The edges of a polyhedron by their planes.
fn edges_of(hulls: &HPolyhedra, hull: &HPolyhedron) -> BTreeMap<[usize; 2], [Point; 2]> {
    let (mut polygon, mut edges, mut all) = (Polygon::default(), Vec::new(), BTreeMap::new());
    for face in 0..hull.planes().len() {
        hulls.edges(hull, face, &mut polygon, &mut edges);
        for edge in &edges {
            let [a, b] = edge.planes();
            all.entry([a.min(b), a.max(b)]).or_insert(edge.ends());
        }
    }
    all
}

fn position_of(hull: &HPolyhedron, hulls: &HPolyhedra) -> usize {
    hulls.list().iter().position(|other| std::ptr::eq(other, hull)).expect("one of the list")
}

/// The part of an edge, as fractions, inside another polyhedron or inside one of its faces. The polyhedron may have the same edge:
/// then the part counts as covered if the other one comes `first`.
fn covered_by(other: &HPolyhedron, first: bool, planes: &[HalfSpace; 2], [from, to]: &[Point; 2]) -> Option<[f64; 2]> {
    if planes.iter().all(|plane| other.planes().contains(plane)) && !first {
        return None;
    }
    let [mut low, mut high] = [0.0, 1.0];
    for plane in other.planes().iter().filter(|plane| !planes.contains(plane)) {
        let [a, b] = [from, to].map(|end| plane.height(end) + COVERED_DEPTH);
        match (a < 0.0, b < 0.0) {
            (true, true) => {}
            (true, false) => high = f64::min(high, a / (a - b)),
            (false, true) => low = f64::max(low, a / (a - b)),
            (false, false) => return None,
        }
    }
    (low < high).then_some([low, high])
}

/// Whether a path may bend at a corner: not if it is covered, or if no other polyhedron is near it.
fn may_bend_at(
    corner: &Point,
    (index, hull): (usize, &HPolyhedron),
    mut touched: bool,
    others: &mut dyn Iterator<Item = (usize, &HPolyhedron)>,
) -> bool {
    let here = |plane: &&HalfSpace| plane.height(corner).abs() < COVERED_DEPTH;
    let own: Vec<&HalfSpace> = hull.planes().iter().filter(here).collect();
    if own.len() < 3 {
        return false; // an edge ends at the box
    }
    let simple = own.len() == 3;
    for (at, other) in others.filter(|(at, _)| *at != index) {
        let inside = |plane: &&HalfSpace| plane.height(corner) < -COVERED_DEPTH;
        let mut rest = other.planes().iter().filter(|plane| !(simple && own.contains(plane)));
        let has_all = own.iter().all(|plane| other.planes().contains(plane));
        if rest.all(|plane| inside(&plane)) && !(has_all && at > index) {
            return false;
        }
        touched |= other.planes().iter().all(|plane| plane.height(corner) < COVERED_DEPTH);
    }
    touched || !simple
}

/// A list of points that keeps coincident ones once.
#[derive(Default)]
struct Corners(Vec<Point>);

impl Corners {
    fn add(&mut self, corner: Point) {
        if self.0.iter().all(|other| (other - corner).norm() > SAME_CORNER) {
            self.0.push(corner);
        }
    }
}
