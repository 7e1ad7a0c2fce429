//! The file formats as plain data: one set of types for TOML, JSON and the JSON Schema. Only the structure is checked
//! here; [`crate::model::Robot`] and [`crate::model::Scene`] check the values, once.

use crate::choices;
use crate::fixed_length;
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

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
    /// The robot: a table, or the path of a robot file relative to the scene file.
    pub robot: RobotSource,
    /// Convex obstacle parts; the parts of a concave body share one name.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<BodySpec>,
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

/// An inline robot, or the path of its file.
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
    /// Version of the format, 1; only in a separate robot file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<u32>,
    /// Name used in messages and figures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Mass of the platform, kg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Centre of mass in the platform frame, m; default the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub center_of_mass: Option<[f64; 3]>,
    /// Inertia of the platform about its centre of mass, platform axes, kg·m²: [Ixx, Iyy, Izz], or the rows of the symmetric
    /// tensor; default that of its parts at uniform density. It matters for timed motions on which the platform turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<InertiaSpec>,
    /// Convex parts of the platform, in the platform frame; a part may be flat, a segment or a point.
    pub platform: Vec<BodySpec>,
    /// Cables.
    pub cables: Vec<CableSpec>,
}

/// The inertia of a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(untagged)]
pub enum InertiaSpec {
    /// Ixx, Iyy and Izz; the products of inertia are zero.
    Diagonal([f64; 3]),
    /// The rows of the tensor.
    Tensor([[f64; 3]; 3]),
}

/// A number of a diagonal, or a row of a tensor.
enum InertiaEntry {
    Number(f64),
    Row([f64; 3]),
}

impl<'de> Deserialize<'de> for InertiaEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = InertiaEntry;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("a number, or a row of three numbers")
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<InertiaEntry, E> {
                Ok(InertiaEntry::Number(number))
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<InertiaEntry, E> {
                Ok(InertiaEntry::Number(number as f64))
            }

            fn visit_u64<E: de::Error>(self, number: u64) -> Result<InertiaEntry, E> {
                Ok(InertiaEntry::Number(number as f64))
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, seq: A) -> Result<InertiaEntry, A::Error> {
                fixed_length::from_seq(seq).map(InertiaEntry::Row)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

impl<'de> Deserialize<'de> for InertiaSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        use InertiaEntry::{Number, Row};
        let entries = <[InertiaEntry; 3]>::deserialize(fixed_length::FixedLength(deserializer))?;
        match entries {
            [Number(x), Number(y), Number(z)] => Ok(InertiaSpec::Diagonal([x, y, z])),
            [Row(x), Row(y), Row(z)] => Ok(InertiaSpec::Tensor([x, y, z])),
            _ => Err(de::Error::custom(
                "found numbers and rows, expected [Ixx, Iyy, Izz] or three rows of three numbers",
            )),
        }
    }
}

/// A straight cable between a fixed outlet and an attachment on the platform.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CableSpec {
    /// Name used in messages; default "cable K", counting from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Where the cable leaves the frame, world, m.
    pub outlet: [f64; 3],
    /// Where the cable is attached to the platform, platform frame, m.
    pub attachment: [f64; 3],
    /// Minimum and maximum tension, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<[f64; 2]>,
    /// Diameter, m; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diameter: Option<f64>,
    /// Minimum and maximum length between outlet and attachment, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<[f64; 2]>,
}

/// A body: exactly one of `box`, `vertices` and `prism` (convex shapes) or `mesh` (any shape), then rotated and
/// translated.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct BodySpec {
    /// Name used in messages; obstacle parts with the same name form one body.
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
    /// A triangle mesh: an STL or OBJ file, relative to the file that contains this table, or vertices and triangles. A
    /// mesh that is not convex is replaced by convex parts that cover it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh: Option<MeshSource>,
    /// Unit of the mesh's coordinates; default m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub units: Option<Unit>,
    /// Factor applied to the mesh's coordinates, in addition to their unit; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<f64>,
    /// How far the convex parts may extend beyond the mesh, m; default 1 % of the extent of each connected piece, and
    /// at least 0.25 % of the extent of the whole mesh.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Added to every point after the rotation, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<[f64; 3]>,
    /// Roll, pitch and yaw, rad: R = Rz(yaw) Ry(pitch) Rx(roll).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rpy: Option<[f64; 3]>,
    /// The same in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rpy_degrees: Option<[f64; 3]>,
    /// The rotation as a unit quaternion, w x y z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quaternion: Option<[f64; 4]>,
}

/// The path of a mesh file, or an inline mesh.
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
    /// Corners of each triangle as indices into the vertices, from 0, counter-clockwise seen from outside.
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
    /// Length of the unit in metres.
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

