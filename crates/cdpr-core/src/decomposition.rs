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
use crate::geometry::{HalfSpace, Point, Vector};
use crate::watch::Watch;
use chain::Chains;

/// Result of a search.
#[derive(Debug, Clone, PartialEq)]
pub enum Way {
    /// A path, m.
    Path(Vec<Point>),
    /// Closed cells separate start and goal: there is no path.
    None,
    /// Undecided: effort or time ran out, or cells would have to be smaller than possible.
    Undecided,
}

/// How a search trades path length against the width of passages.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taste {
    /// Distance through an open cell of level l costs 1 + 1.7^(l - `level`) times as much as through a free one. A low
    /// `level` prefers wide detours, a high one short paths through narrow passages.
    pub level: i32,
    /// Weight of the remaining distance in the A* ordering; at least 1. The larger it is, the fewer cells are visited,
    /// and the longer the chains.
    pub haste: f64,
}

/// See [`Taste::level`].
const GROWTH: f64 = 1.7;
/// Maximum number of halvings of the box. Coordinates of cells are multiples of 2^-LEVELS of its sides.
const LEVELS: u8 = 14;
/// Cost of checking a motion, in visited cells.
const MOTION: usize = 10;

/// A cell decomposition.
#[derive(Debug, Clone)]
pub struct Decomposition {
    pieces: Vec<Piece>,
    low: Point,
    size: Vector,
    /// The whole box, followed by the eight parts of each divided cell.
    cells: Vec<Cell>,
    chains: Chains,
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

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Outside all pieces.
    Free,
    /// Neither inside one piece nor outside all of them, or the engine rejected a motion in it.
    Open,
    /// Inside a piece, or too small to be divided.
    Closed,
    /// Divided; holds the index of the first part.
    Divided(u32),
}

impl Kind {
    fn passable(self) -> bool {
        matches!(self, Kind::Free | Kind::Open)
    }
}

impl Decomposition {
    /// A single cell: the box of positions from `low` to `high`, m.
    pub fn new(pieces: Vec<Piece>, low: Point, high: Point) -> Self {
        let near = (0..pieces.len() as u32).collect();
        let center = nalgebra::center(&low, &high);
        let whole = Cell { low: [0; 3], level: 0, kind: Kind::Open, center, near, beside: Vec::new() };
        let chains = Chains::default();
        Decomposition { pieces, low, size: high - low, cells: vec![whole], chains, credit: 0, at_the_limit: false }
    }

    /// The forbidden polyhedra.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Searches for a path, visiting about `effort` cells. The next call continues the search and deducts what this
    /// call visited beyond that. `free` makes the final decision on motions within cells that no piece reaches into.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn way(
        &mut self,
        [start, goal]: [&Point; 2],
        free: &dyn Fn(&Point, &Point) -> bool,
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
            let open = |cell: &u32| self.cells[*cell as usize].kind == Kind::Open;
            let mut doubtful: Vec<u32> = chain.iter().copied().filter(open).collect();
            if doubtful.is_empty() {
                let places = self.places(&chain, start, goal);
                let refused = |k: &usize| !free(&places[*k], &places[k + 1]);
                doubtful = (0..chain.len()).filter(refused).map(|k| chain[k]).collect();
                self.credit -= (MOTION * chain.len()) as i64;
                if doubtful.is_empty() {
                    return Ok(Way::Path(places));
                }
            }
            doubtful.into_iter().for_each(|cell| self.divide(cell));
        }
        Ok(Way::Undecided)
    }

    /// Start, the centres of the contacts between consecutive cells, goal: between two of these points the path stays
    /// in one cell.
    fn places(&self, chain: &[u32], start: &Point, goal: &Point) -> Vec<Point> {
        let contact = |pair: &[u32]| {
            let [(a, b), (c, d)] = [self.bounds(pair[0]), self.bounds(pair[1])];
            nalgebra::center(&a.sup(&c), &b.inf(&d))
        };
        std::iter::once(*start).chain(chain.windows(2).map(contact)).chain([*goal]).collect()
    }

    /// Smallest and largest coordinates of a cell, m; equal where cells touch.
    fn bounds(&self, cell: u32) -> (Point, Point) {
        let cell = &self.cells[cell as usize];
        let at =
            |axis: usize, steps: u32| self.low[axis] + self.size[axis] * (f64::from(steps) / f64::from(1 << LEVELS));
        let corner = |steps: u32| Point::from(Vector::from_fn(|axis, _| at(axis, cell.low[axis] + steps)));
        (corner(0), corner(cell.span()))
    }

    /// The undivided cell that contains a position.
    fn cell_at(&self, place: &Point) -> u32 {
        let mut at = 0;
        while let Kind::Divided(first) = self.cells[at as usize].kind {
            let middle = self.bounds(first).1;
            at = first + (0..3).map(|axis| u32::from(place[axis] >= middle[axis]) << axis).sum::<u32>();
        }
        at
    }

    /// Divides a cell into eight, or closes it if it is too small.
    fn divide(&mut self, cell: u32) {
        let first = self.cells.len() as u32;
        let parent = &mut self.cells[cell as usize];
        let (low, level) = (parent.low, parent.level + 1);
        let (near, beside) = (std::mem::take(&mut parent.near), std::mem::take(&mut parent.beside));
        parent.kind = if level > LEVELS { Kind::Closed } else { Kind::Divided(first) };
        for &other in &beside {
            self.cells[other as usize].beside.retain(|&at| at != cell);
        }
        if level > LEVELS {
            self.at_the_limit = true;
            return;
        }
        for part in 0..8 {
            let low = std::array::from_fn(|axis| low[axis] + ((part >> axis & 1) << (LEVELS - level)));
            self.cells.push(Cell {
                low,
                level,
                kind: Kind::Open,
                center: Point::origin(),
                near: Vec::new(),
                beside: Vec::new(),
            });
            let new = first + part;
            self.classify(new, &near);
            self.connect(new, beside.iter().copied().chain(first..new));
        }
    }

    /// Classifies a new cell, given the pieces that may reach into it.
    fn classify(&mut self, new: u32, candidates: &[u32]) {
        let (low, high) = self.bounds(new);
        let (center, half) = (nalgebra::center(&low, &high), (high - low) * 0.5);
        let above = |plane: &HalfSpace| plane.height(&center) - plane.normal.abs().dot(&half) >= 0.0;
        let below = |plane: &HalfSpace| plane.height(&center) + plane.normal.abs().dot(&half) < 0.0;
        let piece = |index: &u32| &self.pieces[*index as usize];
        let reaches = |index: &u32| !piece(index).outer.iter().any(above);
        let near: Vec<u32> = candidates.iter().copied().filter(reaches).collect();
        let closed = near.iter().any(|index| piece(index).certain.as_ref().is_some_and(|all| all.iter().all(below)));
        let cell = &mut self.cells[new as usize];
        cell.center = center;
        cell.kind = match closed {
            true => Kind::Closed,
            false if near.is_empty() => Kind::Free,
            false => Kind::Open,
        };
        if !closed {
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
    fn span(&self) -> u32 {
        1 << (LEVELS - self.level)
    }

    fn touches(&self, other: &Cell) -> bool {
        let reaches = |a: &Cell, b: &Cell, axis: usize| a.low[axis] + a.span() >= b.low[axis];
        (0..3).all(|axis| reaches(self, other, axis) && reaches(other, self, axis))
    }
}
