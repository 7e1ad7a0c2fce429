//! The widest path: its smallest clearance from obstacles is as large as possible, and a proof says so.
//!
//! For a given clearance, a cell decomposition finds a path or proves that there is none. A bisection narrows the largest clearance
//! down to [`WIDEST_GAP`]. A path that is found usually keeps more than it had to, and no path keeps more than its ends, so it
//! begins just below what they keep. The path is then planned and shortened like any other, in the scene with the largest
//! clearance for which one is known.
//!
//! If the path may only be so long, a clearance is kept by a path that planning finds with it and that is not longer. If it finds
//! none, either no path keeps the clearance, or a lower bound shows that all that keep it are longer.

use std::sync::Arc;
use std::time::Duration;

use nalgebra::center;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use web_time::Instant;

use super::{
    FoundBy, Observer, POST_GRACE, PlanOptions, PlanResult, Planned, Post, Processing, Query, Widest, plan, plan_held,
    post_process, verified,
};
use crate::choices;
use crate::collision::path_check::nearest_of;
use crate::collision::{Checker, Conditions, Engine};
use crate::compiled::CompiledScene;
use crate::decomposition::Way;
use crate::error::Error;
use crate::geometry::{Point, Vector, path_length};
use crate::limits::{PROOF_EFFORT_PER_SAMPLE, WIDEST_EFFORT};
use crate::lower_bound::Forbidden;
use crate::model::{Member, Scene};
use crate::path::held;
use crate::planning::{Method, PlannerOptions, Problem, SearchLimits, Status, TranslationSpace, Until};
use crate::postprocess::StringPuller;
use crate::proof::quick_way;
use crate::tolerances::{BEYOND_END, PROOF_MARGIN, WIDEST_GAP};
use crate::watch::{Watch, unless_interrupted, unless_stopped};

/// What a path may have as much of as possible, instead of being short.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Maximise {
    /// The smallest clearance from obstacles.
    Clearance,
}

choices!(Maximise, "maximise", [
    Clearance = "clearance": "The smallest clearance from obstacles, within a proved millimetre",
]);

/// Plans the path with the largest clearance from obstacles, within [`WIDEST_GAP`]; it is shortened as far as it keeps that. If there
/// is no path, or none is found, the answer is that of [`plan`](super::plan).
///
/// A budget or an interruption ends the search with the widest path so far, and with what is proved by then. `observer` is
/// told of every wider path.
///
/// # Errors
/// The errors of [`plan`](super::plan); a platform that may turn, options without proofs, a scene in which nothing keeps the key
/// `clearance` from an obstacle.
///
/// # Example
/// ```
/// use cdpr_core::plan::plan_widest;
/// use cdpr_core::{PlanOptions, testing::hard1};
/// let found = plan_widest(&hard1(), &PlanOptions::default(), &())?.result.widest.unwrap();
/// assert!(found.none_above.unwrap() <= found.clearance + 1e-3);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan_widest<'q>(
    query: impl Into<Query<'q>>,
    options: &PlanOptions,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    let query = query.into();
    let stop = || observer.interrupted();
    let (query, watch) = (query.checked(options)?, options.watch(&stop));
    widest(&query, &Asked { begun: Instant::now(), longest: f64::INFINITY, shortest: None }, options, &watch, observer)
}

/// Plans the widest path, as [`plan_widest`] does, of those that are at most this many times as long as the shortest path: the one that
/// [`plan`](super::plan) finds, which gets half of a budget.
///
/// # Errors
/// The errors of [`plan_widest`]; a ratio below 1.
///
/// # Example
/// ```
/// use cdpr_core::plan::{plan_widest, plan_widest_within};
/// use cdpr_core::{PlanOptions, plan, testing::hard1};
/// let (scene, options) = (hard1(), PlanOptions::default());
/// let shortest = plan(&scene, &options, &())?.result.cost;
/// let found = plan_widest_within(&scene, 1.05, &options, &())?.result;
/// assert!(found.cost <= 1.05 * shortest);
/// let any = plan_widest(&scene, &options, &())?.result;
/// assert!(found.widest.unwrap().clearance > 0.0 && found.widest.unwrap().clearance < any.widest.unwrap().clearance);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan_widest_within<'q>(
    query: impl Into<Query<'q>>,
    ratio: f64,
    options: &PlanOptions,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    let query = query.into();
    if !(ratio >= 1.0 && ratio.is_finite()) {
        return Err(Error::invalid("within", format!("found {ratio}, expected a number of at least 1")));
    }
    let stop = || observer.interrupted();
    let (begun, watch) = (Instant::now(), options.watch(&stop));
    let query = query.checked(options)?;
    let half = PlanOptions { budget: options.budget.map(|budget| budget / 2), ..options.clone() };
    let shortest = plan(query, &half, &stop)?;
    if shortest.result.status != Status::Solved {
        return Ok(shortest);
    }
    let longest = ratio * shortest.result.cost;
    widest(&query, &Asked { begun, longest, shortest: Some(&shortest) }, options, &watch, observer)
}

