//! Proved workspaces during turns: a volume worked by hand, agreement with the checks of positions and motions, and what is refused.

use cdpr_core::batch::BatchOptions;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::model::spec::{PulleySpec, RuleSpec, WrenchSpec};
use cdpr_core::model::{OrientationSource, RobotSource, Scene};
use cdpr_core::testing;
use cdpr_core::workspace::{ValidAt, Workspace, WorkspaceOptions, orientations_for, workspace};
use cdpr_core::{Pose, Validity};
use cdpr_tests::{built_scene, effort};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::workspace::{assert_volume, compiled, estimated, in_boxes, point_scene, proved_at, scene};

/// A square of 1 m in a room of 2 m needs 1 m across at 0° and 90°, but √2 m on the way.
#[test]
fn a_square_that_turns_needs_its_diagonal() {
    let mut spec = point_scene([2.0; 3], &[[1.0, 1.0, 3.0]], Vec::new());
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.platform[0].vertices = Some(vec![[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [0.5, 0.5, 0.0], [-0.5, 0.5, 0.0]]);
    let first = scene(spec);
    let ends = [first.clone(), first.turned([0.5_f64.sqrt(), 0.0, 0.0, 0.5_f64.sqrt()].into()).unwrap()];
    assert_volume(&proved_at(&ends, ValidAt::Every, 0.1), 2.0, 0.02);
    // The orientations that are judged are 10° apart: nearest to 45°, two at 40° and 50°.
    let judged = 2.0_f64.sqrt() * 5.0_f64.to_radians().cos();
    let found = proved_at(&ends, ValidAt::Turns, 0.02);
    assert!((found.total - 2.0 * (2.0 - judged).powi(2)).abs() < 1e-9, "{}", found.total);
    assert_volume(&found, 2.0 * (2.0 - 2.0_f64.sqrt()).powi(2), 0.15);
    assert_eq!((found.valid_at, found.more_orientations.len()), (Some(ValidAt::Turns), 9));
    // There and back is no farther.
    let there_and_back = [&ends[0], &ends[1], &ends[0]].map(Scene::clone);
    assert_eq!(proved_at(&there_and_back, ValidAt::Turns, 0.1).volume, proved_at(&ends, ValidAt::Turns, 0.1).volume);
}

/// What is said of turns, as the check of positions sees it at many orientations on the way, and the check of motions.
fn assert_turns_agree(name: &str, ends: &[Scene; 2], found: &Workspace, tries: u64) {
    let turn = |at: &Point| Pose::new(*at, *ends[0].orientation()).toward(&Pose::new(*at, *ends[1].orientation()));
    let on_the_way = |k: usize| {
        let [x, y, z, w] = turn(&Point::origin()).at(k as f64 / 30.0).orientation.coords.into();
        compiled(&ends[0].turned([w, x, y, z].into()).unwrap())
    };
    let on_the_way: Vec<CompiledScene> = (0..=30).map(on_the_way).collect();
    let valid = |position: &Point| on_the_way.iter().all(|at| at.level().state_valid(position));
    let judged: Vec<CompiledScene> = orientations_for(ends, ValidAt::Turns).unwrap().iter().map(compiled).collect();
    judged[0].ready_for(&[turn(&Point::origin()).to]).unwrap();
    let moves = |position: &Point| judged[0].motion_valid(&turn(position).from, &turn(position).to);
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    for (k, position) in in_boxes(&found.boxes, 1, tries, &mut rng) {
        assert!(valid(&position) && moves(&position), "{position} in box {k} of {name}");
    }
    for (k, position) in in_boxes(&found.boxes, -1, tries, &mut rng) {
        let at = found.causes[found.boxes.cause[k] as usize].at.unwrap();
        assert!(!judged[at].level().state_valid(&position) && !moves(&position), "{position} in box {k} of {name}");
    }
    let [most, error] = estimated(found, &valid, tries, &mut rng);
    assert!(found.volume.min - error <= most, "{name}: {:?}, {most}", found.volume);
    let [least, error] = estimated(found, &moves, tries, &mut rng);
    assert!(least <= found.volume.max + error, "{name}: {:?}, {least}", found.volume);
}

/// The paper's scene with a clearance, where some cables sag and some run over pulleys; outlets are not known exactly.
fn with_real_cables(clearance: f64) -> Scene {
    let mut spec = testing::hard1().spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    for (k, cable) in robot.cables.iter_mut().enumerate() {
        (cable.diameter, cable.outlet_error) = (Some(0.004), Some(0.002));
        match k % 4 {
            0 => (cable.linear_density, cable.sag_tension) = (Some(0.05), Some(20.0)),
            1 => cable.pulley = Some(PulleySpec { radius: 0.01, axis: [0.0, 0.0, cable.outlet[2] - 1.0] }),
            _ => {}
        }
    }
    scene(spec).with_clearance(clearance).unwrap()
}

#[test]
fn boxes_during_turns_agree_with_the_check_of_positions_and_motions() {
    let about = |axis: Vector, degrees: f64| {
        let turn = cdpr_core::Rotation::from_scaled_axis(axis.normalize() * degrees.to_radians());
        OrientationSource::Quaternion([turn.w, turn.i, turn.j, turn.k])
    };
    let turned = |scene: &Scene, axis: Vector, degrees: f64| scene.turned(about(axis, degrees)).unwrap();
    let cases: Vec<(&str, Scene, Vector, f64, f64, u64)> = vec![
        ("hard1", built_scene("hard1"), Vector::z(), 8.0, 0.1, 200),
        ("hard3", built_scene("hard3"), Vector::new(1.0, 0.5, 0.2), 5.0, 0.1, 200),
        ("turn", built_scene("turn"), Vector::z(), 40.0, 0.08, 200),
        ("plank", built_scene("plank"), Vector::z(), 45.0, 0.06, 200),
        ("ipanema2", built_scene("ipanema2"), Vector::z(), 3.0, 0.2, 200),
        ("real cables", with_real_cables(0.005), Vector::new(0.3, 0.0, 1.0), 2.0, 0.12, 30),
    ];
    cases.into_par_iter().for_each(|(name, scene, axis, degrees, resolution, tries)| {
        let ends = [turned(&scene, axis, -degrees), turned(&scene, axis, degrees)];
        let found = proved_at(&ends, ValidAt::Turns, resolution);
        println!("{name}: {:?} of {}, {:.3} decided", found.volume, found.total, found.decided);
        assert!(found.volume.min > 0.0 && found.decided > 0.5, "{name}: {:?} {}", found.volume, found.decided);
        assert_turns_agree(name, &ends, &found, tries * effort());
        let every = proved_at(&ends, ValidAt::Every, resolution);
        assert!(found.volume.min <= every.volume.max, "{name}: {:?} {:?}", found.volume, every.volume);
        let larger = proved_at(&ends, ValidAt::Turns, 4.0 * resolution).volume;
        assert!(larger.min <= found.volume.max && found.volume.min <= larger.max, "{name}: {larger:?}");
    });
}

#[test]
fn turns_that_cannot_be_are_refused() {
    let first = built_scene("turn");
    let refused = |scenes: &[Scene]| {
        let compiled: Vec<CompiledScene> = scenes.iter().map(compiled).collect();
        let options = WorkspaceOptions { resolution: Some(0.5), valid_at: ValidAt::Turns };
        workspace(&compiled.iter().collect::<Vec<_>>(), &options, &BatchOptions::default()).unwrap_err().to_string()
    };
    let one = std::slice::from_ref(&first);
    assert!(refused(one).starts_with("orientations: found 1, expected at least two"), "{}", refused(one));
    assert!(orientations_for(one, ValidAt::Turns).is_err() && orientations_for(&[], ValidAt::Turns).is_err());
    // The scene allows turns about the vertical only.
    let tilted = first.turned([0.96, 0.28, 0.0, 0.0].into()).unwrap();
    let message = refused(&[first.clone(), tilted]);
    assert!(message.contains("expected one that [turning] of the scene allows"), "{message}");
    let mut spec = testing::hard1().spec().clone();
    spec.wrench = Some(WrenchSpec { rule: Some(RuleSpec::Grid), ..WrenchSpec::default() });
    let scene = scene(spec);
    let turned = scene.turned([0.8, 0.0, 0.0, 0.6].into()).unwrap();
    assert!(refused(&[scene, turned]).starts_with("wrench.rule: found \"grid\""));
}
