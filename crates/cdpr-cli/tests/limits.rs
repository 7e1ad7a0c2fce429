//! Ctrl-C and time budgets, for every command, at any time.
//!
//! The best of several runs counts, and limits are far above the intended times, since the machine may be busy.
#![cfg(unix)]

mod support;

use std::fmt::Write as _;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, ExitStatus, Output, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use support::{folder, status, stderr, testdata};

/// Time within which an interrupted command must end; the intention is 0.1 s.
const AT_ONCE: Duration = Duration::from_millis(400);

/// How far a call may exceed the budget, without the start of the program, which takes several milliseconds in the tests' profile.
const LATE: f64 = 20.0; // ms

/// Number of runs of an interrupted command, of which the best counts.
const RUNS: usize = 3;

/// Runs of a command with a budget: a few milliseconds are soon lost on a busy machine.
const BUDGETED_RUNS: usize = 40;

/// Held by each test, since tests running at the same time would disturb each other's times.
static ALONE: Mutex<()> = Mutex::new(());

fn alone() -> MutexGuard<'static, ()> {
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Numbers in [0, 1), the same each time.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// A hall with 300 boxes below a robot that hangs from its ceiling, and 2 cm of clearance.
fn crowded() -> String {
    let mut text = "version = 1\nname = \"crowded\"\nclearance = 0.02\n\
                    [workspace]\nmin = [0, 0, 0]\nmax = [12, 8, 6]\n\
                    [query]\nstart = [1.5, 1.5, 1.5]\ngoal = [10.5, 6.5, 1.5]\n\
                    [robot]\nname = \"hanging\"\nmass = 20.0\n[[robot.platform]]\nbox = [0.4, 0.4, 0.2]\n"
        .to_string();
    for (k, [x, y]) in [[0.0, 0.0], [12.0, 0.0], [12.0, 8.0], [0.0, 8.0]].into_iter().enumerate() {
        let (a, b) = (if k == 0 || k == 3 { -0.2 } else { 0.2 }, if k < 2 { -0.2 } else { 0.2 });
        for (z, c) in [(6.0, 0.1), (5.6, -0.1)] {
            writeln!(
                text,
                "[[robot.cables]]\noutlet = [{x}, {y}, {z}]\nattachment = [{a}, {b}, {c}]\ntension = [5.0, 5000.0]"
            )
            .unwrap();
        }
    }
    let mut numbers = Numbers(7);
    let mut boxes = 0;
    while boxes < 300 {
        let [x, y] = [numbers.between(0.3, 11.7), numbers.between(0.3, 7.7)];
        let height = numbers.between(0.5, 2.0);
        if [[1.5, 1.5], [10.5, 6.5]].iter().any(|[a, b]| (x - a).hypot(y - b) < 1.2) {
            continue;
        }
        let [w, d] = [numbers.between(0.05, 0.25), numbers.between(0.05, 0.25)];
        writeln!(text, "[[obstacles]]\nbox = [{w}, {d}, {height}]\nposition = [{x}, {y}, {}]", 0.5 * height).unwrap();
        boxes += 1;
    }
    text
}

/// A folder with the scenes, paths and an experiment.
struct Place {
    folder: tempfile::TempDir,
    /// The files that exist from the start.
    given: Vec<String>,
}

/// Name of a scene, and a free place in it from which its path goes up.
const SCENES: [(&str, [f64; 3]); 4] = [
    ("hard1", [0.3, 1.0, 0.3]),
    ("forest", [1.0, 1.0, 1.0]),
    ("cogiro", [0.0, 0.0, 1.5]),
    ("crowded", [1.5, 1.5, 1.5]),
];

impl Place {
    fn new() -> Self {
        let folder = folder();
        fs::write(folder.path().join("crowded.toml"), crowded()).unwrap();
        for (name, [x, y, z]) in SCENES {
            let mut path = "x,y,z\n".to_string();
            for k in 0..6000 {
                let (side, up) = (0.02 * f64::from(k % 2), 0.5 * f64::from(k) / 6000.0);
                writeln!(path, "{},{y},{}", x + side, z + up).unwrap();
            }
            fs::write(folder.path().join(format!("{name}.csv")), path).unwrap();
            let scene = Self::scene(name);
            let experiment = format!(
                "version = 1\nname = \"{name}\"\ntrials = 100000\n[[scenarios]]\nname = \"{name}\"\nscene = {scene:?}\n\
                 [[methods]]\nname = \"connect\"\nplanner = \"rrt-connect\"\n\
                 [[methods]]\nname = \"star\"\nplanner = \"rrt-star\"\n"
            );
            fs::write(folder.path().join(format!("{name}-experiment.toml")), experiment).unwrap();
        }
        let given = names(folder.path());
        Place { folder, given }
    }

