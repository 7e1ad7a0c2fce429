//! Timed motions: worked examples, and limits at many instants of motions along planned paths.

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::model::Scene;
use cdpr_core::model::spec::{
    CableSpec, ClearancesSpec, MotionSpec, PairClearanceSpec, RobotSource, RobotSpec, SceneSpec,
};
use cdpr_core::path::held;
use cdpr_core::path::positions;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::testing::{empty, hard1, hard3};
use cdpr_core::trajectory::curve::Piece;
use cdpr_core::trajectory::motion::Rates;
use cdpr_core::trajectory::timing::Phase;
use cdpr_core::trajectory::winches::Span;
use cdpr_core::trajectory::{Curve, Limit, Motion, Passing, Trajectory, Winches};
use cdpr_core::trajectory_check::{FaultKind, Recorded, TrajectoryRules, check_trajectory};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{Demand, DemandFacets, Statics, TensionQp, measures};
use cdpr_tests::built_scene;
use cdpr_tests::compiled;
use cdpr_tests::motions::worst;
use nalgebra::Vector6;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::anytime::random_scenes;

const FREE: MotionSpec = MotionSpec {
    speed: Some(1.0),
    acceleration: Some(2.0),
    jerk: None,
    cable_speed: None,
    cable_acceleration: None,
    turn_speed: None,
    turn_acceleration: None,
    blend: None,
    clearance: None,
    wrench_margin: None,
};

fn points(rows: &[[f64; 3]]) -> Vec<Point> {
    rows.iter().map(|row| (*row).into()).collect()
}

fn motion(scene: &Scene, waypoints: &[[f64; 3]], limits: &MotionSpec) -> Trajectory {
    Trajectory::new(&compiled(scene), &held(scene, &points(waypoints)), limits, &Watch::NONE).unwrap()
}

fn refusal(scene: &Scene, waypoints: &[[f64; 3]], limits: &MotionSpec) -> String {
    Trajectory::new(&compiled(scene), &held(scene, &points(waypoints)), limits, &Watch::NONE).unwrap_err().to_string()
}

/// A point mass of 10 kg without gravity, with cables along all axes from so far that they do not turn.
fn far_point() -> Scene {
    let spec = empty().spec().clone();
    let RobotSource::Inline(robot) = spec.robot.clone() else { panic!("the robot is part of the scene") };
    let cable = |k: usize| CableSpec {
        outlet: std::array::from_fn(
            |axis| if axis == k / 2 { if k.is_multiple_of(2) { 1e5 } else { -1e5 } } else { 0.0 },
        ),
        attachment: [0.0; 3],
        tension: Some([10.0, 100.0]),
        ..CableSpec::default()
    };
    let mut platform = robot.platform.clone();
    platform[0].cuboid = None;
    platform[0].vertices = Some(vec![[0.0; 3]]);
    let robot = RobotSpec { mass: Some(10.0), platform, cables: (0..6).map(cable).collect(), ..robot };
    Scene::new(SceneSpec { gravity: Some([0.0; 3]), robot: RobotSource::Inline(robot), ..spec }).unwrap()
}

#[test]
fn known_tension_limits_give_the_triangle_profile_time() {
    let unlimited = MotionSpec { speed: None, acceleration: None, ..FREE };
    let found = motion(&far_point(), &[[1.0, 1.0, 0.5], [1.0, 1.0, 1.5]], &unlimited);
    // One cable pulls with 100 N, the other holds against it with 10 N: 9 m/s² for 10 kg.
    let exact = 2.0 * (1.0_f64 / 9.0).sqrt();
    assert!(found.duration() >= exact && found.duration() < exact * (1.0 + 2e-4), "{}", found.duration());
    assert!(
        found
            .limiting()
            .iter()
            .all(|limiting| limiting.limit == Limit::Tension && matches!(limiting.cable, Some(4 | 5)))
    );
    let sample = found.sample(&mut TensionQp::default(), 0.1 * exact).unwrap();
    let tensions = sample.tensions.unwrap();
    assert!((tensions[4] - 100.0).abs() < 0.1 && (tensions[5] - 10.0).abs() < 0.1, "{tensions:?}");
}

