//! Payloads and tasks: scenes against those written by hand, legs that are blocked until something is moved, tensions by hand.

use cdpr_core::collision::check_path;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Pose, Rotation, Vector, wxyz};
use cdpr_core::model::{
    BodySpec, ClearancesSpec, InertiaSpec, OrientationSource, OrientationSpec, PairClearanceSpec, PayloadSpec,
    PositionSource, RobotSource, Scene, SceneSpec, StationSpec, TaskRowSpec, WrenchSpec,
};
use cdpr_core::path_file::PathFile;
use cdpr_core::plan::{Appraisal, PlanOptions, Query, plan};
use cdpr_core::planning::Status;
use cdpr_core::task::{Task, TaskFile, TaskLegs, TaskNames, TaskTiming, plan_task};
use cdpr_core::testing::{self, block};
use cdpr_core::watch::Watch;
use cdpr_core::{MotionSpec, Required, check, wrench_of_scene_at};

/// The names of the files of a task.
pub const NAMES: TaskNames = TaskNames {
    path: |k| format!("leg-{}.json", k + 1),
    motion: |k| format!("leg-{}-motion.json", k + 1),
    whole: "motion.json",
};

pub fn spec() -> SceneSpec {
    toml::from_str(include_str!("../../testdata/tasks/tower.toml")).unwrap()
}

pub fn scene(spec: SceneSpec) -> Scene {
    Scene::new(spec).unwrap()
}

fn refused(spec: SceneSpec) -> String {
    Scene::new(spec).unwrap_err().to_string()
}

pub fn planned(scene: &Scene) -> Task {
    plan_task(scene, &PlanOptions::default(), None, &|| false, &|_, _| ()).unwrap()
}

fn at(station: &str) -> PositionSource {
    PositionSource::Named(station.to_string())
}

fn row(key: &str, value: &str) -> TaskRowSpec {
    serde_json::from_value(serde_json::json!({ key: value })).unwrap()
}

pub fn rows(rows: &[(&str, &str)]) -> Vec<TaskRowSpec> {
    rows.iter().map(|(key, value)| row(key, value)).collect()
}

fn file(scene: &Scene, ends: [[f64; 3]; 2]) -> String {
    let query = Query::of(scene).starting_at(ends[0].into()).to(ends[1].into());
    let result = plan(query, &PlanOptions::default(), &()).unwrap().result;
    assert_eq!(result.status, Status::Solved);
    let mut file = serde_json::json!(PathFile::planned(scene, &PlanOptions::default(), &result, &Appraisal::default()));
    let known = file.as_object_mut().unwrap();
    for times in ["stats", "history"] {
        known.remove(times);
    }
    serde_json::to_string(&file).unwrap()
}

#[test]
fn a_payload_that_stands_is_an_obstacle_and_one_that_is_carried_a_part_of_the_platform() {
    let with = SceneSpec { task: Vec::new(), ..spec() };
    let ends = [[0.6, 1.0, 0.7], [1.5, 1.4, 0.5]];
    let by_hand = SceneSpec { payloads: Vec::new(), ..with.clone() };
    let mut standing = by_hand.clone();
    standing.obstacles.extend([
        block("tower", [0.3, 0.3, 0.7], [1.0, 1.0, 0.725 - 0.375]),
        block("crate", [0.15, 0.15, 0.2], [0.25, 0.4, 0.225 - 0.125]),
        block("chest", [0.15, 0.15, 0.2], [0.25, 1.0, 0.225 - 0.125]),
    ]);
    let (found, expected) = (scene(with.clone()), scene(standing.clone()));
    assert_eq!(found.spec(), expected.spec());
    assert_eq!(found.written(), &with);
    assert_eq!(found.fingerprint(), expected.fingerprint());
    assert_eq!(file(&found, ends), file(&expected, ends));

    let mut carrying = standing.clone();
    carrying.obstacles.remove(3);
    let RobotSource::Inline(robot) = &mut carrying.robot else { unreachable!() };
    robot.platform.push(block("tower", [0.3, 0.3, 0.7], [0.0, 0.0, -0.375]));
    robot.mass = Some(13.0);
    robot.center_of_mass = Some([0.0, 0.0, 3.0 * -0.375 / 13.0]);
    // By hand: both about the common centre, with the boxes at uniform density.
    let (c, up, down) = (3.0 * -0.375 / 13.0, 3.0 * 0.375 / 13.0, 10.0 * 0.375 / 13.0);
    let side = 10.0 / 12.0 * (0.15 * 0.15 + 0.05 * 0.05)
        + 10.0 * up * up
        + 3.0 / 12.0 * (0.3 * 0.3 + 0.7 * 0.7)
        + 3.0 * down * down;
    let upright = 10.0 / 12.0 * 2.0 * 0.15 * 0.15 + 3.0 / 12.0 * 2.0 * 0.3 * 0.3;
    let found = scene(with).carrying("tower").unwrap();
    let tensor = found.robot().inertia().unwrap();
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
    for (k, expected) in [side, side, upright].into_iter().enumerate() {
        close(tensor[(k, k)], expected);
        close(tensor[(k, (k + 1) % 3)], 0.0);
    }
    close(found.robot().center_of_mass().z, c);
    let tensor = [0, 1, 2].map(|row| [0, 1, 2].map(|column| tensor[(row, column)]));
    let RobotSource::Inline(robot) = &mut carrying.robot else { unreachable!() };
    robot.inertia = Some(InertiaSpec::Tensor(tensor));
    let expected = scene(carrying);
    assert_eq!(found.spec(), expected.spec());
    let ends = [[0.6, 1.0, 0.8], [0.6, 1.5, 0.8]];
    assert_eq!(file(&found, ends), file(&expected, ends));
    // And back.
    let again = found.placed("tower", at("gap")).unwrap();
    assert_eq!(again.spec(), scene(standing).spec());
    let moved = found.placed("tower", [0.4, 1.6, 0.725].into()).unwrap();
    assert_eq!(moved.obstacles()[3].aabb().min.y, 1.6 - 0.15);
}

