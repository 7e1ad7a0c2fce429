//! The motions that a rewinding checks, as drawn in the paper's Figure 5.

use std::sync::{Mutex, PoisonError};

use super::rewind::{RewindOptions, rewind};
use crate::collision::{Clearance, Validity, Violation};
use crate::error::Error;
use crate::planning::StateSpace;
use crate::watch::Watch;

/// A motion that was checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Try<State> {
    /// Start of the motion.
    pub from: State,
    /// End of the motion.
    pub to: State,
    /// Whether the motion was valid.
    pub valid: bool,
}

/// A path after rewinding, with the motions checked for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace<State> {
    /// The path after rewinding.
    pub path: Vec<State>,
    /// Checked motions, in order; for forward rewinding in the direction of the reversed path.
    pub tries: Vec<Try<State>>,
}

/// Rewinds a path and records every motion that it checks.
///
/// # Errors
/// The errors of [`rewind`](super::rewind()).
pub fn rewind_traced<S: StateSpace>(
    space: &S,
    validity: &dyn Validity<S::State>,
    waypoints: &[S::State],
    options: &RewindOptions,
    watch: &Watch,
) -> Result<Trace<S::State>, Error>
where
    S::State: Send,
{
    let recorder = Recorder { validity, tries: Mutex::default() };
    let path = rewind(space, &recorder, waypoints, options, watch)?;
    Ok(Trace { path, tries: recorder.tries.into_inner().unwrap_or_else(PoisonError::into_inner) })
}

/// An engine that records the motions that it checks.
struct Recorder<'a, State> {
    validity: &'a dyn Validity<State>,
    tries: Mutex<Vec<Try<State>>>,
}

impl<State: Copy + Send> Validity<State> for Recorder<'_, State> {
    fn state_valid(&self, state: &State) -> bool {
        self.validity.state_valid(state)
    }

    fn motion_valid(&self, from: &State, to: &State) -> bool {
        let valid = self.validity.motion_valid(from, to);
        self.tries.lock().unwrap_or_else(PoisonError::into_inner).push(Try { from: *from, to: *to, valid });
        valid
    }

    fn violations(&self, from: &State, to: &State) -> Vec<Violation> {
        self.validity.violations(from, to)
    }

    fn clearance(&self, from: &State, to: &State) -> Option<Clearance> {
        self.validity.clearance(from, to)
    }
}
