//! Planning: options and arguments that would have no effect, the search, and the motion if its time is minimised.

use cdpr_core::model::spec::MotionSpec;
use cdpr_core::plan::{Appraisal, Observer, PlanOptions, PlanResult, Post, Query, plan as search_path};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::trajectory::{MOST_PATHS, Minimise};
use cdpr_core::watch::{TimeUnit, in_time, time_budget};
use cdpr_core::{Choice, Error};
use cdpr_files::{PathFile, text::Notation};
use pyo3::prelude::*;

use crate::convert::{named, point, serialized, serialized_as_in_files};
use crate::errors::answered;
use crate::scene::Scene;
use crate::search::{TreeArrays, observed, tree_arrays};
use crate::timed::Trajectory;
use crate::turning::Orientation;

type Planned<'py> = (String, TreeArrays<'py>, Option<String>, Option<Trajectory>);

/// The result of planning as JSON, as in a path file, the search tree, states (n, 3) and parents (n,), the certificate of a
/// proof that there is no path, if it has one, and the motion with limits `motion`, JSON as in the table `[motion]`, if its time is minimised.
#[allow(clippy::too_many_arguments)] // one per keyword of cdpr.plan
#[pyfunction]
pub fn plan<'py>(
    scene: &Scene,
    py: Python<'py>,
    planner: &str,
    engine: &str,
    interference: &str,
    seed: u64,
    start: Option<[f64; 3]>,
    goal: Option<[f64; 3]>,
    start_orientation: Option<Orientation>,
    goal_orientation: Option<Orientation>,
    step: Option<f64>,
    post: Option<&str>,
    repeats: Option<usize>,
    budget: Option<f64>,
    settings: &str,
    proof: bool,
    minimise: &str,
    motion: Option<&str>,
    on_improvement: Option<Py<PyAny>>,
) -> PyResult<Planned<'py>> {
    let settings: PlannerSettings = answered(|| cdpr_files::text::parse(settings, Notation::Json))?;
    let planner: Planner = named(planner)?;
    let given = (step.is_some(), repeats.is_some());
    let PlanOptions { step: usual_step, repeats: usual_repeats, .. } = PlanOptions::default();
    let (step, repeats) = (step.unwrap_or(usual_step), repeats.unwrap_or(usual_repeats));
    let limits = answered(|| motion_limits(&scene.0, Choice::named(minimise)?, motion))?;
    let mut options = PlanOptions {
        planner: answered(|| PlannerOptions::new(planner, step, &settings))?,
        engine: named(engine)?,
        interference: named(interference)?,
        seed,
        step,
        post: post.map(named).transpose()?,
        repeats,
        proof,
        budget: answered(|| budget.map(|seconds| time_budget("budget", seconds, TimeUnit::Second)).transpose())?,
    };
    // An invalid number is reported as such, even where it would have no effect.
    answered(|| Post::Both.processing(step, repeats).map(drop))?;
    answered(|| without_effect(&options, given, settings.extend_step.is_some()))?;
    let turn = |key: &str, given: Option<Orientation>| given.map(|given| given.of(&scene.0, key)).transpose();
    let ends =
        answered(|| Ok([turn("start_orientation", start_orientation)?, turn("goal_orientation", goal_orientation)?]))?;
    let query = Query { start: start.map(point), goal: goal.map(point), ..Query::of(&scene.0) }.oriented(ends);
    let search = |observer: &dyn Observer| {
        let stop = || observer.interrupted();
        let watch = options.watch(&stop);
        let compiled = || scene.1.compiled(&scene.0, (options.engine, options.interference), &watch);
        let compiled = match scene.0.orientation_is_open() {
            true => None, // a scene for each of its orientations is compiled
            false => match in_time(compiled())? {
                None => return Ok((scene.0.clone(), PlanResult::out_of_time(), Appraisal::default(), None)),
                compiled => compiled,
            },
        };
        let searches = if limits.is_some() { MOST_PATHS } else { 1 }; // each has an equal share of the budget
        options.budget = watch.left().map(|left| left / searches);
        let mut planned = search_path(Query { compiled: compiled.as_ref(), ..query }, &options, observer)?;
        let fastest = match &limits {
            Some(limits) if planned.result.status == Status::Solved => {
                let ends = Query { scene: &planned.scene, ..query }.poses()?;
                Trajectory::fastest(&mut planned, ends, &mut options, limits, &watch)?
            }
            _ => None,
        };
        let appraisal = planned.appraise(false, &watch)?;
        Ok((planned.scene, planned.result.unless_interrupted()?, appraisal, fastest))
    };
    let (asked, found, appraisal, fastest) = observed(py, on_improvement.as_ref(), search)?;
    let file = answered(|| Ok(PathFile::planned(&asked, &options, &found, &appraisal)))?;
    let certificate = found.no_path.as_ref().map(|no_path| serialized(&no_path.certificate));
    Ok((serialized_as_in_files(&file), tree_arrays(py, &found.tree)?, certificate, fastest))
}

/// The limits of the motion whose time is minimised, JSON as in the table `[motion]`, checked before the search; `None` if the
/// length is minimised.
fn motion_limits(
    scene: &cdpr_core::Scene,
    minimise: Minimise,
    motion: Option<&str>,
) -> Result<Option<MotionSpec>, Error> {
    match (minimise, motion) {
        (Minimise::Length, None) => Ok(None),
        (Minimise::Length, Some(_)) => {
            let problem = "found with minimise=\"length\", where it has no effect; expected minimise=\"time\"";
            Err(Error::invalid("motion", problem))
        }
        (Minimise::Time, motion) => {
            let given = motion.map_or(Ok(MotionSpec::default()), |text| cdpr_files::text::parse(text, Notation::Json));
            let given = given.map_err(|error| error.under("motion"))?;
            given.in_scene(scene).map_err(|error| error.under("motion")).map(|_| Some(given))
        }
    }
}

/// Where step and repeats have an effect.
const REWINDING: &str = "post=\"both\", \"backward\", \"forward\", \"backward-only\" or \"forward-only\"";

/// Refuses a step and repeats, where given, that would have no effect.
fn without_effect(options: &PlanOptions, (step, repeats): (bool, bool), extend_step: bool) -> Result<(), Error> {
    let (planner, post) = (options.planner.planner(), options.post());
    let refused = |place: &str, with: String, expected: &str| {
        Err(Error::invalid(place, format!("found with {with}, where it has no effect; expected {expected}")))
    };
    let both = || format!("planner=\"{}\" and post=\"{}\"", planner.name(), post.name());
    if repeats && !post.rewinds() {
        return refused("repeats", both(), REWINDING);
    }
    if step && !options.uses_step(extend_step) {
        let expected = format!("{REWINDING}, or planner=\"rrt\" or \"rrt-star\" without extend_step");
        return refused("step", both(), &expected);
    }
    Ok(())
}
