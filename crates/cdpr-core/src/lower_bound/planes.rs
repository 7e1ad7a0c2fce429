//! A lower bound of the length of all paths.
//!
//! Every path from start to goal crosses any plane that separates them, at a point that is not forbidden. So it is at
//! least as long as the minimum of |x - start| + |x - goal| over the part of the plane that the forbidden polygons
//! leave free. That function is convex, so the minimum is at the crossing of the straight line or on a side of a
//! polygon, where it is known in closed form. Any plane gives a bound; the best of many is used.

use crate::error::Error;
use crate::forbidden::{HPolyhedra, HPolyhedron, Near, edge_direction, in_box, meeting_line};
use crate::geometry::{HalfSpace, Point, Vector, shortest_over};
use crate::tolerances::SAME_POINT;
use crate::watch::Watch;

/// Planes that are tried first: positions along the straight line, and tilts to both sides in two directions.
const POSITIONS: usize = 7;
const TILTS: [f64; 3] = [-0.6, 0.0, 0.6];
/// Rounds in which the best plane is varied, by decreasing amounts.
const ROUNDS: usize = 4;

/// A lower bound of the length of all paths between two points in a box that avoid `hulls`, m; infinite if a plane is
/// completely blocked, so that there is no path. If time runs out, it is the best bound so far.
///
/// # Errors
/// [`Error::interrupted`].
pub fn lower_bound(
    hulls: &HPolyhedra,
    low: &Point,
    high: &Point,
    start: &Point,
    goal: &Point,
    watch: &Watch,
) -> Result<f64, Error> {
    let straight = (goal - start).norm();
    let Some(along) = (goal - start).try_normalize(SAME_POINT) else { return Ok(0.0) };
    let across = along.cross(&Vector::ith(along.iamin(), 1.0)).normalize();
    let up = along.cross(&across);
    let mut section = Section { hulls, low, high, start, goal, near: Near::default() };
    let mut best = (straight, [0.5, 0.0, 0.0]);
    let mut over = false;
    let mut improve = |best: &mut (f64, [f64; 3]), place: [f64; 3]| {
        over = over || watch.expired()?;
        if over {
            return Ok(());
        }
        let [at, tilt, lean] = place;
        let normal = (along + across * tilt + up * lean).normalize();
        let plane = HalfSpace::through(&(start + (goal - start) * at), normal);
        if let Some(bound) = section.beyond(&plane, best.0, watch)? {
            *best = (bound, place);
        }
        Ok::<_, Error>(())
    };
    for k in 1..=POSITIONS {
        for tilt in TILTS {
            for lean in TILTS {
                improve(&mut best, [k as f64 / (POSITIONS + 1) as f64, tilt, lean])?;
            }
        }
    }
    for round in 1..=ROUNDS {
        let step = 0.5f64.powi(round as i32);
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut place = best.1;
                place[axis] += sign * step * if axis == 0 { 1.0 / (POSITIONS + 1) as f64 } else { TILTS[2] };
                place[0] = place[0].clamp(0.01, 0.99);
                improve(&mut best, place)?;
            }
        }
    }
    Ok(best.0)
}

/// The planes that the hulls cut, one after another.
struct Section<'a> {
    hulls: &'a HPolyhedra,
    low: &'a Point,
    high: &'a Point,
    start: &'a Point,
    goal: &'a Point,
    near: Near,
}

/// A side of a polygon that a hull cuts out of a plane, and how short a path through it could be.
struct Side<'a> {
    hull: &'a HPolyhedron,
    point: Point,
    along: Vector,
    range: [f64; 2],
    /// The point on the side's line through which a path is shortest, as a distance along the line.
    unfolded: f64,
    /// Length of the shortest path through the side, m, if the whole side were free.
    least: f64,
}

/// Sides between two checks of the watch.
const POLL: usize = 64;

impl<'a> Section<'a> {
    /// Length of the shortest path from start through a free point of a plane to the goal; `None` if the plane gives no
    /// bound above `known`, m, or time runs out.
    fn beyond(&mut self, plane: &HalfSpace, known: f64, watch: &Watch) -> Result<Option<f64>, Error> {
        let (below, above) = (plane.height(self.start), plane.height(self.goal));
        let way = self.goal - self.start;
        let crossing = self.start + way * (below / (below - above));
        let hidden = |hull: &HPolyhedron| hull.planes().iter().all(|h| h.height(&crossing) < 0.0);
        if !(below < 0.0 && above > 0.0 && self.hulls.near(&[crossing], &mut self.near).any(hidden)) {
            return Ok(None);
        }
        // A path through a point at distance h from the straight line of length d has at least the length √(d² + 4h²),
        // and a point of the plane at distance r from the crossing has h ≥ r sin(angle of line and plane).
        let steepness = plane.normal.dot(&way) / way.norm();
        let radius_of = |length: f64| 0.5 * (length * length - way.norm_squared()).max(0.0).sqrt() / steepness;
        let everything = (self.high - self.low).norm();
        let mut radius = radius_of(known).max(everything / 64.0);
        loop {
            let Some(shortest) = self.shortest_within(plane, &crossing, radius, known, watch)? else { return Ok(None) };
            if shortest <= known {
                return Ok(None);
            }
            if radius_of(shortest) <= radius || radius >= everything {
                return Ok(Some(shortest));
            }
            radius = radius_of(shortest).clamp(2.0 * radius, 8.0 * radius);
        }
    }