#[test]
fn a_wrench_margin_takes_its_force_from_the_acceleration() {
    let unlimited = MotionSpec { speed: None, acceleration: None, wrench_margin: Some(45.0), ..FREE };
    let found = motion(&far_point(), &[[1.0, 1.0, 0.5], [1.0, 1.0, 1.5]], &unlimited);
    let exact = 2.0 * (1.0_f64 / 4.5).sqrt(); // 45 N of 90 N are left
    assert!(found.duration() >= exact && found.duration() < exact * (1.0 + 3e-4), "{}", found.duration());
}

#[test]
fn a_binding_cable_speed_is_reached_and_kept() {
    // Toward the outlet of cable 4, whose length changes as fast as the platform moves.
    let scene = empty();
    let cable = &scene.robot().cables()[4];
    let arm = cable.attachment.coords;
    let toward = (cable.outlet - arm - Point::new(1.0, 1.0, 1.0)).normalize();
    let [from, to] = [-0.6, 0.6].map(|way| Point::new(1.0, 1.0, 1.0) + toward * way);
    let limits = MotionSpec { cable_speed: Some(0.5), ..FREE };
    let found = motion(&scene, &[from.into(), to.into()], &limits);
    // 0.25 s to 0.5 m/s, over 0.0625 m at each end.
    let exact = 0.5 + (1.2 - 0.125) / 0.5;
    assert!((found.duration() - exact).abs() < 1e-3 * exact, "{} {exact}", found.duration());
    // The opposite cable, number 3, is on the same line.
    let bounds: Vec<_> = found.limiting().iter().map(|limiting| (limiting.limit, limiting.cable)).collect();
    assert_eq!((bounds[0], bounds[bounds.len() - 1]), ((Limit::Acceleration, None), (Limit::Acceleration, None)));
    let middle = &bounds[1..bounds.len() - 1];
    assert!(!middle.is_empty() && middle.iter().all(|b| matches!(b, (Limit::CableSpeed, Some(3 | 4)))));
}

#[test]
fn jerk_is_limited_and_the_acceleration_continuous() {
    let limits = MotionSpec { jerk: Some(10.0), ..FREE };
    let found = motion(&empty(), &[[0.5, 1.0, 1.0], [1.5, 1.0, 1.0]], &limits);
    // 0.2 s to 2 m/s², 0.3 s with it, 0.2 s back: 1 m/s after 0.7 s... until 0.5 m are left.
    assert!((found.duration() - 1.7).abs() < 2e-3, "{}", found.duration());
    let mut before = found.at(0.0);
    assert!(before.acceleration.norm() < 1e-12);
    let steps = 20_000;
    for k in 1..=steps {
        let now = found.at(found.duration() * f64::from(k) / f64::from(steps));
        let step = (now.acceleration - before.acceleration).norm();
        assert!(step <= 10.0 * (1.0 + 1e-9) * found.duration() / f64::from(steps) + 1e-12, "{k}");
        before = now;
    }
}

#[test]
fn looser_limits_are_never_slower_under_a_jerk_limit() {
    let line = [[0.5, 1.0, 1.0], [1.5, 1.0, 1.0]];
    for jerk in [1.0, 10.0, 100.0] {
        let duration = |acceleration| {
            let limits = MotionSpec { speed: None, acceleration, jerk: Some(jerk), ..FREE };
            motion(&empty(), &line, &limits).duration()
        };
        // In four quarters of the time the acceleration grows, falls to its negative, and returns: L = J T³/32.
        let fastest = (32.0 / jerk).cbrt();
        let loose = [None, Some(10.0 * jerk), Some(1e3 * jerk), Some(1e6)].map(duration);
        assert!(loose.iter().all(|t| *t >= fastest && *t < fastest * 1.001), "{loose:?} {fastest}");
        let peak = 0.25 * jerk * fastest;
        let tight: Vec<f64> = (1..=20).map(|k| duration(Some(0.07 * f64::from(k) * peak))).collect();
        assert!(tight.windows(2).all(|pair| pair[1] <= pair[0] * 1.001), "{tight:?}");
        // With a constant acceleration in between: A²/J + A T₁ + … = L, a quadratic in the time at constant acceleration.
        let a = 0.35 * peak;
        let exact = a / jerk + (a * a / jerk / jerk + 4.0 / a).sqrt();
        assert!((tight[4] / exact - 1.0).abs() < 2e-3, "{} {exact}", tight[4]);
    }
    // Corners that are passed with a stop, each of its own length.
    let path = [[0.5, 1.0, 1.0], [1.5, 1.0, 1.0], [1.5, 1.02, 1.0], [0.5, 1.02, 1.0]];
    let duration = |acceleration| {
        let limits = MotionSpec { acceleration: Some(acceleration), jerk: Some(10.0), blend: Some(0.0), ..FREE };
        motion(&empty(), &path, &limits).duration()
    };
    let found = [1.0, 2.0, 4.0, 8.0, 1e3].map(duration);
    assert!(found.windows(2).all(|pair| pair[1] <= pair[0] * 1.001), "{found:?}");
}

