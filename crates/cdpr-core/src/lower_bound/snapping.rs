//! Polyhedra in which planes that are equal up to rounding are equal.

use std::collections::HashMap;

use crate::forbidden::HPolyhedron;
use crate::geometry::{HalfSpace, Point};
use crate::numerics::SAME_PLANE;
use crate::proof::Widened;

/// The widened polyhedra. Of planes that are equal before they are moved outward, all become the innermost, so that the
/// polyhedra become smaller, if anything. Faces of the platform's and of the cables' polyhedra often lie in one plane.
pub fn snapped<'p>(
    polyhedra: impl Iterator<Item = &'p Widened>,
    low: Point,
    high: Point,
) -> impl Iterator<Item = HPolyhedron> {
    let polyhedra: Vec<&Widened> = polyhedra.collect();
    let extent = low.coords.abs().sup(&high.coords.abs()).norm();
    let mut same: HashMap<[i64; 4], HalfSpace> = HashMap::new();
    for (certain, plane) in polyhedra.iter().flat_map(|polyhedron| polyhedron.certain.iter().zip(&polyhedron.planes)) {
        let known = same.entry(key(certain)).or_insert(*plane);
        let turned = (plane.normal - known.normal).norm();
        known.offset = known.offset.min(plane.offset - turned * extent);
    }
    let snapped =
        |polyhedron: &Widened| HPolyhedron::exact(polyhedron.certain.iter().map(|plane| same[&key(plane)]).collect());
    polyhedra.iter().map(|polyhedron| snapped(polyhedron)).collect::<Vec<_>>().into_iter()
}

fn key(plane: &HalfSpace) -> [i64; 4] {
    let HalfSpace { normal, offset } = plane;
    [normal.x, normal.y, normal.z, *offset].map(|number| (number / SAME_PLANE).round() as i64)
}
