//! Files of forbidden regions: meshes (.obj, .ply, .stl), or a page that shows them (.html), which the caller makes.

use std::fmt::Write;
use std::path::Path;

use super::output::write_atomically;
use super::text::{extension, other_extension};
use cdpr_core::choice::Choice;
use cdpr_core::error::Error;
use cdpr_core::geometry::{Point, TriangleMesh};
use cdpr_core::model::Scene;
use cdpr_core::regions::{NamedMesh, Regions, unused};

/// The formats of region files, selected by extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RegionFormat {
    /// `.obj`: one named object per region.
    Obj,
    /// `.ply`, text: one surface; each face has the number of its region, and comments give the names.
    Ply,
    /// `.stl`, binary: one surface without names, coordinates in single precision (about seven digits).
    Stl,
    /// `.html`: a page that shows the regions in the scene.
    Html,
}

impl RegionFormat {
    /// The format for the file's extension; call this before doing any work.
    ///
    /// # Errors
    /// Another extension.
    pub fn of(path: &Path) -> Result<Self, Error> {
        match extension(path).as_deref() {
            Some("obj") => Ok(RegionFormat::Obj),
            Some("ply") => Ok(RegionFormat::Ply),
            Some("stl") => Ok(RegionFormat::Stl),
            Some("html" | "htm") => Ok(RegionFormat::Html),
            _ => Err(other_extension(path, ".obj, .ply, .stl or .html")),
        }
    }
}

/// Writes regions of a scene in the format given by the extension. Coordinates are in metres. `page` gives the text of
/// a page that shows the regions; it is called for `.html` only.
///
/// # Errors
/// Another extension, or a file that cannot be written; nothing half-written is left.
pub fn save_regions(
    path: impl AsRef<Path>,
    scene: &Scene,
    regions: &Regions,
    page: impl FnOnce(&Scene, &Regions) -> String,
) -> Result<(), Error> {
    let path = path.as_ref();
    let bytes = match RegionFormat::of(path)? {
        RegionFormat::Obj => obj(scene, regions).into_bytes(),
        RegionFormat::Ply => ply(scene, regions).into_bytes(),
        RegionFormat::Stl => stl(&merged(regions)),
        RegionFormat::Html => page(scene, regions).into_bytes(),
    };
    write_atomically(path, &bytes)
}

fn title(scene: &Scene, regions: &Regions) -> String {
    one_line(&format!("forbidden regions of {}, space: {}, unit: m", scene.name(), regions.space.name()))
}

/// A name for a comment: names are free text and must not end the line.
fn one_line(name: &str) -> String {
    name.replace(char::is_control, " ")
}

