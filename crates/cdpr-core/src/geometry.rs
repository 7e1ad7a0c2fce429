//! Convex bodies and queries on pairs of them: distance (GJK), overlap depth (separating axes), contact; triangle
//! meshes and the convex parts that replace them.

mod convex;
pub(crate) mod convex_parts;
mod leeway;
mod pairs;
mod pose;
mod pulley;
pub mod quadratic;
pub mod seam;
pub mod surface;
mod triangle_mesh;

pub use convex::{
    Aabb, Cone, Cuboid, Facet, HalfSpace, Polytope, PolytopeError, Shadow, convex_mesh, convex_volume, shadow,
    wedge_mesh,
};
pub(crate) use convex::{as_list, farthest};
pub use convex_parts::{ConvexParts, convex_parts};
pub use leeway::{Leeway, TurnBounds};
pub use pairs::{
    CableSweep, ConvexShape, Fan, Proximity, SupportMap, Swept, Triangle, distance, gjk, proximity, segment_segment,
    separating_axes,
};
pub use pose::{
    Apart, Placed, PlacedBody, Pose, PoseMotion, TurnedSweep, Turning, TurningPiece, from_roll_pitch_yaw,
    rotation_as_written, turn_about, wxyz, wxyz_in_turn,
};
pub use pulley::{Departure, Pulley};
pub use quadratic::Quadratic;
pub use surface::{Faults, MeshPiece, pieces};
pub use triangle_mesh::TriangleMesh;

/// A position in the world or platform frame, m.
pub type Point = nalgebra::Point3<f64>;
/// A displacement, m, or a direction.
pub type Vector = nalgebra::Vector3<f64>;
/// Rotation from the platform frame to the world frame.
pub type Rotation = nalgebra::UnitQuaternion<f64>;

/// Where the shortest path between two positions over a line crosses it, as a distance from `point` along the unit
/// vector `along`, m. The path is straight once the two half-planes are unfolded into one plane.
pub fn shortest_over(point: &Point, along: &Vector, places: [&Point; 2]) -> f64 {
    let [(a, height_a), (b, height_b)] = places.map(|place| {
        let foot = along.dot(&(place - point));
        (foot, (place - (point + along * foot)).norm())
    });
    if height_a + height_b > 0.0 { (a * height_b + b * height_a) / (height_a + height_b) } else { a }
}

/// The largest distance of any of these points from one, m; 0 if there are none.
pub(crate) fn largest_distance(points: &[Point], from: &Point) -> f64 {
    points.iter().map(|point| (point - from).norm()).fold(0.0, f64::max)
}

/// Length of a path of straight segments, m.
pub fn path_length(waypoints: &[Point]) -> f64 {
    waypoints.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
}
