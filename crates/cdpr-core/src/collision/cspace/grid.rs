//! A grid over the box of positions: for each cell, the regions that overlap it. A motion is tested only against the
//! regions of the cells it passes through.
//!
//! The box is divided into 4³ to 32³ cells. A cell lists the regions that overlap it or come within half a cell; they are
//! found once by recursive bisection, eight boxes at a time, keeping only those planes that do not have the whole box
//! inside. A cell inside one region is *full*. A motion is cut into equal pieces no longer than a cell; the list of the
//! cell at a piece's midpoint covers the piece. Each entry has one plane of its region, the one that the cell's centre is
//! farthest outside of, in 16-bit integers relative to the cell and widened accordingly: eight of them fit in a cache line
//! and are compared at once. A valid motion of 0.1 m in scenes like the paper's leaves 0.04 to 0.15 regions to test in
//! full.

use super::segment_clip::{CoarseGroup, CoarsePlace, CoarsePlane};
use crate::conditions::{Inner, Region};
use crate::error::Error;
use crate::geometry::{HalfSpace, Point, Vector};
use crate::simd::{INTEGERS, Kernel, Lanes, Task, WIDTH};
use crate::tolerances::CELL_ROUNDING;
use crate::watch::Watch;

/// Cells of equal size, `n` along each axis.
#[derive(Debug, Clone, Copy)]
pub struct Cells {
    min: Point,
    size: Vector,
    /// Cells per metre.
    density: Vector,
    n: usize,
    kernel: Kernel,
}

impl PartialEq for Cells {
    fn eq(&self, other: &Self) -> bool {
        let all = |cells: &Cells| (cells.min, cells.size, cells.density, cells.n);
        all(self) == all(other)
    }
}

/// How far beyond its cell a list is valid, in cells.
const OVERLAP: f64 = 0.5;

/// A piece of a segment may extend by half its length on both sides of its midpoint; slightly less, for rounding.
const PIECES_PER_CELL: f64 = 0.5 / (OVERLAP - CELL_ROUNDING);

/// A cell that a region overlaps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reached {
    /// Index of the cell.
    pub cell: u32,
    /// The outer plane of the region above which the centre of the cell is highest, inside or outside, or
    /// [`NO_WITNESS`].
    pub witness: u16,
    /// Whether every position in the cell is forbidden.
    pub full: bool,
}

/// Denotes a plane with everything inside.
pub const NO_WITNESS: u16 = u16::MAX;

impl Cells {
    /// Divides a box into n³ cells; n must be a power of two, from 2 to [`MOST_CELLS`].
    pub fn new(min: Point, max: Point, n: usize) -> Self {
        let extent = max - min;
        let density = extent.map(|e| if e > 0.0 { n as f64 / e } else { 0.0 });
        Cells { min, size: extent / n as f64, density, n, kernel: Kernel::best() }
    }

    /// The number of cells.
    pub fn len(&self) -> usize {
        self.n * self.n * self.n
    }

    /// The cells that a region overlaps, found by recursive bisection of the box. `may_reach(center, half)` returns
    /// whether the region may overlap a box, given its centre and half its sides.
    pub fn reached(&self, may_reach: &dyn Fn(&Point, &Vector) -> bool) -> Vec<Reached> {
        let mut found = Vec::new();
        self.descend([0; 3], self.n, may_reach, &mut found);
        found
    }

    fn descend(
        &self,
        corner: [usize; 3],
        n: usize,
        may_reach: &dyn Fn(&Point, &Vector) -> bool,
        found: &mut Vec<Reached>,
    ) {
        let half = self.size * (0.5 * n as f64);
        let low = self.min + self.size.component_mul(&Vector::from_fn(|axis, _| corner[axis] as f64));
        if !may_reach(&(low + half), &(half + self.size * OVERLAP)) {
            return;
        }
        if n == 1 {
            found.push(Reached { cell: self.index(corner) as u32, witness: NO_WITNESS, full: false });
            return;
        }
        for k in 0..8 {
            let child = std::array::from_fn(|axis| corner[axis] + (k >> axis & 1) * n / 2);
            self.descend(child, n / 2, may_reach, found);
        }
    }

