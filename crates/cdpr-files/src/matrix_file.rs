//! Lengths or durations between stations as CSV: a row and a column for each station, the unit in the corner, 0 on the diagonal, empty where
//! no path or no motion is known.

use std::path::Path;

use cdpr_core::error::Error;
use cdpr_core::tour::Legs;

use super::cable_columns::csv_text;
use super::csv_cell::cell;
use super::text::{extension, other_extension};

/// What tours are compared by as CSV text: lengths, m, or durations, s.
///
/// # Example
/// ```
/// use cdpr_core::model::Station;
/// use cdpr_core::planning::Status;
/// use cdpr_core::tour::{Leg, Legs};
/// use cdpr_files::matrix_csv;
/// let station = |name: &str| Station { name: name.to_string(), position: Default::default(), orientation: None };
/// let leg = Leg { status: Status::Solved, cost: 1.5, lower_bound: 1.4, path: Vec::new(), time: None };
/// let legs = Legs { stations: vec![station("dock"), station("rack")], pairs: vec![[0, 1]], legs: vec![leg] };
/// assert_eq!(matrix_csv(&legs), "m,dock,rack\ndock,0,1.5\nrack,1.5,0\n");
/// ```
pub fn matrix_csv(legs: &Legs) -> String {
    let names = || legs.stations.iter().map(|station| cell(&station.name).into_owned());
    let unit = if legs.legs.iter().any(|leg| leg.time.is_some()) { "s" } else { "m" };
    let weight = |i: usize, j: usize| match legs.between(i, j) {
        _ if i == j => "0".to_string(),
        Some((leg, _)) if leg.weight().is_finite() => leg.weight().to_string(),
        _ => String::new(),
    };
    let row = |(i, name): (usize, String)| {
        std::iter::once(name).chain((0..legs.stations.len()).map(|j| weight(i, j))).collect()
    };
    csv_text(std::iter::once(unit.to_string()).chain(names()).collect(), names().enumerate().map(row))
}

/// Checks that lengths can be written under this name, before any work is done.
///
/// # Errors
/// An extension other than .csv.
pub fn check_matrix_name(path: &Path) -> Result<(), Error> {
    if extension(path).as_deref() == Some("csv") { Ok(()) } else { Err(other_extension(path, ".csv")) }
}
