//! Proofs that the cables can exert the required wrenches during a motion with a turn.
//!
//! As for translations ([`sagging`]): between two poses, each column of the wrench matrix deviates from its chord by a term of
//! second order, and the slack is below its chord by no more than these deviations, times the tensions, and the changes of the
//! columns, times the ranges of tensions. Here the arms turn as well, and with them the moment of the weight.

use crate::collision::{Kind, Violation};
use crate::error::Error;
use crate::geometry::{Pose, PoseMotion};
use crate::model::{Cable, MarginSpec, Robot, RuleSpec, Scene};
use crate::numerics::{TURNING_PLACE, WRENCH_PIECES};
use crate::wrench::{BEND, Loads, Measure, Required, Statics, limit_at, measures_by, required, sagging};

/// Wrench feasibility as a scene requires it, at any orientation.
#[derive(Debug, Clone)]
pub struct TurningWrench {
    robot: Robot,
    loads: Loads,
    required: Required,
    margin: MarginSpec,
}

/// A pose of a motion and what is known there.
struct Known {
    at: f64,
    pose: Pose,
    measures: Vec<Measure>,
    slack: Vec<f64>,
}

impl TurningWrench {
    /// The requirement of a scene; `None` if it has none.
    ///
    /// # Errors
    /// As [`crate::wrench::measures`]; the rule of a grid, which is for one orientation.
    pub fn of(scene: &Scene) -> Result<Option<Self>, Error> {
        let Some(spec) = scene.wrench() else { return Ok(None) };
        if spec.rule == Some(RuleSpec::Grid) {
            let problem =
                "found the rule \"grid\", which is for one orientation; expected \"certified\" if the platform turns";
            return Err(Error::invalid("wrench.rule", problem));
        }
        crate::wrench::measures(scene)?;
        let margin = spec.margin.unwrap_or(MarginSpec::Capacity);
        Ok(Some(TurningWrench {
            robot: scene.robot().clone(),
            loads: Loads::of(scene),
            required: required(spec)?,
            margin,
        }))
    }

    /// The measures at an orientation.
    fn measures(&self, pose: &Pose) -> Vec<Measure> {
        let loads = Loads { orientation: pose.orientation, ..self.loads.clone() };
        let statics = Statics::new(&self.robot, &loads).expect("checked at the orientation of the scene");
        measures_by(&statics, &self.required, self.margin).unwrap_or_default()
    }

    /// How much more than required the cables can exert at a pose, N: the least of its measures; NaN where a cable has no
    /// direction.
    pub fn slack(&self, pose: &Pose) -> f64 {
        let slack = self.measures(pose).iter().map(|measure| measure.slack(&pose.position)).collect::<Vec<_>>();
        slack
            .into_iter()
            .fold(f64::INFINITY, |least, slack| if slack < least || slack.is_nan() { slack } else { least })
    }

    fn known(&self, motion: &PoseMotion, at: f64) -> Known {
        let pose = motion.at(at);
        let measures = self.measures(&pose);
        let slack = measures.iter().map(|measure| measure.slack(&pose.position) - measure.floor()).collect();
        Known { at, pose, measures, slack }
    }

    /// Whether a motion is proved to satisfy the requirement.
    pub fn keeps(&self, from: &Pose, to: &Pose) -> bool {
        self.first_refused(&from.toward(to), 1.0).is_none()
    }

    /// The fraction of a motion at which the requirement is not proved, to the accuracy `place`.
    fn first_refused(&self, motion: &PoseMotion, place: f64) -> Option<f64> {
        let first = self.known(motion, 0.0);
        if !first.holds() {
            return Some(0.0);
        }
        if motion.from == motion.to {
            return None;
        }
        let (mut from, mut ahead) = (first, vec![self.known(motion, 1.0)]);
        for _ in 0..WRENCH_PIECES {
            let to = ahead.last()?;
            if to.holds() && self.proved(motion, &from, to) {
                from = ahead.pop().expect("just seen");
                continue;
            }
            if !to.holds() && to.at - from.at <= place {
                return Some(from.at);
            }
            ahead.push(self.known(motion, 0.5 * (from.at + to.at)));
        }
        Some(from.at)
    }

    /// Whether the slack at both ends of a piece proves that it suffices between them.
    fn proved(&self, motion: &PoseMotion, from: &Known, to: &Known) -> bool {
        let share = to.at - from.at;
        let (step, angle) = ((motion.to.position - motion.from.position).norm() * share, motion.angle * share);
        (from.measures.iter().enumerate()).all(|(k, measure)| {
            let sag = self.sag(measure, [&from.pose, &to.pose], step, angle);
            sagging(from.slack[k], to.slack[k], sag) >= 0.0
        })
    }

    /// How far the slack can drop below its chord in the middle of a piece with this translation, m, and turn, rad.
    fn sag(&self, measure: &Measure, ends: [&Pose; 2], step: f64, angle: f64) -> f64 {
        let length = self.loads.characteristic_length;
        let parts = |force: f64, moment: f64| match measure {
            Measure::Capacity(_) => force.hypot(moment / length),
            Measure::Force(..) => force,
            Measure::Moment(..) => moment,
        };
        let sag = |cable: &Cable| {
            let arm = cable.attachment.coords.norm();
            let speed = step + angle * arm;
            let line =
                |pose: &&Pose| (pose.position + pose.orientation * cable.attachment.coords - cable.outlet).norm();
            let shortest = ends.iter().map(line).fold(f64::INFINITY, f64::min) - 0.5 * speed;
            if !(shortest > 0.0) {
                return f64::INFINITY;
            }
            // First and second derivative of the direction of the cable, and of its moment.
            let turn = (speed / shortest).min(2.0);
            let bend = BEND * (speed / shortest).powi(2) + angle * angle * arm / shortest;
            let moment = [angle * arm + arm * turn, angle * angle * arm + 2.0 * angle * arm * turn + arm * bend];
            let [least, largest] = cable.tension.unwrap_or_default();
            0.25 * (largest - least) * parts(turn, moment[0]) + 0.125 * largest * parts(bend, moment[1])
        };
        let weight =
            self.loads.gravity.norm() * self.robot.mass().unwrap_or(0.0) * self.robot.center_of_mass().coords.norm();
        let cables: f64 = self.robot.cables().iter().map(sag).sum();
        cables + 0.125 * angle * angle * parts(0.0, weight)
    }

    /// The violation of a motion, if it is not proved to satisfy the requirement; marked as unproved if no failure is known.
    pub fn violation(&self, from: &Pose, to: &Pose) -> Option<Violation> {
        let motion = from.toward(to);
        let at = self.first_refused(&motion, TURNING_PLACE)?;
        const SAMPLES: usize = 64;
        let limits = (0..=SAMPLES).flat_map(|k| {
            let pose = motion.at(at + (1.0 - at) * k as f64 / SAMPLES as f64);
            self.measures(&pose).iter().map(|measure| limit_at(measure, &pose.position)).collect::<Vec<_>>()
        });
        let limit = limits.min_by(|a, b| a.order().total_cmp(&b.order()))?;
        let culprits = limit.at_greatest.iter().chain(&limit.at_least).cloned().collect();
        let unproved = limit.wrench_margin.is_some_and(|margin| margin >= 0.0) && !limit.leaves_motions_free();
        let wrench = Some(limit);
        Some(Violation { at, kind: Kind::Wrench, culprits, gap: None, required: None, margin: None, unproved, wrench })
    }
}

impl Known {
    fn holds(&self) -> bool {
        self.slack.iter().all(|slack| *slack >= 0.0)
    }
}
