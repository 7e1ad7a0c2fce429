//! The smallest p-norm of tensions relative to the middle of their limits.
//!
//! Newton's method with an active set, from tensions that balance the wrench within the limits, such as those with the smallest
//! 2-norm. Each step keeps the active limits and goes to the least sum of p-th powers along Newton's direction, or to the first
//! limit on the way, which becomes active. Where no direction that keeps them lessens the sum, the limit with the most negative
//! multiplier is released; if none is negative, the Kuhn-Tucker conditions hold, and the sum is least, since it is convex. All tensions
//! on the way balance the wrench within the limits.
//!
//! J. Nocedal and S. Wright, "Numerical Optimization", 2006, chapter 16.5, for active sets; p is even.

use nalgebra::{DMatrix, DVector};

use super::active_set::Limit;
use crate::limits::{ACTIVE_SET_STEPS, NORM_STEPS};
use crate::tolerances::{NORM_DEPENDENT, NORM_GRADIENT, NORM_MULTIPLIER, NORM_STEP};

/// Reusable memory of the search. Lengths: m, the number of cables; r, the dimension of the null space.
#[derive(Default)]
pub(super) struct LeastNorm {
    /// Deviations from the middle in units of the largest one of the start, m.
    x: Vec<f64>,
    /// Change of `x` for a whole step, m.
    change: Vec<f64>,
    /// The limits of `x`, m.
    bounds: Vec<[f64; 2]>,
    active: Vec<Limit>,
    /// Row by row: orthonormal basis of the normals of active limits, completed to all of r dimensions.
    basis: Vec<f64>,
    /// Gradient in y, r.
    gradient: Vec<f64>,
    /// Newton's matrix on the face, row by row, and the right-hand side.
    matrix: Vec<f64>,
    step: Vec<f64>,
    /// Multipliers of the active limits.
    multipliers: Vec<f64>,
}

impl LeastNorm {
    /// Moves tensions along the columns of `null`, which keep the balance, to the least sum of p-th powers of their deviations from
    /// `middle`, N, within their limits. False if the search did not end; the tensions still balance then.
    pub(super) fn lessen(
        &mut self,
        null: &DMatrix<f64>,
        p: i32,
        (middle, unit): (&DVector<f64>, f64),
        limits: &[[f64; 2]],
        tensions: &mut DVector<f64>,
    ) -> bool {
        let deviation = |i: usize| (tensions[i] - middle[i]) / unit;
        let scale = (0..limits.len()).fold(0.0_f64, |most, i| most.max(deviation(i).abs()));
        if null.ncols() == 0 || !(scale > 0.0) {
            return true;
        }
        self.x.clear();
        self.x.extend((0..limits.len()).map(|i| deviation(i) / scale));
        self.bounds.clear();
        let bound = |t: f64, i: usize| (t - middle[i]) / unit / scale;
        self.bounds.extend(limits.iter().enumerate().map(|(i, [lo, hi])| [bound(*lo, i), bound(*hi, i)]));
        self.change.resize(limits.len(), 0.0);
        let ended = self.search(null, p);
        for (i, [lo, hi]) in limits.iter().enumerate() {
            let [least, most] = self.bounds[i];
            tensions[i] = match self.x[i] {
                x if x <= least => *lo,
                x if x >= most => *hi,
                x => (middle[i] + unit * scale * x).clamp(*lo, *hi),
            };
        }
        ended
    }

    fn search(&mut self, null: &DMatrix<f64>, p: i32) -> bool {
        self.active.clear();
        self.complete(null);
        for entry in 0..self.x.len() {
            let [least, most] = self.bounds[entry];
            let side = if self.x[entry] <= least { -1.0 } else { 1.0 };
            if self.x[entry] <= least || self.x[entry] >= most {
                self.add(null, Limit { entry, side });
            }
        }
        let mut blocked = 0;
        for _ in 0..ACTIVE_SET_STEPS * (self.x.len() + 1) + NORM_STEPS {
            self.differentiate(null, p);
            if self.newton(null, p) {
                let (most, limit) = self.first_limit();
                let (share, blocks) = self.least_along(p, most, limit.is_some());
                let moved = greatest(&self.change) * share;
                self.x.iter_mut().zip(&self.change).for_each(|(x, change)| *x += share * change);
                if let (true, Some(limit)) = (blocks, limit) {
                    self.x[limit.entry] = self.bounds[limit.entry][usize::from(limit.side > 0.0)];
                    self.add(null, limit);
                    blocked = if moved > NORM_STEP { 0 } else { blocked + 1 };
                    continue;
                }
                if moved > NORM_STEP * greatest(&self.x) {
                    blocked = 0;
                    continue;
                }
            }
            if !self.release(null, p, blocked > 0) {
                return true;
            }
        }
        false
    }