#[test]
fn paths_touching_a_corner_swing_outward_or_stop() {
    let path = plan(&hard1(), &PlanOptions::default(), &()).unwrap().result.path;
    let outward =
        Trajectory::new(&compiled(&hard1()), &path, &MotionSpec { blend: Some(0.03), ..FREE }, &Watch::NONE).unwrap();
    assert!(outward.corners().iter().all(|corner| corner.passing == Passing::Outward));
    let stopped = Trajectory::new(&compiled(&hard1()), &path, &FREE, &Watch::NONE).unwrap();
    assert!(stopped.corners().iter().all(|corner| corner.passing == Passing::Stop));
    assert!(outward.duration() < 0.95 * stopped.duration(), "{} {}", outward.duration(), stopped.duration());
    for corner in stopped.corners() {
        let time = stopped.timing().when(corner.at);
        assert!(stopped.at(time).velocity.norm() < 1e-6);
    }
}

#[test]
fn no_limit_is_exceeded_at_any_instant_and_nothing_is_hit() {
    let all = MotionSpec { cable_speed: Some(0.8), cable_acceleration: Some(3.0), blend: Some(0.03), ..FREE };
    for scene in [hard1(), hard3(), built_scene("cogiro"), built_scene("ipanema2")] {
        for (seed, clearance) in [(0, None), (1, None), (2, Some(0.01))] {
            let scene = Scene::new(SceneSpec { clearance, ..scene.spec().clone() }).unwrap();
            let planned = plan(&scene, &PlanOptions { seed, ..PlanOptions::default() }, &()).unwrap();
            let (scene, path) = (planned.scene, planned.result.path);
            if path.is_empty() {
                continue;
            }
            for jerk in [None, Some(30.0)] {
                let found =
                    Trajectory::new(&compiled(&scene), &path, &MotionSpec { jerk, ..all }, &Watch::NONE).unwrap();
                let worst = worst(&scene, &positions(&path), &found, 1500);
                assert!(worst.is_sound(), "{} {seed} {clearance:?} {jerk:?}: {worst:?}", scene.name());
            }
        }
    }
}

/// Clearances in general, of a kind, and of a pair.
fn clearances(scene: &Scene, distance: f64, which: u32) -> Scene {
    let obstacle = scene.obstacles()[0].name.clone();
    let own = match which {
        0 => None,
        1 => Some(ClearancesSpec { platform_obstacle: Some(2.0 * distance), ..ClearancesSpec::default() }),
        _ => {
            let between = ["platform".to_string(), obstacle];
            let pairs = vec![PairClearanceSpec { between, clearance: 0.5 * distance }];
            Some(ClearancesSpec { pairs, ..ClearancesSpec::default() })
        }
    };
    Scene::new(SceneSpec { clearance: Some(distance), clearances: own, ..scene.spec().clone() }).unwrap()
}

