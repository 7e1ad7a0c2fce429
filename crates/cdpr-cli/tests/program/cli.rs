//! The command line from outside: outputs, exit statuses, files.

use std::fs;

use crate::support::*;
use serde_json::Value;

#[test]
fn plan_writes_a_path_that_check_accepts_and_a_page() {
    let folder = folder();
    let hard1 = testdata("scenes/hard1.toml");
    let planned = cdpr_in(folder.path(), &["plan", &hard1, "-o", "path.json", "--html", "view.html"]);
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    for word in ["hard1", "8 cables, 1 obstacle", "solved", "in a straight line", "nearest approach"] {
        assert!(stdout(&planned).contains(word), "no \"{word}\" in {}", stdout(&planned));
    }
    assert!(stderr(&planned).contains("wrote path.json") && stderr(&planned).contains("next: cdpr check"));
    let file: Value = serde_json::from_str(&fs::read_to_string(folder.path().join("path.json")).unwrap()).unwrap();
    assert_eq!((&file["version"], &file["status"], &file["planner"]), (&1.into(), &"solved".into(), &"anytime".into()));
    for key in
        ["cost", "waypoints", "min_clearance", "raw_cost", "raw_waypoints", "engine", "interference", "seed", "options"]
    {
        assert!(!file[key].is_null(), "no {key}");
    }
    for key in ["nodes", "motion_checks", "planning_seconds", "post_seconds"] {
        assert!(file["stats"][key].is_number(), "no stats.{key}");
    }
    let page = fs::read_to_string(folder.path().join("view.html")).unwrap();
    assert!(page.starts_with("<!doctype html>") && page.contains("\"waypoints\"") && page.contains("\"tree\":{"));
    let checked = cdpr_in(folder.path(), &["check", &hard1, "path.json", "--format", "json"]);
    assert_eq!((status(&checked), &json(&checked)["valid"]), (0, &true.into()));
    assert!(json(&checked)["min_clearance"]["value"].as_f64().unwrap() > 0.0);
    let swept = cdpr_in(folder.path(), &["check", &hard1, "path.json", "--interference", "swept", "--engine", "gjk"]);
    assert!([0, 1].contains(&status(&swept)));
}

#[test]
fn json_results_are_the_same_for_the_same_seed() {
    let run = || {
        let mut result = json(&cdpr(&["plan", &testdata("scenes/hard3.toml"), "--seed", "4", "--format", "json"]));
        result["stats"] = Value::Null;
        for better in result["history"].as_array_mut().unwrap() {
            better["seconds"] = Value::Null;
        }
        result
    };
    assert_eq!(run(), run());
}

#[test]
fn an_invalid_start_or_goal_is_the_answer_no_and_still_written() {
    let folder = folder();
    let hard1 = testdata("scenes/hard1.toml");
    for (option, expected) in [("--start", "start_invalid"), ("--goal", "goal_invalid")] {
        for place in [["1", "1", "0.5"], ["-5", "1", "0.5"]] {
            let [x, y, z] = place;
            let output =
                cdpr_in(folder.path(), &["plan", &hard1, option, x, y, z, "-o", "no.json", "--format", "json"]);
            assert_eq!(status(&output), 1, "{}", stderr(&output));
            let file: Value =
                serde_json::from_str(&fs::read_to_string(folder.path().join("no.json")).unwrap()).unwrap();
            assert_eq!(
                (&file["status"], &file["cost"], &file["waypoints"]),
                (&expected.into(), &Value::Null, &Value::Array(vec![]))
            );
            assert!(file["reason"]["kind"].is_string());
            assert_eq!(json(&output), file);
        }
    }
    let empty = cdpr_in(folder.path(), &["check", &hard1, "no.json"]);
    assert_eq!(status(&empty), 2);
    assert!(stderr(&empty).contains("goal_invalid"), "{}", stderr(&empty));
}

