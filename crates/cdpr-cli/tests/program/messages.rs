//! Messages, as a new user meets them; and no text from a file reaches a terminal unescaped.

use std::fs;

use crate::support::*;
use serde_json::json;

/// hard1 with one piece of text replaced, its robot beside it.
fn hard1_with(from: &str, to: &str) -> tempfile::TempDir {
    let folder = folder();
    let text = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    assert!(text.contains(from), "{from}");
    fs::write(folder.path().join("hall.toml"), text.replacen(from, to, 1)).unwrap();
    folder
}

#[test]
fn budgets_and_threads_have_limits() {
    let hard1 = testdata("scenes/hard1.toml");
    for budget in ["1e19", "inf", "NaN", "-1", "0", "1e13", "1e-9"] {
        let refused = cdpr(&["plan", &hard1, "--budget-ms", budget]);
        let told = stderr(&refused);
        assert!(status(&refused) == 2 && told.contains("expected a positive number"), "{budget}: {told}");
        assert!(told.contains("at most 1e12"), "{budget}: {told}");
    }
    for threads in ["0", "1025", "100000", "-1", "1.5", "99999999999999999999"] {
        let refused = cdpr(&["batch", "nowhere.toml", "-o", "nowhere", "--threads", threads]);
        assert!(status(&refused) == 2 && stderr(&refused).contains("expected"), "{threads}: {}", stderr(&refused));
        assert!(!std::path::Path::new("nowhere").exists());
    }
}

#[test]
fn angles_beyond_a_turn_get_a_hint_at_degrees() {
    let turned = |turn: &str| hard1_with("name = \"pillar\"", &format!("name = \"pillar\"\n{turn}"));
    let folder = turned("rpy = [0, 0, 17]");
    let told = stderr(&cdpr_in(folder.path(), &["plan", "hall.toml"]));
    assert!(told.contains("obstacles[0].rpy: found 17 rad") && told.contains("did you mean rpy_degrees?"), "{told}");
    let turns = ["rpy_degrees = [10, 20, 30]", "rpy = [0.17453292519943295, 0.3490658503988659, 0.5235987755982988]"];
    let [degrees, radians] = turns.map(|turn| {
        let ended = cdpr_in(turned(turn).path(), &["plan", "hall.toml", "--format", "json"]);
        assert!(!stderr(&ended).contains("rpy"), "{}", stderr(&ended));
        json(&ended)["cost"].as_f64().unwrap()
    });
    assert!((degrees - radians).abs() < 1e-9, "{degrees}, {radians}");
    let both = turned("rpy = [0, 0, 1]\nrpy_degrees = [0, 0, 1]");
    let told = stderr(&cdpr_in(both.path(), &["plan", "hall.toml"]));
    assert!(told.contains("obstacles[0]: found both rpy and rpy_degrees, expected one of them"), "{told}");
}

#[test]
fn a_mesh_that_dwarfs_the_workspace_gets_a_hint_at_units() {
    let cube = "v 0 0 0\nv 300 0 0\nv 300 300 0\nv 0 300 0\nv 0 0 300\nv 300 0 300\nv 300 300 300\nv 0 300 300\n\
        f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let inside = "position = [0.5, 0.5, 0.1]"; // where outlets are then inside the mesh, which is an error
    for (units, position, hinted) in [
        ("", inside, true),
        ("", "position = [0.5, 0.5, 3.0]", true),
        ("units = \"mm\"\n", inside, false),
        ("units = \"m\"\n", inside, false),
    ] {
        let mesh = format!("mesh = \"mill.obj\"\n{units}{position}\n");
        let folder = hard1_with("box = [0.3, 0.3, 1.5]\nposition = [1.0, 1.0, 0.75]\n", &mesh);
        fs::write(folder.path().join("mill.obj"), cube).unwrap();
        let ended = cdpr_in(folder.path(), &["info", "hall.toml"]);
        let told = format!("{}{}", stdout(&ended), stderr(&ended));
        let hint = "it is 300.000 m long in a workspace of 2.000 m; if its coordinates are millimetres, add units";
        assert_eq!(told.contains(hint), hinted, "{units}: {told}");
    }
}

