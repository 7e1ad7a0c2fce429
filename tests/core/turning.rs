//! Planning for a platform that turns, and known answers for motions with a turn.

use cdpr_core::collision::check_path;
use cdpr_core::path::held;
use cdpr_core::path::length;
use cdpr_core::path::lengths_along;
use cdpr_core::path::tensions_along;
use cdpr_core::plan::Processing;
use cdpr_core::plan::shorten;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use cdpr_core::collision::{Engine, Interference, Kind, Validity};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::model::spec::{TurningAxis, TurningSpec};
use cdpr_core::model::{BodySpec, OrientationSource, Scene, SceneSpec};
use cdpr_core::plan::{PlanOptions, PlanResult, Planned, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::testing::{self, block};

use cdpr_core::watch::Watch;
use cdpr_tests::{Improvements, built_scene, compiled};

fn yaw(angle: f64) -> Rotation {
    Rotation::from_scaled_axis(Vector::z() * angle)
}

/// A point robot's cables and a platform of 0.4 × 0.1 × 0.1 m at (1, 1, 1), beside a wall whose face is at y = 1 + `room`.
fn bar_beside_a_wall(room: f64) -> Scene {
    let mut spec = testing::paper_scene("wall", vec![block("wall", [0.6, 0.2, 0.1], [1.0, 1.1 + room, 1.0])]);
    let cdpr_core::model::RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.platform = vec![BodySpec { cuboid: Some([0.4, 0.1, 0.1]), ..BodySpec::default() }];
    robot.cables.truncate(1);
    (robot.cables[0].outlet, robot.cables[0].attachment) = ([1.0, 1.0, 2.0], [0.0, 0.0, 0.05]);
    Scene::new(spec).unwrap()
}

#[test]
fn a_bar_turns_until_its_corner_meets_a_wall() {
    // A corner at 0.2 m along and 0.05 m across is at height 0.2 sin φ + 0.05 cos φ.
    for angle in [0.1f64, 0.5, 1.0] {
        let room = 0.2 * angle.sin() + 0.05 * angle.cos();
        let engine = compiled(&bar_beside_a_wall(room));
        let at = |angle: f64| Pose::new(Point::new(1.0, 1.0, 1.0), yaw(angle));
        for sign in [1.0, -1.0] {
            assert!(engine.motion_valid(&at(0.0), &at(sign * (angle - 1e-3))), "{angle}");
            assert!(!engine.motion_valid(&at(0.0), &at(sign * (angle + 1e-3))), "{angle}");
            let found = engine.violations(&at(0.0), &at(sign * 1.2));
            assert_eq!(found[0].kind, Kind::PlatformObstacle);
            assert!((1.2 * found[0].at - angle).abs() < 3e-3, "{} {angle}", 1.2 * found[0].at);
        }
    }
}

#[test]
fn a_platform_may_turn_where_it_stands() {
    // On the floor, under a ceiling just as high, and beside a wall that its farthest corner just does not reach.
    let mut spec = bar_beside_a_wall(0.04f64.hypot(0.2) + 0.02).spec().clone();
    spec.workspace.min[2] = 0.95;
    spec.obstacles.push(block("floor", [2.0, 2.0, 0.5], [1.0, 1.0, 0.7]));
    let scene = Scene::new(spec).unwrap();
    let engine = compiled(&scene);
    let at = |angle: f64| Pose::new(Point::new(1.0, 1.0, 1.0), yaw(angle));
    assert!(engine.motion_valid(&at(0.0), &at(3.0)));
    let tilted = Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::from_scaled_axis(Vector::y() * 0.01));
    assert!(!engine.motion_valid(&at(0.0), &tilted));
}