#[test]
fn motions_keep_clearances_of_all_of_a_kind_and_of_a_pair() {
    let mut timed = 0;
    for (name, scene) in [("hard1", hard1()), ("hard3", hard3()), ("cogiro", built_scene("cogiro"))] {
        for (distance, which) in [(0.01, 0), (0.02, 1), (0.03, 2), (0.045, 0), (0.06, 2)] {
            let scene = clearances(&scene, distance, which);
            let Ok(planned) = plan(&scene, &PlanOptions::default(), &()) else { continue };
            let (scene, path) = (planned.scene, planned.result.path);
            if path.len() < 2 {
                continue;
            }
            timed += 1;
            let limits = MotionSpec { blend: Some(0.05), ..FREE };
            let found = Trajectory::new(&compiled(&scene), &path, &limits, &Watch::NONE).unwrap();
            let worst = worst(&scene, &positions(&path), &found, 1500);
            assert!(worst.is_sound(), "{name} {distance} {which}: {worst:?}");
            let file = TrajectoryFile::of(&compiled(&scene), &path, &found, 100.0, &Watch::NONE).unwrap();
            let rules = TrajectoryRules { limits, ..TrajectoryRules::default() };
            let report = check_trajectory(&scene, &Recorded::of(&file).unwrap(), &rules, &Watch::NONE).unwrap();
            assert!(report.valid, "{name} {distance} {which}: {:?}", report.faults);
            assert_eq!((Some(report.largest), report.nearest), (file.largest, file.nearest));
        }
    }
    assert!(timed >= 10, "{timed}");
}

#[test]
fn motion_clearance_is_lowered_only_on_request() {
    let scene = hard1().with_clearance(0.02).unwrap();
    let path = plan(&scene, &PlanOptions::default(), &()).unwrap().result.path;
    let with = |clearance| MotionSpec { blend: Some(0.05), clearance, ..FREE };
    let timed = |clearance| Trajectory::new(&compiled(&scene), &path, &with(clearance), &Watch::NONE).unwrap();
    let (all, less) = (timed(None), timed(Some(0.005)));
    assert!(less.duration() < 0.95 * all.duration(), "{} {}", less.duration(), all.duration());
    let check = |motion: &Trajectory, clearance| {
        let file = TrajectoryFile::of(&compiled(&scene), &path, motion, 100.0, &Watch::NONE).unwrap();
        let rules = TrajectoryRules { limits: with(clearance), ..TrajectoryRules::default() };
        check_trajectory(&scene, &Recorded::of(&file).unwrap(), &rules, &Watch::NONE).unwrap()
    };
    assert!(check(&all, None).valid && check(&less, Some(0.005)).valid);
    let report = check(&less, None);
    let fault = report.faults.first().unwrap();
    assert_eq!((fault.kind, fault.limit), (FaultKind::Condition, Some(0.02)));
    let found = fault.found.unwrap();
    assert!((0.005..0.02).contains(&found), "{found}");
    let words = format!("with only {:.3} mm between them, 20.000 mm required", 1e3 * found);
    assert!(fault.message.ends_with(&words), "{}", fault.message);
    // A clearance that the path itself does not keep.
    let more = Trajectory::new(&compiled(&scene), &path, &with(Some(0.1)), &Watch::NONE).unwrap_err().to_string();
    assert!(more.contains("100.000 mm required"), "{more}");
}

#[test]
fn tensions_may_bind_on_bends() {
    let scene = built_scene("cogiro");
    let path = plan(&scene, &PlanOptions::default(), &()).unwrap().result.path;
    for (blend, acceleration) in [(0.2, None), (0.05, None), (0.1, Some(20.0))] {
        let limits = MotionSpec { speed: Some(4.0), acceleration, blend: Some(blend), ..FREE };
        let found = Trajectory::new(&compiled(&scene), &path, &limits, &Watch::NONE).unwrap();
        assert!(found.limiting().iter().any(|limiting| limiting.limit == Limit::Tension));
        let worst = worst(&scene, &positions(&path), &found, 2000);
        assert!(worst.is_sound(), "{blend}: {worst:?}");
    }
}

#[test]
fn impossible_limits_and_paths_are_refused_with_a_reason() {
    let (scene, line) = (empty(), [[0.5, 1.0, 1.0], [1.5, 1.0, 1.0]]);
    let with = |change: fn(&mut MotionSpec)| {
        let mut limits = FREE;
        change(&mut limits);
        refusal(&empty(), &line, &limits)
    };
    assert!(with(|l| l.speed = Some(0.0)).contains("speed"));
    assert!(with(|l| l.acceleration = Some(f64::NAN)).contains("acceleration"));
    assert!(with(|l| l.acceleration = None).contains("expected an acceleration, a jerk or a cable_acceleration"));
    assert!(with(|l| l.wrench_margin = Some(1.0)).contains("tensions are not limited"));
    assert!(refusal(&scene, &line[..1], &FREE).contains("at least two"));
    assert!(refusal(&scene, &[line[0], line[0]], &FREE).contains("only one position"));
    assert!(refusal(&scene, &[line[0], [9.0, 1.0, 1.0]], &FREE).contains("leaves the workspace"));
}