    /// The cells that a polyhedral region overlaps. The descent keeps only the planes that still matter: if a box is
    /// inside a plane, so are all boxes in it.
    pub fn reached_by(&self, outer: &[HalfSpace], inner: &Inner) -> Vec<Reached> {
        let mut descent = Descent::new(self, outer, inner);
        let center = self.min + self.size * (0.5 * self.n as f64);
        let reach = 0.5 * self.n as f64 + OVERLAP;
        let over = |cut: &Cut| cut.plane.height(&center);
        if descent.cuts.iter().any(|cut| cut.outer && over(cut) >= cut.extent * reach) {
            return Vec::new();
        }
        let matters = |cut: &Cut| over(cut) > cut.limit - cut.extent * reach;
        descent.active = (0..descent.cuts.len() as u32).filter(|&k| matters(&descent.cuts[k as usize])).collect();
        if descent.fills && descent.own_filled(descent.active.iter().copied()) {
            self.take_all([0; 3], self.n, &mut descent.found);
        } else {
            descent.children([0; 3], self.n, 0);
        }
        descent.found.shrink_to_fit();
        descent.found
    }

    fn take_all(&self, corner: [usize; 3], n: usize, found: &mut Vec<Reached>) {
        for k in 0..n * n * n {
            let cell = [corner[0] + k % n, corner[1] + k / n % n, corner[2] + k / (n * n)];
            found.push(Reached { cell: self.index(cell) as u32, witness: NO_WITNESS, full: true });
        }
    }

    /// A half-space in the format of the lists, relative to the corner of the box.
    fn coarse(&self, half_space: &HalfSpace) -> CoarsePlane {
        CoarsePlane::new(&half_space.normal.component_mul(&self.size), -half_space.height(&self.min))
    }

    /// Index of a cell in Morton order: cells close to each other have indices close to each other.
    #[inline(always)]
    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (SPREAD[x % MOST_CELLS] | SPREAD[y % MOST_CELLS] << 1 | SPREAD[z % MOST_CELLS] << 2) as usize
    }

    /// A position in cells from the corner of the box.
    #[inline(always)]
    pub fn place<L: Lanes>(&self, l: L, p: &Point) -> L::Four {
        let at = (p - self.min).component_mul(&self.density);
        l.load(&[at.x, at.y, at.z, 0.0])
    }

    /// The number of equal pieces into which to cut a segment so that the list of the cell at its centre covers each
    /// piece.
    #[inline(always)]
    pub fn pieces<L: Lanes>(&self, l: L, way: L::Four) -> usize {
        let [x, y, z, _] = l.store(l.abs(way));
        1 + (x.max(y).max(z) * PIECES_PER_CELL) as usize
    }

    /// The cell that contains the midpoint of a piece (the nearest cell if that is outside), and the piece relative to
    /// the centre of that cell.
    #[inline(always)]
    pub fn cell<L: Lanes>(&self, l: L, start: L::Four, way: L::Four) -> (usize, [CoarsePlace; 2]) {
        let half = l.splat(0.5);
        let middle = l.add(start, l.mul(way, half));
        let [x, y, z, _] = l.truncated(l.min(l.max(middle, l.splat(0.0)), l.splat((self.n - 1) as f64)));
        let corner = l.load(&[f64::from(x), f64::from(y), f64::from(z), 0.0]);
        let from = l.sub(start, l.add(corner, half));
        let cell = self.index([x as usize, y as usize, z as usize]);
        (cell, [CoarsePlace::new(l, from), CoarsePlace::new(l, l.add(from, way))])
    }
}

/// Largest number of cells along an axis.
const MOST_CELLS: usize = 32;

/// The bits of each number, each followed by two zeros.
const SPREAD: [u32; MOST_CELLS] = {
    let mut spread = [0; MOST_CELLS];
    let mut k = 0;
    while k < MOST_CELLS {
        let mut bit = 0;
        while bit < 5 {
            spread[k] |= (k as u32 >> bit & 1) << (3 * bit);
            bit += 1;
        }
        k += 1;
    }
    spread
};

