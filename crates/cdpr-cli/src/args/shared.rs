//! What many commands take: a scene, a path, who checks it.

use std::path::PathBuf;

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::{Choice, model::OrientationSource};
use clap::{Args, ValueEnum, ValueHint};

use super::values::{choice, orientation};

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