fn obj(scene: &Scene, regions: &Regions) -> String {
    let mut text = format!("# {}\n", title(scene, regions));
    let mut taken: Vec<String> = Vec::new();
    let mut first = 1; // vertices count from 1, through all objects
    for NamedMesh { name, mesh, .. } in &regions.meshes {
        let object = unused(&object_name(name), '_', |name| taken.iter().any(|t| t == name));
        let _ = writeln!(text, "# {}\no {object}", one_line(name));
        for [x, y, z] in coordinates(mesh) {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        for [i, j, k] in mesh.triangles.iter().map(|t| t.map(|i| i + first)) {
            let _ = writeln!(text, "f {i} {j} {k}");
        }
        first += mesh.vertices.len();
        taken.push(object);
    }
    text
}

/// A name that every reader treats as one word: "cable 3 / pillar" becomes "cable_3_pillar".
fn object_name(name: &str) -> String {
    let words = name.split(|c: char| !(c.is_alphanumeric() || c == '-' || c == '.')).filter(|word| !word.is_empty());
    let joined = words.collect::<Vec<_>>().join("_");
    if joined.is_empty() { "region".to_string() } else { joined }
}

fn ply(scene: &Scene, regions: &Regions) -> String {
    let whole = merged(regions);
    let mut text = format!("ply\nformat ascii 1.0\ncomment {}\n", title(scene, regions));
    for (k, region) in regions.meshes.iter().enumerate() {
        let _ = writeln!(text, "comment region {k}: {}", one_line(&region.name));
    }
    let _ = writeln!(text, "element vertex {}", whole.vertices.len());
    text.push_str("property double x\nproperty double y\nproperty double z\n");
    let _ = writeln!(text, "element face {}", whole.triangles.len());
    text.push_str("property list uchar int vertex_indices\nproperty int region\nend_header\n");
    for [x, y, z] in coordinates(&whole) {
        let _ = writeln!(text, "{x} {y} {z}");
    }
    let owners = regions.meshes.iter().enumerate().flat_map(|(k, r)| std::iter::repeat_n(k, r.mesh.triangles.len()));
    for ([i, j, k], region) in whole.triangles.iter().zip(owners) {
        let _ = writeln!(text, "3 {i} {j} {k} {region}");
    }
    text
}

/// The bytes of a binary .stl file of a surface.
pub(super) fn stl(surface: &TriangleMesh) -> Vec<u8> {
    // Rounded first, so that triangles flattened by rounding are removed and their neighbours still meet.
    let whole = surface.in_single_precision();
    let single = |v: [f64; 3]| stl_io::Vertex::new(v.map(|x| x as f32));
    let triangle = |t: &[usize; 3]| {
        let corners = t.map(|i| whole.vertices[i]);
        let normal = whole.normal(t).map_or([0.0; 3], |n| [n.x, n.y, n.z]);
        stl_io::Triangle { normal: single(normal), vertices: corners.map(|p| single(xyz(&p))) }
    };
    let mut bytes = Vec::new();
    stl_io::write_stl(&mut bytes, whole.triangles.iter().map(triangle)).expect("memory can be written to");
    bytes
}

fn merged(regions: &Regions) -> TriangleMesh {
    let mut whole = TriangleMesh::default();
    regions.meshes.iter().for_each(|region| whole.append(&region.mesh));
    whole
}

fn xyz(p: &Point) -> [f64; 3] {
    [p.x, p.y, p.z]
}

fn coordinates(mesh: &TriangleMesh) -> impl Iterator<Item = [f64; 3]> + '_ {
    mesh.vertices.iter().map(xyz)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::collision::Kind;
    use cdpr_core::geometry::{Aabb, convex_mesh};
    use cdpr_core::regions::{RegionOptions, Space, regions};
    use cdpr_core::testing::{hard1, hard3};

    /// Vertices and faces of each object of an OBJ file.
    fn read_obj(text: &str) -> Vec<(String, TriangleMesh)> {
        let (mut objects, mut first): (Vec<(String, TriangleMesh)>, usize) = (Vec::new(), 1);
        for line in text.lines() {
            let (key, rest) = line.split_once(' ').unwrap();
            let words = || rest.split(' ');
            match key {
                "o" => {
                    first += objects.last().map_or(0, |(_, mesh)| mesh.vertices.len());
                    objects.push((rest.to_string(), TriangleMesh::default()));
                }
                "v" => objects
                    .last_mut()
                    .unwrap()
                    .1
                    .vertices
                    .push(Point::from_slice(&words().map(|x| x.parse().unwrap()).collect::<Vec<f64>>())),
                "f" => {
                    let corners: Vec<usize> = words().map(|i| i.parse::<usize>().unwrap() - first).collect();
                    objects.last_mut().unwrap().1.triangles.push(corners.try_into().unwrap());
                }
                other => assert_eq!(other, "#"),
            }
        }
        objects
    }

    #[test]
    fn an_obj_file_gives_back_every_mesh_bit_for_bit() {
        let found = regions(&hard3(), &RegionOptions { all: true, ..RegionOptions::default() }).unwrap();
        let read = read_obj(&obj(&hard3(), &found));
        assert_eq!(read.len(), found.meshes.len());
        assert!(read.iter().zip(&found.meshes).all(|((_, mesh), region)| *mesh == region.mesh));
        assert!(read.iter().any(|(name, _)| name == "cable_1_north"));
    }

    fn hostile_names() -> Regions {
        let within = *hard1().workspace();
        let region = |name: &str| NamedMesh {
            name: name.to_string(),
            kind: Kind::CableObstacle,
            culprits: Vec::new(),
            mesh: convex_mesh(&[], &within).unwrap(),
        };
        let meshes = ["a b", "a\nv 1 2 3", "a_b", "Säule 1", "/ /"].map(region).to_vec();
        Regions { space: Space::Attachment, within, meshes }
    }

    #[test]
    fn object_names_are_single_different_words() {
        let names: Vec<String> = read_obj(&obj(&hard1(), &hostile_names())).into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, ["a_b", "a_v_1_2_3", "a_b_2", "Säule_1", "region"]);
    }

    #[test]
    fn a_ply_file_numbers_the_faces_by_region() {
        let text = ply(&hard1(), &hostile_names());
        let (header, body) = text.split_once("end_header\n").unwrap();
        assert!(header.contains("element vertex 40\n") && header.contains("element face 60\n"));
        assert!(header.contains("comment region 1: a v 1 2 3\n"));
        let faces: Vec<&str> = body.lines().skip(40).collect();
        assert_eq!(faces.len(), 60);
        assert!(faces.iter().enumerate().all(|(k, face)| face.ends_with(&format!(" {}", k / 12))));
    }

    #[test]
    fn an_stl_file_has_every_triangle_and_says_where_outside_is() {
        let found = regions(&hard3(), &RegionOptions::default()).unwrap();
        let bytes = stl(&merged(&found));
        let read = stl_io::read_stl(&mut std::io::Cursor::new(bytes)).unwrap();
        assert_eq!(read.faces.len(), merged(&found).in_single_precision().triangles.len());
        let corner = |i: usize| Point::from(<[f32; 3]>::from(read.vertices[i]).map(f64::from));
        for face in &read.faces {
            let [a, b, c] = face.vertices.map(corner);
            let normal = Point::from(<[f32; 3]>::from(face.normal).map(f64::from)).coords;
            assert!((b - a).cross(&(c - a)).normalize().dot(&normal) > 0.999);
        }
    }

    #[test]
    fn stl_files_stay_closed_in_single_precision() {
        let far = Point::new(1e3, 1e3, 1e3);
        let within = Aabb { min: far, max: far + cdpr_core::geometry::Vector::repeat(1.0) };
        let diagonal = cdpr_core::geometry::Vector::repeat(1.0).normalize();
        let corner = cdpr_core::geometry::HalfSpace::through(&within.max, diagonal).widened(-1e-6);
        let cut = convex_mesh(&[corner], &within).unwrap();
        assert_eq!((cut.triangles.len(), cut.in_single_precision().triangles.len()), (16, 12));
    }

    #[test]
    fn formats_go_by_extension() {
        assert_eq!(RegionFormat::of(Path::new("a.stl")).unwrap(), RegionFormat::Stl);
        let error = RegionFormat::of(Path::new("shadows.step")).unwrap_err().to_string();
        assert_eq!(error, "shadows.step: found the extension .step, expected .obj, .ply, .stl or .html");
    }
}
