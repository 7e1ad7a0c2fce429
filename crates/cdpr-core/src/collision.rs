//! Checks whether a motion keeps all conditions and, if not, which ones it breaks, where and by how much.
//!
//! [`crate::conditions`] lists the conditions of a scene at a fixed orientation. An engine checks motions against that
//! list; planners only use the trait [`Validity`].
//!
//! During a straight translation the platform sweeps the convex hull of its two end positions and a cable sweeps a
//! triangle, both exactly, so one convex query decides a whole motion (the paper, section 3.1). `Conditions::new`
//! computes everything that does not depend on the position: the rotated platform and attachments, the pairs that touch
//! by construction, and those that can never keep the required distance (`exempt`). An engine then tests each condition
//! on the list, cheap ones first.
//!
//! Motions are translations, given by their two ends as in OMPL's `MotionValidator`; [`crate::turning`] proves motions
//! with a turn on pieces of them. Required wrenches are not on the list: they concern all cables at once, forbid no
//! polyhedra, have no gap in metres, and cost more than all other tests together. `WrenchChecker` checks them last.

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

pub use crate::conditions::{
    CableDemand, Condition, Conditions, Exemption, Interference, Kind, Piece, Polyhedron, Reason,
};
pub use clearance::{Clearance, Tightest, path_clearance, tightest, tightest_at_pose, tightest_of};
pub use cspace::CspaceEngine;
pub use gjk_engine::GjkEngine;
pub use many::{clearances, motions_valid, states_valid};
pub use nearby::{nearest_valid, valid_nearby};
pub use path_check::{PathReport, check_path};
pub use validity::{Checker, Engine, FacetBounds, Slack, Unproved, Validity};
pub use violation::{Violation, WrenchLimit, worst_first};
