//! Planning: options and arguments that would have no effect, the search, and the motion if its time is minimised.

use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use cdpr_core::geometry::Rotation;
use cdpr_core::model::PositionSource;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::plan::{
    Appraisal, Maximise, Observer, PlanOptions, PlanResult, Post, Query, Route, plan_each, plan_route, plan_widest,
    plan_widest_within, replan as search_again,
};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::task::{TaskLegs, TaskTiming, plan_task};
use cdpr_core::tour::{By, TourFile, TourOptions, plan_tour};
use cdpr_core::trajectory::{MOST_PATHS, Minimise};
use cdpr_core::watch::{TimeUnit, Watch, in_time, time_budget};
use cdpr_core::{Choice, Error};
use cdpr_files::{PathFile, WholeFile, text::Notation};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use crate::convert::{named, serialized, serialized_as_in_files};
use crate::errors::{Failure, answered, kept_on_interrupt, raised};
use crate::scene::Scene;
use crate::search::{TreeArrays, observed, tree_arrays};
use crate::timed::Trajectory;
use crate::turning::{Orientation, Position};

type Planned<'py> = (String, TreeArrays<'py>, Option<String>, Option<Trajectory>);
type Found<'py> = (String, TreeArrays<'py>, Option<String>);
/// Via points, goals, and a box of goals.
type RouteGiven = (Vec<Position>, Vec<Position>, Option<[[f64; 3]; 2]>);

/// Minimum time between two calls of a progress function, each of which needs the interpreter.
pub const PERIOD: Duration = Duration::from_millis(50);

/// The result of planning as JSON, as in a path file, the search tree, states (n, 3) and parents (n,), the certificate of a
/// proof that there is no path, if it has one, and the motion with limits `motion`, JSON as in the table `[motion]`, if its time is minimised.
#[allow(clippy::too_many_arguments)] // one per keyword of cdpr.plan
#[pyfunction]
pub fn plan<'py>(
    scene: &Scene,
    py: Python<'py>,
    search: Search,
    start_orientation: Option<Orientation>,
    goal_orientation: Option<Orientation>,
    route: RouteGiven,
    minimise: &str,
    motion: Option<&str>,
    maximise: Option<&str>,
    within: Option<f64>,
    on_improvement: Option<Py<PyAny>>,
) -> PyResult<Planned<'py>> {
    let limits = answered(|| {
        let minimise: Minimise = Choice::named(minimise)?;
        motion_limits(&scene.0, ("minimise", minimise == Minimise::Time), motion)
    })?;
    let maximise: Option<Maximise> = maximise.map(named).transpose()?;
    if maximise.is_some() && limits.is_some() {
        return Err(raised(Error::invalid("maximise", "found with minimise=\"time\", expected one of the two")));
    }
    let (via, goals, goal_box) = route;
    let sources = |given: Vec<Position>| given.into_iter().map(Into::into).collect();
    let goal_box = goal_box.map(|corners| corners.map(Into::into));
    let route = Route { via: sources(via), goals: sources(goals), goal_box };
    if within.is_some() && maximise.is_none() {
        return Err(raised(Error::invalid("within", "found without maximise, where it has no effect")));
    }
    if maximise.is_some() && !route.is_plain() {
        let problem =
            "found with via, goals or goal_box, expected one goal and nothing on the way: the widest path leads there";
        return Err(raised(Error::invalid("maximise", problem)));
    }
    let mut options = options(search)?;
    let ends = end_orientations(&scene.0, start_orientation, goal_orientation)?;
    let query = Query::of(&scene.0).oriented(ends);
    let find = |observer: &dyn Observer| {
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
        let query = Query { compiled: compiled.as_ref(), ..query };
        let mut planned = match maximise {
            None => plan_route(query, &route, &options, observer)?,
            Some(Maximise::Clearance) => match within {
                None => plan_widest(query, &options, observer)?,
                Some(ratio) => plan_widest_within(query, ratio, &options, observer)?,
            },
        };
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
    let (asked, found, appraisal, fastest) = observed(py, on_improvement.as_ref(), find)?;
    let file = answered(|| Ok(PathFile::planned(&asked, &options, &found, &appraisal)))?;
    let certificate = found.no_path.as_ref().map(|no_path| serialized(&no_path.certificate));
    Ok((serialized_as_in_files(&file), tree_arrays(py, &found.tree)?, certificate, fastest))
}

