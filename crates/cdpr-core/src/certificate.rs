//! The files of certificates as plain data: what the program writes and `cdpr-certify` reads. docs/understand/no-path.md
//! describes them.

use std::fmt;

use serde::de::{self, Deserializer, IgnoredAny, SeqAccess, Visitor};
use serde::ser::{SerializeSeq, Serializer};
use serde::{Deserialize, Serialize};

use crate::limits::{MOST_CERTIFICATE_BOXES, MOST_WEAK_BOXES};

/// Version of both formats.
pub const VERSION: u64 = 1;
/// First item of the reason of a box whose positions lack a wrench; the direction [force; moment] follows.
pub const WRENCH: &str = "wrench";
const MOST_REGIONS: usize = 10_000;
const MOST_HALF_SPACES: usize = 1000;
const MOST_BOUND_REGIONS: usize = 1000;
const MOST_EDGES: usize = 10_000;
const MOST_CORNERS: usize = 10_000;
/// Most pieces of all edges together: every two of them are compared.
pub const MOST_PIECES: usize = 10_000;

/// Smallest and largest coordinates, m.
pub type Bounds = [[f64; 3]; 2];

/// A certificate that a scene has no path: regions of forbidden positions, and boxes that tile the box of positions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// [`Certificate::FORMAT`].
    pub format: String,
    /// [`VERSION`].
    pub version: u64,
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

impl Certificate {
    /// What the file says it is.
    pub const FORMAT: &str = "cdpr-proof";
}

/// Positions that two members of the scene forbid, or where wrenches lack.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// The names of the two, or [`WRENCH`].
    #[serde(deserialize_with = "at_most::<_, _, 2>")]
    pub who: Vec<String>,
    /// All x with n·x < d for each of these: n, then d.
    #[serde(deserialize_with = "at_most::<_, _, MOST_HALF_SPACES>")]
    pub half_spaces: Vec<[f64; 4]>,
    /// Boxes that tile a box around the region, if wrenches lack in it.
    #[serde(default, deserialize_with = "at_most::<_, _, MOST_WEAK_BOXES>", skip_serializing_if = "Vec::is_empty")]
    pub boxes: Vec<WeakBox>,
}

/// A box of positions, and a proof that the cables are too weak at those that count: inside the last half-space of the region, and where
/// a path can be that is shorter than the certified length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<f64>", into = "Vec<f64>")]
pub struct WeakBox {
    /// Its least and its largest coordinates, m.
    pub bounds: Bounds,
    /// Where they are too weak; `None` if no position counts.
    pub direction: Option<WeakDirection>,
}

/// A direction of forces and moments in which the cables are too weak. It is linear in the position.
#[derive(Debug, Clone, PartialEq)]
pub struct WeakDirection {
    /// The direction at the centre of the box.
    pub at_center: [f64; 6],
    /// Its changes along x, y and z, per metre.
    pub slopes: [[f64; 6]; 3],
    /// What the cables lack is at least this times the height below the plane of the last half-space, in the unit of the direction
    /// per metre.
    pub weight: f64,
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

/// A certificate that no path is shorter than a length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BoundCertificate {
    /// [`BoundCertificate::FORMAT`].
    pub format: String,
    /// [`VERSION`].
    pub version: u64,
    /// The scene's fingerprint.
    pub scene: String,
    /// The platform's orientation, a unit quaternion w x y z.
    pub orientation: [f64; 4],
    /// Paths that come closer to forbidden positions do not count, m.
    pub margin: f64,
    /// Where a path starts, m.
    pub start: [f64; 3],
    /// Where it ends, m.
    pub goal: [f64; 3],
    /// No path is shorter, m.
    pub length: f64,
    /// The box of positions, m.
    #[serde(rename = "box")]
    pub bounds: Bounds,
    /// Regions of forbidden positions.
    #[serde(deserialize_with = "at_most::<_, _, MOST_BOUND_REGIONS>")]
    pub regions: Vec<Region>,
    /// Parts of their edges where a path may bend.
    #[serde(deserialize_with = "at_most::<_, _, MOST_EDGES>")]
    pub edges: Vec<EdgeRow>,
    /// Corners where it may bend: three coordinates and a label, m.
    #[serde(deserialize_with = "at_most::<_, _, MOST_CORNERS>")]
    pub corners: Vec<[f64; 4]>,
}

impl BoundCertificate {
    /// What the file says it is.
    pub const FORMAT: &str = "cdpr-bound";
}

/// A part of an edge.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EdgeRow {
    /// The index of the region.
    pub region: usize,
    /// The indices of the two half-spaces whose planes meet in the edge.
    pub planes: [usize; 2],
    /// Both ends, m.
    pub ends: [[f64; 3]; 2],
    /// For each piece: where it ends, as a fraction, and labels at both of its ends, m.
    #[serde(deserialize_with = "at_most::<_, _, MOST_PIECES>")]
    pub pieces: Vec<[f64; 3]>,
}

/// Six coordinates; then six numbers of the direction, 18 of its changes, and the weight.
impl From<WeakBox> for Vec<f64> {
    fn from(weak: WeakBox) -> Self {
        let mut row = weak.bounds.as_flattened().to_vec();
        if let Some(WeakDirection { at_center, slopes, weight }) = weak.direction {
            row.extend(at_center.iter().chain(slopes.as_flattened()).chain([&weight]));
        }
        row
    }
}

impl TryFrom<Vec<f64>> for WeakBox {
    type Error = String;

    fn try_from(row: Vec<f64>) -> Result<Self, String> {
        let six = |from: usize| -> [f64; 6] { std::array::from_fn(|k| row[from + k]) };
        let direction = match row.len() {
            6 => None,
            31 => Some(WeakDirection { at_center: six(6), slopes: [12, 18, 24].map(six), weight: row[30] }),
            other => return Err(format!("found {other} numbers, expected 6 or 31")),
        };
        let [x0, y0, z0, x1, y1, z1] = six(0);
        Ok(WeakBox { bounds: [[x0, y0, z0], [x1, y1, z1]], direction })
    }
}

/// Reads a list; of a longer one, only the length.
fn at_most<'de, D: Deserializer<'de>, T: Deserialize<'de>, const MOST: usize>(list: D) -> Result<Vec<T>, D::Error> {
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
impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_seq(None)?;
        self.bounds.as_flattened().iter().try_for_each(|x| row.serialize_element(x))?;
        match &self.status {
            Status::Open => row.serialize_element(&-1)?,
            Status::Within(region) => row.serialize_element(region)?,
            Status::Broken(names) => {
                row.serialize_element(&-2)?;
                row.serialize_element(names)?;
            }
            Status::TooWeak([a, b, c, d, e, f]) => {
                row.serialize_element(&-2)?;
                row.serialize_element(&(WRENCH, a, b, c, d, e, f))?;
            }
        }
        row.end()
    }
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
#[derive(Deserialize)]
#[serde(untagged, expecting = "one or two names of members, or \"wrench\" and six numbers")]
enum Reason {
    Wrench(Wrench, f64, f64, f64, f64, f64, f64),
    One([String; 1]),
    Two([String; 2]),
}

#[derive(Deserialize)]
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
