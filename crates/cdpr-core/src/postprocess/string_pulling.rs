//! String pulling: turns any valid path into a locally shortest one, exactly.
//!
//! At fixed orientation the forbidden regions are convex polyhedra in the space of positions. Among polyhedra, a
//! shortest path is straight except for bends at their edges (M. Sharir and A. Schorr, "On shortest paths in polyhedral
//! spaces", SIAM J. Comput. 15, 1986). Two steps alternate until neither shortens the path:
//!
//! - *pull*: a bend and its neighbours span a triangle; the string is pulled tight in its plane ([`pull`]). Its new
//!   bends lie on edges of the polyhedra.
//! - *slide*: all bends slide along their edges to the positions that make the path through these edges shortest, a
//!   convex problem ([`slide`]). If a segment hits something on the way, pulling leads it around the obstruction.
//!
//! A change is made only if the engine finds every new segment valid and the path becomes shorter. So the result is
//! valid and never longer, even if the polyhedra cover too much (sets fattened by a clearance) or too little
//! (wrenches).

pub mod pull;
pub mod slide;

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};

use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::collision::Checker;
use crate::decomposition::{Decomposition, Taste, Way};
use crate::error::Error;
use crate::forbidden::{HPolyhedra, HPolyhedron, Near, Room, in_box};
use crate::geometry::{Point, Vector};
use crate::lower_bound::{Bound, Forbidden};
use crate::planning::PathOptimizer;
use crate::tolerances::{ON_SURFACE, SAME_POINT, TAUT};
use crate::watch::{Watch, in_time};
use pull::Pull;

/// A waypoint; if it bends around a polyhedron, with the direction of the edge along which it can slide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// Position of the waypoint, m.
    pub place: Point,
    /// Unit vector along the edge; `None` for a waypoint that is not on an edge.
    pub edge: Option<Vector>,
    /// The bend's neighbours when pulling last left it unchanged.
    settled: Option<[Point; 2]>,
}

impl Bend {
    /// A waypoint that may lie on an edge.
    pub fn new(place: Point, edge: Option<Vector>) -> Self {
        Bend { place, edge, settled: None }
    }
}

/// The string puller of a scene: everything needed to pull paths in it.
pub struct StringPuller<'a> {
    engine: &'a dyn Checker,
    hulls: OnceLock<HPolyhedra>,
    low: Point,
    high: Point,
    /// Whether the engine ever rejected a change that the polyhedra allow.
    blocked: AtomicBool,
    /// Scratch memory for sampling.
    room: Mutex<Room>,
    ways: Mutex<Option<Ways>>,
    /// A path that was given, until it is asked for.
    known: Mutex<Option<Vec<Point>>>,
}

/// The cell search for paths, from wide detours to short paths through narrow passages.
struct Ways {
    cells: Decomposition,
    /// Number of weightings tried so far.
    tried: usize,
}

/// The order of cell searches: wide detours are found quickly, short paths come close to the shortest.
const SEARCH_ORDER: [Taste; 6] = [
    Taste { level: 4, heuristic_weight: 3.0 },
    Taste { level: 5, heuristic_weight: 2.0 },
    Taste { level: 6, heuristic_weight: 2.0 },
    Taste { level: 7, heuristic_weight: 2.0 },
    Taste { level: 8, heuristic_weight: 2.0 },
    Taste { level: 9, heuristic_weight: 2.0 },
];
/// Maximum number of rounds of pulling and sliding; five to ten are typical.
const ROUNDS: usize = 50;
/// Share of a length that cutting a corner or nudging must gain to be continued.
const WORTHWHILE: f64 = 1e-3;
/// Share of a path's length that a round must gain to be followed by another, when candidate paths are compared.
const ROUGH: f64 = 1e-4;
/// Pulling stops before a slide if the ratio of path length to `worth` exceeds the value for that slide. A slide gains
/// several per cent, the next one less.
const HOPES: [f64; 8] = [1.15, 1.04, 1.02, 1.01, 1.005, 1.002, 1.001, 1.001];
/// Random moves of a bend per size; fewer if the path is limited by constraints that are slow to check.
const NUDGES: usize = 12;
const FEW_NUDGES: usize = 3;
/// Number of sizes of nudges and of corners to cut, each half the previous one.
const SIZES: usize = 6;
/// Halvings of a slide that is not possible in full.
const HALVINGS: usize = 12;