/// Plans between the ends of a path, keeping what is still valid of it: what [`plan`] returns, without a motion.
#[pyfunction]
pub fn replan<'py>(
    scene: &Scene,
    py: Python<'py>,
    search: Search,
    waypoints: PyReadonlyArray2<'py, f64>,
    orientations: Option<PyReadonlyArray2<'py, f64>>,
) -> PyResult<Found<'py>> {
    let options = options(search)?;
    let path = scene.path(&waypoints, orientations.as_ref())?;
    let (found, appraisal) = observed(py, None, |observer| {
        let stop = || observer.interrupted();
        let watch = options.watch(&stop);
        let compiled = scene.1.compiled(&scene.0, (options.engine, options.interference), &watch);
        let Some(compiled) = in_time(compiled)? else { return Ok((PlanResult::out_of_time(), Appraisal::default())) };
        let planned = search_again(Query::of(&scene.0).by(&compiled), &path, &options, observer)?;
        let appraisal = planned.appraise(false, &watch)?;
        Ok((planned.result.unless_interrupted()?, appraisal))
    })?;
    let file = answered(|| Ok(PathFile::planned(&scene.0, &options, &found, &appraisal)))?;
    let certificate = found.no_path.as_ref().map(|no_path| serialized(&no_path.certificate));
    Ok((serialized_as_in_files(&file), tree_arrays(py, &found.tree)?, certificate))
}

/// Plans from each start to its goal in one scene: for each, what [`plan`] returns, without a motion. On Ctrl-C, what has not
/// been decided is "interrupted". `progress` is called with the number of answers and of questions.
#[allow(clippy::too_many_arguments)] // one per keyword of cdpr.plan_many
#[pyfunction]
pub fn plan_many<'py>(
    scene: &Scene,
    py: Python<'py>,
    search: Search,
    ends: Vec<(Position, Position)>,
    start_orientation: Option<Orientation>,
    goal_orientation: Option<Orientation>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Vec<Found<'py>>> {
    let options = options(search)?;
    let turns = end_orientations(&scene.0, start_orientation, goal_orientation)?;
    let ends: Vec<[PositionSource; 2]> = ends.into_iter().map(|(start, goal)| [start.into(), goal.into()]).collect();
    let telling = Telling::new(progress.as_ref());
    let found = kept_on_interrupt(py, Failure::default(), |stop, failure| {
        let stop = || stop() || failure.is_set();
        let compiled = match scene.0.orientation_is_open() {
            true => None, // a scene for each of its orientations is compiled
            false => Some(scene.1.compiled(&scene.0, (options.engine, options.interference), &Watch::on(&stop))?),
        };
        let query = Query { compiled: compiled.as_ref(), ..Query::of(&scene.0).oriented(turns) };
        let told = |done, total| telling.tell(done, total, failure);
        plan_each(&query, &ends, &options, threads, &stop, &told, &|_, planned| {
            let appraisal = planned.appraise(false, &options.watch(&stop))?;
            let written = PathFile::planned(&planned.scene, &options, &planned.result, &appraisal);
            Ok((serialized_as_in_files(&written), planned.result))
        })
    })?;
    let row = |(written, result): (String, PlanResult)| {
        let certificate = result.no_path.as_ref().map(|no_path| serialized(&no_path.certificate));
        Ok((written, tree_arrays(py, &result.tree)?, certificate))
    };
    found.into_iter().map(row).collect()
}

