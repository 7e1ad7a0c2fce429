//! Chooses the path of a timed motion: the shortest one is not always the fastest, since it leaves no room to round corners.

use std::sync::Arc;

use super::Trajectory;
use crate::choices;
use crate::compiled::CompiledScene;
use crate::error::{Error, ErrorClass};
use crate::geometry::Pose;
use crate::model::Scene;
use crate::model::spec::MotionSpec;
use crate::plan::{PlanOptions, PlanResult, Query, plan, plan_through};
use crate::planning::{Method, Status, Until};
use crate::watch::Watch;

/// The criterion by which the path of a timed motion is chosen.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Minimise {
    /// The length of the path.
    #[default]
    Length,
    /// The duration of the motion.
    Time,
}

choices!(Minimise, "minimise", [
    Length = "length": "The length of the path",
    Time = "time": "The duration of the motion, over paths of several seeds and of a larger clearance that leaves room to round corners",
]);

/// Further seeds whose paths are tried.
const SEEDS: u64 = 2;

/// Most paths among which [`plan_timed`] chooses: the first seed and further ones, each with and without a larger clearance.
pub const MOST_PATHS: u32 = 2 * (1 + SEEDS as u32);

/// A path replaces another one only if its motion takes less than this share of the time.
const FASTER: f64 = 0.999;

/// A planned path with its motion.
#[derive(Debug)]
pub struct TimedPlan {
    /// The planned path.
    pub result: PlanResult,
    /// The motion along the path.
    pub trajectory: Trajectory,
    /// The options that the path was planned with.
    pub options: PlanOptions,
    /// The seed of the path that was given.
    pub first_seed: u64,
    /// The clearance that the path keeps in addition to that of the scene, m.
    pub room: f64,
    /// Number of paths that were timed.
    pub tried: usize,
    /// The duration along the path that was given, s, if there is one.
    pub duration_of_first: Option<f64>,
}

/// The motion along a planned path, or along the fastest of several paths: those of other seeds, and of a clearance that is
/// larger by the deviation with which corners are rounded.
///
/// # Errors
/// The errors of [`Trajectory::new`], if there is no motion along any path.
pub fn plan_timed(
    compiled: &Arc<CompiledScene>,
    ends: [Pose; 2],
    first: PlanResult,
    (options, minimise): (&PlanOptions, Minimise),
    given: &MotionSpec,
    watch: &Watch,
) -> Result<TimedPlan, Error> {
    let kept = first.widest.map(|widest| widest.clearance);
    let timed = Trajectory::keeping(compiled, kept, &first.path, given, watch);
    let (route, bound) = (first.route.clone(), first.lower_bound);
    let via: Option<Vec<Pose>> = route.as_ref().map(|route| route.via.iter().map(|k| first.path[*k]).collect());
    let (duration, first_seed) = (timed.as_ref().ok().map(Trajectory::duration), options.seed);
    let mut best = timed.map(|trajectory| TimedPlan {
        result: first,
        first_seed,
        trajectory,
        options: options.clone(),
        room: 0.0,
        tried: 1,
        duration_of_first: duration,
    });
    if minimise == Minimise::Length || matches!(&best, Err(error) if error.class() != ErrorClass::Input) {
        return best;
    }
    let mut tried = usize::from(best.is_ok());
    for (room, seed) in others(compiled.scene(), given, first_seed)? {
        let options = alternative(options, seed);
        let timed = another(compiled, (ends, via.as_deref()), &options, room, watch).and_then(|found| {
            found.map(|result| Ok((Trajectory::new(compiled, &result.path, given, watch)?, result))).transpose()
        });
        match timed {
            Ok(None) => {}
            Ok(Some((trajectory, mut result))) => {
                tried += 1;
                if let (Some(found), Some(first)) = (&mut result.route, &route) {
                    // The bound of the first path is about all goals and all via points, and not only about this goal.
                    (found.goal, result.lower_bound) = (first.goal, bound);
                }
                if best.as_ref().map_or(true, |best| trajectory.duration() < FASTER * best.trajectory.duration()) {
                    best = Ok(TimedPlan {
                        result,
                        trajectory,
                        options,
                        first_seed,
                        room,
                        tried,
                        duration_of_first: duration,
                    });
                }
            }
            Err(error) if error.class() == ErrorClass::Input => {}
            Err(error) if error.class() == ErrorClass::Interrupted && best.is_ok() => break,
            Err(error) => return Err(error),
        }
    }
    best.map(|plan| TimedPlan { tried, ..plan })
}

/// The options for the path of another seed. The target length is omitted: with a larger clearance, no path may reach
/// it.
fn alternative(options: &PlanOptions, seed: u64) -> PlanOptions {
    let mut options = PlanOptions { seed, proof: false, ..options.clone() };
    let limits = &mut options.planner.limits;
    if matches!(limits.until, Until::Cost(target) if target > 0.0) {
        limits.until = Until::FirstPath;
    }
    if let Method::Anytime { gap } = &mut options.planner.method {
        *gap = None;
    }
    options
}

