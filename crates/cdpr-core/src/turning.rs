//! A platform that turns: motions from pose to pose, proved free as a whole, and the space in which to plan them.

mod allowed;
mod check;
mod engine;
mod nearest;
mod pose_curve;
mod pose_rows;
mod pose_space;
mod pose_wrench;
mod shorten;
mod turning_wrench;

pub use allowed::AllowedTurns;
pub use check::{check_poses, nearest_of_poses, pose_path_length};
pub use engine::TurningEngine;
pub use pose_curve::{Derivatives, PoseCurve};
pub use pose_rows::{lengths_along_poses, tensions_along_poses};
pub use pose_space::{PoseSpace, turn_weight};
pub use pose_wrench::wrench_of_poses;
pub use shorten::PoseShortener;
pub use turning_wrench::TurningWrench;
