//! Which conditions are broken, and which bodies nearly meet, between the samples of a motion.

use std::f64::consts::PI;

use super::TrajectoryRules;
use super::faults::{FaultKind, Faults, Instant};
use super::recorded::Recorded;
use crate::collision::{Validity, Violation, WrenchLimit};
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::Pose;
use crate::limits::INSTANTS_OF_STEP;
use crate::model::Scene;
use crate::tolerances::{RECORDED_OVERLAP, SAME_TURN, SAMPLED_TRAVEL};
use crate::trajectory::{NearestInTime, nearest_in_time};
use crate::watch::Watch;
use crate::words::small_length;
use crate::wrench::{Measure, measures_at};

/// Finds broken conditions between the samples of `shown`, and the nearest approach. `away` is how far the motion
/// may be from `shown` after each sample, m; nothing if it is empty. Also returns notes on what could not be determined.
pub fn check(
    scene: &Scene,
    given: &TrajectoryRules,
    (shown, away): (&Recorded, &[f64]),
    faults: &mut Faults,
    watch: &Watch,
) -> Result<(Option<NearestInTime>, Vec<String>), Error> {
    let compiled = CompiledScene::new(scene, given.engine, given.interference, watch)?;
    let (motions, poses) = (shown.motions(scene.orientation()), shown.poses(scene.orientation()));
    let reach = compiled.conditions().bodies.reach();
    compiled.ready_for(&poses)?;
    let deviation = |k: usize| shown.sag(k, &motions, reach) + away.get(k).copied().unwrap_or(0.0);
    let mut notes: Vec<String> = half_turn(shown, &poses).into_iter().collect();
    let close = conditions(&compiled, shown, (&poses, reach), &deviation, faults, watch)?;
    notes.extend(close.map(|close| too_close(&close)));
    let nearest = nearest_in_time(&compiled, &shown.times, &poses, watch)?;
    notes.extend(too_coarse(shown, &deviation, nearest.as_ref()));
    Ok((nearest, notes))
}

/// The motion between two poses in steps short enough that sampling each of them finds what is broken. In longer steps that begin
/// in contact, only this contact might be found.
fn divided(from: &Pose, to: &Pose, reach: f64) -> Vec<Pose> {
    let travel = (to.position - from.position).norm() + reach * from.angle_to(to);
    let (motion, count) = (from.toward(to), (travel / SAMPLED_TRAVEL).ceil().clamp(1.0, INSTANTS_OF_STEP));
    (0..=count as usize).map(|k| motion.at(k as f64 / count)).collect()
}

/// Broken conditions on the motions between samples; a turn that is not free is [`divided`]. Returns the first
/// condition that is not known to be broken but too close to be proved, with its time.
fn conditions(
    compiled: &CompiledScene,
    motion: &Recorded,
    (poses, reach): (&[Pose], f64),
    deviation: &dyn Fn(usize) -> f64,
    faults: &mut Faults,
    watch: &Watch,
) -> Result<Option<(f64, Violation)>, Error> {
    let mut close = None;
    for (k, pair) in poses.windows(2).enumerate() {
        watch.check()?;
        if compiled.motion_valid(&pair[0], &pair[1]) {
            continue; // many times faster than checking every condition separately
        }
        let sag = deviation(k).min(RECORDED_OVERLAP);
        let parts = match compiled.scene().keeps_orientation(pair) {
            true => pair.to_vec(),
            false => divided(&pair[0], &pair[1], reach),
        };
        let found = parts.windows(2).enumerate().flat_map(|(part, ends)| {
            let found = compiled.violations(&ends[0], &ends[1]).into_iter();
            found.map(move |violation| (part, ends, violation))
        });
        for (part, ends, violation) in found {
            let share = (part as f64 + violation.at) / (parts.len() - 1) as f64;
            let time = motion.times[k] + share * motion.step(k);
            if violation.unproved && motion.orientations.is_some() {
                close.get_or_insert((time, violation));
                continue;
            }
            if may_be_kept(compiled.scene(), &violation, [&ends[0], &ends[1]], (sag, reach))? {
                continue;
            }
            let culprits: Vec<&str> = violation.culprits.iter().map(String::as_str).collect();
            let (found, limit) = (violation.gap, violation.required);
            let excess = violation.margin.map_or(0.0, |margin| -margin);
            let kind = FaultKind::Condition;
            faults.add(&Instant { step: k, time, kind, culprits: &culprits, found, limit, excess }, || {
                violation.sentence()
            });
        }
    }
    Ok(close)
}

/// Whether a condition that is broken on the straight motion between two poses may be kept by one that is up to `away` metres from it;
/// `reach` is the greatest distance of the platform's points from its origin, m.
fn may_be_kept(
    scene: &Scene,
    violation: &Violation,
    [from, to]: [&Pose; 2],
    (away, reach): (f64, f64),
) -> Result<bool, Error> {
    if let Some(margin) = violation.margin {
        return Ok(margin >= -away);
    }
    // The rule of a grid judges a position by points that may be a whole cell away from it.
    let continuous = |limit: &&WrenchLimit| limit.corner.is_none() && !limit.leaves_motions_free();
    let Some((judged, Some(margin))) =
        violation.wrench.as_ref().filter(continuous).map(|limit| (limit.measure, limit.wrench_margin))
    else {
        return Ok(false);
    };
    let turns = !scene.keeps_orientation(&[*from, *to]);
    let steepness = |measure: &Measure, pose: &Pose| {
        let turning = if turns { measure.steepness_of_turns(scene.robot().center_of_mass(), reach) } else { 0.0 };
        measure.steepness(&pose.position, away) + turning
    };
    // Near an outlet slack may change by any amount, which must not excuse any shortfall: the gentler end counts.
    let mut allowed = f64::INFINITY;
    for pose in [from, to] {
        let measures = measures_at(scene, &pose.orientation)?;
        let judging = measures.iter().filter(|measure| measure.name_and_unit().0 == judged);
        allowed = allowed.min(judging.map(|measure| steepness(measure, pose)).fold(0.0, f64::max));
    }
    Ok(allowed.is_finite() && margin >= -away * allowed)
}

fn too_close((time, violation): &(f64, Violation)) -> String {
    format!("at {time:.3} s, {}", violation.sentence())
}

/// A note if the motion may deviate from the straight lines between samples by more than the nearest approach.
fn too_coarse(motion: &Recorded, deviation: &dyn Fn(usize) -> f64, nearest: Option<&NearestInTime>) -> Option<String> {
    let steps = 0..motion.positions.len() - 1;
    let (deviation, k) = steps.map(|k| (deviation(k), k)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    let untold = -deviation..deviation;
    let counts = deviation > RECORDED_OVERLAP && nearest.is_some_and(|nearest| untold.contains(&nearest.value));
    counts.then(|| {
        let (most, time) = (small_length(deviation), motion.times[k]);
        format!(
            "collisions are checked on straight lines between samples, from which the motion may deviate by {most} \
                 after {time:.3} s: more samples tell more"
        )
    })
}

/// A note if the platform turns by half a turn between two samples: they do not tell which way.
fn half_turn(motion: &Recorded, poses: &[Pose]) -> Option<String> {
    let k = poses.windows(2).position(|pair| pair[0].angle_to(&pair[1]) >= PI - SAME_TURN)?;
    let [from, to] = [k, k + 1].map(|k| motion.times[k]);
    Some(format!(
        "between {from:.3} s and {to:.3} s the platform turns by half a turn, and only one of the two ways is checked: more \
         samples tell more"
    ))
}
