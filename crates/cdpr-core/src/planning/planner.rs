//! All planners with their options: as types for code, and as plain settings for files and the command line.

use rand::Rng;
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::anytime::{PathOptimizer, anytime};
use super::modified_rrt::modified_rrt;
use super::outcome::{Improved, Outcome};
use super::rrt::{RrtOptions, rrt};
use super::rrt_connect::rrt_connect;
use super::rrt_star::{RrtStarOptions, rrt_star};
use super::search::{Search, SearchLimits, Until};
use super::space::{Problem, StateSpace};
use super::two_trees::two_trees;
use crate::choice::Choice;
use crate::choices;
use crate::collision::Validity;
use crate::error::Error;
use crate::watch::Watch;

/// Default step of rewinding, and of the trees of RRT and RRT*, m.
const STEP: f64 = 0.1;

/// The planners.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Planner {
    /// A first path quickly, then shorter ones.
    #[default]
    Anytime,
    /// Connects samples directly to trees from start and goal.
    TwoTrees,
    /// Two trees that grow towards each other in steps.
    RrtConnect,
    /// Algorithm 3 of the paper.
    ModifiedRrt,
    /// Plain RRT.
    Rrt,
    /// Algorithm 1 of the paper.
    RrtStar,
}

choices!(Planner, "planner", [
    Anytime = "anytime": "Finds a first path quickly, then shorter ones by sampling, subdivision and string pulling",
    TwoTrees = "two-trees": "Connects samples directly to trees from start and goal: the fastest first path",
    RrtConnect = "rrt-connect": "Grows two trees towards each other in steps (Kuffner and LaValle)",
    ModifiedRrt = "modified-rrt": "Connects samples directly and tries the goal after every change (the paper, Algorithm 3)",
    Rrt = "rrt": "Grows in steps towards random samples",
    RrtStar = "rrt-star": "RRT that also rewires nodes to cheaper parents (the paper, Algorithm 1)",
]);

impl Planner {
    /// The settings that not all planners have.
    fn own_settings(self) -> &'static [&'static str] {
        match self {
            Planner::Anytime => &["gap"],
            Planner::TwoTrees => &[],
            Planner::RrtConnect => &["extend_step"],
            Planner::ModifiedRrt => &["goal_bias"],
            Planner::Rrt => &["extend_step", "goal_bias", "check_goal"],
            Planner::RrtStar => &["extend_step", "goal_bias", "near_radius", "near_cap"],
        }
    }

    /// The limits of a search where none are given.
    fn limits(self) -> SearchLimits {
        match self {
            Planner::Anytime => SearchLimits::samples(usize::MAX),
            Planner::RrtConnect => SearchLimits { max_nodes: 1_000_000, ..SearchLimits::samples(500_000) },
            Planner::RrtStar => SearchLimits::samples(500_000),
            Planner::TwoTrees | Planner::ModifiedRrt | Planner::Rrt => SearchLimits::samples(20_000),
        }
    }
}

/// A planner with its options.
#[derive(Debug, Clone, PartialEq)]
pub struct PlannerOptions {
    /// What ends the search. With `Until::FirstPath`, the anytime planner continues until nothing has improved for a while.
    pub limits: SearchLimits,
    /// Search method and its options.
    pub method: Method,
}

/// A planner with the options that not all planners have.
#[derive(Debug, Clone, PartialEq)]
pub enum Method {
    /// The anytime planner.
    Anytime {
        /// The search ends when the best path is longer than a lower bound of all paths by at most this share.
        gap: Option<f64>,
    },
    /// Two trees with direct connections.
    TwoTrees,
    /// RRT-Connect.
    RrtConnect {
        /// Longest edge of the trees, m; by default a fifth of the largest distance in the space.
        step: Option<f64>,
    },
    /// Modified RRT.
    ModifiedRrt {
        /// Probability of using the goal as the sample; `None`, as in the paper, tries it after every change of the tree.
        goal_bias: Option<f64>,
    },
    /// Plain RRT.
    Rrt(RrtOptions),
    /// RRT*.
    RrtStar(RrtStarOptions),
}

