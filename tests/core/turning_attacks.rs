//! Timed motions of a platform that turns: instants beside stops, tiny turns, few samples, and files that are wrong in between.

use std::f64::consts::PI;

use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::model::Scene;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::testing::empty;
use cdpr_core::trajectory_check::{FaultKind, Recorded};
use cdpr_core::wrench::TensionQp;
use cdpr_tests::built_scene;

use super::turning_motions::{FREE, at, check, file, motion, planned_turn};

#[test]
fn beside_a_stop_the_rates_are_those_of_its_own_side() {
    // The second turn is twenty times faster per length than the first one.
    let poses = [at([0.7, 1.0, 1.0], 0.0), at([1.2, 1.0, 1.0], 0.02), at([1.2, 1.01, 1.0], 0.22)];
    let found = motion(&empty(), &poses, &FREE);
    let limits = *found.limits();
    for phase in found.timing().phases() {
        for shift in [-1e-7, -1e-8, -3e-9, -1e-9, -1e-10, 0.0, 1e-10, 1e-9, 1e-8] {
            let now = found.at(phase.time + shift);
            assert!(now.angular_acceleration.norm() <= limits.turn_acceleration.unwrap() * (1.0 + 1e-9), "{phase:?}");
            assert!(now.acceleration.norm() <= limits.acceleration.unwrap() * (1.0 + 1e-9), "{phase:?}");
        }
    }
}

#[test]
fn tiny_turns_and_weights_survive_on_long_paths() {
    for weight in [1e-300, 1e-12, 1e-3, 1e6, 1e300] {
        let mut spec = built_scene("turn").spec().clone();
        spec.turning.as_mut().unwrap().weight = Some(weight);
        let scene = Scene::new(spec).unwrap();
        let places = [([0.6, 1.6, 1.2], 0.0), ([0.7, 1.6, 1.2], 0.0), ([0.7, 1.6, 1.2], 0.4)];
        let more = [([0.7, 1.5, 1.3], 0.8), ([0.7, 1.5, 1.3], 0.8 + 1e-8), ([0.8, 1.5, 1.3], 0.8 + 1e-8)];
        let poses: Vec<Pose> = places.into_iter().chain(more).map(|(place, angle)| at(place, angle)).collect();
        let found = motion(&scene, &poses, &FREE);
        assert!(found.duration() > 1.0 && found.duration() < 4.0, "{weight}: {}", found.duration());
        let report = check(&scene, &Recorded::of(&file(&scene, &poses, &found, 100.0)).unwrap(), &FREE);
        assert!(report.valid, "{weight}: {:?}", report.faults);
    }
}

#[test]
fn few_samples_of_an_exact_motion_are_no_fault() {
    let (scene, poses) = planned_turn();
    let found = motion(&scene, &poses, &FREE);
    for rate in [0.1, 1.0, 10.0] {
        let report = check(&scene, &Recorded::of(&file(&scene, &poses, &found, rate)).unwrap(), &FREE);
        assert!(report.valid && report.exact, "{rate}: {:?}", report.faults);
        let nearest = report.nearest.unwrap();
        assert!(nearest.value > -1e-4, "{rate}: {nearest:?}");
    }
}

#[test]
fn tensions_exist_beside_a_stop_between_two_ways() {
    // There and back, and a turn at another rate: at the middle stop rounding must not mix the two.
    let scene = built_scene("cogiro");
    let pose = |x: f64, yaw: f64| Pose::new(Point::new(x, 0.0, 2.5), Rotation::from_scaled_axis(Vector::z() * yaw));
    let ways = [
        vec![pose(-2.0, 0.0), pose(-1.6, 0.01), pose(-1.59, 0.2)],
        vec![pose(-2.0, 0.0), pose(-1.6, 0.2), pose(-2.0, 0.0)],
    ];
    let mut solver = TensionQp::default();
    for poses in ways {
        let found = motion(&scene, &poses, &MotionSpec { blend: Some(0.0), ..MotionSpec::default() });
        assert!(found.winches().tension_limits().is_some());
        let stop = found.timing().when(found.corners()[0].at);
        for time in [stop, 0.5 * found.duration()] {
            for shift in [-1e-7, -1e-8, -3e-9, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-8] {
                assert!(found.sample(&mut solver, time + shift).unwrap().tensions.is_some());
            }
        }
    }
}

#[test]
fn an_overlap_after_a_contact_is_found() {
    // The bar touches a face of the pillar, then moves away and sweeps an end through it.
    let poses = [at([1.0, 1.09, 0.45], 0.0), at([1.0, 1.4, 0.45], 3.0)];
    let orientations = Some(poses.iter().map(|pose| pose.orientation).collect());
    let positions = poses.iter().map(|pose| pose.position).collect();
    let recorded = Recorded { times: vec![0.0, 1.0], positions, orientations, ..Recorded::default() };
    let report = check(&built_scene("turn"), &recorded, &MotionSpec::default());
    let found = report.faults.iter().find(|f| f.kind == FaultKind::Condition && f.culprits == ["platform", "pillar"]);
    assert!(found.is_some_and(|fault| fault.time > 0.3 && fault.time < 0.7), "{:?}", report.faults);
}

#[test]
fn a_half_turn_between_two_samples_gives_a_note() {
    let place = Point::new(0.6, 1.6, 1.2);
    let half = [0.0, PI].map(|angle| Pose::new(place, Rotation::from_scaled_axis(Vector::z() * angle)));
    let orientations = Some(half.iter().map(|pose| pose.orientation).collect());
    let recorded = Recorded { times: vec![0.0, 1.0], positions: vec![place; 2], orientations, ..Recorded::default() };
    let report = check(&built_scene("turn"), &recorded, &MotionSpec::default());
    assert!(report.notes.iter().any(|note| note.contains("only one of the two ways")), "{:?}", report.notes);
}
