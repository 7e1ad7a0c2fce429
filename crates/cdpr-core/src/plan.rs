//! Planning as a whole: engine, planner, post-processing, and a final check of the path.

mod choosing;
mod deciding;
mod no_path;
mod query;
mod with_turns;

use std::sync::Arc;
use std::time::Duration;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use serde::Serialize;
use web_time::Instant;

use crate::choices;
use crate::collision::path_check::{Nearest, PathReport, first_invalid_segment, nearest, path_length};
use crate::collision::{Checker, CspaceEngine, Engine, GjkEngine, Interference, Validity, Violation, check_path};
use crate::error::{Error, ErrorClass};
use crate::geometry::{Point, Pose, Rotation};
use crate::lower_bound::Forbidden;
use crate::model::Scene;
use crate::numerics::{BOUND_GAP, QUICK_BOUND_EFFORT};
use crate::planning::{
    Milestone, Outcome, PathOptimizer, Planner, PlannerOptions, Problem, SearchTree, Status, TranslationSpace,
};
use crate::postprocess::{Direction, Order, RewindOptions, StringPuller, Trace, rewind, rewind_traced};
use crate::turning::{TurningEngine, nearest_of_poses};
use crate::watch::{Interrupt, Watch, in_time};
use crate::wrench::{PathWrench, WrenchChecker, WrenchConstraint, measures, path_wrench};

use deciding::{Decided, search_and_decide};
pub use no_path::NoPath;
pub use query::{Observer, Planned, Query};
pub use with_turns::{shorten_poses, turning_engine};

type Improved<'a> = crate::planning::Improved<'a, Point>;

/// What is done to a planner's path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Post {
    /// Rewind in both orders and keep the shorter result.
    Both,
    /// Rewind backward, then forward.
    Backward,
    /// Rewind forward, then backward.
    Forward,
    /// String pulling: a locally shortest path.
    StringPulling,
    /// Nothing.
    None,
}

choices!(Post, "post", [
    Both = "both": "Rewind in both orders and keep the shorter result (the paper)",
    Backward = "backward": "Rewind backward, then forward",
    Forward = "forward": "Rewind forward, then backward",
    StringPulling = "taut": "String pulling: a locally shortest path around the exact forbidden regions",
    None = "none": "Leave the planner's path as it is",
]);

impl Post {
    /// The default post-processing of a planner: rewinding for the paper's planners, as in the paper.
    pub fn of(planner: Planner) -> Self {
        match planner {
            Planner::Anytime => Post::None,
            Planner::TwoTrees | Planner::RrtConnect => Post::StringPulling,
            Planner::ModifiedRrt | Planner::Rrt | Planner::RrtStar => Post::Both,
        }
    }

    /// Adds the parameters of rewinding.
    ///
    /// # Errors
    /// As [`RewindOptions::checked`].
    pub fn processing(self, step: f64, repeats: usize) -> Result<Processing, Error> {
        let rewind = |order| RewindOptions { step, order, repeats }.checked().map(Processing::Rewind);
        match self {
            Post::Both => rewind(Order::Both),
            Post::Backward => rewind(Order::Backward),
            Post::Forward => rewind(Order::Forward),
            Post::StringPulling => Ok(Processing::StringPulling),
            Post::None => Ok(Processing::None),
        }
    }
}

/// A [`Post`] with its options.
#[derive(Debug, Clone, PartialEq)]
pub enum Processing {
    /// Leave the path as it is.
    None,
    /// Algorithms 4 and 5 of the paper.
    Rewind(RewindOptions),
    /// [`crate::postprocess::string_pulling`].
    StringPulling,
}

impl Processing {
    /// Applies the processing to a valid path.
    fn of(&self, engine: &dyn Checker, waypoints: &[Point], watch: &Watch) -> Result<Vec<Point>, Error> {
        match self {
            Processing::None => Ok(waypoints.to_vec()),
            Processing::Rewind(options) => {
                rewind(&TranslationSpace::of(engine.conditions()), engine, waypoints, options, watch)
            }
            Processing::StringPulling => StringPuller::new(engine).polished(waypoints, watch),
        }
    }
}

