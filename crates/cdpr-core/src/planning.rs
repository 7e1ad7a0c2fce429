//! Sampling planners: functions of problem, validity, options and generator, returning an outcome.
//!
//! They know the trait [`crate::collision::Validity`], not the engine behind it, and a [`StateSpace`], not its geometry.

pub mod modified_rrt;
pub mod neighbours;
pub mod outcome;
pub mod planner;
pub mod rrt;
pub mod rrt_star;
pub mod search;
pub mod space;
pub mod tree;

pub use modified_rrt::{ModifiedRrtOptions, modified_rrt};
pub use neighbours::Neighbours;
pub use outcome::{Outcome, Status, Watch};
pub use planner::{Planner, PlannerOptions, PlannerSettings};
pub use rrt::{RrtOptions, rrt};
pub use rrt_star::{RrtStarOptions, rrt_star};
pub use search::{Limits, Until};
pub use space::{Problem, StateSpace, TranslationSpace};
pub use tree::SearchTree;
