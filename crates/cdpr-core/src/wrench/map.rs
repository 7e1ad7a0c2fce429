//! Wrench maps: margins at the nodes of a grid of positions, and the region where they are positive.
//!
//! The paper's wrench-feasible workspace (section 3.3) in numbers: where the cables can hold the platform and exert the
//! required wrenches.

mod identity;

pub use identity::MapIdentity;

use serde::Serialize;

use super::{CapacityMargin, Required, Statics};
use crate::batch::{BatchOptions, Pace, answer_all};
use crate::error::Error;
use crate::geometry::{Aabb, Point, Vector, as_list};
use crate::limits::MAP_NODES;
use crate::model::body;
use crate::simd::WIDTH;
use crate::tolerances::STEP_COUNT;
use crate::wrench::set::{force_limit, moment_limit};

/// Spacing of the nodes, and the margins to compute.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapOptions {
    /// Distance of neighbouring nodes along each axis, m.
    pub step: f64,
    /// Also compute force and moment margins; they are computed by definition, which takes longer.
    pub projected: bool,
}

impl Default for MapOptions {
    fn default() -> Self {
        MapOptions { step: crate::wrench::motion::constraint::GRID, projected: false }
    }
}

/// A regular grid of positions.
///
/// Along each axis the nodes are origin, origin + step, origin + 2 step, and so on. Margins are in C order: z fastest,
/// node (i, j, k) at (i · ny + j) · nz + k, as NumPy expects of an array of shape (nx, ny, nz).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Grid {
    /// The first node, m.
    #[serde(serialize_with = "as_list")]
    pub origin: Point,
    /// Distance of neighbouring nodes along each axis, m.
    pub step: f64,
    /// Nodes along x, y and z.
    pub counts: [usize; 3],
}

impl Grid {
    /// The grid that starts at the box's minimum corner; along each axis its last node is the last one in the box. If
    /// the box is a whole number of steps long (up to a rounding error of 1e-12 steps), the last node is at its end.
    ///
    /// # Errors
    /// A box that is empty or not finite, a step that is not positive, or one so small that there are more than
    /// [`MAP_NODES`] nodes.
    pub fn over(within: &Aabb, step: f64) -> Result<Self, Error> {
        body::positive("step", step)?;
        body::coordinates("min", within.min.coords.as_slice())?;
        body::coordinates("max", within.max.coords.as_slice())?;
        if let Some(axis) = (0..3).find(|&k| within.min[k] > within.max[k]) {
            let (min, max, name) = (within.min[axis], within.max[axis], ["x", "y", "z"][axis]);
            return Err(Error::invalid("max", format!("found {max} along {name}, expected at least min, {min}")));
        }
        let counts = (within.max - within.min).map(|extent| (extent / step * (1.0 + STEP_COUNT)).floor() + 1.0);
        within_limit("step", &format!("{step} m"), counts.product())?;
        Ok(Grid { origin: within.min, step, counts: std::array::from_fn(|axis| counts[axis] as usize) })
    }

    /// Number of nodes of the grid.
    #[expect(clippy::len_without_is_empty, reason = "a grid has at least one node")]
    pub fn len(&self) -> usize {
        self.counts.iter().product()
    }

    /// Index of the margins of node (i, j, k).
    pub fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.counts[1] + j) * self.counts[2] + k
    }

    /// The position of the n-th node, m.
    #[inline]
    pub fn position(&self, n: usize) -> Point {
        let [_, ny, nz] = self.counts;
        self.origin + Vector::new((n / nz / ny) as f64, (n / nz % ny) as f64, (n % nz) as f64) * self.step
    }
}

/// Rejects more nodes than [`MAP_NODES`].
fn within_limit(place: &str, found: &str, nodes: f64) -> Result<(), Error> {
    if nodes <= MAP_NODES {
        return Ok(());
    }
    let problem = format!(
        "found {found}, which makes {nodes:.1e} nodes of 8 bytes for each margin; expected at most {MAP_NODES:e} nodes"
    );
    Err(Error::invalid(place, problem))
}

/// Margins of a robot at the nodes of a grid, at one orientation and under one load.
///
/// Memory: 8 bytes for each node and margin. The margins do not depend on the number of threads.
///
/// # Example
/// ```
/// use cdpr_core::{Point, Required, WrenchMap, geometry::Aabb, testing, wrench::{Loads, MapOptions, Statics}};
/// # use cdpr_core::batch::BatchOptions;
/// let statics = Statics::new(testing::empty().robot(), &Loads::default())?;
/// let within = Aabb { min: Point::new(0.2, 0.2, 0.2), max: Point::new(1.8, 1.8, 1.8) };
/// let options = MapOptions { step: 0.4, ..MapOptions::default() };
/// let batch = BatchOptions::default();
/// let map = WrenchMap::new(&statics, &Required::balls(50.0, 5.0)?, &within, &options, &batch)?;
/// assert_eq!(map.grid().counts, [5, 5, 5]);
/// assert_eq!(map.summary().share, 0.0); // nowhere: this robot holds no moment of 5 N·m
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct WrenchMap {
    grid: Grid,
    identity: MapIdentity,
    margins: Margins,
}

