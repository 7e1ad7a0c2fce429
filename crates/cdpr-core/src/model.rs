//! Robots, obstacles and scenes: as plain data from files (`spec`), and checked (`robot`, `scene`).

pub mod body;
mod carrying;
mod doubts;
mod drum;
mod envelope;
pub mod inertia;
mod load_case;
mod most_tension;
pub(crate) mod obstacle;
mod obstacle_clearance;
mod obstacle_seams;
pub(crate) mod pairs;
mod payload;
mod payloads;
mod query;
pub(crate) mod robot;
pub mod scene;
pub mod spec;
mod task_rows;
mod winch;

pub(crate) use doubts::{doubts, exceeded_clearance};
pub use drum::Drum;
pub use envelope::{Envelope, Sag};
pub use load_case::LoadCase;
pub use obstacle::Obstacle;
pub use pairs::{Member, PairRule, PairRules};
pub use payload::Payload;
pub(crate) use payload::index as payload_index;
pub use query::Station;
pub use robot::{Cable, Robot};
pub use scene::{AlikeNotes, Scene};
pub use spec::{
    BodySpec, CableDefaultsSpec, CableSpec, ClearancesSpec, Distribution, DrumSpec, GRAVITY, InertiaSpec, MarginSpec,
    MembershipSpec, MeshSource, MeshSpec, OrientationSource, OrientationSpec, PairClearanceSpec, PayloadSpec,
    PositionSource, PrismSpec, PulleySpec, QuerySpec, RobotSource, RobotSpec, RuleSpec, SceneSpec, StationSpec,
    TaskRowSpec, Unit, WorkspaceSpec, WrenchSpec,
};
pub use task_rows::{Action, Stop, Stops};
pub use winch::{CommandRows, Commands, Joints};
