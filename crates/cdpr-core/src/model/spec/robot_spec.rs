//! The parts of a robot file: the bodies of the platform, the cables, and meshes.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de};

use crate::{choices, file_or_inline, fixed_length};

/// An inline robot, or the path of its file.
// There is one for each scene, so its size does not matter.
#[allow(clippy::large_enum_variant)]
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
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
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
    /// What all cables have in common: values for those that do not give their own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable: Option<CableDefaultsSpec>,
    /// Which of all tensions that balance the loads the controller keeps; default `middle`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension_distribution: Option<Distribution>,
}

/// Which of all tensions within the limits that balance the loads are chosen.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Distribution {
    /// The nearest to the middle of the limits: the smallest sum of squared deviations.
    #[default]
    Middle,
    /// The smallest: the smallest sum of squares.
    Least,
    /// The smallest sum of fourth powers of the deviations from the middle of the limits, so that few come near a limit.
    P4,
    /// The smallest sum of eighth powers of the deviations from the middle of the limits.
    P8,
    /// Those of `middle` without regard to limits, and none where they exceed one.
    ClosedForm,
}

choices!(Distribution, "tension distribution", [
    Middle = "middle": "The nearest to the middle of the limits",
    Least = "least": "The smallest",
    P4 = "p4": "The smallest 4-norm of the deviations from the middle, so that few come near a limit",
    P8 = "p8": "The smallest 8-norm of the deviations from the middle",
    ClosedForm = "closed-form": "Those of `middle` without regard to limits, and none where they exceed one",
]);

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

/// A cable between an outlet and an attachment on the platform: straight, unless it has a `linear_density`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
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
    /// Mass per length, kg/m; the cable then sags. Default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub linear_density: Option<f64>,
    /// The tension at the platform that the controller keeps at least, N, which limits the sag; default the minimum tension.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sag_tension: Option<f64>,
    /// The true outlet is at most this far from the given one, m; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outlet_error: Option<f64>,
    /// The last pulley; by default, the outlet is a fixed point.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulley: Option<PulleySpec>,
    /// Axial stiffness E A of the cable, N; by default it does not stretch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// The drum of the winch, for angles and torques of the motor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drum: Option<DrumSpec>,
}

/// Values of all cables that do not give their own.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CableDefaultsSpec {
    /// Mass per length, kg/m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub linear_density: Option<f64>,
    /// The tension at the platform that the controller keeps at least, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sag_tension: Option<f64>,
    /// The true outlet is at most this far from the given one, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outlet_error: Option<f64>,
    /// The last pulley.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulley: Option<PulleySpec>,
    /// Axial stiffness E A, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// The drum of the winch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drum: Option<DrumSpec>,
}

/// The last pulley of a cable. The cable meets the groove at the outlet, running in the direction of `axis`, and goes round the
/// wheel from there; the wheel swivels about `axis` through the outlet, its centre always on the side of the attachment.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PulleySpec {
    /// Radius from the axle to the middle of the cable, m.
    pub radius: f64,
    /// Direction of the swivel axis and of the arriving cable, world; any length.
    pub axis: [f64; 3],
}

/// The drum of a winch and the gear to its motor. The motor's angle, rad, is `gear` (commanded length − `zero`) / `radius`: with a
/// positive `gear` it grows while the cable is let out. The torque of a tension about the motor's axis is tension · `radius` / `gear`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DrumSpec {
    /// Radius from the axis of the drum to the middle of the cable, m.
    pub radius: f64,
    /// Turns of the motor for one turn of the drum, negative if positive angles of the motor wind the cable in; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gear: Option<f64>,
    /// Length of the cable at which the motor's angle is 0, m; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zero: Option<f64>,
    /// Length of the cable between drum and outlet, which stretches as well, m; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lead: Option<f64>,
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
    /// Roll, pitch and yaw, degrees.
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
