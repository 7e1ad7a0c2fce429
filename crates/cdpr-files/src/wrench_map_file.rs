//! Files of wrench maps: .npz for NumPy, which can be read back, and .vti for ParaView.
//!
//! In an .npz file: `margin`, and if computed `force_margin` and `moment_margin`, float64 of shape (nx, ny, nz) in C
//! order; `origin`, float64 (3,), m; `step`, float64 (), m; `metadata`, JSON text, unicode (). In a .vti file (VTK
//! ImageData, XML) the same margins are point data, with the grid in double precision; the crate vtkio
//! would hold origin and spacing in single precision.

use std::io::{self, BufReader, Cursor, Read, Seek};
use std::path::Path;

use npyz::{NpyFile, Order};
use serde::{Deserialize, Serialize};
use zip::ZipArchive;

use super::npz::Npz;
use super::output::write_atomically;
use super::text::{extension, open, other_extension};
use cdpr_core::error::Error;
use cdpr_core::geometry::Point;
use cdpr_core::limits::MAP_NODES;
use cdpr_core::wrench::map::{Grid, Margins};
use cdpr_core::wrench::{MapIdentity, WrenchMap};

/// The format name in the metadata of a map.
const FORMAT: &str = "cdpr wrench map";
/// Format version of the files written.
const VERSION: u32 = 1;
/// Longest metadata read, bytes (NumPy takes four for a character): far above those of any robot.
const LONGEST_METADATA: usize = 1 << 26;

/// The formats of wrench maps, selected by extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapFormat {
    /// `.npz`: arrays for NumPy, and for [`load_wrench_map`].
    Npz,
    /// `.vti`: ImageData for ParaView.
    Vti,
}

impl MapFormat {
    /// The format for the file's extension; call this before doing any work.
    ///
    /// # Errors
    /// Another extension.
    pub fn of(path: &Path) -> Result<Self, Error> {
        match extension(path).as_deref() {
            Some("npz") => Ok(MapFormat::Npz),
            Some("vti") => Ok(MapFormat::Vti),
            _ => Err(other_extension(path, ".npz or .vti")),
        }
    }
}

#[derive(Serialize, Deserialize)]
struct Metadata {
    format: String,
    version: u32,
    fingerprint: String,
    identity: MapIdentity,
}

/// Writes a map in the format given by the extension.
///
/// # Errors
/// Another extension, or a file that cannot be written; nothing half-written is left.
pub fn save_wrench_map(path: impl AsRef<Path>, map: &WrenchMap) -> Result<(), Error> {
    let path = path.as_ref();
    let bytes = match MapFormat::of(path)? {
        MapFormat::Npz => npz(map).map_err(|e| Error::file(path, format!("cannot be written: {e}")))?,
        MapFormat::Vti => vti(map),
    };
    write_atomically(path, &bytes)
}

/// Reads a map from an .npz file. If an identity is given, a map with another robot, load or requirement is an error.
///
/// # Errors
/// A file that cannot be read, is not a wrench map, or is truncated; a map with another identity.
///
/// # Example
/// ```
/// use cdpr_core::{Point, geometry::Aabb, testing};
/// use cdpr_files as io;
/// use cdpr_core::{Required, WrenchMap, wrench::{MapIdentity, MapOptions, Statics}};
/// # use cdpr_core::batch::BatchOptions;
/// # let folder = tempfile::tempdir().unwrap();
/// # let path = folder.path().join("map.npz");
/// let (statics, required) = (Statics::of(&testing::empty())?, Required::default());
/// let within = Aabb { min: Point::new(0.5, 0.5, 0.5), max: Point::new(1.5, 1.5, 1.5) };
/// let batch = BatchOptions::default();
/// let map = WrenchMap::new(&statics, &required, &within, &MapOptions { step: 0.1, projected: true }, &batch)?;
/// io::save_wrench_map(&path, &map)?;
/// assert_eq!(io::load_wrench_map(&path, Some(&MapIdentity::of(&statics, &required)))?, map);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn load_wrench_map(path: impl AsRef<Path>, expected: Option<&MapIdentity>) -> Result<WrenchMap, Error> {
    let path = path.as_ref();
    if MapFormat::of(path)? == MapFormat::Vti {
        return Err(Error::file(path, "found a .vti file, which is for ParaView only; expected an .npz file"));
    }
    let file = open(path)?;
    let map = read_npz(BufReader::new(file)).map_err(|e| e.in_file(path))?;
    expected.map_or(Ok(()), |identity| identity.expect(map.identity())).map_err(|e| e.in_file(path))?;
    Ok(map)
}

