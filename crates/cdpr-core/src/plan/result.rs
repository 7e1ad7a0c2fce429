//! The result of planning.

use std::sync::Arc;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Improved, NoPath};
use crate::choices;
use crate::collision::{Validity, Violation, worst_first};
use crate::compiled::positions;
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::planning::{Milestone, Outcome, SearchTree, Status};

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

/// The searches of one call, reported as one: counts and times are sums, and each search begins where the one before ended.
#[derive(Default)]
pub(super) struct Searches(Stats);

impl Searches {
    /// Reports the paths of the next search that are shorter than this, m.
    pub(super) fn shorter_than<'a>(
        &self,
        shortest: f64,
        improved: &'a Improved,
    ) -> impl Fn(f64, f64, &[Point]) + use<'a> {
        let before = self.seconds();
        move |seconds, cost, path| {
            if cost < shortest {
                improved(before + seconds, cost, path);
            }
        }
    }

    /// Adds a search; its history then counts from the start of the first one.
    pub(super) fn add(&mut self, found: &mut PlanResult) {
        let (before, own) = (self.seconds(), found.stats);
        for milestone in &mut found.history {
            milestone.seconds += before;
            milestone.samples += self.0.samples;
        }
        self.0 = Stats {
            nodes: self.0.nodes + own.nodes,
            motion_checks: self.0.motion_checks + own.motion_checks,
            samples: self.0.samples + own.samples,
            planning_seconds: self.0.planning_seconds + own.planning_seconds,
            post_seconds: self.0.post_seconds + own.post_seconds,
        };
    }

    /// Counts and times of all searches.
    pub(super) fn stats(&self) -> Stats {
        self.0
    }

    fn seconds(&self) -> f64 {
        self.0.planning_seconds + self.0.post_seconds
    }
}

/// What found a path.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum FoundBy {
    /// The planner found the path.
    #[default]
    Planner,
    /// The decision whether there is a path found it: the planner found none, but a chain of free cells is one.
    Decision,
    /// It is a given path, which is still valid.
    Kept,
    /// It is a given path, parts of which were planned anew.
    Repaired,
}

choices!(FoundBy, "finder", [
    Planner = "planner": "The planner",
    Decision = "decision": "The decision whether there is a path",
    Kept = "kept": "A given path, which is still valid",
    Repaired = "repaired": "A given path, parts of which were planned anew",
]);

/// How wide a widest path is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct Widest {
    /// The smallest clearance of the path from obstacles, m, over the pairs to which
    /// [`with_obstacle_clearance`](crate::model::Scene::with_obstacle_clearance) applies.
    pub clearance: f64,
    /// It is proved that no path keeps this clearance, m; `None` if the search was stopped before anything was proved.
    pub none_above: Option<f64>,
    /// Only paths of at most this length, m, are meant; `None` if all are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub longest: Option<f64>,
    /// The end that does not keep `none_above` itself: 0 for the start, 1 for the goal.
    #[serde(skip)]
    pub narrow_end: Option<usize>,
}

/// What a path through via points, or to one of several goals, passes.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct RouteFound {
    /// For each via point, the index of its waypoint; empty without a path.
    pub via: Vec<usize>,
    /// The goal that it leads to, counted from 0, if there were several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub goal: Option<usize>,
    /// Without a path: the leg that has none, counted from 0, and the number of legs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leg: Option<[usize; 2]>,
}