#[test]
fn bad_input_exits_2_names_file_and_key_and_writes_nothing() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    let hard1 = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    fs::write(at("typo.toml"), hard1.replace("outlet = [2.0, 0.0, 0.0]", "outlett = [2.0, 0.0, 0.0]")).unwrap();
    fs::write(at("nan.toml"), hard1.replace("outlet = [2.0, 0.0, 0.0]", "outlet = [nan, 0.0, 0.0]")).unwrap();
    fs::write(at("wrench.toml"), format!("{hard1}\n[wrench]\nforce = -1.0\n")).unwrap();
    fs::write(at("hard1.toml"), &hard1).unwrap();
    fs::write(at("other.json"), stdout(&cdpr(&["plan", &testdata("scenes/empty.toml"), "--format", "json"]))).unwrap();
    for (arguments, words) in [
        (vec!["plan", "nowhere.toml", "-o", "out.json"], vec!["nowhere.toml", "cannot be read"]),
        (
            vec!["plan", "typo.toml", "-o", "out.json"],
            vec!["typo.toml", "robot.cables[1]", "outlett", "did you mean `outlet`"],
        ),
        (vec!["plan", "nan.toml", "-o", "out.json"], vec!["nan.toml", "robot.cables[1].outlet", "NaN"]),
        (vec!["plan", "wrench.toml", "-o", "out.json"], vec!["wrench.toml", "wrench.force", "found -1"]),
        (vec!["plan", "hard1.toml", "-o", "out.yaml"], vec!["out.yaml", ".json or .csv"]),
        (vec!["plan", "hard1.toml", "--html", "out.pdf"], vec!["out.pdf", ".html"]),
        (vec!["plan", "hard1.toml", "--step", "-0.1", "-o", "out.json"], vec!["--step", "-0.1", "positive"]),
        (vec!["plan", "hard1.toml", "--step", "nan", "-o", "out.json"], vec!["--step", "positive"]),
        (vec!["plan", "hard1.toml", "--start", "nan", "0", "0", "-o", "out.json"], vec!["start", "NaN"]),
        (vec!["plan", "hard1.toml", "--planner", "magic", "-o", "out.json"], vec!["magic", "modified-rrt"]),
        (vec!["plan", "hard1.toml", "-o", "nofolder/out.json"], vec!["nofolder", "cannot be written"]),
        (vec!["post", "hard1.toml", "other.json", "--strict", "-o", "out.json"], vec!["other.json", "another scene"]),
        (vec!["view", "hard1.toml", "other.json", "--strict", "-o", "out.html"], vec!["other.json", "another scene"]),
    ] {
        let output = cdpr_in(folder.path(), &arguments);
        assert_eq!(status(&output), 2, "{arguments:?}: {}", stderr(&output));
        for word in words {
            assert!(stderr(&output).contains(word), "{arguments:?}: no \"{word}\" in {}", stderr(&output));
        }
        assert!(stdout(&output).is_empty() || arguments[0] == "plan", "{arguments:?}: {}", stdout(&output));
    }
    let left: Vec<String> =
        fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    assert!(!left.iter().any(|name| name.starts_with("out") || name.starts_with('.')), "{left:?}");
}

