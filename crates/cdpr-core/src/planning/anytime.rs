//! The anytime planner: a first path quickly, then shorter ones until a limit is reached or further search no longer
//! pays off.
//!
//! Two trees grow as in the planner `two-trees`. Whenever they meet, a [`PathOptimizer`], which knows the geometry,
//! turns the resulting path into a locally shortest one; the shortest of these is kept. Once there is a path, or after
//! a while without one, half of the samples also come from the optimizer, from places where shortest paths can bend: in
//! narrow passages few other samples are useful. Samples through which no shorter path can lead are skipped (J. D.
//! Gammell, S. S. Srinivasa, T. D. Barfoot, "Informed RRT*", IROS 2014).

use rand::Rng;

use super::bidirectional::{Halves, Parent};
use super::outcome::Outcome;
use super::search::{Search, SearchLimits, Until};
use super::space::{Problem, StateSpace};
use super::tree::SearchTree;
use crate::error::{Error, ErrorClass};
use crate::limits::{BOUND_EFFORT, QUICK_BOUND_EFFORT};
use crate::lower_bound::Bound;
use crate::tolerances::BOUND_GAP;
use crate::watch::Watch;

/// A string puller: what the planner needs from the geometry of the space to shorten paths and to choose samples.
pub trait PathOptimizer<State>: Sync {
    /// Shortens a valid path; the result is valid, has the same ends and is never longer. It is approximately locally
    /// shortest if that may be shorter than `worth`, m.
    ///
    /// # Errors
    /// [`Error::interrupted`] if the watch requests it; a deadline ends it early.
    fn shortened(&self, path: &[State], worth: f64, watch: &Watch) -> Result<Vec<State>, Error>;

    /// Shortens a valid path to full precision, for paths that are worth the effort.
    ///
    /// # Errors
    /// The errors of [`PathOptimizer::shortened`].
    fn polished(&self, path: &[State], watch: &Watch) -> Result<Vec<State>, Error> {
        self.shortened(path, f64::INFINITY, watch)
    }

    /// A valid path found without sampling, usually a different one each time. `None` if this takes more effort than
    /// the given number of samples (the next call continues), or if there are no more paths to find.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    fn way(&self, _start: &State, _goal: &State, _effort: usize, _watch: &Watch) -> Result<Option<Vec<State>>, Error> {
        Ok(None)
    }

    /// Number of bodies around which paths may bend.
    fn complexity(&self) -> usize {
        0
    }

    /// Whether constraints other than polyhedra have blocked the string puller, which makes pulling slow.
    fn blocked(&self) -> bool {
        false
    }

    /// A lower bound of the length of all paths between two states: at least `enough`, m, if that can be proved with about this
    /// effort, in pairs of intervals, and before time runs out. Otherwise a shorter path may be returned as well.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    fn lower_bound(&self, ends: [&State; 2], enough: f64, effort: usize, watch: &Watch) -> Result<Bound<State>, Error>;

    /// A promising state where shortest paths may bend; `None` if no such places are known, or time has run out.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    fn sample(
        &self,
        promising: &dyn Fn(&State) -> bool,
        rng: &mut dyn Rng,
        watch: &Watch,
    ) -> Result<Option<State>, Error>;
}

/// Without other limits: number of samples without any path after which the search gives up.
const HOPELESS: usize = 100_000;
/// Without other limits: effort since the last improvement after which the search ends, in samples: this times √n for n
/// bodies that paths may bend around, but at least `LEAST_EFFORT`.
const EFFORT: f64 = 120.0;
const LEAST_EFFORT: f64 = 500.0;
/// Without other limits: the search continues for at least this share of the effort that led from the first path to the
/// best one.
const EFFORT_SHARE: f64 = 0.5;
/// Effort of string pulling one path, in samples; the second value applies if non-polyhedral constraints block the
/// string puller.
const PULL: usize = 20;
const BLOCKED_PULL: usize = 40;
/// Only a path shorter by this share counts as an improvement that prolongs the search.
const BETTER: f64 = 1e-3;
/// Samples without a path before the optimizer is used: preparing it may take longer than finding a first path.
const UNGUIDED: usize = 500;
/// Samples before the first cell search, and between two cell searches.
const FIRST_WAY: usize = 100;
const NEXT_WAY: usize = 100;
/// The cell search ends after this many paths in a row without an improvement, plus one for every `THINGS_PER_WAY`
/// bodies that paths may bend around.
const FRUITLESS_WAYS: usize = 2;
const THINGS_PER_WAY: usize = 100;
/// Paths longer than the best one by more than this factor are not pulled.
const DETOUR: f64 = 1.4;
/// A path shorter than the last polished one by this factor is polished at once, otherwise at the end.
const MUCH_BETTER: f64 = 0.98;
/// The effort to prove a gap grows by this factor from one attempt to the next, while the number of samples doubles.
const MORE_EFFORT: usize = 3;
/// Number of nodes at which the trees restart; the best path is kept.
const MOST_NODES: usize = 20_000;

