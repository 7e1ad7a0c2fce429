//! Bends on which a turn begins, ends or changes: free where they are accepted, and faster than stops.

use std::sync::atomic::{AtomicUsize, Ordering};

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::conditions::Kind;
use cdpr_core::geometry::{Placed, Point, Pose, Rotation, Vector};
use cdpr_core::model::spec::{ClearancesSpec, MotionSpec, RobotSource};
use cdpr_core::model::{BodySpec, Scene, SceneSpec};
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::testing::{block, empty};
use cdpr_core::trajectory::rows::Rows;
use cdpr_core::trajectory::timing::Phase;
use cdpr_core::trajectory::turning_bend::TurningBend;
use cdpr_core::trajectory::turning_corners::TurningSpace;
use cdpr_core::trajectory::{Curve, Motion, Passing, Trajectory, Winches, curve::Piece};
use cdpr_core::trajectory_check::Recorded;
use cdpr_core::watch::Watch;
use cdpr_tests::built_scene;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use super::turning_motions::{FREE, TensionsBetween, at, check, excess, file, motion, planned_turn};

/// A bend about a place, with turns of these sizes, rad/m: it begins, ends or changes a turn.
pub fn random_bend(rng: &mut ChaCha8Rng, place: Point, [tilt, spin]: [f64; 2]) -> TurningBend {
    let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..=most));
    let corner = Pose::new(place + any(0.2), Rotation::from_scaled_axis(any(tilt)));
    let (mut velocities, mut spins) = ([any(0.6), any(0.6)], [any(spin), any(spin)]);
    match (any(1.0).x * 3.0).floor() as i32 {
        -3 => spins[0] = Vector::zeros(),
        -2 => spins[1] = Vector::zeros(),
        -1 => velocities[0] = Vector::zeros(),
        0 => spins[1] = spins[0] * 0.3,
        _ => {}
    }
    TurningBend::new(corner, velocities, spins, 0.02 + 0.3 * any(1.0).x.abs())
}

/// Where a small block meets a point of the platform or of a cable somewhere on a bend, its sides, and a way out.
fn block_at(scene: &Scene, bend: &TurningBend, rng: &mut ChaCha8Rng) -> (Point, [f64; 3], Vector) {
    let pose = bend.pose(rng.random_range(0.0..1.0) * bend.length());
    let robot = scene.robot();
    let vertices: Vec<Vector> = robot.parts().iter().flat_map(|part| part.vertices()).map(|v| v.coords).collect();
    let corner = vertices[rng.random_range(0..vertices.len())];
    let cable = &robot.cables()[rng.random_range(0..robot.cables().len())];
    let at = |v: &Vector| pose.position + pose.orientation * v;
    let end = at(&cable.attachment.coords);
    let near = match rng.random_bool(0.5) {
        true => at(&(corner * rng.random_range(0.2..1.0))),
        false => end + (cable.outlet - end) * rng.random_range(0.05..0.7),
    };
    let way = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0));
    (near, std::array::from_fn(|_| rng.random_range(0.01..0.15)), way.normalize())
}

fn with_block(scene: &Scene, (near, sides, way): &(Point, [f64; 3], Vector), away: f64) -> Option<Scene> {
    let mut spec = scene.spec().clone();
    spec.obstacles.push(block("near", *sides, (near + way * away).into()));
    Scene::new(spec).ok()
}

