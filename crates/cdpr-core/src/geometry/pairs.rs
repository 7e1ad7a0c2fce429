//! Pairs of convex bodies: distance, overlap depth, contact.

pub(super) mod features;
pub mod gjk;
pub mod segment_segment;
pub mod separating_axes;
pub(super) mod shape;

pub use gjk::{Proximity, distance, proximity};
pub use shape::{CableSweep, ConvexShape, Fan, SupportMap, Swept, Triangle};