impl<'q> Query<'q> {
    /// The query, if widest paths can be planned for it.
    fn checked(self, options: &PlanOptions) -> Result<Query<'q>, Error> {
        options.post().processing(options.step, options.repeats)?;
        if self.turns() {
            let problem = "found a platform that may turn on its way, expected one that keeps its orientation: a proof is for one";
            return Err(Error::invalid("maximise", problem));
        }
        if !options.proof {
            return Err(Error::invalid("maximise", "found a search without proofs, which the widest path needs"));
        }
        Ok(self)
    }
}

/// Limits of the search that are not part of the query.
struct Asked<'a> {
    /// When the call began.
    begun: Instant,
    /// Longer paths do not count, m.
    longest: f64,
    /// The shortest path, if there is a limit of the length.
    shortest: Option<&'a Planned>,
}

/// Plans the widest of all paths that are not too long.
fn widest(
    query: &Query,
    asked: &Asked,
    options: &PlanOptions,
    whole: &Watch,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    let choices = if query.compiled.is_some() { vec![query.scene.clone()] } else { query.scene.choices() };
    let mut best: Option<Planned> = None;
    // Of all orientations together: the clearance that no path keeps, and the end that does not keep it.
    let mut above = (0.0, None);
    for (k, scene) in choices.iter().enumerate() {
        let share = whole.left().map(|left| left / (choices.len() - k) as u32);
        let watch = Watch { deadline: None, ..*whole }.with_budget(share);
        let found = widest_at((&Query { scene, ..*query }, asked), options, &watch, observer);
        let Some(found) = unless_interrupted(found)? else {
            above = (f64::INFINITY, None);
            break;
        };
        let own = match (found.result.widest, found.result.status) {
            (Some(widest), _) => (widest.none_above.unwrap_or(f64::INFINITY), widest.narrow_end),
            (None, Status::NoPath | Status::StartInvalid | Status::GoalInvalid) => (0.0, None),
            (None, _) => (f64::INFINITY, None),
        };
        above = if own.0 > above.0 { own } else { above };
        best = Some(match best {
            Some(best) if !wider_than(&found, &best) => best,
            _ => found,
        });
        if (whole.interrupted)() && k + 1 < choices.len() {
            above = (f64::INFINITY, None);
            break;
        }
    }
    let Some(mut best) = best else {
        return Ok(Planned { scene: query.scene.clone(), compiled: None, result: PlanResult::interrupted() });
    };
    if let Some(widest) = &mut best.result.widest {
        (widest.none_above, widest.narrow_end) = (Some(above.0).filter(|above| above.is_finite()), above.1);
    }
    Ok(best)
}

/// Whether a result is better: the wider path or, without paths, the more informative status.
fn wider_than(found: &Planned, other: &Planned) -> bool {
    match (found.result.widest, other.result.widest) {
        (Some(found), Some(other)) => found.clearance > other.clearance,
        (Some(_), None) => true,
        (None, Some(_)) => false,
        _ => found.better_than(other),
    }
}