#[test]
fn quaternion_signs_and_half_turn_directions_do_not_matter() {
    let here = Point::new(1.0, 1.0, 1.0);
    let from = Pose::new(here, yaw(0.3));
    let to = Pose::new(here, Rotation::new_unchecked(-yaw(0.4).into_inner()));
    assert!((from.toward(&to).angle - 0.1).abs() < 1e-12 && (from.angle_to(&to) - 0.1).abs() < 1e-12);
    for axis in [Vector::x(), Vector::y(), Vector::z(), Vector::new(1.0, -2.0, 0.5).normalize()] {
        for sign in [1.0, -1.0] {
            let opposite = Rotation::from_scaled_axis(axis * PI) * from.orientation;
            let opposite = Pose::new(here, Rotation::new_unchecked(opposite.into_inner() * sign));
            let (forth, back) = (from.toward(&opposite), opposite.toward(&from));
            assert!((forth.angle - PI).abs() < 1e-12);
            for share in [0.0, 0.2, 0.5, 0.9, 1.0] {
                let apart = forth.at(share).angle_to(&back.at(1.0 - share));
                assert!(apart < 1e-9, "{axis:?} {sign} {share}: {apart}");
            }
        }
    }
    let engine = compiled(&testing::hard1());
    let broken = Pose::new(here, Rotation::new_unchecked(nalgebra::Quaternion::new(f64::NAN, 0.0, 0.0, 0.0)));
    assert!(!engine.motion_valid(&from, &broken) && !engine.state_valid(&broken));
}

fn solved(scene: &Scene, planner: Planner, seed: u64) -> Planned {
    let options = PlanOptions { planner: PlannerOptions::of(planner), seed, ..PlanOptions::default() };
    let planned = plan(scene, &options, &()).unwrap();
    assert_eq!(planned.result.status, Status::Solved, "{planner:?}, seed {seed}");
    planned
}

#[test]
fn a_query_unsolvable_without_turning_is_solved() {
    let scene = built_scene("turn");
    for name in ["along", "across"] {
        let mut spec = SceneSpec { turning: None, ..scene.spec().clone() };
        let query = spec.query.as_mut().unwrap();
        (query.orientation, query.goal_orientation) = (Some(OrientationSource::Named(name.to_string())), None);
        let fixed = plan(&Scene::new(spec).unwrap(), &PlanOptions::default(), &()).unwrap().result;
        assert_ne!(fixed.status, Status::Solved, "{name}");
    }
    for planner in [Planner::Anytime, Planner::RrtConnect, Planner::TwoTrees, Planner::ModifiedRrt] {
        for seed in 0..3 {
            let planned = solved(&scene, planner, seed);
            let poses = &planned.result.path;
            assert!((poses[0].angle_to(poses.last().unwrap()) - FRAC_PI_2).abs() < 1e-9);
            let report = check_path(&**planned.compiled.as_ref().unwrap(), poses, &Watch::NONE).unwrap();
            assert!(report.valid && (report.length - planned.result.cost).abs() < 1e-9);
            assert!(poses.windows(2).all(|pair| {
                let turn = pair[0].toward(&pair[1]);
                turn.angle < 1e-9 || turn.axis.cross(&Vector::z()).norm() < 1e-6 // as the scene asks
            }));
            assert_eq!(solved(&scene, planner, seed).result.waypoints(), planned.result.waypoints());
        }
    }
}

/// Seeds whose paths on `turn.toml` have 7 to 13 waypoints before needless ones are removed.
const WITH_NEEDLESS_WAYPOINTS: [u64; 7] = [0, 1, 2, 3, 4, 19, 21];

