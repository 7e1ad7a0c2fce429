//! Import of robots from other programs, by file type, and writing of robot files.

use std::path::Path;

pub use super::import_source::ImportOptions;
use super::import_source::Source;
use super::loader::Loader;
use super::mesh_bodies::{self, MeshRemarks};
use super::output::write_atomically;
use super::text::{Notation, extension, other_extension, relative};
use super::{caspr, gazebo};
use cdpr_core::error::Error;
use cdpr_core::geometry::{Point, Polytope, PolytopeError};
use cdpr_core::model::{BodySpec, MeshSource, Robot, RobotSpec, Unit};
use cdpr_core::words::small_length;

/// A robot imported from another program.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The robot as written to a file; refers to the mesh if one was given for the platform.
    pub robot: RobotSpec,
    /// The checked robot, with the mesh replaced by convex parts.
    pub whole: RobotSpec,
    /// Description of the source.
    pub origin: String,
    /// Notes on what was not carried over or was changed.
    pub notes: Vec<String>,
}

/// Imports a robot: CASPR (one of the two XML files of a model, or their folder), or the YAML of the Gazebo simulator
/// cdpr.
///
/// The platform frame is that of the source. If the source does not define the platform's shape, the hull of the
/// attachments is used.
///
/// # Errors
/// Unsupported or invalid contents; the error names the file, the element with its line, what was found and what was
/// expected.
pub fn import_robot(path: impl AsRef<Path>, options: &ImportOptions) -> Result<Imported, Error> {
    let path = path.as_ref();
    Loader::PATIENT.import(path, options)
}

impl Loader<'_> {
    /// Imports a robot; see [`import_robot`].
    ///
    /// # Errors
    /// The errors of [`import_robot`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn import(&self, path: impl AsRef<Path>, options: &ImportOptions) -> Result<Imported, Error> {
        let path = path.as_ref();
        let Source { robot, origin, notes } = match extension(path).as_deref() {
            Some("yaml" | "yml") => {
                options.refuse_those_of_caspr()?;
                gazebo::import(path)?
            }
            Some("xml") => caspr::import(path, options)?,
            _ if path.is_dir() => caspr::import(path, options)?,
            _ => return Err(other_extension(path, ".xml (CASPR), a folder of it, or .yaml")),
        };
        let mut imported = Imported { whole: robot.clone(), robot, origin, notes };
        if let Some((mesh, unit)) = &options.platform {
            imported.robot.platform = vec![mesh_body(mesh, *unit)?];
        }
        hull_holds_none(&imported.robot).map_err(|e| e.in_file(path))?;
        imported.whole = imported.robot.clone();
        let mut remarks = MeshRemarks::default();
        mesh_bodies::in_place(&mut imported.whole.platform, "platform", None, &mut remarks, &self.watch)?;
        imported.notes.extend(remarks.notes.iter().map(ToString::to_string));
        Robot::try_from(imported.whole.clone()).map_err(|e| e.in_file(path))?;
        Ok(imported)
    }
}

fn mesh_body(mesh: &Path, unit: Unit) -> Result<BodySpec, Error> {
    let whole = std::path::absolute(mesh).map_err(|e| Error::system(mesh, "cannot be found", e))?;
    let source = MeshSource::File(whole.to_string_lossy().into_owned());
    Ok(BodySpec { mesh: Some(source), units: Some(unit), ..BodySpec::default() })
}

/// Rejects an attachment inside the hull of the others: the hull is then not the platform's shape.
fn hull_holds_none(robot: &RobotSpec) -> Result<(), Error> {
    let [BodySpec { vertices: Some(corners), .. }] = &robot.platform[..] else { return Ok(()) };
    let points: Vec<Point> = corners.iter().copied().map(Point::from).collect();
    match Polytope::from_vertices(&points) {
        Err(PolytopeError::InsideHull { index, depth }) => {
            let found = format!("attachment {index} lies {} inside the hull of the others", small_length(depth));
            let expected = "expected a platform that is the hull of its attachments, or a mesh of the platform";
            Err(Error::invalid("platform", format!("{found}, {expected}")))
        }
        _ => Ok(()),
    }
}

/// Writes an imported robot as a robot file in the format given by the extension; in TOML, comments at the top give its
/// source and notes. The path of a mesh is relative to the file.
///
/// # Errors
/// An unknown extension, or a file that cannot be written.
pub fn save_imported(path: impl AsRef<Path>, imported: &Imported) -> Result<(), Error> {
    let path = path.as_ref();
    let notation = Notation::of(path)?;
    let mut imported = imported.clone();
    for body in &mut imported.robot.platform {
        if let Some(MeshSource::File(mesh)) = &mut body.mesh {
            *mesh = relative(Path::new(mesh), path)?;
        }
    }
    let text = match notation {
        Notation::Toml => robot_toml(&imported),
        Notation::Json => format!("{:#}\n", serde_json::json!(imported.robot)),
    };
    write_atomically(path, text.as_bytes())
}

/// The robot file in TOML: one line per point, comments at the top.
pub fn robot_toml(imported: &Imported) -> String {
    let one_line = |text: &str| text.replace(char::is_control, " ");
    let mut text = format!("# {}.\n", one_line(&imported.origin));
    if !imported.notes.is_empty() {
        text.push_str("# Not carried over:\n");
        imported.notes.iter().for_each(|note| text.push_str(&format!("# - {}\n", one_line(note))));
    }
    for line in toml::to_string(&imported.robot).expect("robots are finite").lines() {
        let list = line.starts_with("vertices = [[");
        text.push_str(&if list {
            line.replace("[[", "[\n    [").replace("], [", "],\n    [").replace("]]", "],\n]")
        } else {
            line.to_string()
        });
        text.push('\n');
    }
    text
}