#[test]
fn a_payload_at_a_station_with_an_orientation_is_turned() {
    let turn = Rotation::from_scaled_axis(Vector::new(0.1, -0.2, 0.7));
    let mut spec = SceneSpec { task: Vec::new(), ..spec() };
    spec.stations.push(StationSpec {
        name: "askew".to_string(),
        position: [0.6, 0.5, 0.5],
        orientation: Some(wxyz(&turn).into()),
    });
    spec.payloads.truncate(1);
    spec.payloads[0].body[0].rpy = Some([0.3, 0.2, -0.5]);
    let body = scene(spec.clone()).payloads()[0].parts[0].clone();
    let askew = scene(spec.clone()).placed("tower", at("askew")).unwrap();
    let found = &askew.obstacles()[3].parts[0];
    for corner in body.vertices() {
        let expected = Point::new(0.6, 0.5, 0.5) + turn * corner.coords;
        assert!(found.vertices().iter().any(|v| (v - expected).norm() < 1e-12));
    }
    // The scene's own orientation, if the station has none, whatever the query goes between.
    let yaw = Rotation::from_scaled_axis(Vector::z() * 0.5);
    spec.payloads[0].body[0].rpy = None;
    let plain = scene(spec.clone());
    let turned = plain.turned(wxyz(&yaw).into()).unwrap();
    let corner = yaw * Vector::new(0.15, 0.15, -0.725) + Vector::new(1.0, 1.0, 0.725);
    assert!(turned.obstacles()[3].parts[0].vertices().iter().any(|v| (v.coords - corner).norm() < 1e-12));
    let ends = ["askew", "askew"].map(|name| Some(at(name)));
    assert_eq!(plain.clone().between(ends).unwrap().obstacles(), plain.obstacles());
    let asked = scene(SceneSpec { task: rows(&[("pick", "tower")]), ..spec.clone() });
    let elsewhere = asked.between(["corner", "askew"].map(|name| Some(at(name)))).unwrap();
    assert_eq!(elsewhere.task().unwrap().start.position, Point::new(0.4, 1.6, 0.725));
    assert_eq!(plain.obstacles()[3].aabb().max, Point::new(1.15, 1.15, 0.7));
    spec.orientations =
        ["a", "b"].map(|name| OrientationSpec { name: name.to_string(), ..Default::default() }).to_vec();
    assert!(refused(spec).starts_with("payloads[0].at: found a place without an orientation"));
}

