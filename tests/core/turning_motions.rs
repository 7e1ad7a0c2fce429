//! Timed motions of a platform that turns: worked examples, limits at many instants, and hostile paths.

use cdpr_core::path::held;
use std::f64::consts::PI;

use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::kinematics::{cable_lengths, wrench_matrix};
use cdpr_core::model::spec::{CableSpec, MotionSpec, RobotSource};
use cdpr_core::model::{BodySpec, InertiaSpec, Scene, SceneSpec};
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::testing::{empty, paper_robot, paper_scene};
use cdpr_core::trajectory::curve::Piece;
use cdpr_core::trajectory::motion::Rates;
use cdpr_core::trajectory::timing::Phase;
use cdpr_core::trajectory::winches::{RecentTensions, Span};
use cdpr_core::trajectory::{Attitude, Curve, Limit, Motion, Passing, Trajectory, Winches};
use cdpr_core::trajectory_check::{FaultKind, Recorded, TrajectoryReport, TrajectoryRules, check_trajectory};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{Loads, TensionQp};
use cdpr_tests::{built_scene, compiled};
use nalgebra::{DVector, Vector6};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use cdpr_core::collision::Validity;

pub const FREE: MotionSpec = MotionSpec {
    speed: Some(1.0),
    acceleration: Some(2.0),
    turn_speed: Some(1.5),
    turn_acceleration: Some(4.0),
    jerk: None,
    cable_speed: None,
    cable_acceleration: None,
    blend: None,
    clearance: None,
    wrench_margin: None,
};

pub fn yaw(angle: f64) -> Rotation {
    Rotation::from_scaled_axis(Vector::z() * angle)
}

pub fn at([x, y, z]: [f64; 3], angle: f64) -> Pose {
    Pose::new(Point::new(x, y, z), yaw(angle))
}

pub fn motion(scene: &Scene, poses: &[Pose], limits: &MotionSpec) -> Trajectory {
    Trajectory::new(&compiled(scene), poses, limits, &Watch::NONE).unwrap()
}

fn refusal(scene: &Scene, poses: &[Pose], limits: &MotionSpec) -> String {
    Trajectory::new(&compiled(scene), poses, limits, &Watch::NONE).unwrap_err().to_string()
}

pub fn file(scene: &Scene, poses: &[Pose], motion: &Trajectory, rate: f64) -> TrajectoryFile {
    TrajectoryFile::of(&compiled(scene), poses, motion, rate, &Watch::NONE).unwrap()
}

pub fn check(scene: &Scene, motion: &Recorded, limits: &MotionSpec) -> TrajectoryReport {
    let rules = TrajectoryRules { limits: *limits, ..TrajectoryRules::default() };
    check_trajectory(scene, motion, &rules, &Watch::NONE).unwrap()
}

#[test]
fn a_turn_on_the_spot_takes_the_time_of_a_trapezoid() {
    let middle = [1.0, 1.0, 1.0];
    let limits = MotionSpec { turn_speed: Some(0.5), turn_acceleration: Some(1.0), ..MotionSpec::default() };
    for angle in [1.0, -1.0, 0.3] {
        let found = motion(&empty(), &[at(middle, 0.0), at(middle, angle)], &limits);
        let exact = 0.5 + f64::abs(angle) / 0.5; // half a second to 0.5 rad/s, half a second to rest
        assert!(found.duration() >= exact * (1.0 - 1e-12) && found.duration() < exact * (1.0 + 1e-4), "{angle}");
        let half = found.at(0.5 * found.duration());
        assert!((half.angular_velocity - Vector::z() * (0.5 * angle.signum())).norm() < 1e-4);
        assert!(half.velocity.norm() == 0.0 && half.orientation.angle_to(&yaw(0.5 * angle)) < 1e-9);
        let bounds: Vec<Limit> = found.limiting().iter().map(|limiting| limiting.limit).collect();
        assert_eq!(bounds, [Limit::TurnAcceleration, Limit::TurnSpeed, Limit::TurnAcceleration]);
        assert_eq!(found.curve().length(), 0.0);
    }
}

