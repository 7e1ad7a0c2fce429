//! Decides whether there is a path at all while the planner searches: on a second thread, or alternating on one thread.
//!
//! Which of the two finishes first affects only the time taken. The planner's path takes precedence; a path from the decision is
//! used only after the planner has failed, and where a proof shows that there is no path, the planner cannot find one. The only
//! exception is a path that keeps no gap at all, such as a bent path through slits of zero width, which planners hardly ever
//! find. An error of the decision is reported unless the planner has a path.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use web_time::Instant;

use super::{Improved, PlanOptions};
use crate::batch::THREADS;
use crate::collision::Checker;
use crate::error::{Error, ErrorClass};
use crate::geometry::Point;
use crate::limits::{PROOF_EFFORT, PROOF_EFFORT_PER_SAMPLE};
use crate::planning::{Outcome, PathOptimizer, Status};
use crate::proof::{Answer, decide_with};
use crate::watch::{Watch, unless_stopped};

/// Head start of the planner: most scenes are solved before a proof would be of use.
const HEAD_START: Duration = Duration::from_millis(1);

/// The planner's first turn where the two share one thread.
const FIRST_TURN: Duration = Duration::from_millis(10);

/// Whether to start a second thread: not in the browser page, which has only one, nor on a worker of a thread pool,
/// where every core is busy. Parts of the decision run in the pool, so a worker that waited for the second thread could
/// wait forever.
fn has_second_thread() -> bool {
    THREADS && rayon::current_thread_index().is_none()
}

/// How a search ended.
pub enum Decided {
    /// The planner's result and, if it found no path, an upper bound of the width of an opening that every path passes,
    /// m, if known.
    Searched(Outcome<Point>, Option<f64>),
    /// The planner's result with a path of the decision, because the planner found none.
    Rescued(Outcome<Point>),
    /// There is no path; the proof.
    NoPath(Box<crate::proof::Proof>),
}

/// Runs the planner `search` and, beside it, the decision whether there is a path; `improved` is called with every better path.
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
        return conclude((search(improved, watch), Ok(Some(answer.clone()))), puller, watch);
    }
    let effort = options.planner.limits.max_samples.saturating_mul(PROOF_EFFORT_PER_SAMPLE).min(PROOF_EFFORT);
    if !options.proof || effort == 0 {
        return search(improved, watch).map(|outcome| Decided::Searched(outcome, None));
    }
    let decision = Decision { engine, ends: [start, goal], effort, found: AtomicBool::new(false) };
    let ended = if has_second_thread() {
        side_by_side(&decision, (improved, watch), search)
    } else {
        in_turns(&decision, FIRST_TURN, (improved, watch), search)
    };
    conclude(ended, puller, watch)
}

/// Result of the decision; `None` if it was stopped, or ran out of time.
type Decisive = Result<Option<Answer>, Error>;

/// Results of the planner and of the decision.
type Ended = (Result<Outcome<Point>, Error>, Decisive);

/// The decision whether there is a path; it stops as soon as the planner has one.
struct Decision<'a> {
    engine: &'a dyn Checker,
    ends: [&'a Point; 2],
    effort: usize,
    found: AtomicBool,
}

impl Decision<'_> {
    /// Calls `on_no_path` as soon as it is certain that there is no path; that is then the answer.
    fn answer(&self, on_no_path: &dyn Fn(), watch: &Watch) -> Decisive {
        let useless = || self.is_useless() || (watch.interrupted)();
        let watch = Watch { interrupted: &useless, ..*watch };
        unless_stopped(decide_with(self.engine, self.ends, self.effort, on_no_path, &watch))
    }

    fn is_useless(&self) -> bool {
        self.found.load(Ordering::Relaxed)
    }

    /// Runs the planner, and notes when it has a path.
    fn searched(
        &self,
        search: impl FnOnce(&Improved, &Watch) -> Result<Outcome<Point>, Error>,
        (improved, watch): (&Improved, &Watch),
    ) -> Result<Outcome<Point>, Error> {
        let better = |seconds: f64, cost: f64, path: &[Point]| {
            self.found.store(true, Ordering::Relaxed);
            improved(seconds, cost, path);
        };
        let outcome = search(&better, watch);
        let solved = outcome.as_ref().is_ok_and(|outcome| outcome.status == Status::Solved);
        self.found.fetch_or(solved, Ordering::Relaxed);
        outcome
    }
}

