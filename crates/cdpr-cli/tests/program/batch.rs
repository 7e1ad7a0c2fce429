//! Batches from the command line: killed and resumed, merged, reported.

use std::fs;
use std::path::Path;

use crate::support::*;

/// The exit status of a killed process: none on Unix, 1 on Windows.
const KILLED: Option<i32> = if cfg!(windows) { Some(1) } else { None };

/// Number of bytes of rows that a run has written so far.
fn bytes_of_rows(run: &Path) -> u64 {
    let rows = fs::read_dir(run.join("rows")).into_iter().flatten();
    rows.map(|entry| entry.unwrap().metadata().unwrap().len()).sum()
}

/// Runs of which all but `kills` may end before they can be killed.
const RUNS: usize = 100;

/// Runs a batch into the folder `torn` with two threads, and kills it several times, each time after it has written up
/// to a few more bytes. A run that ends before it is killed starts again from nothing.
fn run_and_kill(folder: &Path, arguments: &[&str], kills: usize, most: u64) {
    let (mut random, mut killed) = (12345u64, 0);
    for _ in 0..RUNS {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        if is_killed(folder, arguments, 1 + (random >> 32) % most) {
            killed += 1;
        } else {
            fs::remove_dir_all(folder.join("torn")).unwrap();
            killed = 0;
        }
        if killed == kills {
            return;
        }
    }
    panic!("{RUNS} runs ended before they were killed");
}

/// Resumes a batch in the folder `torn` until it has written `more` more bytes; returns whether it could be killed
/// then.
fn is_killed(folder: &Path, arguments: &[&str], more: u64) -> bool {
    let wanted = bytes_of_rows(&folder.join("torn")) + more;
    let mut command = std::process::Command::new(assert_cmd::cargo::cargo_bin!("cdpr"));
    command.current_dir(folder).args(arguments).args(["torn", "--resume", "--threads", "2"]);
    let mut child = command.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null()).spawn().unwrap();
    while child.try_wait().unwrap().is_none() && bytes_of_rows(&folder.join("torn")) < wanted {
        std::thread::sleep(std::time::Duration::from_micros(200));
    }
    child.kill().unwrap();
    child.wait().unwrap().code() == KILLED
}

#[test]
fn a_batch_that_is_killed_ten_times_ends_with_the_same_bytes() {
    let folder = folder();
    let experiment = testdata("../experiments/table2.toml");
    let arguments = ["batch", &experiment, "--trials", "100", "-o"];
    let whole = cdpr_in(folder.path(), &[&arguments[..], &["whole", "--threads", "1", "--format", "json"]].concat());
    assert_eq!(status(&whole), 0, "{}", stderr(&whole));
    assert_eq!(json(&whole)["methods"].as_array().unwrap().len(), 8);
    let expected = fs::read(folder.path().join("whole/trials.csv")).unwrap();
    let most = bytes_of_rows(&folder.path().join("whole")) / 40; // at a time, so that ten kills leave much to be done
    run_and_kill(folder.path(), &arguments, 10, most);
    let resumed = cdpr_in(folder.path(), &[&arguments[..], &["torn", "--resume"]].concat());
    assert_eq!(status(&resumed), 0, "{}", stderr(&resumed));
    assert!(
        stdout(&resumed).contains("modified RRT + post-processing")
            && stdout(&resumed).contains("p of the t-tests: A ")
    );
    assert_eq!(fs::read(folder.path().join("torn/trials.csv")).unwrap(), expected);
    let again = cdpr_in(folder.path(), &[&arguments[..], &["torn"]].concat());
    assert_eq!(status(&again), 2);
    assert!(stderr(&again).contains("found a folder that is not empty"));
}

/// An experiment on a platform that turns.
fn turning(scene: &str, methods: serde_json::Value) -> serde_json::Value {
    let scenarios = serde_json::json!([{"name": "bar", "scene": scene}]);
    serde_json::json!({"version": 1, "name": "turning", "trials": 12, "scenarios": scenarios, "methods": methods})
}

