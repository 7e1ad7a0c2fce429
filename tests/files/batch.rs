//! Experiments: the same rows for any threads and interruptions, reproducible rows, and bad input.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use cdpr_core::plan::{PlanOptions, Post, plan};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings};
use cdpr_core::testing::hard1;
use cdpr_files::text::Notation;
use cdpr_study::{BatchFolder, BatchRows, experiment_from_text, load_experiment, merge};
use cdpr_study::{Comparison, Experiment, Row, RunOptions, TrialRow};
use serde_json::Value;
use tempfile::TempDir;

const SMALL: &str = r#"
version = 1
seed = 3
trials = 12
[[scenarios]]
name = "hard1"
scene = "SCENES/hard1.toml"
[[scenarios]]
name = "drawn"
scene = "SCENES/empty.toml"
random = { count = 2 }
[[methods]]
name = "sweep"
options = { max_samples = 300 }
[methods.sweep]
step = [0.1, 0.02]
repeats = [1, 10]
[[methods]]
name = "rrt"
planner = "rrt"
options = { goal_bias = 0.05, max_samples = 3000 }
post = "forward"
[[t_tests]]
group = "A"
measure = "cost"
a = ["hard1", "rrt"]
b = ["hard1", "sweep, step 0.1, repeats 01"]
variances = "pooled"
"#;

fn repository() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// An experiment from text, through a file.
fn experiment(folder: &Path, text: &str) -> Result<Experiment, cdpr_core::Error> {
    let path = folder.join("experiment.toml");
    let scenes = repository().join("testdata/scenes");
    fs::write(&path, text.replace("SCENES", &scenes.display().to_string())).unwrap();
    load_experiment(&path)
}

fn small(folder: &TempDir) -> Experiment {
    experiment(folder.path(), SMALL).unwrap()
}

/// Runs until this number of trials is complete.
fn run(
    path: &Path,
    experiment: &Experiment,
    threads: usize,
    stop_after: usize,
    resume: bool,
) -> Result<(), cdpr_core::Error> {
    let mut folder = BatchFolder::open(path, experiment, 0..experiment.trials, resume)?;
    let done = AtomicUsize::new(0);
    let options = RunOptions {
        threads: Some(threads),
        interrupted: &|| done.load(Ordering::Relaxed) >= stop_after,
        progress: &mut |progress| done.store(progress.done, Ordering::Relaxed),
    };
    folder.run(experiment, options)
}

fn table(path: &Path) -> String {
    fs::read_to_string(path.join("trials.csv")).unwrap()
}

#[test]
fn threads_and_interruptions_change_no_byte() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let [one, three, torn] = ["one", "three", "torn"].map(|name| folder.path().join(name));
    run(&one, &experiment, 1, usize::MAX, false).unwrap();
    run(&three, &experiment, 3, usize::MAX, false).unwrap();
    assert_eq!(table(&one), table(&three));
    let mut interruptions = 0;
    while let Err(error) = run(&torn, &experiment, 1 + interruptions % 3, 5, true) {
        assert_eq!(error.class(), cdpr_core::ErrorClass::Interrupted);
        interruptions += 1;
        // Complete rows remain; then a kill in the middle of a write.
        assert!(table(&torn).lines().all(|line| line.split(',').count() >= 11));
        let rows = torn.join("rows/0000.csv");
        let text = fs::read_to_string(&rows).unwrap();
        fs::write(&rows, &text[..text.len() - text.len().min(7 * interruptions)]).unwrap();
    }
    assert!(interruptions >= 8, "{interruptions}");
    assert_eq!(table(&one), table(&torn));
    run(&torn, &experiment, 2, usize::MAX, true).unwrap(); // nothing left to do
    assert_eq!(table(&one), table(&torn));
}

