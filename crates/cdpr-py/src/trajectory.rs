//! The class `Trajectory`: a timed motion, its samples and its state at any time.

use std::path::{Path, PathBuf};

use cdpr_core::geometry::{Point, Vector};
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::trajectory::{self, Curve, Limits, Motion, Timing, Winches};
use cdpr_core::trajectory_file::{TrajectoryFile, TrajectoryLimits};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::TensionQp;
use cdpr_core::{Error, Scene as CoreScene};
use cdpr_files::{Loader, text, text::Notation};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use serde_json::json;

use crate::convert::{points, serialized, triples};
use crate::errors::{abandonable, answered, interruptible};
use crate::scene::Scene;

/// Number of instants up to which a thread is not worthwhile.
const FEW_INSTANTS: usize = 20;

/// A timed motion: its file and, if the file has them, curve and timing for its state at any time.
#[pyclass(frozen, module = "cdpr._core")]
pub struct Trajectory {
    file: TrajectoryFile,
    /// The scene that it was made for, if known, and its cables, which are needed between samples.
    scene: Option<(CoreScene, Winches)>,
    exact: Option<(Curve, Timing)>,
}

#[pymethods]
impl Trajectory {
    /// The fastest motion along a path; `limits` is JSON as in the table `[motion]` of a scene.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        scene: &Scene,
        waypoints: PyReadonlyArray2<'_, f64>,
        limits: &str,
        rate: f64,
    ) -> PyResult<Self> {
        let scene = &scene.0;
        let limits: MotionSpec = answered(|| text::parse(limits, Notation::Json))?;
        let waypoints = points(waypoints.as_slice()?);
        interruptible(py, |stop| {
            let watch = Watch::on(stop);
            let motion = trajectory::Trajectory::new(scene, &waypoints, &limits, &watch)?;
            let file = TrajectoryFile::of(scene, &waypoints, &motion, rate, &watch)?;
            let exact = (motion.curve().clone(), motion.timing().clone());
            Ok(Trajectory { file, scene: Some((scene.clone(), motion.winches().clone())), exact: Some(exact) })
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
        abandonable(py, move || {
            let file = load(&path)?;
            let turned = scene.map(|scene| cdpr_files::scene_of_trajectory(&scene, &file, strict)).transpose();
            let (turned, warning) = turned.map_err(|error| error.in_file(&path))?.unzip();
            let warning = warning.flatten();
            let scene = turned.filter(|_| warning.is_none());
            Ok((Trajectory::from_file(file, scene).map_err(|error| error.in_file(&path))?, warning))
        })
    }

    /// What [`Trajectory::to_json`] returned.
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

    /// Writes a file in the format given by the extension.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        py.detach(|| answered(|| save(&path, &self.file)))
    }

    /// Everything but samples, curve and timing, as JSON; `note` says why tensions are not limited.
    fn facts(&self) -> String {
        let file = &self.file;
        let unknown = file.tensions.is_none().then_some("tensions are not limited");
        let note = self.winches().map_or(unknown, Winches::note);
        let facts = json!({
            "duration": file.duration,
            "length": file.length,
            "rate": file.rate,
            "orientation": file.orientation,
            "orientation_name": file.orientation_name,
            "limits": file.limits,
            "tension_limits": file.tension_limits,
            "waypoints": file.waypoints,
            "corners": file.corners,
            "limiting": file.limiting,
            "cables": file.cables,
            "note": note,
        });
        facts.to_string()
    }

    /// The times of the samples, and the states then, as [`Trajectory::at`] returns them.
    fn samples<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyArray1<f64>>, States<'py>)> {
        let file = &self.file;
        let of_cables = |rows: &Vec<Vec<f64>>| rows.concat();
        let columns = Columns {
            platform: [&file.positions, &file.velocities, &file.accelerations].map(|rows| rows.as_flattened().to_vec()),
            cables: Some([of_cables(&file.cable_lengths), of_cables(&file.cable_speeds)]),
            tensions: file.tensions.as_ref().map(of_cables),
        };
        Ok((PyArray1::from_slice(py, &file.times), columns.arrays(py, file.times.len(), file.cables.len())?))
    }

    /// The states at some times: positions, velocities and accelerations, (n, 3); lengths and speeds of the cables, (n, m),
    /// if the scene is known; tensions, (n, m), if they are limited and the scene is known.
    fn at<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'_, f64>) -> PyResult<States<'py>> {
        let missing =
            || Error::invalid("curve", "found none in the file, expected the exact form that planning writes");
        let exact = answered(|| self.exact.as_ref().ok_or_else(missing))?;
        let times = times.as_slice()?;
        let columns = if times.len() <= FEW_INSTANTS {
            answered(|| Columns::at(exact, self.winches(), times, &Watch::NONE))
        } else {
            interruptible(py, |stop| Columns::at(exact, self.winches(), times, &Watch::on(stop)))
        }?;
        columns.arrays(py, times.len(), self.file.cables.len())
    }
}