    fn scene(name: &str) -> String {
        if name == "crowded" { "crowded.toml".to_string() } else { testdata(&format!("scenes/{name}.toml")) }
    }

    /// Checks that all files written by a command are complete, then removes them.
    fn assert_whole_and_clear(&self, what: &str) {
        for name in names(self.folder.path()) {
            if self.given.contains(&name) {
                continue;
            }
            let path = self.folder.path().join(&name);
            if path.is_dir() {
                assert_eq!(name, "run", "{what} left {name}");
                let inside: Vec<String> = [names(&path), names(&path.join("rows"))].concat();
                assert!(inside.iter().all(|name| !name.starts_with(".tmp")), "{what} left {inside:?}");
                fs::remove_dir_all(path).unwrap();
                continue;
            }
            let bytes = fs::read(&path).unwrap();
            let whole = match path.extension().and_then(|e| e.to_str()) {
                Some("json") => serde_json::from_slice::<serde_json::Value>(&bytes).is_ok(),
                Some("html") => bytes.trim_ascii_end().ends_with(b"</html>"),
                Some("obj") => bytes.ends_with(b"\n"),
                Some("npz") => bytes.windows(4).any(|word| word == b"PK\x05\x06"), // the end of a ZIP archive
                _ => false,
            };
            assert!(whole, "{what} left {name}");
            fs::remove_file(path).unwrap();
        }
    }

    fn start(&self, arguments: &[String]) -> std::process::Child {
        Command::new(assert_cmd::cargo::cargo_bin("cdpr"))
            .current_dir(self.folder.path())
            .env("TMPDIR", self.folder.path())
            .args(arguments)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    }
}

/// The names in a folder; empty if the folder does not exist.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

fn send(signal: &str, child: &std::process::Child) {
    // It may have ended already.
    let _ = Command::new("kill").args(["-s", signal, &child.id().to_string()]).stderr(Stdio::null()).status().unwrap();
}

/// The commands on a scene.
fn commands(name: &str) -> Vec<Vec<String>> {
    let (scene, path) = (Place::scene(name), format!("{name}.csv"));
    let step = if name == "hard1" { "0.02" } else { "0.1" };
    let endless = ["--keep-going", "--max-samples", "1000000000"];
    let commands: Vec<Vec<&str>> = vec![
        vec!["plan", &scene, "-o", "out.json", "--html", "view.html"],
        [&["plan", &scene, "-o", "out.json", "--planner", "rrt-star"][..], &endless].concat(),
        [&["plan", &scene, "-o", "out.json", "--planner", "modified-rrt"][..], &endless].concat(),
        vec!["check", &scene, &path],
        vec!["check", &scene, &path, "--engine", "gjk"],
        vec!["info", &scene],
        vec!["post", &scene, &path, "-o", "shorter.json", "--post", "taut"],
        vec!["view", &scene, &path, "-o", "view.html"],
        vec!["shadows", &scene, "-o", "shadows.obj", "--all"],
        vec!["wrench", &scene, "--grid", step, "-o", "margins.npz"],
    ];
    let mut commands: Vec<Vec<String>> =
        commands.into_iter().map(|command| command.into_iter().map(str::to_string).collect()).collect();
    commands.push(["batch".to_string(), format!("{name}-experiment.toml"), "-o".into(), "run".into()].into());
    commands
}

/// Runs a command, interrupts it after a while, and returns its status and the time it took to end.
fn interrupted(place: &Place, arguments: &[String], signal: &str, moment: Duration) -> (ExitStatus, Duration) {
    let mut child = place.start(arguments);
    std::thread::sleep(moment);
    let sent = Instant::now();
    send(signal, &child);
    (child.wait().unwrap(), sent.elapsed())
}

