//! How close a motion comes to breaking conditions; computed from the conditions alone, so the same for all engines.

use serde::Serialize;

use super::along::{at, first_true};
use crate::conditions::{Condition, Conditions};
use crate::error::Error;
use crate::geometry::{Placed, Point};
use crate::tolerances::TOUCH_DEPTH;
use crate::watch::Watch;

/// The closest approach of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Clearance {
    /// Gap in the world, m.
    pub value: f64,
    /// Fraction of the motion at which it is first attained, 0 to 1.
    pub at: f64,
    /// Names of the members of the pair.
    pub culprits: Vec<String>,
    /// The required clearance of the pair, m; 0 if it only has to stay apart.
    pub required: f64,
}

/// The closest approach of a motion over all conditions on gaps.
pub fn clearance(conditions: &Conditions, from: &Point, to: &Point) -> Option<Clearance> {
    nearest(conditions, from, to).map(|nearest| reached(conditions, nearest, from, to))
}

/// The first closest approach of a motion, given the smallest gap and the index of its condition.
pub fn reached(conditions: &Conditions, (value, index): (f64, usize), from: &Point, to: &Point) -> Clearance {
    let nearest = &conditions.list[index];
    let until = |t: f64| gap(conditions, nearest, from, &at(from, to, t));
    let reached = |t: f64| until(t).is_some_and(|gap| gap <= value + TOUCH_DEPTH);
    let required = conditions.required(nearest).map_or(0.0, |gap| gap.max(0.0));
    Clearance { value, at: first_true(reached), culprits: conditions.culprits(nearest), required }
}

/// Conditions measured between two polls of the watch.
const AT_A_TIME: usize = 256;

/// The closest approach of a path, and its segment, for the conditions with these indices.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn path_clearance(
    conditions: &Conditions,
    indices: &[usize],
    waypoints: &[Point],
    watch: &Watch,
) -> Result<Option<(usize, Clearance)>, Error> {
    let travels = waypoints.windows(2).map(|pair| (pair[1] - pair[0]).norm());
    let on = |segment: usize| (&waypoints[segment], &waypoints[segment + 1]);
    let measured = |segment: usize, index: usize, least: f64| gap_below(conditions, index, on(segment), least);
    Ok(nearest_segment(indices, travels, measured, watch)?.map(|(segment, value, index)| {
        let (from, to) = on(segment);
        (segment, reached(conditions, (value, index), from, to))
    }))
}

/// What is known about a gap during a segment of a path.
pub enum Gap {
    /// The smallest gap, m.
    Is(f64),
    /// A lower bound of the gap, m, larger than the smallest gap of the path.
    AtLeast(f64),
}

/// The gap of a condition during a straight motion without a turn, as far as it may be less than `least`, m.
pub fn gap_below(conditions: &Conditions, index: usize, (from, to): (&Point, &Point), least: f64) -> Gap {
    let condition = &conditions.list[index];
    let apart = condition.details().boxes_apart(&conditions.bodies, from, to);
    if apart >= least {
        return Gap::AtLeast(apart);
    }
    // A condition without a gap is not measured again.
    gap(conditions, condition, from, to).map_or(Gap::AtLeast(f64::INFINITY), Gap::Is)
}

/// The segment of a path with the smallest gap, the gap, m, and the index of its condition. `measured` gives the gap of a condition
/// during a segment as far as it may be smaller than the smallest so far. A gap changes by at most what is travelled, so a wide one
/// is not measured again until the path could have used it up.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn nearest_segment(
    indices: &[usize],
    travels: impl Iterator<Item = f64>,
    measured: impl Fn(usize, usize, f64) -> Gap,
    watch: &Watch,
) -> Result<Option<(usize, f64, usize)>, Error> {
    let mut best: Option<(usize, f64, usize)> = None;
    // For each condition: after s metres of path, its gap is at least this value minus s.
    let mut wide_until = vec![f64::NEG_INFINITY; indices.len()];
    let mut way = 0.0;
    for (segment, travel) in travels.enumerate() {
        way += travel;
        for (block, ways) in wide_until.chunks_mut(AT_A_TIME).enumerate() {
            watch.check()?;
            for (k, wide_until) in ways.iter_mut().enumerate() {
                let least = best.map_or(f64::INFINITY, |(_, least, _)| least);
                if *wide_until - way > least + TOUCH_DEPTH {
                    continue;
                }
                let index = indices[block * AT_A_TIME + k];
                let gap = measured(segment, index, least);
                if let Gap::Is(gap) = gap
                    && gap < least
                {
                    best = Some((segment, gap, index));
                }
                let (Gap::Is(wide) | Gap::AtLeast(wide)) = gap;
                *wide_until = way + wide;
            }
        }
    }
    Ok(best)
}

