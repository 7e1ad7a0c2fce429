//! Wrench feasibility: the wrenches that the cables can exert, the wrenches that they must exert, and the margin
//! between them (the paper, section 3.3).

mod active_set;
pub(crate) mod capacity;
mod cells;
pub(crate) mod certify;
pub(crate) mod checker;
pub mod constraint;
mod demand_facets;
mod facets;
pub mod hold;
mod interior_point;
mod kernel;
pub mod linear_program;
mod loads;
pub mod map;
pub mod map_identity;
pub mod margins;
pub mod measure;
pub(crate) mod set_mesh;
mod slice;
pub(crate) mod statics;
pub mod tension_qp;
pub mod tensions;
pub mod zonotope;

pub use capacity::CapacityMargin;
pub use certify::{Verdict, certified, first_failure, least_slack, slack_reaches, verdict};
pub use checker::WrenchChecker;
pub use constraint::{WrenchConstraint, limit_at, measures, measures_by, required};
pub use demand_facets::{Demand, DemandFacets, FacetPair, TensionShare, Turned};
pub use hold::{FreeMotion, Hold, Holding};
pub use linear_program::{Balance, FeasibilityLp, LargestScale, ScaleLp};
pub use loads::Loads;
pub use map::{MapOptions, MapSummary, WrenchMap};
pub use map_identity::MapIdentity;
pub use margins::{BindingFacet, Required, capacity_limit, force_limit, moment_limit};
pub use measure::{BEND, Measure, sagging};
pub use set_mesh::{AvailableSet, force_set, moment_set};
pub use statics::{StaticCable, Statics};
pub use tension_qp::{QpMethod, TensionQp};
pub use tensions::{LengthRow, PathWrench, TensionRow, WrenchReport, wrench_at, wrench_of_scene_at};
