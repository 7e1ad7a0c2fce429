//! Checks of many states or motions at once.

use super::validity::{Checker, Validity};
use crate::batch::{BatchOptions, Pace, answer_all};
use crate::error::Error;
use crate::geometry::Point;

/// Whether each position is valid; `position(k)` gives the k-th one.
///
/// # Errors
/// [`Error::interrupted`], or a number of threads that [`thread_count`](crate::watch::thread_count) rejects.
pub fn states_valid(
    validity: &dyn Validity,
    position: impl Fn(usize) -> Point + Sync,
    answers: &mut [bool],
    options: &BatchOptions,
) -> Result<(), Error> {
    answer_all(answers, |k| validity.state_valid(&position(k)), Pace::CHECKS, options)
}

/// Whether each motion is valid; `motion(k)` gives both ends of the k-th one.
///
/// # Errors
/// [`Error::interrupted`], or a number of threads that [`thread_count`](crate::watch::thread_count) rejects.
pub fn motions_valid(
    validity: &dyn Validity,
    motion: impl Fn(usize) -> (Point, Point) + Sync,
    answers: &mut [bool],
    options: &BatchOptions,
) -> Result<(), Error> {
    let question = |k| {
        let (from, to) = motion(k);
        validity.motion_valid(&from, &to)
    };
    answer_all(answers, question, Pace::CHECKS, options)
}

/// The signed clearance of each position, m: the smallest gap in the world, negative where bodies overlap, infinite if
/// there are no gaps to measure; `position(k)` gives the k-th one.
///
/// # Errors
/// [`Error::interrupted`], or a number of threads that [`thread_count`](crate::watch::thread_count) rejects.
pub fn clearances(
    checker: &dyn Checker,
    position: impl Fn(usize) -> Point + Sync,
    answers: &mut [f64],
    options: &BatchOptions,
) -> Result<(), Error> {
    let question = |k| {
        let p = position(k);
        checker.gap(&p, &p).unwrap_or(f64::INFINITY)
    };
    answer_all(answers, question, Pace::CHECKS, options)
}