/// A body of 10 kg without gravity on twelve cables from so far that they do not turn. The only moment about z is that of four
/// cables along x, which pull half a metre beside its centre.
fn rotor(inertia: f64) -> Scene {
    let mut robot = paper_robot();
    let cable = |k: usize| {
        let (axis, beside, way) = (k / 4, if k & 2 == 0 { 0.5 } else { -0.5 }, if k & 1 == 0 { 1e5 } else { -1e5 });
        let mut attachment = [0.0; 3];
        attachment[(axis + 1) % 3] = beside;
        let mut outlet = [1.0; 3];
        outlet[axis] += way;
        outlet[(axis + 1) % 3] += beside;
        CableSpec { outlet, attachment, tension: Some([10.0, 100.0]), ..CableSpec::default() }
    };
    robot.cables = (0..12).map(cable).collect();
    robot.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
    robot.inertia = Some(InertiaSpec::Diagonal([inertia; 3]));
    let mut spec = SceneSpec { gravity: Some([0.0; 3]), ..paper_scene("rotor", Vec::new()) };
    spec.robot = RobotSource::Inline(robot);
    Scene::new(spec).unwrap()
}

#[test]
fn tensions_and_a_known_inertia_give_the_time_of_a_turn() {
    // 90 N of two cables, at 0.5 m on both sides: 90 N·m, or 10 rad/s² for 9 kg·m².
    let poses = [at([1.0, 1.0, 1.0], -0.01), at([1.0, 1.0, 1.0], 0.01)];
    let found = motion(&rotor(9.0), &poses, &MotionSpec::default());
    let exact = 2.0 * (0.02_f64 / 10.0).sqrt();
    assert!(found.duration() >= exact && found.duration() < exact * (1.0 + 5e-4), "{} {exact}", found.duration());
    assert!(found.limiting().iter().all(|limiting| limiting.limit == Limit::Tension));
    let slow = motion(&rotor(36.0), &poses, &MotionSpec::default());
    assert!((slow.duration() / found.duration() - 2.0).abs() < 1e-3);
}

#[test]
fn level_poses_are_timed_like_positions() {
    let points = [[0.5, 1.0, 1.0], [1.2, 1.0, 1.0], [1.2, 1.4, 1.0]];
    let limits = MotionSpec { blend: Some(0.05), ..FREE };
    let plain =
        Trajectory::new(&compiled(&empty()), &held(&empty(), &points.map(Point::from)), &limits, &Watch::NONE).unwrap();
    let posed = motion(&empty(), &points.map(|p| at(p, 0.0)), &limits);
    assert_eq!((plain.timing(), plain.curve()), (posed.timing(), posed.curve()));
    let [a, b] = [plain, posed].map(|motion| {
        TrajectoryFile::of(&compiled(&empty()), &points.map(|p| at(p, 0.0)), &motion, 50.0, &Watch::NONE).unwrap()
    });
    assert!(a == b && a.orientations.is_none() && a.waypoint_orientations.is_none());
}

