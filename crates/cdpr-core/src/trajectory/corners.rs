//! Turns a path with corners into a curve with continuous curvature.
//!
//! A corner is rounded on its inside where that is free. A shortest path touches what it goes around on the inside of its
//! corners; there the corner is moved outward, so that the rounded curve passes outside of it. Where neither is free, the
//! platform stops at the corner.

use serde::Serialize;

use super::curve::{CONTROL, Curve, Piece};
use super::free_space::FreeSpace;
use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::tolerances::{SAME_POINT, STRAIGHT_ON};
use crate::watch::Watch;

/// How a trajectory passes a corner of its path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Passing {
    /// Rounded on its inside.
    Rounded,
    /// Moved outward, then rounded.
    Outward,
    /// Passed at rest: the platform stops at the corner.
    Stop,
}

/// A corner of the path on the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Index of the waypoint.
    pub waypoint: usize,
    /// How the curve passes the corner.
    pub passing: Passing,
    /// Largest distance between curve and path at the corner, m; where the platform turns, of any of its corners and
    /// attachments.
    pub deviation: f64,
    /// The parameter of the curve at the corner, m.
    pub at: f64,
    /// Whether the platform begins, ends or changes a turn at the corner.
    pub turn: bool,
}

/// Pieces that follow each other, and how they pass corners.
#[derive(Debug, Default)]
pub struct Part {
    /// The pieces of the part.
    pub pieces: Vec<Piece>,
    /// The corners of the part; their parameters are not known yet.
    pub corners: Vec<PartCorner>,
}

/// A corner of a part.
#[derive(Debug)]
pub struct PartCorner {
    /// The corner, with a parameter that is not known yet.
    pub corner: Corner,
    /// Index of the piece that rounds the corner or begins there.
    pub piece: usize,
}

impl Part {
    /// Adds another part that begins where this one ends; waypoints of its corners are counted from `waypoint`.
    pub fn append(&mut self, other: Part, waypoint: usize) {
        let first = self.pieces.len();
        self.pieces.extend(other.pieces);
        self.corners.extend(other.corners.into_iter().map(|PartCorner { corner, piece }| PartCorner {
            corner: Corner { waypoint: waypoint + corner.waypoint, ..corner },
            piece: first + piece,
        }));
    }

    /// The curve and its corners.
    pub fn curve(self) -> (Curve, Vec<Corner>) {
        let curve = Curve::new(self.pieces);
        let placed = |PartCorner { corner, piece }: PartCorner| {
            let length = if corner.passing == Passing::Stop { 0.0 } else { curve.pieces()[piece].length };
            Corner { at: curve.starts()[piece] + 0.5 * length, ..corner }
        };
        let corners = self.corners.into_iter().map(placed).collect();
        (curve, corners)
    }
}

/// Distance of a bend's middle from its corner, as a share of the distance of its ends times the sine of half the angle
/// between the two lines.
const SAG: f64 = 0.375;
/// Where the control points of a bend are, as shares of the distance of its ends from the corner.
const SPACING: [f64; 3] = [1.0, 0.6, 0.2];
/// Share of an outward movement that the rounding may cut off again.
const CUT_AGAIN: f64 = 0.8;
/// Number of sizes that are tried: each is half of the one before.
pub(super) const SIZES: i32 = 6;

/// An attempt at a corner: first the largest deviation inside, then outside, then half of it.
#[derive(Debug, Clone, Copy)]
struct Attempt(i32);

impl Attempt {
    fn passing(self) -> Passing {
        match self.0 {
            n if n >= 2 * SIZES => Passing::Stop,
            n if n % 2 == 0 => Passing::Rounded,
            _ => Passing::Outward,
        }
    }

    fn size(self) -> f64 {
        0.5_f64.powi(self.0 / 2)
    }
}

/// Pieces along a free path whose deviation is at most `blend`, m, and how they pass each corner. At those ends of the path that
/// are `joined` to others, half of the first or last line is left.
///
/// # Errors
/// A path whose waypoints coincide; [`Error::interrupted`], [`Error::out_of_time`].
pub fn rounded(
    waypoints: &[Point],
    blend: f64,
    joined: [bool; 2],
    free: &FreeSpace,
    watch: &Watch,
) -> Result<Part, Error> {
    let path = Waypoints::of(waypoints)?;
    let stop = Attempt(2 * SIZES);
    let mut attempts: Vec<Attempt> =
        (1..path.points.len() - 1).map(|k| if blend > 0.0 && !path.reverses(k) { Attempt(0) } else { stop }).collect();
    loop {
        watch.check()?;
        let layout = Layout::new(&path, &attempts, blend, joined);
        let failed = layout.failed(free);
        if failed.is_empty() {
            return Ok(layout.part(&path));
        }
        for corner in failed {
            attempts[corner].0 += 1;
        }
    }
}

/// The waypoints at which a path bends, with their indices in the path.
struct Waypoints {
    points: Vec<Point>,
    index: Vec<usize>,
}

impl Waypoints {
    fn of(waypoints: &[Point]) -> Result<Self, Error> {
        if waypoints.len() < 2 {
            let problem = format!("found {}, expected at least two", waypoints.len());
            return Err(Error::invalid("waypoints", problem));
        }
        let mut path = Waypoints { points: vec![waypoints[0]], index: vec![0] };
        for (k, point) in waypoints.iter().enumerate().skip(1) {
            let last = path.points.len() - 1;
            if (point - path.points[last]).norm() <= SAME_POINT {
                continue;
            }
            if last > 0 && straight_on(&path.points[last - 1], &path.points[last], point) {
                path.points.pop();
                path.index.pop();
            }
            path.points.push(*point);
            path.index.push(k);
        }
        if path.points.len() < 2 {
            return Err(Error::invalid("waypoints", "found only one position, expected a path that moves"));
        }
        Ok(path)
    }

