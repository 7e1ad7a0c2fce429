//! Reading of triangle meshes: STL, binary or text, and OBJ. Whatever a file contains is used, or an error or a note
//! names it.

mod lines;
mod obj;
mod stl;
mod triangulation;

use std::path::Path;

use super::text::{extension, other_extension, read_bytes_at_most};
use cdpr_core::error::Error;
use cdpr_core::geometry::{Point, TriangleMesh};
use cdpr_core::limits::{MOST_MESH_BYTES, MOST_TRIANGLES};
use cdpr_core::model::MeshSpec;

/// A mesh as its file gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile {
    /// The triangles, in the unit of the file.
    pub mesh: TriangleMesh,
    /// Notes on what else the file contains, and on what is unusual about it.
    pub notes: Vec<String>,
}

/// Loads a mesh, in the unit of its file. Polygons with more than three corners are triangulated. [`load_mesh_file`] gives
/// the notes about the file, too.
///
/// # Errors
/// The errors of [`load_mesh_file`].
///
/// # Example
/// ```
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("plate.obj");
/// std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
/// let mesh = cdpr_files::load_mesh(&path)?;
/// assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (4, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn load_mesh(path: impl AsRef<Path>) -> Result<TriangleMesh, Error> {
    let path = path.as_ref();
    load_mesh_file(path).map(|file| file.mesh)
}

/// Loads a mesh and the notes about its file.
///
/// # Errors
/// An unknown extension, a file in a different format, or that ends early, statements that are unknown or of curved
/// surfaces, no triangles or too many, coordinates that are not finite; with the line where there is one. Holes and similar
/// defects are not errors; see [`cdpr_core::geometry::pieces`].
pub fn load_mesh_file(path: impl AsRef<Path>) -> Result<MeshFile, Error> {
    let path = path.as_ref();
    mesh_from(path, &bytes_of(path)?)
}

/// The bytes of a mesh file.
pub(super) fn bytes_of(path: &Path) -> Result<Vec<u8>, Error> {
    format_of(path)?;
    read_bytes_at_most(path, MOST_MESH_BYTES)
}

/// The mesh in the bytes of a file of this name.
pub(super) fn mesh_from(path: &Path, bytes: &[u8]) -> Result<MeshFile, Error> {
    let read = || {
        let MeshFile { mesh, notes } = format_of(path)?(bytes)?;
        let mesh = checked(mesh).map_err(|e| e.with_hints(&notes))?;
        Ok(MeshFile { mesh, notes })
    };
    read().map_err(|e: Error| e.in_file(path))
}

type Reader = fn(&[u8]) -> Result<MeshFile, Error>;

fn format_of(path: &Path) -> Result<Reader, Error> {
    match extension(path).as_deref() {
        Some("stl") => Ok(stl::read),
        Some("obj") => Ok(obj::read),
        _ => Err(other_extension(path, ".stl or .obj")),
    }
}

/// An inline mesh.
pub(super) fn mesh_of(spec: &MeshSpec) -> Result<TriangleMesh, Error> {
    let vertices = spec.vertices.iter().copied().map(Point::from).collect();
    checked(TriangleMesh { vertices, triangles: spec.triangles.clone() })
}

fn checked(mesh: TriangleMesh) -> Result<TriangleMesh, Error> {
    let TriangleMesh { vertices, triangles } = &mesh;
    let refuse = |problem: String| Err(Error::invalid("", problem));
    if triangles.is_empty() {
        return refuse("found no triangles, expected at least one".to_string());
    }
    if triangles.len() > MOST_TRIANGLES {
        return Err(too_many(triangles.len()));
    }
    if let Some(k) = triangles.iter().position(|t| t.iter().any(|i| *i >= vertices.len())) {
        return refuse(format!(
            "triangle {k} has a corner {:?}, expected indices below {}",
            triangles[k],
            vertices.len()
        ));
    }
    if let Some(k) = triangles.iter().position(|t| t.iter().any(|i| !vertices[*i].iter().all(|x| x.is_finite()))) {
        return refuse(format!("triangle {k} has a coordinate that is not finite, expected finite numbers"));
    }
    // Vertices that no triangle uses do not matter and may be anywhere.
    let mut place = vec![None; vertices.len()];
    let mut used = Vec::new();
    let mut moved = |i: usize| {
        *place[i].get_or_insert_with(|| {
            used.push(vertices[i]);
            used.len() - 1
        })
    };
    let triangles = triangles.iter().map(|t| t.map(&mut moved)).collect();
    Ok(TriangleMesh { triangles, vertices: used })
}

fn too_many(found: impl std::fmt::Display) -> Error {
    Error::invalid("", format!("found {found} triangles, expected at most {MOST_TRIANGLES}; simplify the mesh"))
}
