//! The readers, and the use made of the input that they accept.

use std::path::PathBuf;
use std::sync::{Arc, LazyLock};

use cdpr_core::collision::{Checker, CspaceEngine, GjkEngine, Interference, check_path};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::Point;
use cdpr_core::kinematics::ForwardKinematics;
use cdpr_core::trajectory_check::{TrajectoryRules, check_trajectory};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::measures;
use cdpr_core::{Error, Scene, testing};
use cdpr_files::ImportOptions;
use cdpr_files::text::Notation;
use cdpr_study::report;
use hmac_sha256::Hash;
use serde_json::Value;
use tempfile::TempDir;

/// A reader by its name in the folders of inputs.
#[derive(Debug, Clone, Copy)]
pub struct Reader {
    /// Name.
    pub name: &'static str,
    /// Reads bytes as a file, and uses the result.
    pub read: fn(&[u8]),
}

/// Every reader.
pub const READERS: [Reader; 21] = [
    Reader { name: "scene_toml", read: |bytes| scene("scene.toml", bytes) },
    Reader { name: "scene_json", read: |bytes| scene("scene.json", bytes) },
    Reader { name: "robot_toml", read: robot },
    Reader { name: "path_json", read: |bytes| path("path.json", bytes) },
    Reader { name: "path_csv", read: |bytes| path("path.csv", bytes) },
    Reader { name: "task_json", read: task },
    Reader { name: "lengths_csv", read: lengths },
    Reader { name: "trajectory_json", read: |bytes| trajectory("motion.json", bytes) },
    Reader { name: "trajectory_csv", read: |bytes| trajectory("motion.csv", bytes) },
    Reader { name: "experiment_toml", read: experiment },
    Reader { name: "caspr_cables", read: |bytes| caspr(bytes, &seed("caspr_bodies/cogiro.xml")) },
    Reader { name: "caspr_bodies", read: |bytes| caspr(&seed("caspr_cables/cogiro.xml"), bytes) },
    Reader { name: "gazebo_yaml", read: gazebo },
    Reader { name: "mesh_stl", read: |bytes| mesh("mesh.stl", bytes) },
    Reader { name: "mesh_obj", read: |bytes| mesh("mesh.obj", bytes) },
    Reader { name: "parts_json", read: parts },
    Reader { name: "wrench_map_npz", read: wrench_map },
    Reader { name: "run_json", read: |bytes| run(bytes, &seed("rows_csv/rows.csv")) },
    Reader { name: "rows_csv", read: |bytes| run(&seed("run_json/run.json"), bytes) },
    Reader { name: "summary_json", read: |bytes| study(bytes, &seed("trials_csv/trials.csv")) },
    Reader { name: "trials_csv", read: |bytes| study(&seed("summary_json/summary.json"), bytes) },
];

/// The reader with this name.
///
/// # Panics
/// If there is no such reader.
pub fn reader(name: &str) -> Reader {
    *READERS.iter().find(|reader| reader.name == name).unwrap_or_else(|| panic!("no reader is called {name}"))
}

/// Inputs of this package, a folder for each reader: `seeds` are valid files, `regressions` once revealed defects.
pub fn inputs(kind: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(kind)
}

/// The second file of readers that need two.
fn seed(name: &str) -> Vec<u8> {
    std::fs::read(inputs("seeds").join(name)).expect("a seed")
}

/// A scene or robot with more than these is only read, since engines are not designed for them.
const MOST_CABLES: usize = 10;
const MOST_BODIES: usize = 60;
/// Waypoints of a path that are checked.
const MOST_WAYPOINTS: usize = 200;

/// Legs of a task that are followed.
const MOST_LEGS: usize = 20;

/// Rows of lengths for which poses are looked for.
const MOST_ROWS: usize = 20;

/// A temporary folder of files.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Folder(tempfile::tempdir().expect("a folder for temporary files"))
    }

    fn with(self, name: &str, bytes: &[u8]) -> Self {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder can be made");
        std::fs::write(path, bytes).expect("a file can be written");
        self
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }
}

/// The accepted value; a rejection must have a message.
fn accepted<T>(result: Result<T, Error>) -> Option<T> {
    result.map_err(|error| assert!(error.to_string().contains(' '), "refused with \"{error}\"")).ok()
}

fn scene(name: &str, bytes: &[u8]) {
    let folder = Folder::new().with(name, bytes).with("robot.toml", &seed("robot_toml/paper.toml"));
    accepted(cdpr_files::load_scene(folder.path(name))).iter().for_each(ask);
}

