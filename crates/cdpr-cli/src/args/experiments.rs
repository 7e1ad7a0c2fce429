//! Arguments of `batch`, `merge` and `report`.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::shared::Format;
use super::values::{Trials, threads, trials};

#[derive(Debug, Args)]
pub struct BatchArgs {
    /// Experiment file (.toml or .json).
    #[arg(value_hint = ValueHint::FilePath)]
    pub experiment: PathBuf,
    /// Folder to write; must be new or empty, unless a run in it is resumed.
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
    /// Continue the run in the folder.
    #[arg(long)]
    pub resume: bool,
    /// Number of threads [default: the number of cores].
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
    /// Number of trials instead of the experiment's, or a range of trials without its end.
    #[arg(long, value_name = "N|A..B", value_parser = trials)]
    pub trials: Option<Trials>,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct MergeArgs {
    /// Folders of complete runs, in any order.
    #[arg(required = true, value_hint = ValueHint::DirPath)]
    pub folders: Vec<PathBuf>,
    /// Folder to write; must be new or empty.
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct ReportArgs {
    /// Folder of a run.
    #[arg(value_hint = ValueHint::DirPath)]
    pub folder: PathBuf,
    /// Page to write [default: report.html in the folder].
    #[arg(short, long, value_name = "REPORT.html", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}
