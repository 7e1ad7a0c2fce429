//! Adaptive cell decomposition of the box of positions: finds a path, or proves that there is none.
//!
//! A cell is closed (inside a forbidden polyhedron), free (outside all of them) or open (neither). The search looks for
//! a chain of free and open cells from start to goal, divides the open cells on it, and repeats. A chain of free cells
//! is a path. If there is no chain, closed cells separate start and goal, and there is no path. Only cells on a chain
//! are divided, so narrow passages cost little and the rest of the space nothing.
//!
//! This is the subdivision search of C. Wang, Y.-J. Chiang and C. Yap, "On soft predicates in subdivision motion
//! planning", Computational Geometry 48, 2015; proofs by closed cells go back to L. Zhang, Y. J. Kim and D. Manocha, "A
//! simple path non-existence algorithm using C-obstacle query", WAFR 2006.

mod chain;

use crate::collision::Piece;
use crate::error::Error;
use crate::geometry::{Cuboid, Point, Vector};
use crate::watch::Watch;
use chain::{Chains, POLL};
use std::collections::BinaryHeap;
use std::sync::Arc;

/// Result of a search.
#[derive(Debug, Clone, PartialEq)]
pub enum Way {
    /// Waypoints of a path, m.
    Path(Vec<Point>),
    /// Closed cells separate start and goal: there is no path.
    None,
    /// Undecided: effort or time ran out, or cells would have to be smaller than possible.
    Undecided,
}

/// Weights of a search: path length against the width of passages, and the remaining distance in A*.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taste {
    /// Distance through an open cell of level l costs 1 + 1.7^(l - `level`) times as much as through a free one. A low
    /// `level` prefers wide detours, a high one short paths through narrow passages.
    pub level: i32,
    /// Weight of the remaining distance in the A* ordering; at least 1. The larger it is, the fewer cells are visited,
    /// and the longer the chains.
    pub heuristic_weight: f64,
}

/// Decides questions of a search about motions and cells.
pub trait Oracle {
    /// Makes the final decision on a motion within cells that no piece reaches into.
    fn free(&self, from: &Point, to: &Point) -> bool;

    /// Whether a piece may reach into a cell.
    fn reaches(&self, piece: &Piece, cell: &Cuboid) -> bool {
        !piece.outer.iter().any(|plane| cell.lowest(plane) >= 0.0)
    }

    /// Whether a cell is inside what this piece forbids.
    fn closes(&self, _index: u32, piece: &Piece, cell: &Cuboid) -> bool {
        piece.certain.as_ref().is_some_and(|all| all.iter().all(|plane| cell.highest(plane) < 0.0))
    }

    /// The index of a condition that forbids a whole cell although no piece does. Called only before a cell on a chain is
    /// divided.
    fn closed_by_bound(&self, _cell: &Cuboid) -> Option<u32> {
        None
    }
}

impl<F: Fn(&Point, &Point) -> bool> Oracle for F {
    fn free(&self, from: &Point, to: &Point) -> bool {
        self(from, to)
    }
}

/// Factor of the cost of an open cell from one level to the next; see [`Taste::level`].
const GROWTH: f64 = 1.7;
/// The cell that is the whole box.
pub const WHOLE: u32 = 0;
/// Coordinates of cells are multiples of 2^-LEVELS of the sides of the box.
const LEVELS: u8 = 24;
/// Maximum number of halvings of the box, unless set otherwise.
const FINEST: u8 = 14;
/// Number of halvings of the box after which the cells of start and goal need not be free; the oracle then decides about the
/// motions in them.
const SMALL_END: u8 = 10;
/// Cost of checking a motion, in visited cells.
const MOTION: usize = 10;

/// A cell decomposition of the box of positions.
#[derive(Debug, Clone)]
pub struct Decomposition {
    pieces: Arc<Vec<Piece>>,
    low: Point,
    size: Vector,
    /// The whole box, followed by the eight parts of each divided cell.
    cells: Vec<Cell>,
    chains: Chains,
    /// Maximum number of halvings of the box.
    finest: u8,
    /// Number of cells that may still be visited; negative if the last search exceeded its effort.
    credit: i64,
    /// Whether a cell that might be passable is too small to be divided.
    at_the_limit: bool,
}

