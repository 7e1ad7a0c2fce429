//! The folder of a run: rows as they are computed, and the tables made from them.
//!
//! `rows/` holds one file per method and scenario, to which each trial appends its lines in one write. A run that was
//! killed leaves at most one incomplete trial at the end of each file; resuming truncates it. If a run was killed
//! before it wrote `run.json`, it has not begun, and its folder counts as empty. `trials.csv`, `timings.csv`,
//! `history.csv` (if the experiment requests it) and `summary.json` are written as a whole when a run ends or is
//! interrupted.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, BufWriter, ErrorKind, Read, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::batch_tables::{RunFile, lines, write_tables};
use super::origin::origin_here;
use crate::Experiment;
use crate::run::{Row, RunOptions, run, threads_of};
use cdpr_core::error::Error;
use cdpr_files::output::{Output, is_temporary, write_atomically};
use cdpr_files::text;

/// The file that identifies the run of a folder.
const RUN_FILE: &str = "run.json";
/// The folder of the rows.
const ROWS: &str = "rows";
/// The lock file in the folder of rows, which a working process keeps locked.
const LOCK: &str = "lock";

/// The folder of a run.
#[derive(Debug)]
pub struct BatchFolder {
    path: PathBuf,
    run: RunFile,
    /// Number of trials of each group whose rows are complete.
    done: Vec<usize>,
    /// Locked during the lifetime of this value; the system unlocks it however the process ends.
    _lock: File,
}

impl BatchFolder {
    /// Creates the folder of a run of these trials, or continues an existing run with `resume`.
    ///
    /// # Errors
    /// Without `resume`, a folder that is not empty; with `resume`, a folder without a run, or with a run of another
    /// experiment or another first trial; a folder that cannot be written; no trials; a planner that is a function of the caller.
    pub fn open(
        path: impl AsRef<Path>,
        experiment: &Experiment,
        trials: Range<usize>,
        resume: bool,
    ) -> Result<Self, Error> {
        let path = path.as_ref();
        experiment.all_built_in()?;
        BatchFolder::with(path, RunFile::of(experiment, &trials)?, resume)
    }

    pub(super) fn with(path: &Path, mut run: RunFile, resume: bool) -> Result<Self, Error> {
        fs::create_dir_all(path).map_err(|e| Error::system(path, "cannot be created", e))?;
        match (!as_good_as_new(path)?, resume) {
            (true, false) => {
                return Err(Error::file(
                    path,
                    "found a folder that is not empty, expected a new or empty one, unless a run in it is resumed",
                ));
            }
            (true, true) => run.origins = same_run(path, &run)?.origins,
            (false, _) => {}
        }
        let rows = path.join(ROWS);
        fs::create_dir_all(&rows).map_err(|e| Error::system(&rows, "cannot be created", e))?;
        let lock = locked(path, &rows.join(LOCK))?;
        let mut folder = BatchFolder { path: path.to_path_buf(), run, done: Vec::new(), _lock: lock };
        folder.write_run_file()?;
        folder.done = (0..folder.run.layout.groups.len()).map(|g| folder.recover(g)).collect::<Result<_, _>>()?;
        Ok(folder)
    }

    fn write_run_file(&self) -> Result<(), Error> {
        let json = serde_json::to_string_pretty(&self.run).expect("names and numbers");
        write_atomically(self.path.join(RUN_FILE), format!("{json}\n").as_bytes())
    }

    /// Runs the missing trials, then writes the tables; if interrupted, the tables of the rows so far.
    ///
    /// # Errors
    /// The errors of [`run`], and files that cannot be written.
    pub fn run(&mut self, experiment: &Experiment, options: RunOptions) -> Result<(), Error> {
        if self.done() < self.run.trials().len() * self.run.layout.groups.len() {
            self.run.ran_on(origin_here(Some(threads_of(&options)?)));
            self.write_run_file()?;
        }
        let next: Vec<usize> = self.done.iter().map(|done| self.run.first_trial + done).collect();
        let (rows, done) = (self.path.join(ROWS), &mut self.done);
        let ended = run(experiment, &next, self.run.end_trial, options, &mut |group, lines| {
            append(&rows.join(file_name(group)), lines)?;
            done[group] += 1;
            Ok(())
        });
        match ended {
            Err(error) if error.class() != cdpr_core::ErrorClass::Interrupted => Err(error),
            ended => self.write_tables().and(ended),
        }
    }

    /// Number of trials whose rows are complete, over all methods and scenarios.
    pub fn done(&self) -> usize {
        self.done.iter().sum()
    }

