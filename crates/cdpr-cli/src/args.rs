//! The command line: names, defaults and help.

use std::path::{Path, PathBuf};
use std::time::Duration;

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::geometry::Point;
use cdpr_core::io::scene_file::Format as FileFormat;
use cdpr_core::model::{OrientationSource, Unit};
use cdpr_core::plan::{PlanOptions, Post, Processing};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings};
use cdpr_core::regions::{RegionOptions, Space};
use cdpr_core::watch::{TimeUnit, thread_count, time_budget};
use cdpr_core::{Choice, Error, io};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};

use crate::output::{Talk, is_standard_output};

/// Plan, check and look at paths of cable-driven parallel robots among obstacles.
///
/// Exit status: 0 yes, 1 no (no path, start or goal invalid, in collision), 2 bad input, 130 interrupted.
/// Results go to standard output, everything else to standard error, in colours only on a terminal. `-` in the place of a
/// file is standard input or output, and pipes that the shell has opened are read and written as well; where a file goes to
/// standard output, results go to standard error.
#[derive(Debug, Parser)]
#[command(name = "cdpr", version, arg_required_else_help = true)]
pub struct Cli {
    #[command(flatten)]
    pub talk: TalkArgs,
    #[command(flatten)]
    pub color: colorchoice_clap::Color,
    #[command(subcommand)]
    pub command: Command,
}

/// How much is said.
#[derive(Debug, Clone, Copy, Args)]
pub struct TalkArgs {
    /// Print results and errors only.
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Also say what was read, and how a search got on.
    #[arg(short, long, global = true)]
    verbose: bool,
}

