//! Wrenches of a robot on arrays of positions.

use cdpr_core::batch::{BatchOptions, Pace, answer_all};
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::model::{self, Robot, RobotSpec};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{
    self, AvailableSet, BindingFacet, CapacityMargin, Loads, Required, TensionQp, force_limit, moment_limit,
};
use cdpr_core::{Error, kinematics};
use cdpr_files::text::Notation;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::convert::{answer_array, named, point, points, row, triples};
use crate::errors::{answered, interruptible, raised};

/// A robot with the loads that its cables must balance.
#[pyclass(frozen, module = "cdpr._core")]
pub struct Statics {
    robot: Robot,
    loads: Loads,
}

impl Statics {
    fn core(&self) -> PyResult<wrench::Statics> {
        answered(|| wrench::Statics::new(&self.robot, &self.loads))
    }
}

#[pymethods]
impl Statics {
    /// The statics of a robot from JSON text, with its orientation, gravity and load.
    #[new]
    fn new(
        robot: &str,
        orientation: Option<[f64; 4]>,
        gravity: Option<[f64; 3]>,
        load: Option<[f64; 6]>,
        characteristic_length: f64,
    ) -> PyResult<Self> {
        let robot = answered(|| Robot::try_from(cdpr_files::text::parse::<RobotSpec>(robot, Notation::Json)?))?;
        let default = Loads::default();
        let turned = |q| answered(|| model::body::unit_quaternion("orientation", q));
        let loads = Loads {
            orientation: orientation.map(turned).transpose()?.unwrap_or(default.orientation),
            gravity: gravity.map_or(default.gravity, Vector::from),
            load: load.map_or(default.load, Into::into),
            characteristic_length,
            ..default
        };
        Ok(Statics { robot, loads })
    }

    /// Wrench matrices, (n, 6, m).
    fn wrench_matrix<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let positions = points(positions.as_slice()?);
        let mut numbers = Vec::with_capacity(positions.len() * 6 * self.robot.cables().len());
        answered(|| {
            for (k, position) in positions.iter().enumerate() {
                let matrix = kinematics::wrench_matrix(&self.robot, &self.loads.orientation, position);
                let matrix = matrix.map_err(|e| e.under(&format!("positions[{k}]")))?;
                numbers.extend(matrix.transpose().iter()); // columns of the transpose are rows
            }
            Ok(())
        })?;
        PyArray1::from_vec(py, numbers).reshape([positions.len(), 6, self.robot.cables().len()])
    }

    /// Cable lengths, (n, m), m.
    fn cable_lengths<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (rows, cables) = (positions.as_slice()?, self.robot.cables().len());
        let lengths = |k| kinematics::cable_lengths(&self.robot, &self.loads.orientation, &row(rows, k));
        let numbers: Vec<f64> = (0..rows.len() / 3).flat_map(lengths).collect();
        PyArray1::from_vec(py, numbers).reshape([rows.len() / 3, cables])
    }

    /// Capacity margins, N; NaN where a cable has no direction.
    fn capacity_margin<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        force: f64,
        moment: f64,
        vertices: Option<Vec<[f64; 6]>>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let required = match vertices {
            Some(corners) => Required::Polytope(corners.into_iter().map(Into::into).collect()),
            None => answered(|| Required::balls(force, moment))?,
        };
        let statics = self.core()?;
        let margin = answered(|| CapacityMargin::new(statics, required))?;
        let rows = positions.as_slice()?;
        let n = rows.len() / 3;
        let mut fours = vec![[0.0; 4]; n.div_ceil(4)];
        let at = |k: usize| row(rows, k.min(n - 1));
        let question = |k: usize| margin.at_four(&std::array::from_fn(|lane| at(4 * k + lane)));
        interruptible(py, |interrupted| {
            answer_all(&mut fours, question, Pace::WRENCHES, &BatchOptions { threads, watch: Watch::on(interrupted) })
        })?;
        let mut margins = fours.into_flattened();
        margins.truncate(n);
        Ok(PyArray1::from_vec(py, margins))
    }

    /// Force margins, N.
    fn force_margin<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        self.projected(py, &positions, threads, force_limit)
    }

    /// Moment margins, N·m; NaN for a point mass.
    fn moment_margin<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        self.projected(py, &positions, threads, moment_limit)
    }

    /// Tensions of the given choice, of that of the robot, or nearest to a reference, (n, m), N; rows of NaN where the loads cannot be balanced.
    fn tensions<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        reference: Option<Vec<f64>>,
        chosen: Option<&str>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let chosen = chosen.map(named).transpose()?;
        let (statics, cables) = (self.core()?, self.robot.cables().len());
        let statics = chosen.map_or_else(|| statics.clone(), |chosen| statics.with_tensions(chosen));
        let rows = positions.as_slice()?;
        let mut answers: Vec<Result<Option<Vec<f64>>, Error>> = (0..rows.len() / 3).map(|_| Ok(None)).collect();
        let question = |k: usize| statics.tensions(&mut TensionQp::default(), &row(rows, k), reference.as_deref());
        interruptible(py, |interrupted| {
            answer_all(&mut answers, question, Pace::WRENCHES, &BatchOptions { threads, watch: Watch::on(interrupted) })
        })?;
        let mut numbers = Vec::with_capacity(answers.len() * cables);
        let n = answers.len();
        for answer in answers {
            match answer.map_err(raised)? {
                Some(tensions) => numbers.extend(tensions),
                None => numbers.extend(std::iter::repeat_n(f64::NAN, cables)),
            }
        }
        PyArray1::from_vec(py, numbers).reshape([n, cables])
    }

    /// The set of forces available at a position: rank, balance, margin, and its surface.
    fn force_set<'py>(&self, py: Python<'py>, position: [f64; 3]) -> PyResult<Set<'py>> {
        let statics = self.core()?;
        surface(py, answered(|| wrench::force_set(&statics, &point(position)))?)
    }

    /// The set of moments available at a position.
    fn moment_set<'py>(&self, py: Python<'py>, position: [f64; 3]) -> PyResult<Set<'py>> {
        let statics = self.core()?;
        surface(py, answered(|| wrench::moment_set(&statics, &point(position)))?)
    }
}

type Set<'py> = (usize, [f64; 3], f64, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<i64>>);

fn surface(py: Python<'_>, set: AvailableSet) -> PyResult<Set<'_>> {
    let AvailableSet { rank, mesh, balance, margin } = set;
    let vertices = triples(py, mesh.vertices.iter().flat_map(|v| [v.x, v.y, v.z]).collect())?;
    let triangles = triples(py, mesh.triangles.iter().flatten().map(|i| *i as i64).collect())?;
    Ok((rank, balance.into(), margin, vertices, triangles))
}

impl Statics {
    fn projected<'py>(
        &self,
        py: Python<'py>,
        positions: &PyReadonlyArray2<'py, f64>,
        threads: Option<usize>,
        limit: impl Fn(&wrench::Statics, &Point) -> Option<BindingFacet<3>> + Sync,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let statics = self.core()?;
        let rows = positions.as_slice()?;
        let question = |k: usize| limit(&statics, &row(rows, k)).map_or(f64::NAN, |limit| limit.margin);
        answer_array(py, rows.len() / 3, threads, |margins, options| {
            answer_all(margins, question, Pace::WRENCHES, options)
        })
    }
}
