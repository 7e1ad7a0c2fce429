//! Rounds the waypoints of a path of poses at which a turn begins, ends or changes.
//!
//! The lines before and after such a waypoint are cut, and a [`TurningBend`] replaces the part that is cut off. It is
//! proved free in the same way as motions between poses: each part of it stays close to the motion at constant rates
//! between the ends of the part, and the conditions are bounded for all motions that stay that close. A bend that is
//! not proved is made smaller; if that does not help, the platform stops there.

use std::sync::Arc;

use super::corners::{Corner, Part, PartCorner, Passing, SIZES};
use super::curve::Piece;
use super::turning_bend::TurningBend;
use crate::collision::{Checker, Conditions, Engine, Interference};
use crate::compiled::engine_within;
use crate::error::Error;
use crate::geometry::{Placed, Pose, Rotation, Vector};
use crate::limits::{BEND_HALVINGS, BEND_WRENCH_PIECES};
use crate::model::{RuleSpec, Scene};
use crate::tolerances::{LEAST_TURNING_BEND, STRAIGHT_ON, TOO_CLOSE_TO_TURN};
use crate::turning::{AllowedTurns, TurningWrench};
use crate::watch::Watch;

/// The requirements on bends on which the platform turns: all conditions of a scene and its required wrenches, at any orientation.
pub struct TurningSpace {
    checker: Arc<dyn Checker>,
    reference: Rotation,
    allowed: Vec<AllowedTurns>,
    wrench: Option<TurningWrench>,
}

impl TurningSpace {
    /// The requirements of a scene. `None` if required wrenches cannot be proved on any bend: under the grid rule, whose cells
    /// are for one orientation, and for a point mass, which its cables cannot turn.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn of(scene: &Scene, watch: &Watch) -> Result<Option<Self>, Error> {
        if scene.wrench().is_some_and(|spec| spec.rule == Some(RuleSpec::Grid)) {
            return Ok(None);
        }
        let wrench = TurningWrench::of(scene)?;
        if wrench.as_ref().is_some_and(TurningWrench::of_point_mass) {
            return Ok(None);
        }
        let checker = engine_within(scene, Engine::Gjk, Interference::Exact, watch)?;
        Ok(Some(TurningSpace { checker, reference: *scene.orientation(), allowed: AllowedTurns::of(scene), wrench }))
    }

    /// Distance from the platform's origin to its farthest corner or attachment, m.
    pub fn reach(&self) -> f64 {
        self.checker.conditions().bodies.reach()
    }

    /// Whether a bend is certainly free.
    pub fn allows(&self, bend: &TurningBend) -> bool {
        let corner = Placed::new(bend.corner(), &self.reference);
        let turns = |allowed: &AllowedTurns| allowed.keeps_within(&corner, bend.swing(allowed.line()));
        let all: Vec<usize> = (0..self.checker.conditions().list.len()).collect();
        let balanced = |wrench: &TurningWrench| wrench.keeps_along(bend, BEND_WRENCH_PIECES);
        self.allowed.iter().all(turns)
            && self.keeps(bend, [0.0, bend.length()], &all, BEND_HALVINGS)
            && self.wrench.iter().all(balanced)
    }

    /// Whether these conditions are proved between two parameters: by a bound, or on both halves.
    fn keeps(&self, bend: &TurningBend, [from, to]: [f64; 2], conditions: &[usize], halvings: usize) -> bool {
        let Conditions { list, bodies, .. } = self.checker.conditions();
        let piece = bend.piece([from, to], &self.reference);
        let unproved = |index: &&usize| !list[**index].details().kept_during_turn(bodies, &piece);
        let left: Vec<usize> = conditions.iter().filter(unproved).copied().collect();
        if left.is_empty() {
            return true;
        }
        let middle = 0.5 * (from + to);
        let there = Placed::new(&bend.pose(middle), &self.reference);
        let close = |index: &usize| !(list[*index].details().slack_at(bodies, &there) >= TOO_CLOSE_TO_TURN);
        if halvings == 0 || left.iter().any(close) {
            return false;
        }
        [[from, middle], [middle, to]].into_iter().all(|half| self.keeps(bend, half, &left, halvings - 1))
    }
}

/// Share of a line that a bend may cut off, if only one of its ends is cut and if both are. The rest stays a line long
/// enough to have a direction.
const ROOM: [f64; 2] = [0.9, 0.45];

