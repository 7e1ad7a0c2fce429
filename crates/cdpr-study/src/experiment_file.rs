//! Experiment files.

use std::path::Path;

use crate::{Experiment, ExperimentSpec, SceneSource};
use cdpr_core::error::{Error, name_of_file};
use cdpr_files::Loader;
use cdpr_files::text::{self, Notation};

/// Loads an experiment; paths of scenes are relative to its file.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_experiment(path: impl AsRef<Path>) -> Result<Experiment, Error> {
    let path = path.as_ref();
    load_experiment_by(&Loader::PATIENT, path)
}

/// Reads an experiment from text; paths of scenes are relative to `folder`, or to the working directory.
///
/// # Errors
/// As [`load_experiment`].
pub fn experiment_from_text(text: &str, notation: Notation, folder: Option<&Path>) -> Result<Experiment, Error> {
    experiment_from_text_by(&Loader::PATIENT, text, notation, folder)
}

/// As [`load_experiment`], with an interruptible loader.
///
/// # Errors
/// As [`load_experiment`], and those of the watch.
pub fn load_experiment_by(loader: &Loader, path: impl AsRef<Path>) -> Result<Experiment, Error> {
    let path = path.as_ref();
    let notation = Notation::of(path)?;
    let mut spec: ExperimentSpec = text::parse(&text::read(path)?, notation).map_err(|e| e.in_file(path))?;
    if spec.name.is_none() {
        spec.name = name_of_file(path);
    }
    checked(spec, Some(path.parent().unwrap_or(Path::new("."))), loader).map_err(|e| e.in_file(path))
}

/// As [`experiment_from_text`], with an interruptible loader.
///
/// # Errors
/// As [`load_experiment`], and those of the watch.
pub fn experiment_from_text_by(
    loader: &Loader,
    text: &str,
    notation: Notation,
    folder: Option<&Path>,
) -> Result<Experiment, Error> {
    checked(text::parse(text, notation)?, folder, loader)
}

fn checked(spec: ExperimentSpec, folder: Option<&Path>, loader: &Loader) -> Result<Experiment, Error> {
    let folder = folder.unwrap_or(Path::new(""));
    Experiment::new(spec, |scene| match scene {
        SceneSource::File(path) => loader.scene(folder.join(path)),
        SceneSource::Inline(spec) => loader.scene_from_spec((**spec).clone(), Some(folder)),
    })
}