/// A platform that hangs symmetrically on four cables: each holds a quarter of the weight over the cosine of its angle.
#[test]
fn tensions_while_carrying_are_those_worked_out_by_hand() {
    let mut spec = SceneSpec { task: Vec::new(), wrench: Some(WrenchSpec::default()), ..spec() };
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.cables.iter_mut().for_each(|cable| cable.attachment = [0.0, 0.0, 0.025]);
    let scene = scene(spec);
    let place = Point::new(1.0, 1.0, 0.775);
    let (rise, run) = (1.2_f64, 2.0_f64.sqrt());
    for (scene, mass) in [
        (scene.clone(), 10.0),
        (scene.carrying("tower").unwrap(), 13.0),
        (scene.carrying("crate").unwrap().placed("tower", at("corner")).unwrap(), 14.0),
    ] {
        let scene = scene.without("south wall").unwrap().without("north wall").unwrap();
        let report = wrench_of_scene_at(&scene, &Required::default(), &place).unwrap();
        let expected = mass * 9.81 / 4.0 * rise.hypot(run) / rise;
        let tensions = report.tensions.expect("it hangs in the middle");
        assert!(tensions.iter().all(|found| (found - expected).abs() < 1e-6), "{tensions:?} {expected}");
    }
}

#[test]
fn a_tower_blocks_the_way_until_it_is_moved() {
    let whole = scene(spec());
    let task = planned(&whole);
    for (leg, plan) in task.legs.legs.iter().zip(&task.plans) {
        assert_eq!(plan.status, Status::Solved, "{:?} {:?}: {:?}", leg.from.name, leg.to.name, plan.reason);
        let compiled = CompiledScene::new(&leg.scene, Default::default(), Default::default(), &Watch::NONE).unwrap();
        assert!(check_path(&compiled, &plan.path, &Watch::NONE).unwrap().valid);
        assert_eq!((plan.path[0], plan.path[plan.path.len() - 1]), (leg.from.pose, leg.to.pose));
    }
    assert!(task.plans.len() == 7 && task.status() == Status::Solved && task.cost().is_finite());
    let third = &task.plans[5];
    assert!(third.path.iter().any(|pose| pose.position == Point::new(1.0, 1.0, 0.5)), "the via");
    assert!(task.legs.legs.windows(2).all(|pair| pair[0].to == pair[1].from));

    // What is carried, and which clearances are waived.
    let carried = |k: usize| -> Vec<&str> {
        let payloads = whole.payloads().iter().zip(&task.legs.legs[k].stands);
        payloads.filter(|(_, stands)| stands.is_none()).map(|(payload, _)| payload.name.as_str()).collect()
    };
    assert_eq!([0, 1, 2, 3, 4, 5, 6].map(|k| carried(k).join("+")), ["", "tower", "", "crate", "", "chest", ""]);
    let touch = |k: usize| -> Vec<&str> { task.legs.legs[k].touch.iter().map(|[_, name]| name.as_str()).collect() };
    assert_eq!(
        [0, 1, 2, 3, 4, 5, 6].map(|k| touch(k).join("+")),
        ["tower", "", "tower+crate", "table", "crate+chest", "", "chest"]
    );
    assert!(task.legs.legs.iter().flat_map(|leg| &leg.touch).all(|pair| pair[0] == "platform"));

    // Without moving the tower first, the crate cannot pass; the other legs are planned.
    let direct = rows(&[("pick", "crate"), ("go", "table"), ("place", "crate"), ("go", "dock")]);
    let task = planned(&scene(SceneSpec { task: direct, ..spec() }));
    let status: Vec<Status> = task.plans.iter().map(|plan| plan.status).collect();
    assert_eq!(status, [Status::Solved, Status::NoPath, Status::Solved]);
    assert_eq!((task.status(), task.cost()), (Status::NoPath, f64::INFINITY));
    let reason = task.plans[1].reason.as_ref().unwrap();
    assert!(reason.contains("tower") && reason.contains("without tower "), "{reason}");
}

