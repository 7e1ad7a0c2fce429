//! The motion of the platform at an instant, and bounds of its derivatives during some time.
//!
//! With q(s) the curve and s(t) the progress on it, the derivatives of q(s(t)) follow from those of both (Faà di Bruno's
//! formula). Where the platform turns on a line, its axis is fixed and its angle proportional to s: a vector of the platform at
//! distance ρ from the axis has derivatives with respect to s of the norms σρ, σ²ρ, σ³ρ, …, with σ the angle per s. On a bend, the
//! bounds of [`TurningBend`](super::turning_bend::TurningBend) take their place. An attachment moves as the platform's origin and such
//! a vector together.

use super::curve::{Curve, Piece};
use super::timing::{Phase, Timing};
use super::turning_bend::TurnBounds;
use crate::geometry::{Point, Rotation, Vector};

/// Position, velocity, acceleration and jerk of the platform's origin at an instant, and how the platform turns about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Position, m.
    pub position: Point,
    /// World-from-platform rotation.
    pub orientation: Rotation,
    /// Velocity, m/s.
    pub velocity: Vector,
    /// Acceleration, m/s².
    pub acceleration: Vector,
    /// Jerk, m/s³.
    pub jerk: Vector,
    /// Angular velocity, world axes, rad/s.
    pub angular_velocity: Vector,
    /// Angular acceleration, world axes, rad/s².
    pub angular_acceleration: Vector,
}

impl Motion {
    /// The motion at an instant, s; before the start and after the end, at rest there. At a stop, rates never combine
    /// the progress before it with the curve after it.
    pub fn at(curve: &Curve, timing: &Timing, time: f64) -> Self {
        let [start, now] = timing.phase_at(time);
        Self::on(curve, curve.piece_reached(start.s, now.s), &now)
    }

    /// The motion at a state of progress on a piece of a curve.
    pub fn on(curve: &Curve, piece: usize, phase: &Phase) -> Self {
        let jet = curve.on_piece(piece, phase.s);
        let Phase { speed, acceleration, jerk, .. } = *phase;
        Motion {
            position: jet.position,
            orientation: jet.orientation,
            velocity: jet.first * speed,
            acceleration: jet.first * acceleration + jet.second * speed.powi(2),
            jerk: jet.first * jerk + jet.second * (3.0 * speed * acceleration) + jet.third * speed.powi(3),
            angular_velocity: jet.spin * speed,
            angular_acceleration: jet.spin * acceleration + jet.spin_change * speed.powi(2),
        }
    }

    /// Velocity and acceleration of a point of the platform at `arm` from its origin, world axes, m/s and m/s².
    pub fn of_point(&self, arm: &Vector) -> [Vector; 2] {
        if self.angular_velocity == Vector::zeros() && self.angular_acceleration == Vector::zeros() {
            return [self.velocity, self.acceleration]; // to the sign of a zero
        }
        let turning = self.angular_velocity.cross(arm);
        let bending = self.angular_acceleration.cross(arm) + self.angular_velocity.cross(&turning);
        [self.velocity + turning, self.acceleration + bending]
    }
}

/// Bounds of the norms of the first five time derivatives of a vector.
pub type Derivatives = [f64; 5];

/// Upper bounds of the norms of derivatives while the motion stays on one piece of the curve and in one phase of its
/// progress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rates {
    /// Bounds for the position of the platform's origin.
    pub origin: Derivatives,
    /// Bounds for the first three time derivatives of the progress.
    progress: [f64; 3],
    turn: Turn,
}

/// How the platform turns on a piece of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Turn {
    Held,
    /// The platform turns about a unit axis, world, by an angle per parameter, rad/m.
    Steady {
        axis: Vector,
        spin: f64,
    },
    Bend(TurnBounds),
}

impl Turn {
    fn on(piece: &Piece) -> Self {
        match piece.turning() {
            Some(bend) => Turn::Bend(*bend.bounds()),
            None if piece.turns() => Turn::Steady { axis: *piece.attitude().axis(), spin: piece.spin() },
            None => Turn::Held,
        }
    }
}

impl Rates {
    /// The bounds during `time` s between two states of progress on a piece.
    pub fn new(piece: &Piece, start: &Phase, end: &Phase, time: f64) -> Self {
        let s3 = start.jerk.abs();
        let s2 = start.acceleration.abs().max(end.acceleration.abs());
        let s1 = start.speed.abs().max(end.speed.abs()) + time * time / 8.0 * s3;
        let progress = [s1, s2, s3];
        let origin = derivatives(&piece.derivative_bounds, progress);
        Rates { origin, progress, turn: Turn::on(piece) }
    }

    /// Unit axis of the turn, world axes, if it does not change.
    pub fn axis(&self) -> Option<&Vector> {
        match &self.turn {
            Turn::Steady { axis, .. } => Some(axis),
            Turn::Held | Turn::Bend(_) => None,
        }
    }

    /// Whether the platform turns on the piece.
    pub fn turns(&self) -> bool {
        self.turn != Turn::Held
    }

