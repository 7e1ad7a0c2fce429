//! What `cdpr` reports on cables: lengths and tensions by name, and which motions they resist.

use std::fs;

use crate::support::*;

const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]];

/// A scene around four cables from the corners of the ceiling to those of a box, with more for each and for the robot.
fn four_cables(of_each: &str, of_robot: &str, rest: &str) -> String {
    let cable = |(k, [x, y]): (usize, &[f64; 2])| {
        let (a, b) = (0.2 * (x / 3.0 - 1.0), 0.2 * (y / 2.0 - 1.0));
        let name = k + 1;
        format!("{{ name = \"winch {name}\", outlet = [{x}, {y}, 3], attachment = [{a}, {b}, 0.1]{of_each} }}")
    };
    let cables: Vec<String> = CORNERS.iter().enumerate().map(cable).collect();
    format!(
        "version = 1\nworkspace = {{ min = [0, 0, 0], max = [6, 4, 3] }}\n{rest}\n[robot]\n{of_robot}\n\
         platform = [{{ box = [0.4, 0.4, 0.2] }}]\ncables = [{}]\n",
        cables.join(", ")
    )
}

#[test]
fn winches_are_in_tables_as_far_as_they_are_known() {
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let drum = ", drum = { radius = 0.5, gear = 2, zero = 1 }";
    let both = format!("{drum}, tension = [5, 500], stiffness = 1e5");
    write("drums.toml", &four_cables(drum, "", ""));
    write("stiff.toml", &four_cables(&both, "mass = 20", ""));
    write("path.csv", PATH);
    let along = |scene: &str, expected: i32| {
        let done = cdpr_in(folder.path(), &["wrench", scene, "--along", "path.csv", "--step", "1", "-q"]);
        assert_eq!((status(&done), stderr(&done)), (expected, String::new()));
        let text = stdout(&done);
        let names: Vec<String> = text.lines().next().unwrap().split(',').map(str::to_string).collect();
        let row: Vec<f64> = text.lines().last().unwrap().split(',').map(|x| x.parse().unwrap_or(f64::NAN)).collect();
        move |name: &str| names.iter().position(|other| other == name).map(|k| row[k])
    };
    // Lengths alone give angles, four times the length beyond 1 m.
    let lengths = along("drums.toml", 0);
    let (length, angle) = (lengths("length:winch 3").unwrap(), lengths("angle:winch 3").unwrap());
    assert!((angle - 4.0 * (length - 1.0)).abs() < 1e-12 && lengths("torque:winch 3").is_none());
    let all = along("stiff.toml", 1); // the four cables balance the weight only in the middle, at the end
    let of = |name: &str| all(&format!("{name}:winch 2")).unwrap();
    assert!((of("command") * (1.0 + of("tension") / 1e5) - of("length")).abs() < 1e-12, "{}", of("command"));
    assert!((of("angle") - 4.0 * (of("command") - 1.0)).abs() < 1e-12);
    assert!((of("torque") - 0.25 * of("tension")).abs() < 1e-12);
}

const PATH: &str = "x,y,z\n1,1,1\n3,2,1\n";

#[test]
fn lengths_along_a_path_need_no_tension_limits() {
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("bare.toml", &four_cables("", "", ""));
    write("limits.toml", &four_cables(", tension = [5, 500]", "mass = 20", ""));
    write("path.csv", PATH);
    let run = |arguments: &[&str]| cdpr_in(folder.path(), arguments);
    let bare = run(&["wrench", "bare.toml", "--along", "path.csv", "--step", "1"]);
    assert_eq!(status(&bare), 0, "{}", stderr(&bare));
    assert!(stderr(&bare).contains("lengths only: bare.toml: robot.mass: found none"), "{}", stderr(&bare));
    let header = stdout(&bare).lines().next().unwrap().to_string();
    assert!(header.starts_with("s,x,y,z,length:winch 1,length:winch 2,"), "{header}");
    assert!(!header.contains("tension"), "{header}");
    let last: Vec<f64> = stdout(&bare).lines().last().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let expected = f64::sqrt(2.8_f64.powi(2) + 1.8_f64.powi(2) + 1.9_f64.powi(2)); // to each corner, from the middle
    assert!(last[4..].len() == 4 && last[4..].iter().all(|x| (x - expected).abs() < 1e-12), "{last:?}");

    let limits = run(&["wrench", "limits.toml", "--along", "path.csv", "--step", "1", "-o", "out.csv"]);
    let csv = fs::read_to_string(folder.path().join("out.csv")).unwrap();
    assert!(csv.contains("length:winch 4,tension:winch 1,tension:winch 2"), "{csv}");
    assert!(!csv.contains("length_0") && stdout(&limits).contains("longest cable "), "{csv}{}", stdout(&limits));

    for (scene, tensions) in [("bare.toml", false), ("limits.toml", true)] {
        let json = json(&run(&["wrench", scene, "--along", "path.csv", "--step", "1", "--format", "json"]));
        assert_eq!(json["cables"], serde_json::json!(["winch 1", "winch 2", "winch 3", "winch 4"]));
        assert_eq!(json["rows"][0]["lengths"].as_array().unwrap().len(), 4);
        assert_eq!(json["rows"][0].get("tensions").is_some(), tensions);
    }
    // If forces are requested, missing mass or tension limits are an error.
    let asked = run(&["wrench", "bare.toml", "--along", "path.csv", "--force", "1"]);
    assert!(status(&asked) == 2 && stderr(&asked).contains("robot.mass: found none"), "{}", stderr(&asked));
}

