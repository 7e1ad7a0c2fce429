//! Planning where the scene leaves the orientation open.

use super::{PlanOptions, PlanResult, Stats, end, engine_within, lower_bound, plan_heard};
use crate::collision::Checker;
use crate::error::{Error, ErrorClass};
use crate::geometry::Point;
use crate::model::Scene;
use crate::planning::{Listener, Status};
use crate::watch::{Interrupt, Watch};

/// What planning found, and the scene at the orientation that it chose.
pub struct Planned {
    /// The scene at that orientation.
    pub scene: Scene,
    /// The engine that answered for it; none if time was over before it was there.
    pub engine: Option<Box<dyn Checker>>,
    /// What was found there; the counts and the time are those of all orientations.
    pub result: PlanResult,
}

/// Plans the query of a scene at the orientation with the shortest path: at each of [`Scene::choices`] in turn, but for
/// those whose lower bound says that no path there is shorter than the best so far. What is left of the budget, which
/// begins with the call, is shared evenly by the orientations that are left.
///
/// # Errors
/// As [`super::plan`]. Once there is a path, an interruption is no error: the best path so far is the answer.
///
/// # Example
/// ```
/// use cdpr_core::plan::{PlanOptions, plan_choosing};
/// let planned = plan_choosing(&cdpr_core::testing::hard1(), &PlanOptions::default(), &|| false, &|_, _, _| {})?;
/// assert!((planned.result.cost - 2.435167).abs() < 1e-3);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan_choosing(
    scene: &Scene,
    options: &PlanOptions,
    interrupted: &Interrupt,
    listener: &Listener<Point>,
) -> Result<Planned, Error> {
    let whole = options.watch(interrupted);
    let choices = scene.choices();
    let mut best: Option<Planned> = None;
    let mut total = Stats::default();
    for (k, scene) in choices.iter().enumerate() {
        let share = whole.left().map(|left| left / (choices.len() - k) as u32);
        let watch = Watch::on(interrupted).with_budget(share);
        let shortest = best.as_ref().map_or(f64::INFINITY, Planned::length);
        let before = total.planning_seconds + total.post_seconds;
        let heard = |seconds: f64, cost: f64, path: &[Point]| {
            if cost < shortest {
                listener(before + seconds, cost, path);
            }
        };
        let (engine, mut result) = match at_one(scene, options, shortest, &watch, &heard) {
            Ok(Some(found)) => found,
            Ok(None) => continue,
            Err(stopped) if stopped.class() == ErrorClass::Interrupted && shortest < f64::INFINITY => break,
            Err(error) => return Err(error),
        };
        total = total.and(&result.stats);
        result.history.iter_mut().for_each(|milestone| milestone.seconds += before);
        let found = Planned { scene: scene.clone(), engine, result };
        best = Some(match best {
            Some(best) if !found.better_than(&best) => best,
            _ => found,
        });
    }
    let best = best.expect("the first of the orientations is always planned");
    Ok(Planned { result: PlanResult { stats: total, ..best.result }, ..best })
}

/// The engine, unless time was over before it was there, and the answer.
type Found = (Option<Box<dyn Checker>>, PlanResult);

/// Plans at one orientation; none if no path there is shorter than the shortest so far.
fn at_one(
    scene: &Scene,
    options: &PlanOptions,
    shortest: f64,
    watch: &Watch,
    listener: &Listener<Point>,
) -> Result<Option<Found>, Error> {
    let engine = match engine_within(scene, options.engine, options.interference, watch) {
        Err(error) if error.class() == ErrorClass::OutOfTime => return Ok(Some((None, PlanResult::out_of_time()))),
        engine => engine?,
    };
    if shortest < f64::INFINITY {
        let start = end("start", options.start, scene.start())?;
        let goal = end("goal", options.goal, scene.goal())?;
        if lower_bound(&*engine, &start, &goal, watch)? >= shortest {
            return Ok(None);
        }
    }
    let result = plan_heard(&*engine, scene, options, watch, listener)?;
    Ok(Some((Some(engine), result)))
}

impl Planned {
    /// Length of the path, m; infinite if there is none.
    fn length(&self) -> f64 {
        if self.result.status == Status::Solved { self.result.cost } else { f64::INFINITY }
    }

    /// The shorter path; without one, the answer that tells more.
    fn better_than(&self, other: &Planned) -> bool {
        let rank = |status: Status| match status {
            Status::Solved => 0,
            Status::BudgetSpent => 1,
            Status::GoalInvalid => 2,
            Status::StartInvalid => 3,
        };
        let (own, others) = (rank(self.result.status), rank(other.result.status));
        own < others || own == others && self.length() < other.length()
    }
}

impl Stats {
    /// Counts and times of two runs.
    fn and(&self, other: &Stats) -> Stats {
        Stats {
            nodes: self.nodes + other.nodes,
            motion_checks: self.motion_checks + other.motion_checks,
            samples: self.samples + other.samples,
            planning_seconds: self.planning_seconds + other.planning_seconds,
            post_seconds: self.post_seconds + other.post_seconds,
        }
    }
}
