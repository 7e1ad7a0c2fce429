//! Arguments of `trajectory` and `check`, and the limits of motions.

use std::path::{Path, PathBuf};

use cdpr_core::model::Joints;
use cdpr_core::model::spec::MotionSpec;
use cdpr_files::MessageFields;
use clap::{Args, ValueHint};

use super::given_options::GivenOptions;
use super::shared::{CheckerArgs, PathArgs, SceneArgs, Strict, TensionArgs};
use super::values::{POSITION, choice, not_negative, positive};

/// Limits of a timed motion instead of those in the scene's `[motion]`.
#[derive(Debug, Clone, Copy, Args)]
pub struct LimitArgs {
    /// Largest speed of the platform instead of the scene's, m/s.
    #[arg(long, value_name = "V", value_parser = positive, allow_negative_numbers = true)]
    pub speed: Option<f64>,
    /// Largest acceleration of the platform instead of the scene's, m/s².
    #[arg(long, value_name = "A", value_parser = positive, allow_negative_numbers = true)]
    pub acceleration: Option<f64>,
    /// Largest angular speed of a platform that turns instead of the scene's, rad/s.
    #[arg(long, value_name = "W", value_parser = positive, allow_negative_numbers = true)]
    pub turn_speed: Option<f64>,
    /// Largest angular acceleration of a platform that turns instead of the scene's, rad/s².
    #[arg(long, value_name = "A", value_parser = positive, allow_negative_numbers = true)]
    pub turn_acceleration: Option<f64>,
    /// Largest jerk of the platform instead of the scene's, m/s³.
    #[arg(long, value_name = "J", value_parser = positive, allow_negative_numbers = true)]
    pub jerk: Option<f64>,
    /// Largest speed at which a cable is wound or unwound instead of the scene's, m/s.
    #[arg(long, value_name = "V", value_parser = positive, allow_negative_numbers = true)]
    pub cable_speed: Option<f64>,
    /// Largest acceleration of a cable instead of the scene's, m/s².
    #[arg(long, value_name = "A", value_parser = positive, allow_negative_numbers = true)]
    pub cable_acceleration: Option<f64>,
    /// Largest deviation from the path where corners are rounded instead of the scene's `blend`, m [default: the scene's clearance].
    #[arg(long, value_name = "M", value_parser = not_negative, allow_negative_numbers = true)]
    pub blend: Option<f64>,
    /// Largest clearance that the motion keeps instead of the scene's `clearance` and of larger ones of kinds and pairs, m.
    #[arg(long, value_name = "M", value_parser = not_negative, allow_negative_numbers = true)]
    pub motion_clearance: Option<f64>,
    /// Capacity margin that the cables keep besides the inertia of the platform instead of the scene's, N [default: 0].
    #[arg(long, value_name = "N", value_parser = not_negative, allow_negative_numbers = true)]
    pub wrench_margin: Option<f64>,
}

impl LimitArgs {
    pub fn spec(self) -> MotionSpec {
        MotionSpec {
            speed: self.speed,
            acceleration: self.acceleration,
            turn_speed: self.turn_speed,
            turn_acceleration: self.turn_acceleration,
            jerk: self.jerk,
            cable_speed: self.cable_speed,
            cable_acceleration: self.cable_acceleration,
            blend: self.blend,
            clearance: self.motion_clearance,
            wrench_margin: self.wrench_margin,
        }
    }
}

/// How a motion is timed.
#[derive(Debug, Clone, Copy, Args)]
pub struct TimingArgs {
    /// Samples per second [default: 100, or more for accelerations beyond 8 m/s²: straight lines between samples are within 0.1 mm of
    /// the motion].
    #[arg(long, value_name = "HZ", value_parser = positive, allow_negative_numbers = true)]
    pub rate: Option<f64>,
    /// What the joints of a ROS 2 message (.yaml) are [default: length].
    #[arg(long, value_name = "JOINTS", value_parser = choice::<Joints>())]
    pub joints: Option<Joints>,
    /// In a ROS 2 message (.yaml), also write the tensions as effort, or the torques if joints are angles; controllers of positions
    /// refuse such messages.
    #[arg(long)]
    pub effort: bool,
    #[command(flatten)]
    pub limits: LimitArgs,
}

impl TimingArgs {
    /// The fields of a ROS 2 message.
    pub fn fields(&self) -> MessageFields {
        MessageFields { joints: self.joints, effort: self.effort }
    }
}

#[derive(Debug, Args)]
pub struct CheckArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Path file: JSON as written by `plan`, or CSV with the header x,y,z (x,y,z,qw,qx,qy,qz if the platform turns). Also a
    /// trajectory, JSON as written by `trajectory` or CSV with at least the columns t,x,y,z, a proof as written by `plan
    /// --proof`, or the task.json of `task`.
    #[arg(value_hint = ValueHint::FilePath, required_unless_present = "at")]
    pub path: Option<PathBuf>,
    /// Check a station, or a position of the platform's origin, m, instead of a path: everything that is wrong with it, worst first, and a
    /// valid position near it.
    #[arg(long, num_args = 1..=3, value_name = POSITION, allow_negative_numbers = true, conflicts_with = "path")]
    pub at: Option<Vec<String>>,
    /// With --at: how far the suggested position is inside the valid ones, m [default: 0.001].
    #[arg(long, value_name = "M", value_parser = not_negative, allow_negative_numbers = true)]
    pub margin: Option<f64>,
    /// Start that a proof is about, instead of the scene's: the name of a station, or a position, m.
    #[arg(long, num_args = 1..=3, value_name = POSITION, allow_negative_numbers = true)]
    pub start: Option<Vec<String>>,
    /// Goal that a proof is about, instead of the scene's: the name of a station, or a position, m.
    #[arg(long, num_args = 1..=3, value_name = POSITION, allow_negative_numbers = true)]
    pub goal: Option<Vec<String>>,
    #[command(flatten)]
    pub strict: Strict,
    #[command(flatten)]
    pub checker: CheckerArgs,
    #[command(flatten)]
    pub limits: LimitArgs,
    #[command(flatten)]
    pub tensions: TensionArgs,
}

impl CheckArgs {
    /// These arguments for another file.
    pub fn of_file(&self, path: &Path) -> PathArgs {
        PathArgs { scene: self.scene.clone(), path: path.to_path_buf(), strict: self.strict, checker: self.checker }
    }
}

#[derive(Debug, Args)]
pub struct TrajectoryArgs {
    #[command(flatten)]
    pub given: GivenOptions,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Path file: JSON as written by `plan`, or CSV with the header x,y,z (x,y,z,qw,qx,qy,qz if the platform turns).
    #[arg(value_hint = ValueHint::FilePath)]
    pub path: PathBuf,
    /// Write the trajectory here (.json; .csv for the samples; .yaml for a ROS 2 JointTrajectory of the cables).
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub strict: Strict,
    #[command(flatten)]
    pub timing: TimingArgs,
    #[command(flatten)]
    pub tensions: TensionArgs,
}
