//! Example scenes and files that the library contains, so that they are at hand wherever it is installed.

use std::fs;
use std::path::{Path, PathBuf};

use cdpr_core::Error;
use cdpr_core::model::{RobotSource, RobotSpec, Scene, SceneSpec};

use super::output::{check_folder, check_target, write_atomically};
use super::scene_file::scene_from_text;
use super::text::{self, Notation};

/// Names and texts of files.
type Files = &'static [(&'static str, &'static str)];

macro_rules! files {
    ($folder:literal, $($name:literal),*) => {
        &[$(($name, include_str!(concat!("../assets/", $folder, "/", $name, ".toml")))),*]
    };
}

#[rustfmt::skip]
const SCENES: Files = files!("scenes", "acrobot", "caroca", "closed", "cogiro", "concave", "empty", "empty_rank6", "forest", "hard1",
    "hard1_rank6", "hard3", "hard3_rank6", "ipanema2", "mpi_simulator", "plank", "turn");

const ROBOTS: Files =
    files!("robots", "acrobot", "caroca", "cogiro", "ipanema2", "mpi_simulator", "paper", "paper_rank6");

macro_rules! foreign_files {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_bytes!(concat!("../assets/", $name)).as_slice())),*]
    };
}

/// Files of other programs, by their names in the folder of assets.
const FOREIGN: &[(&str, &[u8])] = foreign_files![
    "caspr/ACROBOT/ACROBOT_bodies.xml",
    "caspr/ACROBOT/ACROBOT_cables.xml",
    "caspr/CAROCA/CAROCA_bodies.xml",
    "caspr/CAROCA/CAROCA_cables.xml",
    "caspr/CoGiRo/CoGiRo_bodies.xml",
    "caspr/CoGiRo/CoGiRo_cables.xml",
    "caspr/IPAnema_2/IPAnema_2_bodies.xml",
    "caspr/IPAnema_2/IPAnema_2_cables.xml",
    "caspr/LICENSE-CASPR",
    "caspr/The_Cable_Robot_Simulator/The_Cable_Robot_Simulator_bodies.xml",
    "caspr/The_Cable_Robot_Simulator/The_Cable_Robot_Simulator_cables.xml",
    "gazebo/caroca.yaml",
    "meshes/machine.stl",
    "meshes/platform.stl",
];

/// Names of the example scenes, in alphabetical order.
///
/// # Example
/// ```
/// assert!(cdpr_files::example_names().any(|name| name == "hard1"));
/// ```
pub fn example_names() -> impl Iterator<Item = &'static str> {
    SCENES.iter().map(|(name, _)| *name)
}

/// An example scene as one file that needs no other: its robot stands in it.
///
/// # Errors
/// A name that is not one of [`example_names`].
///
/// # Example
/// ```
/// use cdpr_files::{example_text, scene_from_text, text::Notation};
/// let text = example_text("cogiro", Notation::Toml)?;
/// let scene = scene_from_text(&text, Notation::Toml, None)?;
/// assert!(scene.robot().name().starts_with("CoGiRo") && scene.robot().cables().len() == 8);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn example_text(name: &str, notation: Notation) -> Result<String, Error> {
    let known = SCENES.iter().find(|(known, _)| *known == name);
    let (_, source) = known.ok_or_else(|| {
        let names = example_names().collect::<Vec<_>>().join(", ");
        Error::invalid("example", format!("found \"{name}\", expected one of {names}"))
    })?;
    let mut spec: SceneSpec = text::parse(source, Notation::Toml)?;
    let whole = matches!(spec.robot, RobotSource::Inline(_));
    if let RobotSource::File(path) = &spec.robot {
        let found = ROBOTS.iter().find(|(robot, _)| path.ends_with(&format!("/{robot}.toml")));
        let (_, robot) = found.ok_or_else(|| Error::invalid("robot", format!("found {path}, which is no example")))?;
        let robot: RobotSpec = text::parse(robot, Notation::Toml)?;
        spec.robot = RobotSource::Inline(RobotSpec { version: None, ..robot });
    }
    match (notation, whole) {
        (Notation::Json, _) => return Ok(format!("{:#}\n", serde_json::json!(spec))),
        (Notation::Toml, true) => return Ok(source.to_string()),
        (Notation::Toml, false) => (),
    }
    let comment: String = source.split_inclusive('\n').take_while(|line| line.starts_with('#')).collect();
    let table = toml::to_string(&spec).map_err(|e| Error::invalid("example", e.to_string()))?;
    Ok(comment + &table)
}

/// An example scene.
///
/// # Errors
/// A name that is not one of [`example_names`].
///
/// # Example
/// ```
/// use cdpr_core::{PlanOptions, plan};
/// let scene = cdpr_files::example("hard1")?;
/// assert!((plan(&scene, &PlanOptions::default(), &())?.result.cost - 2.435).abs() < 0.003);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn example(name: &str) -> Result<Scene, Error> {
    scene_from_text(&example_text(name, Notation::Toml)?, Notation::Toml, None)
}

