//! A limit of tilt: the angle between the vertical and the line of the platform that is vertical at the scene's orientation.

use crate::collision::{Kind, Violation};
use crate::geometry::{Placed, Turning, Vector};
use crate::model::spec::PLATFORM;
use crate::numerics::{SAME_TURN, TURNING_PLACE};

/// The tilt stays within a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilt {
    /// Cosine of the largest tilt.
    cosine: f64,
}

impl Tilt {
    /// The limit of this angle, rad.
    pub fn at_most(angle: f64) -> Self {
        Tilt { cosine: (angle + SAME_TURN).cos() }
    }

    /// Whether a pose keeps it.
    pub fn allows(&self, at: &Placed) -> bool {
        at.turn[(2, 2)] >= self.cosine
    }

    /// Whether a motion keeps it, in closed form.
    pub fn keeps(&self, motion: &Turning) -> bool {
        motion.least_along(&Vector::z()) >= self.cosine
    }

    /// The violation of a motion that does not keep it.
    pub fn violation(&self, motion: &Turning) -> Option<Violation> {
        let places = (1.0 / TURNING_PLACE) as usize;
        let at = (0..=places).map(|k| k as f64 * TURNING_PLACE).find(|t| !self.allows(&motion.at(*t)));
        (!self.keeps(motion)).then(|| Violation {
            at: at.unwrap_or(0.5),
            kind: Kind::Tilt,
            culprits: vec![PLATFORM.to_string()],
            gap: None,
            required: None,
            margin: None,
            unproved: false,
            wrench: None,
        })
    }
}