#[test]
fn rows_from_before_compiling_was_timed_can_be_continued() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let path = folder.path().join("run");
    run(&path, &experiment, 2, 31, false).unwrap_err();
    let mut shortened = 0;
    for rows in fs::read_dir(path.join("rows")).unwrap().map(|file| file.unwrap().path()) {
        let text = fs::read_to_string(&rows).unwrap();
        let old: Vec<&str> = text.lines().map(|line| line.rsplit_once(',').unwrap().0).collect();
        shortened += old.len();
        fs::write(&rows, old.iter().map(|line| format!("{line}\n")).collect::<String>()).unwrap();
    }
    run(&path, &experiment, 2, usize::MAX, true).unwrap();
    let timings = fs::read_to_string(path.join("timings.csv")).unwrap();
    let untimed = timings.lines().skip(1).filter(|line| line.ends_with(',')).count();
    assert!(shortened > 20 && untimed >= shortened, "{untimed} of {shortened}");
    let timed = timings.lines().skip(1).filter_map(|line| line.rsplit_once(',')?.1.parse::<f64>().ok());
    let timed: Vec<f64> = timed.collect();
    assert!(!timed.is_empty() && timed.iter().all(|seconds| *seconds > 0.0 && *seconds < 10.0), "{timed:?}");
}

#[test]
fn a_history_tells_when_each_path_got_better() {
    let folder = tempfile::tempdir().unwrap();
    let text = SMALL.replace("max_samples = 300 }", "max_samples = 300, keep_going = true }");
    let plain = experiment(folder.path(), &text).unwrap();
    let told = experiment(folder.path(), &format!("history = true\n{}", text.trim_start())).unwrap();
    let [without, with, torn, merged] = ["without", "with", "torn", "merged"].map(|name| folder.path().join(name));
    run(&without, &plain, 2, usize::MAX, false).unwrap();
    run(&with, &told, 2, usize::MAX, false).unwrap();
    assert!(!without.join("history.csv").exists() && table(&with) == table(&without));
    while run(&torn, &told, 2, 11, true).is_err() {
        let rows = torn.join("rows/0000.csv");
        let text = fs::read_to_string(&rows).unwrap();
        fs::write(&rows, &text[..text.len() - 40]).unwrap();
    }
    let parts = [(0..5, "part0"), (5..12, "part1")].map(|(trials, name)| {
        let options = RunOptions { threads: Some(2), interrupted: &|| false, progress: &mut |_| {} };
        BatchFolder::open(folder.path().join(name), &told, trials, false).unwrap().run(&told, options).unwrap();
        folder.path().join(name)
    });
    merge(&parts, &merged).unwrap();
    let mut reader = csv::Reader::from_path(with.join("history.csv")).unwrap();
    assert_eq!(reader.headers().unwrap(), vec!["scenario", "method", "trial", "seconds", "samples", "cost"]);
    let history: Vec<(String, String, usize, f64, usize, f64)> = reader.deserialize().map(|r| r.unwrap()).collect();
    let mut improved = 0;
    for pair in history.windows(2).filter(|p| (&p[0].0, &p[0].1, p[0].2) == (&p[1].0, &p[1].1, p[1].2)) {
        assert!(pair[0].3 <= pair[1].3 && pair[0].4 <= pair[1].4 && pair[0].5 > pair[1].5, "{pair:?}");
        improved += 1;
    }
    assert!(improved > 12, "{improved}");
    let mut solved = 0;
    for Row { result, planning_seconds, .. } in rows(&with).iter().filter(|row| row.result.raw_cost.is_some()) {
        let name = result.method.split(',').next().unwrap(); // of variants of a sweep, that of the method
        let mut of =
            history.iter().filter(|h| (&h.0 as &str, &h.1 as &str, h.2) == (&result.scenario, name, result.trial));
        let last = of.next_back().unwrap();
        assert!((Some(last.5), last.3 <= planning_seconds.unwrap()) == (result.raw_cost, true), "{result:?}");
        solved += 1;
    }
    assert!(solved > 60, "{solved}");
    for folder in [&torn, &merged] {
        let text = fs::read_to_string(folder.join("history.csv")).unwrap();
        assert_eq!((text.lines().count(), table(folder)), (history.len() + 1, table(&with)));
    }
    let other = run(&with, &plain, 1, usize::MAX, true).unwrap_err().to_string();
    assert!(other.contains("found a run of another experiment"), "{other}");
}

