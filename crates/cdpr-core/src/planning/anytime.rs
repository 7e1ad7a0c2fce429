//! The anytime planner: a first path at once, then shorter ones for as long as it may.
//!
//! Two trees grow as in RRT-Connect. Every way on which they meet is handed to a [`Guide`], which knows the geometry and
//! makes a locally shortest path of it; of these the shortest is kept. Once there is a path, or none after a while, half
//! of the samples come from the guide too, from where shortest paths can bend: in narrow passages that is what is left
//! to draw from. Samples through which no shorter path can lead are not looked at (J. D. Gammell, S. S. Srinivasa, T. D.
//! Barfoot, "Informed RRT*", IROS 2014).

use rand::Rng;

use super::bidirectional::{Halves, Parent};
use super::outcome::{Outcome, Status};
use super::search::{Limits, Search, Until, path_length};
use super::space::{Problem, StateSpace};
use super::tree::SearchTree;
use crate::collision::Validity;
use crate::error::{Error, ErrorClass};
use crate::watch::Watch;

/// What a planner can be told by somebody who knows the geometry of the space.
pub trait Guide<State>: Sync {
    /// A path no longer than a valid one, with the same ends, and valid; roughly as short as its kind can be, if that is
    /// shorter than `worth`, m.
    ///
    /// # Errors
    /// [`Error::interrupted`] if the watch says so; a deadline ends it early.
    fn shortened(&self, path: &[State], worth: f64, watch: &Watch) -> Result<Vec<State>, Error>;

    /// The same to the last digit, for paths that are worth it.
    ///
    /// # Errors
    /// As [`Guide::shortened`].
    fn polished(&self, path: &[State], watch: &Watch) -> Result<Vec<State>, Error> {
        self.shortened(path, f64::INFINITY, watch)
    }

    /// A valid path found by other means than sampling, in general another one each time; none if that takes more effort
    /// than so many samples do, and the next call goes on from there, or if it finds no more.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    fn way(&self, _start: &State, _goal: &State, _effort: usize, _watch: &Watch) -> Result<Option<Vec<State>>, Error> {
        Ok(None)
    }

    /// How many things it knows of that paths may bend around.
    fn complexity(&self) -> usize {
        0
    }

    /// Whether it met limits that it does not know, which makes its work long.
    fn hindered(&self) -> bool {
        false
    }

    /// A length that no path between two states falls below, m; the best one known when time is over.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    fn lower_bound(&self, start: &State, goal: &State, watch: &Watch) -> Result<f64, Error>;

    /// A promising state where shortest paths may bend; none if nothing is known of such places, or time is over.
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

/// Called with every better path: seconds since the start, its length in m, the path.
pub type Improved<'a, State> = dyn Fn(f64, f64, &[State]) + 'a;

/// Options of [`anytime`].
#[derive(Debug, Clone, PartialEq)]
pub struct AnytimeOptions {
    /// What ends the search. Content with the first path it goes on until nothing has improved for a while.
    pub limits: Limits,
    /// Share of the best length that a lower bound of all paths may be short of it, for the search to end: 0.01 for "at
    /// most 1 % too long".
    pub gap: Option<f64>,
}

impl Default for AnytimeOptions {
    fn default() -> Self {
        AnytimeOptions { limits: Limits::samples(usize::MAX), gap: None }
    }
}

/// Without other limits: samples without any path after which it gives up.
const HOPELESS: usize = 100_000;
/// Without other limits: effort since the last better path after which it is content, in samples: this for one thing that
/// paths may bend around, for n of them √n times as much; and at least so much.
const EFFORT: f64 = 120.0;
const LEAST_EFFORT: f64 = 500.0;
/// Without other limits: it goes on for this much of the effort that led from the first path to the best one.
const EFFORT_SHARE: f64 = 0.5;
/// Effort of making a way taut, in samples; and where the guide is hindered.
const PULL: usize = 20;
const HINDERED_PULL: usize = 40;
/// A path shorter by this share is a better one, for which the search goes on.
const BETTER: f64 = 1e-3;
/// Samples without a path before the guide is asked for some: to get ready it may need longer than a first path takes.
const UNGUIDED: usize = 500;
/// Samples before the guide is asked for a way, and between two such questions.
const FIRST_WAY: usize = 100;
const NEXT_WAY: usize = 100;
/// Ways in a row that led to no shorter path, after which the guide is not asked for more; one more for each so many things
/// that paths may bend around.
const FRUITLESS_WAYS: usize = 2;
const THINGS_PER_WAY: usize = 100;
/// Ways longer than the best path by more than this factor are not made taut.
const DETOUR: f64 = 1.4;
/// A path is polished at once if it is better than the last polished one by this factor, otherwise in the end.
const MUCH_BETTER: f64 = 0.98;
/// Nodes after which the trees begin anew; the best path stays.
const MOST_NODES: usize = 20_000;

