//! Two cables of which at least one can take several shapes.
//!
//! A cable that hangs at most σ below its chord, in the middle, lies between the chord and a parabola, and so in the hull of the
//! chord and of the points σ below it at a quarter and at three quarters of its length: these are on the tangents at both ends
//! and in the middle. With several exit points, the hull of all these hulls is meant. The pair must keep the distance of both hulls.
//! That is less than necessary where the cables would not reach the same shape at the same time.
//!
//! The sag is that of the longest chord during a piece of a motion. The corners of the hulls then move linearly with the platform, so
//! a gap along a fixed direction is a concave function of time and smallest at an end: each piece is bounded along the direction that
//! separates the hulls halfway.

use super::bodies::CableAt;
use crate::geometry::gjk::shape_distance;
use crate::geometry::separating_axes::gap_along;
use crate::geometry::{Fan, Point, Vector, proximity};
use crate::limits::{HANGING_HALVINGS, HANGING_PIECES};
use crate::tolerances::{GAP_TOLERANCE, TOUCH_DEPTH};

/// Two cables, at least one of which can take several shapes.
pub struct HangingPair<'a> {
    /// The cables.
    pub cables: [&'a CableAt; 2],
}

/// Pieces of a motion that are still to be examined, as fractions of it: each halving adds one.
struct Waiting {
    pieces: [[f64; 2]; HANGING_HALVINGS],
    count: usize,
}

impl Waiting {
    fn whole() -> Self {
        Waiting { pieces: [[0.0, 1.0]; HANGING_HALVINGS], count: 1 }
    }

    fn pop(&mut self) -> Option<[f64; 2]> {
        self.count = self.count.checked_sub(1)?;
        Some(self.pieces[self.count])
    }

    /// Leaves both halves for later, the first one on top; false if there is no more room.
    fn halve(&mut self, [start, end]: [f64; 2]) -> bool {
        let room = self.count + 2 <= HANGING_HALVINGS;
        if room {
            let middle = 0.5 * (start + end);
            self.pieces[self.count] = [middle, end];
            self.pieces[self.count + 1] = [start, middle];
            self.count += 2;
        }
        room
    }
}

impl HangingPair<'_> {
    /// How deep the cables hang at most while the platform moves between two positions, m: the length of a chord is greatest at one
    /// of them.
    fn depths(&self, ends: [&Point; 2]) -> [f64; 2] {
        self.cables
            .map(|cable| ends.map(|position| cable.sag(&(position + cable.arm), 0.0)).into_iter().fold(0.0, f64::max))
    }

    /// The hulls of both cables with the platform at a position, if they hang at most this deep.
    fn at(&self, position: &Point, depths: [f64; 2]) -> [Fan<'_>; 2] {
        let [i, j] = self.cables;
        [i.shapes(&(position + i.arm), depths[0]), j.shapes(&(position + j.arm), depths[1])]
    }

    /// The distance of the cables' axes at a position, m, negative where the hulls overlap, and their nearest points.
    pub fn nearest(&self, position: &Point) -> (f64, [Point; 2], Vector) {
        let [a, b] = self.at(position, self.depths([position; 2]));
        let found = shape_distance(&a, &b);
        (found.signed(), [found.on_a, found.on_b], found.axis)
    }

    /// Whether the cables come nearer than `gap` metres, which must be positive, at some instant of a motion, or too close to
    /// that to tell.
    pub fn nearer_than(&self, gap: f64, from: &Point, to: &Point) -> bool {
        let wanted = gap - TOUCH_DEPTH;
        let place = |t: f64| from + (to - from) * t;
        let shortest = GAP_TOLERANCE / (to - from).norm();
        let mut waiting = Waiting::whole();
        for _ in 0..HANGING_PIECES {
            let Some([start, end]) = waiting.pop() else { return false };
            let middle = 0.5 * (start + end);
            let depths = self.depths([&place(middle); 2]);
            let [a, b] = self.at(&place(middle), depths);
            let found = proximity(&a, &b, wanted, wanted);
            if found.upper < wanted || (found.lower < wanted && !(end - start > shortest)) {
                return true;
            }
            if self.gap_between([&place(start), &place(end)], &found.axis) >= wanted {
                continue;
            }
            if !waiting.halve([start, end]) {
                return true;
            }
        }
        waiting.count > 0
    }

    /// The least distance of the cables' axes during a motion, m, to within [`GAP_TOLERANCE`] or slightly more.
    pub fn least(&self, from: &Point, to: &Point) -> f64 {
        let place = |t: f64| from + (to - from) * t;
        let mut best = self.nearest(from).0;
        if from == to {
            return best;
        }
        best = best.min(self.nearest(to).0);
        let mut waiting = Waiting::whole();
        for _ in 0..HANGING_PIECES {
            let Some([start, end]) = waiting.pop() else { break };
            let middle = 0.5 * (start + end);
            let (distance, _, axis) = self.nearest(&place(middle));
            best = best.min(distance);
            let open = self.gap_between([&place(start), &place(end)], &axis) < best - GAP_TOLERANCE;
            if open && !waiting.halve([start, end]) {
                break;
            }
        }
        best
    }

    /// The least gap along a unit direction, from the first cable to the second, between two positions, m.
    fn gap_between(&self, ends: [&Point; 2], axis: &Vector) -> f64 {
        let depths = self.depths(ends);
        let gap = |position: &Point| {
            let [a, b] = self.at(position, depths);
            gap_along(&a, &b, axis)
        };
        gap(ends[0]).min(gap(ends[1]))
    }
}
