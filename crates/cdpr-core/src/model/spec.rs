//! The file formats as plain data: one set of types for TOML, JSON and the JSON Schema. Only the structure is checked
//! here; [`crate::model::Robot`] and [`crate::model::Scene`] check the values, once.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mod payload_spec;
mod query_spec;
mod robot_spec;

pub use payload_spec::{PayloadSpec, TaskRowSpec};
pub use query_spec::{
    MarginSpec, MembershipSpec, MotionSpec, OrientationSource, OrientationSpec, PositionSource, QuerySpec, RuleSpec,
    StationSpec, TurningAxis, TurningSpec, WrenchSpec,
};
pub use robot_spec::{
    BodySpec, CableDefaultsSpec, CableSpec, Distribution, DrumSpec, InertiaSpec, MeshSource, MeshSpec, PrismSpec,
    PulleySpec, RobotSource, RobotSpec, Unit,
};

/// Deserializes a file name or a table. Written by hand, because an untagged derive reports a misspelt key as "did not
/// match any variant".
#[doc(hidden)]
#[macro_export]
macro_rules! file_or_inline {
    ($source:ident, $table:ty, $expecting:literal) => {
        impl<'de> serde::Deserialize<'de> for $source {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Visitor;
                impl<'de> serde::de::Visitor<'de> for Visitor {
                    type Value = $source;

                    fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                        f.write_str($expecting)
                    }

                    fn visit_str<E: serde::de::Error>(self, path: &str) -> Result<$source, E> {
                        Ok($source::File(path.to_string()))
                    }

                    fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<$source, A::Error> {
                        <$table>::deserialize(serde::de::value::MapAccessDeserializer::new(map)).map($source::Inline)
                    }
                }
                deserializer.deserialize_any(Visitor)
            }
        }
    };
}

/// The version of the scene, robot and path formats that this program reads and writes.
pub const FORMAT_VERSION: u32 = 1;

/// Default gravity, world axes, m/s².
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// The name of the platform in messages and in pairs such as those of `ignore`.
pub const PLATFORM: &str = "platform";

/// A scene: robot, obstacles, workspace and planning query. Lengths in m, world axes, z up by convention.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", schemars(title = "cdpr scene"))]
pub struct SceneSpec {
    /// Version of the format, 1.
    pub version: u32,
    /// Name used in messages and figures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Gravity in world axes, m/s²; default (0, 0, -9.81).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gravity: Option<[f64; 3]>,
    /// Minimum distance between bodies that must not touch, m; default 0. `clearances` overrides it for kinds and
    /// pairs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance: Option<f64>,
    /// Pairs that are not checked against each other, by name: of a cable, of an obstacle, or "platform".
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ignore: Vec<[String; 2]>,
    /// Pairs that may touch but not overlap, named as in `ignore`; no clearance is required between them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub touch: Vec<[String; 2]>,
    /// Clearances of particular kinds or pairs, instead of `clearance`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearances: Option<ClearancesSpec>,
    /// The box in which every platform vertex must stay.
    pub workspace: WorkspaceSpec,
    /// Named orientations of the platform. If the query selects none, planning uses the one with the shortest path, a
    /// command that reads a path uses the path's orientation, and everything else uses the first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub orientations: Vec<OrientationSpec>,
    /// Named positions of the platform, for starts and goals.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stations: Vec<StationSpec>,
    /// The robot: a table, or the path of a robot file relative to the scene file.
    pub robot: RobotSource,
    /// Convex obstacle parts; the parts of a concave body share one name.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<BodySpec>,
    /// What the platform can carry.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub payloads: Vec<PayloadSpec>,
    /// What the platform is to do, row by row; it begins at the start of the query or, without one, where the first row goes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub task: Vec<TaskRowSpec>,
    /// Requirements on wrench feasibility; this table, even if empty, turns the constraint on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wrench: Option<WrenchSpec>,
    /// Start, goal and orientation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub query: Option<QuerySpec>,
    /// Limits of timed motions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionSpec>,
    /// How the platform may turn on its way; without this table it turns only if start and goal differ in orientation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turning: Option<TurningSpec>,
}

/// Clearances that differ from the scene's `clearance`. A clearance for a pair takes precedence over that of its kind.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ClearancesSpec {
    /// Between the platform and obstacles, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub platform_obstacle: Option<f64>,
    /// Between cables and obstacles, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_obstacle: Option<f64>,
    /// Between cables and the parts of the platform to which they are not attached, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_platform: Option<f64>,
    /// Between two cables, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_cable: Option<f64>,
    /// Between two named bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<PairClearanceSpec>,
}

impl ClearancesSpec {
    /// Lowers clearances that are larger than this one, m.
    pub fn limit(&mut self, most: f64) {
        let kinds =
            [&mut self.platform_obstacle, &mut self.cable_obstacle, &mut self.cable_platform, &mut self.cable_cable];
        let pairs = self.pairs.iter_mut().map(|pair| &mut pair.clearance);
        kinds.into_iter().flatten().chain(pairs).for_each(|clearance| *clearance = clearance.min(most));
    }
}

/// The clearance of one pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PairClearanceSpec {
    /// Two names: of cables, of obstacles, or "platform".
    pub between: [String; 2],
    /// Minimum distance, m.
    pub clearance: f64,
}

/// An axis-aligned box in the world, m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct WorkspaceSpec {
    /// Smallest coordinates, m.
    pub min: [f64; 3],
    /// Largest coordinates, m.
    pub max: [f64; 3],
}
