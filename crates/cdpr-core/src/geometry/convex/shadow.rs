//! The obstacle shadow: the points where a cable from a fixed outlet cannot end, because it would pass through a body.
//!
//! Source: the paper, section 3.1 and Figure 3, which draws the region; this module computes it.

use super::half_space::HalfSpace;
use crate::geometry::{Point, Polytope, Vector};
use crate::tolerances::{GRAZING, PARALLEL};

/// A shadow as an intersection of open half-spaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Shadow {
    /// The planes through the apex and the silhouette, then the facets that face the apex.
    pub half_spaces: Vec<HalfSpace>,
    /// Sine of the largest angle by which rounding lets the body protrude from a silhouette plane.
    pub tilt: f64,
}

/// The points x for which the segment from `apex` to x meets the interior of a body: the body and everything behind it,
/// `K ⊕ cone(K - apex)`. `None` if no facet faces the apex (which is inside the body, or in the plane of a flat one).
///
/// A facet whose plane contains the apex does not face it: the planes through its other edges are equivalent.
///
/// # Example
/// ```
/// use cdpr_core::{Point, geometry::{Polytope, shadow}};
/// let cube = Polytope::cuboid([2.0; 3])?;
/// let shadow = shadow(&cube, &Point::new(0.0, 0.0, 5.0)).unwrap();
/// let hidden = |x, y, z| shadow.half_spaces.iter().all(|h| h.height(&Point::new(x, y, z)) < 0.0);
/// assert!(hidden(0.0, 0.0, -9.0) && !hidden(0.0, 0.0, 2.0));
/// assert!(hidden(1.4, 0.0, -1.0) && !hidden(1.6, 0.0, -1.0)); // the upper rim is at 4 m, the ray passes 1.5 at 6 m
/// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
/// ```
pub fn shadow(body: &Polytope, apex: &Point) -> Option<Shadow> {
    let vertices = body.vertices();
    let facing: Vec<_> = body.facets().iter().filter(|f| f.height(apex) > GRAZING).collect();
    if facing.is_empty() {
        return None;
    }
    let edges: Vec<[usize; 2]> = facing.iter().flat_map(|f| f.edges()).collect();
    let silhouette = edges.iter().filter(|[i, j]| !edges.contains(&[*j, *i]));
    let mut half_spaces: Vec<HalfSpace> = silhouette
        .filter_map(|&[i, j]| through_edge(apex, &vertices[i], &vertices[j]))
        .map(|normal| HalfSpace::through(apex, normal))
        .collect();
    let rays: Vec<Vector> = vertices.iter().map(|v| (v - apex).normalize()).collect();
    let tilts = half_spaces.iter().flat_map(|h| rays.iter().map(|ray| h.normal.dot(ray)));
    let tilt = tilts.fold(0.0, f64::max);
    half_spaces.extend(facing.iter().map(|f| HalfSpace { normal: f.normal, offset: f.offset }));
    Some(Shadow { half_spaces, tilt })
}

/// Outward unit normal of the plane through the apex and an edge that runs counter-clockwise around the silhouette;
/// `None` for an edge in line with the apex, which appears as a corner.
fn through_edge(apex: &Point, from: &Point, to: &Point) -> Option<Vector> {
    let (a, b) = (from - apex, to - apex);
    // The side between the closer end and the edge has the smallest rounding error.
    let (nearer, edge) = (if a.norm_squared() <= b.norm_squared() { a } else { b }, to - from);
    let cross = nearer.cross(&edge);
    let norm = cross.norm();
    (norm > PARALLEL * nearer.norm() * edge.norm()).then(|| cross / norm)
}