/// Searches ever shorter paths; see the module. On interruption the best path so far is the answer, if there is one.
///
/// It ends, besides by the limits, when the path is as short as the straight line. With a deadline, or asked for a cost or a
/// gap, it goes on until then; otherwise until it has tried long enough without finding anything better.
///
/// # Errors
/// [`Error::interrupted`] if the watch says so before there is a path.
pub fn anytime<S: StateSpace>(
    problem: &Problem<S>,
    validity: &dyn Validity<S::State>,
    guide: &dyn Guide<S::State>,
    options: &AnytimeOptions,
    improved: &Improved<S::State>,
    rng: &mut impl Rng,
    watch: &Watch,
) -> Result<Outcome<S::State>, Error> {
    let lasting = watch.deadline.is_some() || options.limits.until != Until::FirstPath || options.gap.is_some();
    // Who gives a number of samples wants them drawn as long as there is no path.
    let hopeless = if options.limits.max_samples < usize::MAX { usize::MAX } else { HOPELESS };
    let limits = Limits { until: Until::Cost(0.0), ..options.limits.clone() };
    let mut run = Run {
        guide,
        watch,
        improved,
        search: Search::new(problem, validity, &limits, watch),
        halves: Halves::new(problem),
        past: 0,
        next_way: FIRST_WAY,
        last_way: Vec::new(),
        fruitless_ways: 0,
        best: Vec::new(),
        cost: f64::INFINITY,
        polished: f64::INFINITY,
        enough: content_with(problem, options),
        gap: options.gap,
        patience: (!lasting).then_some(Patience { hopeless, effort: 0, first: None, last: 0, cost: f64::INFINITY }),
    };
    match run.improve(rng).and_then(|()| run.polish()) {
        Err(stopped) if stopped.class() == ErrorClass::Interrupted && !run.best.is_empty() => {}
        ended => ended?,
    }
    let status = if run.best.is_empty() { Status::BudgetSpent } else { Status::Solved };
    let tree: SearchTree<S::State> = run.halves.into_search_tree();
    Ok(run.search.ended(status, run.best, tree))
}

/// The length with which the search is content, whatever the lower bound.
fn content_with<S: StateSpace>(Problem { space, start, goal }: &Problem<S>, options: &AnytimeOptions) -> f64 {
    let asked = if let Until::Cost(cost) = options.limits.until { cost } else { 0.0 };
    asked.max(space.distance(start, goal))
}

/// How much was tried, and when it led to something; all in samples.
struct Patience {
    /// Effort without any path after which the search gives up.
    hopeless: usize,
    effort: usize,
    /// Effort until the first path.
    first: Option<usize>,
    /// Effort until the last path that was better.
    last: usize,
    /// Its length, m.
    cost: f64,
}

impl Patience {
    /// Whether to give up, or to be content, where paths may bend around so many things.
    fn lost(&self, complexity: usize) -> bool {
        let Some(first) = self.first else { return self.effort >= self.hopeless };
        let earned = (EFFORT_SHARE * (self.last - first) as f64) as usize;
        let least = (EFFORT * (complexity as f64).sqrt()).max(LEAST_EFFORT) as usize;
        self.effort - self.last > earned.max(least)
    }

    fn take(&mut self, cost: f64) {
        self.first.get_or_insert(self.effort);
        if cost < (1.0 - BETTER) * self.cost {
            (self.last, self.cost) = (self.effort, cost);
        }
    }
}

struct Run<'r, S: StateSpace> {
    guide: &'r dyn Guide<S::State>,
    watch: &'r Watch<'r>,
    improved: &'r Improved<'r, S::State>,
    search: Search<'r, S>,
    halves: Halves<'r, S>,
    /// Nodes of trees that were given up.
    past: usize,
    /// Samples from which on the guide is asked for a way.
    next_way: usize,
    /// The last way from the guide.
    last_way: Vec<S::State>,
    /// Ways in a row that led to no shorter path.
    fruitless_ways: usize,
    best: Vec<S::State>,
    cost: f64,
    /// Length of the best path that was polished, m.
    polished: f64,
    /// A path of this length is short enough, m.
    enough: f64,
    /// The gap to the lower bound that is short enough, until the bound is known.
    gap: Option<f64>,
    patience: Option<Patience>,
}

