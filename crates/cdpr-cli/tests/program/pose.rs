//! Poses from cable lengths, and plans that start from them.

use std::fs;
use std::path::Path;

use cdpr_core::geometry::{Pose, Rotation, Vector, wxyz};
use cdpr_core::kinematics::cable_lengths;
use cdpr_core::{Point, Robot};
use serde_json::Value;

use crate::support::*;

const HERE: Point = Point::new(0.4, -0.3, 2.0);

fn cogiro() -> Robot {
    cdpr_files::load_robot(testdata("robots/cogiro.toml")).unwrap()
}

fn tilted() -> Pose {
    Pose::new(HERE, Rotation::from_scaled_axis(Vector::new(0.05, 0.1, -0.2)))
}

fn row(robot: &Robot, pose: &Pose) -> String {
    let lengths = cable_lengths(robot, &pose.orientation, &pose.position);
    lengths.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n"
}

fn numbers(json: &Value) -> Vec<f64> {
    json.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn near(json: &Value, right: &[f64], most: f64) {
    let found = numbers(json);
    assert!(found.len() == right.len() && found.iter().zip(right).all(|(a, b)| (a - b).abs() <= most), "{found:?}");
}

/// The start of a plan as JSON.
fn start(plan: &Value) -> &Value {
    &plan["waypoints"][0]
}

#[test]
fn the_pose_comes_back_from_files_and_standard_input_in_any_order_of_columns() {
    let (folder, robot) = (folder(), cogiro());
    let text = row(&robot, &tilted());
    let cells: Vec<&str> = text.trim().split(',').collect();
    let header: Vec<String> = (0..8).rev().map(|k| format!("length:cable {k}")).collect();
    let reversed: Vec<&str> = cells.iter().rev().copied().collect();
    let named = format!("t,{}\n0.1,{}\n", header.join(","), reversed.join(","));
    fs::write(folder.path().join("lengths.csv"), &named).unwrap();
    let command = ["pose", &testdata("robots/cogiro.toml"), "lengths.csv", "--format", "json"];
    let of_file = json(&cdpr_in(folder.path(), &command));
    assert_eq!((&of_file["robot"], &of_file["poses"][0]["line"]), (&robot.name().into(), &2.into()));
    let of_stream = json(&cdpr_fed(folder.path(), &[&command[..2], &["-", "--format", "json", "-q"]].concat(), &text));
    for found in [&of_file["poses"][0], &of_stream["poses"][0]] {
        near(&found["position"], HERE.coords.as_slice(), 1e-9);
        near(&found["orientation"], &wxyz(&tilted().orientation), 1e-9);
        near(&found["residuals"], &[0.0; 8], 1e-9);
        assert_eq!(
            (&found["rank"], &found["full_rank"], &found["others"]),
            (&6.into(), &6.into(), &Value::Array(vec![]))
        );
        assert_eq!(found["covariance"].as_array().unwrap().len(), 6);
    }
    let known = json(&cdpr_fed(
        folder.path(),
        &["pose", &testdata("robots/cogiro.toml"), "-", "--orientation", "1,0,0,0", "--format", "json"],
        &row(&robot, &Pose::new(HERE, Rotation::identity())),
    ));
    near(&known["poses"][0]["position"], HERE.coords.as_slice(), 1e-9);
    assert_eq!((&known["poses"][0]["rank"], &known["poses"][0]["full_rank"]), (&3.into(), &3.into()));
}

#[test]
fn poses_are_written_as_a_path() {
    let (folder, robot) = (folder(), cogiro());
    let rows: String = [0.0, 0.01, 0.02]
        .iter()
        .map(|x| row(&robot, &Pose::new(HERE + Vector::x() * *x, Rotation::identity())))
        .collect();
    let command = ["pose", &testdata("robots/cogiro.toml"), "-", "-o"];
    let done = cdpr_fed(folder.path(), &[&command[..], &["driven.csv", "-q"]].concat(), &rows);
    assert_eq!((status(&done), stderr(&done).as_str()), (0, ""));
    let path = cdpr_files::load_waypoints(folder.path().join("driven.csv")).unwrap();
    assert!((path.waypoints[2] - HERE - Vector::x() * 0.02).norm() < 1e-9 && path.orientations.unwrap().len() == 3);
    let streamed = cdpr_fed(folder.path(), &[&command[..], &["-"]].concat(), &rows);
    assert_eq!(json(&streamed)["waypoints"].as_array().unwrap().len(), 3);
    assert!(stderr(&streamed).contains("line 1: (0.4, -0.3, 2) at 1,0,0,0, residuals up to 0.000 µm"));
    let itself = cdpr_in(folder.path(), &["pose", &testdata("robots/cogiro.toml"), "driven.csv", "-o", "driven.csv"]);
    assert!(status(&itself) == 2 && stderr(&itself).contains("is an input of this command"), "{}", stderr(&itself));
}

#[test]
fn lengths_that_leave_the_pose_open_have_status_1() {
    let paper = ["pose", &testdata("robots/paper.toml"), "-"];
    let robot = cdpr_files::load_robot(paper[1]).unwrap();
    let middle = row(&robot, &Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::identity()));
    let open = cdpr_fed(Path::new("."), &paper, &middle);
    assert_eq!(status(&open), 1);
    assert!(stderr(&open).contains("note: line 1: rank 5 of 6, so the lengths do not determine the pose\n"));
    let twice = json(&cdpr_fed(Path::new("."), &[&paper[..], &["--format", "json"]].concat(), &middle.repeat(2)));
    assert_eq!((&twice["poses"][0]["covariance"], &twice["poses"][1]["line"]), (&Value::Null, &2.into()));
}

