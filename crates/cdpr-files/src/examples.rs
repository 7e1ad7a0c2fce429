//! Example scenes that the library contains, so that they are at hand wherever it is installed.

use cdpr_core::Error;
use cdpr_core::model::{RobotSource, RobotSpec, Scene, SceneSpec};

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

    #[test]
    fn every_file_is_included() {
        for (files, folder) in [(SCENES, "scenes"), (ROBOTS, "robots")] {
            assert_eq!(files.iter().map(|(name, _)| *name).collect::<Vec<_>>(), names_in(folder));
        }
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
}
