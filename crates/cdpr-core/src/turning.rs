//! A platform that turns: motions from pose to pose, proved free as a whole, and the space in which to plan them.
//!
//! `TurningEngine::motion_valid` halves a motion until `PhysicalCondition::kept_during_turn` proves each piece, from the deviations
//! of `geometry::TurningPiece`; `allowed` and `turning_wrench` do likewise for orientations and wrenches. An engine is "level" at the
//! orientation of the scene, which need not be horizontal.

mod allowed;
mod engine;
mod nearest;
mod pose_curve;
mod pose_space;
mod shorten;
mod turning_wrench;

pub use allowed::AllowedTurns;
pub use engine::TurningEngine;
pub use pose_curve::{Derivatives, PoseCurve};
pub use pose_space::{PoseSpace, pose_distance, turn_weight};
pub use shorten::PoseShortener;
pub use turning_wrench::TurningWrench;
