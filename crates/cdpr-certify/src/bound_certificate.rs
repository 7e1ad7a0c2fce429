//! Whether the numbers of a certificate of a bound are in range.

use cdpr_core::certificate::{BoundCertificate, MOST_PIECES};
use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;

use crate::question::{finite, regions_are_finite};

/// Largest coordinate and label, m: rounding errors are then far below [`STEP`].
const MOST_LENGTH: f64 = 1000.0;
/// How far the length of a normal may be from 1.
const UNIT: f64 = 1e-9;

/// Whether a text says that it is a certificate of a bound.
pub fn is_bound(text: &str) -> bool {
    #[derive(serde::Deserialize)]
    struct Head {
        format: String,
    }
    serde_json::from_str(text).is_ok_and(|head: Head| head.format == BoundCertificate::FORMAT)
}

/// An error for numbers and indices that are out of range.
pub(crate) fn numbers_are_sound(certificate: &BoundCertificate) -> Result<(), Error> {
    let small = |place: &str, numbers: &[f64]| match numbers.iter().find(|x| !(x.abs() <= MOST_LENGTH)) {
        Some(x) => Err(Error::invalid(place, format!("found {x}, expected numbers up to {MOST_LENGTH}"))),
        None => Ok(()),
    };
    regions_are_finite(&certificate.regions)?;
    small("length", &[certificate.length])?;
    small("start", &certificate.start)?;
    small("goal", &certificate.goal)?;
    small("box", certificate.bounds.as_flattened())?;
    for (k, region) in certificate.regions.iter().enumerate() {
        for (h, [x, y, z, d]) in region.half_spaces.iter().enumerate() {
            let place = format!("regions[{k}].half_spaces[{h}]");
            small(&place, &[*d])?;
            let length = Vector::new(*x, *y, *z).norm();
            if !((length - 1.0).abs() <= UNIT) {
                return Err(Error::invalid(place, format!("found a normal of length {length}, expected 1")));
            }
        }
    }
    for (k, edge) in certificate.edges.iter().enumerate() {
        let place = format!("edges[{k}]");
        let count = certificate.regions.get(edge.region).map_or(0, |region| region.half_spaces.len());
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
    let pieces: usize = certificate.edges.iter().map(|edge| edge.pieces.len()).sum();
    if pieces > MOST_PIECES {
        return Err(Error::invalid("edges", format!("found {pieces} pieces, expected at most {MOST_PIECES}")));
    }
    small("corners", certificate.corners.as_flattened())
}
