//! Rows in memory, for exchange between processes.
//!
//! A worker on a Python executor receives the experiment as JSON with inline scenes and a range of trials, and returns
//! the lines that a local run would write; concatenated in order, they give the same files.

use std::io::Read;
use std::ops::Range;
use std::path::Path;

use super::batch_folder::BatchFolder;
use super::batch_tables::{RunFile, lines, write_tables};
use super::origin::origin_here;
use crate::run::{RunOptions, parts, run, threads_of};
use crate::{Experiment, SummaryFile};
use cdpr_core::error::Error;

/// The rows of a range of trials, in memory.
///
/// The rows of each group (a method in a scenario) are lines of CSV; concatenating those of consecutive ranges gives
/// the rows of the whole.
///
/// # Example
/// ```
/// use cdpr_study::{BatchRows, RunOptions, experiment_from_text};
/// use cdpr_files::text::Notation;
/// let text = r#"{"version": 1, "trials": 4, "methods": [{"name": "modified RRT"}],
///     "scenarios": [{"name": "hard1", "scene": "../../testdata/scenes/hard1.toml"}]}"#;
/// let experiment = experiment_from_text(text, Notation::Json, None)?;
/// let rows = |trials: std::ops::Range<usize>| {
///     let options = RunOptions { threads: Some(1), interrupted: &|| false, progress: &mut |_| {} };
///     BatchRows::run(&experiment, trials, options)
/// };
/// let parts = [rows(0..3)?.into_groups().concat(), rows(3..4)?.into_groups().concat()];
/// let merged = BatchRows::new(&experiment, 0..4, vec![parts.concat()])?;
/// assert_eq!(merged.tables()?.trials, rows(0..4)?.tables()?.trials);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct BatchRows {
    run: RunFile,
    groups: Vec<Vec<u8>>,
}

/// The results of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Tables {
    /// Contents of `trials.csv`.
    pub trials: Vec<u8>,
    /// Contents of `timings.csv`.
    pub timings: Vec<u8>,
    /// Contents of `history.csv`, if the experiment requests it.
    pub history: Option<Vec<u8>>,
    /// Contents of `summary.json`.
    pub summary: SummaryFile,
}

impl BatchRows {
    /// Runs these trials and keeps their rows in memory. Methods with planners of the caller get none: the caller adds those of
    /// [`external_rows`](crate::external_rows).
    ///
    /// # Errors
    /// The errors of [`run`]; no trials.
    pub fn run(experiment: &Experiment, trials: Range<usize>, options: RunOptions) -> Result<Self, Error> {
        let mut about = RunFile::of(experiment, &trials)?;
        about.ran_on(origin_here(Some(threads_of(&options)?)));
        let mut groups = vec![Vec::new(); about.layout.groups.len()];
        let first = |group: usize| match parts(experiment, group).2.external {
            None => trials.start,
            Some(_) => trials.end,
        };
        let next: Vec<usize> = (0..groups.len()).map(first).collect();
        run(experiment, &next, trials.end, options, &mut |group, rows| {
            groups[group].extend(lines(rows)?);
            Ok(())
        })?;
        Ok(BatchRows { run: about, groups })
    }

    /// Rows that were run elsewhere, by group.
    ///
    /// # Errors
    /// Wrong number of groups, or of rows in one of them; no trials.
    pub fn new(experiment: &Experiment, trials: Range<usize>, groups: Vec<Vec<u8>>) -> Result<Self, Error> {
        let mut run = RunFile::of(experiment, &trials)?;
        run.ran_on(origin_here(None));
        let expected: Vec<usize> = run.layout.groups.iter().map(|g| g.methods.len() * trials.len()).collect();
        let found: Vec<usize> =
            groups.iter().map(|lines| lines.iter().filter(|byte| **byte == b'\n').count()).collect();
        if found != expected {
            return Err(Error::invalid("rows", format!("found {found:?} rows by group, expected {expected:?}")));
        }
        Ok(BatchRows { run, groups })
    }

    /// The lines of each group.
    pub fn into_groups(self) -> Vec<Vec<u8>> {
        self.groups
    }

    /// The tables, the same bytes as in a folder of the run.
    ///
    /// # Errors
    /// Rows of other trials.
    pub fn tables(&self) -> Result<Tables, Error> {
        let (mut trials, mut timings) = (Vec::new(), Vec::new());
        let mut history = self.run.layout.history.then(Vec::new);
        let open = |group: usize| Ok(Box::new(&*self.groups[group]) as Box<dyn Read + '_>);
        let summary = write_tables(&self.run, Path::new("rows"), open, (&mut trials, &mut timings, history.as_mut()))?;
        Ok(Tables { trials, timings, history, summary })
    }

    /// Writes the folder of the run, as the command line does.
    ///
    /// # Errors
    /// A folder that is not empty or cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let path = path.as_ref();
        BatchFolder::with(path, self.run.clone(), false)?.fill(&self.groups)
    }
}