impl<'a> StringPuller<'a> {
    /// A string puller for the polyhedra that an engine avoids.
    pub fn new(engine: &'a dyn Checker) -> Self {
        let (low, high) = engine.conditions().position_box();
        let (hulls, blocked) = (OnceLock::new(), AtomicBool::new(false));
        let (room, ways, known) = (Mutex::default(), Mutex::default(), Mutex::default());
        StringPuller { engine, hulls, low, high, blocked, room, ways, known }
    }

    /// With a valid path that is known, m, which [`PathOptimizer::way`] returns before it searches.
    pub fn knowing(self, path: Option<&[Point]>) -> Self {
        StringPuller { known: Mutex::new(path.map(<[Point]>::to_vec)), ..self }
    }
}

impl PathOptimizer<Point> for StringPuller<'_> {
    fn shortened(&self, path: &[Point], worth: f64, watch: &Watch) -> Result<Vec<Point>, Error> {
        let Some(mut string) = Strand::new(self, path, watch)? else { return Ok(path.to_vec()) };
        string.pull_roughly(worth, watch)?;
        Ok(string.places())
    }

    fn way(&self, start: &Point, goal: &Point, effort: usize, watch: &Watch) -> Result<Option<Vec<Point>>, Error> {
        if let Some(path) = self.known.lock().unwrap_or_else(PoisonError::into_inner).take() {
            return Ok(Some(path));
        }
        let mut ways = self.ways.lock().unwrap_or_else(PoisonError::into_inner);
        if ways.is_none() {
            let Some(pieces) = in_time(self.engine.pieces(watch))? else { return Ok(None) };
            let cells = Decomposition::new(pieces, self.low, self.high);
            *ways = Some(Ways { cells, tried: 0 });
        }
        let Some(Ways { cells, tried }) = ways.as_mut() else { return Ok(None) };
        let Some(taste) = SEARCH_ORDER.get(*tried % SEARCH_ORDER.len()).filter(|_| *tried < 2 * SEARCH_ORDER.len())
        else {
            return Ok(None);
        };
        let backward = *tried >= SEARCH_ORDER.len();
        let ends = if backward { [goal, start] } else { [start, goal] };
        let free = |from: &Point, to: &Point| self.engine.motion_valid(from, to);
        let effort = (effort as f64 * (cells.pieces().len() as f64).sqrt()) as usize; // the cost of a sample, in cells
        let Way::Path(mut path) = cells.way(ends, &free, *taste, effort, watch)? else { return Ok(None) };
        *tried += 1;
        if backward {
            path.reverse();
        }
        Ok(Some(path))
    }

    fn lower_bound(&self, ends: [&Point; 2], enough: f64, effort: usize, watch: &Watch) -> Result<Bound, Error> {
        let straight = || Bound { length: (ends[1] - ends[0]).norm(), way: Vec::new() };
        let Some(forbidden) = in_time(Forbidden::new(self.engine, ends, watch))? else { return Ok(straight()) };
        let found = forbidden.prove(enough, effort, &|from, to| self.engine.motion_valid(from, to), watch)?;
        let quick = if found.length < enough { forbidden.quick_bound(watch)?.min(enough) } else { enough };
        Ok(Bound { length: found.length.max(quick), ..found })
    }

    fn complexity(&self) -> usize {
        self.hulls.get().map_or(0, HPolyhedra::count)
    }

    fn blocked(&self) -> bool {
        self.blocked.load(Ordering::Relaxed)
    }

    fn polished(&self, path: &[Point], watch: &Watch) -> Result<Vec<Point>, Error> {
        let Some(mut string) = Strand::new(self, path, watch)? else { return Ok(path.to_vec()) };
        string.polish(watch)?;
        Ok(string.places())
    }

    /// A point on an edge of a polyhedron, outside all others: shortest paths bend only there.
    fn sample(
        &self,
        promising: &dyn Fn(&Point) -> bool,
        rng: &mut dyn Rng,
        watch: &Watch,
    ) -> Result<Option<Point>, Error> {
        let Some(hulls) = self.hulls(watch)? else { return Ok(None) };
        let mut room = self.room.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(hulls.sample(promising, rng, &mut room))
    }
}

impl StringPuller<'_> {
    /// The slightly enlarged polyhedra; `None` if time runs out before they are ready.
    fn hulls(&self, watch: &Watch) -> Result<Option<&HPolyhedra>, Error> {
        if self.hulls.get().is_none() {
            let Some(pieces) = in_time(self.engine.pieces(watch))? else { return Ok(None) };
            let around = pieces.iter().map(|piece| HPolyhedron::around(piece.outer.clone()));
            let hulls = HPolyhedra::new(around, self.low, self.high);
            let _ = self.hulls.set(hulls); // another thread may have set the same value first
        }
        Ok(self.hulls.get())
    }
}

