//! The file of a certificate of a bound as plain data.

use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;

use crate::certificate::{Region, at_most, parsed};
use crate::question::{finite, regions_are_finite};
use crate::tiling::Bounds;

const FORMAT: &str = "cdpr-bound";
const MOST_BOUND_REGIONS: usize = 1000;
const MOST_EDGES: usize = 10_000;
const MOST_CORNERS: usize = 10_000;
/// Most pieces of all edges together: every two of them are compared.
const MOST_PIECES: usize = 10_000;
/// Largest coordinate and label, m: rounding errors are then far below [`STEP`].
const MOST_LENGTH: f64 = 1000.0;
/// How far the length of a normal may be from 1.
const UNIT: f64 = 1e-9;

/// A certificate that no path is shorter than a length.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BoundCertificate {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u64,
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

/// A part of an edge.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
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

/// Whether a text says that it is a certificate of a bound.
pub fn is_bound(text: &str) -> bool {
    #[derive(serde::Deserialize)]
    struct Head {
        format: String,
    }
    serde_json::from_str(text).is_ok_and(|head: Head| head.format == FORMAT)
}

impl BoundCertificate {
    /// Reads a certificate, without checking what it says.
    ///
    /// # Errors
    /// Text that is not a certificate of this version, or a longer one than this program checks.
    pub fn parse(text: &str) -> Result<Self, Error> {
        parsed(text, FORMAT)
    }

    /// An error for numbers and indices that are out of range.
    pub(crate) fn numbers_are_sound(&self) -> Result<(), Error> {
        let small = |place: &str, numbers: &[f64]| match numbers.iter().find(|x| !(x.abs() <= MOST_LENGTH)) {
            Some(x) => Err(Error::invalid(place, format!("found {x}, expected numbers up to {MOST_LENGTH}"))),
            None => Ok(()),
        };
        regions_are_finite(&self.regions)?;
        small("length", &[self.length])?;
        small("start", &self.start)?;
        small("goal", &self.goal)?;
        small("box", self.bounds.as_flattened())?;
        for (k, region) in self.regions.iter().enumerate() {
            for (h, [x, y, z, d]) in region.half_spaces.iter().enumerate() {
                let place = format!("regions[{k}].half_spaces[{h}]");
                small(&place, &[*d])?;
                let length = Vector::new(*x, *y, *z).norm();
                if !((length - 1.0).abs() <= UNIT) {
                    return Err(Error::invalid(place, format!("found a normal of length {length}, expected 1")));
                }
            }
        }
        for (k, edge) in self.edges.iter().enumerate() {
            let place = format!("edges[{k}]");
            let count = self.regions.get(edge.region).map_or(0, |region| region.half_spaces.len());
            if edge.planes.iter().any(|plane| *plane >= count) {
                let (region, [a, b]) = (edge.region, edge.planes);
                let problem = format!("found half-spaces {a} and {b} of region {region}, expected indices");
                return Err(Error::invalid(place, problem));
            }
            small(&place, edge.ends.as_flattened())?;
            finite(&place, edge.pieces.as_flattened())?;
            small(&place, edge.pieces.as_flattened())?;
            let shares = || edge.pieces.iter().map(|piece| piece[0]);
            let rising = std::iter::once(0.0).chain(shares()).zip(shares()).all(|(before, after)| before <= after);
            if !rising || shares().next_back() != Some(1.0) {
                return Err(Error::invalid(place, "found pieces that do not end one after another, the last one at 1"));
            }
        }
        let pieces: usize = self.edges.iter().map(|edge| edge.pieces.len()).sum();
        if pieces > MOST_PIECES {
            return Err(Error::invalid("edges", format!("found {pieces} pieces, expected at most {MOST_PIECES}")));
        }
        small("corners", self.corners.as_flattened())
    }
}
