//! Two trees, one from the start and one from the goal, that meet in samples; the search of the anytime planner.

use rand::{Rng, RngExt};

use super::neighbours::Neighbours;
use super::search::Search;
use super::space::{Problem, StateSpace};
use super::tree::{SearchTree, Tree};
use crate::error::Error;

/// Number of nodes of each tree from which a sample is tried, nearest first. With one, a sample behind a corner of its
/// nearest node is lost; with all, an unreachable sample costs as many motion checks as there are nodes.
const NEAREST: usize = 10;

/// A tree that is larger than the other by this factor grows only together with it: if the other tree is stuck, the
/// search must make progress there.
const LOPSIDED: usize = 1;

/// How the parent of a new state is chosen among the nodes that can reach it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Parent {
    /// The nearest node; needs the fewest motion checks.
    Nearest,
    /// The node that gives the shortest path from the root; nearby nodes are rewired. Gives the shortest paths.
    Cheapest,
}

/// The two trees.
pub(super) struct Halves<'p, S: StateSpace> {
    space: &'p S,
    halves: [Half<S>; 2],
}

/// One tree, with a spatial index of its nodes.
pub(super) struct Half<S: StateSpace> {
    pub tree: Tree<S>,
    neighbours: Neighbours,
}

impl<'p, S: StateSpace> Halves<'p, S> {
    pub fn new(problem: &'p Problem<S>) -> Self {
        Halves { space: &problem.space, halves: Half::of_both_ends(problem) }
    }

    /// Number of nodes of both trees.
    pub fn len(&self) -> usize {
        self.halves.iter().map(|half| half.tree.len()).sum()
    }

    /// A random node of the smaller tree, which is the one that is stuck.
    pub fn stuck(&self, rng: &mut impl Rng) -> &S::State {
        let smaller = &self.halves[usize::from(self.halves[1].tree.len() < self.halves[0].tree.len())].tree;
        smaller.state(rng.random_range(0..smaller.len()))
    }

    /// Inserts the waypoints of a valid path from start to goal into both trees; the path may be empty.
    pub fn keep(&mut self, path: &[S::State]) {
        let [_, inner @ .., _] = path else { return };
        let [from_start, from_goal] = &mut self.halves;
        from_start.append_chain(self.space, inner.iter());
        from_goal.append_chain(self.space, inner.iter().rev());
    }

    /// Connects a state to both trees by straight motions; returns the path through the state if both connections
    /// succeed.
    pub fn meet(
        &mut self,
        search: &mut Search<S>,
        state: &S::State,
        parent: Parent,
    ) -> Result<Option<Vec<S::State>>, Error> {
        let smaller = usize::from(self.halves[1].tree.len() < self.halves[0].tree.len());
        let larger = 1 - smaller;
        let mut nodes = [None; 2];
        nodes[smaller] = self.halves[smaller].append(self.space, search, state, parent)?;
        if nodes[smaller].is_some() || self.halves[larger].tree.len() < LOPSIDED * self.halves[smaller].tree.len() {
            nodes[larger] = self.halves[larger].append(self.space, search, state, parent)?;
        }
        let [Some(first), Some(second)] = nodes else { return Ok(None) };
        Ok(Some(path_through(&self.halves, [first, second])))
    }

    /// Both trees, the tree of the start first.
    pub fn into_search_tree(self) -> SearchTree<S::State> {
        into_search_tree(self.halves)
    }
}

/// The path from the root of the first tree to the root of the second, through a node of each with the same state.
pub(super) fn path_through<S: StateSpace>(halves: &[Half<S>; 2], nodes: [usize; 2]) -> Vec<S::State> {
    let mut path = halves[0].tree.path_to(nodes[0]);
    path.extend(halves[1].tree.path_to(nodes[1]).into_iter().rev().skip(1));
    path
}

/// Both trees, one after the other.
pub(super) fn into_search_tree<S: StateSpace>(halves: [Half<S>; 2]) -> SearchTree<S::State> {
    let [mut all, second] = halves.map(|half| SearchTree::from(half.tree));
    let count = all.states.len();
    all.states.extend(second.states);
    all.parents.extend(second.parents.into_iter().map(|parent| parent + count));
    all
}

impl<S: StateSpace> Half<S> {
    /// A tree from the start and one from the goal, each with only its root.
    pub fn of_both_ends(Problem { space, start, goal }: &Problem<S>) -> [Self; 2] {
        [start, goal].map(|root| {
            let mut neighbours = Neighbours::default();
            neighbours.push(space.place(root));
            Half { tree: Tree::rooted_at(*root), neighbours }
        })
    }

    /// The node nearest to a state.
    pub fn nearest(&mut self, space: &S, state: &S::State) -> Option<usize> {
        self.neighbours.nearest_to(space, &self.tree, state)
    }

    /// Appends a state to a node; returns the new node.
    pub fn push(&mut self, space: &S, parent: usize, state: S::State) -> usize {
        self.neighbours.push(space.place(&state));
        self.tree.append(space, parent, state)
    }

    /// Appends a state to one of the nearest nodes from which it can be reached; returns the new node.
    fn append(
        &mut self,
        space: &S,
        search: &mut Search<S>,
        state: &S::State,
        parent: Parent,
    ) -> Result<Option<usize>, Error> {
        let few = self.neighbours.nearest_few::<NEAREST>(&space.place(state));
        let mut through = [(0.0, 0); NEAREST];
        let through = &mut through[..few.nodes().len()];
        for (known, &node) in through.iter_mut().zip(few.nodes()) {
            *known = (self.tree.cost_through(space, node, state), node);
        }
        if parent == Parent::Cheapest {
            through.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        for (k, (_, node)) in through.iter().enumerate() {
            if search.collision_free(self.tree.state(*node), state) {
                let new = self.push(space, *node, *state);
                if parent == Parent::Cheapest {
                    self.rewire(space, search, new, &through[k + 1..])?;
                }
                return Ok(Some(new));
            }
        }
        Ok(None)
    }

    /// Makes a new node the parent of other nodes if this shortens their paths from the root.
    fn rewire(&mut self, space: &S, search: &mut Search<S>, new: usize, others: &[(f64, usize)]) -> Result<(), Error> {
        for &(_, other) in others {
            let cheaper = self.tree.cost_through(space, new, self.tree.state(other)) < self.tree.cost(other);
            if cheaper && search.collision_free(self.tree.state(new), self.tree.state(other)) {
                self.tree.rewire(space, other, new);
            }
        }
        Ok(())
    }

    /// Appends states one after another, starting at the root; the motions between them are known to be free.
    fn append_chain<'s>(&mut self, space: &S, states: impl Iterator<Item = &'s S::State>)
    where
        S::State: 's,
    {
        let mut last = 0;
        for state in states {
            last = self.push(space, last, *state);
        }
    }
}
