//! Whether there is a path at all, decided on a second thread while the planner searches.
//!
//! Which of the two is done first changes only how long it takes: a path of the planner takes precedence over one of the decision,
//! which is used only after the planner has failed, and a planner finds nothing where it is proved that there is no path. An
//! exception are paths that keep no gap at all, such as a bent path through slits without width: planners hardly ever find them.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::{Improved, PlanOptions};
use crate::collision::Checker;
use crate::error::{Error, ErrorClass};
use crate::geometry::Point;
use crate::numerics::{PROOF_EFFORT, PROOF_EFFORT_PER_SAMPLE};
use crate::planning::{Outcome, PathOptimizer, Status};
use crate::proof::{Answer, decide};
use crate::watch::Watch;

/// Head start of the planner: most scenes are solved before a proof would be of use.
const HEAD_START: Duration = Duration::from_millis(1);

/// How a search ended.
pub enum Decided {
    /// The planner's result, and what is known of the width of openings if it found no path, m.
    Searched(Outcome<Point>, Option<f64>),
    /// The planner's result with a path of the decision, because the planner found none.
    Rescued(Outcome<Point>),
    /// There is no path.
    NoPath(Box<crate::proof::Proof>),
}

/// Runs the planner, given a watch and whom to tell of better paths, and beside it the decision.
pub fn search_and_decide(
    engine: &dyn Checker,
    [start, goal]: [&Point; 2],
    (options, known): (&PlanOptions, Option<&Answer>),
    (improved, watch): (&Improved, &Watch),
    puller: &dyn PathOptimizer<Point>,
    search: impl FnOnce(&Improved, &Watch) -> Result<Outcome<Point>, Error>,
) -> Result<Decided, Error> {
    if let (true, Some(answer)) = (options.proof, known) {
        if let Answer::NoPath(proof) = answer {
            return Ok(Decided::NoPath(proof.clone()));
        }
        return conclude(search(improved, watch), Some(answer.clone()), puller, watch);
    }
    let effort = options.planner.limits().max_samples.saturating_mul(PROOF_EFFORT_PER_SAMPLE).min(PROOF_EFFORT);
    if !options.proof || effort == 0 {
        return search(improved, watch).map(|outcome| Decided::Searched(outcome, None));
    }
    let (found, none, begun) = (AtomicBool::new(false), AtomicBool::new(false), AtomicBool::new(false));
    let decision = || {
        let useless = || found.load(Ordering::Relaxed) || (watch.interrupted)();
        let answer = decide(engine, [start, goal], effort, &Watch { interrupted: &useless, ..*watch }).ok();
        none.store(matches!(answer, Some(Answer::NoPath(_))), Ordering::Relaxed);
        answer
    };
    let clock = Instant::now();
    let (outcome, answer) = thread::scope(|scope| {
        let beside = Mutex::new(None);
        // The planner polls this: scenes that it solves quickly never start a thread.
        let stop = || {
            let late =
                !begun.load(Ordering::Relaxed) && !found.load(Ordering::Relaxed) && clock.elapsed() >= HEAD_START;
            if late && !begun.swap(true, Ordering::Relaxed) {
                // Where no thread can be started the decision follows the search.
                *lock(&beside) = thread::Builder::new().spawn_scoped(scope, decision).ok();
            }
            none.load(Ordering::Relaxed) || (watch.interrupted)()
        };
        let better = |seconds: f64, cost: f64, path: &[Point]| {
            found.store(true, Ordering::Relaxed);
            improved(seconds, cost, path);
        };
        let outcome = search(&better, &Watch { interrupted: &stop, ..*watch });
        let solved = outcome.as_ref().is_ok_and(|outcome| outcome.status == Status::Solved);
        found.fetch_or(solved, Ordering::Relaxed);
        let beside = lock(&beside).take();
        let answer = match beside {
            Some(beside) => beside.join().expect("the decision does not panic"),
            None if solved => None,
            None => decision(),
        };
        (outcome, answer)
    });
    conclude(outcome, answer, puller, watch)
}

fn lock<T>(value: &Mutex<T>) -> MutexGuard<'_, T> {
    value.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What the planner's result and the decision say together.
fn conclude(
    outcome: Result<Outcome<Point>, Error>,
    answer: Option<Answer>,
    puller: &dyn PathOptimizer<Point>,
    watch: &Watch,
) -> Result<Decided, Error> {
    let stopped = |error: &Error| error.class() == ErrorClass::Interrupted;
    match (outcome, answer) {
        (Ok(outcome), _) if outcome.status == Status::Solved => Ok(Decided::Searched(outcome, None)),
        (Ok(_), Some(Answer::NoPath(proof))) => Ok(Decided::NoPath(proof)),
        (Err(error), Some(Answer::NoPath(proof))) if stopped(&error) => Ok(Decided::NoPath(proof)),
        (Ok(outcome), Some(Answer::Path(path))) => {
            let waypoints = puller.polished(&path, watch)?;
            Ok(Decided::Rescued(Outcome { status: Status::Solved, waypoints, ..outcome }))
        }
        (Ok(outcome), Some(Answer::OpeningBelow(width))) => Ok(Decided::Searched(outcome, Some(width))),
        (Ok(outcome), None) => Ok(Decided::Searched(outcome, None)),
        (Err(error), _) => Err(error),
    }
}
