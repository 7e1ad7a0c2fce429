//! A grid of positions, its feasible cells, and the cells that a motion crosses. Implements the paper's rule, by which
//! the nearest grid point decides about a position, and a stricter one, by which all corners of its cell decide.

use super::measure::Measure;
use crate::batch::each;
use crate::error::Error;
use crate::geometry::{Cuboid, Point, Vector};
use crate::model::MembershipSpec;
use crate::simd::WIDTH;

/// Maximum number of nodes; more are probably due to a wrong unit.
const MOST_NODES: f64 = 1e8;

/// Number of groups of points from which on they are computed in parallel.
const IN_PARALLEL: usize = 64;

/// Cells of a box of positions. A cell is feasible if all its corners are, or if the grid point at its centre is.
#[derive(Debug, Clone, PartialEq)]
pub struct FeasibleCells {
    membership: MembershipSpec,
    min: Point,
    size: f64,
    counts: [usize; 3],
    feasible: Vec<bool>,
}

impl FeasibleCells {
    /// Cells of this size over a box of positions; the grid points are evaluated on all cores.
    ///
    /// # Errors
    /// Too many points.
    pub fn new(
        measures: &[Measure],
        (min, max): (Point, Point),
        size: f64,
        membership: MembershipSpec,
    ) -> Result<Self, Error> {
        let cells = (max - min).map(|extent| (extent / size).ceil().max(1.0));
        if (min - max).max() > 0.0 {
            return Ok(FeasibleCells { membership, min, size, counts: [0; 3], feasible: Vec::new() });
        }
        let nodes = cells.map(|n| n + 1.0);
        if nodes.product() > MOST_NODES {
            let problem =
                format!("found {size} m, which makes {:.1e} points; expected at most {MOST_NODES:e}", nodes.product());
            return Err(Error::invalid("wrench.grid", problem));
        }
        let counts: [usize; 3] = std::array::from_fn(|axis| cells[axis] as usize);
        let points = feasible_points(measures, &min, size, counts);
        let nodes = counts.map(|n| n + 1);
        if membership == MembershipSpec::Nearest {
            let min = min - Vector::repeat(0.5 * size);
            return Ok(FeasibleCells { membership, min, size, counts: nodes, feasible: points });
        }
        let corner = |i: usize, j: usize, k: usize| points[i + nodes[0] * (j + nodes[1] * k)];
        let around = |i: usize, j: usize, k: usize| (0..8).all(|c| corner(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)));
        let [cx, cy, cz] = counts;
        let cells = (0..cx * cy * cz).map(|n| around(n % cx, n / cx % cy, n / (cx * cy)));
        Ok(FeasibleCells { membership, min, size, counts, feasible: cells.collect() })
    }

    /// The fraction of a motion at which it first enters an infeasible cell or leaves the grid, and that cell; `None`
    /// if it never does. A wall belongs to the cell above it, so a motion that ends on one enters that cell.
    pub fn first_infeasible(&self, from: &Point, to: &Point) -> Option<(f64, [i64; 3])> {
        let (start, step) = ((from - self.min) / self.size, (to - from) / self.size);
        let mut cell = self.cell_at(from);
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
            // Through an edge: upward first, since the edge belongs to the cell above it.
            let down = |axis: usize| step[axis] < 0.0;
            let order = |&a: &usize, &b: &usize| wall(a).total_cmp(&wall(b)).then(down(a).cmp(&down(b)));
            let next = (0..3).min_by(order).expect("three axes");
            if !(wall(next) < 1.0) {
                return self.end_infeasible(to);
            }
            at = wall(next).max(at);
            cell[next] += if step[next] > 0.0 { 1 } else { -1 };
            if self.leaves(cell, to) {
                return self.end_infeasible(to); // the end is inside; it appears outside only because of rounding
            }
        }
    }

    /// Whether all cells that a box reaches into are feasible, or none of them; `None` if some are.
    pub fn over(&self, positions: &Cuboid) -> Option<bool> {
        let [low, high] = [&positions.low, &positions.high].map(|corner| self.cell_at(corner));
        let cells = (low[0]..=high[0])
            .flat_map(|i| (low[1]..=high[1]).flat_map(move |j| (low[2]..=high[2]).map(move |k| [i, j, k])));
        let first = self.is_feasible(low);
        cells.into_iter().all(|cell| self.is_feasible(cell) == first).then_some(first)
    }

    fn end_infeasible(&self, to: &Point) -> Option<(f64, [i64; 3])> {
        let cell = self.cell_at(to);
        (!self.is_feasible(cell)).then_some((1.0, cell))
    }

    /// The grid points that decide about a cell.
    pub fn points(&self, cell: [i64; 3]) -> Vec<Point> {
        let at = |offset: Vector| self.min + (Vector::from_fn(|axis, _| cell[axis] as f64) + offset) * self.size;
        match self.membership {
            MembershipSpec::Nearest => vec![at(Vector::repeat(0.5))],
            MembershipSpec::Corners => {
                (0..8).map(|c| at(Vector::from_fn(|axis, _| f64::from(c >> axis & 1)))).collect()
            }
        }
    }

    fn cell_at(&self, position: &Point) -> [i64; 3] {
        let at = (position - self.min) / self.size;
        std::array::from_fn(|axis| self.cell_of(axis, at[axis]))
    }

    /// The cell of a coordinate; the upper end of the grid belongs to its last cell. `None` for NaN.
    fn cell_of(&self, axis: usize, x: f64) -> i64 {
        if x.is_nan() {
            return -1;
        }
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

/// Whether each grid point has sufficient slack, x fastest. A set of lower rank has no slack, up to rounding.
fn feasible_points(measures: &[Measure], min: &Point, size: f64, counts: [usize; 3]) -> Vec<bool> {
    let [nx, ny, nz] = counts.map(|n| n + 1);
    let at = |n: usize| min + Vector::new((n % nx) as f64, (n / nx % ny) as f64, (n / (nx * ny)) as f64) * size;
    let count = nx * ny * nz;
    let four = |(): &mut (), group: usize| {
        let positions = std::array::from_fn(|k| at(group * WIDTH + k));
        let slack: Vec<[f64; WIDTH]> = measures.iter().map(|measure| measure.slack_at_four(&positions)).collect();
        let enough = |k: usize| slack.iter().zip(measures).all(|(slack, measure)| slack[k] >= measure.floor());
        Ok(std::array::from_fn::<bool, WIDTH, _>(enough))
    };
    let mut points = each(count.div_ceil(WIDTH), IN_PARALLEL, &four).expect("nothing stops it").into_flattened();
    points.truncate(count);
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four by three by two cells of 0.25 m from (1, 0, 0) on, all feasible but these.
    fn cells(infeasible: &[[usize; 3]]) -> FeasibleCells {
        let mut feasible = vec![true; 24];
        infeasible.iter().for_each(|[i, j, k]| feasible[i + 4 * (j + 3 * k)] = false);
        let (membership, min) = (MembershipSpec::Corners, Point::new(1.0, 0.0, 0.0));
        FeasibleCells { membership, min, size: 0.25, counts: [4, 3, 2], feasible }
    }

    fn first_infeasible(cells: &FeasibleCells, from: &Point, to: &Point) -> Option<f64> {
        cells.first_infeasible(from, to).map(|(at, _)| at)
    }

    /// A position in cells.
    fn at(x: f64, y: f64, z: f64) -> Point {
        Point::new(1.0 + 0.25 * x, 0.25 * y, 0.25 * z)
    }

    #[test]
    fn a_motion_ending_on_a_wall_enters_the_cell_above() {
        let cells = cells(&[[2, 1, 0]]);
        let (from, wall) = (at(0.5, 1.5, 0.5), at(2.0, 1.5, 0.5));
        assert_eq!(first_infeasible(&cells, &wall, &wall), Some(0.0));
        assert_eq!(first_infeasible(&cells, &from, &wall), Some(1.0));
        assert_eq!(first_infeasible(&cells, &wall, &from), Some(0.0));
        let (above, below) = (at(3.5, 1.5, 0.5), at(3.0, 1.5, 0.5));
        assert_eq!(first_infeasible(&cells, &above, &below), None);
        let through = first_infeasible(&cells, &above, &from).expect("refused");
        assert!((through - 1.0 / 6.0).abs() < 1e-12);
    }

    #[test]
    fn the_upper_end_of_the_grid_belongs_to_its_last_cell() {
        let cells = cells(&[]);
        let (low, high) = (at(0.0, 0.0, 0.0), at(4.0, 3.0, 2.0));
        for (from, to) in [(low, high), (high, low), (high, high), (high, at(4.0, 0.0, 2.0)), (at(4.0, 0.0, 0.0), high)]
        {
            assert_eq!(first_infeasible(&cells, &from, &to), None);
        }
        assert!(first_infeasible(&cells, &low, &at(4.1, 0.0, 0.0)).is_some());
        assert!(first_infeasible(&cells, &low, &at(f64::NAN, 0.0, 0.0)).is_some());
    }

    #[test]
    fn no_place_of_an_accepted_motion_is_in_an_infeasible_cell() {
        let cells = cells(&[[2, 1, 0], [0, 2, 1], [3, 0, 0]]);
        let place = |n: usize| at((n % 9) as f64 / 2.0, (n / 9 % 7) as f64 / 2.0, (n / 63) as f64 / 2.0);
        let (mut accepted, mut refused) = (0, 0);
        for (from, to) in (0..315).flat_map(|a| (0..315).map(move |b| (place(a), place(b)))) {
            let refuses = first_infeasible(&cells, &from, &to);
            let within = |k: usize| cells.is_feasible(cells.cell_at(&(from + (to - from) * (k as f64 / 24.0))));
            assert!(refuses.is_some() || (0..=24).all(within), "{from} to {to}");
            if refuses.is_some() { refused += 1 } else { accepted += 1 }
        }
        assert!(accepted > 10_000 && refused > 10_000, "{accepted} accepted, {refused} refused");
    }
}