/// What [`plan_many`] returns for a path that it did not come to before it was interrupted.
#[pyfunction]
pub fn not_planned<'py>(scene: &Scene, py: Python<'py>, search: Search) -> PyResult<Found<'py>> {
    let (options, result) = (options(search)?, PlanResult::interrupted());
    let file = answered(|| Ok(PathFile::planned(&scene.0, &options, &result, &Appraisal::default())))?;
    Ok((serialized_as_in_files(&file), tree_arrays(py, &result.tree)?, None))
}

/// Plans a tour of stations and returns it as JSON. After Ctrl-C, pairs that were not planned are "interrupted". `progress` is
/// called with the number of planned pairs and the total number.
#[allow(clippy::too_many_arguments)] // one per keyword of cdpr.tour
#[pyfunction]
pub fn tour(
    scene: &Scene,
    py: Python<'_>,
    search: Search,
    stations: Option<Vec<String>>,
    start: Option<String>,
    returns: bool,
    order: &str,
    by: &str,
    motion: Option<&str>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    let options = options(search)?;
    let by = named(by)?;
    let limits = answered(|| motion_limits(&scene.0, ("by", by == By::Time), motion))?.unwrap_or_default();
    let wanted = TourOptions { stations, start, returns, order: named(order)?, by, limits, threads };
    let telling = Telling::new(progress.as_ref());
    let found = kept_on_interrupt(py, Failure::default(), |stop, failure| {
        let stop = || stop() || failure.is_set();
        let compiled = scene.1.compiled(&scene.0, (options.engine, options.interference), &Watch::on(&stop))?;
        plan_tour(&compiled, &wanted, &options, &stop, &|done, total| telling.tell(done, total, failure))
    })?;
    Ok(serialized_as_in_files(&TourFile::of(&scene.0, &found)))
}

/// A leg of a task: its path file as JSON, its scene, and its motion.
type LegOfTask = (String, Scene, Option<Trajectory>);

/// Plans the task of a scene and returns its file as JSON, its legs, and the motion through all of them. They are timed if there are limits
/// `motion`, JSON as in the table `[motion]`. After Ctrl-C, legs that were not planned are "interrupted". `progress` is called with the
/// number of planned legs and that of all legs.
#[pyfunction]
pub fn task(
    scene: &Scene,
    py: Python<'_>,
    search: Search,
    motion: Option<&str>,
    rate: Option<f64>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, Vec<LegOfTask>, Option<Trajectory>)> {
    let options = options(search)?;
    let limits = motion.map(|text| answered(|| motion_limits(&scene.0, ("motion", true), Some(text)))).transpose()?;
    let timing = limits.flatten().map(|limits| TaskTiming { limits, rate });
    answered(|| timing.iter().try_for_each(|timing| timing.checked(&scene.0, &TaskLegs::of(&scene.0)?)))?;
    let telling = Telling::new(progress.as_ref());
    let found = kept_on_interrupt(py, Failure::default(), |stop, failure| {
        let stop = || stop() || failure.is_set();
        let found = plan_task(&scene.0, &options, threads, &stop, &|done, total| telling.tell(done, total, failure))?;
        match &timing {
            Some(timing) => found.timed(&scene.0, timing, threads, &stop),
            None => Ok(found),
        }
    })?;
    let file = serialized_as_in_files(&cdpr_files::task_file(&scene.0, &found, WholeFile::default()));
    let (motions, whole) = found.motion.map_or_else(Default::default, |motion| (motion.legs, motion.whole));
    let mut motions = motions.into_iter().map(Result::ok).chain(std::iter::repeat(None));
    let legs = found.legs.legs.into_iter().zip(found.plans);
    let planned =
        |motion, scene| answered(|| Ok(Trajectory { planned: true, ..Trajectory::from_file(motion, scene)? }));
    let legs = legs.map(|(leg, plan)| {
        let motion = motions.next().flatten().map(|motion| planned(motion, Some(leg.scene.clone()))).transpose()?;
        Ok((serialized_as_in_files(&plan.file), Scene::of(leg.scene), motion))
    });
    Ok((file, legs.collect::<PyResult<_>>()?, whole.map(|whole| planned(whole.file, None)).transpose()?))
}

