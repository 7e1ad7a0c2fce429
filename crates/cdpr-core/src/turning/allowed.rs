//! The orientations that the table `[turning]` of a scene allows.
//!
//! A limit of tilt bounds how far the line of the platform that is vertical at the scene's orientation may leave the vertical. The
//! orientations that are reached by turns about one axis are those at which the line along this axis stays where it is.

use crate::collision::{Kind, Violation};
use crate::geometry::{Placed, Turning, Vector};
use crate::model::Scene;
use crate::model::spec::{PLATFORM, TurningAxis, TurningSpec};
use crate::tolerances::{OFF_AXIS, SAME_TURN, TURNING_PLACE};

/// A line of the platform stays within an angle of where it points at the scene's orientation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AllowedTurns {
    kind: Kind,
    /// Unit direction of the line, world.
    line: Vector,
    /// Cosine of the largest angle.
    cosine: f64,
}

impl AllowedTurns {
    /// The restrictions in the table of a scene; if there are none, all turns are allowed.
    pub fn of(scene: &Scene) -> Vec<Self> {
        let TurningSpec { axis, max_tilt, .. } = scene.turning().copied().unwrap_or_default();
        let axis = match axis {
            Some(TurningAxis::Fixed(axis)) => {
                Some(Self::within(Kind::TurningAxis, Vector::from(axis).normalize(), 0.0))
            }
            Some(TurningAxis::Free) | None => None,
        };
        let tilt = max_tilt.map(|degrees| Self::within(Kind::Tilt, Vector::z(), degrees.to_radians()));
        axis.into_iter().chain(tilt).collect()
    }

    fn within(kind: Kind, line: Vector, angle: f64) -> Self {
        // The cosine of a small angle is too close to 1 to be distinguished from rounding errors.
        AllowedTurns { kind, line, cosine: (angle + SAME_TURN).max(OFF_AXIS).cos() }
    }

    fn allows(&self, at: &Placed) -> bool {
        self.line.dot(&at.turned(&self.line)) >= self.cosine
    }

    /// Unit direction of the line, world, at the orientation of the scene.
    pub fn line(&self) -> &Vector {
        &self.line
    }

    /// Whether the restriction holds at all poses at which the line is turned at most `by`, rad, farther than at this
    /// pose.
    pub fn keeps_within(&self, at: &Placed, by: f64) -> bool {
        let turned = self.line.dot(&at.turned(&self.line)).clamp(-1.0, 1.0);
        libm::acos(turned) + by <= libm::acos(self.cosine)
    }

    /// Whether a motion keeps the restriction, in closed form.
    pub fn keeps(&self, motion: &Turning) -> bool {
        motion.least_along(&self.line) >= self.cosine
    }

    /// The violation of a motion that does not keep the restriction.
    pub fn violation(&self, motion: &Turning) -> Option<Violation> {
        let places = (1.0 / TURNING_PLACE) as usize;
        let at = (0..=places).map(|k| k as f64 * TURNING_PLACE).find(|t| !self.allows(&motion.at(*t)));
        (!self.keeps(motion)).then(|| Violation {
            at: at.unwrap_or(0.5),
            kind: self.kind,
            culprits: vec![PLATFORM.to_string()],
            gap: None,
            required: None,
            margin: None,
            unproved: false,
            shapes: None,
            wrench: None,
        })
    }
}
