//! Proofs that the cables can exert the required wrenches during a motion with a turn.
//!
//! As for translations ([`sagging`]): between two poses, each column of the wrench matrix deviates from its chord by a term of
//! second order, and the slack drops below its chord by at most these deviations times the tensions, plus the changes of the
//! columns times the ranges of tensions. Here the arms turn as well, and with them the moment of the weight. Only bounds of the
//! derivatives of the motion are used ([`PoseCurve`]), so its rates need not be constant.

use nalgebra::Vector6;

use super::pose_curve::{Derivatives, PoseCurve};
use crate::collision::{Violation, WrenchLimit};
use crate::error::Error;
use crate::geometry::{Leeway, Placed, Pose, PoseMotion, Vector};
use crate::limits::{MOST_WRENCH_CABLES, WRENCH_PIECES};
use crate::model::{Cable, MarginSpec, Robot, RuleSpec, Scene};
use crate::simd::WIDTH;
use crate::tolerances::TURNING_PLACE;
use crate::wrench::constraint::few_cables;
use crate::wrench::{BEND, Loads, Measure, Required, Statics, largest_sum, limit_at, measures_by, required, sagging};

/// Wrench feasibility as a scene requires it, at any orientation and for each of its load cases.
#[derive(Debug, Clone)]
pub struct TurningWrench {
    cases: Vec<Case>,
}

/// Wrench feasibility for one load case.
#[derive(Debug, Clone)]
struct Case {
    robot: Robot,
    loads: Loads,
    required: Required,
    margin: MarginSpec,
    /// The measures at the orientation of the scene.
    measures: Vec<Measure>,
    /// The largest moment of the weight about the platform's origin, N·m.
    weight_moment: f64,
}

/// A cable at a pose, and its column of the wrench matrix.
struct Column {
    /// From the attachment to the outlet, m.
    line: Vector,
    /// Distance of the two, m.
    length: f64,
    unit: Vector,
    /// Moment of a unit force along the cable about the platform's origin, m.
    moment: Vector,
}

impl Column {
    #[inline]
    fn of(cable: &Cable, pose: &Pose) -> Self {
        let arm = pose.orientation * cable.attachment.coords;
        let line = cable.outlet - (pose.position + arm);
        let length = line.norm();
        let unit = match &cable.pulley {
            None => line / length,
            Some(_) => cable.departure(&(cable.outlet - line)).map_or(Vector::repeat(f64::NAN), |found| found.pull),
        };
        Column { line, length, unit, moment: arm.cross(&unit) }
    }
}

/// Bounds of the second derivatives of the direction of a cable, and of its moment, m, on a piece with these ends; `None` if the
/// cable may lose its direction there.
fn second_derivatives(cable: &Cable, [first, last]: &[Column; 2], bounds: &Derivatives) -> Option<[f64; 2]> {
    let Derivatives { position, turned: [swing, jolt] } = bounds;
    let arm = cable.attachment.coords.norm();
    // The speed of the attachment differs from the mean by at most half of its acceleration.
    let acceleration = position + jolt * arm;
    let speed = (last.line - first.line).norm() + 0.5 * acceleration;
    let shortest = first.length.min(last.length) - 0.5 * speed;
    if !(shortest > 0.0) {
        return None;
    }
    let turn = speed / shortest;
    let bend = BEND * turn * turn + acceleration / shortest;
    Some([bend, jolt * arm + 2.0 * swing * arm * turn + arm * bend])
}

/// How direction and moment, m, of a cable may behave on a piece, for all outlets within their error.
struct OffNominal {
    /// Bounds of the second derivatives.
    seconds: [f64; 2],
    /// Bounds of how much more they change than at the given outlet.
    changes: [f64; 2],
}

