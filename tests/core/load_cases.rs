//! Scenes with several loads and a payload: a claim holds if it holds in each load case.

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::model::{BodySpec, CableSpec, MarginSpec, RobotSource, Scene, SceneSpec, WrenchSpec};
use cdpr_core::path::check;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::Status;
use cdpr_core::testing::empty;
use cdpr_core::trajectory::Trajectory;
use cdpr_core::trajectory_check::{FaultKind, Recorded, TrajectoryRules, check_trajectory};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::turning::TurningWrench;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{Loads, Required, measures, wrench_of_scene_at};
use cdpr_tests::compiled;
use cdpr_tests::{built_scene, rng};
use rand::RngExt;

/// A scene under other loads.
fn under(scene: &Scene, change: impl Fn(&mut WrenchSpec)) -> Scene {
    let mut spec = scene.spec().clone();
    change(spec.wrench.get_or_insert_default());
    Scene::new(spec).unwrap()
}

/// A scene whose platform weighs more, kg.
fn heavier(scene: &Scene, payload: f64) -> Scene {
    let mut spec = scene.spec().clone();
    let mut robot = scene.robot().spec().clone();
    robot.mass = robot.mass.map(|mass| mass + payload);
    spec.robot = RobotSource::Inline(robot);
    Scene::new(spec).unwrap()
}

const LEFT: [f64; 6] = [-60.0, 0.0, 0.0, 0.0, 0.0, 0.0];
const UP: [f64; 6] = [0.0, 50.0, 200.0, 0.0, 20.0, 0.0];
const PAYLOAD: f64 = 100.0;

/// CoGiRo with two loads and a payload, and with each of the four load cases alone.
fn cogiro(change: impl Fn(&mut WrenchSpec)) -> (Scene, [Scene; 4]) {
    let scene = under(&built_scene("cogiro"), |wrench| change(wrench));
    let all = under(&scene, |wrench| (wrench.loads, wrench.payload) = (Some(vec![LEFT, UP]), Some(PAYLOAD)));
    let [left, up] = [LEFT, UP].map(|load| under(&scene, |wrench| wrench.load = Some(load)));
    let [left_loaded, up_loaded] = [&left, &up].map(|scene| heavier(scene, PAYLOAD));
    (all, [left, up, left_loaded, up_loaded])
}

fn random_point(scene: &Scene, rng: &mut impl RngExt) -> Point {
    let bounds = scene.workspace();
    Point::from(Vector::from_fn(|axis, _| rng.random_range(bounds.min[axis]..bounds.max[axis])))
}

#[test]
fn a_motion_is_valid_if_it_is_so_in_every_load_case() {
    let mut rng = rng(39);
    for margin in [MarginSpec::Capacity, MarginSpec::Projected] {
        let (all, single) = cogiro(|wrench| wrench.margin = Some(margin));
        for kind in [Engine::Cspace, Engine::Gjk] {
            let engine = |scene: &Scene| engine_for(scene, kind, Interference::Exact).unwrap();
            let (whole, parts) = (engine(&all), single.each_ref().map(engine));
            let mut counts = [0; 2];
            for _ in 0..400 {
                let from = random_point(&all, &mut rng);
                let to = from + Vector::from_fn(|_, _| rng.random_range(-0.5..0.5));
                let each = parts.each_ref().map(|engine| engine.motion_valid(&from, &to));
                let valid = whole.motion_valid(&from, &to);
                assert_eq!(valid, each.iter().all(|valid| *valid), "{margin:?} {from} {to} {each:?}");
                // Only motions that some cases allow and others do not are counted.
                counts[usize::from(valid)] += usize::from(valid || each.iter().any(|valid| *valid));
                if !valid && each.iter().any(|valid| *valid) {
                    let wrench = whole.violations(&from, &to).into_iter().find_map(|violation| violation.wrench);
                    let case = wrench.unwrap().load_case.unwrap().to_string();
                    assert!(case.starts_with("load ") && case.contains("the payload"), "{case}");
                }
            }
            assert!(counts.iter().all(|count| *count >= 20), "{counts:?}");
        }
    }
}

