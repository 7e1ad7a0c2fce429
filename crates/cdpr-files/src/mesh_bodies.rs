//! Replaces bodies given as meshes by convex parts. Decompositions that take time are cached beside the file, under a
//! key made from the contents of the file and the settings.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fmt, fs};

use hmac_sha256::Hash;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::mesh_reader::{MeshFile, bytes_of, mesh_from, mesh_of};
use super::output::write_atomically;
use super::text::read_bytes_at_most;
use cdpr_core::error::Error;
use cdpr_core::geometry::{Aabb, ConvexParts, Faults, MeshPiece, Point, TriangleMesh, convex_parts, pieces};
use cdpr_core::limits::{HUGE_MESH, MOST_MESH_BYTES, MOST_PARTS, MOST_PARTS_IN_ALL, MOST_PIECES};
use cdpr_core::model::body::{coordinates, one_shape, positive};
use cdpr_core::model::{AlikeNotes, BodySpec, MeshSource, Unit, WorkspaceSpec};
use cdpr_core::tolerances::{EXACT_VOLUME, MESH_TOLERANCE, MESH_TOLERANCE_IN_ALL, SHEET, USELESS_REACH};
use cdpr_core::watch::Watch;
use cdpr_core::words::{count, length};

/// Number of meshes up to which each note of a kind is printed.
const MOST_ALIKE: usize = 3;

/// A remark about a mesh.
#[derive(Debug, Clone)]
pub(super) struct Remark {
    /// Where the scene or robot names the mesh, and its file.
    mesh: String,
    text: String,
    /// Whether the remark needs no warning.
    pub good: bool,
}

impl Remark {
    /// What remarks of a kind have in common: their first words, without numbers and plurals.
    fn kind(&self) -> (bool, String) {
        let head = self.text.split([',', ':', ';']).next().unwrap_or_default();
        let words = head.split_whitespace().filter(|word| !word.starts_with(|c: char| c.is_ascii_digit()));
        (self.good, words.map(|word| word.trim_end_matches('s')).collect::<Vec<_>>().join(" "))
    }

    /// The largest length stated in the remark, mm.
    fn largest_length(&self) -> Option<f64> {
        let words: Vec<&str> = self.text.split([' ', ',', ';', '(', ')']).collect();
        let lengths = words.windows(2).filter(|pair| pair[1] == "mm").filter_map(|pair| pair[0].parse().ok());
        lengths.max_by(f64::total_cmp)
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.mesh, self.text)
    }
}

/// Remarks about the meshes of a scene or robot.
#[derive(Debug, Default)]
pub(super) struct MeshRemarks {
    /// The workspace, if there is one, to compare sizes with.
    pub workspace: Option<WorkspaceSpec>,
    /// Notes for the user.
    pub notes: Vec<Remark>,
    /// Possible causes of a later error.
    pub hints: Vec<Remark>,
}

impl MeshRemarks {
    /// The notes of each kind that concerns many meshes, with a sentence in their place: the note that states the largest
    /// length, or else the first one.
    pub fn alike(&self) -> Vec<AlikeNotes> {
        let mut kinds: BTreeMap<(bool, String), Vec<&Remark>> = BTreeMap::new();
        self.notes.iter().chain(&self.hints).for_each(|note| kinds.entry(note.kind()).or_default().push(note));
        let many = kinds.into_values().filter(|notes| notes.len() > MOST_ALIKE);
        many.map(|notes| {
            let longest = notes.iter().filter_map(|note| note.largest_length()).max_by(f64::total_cmp);
            let shown = notes.iter().find(|note| note.largest_length() == longest).expect("there are many");
            let largest = if longest.is_some() { ", which states the largest length" } else { "" };
            let sentence = format!("{} meshes have a note like this one{largest}: {shown}", notes.len());
            AlikeNotes { sentence, notes: notes.iter().map(ToString::to_string).collect() }
        })
        .collect()
    }
}

