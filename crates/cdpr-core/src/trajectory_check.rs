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
mod tests {
    use super::*;
    use crate::compiled::CompiledScene;
    use crate::geometry::Point;
    use crate::model::{BodySpec, Distribution, MarginSpec, RobotSource, SceneSpec, WrenchSpec};
    use crate::plan::{PlanOptions, Query, plan};
    use crate::testing::{hard1, paper_robot, paper_scene, scene};
    use crate::trajectory::{Limit, Trajectory};
    use crate::trajectory_file::TrajectoryFile;

    const SLOW: MotionSpec = MotionSpec {
        speed: Some(1.0),
        acceleration: Some(3.0),
        turn_speed: None,
        turn_acceleration: None,
        jerk: None,
        cable_speed: None,
        cable_acceleration: None,
        blend: Some(0.02),
        clearance: None,
        wrench_margin: None,
    };

    fn check(scene: &Scene, motion: &Recorded, limits: &MotionSpec) -> TrajectoryReport {
        let rules = TrajectoryRules { limits: *limits, ..TrajectoryRules::default() };
        check_trajectory(scene, motion, &rules, &Watch::NONE).unwrap()
    }

    fn compiled(scene: &Scene) -> CompiledScene {
        CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).unwrap()
    }

    fn along(scene: &Scene, path: &[Point], rate: f64) -> Recorded {
        let path = crate::path::held(scene, path);
        let compiled = compiled(scene);
        let trajectory = Trajectory::new(&compiled, &path, &SLOW, &Watch::NONE).unwrap();
        let file = TrajectoryFile::of(&compiled, &path, &trajectory, rate, &Watch::NONE).unwrap();
        Recorded::of(&file).unwrap()
    }

    /// A trajectory around the pillar.
    fn around_pillar(rate: f64) -> Recorded {
        let scene = hard1();
        let path = plan(Query::of(&scene), &PlanOptions::default(), &()).unwrap().result.waypoints();
        along(&scene, &path, rate)
    }

    /// The paper's robot with a point mass, which leaves no motion free.
    fn held() -> Scene {
        let mut robot = paper_robot();
        robot.cables.iter_mut().for_each(|cable| cable.attachment = [0.0; 3]);
        robot.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
        scene(SceneSpec { robot: RobotSource::Inline(robot), ..paper_scene("held", Vec::new()) })
    }

    /// A trajectory whose tensions are limited.
    fn with_tensions() -> Recorded {
        let motion = along(&held(), &[Point::new(0.6, 0.8, 0.7), Point::new(1.3, 1.1, 0.9)], 100.0);
        Recorded { exact: None, ..motion }
    }

    fn faults(motion: &Recorded, limits: &MotionSpec) -> Vec<Fault> {
        check(&hard1(), motion, limits).faults
    }

    /// Without the exact form, as in a CSV file.
    fn sampled(rate: f64) -> Recorded {
        Recorded { exact: None, ..around_pillar(rate) }
    }

    #[test]
    fn excessive_deviation_from_the_path_is_found() {
        let motion = around_pillar(100.0);
        assert!(motion.path.as_ref().is_some_and(|path| path.len() > 2));
        let with = |blend: f64| MotionSpec { blend: Some(blend), ..SLOW };
        let found = faults(&motion, &with(0.01));
        let deviates = |fault: &Fault| fault.kind == FaultKind::Deviation;
        assert!(!found.is_empty() && found.iter().all(deviates), "{found:?}");
        let farthest = found.iter().filter_map(|fault| fault.found).fold(0.0, f64::max);
        assert!(farthest > 0.01 && farthest <= 0.02 + 1e-6, "{farthest}");
        assert_eq!(faults(&motion, &with(farthest)), []);
        assert!(!faults(&motion, &with(0.999 * farthest)).is_empty());
        // The limit of the scene counts as well; one that nobody gives does not.
        let limit = |blend| SceneSpec { motion: Some(with(blend)), ..hard1().spec().clone() };
        let none = MotionSpec::default();
        assert!(!check(&scene(limit(0.01)), &motion, &none).valid && check(&scene(limit(0.02)), &motion, &none).valid);
        assert_eq!(faults(&motion, &MotionSpec { blend: None, ..SLOW }), []);
        // Samples alone tell it too, on a path that passes the same place twice.
        let line = |k: usize| Point::new(0.3 + 0.01 * k as f64, 1.0, 0.3);
        let positions: Vec<Point> = (0..=20).chain((0..20).rev()).map(line).collect();
        let there_and_back = Recorded {
            times: (0..positions.len()).map(|k| 0.1 * k as f64).collect(),
            positions,
            path: Some(vec![line(0), line(20), line(0)]),
            ..Recorded::default()
        };
        assert_eq!(faults(&there_and_back, &with(0.0)), []);
        let mut off = there_and_back;
        off.positions[30].y += 0.002;
        assert!(faults(&off, &with(0.0)).iter().any(|fault| deviates(fault) && fault.time == off.times[30]));
    }

    #[test]
    fn planned_trajectories_are_valid_with_and_without_columns() {
        for rate in [1000.0, 100.0, 30.0] {
            let exact = around_pillar(rate);
            let report = check(&hard1(), &exact, &SLOW);
            assert_eq!((report.faults, report.exact), (Vec::new(), true));
            assert!(report.largest.speed <= 1.0 + 1e-9 && report.largest.acceleration > 2.9);
            let sampled = Recorded { exact: None, ..exact };
            assert_eq!(faults(&sampled, &SLOW), []);
            let Recorded { times, positions, velocities, .. } = sampled;
            let bare = Recorded { times, positions, velocities, ..Recorded::default() };
            assert_eq!(faults(&bare, &SLOW), []);
            assert_eq!(faults(&Recorded { velocities: None, ..bare }, &SLOW), []);
        }
    }

    #[test]
    fn tighter_limits_are_exceeded_at_a_time_that_is_named() {
        let found = faults(&sampled(100.0), &MotionSpec { speed: Some(0.9), ..SLOW });
        assert_eq!(found[0].kind, FaultKind::Limit(Limit::Speed));
        assert!(found[0].message.starts_with("speed 0.99999") && found[0].message.ends_with(" m/s, limit 0.9 m/s"));
        assert!(found[0].from > 0.29 && found[0].from < 0.32, "{}", found[0].from);
        let found = faults(&around_pillar(100.0), &MotionSpec { cable_acceleration: Some(1.0), ..SLOW });
        assert!(
            found
                .iter()
                .any(|fault| fault.kind == FaultKind::Limit(Limit::CableAcceleration) && !fault.culprits.is_empty())
        );
    }

    #[test]
    fn velocities_that_are_a_tenth_too_large_do_not_fit() {
        let mut motion = sampled(100.0);
        motion.velocities.iter_mut().flatten().for_each(|v| *v *= 1.1);
        let found = faults(&motion, &MotionSpec { speed: None, ..SLOW });
        assert!(found.iter().any(|fault| fault.kind == FaultKind::Velocity), "{found:?}");
        let mut motion = around_pillar(100.0);
        motion.velocities.iter_mut().flatten().for_each(|v| *v *= 1.1);
        assert!(faults(&motion, &SLOW).iter().any(|fault| fault.kind == FaultKind::NotExact));
    }

    #[test]
    fn velocities_that_alternate_about_the_right_ones_do_not_fit() {
        let Recorded { times, positions, velocities, .. } = sampled(100.0);
        for size in [0.2, 1.0, 100.0] {
            let mut motion = Recorded {
                times: times.clone(),
                positions: positions.clone(),
                velocities: velocities.clone(),
                ..Recorded::default()
            };
            for (k, velocity) in motion.velocities.iter_mut().flatten().enumerate() {
                velocity.x += if k % 2 == 0 { size } else { -size };
            }
            let found = faults(&motion, &MotionSpec::default());
            assert!(found.iter().any(|fault| fault.kind == FaultKind::Velocity), "{size}: {found:?}");
        }
    }

    #[test]
    fn tensions_between_the_samples_of_an_exact_motion_must_exist() {
        let (scene, ends) = (held(), [Point::new(0.6, 0.8, 0.7), Point::new(1.3, 1.1, 0.9)]);
        let mut spec = scene.spec().clone();
        let RobotSource::Inline(robot) = &mut spec.robot else { panic!("the robot is part of the scene") };
        robot.mass = None;
        let fast =
            MotionSpec { acceleration: Some(3000.0), jerk: Some(1e6), blend: Some(0.0), ..MotionSpec::default() };
        let weightless = Scene::new(spec).unwrap();
        let path = crate::path::held(&weightless, &ends);
        let compiled = compiled(&weightless);
        let trajectory = Trajectory::new(&compiled, &path, &fast, &Watch::NONE).unwrap();
        // Two samples, both at rest.
        let file = TrajectoryFile::of(&compiled, &path, &trajectory, 0.1, &Watch::NONE).unwrap();
        let motion = Recorded::of(&file).unwrap();
        assert_eq!(motion.times.len(), 2);
        let report = check(&scene, &motion, &fast);
        assert!(report.exact && report.faults.iter().any(|fault| fault.kind == FaultKind::NoTensions), "{report:?}");
        assert_eq!(check(&weightless, &motion, &fast).faults, []);
    }

    #[test]
    fn accelerations_in_another_unit_do_not_fit() {
        let mut motion = Recorded { tensions: None, ..sampled(100.0) };
        motion.accelerations.iter_mut().flatten().for_each(|a| *a /= 9.81);
        assert!(faults(&motion, &SLOW).iter().any(|fault| fault.kind == FaultKind::Inconsistent));
    }

    #[test]
    fn few_samples_do_not_excuse_an_overlap() {
        // 2 mm through the floor; with a sample each half second, a motion may deviate from straight lines by far more.
        let scene = crate::testing::empty();
        let moving = crate::testing::moving(&scene, Point::new(0.5, 1.0, 0.023), Point::new(1.5, 1.0, 0.023), 4);
        let report = check(&scene, &Recorded::of(&moving).unwrap(), &MotionSpec::default());
        assert!(report.faults.iter().any(|fault| fault.message.starts_with("the platform leaves the workspace by 2")));
        // 1 mm above it, nothing is wrong; positions alone do not tell enough.
        let moving = crate::testing::moving(&scene, Point::new(0.5, 1.0, 0.026), Point::new(1.5, 1.0, 0.026), 4);
        let known = Recorded::of(&moving).unwrap();
        let report = check(&scene, &known, &MotionSpec::default());
        assert_eq!((report.faults, report.notes.len()), (Vec::new(), 1)); // that tensions are not limited
        let bare = Recorded { velocities: None, accelerations: None, ..known };
        let report = check(&scene, &bare, &MotionSpec::default());
        assert_eq!(report.faults, []);
        assert!(report.notes.iter().any(|note| note.contains("more samples tell more")), "{:?}", report.notes);
    }

    #[test]
    fn sampled_velocities_locate_a_bend_between_samples() {
        let exact = around_pillar(1000.0);
        let (curve, timing) = exact.exact.clone().unwrap();
        let coarse = Recorded { exact: None, ..around_pillar(20.0) };
        let (smooth, away) = coarse.smoothed().unwrap();
        let mut largest = [0.0_f64; 2];
        for (k, time) in smooth.times.iter().enumerate() {
            let found = (smooth.positions[k] - Motion::at(&curve, &timing, *time).position).norm();
            let allowed = away[k.min(away.len() - 1)];
            assert!(found <= allowed + 1e-12, "{time}: {found} {allowed}");
            largest = [largest[0].max(found), largest[1].max(allowed)];
        }
        let chords = (0..coarse.times.len() - 1).map(|k| coarse.sag(k, &coarse.motions(hard1().orientation()), 0.0));
        let chords = chords.fold(0.0, f64::max);
        assert!(largest[0] > 1e-6 && largest[1] < 0.7 * chords, "{largest:?} {chords}");
    }

    /// `held` with a required force, N.
    fn requiring(force: f64) -> Scene {
        let margin = Some(MarginSpec::Projected);
        let wrench = WrenchSpec { force: Some(force), margin, ..WrenchSpec::default() };
        scene(SceneSpec { wrench: Some(wrench), ..held().spec().clone() })
    }

    #[test]
    fn a_shortfall_of_wrenches_is_excused_where_the_motion_may_not_be_so_short() {
        let (from, to) = (Point::new(1.0, 1.0, 0.9), Point::new(1.4, 1.2, 1.1));
        let measures = crate::wrench::measures(&requiring(1.0)).unwrap();
        let measure = &measures[0];
        let (least, at) = crate::wrench::least_slack(measure, &from, &to);
        let worst = from + (to - from) * at;
        let slack = |axis: usize, by: f64| measure.slack(&(worst + Vector::ith(axis, by)));
        let gradient = Vector::from_fn(|axis, _| (slack(axis, 1e-4) - slack(axis, -1e-4)) / 2e-4).norm();
        // At 8 m/s² between rest and rest; positions alone show how far from straight lines the motion may be.
        let moving = |samples: usize| {
            let known = Recorded::of(&crate::testing::moving(&held(), from, to, samples)).unwrap();
            let shorter = ((to - from).norm() / 8.0_f64).sqrt();
            Recorded {
                times: known.times.iter().map(|t| t * shorter).collect(),
                positions: known.positions,
                ..Recorded::default()
            }
        };
        let excused = |motion: &Recorded, lacking: f64| {
            let report = check(&requiring(1.0 + least + lacking), motion, &MotionSpec::default());
            let wrench = |fault: &Fault| fault.message.contains("the cables cannot balance");
            assert!(report.faults.iter().all(wrench), "{:?}", report.faults);
            report.valid
        };
        // Twelve samples: up to 2 mm from straight lines, of which 0.1 mm counts. With 1200, less than a micrometre.
        let (coarse, fine) = (moving(12), moving(1200));
        for share in [0.5, 1.0] {
            assert!(excused(&coarse, share * 1e-4 * gradient) && !excused(&fine, share * 1e-4 * gradient), "{share}");
            assert!(excused(&fine, share * 1e-7 * gradient), "{share}");
        }
        let steepest = measure.steepness(&worst, 1e-3);
        assert!(steepest < 5.0 * gradient && !excused(&coarse, 1e-4 * steepest), "{gradient} {steepest}");
        assert!(!excused(&fine, 1e-6 * steepest));
    }

    #[test]
    fn nothing_excuses_a_large_shortfall_of_wrenches_near_an_outlet() {
        // In one step to a place some 3 cm from an outlet, where slack changes tens of times faster than on most of the way.
        let (from, to) = (Point::new(1.3, 1.3, 1.3), Point::new(0.02, 0.02, 0.02));
        let measures = crate::wrench::measures(&requiring(1.0)).unwrap();
        let least = crate::wrench::least_slack(&measures[0], &from, &to).0;
        let moving = Recorded { times: vec![0.0, 1.0], positions: vec![from, to], ..Recorded::default() };
        let report = check(&requiring(1.0 + least + 1.5), &moving, &MotionSpec::default());
        assert!(report.faults.iter().any(|fault| fault.message.contains("the cables cannot balance")), "{report:?}");
    }

    #[test]
    fn a_sample_moved_into_an_obstacle_is_found() {
        // Upward beside the pillar, whose face is at x = 0.85; the platform is 0.15 m wide.
        let (from, to) = (Point::new(0.7745, 1.0, 0.3), Point::new(0.7745, 1.0, 1.3));
        let file = crate::testing::moving(&hard1(), from, to, 200);
        let mut motion = Recorded::of(&file).unwrap();
        let spec = MotionSpec::default();
        motion.tensions = None;
        let collides = |found: &[Fault]| found.iter().any(|fault| fault.culprits == ["platform", "pillar"]);
        let before = faults(&motion, &spec);
        assert!(!collides(&before), "{before:?}");
        motion.positions[100].x += 1e-3;
        let found = faults(&motion, &spec);
        assert!(collides(&found), "{found:?}");
        let fault = found.iter().find(|fault| fault.culprits == ["platform", "pillar"]).unwrap();
        assert!((fault.from - 1.0).abs() < 0.011 && fault.message.starts_with("the platform meets pillar, 0.5"));
        assert!(found.iter().any(|fault| fault.kind == FaultKind::CableLength && fault.time == 1.0));
    }

    #[test]
    fn tensions_keep_their_limits_and_the_balance() {
        let faults = |motion: &Recorded| check(&held(), motion, &SLOW).faults;
        assert_eq!(faults(&with_tensions()), []);
        let mut motion = with_tensions();
        motion.tensions.as_mut().unwrap()[50][3] = 9.0;
        let found = faults(&motion);
        let of = |kind| found.iter().find(|fault| fault.kind == kind).unwrap();
        assert_eq!((of(FaultKind::Limit(Limit::Tension)).time, of(FaultKind::Balance).time), (0.5, 0.5));
        assert_eq!(of(FaultKind::Limit(Limit::Tension)).message, "cable 3: tension 9 N, limits 10 N and 1000 N");
        let mut motion = with_tensions();
        motion.accelerations.iter_mut().flatten().for_each(|a| *a *= 0.0);
        assert!(faults(&motion).iter().any(|fault| fault.kind == FaultKind::Balance));
    }

    #[test]
    fn tensions_are_those_that_the_motion_or_the_robot_names() {
        let kinds = |scene: &Scene, motion: &Recorded| {
            let faults = check(scene, motion, &SLOW).faults;
            faults.iter().map(|fault| fault.kind).collect::<Vec<_>>()
        };
        let (chosen, middle) = (held().with_tensions(Distribution::Least), with_tensions());
        assert_eq!(middle.tension_distribution, Some(Distribution::Middle));
        assert_eq!(kinds(&chosen, &middle), []); // its own name counts
        let unnamed = Recorded { tension_distribution: None, ..middle.clone() };
        assert_eq!(
            (kinds(&held(), &unnamed), kinds(&chosen, &unnamed)),
            (vec![], vec![FaultKind::TensionDistribution])
        );
        let renamed = Recorded { tension_distribution: Some(Distribution::P4), ..middle };
        let report = check(&held(), &renamed, &SLOW);
        assert_eq!(report.faults.len(), 1);
        assert!(report.faults[0].message.contains(": tension by `p4` "), "{}", report.faults[0].message);
        let path = [Point::new(0.6, 0.8, 0.7), Point::new(1.3, 1.1, 0.9)];
        for chosen in [Distribution::Least, Distribution::P4, Distribution::P8] {
            let motion = along(&held().with_tensions(chosen), &path, 100.0);
            assert_eq!(motion.tension_distribution, Some(chosen));
            assert_eq!(kinds(&held(), &motion), []);
            assert_eq!((&motion.times, &motion.positions), (&with_tensions().times, &with_tensions().positions));
        }
    }

    #[test]
    fn without_columns_tensions_must_exist() {
        let positions = [1.0, 1.1, 1.0].map(|z| Point::new(0.6, 0.8, z)).to_vec();
        let jump = Recorded { times: vec![0.0, 0.01, 0.02], positions, ..Recorded::default() };
        let report = check(&held(), &jump, &MotionSpec::default());
        assert!(report.faults.iter().any(|fault| fault.kind == FaultKind::NoTensions), "{report:?}");
        let Recorded { times, positions, path, .. } = with_tensions();
        let bare = Recorded { times, positions, path, ..Recorded::default() };
        let report = check(&held(), &bare, &SLOW);
        assert_eq!((report.faults, report.notes), (Vec::new(), Vec::new()));
    }
}