/// Additional clearances and seeds to try.
fn others(scene: &Scene, given: &MotionSpec, seed: u64) -> Result<Vec<(f64, u64)>, Error> {
    let room = given.in_scene(scene)?.blend();
    let seeds: Vec<u64> = (0..=SEEDS).map(|k| seed.wrapping_add(k)).collect();
    let more = seeds.iter().filter(|_| room > 0.0).map(|&seed| (room, seed));
    Ok(more.chain(seeds[1..].iter().map(|&seed| (0.0, seed))).collect())
}

/// The path of a seed with additional clearance, if there is one.
fn another(
    compiled: &Arc<CompiledScene>,
    ([start, goal], via): ([Pose; 2], Option<&[Pose]>),
    options: &PlanOptions,
    room: f64,
    watch: &Watch,
) -> Result<Option<PlanResult>, Error> {
    let (scene, wider) = (compiled.scene(), room > 0.0);
    let clearance = scene.spec().clearance.unwrap_or(0.0) + room;
    let Ok(roomier) = (if wider { scene.with_clearance(clearance).map(Some) } else { Ok(None) }) else {
        return Ok(None);
    };
    let query = roomier.as_ref().map_or(Query::of(scene).by(compiled), Query::of);
    let (query, stop) = (query.between(&start, &goal), || (watch.interrupted)());
    let found = match via {
        Some(via) => plan_through(query, via, options, &stop, true)?,
        None => plan(query, options, &stop)?,
    };
    let found = found.result.unless_interrupted()?;
    watch.check()?;
    // A lower bound for a scene with a larger clearance does not apply to this one.
    let lower_bound = found.lower_bound.filter(|_| room == 0.0);
    Ok((found.status == Status::Solved).then_some(PlanResult { lower_bound, added_clearance: room, ..found }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planning::{Planner, PlannerOptions, PlannerSettings};
    use crate::testing::hard1;

    fn compiled(scene: &Scene) -> Arc<CompiledScene> {
        CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).unwrap().into()
    }

    #[test]
    fn minimum_time_is_never_slower_than_minimum_length() {
        let scene = hard1();
        let limits =
            MotionSpec { speed: Some(1.0), acceleration: Some(2.0), blend: Some(0.03), ..MotionSpec::default() };
        let options = PlanOptions::default();
        let query = Query::of(&scene);
        let first = plan(query, &options, &()).unwrap().result;
        let compiled = compiled(&scene);
        let kept = |minimise| {
            let ends = query.poses().unwrap();
            plan_timed(&compiled, ends, first.clone(), (&options, minimise), &limits, &Watch::NONE).unwrap()
        };
        let (short, fast) = (kept(Minimise::Length), kept(Minimise::Time));
        assert_eq!((short.tried, short.duration_of_first), (1, Some(short.trajectory.duration())));
        assert!(fast.tried > 2 && fast.trajectory.duration() <= short.trajectory.duration());
        assert_eq!(fast.duration_of_first, short.duration_of_first);
    }

    #[test]
    fn timed_plan_ignores_target_cost_with_added_clearance() {
        let scene = hard1();
        let limits =
            MotionSpec { speed: Some(1.0), acceleration: Some(2.0), blend: Some(0.02), ..MotionSpec::default() };
        for settings in [
            PlannerSettings { gap: Some(0.001), ..PlannerSettings::default() },
            PlannerSettings { target_cost: Some(2.436), ..PlannerSettings::default() },
        ] {
            let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
            let options = PlanOptions { planner, ..PlanOptions::default() };
            let query = Query::of(&scene);
            let first = plan(query, &options, &()).unwrap().result;
            let ends = query.poses().unwrap();
            let found =
                plan_timed(&compiled(&scene), ends, first, (&options, Minimise::Time), &limits, &Watch::NONE).unwrap();
            assert!(found.tried > 2);
            // The options are those of the path that was kept.
            let again = scene.with_clearance(found.room).unwrap();
            let again = plan(Query::of(&again), &found.options, &()).unwrap().result;
            assert_eq!(again.path, found.result.path);
            assert!(found.room == 0.0 || found.result.lower_bound.is_none());
            assert_eq!(found.result.added_clearance, found.room);
        }
    }

    #[test]
    fn an_interruption_keeps_the_best_motion_so_far() {
        let scene = hard1();
        let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
        let options = PlanOptions::default();
        let query = Query::of(&scene);
        let (first, ends) = (plan(query, &options, &()).unwrap().result, query.poses().unwrap());
        let polls = std::sync::atomic::AtomicUsize::new(0);
        let count = || polls.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        let compiled = compiled(&scene);
        let timed = |stop: &(dyn Fn() -> bool + Sync)| {
            plan_timed(&compiled, ends, first.clone(), (&options, Minimise::Time), &limits, &Watch::on(stop))
        };
        let whole = timed(&|| count() == usize::MAX).unwrap();
        let all = polls.swap(0, std::sync::atomic::Ordering::Relaxed);
        let found = timed(&|| count() > all / 2).unwrap();
        assert!(found.tried < whole.tried && found.trajectory.duration() <= whole.duration_of_first.unwrap());
    }
}
