//! Shortening of waypoint paths.

pub mod rewind;
pub mod taut;
pub mod trace;

pub use rewind::{Direction, Order, RewindOptions, rewind, rewind_once};
pub use taut::Taut;
pub use trace::{Trace, Try, rewind_traced};
