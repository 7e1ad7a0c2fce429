//! Planning as a whole: engine, planner, post-processing, and a final check of the path.

mod appraisal;
mod choosing;
mod deciding;
mod given_path;
mod many;
mod no_path;
mod options;
mod planned;
mod query;
mod replanning;
mod result;
mod route;
mod widest;
mod with_turns;

use std::sync::Arc;
use std::time::Duration;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use web_time::Instant;

use crate::collision::path_check::{first_invalid_segment, path_length};
use crate::collision::{Checker, Validity, nearest_valid};
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::lower_bound::Forbidden;
use crate::path::held;
use crate::planning::{Problem, Status, TranslationSpace};
use crate::postprocess::{RewindOptions, StringPuller};
use crate::proof::Answer;
use crate::tolerances::PLACE_MARGIN;
use crate::watch::{Watch, in_time, unless_interrupted};

pub use appraisal::{Appraisal, appraise, quick_bound};
use deciding::{Decided, search_and_decide};
pub use given_path::{shorten, shorten_held, trace_rewinding};
pub use many::plan_each;
pub use no_path::NoPath;
pub use options::{PlanOptions, Post, Processing};
pub use planned::Planned;
pub use query::{Observer, Query};
pub use replanning::replan;
pub use result::{FoundBy, PlanResult, RouteFound, Stats, Widest};
pub(crate) use route::plan_through;
pub use route::{Route, plan_route, search_route};
pub use widest::{Maximise, plan_widest, plan_widest_within};
use with_turns::plan_with_turns;

type Improved<'a> = crate::planning::Improved<'a, Point>;

/// Time for post-processing a path that was found when the budget had nearly run out: well below what a caller notices,
/// and usually enough to finish.
const POST_GRACE: Duration = Duration::from_millis(6);

/// A watch for post-processing, which may take until the deadline and gets at least [`POST_GRACE`].
fn for_post_processing<'a>(watch: &Watch<'a>) -> Watch<'a> {
    let least = Instant::now() + POST_GRACE;
    Watch { deadline: watch.deadline.map(|deadline| deadline.max(least)), ..*watch }
}

/// Plans a path: compiles the scene, searches, post-processes, and rechecks the path.
///
/// If the scene selects no orientation, each of [`choices`](crate::model::Scene::choices) is tried in turn, except those for which a lower
/// bound shows that no path is shorter than the best so far; the shortest path wins. The budget begins with the call,
/// and the remaining time is shared evenly among the remaining orientations.
///
/// An interruption ends the search with the best path so far; without one, the status is [`Status::Interrupted`].
///
/// # Errors
/// No start or goal, bad options, a scene that cannot be compiled.
///
/// # Example
/// ```
/// use cdpr_core::{PlanOptions, plan};
/// use cdpr_core::Status;
/// let found = plan(&cdpr_core::testing::hard1(), &PlanOptions::default(), &())?.result;
/// assert_eq!(found.status, Status::Solved);
/// assert!((found.cost - 2.435167).abs() < 1e-3); // the straight line is 1.98 m long
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan<'q>(query: impl Into<Query<'q>>, options: &PlanOptions, observer: &dyn Observer) -> Result<Planned, Error> {
    let query = query.into();
    RewindOptions { step: options.step, ..RewindOptions::default() }.checked()?;
    let interrupted = || observer.interrupted();
    let watch = options.watch(&interrupted);
    let planned = if query.compiled.is_none() && query.scene.orientation_is_open() {
        choosing::plan_choosing(&query, options, observer)
    } else {
        let improved = |seconds: f64, cost: f64, path: &[Point]| observer.improved(seconds, cost, path);
        plan_within(&query, options, &watch, &improved)
    };
    match unless_interrupted(planned)? {
        Some(planned) => with_place_near_invalid_end(planned, &query, &watch),
        None => Ok(Planned { scene: query.scene.clone(), compiled: None, result: PlanResult::interrupted() }),
    }
}

/// The result with a valid position near a start or goal that is not valid.
fn with_place_near_invalid_end(mut planned: Planned, query: &Query, watch: &Watch) -> Result<Planned, Error> {
    let end = match planned.result.status {
        Status::StartInvalid => 0,
        Status::GoalInvalid => 1,
        _ => return Ok(planned),
    };
    let Some(compiled) = &planned.compiled else { return Ok(planned) };
    let Pose { position, orientation } = Query { scene: &planned.scene, ..*query }.poses()?[end];
    let valid = |place: &Point| compiled.state_valid(&Pose::new(*place, orientation));
    let found = nearest_valid(compiled.conditions().position_box(), &position, PLACE_MARGIN, valid, watch);
    planned.result.nearest_valid = unless_interrupted(found)?.flatten();
    Ok(planned)
}

