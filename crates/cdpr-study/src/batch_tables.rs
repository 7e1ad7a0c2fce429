//! The tables of a run, made from its rows.

use std::io::{Read, Write};
use std::ops::Range;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::experiment::Group;
use crate::run::{Row, TrialRow};
use crate::{Experiment, Layout, Origin, Rules, Summary, SummaryFile};
use cdpr_core::error::Error;
use cdpr_core::limits::MOST_TRIALS;
use cdpr_core::model::spec::FORMAT_VERSION;
use cdpr_files::csv_cell::cell;

/// The description of a run in its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct RunFile {
    pub version: u32,
    pub experiment: String,
    pub fingerprint: String,
    pub first_trial: usize,
    pub end_trial: usize,
    pub layout: Layout,
    /// How the methods plan; empty in files from before 0.2.
    #[serde(default)]
    pub rules: Vec<Rules>,
    /// The programs and machines that ran the trials, without duplicates; several if the run was resumed or merged.
    #[serde(default)]
    pub origins: Vec<Origin>,
    /// Names of the scenarios whose trials have random scenes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub random: Vec<String>,
}

impl RunFile {
    /// The run of these trials, of which there must be at least one.
    pub fn of(experiment: &Experiment, trials: &Range<usize>) -> Result<Self, Error> {
        if trials.is_empty() {
            let problem = format!("found {} to {}, expected at least one trial", trials.start, trials.end);
            return Err(Error::invalid("trials", problem));
        }
        Ok(RunFile {
            version: FORMAT_VERSION,
            experiment: experiment.name.clone(),
            fingerprint: experiment.fingerprint.clone(),
            first_trial: trials.start,
            end_trial: trials.end,
            layout: experiment.layout.clone(),
            rules: experiment.rules(),
            origins: Vec::new(),
            random: experiment.scenarios.iter().filter(|s| s.random.is_some()).map(|s| s.name.clone()).collect(),
        })
    }

    /// Checks the contents of a file: a valid range of trials, and groups with at least one method.
    pub fn check(&self) -> Result<(), Error> {
        let RunFile { version, first_trial, end_trial, layout, .. } = self;
        if *version != FORMAT_VERSION {
            return Err(Error::invalid("version", format!("found {version}, expected {FORMAT_VERSION}")));
        }
        if !(first_trial < end_trial && *end_trial <= MOST_TRIALS) {
            let problem =
                format!("found {end_trial}, expected more than first_trial, {first_trial}, at most {MOST_TRIALS}");
            return Err(Error::invalid("end_trial", problem));
        }
        layout.check().map_err(|e| e.under("layout"))
    }

    pub fn trials(&self) -> Range<usize> {
        self.first_trial..self.end_trial
    }

    /// Records the program and machine that ran the trials.
    pub fn ran_on(&mut self, origin: Origin) {
        if !self.origins.contains(&origin) {
            self.origins.push(origin);
        }
    }
}

/// Rows as lines of CSV.
pub(super) fn lines(rows: &[Row]) -> Result<Vec<u8>, Error> {
    let problem = |e: csv::Error| Error::invalid("rows", e.to_string());
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row)).map_err(problem)?;
    writer.into_inner().map_err(|e| Error::invalid("rows", e.to_string()))
}

