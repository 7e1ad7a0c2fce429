//! Certificates for the slack along a straight motion: that it suffices everywhere, where it first fails, and its
//! minimum.
//!
//! Two bounds work together. Slack is computed at four positions at a time, and between two of them it cannot drop by
//! more than [`sagging`] allows. This is cheap and decides most motions, but near the limit it would need pieces as
//! short as the slack is small. The remaining pieces are certified facet by facet (`Facets`): there a piece may be as
//! long as the square root of the slack, and each facet is divided only where it limits.
//!
//! The facets are those at the given outlets. Where the true ones may differ, more slack is required on each piece, by what this
//! can change. With pulleys, facets are polynomials only if exits are taken to move evenly, which requires more slack the longer a
//! piece is; so pieces are halved until their facets decide.

use super::facets::{Bounds, FacetPair, Facets};
use super::measure::{Measure, MotionVerdict, sagging};
use crate::geometry::Point;
use crate::simd::WIDTH;
use crate::tolerances::{CERTIFY_PIECE, LEAST_SLACK_RELATIVE};

/// Number of facet bounds after which certification gives up: some 3 ms, spent only on motions whose slack is
/// almost zero over a long distance.
const MOST_BOUNDS: usize = 10_000;
/// Number of pairs of facets that are found in the time of a facet bound.
const FACETS_OF_A_BOUND: usize = 4;
/// Cost of computing the slack at four positions, in facet bounds: by the kernel, and by definition per facet.
const KERNEL_COST: usize = 8;
const DEFINITION_COST: usize = 8;
/// Maximum number of divisions of pieces before facets are examined.
const DIVISIONS: usize = 2;
/// Number of halvings after which a piece that its facet does not decide is tested by the slack at its ends.
const HALVINGS: u32 = 6;
/// Number of halvings after which a part of a piece on which exits are taken to move evenly is left to shorter pieces.
const PATIENCE: u32 = 2;
/// Accuracy of the position of the first failure, as a share of the motion.
const PLACE: f64 = 1e-10;

/// A motion, the slack that it needs, and the remaining effort for it.
struct Way<'a> {
    measure: &'a Measure,
    from: &'a Point,
    to: &'a Point,
    length: f64,
    /// The least slack at a position.
    floor: f64,
    /// The least value of bounds of the slack between positions.
    proved: f64,
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

impl MotionPiece {
    /// The piece of the whole motion between two fractions.
    fn between(from: f64, to: f64) -> Self {
        MotionPiece { from, to, halved: 0 }
    }
}

/// The facets of a piece of a motion.
struct PieceFacets<'a> {
    facets: Facets<'a>,
    from: f64,
    to: f64,
}

impl PieceFacets<'_> {
    /// A fraction of the motion as a fraction of the piece.
    fn inner(&self, t: f64) -> f64 {
        (t - self.from) / (self.to - self.from)
    }

    fn bounds(&self, pair: &FacetPair, part: &MotionPiece, least: f64) -> Bounds {
        self.facets.bounds(pair, self.inner(part.from), self.inner(part.to), least)
    }

    /// How much smaller the slack can be on a part of the piece than if exits moved evenly along the piece.
    fn loss(&self, part: &MotionPiece) -> f64 {
        if self.facets.loss() == 0.0 {
            return 0.0;
        }
        let [from, to] = [self.inner(part.from), self.inner(part.to)];
        let nearest = 0.5f64.max(from).min(to);
        4.0 * nearest * (1.0 - nearest) * self.facets.loss()
    }
}

/// What the facets of a piece of a motion tell about it.
enum Told<T> {
    Result(T),
    /// Only shorter pieces can tell.
    Shorter,
}

impl<'a> Way<'a> {
    /// A motion on which the slack must be at least the measure's floor.
    fn new(measure: &'a Measure, from: &'a Point, to: &'a Point) -> Self {
        Way { measure, from, to, length: (to - from).norm(), floor: measure.floor(), proved: 0.0, bounds: MOST_BOUNDS }
    }

