//! Converts errors of the core to exceptions of `cdpr.exceptions`, and handles Ctrl-C during long calls.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use cdpr_core::error::caught;
use cdpr_core::watch::Interrupt;
use cdpr_core::{Error, ErrorClass};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

use crate::forked::{STACK, with_living_threads};

static INPUT_ERROR: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static FILE_ERROR: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static OUT_OF_TIME: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static INTERNAL_ERROR: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// The exception for an error of the core.
pub fn raised(error: Error) -> PyErr {
    let (class, name) = match error.class() {
        ErrorClass::Input => (&INPUT_ERROR, "InputError"),
        ErrorClass::File => (&FILE_ERROR, "FileError"),
        ErrorClass::OutOfTime => (&OUT_OF_TIME, "CdprError"),
        ErrorClass::Internal => (&INTERNAL_ERROR, "InternalError"),
        ErrorClass::Interrupted => return PyKeyboardInterrupt::new_err(()),
    };
    Python::attach(|py| match class.import(py, "cdpr.exceptions", name) {
        Ok(class) => PyErr::from_type(class.clone(), error.to_string()),
        Err(problem) => problem,
    })
}

/// Time between two checks for signals.
const PERIOD: Duration = Duration::from_millis(20);

/// Runs short work. A panic in it raises an `InternalError`; PyO3 would raise a `PanicException`, which `except
/// Exception` does not catch.
pub fn answered<T>(work: impl FnOnce() -> Result<T, Error>) -> PyResult<T> {
    caught(work).map_err(raised)
}

/// Runs long work with the interpreter released. The work polls its argument, on any thread; on Ctrl-C, or if a signal
/// handler raises, that exception is raised.
pub fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Interrupt) -> Result<T, Error> + Send) -> PyResult<T> {
    match interruptible_with_rest(py, work) {
        (_, Some(signal)) => Err(signal),
        (run, None) => run.map_err(raised),
    }
}

/// The first exception of a Python function that long work calls.
#[derive(Default)]
pub struct Failure(Mutex<Option<PyErr>>);

impl Failure {
    /// Whether there is one; the work should then end.
    pub fn is_set(&self) -> bool {
        self.get().is_some()
    }

    /// Keeps the exception of a call, if it is the first.
    pub fn keep<T>(&self, called: PyResult<T>) {
        let mut failure = self.get();
        *failure = failure.take().or(called.err());
    }

    fn get(&self) -> MutexGuard<'_, Option<PyErr>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Runs long work like [`interruptible`], but after Ctrl-C keeps what the work returns. An exception of a function that the work
/// called, or of another signal handler, is raised.
pub fn kept_on_interrupt<T: Send>(
    py: Python<'_>,
    failure: Failure,
    work: impl FnOnce(&Interrupt, &Failure) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let (run, signal) = interruptible_with_rest(py, |stop| work(stop, &failure));
    match (failure.0.into_inner().unwrap_or_else(PoisonError::into_inner), signal) {
        (Some(error), _) => Err(error),
        (None, Some(signal)) if !(signal.is_instance_of::<PyKeyboardInterrupt>(py) && run.is_ok()) => Err(signal),
        _ => run.map_err(raised),
    }
}

/// Runs long work that owns what it needs, with the interpreter released. On Ctrl-C the call ends at once: the work goes on
/// in its thread until it polls its argument, if it does, and frees what it has there, which may take long.
pub fn abandonable<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&Interrupt) -> Result<T, Error> + Send + 'static,
) -> PyResult<T> {
    py.detach(|| {
        let stop = Arc::new(AtomicBool::new(false));
        let told = Arc::clone(&stop);
        let (send, receive) = mpsc::sync_channel(1);
        let stopped = move || told.load(Ordering::Relaxed);
        let worker = move || drop(send.send(with_living_threads(|| caught(|| work(&stopped)))));
        std::thread::Builder::new().stack_size(STACK).spawn(worker).map_err(|e| raised(no_thread(&e)))?;
        loop {
            match receive.recv_timeout(PERIOD) {
                Ok(run) => return run.map_err(raised),
                Err(RecvTimeoutError::Disconnected) => return Err(raised(no_answer())),
                Err(RecvTimeoutError::Timeout) => {
                    Python::attach(|py| py.check_signals()).inspect_err(|_| stop.store(true, Ordering::Relaxed))?;
                }
            }
        }
    })
}

/// Runs long work that has a result even if it is stopped, with the interpreter released: returns the result and the
/// exception of the signal.
///
/// Python delivers signals to the thread that runs the interpreter. That thread therefore waits and polls for signals,
/// while the work runs on another thread and may use any number of threads itself.
pub fn interruptible_with_rest<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&Interrupt) -> Result<T, Error> + Send,
) -> (Result<T, Error>, Option<PyErr>) {
    py.detach(|| {
        let stop = AtomicBool::new(false);
        let (send, receive) = mpsc::sync_channel(1);
        std::thread::scope(|scope| {
            let stop = &stop;
            let stopped = || stop.load(Ordering::Relaxed);
            let worker = move || drop(send.send(with_living_threads(|| caught(|| work(&stopped)))));
            if let Err(problem) = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, worker) {
                return (Err(no_thread(&problem)), None);
            }
            let mut signal = None;
            loop {
                match receive.recv_timeout(PERIOD) {
                    Ok(run) => return (run, signal),
                    Err(RecvTimeoutError::Disconnected) => return (Err(no_answer()), signal),
                    Err(RecvTimeoutError::Timeout) if signal.is_none() => {
                        signal = Python::attach(|py| py.check_signals()).err();
                        stop.store(signal.is_some(), Ordering::Relaxed);
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                }
            }
        })
    })
}

fn no_thread(problem: &std::io::Error) -> Error {
    Error::internal(format!("no thread can be started: {problem}"))
}

fn no_answer() -> Error {
    Error::internal("the work ended without a result")
}
