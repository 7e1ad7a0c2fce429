//! The curve along a path: parts at one orientation, whose corners are rounded, and turns.
//!
//! A motion between two poses turns about a fixed axis at a constant rate per length. At a waypoint where a turn begins, ends or
//! changes, this rate jumps, as the direction does at a corner. So a bend leads from one to the other
//! ([`turning_corners`](super::turning_corners)), or the platform stops there. Waypoints that the motion between their neighbours passes
//! anyway change nothing.

use std::ops::Range;

use super::attitude::Attitude;
use super::corners::{Corner, Part, PartCorner, Passing, rounded};
use super::curve::{Curve, Piece};
use super::free_space::FreeSpace;
use super::turning_corners::rounded_turns;
use crate::collision::{Engine, Interference, Validity};
use crate::compiled::{CompiledScene, positions};
use crate::error::Error;
use crate::geometry::{Pose, wxyz};
use crate::model::Scene;
use crate::tolerances::{LARGEST_TURN_WEIGHT, LEAST_TURN_LENGTH, SAME_POINT, SAME_TURN, STRAIGHT_ON};
use crate::turning::turn_weight;
use crate::watch::Watch;

/// A part of a path, given by the indices of its waypoints.
#[derive(Debug, Clone, PartialEq)]
enum Stage {
    /// The platform keeps the orientation of the first waypoint.
    Held(Range<usize>),
    /// The platform turns once, from a waypoint to another.
    Turn(usize, usize),
}

/// The curve along a path, which must be free, and how it passes each corner. Bends deviate by at most `blend`, m.
///
/// # Errors
/// A path that does not move; [`Error::interrupted`], [`Error::out_of_time`].
pub fn along_path(
    compiled: &CompiledScene,
    poses: &[Pose],
    blend: f64,
    watch: &Watch,
) -> Result<(Curve, Vec<Corner>), Error> {
    let scene = compiled.scene();
    if scene.keeps_orientation(poses) {
        let free = FreeSpace::new(scene, compiled.level(), watch)?;
        let (curve, corners) = rounded(&positions(poses), blend, [false; 2], &free, watch)?.curve();
        return Ok((curve.held_at(*scene.orientation()), corners));
    }
    let mut whole = Part::default();
    let mut reached = 0;
    let stages = stages(poses, |from, to| compiled.motion_valid(from, to));
    for (k, stage) in stages.iter().enumerate() {
        let joined = [k > 0, k + 1 < stages.len()];
        let (part, first, last) = match stage {
            Stage::Held(range) => {
                (held(compiled, &poses[range.clone()], blend, joined, watch)?, range.start, range.end - 1)
            }
            Stage::Turn(from, to) => (turn(scene, &poses[*from], &poses[*to]), *from, *to),
        };
        if !whole.pieces.is_empty() && !part.pieces.is_empty() {
            let corner = Corner { waypoint: reached, passing: Passing::Stop, deviation: 0.0, at: 0.0, turn: true };
            whole.corners.push(PartCorner { corner, piece: whole.pieces.len() });
        }
        if !part.pieces.is_empty() {
            reached = last;
        }
        whole.append(part, first);
    }
    if whole.pieces.is_empty() {
        return Err(Error::invalid("waypoints", "found only one pose, expected a path that moves"));
    }
    Ok(rounded_turns(scene, whole, blend, watch)?.curve())
}

/// The stages of a path, in order; neighbours share a waypoint. The first and the last one are at one orientation. A turn that
/// passes several waypoints must be proved to be `free`.
fn stages(poses: &[Pose], free: impl Fn(&Pose, &Pose) -> bool) -> Vec<Stage> {
    let (mut stages, mut at) = (Vec::new(), 0);
    loop {
        let held = poses[at..].iter().take_while(|pose| poses[at].angle_to(pose) <= SAME_TURN).count();
        stages.push(Stage::Held(at..at + held));
        let from = at + held - 1;
        if from + 1 == poses.len() {
            return stages;
        }
        let to = end_of_turn(poses, from);
        at = if to == from + 1 || free(&poses[from], &poses[to]) { to } else { from + 1 };
        stages.push(Stage::Turn(from, at));
    }
}

/// The last waypoint that one turn from a waypoint reaches; found by doubling and halving, since paths have many waypoints.
fn end_of_turn(poses: &[Pose], from: usize) -> usize {
    let reaches = |to: usize| to < poses.len() && is_one_turn(&poses[from..=to]);
    let (mut end, mut step) = (from + 1, 1);
    while reaches(end + step) {
        end += step;
        step *= 2;
    }
    while step > 1 {
        step /= 2;
        if reaches(end + step) {
            end += step;
        }
    }
    end
}