/// A planned path, its length before needless waypoints were removed, and a path for which that length was the target.
fn with_and_without_leaving_out(scene: &Scene, seed: u64) -> (PlanResult, f64, PlanResult) {
    let found = solved(scene, Planner::Anytime, seed).result;
    let length = found.history.last().unwrap().cost;
    let settings = PlannerSettings { target_cost: Some(length), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
    let asked = plan(scene, &PlanOptions { seed, planner, ..PlanOptions::default() }, &()).unwrap().result;
    (found, length, asked)
}

#[test]
fn sliding_along_a_contact_takes_few_waypoints() {
    let scene = built_scene("turn");
    let mut given_up = 0;
    for seed in WITH_NEEDLESS_WAYPOINTS {
        let (found, length, asked) = with_and_without_leaving_out(&scene, seed);
        assert!(found.waypoints().len() <= 7, "{seed}: {}", found.waypoints().len());
        assert!(found.cost <= 1.001 * length, "{seed}: {} after {length}", found.cost);
        // A target length is not given up for fewer waypoints.
        assert!(asked.cost <= length, "{seed}: {} instead of {length}", asked.cost);
        given_up += usize::from(found.cost > length * (1.0 + 1e-9));
    }
    assert!(given_up > 0, "no path had a length to give up");
}

#[test]
fn shortening_a_path_of_poses_never_makes_it_longer() {
    let scene = built_scene("turn");
    let engine = compiled(&scene);
    let asked = WITH_NEEDLESS_WAYPOINTS.map(|seed| with_and_without_leaving_out(&scene, seed).2);
    let rough = [1, 2].map(|seed| solved(&scene, Planner::TwoTrees, seed).result);
    for result in asked.iter().chain(&rough) {
        let poses = &result.path;
        let shorter = shorten(&engine, poses, &Processing::StringPulling, &Watch::NONE).unwrap();
        let [before, after] = [poses, &shorter].map(|path| length(&scene, path));
        assert!(after <= before && shorter.len() <= poses.len(), "{after} m instead of {before}");
    }
}

#[test]
fn the_platform_does_not_turn_for_nothing() {
    let hard1 = testing::hard1();
    let turning = Some(TurningSpec { axis: Some(TurningAxis::Fixed([0.0, 0.0, 2.0])), ..TurningSpec::default() });
    let free = Scene::new(SceneSpec { turning, ..hard1.spec().clone() }).unwrap();
    let [level, turned] = [&hard1, &free].map(|scene| solved(scene, Planner::Anytime, 0).result);
    assert!(turned.cost <= level.cost);
    let length = length(&free, &turned.path);
    assert!((length - turned.cost).abs() < 1e-9);
    // A straight line needs no turn.
    let query = Query::of(&free).to(Point::new(0.3, 1.0, 1.0));
    let straight = plan(query, &PlanOptions::default(), &()).unwrap().result;
    assert!(free.keeps_orientation(&straight.path) && (straight.cost - 0.7).abs() < 1e-9);
}

/// Between start and goal a gap of 0.3 m, too narrow for the bar of 0.4 m unless it turns.
fn bar_before_a_gap() -> Scene {
    let mut spec = bar_beside_a_wall(0.0).spec().clone();
    let half = |name: &str, x: f64| block(name, [0.85, 0.1, 1.5], [x, 1.0, 0.75]);
    spec.obstacles = vec![half("left", 0.425), half("right", 1.575)];
    spec.workspace.max[2] = 1.0;
    let query = spec.query.as_mut().unwrap();
    (query.start, query.goal) = (Some([1.0, 0.6, 0.8].into()), Some([1.0, 1.4, 0.8].into()));
    Scene::new(spec).unwrap()
}

#[test]
fn stats_sum_searches_with_and_without_turns() {
    for (still, turns) in [(testing::hard1(), false), (bar_before_a_gap(), true)] {
        let free = Scene::new(SceneSpec { turning: Some(TurningSpec::default()), ..still.spec().clone() }).unwrap();
        let settings = PlannerSettings { max_samples: Some(1000), keep_going: true, ..PlannerSettings::default() };
        let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
        let options = PlanOptions { planner, proof: false, ..PlanOptions::default() };
        let first = plan(&still, &options, &()).unwrap().result;
        let improvements = Improvements::default();
        let both = plan(&free, &options, &improvements).unwrap().result;
        assert_eq!((both.status, free.keeps_orientation(&both.path)), (Status::Solved, !turns));
        assert_eq!((first.stats.samples, both.stats.samples), (1000, 2000));
        assert!(both.stats.nodes > first.stats.nodes && both.stats.motion_checks > first.stats.motion_checks);
        let reported = improvements.reported().into_iter().map(|(seconds, cost, _)| (seconds, cost));
        assert!(both.history.iter().map(|found| (found.seconds, found.cost)).eq(reported));
        assert!(both.history.iter().all(|found| (found.samples > 1000) == turns));
    }
    // Half of the budget goes to the search without turns.
    let still = bar_before_a_gap();
    let free = Scene::new(SceneSpec { turning: Some(TurningSpec::default()), ..still.spec().clone() }).unwrap();
    let options = PlanOptions { budget: Some(Duration::from_millis(600)), proof: false, ..PlanOptions::default() };
    let found = plan(&free, &options, &()).unwrap().result;
    assert!(found.stats.planning_seconds > 0.45 && found.history.iter().all(|found| found.seconds > 0.28));
}

#[test]
fn a_tilt_limit_holds_all_along_a_path() {
    let mut spec = built_scene("turn").spec().clone();
    spec.turning = Some(TurningSpec { max_tilt: Some(5.0), ..TurningSpec::default() });
    let scene = Scene::new(spec.clone()).unwrap();
    let planned = solved(&scene, Planner::RrtConnect, 1);
    for pair in planned.result.path.windows(2) {
        let motion = pair[0].toward(&pair[1]);
        let tilt = |k: i32| (motion.at(f64::from(k) / 20.0).orientation * Vector::z()).angle(&Vector::z());
        assert!((0..=20).map(tilt).all(|tilt| tilt <= 5f64.to_radians() + 1e-6));
    }
    let tilted = Rotation::from_scaled_axis(Vector::x() * 0.2);
    let query = Query::of(&scene).oriented([None, Some(tilted)]).to(Point::new(1.0, 0.4, 1.2));
    let refused = plan(query, &PlanOptions::default(), &()).unwrap().result;
    assert_eq!(refused.status, Status::GoalInvalid);
    assert!(refused.reason().unwrap().sentence().contains("tilts further"));
}

#[test]
fn an_interruption_never_loses_the_path_that_is_known() {
    let still = testing::hard1();
    let mut spec = still.spec().clone();
    spec.turning = Some(TurningSpec::default());
    let turning = Scene::new(spec).unwrap();
    for planner in [Planner::Anytime, Planner::RrtConnect, Planner::TwoTrees] {
        let options = PlanOptions { planner: PlannerOptions::of(planner), proof: false, ..PlanOptions::default() };
        let after = |scene: &Scene, most: usize| {
            let polls = AtomicUsize::new(0);
            let found = plan(scene, &options, &|| polls.fetch_add(1, Ordering::Relaxed) >= most);
            (found.map(|planned| planned.result.status), polls.into_inner())
        };
        // A path without turns is searched first.
        let (known, whole) = (after(&still, usize::MAX).1, after(&turning, usize::MAX).1);
        assert!(known < whole, "{planner:?}: {known} of {whole} polls");
        for most in (0..=30).map(|k| known + k * (whole - known) / 30) {
            let (found, _) = after(&turning, most);
            assert_eq!(found.ok(), Some(Status::Solved), "{planner:?} after {most} of {known} to {whole} polls");
        }
    }
}

#[test]
fn ends_that_the_axis_does_not_allow_are_invalid() {
    let scene = built_scene("turn");
    let tilted = Some(Rotation::from_scaled_axis(Vector::x() * 0.2));
    let query = Query::of(&scene).to(Point::new(1.0, 0.4, 1.0)).starting_at(Point::new(1.0, 0.6, 1.0));
    // Also if both are tilted alike, so that no turn about another axis is left on the way.
    for (ends, status) in [([None, tilted], Status::GoalInvalid), ([tilted, tilted], Status::StartInvalid)] {
        let refused = plan(query.oriented(ends), &PlanOptions::default(), &()).unwrap().result;
        assert_eq!(refused.status, status);
        let reason = refused.reason().unwrap();
        assert_eq!((reason.kind, reason.at), (Kind::TurningAxis, 0.0));
        assert!(reason.sentence().contains("another axis than the scene allows"), "{}", reason.sentence());
    }
}

#[test]
fn a_path_must_turn_about_the_axis_of_the_scene() {
    let mut spec = built_scene("turn").spec().clone();
    let place = Point::new(1.0, 1.0, 1.3);
    let about = |axis: [f64; 3], angle: f64| Rotation::from_scaled_axis(Vector::from(axis).normalize() * angle);
    for axis in [[0.0, 0.0, 2.0], [0.0, 0.3, 1.0]] {
        spec.turning = Some(TurningSpec { axis: Some(TurningAxis::Fixed(axis)), ..TurningSpec::default() });
        let scene = Scene::new(spec.clone()).unwrap();
        let engine = compiled(&scene);
        let kinds = |turns: &[Rotation]| -> Vec<(usize, Kind)> {
            let poses: Vec<Pose> = turns.iter().map(|turn| Pose::new(place, turn * scene.orientation())).collect();
            let report = check_path(&engine, &poses, &Watch::NONE).unwrap();
            report.violations.iter().map(|found| (found.segment, found.violation.kind)).collect()
        };
        let at = |angle: f64| about(axis, angle);
        assert_eq!(kinds(&[at(0.0), at(0.1), at(-0.1), at(-0.1)]), []);
        let aside = about([1.0, 0.0, 0.0], 0.05);
        let off = [(1, Kind::TurningAxis), (2, Kind::TurningAxis)];
        assert_eq!(kinds(&[at(0.0), at(0.1), aside * at(0.1), at(0.2)]), off);
        // In steps too small to be seen one by one.
        let step = |k: usize| about([1.0, 0.0, 0.0], 1.1e-5 * k as f64);
        let found = kinds(&(0..20).map(step).collect::<Vec<_>>());
        assert!(found.len() == 17 && found.iter().all(|(_, kind)| *kind == Kind::TurningAxis), "{found:?}");
    }
}

#[test]
fn tensions_with_turns_match_each_fixed_orientation() {
    let scene = built_scene("cogiro");
    let required = cdpr_core::wrench::constraint::required_of(&scene, None, None).unwrap();
    let place = |x: f64| Point::new(x, 0.0, 2.0);
    let level = *scene.orientation();
    let poses = [(0.0, 0.0), (0.4, 0.2), (0.4, -0.1)].map(|(x, angle)| Pose::new(place(x), yaw(angle) * level));
    let rows = tensions_along(&scene, &required, &poses, 0.1, None, &Watch::NONE).unwrap();
    let lengths = lengths_along(&scene, &poses, 0.1).unwrap();
    assert!((rows[rows.len() - 1].place.s - length(&scene, &poses)).abs() < 1e-12);
    assert!(rows.len() > 8 && rows.iter().map(|row| &row.place).eq(&lengths));
    for row in rows {
        let position = Point::from(row.place.position);
        let there = scene.turned(row.place.orientation.unwrap().into()).unwrap();
        let path = held(&there, &[position, position + Vector::x()]);
        let alone = tensions_along(&there, &required, &path, 2.0, None, &Watch::NONE).unwrap().remove(0);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * (1.0 + b.abs());
        let all = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| near(*a, *b));
        assert!(all(&row.place.lengths, &alone.place.lengths) && row.rank == alone.rank);
        assert!(all(&row.tensions.unwrap(), &alone.tensions.unwrap()));
        assert!(near(row.capacity_margin.unwrap(), alone.capacity_margin.unwrap()));
        assert!(near(row.moment_margin.unwrap(), alone.moment_margin.unwrap()));
    }
    // A path without length has one row.
    assert_eq!(tensions_along(&scene, &required, &poses[..1], 0.1, None, &Watch::NONE).unwrap().len(), 1);
}