/// [`second_derivatives`] of a cable that runs round a pulley, or whose outlet may differ from the given one.
fn off_nominal(cable: &Cable, [first, last]: &[Column; 2], bounds: &Derivatives) -> Option<OffNominal> {
    let Derivatives { position, turned: [swing, jolt] } = bounds;
    let (arm, error) = (cable.attachment.coords.norm(), cable.outlet_error);
    let acceleration = position + jolt * arm;
    let speed = (last.line - first.line).norm() + 0.5 * acceleration;
    let leeway = |column: &Column| Leeway::of(cable.pulley.as_ref(), &cable.outlet, &(cable.outlet - column.line));
    let rates = leeway(first).between(leeway(last), speed).within(error).turning()?;
    let turn = speed * rates.first;
    let bend = rates.second * speed * speed + acceleration * rates.first;
    // The direction seen from another outlet differs by `error · rates.first`, and turns by `error · rates.second` per distance more.
    let more = error * rates.second * speed;
    Some(OffNominal {
        seconds: [bend, jolt * arm + 2.0 * swing * arm * turn + arm * bend],
        changes: [more, arm * more + swing * arm * error * rates.first],
    })
}

/// A pose of a motion, and the slack there by each measure.
#[derive(Debug, Clone)]
struct Known {
    at: f64,
    pose: Pose,
    slack: Slack,
}

/// The slack by each measure; there are at most two.
type Slack = [f64; 2];

/// Whether slack at a pose is at least `floors`, by each measure.
fn holds(known: &Known, floors: &Slack) -> bool {
    floors.iter().zip(&known.slack).all(|(floor, slack)| slack >= floor)
}

/// Message of an `expect`: why the statics exist at every orientation.
const CHECKED: &str = "checked at the orientation of the scene";

impl TurningWrench {
    /// The wrench requirement of a scene; `None` if it has none.
    ///
    /// # Errors
    /// The errors of [`crate::wrench::measures`]; the rule of a grid, which is for one orientation.
    pub fn of(scene: &Scene) -> Result<Option<Self>, Error> {
        let Some(spec) = scene.wrench() else { return Ok(None) };
        if spec.rule == Some(RuleSpec::Grid) {
            let problem =
                "found \"grid\", which is a rule for one orientation; expected \"certified\" if the platform turns";
            return Err(Error::invalid("wrench.rule", problem));
        }
        let (robot, required) = (scene.robot(), required(spec)?);
        let margin = spec.margin.unwrap_or(MarginSpec::Capacity);
        let case = |loads: Loads| {
            let weight = loads.gravity.norm() * loads.mass(robot).unwrap_or(0.0);
            Ok(Case {
                weight_moment: weight * robot.center_of_mass().coords.norm(),
                measures: measures_by(&Statics::new(robot, &loads)?, &required, margin)?,
                robot: robot.clone(),
                loads,
                required: required.clone(),
                margin,
            })
        };
        few_cables(robot)?;
        Ok(Some(TurningWrench { cases: Loads::cases(scene).into_iter().map(case).collect::<Result<_, Error>>()? }))
    }

    /// Whether all cables meet in one point of the platform, which they cannot turn.
    pub fn of_point_mass(&self) -> bool {
        self.cases.iter().flat_map(|case| &case.measures).any(|measure| measure.statics().point_mass())
    }

    /// Whether a motion is proved to satisfy the requirement.
    pub fn keeps(&self, from: &Pose, to: &Pose) -> bool {
        self.cases.iter().all(|case| case.keeps(from, to))
    }

    /// Whether a curve of poses, divided into at most about four times `pieces` pieces, is proved to satisfy the requirement.
    pub fn keeps_along(&self, motion: &impl PoseCurve, pieces: usize) -> bool {
        self.cases.iter().all(|case| case.keeps_along(motion, pieces))
    }

    /// Whether the requirement is proved at all poses that differ from those of a motion by at most `apart`, m, in position; the motion is
    /// divided into at most about four times `pieces` pieces.
    pub fn keeps_near(&self, motion: &PoseMotion, apart: f64, pieces: usize) -> bool {
        self.cases.iter().all(|case| case.keeps_near(motion, apart, pieces))
    }

    /// The facet that limits the wrenches at a pose most.
    pub fn least_at(&self, pose: &Pose) -> Option<WrenchLimit> {
        let limits = self.cases.iter().flat_map(|case| case.limits_at(pose));
        limits.min_by(|a, b| a.order().total_cmp(&b.order()))
    }

