//! Orientations: respected everywhere, named, chosen by planning, recorded in path files.

use std::sync::Arc;

use cdpr_core::collision::{Checker, Conditions, Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Rotation, Vector};
use cdpr_core::model::{BodySpec, MarginSpec, OrientationSource, OrientationSpec, RobotSource, SceneSpec};
use cdpr_core::plan::{Appraisal, PlanOptions, Planned, plan};
use cdpr_core::planning::Status;
use cdpr_core::regions::{RegionOptions, regions};
use cdpr_core::wrench::{Loads, Required, Statics, wrench_at};
use cdpr_core::{Scene, testing};
use cdpr_files::{PathFile, PathFormat, load_waypoints, save_path, scene_of_path, waypoints_from_text};
use cdpr_view::{Contents, Form};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn named(name: &str, yaw: f64) -> OrientationSpec {
    OrientationSpec { name: name.to_string(), rpy: Some([0.0, 0.0, yaw]), ..OrientationSpec::default() }
}

fn spec_of(rotation: &Rotation) -> [f64; 4] {
    [rotation.w, rotation.i, rotation.j, rotation.k]
}

/// The scene with the rotation applied to the robot itself: corners, attachments and centre of mass.
fn worked_in(scene: &Scene, rotation: &Rotation) -> Scene {
    let mut spec = scene.spec().clone();
    let turned = |p: [f64; 3]| (rotation * Vector::from(p)).into();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("robots of checked scenes are in place") };
    let parts = scene.robot().parts().iter();
    let corners = |part: &cdpr_core::geometry::Polytope| part.vertices().iter().map(|&v| turned(v.into())).collect();
    robot.platform = parts.map(|part| BodySpec { vertices: Some(corners(part)), ..BodySpec::default() }).collect();
    robot.cables.iter_mut().for_each(|cable| cable.attachment = turned(cable.attachment));
    robot.center_of_mass = robot.center_of_mass.map(turned);
    Scene::new(spec).unwrap()
}

/// Checks, shadows and wrenches at an orientation are those of a robot that was built rotated.
#[test]
fn an_orientation_is_honoured_everywhere() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let cogiro = cdpr_tests::built_scene("cogiro");
    for (k, scene) in [testing::hard1(), testing::hard3(), cogiro].iter().enumerate() {
        for round in 0..4 {
            let axis = Vector::new(rng.random(), rng.random(), rng.random()) * [0.3, 1.0, 2.0, 6.0][round];
            let rotation = Rotation::new(axis);
            let turned = scene.turned(spec_of(&rotation).into()).unwrap();
            let built = worked_in(scene, &rotation);
            same_answers(&format!("{k} {round}"), &turned, &built, &mut rng);
            same_regions(&turned, &built);
            same_wrenches(&turned, &built, &mut rng);
            let page = cdpr_view::page(&turned, Contents::default(), Form::Static);
            assert!(page.contains(&format!("\"orientation\":{}", serde_json::json!(spec_of(turned.orientation())))));
        }
    }
}

fn same_answers(name: &str, turned: &Scene, built: &Scene, rng: &mut ChaCha8Rng) {
    for kind in [Engine::Cspace, Engine::Gjk] {
        let [one, other]: [Arc<dyn Checker>; 2] =
            [turned, built].map(|scene| engine_for(scene, kind, Interference::Exact).unwrap());
        let (min, max) = one.conditions().position_box();
        let place = |rng: &mut ChaCha8Rng| min + (max - min).map(|side| side.max(0.0) * rng.random::<f64>());
        for _ in 0..300 {
            let (from, to) = (place(rng), place(rng));
            let to = from + (to - from) * 0.3;
            assert_eq!(one.motion_valid(&from, &to), other.motion_valid(&from, &to), "{name}: {from} {to}");
            assert_eq!(one.state_valid(&from), other.state_valid(&from), "{name}: {from}");
        }
    }
}

fn same_regions(turned: &Scene, built: &Scene) {
    let options = RegionOptions { all: true, ..RegionOptions::default() };
    let volumes = |scene: &Scene| -> Vec<(String, f64)> {
        regions(scene, &options).unwrap().meshes.iter().map(|r| (r.name.clone(), r.mesh.volume())).collect()
    };
    let (one, other) = (volumes(turned), volumes(built));
    assert!(!one.is_empty() && one.len() == other.len());
    for ((name, a), (other, b)) in one.iter().zip(&other) {
        assert!(name == other && (a - b).abs() < 1e-9 * (1.0 + a), "{name} {other}: {a} {b}");
    }
}