#[test]
fn a_folder_killed_before_the_run_counts_as_empty() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let whole = folder.path().join("whole");
    run(&whole, &experiment, 2, usize::MAX, false).unwrap();
    for (name, resume) in [("plain", false), ("resumed", true)] {
        let path = folder.path().join(name);
        fs::create_dir_all(path.join("rows")).unwrap();
        fs::write(path.join("rows/lock"), "").unwrap();
        fs::write(path.join(".cdpr-AbC123"), "{\"experiment\": ").unwrap();
        run(&path, &experiment, 2, usize::MAX, resume).unwrap();
        assert_eq!(table(&whole), table(&path));
        // Rows of an unknown run are not overwritten.
        fs::remove_file(path.join("run.json")).unwrap();
        let refused = run(&path, &experiment, 2, usize::MAX, resume).unwrap_err().to_string();
        assert!(refused.contains(if resume { "found no run.json" } else { "not empty" }), "{refused}");
        assert_eq!(table(&whole), table(&path));
    }
}

/// The rows of `trials.csv`, in the order of the files of rows.
fn results(path: &Path) -> Vec<TrialRow> {
    rows(path).into_iter().map(|row| row.result).collect()
}

fn rows(path: &Path) -> Vec<Row> {
    let mut rows = Vec::new();
    for group in 0..4 {
        let file = path.join(format!("rows/{group:04}.csv"));
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_path(file).unwrap();
        rows.extend(reader.deserialize().map(|row: Result<Row, _>| row.unwrap()));
    }
    rows
}

#[test]
fn rows_are_sorted_and_reproducible() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let path = folder.path().join("out");
    run(&path, &experiment, 2, usize::MAX, false).unwrap();
    let text = table(&path);
    let header = "scenario,method,trial,seed,status,raw_cost,cost,raw_waypoints,waypoints,nodes,motion_checks";
    assert_eq!(text.lines().next(), Some(header));
    assert_eq!(text.lines().count(), 1 + 2 * 5 * 12);
    let timings = fs::read_to_string(path.join("timings.csv")).unwrap();
    assert!(timings.starts_with("scenario,method,trial,planning_seconds,post_seconds,compile_seconds\n"));
    assert_eq!(timings.lines().count(), text.lines().count());
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let keys = reader.records().map(|r| r.unwrap());
    let keys: Vec<(String, String, usize)> = keys.map(|r| (r[0].into(), r[1].into(), r[2].parse().unwrap())).collect();
    assert!(keys.is_sorted());
    let rows = results(&path);
    let row = rows.iter().find(|r| (r.scenario.as_str(), r.method.as_str(), r.trial) == ("hard1", "rrt", 7)).unwrap();
    let settings = PlannerSettings { goal_bias: Some(0.05), max_samples: Some(3000), ..Default::default() };
    let planner = PlannerOptions::new(Planner::Rrt, 0.1, &settings).unwrap();
    let options = PlanOptions { planner, seed: row.seed, post: Some(Post::Forward), ..PlanOptions::paper() };
    let again = plan(&hard1(), &options, &|| false).unwrap().result;
    assert_eq!(
        (row.raw_cost, row.cost),
        (Some(again.raw_cost).filter(|c| c.is_finite()), Some(again.cost).filter(|c| c.is_finite()))
    );
    for trial in 0..12 {
        let of = |method: &str| {
            rows.iter().find(|r| r.scenario == "hard1" && r.trial == trial && r.method == method).unwrap()
        };
        let [once, often] = ["01", "10"].map(|n| of(&format!("sweep, step 0.02, repeats {n}")));
        assert!(once.raw_cost == often.raw_cost && once.seed == often.seed && often.cost <= once.cost);
        assert_ne!(once.seed, of("rrt").seed);
    }
}