#[test]
fn turning_corners_use_bends_and_stop_without_blend() {
    let scene = empty();
    let poses = [
        at([0.5, 1.0, 1.0], 0.0),
        at([1.0, 1.0, 1.0], 0.0),
        at([1.0, 1.4, 1.0], 0.0),
        at([1.2, 1.4, 1.0], 0.3),
        at([1.2, 1.0, 1.0], 0.3),
        at([1.4, 1.0, 1.2], 0.3),
        at([1.4, 1.0, 1.2], 0.1),
    ];
    let timed = |blend: f64| motion(&scene, &poses, &MotionSpec { blend: Some(blend), ..FREE });
    let (found, stopping) = (timed(0.05), timed(0.0));
    let passed = |motion: &Trajectory| -> Vec<(usize, Passing, bool)> {
        motion.corners().iter().map(|c| (c.waypoint, c.passing, c.turn)).collect()
    };
    let all = |passing: Passing| {
        [(1, false), (2, true), (3, true), (4, false), (5, true)].map(|(k, turn)| (k, passing, turn))
    };
    assert_eq!(passed(&found), all(Passing::Rounded));
    assert_eq!(passed(&stopping), all(Passing::Stop));
    assert!(found.duration() < 0.8 * stopping.duration());
    for corner in found.corners() {
        let (there, waypoint) = (found.at(found.timing().when(corner.at)), &poses[corner.waypoint]);
        assert!(there.velocity.norm() + there.angular_velocity.norm() > 0.1);
        let turned = there.orientation.angle_to(&waypoint.orientation);
        assert!((there.position - waypoint.position).norm() + 0.1 * turned <= corner.deviation + 1e-9);
    }
    for corner in stopping.corners() {
        let (there, waypoint) = (stopping.at(stopping.timing().when(corner.at)), &poses[corner.waypoint]);
        assert!(there.velocity.norm() < 1e-6 && (there.position - waypoint.position).norm() < 1e-9);
        assert!(there.orientation.angle_to(&waypoint.orientation) < 1e-9);
    }
    let end = found.at(found.duration());
    assert!((end.position - poses[6].position).norm() < 1e-9 && end.orientation.angle_to(&yaw(0.1)) < 1e-9);
}

#[test]
fn a_turn_in_many_steps_is_timed_as_one() {
    let [from, to] = [at([0.8, 1.0, 1.0], 0.0), at([1.2, 1.1, 1.0], 0.25)];
    let whole = from.toward(&to);
    let steps: Vec<Pose> = (0..=40).map(|k| whole.at(f64::from(k) / 40.0)).collect();
    let [one, many] = [vec![from, to], steps].map(|poses| motion(&empty(), &poses, &FREE));
    assert_eq!((one.timing(), many.corners()), (many.timing(), &[][..]));
}

/// The largest share by which a motion exceeds a limit at many instants, from its states and from differences between them.
pub fn excess(scene: &Scene, motion: &Trajectory, steps: u32) -> f64 {
    let (limits, robot) = (motion.limits(), scene.robot());
    let mut worst = f64::NEG_INFINITY;
    let mut see = |value: f64, limit: Option<f64>, slack: f64| {
        worst = worst.max(limit.map_or(worst, |limit| (value - slack) / limit - 1.0));
    };
    let mut solver = TensionQp::default();
    let h = 1e-6 * motion.duration();
    for k in 0..=steps {
        let time = motion.duration() * f64::from(k) / f64::from(steps);
        let now = motion.sample(&mut solver, time).unwrap();
        see(now.motion.velocity.norm(), limits.speed, 0.0);
        see(now.motion.acceleration.norm(), limits.acceleration, 0.0);
        see(now.motion.angular_velocity.norm(), limits.turn_speed, 0.0);
        see(now.motion.angular_acceleration.norm(), limits.turn_acceleration, 0.0);
        for winding in &now.windings {
            see(winding.speed.abs(), limits.cable_speed, 0.0);
            see(winding.acceleration.abs(), limits.cable_acceleration, 0.0);
        }
        if let (Some(tensions), Some(bounds)) = (&now.tensions, motion.winches().tension_limits()) {
            assert!(tensions.iter().zip(bounds).all(|(t, [least, most])| t >= least && t <= most), "{tensions:?}");
        }
        // States agree with differences.
        let [before, after] = [time - h, time + h].map(|time| motion.at(time));
        if time < h
            || time + h > motion.duration()
            || motion.curve().piece_at(motion.timing().at(time - h).s)
                != motion.curve().piece_at(motion.timing().at(time + h).s)
        {
            continue;
        }
        let scale = 1.0 + now.motion.velocity.norm() + now.motion.angular_velocity.norm();
        let velocity = (after.position - before.position) / (2.0 * h);
        assert!((velocity - now.motion.velocity).norm() < 1e-3 * scale, "{time}");
        let turned = (after.orientation * before.orientation.inverse()).scaled_axis() / (2.0 * h);
        assert!((turned - now.motion.angular_velocity).norm() < 1e-3 * scale, "{time}: {turned}");
        let lengths = [&before, &after].map(|m| cable_lengths(robot, &m.orientation, &m.position));
        for (cable, winding) in now.windings.iter().enumerate() {
            let speed = (lengths[1][cable] - lengths[0][cable]) / (2.0 * h);
            assert!((speed - winding.speed).abs() < 1e-3 * scale, "{time}: {speed} {}", winding.speed);
        }
    }
    worst
}