    /// The shortest path through free points on sides of the hulls within `radius` of a point of the plane, or any path
    /// no longer than `known`; `None` if time runs out.
    fn shortest_within(
        &mut self,
        plane: &HalfSpace,
        center: &Point,
        radius: f64,
        known: f64,
        watch: &Watch,
    ) -> Result<Option<f64>, Error> {
        let Some(mut sides) = self.sides_within(plane, center, radius) else { return Ok(None) };
        sides.sort_by(|a, b| a.least.total_cmp(&b.least));
        let mut shortest = f64::INFINITY;
        for (k, side) in sides.iter().enumerate() {
            if side.least >= shortest || shortest <= known {
                break;
            }
            if k % POLL == 0 && watch.expired()? {
                return Ok(None);
            }
            for [a, b] in self.open(side) {
                shortest = shortest.min(self.over(side, side.unfolded.clamp(a, b)));
            }
        }
        Ok(Some(shortest))
    }

    /// The sides of the hulls that come near a disc of the plane; `None` if the position of one is uncertain.
    fn sides_within(&mut self, plane: &HalfSpace, center: &Point, radius: f64) -> Option<Vec<Side<'a>>> {
        let across = plane.normal.cross(&Vector::ith(plane.normal.iamin(), 1.0)).normalize();
        let up = plane.normal.cross(&across);
        // The corners of a triangle around the disc.
        let corner = |x: f64, y: f64| center + (across * x + up * y) * radius;
        let corners = [corner(0.0, 2.0), corner(-3f64.sqrt(), -1.0), corner(3f64.sqrt(), -1.0)];
        let mut sides = Vec::new();
        let hulls: Vec<&HPolyhedron> = self.hulls.near(&corners, &mut self.near).collect();
        for hull in hulls {
            for own in hull.planes() {
                edge_direction(plane, own)?; // the position of a side along the plane would be uncertain
                let (point, along) = meeting_line(plane, own)?;
                let [from, to] = in_box(self.low, self.high, &point, &along);
                let Some([first, last]) = hull.side(&point, &along) else { continue };
                let range = [from.max(first), to.min(last)];
                if range[0] <= range[1] {
                    let mut side = Side { hull, point, along, range, unfolded: 0.0, least: 0.0 };
                    side.unfolded = shortest_over(&point, &along, [self.start, self.goal]);
                    side.least = self.over(&side, side.unfolded.clamp(range[0], range[1]));
                    sides.push(side);
                }
            }
        }
        Some(sides)
    }

    /// Length of the path through a point on the line of a side, m.
    fn over(&self, side: &Side, t: f64) -> f64 {
        let place = side.point + side.along * t;
        (place - self.start).norm() + (place - self.goal).norm()
    }

    /// The pieces of a side outside all other hulls.
    fn open(&mut self, side: &Side) -> Vec<[f64; 2]> {
        let ends = side.range.map(|t| side.point + side.along * t);
        let mut open = vec![side.range];
        for other in self.hulls.near(&ends, &mut self.near).filter(|other| !std::ptr::eq(*other, side.hull)) {
            if let Some([a, b]) = other.inside(&side.point, &side.along) {
                let left = open.iter().flat_map(|[c, d]| [[*c, d.min(a)], [c.max(b), *d]]).filter(|[c, d]| c <= d);
                open = left.collect();
            }
        }
        open
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polytope, Rotation};
    use rand::{RngExt, SeedableRng};

    /// The shortest path through free points of a plane, found on a fine grid.
    fn sampled(plane: &HalfSpace, hulls: &[HPolyhedron], low: &Point, high: &Point, ends: [&Point; 2]) -> f64 {
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
    fn plane_bounds_match_a_fine_grid() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let (low, high) = (Point::new(0.0, 0.0, 0.0), Point::new(2.0, 2.0, 2.0));
        let (start, goal) = (Point::new(0.2, 1.0, 1.0), Point::new(1.8, 1.0, 1.0));
        let mut told = 0;
        for round in 0..120 {
            let mut hulls: Vec<HPolyhedron> = (0..6)
                .map(|_| {
                    let body = Polytope::cuboid([0; 3].map(|_| rng.random_range(0.1..1.2))).unwrap();
                    let axis = Vector::new(rng.random(), rng.random(), rng.random());
                    let at = Vector::new(1.0, rng.random_range(0.2..1.8), rng.random_range(0.2..1.8));
                    HPolyhedron::exact(body.transformed(&Rotation::new(axis), &at).half_spaces())
                })
                .collect();
            // Planes that are equal up to rounding, and a hull twice.
            let twins: Vec<HalfSpace> = hulls[0].planes().iter().flat_map(|h| [*h, h.widened(1e-13)]).collect();
            hulls.extend([HPolyhedron::exact(twins), hulls[1].clone()]);
            hulls.remove(0);
            let tilt = Vector::new(1.0, rng.random_range(-0.5..0.5), rng.random_range(-0.5..0.5)).normalize();
            let plane = HalfSpace::through(&Point::new(1.0, 1.0, 1.0), tilt);
            let placed = HPolyhedra::new(hulls.iter().cloned(), low, high);
            let (near, hulls_at) = (Near::default(), &placed);
            let mut section = Section { hulls: hulls_at, low: &low, high: &high, start: &start, goal: &goal, near };
            let known = (goal - start).norm();
            let Some(bound) = section.beyond(&plane, known, &Watch::NONE).unwrap() else { continue };
            let grid = sampled(&plane, &hulls, &low, &high, [&start, &goal]);
            assert!(bound <= grid + 1e-9 && (grid - bound < 0.03 || bound > 1e9), "{round}: {bound}, on a grid {grid}");
            told += 1;
        }
        assert!(told > 50, "{told}");
    }
}
