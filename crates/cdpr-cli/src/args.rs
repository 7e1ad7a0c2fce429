//! The command line: names, defaults and help.

mod analysis;
mod experiments;
mod files;
mod given_options;
mod motion;
mod planning;
mod route;
mod shared;
mod tours;
mod values;
mod without_effect;

use std::path::{Path, PathBuf};

use cdpr_core::Error;
use clap::{Args, Parser, Subcommand};

pub use analysis::{PoseArgs, ShadowsArgs, WorkspaceArgs, WrenchArgs};
pub use experiments::{BatchArgs, MergeArgs, ReportArgs};
pub use files::{CompletionsArgs, ExportArgs, ImportArgs, ManArgs, NewArgs, SchemaArgs, ViewArgs};
pub use given_options::GivenOptions;
pub use motion::{CheckArgs, TrajectoryArgs};
pub use planning::{PlanArgs, PostArgs};
pub use shared::{CheckerArgs, Format, PathArgs, SceneArgs, Strict};
pub use tours::{TaskArgs, TourArgs};
pub use values::{Trials, place, position};
pub use without_effect::LIMITS;

use crate::output::Talk;
use crate::target::{Contents, Target, check_targets};

/// Plan, check and view paths of cable-driven parallel robots among obstacles.
///
/// Exit status: 0 for yes, 1 for no (no path, start or goal invalid, in collision), 2 for bad input, 70 for a bug in
/// cdpr (please report it with its message), 130 if interrupted. Results go to standard output and everything else to
/// standard error, in colour only on a terminal. `-` in place of a file name means standard input or output, and pipes
/// opened by the shell work as well. If a file is written to standard output, results go to standard error.
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

