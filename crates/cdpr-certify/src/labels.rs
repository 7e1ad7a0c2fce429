//! Labels of places where a path may bend: lower bounds of the distance from the start.
//!
//! A label may be anything up to the straight distance from the start. For any other piece and each one that may come before
//! it, one of these holds; otherwise the certificate is refused.
//!
//! - The label at the end of a straight segment from one piece to the other exceeds the one at its beginning by no more than
//!   its length, which is at least u·(y - x) for each unit vector u. That is linear in x and in y, so the ends of the pieces
//!   decide.
//! - One region blocks all segments between them: at some fraction of the way, those between the ends are inside.
//! - The pieces are on one line, or a path cannot bend at one of them towards the other: from there exactly one of the two
//!   planes that meet in the edge is seen from outside.
//! - With the straight way to the goal, the path is too long to matter.
//!
//! All numbers are at most 1000 m. A sum here has a dozen terms, so its rounding error is below 1e-11 m, far less than the
//! reserve of every decision.

use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;
use cdpr_core::watch::Watch;

use crate::bends::{NEAR, NO_DIRECTION, unit};

/// How much a label may exceed the length of a path for each bend, m. This covers the shortfall of an inequality ([`LACKING`]),
/// twice the distance between a bend and its listed place ([`NEAR`]), and rounding errors.
pub const STEP: f64 = 2e-8;
const _: () = assert!(LACKING + 2.0 * NEAR + 1e-10 < STEP);
/// The shortfall up to which the inequality of two labels is accepted, m.
pub const LACKING: f64 = 1.9e-8;
/// Depth from which a place counts as inside a region, m: more than the distance of a bend from its listed place.
const DEPTH: f64 = 5e-10;
/// Height over a plane up to which a place may be below it, and depth up to which it may be above it, m.
const LEVEL: f64 = 1e-9;
/// A tangent at the nearest point keeps this distance from the ends of a piece, as a share.
const BESIDE: f64 = 1.0 / 16.0;

/// A half-space with the numbers of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Unit normal of the plane.
    pub normal: Vector,
    /// Inside the half-space, n·x is less than this.
    pub offset: f64,
}

impl Plane {
    fn height(&self, x: &Vector) -> f64 {
        self.normal.dot(x) - self.offset
    }
}

/// The ends of a piece, and its labels there.
#[derive(Debug, Clone, Copy)]
pub struct Ends {
    /// Positions of the ends, m.
    pub ends: [Vector; 2],
    /// Labels at the ends, m.
    pub labels: [f64; 2],
}

/// A piece of an edge, or a corner.
pub struct LabelledPiece {
    /// Ends of the piece, with labels.
    pub ends: Ends,
    /// The planes that meet in the piece's edge; `None` if nothing follows from them.
    pub crossed: Option<[Plane; 2]>,
}

/// Checks the labels of all pieces and that of the goal, which follows from the length to be proved and the number of bends.
pub fn hold(
    regions: &[Vec<Plane>],
    [start, goal]: [Vector; 2],
    pieces: &[LabelledPiece],
    (length, bends): (f64, usize),
    watch: &Watch,
) -> Result<(), Error> {
    let enough = length + STEP * (bends + 2) as f64;
    let point =
        |at: Vector, label: f64| LabelledPiece { ends: Ends { ends: [at; 2], labels: [label; 2] }, crossed: None };
    let (start, end) = (point(start, 0.0), point(goal, enough));
    let all: Vec<&LabelledPiece> = std::iter::once(&start).chain(pieces).chain([&end]).collect();
    let blocks = Blocks::of(regions, &all);
    let last = all.len() - 1;
    let derived: Vec<usize> = (1..=last).filter(|j| !grows_slowly(&start.ends, &all[*j].ends)).collect();
    for (i, from) in all[..last].iter().enumerate() {
        watch.check()?;
        let mut recent = 0;
        for (j, to) in derived.iter().map(|j| (*j, all[*j])).filter(|(j, _)| *j != i) {
            let fine = grows_slowly(&from.ends, &to.ends)
                || !may_follow(from, to)
                || blocks.block(i, j, &mut recent)
                || is_too_long(&from.ends, &to.ends, &goal, enough);
            if !fine {
                return Err(Error::invalid("edges", refusal(&from.ends, &to.ends, j == last)));
            }
        }
    }
    Ok(())
}