/// The least slack of the conditions along a fine walk, m, and of which kind it is. Two cables that cross are at a distance again
/// at the next pose, so the least distance of each pair is searched between poses.
fn least_slack(scene: &Scene, bend: &TurningBend) -> (f64, Kind) {
    let engine = engine_for(scene, Engine::Gjk, Interference::Exact).unwrap();
    let (conditions, step) = (engine.conditions(), bend.length() / 400.0);
    let placed = |s: f64| Placed::new(&bend.pose(s.clamp(0.0, bend.length())), scene.orientation());
    let poses: Vec<Placed> = (0..=400).map(|k| placed(step * f64::from(k))).collect();
    let least = conditions.list.iter().map(|condition| {
        let details = condition.details();
        let slacks = poses.iter().map(|pose| details.slack_at(&conditions.bodies, pose)).enumerate();
        let (k, slack) = slacks.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        if details.kind() != Kind::CableCable || slack > 2e-3 {
            return (slack, details.kind());
        }
        let [mut low, mut high] = [-1.0, 1.0].map(|way| step * (k as f64 + way));
        let at = |s: f64| details.slack_at(&conditions.bodies, &placed(s));
        for _ in 0..60 {
            let third = (high - low) / 3.0;
            if at(low + third) < at(high - third) { high -= third } else { low += third }
        }
        (slack.min(at(low)), details.kind())
    });
    least.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

/// Numbers of decisions about random bends.
#[derive(Debug, Default)]
struct Tally {
    accepted: AtomicUsize,
    refused: AtomicUsize,
    /// Accepted with less than a millimetre of slack.
    close: AtomicUsize,
    /// Refused with more than 0.1 mm of slack everywhere.
    wrongly: AtomicUsize,
    /// Bends within 5 mm of the deciding pair, by kind: cable and obstacle, platform and obstacle, two cables, cable
    /// and platform.
    kinds: [AtomicUsize; 4],
}

impl Tally {
    /// Decides about a bend and walks along it.
    fn judge(&self, scene: &Scene, bend: &TurningBend, name: &str) -> bool {
        let add = |counter: &AtomicUsize, counts: bool| counter.fetch_add(usize::from(counts), Ordering::Relaxed);
        let allowed = TurningSpace::of(scene, &Watch::NONE).unwrap().unwrap().allows(bend);
        let (slack, kind) = least_slack(scene, bend);
        let least = if kind == Kind::CableCable { 1e-7 } else { -1e-6 };
        assert!(!allowed || slack >= least, "{name}: {slack} {kind:?} {bend:?}");
        add(&self.accepted, allowed);
        add(&self.refused, !allowed);
        add(&self.close, allowed && slack < 1e-3);
        add(&self.wrongly, !allowed && slack > 1e-4);
        let kinds = [Kind::CableObstacle, Kind::PlatformObstacle, Kind::CableCable, Kind::CablePlatform];
        if let Some(k) = kinds.iter().position(|other| *other == kind).filter(|_| slack.abs() < 5e-3) {
            add(&self.kinds[k], true);
        }
        allowed
    }
}

/// The bar of `turn.toml` with a mast, beside which two of its cables pass.
fn bar_with_a_mast() -> Scene {
    let mut spec = SceneSpec { turning: None, ..built_scene("turn").spec().clone() };
    let RobotSource::Inline(robot) = &mut spec.robot else { panic!("the robot is part of the scene") };
    robot.platform.push(BodySpec { name: None, ..block("mast", [0.06, 0.02, 0.3], [0.0, 0.0, 0.19]) });
    robot.cables.iter_mut().take(2).for_each(|cable| cable.attachment[0] *= -1.0);
    Scene::new(spec).unwrap()
}

#[test]
fn accepted_bends_are_free_at_every_pose_of_a_fine_walk() {
    let count = std::env::var("RANDOM_BENDS").map_or(160, |count| count.parse().unwrap());
    let free = |scene: Scene| Scene::new(SceneSpec { turning: None, wrench: None, ..scene.spec().clone() }).unwrap();
    let cases = [
        ("bar", free(built_scene("turn")), [0.6, 1.4, 1.2], [0.6, 2.5]),
        ("cogiro", free(built_scene("cogiro")), [0.0, 0.0, 2.5], [0.4, 2.0]),
        ("paper", free(empty()), [1.0; 3], [0.7, 4.0]),
        ("mast", bar_with_a_mast(), [1.0, 0.25, 1.1], [0.3, 2.5]),
    ];
    let tally = Tally::default();
    (0..count).into_par_iter().for_each(|seed| {
        let (name, scene, place, sizes) = &cases[seed as usize % cases.len()];
        let scene = scene.with_most_clearance(0.0).unwrap();
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let bend = random_bend(&mut rng, (*place).into(), *sizes);
        let named = format!("{name} {seed}");
        if rng.random_bool(0.5) {
            // Larger and smaller bends, among cables and platform only.
            let ([v, w], length) = ([bend.velocities(), bend.spins()], bend.length());
            for k in 0..10 {
                let bend = TurningBend::new(*bend.corner(), *v, *w, 2.0 * length * 0.7_f64.powi(k));
                tally.judge(&scene, &bend, &named);
            }
            return;
        }
        // A block as near as the proof allows.
        let block = block_at(&scene, &bend, &mut rng);
        let [mut near, mut far] = [0.0, 0.3];
        for _ in 0..9 {
            let away = 0.5 * (near + far);
            let Some(scene) = with_block(&scene, &block, away) else { return };
            if tally.judge(&scene, &bend, &named) { far = away } else { near = away }
        }
    });
    println!("{tally:?}");
    let Tally { accepted, refused, close, wrongly, kinds } = tally;
    let [accepted, refused, close, wrongly] = [accepted, refused, close, wrongly].map(AtomicUsize::into_inner);
    assert!(accepted > 100 && refused > 100 && close > 30 && wrongly < refused / 20);
    assert!(kinds.into_iter().all(|kind| kind.into_inner() > 3));
}

#[test]
fn turns_that_a_scene_does_not_allow_are_refused() {
    let scene = built_scene("turn"); // about the vertical only
    let space = TurningSpace::of(&scene, &Watch::NONE).unwrap().unwrap();
    let corner = at([0.6, 1.6, 1.2], 0.3);
    let bend = |axis: Vector| TurningBend::new(corner, [Vector::x(), Vector::y() * 0.5], [Vector::zeros(), axis], 0.1);
    assert!(space.allows(&bend(Vector::z() * 2.0)));
    assert!(!space.allows(&bend(Vector::z() * 2.0 + Vector::x() * 0.01)));
}

#[test]
fn rows_limit_the_angular_acceleration_of_a_bend() {
    let limits = MotionSpec { turn_acceleration: Some(3.0), acceleration: Some(2.0), ..MotionSpec::default() };
    let winches = Winches::of(&empty(), &limits, &[at([1.0; 3], 0.0), at([1.0; 3], 0.1)]).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut kept = [0; 2];
    for _ in 0..2000 {
        let bend = random_bend(&mut rng, [1.0; 3].into(), [0.3, 3.0]);
        let curve = Curve::new(vec![Piece::turning_bend(bend)]);
        let s = rng.random_range(0.0..1.0) * bend.length();
        let speed: f64 = rng.random_range(0.0..1.5);
        let phase = Phase { time: 0.0, s, speed, acceleration: rng.random_range(-3.0..3.0), jerk: 0.0 };
        let rows = Rows::along(&[curve.at(s)], &MotionSpec { acceleration: None, ..limits }, &winches);
        let Ok(rows) = rows else { continue };
        let turn = rows[0].turn.unwrap();
        let by_row = (turn.first * phase.acceleration + turn.second * (speed * speed)).norm() <= turn.radius;
        let now = Motion::on(&curve, 0, &phase);
        if (now.angular_acceleration.norm() - 3.0).abs() > 1e-9 {
            assert_eq!(by_row, now.angular_acceleration.norm() <= 3.0);
            kept[usize::from(by_row)] += 1;
        }
    }
    assert!(kept[0] > 100 && kept[1] > 100, "{kept:?}");
}

#[test]
fn tensions_between_two_instants_on_a_bend_are_as_bounded() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut check = TensionsBetween::new();
    for k in 0..600 {
        let bend = random_bend(&mut rng, Point::new(-2.0, 0.0, 2.0), [0.2, 1.0]);
        let curve = Curve::new(vec![Piece::turning_bend(bend)]);
        let mut any = |most: f64| rng.random_range(-most..most);
        let (s, speed) = ((0.25 + any(0.2)) * bend.length(), 1.0 + any(0.9));
        let phase = Phase { time: 0.0, s, speed, acceleration: any(3.0), jerk: [0.0, any(20.0)][k % 2] };
        let time = 10_f64.powf(-2.2 + any(1.3));
        check.at(k, &curve, &phase, time);
    }
    assert!(check.bounded > 50 && check.held > 20, "{} {}", check.bounded, check.held);
}

