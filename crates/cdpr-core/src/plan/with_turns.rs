//! Planning for a platform that may turn on its way.

use std::sync::Arc;
use std::time::Duration;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use web_time::Instant;

use super::query::{Planned, Query};
use super::result::Searches;
use super::{Improved, POST_GRACE, PlanOptions, PlanResult, Post, Stats, engine_within, plan_by};
use crate::collision::{Interference, Validity};
use crate::error::Error;
use crate::geometry::{Point, Pose, Rotation};
use crate::model::Scene;
use crate::planning::{Outcome, Planner, PlannerSettings, Problem, SearchTree, StateSpace, Status};
use crate::turning::{PoseShortener, PoseSpace, TurningEngine};
use crate::watch::{Watch, unless_interrupted};

/// The engine for motions from pose to pose in a scene.
///
/// # Errors
/// As [`engine_within`] and [`TurningEngine::new`].
pub fn turning_engine(scene: &Scene, watch: &Watch) -> Result<TurningEngine, Error> {
    let level = engine_within(scene, PlanOptions::default().engine, Interference::Exact, watch)?;
    TurningEngine::new(scene, level)
}

/// Plans a path of poses. If start and goal have the orientation of the scene, it is first planned without turning.
pub fn plan_turning(
    query: &Query,
    options: &PlanOptions,
    watch: &Watch,
    improved: &Improved,
) -> Result<Planned, Error> {
    let scene = query.scene;
    let Some(level) = query.compiled(options, watch)? else { return Ok(Planned::out_of_time()) };
    let engine = TurningEngine::new(scene, level)?;
    let [start, goal] = query.poses()?;
    let mut searches = Searches::default();
    let straight = match scene.keeps_orientation(&[start, goal]) {
        true => {
            let half = watch.left().map(|left| left / 2);
            let share = Watch { deadline: half.map(|half| Instant::now() + half), ..*watch };
            let mut found = plan_by(engine.level(), query, options, &share, improved)?;
            searches.add(&mut found);
            Some(found)
        }
        false => None,
    };
    let known = straight.as_ref().filter(|found| found.status == Status::Solved);
    if known.is_some_and(|found| found.cost <= (goal.position - start.position).norm() * (1.0 + TURN_WORTH)) {
        return Ok(Planned::turning(engine, straight.expect("just seen")));
    }
    let shortest = known.map_or(f64::INFINITY, |found| found.cost);
    let shorter = searches.shorter_than(shortest, improved);
    let turned = search(&engine, scene, [start, goal], options, watch, &shorter);
    // An interruption ends the search for a shorter path, not the one that is known.
    let mut turned = match known {
        Some(_) => unless_interrupted(turned)?.unwrap_or_else(PlanResult::out_of_time),
        None => turned?,
    };
    searches.add(&mut turned);
    let result = match straight {
        Some(straight) if !(turned.cost < straight.cost * (1.0 - TURN_WORTH)) && straight.status == Status::Solved => {
            straight
        }
        _ => turned,
    };
    Ok(Planned::turning(engine, PlanResult { stats: searches.stats(), ..result }))
}

/// A path on which the platform turns must be shorter by this share than one without.
const TURN_WORTH: f64 = 1e-6;

fn search(
    engine: &TurningEngine,
    scene: &Scene,
    [start, goal]: [Pose; 2],
    options: &PlanOptions,
    watch: &Watch,
    improved: &Improved,
) -> Result<PlanResult, Error> {
    for (pose, status) in [(start, Status::StartInvalid), (goal, Status::GoalInvalid)] {
        if !engine.state_valid(&pose) {
            return Ok(PlanResult::invalid_end(status, engine, &pose));
        }
    }
    let space = PoseSpace::of(scene, [&start, &goal])?;
    let clock = Instant::now();
    let mut rng = ChaCha8Rng::seed_from_u64(options.seed);
    let shortener = PoseShortener::new(&space, engine);
    let better = |seconds: f64, cost: f64, path: &[Pose]| improved(seconds, cost, &positions(path));
    let problem = Problem { space: space.clone(), start, goal };
    // The anytime planner shortens its paths itself, and leaves out needless waypoints in the end.
    let shortens = options.planner.planner() == Planner::Anytime;
    let simplifies = shortens || options.post() != Post::None;
    let kept = if simplifies { kept_for_simplifying(watch) } else { Duration::ZERO };
    let search = Watch { deadline: watch.deadline.map(|deadline| deadline - kept), ..*watch };
    let outcome = options.planner.search(&problem, engine, &shortener, &better, &mut rng, &search)?;
    let planning_seconds = clock.elapsed().as_secs_f64();
    let Outcome { status, waypoints, tree, motion_checks, samples, history, .. } = outcome;
    let stats = Stats { nodes: tree.states.len(), motion_checks, samples, planning_seconds, post_seconds: 0.0 };
    let tree = SearchTree { states: positions(&tree.states), parents: tree.parents };
    let unsolved = PlanResult { tree: Arc::new(tree), history, ..PlanResult::unsolved(status, stats) };
    if status != Status::Solved {
        return Ok(unsolved);
    }
    let clock = Instant::now();
    let grace = Watch { deadline: watch.deadline.map(|deadline| deadline + POST_GRACE), ..*watch };
    let longest = match options.planner.settings() {
        PlannerSettings { target_cost: None, gap: None, .. } => f64::INFINITY,
        _ => 0.0, // a length that was asked for and reached must not be lost again
    };
    let path = match simplifies {
        // A caller who interrupts wants the path that was found.
        true => unless_interrupted(shortener.simplified(&waypoints, longest, &grace))?,
        false => None,
    };
    let path = path.unwrap_or_else(|| waypoints.clone());
    let raw = if shortens { &path } else { &waypoints };
    if let Some(segment) = path.windows(2).position(|pair| !engine.motion_valid(&pair[0], &pair[1])) {
        return Err(Error::internal(format!("segment {segment} of the planned path did not pass its last check")));
    }
    let stats = Stats { post_seconds: clock.elapsed().as_secs_f64(), ..stats };
    Ok(PlanResult {
        cost: space.length(&path),
        waypoints: positions(&path),
        orientations: orientations(&path),
        raw_cost: space.length(raw),
        raw_waypoints: positions(raw),
        stats,
        ..unsolved
    })
}

/// The part of a budget that is kept for leaving out needless waypoints in the end.
fn kept_for_simplifying(watch: &Watch) -> Duration {
    const SHARE: u32 = 10;
    const MOST: Duration = Duration::from_millis(100);
    watch.left().map_or(Duration::ZERO, |left| (left / SHARE).min(MOST))
}

fn positions(path: &[Pose]) -> Vec<Point> {
    path.iter().map(|pose| pose.position).collect()
}

fn orientations(path: &[Pose]) -> Vec<Rotation> {
    path.iter().map(|pose| pose.orientation).collect()
}
