//! Two linear programs about wrenches: whether tensions within limits balance one, and how far a polytope of them can
//! be scaled up.
//!
//! Both are formulated in the null space of the wrench matrix and in half ranges of the tensions (a wrench is balanced
//! by `x = p + N y` with every entry between −1 and 1), so eight cables leave three unknowns and sixteen rows. clarabel
//! proposes an answer; independently verified tensions, or a separating plane, decide.

use clarabel::solver::DefaultInfo;
use nalgebra::{DMatrix, DVector, Matrix6xX, Vector6};

use super::active_set::{Nearest, nearest};
use super::interior_point::InteriorPoint;
use super::slice::{Ranges, Slice, check, check_numbers};
use crate::error::Error;
use crate::limits::SCALE_STEPS;
use crate::tolerances::{MOST_SCALE_ROUNDING, PLAIN_ANSWER, PLAIN_RESIDUAL, SCALE_ROUNDING};

/// Whether tensions within limits balance a wrench.
#[derive(Debug, Clone, PartialEq)]
pub enum Balance {
    /// These tensions balance the wrench, N, in cable order; exactly within their limits.
    Feasible(DVector<f64>),
    /// No tensions balance the wrench: a plane separates it from everything that the cables can balance.
    Infeasible,
    /// The solver failed; undecided.
    Undecided,
}

impl Balance {
    /// The tensions, N, if there are any.
    pub fn tensions(&self) -> Option<&DVector<f64>> {
        match self {
            Self::Feasible(tensions) => Some(tensions),
            Self::Infeasible | Self::Undecided => None,
        }
    }
}

/// Reusable solver for "can the cables balance this wrench?".
///
/// # Method
/// Minimises σ with `|p + N y| <= σ` in every cable: the wrench is feasible if σ <= 1. Unlike the direct feasibility
/// problem, this program always has a solution and an interior. Two cases need no solver: p itself is
/// within limits, or the plane normal to p separates.
///
/// # Example
/// ```
/// use cdpr_core::wrench::{Balance, FeasibilityLp};
/// use nalgebra::{Matrix6xX, Vector6};
/// let mut w = Matrix6xX::zeros(2); // two cables along the x-axis, one to each side
/// (w[(0, 0)], w[(0, 1)]) = (1.0, -1.0);
/// let (limits, mut lp) = ([[10.0, 100.0]; 2], FeasibilityLp::new());
/// let balance = lp.solve(&w, &limits, &(Vector6::x() * 50.0))?;
/// let tensions = balance.tensions().unwrap();
/// assert!((tensions[0] - tensions[1] - 50.0).abs() < 1e-9);
/// assert_eq!(lp.solve(&w, &limits, &(Vector6::x() * 91.0))?, Balance::Infeasible); // 90 N is the most
/// assert_eq!(lp.solve(&w, &limits, &Vector6::z())?, Balance::Infeasible); // no cable pulls up
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub struct FeasibilityLp {
    program: InteriorPoint,
}

impl Default for FeasibilityLp {
    fn default() -> Self {
        Self::new()
    }
}

impl FeasibilityLp {
    /// A solver; the first query determines its size.
    pub fn new() -> Self {
        Self { program: InteriorPoint::new(0.0, Some(plain)) }
    }

    /// Tensions t with `W t = wrench` and `t_min <= t <= t_max`, if there are any.
    ///
    /// `wrench_matrix` is W, 6 × m, of any rank, with rows of comparable scale; `limits` is (t_min, t_max) of each
    /// cable, N; `wrench` is what the cables have to exert on the platform, [force, N; moment, N times the length unit
    /// of W]. The balance is accurate to [`BALANCE_RELATIVE`](crate::tolerances::BALANCE_RELATIVE).
    ///
    /// # Errors
    /// No cable, lengths that differ, numbers that are not finite or exceed
    /// [`MAX_WRENCH`](crate::limits::MAX_WRENCH), `t_min` above `t_max`.
    pub fn solve(
        &mut self,
        wrench_matrix: &Matrix6xX<f64>,
        limits: &[[f64; 2]],
        wrench: &Vector6<f64>,
    ) -> Result<Balance, Error> {
        check(wrench_matrix, limits, wrench)?;
        let ranges = Ranges::new(wrench_matrix, limits);
        let Some(slice) = ranges.slice(wrench_matrix, wrench) else { return Ok(Balance::Infeasible) };
        Ok(match self.inside(&slice) {
            Nearest::At(x) => Balance::Feasible(ranges.tensions(&x, limits)),
            Nearest::Nowhere(_) => Balance::Infeasible,
            Nearest::Unsettled => Balance::Undecided,
        })
    }

