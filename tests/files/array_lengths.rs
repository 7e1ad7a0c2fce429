//! Arrays of fixed length in every file format: with one element too many or too few they are rejected by key and
//! number, never truncated or filled in.

use cdpr_core::Error;
use cdpr_files::text::Notation;
use cdpr_files::{ImportOptions, PathFormat, import_robot, robot_from_text, scene_from_text, waypoints_from_text};
use cdpr_study::{experiment_from_text, load_study, merge};
use serde_json::{Value, json};

/// Keys whose arrays may be of any length.
const LISTS: [&str; 13] = [
    "ignore",
    "orientations",
    "platform",
    "cables",
    "obstacles",
    "triangles",
    "base",
    "scenarios",
    "methods",
    "t_tests",
    "waypoints",
    "raw_waypoints",
    "groups",
];
/// More of them: lists of plain numbers or names.
const PLAIN_LISTS: [&str; 3] = ["step", "post", "repeats"];

/// A scene that uses every array of the format; `vertices` occurs in bodies, meshes and `[wrench]`.
fn scene() -> Value {
    let corners = json!([[0, 0, 0], [0.2, 0, 0], [0, 0.2, 0], [0, 0, 0.2]]);
    json!({
        "version": 1,
        "gravity": [0, 0, -9.81],
        "ignore": [["first", "mesh"]],
        "workspace": { "min": [0, 0, 0], "max": [2, 2, 2] },
        "orientations": [
            { "name": "flat", "rpy": [0, 0, 0] },
            { "name": "turned", "quaternion": [1, 0, 0, 0] },
        ],
        "robot": robot(),
        "obstacles": [
            { "name": "box", "box": [0.1, 0.1, 0.1], "position": [1, 1, 1], "rpy": [0, 0, 1] },
            { "name": "hull", "vertices": corners, "quaternion": [1, 0, 0, 0], "position": [1.5, 1, 1] },
            { "name": "prism", "prism": { "base": [[1, 0.2], [1.1, 0.2], [1, 0.3]], "height": 0.1 }, "rpy_degrees": [0, 0, 1] },
            { "name": "mesh", "mesh": {
                "vertices": [[1, 1.5, 0], [1.2, 1.5, 0], [1, 1.7, 0], [1, 1.5, 0.2]],
                "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
            } },
        ],
        "wrench": { "vertices": [[0, 0, 1, 0, 0, 0]], "load": [0, 0, -1, 0, 0, 0] },
        "query": { "start": [0.5, 0.5, 1.5], "goal": [1.5, 0.5, 1.5], "orientation": [1, 0, 0, 0] },
    })
}

fn robot() -> Value {
    let cable = |name: &str, outlet: Value| {
        json!({
            "name": name, "outlet": outlet, "attachment": [0, 0, 0.05], "tension": [1, 100], "length": [0, 9],
        })
    };
    json!({
        "mass": 1,
        "center_of_mass": [0, 0, 0.01],
        "platform": [{ "box": [0.1, 0.1, 0.1] }],
        "cables": [cable("first", json!([0, 0, 2])), cable("second", json!([2, 0, 2]))],
    })
}

fn robot_file() -> Value {
    let mut robot = robot();
    robot["version"] = json!(1);
    robot
}

fn experiment() -> Value {
    let mut scene = scene();
    scene["orientations"] = json!([]);
    scene.as_object_mut().unwrap().remove("wrench"); // two cables balance nothing
    let region = json!({ "min": [0.5, 0.8, 0], "max": [1.5, 1.2, 1] });
    let random =
        json!({ "count": 1, "width": [0.1, 0.2], "depth": [0.1, 0.2], "height": [0.1, 0.2], "region": region });
    json!({
        "version": 1,
        "trials": 2,
        "scenarios": [{ "name": "random", "scene": scene, "random": random }],
        "methods": [{ "name": "m", "sweep": { "step": [0.1, 0.2], "post": ["both"], "repeats": [1, 2] } }],
        "t_tests": [{
            "group": "A",
            "measure": "cost",
            "a": ["random", "m, step 0.1, both, repeats 1"],
            "b": ["random", "m, step 0.1, both, repeats 2"],
        }],
    })
}

