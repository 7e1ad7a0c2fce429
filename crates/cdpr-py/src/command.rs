//! The command `cdpr`, for the package's console script.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the command with its arguments, the first of which is the name of the program, and returns its exit status. Handles
/// signals from then on, and may end the process.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| cdpr_cli::run(&arguments))
}
