//! A string over a triangle: the shortest path from one corner to another that passes the forbidden polyhedra on the
//! side of the third.
//!
//! A plane cuts convex polyhedra in convex polygons. If the path u → v → w is free, the region that they leave on the
//! side of v is bounded by the convex hull of u, w and the polygons inside the triangle, and so is the string. Its
//! corners are corners of polygons, which lie on edges of polyhedra.

use super::Bend;
use crate::error::Error;
use crate::forbidden::{Frame, HPolyhedra, HPolyhedron, Near, Place, Polygon, edge_direction};
use crate::geometry::{Point, Vector};
use crate::tolerances::{GRAZING, SAME_POINT};
use crate::watch::Watch;

/// Scratch memory for one pull, reused for the next.
#[derive(Debug, Default)]
pub struct Pull {
    polygon: Polygon,
    found: Vec<(Place, Option<Vector>)>,
    near: Near,
}

impl Pull {
    /// Replaces `chain` by the corners of the tightened string u → v → w; empty if v is not needed at all. Returns false if
    /// time runs out before they are known.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn over(
        &mut self,
        hulls: &HPolyhedra,
        [u, v, w]: [&Point; 3],
        chain: &mut Vec<Bend>,
        watch: &Watch,
    ) -> Result<bool, Error> {
        chain.clear();
        let Some((frame, top, length)) = framed(u, v, w) else { return Ok(true) };
        self.found.clear();
        // A hull that contains a valid waypoint is too large there, and useless for finding a path around it.
        let in_the_way =
            |hull: &&HPolyhedron| !hull.apart(&[*u, *v, *w]) && ![u, v, w].into_iter().any(|p| hull.holds(p));
        let mut near = std::mem::take(&mut self.near);
        let Some(found) = hulls.near_in_time(&[*u, *v, *w], &mut near, watch)? else { return Ok(false) };
        for hull in found.filter(in_the_way) {
            self.cut(hull, &frame, [[0.0, 0.0], [length, 0.0], top]);
            self.collect(hull);
        }
        self.near = near;
        self.wrap(&frame, length, chain);
        Ok(true)
    }

    /// The polygon that a hull cuts out of the triangle.
    fn cut(&mut self, hull: &HPolyhedron, frame: &Frame, triangle: [Place; 3]) {
        self.polygon.begin(triangle);
        for (index, plane) in hull.planes().iter().enumerate() {
            self.polygon.clip(frame.height(plane), Some(index));
            if self.polygon.corners().is_empty() {
                return;
            }
        }
    }

    /// The corners of the polygon with the edges of the hull on which they lie.
    fn collect(&mut self, hull: &HPolyhedron) {
        for [before, corner] in self.polygon.with_previous() {
            let edge = match (before.line, corner.line) {
                (Some(i), Some(j)) if i != j => edge_direction(&hull.planes()[i], &hull.planes()[j]),
                _ => None,
            };
            self.found.push((corner.place, edge));
        }
    }

    /// The upper side of the convex hull of u, w and all corners, from u to w: R. A. Jarvis (1973).
    fn wrap(&self, frame: &Frame, length: f64, chain: &mut Vec<Bend>) {
        let end = [length, 0.0];
        let mut at = [0.0, 0.0];
        for _ in 0..=self.found.len() {
            let (mut next, mut edge) = (end, None);
            for (place, along) in &self.found {
                let (ahead, there) = (minus(&next, &at), minus(place, &at));
                let left = ahead[0] * there[1] - ahead[1] * there[0];
                if there[0].hypot(there[1]) > SAME_POINT && left > GRAZING * ahead[0].hypot(ahead[1]) {
                    (next, edge) = (*place, *along);
                }
            }
            let rest = minus(&next, &end);
            if rest[0].hypot(rest[1]) <= SAME_POINT {
                return;
            }
            chain.push(Bend::new(frame.point(&next), edge));
            at = next;
        }
    }
}

fn minus(a: &Place, b: &Place) -> Place {
    [a[0] - b[0], a[1] - b[1]]
}

/// The frame of a triangle, x along u → w, v above; v in it, and the length of the base. `None` if the triangle is
/// flat.
fn framed(u: &Point, v: &Point, w: &Point) -> Option<(Frame, Place, f64)> {
    let (base, arm) = (w - u, v - u);
    let length = base.norm();
    let along = base.try_normalize(SAME_POINT)?;
    let side = arm - along * arm.dot(&along);
    let across = side.try_normalize(SAME_POINT)?;
    Some((Frame { origin: *u, along, across }, [arm.dot(&along), side.norm()], length))
}
