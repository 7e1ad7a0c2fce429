//! Bad files: each message names the file, the key and what is expected.

use std::fs;
use std::path::{Path, PathBuf};

use cdpr_files::text::Notation;
use cdpr_files::{
    PathFile, PathFormat, load_robot, load_scene, load_waypoints, save_path, scene_from_text, scene_of_path,
    waypoints_from_text,
};

fn testdata(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../testdata").join(name)
}

/// hard1 with one piece of text replaced.
fn scene_with(from: &str, to: &str) -> String {
    let text = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    assert!(text.contains(from), "{from} is not in the scene");
    text.replacen(from, to, 1)
}

/// The message of loading a scene with this text; it must name the file.
fn refusal(text: &str, extension: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(format!("scene.{extension}"));
    fs::write(&path, text).unwrap();
    let message = load_scene(&path).expect_err("it should be refused").to_string();
    assert!(message.contains(&path.display().to_string()), "no file name in: {message}");
    message
}

#[test]
fn scenes_that_make_no_sense_are_refused_by_key() {
    let first_outlet = "outlet = [0.0, 0.0, 0.0]";
    let box_line = "box = [0.3, 0.3, 1.5]";
    for (from, to, expected) in [
        ("version = 1", "version = 2", vec!["version", "expected 1"]),
        ("version = 1", "version = 1\nclearence = 0.1", vec!["clearence", "did you mean `clearance`", "line"]),
        ("version = 1", "version = 1\nclearance = -0.1", vec!["clearance", "-0.1", "at least 0"]),
        ("version = 1", "version = 1\nclearance = nan", vec!["clearance", "NaN"]),
        ("version = 1", "version = 1\ngravity = [0.0, inf, 0.0]", vec!["gravity", "inf"]),
        (
            "version = 1",
            "version = 1\nignore = [[\"cable 3\", \"pilar\"]]",
            vec!["ignore[0]", "pilar", "did you mean \"pillar\""],
        ),
        ("version = 1", "version = 1\nignore = [[\"pillar\", \"pillar\"]]", vec!["ignore[0]", "different"]),
        ("version = 1", "version = 1\nversion = 1", vec!["duplicate key `version`", "line 3"]),
        (first_outlet, "outlet = [0.0, 0.0]", vec!["robot.cables[0].outlet", "found 2 numbers, expected 3"]),
        (first_outlet, "outlet = [0.0, nan, 0.0]", vec!["robot.cables[0].outlet", "NaN"]),
        (first_outlet, "outlet = [0.0, -inf, 0.0]", vec!["robot.cables[0].outlet", "-inf"]),
        (first_outlet, "outlet = [0.0, 2e6, 0.0]", vec!["robot.cables[0].outlet", "2000000", "1e6"]),
        (
            first_outlet,
            "outlet = [1.0, 1.0, 0.5]",
            vec!["robot.cables[0].outlet", "inside obstacle \"pillar\"", "move"],
        ),
        (first_outlet, "outlet = \"here\"", vec!["robot.cables[0].outlet", "string"]),
        (
            "attachment = [-0.075, -0.075, -0.025]",
            "attachment = [0.0, 0.0, 0.0]",
            vec!["robot.cables[0].attachment", "inside platform[0]", "surface"],
        ),
        ("tension = [10.0, 1000.0]", "tension = [1000.0, 10.0]", vec!["robot.cables[0].tension", "min <= max"]),
        ("tension = [10.0, 1000.0]", "tension = [-1.0, 10.0]", vec!["robot.cables[0].tension", "0 <= min"]),
        ("tension = [10.0, 1000.0]", "length = [2.0, 1.0]", vec!["robot.cables[0].length", "min <= max"]),
        ("tension = [10.0, 1000.0]", "diameter = -0.1", vec!["robot.cables[0].diameter", "-0.1"]),
        ("tension = [10.0, 1000.0]", "name = \"cable 1\"", vec!["robot.cables[1].name", "unique"]),
        ("mass = 10.0", "mass = -1.0", vec!["robot.mass", "-1"]),
        ("mass = 10.0", "mass = 10.0\nversion = 1", vec!["robot.version"]),
        (box_line, "box = [0.3, 0.0, 1.5]", vec!["obstacles[0]", "without volume"]),
        (box_line, "box = [0.3, -0.3, 1.5]", vec!["obstacles[0].box", "-0.3"]),
        (box_line, "", vec!["obstacles[0]", "box, vertices, prism"]),
        (box_line, "box = [0.3, 0.3, 1.5]\nvertices = [[0.0, 0.0, 0.0]]", vec!["obstacles[0]", "exactly one"]),
        (box_line, "vertices = []", vec!["obstacles[0].vertices", "no vertices"]),
        (
            box_line,
            "vertices = [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0]]",
            vec!["obstacles[0]", "without volume"],
        ),
        (
            box_line,
            "vertices = [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1], [0.02, 0.02, 0.02]]",
            vec!["obstacles[0].vertices", "vertex 4", "inside the hull"],
        ),
        (
            box_line,
            "prism = { base = [[0.0, 0.0], [0.1, 0.0], [0.2, 0.0]], height = 1.0 }",
            vec!["obstacles[0].prism.base", "three corners"],
        ),
        (
            box_line,
            "prism = { base = [[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]], height = 0.0 }",
            vec!["obstacles[0].prism.height", "positive"],
        ),
        (
            box_line,
            "prism = { base = [[0.0, 0.0], [0.1, 0.0], [0.0, 0.1], [0.02, 0.02]], height = 1.0 }",
            vec!["obstacles[0].prism.base[3]", "inside"],
        ),
        (
            box_line,
            "box = [0.3, 0.3, 1.5]\nrpy = [0.0, 0.0, 0.1]\nquaternion = [1.0, 0.0, 0.0, 0.0]",
            vec!["rpy and quaternion"],
        ),
        (
            box_line,
            "box = [0.3, 0.3, 1.5]\nquaternion = [1.0, 0.1, 0.0, 0.0]",
            vec!["obstacles[0].quaternion", "length 1"],
        ),
        ("name = \"pillar\"", "name = \"cable 0\"", vec!["obstacles[0].name", "cable 0"]),
        ("max = [2.0, 2.0, 2.0]", "max = [2.0, 0.0, 2.0]", vec!["workspace", "min < max", "y"]),
        ("start = [0.3, 1.0, 0.3]", "start = [0.3, nan, 0.3]", vec!["query.start", "NaN"]),
        ("start = [0.3, 1.0, 0.3]", "orientation = [1.0, 1.0, 0.0, 0.0]", vec!["query.orientation", "length 1"]),
        ("[workspace]", "[workspace", vec!["line"]),
    ] {
        let message = refusal(&scene_with(from, to), "toml");
        for word in expected {
            assert!(message.contains(word), "{to}: expected \"{word}\" in: {message}");
        }
    }
}

