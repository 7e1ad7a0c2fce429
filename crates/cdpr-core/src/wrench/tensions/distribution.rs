//! Which of all tensions that balance a wrench are chosen.
//!
//! - `middle`: the smallest Σ (tᵢ − mᵢ)², with m the middle of the limits.
//! - `least`: the smallest Σ tᵢ².
//! - `p4`, `p8`: the smallest Σ |tᵢ − mᵢ|ᵖ. C. Gosselin and M. Grenier, "On the determination of the force distribution in
//!   overconstrained cable-driven parallel mechanisms", Meccanica 46, 2011, propose p-norms with a finite p: the largest deviation
//!   shrinks as p grows, but the ∞-norm has many solutions and no continuous choice among them.
//! - `closed-form`: t = m + W⁺ (w − W m), without regard to limits. A. Pott, T. Bruckmann and L. Mikelsons, "Closed-form force
//!   distribution for parallel wire robots", Computational Kinematics, 2009. These are the tensions of `middle` where they are
//!   within the limits, and elsewhere there are none. The improved closed form (A. Pott, 2014) then fixes the cable that exceeds its
//!   limit by most at this limit, and so on. It is not offered: where two cables exceed their limits by the same amount, tensions
//!   jump from one order to the other. The active set of `middle` fixes cables at their limits likewise, but also releases them.
//!
//! Each of the first four minimises a strictly convex function of the tensions, so they are unique, and exist wherever any tensions
//! balance the wrench. They are continuous along a motion as long as tensions inside the limits balance the wrench at full rank,
//! which is the case if the capacity margin is positive: then the balancing tensions within the limits change continuously as a
//! set. Where the margin is zero they need not: the set may be a single point or a line, and change its shape all at once.

use nalgebra::{DVector, Matrix6xX, Vector6};

use super::active_set::Nearest;
use super::linear_program::Balance;
use super::quadratic_program::{TensionQp, reference_or_middle, widest_half};
use super::slice::{Equations, Slice, check};
use crate::error::Error;
use crate::model::Distribution;

impl TensionQp {
    /// The chosen ones of all tensions t with `W t = wrench` and `t_min <= t <= t_max`, if there are any.
    ///
    /// `wrench_matrix`, `limits` and `wrench` are those of [`FeasibilityLp::solve`](super::FeasibilityLp::solve). In closed form,
    /// [`Balance::Infeasible`] means that the tensions exceed a limit.
    ///
    /// # Errors
    /// The errors of [`FeasibilityLp::solve`](super::FeasibilityLp::solve).
    ///
    /// # Source
    /// p-norms: C. Gosselin and M. Grenier, 2011; closed form: A. Pott, T. Bruckmann and L. Mikelsons, 2009.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{model::Distribution, wrench::TensionQp};
    /// use nalgebra::{Matrix6xX, Vector6};
    /// let mut w = Matrix6xX::zeros(2); // two cables along the x-axis, one to each side
    /// (w[(0, 0)], w[(0, 1)]) = (1.0, -1.0);
    /// let (limits, mut qp) = ([[10.0, 100.0]; 2], TensionQp::default());
    /// let found = qp.distribute(Distribution::Least, &w, &limits, &(Vector6::x() * 30.0))?;
    /// assert_eq!(found.tensions().unwrap()[1], 10.0); // as slack as the limits allow
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn distribute(
        &mut self,
        chosen: Distribution,
        wrench_matrix: &Matrix6xX<f64>,
        limits: &[[f64; 2]],
        wrench: &Vector6<f64>,
    ) -> Result<Balance, Error> {
        let power = match chosen {
            Distribution::Middle => return self.solve(wrench_matrix, limits, wrench, None),
            Distribution::Least => return self.solve(wrench_matrix, limits, wrench, Some(&vec![0.0; limits.len()])),
            Distribution::ClosedForm => 2,
            Distribution::P4 => 4,
            Distribution::P8 => 8,
        };
        check(wrench_matrix, limits, wrench)?;
        let (middle, unit) = (reference_or_middle(None, limits)?, widest_half(limits));
        let equations = Equations::new(&(wrench_matrix * unit));
        let method = if chosen == Distribution::ClosedForm { without_limits } else { Self::nearest };
        let found = self.solve_by(&equations, wrench_matrix, limits, wrench, &middle, method);
        let Balance::Feasible(mut tensions) = found else { return Ok(found) };
        if power > 2 && !self.norm.lessen(&equations.null, power, (&middle, unit), limits, &mut tensions) {
            return Ok(Balance::Undecided);
        }
        Ok(Balance::Feasible(tensions))
    }
}

/// The point nearest to the reference, if it is within the limits.
fn without_limits(_: &mut TensionQp, slice: &Slice) -> Nearest {
    match slice.within(&DVector::zeros(slice.freedom())) {
        Some(x) => Nearest::At(x),
        None => Nearest::Nowhere(DVector::zeros(slice.point.len())),
    }
}