/// Checks the motion of a scene's query, or one across its workspace, with both engines, and the wrenches at the start.
/// The time to certify a motion depends on more than the size of a file.
fn ask(scene: &Scene) {
    serde_json::to_string(scene.spec()).expect("a scene can be written");
    let bodies = scene.robot().parts().len() + scene.obstacles().iter().map(|o| o.parts.len()).sum::<usize>();
    if scene.robot().cables().len() > MOST_CABLES || bodies > MOST_BODIES {
        return;
    }
    let [from, to] = [scene.start().unwrap_or(scene.workspace().min), scene.goal().unwrap_or(scene.workspace().max)];
    let waypoints = [from, from + 0.5 * (to - from), to];
    accepted(GjkEngine::new(scene, Interference::Exact)).iter().for_each(|engine| checked(engine, &waypoints));
    accepted(CspaceEngine::new(scene, Interference::Exact)).iter().for_each(|engine| checked(engine, &waypoints));
    for measure in accepted(measures(scene)).iter().flatten() {
        measure.limit(&from);
    }
}

fn checked(engine: &dyn Checker, waypoints: &[Point]) {
    serde_json::to_string(&accepted(check_path(engine, waypoints, &Watch::NONE))).expect("a report can be written");
}

fn robot(bytes: &[u8]) {
    let folder = Folder::new().with("robot.toml", bytes);
    accepted(cdpr_files::load_robot(folder.path("robot.toml")));
}

/// The scene of the seeds of tasks.
static TOWER: LazyLock<Scene> = LazyLock::new(|| {
    let text = String::from_utf8(seed("scene_toml/tower.toml")).expect("text");
    cdpr_files::scene_from_text(&text, Notation::Toml, None).expect("a scene")
});

/// Follows a task in its scene. Each leg is a scene, so only a few are.
fn task(bytes: &[u8]) {
    let folder = Folder::new().with("task.json", bytes);
    let read = accepted(cdpr_files::load_if_task(folder.path("task.json"))).flatten();
    if let Some(file) = read.filter(|file| file.legs.len() <= MOST_LEGS) {
        accepted(file.legs(&TOWER));
    }
}

static HARD1: LazyLock<(Scene, Arc<CspaceEngine>)> = LazyLock::new(|| {
    let scene = testing::hard1();
    let engine = CspaceEngine::new(&scene, Interference::Exact).expect("an engine");
    (scene, Arc::new(engine))
});

fn path(name: &str, bytes: &[u8]) {
    let folder = Folder::new().with(name, bytes);
    if let Some(loaded) = accepted(cdpr_files::load_waypoints(folder.path(name))) {
        let count = loaded.waypoints.len().min(MOST_WAYPOINTS);
        checked(&*HARD1.1, &loaded.waypoints[..count]);
        let again = folder.path("again.json");
        cdpr_files::save_path(&again, &cdpr_files::PathFile::of(&HARD1.0, &loaded.path(&HARD1.0)))
            .expect("a path can be written");
        assert_eq!(cdpr_files::load_waypoints(&again).expect("what was written").waypoints, loaded.waypoints);
    }
}

/// Solves the first rows, each from the pose before; wild lengths have no pose.
fn lengths(bytes: &[u8]) {
    let folder = Folder::new().with("lengths.csv", bytes);
    let robot = HARD1.0.robot();
    let Some(found) = accepted(cdpr_files::load_lengths(folder.path("lengths.csv"), robot)) else { return };
    let rows = found.rows.iter().take(MOST_ROWS).map(Vec::as_slice);
    let solver = ForwardKinematics::new(robot, None).expect("eight cables");
    for pose in accepted(solver.follow(rows, None, |e, _| e, &Watch::NONE)).unwrap_or_default() {
        assert!(pose.pose.is_finite() && pose.fit().is_finite());
    }
}

/// Checks the trajectory in a scene; JSON is shown, and written in all formats, as well.
fn trajectory(name: &str, bytes: &[u8]) {
    let folder = Folder::new().with(name, bytes);
    let Some(loaded) = accepted(cdpr_files::load_trajectory(folder.path(name))) else { return };
    for name in ["again.json", "again.csv", "again.yaml"] {
        let Some(file) = &loaded.file else { break };
        accepted(cdpr_files::save_trajectory(folder.path(name), file, cdpr_files::MessageFields::default()));
    }
    if loaded.motion.times.len() > MOST_WAYPOINTS {
        return;
    }
    let (hard1, engine) = &*HARD1;
    if let Some((scene, motion, _)) = accepted(cdpr_files::scene_of_loaded(hard1, &loaded, false)) {
        if let Some(file) = &loaded.file {
            let compiled = CompiledScene::with(&scene, engine.clone());
            let violations = file.violations(&compiled, &Watch::NONE).expect("nothing stops it");
            cdpr_view::trajectory_page_within(&scene, file, &violations, &Watch::NONE).expect("nothing stops it");
        }
        let report = accepted(check_trajectory(&scene, &motion, &TrajectoryRules::default(), &Watch::NONE));
        serde_json::to_string(&report).expect("a report can be written");
    }
}

