//! Decides whether there is a path at all: a path, a proof that there is none, or neither.
//!
//! A cell decomposition divides the box of positions until a chain of free cells connects start and goal, or closed cells
//! separate them. A cell is closed if every position in it is within [`PROOF_MARGIN`] of a forbidden one, by one condition:
//! either the cell is inside a convex polyhedron of such positions, or a bound over the cell says so. Closed cells that
//! separate start and goal prove that **no path keeps a gap of more than the margin**. Without the margin little could be
//! proved: touching is allowed, so bodies that abut leave slits without width.
//!
//! # Sources
//! J. Basch, L. J. Guibas, D. Hsu and A. T. Nguyen, "Disconnection proofs for motion planning", ICRA 2001; L. Zhang,
//! Y. J. Kim and D. Manocha, "A simple path non-existence algorithm using C-obstacle query", WAFR 2006.

mod blocking;
mod certificate;
mod closing;
mod tiling;

pub use crate::certificate::Certificate;
pub use certificate::certificate_ends;
pub use closing::{Beyond, Regions, widened_evenly};
pub use tiling::{Content, ProofBox, ProofRegion};

use crate::batch::join;
use crate::collision::{Checker, Piece};
use crate::decomposition::{Decomposition, Kind, Taste, WHOLE, Way};
use crate::error::Error;
use crate::geometry::{Cuboid, Point, Vector};
use crate::limits::{BISECTION_STEPS, BOUND_PROOF_EFFORT, DECIDING, PROOF_EFFORT};
use crate::tolerances::{PROOF_MARGIN, TOUCH_DEPTH};
use crate::watch::Watch;
use blocking::Smaller;
use std::sync::Arc;
use tiling::{around, tiling};

/// The answer to whether there is a path.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// A path, m, not shortened.
    Path(Vec<Point>),
    /// There is no path; the proof.
    NoPath(Box<Proof>),
    /// Undecided: effort or time ran out. Every path passes an opening narrower than this, m; infinite if not known.
    OpeningBelow(f64),
}

/// A proof that no path keeps a gap of more than `margin`.
#[derive(Debug, Clone, PartialEq)]
pub struct Proof {
    /// The proof applies to paths that keep a gap of more than this, m.
    pub margin: f64,
    /// Start of all paths, m.
    pub start: Point,
    /// Goal of all paths, m.
    pub goal: Point,
    /// The box of positions.
    pub bounds: Cuboid,
    /// Convex polyhedra of positions that are forbidden, or within the margin of such.
    pub regions: Vec<ProofRegion>,
    /// Boxes that tile the box of positions. Open ones do not connect start and goal.
    pub boxes: Vec<ProofBox>,
    /// The open boxes that are connected with the start, by index.
    pub around_start: Vec<usize>,
    /// The closed boxes that touch those of `around_start`, by index.
    pub wall: Vec<usize>,
    /// A minimal set of conditions that separate start and goal: indices into the engine's list; wrenches have the
    /// index after the last.
    pub conditions: Vec<usize>,
    /// A minimal set of obstacles that separate start and goal: indices into [`crate::model::Scene::obstacles`].
    pub blocking: Vec<usize>,
    /// For each obstacle of `blocking`, a path past all other obstacles, m, neither shortened nor checked by the
    /// engine, if one is found.
    pub paths_without: Vec<Option<Vec<Point>>>,
    /// The free boxes that are connected with the start.
    pub reachable: Vec<Cuboid>,
    /// Volume of the reachable boxes, m³.
    pub reachable_volume: f64,
    /// Where the platform ends up if it moves straight towards the goal from the point of the reachable boxes that is
    /// nearest to the goal, m.
    pub nearest_to_goal: Point,
}

/// Prefers wide passages: proofs and paths then need the fewest cells.
const WIDE_PASSAGES: Taste = Taste { level: 2, heuristic_weight: 1.0 };

