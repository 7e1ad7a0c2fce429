//! Two trees, one from the start and one from the goal, with the direct connections of the paper's Modified RRT: every
//! sample is tried with both trees. Unlike RRT-Connect it has no steps and no CONNECT.

use rand::Rng;

use super::bidirectional::{Halves, Parent};
use super::outcome::Outcome;
use super::search::Search;
use super::space::{Problem, StateSpace};
use crate::error::Error;

/// Searches for a path with two trees. Stops at the first path, or continues up to the limits and keeps the shortest
/// path.
///
/// There are no steps: engines check a motion of any length in one query, so a valid sample is connected directly to
/// each tree, to the nearest node from which it can be reached. A sample that both trees reach joins them.
///
/// # Errors
/// [`Error::interrupted`] if the watch requests it before there is a path.
pub(super) fn two_trees<S: StateSpace>(mut search: Search<S>, rng: &mut impl Rng) -> Result<Outcome<S::State>, Error> {
    let problem = search.problem;
    let Problem { space, start, goal } = problem;
    let mut halves = Halves::new(problem);
    let mut path = if search.collision_free(start, goal) { vec![*start, *goal] } else { Vec::new() };
    let mut best = space.length(&path);
    while !search.over(halves.len(), best, || path.clone()) {
        let Some(sample) = search.random_sample(rng).filter(|x| search.valid(x)) else { continue };
        if let Some(found) = halves.meet(&mut search, &sample, Parent::Nearest)? {
            let length = space.length(&found);
            if length < best {
                (path, best) = (found, length);
            }
        }
    }
    Ok(search.ended(path, halves.into_search_tree()))
}