/// The widest path at the orientation of the scene.
fn widest_at(
    (query, asked): (&Query, &Asked),
    options: &PlanOptions,
    watch: &Watch,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    let Asked { begun, longest, .. } = *asked;
    let shortest = asked.shortest.filter(|found| found.scene.orientation() == query.scene.orientation());
    let compiled = match shortest.and_then(|found| found.compiled.clone()) {
        Some(compiled) => Some(compiled),
        None => query.compile(options, watch)?,
    };
    let Some(compiled) = compiled else { return Ok(Planned::out_of_time(query.scene)) };
    let pairs = pairs_from_obstacles(query.scene, compiled.conditions())?;
    let first = match shortest {
        Some(shortest) => shortest.result.clone(),
        None if longest.is_finite() => short_path(&compiled, query, longest, options, watch)?,
        None => first_path(&compiled, query, options, watch)?,
    };
    if first.status == Status::Solved && first.cost > longest {
        // The shortest path has another orientation.
        return Ok(Planned::by(query.scene, compiled, PlanResult::out_of_time()));
    }
    if first.status != Status::Solved {
        return Ok(Planned::by(query.scene, compiled, first));
    }
    let mut search = Widening {
        scene: query.scene,
        base: &compiled,
        ends: query.ends()?,
        pairs,
        longest,
        options,
        begun,
        observer,
        path: first.waypoints(),
        kept: query.scene.spec().clearance.unwrap_or(0.0),
        kept_by: compiled.clone(),
        above: f64::INFINITY,
        narrow_end: None,
    };
    search.tell();
    let left = watch.left().map(|left| left.mul_f64(SHARE_OF_WIDENING));
    unless_stopped(search.run(&Watch { deadline: left.map(|left| Instant::now() + left), ..*watch }))?;
    let (result, kept) = search.finished(query, &first, watch)?;
    let none_above = Some(search.above).filter(|above| above.is_finite());
    let longest = Some(longest).filter(|longest| longest.is_finite());
    let widest = Some(Widest { clearance: kept, none_above, longest, narrow_end: search.narrow_end });
    Ok(Planned::by(query.scene, compiled, PlanResult { widest, lower_bound: None, ..result }))
}

/// The share of a budget that is for widening; the rest is for shortening.
const SHARE_OF_WIDENING: f64 = 0.7;

/// Indices of the conditions on the pairs to which a larger clearance from obstacles applies.
fn pairs_from_obstacles(scene: &Scene, conditions: &Conditions) -> Result<Vec<usize>, Error> {
    let wider = scene.with_obstacle_clearance(scene.spec().clearance.unwrap_or(0.0) + 1.0)?;
    let applies = |members: &[Member]| match members {
        [a, b] => wider.pairs().clearance(*a, *b) > scene.pairs().clearance(*a, *b),
        _ => false,
    };
    let is_one = |&index: &usize| {
        let condition = &conditions.list[index];
        conditions.required(condition).is_some() && applies(&conditions.members(condition))
    };
    let pairs: Vec<usize> = (0..conditions.list.len()).filter(is_one).collect();
    if pairs.is_empty() {
        let problem = "found no pair with an obstacle that keeps the key clearance of the scene, expected one: without it, all \
                       paths are equally wide";
        return Err(Error::invalid("maximise", problem));
    }
    Ok(pairs)
}

/// A first path, not shortened, or the answer that there is none.
fn first_path(
    compiled: &CompiledScene,
    query: &Query,
    options: &PlanOptions,
    watch: &Watch,
) -> Result<PlanResult, Error> {
    let given = options.planner.limits;
    let max_samples = if given.max_samples == usize::MAX { FIRST_SAMPLES } else { given.max_samples };
    let limits = SearchLimits { max_samples, until: Until::FirstPath, ..given };
    let planner = PlannerOptions { limits, method: Method::TwoTrees };
    let quick = PlanOptions { planner, post: Some(Post::None), ..options.clone() };
    plan_held(compiled, query, &quick, watch, &|_, _, _| ())
}

/// A path at an orientation at which none is known, which may be too long.
fn short_path(
    compiled: &CompiledScene,
    query: &Query,
    longest: f64,
    options: &PlanOptions,
    watch: &Watch,
) -> Result<PlanResult, Error> {
    let mut options = options.clone();
    if watch.deadline.is_some() {
        // The anytime planner would go on until the deadline.
        options.planner.limits.until = Until::Cost(longest);
    }
    plan_held(compiled, query, &options, watch, &|_, _, _| ())
}

/// Samples for a first path of the anytime planner, which has no limit of its own.
const FIRST_SAMPLES: usize = 20_000;

