//! Checks whether a motion keeps all conditions and, if not, which ones it breaks, where and by how much.
//!
//! [`crate::conditions`] lists the conditions of a scene at a fixed orientation. An engine checks motions against that
//! list; planners only use the trait [`Validity`].

pub(crate) mod along;
pub(crate) mod clearance;
pub(crate) mod cspace;
mod explain;
pub(crate) mod gjk_engine;
pub mod many;
mod nearby;
pub mod path_check;
pub(crate) mod validity;
pub(crate) mod violation;

pub use crate::conditions::{Condition, Conditions, Demand, Exemption, Interference, Kind, Piece, Polyhedron, Reason};
pub use clearance::{Clearance, Tightest, path_clearance, tightest, tightest_at_pose, tightest_of};
pub use cspace::CspaceEngine;
pub use gjk_engine::GjkEngine;
pub use many::{clearances, motions_valid, states_valid};
pub use nearby::{nearest_valid, valid_nearby};
pub use path_check::{PathReport, check_path};
pub use validity::{Checker, Engine, Validity};
pub use violation::{Violation, WrenchLimit, worst_first};