/// Tells a Python function now and then how much is done.
struct Telling<'a> {
    function: Option<&'a Py<PyAny>>,
    /// When and what it was told last.
    last: Mutex<(Instant, usize)>,
}

impl<'a> Telling<'a> {
    fn new(function: Option<&'a Py<PyAny>>) -> Self {
        Telling { function, last: Mutex::new((Instant::now(), 0)) }
    }

    /// So many of `total` are finished.
    fn tell(&self, done: usize, total: usize, failure: &Failure) {
        let Some(function) = self.function else { return };
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if done > last.1 && (done == total || last.0.elapsed() >= PERIOD) {
            *last = (Instant::now(), done);
            failure.keep(Python::attach(|py| function.call1(py, (done, total)).map(drop)));
        }
    }
}

/// Orientations at start and goal, as far as given.
fn end_orientations(
    scene: &cdpr_core::Scene,
    start: Option<Orientation>,
    goal: Option<Orientation>,
) -> PyResult<[Option<Rotation>; 2]> {
    let turn = |key: &str, given: Option<Orientation>| given.map(|given| given.of(scene, key)).transpose();
    answered(|| Ok([turn("start_orientation", start)?, turn("goal_orientation", goal)?]))
}

/// Planner, engine, interference, seed, step, post, repeats, budget, settings of the planner as JSON, and whether to decide
/// whether there is a path.
type Search = (String, String, String, u64, Option<f64>, Option<String>, Option<usize>, Option<f64>, String, bool);

/// The options of a search, checked, also for those that would have no effect.
fn options(search: Search) -> PyResult<PlanOptions> {
    let (planner, engine, interference, seed, step, post, repeats, budget, settings, proof) = search;
    let settings: PlannerSettings = answered(|| cdpr_files::text::parse(&settings, Notation::Json))?;
    let planner: Planner = named(&planner)?;
    let given = (step.is_some(), repeats.is_some());
    let PlanOptions { step: usual_step, repeats: usual_repeats, .. } = PlanOptions::default();
    let (step, repeats) = (step.unwrap_or(usual_step), repeats.unwrap_or(usual_repeats));
    let options = PlanOptions {
        planner: answered(|| PlannerOptions::new(planner, step, &settings))?,
        engine: named(&engine)?,
        interference: named(&interference)?,
        seed,
        step,
        post: post.as_deref().map(named).transpose()?,
        repeats,
        proof,
        budget: answered(|| budget.map(|seconds| time_budget("budget", seconds, TimeUnit::Second)).transpose())?,
    };
    // An invalid number is reported as such, even where it would have no effect.
    answered(|| Post::Both.processing(step, repeats).map(drop))?;
    answered(|| without_effect(&options, given, settings.extend_step.is_some()))?;
    Ok(options)
}

/// The limits of motions, JSON as in the table `[motion]`, checked before the search; `None` if no time is asked for, by the argument of this
/// name.
fn motion_limits(
    scene: &cdpr_core::Scene,
    (argument, timed): (&str, bool),
    motion: Option<&str>,
) -> Result<Option<MotionSpec>, Error> {
    if !timed {
        let problem = format!("found with {argument}=\"length\", where it has no effect; expected {argument}=\"time\"");
        return motion.map_or(Ok(None), |_| Err(Error::invalid("motion", problem)));
    }
    let given = motion.map_or(Ok(MotionSpec::default()), |text| cdpr_files::text::parse(text, Notation::Json));
    let given = given.map_err(|error| error.under("motion"))?;
    given.in_scene(scene).map_err(|error| error.under("motion")).map(|_| Some(given))
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