    /// Makes a limit active, if its normal is not a combination of those that are.
    fn add(&mut self, null: &DMatrix<f64>, limit: Limit) {
        self.active.push(limit);
        if self.complete(null) < self.active.len() {
            self.active.pop();
            self.complete(null);
        }
    }

    /// Computes the basis; returns the number of independent normals.
    fn complete(&mut self, null: &DMatrix<f64>) -> usize {
        let r = null.ncols();
        self.basis.clear();
        let mut independent = 0;
        let normals = self.active.len();
        for k in 0..normals + r {
            let start = self.basis.len();
            if start == r * r {
                break;
            }
            match self.active.get(k) {
                Some(limit) => self.basis.extend(null.row(limit.entry).iter().map(|x| x * limit.side)),
                None => self.basis.extend((0..r).map(|j| if j == k - normals { 1.0 } else { 0.0 })),
            }
            let (before, row) = self.basis.split_at_mut(start);
            for _ in 0..2 {
                for other in before.chunks_exact(r) {
                    let share = dot(other, row);
                    row.iter_mut().zip(other).for_each(|(x, along)| *x -= share * along);
                }
            }
            let norm = dot(row, row).sqrt();
            // An axis that the others nearly cover is left out: one of r axes is always far from covered.
            let least = if k < normals { NORM_DEPENDENT } else { 0.5 / (r as f64).sqrt() };
            if norm > least {
                row.iter_mut().for_each(|x| *x /= norm);
                independent += usize::from(k < normals);
            } else {
                self.basis.truncate(start);
            }
        }
        independent
    }

    /// Computes the gradient of Σ xᵖ / p in y.
    fn differentiate(&mut self, null: &DMatrix<f64>, p: i32) {
        self.gradient.clear();
        let x = &self.x;
        self.gradient
            .extend(null.column_iter().map(|column| column.iter().zip(x).map(|(n, x)| n * x.powi(p - 1)).sum::<f64>()));
    }

    /// Computes Newton's step that keeps all active limits; false if the gradient across them is zero.
    fn newton(&mut self, null: &DMatrix<f64>, p: i32) -> bool {
        let (r, fixed) = (null.ncols(), self.active.len());
        let free = r - fixed.min(r);
        let face = &self.basis[fixed.min(r) * r..];
        self.step.clear();
        self.step.extend(face.chunks_exact(r).map(|row| -dot(row, &self.gradient)));
        if self.step.iter().all(|g| g.abs() <= NORM_GRADIENT * self.size(p)) {
            return false;
        }
        self.matrix.clear();
        self.matrix.resize(free * free, 0.0);
        for (i, x) in self.x.iter().enumerate() {
            let weight = f64::from(p - 1) * x.powi(p - 2);
            for a in 0..free {
                let along = across(null, i, &face[a * r..(a + 1) * r]);
                for b in 0..=a {
                    self.matrix[a * free + b] += weight * along * across(null, i, &face[b * r..(b + 1) * r]);
                }
            }
        }
        let most = (0..free).map(|a| self.matrix[a * free + a]).fold(0.0, f64::max);
        if most > 0.0 {
            solve(&mut self.matrix, &mut self.step, f64::EPSILON * most);
        }
        for (i, change) in self.change.iter_mut().enumerate() {
            *change = face.chunks_exact(r).zip(&self.step).map(|(row, step)| step * across(null, i, row)).sum();
        }
        true
    }

    /// The first limit that the step reaches, and at which share of it; the share is infinite without one.
    fn first_limit(&self) -> (f64, Option<Limit>) {
        let mut first = (f64::INFINITY, None);
        let along = NORM_DEPENDENT * dot(&self.step, &self.step).sqrt();
        for (entry, change) in self.change.iter().enumerate() {
            let side = change.signum();
            let is = |limit: &Limit| limit.entry == entry && (limit.side == side || self.is_fixed(entry));
            if change.abs() <= along || self.active.iter().any(is) {
                continue;
            }
            let share = ((self.bounds[entry][usize::from(side > 0.0)] - self.x[entry]) / change).max(0.0);
            if share < first.0 {
                first = (share, Some(Limit { entry, side }));
            }
        }
        first
    }