fn same_wrenches(turned: &Scene, built: &Scene, rng: &mut ChaCha8Rng) {
    if turned.robot().cables().iter().any(|cable| cable.tension.is_none()) {
        return;
    }
    let [one, other] = [turned, built].map(|scene| Statics::new(scene.robot(), &Loads::of(scene)).unwrap());
    for _ in 0..20 {
        let at = Point::new(rng.random_range(-2.0..2.0), rng.random_range(-2.0..2.0), rng.random_range(1.0..3.0));
        let [a, b] =
            [&one, &other].map(|statics| wrench_at(statics, &Required::default(), MarginSpec::Capacity, &at).unwrap());
        assert_eq!(a.feasible, b.feasible, "{at}");
        assert!((a.capacity_margin - b.capacity_margin).abs() < 1e-6 * (1.0 + a.capacity_margin.abs()), "{at}");
    }
}

/// A plank, 0.8 m long, and a wall with an upright slot 0.5 m wide, which it does not pass when turned across.
fn plank() -> SceneSpec {
    let mut spec = testing::paper_scene(
        "slot",
        vec![
            testing::block("left", [0.1, 0.75, 2.0], [1.0, 0.375, 1.0]),
            testing::block("right", [0.1, 0.75, 2.0], [1.0, 1.625, 1.0]),
        ],
    );
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.platform = vec![BodySpec { cuboid: Some([0.8, 0.05, 0.05]), ..BodySpec::default() }];
    robot.cables.truncate(2);
    for (cable, x) in robot.cables.iter_mut().zip([-0.4, 0.4]) {
        (cable.outlet, cable.attachment) = ([1.0 + 2.5 * x, 1.0, 2.0], [x, 0.0, 0.025]);
    }
    spec.orientations = vec![named("across", std::f64::consts::FRAC_PI_2), named("along", 0.0), named("askew", 0.3)];
    spec.query.as_mut().unwrap().start = Some([0.45, 1.0, 0.5].into());
    spec.query.as_mut().unwrap().goal = Some([1.55, 1.0, 0.5].into());
    spec
}

fn choose(scene: &Scene) -> Planned {
    plan(scene, &PlanOptions::default(), &()).unwrap()
}

#[test]
fn planning_takes_the_orientation_with_the_shortest_path() {
    let scene = Scene::new(plank()).unwrap();
    assert!(!scene.orientation_is_fixed() && scene.orientation_name() == Some("across") && scene.choices().len() == 3);
    let alone: Vec<_> =
        scene.choices().iter().map(|s| plan(s, &PlanOptions::default(), &|| false).unwrap().result).collect();
    let planned = choose(&scene);
    let least = alone.iter().filter(|r| r.status == Status::Solved).map(|r| r.cost).fold(f64::INFINITY, f64::min);
    assert!(alone[0].status != Status::Solved && planned.result.cost == least, "{} {least}", planned.result.cost);
    assert_eq!(planned.scene.orientation_name(), Some("along"));
    // The straight line is free there, so the third orientation is not searched.
    assert_eq!(planned.result.stats.samples, alone[0].stats.samples + alone[1].stats.samples);
    let askew = scene.turned(OrientationSource::Named("askew".to_string())).unwrap();
    assert_eq!(choose(&askew).scene, askew);
}

#[test]
fn without_a_path_the_most_informative_status_wins() {
    let mut spec = plank();
    spec.orientations = vec![named("blocked", 0.9), named("across", std::f64::consts::FRAC_PI_2)];
    spec.query.as_mut().unwrap().start = Some([0.74, 0.42, 0.5].into()); // valid only when turned across
    let planned = choose(&Scene::new(spec).unwrap());
    assert_eq!((planned.result.status, planned.scene.orientation_name()), (Status::GoalInvalid, Some("across")));
}