/// The values of a map, one for each node in the order of the [`Grid`]; NaN where a cable has no direction.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Margins {
    /// Capacity margins, N; see [`super::capacity_limit`].
    pub capacity: Vec<f64>,
    /// Force margins, N, if requested; see [`force_limit`].
    pub force: Option<Vec<f64>>,
    /// Moment margins, N·m, if requested; a point mass has none. See [`moment_limit`].
    pub moment: Option<Vec<f64>>,
}

impl WrenchMap {
    /// Computes a map over a box of positions.
    ///
    /// # Errors
    /// The errors of [`Grid::over`] and [`CapacityMargin::new`]; zero threads; [`Error::interrupted`].
    pub fn new(
        statics: &Statics,
        required: &Required,
        within: &Aabb,
        options: &MapOptions,
        batch: &BatchOptions,
    ) -> Result<Self, Error> {
        let capacity = CapacityMargin::new(statics.clone(), required.clone())?;
        let grid = Grid::over(within, options.step)?;
        let mut margins =
            Margins { capacity: at_nodes(&grid, |four| capacity.at_four(four), batch)?, ..Default::default() };
        if options.projected {
            let force = |p: &Point| force_limit(statics, p).map_or(f64::NAN, |limit| limit.margin);
            let moment = |p: &Point| moment_limit(statics, p).map_or(f64::NAN, |limit| limit.margin);
            margins.force = Some(at_nodes(&grid, |four| four.each_ref().map(force), batch)?);
            if !statics.point_mass() {
                margins.moment = Some(at_nodes(&grid, |four| four.each_ref().map(moment), batch)?);
            }
        }
        Ok(WrenchMap { grid, identity: MapIdentity::of(statics, required), margins })
    }

    /// A map from its parts, as read from a file.
    ///
    /// # Errors
    /// A grid that is not finite, or a number of margins that differs from the number of nodes.
    pub fn from_parts(grid: Grid, identity: MapIdentity, margins: Margins) -> Result<Self, Error> {
        body::positive("step", grid.step)?;
        body::coordinates("origin", grid.origin.coords.as_slice())?;
        let nodes = grid.counts.iter().map(|n| *n as f64).product();
        within_limit("margin", &format!("the shape {:?}", grid.counts), nodes)?;
        if grid.counts.contains(&0) {
            return Err(Error::invalid("margin", format!("found the shape {:?}, expected nodes", grid.counts)));
        }
        let named = [("margin", Some(&margins.capacity)), ("force_margin", margins.force.as_ref())];
        for (name, margins) in named.into_iter().chain([("moment_margin", margins.moment.as_ref())]) {
            if let Some(found) = margins.map(Vec::len).filter(|found| *found != grid.len()) {
                return Err(Error::invalid(name, format!("found {found} numbers, expected {}", grid.len())));
            }
        }
        Ok(WrenchMap { grid, identity, margins })
    }

    /// The grid of nodes.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// All inputs that the margins depend on.
    pub fn identity(&self) -> &MapIdentity {
        &self.identity
    }

    /// The margins at all nodes.
    pub fn margins(&self) -> &Margins {
        &self.margins
    }

    /// The region where the required wrenches are available, by the capacity margin.
    pub fn summary(&self) -> MapSummary {
        MapSummary::of(&self.grid, &self.margins.capacity)
    }
}

/// A margin and the position that has it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Place {
    /// The margin at the node, N.
    pub margin: f64,
    /// Position of the node, m.
    #[serde(serialize_with = "as_list")]
    pub position: Point,
}

/// The feasible region of a map in numbers.
///
/// A node is feasible if its margin is positive: a set without interior, such as that of a robot which lacks a degree
/// of freedom, has margins of at most zero. Each feasible node represents the cube of one step around it, so the volume
/// is the count times step³; a region that extends to the side of the box is counted half a step beyond it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MapSummary {
    /// The grid of nodes.
    #[serde(flatten)]
    pub grid: Grid,
    /// Number of nodes of the grid.
    pub nodes: usize,
    /// Nodes with a positive margin.
    pub feasible: usize,
    /// Nodes without a margin, because a cable has no direction there.
    pub undefined: usize,
    /// Feasible nodes over nodes, 0 to 1.
    pub share: f64,
    /// Estimated volume of the feasible region, m³.
    pub volume: f64,
    /// The smallest box around the feasible nodes; `None` if there are none.
    pub extent: Option<Aabb>,
    /// The smallest margin, at the first node that has it; `None` if no node has a margin.
    pub least: Option<Place>,
    /// The largest margin, at the first node that has it; `None` if no node has a margin.
    pub greatest: Option<Place>,
}