#[test]
fn json_is_refused_with_the_same_care() {
    assert!(
        refusal("{\"version\": 1, \"workspace\": {\"min\": [0, 0], \"max\": [1, 1, 1]}}", "json")
            .contains("workspace.min")
    );
    assert!(refusal("{\"version\": 1, ", "json").contains("line 1"));
    assert!(refusal("{} trailing", "json").contains("version"));
    assert!(refusal("", "toml").contains("missing field `version`"));
}

#[test]
fn missing_files_and_unknown_extensions_are_refused() {
    let missing = load_scene(Path::new("nowhere.toml")).unwrap_err().to_string();
    assert!(missing.contains("nowhere.toml") && missing.contains("cannot be read"));
    let other = load_scene(Path::new("scene.yaml")).unwrap_err().to_string();
    assert!(other.contains(".yaml") && other.contains(".toml or .json"));
    let text = fs::read_to_string(testdata("scenes/hard3.toml")).unwrap().replace("paper.toml", "nobody.toml");
    assert!(
        {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("scene.toml");
            fs::write(&path, text).unwrap();
            load_scene(&path).unwrap_err().to_string()
        }
        .contains("nobody.toml")
    );
}

#[test]
fn a_robot_file_needs_its_version() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("robot.toml");
    let text = fs::read_to_string(testdata("robots/paper.toml")).unwrap();
    fs::write(&path, text.replace("version = 1", "")).unwrap();
    assert!(load_robot(&path).unwrap_err().to_string().contains("version"));
}

