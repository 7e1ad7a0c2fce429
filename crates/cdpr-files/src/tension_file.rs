//! Cables along a path as CSV. The headers of a cable's columns contain its name and the unit: `s,x,y,z,length of winch
//! 1 (m),…,tension of winch 1 (N),…,capacity_margin,force_margin,moment_margin`; the other columns are in m, N and N·m.
//! Undefined entries are empty. If the platform turns, the columns `qw,qx,qy,qz` follow `z`.

use std::path::Path;

use super::output::write_atomically;
use super::text::{extension, other_extension};
use cdpr_core::error::Error;
use cdpr_core::wrench::{LengthRow, TensionRow};

/// The rows as CSV text; `cables` are the names of the cables.
///
/// # Example
/// ```
/// use cdpr_core::{Point, testing};
/// use cdpr_files::tensions_csv;
/// use cdpr_core::{tensions_along, path::held};
/// use cdpr_core::{Required, Watch};
/// let scene = testing::empty();
/// let path = held(&scene, &[Point::new(1.0, 1.0, 0.5), Point::new(1.0, 1.0, 1.5)]);
/// let rows = tensions_along(&scene, &Required::default(), &path, 0.5, None, &Watch::NONE)?;
/// let csv = tensions_csv(&scene.robot().cable_names(), &rows);
/// assert!(csv.starts_with("s,x,y,z,length of cable 0 (m),") && csv.lines().count() == 4);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn tensions_csv(cables: &[&str], rows: &[TensionRow]) -> String {
    let header = place_header(cables, rows.first().is_some_and(|row| row.place.orientation.is_some()))
        .chain(columns("tension", cables, "N"))
        .chain(["capacity_margin", "force_margin", "moment_margin"].map(str::to_string));
    let record = |row: &TensionRow| {
        let tensions = (0..cables.len()).map(|k| row.tensions.as_ref().map(|t| t[k]));
        let margins = [row.capacity_margin, row.force_margin, row.moment_margin];
        let numbers = tensions.chain(margins).map(|x| x.map_or(String::new(), |x| x.to_string()));
        place_record(&row.place).chain(numbers).collect()
    };
    table(header.collect(), rows.iter().map(record))
}

/// The rows as CSV text if tensions are not known.
pub fn lengths_csv(cables: &[&str], rows: &[LengthRow]) -> String {
    let turns = rows.first().is_some_and(|row| row.orientation.is_some());
    table(place_header(cables, turns).collect(), rows.iter().map(|row| place_record(row).collect()))
}

fn place_header(cables: &[&str], turns: bool) -> impl Iterator<Item = String> {
    let orientation: &[&str] = if turns { &["qw", "qx", "qy", "qz"] } else { &[] };
    let place = ["s", "x", "y", "z"].iter().chain(orientation).map(|name| name.to_string());
    place.chain(columns("length", cables, "m"))
}

fn columns(what: &str, cables: &[&str], unit: &str) -> Vec<String> {
    cables.iter().map(|cable| format!("{what} of {cable} ({unit})")).collect()
}

fn place_record(row: &LengthRow) -> impl Iterator<Item = String> {
    let pose = row.position.into_iter().chain(row.orientation.into_iter().flatten());
    [row.s].into_iter().chain(pose).chain(row.lengths.iter().copied()).map(|x| x.to_string())
}

fn table(header: Vec<String>, rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in std::iter::once(header).chain(rows) {
        writer.write_record(record).expect("memory takes rows of one length");
    }
    String::from_utf8(writer.into_inner().expect("memory takes it")).expect("numbers and names are text")
}

/// Writes the rows as a CSV file, atomically.
///
/// # Errors
/// A name that does not end in .csv, a file that cannot be written.
pub fn save_tensions(path: impl AsRef<Path>, cables: &[&str], rows: &[TensionRow]) -> Result<(), Error> {
    let path = path.as_ref();
    check_tensions_name(path)?;
    write_atomically(path, tensions_csv(cables, rows).as_bytes())
}

/// Checks that a file name is suitable for tensions.
///
/// # Errors
/// A name that does not end in .csv.
pub fn check_tensions_name(path: impl AsRef<Path>) -> Result<(), Error> {
    let path = path.as_ref();
    match extension(path).as_deref() {
        Some("csv") => Ok(()),
        _ => Err(other_extension(path, ".csv")),
    }
}