/// Number of halvings of the box down to which the reachable volume is measured, and maximum number of cells for this.
const REACH_LEVEL: u8 = 4;
const REACH_CELLS: usize = 50_000;

/// Decides whether there is a path from start to goal, both valid positions. Visits about `effort` cells, and as many
/// again for each obstacle that separates them, to find the path that its removal would open.
///
/// # Errors
/// [`Error::interrupted`]; [`Error::out_of_time`] if time runs out before the scene's polyhedra are ready.
///
/// # Example
/// ```
/// use cdpr_core::{Interference, collision::CspaceEngine};
/// use cdpr_core::limits::PROOF_EFFORT;
/// use cdpr_core::proof::{Answer, decide};
/// use cdpr_core::testing::{scene, walled};
/// use cdpr_core::Watch;
/// let scene = scene(walled(0.94)); // the platform needs 0.95 m to pass over the wall
/// let engine = CspaceEngine::new(&scene, Interference::Exact)?;
/// let ends = [&scene.start().unwrap(), &scene.goal().unwrap()];
/// let answer = decide(&engine, ends, PROOF_EFFORT, &Watch::NONE)?;
/// let Answer::NoPath(proof) = answer else { panic!("there is no path") };
/// assert_eq!(proof.blocking, [0]); // the first obstacle
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn decide(checker: &dyn Checker, ends: [&Point; 2], effort: usize, watch: &Watch) -> Result<Answer, Error> {
    decide_with(checker, ends, effort, &|| (), watch)
}

/// Like [`decide`]; calls `on_no_path` as soon as it is certain that there is no path, before the reasons are known.
/// The answer cannot change after that; if the caller then stops the search, only the paths past single obstacles are
/// missing.
///
/// # Errors
/// The errors of [`decide`].
pub fn decide_with(
    checker: &dyn Checker,
    ends: [&Point; 2],
    effort: usize,
    on_no_path: &dyn Fn(),
    watch: &Watch,
) -> Result<Answer, Error> {
    if checker.motion_valid(ends[0], ends[1]) {
        return Ok(Answer::Path(ends.map(|end| *end).to_vec())); // it may touch something all along
    }
    let mut search = CellSearch::new(checker, checker.pieces(watch)?, ends, Beyond::ProofMargin);
    Ok(match search.run(effort, &watch.part(DECIDING))? {
        Way::Path(path) => Answer::Path(path),
        Way::Undecided => Answer::OpeningBelow(search.cells.narrowest_opening(ends, watch)?),
        Way::None => {
            on_no_path();
            Answer::NoPath(Box::new(search.proof(effort, watch)))
        }
    })
}

/// Whether it is certain that start and goal, both valid positions, are not joined by any path to which lower bounds of
/// the length apply. Such paths keep only [`BOUND_MARGIN`](crate::tolerances::BOUND_MARGIN), so [`decide`] does not
/// answer this.
///
/// # Errors
/// The errors of [`decide`].
pub fn no_bounded_path(checker: &dyn Checker, ends: [&Point; 2], watch: &Watch) -> Result<bool, Error> {
    if checker.motion_valid(ends[0], ends[1]) {
        return Ok(false);
    }
    let mut search = CellSearch::new(checker, checker.pieces(watch)?, ends, Beyond::BoundMargin);
    Ok(search.run(BOUND_PROOF_EFFORT, watch)? == Way::None)
}

/// A path from start to goal, both valid positions, not shortened; `None` if there is none or it is not found.
///
/// # Errors
/// The errors of [`decide`].
pub fn quick_path(checker: &dyn Checker, ends: [&Point; 2], watch: &Watch) -> Result<Option<Vec<Point>>, Error> {
    Ok(match quick_way(checker, ends, PROOF_EFFORT, watch)? {
        Way::Path(path) => Some(path),
        Way::None | Way::Undecided => None,
    })
}