#[test]
fn every_command_stops_promptly_without_partial_files() {
    let _alone = alone();
    let place = Place::new();
    let mut numbers = Numbers(1);
    let mut stopped = 0;
    for (name, _) in SCENES {
        for command in commands(name) {
            let signal = if numbers.next() < 0.5 { "INT" } else { "TERM" };
            // Early moments are as likely as late ones, on a scale of factors.
            let moment = Duration::from_secs_f64(1e-3 * 400f64.powf(numbers.next()));
            let what = format!("{} after {moment:?}, {signal}", command.join(" "));
            let mut least = Duration::MAX;
            for _ in 0..RUNS {
                let (ended, waited) = interrupted(&place, &command, signal, moment);
                // Before its first line the program has no handler, and the signal itself ends it.
                let code = ended.code().or(ended.signal().filter(|s| [2, 15].contains(s)).map(|_| 130));
                let refused = command[0] == "post" && code == Some(2); // a path that is not valid cannot be shortened
                assert!(matches!(code, Some(0 | 1 | 130)) || refused, "{what}: {ended}");
                stopped += usize::from(ended.code() == Some(130));
                place.assert_whole_and_clear(&what);
                least = least.min(waited);
                if least < AT_ONCE {
                    break;
                }
            }
            assert!(least < AT_ONCE, "{what}: {least:?}");
        }
    }
    assert!(stopped > 10, "{stopped} of the commands were stopped");
}

/// Later moments, if there was no path at the first one.
const MOMENTS: [f64; 4] = [0.3, 1.0, 3.0, 9.0]; // s

#[test]
fn a_found_path_is_written_despite_an_interruption() {
    let _alone = alone();
    let place = Place::new();
    let scene = Place::scene("hard1");
    let plan = ["plan", &scene, "-o", "out.json", "--max-samples", "1000000000", "--keep-going"];
    let motion = ["--trajectory", "motion.json", "--speed", "1", "--acceleration", "2"];
    let further: [&[&str]; 9] = [
        &["--planner", "two-trees"],
        &["--planner", "rrt-connect"],
        &["--planner", "rrt", "--goal-bias", "0.1"],
        &["--planner", "rrt-star", "--goal-bias", "0.1"],
        &["--planner", "modified-rrt"],
        &["--planner", "anytime"],
        &["--planner", "rrt-connect", "--proof", "proof.json"],
        &motion,
        &[&motion[..], &["--minimise", "time"]].concat(),
    ];
    for more in further {
        let command: Vec<String> = plan.iter().chain(more).map(|word| word.to_string()).collect();
        let what = command.join(" ");
        let written = MOMENTS.into_iter().any(|moment| {
            let (ended, _) = interrupted(&place, &command, "INT", Duration::from_secs_f64(moment));
            assert_eq!(ended.code(), Some(130), "{what}");
            place.folder.path().join("out.json").exists()
        });
        assert!(written, "{what}");
        let checked = place.start(&["check".to_string(), scene.clone(), "out.json".to_string()]).wait().unwrap();
        assert_eq!(checked.code(), Some(0), "{what}");
        place.assert_whole_and_clear(&what);
    }
}