#[test]
fn repeated_and_almost_repeated_waypoints_change_nothing() {
    let scene = empty();
    let plain = motion(&scene, &[[0.5, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.5, 1.0]], &FREE);
    let step = 1e-9;
    let repeated =
        [[0.5, 1.0, 1.0], [0.5, 1.0, 1.0], [0.75, 1.0, 1.0], [0.75 + step, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.5, 1.0]];
    let repeated = motion(&scene, &repeated, &FREE);
    assert!((plain.duration() - repeated.duration()).abs() < 1e-6);
}

#[test]
fn default_rates_follow_accelerations() {
    let (scene, line) = (empty(), [[0.5, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.5, 1.0]]);
    // 100 √(a / 0.08) per second, in whole hundreds.
    for (acceleration, rate) in [(2.0, 100.0), (7.9, 100.0), (8.1, 200.0), (130.0, 500.0)] {
        let limits = MotionSpec { blend: Some(0.05), acceleration: Some(acceleration), ..MotionSpec::default() };
        let (found, path) = (motion(&scene, &line, &limits), held(&scene, &points(&line)));
        let file = TrajectoryFile::of(&compiled(&scene), &path, &found, None, &Watch::NONE).unwrap();
        assert_eq!(file.rate, rate);
        for (k, ends) in file.points().windows(2).enumerate() {
            for part in 1..10 {
                let share = f64::from(part) / 10.0;
                let on_line = ends[0] + (ends[1] - ends[0]) * share;
                let exact = found.at((file.times[k] + share / rate).min(found.duration())).position;
                assert!((exact - on_line).norm() < 1e-4, "{acceleration}: {exact} is away from {on_line}");
            }
        }
    }
}

/// A turn moves the farthest point of the platform, 109 mm from its origin.
#[test]
fn default_rates_follow_angular_accelerations() {
    let scene = empty();
    let reach = Vector::new(0.075, 0.075, 0.025).norm();
    let turned = |angle: f64| Rotation::from_scaled_axis(Vector::z() * angle);
    let path = [(1.0, 0.0), (1.001, 0.3)].map(|(x, angle)| Pose::new(Point::new(x, 1.0, 1.0), turned(angle)));
    // 100 √(a / 8) per second, in whole hundreds; the origin hardly accelerates.
    for (acceleration, rate) in [(7.0, 100.0), (8.5, 200.0), (31.0, 200.0), (33.0, 300.0)] {
        let turn_acceleration = Some(acceleration / reach);
        let limits =
            MotionSpec { turn_acceleration, acceleration: Some(1000.0), blend: Some(0.0), ..MotionSpec::default() };
        let found = Trajectory::new(&compiled(&scene), &path, &limits, &Watch::NONE).unwrap();
        let file = TrajectoryFile::of(&compiled(&scene), &path, &found, None, &Watch::NONE).unwrap();
        assert_eq!(file.rate, rate, "{acceleration}");
    }
}

/// Rather than at a lower rate than a hundred per second, a motion of days is not written at all.
#[test]
fn the_default_rate_is_never_below_a_hundred() {
    let (scene, line) = (empty(), [[0.5, 1.0, 1.0], [1.0, 1.0, 1.0]]);
    let limits = MotionSpec { speed: Some(1e-6), acceleration: Some(1.0), blend: Some(0.0), ..MotionSpec::default() };
    let (found, path) = (motion(&scene, &line, &limits), held(&scene, &points(&line)));
    let said = TrajectoryFile::of(&compiled(&scene), &path, &found, None, &Watch::NONE).unwrap_err().to_string();
    assert!(said.contains("found 100 per second for 501000"), "{said}");
}

