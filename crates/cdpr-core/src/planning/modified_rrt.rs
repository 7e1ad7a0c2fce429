//! Modified RRT, Algorithm 3 of the paper: samples are connected directly, and the goal is tried after every change.
//!
//! The goal is tried only from the newest node, since the others have already failed. Samples are first checked as states,
//! which does not count as a motion check. If the search continues after the first path, a node becomes the goal's parent
//! only if that makes the goal cheaper.

use rand::{Rng, RngExt};

use super::outcome::Outcome;
use super::search::Search;
use super::space::{Problem, StateSpace};
use super::tree::Tree;
use crate::error::Error;

/// Searches for a path by Modified RRT. Stops at the first connection to the goal, or continues up to the limits.
///
/// `goal_bias`, the probability of using the goal as the sample, 0 to 1, shows what the paper's goal test brings: `None`, as in
/// the paper, tries the goal after every change of the tree.
///
/// Interpretation of the pseudocode: a sample is first tested as a state, which is not counted as a motion check. The goal
/// is tried only from the nodes from which it has not been tried before, since from all others it has already failed. If
/// the search continues after the first path, a node becomes the goal's parent if it gives a shorter path than the present
/// parent (section 4).
///
/// # Errors
/// [`Error::interrupted`] if the watch requests it before there is a path.
pub(super) fn modified_rrt<S: StateSpace>(
    mut search: Search<S>,
    goal_bias: Option<f64>,
    rng: &mut impl Rng,
) -> Result<Outcome<S::State>, Error> {
    let Problem { space, start, goal } = search.problem;
    let mut tree: Tree<S> = Tree::rooted_at(*start); // T <- x_init
    let mut check_goal = true; // chkGoal <- true
    let mut tried = 0; // from these nodes, the goal has been tried
    let (mut goal_parent, mut best) = (None, f64::INFINITY);
    loop {
        let goal_is_sample = match goal_bias {
            None => std::mem::take(&mut check_goal),
            Some(probability) => rng.random::<f64>() < probability,
        };
        if goal_is_sample {
            let check = |from: &_, to: &_| search.collision_free(from, to);
            let x_cheap = tree.feasible_cheapest(space, goal, tried..tree.len(), best, check);
            tried = tree.len();
            if let Some(x_cheap) = x_cheap {
                (goal_parent, best) = (Some(x_cheap), tree.cost_through(space, x_cheap, goal));
            }
        }
        if search.over(tree.len(), best, || tree.path_through(goal_parent, goal)) {
            return Ok(search.outcome(tree, goal_parent));
        }
        if goal_is_sample && goal_bias.is_some() {
            search.drawn(Some(*goal));
            continue;
        }
        let Some(x_rand) = search.random_sample(rng).filter(|x| search.valid(x)) else { continue };
        let check = |from: &_, to: &_| search.collision_free(from, to);
        let x_cheap = tree.feasible_cheapest(space, &x_rand, 0..tree.len(), f64::INFINITY, check);
        if let Some(x_cheap) = x_cheap {
            tree.append(space, x_cheap, x_rand);
            check_goal = true;
        }
    }
}
