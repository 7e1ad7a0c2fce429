//! The tensions that a moving platform needs: they balance weight, load and inertia.
//!
//! The platform's origin has the acceleration a, the centre of mass is at c from it, and the platform turns with the angular
//! velocity ω and acceleration α about an axis e of the world. Then the cables must exert, besides the balance at rest, the force
//! m (a + α × c + ω × (ω × c)) and the moment about the origin c × force + I α + ω × (I ω), with I the inertia about the centre of
//! mass in world axes (Newton and Euler).
//!
//! **Between two instants** each of these is bounded by derivatives ([`Rates`]). On a line, the angular momentum is I ω
//! = ψ̇ h with ψ the angle and h = I e; the axis is fixed in the platform and in the world, so h turns with the
//! platform like any vector fixed in it. Hence the second derivative of its rate is the fourth derivative of such a
//! vector, at the distance of h from the axis, in kg·m². A product such as c × force has the second derivative c″ × f +
//! 2 c′ × f′ + c × f″.
//!
//! On a bend, the axis changes. The second derivative of the rate of I ω is I ω‴ + 3 I′ ω″ + 3 I″ ω′ + I‴ ω. With I = R (m 1 + D) Rᵀ and
//! m the middle between the smallest and the largest principal moment, only R D Rᵀ changes. Its norm is half of their difference, and its
//! derivatives are bounded by Σ C(k, j) ρ⁽ʲ⁾ ρ⁽ᵏ⁻ʲ⁾ times that, with the bounds ρ⁽ʲ⁾ of the derivatives of unit vectors of the platform.

mod any_outlet;

use std::borrow::Cow;
use std::collections::VecDeque;

use nalgebra::{Matrix3, Matrix6, Matrix6xX, Vector6};

use super::jet::Jet;
use super::motion::{Motion, Rates};
use crate::error::Error;
use crate::geometry::{Placed, Point, Pose, Rotation, Vector};
use crate::model::spec::MotionSpec;
use crate::model::{Distribution, Scene};
use crate::tolerances::{RANK_RELATIVE, SAME_TURN, TENSION_RESERVES, TURNING};
use crate::wrench::{
    Balance, Demand, DemandFacets, FacetPair, Holding, Loads, StaticCable, Statics, TensionQp, TensionShare, Turned,
};

/// The time between two instants.
#[derive(Debug, Clone, Copy)]
pub struct Span<'a> {
    /// The motion at both instants.
    pub ends: &'a [Motion; 2],
    /// Bounds of the motion's derivatives in between.
    pub rates: &'a Rates,
    /// Duration, s.
    pub time: f64,
}

/// A platform with mass on cables with limits of tension, in one load case.
#[derive(Debug, Clone)]
pub struct MovingMass {
    statics: Statics,
    loads: Loads,
    mass: f64,
    /// Centre of mass, platform frame, m.
    center: Vector,
    /// Inertia about the centre of mass, platform axes, kg·m².
    inertia: Matrix3<f64>,
    /// Whether the inertia is that of the parts at uniform density, and matters.
    assumed: bool,
    /// Tension limits, N.
    limits: Vec<[f64; 2]>,
    /// The facets of the wrenches that are available with a reserve of tension.
    facets: DemandFacets,
}

/// Bounds for a cable and its column of the wrench matrix between two instants.
struct CableBounds {
    /// Bounds of the first and second derivative of the attachment, m/s and m/s².
    attachment: [f64; 2],
    /// Bounds of the first and second derivative of the arm divided by the characteristic length.
    arm: [f64; 2],
    /// Norm of the column for a unit of the cable's vector.
    lever: f64,
}

/// Tensions at the most recently queried instants: where one time ends, the next one begins.
#[derive(Default)]
pub struct CaseTensions {
    solver: TensionQp,
    /// For each instant, its tensions; `None` where no tensions are known to exist.
    known: VecDeque<(Motion, Option<Vec<f64>>)>,
}

/// Number of instants that are remembered.
const RECENT: usize = 3;