#[test]
fn a_platform_that_must_not_tilt_still_turns_about_the_vertical() {
    let mut spec = built_scene("turn").spec().clone();
    spec.turning = Some(TurningSpec { max_tilt: Some(0.0), ..TurningSpec::default() });
    let engine = compiled(&Scene::new(spec).unwrap());
    let at = |k: i32| Pose::new(Point::new(1.0, 1.0, 1.3), yaw(0.01 * f64::from(k)));
    assert!((0..50).all(|k| engine.motion_valid(&at(k), &at(k + 1))));
    let tilted = Pose::new(Point::new(1.0, 1.0, 1.3), Rotation::from_scaled_axis(Vector::y() * 1e-3));
    assert!(!engine.state_valid(&tilted));
}

#[test]
fn a_query_with_turns_takes_the_engine_it_is_given() {
    let scene = built_scene("turn");
    let engine = CompiledScene::new(&scene, Engine::Gjk, Interference::Exact, &Watch::NONE).unwrap().into();
    let planned = plan(Query::of(&scene).by(&engine), &PlanOptions::default(), &()).unwrap();
    assert_eq!(planned.result.status, Status::Solved);
    assert!(Arc::ptr_eq(&planned.compiled.unwrap(), &engine));
}

/// Poses that all have the orientation of the scene are measured as a path without a turn: exactly, not from samples.
#[test]
fn poses_without_a_turn_are_measured_like_positions() {
    for name in ["hard3", "cogiro"] {
        let scene = built_scene(name);
        let planned = plan(&scene, &PlanOptions::default(), &()).unwrap();
        let compiled = planned.compiled.unwrap();
        let report = check_path(&*compiled, &planned.result.path, &Watch::NONE).unwrap();
        let positions = planned.result.waypoints();
        assert_eq!(report, check_path(compiled.level(), &positions, &Watch::NONE).unwrap(), "{name}");
    }
}
