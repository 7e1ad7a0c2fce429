//! Python bindings: numbers in, numbers out. The Python package around them is the interface.

mod batch;
mod bound;
mod command;
mod convert;
mod drawing;
mod engines;
mod errors;
mod export;
mod files;
mod forked;
mod forward;
mod planning;
mod rewinding;
mod scene;
mod search;
mod timed;
mod trajectory;
mod turning;
mod workspace;
mod wrench;
mod wrench_map;

use cdpr_core::Error;
use cdpr_core::geometry::{Point, Polytope, distance};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use convert::points;
use errors::{abandonable, answered, interruptible};

/// Number of points up to which hulls take well below a millisecond, so that a thread is not worthwhile.
const FEW_POINTS: usize = 200;

/// Distance between the convex hulls of two vertex lists, with nearest points and overlap depth.
#[pyfunction]
fn polytope_distance(
    py: Python<'_>,
    a: PyReadonlyArray2<'_, f64>,
    b: PyReadonlyArray2<'_, f64>,
) -> PyResult<(f64, [f64; 3], [f64; 3], f64)> {
    let hull = |place: &str, points: &[Point]| {
        Polytope::hull_of(points).map_err(|problem| Error::invalid(place, problem.to_string()))
    };
    let (a, b) = (points(a.as_slice()?), points(b.as_slice()?));
    let few = a.len() + b.len() <= FEW_POINTS;
    let answer = move || Ok(distance(&hull("a", &a)?, &hull("b", &b)?));
    let found = if few { answered(answer) } else { abandonable(py, move |_| answer()) }?;
    Ok((found.distance, found.on_a.into(), found.on_b.into(), found.depth))
}

/// Fails like a bug, on this thread or on another, for tests.
#[pyfunction]
fn panic(py: Python<'_>, thread: &str) -> PyResult<()> {
    let bug = || -> Result<(), Error> { panic!("this is a test") };
    match thread {
        "other" => interruptible(py, |_| bug()),
        "abandonable" => abandonable(py, move |_| bug()),
        _ => answered(bug),
    }
}

#[pymodule(gil_used = false)]
mod _core {
    #[pymodule_export]
    use super::batch::Experiment;
    #[pymodule_export]
    use super::command::command;
    #[pymodule_export]
    use super::export::save_mjcf;
    #[pymodule_export]
    use super::files::{
        check_robot, check_target, example, import_robot, load_path, load_robot, remove_earlier_task,
        save_example_files, save_path, save_robot, save_text, schema,
    };
    #[pymodule_export]
    use super::forward::{lengths_from, other_poses, pose_from_lengths};
    #[pymodule_export]
    use super::planning::{not_planned, plan, plan_many, replan, task, tour};
    #[pymodule_export]
    use super::scene::Scene;
    #[pymodule_export]
    use super::timed::Trajectory;
    #[pymodule_export]
    use super::workspace::Workspace;
    #[pymodule_export]
    use super::wrench::Statics;
    #[pymodule_export]
    use super::wrench_map::Map;
    use super::*;
    #[pymodule_export]
    use super::{panic, polytope_distance};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        forked::loaded();
        module.add("GRAVITY", cdpr_core::model::GRAVITY)?;
        module.add("MAX_COORDINATE", cdpr_core::limits::MAX_COORDINATE)?;
        module.add("UNIT_QUATERNION", cdpr_core::tolerances::UNIT_QUATERNION)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