/// A random free path of poses about a place of a scene.
fn random_path(scene: &Scene, around: Point, rng: &mut ChaCha8Rng) -> Option<Vec<Pose>> {
    let engine = compiled(scene);
    let reach = rng.random_range(0.05..0.4);
    let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
    let count = 3;
    let mut poses = vec![Pose::new(around, *scene.orientation())];
    for _ in 0..40 {
        let last = poses[poses.len() - 1];
        let turn = Rotation::from_scaled_axis(any(0.5));
        let turn = if any(1.0).x > 0.0 { turn } else { Rotation::identity() };
        let place = around + any(reach) * f64::from(u8::from(any(1.0).x > -0.5));
        let next = Pose::new(place, turn * last.orientation);
        if engine.motion_valid(&last, &next) {
            poses.push(next);
        }
        if poses.len() > count {
            return Some(poses);
        }
    }
    None
}

#[test]
fn random_turning_motions_keep_all_limits() {
    let mut counted = [0; 2];
    for (name, place) in [("cogiro", [0.0, 0.0, 2.5]), ("ipanema2", [0.0, 0.0, 1.5]), ("turn", [0.6, 1.6, 1.2])] {
        let scene = built_scene(name);
        for seed in 0..10 {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            let Some(poses) = random_path(&scene, place.into(), &mut rng) else { continue };
            let mut maybe =
                |low: f64, high: f64| rng.random_bool(0.6).then(|| 10_f64.powf(rng.random_range(low..high)));
            let mut limits = MotionSpec {
                speed: maybe(-1.0, 1.0),
                turn_speed: maybe(-1.0, 1.0),
                turn_acceleration: Some(maybe(-1.0, 1.5).unwrap_or(3.0)),
                acceleration: Some(maybe(-1.0, 1.5).unwrap_or(3.0)),
                cable_speed: maybe(-1.0, 1.0),
                cable_acceleration: maybe(-1.0, 1.5),
                blend: Some(0.02),
                ..MotionSpec::default()
            };
            limits.jerk = (seed % 3 == 0).then_some(50.0);
            let found = match Trajectory::new(&compiled(&scene), &poses, &limits, &Watch::NONE) {
                Ok(found) => found,
                Err(error) if error.to_string().contains("no tensions within the limits") => continue,
                Err(error) => panic!("{name} {seed}: {error}"),
            };
            let excess = excess(&scene, &found, 3000);
            assert!(excess <= 1e-9, "{name} {seed} {limits:?}: {excess}");
            counted[usize::from(found.winches().tension_limits().is_some())] += 1;
            let file = file(&scene, &poses, &found, 200.0);
            cdpr_files::check_trajectory(&file).unwrap();
            let report = check(&scene, &Recorded::of(&file).unwrap(), &limits);
            assert!(report.valid && report.exact, "{name} {seed}: {:?}", report.faults);
            let sampled = Recorded { exact: None, ..Recorded::of(&file).unwrap() };
            let report = check(&scene, &sampled, &limits);
            assert!(report.valid, "{name} {seed}: {:?}", report.faults);
        }
    }
    assert!(counted[0] >= 5 && counted[1] >= 5, "{counted:?}");
}