/// How much work the answer for one clearance may take.
struct Effort {
    /// Cells of the decomposition.
    cells: usize,
    /// The planner for a path where the decomposition leaves it undecided.
    method: Method,
    /// Its samples.
    samples: usize,
}

impl Effort {
    /// No search: only the widest path so far is moved aside.
    const NONE: Effort = Effort { cells: 0, method: Method::TwoTrees, samples: 0 };
}

/// A search for the widest path at one orientation.
struct Widening<'a> {
    /// The scene of the query, which may differ from that of `base` in its query.
    scene: &'a Scene,
    base: &'a Arc<CompiledScene>,
    ends: [Point; 2],
    /// Indices of the conditions that count.
    pairs: Vec<usize>,
    /// Longer paths do not count, m.
    longest: f64,
    options: &'a PlanOptions,
    begun: Instant,
    observer: &'a dyn Observer,
    /// The widest path so far, m, not shortened.
    path: Vec<Point>,
    /// The clearance that it keeps, m.
    kept: f64,
    /// A scene with a clearance of at most `kept` in which it is valid.
    kept_by: Arc<CompiledScene>,
    /// No path keeps this, m.
    above: f64,
    /// The end that does not keep it, 0 or 1, if that is the reason.
    narrow_end: Option<usize>,
}