#[derive(Debug, Clone)]
struct Cell {
    /// Corner with the smallest coordinates, in units of the smallest cells.
    low: [u32; 3],
    /// Number of halvings of the box that led to this cell.
    level: u8,
    kind: Kind,
    center: Point,
    /// The pieces that reach into the cell, unless it is divided.
    near: Vec<u32>,
    /// The passable cells that touch this one, even if only in a corner; empty for cells that are not passable.
    beside: Vec<u32>,
}

/// Classification of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Outside all forbidden pieces.
    Free,
    /// Neither inside one piece nor outside all of them, or the engine rejected a motion in it.
    Open,
    /// Forbidden as a whole.
    Closed(Closed),
    /// Neither free nor forbidden, but too small to be divided.
    TooSmall,
    /// Divided; holds the index of the first part.
    Divided(u32),
}

/// What can be reached from a cell.
#[derive(Debug, Clone)]
pub struct Reached {
    /// For each cell, whether it can be reached.
    pub inside: Vec<bool>,
    /// For each cell, whether it touches one that can be reached.
    pub touched: Vec<bool>,
}

/// Why a cell is closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Closed {
    /// The cell is inside the piece with this index.
    Piece(u32),
    /// The condition with this index forbids it, by a bound.
    Bound(u32),
}

impl Kind {
    /// Whether a path may lead through the cell.
    pub fn passable(self) -> bool {
        matches!(self, Kind::Free | Kind::Open)
    }
}

impl Decomposition {
    /// A single cell: the box of positions from `low` to `high`, m.
    pub fn new(pieces: Arc<Vec<Piece>>, low: Point, high: Point) -> Self {
        let near = (0..pieces.len() as u32).collect();
        let center = nalgebra::center(&low, &high);
        let whole = Cell { low: [0; 3], level: 0, kind: Kind::Open, center, near, beside: Vec::new() };
        let chains = Chains::default();
        let (size, cells) = (high - low, vec![whole]);
        Decomposition { pieces, low, size, cells, chains, finest: FINEST, credit: 0, at_the_limit: false }
    }

    /// This decomposition with cells no smaller than `size`, m (the mean of their sides), instead of 2^-14 of the box.
    pub fn down_to(self, size: f64) -> Self {
        let halvings = (self.size.mean() / size).log2().floor().clamp(0.0, f64::from(LEVELS));
        Decomposition { finest: halvings as u8, ..self }
    }

