//! A lower bound of the length of all paths, valid or not yet found.
//!
//! Every path from start to goal passes any plane that separates them, at a place that is not forbidden. So it is at least
//! as long as the shortest way over such a place, the minimum of |x - start| + |x - goal| over what the forbidden polygons leave of
//! the plane. That function is convex, so the minimum is where the straight line passes or on a side of a polygon, where
//! it is known in closed form. Any plane gives a bound; the best of many is taken.

use super::hull::{Hull, edge_direction, in_box, meeting_line};
use crate::geometry::{HalfSpace, Point, Vector};
use crate::numerics::SAME_POINT;

/// Planes that are tried first: positions along the straight line, and tilts to both sides in two directions.
const POSITIONS: usize = 7;
const TILTS: [f64; 3] = [-0.6, 0.0, 0.6];
/// Rounds in which the best plane is varied, by less and less.
const ROUNDS: usize = 4;

/// A lower bound of the length of all paths between two points in a box that keep out of `hulls`, m; infinite where a
/// plane is closed altogether, so that there is no path.
pub fn lower_bound(hulls: &[Hull], low: &Point, high: &Point, start: &Point, goal: &Point) -> f64 {
    let straight = (goal - start).norm();
    let Some(along) = (goal - start).try_normalize(SAME_POINT) else { return 0.0 };
    let across = along.cross(&Vector::ith(along.iamin(), 1.0)).normalize();
    let up = along.cross(&across);
    let bound = |[at, tilt, lean]: [f64; 3]| {
        let normal = (along + across * tilt + up * lean).normalize();
        let plane = HalfSpace::through(&(start + (goal - start) * at), normal);
        beyond(&plane, hulls, low, high, start, goal).unwrap_or(straight)
    };
    let places = (1..=POSITIONS).map(|k| k as f64 / (POSITIONS + 1) as f64);
    let first = places.flat_map(|at| TILTS.iter().flat_map(move |t| TILTS.iter().map(move |l| [at, *t, *l])));
    let better = |a: (f64, [f64; 3]), b: (f64, [f64; 3])| if b.0 > a.0 { b } else { a };
    let mut best = first.map(|place| (bound(place), place)).fold((straight, [0.5, 0.0, 0.0]), better);
    for round in 1..=ROUNDS {
        let step = 0.5f64.powi(round as i32);
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut place = best.1;
                place[axis] += sign * step * if axis == 0 { 1.0 / (POSITIONS + 1) as f64 } else { TILTS[2] };
                place[0] = place[0].clamp(0.01, 0.99);
                best = better(best, (bound(place), place));
            }
        }
    }
    best.0
}

/// Length of the shortest way from start over a free place of a plane to the goal; none where the plane says nothing.
fn beyond(plane: &HalfSpace, hulls: &[Hull], low: &Point, high: &Point, start: &Point, goal: &Point) -> Option<f64> {
    let (below, above) = (plane.height(start), plane.height(goal));
    let straight = start + (goal - start) * (below / (below - above));
    let hidden = |hull: &Hull| hull.planes().iter().all(|h| h.height(&straight) < 0.0);
    if !(below < 0.0 && above > 0.0 && hulls.iter().any(hidden)) {
        return None;
    }
    let mut shortest = f64::INFINITY;
    for (own, hull) in hulls.iter().enumerate() {
        for side in hull.planes() {
            edge_direction(plane, side)?; // a side along the plane: its place there would be uncertain
            let (point, along) = meeting_line(plane, side)?;
            let [from, to] = in_box(low, high, &point, &along);
            let Some([first, last]) = hull.inside_but(side, &point, &along) else { continue };
            let mut open = vec![[from.max(first), to.min(last)]];
            for (_, other) in hulls.iter().enumerate().filter(|(k, _)| *k != own) {
                if let Some([a, b]) = other.inside(&point, &along) {
                    open = open
                        .iter()
                        .flat_map(|[c, d]| [[*c, d.min(a)], [c.max(b), *d]])
                        .filter(|[c, d]| c <= d)
                        .collect();
                }
            }
            let (s, g) = (along.dot(&(start - point)), along.dot(&(goal - point)));
            let far = |p: &Point, t: f64| (p - (point + along * t)).norm();
            let (ds, dg) = (far(start, s), far(goal, g));
            let unfolded = if ds + dg > 0.0 { (s * dg + g * ds) / (ds + dg) } else { s };
            for [a, b] in open.into_iter().filter(|[a, b]| a <= b) {
                let t = unfolded.clamp(a, b);
                shortest = shortest.min(far(start, t) + far(goal, t));
            }
        }
    }
    Some(shortest)
}
