//! The point of a slice nearest to the origin of its directions, by the dual active-set method.
//!
//! D. Goldfarb and A. Idnani, "A numerically stable dual method for solving strictly convex quadratic programs",
//! Mathematical Programming 27, 1983, with the identity as Hessian. The method starts from y = 0, or from limits
//! guessed active. It adds the most violated limit and drops limits whose multiplier would become negative. Every step
//! increases the distance, so the method terminates: with a point, or with limits that no y satisfies together.

use nalgebra::{DMatrix, DVector};

use super::slice::Slice;
use crate::limits::ACTIVE_SET_STEPS;
use crate::tolerances::{DEPENDENT_NORMALS, DEPENDENT_NORMALS_AT_LEAST, LIMIT_RELATIVE, LIMIT_ROUNDING, LIMIT_SLACK};

/// Result of the search for the nearest point.
pub(super) enum Nearest {
    /// `point + null y` within its limits; active limits are met exactly.
    At(DVector<f64>),
    /// No y satisfies all limits; the direction proves it, see [`Slice::separated_by`].
    Nowhere(DVector<f64>),
    /// Undecided because of rounding.
    Unsettled,
}

/// One limit of one entry; `side` is 1 for the upper one, −1 for the lower one.
#[derive(Clone, Copy)]
pub(super) struct Limit {
    pub(super) entry: usize,
    pub(super) side: f64,
}

/// The y nearest to 0 whose `point + null y` is in the box, starting from limits that may be active.
///
/// If limits are only just compatible, the active set may not settle. Then the limits are widened by half the
/// tolerance, first with the same threshold for dependent limits, then with a smaller one.
pub(super) fn nearest(slice: &Slice, guess: &[Limit]) -> Nearest {
    match attempt(slice, guess, LIMIT_ROUNDING, DEPENDENT_NORMALS) {
        Nearest::Unsettled => {}
        settled => return settled,
    }
    let wider = slice.widened(LIMIT_SLACK);
    for dependent in [DEPENDENT_NORMALS, DEPENDENT_NORMALS_AT_LEAST] {
        match attempt(&wider, &[], LIMIT_SLACK, dependent) {
            Nearest::At(x) => return Nearest::At(slice.put_back(x)),
            Nearest::Nowhere(direction) => return Nearest::Nowhere(direction),
            Nearest::Unsettled => {}
        }
    }
    Nearest::Unsettled
}

/// One run. Limits violated by at most `passing` count as met, and normals whose linearly independent part is less than
/// `dependent` count as dependent.
fn attempt(slice: &Slice, guess: &[Limit], passing: f64, dependent: f64) -> Nearest {
    let mut set = ActiveSet::start(slice, guess, dependent);
    for _ in 0..ACTIVE_SET_STEPS * (slice.point.len() + 1) {
        let (passed, by) = set.farthest_passed();
        if by <= passing {
            break;
        }
        if let Err(direction) = set.take_in(passed) {
            match slice.separated_by(&direction) {
                true => return Nearest::Nowhere(direction),
                false if by > LIMIT_SLACK => return Nearest::Unsettled,
                false => break, // limits that contradict each other by no more than the tolerance count as compatible
            }
        }
    }
    set.point().map_or(Nearest::Unsettled, Nearest::At)
}

struct ActiveSet<'a> {
    slice: &'a Slice<'a>,
    dependent: f64,
    limits: Vec<Limit>,
    /// One multiplier ≥ 0 for each limit; `y + Σ multiplier · normal = 0`.
    multipliers: DVector<f64>,
    y: DVector<f64>,
}

impl<'a> ActiveSet<'a> {
    /// The nearest point on those guessed limits that together keep y away from 0.
    fn start(slice: &'a Slice<'a>, guess: &[Limit], dependent: f64) -> Self {
        let none = DVector::zeros(0);
        let mut set =
            Self { slice, dependent, limits: Vec::new(), multipliers: none, y: DVector::zeros(slice.freedom()) };
        for limit in guess {
            let normal = set.normal(*limit);
            if set.split(&normal).0.norm() > dependent {
                set.limits.push(*limit);
            }
        }
        set.settle();
        while let Some(worst) = (0..set.limits.len()).find(|i| set.multipliers[*i] < 0.0) {
            set.limits.remove(worst);
            set.settle();
        }
        set
    }

    /// Outward normal of a limit, in y.
    fn normal(&self, limit: Limit) -> DVector<f64> {
        self.slice.null.row(limit.entry).transpose() * limit.side
    }

    /// Largest value that `normal · y` may have.
    fn level(&self, Limit { entry, side }: Limit) -> f64 {
        let bound = if side > 0.0 { self.slice.upper[entry] } else { self.slice.lower[entry] };
        side * (bound - self.slice.point[entry])
    }