    /// Any point of the slice in the box.
    fn inside(&mut self, slice: &Slice) -> Nearest {
        if let Some(x) = slice.within(&DVector::zeros(slice.freedom())) {
            return Nearest::At(x);
        }
        if slice.separated_by(&slice.point) {
            return Nearest::Nowhere(slice.point.clone());
        }
        if slice.freedom() > 0
            && let Some((y, direction)) = self.least_reach(slice)
        {
            if let Some(x) = slice.within(&y) {
                return Nearest::At(x);
            }
            if slice.separated_by(&direction) {
                return Nearest::Nowhere(direction);
            }
        }
        nearest(slice, &[]) // too close to the boundary for an interior-point answer
    }

    /// An approximate minimiser y of σ, and a direction that approximately bounds σ from below.
    fn least_reach(&mut self, slice: &Slice) -> Option<(DVector<f64>, DVector<f64>)> {
        let last = slice.freedom();
        let matrix = both_signs(slice.null, |_| -1.0, |_| -1.0);
        let bounds = DVector::from_fn(matrix.nrows(), |i, _| match i.checked_sub(slice.point.len()) {
            None => -slice.point[i],
            Some(i) => slice.point[i],
        });
        let mut cost = vec![0.0; last + 1];
        cost[last] = 1.0;
        let proposal = self.program.propose(&cost, &matrix, bounds.as_slice())?;
        Some((DVector::from_column_slice(&proposal.x[..last]), difference(proposal.multipliers)))
    }
}

/// A σ clearly below or above 1.
fn plain(info: &DefaultInfo<f64>) -> bool {
    let yes = info.cost_primal < 1.0 - PLAIN_ANSWER && info.res_primal < PLAIN_RESIDUAL;
    let no = info.cost_dual > 1.0 + PLAIN_ANSWER && info.res_dual < PLAIN_RESIDUAL;
    yes || no
}

/// The rows [N, a] over the rows [−N, b].
fn both_signs(null: &DMatrix<f64>, a: impl Fn(usize) -> f64, b: impl Fn(usize) -> f64) -> DMatrix<f64> {
    let (cables, freedom) = null.shape();
    DMatrix::from_fn(2 * cables, freedom + 1, |i, j| match (i < cables, j < freedom) {
        (true, true) => null[(i, j)],
        (false, true) => -null[(i - cables, j)],
        (true, false) => a(i),
        (false, false) => b(i - cables),
    })
}

/// Multipliers of upper limits minus those of lower limits.
fn difference(multipliers: &[f64]) -> DVector<f64> {
    let (upper, lower) = multipliers.split_at(multipliers.len() / 2);
    DVector::from_iterator(upper.len(), upper.iter().zip(lower).map(|(u, l)| u - l))
}

/// How far a polytope of wrenches around a centre can be scaled up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LargestScale {
    /// Up to this scale, >= 0: every corner, and therefore the whole polytope, can just be balanced.
    Bounded(f64),
    /// All corners coincide with the centre, which can be balanced.
    Unbounded,
    /// The centre cannot be balanced.
    Infeasible,
    /// The solver failed; undecided.
    Undecided,
}

/// Reusable solver for "by how much can this polytope of wrenches grow?".
///
/// # Method
/// One small program for each corner, the largest s with `-1 <= p + s q + N y <= 1`, unless the corner can also be
/// balanced at the smallest scale so far (which needs no program). Its multipliers define a plane that bounds s. If the
/// wrench at this bound cannot be balanced, the plane that separates it gives a new bound.
///
/// # Example
/// ```
/// use cdpr_core::wrench::{LargestScale, ScaleLp};
/// use nalgebra::{Matrix6xX, Vector6};
/// let mut w = Matrix6xX::zeros(2); // two cables along the x-axis, one to each side
/// (w[(0, 0)], w[(0, 1)]) = (1.0, -1.0);
/// let (limits, mut lp) = ([[10.0, 100.0]; 2], ScaleLp::new());
/// let corners = [Vector6::x(), -Vector6::x()];
/// let LargestScale::Bounded(s) = lp.solve(&w, &limits, &(Vector6::x() * 50.0), &corners)? else { panic!() };
/// assert!((s - 40.0).abs() < 1e-7); // 50 N and 40 N more is what one cable can pull against the other
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub struct ScaleLp {
    program: InteriorPoint,
}

impl Default for ScaleLp {
    fn default() -> Self {
        Self::new()
    }
}

impl ScaleLp {
    /// A solver; the first query determines its size.
    pub fn new() -> Self {
        Self { program: InteriorPoint::new(0.0, None) }
    }

