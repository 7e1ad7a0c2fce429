//! Certificates for the slack along a straight motion: that it suffices everywhere, where it first fails, and its
//! minimum.
//!
//! Two bounds work together. Slack is computed at four positions at a time, and between two of them it cannot drop by
//! more than [`sagging`] allows. This is cheap and decides most motions, but near the limit it would need pieces as
//! short as the slack is small. The remaining pieces are certified facet by facet (`Facets`): there a piece may be as
//! long as the square root of the slack, and each facet is divided only where it limits.
//!
//! The facets are those at the given outlets. Where the true ones may differ, more slack is required on each piece, by what this
//! can change. Cables that run round pulleys have no such polynomials; [`super::halving`] certifies motions with them.

use super::facets::{Bounds, FacetPair, Facets};
use super::halving;
use super::measure::{Measure, MotionVerdict, sagging};
use crate::geometry::Point;
use crate::simd::WIDTH;
use crate::tolerances::{CERTIFY_PIECE, LEAST_SLACK_RELATIVE};

/// Number of facet bounds after which certification gives up: some 3 ms, spent only on motions whose slack is
/// almost zero over a long distance.
const MOST_BOUNDS: usize = 10_000;
/// Cost of computing the slack at four positions, in facet bounds: by the kernel, and by definition per facet.
const KERNEL_COST: usize = 8;
const DEFINITION_COST: usize = 8;
/// Maximum number of divisions of pieces before facets are examined.
const DIVISIONS: usize = 2;
/// Number of halvings after which a piece that its facet does not decide is tested by the slack at its ends.
const HALVINGS: u32 = 6;
/// Accuracy of the position of the first failure, as a share of the motion.
const PLACE: f64 = 1e-10;

/// A motion, and the remaining effort for it.
struct Way<'a> {
    measure: &'a Measure,
    from: &'a Point,
    to: &'a Point,
    length: f64,
    bounds: usize,
}

/// A piece of a motion between two fractions of it, and its number of halvings.
#[derive(Debug, Clone, Copy, Default)]
struct MotionPiece {
    from: f64,
    to: f64,
    halved: u32,
}

/// A stack of pieces of one facet; each halving adds one piece.
struct Waiting {
    pieces: [MotionPiece; 64],
    count: usize,
}

impl Waiting {
    fn of(piece: MotionPiece) -> Self {
        let mut pieces = [MotionPiece::default(); 64];
        pieces[0] = piece;
        Waiting { pieces, count: 1 }
    }

    fn pop(&mut self) -> Option<MotionPiece> {
        self.count = self.count.checked_sub(1)?;
        Some(self.pieces[self.count])
    }

    fn halve(&mut self, piece: &MotionPiece) {
        let middle = 0.5 * (piece.from + piece.to);
        let halved = piece.halved + 1;
        self.push(MotionPiece { from: middle, halved, ..*piece });
        self.push(MotionPiece { to: middle, halved, ..*piece });
    }

    fn push(&mut self, piece: MotionPiece) {
        self.pieces[self.count] = piece;
        self.count += 1;
    }
}

impl<'a> Way<'a> {
    fn new(measure: &'a Measure, from: &'a Point, to: &'a Point) -> Self {
        Way { measure, from, to, length: (to - from).norm(), bounds: MOST_BOUNDS }
    }

    fn at(&self, t: f64) -> Point {
        self.from + (self.to - self.from) * t
    }

    /// The fraction of the motion at which it is closest to a position.
    fn nearest(&self, position: &Point) -> f64 {
        ((position - self.from).dot(&(self.to - self.from)) / (self.length * self.length)).clamp(0.0, 1.0)
    }

    fn slack_at_four(&self, fractions: &[f64; WIDTH]) -> [f64; WIDTH] {
        self.measure.slack_at_four(&fractions.map(|t| self.at(t)))
    }

    /// Whether the slack at both ends of a piece proves that it suffices between them.
    fn proved_by_ends(&self, [from, to]: [f64; 2], [a, b]: [f64; 2]) -> bool {
        sagging(a, b, self.measure.sag(&self.at(from), &self.at(to))) >= 0.0
    }

    /// How much smaller the slack at the true outlets can be on a piece than at the given ones.
    fn loss(&self, piece: &MotionPiece) -> f64 {
        if !self.measure.statics().has_errors() {
            return 0.0;
        }
        self.measure.loss(&self.at(piece.from), &self.at(piece.to))
    }

    fn spend(&mut self, bounds: usize) {
        self.bounds = self.bounds.saturating_sub(bounds);
    }

    /// Whether the slack at the ends proves a piece; tried rarely, since it costs more than a bound.
    fn closed(&mut self, piece: &MotionPiece) -> bool {
        if piece.halved == 0 || !piece.halved.is_multiple_of(HALVINGS) {
            return false;
        }
        self.spend(2 * self.slack_cost());
        let [a, b] = [piece.from, piece.to].map(|t| self.measure.slack(&self.at(t)));
        let floor = self.measure.floor();
        a >= floor && b >= floor && self.proved_by_ends([piece.from, piece.to], [a, b])
    }

