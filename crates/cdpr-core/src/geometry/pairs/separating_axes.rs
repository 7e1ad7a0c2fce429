//! Overlap depth of two convex polytopes, exactly, by the separating axis theorem.
//!
//! The overlap of two convex sets is the length of the smallest translation that separates them. This translation is
//! perpendicular to a facet of their Minkowski difference, whose normals are the face normals of either set and the
//! cross products of their edges. Trying all of them is exact for any shape, including needles and slivers. Source:
//! Gottschalk, Lin, Manocha, OBBTree, SIGGRAPH 1996, for the theorem; Ericson, Real-Time Collision Detection, section
//! 5.2.1.

use crate::geometry::convex::polytope::unit_cross;
use crate::geometry::{ConvexShape, Vector};

/// Signed separation of two shapes, m, and the unit axis from `a` to `b` on which it was found.
///
/// Positive: a certified lower bound of their distance. Zero or negative: minus the depth of their overlap. Sets whose
/// Minkowski difference is flat (two coplanar segments, for example) can touch but not overlap: the result for them is
/// at most zero if they meet.
pub fn separation(a: &impl ConvexShape, b: &impl ConvexShape) -> (f64, Vector) {
    let mut best = (f64::NEG_INFINITY, Vector::x());
    visit_axes(a, b, |gap, axis| {
        if gap > best.0 {
            best = (gap, axis);
        }
        false
    });
    if best.0 == f64::NEG_INFINITY { (0.0, best.1) } else { best }
}

/// Whether two shapes overlap by more than `depth`, m; stops at the first axis that refutes it.
pub fn overlap_deeper_than(a: &impl ConvexShape, b: &impl ConvexShape, depth: f64) -> bool {
    let mut tried = false;
    let apart = visit_axes(a, b, |gap, _| {
        tried = true;
        gap >= -depth
    });
    tried && !apart
}

/// Calls `stop(gap, axis)` for every candidate axis until it returns true; returns whether it did.
fn visit_axes(a: &impl ConvexShape, b: &impl ConvexShape, mut stop: impl FnMut(f64, Vector) -> bool) -> bool {
    let mut visit = |axis: Vector| {
        let (forth, back) = (gap_along(a, b, &axis), gap_along(a, b, &-axis));
        if forth >= back { stop(forth, axis) } else { stop(back, -axis) }
    };
    for axis in a.normals().chain(b.normals()) {
        if visit(axis) {
            return true;
        }
    }
    for edge_a in a.edges() {
        for edge_b in b.edges() {
            if unit_cross(&edge_a, &edge_b).is_some_and(&mut visit) {
                return true;
            }
        }
    }
    false
}

/// Gap between the far end of `a` and the near end of `b` along a unit axis; negative if they overlap.
#[inline]
pub fn gap_along(a: &impl ConvexShape, b: &impl ConvexShape, axis: &Vector) -> f64 {
    (b.support(&-axis) - a.support(axis)).dot(axis)
}