#[test]
fn bad_lengths_name_file_line_and_cable() {
    let robot = testdata("robots/cogiro.toml");
    let said = |rest: &[&str], text: &str| {
        let output = cdpr_fed(Path::new("."), &[&["pose", &robot][..], rest].concat(), text);
        assert_eq!((status(&output), stdout(&output).as_str()), (2, ""));
        stderr(&output)
    };
    for (text, expected) in [
        ("", "standard input: found no rows, expected at least one"),
        ("1,2\n", "standard input: line 1: found 2 values, expected 8"),
        ("9,9,9,9,9,9,9,9\n9,9,9,0,9,9,9,9\n", "standard input: line 2, cable 3: found a length of 0 m, expected"),
        ("9,9,9,-1,9,9,9,9\n", "standard input: line 1, cable 3: found a length of -1 m, expected"),
        ("9,9,9,nan,9,9,9,9\n", "standard input: line 1, cable 3: found \"nan\", expected a number"),
        ("length:cable 0\n9\n", "standard input: header: found no column length:cable 1, expected every cable"),
        (
            "4978,5644,7742,1.7,0.03,1e-4,65,301\n",
            "standard input: line 1: found no pose after 200 iterations: the root mean square",
        ),
    ] {
        let found = said(&["-"], text);
        assert!(found.starts_with(&format!("cdpr: {expected}")), "{found}\nexpected {expected}");
    }
    assert!(said(&["-", "--guess", "nan", "0", "0"], "9,9,9,9,9,9,9,9\n").contains("--guess: found NaN"));
    assert!(said(&["-", "--orientation", "level"], "").contains("expected four numbers, W,X,Y,Z"));
    assert!(said(&["-", "--orientation", "1,1,0,0"], "").contains("expected length 1"));
    let both = cdpr_fed(Path::new("."), &["pose", "-", "-"], "");
    assert!(stderr(&both).contains("found - for both robot and lengths"), "{}", stderr(&both));
}