impl TalkArgs {
    pub fn level(self) -> Talk {
        match (self.quiet, self.verbose) {
            (true, _) => Talk::Quiet,
            (_, true) => Talk::Verbose,
            _ => Talk::Usual,
        }
    }
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Plan a path from the start to the goal of a scene.
    #[command(after_help = "Examples:
  cdpr plan hall.toml -o path.json --html view.html
  cdpr plan hall.toml --seed 7 --goal 1.2 0.5 1.8 --format json
  cdpr plan hall.toml --budget-ms 100
  cdpr plan hall.toml --orientation tilted -o path.json
  cdpr plan hall.toml --planner modified-rrt --post none -o raw.csv
  cdpr plan hall.toml --planner rrt-star --near-radius 0.3 --keep-going --budget-ms 500")]
    Plan(PlanArgs),
    /// Check a path: every violation with culprits, place and margin, and the nearest approach.
    #[command(after_help = "Examples:
  cdpr check hall.toml path.json
  cdpr plan hall.toml -o - | cdpr check hall.toml -")]
    Check(PathArgs),
    /// Describe a scene: sizes, ranks, special pairs of cables, how much of the workspace is free.
    #[command(after_help = "Example:
  cdpr info hall.toml")]
    Info(SceneArgs),
    /// Shorten anyone's path by rewinding.
    #[command(after_help = "Examples:
  cdpr post hall.toml waypoints.csv -o shorter.json
  cdpr post hall.toml waypoints.csv --post taut -o taut.json
  cdpr post hall.toml path.json --step 0.02 --repeats 5 -o shorter.csv")]
    Post(PostArgs),
    /// Write a commented scene that plans: a small one to start from, or one around your own robot and meshes.
    ///
    /// With --robot the box is that of outlets and meshes, down to the floor; start and goal are found where none are given:
    /// far apart, with something in the way. If the robot has a mass and tension limits, its cables must be able to
    /// hold it all along.
    #[command(after_help = "Examples:
  cdpr new hall.toml && cdpr plan hall.toml -o path.json --html view.html
  cdpr new hall.toml --robot cogiro.toml --obstacle machine.stl
  cdpr new hall.toml --robot cogiro.toml --obstacle press.obj rack.stl --units mm --start -4 0 1")]
    New(NewArgs),
    /// Make a robot file from a robot of another program.
    ///
    /// CASPR: one of the two XML files of a model, or their folder; --cable-set chooses one of its sets of cables. Gazebo
    /// (oKermorgant/cdpr on GitHub): its YAML file. What is not carried over is listed. Where the source says
    /// nothing of the platform's shape, it is the hull of the attachments, unless --platform gives a mesh.
    #[command(after_help = "Examples:
  cdpr import CoGiRo_cables.xml -o cogiro.toml
  cdpr import models/CAROCA --cable-set gazebo_sim -o caroca.toml
  cdpr import caroca.yaml --platform platform.stl --units mm -o caroca.toml")]
    Import(ImportArgs),
    /// Print the JSON Schema of a file format.
    #[command(after_help = "Example:
  cdpr schema scene > scene.schema.json")]
    Schema(SchemaArgs),
    /// Write one self-contained HTML page that shows a scene and, if given, a path.
    #[command(after_help = "Example:
  cdpr view hall.toml path.json -o view.html")]
    View(ViewArgs),
    /// Write the shadows of obstacles, or all forbidden regions, as closed triangle meshes or as a page.
    ///
    /// The shadow of an obstacle is where the end of a cable cannot be, because the cable would pass through the
    /// obstacle; it starts at the obstacle, as seen from the outlet. One mesh for each cable and obstacle, cut at the
    /// workspace; the parts of a concave obstacle are closed pieces of one mesh. Clearance and cable diameters are not
    /// part of it.
    ///
    /// By extension: .obj has an object for each region; .ply numbers the faces by region; .stl has no names and is in
    /// single precision (about seven digits); .html is a page that shows the regions in the scene.
    #[command(after_help = "Examples:
  cdpr shadows hall.toml -o shadows.html
  cdpr shadows hall.toml -o shadows.obj --cable \"cable 3\" --obstacle pillar
  cdpr shadows hall.toml -o regions.stl --all")]
    Shadows(ShadowsArgs),
    /// What the cables can balance: at a position, on a grid, or along a path.
    ///
    /// At a position: rank, margins, the cables that limit them, and the tensions nearest to the middle of their limits.
    /// On a grid: capacity margins at all positions inside the workspace, with share, volume and extent of the feasible ones.
    /// Along a path: position, length and tension of every cable and the margins at even steps, as CSV. Required balls are
    /// those of the scene's `[wrench]` unless given here. Exit status 1 where the loads (with --at: all that is required)
    /// cannot be balanced.
    #[command(after_help = "Examples:
  cdpr wrench hall.toml --at 0 0 2
  cdpr wrench hall.toml --at 0 0 2 --force 50 --moment 5 --format json
  cdpr wrench hall.toml --grid 0.1 -o margins.npz
  cdpr wrench hall.toml --along path.json -o tensions.csv")]
    Wrench(WrenchArgs),
    /// Run an experiment: scenarios × methods × trials, on all cores.
    ///
    /// Writes trials.csv (the same bytes for any number of threads), timings.csv and summary.json, and history.csv (when
    /// each path got better) if the experiment says `history = true`. Ctrl-C leaves complete rows behind; after it, or
    /// after any other end, --resume goes on.
    #[command(after_help = "Examples:
  cdpr batch experiments/table2.toml -o table2
  cdpr batch experiments/table2.toml -o table2 --resume
  cdpr batch experiments/table2.toml -o part3 --trials 200..300")]
    Batch(BatchArgs),
    /// Put runs of ranges of trials of one experiment together.
    #[command(after_help = "Example:
  cdpr merge part1 part2 part3 -o table2")]
    Merge(MergeArgs),
    /// Show a run as one page: tables, plots, and the paper's numbers beside ours where it prints any.
    ///
    /// The page is self-contained and opens offline. --plots also writes each plot as SVG and PNG.
    #[command(after_help = "Examples:
  cdpr report table2
  cdpr report table2 -o table2.html --plots figures")]
    Report(ReportArgs),
    /// Write manual pages, one for each command.
    #[command(after_help = "Example:
  cdpr man -o ~/.local/share/man/man1 && man cdpr-plan")]
    Man(ManArgs),
    /// Print a completion script for a shell.
    #[command(after_help = "Example:
  cdpr completions bash > ~/.local/share/bash-completion/completions/cdpr")]
    Completions(CompletionsArgs),
}