#[test]
fn touch_for_the_platform_suggests_touch_for_its_cables() {
    let folder = folder();
    let planned = |touch: &str| {
        let robot = testdata("robots/cogiro.toml");
        let scene = format!(
            "version = 1\nrobot = {robot:?}\nclearance = 0.05\ntouch = [{touch}]\n\
             [workspace]\nmin = [-7, -5, 0]\nmax = [7, 5, 6]\n\
             [[obstacles]]\nname = \"conveyor\"\nbox = [2.0, 1.5, 0.8]\nposition = [-3.0, 1.5, 0.4]\n\
             [query]\nstart = [-3.0, 1.5, 0.801]\ngoal = [4.0, 0.5, 1.0]\n"
        );
        fs::write(folder.path().join("hall.toml"), scene).unwrap();
        cdpr_in(folder.path(), &["plan", "hall.toml"])
    };
    let platform = "[\"platform\", \"conveyor\"]";
    let refused = stderr(&planned(platform));
    let pairs: Vec<String> = [0, 2, 4, 6].map(|k| format!("[\"cable {k}\", \"conveyor\"]")).into();
    let hint = format!(
        "next: only the platform may touch conveyor; to let cable 0, cable 2, cable 4, cable 6 do so as well, add {} to `touch`",
        pairs.join(", ")
    );
    assert!(refused.contains(&hint), "{refused}");
    assert_eq!(status(&planned(&format!("{platform}, {}", pairs.join(", ")))), 0);
    let refused = stderr(&planned(""));
    assert!(refused.contains("next: choose another position") && !refused.contains("to `touch`"), "{refused}");
}

#[test]
fn exempt_pairs_are_printed_with_the_answer() {
    let folder = folder();
    let hard1 = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    fs::write(folder.path().join("near.toml"), format!("{hard1}\n[clearances]\ncable_cable = 0.06\n")).unwrap();
    let touch = "version = 1\ntouch = [[\"platform\", \"pillar\"]]\nignore = [[\"cable 0\", \"pillar\"]]\n";
    fs::write(folder.path().join("touch.toml"), hard1.replace("version = 1\n", touch)).unwrap();
    let exempt = |output: &std::process::Output| {
        let text = stdout(output);
        text.lines().filter(|line| line.starts_with("exempt: ")).map(str::to_string).collect::<Vec<_>>()
    };
    let planned = cdpr_in(folder.path(), &["plan", "near.toml", "-o", "path.json"]);
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    let checked = cdpr_in(folder.path(), &["check", "near.toml", "path.json"]);
    for output in [&planned, &checked] {
        let told = exempt(output);
        assert!(
            told[0].starts_with(
                "exempt: cable 0 and cable 4 can be 50.000 mm apart at most, 60.000 mm are demanded; they must still not \
                 touch (here "
            ),
            "{told:?}"
        );
        assert!(!stderr(output).contains("apart at most"), "{}", stderr(output));
    }
    let file: Value = serde_json::from_str(&fs::read_to_string(folder.path().join("path.json")).unwrap()).unwrap();
    let report = json(&cdpr_in(folder.path(), &["check", "near.toml", "path.json", "--format", "json"]));
    assert_eq!((&file["exempt"], &file["min_clearance"]), (&report["exempt"], &report["min_clearance"]));
    let first = &report["exempt"][0];
    assert_eq!((&first["pair"][0], &first["reason"]), (&"cable 0".into(), &"unattainable".into()));
    assert!(
        first["gap"].as_f64() < first["attainable"].as_f64()
            && first["attainable"].as_f64() < first["demanded"].as_f64()
    );
    // Commands whose output has no place for the list print it as notes.
    let shorter = cdpr_in(folder.path(), &["post", "near.toml", "path.json"]);
    assert!(stderr(&shorter).contains("note: cable 0 and cable 4 can be"), "{}", stderr(&shorter));
    let info = exempt(&cdpr_in(folder.path(), &["info", "touch.toml"]));
    assert_eq!(info, ["exempt: platform and pillar may touch, but not enter each other"]);
    let unchecked = stdout(&cdpr_in(folder.path(), &["info", "touch.toml"]));
    assert!(unchecked.contains("\nnot checked against each other: cable 0 and pillar\n"), "{unchecked}");
}

