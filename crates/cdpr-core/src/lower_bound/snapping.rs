//! Polyhedra in which planes that are equal up to rounding are equal.

use std::collections::HashMap;

use crate::forbidden::HPolyhedron;
use crate::geometry::{HalfSpace, Point};
use crate::tolerances::SAME_PLANE;

/// The planes of a polyhedron, before and after they are moved outward.
pub struct Moved<'p> {
    pub before: &'p [HalfSpace],
    pub after: Vec<HalfSpace>,
}

/// The moved polyhedra. Planes that are equal before they are moved are all replaced by the innermost of them, so the polyhedra
/// can only become smaller. Faces of the platform's and of the cables' polyhedra often lie in one plane.
pub fn snapped(polyhedra: &[Moved], low: Point, high: Point) -> impl Iterator<Item = HPolyhedron> {
    let extent = low.coords.abs().sup(&high.coords.abs()).norm();
    let mut same: HashMap<[i64; 4], HalfSpace> = HashMap::new();
    for (before, plane) in polyhedra.iter().flat_map(|polyhedron| polyhedron.before.iter().zip(&polyhedron.after)) {
        let known = same.entry(key(before)).or_insert(*plane);
        let turned = (plane.normal - known.normal).norm();
        known.offset = known.offset.min(plane.offset - turned * extent);
    }
    let snapped = move |moved: &Moved| HPolyhedron::exact(moved.before.iter().map(|plane| same[&key(plane)]).collect());
    polyhedra.iter().map(snapped)
}

fn key(plane: &HalfSpace) -> [i64; 4] {
    let HalfSpace { normal, offset } = plane;
    [normal.x, normal.y, normal.z, *offset].map(|number| (number / SAME_PLANE).round() as i64)
}
