//! Ways to end long work early: a deadline, or an interrupt by the caller.
//!
//! Every function that can take longer than about ten milliseconds takes a [`Watch`] and polls it every few
//! milliseconds, on any thread.

use std::time::Duration;

use web_time::Instant;

use crate::error::{Error, ErrorClass};
use crate::limits::{MOST_SECONDS, MOST_THREADS};

/// Returns whether the caller wants to stop; polled often, from any thread.
pub type Interrupt<'a> = dyn Fn() -> bool + Sync + 'a;

/// Unit of a time budget.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TimeUnit {
    /// Second.
    Second,
    /// Millisecond.
    Millisecond,
}

/// Checks a time budget.
///
/// # Errors
/// A number that is not positive, or above [`MOST_SECONDS`].
///
/// # Example
/// ```
/// use cdpr_core::watch::{TimeUnit, time_budget};
/// assert_eq!(time_budget("budget", 0.5, TimeUnit::Second)?.as_millis(), 500);
/// assert!(time_budget("budget", f64::INFINITY, TimeUnit::Second).is_err());
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn time_budget(place: &str, number: f64, unit: TimeUnit) -> Result<Duration, Error> {
    let (name, per_second) = match unit {
        TimeUnit::Second => ("s", 1.0),
        TimeUnit::Millisecond => ("ms", 1e3),
    };
    let most = MOST_SECONDS * per_second;
    let possible = Some(number).filter(|number| *number > 0.0 && *number <= most);
    // A time too short for the clock rounds to zero.
    let budget = possible.map(|number| Duration::from_secs_f64(number / per_second)).filter(|b| !b.is_zero());
    budget.ok_or_else(|| {
        let expected = format!("expected a positive number of at most {most:e}; omit it for no limit");
        Error::invalid(place, format!("found {number} {name}, {expected}"))
    })
}

/// Checks a number of threads.
///
/// # Errors
/// Zero, or more than [`MOST_THREADS`].
pub fn thread_count(threads: usize) -> Result<usize, Error> {
    if (1..=MOST_THREADS).contains(&threads) {
        return Ok(threads);
    }
    Err(Error::invalid("threads", format!("found {threads}, expected at least 1 and at most {MOST_THREADS}")))
}

/// A deadline and an interrupt.
///
/// # Example
/// ```
/// use std::time::Duration;
/// use cdpr_core::Watch;
/// assert!(!Watch::NONE.expired()?);
/// let stop = || true;
/// assert!(Watch::on(&stop).expired().is_err());
/// assert!(Watch::NONE.with_budget(Some(Duration::ZERO)).expired()?);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// When the work should stop, with the best result so far.
    pub deadline: Option<Instant>,
    /// Returns true to end the work with [`Error::interrupted`].
    pub interrupted: &'a Interrupt<'a>,
}

impl Default for Watch<'_> {
    fn default() -> Self {
        Watch::NONE
    }
}

impl<'a> Watch<'a> {
    /// A watch without deadline and interrupt.
    pub const NONE: Watch<'static> = Watch { deadline: None, interrupted: &|| false };

    /// A watch with an interrupt and no deadline.
    pub fn on(interrupted: &'a Interrupt<'a>) -> Self {
        Watch { deadline: None, interrupted }
    }

    /// This watch with a deadline `budget` from now. A budget beyond the range of the clock sets no deadline.
    pub fn with_budget(self, budget: Option<Duration>) -> Self {
        Watch { deadline: budget.and_then(|budget| Instant::now().checked_add(budget)), ..self }
    }

    /// The time left until the deadline; `None` without a deadline.
    pub fn left(&self) -> Option<Duration> {
        self.deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()))
    }

    /// A watch that ends after a share of the time left, if there is a deadline.
    pub fn part(self, share: f64) -> Self {
        self.with_budget(self.left().map(|left| left.mul_f64(share)))
    }

    /// Whether the deadline has passed, for work that has a result even if it ends early.
    ///
    /// # Errors
    /// [`Error::interrupted`] if the caller wants to stop.
    pub fn expired(&self) -> Result<bool, Error> {
        if (self.interrupted)() {
            return Err(Error::interrupted());
        }
        Ok(self.deadline.is_some_and(|deadline| Instant::now() >= deadline))
    }

    /// Checks deadline and interrupt, for work that has no result unless it finishes.
    ///
    /// # Errors
    /// [`Error::interrupted`] if the caller wants to stop, [`Error::out_of_time`] if the deadline has passed.
    pub fn check(&self) -> Result<(), Error> {
        if self.expired()? { Err(Error::out_of_time()) } else { Ok(()) }
    }
}

/// A result, or `None` if the caller wanted to stop first: for optional work on a result that must not be lost.
///
/// # Errors
/// All errors other than an interruption.
pub fn unless_interrupted<T>(answer: Result<T, Error>) -> Result<Option<T>, Error> {
    match answer {
        Err(error) if error.class() == ErrorClass::Interrupted => Ok(None),
        answer => answer.map(Some),
    }
}

/// A result, or `None` if time ran out first.
///
/// # Errors
/// All errors other than running out of time.
pub fn in_time<T>(answer: Result<T, Error>) -> Result<Option<T>, Error> {
    match answer {
        Err(error) if error.class() == ErrorClass::OutOfTime => Ok(None),
        answer => answer.map(Some),
    }
}

/// A result, or `None` if the caller wanted to stop, or time ran out, first.
///
/// # Errors
/// All errors other than an interruption and running out of time.
pub fn unless_stopped<T>(answer: Result<T, Error>) -> Result<Option<T>, Error> {
    Ok(in_time(unless_interrupted(answer))?.flatten())
}

impl std::fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Watch").field("deadline", &self.deadline).finish_non_exhaustive()
    }
}
