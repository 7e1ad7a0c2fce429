//! Scene and robot files, and the schemas of all formats.

use std::path::{Path, PathBuf};

use schemars::schema_for;

use super::text::{self, Notation};
use crate::batch::ExperimentSpec;
use crate::choice::choices;
use crate::error::Error;
use crate::model::{Robot, RobotSource, RobotSpec, Scene, SceneSpec};

/// Loads a scene; a robot file it names is read relative to the scene file.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_scene(path: &Path) -> Result<Scene, Error> {
    let notation = Notation::of(path)?;
    let mut spec: SceneSpec = text::parse(&text::read(path)?, notation).map_err(|e| e.in_file(path))?;
    if spec.name.is_none() {
        spec.name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    }
    in_place(spec, path.parent()).map_err(|e| e.in_file(path))
}

/// A scene from text; robot files it names are read relative to `folder`.
///
/// # Errors
/// As [`load_scene`].
pub fn scene_from_text(text: &str, notation: Notation, folder: Option<&Path>) -> Result<Scene, Error> {
    in_place(text::parse(text, notation)?, folder)
}

/// Loads a robot file.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_robot(path: &Path) -> Result<Robot, Error> {
    Robot::try_from(robot_spec(path)?).map_err(|e| e.in_file(path))
}

fn robot_spec(path: &Path) -> Result<RobotSpec, Error> {
    let notation = Notation::of(path)?;
    let spec: RobotSpec = text::parse(&text::read(path)?, notation).map_err(|e| e.in_file(path))?;
    match spec.version {
        Some(_) => Ok(spec),
        None => {
            Err(Error::invalid("version", "found none, expected version = 1 at the top of a robot file").in_file(path))
        }
    }
}

/// Reads the robot file, if the scene names one, and checks the whole.
pub(super) fn in_place(mut spec: SceneSpec, folder: Option<&Path>) -> Result<Scene, Error> {
    match &spec.robot {
        RobotSource::File(name) => {
            let path = folder.map_or_else(|| PathBuf::from(name), |folder| folder.join(name));
            let robot = robot_spec(&path)?;
            Robot::try_from(robot.clone()).map_err(|e| e.in_file(&path))?;
            spec.robot = RobotSource::Inline(RobotSpec { version: None, ..robot });
        }
        RobotSource::Inline(robot) if robot.version.is_some() => {
            return Err(Error::invalid(
                "robot.version",
                "found one in a scene; only a robot file of its own has a version",
            ));
        }
        RobotSource::Inline(_) => {}
    }
    Scene::new(spec)
}

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
        Format::Path => schema_for!(super::path_file::PathFile).to_value(),
        Format::Experiment => schema_for!(ExperimentSpec).to_value(),
    }
}
