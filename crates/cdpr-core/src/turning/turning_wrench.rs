//! Proofs that the cables can exert the required wrenches during a motion with a turn.
//!
//! As for translations ([`sagging`]): between two poses, each column of the wrench matrix deviates from its chord by a term of
//! second order, and the slack is below its chord by no more than these deviations, times the tensions, and the changes of the
//! columns, times the ranges of tensions. Here the arms turn as well, and with them the moment of the weight.

use crate::collision::Violation;
use crate::error::Error;
use crate::geometry::{Placed, Pose, PoseMotion, Vector};
use crate::model::{Cable, MarginSpec, Robot, RuleSpec, Scene};
use crate::numerics::simd::WIDTH;
use crate::numerics::{TURNING_PLACE, WRENCH_PIECES};
use crate::wrench::{BEND, Loads, Measure, Required, Statics, limit_at, measures, measures_by, required, sagging};

/// Wrench feasibility as a scene requires it, at any orientation.
#[derive(Debug, Clone)]
pub struct TurningWrench {
    robot: Robot,
    loads: Loads,
    required: Required,
    margin: MarginSpec,
    /// The measures at the orientation of the scene.
    measures: Vec<Measure>,
}

/// A pose of a motion, and for each measure how much more than required the cables can exert there.
#[derive(Debug, Clone)]
struct Known {
    at: f64,
    pose: Pose,
    slack: Slack,
}

/// The slack by each measure; there are at most two.
type Slack = [f64; 2];

/// Why the statics exist at every orientation.
const CHECKED: &str = "checked at the orientation of the scene";

impl TurningWrench {
    /// The requirement of a scene; `None` if it has none.
    ///
    /// # Errors
    /// As [`crate::wrench::measures`]; the rule of a grid, which is for one orientation.
    pub fn of(scene: &Scene) -> Result<Option<Self>, Error> {
        let Some(spec) = scene.wrench() else { return Ok(None) };
        if spec.rule == Some(RuleSpec::Grid) {
            let problem =
                "found \"grid\", which is a rule for one orientation; expected \"certified\" if the platform turns";
            return Err(Error::invalid("wrench.rule", problem));
        }
        Ok(Some(TurningWrench {
            robot: scene.robot().clone(),
            loads: Loads::of(scene),
            required: required(spec)?,
            margin: spec.margin.unwrap_or(MarginSpec::Capacity),
            measures: measures(scene)?,
        }))
    }