#[test]
fn the_summary_counts_and_compares() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let path = folder.path().join("out");
    run(&path, &experiment, 2, usize::MAX, false).unwrap();
    let summary: Value = serde_json::from_str(&fs::read_to_string(path.join("summary.json")).unwrap()).unwrap();
    let methods = summary["methods"].as_array().unwrap();
    assert_eq!(methods.len(), 10);
    let rows = results(&path);
    for method in methods {
        let of = |r: &&TrialRow| r.scenario == method["scenario"] && r.method == method["method"];
        let costs: Vec<f64> = rows.iter().filter(of).filter_map(|r| r.cost).collect();
        assert_eq!((&method["n"], &method["solved"]), (&12.into(), &costs.len().into()));
        let mean = costs.iter().sum::<f64>() / costs.len() as f64;
        assert!((method["cost"]["mean"].as_f64().unwrap() - mean).abs() < 1e-12);
        assert!(method["cost"]["median"].as_f64().unwrap() <= method["cost"]["max"].as_f64().unwrap());
        assert!(method["planning_seconds"]["mean"].as_f64().unwrap() > 0.0);
    }
    let test = &summary["t_tests"][0];
    assert_eq!((&test["group"], &test["measure"], &test["b"][0]), (&"A".into(), &"cost".into(), &"hard1".into()));
    assert!(test["p"].as_f64().unwrap() <= 1.0 && test["df"].as_f64().unwrap() <= 22.0);
    let costs = |name: &Value| -> BTreeMap<usize, f64> {
        let of = |r: &&TrialRow| r.scenario == "hard1" && r.method == *name;
        rows.iter().filter(of).filter_map(|r| Some((r.trial, r.cost?))).collect()
    };
    let (a, b) = (costs(&test["a"][1]), costs(&test["b"][1]));
    let pairs: Vec<(f64, f64)> = a.iter().filter_map(|(trial, cost)| Some((*cost, *b.get(trial)?))).collect();
    assert!(pairs.len() > 1 && pairs.len() < a.len().max(b.len()), "{} of {} and {}", pairs.len(), a.len(), b.len());
    let paired = &test["paired"];
    let mean = pairs.iter().map(|(a, b)| a - b).sum::<f64>() / pairs.len() as f64;
    assert!((paired["mean_difference"].as_f64().unwrap() - mean).abs() < 1e-12);
    let less = [pairs.iter().filter(|(a, b)| a < b).count(), pairs.iter().filter(|(a, b)| b < a).count()];
    assert_eq!(
        [&paired["n"], &paired["a_less"], &paired["b_less"]],
        [pairs.len(), less[0], less[1]].map(Value::from).each_ref()
    );
    assert_eq!(paired["df"], pairs.len() as f64 - 1.0);
    // Every method but the first of its scenario, against the first.
    let compared = summary["pairs"].as_array().unwrap();
    assert_eq!(compared.len(), 8);
    assert!(compared.iter().all(|pair| pair["a"] == methods[0]["method"] && pair["b"] != pair["a"]), "{compared:?}");
}

#[test]
fn run_and_summary_record_program_machine_and_rules() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let paths = ["first", "second", "both"].map(|name| folder.path().join(name));
    let json = |path: &Path| -> Value { serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap() };
    for (path, trials, threads) in [(&paths[0], 0..1, 1), (&paths[1], 1..2, 2)] {
        let options = RunOptions { threads: Some(threads), interrupted: &|| false, progress: &mut |_| {} };
        BatchFolder::open(path, &experiment, trials, false).unwrap().run(&experiment, options).unwrap();
    }
    for file in ["run.json", "summary.json"] {
        let known = json(&paths[0].join(file));
        let origin = &known["origins"][0];
        assert_eq!((&origin["program"], &origin["threads"]), (&"cdpr".into(), &1.into()), "{file}");
        assert_eq!(origin["version"], env!("CARGO_PKG_VERSION"));
        assert!(origin["os"].as_str().unwrap().starts_with(std::env::consts::OS));
        assert!(origin["cores"].as_u64() >= Some(1) && origin["architecture"] == std::env::consts::ARCH);
        assert!(!cfg!(all(target_os = "linux", target_arch = "x86_64")) || origin["cpu"].as_str().unwrap().len() > 3);
        let rules = known["rules"].as_array().unwrap();
        let [sweep, rrt] = &rules[..] else { panic!("{rules:?}") };
        let of = |rules: &Value, key: &str| rules[key].as_str().unwrap().to_string();
        assert_eq!(
            ["method", "planner", "engine", "interference"].map(|key| of(sweep, key)),
            ["sweep", "modified-rrt", "cspace", "exact"]
        );
        assert_eq!(["method", "planner", "post"].map(|key| of(rrt, key)), ["rrt", "rrt", "forward"]);
        assert_eq!((&rrt["options"]["goal_bias"], &sweep["sweep"]["repeats"][1]), (&0.05.into(), &10.into()));
    }
    // A complete run that is resumed computed nothing; a merged run has the origins of its parts.
    merge(&paths[..2], &paths[2]).unwrap();
    let origins = json(&paths[2].join("summary.json"))["origins"].clone();
    let threads: Vec<_> = origins.as_array().unwrap().iter().map(|origin| origin["threads"].clone()).collect();
    assert_eq!(threads, [1, 2]);
    let mut again = BatchFolder::open(&paths[0], &experiment, 0..1, true).unwrap();
    let options = RunOptions { threads: Some(7), interrupted: &|| false, progress: &mut |_| {} };
    again.run(&experiment, options).unwrap();
    assert_eq!(json(&paths[0].join("run.json"))["origins"].as_array().unwrap().len(), 1);
}