/// A path that is being pulled.
struct Strand<'a> {
    taut: &'a StringPuller<'a>,
    hulls: &'a HPolyhedra,
    path: Vec<Bend>,
    /// Whether the engine rejected a change that the polyhedra allow.
    refused: bool,
    pull: Pull,
    near: Near,
    chain: Vec<Bend>,
}

impl<'a> Strand<'a> {
    /// `None` if time runs out before the polyhedra are ready.
    fn new(taut: &'a StringPuller<'a>, path: &[Point], watch: &Watch) -> Result<Option<Self>, Error> {
        if path.len() <= 2 {
            return Ok(None); // a straight line, for which nothing need be prepared
        }
        let Some(hulls) = taut.hulls(watch)? else { return Ok(None) };
        let mut path: Vec<Bend> = path.iter().map(|place| Bend::new(*place, None)).collect();
        path.dedup_by(|a, b| a.place == b.place);
        path.extend((path.len() == 1).then(|| path[0])); // a path has two ends, even if they coincide
        let (pull, near, chain) = (Pull::default(), Near::default(), Vec::new());
        Ok(Some(Strand { taut, hulls, path, refused: false, pull, near, chain }))
    }

    fn places(self) -> Vec<Point> {
        self.path.into_iter().map(|bend| bend.place).collect()
    }

    /// How far a bend can slide along its edge in both directions before it meets another polyhedron or leaves the box;
    /// at most `reach`, the distances to its neighbours, since no shorter path over the edge lies beyond.
    fn range(&mut self, bend: &Bend, reach: f64) -> [f64; 2] {
        let Some(along) = &bend.edge else { return [0.0; 2] };
        let [low, high] = in_box(&self.taut.low, &self.taut.high, &bend.place, along);
        let window = [low.max(-reach), high.min(reach)];
        let [mut low, mut high] = window;
        let ends = [bend.place + along * low, bend.place + along * high];
        for hull in self.hulls.near(&ends, &mut self.near) {
            match hull.inside_within(&bend.place, along, window) {
                Some([_, end]) if end <= SAME_POINT => low = low.max(end),
                Some([start, _]) if start >= -SAME_POINT => high = high.min(start),
                _ => {}
            }
        }
        [low.min(0.0), high.max(0.0)]
    }

    fn ranges(&mut self, path: &[Bend]) -> Vec<[f64; 2]> {
        let reach = |k: usize| {
            let beside = [k.saturating_sub(1), (k + 1).min(path.len() - 1)];
            beside.map(|other| (path[other].place - path[k].place).norm()).iter().sum()
        };
        (0..path.len()).map(|k| self.range(&path[k], reach(k))).collect()
    }

    /// The directions of all edges through a point.
    fn edges_at(&mut self, place: &Point) -> Vec<Vector> {
        self.hulls.near(&[*place], &mut self.near).flat_map(|hull| hull.edges_at(place)).collect()
    }

    /// Pulls and slides, then nudges: bends may block each other, or be blocked by a constraint that is not a
    /// polyhedron.
    fn polish(&mut self, watch: &Watch) -> Result<(), Error> {
        self.pull_and_slide(watch)?;
        let mut rng = ChaCha8Rng::seed_from_u64(0); // the result depends only on the path
        while self.nudge(&mut rng, watch)? {
            self.pull_and_slide(watch)?;
        }
        Ok(())
    }

    /// Pulls and slides as long as this gains enough and the path may still become shorter than `worth`.
    fn pull_roughly(&mut self, worth: f64, watch: &Watch) -> Result<(), Error> {
        let mut before = f64::INFINITY;
        for hope in HOPES {
            if self.shortcut(watch)? || self.pull(watch)? || length(&self.path) > hope * worth {
                break;
            }
            self.slide_together(watch)?;
            let now = length(&self.path);
            if !(now < (1.0 - ROUGH) * before) {
                break;
            }
            before = now;
        }
        Ok(())
    }

    fn pull_and_slide(&mut self, watch: &Watch) -> Result<(), Error> {
        let mut length = length(&self.path);
        for _ in 0..ROUNDS {
            let ended = self.shortcut(watch)? || self.pull(watch)? || self.slide(watch)?;
            let now = self::length(&self.path);
            if ended || !(now < length - TAUT) {
                break;
            }
            length = now;
        }
        Ok(())
    }