/// Plans in the scene of a query, which selects an orientation.
fn plan_within(query: &Query, options: &PlanOptions, watch: &Watch, improved: &Improved) -> Result<Planned, Error> {
    let Some(compiled) = query.compile(options, watch)? else { return Ok(Planned::out_of_time(query.scene)) };
    let result = match query.turns() {
        true => plan_with_turns(&compiled, query, options, watch, improved)?,
        false => plan_held(&compiled, query, options, watch, improved)?,
    };
    Ok(Planned::by(query.scene, compiled, result))
}

/// Plans at the orientation of the scene.
fn plan_held(
    compiled: &CompiledScene,
    query: &Query,
    options: &PlanOptions,
    watch: &Watch,
    improved: &Improved,
) -> Result<PlanResult, Error> {
    let processing = options.post().processing(options.step, options.repeats)?;
    let raw = search_held(compiled, query, options, watch, improved)?;
    post_process(compiled, &raw, &processing, &for_post_processing(watch))
}

/// The planner's result before post-processing; only `raw_path` holds its path.
fn search_held(
    compiled: &CompiledScene,
    query: &Query,
    options: &PlanOptions,
    watch: &Watch,
    improved: &Improved,
) -> Result<PlanResult, Error> {
    let (engine, [start, goal]) = (compiled.level(), query.ends()?);
    if let Some(invalid) = PlanResult::invalid_end(engine, [&start, &goal]) {
        return Ok(invalid);
    }
    let problem = Problem { space: TranslationSpace::of(engine.conditions()), start, goal };
    let clock = Instant::now();
    let mut rng = ChaCha8Rng::seed_from_u64(options.seed);
    let puller = StringPuller::new(engine).knowing(query.known);
    let known = query.known.map(|path| Answer::Path(path.to_vec()));
    let answer = known.as_ref().or(query.answer);
    let planner = |improved: &Improved, watch: &Watch| {
        options.planner.search(&problem, engine, &puller, improved, &mut rng, watch)
    };
    let decided = search_and_decide(engine, [&start, &goal], (options, answer), (improved, watch), &puller, planner)?;
    let planning_seconds = clock.elapsed().as_secs_f64();
    let (mut outcome, found_by, opening_below) = match decided {
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
            return Ok(PlanResult { no_path, ..PlanResult::unsolved(Status::NoPath, stats) });
        }
    };
    let waypoints = std::mem::take(&mut outcome.waypoints);
    let unsolved = PlanResult { found_by, opening_below, ..PlanResult::searched(outcome, planning_seconds, |p| p) };
    Ok(match unsolved.status {
        Status::Solved => {
            PlanResult { raw_cost: path_length(&waypoints), raw_path: held(compiled.scene(), &waypoints), ..unsolved }
        }
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
/// use cdpr_core::{Engine, Interference};
/// use cdpr_core::compiled::engine_for;
/// use cdpr_core::lower_bound;
/// use cdpr_core::Watch;
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

/// A result at the orientation of the scene, with the planner's path processed anew and every segment rechecked.
///
/// # Errors
/// Bad options, [`Error::interrupted`].
pub fn post_process(
    compiled: &CompiledScene,
    raw: &PlanResult,
    processing: &Processing,
    watch: &Watch,
) -> Result<PlanResult, Error> {
    if raw.status != Status::Solved {
        return Ok(raw.clone());
    }
    let clock = Instant::now();
    let raw_waypoints = raw.raw_waypoints();
    let waypoints =
        unless_interrupted(processing.of(compiled.level(), &raw_waypoints, watch))?.unwrap_or(raw_waypoints);
    let post_seconds = if *processing == Processing::None { 0.0 } else { clock.elapsed().as_secs_f64() };
    verified(compiled.level(), &waypoints)?;
    let stats = Stats { post_seconds, ..raw.stats };
    Ok(PlanResult { cost: path_length(&waypoints), path: held(compiled.scene(), &waypoints), stats, ..raw.clone() })
}

/// Checks all segments of a path: a collision on a returned path would be a bug in this program.
fn verified<S>(engine: &(impl Validity<S> + ?Sized), path: &[S]) -> Result<(), Error> {
    match first_invalid_segment(engine, path) {
        None => Ok(()),
        Some(segment) => Err(Error::internal(format!("segment {segment} of the path did not pass its last check"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn post_processing_takes_what_the_search_left_and_a_few_milliseconds_after_that() {
        assert_eq!(for_post_processing(&Watch::NONE).deadline, None);
        let plenty = Watch::NONE.with_budget(Some(Duration::from_secs(60)));
        assert_eq!(for_post_processing(&plenty).deadline, plenty.deadline);
        let over = Watch::NONE.with_budget(Some(Duration::ZERO));
        assert!(for_post_processing(&over).deadline >= over.deadline.map(|deadline| deadline + POST_GRACE));
    }
}
