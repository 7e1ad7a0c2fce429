//! Reading of triangle meshes: STL, binary or text, and OBJ.

use std::io::Cursor;
use std::path::Path;

use super::text::{extension, other_extension, read_bytes_at_most};
use cdpr_core::error::Error;
use cdpr_core::geometry::{Point, TriangleMesh};
use cdpr_core::model::MeshSpec;
use cdpr_core::numerics::{MOST_MESH_BYTES, MOST_TRIANGLES, WORDS_PER_TRIANGLE};

/// Loads a mesh, in the unit of its file. Polygons of more than three corners become triangles.
///
/// # Errors
/// Another extension, a file that is not what its extension says, no triangles or too many, coordinates that are not
/// finite. Holes and the like are no errors; see [`cdpr_core::geometry::pieces`].
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
pub fn load_mesh(path: &Path) -> Result<TriangleMesh, Error> {
    mesh_from(path, &bytes_of(path)?)
}

/// The bytes of a mesh file.
pub(super) fn bytes_of(path: &Path) -> Result<Vec<u8>, Error> {
    format_of(path)?;
    read_bytes_at_most(path, MOST_MESH_BYTES)
}

/// The mesh in the bytes of a file of this name.
pub(super) fn mesh_from(path: &Path, bytes: &[u8]) -> Result<TriangleMesh, Error> {
    let mesh = format_of(path)?(bytes).and_then(checked);
    mesh.map_err(|e| e.in_file(path))
}

type Reader = fn(&[u8]) -> Result<TriangleMesh, Error>;

fn format_of(path: &Path) -> Result<Reader, Error> {
    match extension(path).as_deref() {
        Some("stl") => Ok(stl),
        Some("obj") => Ok(obj),
        _ => Err(other_extension(path, ".stl or .obj")),
    }
}

/// A mesh given in place.
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
    // Corners that no triangle uses do not matter, and may be anywhere.
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

fn too_many(triangles: usize) -> Error {
    Error::invalid("", format!("found {triangles} triangles, expected at most {MOST_TRIANGLES}; thin the mesh out"))
}

/// Bytes of a binary STL file before its triangles, and of each triangle.
const STL_HEADER: usize = 84;
const STL_TRIANGLE: usize = 50;

fn stl(bytes: &[u8]) -> Result<TriangleMesh, Error> {
    let told = bytes.get(80..STL_HEADER).map(|b| u32::from_le_bytes(b.try_into().expect("four bytes")) as usize);
    if let Some(told) = told.filter(|n| *n > MOST_TRIANGLES && !bytes.starts_with(b"solid")) {
        return Err(too_many(told));
    }
    let is_binary = told.is_some_and(|n| n.checked_mul(STL_TRIANGLE) == bytes.len().checked_sub(STL_HEADER));
    let mut bytes = bytes.to_vec();
    let is_text = !is_binary && bytes.starts_with(b"solid");
    if is_binary {
        bytes[..5].fill(b' '); // some headers begin with "solid", which would read as text
    } else if is_text {
        bytes.insert(5, b' '); // "solid" alone in a line is a name left out
    } else if let Some(told) = told {
        let problem = format!("ends after {} of {told} triangles", (bytes.len() - STL_HEADER) / STL_TRIANGLE);
        return Err(Error::invalid("", format!("{problem}, or is no STL file")));
    }
    let found = stl_io::read_stl(&mut Cursor::new(bytes))
        .map_err(|e| Error::invalid("", format!("is no sound STL file: {e}")))?;
    let vertices = found.vertices.iter().map(|v| Point::from(<[f32; 3]>::from(*v).map(f64::from))).collect();
    Ok(TriangleMesh { vertices, triangles: found.faces.iter().map(|f| f.vertices).collect() })
}

fn obj(bytes: &[u8]) -> Result<TriangleMesh, Error> {
    let words = bytes.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).count();
    if words > WORDS_PER_TRIANGLE * MOST_TRIANGLES {
        let problem = format!("found {words} words, expected at most {}", WORDS_PER_TRIANGLE * MOST_TRIANGLES);
        return Err(Error::invalid("", format!("{problem} ({MOST_TRIANGLES} triangles); thin the mesh out")));
    }
    let options = tobj::LoadOptions { ignore_points: true, ignore_lines: true, ..tobj::LoadOptions::default() };
    let no_materials = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(bytes), &options, no_materials)
        .map_err(|e| Error::invalid("", format!("is no sound OBJ file: {e}")))?;
    let mut whole = TriangleMesh::default();
    for tobj::Model { mesh, .. } in models {
        let vertices: Vec<Point> = mesh.positions.chunks_exact(3).map(Point::from_slice).collect();
        let mut corners = mesh.indices.iter().map(|i| *i as usize);
        let triangles_only = vec![3; if mesh.face_arities.is_empty() { mesh.indices.len() / 3 } else { 0 }];
        let arities = mesh.face_arities.iter().chain(&triangles_only);
        let polygons = arities.map(|n| corners.by_ref().take(*n as usize).collect::<Vec<usize>>());
        let triangles = polygons.flat_map(|polygon| triangles_of(&polygon, &vertices)).collect();
        whole.append(&TriangleMesh { vertices, triangles });
    }
    Ok(whole)
}

/// A polygon, convex or not, as triangles; of one that cuts itself some are missing.
fn triangles_of(polygon: &[usize], vertices: &[Point]) -> Vec<[usize; 3]> {
    if let [a, b, c] = polygon {
        return vec![[*a, *b, *c]];
    }
    let Some(places) = polygon.iter().map(|i| vertices.get(*i).map(|p| [p.x, p.y, p.z])).collect::<Option<Vec<_>>>()
    else {
        return vec![[usize::MAX; 3]]; // told with the other corners that do not exist
    };
    let (mut flat, mut found) = (Vec::new(), Vec::<usize>::new());
    if earcut::utils3d::project3d_to_2d(&places, places.len(), &mut flat) {
        earcut::Earcut::new().earcut(flat, &[], &mut found);
    }
    found.chunks_exact(3).map(|t| [polygon[t[0]], polygon[t[1]], polygon[t[2]]]).collect()
}
