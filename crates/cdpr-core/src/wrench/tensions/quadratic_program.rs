//! The tensions nearest to a reference that balance a wrench.
//!
//! Let `t = p + N y`, with p the balancing tensions nearest to the reference regardless of limits. The distance is then
//! |y|, so the problem is to find the point of a polytope nearest to the origin, in two dimensions for eight cables.

use nalgebra::{DMatrix, DVector, Matrix6xX, Vector6};

use super::active_set::{Limit, Nearest, nearest};
use super::interior_point::InteriorPoint;
use super::linear_program::Balance;
use super::norm::LeastNorm;
use super::slice::{Equations, Slice, check, check_numbers, greatest};
use crate::error::Error;

/// How the nearest tensions are found. Both methods end in the same active set, so their answers are equal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum QpMethod {
    /// The dual active-set method, starting at the reference; the interior-point method if rounding stops it.
    #[default]
    ActiveSet,
    /// clarabel first; the active set starts from the limits that clarabel finds active.
    InteriorPoint,
}

/// Reusable solver for the tensions nearest to a reference.
///
/// # Source
/// Minimise Σ (tᵢ − refᵢ)² where `W t = wrench` and `t_min <= t <= t_max`; D. Goldfarb and A. Idnani, 1983, for the
/// active set.
///
/// # Example
/// ```
/// use cdpr_core::wrench::TensionQp;
/// use nalgebra::{Matrix6xX, Vector6};
/// let mut w = Matrix6xX::zeros(2); // two cables along the x-axis, one to each side
/// (w[(0, 0)], w[(0, 1)]) = (1.0, -1.0);
/// let (limits, mut qp) = ([[10.0, 100.0]; 2], TensionQp::default());
/// let balance = qp.solve(&w, &limits, &(Vector6::x() * 30.0), None)?;
/// assert!((balance.tensions().unwrap()[0] - 70.0).abs() < 1e-9); // 70 − 40, as near to 55 N as can be
/// let balance = qp.solve(&w, &limits, &(Vector6::x() * 30.0), Some(&[0.0, 0.0]))?;
/// assert_eq!(balance.tensions().unwrap()[1], 10.0); // as slack as the limits allow
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub struct TensionQp {
    method: QpMethod,
    program: InteriorPoint,
    /// Memory of the search for the least norm.
    pub(super) norm: LeastNorm,
}

impl Default for TensionQp {
    fn default() -> Self {
        Self::new(QpMethod::default())
    }
}

impl TensionQp {
    /// A solver; the first query determines its size.
    pub fn new(method: QpMethod) -> Self {
        Self { method, program: InteriorPoint::new(1.0, None), norm: LeastNorm::default() }
    }

    /// Tensions t nearest to the reference with `W t = wrench` and `t_min <= t <= t_max`, if there are any. They are
    /// unique and depend continuously on the wrench.
    ///
    /// `wrench_matrix`, `limits` and `wrench` are those of
    /// [`FeasibilityLp::solve`](super::FeasibilityLp::solve). `reference` is one tension for each
    /// cable, N, within limits or not; the default is the middle of the limits.
    ///
    /// # Errors
    /// The errors of [`FeasibilityLp::solve`](super::FeasibilityLp::solve); a `reference` of another length, or with a
    /// number that is not finite.
    pub fn solve(
        &mut self,
        wrench_matrix: &Matrix6xX<f64>,
        limits: &[[f64; 2]],
        wrench: &Vector6<f64>,
        reference: Option<&[f64]>,
    ) -> Result<Balance, Error> {
        check(wrench_matrix, limits, wrench)?;
        let reference = reference_or_middle(reference, limits)?;
        let equations = Equations::new(&(wrench_matrix * widest_half(limits)));
        Ok(self.solve_by(&equations, wrench_matrix, limits, wrench, &reference, Self::nearest))
    }

