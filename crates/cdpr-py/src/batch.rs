//! Experiments: rows as bytes, so that processes can exchange them.

use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use cdpr_core::watch::Watch;
use cdpr_files::{Loader, text::Notation};
use cdpr_study::BatchRows;
use cdpr_study::{Progress, RunOptions};
use pyo3::prelude::*;

use crate::convert::{serialized, serialized_as_in_files};
use crate::errors::{answered, interruptible};

/// Minimum time between two calls of a progress function, each of which needs the interpreter.
const PERIOD: Duration = Duration::from_millis(50);

/// A checked experiment.
#[pyclass(frozen, module = "cdpr._core")]
pub struct Experiment(cdpr_study::Experiment);

/// Rows of each group, and the reasons of trials that failed.
type Ran = (Vec<Vec<u8>>, Vec<String>);

/// trials.csv, timings.csv, history.csv if the experiment requests it, summary.json.
type Tables = (Vec<u8>, Vec<u8>, Option<Vec<u8>>, String);

#[pymethods]
impl Experiment {
    /// Loads an experiment file.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        interruptible(py, |stop| cdpr_study::Experiment::load(&path, &Loader::new(Watch::on(stop)))).map(Experiment)
    }

    /// An experiment from JSON text; paths of scene files are relative to the working directory.
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        let read = |loader: &Loader| cdpr_study::Experiment::from_text(text, Notation::Json, None, loader);
        interruptible(py, |stop| read(&Loader::new(Watch::on(stop)))).map(Experiment)
    }

    /// The experiment as JSON text, with inline scenes.
    fn to_json(&self) -> String {
        serialized(&self.0.portable)
    }

    /// Name of the experiment.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// Number of trials of each method in each scenario.
    #[getter]
    fn trials(&self) -> usize {
        self.0.trials
    }

    /// Number of pairs of scenario and method.
    #[getter]
    fn groups(&self) -> usize {
        self.0.layout.groups.len()
    }

    /// Runs the trials from `first` up to `end`; `progress` is called with the number of finished trials and the total
    /// number.
    fn run(
        &self,
        py: Python<'_>,
        first: usize,
        end: usize,
        threads: Option<usize>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Ran> {
        let problem: Mutex<Option<PyErr>> = Mutex::new(None);
        let mut failures = Vec::new();
        let rows = interruptible(py, |interrupted| {
            let mut told = Instant::now();
            let mut tell = |Progress { done, total, failure }: Progress| {
                failures.extend(failure);
                if let Some(progress) = &progress
                    && (done == total || told.elapsed() >= PERIOD)
                {
                    told = Instant::now();
                    let answer = Python::attach(|py| progress.call1(py, (done, total)));
                    *problem.lock().unwrap_or_else(PoisonError::into_inner) = answer.err();
                }
            };
            let stop = || interrupted() || problem.lock().unwrap_or_else(PoisonError::into_inner).is_some();
            BatchRows::run(&self.0, first..end, RunOptions { threads, interrupted: &stop, progress: &mut tell })
        });
        match problem.into_inner().unwrap_or_else(PoisonError::into_inner) {
            Some(problem) => Err(problem),
            None => Ok((rows?.into_groups(), failures)),
        }
    }

    /// `trials.csv`, `timings.csv`, `history.csv` if the experiment requests it, and `summary.json`, made from rows.
    fn tables(&self, py: Python<'_>, first: usize, end: usize, rows: Vec<Vec<u8>>) -> PyResult<Tables> {
        let made = py.detach(|| answered(|| BatchRows::new(&self.0, first..end, rows)?.tables()))?;
        Ok((made.trials, made.timings, made.history, serialized_as_in_files(&made.summary)))
    }

    /// Writes the folder of a run.
    fn save(&self, py: Python<'_>, path: PathBuf, first: usize, end: usize, rows: Vec<Vec<u8>>) -> PyResult<()> {
        py.detach(|| answered(|| BatchRows::new(&self.0, first..end, rows)?.save(&path)))
    }
}