/// Replaces every mesh by its convex parts: the first part in place of the mesh, the others after all bodies, so that
/// indices in messages stay correct.
pub(super) fn in_place(
    bodies: &mut Vec<BodySpec>,
    list: &str,
    folder: Option<&Path>,
    remarks: &mut MeshRemarks,
    watch: &Watch,
) -> Result<(), Error> {
    if bodies.iter().all(|body| body.mesh.is_none()) {
        return Ok(());
    }
    let mut behind = Vec::new();
    for (k, body) in bodies.iter_mut().enumerate() {
        let place = format!("{list}[{k}]");
        if list == "obstacles" {
            body.name.get_or_insert_with(|| format!("obstacle {k}"));
        }
        let Some(source) = &body.mesh else { continue };
        one_shape(&place, body)?;
        let (what, parts) = match source {
            MeshSource::File(name) => {
                let path = folder.map_or_else(|| PathBuf::from(name), |folder| folder.join(name));
                (format!("{place}: {name}"), of_file(&path, body, &place, watch)?)
            }
            MeshSource::Inline(mesh) => {
                let size = (scale(body, &place)?, tolerance(body, &place)?);
                let mesh = mesh_of(mesh).map_err(|e| e.under(&format!("{place}.mesh")))?;
                (place.clone(), parts_of(&mesh, size, watch).map_err(|e| e.under(&format!("{place}.mesh")))?)
            }
        };
        let remark = |good: bool, text: &String| Remark { mesh: what.clone(), text: text.clone(), good };
        remarks.notes.extend(parts.notes.iter().map(|note| remark(parts.exact, note)));
        remarks.hints.extend(units_hint(body, &parts, remarks.workspace.as_ref()).map(|hint| remark(false, &hint)));
        let mut specs = parts.parts.into_iter().map(|vertices| as_vertices(body, vertices));
        let first = specs.next().expect("a mesh has parts");
        behind.extend(specs);
        *body = first;
    }
    bodies.extend(behind);
    Ok(())
}

/// A hint if a mesh without `units` is much larger than the workspace: its coordinates are probably in millimetres.
fn units_hint(body: &BodySpec, parts: &Parts, workspace: Option<&WorkspaceSpec>) -> Option<String> {
    let WorkspaceSpec { min, max } = workspace.filter(|_| body.units.is_none())?;
    let corners: Vec<Point> = parts.parts.iter().flatten().map(|v| Point::from(*v)).collect();
    let (size, room) = (largest_side(&corners), largest_side(&[Point::from(*min), Point::from(*max)]));
    let much = size > HUGE_MESH * room;
    much.then(|| {
        let found = format!("it is {} long in a workspace of {}", length(size), length(room));
        format!("{found}; if its coordinates are millimetres, add units = \"mm\"")
    })
}

fn as_vertices(body: &BodySpec, vertices: Vec<[f64; 3]>) -> BodySpec {
    let BodySpec { name, position, rpy, rpy_degrees, quaternion, .. } = body.clone();
    BodySpec { name, vertices: Some(vertices), position, rpy, rpy_degrees, quaternion, ..BodySpec::default() }
}

fn scale(body: &BodySpec, place: &str) -> Result<f64, Error> {
    Ok(positive(&format!("{place}.scale"), body.scale.unwrap_or(1.0))? * body.units.unwrap_or(Unit::M).metres())
}

fn tolerance(body: &BodySpec, place: &str) -> Result<Option<f64>, Error> {
    body.tolerance.map(|length| positive(&format!("{place}.tolerance"), length)).transpose()
}

/// Corners of convex parts, m, and remarks about them.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Parts {
    parts: Vec<Vec<[f64; 3]>>,
    notes: Vec<String>,
    /// Whether the parts equal the mesh and the mesh has no defects.
    exact: bool,
}

fn of_file(path: &Path, body: &BodySpec, place: &str, watch: &Watch) -> Result<Parts, Error> {
    let size = (scale(body, place)?, tolerance(body, place)?);
    let bytes = bytes_of(path)?;
    let key = key(&bytes, size);
    let kept = path.with_file_name(format!(
        "{}.{}.parts.json",
        path.file_name().unwrap_or_default().to_string_lossy(),
        &key[..8]
    ));
    if let Some(parts) = kept_parts(&kept, &key) {
        return Ok(parts);
    }
    let MeshFile { mesh, notes } = mesh_from(path, &bytes)?;
    let mut parts = parts_of(&mesh, size, watch).map_err(|e| e.in_file(path))?;
    parts.exact &= notes.is_empty();
    parts.notes.splice(..0, notes);
    if parts.parts.len() > 1 {
        keep(&kept, &key, &parts);
    }
    Ok(parts)
}

