//! The file formats as plain data: one set of types for TOML, JSON and the JSON Schema. Nothing here is checked beyond
//! its shape; [`crate::model::Robot`] and [`crate::model::Scene`] do that once.

use crate::choices;
use crate::fixed_length;
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de};

/// Reads what is a path or a table. By hand: an untagged derive would answer a misspelt key with "did not match any
/// variant".
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

/// The name that stands for the platform in messages, and in pairs such as those of `ignore`.
pub const PLATFORM: &str = "platform";

/// A scene: robot, obstacles, workspace, and the question asked of them. Lengths in m, world axes, z up by custom.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", schemars(title = "cdpr scene"))]
pub struct SceneSpec {
    /// Version of the format, 1.
    pub version: u32,
    /// A name for messages and pictures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Gravity in world axes, m/s²; default (0, 0, -9.81).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gravity: Option<[f64; 3]>,
    /// Least distance to keep between whatever must not touch, m; default 0. `clearances` overrides it by kind and by pair.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance: Option<f64>,
    /// Pairs that are not checked against each other, by name: a cable's, an obstacle's, or "platform".
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ignore: Vec<[String; 2]>,
    /// Pairs that may touch but not enter each other, named as in `ignore`: no clearance is demanded of them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub touch: Vec<[String; 2]>,
    /// Clearances of some kinds or pairs, in place of `clearance`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearances: Option<ClearancesSpec>,
    /// The box that every platform vertex must stay in.
    pub workspace: WorkspaceSpec,
    /// Named ways to turn the platform. Where the query says none, planning takes the one with the shortest path, what
    /// reads a path that of the path, and everything else the first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub orientations: Vec<OrientationSpec>,
    /// The robot: a table, or the path of a robot file relative to the scene file.
    pub robot: RobotSource,
    /// Convex obstacle parts; parts of one concave body carry the same name.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<BodySpec>,
    /// Demand of wrench feasibility; its presence turns the constraint on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wrench: Option<WrenchSpec>,
    /// Start, goal and orientation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub query: Option<QuerySpec>,
}

/// Clearances that differ from the scene's `clearance`. A pair's own comes before that of its kind.
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
    /// Between cables and parts of the platform that they do not end on, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_platform: Option<f64>,
    /// Between two cables, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_cable: Option<f64>,
    /// Between two members by name.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<PairClearanceSpec>,
}

/// The clearance of one pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PairClearanceSpec {
    /// Two names: a cable's, an obstacle's, or "platform".
    pub between: [String; 2],
    /// Least distance to keep, m.
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

/// A robot in place, or the path of its file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(untagged)]
pub enum RobotSource {
    /// Path of a robot file (TOML or JSON), relative to the scene file.
    File(String),
    /// The robot itself.
    Inline(RobotSpec),
}

file_or_inline!(RobotSource, RobotSpec, "a robot table or the path of a robot file");

/// A cable robot: platform and cables.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", schemars(title = "cdpr robot"))]
pub struct RobotSpec {
    /// Version of the format, 1; only in a robot file of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<u32>,
    /// A name for messages and pictures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Mass of the platform, kg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Centre of mass in the platform frame, m; default the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub center_of_mass: Option<[f64; 3]>,
    /// Convex parts of the platform, in the platform frame; they may be flat, a segment or a point.
    pub platform: Vec<BodySpec>,
    /// Cables.
    pub cables: Vec<CableSpec>,
}

/// A straight cable between a fixed outlet and an attachment on the platform.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CableSpec {
    /// A name for messages; default "cable K", counting from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Where the cable leaves the frame, world, m.
    pub outlet: [f64; 3],
    /// Where it meets the platform, platform frame, m.
    pub attachment: [f64; 3],
    /// Least and largest tension, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<[f64; 2]>,
    /// Diameter, m; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diameter: Option<f64>,
    /// Least and largest length between outlet and attachment, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<[f64; 2]>,
}

/// A body: exactly one of `box`, `vertices`, `prism` (convex ones) and `mesh` (any), then turned and moved.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct BodySpec {
    /// A name for messages; obstacle parts of the same name form one body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Full side lengths of a box centred at the origin, m.
    #[serde(default, rename = "box", skip_serializing_if = "Option::is_none")]
    pub cuboid: Option<[f64; 3]>,
    /// Corners of a convex body in any order, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<[f64; 3]>>,
    /// An upright prism over a convex polygon.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub prism: Option<PrismSpec>,
    /// A triangle mesh: an STL or OBJ file, relative to the file that names it, or vertices and triangles. It stands
    /// for convex parts that cover it; one that is convex stands as it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh: Option<MeshSource>,
    /// Unit of the mesh's coordinates; default m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub units: Option<Unit>,
    /// Factor of the mesh's coordinates, besides their unit; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<f64>,
    /// How far the convex parts of the mesh may reach beyond it, m; default 1 % of the extent of each connected piece, and
    /// at least 0.25 % of the whole mesh's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Added to every point after turning, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<[f64; 3]>,
    /// Roll, pitch and yaw, rad: R = Rz(yaw) Ry(pitch) Rx(roll).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rpy: Option<[f64; 3]>,
    /// The same in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rpy_degrees: Option<[f64; 3]>,
    /// The turn as a unit quaternion, w x y z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quaternion: Option<[f64; 4]>,
}

