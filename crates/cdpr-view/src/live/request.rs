//! The requests of the page as plain data.

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::model::SceneSpec;
use cdpr_core::path_file::PathFile;
use cdpr_core::plan::{PlanOptions, Post};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings};
use cdpr_core::watch::{TimeUnit, time_budget};
use cdpr_core::{Choice, Error};
use serde::Deserialize;

/// A question about a scene.
#[derive(Debug, Deserialize)]
pub struct Request {
    /// The scene as in its file, with robot and meshes inline.
    pub scene: SceneSpec,
    /// The kind of the request.
    #[serde(flatten)]
    pub ask: Ask,
}

/// The kinds of request.
#[derive(Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "lowercase")]
pub enum Ask {
    /// A path from the scene's start to its goal.
    Plan {
        /// Options of planning.
        #[serde(default)]
        options: Box<Options>,
        /// A path before something has moved: what is still valid of it is kept if it has the scene's start and goal.
        #[serde(default)]
        path: Option<Box<PathFile>>,
        /// Whether the answer holds the contents of the page.
        #[serde(default)]
        page: bool,
        /// Whether the contents of the page include those that do not depend on the path: shadows and the
        /// wrench-feasible workspace.
        #[serde(default)]
        extras: bool,
    },
    /// The contents of the page.
    Page {
        /// The path shown on the page.
        #[serde(default)]
        path: Option<Box<PathFile>>,
        /// Whether the contents of the page include those that do not depend on the path: shadows and the
        /// wrench-feasible workspace.
        #[serde(default)]
        extras: bool,
    },
    /// Whether the platform can be at a position.
    Place {
        /// The position, world, m.
        at: [f64; 3],
        /// The orientation at the position, a unit quaternion w x y z; if omitted, the scene's. Only for a platform
        /// that may turn.
        #[serde(default)]
        orientation: Option<[f64; 4]>,
    },
    /// Where the platform can be, proved as far as the time allows: at the scene's orientation, or if it selects none, at any of
    /// those that it lists.
    Workspace {
        /// Time limit, ms.
        budget_ms: f64,
    },
    /// The scene as a TOML file.
    Toml,
}

/// How a path is planned; omitted options have the defaults of the program.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Options {
    /// Name of the planner.
    pub planner: Option<String>,
    /// Seed of all random numbers.
    pub seed: Option<u64>,
    /// Name of the engine.
    pub engine: Option<String>,
    /// Name of the rule for interference between cables.
    pub interference: Option<String>,
    /// Name of the post-processing.
    pub post: Option<String>,
    /// Step of rewinding, m.
    pub step: Option<f64>,
    /// Number of times that rewinding runs.
    pub repeats: Option<usize>,
    /// Time limit of planning, ms.
    pub budget_ms: Option<f64>,
    /// Whether planning also decides if there is a path at all.
    pub proof: Option<bool>,
    /// Continue until the path is proved to be at most this fraction longer than the shortest.
    pub gap: Option<f64>,
    /// Other settings of the planner.
    #[serde(default)]
    pub settings: PlannerSettings,
}

impl TryFrom<&Options> for PlanOptions {
    type Error = Error;

    fn try_from(options: &Options) -> Result<Self, Error> {
        let default = PlanOptions::default();
        let step = options.step.unwrap_or(default.step);
        let settings = PlannerSettings { gap: options.gap.or(options.settings.gap), ..options.settings.clone() };
        let planner: Planner = named(options.planner.as_deref())?.unwrap_or_default();
        let budget = options.budget_ms.map(|ms| time_budget("budget_ms", ms, TimeUnit::Millisecond)).transpose()?;
        let post: Option<Post> = named(options.post.as_deref())?;
        let engine: Engine = named(options.engine.as_deref())?.unwrap_or_default();
        let interference: Interference = named(options.interference.as_deref())?.unwrap_or_default();
        Ok(PlanOptions {
            planner: PlannerOptions::new(planner, step, &settings)?,
            engine,
            interference,
            seed: options.seed.unwrap_or(default.seed),
            step,
            post,
            repeats: options.repeats.unwrap_or(default.repeats),
            proof: options.proof.unwrap_or(default.proof),
            budget,
        })
    }
}

fn named<T: Choice>(name: Option<&str>) -> Result<Option<T>, Error> {
    name.map(T::named).transpose()
}