#[test]
fn a_turning_motion_is_valid_if_it_is_so_in_every_load_case() {
    let mut rng = rng(40);
    for margin in [MarginSpec::Capacity, MarginSpec::Projected] {
        let (all, single) = cogiro(|wrench| wrench.margin = Some(margin));
        let requirement = |scene: &Scene| TurningWrench::of(scene).unwrap().unwrap();
        let (whole, parts) = (requirement(&all), single.each_ref().map(requirement));
        let mut counts = [0; 2];
        for _ in 0..150 {
            let from = Pose::new(random_point(&all, &mut rng), *all.orientation());
            let turn = Rotation::from_scaled_axis(Vector::from_fn(|_, _| rng.random_range(-0.2..0.2)));
            let to = Pose::new(from.position + Vector::x() * 0.3, turn * all.orientation());
            let each = parts.each_ref().map(|part| part.keeps(&from, &to));
            let valid = whole.keeps(&from, &to);
            assert_eq!(valid, each.iter().all(|valid| *valid), "{margin:?} {each:?}");
            assert_eq!(valid, whole.violation(&from, &to).is_none());
            let least = whole.least_at(&from).unwrap();
            let of_each = parts.iter().map(|part| part.least_at(&from).unwrap().order());
            assert_eq!(least.order(), of_each.fold(f64::INFINITY, f64::min));
            counts[usize::from(valid)] += usize::from(valid || each.iter().any(|valid| *valid));
        }
        assert!(counts.iter().all(|count| *count >= 5), "{counts:?}");
    }
}

/// A point mass of 10 kg that hangs at (1, 1, 1) on four cables from (0 or 2, 0 or 2, 2): each carries W √3 / 4.
fn hanging(wrench: WrenchSpec) -> Scene {
    let mut spec = SceneSpec { wrench: Some(wrench), ..empty().spec().clone() };
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("an inline robot") };
    let cable = |k: usize| CableSpec {
        outlet: [2.0 * (k / 2) as f64, 2.0 * (k % 2) as f64, 2.0],
        attachment: [0.0; 3],
        tension: Some([0.0, 50.0]),
        ..robot.cables[0].clone()
    };
    robot.cables = (0..4).map(cable).collect();
    robot.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
    (robot.mass, robot.center_of_mass) = (Some(10.0), None);
    for (k, cable) in robot.cables.iter_mut().enumerate() {
        cable.name = Some(format!("rope {k}"));
    }
    Scene::new(spec).unwrap()
}

#[test]
fn a_payload_that_the_cables_cannot_hold_is_named() {
    let at = Point::new(1.0, 1.0, 1.0);
    let report = |wrench: WrenchSpec| wrench_of_scene_at(&hanging(wrench), &Required::default(), &at).unwrap();
    // 50 N each hold 4 · 50 / √3 N = 115.47 N = 11.77 kg.
    let light = report(WrenchSpec { payload: Some(1.7), ..WrenchSpec::default() });
    assert!(light.feasible && light.balanced);
    let each = 11.7 * 9.81 * 3.0_f64.sqrt() / 4.0;
    assert!(light.tensions.unwrap().iter().all(|tension| (tension - each).abs() < 1e-9));
    assert_eq!(light.limit.load_case.unwrap().to_string(), "with the payload");
    let heavy = report(WrenchSpec { payload: Some(1.8), ..WrenchSpec::default() });
    assert!(!heavy.feasible && !heavy.balanced);
    assert_eq!(heavy.limit.load_case.unwrap().to_string(), "with the payload");
    // A load that lifts 5 kg makes the ropes slack in the other case.
    let loads = vec![[0.0; 6], [0.0, 0.0, 103.0, 0.0, 0.0, 0.0]];
    let lifted = report(WrenchSpec { loads: Some(loads), ..WrenchSpec::default() });
    assert_eq!((lifted.feasible, lifted.limit.load_case.unwrap().to_string().as_str()), (false, "load 2 of 2"));
    let scene = hanging(WrenchSpec { payload: Some(1.8), ..WrenchSpec::default() });
    let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).unwrap();
    let sentence = engine.violations(&at, &at)[0].sentence();
    assert!(sentence.ends_with("(with the payload)"), "{sentence}");
}

#[test]
fn one_load_in_a_list_is_that_load() {
    let alone = under(&built_scene("cogiro"), |wrench| wrench.load = Some(UP));
    let listed = under(&built_scene("cogiro"), |wrench| wrench.loads = Some(vec![UP]));
    assert_eq!(Loads::cases(&alone), Loads::cases(&listed));
    let [a, b] = [&alone, &listed].map(|scene| plan(scene, &PlanOptions::default(), &()).unwrap().result);
    assert_eq!((a.waypoints(), a.status), (b.waypoints(), b.status));
}