impl CaseTensions {
    fn of(
        &mut self,
        motion: &Motion,
        solve: impl FnOnce(&mut TensionQp) -> Result<Option<Balance>, Error>,
    ) -> Result<Option<&[f64]>, Error> {
        let place = match self.known.iter().position(|(known, _)| known == motion) {
            Some(place) => place,
            None => {
                // At a limit the solver may not be able to decide; then nothing is proved.
                let found = match solve(&mut self.solver)? {
                    Some(Balance::Feasible(tensions)) => Some(tensions.as_slice().to_vec()),
                    _ => None,
                };
                self.known.truncate(RECENT - 1);
                self.known.push_front((*motion, found));
                0
            }
        };
        Ok(self.known[place].1.as_deref())
    }
}

/// Parts into which a time is divided in which a cable may lose its direction, or the cables their hold.
const TOO_LONG: f64 = 4.0;

impl MovingMass {
    /// The platform of a scene in each load case, for motions that keep the orientation of the scene or on which it turns; or why
    /// tensions cannot be limited.
    ///
    /// # Errors
    /// Tension limits of some cables but not of all; a moment that a point mass cannot balance.
    pub fn cases(
        scene: &Scene,
        limits: &MotionSpec,
        start: &Pose,
        turns: bool,
    ) -> Result<Result<Vec<Self>, String>, Error> {
        let assumed = turns && scene.robot().spec().inertia.is_none();
        let able = |mass: MovingMass| match turns && mass.statics.point_mass() {
            true => Err("all cables meet in one point of the platform, so they cannot turn it".to_string()),
            false => Ok(MovingMass { assumed, ..mass }),
        };
        let cases: Result<Result<Vec<Self>, String>, Error> =
            Loads::cases(scene).into_iter().map(|loads| Self::of(scene, loads, limits, start)).collect();
        Ok(cases?.and_then(|cases| cases.into_iter().map(able).collect()))
    }

    /// The platform under these loads.
    fn of(scene: &Scene, loads: Loads, limits: &MotionSpec, start: &Pose) -> Result<Result<Self, String>, Error> {
        let robot = scene.robot();
        if robot.mass().is_none() {
            return Ok(Err("the mass of the platform is unknown".to_string()));
        }
        if robot.cables().iter().all(|cable| cable.tension.is_none()) {
            return Ok(Err("the cables have no tension limits".to_string()));
        }
        let statics = Statics::new(robot, &loads)?;
        if let Some(moment) = statics.moment_on_point_mass() {
            let problem =
                format!("found a moment of {moment:.3} N·m about the point where all cables meet, expected none");
            return Err(Error::invalid("robot.center_of_mass", problem));
        }
        let mass = MovingMass {
            mass: loads.mass(robot).unwrap_or_default(),
            center: robot.center_of_mass().coords,
            inertia: robot.inertia().unwrap_or_default(),
            assumed: false,
            limits: statics.limits(),
            facets: DemandFacets::new(statics.clone().with_reserve(TENSION_RESERVES[0]), limits.wrench_margin()),
            loads,
            statics,
        };
        let hold = mass.statics_at(&start.orientation).hold(&start.position);
        if let Some(hold) = hold.filter(|hold| hold.holding == Holding::Underconstrained) {
            return Ok(Err(hold.sentence()));
        }
        Ok(Ok(mass))
    }

    /// The platform on cables that leave another share of their range of tensions unused at both ends.
    pub fn with_reserve(&self, share: f64, limits: &MotionSpec) -> Self {
        let facets = DemandFacets::new(self.statics.clone().with_reserve(share), limits.wrench_margin());
        MovingMass { facets, ..self.clone() }
    }

    /// Which of all tensions the robot keeps.
    pub fn distribution(&self) -> Distribution {
        self.statics.distribution()
    }

    /// Tension limits of the cables, N.
    pub fn limits(&self) -> &[[f64; 2]] {
        &self.limits
    }