/// Every third bit of a number, the inverse of [`SPREAD`].
#[inline]
fn gathered(spread: u32) -> u32 {
    let ones = spread & 0b001_001_001_001_001;
    let pairs = (ones | ones >> 2) & 0b001_000_011_000_011;
    let fours = (pairs | pairs >> 4) & 0b001_000_000_001_111;
    (fours | fours >> 8) & 0b11111
}

/// The centre of a cell, in cells from the corner of the box.
#[inline]
fn middle(cell: usize) -> Vector {
    let cell = cell as u32;
    Vector::new(f64::from(gathered(cell)), f64::from(gathered(cell >> 1)), f64::from(gathered(cell >> 2)))
        .add_scalar(0.5)
}

/// A plane during the descent.
struct Cut {
    plane: HalfSpace,
    /// The extent of a cell along the normal, by axis, m.
    across: Vector,
    /// The sum of the magnitudes in `across`: half the extent of a box along the normal, per cell of half its side, m.
    extent: f64,
    /// The plane matters to a box if part of the box is higher than this, m.
    limit: f64,
    /// Whether points outside the plane are outside the region.
    outer: bool,
}

/// The position of a plane relative to the eight octants of a box.
#[derive(Clone, Copy)]
struct Sides {
    /// Index of the plane.
    cut: u32,
    /// One bit for each octant that is outside the plane.
    outside: u8,
    /// One bit for each octant to which the plane matters.
    matters: u8,
}

/// Finds the cells that a region overlaps.
struct Descent<'a> {
    cells: &'a Cells,
    cuts: Vec<Cut>,
    /// Whether a box may lie inside the region.
    fills: bool,
    /// Whether `fills` depends on planes other than the outer ones.
    own: bool,
    /// The planes that matter, for each box on the current branch of the descent.
    active: Vec<u32>,
    sides: Vec<Sides>,
    found: Vec<Reached>,
}

/// Classifies the eight octants of a box of `n` cells per side around its centre.
struct Classify<'a, 'b> {
    descent: &'b mut Descent<'a>,
    center: Point,
    n: usize,
    first: usize,
}

impl Task for Classify<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let Descent { cuts, active, sides, .. } = self.descent;
        let reach = 0.25 * self.n as f64 + OVERLAP;
        let aside = 0.25 * self.n as f64;
        for &k in &active[self.first..] {
            let cut = &cuts[k as usize];
            let middle = cut.plane.height(&self.center);
            let [x, y, z] = [cut.across.x * aside, cut.across.y * aside, cut.across.z * aside];
            let flat = l.load(&[-x - y, x - y, y - x, x + y]);
            let (low, high) = (l.add(l.splat(middle - z), flat), l.add(l.splat(middle + z), flat));
            let (top, floor) = (cut.extent * reach, cut.limit - cut.extent * reach);
            let out = l.not_negative(l.sub(low, l.splat(top))) | l.not_negative(l.sub(high, l.splat(top))) << WIDTH;
            let below =
                l.not_negative(l.sub(l.splat(floor), low)) | l.not_negative(l.sub(l.splat(floor), high)) << WIDTH;
            sides.push(Sides { cut: k, outside: out as u8, matters: !below as u8 });
        }
    }
}

/// The position of the planes relative to the eight cells of a box of two cells per side.
struct Leaves {
    /// One bit for each cell that is outside the region.
    outside: u8,
    /// One bit for each cell to which an outer plane matters, and to which a plane of the inner polyhedron matters.
    matters: [u8; 2],
    /// The outer plane that the centre of each cell is highest above.
    witnesses: [[f64; WIDTH]; 2],
}

/// Classifies the eight cells around a point.
struct ClassifyLeaves<'a, 'b> {
    descent: &'b Descent<'a>,
    center: Point,
    first: usize,
}

