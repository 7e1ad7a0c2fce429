//! Wrench feasibility: the wrenches that the cables can exert, the wrenches that they must exert, and the margin
//! between them (the paper, section 3.3).
//!
//! The available wrench set at a position is a zonotope. `zonotope` enumerates its facets by definition, for any number
//! of cables, any rank, and three or six dimensions: it is the reference for everything else here, and is itself tested
//! against linear programs and pycapacity. `kernel` computes the same margin some thirty times faster for six to eight
//! cables, at four positions at once; where it is not sure, the definition decides. `certify` proves motions, from bounds
//! of the slack between positions (docs/understand/wrench.md has the proof). `WrenchChecker` combines this with an engine
//! for geometry, so that planners need not know about wrenches. Tensions come from a dual active-set method in the null
//! space of W (`active_set`), with clarabel as a fallback (`interior_point`); the smallest p-norm from Newton's
//! method on top of it (`norm`).

pub mod map;
mod motion;
pub mod report;
mod set;
mod settling;
mod statics;
mod tensions;
pub mod zonotope;

pub use map::{MapIdentity, MapOptions, MapSummary, WrenchMap};
pub use motion::{
    BEND, Measure, MotionVerdict, WrenchChecker, WrenchConstraint, certified, constraint, first_failure, largest_sum,
    least_slack, limit_at, measures, measures_at, measures_by, required, sagging, slack_reaches, verdict, with_wrench,
};
pub use report::{LengthRow, PathWrench, TensionRow, WrenchReport, wrench_at, wrench_of_scene_at};
pub use set::{
    AvailableSet, BindingFacet, CapacityMargin, Demand, DemandFacets, FacetPair, Required, TensionShare, Turned,
    capacity_limit, force_limit, force_set, moment_limit, moment_set,
};
pub use settling::Settling;
pub use statics::{FreeMotion, Hold, Holding, Loads, Origin, Part, StaticCable, Statics};
pub use tensions::{Balance, FeasibilityLp, LargestScale, QpMethod, ScaleLp, TensionQp};