/// What a command is going to write.
pub enum Target<'a> {
    File(&'a Path),
    Folder(&'a Path),
}

impl Target<'_> {
    /// Checks that it can be written, before any work is done for it.
    pub fn check(&self) -> Result<(), Error> {
        match self {
            Target::File(path) if is_standard_output(path) => Ok(()),
            Target::File(path) => io::check_target(path),
            Target::Folder(path) => io::check_folder(path),
        }
    }
}

impl Command {
    /// All that this command is going to write.
    pub fn targets(&self) -> Vec<Target<'_>> {
        fn file(path: &Option<PathBuf>) -> Option<Target<'_>> {
            path.as_deref().map(Target::File)
        }
        fn folder(path: &Option<PathBuf>) -> Option<Target<'_>> {
            path.as_deref().map(Target::Folder)
        }
        match self {
            Command::Plan(args) => [file(&args.output), file(&args.html)].into_iter().flatten().collect(),
            Command::Post(args) => file(&args.output).into_iter().collect(),
            Command::New(args) => file(&args.output).into_iter().collect(),
            Command::Import(args) => vec![Target::File(&args.output)],
            Command::View(args) => vec![Target::File(&args.output)],
            Command::Shadows(args) => vec![Target::File(&args.output)],
            Command::Wrench(args) => file(&args.output).into_iter().collect(),
            Command::Batch(args) => vec![Target::Folder(&args.output)],
            Command::Merge(args) => vec![Target::Folder(&args.output)],
            Command::Report(args) => [file(&args.output), folder(&args.plots)].into_iter().flatten().collect(),
            Command::Man(args) => folder(&args.output).into_iter().collect(),
            Command::Check(_) | Command::Info(_) | Command::Schema(_) | Command::Completions(_) => Vec::new(),
        }
    }
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people.
    #[default]
    Text,
    /// For programs.
    Json,
}

#[derive(Debug, Clone, Args)]
pub struct SceneArgs {
    /// Scene file (.toml or .json).
    #[arg(value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,
    /// How the platform is turned: one of the scene's orientations by name, or a unit quaternion W,X,Y,Z. Otherwise as the
    /// scene says; if it names several, `plan` takes the one with the shortest path, what reads a path that of the path.
    #[arg(long, value_name = "NAME|W,X,Y,Z", value_parser = orientation, allow_hyphen_values = true)]
    pub orientation: Option<OrientationSource>,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Four numbers are a quaternion, anything else is a name.
fn orientation(text: &str) -> Result<OrientationSource, String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    Ok(match numbers.ok().and_then(|numbers| <[f64; 4]>::try_from(numbers).ok()) {
        Some(quaternion) => OrientationSource::Quaternion(quaternion),
        None => OrientationSource::Named(text.to_string()),
    })
}

#[derive(Debug, Args)]
pub struct PathArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Path file: JSON as written by `plan`, or CSV with the header x,y,z.
    #[arg(value_hint = ValueHint::FilePath)]
    pub path: PathBuf,
    #[command(flatten)]
    pub strict: Strict,
    #[command(flatten)]
    pub checker: CheckerArgs,
}

/// What is done with a path that was planned for another scene.
#[derive(Debug, Clone, Copy, Args)]
pub struct Strict {
    /// Refuse a path that was planned for another scene, instead of a warning.
    #[arg(long)]
    pub strict: bool,
}

/// Who checks motions, and how strictly.
#[derive(Debug, Clone, Copy, Args)]
pub struct CheckerArgs {
    /// Collision engine.
    #[arg(long, value_parser = choice::<Engine>(), default_value = Engine::default().name())]
    pub engine: Engine,
    /// How cables are kept from each other.
    #[arg(long, value_parser = choice::<Interference>(), default_value = Interference::default().name())]
    pub interference: Interference,
}