#[test]
fn a_path_for_another_scene_gives_a_warning() {
    let folder = folder();
    let hard1 = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("hall.toml"), &hard1).unwrap();
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", "hall.toml", "-o", "path.json"])), 0);
    // The pillar moves into the path, or gets smaller.
    let (place, size) = ("position = [1.0, 1.0, 0.75]", "box = [0.3, 0.3, 1.5]");
    for (old, new, valid) in [(place, "position = [0.3, 1.0, 1.85]", false), (size, "box = [0.2, 0.2, 1.4]", true)] {
        fs::write(at("hall.toml"), hard1.replace(old, new)).unwrap();
        let checked = cdpr_in(folder.path(), &["check", "hall.toml", "path.json", "--format", "json"]);
        assert_eq!((status(&checked), json(&checked)["valid"].clone()), (i32::from(!valid), valid.into()));
        for arguments in [
            vec!["check", "hall.toml", "path.json"],
            vec!["check", "hall.toml", "path.json", "--quiet"],
            vec!["view", "hall.toml", "path.json", "-o", "view.html"],
            vec!["post", "hall.toml", "path.json", "-o", "shorter.json"],
            vec!["wrench", "hall.toml", "--along", "path.json"],
        ] {
            let answer = cdpr_in(folder.path(), &arguments);
            let said = stderr(&answer);
            assert!(
                said.contains("warning: the path was planned for another scene: \"hard1\""),
                "{arguments:?}: {said}"
            );
            let strict = cdpr_in(folder.path(), &[&arguments[..], &["--strict"]].concat());
            assert_eq!(status(&strict), 2, "{arguments:?}: {}", stderr(&strict));
            assert!(stderr(&strict).contains("path.json: scene: found a path planned for another scene"));
        }
    }
    assert!(at("view.html").exists() && at("shorter.json").exists());
    // A result written anew belongs to the edited scene.
    let again = cdpr_in(folder.path(), &["check", "hall.toml", "shorter.json", "--strict"]);
    assert_eq!((status(&again), stderr(&again)), (0, String::new()));
}

/// hard1 with a wall across the workspace that only cables may pass: no path exists.
#[cfg(unix)]
fn walled() -> String {
    let scene = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    let ignore: Vec<String> = (0..8).map(|k| format!("[\"cable {k}\", \"pillar\"]")).collect();
    scene
        .replace("version = 1\n", &format!("version = 1\nignore = [{}]\n", ignore.join(", ")))
        .replace("box = [0.3, 0.3, 1.5]", "box = [0.05, 2.0, 2.0]")
        .replace("0.75]", "1.0]")
}

#[cfg(unix)]
#[test]
fn ctrl_c_exits_130_and_writes_nothing() {
    let folder = folder();
    fs::write(folder.path().join("walled.toml"), walled()).unwrap();
    let program = assert_cmd::cargo::cargo_bin("cdpr");
    let mut child = std::process::Command::new(program)
        .current_dir(folder.path())
        .args(["plan", "walled.toml", "--no-proof", "--max-samples", "1000000000", "-o", "out.json"])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(300));
    let sent = std::time::Instant::now();
    let signal = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(signal.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(sent.elapsed().as_secs() < 2); // far above the tenth of a second meant: the machine may be busy
    assert!(!folder.path().join("out.json").exists());
}

#[test]
fn post_shortens_a_csv_path() {
    let folder = folder();
    fs::write(folder.path().join("long.csv"), "x,y,z\n0.3,1,0.3\n0.5,0.4,1.0\n1.0,1.0,1.8\n1.7,1,1.7\n").unwrap();
    let scene = testdata("scenes/empty.toml");
    let output = cdpr_in(folder.path(), &["post", &scene, "long.csv", "-o", "short.csv", "--format", "json"]);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    assert!((json(&output)["cost"].as_f64().unwrap() - 1.4 * 2f64.sqrt()).abs() < 1e-9);
    let written = fs::read_to_string(folder.path().join("short.csv")).unwrap();
    assert_eq!(written, "x,y,z\n0.3,1,0.3\n1.7,1,1.7\n");
}