/// How much is printed.
#[derive(Debug, Clone, Copy, Args)]
pub struct TalkArgs {
    /// Print results and errors only.
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Also print what was read, each note, and how the search progresses.
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
  cdpr plan hall.toml --start rack --goal mill -o path.json
  cdpr plan hall.toml --budget-ms 100
  cdpr plan hall.toml --start-lengths encoders.csv
  cdpr plan hall.toml --orientation tilted -o path.json
  cdpr plan hall.toml --start-orientation along --goal-orientation across -o path.json
  cdpr plan hall.toml --trajectory motion.csv --speed 1 --acceleration 2 --minimise time
  cdpr plan hall.toml --maximise clearance -o wide.json
  cdpr plan hall.toml --planner modified-rrt --post none -o raw.csv
  cdpr plan hall.toml --planner rrt-star --near-radius 0.3 --keep-going --budget-ms 500")]
    Plan(Box<PlanArgs>),
    /// Check a path or a trajectory: report every violation (the bodies involved, where or when, by how much) and the
    /// nearest approach.
    ///
    /// A trajectory, from any source, must keep the limits of the scene's `[motion]` or those given here, at its samples
    /// and, as far as the samples show it, between them; a trajectory of cdpr also at ten instants between two samples.
    /// Velocities, accelerations and cable lengths must fit the positions. Tensions must keep the limits of the cables
    /// and balance weight, load and inertia; without columns of tensions, such tensions must exist. Bodies must keep the
    /// clearances of the scene, or at most --motion-clearance. With a `blend` in the scene's `[motion]` or given here, a
    /// trajectory of cdpr must not deviate more from its path.
    ///
    /// Of a task, each leg is checked in the scene that holds then, and its motion if it was timed; legs must join, payloads be picked where
    /// they stand, and the motion through all legs be theirs one after another.
    #[command(after_help = "Examples:
  cdpr check hall.toml path.json
  cdpr check hall.toml task/task.json
  cdpr check hall.toml motion.csv --speed 1 --acceleration 2
  cdpr plan hall.toml -o - | cdpr check hall.toml -")]
    Check(CheckArgs),
    /// Describe a scene: sizes, ranks of the wrench matrix, special pairs of cables, and how much of the workspace is
    /// free.
    #[command(after_help = "Example:
  cdpr info hall.toml")]
    Info(SceneArgs),
    /// Shorten a path from any source, by rewinding or string pulling.
    #[command(after_help = "Examples:
  cdpr post hall.toml waypoints.csv -o shorter.json
  cdpr post hall.toml waypoints.csv --post taut -o taut.json
  cdpr post hall.toml path.json --step 0.02 --repeats 5 -o shorter.csv")]
    Post(PostArgs),
    /// Time a path: the fastest motion along it that keeps all limits at every instant.
    ///
    /// The limits are those of the scene's `[motion]` and the options: speed, acceleration and jerk of the platform, speed
    /// and acceleration of the cables, and the tension limits of the cables under weight, load and inertia. Corners are
    /// rounded with at most the deviation `blend`, where that is free; otherwise the platform stops there.
    #[command(after_help = "Examples:
  cdpr trajectory hall.toml path.json -o motion.json --speed 1 --acceleration 2
  cdpr trajectory hall.toml path.json -o motion.csv --rate 500 --blend 0.05
  cdpr trajectory hall.toml path.json -o motion.yaml --rate 100

motion.yaml is a message trajectory_msgs/msg/JointTrajectory; docs/ros2.md has a node that publishes it.")]
    Trajectory(TrajectoryArgs),
    /// Write a commented scene that can be planned at once: a small example, or one built around your own robot and
    /// meshes.
    ///
    /// With --robot, the workspace is the box around outlets and meshes, extended down to the floor, and widened where
    /// the platform would have no room. If start or goal is not given, cdpr looks for positions that are far apart, with
    /// something in the way if there are such. If the robot has a mass and tension limits, the scene requires that the
    /// cables can hold the platform along the whole path, unless they hold it nowhere.
    #[command(after_help = "Examples:
  cdpr new hall.toml && cdpr plan hall.toml -o path.json --html view.html
  cdpr new --example-files examples && cdpr import examples/caspr/CoGiRo -o cogiro.toml
  cdpr new hall.toml --robot cogiro.toml --obstacle machine.stl
  cdpr new hall.toml --robot cogiro.toml --obstacle press.obj rack.stl --units mm --start -4 0 1")]
    New(NewArgs),
    /// Convert a robot of another program to a robot file.
    ///
    /// CASPR: give one of the two XML files of a model, or their folder; --cable-set selects one of its cable sets.
    /// Gazebo (oKermorgant/cdpr on GitHub): give its YAML file. Everything that is not carried over is listed. If the
    /// source does not define the platform's shape, the hull of the attachments is used, unless --platform gives a
    /// mesh.
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
    /// Write a scene, and if given a timed motion, for the simulator MuJoCo.
    ///
    /// The model (MJCF) has the platform as a free body with its mass, centre of mass and inertia, the obstacles, and each cable
    /// as a tendon with an actuator, all by name; a pulley is a wheel that swivels. The motion, which must have tensions, is
    /// written beside the model as NumPy arrays for its joints and controls: model.npz beside model.xml. What the scene says and
    /// the model leaves out or assumes is printed. In MuJoCo cables pass through bodies, and nothing keeps clearances and limits of lengths:
    /// check that with `cdpr check`.
    #[command(after_help = "Examples:
  cdpr export hall.toml motion.json -o model.xml
  cdpr export hall.toml motion.csv -o model.xml --control length
  cdpr export hall.toml -o - > model.xml

docs/howto/simulate.md says how to simulate them; python/examples/simulate.py does.")]
    Export(ExportArgs),
    /// Write the shadows of obstacles, or all forbidden regions, as closed triangle meshes or as a page.
    ///
    /// The shadow of an obstacle is the region where the end of a cable cannot be, because the cable would pass through
    /// the obstacle; seen from the outlet, it begins at the obstacle. There is one mesh for each cable and obstacle,
    /// clipped to the workspace; the parts of a concave obstacle are closed pieces of one mesh. Clearances and cable
    /// diameters are not included.
    ///
    /// The extension selects the format: .obj has one object per region; .ply numbers the faces by region; .stl has no
    /// names and is in single precision (about seven digits); .html is a page that shows the regions in the scene.
    #[command(after_help = "Examples:
  cdpr shadows hall.toml -o shadows.html
  cdpr shadows hall.toml -o shadows.obj --cable \"cable 3\" --obstacle pillar
  cdpr shadows hall.toml -o regions.stl --all")]
    Shadows(ShadowsArgs),
    /// Compute what the cables can balance: at a position, on a grid, or along a path.
    ///
    /// At a position: the rank of the wrench matrix and which motions the cables resist, the margins and the cables
    /// that limit them, and the tensions nearest to the middle of their limits. A position is feasible if planning with
    /// the same requirements would accept it under the rule `certified`; under `grid`, planning asks the nodes of the
    /// grid instead. On a grid: capacity margins at all positions inside the workspace, with the share, volume and
    /// extent of the feasible ones. Along a path: the position, length and tension of every cable by name, the command of
    /// its winch if `stiffness` or `drum` is known, and the margins, at even steps, as CSV; only the lengths if the robot has no mass or tension limits. The required force and moment balls are those of the scene's `[wrench]` unless given here. The exit
    /// status is 1 if the loads (with --at: everything required) cannot be balanced.
    #[command(after_help = "Examples:
  cdpr wrench hall.toml --at 0 0 2
  cdpr wrench hall.toml --at 0 0 2 --force 50 --moment 5 --format json
  cdpr wrench hall.toml --grid 0.1 -o margins.npz
  cdpr wrench hall.toml --along path.json -o tensions.csv")]
    Wrench(WrenchArgs),
    /// Prove where the platform can be, at one orientation or at several.
    ///
    /// Divides the box of positions into boxes of which every position is valid, boxes of which one condition forbids every
    /// position, and a rest that is undecided because its boxes are as small as --resolution, or time ran out. So the volume of all
    /// valid positions is known to lie between two numbers. Clearances, lengths of cables, their sag, pulleys and the wrenches of
    /// the scene count as they do in planning. The connected parts of what is proved inside are printed too, and how much each
    /// condition rules out; a box that several conditions forbid counts for the first of them. The exit status is 1 if nothing
    /// is proved inside.
    #[command(after_help = "Examples:
  cdpr workspace hall.toml
  cdpr workspace hall.toml -o boxes.npz --resolution 0.02
  cdpr workspace hall.toml --budget-ms 10000 --format json
  cdpr workspace hall.toml --orientation tilted -o inside.stl")]
    Workspace(WorkspaceArgs),
    /// Plan a tour: all paths between the stations of a scene, and the order with the shortest way through all of them, or the least time.
    ///
    /// Up to 12 stations the order is the best one for the paths that were found; beyond that, a search finds a short one. The bound
    /// that is printed holds for every order and every path. The file of -o is a path through all stations, for `check`, `view` and
    /// `trajectory`. The exit status is 1 if there is no tour.
    ///
    /// By time, each path is timed from rest to rest, by the limits of the scene's `[motion]` and the options; one time holds both ways.
    #[command(after_help = "Examples:
  cdpr tour hall.toml -o tour.json --html tour.html
  cdpr tour hall.toml --stations rack,mill,washer --start rack --return
  cdpr tour hall.toml --by time --speed 1 --acceleration 2 --matrix seconds.csv
  cdpr tour hall.toml --matrix lengths.csv --format json
  cdpr tour hall.toml -o tour.json && cdpr trajectory hall.toml tour.json -o motion.csv")]
    Tour(TourArgs),
    /// Plan a task: the way of the platform as it picks payloads and sets them down, by the rows `[[task]]` of a scene.
    ///
    /// Each leg is planned in the scene that holds then: what is carried is a part of the platform, other payloads are obstacles where
    /// they stand. A leg without a path is named with its reason, and the others are planned all the same. At a pick or a place, the
    /// payload may touch what it stands on, and the platform the payload. With --trajectory, the legs are timed as one motion that stops
    /// between them. `cdpr check SCENE DIR/task.json` checks the whole task. The exit status is 1 if a leg has no path or no motion.
    #[command(after_help = "Examples:
  cdpr task hall.toml -o task && cdpr check hall.toml task/task.json
  cdpr task hall.toml -o task --trajectory motion.csv --speed 1 --acceleration 2
  cdpr task hall.toml -o task --html --budget-ms 500")]
    Task(TaskArgs),
    /// Find the pose of the platform from the lengths of its cables, as the winches report them.
    ///
    /// The pose is the one whose lengths are nearest to those given (least squares), round pulleys if there are any. Each
    /// row is solved from the pose of the row before, the first one from the lengths alone or from --guess. Position and orientation
    /// need at least six cables, the position at a known --orientation three. Residuals, given lengths minus those at the pose, are
    /// printed and never an error. Other poses with the same lengths are listed if they are found; they are looked for from
    /// the pose moved by the mean length of the cables along each axis, and turned by 90° about each. The exit status is 1 if
    /// lengths do not determine a pose.
    #[command(after_help = "Examples:
  cdpr pose cogiro.toml encoders.csv
  cdpr pose cogiro.toml encoders.csv -o driven.csv && cdpr check hall.toml driven.csv
  tail -n 1 log.csv | cdpr pose cogiro.toml - --orientation 1,0,0,0 --format json")]
    Pose(PoseArgs),
    /// Run an experiment: scenarios × methods × trials, on all cores.
    ///
    /// Writes trials.csv (the same bytes for any number of threads), timings.csv and summary.json, and history.csv
    /// (when each path improved) if the experiment sets `history = true`. After Ctrl-C, or if the run ends in any other
    /// way, the rows are complete and --resume continues the run.
    #[command(after_help = "Examples:
  cdpr batch experiments/table2.toml -o table2
  cdpr batch experiments/table2.toml -o table2 --resume
  cdpr batch experiments/table2.toml -o part3 --trials 200..300")]
    Batch(BatchArgs),
    /// Merge runs of several ranges of trials of one experiment.
    #[command(after_help = "Example:
  cdpr merge part1 part2 part3 -o table2")]
    Merge(MergeArgs),
    /// Show a run as one page: tables, and the paper's numbers beside ours where the paper prints any.
    ///
    /// The page is self-contained and opens offline. `python -m cdpr.figures FOLDER -o DIR` draws the figures of the run.
    #[command(after_help = "Examples:
  cdpr report table2
  cdpr report table2 -o table2.html")]
    Report(ReportArgs),
    /// Write manual pages, one per command.
    #[command(after_help = "Example:
  cdpr man -o ~/.local/share/man/man1 && man cdpr-plan")]
    Man(ManArgs),
    /// Print a completion script for a shell.
    #[command(after_help = "Example:
  cdpr completions bash > ~/.local/share/bash-completion/completions/cdpr")]
    Completions(CompletionsArgs),
}