/// The planner on this thread, the decision on another one.
fn side_by_side(
    decision: &Decision,
    (improved, watch): (&Improved, &Watch),
    search: impl FnOnce(&Improved, &Watch) -> Result<Outcome<Point>, Error>,
) -> Ended {
    let (none, begun) = (AtomicBool::new(false), AtomicBool::new(false));
    let beside = || decision.answer(&|| none.store(true, Ordering::Relaxed), watch);
    let clock = Instant::now();
    thread::scope(|scope| {
        let thread = Mutex::new(None);
        // The planner polls this: scenes that it solves quickly never start a thread.
        let stop = || {
            let late = !begun.load(Ordering::Relaxed) && !decision.is_useless() && clock.elapsed() >= HEAD_START;
            if late && !begun.swap(true, Ordering::Relaxed) {
                // If no thread can be started, the decision follows the search.
                *lock(&thread) = thread::Builder::new().spawn_scoped(scope, beside).ok();
            }
            none.load(Ordering::Relaxed) || (watch.interrupted)()
        };
        let outcome = decision.searched(search, (improved, &Watch { interrupted: &stop, ..*watch }));
        let thread = lock(&thread).take();
        let answer = match thread {
            Some(thread) => thread.join().expect("the decision does not panic"),
            None if decision.is_useless() => Ok(None),
            None => beside(),
        };
        (outcome, answer)
    })
}

/// Alternates planner and decision on this thread. When the planner polls after the end of its turn, the decision
/// restarts and may run for as long as everything before it took. So each waits for the other for about as long as it
/// runs itself.
fn in_turns(
    decision: &Decision,
    first: Duration,
    (improved, watch): (&Improved, &Watch),
    search: impl FnOnce(&Improved, &Watch) -> Result<Outcome<Point>, Error>,
) -> Ended {
    let (clock, turns) = (Instant::now(), Mutex::new((first, Ok(None))));
    let stop = || {
        let (next, answer) = &mut *lock(&turns);
        if matches!(answer, Ok(None)) && !decision.is_useless() && clock.elapsed() >= *next {
            let end = Instant::now() + clock.elapsed();
            let deadline = Some(watch.deadline.map_or(end, |deadline| deadline.min(end)));
            // A decision that its turn leaves undecided may succeed in the next turn.
            let certain = |answer: &Answer| !matches!(answer, Answer::OpeningBelow(_));
            *answer = decision.answer(&|| (), &Watch { deadline, ..*watch }).map(|answer| answer.filter(certain));
            *next = 2 * clock.elapsed();
        }
        matches!(answer, Ok(Some(Answer::NoPath(_)))) || (watch.interrupted)()
    };
    let outcome = decision.searched(search, (improved, &Watch { interrupted: &stop, ..*watch }));
    let (_, answer) = turns.into_inner().unwrap_or_else(PoisonError::into_inner);
    let answer = match answer {
        _ if decision.is_useless() => Ok(None),
        Ok(None) => decision.answer(&|| (), watch),
        answer => answer,
    };
    (outcome, answer)
}

fn lock<T>(value: &Mutex<T>) -> MutexGuard<'_, T> {
    value.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Combines the planner's result with the decision.