#[test]
fn info_lists_special_pairs_of_cables() {
    let crossing = json(&cdpr(&["info", &testdata("cases/always_crossing.toml"), "--format", "json"]));
    assert_eq!(crossing["always_crossing_pairs"], serde_json::json!([["cable 0", "cable 1"]]));
    let shared = json(&cdpr(&["info", &testdata("cases/shared_ends.toml"), "--format", "json"]));
    assert_eq!(shared["sharing_pairs"], serde_json::json!([["cable 0", "cable 1"], ["cable 1", "cable 2"]]));
    let column = cdpr(&["info", &testdata("cases/outlet_on_column.toml")]);
    assert!(stdout(&column).contains("outlets on obstacles: cable 0 and column"), "{}", stdout(&column));
}

#[test]
fn a_page_shows_violations_and_schemas_are_json() {
    let folder = folder();
    let hard1 = testdata("scenes/hard1.toml");
    fs::write(folder.path().join("bad.csv"), "x,y,z\n0.3,1,0.3\n1.7,1,1.7\n").unwrap();
    let viewed = cdpr_in(folder.path(), &["view", &hard1, "bad.csv", "-o", "bad.html"]);
    assert_eq!(status(&viewed), 0, "{}", stderr(&viewed));
    assert!(fs::read_to_string(folder.path().join("bad.html")).unwrap().contains("\"platform-obstacle\""));
    for of in ["scene", "robot", "path"] {
        let schema = json(&cdpr(&["schema", of]));
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    }
    assert!(json(&cdpr(&["schema"]))["properties"]["workspace"].is_object());
}

#[test]
fn wrench_tells_margins_at_a_position_and_tensions_along_a_path() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let hall = format!(
        "version = 1\nrobot = \"{}\"\nworkspace = {{ min = [-7, -5, 0], max = [7, 5, 5.3] }}\n\
         wrench = {{ force = 60, moment = 10 }}\nquery = {{ start = [-4, 0, 0.5], goal = [4, 0, 0.5] }}\n",
        testdata("robots/cogiro.toml")
    );
    fs::write(at("hall.toml"), hall).unwrap();
    fs::write(at("path.csv"), "x,y,z\n-4,0,0.5\n-6.4,0,0.5\n").unwrap();
    let found = cdpr(&["wrench", &at("hall.toml"), "--at", "-4", "0", "0.5", "--format", "json"]);
    let report = json(&found);
    assert_eq!((found.status.code(), &report["feasible"], &report["rank"]), (Some(0), &true.into(), &6.into()));
    assert_eq!(report["wrench_matrix"].as_array().unwrap().len(), 6);
    assert_eq!(report["tensions"].as_array().unwrap().len(), 8);
    let wall = cdpr(&["wrench", &at("hall.toml"), "--at", "-6.4", "0", "0.5"]);
    assert_eq!(wall.status.code(), Some(1));
    assert!(stdout(&wall).contains("not feasible at (-6.4, 0, 0.5): capacity margin -"), "{}", stdout(&wall));
    let arguments = ["wrench", &at("hall.toml"), "--along", &at("path.csv"), "--step", "0.5", "-o", &at("t.csv")];
    assert_eq!(cdpr(&arguments).status.code(), Some(1)); // the loads cannot be balanced near the wall
    let csv = fs::read_to_string(at("t.csv")).unwrap();
    assert!(csv.starts_with("s,x,y,z,length:cable 0,") && csv.lines().count() == 7, "{csv}");
    assert!(csv.lines().last().unwrap().starts_with("2.4000000000000004,-6.4,0,0.5,"), "{csv}");
    for name in ["map.npz", "map.vti"] {
        let arguments = ["wrench", &at("hall.toml"), "--grid", "0.5", "-o", &at(name), "--format", "json"];
        let map = json(&cdpr(&arguments));
        assert_eq!(map["counts"], serde_json::json!([26, 19, 9]));
        assert!(map["volume"].as_f64().unwrap() > 100.0 && fs::metadata(at(name)).unwrap().len() > 10_000);
    }
    let check = cdpr(&["check", &at("hall.toml"), &at("path.csv"), "--format", "json"]);
    let check = json(&check);
    assert_eq!(check["violations"][0]["kind"], "wrench");
    assert!(check["min_wrench_margin"]["value"].as_f64().unwrap() < 0.0 && check["tension_range"].is_null());
    let plan = json(&cdpr(&["plan", &at("hall.toml"), "--format", "json"]));
    assert!(plan["min_wrench_margin"]["value"].as_f64().unwrap() > 0.0, "{plan}");
    assert!(plan["tension_range"]["min"]["value"].as_f64().unwrap() >= 100.0);
    for (arguments, words) in [
        (vec!["--along", "nowhere.csv"], "nowhere.csv"),
        (vec!["--grid", "0.5"], "--output"),
        (vec!["--grid", "0.5", "-o", "map.txt"], "map.txt"),
        (vec!["--grid", "1e-6", "-o", "map.npz"], "--grid: found 0.000001 m"),
        (vec!["--at", "0", "0"], "--at"),
    ] {
        let all: Vec<&str> = ["wrench"].into_iter().chain([at("hall.toml").leak() as &str]).chain(arguments).collect();
        let output = cdpr(&all);
        assert_eq!(output.status.code(), Some(2), "{all:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains(words), "{all:?}: {output:?}");
    }
}

