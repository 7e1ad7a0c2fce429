//! Shared by all planners: counted state and motion checks, and the limits that end a search.

use rand::{Rng, RngExt};
use web_time::Instant;

use super::outcome::{Improved, Milestone, Outcome, Status};
use super::space::{Problem, StateSpace};
use super::tree::{SearchTree, Tree};
use crate::collision::Validity;
use crate::watch::Watch;

/// Motion checks, or samples, between two polls of the clock and the interrupt, if they are fast.
const POLL: usize = 64;

/// Limits of a search other than time, which the deadline of its `Watch` limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchLimits {
    /// Maximum number of random samples.
    pub max_samples: usize,
    /// Maximum number of tree nodes.
    pub max_nodes: usize,
    /// The path that ends the search.
    pub until: Until,
}

/// The path that ends a search.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Until {
    /// The first path ends the search.
    #[default]
    FirstPath,
    /// A path of at most this length, m, ends the search; with 0 it continues until samples, nodes or time run out.
    Cost(f64),
}

impl SearchLimits {
    /// Ends at the first path, or after this many samples.
    pub fn samples(max_samples: usize) -> Self {
        SearchLimits { max_samples, max_nodes: usize::MAX, until: Until::FirstPath }
    }
}

/// One run of a planner: problem, validity, and the resources used so far.
pub(super) struct Search<'a, S: StateSpace> {
    pub problem: &'a Problem<S>,
    validity: &'a dyn Validity<S::State>,
    pub limits: SearchLimits,
    improved: &'a Improved<'a, S::State>,
    pub watch: &'a Watch<'a>,
    poll: usize,
    motion_checks: usize,
    samples: usize,
    /// How a search ends that has no path, once it is asked to stop or time runs out.
    stopped: Option<Status>,
    started: Instant,
    history: Vec<Milestone>,
}

impl<'a, S: StateSpace> Search<'a, S> {
    pub fn new(
        problem: &'a Problem<S>,
        validity: &'a dyn Validity<S::State>,
        limits: SearchLimits,
        improved: &'a Improved<'a, S::State>,
        watch: &'a Watch<'a>,
    ) -> Self {
        let (started, history) = (Instant::now(), Vec::new());
        let poll = if validity.may_be_slow() { 1 } else { POLL };
        let (motion_checks, samples, stopped) = (0, 0, None);
        Search { problem, validity, limits, improved, watch, poll, motion_checks, samples, stopped, started, history }
    }

    /// `CollisionFree` of the paper; returns false once the search is asked to stop or time has run out.
    pub fn collision_free(&mut self, from: &S::State, to: &S::State) -> bool {
        self.motion_checks += 1;
        if self.motion_checks.is_multiple_of(self.poll) {
            self.poll_watch();
        }
        self.stopped.is_none() && self.validity.motion_valid(from, to)
    }

    /// Ends the search, since the caller asked it to stop.
    pub fn interrupt(&mut self) {
        self.stopped = Some(Status::Interrupted);
    }

    fn poll_watch(&mut self) {
        self.stopped = self.stopped.or(match self.watch.expired() {
            Err(_) => Some(Status::Interrupted),
            Ok(true) => Some(Status::BudgetSpent),
            Ok(false) => None,
        });
    }

    /// `RandomSample` of the paper: uniform; `None` if the space is empty.
    pub fn random_sample(&mut self, rng: &mut impl Rng) -> Option<S::State> {
        self.samples += 1;
        self.problem.space.sample(rng)
    }

    /// Counts a sample that the caller drew.
    pub fn drawn(&mut self, sample: Option<S::State>) -> Option<S::State> {
        self.samples += 1;
        sample
    }

    /// Samples drawn so far.
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// Records and reports a path of this length, shorter than all before.
    pub fn improved(&mut self, cost: f64, path: &[S::State]) {
        let seconds = self.started.elapsed().as_secs_f64();
        self.history.push(Milestone { seconds, samples: self.samples, cost });
        (self.improved)(seconds, cost, path);
    }

    /// The goal with this probability, otherwise a random sample: the conventional goal bias.
    pub fn biased_sample(&mut self, goal_bias: f64, rng: &mut impl Rng) -> Option<S::State> {
        if goal_bias > 0.0 && rng.random::<f64>() < goal_bias {
            self.samples += 1;
            return Some(self.problem.goal);
        }
        self.random_sample(rng)
    }

    /// Whether any motion could lead to this state at all: a cheap pre-test, not counted as a motion check.
    pub fn valid(&self, state: &S::State) -> bool {
        self.validity.state_valid(state)
    }

    /// Whether the node limit allows more nodes than these.
    pub fn has_room(&self, nodes: usize) -> bool {
        nodes < self.limits.max_nodes
    }

    /// Whether the search is over: the best path so far, of length `best` (infinite if there is none), is good enough, or a
    /// limit is reached. Records and reports the path if it is shorter than all before.
    pub fn over(&mut self, nodes: usize, best: f64, path: impl FnOnce() -> Vec<S::State>) -> bool {
        if best < self.history.last().map_or(f64::INFINITY, |last| last.cost) {
            self.improved(best, &path());
        }
        let content = match self.limits.until {
            Until::FirstPath => best.is_finite(),
            Until::Cost(target) => best <= target,
        };
        let SearchLimits { max_samples, max_nodes, .. } = self.limits;
        if content || self.samples >= max_samples || nodes >= max_nodes || self.stopped.is_some() {
            return true;
        }
        if self.samples.is_multiple_of(self.poll) {
            self.poll_watch();
        }
        self.stopped.is_some()
    }

    /// The outcome, with the goal appended to its parent, if there is one.
    pub fn outcome(self, mut tree: Tree<S>, goal_parent: Option<usize>) -> Outcome<S::State> {
        let Problem { space, goal, .. } = self.problem;
        let waypoints = goal_parent.map_or(Vec::new(), |parent| {
            let last = tree.append(space, parent, *goal);
            tree.path_to(last)
        });
        self.ended(waypoints, tree.into())
    }

    /// The outcome with a given path, empty if there is none.
    pub fn ended(self, waypoints: Vec<S::State>, tree: SearchTree<S::State>) -> Outcome<S::State> {
        let Search { motion_checks, samples, history, stopped, .. } = self;
        let unsolved = stopped.unwrap_or(Status::BudgetSpent);
        let status = if waypoints.is_empty() { unsolved } else { Status::Solved };
        Outcome { status, waypoints, tree, motion_checks, samples, history, lower_bound: None }
    }
}
