//! Models for simulators.

use std::path::PathBuf;

use cdpr_core::Recorded;
use cdpr_files::{check_mjcf_name, check_target, mjcf, motion_of_mjcf, scene_of_trajectory};
use pyo3::prelude::*;

use crate::convert::named;
use crate::errors::answered;
use crate::scene::Scene;
use crate::timed::Trajectory;

/// Writes a scene, and if given a motion, for MuJoCo. Returns notes on what the model leaves out or assumes, and a warning if the
/// motion was made for another scene; with `strict`, that is an error instead.
#[pyfunction]
pub fn save_mjcf(
    py: Python<'_>,
    path: PathBuf,
    scene: &Scene,
    motion: Option<&Trajectory>,
    control: &str,
    strict: bool,
) -> PyResult<(Vec<String>, Option<String>)> {
    let control = named(control)?;
    py.detach(|| {
        answered(|| {
            check_mjcf_name(&path)?;
            check_target(&path)?;
            let Some(motion) = motion else {
                let made = mjcf(&scene.0, None, control)?;
                return cdpr_files::save_mjcf(&path, &made).map(|()| (made.notes, None));
            };
            check_target(motion_of_mjcf(&path))?;
            let (scene, warning) = scene_of_trajectory(&scene.0, &motion.file, strict)?;
            let made = mjcf(&scene, Some(&Recorded::of(&motion.file)?), control)?;
            cdpr_files::save_mjcf(&path, &made).map(|()| (made.notes, warning))
        })
    })
}
