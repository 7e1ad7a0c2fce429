//! Why there is no path: the smallest sets of obstacles and of conditions that close the way.
//!
//! Obstacles are left out one after another, as long as there is still no path. Most are found without a new search: the cells
//! that an obstacle closes are opened, and start and goal remain separated.

use std::collections::BTreeMap;

use super::Search;
use crate::decomposition::{Closed, Decomposition, Kind, Way};
use crate::error::Error;
use crate::geometry::Point;
use crate::numerics::PROOF_EFFORT;
use crate::watch::Watch;

/// A proof by fewer obstacles and conditions.
pub struct Smaller<'a> {
    /// The search without the other obstacles, if one was needed to find them.
    pub search: Option<Search<'a>>,
    /// The conditions that its proof needs, as indices; wrenches have the index after the last condition.
    pub conditions: Vec<usize>,
    /// Its obstacles.
    pub blocking: Vec<usize>,
}

/// Leaves out obstacles, then conditions, of a search that found no way.
pub fn smallest<'a>(whole: &Search<'a>, watch: &Watch) -> Result<Smaller<'a>, Error> {
    let mut blocking = irreducible(&whole.cells, whole.ends, &|_| true, &|condition| whole.obstacles_of(condition));
    let mut search = None;
    for obstacle in blocking.clone() {
        let left: Vec<usize> = blocking.iter().copied().filter(|&other| other != obstacle).collect();
        let mut fewer = whole.among(&left);
        if fewer.run(PROOF_EFFORT, watch)? == Way::None {
            (search, blocking) = (Some(fewer), left);
        }
    }
    let cells = &search.as_ref().unwrap_or(whole).cells;
    let needed = |condition: usize| whole.obstacles_of(condition).iter().all(|j| blocking.contains(j));
    let conditions = irreducible(cells, whole.ends, &needed, &|condition| vec![condition]);
    Ok(Smaller { search, conditions, blocking })
}

impl<'a> Search<'a> {
    /// The obstacles that a condition is about; two for a seam between them.
    fn obstacles_of(&self, condition: usize) -> Vec<usize> {
        let conditions = self.checker.conditions();
        let mut found =
            conditions.list.get(condition).map_or(Vec::new(), |c| c.details().obstacles(&conditions.bodies));
        found.dedup();
        found
    }

    /// A new search that knows no obstacles but these.
    fn among(&self, obstacles: &[usize]) -> Self {
        let known = |condition: usize| self.obstacles_of(condition).iter().all(|obstacle| obstacles.contains(obstacle));
        let pieces = self.cells.pieces().iter().filter(|piece| known(piece.condition)).cloned().collect();
        Search::new(self.checker, pieces, &known, self.ends)
    }
}

/// The condition that closes a cell, if one does.
fn closed_by(cells: &Decomposition, cell: u32) -> Option<usize> {
    match cells.kind(cell) {
        Kind::Closed(Closed::Piece(index)) => Some(cells.pieces()[index as usize].condition),
        Kind::Closed(Closed::Bound(condition)) => Some(condition as usize),
        _ => None,
    }
}

/// The closed cells, by what `of` makes of the conditions that close them.
fn closed_cells(cells: &Decomposition, of: impl Fn(usize) -> Vec<usize>) -> BTreeMap<usize, Vec<u32>> {
    let mut found: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
    for cell in cells.leaves() {
        let Some(condition) = closed_by(cells, cell) else { continue };
        for item in of(condition) {
            found.entry(item).or_default().push(cell);
        }
    }
    found
}

/// Items none of which can be left out: the cells that they close separate start and goal. `of` gives the items of a condition;
/// conditions for which `counts` is false close nothing. Items with few cells are left out first.
fn irreducible(
    cells: &Decomposition,
    ends: [&Point; 2],
    counts: &dyn Fn(usize) -> bool,
    of: &dyn Fn(usize) -> Vec<usize>,
) -> Vec<usize> {
    let of = |condition: usize| if counts(condition) { of(condition) } else { Vec::new() };
    let mut items: Vec<(usize, Vec<u32>)> = closed_cells(cells, of).into_iter().collect();
    items.sort_by_key(|(_, cells)| cells.len());
    let ends = ends.map(|end| cells.cell_at(end));
    let mut open = Open::new(cells, |condition| !counts(condition));
    let mut needed = Vec::new();
    for (item, closed) in items {
        let mut more = open.clone();
        closed.iter().for_each(|&cell| more.open(cells, cell));
        if more.connected(ends) {
            needed.push(item);
        } else {
            open = more;
        }
    }
    needed.sort_unstable();
    needed
}

/// Groups of connected open cells (union-find).
#[derive(Clone)]
struct Open {
    open: Vec<bool>,
    parent: Vec<u32>,
}

impl Open {
    /// The cells that nothing closes, or a condition that `leaves_open` names.
    fn new(cells: &Decomposition, leaves_open: impl Fn(usize) -> bool) -> Self {
        let count = cells.leaves().map(|cell| cell as usize + 1).max().unwrap_or(0);
        let mut groups = Open { open: vec![false; count], parent: (0..count as u32).collect() };
        let open = |cell: &u32| closed_by(cells, *cell).is_none_or(&leaves_open);
        cells.leaves().filter(open).for_each(|cell| groups.open(cells, cell));
        groups
    }

    fn open(&mut self, cells: &Decomposition, cell: u32) {
        self.open[cell as usize] = true;
        cells.touching(cell, &mut |other| {
            if self.open[other as usize] {
                let [a, b] = [cell, other].map(|cell| self.group(cell));
                self.parent[a as usize] = b;
            }
        });
    }

    fn group(&mut self, cell: u32) -> u32 {
        let mut at = cell;
        while self.parent[at as usize] != at {
            let above = self.parent[self.parent[at as usize] as usize];
            self.parent[at as usize] = above;
            at = above;
        }
        at
    }

    fn connected(&mut self, [a, b]: [u32; 2]) -> bool {
        self.group(a) == self.group(b)
    }
}