impl Trajectory {
    fn from_file(file: TrajectoryFile, scene: Option<CoreScene>) -> Result<Self, Error> {
        let winches = scene.as_ref().map(|scene| winches(scene, &file)).transpose()?;
        let exact = (file.curve.is_some() && file.timing.is_some()).then(|| file.exact()).transpose()?;
        Ok(Trajectory { file, scene: scene.zip(winches), exact })
    }

    fn winches(&self) -> Option<&Winches> {
        self.scene.as_ref().map(|(_, winches)| winches)
    }
}

/// The cables of the robot of a trajectory.
fn winches(scene: &CoreScene, file: &TrajectoryFile) -> Result<Winches, Error> {
    let TrajectoryLimits { speed, acceleration, jerk, cable_speed, cable_acceleration, blend, wrench_margin } =
        file.limits;
    let wrench_margin = wrench_margin.unwrap_or(0.0);
    let limits = Limits { speed, acceleration, jerk, cable_speed, cable_acceleration, blend, wrench_margin };
    Winches::of(scene, &limits, &Point::from(file.waypoints[0]))
}

/// Writes a trajectory in the format given by the extension.
// To be replaced by `cdpr_files::save_trajectory`, which also writes CSV and YAML.
fn save(path: &Path, file: &TrajectoryFile) -> Result<(), Error> {
    match text::extension(path).as_deref() {
        Some("json") => cdpr_files::write_atomically(path, serialized(file).as_bytes()),
        _ => Err(text::other_extension(path, ".json")),
    }
}

/// Reads a trajectory file.
// To be replaced by `cdpr_files::load_trajectory`.
fn load(path: &Path) -> Result<TrajectoryFile, Error> {
    if text::extension(path).as_deref() != Some("json") {
        return Err(text::other_extension(path, ".json"));
    }
    let found = cdpr_files::read_trajectory(path)?;
    let other = || Error::invalid("format", "found another one, expected a trajectory").in_file(path);
    cdpr_files::trajectory_from_text(&found.ok_or_else(other)?).map_err(|error| error.in_file(path))
}

type Rows<'py> = Bound<'py, PyArray2<f64>>;
type States<'py> = (Rows<'py>, Rows<'py>, Rows<'py>, Option<Rows<'py>>, Option<Rows<'py>>, Option<Rows<'py>>);

/// States at some times, each quantity row by row.
struct Columns {
    platform: [Vec<f64>; 3],
    cables: Option<[Vec<f64>; 2]>,
    tensions: Option<Vec<f64>>,
}

impl Columns {
    fn at(
        (curve, timing): &(Curve, Timing),
        winches: Option<&Winches>,
        times: &[f64],
        watch: &Watch,
    ) -> Result<Self, Error> {
        let limited = winches.filter(|winches| winches.tension_limits().is_some());
        let mut columns = Columns {
            platform: Default::default(),
            cables: winches.map(|_| Default::default()),
            tensions: limited.map(|_| Vec::new()),
        };
        let mut solver = TensionQp::default();
        for &time in times {
            watch.check()?;
            let phase = timing.at(time);
            let Motion { position, velocity, acceleration, .. } = Motion::on(curve, curve.piece_at(phase.s), &phase);
            for (column, row) in columns.platform.iter_mut().zip([position.coords, velocity, acceleration]) {
                column.extend(Vector::iter(&row));
            }
            if let (Some(winches), Some([lengths, speeds])) = (winches, &mut columns.cables) {
                for winding in winches.windings(&position, &velocity, &acceleration) {
                    lengths.push(winding.length);
                    speeds.push(winding.speed);
                }
            }
            if let (Some(winches), Some(rows)) = (limited, &mut columns.tensions) {
                rows.extend(winches.tensions(&mut solver, &position, &acceleration)?.unwrap_or_default());
            }
        }
        Ok(columns)
    }

    /// The arrays for these numbers of times and cables.
    fn arrays(self, py: Python<'_>, count: usize, cables: usize) -> PyResult<States<'_>> {
        let matrix = |numbers: Vec<f64>| PyArray1::from_vec(py, numbers).reshape([count, cables]);
        let [positions, velocities, accelerations] = self.platform;
        let [lengths, speeds] = self.cables.map_or([None, None], |columns| columns.map(Some));
        Ok((
            triples(py, positions)?,
            triples(py, velocities)?,
            triples(py, accelerations)?,
            lengths.map(matrix).transpose()?,
            speeds.map(matrix).transpose()?,
            self.tensions.map(matrix).transpose()?,
        ))
    }
}