/// The wrenches that the cables must be able to balance along the whole path.
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
    /// An additional constant load, world axes, with its moment about the platform's origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<[f64; 6]>,
    /// The margin that decides feasibility; default capacity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub margin: Option<MarginSpec>,
    /// How a motion is checked; default certified.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule: Option<RuleSpec>,
    /// Cell size of the grid rule, m; default 0.05.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grid: Option<f64>,
    /// The grid points that decide the feasibility of a position; default corners.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub membership: Option<MembershipSpec>,
    /// Length that converts moments to forces, m; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub characteristic_length: Option<f64>,
}

/// The margin that decides wrench feasibility.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum MarginSpec {
    /// The rigorous margin of the six-dimensional wrench set.
    Capacity,
    /// The paper's margin: forces and moments separately.
    Projected,
}

/// How the wrench feasibility of a motion is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum RuleSpec {
    /// Every point of the motion is proved feasible.
    Certified,
    /// The grid cells that the motion crosses are checked.
    Grid,
}

/// The grid points that decide the feasibility of a position.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum MembershipSpec {
    /// All eight corners of its cell.
    #[default]
    Corners,
    /// The nearest grid point, as in the paper.
    Nearest,
}

/// The planning query: start, goal, and the orientation held along the whole path.
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
    /// Orientation held along the whole path: a world-from-platform unit quaternion, w x y z, or the name of one of the
    /// scene's orientations; default: no rotation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationSource>,
    /// Orientation at the start if the platform turns on its way; default `orientation`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start_orientation: Option<OrientationSource>,
    /// Orientation at the goal if the platform turns on its way; default `orientation`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal_orientation: Option<OrientationSource>,
}

/// How the platform may turn on its way.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TurningSpec {
    /// "free" for turns about any axis, or the only axis, world, about which the platform may be turned from the scene's
    /// orientation; default "free".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<TurningAxis>,
    /// Largest angle between the vertical and the line of the platform that is vertical at the scene's orientation,
    /// degrees; default 180.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_tilt: Option<f64>,
    /// Length of a turn by one radian, m; default the distance from the platform's origin to its farthest corner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
}

/// The axes about which the platform may turn.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[cfg_attr(feature = "schema", schemars(untagged))]
pub enum TurningAxis {
    /// Any: "free".
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    Free,
    /// Only this one, world.
    Fixed([f64; 3]),
}

/// The name of [`TurningAxis::Free`].
const FREE: &str = "free";

impl Serialize for TurningAxis {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            TurningAxis::Free => serializer.serialize_str(FREE),
            TurningAxis::Fixed(axis) => axis.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for TurningAxis {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = TurningAxis;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("\"free\" or an axis [x, y, z]")
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<TurningAxis, E> {
                if name == FREE {
                    Ok(TurningAxis::Free)
                } else {
                    Err(E::invalid_value(de::Unexpected::Str(name), &self))
                }
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, seq: A) -> Result<TurningAxis, A::Error> {
                fixed_length::from_seq(seq).map(TurningAxis::Fixed)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

/// Limits of timed motions; all are optional. Tensions are limited by those of the cables.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MotionSpec {
    /// Largest speed of the platform, m/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Largest acceleration of the platform, m/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<f64>,
    /// Largest angular speed of a platform that turns, rad/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_speed: Option<f64>,
    /// Largest angular acceleration of a platform that turns, rad/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_acceleration: Option<f64>,
    /// Largest jerk of the platform, m/s³; needs an acceleration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jerk: Option<f64>,
    /// Largest speed at which a cable is wound or unwound, m/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_speed: Option<f64>,
    /// Largest acceleration of a cable, m/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_acceleration: Option<f64>,
    /// Largest deviation from the path where corners are rounded, m; default the scene's clearance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blend: Option<f64>,
    /// Capacity margin that the cables keep in addition to the inertia of the platform, N; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wrench_margin: Option<f64>,
}

impl MotionSpec {
    /// These limits and, where they are not set, those of another table.
    pub fn over(&self, other: Option<&MotionSpec>) -> Self {
        let other = other.copied().unwrap_or_default();
        MotionSpec {
            speed: self.speed.or(other.speed),
            acceleration: self.acceleration.or(other.acceleration),
            turn_speed: self.turn_speed.or(other.turn_speed),
            turn_acceleration: self.turn_acceleration.or(other.turn_acceleration),
            jerk: self.jerk.or(other.jerk),
            cable_speed: self.cable_speed.or(other.cable_speed),
            cable_acceleration: self.cable_acceleration.or(other.cable_acceleration),
            blend: self.blend.or(other.blend),
            wrench_margin: self.wrench_margin.or(other.wrench_margin),
        }
    }
}

/// A named orientation of the platform, world-from-platform.
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
    /// The rotation as a unit quaternion, w x y z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quaternion: Option<[f64; 4]>,
}

/// The name of an orientation, or a quaternion.
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
    // Written by hand for the same reason as `file_or_inline`.
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
