//! The class `Trajectory`: a timed motion, its samples and its state at any time.

use std::path::{Path, PathBuf};

use cdpr_core::collision::Engine;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::model::Distribution;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::trajectory::{self, Winches};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene as CoreScene};
use cdpr_files::{LoadedTrajectory, Loader, MessageFields, scene_of_trajectory, text, text::Notation};
use cdpr_view::trajectory_page_within;
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use serde_json::json;

use crate::convert::{named, serialized};
use crate::errors::{abandonable, answered, interruptible};
use crate::scene::Scene;
use crate::timed::{Columns, States, Trajectory};
use crate::turning::PoseRows;

/// Number of instants up to which a thread is not worthwhile.
const FEW_INSTANTS: usize = 20;

type Rows<'py> = PyReadonlyArray2<'py, f64>;

#[pymethods]
impl Trajectory {
    /// The fastest motion along a path, with quaternions whose length has been checked if the platform turns; `limits` is JSON
    /// as in the table `[motion]` of a scene; `kept`, the clearance from obstacles that the motion keeps, m.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        scene: Py<Scene>,
        path: (Rows<'_>, Option<Rows<'_>>),
        limits: &str,
        rate: Option<f64>,
        chosen: Option<&str>,
        kept: Option<f64>,
    ) -> PyResult<Self> {
        let chosen = chosen.map(named::<Distribution>).transpose()?;
        let limits: MotionSpec = answered(|| text::parse(limits, Notation::Json))?;
        let (waypoints, quaternions) = path;
        let turns = quaternions.as_ref().map(|quaternions| quaternions.as_slice()).transpose()?;
        let path = PoseRows::of(&scene.get().0, waypoints.as_slice()?, turns).poses();
        abandonable(py, move |stop| {
            let watch = Watch::on(stop);
            let own;
            let shared = scene.get().compiled_within(&watch)?;
            let compiled = match chosen {
                None => &*shared,
                Some(chosen) => {
                    own = shared.with_tensions(chosen);
                    &own
                }
            };
            let motion = trajectory::Trajectory::keeping(compiled, kept, &path, &limits, &watch)?;
            Trajectory::sampled(compiled, &path, &motion, rate, &watch)
        })
    }

    /// Loads a file, and a warning if it was made for another scene; with `strict`, an error instead.
    #[staticmethod]
    fn load(
        py: Python<'_>,
        path: PathBuf,
        scene: Option<&Scene>,
        strict: bool,
    ) -> PyResult<(Trajectory, Option<String>)> {
        let scene = scene.map(|scene| scene.0.clone());
        abandonable(py, move |_| {
            let (file, turned, warning) = load(&path, scene.as_ref(), strict).map_err(|error| error.in_file(&path))?;
            let scene = turned.filter(|_| warning.is_none());
            Ok((Trajectory::from_file(file, scene).map_err(|error| error.in_file(&path))?, warning))
        })
    }

    /// A trajectory from the result of [`Trajectory::to_json`].
    #[staticmethod]
    fn from_json(py: Python<'_>, file: &str, scene: Option<&str>) -> PyResult<Self> {
        interruptible(py, |stop| {
            let file = cdpr_files::trajectory_from_text(file)?;
            let scene = scene.map(|text| Loader::new(Watch::on(stop)).scene_from_text(text, Notation::Json, None));
            Trajectory::from_file(file, scene.transpose()?)
        })
    }

    /// The file and the scene, if known, as JSON.
    fn to_json(&self, py: Python<'_>) -> (String, Option<String>) {
        py.detach(|| (serialized(&self.file), self.scene.as_ref().map(|(scene, _)| serialized(scene.spec()))))
    }

    /// The object itself, which never changes.
    fn __deepcopy__<'py>(slf: &Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf.clone()
    }

    /// Writes a file in the format given by the extension.
    fn save(&self, py: Python<'_>, path: PathBuf, joints: Option<&str>, effort: bool) -> PyResult<()> {
        let fields = MessageFields { joints: joints.map(named).transpose()?, effort };
        py.detach(|| answered(|| cdpr_files::save_trajectory(&path, &self.file, fields)))
    }

    /// A self-contained page that plays the motion in a scene, and a warning if it was made for another scene; with `strict`,
    /// an error instead.
    fn page(
        &self,
        py: Python<'_>,
        scene: &Scene,
        interference: &str,
        strict: bool,
    ) -> PyResult<(String, Option<String>)> {
        let interference = named(interference)?;
        interruptible(py, |stop| {
            let watch = Watch::on(stop);
            let (scene, warning) = scene_of_trajectory(&scene.0, &self.file, strict)?;
            let moving = self.file.limits.moving_again(&scene)?.into_owned();
            let compiled = CompiledScene::new(&moving, Engine::default(), interference, &watch)?;
            let violations = self.file.violations(&compiled, &watch)?;
            Ok((trajectory_page_within(&scene, &self.file, &violations, &watch)?, warning))
        })
    }

    /// Everything but samples, curve and timing, as JSON; `note` says why tensions are not limited.
    fn facts(&self) -> String {
        let file = &self.file;
        let unknown = file.tensions.is_none().then_some("tensions are not limited");
        let winches = self.winches();
        let assumption = winches.and_then(Winches::assumption).filter(|_| file.orientations.is_some());
        let note = winches.map_or(unknown, |winches| winches.note().or(assumption));
        let speeds = self.exact.as_ref().and_then(|_| file.limits.note());
        let notes: Vec<&str> = note.into_iter().chain(speeds).collect();
        let note = (!notes.is_empty()).then(|| notes.join("; "));
        let facts = json!({
            "duration": file.duration,
            "length": file.length,
            "rate": file.rate,
            "orientation": file.orientation,
            "orientation_name": file.orientation_name,
            "limits": file.limits,
            "tension_limits": file.tension_limits,
            "tension_distribution": file.tension_distribution,
            "waypoints": file.waypoints,
            "waypoint_orientations": file.waypoint_orientations,
            "corners": file.corners,
            "limiting": file.limiting,
            "largest": file.largest,
            "nearest": file.nearest,
            "cables": file.cables,
            "note": note,
        });
        facts.to_string()
    }

    /// Whether the samples have orientations of their own.
    fn turns(&self) -> bool {
        self.file.orientations.is_some()
    }

    /// The times of the samples, and the states then, as [`Trajectory::at`] returns them.
    fn samples<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyArray1<f64>>, States<'py>)> {
        let file = &self.file;
        let of_cables = |rows: &Vec<Vec<f64>>| rows.concat();
        let columns = py.detach(|| Columns {
            platform: [&file.positions, &file.velocities, &file.accelerations].map(|rows| rows.as_flattened().to_vec()),
            orientations: match &file.orientations {
                Some(orientations) => orientations.as_flattened().to_vec(),
                None => file.orientation.repeat(file.times.len()),
            },
            turning: [&file.angular_velocities, &file.angular_accelerations].map(|rows| match rows {
                Some(rows) => rows.as_flattened().to_vec(),
                None => vec![0.0; 3 * file.times.len()],
            }),
            cables: file.by_cable().map(|rows| rows.map(of_cables)),
        });
        Ok((PyArray1::from_slice(py, &file.times), columns.arrays(py, file.times.len(), file.cables.len())?))
    }

    /// The states at some times: positions, velocities and accelerations, (n, 3); if the scene is known, also the columns of the
    /// cables, (n, m).
    fn at<'py>(slf: Bound<'py, Self>, times: PyReadonlyArray1<'_, f64>) -> PyResult<States<'py>> {
        let (py, trajectory) = (slf.py(), slf.unbind());
        let times = times.as_slice()?;
        let (count, cables) = (times.len(), trajectory.get().file.cables.len());
        let columns = match times.len() <= FEW_INSTANTS {
            true => answered(|| trajectory.get().columns_at(times, &Watch::NONE)),
            false => {
                let times = times.to_vec();
                abandonable(py, move |stop| trajectory.get().columns_at(&times, &Watch::on(stop)))
            }
        }?;
        columns.arrays(py, count, cables)
    }
}

impl Trajectory {
    fn columns_at(&self, times: &[f64], watch: &Watch) -> Result<Columns, Error> {
        let missing =
            || Error::invalid("curve", "found none in the file, expected the exact form that planning writes");
        let exact = self.exact.as_ref().ok_or_else(missing)?;
        Columns::at(exact, self.scene.as_ref(), times, watch).map_err(|error| self.blamed(error))
    }
}

/// Loads a file, the scene at its orientation, and a warning if it was made for another scene.
fn load(
    path: &Path,
    scene: Option<&CoreScene>,
    strict: bool,
) -> Result<(TrajectoryFile, Option<CoreScene>, Option<String>), Error> {
    let loaded = cdpr_files::load_trajectory(path)?;
    let Some(scene) = scene else { return Ok((loaded.whole(None)?, None, None)) };
    let (turned, motion, warning) = cdpr_files::scene_of_loaded(scene, &loaded, strict)?;
    let file = LoadedTrajectory { motion, ..loaded }.whole(Some(&turned))?;
    Ok((file, Some(turned), warning))
}
