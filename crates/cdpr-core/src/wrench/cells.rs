//! The paper's rule: a grid over the positions, feasible cells, and the cells that a motion crosses.

use rayon::prelude::*;

use super::measure::Measure;
use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::numerics::simd::WIDTH;

/// Most nodes of a grid: beyond it lies a slip of the unit.
const MOST_NODES: f64 = 1e8;

/// Cells of a box of positions; a cell is feasible when all its corners are.
#[derive(Debug, Clone, PartialEq)]
pub struct FeasibleCells {
    min: Point,
    size: f64,
    counts: [usize; 3],
    feasible: Vec<bool>,
}

impl FeasibleCells {
    /// Cells of this size over a box of positions, their corners measured on all cores.
    ///
    /// # Errors
    /// More corners than would fit.
    pub fn new(measures: &[Measure], (min, max): (Point, Point), size: f64) -> Result<Self, Error> {
        let cells = (max - min).map(|extent| (extent / size).ceil().max(1.0));
        if (min - max).max() > 0.0 {
            return Ok(FeasibleCells { min, size, counts: [0; 3], feasible: Vec::new() });
        }
        let nodes = cells.map(|n| n + 1.0);
        if nodes.product() > MOST_NODES {
            let problem =
                format!("found {size} m, which makes {:.1e} corners; expected at most {MOST_NODES:e}", nodes.product());
            return Err(Error::invalid("wrench.grid", problem));
        }
        let counts: [usize; 3] = std::array::from_fn(|axis| cells[axis] as usize);
        let corners = feasible_corners(measures, &min, size, counts);
        let [nx, ny, _] = counts.map(|n| n + 1);
        let corner = |i: usize, j: usize, k: usize| corners[i + nx * (j + ny * k)];
        let around = |i: usize, j: usize, k: usize| (0..8).all(|c| corner(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)));
        let [cx, cy, cz] = counts;
        let cells = (0..cx * cy * cz).map(|n| around(n % cx, n / cx % cy, n / (cx * cy)));
        Ok(FeasibleCells { min, size, counts, feasible: cells.collect() })
    }

    /// The fraction of a motion at which it enters a cell that is not feasible, or leaves the grid, and that cell; none if it
    /// never does.
    pub fn first_infeasible(&self, from: &Point, to: &Point) -> Option<(f64, [i64; 3])> {
        let (start, step) = ((from - self.min) / self.size, (to - from) / self.size);
        let mut cell: [i64; 3] = std::array::from_fn(|axis| self.cell_of(axis, start[axis]));
        let mut at = 0.0;
        loop {
            if !self.is_feasible(cell) {
                return Some((at, cell));
            }
            // The next wall: along each axis the far one of the cell.
            let wall = |axis: usize| {
                let far = cell[axis] as f64 + if step[axis] > 0.0 { 1.0 } else { 0.0 };
                if step[axis] == 0.0 { f64::INFINITY } else { (far - start[axis]) / step[axis] }
            };
            let next = (0..3).min_by(|&a, &b| wall(a).total_cmp(&wall(b))).expect("three axes");
            if !(wall(next) < 1.0) {
                return None;
            }
            at = wall(next).max(at);
            cell[next] += if step[next] > 0.0 { 1 } else { -1 };
            if self.leaves(cell, to) {
                return None; // only rounding leads out of the grid while the motion ends inside
            }
        }
    }

    /// The corners of a cell.
    pub fn corners(&self, cell: [i64; 3]) -> [Point; 8] {
        let corner = |c: usize| Vector::from_fn(|axis, _| (cell[axis] + (c >> axis & 1) as i64) as f64);
        std::array::from_fn(|c| self.min + corner(c) * self.size)
    }

    /// The cell of a coordinate; the upper end of the grid belongs to its last cell.
    fn cell_of(&self, axis: usize, x: f64) -> i64 {
        let cell = x.floor() as i64;
        if cell == self.counts[axis] as i64 && x - cell as f64 <= END { cell - 1 } else { cell }
    }

    fn leaves(&self, cell: [i64; 3], to: &Point) -> bool {
        let end = (to - self.min) / self.size;
        (0..3).any(|axis| cell[axis] == self.counts[axis] as i64 && end[axis] - cell[axis] as f64 <= END)
            || (0..3).any(|axis| cell[axis] == -1 && end[axis] >= -END)
    }

    fn is_feasible(&self, cell: [i64; 3]) -> bool {
        let inside = (0..3).all(|axis| (0..self.counts[axis] as i64).contains(&cell[axis]));
        let [i, j, k] = cell.map(|n| n as usize);
        inside && self.feasible[i + self.counts[0] * (j + self.counts[1] * k)]
    }
}

/// How far beyond the end of the grid a coordinate may lie by rounding, in cells.
const END: f64 = 1e-9;

/// Whether each corner of the cells has slack, x fastest.
fn feasible_corners(measures: &[Measure], min: &Point, size: f64, counts: [usize; 3]) -> Vec<bool> {
    let [nx, ny, nz] = counts.map(|n| n + 1);
    let at = |n: usize| min + Vector::new((n % nx) as f64, (n / nx % ny) as f64, (n / (nx * ny)) as f64) * size;
    let mut corners = vec![false; nx * ny * nz];
    corners.par_chunks_mut(WIDTH).enumerate().with_min_len(64).for_each(|(chunk, corners)| {
        let positions = std::array::from_fn(|k| at(chunk * WIDTH + k));
        let slack: Vec<[f64; WIDTH]> = measures.iter().map(|measure| measure.slack_at_four(&positions)).collect();
        for (k, corner) in corners.iter_mut().enumerate() {
            *corner = slack.iter().all(|slack| slack[k] >= 0.0);
        }
    });
    corners
}