#[test]
fn the_platform_turns_to_a_payload_that_stands_askew() {
    let yaw = |angle: f64| wxyz(&Rotation::from_scaled_axis(Vector::z() * angle));
    let mut turning = spec();
    turning.payloads.drain(..1);
    turning.payloads[0].orientation = Some(yaw(0.2).into());
    turning.stations.push(StationSpec {
        name: "askew".to_string(),
        position: [0.5, 1.5, 0.6],
        orientation: Some(yaw(0.2).into()),
    });
    turning.task = rows(&[("pick", "crate"), ("via", "dock"), ("go", "askew"), ("go", "dock")]);
    let turned = scene(turning);
    let task = planned(&turned);
    let angles = |path: &[Pose]| -> Vec<f64> { path.iter().map(|pose| pose.orientation.angle()).collect() };
    for (leg, plan) in task.legs.legs.iter().zip(&task.plans) {
        assert_eq!(plan.status, Status::Solved, "{:?}", plan.reason);
        let compiled = CompiledScene::new(&leg.scene, Default::default(), Default::default(), &Watch::NONE).unwrap();
        assert!(check(&compiled, &plan.path, &Watch::NONE).unwrap().path.valid);
    }
    // Without a limit of turns, the legs that turn have no motion; nothing else is lost.
    let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
    let timed = task.clone().timed(&turned, &TaskTiming { limits, rate: None }, None, &|| false).unwrap();
    assert_eq!((timed.status(), timed.cost()), (Status::Solved, task.cost()));
    let motion = timed.motion.unwrap();
    let [turns, keeps, back] = &motion.legs[..] else { panic!() };
    assert!(keeps.is_ok() && motion.whole.is_none());
    for reason in [turns, back].map(|leg| leg.as_ref().unwrap_err()) {
        assert!(reason.starts_with("turn_acceleration: found no limit"), "{reason}");
    }
    let [straight, turning] = [scene(spec()), turned].map(|scene| {
        let legs = TaskLegs::of(&scene).unwrap();
        TaskTiming::default().checked(&scene, &legs).map_err(|e| e.to_string())
    });
    // The second leg does not turn.
    for refused in [straight, turning].map(Result::unwrap_err) {
        assert!(refused.starts_with("acceleration: found no limit"), "{refused}");
    }
    let [first, second, third] = [0, 1, 2].map(|k| angles(&task.plans[k].path));
    assert!(first[0] == 0.0 && (first[first.len() - 1] - 0.2).abs() < 1e-12);
    // Between poses of one orientation the platform keeps it, also where it passes a station without one.
    assert!(second.iter().all(|angle| (angle - 0.2).abs() < 1e-12) && task.plans[1].file.orientations.is_none());
    assert!((third[0] - 0.2).abs() < 1e-12 && third[third.len() - 1] == 0.0);
    assert_eq!(task.plans[2].file.turns().unwrap().unwrap().len(), third.len());
}

#[test]
fn contact_is_free_only_where_a_payload_is_picked_or_placed() {
    // Placed on the table, the crate touches it; a leg that only stops there must keep the clearance.
    let only = rows(&[("go", "middle"), ("go", "west")]);
    let task = planned(&scene(SceneSpec { task: only, ..spec() }));
    assert_eq!(task.plans[0].status, Status::GoalInvalid);
    assert!(task.plans[0].reason.as_ref().unwrap().contains("chest"), "{:?}", task.plans[0].reason);
    // Overlap is never free: a table 2 mm higher.
    let mut high = spec();
    high.obstacles[2].cuboid = Some([0.3, 0.3, 0.104]);
    let task = planned(&scene(high));
    let status: Vec<Status> = task.plans.iter().map(|plan| plan.status).collect();
    assert_eq!((status[3], status[4]), (Status::GoalInvalid, Status::Solved));
    // A clearance of the pair itself is waived too, and only there.
    let mut own = spec();
    let pair = PairClearanceSpec { between: ["platform", "table"].map(str::to_string), clearance: 0.02 };
    own.clearances = Some(ClearancesSpec { pairs: vec![pair], ..ClearancesSpec::default() });
    assert_eq!(planned(&scene(own)).status(), Status::Solved);
}

