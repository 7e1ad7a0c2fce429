//! RRT: a tree that grows by short steps towards random samples (S. M. LaValle, 1998; the paper, section 2.2).

use rand::Rng;

use super::neighbours::Neighbours;
use super::outcome::{Improved, Outcome};
use super::search::{Limits, Search};
use super::space::{Problem, StateSpace, steer};
use super::tree::Tree;
use crate::collision::Validity;
use crate::error::Error;
use crate::watch::Watch;

/// Options of [`rrt`].
#[derive(Debug, Clone, PartialEq)]
pub struct RrtOptions {
    /// Longest edge of the tree, m.
    pub step: f64,
    /// Probability of using the goal as the sample, 0 to 1; 0, as in the paper, is no bias.
    pub goal_bias: f64,
    /// Whether the goal is the next sample after every change of the tree, as in the paper's Algorithm 3, instead of by
    /// chance.
    pub check_goal: bool,
    /// What ends the search: the first path, or 20 000 samples.
    pub limits: Limits,
}

impl Default for RrtOptions {
    fn default() -> Self {
        RrtOptions { step: 0.1, goal_bias: 0.0, check_goal: false, limits: Limits::samples(20_000) }
    }
}

/// Searches for a path by RRT. Stops at the first path, or continues up to the limits and keeps the shortest path.
///
/// The new state is first tested as a state, which is not counted as a motion check. Samples are not tested, since the
/// tree may grow towards an invalid sample. The goal is tried from the start and from every new node within one step of
/// it.
///
/// # Errors
/// [`Error::interrupted`] if the watch requests it before there is a path.
///
/// # Example
/// ```
/// use cdpr_core::collision::{Checker, CspaceEngine, Interference};
/// use cdpr_core::planning::{rrt, Problem, RrtOptions, Status, TranslationSpace};
/// use cdpr_core::watch::Watch;
/// use rand::SeedableRng;
/// let scene = cdpr_core::testing::hard1();
/// let engine = CspaceEngine::new(&scene, Interference::Exact)?;
/// let space = TranslationSpace::of(engine.conditions());
/// let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
/// let options = RrtOptions { goal_bias: 0.05, ..RrtOptions::default() };
/// let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
/// let outcome = rrt(&problem, &engine, &options, &|_, _, _| (), &mut rng, &Watch::NONE)?;
/// assert_eq!(outcome.status, Status::Solved);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn rrt<S: StateSpace>(
    problem: &Problem<S>,
    validity: &dyn Validity<S::State>,
    options: &RrtOptions,
    improved: &Improved<S::State>,
    rng: &mut impl Rng,
    watch: &Watch,
) -> Result<Outcome<S::State>, Error> {
    let Problem { space, start, goal } = problem;
    let mut search = Search::new(problem, validity, &options.limits, improved, watch);
    let mut neighbours = Neighbours::default();
    neighbours.push(space.place(start));
    let mut tree: Tree<S> = Tree::rooted_at(*start); // T <- x_init
    let (mut newest, mut check_goal) = (Some(0), options.check_goal);
    let (mut goal_parent, mut best) = (None, f64::INFINITY);
    loop {
        if let Some(x) = newest.take().filter(|x| space.distance(tree.state(*x), goal) <= options.step) {
            let cost = tree.cost_through(space, x, goal);
            if cost < best && search.collision_free(tree.state(x), goal)? {
                (goal_parent, best) = (Some(x), cost);
            }
        }
        if search.over(tree.len(), best, || tree.path_through(goal_parent, goal))? {
            return Ok(search.outcome(tree, goal_parent));
        }
        let x_rand = match std::mem::take(&mut check_goal) {
            true => search.drawn(Some(*goal)),
            false => search.biased_sample(options.goal_bias, rng),
        };
        let Some(x_rand) = x_rand else { continue };
        let Some(x_nearest) = neighbours.nearest_to(space, &tree, &x_rand) else { continue };
        let x_new = steer(space, tree.state(x_nearest), &x_rand, options.step);
        if x_new == *goal {
            continue; // it has been tried from this node, when the node was new
        }
        if search.valid(&x_new) && search.collision_free(tree.state(x_nearest), &x_new)? {
            newest = Some(tree.append(space, x_nearest, x_new));
            neighbours.push(space.place(&x_new));
            check_goal = options.check_goal;
        }
    }
}