#[test]
fn a_path_is_checked_at_its_own_orientation() {
    let scene = Scene::new(plank()).unwrap();
    let planned = choose(&scene);
    let along = &planned.scene;
    assert!(along.orientation_is_fixed());
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("path.json");
    let saved = |scene| PathFile::planned(scene, &PlanOptions::default(), &planned.result, &Appraisal::default());
    save_path(&file, &saved(along)).unwrap();
    let loaded = load_waypoints(&file).unwrap();
    let (found, warning) = scene_of_path(&scene, &loaded, true).unwrap();
    assert_eq!(warning, None);
    assert_eq!((found.orientation_name(), &loaded.waypoints), (Some("along"), &planned.result.waypoints()));
    // An error at another orientation that the scene selects.
    let across = scene.turned(OrientationSource::Named("across".to_string())).unwrap();
    let refused = scene_of_path(&across, &loaded, false).unwrap_err().to_string();
    assert!(refused.contains("orientation: found a path at [1.0, 0.0, 0.0, 0.0], but the scene is at"), "{refused}");
    // Waypoints alone have no orientation, and the scene selects none.
    let bare = waypoints_from_text("x,y,z\n0.45,1,0.5\n1.55,1,0.5\n", PathFormat::Csv).unwrap();
    let refused = scene_of_path(&scene, &bare, false).unwrap_err().to_string();
    assert!(refused.contains("selects none of across, along, askew; select one"), "{refused}");
    assert!(scene_of_path(&across, &bare, true).is_ok() && Conditions::new(&across).unwrap().notes.is_empty());
    assert!(Conditions::new(&scene).unwrap().notes[0].contains("selects none; using \"across\", the first"));
    // An edited scene gives a result and a warning, or an error.
    let mut other = plank();
    other.obstacles[0].position = Some([1.0, 0.3, 1.0]);
    let edited = Scene::new(other.clone()).unwrap();
    let (found, warning) = scene_of_path(&edited, &loaded, false).unwrap();
    assert_eq!(found.orientation_name(), Some("along"));
    assert!(warning.unwrap().contains("planned for another scene: \"slot\""));
    assert!(scene_of_path(&edited, &loaded, true).unwrap_err().to_string().contains("another scene"));
    // A scene that no longer has the path's orientation gives an error.
    other.orientations.retain(|orientation| orientation.name != "along");
    let without = Scene::new(other).unwrap();
    let refused = scene_of_path(&without, &loaded, false).unwrap_err().to_string();
    assert!(refused.contains("not one of the scene's orientations (across, askew)"), "{refused}");
    let bare =
        Scene::new(SceneSpec { orientations: vec![named("across", 1.0), named("askew", 0.3)], ..plank() }).unwrap();
    assert_eq!(bare.turned([1.0, 0.0, 0.0, 0.0].into()).unwrap().fingerprint(), along.fingerprint());
    assert!(
        scene_of_path(&bare, &loaded, false).unwrap_err().to_string().contains("not one of the scene's orientations")
    );
    // A path planned for this very scene at an orientation without a name is checked at that orientation.
    let aside = scene.turned([0.6f64.cos(), 0.0, 0.0, 0.6f64.sin()].into()).unwrap();
    save_path(&file, &saved(&aside)).unwrap();
    let (found, warning) = scene_of_path(&scene, &load_waypoints(&file).unwrap(), false).unwrap();
    assert_eq!((found.orientation(), warning), (aside.orientation(), None));
}

#[test]
fn fingerprints_depend_on_rotation_not_notation() {
    let mut spec = plank();
    spec.orientations.push(named("half", 1.0));
    let scene = Scene::new(spec).unwrap();
    let by_name = scene.turned(OrientationSource::Named("half".to_string())).unwrap();
    let (c, s) = (0.5f64.cos(), 0.5f64.sin());
    for quaternion in [[c, 0.0, 0.0, s], [-c, 0.0, 0.0, -s]] {
        let turned = scene.turned(quaternion.into()).unwrap();
        assert_eq!(turned.fingerprint(), by_name.fingerprint());
        assert_eq!(turned.orientation_name(), Some("half"));
    }
    assert_ne!(by_name.fingerprint(), scene.fingerprint());
    let half = |w: f64, k: f64| scene.turned([w, 0.0, 0.0, k].into()).unwrap().fingerprint();
    assert!(half(0.0, 1.0) == half(0.0, -1.0) && half(6e-17, 1.0) == half(-6e-17, 1.0));
    let plain = Scene::new(SceneSpec { orientations: Vec::new(), ..plank() }).unwrap();
    let level = scene.turned(OrientationSource::Named("along".to_string())).unwrap();
    assert_eq!(level.fingerprint(), plain.fingerprint());
}

#[test]
fn bad_orientations_are_named() {
    let with =
        |orientations: Vec<OrientationSpec>| Scene::new(SceneSpec { orientations, ..plank() }).unwrap_err().to_string();
    let both = OrientationSpec { quaternion: Some([1.0, 0.0, 0.0, 0.0]), ..named("a", 0.0) };
    for (found, expected) in [
        (with(vec![named("a", 0.0), named("a", 1.0)]), "orientations[1].name: found \"a\""),
        (with(vec![named("", 0.0)]), "orientations[0].name: found \"\""),
        (with(vec![both]), "orientations[0]: found both rpy and quaternion"),
        (with(vec![named("a", f64::NAN)]), "orientations[0].rpy: found NaN"),
    ] {
        assert!(found.contains(expected), "{found}");
    }
    let scene = Scene::new(plank()).unwrap();
    let refused = |source: OrientationSource| scene.turned(source).unwrap_err().to_string();
    assert!(refused(OrientationSource::Named("acros".to_string())).contains("did you mean \"across\"?"));
    assert!(refused([1.0, 1.0, 0.0, 0.0].into()).contains("length 1.41"));
}