#[test]
fn trials_of_a_platform_that_turns_are_the_plans_of_their_seeds() {
    let folder = folder();
    let scene = testdata("scenes/turn.toml");
    let methods = serde_json::json!([
        {"name": "two trees", "planner": "two-trees"},
        {"name": "as it grew", "planner": "rrt-connect", "post": "none"},
    ]);
    fs::write(folder.path().join("turning.json"), turning(&scene, methods).to_string()).unwrap();
    let arguments = ["batch", "turning.json", "-o"];
    let whole = cdpr_in(folder.path(), &[&arguments[..], &["whole", "--threads", "1"]].concat());
    assert_eq!(status(&whole), 0, "{}", stderr(&whole));
    let table = |run: &str| fs::read_to_string(folder.path().join(run).join("trials.csv")).unwrap();
    run_and_kill(folder.path(), &arguments, 3, 300);
    assert_eq!(status(&cdpr_in(folder.path(), &[&arguments[..], &["torn", "--resume"]].concat())), 0);
    assert_eq!(table("torn"), table("whole"));
    assert!(
        table("whole").starts_with(
            "scenario,method,trial,seed,status,raw_cost,cost,raw_waypoints,waypoints,nodes,motion_checks\n"
        )
    );

    for (method, options) in [("two trees", &["two-trees"][..]), ("as it grew", &["rrt-connect", "--post", "none"])] {
        let row = table("whole").lines().find(|line| line.contains(&format!("{method},5,"))).unwrap().to_string();
        let cells: Vec<&str> = row.split(',').collect();
        let plan = ["plan", &scene, "--seed", cells[3], "-o", "path.json", "--format", "json", "--planner"];
        let planned = cdpr_in(folder.path(), &[&plan[..], options].concat());
        assert_eq!((cells[4], status(&planned)), ("solved", 0), "{}", stderr(&planned));
        let path = json(&planned);
        assert_eq!([path["raw_cost"].to_string(), path["cost"].to_string()], cells[5..7]);
        // The length counts the quarter turn, whose weight is the distance of the bar's corner.
        let quarter = std::f64::consts::FRAC_PI_2 * (0.3f64.powi(2) + 2.0 * 0.04f64.powi(2)).sqrt();
        assert!(path["cost"].as_f64().unwrap() > 2.0f64.sqrt() + quarter);
        let checked = cdpr_in(folder.path(), &["check", &scene, "path.json", "--format", "json"]);
        assert_eq!((status(&checked), &json(&checked)["length"]), (0, &path["cost"]));
    }
    let report = cdpr_in(folder.path(), &["report", "whole"]);
    assert_eq!(status(&report), 0, "{}", stderr(&report));
    let page = fs::read_to_string(folder.path().join("whole/report.html")).unwrap();
    assert!(page.contains("The platform may turn in \u{201c}bar\u{201d}"), "{page}");
}

#[test]
fn options_undefined_for_turning_platforms_are_refused() {
    let folder = folder();
    let scene = testdata("scenes/turn.toml");
    let text = fs::read_to_string(&scene).unwrap();
    fs::write(folder.path().join("rolled.toml"), text.replace("axis = [0.0, 0.0, 1.0]", "axis = [1.0, 0.0, 0.0]"))
        .unwrap();
    let no_goal = text.replace("goal = [1.5, 1.5, 0.15]", "");
    fs::write(folder.path().join("aimless.toml"), no_goal).unwrap();
    for (scene, method, problem) in [
        (
            &*scene,
            serde_json::json!({"name": "a", "sweep": {"step": [0.1, 0.2]}}),
            "a.json: methods[0].sweep: found a sweep of rewinding, expected none, since the platform of scenarios[0] may turn",
        ),
        (
            &*scene,
            serde_json::json!({"name": "a", "interference": "swept"}),
            "a.json: methods[0].interference: found \"swept\", expected \"exact\", since the platform of scenarios[0] may turn",
        ),
        (
            "rolled.toml",
            serde_json::json!({"name": "a"}),
            "a.json: scenarios[0].scene.turning.axis: found a goal that the platform cannot reach from its start",
        ),
        ("aimless.toml", serde_json::json!({"name": "a"}), "a.json: scenarios[0].scene.query.goal: found none"),
    ] {
        fs::write(folder.path().join("a.json"), turning(scene, serde_json::json!([method])).to_string()).unwrap();
        let refused = cdpr_in(folder.path(), &["batch", "a.json", "-o", "run"]);
        assert!(status(&refused) == 2 && stderr(&refused).contains(problem), "{}", stderr(&refused));
        assert!(!folder.path().join("run").exists());
    }
}