#[test]
fn a_robot_in_place_of_a_scene_is_named_as_such() {
    let file = testdata("robots/paper.toml");
    let text = fs::read_to_string(&file).unwrap();
    for ended in [cdpr(&["plan", &file]), cdpr_fed(folder().path(), &["info", "-"], &text)] {
        assert!(
            status(&ended) == 2 && stderr(&ended).contains("found a robot, expected a scene"),
            "{}",
            stderr(&ended)
        );
    }
}

#[test]
fn a_clearance_below_a_table_is_said_to_be_of_motions_only() {
    let folder = folder();
    let motion = "\n[motion]\nspeed = 1.0\nacceleration = 1.0\nclearance = 0.05\n";
    let hard1 = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap().replace("../robots", &testdata("robots"));
    fs::write(folder.path().join("hall.toml"), hard1 + motion).unwrap();
    let planned = cdpr_in(folder.path(), &["plan", "hall.toml", "-o", "path.json"]);
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    assert!(
        stderr(&planned).contains("`clearance = 0.05` in [motion] is for timed motions only"),
        "{}",
        stderr(&planned)
    );
    let timed = cdpr_in(folder.path(), &["trajectory", "hall.toml", "path.json"]);
    let told = stderr(&timed);
    assert!(status(&timed) == 2 && told.contains("the motion is to keep 0.05 m"), "{told}");
}

#[test]
fn messages_use_plain_keys_units_and_numbers() {
    let folder = hard1_with("version = 1", "version = 1\nclearance = 0\nclearance = 1");
    let path = folder.path().join("hall.toml");
    let told = || stderr(&cdpr_in(folder.path(), &["plan", "hall.toml"]));
    assert!(told().contains("duplicate key `clearance`, expected it once (line "), "{}", told());
    let hard1 = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    for (from, to, expected) in [
        (
            "version = 1",
            "version = 1\nclearance = \"1 cm\"",
            "clearance: found the string \"1 cm\", expected a number (line ",
        ),
        ("version = 1", "version = 1\nclearance = 1 cm", "found \"1 cm\", expected one value: a number without a unit"),
        ("version = 1", "version = 1\nclearance = [1]", "clearance: found an array, expected a number"),
        ("name = \"pillar\"", "name = 5", "obstacles[0].name: found 5, expected a string"),
        ("version = 1", "version = -1", "version: found -1, expected a whole number of at least 0"),
        (
            "[query]",
            "[wrench]\nload = [0, 0, -9.81]\n[query]",
            "wrench.load: found 3 numbers, expected 6: fx fy fz mx my mz",
        ),
        ("[query]", "[wrench]\nload = [0, 0, nan, 0, 0, 0]\n[query]", "wrench.load: found fz = NaN"),
        ("[query]", "[query]\norientation = [1, 0, 0]", "query.orientation: found 3 numbers, expected 4: w x y z"),
    ] {
        fs::write(&path, hard1.replacen(from, to, 1)).unwrap();
        assert!(told().contains(expected), "{to}: {}", told());
    }
    fs::write(&path, &hard1).unwrap();
    fs::write(folder.path().join("far.csv"), "x,y,z\n0.3,1,0.3\n9788.4,1,0.3\n").unwrap();
    let checked = stdout(&cdpr_in(folder.path(), &["check", "hall.toml", "far.csv"]));
    assert!(checked.contains("leaves the workspace by 9786.") && !checked.contains("9786475"), "{checked}");
}

#[test]
fn violations_have_gap_required_and_nonpositive_margin() {
    let folder = hard1_with("version = 1", "version = 1\nclearance = 0.1");
    fs::write(folder.path().join("path.csv"), "x,y,z\n0.72,1,0.3\n0.6,1,0.3\n1.7,1,1.7\n0.3,1.7,1.7\n-1,1,1\n")
        .unwrap();
    let report = json(&cdpr_in(folder.path(), &["check", "hall.toml", "path.csv", "--format", "json"]));
    let violations = report["violations"].as_array().unwrap();
    let mut clear_but_too_near = 0;
    for v in violations {
        let number = |key: &str| v[key].as_f64().unwrap_or_else(|| panic!("{key}: {v}"));
        assert!(number("margin") <= 0.0, "{v}");
        assert!((number("gap") - number("required") - number("margin")).abs() < 1e-9, "{v}");
        clear_but_too_near += usize::from(number("gap") > 0.0);
    }
    assert!(violations.len() > 3 && clear_but_too_near > 0, "{violations:#?}");
    let text = stdout(&cdpr_in(folder.path(), &["check", "hall.toml", "path.csv"]));
    assert!(text.contains("comes too near") && text.contains("100.000 mm required"), "{text}");
}

