//! A grid over the box of positions: for each cell the regions that reach into it. A motion asks only the regions of the
//! cells it passes.

use super::clip::CoarseGroup;
use super::region::Region;
use crate::geometry::{HalfSpace, Point, Vector};
use crate::numerics::CELL_ROUNDING;
use crate::numerics::simd::WIDTH;

/// Cells of equal size, `n` along each axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cells {
    min: Point,
    size: Vector,
    /// Cells per metre.
    density: Vector,
    n: usize,
}

/// How far a list reaches beyond its cell, in cells.
const OVERLAP: f64 = 0.5;

/// A piece of a segment may extend by half of it on both sides of its middle; a little less, for rounding.
const PIECES_PER_CELL: f64 = 0.5 / (OVERLAP - CELL_ROUNDING);

/// How a region lies to a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reach {
    /// It does not meet the box.
    Outside,
    /// It may meet the box.
    Partly,
    /// The box is inside of it.
    Full,
}

/// A cell that a region reaches into, and whether the cell is all inside of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reached {
    /// Index of the cell.
    pub cell: u32,
    /// Whether every position in the cell is forbidden.
    pub full: bool,
}

impl Cells {
    /// Divides a box into n³ cells; n must be a power of two.
    pub fn new(min: Point, max: Point, n: usize) -> Self {
        let extent = max - min;
        let density = extent.map(|e| if e > 0.0 { n as f64 / e } else { 0.0 });
        Cells { min, size: extent / n as f64, density, n }
    }

    /// How many cells there are.
    pub fn len(&self) -> usize {
        self.n * self.n * self.n
    }

    /// The cells that a region reaches into, found by halving the box again and again. `reach(center, half)` tells how the
    /// region lies to a box given by its centre and half its sides.
    pub fn reached(&self, reach: &dyn Fn(&Point, &Vector) -> Reach) -> Vec<Reached> {
        let mut found = Vec::new();
        self.descend([0; 3], self.n, reach, &mut found);
        found
    }

    fn descend(
        &self,
        corner: [usize; 3],
        n: usize,
        reach: &dyn Fn(&Point, &Vector) -> Reach,
        found: &mut Vec<Reached>,
    ) {
        let half = self.size * (0.5 * n as f64);
        let low = self.min + self.size.component_mul(&Vector::from_fn(|axis, _| corner[axis] as f64));
        match reach(&(low + half), &(half + self.size * OVERLAP)) {
            Reach::Outside => {}
            Reach::Full => self.take_all(corner, n, found),
            Reach::Partly if n == 1 => found.push(Reached { cell: self.index(corner) as u32, full: false }),
            Reach::Partly => {
                for k in 0..8 {
                    let child = std::array::from_fn(|axis| corner[axis] + (k >> axis & 1) * n / 2);
                    self.descend(child, n / 2, reach, found);
                }
            }
        }
    }

    fn take_all(&self, corner: [usize; 3], n: usize, found: &mut Vec<Reached>) {
        for k in 0..n * n * n {
            let cell = [corner[0] + k % n, corner[1] + k / n % n, corner[2] + k / (n * n)];
            found.push(Reached { cell: self.index(cell) as u32, full: true });
        }
    }

    #[inline(always)]
    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        x + self.n * (y + self.n * z)
    }

    /// Largest coordinate of a position, or a little more.
    fn largest(&self) -> f64 {
        let extent = self.size * self.n as f64;
        self.min.coords.abs().sup(&(self.min.coords + extent).abs()).sum()
    }

    /// The middle of a cell.
    fn center(&self, cell: usize) -> Point {
        let at = [cell % self.n, cell / self.n % self.n, cell / (self.n * self.n)];
        self.min + self.size.component_mul(&Vector::from(at.map(|k| k as f64 + 0.5)))
    }

    /// Into how many equal pieces a segment must be cut so that each is covered by the list of the cell in its middle.
    #[inline(always)]
    pub fn pieces(&self, from: &Point, to: &Point) -> usize {
        let needed = (to - from).component_mul(&self.density).abs();
        1 + (needed.x.max(needed.y).max(needed.z) * PIECES_PER_CELL) as usize
    }

    /// The cell of a position; the nearest one for positions outside.
    #[inline(always)]
    pub fn cell(&self, p: &Point) -> usize {
        let last = (self.n - 1) as f64;
        let at = (p - self.min).component_mul(&self.density);
        let [x, y, z] = [at.x, at.y, at.z].map(|c| c.max(0.0).min(last) as u32 as usize);
        x + self.n * (y + self.n * z)
    }
}