impl MapSummary {
    fn of(grid: &Grid, margins: &[f64]) -> Self {
        let mut extent: Option<Aabb> = None;
        let (mut feasible, mut undefined, mut least, mut greatest) = (0, 0, None, None);
        for (n, &margin) in margins.iter().enumerate() {
            if margin.is_nan() {
                undefined += 1;
                continue;
            }
            replace_if(&mut least, (n, margin), |margin, least| margin < least);
            replace_if(&mut greatest, (n, margin), |margin, greatest| margin > greatest);
            if margin > 0.0 {
                feasible += 1;
                let position = grid.position(n);
                let around = extent.get_or_insert(Aabb { min: position, max: position });
                *around = Aabb { min: around.min.inf(&position), max: around.max.sup(&position) };
            }
        }
        let place = |(n, margin): (usize, f64)| Place { margin, position: grid.position(n) };
        MapSummary {
            grid: *grid,
            nodes: margins.len(),
            feasible,
            undefined,
            share: feasible as f64 / margins.len() as f64,
            volume: feasible as f64 * grid.step.powi(3),
            extent,
            least: least.map(place),
            greatest: greatest.map(place),
        }
    }
}

/// Keeps the first of equally extreme margins.
fn replace_if(kept: &mut Option<(usize, f64)>, new: (usize, f64), beyond: impl Fn(f64, f64) -> bool) {
    if kept.is_none_or(|(_, margin)| beyond(new.1, margin)) {
        *kept = Some(new);
    }
}

/// A number for each node; positions are processed four at a time, and the last group is padded by repeating the last
/// node.
fn at_nodes(
    grid: &Grid,
    margins: impl Fn(&[Point; WIDTH]) -> [f64; WIDTH] + Sync,
    batch: &BatchOptions,
) -> Result<Vec<f64>, Error> {
    let last = grid.len() - 1;
    let mut fours = vec![[0.0; WIDTH]; grid.len().div_ceil(WIDTH)];
    let four = |n: usize| margins(&std::array::from_fn(|lane| grid.position((n * WIDTH + lane).min(last))));
    answer_all(&mut fours, four, Pace::WRENCHES, batch)?;
    let mut numbers = fours.into_flattened();
    numbers.truncate(grid.len());
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(max: [f64; 3], step: f64) -> Result<Grid, Error> {
        Grid::over(&Aabb { min: Point::origin(), max: max.into() }, step)
    }

    #[test]
    fn a_whole_number_of_steps_ends_in_a_node() {
        assert_eq!(grid([0.3, 0.31, 0.0], 0.1).unwrap().counts, [4, 4, 1]); // 0.3 / 0.1 is below 3 in floating point
        assert_eq!(grid([0.29999, 2.0, 0.05], 0.1).unwrap().counts, [3, 21, 1]);
    }

    #[test]
    fn nodes_run_along_z_first() {
        let grid = grid([1.0, 2.0, 3.0], 1.0).unwrap();
        assert_eq!((grid.counts, grid.len()), ([2, 3, 4], 24));
        assert_eq!(grid.position(1), Point::new(0.0, 0.0, 1.0));
        for n in 0..grid.len() {
            let at = grid.position(n);
            assert_eq!(grid.index([at.x as usize, at.y as usize, at.z as usize]), n);
        }
    }

    #[test]
    fn what_makes_no_grid_is_named() {
        let message = |max, step| grid(max, step).unwrap_err().to_string();
        assert!(message([1.0; 3], 0.0).starts_with("step: found 0, expected"));
        assert!(message([1.0; 3], f64::NAN).starts_with("step: found NaN"));
        assert!(message([1.0, -1.0, 1.0], 0.1).starts_with("max: found -1 along y, expected at least min, 0"));
        assert!(message([1.0, f64::INFINITY, 1.0], 0.1).starts_with("max: found inf"));
        let many =
            "step: found 0.0001 m, which makes 1.0e12 nodes of 8 bytes for each margin; expected at most 1e8 nodes";
        assert_eq!(message([1.0; 3], 1e-4), many);
        assert!(message([1.0; 3], 1e-300).contains("inf nodes"));
    }

    #[test]
    fn summaries_count_positive_and_skip_undefined_margins() {
        let grid = grid([0.5, 0.0, 1.0], 0.5).unwrap();
        let summary = MapSummary::of(&grid, &[1.0, 3.0, -2.0, f64::NAN, 0.0, 3.0]);
        assert_eq!((summary.nodes, summary.feasible, summary.undefined), (6, 3, 1));
        assert_eq!((summary.share, summary.volume), (0.5, 0.375));
        assert_eq!(summary.extent, Some(Aabb { min: Point::origin(), max: Point::new(0.5, 0.0, 1.0) }));
        assert_eq!(summary.least, Some(Place { margin: -2.0, position: Point::new(0.0, 0.0, 1.0) }));
        assert_eq!(summary.greatest, Some(Place { margin: 3.0, position: Point::new(0.0, 0.0, 0.5) }));
        let nothing = MapSummary::of(&grid, &[f64::NAN; 6]);
        assert_eq!((nothing.extent, nothing.least, nothing.share), (None, None, 0.0));
    }
}