/// Options of planning; start and goal are in [`Query`].
#[derive(Debug, Clone, PartialEq)]
pub struct PlanOptions {
    /// Search method and its options.
    pub planner: PlannerOptions,
    /// The engine that checks motions.
    pub engine: Engine,
    /// Rule for interference between cables.
    pub interference: Interference,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Step of rewinding, m.
    pub step: f64,
    /// Post-processing of the planner's path; `None` means [`Post::of`] the planner.
    pub post: Option<Post>,
    /// Number of times that rewinding runs.
    pub repeats: usize,
    /// Whether to decide, beside the search, if there is a path at all.
    pub proof: bool,
    /// Time limit of the call, including the time to compile the scene; the best path so far is returned.
    pub budget: Option<Duration>,
}

impl Default for PlanOptions {
    fn default() -> Self {
        let RewindOptions { step, repeats, .. } = RewindOptions::default();
        PlanOptions {
            planner: PlannerOptions::default(),
            engine: Engine::default(),
            interference: Interference::default(),
            seed: 0,
            step,
            post: None,
            repeats,
            proof: true,
            budget: None,
        }
    }
}

impl PlanOptions {
    /// The paper's method: Modified RRT and rewinding in both orders.
    pub fn paper() -> Self {
        PlanOptions { planner: PlannerOptions::of(Planner::ModifiedRrt), ..PlanOptions::default() }
    }

    /// The watch for a call that begins now.
    pub fn watch<'a>(&self, interrupted: &'a Interrupt<'a>) -> Watch<'a> {
        Watch::on(interrupted).with_budget(self.budget)
    }

    /// What is done to the planner's path.
    pub fn post(&self) -> Post {
        self.post.unwrap_or_else(|| Post::of(self.planner.planner()))
    }
}

/// Counts and times of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Stats {
    /// Nodes of the tree.
    pub nodes: usize,
    /// Motions checked by the planner.
    pub motion_checks: usize,
    /// Random samples drawn.
    pub samples: usize,
    /// Time of the planner, s.
    pub planning_seconds: f64,
    /// Time of rewinding, s.
    pub post_seconds: f64,
}

/// What found a path.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum FoundBy {
    /// The planner.
    #[default]
    Planner,
    /// The decision whether there is a path: the planner found none, but a chain of free cells is one.
    Decision,
}

choices!(FoundBy, "finder", [
    Planner = "planner": "The planner",
    Decision = "decision": "The decision whether there is a path",
]);

/// Result of planning.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanResult {
    /// How planning ended.
    pub status: Status,
    /// What found the path, if there is one.
    pub found_by: FoundBy,
    /// Why the start or goal is invalid.
    pub reason: Option<Violation>,
    /// Why there is no path, if that was proved.
    pub no_path: Option<Arc<NoPath>>,
    /// If no path was found and none proved impossible: every path passes an opening narrower than this, m, if known.
    pub opening_below: Option<f64>,
    /// No path is shorter, m, if the planner computed such a bound.
    pub lower_bound: Option<f64>,
    /// The final path, m; empty unless solved.
    pub waypoints: Vec<Point>,
    /// The orientation at each waypoint; empty if the platform keeps that of the scene.
    pub orientations: Vec<Rotation>,
    /// Its length, m; NaN unless solved.
    pub cost: f64,
    /// The planner's path before rewinding, m; empty unless solved.
    pub raw_waypoints: Vec<Point>,
    /// Its length, m; NaN unless solved.
    pub raw_cost: f64,
    /// The planner's tree, shared by all rewindings of its path; empty if start or goal is invalid.
    pub tree: Arc<SearchTree<Point>>,
    /// When the planner's path improved, first to last.
    pub history: Vec<Milestone>,
    /// Counts and times.
    pub stats: Stats,
}