/// For each cell the regions that reach into it, four to a group, each with the plane most likely to rule it out there.
#[derive(Debug, Clone, Default)]
pub struct Lists {
    /// The groups of cell k are `starts[k]..starts[k + 1]`.
    starts: Vec<u32>,
    planes: Vec<CoarseGroup>,
    regions: Vec<[u32; WIDTH]>,
}

/// Marks the one entry of a cell that lies inside a region.
pub const FULL: u32 = 1 << 31;

impl Lists {
    /// Sorts regions by the cells they reach into.
    pub fn new<'a>(cells: &Cells, pieces: impl Iterator<Item = (&'a Region, &'a [Reached])> + Clone) -> Self {
        const NONE: u32 = u32::MAX;
        let mut full = vec![NONE; cells.len()];
        let mut count = vec![0; cells.len()];
        for (region, (_, reached)) in pieces.clone().enumerate() {
            for reached in reached {
                count[reached.cell as usize] += 1;
                if reached.full {
                    full[reached.cell as usize] = region as u32 | FULL;
                }
            }
        }
        let mut starts = vec![0; cells.len() + 1];
        for cell in 0..cells.len() {
            let entries: usize = if full[cell] == NONE { count[cell] } else { 1 };
            starts[cell + 1] = starts[cell] + entries.div_ceil(WIDTH) as u32;
        }
        let groups = starts[cells.len()] as usize;
        let mut planes = vec![CoarseGroup::ALL_OUTSIDE; groups];
        let mut regions = vec![[0; WIDTH]; groups];
        let mut put = |cell: usize, lane: usize, plane: &HalfSpace, region: u32| {
            let group = starts[cell] as usize + lane / WIDTH;
            planes[group].set(lane % WIDTH, plane, cells.largest());
            regions[group][lane % WIDTH] = region;
        };
        let mut filled = vec![0; cells.len()];
        for (region, (bounds, reached)) in pieces.enumerate() {
            for cell in reached.iter().map(|r| r.cell as usize).filter(|&cell| full[cell] == NONE) {
                put(cell, filled[cell], &witness(bounds, &cells.center(cell)), region as u32);
                filled[cell] += 1;
            }
        }
        for cell in (0..cells.len()).filter(|&cell| full[cell] != NONE) {
            put(cell, 0, &NOTHING_OUTSIDE, full[cell]);
        }
        Lists { starts, planes, regions }
    }

    /// The planes and the regions of a cell.
    #[inline(always)]
    pub fn of(&self, cell: usize) -> (&[CoarseGroup], &[[u32; WIDTH]]) {
        let range = self.starts[cell] as usize..self.starts[cell + 1] as usize;
        (&self.planes[range.clone()], &self.regions[range])
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        4 * self.starts.capacity() + self.planes.capacity() * (size_of::<CoarseGroup>() + 4 * WIDTH)
    }
}

/// A half-space that holds everything.
const NOTHING_OUTSIDE: HalfSpace = HalfSpace { normal: Vector::new(0.0, 0.0, 0.0), offset: f64::INFINITY };

/// The plane of a region that a place is farthest outside of, or least inside.
fn witness(region: &Region, place: &Point) -> HalfSpace {
    let planes = region.outer.iter().flatten();
    planes.max_by(|a, b| a.height(place).total_cmp(&b.height(place))).copied().unwrap_or(NOTHING_OUTSIDE)
}

/// Whether one plane of a polyhedron has a whole box outside.
pub fn outside(polyhedron: &[HalfSpace], center: &Point, half: &Vector) -> bool {
    polyhedron.iter().any(|h| h.height(center) >= h.normal.abs().dot(half))
}

/// Whether a polyhedron, its planes moved outward by `widen`, holds a whole box.
pub fn holds(polyhedron: &[HalfSpace], widen: f64, center: &Point, half: &Vector) -> bool {
    polyhedron.iter().all(|h| h.height(center) - widen <= -h.normal.abs().dot(half))
}
