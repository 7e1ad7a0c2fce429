//! Which wrenches the cables can balance within their tension limits, and with which tensions.

mod active_set;
mod interior_point;
pub mod linear_program;
mod slice;
pub mod tension_qp;
