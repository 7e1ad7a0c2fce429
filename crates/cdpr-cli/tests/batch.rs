//! Batches from the command line: killed and resumed, merged, reported.

mod support;

use std::fs;
use std::path::Path;

use support::*;

/// The exit status of a process that was killed, where there is none for it, or Windows' own.
const KILLED: Option<i32> = if cfg!(windows) { Some(1) } else { None };

/// How much a run has written so far.
fn bytes_of_rows(run: &Path) -> u64 {
    let rows = fs::read_dir(run.join("rows")).into_iter().flatten();
    rows.map(|entry| entry.unwrap().metadata().unwrap().len()).sum()
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
    let mut random = 12345u64;
    for _ in 0..10 {
        let written = bytes_of_rows(&folder.path().join("torn"));
        let mut command = std::process::Command::new(assert_cmd::cargo::cargo_bin!("cdpr"));
        command.current_dir(folder.path()).args(arguments).args(["torn", "--resume", "--threads", "2"]);
        let mut child =
            command.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null()).spawn().unwrap();
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let wanted = written + 1 + (random >> 32) % most;
        while bytes_of_rows(&folder.path().join("torn")) < wanted {
            assert!(child.try_wait().unwrap().is_none(), "the run ended before it was killed");
            std::thread::sleep(std::time::Duration::from_micros(200));
        }
        child.kill().unwrap();
        assert_eq!(child.wait().unwrap().code(), KILLED, "the run ended before it was killed");
    }
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
fn a_report_sets_the_paper_beside_a_run_and_writes_its_plots() {
    let folder = folder();
    for (name, trials, expected) in [
        ("table2", "12", &["11.345 ± 26.799", "here / paper", "28.62", "Two-sample t-tests", "0.5274"][..]),
        (
            "fig8",
            "8",
            &["The paper prints a gap of 0.66", "backward first", "repeats 10", "mean reduction of path cost"],
        ),
        ("fig7", "4", &["step, m", "median time of rewinding"]),
    ] {
        let experiment = testdata(&format!("../experiments/{name}.toml"));
        let run = cdpr_in(folder.path(), &["batch", &experiment, "-o", name, "--trials", trials]);
        assert_eq!(status(&run), 0, "{}", stderr(&run));
        let page = format!("{name}.html");
        let report = cdpr_in(folder.path(), &["report", name, "-o", &page, "--plots", "plots"]);
        assert_eq!(status(&report), 0, "{}", stderr(&report));
        let page = fs::read_to_string(folder.path().join(page)).unwrap();
        for text in expected {
            assert!(page.contains(text), "no \"{text}\" in {page}");
        }
        // Self-contained: nothing is loaded and nothing runs.
        assert!(
            page.contains("<svg") && !page.contains("<script") && !page.contains("src=") && !page.contains("href=")
        );
    }
    let png = fs::read(folder.path().join("plots/01-hard1-path-cost.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG") && png.len() > 5000);
    assert!(fs::read_to_string(folder.path().join("plots/01-hard1-path-cost.svg")).unwrap().starts_with("<svg"));
}

#[test]
fn names_add_no_markup_to_a_report_and_what_is_no_run_is_refused() {
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
    let report = cdpr_in(folder.path(), &["report", "run", "--plots", "plots", "--format", "json"]);
    assert_eq!((status(&report), &json(&report)["plots"]), (0, &"plots".into()));
    let page = fs::read_to_string(folder.path().join("run/report.html")).unwrap();
    assert!(!page.contains("<script") && page.contains("&lt;script&gt;"), "{page}");
    for plot in fs::read_dir(folder.path().join("plots")).unwrap() {
        let bytes = fs::read(plot.unwrap().path()).unwrap();
        assert!(!String::from_utf8_lossy(&bytes).contains("<script"));
    }
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
