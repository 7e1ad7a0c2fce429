//! Arguments of `shadows`, `wrench`, `workspace` and `pose`.

use std::path::PathBuf;
use std::time::Duration;

use cdpr_core::Choice;
use cdpr_core::geometry::Rotation;
use cdpr_core::model::OrientationSource;
use cdpr_core::regions::{RegionOptions, Space};
use cdpr_core::workspace::ValidAt;
use clap::{Args, ValueHint};

use super::given_options::GivenOptions;
use super::shared::{Format, SceneArgs, Strict, TensionArgs};
use super::values::{POSITION, budget, choice, orientation, positive, quaternion};

#[derive(Debug, Args)]
pub struct ShadowsArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// File to write (.obj, .ply, .stl or .html).
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// Space of the regions [default: attachment; position with --all].
    #[arg(long, value_parser = choice::<Space>())]
    pub space: Option<Space>,
    /// Also write the regions of the platform with obstacles, of cables with the platform, and of pairs of cables
    /// (flat). They exist only in the space of positions, which is then the default.
    #[arg(long)]
    pub all: bool,
    /// Write only the regions of these cables.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub cable: Vec<String>,
    /// Write only the regions of these obstacles.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub obstacle: Vec<String>,
}

#[derive(Debug, Args)]
#[command(group = clap::ArgGroup::new("where").required(true).args(["at", "grid", "along"]))]
pub struct WrenchArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The name of a station, or a position of the platform's origin, m.
    #[arg(long, num_args = 1..=3, value_name = POSITION, allow_negative_numbers = true)]
    pub at: Option<Vec<String>>,
    /// Compute margins on a grid with this step over all positions inside the workspace, m; requires -o.
    #[arg(long, value_name = "STEP", value_parser = positive, requires = "output", allow_negative_numbers = true)]
    pub grid: Option<f64>,
    /// With --grid, also compute force and moment margins (slower).
    #[arg(long)]
    pub projected: bool,
    /// Path file: JSON as written by `plan`, or CSV with the header x,y,z.
    #[arg(long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub along: Option<PathBuf>,
    #[command(flatten)]
    pub strict: Strict,
    /// Distance between rows along the path, m.
    #[arg(long, value_name = "M", default_value_t = 0.01, value_parser = positive, allow_negative_numbers = true)]
    pub step: f64,
    /// Radius of the required force ball instead of the scene's, N.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub force: Option<f64>,
    /// Radius of the required moment ball instead of the scene's, N·m.
    #[arg(long, value_name = "NM", allow_negative_numbers = true)]
    pub moment: Option<f64>,
    #[command(flatten)]
    pub tensions: TensionArgs,
    /// Write the rows (.csv) or the map (.npz for NumPy, .vti for ParaView) here.
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct WorkspaceArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Several orientations instead of one: names of the scene's orientations, or unit quaternions.
    #[arg(long, num_args = 1.., value_name = "NAME|W,X,Y,Z", value_parser = orientation, conflicts_with = "orientation")]
    pub orientations: Vec<OrientationSource>,
    /// At which of several orientations positions have to be valid.
    #[arg(long, value_parser = choice::<ValidAt>(), default_value = ValidAt::default().name(), requires = "orientations")]
    pub valid_at: ValidAt,
    /// Write the result here (.json with all boxes, .npz for NumPy, .vti for ParaView, or .stl, the surface of what is proved inside).
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Write a page that shows where the platform can be here.
    #[arg(long, value_name = "VIEW.html", value_hint = ValueHint::FilePath)]
    pub html: Option<PathBuf>,
    /// Divide boxes until their sides are at most this long, m [default: a 64th of the longest side of the box of positions; with
    /// --budget-ms, as small as time allows].
    #[arg(long, value_name = "M", value_parser = positive, allow_negative_numbers = true)]
    pub resolution: Option<f64>,
    /// Stop this long after all files are read, ms; what is undecided then remains so.
    #[arg(long, value_name = "T", value_parser = budget, allow_negative_numbers = true)]
    pub budget_ms: Option<Duration>,
}

#[derive(Debug, Args)]
pub struct PoseArgs {
    /// Robot file (.toml or .json).
    #[arg(value_hint = ValueHint::FilePath)]
    pub robot: PathBuf,
    /// CSV file of cable lengths, m, one pose in each row: with a header that has a column `length:NAME` for each cable, or
    /// without a header and with the lengths in the order of the cables. Instead of lengths, `command:NAME`, m, or `angle:NAME`,
    /// rad, as winches report them, with `tension:NAME`, N, if cables stretch.
    #[arg(value_hint = ValueHint::FilePath)]
    pub lengths: PathBuf,
    /// Known orientation of the platform, a unit quaternion; only the position is then found.
    #[arg(long, value_name = "W,X,Y,Z", value_parser = quaternion, allow_hyphen_values = true)]
    pub orientation: Option<Rotation>,
    /// Position near which to look for the first pose, m; the platform is then level, or at --orientation [default: from the
    /// lengths].
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true)]
    pub guess: Option<Vec<f64>>,
    /// Write the poses here as a path (.json, or .csv with the header x,y,z,qw,qx,qy,qz).
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

impl ShadowsArgs {
    pub fn options(&self) -> RegionOptions {
        let (cables, obstacles) = (self.cable.clone(), self.obstacle.clone());
        RegionOptions { space: self.space, all: self.all, cables, obstacles }
    }
}