/// The path of a mesh file, or a mesh in place.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(untagged)]
pub enum MeshSource {
    /// Path of an STL or OBJ file, relative to the scene or robot file.
    File(String),
    /// The mesh itself.
    Inline(MeshSpec),
}

file_or_inline!(MeshSource, MeshSpec, "the path of a mesh file (.stl or .obj), or a table of vertices and triangles");

/// A triangle mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MeshSpec {
    /// Corners, in the mesh's unit.
    pub vertices: Vec<[f64; 3]>,
    /// Corners of each triangle, counter-clockwise seen from outside, as indices from 0 into the vertices.
    pub triangles: Vec<[usize; 3]>,
}

/// Unit of a mesh's coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Unit {
    /// Millimetre.
    Mm,
    /// Centimetre.
    Cm,
    /// Metre.
    M,
    /// Inch.
    In,
    /// Foot.
    Ft,
}

choices!(Unit, "unit", [
    Mm = "mm": "Millimetre",
    Cm = "cm": "Centimetre",
    M = "m": "Metre",
    In = "in": "Inch",
    Ft = "ft": "Foot",
]);

impl Unit {
    /// One of it in metres.
    pub fn metres(self) -> f64 {
        match self {
            Unit::Mm => 1e-3,
            Unit::Cm => 1e-2,
            Unit::M => 1.0,
            Unit::In => 0.0254,
            Unit::Ft => 0.3048,
        }
    }
}

/// An upright prism from z = 0 to z = height.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PrismSpec {
    /// Corners of the convex base, m.
    pub base: Vec<[f64; 2]>,
    /// Height, m.
    pub height: f64,
}

/// The wrenches that the cables must be able to balance all along a path.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct WrenchSpec {
    /// Radius of the required force ball, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// Radius of the required moment ball, N·m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
    /// Corners of a required polytope instead of the balls, each fx fy fz mx my mz, N and N·m, on top of the wrench
    /// that balances the loads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<[f64; 6]>>,
    /// A further constant load, world axes, its moment about the platform's origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<[f64; 6]>,
    /// Which margin decides; default capacity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub margin: Option<MarginSpec>,
    /// How a motion is judged; default certified.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule: Option<RuleSpec>,
    /// Cell size of the grid rule, m; default 0.05.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grid: Option<f64>,
    /// Which points of the grid decide about a position; default corners.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub membership: Option<MembershipSpec>,
    /// Length that turns moments into forces, m; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub characteristic_length: Option<f64>,
}

/// Which margin decides on wrench feasibility.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum MarginSpec {
    /// The rigorous one, on the 6-D set.
    Capacity,
    /// The paper's: force part and moment part each on its own.
    Projected,
}

/// How wrench feasibility of a motion is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum RuleSpec {
    /// Every point of the motion is proved.
    Certified,
    /// The cells of a grid that the motion crosses.
    Grid,
}

/// Which points of a grid decide about a position.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum MembershipSpec {
    /// All eight corners of its cell.
    #[default]
    Corners,
    /// The point nearest to it. The paper's.
    Nearest,
}

/// What is asked: from where to where, and how the platform is turned all the way.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct QuerySpec {
    /// Position of the platform's origin at the start, world, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<[f64; 3]>,
    /// Position of the platform's origin at the goal, world, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal: Option<[f64; 3]>,
    /// How the platform is turned all the way: a world-from-platform unit quaternion, w x y z, or the name of one of the
    /// scene's orientations; default no turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationSource>,
}

/// A way to turn the platform, world-from-platform.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct OrientationSpec {
    /// Its name.
    pub name: String,
    /// Roll, pitch and yaw, rad: R = Rz(yaw) Ry(pitch) Rx(roll).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rpy: Option<[f64; 3]>,
    /// The same in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rpy_degrees: Option<[f64; 3]>,
    /// The turn as a unit quaternion, w x y z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quaternion: Option<[f64; 4]>,
}

/// An orientation by name or in place.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(untagged)]
pub enum OrientationSource {
    /// One of the scene's orientations.
    Named(String),
    /// A unit quaternion, w x y z.
    Quaternion([f64; 4]),
}

impl From<[f64; 4]> for OrientationSource {
    fn from(quaternion: [f64; 4]) -> Self {
        OrientationSource::Quaternion(quaternion)
    }
}

impl<'de> Deserialize<'de> for OrientationSource {
    // By hand, as files in `file_or_inline`.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = OrientationSource;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("a unit quaternion [w, x, y, z] or the name of an orientation")
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<OrientationSource, E> {
                Ok(OrientationSource::Named(name.to_string()))
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, seq: A) -> Result<OrientationSource, A::Error> {
                fixed_length::from_seq(seq).map(OrientationSource::Quaternion)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}