    /// The violation of a motion, if it is not proved to satisfy the requirement; marked as unproved if no failure is known. With
    /// several load cases it is that of the case that fails first.
    pub fn violation(&self, from: &Pose, to: &Pose) -> Option<Violation> {
        let found = self.cases.iter().filter_map(|case| case.violation(from, to));
        found.min_by(|a, b| a.unproved.cmp(&b.unproved).then(a.at.total_cmp(&b.at)))
    }
}

impl Case {
    fn keeps(&self, from: &Pose, to: &Pose) -> bool {
        if from == to {
            let [known, ..] = self.known(&from.toward(to), &[0.0; WIDTH]);
            return holds(&known, &self.floors());
        }
        self.keeps_along(&from.toward(to), WRENCH_PIECES)
    }

    fn keeps_along(&self, motion: &impl PoseCurve, pieces: usize) -> bool {
        self.keeps_above(motion, pieces, &self.floors())
    }

    /// The smallest slack that counts, by each measure.
    fn floors(&self) -> Slack {
        self.by_measure(Measure::floor)
    }

    fn by_measure(&self, floor: impl Fn(&Measure) -> f64) -> Slack {
        let mut floors = [f64::NEG_INFINITY; 2];
        floors.iter_mut().zip(&self.measures).for_each(|(own, measure)| *own = floor(measure));
        floors
    }

    /// Whether slack is proved to be at least `floors` on a curve.
    fn keeps_above(&self, motion: &impl PoseCurve, pieces: usize, floors: &Slack) -> bool {
        let first = self.known(motion, &[0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0]);
        if !first.iter().all(|known| holds(known, floors)) {
            return false;
        }
        let mut open: Vec<[Known; 2]> = first.windows(2).map(|ends| [ends[0].clone(), ends[1].clone()]).collect();
        for _ in 0..pieces {
            open.retain(|piece| !self.proved(motion, piece, floors));
            if open.is_empty() {
                return true;
            }
            // The middles of up to four pieces at once; the last ones again if there are fewer.
            let taken = open.split_off(open.len().saturating_sub(WIDTH));
            let middle = |k: usize| {
                let [from, to] = &taken[k.min(taken.len() - 1)];
                0.5 * (from.at + to.at)
            };
            let middles = self.known(motion, &std::array::from_fn(middle));
            for (piece, middle) in taken.into_iter().zip(middles) {
                if !holds(&middle, floors) {
                    return false;
                }
                let [from, to] = piece;
                open.extend([[from, middle.clone()], [middle, to]]);
            }
        }
        false
    }

    /// The slack at another position of the platform is less by at most the distance times its steepness, for whose bound every attachment
    /// may be where any turn takes it.
    fn keeps_near(&self, motion: &PoseMotion, apart: f64, pieces: usize) -> bool {
        let arm = self.robot.cables().iter().map(|cable| cable.attachment.coords.norm()).fold(0.0, f64::max);
        let travel = (motion.to.position - motion.from.position).norm();
        let reach = apart + travel + 2.0 * arm;
        let drop = |measure: &Measure| measure.steepness(&motion.from.position, reach) * apart;
        self.keeps_above(motion, pieces, &self.by_measure(|measure| measure.floor() + drop(measure)))
    }

    /// The poses at four fractions of a motion, and their slack.
    fn known(&self, motion: &impl PoseCurve, shares: &[f64; WIDTH]) -> [Known; WIDTH] {
        let poses = shares.map(|share| motion.pose_at(share));
        let slack = self.slack_at_four(&poses);
        std::array::from_fn(|lane| Known { at: shares[lane], pose: poses[lane], slack: slack[lane] })
    }

    fn slack_at_four(&self, poses: &[Pose; WIDTH]) -> [Slack; WIDTH] {
        let fast = match &self.measures[..] {
            [Measure::Capacity(margin)] => {
                let placed = poses.map(|pose| Placed::new(&pose, &self.loads.orientation));
                let balance = |pose: &Pose| self.loads.at(&pose.orientation).balance(&self.robot);
                margin.at_four_placed(&placed, &poses.each_ref().map(|pose| balance(pose).expect(CHECKED).into()))
            }
            _ => None,
        };
        std::array::from_fn(|lane| match fast {
            Some(margins) if !margins[lane].is_nan() => [margins[lane], f64::INFINITY],
            _ => self.slack(&poses[lane]),
        })
    }

