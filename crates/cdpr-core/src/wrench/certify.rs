//! Proofs about the slack along a straight motion: that it is nowhere too small, where it first is, how small it gets.
//!
//! Slack is computed at four places at a time; between two of them it cannot sag by more than [`sagging`] allows. Pieces
//! for which that is not enough are cut into five.

use super::measure::{Measure, sagging};
use crate::geometry::Point;
use crate::numerics::simd::WIDTH;
use crate::numerics::{CERTIFY_PIECE, LEAST_SLACK_RELATIVE};

/// A piece of a motion between two fractions of it, with the slack at both.
#[derive(Debug, Clone, Copy, Default)]
struct Piece {
    from: f64,
    to: f64,
    slack: [f64; 2],
}

/// Pieces that wait: each division leaves four more than it takes, and there are at most some thirty in a row.
const WAITING: usize = 160;

/// A motion cut into pieces; the ones that wait stand with the first one on top.
struct March<'a> {
    measure: &'a Measure,
    from: &'a Point,
    to: &'a Point,
    length: f64,
    waiting: [Piece; WAITING],
    count: usize,
    divisions: usize,
    most: usize,
}

impl<'a> March<'a> {
    /// The motion as one piece.
    fn new(measure: &'a Measure, from: &'a Point, to: &'a Point) -> Self {
        let length = (to - from).norm();
        March {
            measure,
            from,
            to,
            length,
            waiting: [Piece::default(); WAITING],
            count: 0,
            divisions: 0,
            most: measure.divisions(),
        }
    }

    fn at(&self, t: f64) -> Point {
        self.from + (self.to - self.from) * t
    }

    fn push(&mut self, piece: Piece) {
        self.waiting[self.count] = piece;
        self.count += 1;
    }

    fn pop(&mut self) -> Option<Piece> {
        self.count = self.count.checked_sub(1)?;
        Some(self.waiting[self.count])
    }

    /// The least slack that there can be on a piece whose ends have some.
    fn bound(&self, piece: &Piece) -> f64 {
        let [a, b] = piece.slack;
        sagging(a, b, self.measure.sag(&self.at(piece.from), &self.at(piece.to)))
    }

    /// Both ends of the motion and two places between them: three pieces.
    fn start(&mut self) -> [Piece; 3] {
        let fractions = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
        let slack = self.measure.slack_at_four(&fractions.map(|t| self.at(t)));
        std::array::from_fn(|k| Piece { from: fractions[k], to: fractions[k + 1], slack: [slack[k], slack[k + 1]] })
    }

    /// A piece in five.
    fn divide(&mut self, piece: &Piece) -> [Piece; WIDTH + 1] {
        self.divisions += 1;
        let fraction = |k: usize| piece.from + (piece.to - piece.from) * k as f64 / (WIDTH + 1) as f64;
        let inner = self.measure.slack_at_four(&std::array::from_fn(|k| self.at(fraction(k + 1))));
        let slack = |k: usize| match k {
            0 => piece.slack[0],
            k if k <= WIDTH => inner[k - 1],
            _ => piece.slack[1],
        };
        let end = |k: usize| if k == WIDTH + 1 { piece.to } else { fraction(k) };
        std::array::from_fn(|k| Piece {
            from: if k == 0 { piece.from } else { fraction(k) },
            to: end(k + 1),
            slack: [slack(k), slack(k + 1)],
        })
    }

    /// Whether a piece is too short, or the work too much, to go on.
    fn exhausted(&self, piece: &Piece) -> bool {
        (piece.to - piece.from) * self.length <= CERTIFY_PIECE
            || self.divisions >= self.most
            || self.count + WIDTH + 1 > WAITING
    }
}

/// Whether the slack is at least the measure's floor all along a motion, both ends included. What cannot be proved, because
/// slack is too small over too long a way, is refused.
pub fn certified(measure: &Measure, from: &Point, to: &Point) -> bool {
    let floor = measure.floor();
    let enough = |pieces: &[Piece]| pieces.iter().all(|piece| piece.slack.iter().all(|slack| *slack >= floor));
    if from == to {
        return measure.slack(from) >= floor;
    }
    let mut march = March::new(measure, from, to);
    let first = march.start();
    if !enough(&first) {
        return false;
    }
    first.into_iter().rev().for_each(|piece| march.push(piece));
    while let Some(piece) = march.pop() {
        if march.bound(&piece) >= 0.0 {
            continue;
        }
        if march.exhausted(&piece) {
            return false;
        }
        let pieces = march.divide(&piece);
        if !enough(&pieces) {
            return false;
        }
        pieces.into_iter().rev().for_each(|piece| march.push(piece));
    }
    true
}

/// The fraction of a motion up to which it is certified; none if all of it is.
pub fn first_failure(measure: &Measure, from: &Point, to: &Point) -> Option<f64> {
    let floor = measure.floor();
    let enough = |slack: f64| slack >= floor;
    let mut march = March::new(measure, from, to);
    let first = march.start();
    let push_up_to_failure = |march: &mut March, pieces: &[Piece]| {
        let failing = pieces.iter().position(|piece| !enough(piece.slack[1]));
        let wanted = failing.map_or(pieces.len(), |k| k + 1);
        if failing.is_some() {
            march.count = 0; // whatever comes later fails later
        }
        pieces[..wanted].iter().rev().for_each(|piece| march.push(*piece));
    };
    if !enough(first[0].slack[0]) {
        return Some(0.0);
    }
    if from == to {
        return None;
    }
    push_up_to_failure(&mut march, &first);
    while let Some(piece) = march.pop() {
        if enough(piece.slack[1]) && march.bound(&piece) >= 0.0 {
            continue;
        }
        if march.exhausted(&piece) {
            return Some(piece.from);
        }
        let pieces = march.divide(&piece);
        push_up_to_failure(&mut march, &pieces);
    }
    None
}

/// The least slack along a motion and the fraction at which it is, up to [`LEAST_SLACK_RELATIVE`] of the largest tension
/// where it is positive (there the bound between two places holds; elsewhere the least of the places looked at); NaN where
/// a cable has no direction.
pub fn least_slack(measure: &Measure, from: &Point, to: &Point) -> (f64, f64) {
    let tolerance = LEAST_SLACK_RELATIVE * measure.statics().largest_tension();
    let mut march = March::new(measure, from, to);
    let first = march.start();
    let mut least = (first[0].slack[0], 0.0);
    let mut note = |pieces: &[Piece]| {
        for piece in pieces {
            if piece.slack[1] < least.0 || piece.slack[1].is_nan() {
                least = (piece.slack[1], piece.to);
            }
        }
        least.0
    };
    let mut known = note(&first);
    if from == to {
        return least;
    }
    first.into_iter().rev().for_each(|piece| march.push(piece));
    while let Some(piece) = march.pop() {
        if known.is_nan() {
            return least;
        }
        if march.bound(&piece) >= known - tolerance || march.exhausted(&piece) {
            continue;
        }
        let pieces = march.divide(&piece);
        known = note(&pieces);
        pieces.into_iter().rev().for_each(|piece| march.push(piece));
    }
    least
}