    /// The forbidden polyhedra.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Searches for a path, visiting about `effort` cells. The next call continues the search and deducts what this
    /// call visited beyond that.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn way(
        &mut self,
        [start, goal]: [&Point; 2],
        oracle: &dyn Oracle,
        taste: Taste,
        effort: usize,
        watch: &Watch,
    ) -> Result<Way, Error> {
        self.credit += effort as i64;
        while self.credit > 0 && !watch.expired()? {
            let ends = [self.cell_at(start), self.cell_at(goal)];
            let (chain, looked) = self.chains.find(&self.cells, ends, goal, taste, watch)?;
            self.credit -= looked as i64;
            if chain.is_empty() {
                let certain = !self.at_the_limit && !watch.expired()?;
                return Ok(if certain { Way::None } else { Way::Undecided });
            }
            // If start or goal touches something, no cell that contains it is free, however small.
            let leaves_end = |cell: &u32| ends.contains(cell) && self.cells[*cell as usize].level >= SMALL_END;
            let open = |cell: &u32| self.cells[*cell as usize].kind == Kind::Open && !leaves_end(cell);
            let mut doubtful: Vec<u32> = chain.iter().copied().filter(open).collect();
            if doubtful.is_empty() {
                let places = self.places(&chain, start, goal);
                let refused = |k: &usize| !oracle.free(&places[*k], &places[k + 1]);
                doubtful = (0..chain.len()).filter(refused).map(|k| chain[k]).collect();
                self.credit -= (MOTION * chain.len()) as i64;
                if doubtful.is_empty() {
                    return Ok(Way::Path(places));
                }
            }
            for cell in doubtful {
                if watch.expired()? {
                    return Ok(Way::Undecided); // bounds on wrenches take long
                }
                self.settle(cell, oracle);
            }
        }
        Ok(Way::Undecided)
    }

    /// Every path from start to goal passes an opening narrower than this, m: every chain of cells contains one that is not free,
    /// and in such a cell something forbidden is closer than its diagonal. Infinite if time runs out.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn narrowest_opening(&self, ends: [&Point; 2], watch: &Watch) -> Result<f64, Error> {
        // A widest path: cells are visited in descending order of the narrowest opening on the way to them. Widths are
        // not negative, so they are ordered as their bits.
        let [start, goal] = ends.map(|end| self.cell_at(end));
        let mut seen = vec![false; self.cells.len()];
        let mut waiting = BinaryHeap::from([(self.opening(start).to_bits(), start)]);
        let mut looked = 0;
        while let Some((width, cell)) = waiting.pop() {
            if cell == goal {
                return Ok(f64::from_bits(width));
            }
            looked += 1;
            if looked % POLL == 0 && watch.expired()? {
                break;
            }
            self.touching(cell, &mut |other| {
                if !std::mem::replace(&mut seen[other as usize], true) {
                    waiting.push((width.min(self.opening(other).to_bits()), other));
                }
            });
        }
        Ok(f64::INFINITY)
    }

    /// Upper bound on the width of an opening in a cell: twice its diagonal; infinite if the cell is free, zero if it is closed.
    fn opening(&self, cell: u32) -> f64 {
        match self.cells[cell as usize].kind {
            Kind::Free => f64::INFINITY,
            Kind::Open | Kind::TooSmall => 4.0 * self.span(cell).half.norm(),
            Kind::Closed(_) | Kind::Divided(_) => 0.0,
        }
    }

    /// The undivided cells.
    pub fn leaves(&self) -> impl Iterator<Item = u32> {
        let divided = |cell: &Cell| matches!(cell.kind, Kind::Divided(_));
        self.cells.iter().enumerate().filter(move |(_, cell)| !divided(cell)).map(|(index, _)| index as u32)
    }

    /// The classification of a cell.
    pub fn kind(&self, cell: u32) -> Kind {
        self.cells[cell as usize].kind
    }

    /// The passable cells that touch a passable one.
    pub fn beside(&self, cell: u32) -> &[u32] {
        &self.cells[cell as usize].beside
    }

    /// The cells that a chain of touching passable cells connects with the cell `from`.
    pub fn reached(&self, from: u32, passable: &dyn Fn(u32) -> bool) -> Reached {
        self.flooded(from, passable, |cell, visit| self.touching(cell, visit))
    }

    /// For each cell, whether a chain of touching passable cells connects it with the cell `from`; here all cells of a
    /// passable kind count, whose neighbours are stored.
    pub fn reached_from(&self, from: u32) -> Vec<bool> {
        let passable = |cell: u32| self.kind(cell).passable();
        self.flooded(from, &passable, |cell, visit| self.beside(cell).iter().for_each(|&other| visit(other))).inside
    }

    fn flooded(
        &self,
        from: u32,
        passable: &dyn Fn(u32) -> bool,
        visit_neighbours: impl Fn(u32, &mut dyn FnMut(u32)),
    ) -> Reached {
        let mut reached = Reached { inside: vec![false; self.cells.len()], touched: vec![false; self.cells.len()] };
        let mut waiting = Vec::from_iter(Some(from).filter(|&from| passable(from)));
        while let Some(cell) = waiting.pop() {
            if std::mem::replace(&mut reached.inside[cell as usize], true) {
                continue;
            }
            visit_neighbours(cell, &mut |other| {
                let seen = std::mem::replace(&mut reached.touched[other as usize], true);
                if !seen && passable(other) {
                    waiting.push(other);
                }
            });
        }
        reached
    }

    /// These cells as classified if only the conditions for which `known` is true count, as in the oracle: cells that
    /// other conditions closed or left undecided are classified again.
    pub fn knowing(mut self, known: &dyn Fn(usize) -> bool, oracle: &dyn Oracle) -> Self {
        (self.credit, self.at_the_limit) = (0, false);
        let known_pieces: Vec<bool> = self.pieces.iter().map(|piece| known(piece.condition)).collect();
        let counts = |piece: u32| known_pieces[piece as usize];
        let all: Vec<u32> = (0..self.pieces.len() as u32).filter(|&piece| counts(piece)).collect();
        for leaf in self.leaves().collect::<Vec<u32>>() {
            let cell = &mut self.cells[leaf as usize];
            cell.near.retain(|&piece| counts(piece));
            let reopened = match cell.kind {
                Kind::Closed(Closed::Piece(piece)) => !counts(piece),
                Kind::Closed(Closed::Bound(condition)) => !known(condition as usize),
                Kind::TooSmall => true,
                Kind::Open if cell.near.is_empty() => {
                    cell.kind = Kind::Free;
                    false
                }
                _ => false,
            };
            if reopened {
                self.classify(leaf, &all, oracle);
                let mut beside = Vec::new();
                self.touching(leaf, &mut |other| beside.push(other));
                self.connect(leaf, beside.into_iter().filter(|&other| other != leaf));
            }
        }
        self
    }

    /// Visits the undivided cells that touch a cell, itself included.
    pub fn touching(&self, cell: u32, visit: &mut dyn FnMut(u32)) {
        let (low, steps) = (self.cells[cell as usize].low, self.cells[cell as usize].steps());
        let mut waiting = vec![WHOLE];
        while let Some(at) = waiting.pop() {
            let other = &self.cells[at as usize];
            let Kind::Divided(first) = other.kind else {
                visit(at);
                continue;
            };
            // Visits the parts of `other` in the halves that the cell touches along all three axes.
            let middle = other.low.map(|low| low + other.steps() / 2);
            let halves = |touched: &dyn Fn(usize) -> bool| (0..3).map(|axis| u32::from(touched(axis)) << axis).sum();
            let lower: u32 = halves(&|axis| low[axis] <= middle[axis]);
            let upper: u32 = halves(&|axis| low[axis] + steps >= middle[axis]);
            waiting.extend((0..8).filter(|part| (part & upper) | (!part & lower) == 7).map(|part| first + part));
        }
    }

    /// Divides the open cells that can be reached from a position until each has been halved `level` times, or there are `most`
    /// cells.
    pub fn refine(&mut self, from: &Point, level: u8, most: usize, oracle: &dyn Oracle) {
        loop {
            let reached = self.reached_from(self.cell_at(from));
            let coarse = |cell: &u32| {
                let Cell { kind, level: own, .. } = self.cells[*cell as usize];
                reached[*cell as usize] && kind == Kind::Open && own < level
            };
            let coarse: Vec<u32> = self.leaves().filter(coarse).collect();
            if coarse.is_empty() || self.cells.len() >= most {
                return;
            }
            coarse.into_iter().for_each(|cell| self.divide(cell, oracle));
        }
    }

    /// Start, the centres of the contacts between consecutive cells, goal: between two of these points the path stays
    /// in one cell.
    fn places(&self, chain: &[u32], start: &Point, goal: &Point) -> Vec<Point> {
        let contact = |pair: &[u32]| {
            let [a, b] = [self.span(pair[0]), self.span(pair[1])];
            nalgebra::center(&a.low.sup(&b.low), &a.high.inf(&b.high))
        };
        std::iter::once(*start).chain(chain.windows(2).map(contact)).chain([*goal]).collect()
    }

    /// The box of a cell; coordinates are equal where cells touch.
    pub fn span(&self, cell: u32) -> Cuboid {
        let cell = &self.cells[cell as usize];
        let at =
            |axis: usize, steps: u32| self.low[axis] + self.size[axis] * (f64::from(steps) / f64::from(1 << LEVELS));
        let corner = |steps: u32| Point::from(Vector::from_fn(|axis, _| at(axis, cell.low[axis] + steps)));
        Cuboid::new(corner(0), corner(cell.steps()))
    }

    /// The undivided cell that contains a position.
    pub fn cell_at(&self, place: &Point) -> u32 {
        let mut at = 0;
        while let Kind::Divided(first) = self.cells[at as usize].kind {
            let middle = self.span(first).high;
            at = first + (0..3).map(|axis| u32::from(place[axis] >= middle[axis]) << axis).sum::<u32>();
        }
        at
    }

    /// Closes a cell by a bound, or else divides it into eight.
    fn settle(&mut self, cell: u32, oracle: &dyn Oracle) {
        match oracle.closed_by_bound(&self.span(cell)) {
            Some(condition) => {
                self.withdraw(cell, Kind::Closed(Closed::Bound(condition)));
            }
            None if self.cells[cell as usize].level == self.finest => {
                self.at_the_limit = true;
                self.withdraw(cell, Kind::TooSmall);
            }
            None => self.divide(cell, oracle),
        }
    }

    /// Gives a cell a kind that is not passable; returns the cells that touched it.
    fn withdraw(&mut self, cell: u32, kind: Kind) -> Vec<u32> {
        self.cells[cell as usize].kind = kind;
        let beside = std::mem::take(&mut self.cells[cell as usize].beside);
        for &other in &beside {
            self.cells[other as usize].beside.retain(|&at| at != cell);
        }
        beside
    }

    fn divide(&mut self, cell: u32, oracle: &dyn Oracle) {
        let first = self.cells.len() as u32;
        let beside = self.withdraw(cell, Kind::Divided(first));
        let parent = &mut self.cells[cell as usize];
        let (low, level, near) = (parent.low, parent.level + 1, std::mem::take(&mut parent.near));
        for part in 0..8 {
            let low = std::array::from_fn(|axis| low[axis] + ((part >> axis & 1) << (LEVELS - level)));
            let (center, near_new, beside_new) = (Point::origin(), Vec::new(), Vec::new());
            self.cells.push(Cell { low, level, kind: Kind::Open, center, near: near_new, beside: beside_new });
            let new = first + part;
            self.classify(new, &near, oracle);
            self.connect(new, beside.iter().copied().chain(first..new));
        }
    }

    /// Classifies a new cell, given the pieces that may reach into it.
    fn classify(&mut self, new: u32, candidates: &[u32], oracle: &dyn Oracle) {
        let span = self.span(new);
        let piece = |index: &u32| &self.pieces[*index as usize];
        let reaches = |index: &u32| oracle.reaches(piece(index), &span);
        let near: Vec<u32> = candidates.iter().copied().filter(reaches).collect();
        let closed = near.iter().find(|index| oracle.closes(**index, piece(index), &span)).copied();
        let cell = &mut self.cells[new as usize];
        cell.center = span.center;
        cell.kind = match closed {
            Some(piece) => Kind::Closed(Closed::Piece(piece)),
            None if near.is_empty() => Kind::Free,
            None => Kind::Open,
        };
        if closed.is_none() {
            cell.near = near;
        }
    }

    /// Connects a new cell to those of the given cells that it touches.
    fn connect(&mut self, new: u32, others: impl Iterator<Item = u32>) {
        if !self.cells[new as usize].kind.passable() {
            return;
        }
        for other in others {
            let [a, b] = [new, other].map(|at| &self.cells[at as usize]);
            if b.kind.passable() && a.touches(b) {
                self.cells[new as usize].beside.push(other);
                self.cells[other as usize].beside.push(new);
            }
        }
    }
}

impl Cell {
    /// Length of its sides, in units of the smallest cells.
    fn steps(&self) -> u32 {
        1 << (LEVELS - self.level)
    }

    fn touches(&self, other: &Cell) -> bool {
        let reaches = |a: &Cell, b: &Cell, axis: usize| a.low[axis] + a.steps() >= b.low[axis];
        (0..3).all(|axis| reaches(self, other, axis) && reaches(other, self, axis))
    }
}
