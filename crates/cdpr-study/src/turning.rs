//! Checks, before any trial runs, that an experiment requests nothing that is undefined where the platform may turn.

use cdpr_core::collision::Interference;
use cdpr_core::error::Error;
use cdpr_core::model::Scene;
use cdpr_core::plan::{PlanOptions, Query};
use cdpr_core::turning::PoseSpace;

/// Checks a scene whose platform may turn.
///
/// # Errors
/// No start or goal, or a goal that cannot be reached by turns about the scene's axis. The error names the key.
pub fn check_scene(scene: &Scene) -> Result<(), Error> {
    let [start, goal] = Query::of(scene).poses()?;
    PoseSpace::of(scene, [&start, &goal]).map(|_| ())
}

/// Checks a method that plans in the scenario with this number, whose platform may turn.
///
/// # Errors
/// A sweep of rewinding, which is for paths without turns; the rule `swept` for cables; a planner that is a function of
/// the caller. The error names the key.
pub fn check_method(options: &PlanOptions, sweeps: bool, external: bool, scenario: usize) -> Result<(), Error> {
    let because = format!("since the platform of scenarios[{scenario}] may turn");
    if sweeps {
        return Err(Error::invalid("sweep", format!("found a sweep of rewinding, expected none, {because}")));
    }
    if external {
        return Err(Error::invalid("planner", format!("found a function, expected a planner of cdpr, {because}")));
    }
    if options.interference == Interference::Swept {
        return Err(Error::invalid("interference", format!("found \"swept\", expected \"exact\", {because}")));
    }
    Ok(())
}