    /// The assumption about the platform's inertia, if it matters.
    pub fn assumption(&self) -> Option<&'static str> {
        self.assumed.then_some("the robot gives no inertia: that of its parts at uniform density is assumed")
    }

    /// Whether an orientation equals that of the statics.
    fn is_level(&self, orientation: &Rotation) -> bool {
        *orientation == self.loads.orientation || orientation.angle_to(&self.loads.orientation) <= SAME_TURN
    }

    /// The turn to an orientation, and the wrench that must be balanced there.
    fn turned(&self, orientation: &Rotation) -> Turned {
        let balance = self.loads.at(orientation).balance_of(self.mass, &self.center);
        (Placed::new(&Pose::new(Point::origin(), *orientation), &self.loads.orientation), balance)
    }

    fn statics_at(&self, orientation: &Rotation) -> Cow<'_, Statics> {
        if self.is_level(orientation) {
            return Cow::Borrowed(&self.statics);
        }
        let (turn, balance) = self.turned(orientation);
        Cow::Owned(self.statics.turned(&turn, balance))
    }

    /// The wrench that an acceleration, an angular acceleration and an angular velocity need at an orientation, as
    /// [force; moment / ℓ], N.
    fn wrench(&self, orientation: &Rotation, acceleration: &Vector, turn: [&Vector; 2]) -> Vector6<f64> {
        let (length, [faster, spin]) = (self.statics.characteristic_length(), turn);
        let center = orientation * self.center;
        let force = (acceleration + faster.cross(&center) + spin.cross(&spin.cross(&center))) * self.mass;
        let [gain, momentum] = turn.map(|v| self.inertia_times(orientation, v));
        let moment = (center / length).cross(&force) + (gain + spin.cross(&momentum)) / length;
        Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
    }

    /// The inertia, in world axes, times a vector.
    fn inertia_times(&self, orientation: &Rotation, v: &Vector) -> Vector {
        if *v == Vector::zeros() {
            return *v;
        }
        orientation * (self.inertia * orientation.inverse_transform_vector(v))
    }

    fn wrench_of(&self, motion: &Motion) -> Vector6<f64> {
        let turn = [&motion.angular_acceleration, &motion.angular_velocity];
        self.wrench(&motion.orientation, &motion.acceleration, turn)
    }

    /// The turns to these orientations, unless all of them equal that of the statics.
    fn turns<'a>(&self, orientations: impl Iterator<Item = &'a Rotation> + Clone) -> Option<Vec<Turned>> {
        let level = orientations.clone().all(|orientation| self.is_level(orientation));
        (!level).then(|| orientations.map(|orientation| self.turned(orientation)).collect())
    }

    /// Visits the tension limits at places of a curve; see [`super::Winches::for_each_tension_limit`].
    pub fn for_each_limit(
        &self,
        places: &[(Jet, [f64; 2])],
        mut visit: impl FnMut(usize, [f64; 3]),
    ) -> Result<(), usize> {
        let nothing = Vector::zeros();
        let demand = |(jet, most): &(Jet, [f64; 2])| {
            let by_u = self.wrench(&jet.orientation, &jet.first, [&jet.spin, &nothing]);
            let by_x = self.wrench(&jet.orientation, &jet.second, [&jet.spin_change, &jet.spin]);
            Demand { position: jet.position, wrenches: [by_u, by_x], most: *most }
        };
        let demands: Vec<Demand> = places.iter().map(demand).collect();
        let turns = self.turns(places.iter().map(|(jet, _)| &jet.orientation));
        let lacking =
            self.facets.for_each(&demands, turns.as_deref(), |k, FacetPair { heights: [a, b], slack, .. }| {
                visit(k, [*a, *b, slack[0]]);
                visit(k, [-a, -b, slack[1]]);
            });
        lacking.map_or(Ok(()), Err)
    }

    /// The share of the slack at rest that each motion uses; see [`super::Winches::tension_shares`].
    pub fn shares(&self, motions: &[Motion]) -> Result<Vec<TensionShare>, usize> {
        // Facets depend on the pose alone: where one motion ends, the next one begins.
        let same_pose = |a: &Motion, b: &Motion| a.position == b.position && a.orientation == b.orientation;
        let pairs: Vec<&[Motion]> = motions.chunk_by(same_pose).flat_map(|same| same.chunks(2)).collect();
        let demand = |pair: &&[Motion]| {
            let wrenches = [0, pair.len() - 1].map(|k| self.wrench_of(&pair[k]));
            Demand { position: pair[0].position, wrenches, most: [f64::INFINITY; 2] }
        };
        let demands: Vec<Demand> = pairs.iter().map(demand).collect();
        let turns = self.turns(pairs.iter().map(|pair| &pair[0].orientation));
        let shares = self.facets.shares(&demands, turns.as_deref());
        let shares = shares.map_err(|k| pairs[..k].iter().map(|pair| pair.len()).sum::<usize>())?;
        Ok(pairs.iter().zip(shares).flat_map(|(pair, shares)| shares.into_iter().take(pair.len())).collect())
    }

    /// How much the slack of the available wrenches can drop below its values at both ends of a motion, in any direction, N;
    /// compare [`crate::wrench::Measure::sag`]. A column u, r × u/ℓ of the wrench matrix, with r the arm of the cable, has the
    /// second derivative u″, (r″ × u + 2 r′ × u′ + r × u″)/ℓ.
    pub fn sag(&self, span: &Span) -> f64 {
        if self.of_any_outlet() {
            return self.sag_of_any(span);
        }
        let Span { ends, rates, time } = span;
        let [before, after] = ends.each_ref().map(|motion| self.lengths(motion));
        let bounds = self.bounds(&ends[0], rates).zip(before.zip(after));
        let cable = |(line, (bounds, (before, after))): (&StaticCable, (CableBounds, (f64, f64)))| {
            let [speed, acceleration] = bounds.attachment;
            let shortest = 0.5 * (before + after - speed * time);
            if !(shortest > 0.0) {
                return f64::INFINITY;
            }
            let turn = (speed / shortest * time).min(2.0);
            let bend = time * time * (acceleration / shortest + TURNING[1] * (speed / shortest).powi(2));
            let [least, largest] = line.tension;
            let straight = bounds.lever * (0.25 * (largest - least) * turn + 0.125 * largest * bend);
            let [swing, jolt] = bounds.arm;
            let turned = 0.25 * (largest - least) * swing * time
                + 0.125 * largest * time * time * (jolt + 2.0 * swing * speed / shortest);
            straight + turned
        };
        let cables: f64 = self.statics.cables().iter().zip(bounds).map(cable).sum();
        cables + time * time / 8.0 * self.second_derivative(&ends[0], rates)
    }

    /// Whether tensions within the limits exist everywhere on a motion between two instants: if the number is at most
    /// 1. Otherwise it is the number of equal parts on which the proof may succeed; it is infinite if it cannot.
    ///
    /// The forces per length τ of the cables at both ends are interpolated linearly. The imbalance that remains is zero at both
    /// ends, and its second derivative is bounded; the shortest correction is at most that over the smallest singular value of
    /// the matrix of cable vectors l and their moments r × l/ℓ. With pulleys or errors of outlets nothing is proved.
    ///
    /// # Errors
    /// A solver that reached no answer.
    pub fn hold_between(&self, solver: &mut CaseTensions, span: &Span) -> Result<f64, Error> {
        let Span { ends, rates, time } = *span;
        if self.of_any_outlet() {
            return Ok(f64::INFINITY);
        }
        let reserved = self.facets.statics().limits();
        let mut densities: [Vec<f64>; 2] = Default::default();
        let lengths = ends.each_ref().map(|motion| self.lengths(motion).collect::<Vec<f64>>());
        for (k, motion) in ends.iter().enumerate() {
            let found = solver.of(motion, |solver| self.balance(solver, motion, &reserved, Distribution::Middle))?;
            let Some(tensions) = found else { return Ok(f64::INFINITY) };
            densities[k] = tensions.iter().zip(&lengths[k]).map(|(t, l)| t / l).collect();
        }
        let eighth = time * time / 8.0;
        let cables: Vec<CableBounds> = self.bounds(&ends[0], rates).collect();
        // What the turn of the arms adds to the first and second derivative of a cable's vector and moment.
        let turned = |k: usize| {
            let CableBounds { attachment: [speed, _], arm: [swing, jolt], .. } = &cables[k];
            let longest = lengths[0][k].max(lengths[1][k]) + speed * time;
            [swing * longest, jolt * longest + 2.0 * swing * speed]
        };
        let share = |k: usize| {
            let CableBounds { attachment: [speed, acceleration], lever, .. } = &cables[k];
            let change = (densities[1][k] - densities[0][k]).abs() / time;
            let ([swing, jolt], density) = (turned(k), densities[0][k].max(densities[1][k]));
            lever * (density * acceleration + 2.0 * change * speed) + density * jolt + 2.0 * change * swing
        };
        let missing = self.second_derivative(&ends[0], rates) + (0..cables.len()).map(share).sum::<f64>();
        let correction = eighth * missing / self.least_singular_value_during(&cables, [&lengths[0], &lengths[1]], span);
        let parts = |k: usize| {
            let [speed, acceleration] = cables[k].attachment;
            let (l, tau) = (lengths[0][k].max(lengths[1][k]), densities[0][k].max(densities[1][k]));
            let shortest = lengths[0][k].min(lengths[1][k]) - speed * time;
            let change = (densities[1][k] - densities[0][k]).abs() / time;
            let bend = (acceleration + speed * speed / shortest) * tau + 2.0 * speed * change;
            let reserve = reserved[k][0] - self.limits[k][0];
            // What is missing at most grows with the square of the time.
            let missing = ((l + speed * time) * correction + eighth * bend) / reserve;
            if shortest > 0.0 { missing.sqrt() } else { TOO_LONG }
        };
        if !(correction >= 0.0) {
            return Ok(TOO_LONG);
        }
        Ok((0..cables.len()).map(parts).fold(0.0, |most, parts| if parts <= most { most } else { parts }))
    }

    /// A lower bound of how much more slack the available wrenches have between two instants than those with a reserve
    /// of tension, in any direction, N. In a unit direction c the reserves r add Σ r |c·w| over the columns w, which is
    /// at least the least r times the smallest singular value of the wrench matrix.
    pub fn spare(&self, span: &Span) -> f64 {
        if self.of_any_outlet() {
            return self.spare_of_any(span);
        }
        let lengths = span.ends.each_ref().map(|motion| self.lengths(motion).collect::<Vec<f64>>());
        let cables: Vec<CableBounds> = self.bounds(&span.ends[0], span.rates).collect();
        let longest = |k: usize| lengths[0][k].max(lengths[1][k]) + cables[k].attachment[0] * span.time;
        let most = (0..cables.len()).map(longest).fold(0.0, f64::max);
        let least = self.least_singular_value_during(&cables, [&lengths[0], &lengths[1]], span);
        self.least_reserve() * (least / most).max(0.0)
    }

    /// The least reserve of tension of all cables, N.
    fn least_reserve(&self) -> f64 {
        let reserves = self.facets.statics().limits().into_iter().zip(&self.limits);
        reserves.map(|(reserved, limits)| reserved[0] - limits[0]).fold(f64::INFINITY, f64::min)
    }

    /// A lower bound of [`MovingMass::least_singular_value`] between two instants, given the lengths of the cables at both.
    fn least_singular_value_during(&self, cables: &[CableBounds], lengths: [&[f64]; 2], span: &Span) -> f64 {
        let Span { ends, rates, time } = *span;
        let moved = |k: usize| {
            let CableBounds { attachment: [speed, _], arm: [swing, _], lever } = cables[k];
            let longest = lengths[0][k].max(lengths[1][k]) + speed * time;
            lever * speed + swing * longest
        };
        let drift = (0..cables.len()).map(|k| moved(k).powi(2)).sum::<f64>().sqrt() * time;
        self.least_singular_value(&ends[0], rates.turns()) - drift
    }

    /// The bounds for each cable; those of a platform that turns do not depend on the instant.
    fn bounds<'a>(&'a self, motion: &Motion, rates: &'a Rates) -> impl Iterator<Item = CableBounds> + 'a {
        let length = self.statics.characteristic_length();
        self.arms(&motion.orientation).map(move |arm| {
            let ([speed, acceleration, ..], [swing, jolt, ..]) = (rates.of_point(&arm), rates.turned(&arm));
            let lever = (1.0 + (arm / length).norm_squared()).sqrt();
            CableBounds { attachment: [speed, acceleration], arm: [swing / length, jolt / length], lever }
        })
    }

    /// From the origin to each attachment at an orientation, world axes, m.
    fn arms<'a>(&'a self, orientation: &Rotation) -> impl Iterator<Item = Vector> + 'a {
        let turn = (!self.is_level(orientation)).then(|| self.turned(orientation).0);
        let arm = move |cable: &StaticCable| turn.as_ref().map_or(cable.arm, |turn| turn.turned(&cable.arm));
        self.statics.cables().iter().map(arm)
    }

    /// A bound of the second time derivative of the wrench to be balanced, as [force; moment / ℓ], N/s².
    fn second_derivative(&self, motion: &Motion, rates: &Rates) -> f64 {
        let length = self.statics.characteristic_length();
        let center = motion.orientation * self.center;
        let heaviness = self.mass * (center / length).norm().hypot(1.0);
        let [_, second, third, fourth, _] = rates.of_point(&center);
        if !rates.turns() {
            return heaviness * fourth;
        }
        let [swing, jolt, ..] = rates.turned(&center);
        let turned = self.momentum_derivative(motion, rates);
        let weight = self.loads.gravity.norm() * self.mass;
        let moment = jolt * (self.mass * second + weight) + 2.0 * swing * self.mass * third + turned;
        heaviness * fourth + moment / length
    }

    /// A bound of the third time derivative of the angular momentum, N·m/s².
    fn momentum_derivative(&self, motion: &Motion, rates: &Rates) -> f64 {
        if let Some(axis) = rates.axis() {
            let [.., turned, _] = rates.turned(&self.inertia_times(&motion.orientation, axis));
            return turned;
        }
        let ([u1, u2, u3, ..], [w0, w1, w2, w3]) = (rates.unit(), rates.turn());
        let moments = self.inertia.symmetric_eigenvalues();
        let spread = 0.5 * (moments.max() - moments.min());
        let change = [2.0 * u1, 2.0 * (u2 + u1 * u1), 2.0 * u3 + 6.0 * u1 * u2].map(|rate| spread * rate);
        moments.max() * w3 + 3.0 * (change[0] * w2 + change[1] * w1) + change[2] * w0
    }

    /// Lengths of the cables, m.
    fn lengths<'a>(&'a self, motion: &Motion) -> impl Iterator<Item = f64> + 'a {
        let (position, cables) = (motion.position, self.statics.cables().iter());
        cables.zip(self.arms(&motion.orientation)).map(move |(cable, arm)| (cable.outlet - (position + arm)).norm())
    }

    /// The chosen ones of all tensions within the limits that balance loads and inertia; `None` if there are none.
    ///
    /// # Errors
    /// A solver that reached no answer.
    pub fn solve(
        &self,
        solver: &mut TensionQp,
        motion: &Motion,
        chosen: Distribution,
    ) -> Result<Option<Vec<f64>>, Error> {
        match self.balance(solver, motion, &self.limits, chosen)? {
            Some(Balance::Feasible(tensions)) => Ok(Some(tensions.as_slice().to_vec())),
            Some(Balance::Infeasible) | None => Ok(None),
            Some(Balance::Undecided) => {
                Err(Error::internal(format!("the solver could not decide at {:?}", motion.position)))
            }
        }
    }

    /// The tensions of [`MovingMass::solve`] as far as the solver can tell; `None` if a cable has no direction.
    fn balance(
        &self,
        solver: &mut TensionQp,
        motion: &Motion,
        limits: &[[f64; 2]],
        chosen: Distribution,
    ) -> Result<Option<Balance>, Error> {
        let statics = self.statics_at(&motion.orientation);
        let Some(columns) = statics.columns(&motion.position) else { return Ok(None) };
        let wrench = statics.balance() + self.wrench_of(motion);
        solver.distribute(chosen, &Matrix6xX::from_columns(&columns), limits, &wrench).map(Some)
    }

    /// The smallest singular value, other than zero, of the matrix of cable vectors and their moments, m. If the platform turns,
    /// zero counts as well, since the imbalance may then have any direction.
    fn least_singular_value(&self, motion: &Motion, turns: bool) -> f64 {
        let (length, statics) = (self.statics.characteristic_length(), self.statics_at(&motion.orientation));
        let mut gram = Matrix6::zeros();
        for StaticCable { outlet, arm, .. } in statics.cables() {
            let line = outlet - (motion.position + arm);
            let moment = arm.cross(&line) / length;
            let column = Vector6::new(line.x, line.y, line.z, moment.x, moment.y, moment.z);
            gram += column * column.transpose();
        }
        let squares = gram.symmetric_eigenvalues();
        let largest = squares.max();
        let counts = |square: &&f64| **square > (RANK_RELATIVE * RANK_RELATIVE).max(1e-14) * largest;
        if turns && !squares.iter().all(|square| counts(&square)) {
            return 0.0;
        }
        squares.iter().filter(counts).fold(f64::INFINITY, |least, square| least.min(*square)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::model::{InertiaSpec, RobotSource};
    use crate::testing::empty;
    use crate::trajectory::curve::{Curve, Piece};
    use crate::trajectory::timing::Phase;
    use crate::trajectory::turning_bend::TurningBend;

    /// What must be balanced changes on a bend no faster than bounded.
    #[test]
    fn second_derivative_of_the_wrench_on_a_bend_is_bounded() {
        let mut spec = empty().spec().clone();
        let RobotSource::Inline(robot) = &mut spec.robot else { panic!("testing scenes have their robot inline") };
        (robot.mass, robot.center_of_mass) = (Some(10.0), Some([0.02, -0.01, 0.015]));
        robot.inertia = Some(InertiaSpec::Diagonal([0.3, 0.5, 0.7]));
        let scene = Scene::new(spec).unwrap();
        let start = Pose::new(Point::new(1.1, 0.9, 1.0), Rotation::from_scaled_axis(Vector::new(0.1, -0.2, 0.3)));
        let mass = MovingMass::cases(&scene, &MotionSpec::default(), &start, true).unwrap().unwrap().remove(0);
        let mut rng = ChaCha8Rng::seed_from_u64(6);
        let mut closest = 0.0_f64;
        for _ in 0..300 {
            let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
            let corner = Pose::new(start.position + any(0.3), Rotation::from_scaled_axis(any(0.5)));
            let bend = TurningBend::new(corner, [any(1.0), any(1.0)], [any(5.0), any(5.0)], 0.1 + any(0.3).x.abs());
            let curve = Curve::new(vec![Piece::turning_bend(bend)]);
            let [s, speed, acceleration, jerk] = [0.4 * bend.length(), 0.5, any(1.0).x, any(5.0).x];
            let (phase, time, h) = (Phase { time: 0.0, s, speed, acceleration, jerk }, 0.02, 1e-3);
            let needed = |t: f64| {
                let motion = Motion::on(&curve, 0, &phase.after(t));
                mass.statics_at(&motion.orientation).balance() + mass.wrench_of(&motion)
            };
            let rates = Rates::new(&curve.pieces()[0], &phase, &phase.after(time), time);
            let bound = mass.second_derivative(&Motion::on(&curve, 0, &phase), &rates);
            for t in [0.002, 0.01, 0.018] {
                let found = ((needed(t + h) - needed(t) * 2.0 + needed(t - h)) / (h * h)).norm();
                assert!(found <= bound * (1.0 + 1e-6), "{found} {bound}");
                closest = closest.max(found / bound);
            }
        }
        assert!(closest > 0.1, "{closest}");
    }
}