#[test]
fn tensions_match_differences_of_momentum() {
    let mut spec = built_scene("cogiro").spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { panic!("the robot is part of the scene") };
    let mass = robot.mass.unwrap();
    robot.center_of_mass = Some([0.05, -0.03, 0.1]);
    let tensor = [[0.3, 0.02, 0.0], [0.02, 0.4, -0.03], [0.0, -0.03, 0.5]].map(|row| row.map(|x| x * mass));
    robot.inertia = Some(InertiaSpec::Tensor(tensor));
    let scene = Scene::new(spec).unwrap();
    let poses = [
        Pose::new(Point::new(-2.0, 0.0, 2.5), Rotation::identity()),
        Pose::new(Point::new(-1.4, 0.2, 2.7), Rotation::from_scaled_axis(Vector::new(0.1, -0.12, 0.2))),
    ];
    let found = motion(&scene, &poses, &MotionSpec { blend: Some(0.0), ..MotionSpec::default() });
    assert!(found.winches().tension_limits().is_some());
    let (robot, loads) = (scene.robot(), Loads::of(&scene));
    let inertia = robot.inertia().unwrap();
    let momentum = |time: f64| {
        let now = found.at(time);
        let center = now.orientation * robot.center_of_mass().coords;
        let axes = now.orientation.to_rotation_matrix();
        let linear = now.of_point(&center)[0] * mass;
        (linear, axes * inertia * axes.transpose() * now.angular_velocity)
    };
    let mut solver = TensionQp::default();
    for share in [0.1, 0.3, 0.45, 0.6, 0.9] {
        let time = share * found.duration();
        let h = 1e-7;
        let ((before, about_before), (after, about_after)) = (momentum(time - h), momentum(time + h));
        let sample = found.sample(&mut solver, time).unwrap();
        let now = sample.motion;
        let force = (after - before) / (2.0 * h);
        let center = now.orientation * robot.center_of_mass().coords;
        let moment = center.cross(&force) + (about_after - about_before) / (2.0 * h);
        let needed = Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        let matrix = wrench_matrix(robot, &now.orientation, &now.position).unwrap();
        let exerted = matrix * DVector::from_vec(sample.tensions.unwrap());
        let rest = loads.at(&now.orientation).balance(robot).unwrap();
        let missing = (exerted - rest - needed).norm();
        assert!(missing < 1e-3 * (1.0 + needed.norm() + rest.norm()), "{share}: {missing} {needed}");
    }
    let report = check(&scene, &Recorded::of(&file(&scene, &poses, &found, 100.0)).unwrap(), &MotionSpec::default());
    assert!(report.valid && report.notes.is_empty(), "{:?} {:?}", report.faults, report.notes);
}

/// The bar of `turn.toml` from the tray in which it lies to the other one.
pub fn planned_turn() -> (Scene, Vec<Pose>) {
    let scene = built_scene("turn");
    let planned = plan(Query::of(&scene), &PlanOptions::default(), &()).unwrap();
    let poses = planned.result.path;
    (scene, poses)
}

#[test]
fn a_timed_turning_path_passes_its_check() {
    let (scene, poses) = planned_turn();
    let limits = MotionSpec { blend: Some(0.01), cable_speed: Some(1.0), ..FREE };
    let found = motion(&scene, &poses, &limits);
    assert!(excess(&scene, &found, 4000) <= 1e-9);
    assert!(found.winches().note().unwrap().contains("mass"));
    let file = file(&scene, &poses, &found, 100.0);
    let read: TrajectoryFile = serde_json::from_str(&serde_json::to_string(&file).unwrap()).unwrap();
    assert_eq!(read, file);
    let (curve, timing) = read.exact().unwrap();
    assert_eq!((&curve, &timing), (found.curve(), found.timing()));
    let exact = Recorded::of(&file).unwrap();
    let report = check(&scene, &exact, &limits);
    assert!(report.valid && report.exact && report.nearest.is_some(), "{:?}", report.faults);
    assert!(report.largest.turn_speed.unwrap() <= 1.5 + 1e-9 && report.largest.turn_speed.unwrap() > 0.5);
    // As samples of any source, with fewer and fewer columns.
    let Recorded { times, positions, orientations, angular_velocities, velocities, .. } = exact.clone();
    let sampled = Recorded { exact: None, ..exact.clone() };
    let rates = Recorded { times, positions, orientations, velocities, angular_velocities, ..Recorded::default() };
    let bare = Recorded { velocities: None, angular_velocities: None, ..rates.clone() };
    for recorded in [sampled, rates, bare] {
        let report = check(&scene, &recorded, &limits);
        assert!(report.valid && !report.exact, "{:?}", report.faults);
    }
    let by_table = cdpr_files::loaded_if_trajectory(&table(&file)).unwrap().unwrap();
    let (turned, recorded, _) = cdpr_files::scene_of_loaded(&scene, &by_table, true).unwrap();
    // A table has no path.
    assert_eq!(recorded, Recorded { exact: None, path: None, ..exact });
    assert!(check(&turned, &recorded, &limits).valid);
}

