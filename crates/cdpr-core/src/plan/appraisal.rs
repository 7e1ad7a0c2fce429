//! Measurements of a path: the report of a check, and the figures stated for a planned path.

use std::time::Duration;

use serde::Serialize;

use super::PlanResult;
use crate::collision::path_check::{Nearest, PathReport, nearest};
use crate::collision::{Checker, check_path};
use crate::error::{Error, ErrorClass};
use crate::geometry::{Point, Pose};
use crate::lower_bound::Forbidden;
use crate::model::Scene;
use crate::numerics::{BOUND_GAP, QUICK_BOUND_EFFORT};
use crate::turning::{TurningEngine, check_poses, nearest_of_poses, wrench_of_poses};
use crate::watch::Watch;
use crate::wrench::{PathWrench, measures, path_wrench};

/// How far measuring a found path may exceed the budget.
const APPRAISAL_GRACE: Duration = Duration::from_millis(12);

/// The complete report on a path of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckReport {
    /// Its length, violations and nearest approach.
    #[serde(flatten)]
    pub path: PathReport,
    /// Its smallest wrench margin and its range of tensions, if the scene requires wrench feasibility.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub wrench: Option<PathWrench>,
}

/// Checks a path of a scene with the engine from [`engine_for`](super::engine_for).
///
/// # Errors
/// As [`path_wrench`]; [`Error::out_of_time`].
pub fn check(scene: &Scene, engine: &dyn Checker, waypoints: &[Point], watch: &Watch) -> Result<CheckReport, Error> {
    let path = check_path(engine, waypoints, watch)?;
    Ok(CheckReport { path, wrench: path_wrench(&measures(scene)?, waypoints, watch)? })
}

/// Checks a path of a scene along which the platform turns.
///
/// # Errors
/// As [`wrench_of_poses`].
pub fn check_turning(
    scene: &Scene,
    engine: &TurningEngine,
    poses: &[Pose],
    watch: &Watch,
) -> Result<CheckReport, Error> {
    let path = check_poses(scene, engine, poses, watch)?;
    Ok(CheckReport { path, wrench: wrench_of_poses(scene, poses, watch)? })
}

/// Measurements of a found path besides its length; those not finished in time are left out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Appraisal {
    /// Its nearest approach, and the pairs exempt from the required clearance.
    pub nearest: Nearest,
    /// Its wrenches, if the scene requires wrench feasibility.
    pub wrench: Option<PathWrench>,
    /// Lower bound on the length of every path, m; only if requested.
    pub lower_bound: Option<f64>,
}

/// Measures a found path, within the watch of its planning plus a short grace period for all but the bound. An interruption is not an error
/// here: the path exists, and a caller who interrupts wants it.
///
/// # Errors
/// As [`path_wrench`].
pub fn appraise(
    scene: &Scene,
    engine: &dyn Checker,
    result: &PlanResult,
    bounded: bool,
    watch: &Watch,
) -> Result<Appraisal, Error> {
    let waypoints = &result.waypoints;
    let unmeasured = || Nearest::unmeasured(engine.conditions());
    if waypoints.is_empty() {
        return Ok(Appraisal { nearest: unmeasured(), ..Appraisal::default() });
    }
    let lower_bound = match bounded {
        true => unless_stopped(bound_of(engine, result, watch))?.or(result.lower_bound),
        false => None,
    };
    let grace = watch.deadline.map(|deadline| deadline + APPRAISAL_GRACE);
    let watch = Watch { deadline: grace, ..*watch };
    Ok(Appraisal {
        nearest: unless_stopped(nearest(engine.conditions(), waypoints, &watch).map(Some))?.unwrap_or_else(unmeasured),
        wrench: unless_stopped(path_wrench(&measures(scene)?, waypoints, &watch))?,
        lower_bound,
    })
}

/// As [`appraise`] for a path on which the platform may turn: its closest approach.
///
/// # Errors
/// [`Error::interrupted`] never: an interruption leaves the measurements out.
pub fn appraise_turning(
    scene: &Scene,
    engine: &TurningEngine,
    result: &PlanResult,
    watch: &Watch,
) -> Result<Appraisal, Error> {
    let unmeasured = || Nearest::unmeasured(engine.conditions());
    if result.waypoints.is_empty() {
        return Ok(Appraisal { nearest: unmeasured(), ..Appraisal::default() });
    }
    let grace = watch.deadline.map(|deadline| deadline + APPRAISAL_GRACE);
    let poses = result.poses(scene.orientation());
    let nearest = nearest_of_poses(engine, &poses, &Watch { deadline: grace, ..*watch }).map(Some);
    Ok(Appraisal { nearest: unless_stopped(nearest)?.unwrap_or_else(unmeasured), ..Appraisal::default() })
}

/// A lower bound of the length of all paths, near that of a path that was found if this takes little effort; `None` if there is
/// no time.
fn bound_of(engine: &dyn Checker, result: &PlanResult, watch: &Watch) -> Result<Option<f64>, Error> {
    let (PlanResult { waypoints, cost, .. }, enough) = (result, result.cost / (1.0 + BOUND_GAP));
    let [Some(start), Some(goal)] = [waypoints.first(), waypoints.last()] else { return Ok(None) };
    let known = result.lower_bound.unwrap_or(0.0).max((goal - start).norm()).min(*cost);
    let no_time = watch.left().is_some_and(|left| left.is_zero());
    if known >= enough || no_time {
        return Ok(Some(known).filter(|_| known >= enough || result.lower_bound.is_some()));
    }
    let forbidden = Forbidden::new(engine, [start, goal], watch)?;
    let known = known.max(forbidden.quick_bound(watch)?.min(*cost));
    if known >= enough || result.lower_bound.is_some() {
        return Ok(Some(known)); // the planner has already tried to prove more
    }
    Ok(Some(known.max(forbidden.prove(enough, QUICK_BOUND_EFFORT, &|_, _| false, watch)?.length)))
}

/// A result, or `None` if the work was interrupted or ran out of time.
fn unless_stopped<T>(answer: Result<Option<T>, Error>) -> Result<Option<T>, Error> {
    match answer {
        Err(error) if matches!(error.class(), ErrorClass::Interrupted | ErrorClass::OutOfTime) => Ok(None),
        answer => answer,
    }
}