/// Whether the motion from the first to the last pose passes through the others, so that the platform need not stop
/// there.
fn is_one_turn(poses: &[Pose]) -> bool {
    let [first, between @ .., last] = poses else { return true };
    let motion = first.toward(last);
    let mut reached = 0.0;
    between.iter().all(|pose| {
        let angle = first.angle_to(pose);
        let there = motion.at(angle / motion.angle);
        let advances = angle >= reached && angle <= motion.angle;
        reached = angle;
        advances && (there.position - pose.position).norm() <= STRAIGHT_ON && there.angle_to(pose) <= SAME_TURN
    })
}

/// Lines and bends at the orientation of the first of these poses; nothing if they do not move. Turns are `joined` to the start and
/// the end.
fn held(compiled: &CompiledScene, poses: &[Pose], blend: f64, joined: [bool; 2], watch: &Watch) -> Result<Part, Error> {
    let points = positions(poses);
    if !points.iter().any(|point| (point - points[0]).norm() > SAME_POINT) {
        return Ok(Part::default());
    }
    let orientation = &poses[0].orientation;
    if let [from, to] = points[..] {
        return Ok(Part { pieces: vec![Piece::line(from, to).held_at(*orientation)], corners: Vec::new() });
    }
    let turned;
    let (scene, engine) = match compiled.scene().has_orientation(orientation) {
        true => (compiled.scene(), compiled.level()),
        false => {
            let scene = compiled.scene().turned(wxyz(orientation).into())?;
            turned = CompiledScene::new(&scene, Engine::Cspace, Interference::Exact, watch)?;
            (turned.scene(), turned.level())
        }
    };
    let part = rounded(&points, blend, joined, &FreeSpace::new(scene, engine, watch)?, watch)?;
    Ok(Part { pieces: part.pieces.into_iter().map(|piece| piece.held_at(*orientation)).collect(), ..part })
}

/// The motion between two poses. Its parameter is its length, with turns weighted as in planning but kept within the range in
/// which timing is accurate, since a turn or its weight may be tiny.
fn turn(scene: &Scene, from: &Pose, to: &Pose) -> Part {
    let attitude = Attitude::between(from.orientation, to.orientation);
    let ends = [from.position, to.position];
    let length = (to.position - from.position).norm() + turn_weight(scene).min(LARGEST_TURN_WEIGHT) * attitude.angle();
    let length = length.max(LEAST_TURN_LENGTH);
    Part { pieces: vec![Piece::turning_line(ends, attitude, length)], corners: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Rotation, Vector};

    #[test]
    fn stages_meet_where_turns_begin_and_end() {
        let pose = |x: f64, yaw: f64| Pose::new(Point::new(x, 0.0, 0.0), Rotation::from_scaled_axis(Vector::z() * yaw));
        let poses = [pose(0.0, 0.0), pose(1.0, 0.0), pose(1.0, 0.5), pose(2.0, 0.7), pose(3.0, 0.7)];
        let found = stages(&poses, |_, _| true);
        let expected = [Stage::Held(0..2), Stage::Turn(1, 2), Stage::Held(2..3), Stage::Turn(2, 3), Stage::Held(3..5)];
        assert_eq!(found, expected);
        assert_eq!(stages(&poses[..2], |_, _| true), [Stage::Held(0..2)]);
        // A turn in even steps is one; back and forth, it is two.
        let steps: Vec<Pose> = (0..=10).map(|k| pose(0.1 * f64::from(k), 0.05 * f64::from(k))).collect();
        assert_eq!(stages(&steps, |_, _| true), [Stage::Held(0..1), Stage::Turn(0, 10), Stage::Held(10..11)]);
        assert_eq!(stages(&steps, |_, _| false).len(), 21);
        let many: Vec<Pose> = (0..=5000).map(|k| pose(1e-4 * f64::from(k), 1e-4 * f64::from(k))).collect();
        for end in [2, 3, 4, 5, 1000, 5000] {
            assert_eq!(end_of_turn(&many[..=end], 0), end);
            let bent = [&many[..=end], &[pose(0.0, 1.0)]].concat();
            assert_eq!(end_of_turn(&bent, 0), end);
        }
        let back: Vec<Pose> = [0, 3, 7, 4].map(|k| steps[k]).to_vec();
        let expected = [Stage::Held(0..1), Stage::Turn(0, 2), Stage::Held(2..3), Stage::Turn(2, 3), Stage::Held(3..4)];
        assert_eq!(stages(&back, |_, _| true), expected);
    }
}