/// The CSV of a motion.
fn table(file: &TrajectoryFile) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motion.csv");
    cdpr_files::save_trajectory(&path, file, cdpr_files::MessageFields::default()).unwrap();
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn wrong_columns_of_a_turn_are_found() {
    let (scene, poses) = planned_turn();
    let limits = MotionSpec { blend: Some(0.01), ..FREE };
    let found = motion(&scene, &poses, &limits);
    let good = Recorded { exact: None, ..Recorded::of(&file(&scene, &poses, &found, 100.0)).unwrap() };
    let kinds = |motion: &Recorded, limits: &MotionSpec| -> Vec<FaultKind> {
        check(&scene, motion, limits).faults.iter().map(|fault| fault.kind).collect()
    };
    assert_eq!(kinds(&good, &limits), []);
    let slow = MotionSpec { turn_speed: Some(0.4), turn_acceleration: Some(0.5), ..limits };
    let told = kinds(&good, &slow);
    assert!(
        told.contains(&FaultKind::Limit(Limit::TurnSpeed)) && told.contains(&FaultKind::Limit(Limit::TurnAcceleration)),
        "{told:?}"
    );
    let mut fast = good.clone();
    fast.angular_velocities.iter_mut().flatten().for_each(|w| *w *= 1.2);
    let told = kinds(&fast, &MotionSpec { turn_speed: None, ..limits });
    assert!(told.contains(&FaultKind::AngularVelocity) && told.contains(&FaultKind::CableRate), "{told:?}");
    let mut other = good.clone();
    other.angular_accelerations.iter_mut().flatten().for_each(|a| *a /= 57.3);
    assert!(kinds(&other, &limits).contains(&FaultKind::Inconsistent));
    let mut jump = good.clone();
    let (times, orientations) = (good.times.len(), jump.orientations.as_mut().unwrap());
    orientations[times / 2] = yaw(0.05) * orientations[times / 2];
    let told = kinds(&jump, &limits);
    assert!(told.contains(&FaultKind::CableLength) && told.contains(&FaultKind::Limit(Limit::TurnSpeed)), "{told:?}");
    // Turned at once in the narrow tray.
    let mut caught = Recorded { cable_lengths: None, ..good };
    let orientations = caught.orientations.as_mut().unwrap();
    orientations[1] = yaw(0.7) * orientations[1];
    let report = check(&scene, &caught, &limits);
    assert!(report.faults.iter().any(|f| f.kind == FaultKind::Condition && f.culprits[0] == "platform"), "{report:?}");
}

