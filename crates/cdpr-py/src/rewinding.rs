//! Rewinding step by step, for figures.

use cdpr_core::collision::Checker;
use cdpr_core::geometry::Point;
use cdpr_core::plan::trace_rewinding;
use cdpr_core::postprocess::RewindOptions;
use cdpr_core::watch::Watch;
use numpy::PyArray2;
use pyo3::prelude::*;

use crate::convert::{named, points, triples};
use crate::errors::interruptible;

/// The path after rewinding, and every motion checked: starts, ends, results.
pub type Tries<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Vec<bool>);

/// A path rewound with a step, m, and an order, with everything that was tried.
pub fn tries<'py>(
    py: Python<'py>,
    engine: &dyn Checker,
    waypoints: &[f64],
    (step, order): (f64, &str),
) -> PyResult<Tries<'py>> {
    let waypoints = points(waypoints);
    let options = RewindOptions { step, order: named(order)?, repeats: 1 };
    let trace = interruptible(py, |stop| trace_rewinding(engine, &waypoints, &options, &Watch::on(stop)))?;
    let rows = |list: &mut dyn Iterator<Item = Point>| triples(py, list.flat_map(|p| [p.x, p.y, p.z]).collect());
    Ok((
        rows(&mut trace.path.iter().copied())?,
        rows(&mut trace.tries.iter().map(|t| t.from))?,
        rows(&mut trace.tries.iter().map(|t| t.to))?,
        trace.tries.iter().map(|t| t.valid).collect(),
    ))
}
