//! Paths given by the user, shortened.

use cdpr_core::Scene;
use cdpr_core::collision::Checker;
use cdpr_core::geometry::Point;
use cdpr_core::plan::{Post, shorten_path, shorten_poses, trace_rewinding};
use cdpr_core::postprocess::RewindOptions;
use cdpr_core::turning::TurningEngine;
use cdpr_core::watch::Watch;
use cdpr_files::PathFile;
use numpy::PyArray2;
use pyo3::prelude::*;

use crate::convert::{named, points, serialized_as_in_files, triples};
use crate::errors::{answered, interruptible};
use crate::turning::PoseRows;

/// The path after rewinding, and every motion checked: starts, ends, results.
pub type Tries<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Vec<bool>);

/// A path without turns after post-processing with a step, m, and a number of repeats, as JSON.
pub fn shortened(
    py: Python<'_>,
    scene: &Scene,
    engine: &dyn Checker,
    waypoints: &[f64],
    (post, step, repeats): (&str, f64, usize),
) -> PyResult<String> {
    let waypoints = points(waypoints);
    let post: Post = named(post)?;
    let processing = answered(|| post.processing(step, repeats))?;
    let shorter = interruptible(py, |stop| shorten_path(engine, &waypoints, &processing, &Watch::on(stop)))?;
    answered(|| Ok(serialized_as_in_files(&PathFile::of(scene, &shorter))))
}

/// A path of poses, shortened, as JSON.
pub fn shortened_poses(py: Python<'_>, scene: &Scene, engine: &TurningEngine, rows: PoseRows) -> PyResult<String> {
    let poses = rows.poses();
    let shorter = interruptible(py, |stop| shorten_poses(scene, engine, &poses, &Watch::on(stop)))?;
    answered(|| Ok(serialized_as_in_files(&PathFile::of_poses(scene, &shorter))))
}

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
