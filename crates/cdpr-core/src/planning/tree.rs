//! A tree of states that grows from the start.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::space::StateSpace;

/// Nodes with their parents and the length of the way to them from the root, node 0.
#[derive(Debug, Clone)]
pub struct Tree<S: StateSpace> {
    states: Vec<S::State>,
    parents: Vec<usize>,
    costs: Vec<f64>,
    queue: Vec<Reverse<(u64, usize)>>,
}

impl<S: StateSpace> Tree<S> {
    /// A tree that is only its root.
    pub fn rooted_at(root: S::State) -> Self {
        Tree { states: vec![root], parents: vec![0], costs: vec![0.0], queue: Vec::new() }
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.states.len()
    }

    /// A tree has at least its root.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The state of a node.
    pub fn state(&self, node: usize) -> &S::State {
        &self.states[node]
    }

    /// Length of the way from the root to a node.
    pub fn cost(&self, node: usize) -> f64 {
        self.costs[node]
    }

    /// `Append(T, x_parent, x)` of the paper; returns the new node.
    pub fn append(&mut self, space: &S, parent: usize, state: S::State) -> usize {
        self.costs.push(self.costs[parent] + space.distance(&self.states[parent], &state));
        self.states.push(state);
        self.parents.push(parent);
        self.states.len() - 1
    }

    /// `FeasibleCheapest(T, x)` of the paper: the node through which `target` is reached at the least cost, among those
    /// with a feasible motion to it. Nodes are asked lazily, in increasing order of that cost.
    pub fn feasible_cheapest<E>(
        &mut self,
        space: &S,
        target: &S::State,
        mut feasible: impl FnMut(&S::State, &S::State) -> Result<bool, E>,
    ) -> Result<Option<usize>, E> {
        let through = |node: usize| self.costs[node] + space.distance(&self.states[node], target);
        let mut queue = std::mem::take(&mut self.queue);
        queue.clear();
        // Costs are not negative, so their bits are ordered as they are; ties go to the older node.
        queue.extend((0..self.states.len()).map(|node| Reverse((through(node).to_bits(), node))));
        let mut heap = BinaryHeap::from(queue);
        let mut found = None;
        while let Some(Reverse((_, node))) = heap.pop() {
            if feasible(&self.states[node], target)? {
                found = Some(node);
                break;
            }
        }
        self.queue = heap.into_vec();
        Ok(found)
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
}
