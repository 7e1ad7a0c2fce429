//! Certificates along straight motions of robots with pulleys, whose columns are no polynomials of the position: pieces are cut
//! until the slack at their ends proves them (`sagging`).

use std::collections::{BinaryHeap, VecDeque};

use super::measure::{Measure, MotionVerdict, sagging};
use crate::geometry::Point;
use crate::simd::WIDTH;
use crate::tolerances::CERTIFY_PIECE;

/// Number of pieces that are cut at most: some 20 ms. By definition a slack takes longer.
const MOST_CUTS: usize = 1000;
const MOST_CUTS_BY_DEFINITION: usize = 200;

/// Accuracy of the position of the first failure, as a share of the motion.
const PLACE: f64 = 1e-10;

/// A piece of a motion between two fractions of it, and the slack there.
#[derive(Debug, Clone, Copy)]
struct Slackened {
    at: [f64; 2],
    slack: [f64; 2],
}

struct Way<'a> {
    measure: &'a Measure,
    from: &'a Point,
    to: &'a Point,
    length: f64,
    cuts: usize,
}

impl<'a> Way<'a> {
    fn new(measure: &'a Measure, from: &'a Point, to: &'a Point) -> Self {
        let cuts = if measure.by_kernel() { MOST_CUTS } else { MOST_CUTS_BY_DEFINITION };
        Way { measure, from, to, length: (to - from).norm(), cuts }
    }

    fn at(&self, t: f64) -> Point {
        self.from + (self.to - self.from) * t
    }

    /// The motion in one piece.
    fn whole(&self) -> Slackened {
        Slackened { at: [0.0, 1.0], slack: [self.from, self.to].map(|p| self.measure.slack(p)) }
    }

    /// A lower bound of the slack on a piece whose ends have some.
    fn bound(&self, Slackened { at, slack: [a, b] }: &Slackened) -> f64 {
        sagging(*a, *b, self.measure.sag(&self.at(at[0]), &self.at(at[1])))
    }

    /// A piece in five parts.
    fn cut(&mut self, Slackened { at: [from, to], slack: [a, b] }: &Slackened) -> [Slackened; WIDTH + 1] {
        self.cuts = self.cuts.saturating_sub(1);
        let inner: [f64; WIDTH] = std::array::from_fn(|n| from + (to - from) * (n + 1) as f64 / (WIDTH + 1) as f64);
        let within = self.measure.slack_at_four(&inner.map(|t| self.at(t)));
        let place =
            |n: usize| if n == 0 { (*from, *a) } else { inner.get(n - 1).map_or((*to, *b), |t| (*t, within[n - 1])) };
        std::array::from_fn(|n| {
            let (before, after) = (place(n), place(n + 1));
            Slackened { at: [before.0, after.0], slack: [before.1, after.1] }
        })
    }

    /// Whether a piece is too short, or the effort too large, to continue.
    fn exhausted(&self, piece: &Slackened) -> bool {
        let [from, to] = piece.at;
        (to - from) * self.length <= CERTIFY_PIECE || self.cuts == 0
    }

    /// The verdict on slack of at least `least`, proved by bounds of at least `proved`. With `exact`, a failure is the first one;
    /// otherwise large pieces are examined first.
    fn verdict(&mut self, least: f64, proved: f64, exact: bool) -> MotionVerdict {
        let whole = self.whole();
        if let Some(k) = whole.slack.iter().position(|slack| !(*slack >= least))
            && (k == 0 || !exact)
        {
            return MotionVerdict::Fails(whole.at[k]);
        }
        let mut waiting = VecDeque::from([whole]);
        while let Some(piece) = if exact { waiting.pop_back() } else { waiting.pop_front() } {
            let fails = !(piece.slack[1] >= least);
            if !fails && self.bound(&piece) >= proved {
                continue;
            }
            if fails && piece.at[1] - piece.at[0] <= PLACE {
                return MotionVerdict::Fails(piece.at[0]);
            }
            if self.exhausted(&piece) {
                return MotionVerdict::Undecided(waiting.iter().map(|open| open.at[0]).fold(piece.at[0], f64::min));
            }
            let parts = self.cut(&piece);
            let failing = parts.iter().position(|part| !(part.slack[1] >= least));
            match failing {
                Some(k) if !exact => return MotionVerdict::Fails(parts[k].at[1]),
                Some(k) => {
                    // What follows a failure does not matter.
                    waiting.clear();
                    waiting.extend(parts[..=k].iter().rev());
                }
                None => waiting.extend(parts.iter().rev()),
            }
        }
        MotionVerdict::Holds
    }
}

/// The verdict on a motion, including both ends.
pub fn verdict(measure: &Measure, from: &Point, to: &Point) -> MotionVerdict {
    Way::new(measure, from, to).verdict(measure.floor(), 0.0, false)
}

/// The fraction up to which a motion that is not certified is.
pub fn first_failure(measure: &Measure, from: &Point, to: &Point) -> f64 {
    match Way::new(measure, from, to).verdict(measure.floor(), 0.0, true) {
        MotionVerdict::Holds => 1.0,
        MotionVerdict::Fails(at) | MotionVerdict::Undecided(at) => at,
    }
}

/// Whether the slack along a motion is proved to be at least this.
pub fn reaches(measure: &Measure, from: &Point, to: &Point, least: f64) -> bool {
    Way::new(measure, from, to).verdict(least, least, false) == MotionVerdict::Holds
}

/// A piece with a lower bound of its slack; the one with the smallest comes first.
struct Bounded(f64, Slackened);

impl Ord for Bounded {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.0.total_cmp(&self.0)
    }
}

impl PartialOrd for Bounded {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Bounded {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Bounded {}

/// The smallest slack along a motion and its fraction, to within a tolerance unless the effort is too large; NaN if a cable has no
/// direction.
pub fn least_slack(measure: &Measure, from: &Point, to: &Point, tolerance: f64) -> (f64, f64) {
    let mut way = Way::new(measure, from, to);
    let whole = way.whole();
    let mut least = (f64::INFINITY, 0.0);
    let mut waiting = BinaryHeap::from([Bounded(f64::NEG_INFINITY, whole)]);
    while let Some(Bounded(bound, piece)) = waiting.pop() {
        for (slack, at) in piece.slack.into_iter().zip(piece.at) {
            if slack.is_nan() {
                return (slack, at);
            }
            if slack < least.0 {
                least = (slack, at);
            }
        }
        if bound >= least.0 - tolerance || way.exhausted(&piece) {
            break;
        }
        for part in way.cut(&piece) {
            let bound = way.bound(&part);
            waiting.push(Bounded(if bound.is_nan() { f64::NEG_INFINITY } else { bound }, part));
        }
    }
    least
}
