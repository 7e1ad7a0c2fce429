//! Whether a motion with a turn keeps all conditions: proved, or refused.
//!
//! A condition is bounded on a piece of the motion. Where the bound does not prove it, the pose halfway is measured: below
//! [`TOO_CLOSE_TO_TURN`] the motion is refused, otherwise the piece is halved. Deviations from chords fall with the square of
//! the angle, so most motions need one or two pieces for each condition.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::allowed::AllowedTurns;
use super::nearest::{is_level, path_clearance};
use super::pose_space::{pose_distance, turn_weight};
use super::turning_wrench::TurningWrench;
use crate::collision::along::{Least, least_between};
use crate::collision::path_check::PathEngine;
use crate::collision::{Checker, Clearance, Conditions, Interference, Validity, Violation};
use crate::conditions::Bodies;
use crate::error::Error;
use crate::geometry::{Apart, Placed, Pose, PoseMotion, Rotation, Turning, TurningPiece};
use crate::limits::{PIECES_NEAR, TURNING_PIECES};
use crate::model::Scene;
use crate::tolerances::{TOO_CLOSE_TO_TURN, TOUCH_DEPTH, TURNING_PLACE};
use crate::watch::Watch;

/// An engine for motions from pose to pose.
///
/// Cables must not meet at any instant (the rule `exact`). Distances that a pair cannot keep at the orientation of the scene
/// are not required of it at others.
///
/// # Example
/// ```
/// use cdpr_core::Validity;
/// use cdpr_core::{Point, Pose, Rotation, Vector};
/// use cdpr_core::compiled::engine_for;
/// use cdpr_core::turning::TurningEngine;
/// let scene = cdpr_core::testing::hard1();
/// let engine = TurningEngine::new(&scene, engine_for(&scene, Default::default(), Default::default())?)?;
/// let yaw = |angle: f64| Rotation::from_scaled_axis(Vector::z() * angle);
/// let place = Point::new(0.3, 1.0, 0.3);
/// let [from, to] = [0.0, 0.2].map(|angle| Pose::new(place, yaw(angle)));
/// assert!(engine.motion_valid(&from, &to));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub struct TurningEngine {
    /// Checks motions without a turn at the orientation of the scene.
    level: Arc<dyn Checker>,
    reference: Rotation,
    wrench: Option<TurningWrench>,
    allowed: Vec<AllowedTurns>,
    /// Length of a turn by one radian, m.
    weight: f64,
    /// The condition that refused the last motion: often it refuses the next one, too.
    hint: AtomicUsize,
}

/// Verdict on a condition during a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Verdict {
    Kept,
    /// At this fraction, with this slack, m: broken, or too close to tell.
    Refused {
        at: f64,
        slack: f64,
    },
}

impl TurningEngine {
    /// The engine for a scene; `level` checks motions without a turn.
    ///
    /// # Errors
    /// The interference rule `swept`, and the errors of [`TurningWrench::of`].
    pub fn new(scene: &Scene, level: Arc<dyn Checker>) -> Result<Self, Error> {
        if level.interference() == Interference::Swept {
            let problem =
                "found \"swept\", which is for motions without a turn; expected \"exact\" if the platform turns";
            return Err(Error::invalid("interference", problem));
        }
        Ok(TurningEngine {
            level,
            reference: *scene.orientation(),
            wrench: TurningWrench::of(scene)?,
            allowed: AllowedTurns::of(scene),
            weight: turn_weight(scene),
            hint: AtomicUsize::new(0),
        })
    }

    /// The conditions, at the orientation of the scene.
    pub fn conditions(&self) -> &Conditions {
        self.level.conditions()
    }

    /// The engine for motions without a turn at the orientation of the scene.
    pub fn level(&self) -> &dyn Checker {
        &*self.level
    }

    /// The orientation of the scene.
    pub fn reference(&self) -> &Rotation {
        &self.reference
    }

    /// Whether a pose has the orientation of the scene.
    fn is_level(&self, pose: &Pose) -> bool {
        is_level(pose, &self.reference)
    }

    fn kept(&self, index: usize, motion: &Turning, whole: &TurningPiece) -> bool {
        let Conditions { list, bodies, .. } = self.conditions();
        let condition = list[index].details();
        condition.kept_during_turn(bodies, whole)
            || verdict(motion, *whole, &Measured { condition, bodies }, 1.0) == Verdict::Kept
    }