pub fn stops(motion: &Trajectory) -> usize {
    motion.corners().iter().filter(|corner| corner.passing == Passing::Stop).count()
}

#[test]
fn the_bar_passes_the_ends_of_its_turns_and_is_faster() {
    for clearance in [0.0, 0.005, 0.02] {
        // Cables keep less: at the start, they cannot keep more from the bar.
        let clearances = ClearancesSpec { platform_obstacle: Some(clearance), ..ClearancesSpec::default() };
        let spec = built_scene("turn").spec().clone();
        let scene =
            Scene::new(SceneSpec { clearance: Some(clearance.min(0.005)), clearances: Some(clearances), ..spec });
        let scene = scene.unwrap();
        let planned = plan(Query::of(&scene), &PlanOptions::default(), &()).unwrap();
        let poses = planned.result.path;
        let stopping = motion(&scene, &poses, &MotionSpec { blend: Some(0.0), ..FREE });
        println!("clearance {clearance}: {} stops, {} s", stops(&stopping), stopping.duration());
        for blend in [0.005, 0.02, 0.03] {
            let found = motion(&scene, &poses, &MotionSpec { blend: Some(blend), ..FREE });
            println!("  blend {blend}: {} stops, {} s", stops(&found), found.duration());
            assert!(excess(&scene, &found, 10_000) <= 1e-9);
            // The path has no more than three corners, so there is little to gain.
            assert!(2 * stops(&found) < stops(&stopping) && found.duration() < 0.93 * stopping.duration());
            assert!(found.corners().iter().all(|corner| corner.deviation <= blend * (1.0 + 1e-9)));
        }
    }
}

