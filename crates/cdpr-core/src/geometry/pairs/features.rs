//! Distance of two disjoint polytopes from their features: the nearest points lie on two edges, or one is a corner
//! above a face of the other. Slow but exact; decides the few cases that GJK leaves undecided because of rounding.

use super::segment_segment;
use crate::geometry::{Point, Vector};

/// Edges and flat faces of a shape. They may include parts of its interior and must include its boundary.
#[derive(Debug, Default, Clone)]
pub struct Boundary {
    /// Edges of the shape; a point is an edge of length zero.
    pub edges: Vec<[Point; 2]>,
    /// Convex polygons on the faces of the shape.
    pub faces: Vec<Vec<Point>>,
}

/// Distance and nearest points of two shapes that do not overlap.
pub fn closest(a: &Boundary, b: &Boundary) -> (f64, Point, Point) {
    let mut best = (f64::INFINITY, Point::origin(), Point::origin());
    let mut consider = |p: Point, q: Point| {
        let distance = (q - p).norm();
        if distance < best.0 {
            best = (distance, p, q);
        }
    };
    for [p0, p1] in &a.edges {
        for [q0, q1] in &b.edges {
            let pair = segment_segment::closest(p0, p1, q0, q1);
            consider(p0 + (p1 - p0) * pair.s, q0 + (q1 - q0) * pair.r);
        }
    }
    for p in a.edges.iter().flatten() {
        b.faces.iter().filter_map(|face| foot(p, face)).for_each(|q| consider(*p, q));
    }
    for q in b.edges.iter().flatten() {
        a.faces.iter().filter_map(|face| foot(q, face)).for_each(|p| consider(p, *q));
    }
    best
}

/// Foot of the perpendicular from a point to a convex polygon, if it falls inside.
fn foot(point: &Point, face: &[Point]) -> Option<Point> {
    let spoke = |i: usize| face[i] - face[0];
    let area: Vector = (1..face.len() - 1).map(|i| spoke(i).cross(&spoke(i + 1))).sum();
    let normal = area.try_normalize(0.0)?;
    let foot = point - normal * normal.dot(&(point - face[0]));
    let inside = (0..face.len()).all(|k| {
        let (p, q) = (face[k], face[(k + 1) % face.len()]);
        normal.dot(&(q - p).cross(&(foot - p))) >= 0.0
    });
    inside.then_some(foot)
}