    fn free(&self, from: &Bend, to: &Bend) -> bool {
        self.taut.engine.motion_valid(&from.place, &to.place)
    }

    fn all_free(&self, path: &[Bend]) -> bool {
        path.windows(2).all(|pair| self.free(&pair[0], &pair[1]))
    }

    /// Connects every waypoint to the last one that it can reach directly; returns whether time ran out.
    fn shortcut(&mut self, watch: &Watch) -> Result<bool, Error> {
        let mut from = 0;
        while from + 2 < self.path.len() {
            let mut to = self.path.len() - 1;
            while to > from + 1 && !self.free(&self.path[from], &self.path[to]) {
                if watch.expired()? {
                    return Ok(true);
                }
                to -= 1;
            }
            self.path.drain(from + 1..to);
            from += 1;
        }
        Ok(false)
    }

    /// Pulls the string over every bend until the path stops becoming shorter; returns whether time ran out.
    fn pull(&mut self, watch: &Watch) -> Result<bool, Error> {
        for _ in 0..ROUNDS {
            let mut pulled = false;
            let mut at = 1;
            while at + 1 < self.path.len() {
                if watch.expired()? {
                    return Ok(true);
                }
                let bends = self.path.len();
                let Some(moved) = self.pull_over(at, watch)? else { return Ok(true) };
                pulled |= moved;
                // Several new bends have triangles of their own, so continue with the first. A single new bend is already tight
                // in its triangle: if pulled again, it would only creep along its edge by rounding errors.
                if !moved || self.path.len() == bends {
                    at += 1;
                }
            }
            if !pulled {
                break;
            }
        }
        Ok(false)
    }

    /// Pulls the string over one bend; returns whether it has become shorter, or `None` if time ran out.
    fn pull_over(&mut self, at: usize, watch: &Watch) -> Result<Option<bool>, Error> {
        let [u, v, w] = [self.path[at - 1], self.path[at], self.path[at + 1]];
        if v.settled == Some([u.place, w.place]) {
            return Ok(Some(false));
        }
        let mut chain = std::mem::take(&mut self.chain);
        if !self.pull.over(self.hulls, [&u.place, &v.place, &w.place], &mut chain, watch)? {
            return Ok(None);
        }
        if let [same] = chain[..]
            && (same.place - v.place).norm() < ON_SURFACE
        {
            self.path[at].edge = same.edge.or(v.edge);
        }
        chain.insert(0, u);
        chain.push(w);
        let shorter = length(&chain) < length(&[u, v, w]) - TAUT;
        let free = shorter && self.all_free(&chain);
        if free {
            self.path.splice(at..=at, chain[1..chain.len() - 1].iter().copied());
        }
        self.chain = chain;
        if shorter && !free {
            self.refused = true;
            self.taut.blocked.store(true, Ordering::Relaxed);
        }
        let pulled = free || (shorter && self.cut_corner(at));
        if !pulled {
            self.path[at].settled = Some([u.place, w.place]);
        }
        Ok(Some(pulled))
    }

    /// If a non-polyhedral constraint blocks pulling: cuts off the largest possible corner, trying halved sizes.
    fn cut_corner(&mut self, at: usize) -> bool {
        let [u, v, w] = [self.path[at - 1].place, self.path[at].place, self.path[at + 1].place];
        let toward = |end: &Point, share: f64| Bend::new(v + (end - v) * share, None);
        let cuts = (1..=SIZES).map(|k| 0.5f64.powi(k as i32)).map(|share| [toward(&u, share), toward(&w, share)]);
        let worth = |[a, b]: &[Bend; 2]| {
            let gain = (a.place - v).norm() + (b.place - v).norm() - (b.place - a.place).norm();
            gain > WORTHWHILE * ((u - v).norm() + (w - v).norm())
        };
        // The rest of the old segments is checked, too: it is part of valid ones, but its new ends are rounded.
        let [first, last] = [&u, &w].map(|end| Bend::new(*end, None));
        let free = |[a, b]: &[Bend; 2]| self.free(a, b) && self.free(&first, a) && self.free(b, &last);
        let found = cuts.take_while(worth).find(free);
        if let Some(cut) = found {
            self.path.splice(at..=at, cut);
        }
        found.is_some()
    }