    /// The answer of `method` for tensions relative to a reference, in units of [`widest_half`]; the equations are those of the
    /// wrench matrix times this unit.
    pub(super) fn solve_by(
        &mut self,
        equations: &Equations,
        wrench_matrix: &Matrix6xX<f64>,
        limits: &[[f64; 2]],
        wrench: &Vector6<f64>,
        reference: &DVector<f64>,
        method: fn(&mut Self, &Slice) -> Nearest,
    ) -> Balance {
        let unit = widest_half(limits);
        let scale = greatest(limits).max(wrench.norm());
        let Some(point) = equations.solve(&(wrench - wrench_matrix * reference), scale) else {
            return Balance::Infeasible;
        };
        let bound = |side: usize| DVector::from_fn(limits.len(), |i, _| (limits[i][side] - reference[i]) / unit);
        let slice = Slice { null: &equations.null, point, lower: bound(0), upper: bound(1) };
        let put_back = |x: DVector<f64>| {
            DVector::from_fn(x.len(), |i, _| match x[i] {
                x if x == slice.lower[i] => limits[i][0],
                x if x == slice.upper[i] => limits[i][1],
                x => (reference[i] + unit * x).clamp(limits[i][0], limits[i][1]),
            })
        };
        match method(self, &slice) {
            Nearest::At(x) => Balance::Feasible(put_back(x)),
            Nearest::Nowhere(_) => Balance::Infeasible,
            Nearest::Unsettled => Balance::Undecided,
        }
    }

    pub(super) fn nearest(&mut self, slice: &Slice) -> Nearest {
        if let Some(x) = slice.within(&DVector::zeros(slice.freedom())) {
            return Nearest::At(x); // the nearest even without limits
        }
        let middle = (&slice.lower + &slice.upper) * 0.5;
        let away = &slice.point - middle;
        if slice.separated_by(&away) {
            return Nearest::Nowhere(away);
        }
        if self.method == QpMethod::ActiveSet || slice.freedom() == 0 {
            let found = nearest(slice, &[]);
            if !matches!(found, Nearest::Unsettled) || slice.freedom() == 0 {
                return found;
            }
        }
        self.by_interior_point(slice)
    }

    fn by_interior_point(&mut self, slice: &Slice) -> Nearest {
        let (cables, freedom) = slice.null.shape();
        let matrix = DMatrix::from_fn(2 * cables, freedom, |i, j| match i.checked_sub(cables) {
            None => slice.null[(i, j)],
            Some(i) => -slice.null[(i, j)],
        });
        let bounds = DVector::from_fn(2 * cables, |i, _| match i.checked_sub(cables) {
            None => slice.upper[i] - slice.point[i],
            Some(i) => slice.point[i] - slice.lower[i],
        });
        let cost = vec![0.0; freedom];
        let Some(proposal) = self.program.propose(&cost, &matrix, bounds.as_slice()) else {
            return nearest(slice, &[]);
        };
        let multipliers = DVector::from_column_slice(proposal.multipliers);
        let direction = multipliers.rows(0, cables) - multipliers.rows(cables, cables);
        if slice.separated_by(&direction) {
            return Nearest::Nowhere(direction);
        }
        let slack = bounds - matrix * DVector::from_column_slice(proposal.x);
        nearest(slice, &active(&multipliers, &slack))
    }
}

/// Limits whose multiplier exceeds their slack.
fn active(multipliers: &DVector<f64>, slack: &DVector<f64>) -> Vec<Limit> {
    let cables = slack.len() / 2;
    let limit = |i: usize| Limit { entry: i % cables, side: if i < cables { 1.0 } else { -1.0 } };
    (0..slack.len()).filter(|i| multipliers[*i] > slack[*i]).map(limit).collect()
}

pub(super) fn reference_or_middle(reference: Option<&[f64]>, limits: &[[f64; 2]]) -> Result<DVector<f64>, Error> {
    let Some(reference) = reference else {
        return Ok(DVector::from_iterator(limits.len(), limits.iter().map(|[lo, hi]| 0.5 * (lo + hi))));
    };
    check_numbers("reference", reference)?;
    if reference.len() != limits.len() {
        let problem = format!("has {} tensions, expected one for each of {} cables", reference.len(), limits.len());
        return Err(Error::invalid("reference", problem));
    }
    Ok(DVector::from_column_slice(reference))
}

/// Half the widest range, N, the unit of the program; 1 if every tension is given.
pub(super) fn widest_half(limits: &[[f64; 2]]) -> f64 {
    let widest = limits.iter().fold(0.0_f64, |widest, [lo, hi]| widest.max(0.5 * (hi - lo)));
    if widest > 0.0 { widest } else { 1.0 }
}
