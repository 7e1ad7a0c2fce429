//! Where the platform settles if the winches are commanded the lengths of taut cables at a pose, without their stretch.
//!
//! A cable of unstretched length c, lead included, pulls with T = E A max(0, e) / c, where e is what the platform's pose lengthens it by.
//! The platform comes to rest where these tensions balance the loads: where the energy of cables and loads is least. Its gradient, with
//! respect to the position and to a turn of the platform, is the wrench that is missing; its Hessian is the stiffness of the taut cables.
//! Newton's method finds the zero of the gradient. A step that raises the energy and the missing wrench is damped, as in the method of
//! Levenberg and Marquardt: cables become taut and slack on the way, and motions that no cable resists have no stiffness.
//!
//! # Source
//! S. Behzadipour, A. Khajepour, *Stiffness of cable-based parallel manipulators with application to stability analysis*, Journal
//! of Mechanical Design 128 (1), 2006. Pulleys and the turn of the loads are ours.

use nalgebra::{Matrix3, Matrix6, Vector6};
use serde::Serialize;

use super::statics::Loads;
use crate::geometry::{Departure, Point, Pose, Rotation, Vector};
use crate::limits::SETTLING_STEPS;
use crate::model::{Cable, Robot};
use crate::tolerances::{SETTLED, SETTLED_STRETCH};

/// How far the platform settles on cables that stretch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Settling {
    /// Distance that the platform's origin moves, m.
    pub displacement: f64,
    /// Angle that the platform turns, rad.
    pub rotation: f64,
}

impl Settling {
    /// How far the platform of a robot settles under loads, at rest, if its winches are commanded the lengths of taut cables at a
    /// pose; the orientation of the loads is not used. `None` if the mass of the platform or the stiffness of a cable is not known, if a
    /// cable cannot reach its attachment, or if the platform does not come to rest where all cables can.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, Pose, Robot, Rotation, testing};
    /// use cdpr_core::wrench::{Loads, Settling};
    /// let mut spec = testing::empty().robot().spec().clone();
    /// spec.cables.iter_mut().for_each(|cable| cable.stiffness = Some(1e5));
    /// let at = Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::identity());
    /// let found = Settling::of(&Robot::try_from(spec)?, &Loads::default(), &at).unwrap();
    /// assert!(found.displacement > 1e-4 && found.displacement < 1e-2 && found.rotation < 1e-9);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn of(robot: &Robot, loads: &Loads, commanded: &Pose) -> Option<Self> {
        let elastic = Elastic::of(robot, loads, commanded)?;
        let found = elastic.rest(*commanded)?;
        let displacement = (found.position - commanded.position).norm();
        Some(Settling { displacement, rotation: commanded.angle_to(&found) })
    }
}

/// A platform on elastic cables.
struct Elastic<'a> {
    cables: &'a [Cable],
    /// Unstretched length of each cable, m, and its tension for each metre that it is stretched, N/m.
    wound: Vec<[f64; 2]>,
    /// Length of each cable at the commanded pose, m.
    lengths: Vec<f64>,
    weight: Vector,
    /// Centre of mass, platform frame, m.
    center: Vector,
    /// A constant wrench, with its moment about the platform's origin, N and N·m.
    load: Vector6<f64>,
    /// Length by which moments are compared to forces, m: the longest arm of a force.
    arm: f64,
}

/// The platform at a pose.
struct State {
    /// Energy of cables and weight, J.
    energy: f64,
    /// Wrench that cables and loads exert together, N and N·m.
    missing: Vector6<f64>,
    stiffness: Matrix6<f64>,
    /// Forces that balance each other at best, N.
    forces: f64,
}

impl<'a> Elastic<'a> {
    fn of(robot: &'a Robot, loads: &Loads, commanded: &Pose) -> Option<Self> {
        let cables = robot.cables();
        let arms = cables.iter().map(|cable| cable.attachment.coords.norm());
        let arm = arms.fold(robot.center_of_mass().coords.norm(), f64::max);
        let lengths: Vec<f64> =
            cables.iter().map(|cable| cable.length_to(&commanded.place(&cable.attachment))).collect();
        let wound = |(cable, length): (&Cable, &f64)| {
            let wound = length + cable.drum.map_or(0.0, |drum| drum.lead);
            (cable.stiffness.is_finite() && wound > 0.0).then(|| [wound, cable.stiffness / wound])
        };
        Some(Elastic {
            wound: cables.iter().zip(&lengths).map(wound).collect::<Option<_>>()?,
            lengths,
            weight: loads.gravity * loads.mass(robot)?,
            center: robot.center_of_mass().coords,
            load: loads.load,
            arm: if arm > 0.0 { arm } else { 1.0 },
            cables,
        })
    }