#[test]
fn a_file_holds_samples_at_its_rate_and_the_exact_motion() {
    let (scene, line) = (empty(), [[0.5, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.5, 1.0]]);
    let found = motion(&scene, &line, &MotionSpec { blend: Some(0.05), jerk: Some(20.0), ..FREE });
    let path = held(&scene, &points(&line));
    let file = TrajectoryFile::of(&compiled(&scene), &path, &found, 100.0, &Watch::NONE).unwrap();
    assert_eq!(file.times.len(), (file.duration * 100.0).ceil() as usize + 1);
    let last = (100.0 * file.duration).ceil() / 100.0;
    assert_eq!((file.times[7], file.times[file.times.len() - 1]), (0.07, last));
    cdpr_files::check_trajectory(&file).unwrap();
    let read: TrajectoryFile = serde_json::from_str(&serde_json::to_string(&file).unwrap()).unwrap();
    assert_eq!(read, file);
    let (curve, timing) = read.exact().unwrap();
    assert_eq!((&curve, &timing), (found.curve(), found.timing()));
    assert!(
        TrajectoryFile::of(&compiled(&scene), &path, &found, 1e9, &Watch::NONE)
            .unwrap_err()
            .to_string()
            .contains("rate")
    );
}

#[test]
fn a_path_to_the_verge_of_what_the_cables_hold_gets_a_motion() {
    for name in ["cogiro", "caroca", "ipanema2"] {
        let mut spec = built_scene(name).spec().clone();
        (spec.obstacles, spec.wrench, spec.touch, spec.ignore) = Default::default();
        spec.wrench = Some(Default::default());
        let scene = Scene::new(spec).unwrap();
        let (from, measures) = (scene.start().unwrap(), measures(&scene).unwrap());
        let slack = |position: &Point| measures.iter().map(|m| m.slack(position)).fold(f64::INFINITY, f64::min);
        assert!(slack(&from) > 1.0, "{name}");
        let mut timed = 0;
        for direction in [Vector::x(), -Vector::x(), Vector::y(), -Vector::y(), Vector::z()] {
            // The end is where so much slack is left, N: the reserve of 0.01 % takes more.
            for left in [1e-2, 1e-3] {
                let (mut inside, mut outside) = (0.0, 20.0);
                for _ in 0..80 {
                    let middle = 0.5 * (inside + outside);
                    let holds = slack(&(from + direction * middle)) >= left;
                    if holds { inside = middle } else { outside = middle }
                }
                let ends = [from, from + direction * inside];
                let path = held(&scene, &ends);
                let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).unwrap();
                if inside < 0.1 || !engine.motion_valid(&ends[0], &ends[1]) {
                    continue;
                }
                timed += 1;
                let found = Trajectory::new(&compiled(&scene), &path, &FREE, &Watch::NONE).unwrap();
                let worst = worst(&scene, &ends, &found, 2000);
                assert!(worst.is_sound(), "{name} {direction} {left}: {worst:?}");
                let file = TrajectoryFile::of(&compiled(&scene), &path, &found, 100.0, &Watch::NONE).unwrap();
                let rules = TrajectoryRules { limits: FREE, ..TrajectoryRules::default() };
                let report = check_trajectory(&scene, &Recorded::of(&file).unwrap(), &rules, &Watch::NONE).unwrap();
                assert!(report.valid, "{name} {direction} {left}: {:?}", report.faults);
            }
        }
        assert!(timed >= 2, "{name}: {timed}");
    }
}

