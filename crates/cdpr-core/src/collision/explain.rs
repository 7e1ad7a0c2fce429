//! Where and how badly a motion breaks constraints, and how near it comes to breaking one: the same words and the same
//! measures for every engine.

use super::constraint::{Constraint, Constraints, Demand};
use super::validity::{Checker, Clearance, Interference, Violation};
use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::{Aabb, Point, Swept, segment_segment};
use crate::numerics::{BISECTION_STEPS, TOUCH_DEPTH};
use crate::watch::Watch;

/// All constraints that a motion breaks in the eyes of an engine, those that break first first.
pub(super) fn violations(checker: &impl Checker, from: &Point, to: &Point) -> Vec<Violation> {
    let constraints = checker.constraints();
    let broken: Vec<usize> = (0..constraints.list.len()).filter(|&k| checker.breaks(k, from, to)).collect();
    let told = broken.iter().filter(|&&k| !told_by_others(constraints, k, &broken));
    let mut violations: Vec<Violation> = told.map(|&k| violation(checker, k, from, to)).collect();
    violations.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.kind.cmp(&b.kind)));
    merge_parts(violations)
}

/// The nearest approach of a motion, over all constraints that are about a distance.
pub(super) fn clearance(constraints: &Constraints, from: &Point, to: &Point) -> Option<Clearance> {
    nearest(constraints, from, to).map(|nearest| reached(constraints, nearest, from, to))
}

/// Where a motion first comes as near as it ever does, from the least gap and the constraint it is about.
fn reached(constraints: &Constraints, (value, index): (f64, usize), from: &Point, to: &Point) -> Clearance {
    let nearest = &constraints.list[index];
    let until = |t: f64| gap(constraints, nearest, from, &at(from, to, t));
    let reached = |t: f64| until(t).is_some_and(|gap| gap <= value + TOUCH_DEPTH);
    let required = constraints.required(nearest).map_or(0.0, |gap| gap.max(0.0));
    Clearance { value, at: first_true(reached), culprits: constraints.culprits(nearest), required }
}

/// Constraints that are looked at between two looks at the watch.
const AT_A_TIME: usize = 256;

/// The nearest approach of a path with regard to some constraints, by their indices, and its segment. A gap changes by no
/// more than the way gone, so one that is wide is not looked at again until the way could have used it up.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub(super) fn path_clearance(
    constraints: &Constraints,
    indices: &[usize],
    waypoints: &[Point],
    watch: &Watch,
) -> Result<Option<(usize, Clearance)>, Error> {
    let mut best: Option<(usize, f64, usize)> = None;
    // For each constraint a way along the path less which, at a later place, its gap is at most smaller.
    let mut wide_until = vec![f64::NEG_INFINITY; indices.len()];
    let mut way = 0.0;
    for (segment, pair) in waypoints.windows(2).enumerate() {
        let (from, to) = (&pair[0], &pair[1]);
        way += (to - from).norm();
        for (block, constraints_and_ways) in wide_until.chunks_mut(AT_A_TIME).enumerate() {
            watch.check()?;
            for (k, wide_until) in constraints_and_ways.iter_mut().enumerate() {
                let least = best.map_or(f64::INFINITY, |(_, least, _)| least);
                if *wide_until - way > least + TOUCH_DEPTH {
                    continue;
                }
                let index = indices[block * AT_A_TIME + k];
                let constraint = &constraints.list[index];
                let apart = boxes_apart(constraints, constraint, from, to);
                let gap = if apart >= least { None } else { gap(constraints, constraint, from, to) };
                if let Some(gap) = gap.filter(|gap| *gap < least) {
                    best = Some((segment, gap, index));
                }
                // Where no distance is to be kept there is never a gap.
                *wide_until = way + if apart >= least { apart } else { gap.unwrap_or(f64::INFINITY) };
            }
        }
    }
    Ok(best.map(|(segment, value, index)| {
        (segment, reached(constraints, (value, index), &waypoints[segment], &waypoints[segment + 1]))
    }))
}

/// Who has the least room at a position: the pair whose gap exceeds what is required of it by the least, or falls short by
/// the most. Unlike elsewhere, `required` is negative where only the axes of thick cables must keep apart.
pub fn tightest(constraints: &Constraints, position: &Point) -> Option<Clearance> {
    let required = |constraint: &Constraint| constraints.required(constraint).unwrap_or(0.0);
    let (room, index) = least(constraints, position, position, required)?;
    let constraint = &constraints.list[index];
    let required = required(constraint);
    Some(Clearance { value: room + required, at: 0.0, culprits: constraints.culprits(constraint), required })
}

/// The least gap of a motion, m, and the index of the constraint it is about.
pub(super) fn nearest(constraints: &Constraints, from: &Point, to: &Point) -> Option<(f64, usize)> {
    least(constraints, from, to, |_| 0.0)
}

