//! Shortening of waypoint paths.

pub mod rewind;
pub mod string_pulling;
pub mod trace;

pub use rewind::{Order, RewindOptions, rewind};
pub use string_pulling::StringPuller;
pub use trace::{Trace, Try, rewind_traced};
