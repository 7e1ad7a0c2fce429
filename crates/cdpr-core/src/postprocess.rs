//! Making any waypoint path shorter.

pub mod rewind;

pub use rewind::{Order, RewindOptions, rewind};