    fn farthest_passed(&self) -> (Limit, f64) {
        let moved = self.slice.null * &self.y;
        let mut farthest = (Limit { entry: 0, side: 1.0 }, f64::NEG_INFINITY);
        for entry in 0..moved.len() {
            for side in [1.0, -1.0] {
                let limit = Limit { entry, side };
                let by = side * moved[entry] - self.level(limit);
                if by > farthest.1 && !self.limits.iter().any(|l| l.entry == entry && l.side == side) {
                    farthest = (limit, by);
                }
            }
        }
        farthest
    }

    /// The component of a vector orthogonal to all active normals, and its coefficients along them.
    fn split(&self, vector: &DVector<f64>) -> (DVector<f64>, DVector<f64>) {
        let Some((q, r)) = self.factors() else { return (vector.clone(), DVector::zeros(0)) };
        let along = q.tr_mul(vector);
        let mut across = vector - &q * &along;
        across -= &q * q.tr_mul(&across); // repeated to remove the rounding error of the first pass
        let shares = r.solve_upper_triangular(&along).unwrap_or_else(|| DVector::zeros(self.limits.len()));
        (across, shares)
    }

    fn factors(&self) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
        if self.limits.is_empty() {
            return None;
        }
        let normals: Vec<_> = self.limits.iter().map(|l| self.normal(*l)).collect();
        Some(DMatrix::from_columns(&normals).qr().unpack())
    }

    /// Recomputes y and the multipliers from the active limits, so that rounding errors do not accumulate.
    fn settle(&mut self) {
        let Some((q, r)) = self.factors() else {
            self.y.fill(0.0);
            self.multipliers = DVector::zeros(0);
            return;
        };
        let levels = DVector::from_iterator(self.limits.len(), self.limits.iter().map(|l| self.level(*l)));
        if let Some(heights) = r.tr_solve_upper_triangular(&levels)
            && let Some(shares) = r.solve_upper_triangular(&heights)
        {
            self.y = q * heights;
            self.multipliers = -shares;
        }
    }

    /// Moves y onto a limit that it violates, dropping limits that block it. If the active limits contradict the new
    /// one, returns the direction, over the entries, that proves it.
    fn take_in(&mut self, passed: Limit) -> Result<(), DVector<f64>> {
        let normal = self.normal(passed);
        for _ in 0..=self.limits.len() {
            let (across, shares) = self.split(&normal);
            let independent = across.norm() > self.dependent;
            let by = normal.dot(&self.y) - self.level(passed);
            let reach = if independent { by / across.norm_squared() } else { f64::INFINITY };
            let (blocking, until) = self.first_to_vanish(&shares);
            if reach <= until && independent {
                self.limits.push(passed);
                self.settle();
                return Ok(());
            }
            if until == f64::INFINITY {
                return Err(self.contradiction(passed, &shares));
            }
            if independent {
                self.y.axpy(-until, &across, 1.0);
            }
            self.multipliers.axpy(-until, &shares, 1.0);
            self.limits.remove(blocking);
            self.multipliers = self.multipliers.clone().remove_row(blocking);
        }
        Ok(())
    }

    /// Which multiplier is the first to fall to 0 at the given rates, and when.
    fn first_to_vanish(&self, rates: &DVector<f64>) -> (usize, f64) {
        let time = |i: &usize| self.multipliers[*i].max(0.0) / rates[*i];
        let falling = (0..rates.len()).filter(|i| rates[*i] > 0.0);
        falling.map(|i| (i, time(&i))).fold((0, f64::INFINITY), |first, new| if new.1 < first.1 { new } else { first })
    }

    /// The combination of limits in which y cancels; what remains does not depend on y.
    fn contradiction(&self, passed: Limit, shares: &DVector<f64>) -> DVector<f64> {
        let mut direction = DVector::zeros(self.slice.point.len());
        direction[passed.entry] += passed.side;
        for (limit, share) in self.limits.iter().zip(shares) {
            direction[limit.entry] -= limit.side * share;
        }
        direction
    }

    /// The point found, if it satisfies its limits and the multipliers are those of a nearest point.
    fn point(&self) -> Option<DVector<f64>> {
        let mut point = self.slice.within(&self.y)?;
        for limit in &self.limits {
            let bounds = if limit.side > 0.0 { &self.slice.upper } else { &self.slice.lower };
            point[limit.entry] = bounds[limit.entry];
        }
        self.multipliers.iter().all(|u| *u >= -LIMIT_RELATIVE).then_some(point)
    }
}
