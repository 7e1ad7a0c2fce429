//! Checks a timed motion from any source against a scene and its limits.
//!
//! Limits are checked at the samples, and for the mean rates between them. The motion really reaches these rates, so
//! every reported fault is genuine; but between two samples a rate may be higher, by as much as its derivative allows.
//! If the exact form of the motion is known and the samples lie on it, at least ten instants between two samples are
//! checked as well, including tensions. Rates that are not given are derived from differences ([`Recorded`]), which
//! never overstates them. Bodies must not overlap between samples, and must keep the clearances of the scene, on
//! straight lines or, where velocities are given and the platform does not turn, on cubic curves. A shortfall is not a
//! fault if it is less than the motion may deviate from these, up to a tenth of a millimetre, or for wrenches than
//! such a deviation may change; where the motion may deviate by more than that and by more than the nearest approach,
//! a note says so.

mod deviation;
mod faults;
mod forces;
mod meetings;
mod recorded;
mod rules;

use serde::Serialize;

pub use faults::{Fault, FaultKind};
pub use recorded::Recorded;

use crate::collision::{Engine, Interference};
use crate::error::Error;
use crate::geometry::{Vector, path_length};
use crate::model::Scene;
use crate::model::spec::MotionSpec;
use crate::tolerances::{RECORDED_ROUNDING, TENSION_RESERVES};
use crate::trajectory::{Curve, Largest, Motion, NearestInTime, Timing, Winches, instants};
use crate::watch::Watch;
use faults::Faults;
use rules::{Rates, Rules, around};

/// The result of checking a timed motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TrajectoryReport {
    /// Whether there are no faults.
    pub valid: bool,
    /// Time from the first to the last sample, s.
    pub duration: f64,
    /// Length of the straight lines between samples, m.
    pub length: f64,
    /// Number of samples.
    pub samples: usize,
    /// Whether instants between the samples were checked on the exact form of the motion.
    pub exact: bool,
    /// How much faster than at the samples the platform may be between them, m/s; `None` if those instants were checked.
    pub unseen_speed: Option<f64>,
    /// The largest rates, and the range of tensions.
    pub largest: Largest,
    /// The closest approach, if anything can come close.
    pub nearest: Option<NearestInTime>,
    /// Faults of the motion, in order of time.
    pub faults: Vec<Fault>,
    /// Notes on what could not be checked, and why.
    pub notes: Vec<String>,
}

/// How a motion is checked.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct TrajectoryRules {
    /// Limits that replace those of the scene where they are set.
    pub limits: MotionSpec,
    /// The engine that finds collisions.
    pub engine: Engine,
    /// Rule for interference between cables.
    pub interference: Interference,
}

