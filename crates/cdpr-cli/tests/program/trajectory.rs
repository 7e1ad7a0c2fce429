//! Trajectories from the command line: planned, written in all formats, checked, damaged.

use std::fs;
use std::path::Path;

use crate::support::*;
use serde_json::{Value, json};

const LIMITS: [&str; 6] = ["--speed", "1", "--acceleration", "2", "--blend", "0.02"];

/// A folder with a path and its trajectory in all formats.
fn planned() -> tempfile::TempDir {
    let (folder, hard1) = (folder(), testdata("scenes/hard1.toml"));
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", &hard1, "-o", "path.json"])), 0);
    for name in ["motion.json", "motion.csv", "motion.yaml"] {
        let made = cdpr_in(folder.path(), &[&["trajectory", &hard1, "path.json", "-o", name][..], &LIMITS].concat());
        assert_eq!(status(&made), 0, "{}", stderr(&made));
        assert!(stderr(&made).contains(&format!("wrote {name}")));
    }
    folder
}

fn check(folder: &Path, file: &str, limits: &[&str]) -> std::process::Output {
    cdpr_in(folder, &[&["check", &testdata("scenes/hard1.toml"), file][..], limits].concat())
}

/// The trajectory with its rows changed.
fn changed(folder: &Path, change: impl Fn(usize, &mut Vec<String>)) {
    let mut reader = csv::Reader::from_path(folder.join("motion.csv")).unwrap();
    let mut writer = csv::Writer::from_path(folder.join("changed.csv")).unwrap();
    writer.write_record(reader.headers().unwrap()).unwrap();
    for (k, row) in reader.records().enumerate() {
        let mut row: Vec<String> = row.unwrap().iter().map(str::to_string).collect();
        change(k, &mut row);
        writer.write_record(row).unwrap();
    }
    writer.flush().unwrap();
}

fn scaled(cell: &mut String, factor: f64) {
    *cell = (cell.parse::<f64>().unwrap() * factor).to_string();
}

#[test]
fn check_finds_deviation_from_a_known_path() {
    let folder = planned();
    let far = check(folder.path(), "motion.json", &["--blend", "0.001"]);
    assert_eq!(status(&far), 1);
    assert!(stdout(&far).contains(" mm away from the path, at most 1.000 mm allowed"), "{}", stdout(&far));
    assert_eq!(status(&check(folder.path(), "motion.json", &[])), 0);
    let unknown = check(folder.path(), "motion.csv", &["--blend", "0.001"]);
    assert_eq!(status(&unknown), 0);
    assert!(stderr(&unknown).contains("the deviation from the path is not checked"), "{}", stderr(&unknown));
}

#[test]
fn a_trajectory_is_valid_in_every_format_that_is_read() {
    let folder = planned();
    // A table says only when its last sample is, a whole period.
    for (file, duration) in [("motion.json", "3.2688"), ("motion.csv", "3.27")] {
        let checked = check(folder.path(), file, &LIMITS);
        assert_eq!(status(&checked), 0, "{}{}", stdout(&checked), stderr(&checked));
        let words = format!("valid: {duration} s along 2.4447 m, 328 samples");
        assert!(stdout(&checked).contains(&words), "{}", stdout(&checked));
        let report = json(&check(folder.path(), file, &["--format", "json"]));
        assert_eq!((&report["valid"], &report["faults"]), (&json!(true), &json!([])));
        assert!((report["largest"]["speed"].as_f64().unwrap() - 1.0).abs() < 1e-4);
        let slow = check(folder.path(), file, &["--speed", "0.9"]);
        assert_eq!(status(&slow), 1);
        assert!(stdout(&slow).contains(" s: speed 0.999999 m/s, limit 0.9 m/s (from 0.45"), "{}", stdout(&slow));
    }
}

