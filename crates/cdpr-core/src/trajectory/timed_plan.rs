//! Chooses the path of a timed motion: the shortest one is not always the fastest, since it leaves no room to round corners.

use super::Trajectory;
use super::limits::Limits;
use crate::choices;
use crate::error::{Error, ErrorClass};
use crate::geometry::Pose;
use crate::model::Scene;
use crate::model::spec::MotionSpec;
use crate::plan::{PlanOptions, PlanResult, Query, plan};
use crate::planning::Status;
use crate::watch::Watch;

/// What the path of a timed motion is chosen for.
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

/// A path replaces another one only if its motion takes less than this share of the time.
const FASTER: f64 = 0.999;

/// A planned path with its motion.
#[derive(Debug)]
pub struct TimedPlan {
    /// The path.
    pub result: PlanResult,
    /// The motion along it.
    pub trajectory: Trajectory,
    /// The seed that it was planned with.
    pub seed: u64,
    /// The seed of the path that was given.
    pub first_seed: u64,
    /// The clearance that it was planned with in addition to that of the scene, m.
    pub room: f64,
    /// Number of paths that were timed.
    pub tried: usize,
    /// The duration along the path that was given, s, if there is one.
    pub duration_of_first: Option<f64>,
}

/// The motion along a planned path, or along the fastest of several paths: those of other seeds, and of a clearance that is
/// larger by the deviation with which corners are rounded. The engine of the query is not used for these.
///
/// # Errors
/// As [`Trajectory::new`], if there is no motion along any path.
pub fn plan_timed(
    scene: &Scene,
    ends: [Pose; 2],
    first: PlanResult,
    (options, minimise): (&PlanOptions, Minimise),
    given: &MotionSpec,
    watch: &Watch,
) -> Result<TimedPlan, Error> {
    let timed = motion_along(scene, &first, given, watch);
    let (duration, seed) = (timed.as_ref().ok().map(Trajectory::duration), options.seed);
    let mut best = timed.map(|trajectory| TimedPlan {
        result: first,
        first_seed: seed,
        trajectory,
        seed,
        room: 0.0,
        tried: 1,
        duration_of_first: duration,
    });
    if minimise == Minimise::Length || matches!(&best, Err(error) if error.class() != ErrorClass::Input) {
        return best;
    }
    let (mut tried, first_seed) = (usize::from(best.is_ok()), seed);
    for (room, seed) in others(scene, given, seed)? {
        let Some(result) = another(scene, ends, &PlanOptions { seed, ..options.clone() }, room, watch)? else {
            continue;
        };
        match motion_along(scene, &result, given, watch) {
            Ok(trajectory) => {
                tried += 1;
                if best.as_ref().map_or(true, |best| trajectory.duration() < FASTER * best.trajectory.duration()) {
                    best = Ok(TimedPlan {
                        result,
                        trajectory,
                        seed,
                        first_seed,
                        room,
                        tried,
                        duration_of_first: duration,
                    });
                }
            }
            Err(error) if error.class() == ErrorClass::Input => {}
            Err(error) => return Err(error),
        }
    }
    best.map(|plan| TimedPlan { tried, ..plan })
}

/// The motion along a planned path.
fn motion_along(scene: &Scene, path: &PlanResult, given: &MotionSpec, watch: &Watch) -> Result<Trajectory, Error> {
    match path.orientations.is_empty() {
        true => Trajectory::new(scene, &path.waypoints, given, watch),
        false => Trajectory::of_poses(scene, &path.poses(scene.orientation()), given, watch),
    }
}

/// Additional clearances and seeds.
fn others(scene: &Scene, given: &MotionSpec, seed: u64) -> Result<Vec<(f64, u64)>, Error> {
    let room = Limits::of(scene, given)?.blend;
    let seeds: Vec<u64> = (0..=SEEDS).map(|k| seed.wrapping_add(k)).collect();
    let more = seeds.iter().filter(|_| room > 0.0).map(|&seed| (room, seed));
    Ok(more.chain(seeds[1..].iter().map(|&seed| (0.0, seed))).collect())
}

/// The path of a seed with additional clearance, if there is one.
fn another(
    scene: &Scene,
    [start, goal]: [Pose; 2],
    options: &PlanOptions,
    room: f64,
    watch: &Watch,
) -> Result<Option<PlanResult>, Error> {
    let wider;
    let scene = match room > 0.0 {
        false => scene,
        true => match scene.with_clearance(scene.spec().clearance.unwrap_or(0.0) + room) {
            Ok(scene) => {
                wider = scene;
                &wider
            }
            Err(_) => return Ok(None),
        },
    };
    let options = PlanOptions { proof: false, ..options.clone() };
    let query = Query::of(scene).from(start.position).to(goal.position);
    let query = query.oriented([start, goal].map(|end| Some(end.orientation)));
    let found = plan(query, &options, &|| (watch.interrupted)())?.result;
    watch.check()?;
    Ok((found.status == Status::Solved).then_some(found))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::hard1;

    #[test]
    fn the_fastest_motion_is_never_slower_than_that_of_the_shortest_path() {
        let scene = hard1();
        let limits =
            MotionSpec { speed: Some(1.0), acceleration: Some(2.0), blend: Some(0.03), ..MotionSpec::default() };
        let options = PlanOptions::default();
        let query = Query::of(&scene);
        let first = plan(query, &options, &()).unwrap().result;
        let kept = |minimise| {
            let ends = query.poses().unwrap();
            plan_timed(&scene, ends, first.clone(), (&options, minimise), &limits, &Watch::NONE).unwrap()
        };
        let (short, fast) = (kept(Minimise::Length), kept(Minimise::Time));
        assert_eq!((short.tried, short.duration_of_first), (1, Some(short.trajectory.duration())));
        assert!(fast.tried > 2 && fast.trajectory.duration() <= short.trajectory.duration());
        assert_eq!(fast.duration_of_first, short.duration_of_first);
    }
}