#[test]
fn load_cases_apply_from_plan_to_check() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let hall = |wrench: &str| {
        format!(
            "version = 1\nrobot = \"{}\"\nworkspace = {{ min = [-7, -5, 0], max = [7, 5, 5.3] }}\n\
             wrench = {{ force = 60, moment = 10, {wrench} }}\nquery = {{ start = [-3, 0, 0.5], goal = [3, 0, 0.5] }}\n",
            testdata("robots/cogiro.toml")
        )
    };
    fs::write(at("hall.toml"), hall("payload = 60, loads = [[0, 0, 0, 0, 0, 0], [100, 0, 0, 0, 0, 0]]")).unwrap();
    let planned = cdpr(&["plan", &at("hall.toml"), "--trajectory", &at("m.json"), "--format", "json"]);
    assert!(stderr(&planned).contains("those for the first of `loads` without the payload"), "{}", stderr(&planned));
    let least = json(&planned)["min_wrench_margin"]["load_case"].clone();
    assert!(least.as_str().is_some_and(|case| case.starts_with("load ")), "{least}");
    assert_eq!(cdpr(&["check", &at("hall.toml"), &at("m.json")]).status.code(), Some(0));
    // A motion timed for the empty platform is too fast for the loaded one.
    fs::write(at("empty.toml"), hall("")).unwrap();
    assert_eq!(cdpr(&["plan", &at("empty.toml"), "--trajectory", &at("m.json")]).status.code(), Some(0));
    let fast = cdpr(&["check", &at("hall.toml"), &at("m.json")]);
    assert_eq!(fast.status.code(), Some(1));
    let told = "no tensions within the limits balance weight, load and inertia (load";
    assert!(stdout(&fast).contains(told), "{}", stdout(&fast));
    let report = stdout(&cdpr(&["wrench", &at("hall.toml"), "--at", "3", "0", "0.5"]));
    assert!(report.contains("\nleast favourable load case: load 1 of 2 "), "{report}");
    let map = cdpr(&["wrench", &at("hall.toml"), "--grid", "1", "-o", &at("map.npz")]);
    assert_eq!(map.status.code(), Some(2));
    assert!(stderr(&map).contains("wrench: found 4 load cases, expected one: a map is for one"), "{}", stderr(&map));
}

