//! What options and files say together: orientations of paths, options without effect, files of another kind.

use std::fs;
use std::path::Path;
use std::process::Output;

use crate::support::*;

const ALONG: &str = "1,0,0,0";

/// A folder with a path of the plank, which passes lengthwise, as CSV with a quaternion in each row.
fn plank() -> tempfile::TempDir {
    let folder = folder();
    fs::write(folder.path().join("along.csv"), csv(&[ALONG, ALONG])).unwrap();
    fs::write(folder.path().join("turns.csv"), csv(&[ALONG, "0.9961946980917455,0,0,0.08715574274765817"])).unwrap();
    folder
}

/// The straight way of the plank with these quaternions.
fn csv(turns: &[&str; 2]) -> String {
    format!("x,y,z,qw,qx,qy,qz\n0.45,1,0.5,{}\n1.55,1,0.5,{}\n", turns[0], turns[1])
}

fn of_plank(folder: &Path, command: &str, rest: &[&str]) -> Output {
    cdpr_in(folder, &[&[command, &testdata("scenes/plank.toml")][..], rest].concat())
}

#[track_caller]
fn refused(output: &Output, words: &str) {
    assert_eq!((status(output), stdout(output).as_str()), (2, ""), "{}", stderr(output));
    assert!(stderr(output).contains(words), "{}", stderr(output));
}

#[test]
fn a_path_with_quaternions_is_read_at_its_own_orientations() {
    let folder = plank();
    let checked = of_plank(folder.path(), "check", &["along.csv"]);
    assert_eq!(status(&checked), 0, "{}{}", stdout(&checked), stderr(&checked));
    assert!(stdout(&checked).contains("at \"along\"\nvalid: 1.1 m, 2 waypoints\n"), "{}", stdout(&checked));
    let turning = of_plank(folder.path(), "check", &["turns.csv"]);
    assert!(stdout(&turning).contains("valid: 1.1480 m, 2 waypoints, turns by 10.0°") || status(&turning) < 2);
    // An orientation given beside a path must be the path's own.
    for command in ["check", "post", "trajectory"] {
        for file in ["along.csv", "turns.csv"] {
            let limits: &[&str] = if command == "trajectory" { &LIMITS } else { &[] };
            let with = |name| of_plank(folder.path(), command, &[&[file, "--orientation", name][..], limits].concat());
            assert_eq!(status(&with("along")), 0, "{command} {file}: {}", stderr(&with("along")));
            let words = "orientations: found [1.0, 0.0, 0.0, 0.0] at the start, but [0.7071067811865476, 0.0, 0.0, \
                         0.7071067811865475] is given; expected the same orientation, or none to be given";
            refused(&with("across"), words);
        }
    }
}

const LIMITS: [&str; 8] = ["--speed", "1", "--acceleration", "2", "--turn-speed", "1", "--turn-acceleration", "2"];

#[test]
fn paths_with_quaternions_give_consistent_results() {
    let folder = plank();
    for (file, keys) in [("along.csv", 0), ("turns.csv", 1)] {
        assert_eq!(status(&of_plank(folder.path(), "post", &[file, "-o", "shorter.json"])), 0);
        let written: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(folder.path().join("shorter.json")).unwrap()).unwrap();
        assert_eq!(written["orientation_name"], "along");
        assert_eq!(written.get("orientations").iter().count(), keys);
        assert_eq!(status(&of_plank(folder.path(), "check", &["shorter.json"])), 0);
        let timed = of_plank(folder.path(), "trajectory", &[&[file, "-o", "motion.csv"][..], &LIMITS].concat());
        assert_eq!(status(&timed), 0, "{}", stderr(&timed));
        for motion in [&["motion.csv"][..], &["motion.csv", "--orientation", "along"]] {
            let checked = of_plank(folder.path(), "check", motion);
            assert_eq!(status(&checked), 0, "{}{}", stdout(&checked), stderr(&checked));
        }
        assert_eq!(status(&of_plank(folder.path(), "check", &["motion.csv", "--orientation", "across"])), 2);
        assert_eq!(status(&of_plank(folder.path(), "view", &["motion.csv", "-o", "view.html"])), 0);
        assert_eq!(status(&of_plank(folder.path(), "wrench", &["--along", file, "-o", "lengths.csv"])), 0);
    }
}

#[test]
fn the_rule_swept_is_for_all_paths_without_a_turn() {
    let folder = plank();
    // The plank has two cables whose swept triangles meet; the same path without quaternions gets the same answer.
    fs::write(folder.path().join("bare.csv"), "x,y,z\n0.45,1,0.5\n1.55,1,0.5\n").unwrap();
    let swept = |file| of_plank(folder.path(), "check", &[file, "--orientation", "along", "--interference", "swept"]);
    assert_eq!(stdout(&swept("along.csv")), stdout(&swept("bare.csv")));
    assert_eq!(status(&swept("along.csv")), 1);
    refused(&swept("turns.csv"), "--interference: found \"swept\", which is for motions without a turn");
}

