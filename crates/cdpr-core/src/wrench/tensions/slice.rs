//! The tensions that balance one wrench: an affine slice of the box of tension limits.
//!
//! `W t = w` has the solutions `t = p + N y`, with p in the row space of W and N an orthonormal basis of its null
//! space, so the dimension of y is the number of cables minus the rank of W: two for eight cables. Only the limits
//! remain, two for each cable. No result is trusted merely because an algorithm ended: a point is verified against the
//! limits, and a "no" comes with a plane that separates the slice from the box.

use nalgebra::{DMatrix, DVector, DVectorView, Matrix6xX, Vector6};

use crate::error::Error;
use crate::limits::MAX_WRENCH;
use crate::tolerances::{BALANCE_RELATIVE, LIMIT_RELATIVE, LIMIT_SLACK, RANK_RELATIVE, SEPARATING_LEFT};

/// Rejects ill-posed problems: no cables, wrong lengths, numbers that are not finite, lower limits above upper ones.
pub(super) fn check(wrench_matrix: &Matrix6xX<f64>, limits: &[[f64; 2]], wrench: &Vector6<f64>) -> Result<(), Error> {
    let cables = wrench_matrix.ncols();
    if cables == 0 {
        return Err(Error::invalid("wrench_matrix", "has no columns, expected one for each cable"));
    }
    check_numbers("wrench_matrix", wrench_matrix.as_slice())?;
    check_numbers("wrench", wrench.as_slice())?;
    if limits.len() != cables {
        let problem = format!("has {} pairs, expected one for each of {cables} cables", limits.len());
        return Err(Error::invalid("limits", problem));
    }
    for (i, [lo, hi]) in limits.iter().enumerate() {
        check_numbers(&format!("limits[{i}]"), &[*lo, *hi])?;
        if lo > hi {
            let problem = format!("found t_min = {lo} above t_max = {hi}, expected t_min <= t_max");
            return Err(Error::invalid(format!("limits[{i}]"), problem));
        }
    }
    Ok(())
}

/// Rejects numbers that are not finite, or so large that their products are not.
pub(super) fn check_numbers(place: &str, numbers: &[f64]) -> Result<(), Error> {
    match numbers.iter().find(|x| !(x.abs() <= MAX_WRENCH)) {
        None => Ok(()),
        Some(bad) => Err(Error::invalid(place, format!("contains {bad:?}, expected numbers up to {MAX_WRENCH:e}"))),
    }
}

/// Solver of `W x = w` for one W and any w: row space, null space and rank, by Gram-Schmidt on the rows of W, largest
/// first.
pub(super) struct Equations {
    /// Orthonormal basis of the null space, m × (m − rank).
    pub(super) null: DMatrix<f64>,
    /// Orthonormal basis Q of the row space, m × rank.
    rows: DMatrix<f64>,
    /// W Q, 6 × rank; lower triangular in the order of `pivots`.
    lower: Matrix6xX<f64>,
    /// For each column of Q, the row of W that it comes from.
    pivots: Vec<usize>,
}

impl Equations {
    pub(super) fn new(matrix: &Matrix6xX<f64>) -> Self {
        let cables = matrix.ncols();
        let mut basis = DMatrix::zeros(cables, cables);
        let pivots = row_space(matrix, &mut basis);
        let rank = pivots.len();
        complete(&mut basis, rank);
        let rows = basis.columns(0, rank).into_owned();
        // Column by column: preparing a product of whole matrices takes longer than this small one.
        let mut lower = Matrix6xX::zeros(rank);
        for (mut column, row) in lower.column_iter_mut().zip(rows.column_iter()) {
            column.gemv(1.0, matrix, &row, 0.0);
        }
        Self { null: basis.columns_range(rank..).into_owned(), lower, rows, pivots }
    }