#[test]
fn zero_samples_do_not_blame_the_budget() {
    let hard1 = testdata("scenes/hard1.toml");
    for planner in [&["modified-rrt"][..], &["rrt", "--check-goal"], &["rrt-star"]] {
        let arguments = ["plan", &hard1, "--no-proof", "--max-samples", "0", "--planner"];
        let found = cdpr(&[&arguments[..], planner].concat());
        assert_eq!(status(&found), 1);
        assert!(stdout(&found).contains("no path found after 0 samples"), "{}", stdout(&found));
        assert!(!stdout(&found).contains("budget"), "{}", stdout(&found));
    }
}

#[test]
fn every_planner_plans_with_its_options() {
    let hard1 = testdata("scenes/hard1.toml");
    for (planner, options) in [
        ("rrt", &["--goal-bias", "0.05"][..]),
        ("rrt-star", &["--near-radius", "0.3", "--extend-step", "0.2"]),
        ("rrt-star", &["--near-cap", "4", "--goal-bias", "0.05"]),
        ("modified-rrt", &["--goal-bias", "0.1"]),
        ("modified-rrt", &["--keep-going", "--max-samples", "2000"]),
        ("two-trees", &["--keep-going", "--max-samples", "2000"]),
        ("rrt-connect", &["--extend-step", "0.3", "--keep-going", "--max-samples", "2000"]),
        ("anytime", &["--gap", "0.3", "--target-cost", "2.5"]),
    ] {
        let arguments = ["plan", &hard1, "--planner", planner, "--format", "json"];
        let found = cdpr(&[&arguments[..], options].concat());
        assert_eq!((status(&found), &json(&found)["planner"]), (0, &planner.into()), "{}", stderr(&found));
        for pair in options.chunks_exact(2).filter(|pair| pair[0] != "--keep-going") {
            let key = pair[0].trim_start_matches("--").replace('-', "_");
            assert_eq!(json(&found)["options"][&key], pair[1].parse::<f64>().unwrap(), "{key}");
        }
    }
}

#[test]
fn anytime_uses_its_budget_and_any_path_can_be_pulled_taut() {
    let folder = folder();
    let hard1 = testdata("scenes/hard1.toml");
    let best = 2.435167; // m, the best known path
    // The budget counts from the call: reading and compiling have their share. On a busy machine a single run may be late.
    let budgeted = ["plan", &hard1, "--planner", "anytime", "--budget-ms", "60", "--format", "json"];
    let seconds = |found: &Value| found["stats"]["planning_seconds"].as_f64().unwrap();
    let runs: Vec<Value> = (0..5).map(|_| json(&cdpr(&budgeted))).collect();
    let found = runs.iter().min_by(|a, b| seconds(a).total_cmp(&seconds(b))).unwrap();
    assert!((0.03..0.07).contains(&seconds(found)), "{found}");
    assert!((found["cost"].as_f64().unwrap() - best).abs() < 1e-3 * best, "{}", found["cost"]);
    let costs: Vec<f64> =
        found["history"].as_array().unwrap().iter().map(|better| better["cost"].as_f64().unwrap()).collect();
    assert!(!costs.is_empty() && costs.is_sorted_by(|a, b| a > b) && costs.last() == found["cost"].as_f64().as_ref());
    let paper = ["plan", &hard1, "--planner", "modified-rrt", "--seed", "3"];
    let raw = cdpr_in(folder.path(), &[&paper[..], &["--post", "none", "-o", "raw.json"]].concat());
    assert_eq!(status(&raw), 0, "{}", stderr(&raw));
    let at_once = json(&cdpr(&[&paper[..], &["--post", "taut", "--format", "json"]].concat()));
    let post = ["post", &hard1, "raw.json", "--post", "taut", "-o", "taut.json", "--format", "json"];
    let later = json(&cdpr_in(folder.path(), &post));
    assert_eq!((&later["waypoints"], &later["cost"]), (&at_once["waypoints"], &at_once["cost"]));
    assert!(later["cost"].as_f64().unwrap() < at_once["raw_cost"].as_f64().unwrap() - 0.1);
    for engine in ["cspace", "gjk"] {
        assert_eq!(status(&cdpr_in(folder.path(), &["check", &hard1, "taut.json", "--engine", engine])), 0, "{engine}");
    }
}