fn path() -> Value {
    json!({
        "version": 1,
        "waypoints": [[0, 0, 0], [1, 1, 1]],
        "raw_waypoints": [[0, 0, 0], [1, 0, 1], [1, 1, 1]],
        "orientation": [1, 0, 0, 0],
        "orientations": [[1, 0, 0, 0], [0, 0, 0, 1]],
    })
}

fn run_file() -> Value {
    json!({
        "version": 1, "experiment": "e", "fingerprint": "f", "first_trial": 0, "end_trial": 1,
        "layout": {
            "confidence": 0.95,
            "groups": [{ "scenario": "s", "methods": ["m"] }],
            "t_tests": [{ "group": "A", "measure": "cost", "a": ["s", "m"], "b": ["s", "m"] }],
        },
    })
}

fn summary_file() -> Value {
    json!({
        "experiment": "e", "fingerprint": "f", "confidence": 0.9, "methods": [],
        "t_tests": [{ "group": "A", "measure": "cost", "a": ["s", "m"], "b": ["s", "m"], "t": 1, "df": 1, "p": 1 }],
    })
}

type Reader = fn(&str, Notation) -> Result<(), Error>;

/// Every format with a file that uses all of its arrays, its reader, and the number of arrays of fixed length in it.
fn formats() -> Vec<(&'static str, Value, Reader, usize)> {
    vec![
        ("scene", scene(), |text, notation| scene_from_text(text, notation, None).map(drop), 42),
        ("robot", robot_file(), |text, notation| robot_from_text(text, notation, None).map(drop), 10),
        ("experiment", experiment(), |text, notation| experiment_from_text(text, notation, None).map(drop), 45),
        ("path", path(), |text, _| waypoints_from_text(text, PathFormat::Json).map(drop), 8),
        ("run", run_file(), |text, _| read_in_folder("run.json", text), 2),
        ("summary", summary_file(), |text, _| read_in_folder("summary.json", text), 2),
    ]
}

fn read_in_folder(name: &str, text: &str) -> Result<(), Error> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(name), text).unwrap();
    match name {
        "run.json" => merge(&[folder.path().to_path_buf()], folder.path().join("merged")),
        _ => load_study(folder.path()).map(drop),
    }
}

/// JSON pointers to the arrays of fixed length in a value.
fn fixed_arrays(value: &Value, pointer: &str, key: &str, found: &mut Vec<String>) {
    let list = LISTS.contains(&key) || PLAIN_LISTS.contains(&key) || (key == "vertices" && value[0].is_array());
    match value {
        Value::Array(elements) => {
            if !list {
                found.push(pointer.to_string());
            }
            for (k, element) in elements.iter().enumerate() {
                fixed_arrays(element, &format!("{pointer}/{k}"), "", found);
            }
        }
        Value::Object(table) => {
            table.iter().for_each(|(key, value)| fixed_arrays(value, &format!("{pointer}/{key}"), key, found));
        }
        _ => {}
    }
}

/// "/robot/cables/0/outlet" as in messages: "robot.cables[0].outlet".
fn place(pointer: &str) -> String {
    let step = |step: &str| match step.parse::<usize>() {
        Ok(index) => format!("[{index}]"),
        Err(_) => format!(".{step}"),
    };
    pointer.split('/').skip(1).map(step).collect::<String>().trim_start_matches('.').to_string()
}

fn text(value: &Value, notation: Notation) -> String {
    match notation {
        Notation::Json => format!("{value:#}"),
        Notation::Toml => toml::to_string(value).unwrap(),
    }
}

