//! Convex bodies and queries on pairs of them: distance (GJK), overlap depth (separating axes), contact.

mod cell;
pub(crate) mod clip;
pub(crate) mod convex_parts;
mod coverage;
mod cuboid;
pub mod features;
pub mod gjk;
pub(crate) mod half_space;
mod hull;
mod inner;
mod inner_hull;
mod mending;
mod merge;
pub(crate) mod mesh;
pub(crate) mod minkowski;
mod part;
pub(crate) mod polytope;
mod pose;
mod reach;
pub mod seam;
pub mod segment_segment;
pub mod separating_axes;
pub(crate) mod shadow;
pub(crate) mod shape;
pub mod solid;
pub(crate) mod surface;
mod welded;
mod wrap;

pub use clip::{convex_mesh, wedge_mesh};
pub use convex_parts::{ConvexParts, convex_parts};
pub use cuboid::Cuboid;
pub use gjk::{Proximity, distance, proximity};
pub use half_space::HalfSpace;
pub use mesh::TriangleMesh;
pub use polytope::{Aabb, Facet, Polytope, PolytopeError};
pub use pose::{
    Apart, Placed, PlacedBody, Pose, PoseMotion, TurnedSweep, Turning, TurningPiece, from_roll_pitch_yaw,
    rotation_as_written, turn_about, wxyz, wxyz_in_turn,
};
pub use shadow::{Shadow, shadow};
pub use shape::{ConvexShape, SupportMap, Swept, Triangle};
pub use surface::{Faults, Piece, pieces};

/// A position in the world or platform frame, m.
pub type Point = nalgebra::Point3<f64>;
/// A displacement, m, or a direction.
pub type Vector = nalgebra::Vector3<f64>;
/// Rotation from the platform frame to the world frame.
pub type Rotation = nalgebra::UnitQuaternion<f64>;

/// Where the shortest path between two positions over a line crosses it, as a distance from `point` along the unit vector
/// `along`, m. The path is straight once the two half-planes are unfolded into one plane.
pub fn shortest_over(point: &Point, along: &Vector, places: [&Point; 2]) -> f64 {
    let [(a, height_a), (b, height_b)] = places.map(|place| {
        let foot = along.dot(&(place - point));
        (foot, (place - (point + along * foot)).norm())
    });
    if height_a + height_b > 0.0 { (a * height_b + b * height_a) / (height_a + height_b) } else { a }
}

/// Length of a path of straight segments, m.
pub fn path_length(waypoints: &[Point]) -> f64 {
    waypoints.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
}