impl Command {
    /// Everything that this command will write.
    fn targets(&self) -> Vec<Target<'_>> {
        fn named(path: &Option<PathBuf>, contents: Contents) -> Vec<Target<'_>> {
            path.iter().map(|path| Target::new(path, contents)).collect()
        }
        match self {
            Command::Plan(args) => {
                let trajectory = Contents::Trajectory(args.timing.fields());
                let files = [
                    (&args.output, Contents::Path),
                    (&args.html, Contents::Page),
                    (&args.trajectory, trajectory),
                    (&args.proof, Contents::Proof),
                ];
                files.into_iter().flat_map(|(path, contents)| named(path, contents)).collect()
            }
            Command::Trajectory(args) => named(&args.output, Contents::Trajectory(args.timing.fields())),
            Command::Post(args) => named(&args.output, Contents::Path),
            Command::New(args) => {
                let files = [(&args.output, Contents::Spec), (&args.example_files, Contents::Folder)];
                files.into_iter().flat_map(|(path, contents)| named(path, contents)).collect()
            }
            Command::Import(args) => vec![Target::new(&args.output, Contents::Spec)],
            Command::Export(args) => {
                let motion = args.motion_output();
                let model = Target::new(&args.output, Contents::Model { beside: motion.is_some() });
                [Some(model), motion.map(|path| Target::new(path, Contents::Arrays))].into_iter().flatten().collect()
            }
            Command::View(args) => vec![Target::new(&args.output, Contents::Page)],
            Command::Shadows(args) => vec![Target::new(&args.output, Contents::Regions)],
            Command::Wrench(args) if args.grid.is_some() => named(&args.output, Contents::Map),
            Command::Wrench(args) => named(&args.output, Contents::Tensions),
            Command::Workspace(args) => {
                let files = [(&args.output, Contents::Workspace), (&args.html, Contents::Page)];
                files.into_iter().flat_map(|(path, contents)| named(path, contents)).collect()
            }
            Command::Tour(args) => {
                let files =
                    [(&args.output, Contents::Path), (&args.matrix, Contents::Matrix), (&args.html, Contents::Page)];
                files.into_iter().flat_map(|(path, contents)| named(path, contents)).collect()
            }
            Command::Task(args) => vec![Target::new(&args.output, Contents::Folder)],
            Command::Pose(args) => named(&args.output, Contents::Path),
            Command::Batch(args) => vec![Target::new(&args.output, Contents::Folder)],
            Command::Merge(args) => vec![Target::new(&args.output, Contents::Folder)],
            Command::Report(args) => named(&args.output, Contents::Page),
            Command::Man(args) => named(&args.output, Contents::Folder),
            Command::Check(_) | Command::Info(_) | Command::Schema(_) | Command::Completions(_) => Vec::new(),
        }
    }

    /// The files and folders that this command reads, without those that they name.
    fn sources(&self) -> Vec<&Path> {
        fn all<'a>(files: impl IntoIterator<Item = &'a PathBuf>) -> Vec<&'a Path> {
            files.into_iter().map(PathBuf::as_path).collect()
        }
        match self {
            Command::Plan(args) => all([&args.scene.scene].into_iter().chain(&args.start_lengths).chain(&args.replan)),
            Command::Check(args) => all([&args.scene.scene].into_iter().chain(&args.path)),
            Command::Info(args) => all([&args.scene]),
            Command::Post(args) => all([&args.path.scene.scene, &args.path.path]),
            Command::Trajectory(args) => all([&args.scene.scene, &args.path]),
            Command::New(args) => all(args.robot.iter().chain(&args.obstacle)),
            Command::Import(args) => all([&args.source].into_iter().chain(&args.bodies).chain(&args.platform)),
            Command::Export(args) => all([&args.scene.scene].into_iter().chain(&args.motion)),
            Command::View(args) => all([&args.scene.scene].into_iter().chain(&args.path)),
            Command::Shadows(args) => all([&args.scene.scene]),
            Command::Workspace(args) => all([&args.scene.scene]),
            Command::Tour(args) => all([&args.scene.scene]),
            Command::Task(args) => all([&args.scene.scene]),
            Command::Wrench(args) => all([&args.scene.scene].into_iter().chain(&args.along)),
            Command::Pose(args) => all([&args.robot, &args.lengths]),
            Command::Batch(args) => all([&args.experiment]),
            Command::Merge(args) => all(&args.folders),
            Command::Report(_) | Command::Schema(_) | Command::Man(_) | Command::Completions(_) => Vec::new(),
        }
    }

    /// Checks that everything this command will write can be written, and replaces neither what it reads nor each other.
    pub fn check_targets(&self) -> Result<(), Error> {
        check_targets(&self.targets(), self.sources())
    }
}
