//! Wrench feasibility: what the cables can exert, what they must, and how far the one is from the other (the paper,
//! section 3.3).

pub mod capacity;
mod cells;
pub mod certify;
pub mod checker;
pub mod constraint;
mod kernel;
pub mod margins;
pub mod measure;
pub mod statics;
pub mod zonotope;

pub use capacity::CapacityMargin;
pub use certify::{certified, first_failure, least_slack};
pub use checker::WrenchChecker;
pub use constraint::{WrenchConstraint, measures};
pub use margins::{Limit, Required, capacity_limit, force_limit, moment_limit};
pub use measure::Measure;
pub use statics::{Loads, StaticCable, Statics};
