//! A timed motion, as planned or as read from a file, and its states as arrays.

use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Pose, Vector, wxyz};
use cdpr_core::model::Commands;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::path::held;
use cdpr_core::plan::{PlanOptions, Planned};
use cdpr_core::trajectory::{self, Curve, Minimise, Motion, Timing, Winches, Winding, plan_timed};
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
        let sampled = Self::sampled(compiled, &found.result.path, &found.trajectory, None, &Watch::NONE)?;
        (planned.result, *options) = (found.result, found.options);
        Ok(Some(sampled))
    }

    pub fn sampled(
        compiled: &CompiledScene,
        path: &[Pose],
        motion: &trajectory::Trajectory,
        rate: Option<f64>,
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
        // Between the samples, tensions are those that the samples hold.
        let scene = match file.tension_distribution {
            Some(chosen) => scene.map(|scene| scene.with_tensions(chosen)),
            None => scene,
        };
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
/// Positions, velocities, accelerations; orientations, angular velocities and accelerations; [columns of cables](Columns::cables).
pub type States<'py> = ([Rows<'py>; 3], [Rows<'py>; 3], [Maybe<'py>; 7]);

/// States at some times, each quantity row by row.
pub struct Columns {
    pub platform: [Vec<f64>; 3],
    pub orientations: Vec<f64>,
    pub turning: [Vec<f64>; 2],
    /// Lengths, speeds, accelerations and tensions of the cables, commanded lengths, angles and torques of the winches, if known.
    pub cables: [Option<Vec<f64>>; 7],
}

impl Columns {
    pub fn at(
        (curve, timing): &(Curve, Timing),
        known: Option<&(CoreScene, Winches)>,
        times: &[f64],
        watch: &Watch,
    ) -> Result<Self, Error> {
        let mut columns = Columns {
            platform: Default::default(),
            orientations: Vec::new(),
            turning: Default::default(),
            cables: known.map_or_else(Default::default, empty_columns),
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
            let Some((scene, winches)) = known else { continue };
            let row = cable_row(scene, winches.windings(&now), winches.tensions(&mut solver, &now)?);
            for (column, values) in columns.cables.iter_mut().zip(row) {
                column.iter_mut().for_each(|column| column.extend(values.iter().flatten()));
            }
        }
        Ok(columns)
    }

    /// The arrays for these numbers of times and cables.
    pub fn arrays(self, py: Python<'_>, count: usize, cables: usize) -> PyResult<States<'_>> {
        let matrix = |numbers: Vec<f64>| PyArray1::from_vec(py, numbers).reshape([count, cables]);
        let [positions, velocities, accelerations] = self.platform;
        let [turns, gains] = self.turning;
        let mut matrices = [const { None }; 7];
        for (matrix_, numbers) in matrices.iter_mut().zip(self.cables) {
            *matrix_ = numbers.map(matrix).transpose()?;
        }
        Ok((
            [triples(py, positions)?, triples(py, velocities)?, triples(py, accelerations)?],
            [PyArray1::from_vec(py, self.orientations).reshape([count, 4])?, triples(py, turns)?, triples(py, gains)?],
            matrices,
        ))
    }
}

/// The columns of cables at an instant.
fn cable_row(
    scene: &CoreScene,
    windings: impl Iterator<Item = Winding>,
    tensions: Option<Vec<f64>>,
) -> [Option<Vec<f64>>; 7] {
    let windings: Vec<Winding> = windings.collect();
    let of = |value: fn(&Winding) -> f64| windings.iter().map(value).collect::<Vec<f64>>();
    let lengths = of(|winding| winding.length);
    let Commands { commands, angles, torques } = scene.robot().commands(&lengths, tensions.as_deref());
    let rates = [of(|winding| winding.speed), of(|winding| winding.acceleration)].map(Some);
    let [speeds, accelerations] = rates;
    [Some(lengths), speeds, accelerations, tensions, commands, angles, torques]
}

/// The columns that are known, without values.
fn empty_columns((scene, winches): &(CoreScene, Winches)) -> [Option<Vec<f64>>; 7] {
    let any = Winding { length: 0.0, speed: 0.0, acceleration: 0.0 };
    let tensions = winches.tension_limits().map(|limits| vec![0.0; limits.len()]);
    let row = cable_row(scene, std::iter::repeat_n(any, scene.robot().cables().len()), tensions);
    row.map(|values| values.map(|_| Vec::new()))
}