#[test]
fn random_obstacles_keep_start_and_goal_poses_free() {
    let folder = folder();
    let mut experiment =
        turning(&testdata("scenes/turn.toml"), serde_json::json!([{"name": "a", "planner": "two-trees"}]));
    experiment["scenarios"][0]["random"] = serde_json::json!({"count": 3, "height": [0.2, 0.6]});
    fs::write(folder.path().join("random.json"), experiment.to_string()).unwrap();
    let run = cdpr_in(folder.path(), &["batch", "random.json", "-o", "run"]);
    assert_eq!(status(&run), 0, "{}", stderr(&run));
    let table = fs::read_to_string(folder.path().join("run/trials.csv")).unwrap();
    let rows: Vec<&str> = table.lines().skip(1).collect();
    assert!(rows.len() == 12 && rows.iter().all(|row| !row.contains("invalid") && !row.contains("failed")), "{table}");
    assert!(rows.iter().filter(|row| row.contains("solved")).count() > 6, "{table}");
}

#[test]
fn parts_of_a_batch_merge() {
    let folder = folder();
    let experiment = testdata("../experiments/fig8.toml");
    for (name, trials) in [("whole", "6"), ("a", "0..2"), ("b", "2..6")] {
        let part = cdpr_in(folder.path(), &["batch", &experiment, "-o", name, "--trials", trials]);
        assert_eq!(status(&part), 0, "{}", stderr(&part));
    }
    assert_eq!(status(&cdpr_in(folder.path(), &["merge", "b", "a", "-o", "merged"])), 0);
    let table = |name: &str| fs::read(folder.path().join(name).join("trials.csv")).unwrap();
    assert_eq!(table("whole"), table("merged"));
    let bad = cdpr_in(folder.path(), &["batch", &experiment, "-o", "c", "--trials", "5..5"]);
    assert!(status(&bad) == 2 && stderr(&bad).contains("found no trials"));
    let bad = cdpr_in(folder.path(), &["batch", &experiment, "-o", "c", "--threads", "0"]);
    assert!(status(&bad) == 2 && stderr(&bad).contains("threads: found 0, expected at least 1"));
}

#[test]
fn a_report_sets_the_paper_beside_a_run_and_says_how_to_draw_it() {
    let folder = folder();
    for (name, trials, expected) in [
        ("table2", "12", &["11.345 ± 26.799", "here / paper", "28.62", "Two-sample t-tests", "0.5274"][..]),
        ("fig8", "8", &["The paper prints a gap of 0.66", "backward first", "repeats 10"]),
        ("fig7", "4", &["step, m", "0.05"]),
    ] {
        let experiment = testdata(&format!("../experiments/{name}.toml"));
        let run = cdpr_in(folder.path(), &["batch", &experiment, "-o", name, "--trials", trials]);
        assert_eq!(status(&run), 0, "{}", stderr(&run));
        let page = format!("{name}.html");
        let report = cdpr_in(folder.path(), &["report", name, "-o", &page]);
        let figures = format!("figures: python -m cdpr.figures {name} -o DIR");
        assert!(status(&report) == 0 && stderr(&report).contains(&figures), "{}", stderr(&report));
        let page = fs::read_to_string(folder.path().join(page)).unwrap();
        for text in expected {
            assert!(page.contains(text), "no \"{text}\" in {page}");
        }
        // Self-contained: nothing is loaded and nothing runs.
        assert!(!page.contains("<script") && !page.contains("src=") && !page.contains("href="));
    }
}

