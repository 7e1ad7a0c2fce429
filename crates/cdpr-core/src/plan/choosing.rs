//! Planning where the scene leaves the orientation open.

use std::time::Duration;

use super::{PlanOptions, PlanResult, Stats, end, engine_for, lower_bound, plan_heard};
use crate::collision::Checker;
use crate::error::Error;
use crate::geometry::Point;
use crate::model::Scene;
use crate::planning::{Listener, Status};
use crate::watch::Interrupt;

/// What planning found, and the scene at the orientation that it chose.
pub struct Planned {
    /// The scene at that orientation.
    pub scene: Scene,
    /// The engine that answered for it.
    pub engine: Box<dyn Checker>,
    /// What was found there; the counts and the time are those of all orientations.
    pub result: PlanResult,
}

/// Plans the query of a scene at the orientation with the shortest path: at each of [`Scene::choices`] in turn, but for
/// those whose lower bound says that no path there is shorter than the best so far. What is left of a budget for searching is
/// shared evenly by the orientations that are left.
///
/// # Errors
/// As [`super::plan`]. An interruption is none once there is a path.
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
    let choices = scene.choices();
    let mut best: Option<Planned> = None;
    let mut total = Stats::default();
    for (k, scene) in choices.iter().enumerate() {
        let engine = engine_for(scene, options.engine, options.interference)?;
        let shortest = best.as_ref().map_or(f64::INFINITY, Planned::length);
        if shortest < f64::INFINITY && (interrupted() || bound(&*engine, scene, options)? >= shortest) {
            continue;
        }
        let before = total.planning_seconds + total.post_seconds;
        let share =
            |whole: Duration| whole.saturating_sub(Duration::from_secs_f64(before)) / (choices.len() - k) as u32;
        let options = PlanOptions { budget: options.budget.map(share), ..options.clone() };
        let heard = |seconds: f64, cost: f64, path: &[Point]| {
            if cost < shortest {
                listener(before + seconds, cost, path);
            }
        };
        let mut result = match plan_heard(&*engine, scene, &options, interrupted, &heard) {
            Err(_) if shortest < f64::INFINITY && interrupted() => continue,
            result => result?,
        };
        total = total.and(&result.stats);
        result.history.iter_mut().for_each(|milestone| milestone.seconds += before);
        let found = Planned { scene: scene.clone(), engine, result };
        best = Some(match best {
            Some(best) if !found.better_than(&best) => best,
            _ => found,
        });
    }
    let best = best.expect("a scene has at least one orientation");
    Ok(Planned { result: PlanResult { stats: total, ..best.result }, ..best })
}

fn bound(engine: &dyn Checker, scene: &Scene, options: &PlanOptions) -> Result<f64, Error> {
    let start = end("start", options.start, scene.start())?;
    let goal = end("goal", options.goal, scene.goal())?;
    Ok(lower_bound(engine, &start, &goal))
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