/// Writes the tables of trials, of timings and, if requested, of their history, sorted by the names of scenario and
/// method; returns the summary. `place` is the location of the rows, for messages; `open` reads the rows of a group.
pub(super) fn write_tables<'a>(
    run: &RunFile,
    place: &Path,
    open: impl Fn(usize) -> Result<Box<dyn Read + 'a>, Error>,
    (trials, timings, history): (&mut impl Write, &mut impl Write, Option<&mut impl Write>),
) -> Result<SummaryFile, Error> {
    let groups = run.layout.groups.iter().enumerate();
    let mut order: Vec<(&str, &str, usize, usize)> = groups
        .flat_map(|(g, group)| {
            let variants = group.methods.iter().enumerate();
            variants.map(move |(v, method)| (group.scenario.as_str(), method.as_str(), g, v))
        })
        .collect();
    order.sort_unstable();
    let mut summary = Summary::default();
    let mut trials = Table::new(trials, &trial_columns()?)?;
    let mut timings = Table::new(timings, &TIMING_COLUMNS)?;
    let mut history = history.map(|to| Table::new(to, &HISTORY_COLUMNS)).transpose()?;
    for (scenario, method, group, variant) in order {
        let mut rows = Vec::new();
        let sweep = run.layout.groups[group].sweep.get(variant);
        let planned = sweep.map_or(method, |swept| &swept.of);
        let path = place.join(format!("{group:04}.csv"));
        each_row(run, (group, variant), &path, open(group)?, |row| {
            let (scenario, method, planned) = (cell(scenario), cell(method), cell(planned));
            let trial = row.result.trial;
            trials.write(&TrialRow {
                scenario: scenario.to_string(),
                method: method.to_string(),
                ..row.result.clone()
            })?;
            let seconds = (row.planning_seconds, row.post_seconds, row.compile_seconds);
            timings.write(&(&scenario, &method, trial, seconds))?;
            if let Some(history) = &mut history {
                row.history.iter().try_for_each(|m| history.write(&(&scenario, &planned, trial, m)))?;
            }
            rows.push(row);
            Ok(())
        })?;
        summary.add((scenario, method), sweep, rows.into_iter(), run.layout.confidence);
    }
    trials.finish()?;
    timings.finish()?;
    history.map_or(Ok(()), Table::finish)?;
    let summary = summary.file(&run.layout, &run.experiment, &run.fingerprint);
    let (rules, origins, random) = (run.rules.clone(), run.origins.clone(), run.random.clone());
    Ok(SummaryFile { rules, origins, random, ..summary })
}

/// Reads the rows of one variant of a group, up to the last trial of the run.
fn each_row(
    run: &RunFile,
    (group, variant): (usize, usize),
    path: &Path,
    lines: Box<dyn Read + '_>,
    mut see: impl FnMut(Row) -> Result<(), Error>,
) -> Result<(), Error> {
    let Group { scenario, methods, .. } = &run.layout.groups[group];
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(lines); // old rows are shorter
    let rows = reader.deserialize::<Row>().skip(variant).step_by(methods.len());
    for (trial, row) in run.trials().zip(rows) {
        let row = row.map_err(|e| Error::file(path, e.to_string()))?;
        let found = &row.result;
        if (&found.scenario, &found.method, found.trial) != (scenario, &methods[variant], trial) {
            let problem = format!(
                "found trial {} of {}, {} where trial {trial} of {scenario}, {} is expected; it has been changed",
                found.trial, found.scenario, found.method, methods[variant]
            );
            return Err(Error::file(path, problem));
        }
        see(row)?;
    }
    Ok(())
}

const TIMING_COLUMNS: [&str; 6] =
    ["scenario", "method", "trial", "planning_seconds", "post_seconds", "compile_seconds"];
/// The variants of a swept method share one history, under the name of the method.
const HISTORY_COLUMNS: [&str; 6] = ["scenario", "method", "trial", "seconds", "samples", "cost"];

/// The columns of `trials.csv`: the keys of its rows, as `csv` writes them.
fn trial_columns() -> Result<Vec<String>, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.serialize(TrialRow::default()).map_err(unwritable)?;
    let text = writer.into_inner().map_err(unwritable)?;
    let header = csv::Reader::from_reader(&*text).headers().map_err(unwritable)?.clone();
    Ok(header.iter().map(str::to_string).collect())
}

/// A table that grows row by row.
struct Table<W: Write> {
    writer: csv::Writer<W>,
}

impl<W: Write> Table<W> {
    fn new(to: W, columns: &[impl Serialize]) -> Result<Self, Error> {
        let mut table = Table { writer: csv::WriterBuilder::new().has_headers(false).from_writer(to) };
        table.write(&columns)?;
        Ok(table)
    }

    fn write(&mut self, row: &impl Serialize) -> Result<(), Error> {
        self.writer.serialize(row).map_err(unwritable)
    }

    fn finish(mut self) -> Result<(), Error> {
        self.writer.flush().map_err(unwritable)
    }
}

fn unwritable(problem: impl std::fmt::Display) -> Error {
    Error::invalid("tables", format!("cannot be written: {problem}"))
}