#[test]
fn a_page_plays_a_trajectory_from_a_table() {
    let (folder, hard1) = (folder(), testdata("scenes/hard1.toml"));
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", &hard1, "-o", "path.json"])), 0);
    let motion = ["trajectory", &hard1, "path.json", "-o", "motion.csv", "--speed", "1", "--acceleration", "2"];
    assert_eq!(status(&cdpr_in(folder.path(), &motion)), 0);
    let viewed = cdpr_in(folder.path(), &["view", &hard1, "motion.csv", "-o", "view.html", "--format", "json"]);
    assert_eq!(status(&viewed), 0, "{}", stderr(&viewed));
    assert_eq!(json(&viewed)["violations"], serde_json::json!([]));
    // Few columns of any source: lengths of cables are computed.
    fs::write(folder.path().join("few.csv"), "t,x,y,z\n0,0.3,1,0.3\n1,0.3,1,0.8\n").unwrap();
    assert_eq!(status(&cdpr_in(folder.path(), &["view", &hard1, "few.csv", "-o", "view.html"])), 0);
}

#[test]
fn options_that_the_file_leaves_without_effect_are_refused() {
    let (folder, closed) = (plank(), testdata("scenes/closed.toml"));
    let proved = cdpr_in(folder.path(), &["plan", &closed, "--proof", "proof.json"]);
    assert_eq!(status(&proved), 1, "{}", stderr(&proved));
    for option in [&["--strict"][..], &["--engine", "gjk"], &["--interference", "swept"]] {
        let words =
            format!("{}: found with a proof, where it has no effect; expected a path or a trajectory", option[0]);
        refused(&cdpr_in(folder.path(), &[&["check", &closed, "proof.json"][..], option].concat()), &words);
    }
    refused(
        &cdpr_in(folder.path(), &["view", &closed, "proof.json", "-o", "view.html", "--strict"]),
        "--strict: found with a proof",
    );
    for option in [["--post", "both"], ["--step", "0.1"], ["--repeats", "2"]] {
        let words = format!("{}: found with a path on which the platform turns", option[0]);
        refused(&of_plank(folder.path(), "post", &["turns.csv", option[0], option[1]]), &words);
    }
    for option in [["--cable-set", "original"], ["--bodies", "bodies.xml"]] {
        let source = testdata("gazebo/caroca.yaml");
        let words = format!("{}: found with a YAML file, where it has no effect; expected a model of CASPR", option[0]);
        refused(&cdpr_in(folder.path(), &["import", &source, "-o", "robot.toml", option[0], option[1]]), &words);
    }
    assert!(!folder.path().join("robot.toml").exists() && !folder.path().join("view.html").exists());
}

#[test]
fn a_proof_is_no_path() {
    let (folder, closed) = (folder(), testdata("scenes/closed.toml"));
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", &closed, "--proof", "proof.json"])), 1);
    for line in [
        &["post", &closed, "proof.json"][..],
        &["trajectory", &closed, "proof.json"],
        &["wrench", &closed, "--along", "proof.json"],
    ] {
        refused(&cdpr_in(folder.path(), line), "proof.json: found a proof, expected a path");
    }
}

#[test]
fn errors_name_the_option_at_fault() {
    let (folder, hard1) = (folder(), testdata("scenes/hard1.toml"));
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", &hard1, "-o", "path.json"])), 0);
    let cases: [(&[&str], &str); 8] = [
        (&["plan", &hard1, "--orientation", "askew"], "cdpr: --orientation: found \"askew\", expected a quaternion"),
        (&["check", &hard1, "path.json", "--orientation", "askew"], "cdpr: --orientation: found \"askew\""),
        (
            &["plan", &hard1, "--planner", "rrt", "--goal-bias", "4"],
            "cdpr: --goal-bias: found 4, expected a probability",
        ),
        (
            &["trajectory", &hard1, "path.json", "--acceleration", "1", "--wrench-margin", "5"],
            "cdpr: --wrench-margin: found a margin",
        ),
        (
            &["shadows", &hard1, "-o", "s.obj", "--cable", "nope"],
            "cdpr: --cable: found \"nope\", expected one of cable 0",
        ),
        (
            &["shadows", &hard1, "-o", "s.obj", "--all", "--space", "attachment"],
            "cdpr: --space: found \"attachment\" with all",
        ),
        (
            &["wrench", &testdata("scenes/cogiro.toml"), "--grid", "1e-5", "-o", "m.npz"],
            "cdpr: --grid: found 0.00001 m",
        ),
        (&["batch", "trials.toml", "-o", "-"], "cdpr: -: is standard output, expected the name of a folder"),
    ];
    for (line, words) in cases {
        refused(&cdpr_in(folder.path(), line), words);
    }
}

#[test]
fn a_new_scene_is_announced_as_json() {
    let folder = folder();
    let made = cdpr_in(folder.path(), &["new", "hall.toml", "--format", "json"]);
    assert_eq!(json(&made), serde_json::json!({ "output": "hall.toml", "query": true }));
}