impl<S: StateSpace> Run<'_, S> {
    fn improve(&mut self, rng: &mut impl Rng) -> Result<(), Error> {
        let Problem { start, goal, .. } = self.search.problem;
        if self.search.collision_free(start, goal)? {
            self.take(vec![*start, *goal]);
        }
        while self.cost > self.enough && !self.patience_lost() && !self.search.over(self.nodes(), self.cost)? {
            self.look_at_the_gap()?;
            self.ask_for_a_way()?;
            let Some(sample) = self.promising_sample(rng)? else { continue };
            let parent = if self.cost.is_finite() { Parent::Cheapest } else { Parent::Nearest };
            if let Some(way) = self.halves.meet(&mut self.search, &sample, parent)? {
                self.consider(way, &sample)?;
            }
            if self.halves.len() > MOST_NODES {
                self.past += self.halves.len();
                self.halves = Halves::new(self.search.problem);
                self.halves.keep(&self.best); // nothing, where there is no path yet
            }
        }
        Ok(())
    }

    /// Once there is a path, asks for the lower bound if a gap to it would be short enough.
    fn look_at_the_gap(&mut self) -> Result<(), Error> {
        let Problem { start, goal, .. } = self.search.problem;
        if self.cost.is_finite()
            && let Some(gap) = self.gap.take()
        {
            self.enough = self.enough.max((1.0 + gap) * self.guide.lower_bound(start, goal, self.watch)?);
        }
        Ok(())
    }

    fn ask_for_a_way(&mut self) -> Result<(), Error> {
        let Problem { start, goal, .. } = self.search.problem;
        let samples = self.search.samples();
        let enough = FRUITLESS_WAYS + self.guide.complexity() / THINGS_PER_WAY;
        if samples < self.next_way || self.fruitless_ways >= enough {
            return Ok(());
        }
        self.next_way = samples + NEXT_WAY;
        let Some(way) = self.guide.way(start, goal, NEXT_WAY, self.watch)? else { return Ok(()) };
        let before = self.cost;
        if way != self.last_way {
            if self.best.is_empty() {
                self.take(way.clone()); // an answer in case that time ends here
            }
            let taut = self.guide.shortened(&way, before, self.watch)?;
            self.take(taut);
            self.last_way = way;
        }
        self.fruitless_ways = if self.cost < (1.0 - BETTER) * before { 0 } else { self.fruitless_ways + 1 };
        self.polish_if_much_better()
    }

    fn nodes(&self) -> usize {
        self.past + self.halves.len()
    }

    fn patience_lost(&mut self) -> bool {
        self.patience.as_mut().is_some_and(|patience| {
            patience.effort += 1;
            patience.lost(self.guide.complexity())
        })
    }

    /// A valid state through which a shorter path might lead.
    fn promising_sample(&mut self, rng: &mut impl Rng) -> Result<Option<S::State>, Error> {
        let Problem { space, start, goal } = self.search.problem;
        let samples = self.search.samples();
        let cost = self.cost;
        let promising = |state: &S::State| space.distance(start, state) + space.distance(state, goal) < cost;
        let sample = match samples % 4 {
            1 if self.cost.is_infinite() => space.sample_around(self.halves.stuck(rng), rng),
            0 | 2 if self.cost.is_finite() || samples >= UNGUIDED => self.guide.sample(&promising, rng, self.watch)?,
            _ => None,
        };
        let sample = sample.or_else(|| match self.cost {
            f64::INFINITY => space.sample(rng),
            cost => space.sample_between(start, goal, cost, rng),
        });
        let Some(sample) = self.search.drawn(sample) else { return Ok(None) };
        Ok((promising(&sample) && self.search.valid(&sample)).then_some(sample))
    }

    /// Pulls a way through a sample taut, unless it is far too long or the sample is not what it bends around.
    fn consider(&mut self, mut way: Vec<S::State>, sample: &S::State) -> Result<(), Error> {
        let space = &self.search.problem.space;
        let at = way.iter().position(|state| state == sample).filter(|at| *at > 0 && at + 1 < way.len());
        if let Some(at) = at.filter(|_| self.cost.is_finite())
            && self.search.collision_free(&way[at - 1], &way[at + 1])?
        {
            way.remove(at);
            if path_length(space, &way) >= self.cost {
                return Ok(());
            }
        }
        if path_length(space, &way) > DETOUR * self.cost {
            return Ok(());
        }
        if let Some(patience) = &mut self.patience {
            patience.effort += if self.guide.hindered() { HINDERED_PULL } else { PULL };
        }
        if self.best.is_empty() {
            self.take(way.clone()); // an answer in case that time ends here
        }
        let taut = self.guide.shortened(&way, self.cost, self.watch)?;
        self.take(taut);
        self.polish_if_much_better()
    }

    fn polish_if_much_better(&mut self) -> Result<(), Error> {
        if self.cost < MUCH_BETTER * self.polished { self.polish() } else { Ok(()) }
    }

    /// Makes the best path as short as the guide can.
    fn polish(&mut self) -> Result<(), Error> {
        if self.cost < self.polished && !self.best.is_empty() {
            let polished = self.guide.polished(&self.best, self.watch)?;
            self.take(polished);
            self.polished = self.cost;
        }
        Ok(())
    }

    /// Keeps a path if it is the shortest so far.
    fn take(&mut self, path: Vec<S::State>) {
        let cost = path_length(&self.search.problem.space, &path);
        if cost < self.cost {
            (self.best, self.cost) = (path, cost);
            self.halves.keep(&self.best);
            if let Some(patience) = &mut self.patience {
                patience.take(cost);
            }
            let seconds = self.search.improved(cost);
            (self.improved)(seconds, cost, &self.best);
        }
    }
}