#[test]
fn both_engines_reproduce_the_papers_table() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(repository().join("experiments/table2_paper.toml")).unwrap();
    let text = text.replace("../testdata/scenes", "SCENES");
    let paper = experiment(folder.path(), &text).unwrap();
    assert_eq!((paper.trials, paper.layout.t_tests.len()), (1000, 18));
    for rules in paper.rules() {
        assert_eq!((rules.engine.as_str(), rules.interference.as_str()), ("gjk", "swept"), "{}", rules.method);
        let post = if rules.method.ends_with("post-processing") { "backward" } else { "none" };
        assert_eq!((rules.post.as_str(), rules.step), (post, 0.1));
    }
    assert!(paper.layout.t_tests.iter().all(|test| test.variances == Comparison::Pooled));
    let fast = experiment(folder.path(), &text.replace("engine = \"gjk\"", "engine = \"cspace\"")).unwrap();
    let trials = |experiment: &Experiment| {
        let options = RunOptions { threads: None, interrupted: &|| false, progress: &mut |_| {} };
        BatchRows::run(experiment, 0..2, options).unwrap().tables().unwrap().trials
    };
    assert_eq!(trials(&paper), trials(&fast));
}

#[test]
fn ranges_of_trials_merge_to_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let [whole, low, high, merged] = ["whole", "low", "high", "merged"].map(|name| folder.path().join(name));
    run(&whole, &experiment, 2, usize::MAX, false).unwrap();
    for (path, trials) in [(&low, 0..5), (&high, 5..12)] {
        let options = RunOptions { threads: None, interrupted: &|| false, progress: &mut |_| {} };
        BatchFolder::open(path, &experiment, trials, false).unwrap().run(&experiment, options).unwrap();
    }
    merge(&[high.clone(), low.clone()], &merged).unwrap();
    assert_eq!(table(&whole), table(&merged));
    let told = |folders: &[PathBuf]| merge(folders, folder.path().join("no")).unwrap_err().to_string();
    assert!(told(&[whole.clone(), high.clone()]).contains("found trials from 5, expected trials from 12 on"));
    assert!(told(&[folder.path().join("nowhere")]).contains("found no run.json"));
    let other = self::experiment(folder.path(), &SMALL.replace("seed = 3", "seed = 4")).unwrap();
    let stranger = folder.path().join("stranger");
    BatchFolder::open(&stranger, &other, 12..13, false).unwrap();
    assert!(told(&[whole, stranger]).contains("another experiment"));
}

#[test]
fn folders_that_are_not_ours_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let path = folder.path().join("out");
    run(&path, &experiment, 2, 3, false).unwrap_err();
    let told = |experiment: &Experiment, trials, resume| {
        BatchFolder::open(&path, experiment, trials, resume).unwrap_err().to_string()
    };
    assert!(told(&experiment, 0..12, false).contains("not empty"));
    assert!(told(&experiment, 2..12, true).contains("found a run from trial 0, expected one from 2"));
    assert!(told(&experiment, 4..4, true).contains("at least one trial"));
    let other = self::experiment(folder.path(), &SMALL.replace("[0.1, 0.02]", "[0.1, 0.03]")).unwrap();
    assert!(told(&other, 0..12, true).contains("another experiment"));
    assert!(
        BatchFolder::open(folder.path(), &experiment, 0..12, true).unwrap_err().to_string().contains("no run.json")
    );
    let file = folder.path().join("experiment.toml").join("out");
    assert!(BatchFolder::open(&file, &experiment, 0..12, false).unwrap_err().to_string().contains("cannot be created"));
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let path = folder.path().join("out");
    let mut opened = BatchFolder::open(&path, &experiment, 0..12, false).unwrap();
    std::os::unix::fs::symlink("/dev/full", path.join("rows/0000.csv")).unwrap();
    let options = RunOptions { threads: Some(2), interrupted: &|| false, progress: &mut |_| {} };
    let told = opened.run(&experiment, options).unwrap_err().to_string();
    assert!(told.contains("0000.csv: cannot be written: No space left"), "{told}");
}