#[test]
fn hostile_paths_and_limits_are_timed_or_refused_with_a_reason() {
    let scene = empty();
    let middle = [1.0, 1.0, 1.0];
    let mut timed = 0;
    // Half a turn, either way; a turn too small to see; a tiny move with a large turn; a turn that is none.
    for (from, to) in [
        (at(middle, 0.0), at(middle, PI)),
        (at(middle, 0.3), at([1.1, 1.0, 1.0], 0.3 - PI)),
        (at(middle, 0.0), at(middle, 1e-8)),
        (at(middle, 0.0), at([1.0 + 1e-12, 1.0, 1.0], 0.8)),
        (at(middle, 0.0), at([1.0 + 1e-7, 1.0, 1.0], -0.8)),
        (at(middle, 0.0), at([1.2, 1.0, 1.0], 2e-9)),
    ] {
        let turned = Rotation::new_unchecked(-to.orientation.into_inner());
        for to in [to, Pose::new(to.position, turned)] {
            let engine = compiled(&scene);
            if !engine.motion_valid(&from, &to) {
                assert!(refusal(&scene, &[from, to], &FREE).contains("not free"));
                continue;
            }
            let found = match Trajectory::new(&compiled(&scene), &[from, to], &FREE, &Watch::NONE) {
                Ok(found) => found,
                // Turned by more than a little, the cables of this robot cannot hold the platform.
                Err(error) if error.to_string().contains("that hold the platform") => continue,
                Err(error) => panic!("{error}"),
            };
            timed += 1;
            assert!(found.duration() > 0.0 && found.duration() < 10.0, "{from:?} {to:?}");
            assert!(excess(&scene, &found, 500) <= 1e-9, "{from:?} {to:?}");
            let rows = file(&scene, &[from, to], &found, 100.0).orientations.unwrap_or_default();
            let product = |pair: &[[f64; 4]]| (0..4).map(|k| pair[0][k] * pair[1][k]).sum::<f64>();
            assert!(rows.windows(2).all(|pair| product(pair) > 0.0), "{from:?} {to:?}");
            let end = found.at(found.duration());
            assert!(end.orientation.angle_to(&to.orientation) < 1e-8 && (end.position - to.position).norm() < 1e-9);
        }
    }
    assert!(timed >= 8, "{timed}");
    let turn = [at(middle, 0.0), at(middle, 0.2)];
    assert!(refusal(&scene, &[turn[0], turn[0]], &FREE).contains("only one position"));
    let still = [at(middle, 0.2), at(middle, 0.2)];
    assert!(refusal(&scene, &still, &FREE).contains("only one pose"));
    assert!(refusal(&scene, &[], &FREE).contains("found none"));
    let with = |change: fn(&mut MotionSpec)| {
        let mut limits = FREE;
        change(&mut limits);
        refusal(&scene, &turn, &limits)
    };
    assert!(with(|l| l.turn_speed = Some(0.0)).contains("turn_speed: found 0"));
    assert!(with(|l| l.turn_acceleration = Some(f64::NAN)).contains("turn_acceleration"));
    assert!(with(|l| l.turn_acceleration = None).contains("expected a turn_acceleration"));
    assert!(with(|l| l.wrench_margin = Some(1.0)).contains("tensions are not limited"));
    // Limits of a turn have no effect on a motion without one.
    let line = [at(middle, 0.0), at([1.4, 1.0, 1.0], 0.0)];
    let none = MotionSpec { turn_speed: None, turn_acceleration: None, ..FREE };
    assert_eq!(motion(&scene, &line, &FREE).timing(), motion(&scene, &line, &none).timing());
}

/// The paper's robot with these attachments.
fn attached(attachment: fn([f64; 3]) -> [f64; 3], mass: Option<f64>) -> Scene {
    let mut robot = paper_robot();
    robot.mass = mass;
    robot.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
    robot.cables.iter_mut().for_each(|cable| cable.attachment = attachment(cable.attachment));
    let mut spec = paper_scene("attached", Vec::new());
    spec.robot = RobotSource::Inline(robot);
    Scene::new(spec).unwrap()
}

#[test]
fn a_turn_that_no_cable_feels_needs_a_limit_of_its_own() {
    let turn = [at([1.0, 1.0, 1.0], 0.0), at([1.0, 1.0, 1.0], 0.5)];
    let cables = MotionSpec { cable_speed: Some(1.0), cable_acceleration: Some(1.0), ..MotionSpec::default() };
    // With all attachments at the origin, or on the axis, lengths do not change.
    for scene in [attached(|_| [0.0; 3], None), attached(|[_, _, z]| [0.0, 0.0, z], Some(10.0))] {
        assert!(refusal(&scene, &turn, &cables).contains("no cable changes its length"));
        let found = motion(&scene, &turn, &MotionSpec { turn_acceleration: Some(2.0), ..cables });
        assert!((found.duration() - 2.0 * (0.25_f64).sqrt()).abs() < 1e-4, "{}", found.duration());
    }
    let point = attached(|_| [0.0; 3], Some(10.0));
    let found = motion(&point, &turn, &FREE);
    assert!(found.winches().note().unwrap().contains("meet in one point"), "{:?}", found.winches().note());
}

