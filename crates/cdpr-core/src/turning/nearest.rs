//! The closest approach of motions with turns, and of paths of poses.

use crate::collision::along::{Least, golden_sections};
use crate::collision::clearance::{Gap, gap_below, nearest_segment, reached};
use crate::collision::{Clearance, Condition, Conditions};
use crate::conditions::Bodies;
use crate::error::Error;
use crate::geometry::{Placed, Pose, Rotation, Turning};
use crate::tolerances::SAME_TURN;
use crate::watch::Watch;

/// The closest approach of a path of poses, and its segment, for the conditions with these indices, which are given with their
/// orientation.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn path_clearance(
    (conditions, reference): (&Conditions, &Rotation),
    indices: &[usize],
    poses: &[Pose],
    watch: &Watch,
) -> Result<Option<(usize, Clearance)>, Error> {
    let Conditions { list, bodies, .. } = conditions;
    let about_gap = |index: &usize| list[*index].details().is_about_gap(bodies);
    let mut about_gaps: Vec<(usize, f64)> =
        indices.iter().copied().filter(about_gap).map(|index| (index, 0.0)).collect();
    let segments: Vec<Segment> = poses.windows(2).map(|pair| Segment::between(reference, &pair[0], &pair[1])).collect();
    if let Some(Segment::Turning(motion)) = segments.first() {
        // Nearly always a pair that is close at the start shows that others are not closest.
        let start = motion.at(0.0);
        about_gaps.iter_mut().for_each(|(index, gap)| *gap = gap_at(&list[*index], bodies, &start));
        about_gaps.sort_by(|(_, a), (_, b)| a.total_cmp(b));
    }
    let indices: Vec<usize> = about_gaps.into_iter().map(|(index, _)| index).collect();
    let reach = bodies.reach();
    let measured = |segment: usize, index: usize, least: f64| match &segments[segment] {
        Segment::Level(from, to) => gap_below(conditions, index, (&from.position, &to.position), least),
        Segment::Turning(motion) => match least_gap(motion, reach, least, |at| gap_at(&list[index], bodies, at)) {
            Closest { reached: Some(found), .. } => Gap::Is(found.value),
            Closest { at_least, .. } => Gap::AtLeast(at_least),
        },
    };
    let travels = segments.iter().map(|segment| segment.travel(reach));
    let found = nearest_segment(&indices, travels, measured, watch)?;
    Ok(found.map(|(segment, value, index)| {
        let found = match &segments[segment] {
            Segment::Level(from, to) => reached(conditions, (value, index), &from.position, &to.position),
            Segment::Turning(motion) => {
                let gap = |at: &Placed| gap_at(&list[index], bodies, at);
                let at = least_gap(motion, reach, f64::INFINITY, gap).reached.map_or(0.0, |found| found.at);
                let required = list[index].details().required(bodies).max(0.0);
                Clearance { value, at, culprits: conditions.culprits(&list[index]), required }
            }
        };
        (segment, found)
    }))
}

/// Whether a pose has the orientation of the conditions.
pub fn is_level(pose: &Pose, reference: &Rotation) -> bool {
    pose.orientation.angle_to(reference) <= SAME_TURN
}

/// A segment of a path of poses.
enum Segment {
    /// Without a turn, at the orientation of the conditions.
    Level(Pose, Pose),
    Turning(Box<Turning>),
}

impl Segment {
    fn between(reference: &Rotation, from: &Pose, to: &Pose) -> Self {
        match is_level(from, reference) && is_level(to, reference) {
            true => Segment::Level(*from, *to),
            false => Segment::Turning(Box::new(from.toward(to).relative_to(reference))),
        }
    }

    /// The most by which a gap can change from one end to the other, m: both bodies of a pair may move.
    fn travel(&self, reach: f64) -> f64 {
        match self {
            Segment::Level(from, to) => (to.position - from.position).norm(),
            Segment::Turning(motion) => 2.0 * motion.whole().travel(reach),
        }
    }
}

/// The gap of a pair at a pose, m, whether a gap is required or not.
fn gap_at(condition: &Condition, bodies: &Bodies, at: &Placed) -> f64 {
    condition.details().clearance_at(bodies, at)
}

/// What is known about a gap during a motion.
struct Closest {
    /// The smallest gap, m, if it is below the limit.
    reached: Option<Least>,
    /// A lower bound, m.
    at_least: f64,
}

/// Parts are not halved any more if they are this share of a motion, or if bodies move in them by less than this, m.
const SHORT: [f64; 2] = [1.0 / 32.0, 1e-3];

