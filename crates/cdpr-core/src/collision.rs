//! What a motion must satisfy, and the engines that answer whether it does.
//!
//! [`constraint`] lists, for a scene at fixed orientation, who must keep away from whom and how (the conditions of
//! sections 3.1 and 3.2 of the paper). An engine answers them; planners know only the trait [`Validity`].

pub mod batch;
pub mod cable_cable;
pub mod constraint;
pub mod cspace;
pub mod exempt;
mod explain;
pub mod forbidden;
pub mod gjk_engine;
pub mod path_check;
pub mod validity;

pub use constraint::{Constraint, Constraints, Demand};
pub use cspace::CspaceEngine;
pub use exempt::{Exemption, Reason};
pub use explain::tightest;
pub use gjk_engine::GjkEngine;
pub use path_check::{PathReport, check_path};
pub use validity::{
    Checker, Clearance, Engine, Interference, Kind, Piece, Polyhedra, Validity, Violation, WrenchLimit,
};
