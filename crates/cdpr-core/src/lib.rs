//! Planning, checking and running paths of cable-driven parallel robots among obstacles.
//!
//! Modules in reading order; each uses only those before it.
#![doc = ""]

pub mod error;
pub mod geometry;
pub mod numerics;

pub use error::{Error, ErrorClass};
