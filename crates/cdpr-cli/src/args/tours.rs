//! Arguments of `tour` and `task`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use cdpr_core::plan::PlanOptions;
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings};
use cdpr_core::task::TaskTiming;
use cdpr_core::tour::{By, Order, TourOptions};
use cdpr_core::{Choice, Error};
use cdpr_files::WholeFile;
use clap::{Args, ValueHint};

use super::given_options::GivenOptions;
use super::motion::{LimitArgs, TimingArgs};
use super::shared::{CheckerArgs, SceneArgs, TensionArgs};
use super::values::{budget, choice, positive, threads};
use crate::target::check_message;

/// How each leg is planned.
#[derive(Debug, Clone, Copy, Args)]
pub struct SearchArgs {
    /// Search on each leg until the path is proved to be at most this fraction longer than the shortest: 0.01 for 1 %.
    /// Where wrenches or clearances bind, that may never be; --budget-ms ends it.
    #[arg(long, value_name = "SHARE", value_parser = positive, allow_negative_numbers = true)]
    pub gap: Option<f64>,
    /// Time limit of each leg, ms.
    #[arg(long, value_name = "T", value_parser = budget, allow_negative_numbers = true)]
    pub budget_ms: Option<Duration>,
    /// Seed of all random numbers.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Number of threads [default: the number of cores].
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
    #[command(flatten)]
    pub checker: CheckerArgs,
}

impl SearchArgs {
    pub fn options(&self, given: &GivenOptions) -> Result<PlanOptions, Error> {
        let settings = PlannerSettings { gap: self.gap, ..PlannerSettings::default() };
        let usual = PlanOptions::default();
        Ok(PlanOptions {
            planner: PlannerOptions::new(Planner::Anytime, usual.step, &settings).map_err(|e| given.named(e).0)?,
            engine: self.checker.engine,
            interference: self.checker.interference,
            seed: self.seed,
            budget: self.budget_ms,
            ..usual
        })
    }
}

#[derive(Debug, Args)]
pub struct TaskArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub search: SearchArgs,
    /// Write the legs into this folder: task.json, and the path of each leg, leg-1.json and so on.
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
    /// Also write a page of each leg that has a path: leg-1.html and so on.
    #[arg(long)]
    pub html: bool,
    /// Also time the legs, as `trajectory` does, each in the scene that holds then. Their motions, leg-1-motion.json and so on, are
    /// written into the folder, and the one through all of them under this name (.json, .csv or .yaml).
    #[arg(long, value_name = "NAME")]
    pub trajectory: Option<String>,
    #[command(flatten)]
    pub timing: TimingArgs,
    #[command(flatten)]
    pub tensions: TensionArgs,
}

impl TaskArgs {
    /// The file of the motion through all legs.
    pub fn whole(&self) -> Result<WholeFile<'_>, Error> {
        let fields = self.timing.fields();
        check_message(self.trajectory.as_deref().map(Path::new), fields)?;
        let Some(name) = &self.trajectory else { return Ok(WholeFile::default()) };
        let whole = WholeFile { name, fields };
        whole.check().map(|()| whole)
    }

    /// How the legs are timed, if they are.
    pub fn task_timing(&self) -> Option<TaskTiming> {
        let timing = TaskTiming { limits: self.timing.limits.spec(), rate: self.timing.rate };
        self.trajectory.as_ref().map(|_| timing)
    }
}

#[derive(Debug, Args)]
pub struct TourArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Names of the stations to visit [default: all of the scene's].
    #[arg(long, value_name = "A,B,...", value_delimiter = ',')]
    pub stations: Vec<String>,
    /// Name of the station where the tour starts [default: the best one; with --order given, the first].
    #[arg(long, value_name = "STATION")]
    pub start: Option<String>,
    /// Return to the start at the end.
    #[arg(long = "return")]
    pub returns: bool,
    /// Order of the stations.
    #[arg(long, value_parser = choice::<Order>(), default_value = Order::default().name())]
    pub order: Order,
    /// What tours are compared by.
    #[arg(long, value_parser = choice::<By>(), default_value = By::default().name())]
    pub by: By,
    #[command(flatten)]
    pub limits: LimitArgs,
    #[command(flatten)]
    pub search: SearchArgs,
    /// Write the path through all stations here (.json, with the tour, or .csv).
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Write the lengths between all stations here, or with --by time the durations (.csv).
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub matrix: Option<PathBuf>,
    /// Write a page of the tour here (.html).
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub html: Option<PathBuf>,
}

impl TourArgs {
    pub fn tour(&self) -> TourOptions {
        TourOptions {
            stations: self.given.has("--stations").then(|| self.stations.clone()),
            start: self.start.clone(),
            returns: self.returns,
            order: self.order,
            by: self.by,
            limits: self.limits.spec(),
            threads: self.search.threads,
        }
    }
}
