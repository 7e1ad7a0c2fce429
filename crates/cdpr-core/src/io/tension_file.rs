//! Tensions along a path as CSV: `s,x,y,z,length_0,…,tension_0,…,capacity_margin,force_margin,moment_margin`, in m, N and
//! N·m; cables count from 0, and what does not exist is left empty.

use std::path::Path;

use super::output::write_atomically;
use super::text::{extension, other_extension};
use crate::error::Error;
use crate::wrench::TensionRow;

/// The rows as CSV text.
///
/// # Example
/// ```
/// use cdpr_core::{geometry::Point, io::tensions_csv, testing};
/// use cdpr_core::wrench::{Loads, Required, Statics, tensions_along};
/// let statics = Statics::new(testing::empty().robot(), &Loads::default())?;
/// let path = [Point::new(1.0, 1.0, 0.5), Point::new(1.0, 1.0, 1.5)];
/// let rows = tensions_along(&statics, &Required::default(), &path, 0.5, None, &|| false)?;
/// let csv = tensions_csv(&rows);
/// assert!(csv.starts_with("s,x,y,z,length_0,") && csv.lines().count() == 4);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn tensions_csv(rows: &[TensionRow]) -> String {
    let cables = rows.first().map_or(0, |row| row.lengths.len());
    let numbered = |what: &'static str| (0..cables).map(move |k| format!("{what}_{k}"));
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = |names: &[&str]| names.iter().map(ToString::to_string).collect::<Vec<_>>();
    let header = names(&["s", "x", "y", "z"]).into_iter().chain(numbered("length")).chain(numbered("tension"));
    let header = header.chain(names(&["capacity_margin", "force_margin", "moment_margin"]));
    writer.write_record(header.collect::<Vec<_>>()).expect("memory takes it");
    for row in rows {
        writer.write_record(record(row, cables)).expect("all rows are equally long");
    }
    String::from_utf8(writer.into_inner().expect("memory takes it")).expect("numbers are text")
}

fn record(row: &TensionRow, cables: usize) -> Vec<String> {
    let number = |x: f64| x.to_string();
    let maybe = |x: Option<f64>| x.map_or(String::new(), number);
    let tensions = (0..cables).map(|k| maybe(row.tensions.as_ref().map(|t| t[k])));
    let place = [row.s].into_iter().chain(row.position).map(number);
    let margins = [row.capacity_margin, row.force_margin, row.moment_margin].map(maybe);
    place.chain(row.lengths.iter().copied().map(number)).chain(tensions).chain(margins).collect()
}

/// Writes the rows as a CSV file, whole or not at all.
///
/// # Errors
/// A name that does not end in .csv, a file that cannot be written.
pub fn save_tensions(path: &Path, rows: &[TensionRow]) -> Result<(), Error> {
    check_tensions_name(path)?;
    write_atomically(path, tensions_csv(rows).as_bytes())
}

/// Checks that a name is one for tensions.
///
/// # Errors
/// A name that does not end in .csv.
pub fn check_tensions_name(path: &Path) -> Result<(), Error> {
    match extension(path).as_deref() {
        Some("csv") => Ok(()),
        _ => Err(other_extension(path, ".csv")),
    }
}