#[test]
fn a_task_file_is_followed_and_its_damage_named() {
    let scene = scene(spec());
    let task = planned(&scene);
    let file = TaskFile::of(&scene, &task, &NAMES);
    let text = serde_json::to_string(&file).unwrap();
    let read: TaskFile = serde_json::from_str(&text).unwrap();
    assert_eq!(read, file);
    assert_eq!(TaskLegs::of(&scene).unwrap().legs.len(), 7);
    let legs = read.legs(&scene).unwrap();
    for (found, expected) in legs.legs.iter().zip(&task.legs.legs) {
        assert_eq!((&found.scene, &found.touch, &found.stands), (&expected.scene, &expected.touch, &expected.stands));
    }
    assert_eq!(legs.after, task.legs.after);
    let damaged = |pointer: &str, value: serde_json::Value| {
        let mut file: serde_json::Value = serde_json::from_str(&text).unwrap();
        *file.pointer_mut(pointer).unwrap() = value;
        let read = serde_json::from_value::<TaskFile>(file).unwrap();
        read.legs(&scene).unwrap_err().to_string()
    };
    for (pointer, value, said) in [
        ("/format", serde_json::json!("path"), "format: found \"path\""),
        ("/version", serde_json::json!(2), "version: found 2, expected 1"),
        ("/legs", serde_json::json!([]), "legs: found none"),
        ("/legs/1/from/position/0", serde_json::json!(1.1), "legs[1].from: found [1.1, 1.0, 0.725]"),
        ("/legs/1/from/orientation", serde_json::json!([0.0, 0.0, 0.0, 1.0]), "legs[1].from: found"),
        ("/legs/1/from/orientation", serde_json::json!([0.0, 0.0, 0.0, 2.0]), "legs[1].from.orientation: found"),
        ("/legs/1/before/0/pick", serde_json::json!("crate"), "legs[1].before[0].pick: found \"crate\" at"),
        ("/legs/1/before/0/pick", serde_json::json!("cart"), "legs[1].before[0].pick: found \"cart\""),
        ("/legs/1/before", serde_json::json!([]), "legs[1].carried: found \"tower\", which stands then"),
        (
            "/legs/2/before/0",
            serde_json::json!({"pick": "tower"}),
            "legs[2].before[0].pick: found \"tower\", which is carried",
        ),
        ("/legs/1/carried", serde_json::json!([]), "legs[1].carried: found none named \"tower\""),
        ("/legs/3/standing/tower/position/1", serde_json::json!(1.5), "legs[3].standing.tower: found"),
        ("/legs/3/touch", serde_json::json!([]), "legs[3].touch: found []"),
        ("/after", serde_json::json!([{"place": "crate"}]), "after[0].place: found \"crate\", which is not carried"),
    ] {
        let found = damaged(pointer, value);
        assert!(found.starts_with(said), "{pointer}: {found}");
    }
}

#[test]
fn what_no_payload_and_no_task_can_be_is_refused() {
    let payload = |change: &dyn Fn(&mut PayloadSpec)| {
        let mut spec = spec();
        change(&mut spec.payloads[1]);
        refused(spec)
    };
    let flat = BodySpec { cuboid: Some([1.0, 1.0, 0.0]), ..BodySpec::default() };
    let named = block("box", [0.1; 3], [0.0; 3]);
    let around = block("", [0.16, 0.16, 0.2], [0.0, 0.0, -0.05]);
    let around = BodySpec { name: None, ..around };
    for (found, said) in [
        (payload(&|p| p.name = "tower".to_string()), "payloads[1].name: found \"tower\", expected a unique name"),
        (payload(&|p| p.name = "table".to_string()), "payloads[1].name: found \"table\", which is already"),
        (payload(&|p| p.name = "SW".to_string()), "payloads[1].name: found \"SW\", which is already"),
        (payload(&|p| p.name = "platform".to_string()), "payloads[1].name: found \"platform\", which is already"),
        (payload(&|p| p.mass = 0.0), "payloads[1].mass: found 0, expected a finite positive number"),
        (payload(&|p| p.center_of_mass = Some([f64::NAN, 0.0, 0.0])), "payloads[1].center_of_mass: found NaN"),
        (payload(&|p| p.body = vec![flat.clone()]), "payloads[1].body: found a body without volume"),
        (payload(&|p| p.body.push(flat.clone())), "payloads[1].body[1]: found a body without volume"),
        (payload(&|p| p.body = vec![named.clone()]), "payloads[1].body.name: found a name"),
        (payload(&|p| p.body = vec![]), "payloads[1].body: found no bodies"),
        (
            payload(&|p| p.body = vec![around.clone()]),
            "payloads[1].body: found a payload that the robot cannot carry: ",
        ),
        (payload(&|p| p.at = Some(at("wast"))), "payloads[1].at: found \"wast\", expected a position"),
        (payload(&|p| p.at = None), "payloads[1].at: found none, expected the station"),
        (payload(&|p| p.carried = true), "payloads[1].at: found one, but it is carried"),
        (
            payload(&|p| p.orientation = Some(OrientationSource::Named("up".to_string()))),
            "payloads[1].orientation: found \"up\"",
        ),
    ] {
        assert!(found.starts_with(said), "{found}");
    }
    let task = |list: &[(&str, &str)]| refused(SceneSpec { task: rows(list), ..spec() });
    for (found, said) in [
        (
            task(&[("go", "dok")]),
            "task[0].go: found \"dok\", expected a position [x, y, z] or one of the scene's stations",
        ),
        (
            task(&[("pick", "crat")]),
            "task[0].pick: found \"crat\", expected one of the scene's payloads (tower, crate, chest); did you mean \"crate\"?",
        ),
        (task(&[("pick", "crate"), ("pick", "crate")]), "task[1].pick: found \"crate\", which is carried already"),
        (
            task(&[("pick", "crate"), ("pick", "chest")]),
            "task[1].pick: found \"chest\", whose body overlaps that of \"crate\"",
        ),
        (task(&[("place", "crate")]), "task[0].place: found \"crate\", which is not carried then"),
        (task(&[("pick", "crate"), ("via", "gap"), ("place", "crate")]), "task[2].place: found it after via"),
        (task(&[("go", "gap"), ("via", "dock")]), "task[1].via: found the last row"),
    ] {
        assert!(found.starts_with(said), "{found}");
    }
    let both = TaskRowSpec { go: Some(at("gap")), ..row("pick", "crate") };
    let odd = |rows: Vec<TaskRowSpec>| refused(SceneSpec { task: rows, query: None, ..spec() });
    assert!(odd(vec![both]).starts_with("task[0]: found go and pick, expected exactly one of"));
    assert!(odd(vec![TaskRowSpec::default()]).starts_with("task[0]: found none, expected exactly one of"));
    assert!(odd(rows(&[("via", "gap")])).starts_with("task[0].via: found the first row"));
    let two = |spec: &mut SceneSpec| {
        spec.payloads[1..].iter_mut().for_each(|p| *p = PayloadSpec { at: None, carried: true, ..p.clone() });
    };
    let mut both = SceneSpec { task: Vec::new(), ..spec() };
    two(&mut both);
    assert!(refused(both).starts_with("payloads[2]: found \"chest\", whose body overlaps that of \"crate\""));
    let none = SceneSpec { task: Vec::new(), ..spec() };
    let none = plan_task(&scene(none), &PlanOptions::default(), None, &|| false, &|_, _| ()).unwrap_err();
    assert!(none.to_string().starts_with("task: found none"));
    assert!(testing::hard1().carrying("crate").unwrap_err().to_string().starts_with("payloads: found \"crate\""));
}