#[test]
fn a_script_that_ignores_ctrl_c_for_its_children_can_stop_them() {
    let _alone = alone();
    let place = Place::new();
    let program = assert_cmd::cargo::cargo_bin("cdpr");
    let mut child = Command::new("sh")
        .current_dir(place.folder.path())
        .args(["-c", "trap '' INT; exec \"$@\"", "sh"])
        .arg(program)
        .args(["plan", "crowded.toml", "--planner", "rrt-star", "--keep-going", "--max-samples", "1000000000"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(500));
    send("INT", &child);
    let patience = Instant::now();
    while child.try_wait().unwrap().is_none() && patience.elapsed() < Duration::from_secs(10) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let ended = child.try_wait().unwrap();
    let _ = child.kill();
    assert_eq!(ended.and_then(|ended| ended.code()), Some(130));
}

/// A plan with a budget of two seconds, started by a shell in a particular way.
fn started_by(place: &Place, script: &str) -> std::process::Child {
    Command::new("sh")
        .current_dir(place.folder.path())
        .args(["-c", script, "sh"])
        .arg(assert_cmd::cargo::cargo_bin("cdpr"))
        .args(["plan", "crowded.toml", "--planner", "rrt-star", "--keep-going", "--max-samples", "1000000000"])
        .args(["--budget-ms", "2000", "-o", "out.json"])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

#[test]
fn a_hangup_ends_a_command_like_sigterm() {
    let _alone = alone();
    let place = Place::new();
    let mut child = started_by(&place, "exec \"$@\"");
    std::thread::sleep(Duration::from_millis(500));
    let sent = Instant::now();
    send("HUP", &child);
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(sent.elapsed() < Duration::from_secs(1), "{:?}", sent.elapsed());
    place.assert_whole_and_clear("a plan that was hung up on");
}

#[test]
fn nohup_survives_sighup_but_not_sigterm() {
    let _alone = alone();
    let place = Place::new();
    for script in ["exec nohup \"$@\"", "trap '' HUP; exec \"$@\""] {
        let mut child = started_by(&place, script);
        for _ in 0..5 {
            std::thread::sleep(Duration::from_millis(100));
            send("HUP", &child);
        }
        let code = child.wait().unwrap().code();
        assert!(matches!(code, Some(0 | 1)), "{script}: {code:?}"); // its budget ended it
        assert!(place.folder.path().join("out.json").exists(), "{script}");
        place.assert_whole_and_clear(script);
        let mut child = started_by(&place, script);
        std::thread::sleep(Duration::from_millis(500));
        send("TERM", &child);
        assert_eq!(child.wait().unwrap().code(), Some(130), "{script}");
        place.assert_whole_and_clear(script);
    }
}

/// Measures how late plans are.
struct Clock {
    place: Place,
    /// The least time that the program takes to start and end, ms.
    start: f64,
}

impl Clock {
    fn new() -> Self {
        let place = Place::new();
        let start = (0..10).map(|_| milliseconds(&place, &["--version"]).0).fold(f64::INFINITY, f64::min);
        Clock { place, start }
    }

    /// Time of a plan beyond its budget, ms. The start of the program and reading the scene, which the budget does not count, are
    /// taken off.
    fn late(&self, scene: &str, options: &[&str], budget: &str) -> f64 {
        let scene = Place::scene(scene);
        let arguments = [&["plan", &scene, "--budget-ms", budget, "-v"], options].concat();
        let (taken, output) = milliseconds(&self.place, &arguments);
        assert!(matches!(status(&output), 0 | 1), "{arguments:?}: {}", stderr(&output));
        let told = stderr(&output);
        let reading = told.lines().find_map(|line| line.strip_prefix("read ")?.split_once(" in ")?.1.split_once(" ms"));
        taken - self.start - reading.expect(&told).0.parse::<f64>().unwrap() - budget.parse::<f64>().unwrap()
    }

    /// Asserts that one of several runs of a plan ends with its budget.
    fn assert_in_time(&self, runs: usize, scene: &str, options: &[&str], budget: &str) {
        let mut least = f64::INFINITY;
        for _ in 0..runs {
            least = least.min(self.late(scene, options, budget));
            if least <= LATE {
                return;
            }
        }
        panic!("{scene}, {options:?}, {budget} ms: {least:.1} ms late");
    }
}

fn milliseconds(place: &Place, arguments: &[&str]) -> (f64, Output) {
    let clock = Instant::now();
    let output = support::cdpr_in(place.folder.path(), arguments);
    (1e3 * clock.elapsed().as_secs_f64(), output)
}

#[test]
fn rewinding_in_tiny_steps_ends_with_its_budget() {
    let _alone = alone();
    let options = ["--planner", "modified-rrt", "--step", "1e-9"];
    Clock::new().assert_in_time(BUDGETED_RUNS, "hard1", &options, "200");
}

#[test]
fn a_decision_that_runs_out_of_time_tells_the_narrowest_opening_within_the_budget() {
    let _alone = alone();
    let options = ["--planner", "rrt", "--max-samples", "1000000"];
    Clock::new().assert_in_time(3, "cogiro", &options, "1000");
}

#[test]
fn a_budget_holds_from_the_call_to_the_answer() {
    let _alone = alone();
    let clock = Clock::new();
    for (name, _) in SCENES {
        for planner in ["anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"] {
            for budget in ["1", "5", "50"] {
                clock.assert_in_time(BUDGETED_RUNS, name, &["--planner", planner], budget);
            }
        }
    }
}
