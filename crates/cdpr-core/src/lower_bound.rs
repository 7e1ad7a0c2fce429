//! Lower bounds of the length of all paths.
//!
//! Among open convex polyhedra, a shortest path is straight except for bends at free edges: edges of single polyhedra, where
//! no other polyhedron covers them (M. Sharir and A. Schorr, "On shortest paths in polyhedral spaces", SIAM J. Comput. 15,
//! 1986; where two overlap, the edge of their union is concave). So the search for a bound looks at *intervals of free edges*.
//!
//! - Where several polyhedra share a corner, rounding leaves tiny edges that far outnumber the others. All tiny edges near a
//!   corner are replaced by one ball, in which a path may bend in any way.
//! - Two intervals are linked unless one polyhedron blocks every segment between them, or no shortest path that bends at
//!   one of them can come from the other.
//! - Each interval has a *label* for each side of its edge: a linear function on the interval that bounds from below the length
//!   of paths from the start that arrive on that side. A shortest path leaves on the other side. Labels are lowered until none
//!   exceeds what its neighbours allow. The label of the goal is then a lower bound of the length of all paths.
//! - With labels from both ends, parts of intervals that lie only on paths too long to be of interest are removed. The others are
//!   halved, and so on, until nothing is left. Errors are of second order in the length of the intervals.
//!
//! The exact problem is NP-hard (J. Canny and J. Reif, FOCS 1987); the idea to divide edges into intervals is that of C. H.
//! Papadimitriou, "An algorithm for shortest-path motion in three dimensions", Inf. Process. Lett. 20, 1985.
//!
//! If a path that is shorter than wanted remains possible only because it leads through positions where wrenches lack, polyhedra of
//! such positions are added (`lacking`), and the search starts anew.
//!
//! Only certainly forbidden positions are used, so the bound holds for every path that any engine accepts; with clearances and
//! crossing cables it is looser. Planes of polyhedra where wrenches lack stay where they are; other planes are moved outward a little
//! ([`widened_evenly`]), since slits of zero width between abutting parts would otherwise be short cuts. `planes` gives a first bound
//! quickly, by other means.

mod bends;
mod bound_file;
mod free_edges;
mod interval;
mod lacking;
mod network;
mod planes;
mod snapping;
mod weak_boxes;

use std::sync::Arc;
use std::time::Duration;

use crate::certificate::{BoundCertificate, WRENCH};
use crate::collision::{Checker, Conditions, Polyhedron};
use crate::error::Error;
use crate::forbidden::{HPolyhedra, HPolyhedron};
use crate::geometry::{Cuboid, HalfSpace, Point, path_length};
use crate::limits::{BOUND_EFFORT, CERTIFICATE_SECONDS, JUDGED_EFFORT, QUICK_BOUND_EFFORT};
use crate::model::{Member, Scene};
use crate::proof::widened_evenly;
use crate::tolerances::{BEND_STEP, BOUND_MARGIN, LEAST_INTERVAL};
use crate::watch::{Watch, in_time};
use bends::{FreePart, bends};
use bound_file::{BoundRegion, Parts};
use free_edges::{Ellipsoid, FreeEdge, FreeEdges, free_edges};
use interval::Interval;
use lacking::{Lacking, LackingPolyhedron};
use network::Network;
use snapping::{Moved, snapped};
use weak_boxes::Weakness;

/// A lower bound, and where a path close to it might be.
#[derive(Debug, Clone, PartialEq)]
pub struct Bound<State = Point> {
    /// No path that keeps a gap of more than [`crate::tolerances::BOUND_MARGIN`] is shorter than this length, m.
    pub length: f64,
    /// A free path shorter than the length to be proved; empty if none was found.
    pub way: Vec<State>,
}

/// Whether a motion between two positions is free.
pub type Free<'f> = dyn Fn(&Point, &Point) -> bool + 'f;

