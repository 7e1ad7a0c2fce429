//! What a rewinding asks on its way: the motions that the paper's Figure 5 draws.

use std::sync::{Mutex, PoisonError};

use super::rewind::{Direction, rewind_once};
use crate::collision::{Clearance, Validity, Violation};
use crate::error::Error;
use crate::planning::StateSpace;
use crate::watch::Watch;

/// A motion that was asked about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Try<State> {
    /// Where it starts.
    pub from: State,
    /// Where it ends.
    pub to: State,
    /// The answer.
    pub valid: bool,
}

/// A path rewound once, and what was asked for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace<State> {
    /// The path afterwards.
    pub path: Vec<State>,
    /// In the order in which they were asked; of forward rewinding in the direction of the reversed path.
    pub tries: Vec<Try<State>>,
}

/// Rewinds a path once, in one direction, and keeps every motion asked about.
///
/// # Errors
/// As [`rewind`](super::rewind()).
pub fn rewind_traced<S: StateSpace>(
    space: &S,
    validity: &dyn Validity<S::State>,
    waypoints: &[S::State],
    step: f64,
    direction: Direction,
    watch: &Watch,
) -> Result<Trace<S::State>, Error>
where
    S::State: Send,
{
    let recorder = Recorder { validity, tries: Mutex::default() };
    let path = rewind_once(space, &recorder, waypoints, step, direction, watch)?;
    Ok(Trace { path, tries: recorder.tries.into_inner().unwrap_or_else(PoisonError::into_inner) })
}

/// An engine that remembers which motions it was asked about.
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
