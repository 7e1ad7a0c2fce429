//! Planning, checking and running paths of cable-driven parallel robots (CDPRs) among obstacles.
//!
//! A platform hangs on cables that leave fixed outlets. A path of the platform is free if platform and cables stay
//! clear of obstacles and of each other all along it. The method follows Bak et al., "Collision-free path planning of
//! cable-driven parallel robots in cluttered environments", Intelligent Service Robotics, 2019,
//! doi:10.1007/s11370-019-00278-7, called "the paper" throughout.
//!
//! Modules in reading order, each using only those before it: [`tolerances`], [`limits`], [`geometry`], [`model`], [`kinematics`],
//! [`conditions`], [`collision`], [`wrench`], [`decomposition`], [`proof`], [`forbidden`], [`lower_bound`], [`planning`],
//! [`postprocess`], [`turning`], [`compiled`], [`path`], [`plan`], [`trajectory`], [`path_file`], [`trajectory_file`],
//! [`trajectory_check`], [`survey`], [`new_scene`], [`regions`]. All of them use [`error`], [`choice`], [`words`], [`watch`] and [`batch`];
//! [`testing`] is for examples and tests. Nothing here opens a file: the crate `cdpr-files` reads and writes scenes and
//! paths.

pub mod batch;
pub mod certificate;
pub mod choice;
pub mod collision;
pub mod compiled;
pub mod conditions;
pub mod decomposition;
pub mod error;
pub mod fingerprint;
pub mod fixed_length;
pub mod forbidden;
pub mod geometry;
pub mod kinematics;
pub mod limits;
pub mod lower_bound;
pub mod model;
pub mod new_scene;
pub mod path;
pub mod path_file;
pub mod plan;
pub mod planning;
pub mod postprocess;
pub mod proof;
pub mod regions;
mod simd;
pub mod survey;
pub mod testing;
pub mod tolerances;
pub mod trajectory;
pub mod trajectory_check;
pub mod trajectory_file;
pub mod turning;
pub mod watch;
pub mod words;
pub mod wrench;

pub use choice::Choice;
pub use error::{Error, ErrorClass};
pub use model::{Robot, Scene};

/// Tests the examples in the crate's README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
