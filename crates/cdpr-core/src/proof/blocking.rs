//! Why there is no path: a minimal set of obstacles and conditions that separate start and goal.
//!
//! Obstacles are left out one after another, as long as there is still no path. Most can be left out without a search:
//! if the cells that an obstacle closes are opened, start and goal remain separated. For each of the others the search
//! continues without it. If that finds a path past all other obstacles, this one is needed; if not, the search
//! continues among those that are left.

use std::collections::BTreeMap;

use super::CellSearch;
use crate::batch::each;
use crate::decomposition::{Closed, Decomposition, Kind, Way};
use crate::geometry::Point;
use crate::watch::Watch;

/// A proof by a minimal set of obstacles and conditions.
pub struct Smaller<'a> {
    /// The search without the omitted obstacles, if one was needed.
    pub search: Option<CellSearch<'a>>,
    /// The conditions that the proof needs, as indices; wrenches have the index after the last condition.
    pub conditions: Vec<usize>,
    /// The obstacles that the proof needs.
    pub blocking: Vec<usize>,
    /// For each obstacle of `blocking`, a path past all other obstacles, m, if one is found; its motions are not
    /// checked.
    pub paths_without: Vec<Option<Vec<Point>>>,
}

/// Leaves out obstacles, then conditions, of a search that found no way; each further search visits about `effort` cells, and
/// stays undecided if the caller wants to stop.
pub fn smallest<'a>(whole: &CellSearch<'a>, effort: usize, watch: &Watch) -> Smaller<'a> {
    let way = |search: &mut CellSearch| search.run(effort, watch).unwrap_or(Way::Undecided);
    let mut blocking = irreducible(&whole.cells, whole.ends, &|_| true, &|condition| whole.obstacles_of(condition));
    let searches = each(blocking.len(), 2, &|(), k| {
        let mut others = whole.clone().knowing(&|other| other != blocking[k]);
        let way = way(&mut others);
        Ok((blocking[k], way, others))
    })
    .expect("no search fails");
    let (mut fewest, mut ways) = (None, BTreeMap::new());
    for (obstacle, without, others) in searches {
        if let Way::Path(path) = without {
            ways.insert(obstacle, Some(path));
            continue;
        }
        let mut fewer = others.knowing(&|other| other != obstacle && blocking.contains(&other));
        if way(&mut fewer) == Way::None {
            blocking.retain(|&other| other != obstacle);
            fewest = Some(fewer);
        } else {
            ways.insert(obstacle, None);
        }
    }
    let cells = &fewest.as_ref().unwrap_or(whole).cells;
    let needed = |condition: usize| whole.obstacles_of(condition).iter().all(|j| blocking.contains(j));
    let conditions = irreducible(cells, whole.ends, &needed, &|condition| vec![condition]);
    Smaller { search: fewest, conditions, blocking, paths_without: ways.into_values().collect() }
}

impl<'a> CellSearch<'a> {
    /// The obstacles that a condition concerns; several for a seam between them.
    fn obstacles_of(&self, condition: usize) -> Vec<usize> {
        let conditions = self.checker.conditions();
        conditions.list.get(condition).map_or(Vec::new(), |c| c.details().obstacles(&conditions.bodies))
    }

    /// This search with only these obstacles.
    fn knowing(self, obstacle: &dyn Fn(usize) -> bool) -> Self {
        let number = self.checker.conditions().list.len();
        let known: Vec<bool> =
            (0..number).map(|condition| self.obstacles_of(condition).into_iter().all(obstacle)).collect();
        let known = |condition: usize| known.get(condition).is_none_or(|known| *known); // wrenches come after the last one
        let regions = self.regions.knowing(&known);
        let cells = self.cells.knowing(&known, &regions);
        CellSearch { regions, cells, ..self }
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

/// A minimal set of items whose closed cells separate start and goal. `of` gives the items of a condition; conditions
/// for which `counts` is false close nothing. Items with few cells are left out first.
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
        let left_open = |cell: &u32| closed_by(cells, *cell).is_none_or(&leaves_open);
        let (passable, others): (Vec<u32>, Vec<u32>) =
            cells.leaves().filter(left_open).partition(|&cell| cells.kind(cell).passable());
        for cell in passable {
            groups.open[cell as usize] = true;
            cells.beside(cell).iter().for_each(|&other| groups.join(cell, other));
        }
        others.into_iter().for_each(|cell| groups.open(cells, cell));
        groups
    }

    fn open(&mut self, cells: &Decomposition, cell: u32) {
        self.open[cell as usize] = true;
        cells.touching(cell, &mut |other| {
            if self.open[other as usize] {
                self.join(cell, other);
            }
        });
    }

    fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [a, b].map(|cell| self.group(cell));
        self.parent[a as usize] = b;
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
