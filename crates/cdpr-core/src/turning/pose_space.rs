//! The poses that a planner searches.

use std::f64::consts::PI;

use rand::{Rng, RngExt};

use crate::error::Error;
use crate::geometry::{Point, Pose, Rotation, Vector, turn_about};
use crate::model::Scene;
use crate::model::spec::TurningAxis;
use crate::planning::{StateSpace, TranslationSpace};
use crate::tolerances::{NO_TURN, OFF_AXIS};

/// The orientations of a space.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Freedom {
    /// Orientations that tilt the platform by at most this angle, rad, from the scene's orientation.
    Tilt(f64),
    /// Orientations reached by turns from the start about this unit axis, world.
    Axis(Vector),
}

/// Poses of the platform. Lengths are those of the translation plus the weight times the angle of the turn.
///
/// # Example
/// ```
/// use cdpr_core::{Pose, Rotation, Vector};
/// use cdpr_core::planning::StateSpace;
/// use cdpr_core::turning::PoseSpace;
/// let scene = cdpr_core::testing::hard1();
/// let [start, goal] = [scene.start().unwrap(), scene.goal().unwrap()];
/// let from = Pose::new(start, Rotation::identity());
/// let to = Pose::new(goal, Rotation::from_scaled_axis(Vector::z() * 0.5));
/// let space = PoseSpace::of(&scene, [&from, &to])?;
/// assert!((space.distance(&from, &to) - ((goal - start).norm() + space.weight() * 0.5)).abs() < 1e-12);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PoseSpace {
    positions: TranslationSpace,
    freedom: Freedom,
    /// The orientation from which turns are measured.
    reference: Rotation,
    weight: f64,
}

impl PoseSpace {
    /// The space for a path between two poses in a scene, as its `[turning]` table allows.
    ///
    /// # Errors
    /// A fixed axis about which the start cannot be turned to the goal.
    pub fn of(scene: &Scene, [start, goal]: [&Pose; 2]) -> Result<Self, Error> {
        let spec = scene.turning().copied().unwrap_or_default();
        let box_ = scene.workspace();
        let aside =
            Vector::repeat(scene.robot().parts().iter().map(|part| part.centroid().coords.norm()).fold(0.0, f64::max));
        let positions = TranslationSpace { min: box_.min - aside, max: box_.max + aside };
        let weight = turn_weight(scene);
        let (freedom, reference) = match spec.axis {
            Some(TurningAxis::Fixed(axis)) => (Freedom::Axis(Vector::from(axis).normalize()), start.orientation),
            _ => (Freedom::Tilt(spec.max_tilt.map_or(PI, f64::to_radians)), *scene.orientation()),
        };
        if let Freedom::Axis(axis) = freedom {
            let turn = start.toward(goal);
            if turn.axis.cross(&axis).norm() * turn.angle > 2.0 * OFF_AXIS {
                let [x, y, z] = axis.into();
                let problem = format!(
                    "found a goal that the platform cannot reach from its start by turning about ({x}, {y}, {z}); choose other \
                     orientations or axis = \"free\""
                );
                return Err(Error::invalid("turning.axis", problem));
            }
        }
        Ok(PoseSpace { positions, freedom, reference, weight })
    }

    /// Length of a turn by one radian, m.
    pub fn weight(&self) -> f64 {
        self.weight
    }

    fn random_orientation(&self, rng: &mut impl Rng) -> Rotation {
        match self.freedom {
            Freedom::Axis(axis) => turn_about(&axis, rng.random_range(-PI..PI)) * self.reference,
            Freedom::Tilt(most) => {
                let [spin, side, share]: [f64; 3] = std::array::from_fn(|_| rng.random());
                let tilt = libm::acos(1.0 - share * (1.0 - libm::cos(most)));
                let (sine, cosine) = libm::sincos(2.0 * PI * side);
                let tilted = turn_about(&Vector::new(cosine, sine, 0.0), tilt);
                tilted * turn_about(&Vector::z(), 2.0 * PI * spin) * self.reference
            }
        }
    }