    /// Whether the slack is too small at a point where a facet's polynomial suggests it.
    fn lacking(&mut self, bounds: &Bounds, at: f64, floor: f64, loss: f64) -> bool {
        if !bounds.middle.is_some_and(|slack| slack < floor + loss) {
            return false;
        }
        self.spend(self.slack_cost());
        !(self.measure.slack(&self.at(at)) >= floor)
    }

    fn slack_cost(&self) -> usize {
        if self.measure.by_kernel() { KERNEL_COST } else { DEFINITION_COST * self.measure.facets() }
    }

    /// Whether a piece is too short, or the effort too large, to continue.
    fn exhausted(&self, piece: &MotionPiece) -> bool {
        (piece.to - piece.from) * self.length <= CERTIFY_PIECE || piece.halved >= 60 || self.bounds == 0
    }

    /// The verdict on one pair of facets on a piece of the motion; `facets` belongs to that piece.
    fn judged(&mut self, facets: &Facets, pair: &FacetPair, [start, end]: [f64; 2], floor: f64) -> MotionVerdict {
        let inner = |t: f64| (t - start) / (end - start);
        let mut waiting = Waiting::of(MotionPiece { from: start, to: end, halved: 0 });
        while let Some(piece) = waiting.pop() {
            let bounds = facets.bounds(pair, inner(piece.from), inner(piece.to), floor + self.loss(&piece));
            if bounds.holds {
                continue;
            }
            let middle = 0.5 * (piece.from + piece.to);
            if self.lacking(&bounds, middle, floor, self.loss(&piece)) {
                return MotionVerdict::Fails(middle);
            }
            self.spend(1);
            if self.closed(&piece) {
                continue;
            }
            if self.exhausted(&piece) {
                return MotionVerdict::Undecided(piece.from);
            }
            waiting.halve(&piece);
        }
        MotionVerdict::Holds
    }

    /// The verdict on a piece of the motion by facets.
    fn by_facets(&mut self, from: f64, to: f64) -> MotionVerdict {
        let floor = self.measure.floor();
        let (start, end) = (self.at(from), self.at(to));
        let Some(facets) = Facets::new(self.measure, &start, &end) else { return MotionVerdict::Undecided(from) };
        let mut verdict = MotionVerdict::Holds;
        let through = facets.all(|pair| {
            match self.judged(&facets, pair, [from, to], floor) {
                MotionVerdict::Holds => {}
                MotionVerdict::Fails(at) => verdict = MotionVerdict::Fails(at),
                MotionVerdict::Undecided(at) => verdict = MotionVerdict::Undecided(at),
            }
            verdict == MotionVerdict::Holds
        });
        if through || verdict != MotionVerdict::Holds { verdict } else { MotionVerdict::Undecided(from) }
    }
}

/// Whether the slack is at least the measure's floor along the whole motion, including both ends.
pub fn certified(measure: &Measure, from: &Point, to: &Point) -> bool {
    verdict(measure, from, to) == MotionVerdict::Holds
}

/// The verdict on a motion, including both ends.
pub fn verdict(measure: &Measure, from: &Point, to: &Point) -> MotionVerdict {
    let floor = measure.floor();
    let enough = |slack: f64| slack >= floor;
    if from == to {
        return if enough(measure.slack(from)) { MotionVerdict::Holds } else { MotionVerdict::Fails(0.0) };
    }
    if measure.statics().has_pulleys() {
        return halving::verdict(measure, from, to);
    }
    let mut way = Way::new(measure, from, to);
    let slack = way.slack_at_four(&THIRDS);
    if let Some(k) = slack.iter().position(|slack| !enough(*slack)) {
        return MotionVerdict::Fails(THIRDS[k]);
    }
    // The undecided interval.
    let mut open: Option<[f64; 2]> = None;
    let mut leave = |from: f64, to: f64| open = Some([open.map_or(from, |[start, _]| start), to]);
    let mut divisions = if measure.by_kernel() { DIVISIONS } else { 0 };
    for k in 0..WIDTH - 1 {
        let ends = [THIRDS[k], THIRDS[k + 1]];
        if way.proved_by_ends(ends, [slack[k], slack[k + 1]]) {
            continue;
        }
        if divisions == 0 {
            leave(ends[0], ends[1]);
            continue;
        }
        divisions -= 1;
        let inner: [f64; WIDTH] =
            std::array::from_fn(|n| ends[0] + (ends[1] - ends[0]) * (n + 1) as f64 / (WIDTH + 1) as f64);
        let within = way.slack_at_four(&inner);
        if let Some(n) = within.iter().position(|slack| !enough(*slack)) {
            return MotionVerdict::Fails(inner[n]);
        }
        let place = |n: usize| if n == 0 { ends[0] } else { inner.get(n - 1).copied().unwrap_or(ends[1]) };
        let slack_at = |n: usize| if n == 0 { slack[k] } else { within.get(n - 1).copied().unwrap_or(slack[k + 1]) };
        for n in 0..=WIDTH {
            let piece = [place(n), place(n + 1)];
            if !way.proved_by_ends(piece, [slack_at(n), slack_at(n + 1)]) {
                leave(piece[0], piece[1]);
            }
        }
    }
    open.map_or(MotionVerdict::Holds, |[start, end]| way.by_facets(start, end))
}

