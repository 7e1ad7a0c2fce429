//! JSON Schemas of all file formats that people write.

use schemars::schema_for;

use crate::ExperimentSpec;
use cdpr_core::choices;
use cdpr_core::model::{RobotSpec, SceneSpec};
use cdpr_files::PathFile;

/// Which file format a schema is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Scene files.
    Scene,
    /// Robot files.
    Robot,
    /// Path files.
    Path,
    /// Experiment files.
    Experiment,
}

choices!(Format, "format", [
    Scene = "scene": "Scene files",
    Robot = "robot": "Robot files",
    Path = "path": "Path files",
    Experiment = "experiment": "Experiment files",
]);

/// JSON Schema of a file format.
pub fn schema(format: Format) -> serde_json::Value {
    match format {
        Format::Scene => schema_for!(SceneSpec).to_value(),
        Format::Robot => schema_for!(RobotSpec).to_value(),
        Format::Path => schema_for!(PathFile).to_value(),
        Format::Experiment => schema_for!(ExperimentSpec).to_value(),
    }
}
