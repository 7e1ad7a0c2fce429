//! A proof as plain data, which can be checked without this program.

use serde::{Deserialize, Serialize};

use super::{Content, Proof};
use crate::collision::Checker;
use crate::error::Error;
use crate::geometry::{Cuboid, Point, wxyz};
use crate::model::Scene;

/// What the file says it is.
pub const FORMAT: &str = "cdpr-proof";
/// Version of the format.
pub const VERSION: u32 = 1;
/// Region of an open box.
pub const OPEN: i64 = -1;
/// Region of a box that a bound closes.
pub const BOUND: i64 = -2;
/// First item of the reason of a box whose positions lack a wrench; the direction [force; moment] follows.
pub const WRENCH: &str = "wrench";

/// A proof that no path keeps a gap of more than the margin.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// [`FORMAT`].
    pub format: String,
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
    /// Smallest and largest position, m.
    #[serde(rename = "box")]
    pub bounds: [[f64; 3]; 2],
    /// Convex polyhedra of positions within the margin of forbidden ones.
    pub regions: Vec<NamedRegion>,
    /// Boxes that tile the box of positions.
    pub boxes: Vec<BoxRow>,
}

/// A convex polyhedron of positions, and whose it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NamedRegion {
    /// The names of the members of the condition.
    pub who: Vec<String>,
    /// Half-spaces [nx, ny, nz, d] of points with n·x < d, m.
    pub half_spaces: Vec<[f64; 4]>,
}

/// A box: its smallest and largest coordinates, m, the index of the region that it is inside ([`OPEN`] or [`BOUND`] for none), and
/// the reason for a bound.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum BoxRow {
    /// An open box, or one inside a region.
    Plain(f64, f64, f64, f64, f64, f64, i64),
    /// A box that a bound closes: the names of the members of the condition, or [`WRENCH`] and a direction.
    Bound(f64, f64, f64, f64, f64, f64, i64, Vec<Reason>),
}

/// Part of the reason for a bound.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Reason {
    /// A name.
    Name(String),
    /// A number.
    Number(f64),
}

impl Certificate {
    /// The certificate of a proof about a scene, found with this engine.
    pub fn of(proof: &Proof, scene: &Scene, checker: &dyn Checker) -> Self {
        let conditions = checker.conditions();
        let names = |condition: usize| conditions.culprits(&conditions.list[condition]);
        let regions = proof.regions.iter().map(|region| NamedRegion {
            who: names(region.condition),
            half_spaces: region.half_spaces.iter().map(|h| [h.normal.x, h.normal.y, h.normal.z, h.offset]).collect(),
        });
        let reason = |condition: usize, positions: &Cuboid| match conditions.list.get(condition) {
            Some(_) => names(condition).into_iter().map(Reason::Name).collect(),
            None => {
                let direction = checker.lacking_wrench(positions).expect("the box was closed by it");
                let direction = direction.map(Reason::Number);
                std::iter::once(Reason::Name(WRENCH.to_string())).chain(direction).collect()
            }
        };
        let row = |b: &super::ProofBox| {
            let Cuboid { low, high, .. } = &b.positions;
            let plain = |region: i64| BoxRow::Plain(low.x, low.y, low.z, high.x, high.y, high.z, region);
            match b.content {
                Content::Open => plain(OPEN),
                Content::Region(region) => plain(region as i64),
                Content::Bound(condition) => {
                    let reason = reason(condition, &b.positions);
                    BoxRow::Bound(low.x, low.y, low.z, high.x, high.y, high.z, BOUND, reason)
                }
            }
        };
        let turn = scene.orientation();
        Certificate {
            format: FORMAT.to_string(),
            version: VERSION,
            scene: scene.fingerprint(),
            orientation: wxyz(turn),
            margin: proof.margin,
            start: proof.start.into(),
            goal: proof.goal.into(),
            bounds: [proof.bounds.low.into(), proof.bounds.high.into()],
            regions: regions.collect(),
            boxes: proof.boxes.iter().map(row).collect(),
        }
    }
}

/// Start and goal of a certificate, m, from its text.
///
/// # Errors
/// Text without them.
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