    /// Whether a motion is proved to satisfy the requirement.
    pub fn keeps(&self, from: &Pose, to: &Pose) -> bool {
        let motion = from.toward(to);
        let still = from == to;
        let shares = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|share| if still { 0.0 } else { share });
        let first = self.known(&motion, &shares);
        if !first.iter().all(|known| self.holds(known)) {
            return false;
        }
        if still {
            return true;
        }
        let mut open: Vec<[Known; 2]> = first.windows(2).map(|ends| [ends[0].clone(), ends[1].clone()]).collect();
        for _ in 0..WRENCH_PIECES {
            open.retain(|piece| !self.proved(&motion, piece));
            if open.is_empty() {
                return true;
            }
            // The middles of up to four pieces at once; the last ones again if there are fewer.
            let taken = open.split_off(open.len().saturating_sub(WIDTH));
            let middle = |k: usize| {
                let [from, to] = &taken[k.min(taken.len() - 1)];
                0.5 * (from.at + to.at)
            };
            let middles = self.known(&motion, &std::array::from_fn(middle));
            for (piece, middle) in taken.into_iter().zip(middles) {
                if !self.holds(&middle) {
                    return false;
                }
                let [from, to] = piece;
                open.extend([[from, middle.clone()], [middle, to]]);
            }
        }
        false
    }

    fn holds(&self, known: &Known) -> bool {
        (self.measures.iter().zip(&known.slack)).all(|(measure, slack)| *slack >= measure.floor())
    }

    /// The poses at four fractions of a motion, and their slack.
    fn known(&self, motion: &PoseMotion, shares: &[f64; WIDTH]) -> [Known; WIDTH] {
        let poses = shares.map(|share| motion.at(share));
        let slack = self.slack_at_four(&poses);
        std::array::from_fn(|lane| Known { at: shares[lane], pose: poses[lane], slack: slack[lane] })
    }

    fn slack_at_four(&self, poses: &[Pose; WIDTH]) -> [Slack; WIDTH] {
        let fast = match &self.measures[..] {
            [Measure::Capacity(margin)] => {
                let placed = poses.map(|pose| Placed::new(&pose, &self.loads.orientation));
                let balance = |pose: &Pose| self.loads.at(&pose.orientation).balance(&self.robot);
                margin.at_four_poses(&placed, &poses.each_ref().map(|pose| balance(pose).expect(CHECKED).into()))
            }
            _ => None,
        };
        std::array::from_fn(|lane| match fast {
            Some(margins) if !margins[lane].is_nan() => [margins[lane], f64::INFINITY],
            _ => self.slack(&poses[lane]),
        })
    }

    /// The slack at a pose by definition; NaN where a cable has no direction.
    fn slack(&self, pose: &Pose) -> Slack {
        let mut slack = [f64::INFINITY; 2];
        for (slack, measure) in slack.iter_mut().zip(self.measures_at(pose)) {
            *slack = measure.limit(&pose.position).map_or(f64::NAN, |limit| limit.margin);
        }
        slack
    }

    /// The measures at the orientation of a pose.
    fn measures_at(&self, pose: &Pose) -> Vec<Measure> {
        let statics = Statics::new(&self.robot, &self.loads.at(&pose.orientation)).expect(CHECKED);
        measures_by(&statics, &self.required, self.margin).expect(CHECKED)
    }

    fn weight(&self) -> Vector {
        self.loads.gravity * self.robot.mass().unwrap_or(0.0)
    }

    /// Whether the slack at both ends of a piece proves that it suffices between them.
    fn proved(&self, motion: &PoseMotion, [from, to]: &[Known; 2]) -> bool {
        let share = to.at - from.at;
        let (step, angle) = ((motion.to.position - motion.from.position).norm() * share, motion.angle * share);
        self.measures.iter().enumerate().all(|(k, measure)| {
            let floor = measure.floor();
            let sag = self.sag(measure, [&from.pose, &to.pose], step, angle);
            sagging(from.slack[k] - floor, to.slack[k] - floor, sag) >= 0.0
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
            let line = |pose: &Pose| (pose.position + pose.orientation * cable.attachment.coords - cable.outlet).norm();
            let shortest = line(ends[0]).min(line(ends[1])) - 0.5 * speed;
            if !(shortest > 0.0) {
                return f64::INFINITY;
            }
            // First and second derivative of the direction of the cable, and of its moment.
            let turn = speed / shortest;
            let bend = BEND * turn * turn + angle * angle * arm / shortest;
            let moment = [angle * arm + arm * turn, angle * angle * arm + 2.0 * angle * arm * turn + arm * bend];
            let [least, largest] = cable.tension.unwrap_or_default();
            0.25 * (largest - least) * parts(turn, moment[0]) + 0.125 * largest * parts(bend, moment[1])
        };
        let cables: f64 = self.robot.cables().iter().map(sag).sum();
        let weight = self.weight().norm() * self.robot.center_of_mass().coords.norm();
        cables + 0.125 * angle * angle * parts(0.0, weight)
    }

    /// The violation of a motion, if it is not proved to satisfy the requirement; marked as unproved if no failure is known.
    pub fn violation(&self, from: &Pose, to: &Pose) -> Option<Violation> {
        if self.keeps(from, to) {
            return None;
        }
        let motion = from.toward(to);
        let places = (1.0 / TURNING_PLACE) as usize;
        let failed = |k: &usize| {
            let at = *k as f64 * TURNING_PLACE;
            let pose = motion.at(at);
            !self.holds(&Known { at, pose, slack: self.slack(&pose) })
        };
        let at = (0..=places).find(failed).map_or(0.0, |k| k as f64 * TURNING_PLACE);
        const SAMPLES: usize = 64;
        let limits = (0..=SAMPLES).flat_map(|k| {
            let pose = motion.at(at + (1.0 - at) * k as f64 / SAMPLES as f64);
            self.measures_at(&pose).iter().map(|measure| limit_at(measure, &pose.position)).collect::<Vec<_>>()
        });
        let limit = limits.min_by(|a, b| a.order().total_cmp(&b.order()))?;
        Some(Violation::of_wrench(at, limit))
    }
}