#[test]
fn a_scenario_that_can_never_be_free_ends_the_run_with_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let wide = SMALL.replace("{ count = 2 }", "{ count = 1, width = [2.0, 2.0], height = [1.0, 1.0], attempts = 9 }");
    let experiment = experiment(folder.path(), &wide).unwrap();
    let told = run(&folder.path().join("out"), &experiment, 2, usize::MAX, false).unwrap_err().to_string();
    assert!(told.contains("scenarios[1].random: found no free scene in 9 draws"), "{told}");
}

#[test]
fn each_method_sets_its_own_path_decision() {
    const CLOSED: &str = r#"
version = 1
trials = 2
[[scenarios]]
name = "closed"
scene = "SCENES/closed.toml"
[[scenarios]]
name = "none drawn"
scene = "SCENES/closed.toml"
random = { count = 1 }
[[methods]]
name = "decided"
options = { max_samples = 200 }
[[methods]]
name = "searched"
options = { max_samples = 200 }
proof = false
[[methods]]
name = "hurried"
options = { max_samples = 200 }
budget_ms = 0.001
[[methods]]
name = "patient"
options = { max_samples = 200 }
budget_ms = 60000
"#;
    let folder = tempfile::tempdir().unwrap();
    let experiment = experiment(folder.path(), CLOSED).unwrap();
    let path = folder.path().join("run");
    run(&path, &experiment, 1, usize::MAX, false).unwrap();
    let mut rows = 0;
    for row in csv::Reader::from_path(path.join("trials.csv")).unwrap().deserialize() {
        let TrialRow { scenario, method, status, .. } = row.unwrap();
        let ended = if method == "decided" || method == "patient" { "no_path" } else { "budget_spent" };
        assert_eq!(status.name(), ended, "{scenario}, {method}");
        rows += 1;
    }
    assert_eq!(rows, 16);
    let known: Value = serde_json::from_str(&fs::read_to_string(path.join("summary.json")).unwrap()).unwrap();
    let proofs: Vec<_> = known["rules"].as_array().unwrap().iter().map(|rules| rules.get("proof")).collect();
    assert_eq!(proofs, [None, Some(&Value::Bool(false)), None, None]);
}

#[test]
fn bad_experiments_name_key_finding_and_expectation() {
    let folder = tempfile::tempdir().unwrap();
    for (from, to, message) in [
        ("trials = 12", "trials = 0", "trials: found 0, expected at least 1"),
        ("trials = 12", "trails = 12", "did you mean `trials`?"),
        ("version = 1", "version = 2", "version: found 2, expected 1"),
        ("planner = \"rrt\"", "planner = \"rtt\"", "methods[1].planner: found \"rtt\""),
        ("post = \"forward\"", "post = \"sideways\"", "methods[1].post: found \"sideways\""),
        ("goal_bias = 0.05", "goal_bias = 5.0", "methods[1].options.goal_bias: found 5"),
        ("goal_bias = 0.05", "gaol_bias = 0.05", "did you mean `goal_bias`?"),
        ("step = [0.1, 0.02]", "step = [0.1, 0.1]", "methods: found the name \"sweep, step 0.1, repeats 01\" twice"),
        ("step = [0.1, 0.02]", "step = [0.1, -1.0]", "step: found -1 m"),
        ("name = \"rrt\"", "name = \" \"", "methods[1].name"),
        ("hard1.toml", "hard9.toml", "hard9.toml: cannot be read"),
        (
            "a = [\"hard1\", \"rrt\"]",
            "a = [\"hard2\", \"rrt\"]",
            "t_tests[0].a: found \"hard2\", expected the name of a scenario",
        ),
        ("measure = \"cost\"", "measure = \"costs\"", "did you mean `cost`?"),
        ("count = 2", "count = 2, width = [1.0, 0.5]", "scenarios[1].random.width"),
        ("seed = 3", "seed = 3\nconfidence = 1.5", "confidence: found 1.5"),
        ("post = \"forward\"", "budget_ms = -2.0", "methods[1].budget_ms: found -2 ms"),
        ("post = \"forward\"", "proof = \"no\"", "methods[1].proof: found the string \"no\", expected true or false"),
    ] {
        let told = experiment(folder.path(), &SMALL.replacen(from, to, 1)).unwrap_err().to_string();
        assert!(told.contains(message), "{told}, expected {message}");
    }
}