fn experiment(bytes: &[u8]) {
    let folder = Folder::new().with("experiment.toml", bytes).with("scene.toml", &seed("scene_toml/hard1.toml"));
    if let Some(experiment) = accepted(cdpr_study::load_experiment(folder.path("experiment.toml"))) {
        serde_json::to_string(&experiment.portable).expect("an experiment can be written");
    }
}

fn caspr(cables: &[u8], bodies: &[u8]) {
    imported(&Folder::new().with("model_cables.xml", cables).with("model_bodies.xml", bodies), "model_cables.xml");
}

fn gazebo(bytes: &[u8]) {
    imported(&Folder::new().with("robot.yaml", bytes), "robot.yaml");
}

/// An imported robot can be written and read again.
fn imported(folder: &Folder, name: &str) {
    if let Some(imported) = accepted(cdpr_files::import_robot(folder.path(name), &ImportOptions::default())) {
        let robot = folder.path("imported.toml");
        cdpr_files::save_imported(&robot, &imported).expect("a robot can be written");
        let again = cdpr_files::load_robot(&robot).expect("what was written");
        assert_eq!(again.spec(), &imported.robot);
    }
}

/// A scene around a mesh.
const AROUND: &str = "version = 1\nworkspace = { min = [0, 0, 0], max = [2, 2, 2] }\nrobot = \"robot.toml\"\n\
    query = { start = [0.3, 1.0, 0.3], goal = [1.7, 1.0, 1.7] }\n[[obstacles]]\nname = \"mesh\"\nmesh = \"";

fn around(name: &str, bytes: &[u8]) -> Folder {
    let text = format!("{AROUND}{name}\"\n");
    Folder::new()
        .with(name, bytes)
        .with("robot.toml", &seed("robot_toml/paper.toml"))
        .with("scene.toml", text.as_bytes())
}

fn mesh(name: &str, bytes: &[u8]) {
    let folder = around(name, bytes);
    accepted(cdpr_files::load_scene(folder.path("scene.toml"))).iter().for_each(ask);
}

/// Parts cached beside a mesh, with the key and checksum by which they are found; without these, nothing is read.
fn parts(bytes: &[u8]) {
    static KEY: LazyLock<String> = LazyLock::new(|| {
        let folder = around("mesh.obj", &seed("mesh_obj/angle.obj"));
        cdpr_files::load_scene(folder.path("scene.toml")).expect("a sound scene");
        let mut names = std::fs::read_dir(folder.0.path()).expect("a folder").map(|e| e.expect("a file").file_name());
        let kept = names.find(|name| name.to_string_lossy().ends_with(".parts.json")).expect("kept parts");
        let text = std::fs::read_to_string(folder.0.path().join(kept)).expect("a file");
        let kept: Value = serde_json::from_str(&text).expect("JSON");
        kept["key"].as_str().expect("a key").to_string()
    });
    let folder = around("mesh.obj", &seed("mesh_obj/angle.obj"))
        .with(&format!("mesh.obj.{}.parts.json", &KEY[..8]), &signed(bytes));
    accepted(cdpr_files::load_scene(folder.path("scene.toml"))).iter().for_each(ask);

    fn signed(bytes: &[u8]) -> Vec<u8> {
        #[derive(serde::Serialize, serde::Deserialize)]
        struct Parts {
            parts: Vec<Vec<[f64; 3]>>,
            notes: Vec<String>,
        }
        let Ok(parts) = serde_json::from_slice::<Parts>(bytes) else { return bytes.to_vec() };
        let text = serde_json::to_string(&parts).expect("numbers");
        let sum: String = Hash::hash(text.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect();
        format!("{{\"key\":\"{}\",\"sum\":\"{sum}\",{}", *KEY, &text[1..]).into_bytes()
    }
}

fn wrench_map(bytes: &[u8]) {
    let folder = Folder::new().with("map.npz", bytes);
    if let Some(map) = accepted(cdpr_files::load_wrench_map(folder.path("map.npz"), None)) {
        map.summary();
        for name in ["again.npz", "again.vti"] {
            cdpr_files::save_wrench_map(folder.path(name), &map).expect("a map can be written");
        }
    }
}

/// The folder of a run to be merged.
fn run(about: &[u8], rows: &[u8]) {
    let folder = Folder::new().with("run/run.json", about).with("run/rows/0000.csv", rows);
    accepted(cdpr_study::merge(&[folder.path("run")], folder.path("merged")));
}

/// The results of a run to report on.
fn study(summary: &[u8], trials: &[u8]) {
    let folder = Folder::new().with("summary.json", summary).with("trials.csv", trials);
    if let Some(study) = accepted(cdpr_study::load_study(folder.0.path())) {
        report::page(&study);
    }
}