impl Widening<'_> {
    /// Narrows down the largest clearance. When the watch stops it, everything found and proved so far holds.
    fn run(&mut self, watch: &Watch) -> Result<(), Error> {
        self.kept = self.kept.max(self.measured(&self.path, watch)?);
        self.bound_by_ends(watch)?;
        let samples = self.options.planner.limits.max_samples;
        let most = samples.saturating_mul(PROOF_EFFORT_PER_SAMPLE).min(WIDEST_EFFORT);
        // A clearance just below what the ends keep decides many scenes at once.
        let first = Effort { cells: most / 10, method: Method::Anytime { gap: None }, samples: SAMPLES_OF_ANYTIME };
        self.decide(micrometres(self.above - NEARLY * WIDEST_GAP), &first, watch)?;
        let by_cells = |cells, samples| Effort { cells, method: Method::TwoTrees, samples };
        if self.longest.is_finite() {
            return self.bisect(&by_cells(most, SAMPLES), COARSE_STEP, watch); // a proof about lengths has its own effort
        }
        self.bisect(&by_cells(most / 40, SAMPLES), COARSE_STEP, watch)?;
        self.climb(watch)?;
        self.bisect(&by_cells(most / 10, SAMPLES), COARSE_STEP, watch)?;
        self.bisect(&by_cells(most, MOST_SAMPLES), FINE_STEP, watch)
    }

    /// Tries clearances in between, with the same effort each, until those that are left are within a step of what is known or of
    /// others that were left undecided.
    fn bisect(&mut self, effort: &Effort, step: f64, watch: &Watch) -> Result<(), Error> {
        let mut undecided: Option<[f64; 2]> = None;
        for _ in 0..MOST_TRIES {
            let Some(clearance) = self.next(undecided, step) else { break };
            if !self.decide(clearance, effort, watch)? {
                let [low, high] = undecided.unwrap_or([clearance; 2]);
                undecided = Some([low.min(clearance), high.max(clearance)]);
            }
        }
        Ok(())
    }

    /// Moves the widest path aside for larger and larger clearances, as far as that succeeds: quicker by far than cells in the narrow
    /// passages that are left.
    fn climb(&mut self, watch: &Watch) -> Result<(), Error> {
        let mut step = FARTHEST_ASIDE * WIDEST_GAP;
        while step > CLIMB_STEP && self.above - self.kept > WIDEST_GAP - PROOF_MARGIN {
            let clearance = micrometres((self.kept + step).min(self.above - NEARLY * WIDEST_GAP));
            if !self.decide(clearance, &Effort::NONE, watch)? {
                step *= 0.5;
            }
        }
        Ok(())
    }

    /// The clearance to try next, m, at least a step beside those that were left undecided, of which the smallest and the largest are
    /// given; `None` if there is none.
    fn next(&self, undecided: Option<[f64; 2]>, step: f64) -> Option<f64> {
        let within = |low: f64, high: f64| micrometres(low + SPLIT * (high - low));
        let left = self.above - self.kept;
        match undecided.filter(|[low, high]| *low > self.kept && *high < self.above) {
            _ if left <= WIDEST_GAP - PROOF_MARGIN => None,
            None if left < 2.0 * WIDEST_GAP => Some(micrometres(self.kept + NEARLY * WIDEST_GAP)),
            None => Some(within(self.kept, self.above)),
            Some([low, high]) => {
                let (below, beyond) = (low - self.kept, self.above - high);
                let next = if below > beyond { within(self.kept, low) } else { within(high, self.above) };
                (below.max(beyond) > step).then_some(next)
            }
        }
    }

    /// Decides whether a path keeps a clearance, m; false if that takes more effort, or if it is known.
    fn decide(&mut self, clearance: f64, effort: &Effort, watch: &Watch) -> Result<bool, Error> {
        if !(clearance > self.kept && clearance < self.above) {
            return Ok(false);
        }
        let scene = self.scene.with_obstacle_clearance(clearance)?;
        let wider = CompiledScene::new(&scene, self.options.engine, self.options.interference, watch)?;
        match self.way(&wider, clearance - self.kept, effort, watch)? {
            Way::Path(path) => {
                self.kept = clearance.max(self.measured(&path, watch)?);
                (self.path, self.kept_by) = (path, wider.into());
                self.tell();
            }
            Way::None => (self.above, self.narrow_end) = (clearance, None),
            Way::Undecided => return Ok(false),
        }
        Ok(true)
    }

    /// Tells the observer of the widest path so far.
    fn tell(&self) {
        self.observer.improved(self.begun.elapsed().as_secs_f64(), path_length(&self.path), &self.path);
    }

    /// The smallest clearance of a path from obstacles, m.
    fn measured(&self, path: &[Point], watch: &Watch) -> Result<f64, Error> {
        let nearest = nearest_of(self.base.level(), &self.pairs, path, watch)?;
        Ok(nearest.map_or(f64::INFINITY, |nearest| nearest.value))
    }

    /// No path keeps more than its ends. For cables that hang, the measured clearance is only a lower bound, so the answer is that
    /// of an engine.
    fn bound_by_ends(&mut self, watch: &Watch) -> Result<(), Error> {
        let [start, goal] = self.ends;
        let own = [self.measured(&[start, start], watch)?, self.measured(&[goal, goal], watch)?];
        let least = own[0].min(own[1]).max(self.kept);
        let mut clearance = micrometres(least + BEYOND_END).max(least + 0.5 * BEYOND_END);
        while clearance.is_finite() {
            let scene = self.scene.with_obstacle_clearance(clearance)?;
            let engine = CompiledScene::new(&scene, Engine::Gjk, self.options.interference, watch)?;
            let narrow = self.ends.iter().position(|end| !engine.level().state_valid(end));
            if narrow.is_some() {
                (self.above, self.narrow_end) = (clearance, narrow);
                break;
            }
            clearance = micrometres(1.5 * clearance);
        }
        Ok(())
    }

    /// Whether there is a path in a scene with a clearance that is larger by this, m: the widest one so far, moved aside, or what the
    /// decomposition finds; sampling may find what that leaves undecided.
    fn way(&self, wider: &CompiledScene, by: f64, effort: &Effort, watch: &Watch) -> Result<Way, Error> {
        let (engine, [start, goal]) = (wider.level(), self.ends);
        if engine.motion_valid(&start, &goal) {
            return Ok(Way::Path(vec![start, goal]));
        }
        if self.longest.is_finite() {
            return self.way_within(wider, watch);
        }
        if by < FARTHEST_ASIDE * WIDEST_GAP
            && let Some(path) = moved_aside(engine, &self.path, by, watch)?
        {
            return Ok(Way::Path(path));
        }
        if effort.cells == 0 {
            return Ok(Way::Undecided);
        }
        let way = quick_way(engine, [&start, &goal], effort.cells, watch)?;
        if way != Way::Undecided {
            return Ok(way);
        }
        let problem = Problem { space: TranslationSpace::of(engine.conditions()), start, goal };
        let max_samples = effort.samples.min(self.options.planner.limits.max_samples);
        // Paths of any length will do. After `FirstPath`, the anytime planner would go on until a deadline.
        let limits = SearchLimits { until: Until::Cost(f64::MAX), ..SearchLimits::samples(max_samples) };
        let planner = PlannerOptions { limits, method: effort.method.clone() };
        let mut rng = ChaCha8Rng::seed_from_u64(self.options.seed);
        let puller = StringPuller::new(engine);
        let found = planner.search(&problem, engine, &puller, &|_, _, _| (), &mut rng, watch)?;
        Ok(if found.status == Status::Solved { Way::Path(found.waypoints) } else { Way::Undecided })
    }

    /// Whether there is a path that is not too long in a scene with a larger clearance.
    fn way_within(&self, wider: &CompiledScene, watch: &Watch) -> Result<Way, Error> {
        let (engine, [start, goal]) = (wider.level(), self.ends);
        let forbidden = Forbidden::new(engine, [&start, &goal], watch)?;
        if forbidden.quick_bound(watch)? > self.longest {
            return Ok(Way::None);
        }
        let max_samples = SAMPLES.min(self.options.planner.limits.max_samples);
        let limits = SearchLimits { until: Until::Cost(self.longest), ..SearchLimits::samples(max_samples) };
        let planner = PlannerOptions { limits, method: Method::Anytime { gap: None } };
        let options = PlanOptions { planner, post: Some(Post::None), ..self.options.clone() };
        let query = Query::of(wider.scene()).starting_at(start).to(goal);
        let found = plan_held(wider, &query, &options, watch, &|_, _, _| ())?;
        watch.check()?;
        match found.status {
            Status::Solved if found.cost <= self.longest => return Ok(Way::Path(found.waypoints())),
            Status::NoPath => return Ok(Way::None),
            _ => {}
        }
        let enough = self.longest * (1.0 + LONGER);
        let proved = forbidden.prove(enough, LENGTH_EFFORT, &|_, _| false, watch)?.length;
        Ok(if proved > self.longest { Way::None } else { Way::Undecided })
    }

    /// The path, shortened as far as it keeps its clearance, and that clearance, m.
    fn finished(&self, query: &Query, first: &PlanResult, watch: &Watch) -> Result<(PlanResult, f64), Error> {
        let planned = unless_stopped(self.planned(query, watch))?;
        let found = planned.filter(|(found, _)| found.status == Status::Solved && found.cost <= self.longest);
        let (found, by) = match found {
            Some(found) => found,
            None => {
                let raw = PlanResult {
                    found_by: FoundBy::Decision,
                    raw_path: held(self.base.scene(), &self.path),
                    raw_cost: path_length(&self.path),
                    ..first.clone()
                };
                let rest = Watch::NONE.with_budget(Some(REST));
                let found = post_process(&self.kept_by, &raw, &Processing::StringPulling, &rest)?;
                (found, self.kept_by.clone())
            }
        };
        let waypoints = found.waypoints();
        verified(self.base.level(), &waypoints)?;
        let demanded = by.scene().spec().clearance.unwrap_or(0.0);
        let rest = Watch::NONE.with_budget(watch.deadline.map(|_| POST_GRACE));
        let kept = unless_stopped(self.measured(&waypoints, &rest))?.unwrap_or(demanded);
        let mut stats = found.stats;
        stats.planning_seconds = self.begun.elapsed().as_secs_f64() - stats.post_seconds;
        Ok((PlanResult { stats, ..found }, kept))
    }

    /// The path that planning finds in the scene with the largest known clearance, and that scene.
    fn planned(&self, query: &Query, watch: &Watch) -> Result<(PlanResult, Arc<CompiledScene>), Error> {
        watch.check()?;
        let scene = self.scene.with_obstacle_clearance(self.kept)?;
        let wider = CompiledScene::new(&scene, self.options.engine, self.options.interference, watch)?;
        let valid = self.path.windows(2).all(|pair| wider.level().motion_valid(&pair[0], &pair[1]));
        let wider = if valid { wider.into() } else { self.kept_by.clone() }; // they differ by rounding
        let query = Query { scene: wider.scene(), compiled: Some(&wider), known: Some(&self.path), ..*query };
        let found = plan_held(&wider, &query, self.options, watch, &|_, _, _| ())?;
        Ok((found, wider))
    }
}