#[test]
fn arrays_of_wrong_length_are_refused_in_every_format() {
    for (format, whole, read, count) in formats() {
        let notations = if matches!(format, "path" | "run" | "summary") { 1 } else { 2 };
        for notation in &[Notation::Json, Notation::Toml][..notations] {
            let sound = read(&text(&whole, *notation), *notation);
            let known = matches!(format, "run" | "summary"); // these lack the other files of their folder
            assert!(sound.is_ok() || known, "{format}: {}", sound.unwrap_err());
            let mut arrays = Vec::new();
            fixed_arrays(&whole, "", "", &mut arrays);
            assert_eq!(arrays.len(), count, "{format}: {arrays:#?}");
            for pointer in &arrays {
                for more in [true, false] {
                    let mut changed = whole.clone();
                    let array = changed.pointer_mut(pointer).unwrap().as_array_mut().unwrap();
                    let expected = array.len();
                    let last = array.pop().unwrap();
                    array.extend(if more { vec![last.clone(), last] } else { vec![] });
                    let found = array.len();
                    let message = read(&text(&changed, *notation), *notation).expect_err(pointer).to_string();
                    let what = if changed.pointer(&format!("{pointer}/0")).is_some_and(Value::is_string) {
                        if found == 1 { "name" } else { "names" }
                    } else if found == 1 {
                        "number"
                    } else {
                        "numbers"
                    };
                    let told = format!("{}: found {found} {what}, expected {expected}", place(pointer));
                    assert!(message.contains(&told) && message.contains("(line "), "{format}: {told}: {message}");
                }
            }
        }
    }
}

#[test]
fn a_decimal_comma_is_refused_with_file_key_line_and_numbers() {
    let scene = text(&scene(), Notation::Toml).replace("start = [0.5, 0.5, 1.5]", "start = [0,5, 0.5, 1.5]");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("hall.toml");
    std::fs::write(&path, &scene).unwrap();
    let line = 1 + scene.lines().position(|line| line.starts_with("start = [0,5")).unwrap();
    let message = cdpr_files::load_scene(&path).unwrap_err().to_string();
    assert_eq!(message, format!("{}: query.start: found 4 numbers, expected 3 (line {line})", path.display()));
}

#[test]
fn empty_arrays_and_other_types_are_refused() {
    for (found, expected) in [
        (json!([]), "query.start: found 0 numbers, expected 3"),
        (json!([1, 2, 3, 4, 5, 6, 7]), "query.start: found 7 numbers, expected 3"),
        (json!(1), "query.start: found 1, expected a position [x, y, z] or the name of a station"),
        (
            json!("1, 2, 3"),
            "query.start: found \"1, 2, 3\", expected a position [x, y, z] or one of the scene's stations",
        ),
        (json!([1, "2", 3]), "query.start[1]: found the string \"2\", expected a number"),
        (json!([1, [2], 3]), "query.start[1]: found an array, expected a number"),
    ] {
        let mut scene = scene();
        scene["query"]["start"] = found;
        for notation in [Notation::Json, Notation::Toml] {
            let message = scene_from_text(&text(&scene, notation), notation, None).unwrap_err().to_string();
            assert!(message.starts_with(expected), "{message}");
        }
    }
}

#[test]
fn yaml_is_refused_with_the_same_care() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("robot.yaml");
    let yaml =
        "platform: {type: box, size: [1, 1, 1], mass: 1}\npoints:\n- {frame: [0, 0, 3], platform: [0, 0, 0.5]}\n";
    let import = |yaml: &str| {
        std::fs::write(&path, yaml).unwrap();
        import_robot(&path, &ImportOptions::default())
    };
    import(yaml).unwrap();
    for (from, to, expected) in [
        ("[0, 0, 3]", "[0, 0, 3, 1]", "points[0].frame: found [0,0,3,1], expected 3 finite numbers"),
        ("[0, 0, 3]", "[0, 3]", "points[0].frame: found [0,3], expected 3 finite numbers"),
        ("[1, 1, 1]", "[1, 1, 1, 1]", "platform.size: found [1,1,1,1], expected"),
    ] {
        let message = import(&yaml.replace(from, to)).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    }
}
