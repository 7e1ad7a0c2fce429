//! The space that a planner searches: its states, their distances, and how to sample them.

use rand::{Rng, RngExt};

use crate::collision::Conditions;
use crate::geometry::{Point, Vector};
use crate::tolerances::FLAT;

/// States, the straight motions between them, and their length.
pub trait StateSpace: Sync {
    /// A configuration of the robot.
    type State: Copy + PartialEq + std::fmt::Debug + Send + Sync;

    /// A uniform random state; `None` if the space is empty.
    fn sample(&self, rng: &mut impl Rng) -> Option<Self::State>;

    /// A uniform random state among those through which a path between two states can be shorter than `length`, m;
    /// `None` if the draw fell outside the space.
    fn sample_between(
        &self,
        from: &Self::State,
        to: &Self::State,
        length: f64,
        rng: &mut impl Rng,
    ) -> Option<Self::State>;

    /// A state at a random distance from another one, log-uniform over all scales; `None` if it is outside the space.
    fn sample_around(&self, state: &Self::State, rng: &mut impl Rng) -> Option<Self::State>;

    /// Length of the straight motion between two states.
    fn distance(&self, a: &Self::State, b: &Self::State) -> f64;

    /// Length of a path of straight motions, m; infinite for an empty path, which leads nowhere.
    fn length(&self, path: &[Self::State]) -> f64 {
        let length = path.windows(2).map(|pair| self.distance(&pair[0], &pair[1])).sum();
        if path.is_empty() { f64::INFINITY } else { length }
    }

    /// The largest distance between two states, m; 0 where the space is empty.
    fn largest_distance(&self) -> f64;

    /// The state at fraction `t` of the straight motion from `a` to `b`.
    fn interpolate(&self, a: &Self::State, b: &Self::State, t: f64) -> Self::State;

    /// The point of a state in the neighbour index: points are never farther apart than their states.
    fn place(&self, state: &Self::State) -> Point;

    /// γ (ln n / n)^(1/d), m, with γ = (2 (1 + 1/d) V/ζ)^(1/d) for d dimensions, the volume V of the space and the
    /// volume ζ of the unit ball. S. Karaman and E. Frazzoli (2011) use this radius in their proof that RRT* is
    /// asymptotically optimal. The proof has a gap; K. Solovey, L. Janson, E. Schmerling, E. Frazzoli and M. Pavone
    /// ("Revisiting the asymptotic optimality of RRT*", ICRA 2020) prove the result for the exponent 1/(d + 1) and a
    /// larger γ, which is a larger radius for large n.
    fn near_radius(&self, nodes: usize) -> f64;
}

/// `Steer(x_rand, x_nearest)` of the paper: the state one step from `from` towards `to`, or `to` if it is within one
/// step.
pub fn steer<S: StateSpace>(space: &S, from: &S::State, to: &S::State, step: f64) -> S::State {
    let distance = space.distance(from, to);
    if distance <= step { *to } else { space.interpolate(from, to, step / distance) }
}

/// Positions of the platform's origin at fixed orientation; uniform over the positions at which the platform is inside
/// the workspace.
#[derive(Debug, Clone, PartialEq)]
pub struct TranslationSpace {
    /// Smallest coordinates of a position, m.
    pub min: Point,
    /// Largest coordinates of a position, m.
    pub max: Point,
}

impl TranslationSpace {
    /// The positions at which the platform is inside the workspace.
    pub fn of(conditions: &Conditions) -> Self {
        let (min, max) = conditions.position_box();
        TranslationSpace { min, max }
    }
}

impl StateSpace for TranslationSpace {
    type State = Point;

    fn sample(&self, rng: &mut impl Rng) -> Option<Point> {
        let size = self.size();
        let [x, y, z]: [f64; 3] = std::array::from_fn(|_| rng.random());
        (size.min() >= 0.0).then(|| self.min + size.component_mul(&Vector::new(x, y, z)))
    }

