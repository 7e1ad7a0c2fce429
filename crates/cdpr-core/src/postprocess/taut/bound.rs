//! A lower bound of the length of all paths, valid or not yet found.
//!
//! Every path from start to goal passes any plane that separates them, at a place that is not forbidden. So it is at
//! least as long as the shortest way over such a place, the minimum of |x - start| + |x - goal| over what the forbidden
//! polygons leave of the plane. That function is convex, so the minimum is where the straight line passes or on a side
//! of a polygon, where it is known in closed form. Any plane gives a bound; the best of many is taken.

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
            let Some([first, last]) = hull.side(&point, &along) else { continue };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polytope, Rotation};
    use rand::{RngExt, SeedableRng};

    /// The least way over free places of a plane, of a fine grid over it.
    fn sampled(plane: &HalfSpace, hulls: &[Hull], low: &Point, high: &Point, ends: [&Point; 2]) -> f64 {
        const STEPS: i32 = 150;
        let across = plane.normal.cross(&Vector::ith(plane.normal.iamin(), 1.0)).normalize();
        let up = plane.normal.cross(&across);
        let origin = Point::from(plane.normal * plane.offset);
        let place =
            |i: i32, j: i32| origin + across * (4.0 * i as f64 / STEPS as f64) + up * (4.0 * j as f64 / STEPS as f64);
        let all = (-STEPS..=STEPS).flat_map(|i| (-STEPS..=STEPS).map(move |j| place(i, j)));
        let in_box = |p: &Point| (0..3).all(|axis| low[axis] <= p[axis] && p[axis] <= high[axis]);
        let free = |p: &Point| !hulls.iter().any(|hull| hull.planes().iter().all(|plane| plane.height(p) < 0.0));
        let ways = all.filter(|p| in_box(p) && free(p)).map(|p| ends.iter().map(|end| (p - *end).norm()).sum());
        ways.fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn what_a_plane_says_is_what_a_grid_over_it_finds() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let (low, high) = (Point::new(0.0, 0.0, 0.0), Point::new(2.0, 2.0, 2.0));
        let (start, goal) = (Point::new(0.2, 1.0, 1.0), Point::new(1.8, 1.0, 1.0));
        let mut told = 0;
        for round in 0..120 {
            let mut hulls: Vec<Hull> = (0..6)
                .map(|_| {
                    let body = Polytope::cuboid([0; 3].map(|_| rng.random_range(0.1..1.2))).unwrap();
                    let axis = Vector::new(rng.random(), rng.random(), rng.random());
                    let at = Vector::new(1.0, rng.random_range(0.2..1.8), rng.random_range(0.2..1.8));
                    Hull::exact(body.transformed(&Rotation::new(axis), &at).half_spaces())
                })
                .collect();
            // Planes that say the same but for rounding, and a hull twice.
            let twins: Vec<HalfSpace> = hulls[0].planes().iter().flat_map(|h| [*h, h.widened(1e-13)]).collect();
            hulls.extend([Hull::exact(twins), hulls[1].clone()]);
            hulls.remove(0);
            let tilt = Vector::new(1.0, rng.random_range(-0.5..0.5), rng.random_range(-0.5..0.5)).normalize();
            let plane = HalfSpace::through(&Point::new(1.0, 1.0, 1.0), tilt);
            let Some(bound) = beyond(&plane, &hulls, &low, &high, &start, &goal) else { continue };
            let grid = sampled(&plane, &hulls, &low, &high, [&start, &goal]);
            assert!(bound <= grid + 1e-9 && (grid - bound < 0.03 || bound > 1e9), "{round}: {bound}, on a grid {grid}");
            told += 1;
        }
        assert!(told > 50, "{told}");
    }
}
