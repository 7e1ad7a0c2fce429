//! Modified RRT, Algorithm 3 of the paper: samples are connected directly, and the goal is tried after every change.

use rand::Rng;

use super::outcome::{Outcome, Status, Watch};
use super::space::{Problem, StateSpace};
use super::tree::Tree;
use crate::collision::Validity;
use crate::error::Error;

/// Options of [`modified_rrt`].
#[derive(Debug, Clone, PartialEq)]
pub struct ModifiedRrtOptions {
    /// Random samples after which the search gives up.
    pub max_samples: usize,
}

impl Default for ModifiedRrtOptions {
    fn default() -> Self {
        ModifiedRrtOptions { max_samples: 20_000 }
    }
}

/// Searches a path by Modified RRT; stops at the first connection to the goal.
///
/// Readings of the pseudocode: a sample is first tested as a state, which is no motion check. When the goal is tried
/// again after an append, only the new node can have changed the answer, the others were refused before.
///
/// # Errors
/// [`Error::interrupted`] if the watch says so.
///
/// # Example
/// ```
/// use cdpr_core::collision::{Checker, GjkEngine, Interference};
/// use cdpr_core::planning::{modified_rrt, ModifiedRrtOptions, Problem, Status, TranslationSpace, Watch};
/// use rand::SeedableRng;
/// let scene = cdpr_core::testing::hard1();
/// let engine = GjkEngine::new(&scene, Interference::Exact)?;
/// let space = TranslationSpace::of(engine.constraints());
/// let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
/// let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
/// let outcome = modified_rrt(&problem, &engine, &ModifiedRrtOptions::default(), &mut rng, &Watch::NONE)?;
/// assert_eq!(outcome.status, Status::Solved);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn modified_rrt<S: StateSpace>(
    problem: &Problem<S>,
    validity: &dyn Validity<S::State>,
    options: &ModifiedRrtOptions,
    rng: &mut impl Rng,
    watch: &Watch,
) -> Result<Outcome<S::State>, Error> {
    let Problem { space, start, goal } = problem;
    let (mut motion_checks, mut samples) = (0usize, 0usize);
    let mut out_of_time = false;
    let mut collision_free = |from: &S::State, to: &S::State| {
        motion_checks += 1;
        out_of_time |= motion_checks.is_multiple_of(POLL) && watch.expired()?;
        Ok::<bool, Error>(!out_of_time && validity.motion_valid(from, to))
    };
    let mut tree: Tree<S> = Tree::rooted_at(*start); // T <- x_init
    let mut newest = 0;
    let mut check_goal = true;
    let status = loop {
        if check_goal {
            check_goal = false;
            if collision_free(tree.state(newest), goal)? {
                newest = tree.append(space, newest, *goal);
                break Status::Solved;
            }
        }
        if samples == options.max_samples || (samples.is_multiple_of(POLL) && watch.expired()?) {
            break Status::BudgetSpent;
        }
        samples += 1;
        let Some(x_rand) = space.sample(rng).filter(|x| validity.state_valid(x)) else { continue };
        if let Some(x_cheap) = tree.feasible_cheapest(space, &x_rand, &mut collision_free)? {
            newest = tree.append(space, x_cheap, x_rand);
            check_goal = true;
        }
    };
    let waypoints = if status == Status::Solved { tree.path_to(newest) } else { Vec::new() };
    Ok(Outcome { status, waypoints, nodes: tree.len(), motion_checks, samples })
}

/// Motion checks, or samples, between two looks at the clock and the caller.
const POLL: usize = 64;