#[test]
fn motions_keep_the_clearance_and_check_requires_it() {
    let folder = folder();
    let text = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    let text = text.replace("../", &testdata("")).replace("version = 1\n", "version = 1\nclearance = 0.02\n");
    fs::write(folder.path().join("scene.toml"), text).unwrap();
    let run = |args: &[&str]| cdpr_in(folder.path(), args);
    assert_eq!(status(&run(&["plan", "scene.toml", "-o", "path.json"])), 0);
    let time = |name: &str, more: &[&str]| {
        let args =
            [&["trajectory", "scene.toml", "path.json", "-o", name, "--format", "json"], &LIMITS[..], more].concat();
        json(&run(&args))
    };
    let (kept, spent) = (time("kept.json", &[]), time("spent.csv", &["--motion-clearance", "0.001"]));
    assert!(kept["nearest"]["value"].as_f64().unwrap() >= 0.02 - 1e-9, "{}", kept["nearest"]);
    assert!(spent["nearest"]["value"].as_f64().unwrap() < 0.02 && spent["limits"]["clearance"] == json!(0.001));
    for (speed, rates) in [("speed", &kept), ("cable_speed", &kept)] {
        assert!(rates["largest"][speed].as_f64().unwrap() <= 1.0, "{}", rates["largest"]);
    }
    let checked = run(&["check", "scene.toml", "kept.json"]);
    assert_eq!(status(&checked), 0, "{}", stdout(&checked));
    let checked = run(&["check", "scene.toml", "spent.csv"]);
    assert_eq!(status(&checked), 1);
    let words = " mm between them, 20.000 mm required (from ";
    assert!(stdout(&checked).contains(words), "{}", stdout(&checked));
    let checked = run(&["check", "scene.toml", "spent.csv", "--motion-clearance", "0.001"]);
    assert_eq!(status(&checked), 0, "{}", stdout(&checked));
}

#[test]
fn cable_columns_are_checked_against_robot_and_limits() {
    let folder = planned();
    let text = fs::read_to_string(folder.path().join("motion.json")).unwrap();
    let changed = |key: &str, k: usize, value: f64| {
        let mut file: Value = serde_json::from_str(&text).unwrap();
        file[key][k][2] = json!(value);
        fs::write(folder.path().join("changed.json"), file.to_string()).unwrap();
        stdout(&check(folder.path(), "changed.json", &["--cable-speed", "2", "--cable-acceleration", "4"]))
    };
    let found = changed("cable_accelerations", 150, 1e6);
    assert!(found.contains("cable 2: acceleration 1000000 m/s², limit 4 m/s²"), "{found}");
    assert!(found.contains("cable 2: acceleration 1000000 m/s², ") && found.contains(" expected"), "{found}");
    let found = changed("cable_speeds", 150, 2.1);
    assert!(found.contains("cable 2: speed 2.1 m/s, limit 2 m/s"), "{found}");
    let found = changed("cable_speeds", 0, 0.0);
    assert!(found.contains("\nvalid: ") || found.starts_with("valid: "), "{found}");
}

#[test]
fn the_last_sample_is_at_rest_on_a_whole_period() {
    let folder = planned();
    for rate in ["1000", "333", "7"] {
        let hard1 = testdata("scenes/hard1.toml");
        let made = [&["trajectory", &hard1, "path.json", "-o", "rate.json", "--rate", rate][..], &LIMITS].concat();
        assert_eq!(status(&cdpr_in(folder.path(), &made)), 0);
        let file: Value = serde_json::from_str(&fs::read_to_string(folder.path().join("rate.json")).unwrap()).unwrap();
        let (times, rate) = (file["times"].as_array().unwrap(), rate.parse::<f64>().unwrap());
        let (last, duration) = (times[times.len() - 1].as_f64().unwrap(), file["duration"].as_f64().unwrap());
        assert!(last >= duration && last < duration + 1.0 / rate && last == (times.len() - 1) as f64 / rate);
        for key in ["velocities", "accelerations", "cable_speeds", "cable_accelerations"] {
            let row = file[key].as_array().unwrap().last().unwrap().as_array().unwrap();
            assert!(row.iter().all(|x| x.as_f64().unwrap() == 0.0), "{key} {row:?}");
        }
        let checked = check(folder.path(), "rate.json", &LIMITS);
        assert_eq!(status(&checked), 0, "{}", stdout(&checked));
    }
}

#[test]
fn a_motion_whose_speed_has_no_limit_says_so() {
    let folder = planned();
    let time = |more: &[&str]| {
        let args = ["trajectory", &testdata("scenes/hard1.toml"), "path.json", "--acceleration", "2"];
        stderr(&cdpr_in(folder.path(), &[&args[..], more].concat()))
    };
    let words = "note: neither speed nor cable_speed is limited";
    assert!(time(&[]).contains(words) && !time(&["--speed", "9"]).contains(words));
    assert!(!time(&["--cable-speed", "9"]).contains(words));
}

