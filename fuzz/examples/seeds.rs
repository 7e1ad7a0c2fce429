//! Writes `fuzz/seeds`, a few valid files for each reader: `cargo run -p cdpr-fuzz --example seeds`.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use cdpr_core::batch::BatchOptions;
use cdpr_core::geometry::{Aabb, Point};
use cdpr_core::kinematics::cable_lengths;
use cdpr_core::plan::{Appraisal, PlanOptions, plan};
use cdpr_core::task::plan_task;
use cdpr_core::testing;
use cdpr_core::wrench::{MapOptions, Required, Statics, WrenchMap};
use cdpr_files::PathFile;
use cdpr_fuzz::inputs;
use cdpr_study::BatchFolder;
use cdpr_study::RunOptions;

/// A column with a foot, as one closed surface.
const ANGLE: &str = "\
v 0.85 0.8 0\nv 1.6 0.8 0\nv 1.6 0.8 0.1\nv 1.15 0.8 0.1\nv 1.15 0.8 1.5\nv 0.85 0.8 1.5
v 0.85 1.2 0\nv 1.6 1.2 0\nv 1.6 1.2 0.1\nv 1.15 1.2 0.1\nv 1.15 1.2 1.5\nv 0.85 1.2 1.5
f 1 2 3 4\nf 1 4 5 6\nf 7 10 9 8\nf 7 12 11 10
f 1 7 8 2\nf 2 8 9 3\nf 3 9 10 4\nf 4 10 11 5\nf 5 11 12 6\nf 6 12 7 1
";

const EXPERIMENT: &str = r#"version = 1
name = "small"
seed = 3
trials = 3
history = true

[[scenarios]]
name = "hard1"
scene = "scene.toml"

[[scenarios]]
name = "drawn"
scene = "scene.toml"
random = { count = 2, count_up_to = 3, width = [0.05, 0.1], turned = true }

[[methods]]
name = "swept"
options = { max_samples = 300 }
sweep = { step = [0.1, 0.2], post = ["backward", "forward"], repeats = [1, 2] }

[[t_tests]]
group = "A"
measure = "cost"
a = ["hard1", "swept, step 0.1, backward, repeats 1"]
b = ["drawn", "swept, step 0.1, forward, repeats 1"]
"#;

fn testdata(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata").join(name)
}

fn put(name: &str, bytes: impl AsRef<[u8]>) -> std::io::Result<()> {
    let path = inputs("seeds").join(name);
    fs::create_dir_all(path.parent().expect("a folder"))?;
    fs::write(path, bytes)
}

fn main() -> Result<(), Box<dyn Error>> {
    robots()?;
    scenes()?;
    meshes()?;
    paths()?;
    maps()?;
    runs()?;
    Ok(())
}

fn robots() -> Result<(), Box<dyn Error>> {
    for name in ["paper", "cogiro"] {
        put(&format!("robot_toml/{name}.toml"), fs::read(testdata(&format!("robots/{name}.toml")))?)?;
    }
    for (model, seed) in [("CoGiRo", "cogiro"), ("ACROBOT", "acrobot")] {
        for kind in ["cables", "bodies"] {
            let path = testdata(&format!("caspr/{model}/{model}_{kind}.xml"));
            put(&format!("caspr_{kind}/{seed}.xml"), fs::read(path)?)?;
        }
    }
    put("caspr_cables/pulleys.xml", pulleys()?)?;
    Ok(put("gazebo_yaml/caroca.yaml", fs::read(testdata("gazebo/caroca.yaml"))?)?)
}

/// CAROCA's cables that run round pulleys; all of them stretch here.
fn pulleys() -> Result<String, Box<dyn Error>> {
    let text = fs::read_to_string(testdata("caspr/CAROCA/CAROCA_cables.xml"))?;
    let set = text.split("<cable_set id=\"with_rotating_pulleys\">").nth(1).ok_or("no pulleys")?;
    let set = set.split("</cable_set>").next().ok_or("no end")?;
    let set = set.replace("cable_ideal", "cable_linear_spring").replace("<properties>", "<properties><K>7e5</K>");
    Ok(format!("<cables><cable_set id=\"pulleys\">{set}</cable_set></cables>\n"))
}

fn scenes() -> Result<(), Box<dyn Error>> {
    for name in
        ["scenes/hard1", "scenes/concave", "scenes/acrobot", "cases/abutting", "cases/clearance", "cases/shared_ends"]
    {
        let text = fs::read_to_string(testdata(&format!("{name}.toml")))?;
        let seed = name.split('/').next_back().expect("a name");
        let text =
            ["paper", "acrobot"].iter().fold(text, |text, robot| text.replace(&format!("../robots/{robot}"), "robot"));
        put(&format!("scene_toml/{seed}.toml"), text)?;
        let scene = cdpr_files::load_scene(testdata(&format!("{name}.toml")))?;
        put(&format!("scene_json/{seed}.json"), serde_json::to_string(scene.spec())?)?;
    }
    let (tower, name) = (testdata("tasks/tower.toml"), "tower");
    put(&format!("scene_toml/{name}.toml"), fs::read(&tower)?)?;
    let scene = cdpr_files::load_scene(&tower)?;
    put(&format!("scene_json/{name}.json"), serde_json::to_string(scene.written())?)?;
    let task = plan_task(&scene, &PlanOptions::default(), None, &|| false, &|_, _| ())?;
    put(
        &format!("task_json/{name}.json"),
        serde_json::to_string(&cdpr_files::task_file(&scene, &task, Default::default()))?,
    )?;
    Ok(put("experiment_toml/small.toml", EXPERIMENT)?)
}

