//! The files and folders that a command writes.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use cdpr_core::Error;
use cdpr_files::text::{Notation, extension, other_extension};
use cdpr_files::{MapFormat, MessageFields, RegionFormat, WorkspaceFormat};

use crate::output::{is_dash, is_standard_output, is_stream};

/// A file or folder that a command will write.
pub struct Target<'a> {
    path: Cow<'a, Path>,
    contents: Contents,
}

/// What is written, which decides how it may be named.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contents {
    /// JSON or CSV.
    Path,
    /// JSON, CSV or, the only one that has room for these fields, a ROS 2 message.
    Trajectory(MessageFields),
    /// HTML.
    Page,
    /// A scene or a robot: TOML or JSON.
    Spec,
    /// Meshes, or a page.
    Regions,
    /// Margins on a grid.
    Map,
    /// Boxes of positions.
    Workspace,
    /// Lengths between stations: CSV.
    Matrix,
    /// A model for MuJoCo, with a motion beside it or without.
    Model { beside: bool },
    /// NumPy arrays beside a model, in a file named after it.
    Arrays,
    /// CSV.
    Tensions,
    /// JSON under any name.
    Proof,
    /// A folder.
    Folder,
}

impl<'a> Target<'a> {
    /// A file or folder with this name.
    pub fn new(path: impl Into<Cow<'a, Path>>, contents: Contents) -> Self {
        Target { path: path.into(), contents }
    }

    /// Where it is, without links; `None` for standard output, pipes and devices.
    fn place(&self) -> Option<PathBuf> {
        let path = &*self.path;
        if is_standard_output(path) || cdpr_files::is_stream(path) {
            return None;
        }
        let folder = || path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        path.canonicalize().ok().or_else(|| Some(folder().canonicalize().ok()?.join(path.file_name()?)))
    }

    /// Checks that it can be written.
    fn check(&self) -> Result<(), Error> {
        let path = &*self.path;
        match self.contents {
            Contents::Folder if is_dash(path) => {
                Err(Error::file(path, "is standard output, expected the name of a folder"))
            }
            Contents::Folder => cdpr_files::check_folder(path),
            _ if is_standard_output(path) => Ok(()),
            _ => cdpr_files::check_target(path),
        }
    }

    /// Checks that its name has an extension for what it contains. Standard output, pipes and devices have none, where there is a
    /// format for them.
    fn check_name(&self) -> Result<(), Error> {
        let path = &*self.path;
        match self.contents {
            Contents::Regions => RegionFormat::of(path).map(drop),
            Contents::Map => MapFormat::of(path).map(drop),
            Contents::Page if matches!(extension(path).as_deref(), Some("html" | "htm")) => Ok(()),
            Contents::Trajectory(fields) if is_stream(path) => check_message(None, fields),
            Contents::Model { beside: true } if is_stream(path) => Err(Error::invalid(
                "--output",
                "found no file, expected one named .xml: the motion is written beside it",
            )),
            _ if is_stream(path) => Ok(()),
            Contents::Path => cdpr_files::check_path_name(path),
            Contents::Model { .. } => cdpr_files::check_mjcf_name(path),
            Contents::Trajectory(fields) => cdpr_files::check_trajectory_name(path, fields),
            Contents::Page => Err(other_extension(path, ".html")),
            Contents::Spec => Notation::of(path).map(drop),
            Contents::Workspace => WorkspaceFormat::of(path).map(drop),
            Contents::Matrix => cdpr_files::check_matrix_name(path),
            Contents::Tensions => cdpr_files::check_tensions_name(path),
            Contents::Proof | Contents::Folder | Contents::Arrays => Ok(()),
        }
    }
}

/// Checks that there is a file that may have room for these fields, so `--joints` and `--effort` are not passed over.
pub fn check_message(file: Option<&Path>, fields: MessageFields) -> Result<(), Error> {
    match fields.requested().filter(|_| file.is_none()) {
        Some(field) => Err(Error::invalid(
            format!("--{field}"),
            "found without a ROS 2 message, expected a trajectory file named .yaml",
        )),
        None => Ok(()),
    }
}

/// Checks, before any work is done, that all of these can be written, and replace neither `sources` nor each other.
pub fn check_targets(targets: &[Target], sources: Vec<&Path>) -> Result<(), Error> {
    targets.iter().try_for_each(Target::check)?;
    let places = targets.iter().filter_map(|target| Some((&*target.path, target.place()?)));
    let written: Vec<(&Path, PathBuf)> = places.collect();
    if let Some((path, _)) = (1..written.len()).find_map(|k| {
        let (_, place) = &written[k];
        written[..k].iter().any(|(_, other)| other == place).then_some(&written[k])
    }) {
        return Err(Error::file(path, "is the name of two outputs; choose different names"));
    }
    let old: Vec<&(&Path, PathBuf)> = written.iter().filter(|(_, place)| place.exists()).collect();
    if !old.is_empty() {
        let read = sources.into_iter().filter(|path| !is_standard_output(path)).flat_map(cdpr_files::sources);
        let read: Vec<PathBuf> = read.filter_map(|path| path.canonicalize().ok()).collect();
        if let Some((path, _)) = old.into_iter().find(|(_, place)| read.contains(place)) {
            return Err(Error::file(path, "is an input of this command; choose another name for the output"));
        }
    }
    targets.iter().try_for_each(Target::check_name)
}
