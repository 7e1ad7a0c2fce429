//! Poses from cable lengths.

use cdpr_core::geometry::{Pose, Rotation, wxyz};
use cdpr_core::kinematics::{ForwardKinematics, PoseEstimate};
use cdpr_core::model::body::unit_quaternion;
use cdpr_core::model::{Joints, Robot, RobotSpec};
use cdpr_core::nalgebra::Matrix6;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Point};
use cdpr_files::text::Notation;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::convert::{named, triples};
use crate::errors::{answered, interruptible};

/// Positions, orientations, residuals, covariances, ranks and numbers of iterations, a row for each pose.
type Poses<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray3<f64>>,
    Bound<'py, PyArray1<i64>>,
    Bound<'py, PyArray1<i64>>,
);

/// The question: a robot as JSON text, rows of lengths, and the orientation if it is known.
struct Asked {
    robot: Robot,
    rows: Vec<Vec<f64>>,
    orientation: Option<Rotation>,
}

impl Asked {
    fn new(robot: &str, lengths: &PyReadonlyArray2<'_, f64>, orientation: Option<[f64; 4]>) -> PyResult<Self> {
        let columns = lengths.shape()[1].max(1);
        let rows = lengths.as_slice()?.chunks_exact(columns).map(<[f64]>::to_vec).collect();
        answered(|| {
            let robot = Robot::try_from(cdpr_files::text::parse::<RobotSpec>(robot, Notation::Json)?)?;
            let orientation = orientation.map(|q| unit_quaternion("orientation", q)).transpose()?;
            Ok(Asked { robot, rows, orientation })
        })
    }

    fn solver(&self) -> Result<ForwardKinematics<'_>, Error> {
        ForwardKinematics::new(&self.robot, self.orientation).map_err(|e| e.under("robot"))
    }
}

fn pose((position, orientation): ([f64; 3], [f64; 4])) -> Result<Pose, Error> {
    Ok(Pose::new(Point::from(position), unit_quaternion("guess", orientation)?))
}

/// Lengths of the cables, m, from rows of what the winches of a robot, JSON text, report, and the tensions, N; `many` tells
/// whether errors name the row.
#[pyfunction]
pub fn lengths_from<'py>(
    py: Python<'py>,
    robot: &str,
    joints: &str,
    values: PyReadonlyArray2<'py, f64>,
    tensions: Option<PyReadonlyArray2<'py, f64>>,
    many: bool,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let joints: Joints = named(joints)?;
    let Asked { robot, rows, .. } = Asked::new(robot, &values, None)?;
    let columns = robot.cables().len();
    let tensions = tensions.as_ref().map(|tensions| tensions.as_slice()).transpose()?;
    let row = |(k, values): (usize, &Vec<f64>)| {
        let tensions = tensions.map(|tensions| &tensions[columns * k..][..columns]);
        let in_row = |error: Error| if many { error.under(&format!("lengths[{k}]")) } else { error.under("lengths") };
        robot.lengths_from(joints, values, tensions).map_err(in_row)
    };
    let found = answered(|| rows.iter().enumerate().map(row).collect::<Result<Vec<_>, Error>>())?;
    PyArray1::from_vec(py, found.concat()).reshape([rows.len(), columns])
}

/// The poses with these lengths, each found from the one before, the first one from `guess`; `many` tells whether errors name the row.
#[pyfunction]
pub fn pose_from_lengths<'py>(
    py: Python<'py>,
    robot: &str,
    lengths: PyReadonlyArray2<'py, f64>,
    orientation: Option<[f64; 4]>,
    guess: Option<([f64; 3], [f64; 4])>,
    many: bool,
) -> PyResult<Poses<'py>> {
    let asked = Asked::new(robot, &lengths, orientation)?;
    let named = |e: Error, k: usize| match e.place() {
        Some(place) if place.starts_with("guess") => e,
        _ if many => e.under(&format!("lengths[{k}]")),
        _ => e.under("lengths"),
    };
    let found = interruptible(py, |interrupted| {
        let rows = asked.rows.iter().map(Vec::as_slice);
        asked.solver()?.follow(rows, guess.map(pose).transpose()?, named, &Watch::on(interrupted))
    })?;
    arrays(py, &found, asked.robot.cables().len())
}

/// Other poses with the same lengths as each of these.
#[pyfunction]
pub fn other_poses<'py>(
    py: Python<'py>,
    robot: &str,
    lengths: PyReadonlyArray2<'py, f64>,
    orientation: Option<[f64; 4]>,
    poses: Vec<([f64; 3], [f64; 4])>,
) -> PyResult<Vec<Poses<'py>>> {
    let asked = Asked::new(robot, &lengths, orientation)?;
    let found = interruptible(py, |interrupted| {
        let (solver, watch) = (asked.solver()?, Watch::on(interrupted));
        let of_row = |(lengths, at): (&Vec<f64>, &([f64; 3], [f64; 4]))| {
            watch.check()?;
            solver.others(lengths, &solver.estimate(lengths, Some(&pose(*at)?))?)
        };
        asked.rows.iter().zip(&poses).map(of_row).collect::<Result<Vec<_>, Error>>()
    })?;
    found.iter().map(|others| arrays(py, others, asked.robot.cables().len())).collect()
}

fn arrays<'py>(py: Python<'py>, found: &[PoseEstimate], cables: usize) -> PyResult<Poses<'py>> {
    let n = found.len();
    let table = |numbers: Vec<f64>, columns: usize| PyArray1::from_vec(py, numbers).reshape([n, columns]);
    let unknown = Matrix6::from_element(f64::NAN);
    // A symmetric matrix is the same by rows and by columns.
    let covariances: Vec<f64> = found.iter().flat_map(|e| e.covariance.unwrap_or(unknown).data.0.concat()).collect();
    let whole = |count: fn(&PoseEstimate) -> usize| {
        PyArray1::from_vec(py, found.iter().map(|estimate| count(estimate) as i64).collect())
    };
    Ok((
        triples(py, found.iter().flat_map(|e| <[f64; 3]>::from(e.pose.position)).collect())?,
        table(found.iter().flat_map(|e| wxyz(&e.pose.orientation)).collect(), 4)?,
        table(found.iter().flat_map(|e| e.residuals.iter().copied()).collect(), cables)?,
        PyArray1::from_vec(py, covariances).reshape([n, 6, 6])?,
        whole(|estimate| estimate.rank),
        whole(|estimate| estimate.iterations),
    ))
}
