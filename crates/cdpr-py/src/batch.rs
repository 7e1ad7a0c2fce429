//! Experiments: rows as bytes, so that processes can exchange them.

use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use cdpr_core::Choice;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::planning::Milestone;
use cdpr_core::watch::Watch;
use cdpr_files::{Loader, text::Notation};
use cdpr_study::{
    Answered, BatchRows, Progress, RunOptions, TrialStatus, external_rows, foregone, trial_scene, trial_seed,
};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use crate::convert::{points, serialized, serialized_as_in_files};
use crate::errors::{answered, interruptible};
use crate::planning::PERIOD;
use crate::scene::Scene;

/// A checked experiment.
#[pyclass(frozen, module = "cdpr._core")]
pub struct Experiment(cdpr_study::Experiment);

/// Rows of each group, and the reasons of trials that failed.
type Ran = (Vec<Vec<u8>>, Vec<String>);

/// trials.csv, timings.csv, history.csv if the experiment requests it, summary.json.
type Tables = (Vec<u8>, Vec<u8>, Option<Vec<u8>>, String);

impl Experiment {
    /// How the motions of a method are checked.
    fn kind(&self, group: usize) -> (Engine, Interference) {
        let options = &self.0.methods[group % self.0.methods.len()].options;
        (options.engine, options.interference)
    }
}

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

    /// Names of the scenarios, and whether their trials have the same scene.
    #[getter]
    fn scenarios(&self) -> Vec<(&str, bool)> {
        self.0.scenarios.iter().map(|scenario| (scenario.name.as_str(), scenario.random.is_none())).collect()
    }

    /// Names of the methods, and whether their planner is a function.
    #[getter]
    fn methods(&self) -> Vec<(&str, bool)> {
        self.0.methods.iter().map(|method| (method.name.as_str(), method.external.is_some())).collect()
    }

    /// The scene of a trial in the scenario with this number.
    fn scene(&self, py: Python<'_>, scenario: usize, trial: usize) -> PyResult<Scene> {
        interruptible(py, |stop| trial_scene(&self.0, scenario, trial, &Watch::on(stop))).map(Scene::of)
    }

    /// The seed of a trial.
    fn seed(&self, group: usize, trial: usize) -> u64 {
        trial_seed(&self.0, group, trial)
    }

    /// Compiles the scene of a trial; the status if its planner need not run.
    fn foregone(&self, py: Python<'_>, group: usize, scene: &Scene) -> PyResult<Option<&'static str>> {
        let compiled = scene.compiled_for(py, self.kind(group))?;
        let found = interruptible(py, |stop| foregone(&self.0, group, &compiled, &Watch::on(stop)))?;
        Ok(found.map(|status| status.name()))
    }

    /// The rows of a trial whose planner is a function, as lines, and why its path is not valid, if it is not.
    #[allow(clippy::too_many_arguments)] // one per fact about the trial
    fn external_rows(
        &self,
        py: Python<'_>,
        unit: (usize, usize),
        scene: &Scene,
        status: &str,
        path: PyReadonlyArray2<'_, f64>,
        seconds: Option<f64>,
        history: Vec<(f64, usize, f64)>,
    ) -> PyResult<(Vec<u8>, Option<String>)> {
        let compiled = scene.compiled_for(py, self.kind(unit.0))?;
        let history =
            history.into_iter().map(|(seconds, samples, cost)| Milestone { seconds, samples, cost }).collect();
        let status = answered(|| TrialStatus::named(status))?;
        let answered = Answered { status, path: points(path.as_slice()?), seconds, history };
        interruptible(py, |stop| external_rows(&self.0, unit, &compiled, &answered, &Watch::on(stop)))
    }

    /// Runs the trials from `first` up to `end` of the methods whose planners are not functions; `progress` is called with the
    /// number of finished trials and the total number.
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
