//! No reader may hang, run out of memory or panic on any file: special files, huge ones, deeply nested ones.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cdpr_core::Error;
use cdpr_core::limits::{MOST_BODIES, MOST_CABLES, MOST_CORNERS, MOST_POLYGON_CORNERS, MOST_TEXT_BYTES};
use cdpr_files::{
    ImportOptions, import_robot, load_if_task, load_lengths, load_mesh, load_robot, load_scene, load_waypoints,
    load_wrench_map,
};
use cdpr_study::{load_experiment, load_study, merge};

/// Rejecting a file takes some seconds at most; a busy machine gets a minute.
const PATIENCE: Duration = Duration::from_secs(60);

type Reader = fn(&Path) -> Result<(), Error>;

/// Every reader of a file, by the name that the file must have in its folder.
const READERS: [(&str, Reader); 16] = [
    ("scene.toml", |path| load_scene(path).map(drop)),
    ("scene.json", |path| load_scene(path).map(drop)),
    ("robot.toml", |path| load_robot(path).map(drop)),
    ("path.json", |path| load_waypoints(path).map(drop)),
    ("path.csv", |path| load_waypoints(path).map(drop)),
    ("task.json", |path| match load_if_task(path)? {
        Some(_) => Ok(()),
        None => load_waypoints(path).map(drop), // as `cdpr check` does
    }),
    ("lengths.csv", |path| load_lengths(path, cdpr_core::testing::empty().robot()).map(drop)),
    ("experiment.toml", |path| load_experiment(path).map(drop)),
    ("robot.xml", |path| {
        let options = ImportOptions { bodies: Some(path.to_path_buf()), ..ImportOptions::default() };
        import_robot(path, &options).map(drop)
    }),
    ("robot.yaml", |path| import_robot(path, &ImportOptions::default()).map(drop)),
    ("mesh.stl", |path| load_mesh(path).map(drop)),
    ("mesh.obj", |path| load_mesh(path).map(drop)),
    ("map.npz", |path| load_wrench_map(path, None).map(drop)),
    ("run.json", |path| merge(&[path.with_file_name("")], path.with_file_name("merged")).map(drop)),
    ("summary.json", |path| load_study(path.with_file_name("")).map(drop)),
    ("trials.csv", |path| {
        let summary =
            "{\"experiment\": \"\", \"fingerprint\": \"\", \"confidence\": 0.9, \"methods\": [], \"t_tests\": []}";
        fs::write(path.with_file_name("summary.json"), summary).unwrap();
        load_study(path.with_file_name("")).map(drop)
    }),
];

/// The message of every reader for a file that `make` creates; no reader may take long.
fn refusals(make: impl Fn(&Path)) -> Vec<(&'static str, String)> {
    let refusal = |(name, reader): (&'static str, Reader)| {
        let folder = tempfile::tempdir().unwrap();
        let path: PathBuf = folder.path().join(name);
        make(&path);
        let (done, waits) = std::sync::mpsc::channel();
        let own = path.clone();
        std::thread::spawn(move || done.send(reader(&own)));
        let answer = waits.recv_timeout(PATIENCE).unwrap_or_else(|_| panic!("{name} hangs"));
        let message = answer.expect_err(name).to_string();
        assert!(message.contains(folder.path().to_str().unwrap()), "{name}: no file in: {message}");
        (name, message)
    };
    READERS.into_iter().map(refusal).collect()
}

#[test]
fn special_files_are_refused_by_every_reader() {
    for (name, message) in refusals(|path| fs::create_dir(path).unwrap()) {
        assert!(message.contains("folder"), "{name}: {message}");
    }
    for (name, message) in refusals(|_| {}) {
        assert!(message.contains("No such file") || message.contains("found no"), "{name}: {message}");
    }
}

#[cfg(unix)]
#[test]
fn pipes_devices_and_loops_are_refused_by_every_reader() {
    use std::os::unix::fs::symlink;
    let pipe = |path: &Path| assert!(std::process::Command::new("mkfifo").arg(path).status().unwrap().success());
    for (name, message) in refusals(pipe) {
        assert!(message.contains("not a regular file") || message.contains("found no"), "{name}: {message}");
    }
    for device in ["/dev/zero", "/dev/random", "/dev/tty"].into_iter().filter(|device| Path::new(device).exists()) {
        for (name, message) in refusals(|path| symlink(device, path).unwrap()) {
            assert!(message.contains("not a regular file") || message.contains("found no"), "{name}: {message}");
        }
    }
    refusals(|path| symlink(path, path).unwrap());
}