/// How far post-processing of the path may exceed the budget: well below what a caller notices, and usually enough to
/// finish.
const POST_GRACE: Duration = Duration::from_millis(8);

/// How far measuring a found path may exceed the budget.
const APPRAISAL_GRACE: Duration = Duration::from_millis(12);

/// The engine for a scene: checks its geometry and, if required, wrench feasibility.
///
/// # Errors
/// As [`crate::collision::Conditions::new`] and [`WrenchConstraint::of`].
pub fn engine_for(scene: &Scene, engine: Engine, interference: Interference) -> Result<Box<dyn Checker>, Error> {
    engine_within(scene, engine, interference, &Watch::NONE)
}

/// As [`engine_for`], within a watch.
///
/// # Errors
/// As [`engine_for`]; [`Error::interrupted`], [`Error::out_of_time`].
pub fn engine_within(
    scene: &Scene,
    engine: Engine,
    interference: Interference,
    watch: &Watch,
) -> Result<Box<dyn Checker>, Error> {
    let geometry: Box<dyn Checker> = match engine {
        Engine::Cspace => Box::new(CspaceEngine::within(scene, interference, watch)?),
        Engine::Gjk => Box::new(GjkEngine::within(scene, interference, watch)?),
    };
    Ok(match WrenchConstraint::of(scene, geometry.conditions())? {
        Some(wrench) => Box::new(WrenchChecker::new(geometry, wrench)),
        None => geometry,
    })
}

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

/// Checks a path of a scene with the engine from [`engine_for`].
///
/// # Errors
/// As [`path_wrench`]; [`Error::out_of_time`].
pub fn check(scene: &Scene, engine: &dyn Checker, waypoints: &[Point], watch: &Watch) -> Result<CheckReport, Error> {
    let path = check_path(engine, waypoints, watch)?;
    Ok(CheckReport { path, wrench: path_wrench(&measures(scene)?, waypoints, watch)? })
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

/// Plans a path: compiles the scene, searches, post-processes, and rechecks the path.
///
/// If the scene selects no orientation, each of [`Scene::choices`] is tried in turn, except those for which a lower
/// bound shows that no path is shorter than the best so far; the shortest path wins. The budget begins with the call,
/// and the remaining time is shared evenly among the remaining orientations.
///
/// # Errors
/// No start or goal, bad options, [`Error::interrupted`]. Once there is a path, an interruption is not an error: the
/// best path so far is returned.
///
/// # Example
/// ```
/// use cdpr_core::plan::{PlanOptions, plan};
/// use cdpr_core::planning::Status;
/// let found = plan(&cdpr_core::testing::hard1(), &PlanOptions::default(), &())?.result;
/// assert_eq!(found.status, Status::Solved);
/// assert!((found.cost - 2.435167).abs() < 1e-3); // the straight line is 1.98 m long
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan<'q>(query: impl Into<Query<'q>>, options: &PlanOptions, observer: &dyn Observer) -> Result<Planned, Error> {
    let query = query.into();
    RewindOptions { step: options.step, ..RewindOptions::default() }.checked()?;
    if query.engine.is_none() && query.scene.orientation_is_open() {
        return choosing::plan_choosing(&query, options, observer);
    }
    let interrupted = || observer.interrupted();
    let improved = |seconds: f64, cost: f64, path: &[Point]| observer.improved(seconds, cost, path);
    plan_within(&query, options, &options.watch(&interrupted), &improved)
}

/// Plans at the orientation of the scene or, if the platform may turn, from there.
fn plan_within(query: &Query, options: &PlanOptions, watch: &Watch, improved: &Improved) -> Result<Planned, Error> {
    if query.turns() {
        return with_turns::plan_turning(query, options, watch, improved);
    }
    if let Some(engine) = query.engine {
        let result = plan_by(engine, query, options, watch, improved)?;
        return Ok(Planned::without_engine(result));
    }
    let engine = match engine_within(query.scene, options.engine, options.interference, watch) {
        Err(error) if error.class() == ErrorClass::OutOfTime => {
            return Ok(Planned::without_engine(PlanResult::out_of_time()));
        }
        engine => engine?,
    };
    let result = plan_by(&*engine, query, options, watch, improved)?;
    Ok(Planned { engine: Some(engine), ..Planned::without_engine(result) })
}

