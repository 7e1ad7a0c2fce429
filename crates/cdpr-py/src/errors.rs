//! Errors of the core as exceptions of `cdpr.exceptions`, and Ctrl-C during long calls.

use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

use cdpr_core::{Error, ErrorClass};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

static INPUT_ERROR: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static FILE_ERROR: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// The exception for an error of the core.
pub fn raised(error: Error) -> PyErr {
    let (class, name) = match error.class() {
        ErrorClass::Input => (&INPUT_ERROR, "InputError"),
        ErrorClass::File => (&FILE_ERROR, "FileError"),
        ErrorClass::Interrupted => return PyKeyboardInterrupt::new_err(()),
    };
    Python::attach(|py| match class.import(py, "cdpr.exceptions", name) {
        Ok(class) => PyErr::from_type(class.clone(), error.to_string()),
        Err(problem) => problem,
    })
}

/// Time between two looks at whether a signal has come.
const PERIOD: Duration = Duration::from_millis(20);

/// Runs long work with the interpreter released. The work asks now and then whether to stop; Ctrl-C, or whatever a
/// signal handler raises, then comes out as its exception.
pub fn interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Fn() -> bool) -> Result<T, Error> + Send,
) -> PyResult<T> {
    match interruptible_with_rest(py, work) {
        (_, Some(signal)) => Err(signal),
        (run, None) => run.map_err(raised),
    }
}

/// As [`interruptible`], for work that has an answer even if it is stopped: the answer beside the signal.
pub fn interruptible_with_rest<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Fn() -> bool) -> Result<T, Error> + Send,
) -> (Result<T, Error>, Option<PyErr>) {
    py.detach(|| {
        let asked_at = Cell::new(Instant::now());
        let signal = RefCell::new(None);
        let interrupted = || {
            if asked_at.get().elapsed() >= PERIOD {
                asked_at.set(Instant::now());
                *signal.borrow_mut() = Python::attach(|py| py.check_signals()).err();
            }
            signal.borrow().is_some()
        };
        let run = work(&interrupted);
        (run, signal.into_inner())
    })
}