/// The pair with the least slack at a position.
#[derive(Debug, Clone, PartialEq)]
pub struct Tightest {
    /// Gap of the pair at the position. Unlike elsewhere, `required` is negative where only the axes of thick cables
    /// must stay apart.
    pub clearance: Clearance,
    /// The points of both members that are nearest to each other, world.
    pub points: Option<[Point; 2]>,
}

/// The pair with the least slack at a position: gap minus required gap is smallest.
pub fn tightest(conditions: &Conditions, position: &Point) -> Option<Tightest> {
    tightest_of(conditions, position, |_| true)
}

/// The pair with the least slack at a position, among the selected conditions.
pub fn tightest_of(conditions: &Conditions, position: &Point, of: impl Fn(&Condition) -> bool) -> Option<Tightest> {
    let required = |condition: &Condition| conditions.required(condition).unwrap_or(0.0);
    let deducted = |condition: &Condition| of(condition).then(|| required(condition));
    let (room, index) = least(conditions, position, position, deducted)?;
    let condition = &conditions.list[index];
    let required = required(condition);
    let clearance = Clearance { value: room + required, at: 0.0, culprits: conditions.culprits(condition), required };
    Some(Tightest { clearance, points: condition.details().nearest_points(&conditions.bodies, position) })
}

/// The pair with the least slack at a pose, among the selected conditions; its points are not computed. The bodies are
/// given at the orientation of the conditions.
pub fn tightest_at_pose(conditions: &Conditions, at: &Placed, of: impl Fn(&Condition) -> bool) -> Option<Tightest> {
    let Conditions { list, bodies, .. } = conditions;
    let chosen = list.iter().filter(|condition| of(condition));
    let about_gaps = chosen.filter(|condition| condition.details().is_about_gap(bodies));
    let (room, condition) = about_gaps
        .map(|condition| {
            let details = condition.details();
            (details.clearance_at(bodies, at) - details.required(bodies), condition)
        })
        .min_by(|(a, _), (b, _)| a.total_cmp(b))?;
    let required = condition.details().required(bodies);
    let clearance = Clearance { value: room + required, at: 0.0, culprits: conditions.culprits(condition), required };
    Some(Tightest { clearance, points: None })
}

/// The smallest gap of a motion, m, and the index of its condition.
pub fn nearest(conditions: &Conditions, from: &Point, to: &Point) -> Option<(f64, usize)> {
    least(conditions, from, to, |_| Some(0.0))
}

/// The smallest gap of a motion after a deduction for each condition, m, and the index of the condition; conditions without
/// a deduction are left out. Bodies whose bounding boxes are further apart than the smallest gap found so far are skipped.
fn least(
    conditions: &Conditions,
    from: &Point,
    to: &Point,
    deducted: impl Fn(&Condition) -> Option<f64>,
) -> Option<(f64, usize)> {
    let mut best: Option<(f64, usize)> = None;
    for (index, condition) in conditions.list.iter().enumerate() {
        let Some(deducted) = deducted(condition) else { continue };
        if best
            .is_some_and(|(least, _)| condition.details().boxes_apart(&conditions.bodies, from, to) - deducted >= least)
        {
            continue;
        }
        let room = gap(conditions, condition, from, to).map(|gap| gap - deducted);
        if let Some(room) = room.filter(|room| best.is_none_or(|(least, _)| *room < least)) {
            best = Some((room, index));
        }
    }
    best
}

/// The smallest gap of a condition over a motion, m, whether required or not. `None` if the condition does not limit a
/// gap; see [`Conditions::required`].
fn gap(conditions: &Conditions, condition: &Condition, from: &Point, to: &Point) -> Option<f64> {
    let (condition, bodies) = (condition.details(), &conditions.bodies);
    condition.is_about_gap(bodies).then(|| condition.clearance(bodies, from, to))
}
