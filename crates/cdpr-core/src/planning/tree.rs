//! A tree of states that grows from the start.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use super::space::StateSpace;

/// One or several search trees as plain data, for display; several trees follow one another.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SearchTree<State> {
    /// The state of each node.
    pub states: Vec<State>,
    /// The parent of each node; a root is its own parent.
    pub parents: Vec<usize>,
}

impl<State> SearchTree<State> {
    /// The edges: the state of each node's parent, and the node's own state; roots have none.
    pub fn edges(&self) -> impl Iterator<Item = [&State; 2]> {
        let nodes = self.parents.iter().enumerate().filter(|(node, parent)| node != *parent);
        nodes.map(|(node, parent)| [&self.states[*parent], &self.states[node]])
    }
}

impl<S: StateSpace> From<Tree<S>> for SearchTree<S::State> {
    fn from(Tree { states, parents, .. }: Tree<S>) -> Self {
        SearchTree { states, parents }
    }
}

/// Nodes with their parents and their path lengths from the root, node 0.
#[derive(Debug, Clone)]
pub struct Tree<S: StateSpace> {
    states: Vec<S::State>,
    parents: Vec<usize>,
    costs: Vec<f64>,
    kin: Vec<Kin>,
    queue: Vec<Reverse<(u64, usize)>>,
}

/// The children of a node as a linked list: its first child, and the next sibling.
#[derive(Debug, Clone, Copy, Default)]
struct Kin {
    first_child: Option<Child>,
    next_sibling: Option<Child>,
}

/// A node that has a parent; the root is never a child.
type Child = std::num::NonZeroUsize;

impl<S: StateSpace> Tree<S> {
    /// A tree that consists of its root.
    pub fn rooted_at(root: S::State) -> Self {
        let (states, parents, costs, kin) = (vec![root], vec![0], vec![0.0], vec![Kin::default()]);
        Tree { states, parents, costs, kin, queue: Vec::new() }
    }

    /// Number of nodes of the tree.
    pub fn len(&self) -> usize {
        self.states.len()
    }

    /// Always false: a tree has at least its root.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The state of a node.
    pub fn state(&self, node: usize) -> &S::State {
        &self.states[node]
    }

    /// The parent of a node; the root is its own parent.
    pub fn parent(&self, node: usize) -> usize {
        self.parents[node]
    }

    /// Path length from the root to a node.
    pub fn cost(&self, node: usize) -> f64 {
        self.costs[node]
    }

    /// Path length from the root through a node and then straight to a state.
    pub fn cost_through(&self, space: &S, node: usize, state: &S::State) -> f64 {
        self.costs[node] + space.distance(&self.states[node], state)
    }

    /// `Append(T, x_parent, x)` of the paper; returns the new node.
    pub fn append(&mut self, space: &S, parent: usize, state: S::State) -> usize {
        self.costs.push(self.cost_through(space, parent, &state));
        self.states.push(state);
        self.parents.push(parent);
        self.kin.push(Kin::default());
        let new = self.states.len() - 1;
        self.adopt(parent, new);
        new
    }

    /// Gives a node another parent, and updates the costs of the node and all its descendants.
    ///
    /// The parent must not be a descendant of the node; a parent that reduces the node's cost never is.
    pub fn rewire(&mut self, space: &S, node: usize, parent: usize) {
        self.disown(node);
        self.parents[node] = parent;
        self.adopt(parent, node);
        let mut stack = vec![node];
        while let Some(node) = stack.pop() {
            self.costs[node] = self.cost_through(space, self.parents[node], &self.states[node]);
            let mut child = self.kin[node].first_child;
            while let Some(next) = child {
                stack.push(next.get());
                child = self.kin[next.get()].next_sibling;
            }
        }
    }

    fn adopt(&mut self, parent: usize, node: usize) {
        self.kin[node].next_sibling = self.kin[parent].first_child;
        self.kin[parent].first_child = Child::new(node);
    }

    fn disown(&mut self, node: usize) {
        let (parent, next) = (self.parents[node], self.kin[node].next_sibling);
        let mut link = &mut self.kin[parent].first_child;
        while let Some(child) = link.filter(|child| child.get() != node) {
            link = &mut self.kin[child.get()].next_sibling;
        }
        *link = next;
    }

    /// `FeasibleCheapest(T, x)` of the paper: the one of these nodes that gives the shortest path to `target`, among those
    /// with a feasible motion to it and a path shorter than `below`, m. Nodes are tried lazily, in order of increasing cost.
    pub fn feasible_cheapest(
        &mut self,
        space: &S,
        target: &S::State,
        nodes: Range<usize>,
        below: f64,
        mut feasible: impl FnMut(&S::State, &S::State) -> bool,
    ) -> Option<usize> {
        let through = |node: usize| self.costs[node] + space.distance(&self.states[node], target);
        let mut queue = std::mem::take(&mut self.queue);
        queue.clear();
        // Costs are nonnegative, so their bit patterns have the same order; the older node wins a tie.
        let through = nodes.map(|node| (through(node), node)).filter(|(cost, _)| *cost < below);
        queue.extend(through.map(|(cost, node)| Reverse((cost.to_bits(), node))));
        let mut heap = BinaryHeap::from(queue);
        let mut found = None;
        while let Some(Reverse((_, node))) = heap.pop() {
            if feasible(&self.states[node], target) {
                found = Some(node);
                break;
            }
        }
        self.queue = heap.into_vec();
        found
    }

    /// The states from the root to a node.
    pub fn path_to(&self, mut node: usize) -> Vec<S::State> {
        let mut path = vec![self.states[node]];
        while node != 0 {
            node = self.parents[node];
            path.push(self.states[node]);
        }
        path.reverse();
        path
    }

    /// The states from the root through a node to another state; empty without a node.
    pub fn path_through(&self, node: Option<usize>, end: &S::State) -> Vec<S::State> {
        node.map_or(Vec::new(), |node| self.path_to(node).into_iter().chain([*end]).collect())
    }
}
