//! The certificate of a proof.

use serde::Deserialize;

use super::{Content, Proof};
use crate::certificate::{Cell, Certificate, Region, Status, VERSION};
use crate::collision::Checker;
use crate::error::Error;
use crate::geometry::{Cuboid, Point, wxyz};
use crate::model::Scene;

impl Certificate {
    /// The certificate of a proof about a scene, found with this engine.
    pub fn of(proof: &Proof, scene: &Scene, checker: &dyn Checker) -> Self {
        let conditions = checker.conditions();
        let names = |condition: usize| conditions.culprits(&conditions.list[condition]);
        let regions = proof.regions.iter().map(|region| Region {
            who: names(region.condition),
            boxes: Vec::new(),
            half_spaces: region.half_spaces.iter().map(|h| [h.normal.x, h.normal.y, h.normal.z, h.offset]).collect(),
        });
        let reason = |condition: usize, positions: &Cuboid| match conditions.list.get(condition) {
            Some(_) => Status::Broken(names(condition)),
            None => Status::TooWeak(checker.lacking_wrench(positions).expect("the box was closed by it")),
        };
        let cell = |b: &super::ProofBox| Cell {
            bounds: [b.positions.low.into(), b.positions.high.into()],
            status: match b.content {
                Content::Open => Status::Open,
                Content::Region(region) => Status::Within(region),
                Content::Bound(condition) => reason(condition, &b.positions),
            },
        };
        let turn = scene.orientation();
        Certificate {
            format: Certificate::FORMAT.to_string(),
            version: VERSION,
            scene: scene.fingerprint(),
            orientation: wxyz(turn),
            margin: proof.margin,
            start: proof.start.into(),
            goal: proof.goal.into(),
            bounds: [proof.bounds.low.into(), proof.bounds.high.into()],
            regions: regions.collect(),
            boxes: proof.boxes.iter().map(cell).collect(),
        }
    }
}

/// Start and goal of a certificate, m, from its text.
///
/// # Errors
/// Text without start and goal.
pub fn certificate_ends(text: &str) -> Result<[Point; 2], Error> {
    #[derive(Deserialize)]
    struct Ends {
        start: [f64; 3],
        goal: [f64; 3],
    }
    let parsed: Result<Ends, _> = serde_json::from_str(text);
    let Ends { start, goal } = parsed.map_err(|e| Error::invalid("", format!("found no certificate: {e}")))?;
    Ok([start.into(), goal.into()])
}
