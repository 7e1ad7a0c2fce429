//! The known answers of `testdata/cases`, checked by the library. Python and the command line run the same list.

use cdpr_core::Choice;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::Point;
use cdpr_core::model::{MarginSpec, Scene};
use cdpr_core::path::check;
use cdpr_core::path::held;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{PlannerOptions, PlannerSettings};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::constraint::required_of;
use cdpr_core::wrench::{Loads, Statics, wrench_at};
use cdpr_files::load_scene;
use cdpr_tests::cases::{Cases, PlanCase, scene_file};
use serde_json::{Value, json};

#[test]
fn motions() {
    for (case, engine) in each_engine(&Cases::load().motion) {
        let engine = engine_for(&scene(&case.scene), engine, choice(&case.interference)).unwrap();
        let (from, to) = (Point::from(case.from), Point::from(case.to));
        let found = engine.explain(&from, &to);
        let valid = case.violation.is_none();
        assert_eq!(engine.motion_valid(&from, &to), valid, "{}", case.name);
        assert_eq!(engine.motion_valid(&to, &from), valid, "{}, backward", case.name);
        assert!(case.agrees(&json!(found)), "{}: {found:#?}", case.name);
    }
}

#[test]
fn plans() {
    for case in Cases::load().plan {
        let found = planned(&case);
        assert!(case.agrees(&found), "{}: {found:#}", case.name);
    }
}

fn planned(case: &PlanCase) -> Value {
    let scene = scene(&case.scene);
    let mut options = PlanOptions { seed: case.seed, ..PlanOptions::default() };
    let settings = PlannerSettings { max_samples: case.max_samples, ..PlannerSettings::default() };
    options.planner = PlannerOptions::new(choice(&case.planner), options.step, &settings).unwrap();
    let query = Query { start: case.start.map(Point::from), goal: case.goal.map(Point::from), ..Query::of(&scene) };
    let found = plan(query, &options, &()).unwrap().result;
    json!({ "status": found.status, "cost": found.cost, "reason": found.reason() })
}

#[test]
fn checks() {
    for (case, engine) in each_engine(&Cases::load().check) {
        let scene = scene(&case.scene);
        let compiled = CompiledScene::new(&scene, engine, Interference::default(), &Watch::NONE).unwrap();
        let waypoints: Vec<Point> = case.waypoints.iter().map(|w| Point::from(*w)).collect();
        let found = json!(check(&compiled, &held(&scene, &waypoints), &Watch::NONE).unwrap());
        assert!(case.agrees(&found), "{}: {found:#}", case.name);
    }
}

#[test]
fn wrenches() {
    for case in Cases::load().wrench {
        let scene = scene(&case.scene);
        let statics = Statics::new(scene.robot(), &Loads::of(&scene)).unwrap();
        let required = required_of(&scene, case.force, None).unwrap();
        let found = json!(wrench_at(&statics, &required, MarginSpec::Capacity, &case.position.into()).unwrap());
        assert!(case.agrees(&found), "{}: {found:#}", case.name);
    }
}

fn scene(name: &str) -> Scene {
    load_scene(scene_file(name)).unwrap()
}

/// The value with this name, or the default.
fn choice<T: Choice + Default>(name: &Option<String>) -> T {
    name.as_ref().map_or_else(T::default, |name| T::named(name).unwrap())
}

fn each_engine<T>(cases: &[T]) -> impl Iterator<Item = (&T, Engine)> {
    cases.iter().flat_map(|case| Engine::ALL.iter().map(move |(engine, ..)| (case, *engine)))
}
