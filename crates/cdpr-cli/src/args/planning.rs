//! Arguments of `plan` and `post`.

use std::path::PathBuf;
use std::time::Duration;

use cdpr_core::model::OrientationSource;
use cdpr_core::plan::{Maximise, PlanOptions, Post, Processing, Query};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings};
use cdpr_core::trajectory::Minimise;
use cdpr_core::{Choice, Error, Scene};
use clap::{Args, ValueHint};

use super::given_options::GivenOptions;
use super::motion::TimingArgs;
use super::route::RouteArgs;
use super::shared::{CheckerArgs, PathArgs, SceneArgs, TensionArgs};
use super::values::{POSITION, budget, choice, orientation, positive, ratio, something};

#[derive(Debug, Clone, Args)]
pub struct PlanArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Search method.
    #[arg(long, value_parser = choice::<Planner>(), default_value = Planner::default().name())]
    pub planner: Planner,
    #[command(flatten)]
    pub settings: PlannerArgs,
    /// Stop this long after all files are read, ms; includes the time to compile the scene (the search may end earlier).
    #[arg(long, value_name = "T", value_parser = budget, allow_negative_numbers = true)]
    pub budget_ms: Option<Duration>,
    #[command(flatten)]
    pub checker: CheckerArgs,
    /// Seed of all random numbers.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    #[command(flatten)]
    pub rewinding: RewindArgs,
    /// Post-processing of the planner's path [default: none for anytime, taut for two-trees and rrt-connect, both for
    /// the others].
    #[arg(long, value_parser = choice::<Post>())]
    pub post: Option<Post>,
    /// Find the widest path instead of a short one, and prove how wide paths can be; it is shortened as far as it stays as wide.
    #[arg(long, value_parser = choice::<Maximise>(), conflicts_with_all = ["no_proof", "minimise", "via", "goal_box"])]
    pub maximise: Option<Maximise>,
    /// With --maximise, the path may be at most this many times as long as the shortest: 1.05 for 5 % longer.
    #[arg(long, value_name = "RATIO", value_parser = ratio, allow_negative_numbers = true, requires = "maximise")]
    pub within: Option<f64>,
    /// Start instead of the scene's: the name of a station, or a position, m.
    #[arg(long, num_args = 1..=3, value_name = POSITION, allow_negative_numbers = true)]
    pub start: Option<Vec<String>>,
    /// Start at the pose with these cable lengths: CSV as for `cdpr pose`, with one row. If the platform may turn on its way, the
    /// orientation at the start follows from the lengths; if the scene leaves the orientation open, the one that fits is used.
    #[arg(long, value_name = "LENGTHS", value_hint = ValueHint::FilePath, conflicts_with = "start")]
    pub start_lengths: Option<PathBuf>,
    #[command(flatten)]
    pub route: RouteArgs,
    /// Plan between the ends of this path of an earlier scene, and keep what is still valid of it; the other options are for what
    /// is not.
    #[arg(long, value_name = "PATH", value_hint = ValueHint::FilePath, conflicts_with_all = ["start", "start_lengths", "goal",           "goal_box", "via", "start_orientation", "goal_orientation", "maximise"])]
    pub replan: Option<PathBuf>,
    /// Orientation at the start instead of the scene's, for a platform that turns on its way.
    #[arg(long, value_name = "NAME|W,X,Y,Z", value_parser = orientation, allow_hyphen_values = true)]
    pub start_orientation: Option<OrientationSource>,
    /// Orientation at the goal instead of the scene's, for a platform that turns on its way.
    #[arg(long, value_name = "NAME|W,X,Y,Z", value_parser = orientation, allow_hyphen_values = true)]
    pub goal_orientation: Option<OrientationSource>,
    /// Only search: do not decide, beside the search, if there is a path at all.
    #[arg(long, conflicts_with = "proof")]
    pub no_proof: bool,
    /// Write the proof of the answer here (.json): that there is no path, that none is shorter than the printed bound or, with
    /// --maximise, that none is wider; `cdpr check` checks it.
    #[arg(long, value_name = "PROOF", value_hint = ValueHint::FilePath)]
    pub proof: Option<PathBuf>,
    /// Write the result here (.json, or .csv for the waypoints alone, with their orientations if the platform turns).
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Write a page that shows the result here.
    #[arg(long, value_name = "VIEW.html", value_hint = ValueHint::FilePath)]
    pub html: Option<PathBuf>,
    /// Write a page that only shows the result: no editing and planning in it, 1 MB smaller.
    #[arg(long = "static", requires = "html")]
    pub is_static: bool,
    /// Also time the path, as `trajectory` does, and write the trajectory here (.json, .csv or .yaml).
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub trajectory: Option<PathBuf>,
    /// With --trajectory, what to minimise; for `time`, each path has the time of --budget-ms.
    #[arg(long, value_parser = choice::<Minimise>(), default_value = Minimise::default().name())]
    pub minimise: Minimise,
    #[command(flatten)]
    pub timing: TimingArgs,
    #[command(flatten)]
    pub tensions: TensionArgs,
}

