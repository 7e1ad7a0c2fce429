//! Whether there is a path at all, decided on a second thread while the planner searches.
//!
//! Which of the two is done first changes only how long it takes: a path of the planner takes precedence over one of the decision,
//! which is used only after the planner has failed, and a planner finds nothing where it is proved that there is no path. An
//! exception are paths that keep no gap at all, such as a bent path through slits without width: planners hardly ever find them.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

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
    let (found, none) = (AtomicBool::new(false), AtomicBool::new(false));
    let decision = || {
        thread::park_timeout(HEAD_START);
        let useless = || found.load(Ordering::Relaxed) || (watch.interrupted)();
        if useless() {
            return None;
        }
        let answer = decide(engine, [start, goal], effort, &Watch { interrupted: &useless, ..*watch }).ok();
        none.store(matches!(answer, Some(Answer::NoPath(_))), Ordering::Relaxed);
        answer
    };
    let (outcome, answer) = thread::scope(|scope| {
        // Without a second thread the decision follows the search.
        let beside = thread::Builder::new().spawn_scoped(scope, decision).ok();
        let stop = || none.load(Ordering::Relaxed) || (watch.interrupted)();
        let better = |seconds: f64, cost: f64, path: &[Point]| {
            found.store(true, Ordering::Relaxed);
            improved(seconds, cost, path);
        };
        let outcome = search(&better, &Watch { interrupted: &stop, ..*watch });
        let solved = outcome.as_ref().is_ok_and(|outcome| outcome.status == Status::Solved);
        found.fetch_or(solved, Ordering::Relaxed);
        let answer = match beside {
            Some(beside) => {
                beside.thread().unpark();
                beside.join().expect("the decision does not panic")
            }
            None => decision(),
        };
        (outcome, answer)
    });
    conclude(outcome, answer, puller, watch)
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
            Ok(Decided::Searched(Outcome { status: Status::Solved, waypoints, ..outcome }, None))
        }
        (Ok(outcome), Some(Answer::OpeningBelow(width))) => Ok(Decided::Searched(outcome, Some(width))),
        (Ok(outcome), None) => Ok(Decided::Searched(outcome, None)),
        (Err(error), _) => Err(error),
    }
}
