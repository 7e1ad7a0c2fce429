//! RRT: a tree that grows by short steps towards random samples (S. M. LaValle, 1998; the paper, section 2.2).

use rand::Rng;

use super::neighbours::Neighbours;
use super::outcome::Outcome;
use super::search::Search;
use super::space::{Problem, StateSpace, steer};
use super::tree::Tree;
use crate::error::Error;

/// How plain RRT grows.
#[derive(Debug, Clone, PartialEq)]
pub struct RrtOptions {
    /// Longest edge of the tree, m.
    pub step: f64,
    /// Probability of using the goal as the sample, 0 to 1; 0, as in the paper, is no bias.
    pub goal_bias: f64,
    /// Whether the goal is the next sample after every change of the tree, as in the paper's Algorithm 3, instead of by
    /// chance.
    pub check_goal: bool,
}

/// Searches for a path by RRT. Stops at the first path, or continues up to the limits and keeps the shortest path.
///
/// The new state is first tested as a state, which is not counted as a motion check. Samples are not tested, since the
/// tree may grow towards an invalid sample. The goal is tried from the start and from every new node within one step of
/// it.
///
/// # Errors
/// [`Error::interrupted`] if the watch requests it before there is a path.
pub(super) fn rrt<S: StateSpace>(
    mut search: Search<S>,
    options: &RrtOptions,
    rng: &mut impl Rng,
) -> Result<Outcome<S::State>, Error> {
    let Problem { space, start, goal } = search.problem;
    let mut neighbours = Neighbours::default();
    neighbours.push(space.place(start));
    let mut tree: Tree<S> = Tree::rooted_at(*start); // T <- x_init
    let (mut newest, mut check_goal) = (Some(0), options.check_goal);
    let (mut goal_parent, mut best) = (None, f64::INFINITY);
    loop {
        if let Some(x) = newest.take().filter(|x| space.distance(tree.state(*x), goal) <= options.step) {
            let cost = tree.cost_through(space, x, goal);
            if cost < best && search.collision_free(tree.state(x), goal) {
                (goal_parent, best) = (Some(x), cost);
            }
        }
        if search.over(tree.len(), best, || tree.path_through(goal_parent, goal)) {
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
        if search.valid(&x_new) && search.collision_free(tree.state(x_nearest), &x_new) {
            newest = Some(tree.append(space, x_nearest, x_new));
            neighbours.push(space.place(&x_new));
            check_goal = options.check_goal;
        }
    }
}