    /// The slack at a pose by definition; NaN where a cable has no direction or there is no measure.
    fn slack(&self, pose: &Pose) -> Slack {
        let Some(measures) = self.measures_at(pose) else { return [f64::NAN; 2] };
        let mut slack = [f64::INFINITY; 2];
        for (slack, measure) in slack.iter_mut().zip(measures) {
            *slack = measure.limit(&pose.position).map_or(f64::NAN, |limit| limit.margin);
        }
        slack
    }

    /// The measures at the orientation of a pose; `None` where loads turn a platform whose cables meet in one point, which
    /// they cannot balance.
    fn measures_at(&self, pose: &Pose) -> Option<Vec<Measure>> {
        let statics = Statics::new(&self.robot, &self.loads.at(&pose.orientation)).expect(CHECKED);
        measures_by(&statics, &self.required, self.margin).ok()
    }

    /// The facets that limit the wrenches at a pose, one per measure; without a margin where there is no measure.
    fn limits_at(&self, pose: &Pose) -> Vec<WrenchLimit> {
        let limit = |measure: &Measure| limit_at(measure, &pose.position);
        match self.measures_at(pose) {
            Some(measures) => measures.iter().map(limit).collect(),
            None => {
                let unlimited = |known: WrenchLimit| WrenchLimit {
                    wrench_margin: None,
                    hold: None,
                    at_greatest: Vec::new(),
                    at_least: Vec::new(),
                    ..known
                };
                self.measures.iter().map(limit).map(unlimited).collect()
            }
        }
    }

    /// Whether the slack at both ends of a piece proves that it suffices between them.
    fn proved(&self, motion: &impl PoseCurve, [from, to]: &[Known; 2], floors: &Slack) -> bool {
        let bounds = motion.derivatives(to.at - from.at);
        self.measures.iter().zip(floors).enumerate().all(|(k, (measure, floor))| {
            let sag = self.sag(measure, [&from.pose, &to.pose], &bounds);
            sagging(from.slack[k] - floor, to.slack[k] - floor, sag) >= 0.0
        })
    }

    /// How far the slack can drop below its chord in the middle of a piece with these ends and bounds.
    ///
    /// As in [`sagging`], for a unit direction c: Σ ρᵢ |c·Δwᵢ| / 2 with the differences of the columns wᵢ at the ends, plus
    /// what the columns deviate from their chords.
    fn sag(&self, measure: &Measure, ends: [&Pose; 2], bounds: &Derivatives) -> f64 {
        let mut changes = [Vector6::zeros(); MOST_WRENCH_CABLES];
        let mut bent = 0.125 * bounds.turned[1] * self.part(measure, [0.0, self.weight_moment]);
        for (cable, change) in self.robot.cables().iter().zip(&mut changes) {
            let columns = ends.map(|pose| Column::of(cable, pose));
            let [least, largest] = cable.tension.unwrap_or_default();
            let seconds = if cable.pulley.is_some() || cable.outlet_error > 0.0 {
                let Some(OffNominal { seconds, changes }) = off_nominal(cable, &columns, bounds) else {
                    return f64::INFINITY;
                };
                bent += 0.25 * (largest - least) * self.part(measure, changes);
                seconds
            } else {
                let Some(seconds) = second_derivatives(cable, &columns, bounds) else { return f64::INFINITY };
                seconds
            };
            let [first, last] = columns;
            bent += 0.125 * largest * self.part(measure, seconds);
            *change =
                self.wrench(measure, last.unit - first.unit, last.moment - first.moment) * (0.25 * (largest - least));
        }
        largest_sum(&changes[..self.robot.cables().len()]) + bent
    }

