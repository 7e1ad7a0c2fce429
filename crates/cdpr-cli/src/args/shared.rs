//! Arguments shared by commands: scene, path, collision checker.

use std::path::PathBuf;

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::model::{Distribution, OrientationSource};
use cdpr_core::{Choice, Scene};
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
    /// Orientation of the platform: the name of one of the scene's orientations, or a unit quaternion W,X,Y,Z [default:
    /// the one that the scene selects]. If the scene lists several and selects none, `plan` uses the one with the
    /// shortest path, commands that read a path use the path's, and others use the first.
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
    /// Path file: JSON as written by `plan`, or CSV with the header x,y,z (x,y,z,qw,qx,qy,qz if the platform turns).
    #[arg(value_hint = ValueHint::FilePath)]
    pub path: PathBuf,
    #[command(flatten)]
    pub strict: Strict,
    #[command(flatten)]
    pub checker: CheckerArgs,
}

/// How to treat a path that was planned for another scene.
#[derive(Debug, Clone, Copy, Args)]
pub struct Strict {
    /// Refuse a path that was planned for another scene instead of warning about it.
    #[arg(long)]
    pub strict: bool,
}

/// Which tensions are computed.
#[derive(Debug, Clone, Copy, Args)]
pub struct TensionArgs {
    /// Which of all tensions that balance the loads are computed [default: the robot's `tension_distribution`, else middle].
    #[arg(long, value_parser = choice::<Distribution>())]
    pub tensions: Option<Distribution>,
}

impl TensionArgs {
    /// The scene with these tensions, if they are given.
    pub fn in_scene(self, scene: Scene) -> Scene {
        self.tensions.map_or_else(|| scene.clone(), |chosen| scene.with_tensions(chosen))
    }
}

/// How motions are checked.
#[derive(Debug, Clone, Copy, Args)]
pub struct CheckerArgs {
    /// Collision engine.
    #[arg(long, value_parser = choice::<Engine>(), default_value = Engine::default().name())]
    pub engine: Engine,
    /// Rule for interference between cables.
    #[arg(long, value_parser = choice::<Interference>(), default_value = Interference::default().name())]
    pub interference: Interference,
}
