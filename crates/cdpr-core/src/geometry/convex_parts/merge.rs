//! Merging of neighbouring convex parts that one body encloses within the tolerance.

use std::cmp::Ordering;

use rayon::prelude::*;

use super::inner_hull::InnerHull;
use super::part::{Part, Task};
use super::wrap::Wrap;
use crate::error::Error;
use crate::geometry::{HalfSpace, Point};
use crate::limits::{MERGE_STEPS, MERGE_STEPS_PER_PART};
use crate::tolerances::{ON_SURFACE, UNDECIDED};

/// Maximum number of pairs examined, per initial part.
const PAIRS_PER_PART: usize = 12;

/// Number of hull corners of a pair at which points are examined before anything is proved.
const ROUGH_CORNERS: usize = 30;

/// Minimum number of steps for the proof of a pair.
const LEAST_STEPS: usize = 500;

/// Merges parts into parts that extend at most `within` metres, starting with those that add the least volume. Each
/// round merges as many disjoint pairs as possible.
///
/// Parts that fill the body exactly are merged only into parts that do so, too.
pub(super) fn merged(task: &Task, parts: Vec<Part>, within: f64) -> Result<Vec<Part>, Error> {
    let exactly = parts.iter().all(|part| part.reach == Some(0.0));
    let mut left = PAIRS_PER_PART * parts.len();
    let mut steps = MERGE_STEPS_PER_PART * parts.len();
    let mut parts: Vec<Option<Part>> = parts.into_iter().map(Some).collect();
    let mut waiting: Vec<(f64, [usize; 2])> = Vec::new();
    let mut known = 0; // pairs of parts before this one have been tried
    loop {
        let mut pairs = Vec::new();
        for j in known..parts.len() {
            for i in 0..j {
                if let (Some(a), Some(b)) = (&parts[i], &parts[j])
                    && a.reach.is_some()
                    && b.reach.is_some()
                    && !a.wrap.aabb.apart_by(&b.wrap.aabb, 0.0)
                {
                    pairs.push([i, j]);
                }
            }
        }
        known = parts.len();
        pairs.truncate(left);
        left -= pairs.len();
        let ends = |[i, j]: [usize; 2]| [i, j].map(|k| parts[k].as_ref().expect("pairs are of parts that are left"));
        let may = |pair: &[usize; 2]| Ok(may_be_one(task, ends(*pair), within)?.map(|loss| (loss, *pair)));
        let looked: Vec<Option<(f64, [usize; 2])>> = pairs.par_iter().map(may).collect::<Result<_, Error>>()?;
        waiting.extend(looked.into_iter().flatten());
        waiting.retain(|(_, [i, j])| parts[*i].is_some() && parts[*j].is_some());
        waiting.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        // Disjoint pairs: merge every pair that can be merged.
        let mut taken = vec![false; parts.len()];
        let mut likely: Vec<[usize; 2]> = Vec::new();
        waiting.retain(|(_, pair)| {
            let free = pair.iter().all(|k| !taken[*k]);
            if free {
                pair.iter().for_each(|k| taken[*k] = true);
                likely.push(*pair);
            }
            !free
        });
        let share = (steps / likely.len().max(1)).clamp(LEAST_STEPS, MERGE_STEPS);
        let tried: Vec<(usize, Option<Part>)> =
            likely.par_iter().map(|pair| joint(task, ends(*pair), exactly, within, share)).collect::<Result<_, _>>()?;
        for ([i, j], (took, joint)) in likely.into_iter().zip(tried) {
            steps = steps.saturating_sub(took);
            if let Some(joint) = joint {
                (parts[i], parts[j]) = (None, None);
                parts.push(Some(joint));
            }
        }
        if (parts.len() == known && waiting.is_empty()) || steps == 0 {
            return Ok(parts.into_iter().flatten().collect());
        }
    }
}

/// Points farther than a limit from the piece.
struct Outskirts<'a> {
    task: &'a Task<'a>,
    /// Distance from the piece, m.
    limit: f64,
    /// Balls inside the body: centres and squared radii. Most points are in a known one.
    balls: Vec<(Point, f64)>,
}

