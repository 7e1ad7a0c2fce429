//! Planning, checking and running paths of cable-driven parallel robots (CDPRs) among obstacles.
//!
//! A platform hangs on cables that leave fixed outlets. A path of the platform is free if platform and cables stay
//! clear of obstacles and of each other all along it. The method follows Bak et al., "Collision-free path planning of
//! cable-driven parallel robots in cluttered environments", Intelligent Service Robotics, 2019,
//! doi:10.1007/s11370-019-00278-7, called "the paper" throughout.
//!
//! # Start here
//!
//! ```
//! use cdpr_core::nalgebra::Vector3;
//! use cdpr_core::{CompiledScene, PlanOptions, Point, Scene, SceneSpec, Status, Watch, check, plan};
//!
//! let spec: SceneSpec = serde_json::from_str(r#"{
//!     "version": 1,
//!     "workspace": {"min": [0, 0, 0], "max": [2, 2, 2]},
//!     "robot": {
//!         "platform": [{"box": [0.2, 0.2, 0.2]}],
//!         "cables": [
//!             {"outlet": [0, 1, 2], "attachment": [-0.1, 0, 0.1]},
//!             {"outlet": [2, 1, 2], "attachment": [0.1, 0, 0.1]}
//!         ]
//!     },
//!     "obstacles": [{"name": "pillar", "box": [0.2, 0.2, 1.2], "position": [1, 1, 0.6]}],
//!     "query": {"start": [0.4, 1, 0.9], "goal": [1.6, 1, 0.9]}
//! }"#)?; // plain data: here by serde_json, or built in code
//! let scene = Scene::new(spec)?; // checked once
//! let planned = plan(&scene, &PlanOptions::default(), &())?;
//! assert_eq!(planned.result.status, Status::Solved);
//!
//! let compiled = planned.compiled.expect("there is no time limit"); // shared by all further questions
//! let report = check(&compiled, &planned.result.path, &Watch::NONE)?;
//! assert!(report.path.valid);
//! let above: Point = scene.start().unwrap() + Vector3::new(0.0, 0.0, 0.5);
//! assert!(compiled.level().state_valid(&above));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`Scene`] and [`Robot`] are checked once; [`SceneSpec`] and [`RobotSpec`] are the same as plain data.
//! - [`plan()`] answers a [`Query`]; [`Planned`] has the scene, as given and as compiled, and the result.
//! - A path is a list of [`Pose`]s. [`check()`], [`shorten`], [`lengths_along`], [`tensions_along`] and [`Trajectory`] take any path; a
//!   translation is a path that keeps the orientation of the scene ([`held`]).
//! - [`CompiledScene`] is a scene with the engines that check motions in it: make one, and ask it many questions.
//! - Long work polls a [`Watch`]: a deadline, and a function that returns true to stop. [`plan()`] takes an [`Observer`] instead, which can
//!   stop the search and sees every better path. A search that is stopped still returns the best path it has.
//! - Errors are [`Error`]s, which say where, what was found and what was expected.
//!
//! Lengths are in m, angles in rad, forces in N. Nothing here opens a file: the crate `cdpr-files` reads and writes scenes and paths.
//! Items that are not on this page are for the other crates of this project, and may change with any version.

#[doc(hidden)]
pub mod batch;
#[doc(hidden)]
pub mod certificate;
#[doc(hidden)]
pub mod choice;
#[doc(hidden)]
pub mod collision;
#[doc(hidden)]
pub mod compiled;
#[doc(hidden)]
pub mod conditions;
#[doc(hidden)]
pub mod decomposition;
#[doc(hidden)]
pub mod error;
#[doc(hidden)]
pub mod fingerprint;
#[doc(hidden)]
pub mod fixed_length;
#[doc(hidden)]
pub mod forbidden;
#[doc(hidden)]
pub mod geometry;
#[doc(hidden)]
pub mod kinematics;
#[doc(hidden)]
pub mod limits;
#[doc(hidden)]
pub mod lower_bound;
#[doc(hidden)]
pub mod model;
#[doc(hidden)]
pub mod new_scene;
#[doc(hidden)]
pub mod path;
#[doc(hidden)]
pub mod path_file;
#[doc(hidden)]
pub mod plan;
#[doc(hidden)]
pub mod planning;
#[doc(hidden)]
pub mod postprocess;
#[doc(hidden)]
pub mod proof;
#[doc(hidden)]
pub mod regions;
mod simd;
#[doc(hidden)]
pub mod survey;
#[doc(hidden)]
pub mod task;
#[doc(hidden)]
pub mod testing;
#[doc(hidden)]
pub mod tolerances;
#[doc(hidden)]
pub mod tour;
#[doc(hidden)]
pub mod trajectory;
#[doc(hidden)]
pub mod trajectory_check;
#[doc(hidden)]
pub mod trajectory_file;
#[doc(hidden)]
pub mod turning;
#[doc(hidden)]
pub mod watch;
#[doc(hidden)]
pub mod words;
#[doc(hidden)]
pub mod workspace;
#[doc(hidden)]
pub mod wrench;

pub use nalgebra;

pub use choice::Choice;
pub use collision::path_check::{PathClearance, PathReport, PathViolation};
pub use collision::{Checker, Clearance, Engine, Interference, Kind, Validity, Violation, nearest_valid};
pub use compiled::CompiledScene;
pub use error::{Error, ErrorClass};
pub use geometry::{Point, Pose, Rotation, Vector, rotation_as_written, wxyz};
pub use lower_bound::Forbidden;
pub use model::spec::{BodySpec, CableSpec, MotionSpec, QuerySpec, RobotSpec, SceneSpec, WorkspaceSpec, WrenchSpec};
pub use model::{Cable, Obstacle, Robot, RobotSource, Scene};
pub use path::{CheckReport, check, held, lengths_along, tensions_along};
pub use path_file::PathFile;
pub use plan::{
    Appraisal, Maximise, NoPath, Observer, PlanOptions, PlanResult, Planned, Post, Processing, Query, Stats, Widest,
    appraise, lower_bound, plan, plan_widest, shorten,
};
pub use planning::{Planner, PlannerOptions, PlannerSettings, Status};
pub use tour::{TourOptions, plan_tour};
pub use trajectory::{Minimise, TimedPlan, Trajectory, plan_timed};
pub use trajectory_check::{Recorded, TrajectoryReport, TrajectoryRules, check_trajectory};
pub use trajectory_file::TrajectoryFile;
pub use watch::Watch;
pub use wrench::{PathWrench, Required, WrenchMap, WrenchReport, wrench_of_scene_at};

/// Tests the examples in the crate's README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