#[derive(Debug, Args)]
pub struct PlanArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Search method.
    #[arg(long, value_parser = choice::<Planner>(), default_value = Planner::default().name())]
    pub planner: Planner,
    #[command(flatten)]
    pub settings: PlannerArgs,
    /// Stop after this time, ms, compiling of the scene included (the samples may run out first).
    #[arg(long, value_name = "T", value_parser = budget, allow_negative_numbers = true)]
    pub budget_ms: Option<Duration>,
    #[command(flatten)]
    pub checker: CheckerArgs,
    /// Seed of everything random.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    #[command(flatten)]
    pub rewinding: RewindArgs,
    /// What is done to the found path [default: none for anytime, taut for rrt-connect, both for the others].
    #[arg(long, value_parser = choice::<Post>())]
    pub post: Option<Post>,
    /// Start instead of the scene's, m.
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true)]
    pub start: Option<Vec<f64>>,
    /// Goal instead of the scene's, m.
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true)]
    pub goal: Option<Vec<f64>>,
    /// Write the result here (.json, or .csv for the waypoints alone).
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Write a page here that shows the result.
    #[arg(long, value_name = "VIEW.html", value_hint = ValueHint::FilePath)]
    pub html: Option<PathBuf>,
}

/// Options of the planner; those that it does not have are refused.
#[derive(Debug, Clone, Copy, Args)]
pub struct PlannerArgs {
    /// Stop after this many random samples [default: 20000; rrt-star: 500000; anytime: no limit].
    #[arg(long, value_name = "N")]
    pub max_samples: Option<usize>,
    /// Stop after this many nodes.
    #[arg(long, value_name = "N")]
    pub max_nodes: Option<usize>,
    /// Go on after the first path, until samples, nodes or time are spent; the shortest path is kept.
    #[arg(long)]
    pub keep_going: bool,
    /// Go on after the first path until it is at most this long, m.
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub target_cost: Option<f64>,
    /// With anytime, go on until the path is at most this share longer than a lower bound of all paths: 0.01 for 1 %.
    #[arg(long, value_name = "SHARE", value_parser = positive, allow_negative_numbers = true)]
    pub gap: Option<f64>,
    /// Longest edge by which rrt and rrt-star grow, m [default: --step, as in the paper].
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub extend_step: Option<f64>,
    /// Probability with which rrt and rrt-star take the goal for a sample [default: 0].
    #[arg(long, value_name = "P", allow_negative_numbers = true)]
    pub goal_bias: Option<f64>,
    /// Radius of the ball that rrt-star looks at around a new node, m [default: shrinks with the number of nodes].
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub near_radius: Option<f64>,
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
            near_radius: self.near_radius,
        }
    }
}

/// Options of rewinding.
#[derive(Debug, Clone, Copy, Args)]
pub struct RewindArgs {
    /// Distance of the points that rewinding tries, m; also the step of rrt and rrt-star.
    #[arg(long, value_name = "M", default_value_t = PlanOptions::default().step, value_parser = positive, allow_negative_numbers = true)]
    pub step: f64,
    /// How often rewinding runs.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub repeats: usize,
}