#[cfg(unix)]
#[test]
fn a_scene_that_names_a_device_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    std::os::unix::fs::symlink("/dev/zero", folder.path().join("zero.obj")).unwrap();
    std::os::unix::fs::symlink("/dev/zero", folder.path().join("zero.toml")).unwrap();
    let scene = folder.path().join("scene.toml");
    for (robot, mesh, expected) in [
        ("zero.toml", "zero.obj", "zero.toml: is not a regular file"),
        ("PAPER", "zero.obj", "zero.obj: is not a regular file"),
        ("PAPER", "/dev/zero", "found the extension (none)"),
        ("PAPER", "../../../../../../../../dev/zero", "found the extension (none)"),
    ] {
        let paper = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/robots/paper.toml");
        let text = format!(
            "version = 1\nrobot = '{}'\nworkspace = {{ min = [0, 0, 0], max = [2, 2, 2] }}\n[[obstacles]]\nmesh = '{mesh}'\n",
            robot.replace("PAPER", paper.to_str().unwrap())
        );
        fs::write(&scene, text).unwrap();
        let message = load_scene(&scene).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn non_utf8_files_are_refused_by_every_reader() {
    for bytes in [&b"\xff\xfe\x00\x01"[..], b"\xc3", b"version = 1 # \xf0\x9f", &[0; 1000], &[b'\xff'; 1000]] {
        let rows = |path: &Path| path.ends_with("trials.csv"); // its head may be any text
        refusals(|path| fs::write(path, [if rows(path) { b"a\n" } else { &b""[..] }, bytes].concat()).unwrap());
    }
}

#[test]
fn huge_files_are_refused_before_being_read() {
    let sparse = |path: &Path| fs::File::create(path).unwrap().set_len(10_000_000_000).unwrap(); // takes no space
    for (name, message) in refusals(sparse) {
        if name != "map.npz" {
            assert!(message.contains(" MB, expected at most"), "{name}: {message}");
        }
    }
}

#[test]
fn self_crossing_polygons_are_read_in_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mesh.obj");
    let vertices: String = (0..1000).map(|k| format!("v {} {} 0\n", k * 617 % 1009, k * 383 % 1013)).collect();
    let polygon =
        |n: usize| "f".to_string() + &(0..n).map(|k| format!(" {}", k * 7919 % 1000 + 1)).collect::<String>() + "\n";
    fs::write(&path, vertices.clone() + &polygon(MOST_POLYGON_CORNERS).repeat(50)).unwrap();
    let begun = Instant::now();
    assert!(load_mesh(&path).is_ok());
    assert!(begun.elapsed() < PATIENCE, "{:?}", begun.elapsed());
    fs::write(&path, vertices + &polygon(100_000)).unwrap();
    let message = load_mesh(&path).unwrap_err().to_string();
    assert!(
        message.ends_with("found a face with 100000 corners, expected at most 2000: triangulate it (line 1001)"),
        "{message}"
    );
}

/// The message that rejects a scene with this text; it must not take long, even while other tests run.
fn refusal(name: &str, text: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    let begun = Instant::now();
    let message = load_scene(&path).unwrap_err().to_string();
    assert!(begun.elapsed() < PATIENCE, "{:?}", begun.elapsed());
    message
}

#[test]
fn nesting_to_any_depth_is_refused() {
    let deep = 200_000;
    for (name, open, close) in [("scene.toml", "a = ", ""), ("scene.json", "", "")] {
        for bracket in [["[", "]"], ["{a=", "}"], ["{\"a\":", "}"]] {
            let text = format!("{open}{}1{}{close}", bracket[0].repeat(deep), bracket[1].repeat(deep));
            refusal(name, &text);
        }
    }
    refusal("scene.toml", &format!("{}a = 1", "a.".repeat(deep)));
    refusal("scene.toml", &format!("[{}a]\nb = 1", "a.".repeat(deep)));
    refusal("scene.toml", &format!("[[{}a]]\nb = 1", "a.".repeat(deep)));
}

#[test]
fn long_names_are_refused_without_a_typo_search() {
    let long = "x".repeat(1_000_000);
    assert!(refusal("scene.toml", &format!("version = 1\n{long} = 1\n")).contains("unknown field"));
    let hard1 =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/scenes/hard1.toml")).unwrap();
    let named = hard1.replace("name = \"pillar\"", &format!("name = \"{long}y\""));
    let text = named.replace("version = 1", &format!("version = 1\nignore = [[\"{long}\", \"platform\"]]"));
    assert!(refusal("scene.toml", &text).contains("ignore[0]"));
}

#[test]
fn oversized_lists_are_refused_with_their_count() {
    let scene = |cables: usize, parts: usize, obstacles: usize, corners: usize| {
        let workspace = "version = 1\nworkspace = { min = [0, 0, 0], max = [2, 2, 2] }\n";
        let cable = "{ outlet = [0, 0, 0], attachment = [0, 0, 0] },".repeat(cables);
        let part = "{ vertices = [[0, 0, 0]] },".repeat(parts);
        let obstacle = format!("{{ vertices = [{}] }},", "[0, 0, 0],".repeat(corners)).repeat(obstacles);
        format!("{workspace}obstacles = [{obstacle}]\n[robot]\ncables = [{cable}]\nplatform = [{part}]\n")
    };
    for (text, expected) in [
        (scene(MOST_CABLES + 1, 1, 1, 1), "robot.cables: found 257"),
        (scene(1, MOST_BODIES + 1, 1, 1), "robot.platform: found 10001"),
        (scene(1, 1, MOST_BODIES + 1, 1), "obstacles: found 10001"),
        (scene(1, 1, 1, MOST_CORNERS + 1), "obstacles[0].vertices: found 1001"),
    ] {
        assert!(refusal("scene.toml", &text).contains(expected), "{expected}");
    }
}

#[test]
fn the_largest_text_of_nonsense_is_refused_in_time() {
    let most = MOST_TEXT_BYTES as usize;
    for (name, text) in [
        ("scene.toml", "a=1\n".repeat(most / 4)),
        ("scene.toml", format!("a = [{}]", "1,".repeat(most / 2 - 4))),
        ("scene.json", format!("[{}1]", "1,".repeat(most / 2 - 4))),
        ("scene.json", format!("{{\"a\": [{}1]}}", "1,".repeat(most / 2 - 8))),
    ] {
        refusal(name, &text);
    }
}