    /// The pose at which the platform is at rest.
    fn rest(&self, mut pose: Pose) -> Option<Pose> {
        let (mut state, mut damping) = (self.at(&pose)?, 0.0);
        for _ in 0..SETTLING_STEPS {
            if self.size(&state.missing) <= SETTLED * state.forces + SETTLED_STRETCH * self.stiffness() {
                return Some(pose);
            }
            let better = self.step(&state, damping).and_then(|step| {
                let turn = Rotation::from_scaled_axis(step.fixed_rows::<3>(3).into_owned());
                let next = Pose::new(pose.position + step.fixed_rows::<3>(0), turn * pose.orientation);
                let found = self.at(&next)?;
                let gain = state.energy - found.energy + self.load.dot(&step);
                (gain > 0.0 || self.size(&found.missing) < self.size(&state.missing)).then_some((next, found))
            });
            match better {
                Some(better) => {
                    (pose, state) = better;
                    damping *= 0.1;
                }
                None => damping = f64::max(10.0 * damping, f64::EPSILON),
            }
        }
        None
    }

    /// Newton's step, with the stiffness increased by a share of that of all cables.
    fn step(&self, state: &State, damping: f64) -> Option<Vector6<f64>> {
        let more = damping * self.wound.iter().map(|[_, stiffness]| stiffness).sum::<f64>();
        let turning = more * self.arm.powi(2);
        let damped =
            state.stiffness + Matrix6::from_diagonal(&Vector6::new(more, more, more, turning, turning, turning));
        let step = damped.cholesky()?.solve(&state.missing);
        step.iter().all(|x| x.is_finite()).then_some(step)
    }

    /// The norm of a wrench, N.
    fn size(&self, wrench: &Vector6<f64>) -> f64 {
        let [force, moment] = [0, 3].map(|k| wrench.fixed_rows::<3>(k).norm());
        force.hypot(moment / self.arm)
    }

    /// The sum of the axial stiffnesses E A, N.
    fn stiffness(&self) -> f64 {
        self.cables.iter().map(|cable| cable.stiffness).sum()
    }

    /// The platform at a pose; `None` if a cable cannot reach it.
    fn at(&self, pose: &Pose) -> Option<State> {
        let center = pose.orientation * self.center;
        let mut state = State {
            energy: -self.weight.dot(&(pose.position.coords + center)),
            missing: self.load + wrench(&self.weight, &center),
            stiffness: rotated(&-self.weight, &center),
            forces: self.size(&(self.load + wrench(&self.weight, &center))),
        };
        for ((cable, [_, stiffness]), length) in self.cables.iter().zip(&self.wound).zip(&self.lengths) {
            let (attachment, arm) = (pose.place(&cable.attachment), pose.orientation * cable.attachment.coords);
            let departure = cable.departure(&attachment)?;
            let stretch = departure.length - length;
            if stretch < 0.0 {
                continue; // slack
            }
            let (tension, pull) = (stiffness * stretch, wrench(&departure.pull, &arm));
            state.energy += 0.5 * tension * stretch;
            state.missing += tension * pull;
            state.forces += tension;
            state.stiffness += *stiffness * pull * pull.transpose();
            state.stiffness += tension * self.bend(cable, &departure, &attachment, &arm);
        }
        Some(state)
    }

    /// Second derivative of the length of a cable with respect to the pose of the platform.
    fn bend(&self, cable: &Cable, departure: &Departure, attachment: &Point, arm: &Vector) -> Matrix6<f64> {
        let hessian = match &cable.pulley {
            None => (Matrix3::identity() - departure.pull * departure.pull.transpose()) / departure.free,
            Some(pulley) => pulley.hessian(&cable.outlet, attachment),
        };
        let across = -arm.cross_matrix();
        let mut bend = rotated(&-departure.pull, arm);
        bend.fixed_view_mut::<3, 3>(0, 0).copy_from(&hessian);
        bend.fixed_view_mut::<3, 3>(0, 3).copy_from(&(hessian * across));
        bend.fixed_view_mut::<3, 3>(3, 0).copy_from(&(across.transpose() * hessian));
        let turned = bend.fixed_view::<3, 3>(3, 3) + across.transpose() * hessian * across;
        bend.fixed_view_mut::<3, 3>(3, 3).copy_from(&turned);
        bend
    }
}

/// The wrench of a force at the end of an arm.
fn wrench(force: &Vector, arm: &Vector) -> Vector6<f64> {
    let moment = arm.cross(force);
    Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}

/// Second derivative of gradient · end of an arm with respect to a turn of the arm.
fn rotated(gradient: &Vector, arm: &Vector) -> Matrix6<f64> {
    let both = gradient * arm.transpose();
    let mut hessian = Matrix6::zeros();
    let turn = 0.5 * (both + both.transpose()) - Matrix3::from_diagonal_element(gradient.dot(arm));
    hessian.fixed_view_mut::<3, 3>(3, 3).copy_from(&turn);
    hessian
}

#[cfg(test)]
mod tests {
    use nalgebra::Unit;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::model::spec::{DrumSpec, PulleySpec};
    use crate::model::{BodySpec, CableSpec, RobotSpec};
    use crate::testing::empty;

