//! Proof that convex parts cover a piece, by other means than those that made the parts; and what is missing where the
//! proof fails.
//!
//! The cells divide space, and each polygon of the surface belongs to one of them. A part covers the surface in a cell if
//! it contains the corners of its polygons. It covers the body in the cell if the region of the cell above each of its
//! facets is free of the body: that region is convex and contains no surface (which is below the facet), so the winding
//! number of the surface is the same everywhere in it, and zero at one place means zero at all.

use std::sync::Arc;

use super::cell::Cell;
use crate::error::Error;
use crate::geometry::convex::clip::{Polyhedron, clipped};
use crate::geometry::surface::MeshPiece;
use crate::geometry::{Aabb, HalfSpace, Point, Polytope};
use crate::tolerances::GAP_TOLERANCE;
use crate::watch::Watch;

/// Allowance for rounding, m: what lies no farther above a facet counts as covered.
pub(super) const ROOM: f64 = 0.5 * GAP_TOLERANCE;

/// Maximum number of pieces of a triangle outside some bodies that are compared with others.
const MOST_PIECES_OF_A_WALL: usize = 1000;

/// The part of a box in a cell; `None` if it is thinner than rounding.
pub(super) fn polyhedron(cell: &Cell, aabb: &Aabb) -> Option<Polyhedron> {
    let mut body = Polyhedron::cuboid(aabb)?;
    for side in &cell.sides {
        body.cut(side)?;
    }
    Some(body)
}

/// Points that a convex body must also enclose in order to cover a piece within some cells; none if it covers it.
/// `aabb` is the box around the piece; points on a cell's sides may be `on_plane` metres off.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub(super) fn missing(
    piece: &MeshPiece,
    cells: &[Arc<Cell>],
    body: &Polytope,
    (aabb, on_plane): (&Aabb, f64),
    watch: &Watch,
) -> Result<Vec<Point>, Error> {
    let planes = body.half_spaces();
    let mut missing = Vec::new();
    for cell in cells {
        watch.check()?;
        let outside = |p: &&Point| planes.iter().any(|plane| plane.height(p) > ROOM + on_plane);
        missing.extend(cell.points.iter().filter(outside));
        if piece.volume.is_some()
            && let Some(whole) = polyhedron(cell, aabb)
        {
            for plane in &planes {
                if let Some(beyond) = body_above(piece, &whole, plane, on_plane) {
                    missing.extend(beyond);
                }
            }
        }
    }
    Ok(missing)
}

/// Corners of the region of a cell above a facet, if it belongs to the body.
fn body_above(piece: &MeshPiece, cell: &Polyhedron, facet: &HalfSpace, on_plane: f64) -> Option<Vec<Point>> {
    let low = 2.0 * (ROOM + on_plane);
    let corners: Vec<Point> = cell.corners().collect();
    let heights = corners.iter().map(|v| facet.height(v));
    let (highest, height) = heights.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
    if height <= low {
        return None;
    }
    // Between the highest corner and the middle of the cell, at least half as high as the corner.
    let middle = cell.middle();
    let fall = height - facet.height(&middle);
    let share = if fall > height { 0.5 * height / fall } else { 0.5 };
    if !piece.distance.encloses(&(corners[highest] + (middle - corners[highest]) * share)) {
        return None;
    }
    let mut region = cell.clone();
    region.cut(&HalfSpace { normal: -facet.normal, offset: -facet.offset }).map(|()| region.corners().collect())
}

/// Whether convex bodies together contain a triangle, except for `on_plane` metres.
pub(super) fn contain(bodies: &[Polytope], triangle: &[Point; 3], on_plane: f64) -> bool {
    let aabb = Aabb::around(triangle);
    let mut left = vec![triangle.to_vec()];
    for body in bodies.iter().filter(|body| !body.aabb().apart_by(&aabb, ROOM)) {
        left = left.into_iter().flat_map(|polygon| outside(polygon, body, ROOM + on_plane)).collect();
        if left.is_empty() || left.len() > MOST_PIECES_OF_A_WALL {
            break;
        }
    }
    left.is_empty()
}