/// Text that clears the screen, colours what follows, ends a line, rings the bell, and turns the direction of writing.
const HOSTILE: &str = "a\u{1b}[2J\u{1b}]0;b\u{7}\u{9b}31m\r\n\u{202e}c\u{7f}";

/// No output may contain the control characters of HOSTILE.
fn assert_harmless(what: &str, output: &std::process::Output) {
    for text in [stdout(output), stderr(output)] {
        let raw = text.chars().find(|c| (c.is_control() && !"\n\t".contains(*c)) || *c == '\u{202e}');
        assert_eq!(raw, None, "{what}: {text:?}");
    }
}

#[cfg(unix)]
#[test]
fn text_from_files_never_reaches_a_terminal_raw() {
    let name = HOSTILE.replace('/', "");
    let folder = folder();
    let scene = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    let escaped = |c: char| if c.is_ascii_graphic() { c.to_string() } else { format!("\\u{:04x}", c as u32) };
    let quoted = format!("\"{}\"", HOSTILE.chars().map(escaped).collect::<String>()); // for TOML as for JSON
    let put = |file: &str, text: &str| fs::write(folder.path().join(file), text).unwrap();
    let run = |arguments: &[&str], expected: &[i32]| {
        let ended = cdpr_in(folder.path(), arguments);
        assert_harmless(&format!("{arguments:?}"), &ended);
        assert!(expected.contains(&status(&ended)), "{arguments:?}: {}", stderr(&ended));
        ended
    };
    // Names of files: in results, notes, hints and errors.
    let (hall, path, page) = (format!("{name}.toml"), format!("{name}.json"), format!("{name}.html"));
    put(&hall, &scene);
    run(&["plan", &hall, "-o", &path, "--html", &page, "-v"], &[0]);
    run(&["check", &hall, &path], &[0]);
    run(&["check", &hall, &path, "--format", "json"], &[0]);
    run(&["view", &hall, &path, "-o", &page, "--format", "json"], &[0]);
    run(&["info", &hall], &[0]);
    run(&["shadows", &hall, "-o", &format!("{name}.obj"), "--format", "json"], &[0]);
    run(&["info", &format!("{name}x.toml")], &[2]); // "did you mean"
    run(&["plan", &hall, "-o", &format!("{name}/p.json")], &[2]);
    run(&["plan", &hall, "--orientation", &name], &[2]);
    run(&["shadows", &hall, "-o", "s.obj", "--cable", &name], &[2]);
    // Names in files are of one line, and everything else is escaped where it is quoted.
    for (from, to) in [
        ("name = \"pillar\"", format!("name = {quoted}")),
        ("name = \"hard1\"", format!("name = {quoted}")),
        ("version = 1", format!("version = 1\n{quoted} = 1")),
        ("version = 1", format!("version = 1\nrobot = {quoted}")),
        ("version = 1", format!("version = 1\nignore = [[{quoted}, \"platform\"]]")),
        ("version = 1", format!("version = 1\nclearance = {quoted}")),
        ("version = 1", format!("version = 1\norientations = [{{ name = {quoted} }}]")),
        ("tension = [10.0, 1000.0]", format!("tension = [10.0, 1000.0]\nname = {quoted}")),
        ("name = \"paper\"", format!("name = {quoted}")),
        ("[query]", format!("[query]\norientation = {quoted}")),
        ("box = [0.3, 0.3, 1.5]", format!("mesh = {}", quoted.replacen("\"a", "\"x.stl/a", 1))),
    ] {
        let text = scene.replacen(from, &to, 1);
        assert!(text != scene, "{from}");
        put("hall.toml", &text);
        let refused = run(&["info", "hall.toml"], &[2]);
        if to.contains("name = ") {
            assert!(stderr(&refused).contains("expected a name on one line"), "{to}: {}", stderr(&refused));
        }
    }
    put("hall.toml", &scene);
    let waypoints = json!([[0.3, 1, 0.3]]);
    put("status.json", &json!({ "waypoints": waypoints, "status": HOSTILE }).to_string());
    run(&["check", "hall.toml", "status.json"], &[2]);
    let (waypoints, id) = (json!([[0.3, 1, 0.3], [0.4, 1, 0.3]]), json!({ "name": HOSTILE, "fingerprint": HOSTILE }));
    put("id.json", &json!({ "waypoints": waypoints, "scene": id }).to_string());
    run(&["check", "hall.toml", "id.json"], &[0, 2]);
    put("named.json", &json!({ "waypoints": waypoints, "orientation_name": HOSTILE }).to_string());
    run(&["check", "hall.toml", "named.json"], &[2]);
    put("cells.csv", &format!("x,y,z\n1,2,\"{HOSTILE}\"\n"));
    run(&["check", "hall.toml", "cells.csv"], &[2]);
    // A run's own files, which may have been changed.
    fs::create_dir(folder.path().join("run")).unwrap();
    put(
        "run/summary.json",
        &json!({
            "experiment": HOSTILE, "fingerprint": HOSTILE, "confidence": 0.9, "methods": [], "t_tests": [],
        })
        .to_string(),
    );
    run(&["report", "run"], &[2]);
    put(
        "run/run.json",
        &json!({
            "version": 1, "experiment": HOSTILE, "fingerprint": HOSTILE, "first_trial": 0, "end_trial": 1,
            "layout": { "confidence": 0.9, "groups": [{ "scenario": HOSTILE, "methods": [HOSTILE] }], "t_tests": [] },
        })
        .to_string(),
    );
    run(&["merge", "run", "-o", "merged"], &[2]);
    put(
        "e.toml",
        &format!(
            "version = 1\ntrials = 1\nname = {quoted}\nscenarios = [{{ name = \"s\", scene = \"hall.toml\" }}]\nmethods = [{{ name = \"m\" }}]\n"
        ),
    );
    let refused = run(&["batch", "e.toml", "-o", "r"], &[2]);
    assert!(stderr(&refused).contains("expected a name on one line"), "{}", stderr(&refused));
    put("robot.yaml", &format!("platform: {quoted}\n"));
    run(&["import", "robot.yaml", "-o", "robot.toml"], &[2]);
    put("robot.xml", "<a\u{9b}31m></a\u{9b}31m>");
    run(&["import", "robot.xml", "-o", "robot.toml"], &[2]);
}

