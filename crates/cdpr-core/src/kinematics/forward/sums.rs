//! Sums of least squares at a pose, and the steps that follow from them.

use nalgebra::{Matrix6, SymmetricEigen, U6, Vector6};

use crate::tolerances::{POSE_GAIN_RELATIVE, POSE_GRADIENT, POSE_RANK_RELATIVE, POSE_STEP, SAME_FIT};

/// Smallest damping: the matrix stays invertible where the Jacobian is singular.
pub const LEAST_DAMPING: f64 = 1e-13;

/// What a step of least squares needs, at a pose.
#[derive(Clone, Copy)]
pub struct Sums {
    /// Sum of the squares of the residuals, m².
    pub squares: f64,
    /// Jᵀ times the residuals.
    pub right: Vector6<f64>,
    /// JᵀJ.
    pub matrix: Matrix6<f64>,
}

impl Sums {
    /// Whether the residuals are zero or at right angles to the columns of the Jacobian.
    pub fn is_balanced(&self, lengths: usize) -> bool {
        self.squares <= lengths as f64 * SAME_FIT * SAME_FIT
            || self.right.norm() <= POSE_GRADIENT * (self.matrix.trace() * self.squares).sqrt()
    }

    /// Whether the step without damping is short enough: at a nearly singular pose, damping alone makes steps short.
    pub fn is_settled(&self) -> bool {
        self.step(LEAST_DAMPING).is_some_and(|step| step.norm() <= POSE_STEP)
    }

    /// The damping, given as a share of the mean square of the columns, as it is added to the matrix.
    pub fn added(&self, damping: f64) -> f64 {
        damping * self.matrix.trace() / 6.0
    }

    /// The step with this damping.
    pub fn step(&self, damping: f64) -> Option<Vector6<f64>> {
        let damped = self.matrix + Matrix6::from_diagonal_element(self.added(damping));
        Some(damped.cholesky()?.solve(&self.right))
    }

    /// What a step gained, as a share of what it would gain if lengths were linear: of the sum of squares or, where that is lost
    /// in its rounding, of its gradient.
    pub fn gain(&self, there: &Sums, step: &Vector6<f64>, damping: f64) -> f64 {
        let left = self.added(damping) * step;
        let expected = step.dot(&(self.right + left));
        if expected > POSE_GAIN_RELATIVE * self.squares {
            return (self.squares - there.squares) / expected;
        }
        let before = self.right.norm();
        (before - there.right.norm()) / (before - left.norm()).max(f64::MIN_POSITIVE)
    }
}

/// Eigenvalues of JᵀJ, the squares of the singular values of J, count as zero below.
pub fn least_eigenvalue(axes: &SymmetricEigen<f64, U6>) -> f64 {
    POSE_RANK_RELATIVE * POSE_RANK_RELATIVE * axes.eigenvalues.max()
}

/// How the damping changes after a step that gained this share of what it would gain if lengths were linear.
pub fn damping_change(gain: f64) -> f64 {
    match gain {
        gain if gain > 0.9 => 0.01,
        gain if gain > 0.5 => 0.3,
        gain if gain > 0.1 => 1.0,
        _ => 5.0,
    }
}