impl Task for ClassifyLeaves<'_, '_> {
    type Output = Leaves;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> Leaves {
        const ASIDE: f64 = 0.5;
        const REACH: f64 = ASIDE + OVERLAP;
        let Descent { cuts, active, .. } = self.descent;
        let (mut outside, mut inside) = (0, [ALL_LEAVES; 2]);
        let mut highest = [l.splat(f64::NEG_INFINITY); 2];
        let mut witnesses = [l.splat(f64::from(NO_WITNESS)); 2];
        for &k in &active[self.first..] {
            let cut = &cuts[k as usize];
            let middle = cut.plane.height(&self.center);
            let [x, y, z] = [cut.across.x * ASIDE, cut.across.y * ASIDE, cut.across.z * ASIDE];
            let flat = l.load(&[-x - y, x - y, y - x, x + y]);
            let over = [l.add(l.splat(middle - z), flat), l.add(l.splat(middle + z), flat)];
            let (top, floor) = (l.splat(cut.extent * REACH), l.splat(cut.limit - cut.extent * REACH));
            let below = l.not_negative(l.sub(floor, over[0])) | l.not_negative(l.sub(floor, over[1])) << WIDTH;
            if cut.outer {
                inside[0] &= below;
                outside |= l.not_negative(l.sub(over[0], top)) | l.not_negative(l.sub(over[1], top)) << WIDTH;
                let index = l.splat(f64::from(k.min(u32::from(NO_WITNESS))));
                for half in 0..2 {
                    let higher = l.sub(over[half], highest[half]);
                    witnesses[half] = l.where_not_negative(higher, index, witnesses[half]);
                    highest[half] = l.max(highest[half], over[half]);
                }
            } else {
                inside[1] &= below;
            }
        }
        Leaves {
            outside: outside as u8,
            matters: [!inside[0] as u8, !inside[1] as u8],
            witnesses: [l.store(witnesses[0]), l.store(witnesses[1])],
        }
    }
}

/// One bit for each of eight cells.
const ALL_LEAVES: u32 = 0xff;

impl<'a> Descent<'a> {
    fn new(cells: &'a Cells, outer: &[HalfSpace], inner: &Inner) -> Self {
        let cut = |plane: &HalfSpace, limit: f64, outer: bool| {
            let across = plane.normal.component_mul(&cells.size);
            Cut { plane: *plane, across, extent: across.abs().sum(), limit, outer }
        };
        let limit = if let Inner::Shrunk(widen) = inner { *widen } else { 0.0 };
        let mut cuts: Vec<Cut> = outer.iter().map(|h| cut(h, limit, true)).collect();
        if let Inner::Own(planes) = inner {
            cuts.extend(planes.iter().map(|h| cut(h, 0.0, false)));
        }
        Descent {
            cells,
            cuts,
            fills: !matches!(inner, Inner::Unknown),
            own: matches!(inner, Inner::Own(_)),
            active: Vec::new(),
            sides: Vec::new(),
            found: Vec::new(),
        }
    }

    /// Whether a box is inside the inner polyhedron, given the planes that matter to it.
    fn own_filled(&self, mut active: impl Iterator<Item = u32>) -> bool {
        active.all(|k| self.own && self.cuts[k as usize].outer)
    }

