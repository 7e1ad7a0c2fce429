//! Sampling planners: functions of problem, validity, options and generator, returning an outcome.
//!
//! They know the trait [`crate::collision::Validity`], not the engine behind it, and a [`StateSpace`], not its geometry.

pub mod modified_rrt;
pub mod outcome;
pub mod space;
pub mod tree;

pub use modified_rrt::{ModifiedRrtOptions, modified_rrt};
pub use outcome::{Outcome, Status, Watch};
pub use space::{Problem, StateSpace, TranslationSpace};
