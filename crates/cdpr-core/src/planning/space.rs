//! The space a planner searches: what a state is, how far two are apart, how to draw one.

use rand::{Rng, RngExt};

use crate::collision::Conditions;
use crate::geometry::{Point, Vector};
use crate::numerics::FLAT;

/// States, straight lines between them, and their length.
pub trait StateSpace: Sync {
    /// Where the robot can be.
    type State: Copy + PartialEq + std::fmt::Debug + Send + Sync;

    /// A state drawn uniformly, or none if the space is empty.
    fn sample(&self, rng: &mut impl Rng) -> Option<Self::State>;

    /// A state drawn uniformly from those over which a way between two states can be shorter than `length`, m; none if
    /// the draw fell outside of the space.
    fn sample_between(
        &self,
        from: &Self::State,
        to: &Self::State,
        length: f64,
        rng: &mut impl Rng,
    ) -> Option<Self::State>;

    /// A state at a random distance from another one, all orders of magnitude alike; none if it is outside of the space.
    fn sample_around(&self, state: &Self::State, rng: &mut impl Rng) -> Option<Self::State>;

    /// Length of the straight line between two states.
    fn distance(&self, a: &Self::State, b: &Self::State) -> f64;

    /// The largest distance between two states, m; 0 where the space is empty.
    fn largest_distance(&self) -> f64;

    /// The state at fraction `t` of the straight line from `a` to `b`.
    fn interpolate(&self, a: &Self::State, b: &Self::State, t: f64) -> Self::State;

    /// Where a state stands among the others, for finding neighbours: places are never farther apart than their states.
    fn place(&self, state: &Self::State) -> Point;

    /// γ (ln n / n)^(1/d), m, with γ = (2 (1 + 1/d) V/ζ)^(1/d) for d dimensions, the volume V of the space and the volume ζ
    /// of the unit ball: the radius with which S. Karaman and E. Frazzoli (2011) conclude that RRT* tends to the optimum. Their
    /// proof has a gap, closed for the exponent 1/(d + 1) and a larger γ, a larger ball in the end (K. Solovey, L. Janson,
    /// E. Schmerling, E. Frazzoli and M. Pavone, "Revisiting the asymptotic optimality of RRT*", ICRA 2020).
    fn near_radius(&self, nodes: usize) -> f64;
}

/// `Steer(x_rand, x_nearest)` of the paper: the state one step from `from` on the way to `to`, or `to` if that is
/// nearer.
pub fn steer<S: StateSpace>(space: &S, from: &S::State, to: &S::State, step: f64) -> S::State {
    let distance = space.distance(from, to);
    if distance <= step { *to } else { space.interpolate(from, to, step / distance) }
}

/// Positions of the platform's origin at fixed orientation, uniform over those where the platform is inside the
/// workspace.
#[derive(Debug, Clone, PartialEq)]
pub struct TranslationSpace {
    /// Smallest position, m.
    pub min: Point,
    /// Largest position, m.
    pub max: Point,
}

impl TranslationSpace {
    /// The positions that the workspace leaves.
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
    /// RRT*", IROS 2014), or in the space where that is smaller.
    fn sample_between(&self, from: &Point, to: &Point, length: f64, rng: &mut impl Rng) -> Option<Point> {
        let straight = (to - from).norm();
        let across = 0.5 * (length * length - straight * straight).max(0.0).sqrt();
        // Across a flat axis the ellipsoid is as wide as anything drawn from it before it is put back into the space.
        let size = self.size();
        let size = Vector::from_fn(|axis, _| if self.is_flat(axis) { 2.0 * across } else { size[axis] });
        if !(4.0 / 3.0 * std::f64::consts::PI * 0.5 * length * across * across < size.product()) {
            return self.sample(rng);
        }
        let along = (to - from) / straight.max(f64::MIN_POSITIVE);
        let unit = in_unit_ball(rng);
        // Stretched along the straight line, and by as much as the ball's other two axes everywhere else.
        let lengthwise = along.dot(&unit);
        let offset = unit * across + along * (lengthwise * (0.5 * length - across));
        self.inside(nalgebra::center(from, to) + offset)
    }

    fn sample_around(&self, state: &Point, rng: &mut impl Rng) -> Option<Point> {
        let farthest = (self.max - self.min).norm();
        let distance = farthest * NEAREST_SHARE.powf(rng.random::<f64>());
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

/// The nearest that [`StateSpace::sample_around`] draws, as a share of the size of the space.
const NEAREST_SHARE: f64 = 1e-3;

impl TranslationSpace {
    fn size(&self) -> Vector {
        self.max - self.min
    }

    /// Whether there is no room to speak of along an axis: the platform is as high as the workspace.
    fn is_flat(&self, axis: usize) -> bool {
        self.max[axis] - self.min[axis] <= FLAT
    }

    /// A drawn position, if it is in the space; put back into it along flat axes, which a draw never hits.
    fn inside(&self, mut position: Point) -> Option<Point> {
        for axis in (0..3).filter(|&axis| self.is_flat(axis)) {
            position[axis] = position[axis].max(self.min[axis]).min(self.max[axis]);
        }
        (0..3).all(|axis| self.min[axis] <= position[axis] && position[axis] <= self.max[axis]).then_some(position)
    }
}

/// Uniform in the unit ball.
fn in_unit_ball(rng: &mut impl Rng) -> Vector {
    loop {
        let [x, y, z]: [f64; 3] = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
        let point = Vector::new(x, y, z);
        if point.norm_squared() <= 1.0 {
            return point;
        }
    }
}

/// From where to where.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem<S: StateSpace> {
    /// The space of states.
    pub space: S,
    /// Start.
    pub start: S::State,
    /// Goal.
    pub goal: S::State,
}
