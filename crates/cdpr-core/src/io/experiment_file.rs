//! Experiment files.

use std::path::Path;

use super::loader::Loader;
use super::scene_file::in_place;
use super::text::{self, Notation};
use crate::batch::{Experiment, ExperimentSpec, SceneSource};
use crate::error::{Error, name_of_file};

/// Loads an experiment; scenes it names are read relative to its file.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_experiment(path: &Path) -> Result<Experiment, Error> {
    Loader::PATIENT.experiment(path)
}

/// An experiment from text; scenes it names are read relative to `folder`, or to where the program runs.
///
/// # Errors
/// As [`load_experiment`].
pub fn experiment_from_text(text: &str, notation: Notation, folder: Option<&Path>) -> Result<Experiment, Error> {
    Loader::PATIENT.experiment_from_text(text, notation, folder)
}

impl Loader<'_> {
    /// As [`load_experiment`].
    ///
    /// # Errors
    /// As [`load_experiment`], and the watch's.
    pub fn experiment(&self, path: &Path) -> Result<Experiment, Error> {
        let notation = Notation::of(path)?;
        let mut spec: ExperimentSpec = text::parse(&text::read(path)?, notation).map_err(|e| e.in_file(path))?;
        if spec.name.is_none() {
            spec.name = name_of_file(path);
        }
        checked(spec, Some(path.parent().unwrap_or(Path::new("."))), self).map_err(|e| e.in_file(path))
    }

    /// As [`experiment_from_text`].
    ///
    /// # Errors
    /// As [`load_experiment`], and the watch's.
    pub fn experiment_from_text(
        &self,
        text: &str,
        notation: Notation,
        folder: Option<&Path>,
    ) -> Result<Experiment, Error> {
        checked(text::parse(text, notation)?, folder, self)
    }
}

fn checked(spec: ExperimentSpec, folder: Option<&Path>, loader: &Loader) -> Result<Experiment, Error> {
    let folder = folder.unwrap_or(Path::new(""));
    Experiment::new(spec, |scene| match scene {
        SceneSource::File(path) => loader.scene(&folder.join(path)),
        SceneSource::Inline(spec) => in_place((**spec).clone(), Some(folder), &loader.watch),
    })
}