/// Convex polygons that cover what a convex polygon has outside a body.
fn outside(polygon: Vec<Point>, body: &Polytope, room: f64) -> Vec<Vec<Point>> {
    let planes = body.half_spaces();
    let above = |polygon: &[Point], plane: &HalfSpace| polygon.iter().all(|p| plane.height(p) >= room);
    if planes.iter().any(|plane| above(&polygon, plane)) {
        return vec![polygon];
    }
    let (mut inside, mut pieces) = (polygon, Vec::new());
    for plane in &planes {
        let height = |p: &Point| plane.height(p) - room;
        if inside.iter().all(|p| height(p) <= 0.0) {
            continue;
        }
        pieces.push(clipped(&inside, |p| -height(p)));
        inside = clipped(&inside, height);
        if inside.is_empty() {
            break;
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::convex::clip::box_sides;
    use crate::geometry::{convex_mesh, pieces};

    fn span(from: f64, to: f64) -> Aabb {
        Aabb { min: Point::from([from; 3]), max: Point::from([to; 3]) }
    }

    fn hull(corners: &[[f64; 3]]) -> Polytope {
        Polytope::hull_of(&corners.iter().map(|p| Point::from(*p)).collect::<Vec<_>>()).unwrap()
    }

    fn cube(from: f64, to: f64) -> Vec<[f64; 3]> {
        let side = |k: usize, axis: usize| if k >> axis & 1 == 1 { to } else { from };
        (0..8).map(|k| std::array::from_fn(|axis| side(k, axis))).collect()
    }

    #[test]
    fn uncovered_points_are_reported_missing() {
        let mesh = convex_mesh(&[], &span(0.0, 1.0)).unwrap();
        let piece = pieces(&mesh, &Watch::NONE).unwrap().0.remove(0);
        let surface = Cell::whole(&piece.triangles, &vec![0; piece.triangles.len()], &Watch::NONE).unwrap();
        let within = |sides: Aabb| {
            let mut cell = Cell::whole(&[], &[], &Watch::NONE).unwrap();
            cell.sides = box_sides(&sides).to_vec();
            cell
        };
        let (inner, beside) = (within(span(0.25, 0.75)), within(span(1.25, 1.5)));
        let cells = [surface, inner, beside].map(Arc::new);
        let missing = |k: usize, body: &Polytope| {
            missing(&piece, &cells[k..=k], body, (&span(-2.0, 2.0), 0.0), &Watch::NONE).unwrap()
        };
        let cut: Vec<[f64; 3]> = cube(0.0, 1.0).into_iter().filter(|p| p.iter().sum::<f64>() < 3.0).collect();
        assert_eq!(missing(0, &hull(&cube(0.0, 1.0))), []);
        assert!(missing(0, &hull(&cut)).contains(&Point::new(1.0, 1.0, 1.0)));
        assert!(missing(0, &hull(&cube(0.0, 1.0 - 1e-6))).contains(&Point::new(1.0, 1.0, 1.0)));
        // No surface in these cells: all body in one, all void in the other.
        assert_eq!(missing(1, &hull(&cube(0.25, 0.75))), []);
        assert!(missing(1, &hull(&cube(0.25, 0.75 - 1e-6))).contains(&Point::new(0.75, 0.75, 0.75)));
        assert_eq!(missing(2, &hull(&cube(0.0, 0.1))), []);
    }

    #[test]
    fn a_triangle_is_contained_by_bodies_together() {
        let triangle = [[0.1, 0.5, 0.1], [1.9, 0.5, 0.1], [1.9, 0.5, 0.9]].map(Point::from);
        let moved = |x: f64| cube(0.0, 1.0).into_iter().map(|[a, b, c]| [a + x, b, c]).collect::<Vec<_>>();
        let (left, right) = (hull(&moved(0.0)), hull(&moved(1.0)));
        assert!(contain(&[left.clone(), right.clone()], &triangle, 0.0));
        assert!(!contain(std::slice::from_ref(&left), &triangle, 0.0) && !contain(&[right], &triangle, 0.0));
        assert!(!contain(&[left, hull(&moved(1.0 + 1e-6))], &triangle, 0.0));
    }
}