#[test]
fn an_unheld_platform_gets_one_answer() {
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let query = "query = { start = [3, 2, 1], goal = [4, 2, 1] }\nwrench = {}";
    write("four.toml", &four_cables(", tension = [5, 500]", "mass = 20", query));
    write("path.csv", PATH);
    let run = |arguments: &[&str]| cdpr_in(folder.path(), arguments);
    let held = "rank 4 of 6, underconstrained: no tensions resist turning about x while moving along y, nor turning \
                about y while moving along x";
    let at = run(&["wrench", "four.toml", "--at", "3", "2", "1"]);
    assert_eq!(status(&at), 1);
    for words in ["not feasible at (3, 2, 1)", held, "the loads alone are balanced here", "winch 1: 9"] {
        assert!(stdout(&at).contains(words), "no \"{words}\" in {}", stdout(&at));
    }
    let report = json(&run(&["wrench", "four.toml", "--at", "3", "2", "1", "--format", "json"]));
    assert_eq!((&report["feasible"], &report["balanced"]), (&false.into(), &true.into()));
    assert_eq!((&report["rank"], &report["full_rank"]), (&4.into(), &6.into()));
    assert_eq!(report["holding"], "underconstrained");
    assert_eq!(report["free_motions"][0]["words"], "turning about x while moving along y");
    assert_eq!(report["free_motions"][0]["twist"].as_array().unwrap().len(), 6);
    let plan = run(&["plan", "four.toml"]);
    assert!(status(&plan) == 1 && stdout(&plan).contains(held), "{}", stdout(&plan));
    let along = run(&["wrench", "four.toml", "--along", "path.csv", "-o", "out.csv"]);
    assert!(stderr(&along).contains("rank 4 of 6, underconstrained"), "{}", stderr(&along));
    let info = run(&["info", "four.toml"]);
    assert!(stdout(&info).contains("wrench matrix: rank 4 of 6, underconstrained"), "{}", stdout(&info));
}

#[test]
fn a_new_scene_says_why_nothing_is_feasible() {
    let folder = folder();
    let whole = four_cables(", tension = [5, 500]", "mass = 20", "");
    let robot = whole.split_once("[robot]\n").unwrap().1;
    fs::write(folder.path().join("robot.toml"), format!("version = 1\n{robot}")).unwrap();
    let new = cdpr_in(folder.path(), &["new", "hall.toml", "--robot", "robot.toml"]);
    assert!(status(&new) == 0 && stderr(&new).contains("rank 4 of 6, underconstrained"), "{}", stderr(&new));
}

#[test]
fn held_robots_report_how_they_are_held() {
    let suspended = cdpr(&["wrench", &testdata("scenes/cogiro.toml"), "--at", "0", "0", "2"]);
    assert!(status(&suspended) == 0 && stdout(&suspended).contains("rank 6 of 6, suspended"), "{}", stdout(&suspended));
    let constrained = cdpr(&["wrench", &testdata("scenes/ipanema2.toml"), "--at", "0", "0", "3"]);
    assert!(stdout(&constrained).contains("rank 6 of 6, fully constrained"), "{}", stdout(&constrained));
}