    /// An orientation up to this angle, rad, from another one.
    fn orientation_near(&self, orientation: &Rotation, most: f64, rng: &mut impl Rng) -> Rotation {
        let angle = rng.random_range(-1.0..1.0) * most.min(PI);
        let axis = match self.freedom {
            Freedom::Axis(axis) => axis,
            Freedom::Tilt(_) => {
                let [height, side]: [f64; 2] = std::array::from_fn(|_| rng.random());
                let (height, (sine, cosine)) = (2.0 * height - 1.0, libm::sincos(2.0 * PI * side));
                let across = (1.0 - height * height).sqrt();
                Vector::new(across * cosine, across * sine, height)
            }
        };
        turn_about(&axis, angle) * orientation
    }
}

/// Length of a turn by one radian in a scene, m: the weight of its `[turning]` table, or the distance from the platform's
/// origin to its farthest corner.
pub fn turn_weight(scene: &Scene) -> f64 {
    let corners = scene.robot().parts().iter().flat_map(|part| part.vertices());
    let reach = corners.map(|corner| corner.coords.norm()).fold(LEAST_WEIGHT, f64::max);
    scene.turning().and_then(|turning| turning.weight).unwrap_or(reach)
}

/// Length of the motion between two poses, m, if a turn by one radian is as long as `weight`, m.
pub fn pose_distance(weight: f64, a: &Pose, b: &Pose) -> f64 {
    (b.position - a.position).norm() + weight * a.angle_to(b)
}

/// Weight of turns of a platform without extent, m/rad, so that paths have no needless turns.
const LEAST_WEIGHT: f64 = 1e-3;

/// The smallest turn that [`StateSpace::sample_around`] draws, as a share of the largest.
const LEAST_TURN: f64 = 1e-3;

impl StateSpace for PoseSpace {
    type State = Pose;

    fn sample(&self, rng: &mut impl Rng) -> Option<Pose> {
        let position = self.positions.sample(rng)?;
        Some(Pose::new(position, self.random_orientation(rng)))
    }

    /// Positions uniform in the ellipsoid of positions; half of the orientations lie about the straight motion.
    fn sample_between(&self, from: &Pose, to: &Pose, length: f64, rng: &mut impl Rng) -> Option<Pose> {
        let turn = from.toward(to);
        let reach = length - self.weight * turn.angle;
        let position = self.positions.sample_between(&from.position, &to.position, reach, rng)?;
        let way = (position - from.position).norm() + (to.position - position).norm();
        let left = (length - way) / self.weight - turn.angle;
        if left < 0.0 {
            return None;
        }
        let orientation = if rng.random::<bool>() {
            self.orientation_near(&turn.at(rng.random()).orientation, 0.5 * left, rng)
        } else {
            self.random_orientation(rng)
        };
        Some(Pose::new(position, orientation))
    }

    fn sample_around(&self, state: &Pose, rng: &mut impl Rng) -> Option<Pose> {
        let position = self.positions.sample_around(&state.position, rng)?;
        let most = PI * libm::pow(LEAST_TURN, rng.random::<f64>());
        Some(Pose::new(position, self.orientation_near(&state.orientation, most, rng)))
    }

    fn distance(&self, a: &Pose, b: &Pose) -> f64 {
        pose_distance(self.weight, a, b)
    }

    fn largest_distance(&self) -> f64 {
        self.positions.largest_distance() + self.weight * PI
    }

    fn interpolate(&self, a: &Pose, b: &Pose, t: f64) -> Pose {
        a.toward(b).at(t)
    }

    fn place(&self, state: &Pose) -> Point {
        state.position
    }

    fn near_radius(&self, nodes: usize) -> f64 {
        let crowd = libm::log(nodes as f64) / nodes as f64;
        let size = self.positions.max - self.positions.min;
        let places = size.x.max(NO_TURN) * size.y.max(NO_TURN) * size.z.max(NO_TURN);
        // Volumes of the orientations and of the unit ball |Δp| + w |Δα| < 1.
        let (dimensions, turns, ball) = match self.freedom {
            Freedom::Axis(_) => (4.0, 2.0 * PI * self.weight, 2.0 * PI / 3.0),
            Freedom::Tilt(most) => (
                6.0,
                8.0 * PI * PI * self.weight.powi(3) * 0.5 * (1.0 - libm::cos(most)),
                (4.0 * PI / 3.0).powi(2) / 20.0,
            ),
        };
        libm::pow(2.0 * (1.0 + 1.0 / dimensions) * places * turns / ball * crowd, 1.0 / dimensions)
    }
}