/// The convex parts of a mesh, scaled to metres.
fn parts_of(mesh: &TriangleMesh, (scale, tolerance): (f64, Option<f64>), watch: &Watch) -> Result<Parts, Error> {
    let scaled =
        TriangleMesh { vertices: mesh.vertices.iter().map(|v| v * scale).collect(), triangles: mesh.triangles.clone() };
    let numbers: Vec<f64> = scaled.vertices.iter().flat_map(|v| [v.x, v.y, v.z]).collect();
    coordinates("", &numbers)?;
    let (pieces, faults) = pieces(&scaled, watch)?;
    if pieces.is_empty() {
        return Err(Error::invalid("", "found no triangle with an area, expected at least one"));
    }
    if pieces.len() > MOST_PIECES {
        let problem = format!("found {} disconnected pieces, expected at most {MOST_PIECES}", pieces.len());
        return Err(Error::invalid(
            "",
            format!("{problem}; merge coincident vertices of neighbours, or use fewer pieces"),
        ));
    }
    let whole = largest_side(&scaled.vertices);
    let most = (MOST_PARTS_IN_ALL / pieces.len()).clamp(1, MOST_PARTS);
    let asked = |piece: &MeshPiece| {
        let usual = (MESH_TOLERANCE * extent(piece)).max(MESH_TOLERANCE_IN_ALL * whole);
        tolerance.unwrap_or(usual).max(4.0 * SHEET)
    };
    let found = |piece: &MeshPiece| convex_parts(piece, asked(piece), most, watch);
    let parts: Vec<ConvexParts> = pieces.par_iter().map(found).collect::<Result<_, _>>()?;
    let asked: Vec<f64> = pieces.iter().map(asked).collect();
    if let Some(problem) = useless(&asked, &pieces, &parts, &faults) {
        return Err(Error::invalid("", problem));
    }
    let mut notes = faults.notes();
    notes.extend(coverage_note(&scaled, &pieces, &parts));
    notes.extend(missed(&asked, &parts, most));
    let corners = parts.iter().flat_map(|p| &p.bodies).map(|b| b.vertices().iter().map(|v| [v.x, v.y, v.z]).collect());
    let exact = faults.notes().is_empty() && parts.iter().all(|p| p.reach == 0.0);
    Ok(Parts { parts: corners.collect(), notes, exact })
}

fn extent(piece: &MeshPiece) -> f64 {
    let corners: Vec<Point> = piece.triangles.iter().flatten().copied().collect();
    largest_side(&corners)
}

fn largest_side(points: &[Point]) -> f64 {
    let aabb = Aabb::around(points);
    (aabb.max - aabb.min).amax()
}

/// The remark on how closely the parts cover the mesh; `None` if the mesh is a single convex body.
fn coverage_note(mesh: &TriangleMesh, pieces: &[MeshPiece], parts: &[ConvexParts]) -> Option<String> {
    let bodies: usize = parts.iter().map(|p| p.bodies.len()).sum();
    let reach = parts.iter().map(|p| p.reach).fold(0.0, f64::max);
    if bodies == 1 && reach == 0.0 {
        return None;
    }
    let solid: f64 = pieces.iter().filter_map(|p| p.volume).sum();
    let of_solids = pieces.iter().zip(parts).filter(|(piece, _)| piece.volume.is_some());
    let filled: f64 = of_solids.flat_map(|(_, p)| &p.bodies).map(|b| b.volume()).sum();
    let more = (filled - solid).max(0.0);
    let beyond = if reach == 0.0 {
        "which fill it exactly".to_string()
    } else if more > EXACT_VOLUME * solid {
        format!("which reach at most {:.1} mm beyond it and hold {:.3} m³ more (of {solid:.3} m³)", 1e3 * reach, more)
    } else {
        format!("which reach at most {:.1} mm beyond it", 1e3 * reach)
    };
    Some(format!("{} in {}, {beyond}", count(mesh.triangles.len(), "triangle"), count(bodies, "convex part")))
}