#[test]
fn paths_that_make_no_sense_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let scene = load_scene(testdata("scenes/hard1.toml")).unwrap();
    for (name, text, expected) in [
        ("a.json", "{\"waypoints\": []}", "found no waypoints"),
        ("a.json", "{\"waypoints\": [], \"status\": \"budget_spent\"}", "budget_spent"),
        ("b.json", "{\"waypoints\": [[0, 0, 0]]}", "found 1 waypoint,"),
        ("c.json", "{\"waypoints\": [[0, 0], [1, 1, 1]]}", "waypoints[0]"),
        ("d.json", "{\"waypoints\": [[0, 0, 0], [1, 1, 1e9]]}", "waypoints[1]"),
        ("e.json", "{\"version\": 3, \"waypoints\": [[0, 0, 0], [1, 1, 1]]}", "version"),
        (
            "f.json",
            "{\"waypoints\": [[0, 0, 0], [1, 1, 1]], \"scene\": {\"name\": \"hard3\", \"fingerprint\": \"12\"}}",
            "another scene",
        ),
        ("g.json", "{\"waypoints\": [[1", "EOF"),
        ("h.csv", "x,y\n1,2\n", "x,y,z"),
        ("i.csv", "x,y,z\n", "found no waypoints"),
        ("j.csv", "x,y,z\n1,2,3\n1,2\n", "line 3"),
        ("k.csv", "x,y,z\n1,2,3\n1,2,three\n", "line 3: found \"three\", expected a number"),
        ("k2.csv", "x,y,z\n1,2,3\n0,5,1,2\n", "line 3: found 4 numbers, expected 3"),
        ("l.csv", "x,y,z\n1,2,3\n1,2,nan\n", "waypoints[1]"),
        ("m.txt", "x,y,z\n1,2,3\n1,2,4\n", ".json or .csv"),
        ("n.csv", "x,y,z,qw,qx,qy\n1,2,3,1,0,0\n", "expected \"x,y,z\" or, if the platform turns"),
        ("o.csv", "x,y,z,qw,qx,qy,qz\n1,2,3,1,0,0,0\n1,2,3\n", "line 3: found 3 numbers, expected 7"),
        ("p.csv", "x,y,z,qw,qx,qy,qz\n1,2,3,1,0,0,0\n1,2,4,2,0,0,0\n", "orientations[1]"),
        ("q.csv", "x,y,z,qw,qx,qy,qz\n1,2,3,1,0,0,0\n", "found 1 waypoint,"),
    ] {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        let message = load_waypoints(&path)
            .and_then(|loaded| scene_of_path(&scene, &loaded, true).map_err(|e| e.in_file(&path)))
            .unwrap_err()
            .to_string();
        assert!(message.contains(expected) && message.contains(name), "{name}: expected \"{expected}\" in: {message}");
    }
}

