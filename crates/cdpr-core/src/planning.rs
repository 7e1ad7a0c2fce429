//! Sampling-based planners: functions of problem, validity, options and random generator that return an outcome.
//!
//! They depend only on the traits [`crate::collision::Validity`] and [`StateSpace`], not on an engine or a geometry.

pub mod anytime;
mod bidirectional;
pub(crate) mod modified_rrt;
pub(crate) mod neighbours;
pub(crate) mod outcome;
pub(crate) mod planner;
pub(crate) mod rrt;
pub mod rrt_connect;
pub(crate) mod rrt_star;
pub mod search;
pub(crate) mod space;
pub(crate) mod tree;
pub(crate) mod two_trees;

pub use anytime::{AnytimeOptions, PathOptimizer, anytime};
pub use modified_rrt::{ModifiedRrtOptions, modified_rrt};
pub use neighbours::Neighbours;
pub use outcome::{Improved, Milestone, Outcome, Status};
pub use planner::{Planner, PlannerOptions, PlannerSettings};
pub use rrt::{RrtOptions, rrt};
pub use rrt_connect::{RrtConnectOptions, rrt_connect};
pub use rrt_star::{RrtStarOptions, rrt_star};
pub use search::{Limits, Until};
pub use space::{Problem, StateSpace, TranslationSpace};
pub use tree::SearchTree;
pub use two_trees::{TwoTreesOptions, two_trees};