/// The data of a page.
fn data_of(page: &str) -> Value {
    let (_, rest) = page.split_once("id=\"cdpr-data\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn the_bound_of_a_path_has_a_proof_that_check_accepts() {
    let folder = folder();
    let hard1 = testdata("scenes/hard1.toml");
    let planned = cdpr_in(folder.path(), &["plan", &hard1, "--proof", "bound.json", "--format", "json"]);
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    let bound = json(&planned)["lower_bound"].as_f64().unwrap();
    let checked = cdpr_in(folder.path(), &["check", &hard1, "bound.json", "--format", "json"]);
    assert_eq!(status(&checked), 0, "{}", stderr(&checked));
    assert_eq!((&json(&checked)["valid"], json(&checked)["lower_bound"].as_f64()), (&true.into(), Some(bound)));
    let viewed = cdpr_in(folder.path(), &["view", &hard1, "bound.json", "-o", "view.html"]);
    assert!(status(&viewed) == 2 && stderr(&viewed).contains("which is not drawn"), "{}", stderr(&viewed));
    let text = fs::read_to_string(folder.path().join("bound.json")).unwrap();
    fs::write(folder.path().join("longer.json"), text.replace("\"length\":2.4", "\"length\":2.5")).unwrap();
    let refused = cdpr_in(folder.path(), &["check", &hard1, "longer.json"]);
    assert_eq!(status(&refused), 2);
    assert!(
        stderr(&refused).contains("longer.json: ") && stderr(&refused).contains(": found "),
        "{}",
        stderr(&refused)
    );
}

#[test]
fn pages_of_no_path_and_of_its_proof_show_why() {
    let folder = folder();
    let closed = testdata("scenes/closed.toml");
    let read = |name: &str| data_of(&fs::read_to_string(folder.path().join(name)).unwrap());
    let planned = ["plan", &closed, "--html", "plan.html", "--proof", "proof.json", "--format", "json"];
    let planned = cdpr_in(folder.path(), &planned);
    assert_eq!(status(&planned), 1, "{}", stderr(&planned));
    let (proof, page) = (json(&planned)["proof"].clone(), read("plan.html"));
    let shown = &page["no_path"];
    assert_eq!(page["path"]["status"], "no_path");
    for [theirs, ours] in
        [["culprits"; 2], ["blocking"; 2], ["reachable_volume", "volume"], ["nearest_to_goal", "nearest"]]
    {
        assert_eq!((&proof[theirs], proof[theirs].is_null()), (&shown[ours], false), "{theirs}");
    }
    let lists = |key: &str| shown[key].as_array().unwrap();
    assert!(lists("reachable").len() > 6);
    assert_eq!(lists("walls").len(), lists("culprits").len());
    assert!(lists("walls").iter().all(|faces| faces.as_array().unwrap().len() > 6));
    for detour in lists("without") {
        assert_eq!(proof["without"][detour["obstacle"].as_str().unwrap()], detour["cost"]);
        let waypoints = detour["waypoints"].as_array().unwrap();
        assert_eq!((&waypoints[0], &waypoints[waypoints.len() - 1]), (&page["start"], &page["goal"]));
    }
    let viewed = cdpr_in(folder.path(), &["view", &closed, "proof.json", "-o", "view.html"]);
    assert_eq!(status(&viewed), 0, "{}", stderr(&viewed));
    assert_eq!(read("view.html")["no_path"], *shown);
    let other = cdpr_in(folder.path(), &["view", &testdata("scenes/hard1.toml"), "proof.json", "-o", "other.html"]);
    assert_eq!(status(&other), 2);
    assert!(stderr(&other).contains("proof.json: found a proof for another scene"), "{}", stderr(&other));
}