    /// Uniform in the ellipsoid with both positions as foci (J. D. Gammell, S. S. Srinivasa, T. D. Barfoot, "Informed
    /// RRT*", IROS 2014), or in the whole space if that is smaller.
    fn sample_between(&self, from: &Point, to: &Point, length: f64, rng: &mut impl Rng) -> Option<Point> {
        let straight = (to - from).norm();
        let across = 0.5 * (length * length - straight * straight).max(0.0).sqrt();
        // Along a flat axis compare with the ellipsoid's own width: draws are clamped into the space along it.
        let size = self.size();
        let size = Vector::from_fn(|axis, _| if self.is_flat(axis) { 2.0 * across } else { size[axis] });
        if !(4.0 / 3.0 * std::f64::consts::PI * 0.5 * length * across * across < size.product()) {
            return self.sample(rng);
        }
        let along = (to - from) / straight.max(f64::MIN_POSITIVE);
        let unit = in_unit_ball(rng);
        // Scale the unit ball: by the half length along the straight line, by `across` in the other two directions.
        let lengthwise = along.dot(&unit);
        let offset = unit * across + along * (lengthwise * (0.5 * length - across));
        self.inside(nalgebra::center(from, to) + offset)
    }

    fn sample_around(&self, state: &Point, rng: &mut impl Rng) -> Option<Point> {
        let farthest = (self.max - self.min).norm();
        let distance = farthest * libm::pow(NEAREST_SHARE, rng.random::<f64>());
        let direction = in_unit_ball(rng).try_normalize(f64::MIN_POSITIVE)?;
        self.inside(state + direction * distance)
    }

    fn distance(&self, a: &Point, b: &Point) -> f64 {
        (b - a).norm()
    }

    fn largest_distance(&self) -> f64 {
        self.size().map(|side| side.max(0.0)).norm()
    }

    fn interpolate(&self, a: &Point, b: &Point, t: f64) -> Point {
        a + (b - a) * t
    }

    fn place(&self, state: &Point) -> Point {
        *state
    }

    fn near_radius(&self, nodes: usize) -> f64 {
        let crowd = (nodes as f64).ln() / nodes as f64;
        let wide: Vec<f64> = (0..3).filter(|&axis| !self.is_flat(axis)).map(|axis| self.size()[axis]).collect();
        let volume: f64 = wide.iter().product();
        let pi = std::f64::consts::PI;
        match wide.len() {
            0 => 0.0,
            1 => 4.0 * volume / 2.0 * crowd,
            2 => (3.0 * volume / pi).sqrt() * crowd.sqrt(),
            _ => (8.0 / 3.0 * volume / (4.0 / 3.0 * pi)).cbrt() * crowd.cbrt(),
        }
    }
}

/// The smallest distance that [`StateSpace::sample_around`] draws, as a share of the size of the space.
const NEAREST_SHARE: f64 = 1e-3;

impl TranslationSpace {
    fn size(&self) -> Vector {
        self.max - self.min
    }

    /// Whether the space is practically flat along an axis: the platform is as high as the workspace, for example.
    fn is_flat(&self, axis: usize) -> bool {
        self.max[axis] - self.min[axis] <= FLAT
    }

    /// A drawn position if it is in the space; along flat axes, which a draw never hits exactly, it is clamped into the
    /// space.
    fn inside(&self, mut position: Point) -> Option<Point> {
        for axis in (0..3).filter(|&axis| self.is_flat(axis)) {
            position[axis] = position[axis].max(self.min[axis]).min(self.max[axis]);
        }
        (0..3).all(|axis| self.min[axis] <= position[axis] && position[axis] <= self.max[axis]).then_some(position)
    }
}

/// A uniform random point in the unit ball.
fn in_unit_ball(rng: &mut impl Rng) -> Vector {
    loop {
        let [x, y, z]: [f64; 3] = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
        let point = Vector::new(x, y, z);
        if point.norm_squared() <= 1.0 {
            return point;
        }
    }
}

/// A planning problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem<S: StateSpace> {
    /// The space of states.
    pub space: S,
    /// Start of the path.
    pub start: S::State,
    /// Goal of the path.
    pub goal: S::State,
}
