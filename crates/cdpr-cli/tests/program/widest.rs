//! The widest path from the command line: answers, files, and options that meet it.

use std::fs;
use std::path::Path;
use std::process::Output;

use crate::support::*;
use cdpr_core::testing::walled;
use cdpr_core::{QuerySpec, SceneSpec};

const MAXIMISE: [&str; 3] = ["plan", "scene.json", "--maximise"];

/// A scene in which the platform passes between a wall and the ceiling with 0.1 m on the way.
fn spec() -> SceneSpec {
    SceneSpec { query: Some(QuerySpec::between([0.3, 1.0, 0.6], [1.7, 1.0, 0.6])), ..walled(1.05) }
}

fn place() -> tempfile::TempDir {
    let folder = folder();
    fs::write(folder.path().join("scene.json"), serde_json::to_string(&spec()).unwrap()).unwrap();
    folder
}

fn widest(folder: &Path, rest: &[&str]) -> Output {
    cdpr_in(folder, &[&MAXIMISE[..], &["clearance"], rest].concat())
}

#[track_caller]
fn read(folder: &Path, file: &str) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(folder.join(file)).unwrap()).unwrap()
}

#[test]
fn the_answer_says_how_wide_paths_can_be() {
    let folder = place();
    let told = widest(folder.path(), &["-o", "path.json", "--html", "view.html", "--proof", "proof.json"]);
    assert_eq!(status(&told), 0, "{}", stderr(&told));
    let line = stdout(&told).lines().find(|line| line.starts_with("widest: ")).unwrap().to_string();
    assert!(line.contains(" mm from obstacles; no path keeps 100."), "{line}");
    assert!(stdout(&told).contains("% longer than the shortest"), "{}", stdout(&told));
    let path = read(folder.path(), "path.json");
    let [kept, none_above] = ["clearance", "none_above"].map(|key| path["widest"][key].as_f64().unwrap());
    assert!(kept <= 0.1 + 1e-8 && none_above >= 0.1 && none_above - kept <= 1e-3, "{line}");
    assert_eq!(path["min_clearance"]["value"].as_f64(), Some(kept));
    let checked = cdpr_in(folder.path(), &["check", "scene.json", "path.json", "--strict", "--format", "json"]);
    assert_eq!((status(&checked), json(&checked)["min_clearance"]["value"].as_f64()), (0, Some(kept)));
    assert!(folder.path().join("view.html").exists());
    // The certificate is about the scene with that clearance.
    assert!(stderr(&told).contains(&format!("there is no path with clearance = {none_above}")), "{}", stderr(&told));
    let wider = cdpr_core::Scene::new(spec()).unwrap().with_obstacle_clearance(none_above).unwrap();
    fs::write(folder.path().join("wider.json"), serde_json::to_string(wider.spec()).unwrap()).unwrap();
    let proved = cdpr_in(folder.path(), &["check", "wider.json", "proof.json"]);
    assert_eq!(status(&proved), 0, "{}{}", stdout(&proved), stderr(&proved));
    assert_eq!(status(&cdpr_in(folder.path(), &["check", "scene.json", "proof.json"])), 2);
}

#[test]
fn an_end_that_keeps_no_more_is_named() {
    let folder = place();
    let told = widest(folder.path(), &["--start", "1", "1", "0.95", "--proof", "proof.json"]);
    assert!(
        stdout(&told).contains("keeps 25.000 mm from obstacles; no path keeps 25.001 mm, since the start does not")
    );
    assert!(stderr(&told).contains("proof.json was not written: no certificate of the width, since the start itself"));
    assert!(!folder.path().join("proof.json").exists());
}

#[test]
fn the_widest_path_meets_the_other_options() {
    let folder = place();
    let quiet = widest(folder.path(), &["-q", "-o", "path.csv"]);
    assert_eq!((status(&quiet), stderr(&quiet).as_str()), (0, ""));
    let fed = cdpr_fed(
        folder.path(),
        &["plan", "-", "--maximise", "clearance", "--format", "json"],
        &serde_json::to_string(&spec()).unwrap(),
    );
    assert!(json(&fed)["widest"]["clearance"].as_f64().is_some_and(|kept| kept > 0.099), "{}", stderr(&fed));
    for rest in [
        &["--planner", "two-trees"][..],
        &["--planner", "rrt-connect", "--post", "none", "--seed", "3"],
        &["--budget-ms", "300"],
        &["--engine", "gjk"],
        &["--trajectory", "motion.json", "--speed", "1", "--acceleration", "2"],
        &["--max-samples", "2000"],
    ] {
        let told = widest(folder.path(), &[&["-o", "path.json"][..], rest].concat());
        assert_eq!(status(&told), 0, "{rest:?}: {}", stderr(&told));
        assert!(stdout(&told).contains("widest: keeps "), "{rest:?}: {}", stdout(&told));
        assert_eq!(status(&cdpr_in(folder.path(), &["check", "scene.json", "path.json"])), 0, "{rest:?}");
    }
    assert!(folder.path().join("motion.json").exists());
    // No path: the usual answer.
    let none = cdpr(&["plan", &testdata("scenes/closed.toml"), "--maximise", "clearance"]);
    assert_eq!(status(&none), 1);
    assert!(stdout(&none).contains("no path exists: ") && !stdout(&none).contains("widest"), "{}", stdout(&none));
    // The best orientation.
    let plank = cdpr(&["plan", &testdata("scenes/plank.toml"), "--maximise", "clearance"]);
    assert!(stdout(&plank).contains("widest: keeps 225.000 mm"), "{}", stdout(&plank));
}