#[test]
fn orientations_that_make_no_sense_are_refused() {
    for (orientations, expected) in [
        ("[[1, 0, 0, 0]]", "orientations: found 1, expected one for each of the 2 waypoints"),
        ("[]", "orientations: found 0, expected one for each of the 2 waypoints"),
        ("[[1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0]]", "orientations: found 3, expected"),
        ("[[1, 0, 0, 0], [1, 1, 0, 0]]", "orientations[1]: found a quaternion of length"),
        ("[[0, 0, 0, 0], [1, 0, 0, 0]]", "orientations[0]: found a quaternion of length 0"),
        ("[[1, 0, 0, 0], [1e200, 0, 0, 0]]", "orientations[1]"),
        ("[[1, 0, 0, 0], [NaN, 0, 0, 0]]", "orientations[1][0]: expected value"),
        ("[[1, 0, 0, 0], [null, 0, 0, 0]]", "orientations[1][0]: found null, expected a number"),
        ("[[1, 0, 0, 0], [1, 0, 0]]", "orientations[1]: found 3 numbers, expected 4: w x y z"),
        ("[\"along\", \"across\"]", "orientations[0]: found the string \"along\", expected an array of 4 numbers"),
        ("\"along\"", "orientations: found the string \"along\", expected an array"),
    ] {
        let text = format!("{{\"waypoints\": [[0, 0, 0], [1, 1, 1]], \"orientations\": {orientations}}}");
        let message = waypoints_from_text(&text, PathFormat::Json).unwrap_err().to_string();
        assert!(message.contains(expected), "{orientations}: expected \"{expected}\" in: {message}");
    }
    for number in ["NaN", "inf", "-1e400"] {
        let text = format!("x,y,z,qw,qx,qy,qz\n1,2,3,1,0,0,0\n1,2,3,{number},0,0,0\n");
        let message = waypoints_from_text(&text, PathFormat::Csv).unwrap_err().to_string();
        assert!(message.contains("orientations[1]"), "{number}: {message}");
    }
}

#[test]
fn a_path_that_turns_is_written_and_read_back_in_both_formats() {
    let folder = tempfile::tempdir().unwrap();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let orientations = vec![[1.0, 0.0, 0.0, 0.0], [half, 0.0, 0.0, half]];
    let waypoints = vec![[0.0, 0.1, 1.0 / 3.0], [1.0, 2.0, 3.0]];
    let file = PathFile { waypoints, orientations: Some(orientations), ..PathFile::default() };
    let expected = file.turns().unwrap();
    for name in ["path.json", "path.csv"] {
        let path = folder.path().join(name);
        save_path(&path, &file).unwrap();
        let loaded = load_waypoints(&path).unwrap();
        assert_eq!((loaded.waypoints, loaded.orientations), (file.points(), expected.clone()), "{name}");
    }
}

#[test]
fn turning_tables_that_make_no_sense_are_refused() {
    let text = fs::read_to_string(testdata("scenes/empty.toml")).unwrap();
    for (key, expected) in [
        ("axis = \"x\"", "expected \"free\" or an axis [x, y, z]"),
        ("axis = [0, 0, 0]", "turning.axis: found [0.0, 0.0, 0.0], expected \"free\" or an axis that is not zero"),
        ("axis = [0, 1]", "turning.axis"),
        ("axis = [0, 1, nan]", "turning.axis"),
        ("axis = 3", "turning.axis"),
        ("max_tilt = 200", "turning.max_tilt: found 200, expected an angle from 0 to 180 degrees"),
        ("max_tilt = -1", "turning.max_tilt: found -1"),
        ("max_tilt = nan", "turning.max_tilt: found NaN"),
        ("weight = -0.5", "turning.weight: found -0.5"),
        ("weight = 0", "turning.weight: found 0"),
        ("weight = inf", "turning.weight: found inf"),
        ("tilt = 3", "unknown field `tilt`"),
    ] {
        let message =
            scene_from_text(&format!("{text}\n[turning]\n{key}\n"), Notation::Toml, Some(&testdata("scenes")));
        let message = message.unwrap_err().to_string();
        assert!(message.contains(expected), "{key}: expected \"{expected}\" in: {message}");
    }
}

#[test]
fn every_shipped_file_loads() {
    for folder in ["scenes", "cases"] {
        for entry in fs::read_dir(testdata(folder)).unwrap() {
            let path = entry.unwrap().path();
            if !path.ends_with("cases.toml") {
                load_scene(&path).unwrap();
            }
        }
    }
    for entry in fs::read_dir(testdata("robots")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            load_robot(&path).unwrap();
        }
    }
}

#[test]
fn toml_and_json_say_the_same() {
    let scene = load_scene(testdata("scenes/concave.toml")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("concave.json");
    fs::write(&path, serde_json::to_string(scene.spec()).unwrap()).unwrap();
    let again = load_scene(&path).unwrap();
    assert_eq!((again.spec(), again.fingerprint()), (scene.spec(), scene.fingerprint()));
}
