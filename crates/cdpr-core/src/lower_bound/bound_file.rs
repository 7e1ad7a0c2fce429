//! The certificate of a lower bound.

use super::bends::FreePart;
use crate::certificate::{BoundCertificate, EdgeRow, Region, VERSION, WeakBox};
use crate::forbidden::HPolyhedron;
use crate::geometry::{Point, wxyz};
use crate::model::Scene;
use crate::tolerances::{BOUND_MARGIN, WRITTEN_LABEL};

use super::interval::{Interval, Label};

/// What [`BoundCertificate::of`] needs besides the scene.
pub struct Parts<'p> {
    /// Start and goal.
    pub ends: &'p [Point; 2],
    /// The box of positions.
    pub bounds: [Point; 2],
    /// The length to be certified, m.
    pub length: f64,
    /// What contains no position of a path that counts.
    pub regions: Vec<BoundRegion>,
    /// Free parts of the polyhedra's edges, in the order of the numbers in the intervals.
    pub edges: Vec<FreePart>,
}

/// A polyhedron of forbidden positions, or where wrenches lack.
pub struct BoundRegion {
    /// The names of the pair, or [`WRENCH`](crate::certificate::WRENCH).
    pub who: Vec<String>,
    pub hull: HPolyhedron,
    /// Boxes that prove that wrenches lack.
    pub boxes: Vec<WeakBox>,
}

impl BoundCertificate {
    /// The certificate of a bound.
    pub fn of<'i>(parts: &Parts, labelled: impl Iterator<Item = (&'i Interval, &'i Label)>, scene: &Scene) -> Self {
        let region = |BoundRegion { who, hull, boxes }: &BoundRegion| Region {
            who: who.clone(),
            boxes: boxes.clone(),
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
        BoundCertificate {
            format: BoundCertificate::FORMAT.to_string(),
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