/// A path near another one, whose waypoints keep less by this, m: they are moved by a few times as much, and where a motion between two
/// of them is not valid, one from the middle is added. `None` if some cannot be moved.
fn moved_aside(engine: &dyn Checker, path: &[Point], by: f64, watch: &Watch) -> Result<Option<Vec<Point>>, Error> {
    let [start, inner @ .., goal] = path else { return Ok(None) };
    let mut moved = vec![*start];
    for (place, is_end) in inner.iter().map(|place| (place, false)).chain([(goal, true)]) {
        watch.check()?;
        let place = if is_end { Some(*goal) } else { valid_beside(engine, place, by) };
        let last = moved[moved.len() - 1];
        let Some(way) = place.and_then(|place| joined(engine, [&last, &place], by, HALVINGS)) else { return Ok(None) };
        moved.extend(way);
    }
    Ok(Some(moved))
}

/// Waypoints after the first of a path between two positions; `None` if none is found.
fn joined(engine: &dyn Checker, [from, to]: [&Point; 2], by: f64, halvings: usize) -> Option<Vec<Point>> {
    if engine.motion_valid(from, to) {
        return Some(vec![*to]);
    }
    if halvings == 0 {
        return None;
    }
    let middle = valid_beside(engine, &center(from, to), by)?;
    let mut way = joined(engine, [from, &middle], by, halvings - 1)?;
    way.extend(joined(engine, [&middle, to], by, halvings - 1)?);
    Some(way)
}

