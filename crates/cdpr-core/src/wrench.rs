//! Wrench feasibility: the wrenches that the cables can exert, the wrenches that they must exert, and the margin
//! between them (the paper, section 3.3).

pub mod map;
mod motion;
pub mod report;
mod set;
mod statics;
mod tensions;
pub mod zonotope;

pub use map::{MapIdentity, MapOptions, MapSummary, WrenchMap};
pub use motion::{
    BEND, Measure, Verdict, WrenchChecker, WrenchConstraint, certified, constraint, first_failure, least_slack,
    limit_at, measures, measures_by, required, sagging, slack_reaches, verdict,
};
pub use report::{LengthRow, PathWrench, TensionRow, WrenchReport, wrench_at, wrench_of_scene_at};
pub use set::{
    AvailableSet, BindingFacet, CapacityMargin, Demand, DemandFacets, FacetPair, Required, TensionShare, Turned,
    capacity_limit, force_limit, force_set, moment_limit, moment_set,
};
pub use statics::{FreeMotion, Hold, Holding, Loads, StaticCable, Statics};
pub use tensions::{Balance, FeasibilityLp, LargestScale, QpMethod, ScaleLp, TensionQp};