fn plan_by(
    engine: &dyn Checker,
    query: &Query,
    options: &PlanOptions,
    watch: &Watch,
    improved: &Improved,
) -> Result<PlanResult, Error> {
    let processing = options.post().processing(options.step, options.repeats)?;
    let raw = search(engine, query, options, watch, improved)?;
    let grace = watch.deadline.map(|deadline| deadline + POST_GRACE);
    post_process(engine, &raw, &processing, &Watch { deadline: grace, ..*watch })
}

/// The planner's result before post-processing; only `raw_waypoints` holds its path.
fn search(
    engine: &dyn Checker,
    query: &Query,
    options: &PlanOptions,
    watch: &Watch,
    improved: &Improved,
) -> Result<PlanResult, Error> {
    let [start, goal] = query.ends()?;
    for (state, status) in [(start, Status::StartInvalid), (goal, Status::GoalInvalid)] {
        if !engine.state_valid(&state) {
            return Ok(PlanResult::unsolved(status, engine.explain(&state, &state), Stats::default()));
        }
    }
    let problem = Problem { space: TranslationSpace::of(engine.conditions()), start, goal };
    let clock = Instant::now();
    let mut rng = ChaCha8Rng::seed_from_u64(options.seed);
    let puller = StringPuller::new(engine);
    let planner = |improved: &Improved, watch: &Watch| {
        options.planner.search(&problem, engine, &puller, improved, &mut rng, watch)
    };
    let decided =
        search_and_decide(engine, [&start, &goal], (options, query.answer), (improved, watch), &puller, planner)?;
    let (outcome, found_by, opening_below) = match decided {
        Decided::Searched(outcome, opening_below) => {
            let (low, high) = engine.conditions().position_box();
            let telling = opening_below.filter(|width| *width < (high - low).min());
            (outcome, FoundBy::Planner, telling)
        }
        Decided::Rescued(outcome) => (outcome, FoundBy::Decision, None),
        Decided::NoPath(proof) => {
            let no_path = NoPath::of(*proof, query.scene, engine, options, watch)?;
            let stats = Stats { planning_seconds: clock.elapsed().as_secs_f64(), ..Stats::default() };
            let no_path = Some(Arc::new(no_path));
            return Ok(PlanResult { no_path, ..PlanResult::unsolved(Status::NoPath, None, stats) });
        }
    };
    let planning_seconds = clock.elapsed().as_secs_f64();
    let Outcome { status, waypoints: raw_waypoints, tree, motion_checks, samples, history, lower_bound } = outcome;
    let stats = Stats { nodes: tree.states.len(), motion_checks, samples, planning_seconds, post_seconds: 0.0 };
    let unsolved = PlanResult {
        found_by,
        tree: tree.into(),
        history,
        opening_below,
        lower_bound,
        ..PlanResult::unsolved(status, None, stats)
    };
    Ok(match status {
        Status::Solved => PlanResult { raw_cost: path_length(&raw_waypoints), raw_waypoints, ..unsolved },
        _ => unsolved,
    })
}

/// Lower bound on the length of every valid path between two positions, m: the straight line or better; infinite if it
/// is certain that there is no path. If time runs out, the best bound so far.
///
/// # Errors
/// [`Error::interrupted`].
///
/// # Example
/// ```
/// use cdpr_core::collision::{Engine, Interference};
/// use cdpr_core::plan::{engine_for, lower_bound};
/// use cdpr_core::watch::Watch;
/// let scene = cdpr_core::testing::hard1();
/// let engine = engine_for(&scene, Engine::Cspace, Interference::Exact)?;
/// let bound = lower_bound(&*engine, &scene.start().unwrap(), &scene.goal().unwrap(), &Watch::NONE)?;
/// assert!(bound > 2.3 && bound < 2.435167); // the straight line is 1.98 m long, the best known path 2.435167 m
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn lower_bound(engine: &dyn Checker, start: &Point, goal: &Point, watch: &Watch) -> Result<f64, Error> {
    match in_time(Forbidden::new(engine, [start, goal], watch))? {
        Some(forbidden) => forbidden.quick_bound(watch),
        None => Ok((goal - start).norm()),
    }
}