/// CoGiRo with a centre of mass beside its origin and an inertia of its own.
pub fn lopsided() -> Scene {
    let mut spec = built_scene("cogiro").spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { panic!("the robot is part of the scene") };
    let mass = robot.mass.unwrap();
    robot.center_of_mass = Some([0.1, -0.05, 0.15]);
    robot.inertia = Some(InertiaSpec::Diagonal([0.2 * mass, 0.3 * mass, 0.45 * mass]));
    Scene::new(spec).unwrap()
}

/// Compares bounds between two instants of a motion of the [`lopsided`] robot with the motion between them.
pub struct TensionsBetween {
    winches: Winches,
    solver: TensionQp,
    /// Number of finite bounds.
    pub bounded: usize,
    /// Number of motions that were proved to be held.
    pub held: usize,
}

impl TensionsBetween {
    pub fn new() -> Self {
        let start = Pose::new(Point::new(-2.0, 0.0, 2.5), Rotation::identity());
        let end = Pose::new(start.position, yaw(0.1));
        let winches = Winches::of(&lopsided(), &MotionSpec::default(), &[start, end]).unwrap();
        Self { winches, solver: TensionQp::default(), bounded: 0, held: 0 }
    }

    /// Checks case `k`: `time` seconds from `phase` on, if the curve is long enough and the motion never stands.
    pub fn at(&mut self, k: usize, curve: &Curve, phase: &Phase, time: f64) {
        let state = |share: f64| phase.after(share * time);
        if !(state(1.0).s < curve.length() && (0..=8).all(|n| state(f64::from(n) / 8.0).speed > 0.0)) {
            return;
        }
        let winches = &self.winches;
        let motion_at = |share: f64| Motion::on(curve, 0, &state(share));
        let ends = [motion_at(0.0), motion_at(1.0)];
        let rates = Rates::new(&curve.pieces()[0], phase, &state(1.0), time);
        let span = Span { ends: &ends, rates: &rates, time };
        let slack = |motion: Motion| winches.tension_shares(&[motion]).ok().map(|shares| shares[0].slack);
        let inner = || (1..12).map(|n| motion_at(f64::from(n) / 12.0));
        if let [Some(a), Some(b)] = ends.map(slack) {
            let sag = winches.sag(&span);
            self.bounded += usize::from(sag < 100.0);
            for motion in inner() {
                assert!(slack(motion).is_none_or(|slack| slack >= a.min(b) - sag - 1e-6), "{k}: {a} {b} {sag}");
            }
        }
        if winches.hold_between(&mut RecentTensions::default(), &span).unwrap() <= 1.0 {
            self.held += 1;
            inner().for_each(|motion| assert!(winches.tensions(&mut self.solver, &motion).unwrap().is_some(), "{k}"));
        }
    }
}

#[test]
fn slack_and_tensions_between_two_instants_are_as_bounded() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut check = TensionsBetween::new();
    for k in 0..600 {
        let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
        let from = Pose::new(Point::new(-2.0, 0.0, 2.0) + any(0.8), Rotation::from_scaled_axis(any(0.3)));
        let to = Pose::new(from.position + any(0.5), Rotation::from_scaled_axis(any(0.5)) * from.orientation);
        let length = (to.position - from.position).norm() + 0.5 * from.angle_to(&to);
        let turn = Attitude::between(from.orientation, to.orientation);
        let curve = Curve::new(vec![Piece::turning_line([from.position, to.position], turn, length)]);
        let phase = Phase {
            time: 0.0,
            s: rng.random_range(0.0..0.5) * length,
            speed: rng.random_range(0.0..2.0),
            acceleration: rng.random_range(-3.0..3.0),
            jerk: [0.0, rng.random_range(-20.0..20.0)][k % 2],
        };
        let time = 10_f64.powf(rng.random_range(-3.5..-0.7));
        check.at(k, &curve, &phase, time);
    }
    assert!(check.bounded > 100 && check.held > 20, "{} {}", check.bounded, check.held);
}
