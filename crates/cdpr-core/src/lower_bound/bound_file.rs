//! A certificate of a lower bound, as plain data that can be checked without this program.

use serde::Serialize;

use super::bends::FreePart;
use crate::collision::Checker;
use crate::forbidden::HPolyhedron;
use crate::geometry::{Point, wxyz};
use crate::model::Scene;
use crate::proof::NamedRegion;
use crate::tolerances::{BOUND_MARGIN, WRITTEN_LABEL};

use super::interval::{Interval, Label};

/// What the file says it is.
pub const FORMAT: &str = "cdpr-bound";
/// Version of the format.
pub const VERSION: u32 = 1;

/// A certificate that no path that keeps a gap of more than the margin is shorter than a length; docs/bounds.md describes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Certificate {
    /// [`FORMAT`].
    pub format: &'static str,
    /// [`VERSION`].
    pub version: u32,
    /// Fingerprint of the scene at its orientation.
    pub scene: String,
    /// World-from-platform quaternion [w, x, y, z].
    pub orientation: [f64; 4],
    /// The gap, m.
    pub margin: f64,
    /// Start, m.
    pub start: [f64; 3],
    /// Goal, m.
    pub goal: [f64; 3],
    /// No path is shorter, m.
    pub length: f64,
    /// Smallest and largest position, m.
    #[serde(rename = "box")]
    pub bounds: [[f64; 3]; 2],
    /// Convex polyhedra of positions that are forbidden, or within the margin of such.
    pub regions: Vec<NamedRegion>,
    /// Parts of their edges where a path may bend.
    pub edges: Vec<EdgeRow>,
    /// Their corners where a path may bend: three coordinates and a lower bound of the distance from the start, m.
    pub corners: Vec<[f64; 4]>,
}

/// A part of an edge in pieces.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EdgeRow {
    /// Index of its region.
    pub region: usize,
    /// Indices of the two half-spaces whose planes meet in it.
    pub planes: [usize; 2],
    /// Both ends, m.
    pub ends: [[f64; 3]; 2],
    /// For each piece: where it ends, as a fraction, and lower bounds of the distance from the start at both of its ends, m.
    pub pieces: Vec<[f64; 3]>,
}

/// What [`Certificate::of`] needs besides the scene.
pub struct Parts<'p> {
    /// The ends of all paths.
    pub ends: &'p [Point; 2],
    /// The box of positions.
    pub bounds: [Point; 2],
    /// What is proved, m.
    pub length: f64,
    /// The polyhedra, and the condition that forbids each.
    pub regions: Vec<(usize, HPolyhedron)>,
    /// Free parts of their edges, in the order of the numbers in the intervals.
    pub edges: Vec<FreePart>,
}

impl Certificate {
    /// The certificate of a bound.
    pub fn of<'i>(
        parts: &Parts,
        labelled: impl Iterator<Item = (&'i Interval, &'i Label)>,
        scene: &Scene,
        checker: &dyn Checker,
    ) -> Self {
        let conditions = checker.conditions();
        let region = |(condition, hull): &(usize, HPolyhedron)| NamedRegion {
            who: conditions.culprits(&conditions.list[*condition]),
            half_spaces: hull.planes().iter().map(|h| [h.normal.x, h.normal.y, h.normal.z, h.offset]).collect(),
        };
        let row = |edge: &FreePart| EdgeRow {
            region: edge.hull,
            planes: edge.planes,
            ends: edge.ends.map(|end| end.into()),
            pieces: Vec::new(),
        };
        let mut edges: Vec<EdgeRow> = parts.edges.iter().map(row).collect();
        let mut corners = Vec::new();
        // Where no sufficiently short path passes, the label is infinite; any large number can stand for it.
        let written = |value: f64| (value.min(2.0 * parts.length + 1.0) / WRITTEN_LABEL).round() * WRITTEN_LABEL;
        for (interval, label) in labelled {
            let [from, to] = label.0.map(written);
            match interval.of_edge() {
                Some((edge, range)) => edges[edge].pieces.push([range[1], from, to]),
                None => corners.push([interval.ends[0].x, interval.ends[0].y, interval.ends[0].z, from]),
            }
        }
        edges.iter_mut().for_each(|edge| edge.pieces.sort_by(|a, b| a[0].total_cmp(&b[0])));
        Certificate {
            format: FORMAT,
            version: VERSION,
            scene: scene.fingerprint(),
            orientation: wxyz(scene.orientation()),
            margin: BOUND_MARGIN,
            start: parts.ends[0].into(),
            goal: parts.ends[1].into(),
            length: parts.length,
            bounds: parts.bounds.map(|corner| corner.into()),
            regions: parts.regions.iter().map(region).collect(),
            edges,
            corners,
        }
    }
}
