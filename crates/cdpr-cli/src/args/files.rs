//! Arguments of the commands that make and show files.

use std::path::PathBuf;

use cdpr_core::{Choice, model::Unit};
use cdpr_files::{Control, example_names};
use cdpr_study::schema::Format as FileFormat;
use clap::builder::PossibleValuesParser;
use clap::{Args, ValueHint};

use super::given_options::GivenOptions;
use super::shared::{CheckerArgs, Format, SceneArgs, Strict};
use super::values::choice;

/// Options of scenes around a given robot.
const OF_ROBOTS: [&str; 5] = ["robot", "obstacle", "units", "start", "goal"];

#[derive(Debug, Args)]
pub struct NewArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    /// File to write [default: standard output].
    #[arg(value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Robot file.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub robot: Option<PathBuf>,
    /// An example scene instead of one to fill in.
    #[arg(long, value_name = "NAME", conflicts_with_all = OF_ROBOTS, value_parser = PossibleValuesParser::new(example_names()))]
    pub example: Option<String>,
    /// Folder for example files to build scenes around: robots, also of CASPR and Gazebo, and meshes.
    #[arg(long, value_name = "FOLDER", conflicts_with_all = OF_ROBOTS, conflicts_with_all = ["output", "example"], value_hint = ValueHint::DirPath)]
    pub example_files: Option<PathBuf>,
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
    /// Overwrite existing files.
    #[arg(long)]
    pub force: bool,
    /// How to print the result.
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct ImportArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    /// Source: a CASPR XML file, a folder of them, or a YAML file of the Gazebo simulation.
    #[arg(value_hint = ValueHint::AnyPath)]
    pub source: PathBuf,
    /// CASPR's bodies file, if it is not beside the cables file under the same name.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub bodies: Option<PathBuf>,
    /// Cable set [default: the file's own default].
    #[arg(long, value_name = "ID")]
    pub cable_set: Option<String>,
    /// Mesh of the platform in the platform frame (.stl or .obj); the robot file refers to it.
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
pub struct ExportArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Trajectory with tensions (.json or .csv), written beside the model as .npz.
    #[arg(value_hint = ValueHint::FilePath)]
    pub motion: Option<PathBuf>,
    /// Model to write.
    #[arg(short, long, value_name = "MODEL.xml", value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// What the controls of the model are.
    #[arg(long, value_parser = choice::<Control>(), default_value = Control::default().name())]
    pub control: Control,
    #[command(flatten)]
    pub strict: Strict,
}

impl ExportArgs {
    /// The file of the motion, if there is one.
    pub fn motion_output(&self) -> Option<PathBuf> {
        self.motion.as_ref().map(|_| cdpr_files::motion_of_mjcf(&self.output))
    }
}

#[derive(Debug, Args)]
pub struct ViewArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Path or trajectory to show, or a proof that there is no path.
    #[arg(value_hint = ValueHint::FilePath)]
    pub path: Option<PathBuf>,
    /// Page to write.
    #[arg(short, long, value_name = "VIEW.html", value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// Write a page that only shows the scene: no editing and planning in it, 1 MB smaller.
    #[arg(long = "static")]
    pub is_static: bool,
    #[command(flatten)]
    pub strict: Strict,
    #[command(flatten)]
    pub checker: CheckerArgs,
}

#[derive(Debug, Args)]
pub struct ManArgs {
    /// Folder to write; without it, the page of cdpr itself is printed.
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}