/// The smallest gap during a motion, as far as it may be below a limit, m. Parts are halved, except those in which both
/// bodies move too little to bring the gap below the smallest so far; the smallest is then refined around the best of
/// the remaining parts.
fn least_gap(motion: &Turning, reach: f64, limit: f64, gap: impl Fn(&Placed) -> f64) -> Closest {
    let mut best = Least { at: 0.0, value: limit };
    let mut at_least = f64::INFINITY;
    let mut last: Vec<(Least, f64)> = Vec::new();
    let mut left = vec![motion.whole()];
    while let Some(piece) = left.pop() {
        let [from, to] = piece.during;
        let middle = Least { at: 0.5 * (from + to), value: gap(&piece.middle) };
        best = best.or(middle);
        let travel = piece.travel(reach);
        let bound = middle.value - travel;
        if bound >= best.value {
            at_least = at_least.min(bound);
        } else if to - from <= SHORT[0] || travel <= SHORT[1] {
            last.push((middle, to - from));
        } else {
            let [first, second] = motion.halves(&piece);
            left.extend([second, first]);
        }
    }
    let value = |at: f64| gap(&motion.at(at));
    for (middle, width) in &last {
        let beside = |(other, others): &&(Least, f64)| (other.at - middle.at).abs() < 0.6 * (width + others);
        if last.iter().filter(beside).all(|(other, _)| middle.value <= other.value) {
            let around = [(middle.at - width).max(0.0), (middle.at + width).min(1.0)];
            let ends = around.map(|at| Least { at, value: value(at) });
            best = best.or(ends[0]).or(ends[1]).or(golden_sections(around, *middle, &value));
        }
    }
    match best.value < limit {
        true => Closest { reached: Some(best), at_least: best.value },
        false => Closest { reached: None, at_least: at_least.min(limit) },
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::collision::CspaceEngine;
    use crate::conditions::Interference;
    use crate::geometry::{Point, Vector};
    use crate::testing::{hard1, hard3};
    use crate::turning::TurningEngine;

    /// The smallest gap of all pairs at some shares of a motion.
    fn sampled<'a>(engine: &TurningEngine, motion: &Turning, shares: impl Iterator<Item = &'a f64>) -> f64 {
        let Conditions { list, bodies, .. } = engine.conditions();
        let pairs = || list.iter().filter(|condition| condition.details().is_about_gap(bodies));
        let least = |at: Placed| pairs().map(|pair| gap_at(pair, bodies, &at)).fold(f64::INFINITY, f64::min);
        shares.map(|share| least(motion.at(*share))).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn the_nearest_approach_of_poses_is_no_farther_than_any_sample() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let shares: Vec<f64> = (0..=500).map(|k| f64::from(k) / 500.0).collect();
        for scene in [hard1(), hard3()] {
            let level = CspaceEngine::new(&scene, Interference::Exact).unwrap();
            let engine = TurningEngine::new(&scene, Arc::new(level)).unwrap();
            let all: Vec<usize> = (0..engine.conditions().list.len()).collect();
            for (turned, step) in [(0.3, 0.5), (0.01, 0.02), (2.0, 0.0), (0.0, 1.0)] {
                let mut path = vec![Pose::new(Point::new(0.5, 1.0, 0.5), *scene.orientation())];
                for k in 0..30 {
                    let position = path[k].position.map(|x| (x + step * (rng.random::<f64>() - 0.5)).clamp(0.0, 2.0));
                    let axis = Vector::from_fn(|_, _| rng.random::<f64>() - 0.5);
                    let turn =
                        if k % 5 == 4 { Rotation::identity() } else { Rotation::from_scaled_axis(axis * turned) };
                    path.push(Pose::new(position, turn * path[k].orientation));
                }
                let (segment, found) =
                    path_clearance((engine.conditions(), engine.reference()), &all, &path, &Watch::NONE)
                        .unwrap()
                        .unwrap();
                let motions: Vec<Turning> =
                    path.windows(2).map(|pair| pair[0].toward(&pair[1]).relative_to(engine.reference())).collect();
                let least =
                    motions.iter().map(|motion| sampled(&engine, motion, shares.iter())).fold(f64::INFINITY, f64::min);
                assert!(found.value <= least + 1e-12, "{turned} {step}: {found:?} instead of {least}");
                // Without a turn, a depth covers everything passed along the motion.
                if turned > 0.0 {
                    let there = sampled(&engine, &motions[segment], [found.at].iter());
                    assert!((there - found.value).abs() < 1e-9, "{there} at the place of {found:?}");
                }
            }
        }
    }
}
