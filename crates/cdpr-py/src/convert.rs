//! Conversions: rows of C-contiguous (n, 3) arrays as points, without copying the array; numbers as such arrays; names
//! and results.

use cdpr_core::batch::BatchOptions;
use cdpr_core::geometry::Point;
use cdpr_core::watch::Watch;
use cdpr_core::{Choice, Error};
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::errors::{answered, interruptible};

/// The k-th row as a point.
#[inline]
pub fn row(rows: &[f64], k: usize) -> Point {
    Point::from_slice(&rows[3 * k..3 * k + 3])
}

/// All rows as points.
pub fn points(rows: &[f64]) -> Vec<Point> {
    rows.chunks_exact(3).map(Point::from_slice).collect()
}

/// Three numbers as a point.
pub fn point(numbers: [f64; 3]) -> Point {
    Point::from(numbers)
}

/// Numbers as an (n, 3) array.
pub fn triples<'py, T: numpy::Element>(py: Python<'py>, numbers: Vec<T>) -> PyResult<Bound<'py, PyArray2<T>>> {
    let rows = numbers.len() / 3;
    PyArray1::from_vec(py, numbers).reshape([rows, 3])
}

/// A choice from its name.
pub fn named<T: Choice>(name: &str) -> PyResult<T> {
    answered(|| T::named(name))
}

/// A result as JSON text.
pub fn serialized(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("answers are finite")
}

/// A result as JSON text with its keys in the order of files, which is that of Python's dictionaries.
pub fn serialized_as_in_files(value: &impl serde::Serialize) -> String {
    serde_json::json!(value).to_string()
}

pub use cdpr_core::geometry::wxyz as quaternion;

/// The answers to a number of questions as an array; `answer` fills them in with the interpreter released.
pub fn answer_array<T: Element + Clone + Default + Send>(
    py: Python<'_>,
    count: usize,
    threads: Option<usize>,
    answer: impl FnOnce(&mut [T], &BatchOptions) -> Result<(), Error> + Send,
) -> PyResult<Bound<'_, PyArray1<T>>> {
    let mut answers = vec![T::default(); count];
    interruptible(py, |interrupted| answer(&mut answers, &BatchOptions { threads, watch: Watch::on(interrupted) }))?;
    Ok(PyArray1::from_vec(py, answers))
}