    fn reverses(&self, k: usize) -> bool {
        let [a, b] = directions(&self.points[k - 1], &self.points[k], &self.points[k + 1]);
        (a + b).norm() <= STRAIGHT_ON
    }
}

fn directions(before: &Point, at: &Point, after: &Point) -> [Vector; 2] {
    [(at - before).normalize(), (after - at).normalize()]
}

/// Whether a waypoint is on the line between its neighbours, so that the path can omit it.
fn straight_on(before: &Point, at: &Point, after: &Point) -> bool {
    let [a, b] = directions(before, at, after);
    a.dot(&b) > 0.0 && a.cross(&b).norm() * (at - before).norm().min((after - at).norm()) <= STRAIGHT_ON
}

/// Lines and bends for one choice of attempts.
struct Layout {
    lines: Vec<Option<Piece>>,
    bends: Vec<Option<Piece>>,
    passings: Vec<Passing>,
    deviations: Vec<f64>,
}

impl Layout {
    fn new(path: &Waypoints, attempts: &[Attempt], blend: f64, joined: [bool; 2]) -> Self {
        let mut points = path.points.clone();
        let last = points.len() - 1;
        for (k, attempt) in attempts.iter().enumerate().filter(|(_, a)| a.passing() == Passing::Outward) {
            let [a, b] = directions(&path.points[k], &path.points[k + 1], &path.points[k + 2]);
            points[k + 1] += (a - b).normalize() * (blend * attempt.size());
        }
        let share = |segment: usize| {
            let length = (points[segment + 1] - points[segment]).norm();
            let ends = segment == 0 && !joined[0] || segment + 1 == last && !joined[1];
            if ends { length } else { 0.5 * length }
        };
        let mut layout = Layout { lines: Vec::new(), bends: Vec::new(), passings: Vec::new(), deviations: Vec::new() };
        let mut from = points[0];
        for (k, attempt) in attempts.iter().enumerate() {
            let [before, corner, after] = [points[k], points[k + 1], points[k + 2]];
            let room = share(k).min(share(k + 1));
            let bend = bend(&before, &corner, &after, *attempt, blend, room);
            let passing = if bend.is_some() { attempt.passing() } else { Passing::Stop };
            let [enter, leave] =
                bend.as_ref().map_or([corner; 2], |(bend, _)| [bend.control()[0], bend.control()[CONTROL - 1]]);
            layout.lines.push(line(from, enter));
            layout.deviations.push(match passing {
                Passing::Stop => 0.0,
                Passing::Rounded => bend.as_ref().map_or(0.0, |(_, sag)| *sag),
                Passing::Outward => blend * attempt.size(),
            });
            layout.passings.push(passing);
            layout.bends.push(bend.map(|(bend, _)| bend));
            from = leave;
        }
        layout.lines.push(line(from, points[last]));
        layout
    }

    /// The corners whose bend or adjacent moved line is not free.
    fn failed(&self, free: &FreeSpace) -> Vec<usize> {
        let blocked = |piece: &Option<Piece>| piece.as_ref().is_some_and(|piece| !free.allows(piece));
        let moved = |corner: Option<usize>| corner.is_some_and(|k| self.passings.get(k) == Some(&Passing::Outward));
        let lines: Vec<bool> = (0..self.lines.len())
            .map(|k| (moved(k.checked_sub(1)) || moved(Some(k))) && blocked(&self.lines[k]))
            .collect();
        let failed = |k: &usize| {
            blocked(&self.bends[*k]) || self.passings[*k] == Passing::Outward && (lines[*k] || lines[*k + 1])
        };
        (0..self.bends.len()).filter(failed).collect()
    }

    fn part(self, path: &Waypoints) -> Part {
        let mut part = Part::default();
        let mut bends = self.bends.into_iter();
        for (k, line) in self.lines.into_iter().enumerate() {
            part.pieces.extend(line);
            let Some(bend) = bends.next() else { break };
            let (waypoint, passing, deviation) = (path.index[k + 1], self.passings[k], self.deviations[k]);
            let corner = Corner { waypoint, passing, deviation, at: 0.0, turn: false };
            part.corners.push(PartCorner { corner, piece: part.pieces.len() });
            part.pieces.extend(bend);
        }
        part
    }
}

fn line(from: Point, to: Point) -> Option<Piece> {
    ((to - from).norm() > SAME_POINT).then(|| Piece::line(from, to))
}

/// The bend at a corner and its distance from the corner, m; `None` if the platform stops there.
fn bend(
    before: &Point,
    corner: &Point,
    after: &Point,
    attempt: Attempt,
    blend: f64,
    room: f64,
) -> Option<(Piece, f64)> {
    let size = attempt.size();
    let [a, b] = directions(before, corner, after);
    let sine = 0.5 * (b - a).norm();
    let reach = match attempt.passing() {
        Passing::Stop => return None,
        Passing::Rounded => room.min(blend / (SAG * sine)) * size,
        Passing::Outward => room.min(CUT_AGAIN * blend * size / (SAG * sine)),
    };
    if !(reach > 2.0 * SAME_POINT) {
        return None;
    }
    let enter = SPACING.map(|share| corner - a * (share * reach));
    let leave = SPACING.map(|share| corner + b * (share * reach));
    let control = [enter[0], enter[1], enter[2], leave[2], leave[1], leave[0]];
    Some((Piece::bend(control), SAG * sine * reach))
}
