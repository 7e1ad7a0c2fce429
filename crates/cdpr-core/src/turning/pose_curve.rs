//! Curves of poses, as far as bounds on pieces of them need to know them.

use crate::geometry::{Pose, PoseMotion};

/// Bounds of derivatives on a piece of a curve of poses, with respect to a time that runs from 0 to 1 along the piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derivatives {
    /// The second derivative of the platform's origin, m.
    pub position: f64,
    /// The first and second derivative of a unit vector of the platform.
    pub turned: [f64; 2],
}

/// A curve of poses with bounded derivatives.
pub trait PoseCurve {
    /// The pose at a share of the curve, 0 to 1.
    fn pose_at(&self, share: f64) -> Pose;

    /// Bounds on every piece that is this share of the curve.
    fn derivatives(&self, share: f64) -> Derivatives;
}

impl PoseCurve for PoseMotion {
    fn pose_at(&self, share: f64) -> Pose {
        self.at(share)
    }

    fn derivatives(&self, share: f64) -> Derivatives {
        let angle = self.angle * share;
        Derivatives { position: 0.0, turned: [angle, angle * angle] }
    }
}
