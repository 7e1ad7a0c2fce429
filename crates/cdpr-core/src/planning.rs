//! Sampling-based planners: [`PlannerOptions::search`] returns the outcome of one of them for a problem and a random generator.
//!
//! Planners depend only on the traits [`crate::collision::Validity`] and [`StateSpace`], not on an engine or a
//! geometry. Each is a function of a `Search`: it draws samples and checks motions only through it, calls
//! `Search::over` once per turn of its loop, and returns `Search::outcome` or `Search::ended`. Once time runs out, `Search::collision_free`
//! returns false for every motion and the next `Search::over` ends the loop, so such answers must not be kept as collisions.

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

pub use anytime::PathOptimizer;
pub use neighbours::Neighbours;
pub use outcome::{Improved, Milestone, Outcome, Status};
pub use planner::{Method, Planner, PlannerOptions, PlannerSettings};
pub use rrt::RrtOptions;
pub use rrt_star::RrtStarOptions;
pub use search::{SearchLimits, Until};
pub use space::{Problem, StateSpace, TranslationSpace};
pub use tree::SearchTree;