fn refusal(from: &Ends, to: &Ends, is_goal: bool) -> String {
    let [x, y] = [from, to].map(|piece| -> [f64; 3] { ((piece.ends[0] + piece.ends[1]) * 0.5).into() });
    let label = 0.5 * (to.labels[0] + to.labels[1]);
    let what = if is_goal { "the goal".to_string() } else { format!("the piece around {y:?}") };
    format!("found the label {label} of {what}, expected what it can be after the piece around {x:?}, or less")
}

/// Whether no label of a piece exceeds those of another by more than the length of the way.
fn grows_slowly(from: &Ends, to: &Ends) -> bool {
    units(from, to).any(|unit| lacking(from, to, &unit) <= LACKING)
}

/// Unit vectors that may prove something about two pieces: tangents in the middle and near the other piece, and the
/// direction between their nearest points, which is best if labels are constant, or zero if they touch.
fn units(from: &Ends, to: &Ends) -> impl Iterator<Item = Vector> {
    let middle = std::iter::once_with(|| tangent(from, to, 0.5));
    let beside = std::iter::once_with(|| tangent(from, to, nearest(to, from)[0].clamp(BESIDE, 1.0 - BESIDE)));
    let others = [|from: &Ends, to: &Ends| between_nearest(from, to), |_: &Ends, _: &Ends| Vector::zeros()];
    middle.chain(beside).chain(others.into_iter().map(|unit| unit(from, to)))
}

/// How much faster the labels grow than the distance along a unit vector, m.
fn lacking(from: &Ends, to: &Ends, unit: &Vector) -> f64 {
    let pairs = (0..4).map(|k| (k & 1, k >> 1));
    let one = |(a, b): (usize, usize)| to.labels[b] - from.labels[a] - unit.dot(&(to.ends[b] - from.ends[a]));
    pairs.map(one).fold(f64::NEG_INFINITY, f64::max)
}

/// Whether every way over two pieces and straight to the goal has a certain length.
fn is_too_long(from: &Ends, to: &Ends, goal: &Vector, enough: f64) -> bool {
    let ahead = unit(&(goal - (to.ends[0] + to.ends[1]) * 0.5));
    let left = to.ends.map(|end| enough - ahead.dot(&(goal - end)));
    let left = Ends { labels: left, ..*to };
    units(from, to).any(|unit| lacking(from, &left, &unit) <= 0.0)
}

/// The unit vector in whose direction a place of a piece is reached soonest from another piece, given its label.
fn tangent(from: &Ends, to: &Ends, share: f64) -> Vector {
    let y = to.ends[0] + (to.ends[1] - to.ends[0]) * share;
    let way = from.ends[1] - from.ends[0];
    let length = way.norm();
    if length <= NO_DIRECTION {
        return unit(&(y - from.ends[0]));
    }
    let along = way / length;
    let slope = ((from.labels[1] - from.labels[0]) / length).clamp(-1.0, 1.0);
    let foot = (y - from.ends[0]).dot(&along);
    let height = (y - from.ends[0] - along * foot).norm();
    let flat = (1.0 - slope * slope).sqrt();
    let nearest = if flat > 1e-6 { foot - slope * height / flat } else { -slope * f64::INFINITY };
    let nearest = nearest.clamp(0.0, length);
    (y - from.ends[0] - along * nearest).try_normalize(NO_DIRECTION).unwrap_or(along * slope)
}

/// The unit vector between the nearest points of two pieces.
fn between_nearest(from: &Ends, to: &Ends) -> Vector {
    let [s, t] = nearest(from, to);
    let at = |piece: &Ends, share: f64| piece.ends[0] + (piece.ends[1] - piece.ends[0]) * share;
    unit(&(at(to, t) - at(from, s)))
}