#[derive(Debug, Args)]
pub struct PostArgs {
    #[command(flatten)]
    pub path: PathArgs,
    #[command(flatten)]
    pub rewinding: RewindArgs,
    /// What is done to the path.
    #[arg(long, value_parser = something(), default_value = Post::Both.name())]
    pub post: Post,
    /// Write the path here (.json or .csv).
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct NewArgs {
    /// File to write; standard output if none is given.
    #[arg(value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Robot file.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub robot: Option<PathBuf>,
    /// Meshes of obstacles (.stl or .obj), in world coordinates.
    #[arg(long, value_name = "MESH", num_args = 1.., requires = "robot", value_hint = ValueHint::FilePath)]
    pub obstacle: Vec<PathBuf>,
    /// Unit of the meshes.
    #[arg(long, value_parser = choice::<Unit>(), requires = "obstacle", default_value = Unit::M.name())]
    pub units: Unit,
    /// Start, m.
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true, requires = "robot")]
    pub start: Option<Vec<f64>>,
    /// Goal, m.
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true, requires = "robot")]
    pub goal: Option<Vec<f64>>,
    /// Overwrite an existing file.
    #[arg(long)]
    pub force: bool,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct ImportArgs {
    /// The source: an XML file of CASPR, a folder of them, or a YAML file of the Gazebo simulation.
    #[arg(value_hint = ValueHint::AnyPath)]
    pub source: PathBuf,
    /// CASPR's bodies file, where it does not stand beside the cables file under the same name.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub bodies: Option<PathBuf>,
    /// Set of cables [default: the one that the file names].
    #[arg(long, value_name = "ID")]
    pub cable_set: Option<String>,
    /// Mesh of the platform in its frame (.stl or .obj); the robot file names it.
    #[arg(long, value_name = "MESH", value_hint = ValueHint::FilePath)]
    pub platform: Option<PathBuf>,
    /// Unit of that mesh.
    #[arg(long, value_parser = choice::<Unit>(), requires = "platform", default_value = Unit::M.name())]
    pub units: Unit,
    /// Robot file to write (.toml or .json).
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct SchemaArgs {
    /// Which file format.
    #[arg(value_parser = choice::<FileFormat>(), default_value = FileFormat::Scene.name())]
    pub of: FileFormat,
    /// Accepted for uniformity; a schema is JSON.
    #[arg(long, value_enum, default_value_t = Format::Json)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct ViewArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Path file to show.
    #[arg(value_hint = ValueHint::FilePath)]
    pub path: Option<PathBuf>,
    /// Page to write.
    #[arg(short, long, value_name = "VIEW.html", value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    #[command(flatten)]
    pub strict: Strict,
    #[command(flatten)]
    pub checker: CheckerArgs,
}

#[derive(Debug, Args)]
pub struct ShadowsArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// File to write (.obj, .ply, .stl or .html).
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// Where the regions are drawn: attachment, or position with --all.
    #[arg(long, value_parser = choice::<Space>())]
    pub space: Option<Space>,
    /// Also regions of the platform with obstacles, of cables with the platform, and of pairs of cables (flat); they
    /// exist only in the space of positions, which is then the default.
    #[arg(long)]
    pub all: bool,
    /// Only regions of these cables.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub cable: Vec<String>,
    /// Only regions of these obstacles.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub obstacle: Vec<String>,
}

