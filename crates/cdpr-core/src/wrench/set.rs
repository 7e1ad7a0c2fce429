//! The set of wrenches that the cables can exert at a position: how far required wrenches are from its boundary, its
//! facets, and its shape.

mod capacity;
mod demands;
mod kernel;
mod margins;
mod surface;

pub use capacity::CapacityMargin;
pub use demands::{Demand, DemandFacets, FacetPair, TensionShare, Turned};
pub use margins::{BindingFacet, Required, capacity_limit, force_limit, moment_limit};
pub use surface::{AvailableSet, force_set, moment_set};