#[test]
fn motions_along_a_saved_path_keep_its_width() {
    let folder = folder();
    let scene = testdata("scenes/hard3.toml");
    let told = cdpr_in(folder.path(), &["plan", &scene, "--maximise", "clearance", "-o", "wide.json"]);
    assert_eq!(status(&told), 0, "{}", stderr(&told));
    let mut path = read(folder.path(), "wide.json");
    let width = path["widest"]["clearance"].as_f64().unwrap();
    let scene_itself = cdpr_files::load_scene(&scene).unwrap();
    let wider = scene_itself.with_obstacle_clearance(width - 2e-6).unwrap();
    fs::write(folder.path().join("wider.json"), serde_json::to_string(wider.spec()).unwrap()).unwrap();
    let timed = |path: &str| {
        let limits = ["--speed", "1", "--acceleration", "1", "--blend", "0.3", "-o", "motion.json"];
        cdpr_in(folder.path(), &[&["trajectory", &scene, path][..], &limits].concat())
    };
    let keeps_width = |path: &str| {
        let told = timed(path);
        assert_eq!(status(&told), 0, "{path}: {}", stderr(&told));
        status(&cdpr_in(folder.path(), &["check", "wider.json", "motion.json"])) == 0
    };
    assert!(keeps_width("wide.json"));
    // Of this file no width is known.
    let rows: Vec<String> = path["waypoints"].as_array().unwrap().iter().map(|row| row.to_string()).collect();
    let rows = rows.iter().map(|row| row.trim_matches(['[', ']'])).collect::<Vec<_>>().join("\n");
    fs::write(folder.path().join("wide.csv"), format!("x,y,z\n{rows}\n")).unwrap();
    assert!(!keeps_width("wide.csv"));
    // The width was that of another scene.
    path["scene"]["fingerprint"] = serde_json::json!("0");
    fs::write(folder.path().join("other.json"), path.to_string()).unwrap();
    assert!(!keeps_width("other.json"));
    // A width that the path does not have.
    path["scene"]["fingerprint"] = serde_json::json!(scene_itself.fingerprint());
    path["widest"]["clearance"] = serde_json::json!(width + 1e-3);
    fs::write(folder.path().join("claimed.json"), path.to_string()).unwrap();
    let refused = timed("claimed.json");
    assert_eq!(status(&refused), 2);
    let words = ["claimed.json: waypoints", "the motion is to keep 26.709 mm from obstacles, the width of the path"];
    assert!(words.iter().all(|words| stderr(&refused).contains(words)), "{}", stderr(&refused));
    path["widest"]["clearance"] = serde_json::json!("wide");
    fs::write(folder.path().join("damaged.json"), path.to_string()).unwrap();
    let refused = timed("damaged.json");
    assert_eq!(status(&refused), 2);
    assert!(stderr(&refused).contains("widest.clearance"), "{}", stderr(&refused));
}

#[test]
fn questions_without_an_answer_are_refused_by_name() {
    let refused = |scene: &str, rest: &[&str], words: &str| {
        let file = testdata(&format!("scenes/{scene}.toml"));
        let told = cdpr(&[&["plan", &file, "--maximise", "clearance"][..], rest].concat());
        assert_eq!((status(&told), stdout(&told).as_str()), (2, ""), "{scene}");
        assert!(stderr(&told).contains(words), "{}", stderr(&told));
    };
    refused("turn", &[], "--maximise: found a platform that may turn on its way");
    refused("empty", &[], "--maximise: found no pair with an obstacle");
    refused("hard1", &["--no-proof"], "cannot be used with '--no-proof'");
    refused("hard1", &["--minimise", "time", "--trajectory", "m.csv"], "cannot be used with '--m");
    let unknown = cdpr(&["plan", &testdata("scenes/hard1.toml"), "--maximise", "speed"]);
    assert!(status(&unknown) == 2 && stderr(&unknown).contains("possible values: clearance"), "{}", stderr(&unknown));
}

#[test]
fn what_ran_out_is_said() {
    let hard1 = testdata("scenes/hard1.toml");
    let found = cdpr(&["plan", &hard1, "--max-samples", "0", "--budget-ms", "60000"]);
    assert!(status(&found) == 1 && !stdout(&found).contains("compiled"), "{}", stdout(&found));
    let none = cdpr(&["workspace", &hard1, "--budget-ms", "0.0001"]);
    assert_eq!(status(&none), 1, "{}", stderr(&none));
    assert!(stdout(&none).starts_with("nothing is proved: the time budget ran out"), "{}", stdout(&none));
    let one = cdpr(&["workspace", &hard1, "--resolution", "5"]);
    assert!(stdout(&one).contains(", 1 box, "), "{}", stdout(&one));
}