#[test]
fn a_plan_starts_where_the_lengths_are_those_given() {
    let folder = folder();
    let scene = testdata("scenes/hard1.toml");
    let robot = cdpr_files::load_scene(&scene).unwrap().robot().clone();
    let there = Pose::new(Point::new(0.4, 0.9, 0.5), Rotation::identity());
    fs::write(folder.path().join("now.csv"), row(&robot, &there)).unwrap();
    let plan =
        |rest: &[&str]| cdpr_in(folder.path(), &[&["plan", &scene, "--start-lengths", "now.csv"][..], rest].concat());
    let found = plan(&["--format", "json"]);
    near(start(&json(&found)), &[0.4, 0.9, 0.5], 1e-9);
    assert!(stderr(&found).contains("start from lengths: (0.4, 0.9, 0.5) at 1,0,0,0, residuals up to "));
    assert_eq!(stderr(&plan(&["-q"])), "");
    let streamed = ["plan", &scene, "--start-lengths", "-", "--format", "json"];
    near(start(&json(&cdpr_fed(folder.path(), &streamed, &row(&robot, &there)))), &[0.4, 0.9, 0.5], 1e-9);
    let given = plan(&["--start", "0", "0", "0"]);
    assert!(status(&given) == 2 && stderr(&given).contains("cannot be used with"), "{}", stderr(&given));
    let both = cdpr_fed(folder.path(), &["plan", "-", "--start-lengths", "-"], "");
    assert!(stderr(&both).contains("found - for both scene and lengths"), "{}", stderr(&both));
    let itself = plan(&["-o", "now.csv"]);
    assert!(stderr(&itself).contains("is an input of this command"), "{}", stderr(&itself));
}

#[test]
fn lengths_that_do_not_give_a_start_are_refused() {
    let said = |scene: &str, text: &str, rest: &[&str]| {
        let scene = testdata(scene);
        let output = cdpr_fed(Path::new("."), &[&["plan", &scene, "--start-lengths", "-"][..], rest].concat(), text);
        assert_eq!((status(&output), stdout(&output).as_str()), (2, ""), "{}", stderr(&output));
        stderr(&output)
    };
    let robot = cdpr_files::load_robot(testdata("robots/paper.toml")).unwrap();
    let there = Pose::new(Point::new(0.4, 0.9, 0.5), Rotation::identity());
    let two = said("scenes/hard1.toml", &row(&robot, &there).repeat(2), &[]);
    assert!(two.contains("standard input: found 2 rows, expected one: the lengths at the start"), "{two}");
    // One cable 50 mm longer than the others allow.
    let text = row(&robot, &there);
    let (first, rest) = text.split_once(',').unwrap();
    let long = format!("{},{rest}", first.parse::<f64>().unwrap() + 0.05);
    let far = said("scenes/hard1.toml", &long, &[]);
    assert!(
        far.contains("--start-lengths: found a length of cable 0 that is ") && far.contains(" too long at"),
        "{far}"
    );
    assert!(far.ends_with("; expected at most 10.000 mm\n"), "{far}");
    // A platform that may turn: its orientation needs six cables, and is not determined in the middle of the paper's.
    let turning = said("../crates/cdpr-cli/tests/snapshots/files/turning.toml", "1,1,1,1\n", &[]);
    assert!(turning.contains("robot.cables: found 4 cables, expected at least 6"), "{turning}");
    assert!(turning.ends_with("; or pass --start-orientation\n"), "{turning}");
    let middle = row(&robot, &Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::identity()));
    let open =
        said("scenes/hard1.toml", &middle, &["--goal-orientation", "0.9961946980917455,0,0,0.08715574274765817"]);
    assert!(open.contains("found lengths that do not determine the start: rank 5 of 6"), "{open}");
}

