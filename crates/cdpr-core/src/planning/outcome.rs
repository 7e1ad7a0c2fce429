//! How planning can end.

use serde::Serialize;

use super::tree::SearchTree;

/// How a well-posed planning question can end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// A path was found.
    Solved,
    /// The samples or the time ran out first.
    BudgetSpent,
    /// The start is not a valid state.
    StartInvalid,
    /// The goal is not a valid state.
    GoalInvalid,
}

/// What a planner found.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome<State> {
    /// How it ended.
    pub status: Status,
    /// The path from start to goal; empty unless solved.
    pub waypoints: Vec<State>,
    /// The tree as it was at the end; if solved, the goal is its last node. Of planners with two trees, that of the start
    /// and then that of the goal.
    pub tree: SearchTree<State>,
    /// Motions that were checked.
    pub motion_checks: usize,
    /// Random samples that were drawn.
    pub samples: usize,
    /// When the path got better, first to last; one entry where the first path ends the search.
    pub history: Vec<Milestone>,
}

/// A path that was better than those before.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Milestone {
    /// Time since the search began, s.
    pub seconds: f64,
    /// Samples drawn by then.
    pub samples: usize,
    /// Length of the path, m.
    pub cost: f64,
}
