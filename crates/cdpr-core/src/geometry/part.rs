//! A convex part that may still be merged, and its task: the piece to be covered, and how closely.

use super::Point;
use super::reach::{Reach, Until, reach};
use super::surface::Piece;
use super::wrap::{Wrap, thickened, wrap};
use crate::error::Error;
use crate::numerics::TIGHT_WRAP;
use crate::watch::Watch;

/// A part of the body that may still be merged.
#[derive(Clone)]
pub(super) struct Part {
    pub wrap: Wrap,
    /// How far it extends beyond the piece, if this is proved to be within the tolerance, m; zero if it equals the body
    /// there.
    pub reach: Option<f64>,
}

/// The piece that parts must cover, how far they may extend beyond it, m, and how long that may take.
pub(super) struct Task<'a> {
    pub piece: &'a Piece,
    pub tolerance: f64,
    pub watch: &'a Watch<'a>,
}

impl Task<'_> {
    /// A convex body with volume around points; those of a sheet may already have been thickened.
    pub fn enclosing(&self, points: Vec<Point>) -> Result<Wrap, Error> {
        let room = TIGHT_WRAP * self.tolerance;
        match wrap(&points, room, self.watch)? {
            Some(wrap) => Ok(wrap),
            None => Ok(wrap(&thickened(&points), room, self.watch)?.expect("thick points")),
        }
    }

    /// How far a body extends beyond the piece, computed until it is clear whether that is too far.
    pub fn proved(&self, wrap: &Wrap, within: f64, steps: usize) -> Result<Reach, Error> {
        let until = Until { enough: within, or_beyond: true, steps };
        let (planes, aabb) = wrap.widened();
        reach(&self.piece.distance, &planes, &aabb, &until, self.watch)
    }
}
