//! A timed motion, as planned or as read from a file, and its states as arrays.

use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Pose, Vector, wxyz};
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::path::held;
use cdpr_core::plan::{PlanOptions, Planned};
use cdpr_core::trajectory::{self, Curve, Minimise, Motion, Timing, Winches, plan_timed};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::watch::{Watch, unless_interrupted};
use cdpr_core::wrench::TensionQp;
use cdpr_core::{Error, ErrorClass, Scene as CoreScene};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::convert::triples;

/// A timed motion: its file and, if the file has them, curve and timing for its state at any time.
#[pyclass(frozen, module = "cdpr._core")]
pub struct Trajectory {
    pub file: TrajectoryFile,
    /// The scene that the trajectory was made for, if known, and its cables, which are needed between samples.
    pub scene: Option<(CoreScene, Winches)>,
    pub exact: Option<(Curve, Timing)>,
    /// Whether the trajectory was planned here rather than read from a file, whose contents may be wrong.
    pub planned: bool,
}

/// Samples per second of a motion that planning returns.
const RATE: f64 = 100.0;

impl Trajectory {
    /// The fastest of the motions along a planned path and along others, whose path then replaces it with its options; `None`
    /// if time ran out, or the caller wanted to stop, before the first of them was known.
    pub fn fastest(
        planned: &mut Planned,
        ends: [Pose; 2],
        options: &mut PlanOptions,
        limits: &MotionSpec,
        watch: &Watch,
    ) -> Result<Option<Self>, Error> {
        let stop = || !matches!(watch.expired(), Ok(false));
        let (Some(compiled), first) = (&planned.compiled, planned.result.clone()) else { return Ok(None) };
        let found = plan_timed(compiled, ends, first, (options, Minimise::Time), limits, &Watch::on(&stop));
        let Some(found) = unless_interrupted(found)? else { return Ok(None) };
        // This takes some milliseconds, and is done even now that the caller may want to stop.
        let sampled = Self::sampled(compiled, &found.result.path, &found.trajectory, RATE, &Watch::NONE)?;
        (planned.result, *options) = (found.result, found.options);
        Ok(Some(sampled))
    }

    pub fn sampled(
        compiled: &CompiledScene,
        path: &[Pose],
        motion: &trajectory::Trajectory,
        rate: f64,
        watch: &Watch,
    ) -> Result<Self, Error> {
        Ok(Trajectory {
            file: TrajectoryFile::of(compiled, path, motion, rate, watch)?,
            scene: Some((compiled.scene().clone(), motion.winches().clone())),
            exact: Some((motion.curve().clone(), motion.timing().clone())),
            planned: true,
        })
    }

    pub fn from_file(file: TrajectoryFile, scene: Option<CoreScene>) -> Result<Self, Error> {
        let winches = scene.as_ref().map(|scene| winches(scene, &file)).transpose()?;
        let exact = (file.curve.is_some() && file.timing.is_some()).then(|| file.exact()).transpose()?;
        Ok(Trajectory { file, scene: scene.zip(winches), exact, planned: false })
    }

    /// If no tensions allow the motion, that is a bug for one planned here, and otherwise a fault of the file.
    pub fn blamed(&self, error: Error) -> Error {
        match error.class() {
            ErrorClass::Internal if !self.planned => {
                Error::invalid("timing", "found a motion for which no tensions are within the limits")
            }
            _ => error,
        }
    }

    pub fn winches(&self) -> Option<&Winches> {
        self.scene.as_ref().map(|(_, winches)| winches)
    }
}

/// The cables of the robot of a trajectory.
fn winches(scene: &CoreScene, file: &TrajectoryFile) -> Result<Winches, Error> {
    match file.orientations.is_some() {
        true => Winches::of(scene, &file.limits, &file.poses()),
        false => Winches::of(scene, &file.limits, &held(scene, &[file.waypoints[0].into()])),
    }
}

type Rows<'py> = Bound<'py, PyArray2<f64>>;
type Maybe<'py> = Option<Rows<'py>>;
/// Positions, velocities, accelerations; orientations, angular velocities and accelerations; lengths, speeds and accelerations
/// of the cables, and tensions.
pub type States<'py> = ([Rows<'py>; 3], [Rows<'py>; 3], (Maybe<'py>, Maybe<'py>, Maybe<'py>, Maybe<'py>));

/// States at some times, each quantity row by row.
pub struct Columns {
    pub platform: [Vec<f64>; 3],
    pub orientations: Vec<f64>,
    pub turning: [Vec<f64>; 2],
    pub cables: [Option<Vec<f64>>; 3],
    pub tensions: Option<Vec<f64>>,
}

impl Columns {
    pub fn at(
        (curve, timing): &(Curve, Timing),
        winches: Option<&Winches>,
        times: &[f64],
        watch: &Watch,
    ) -> Result<Self, Error> {
        let limited = winches.filter(|winches| winches.tension_limits().is_some());
        let mut columns = Columns {
            platform: Default::default(),
            orientations: Vec::new(),
            turning: Default::default(),
            cables: [(); 3].map(|()| winches.map(|_| Vec::new())),
            tensions: limited.map(|_| Vec::new()),
        };
        let mut solver = TensionQp::default();
        for &time in times {
            watch.check()?;
            let now = Motion::at(curve, timing, time);
            let straight = [now.position.coords, now.velocity, now.acceleration];
            let turning = [now.angular_velocity, now.angular_acceleration];
            let platform = columns.platform.iter_mut().zip(straight);
            for (column, row) in platform.chain(columns.turning.iter_mut().zip(turning)) {
                column.extend(Vector::iter(&row));
            }
            columns.orientations.extend(wxyz(&now.orientation));
            if let (Some(winches), [Some(lengths), Some(speeds), Some(rates)]) = (winches, &mut columns.cables) {
                for winding in winches.windings(&now) {
                    lengths.push(winding.length);
                    speeds.push(winding.speed);
                    rates.push(winding.acceleration);
                }
            }
            if let (Some(winches), Some(rows)) = (limited, &mut columns.tensions) {
                rows.extend(winches.tensions(&mut solver, &now)?.unwrap_or_default());
            }
        }
        Ok(columns)
    }

    /// The arrays for these numbers of times and cables.
    pub fn arrays(self, py: Python<'_>, count: usize, cables: usize) -> PyResult<States<'_>> {
        let matrix = |numbers: Vec<f64>| PyArray1::from_vec(py, numbers).reshape([count, cables]);
        let [positions, velocities, accelerations] = self.platform;
        let [turns, gains] = self.turning;
        let [lengths, speeds, rates] = self.cables;
        Ok((
            [triples(py, positions)?, triples(py, velocities)?, triples(py, accelerations)?],
            [PyArray1::from_vec(py, self.orientations).reshape([count, 4])?, triples(py, turns)?, triples(py, gains)?],
            (
                lengths.map(matrix).transpose()?,
                speeds.map(matrix).transpose()?,
                rates.map(matrix).transpose()?,
                self.tensions.map(matrix).transpose()?,
            ),
        ))
    }
}