/// The fraction up to which a motion is certified; `None` if all of it is.
pub fn first_failure(measure: &Measure, from: &Point, to: &Point) -> Option<f64> {
    let known = match verdict(measure, from, to) {
        MotionVerdict::Holds => return None,
        MotionVerdict::Fails(at) | MotionVerdict::Undecided(at) => at,
    };
    let floor = measure.floor();
    if from == to || !(measure.slack(from) >= floor) {
        return Some(0.0);
    }
    if measure.statics().has_pulleys() {
        return Some(halving::first_failure(measure, from, to));
    }
    let mut way = Way::new(measure, from, to);
    let Some(facets) = Facets::new(measure, from, &way.at(known)).filter(|_| known > 0.0) else { return Some(known) };
    let mut end = known;
    facets.all(|pair| {
        let mut waiting = Waiting::of(MotionPiece { from: 0.0, to: end, halved: 0 });
        while let Some(mut piece) = waiting.pop() {
            piece.to = piece.to.min(end);
            if piece.from >= end {
                break;
            }
            let loss = way.loss(&piece);
            let bounds = facets.bounds(pair, piece.from / known, piece.to / known, floor + loss);
            if bounds.holds {
                continue;
            }
            way.spend(1);
            let middle = 0.5 * (piece.from + piece.to);
            if way.lacking(&bounds, middle, floor, loss) {
                end = middle;
            } else if way.closed(&piece) {
                continue;
            }
            if piece.to - piece.from <= PLACE || way.exhausted(&piece) {
                end = piece.from;
                break;
            }
            waiting.halve(&piece);
        }
        true
    });
    Some(end)
}

/// Whether [`least_slack`] along a motion is at least a nonnegative number. Mostly the slack at a few places decides.
pub fn slack_reaches(measure: &Measure, from: &Point, to: &Point, least: f64) -> bool {
    let way = Way::new(measure, from, to);
    let slack = way.slack_at_four(&THIRDS);
    if !slack.iter().all(|slack| *slack >= least) {
        return false;
    }
    let between = |k: usize| {
        let [start, end] = [THIRDS[k], THIRDS[k + 1]].map(|t| way.at(t));
        sagging(slack[k], slack[k + 1], measure.sag(&start, &end)) >= least
    };
    (0..WIDTH - 1).all(between)
        || if measure.statics().has_pulleys() {
            halving::reaches(measure, from, to, least)
        } else {
            least_slack(measure, from, to).0 >= least
        }
}

/// Fractions of a motion at which its slack is computed first.
const THIRDS: [f64; WIDTH] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];

/// The smallest slack along a motion and its fraction, to within [`LEAST_SLACK_RELATIVE`] of the largest tension
/// unless the slack stays almost zero over a long distance; NaN if a cable has no direction.
pub fn least_slack(measure: &Measure, from: &Point, to: &Point) -> (f64, f64) {
    let tolerance = LEAST_SLACK_RELATIVE * measure.statics().largest_tension();
    let mut way = Way::new(measure, from, to);
    let slack = way.slack_at_four(&THIRDS);
    let mut least = (slack[0], 0.0);
    for (slack, at) in slack.into_iter().zip(THIRDS) {
        if slack < least.0 || slack.is_nan() {
            least = (slack, at);
        }
    }
    if from == to || least.0.is_nan() {
        return least;
    }
    if measure.statics().has_pulleys() {
        return halving::least_slack(measure, from, to, tolerance);
    }
    let Some(facets) = Facets::new(measure, from, to) else {
        // Either a cable has no direction (if the slack there is NaN), or there are more cables than `Facets` supports.
        let places = measure.statics().cables().iter().map(|cable| way.nearest(&(cable.outlet - cable.arm)));
        let without = places.map(|at| (measure.slack(&way.at(at)), at)).find(|(slack, _)| slack.is_nan());
        return without.unwrap_or(least);
    };
    facets.all(|pair| {
        let mut waiting = Waiting::of(MotionPiece { from: 0.0, to: 1.0, halved: 0 });
        while let Some(piece) = waiting.pop() {
            let loss = way.loss(&piece);
            let bounds = facets.bounds(pair, piece.from, piece.to, least.0 - tolerance + loss);
            if bounds.holds {
                continue;
            }
            way.spend(1);
            let middle = 0.5 * (piece.from + piece.to);
            if bounds.middle.is_some_and(|slack| slack - loss < least.0) {
                let slack = measure.slack(&way.at(middle));
                if slack < least.0 || slack.is_nan() {
                    least = (slack, middle);
                }
            }
            if !way.exhausted(&piece) {
                waiting.halve(&piece);
            }
        }
        !least.0.is_nan()
    });
    least
}