/// The certainly forbidden positions between a start and a goal.
///
/// # Example
/// ```
/// use cdpr_core::{Interference, collision::CspaceEngine};
/// use cdpr_core::Forbidden;
/// use cdpr_core::limits::QUICK_BOUND_EFFORT;
/// use cdpr_core::Watch;
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
    polyhedra: Arc<Vec<Polyhedron>>,
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
        let polyhedra = checker.certain_polyhedra(watch)?;
        Ok(Forbidden { checker, polyhedra, ends: ends.map(|end| *end), low, high })
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

    /// Tries to prove that no path is shorter than `enough`, m, examining about `effort` pairs of intervals. Returns the best
    /// bound so far, at most `enough`, if effort or time runs out, or as soon as a shorter path is found whose motions are all
    /// `free`. Required wrenches count if the effort is more than [`QUICK_BOUND_EFFORT`].
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn prove(&self, enough: f64, effort: usize, free: &Free, watch: &Watch) -> Result<Bound, Error> {
        let [start, goal] = &self.ends;
        let mut best = Bound { length: (goal - start).norm().min(enough), way: Vec::new() };
        if best.length >= enough {
            return Ok(best);
        }
        let within = Ellipsoid { start: *start, goal: *goal, length: enough };
        let seeks = effort > QUICK_BOUND_EFFORT;
        let lacking = if seeks { Lacking::new(self.checker, &within, [&self.low, &self.high]) } else { None };
        in_time(self.refine((&within, effort), free, lacking.as_ref(), (&mut best, &mut Vec::new()), watch))?;
        Ok(best)
    }

    /// Raises a bound, and adds the polyhedra where wrenches lack that this takes.
    fn refine(
        &self,
        (within, effort): (&Ellipsoid, usize),
        free: &Free,
        lacking: Option<&Lacking>,
        (best, found): (&mut Bound, &mut Vec<LackingPolyhedron>),
        watch: &Watch,
    ) -> Result<(), Error> {
        let mut hulls: Vec<HPolyhedron> =
            self.moved(within, &|_| true, watch)?.into_iter().map(|(_, hull)| hull).collect();
        let mut left = effort;
        loop {
            let indexed = HPolyhedra::new(hulls.iter().cloned(), self.low, self.high);
            let more = self.search((&indexed, within), &mut left, free, lacking, best, watch)?;
            if more.is_empty() {
                return Ok(());
            }
            hulls.extend(more.iter().map(|lacking| lacking.polyhedron.clone()));
            found.extend(more);
        }
    }

    /// Searches among some polyhedra. If that would not suffice because a shorter path only leads through positions where wrenches lack,
    /// returns polyhedra of such positions.
    fn search(
        &self,
        (hulls, within): (&HPolyhedra, &Ellipsoid),
        left: &mut usize,
        free: &Free,
        lacking: Option<&Lacking>,
        best: &mut Bound,
        watch: &Watch,
    ) -> Result<Vec<LackingPolyhedron>, Error> {
        let Ellipsoid { start, goal, length: enough } = within;
        let (effort, known) = (*left, lacking.map_or(0, Lacking::judged));
        let FreeEdges { edges, corners } = free_edges(hulls, within, watch)?;
        let count = edges.len() + corners.len();
        if count.saturating_mul(count) / 2 > effort {
            return Ok(Vec::new());
        }
        let intervals = corners.iter().map(Interval::corner).chain(edges.iter().enumerate().map(Interval::of));
        let mut network = Network::new(hulls, [start, goal], intervals, (*enough, false), watch)?;
        loop {
            let judged = lacking.map_or(0, Lacking::judged) - known;
            let used = network.examined().saturating_add(judged.saturating_mul(JUDGED_EFFORT));
            *left = effort.saturating_sub(used);
            let Some(bound) = network.label(*left, watch)? else { return Ok(Vec::new()) };
            best.length = best.length.max(bound.min(*enough));
            if best.length >= *enough {
                return Ok(Vec::new());
            }
            let way = network.cheapest_way();
            if way.len() > 1 && path_length(&way) < *enough && way.windows(2).all(|pair| free(&pair[0], &pair[1])) {
                best.way = way;
                return Ok(Vec::new());
            }
            if let Some(lacking) = lacking {
                let more = lacking.on(&network.shortest_way(), watch)?;
                if !more.is_empty() {
                    return Ok(more);
                }
            }
            if used > effort || !network.refine(LEAST_INTERVAL, watch)? {
                return Ok(Vec::new());
            }
        }
    }

    /// Polyhedra that contain only positions where wrenches lack, or that are on no path shorter than `enough`, m: one for each segment of
    /// a path that leads through such positions. For tests.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    #[doc(hidden)]
    pub fn lacking_on(&self, way: &[Point], enough: f64, watch: &Watch) -> Result<Vec<HPolyhedron>, Error> {
        let [start, goal] = self.ends;
        let within = Ellipsoid { start, goal, length: enough };
        let lacking = Lacking::new(self.checker, &within, [&self.low, &self.high]);
        let found = lacking.map_or(Ok(Vec::new()), |lacking| lacking.on(way, watch))?;
        Ok(found.into_iter().map(|lacking| lacking.polyhedron).collect())
    }

    /// The polyhedra of some conditions within an ellipsoid, moved outward, and the condition of each.
    fn moved(
        &self,
        within: &Ellipsoid,
        counts: &dyn Fn(usize) -> bool,
        watch: &Watch,
    ) -> Result<Vec<(usize, HPolyhedron)>, Error> {
        let [start, goal] = &self.ends;
        let (mut conditions, mut moved) = (Vec::new(), Vec::new());
        let near = |polyhedron: &&Polyhedron| !within.misses(&polyhedron.half_spaces) && counts(polyhedron.condition);
        for polyhedron in self.polyhedra.iter().filter(near) {
            watch.check()?;
            let after = widened_evenly(self.checker, polyhedron, [start, goal]);
            moved.push(Moved { before: &polyhedron.half_spaces, after });
            conditions.push(polyhedron.condition);
        }
        Ok(conditions.into_iter().zip(snapped(&moved, self.low, self.high)).collect())
    }

    /// A certificate that no path is shorter than `enough`, m, or than a smaller length if about `effort` pairs of
    /// intervals do not suffice for that; `None` if they prove nothing. `scene` must be the scene of the engine.
    ///
    /// All labels of a certificate hold at the same time, so it does not depend on the rounds of the search: see
    /// docs/understand/bounds.md. This takes several times as long as [`prove`](Self::prove).
    ///
    /// # Errors
    /// [`Error::interrupted`]. Running out of time ends the search as running out of effort does.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Interference, collision::CspaceEngine};
    /// use cdpr_core::Forbidden;
    /// use cdpr_core::limits::BOUND_EFFORT;
    /// use cdpr_core::Watch;
    /// let scene = cdpr_core::testing::hard1();
    /// let engine = CspaceEngine::new(&scene, Interference::Exact)?;
    /// let [start, goal] = [scene.start().unwrap(), scene.goal().unwrap()];
    /// let forbidden = Forbidden::new(&engine, [&start, &goal], &Watch::NONE)?;
    /// let certificate = forbidden.certificate(&scene, 2.41, BOUND_EFFORT, &Watch::NONE)?.unwrap();
    /// assert_eq!(certificate.length, 2.41);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn certificate(
        &self,
        scene: &Scene,
        enough: f64,
        effort: usize,
        watch: &Watch,
    ) -> Result<Option<BoundCertificate>, Error> {
        self.certificate_by(scene, (enough, effort), true, watch)
    }

    /// A certificate by collisions, and by wrenches if they count and checkers know them.
    fn certificate_by(
        &self,
        scene: &Scene,
        (enough, effort): (f64, usize),
        wrenches: bool,
        watch: &Watch,
    ) -> Result<Option<BoundCertificate>, Error> {
        let [start, goal] = &self.ends;
        let within = Ellipsoid { start: *start, goal: *goal, length: enough + BOUND_MARGIN };
        let conditions = self.checker.conditions();
        let Conditions { bodies, list, .. } = conditions;
        let has_name = |condition: usize| {
            let details = list[condition].details();
            let is_cable = |member: &Member| matches!(member, Member::Cable(_));
            !details.closes_seam(bodies) && !details.members(bodies).iter().all(is_cable)
        };
        let known = self.known_to_checkers();
        let Some(moved) = in_time(known.moved(&within, &has_name, watch))? else { return Ok(None) };
        let names = |condition| conditions.culprits(&conditions.list[condition]);
        let of_pair = |(condition, hull)| BoundRegion { who: names(condition), hull, boxes: Vec::new() };
        let of_wrench = |LackingPolyhedron { polyhedron, boxes }| BoundRegion {
            who: vec![WRENCH.to_string()],
            hull: polyhedron,
            boxes,
        };
        let lacking = if wrenches { known.lacking(scene, enough, effort, &watch.part(ATTEMPT))? } else { Vec::new() };
        let regions: Vec<BoundRegion> =
            moved.into_iter().map(of_pair).chain(lacking.into_iter().map(of_wrench)).collect();
        let hulls = HPolyhedra::new(regions.iter().map(|region| region.hull.clone()), self.low, self.high);
        let mut listed = hulls.list().iter().peekable();
        let regions =
            regions.into_iter().filter(|region| listed.next_if(|next| **next == region.hull).is_some()).collect();
        let Some((edges, corners)) = in_time(bends(&hulls, [&self.low, &self.high], &within, watch))? else {
            return Ok(None);
        };
        let count = edges.len() + corners.len();
        if hulls.list().len() > MOST_REGIONS || count > MOST_PIECES || count.saturating_mul(count) / 2 > effort {
            return Ok(None);
        }
        let slack = BEND_STEP * (2 * count + 16) as f64;
        let edge_of = |(number, part): (usize, &FreePart)| Interval::of((number, &free_edge(&hulls, part)));
        let intervals = corners.into_iter().map(Interval::point).chain(edges.iter().enumerate().map(edge_of));
        let network = Network::new(&hulls, [start, goal], intervals, (enough + slack, true), watch);
        let Some(mut network) = in_time(network)? else { return Ok(None) };
        let Some(reached) = in_time(certified(&mut network, effort, watch))?.flatten() else { return Ok(None) };
        let bounds = [self.low, self.high];
        let length = (reached.min(enough + slack) - slack).max(0.0).min(enough);
        let parts = Parts { ends: &self.ends, bounds, length, regions, edges };
        Ok(Some(BoundCertificate::of(&parts, network.labelled(), scene)))
    }

    /// A certificate for at most about `enough`, m, that a checker `accepts`: the result of [`certificate`](Self::certificate) for that, or
    /// for what follows without clearances, which checkers do not round as the bound does; else one for a smaller length, then what
    /// collisions prove without wrenches, and finally the one for the straight line, which needs no regions. `None` if the checker
    /// rejects even that. The search ends after [`CERTIFICATE_SECONDS`]; the certificate for the straight line takes no time.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn accepted_certificate(
        &self,
        scene: &Scene,
        enough: f64,
        accepts: &Accepts,
        watch: &Watch,
    ) -> Result<Option<BoundCertificate>, Error> {
        let most = Duration::from_secs(CERTIFICATE_SECONDS);
        let limited = watch.with_budget(Some(watch.left().map_or(most, |left| left.min(most))));
        let straight = self.straight_certificate(scene, enough);
        let known = self.known_to_checkers();
        let has_clearance = self.polyhedra.iter().any(|polyhedron| polyhedron.of_contact.is_some());
        let alone = match !has_clearance && scene.wrench().is_none() {
            true => enough,
            false => known.proved(enough, false, &limited)?,
        };
        let with = match Weakness::new(self.checker, scene) {
            None => alone,
            Some(_) if !has_clearance => enough,
            Some(_) => known.proved(enough, true, &limited.part(PROVING))?,
        };
        // By wrenches only what collisions alone do not prove.
        let shares = |from: f64, to: f64| {
            let worth = move |share: &f64| share * (to - from) > STRAIGHT_SLACK;
            SHARES.into_iter().filter(worth).map(move |share| from + share * (to - from))
        };
        let lengths = shares(alone, with).map(|asked| (asked, true));
        for (asked, wrenches) in lengths.chain(shares(straight.length, alone).map(|asked| (asked, false))) {
            let attempt = limited.part(if wrenches { ATTEMPT } else { 1.0 });
            let found = self.certificate_by(scene, (asked, BOUND_EFFORT), wrenches, &attempt)?;
            let least = if wrenches { alone } else { straight.length };
            if let Some(found) = found.filter(|found| found.length > least && accepts(found, &limited)) {
                return Ok(Some(found));
            }
            if limited.expired()? {
                break;
            }
        }
        let accepted = accepts(&straight, watch);
        watch.expired()?;
        Ok(Some(straight).filter(|_| accepted))
    }

    /// The polyhedra that checkers of certificates know: without clearances.
    fn known_to_checkers(&self) -> Forbidden<'c> {
        let known = |polyhedron: &Polyhedron| Polyhedron {
            condition: polyhedron.condition,
            half_spaces: polyhedron.of_contact.as_ref().unwrap_or(&polyhedron.half_spaces).clone(),
            of_contact: None,
        };
        Forbidden { polyhedra: Arc::new(self.polyhedra.iter().map(known).collect()), ..*self }
    }

    /// The polyhedra that it takes to prove a length, m, where wrenches lack, with the boxes that show it to checkers; not all of them if
    /// effort or time runs out.
    fn lacking(
        &self,
        scene: &Scene,
        enough: f64,
        effort: usize,
        watch: &Watch,
    ) -> Result<Vec<LackingPolyhedron>, Error> {
        let [start, goal] = self.ends;
        let within = Ellipsoid { start, goal, length: enough };
        let (mut bound, mut found) = (Bound { length: 0.0, way: Vec::new() }, Vec::new());
        let Some(weakness) = Weakness::new(self.checker, scene) else { return Ok(found) };
        let certifies = |positions: &Cuboid, part: (&HalfSpace, f64), watch: &Watch| {
            weakness.boxes(positions, part, &within, watch)
        };
        let lacking = Lacking::new(self.checker, &within, [&self.low, &self.high]);
        if let Some(lacking) = lacking.map(|lacking| lacking.certified(&certifies)) {
            let results = (&mut bound, &mut found);
            in_time(self.refine((&within, effort), &|_, _| false, Some(&lacking), results, watch))?;
        }
        Ok(found)
    }

    /// What is proved of a length, m: by collisions alone with little effort, or also by wrenches.
    fn proved(&self, enough: f64, by_wrenches: bool, watch: &Watch) -> Result<f64, Error> {
        let effort = if by_wrenches { BOUND_EFFORT } else { QUICK_BOUND_EFFORT };
        let proved = self.prove(enough, effort, &|_, _| false, watch)?.length;
        Ok(proved.max(self.quick_bound(watch)?.min(enough)))
    }

    /// A certificate that no path is shorter than the straight line.
    fn straight_certificate(&self, scene: &Scene, enough: f64) -> BoundCertificate {
        let [start, goal] = &self.ends;
        let length = ((goal - start).norm() - STRAIGHT_SLACK).min(enough).max(0.0);
        let bounds = [self.low, self.high];
        let parts = Parts { ends: &self.ends, bounds, length, regions: Vec::new(), edges: Vec::new() };
        BoundCertificate::of(&parts, std::iter::empty(), scene)
    }
}