#[derive(Debug, Args)]
#[command(group = clap::ArgGroup::new("where").required(true).args(["at", "grid", "along"]))]
pub struct WrenchArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// A position of the platform's origin, m.
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true)]
    pub at: Option<Vec<f64>>,
    /// Margins on a grid of this step over all positions inside the workspace, m; needs -o.
    #[arg(long, value_name = "STEP", value_parser = positive, requires = "output", allow_negative_numbers = true)]
    pub grid: Option<f64>,
    /// With --grid, force and moment margins as well (slower).
    #[arg(long, requires = "grid")]
    pub projected: bool,
    /// Path file: JSON as written by `plan`, or CSV with the header x,y,z.
    #[arg(long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub along: Option<PathBuf>,
    #[command(flatten)]
    pub strict: Strict,
    /// Distance of the rows along the path, m.
    #[arg(long, value_name = "M", default_value_t = 0.01, value_parser = positive, allow_negative_numbers = true)]
    pub step: f64,
    /// Radius of the required force ball instead of the scene's, N.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub force: Option<f64>,
    /// Radius of the required moment ball instead of the scene's, N·m.
    #[arg(long, value_name = "NM", allow_negative_numbers = true)]
    pub moment: Option<f64>,
    /// Write the rows (.csv) or the map (.npz for NumPy, .vti for ParaView) here.
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct BatchArgs {
    /// Experiment file (.toml or .json).
    #[arg(value_hint = ValueHint::FilePath)]
    pub experiment: PathBuf,
    /// Folder to write; new or empty, unless a run in it goes on.
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
    /// Go on with the run in the folder.
    #[arg(long)]
    pub resume: bool,
    /// Threads [default: as many as there are cores].
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
    /// Number of trials instead of the experiment's, or a range of them, the end not included.
    #[arg(long, value_name = "N|A..B", value_parser = trials)]
    pub trials: Option<Trials>,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

fn threads(text: &str) -> Result<usize, String> {
    let number = text.parse().map_err(|_| "expected a whole number")?;
    thread_count(number).map_err(|e| e.to_string())
}

/// A range of trials; a type of its own, since clap takes ranges for lists.
#[derive(Debug, Clone)]
pub struct Trials(pub std::ops::Range<usize>);

fn trials(text: &str) -> Result<Trials, String> {
    let number =
        |text: &str| text.parse::<usize>().map_err(|_| "expected a whole number N, or a range A..B".to_string());
    let range = match text.split_once("..") {
        Some((first, end)) => number(first)?..number(end)?,
        None => 0..number(text)?,
    };
    if range.is_empty() { Err("found no trials, expected at least one".to_string()) } else { Ok(Trials(range)) }
}

#[derive(Debug, Args)]
pub struct MergeArgs {
    /// Folders of complete runs, in any order.
    #[arg(required = true, value_hint = ValueHint::DirPath)]
    pub folders: Vec<PathBuf>,
    /// Folder to write; new or empty.
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
    /// Write the plots here, as .svg and .png.
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub plots: Option<PathBuf>,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct ManArgs {
    /// Folder to write; without it the page of cdpr itself is printed.
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

impl PlanArgs {
    pub fn options(&self) -> Result<PlanOptions, Error> {
        Ok(PlanOptions {
            planner: PlannerOptions::new(self.planner, self.rewinding.step, &self.settings.settings())?,
            engine: self.checker.engine,
            interference: self.checker.interference,
            seed: self.seed,
            start: self.start.as_deref().map(Point::from_slice),
            goal: self.goal.as_deref().map(Point::from_slice),
            step: self.rewinding.step,
            post: self.post,
            repeats: self.rewinding.repeats,
            budget: self.budget_ms,
        })
    }
}

impl ShadowsArgs {
    pub fn options(&self) -> RegionOptions {
        let (cables, obstacles) = (self.cable.clone(), self.obstacle.clone());
        RegionOptions { space: self.space, all: self.all, cables, obstacles }
    }
}

impl PostArgs {
    pub fn options(&self) -> Result<Processing, Error> {
        self.post.processing(self.rewinding.step, self.rewinding.repeats)
    }
}

/// Accepts the names of a choice, and shows them with their help.
fn choice<T: Choice>() -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(possible::<T>()).map(|name| T::named(&name).expect("one of the possible names"))
}

fn possible<T: Choice>() -> Vec<PossibleValue> {
    T::ALL.iter().map(|(_, name, help)| PossibleValue::new(*name).help(*help)).collect()
}

/// The names of [`Post`] but for that of doing nothing.
fn something() -> impl TypedValueParser<Value = Post> {
    let names = possible::<Post>().into_iter().filter(|name| !name.matches(Post::None.name(), false));
    PossibleValuesParser::new(names.collect::<Vec<_>>())
        .map(|name| Post::named(&name).expect("one of the possible names"))
}

/// A time in milliseconds.
fn budget(text: &str) -> Result<Duration, String> {
    let ms: f64 = text.parse().map_err(|_| "expected a number")?;
    time_budget("", ms, TimeUnit::Millisecond).map_err(|e| e.to_string())
}

/// A positive number, such as a step.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number <= 1e9 => Ok(number),
        Ok(number) => Err(format!("found {number}, expected a positive number of at most 1e9")),
        Err(_) => Err("expected a number".to_string()),
    }
}