#[test]
fn samples_alone_are_enough() {
    let folder = planned();
    let text = fs::read_to_string(folder.path().join("motion.csv")).unwrap();
    let bare: Vec<String> = text.lines().map(|line| line.split(',').take(4).collect::<Vec<_>>().join(",")).collect();
    fs::write(folder.path().join("bare.csv"), bare.join("\n")).unwrap();
    let checked = check(folder.path(), "bare.csv", &LIMITS);
    assert_eq!(status(&checked), 0, "{}{}", stdout(&checked), stderr(&checked));
    let piped = cdpr_fed(folder.path(), &["check", &testdata("scenes/hard1.toml"), "-"], &bare.join("\n"));
    assert_eq!(status(&piped), 0, "{}", stderr(&piped));
}

#[test]
fn a_damaged_trajectory_is_refused_with_the_place() {
    let folder = planned();
    let refusal = |limits: &[&str], expected: &str| {
        let refused = check(folder.path(), "changed.csv", limits);
        assert_eq!(status(&refused), 1, "{}{}", stdout(&refused), stderr(&refused));
        assert!(stdout(&refused).contains(expected), "{expected}: {}", stdout(&refused));
    };
    changed(folder.path(), |_, row| row[8..11].iter_mut().for_each(|v| scaled(v, 1.1)));
    refusal(&[], "velocities differ by 0.1 m/s from the change of the position");
    changed(folder.path(), |_, row| scaled(&mut row[0], 0.5));
    refusal(&LIMITS, "speed 1.999999 m/s, limit 1 m/s");
    changed(folder.path(), |k, row| {
        if k == 100 {
            row[3] = (row[3].parse::<f64>().unwrap() - 1e-3).to_string();
        }
    });
    refusal(&[], "at 1.000 s: cable 2: length 1.42448 m, 1.423778 m expected");
    changed(folder.path(), |k, row| {
        if k == 182 {
            row[2] = (row[2].parse::<f64>().unwrap() + 0.05).to_string();
        }
    });
    refusal(&[], "at 1.811 s: cable 1 meets pillar, 34.227 mm deep");
    changed(folder.path(), |k, row| {
        if k == 7 {
            row[0] = "0.01".to_string();
        }
    });
    let refused = check(folder.path(), "changed.csv", &[]);
    assert_eq!(status(&refused), 2);
    let expected = "changed.csv: line 9, column t: found 0.01 s after 0.06 s, expected times that increase";
    assert!(stderr(&refused).contains(expected), "{}", stderr(&refused));
}

#[test]
fn a_sample_off_its_exact_form_is_named() {
    let folder = planned();
    let text = fs::read_to_string(folder.path().join("motion.json")).unwrap();
    let mut file: Value = serde_json::from_str(&text).unwrap();
    let z = file["positions"][150][2].as_f64().unwrap();
    file["positions"][150][2] = json!(z - 1e-3);
    fs::write(folder.path().join("moved.json"), file.to_string()).unwrap();
    let refused = check(folder.path(), "moved.json", &[]);
    let expected = "at 1.500 s: the position differs by 0.001 m from that of curve and timing";
    assert!(status(&refused) == 1 && stdout(&refused).contains(expected), "{}", stdout(&refused));
    file["curve"] = json!([{ "line": [[0, 0, 0], [0, 0, 0]] }]);
    fs::write(folder.path().join("moved.json"), file.to_string()).unwrap();
    let refused = check(folder.path(), "moved.json", &[]);
    assert!(
        status(&refused) == 2 && stderr(&refused).contains("curve[0]: found something else"),
        "{}",
        stderr(&refused)
    );
}

#[test]
fn tensions_below_their_limit_are_found() {
    let (folder, cogiro) = (folder(), testdata("scenes/cogiro.toml"));
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", &cogiro, "-o", "path.json"])), 0);
    let limits = ["--speed", "2", "--acceleration", "5", "--rate", "80"];
    let made =
        cdpr_in(folder.path(), &[&["trajectory", &cogiro, "path.json", "-o", "motion.csv"][..], &limits].concat());
    assert_eq!(status(&made), 0, "{}", stderr(&made));
    let check = |file: &str| cdpr_in(folder.path(), &["check", &cogiro, file, "--speed", "2"]);
    assert_eq!(status(&check("motion.csv")), 0, "{}", stdout(&check("motion.csv")));
    let header = fs::read_to_string(folder.path().join("motion.csv")).unwrap();
    let names: Vec<&str> = header.lines().next().unwrap().split(',').collect();
    assert_eq!(names[..14], ["t", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "ax", "ay", "az"]);
    let column = names.iter().position(|name| *name == "tension:cable 3").unwrap();
    changed(folder.path(), |k, row| {
        if k == 160 {
            row[column] = "-5".to_string();
        }
    });
    let refused = check("changed.csv");
    assert_eq!(status(&refused), 1);
    for expected in ["at 2.000 s: cable 3: tension -5 N, limits ", "at 2.000 s: tensions miss the balance"] {
        assert!(stdout(&refused).contains(expected), "{}", stdout(&refused));
    }
}

