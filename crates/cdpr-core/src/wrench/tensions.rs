//! Tensions within limits that balance a wrench: whether there are any, the ones nearest to a reference, and by how
//! much wrenches can grow until there are none.

mod active_set;
mod distribution;
mod interior_point;
mod linear_program;
mod norm;
mod quadratic_program;
mod slice;

pub use linear_program::{Balance, FeasibilityLp, LargestScale, ScaleLp};
pub use quadratic_program::{QpMethod, TensionQp};
