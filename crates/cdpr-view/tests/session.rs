//! Requests of the page against the functions that they stand for.

use std::path::PathBuf;

use cdpr_core::model::RobotSource;
use cdpr_core::plan::{PlanOptions, plan, replan};
use cdpr_core::testing::{hard1, hard3, scene, walled};
use cdpr_core::workspace::{WorkspaceOptions, workspace};
use cdpr_core::{CompiledScene, Scene, Watch};
use cdpr_view::live::Session;
use serde_json::{Value, json};

fn asked(session: &mut Session, request: &Value) -> Value {
    serde_json::from_str(&session.answer(&request.to_string(), &|_| ())).unwrap()
}

fn planned(session: &mut Session, scene: &Value, options: &Value) -> Value {
    asked(session, &json!({ "ask": "plan", "scene": scene, "options": options }))
}

fn of_testdata(name: &str) -> Scene {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../testdata/scenes");
    cdpr_files::load_scene(folder.join(format!("{name}.toml"))).unwrap()
}

#[test]
fn paths_are_those_of_the_program() {
    let mut session = Session::default();
    // Each scene is compiled from the one before as far as they agree.
    for name in ["hard1", "hard3", "hard3_rank6", "hard3", "concave", "plank", "empty", "cogiro", "hard1"] {
        let scene = of_testdata(name);
        let answer = planned(&mut session, &json!(scene.spec()), &json!({ "seed": 3 }));
        let found = plan(&scene, &PlanOptions { seed: 3, ..PlanOptions::default() }, &()).unwrap().result;
        assert_eq!((&answer["cost"], &answer["status"]), (&json!(found.cost), &json!("solved")), "{name}");
        let waypoints: Vec<[f64; 3]> = found.waypoints().iter().map(|p| (*p).into()).collect();
        assert_eq!(answer["waypoints"], json!(waypoints), "{name}");
        assert_eq!(answer["path"]["cost"], answer["cost"], "{name}");
    }
}

/// The page plans anew with the options that its path was written with, defaults written out.
#[test]
fn the_options_of_a_path_give_the_same_path_again() {
    for name in ["hard1", "turn"] {
        let scene = json!(of_testdata(name).spec());
        let first = planned(&mut Session::default(), &scene, &json!({ "seed": 3 }));
        assert_eq!(first["status"], "solved", "{name}");
        let path = &first["path"];
        let options = json!({ "seed": 3, "planner": path["planner"], "post": path["options"]["post"] });
        let again = planned(&mut Session::default(), &scene, &options);
        assert_eq!((&again["cost"], &again["waypoints"]), (&first["cost"], &first["waypoints"]), "{name}");
    }
}

#[test]
fn moved_ends_and_obstacles_change_the_answer() {
    let mut session = Session::default();
    let mut spec = json!(hard1().spec());
    let direct = planned(&mut session, &spec, &json!({}))["cost"].as_f64().unwrap();
    spec["query"]["goal"] = json!([0.3, 1.0, 1.0]);
    assert!((planned(&mut session, &spec, &json!({}))["cost"].as_f64().unwrap() - 0.7).abs() < 1e-9);
    spec["query"]["goal"] = json!(hard1().spec().query.as_ref().unwrap().goal);
    spec["obstacles"][0]["position"] = json!([1.0, 1.0, 0.3]);
    assert!(planned(&mut session, &spec, &json!({}))["cost"].as_f64().unwrap() < direct);
    let fresh = planned(&mut Session::default(), &spec, &json!({}));
    assert_eq!(planned(&mut session, &spec, &json!({}))["waypoints"], fresh["waypoints"]);
}

