//! Other poses with nearly the same lengths: further minima of the sum of squares.
//!
//! Along a direction in which lengths change little, they mostly reach an extremum nearby, and are nearly the same on both sides of this
//! fold. The sum of squares then has a minimum on each side, and the search may end in the wrong one, with residuals of micrometres. With
//! lengths expanded to second order, the sum is a polynomial of degree four, whose other minimum is a further start.

use nalgebra::{SymmetricEigen, U6, Vector6};

use super::sums::{Sums, least_eigenvalue};
use super::{BEND_STEP, ForwardKinematics, PoseEstimate, mean};
use crate::geometry::{Pose, Vector, turn_about};

/// Number of directions in which minima beyond a fold are looked for: three turns may change the lengths about equally little.
pub(super) const FOLDS: usize = 3;
/// Angle by which further starts are turned, rad.
const FURTHER_TURN: f64 = std::f64::consts::FRAC_PI_2;

impl ForwardKinematics<'_> {
    /// The minima found from starts beyond the folds near a pose.
    pub(super) fn minima_beyond(&self, lengths: &[f64], &pose: &Pose) -> impl Iterator<Item = PoseEstimate> {
        let starts = (0..FOLDS).filter_map(move |k| self.across(lengths, &pose, k));
        starts.filter_map(|start| self.minimised(lengths, &start).ok())
    }

    /// The minima found from starts around a pose, where the search converges.
    pub(super) fn minima_around(&self, lengths: &[f64], around: &Pose) -> impl Iterator<Item = PoseEstimate> {
        let both = |size: f64| (0..6).map(move |k| Vector::ith(k / 2, if k % 2 == 0 { size } else { -size }));
        let moved = both(mean(lengths)).map(|step| Pose::new(around.position + step, around.orientation));
        let turned =
            both(1.0).map(|axis| Pose::new(around.position, turn_about(&axis, FURTHER_TURN) * around.orientation));
        let turned = turned.filter(|_| self.orientation.is_none());
        let starts: Vec<Pose> = moved.chain(turned).collect();
        starts.into_iter().filter_map(|start| self.minimised(lengths, &start).ok())
    }

    /// A start for another minimum, beyond a fold: where the sum of squares is least again along a direction in which lengths change
    /// little, the weakest but `k`, while the other directions compensate what they can. `None` if that is farther away than the cables are long.
    fn across(&self, lengths: &[f64], pose: &Pose, k: usize) -> Option<Pose> {
        let here = self.sums(lengths, pose)?;
        let Fold { axes, weak, stiff, along, linear, slope, straight, square } = self.fold(lengths, pose, &here, k)?;
        // Up to a constant factor, the derivative of the sum of squares is s (linear - 2 straight + 3 slope s + 2 square s²).
        let inner = (9.0 * slope * slope - 8.0 * square * (linear - 2.0 * straight)).max(0.0).sqrt();
        let beyond = -(3.0 * slope + inner.copysign(slope)) / (4.0 * square);
        let left = here.right - beyond * beyond * along;
        let compensated = |k: usize| {
            let axis = axes.eigenvectors.column(k);
            axis * (axis.dot(&left) / axes.eigenvalues[k])
        };
        let step = beyond * axes.eigenvectors.column(weak) + stiff.into_iter().map(compensated).sum::<Vector6<f64>>();
        (step.norm() <= mean(lengths)).then(|| self.moved(pose, &step))
    }

    /// Lengths to second order along a direction in which they change little, the weakest but `k`.
    fn fold(&self, lengths: &[f64], pose: &Pose, here: &Sums, k: usize) -> Option<Fold> {
        let axes = here.matrix.symmetric_eigen();
        let mut order = vec![0, 1, 2, 3, 4, 5];
        order.sort_by(|i, j| axes.eigenvalues[*j].total_cmp(&axes.eigenvalues[*i]));
        // At a given orientation, the directions of turns are the last ones.
        order.truncate(self.unknowns());
        let weak = order.remove(order.len() - 1 - k);
        let least = least_eigenvalue(&axes);
        order.retain(|k| axes.eigenvalues[*k] > least);
        let axis = axes.eigenvectors.column(weak).into_owned();
        let size = BEND_STEP * mean(lengths);
        let (ahead, behind) = (self.moved(pose, &(size * axis)), self.moved(pose, &(-size * axis)));
        let (mut along, mut straight, mut square) = (Vector6::zeros(), 0.0, 0.0);
        let around = self.rows(&ahead).zip(self.rows(&behind));
        for ((cable, given), (ahead, behind)) in self.rows(pose).zip(lengths).zip(around) {
            let ((row, length), (_, ahead), (_, behind)) = (cable?, ahead?, behind?);
            let bend = 0.5 * (ahead + behind - 2.0 * length) / (size * size);
            along += bend * row;
            straight += (given - length) * bend;
            square += bend * bend;
        }
        for k in &order {
            let (axis, value) = (axes.eigenvectors.column(*k), axes.eigenvalues[*k]);
            straight -= axis.dot(&here.right) * axis.dot(&along) / value;
            square -= axis.dot(&along).powi(2) / value;
        }
        let slope = axis.dot(&along);
        Some(Fold { weak, stiff: order, along, linear: axes.eigenvalues[weak], slope, straight, square, axes })
    }
}

/// The lengths along a direction in which they change little, by their first derivatives and half of their second ones. Products are those
/// of what the other directions cannot compensate.
struct Fold {
    axes: SymmetricEigen<f64, U6>,
    /// Index of the direction.
    weak: usize,
    /// Indices of the other directions in which lengths change.
    stiff: Vec<usize>,
    /// Jᵀ times the second derivatives.
    along: Vector6<f64>,
    /// Square of the first derivatives.
    linear: f64,
    /// First times second derivatives.
    slope: f64,
    /// Residuals times second derivatives.
    straight: f64,
    /// Square of the second derivatives.
    square: f64,
}
