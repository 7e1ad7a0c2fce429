//! The file of a certificate as plain data.

use std::fmt;

use cdpr_core::error::Error;
use cdpr_core::limits::MOST_CERTIFICATE_BOXES;
use serde::de::{self, Deserialize, Deserializer, IgnoredAny, SeqAccess, Visitor};

use crate::tiling::Bounds;

const FORMAT: &str = "cdpr-proof";
const VERSION: u64 = 1;
const MOST_REGIONS: usize = 10_000;
const MOST_HALF_SPACES: usize = 1000;

/// A certificate that a scene has no path: regions of forbidden positions, and boxes that tile the box of positions.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u64,
    /// The scene's fingerprint.
    pub scene: String,
    /// The platform's orientation, a unit quaternion w x y z.
    pub orientation: [f64; 4],
    /// How close to forbidden positions every path comes at least, m.
    pub margin: f64,
    /// Where a path starts, m.
    pub start: [f64; 3],
    /// Where it ends, m.
    pub goal: [f64; 3],
    /// The box of positions, m.
    #[serde(rename = "box")]
    pub bounds: Bounds,
    /// Regions of forbidden positions.
    #[serde(deserialize_with = "at_most::<_, _, MOST_REGIONS>")]
    pub regions: Vec<Region>,
    /// Boxes that tile the box of positions.
    #[serde(deserialize_with = "at_most::<_, _, MOST_CERTIFICATE_BOXES>")]
    pub boxes: Vec<Cell>,
}

/// Positions that two members of the scene forbid.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// The names of the two.
    pub who: [String; 2],
    /// All x with n·x < d for each of these: n, then d.
    #[serde(deserialize_with = "at_most::<_, _, MOST_HALF_SPACES>")]
    pub half_spaces: Vec<[f64; 4]>,
}

/// A box of positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// Its least and its largest coordinates, m.
    pub bounds: Bounds,
    /// What the certificate claims about it.
    pub status: Status,
}

/// What a certificate claims about a box.
#[derive(Debug, Clone, PartialEq)]
pub enum Status {
    /// Nothing: it may have free positions.
    Open,
    /// It lies in the region with this index.
    Within(usize),
    /// All its positions are forbidden by these members: a pair, or a cable because of its length.
    Broken(Vec<String>),
    /// In all its positions the cables are too weak in this direction of forces and moments.
    TooWeak([f64; 6]),
}

impl Certificate {
    /// Reads a certificate, without checking what it says.
    ///
    /// # Errors
    /// Text that is not a certificate of this version, or a longer one than this program checks.
    ///
    /// # Example
    /// ```
    /// let error = cdpr_certify::Certificate::parse(r#"{"format": "cdpr-proof", "version": 2}"#).unwrap_err();
    /// assert_eq!(error.to_string(), "version: found 2, expected 1");
    /// ```
    pub fn parse(text: &str) -> Result<Self, Error> {
        parsed(text, FORMAT)
    }
}

/// Reads a file of a format of this version.
pub(crate) fn parsed<T: serde::de::DeserializeOwned>(text: &str, format: &str) -> Result<T, Error> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let parsed: Result<T, _> = serde_path_to_error::deserialize(&mut reader);
    let certificate = parsed.map_err(|error| {
        let place = error.path().to_string();
        let place = place.trim_end_matches(['.', '?']).to_string(); // unknown parts of the path
        let problem = error.into_inner().to_string();
        let told = if problem.starts_with("found") { problem } else { format!("found no certificate: {problem}") };
        other_format(text, format).unwrap_or_else(|| Error::invalid(place, told))
    })?;
    reader.end().map_err(|error| Error::invalid("", format!("found more than a certificate: {error}")))?;
    other_format(text, format).map_or(Ok(certificate), Err)
}

/// An error if a text is of another format or version, whatever the rest of it contains.
fn other_format(text: &str, format: &str) -> Option<Error> {
    #[derive(serde::Deserialize)]
    struct Head {
        format: Option<serde_json::Value>,
        version: Option<serde_json::Value>,
    }
    let head: Head = serde_json::from_str(text).ok()?;
    let other = |place: &str, found: Option<serde_json::Value>, expected: serde_json::Value| {
        let found = found.filter(|found| *found != expected)?;
        Some(Error::invalid(place, format!("found {found}, expected {expected}")))
    };
    other("format", head.format, format.into()).or_else(|| other("version", head.version, VERSION.into()))
}

/// Reads a list; of a longer one, only the length.
pub(crate) fn at_most<'de, D: Deserializer<'de>, T: Deserialize<'de>, const MOST: usize>(
    list: D,
) -> Result<Vec<T>, D::Error> {
    struct List<T, const MOST: usize>(std::marker::PhantomData<T>);
    impl<'de, T: Deserialize<'de>, const MOST: usize> Visitor<'de> for List<T, MOST> {
        type Value = Vec<T>;

        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str("a list")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<T>, A::Error> {
            let mut all = Vec::new();
            while all.len() < MOST {
                let Some(next) = list.next_element()? else { return Ok(all) };
                all.push(next);
            }
            let mut count = MOST;
            while list.next_element::<IgnoredAny>()?.is_some() {
                count += 1;
            }
            if count == MOST {
                return Ok(all);
            }
            Err(de::Error::custom(format!("found {count}, expected at most {MOST}")))
        }
    }
    list.deserialize_seq(List::<T, MOST>(std::marker::PhantomData))
}

/// `[x0, y0, z0, x1, y1, z1, region]`, and a reason after region -2.
impl<'de> Deserialize<'de> for Cell {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Row;
        impl<'de> Visitor<'de> for Row {
            type Value = Cell;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("[x0, y0, z0, x1, y1, z1, region], and a reason after region -2")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut row: A) -> Result<Cell, A::Error> {
                let mut bounds = [[0.0; 3]; 2];
                for (k, x) in bounds.as_flattened_mut().iter_mut().enumerate() {
                    *x = row.next_element()?.ok_or_else(|| de::Error::invalid_length(k, &self))?;
                }
                let region: i64 = row.next_element()?.ok_or_else(|| de::Error::invalid_length(6, &self))?;
                let status = match region {
                    -1 => Status::Open,
                    -2 => row.next_element::<Reason>()?.ok_or_else(|| de::Error::invalid_length(7, &self))?.into(),
                    _ => Status::Within(usize::try_from(region).map_err(|_| {
                        de::Error::custom(format!("found region {region}, expected an index, -1 or -2"))
                    })?),
                };
                match row.next_element::<IgnoredAny>()? {
                    None => Ok(Cell { bounds, status }),
                    Some(_) => Err(de::Error::invalid_length(8, &self)),
                }
            }
        }
        deserializer.deserialize_seq(Row)
    }
}

/// Names of members, or "wrench" and a direction.
#[derive(serde::Deserialize)]
#[serde(untagged, expecting = "one or two names of members, or \"wrench\" and six numbers")]
enum Reason {
    Wrench(Wrench, f64, f64, f64, f64, f64, f64),
    One([String; 1]),
    Two([String; 2]),
}

#[derive(serde::Deserialize)]
enum Wrench {
    #[serde(rename = "wrench")]
    Word,
}

impl From<Reason> for Status {
    fn from(reason: Reason) -> Status {
        match reason {
            Reason::Wrench(Wrench::Word, a, b, c, d, e, f) => Status::TooWeak([a, b, c, d, e, f]),
            Reason::One(names) => Status::Broken(names.into()),
            Reason::Two(names) => Status::Broken(names.into()),
        }
    }
}
