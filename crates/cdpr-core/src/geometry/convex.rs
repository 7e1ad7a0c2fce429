//! Convex polytopes and polyhedra: hulls, half-spaces, and bodies made from others.

pub(super) mod clip;
mod cuboid;
mod half_space;
pub(super) mod hull;
mod minkowski;
pub(super) mod polytope;
mod shadow;

pub use clip::{convex_mesh, convex_volume, wedge_mesh};
pub use cuboid::Cuboid;
pub use half_space::HalfSpace;
pub use polytope::{Aabb, Facet, Polytope, PolytopeError};
pub(crate) use polytope::{as_list, farthest};
pub use shadow::{Cone, Shadow, shadow};
