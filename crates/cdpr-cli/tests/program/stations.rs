//! Stations: names in place of positions.

use std::fs;
use std::path::Path;

use crate::support::*;

const STATIONS: &str = "
[[stations]]
name = \"dock\"
position = [0.3, 1.0, 0.3]
[[stations]]
name = \"upper rack\"
position = [1.7, 1.0, 1.7]
[[stations]]
name = \"inside\"
position = [1.0, 1.0, 0.5]
[[stations]]
name = \"turned\"
position = [0.0775, 1.0, 0.3]
orientation = [0.9961946980917455, 0.0, 0.0, 0.08715574274765817]
[[stations]]
name = \"aside\"
position = [0.3, 1.0, 0.3]
orientation = [0.9961946980917455, 0.0, 0.0, 0.08715574274765817]
";

/// A folder with hard1 and stations in it.
fn hall() -> tempfile::TempDir {
    let folder = folder();
    let hard1 = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    fs::write(folder.path().join("hall.toml"), hard1 + STATIONS).unwrap();
    folder
}

fn run(folder: &Path, args: &[&str]) -> std::process::Output {
    cdpr_in(folder, args)
}

#[test]
fn names_stand_for_positions() {
    let folder = hall();
    let planned = |ends: &[&str]| {
        let output = run(folder.path(), &[&["plan", "hall.toml", "--format", "json"][..], ends].concat());
        assert_eq!(status(&output), 0, "{}", stderr(&output));
        json(&output)["waypoints"].clone()
    };
    let by_place = planned(&["--start", "1.7", "1", "1.7", "--goal", "0.3", "1", "0.3"]);
    assert_eq!(planned(&["--start", "upper rack", "--goal", "dock"]), by_place);
    assert_eq!(planned(&["--start=upper rack", "--goal=dock"]), by_place);
    assert_eq!(planned(&["--start", "1.7", "1", "1.7", "--goal", "dock"]), by_place);
    // In front of the scene, a name needs the equals sign.
    let first = run(folder.path(), &["plan", "--goal=dock", "--start=upper rack", "hall.toml", "--format", "json"]);
    assert_eq!(json(&first)["waypoints"], by_place, "{}", stderr(&first));
    let turning = ["plan", "hall.toml", "--start", "0.3", "1", "0.8", "--goal=aside", "--seed", "1"];
    let turning = run(folder.path(), &turning);
    assert!(stdout(&turning).contains("turn"), "{}{}", stdout(&turning), stderr(&turning));
}

#[test]
fn a_position_to_check_may_be_a_station() {
    let folder = hall();
    let at = |command: &str, at: &[&str]| run(folder.path(), &[&[command, "hall.toml", "--at"][..], at].concat());
    assert_eq!(stdout(&at("check", &["dock"])), stdout(&at("check", &["0.3", "1", "0.3"])));
    let inside = at("check", &["inside"]);
    assert_eq!(status(&inside), 1);
    assert!(stdout(&inside).contains("not valid: the platform at (1, 1, 0.5)"), "{}", stdout(&inside));
    let margins = |place: &[&str]| stdout(&at("wrench", place));
    assert_eq!(margins(&["upper rack"]), margins(&["1.7", "1", "1.7"]));
    // By the wall there is room for the platform, but not if it is turned by 10°.
    assert_eq!([status(&at("check", &["0.0775", "1", "0.3"])), status(&at("check", &["turned"]))], [0, 1]);
    let level = ["turned", "--orientation", "1,0,0,0"];
    assert_eq!(status(&at("check", &level)), 0, "an orientation that is given takes precedence");
    let info = stdout(&run(folder.path(), &["info", "hall.toml"]));
    assert!(info.contains("5 stations: 2 not valid\nstation inside is not valid: "), "{info}");
}

#[test]
fn bad_positions_are_named() {
    let folder = hall();
    for (args, words) in [
        (
            &["--start", "dok"][..],
            "--start: found \"dok\", expected a position [x, y, z] or one of the scene's stations",
        ),
        (&["--start", "dok"], "did you mean \"dock\"?"),
        (&["--start", "1", "2"], "--start: found 1 2, expected X Y Z, or the name of a station, as in --start=rack"),
        (&["--goal", "1"], "--goal: found 1, expected X Y Z"),
        (&["--goal", "1", "x", "2"], "--goal: found 1 x 2, expected X Y Z"),
        (&["--goal", "nan", "1", "2"], "--goal: found NaN"),
        (&["--goal", "inf"], "--goal: found inf, expected X Y Z"),
    ] {
        let output = run(folder.path(), &[&["plan", "hall.toml"][..], args].concat());
        assert_eq!((status(&output), stdout(&output).as_str()), (2, ""), "{args:?}");
        assert!(stderr(&output).contains(words), "{args:?}: {}", stderr(&output));
    }
}