    /// The share of the step with the least sum, at most this, and whether it is this.
    fn least_along(&self, p: i32, most: f64, limited: bool) -> (f64, bool) {
        let slope = |share: f64| -> [f64; 2] {
            self.x.iter().zip(&self.change).fold([0.0; 2], |[first, second], (x, change)| {
                let power = (x + share * change).powi(p - 2);
                [first + change * power * (x + share * change), second + f64::from(p - 1) * change * change * power]
            })
        };
        if limited && slope(most)[0] <= 0.0 {
            return (most, true);
        }
        let begin = slope(0.0)[0];
        let (mut low, mut high, mut share) = (0.0, most, 1.0_f64.min(most));
        for _ in 0..NORM_STEPS {
            let [first, second] = slope(share);
            if first.abs() <= NORM_GRADIENT.sqrt() * begin.abs() {
                break;
            }
            if first < 0.0 {
                low = share
            } else {
                high = share
            }
            let next = share - first / second;
            share = match next > low && next < high {
                true => next,
                false if high.is_finite() => 0.5 * (low + high),
                false => 2.0 * share,
            };
        }
        (share, false)
    }

    /// What gradients are compared with.
    fn size(&self, p: i32) -> f64 {
        self.x.iter().map(|x| x.abs().powi(p - 1)).sum()
    }

    fn is_fixed(&self, entry: usize) -> bool {
        let [least, most] = self.bounds[entry];
        most <= least
    }

    /// Releases the active limit with the most negative multiplier, or the first with a negative one; false if there is none.
    fn release(&mut self, null: &DMatrix<f64>, p: i32, first: bool) -> bool {
        let (r, count) = (null.ncols(), self.active.len());
        // Normals are the rows of a lower triangular matrix times the basis, so multipliers follow from the last to the first.
        self.multipliers.clear();
        self.multipliers.extend(self.basis.chunks_exact(r).take(count).map(|row| -dot(row, &self.gradient)));
        for k in (0..count).rev() {
            let normal = |k: usize, j: usize| {
                let Limit { entry, side } = self.active[k];
                side * across(null, entry, &self.basis[j * r..(j + 1) * r])
            };
            self.multipliers[k] /= normal(k, k);
            for j in 0..k {
                self.multipliers[j] -= self.multipliers[k] * normal(k, j);
            }
        }
        let least = -NORM_MULTIPLIER * self.size(p);
        let mut chosen: Option<usize> = None;
        for k in 0..count {
            let multiplier = self.multipliers[k];
            let entry = self.active[k].entry;
            if self.is_fixed(entry) || multiplier >= least {
                continue;
            }
            let better = |best: usize| match first {
                true => entry < self.active[best].entry,
                false => multiplier < self.multipliers[best],
            };
            if chosen.is_none_or(better) {
                chosen = Some(k);
            }
        }
        let Some(k) = chosen else { return false };
        self.active.remove(k);
        self.complete(null);
        true
    }
}

fn greatest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| most.max(x.abs()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The change of a tension along a direction in y.
fn across(null: &DMatrix<f64>, cable: usize, direction: &[f64]) -> f64 {
    null.row(cable).iter().zip(direction).map(|(n, y)| n * y).sum()
}

/// Solves a symmetric system by Cholesky's method in place, given its lower triangle row by row; pivots are at least `least`.
fn solve(matrix: &mut [f64], right: &mut [f64], least: f64) {
    let n = right.len();
    for a in 0..n {
        for b in 0..=a {
            let sum: f64 = (0..b).map(|k| matrix[a * n + k] * matrix[b * n + k]).sum();
            let left = matrix[a * n + b] - sum;
            matrix[a * n + b] = if a == b { left.max(least).sqrt() } else { left / matrix[b * n + b] };
        }
    }
    for a in 0..n {
        let sum: f64 = (0..a).map(|k| matrix[a * n + k] * right[k]).sum();
        right[a] = (right[a] - sum) / matrix[a * n + a];
    }
    for a in (0..n).rev() {
        let sum: f64 = (a + 1..n).map(|k| matrix[k * n + a] * right[k]).sum();
        right[a] = (right[a] - sum) / matrix[a * n + a];
    }
}
