//! Wrench feasibility: what the cables can exert, what they must, and how far the one is from the other (the paper,
//! section 3.3).

pub mod capacity;
mod kernel;
pub mod margins;
pub mod statics;
pub mod zonotope;

pub use capacity::CapacityMargin;
pub use margins::{Limit, Required, capacity_limit, force_limit, moment_limit};
pub use statics::{Loads, StaticCable, Statics};