#[test]
fn paths_and_motions_hold_in_every_load_case() {
    let base = under(&built_scene("cogiro"), |wrench| {
        *wrench = WrenchSpec { force: Some(20.0), moment: Some(5.0), ..WrenchSpec::default() };
    });
    let all = under(&base, |wrench| wrench.payload = Some(40.0));
    let [empty, loaded] = [base.clone(), heavier(&base, 40.0)];
    let planned = plan(&all, &PlanOptions::default(), &()).unwrap().result;
    assert_eq!(planned.status, Status::Solved);
    let least = |scene: &Scene| {
        let report = check(&compiled(scene), &planned.path, &Watch::NONE).unwrap();
        assert!(report.path.valid);
        report.wrench.unwrap()
    };
    let [whole, light, heavy] = [&all, &empty, &loaded].map(least);
    let margins = [&whole, &light, &heavy].map(|wrench| wrench.min_wrench_margin.value.unwrap());
    assert!((margins[0] - margins[1].min(margins[2])).abs() < 1e-3, "{margins:?}");
    let ranges = [&whole, &light, &heavy].map(|wrench| wrench.tension_range.as_ref().unwrap());
    assert_eq!(ranges[0].max.value, ranges[1].max.value.max(ranges[2].max.value));
    assert_eq!(ranges[0].min.value, ranges[1].min.value.min(ranges[2].min.value));

    let limits = MotionSpec { blend: Some(0.05), ..MotionSpec::default() };
    let timed = |scene: &Scene| Trajectory::new(&compiled(scene), &planned.path, &limits, &Watch::NONE).unwrap();
    let faults = |scene: &Scene, motion: &Trajectory, tensions: bool| {
        let file = TrajectoryFile::of(&compiled(scene), &planned.path, motion, 100.0, &Watch::NONE).unwrap();
        let mut recorded = Recorded::of(&file).unwrap();
        recorded.tensions = recorded.tensions.filter(|_| tensions);
        let rules = TrajectoryRules { limits, ..TrajectoryRules::default() };
        check_trajectory(scene, &recorded, &rules, &Watch::NONE).unwrap().faults
    };
    let [both, light, heavy] = [&all, &empty, &loaded].map(timed);
    assert!(both.duration() >= light.duration().max(heavy.duration()) * (1.0 - 1e-9));
    for scene in [&all, &empty, &loaded] {
        assert_eq!(faults(scene, &both, false), []);
    }
    // The tensions of a motion are those without the payload.
    assert_eq!([&all, &empty].map(|scene| faults(scene, &both, true)), [[], []]);
    // With tensions of the platform alone, a motion that is too fast for the payload is found out nevertheless.
    let found = faults(&all, &light, true);
    assert!(found.iter().any(|fault| fault.kind == FaultKind::NoTensions), "{found:?}");
    assert!(found[0].message.ends_with("(with the payload)"), "{}", found[0].message);
}

#[test]
fn unsound_loads_are_refused() {
    let refusal = |change: &dyn Fn(&mut WrenchSpec)| {
        let mut spec = built_scene("cogiro").spec().clone();
        change(spec.wrench.get_or_insert_default());
        Scene::new(spec).unwrap_err().to_string()
    };
    let both = refusal(&|wrench| (wrench.load, wrench.loads) = (Some(UP), Some(vec![LEFT])));
    assert!(both.contains("wrench.loads: found together with load"), "{both}");
    assert!(refusal(&|wrench| wrench.loads = Some(Vec::new())).contains("found 0, expected 1 to 16 loads"));
    assert!(refusal(&|wrench| wrench.loads = Some(vec![UP; 17])).contains("found 17, expected 1 to 16 loads"));
    let number = refusal(&|wrench| wrench.loads = Some(vec![UP, [f64::NAN; 6]]));
    assert!(number.contains("wrench.loads[1]"), "{number}");
    for payload in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = refusal(&|wrench| wrench.payload = Some(payload));
        assert!(refused.contains("wrench.payload"), "{refused}");
    }
    let (all, _) = cogiro(|_| {});
    assert_eq!(measures(&all).unwrap().len(), 4);
    assert!(all.notes().iter().any(|note| note.contains("for the first of `loads` without the payload")));
}