/// A map as the bytes of an .npz file, for other processes.
///
/// # Example
/// ```
/// use cdpr_core::{Point, geometry::Aabb, testing};
/// use cdpr_files as io;
/// use cdpr_core::{Required, WrenchMap, wrench::{MapOptions, Statics}};
/// # use cdpr_core::batch::BatchOptions;
/// let (statics, required) = (Statics::of(&testing::empty())?, Required::default());
/// let within = Aabb { min: Point::new(0.5, 0.5, 0.5), max: Point::new(1.5, 1.5, 1.5) };
/// let batch = BatchOptions::default();
/// let map = WrenchMap::new(&statics, &required, &within, &MapOptions { step: 0.5, projected: false }, &batch)?;
/// assert_eq!(io::wrench_map_from_npz(&io::wrench_map_to_npz(&map))?, map);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn wrench_map_to_npz(map: &WrenchMap) -> Vec<u8> {
    npz(map).expect("memory takes what is written")
}

/// A map from the bytes of an .npz file.
///
/// # Errors
/// Bytes that are not a wrench map or are truncated.
pub fn wrench_map_from_npz(bytes: &[u8]) -> Result<WrenchMap, Error> {
    read_npz(Cursor::new(bytes))
}

/// The margins of a map under their names in files.
fn named(margins: &Margins) -> impl Iterator<Item = (&'static str, &Vec<f64>)> {
    let projected = [("force_margin", &margins.force), ("moment_margin", &margins.moment)];
    let present = projected.into_iter().filter_map(|(name, margins)| margins.as_ref().map(|m| (name, m)));
    [("margin", &margins.capacity)].into_iter().chain(present)
}

fn npz(map: &WrenchMap) -> io::Result<Vec<u8>> {
    let mut npz = Npz::new();
    let grid = map.grid();
    let shape = grid.counts.map(|n| n as u64);
    for (name, margins) in named(map.margins()) {
        npz.numbers(name, &shape, margins)?;
    }
    npz.numbers("origin", &[3], grid.origin.coords.as_slice())?;
    npz.numbers("step", &[], &[grid.step])?;
    npz.texts("metadata", &[], &[&metadata(map.identity())])?;
    npz.finish()
}

fn metadata(identity: &MapIdentity) -> String {
    let fingerprint = identity.fingerprint();
    let metadata = Metadata { format: FORMAT.to_string(), version: VERSION, fingerprint, identity: identity.clone() };
    serde_json::to_string(&metadata).expect("plain data")
}

/// An error about an array of the file.
fn unsound(name: &str, problem: impl std::fmt::Display) -> Error {
    Error::invalid(name, format!("{problem}; expected a wrench map as `save_wrench_map` writes it"))
}

fn read_npz(file: impl Read + Seek) -> Result<WrenchMap, Error> {
    let mut zip =
        ZipArchive::new(file).map_err(|e| unsound("", format!("found an incomplete or invalid .npz file ({e})")))?;
    let identity = read_metadata(&mut zip)?;
    let (_, origin) = numbers(&mut zip, "origin", |shape| shape == [3])?;
    let (_, step) = numbers(&mut zip, "step", <[u64]>::is_empty)?;
    let (shape, capacity) = numbers(&mut zip, "margin", |shape| shape.len() == 3)?;
    let mut projected = |name: &str| {
        let present = zip.index_for_name(&npyz::npz::file_name_from_array_name(name)).is_some();
        let same = |found: &[u64]| found == shape;
        if present { numbers(&mut zip, name, same).map(|(_, numbers)| Some(numbers)) } else { Ok(None) }
    };
    let (force, moment) = (projected("force_margin")?, projected("moment_margin")?);
    let counts = std::array::from_fn(|axis| shape[axis] as usize);
    let grid = Grid { origin: Point::from_slice(&origin), step: step[0], counts };
    WrenchMap::from_parts(grid, identity, Margins { capacity, force, moment })
}