/// Settings of a planner; omitted ones take the planner's defaults.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PlannerSettings {
    /// Stop after this many random samples; default 20 000, for rrt-star and rrt-connect 500 000, for anytime no limit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_samples: Option<usize>,
    /// Stop after this many nodes; default no limit, for rrt-connect 1 000 000.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_nodes: Option<usize>,
    /// Continue after the first path until samples, nodes or time run out.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub keep_going: bool,
    /// Continue after the first path until the path is at most this long, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub target_cost: Option<f64>,
    /// With anytime, continue until the path is proved to be at most this fraction longer than the shortest: 0.01 for 1
    /// %.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Longest edge that rrt, rrt-star and rrt-connect add, m; default the step of rewinding, as in the paper, for
    /// rrt-connect a fifth of the diagonal of the box of positions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extend_step: Option<f64>,
    /// Probability with which rrt, rrt-star and modified-rrt use the goal as the sample; default 0, for modified-rrt the
    /// paper's rule, which tries the goal after every change of the tree.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal_bias: Option<f64>,
    /// With rrt, use the goal as the next sample after every change of the tree, as modified-rrt does.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub check_goal: bool,
    /// Radius of rrt-star's neighbourhood around a new node, m; default min(γ (ln n / n)^(1/3), near_cap) for n nodes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub near_radius: Option<f64>,
    /// Largest radius of rrt-star's neighbourhood if it shrinks with the number of nodes, m; default extend_step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub near_cap: Option<f64>,
}

impl Default for PlannerOptions {
    fn default() -> Self {
        PlannerOptions::of(Planner::default())
    }
}

impl PlannerOptions {
    /// A planner with its defaults.
    pub fn of(planner: Planner) -> Self {
        PlannerOptions::new(planner, STEP, &PlannerSettings::default()).expect("defaults are in range")
    }

    /// A planner with the given settings; `step` (m) is the step of rewinding, which RRT and RRT* use by default.
    ///
    /// # Errors
    /// A number out of range, or a setting that the planner does not have; the error names the key.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Planner, PlannerOptions, PlannerSettings};
    /// let settings = PlannerSettings { near_radius: Some(0.3), ..Default::default() };
    /// assert!(PlannerOptions::new(Planner::RrtStar, 0.1, &settings).is_ok());
    /// let error = PlannerOptions::new(Planner::Rrt, 0.1, &settings).unwrap_err().to_string();
    /// assert_eq!(error, "near_radius: found 0.3, but the planner rrt has no such setting; only rrt-star has it");
    /// ```
    pub fn new(planner: Planner, step: f64, settings: &PlannerSettings) -> Result<Self, Error> {
        let limits = settings.limits(planner)?;
        settings.refuse_unknown_settings(planner)?;
        let step = positive("extend_step", settings.extend_step, "m")?.unwrap_or(step);
        let given_bias = probability("goal_bias", settings.goal_bias)?;
        let goal_bias = given_bias.unwrap_or(0.0);
        let method = match planner {
            Planner::Anytime => Method::Anytime { gap: positive("gap", settings.gap, "of the cost")? },
            Planner::RrtConnect => Method::RrtConnect { step: settings.extend_step },
            Planner::TwoTrees => Method::TwoTrees,
            Planner::ModifiedRrt => Method::ModifiedRrt { goal_bias: given_bias },
            Planner::Rrt => {
                let check_goal = settings.check_goal;
                if check_goal && given_bias.is_some() {
                    let problem = format!("found {goal_bias} with check_goal, expected one of them");
                    return Err(Error::invalid("goal_bias", problem));
                }
                Method::Rrt(RrtOptions { step, goal_bias, check_goal })
            }
            Planner::RrtStar => {
                let near_radius = positive("near_radius", settings.near_radius, "m")?;
                let near_cap = positive("near_cap", settings.near_cap, "m")?;
                if let (Some(_), Some(cap)) = (near_radius, near_cap) {
                    let problem =
                        format!("found {cap} m with near_radius, which does not shrink; expected one of them");
                    return Err(Error::invalid("near_cap", problem));
                }
                Method::RrtStar(RrtStarOptions { step, goal_bias, near_radius, near_cap })
            }
        };
        Ok(PlannerOptions { limits, method })
    }

    /// The planner that these options are for.
    pub fn planner(&self) -> Planner {
        match self.method {
            Method::Anytime { .. } => Planner::Anytime,
            Method::TwoTrees => Planner::TwoTrees,
            Method::RrtConnect { .. } => Planner::RrtConnect,
            Method::ModifiedRrt { .. } => Planner::ModifiedRrt,
            Method::Rrt(_) => Planner::Rrt,
            Method::RrtStar(_) => Planner::RrtStar,
        }
    }