/// Searches for ever shorter paths; see the module. If interrupted, it returns the best path so far, if there is one.
///
/// With a `gap`, the search ends when the best path exceeds a lower bound of all paths by at most this share: 0.01 for "at most
/// 1 % too long". Besides the limits, it ends when the path is as short as the straight line. With a deadline or a target cost, it
/// continues until one of these is reached, or the gap. Otherwise it ends when it has found nothing better for a while; with a gap,
/// after the greatest effort to prove it.
///
/// # Errors
/// Errors of a path optimizer.
pub(super) fn anytime<S: StateSpace>(
    mut search: Search<S>,
    optimizer: &dyn PathOptimizer<S::State>,
    gap: Option<f64>,
    rng: &mut impl Rng,
) -> Result<Outcome<S::State>, Error> {
    let (problem, watch, limits) = (search.problem, search.watch, search.limits);
    let lasting = watch.deadline.is_some() || limits.until != Until::FirstPath;
    // A given number of samples is used up as long as there is no path.
    let hopeless = if limits.max_samples < usize::MAX { usize::MAX } else { HOPELESS };
    search.limits.until = Until::Cost(0.0);
    let mut run = Run {
        optimizer,
        watch,
        search,
        halves: Halves::new(problem),
        past: 0,
        next_way: FIRST_WAY,
        last_way: Vec::new(),
        fruitless_ways: 0,
        best: Vec::new(),
        cost: f64::INFINITY,
        polished: f64::INFINITY,
        enough: content_with(problem, &limits),
        gap,
        bound: 0.0,
        bound_for: f64::INFINITY,
        bound_effort: 0,
        next_bound: 0,
        looked_again: false,
        patience: (!lasting).then_some(Patience { hopeless, effort: 0, first: None, last: 0, cost: f64::INFINITY }),
    };
    match run.improve(rng).and_then(|()| run.polish()) {
        Err(stopped) if stopped.class() == ErrorClass::Interrupted => run.search.interrupt(),
        ended => ended?,
    }
    let tree: SearchTree<S::State> = run.halves.into_search_tree();
    let bound = Some(run.bound).filter(|bound| *bound > 0.0);
    Ok(Outcome { lower_bound: bound, ..run.search.ended(run.best, tree) })
}

/// The length at which the search ends, regardless of the lower bound.
fn content_with<S: StateSpace>(Problem { space, start, goal }: &Problem<S>, limits: &SearchLimits) -> f64 {
    let asked = if let Until::Cost(cost) = limits.until { cost } else { 0.0 };
    asked.max(space.distance(start, goal))
}

/// How much effort was spent, and when it led to an improvement; all in samples.
struct Patience {
    /// Effort without any path after which the search gives up.
    hopeless: usize,
    effort: usize,
    /// Effort up to the first path.
    first: Option<usize>,
    /// Effort up to the last improvement.
    last: usize,
    /// Length of the best path, m.
    cost: f64,
}

impl Patience {
    /// Whether to give up, or to accept the path, given the number of bodies that paths may bend around.
    fn lost(&self, complexity: usize) -> bool {
        let Some(first) = self.first else { return self.effort >= self.hopeless };
        let earned = (EFFORT_SHARE * (self.last - first) as f64) as usize;
        let least = (EFFORT * (complexity as f64).sqrt()).max(LEAST_EFFORT) as usize;
        self.effort - self.last > earned.max(least)
    }

    /// Restarts the wait for an improvement, as after a first path.
    fn restart(&mut self) {
        (self.first, self.last) = (Some(self.effort), self.effort);
    }

    fn take(&mut self, cost: f64) {
        self.first.get_or_insert(self.effort);
        if cost < (1.0 - BETTER) * self.cost {
            (self.last, self.cost) = (self.effort, cost);
        }
    }
}