fn read_metadata(zip: &mut ZipArchive<impl Read + Seek>) -> Result<MapIdentity, Error> {
    let fits = |shape: &[u64], bytes: usize| shape.is_empty() && bytes <= LONGEST_METADATA;
    let (_, text) = read_array::<String>(zip, "metadata", fits)?;
    let value: serde_json::Value = serde_json::from_str(&text[0]).map_err(|e| unsound("metadata", e))?;
    if value["format"] != FORMAT || value["version"] != VERSION {
        let found = format!("found format {} version {}", value["format"], value["version"]);
        return Err(Error::invalid("metadata", format!("{found}, expected \"{FORMAT}\" version {VERSION}")));
    }
    let Metadata { fingerprint, identity, .. } = serde_json::from_value(value).map_err(|e| unsound("metadata", e))?;
    if fingerprint != identity.fingerprint() {
        return Err(unsound("metadata", format!("found fingerprint {fingerprint} of another identity")));
    }
    Ok(identity)
}

fn numbers(
    zip: &mut ZipArchive<impl Read + Seek>,
    name: &str,
    fits: impl Fn(&[u64]) -> bool,
) -> Result<(Vec<u64>, Vec<f64>), Error> {
    let few = |shape: &[u64]| shape.iter().map(|n| *n as f64).product::<f64>() <= MAP_NODES;
    read_array(zip, name, |shape, _| fits(shape) && few(shape))
}

/// Reads an array to its end, where the checksum is; `fits` checks its shape and element size before any data is read.
fn read_array<T: npyz::Deserialize>(
    zip: &mut ZipArchive<impl Read + Seek>,
    name: &str,
    fits: impl Fn(&[u64], usize) -> bool,
) -> Result<(Vec<u64>, Vec<T>), Error> {
    let entry = zip.by_name(&npyz::npz::file_name_from_array_name(name));
    let entry = entry.map_err(|e| unsound(name, format!("cannot be found: {e}")))?;
    let size = entry.size();
    let mut entry = BufReader::new(entry);
    let array = NpyFile::new(&mut entry).map_err(|e| unsound(name, e))?;
    let header = array.header();
    let (shape, dtype) = (header.shape().to_vec(), header.dtype());
    let sound = header.order() == Order::C || shape.len() < 2;
    if !sound || !dtype.num_bytes().is_some_and(|bytes| fits(&shape, bytes)) {
        return Err(unsound(
            name,
            format!("found shape {shape:?}, type {}, {:?} order", dtype.descr(), header.order()),
        ));
    }
    let stated = dtype.num_bytes().and_then(|bytes| shape.iter().try_fold(bytes as u64, |all, n| all.checked_mul(*n)));
    if stated.is_none_or(|stated| stated > size) {
        return Err(unsound(name, format!("found shape {shape:?} in {size} bytes")));
    }
    let elements: Vec<T> = array.into_vec().map_err(|e| unsound(name, e))?;
    match entry.read(&mut [0]) {
        Ok(0) => Ok((shape, elements)),
        Ok(_) => Err(unsound(name, "found more numbers than its shape allows")),
        Err(e) => Err(unsound(name, e)),
    }
}

/// ImageData with raw appended data. Written by hand, since `vtkio` keeps origin and spacing in single precision, which
/// would move the nodes.
fn vti(map: &WrenchMap) -> Vec<u8> {
    let Grid { origin, step, counts: [nx, ny, nz] } = map.grid();
    let bytes = 8 * map.grid().len();
    let extent = format!("0 {} 0 {} 0 {}", nx - 1, ny - 1, nz - 1);
    let array = |(k, (name, _)): (usize, (&str, &Vec<f64>))| {
        let offset = k * (8 + bytes); // each array after its length
        format!("        <DataArray type=\"Float64\" Name=\"{name}\" format=\"appended\" offset=\"{offset}\"/>\n")
    };
    let arrays: String = named(map.margins()).enumerate().map(array).collect();
    let mut file = format!(
        "<?xml version=\"1.0\"?>\n<!-- {FORMAT}, identity {} -->\n\
         <VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  \
         <ImageData WholeExtent=\"{extent}\" Origin=\"{} {} {}\" Spacing=\"{step} {step} {step}\">\n    \
         <Piece Extent=\"{extent}\">\n      <PointData Scalars=\"margin\">\n{arrays}      </PointData>\n    \
         </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n_",
        map.identity().fingerprint(),
        origin.x,
        origin.y,
        origin.z
    )
    .into_bytes();
    for (_, margins) in named(map.margins()) {
        file.extend((bytes as u64).to_le_bytes());
        for k in 0..*nz {
            for j in 0..*ny {
                (0..*nx).for_each(|i| file.extend(margins[map.grid().index([i, j, k])].to_le_bytes()));
            }
        }
    }
    file.extend(b"\n  </AppendedData>\n</VTKFile>\n");
    file
}