    /// A point on two cables of 5 m and 10 kN, 4 m below their outlets, that comes to rest where they are 5.05 m long.
    fn point_on_two_cables(lead: f64) -> (RobotSpec, f64) {
        let drum = DrumSpec { radius: 0.1, gear: None, zero: None, lead: Some(lead) };
        let cable =
            |x| CableSpec { outlet: [x, 0.0, 4.0], stiffness: Some(1e4), drum: Some(drum), ..CableSpec::default() };
        let height = (5.05f64 * 5.05 - 9.0).sqrt();
        let tension = 1e4 * 0.05 / (5.0 + lead);
        let spec = RobotSpec {
            mass: Some(2.0 * tension * height / 5.05 / 9.81),
            platform: vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }],
            cables: vec![cable(-3.0), cable(3.0)],
            ..RobotSpec::default()
        };
        (spec, height - 4.0)
    }

    fn settling(spec: RobotSpec, at: [f64; 3]) -> Option<Settling> {
        Settling::of(&Robot::try_from(spec).unwrap(), &Loads::default(), &Pose::new(at.into(), Rotation::identity()))
    }

    #[test]
    fn a_point_on_two_cables_settles_as_worked_by_hand() {
        for lead in [0.0, 2.5] {
            let (spec, expected) = point_on_two_cables(lead);
            let found = settling(spec, [0.0; 3]).unwrap();
            assert!((found.displacement - expected).abs() < 1e-9 && found.rotation == 0.0, "{found:?} {expected}");
        }
    }

    #[test]
    fn nothing_is_said_without_mass_stiffness_or_a_cable_that_reaches() {
        let changed = |change: fn(&mut RobotSpec), at: [f64; 3]| {
            let (mut spec, _) = point_on_two_cables(0.0);
            change(&mut spec);
            settling(spec, at)
        };
        assert!(changed(|_| {}, [0.0; 3]).is_some());
        assert_eq!(changed(|spec| spec.mass = None, [0.0; 3]), None);
        assert_eq!(changed(|spec| spec.cables[1].stiffness = None, [0.0; 3]), None);
        assert_eq!(changed(|_| {}, [3.0, 0.0, 4.0]), None);
        let hidden = |spec: &mut RobotSpec| {
            spec.cables[0].pulley = Some(PulleySpec { radius: 2.0, axis: [0.0, 0.0, 1.0] });
        };
        assert_eq!(changed(hidden, [0.0, 0.0, 0.0]), None);
    }

    #[test]
    fn missing_wrench_and_stiffness_are_derivatives_of_the_energy() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let mut any = |size: f64| Vector::from_fn(|_, _| rng.random_range(-size..size));
        for k in 0..40 {
            let mut spec = empty().robot().spec().clone();
            spec.center_of_mass = Some(any(0.1).into());
            for cable in &mut spec.cables {
                let axis = if cable.outlet[2] > 1.0 { 1.0 } else { -1.0 };
                let radius = 0.02 + any(0.01).x;
                cable.stiffness = Some(1e5);
                cable.pulley = (k % 2 == 1).then_some(PulleySpec { radius, axis: [0.0, 0.0, axis] });
            }
            let robot = Robot::try_from(spec).unwrap();
            let mut loads = Loads::default();
            loads.load.fixed_rows_mut::<3>(0).copy_from(&any(50.0));
            let turn = |by: Vector| Rotation::from_axis_angle(&Unit::new_normalize(by), by.norm());
            let commanded = Pose::new(Point::new(1.0, 1.0, 1.0), turn(any(0.1)));
            let elastic = Elastic::of(&robot, &loads, &commanded).unwrap();
            let pose = Pose::new(commanded.position + any(0.01), turn(any(0.01)) * commanded.orientation);
            let here = elastic.at(&pose).unwrap();
            for i in 0..6 {
                let near = |by: f64| {
                    let step = by * Vector6::ith(i, 1.0);
                    let turned = Rotation::from_scaled_axis(step.fixed_rows::<3>(3).into_owned()) * pose.orientation;
                    let state = elastic.at(&Pose::new(pose.position + step.fixed_rows::<3>(0), turned)).unwrap();
                    (state.energy - loads.load.dot(&step), state.missing)
                };
                let ((low, before), (high, after)) = (near(-1e-6), near(1e-6));
                let slope = (low - high) / 2e-6;
                assert!(
                    (here.missing[i] - slope).abs() < 1e-3 * (1.0 + slope.abs()),
                    "{k} {i} {slope} {}",
                    here.missing
                );
                // A turn by a small vector and then by another is not a turn by their sum, so the change of the moment differs from
                // the symmetric Hessian by half the moment itself.
                let change = (before - after) / 2e-6;
                let mut expected: Vector6<f64> = here.stiffness.column(i).into_owned();
                if i >= 3 {
                    let moment = here.missing.fixed_rows::<3>(3).into_owned();
                    let half = 0.5 * Vector::ith(i - 3, 1.0).cross(&moment);
                    let mut turned = expected.fixed_rows_mut::<3>(3);
                    turned -= half;
                }
                let error = (change - expected).norm();
                assert!(error < 1e-4 * here.stiffness.norm(), "{k} {i} {change} {expected}");
            }
        }
    }
}