struct Run<'r, S: StateSpace> {
    optimizer: &'r dyn PathOptimizer<S::State>,
    watch: &'r Watch<'r>,
    search: Search<'r, S>,
    halves: Halves<'r, S>,
    /// Nodes of trees that were discarded.
    past: usize,
    /// Number of samples at which the next cell search is due.
    next_way: usize,
    /// The last path from the cell search.
    last_way: Vec<S::State>,
    /// Paths in a row from the cell search that led to no improvement.
    fruitless_ways: usize,
    best: Vec<S::State>,
    cost: f64,
    /// Length of the best polished path, m.
    polished: f64,
    /// A path of this length ends the search, m.
    enough: f64,
    /// The requested gap to the lower bound.
    gap: Option<f64>,
    /// The best lower bound of the length of all paths, m.
    bound: f64,
    /// Length of the best path when the bound was last computed, m.
    bound_for: f64,
    /// The effort allowed for `bound`, in pairs of intervals.
    bound_effort: usize,
    /// Number of samples at which the next bound is due.
    next_bound: usize,
    /// Whether the search has already been restarted to find paths that it missed.
    looked_again: bool,
    patience: Option<Patience>,
}

impl<S: StateSpace> Run<'_, S> {
    fn improve(&mut self, rng: &mut impl Rng) -> Result<(), Error> {
        let Problem { start, goal, .. } = self.search.problem;
        if self.search.collision_free(start, goal) {
            self.take(vec![*start, *goal]);
        }
        while self.cost > self.enough && !self.patience_lost()? && !self.over() {
            self.try_to_prove_gap()?;
            self.try_cell_search()?;
            let Some(sample) = self.promising_sample(rng)? else { continue };
            let parent = if self.cost.is_finite() { Parent::Cheapest } else { Parent::Nearest };
            if let Some(way) = self.halves.meet(&mut self.search, &sample, parent)? {
                self.consider(way, &sample)?;
            }
            if self.halves.len() > MOST_NODES {
                self.past += self.halves.len();
                self.halves = Halves::new(self.search.problem);
                self.halves.keep(&self.best); // empty if there is no path yet
            }
        }
        Ok(())
    }

    /// If a gap was requested, tries at intervals to prove it, with an effort in proportion to that of the search. A
    /// path that is far too long would use up the whole effort, and the time to find a shorter one.
    fn try_to_prove_gap(&mut self) -> Result<(), Error> {
        if let Some(gap) = self.gap
            && self.cost.is_finite()
            && self.search.samples() >= self.next_bound
            && (self.unbounded() || self.bound_effort < BOUND_EFFORT)
        {
            self.next_bound = FIRST_WAY.max(2 * self.search.samples());
            self.prove(gap, self.next_effort())?;
        }
        Ok(())
    }

    /// The effort of the next attempt to prove the gap: more than that of the last one, unless the best path has
    /// improved since.
    fn next_effort(&self) -> usize {
        let more = if self.unbounded() { self.bound_effort } else { MORE_EFFORT * self.bound_effort };
        more.clamp(QUICK_BOUND_EFFORT, BOUND_EFFORT)
    }

    /// Whether the best path is better than when the bound was last computed.
    fn unbounded(&self) -> bool {
        self.cost.is_finite() && self.cost < (1.0 - BETTER) * self.bound_for
    }

    /// Tries to prove that the best path is too long by at most `gap`; otherwise takes a shorter path if the attempt found one.
    fn prove(&mut self, gap: f64, effort: usize) -> Result<(), Error> {
        self.polish()?;
        let Problem { start, goal, .. } = self.search.problem;
        let wanted = self.cost / (1.0 + gap);
        let Bound { length, way } = self.optimizer.lower_bound([start, goal], wanted, effort, self.watch)?;
        (self.bound, self.bound_for, self.bound_effort) = (self.bound.max(length), self.cost, effort);
        // Multiplied by the gap again, the bound may be below the cost by rounding.
        let good = if self.bound >= wanted { self.cost } else { (1.0 + gap) * self.bound };
        self.enough = self.enough.max(good);
        if !way.is_empty() {
            let taut = self.optimizer.shortened(&way, self.cost, self.watch)?;
            self.take(taut);
        }
        Ok(())
    }

    fn try_cell_search(&mut self) -> Result<(), Error> {
        let Problem { start, goal, .. } = self.search.problem;
        let samples = self.search.samples();
        let enough = FRUITLESS_WAYS + self.optimizer.complexity() / THINGS_PER_WAY;
        if samples < self.next_way || self.fruitless_ways >= enough {
            return Ok(());
        }
        self.next_way = samples + NEXT_WAY;
        let Some(way) = self.optimizer.way(start, goal, NEXT_WAY, self.watch)? else { return Ok(()) };
        let before = self.cost;
        if way != self.last_way {
            if self.best.is_empty() {
                self.take(way.clone()); // a result in case time runs out here
            }
            let taut = self.optimizer.shortened(&way, before, self.watch)?;
            self.take(taut);
            self.last_way = way;
        }
        self.fruitless_ways = if self.cost < (1.0 - BETTER) * before { 0 } else { self.fruitless_ways + 1 };
        self.polish_if_much_better()
    }

    /// Whether a limit is reached.
    fn over(&mut self) -> bool {
        let nodes = self.past + self.halves.len();
        self.search.over(nodes, self.cost, || self.best.clone())
    }

    /// Whether to end a search without limits. Before it ends with a path, the path is compared with a lower bound, whose
    /// computation may find a shorter one.
    fn patience_lost(&mut self) -> Result<bool, Error> {
        let Some(patience) = &mut self.patience else { return Ok(false) };
        patience.effort += 1;
        if !patience.lost(self.optimizer.complexity()) {
            return Ok(false);
        }
        if self.unbounded() {
            self.prove(self.gap.unwrap_or(BOUND_GAP), self.next_effort())?;
            if self.unbounded() {
                return Ok(false);
            }
        }
        if self.cost <= self.enough || self.best.is_empty() {
            return Ok(true);
        }
        if self.look_again() {
            return Ok(false);
        }
        while let Some(gap) = self.gap.filter(|_| self.cost > self.enough && self.bound_effort < BOUND_EFFORT) {
            self.prove(gap, self.next_effort())?;
            if self.unbounded() {
                return Ok(false); // a shorter path was found on the way
            }
        }
        Ok(true)
    }

    /// Restarts the search once, with new trees that do not contain the best path, and with chains of cells from the goal: trees
    /// that have grown around one path seldom find another beside it.
    fn look_again(&mut self) -> bool {
        let Some(patience) = self.patience.as_mut().filter(|_| !self.looked_again) else { return false };
        patience.restart();
        self.looked_again = true;
        self.past += self.halves.len();
        self.halves = Halves::new(self.search.problem);
        (self.next_way, self.fruitless_ways) = (self.search.samples(), 0);
        true
    }

    /// A valid state through which a shorter path might lead.
    fn promising_sample(&mut self, rng: &mut impl Rng) -> Result<Option<S::State>, Error> {
        let Problem { space, start, goal } = self.search.problem;
        let samples = self.search.samples();
        let cost = self.cost;
        let promising = |state: &S::State| space.distance(start, state) + space.distance(state, goal) < cost;
        let sample = match samples % 4 {
            1 if self.cost.is_infinite() => space.sample_around(self.halves.stuck(rng), rng),
            0 | 2 if self.cost.is_finite() || samples >= UNGUIDED => {
                self.optimizer.sample(&promising, rng, self.watch)?
            }
            _ => None,
        };
        let sample = sample.or_else(|| match self.cost {
            f64::INFINITY => space.sample(rng),
            cost => space.sample_between(start, goal, cost, rng),
        });
        let Some(sample) = self.search.drawn(sample) else { return Ok(None) };
        Ok((promising(&sample) && self.search.valid(&sample)).then_some(sample))
    }

    /// Pulls the path through a sample, unless it is far too long or does not bend at the sample.
    fn consider(&mut self, mut way: Vec<S::State>, sample: &S::State) -> Result<(), Error> {
        let space = &self.search.problem.space;
        let at = way.iter().position(|state| state == sample).filter(|at| *at > 0 && at + 1 < way.len());
        if let Some(at) = at.filter(|_| self.cost.is_finite())
            && self.search.collision_free(&way[at - 1], &way[at + 1])
        {
            way.remove(at);
            if space.length(&way) >= self.cost {
                return Ok(());
            }
        }
        if space.length(&way) > DETOUR * self.cost {
            return Ok(());
        }
        if let Some(patience) = &mut self.patience {
            patience.effort += if self.optimizer.blocked() { BLOCKED_PULL } else { PULL };
        }
        if self.best.is_empty() {
            self.take(way.clone()); // a result in case time runs out here
        }
        let taut = self.optimizer.shortened(&way, self.cost, self.watch)?;
        self.take(taut);
        self.polish_if_much_better()
    }

    fn polish_if_much_better(&mut self) -> Result<(), Error> {
        if self.cost < MUCH_BETTER * self.polished { self.polish() } else { Ok(()) }
    }

    /// Makes the best path as short as the optimizer can.
    fn polish(&mut self) -> Result<(), Error> {
        if self.cost < self.polished && !self.best.is_empty() {
            let polished = self.optimizer.polished(&self.best, self.watch)?;
            self.take(polished);
            self.polished = self.cost;
        }
        Ok(())
    }

    /// Keeps a path if it is the shortest so far.
    fn take(&mut self, path: Vec<S::State>) {
        let cost = self.search.problem.space.length(&path);
        if cost < self.cost {
            (self.best, self.cost) = (path, cost);
            self.halves.keep(&self.best);
            if let Some(patience) = &mut self.patience {
                patience.take(cost);
            }
            self.search.improved(cost, &self.best);
        }
    }
}