/// A valid position at a few times this distance, m, that has valid ones around it.
fn valid_beside(engine: &dyn Checker, place: &Point, by: f64) -> Option<Point> {
    let around = || {
        let steps = (0..27).map(|k| Vector::new((k % 3) as f64 - 1.0, (k / 3 % 3) as f64 - 1.0, (k / 9) as f64 - 1.0));
        steps.filter(|step| *step != Vector::zeros())
    };
    let roomy = |at: &Point| {
        let is_free = |reach: f64| around().all(|step| engine.state_valid(&(at + step * reach * ROOM_ASIDE)));
        engine.state_valid(at) && is_free(by)
    };
    if engine.state_valid(place) {
        return Some(*place);
    }
    let distances = [1.0, 1.5, 2.0, 3.0, 5.0, 8.0];
    distances.into_iter().find_map(|far| {
        let directions = around().map(|step| step.normalize());
        directions.map(|direction| place + direction * (far * by)).find(&roomy)
    })
}

/// A length, m, in whole micrometres, so that it is short in print.
fn micrometres(length: f64) -> f64 {
    (length * 1e6).round() / 1e6
}

/// Clearances that may end the search are this share of [`WIDEST_GAP`] from a bound of it.
const NEARLY: f64 = 0.95;

/// Where an interval is divided. Not in the middle: there, gaps of round numbers would have no width left.
const SPLIT: f64 = 0.4871;

/// Smaller steps away from clearances that were left undecided are not worth it, m: at first, and with more effort.
const COARSE_STEP: f64 = 0.8 * WIDEST_GAP;
const FINE_STEP: f64 = 0.2 * WIDEST_GAP;

/// Paths are not moved aside for a clearance that is larger by less, m.
const CLIMB_STEP: f64 = 0.1 * WIDEST_GAP;

/// Most clearances that are tried with the same effort.
const MOST_TRIES: usize = 16;

/// Paths are moved aside for clearances that are larger by at most this multiple of [`WIDEST_GAP`].
const FARTHEST_ASIDE: f64 = 5.0;

/// Room that a waypoint has after it was moved, as a share of the smallest distance by which it is moved.
const ROOM_ASIDE: f64 = 0.02;

/// How often a motion is halved between waypoints that were moved.
const HALVINGS: usize = 6;

/// Samples for a path that the decomposition left undecided: at first, and with more effort.
const SAMPLES: usize = 10_000;
const MOST_SAMPLES: usize = 200_000;

/// Samples of the anytime planner, which take longer: half of them come from where paths bend.
const SAMPLES_OF_ANYTIME: usize = 50_000;

/// Time to shorten a path after the search was stopped.
const REST: Duration = Duration::from_millis(15);

/// A bound shows that a path is too long if it is larger than the limit by this share.
const LONGER: f64 = 1e-9;

/// Effort to prove that all paths with a clearance are too long.
const LENGTH_EFFORT: usize = 1_000_000;
