//! Two trees, one from the start and one from the goal, that meet in samples.

use super::neighbours::Neighbours;
use super::search::Search;
use super::space::{Problem, StateSpace};
use super::tree::{SearchTree, Tree};
use crate::error::Error;

/// Nodes of each tree that a sample is tried from, the nearest first. With one, a sample behind a corner of its nearest node is
/// lost; with all, a sample that nothing sees costs as many motion checks as there are nodes.
const NEAREST: usize = 10;

/// A tree that is larger than the other by this factor grows only together with it: where the other is stuck, it is there
/// that something must be found.
const LOPSIDED: usize = 1;

/// The two trees.
pub(super) struct Halves<'p, S: StateSpace> {
    space: &'p S,
    halves: [Half<S>; 2],
}

struct Half<S: StateSpace> {
    tree: Tree<S>,
    neighbours: Neighbours,
}

impl<'p, S: StateSpace> Halves<'p, S> {
    pub fn new(problem: &'p Problem<S>) -> Self {
        let Problem { space, start, goal } = problem;
        let rooted = |root: &S::State| {
            let mut neighbours = Neighbours::default();
            neighbours.push(space.place(root));
            Half { tree: Tree::rooted_at(*root), neighbours }
        };
        Halves { space, halves: [rooted(start), rooted(goal)] }
    }

    /// Nodes of both trees.
    pub fn len(&self) -> usize {
        self.halves.iter().map(|half| half.tree.len()).sum()
    }

    /// Connects a state to both trees, straight; where both can be, the path through it.
    pub fn meet(&mut self, search: &mut Search<S>, state: &S::State) -> Result<Option<Vec<S::State>>, Error> {
        let smaller = usize::from(self.halves[1].tree.len() < self.halves[0].tree.len());
        let larger = 1 - smaller;
        let mut nodes = [None; 2];
        nodes[smaller] = self.halves[smaller].append(self.space, search, state)?;
        if nodes[smaller].is_some() || self.halves[larger].tree.len() < LOPSIDED * self.halves[smaller].tree.len() {
            nodes[larger] = self.halves[larger].append(self.space, search, state)?;
        }
        let [from_start, from_goal] = &self.halves;
        let [Some(first), Some(second)] = nodes else { return Ok(None) };
        let mut path = from_start.tree.path_to(first);
        path.extend(from_goal.tree.path_to(second).into_iter().rev().skip(1));
        Ok(Some(path))
    }

    /// Both trees, that of the start first.
    pub fn into_search_tree(self) -> SearchTree<S::State> {
        let [mut all, second] = self.halves.map(|half| SearchTree::from(half.tree));
        let count = all.states.len();
        all.states.extend(second.states);
        all.parents.extend(second.parents.into_iter().map(|parent| parent + count));
        all
    }
}

impl<S: StateSpace> Half<S> {
    /// Appends a state to the nearest node from which it can be reached; the new node.
    fn append(&mut self, space: &S, search: &mut Search<S>, state: &S::State) -> Result<Option<usize>, Error> {
        for &node in self.neighbours.nearest_few::<NEAREST>(&space.place(state)).nodes() {
            if search.collision_free(self.tree.state(node), state)? {
                self.neighbours.push(space.place(state));
                return Ok(Some(self.tree.append(space, node, *state)));
            }
        }
        Ok(None)
    }
}
