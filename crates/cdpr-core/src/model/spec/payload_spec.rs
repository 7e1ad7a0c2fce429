//! The parts of a scene file about carrying: payloads, and the rows of a task.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{BodySpec, OrientationSource, PositionSource};

/// Something that the platform can carry. While it stands, it is an obstacle; while it is carried, it is a part of the platform.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PayloadSpec {
    /// Name of the payload, as an obstacle and as a part of the platform.
    pub name: String,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass while it is carried, platform frame, m; default the centre of its volume.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub center_of_mass: Option<[f64; 3]>,
    /// Where it stands: it stands where it would be carried if the platform were at this station, or at this position, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<PositionSource>,
    /// Orientation of the platform there; default that of the station, else that of the scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationSource>,
    /// Whether the platform carries it, instead of `at`; default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub carried: bool,
    /// Shape of the payload as it is carried, in the platform's frame: a body without a name, or several.
    #[serde(with = "one_or_several")]
    #[cfg_attr(feature = "schema", schemars(with = "Bodies"))]
    pub body: Vec<BodySpec>,
}

/// A row of a task: exactly one of its keys.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TaskRowSpec {
    /// Go there and stop: a station, or a position, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub go: Option<PositionSource>,
    /// Pass this station or position, m, on the way to the next row, without stopping.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub via: Option<PositionSource>,
    /// Go to where this payload stands, and take it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pick: Option<String>,
    /// Set this payload down where the platform is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
}

/// A body, or several.
#[cfg(feature = "schema")]
#[derive(JsonSchema)]
#[schemars(untagged)]
#[allow(dead_code)]
enum Bodies {
    /// One body.
    One(Box<BodySpec>),
    /// Several bodies.
    Several(Vec<BodySpec>),
}

/// Reads a table or a list of tables; one is written as a table.
mod one_or_several {
    use serde::de::value::MapAccessDeserializer;
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

    use super::BodySpec;

    pub fn serialize<S: Serializer>(bodies: &[BodySpec], serializer: S) -> Result<S::Ok, S::Error> {
        match bodies {
            [one] => one.serialize(serializer),
            several => several.serialize(serializer),
        }
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<BodySpec>, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = Vec<BodySpec>;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("the table of a body, or a list of such tables")
            }

            fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Vec<BodySpec>, A::Error> {
                BodySpec::deserialize(MapAccessDeserializer::new(map)).map(|body| vec![body])
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Vec<BodySpec>, A::Error> {
                let mut bodies = Vec::new();
                while let Some(body) = seq.next_element()? {
                    bodies.push(body);
                }
                Ok(bodies)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}