    /// Whether the table `[turning]` of the scene allows a motion.
    pub(crate) fn allows(&self, motion: &Turning) -> bool {
        self.allowed.iter().all(|allowed| allowed.keeps(motion))
    }

    /// Whether wrenches are required.
    pub(crate) fn requires_wrench(&self) -> bool {
        self.wrench.is_some()
    }

    /// Of some conditions, those that are not proved to hold at all poses that differ from those of a motion by at most `apart`, m, in
    /// position.
    pub(crate) fn unproved_near(&self, motion: &PoseMotion, apart: f64, conditions: &[u32]) -> Vec<u32> {
        let Conditions { list, bodies, .. } = self.conditions();
        let motion = motion.relative_to(&self.reference);
        let apart = Apart { position: apart, turned: 0.0 };
        let kept = |index: &u32| {
            let condition = list[*index as usize].details();
            let mut left = vec![motion.whole()];
            for _ in 0..PIECES_NEAR {
                let Some(piece) = left.pop() else { return true };
                if condition.kept_during_turn(bodies, &piece.within(apart)) {
                    continue;
                }
                if !(condition.slack_at(bodies, &piece.middle) >= TOO_CLOSE_TO_TURN) {
                    return false;
                }
                left.extend(motion.halves(&piece));
            }
            left.is_empty()
        };
        conditions.iter().filter(|index| !kept(index)).copied().collect()
    }

    /// Whether the required wrenches are proved to be available at all poses that differ from those of a motion by at most `apart`, m, in
    /// position.
    pub(crate) fn keeps_wrench_near(&self, motion: &PoseMotion, apart: f64) -> bool {
        self.wrench.as_ref().is_none_or(|wrench| wrench.keeps_near(motion, apart, PIECES_NEAR))
    }

    fn keeps_conditions(&self, motion: &Turning) -> bool {
        let (count, whole) = (self.conditions().list.len(), motion.whole());
        let hint = self.hint.load(Ordering::Relaxed).min(count - 1);
        if !self.kept(hint, motion, &whole) {
            return false;
        }
        match (0..count).find(|&index| index != hint && !self.kept(index, motion, &whole)) {
            Some(refused) => {
                self.hint.store(refused, Ordering::Relaxed);
                false
            }
            None => true,
        }
    }

    /// The verdicts on all conditions that are not proved to be kept.
    fn refused(&self, motion: &Turning) -> Vec<(usize, Verdict)> {
        let Conditions { list, bodies, .. } = self.conditions();
        let found = list.iter().enumerate().map(|(index, condition)| {
            let measured = Measured { condition: condition.details(), bodies };
            (index, verdict(motion, motion.whole(), &measured, TURNING_PLACE))
        });
        found.filter(|(_, verdict)| *verdict != Verdict::Kept).collect()
    }
}

/// A condition that can be bounded on pieces and measured at poses.
pub(super) trait Bounded {
    /// Whether a bound proves that the condition holds on a piece.
    fn kept(&self, piece: &TurningPiece) -> bool;
    /// How far the condition is from being broken at a pose.
    fn slack(&self, at: &Placed) -> f64;
}

struct Measured<'a> {
    condition: &'a dyn crate::conditions::PhysicalCondition,
    bodies: &'a Bodies,
}

impl Bounded for Measured<'_> {
    fn kept(&self, piece: &TurningPiece) -> bool {
        self.condition.kept_during_turn(self.bodies, piece)
    }

    fn slack(&self, at: &Placed) -> f64 {
        self.condition.slack_at(self.bodies, at)
    }
}

/// Divides a motion until a condition is proved, or refused where it is too close. A refused piece is then searched for its first
/// part, no longer than the share `place` of the motion, that is refused as well.
fn verdict(motion: &Turning, whole: TurningPiece, condition: &impl Bounded, place: f64) -> Verdict {
    let mut left = vec![whole];
    let mut close = Verdict::Kept;
    for _ in 0..TURNING_PIECES {
        let Some(piece) = left.pop() else { return close };
        if condition.kept(&piece) {
            continue;
        }
        let slack = condition.slack(&piece.middle);
        let [from, to] = piece.during;
        if !(slack >= TOO_CLOSE_TO_TURN) {
            if to - from <= place {
                return Verdict::Refused { at: from, slack };
            }
            if close == Verdict::Kept {
                close = Verdict::Refused { at: 0.5 * (from + to), slack };
            }
        }
        let [first, second] = motion.halves(&piece);
        left.extend([second, first]);
    }
    Verdict::Refused { at: left.last().map_or(1.0, |piece| piece.during[0]), slack: TOO_CLOSE_TO_TURN }
}