/// Four cables, and two orientations of which none is selected.
const TWO_ORIENTATIONS: &str = r#"
version = 1
[workspace]
min = [0, 0, 0]
max = [2, 2, 2]
[robot]
platform = [{ box = [0.6, 0.08, 0.08] }]
cables = [
    { outlet = [0, 0, 2], attachment = [-0.3, -0.04, 0.04] },
    { outlet = [2, 0, 2], attachment = [0.3, -0.04, 0.04] },
    { outlet = [2, 2, 2], attachment = [0.3, 0.04, 0.04] },
    { outlet = [0, 2, 2], attachment = [-0.3, 0.04, 0.04] },
]
[[orientations]]
name = "level"
[[orientations]]
name = "turned"
rpy_degrees = [0, 0, 20]
[query]
goal = [1.1, 1, 1]
"#;

#[test]
fn at_an_open_orientation_the_lengths_choose_it() {
    let folder = folder();
    fs::write(folder.path().join("scene.toml"), TWO_ORIENTATIONS).unwrap();
    let scene = cdpr_files::load_scene(folder.path().join("scene.toml")).unwrap();
    let position = Point::new(0.9, 1.1, 0.8);
    for (name, orientation) in scene.orientations() {
        let text = row(scene.robot(), &Pose::new(position, *orientation));
        let command = ["plan", "scene.toml", "--start-lengths", "-", "--format", "json"];
        let found = cdpr_fed(folder.path(), &command, &text);
        assert_eq!(json(&found)["orientation_name"], name.as_str());
        near(start(&json(&found)), position.coords.as_slice(), 1e-9);
        // Outlets in a plane: the mirror image fits as well.
        assert!(stderr(&found).contains("note: the lengths also fit (0.9, 1.1, 3.12) at"), "{}", stderr(&found));
        let other = if name == "level" { "turned" } else { "level" };
        let refused = cdpr_fed(folder.path(), &[&command[..4], &["--orientation", other]].concat(), &text);
        assert!(stderr(&refused).contains("expected at most 10.000 mm"), "{}", stderr(&refused));
    }
}

#[test]
fn lengths_that_fit_at_several_orientations_are_refused() {
    let folder = folder();
    let tilted = TWO_ORIENTATIONS.replace("[0, 0, 20]", "[0, 20, 0]"); // seen from aside, two cables and three unknowns
    fs::write(folder.path().join("scene.toml"), tilted).unwrap();
    let scene = cdpr_files::load_scene(folder.path().join("scene.toml")).unwrap();
    let text = row(scene.robot(), &Pose::new(Point::new(0.9, 1.1, 0.8), Rotation::identity()));
    let refused = cdpr_fed(folder.path(), &["plan", "scene.toml", "--start-lengths", "-"], &text);
    assert_eq!(status(&refused), 2);
    assert!(stderr(&refused).contains("found lengths that fit at "), "{}", stderr(&refused));
    assert!(stderr(&refused).ends_with("expected one of these; use --orientation NAME\n"), "{}", stderr(&refused));
}

#[test]
fn a_platform_that_may_turn_starts_at_the_orientation_of_its_lengths() {
    let scene = testdata("scenes/hard1_rank6.toml");
    let robot = cdpr_files::load_scene(&scene).unwrap().robot().clone();
    let there = Pose::new(Point::new(0.4, 0.9, 0.5), Rotation::from_scaled_axis(Vector::new(0.02, 0.0, 0.1)));
    let goal = ["--goal", "0.5", "0.9", "0.6", "--goal-orientation", "0.9999,0.0141417821,0,0"];
    let command = [&["plan", &scene, "--start-lengths", "-", "--format", "json"][..], &goal].concat();
    let text = row(&robot, &there);
    let found = json(&cdpr_fed(Path::new("."), &command, &text));
    near(start(&found), there.position.coords.as_slice(), 1e-9);
    near(&found["orientations"][0], &wxyz(&there.orientation), 1e-9);
    let known = wxyz(&there.orientation).map(|x| x.to_string()).join(",");
    let found = json(&cdpr_fed(Path::new("."), &[&command[..], &["--start-orientation", &known]].concat(), &text));
    near(start(&found), there.position.coords.as_slice(), 1e-9);
    near(&found["orientations"][0], &wxyz(&there.orientation), 1e-9);
}
