//! Modified RRT, Algorithm 3 of the paper: samples are connected directly, and the goal is tried after every change.
//!
//! The goal is tried only from the newest node, since the others have already failed. Samples are first checked as states,
//! which does not count as a motion check. If the search continues after the first path, a node becomes the goal's parent
//! only if that makes the goal cheaper.

use rand::{Rng, RngExt};

use super::outcome::{Improved, Outcome};
use super::search::{Limits, Search};
use super::space::{Problem, StateSpace};
use super::tree::Tree;
use crate::collision::Validity;
use crate::error::Error;
use crate::watch::Watch;

/// Options of [`modified_rrt`].
#[derive(Debug, Clone, PartialEq)]
pub struct ModifiedRrtOptions {
    /// Probability of using the goal as the sample, 0 to 1, which shows what the paper's goal test brings: `None`, as in
    /// the paper, tries the goal after every change of the tree.
    pub goal_bias: Option<f64>,
    /// What ends the search: the first path, or 20 000 samples.
    pub limits: Limits,
}

impl Default for ModifiedRrtOptions {
    fn default() -> Self {
        ModifiedRrtOptions { goal_bias: None, limits: Limits::samples(20_000) }
    }
}

/// Searches for a path by Modified RRT. Stops at the first connection to the goal, or continues up to the limits.
///
/// Interpretation of the pseudocode: a sample is first tested as a state, which is not counted as a motion check. The goal
/// is tried only from the nodes from which it has not been tried before, since from all others it has already failed. If
/// the search continues after the first path, a node becomes the goal's parent if it gives a shorter path than the present
/// parent (section 4).
///
/// # Errors
/// [`Error::interrupted`] if the watch requests it before there is a path.
///
/// # Example
/// ```
/// use cdpr_core::collision::{Checker, GjkEngine, Interference};
/// use cdpr_core::planning::{modified_rrt, ModifiedRrtOptions, Problem, Status, TranslationSpace};
/// use cdpr_core::watch::Watch;
/// use rand::SeedableRng;
/// let scene = cdpr_core::testing::hard1();
/// let engine = GjkEngine::new(&scene, Interference::Exact)?;
/// let space = TranslationSpace::of(engine.conditions());
/// let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
/// let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
/// let outcome = modified_rrt(&problem, &engine, &ModifiedRrtOptions::default(), &|_, _, _| (), &mut rng, &Watch::NONE)?;
/// assert_eq!(outcome.status, Status::Solved);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn modified_rrt<S: StateSpace>(
    problem: &Problem<S>,
    validity: &dyn Validity<S::State>,
    options: &ModifiedRrtOptions,
    improved: &Improved<S::State>,
    rng: &mut impl Rng,
    watch: &Watch,
) -> Result<Outcome<S::State>, Error> {
    let Problem { space, start, goal } = problem;
    let mut search = Search::new(problem, validity, &options.limits, improved, watch);
    let mut tree: Tree<S> = Tree::rooted_at(*start); // T <- x_init
    let mut check_goal = true; // chkGoal <- true
    let mut tried = 0; // from these nodes, the goal has been tried
    let (mut goal_parent, mut best) = (None, f64::INFINITY);
    loop {
        let goal_is_sample = match options.goal_bias {
            None => std::mem::take(&mut check_goal),
            Some(probability) => rng.random::<f64>() < probability,
        };
        if goal_is_sample {
            let check = |from: &_, to: &_| search.collision_free(from, to);
            let x_cheap = tree.feasible_cheapest(space, goal, tried..tree.len(), best, check)?;
            tried = tree.len();
            if let Some(x_cheap) = x_cheap {
                (goal_parent, best) = (Some(x_cheap), tree.cost_through(space, x_cheap, goal));
            }
        }
        if search.over(tree.len(), best, || tree.path_through(goal_parent, goal))? {
            return Ok(search.outcome(tree, goal_parent));
        }
        if goal_is_sample && options.goal_bias.is_some() {
            search.drawn(Some(*goal));
            continue;
        }
        let Some(x_rand) = search.random_sample(rng).filter(|x| search.valid(x)) else { continue };
        let check = |from: &_, to: &_| search.collision_free(from, to);
        let x_cheap = tree.feasible_cheapest(space, &x_rand, 0..tree.len(), f64::INFINITY, check)?;
        if let Some(x_cheap) = x_cheap {
            tree.append(space, x_cheap, x_rand);
            check_goal = true;
        }
    }
}
