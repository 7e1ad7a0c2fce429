//! The obstacle shadow: the points where a cable from a fixed outlet cannot end, because it would pass through a body.
//!
//! Source: the paper, section 3.1 and Figure 3, which draws the region; this module computes it.
//!
//! Seen from a convex set E instead of a point, the shadow is still one convex polyhedron, K ⊕ cone(K ⊕ -E): with weights α and β
//! and μ = α μ₁ + β μ₂, the point α ((1 + μ₁) k₁ - μ₁ e₁) + β ((1 + μ₂) k₂ - μ₂ e₂) is (1 + μ) k - μ e with k between k₁ and k₂
//! and e between e₁ and e₂. Its facets are those of K that face all of E, and planes between K and E that touch both.

use super::half_space::HalfSpace;
use super::polytope::unit_cross;
use crate::geometry::{Point, Polytope, Vector};
use crate::tolerances::{GRAZING, ON_SURFACE, PARALLEL};

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
    let mut half_spaces: Vec<HalfSpace> = (silhouette(body, apex)?.iter())
        .filter_map(|&[i, j]| through_edge(apex, &vertices[i], &vertices[j]))
        .map(|normal| HalfSpace::through(apex, normal))
        .collect();
    let rays: Vec<Vector> = vertices.iter().map(|v| (v - apex).normalize()).collect();
    let tilts = half_spaces.iter().flat_map(|h| rays.iter().map(|ray| h.normal.dot(ray)));
    let tilt = tilts.fold(0.0, f64::max);
    let facing = body.facets().iter().filter(|f| f.height(apex) > GRAZING);
    half_spaces.extend(facing.map(|f| HalfSpace { normal: f.normal, offset: f.offset }));
    Some(Shadow { half_spaces, tilt })
}

/// The shadow of a body seen from a convex set: the points x for which a segment from somewhere in `sources` to x meets the
/// interior of the body. `None` if no facet faces all of the set, or the sum of the bodies cannot be computed.
///
/// # Example
/// ```
/// use cdpr_core::{Point, Vector, geometry::{Polytope, shadow_from}};
/// let cube = Polytope::cuboid([2.0; 3])?;
/// let above = Polytope::hull_of(&[Point::new(-0.5, 0.0, 5.0), Point::new(0.5, 0.0, 5.0)])?;
/// let shadow = shadow_from(&cube, &above).unwrap();
/// let hidden = |x, y, z| shadow.half_spaces.iter().all(|h| h.height(&Point::new(x, y, z)) < 0.0);
/// assert!(hidden(1.7, 0.0, -1.0) && !hidden(1.8, 0.0, -1.0)); // from (-0.5, 5) over the rim (1, 1), 1.75 at -1
/// assert!(hidden(0.0, 1.4, -1.0) && !hidden(0.0, 1.6, -1.0)); // across, the set is a point
/// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
/// ```
pub fn shadow_from(body: &Polytope, sources: &Polytope) -> Option<Shadow> {
    match sources.vertices() {
        [apex] => shadow(body, apex),
        _ => {
            let origin = Point::origin();
            Some(Cone::around(&body.sum(&sources.reflected()).ok()?, &origin)?.added_to(body))
        }
    }
}

/// The directions from a point to a body, as a convex cone.
#[derive(Debug, Clone, PartialEq)]
pub struct Cone {
    /// Outward unit normals of its sides.
    normals: Vec<Vector>,
    /// Unit vectors along its edges.
    rays: Vec<Vector>,
}

impl Cone {
    /// The cone of the directions from `apex` to a body; `None` if no facet faces the apex.
    pub fn around(body: &Polytope, apex: &Point) -> Option<Self> {
        let vertices = body.vertices();
        let silhouette = silhouette(body, apex)?;
        let normals = silhouette.iter().filter_map(|&[i, j]| through_edge(apex, &vertices[i], &vertices[j])).collect();
        let rays = silhouette.iter().map(|&[i, _]| (vertices[i] - apex).normalize()).collect();
        Some(Cone { normals, rays })
    }

    /// The sum of a body and this cone. Each facet is one of the body, a side of the cone moved to the body, or spanned by an
    /// edge of each.
    pub fn added_to(&self, body: &Polytope) -> Shadow {
        let vertices = body.vertices();
        let rises = |n: &Vector| self.rays.iter().map(|ray| n.dot(ray)).fold(f64::NEG_INFINITY, f64::max);
        let around = |n: &Vector| HalfSpace::around(vertices, *n);
        let mut half_spaces: Vec<HalfSpace> = self.normals.iter().map(around).collect();
        let mut edges: Vec<[usize; 2]> =
            body.facets().iter().flat_map(|f| f.edges()).filter(|[i, j]| i < j || !body.has_volume()).collect();
        if body.dimension() == 1 {
            edges.push([0, 1]);
        }
        for [i, j] in edges {
            let Some(along) = (vertices[j] - vertices[i]).try_normalize(0.0) else { continue };
            for normal in self.rays.iter().filter_map(|ray| unit_cross(&along, ray)).flat_map(|n| [n, -n]) {
                let plane = around(&normal);
                let known = |h: &HalfSpace| (h.normal - normal).norm() <= PARALLEL;
                if rises(&normal) <= PARALLEL
                    && plane.height(&vertices[i]) >= -ON_SURFACE
                    && !half_spaces.iter().any(known)
                {
                    half_spaces.push(plane);
                }
            }
        }
        let facing = body.facets().iter().filter(|f| rises(&f.normal) <= PARALLEL);
        half_spaces.extend(facing.map(|f| HalfSpace { normal: f.normal, offset: f.offset }));
        let tilt = half_spaces.iter().map(|h| rises(&h.normal)).fold(0.0, f64::max);
        Shadow { half_spaces, tilt }
    }
}

/// The directed edges of a body around the facets that face a point; `None` if no facet does.
fn silhouette(body: &Polytope, apex: &Point) -> Option<Vec<[usize; 2]>> {
    let facing = body.facets().iter().filter(|f| f.height(apex) > GRAZING);
    let edges: Vec<[usize; 2]> = facing.flat_map(|f| f.edges()).collect();
    let outer = edges.iter().filter(|[i, j]| !edges.contains(&[*j, *i])).copied().collect();
    (!edges.is_empty()).then_some(outer)
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