    /// Bounds for the angular velocity and its first three time derivatives, rad/s to rad/s⁴.
    pub fn turn(&self) -> [f64; 4] {
        let rate = match &self.turn {
            Turn::Held => return [0.0; 4],
            Turn::Steady { spin, .. } => [*spin, 0.0, 0.0, 0.0, 0.0],
            Turn::Bend(bounds) => bounds.rate,
        };
        // The angular velocity is Ω ṡ, with the angular rate Ω per parameter, as the velocity is q′ ṡ.
        let [speed, acceleration, jerk, snap, _] = derivatives(&rate, self.progress);
        [speed, acceleration, jerk, snap]
    }

    /// Bounds for any unit vector fixed in the platform.
    pub fn unit(&self) -> Derivatives {
        let by_parameter = match &self.turn {
            Turn::Held => return [0.0; 5],
            Turn::Steady { spin, .. } => [1, 2, 3, 4, 5].map(|k| spin.powi(k)),
            Turn::Bend(bounds) => bounds.vector,
        };
        derivatives(&by_parameter, self.progress)
    }

    /// Bounds for a vector fixed in the platform, world axes; zero if the platform does not turn.
    pub fn turned(&self, arm: &Vector) -> Derivatives {
        let Turn::Steady { axis, spin } = &self.turn else {
            let reach = arm.norm();
            return self.unit().map(|rate| rate * reach);
        };
        let reach = arm.cross(axis).norm();
        let mut by_parameter = [spin * reach; 5];
        (1..5).for_each(|k| by_parameter[k] = by_parameter[k - 1] * spin);
        derivatives(&by_parameter, self.progress)
    }

    /// Bounds for a point of the platform at `arm` from its origin, world axes.
    pub fn of_point(&self, arm: &Vector) -> Derivatives {
        if !self.turns() {
            return self.origin;
        }
        let turned = self.turned(arm);
        std::array::from_fn(|k| self.origin[k] + turned[k])
    }
}

/// Bounds of the norms of the first five derivatives of q(s(t)) from those of q and of s.
fn derivatives([d1, d2, d3, d4, d5]: &[f64; 5], [s1, s2, s3]: [f64; 3]) -> Derivatives {
    [
        d1 * s1,
        d1 * s2 + d2 * s1.powi(2),
        d1 * s3 + 3.0 * d2 * s1 * s2 + d3 * s1.powi(3),
        4.0 * d2 * s1 * s3 + 3.0 * d2 * s2.powi(2) + 6.0 * d3 * s1.powi(2) * s2 + d4 * s1.powi(4),
        10.0 * d2 * s2 * s3
            + 10.0 * d3 * s1.powi(2) * s3
            + 15.0 * d3 * s1 * s2.powi(2)
            + 10.0 * d4 * s1.powi(3) * s2
            + d5 * s1.powi(5),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trajectory::attitude::Attitude;

    /// Coefficients of differences that give the first three derivatives, with their distances in steps.
    const FIRST: [(f64, f64); 2] = [(-1.0, -0.5), (1.0, 0.5)];

    #[test]
    fn attachment_derivatives_match_differences_and_bounds() {
        let [from, to] = [Vector::new(0.1, 0.2, -0.4), Vector::new(-0.7, 0.5, 0.9)].map(Rotation::from_scaled_axis);
        let turn = Attitude::between(from, to);
        let ends = [Point::new(0.2, 0.3, 0.4), Point::new(0.7, -0.1, 0.5)];
        let curve = Curve::new(vec![Piece::turning_line(ends, turn, 1.3)]);
        let start = Phase { time: 0.0, s: 0.1, speed: 0.4, acceleration: 0.3, jerk: -0.8 };
        let arm = Vector::new(0.3, -0.2, 0.1); // platform axes
        let place = |t: f64| {
            let motion = Motion::on(&curve, 0, &start.after(t));
            (motion.position + motion.orientation * arm, motion)
        };
        let rates = Rates::new(&curve.pieces()[0], &start, &start.after(1.0), 1.0);
        let h = 1e-4;
        for t in [0.1, 0.4, 0.9] {
            let (_, motion) = place(t);
            let world = motion.orientation * arm;
            let [velocity, acceleration] = motion.of_point(&world);
            let difference = |of: &dyn Fn(f64) -> Vector| -> Vector {
                FIRST.iter().map(|(weight, at)| of(t + at * h) * (*weight / h)).sum()
            };
            assert!((difference(&|t| place(t).0.coords) - velocity).norm() < 1e-7);
            let velocity_at = |t: f64| {
                let (_, motion) = place(t);
                motion.of_point(&(motion.orientation * arm))[0]
            };
            assert!((difference(&velocity_at) - acceleration).norm() < 1e-7);
            assert!((difference(&|t| place(t).1.angular_velocity) - motion.angular_acceleration).norm() < 1e-7);
            let acceleration_at = |t: f64| {
                let (_, motion) = place(t);
                motion.of_point(&(motion.orientation * arm))[1]
            };
            let third = difference(&acceleration_at);
            let fourth = (acceleration_at(t + h) - acceleration_at(t) * 2.0 + acceleration_at(t - h)) / (h * h);
            let bounds = rates.of_point(&world);
            let norms = [velocity.norm(), acceleration.norm(), third.norm(), fourth.norm()];
            assert!(
                norms.iter().zip(bounds).all(|(norm, bound)| *norm <= bound * (1.0 + 1e-5)),
                "{norms:?} {bounds:?}"
            );
            assert!(motion.angular_velocity.norm() <= rates.turn()[0]);
        }
    }
}