    /// All settings, including defaults, as recorded in files.
    pub fn settings(&self) -> PlannerSettings {
        let limits = &self.limits;
        let mut own = PlannerSettings::default();
        match &self.method {
            Method::Anytime { gap } => own.gap = *gap,
            Method::TwoTrees => {}
            Method::RrtConnect { step } => own.extend_step = *step,
            Method::ModifiedRrt { goal_bias } => own.goal_bias = *goal_bias,
            Method::Rrt(rrt) => {
                (own.extend_step, own.check_goal) = (Some(rrt.step), rrt.check_goal);
                own.goal_bias = (!rrt.check_goal).then_some(rrt.goal_bias);
            }
            Method::RrtStar(star) => {
                (own.extend_step, own.goal_bias) = (Some(star.step), Some(star.goal_bias));
                (own.near_radius, own.near_cap) = (star.near_radius, star.near_cap);
            }
        }
        PlannerSettings {
            max_samples: Some(limits.max_samples).filter(|n| *n < usize::MAX),
            max_nodes: Some(limits.max_nodes).filter(|n| *n < usize::MAX),
            keep_going: limits.until == Until::Cost(0.0),
            target_cost: match limits.until {
                Until::Cost(target) if target > 0.0 => Some(target),
                _ => None,
            },
            ..own
        }
    }

    /// Searches for a path with this planner; `improved` is called with every better one.
    ///
    /// # Errors
    /// [`Error::interrupted`] if the watch requests it before there is a path.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Interference, collision::CspaceEngine};
    /// use cdpr_core::{Planner, PlannerOptions, Status, planning::{Problem, TranslationSpace}};
    /// use cdpr_core::{Watch, postprocess::StringPuller};
    /// use rand::SeedableRng;
    /// let scene = cdpr_core::testing::hard1();
    /// let engine = CspaceEngine::new(&scene, Interference::Exact)?;
    /// let space = TranslationSpace::of(cdpr_core::collision::Checker::conditions(&engine));
    /// let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
    /// let (planner, puller) = (PlannerOptions::of(Planner::RrtConnect), StringPuller::new(&engine));
    /// let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
    /// let outcome = planner.search(&problem, &engine, &puller, &|_, _, _| (), &mut rng, &Watch::NONE)?;
    /// assert_eq!(outcome.status, Status::Solved);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn search<S: StateSpace>(
        &self,
        problem: &Problem<S>,
        validity: &dyn Validity<S::State>,
        optimizer: &dyn PathOptimizer<S::State>,
        improved: &Improved<S::State>,
        rng: &mut impl Rng,
        watch: &Watch,
    ) -> Result<Outcome<S::State>, Error> {
        let search = Search::new(problem, validity, self.limits, improved, watch);
        match &self.method {
            Method::Anytime { gap } => anytime(search, optimizer, *gap, rng),
            Method::TwoTrees => two_trees(search, rng),
            Method::RrtConnect { step } => rrt_connect(search, *step, rng),
            Method::ModifiedRrt { goal_bias } => modified_rrt(search, *goal_bias, rng),
            Method::Rrt(options) => rrt(search, options, rng),
            Method::RrtStar(options) => rrt_star(search, options, rng),
        }
    }
}

impl PlannerSettings {
    fn limits(&self, planner: Planner) -> Result<SearchLimits, Error> {
        let default = planner.limits();
        let max_samples = self.max_samples.unwrap_or(default.max_samples);
        let max_nodes = self.max_nodes.unwrap_or(default.max_nodes);
        let until = match positive("target_cost", self.target_cost, "m")? {
            Some(target) => Until::Cost(target),
            None if self.keep_going => Until::Cost(0.0),
            None => Until::FirstPath,
        };
        Ok(SearchLimits { max_samples, max_nodes, until })
    }

    /// Rejects a setting that the planner does not have.
    fn refuse_unknown_settings(&self, planner: Planner) -> Result<(), Error> {
        let number = |found: Option<f64>| found.map(|found| found.to_string());
        let given = [
            ("gap", number(self.gap)),
            ("extend_step", number(self.extend_step)),
            ("goal_bias", number(self.goal_bias)),
            ("check_goal", self.check_goal.then(|| "true".to_string())),
            ("near_radius", number(self.near_radius)),
            ("near_cap", number(self.near_cap)),
        ];
        for (key, found) in given {
            if let Some(found) = found.filter(|_| !planner.own_settings().contains(&key)) {
                let owners = Planner::ALL.iter().filter(|(other, ..)| other.own_settings().contains(&key));
                let owners: Vec<&str> = owners.map(|(_, name, _)| *name).collect();
                let verb = if owners.len() > 1 { "have" } else { "has" };
                let (name, owners) = (planner.name(), listed(&owners));
                let problem =
                    format!("found {found}, but the planner {name} has no such setting; only {owners} {verb} it");
                return Err(Error::invalid(key, problem));
            }
        }
        Ok(())
    }
}

