//! Shortens paths given by the user.

use super::{Processing, verified};
use crate::collision::path_check::first_invalid_segment;
use crate::collision::{Checker, Validity};
use crate::compiled::{CompiledScene, positions};
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::path::held;
use crate::planning::{StateSpace, TranslationSpace};
use crate::postprocess::{RewindOptions, Trace, rewind_traced};
use crate::turning::{PoseShortener, PoseSpace};
use crate::watch::Watch;

/// Shortens a path given by the user. If the platform turns on it, positions and orientations are shortened together,
/// whatever the processing.
///
/// # Errors
/// A segment that is not valid (the error names it and the reason); bad options; the errors of
/// [`CompiledScene::turning`] and [`PoseSpace::of`]; [`Error::interrupted`].
pub fn shorten(
    compiled: &CompiledScene,
    path: &[Pose],
    processing: &Processing,
    watch: &Watch,
) -> Result<Vec<Pose>, Error> {
    let ([start, .., goal], scene) = (path, compiled.scene()) else { return Ok(path.to_vec()) };
    if scene.keeps_orientation(path) {
        return Ok(held(scene, &shorten_held(compiled.level(), &positions(path), processing, watch)?));
    }
    let engine = compiled.turning()?;
    refuse_invalid(engine, path)?;
    let space = PoseSpace::of(scene, [start, goal])?;
    let shorter = PoseShortener::new(&space, engine).simplified(path, space.length(path), watch)?;
    verified(engine, &shorter)?;
    Ok(shorter)
}

/// Shortens a path at the orientation of an engine.
///
/// # Errors
/// A segment that is not valid (the error names it and the reason), bad options, [`Error::interrupted`].
pub fn shorten_held(
    engine: &dyn Checker,
    waypoints: &[Point],
    processing: &Processing,
    watch: &Watch,
) -> Result<Vec<Point>, Error> {
    refuse_invalid(engine, waypoints)?;
    let shorter = processing.of(engine, waypoints, watch)?;
    verified(engine, &shorter)?;
    Ok(shorter)
}

/// Rewinds a path of a scene, and records every motion that was checked.
///
/// # Errors
/// The errors of [`shorten_held`].
pub fn trace_rewinding(
    engine: &dyn Checker,
    waypoints: &[Point],
    options: &RewindOptions,
    watch: &Watch,
) -> Result<Trace<Point>, Error> {
    refuse_invalid(engine, waypoints)?;
    let space = TranslationSpace::of(engine.conditions());
    rewind_traced(&space, engine, waypoints, options, watch)
}

fn refuse_invalid<S>(engine: &(impl Validity<S> + ?Sized), path: &[S]) -> Result<(), Error> {
    let Some(segment) = first_invalid_segment(engine, path) else { return Ok(()) };
    let reason = engine.explain(&path[segment], &path[segment + 1]);
    let why = reason.map(|violation| format!(": {}", violation.sentence())).unwrap_or_default();
    Err(Error::invalid(format!("waypoints[{segment}]"), format!("the segment that starts here is not valid{why}")))
}
