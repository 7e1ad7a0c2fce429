//! Lower bounds of the length of all paths.
//!
//! Among open convex polyhedra, a shortest path is straight except for bends at free edges: edges of single polyhedra, where
//! no other polyhedron covers them (M. Sharir and A. Schorr, "On shortest paths in polyhedral spaces", SIAM J. Comput. 15,
//! 1986; where two overlap, the edge of their union is concave). So the search for a bound looks at *intervals of free edges*.
//!
//! - Two intervals are linked unless one polyhedron blocks every segment between them, or no shortest path that bends at
//!   one of them can come from the other.
//! - Each interval has a *label*: a linear function, and the distance from the start is at least that everywhere on the
//!   interval. Labels fall until none exceeds what its neighbours allow. The label of the goal is a lower bound.
//! - With labels from both ends, whatever lies only on longer paths than of interest is cut away. What is left is halved,
//!   and so on, until nothing is left. Errors are of second order in the length of the intervals.
//!
//! The exact problem is NP-hard (J. Canny and J. Reif, FOCS 1987); the idea to divide edges into intervals is that of C. H.
//! Papadimitriou, "An algorithm for shortest-path motion in three dimensions", Inf. Process. Lett. 20, 1985.
//!
//! Only what is certainly forbidden counts, so all paths that any engine accepts are at least that long; with clearances,
//! crossing cables and wrenches the bound is looser. Polyhedra are moved outward a little ([`widened_evenly`]): otherwise
//! slits without width between parts that abut would be short cuts. `planes` gives a first bound quickly, by other means.

mod free_edges;
mod interval;
mod network;
mod planes;
mod snapping;

use crate::collision::{Checker, Polyhedron};
use crate::error::Error;
use crate::forbidden::{HPolyhedra, HPolyhedron};
use crate::geometry::{Point, path_length};
use crate::numerics::LEAST_INTERVAL;
use crate::proof::widened_evenly;
use crate::watch::{Watch, in_time};
use free_edges::{Ellipsoid, free_edges};
use interval::Interval;
use network::Network;
use snapping::{Moved, snapped};

/// A lower bound, and where a path close to it might be.
#[derive(Debug, Clone, PartialEq)]
pub struct Bound<State = Point> {
    /// No path that keeps a gap of more than [`crate::numerics::BOUND_MARGIN`] is shorter, m.
    pub length: f64,
    /// A path that is shorter than what was to be proved; empty if none turned up.
    pub way: Vec<State>,
}

/// Whether a motion between two positions is free.
pub type Free<'f> = dyn Fn(&Point, &Point) -> bool + 'f;

/// What is certainly forbidden between a start and a goal.
///
/// # Example
/// ```
/// use cdpr_core::collision::{CspaceEngine, Interference};
/// use cdpr_core::lower_bound::Forbidden;
/// use cdpr_core::numerics::QUICK_BOUND_EFFORT;
/// use cdpr_core::watch::Watch;
/// let scene = cdpr_core::testing::hard1();
/// let engine = CspaceEngine::new(&scene, Interference::Exact)?;
/// let [start, goal] = [scene.start().unwrap(), scene.goal().unwrap()];
/// let forbidden = Forbidden::new(&engine, [&start, &goal], &Watch::NONE)?;
/// let enough = 2.435167 / 1.001; // the best known path may be at most a thousandth too long
/// let bound = forbidden.prove(enough, QUICK_BOUND_EFFORT, &|_, _| false, &Watch::NONE)?;
/// assert_eq!(bound.length, enough); // that is proved
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub struct Forbidden<'c> {
    checker: &'c dyn Checker,
    polyhedra: Vec<Polyhedron>,
    ends: [Point; 2],
    low: Point,
    high: Point,
}

impl<'c> Forbidden<'c> {
    /// The forbidden polyhedra of an engine.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn new(checker: &'c dyn Checker, ends: [&Point; 2], watch: &Watch) -> Result<Self, Error> {
        let (low, high) = checker.conditions().position_box();
        let (low, high) = (low.inf(ends[0]).inf(ends[1]), high.sup(ends[0]).sup(ends[1]));
        Ok(Forbidden { checker, polyhedra: checker.certain_polyhedra(watch)?, ends: ends.map(|end| *end), low, high })
    }

    /// A bound that is found quickly, m; infinite if it is certain that there is no path. The best one so far if time runs
    /// out.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn quick_bound(&self, watch: &Watch) -> Result<f64, Error> {
        let hulls = self.polyhedra.iter().map(|polyhedron| HPolyhedron::exact(polyhedron.half_spaces.clone()));
        let hulls = HPolyhedra::new(hulls, self.low, self.high);
        planes::lower_bound(&hulls, &self.low, &self.high, &self.ends[0], &self.ends[1], watch)
    }

    /// Tries to prove that no path is shorter than `enough`, m, passing about `effort` pairs of intervals. The best bound so
    /// far, at most `enough`, if that or the time does not suffice, or as soon as a shorter path turns up whose motions are all
    /// `free`.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn prove(&self, enough: f64, effort: usize, free: &Free, watch: &Watch) -> Result<Bound, Error> {
        let [start, goal] = &self.ends;
        let mut best = Bound { length: (goal - start).norm().min(enough), way: Vec::new() };
        in_time(self.refine(enough, effort, free, &mut best, watch))?;
        Ok(best)
    }

    fn refine(&self, enough: f64, effort: usize, free: &Free, best: &mut Bound, watch: &Watch) -> Result<(), Error> {
        let [start, goal] = &self.ends;
        if best.length >= enough {
            return Ok(());
        }
        let within = Ellipsoid { start: *start, goal: *goal, length: enough };
        let mut moved = Vec::new();
        for polyhedron in self.polyhedra.iter().filter(|polyhedron| !within.misses(&polyhedron.half_spaces)) {
            watch.check()?;
            let after = widened_evenly(self.checker, polyhedron, [start, goal]);
            moved.push(Moved { before: &polyhedron.half_spaces, after });
        }
        let hulls = HPolyhedra::new(snapped(&moved, self.low, self.high), self.low, self.high);
        let edges = free_edges(&hulls, &within, watch)?;
        if edges.len().saturating_mul(edges.len()) / 2 > effort {
            return Ok(());
        }
        let intervals = edges.iter().enumerate().map(Interval::of);
        let mut network = Network::new(&hulls, [start, goal], intervals, enough, watch)?;
        loop {
            let left = effort.saturating_sub(network.examined());
            let Some(bound) = network.label(left, watch)? else { return Ok(()) };
            best.length = best.length.max(bound.min(enough));
            if best.length >= enough {
                return Ok(());
            }
            let way = network.cheapest_way();
            if way.len() > 1 && path_length(&way) < enough && way.windows(2).all(|pair| free(&pair[0], &pair[1])) {
                best.way = way;
                return Ok(());
            }
            if network.examined() > effort || !network.refine(LEAST_INTERVAL, watch)? {
                return Ok(());
            }
        }
    }
}