    /// A change of a column [force; moment] as far as a measure depends on it.
    fn wrench(&self, measure: &Measure, force: Vector, moment: Vector) -> Vector6<f64> {
        let moment = moment / self.loads.characteristic_length;
        match measure {
            Measure::Capacity(_) => Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z),
            Measure::Force(..) => Vector6::new(force.x, force.y, force.z, 0.0, 0.0, 0.0),
            Measure::Moment(..) => {
                let moment = moment * self.loads.characteristic_length;
                Vector6::new(0.0, 0.0, 0.0, moment.x, moment.y, moment.z)
            }
        }
    }

    /// The part of bounds of force and moment that a measure depends on.
    fn part(&self, measure: &Measure, [force, moment]: [f64; 2]) -> f64 {
        match measure {
            Measure::Capacity(_) => force.hypot(moment / self.loads.characteristic_length),
            Measure::Force(..) => force,
            Measure::Moment(..) => moment,
        }
    }

    fn violation(&self, from: &Pose, to: &Pose) -> Option<Violation> {
        if self.keeps(from, to) {
            return None;
        }
        let motion = from.toward(to);
        let places = (1.0 / TURNING_PLACE) as usize;
        let failed = |k: &usize| {
            let at = *k as f64 * TURNING_PLACE;
            let pose = motion.at(at);
            !holds(&Known { at, pose, slack: self.slack(&pose) }, &self.floors())
        };
        let at = (0..=places).find(failed).map_or(0.0, |k| k as f64 * TURNING_PLACE);
        const SAMPLES: usize = 64;
        let limits =
            (0..=SAMPLES).flat_map(|k| self.limits_at(&motion.at(at + (1.0 - at) * k as f64 / SAMPLES as f64)));
        let limit = limits.min_by(|a, b| a.order().total_cmp(&b.order()))?;
        Some(Violation::of_wrench(at, limit))
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::geometry::{Point, Rotation};
    use crate::model::{RobotSource, SceneSpec, WrenchSpec};
    use crate::testing::empty;
    use crate::trajectory::turning_bend::TurningBend;

    #[test]
    fn loads_that_turn_a_point_mass_are_refused() {
        let mut spec = empty().spec().clone();
        spec.wrench = Some(WrenchSpec::default());
        let RobotSource::Inline(robot) = &mut spec.robot else { panic!("testing scenes have their robot inline") };
        robot.cables.iter_mut().for_each(|cable| cable.attachment = [0.0, 0.0, 0.025]);
        let wrench = TurningWrench::of(&Scene::new(spec).unwrap()).unwrap().unwrap();
        let level = Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::identity());
        assert!(wrench.keeps(&level, &level));
        // Tilted, the centre of mass is no longer below the point where the cables meet.
        let tilted = Pose::new(level.position, Rotation::from_scaled_axis(Vector::x() * 0.2));
        assert!(!wrench.keeps(&level, &tilted));
        let violation = wrench.violation(&level, &tilted).unwrap();
        assert!(violation.wrench.unwrap().wrench_margin.is_none());
    }

    #[test]
    fn slack_stays_above_its_sagging_chord() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut counted = 0;
        for (margin, count) in [(MarginSpec::Capacity, 300), (MarginSpec::Projected, 100)] {
            let required = WrenchSpec { margin: Some(margin), ..WrenchSpec::default() };
            let scene = Scene::new(SceneSpec { wrench: Some(required), ..empty().spec().clone() }).unwrap();
            let wrench = TurningWrench::of(&scene).unwrap().unwrap();
            let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
            for k in 0..count {
                let size = 0.5f64.powi(k % 6);
                let first = Rotation::from_scaled_axis(any(0.5));
                let from = Pose::new(Point::new(1.0, 1.0, 1.0) + any(0.4), first);
                let turn = Rotation::from_scaled_axis(any(0.6 * size));
                let to = Pose::new(from.position + any(0.4 * size), turn * from.orientation);
                counted += sags(&wrench.cases[0], &from.toward(&to));
            }
        }
        assert!(counted > 50, "{counted}");
    }

    #[test]
    fn slack_drops_by_no_more_than_its_steepness() {
        let mut rng = ChaCha8Rng::seed_from_u64(6);
        // Levers of cables and of the weight that matter more than the directions of the cables.
        for (mass, center, tilt, least) in [(1.0, [0.0; 3], 0.5, 0.15), (30.0, [0.0, 0.0, -20.0], 0.01, 0.01)] {
            let wrench = WrenchSpec { characteristic_length: Some(0.02), ..WrenchSpec::default() };
            let mut spec = SceneSpec { wrench: Some(wrench), ..empty().spec().clone() };
            let RobotSource::Inline(robot) = &mut spec.robot else { panic!("testing scenes have their robot inline") };
            (robot.mass, robot.center_of_mass) = (Some(mass), Some(center));
            let scene = Scene::new(spec).unwrap();
            let (case, robot) = (&TurningWrench::of(&scene).unwrap().unwrap().cases[0], scene.robot());
            let reach = robot.cables().iter().map(|cable| cable.attachment.coords.norm()).fold(0.0, f64::max);
            let mut largest = 0.0_f64;
            for _ in 0..2000 {
                let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
                let here = Pose::new(Point::new(1.0, 1.0, 1.0) + any(0.4), Rotation::from_scaled_axis(any(tilt)));
                let (way, turn) = (any(1e-5), any(1e-3));
                let there = Pose::new(here.position + way, Rotation::from_scaled_axis(turn) * here.orientation);
                let (slack, measures) = (case.slack(&here)[0], case.measures_at(&here).unwrap());
                // Outside the set, the slack is not the distance from it.
                if !(slack >= 0.0) {
                    continue;
                }
                let turned = reach * turn.norm();
                let away = way.norm() + turned;
                let more = measures[0].steepness_of_turns(robot.center_of_mass(), reach) * turned;
                let most = measures[0].steepness(&here.position, away) * away + more;
                largest = largest.max((slack - case.slack(&there)[0]) / most);
            }
            assert!(largest > least && largest <= 1.0, "{mass} {largest}");
        }
    }

    /// Checks that the slack by each measure stays above the bound from its chord; returns the number of chords.
    fn sags(wrench: &Case, motion: &impl PoseCurve) -> usize {
        let ends = [0.0, 1.0].map(|share| motion.pose_at(share));
        let [a, b] = ends.each_ref().map(|pose| wrench.slack(pose));
        let judged = |m: &usize| {
            let sag = wrench.sag(&wrench.measures[*m], ends.each_ref(), &motion.derivatives(1.0));
            if !(a[*m] >= 0.0 && b[*m] >= 0.0 && sag.is_finite()) {
                return false;
            }
            for share in (1..12).map(|n| f64::from(n) / 12.0) {
                let least = (1.0 - share) * a[*m] + share * b[*m] - 4.0 * share * (1.0 - share) * sag;
                let slack = wrench.slack(&motion.pose_at(share))[*m];
                assert!(slack >= least - 1e-6, "{ends:?} at {share}: {slack} < {least}");
            }
            true
        };
        (0..wrench.measures.len()).filter(judged).count()
    }

    /// A bend about the middle of the empty scene. Some have no turns, and some turn about their corner alone.
    fn some_bend(rng: &mut ChaCha8Rng, k: i32) -> TurningBend {
        let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
        let corner = Pose::new(Point::new(1.0, 1.0, 1.0) + any(0.4), Rotation::from_scaled_axis(any(0.5)));
        let (velocities, spins) = ([any(1.0), any(1.0)], [any(8.0), any(8.0)]);
        let [moves, turns] = [f64::from(k % 3 != 1), f64::from(k % 3 != 2)];
        TurningBend::new(corner, velocities.map(|v| v * moves), spins.map(|w| w * turns), 0.3 * 0.5f64.powi(k % 7))
    }

    #[test]
    fn slack_stays_above_its_sagging_chord_on_bends() {
        let mut rng = ChaCha8Rng::seed_from_u64(6);
        let mut counted = 0;
        for (margin, count) in [(MarginSpec::Capacity, 300), (MarginSpec::Projected, 100)] {
            let required = WrenchSpec { margin: Some(margin), ..WrenchSpec::default() };
            let scene = Scene::new(SceneSpec { wrench: Some(required), ..empty().spec().clone() }).unwrap();
            let wrench = TurningWrench::of(&scene).unwrap().unwrap();
            for k in 0..count {
                let bend = some_bend(&mut rng, k);
                let ([v, _], [w, _]) = (bend.velocities(), bend.spins());
                // The way back ends where it begins, so only what is between the ends counts.
                let back = TurningBend::new(*bend.corner(), [*v, -v], [*w, -w], bend.length());
                counted += sags(&wrench.cases[0], &bend) + sags(&wrench.cases[0], &back);
            }
        }
        assert!(counted > 50, "{counted}");
    }

    /// A cable of the empty scene's robot from one place to another.
    fn cable(outlet: Point, attachment: Point) -> Cable {
        Cable { outlet, attachment, ..empty().robot().cables()[0].clone() }
    }

    /// While a long cable and a short arm turn in opposite directions at the same rate θ, the moment is r cos(2θt), so it bends four
    /// times as much as with one of them at rest. The product of both rates is half of that.
    #[test]
    fn moment_bounds_cover_opposite_turns_of_arm_and_cable() {
        let cable = cable(Point::new(0.0, 10.0, 0.0), Point::new(0.1, 0.0, 0.0));
        let [from, to] = [-0.05, 0.05].map(|angle: f64| {
            Pose::new(Point::new(-10.0 * angle.tan(), 0.0, 0.0), Rotation::from_scaled_axis(Vector::z() * angle))
        });
        let motion = from.toward(&to);
        let [first, middle, last] = [0.0, 0.5, 1.0].map(|share| Column::of(&cable, &motion.at(share)));
        let found = (middle.moment - 0.5 * (first.moment + last.moment)).norm();
        let [_, second] = second_derivatives(&cable, &[first, last], &motion.derivatives(1.0)).unwrap();
        let share = found / (0.125 * second);
        assert!(share > 0.9 && share <= 1.0, "{share}");
    }

    /// There and back towards the side of the outlet: the ends say nothing about speed and length of the cable between them, which
    /// follow from the acceleration.
    #[test]
    fn direction_bounds_cover_motion_there_and_back() {
        let cable = cable(Point::new(0.0, 1.0, 0.0), Point::origin());
        for way in [0.2_f64, 0.3, 0.4] {
            // As far as the cable can turn: at the turning point it is perpendicular to the way.
            let angle = way.asin();
            let place = Point::new(way * angle.cos(), way * angle.sin(), 0.0);
            let column = |place| Column::of(&cable, &Pose::new(place, Rotation::identity()));
            let [start, turning] = [Point::origin(), place].map(column);
            let found = (turning.unit - start.unit).norm();
            assert!((found - 2.0 * (0.5 * angle).sin()).abs() < 1e-12);
            let bounds = Derivatives { position: 8.0 * way, turned: [0.0; 2] };
            let ends = [Point::origin(); 2].map(column);
            let Some([second, _]) = second_derivatives(&cable, &ends, &bounds) else { panic!("{way}") };
            assert!(way < found && found <= 0.125 * second, "{way} {found} {second}");
        }
    }

    /// Checks each summand of [`TurningWrench::sag`] alone: the sum could hide an error in one of them.
    #[test]
    fn columns_and_arms_on_bends_keep_their_bounds() {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let scene = empty();
        let mut closest = [[0.0_f64; 3]; 3];
        for k in 0..600 {
            let bend = some_bend(&mut rng, k);
            let bounds = bend.derivatives(1.0);
            let cable = &scene.robot().cables()[k as usize % 8];
            let column = |share: f64| Column::of(cable, &bend.pose_at(share));
            let arm = |share: f64| bend.pose_at(share).orientation * Vector::new(0.6, 0.0, 0.8);
            let Some([force, moment]) = second_derivatives(cable, &[column(0.0), column(1.0)], &bounds) else {
                continue;
            };
            for share in (1..12).map(|n| f64::from(n) / 12.0) {
                let off = |of: &dyn Fn(f64) -> Vector| (of(share) - of(0.0) * (1.0 - share) - of(1.0) * share).norm();
                let deviations = [off(&|s| column(s).unit), off(&|s| column(s).moment), off(&arm)];
                for (n, (found, second)) in deviations.into_iter().zip([force, moment, bounds.turned[1]]).enumerate() {
                    let most = 0.5 * share * (1.0 - share) * second;
                    assert!(found <= most * (1.0 + 1e-9) + 1e-13, "{n} {k}: {found} {most}");
                    let closest = &mut closest[k as usize % 3][n];
                    *closest = closest.max((found - 1e-13) / most);
                }
            }
        }
        let tight = |k: usize| closest[k].iter().filter(|share| **share > 0.7).count();
        assert_eq!([0, 1, 2].map(tight), [3, 3, 2], "{closest:?}"); // with both, on the spot, without turns
    }
}
