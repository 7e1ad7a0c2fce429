//! Pairs that are not held to the clearance that the scene demands of their kind: listed beside every answer, so that no
//! "valid" hides them.

use serde::Serialize;

use crate::choices;
use crate::model::Member;
use crate::words::small_length;

/// Why a pair is exempt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// At no position can the pair keep the distance. It must still not touch, if it can keep from that.
    Unattainable,
    /// The scene lets the pair touch, but not enter each other.
    Touch,
    /// The scene has the pair unchecked.
    Ignore,
}

choices!(Reason, "reason", [
    Unattainable = "unattainable": "The pair can keep the distance at no position; it must still not touch",
    Touch = "touch": "The scene lets the pair touch, but not enter each other",
    Ignore = "ignore": "The scene has the pair unchecked",
]);

/// A pair that is not held to the clearance demanded of its kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Exemption {
    /// Who.
    pub pair: [String; 2],
    /// Why.
    pub reason: Reason,
    /// The clearance that would have to be kept otherwise, m.
    pub demanded: f64,
    /// For unattainable distances the largest gap of their surfaces at any position, m; negative where thick cables
    /// overlap everywhere.
    pub attainable: Option<f64>,
    /// Who, by number.
    #[serde(skip)]
    pub members: [Member; 2],
    /// Indices of the constraints that are about the pair's distance.
    #[serde(skip)]
    pub constraints: Vec<usize>,
}

impl Exemption {
    /// In plain words: "cable 2 and cable 4 can be 100.000 mm apart at most, 200.000 mm are demanded; they must still not
    /// touch".
    pub fn sentence(&self) -> String {
        let names = self.pair.join(" and ");
        let Some(attainable) = self.attainable else {
            return match self.reason {
                Reason::Ignore => format!("{names} are not checked against each other"),
                _ => format!("{names} may touch, but not enter each other"),
            };
        };
        let (most, still) = if attainable >= 0.0 {
            (format!("can be {} apart at most", small_length(attainable)), "they must still not touch")
        } else {
            (format!("overlap by {} at best", small_length(-attainable)), "only the axes of cables are kept clear")
        };
        let demanded = match self.demanded {
            0.0 => String::new(),
            demanded => format!(", {} are demanded", small_length(demanded)),
        };
        format!("{names} {most}{demanded}; {still}")
    }
}

/// The distance of the lines or bodies that a pair is held to, m: clearance and radii if some position gives as much,
/// otherwise the radii alone, so that surfaces do not touch; nothing where even that is impossible.
pub(super) fn kept(clearance: f64, radii: f64, attainable: f64) -> f64 {
    [clearance + radii, radii].into_iter().find(|gap| *gap <= attainable).unwrap_or(0.0)
}