#[test]
fn a_tension_reserve_leaves_at_least_the_spare_slack() {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let mut largest = 0.0_f64;
    for name in ["cogiro", "caroca", "ipanema2"] {
        let scene = built_scene(name);
        let (start, statics) = (scene.start().unwrap(), Statics::of(&scene).unwrap());
        let winches = Winches::of(&scene, &MotionSpec::default(), &held(&scene, &[start])).unwrap();
        let whole = DemandFacets::new(statics.clone(), 0.0);
        for _ in 0..200 {
            let step = Vector::from_fn(|_, _| rng.random_range(-0.3..0.3));
            let curve = Curve::new(vec![Piece::line(start, start + step)]);
            let speed = rng.random_range(0.1..2.0);
            let phase = Phase { time: 0.0, s: 0.0, speed, acceleration: rng.random_range(-3.0..3.0), jerk: 0.0 };
            let time = 10_f64.powf(rng.random_range(-4.0..-1.5)).min(0.5 * step.norm() / (speed + 3.0));
            let ends = [0.0, time].map(|t| Motion::on(&curve, 0, &phase.after(t)));
            let rates = Rates::new(&curve.pieces()[0], &phase, &phase.after(time), time);
            let spare = winches.spare(&Span { ends: &ends, rates: &rates, time });
            for share in [0.0, 0.3, 0.5, 1.0] {
                let motion = Motion::on(&curve, 0, &phase.after(share * time));
                let force = motion.acceleration * scene.robot().mass().unwrap();
                let moment = (scene.orientation() * scene.robot().center_of_mass().coords).cross(&force);
                let wrench = Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
                let demand = Demand { position: motion.position, wrenches: [wrench; 2], most: [f64::INFINITY; 2] };
                let (Ok(reserved), Ok(all)) = (winches.tension_shares(&[motion]), whole.shares(&[demand], None)) else {
                    continue;
                };
                let more = all[0][0].slack - reserved[0].slack;
                assert!(more >= spare - 1e-9, "{name}: {more} {spare}");
                largest = largest.max(spare / more);
            }
        }
    }
    assert!(largest > 0.05, "{largest}");
}

#[test]
fn feasible_motions_pass_and_wider_bends_are_not_slower() {
    // Where few tensions are possible, the tensions nearest to the middle of their limits jump from one instant to the
    // next: with hardly any capacity margin, the set of tensions that balance changes its shape within a step.
    let mut spec = built_scene("caroca").spec().clone();
    (spec.obstacles, spec.wrench, spec.query) = (Vec::new(), None, None);
    let scene = Scene::new(spec).unwrap();
    let path = [[0.41, 0.10, 1.02], [0.06, 0.34, 1.39], [0.12, 0.10, 1.61]];
    let duration = |blend: f64| {
        let limits = MotionSpec { speed: None, acceleration: None, blend: Some(blend), ..FREE };
        motion(&scene, &path, &limits).duration()
    };
    let durations = [0.0, 0.008, 0.01, 0.012, 0.013, 0.018, 0.02, 0.03, 0.05].map(duration);
    assert!(durations.windows(2).all(|pair| pair[1] < pair[0]), "{durations:?}");
}

/// A motion along a planned path of a random scene under random limits; `None` if there is no path.
fn random_motion(seed: u64) -> Option<(Scene, Vec<Point>, Trajectory)> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let scenes = random_scenes(3);
    let scene = scenes.draw(seed).unwrap();
    let clearance = [None, Some(10_f64.powf(rng.random_range(-3.0..-1.5)))][rng.random_range(0..2)];
    let scene = Scene::new(SceneSpec { clearance, ..scene.spec().clone() }).unwrap();
    let planned = plan(&scene, &PlanOptions { seed, ..PlanOptions::default() }, &()).unwrap().result;
    let mut maybe = |low: f64, high: f64| rng.random_bool(0.7).then(|| 10_f64.powf(rng.random_range(low..high)));
    let limits = MotionSpec {
        speed: maybe(-2.0, 1.5),
        cable_speed: maybe(-2.0, 1.5),
        cable_acceleration: maybe(-1.0, 2.0),
        turn_speed: None,
        turn_acceleration: None,
        blend: maybe(-5.0, -0.7),
        clearance: None,
        wrench_margin: None,
        acceleration: Some(10_f64.powf(rng.random_range(-1.0..2.0))),
        jerk: rng.random_bool(0.5).then(|| 10_f64.powf(rng.random_range(0.0..4.0))),
    };
    (planned.waypoints().len() > 1).then(|| {
        let found = Trajectory::new(&compiled(&scene), &planned.path, &limits, &Watch::NONE);
        let found = found.unwrap_or_else(|error| panic!("seed {seed}, {limits:?}: {error}"));
        (scene, planned.waypoints(), found)
    })
}

#[test]
fn motions_under_random_limits_in_random_scenes_are_sound() {
    let count = std::env::var("RANDOM_MOTIONS").map_or(24, |count| count.parse().unwrap());
    (0..count).into_par_iter().for_each(|seed| {
        let Some((scene, path, found)) = random_motion(seed) else { return };
        let worst = worst(&scene, &path, &found, 1000);
        assert!(worst.is_sound(), "seed {seed}, {:?}: {worst:?}", found.limits());
    });
}
