//! Options of planning, and what is done to a planner's path.

use std::time::Duration;

use crate::choices;
use crate::collision::{Checker, Engine, Interference};
use crate::error::Error;
use crate::geometry::Point;
use crate::planning::{PathOptimizer, Planner, PlannerOptions, TranslationSpace};
use crate::postprocess::{Order, RewindOptions, StringPuller, rewind};
use crate::watch::{Interrupt, Watch};

/// Post-processing of a planner's path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Post {
    /// Rewind in both orders and keep the shorter result.
    Both,
    /// Rewind backward, then forward.
    Backward,
    /// Rewind forward, then backward.
    Forward,
    /// Rewind backward alone.
    BackwardOnly,
    /// Rewind forward alone.
    ForwardOnly,
    /// String pulling: a locally shortest path.
    StringPulling,
    /// No post-processing.
    None,
}

choices!(Post, "post", [
    Both = "both": "Rewind in both orders and keep the shorter result (the paper)",
    Backward = "backward": "Rewind backward, then forward",
    Forward = "forward": "Rewind forward, then backward",
    BackwardOnly = "backward-only": "Rewind backward alone (the paper, Algorithm 4)",
    ForwardOnly = "forward-only": "Rewind forward alone (the paper, Algorithm 5)",
    StringPulling = "taut": "String pulling: a locally shortest path around the exact forbidden regions",
    None = "none": "Leave the planner's path as it is",
]);

impl Post {
    /// The default post-processing of a planner: rewinding for the paper's planners, as in the paper.
    pub fn of(planner: Planner) -> Self {
        match planner {
            Planner::Anytime => Post::None,
            Planner::TwoTrees | Planner::RrtConnect => Post::StringPulling,
            Planner::ModifiedRrt | Planner::Rrt | Planner::RrtStar => Post::Both,
        }
    }

    /// Whether this post-processing rewinds, and so has a step and repeats.
    pub fn rewinds(self) -> bool {
        !matches!(self, Post::StringPulling | Post::None)
    }

    /// Adds the parameters of rewinding.
    ///
    /// # Errors
    /// The errors of [`RewindOptions::checked`].
    pub fn processing(self, step: f64, repeats: usize) -> Result<Processing, Error> {
        let rewind = |order| RewindOptions { step, order, repeats }.checked().map(Processing::Rewind);
        match self {
            Post::Both => rewind(Order::Both),
            Post::Backward => rewind(Order::Backward),
            Post::Forward => rewind(Order::Forward),
            Post::BackwardOnly => rewind(Order::BackwardOnly),
            Post::ForwardOnly => rewind(Order::ForwardOnly),
            Post::StringPulling => Ok(Processing::StringPulling),
            Post::None => Ok(Processing::None),
        }
    }
}

/// A [`Post`] with its options.
#[derive(Debug, Clone, PartialEq)]
pub enum Processing {
    /// Leave the path as it is.
    None,
    /// Algorithms 4 and 5 of the paper.
    Rewind(RewindOptions),
    /// String pulling; see [`crate::postprocess::string_pulling`].
    StringPulling,
}

impl Processing {
    /// Applies the processing to a valid path.
    pub(super) fn of(&self, engine: &dyn Checker, waypoints: &[Point], watch: &Watch) -> Result<Vec<Point>, Error> {
        match self {
            Processing::None => Ok(waypoints.to_vec()),
            Processing::Rewind(options) => {
                rewind(&TranslationSpace::of(engine.conditions()), engine, waypoints, options, watch)
            }
            Processing::StringPulling => StringPuller::new(engine).polished(waypoints, watch),
        }
    }
}

/// Options of planning; start and goal are in [`Query`](super::Query).
#[derive(Debug, Clone, PartialEq)]
pub struct PlanOptions {
    /// Search method and its options.
    pub planner: PlannerOptions,
    /// The engine that checks motions.
    pub engine: Engine,
    /// Rule for interference between cables.
    pub interference: Interference,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Step of rewinding, m.
    pub step: f64,
    /// Post-processing of the planner's path; `None` means [`Post::of`] the planner.
    pub post: Option<Post>,
    /// Number of times that rewinding runs.
    pub repeats: usize,
    /// Whether to decide, beside the search, if there is a path at all.
    pub proof: bool,
    /// Time limit of the call, including the time to compile the scene; the best path so far is returned.
    pub budget: Option<Duration>,
}

impl Default for PlanOptions {
    fn default() -> Self {
        let RewindOptions { step, repeats, .. } = RewindOptions::default();
        PlanOptions {
            planner: PlannerOptions::default(),
            engine: Engine::default(),
            interference: Interference::default(),
            seed: 0,
            step,
            post: None,
            repeats,
            proof: true,
            budget: None,
        }
    }
}

impl PlanOptions {
    /// The paper's method: Modified RRT and rewinding in both orders.
    pub fn paper() -> Self {
        PlanOptions { planner: PlannerOptions::of(Planner::ModifiedRrt), ..PlanOptions::default() }
    }

    /// The watch for a call that begins now.
    pub fn watch<'a>(&self, interrupted: &'a Interrupt<'a>) -> Watch<'a> {
        Watch::on(interrupted).with_budget(self.budget)
    }

    /// The post-processing of the planner's path: as given, or the default of the planner.
    pub fn post(&self) -> Post {
        self.post.unwrap_or_else(|| Post::of(self.planner.planner()))
    }

    /// Whether the step of rewinding has an effect: on rewinding or, if `extend_step` is not given, as the step of a
    /// planner.
    pub fn uses_step(&self, extend_step_given: bool) -> bool {
        let plain = matches!(self.planner.planner(), Planner::Rrt | Planner::RrtStar);
        self.post().rewinds() || plain && !extend_step_given
    }
}