    /// Moves bends at random, by decreasing distances, if this shortens the path; returns whether it gained enough.
    fn nudge(&mut self, rng: &mut impl Rng, watch: &Watch) -> Result<bool, Error> {
        let before = length(&self.path);
        for halving in 1..=SIZES {
            for at in 1..self.path.len() - 1 {
                if watch.expired()? {
                    return Ok(false);
                }
                for _ in 0..if self.refused { FEW_NUDGES } else { NUDGES } {
                    let [u, v, w] = [self.path[at - 1], self.path[at], self.path[at + 1]];
                    let reach =
                        0.5f64.powi(halving as i32) * (u.place - v.place).norm().min((w.place - v.place).norm());
                    let by = Vector::from_fn(|_, _| rng.random_range(-1.0..=1.0)) * reach;
                    let moved = [u, Bend::new(v.place + by, None), w];
                    if length(&moved) < length(&[u, v, w]) - TAUT && self.all_free(&moved) {
                        self.path[at] = moved[1];
                    }
                }
            }
        }
        let worthwhile = if self.refused { WORTHWHILE } else { 0.01 * WORTHWHILE };
        Ok(length(&self.path) < (1.0 - worthwhile) * before)
    }

    /// Slides the bends along their edges, all at once or, if one of them blocks the others, one by one; returns
    /// whether time ran out.
    fn slide(&mut self, watch: &Watch) -> Result<bool, Error> {
        if self.slide_together(watch)? {
            return Ok(false);
        }
        let mut at = 1;
        while at + 1 < self.path.len() {
            let [u, v, w] = [self.path[at - 1], self.path[at], self.path[at + 1]];
            let held = |bend: Bend| Bend::new(bend.place, None);
            for edge in self.edges_at(&v.place) {
                if watch.expired()? {
                    return Ok(true);
                }
                let alone = [held(u), Bend::new(v.place, Some(edge)), held(w)];
                if let Some(slid) = self.slid(&alone, watch)? {
                    self.path.splice(at..=at, slid[1..slid.len() - 1].iter().copied());
                    break;
                }
            }
            at += 1;
        }
        Ok(false)
    }

    /// Slides all bends at once; returns whether this shortened the path.
    fn slide_together(&mut self, watch: &Watch) -> Result<bool, Error> {
        let path = std::mem::take(&mut self.path);
        let slid = self.slid(&path, watch);
        self.path = path;
        let slid = slid?;
        let shorter = slid.is_some();
        self.path = slid.unwrap_or_else(|| std::mem::take(&mut self.path));
        Ok(shorter)
    }

    /// The path with its bends slid to the best points on their edges, or as far towards them as shortens the path.
    fn slid(&mut self, path: &[Bend], watch: &Watch) -> Result<Option<Vec<Bend>>, Error> {
        if path.iter().all(|bend| bend.edge.is_none()) {
            return Ok(None);
        }
        let ranges = self.ranges(path);
        let slides = slide::best_slides(path, &ranges);
        let most = length(path) - TAUT;
        for halving in 0..HALVINGS {
            let moved = slide::slid(path, &slides, 0.5f64.powi(halving as i32));
            if !(length(&moved) < most) {
                break;
            }
            let led = self.led_around(path, &moved, watch)?.filter(|led| length(led) < most);
            if led.is_some() {
                return Ok(led);
            }
        }
        Ok(None)
    }

    /// The slid path; segments that are not free are led over the old ones and pulled tight.
    fn led_around(&mut self, path: &[Bend], moved: &[Bend], watch: &Watch) -> Result<Option<Vec<Bend>>, Error> {
        let mut led = vec![moved[0]];
        for (old, new) in path.windows(2).zip(moved.windows(2)) {
            if !self.free(&new[0], &new[1]) {
                // The ends stay where they are, to the last bit: the segments beside them start there.
                let apart = |bend: &&Bend| new.iter().all(|end| (end.place - bend.place).norm() >= TAUT);
                let over = old.iter().filter(apart).map(|bend| Bend::new(bend.place, None));
                let way: Vec<Bend> = std::iter::once(new[0]).chain(over).chain([new[1]]).collect();
                if !self.all_free(&way) {
                    return Ok(None);
                }
                let path = std::mem::replace(&mut self.path, way);
                let pulled = self.pull(watch);
                let way = std::mem::replace(&mut self.path, path);
                pulled?;
                led.extend_from_slice(&way[1..way.len() - 1]);
            }
            led.push(new[1]);
        }
        Ok(Some(led))
    }
}

fn length(path: &[Bend]) -> f64 {
    path.windows(2).map(|pair| (pair[1].place - pair[0].place).norm()).sum()
}