/// The shares at which two segments are nearest: from one to the other in turn.
fn nearest(a: &Ends, b: &Ends) -> [f64; 2] {
    let ways = [a.ends[1] - a.ends[0], b.ends[1] - b.ends[0]];
    let gap = b.ends[0] - a.ends[0];
    let onto = |x: f64, square: f64| if square > 0.0 { (x / square).clamp(0.0, 1.0) } else { 0.0 };
    let squares = ways.map(|way| way.norm_squared());
    let both = ways[0].dot(&ways[1]);
    let area = squares[0] * squares[1] - both * both;
    let mut s = onto(gap.dot(&ways[0]) * squares[1] - gap.dot(&ways[1]) * both, area);
    let mut t = 0.0;
    for _ in 0..2 {
        t = onto((ways[0] * s - gap).dot(&ways[1]), squares[1]);
        s = onto((ways[1] * t + gap).dot(&ways[0]), squares[0]);
    }
    [s, t]
}

/// Whether a shortest path may bend at both pieces, one after the other.
fn may_follow(a: &LabelledPiece, b: &LabelledPiece) -> bool {
    let on_one_line = match (&a.crossed, &b.crossed) {
        (Some(own), Some(others)) => own.iter().all(|plane| others.contains(plane)),
        _ => false,
    };
    !on_one_line && may_bend_towards(a, b) && may_bend_towards(b, a)
}

/// Whether from somewhere on another piece exactly one of the two planes is seen from outside.
fn may_bend_towards(piece: &LabelledPiece, other: &LabelledPiece) -> bool {
    let Some(planes) = &piece.crossed else { return true };
    let [a, b] = planes.map(|plane| other.ends.ends.map(|end| plane.height(&end)));
    let below = |heights: [f64; 2]| part_below(heights.map(|height| height - LEVEL));
    let above = |heights: [f64; 2]| part_below(heights.map(|height| -height - LEVEL));
    overlap(below(a), above(b)) || overlap(below(b), above(a))
}

/// The fractions between which a linear function is not positive, a little more; `None` if nowhere.
fn part_below([a, b]: [f64; 2]) -> Option<[f64; 2]> {
    match (a <= 0.0, b <= 0.0) {
        (true, true) => Some([0.0, 1.0]),
        (true, false) => Some([0.0, a / (a - b) + 1e-9]),
        (false, true) => Some([a / (a - b) - 1e-9, 1.0]),
        (false, false) => None,
    }
}

fn overlap(a: Option<[f64; 2]>, b: Option<[f64; 2]>) -> bool {
    a.zip(b).is_some_and(|(a, b)| a[0].max(b[0]) <= a[1].min(b[1]))
}

/// How high pieces reach over the planes of regions.
struct Blocks {
    /// For each piece and region, the larger height of both ends over each plane.
    highest: Vec<Vec<Vec<f64>>>,
}

impl Blocks {
    fn of(regions: &[Vec<Plane>], pieces: &[&LabelledPiece]) -> Self {
        let over = |piece: &LabelledPiece, plane: &Plane| {
            piece.ends.ends.map(|end| plane.height(&end)).into_iter().fold(f64::MIN, f64::max)
        };
        let of_region =
            |piece: &LabelledPiece, region: &Vec<Plane>| region.iter().map(|plane| over(piece, plane)).collect();
        let highest = pieces.iter().map(|piece| regions.iter().map(|region| of_region(piece, region)).collect());
        Blocks { highest: highest.collect() }
    }

    /// Whether one region blocks all segments between two pieces; tries the one that did so most recently first.
    fn block(&self, i: usize, j: usize, recent: &mut usize) -> bool {
        let (a, b) = (&self.highest[i], &self.highest[j]);
        let mut order = std::iter::once(*recent).chain(0..a.len());
        match order.find(|k| a.get(*k).is_some_and(|a| blocks(a, &b[*k]))) {
            Some(k) => {
                *recent = k;
                true
            }
            None => false,
        }
    }
}

/// Whether there is a fraction of the way at which these heights, which change linearly, are all below zero.
fn blocks(a: &[f64], b: &[f64]) -> bool {
    let [mut low, mut high] = [0.0f64, 1.0f64];
    for (a, b) in a.iter().zip(b).map(|(a, b)| (a + DEPTH, b + DEPTH)) {
        if a >= 0.0 && b >= 0.0 {
            return false;
        }
        if a > 0.0 {
            low = low.max(a / (a - b));
        } else if b > 0.0 {
            high = high.min(a / (a - b));
        }
    }
    let middle = 0.5 * (low + high);
    a.iter().zip(b).all(|(a, b)| a + middle * (b - a) < 0.5 * -DEPTH)
}