impl Validity<Pose> for TurningEngine {
    fn state_valid(&self, pose: &Pose) -> bool {
        self.motion_valid(pose, pose)
    }

    fn motion_valid(&self, from: &Pose, to: &Pose) -> bool {
        if !(from.is_finite() && to.is_finite()) {
            return false;
        }
        let [from, to] = either_way(from, to);
        if self.is_level(from) && self.is_level(to) {
            return self.level.motion_valid(&from.position, &to.position);
        }
        let motion = from.toward(to).relative_to(&self.reference);
        self.allowed.iter().all(|allowed| allowed.keeps(&motion))
            && self.keeps_conditions(&motion)
            && self.wrench.as_ref().is_none_or(|wrench| wrench.keeps(from, to))
    }

    fn may_be_slow(&self) -> bool {
        self.wrench.is_some()
    }

    fn violations(&self, from: &Pose, to: &Pose) -> Vec<Violation> {
        if self.is_level(from) && self.is_level(to) {
            return self.level.violations(&from.position, &to.position);
        }
        let motion = from.toward(to).relative_to(&self.reference);
        let mut found: Vec<Violation> =
            self.refused(&motion).into_iter().map(|(index, verdict)| self.violation(index, &motion, verdict)).collect();
        found.extend(self.allowed.iter().filter_map(|allowed| allowed.violation(&motion)));
        found.extend(self.wrench.as_ref().and_then(|wrench| wrench.violation(from, to)));
        found.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.kind.cmp(&b.kind)));
        found
    }

    fn clearance(&self, from: &Pose, to: &Pose) -> Option<Clearance> {
        let all: Vec<usize> = (0..self.conditions().list.len()).collect();
        let found = self.closest(&all, &[*from, *to], &Watch::NONE);
        found.expect("nothing interrupts it").map(|(_, clearance)| clearance)
    }
}

impl PathEngine<Pose> for TurningEngine {
    fn checked_conditions(&self) -> &Conditions {
        self.conditions()
    }

    fn length(&self, path: &[Pose]) -> f64 {
        path.windows(2).map(|pair| pose_distance(self.weight, &pair[0], &pair[1])).sum()
    }

    fn closest(&self, indices: &[usize], path: &[Pose], watch: &Watch) -> Result<Option<(usize, Clearance)>, Error> {
        path_clearance((self.conditions(), &self.reference), indices, path, watch)
    }
}

/// The ends of a motion in an order that does not depend on its direction, as for
/// [motions without a turn](crate::collision::along::either_way).
fn either_way<'a>(from: &'a Pose, to: &'a Pose) -> [&'a Pose; 2] {
    let numbers = |pose: &'a Pose| pose.position.iter().chain(pose.orientation.coords.iter());
    if numbers(to).lt(numbers(from)) { [to, from] } else { [from, to] }
}

impl TurningEngine {
    fn violation(&self, index: usize, motion: &Turning, verdict: Verdict) -> Violation {
        let Verdict::Refused { at, slack } = verdict else { unreachable!("only refusals are reported") };
        let conditions = self.conditions();
        let condition = &conditions.list[index];
        let details = condition.details();
        let required = details.required(&conditions.bodies);
        let worst = least_during(motion, |at| details.slack_at(&conditions.bodies, at)).value.min(slack);
        let members = (details.kind(), conditions.culprits(condition));
        let found = Violation::of_distance(at, members, worst + required, required);
        let shapes = details.shapes(&conditions.bodies, &[motion.at(0.0), motion.at(1.0)]);
        Violation { margin: Some(worst.min(0.0)), unproved: worst >= -TOUCH_DEPTH, shapes, ..found }
    }
}

/// The least value during a motion, from samples.
fn least_during(motion: &Turning, value: impl Fn(&Placed) -> f64) -> Least {
    const SAMPLES: usize = 32;
    match motion.is_still() {
        true => Least { at: 0.0, value: value(&motion.at(0.0)) },
        false => least_between(0.0, 1.0, SAMPLES, |t| value(&motion.at(t))),
    }
}