#[test]
fn a_path_is_kept_as_far_as_it_is_valid_while_an_obstacle_moves() {
    let scene = hard3();
    let mut session = Session::default();
    let ask = |session: &mut Session, scene: &Scene, path: &Value| {
        asked(session, &json!({ "ask": "plan", "scene": scene.spec(), "path": path, "page": true }))
    };
    let first = ask(&mut session, &scene, &Value::Null);
    let place = scene.place_of("west").unwrap();
    let moved = scene.moved("west", [place.x - 0.1, place.y, place.z].into()).unwrap();
    let answer = ask(&mut session, &moved, &first["page"]["path"]);
    let file: cdpr_core::path_file::PathFile = serde_json::from_value(first["path"].clone()).unwrap();
    let known = file.path(&scene).unwrap();
    let repaired = replan(&moved, &known, &PlanOptions::default(), &()).unwrap().result;
    let waypoints: Vec<[f64; 3]> = repaired.waypoints().iter().map(|p| (*p).into()).collect();
    assert_eq!((&answer["path"]["found_by"], &answer["waypoints"]), (&json!("repaired"), &json!(waypoints)));
    assert_eq!(ask(&mut session, &scene, &first["page"]["path"])["path"]["found_by"], "kept");
    // A path between other ends says nothing about this one.
    let goal = scene.goal().map(Into::into);
    let elsewhere = scene.between([Some(known[1].position.into()), goal]).unwrap();
    assert_eq!(ask(&mut session, &elsewhere, &first["page"]["path"])["path"]["found_by"], Value::Null);
}

#[test]
fn a_turning_path_is_kept_as_far_as_it_is_valid() {
    let scene = json!(of_testdata("turn").spec());
    let mut session = Session::default();
    let first = asked(&mut session, &json!({ "ask": "plan", "scene": scene, "page": true }));
    let again = asked(&mut session, &json!({ "ask": "plan", "scene": scene, "path": first["page"]["path"] }));
    assert_eq!(again["path"]["found_by"], "kept");
}

#[test]
fn better_paths_are_told_while_planning() {
    static TOLD: std::sync::Mutex<Vec<String>> = std::sync::Mutex::new(Vec::new());
    let request = json!({ "ask": "plan", "scene": hard3().spec(), "options": { "planner": "anytime" } });
    let answer = Session::default().answer(&request.to_string(), &|text| TOLD.lock().unwrap().push(text.to_string()));
    let answer: Value = serde_json::from_str(&answer).unwrap();
    let told: Vec<Value> = TOLD.lock().unwrap().iter().map(|text| serde_json::from_str(text).unwrap()).collect();
    assert!(told.windows(2).all(|pair| pair[0]["cost"].as_f64() > pair[1]["cost"].as_f64()));
    assert_eq!(told.last().unwrap()["cost"], answer["cost"]);
}

#[test]
fn an_invalid_position_says_why_and_where_a_valid_one_is() {
    let mut session = Session::default();
    let place = |at: [f64; 3]| json!({ "ask": "place", "scene": hard1().spec(), "at": at });
    let free = asked(&mut session, &place([0.3, 1.0, 0.3]));
    assert_eq!(free, json!({ "nearest": null, "violation": null, "violations": [] }));
    let inside = asked(&mut session, &place([0.8, 1.0, 0.3]));
    assert_eq!(inside["violation"], inside["violations"][0]); // the worst
    assert!(
        inside["violations"].as_array().unwrap().iter().any(|one| one["culprits"] == json!(["platform", "pillar"]))
    );
    let nearest: [f64; 3] = serde_json::from_value(inside["nearest"].clone()).unwrap();
    assert_eq!(asked(&mut session, &place(nearest))["violation"], Value::Null);
}

#[test]
fn a_platform_that_turns_is_placed_at_its_own_orientation() {
    let scene = of_testdata("turn");
    let [_, at_goal] = scene.end_orientations().map(|turn| cdpr_core::geometry::wxyz(&turn));
    let goal: [f64; 3] = scene.goal().unwrap().into();
    let place = json!({ "ask": "place", "scene": scene.spec(), "at": goal, "orientation": at_goal });
    let mut session = Session::default();
    assert_eq!(asked(&mut session, &place)["violation"], Value::Null);
    let level = json!({ "ask": "place", "scene": scene.spec(), "at": goal });
    assert_ne!(asked(&mut session, &level)["violation"], Value::Null);
}

/// Bounds of the volume of all valid positions, m³.
fn volume(session: &mut Session, scene: &Scene, budget_ms: f64) -> [f64; 2] {
    let answer = asked(session, &json!({ "ask": "workspace", "scene": scene.spec(), "budget_ms": budget_ms }));
    let volume = &answer["proved"]["volume"];
    ["min", "max"].map(|end| volume[end].as_f64().unwrap_or_else(|| panic!("{answer}")))
}