/// The least gap of a motion after a deduction for each constraint, m, and the index of the constraint. Bodies whose boxes
/// are further apart than the least found so far are not looked at.
fn least(
    constraints: &Constraints,
    from: &Point,
    to: &Point,
    deducted: impl Fn(&Constraint) -> f64,
) -> Option<(f64, usize)> {
    let mut best: Option<(f64, usize)> = None;
    for (index, constraint) in constraints.list.iter().enumerate() {
        let deducted = deducted(constraint);
        if best.is_some_and(|(least, _)| boxes_apart(constraints, constraint, from, to) - deducted >= least) {
            continue;
        }
        let room = gap(constraints, constraint, from, to).map(|gap| gap - deducted);
        if let Some(room) = room.filter(|room| best.is_none_or(|(least, _)| *room < least)) {
            best = Some((room, index));
        }
    }
    best
}

/// Distance of the boxes around those whom a constraint keeps apart, less the radius of the cable, m: never more than
/// their gap. Minus infinity where the boxes meet.
fn boxes_apart(c: &Constraints, constraint: &Constraint, from: &Point, to: &Point) -> f64 {
    let (swept, body, radius) = match constraint {
        Constraint::PlatformObstacle { part, body, .. } => {
            (c.platform[*part].aabb().swept(&from.coords, &to.coords), body, 0.0)
        }
        Constraint::CableObstacle { cable, body, .. } => {
            let cable = &c.cables[*cable];
            (Aabb::around(&cable.sweep(from, to).corners), body, cable.radius)
        }
        _ => return f64::NEG_INFINITY,
    };
    let apart = swept.distance(c.obstacles[*body].body.aabb());
    if apart > 0.0 { apart - radius } else { f64::NEG_INFINITY }
}

/// Room left in the workspace or in the length of a cable over a motion, m; negative outside.
pub(super) fn room(constraints: &Constraints, constraint: &Constraint, from: &Point, to: &Point) -> f64 {
    match constraint {
        Constraint::Workspace { .. } if !from.iter().chain(to.iter()).all(|x| x.is_finite()) => f64::NEG_INFINITY,
        Constraint::Workspace { min, max } => {
            let room = |p: &Point| (p - min).inf(&(max - p)).min();
            room(from).min(room(to))
        }
        Constraint::CableLength { cable, min, max } => {
            let cable = &constraints.cables[*cable];
            let (p, q) = (from + cable.arm, to + cable.arm);
            let longest = (p - cable.outlet).norm().max((q - cable.outlet).norm());
            let shortest = segment_segment::closest(&p, &q, &cable.outlet, &cable.outlet).distance;
            (shortest - min).min(max - longest)
        }
        _ => f64::INFINITY,
    }
}

/// Gap in the world that a constraint is about, over a motion, m: distance or minus depth, of surfaces, whether or not it
/// is demanded. None where a constraint is not about a distance; see [`Constraints::required`].
fn gap(constraints: &Constraints, constraint: &Constraint, from: &Point, to: &Point) -> Option<f64> {
    constraints.required(constraint).map(|_| distance(constraints, constraint, from, to))
}

/// Distance or minus depth, of surfaces, between those whom a constraint is about, over a motion; for workspace and cable
/// length the room left, m.
pub(super) fn distance(c: &Constraints, constraint: &Constraint, from: &Point, to: &Point) -> f64 {
    match constraint {
        Constraint::Workspace { .. } | Constraint::CableLength { .. } => room(c, constraint, from, to),
        Constraint::CablePlatform { cable, body, .. } => {
            let cable = &c.cables[*cable];
            shape_distance(&cable.sweep_seen_from_platform(from, to), &c.platform[*body]).signed() - cable.radius
        }
        Constraint::CableCable(pair) => pair.least_distance(from, to).0 - pair.radii,
        Constraint::PlatformObstacle { part, body, .. } => {
            let swept = Swept::new(&c.platform[*part], from.coords, to - from);
            shape_distance(&swept, &c.obstacles[*body].body).signed()
        }
        Constraint::CableObstacle { cable, body, .. } => {
            let cable = &c.cables[*cable];
            shape_distance(&cable.sweep(from, to), &c.obstacles[*body].body).signed() - cable.radius
        }
    }
}

/// How far a position is from breaking a constraint that is about a distance or room, m: moving by less keeps it, because
/// distances to what stands still, and between two cables, change at most by the way gone.
pub(super) fn slack(constraints: &Constraints, constraint: &Constraint, position: &Point) -> f64 {
    match constraint {
        Constraint::CablePlatform { demand: Demand::Leave { .. }, .. }
        | Constraint::CableObstacle { demand: Demand::Leave { .. }, .. } => f64::NEG_INFINITY,
        _ => distance(constraints, constraint, position, position) - required(constraints, constraint),
    }
}

/// The least [`distance`] that keeps a constraint, m. Where a cable need only stay outside a body, it is its middle line
/// that does.
fn required(c: &Constraints, constraint: &Constraint) -> f64 {
    match constraint {
        Constraint::Workspace { .. } | Constraint::CableLength { .. } => 0.0,
        Constraint::CableCable(pair) => pair.gap - pair.radii,
        Constraint::PlatformObstacle { gap, .. } => *gap,
        Constraint::CablePlatform { cable, demand, .. } | Constraint::CableObstacle { cable, demand, .. } => {
            let radius = c.cables[*cable].radius;
            match demand {
                Demand::Apart { gap } => gap - radius,
                Demand::Outside { .. } | Demand::Leave { .. } => -radius,
            }
        }
    }
}

