//! Robots, obstacles and scenes: what files say (`spec`), and what holds once it has been checked (`robot`, `scene`).

pub mod body;
pub mod robot;
pub mod scene;
pub mod spec;

pub use robot::{Cable, Robot};
pub use scene::{GRAVITY, Member, Obstacle, Scene};
pub use spec::{
    BodySpec, CableSpec, MarginSpec, MeshSource, MeshSpec, OrientationSource, OrientationSpec, PrismSpec, QuerySpec,
    RobotSource, RobotSpec, RuleSpec, SceneSpec, Unit, WorkspaceSpec, WrenchSpec,
};