#[test]
fn methods_are_compared_on_trials_both_solved() {
    let folder = folder();
    let experiment = serde_json::json!({
        "version": 1, "name": "pairs", "trials": 12, "scenarios": [{"name": "hard3", "scene": testdata("scenes/hard3.toml")}],
        "methods": [{"name": "anytime", "planner": "anytime"}, {"name": "few", "options": {"max_samples": 1000}, "proof": false},
                    {"name": "two trees", "planner": "two-trees"}],
    });
    fs::write(folder.path().join("pairs.json"), experiment.to_string()).unwrap();
    let run = cdpr_in(folder.path(), &["batch", "pairs.json", "-o", "run"]);
    assert_eq!(status(&run), 0, "{}", stderr(&run));
    let said = stdout(&run);
    let few = said.lines().find(|line| line.starts_with("hard3, few")).unwrap();
    let solved: usize = few.split_whitespace().nth(2).unwrap().strip_suffix("/12").unwrap().parse().unwrap();
    assert!(0 < solved && solved < 12, "{said}");
    let trials = if solved == 1 { "trial" } else { "trials" };
    let line = format!("hard3: {solved} {trials} solved by both; anytime shorter in {solved}, few in 0; few 0.");
    assert!(said.contains(&line) && said.contains(" m longer than anytime on average"), "no \"{line}\" in {said}");
    assert_eq!(status(&cdpr_in(folder.path(), &["report", "run", "-o", "page.html"])), 0);
    let page = fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert!(
        page.contains("<h2>Lengths in the same scenes</h2>") && page.contains("<th class=\"n\">trials of both</th>"),
        "{page}"
    );
    // Phones get the width of the screen, and the page begins with what it found.
    assert!(page.contains("name=\"viewport\"") && page.find("Fingerprint") > page.find("How it was run"), "{page}");
}

#[test]
fn reports_escape_names_and_reject_other_folders() {
    let folder = folder();
    let scene = testdata("scenes/hard1.toml");
    let nasty = "<script>alert(1)</script>\"'&";
    let experiment = serde_json::json!({
        "version": 1, "name": nasty, "trials": 3, "scenarios": [{"name": nasty, "scene": scene}],
        "methods": [{"name": nasty}, {"name": format!("{nasty}2"), "sweep": {"step": [0.1, 0.2]}}],
        "t_tests": [{"group": nasty, "measure": "cost", "a": [nasty, nasty], "b": [nasty, nasty]}],
    });
    fs::write(folder.path().join("nasty.json"), experiment.to_string()).unwrap();
    assert_eq!(status(&cdpr_in(folder.path(), &["batch", "nasty.json", "-o", "run"])), 0);
    let report = cdpr_in(folder.path(), &["report", "run", "--format", "json"]);
    assert_eq!((status(&report), &json(&report)["page"]), (0, &"run/report.html".into()));
    let page = fs::read_to_string(folder.path().join("run/report.html")).unwrap();
    assert!(!page.contains("<script") && page.contains("&lt;script&gt;"), "{page}");
    for (arguments, problem) in [
        (["report", "nowhere", "-o", "a.html"], "nowhere: found no summary.json"),
        (["report", "run", "-o", "a.txt"], "expected .html"),
    ] {
        let bad = cdpr_in(folder.path(), &arguments);
        assert!(status(&bad) == 2 && stderr(&bad).contains(problem), "{}", stderr(&bad));
    }
    fs::write(folder.path().join("run/summary.json"), "{\"experiment\": 3}").unwrap();
    let bad = cdpr_in(folder.path(), &["report", "run"]);
    assert!(status(&bad) == 2 && stderr(&bad).contains("summary.json: experiment"), "{}", stderr(&bad));
}
