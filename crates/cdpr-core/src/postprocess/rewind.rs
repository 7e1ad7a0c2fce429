//! Rewinding, Algorithms 4 and 5 of the paper: shortens the path from one end, then from the other.
//!
//! Interpretation: as printed the algorithms never end, because the last step of a segment "rewinds" onto the neighbour
//! that a waypoint already has; here the path must become strictly shorter. After a success the new point becomes the
//! next reference. k = 0 is the plain shortcut between two waypoints. Forward rewinding is backward rewinding of the
//! reversed path.

use crate::choices;
use crate::collision::Validity;
use crate::error::Error;
use crate::planning::StateSpace;
use crate::tolerances::{SHORTER, STEP_COUNT};
use crate::watch::Watch;

/// Which of the two rewindings run, and in which order (the paper, section 5.2).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Order {
    /// Tries both of the following orders and keeps the shorter result, as the paper recommends.
    #[default]
    Both,
    /// Backward rewinding, then forward.
    Backward,
    /// Forward rewinding, then backward.
    Forward,
    /// Backward rewinding alone (Algorithm 4): connects the last waypoint to the earliest point to which it can be
    /// connected.
    BackwardOnly,
    /// Forward rewinding alone (Algorithm 5): connects the first waypoint to the latest point to which it can be
    /// connected.
    ForwardOnly,
}

choices!(Order, "order", [
    Both = "both": "Rewind in both orders and keep the shorter result",
    Backward = "backward": "Rewind backward, then forward",
    Forward = "forward": "Rewind forward, then backward",
    BackwardOnly = "backward-only": "Rewind backward (the paper, Algorithm 4)",
    ForwardOnly = "forward-only": "Rewind forward (the paper, Algorithm 5)",
]);

/// Options of [`rewind`].
#[derive(Debug, Clone, PartialEq)]
pub struct RewindOptions {
    /// Spacing of the points tried along each segment, m, > 0.
    pub step: f64,
    /// Order of the rewindings.
    pub order: Order,
    /// Maximum number of times that the rewindings run; they end early if the path does not become shorter.
    pub repeats: usize,
}

impl Default for RewindOptions {
    fn default() -> Self {
        RewindOptions { step: 0.1, order: Order::Both, repeats: 1 }
    }
}

impl RewindOptions {
    /// Checks the options.
    ///
    /// # Errors
    /// A step that is not positive and finite.
    pub fn checked(self) -> Result<Self, Error> {
        if self.step > 0.0 && self.step.is_finite() {
            return Ok(self);
        }
        Err(Error::invalid("step", format!("found {} m, expected a positive number", self.step)))
    }
}

/// Shortens a path whose segments are valid; the result is valid, has the same ends and is never longer.
///
/// # Errors
/// Invalid options, or [`Error::interrupted`] if the watch requests it.
///
/// # Source
/// The paper, section 4, Algorithms 4 and 5.
pub fn rewind<S: StateSpace>(
    space: &S,
    validity: &dyn Validity<S::State>,
    waypoints: &[S::State],
    options: &RewindOptions,
    watch: &Watch,
) -> Result<Vec<S::State>, Error> {
    let options = options.clone().checked()?;
    let rewinder = Rewinder { space, validity, step: options.step, watch };
    let run = |directions: &[Direction]| {
        let mut path = waypoints.to_vec();
        for _ in 0..options.repeats {
            let before = space.length(&path);
            directions.iter().try_for_each(|direction| rewinder.rewind(&mut path, *direction))?;
            if !(space.length(&path) < before) {
                break;
            }
        }
        Ok::<_, Error>(path)
    };
    use Direction::{Backward, Forward};
    match options.order {
        Order::BackwardOnly => run(&[Backward]),
        Order::ForwardOnly => run(&[Forward]),
        Order::Backward => run(&[Backward, Forward]),
        Order::Forward => run(&[Forward, Backward]),
        Order::Both => {
            let backward_first = run(&[Backward, Forward])?;
            let forward_first = run(&[Forward, Backward])?;
            let shorter = space.length(&forward_first) < space.length(&backward_first);
            Ok(if shorter { forward_first } else { backward_first })
        }
    }
}

/// The end of a path at which a rewinding starts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Direction {
    Backward,
    Forward,
}

/// The waypoint to which a reference is connected, or the new point on the segment that follows it.
type Connection<State> = Option<(usize, Option<State>)>;

/// Points tried between two checks of the watch.
const POLL: usize = 64;

struct Rewinder<'a, S: StateSpace> {
    space: &'a S,
    validity: &'a dyn Validity<S::State>,
    step: f64,
    watch: &'a Watch<'a>,
}

impl<S: StateSpace> Rewinder<'_, S> {
    fn rewind(&self, path: &mut Vec<S::State>, direction: Direction) -> Result<(), Error> {
        if direction == Direction::Forward {
            path.reverse();
        }
        self.backward(path)?;
        if direction == Direction::Forward {
            path.reverse();
        }
        Ok(())
    }

    /// Algorithm 4: connects every reference waypoint, starting at the last, to the earliest point of the path to which
    /// it can be connected, and removes what lies between.
    fn backward(&self, path: &mut Vec<S::State>) -> Result<(), Error> {
        let mut reference = path.len().saturating_sub(1);
        while reference >= 2 && !self.watch.expired()? {
            reference = match self.earliest_connection(path, reference)? {
                Some((j, None)) => {
                    path.drain(j + 1..reference);
                    j
                }
                Some((j, Some(x_step))) => {
                    path.splice(j + 1..reference, [x_step]);
                    j + 1
                }
                None => reference - 1,
            };
        }
        Ok(())
    }

    /// The first point along the path, a waypoint j or a step after it, that can be connected to the reference and
    /// shortens the path.
    fn earliest_connection(&self, path: &[S::State], reference: usize) -> Result<Connection<S::State>, Error> {
        let x_i = &path[reference];
        let mut old = self.space.length(&path[..=reference]); // along the path from x_j to the reference
        let mut tried = 0usize;
        for j in 0..=reference - 2 {
            let (x_j, x_next) = (&path[j], &path[j + 1]);
            let segment = self.space.distance(x_j, x_next);
            let steps = (segment / self.step * (1.0 + STEP_COUNT)).floor() as usize;
            for k in 0..=steps {
                if tried.is_multiple_of(POLL) && self.watch.expired()? {
                    return Ok(None); // what has been rewound so far is a path
                }
                tried += 1;
                let along = k as f64 * self.step;
                let x_step =
                    if k == 0 { *x_j } else { self.space.interpolate(x_j, x_next, (along / segment).min(1.0)) };
                let new = self.space.distance(x_j, &x_step) + self.space.distance(&x_step, x_i);
                if new < old - SHORTER && self.connects(x_j, &x_step, x_i, k) {
                    return Ok(Some((j, (k > 0).then_some(x_step))));
                }
            }
            old -= segment;
        }
        Ok(None)
    }

    /// `FeasibleToRewind`: the new connection is valid, and so is the piece of the old segment that leads to it. (That
    /// piece is part of a valid motion, but its end is rounded.)
    fn connects(&self, x_j: &S::State, x_step: &S::State, x_i: &S::State, k: usize) -> bool {
        self.validity.motion_valid(x_step, x_i) && (k == 0 || self.validity.motion_valid(x_j, x_step))
    }
}
