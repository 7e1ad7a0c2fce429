//! The required wrenches along straight motions: whether they are available everywhere, and by what margin.

mod cells;
mod certify;
mod checker;
pub mod constraint;
mod facets;
mod measure;
mod over;

pub use certify::{certified, first_failure, least_slack, slack_reaches, verdict};
pub use checker::{WrenchChecker, with_wrench};
pub use constraint::{WrenchConstraint, limit_at, measures, measures_at, measures_by, required};
pub use measure::{BEND, Measure, MotionVerdict, largest_sum, sagging};