    /// The shortest x with `W x = wrench`; `None` if the component of the wrench outside the column space exceeds
    /// [`BALANCE_RELATIVE`] of `scale`.
    pub(super) fn solve(&self, wrench: &Vector6<f64>, scale: f64) -> Option<DVector<f64>> {
        let mut left = *wrench;
        let mut shares = DVector::zeros(self.pivots.len());
        for (k, &row) in self.pivots.iter().enumerate() {
            shares[k] = left[row] / self.lower[(row, k)];
            left -= self.lower.column(k) * shares[k];
        }
        (left.norm() <= BALANCE_RELATIVE * scale).then(|| &self.rows * shares)
    }
}

/// Fills the first columns of `basis` with an orthonormal basis of the row space; returns the rows that they come from.
fn row_space(matrix: &Matrix6xX<f64>, basis: &mut DMatrix<f64>) -> Vec<usize> {
    let cables = matrix.ncols();
    let mut left = matrix.transpose(); // the component of each row orthogonal to the basis so far
    let mut pivots = Vec::with_capacity(6);
    let mut largest = 0.0_f64;
    while pivots.len() < cables.min(6) {
        let row = longest(left.column_iter().map(|c| c.norm_squared()));
        let norm = left.column(row).norm();
        largest = largest.max(norm);
        if !(norm > RANK_RELATIVE * largest) {
            break;
        }
        let (before, rest) = basis.as_mut_slice().split_at_mut(pivots.len() * cables);
        let column = &mut rest[..cables];
        column.iter_mut().zip(left.column(row).iter()).for_each(|(to, from)| *to = from / norm);
        orthonormalise(before, column);
        left.as_mut_slice().chunks_exact_mut(cables).for_each(|other| remove(column, other));
        left.column_mut(row).fill(0.0);
        pivots.push(row);
    }
    pivots
}

/// Completes the columns of `basis` from `rank` on to an orthonormal basis, always using the axis that is least
/// covered.
fn complete(basis: &mut DMatrix<f64>, rank: usize) {
    let cables = basis.nrows();
    for k in rank..cables {
        let (before, rest) = basis.as_mut_slice().split_at_mut(k * cables);
        let covered = |axis: usize| before.chunks_exact(cables).map(|other| other[axis] * other[axis]).sum::<f64>();
        let axis = longest((0..cables).map(|axis| 1.0 - covered(axis)));
        rest[axis] = 1.0;
        orthonormalise(before, &mut rest[..cables]);
    }
}

fn longest(squares: impl Iterator<Item = f64>) -> usize {
    squares.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(i, _)| i)
}

/// Removes the components of `column` along the columns `before`, one after the other; done twice to remove the rounding error
/// of the first pass.
fn orthonormalise(before: &[f64], column: &mut [f64]) {
    for _ in 0..2 {
        before.chunks_exact(column.len()).for_each(|other| remove(other, column));
        let norm = dot(column, column).sqrt();
        column.iter_mut().for_each(|x| *x /= norm);
    }
}

/// Removes the component along a unit vector.
fn remove(unit: &[f64], from: &mut [f64]) {
    let share = dot(unit, from);
    from.iter_mut().zip(unit).for_each(|(x, along)| *x -= share * along);
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    DVectorView::from_slice(a, a.len()).dot(&DVectorView::from_slice(b, b.len()))
}

/// All y with `lower <= point + null y <= upper`, componentwise; all vectors have length m.
pub(super) struct Slice<'a> {
    pub(super) null: &'a DMatrix<f64>,
    pub(super) point: DVector<f64>,
    pub(super) lower: DVector<f64>,
    pub(super) upper: DVector<f64>,
}