/// Checks a motion under its limits. The platform has the orientation of the scene unless the motion has its own.
///
/// # Errors
/// Limits that contradict each other or the robot; numbers too large to compute with; [`Error::interrupted`],
/// [`Error::out_of_time`].
///
/// # Example
/// ```
/// use cdpr_core::Point;
/// use cdpr_core::{Recorded, TrajectoryRules, check_trajectory};
/// use cdpr_core::{MotionSpec, Watch, testing};
/// let moving = testing::moving(&testing::hard1(), Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 20);
/// let limits = MotionSpec { speed: Some(0.8), ..MotionSpec::default() };
/// let rules = TrajectoryRules { limits, ..TrajectoryRules::default() };
/// let report = check_trajectory(&testing::hard1(), &Recorded::of(&moving)?, &rules, &Watch::NONE)?;
/// assert_eq!(report.faults[0].message, "speed 1 m/s, limit 0.8 m/s");
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn check_trajectory(
    scene: &Scene,
    motion: &Recorded,
    given: &TrajectoryRules,
    watch: &Watch,
) -> Result<TrajectoryReport, Error> {
    let limits = given.limits.in_scene(scene)?;
    let winches = Winches::of(scene, &limits, &motion.poses(scene.orientation()))?;
    // Recorded motions may leave as little room for proofs as planning does in its last attempt.
    let winches = winches.with_reserve(TENSION_RESERVES[TENSION_RESERVES.len() - 1], &limits);
    let held = scene.orientation();
    let rules = Rules { robot: scene.robot(), names: scene.robot().cable_names(), limits: &limits, winches: &winches };
    let (mut faults, mut largest, mut notes) = (Faults::default(), Largest::default(), Vec::new());
    let motions = motion.motions(held);
    check_columns(&rules, motion, &motions, &mut faults, watch)?;
    notes.extend(rules.unchecked_commands(motion, &motions[0]));
    notes.extend(forces::check(scene, motion, &motions, &rules, &mut faults, watch)?);
    let exact = motion.exact.as_ref().filter(|_| !faults.any(FaultKind::NotExact));
    let fine = exact.map(|exact| between(&rules, motion, exact, &mut largest, &mut faults, watch)).transpose()?;
    match &fine {
        Some(fine) => {
            let motions = fine.motions(held);
            check_fit(&rules, fine, &motions, &mut faults, watch)?;
            forces::check_between(scene, fine, &motions, &rules, &mut faults, watch)?;
        }
        None => {
            check_fit(&rules, motion, &motions, &mut faults, watch)?;
            check_limits(&rules, motion, &motions, &mut largest, &mut faults, watch)?;
        }
    }
    // A deviation that nobody limits has the default of planning, which is no requirement.
    let most = given.limits.blend.or(scene.spec().motion.and_then(|motion| motion.blend));
    match (&motion.path, most) {
        (Some(path), Some(most)) => deviation::check(fine.as_ref().unwrap_or(motion), path, most, &mut faults, watch)?,
        (None, Some(_)) => notes
            .push("the deviation from the path is not checked: the motion does not say which path it follows".into()),
        (_, None) => {}
    }
    largest.include_tensions(motion.tensions.iter().flatten().map(Vec::as_slice));
    let fits = fine.is_none() && !faults.any(FaultKind::Velocity);
    let smooth = fits.then(|| motion.smoothed()).flatten();
    let (shown, away) = match (&fine, &smooth) {
        (None, Some((smooth, away))) => (smooth, &away[..]),
        _ => (fine.as_ref().unwrap_or(motion), &[][..]),
    };
    let of_motion = limits.moving(scene)?;
    let (nearest, of_bodies) = meetings::check(&of_motion, given, (shown, away), &mut faults, watch)?;
    notes.extend(of_bodies);
    let times = &motion.times;
    let faults = faults.sorted();
    Ok(TrajectoryReport {
        valid: faults.is_empty(),
        duration: exact.map_or(times[times.len() - 1] - times[0], |(_, timing)| timing.duration()),
        length: path_length(&shown.positions),
        samples: times.len(),
        exact: fine.is_some(),
        unseen_speed: if fine.is_some() { None } else { Some(unseen_speed(motion)) },
        largest,
        nearest,
        faults,
        notes,
    })
}

/// Whether the columns of all samples fit the robot and the exact form.
fn check_columns(
    rules: &Rules,
    motion: &Recorded,
    motions: &[Motion],
    faults: &mut Faults,
    watch: &Watch,
) -> Result<(), Error> {
    for (k, time) in motion.times.iter().enumerate() {
        watch.check()?;
        rules.cables(motion, motions, k, faults);
        rules.commands(motion, &motions[k], k, faults);
        if let Some((curve, timing)) = &motion.exact {
            rules.exact(motion, k, around(*time).map(|time| Motion::at(curve, timing, time)), faults);
        }
    }
    Ok(())
}

