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
    Experiment::load(path, &Loader::PATIENT)
}

/// Reads an experiment from text; paths of scenes are relative to `folder`, or to the working directory.
///
/// # Errors
/// The errors of [`load_experiment`].
pub fn experiment_from_text(text: &str, notation: Notation, folder: Option<&Path>) -> Result<Experiment, Error> {
    Experiment::from_text(text, notation, folder, &Loader::PATIENT)
}

impl Experiment {
    /// Loads an experiment with an interruptible loader; paths of scenes are relative to its file.
    ///
    /// # Errors
    /// Names the file, the key, what was found and what was expected; the loader's watch stops it.
    pub fn load(path: impl AsRef<Path>, loader: &Loader) -> Result<Self, Error> {
        let path = path.as_ref();
        let notation = Notation::of(path)?;
        let mut spec: ExperimentSpec = text::parse(&text::read(path)?, notation).map_err(|e| e.in_file(path))?;
        if spec.name.is_none() {
            spec.name = name_of_file(path);
        }
        checked(spec, Some(path.parent().unwrap_or(Path::new("."))), loader).map_err(|e| e.in_file(path))
    }

    /// Reads an experiment from text with an interruptible loader; paths of scenes are relative to `folder`, or to the
    /// working directory.
    ///
    /// # Errors
    /// Names the key, what was found and what was expected; the loader's watch stops it.
    pub fn from_text(text: &str, notation: Notation, folder: Option<&Path>, loader: &Loader) -> Result<Self, Error> {
        checked(text::parse(text, notation)?, folder, loader)
    }
}

fn checked(spec: ExperimentSpec, folder: Option<&Path>, loader: &Loader) -> Result<Experiment, Error> {
    let folder = folder.unwrap_or(Path::new(""));
    Experiment::new(spec, |scene| match scene {
        SceneSource::File(path) => loader.scene(folder.join(path)),
        SceneSource::Inline(spec) => loader.scene_from_spec((**spec).clone(), Some(folder)),
    })
}