    /// This motion if the slack must be at least this.
    fn reaching(self, least: f64) -> Self {
        Way { floor: least, proved: least, ..self }
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
        sagging(a, b, self.measure.sag(&self.at(from), &self.at(to))) >= self.proved
    }

    /// The facets of a piece; `None` if a cable may have no direction there, or if there are too many cables.
    fn facets(&mut self, from: f64, to: f64) -> Option<PieceFacets<'a>> {
        self.spend(self.measure.facets() / FACETS_OF_A_BOUND);
        Some(PieceFacets { facets: Facets::new(self.measure, &self.at(from), &self.at(to))?, from, to })
    }

    /// How much smaller the slack can be on a part of a piece than the facets of the piece tell.
    fn loss(&self, facets: &PieceFacets, part: &MotionPiece) -> f64 {
        let errors = match self.measure.statics().has_errors() {
            false => 0.0,
            true => self.measure.loss(&self.at(part.from), &self.at(part.to)),
        };
        errors + facets.loss(part)
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
        a >= self.floor && b >= self.floor && self.proved_by_ends([piece.from, piece.to], [a, b])
    }

    /// Whether the slack is too small at a point where a facet's polynomial suggests it.
    fn lacking(&mut self, bounds: &Bounds, at: f64, loss: f64) -> bool {
        if !bounds.middle.is_some_and(|slack| slack < self.floor + loss) {
            return false;
        }
        self.spend(self.slack_cost());
        !(self.measure.slack(&self.at(at)) >= self.floor)
    }

    fn slack_cost(&self) -> usize {
        if self.measure.by_kernel() { KERNEL_COST } else { DEFINITION_COST * self.measure.facets() }
    }

    /// Whether a piece is too short, or the effort too large, to continue.
    fn exhausted(&self, piece: &MotionPiece) -> bool {
        (piece.to - piece.from) * self.length <= CERTIFY_PIECE || piece.halved >= 60 || self.bounds == 0
    }

    /// Whether shorter pieces may tell more than further halvings of a part of a piece.
    fn impatient(&self, part: &MotionPiece) -> bool {
        self.measure.statics().has_pulleys() && part.halved >= PATIENCE
    }

    /// The verdict on one pair of facets on a piece of the motion.
    fn judged(&mut self, facets: &PieceFacets, pair: &FacetPair) -> Told<MotionVerdict> {
        let mut waiting = Waiting::of(MotionPiece::between(facets.from, facets.to));
        while let Some(part) = waiting.pop() {
            let loss = self.loss(facets, &part);
            let bounds = facets.bounds(pair, &part, self.floor + loss);
            if bounds.holds {
                continue;
            }
            let middle = 0.5 * (part.from + part.to);
            if self.lacking(&bounds, middle, loss) {
                return Told::Result(MotionVerdict::Fails(middle));
            }
            self.spend(1);
            if self.impatient(&part) {
                return Told::Shorter;
            }
            if self.closed(&part) {
                continue;
            }
            if self.exhausted(&part) {
                return Told::Result(MotionVerdict::Undecided(part.from));
            }
            waiting.halve(&part);
        }
        Told::Result(MotionVerdict::Holds)
    }

    /// The verdict on a piece of the motion by its facets.
    fn by_facets(&mut self, piece: &MotionPiece) -> Told<MotionVerdict> {
        let Some(facets) = self.facets(piece.from, piece.to) else { return self.without_facets(piece) };
        let mut told = Told::Result(MotionVerdict::Holds);
        let through = facets.facets.all(&mut |pair| {
            told = self.judged(&facets, pair);
            matches!(told, Told::Result(MotionVerdict::Holds))
        });
        match told {
            Told::Result(MotionVerdict::Holds) if !through => Told::Result(MotionVerdict::Undecided(piece.from)),
            told => told,
        }
    }

    /// The verdict on a piece that has no facets: round pulleys, shorter ones may have.
    fn without_facets(&self, piece: &MotionPiece) -> Told<MotionVerdict> {
        match self.measure.statics().has_pulleys() {
            true => Told::Shorter,
            false => Told::Result(MotionVerdict::Undecided(piece.from)),
        }
    }

    /// The verdict on a part of the motion by facets of as many pieces as are needed.
    fn by_pieces(&mut self, from: f64, to: f64) -> MotionVerdict {
        let mut waiting = Waiting::of(MotionPiece::between(from, to));
        while let Some(piece) = waiting.pop() {
            match self.by_facets(&piece) {
                Told::Result(MotionVerdict::Holds) => {}
                Told::Result(verdict) => return verdict,
                Told::Shorter if self.closed(&piece) => {}
                Told::Shorter if self.exhausted(&piece) => return MotionVerdict::Undecided(piece.from),
                Told::Shorter => waiting.halve(&piece),
            }
        }
        MotionVerdict::Holds
    }

    /// The verdict on the motion, including both ends.
    fn verdict(&mut self) -> MotionVerdict {
        let floor = self.floor;
        let enough = |slack: f64| slack >= floor;
        if self.from == self.to {
            return if enough(self.measure.slack(self.from)) {
                MotionVerdict::Holds
            } else {
                MotionVerdict::Fails(0.0)
            };
        }
        let slack = self.slack_at_four(&THIRDS);
        if let Some(k) = slack.iter().position(|slack| !enough(*slack)) {
            return MotionVerdict::Fails(THIRDS[k]);
        }
        // The undecided interval.
        let mut open: Option<[f64; 2]> = None;
        let mut leave = |from: f64, to: f64| open = Some([open.map_or(from, |[start, _]| start), to]);
        let mut divisions = if self.measure.by_kernel() { DIVISIONS } else { 0 };
        for k in 0..WIDTH - 1 {
            let ends = [THIRDS[k], THIRDS[k + 1]];
            if self.proved_by_ends(ends, [slack[k], slack[k + 1]]) {
                continue;
            }
            if divisions == 0 {
                leave(ends[0], ends[1]);
                continue;
            }
            divisions -= 1;
            let inner: [f64; WIDTH] =
                std::array::from_fn(|n| ends[0] + (ends[1] - ends[0]) * (n + 1) as f64 / (WIDTH + 1) as f64);
            let within = self.slack_at_four(&inner);
            if let Some(n) = within.iter().position(|slack| !enough(*slack)) {
                return MotionVerdict::Fails(inner[n]);
            }
            let place = |n: usize| if n == 0 { ends[0] } else { inner.get(n - 1).copied().unwrap_or(ends[1]) };
            let slack_at =
                |n: usize| if n == 0 { slack[k] } else { within.get(n - 1).copied().unwrap_or(slack[k + 1]) };
            for n in 0..=WIDTH {
                let piece = [place(n), place(n + 1)];
                if !self.proved_by_ends(piece, [slack_at(n), slack_at(n + 1)]) {
                    leave(piece[0], piece[1]);
                }
            }
        }
        open.map_or(MotionVerdict::Holds, |[start, end]| self.by_pieces(start, end))
    }

    /// Where one pair of facets first fails on a piece, not after `end`.
    fn first_of_pair(&mut self, facets: &PieceFacets, pair: &FacetPair, mut end: f64) -> Told<f64> {
        let mut waiting = Waiting::of(MotionPiece::between(facets.from, end));
        while let Some(mut part) = waiting.pop() {
            part.to = part.to.min(end);
            if part.from >= end {
                break;
            }
            let loss = self.loss(facets, &part);
            let bounds = facets.bounds(pair, &part, self.floor + loss);
            if bounds.holds {
                continue;
            }
            self.spend(1);
            let middle = 0.5 * (part.from + part.to);
            if self.lacking(&bounds, middle, loss) {
                end = middle;
            } else if self.impatient(&part) && part.to - part.from > PLACE {
                return Told::Shorter;
            } else if self.closed(&part) {
                continue;
            }
            if part.to - part.from <= PLACE || self.exhausted(&part) {
                return Told::Result(part.from);
            }
            waiting.halve(&part);
        }
        Told::Result(end)
    }

    /// Where the motion first fails by facets, not after `end`, where it may.
    fn first_by_pieces(&mut self, end: f64) -> f64 {
        let mut waiting = Waiting::of(MotionPiece::between(0.0, end));
        while let Some(piece) = waiting.pop() {
            let piece = MotionPiece { to: piece.to.min(end), ..piece };
            if piece.from >= end {
                break;
            }
            let mut first = Told::Result(end);
            match self.facets(piece.from, piece.to) {
                Some(facets) => {
                    facets.facets.all(&mut |pair| {
                        if let Told::Result(known) = first {
                            first = self.first_of_pair(&facets, pair, known.min(piece.to));
                        }
                        matches!(first, Told::Result(_))
                    });
                }
                None if self.measure.statics().has_pulleys() => first = Told::Shorter,
                None => return end,
            }
            match first {
                Told::Result(at) if at < piece.to => return at,
                Told::Result(_) => {}
                Told::Shorter if self.closed(&piece) => {}
                Told::Shorter if self.exhausted(&piece) => return piece.from,
                Told::Shorter => waiting.halve(&piece),
            }
        }
        end
    }
}