#[test]
fn plan_writes_a_trajectory_in_one_command() {
    let (folder, hard1) = (folder(), testdata("scenes/hard1.toml"));
    let plan = |more: &[&str]| cdpr_in(folder.path(), &[&["plan", &hard1, "--trajectory", "t.json"], more].concat());
    let made = plan(&LIMITS);
    assert!(status(&made) == 0 && stdout(&made).contains("timed: 3.2688 s along"), "{}", stderr(&made));
    assert_eq!(status(&check(folder.path(), "t.json", &LIMITS)), 0);
    let fastest = plan(&[&LIMITS[..], &["--minimise", "time", "--format", "json", "-o", "path.json"]].concat());
    let found = json(&fastest);
    assert!(found["trajectory"]["duration"].as_f64().unwrap() <= 3.2689, "{found}");
    assert!(found["trajectory"]["choice"]["tried"].as_u64().unwrap() > 2, "{found}");
    assert_eq!(json(&check(folder.path(), "path.json", &["--format", "json"]))["valid"], true);
    for (arguments, expected) in [
        (&["plan", &hard1, "--speed", "1"][..], "--speed: found without --trajectory, where it has no effect"),
        (&["plan", &hard1, "--minimise", "time"], "--trajectory"),
        (
            &["plan", &hard1, "--trajectory", "t.toml"],
            "t.toml: found the extension .toml, expected .json, .csv or .yaml",
        ),
        (&["plan", &hard1, "--trajectory", "t.csv"], "acceleration: found no limit, expected an acceleration"),
        (&["trajectory", &hard1, "nowhere.csv"], "nowhere.csv: cannot be read"),
        (&["trajectory", &hard1, "path.json", "--speed", "-1"], "expected a positive number"),
        (
            &["trajectory", &hard1, "path.json", "--speed", "1", "--jerk", "4", "--effort"],
            "--effort: found without a ROS 2 message, expected a trajectory file named .yaml",
        ),
        (
            &["trajectory", &hard1, "path.json", "--speed", "1", "--jerk", "4", "-o", "m.csv", "--effort"],
            "m.csv: cannot hold effort, which only a ROS 2 message (.yaml) has",
        ),
        (
            &["trajectory", &hard1, "path.json", "--speed", "1", "--jerk", "4", "-o", "m.yaml", "--effort"],
            "m.yaml: cannot hold tensions as effort: they are not known",
        ),
        (
            &["plan", &hard1, "--trajectory", "m.yaml", "--speed", "1", "--jerk", "4", "--effort"],
            "m.yaml: cannot hold tensions as effort: they are not known",
        ),
        (
            &["trajectory", &hard1, "path.json", "--speed", "1", "--jerk", "4", "--joints", "length"],
            "--joints: found without a ROS 2 message, expected a trajectory file named .yaml",
        ),
        (
            &["trajectory", &hard1, "path.json", "--speed", "1", "--jerk", "4", "-o", "m.json", "--joints", "length"],
            "m.json: cannot hold joints, which only a ROS 2 message (.yaml) has",
        ),
        (
            &["plan", &hard1, "--trajectory", "m.yaml", "--speed", "1", "--jerk", "4", "--joints", "angle"],
            "m.yaml: cannot hold angles: they are not known; they need the drum of each cable",
        ),
        (&["check", &hard1, "path.json", "--speed", "1"], "path.json: found a path without times"),
    ] {
        let refused = cdpr_in(folder.path(), arguments);
        assert!(status(&refused) == 2 && stderr(&refused).contains(expected), "{arguments:?}: {}", stderr(&refused));
        assert_eq!(stdout(&refused), "", "{arguments:?}");
    }
    assert!(!folder.path().join("t.csv").exists());
}

#[test]
fn a_trajectory_goes_through_pipes() {
    let (folder, hard1) = (planned(), testdata("scenes/hard1.toml"));
    let made = cdpr_in(folder.path(), &[&["trajectory", &hard1, "path.json", "-o", "-"][..], &LIMITS].concat());
    assert!(stderr(&made).contains("timed: "), "{}", stderr(&made));
    let checked = cdpr_fed(folder.path(), &["check", &hard1, "-"], &stdout(&made));
    assert!(status(&checked) == 0 && stdout(&checked).contains("in exact form"), "{}", stderr(&checked));
}

