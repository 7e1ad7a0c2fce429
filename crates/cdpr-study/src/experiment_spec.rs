//! The experiment file as plain data; [`super::Experiment`] checks it once.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::random_scene::RandomScenesSpec;
use super::statistics::Comparison;
use cdpr_core::file_or_inline;
use cdpr_core::model::{PositionSource, SceneSpec};
use cdpr_core::planning::PlannerSettings;

/// An experiment: scenarios × methods × trials.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "cdpr experiment")]
pub struct ExperimentSpec {
    /// Version of the format, 1.
    pub version: u32,
    /// Name used in messages.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Seed of all random numbers; default 0.
    #[serde(default)]
    pub seed: u64,
    /// Number of trials of each method in each scenario.
    pub trials: usize,
    /// Level of the confidence intervals; default 0.95.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub confidence: Option<f64>,
    /// The scenes in which the methods plan.
    pub scenarios: Vec<ScenarioSpec>,
    /// The methods to compare; each draws its own random numbers.
    pub methods: Vec<MethodSpec>,
    /// Also record when each trial's path improved, in `history.csv`; default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub history: bool,
    /// Comparisons of two groups by t-tests.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub t_tests: Vec<TTestSpec>,
}

/// A scene, or random scenes based on it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScenarioSpec {
    /// Name used in tables.
    pub name: String,
    /// The scene, or the path of its file.
    pub scene: SceneSource,
    /// Random obstacles, drawn anew in each trial and the same for all methods.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub random: Option<RandomScenesSpec>,
    /// Pairs of start and goal, positions or names of stations, instead of those of the scene: a scenario for each, named like
    /// "hall: rack to mill".
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub queries: Vec<[PositionSource; 2]>,
    /// Positions or names of stations that each path passes, in this order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub via: Vec<PositionSource>,
    /// Goals instead of that of the scene, positions or names of stations: each path leads to the one where it is shortest.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub goals: Vec<PositionSource>,
    /// Box in which paths may end, instead of a goal: least and largest coordinates, world, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal_box: Option<[[f64; 3]; 2]>,
}

/// An inline scene, or the path of its file.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum SceneSource {
    /// Path of a scene file (TOML or JSON), relative to the experiment file.
    File(String),
    /// The scene itself.
    Inline(Box<SceneSpec>),
}

file_or_inline!(SceneSource, Box<SceneSpec>, "a scene table or the path of a scene file");

/// A planner with its options and post-processing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MethodSpec {
    /// Name used in tables.
    pub name: String,
    /// modified-rrt (default), rrt, rrt-star, rrt-connect, two-trees or anytime; in Python, `cdpr.run_batch` also takes a function.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub planner: Option<String>,
    /// Options of the planner.
    #[serde(default)]
    pub options: PlannerSettings,
    /// Time limit of a trial, ms; the rows of trials that it ends are not reproducible.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub budget_ms: Option<f64>,
    /// Whether to decide, before the trials in a scene, if it has a path at all: if not, no planner runs; default true.
    /// With a time limit, the decision has as long as a trial.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub proof: Option<bool>,
    /// Step of rewinding, and of rrt and rrt-star, m; default 0.1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// both, backward, forward, backward-only, forward-only, taut or none; the default depends on the planner and is both for the paper's planners. Where
    /// the platform may turn, all but none shorten positions and orientations together, and the default does so, too. In a box of goals, all
    /// but none also move the end of the path.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub post: Option<String>,
    /// Number of times that rewinding runs; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeats: Option<usize>,
    /// cspace (default) or gjk.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub engine: Option<String>,
    /// exact (default) or swept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interference: Option<String>,
    /// Rewind the raw path of each trial in several ways; each combination becomes a method of its own. Not for scenes whose platform may turn,
    /// nor for scenarios with via points, goals or a box of goals.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sweep: Option<SweepSpec>,
}

/// Ways of rewinding one raw path: all combinations of the listed values.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweepSpec {
    /// Steps, m.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub step: Vec<f64>,
    /// Orders: both, backward, forward, backward-only, forward-only.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub post: Vec<String>,
    /// Numbers of repeats.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub repeats: Vec<usize>,
}

/// A comparison of the means of two groups.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TTestSpec {
    /// Letter of the group.
    pub group: String,
    /// Measure to compare.
    pub measure: Measure,
    /// Scenario and method.
    pub a: [String; 2],
    /// Scenario and method.
    pub b: [String; 2],
    /// welch (default) or pooled.
    #[serde(default)]
    pub variances: Comparison,
}

/// A measure of a trial.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// Time of the planner, s.
    PlanningSeconds,
    /// Time of post-processing, s.
    PostSeconds,
    /// Length of the planner's path, m.
    RawCost,
    /// Length of the final path, m.
    Cost,
}