#[cfg(unix)]
#[test]
fn non_utf8_file_names_work() {
    use std::os::unix::ffi::OsStrExt;
    let folder = hard1_with("version = 1", "version = 1");
    let name = |extension: &[u8]| std::ffi::OsStr::from_bytes(&[b"\xff\x1b.", extension].concat()).to_os_string();
    for (arguments, extension) in [(["view", "hall.toml"], "html"), (["shadows", "hall.toml"], "obj")] {
        let mut command = std::process::Command::new(assert_cmd::cargo::cargo_bin!("cdpr"));
        let command = command.current_dir(folder.path()).args(arguments).args(["--format", "json", "-o"]);
        let ended = command.arg(name(extension.as_bytes())).output().unwrap();
        assert_eq!(status(&ended), 0, "{arguments:?}: {}", stderr(&ended));
        assert_harmless(arguments[0], &ended);
        json(&ended);
        assert!(folder.path().join(name(extension.as_bytes())).is_file());
    }
}

#[test]
fn cells_that_a_spreadsheet_would_run_are_text() {
    let folder = hard1_with("version = 1", "version = 1");
    let names = ["=HYPERLINK(\"http://x\")", "+1", "-1", "@SUM(A1)", "'quoted", "plain"];
    let methods: Vec<_> = names.iter().map(|name| json!({ "name": name, "planner": "modified-rrt" })).collect();
    let experiment = json!({
        "version": 1, "trials": 2, "history": true, "methods": methods,
        "scenarios": [{ "name": "=scene", "scene": "hall.toml" }],
    });
    fs::write(folder.path().join("e.json"), experiment.to_string()).unwrap();
    let ended = cdpr_in(folder.path(), &["batch", "e.json", "-o", "run"]);
    assert_eq!(status(&ended), 0, "{}", stderr(&ended));
    for table in ["trials.csv", "timings.csv", "history.csv"] {
        let mut reader = csv::Reader::from_path(folder.path().join("run").join(table)).unwrap();
        let mut rows = 0;
        for row in reader.records() {
            let row = row.unwrap();
            assert_eq!(&row[0], "'=scene", "{table}");
            let quoted = names.map(|name| if name == "plain" { name.to_string() } else { format!("'{name}") });
            assert!(quoted.contains(&row[1].to_string()), "{table}: {row:?}");
            rows += 1;
        }
        assert!(rows >= 2 * names.len(), "{table}");
    }
    // Text quoted for spreadsheets is read back unchanged.
    let summary = fs::read_to_string(folder.path().join("run/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert!(summary["methods"].as_array().unwrap().iter().all(|m| m["scenario"] == "=scene" && m["solved"] == 2));
    assert_eq!(status(&cdpr_in(folder.path(), &["report", "run"])), 0);
    let page = fs::read_to_string(folder.path().join("run/report.html")).unwrap();
    assert!(!page.contains("'=scene") && !page.contains("&#39;=scene"), "names stand in the page as in the experiment");
    assert_eq!(status(&cdpr_in(folder.path(), &["batch", "e.json", "-o", "run", "--resume"])), 0);
}

#[test]
fn arguments_are_escaped_in_the_errors_about_them() {
    for arguments in [
        vec!["plan", "hall.toml", "--seed", "\u{1b}[31m7\nred"],
        vec!["plan", "hall.toml", "--\u{1b}]0;title\u{7}"],
        vec!["\u{1b}[2Jplan"],
        vec!["plan", "hall.toml", "--planner", "rrt\u{202e}"],
        vec!["batch", "e.toml", "-o", "out", "--trials", "\u{9b}1"],
    ] {
        let output = cdpr(&arguments);
        let said = stderr(&output);
        assert_eq!(status(&output), 2, "{said}");
        assert!(!said.contains(|c: char| c != '\n' && (c.is_control() || c == '\u{202e}')), "{said:?}");
        assert!(said.contains("\\u00") || said.contains("\\u202e"), "{said}");
    }
}

/// A scene whose goal is in a pillar, above a plate, and too heavy to hold.
fn four_things_wrong() -> tempfile::TempDir {
    let folder = folder();
    let text = fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    let text = text.replace("../", &testdata(""));
    let plate = "\n[[obstacles]]\nname = \"plate\"\nbox = [0.4, 0.4, 0.02]\nposition = [1.0, 1.0, 1.0]\n";
    fs::write(folder.path().join("scene.toml"), text + plate).unwrap();
    folder
}

#[test]
fn invalid_ends_list_all_violations_worst_first() {
    let folder = four_things_wrong();
    let run = |args: &[&str]| cdpr_in(folder.path(), args);
    let goal = ["--goal", "1.0", "1.0", "0.9"];
    let planned = run(&[&["plan", "scene.toml", "--format", "json"], &goal[..]].concat());
    assert_eq!(status(&planned), 1);
    let planned = json(&planned);
    let reasons = planned["reasons"].as_array().unwrap();
    assert!(reasons.len() > 4, "{reasons:?}");
    let margins: Vec<f64> = reasons.iter().map_while(|reason| reason["margin"].as_f64()).collect();
    assert!(margins.windows(2).all(|pair| pair[0] <= pair[1]) && margins.len() > 3, "{margins:?}");
    assert_eq!(planned["reason"], reasons[0]);
    let place: Vec<String> = planned["nearest_valid"].as_array().unwrap().iter().map(ToString::to_string).collect();
    let found = stdout(&run(&[&["plan", "scene.toml"], &goal[..]].concat()));
    assert_eq!(found.matches("\n  also: ").count(), reasons.len() - 1, "{found}");
    assert!(found.contains("\na valid position near it: ("), "{found}");
    // `check --at` says the same, and that the place it proposes is valid.
    let checked = run(&["check", "scene.toml", "--at", "1.0", "1.0", "0.9", "--format", "json"]);
    assert_eq!(status(&checked), 1);
    assert_eq!(
        (&json(&checked)["violations"], &json(&checked)["nearest_valid"]),
        (&planned["reasons"], &planned["nearest_valid"])
    );
    let there: Vec<&str> = place.iter().map(String::as_str).collect();
    let valid = run(&[&["check", "scene.toml", "--at"], &there[..]].concat());
    assert_eq!(status(&valid), 0, "{}", stdout(&valid));
    assert!(stdout(&valid).contains("\nvalid: the platform at ("), "{}", stdout(&valid));
    let far = run(&["check", "scene.toml", "--at", "0.3", "1", "0.3", "--margin", "5"]);
    assert!(stdout(&far).contains("no position that is 5.000 m inside was found near it"), "{}", stdout(&far));
    for (args, words) in [
        (&["check", "scene.toml"][..], "<PATH>"),
        (&["check", "scene.toml", "p.json", "--at", "1", "1", "1"], "--at"),
        (
            &["check", "scene.toml", "--at", "1", "1", "1", "--speed", "1"],
            "--speed: found with --at, where it has no effect",
        ),
        (&["check", "scene.toml", "p.json", "--margin", "1"], "--at"),
    ] {
        let refused = run(args);
        assert!(status(&refused) == 2 && stderr(&refused).contains(words), "{args:?}: {}", stderr(&refused));
    }
}

#[test]
fn what_plan_writes_check_checks_with_the_same_ends() {
    let folder = folder();
    let run = |args: &[&str]| cdpr_in(folder.path(), args);
    let (hard1, ends) = (testdata("scenes/hard1.toml"), ["--start", "0.4", "1", "0.4", "--goal", "1.7", "1", "1.2"]);
    let planned = run(&[&["plan", &hard1, "--proof", "bound.json"], &ends[..]].concat());
    assert!(status(&planned) == 0 && folder.path().join("bound.json").exists(), "{}", stderr(&planned));
    let closed = testdata("scenes/closed.toml");
    assert_eq!(status(&run(&["plan", &closed, "--proof", "none.json"])), 1);
    for (scene, file, ends) in [(&hard1, "bound.json", &ends[..]), (&closed, "none.json", &[])] {
        let checked = run(&[&["check", scene, file], ends].concat());
        assert_eq!(status(&checked), 0, "{}", stderr(&checked));
        // The file may come from standard input as well.
        let text = fs::read_to_string(folder.path().join(file)).unwrap();
        let piped = cdpr_fed(folder.path(), &[&["check", scene, "-"], ends].concat(), &text);
        assert_eq!((status(&piped), stdout(&piped)), (0, stdout(&checked)), "{}", stderr(&piped));
        let refused = run(&[&["check", scene, file, "--speed", "1"], ends].concat());
        assert!(stderr(&refused).contains("found a proof, expected a trajectory: limits are given"));
    }
    assert_eq!(status(&run(&["check", &hard1, "bound.json"])), 2); // about other ends
    assert_eq!(status(&run(&["plan", &hard1, "-o", "path.json"])), 0);
    let refused = run(&["check", &hard1, "path.json", "--start", "0.4", "1", "0.4"]);
    assert!(stderr(&refused).contains("found a path, expected a proof, since --start and --goal are given"));
}

#[test]
fn certificates_are_written_for_cables_round_pulleys() {
    let folder = folder();
    let scene = |wall: &str, pulley: &str| {
        format!(
            r#"{{
                "version": 1, "workspace": {{"min": [-1, -1, -1], "max": [1, 1, 1]}},
                "robot": {{"platform": [{{"vertices": [[0, 0, 0]]}}], "cables": [
                    {{"name": "rope", "outlet": [0, 0, 3], "attachment": [0, 0, 0]{pulley}}}
                ]}},
                "obstacles": [{{"name": "wall", "box": [0.1, {wall}, 2], "position": [0, 0, 0]}}],
                "query": {{"start": [-0.5, 0, 0], "goal": [0.5, 0, 0]}}
            }}"#
        )
    };
    let pulley = r#", "pulley": {"radius": 0.05, "axis": [0, 0, -1]}"#;
    for (wall, found) in [("2", 1), ("1", 0)] {
        fs::write(folder.path().join("plain.json"), scene(wall, "")).unwrap();
        fs::write(folder.path().join("pulley.json"), scene(wall, pulley)).unwrap();
        let run = |args: &[&str]| cdpr_in(folder.path(), args);
        for name in ["plain.json", "pulley.json"] {
            let planned = run(&["plan", name, "--proof", "proof.json"]);
            assert_eq!(status(&planned), found, "{}", stderr(&planned));
            assert_eq!(status(&run(&["check", name, "proof.json"])), 0);
        }
        let checked = run(&["check", "plain.json", "proof.json"]);
        assert_eq!(status(&checked), 2);
        assert!(stderr(&checked).contains("found a proof for another scene"), "{}", stderr(&checked));
    }
}