/// Result of planning.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanResult {
    /// How planning ended.
    pub status: Status,
    /// What found the path, if there is one.
    pub found_by: FoundBy,
    /// All violations at an invalid start or goal, worst first.
    pub reasons: Vec<Violation>,
    /// A valid position near an invalid start or goal, if one was found, m.
    pub nearest_valid: Option<Point>,
    /// Why there is no path, if that was proved.
    pub no_path: Option<Arc<NoPath>>,
    /// If no path was found and none was proved impossible: every path passes an opening narrower than this, m, if
    /// known.
    pub opening_below: Option<f64>,
    /// Lower bound of the length of all paths at the orientation of this path, m, if the planner computed one.
    pub lower_bound: Option<f64>,
    /// Clearance that the path keeps in addition to that of the scene, m; 0 unless a timed motion needed more room.
    pub added_clearance: f64,
    /// How wide the path is, if the widest one was asked for.
    pub widest: Option<Widest>,
    /// The via points on the path and the goal it leads to, if these were asked for; see [`plan_route`](super::plan_route).
    pub route: Option<RouteFound>,
    /// The final path; empty unless solved.
    pub path: Vec<Pose>,
    /// Length of the final path, m; NaN unless solved.
    pub cost: f64,
    /// The planner's path before post-processing; empty unless solved.
    pub raw_path: Vec<Pose>,
    /// Length of the planner's path, m; NaN unless solved.
    pub raw_cost: f64,
    /// The planner's tree, shared by all rewindings of its path; empty if start or goal is invalid.
    pub tree: Arc<SearchTree<Point>>,
    /// When the planner's path improved, first to last.
    pub history: Vec<Milestone>,
    /// Counts and times.
    pub stats: Stats,
}

impl PlanResult {
    /// The positions of the final path, m.
    pub fn waypoints(&self) -> Vec<Point> {
        positions(&self.path)
    }

    /// The positions of the planner's path, m.
    pub fn raw_waypoints(&self) -> Vec<Point> {
        positions(&self.raw_path)
    }

    /// The result if the caller asks to stop before the search begins.
    pub fn interrupted() -> Self {
        PlanResult::unsolved(Status::Interrupted, Stats::default())
    }

    /// This result, for callers who have no use for a search that was cut short before it had a path.
    ///
    /// # Errors
    /// [`Error::interrupted`] in place of [`Status::Interrupted`].
    pub fn unless_interrupted(self) -> Result<Self, Error> {
        if self.status == Status::Interrupted { Err(Error::interrupted()) } else { Ok(self) }
    }

    /// The result if time runs out before the search begins.
    pub fn out_of_time() -> Self {
        PlanResult::unsolved(Status::BudgetSpent, Stats::default())
    }

    /// The worst violation at an invalid start or goal.
    pub fn reason(&self) -> Option<&Violation> {
        self.reasons.first()
    }

    /// The result if the start or the goal is not valid.
    pub(super) fn invalid_end<S>(engine: &(impl Validity<S> + ?Sized), [start, goal]: [&S; 2]) -> Option<Self> {
        let ends = [(start, Status::StartInvalid), (goal, Status::GoalInvalid)];
        let (end, status) = ends.into_iter().find(|(end, _)| !engine.state_valid(end))?;
        let reasons = worst_first(engine.violations(end, end));
        Some(PlanResult { reasons, ..PlanResult::unsolved(status, Stats::default()) })
    }

    /// The result of a search without its path; `place` gives the position of a state.
    pub(super) fn searched<S>(outcome: Outcome<S>, planning_seconds: f64, place: impl Fn(S) -> Point) -> Self {
        let Outcome { status, tree, motion_checks, samples, history, lower_bound, .. } = outcome;
        let stats = Stats { nodes: tree.states.len(), motion_checks, samples, planning_seconds, post_seconds: 0.0 };
        let tree = SearchTree { states: tree.states.into_iter().map(place).collect(), parents: tree.parents };
        PlanResult { tree: Arc::new(tree), history, lower_bound, ..PlanResult::unsolved(status, stats) }
    }

    pub(super) fn unsolved(status: Status, stats: Stats) -> Self {
        let (cost, raw_cost) = (f64::NAN, f64::NAN);
        let tree = Arc::default();
        PlanResult {
            status,
            found_by: FoundBy::Planner,
            reasons: Vec::new(),
            nearest_valid: None,
            no_path: None,
            opening_below: None,
            lower_bound: None,
            added_clearance: 0.0,
            widest: None,
            route: None,
            path: Vec::new(),
            cost,
            raw_path: Vec::new(),
            raw_cost,
            tree,
            history: Vec::new(),
            stats,
        }
    }
}
