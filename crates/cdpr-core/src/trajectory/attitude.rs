//! The orientation of the platform along a piece of a curve: held, or turned about a fixed axis.

use crate::geometry::{Point, Pose, Rotation, Vector, turn_about};

/// An orientation that is held, or turned about a fixed axis of the world in proportion to the parameter of the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude {
    from: Rotation,
    to: Rotation,
    /// Unit axis of the turn, world axes; arbitrary without a turn.
    axis: Vector,
    /// Angle of the turn, rad, from 0 to π.
    angle: f64,
}

impl Attitude {
    /// An orientation that is held.
    pub fn held(orientation: Rotation) -> Self {
        Attitude { from: orientation, to: orientation, axis: Vector::x(), angle: 0.0 }
    }

    /// The shorter turn between two orientations, as [`Pose::toward`] takes it.
    pub fn between(from: Rotation, to: Rotation) -> Self {
        let turn = Pose::new(Point::origin(), from).toward(&Pose::new(Point::origin(), to));
        Attitude { from, to, axis: turn.axis, angle: turn.angle }
    }

    /// Unit axis of the turn, world axes; arbitrary without a turn.
    pub fn axis(&self) -> &Vector {
        &self.axis
    }

    /// Angle of the turn, rad.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Whether the platform turns.
    pub fn turns(&self) -> bool {
        self.angle > 0.0
    }

    /// The orientations at both ends.
    pub fn ends(&self) -> [Rotation; 2] {
        [self.from, self.to]
    }

    /// The orientation at a fraction of the piece, 0 to 1.
    pub fn at(&self, share: f64) -> Rotation {
        match self.turns() && share > 0.0 {
            false => self.from,
            true if share >= 1.0 => self.to,
            true => turn_about(&self.axis, self.angle * share) * self.from,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_passes_the_orientations_of_the_motion_between_poses() {
        let [from, to] = [Vector::new(0.3, -0.2, 0.9), Vector::new(-1.0, 0.4, 0.2)].map(Rotation::from_scaled_axis);
        let (turn, ends) = (Attitude::between(from, to), [from, to].map(|q| Pose::new(Point::origin(), q)));
        for share in [0.0, 0.1, 0.5, 0.9, 1.0] {
            let expected = ends[0].toward(&ends[1]).at(share).orientation;
            assert_eq!(turn.at(share), expected);
        }
        assert!(turn.turns() && !Attitude::held(from).turns() && !Attitude::between(from, from).turns());
    }
}
