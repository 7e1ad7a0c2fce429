//! Certificates of lower bounds: no path that keeps a gap of more than the margin is shorter than a length.
//!
//! Let F be the positions in the box and in no region, which is closed. If F has a path shorter than the length, it has a
//! shortest one. That path is straight except for bends at edges or corners of regions (`bends`). The certificate lists
//! pieces of edges and corners with labels. By induction along the path, a label exceeds the length up to a bend by at most
//! [`labels::STEP`] for each bend so far (`labels`). The goal's label is then a lower bound of the whole length.

use cdpr_core::Scene;
use cdpr_core::certificate::{BoundCertificate, Region};
use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;
use cdpr_core::watch::Watch;

use crate::bends;
use crate::bound_certificate::numbers_are_sound;
use crate::certificate::parsed;
use crate::labels::{self, Ends, Plane};
use crate::question::Question;
use crate::{Check, Proofs};

/// The size of a certificate of a bound that was accepted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundSummary {
    /// Lower bound of the length of all paths, m.
    pub length: f64,
    /// The bound holds for paths that keep a gap of more than this to forbidden positions, m.
    pub margin: f64,
    /// The number of regions.
    pub regions: usize,
    /// The number of those where wrenches lack; if there are any, the bound holds for paths on which the cables can exert the required ones.
    pub weak: usize,
    /// The number of pieces of edges.
    pub pieces: usize,
}

/// Checks the text of a certificate of a bound for a scene at its orientation.
///
/// # Errors
/// A defect of the certificate, and where it is: the certificate then proves nothing; [`Error::interrupted`],
/// [`Error::out_of_time`].
///
/// # Example
/// ```
/// use cdpr_core::Watch;
/// let scene = cdpr_core::testing::empty();
/// let error = cdpr_certify::check_bound(&scene, r#"{"format": "cdpr-proof"}"#, &Watch::NONE).unwrap_err();
/// assert_eq!(error.to_string(), r#"format: found "cdpr-proof", expected "cdpr-bound""#);
/// ```
pub fn check_bound(scene: &Scene, text: &str, watch: &Watch) -> Result<BoundSummary, Error> {
    BoundCertificate::parse(text)?.check(scene, watch)
}

impl Check for BoundCertificate {
    type Summary = BoundSummary;

    fn parse(text: &str) -> Result<Self, Error> {
        parsed(text, BoundCertificate::FORMAT)
    }

    fn check(&self, scene: &Scene, watch: &Watch) -> Result<BoundSummary, Error> {
        let question = Question {
            scene: &self.scene,
            orientation: &self.orientation,
            margin: self.margin,
            ends: [&self.start, &self.goal],
            bounds: &self.bounds,
        };
        question.numbers_are_sound()?;
        numbers_are_sound(self)?;
        question.is_of(scene)?;
        question.ends_are_in_box()?;
        let mut proofs = Proofs::of(scene, [&self.start, &self.goal], self.margin, Some(self.length));
        for (k, region) in self.regions.iter().enumerate() {
            watch.check()?;
            proofs.region(region, &self.bounds, watch).map_err(|e| e.under(&format!("regions[{k}]")))?;
        }
        question.ends_are_outside(&self.regions)?;
        let listed = bends::listed(self, watch)?;
        let planes: Vec<Vec<Plane>> = self.regions.iter().map(planes_of).collect();
        let mut pieces = Vec::new();
        for (edge, crossing) in self.edges.iter().zip(&listed.edges) {
            let Some(crossing) = crossing else { continue };
            let crossed = crossing.map(|pair| pair.map(|k| planes[edge.region][k]));
            let [from, to] = edge.ends.map(Vector::from);
            let mut at = 0.0;
            for [end, a, b] in &edge.pieces {
                let ends = [at, *end].map(|share| from + (to - from) * share);
                pieces.push(labels::LabelledPiece { ends: Ends { ends, labels: [*a, *b] }, crossed });
                at = *end;
            }
        }
        for (corner, _) in self.corners.iter().zip(&listed.corners).filter(|(_, used)| **used) {
            let [x, y, z, label] = *corner;
            let ends = [Vector::new(x, y, z); 2];
            pieces.push(labels::LabelledPiece { ends: Ends { ends, labels: [label; 2] }, crossed: None });
        }
        labels::hold(&planes, [self.start.into(), self.goal.into()], &pieces, (self.length, listed.bends), watch)?;
        let count = self.edges.iter().map(|edge| edge.pieces.len()).sum();
        let weak = self.regions.iter().filter(|region| !region.boxes.is_empty()).count();
        let (regions, pieces) = (self.regions.len(), count);
        Ok(BoundSummary { length: self.length, margin: self.margin, regions, weak, pieces })
    }
}

fn planes_of(region: &Region) -> Vec<Plane> {
    region.half_spaces.iter().map(|[x, y, z, d]| Plane { normal: Vector::new(*x, *y, *z), offset: *d }).collect()
}
