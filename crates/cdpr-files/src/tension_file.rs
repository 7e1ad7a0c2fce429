//! Cables along a path as CSV: `s,x,y,z`, m, then columns of cables: `length:`, `tension:` and, if they are known
//! somewhere, `command:`, `angle:` and `torque:`; then `capacity_margin,force_margin`, N, and `moment_margin`, N·m. Undefined entries are
//! empty. If the platform turns, the columns `qw,qx,qy,qz` follow `z`.

use std::path::Path;

use super::cable_columns::{columns, csv_text};
use super::output::write_atomically;
use super::text::{extension, other_extension};
use cdpr_core::error::Error;
use cdpr_core::model::Commands;
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
/// assert!(csv.starts_with("s,x,y,z,length:cable 0,") && csv.lines().count() == 4);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn tensions_csv(cables: &[&str], rows: &[TensionRow]) -> String {
    let winches = Winches::of(rows.iter().map(|row| &row.place));
    let header = place_header(cables, rows.first().map(|row| &row.place))
        .chain(columns("tension", cables))
        .chain(winches.header(cables))
        .chain(["capacity_margin", "force_margin", "moment_margin"].map(str::to_string));
    let record = |row: &TensionRow| {
        let margins = [row.capacity_margin, row.force_margin, row.moment_margin].map(cell);
        let tensions = cells(cables.len(), &row.tensions);
        place_record(&row.place)
            .chain(tensions)
            .chain(winches.record(cables.len(), &row.place))
            .chain(margins)
            .collect()
    };
    csv_text(header.collect(), rows.iter().map(record))
}

/// The rows as CSV text if tensions are not known.
pub fn lengths_csv(cables: &[&str], rows: &[LengthRow]) -> String {
    let winches = Winches::of(rows.iter());
    let header = place_header(cables, rows.first()).chain(winches.header(cables)).collect();
    csv_text(header, rows.iter().map(|row| place_record(row).chain(winches.record(cables.len(), row)).collect()))
}

fn place_header<'a>(cables: &'a [&str], first: Option<&LengthRow>) -> impl Iterator<Item = String> + 'a {
    let turns = first.is_some_and(|row| row.orientation.is_some());
    let orientation: &[&str] = if turns { &["qw", "qx", "qy", "qz"] } else { &[] };
    let place = ["s", "x", "y", "z"].iter().chain(orientation).map(|name| name.to_string());
    place.chain(columns("length", cables))
}

fn place_record(row: &LengthRow) -> impl Iterator<Item = String> {
    let pose = row.position.into_iter().chain(row.orientation.into_iter().flatten());
    [row.s].into_iter().chain(pose).chain(row.lengths.iter().copied()).map(|x| x.to_string())
}

/// A quantity of winches: the beginning of its columns, and its value in a row.
type Quantity = (&'static str, fn(&Commands) -> &Option<Vec<f64>>);

/// The quantities of winches.
const OF_WINCHES: [Quantity; 3] =
    [("command", |row| &row.commands), ("angle", |row| &row.angles), ("torque", |row| &row.torques)];

/// The quantities of winches that are known in some row.
struct Winches(Vec<Quantity>);

impl Winches {
    fn of<'a>(rows: impl Iterator<Item = &'a LengthRow> + Clone) -> Self {
        let known = |(_, of): &Quantity| rows.clone().any(|row| of(&row.winches).is_some());
        Winches(OF_WINCHES.into_iter().filter(known).collect())
    }

    fn header(&self, cables: &[&str]) -> Vec<String> {
        self.0.iter().flat_map(|(name, _)| columns(name, cables)).collect()
    }

    fn record(&self, count: usize, row: &LengthRow) -> Vec<String> {
        self.0.iter().flat_map(|(_, of)| cells(count, of(&row.winches))).collect()
    }
}

fn cells(count: usize, values: &Option<Vec<f64>>) -> impl Iterator<Item = String> {
    (0..count).map(|k| cell(values.as_ref().map(|values| values[k])))
}

fn cell(value: Option<f64>) -> String {
    value.map_or(String::new(), |value| value.to_string())
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