impl Outskirts<'_> {
    fn holds(&mut self, place: Point) -> bool {
        if self.balls.iter().any(|(middle, squared)| (place - middle).norm_squared() < *squared) {
            return false;
        }
        let surface = &self.task.piece.distance;
        if surface.within(&place, self.limit, &mut 0) {
            return false;
        }
        let (distance, _) = surface.at(&place);
        if distance < 0.0 {
            self.balls.push((place, distance * distance));
        }
        distance > self.limit
    }
}

fn both([a, b]: [&Part; 2]) -> Vec<Point> {
    a.wrap.points.iter().chain(&b.wrap.points).copied().collect()
}

/// The approximate volume added by merging two parts; `None` if a point of their hull is too far from the piece.
fn may_be_one(task: &Task, pair: [&Part; 2], within: f64) -> Result<Option<f64>, Error> {
    task.watch.check()?;
    let points = both(pair);
    let Some(mut inner) = InnerHull::new(&points) else { return Ok(None) };
    inner.grow(ON_SURFACE, ROUGH_CORNERS, task.watch)?;
    // The proof would fail at such points, too.
    let mut outskirts = Outskirts { task, limit: UNDECIDED * within, balls: Vec::new() };
    // Each edge belongs to two triangles, which run along it in opposite directions.
    let mut far_along = |a: Point, b: Point| {
        let order = a.iter().partial_cmp(b.iter());
        order == Some(Ordering::Less) && outskirts.holds(nalgebra::center(&a, &b))
    };
    let void = inner.triangles().any(|([a, b, c], _)| far_along(a, b) || far_along(b, c) || far_along(c, a))
        || inner.triangles().any(|([a, b, c], _)| outskirts.holds(Point::from((a.coords + b.coords + c.coords) / 3.0)));
    Ok((!void).then(|| inner.volume() - pair[0].wrap.volume - pair[1].wrap.volume))
}

/// Two parts merged, unless the result extends too far; also the number of steps used.
fn joint(
    task: &Task,
    [a, b]: [&Part; 2],
    exactly: bool,
    within: f64,
    steps: usize,
) -> Result<(usize, Option<Part>), Error> {
    let wrap = task.enclosing(both([a, b]))?;
    let cells = || a.cells.iter().chain(&b.cells).cloned().collect();
    let fill = a.reach == Some(0.0) && b.reach == Some(0.0);
    if fill && wrap.exact && are_one([&a.wrap, &b.wrap]) {
        return Ok((0, Some(Part { wrap, reach: Some(0.0), cells: cells() })));
    }
    if exactly {
        return Ok((0, None));
    }
    let found = task.proved(&wrap, within, steps)?;
    let part = (found.bound <= within).then(|| Part { wrap, reach: Some(found.bound), cells: cells() });
    Ok((found.steps, part))
}

/// Whether the union of two convex bodies on different sides of a plane is convex: both have a face in that plane, and
/// every other face of one has the other body behind it. (Let A' and B' be the bodies without the plane. Then A' ∩ B' is A
/// on one side of the plane, since A lies in B', and B on the other.)
fn are_one([a, b]: [&Wrap; 2]) -> bool {
    let behind = |plane: &HalfSpace, points: &[Point]| points.iter().all(|p| plane.height(p) <= ON_SURFACE);
    // The corners of one face lie in the plane of the other.
    let within = |own: &HalfSpace, points: &[Point], other: &HalfSpace| {
        points.iter().all(|p| own.height(p) < -ON_SURFACE || other.height(p).abs() <= ON_SURFACE)
    };
    let opposite = |p: &HalfSpace, q: &HalfSpace| {
        p.normal.dot(&q.normal) < 0.0 && within(p, &a.points, q) && within(q, &b.points, p)
    };
    a.planes.iter().any(|p| {
        b.planes.iter().any(|q| {
            opposite(p, q)
                && a.planes.iter().all(|side| side == p || behind(side, &b.points))
                && b.planes.iter().all(|side| side == q || behind(side, &a.points))
        })
    })
}
