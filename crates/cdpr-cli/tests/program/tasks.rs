//! Tasks: legs in their scenes, the files of a task, what is wrong with them, and legs without a path.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::support::*;

/// A folder with the scene of a tower, whose task is as given, or its own.
fn cell(rows: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let scene = fs::read_to_string(testdata("tasks/tower.toml")).unwrap();
    let (bare, own) = scene.split_at(scene.find("[[task]]").unwrap());
    fs::write(folder.path().join("cell.toml"), format!("{bare}{}", if rows.is_empty() { own } else { rows })).unwrap();
    folder
}

fn run(folder: &Path, args: &[&str]) -> std::process::Output {
    cdpr_in(folder, args)
}

fn read(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn a_task_is_planned_written_and_checked() {
    let folder = cell("");
    let output = run(folder.path(), &["task", "cell.toml", "-o", "task", "--html"]);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    let text = stdout(&output);
    assert!(text.contains("m in 7 legs\n  leg 1, dock to tower: "), "{text}");
    assert!(text.contains("\n  leg 4, crate to table, carrying crate: "), "{text}");
    let task = read(&folder.path().join("task/task.json"));
    assert_eq!((&task["status"], task["legs"].as_array().unwrap().len()), (&json!("solved"), 7));
    assert_eq!(task["legs"][1]["before"], json!([{ "pick": "tower" }]));
    assert_eq!(task["legs"][1]["carried"], json!(["tower"]));
    assert_eq!(task["legs"][3]["standing"]["tower"]["position"], json!([0.4, 1.6, 0.725]));
    assert_eq!(read(&folder.path().join("task/leg-1.json"))["status"], "solved");
    assert!(fs::read_to_string(folder.path().join("task/leg-7.html")).unwrap().contains("cdpr-data"));
    let checked = run(folder.path(), &["check", "cell.toml", "task/task.json", "--strict"]);
    assert_eq!(status(&checked), 0, "{}", stderr(&checked));
    assert!(stdout(&checked).contains("valid: ") && stdout(&checked).contains(" m in 7 legs"), "{}", stdout(&checked));
    let printed = json(&run(folder.path(), &["task", "cell.toml", "-o", "again", "--format", "json", "-q"]));
    assert_eq!(printed, task);
    let report = json(&run(folder.path(), &["check", "cell.toml", "task/task.json", "--format", "json"]));
    assert_eq!((&report["valid"], report["legs"].as_array().unwrap().len()), (&json!(true), 7));
    // A path of a leg is refused where it does not hold: in the scene as it is at first.
    let first = run(folder.path(), &["check", "cell.toml", "task/leg-4.json"]);
    assert_eq!(status(&first), 1, "{}", stdout(&first));
}

/// Motions of an earlier task must not be taken for those of the last one.
#[test]
fn a_task_removes_the_files_of_an_earlier_one() {
    let folder = cell("");
    let go = |rows: &str, expected: i32| {
        let scene = cell(rows);
        fs::copy(scene.path().join("cell.toml"), folder.path().join("cell.toml")).unwrap();
        let limits = ["--trajectory", "all.csv", "--speed", "1", "--acceleration", "2", "--html"];
        let output = run(folder.path(), &[&["task", "cell.toml", "-o", "task"], &limits[..]].concat());
        assert_eq!(status(&output), expected, "{}", stderr(&output));
        let mut names: Vec<String> = fs::read_dir(folder.path().join("task"))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        (names, stderr(&output))
    };
    let (before, told) = go("", 0);
    assert_eq!(before.len(), 7 * 3 + 2, "{before:?}");
    assert!(!told.contains("was not written"), "{told}");
    fs::write(folder.path().join("task/notes.txt"), "mine").unwrap();
    let rows = "[[task]]\npick = \"crate\"\n[[task]]\ngo = \"table\"\n[[task]]\nplace = \"crate\"\n";
    let (after, told) = go(rows, 1);
    assert!(told.contains("all.csv was not written: not every leg has a motion"), "{told}");
    assert_eq!(after, ["leg-1-motion.json", "leg-1.html", "leg-1.json", "leg-2.json", "notes.txt", "task.json"]);
}

#[test]
fn a_leg_without_a_path_is_named_and_the_others_are_planned() {
    let rows =
        "[[task]]\npick = \"crate\"\n[[task]]\ngo = \"table\"\n[[task]]\nplace = \"crate\"\n[[task]]\ngo = \"dock\"\n";
    let folder = cell(rows);
    let output = run(folder.path(), &["task", "cell.toml", "-o", "task"]);
    assert_eq!(status(&output), 1, "{}", stderr(&output));
    let text = stdout(&output);
    assert!(text.contains("no task: 1 of 3 legs without a path\n  leg 1, dock to crate: 0."), "{text}");
    assert!(
        text.contains("  leg 2, crate to table, carrying crate: no path exists: ") && text.contains("without tower "),
        "{text}"
    );
    assert_eq!(read(&folder.path().join("task/leg-2.json"))["status"], "no_path");
    let checked = run(folder.path(), &["check", "cell.toml", "task/task.json"]);
    assert_eq!(status(&checked), 1, "{}", stderr(&checked));
    let text = stdout(&checked);
    assert!(text.contains("not valid: ") && text.contains("in 3 legs, 1 leg without a path"), "{text}");
    assert!(text.contains("  leg 2, crate to table, carrying crate: no path exists"), "{text}");
    let mut high = fs::read_to_string(folder.path().join("cell.toml")).unwrap();
    high = high.replace("box = [0.3, 0.3, 0.1]", "box = [0.3, 0.3, 0.2]");
    fs::write(folder.path().join("cell.toml"), high).unwrap();
    let output = run(folder.path(), &["task", "cell.toml", "-o", "task"]);
    let text = stdout(&output);
    assert!(text.contains("carrying crate: its goal is not valid: the platform meets table"), "{text}");
}

#[test]
fn a_collision_is_named_with_its_leg_and_damage_with_its_key() {
    let folder = cell("");
    assert_eq!(status(&run(folder.path(), &["task", "cell.toml", "-o", "task"])), 0);
    let place = folder.path().join("task/task.json");
    let whole = read(&place);
    let check = |task: &Value| {
        fs::write(&place, task.to_string()).unwrap();
        run(folder.path(), &["check", "cell.toml", "task/task.json"])
    };
    for (pointer, value, said) in [
        ("/legs/1/from/position", json!([1.0, 1.0]), "legs[1].from.position"),
        ("/legs/1/from/position", json!([1.0, 1.0, 0.7]), "legs[1].from: found [1.0, 1.0, 0.7]"),
        ("/legs/2/before", json!([]), "legs[2].carried: found none named \"tower\""),
        ("/legs/1/before/0", json!({ "pick": "chest" }), "legs[1].before[0].pick: found \"chest\" at"),
        ("/legs/1/before/0", json!({ "lift": "tower" }), "legs[1].before[0]"),
        ("/legs/4/path", json!("leg-9.json"), "cannot be read"),
        ("/legs/4/path", json!("leg-1.json"), "legs[4].path: found a path that begins at"),
        ("/legs", json!(3), "legs"),
    ] {
        let mut task = whole.clone();
        *task.pointer_mut(pointer).unwrap() = value;
        let output = check(&task);
        assert_eq!((status(&output), stdout(&output).as_str()), (2, ""), "{pointer}");
        assert!(stderr(&output).contains(said), "{pointer}: {}", stderr(&output));
    }
    // The via of leg 6 is left out of its path, and leg 4 goes straight through the walls.
    let straight = |k: usize| {
        let file = folder.path().join(format!("task/leg-{k}.json"));
        let mut path = read(&file);
        let waypoints = path["waypoints"].as_array().unwrap().clone();
        path["waypoints"] = json!([waypoints[0], waypoints[waypoints.len() - 1]]);
        let old = fs::read(&file).unwrap();
        fs::write(&file, path.to_string()).unwrap();
        (file, old)
    };
    let (file, old) = straight(6);
    let output = check(&whole);
    assert_eq!(status(&output), 2);
    assert!(
        stderr(&output).contains("legs[5].path: found a path that does not pass [1.0, 1.0, 0.5]"),
        "{}",
        stderr(&output)
    );
    fs::write(file, old).unwrap();
    straight(4);
    let output = check(&whole);
    assert_eq!(status(&output), 1, "{}", stderr(&output));
    assert!(stdout(&output).contains("  leg 4, crate to table, carrying crate, segment 0 at "), "{}", stdout(&output));
    let limits = run(folder.path(), &["check", "cell.toml", "task/task.json", "--speed", "1"]);
    assert!(status(&limits) == 2 && stderr(&limits).contains("--speed: found with a task"), "{}", stderr(&limits));
    let other = testdata("scenes/hard1.toml");
    let output = run(folder.path(), &["check", &other, "task/task.json"]);
    assert!(
        status(&output) == 2 && stderr(&output).contains("expected one of the scene's payloads (none)"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn a_task_that_cannot_be_is_refused() {
    let folder = cell("[[task]]\npick = \"crate\"\n[[task]]\npick = \"crate\"\n");
    let output = run(folder.path(), &["task", "cell.toml", "-o", "task"]);
    assert_eq!(status(&output), 2);
    assert!(
        stderr(&output).contains("cell.toml: task[1].pick: found \"crate\", which is carried already"),
        "{}",
        stderr(&output)
    );
    assert!(!folder.path().join("task").exists());
    for (args, words) in [
        (&["task", &testdata("scenes/hard1.toml"), "-o", "task"][..], "task: found none, expected rows"),
        (&["task", &testdata("tasks/tower.toml")], "--output"),
        (&["task", &testdata("tasks/tower.toml"), "-o", "-"], "expected the name of a folder"),
        (&["task", &testdata("tasks/tower.toml"), "-o", "task", "--gap", "0"], "--gap"),
        (&["task", &testdata("tasks/tower.toml"), "-o", "task", "--threads", "0"], "--threads"),
    ] {
        let output = run(folder.path(), args);
        assert!(status(&output) == 2 && stderr(&output).contains(words), "{args:?}: {}", stderr(&output));
    }
}
