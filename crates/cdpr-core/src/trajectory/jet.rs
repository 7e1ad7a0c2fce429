//! A position on a curve, with the orientation of the platform there, and its derivatives.

use crate::geometry::{Point, Rotation, Vector};

/// A position on a curve and its derivatives with respect to the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// Position of the platform's origin, m.
    pub position: Point,
    /// Orientation of the platform.
    pub orientation: Rotation,
    /// First derivative; its norm is 1 on lines on which the platform does not turn.
    pub first: Vector,
    /// Second derivative, 1/m.
    pub second: Vector,
    /// Third derivative, 1/m².
    pub third: Vector,
    /// Derivative of the orientation: the axis of the turn, world axes, times its angle per parameter, rad/m.
    pub spin: Vector,
    /// Derivative of `spin` with respect to the parameter, rad/m²; zero on lines.
    pub spin_change: Vector,
}

impl Jet {
    /// First and second derivative of a point of the platform at `arm` from its origin, world axes.
    pub fn of_point(&self, arm: &Vector) -> [Vector; 2] {
        let turning = self.spin.cross(arm);
        [self.first + turning, self.second + self.spin.cross(&turning) + self.spin_change.cross(arm)]
    }
}