/// Whether a broken constraint is about a seam while the cable breaks that of a part beside the seam as well, which tells
/// the true culprit and depth.
fn told_by_others(c: &Constraints, index: usize, broken: &[usize]) -> bool {
    let Constraint::CableObstacle { cable, body, .. } = &c.list[index] else { return false };
    let seam = &c.obstacles[*body];
    let part_beside = |other: &usize| match &c.list[*other] {
        Constraint::CableObstacle { cable: same, body, .. } => {
            let part = &c.obstacles[*body];
            same == cable && part.seam.is_none() && seam.between.contains(&part.between[0])
        }
        _ => false,
    };
    seam.seam.is_some() && broken.iter().any(part_beside)
}

/// Where and how badly a motion breaks a constraint that it is known to break.
fn violation(checker: &impl Checker, index: usize, from: &Point, to: &Point) -> Violation {
    let (constraints, constraint) = (checker.constraints(), &checker.constraints().list[index]);
    // What a motion sweeps only grows, so the first contact and the last are found by bisection on the whole test.
    let first = first_true(|t| checker.breaks(index, from, &at(from, to, t)));
    let last = 1.0 - first_true(|t| checker.breaks(index, &at(from, to, 1.0 - t), to));
    let gap = match constraint {
        Constraint::CableCable(pair) if checker.interference() == Interference::Swept => {
            // The triangles meet, maybe at different times: that is the gap this rule is about.
            let sweep = |cable: usize| constraints.cables[cable].sweep(from, to);
            shape_distance(&sweep(pair.first), &sweep(pair.second)).distance - pair.radii
        }
        Constraint::CableCable(_) | Constraint::Workspace { .. } | Constraint::CableLength { .. } => {
            distance(constraints, constraint, from, to)
        }
        _ if from == to => distance(constraints, constraint, from, to),
        _ => least_between(first, last, |t| {
            let p = at(from, to, t);
            distance(constraints, constraint, &p, &p)
        }),
    };
    let required = required(constraints, constraint);
    Violation {
        unproved: false,
        wrench: None,
        at: first,
        kind: constraints.kind(constraint),
        culprits: constraints.culprits(constraint),
        gap: Some(gap),
        required: Some(required),
        margin: Some((gap - required).min(0.0)), // it is known to be broken: more is rounding
    }
}

/// One violation per kind and culprits: a body of several parts is one body.
fn merge_parts(violations: Vec<Violation>) -> Vec<Violation> {
    let mut merged: Vec<Violation> = Vec::new();
    for violation in violations {
        match merged.iter_mut().find(|v| v.kind == violation.kind && v.culprits == violation.culprits) {
            Some(known) => {
                if violation.margin < known.margin {
                    (known.gap, known.required, known.margin) = (violation.gap, violation.required, violation.margin);
                }
            }
            None => merged.push(violation),
        }
    }
    merged
}

fn at(from: &Point, to: &Point, t: f64) -> Point {
    if t >= 1.0 { *to } else { from + (to - from) * t }
}

/// The first t in [0, 1] where a test that stays true once it is true becomes true; it must be true at 1.
fn first_true(test: impl Fn(f64) -> bool) -> f64 {
    if test(0.0) {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..BISECTION_STEPS {
        let middle = 0.5 * (low + high);
        if test(middle) { high = middle } else { low = middle }
    }
    high
}

/// Least value of a function between two instants: samples, then golden sections around each that is least among its
/// neighbours. Exact to rounding for the depth of the platform, which has one minimum along a line.
fn least_between(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const SAMPLES: usize = 16;
    let step = (high - low).max(0.0) / SAMPLES as f64;
    let sampled: [f64; SAMPLES + 1] = std::array::from_fn(|k| value(low + step * k as f64));
    let around = |k: usize| [k.saturating_sub(1), (k + 1).min(SAMPLES)];
    let valleys = (0..=SAMPLES).filter(|&k| around(k).iter().all(|&neighbour| sampled[k] <= sampled[neighbour]));
    let refined = valleys.map(|k| {
        let [a, b] = around(k).map(|k| low + step * k as f64);
        golden_sections(a, b, sampled[k], &value)
    });
    refined.fold(f64::INFINITY, f64::min)
}

/// Least value found in an interval by golden sections; exact where there is one minimum.
fn golden_sections(mut a: f64, mut b: f64, known: f64, value: &impl Fn(f64) -> f64) -> f64 {
    const SECTIONS: usize = 40;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    (0..SECTIONS).fold(known, |least, _| {
        let (left, right) = (b - golden * (b - a), a + golden * (b - a));
        let (at_left, at_right) = (value(left), value(right));
        if at_left <= at_right {
            b = right
        } else {
            a = left
        }
        least.min(at_left).min(at_right)
    })
}