fn conclude((outcome, answer): Ended, puller: &dyn PathOptimizer<Point>, watch: &Watch) -> Result<Decided, Error> {
    let stopped = |error: &Error| error.class() == ErrorClass::Interrupted;
    if let Ok(found) = &outcome
        && found.status == Status::Solved
    {
        return outcome.map(|found| Decided::Searched(found, None));
    }
    match (outcome, answer?) {
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::collision::{Clearance, CspaceEngine, Interference, Piece, Polyhedron, Validity, Violation};
    use crate::conditions::Conditions;
    use crate::model::Scene;
    use crate::planning::{Problem, TranslationSpace};
    use crate::postprocess::StringPuller;
    use crate::testing::{hard3, scene, walled};
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    /// The results for a scene, once side by side and once in turns.
    fn both(scene: &crate::Scene) -> [Ended; 2] {
        both_by(&CspaceEngine::new(scene, Interference::Exact).unwrap(), scene)
    }

    fn both_by(engine: &dyn Checker, scene: &crate::Scene) -> [Ended; 2] {
        let [start, goal] = [scene.start().unwrap(), scene.goal().unwrap()];
        let (options, puller) = (PlanOptions::paper(), StringPuller::new(engine));
        let problem = Problem { space: TranslationSpace::of(engine.conditions()), start, goal };
        let search = |improved: &Improved, watch: &Watch| {
            let mut rng = ChaCha8Rng::seed_from_u64(0);
            options.planner.search(&problem, engine, &puller, improved, &mut rng, watch)
        };
        let decision =
            || Decision { engine, ends: [&start, &goal], effort: PROOF_EFFORT, found: AtomicBool::new(false) };
        let rest: (&Improved, &Watch) = (&|_, _, _| (), &Watch::NONE);
        [side_by_side(&decision(), rest, search), in_turns(&decision(), Duration::ZERO, rest, search)]
    }

    #[test]
    fn one_thread_answers_as_two_do() {
        let [two, one] = both(&hard3());
        assert_eq!(two.0.unwrap().waypoints, one.0.unwrap().waypoints);
        assert!(matches!(one.1, Ok(None)));
        let [two, one] = both(&scene(walled(0.94)));
        let [two, one] = [two, one].map(|ended| ended.1.unwrap());
        let (Some(Answer::NoPath(two)), Some(Answer::NoPath(one))) = (two, one) else { panic!("there is no path") };
        assert_eq!(two.blocking, one.blocking);
    }

    /// An engine that fails when it is asked for its polyhedra.
    struct Failing(CspaceEngine);

    impl Validity for Failing {
        fn state_valid(&self, position: &Point) -> bool {
            self.0.state_valid(position)
        }

        fn motion_valid(&self, from: &Point, to: &Point) -> bool {
            self.0.motion_valid(from, to)
        }

        fn violations(&self, from: &Point, to: &Point) -> Vec<Violation> {
            self.0.violations(from, to)
        }

        fn clearance(&self, from: &Point, to: &Point) -> Option<Clearance> {
            self.0.clearance(from, to)
        }
    }

    impl Checker for Failing {
        fn conditions(&self) -> &Conditions {
            self.0.conditions()
        }

        fn interference(&self) -> Interference {
            self.0.interference()
        }

        fn geometry_for(&self, scene: &Scene, watch: &Watch) -> Result<Box<dyn Checker>, Error> {
            self.0.geometry_for(scene, watch)
        }

        fn breaks(&self, index: usize, from: &Point, to: &Point) -> bool {
            self.0.breaks(index, from, to)
        }

        fn certain_polyhedra(&self, watch: &Watch) -> Result<Arc<Vec<Polyhedron>>, Error> {
            self.0.certain_polyhedra(watch)
        }

        fn pieces(&self, _: &Watch) -> Result<Arc<Vec<Piece>>, Error> {
            Err(Error::internal("no polyhedra"))
        }
    }

    #[test]
    fn an_error_of_the_decision_is_reported_unless_there_is_a_path() {
        for (scene, is_path) in [(hard3(), true), (scene(walled(0.94)), false)] {
            let engine = Failing(CspaceEngine::new(&scene, Interference::Exact).unwrap());
            for ended in both_by(&engine, &scene) {
                match conclude(ended, &StringPuller::new(&engine), &Watch::NONE) {
                    Ok(Decided::Searched(found, None)) => assert!(is_path && found.status == Status::Solved),
                    Ok(_) => panic!("nothing was decided"),
                    Err(error) => assert!(!is_path && error.class() == ErrorClass::Internal, "{error}"),
                }
            }
        }
    }
}
