//! Reading and writing robots, paths and texts.

use cdpr_core::Choice;
use cdpr_core::path::length;
use cdpr_core::path_file::PathFile;
use cdpr_core::watch::Watch;
use cdpr_files::{Loader, text::Notation};
use pyo3::prelude::*;

use crate::convert::{named, quaternion, serialized};
use crate::errors::{answered, interruptible};
use crate::scene::Scene;

/// Checks a robot given as JSON text and returns it with its meshes replaced by convex parts.
#[pyfunction]
pub fn check_robot(py: Python<'_>, text: &str) -> PyResult<String> {
    let robot = interruptible(py, |stop| Loader::new(Watch::on(stop)).robot_from_text(text, Notation::Json, None))?;
    Ok(serialized(robot.spec()))
}

/// Writes a robot given as JSON text to a robot file.
#[pyfunction]
pub fn save_robot(path: std::path::PathBuf, text: &str) -> PyResult<()> {
    answered(|| cdpr_files::save_table(&path, cdpr_files::robot_from_text(text, Notation::Json, None)?.spec()))
}

/// Imports a robot from another program: JSON text, and what was not carried over.
#[pyfunction]
pub fn import_robot(
    py: Python<'_>,
    path: std::path::PathBuf,
    bodies: Option<std::path::PathBuf>,
    cable_set: Option<String>,
    platform: Option<std::path::PathBuf>,
    units: &str,
) -> PyResult<(String, Vec<String>)> {
    let units = named(units)?;
    let options = cdpr_files::ImportOptions { bodies, cable_set, platform: platform.map(|mesh| (mesh, units)) };
    let found = interruptible(py, |stop| Loader::new(Watch::on(stop)).import(&path, &options))?;
    Ok((serialized(&found.whole), found.notes))
}

/// The robot of a robot file as JSON text.
#[pyfunction]
pub fn load_robot(py: Python<'_>, path: std::path::PathBuf) -> PyResult<String> {
    let robot = interruptible(py, |stop| Loader::new(Watch::on(stop)).robot(&path))?;
    Ok(serialized(robot.spec()))
}

/// Waypoints, orientation, the whole contents of the file as JSON, and a warning if it was planned for another scene.
type LoadedPath = (Vec<[f64; 3]>, Option<[f64; 4]>, String, Option<String>);

/// The waypoints of a path file as rows, and its orientation; with `strict`, a path for another scene is an error.
#[pyfunction]
pub fn load_path(path: std::path::PathBuf, scene: Option<&Scene>, strict: bool) -> PyResult<LoadedPath> {
    let (loaded, of_scene) = answered(|| {
        let loaded = cdpr_files::load_waypoints(&path)?;
        let of_scene =
            scene.map(|scene| cdpr_files::scene_of_path(&scene.0, &loaded, strict).map_err(|e| e.in_file(&path)));
        Ok((loaded, of_scene.transpose()?))
    })?;
    let (turned, warning) = of_scene.unzip();
    let said = loaded.file.as_ref().and_then(|file| file.orientation);
    let orientation = said.or(turned.as_ref().map(|scene| quaternion(scene.orientation())));
    let orientations = loaded.orientations.as_ref().map(|turns| turns.iter().map(quaternion).collect());
    // The weight of turns is that of the scene.
    let cost = turned.as_ref().filter(|_| orientations.is_some()).map(|scene| length(scene, &loaded.path(scene)));
    let bare = PathFile { orientations, cost, ..PathFile::default() };
    let json = serialized(&loaded.file.unwrap_or(bare));
    Ok((loaded.waypoints.into_iter().map(Into::into).collect(), orientation, json, warning.flatten()))
}

/// Writes the JSON of a result as a path file, or its waypoints as CSV.
#[pyfunction]
pub fn save_path(path: std::path::PathBuf, json: &str) -> PyResult<()> {
    let value: serde_json::Value = answered(|| cdpr_files::text::parse(json, Notation::Json))?;
    answered(|| cdpr_files::save_path(&path, &value))
}

/// An example scene as JSON text, with an inline robot.
#[pyfunction]
pub fn example(name: &str) -> PyResult<String> {
    answered(|| cdpr_files::example_text(name, Notation::Json))
}

/// Writes example files of other programs into a folder; their paths.
#[pyfunction]
pub fn save_example_files(folder: std::path::PathBuf, overwrite: bool) -> PyResult<Vec<std::path::PathBuf>> {
    answered(|| cdpr_files::save_example_files(&folder, overwrite))
}

/// The JSON Schema of the scene, robot, path or experiment format as JSON text.
#[pyfunction]
pub fn schema(of: &str) -> PyResult<String> {
    answered(|| Ok(cdpr_study::schema(Choice::named(of)?).to_string()))
}

/// Checks that a file can be written, before any work is done.
#[pyfunction]
pub fn check_target(path: std::path::PathBuf) -> PyResult<()> {
    answered(|| cdpr_files::check_target(&path))
}

/// Removes the files of a task that was saved in a folder before.
#[pyfunction]
pub fn remove_earlier_task(folder: std::path::PathBuf) -> PyResult<()> {
    answered(|| cdpr_files::remove_earlier_task(&folder))
}

/// Writes a text file atomically.
#[pyfunction]
pub fn save_text(path: std::path::PathBuf, text: &str) -> PyResult<()> {
    answered(|| cdpr_files::write_atomically(&path, text.as_bytes()))
}
