//! A convex part that may still be merged, and its task: the piece to be covered, and how closely.

use std::sync::Arc;

use super::cell::Cell;
use super::reach::{Bounded, Reach, Until, reach};
use super::wrap::{Wrap, along_its_axes, thickened, wrap};
use crate::error::Error;
use crate::geometry::Point;
use crate::geometry::surface::MeshPiece;
use crate::tolerances::TIGHT_WRAP;
use crate::watch::Watch;

/// A part of the body that may still be merged.
#[derive(Clone)]
pub(super) struct Part {
    pub wrap: Wrap,
    /// How far the part extends beyond the piece, if this is proved to be within the tolerance, m; zero if it equals
    /// the body there.
    pub reach: Option<f64>,
    /// The cells in which this part covers the piece.
    pub cells: Vec<Arc<Cell>>,
}

/// The piece that parts must cover, how far they may extend beyond it, m, and how long that may take.
pub(super) struct Task<'a> {
    pub piece: &'a MeshPiece,
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
        self.measured(wrap.widened(), wrap.corners(), &Until { enough: within, or_beyond: true, steps })
    }

    /// How far a body with these corners extends beyond the piece.
    pub fn measured(&self, body: Bounded, corners: &[Point], until: &Until) -> Result<Reach, Error> {
        // Boxes along the axes of the world would be many in a thin body that is tilted.
        let body = if self.piece.volume.is_some() { body } else { along_its_axes(body, corners) };
        reach(&self.piece.distance, &body, until, self.watch)
    }
}