impl Slice<'_> {
    /// Dimension of y.
    pub(super) fn freedom(&self) -> usize {
        self.null.ncols()
    }

    /// `point + null y`, clamped to limits that it violates only by rounding; `None` if it violates one by more.
    pub(super) fn within(&self, y: &DVector<f64>) -> Option<DVector<f64>> {
        let mut x = &self.point + self.null * y;
        for (i, x) in x.iter_mut().enumerate() {
            let (lo, hi) = (self.lower[i], self.upper[i]);
            if !(lo - *x <= LIMIT_RELATIVE && *x - hi <= LIMIT_RELATIVE) {
                return None;
            }
            *x = x.clamp(lo, hi);
        }
        Some(x)
    }

    /// This slice with every limit moved outward.
    pub(super) fn widened(&self, by: f64) -> Slice<'_> {
        let (lower, upper) = (self.lower.add_scalar(-by), self.upper.add_scalar(by));
        Slice { null: self.null, point: self.point.clone(), lower, upper }
    }

    /// Clamps every entry to its limits.
    pub(super) fn put_back(&self, x: DVector<f64>) -> DVector<f64> {
        DVector::from_fn(x.len(), |i, _| x[i].clamp(self.lower[i], self.upper[i]))
    }

    /// Whether a direction, after its component along the null space is removed, proves that the slice misses the box:
    /// it is then constant on the slice, and larger than anywhere in the box.
    pub(super) fn separated_by(&self, direction: &DVector<f64>) -> bool {
        let Some(normal) = self.across(direction) else { return false };
        let slack = LIMIT_SLACK * normal.lp_norm(1);
        normal.dot(&self.point) > self.support(&normal) + slack
    }

    /// `direction` without its component along the null space; `None` if only rounding errors remain.
    pub(super) fn across(&self, direction: &DVector<f64>) -> Option<DVector<f64>> {
        let mut normal = direction.clone();
        for _ in 0..2 {
            let along = self.null.tr_mul(&normal);
            normal.gemv(-1.0, self.null, &along, 1.0);
        }
        (normal.norm() > SEPARATING_LEFT * direction.norm()).then_some(normal)
    }

    /// Largest value of `normal` in the box.
    pub(super) fn support(&self, normal: &DVector<f64>) -> f64 {
        (0..normal.len()).map(|i| normal[i] * if normal[i] > 0.0 { self.upper[i] } else { self.lower[i] }).sum()
    }
}

/// Tensions relative to the middle of their limits, in half ranges: every limit is −1 or 1.
pub(super) struct Ranges {
    pub(super) middle: DVector<f64>,
    pub(super) half: DVector<f64>,
    pub(super) equations: Equations,
    /// Wrenches smaller than this are compared with it, N.
    greatest: f64,
}

impl Ranges {
    pub(super) fn new(wrench_matrix: &Matrix6xX<f64>, limits: &[[f64; 2]]) -> Self {
        let middle = DVector::from_iterator(limits.len(), limits.iter().map(|[lo, hi]| 0.5 * (lo + hi)));
        let half = DVector::from_iterator(limits.len(), limits.iter().map(|[lo, hi]| 0.5 * (hi - lo)));
        let mut scaled = wrench_matrix.clone();
        for (mut column, half) in scaled.column_iter_mut().zip(half.iter()) {
            column *= *half;
        }
        Self { middle, half, equations: Equations::new(&scaled), greatest: greatest(limits) }
    }

    /// The slice of a wrench; `None` if the wrench has a component that no tensions balance.
    pub(super) fn slice(&self, wrench_matrix: &Matrix6xX<f64>, wrench: &Vector6<f64>) -> Option<Slice<'_>> {
        let scale = self.greatest.max(wrench.norm());
        let point = self.equations.solve(&(wrench - wrench_matrix * &self.middle), scale)?;
        let ones = DVector::repeat(point.len(), 1.0);
        Some(Slice { null: &self.equations.null, point, lower: -&ones, upper: ones })
    }

    /// Converts half ranges to tensions that are within their limits despite rounding.
    pub(super) fn tensions(&self, x: &DVector<f64>, limits: &[[f64; 2]]) -> DVector<f64> {
        DVector::from_fn(x.len(), |i, _| (self.middle[i] + self.half[i] * x[i]).clamp(limits[i][0], limits[i][1]))
    }
}

/// Largest tension in the limits, N.
pub(super) fn greatest(limits: &[[f64; 2]]) -> f64 {
    limits.iter().flatten().fold(0.0, |greatest, t| greatest.max(t.abs()))
}