fn meshes() -> Result<(), Box<dyn Error>> {
    put("mesh_obj/angle.obj", ANGLE)?;
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("angle.obj");
    fs::write(&path, ANGLE)?;
    let mesh = cdpr_files::load_mesh(&path)?;
    let (mut binary, mut text) = (vec![b' '; 80], "solid angle\n".to_string());
    binary.extend((mesh.triangles.len() as u32).to_le_bytes());
    for triangle in &mesh.triangles {
        binary.extend([0; 12]);
        text += "facet normal 0 0 0\nouter loop\n";
        for corner in triangle.map(|i| mesh.vertices[i]) {
            binary.extend(corner.iter().flat_map(|x| (*x as f32).to_le_bytes()));
            text += &format!("vertex {} {} {}\n", corner.x, corner.y, corner.z);
        }
        binary.extend([0; 2]);
        text += "endloop\nendfacet\n";
    }
    put("mesh_stl/binary.stl", binary)?;
    put("mesh_stl/text.stl", text + "endsolid angle\n")?;
    let boxes =
        r#"{"parts":[[[0.85,0.8,0.0],[1.6,0.8,0.0],[1.6,1.2,0.0],[0.85,1.2,0.0],[1.0,1.0,0.1]]],"notes":["a note"]}"#;
    Ok(put("parts_json/pyramid.json", boxes)?)
}

fn paths() -> Result<(), Box<dyn Error>> {
    let (scene, options) = (testing::hard1(), PlanOptions::paper());
    let result = plan(&scene, &options, &|| false)?.result;
    let file = PathFile::planned(&scene, &options, &result, &Appraisal::default());
    for name in ["path_json/hard1.json", "path_csv/hard1.csv"] {
        put(name, "")?;
        cdpr_files::save_path(inputs("seeds").join(name), &file)?;
    }
    let lengths = |x: f64| cable_lengths(scene.robot(), scene.orientation(), &Point::new(x, 1.0, 0.3));
    let row = |x: f64| lengths(x).iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n";
    let header: Vec<String> = scene.robot().cable_names().iter().map(|name| format!("length:{name}")).collect();
    put("lengths_csv/named.csv", header.join(",") + "\n" + &row(0.3) + &row(0.31))?;
    put("lengths_csv/plain.csv", row(0.3))?;
    let motion = testing::moving(&scene, Point::new(0.3, 1.0, 0.3), Point::new(0.9, 1.0, 0.9), 4);
    put("trajectory_json/hard1.json", serde_json::json!(motion).to_string())?;
    Ok(())
}

fn maps() -> Result<(), Box<dyn Error>> {
    let (statics, required) = (Statics::of(&testing::empty())?, Required::default());
    let within = Aabb { min: Point::new(0.5, 0.5, 0.5), max: Point::new(1.5, 1.0, 1.5) };
    let batch = BatchOptions::default();
    let map = WrenchMap::new(&statics, &required, &within, &MapOptions { step: 0.5, projected: true }, &batch)?;
    put("wrench_map_npz/map.npz", "")?;
    Ok(cdpr_files::save_wrench_map(inputs("seeds/wrench_map_npz/map.npz"), &map)?)
}

/// A run to report on, and a smaller one to be merged.
fn runs() -> Result<(), Box<dyn Error>> {
    let text = EXPERIMENT.replace("\"scene.toml\"", &format!("{:?}", testdata("scenes/hard1.toml")));
    let experiment = cdpr_study::experiment_from_text(&text, cdpr_files::text::Notation::Toml, None)?;
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("run");
    let options = RunOptions { threads: Some(1), interrupted: &|| false, progress: &mut |_| {} };
    BatchFolder::open(&path, &experiment, 0..experiment.trials, false)?.run(&experiment, options)?;
    put("summary_json/summary.json", fs::read(path.join("summary.json"))?)?;
    put("trials_csv/trials.csv", fs::read(path.join("trials.csv"))?)?;
    let one = text.split("[[scenarios]]\nname = \"drawn\"").next().expect("a part").to_string();
    let one = one
        + "[[methods]]\nname = \"swept\"\noptions = { max_samples = 300 }\nsweep = { post = [\"backward\", \"forward\"] }\n";
    let experiment = cdpr_study::experiment_from_text(&one, cdpr_files::text::Notation::Toml, None)?;
    let path = folder.path().join("one");
    let options = RunOptions { threads: Some(1), interrupted: &|| false, progress: &mut |_| {} };
    BatchFolder::open(&path, &experiment, 0..experiment.trials, false)?.run(&experiment, options)?;
    put("run_json/run.json", fs::read(path.join("run.json"))?)?;
    Ok(put("rows_csv/rows.csv", fs::read(path.join("rows/0000.csv"))?)?)
}