/// Options of the planner; options that the selected planner does not have are errors.
#[derive(Debug, Clone, Copy, Args)]
pub struct PlannerArgs {
    /// Stop after this many random samples [default: 20000; rrt-star and rrt-connect: 500000; anytime: no limit].
    #[arg(long, value_name = "N")]
    pub max_samples: Option<usize>,
    /// Stop after this many nodes.
    #[arg(long, value_name = "N")]
    pub max_nodes: Option<usize>,
    /// Continue after the first path until samples, nodes or time run out; the shortest path is kept.
    #[arg(long)]
    pub keep_going: bool,
    /// Continue after the first path until the path is at most this long, m.
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub target_cost: Option<f64>,
    /// With anytime, continue until the path is proved to be at most this fraction longer than the shortest: 0.01 for 1
    /// %.
    #[arg(long, value_name = "SHARE", value_parser = positive, allow_negative_numbers = true)]
    pub gap: Option<f64>,
    /// Longest edge that rrt, rrt-star and rrt-connect add, m [default: --step, as in the paper; rrt-connect: a fifth
    /// of the diagonal of the box of positions].
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub extend_step: Option<f64>,
    /// Probability with which rrt, rrt-star and modified-rrt use the goal as the sample [default: 0; modified-rrt: the
    /// goal is tried after every change of the tree].
    #[arg(long, value_name = "P", allow_negative_numbers = true)]
    pub goal_bias: Option<f64>,
    /// With rrt, use the goal as the next sample after every change of the tree, as modified-rrt does.
    #[arg(long)]
    pub check_goal: bool,
    /// Radius of rrt-star's neighbourhood around a new node, m [default: shrinks with the number of nodes].
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub near_radius: Option<f64>,
    /// Largest radius of rrt-star's neighbourhood if it shrinks with the number of nodes, m [default: --extend-step].
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub near_cap: Option<f64>,
}

impl PlannerArgs {
    fn settings(self) -> PlannerSettings {
        PlannerSettings {
            max_samples: self.max_samples,
            max_nodes: self.max_nodes,
            keep_going: self.keep_going,
            target_cost: self.target_cost,
            gap: self.gap,
            extend_step: self.extend_step,
            goal_bias: self.goal_bias,
            check_goal: self.check_goal,
            near_radius: self.near_radius,
            near_cap: self.near_cap,
        }
    }
}

/// Options of rewinding.
#[derive(Debug, Clone, Copy, Args)]
pub struct RewindArgs {
    /// Distance between the points that rewinding tries, m; also the step of rrt and rrt-star.
    #[arg(long, value_name = "M", default_value_t = PlanOptions::default().step, value_parser = positive, allow_negative_numbers = true)]
    pub step: f64,
    /// Number of times that rewinding runs.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub repeats: usize,
}

#[derive(Debug, Args)]
pub struct PostArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub path: PathArgs,
    #[command(flatten)]
    pub rewinding: RewindArgs,
    /// How the path is shortened; if the platform turns on it, positions and orientations are always shortened
    /// together.
    #[arg(long, value_parser = something(), default_value = Post::Both.name())]
    pub post: Post,
    /// Write the path here (.json or .csv).
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

impl PlanArgs {
    pub fn options(&self) -> Result<PlanOptions, Error> {
        Ok(PlanOptions {
            planner: PlannerOptions::new(self.planner, self.rewinding.step, &self.settings.settings())
                .map_err(|e| self.given.named(e).0)?,
            engine: self.checker.engine,
            interference: self.checker.interference,
            seed: self.seed,
            step: self.rewinding.step,
            post: self.post,
            repeats: self.rewinding.repeats,
            proof: !self.no_proof,
            budget: self.budget_ms,
        })
    }
}

impl PlanArgs {
    /// The planning query for a scene with the start and goal of these arguments.
    pub fn query<'a>(&self, scene: &'a Scene) -> Result<Query<'a>, Error> {
        let turned = |option: &str, given: &Option<OrientationSource>| {
            given.as_ref().map(|source| scene.named_orientation(option, source)).transpose()
        };
        let orientations = [
            turned("--start-orientation", &self.start_orientation)?,
            turned("--goal-orientation", &self.goal_orientation)?,
        ];
        Ok(Query::of(scene).oriented(orientations))
    }
}

impl PostArgs {
    pub fn options(&self) -> Result<Processing, Error> {
        self.post.processing(self.rewinding.step, self.rewinding.repeats)
    }
}
