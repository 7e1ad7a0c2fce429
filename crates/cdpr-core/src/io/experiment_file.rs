//! Experiment files.

use std::path::Path;

use super::scene_file::{in_place, load_scene};
use super::text::{self, Notation};
use crate::batch::{Experiment, ExperimentSpec, SceneSource};
use crate::error::Error;

/// Loads an experiment; scenes it names are read relative to its file.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_experiment(path: &Path) -> Result<Experiment, Error> {
    let mut spec: ExperimentSpec = text::parse(&text::read(path)?, Notation::of(path)?).map_err(|e| e.in_file(path))?;
    if spec.name.is_none() {
        spec.name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    }
    checked(spec, Some(path.parent().unwrap_or(Path::new(".")))).map_err(|e| e.in_file(path))
}

/// An experiment from text; scenes it names are read relative to `folder`, or to where the program runs.
///
/// # Errors
/// As [`load_experiment`].
pub fn experiment_from_text(text: &str, notation: Notation, folder: Option<&Path>) -> Result<Experiment, Error> {
    checked(text::parse(text, notation)?, folder)
}

fn checked(spec: ExperimentSpec, folder: Option<&Path>) -> Result<Experiment, Error> {
    let folder = folder.unwrap_or(Path::new(""));
    Experiment::new(spec, |scene| match scene {
        SceneSource::File(path) => load_scene(&folder.join(path)),
        SceneSource::Inline(spec) => in_place((**spec).clone(), Some(folder)),
    })
}