#[test]
fn several_are_carried_if_there_is_room() {
    let mut spec = spec();
    spec.payloads[2].body[0].position = Some([0.15, 0.0, -0.125]);
    spec.payloads[2].at = Some([0.25, 1.0, 0.225].into());
    spec.payloads[0].center_of_mass = Some([0.0, 0.0, -0.1]);
    spec.task = rows(&[
        ("pick", "crate"),
        ("pick", "chest"),
        ("go", "corner"),
        ("place", "crate"),
        ("place", "chest"),
        ("go", "dock"),
    ]);
    let scene = scene(spec);
    let both = scene.carrying("crate").unwrap().carrying("chest").unwrap();
    assert_eq!((both.robot().mass(), both.robot().parts().len()), (Some(19.0), 3));
    let expected = (4.0 * Vector::new(0.0, 0.0, -0.125) + 5.0 * Vector::new(0.15, 0.0, -0.125)) / 19.0;
    assert!((both.robot().center_of_mass().coords - expected).norm() < 1e-12);
    let tower = scene.carrying("tower").unwrap();
    assert!((tower.robot().center_of_mass().z + 0.3 / 13.0).abs() < 1e-12);
    let task = planned(&scene);
    assert_eq!(task.legs.legs.len(), 4);
    assert_eq!(task.legs.legs[2].stands.iter().filter(|stands| stands.is_none()).count(), 2);
    assert_eq!(task.legs.legs[3].before.len(), 2);
}

#[test]
fn an_interrupt_keeps_what_is_planned_and_threads_change_nothing() {
    let scene = scene(spec());
    let stopped = plan_task(&scene, &PlanOptions::default(), Some(1), &|| true, &|_, _| ()).unwrap();
    assert!(stopped.plans.iter().all(|plan| plan.status == Status::Interrupted));
    let file = |threads: usize| {
        let task = plan_task(&scene, &PlanOptions::default(), Some(threads), &|| false, &|_, _| ()).unwrap();
        serde_json::to_string(&TaskFile::of(&scene, &task, &NAMES)).unwrap()
    };
    assert_eq!(file(1), file(2));
}