#[test]
fn the_workspace_is_proved_while_an_outlet_moves() {
    let at = |scene: &Scene| {
        let compiled = CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).unwrap();
        let options = WorkspaceOptions { resolution: Some(0.02), ..WorkspaceOptions::default() };
        let found = workspace(&[&compiled], &options, &Default::default()).unwrap();
        [found.volume.min, found.volume.max]
    };
    let mut session = Session::default();
    let before = hard1();
    let mut spec = before.spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { panic!("the robot is inline") };
    robot.cables[0].outlet[0] += 0.3;
    let after = scene(spec);
    let [[least, _], [_, most]] = [at(&before), at(&after)];
    assert!(most < least, "{most} {least}"); // further in, there is less room
    // Each is compiled from the one before.
    for scene in [&before, &after, &before] {
        let [[min, max], exact] = [volume(&mut session, scene, 500.0), at(scene)];
        assert!(min <= exact[1] && exact[0] <= max && max - min < 0.2 * max, "{min} {max} {exact:?}");
    }
}

#[test]
fn the_workspace_of_a_scene_that_selects_no_orientation_is_that_of_all() {
    let plank = of_testdata("plank");
    assert!(plank.orientation_is_open());
    let [along, across] = [0, 1].map(|k| volume(&mut Session::default(), &plank.choices()[k], 500.0));
    let [_, most] = volume(&mut Session::default(), &plank, 500.0);
    assert!(most >= along[0].max(across[0]));
    let mut flat = plank.spec().clone();
    flat.workspace.max[2] = flat.workspace.min[2] + 0.05;
    let error = asked(&mut Session::default(), &json!({ "ask": "workspace", "scene": flat, "budget_ms": 100.0 }));
    assert!(error["error"]["key"] == "workspace", "{error}");
    let late = json!({ "ask": "workspace", "scene": plank.spec(), "budget_ms": 0.0 });
    assert_eq!(asked(&mut Session::default(), &late)["error"]["key"], "budget_ms");
}

#[test]
fn no_path_is_proved_and_shown() {
    let mut session = Session::default();
    let request = json!({ "ask": "plan", "scene": scene(walled(0.94)).spec(), "page": true });
    let answer = asked(&mut session, &request);
    assert_eq!((&answer["status"], &answer["cost"]), (&json!("no_path"), &Value::Null));
    assert!(answer["page"]["no_path"].is_object());
}

#[test]
fn the_page_of_a_path_is_that_of_the_program() {
    let scene = hard1();
    let answer =
        asked(&mut Session::default(), &json!({ "ask": "plan", "scene": scene.spec(), "page": true, "extras": true }));
    let path: cdpr_core::path_file::PathFile = serde_json::from_value(answer["path"].clone()).unwrap();
    let page = cdpr_view::page_data(&scene, (&path).into(), true, &cdpr_core::watch::Watch::NONE).unwrap();
    for key in ["motion", "regions", "obstacles", "cables", "workspace", "start", "goal"] {
        assert_eq!(answer["page"][key], page[key], "{key}");
    }
    let quick = asked(&mut Session::default(), &json!({ "ask": "plan", "scene": scene.spec(), "page": true }));
    assert!(quick["page"]["motion"].is_object() && quick["page"].get("regions").is_none());
}

#[test]
fn a_saved_scene_is_read_again() {
    for name in ["hard1", "cogiro", "turn", "concave"] {
        let scene = of_testdata(name);
        let answer = asked(&mut Session::default(), &json!({ "ask": "toml", "scene": scene.spec() }));
        let text = answer["toml"].as_str().unwrap();
        let read = cdpr_files::scene_from_text(text, cdpr_files::text::Notation::Toml, None).unwrap();
        assert_eq!(read.fingerprint(), scene.fingerprint(), "{name}");
    }
}

#[test]
fn bad_requests_name_what_is_wrong() {
    let mut session = Session::default();
    let mut spec = json!(hard1().spec());
    spec["workspace"]["max"][0] = json!(-1.0);
    let error = &planned(&mut session, &spec, &json!({}))["error"];
    assert!(error["key"].as_str().unwrap().starts_with("workspace"), "{error}");
    for (options, word) in [(json!({ "planner": "prm" }), "prm"), (json!({ "budget_ms": -1.0 }), "budget_ms")] {
        let error = planned(&mut session, &json!(hard1().spec()), &options)["error"]["message"].to_string();
        assert!(error.contains(word), "{error}");
    }
    for request in ["", "{}", "null", "{\"ask\":\"plan\"}"] {
        assert!(session.answer(request, &|_| ()).contains("error"), "{request}");
    }
}