/// A result with its raw path processed anew, and every segment rechecked.
///
/// # Errors
/// Bad options, [`Error::interrupted`].
pub fn post_process(
    engine: &dyn Checker,
    raw: &PlanResult,
    processing: &Processing,
    watch: &Watch,
) -> Result<PlanResult, Error> {
    if raw.status != Status::Solved {
        return Ok(raw.clone());
    }
    let clock = Instant::now();
    let waypoints = processing.of(engine, &raw.raw_waypoints, watch)?;
    let post_seconds = if *processing == Processing::None { 0.0 } else { clock.elapsed().as_secs_f64() };
    verified(engine, &waypoints)?;
    let stats = Stats { post_seconds, ..raw.stats };
    Ok(PlanResult { cost: path_length(&waypoints), waypoints, stats, ..raw.clone() })
}

impl PlanResult {
    /// The path as poses, given the orientation of the scene.
    pub fn poses(&self, of_scene: &Rotation) -> Vec<Pose> {
        let orientation = |k: usize| *self.orientations.get(k).unwrap_or(of_scene);
        self.waypoints.iter().enumerate().map(|(k, position)| Pose::new(*position, orientation(k))).collect()
    }

    /// The result if time runs out before the search begins.
    pub fn out_of_time() -> Self {
        PlanResult::unsolved(Status::BudgetSpent, None, Stats::default())
    }

    fn unsolved(status: Status, reason: Option<Violation>, stats: Stats) -> Self {
        let (cost, raw_cost) = (f64::NAN, f64::NAN);
        let tree = Arc::default();
        PlanResult {
            status,
            found_by: FoundBy::Planner,
            reason,
            no_path: None,
            opening_below: None,
            lower_bound: None,
            waypoints: Vec::new(),
            orientations: Vec::new(),
            cost,
            raw_waypoints: Vec::new(),
            raw_cost,
            tree,
            history: Vec::new(),
            stats,
        }
    }
}

/// Checks all segments of a path: a collision on a returned path would be a bug in this program.
fn verified(engine: &dyn Validity, waypoints: &[Point]) -> Result<(), Error> {
    match first_invalid_segment(engine, waypoints) {
        None => Ok(()),
        Some(segment) => {
            Err(Error::internal(format!("segment {segment} of the planned path did not pass its last check")))
        }
    }
}

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

/// Rewinds a path of a scene once, in one direction, and records every motion that was checked.
///
/// # Errors
/// As [`shorten_path`].
pub fn trace_rewinding(
    engine: &dyn Checker,
    waypoints: &[Point],
    step: f64,
    direction: Direction,
    watch: &Watch,
) -> Result<Trace<Point>, Error> {
    refuse_invalid(engine, waypoints)?;
    let space = TranslationSpace::of(engine.conditions());
    rewind_traced(&space, engine, waypoints, step, direction, watch)
}

fn refuse_invalid(engine: &dyn Checker, waypoints: &[Point]) -> Result<(), Error> {
    let Some(segment) = first_invalid_segment(engine, waypoints) else { return Ok(()) };
    Err(invalid_segment(segment, engine.explain(&waypoints[segment], &waypoints[segment + 1])))
}

fn invalid_segment(segment: usize, reason: Option<Violation>) -> Error {
    let why = reason.map(|v| format!(": {}", v.sentence())).unwrap_or_default();
    Error::invalid(format!("waypoints[{segment}]"), format!("the segment that starts here is not valid{why}"))
}