#[test]
fn proofs_between_stations_are_checked_by_name() {
    let folder = hall();
    let ends = ["--start", "dock", "--goal=upper rack"];
    let planned = run(folder.path(), &[&["plan", "hall.toml", "--proof", "proof.json"][..], &ends].concat());
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    let check = |ends: &[&str]| run(folder.path(), &[&["check", "hall.toml", "proof.json"][..], ends].concat());
    assert_eq!(status(&check(&ends)), 0, "{}", stderr(&check(&ends)));
    assert_ne!(status(&check(&["--start", "dock", "--goal", "inside"])), 0);
}

const THREE: [&str; 2] = ["--stations", "dock,upper rack,aside"];

#[test]
fn a_tour_is_planned_written_and_checked() {
    let folder = hall();
    let tour = |rest: &[&str]| run(folder.path(), &[&["tour", "hall.toml"][..], rest].concat());
    let stations = ["--stations", "dock,upper rack"];
    let files = ["-o", "tour.json", "--matrix", "lengths.csv", "--html", "tour.html"];
    let output = tour(&[&stations[..], &files].concat());
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    let text = stdout(&output);
    assert!(text.contains("\ntour: 2.435") && text.contains("\n  dock to upper rack: 2.435"), "{text}");
    assert!(text.contains("no tour is shorter than "), "{text}");
    let file: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("tour.json")).unwrap()).unwrap();
    assert_eq!(file["tour"]["order"], serde_json::json!(["dock", "upper rack"]));
    let matrix = fs::read_to_string(folder.path().join("lengths.csv")).unwrap();
    assert!(matrix.starts_with("m,dock,upper rack\ndock,0,2.435"), "{matrix}");
    assert!(fs::read_to_string(folder.path().join("tour.html")).unwrap().contains("cdpr-data"));
    let checked = run(folder.path(), &["check", "hall.toml", "tour.json", "--strict"]);
    assert_eq!(status(&checked), 0, "{}", stderr(&checked));
    let timed = ["trajectory", "hall.toml", "tour.json", "--speed", "1", "--acceleration", "2", "-o", "motion.csv"];
    assert_eq!(status(&run(folder.path(), &timed)), 0);

    let json = json(&tour(&[&stations[..], &["--return", "--start", "upper rack", "--format", "json", "-q"]].concat()));
    assert_eq!(json["tour"]["order"], serde_json::json!(["upper rack", "dock", "upper rack"]));
    assert_eq!(json["waypoints"].as_array().unwrap().len(), 5);
    let streamed = tour(&[&stations[..], &["-o", "-", "-q"]].concat());
    assert!(stdout(&streamed).starts_with('{'), "{}", stdout(&streamed));
    let turning = tour(&THREE);
    assert!(status(&turning) == 0 && stdout(&turning).contains("dock to aside: "), "{}", stdout(&turning));
}

#[test]
fn a_tour_that_is_not_possible_says_why() {
    let folder = hall();
    let tour = |rest: &[&str]| run(folder.path(), &[&["tour", "hall.toml"][..], rest].concat());
    let blocked = tour(&["--stations", "dock,inside", "--html", "tour.html"]);
    assert_eq!(status(&blocked), 1);
    let text = stdout(&blocked);
    assert!(text.contains("no tour: the 2 stations cannot all be visited\n"), "{text}");
    assert!(text.contains("  dock to inside: the second of them is not valid\n"), "{text}");
    assert!(stderr(&blocked).contains("tour.html was not written: there is no tour"), "{}", stderr(&blocked));
    assert!(!folder.path().join("tour.html").exists());
    for (args, words) in [
        (&["--stations", "dock,dok"][..], "--stations: found \"dok\", expected"),
        (&["--stations", "dock"], "--stations: found one, expected at least two"),
        (
            &["--stations", "dock,upper rack", "--start", "aside"],
            "--start: found \"aside\", expected one of the stations",
        ),
        (&["--gap", "0"], "--gap"),
        (&["-o", "tour.html"], "expected .json or .csv"),
        (&["--matrix", "lengths.json"], "expected .csv"),
        (&["-o", "-", "--matrix", "-"], "found - for more than one"),
        (&["--order", "worst"], "worst"),
        (&["--threads", "0"], "--threads"),
    ] {
        let output = tour(args);
        assert_eq!((status(&output), stdout(&output).as_str()), (2, ""), "{args:?}");
        assert!(stderr(&output).contains(words), "{args:?}: {}", stderr(&output));
    }
    let hard1 = run(folder.path(), &["tour", &testdata("scenes/hard1.toml")]);
    assert!(status(&hard1) == 2 && stderr(&hard1).contains("stations: found none"), "{}", stderr(&hard1));
    let open = run(folder.path(), &["tour", &testdata("scenes/plank.toml")]);
    assert!(status(&open) == 2 && stderr(&open).contains("orientation: found a scene"), "{}", stderr(&open));
}