#[test]
fn motions_with_bends_pass_their_check() {
    let (scene, poses) = planned_turn();
    for more in [
        FREE,
        MotionSpec { cable_speed: Some(0.8), cable_acceleration: Some(2.5), ..FREE },
        MotionSpec { jerk: Some(30.0), ..FREE },
    ] {
        let limits = MotionSpec { blend: Some(0.03), ..more };
        let found = motion(&scene, &poses, &limits);
        assert!(found.corners().iter().any(|corner| corner.turn && corner.passing == Passing::Rounded));
        assert!(excess(&scene, &found, 10_000) <= 1e-9);
        let file = file(&scene, &poses, &found, 100.0);
        let text = serde_json::to_string(&file).unwrap();
        let read: cdpr_core::trajectory_file::TrajectoryFile = serde_json::from_str(&text).unwrap();
        let (curve, timing) = read.exact().unwrap();
        assert_eq!((&curve, &timing), (found.curve(), found.timing()));
        let exact = Recorded::of(&read).unwrap();
        let report = check(&scene, &exact, &limits);
        assert!(report.valid && report.exact, "{:?}", report.faults);
        let sampled = check(&scene, &Recorded { exact: None, ..exact }, &limits);
        assert!(sampled.valid && !sampled.exact, "{:?}", sampled.faults);
    }
}

#[test]
fn a_way_back_and_a_path_without_blend_stop() {
    let back = [at([0.8, 1.0, 1.0], 0.0), at([1.2, 1.0, 1.0], 0.2), at([0.8, 1.0, 1.0], 0.0)];
    let found = motion(&empty(), &back, &MotionSpec { blend: Some(0.05), ..FREE });
    assert_eq!(stops(&found), 1);
    let on = [back[0], back[1], at([1.2, 1.3, 1.0], 0.2)];
    assert_eq!(
        [0.0, 0.05].map(|blend| stops(&motion(&empty(), &on, &MotionSpec { blend: Some(blend), ..FREE }))),
        [1, 0]
    );
}
