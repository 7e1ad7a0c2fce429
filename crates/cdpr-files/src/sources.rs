//! The files that a scene or a robot consists of.

use std::path::{Path, PathBuf};

use cdpr_core::model::{BodySpec, MeshSource, RobotSource, RobotSpec, SceneSpec};

use super::output::is_stream;
use super::text::{self, Notation};

/// A file and those that it names if it is a scene or a robot: robot and mesh files. Files that cannot be read name none.
///
/// # Example
/// ```
/// let files = cdpr_files::sources("testdata/scenes/no_such_scene.toml");
/// assert_eq!(files, ["testdata/scenes/no_such_scene.toml"].map(std::path::PathBuf::from));
/// ```
pub fn sources(path: impl AsRef<Path>) -> Vec<PathBuf> {
    let path = path.as_ref();
    let mut files = vec![path.to_path_buf()];
    if path.is_file() && !is_stream(path) {
        files.extend(named_in(path).unwrap_or_default());
    }
    files
}

fn named_in(path: &Path) -> Option<Vec<PathBuf>> {
    let (notation, text) = (Notation::of(path).ok()?, text::read(path).ok()?);
    let beside = |name: &str| path.with_file_name("").join(name);
    let meshes = |bodies: &[BodySpec]| {
        let file = |body: &BodySpec| match &body.mesh {
            Some(MeshSource::File(name)) => Some(beside(name)),
            _ => None,
        };
        bodies.iter().filter_map(file).collect::<Vec<_>>()
    };
    let Ok(scene) = text::parse::<SceneSpec>(&text, notation) else {
        return Some(meshes(&text::parse::<RobotSpec>(&text, notation).ok()?.platform));
    };
    let mut files = meshes(&scene.obstacles);
    files.extend(scene.payloads.iter().flat_map(|payload| meshes(&payload.body)));
    match &scene.robot {
        RobotSource::File(name) => files.extend(sources(beside(name))),
        RobotSource::Inline(robot) => files.extend(meshes(&robot.platform)),
    }
    Some(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_consists_of_its_robot_and_all_meshes() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
        let body = "[[platform]]\nmesh = \"platform.stl\"\n";
        write("robot.toml", &format!("version = 1\n{body}[[cables]]\noutlet = [0, 0, 1]\nattachment = [0, 0, 0]\n"));
        let workspace = "[workspace]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n";
        write(
            "scene.toml",
            &format!("version = 1\nrobot = \"robot.toml\"\n{workspace}[[obstacles]]\nmesh = \"hall.obj\"\n"),
        );
        let names = |path: &str| {
            let files = sources(folder.path().join(path));
            files.iter().map(|file| file.file_name().unwrap().to_str().unwrap().to_string()).collect::<Vec<_>>()
        };
        assert_eq!(names("scene.toml"), ["scene.toml", "hall.obj", "robot.toml", "platform.stl"]);
        assert_eq!(names("robot.toml"), ["robot.toml", "platform.stl"]);
        assert_eq!(names("hall.obj"), ["hall.obj"]);
    }
}