const TURNING: [&str; 10] =
    ["--speed", "1", "--acceleration", "2", "--blend", "0.01", "--turn-speed", "1.5", "--turn-acceleration", "4"];

#[test]
fn a_turning_path_is_planned_timed_checked_and_shown() {
    let (folder, turn) = (folder(), testdata("scenes/turn.toml"));
    let at = folder.path();
    let planned =
        cdpr_in(at, &[&["plan", &turn, "-o", "path.json", "--trajectory", "motion.json"][..], &TURNING].concat());
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    let said = stdout(&planned);
    assert!(said.contains("passed with a stop, since no curve within --blend is proved free there: "), "{said}");
    assert!(said.contains(" corners rounded: waypoints "), "{said}");
    let sharp = cdpr_in(at, &[&["trajectory", &turn, "path.json"], &TURNING[..4], &TURNING[6..]].concat());
    let said = stdout(&sharp);
    assert!(said.contains(" corners passed with a stop; with --blend they may be rounded: waypoints 1, 2"), "{said}");
    let timed = cdpr_in(at, &[&["trajectory", &turn, "path.json", "-o", "again.json"][..], &TURNING].concat());
    assert_eq!(status(&timed), 0, "{}", stderr(&timed));
    let [first, again] = ["motion.json", "again.json"].map(|name| fs::read_to_string(at.join(name)).unwrap());
    assert!(first == again && first.contains("\"angular_velocities\""));
    for name in ["motion.csv", "motion.yaml"] {
        let made = cdpr_in(at, &[&["trajectory", &turn, "path.json", "-o", name][..], &TURNING].concat());
        assert_eq!(status(&made), 0, "{}", stderr(&made));
    }
    let header = fs::read_to_string(at.join("motion.csv")).unwrap();
    assert!(header.starts_with("t,x,y,z,qw,qx,qy,qz,vx,vy,vz,ax,ay,az,wx,wy,wz,alphax,alphay,alphaz,length:"));
    for name in ["motion.json", "motion.csv"] {
        let checked = cdpr_in(at, &[&["check", &turn, name][..], &TURNING].concat());
        assert_eq!(status(&checked), 0, "{}{}", stdout(&checked), stderr(&checked));
        assert!(stdout(&checked).contains("turns at most by "), "{}", stdout(&checked));
        let slow = cdpr_in(at, &["check", &turn, name, "--turn-speed", "0.2"]);
        assert!(status(&slow) == 1 && stdout(&slow).contains(" rad/s, limit 0.2 rad/s"), "{}", stdout(&slow));
    }
    let shown = cdpr_in(at, &["view", &turn, "motion.json", "-o", "view.html", "--format", "json"]);
    assert_eq!(status(&shown), 0, "{}", stderr(&shown));
    assert_eq!(json(&shown)["violations"], json!([]));
    assert!(fs::read_to_string(at.join("view.html")).unwrap().contains("\"turn_speed\":"));
}

#[test]
fn a_turn_without_a_limit_is_refused_with_a_hint() {
    let (folder, turn) = (folder(), testdata("scenes/turn.toml"));
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", &turn, "-o", "path.json"])), 0);
    let refused = cdpr_in(folder.path(), &["trajectory", &turn, "path.json", "--acceleration", "2"]);
    assert_eq!(status(&refused), 2);
    let said = stderr(&refused);
    assert!(said.contains("expected a turn_acceleration") && said.contains("--turn-acceleration"), "{said}");
}

#[test]
fn the_wrench_margin_of_a_turning_path_is_stated() {
    let folder = folder();
    let path = json!({
        "waypoints": [[-2.0, 0.0, 2.5], [-1.8, 0.0, 2.5]],
        "orientations": [[1.0, 0.0, 0.0, 0.0], [0.05_f64.cos(), 0.0, 0.0, 0.05_f64.sin()]],
    });
    fs::write(folder.path().join("path.json"), path.to_string()).unwrap();
    let checked = cdpr_in(folder.path(), &["check", &testdata("scenes/cogiro.toml"), "path.json"]);
    assert!(stdout(&checked).contains("least capacity margin "), "{}{}", stdout(&checked), stderr(&checked));
    assert!(stdout(&checked).contains("tensions from "), "{}", stdout(&checked));
}