/// Whether the slack is at least the measure's floor along the whole motion, including both ends.
pub fn certified(measure: &Measure, from: &Point, to: &Point) -> bool {
    verdict(measure, from, to) == MotionVerdict::Holds
}

/// The verdict on a motion, including both ends.
pub fn verdict(measure: &Measure, from: &Point, to: &Point) -> MotionVerdict {
    Way::new(measure, from, to).verdict()
}

/// Whether the slack along a motion is proved to be at least a nonnegative number. Mostly the slack at a few places decides.
pub fn slack_reaches(measure: &Measure, from: &Point, to: &Point, least: f64) -> bool {
    Way::new(measure, from, to).reaching(least).verdict() == MotionVerdict::Holds
}

/// The fraction up to which a motion is certified; `None` if all of it is.
pub fn first_failure(measure: &Measure, from: &Point, to: &Point) -> Option<f64> {
    let mut way = Way::new(measure, from, to);
    let known = match way.verdict() {
        MotionVerdict::Holds => return None,
        MotionVerdict::Fails(at) | MotionVerdict::Undecided(at) => at,
    };
    if from == to || !(measure.slack(from) >= way.floor) {
        return Some(0.0);
    }
    way.bounds = MOST_BOUNDS;
    Some(if known > 0.0 { way.first_by_pieces(known) } else { known })
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
    let mut waiting = Waiting::of(MotionPiece::between(0.0, 1.0));
    while let Some(piece) = waiting.pop() {
        let Some(facets) = way.facets(piece.from, piece.to) else {
            if measure.statics().has_pulleys() && !way.exhausted(&piece) {
                waiting.halve(&piece);
                continue;
            }
            // Either a cable has no direction (if the slack there is NaN), or there are more cables than `Facets` supports.
            let places = measure.statics().cables().iter().map(|cable| way.nearest(&(cable.outlet - cable.arm)));
            let places = places.chain([piece.from, piece.to]);
            let without = places.map(|at| (measure.slack(&way.at(at)), at)).find(|(slack, _)| slack.is_nan());
            return without.unwrap_or(least);
        };
        let mut shorter = false;
        facets.facets.all(&mut |pair| {
            let mut parts = Waiting::of(MotionPiece::between(piece.from, piece.to));
            while let Some(part) = parts.pop() {
                let loss = way.loss(&facets, &part);
                let bounds = facets.bounds(pair, &part, least.0 - tolerance + loss);
                if bounds.holds {
                    continue;
                }
                way.spend(1);
                let middle = 0.5 * (part.from + part.to);
                if bounds.middle.is_some_and(|slack| slack - loss < least.0) {
                    let slack = measure.slack(&way.at(middle));
                    if slack < least.0 || slack.is_nan() {
                        least = (slack, middle);
                    }
                }
                if way.impatient(&part) {
                    shorter = true;
                    break;
                }
                if !way.exhausted(&part) {
                    parts.halve(&part);
                }
            }
            !shorter && !least.0.is_nan()
        });
        if least.0.is_nan() {
            break;
        }
        if shorter && !way.exhausted(&piece) {
            waiting.halve(&piece);
        }
    }
    least
}