/// Whether rates fit the poses and each other.
fn check_fit(
    rules: &Rules,
    motion: &Recorded,
    motions: &[Motion],
    faults: &mut Faults,
    watch: &Watch,
) -> Result<(), Error> {
    let largest = |norm: fn(&Motion) -> f64| motions.iter().map(norm).fold(0.0, f64::max);
    let most = [largest(|m| m.acceleration.norm()), largest(|m| m.angular_acceleration.norm())];
    for k in 0..motion.times.len() - 1 {
        watch.check()?;
        rules.fits(motion, motions, k, most, faults);
    }
    Ok(())
}

/// Limits at all samples, and between them as far as samples show it.
fn check_limits(
    rules: &Rules,
    motion: &Recorded,
    motions: &[Motion],
    largest: &mut Largest,
    faults: &mut Faults,
    watch: &Watch,
) -> Result<(), Error> {
    let known = [motion.velocities.is_some(), motion.accelerations.is_some()];
    let turn_known = [motion.angular_velocities.is_some(), motion.angular_accelerations.is_some()];
    for (k, now) in motions.iter().enumerate() {
        watch.check()?;
        let rates = Rates {
            step: k,
            time: motion.times[k],
            motion: now,
            has_jerk: false,
            rounding: derived_rounding(motion, k, known),
            turn_rounding: motion.orientations.as_ref().map(|_| derived_rounding(motion, k, turn_known)),
        };
        rules.at(&rates, largest, faults);
        if k + 1 < motion.times.len() {
            rules.means(motion, motions, k, faults);
        }
    }
    Ok(())
}

/// How much rounding of positions (or orientations) may add to a rate and to its derivative at a sample; only to those that are
/// derived from differences because they are not known.
fn derived_rounding(motion: &Recorded, k: usize, known: [bool; 2]) -> [f64; 2] {
    let last = motion.times.len() - 2;
    let step = motion.step(k.min(last)).min(motion.step(k.saturating_sub(1).min(last)));
    let rounding = RECORDED_ROUNDING / step;
    match known {
        [true, true] => [0.0; 2],
        [true, false] => [0.0, rounding],
        [false, true] => [rounding, 0.0],
        [false, false] => [rounding, 2.0 * rounding / step],
    }
}

/// Limits between samples in exact form, and the motion at all these instants.
fn between(
    rules: &Rules,
    motion: &Recorded,
    (curve, timing): &(Curve, Timing),
    largest: &mut Largest,
    faults: &mut Faults,
    watch: &Watch,
) -> Result<Recorded, Error> {
    let (mut times, mut motions) = (Vec::new(), Vec::new());
    let turn_rounding = motion.orientations.as_ref().map(|_| [0.0; 2]);
    for (k, time) in instants(&motion.times, timing.duration()) {
        watch.check()?;
        let now = Motion::at(curve, timing, time);
        let rounding = [0.0; 2];
        rules.at(&Rates { step: k, time, motion: &now, has_jerk: true, rounding, turn_rounding }, largest, faults);
        times.push(time);
        motions.push(now);
    }
    let turns = |rate: fn(&Motion) -> Vector| turn_rounding.map(|_| motions.iter().map(rate).collect());
    Ok(Recorded {
        times,
        positions: motions.iter().map(|now| now.position).collect(),
        orientations: turn_rounding.map(|_| motions.iter().map(|now| now.orientation).collect()),
        velocities: Some(motions.iter().map(|now| now.velocity).collect()),
        accelerations: Some(motions.iter().map(|now| now.acceleration).collect()),
        angular_velocities: turns(|now| now.angular_velocity),
        angular_accelerations: turns(|now| now.angular_acceleration),
        ..Recorded::default()
    })
}

/// How much faster the platform may be between two samples than at either of them: the change of speed that the sampled
/// accelerations allow in half of the time between them.
fn unseen_speed(motion: &Recorded) -> f64 {
    let accelerations = motion.accelerations();
    let most = |k: usize| accelerations[k].norm().max(accelerations[k + 1].norm());
    (0..motion.times.len() - 1).map(|k| 0.5 * motion.step(k) * most(k)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