/// The answer of [`decide`] without a proof, and thus much sooner.
///
/// # Errors
/// The errors of [`decide`].
pub fn quick_way(checker: &dyn Checker, ends: [&Point; 2], effort: usize, watch: &Watch) -> Result<Way, Error> {
    CellSearch::new(checker, checker.pieces(watch)?, ends, Beyond::ProofMargin).run(effort, watch)
}

/// A decomposition for some of the conditions of an engine.
#[derive(Clone)]
struct CellSearch<'a> {
    checker: &'a dyn Checker,
    ends: [&'a Point; 2],
    regions: Regions<'a>,
    cells: Decomposition,
}

impl<'a> CellSearch<'a> {
    /// A search that knows all pieces of an engine, and all its conditions.
    fn new(checker: &'a dyn Checker, pieces: Arc<Vec<Piece>>, ends: [&'a Point; 2], beyond: Beyond) -> Self {
        let (low, high) = checker.conditions().position_box();
        // Positions that leave the workspace by no more than contact are valid, and the box must not be flat.
        let contact = Vector::repeat(0.5 * TOUCH_DEPTH);
        let (low, high) = (low.inf(ends[0]).inf(ends[1]) - contact, high.sup(ends[0]).sup(ends[1]) + contact);
        let regions = Regions::new(checker, Cuboid::new(low, high), &pieces, beyond).between(&pieces, ends);
        let cells = Decomposition::new(pieces, low, high).down_to(beyond.margin());
        CellSearch { checker, ends, regions, cells }
    }

    fn run(&mut self, effort: usize, watch: &Watch) -> Result<Way, Error> {
        self.cells.way(self.ends, &self.regions, WIDE_PASSAGES, effort, watch)
    }

    /// The proof of a search that found no way.
    fn proof(self, effort: usize, watch: &Watch) -> Proof {
        let (smaller, reachable) = join(|| blocking::smallest(&self, effort, watch), || self.clone().reachable());
        let Smaller { search, conditions, blocking, paths_without } = smaller;
        let search = search.as_ref().unwrap_or(&self);
        let (regions, boxes) = tiling(&search.cells, &search.regions, &conditions);
        let (around_start, wall) = around(self.ends[0], &search.cells, &boxes);
        let nearest_to_goal = self.further(nearest(&reachable, self.ends));
        Proof {
            margin: PROOF_MARGIN,
            start: *self.ends[0],
            goal: *self.ends[1],
            bounds: self.cells.span(WHOLE),
            regions,
            boxes,
            around_start,
            wall,
            conditions,
            blocking,
            paths_without,
            reachable_volume: reachable.iter().map(Cuboid::volume).sum(),
            reachable,
            nearest_to_goal,
        }
    }

    /// How far the platform gets from a free position straight towards the goal.
    fn further(&self, from: Point) -> Point {
        let at = |t: f64| from + (self.ends[1] - from) * t;
        let (mut free, mut blocked) = (0.0, 1.0);
        for _ in 0..BISECTION_STEPS {
            let middle = 0.5 * (free + blocked);
            let side = if self.checker.motion_valid(&from, &at(middle)) { &mut free } else { &mut blocked };
            *side = middle;
        }
        at(free)
    }

    /// The free cells that are connected with the start.
    fn reachable(mut self) -> Vec<Cuboid> {
        let start = self.ends[0];
        self.cells.refine(start, REACH_LEVEL, REACH_CELLS, &self.regions);
        let cells = &self.cells;
        let reached = cells.reached_from(cells.cell_at(start));
        let free = |cell: &u32| reached[*cell as usize] && cells.kind(*cell) == Kind::Free;
        cells.leaves().filter(free).map(|cell| cells.span(cell)).collect()
    }
}

/// The position nearest to the goal in these boxes, or the start.
fn nearest(reachable: &[Cuboid], [start, goal]: [&Point; 2]) -> Point {
    let places = reachable.iter().map(|cell| cell.nearest_to(goal)).chain([*start]);
    let distance = |place: &Point| (place - goal).norm();
    places.min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("the start is among them")
}
