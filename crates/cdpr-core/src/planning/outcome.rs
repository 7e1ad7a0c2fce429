//! The possible outcomes of planning.

use serde::Serialize;

use super::tree::SearchTree;
use crate::choices;

/// How a well-posed planning problem can end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// A path was found.
    Solved,
    /// The limit on samples or time was reached first.
    BudgetSpent,
    /// The caller asked to stop before there was a path.
    Interrupted,
    /// There is no path: it was proved.
    NoPath,
    /// The start is not a valid state.
    StartInvalid,
    /// The goal is not a valid state.
    GoalInvalid,
}

choices!(Status, "status", [
    Solved = "solved": "A path was found",
    BudgetSpent = "budget_spent": "The limit on samples or time was reached first",
    Interrupted = "interrupted": "The search was asked to stop before there was a path",
    NoPath = "no_path": "There is no path: it was proved",
    StartInvalid = "start_invalid": "The start is not a valid state",
    GoalInvalid = "goal_invalid": "The goal is not a valid state",
]);

/// The outcome of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome<State> {
    /// How the search ended.
    pub status: Status,
    /// The path from start to goal; empty unless solved.
    pub waypoints: Vec<State>,
    /// The tree at the end of the search; if solved, the goal is its last node. For planners with two trees: the tree
    /// of the start, followed by that of the goal.
    pub tree: SearchTree<State>,
    /// Number of motion checks.
    pub motion_checks: usize,
    /// Number of random samples.
    pub samples: usize,
    /// Every improvement of the path, in order; one entry if the search ends with the first path.
    pub history: Vec<Milestone>,
    /// Lower bound of the length of all paths, m, if the planner computed one.
    pub lower_bound: Option<f64>,
}

/// Called with every path that is shorter than all before: seconds since the start, its length in m, the path.
pub type Improved<'a, State> = dyn Fn(f64, f64, &[State]) + 'a;

/// A path that was shorter than all before.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Milestone {
    /// Time since the search began, s.
    pub seconds: f64,
    /// Samples drawn so far.
    pub samples: usize,
    /// Length of the path, m.
    pub cost: f64,
}
