//! Sampling-based planners: functions of problem, validity, options and random generator that return an outcome.
//!
//! They depend only on the traits [`crate::collision::Validity`] and [`StateSpace`], not on an engine or a geometry.

pub mod anytime;
mod bidirectional;
pub mod modified_rrt;
pub mod neighbours;
pub mod outcome;
pub mod planner;
pub mod rrt;
pub mod rrt_connect;
pub mod rrt_star;
pub mod search;
pub mod space;
pub mod tree;
pub mod two_trees;

pub use anytime::{AnytimeOptions, Improved, PathOptimizer, anytime};
pub use modified_rrt::{ModifiedRrtOptions, modified_rrt};
pub use neighbours::Neighbours;
pub use outcome::{Milestone, Outcome, Status};
pub use planner::{Planner, PlannerOptions, PlannerSettings};
pub use rrt::{RrtOptions, rrt};
pub use rrt_connect::{RrtConnectOptions, rrt_connect};
pub use rrt_star::{RrtStarOptions, rrt_star};
pub use search::{Limits, Until};
pub use space::{Problem, StateSpace, TranslationSpace};
pub use tree::SearchTree;
pub use two_trees::{TwoTreesOptions, two_trees};
