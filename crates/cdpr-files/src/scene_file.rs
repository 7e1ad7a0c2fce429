//! Scene and robot files.

use std::path::{Path, PathBuf};

use super::loader::Loader;
use super::mesh_bodies::{self, MeshRemarks, Remark};
use super::text::{self, Notation};
use cdpr_core::error::{Error, name_of_file};
use cdpr_core::model::{Robot, RobotSource, RobotSpec, Scene, SceneSpec};
use cdpr_core::watch::Watch;

/// Loads a scene; the path of a robot file is relative to the scene file.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_scene(path: impl AsRef<Path>) -> Result<Scene, Error> {
    let path = path.as_ref();
    Loader::PATIENT.scene(path)
}

/// Reads a scene from text; paths of robot files are relative to `folder`.
///
/// # Errors
/// The errors of [`load_scene`].
pub fn scene_from_text(text: &str, notation: Notation, folder: Option<&Path>) -> Result<Scene, Error> {
    Loader::PATIENT.scene_from_text(text, notation, folder)
}

/// Loads a robot file.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_robot(path: impl AsRef<Path>) -> Result<Robot, Error> {
    let path = path.as_ref();
    Loader::PATIENT.robot(path)
}

/// Reads a robot from text; paths of mesh files are relative to `folder`.
///
/// # Errors
/// The errors of [`load_robot`].
pub fn robot_from_text(text: &str, notation: Notation, folder: Option<&Path>) -> Result<Robot, Error> {
    Loader::PATIENT.robot_from_text(text, notation, folder)
}

impl Loader<'_> {
    /// Loads a scene; see [`load_scene`].
    ///
    /// # Errors
    /// The errors of [`load_scene`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn scene(&self, path: impl AsRef<Path>) -> Result<Scene, Error> {
        let path = path.as_ref();
        let notation = Notation::of(path)?;
        let mut spec = scene_spec(&text::read(path)?, notation).map_err(|e| e.in_file(path))?;
        if spec.name.is_none() {
            spec.name = name_of_file(path);
        }
        in_place(spec, path.parent(), &self.watch).map_err(|e| e.in_file(path))
    }

    /// Reads a scene from text; see [`scene_from_text`].
    ///
    /// # Errors
    /// The errors of [`load_scene`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn scene_from_text(&self, text: &str, notation: Notation, folder: Option<&Path>) -> Result<Scene, Error> {
        in_place(scene_spec(text, notation)?, folder, &self.watch)
    }

    /// Makes a scene from plain data; paths of files are relative to `folder`.
    ///
    /// # Errors
    /// The errors of [`load_scene`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn scene_from_spec(&self, spec: SceneSpec, folder: Option<&Path>) -> Result<Scene, Error> {
        in_place(spec, folder, &self.watch)
    }

    /// Loads a robot file; see [`load_robot`].
    ///
    /// # Errors
    /// The errors of [`load_robot`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn robot(&self, path: impl AsRef<Path>) -> Result<Robot, Error> {
        let path = path.as_ref();
        Robot::try_from(robot_spec(path, &mut MeshRemarks::default(), &self.watch)?).map_err(|e| e.in_file(path))
    }

    /// Reads a robot from text; see [`robot_from_text`].
    ///
    /// # Errors
    /// The errors of [`load_robot`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn robot_from_text(&self, text: &str, notation: Notation, folder: Option<&Path>) -> Result<Robot, Error> {
        let mut spec: RobotSpec = text::parse(text, notation)?;
        mesh_bodies::in_place(&mut spec.platform, "platform", folder, &mut MeshRemarks::default(), &self.watch)?;
        Robot::try_from(spec)
    }
}

/// Parses a scene; a robot in its place is named as such.
fn scene_spec(text: &str, notation: Notation) -> Result<SceneSpec, Error> {
    text::parse(text, notation).map_err(|e| {
        let problem = "found a robot, expected a scene: `cdpr new hall.toml --robot FILE` writes one around it";
        if text::parse::<RobotSpec>(text, notation).is_ok() { Error::invalid("", problem) } else { e }
    })
}

/// A robot file with its meshes replaced by convex parts; remarks about them are added to the notes.
fn robot_spec(path: &Path, remarks: &mut MeshRemarks, watch: &Watch) -> Result<RobotSpec, Error> {
    let notation = Notation::of(path)?;
    let mut spec: RobotSpec = text::parse(&text::read(path)?, notation).map_err(|e| e.in_file(path))?;
    if spec.version.is_none() {
        let problem = "found none, expected version = 1 at the top of a robot file";
        return Err(Error::invalid("version", problem).in_file(path));
    }
    mesh_bodies::in_place(&mut spec.platform, "platform", path.parent(), remarks, watch)
        .map_err(|e| e.in_file(path))?;
    Ok(spec)
}

/// Reads the robot file, if any, and all meshes, and checks the scene.
pub(super) fn in_place(mut spec: SceneSpec, folder: Option<&Path>, watch: &Watch) -> Result<Scene, Error> {
    let mut remarks = MeshRemarks { workspace: Some(spec.workspace.clone()), ..MeshRemarks::default() };
    match &mut spec.robot {
        RobotSource::File(name) => {
            let path = folder.map_or_else(|| PathBuf::from(&*name), |folder| folder.join(&*name));
            let robot = robot_spec(&path, &mut remarks, watch)?;
            Robot::try_from(robot.clone()).map_err(|e| e.with_hints(&words(&remarks.hints)).in_file(&path))?;
            spec.robot = RobotSource::Inline(RobotSpec { version: None, ..robot });
        }
        RobotSource::Inline(robot) if robot.version.is_some() => {
            return Err(Error::invalid(
                "robot.version",
                "found one in a scene; only a separate robot file has a version",
            ));
        }
        RobotSource::Inline(robot) => {
            mesh_bodies::in_place(&mut robot.platform, "robot.platform", folder, &mut remarks, watch)?;
        }
    }
    mesh_bodies::in_place(&mut spec.obstacles, "obstacles", folder, &mut remarks, watch)?;
    for (k, payload) in spec.payloads.iter_mut().enumerate() {
        mesh_bodies::in_place(&mut payload.body, &format!("payloads[{k}].body"), folder, &mut remarks, watch)?;
    }
    let good = remarks.notes.iter().filter(|note| note.good).map(ToString::to_string).collect();
    let [notes, hints] = [&remarks.notes, &remarks.hints].map(|remarks| words(remarks));
    let scene = Scene::new(spec).map_err(|e| e.with_hints(&hints))?;
    Ok(scene.with_notes(notes).with_notes(hints).with_good_notes(good).with_alike(remarks.alike()))
}

fn words(remarks: &[Remark]) -> Vec<String> {
    remarks.iter().map(ToString::to_string).collect()
}