#[test]
fn the_experiments_of_the_repository_load() {
    let planners = load_experiment(repository().join("experiments/planners.toml")).unwrap();
    assert!(planners.layout.history);
    for (name, rows) in
        [("table2", 8), ("radii", 4), ("fig7", 50), ("fig8", 20), ("orders_paper", 10), ("ablations", 24)]
    {
        let experiment = load_experiment(repository().join(format!("experiments/{name}.toml"))).unwrap();
        let groups = &experiment.layout.groups;
        assert_eq!((experiment.trials, groups.iter().map(|g| g.methods.len()).sum::<usize>()), (1000, rows));
    }
    let turning = load_experiment(repository().join("experiments/turning.toml")).unwrap();
    assert!(
        turning.layout.history && turning.layout.groups.len() == 9 && turning.layout.groups.iter().all(|g| g.turns)
    );
}

#[test]
fn two_runs_do_not_share_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let path = folder.path().join("run");
    let first = BatchFolder::open(&path, &experiment, 0..2, false).unwrap();
    let second = BatchFolder::open(&path, &experiment, 0..2, true).unwrap_err().to_string();
    assert!(second.contains("run: found another process working in this folder"), "{second}");
    drop(first);
    BatchFolder::open(&path, &experiment, 0..2, true).unwrap();
}

#[test]
fn rows_travel_as_bytes_and_the_experiment_as_text() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = small(&folder);
    let [whole, saved] = ["whole", "saved"].map(|name| folder.path().join(name));
    run(&whole, &experiment, 2, usize::MAX, false).unwrap();
    let text = serde_json::to_string(&experiment.portable).unwrap();
    let sent = experiment_from_text(&text, Notation::Json, Some(Path::new("/nowhere"))).unwrap();
    assert_eq!((&sent.fingerprint, &sent.layout), (&experiment.fingerprint, &experiment.layout));
    let part = |trials| {
        let options = RunOptions { threads: Some(1), interrupted: &|| false, progress: &mut |_| {} };
        BatchRows::run(&sent, trials, options).unwrap().into_groups()
    };
    let groups: Vec<Vec<u8>> = part(0..5).into_iter().zip(part(5..12)).map(|(a, b)| [a, b].concat()).collect();
    let rows = BatchRows::new(&experiment, 0..12, groups.clone()).unwrap();
    rows.save(&saved).unwrap();
    assert_eq!(table(&saved), table(&whole));
    assert_eq!(rows.tables().unwrap().trials, table(&whole).into_bytes());
    run(&saved, &experiment, 1, usize::MAX, true).unwrap(); // usable like any other folder
    let summary: Value = serde_json::from_str(&fs::read_to_string(saved.join("summary.json")).unwrap()).unwrap();
    let method = |name: &str| summary["methods"].as_array().unwrap().iter().find(|m| m["method"] == name).unwrap();
    assert_eq!(method("sweep, step 0.02, repeats 10")["sweep"]["repeats"], 10);
    assert!(method("rrt").get("sweep").is_none());
    let short = BatchRows::new(&experiment, 0..13, groups.clone()).unwrap_err().to_string();
    assert!(short.contains("found [48, 12, 48, 12] rows by group, expected [52, 13, 52, 13]"), "{short}");
    let other = BatchRows::new(&experiment, 1..13, groups).unwrap().tables().unwrap_err().to_string();
    assert!(other.contains("found trial 0 of drawn, rrt where trial 1"), "{other}");
}

#[test]
fn a_scene_may_stand_in_the_experiment() {
    let place = |scene: &str| {
        let text = format!(
            r#"{{"version": 1, "trials": 1, "methods": [{{"name": "m"}}], "scenarios": [{{"name": "s", "scene": {scene}}}]}}"#
        );
        experiment_from_text(&text, Notation::Json, None).map_err(|e| e.to_string())
    };
    let scene = serde_json::to_string(hard1().spec()).unwrap();
    assert_eq!(place(&scene).unwrap().scenarios[0].scene, hard1());
    let told = place(&scene.replace("\"cables\"", "\"cabels\"")).unwrap_err();
    assert!(told.contains("scenarios[0].scene") && told.contains("did you mean `cables`"), "{told}");
    assert!(place("7").unwrap_err().contains("expected a scene table or the path of a scene file"));
}