/// Describes a piece whose parts extend too far beyond it to be useful; `None` if there is none.
fn useless(asked: &[f64], pieces: &[MeshPiece], parts: &[ConvexParts], faults: &Faults) -> Option<String> {
    let share = |k: usize| parts[k].reach / extent(&pieces[k]);
    let useless = (0..pieces.len()).filter(|k| parts[*k].reach > asked[*k] && share(*k) > USELESS_REACH);
    let worst = useless.max_by(|a, b| share(*a).total_cmp(&share(*b)))?;
    let what = match (pieces[worst].volume, faults.notes().is_empty()) {
        (Some(_), _) => "closed, so it probably intersects itself".to_string(),
        (None, true) => "open".to_string(),
        (None, false) => format!("open ({})", faults.notes().join("; ")),
    };
    let found = format!(
        "found a piece of {}, {what}, whose convex parts reach {:.1} mm beyond it, where {:.1} mm was requested",
        count(pieces[worst].triangles.len(), "triangle"),
        1e3 * parts[worst].reach,
        1e3 * asked[worst],
    );
    let most = 1e3 * USELESS_REACH * extent(&pieces[worst]);
    let expected = format!("expected at most {most:.1} mm, {:.0} % of its largest side", 100.0 * USELESS_REACH);
    Some(format!("{found}; {expected}: repair the mesh (no self-intersections, no holes) or replace it"))
}

/// Describes where parts exceed the tolerance, and by how much; `None` if none do.
fn missed(asked: &[f64], parts: &[ConvexParts], most: usize) -> Option<String> {
    let missed: Vec<(f64, f64)> = asked
        .iter()
        .zip(parts)
        .map(|(asked, parts)| (*asked, parts.reach))
        .filter(|(asked, reach)| reach > asked)
        .collect();
    let worst = missed.iter().max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))?;
    let pieces = count(missed.len(), "piece");
    let by = format!(
        "by up to {:.1} mm (requested {:.1} mm, reached {:.1} mm)",
        1e3 * (worst.1 - worst.0),
        1e3 * worst.0,
        1e3 * worst.1
    );
    let why = format!("each piece is limited to {most} parts and some computing time");
    Some(format!(
        "the tolerance is missed in {pieces}, {by}: {why}; repair or simplify the mesh, or set a larger tolerance"
    ))
}

/// Contents of the cache file. The checksum detects changes and truncation.
#[derive(Serialize, Deserialize)]
struct Kept {
    key: String,
    sum: String,
    #[serde(flatten)]
    parts: Parts,
}

/// Identifies a decomposition: the mesh, the settings, and the version of the method.
fn key(bytes: &[u8], (scale, tolerance): (f64, Option<f64>)) -> String {
    const METHOD: &str = "convex parts 7";
    let asked = format!("{METHOD} {scale} {tolerance:?} {}", env!("CARGO_PKG_VERSION"));
    hex(&[asked.as_bytes(), bytes])
}

fn hex(pieces: &[&[u8]]) -> String {
    let mut hash = Hash::new();
    pieces.iter().for_each(|piece| hash.update(piece));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

fn sum(parts: &Parts) -> String {
    hex(&[serde_json::to_string(parts).expect("parts are finite").as_bytes()])
}

/// Parts from the cache beside a file; `None` if there are none, or if they are for another key or were changed.
fn kept_parts(path: &Path, key: &str) -> Option<Parts> {
    let kept: Kept = serde_json::from_slice(&read_bytes_at_most(path, MOST_MESH_BYTES).ok()?).ok()?;
    let parts = kept.parts;
    (kept.key == key && kept.sum == sum(&parts) && !parts.parts.is_empty()).then_some(parts)
}

/// Caches parts beside a file. If the folder cannot be written, they are just computed again next time. Only a regular
/// file is replaced: a pipe would wait for a reader, and a link may lead to anything.
fn keep(path: &Path, key: &str, parts: &Parts) {
    if fs::symlink_metadata(path).is_ok_and(|found| !found.is_file()) {
        return;
    }
    let kept = Kept { key: key.to_string(), sum: sum(parts), parts: parts.clone() };
    let text = serde_json::to_string(&kept).expect("parts are finite");
    let _ = write_atomically(path, text.as_bytes());
}