/// Names in a sentence: a, b and c.
fn listed(names: &[&str]) -> String {
    match names {
        [others @ .., last] if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => names.concat(),
    }
}

fn positive(key: &str, number: Option<f64>, unit: &str) -> Result<Option<f64>, Error> {
    match number {
        Some(x) if !(x > 0.0 && x.is_finite()) => {
            Err(Error::invalid(key, format!("found {x} {unit}, expected a positive number")))
        }
        _ => Ok(number),
    }
}

fn probability(key: &str, number: Option<f64>) -> Result<Option<f64>, Error> {
    match number {
        Some(p) if !(0.0..=1.0).contains(&p) => {
            Err(Error::invalid(key, format!("found {p}, expected a probability from 0 to 1")))
        }
        _ => Ok(number),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_go_there_and_back() {
        let settings = PlannerSettings {
            max_samples: Some(7),
            max_nodes: Some(9),
            keep_going: false,
            target_cost: Some(2.5),
            gap: None,
            extend_step: Some(0.2),
            goal_bias: Some(0.05),
            check_goal: false,
            near_radius: Some(0.3),
            near_cap: None,
        };
        let there_and_back = |planner, settings: &PlannerSettings| {
            assert_eq!(&PlannerOptions::new(planner, 0.1, settings).unwrap().settings(), settings);
        };
        there_and_back(Planner::RrtStar, &settings);
        there_and_back(
            Planner::RrtStar,
            &PlannerSettings { near_radius: None, near_cap: Some(4.0), ..settings.clone() },
        );
        let without = PlannerSettings { near_radius: None, ..settings };
        there_and_back(Planner::Rrt, &PlannerSettings { goal_bias: None, check_goal: true, ..without.clone() });
        there_and_back(Planner::ModifiedRrt, &PlannerSettings { extend_step: None, ..without });
        for (planner, ..) in Planner::ALL {
            let options = PlannerOptions::new(*planner, 0.1, &PlannerSettings::default()).unwrap();
            assert_eq!((options.planner(), &options), (*planner, &PlannerOptions::of(*planner)));
            assert_eq!(PlannerOptions::new(*planner, 0.1, &options.settings()).unwrap(), options);
        }
    }

    #[test]
    fn bad_settings_are_named() {
        let ask = |settings| PlannerOptions::new(Planner::RrtStar, 0.1, &settings).unwrap_err().to_string();
        let none = PlannerSettings::default;
        assert_eq!(
            ask(PlannerSettings { goal_bias: Some(1.5), ..none() }),
            "goal_bias: found 1.5, expected a probability from 0 to 1"
        );
        assert!(ask(PlannerSettings { near_radius: Some(f64::NAN), ..none() }).starts_with("near_radius: found NaN m"));
        assert!(ask(PlannerSettings { extend_step: Some(0.0), ..none() }).starts_with("extend_step: found 0 m"));
        assert_eq!(
            ask(PlannerSettings { near_cap: Some(4.0), near_radius: Some(0.3), ..none() }),
            "near_cap: found 4 m with near_radius, which does not shrink; expected one of them"
        );
        let both = PlannerSettings { goal_bias: Some(0.1), check_goal: true, ..none() };
        assert_eq!(
            PlannerOptions::new(Planner::Rrt, 0.1, &both).unwrap_err().to_string(),
            "goal_bias: found 0.1 with check_goal, expected one of them"
        );
        assert_eq!(
            ask(PlannerSettings { check_goal: true, ..none() }),
            "check_goal: found true, but the planner rrt-star has no such setting; only rrt has it"
        );
        let biased = PlannerSettings { goal_bias: Some(0.1), ..none() };
        let message = PlannerOptions::new(Planner::TwoTrees, 0.1, &biased).unwrap_err().to_string();
        assert!(message.ends_with("only modified-rrt, rrt and rrt-star have it"), "{message}");
        assert!(ask(PlannerSettings { target_cost: Some(-1.0), ..none() }).starts_with("target_cost: found -1 m"));
    }
}