/// Writes example files into a folder, which is made if it is missing: robots of CASPR (`caspr/CoGiRo`, ...) and of cdpr
/// for Gazebo (`gazebo/caroca.yaml`), meshes (`meshes/machine.stl`, ...), and the robots of the example scenes
/// (`robots/cogiro.toml`, ...). Files that are there already with the same contents stay as they are.
///
/// Returns the paths of all example files.
///
/// # Errors
/// The folder cannot be written, or contains a file of the same name with other contents and `overwrite` is not set.
/// Then nothing is written.
///
/// # Example
/// ```
/// # let folder = tempfile::tempdir().unwrap();
/// cdpr_files::save_example_files(folder.path(), false)?;
/// assert!(folder.path().join("meshes/machine.stl").exists());
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn save_example_files(folder: &Path, overwrite: bool) -> Result<Vec<PathBuf>, Error> {
    let mut missing = Vec::new();
    for (name, contents) in example_files() {
        let path = folder.join(name);
        match fs::read(&path) {
            Ok(found) if found == contents => continue,
            Ok(_) if !overwrite => {
                let message =
                    "differs from the example; choose another folder, or overwrite it (--force, overwrite=True)";
                return Err(Error::file(&path, message));
            }
            _ if path.exists() => check_target(&path)?,
            _ => check_folder(path.parent().expect("a file in a folder"))?,
        }
        missing.push((path, contents));
    }
    for (path, contents) in &missing {
        let parent = path.parent().expect("a file in a folder");
        fs::create_dir_all(parent).map_err(|e| Error::system(parent, "cannot be created", e))?;
        write_atomically(path, contents)?;
    }
    Ok(example_files().map(|(name, _)| folder.join(name)).collect())
}

/// Names and contents of the example files, in alphabetical order.
fn example_files() -> impl Iterator<Item = (String, &'static [u8])> {
    let foreign = FOREIGN.iter().map(|(name, contents)| (name.to_string(), *contents));
    foreign.chain(ROBOTS.iter().map(|(name, robot)| (format!("robots/{name}.toml"), robot.as_bytes())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &str) -> Vec<String> {
        let folder = format!("{}/assets/{folder}", env!("CARGO_MANIFEST_DIR"));
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let scenes = files.filter(|file| file.extension().is_some_and(|extension| extension == "toml"));
        let mut names: Vec<String> = scenes.map(|file| file.file_stem().unwrap().to_str().unwrap().into()).collect();
        names.sort();
        names
    }

    fn files_below(folder: &str) -> Vec<String> {
        let entries = std::fs::read_dir(format!("{}/assets/{folder}", env!("CARGO_MANIFEST_DIR"))).unwrap();
        let names = entries.map(|entry| entry.unwrap()).map(|entry| {
            let name = format!("{folder}/{}", entry.file_name().to_str().unwrap());
            if entry.path().is_dir() { files_below(&name) } else { vec![name] }
        });
        names.flatten().collect()
    }

    #[test]
    fn every_file_is_included() {
        for (files, folder) in [(SCENES, "scenes"), (ROBOTS, "robots")] {
            assert_eq!(files.iter().map(|(name, _)| *name).collect::<Vec<_>>(), names_in(folder));
        }
        let mut expected: Vec<String> = ["caspr", "gazebo", "meshes"].into_iter().flat_map(files_below).collect();
        // Parts of a mesh are kept beside it once it has been read.
        expected.retain(|name| ![".py", ".parts.json"].iter().any(|ending| name.ends_with(ending)));
        expected.sort();
        assert_eq!(FOREIGN.iter().map(|(name, _)| *name).collect::<Vec<_>>(), expected);
    }

    #[test]
    fn an_example_is_its_file_in_every_notation() {
        for name in example_names() {
            let file = format!("{}/assets/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
            let expected = crate::load_scene(file).unwrap();
            for notation in [Notation::Toml, Notation::Json] {
                let text = example_text(name, notation).unwrap();
                let found = scene_from_text(&text, notation, None).unwrap();
                assert_eq!(found.spec(), expected.spec(), "{name}");
            }
        }
        let refused = example("hard2").unwrap_err().to_string();
        assert!(refused.starts_with("example: found \"hard2\", expected one of acrobot, caroca,"), "{refused}");
    }
    #[test]
    fn example_files_are_written_once() {
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join("a/b");
        let written = save_example_files(&inside, false).unwrap();
        assert!(
            written.len() == FOREIGN.len() + ROBOTS.len()
                && written.is_sorted()
                && written.iter().all(|path| path.is_file())
        );
        let changed = inside.join("gazebo/caroca.yaml");
        std::fs::remove_file(&written[0]).unwrap();
        std::fs::write(&changed, "mine").unwrap();
        let refused = save_example_files(&inside, false).unwrap_err().to_string();
        assert!(refused.contains("caroca.yaml") && refused.contains("differs from the example"), "{refused}");
        assert!(!written[0].exists() && std::fs::read(&changed).unwrap() == b"mine");
        save_example_files(&inside, true).unwrap();
        assert!(written[0].exists() && std::fs::read(&changed).unwrap().starts_with(b"#"));
    }

    #[test]
    fn a_file_in_the_way_of_example_files_is_named_before_anything_is_written() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("meshes"), "").unwrap();
        let refused = save_example_files(folder.path(), true).unwrap_err().to_string();
        assert!(refused.contains("meshes"), "{refused}");
        assert!(!folder.path().join("caspr").exists());
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(folder.path().join("meshes/machine.stl")).unwrap();
        let refused = save_example_files(folder.path(), true).unwrap_err().to_string();
        assert!(refused.contains("machine.stl"), "{refused}");
        assert!(!folder.path().join("caspr").exists());
    }
}
