//! The cheapest chain of cells: A* (P. E. Hart, N. J. Nilsson, B. Raphael, 1968), with a weight on the remaining
//! distance.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::{Cell, GROWTH, Kind, LEVELS, Taste};
use crate::error::Error;
use crate::geometry::Point;
use crate::watch::Watch;

/// Cells visited between two polls of the watch.
pub const POLL: usize = 256;
/// Marks a cell without predecessor.
const NOBODY: u32 = u32::MAX;

/// Scratch memory for a search, reused for the next.
#[derive(Debug, Clone, Default)]
pub struct Chains {
    /// For each cell, the cost of the cheapest chain to it.
    cost: Vec<f64>,
    /// For each cell, its predecessor on that chain.
    before: Vec<u32>,
    queue: BinaryHeap<Entry>,
}

impl Chains {
    /// The cells from the first end to the second, which contains the goal; empty if there is no chain or time runs
    /// out. Also returns the number of visited cells.
    pub fn find(
        &mut self,
        cells: &[Cell],
        [from, to]: [u32; 2],
        goal: &Point,
        taste: Taste,
        watch: &Watch,
    ) -> Result<(Vec<u32>, usize), Error> {
        let factors: [f64; LEVELS as usize + 1] =
            std::array::from_fn(|level| 1.0 + GROWTH.powi(level as i32 - taste.level));
        self.begin(cells.len());
        let mut looked = 0;
        if cells[from as usize].kind.passable() && cells[to as usize].kind.passable() {
            self.cost[from as usize] = 0.0;
            self.queue.push(Entry { order: 0.0, cost: 0.0, cell: from });
        }
        while let Some(Entry { cost, cell, .. }) = self.queue.pop() {
            if cost > self.cost[cell as usize] {
                continue; // reached more cheaply in the meantime
            }
            looked += 1;
            if looked % POLL == 0 && watch.expired()? {
                return Ok((Vec::new(), looked));
            }
            if cell == to {
                return Ok((self.chain_to(to), looked));
            }
            let here = cells[cell as usize].center;
            for &next in &cells[cell as usize].beside {
                if self.cost[next as usize] <= cost {
                    continue; // no step makes it cheaper
                }
                let Cell { kind, level, center, .. } = &cells[next as usize];
                let factor = if *kind == Kind::Free { 1.0 } else { factors[usize::from(*level)] };
                let cost = cost + factor * (center - here).norm();
                if cost < self.cost[next as usize] {
                    self.cost[next as usize] = cost;
                    self.before[next as usize] = cell;
                    let order = cost + taste.heuristic_weight * (goal - center).norm();
                    self.queue.push(Entry { order, cost, cell: next });
                }
            }
        }
        Ok((Vec::new(), looked))
    }

    fn begin(&mut self, count: usize) {
        self.cost.clear();
        self.cost.resize(count, f64::INFINITY);
        self.before.clear();
        self.before.resize(count, NOBODY);
        self.queue.clear();
    }

    fn chain_to(&self, to: u32) -> Vec<u32> {
        let before = |cell: &u32| Some(self.before[*cell as usize]).filter(|&cell| cell != NOBODY);
        let mut chain: Vec<u32> = std::iter::successors(Some(to), before).collect();
        chain.reverse();
        chain
    }
}

/// A cell to visit: lowest order first, ties by lowest index.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry {
    order: f64,
    cost: f64,
    cell: u32,
}

impl Eq for Entry {}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        other.order.total_cmp(&self.order).then(other.cell.cmp(&self.cell))
    }
}
