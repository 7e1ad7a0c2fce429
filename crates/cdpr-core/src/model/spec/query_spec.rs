//! The parts of a scene file that pose the question: start, goal and orientations, turning, motion limits, and required
//! wrenches.

use std::fmt;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::fixed_length;
use crate::geometry::Point;

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
    /// Several constant loads instead of `load`; everything is certified for each of them, and tensions are those for
    /// the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loads: Option<Vec<[f64; 6]>>,
    /// A mass carried at the platform's centre of mass, kg; everything is certified without it and with it, and tensions are those
    /// without it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub payload: Option<f64>,
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
    /// The margin of the six-dimensional wrench set, which takes forces and moments together.
    Capacity,
    /// The paper's margin: forces and moments separately.
    Projected,
}

/// How the wrench feasibility of a motion is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum RuleSpec {
    /// Every point of the motion is checked, by bounds between positions with bounds of rounding errors.
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
    /// Position of the platform's origin at the start, world, m, or the name of a station.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<PositionSource>,
    /// Position of the platform's origin at the goal, world, m, or the name of a station.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal: Option<PositionSource>,
    /// Orientation held along the whole path: a world-from-platform unit quaternion, w x y z, or the name of one of the
    /// scene's orientations; default: no rotation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationSource>,
    /// Orientation at the start if the platform turns on its way; default that of the station, else `orientation`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start_orientation: Option<OrientationSource>,
    /// Orientation at the goal if the platform turns on its way; default that of the station, else `orientation`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal_orientation: Option<OrientationSource>,
}

impl QuerySpec {
    /// From one position to another.
    pub fn between(start: impl Into<PositionSource>, goal: impl Into<PositionSource>) -> Self {
        QuerySpec { start: Some(start.into()), goal: Some(goal.into()), ..QuerySpec::default() }
    }
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

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
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
    /// Largest jerk of the platform, m/s³.
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
    /// Largest clearance that motions keep, m; default those of the scene. It takes the place of the scene's `clearance`, and of
    /// the clearances of kinds and pairs that are larger.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance: Option<f64>,
    /// Capacity margin that the cables keep in addition to the inertia of the platform, N; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wrench_margin: Option<f64>,
}

impl MotionSpec {
    /// These limits and, where they are not set, those of another table.
    pub fn over(mut self, other: Option<&MotionSpec>) -> Self {
        let mut other = other.copied().unwrap_or_default();
        for ((_, mine), (_, theirs)) in self.entries().into_iter().zip(other.entries()) {
            *mine = mine.or(*theirs);
        }
        self
    }

    /// Every limit with its key.
    pub fn entries(&mut self) -> [(&'static str, &mut Option<f64>); 10] {
        [
            ("speed", &mut self.speed),
            ("acceleration", &mut self.acceleration),
            ("turn_speed", &mut self.turn_speed),
            ("turn_acceleration", &mut self.turn_acceleration),
            ("jerk", &mut self.jerk),
            ("cable_speed", &mut self.cable_speed),
            ("cable_acceleration", &mut self.cable_acceleration),
            ("blend", &mut self.blend),
            ("clearance", &mut self.clearance),
            ("wrench_margin", &mut self.wrench_margin),
        ]
    }
}

/// A named orientation of the platform, world-from-platform.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct OrientationSpec {
    /// Name of the orientation.
    pub name: String,
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

/// A named position of the platform.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct StationSpec {
    /// Name of the station.
    pub name: String,
    /// Position of the platform's origin, world, m.
    pub position: [f64; 3],
    /// Orientation of the platform there, a unit quaternion w x y z or the name of one of the scene's orientations;
    /// default: that of the query.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationSource>,
}

/// The name of a station, or a position.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(untagged)]
pub enum PositionSource {
    /// One of the scene's stations.
    Named(String),
    /// A position of the platform's origin, world, m.
    Coordinates([f64; 3]),
}

impl fmt::Display for PositionSource {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            PositionSource::Named(name) => f.write_str(name),
            PositionSource::Coordinates([x, y, z]) => write!(f, "({x}, {y}, {z})"),
        }
    }
}

impl From<[f64; 3]> for PositionSource {
    fn from(position: [f64; 3]) -> Self {
        PositionSource::Coordinates(position)
    }
}

impl From<Point> for PositionSource {
    fn from(position: Point) -> Self {
        PositionSource::Coordinates(position.into())
    }
}

impl<'de> Deserialize<'de> for PositionSource {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = PositionSource;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a position [x, y, z] or the name of a station")
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<PositionSource, E> {
                Ok(PositionSource::Named(name.to_string()))
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, seq: A) -> Result<PositionSource, A::Error> {
                fixed_length::from_seq(seq).map(PositionSource::Coordinates)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
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

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
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