/// Whether a checker accepts a certificate, within a watch.
pub type Accepts<'a> = dyn Fn(&BoundCertificate, &Watch) -> bool + 'a;

/// Certificates are tried for the straight line plus these shares of what the bound adds to it.
const SHARES: [f64; 4] = [1.0, 0.9, 0.5, 0.2];
/// The share of the time left in which collisions and wrenches may prove a length that clearances have proved.
const PROVING: f64 = 1.0 / 12.0;
/// The share of the time left for one attempt with wrenches, and of that for the search for what lacks.
const ATTEMPT: f64 = 0.5;
/// Taken off the length of the straight line, m: more than the reserves of the checkers.
const STRAIGHT_SLACK: f64 = 4.0 * BEND_STEP;
/// Maximum number of regions that checkers accept.
const MOST_REGIONS: usize = 1000;
/// Maximum number of pieces of edges, and of corners, that checkers accept.
const MOST_PIECES: usize = 10_000;

fn free_edge(hulls: &HPolyhedra, part: &FreePart) -> FreeEdge {
    let planes = part.planes.map(|plane| hulls.list()[part.hull].planes()[plane]);
    FreeEdge { from: part.ends[0], to: part.ends[1], planes }
}

/// Networks with more intervals are not divided for a certificate: see [`MOST_PIECES`].
const MOST_DIVIDED: usize = 2_500;

/// Refines a network until its labels from the start prove enough, or effort is used up; returns the label of the goal, m.
fn certified(network: &mut Network, effort: usize, watch: &Watch) -> Result<Option<f64>, Error> {
    loop {
        let Some(reached) = network.certify(usize::MAX, watch)? else { return Ok(None) };
        if network.is_proved()
            || network.examined() > effort
            || network.len() > MOST_DIVIDED
            || !network.refine(LEAST_INTERVAL, watch)?
        {
            return Ok(Some(reached));
        }
    }
}