    /// Truncates an incomplete trial at the end of a group's rows; returns the number of complete ones.
    fn recover(&self, group: usize) -> Result<usize, Error> {
        let path = self.path.join(ROWS).join(file_name(group));
        let problem = |e: std::io::Error| Error::system(&path, "cannot be read", e);
        if !path.exists() {
            return Ok(0); // no trial is done yet
        }
        let file = text::open_table(&path)?;
        let variants = self.run.layout.groups[group].methods.len();
        let (mut reader, mut line) = (BufReader::new(file), Vec::new());
        let (mut lines, mut at, mut complete) = (0, 0, 0);
        loop {
            line.clear();
            at += reader.read_until(b'\n', &mut line).map_err(problem)? as u64;
            if line.last() != Some(&b'\n') {
                break;
            }
            lines += 1;
            if lines % variants == 0 {
                complete = at;
            }
        }
        let file = OpenOptions::new().write(true).open(&path).map_err(problem)?;
        file.set_len(complete).map_err(|e| Error::system(&path, "cannot be written", e))?;
        Ok(lines / variants)
    }

    /// Writes the rows of all groups, which are complete, and the tables.
    pub(super) fn fill(&mut self, groups: &[Vec<u8>]) -> Result<(), Error> {
        for (group, lines) in groups.iter().enumerate() {
            write_at_end(&self.path.join(ROWS).join(file_name(group)), lines)?;
            self.done[group] = self.run.trials().len();
        }
        self.write_tables()
    }

    /// Writes `trials.csv`, `timings.csv`, `history.csv` if requested, and `summary.json`, sorted by the names of
    /// scenario and method.
    fn write_tables(&self) -> Result<(), Error> {
        let open = |group: usize| -> Result<Box<dyn Read>, Error> {
            let path = self.path.join(ROWS).join(file_name(group));
            match path.exists() {
                true => Ok(Box::new(BufReader::new(text::open_table(&path)?))),
                false => Ok(Box::new(std::io::empty())), // no trial is done yet
            }
        };
        let [trials, timings, history] = ["trials.csv", "timings.csv", "history.csv"].map(|name| self.path.join(name));
        let (mut trials_file, mut timings_file) = (Output::begin(&trials)?, Output::begin(&timings)?);
        let mut history_file = self.run.layout.history.then(|| Output::begin(&history)).transpose()?;
        let files = (&mut trials_file, &mut timings_file, history_file.as_mut());
        let summary = write_tables(&self.run, &self.path.join(ROWS), open, files)?;
        trials_file.finish()?;
        timings_file.finish()?;
        history_file.map_or(Ok(()), Output::finish)?;
        write_atomically(self.path.join("summary.json"), format!("{:#}\n", serde_json::json!(summary)).as_bytes())
    }
}

/// Merges runs of ranges of trials: complete runs of one experiment whose ranges follow each other without a gap.
///
/// # Errors
/// A folder that does not fit (the error names it and the reason); an output folder that is not empty.
pub fn merge(folders: &[PathBuf], output: impl AsRef<Path>) -> Result<(), Error> {
    let output = output.as_ref();
    let mut runs = folders.iter().map(|path| Ok((run_file(path)?, path))).collect::<Result<Vec<_>, Error>>()?;
    runs.sort_by_key(|(run, _)| run.first_trial);
    let Some((first, _)) = runs.first().cloned() else {
        return Err(Error::invalid("folders", "found none, expected at least one"));
    };
    let mut end = first.first_trial;
    let mut parts = Vec::new();
    for (run, path) in &runs {
        if run.fingerprint != first.fingerprint || run.layout.groups != first.layout.groups {
            let problem = format!("found a run of another experiment ({}, not {})", run.fingerprint, first.fingerprint);
            return Err(Error::file(path, problem));
        }
        if run.first_trial != end {
            let problem = format!("found trials from {}, expected trials from {end} on", run.first_trial);
            return Err(Error::file(path, problem));
        }
        end = run.end_trial;
        parts.push(BatchFolder::with(path, run.clone(), true)?);
        let wanted = (run.end_trial - run.first_trial) * run.layout.groups.len();
        let done = parts.last().map_or(0, BatchFolder::done);
        if done < wanted {
            let problem = format!("found {done} of {wanted} trials, expected a complete run; resume it first");
            return Err(Error::file(path, problem));
        }
    }
    let mut whole = RunFile { end_trial: end, ..first };
    runs.into_iter().flat_map(|(run, _)| run.origins).for_each(|origin| whole.ran_on(origin));
    let mut whole = BatchFolder::with(output, whole, false)?;
    for group in 0..whole.run.layout.groups.len() {
        let target = output.join(ROWS).join(file_name(group));
        for part in &parts {
            let methods = part.run.layout.groups[group].methods.len();
            let lines = (part.run.end_trial - part.run.first_trial) * methods;
            copy_lines(&part.path.join(ROWS).join(file_name(group)), &target, lines)?;
        }
        whole.done[group] = end - whole.run.first_trial;
    }
    whole.write_tables()
}