/// The pieces of a part with bends at corners where the platform turns, as far as they are free and deviate by at most
/// `blend`, m.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn rounded_turns(scene: &Scene, part: Part, blend: f64, watch: &Watch) -> Result<Part, Error> {
    if !(blend > 0.0 && part.corners.iter().any(|at| at.corner.turn)) {
        return Ok(part);
    }
    let Some(space) = TurningSpace::of(scene, watch)? else { return Ok(part) };
    let joins = Joins::of(&part);
    let mut bends: Vec<Option<TurningBend>> = vec![None; part.pieces.len()];
    for PartCorner { piece, .. } in part.corners.iter().filter(|at| at.corner.turn) {
        bends[*piece] = joins.bend(*piece, blend, &space, watch)?;
    }
    Ok(with_bends(part, &bends, space.reach()))
}

/// The pieces of a part, and whether a bend may begin at each.
struct Joins<'a> {
    pieces: &'a [Piece],
    joined: Vec<bool>,
}

impl<'a> Joins<'a> {
    fn of(part: &'a Part) -> Self {
        let mut joined = vec![false; part.pieces.len() + 1];
        part.corners.iter().filter(|at| at.corner.turn).for_each(|at| joined[at.piece] = true);
        Joins { pieces: &part.pieces, joined }
    }

    /// Length of a line that a bend may cut off, m.
    fn room(&self, piece: usize) -> f64 {
        let both = self.joined[piece] && self.joined[piece + 1];
        self.pieces[piece].length * ROOM[usize::from(both)]
    }

    /// The largest free bend at the start of a piece.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn bend(
        &self,
        piece: usize,
        blend: f64,
        space: &TurningSpace,
        watch: &Watch,
    ) -> Result<Option<TurningBend>, Error> {
        let [before, after] = [&self.pieces[piece - 1], &self.pieces[piece]];
        if !(before.is_line() && after.is_line()) {
            return Ok(None);
        }
        let ([v1, w1], [v2, w2]) = (rates(before), rates(after));
        let (velocities, spins, reach) = ([v1, v2], [w1, w2], space.reach());
        if reverses(&velocities, &spins, reach) {
            return Ok(None);
        }
        let corner = Pose::new(after.control()[0], after.attitude().ends()[0]);
        let room = 2.0 * self.room(piece - 1).min(self.room(piece));
        let most = room.min(TurningBend::length_for(blend, &velocities, &spins, reach));
        let sizes = (0..SIZES).map(|k| most * 0.5_f64.powi(k)).take_while(|length| *length >= LEAST_TURNING_BEND);
        for length in sizes {
            watch.check()?;
            let bend = TurningBend::new(corner, velocities, spins, length);
            if space.allows(&bend) {
                return Ok(Some(bend));
            }
        }
        Ok(None)
    }
}

/// Rates of position and orientation along a line, m/m and rad/m.
fn rates(line: &Piece) -> [Vector; 2] {
    let jet = line.at(0.0);
    [jet.first, jet.spin]
}

/// Whether the motion goes back the way it came, so that the platform must stop.
fn reverses(velocities: &[Vector; 2], spins: &[Vector; 2], reach: f64) -> bool {
    let norm = |k: usize| velocities[k].norm().hypot(reach * spins[k].norm());
    let [a, b] = [0, 1].map(norm);
    let sum = |vectors: &[Vector; 2]| (vectors[0] / a + vectors[1] / b).norm();
    !(sum(velocities).hypot(reach * sum(spins)) > STRAIGHT_ON)
}

/// The part with these bends at the starts of its pieces, which are cut.
fn with_bends(part: Part, bends: &[Option<TurningBend>], reach: f64) -> Part {
    let (mut pieces, mut starts) = (Vec::new(), Vec::new());
    for (k, piece) in part.pieces.into_iter().enumerate() {
        starts.push(pieces.len());
        let cut = |bend: Option<&Option<TurningBend>>| bend.copied().flatten().map_or(0.0, |bend| 0.5 * bend.length());
        let [first, last] = [cut(bends.get(k)), cut(bends.get(k + 1))];
        pieces.extend(bends[k].map(Piece::turning_bend));
        pieces.push(match first > 0.0 || last > 0.0 {
            true => piece.part_of_line([first, piece.length - last]),
            false => piece,
        });
    }
    let moved = |PartCorner { corner, piece }: PartCorner| {
        let bend = bends[piece].filter(|_| corner.turn);
        let deviation =
            |bend: TurningBend| Corner { passing: Passing::Rounded, deviation: bend.deviation(reach), ..corner };
        PartCorner { corner: bend.map_or(corner, deviation), piece: starts[piece] }
    };
    let corners = part.corners.into_iter().map(moved).collect();
    Part { pieces, corners }
}
