//! Two trees, one from the start and one from the goal, with the direct connections of the paper's Modified RRT: every
//! sample is tried with both trees. Unlike RRT-Connect it has no steps and no CONNECT.

use rand::Rng;

use super::bidirectional::{Halves, Parent};
use super::outcome::{Improved, Outcome, Status};
use super::search::{Limits, Search};
use super::space::{Problem, StateSpace};
use crate::collision::Validity;
use crate::error::Error;
use crate::watch::Watch;

/// Options of [`two_trees`].
#[derive(Debug, Clone, PartialEq)]
pub struct TwoTreesOptions {
    /// What ends the search: the first path, or 20 000 samples.
    pub limits: Limits,
}

impl Default for TwoTreesOptions {
    fn default() -> Self {
        TwoTreesOptions { limits: Limits::samples(20_000) }
    }
}

/// Searches for a path with two trees. Stops at the first path, or continues up to the limits and keeps the shortest
/// path.
///
/// There are no steps: engines check a motion of any length in one query, so a valid sample is connected directly to
/// each tree, to the nearest node from which it can be reached. A sample that both trees reach joins them.
///
/// # Errors
/// [`Error::interrupted`] if the watch requests it before there is a path.
///
/// # Example
/// ```
/// use cdpr_core::collision::{Checker, CspaceEngine, Interference};
/// use cdpr_core::planning::{Problem, TwoTreesOptions, Status, TranslationSpace, two_trees};
/// use cdpr_core::watch::Watch;
/// use rand::SeedableRng;
/// let scene = cdpr_core::testing::hard1();
/// let engine = CspaceEngine::new(&scene, Interference::Exact)?;
/// let space = TranslationSpace::of(engine.conditions());
/// let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
/// let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
/// let outcome = two_trees(&problem, &engine, &TwoTreesOptions::default(), &|_, _, _| (), &mut rng, &Watch::NONE)?;
/// assert_eq!(outcome.status, Status::Solved);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn two_trees<S: StateSpace>(
    problem: &Problem<S>,
    validity: &dyn Validity<S::State>,
    options: &TwoTreesOptions,
    improved: &Improved<S::State>,
    rng: &mut impl Rng,
    watch: &Watch,
) -> Result<Outcome<S::State>, Error> {
    let Problem { space, start, goal } = problem;
    let mut search = Search::new(problem, validity, &options.limits, improved, watch);
    let mut halves = Halves::new(problem);
    let mut path = if search.collision_free(start, goal)? { vec![*start, *goal] } else { Vec::new() };
    let mut best = space.length(&path);
    while !search.over(halves.len(), best, || path.clone())? {
        let Some(sample) = search.random_sample(rng).filter(|x| search.valid(x)) else { continue };
        if let Some(found) = halves.meet(&mut search, &sample, Parent::Nearest)? {
            let length = space.length(&found);
            if length < best {
                (path, best) = (found, length);
            }
        }
    }
    let status = if path.is_empty() { Status::BudgetSpent } else { Status::Solved };
    Ok(search.ended(status, path, halves.into_search_tree()))
}
