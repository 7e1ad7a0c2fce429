//! Planning for a platform that may turn on its way.

use std::time::Duration;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use web_time::Instant;

use super::query::Query;
use super::result::Searches;
use super::{Improved, PlanOptions, PlanResult, Post, Stats, for_post_processing, plan_held, verified};
use crate::compiled::{CompiledScene, positions};
use crate::error::Error;
use crate::geometry::Pose;
use crate::model::Scene;
use crate::planning::{Planner, PlannerSettings, Problem, StateSpace, Status};
use crate::turning::{PoseShortener, PoseSpace, TurningEngine};
use crate::watch::{Watch, unless_interrupted};

/// Plans a path of poses. If start and goal have the orientation of the scene, it is first planned without turning.
pub fn plan_with_turns(
    compiled: &CompiledScene,
    query: &Query,
    options: &PlanOptions,
    watch: &Watch,
    improved: &Improved,
) -> Result<PlanResult, Error> {
    let scene = query.scene;
    let engine = compiled.turning()?;
    let [start, goal] = query.poses()?;
    let mut searches = Searches::default();
    let straight = match scene.keeps_orientation(&[start, goal]) {
        true => {
            let half = watch.left().map(|left| left / 2);
            let share = Watch { deadline: half.map(|half| Instant::now() + half), ..*watch };
            let mut found = plan_held(compiled, query, options, &share, improved)?;
            searches.add(&mut found);
            Some(found)
        }
        false => None,
    };
    let known = straight.as_ref().filter(|found| found.status == Status::Solved);
    if known.is_some_and(|found| found.cost <= (goal.position - start.position).norm() * (1.0 + TURN_WORTH)) {
        return Ok(straight.expect("just seen"));
    }
    let shortest = known.map_or(f64::INFINITY, |found| found.cost);
    let shorter = searches.shorter_than(shortest, improved);
    let turned = search(engine, scene, [start, goal], options, watch, &shorter);
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
    Ok(PlanResult { stats: searches.stats(), ..result })
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
    if let Some(invalid) = PlanResult::invalid_end(engine, [&start, &goal]) {
        return Ok(invalid);
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
    let mut outcome = options.planner.search(&problem, engine, &shortener, &better, &mut rng, &search)?;
    let planning_seconds = clock.elapsed().as_secs_f64();
    let waypoints = std::mem::take(&mut outcome.waypoints);
    let found = PlanResult { lower_bound: None, ..PlanResult::searched(outcome, planning_seconds, |p| p.position) };
    if found.status != Status::Solved {
        return Ok(found);
    }
    let clock = Instant::now();
    let watch = for_post_processing(watch);
    let longest = match options.planner.settings() {
        PlannerSettings { target_cost: None, gap: None, .. } => f64::INFINITY,
        _ => 0.0, // a length that was asked for and reached must not be lost again
    };
    let path = match simplifies {
        // A caller who interrupts wants the path that was found.
        true => unless_interrupted(shortener.simplified(&waypoints, longest, &watch))?,
        false => None,
    };
    let path = path.unwrap_or_else(|| waypoints.clone());
    let raw = if shortens { &path } else { &waypoints };
    verified(engine, &path)?;
    let stats = Stats { post_seconds: clock.elapsed().as_secs_f64(), ..found.stats };
    let (cost, raw_cost, raw_path) = (space.length(&path), space.length(raw), raw.clone());
    Ok(PlanResult { cost, raw_cost, raw_path, path, stats, ..found })
}

/// The part of a budget that is kept for leaving out needless waypoints in the end.
fn kept_for_simplifying(watch: &Watch) -> Duration {
    const SHARE: u32 = 10;
    const MOST: Duration = Duration::from_millis(100);
    watch.left().map_or(Duration::ZERO, |left| (left / SHARE).min(MOST))
}
