//! Forbidden positions as convex polyhedra: their edges, and an index that finds those near a segment.

mod h_polyhedra;
mod h_polyhedron;
mod polygon;

pub use h_polyhedra::{HPolyhedra, Near, Room};
pub use h_polyhedron::{Edge, HPolyhedron, edge_direction, gaps, in_box, meeting_line};
pub use polygon::{Frame, Place, Polygon};
