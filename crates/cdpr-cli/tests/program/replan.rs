//! `cdpr plan --replan`: paths of scenes in which something has moved since.

use std::fs;

use serde_json::Value;

use crate::support::*;

/// A folder with hard3, a path in it, and hard3 with one obstacle moved.
fn moved() -> tempfile::TempDir {
    let folder = folder();
    let before = fs::read_to_string(testdata("scenes/hard3.toml")).unwrap().replace("../robots", &testdata("robots"));
    fs::write(folder.path().join("before.toml"), &before).unwrap();
    let place = "position = [0.7, 1.0, 0.6]";
    assert!(before.contains(place), "{before}");
    fs::write(folder.path().join("moved.toml"), before.replacen(place, "position = [0.6, 1.0, 0.6]", 1)).unwrap();
    let planned = cdpr_in(folder.path(), &["plan", "before.toml", "-o", "path.json", "-q"]);
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    folder
}

#[test]
fn a_path_is_kept_or_repaired() {
    let folder = moved();
    let replanned = |scene: &str, more: &[&str]| {
        let output = cdpr_in(folder.path(), &[&["plan", scene, "--replan", "path.json"][..], more].concat());
        assert_eq!(status(&output), 0, "{}{}", stdout(&output), stderr(&output));
        assert!(!stderr(&output).contains("warning"), "{}", stderr(&output));
        output
    };
    assert!(stdout(&replanned("before.toml", &[])).contains("; the given path, still valid"));
    let again = replanned("moved.toml", &["-o", "again.json", "--html", "again.html", "--proof", "bound.json"]);
    assert!(stdout(&again).contains("; the given path, repaired"), "{}", stdout(&again));
    let file: Value = serde_json::from_str(&fs::read_to_string(folder.path().join("again.json")).unwrap()).unwrap();
    assert_eq!(json(&replanned("moved.toml", &["--format", "json"]))["waypoints"], file["waypoints"]);
    for made in ["again.json", "bound.json"] {
        let checked = cdpr_in(folder.path(), &["check", "moved.toml", made]);
        assert_eq!(status(&checked), 0, "{made}: {}{}", stdout(&checked), stderr(&checked));
    }
    // From standard input, quietly, and as a timed motion.
    let text = fs::read_to_string(folder.path().join("path.json")).unwrap();
    let fed = cdpr_fed(folder.path(), &["plan", "moved.toml", "--replan", "-", "-q", "-o", "-"], &text);
    assert_eq!(json(&fed)["waypoints"], file["waypoints"], "{}", stderr(&fed));
    let limits = ["--trajectory", "motion.csv", "--speed", "1", "--acceleration", "2"];
    replanned("moved.toml", &limits);
    let limits = &limits[2..];
    let checked = cdpr_in(folder.path(), &[&["check", "moved.toml", "motion.csv"], limits].concat());
    assert_eq!(status(&checked), 0, "{}{}", stdout(&checked), stderr(&checked));
}

#[test]
fn the_ends_are_those_of_the_path() {
    let folder = moved();
    fs::write(folder.path().join("short.csv"), "x,y,z\n1.7,1,1.7\n1.7,1.2,1.7\n1.5,1,1.7\n").unwrap();
    let output = cdpr_in(folder.path(), &["plan", "moved.toml", "--replan", "short.csv", "--format", "json"]);
    let waypoints = json(&output)["waypoints"].clone();
    assert_eq!(waypoints, serde_json::json!([[1.7, 1.0, 1.7], [1.5, 1.0, 1.7]]), "{}", stderr(&output));
    let proof = ["plan", "moved.toml", "--replan", "short.csv", "--proof", "bound.json"];
    assert_eq!(status(&cdpr_in(folder.path(), &proof)), 0);
    let ends = ["--start", "1.7", "1", "1.7", "--goal", "1.5", "1", "1.7"];
    let checked = cdpr_in(folder.path(), &[&["check", "moved.toml", "bound.json"], &ends[..]].concat());
    assert_eq!(status(&checked), 0, "{}{}", stdout(&checked), stderr(&checked));
}

#[test]
fn turning_paths_and_open_orientations_are_kept() {
    let folder = folder();
    for name in ["turn", "plank"] {
        let scene = testdata(&format!("scenes/{name}.toml"));
        let first = cdpr_in(folder.path(), &["plan", &scene, "-o", "first.json"]);
        assert_eq!(status(&first), 0, "{name}: {}", stderr(&first));
        let again = cdpr_in(folder.path(), &["plan", &scene, "--replan", "first.json", "-o", "again.json"]);
        let told = stdout(&again);
        assert!(told.contains("; the given path, still valid"), "{name}: {told}{}", stderr(&again));
        let checked = cdpr_in(folder.path(), &["check", &scene, "again.json"]);
        assert_eq!(status(&checked), 0, "{name}: {}", stdout(&checked));
    }
}

#[test]
fn what_cannot_be_replanned_is_named() {
    let folder = moved();
    fs::write(folder.path().join("one.csv"), "x,y,z\n1,1,1\n").unwrap();
    let cases = [
        (vec!["--replan", "one.csv"], "one.csv: waypoints: found 1 waypoint, expected at least two"),
        (vec!["--replan", "path.json", "--goal", "1", "1", "1"], "cannot be used with"),
        (vec!["--replan", "path.json", "--via", "1", "1", "1"], "cannot be used with"),
        (vec!["--replan", "path.json", "--maximise", "clearance"], "cannot be used with"),
        (vec!["--replan", "path.json", "-o", "path.json"], "path.json: is an input of this command"),
        (vec!["--replan", "missing.json"], "missing.json"),
        (vec!["--replan", "moved.toml"], "moved.toml"),
    ];
    for (more, expected) in cases {
        let output = cdpr_in(folder.path(), &[&["plan", "moved.toml"][..], &more].concat());
        assert_eq!(status(&output), 2, "{more:?}: {}", stdout(&output));
        assert!(stderr(&output).contains(expected), "{more:?}: {}", stderr(&output));
    }
    let both = cdpr_fed(folder.path(), &["plan", "-", "--replan", "-"], "");
    assert!(stderr(&both).contains("found - for both scene and path"), "{}", stderr(&both));
}
