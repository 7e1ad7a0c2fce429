//! Measurements of a planned path.

use std::time::Duration;

use super::{PlanResult, Query};
use crate::collision::Checker;
use crate::collision::path_check::{Nearest, nearest};
use crate::compiled::CompiledScene;
use crate::error::{Error, ErrorClass};
use crate::limits::QUICK_BOUND_EFFORT;
use crate::lower_bound::Forbidden;
use crate::path::wrench_of;
use crate::tolerances::BOUND_GAP;
use crate::watch::Watch;
use crate::wrench::PathWrench;

/// How far measuring a found path may exceed the budget.
const APPRAISAL_GRACE: Duration = Duration::from_millis(8);

/// Measurements of a found path besides its length; those not finished in time are left out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Appraisal {
    /// Nearest approach of the path, and the pairs exempt from the required clearance.
    pub nearest: Nearest,
    /// Wrench margin and tensions of the path, if the scene requires wrench feasibility.
    pub wrench: Option<PathWrench>,
    /// Lower bound on the length of every path, m; only if requested.
    pub lower_bound: Option<f64>,
}

/// Measures a found path, within the watch of its planning plus a short grace period for all but the bound. An interruption is not an error
/// here: the path exists, and a caller who interrupts wants it. A path on which the platform turns is measured without wrenches and
/// bound.
///
/// # Errors
/// The errors of [`wrench_of`].
pub fn appraise(
    compiled: &CompiledScene,
    result: &PlanResult,
    bounded: bool,
    watch: &Watch,
) -> Result<Appraisal, Error> {
    let (path, scene) = (&result.path[..], compiled.scene());
    let unmeasured = || Nearest::unmeasured(compiled.conditions());
    if path.is_empty() {
        return Ok(Appraisal { nearest: unmeasured(), ..Appraisal::default() });
    }
    let held = scene.keeps_orientation(path);
    let lower_bound = if bounded { quick_bound(compiled, result, watch)? } else { None };
    let grace = watch.deadline.map(|deadline| deadline + APPRAISAL_GRACE);
    let watch = Watch { deadline: grace, ..*watch };
    Ok(Appraisal {
        nearest: unless_stopped(nearest(compiled, path, &watch).map(Some))?.unwrap_or_else(unmeasured),
        wrench: if held { unless_stopped(wrench_of(scene, path, &watch))? } else { None },
        lower_bound,
    })
}

/// A lower bound on the length of every path between the ends of a found one, m, near its length if this takes little effort.
/// `None` without a path, if the platform may turn, or if there is no time.
///
/// # Errors
/// Effort that no scene needs.
pub fn quick_bound(compiled: &CompiledScene, result: &PlanResult, watch: &Watch) -> Result<Option<f64>, Error> {
    let [start, .., goal] = &result.path[..] else { return Ok(None) };
    if result.route.is_some() {
        return Ok(result.lower_bound); // found with the path: that of the ends alone would be about other paths
    }
    let ends = [start, goal].map(|end| Some(end.orientation));
    if Query::of(compiled.scene()).oriented(ends).turns() {
        return Ok(None);
    }
    Ok(unless_stopped(bound_of(compiled.level(), result, watch))?.or(result.lower_bound))
}

/// A lower bound of the length of all paths, near the length of the found path if this takes little effort; `None` if
/// there is no time.
fn bound_of(engine: &dyn Checker, result: &PlanResult, watch: &Watch) -> Result<Option<f64>, Error> {
    let (PlanResult { path, cost, .. }, enough) = (result, result.cost / (1.0 + BOUND_GAP));
    let [Some(start), Some(goal)] = [path.first(), path.last()].map(|end| end.map(|end| &end.position)) else {
        return Ok(None);
    };
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

/// A result; `None` if the work was interrupted or ran out of time.
fn unless_stopped<T>(answer: Result<Option<T>, Error>) -> Result<Option<T>, Error> {
    match answer {
        Err(error) if matches!(error.class(), ErrorClass::Interrupted | ErrorClass::OutOfTime) => Ok(None),
        answer => answer,
    }
}