    /// Classifies the eight octants of a box of `n` cells per side. The planes that matter to it start at `first` in
    /// `active`; those added here are removed again.
    fn children(&mut self, corner: [usize; 3], n: usize, first: usize) {
        let cells = self.cells;
        let at = Vector::from_fn(|axis, _| (corner[axis] + n / 2) as f64);
        let center = cells.min + cells.size.component_mul(&at);
        if n == 2 {
            return self.leaves(corner, center, first);
        }
        let (base, last) = (self.sides.len(), self.active.len());
        cells.kernel.run(Classify { descent: self, center, n, first });
        let (mut outside, mut beyond) = (0u8, 0u8);
        for sides in &self.sides[base..] {
            if self.cuts[sides.cut as usize].outer {
                outside |= sides.outside;
            } else {
                beyond |= sides.outside;
            }
        }
        for c in (0..8).filter(|c| outside >> c & 1 == 0) {
            let child = std::array::from_fn(|axis| corner[axis] + (c >> axis & 1) * n / 2);
            let mut full = self.fills;
            // If a box is outside one plane of the inner polyhedron, it is not inside the polyhedron, and the other
            // inner planes do not matter.
            let mut kept_beyond = false;
            for slot in base..self.sides.len() {
                let sides = &self.sides[slot];
                if sides.matters >> c & 1 == 0 {
                    continue;
                }
                if self.cuts[sides.cut as usize].outer {
                    full &= self.own;
                } else {
                    full = false;
                    if beyond >> c & 1 == 1 {
                        if kept_beyond || sides.outside >> c & 1 == 0 {
                            continue;
                        }
                        kept_beyond = true;
                    }
                }
                self.active.push(sides.cut);
            }
            if full {
                cells.take_all(child, n / 2, &mut self.found);
            } else {
                self.children(child, n / 2, last);
            }
            self.active.truncate(last);
        }
        self.sides.truncate(base);
    }

    /// Classifies the eight cells of a box of two cells per side.
    fn leaves(&mut self, corner: [usize; 3], center: Point, first: usize) {
        let leaves = self.cells.kernel.run(ClassifyLeaves { descent: self, center, first });
        let free_of = |planes: usize, c: usize| leaves.matters[planes] >> c & 1 == 0;
        for c in (0..8).filter(|c| leaves.outside >> c & 1 == 0) {
            let cell = std::array::from_fn(|axis| corner[axis] + (c >> axis & 1));
            let full = self.fills && free_of(1, c) && (self.own || free_of(0, c));
            let witness = leaves.witnesses[c / WIDTH][c % WIDTH] as u16;
            self.found.push(Reached { cell: self.cells.index(cell) as u32, witness, full });
        }
    }
}

/// For each cell, the regions that overlap it in groups of eight, each with the plane most likely to rule it out there.
#[derive(Debug, Clone, Default)]
pub struct Lists {
    /// The groups of cell k are `starts[k]..starts[k + 1]`.
    starts: Vec<u32>,
    groups: Vec<Listed>,
}

/// Eight regions with one plane each, stored together: ruling out a region by its plane touches no other memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Listed {
    /// The planes that rule out the regions.
    pub planes: CoarseGroup,
    /// Indices of the regions; one that fills the cell is marked with [`FULL`].
    pub regions: [u32; INTEGERS],
}

/// Marks the single entry of a cell that lies inside a region.
pub const FULL: u32 = 1 << 31;

/// Regions sorted into cells between two polls of the watch: a fraction of a millisecond, as a rule.
const REGIONS_TO_A_POLL: usize = 64;

