//! Files of proved workspaces: .json with everything, .npz with the boxes for NumPy, .vti for ParaView, .stl for meshes.
//!
//! In an .npz file: `lower` and `upper`, float64 (n, 3), m; `verdict`, `part` and `cause`, int64 (n,); `causes`, unicode (k,), the
//! conditions that forbid boxes; `report`, JSON text, unicode (). In a .vti file (VTK ImageData, XML) the verdicts are cell data. The
//! .stl file has the surface of all that is proved inside, in single precision.

use std::io;
use std::path::Path;

use super::npz::Npz;
use super::region_file::stl;
use super::text::{extension, other_extension};
use super::voxels::Voxels;
use cdpr_core::error::Error;
use cdpr_core::regions::pair_name;
use cdpr_core::workspace::{Boxes, Cause, Workspace};

/// The formats of proved workspaces, selected by extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WorkspaceFormat {
    /// `.json`: all that is known, and the boxes.
    Json,
    /// `.npz`: the boxes as arrays for NumPy.
    Npz,
    /// `.vti`: voxels for ParaView.
    Vti,
    /// `.stl`, binary: the surface of what is proved inside.
    Stl,
}

impl WorkspaceFormat {
    /// The format for the file's extension; call this before doing any work.
    ///
    /// # Errors
    /// Another extension.
    pub fn of(path: &Path) -> Result<Self, Error> {
        match extension(path).as_deref() {
            Some("json") => Ok(WorkspaceFormat::Json),
            Some("npz") => Ok(WorkspaceFormat::Npz),
            Some("vti") => Ok(WorkspaceFormat::Vti),
            Some("stl") => Ok(WorkspaceFormat::Stl),
            _ => Err(other_extension(path, ".json, .npz, .vti or .stl")),
        }
    }
}

/// A proved workspace as the bytes of a file.
///
/// # Errors
/// A flat workspace in a format of surfaces.
///
/// # Example
/// ```
/// use cdpr_core::workspace::{WorkspaceOptions, workspace};
/// use cdpr_core::{CompiledScene, Watch, testing};
/// use cdpr_files::{WorkspaceFormat, workspace_bytes, workspace_from_json};
/// let compiled = CompiledScene::new(&testing::hard1(), Default::default(), Default::default(), &Watch::NONE)?;
/// let found = workspace(&[&compiled], &WorkspaceOptions { resolution: Some(0.5), ..WorkspaceOptions::default() }, &Default::default())?;
/// assert_eq!(workspace_from_json(&workspace_bytes(WorkspaceFormat::Json, &found)?)?, found);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn workspace_bytes(format: WorkspaceFormat, found: &Workspace) -> Result<Vec<u8>, Error> {
    Ok(match format {
        WorkspaceFormat::Json => json(found),
        WorkspaceFormat::Npz => npz(found).expect("memory takes what is written"),
        WorkspaceFormat::Vti => vti(found),
        WorkspaceFormat::Stl if found.dimension < 3 => {
            let problem = "found a flat workspace, which has no surface; expected another format";
            return Err(Error::invalid("output", problem));
        }
        WorkspaceFormat::Stl => stl(&Voxels::of(found).surface()),
    })
}

/// A proved workspace from the bytes of a .json file.
///
/// # Errors
/// Bytes that are not a workspace.
pub fn workspace_from_json(bytes: &[u8]) -> Result<Workspace, Error> {
    Workspace::from_json(bytes)
}

fn json(found: &Workspace) -> Vec<u8> {
    let mut text = serde_json::to_vec(found).expect("plain data");
    text.push(b'\n');
    text
}

fn npz(found: &Workspace) -> io::Result<Vec<u8>> {
    let Boxes { lower, upper, verdict, part, cause } = &found.boxes;
    let count = verdict.len() as u64;
    let mut npz = Npz::new();
    npz.numbers("lower", &[count, 3], lower.as_flattened())?;
    npz.numbers("upper", &[count, 3], upper.as_flattened())?;
    for (name, numbers) in [("verdict", verdict), ("part", part), ("cause", cause)] {
        npz.integers(name, &[count], numbers)?;
    }
    let named = |cause: &Cause| match cause.culprits.is_empty() {
        true => cause.condition.clone(),
        false => format!("{}: {}", cause.condition, pair_name(&cause.culprits)),
    };
    let causes: Vec<String> = found.causes.iter().map(named).collect();
    npz.texts("causes", &[causes.len() as u64], &causes.iter().map(String::as_str).collect::<Vec<_>>())?;
    npz.texts("report", &[], &[&found.summary().to_string()])?;
    npz.finish()
}

/// ImageData with raw appended data; see [`super::wrench_map_file`] for why it is written by hand.
fn vti(found: &Workspace) -> Vec<u8> {
    let Voxels { origin: [x, y, z], spacing: [dx, dy, dz], counts: [nx, ny, nz], verdict } = Voxels::of(found);
    let extent = format!("0 {nx} 0 {ny} 0 {nz}");
    let mut file = format!(
        "<?xml version=\"1.0\"?>\n<!-- proved workspace, scene {} -->\n\
         <VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  \
         <ImageData WholeExtent=\"{extent}\" Origin=\"{x} {y} {z}\" Spacing=\"{dx} {dy} {dz}\">\n    \
         <Piece Extent=\"{extent}\">\n      <CellData Scalars=\"verdict\">\n        \
         <DataArray type=\"Int8\" Name=\"verdict\" format=\"appended\" offset=\"0\"/>\n      </CellData>\n    \
         </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n_",
        found.scene.fingerprint
    )
    .into_bytes();
    file.extend((verdict.len() as u64).to_le_bytes());
    file.extend(verdict.iter().map(|verdict| *verdict as u8));
    file.extend(b"\n  </AppendedData>\n</VTKFile>\n");
    file
}