    /// The largest s for which `centre + s v` can be balanced for every v of `corners`.
    ///
    /// `wrench_matrix` and `limits` are those of [`FeasibilityLp::solve`]; corners and centre are wrenches in the same
    /// units. If a corner is in a direction that no tensions balance, the result is 0.
    ///
    /// # Errors
    /// The errors of [`FeasibilityLp::solve`], and an empty list of corners.
    pub fn solve(
        &mut self,
        wrench_matrix: &Matrix6xX<f64>,
        limits: &[[f64; 2]],
        centre: &Vector6<f64>,
        corners: &[Vector6<f64>],
    ) -> Result<LargestScale, Error> {
        check_numbers("centre", centre.as_slice())?;
        check(wrench_matrix, limits, centre)?;
        if corners.is_empty() {
            return Err(Error::invalid("corners", "is empty, expected at least one"));
        }
        for (k, corner) in corners.iter().enumerate() {
            check_numbers(&format!("corners[{k}]"), corner.as_slice())?;
        }
        let ranges = Ranges::new(wrench_matrix, limits);
        let Some(slice) = ranges.slice(wrench_matrix, centre) else { return Ok(LargestScale::Infeasible) };
        Ok(match nearest(&slice, &[]) {
            Nearest::At(_) => self.over_corners(&ranges, slice, corners),
            Nearest::Nowhere(_) => LargestScale::Infeasible,
            Nearest::Unsettled => LargestScale::Undecided,
        })
    }

    fn over_corners(&mut self, ranges: &Ranges, slice: Slice, corners: &[Vector6<f64>]) -> LargestScale {
        let mut ray = Ray { centre: slice.point.clone(), direction: slice.point.clone(), slice };
        let mut smallest = f64::INFINITY;
        for corner in corners {
            let size = corner.amax();
            if size == 0.0 {
                continue;
            }
            let Some(direction) = ranges.equations.solve(&(corner / size), 1.0) else {
                return LargestScale::Bounded(0.0);
            };
            let step = direction.amax() * size; // one unit of s along the ray, in half ranges
            ray.direction = &direction / direction.amax();
            if smallest.is_finite() && ray.reaches(smallest * step) {
                continue;
            }
            match self.along(&mut ray) {
                Some(s) => smallest = smallest.min(s / step),
                None => return LargestScale::Undecided,
            }
        }
        if smallest.is_finite() { LargestScale::Bounded(smallest) } else { LargestScale::Unbounded }
    }

    /// How far one ray stays inside, in half ranges; `None` if the solver failed.
    fn along(&mut self, ray: &mut Ray) -> Option<f64> {
        let mut s = ray.bound(&ray.direction)?;
        if ray.slice.freedom() > 0
            && let Some(bound) = self.plane(ray).and_then(|normal| ray.bound(&normal))
        {
            s = s.min(bound);
        }
        let mut back = SCALE_ROUNDING;
        for _ in 0..SCALE_STEPS {
            match ray.at(s) {
                Nearest::At(_) => return Some(s),
                // If a plane moves the end only by rounding, move it slightly farther.
                Nearest::Nowhere(normal) => s = ray.bound(&normal)?.min(s * (1.0 - SCALE_ROUNDING)),
                // So close to the end that rounding decides: go back, twice as far each time, to where it does not.
                Nearest::Unsettled if back <= MOST_SCALE_ROUNDING => {
                    s *= 1.0 - back;
                    back *= 2.0;
                }
                Nearest::Unsettled => return None,
            }
        }
        None
    }

    /// An approximation of the plane that stops the ray.
    fn plane(&mut self, ray: &Ray) -> Option<DVector<f64>> {
        let cables = ray.centre.len();
        let matrix = both_signs(ray.slice.null, |i| ray.direction[i], |i| -ray.direction[i]);
        let bounds = DVector::from_fn(2 * cables, |i, _| match i.checked_sub(cables) {
            None => 1.0 - ray.centre[i],
            Some(i) => 1.0 + ray.centre[i],
        });
        let mut cost = vec![0.0; matrix.ncols()];
        cost[matrix.ncols() - 1] = -1.0;
        let proposal = self.program.propose(&cost, &matrix, bounds.as_slice())?;
        Some(difference(proposal.multipliers))
    }
}

/// Slices whose point moves along a direction, all in half ranges.
struct Ray<'a> {
    slice: Slice<'a>,
    centre: DVector<f64>,
    direction: DVector<f64>,
}

impl Ray<'_> {
    fn at(&mut self, s: f64) -> Nearest {
        self.slice.point = &self.centre + &self.direction * s;
        nearest(&self.slice, &[])
    }

    fn reaches(&mut self, s: f64) -> bool {
        matches!(self.at(s), Nearest::At(_))
    }

    /// Where the ray leaves the half-space with this normal that contains the box; `None` if it does not.
    fn bound(&self, normal: &DVector<f64>) -> Option<f64> {
        let normal = self.slice.across(normal)?;
        let rate = normal.dot(&self.direction);
        let bound = (self.slice.support(&normal) - normal.dot(&self.centre)) / rate;
        (rate > 0.0 && bound.is_finite()).then_some(bound.max(0.0))
    }
}
