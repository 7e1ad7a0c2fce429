//! The known answers of `testdata/cases/cases.toml`, for the tests of the library and of the command line.
//!
//! Cases are compared with results in their JSON form, which both share.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::Value;

/// Tolerance of the known numbers, unless the case has its own.
const TOLERANCE: f64 = 1e-6;

/// All known answers.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cases {
    pub motion: Vec<MotionCase>,
    pub plan: Vec<PlanCase>,
    pub check: Vec<CheckCase>,
    pub wrench: Vec<WrenchCase>,
}

impl Cases {
    pub fn load() -> Self {
        toml::from_str(&fs::read_to_string(folder().join("cases.toml")).unwrap()).unwrap()
    }
}

/// The file of a scene; cases name it relative to their folder.
pub fn scene_file(scene: &str) -> PathBuf {
    folder().join(scene)
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/cases")
}

/// A straight motion.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionCase {
    pub name: String,
    pub scene: String,
    pub from: [f64; 3],
    pub to: [f64; 3],
    pub interference: Option<String>,
    pub violation: Option<Violation>,
}

/// A query, and the expected outcome of planning.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanCase {
    pub name: String,
    pub scene: String,
    pub start: Option<[f64; 3]>,
    pub goal: Option<[f64; 3]>,
    pub planner: Option<String>,
    #[serde(default)]
    pub seed: u64,
    pub max_samples: Option<usize>,
    pub status: String,
    pub length: Option<f64>,
    pub tolerance: Option<f64>,
    pub violation: Option<Violation>,
}

/// A path.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CheckCase {
    pub name: String,
    pub scene: String,
    pub waypoints: Vec<[f64; 3]>,
    pub violation: Option<Violation>,
    pub nearest: Option<Nearest>,
}

/// A position, and what the cables can do there.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WrenchCase {
    pub name: String,
    pub scene: String,
    pub position: [f64; 3],
    pub force: Option<f64>,
    pub feasible: bool,
    pub balanced: bool,
    pub margin: Option<f64>,
    pub tolerance: Option<f64>,
    pub rank: usize,
}

/// The first violation.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Violation {
    pub segment: Option<usize>,
    pub kind: String,
    pub culprits: Vec<String>,
    pub at: Option<f64>,
    pub margin: Option<f64>,
}

/// The closest approach of a path.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Nearest {
    pub segment: Option<usize>,
    pub value: f64,
    pub culprits: Vec<String>,
}

impl MotionCase {
    /// Whether the first violation, or null, is the known one.
    pub fn agrees(&self, found: &Value) -> bool {
        is_violation(self.violation.as_ref(), found)
    }
}

impl PlanCase {
    /// Whether a result, with `status`, `cost` and `reason`, is the known one.
    pub fn agrees(&self, found: &Value) -> bool {
        found["status"] == self.status
            && near(self.length, &found["cost"], self.tolerance)
            && found["cost"].is_null() == self.length.is_none()
            && is_violation(self.violation.as_ref(), &found["reason"])
    }
}

impl CheckCase {
    /// Whether a report is the known one.
    pub fn agrees(&self, found: &Value) -> bool {
        let approach = &found["min_clearance"];
        found["valid"] == self.violation.is_none()
            && is_violation(self.violation.as_ref(), &found["violations"][0])
            && self.nearest.as_ref().is_none_or(|nearest| {
                near(Some(nearest.value), &approach["value"], None)
                    && approach["culprits"] == Value::from(nearest.culprits.clone())
                    && nearest.segment.is_none_or(|segment| approach["segment"] == segment)
            })
    }
}

impl WrenchCase {
    /// Whether a report is the known one.
    pub fn agrees(&self, found: &Value) -> bool {
        found["feasible"] == self.feasible
            && found["balanced"] == self.balanced
            && found["rank"] == self.rank
            && near(self.margin, &found["capacity_margin"], self.tolerance)
    }
}

fn is_violation(expected: Option<&Violation>, found: &Value) -> bool {
    let Some(violation) = expected else { return found.is_null() };
    found["kind"] == violation.kind
        && found["culprits"] == Value::from(violation.culprits.clone())
        && violation.segment.is_none_or(|segment| found["segment"] == segment)
        && near(violation.at, &found["at"], None)
        && near(violation.margin, &found["margin"], None)
}

/// Whether a number is close to the known one, if one is given.
fn near(expected: Option<f64>, found: &Value, tolerance: Option<f64>) -> bool {
    let within = |e: f64, f: f64| (e - f).abs() <= tolerance.unwrap_or(TOLERANCE);
    expected.is_none_or(|e| found.as_f64().is_some_and(|f| within(e, f)))
}