impl Lists {
    /// Sorts regions by the cells they overlap.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn new<'a>(
        cells: &Cells,
        pieces: impl Iterator<Item = (&'a Region, &'a [Reached])> + Clone,
        watch: &Watch,
    ) -> Result<Self, Error> {
        const NONE: u32 = u32::MAX;
        let mut full = vec![NONE; cells.len()];
        let mut count = vec![0; cells.len()];
        for (region, (_, reached)) in pieces.clone().enumerate() {
            if region % REGIONS_TO_A_POLL == 0 {
                watch.check()?;
            }
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
            starts[cell + 1] = starts[cell] + entries.div_ceil(INTEGERS) as u32;
        }
        let groups = starts[cells.len()] as usize;
        let mut groups = vec![Listed { planes: CoarseGroup::ALL_OUTSIDE, regions: [0; INTEGERS] }; groups];
        let mut put = |cell: usize, lane: usize, plane: &CoarsePlane, region: u32| {
            let group = &mut groups[starts[cell] as usize + lane / INTEGERS];
            group.planes.set(lane % INTEGERS, plane, &middle(cell));
            group.regions[lane % INTEGERS] = region;
        };
        let mut filled = vec![0; cells.len()];
        let mut planes = Vec::new();
        for (region, (bounds, reached)) in pieces.enumerate() {
            if region % REGIONS_TO_A_POLL == 0 {
                watch.check()?;
            }
            planes.clear();
            planes.extend(bounds.outer.iter().flatten().map(|half_space| cells.coarse(half_space)));
            for reached in reached {
                let cell = reached.cell as usize;
                if full[cell] == NONE {
                    let witness = planes.get(reached.witness as usize).unwrap_or(&CoarsePlane::ALL_INSIDE);
                    put(cell, filled[cell], witness, region as u32);
                    filled[cell] += 1;
                }
            }
        }
        for cell in (0..cells.len()).filter(|&cell| full[cell] != NONE) {
            put(cell, 0, &CoarsePlane::ALL_INSIDE, full[cell]);
        }
        Ok(Lists { starts, groups })
    }

    /// The regions of a cell.
    #[inline(always)]
    pub fn of(&self, cell: usize) -> &[Listed] {
        &self.groups[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }

    /// Size of the lists in bytes.
    pub fn bytes(&self) -> usize {
        4 * self.starts.capacity() + self.groups.capacity() * size_of::<Listed>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polytope, Rotation};
    use rand::{RngExt, SeedableRng};

    /// The cells of a region, each tested separately.
    fn one_by_one(cells: &Cells, outer: &[HalfSpace], inner: &Inner) -> Vec<(u32, bool)> {
        let half = cells.size * (0.5 + OVERLAP);
        let extent = |h: &HalfSpace| h.normal.abs().dot(&half);
        let mut found = Vec::new();
        for cell in 0..cells.len() {
            let center = cells.min + cells.size.component_mul(&middle(cell));
            let holds = |planes: &[HalfSpace], by: f64| planes.iter().all(|h| h.height(&center) - by <= -extent(h));
            let full = match inner {
                Inner::Unknown => false,
                Inner::Shrunk(by) => holds(outer, *by),
                Inner::Own(planes) => holds(planes, 0.0),
            };
            if !outer.iter().any(|h| h.height(&center) >= extent(h)) {
                found.push((cell as u32, full));
            }
        }
        found
    }

    #[test]
    fn cells_have_distinct_indices_and_middles() {
        let cells = Cells::new(Point::origin(), Point::new(32.0, 32.0, 32.0), MOST_CELLS);
        for k in 0..cells.len() {
            let at = [k % MOST_CELLS, k / MOST_CELLS % MOST_CELLS, k / (MOST_CELLS * MOST_CELLS)];
            let index = cells.index(at);
            assert!(index < cells.len());
            assert_eq!(middle(index), Vector::from(at.map(|k| k as f64 + 0.5)));
        }
    }

    #[test]
    fn bisection_finds_the_same_cells_as_exhaustion() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(9);
        let mut filled = 0;
        for case in 0..300 {
            let mut number = |low: f64, high: f64| rng.random_range(low..high);
            let cells = Cells::new(Point::new(-1.0, -1.0, -1.0), Point::new(1.0, 1.1, 0.9), [4, 8, 16][case % 3]);
            let turn = Rotation::new(Vector::new(number(-2.0, 2.0), number(-2.0, 2.0), number(-2.0, 2.0)));
            let at = Vector::new(number(-1.5, 1.5), number(-1.5, 1.5), number(-1.5, 1.5));
            let body = |grown: f64, sides: [f64; 3]| {
                let body = Polytope::cuboid(sides.map(|side| side + grown)).unwrap();
                body.transformed(&turn, &at).half_spaces()
            };
            let sides = [number(0.1, 3.0), number(0.1, 3.0), number(0.1, 3.0)];
            let inner = [Inner::Unknown, Inner::Shrunk(-1e-3), Inner::Own(body(0.0, sides))][case / 3 % 3].clone();
            let outer = body(0.1, sides);
            let mut found: Vec<(u32, bool)> =
                cells.reached_by(&outer, &inner).iter().map(|reached| (reached.cell, reached.full)).collect();
            found.sort_unstable();
            filled += found.iter().filter(|(_, full)| *full).count();
            assert_eq!(found, one_by_one(&cells, &outer, &inner), "case {case}");
        }
        assert!(filled > 1000, "{filled}");
    }
}
