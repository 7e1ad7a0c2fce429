//! Shortens paths given by the user.

use super::{Processing, verified};
use crate::collision::path_check::first_invalid_segment;
use crate::collision::{Checker, Validity, Violation};
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::model::Scene;
use crate::planning::{StateSpace, TranslationSpace};
use crate::postprocess::{RewindOptions, Trace, rewind_traced};
use crate::turning::{PoseShortener, PoseSpace, TurningEngine};
use crate::watch::Watch;

/// Shortens a path given by the user.
///
/// # Errors
/// A segment that is not valid (the error names it and the reason), bad options, [`Error::interrupted`].
pub fn shorten_path(
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

/// Shortens a path of poses given by the user.
///
/// # Errors
/// A segment that is not valid (the error names it and the reason); as [`PoseSpace::of`]; [`Error::interrupted`].
pub fn shorten_poses(scene: &Scene, engine: &TurningEngine, poses: &[Pose], watch: &Watch) -> Result<Vec<Pose>, Error> {
    let [Some(start), Some(goal)] = [poses.first(), poses.last()] else { return Ok(Vec::new()) };
    let invalid = |path: &[Pose]| path.windows(2).position(|pair| !engine.motion_valid(&pair[0], &pair[1]));
    if let Some(segment) = invalid(poses) {
        let reason = engine.explain(&poses[segment], &poses[segment + 1]);
        return Err(invalid_segment(segment, reason));
    }
    let space = PoseSpace::of(scene, [start, goal])?;
    let shorter = PoseShortener::new(&space, engine).simplified(poses, space.length(poses), watch)?;
    match invalid(&shorter) {
        None => Ok(shorter),
        Some(segment) => {
            Err(Error::internal(format!("segment {segment} of the shortened path did not pass its last check")))
        }
    }
}

/// Rewinds a path of a scene, and records every motion that was checked.
///
/// # Errors
/// As [`shorten_path`].
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

fn refuse_invalid(engine: &dyn Checker, waypoints: &[Point]) -> Result<(), Error> {
    let Some(segment) = first_invalid_segment(engine, waypoints) else { return Ok(()) };
    Err(invalid_segment(segment, engine.explain(&waypoints[segment], &waypoints[segment + 1])))
}

fn invalid_segment(segment: usize, reason: Option<Violation>) -> Error {
    let why = reason.map(|v| format!(": {}", v.sentence())).unwrap_or_default();
    Error::invalid(format!("waypoints[{segment}]"), format!("the segment that starts here is not valid{why}"))
}