fn copy_lines(from: &Path, to: &Path, count: usize) -> Result<(), Error> {
    let unreadable = |e: std::io::Error| Error::system(from, "cannot be read", e);
    let unwritable = |e: std::io::Error| Error::system(to, "cannot be written", e);
    let mut reader = BufReader::new(text::open_table(from)?);
    let mut writer = BufWriter::new(OpenOptions::new().append(true).create(true).open(to).map_err(unwritable)?);
    let mut line = Vec::new();
    for _ in 0..count {
        line.clear();
        reader.read_until(b'\n', &mut line).map_err(unreadable)?;
        writer.write_all(&line).map_err(unwritable)?;
    }
    writer.flush().map_err(unwritable)
}

fn run_file(folder: &Path) -> Result<RunFile, Error> {
    let path = folder.join(RUN_FILE);
    if !path.is_file() {
        return Err(Error::file(folder, format!("found no {RUN_FILE}, expected the folder of a run")));
    }
    let run: RunFile = text::parse(&text::read(&path)?, text::Notation::Json).map_err(|e| e.in_file(&path))?;
    run.check().map_err(|e| e.in_file(&path))?;
    Ok(run)
}

/// Whether a folder contains at most what a run that was killed before it began may have left: an empty folder of rows,
/// and unfinished files.
fn as_good_as_new(path: &Path) -> Result<bool, Error> {
    let rows = path.join(ROWS);
    let left = |name: &OsStr| (name == ROWS && rows.is_dir()) || is_temporary(name);
    Ok(holds_only(path, left)? && (!rows.is_dir() || holds_only(&rows, |name| name == LOCK)?))
}

fn holds_only(folder: &Path, known: impl Fn(&OsStr) -> bool) -> Result<bool, Error> {
    let names =
        fs::read_dir(folder).and_then(|entries| entries.map(|e| Ok(e?.file_name())).collect::<Result<Vec<_>, _>>());
    let names = names.map_err(|e| Error::system(folder, "cannot be read", e))?;
    Ok(names.iter().all(|name| known(name)))
}

/// The existing run, if it is the wanted one; an error otherwise.
fn same_run(path: &Path, wanted: &RunFile) -> Result<RunFile, Error> {
    let found = run_file(path)?;
    if found.fingerprint != wanted.fingerprint || found.layout.groups != wanted.layout.groups {
        let problem = format!(
            "found a run of another experiment (\"{}\", {}), expected one of \"{}\" ({}); was it changed since?",
            found.experiment, found.fingerprint, wanted.experiment, wanted.fingerprint
        );
        return Err(Error::file(path, problem));
    }
    if found.first_trial != wanted.first_trial {
        let problem = format!("found a run from trial {}, expected one from {}", found.first_trial, wanted.first_trial);
        return Err(Error::file(path, problem));
    }
    Ok(found)
}

/// Keeps other processes out: two processes that append to the same rows would corrupt them.
fn locked(folder: &Path, path: &Path) -> Result<File, Error> {
    let unwritable = |e: std::io::Error| Error::system(path, "cannot be written", e);
    let file = OpenOptions::new().write(true).create(true).truncate(false).open(path).map_err(unwritable)?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(Error::file(
            folder,
            "found another process working in this folder, expected none; wait until it has ended",
        )),
        Err(TryLockError::Error(e)) if e.kind() == ErrorKind::Unsupported => Ok(file), // some network drives have no locks
        Err(TryLockError::Error(e)) => Err(unwritable(e)),
    }
}

fn file_name(group: usize) -> String {
    format!("{group:04}.csv")
}

/// Appends the lines of a trial in one write.
fn append(path: &Path, rows: &[Row]) -> Result<(), Error> {
    write_at_end(path, &lines(rows).map_err(|e| e.in_file(path))?)
}

fn write_at_end(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let opened = OpenOptions::new().append(true).create(true).open(path);
    let written = opened.and_then(|mut file| file.write_all(bytes));
    written.map_err(|e| Error::system(path, "cannot be written", e))
}
