//! A checked experiment, and the layout of its results.

use serde::{Deserialize, Serialize};
use serde_json::json;

use super::random_scene::{RandomScenes, RandomScenesSpec};
use crate::experiment_spec::{ExperimentSpec, MethodSpec, ScenarioSpec, SceneSource, SweepSpec, TTestSpec};
use cdpr_core::choice::Choice;
use cdpr_core::collision::Interference;
use cdpr_core::error::{Error, nearest_name};
use cdpr_core::fingerprint::fingerprint_of;
use cdpr_core::limits::{MOST_ROWS_PER_TRIAL, MOST_TRIALS};
use cdpr_core::model::spec::FORMAT_VERSION;
use cdpr_core::model::{PositionSource, Scene, body};
use cdpr_core::plan::{PlanOptions, Post, Processing, Query, Route};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings};
use cdpr_core::postprocess::RewindOptions;
use cdpr_core::turning::PoseSpace;
use cdpr_core::watch::{TimeUnit, time_budget};

/// Default level of confidence intervals.
const CONFIDENCE: f64 = 0.95;
/// Begins the planner's name in a method whose planner is a function of the caller.
const EXTERNAL: &str = "python:";

/// A checked experiment. Immutable; made by [`Experiment::new`].
#[derive(Debug, Clone)]
pub struct Experiment {
    /// Name used in messages.
    pub name: String,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of trials of each method in each scenario.
    pub trials: usize,
    /// The scenarios of the experiment.
    pub scenarios: Vec<Scenario>,
    /// The methods of the experiment.
    pub methods: Vec<Method>,
    /// The layout of the results.
    pub layout: Layout,
    /// Identifies everything that the rows depend on: all except name, number of trials, tests and confidence.
    pub fingerprint: String,
    /// The experiment as data with inline scenes, so that it can be sent to machines without the scene files.
    pub portable: ExperimentSpec,
}

/// One scene for all trials, or one for each.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// Name used in tables.
    pub name: String,
    /// The scene, or the base of random scenes.
    pub scene: Scene,
    /// What paths pass, and where they may end.
    pub route: Route,
    /// Draws a trial's scene.
    pub random: Option<RandomScenes>,
}

/// A planner, and one or more ways to process its raw path.
#[derive(Debug, Clone)]
pub struct Method {
    /// Name of the method; its random numbers derive from it.
    pub name: String,
    /// Options of planning. Their post-processing is used only in scenarios that [plan whole paths](Scenario::plans_whole_paths).
    pub options: PlanOptions,
    /// Names used in tables, and the processing of the raw path in all other scenarios.
    pub variants: Vec<(String, Processing)>,
    /// The settings in which the variants of a sweep differ; empty without a sweep.
    pub sweep: Vec<Swept>,
    /// The planner, if it is a function of the caller: [`crate::external`] measures its paths.
    pub external: Option<String>,
}

/// The layout of the tables of a run, stored beside its rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Layout {
    /// Scenario and variants of each pair of scenario and method, in order of work within a trial.
    pub groups: Vec<Group>,
    /// Requested comparisons.
    pub t_tests: Vec<TTestSpec>,
    /// Level of confidence intervals.
    pub confidence: f64,
    /// Whether rows record when the path improved.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub history: bool,
}

/// The methods of the table that one trial of a method in a scenario fills.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// Name of the scenario.
    pub scenario: String,
    /// Names of the methods.
    pub methods: Vec<String>,
    /// The place of each method in its sweep; empty without a sweep.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sweep: Vec<Swept>,
    /// Whether the platform may turn, so that lengths include its turns.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub turns: bool,
}

/// The place of a variant in its sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Swept {
    /// Name of the swept method.
    pub of: String,
    /// Step of rewinding, m, if it is swept.
    pub step: Option<f64>,
    /// Order of rewinding, if it is swept.
    pub post: Option<String>,
    /// Number of repeats, if it is swept.
    pub repeats: Option<usize>,
}

/// How a method plans and checks, including defaults; recorded beside its rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Rules {
    /// Name of the method.
    pub method: String,
    /// Name of the planner.
    pub planner: String,
    /// Settings of the planner.
    pub options: PlannerSettings,
    /// Name of the collision engine: cspace or gjk.
    pub engine: String,
    /// Rule for interference between cables: exact or swept.
    pub interference: String,
    /// Step of rewinding, m.
    pub step: f64,
    /// Post-processing of the path, unless it is swept.
    pub post: String,
    /// Number of times that rewinding runs, unless it is swept.
    pub repeats: usize,
    /// Time limit of a trial, ms.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub budget_ms: Option<f64>,
    /// Whether it is decided before the trials if there is a path at all; omitted if it is.
    #[serde(default = "decided", skip_serializing_if = "Clone::clone")]
    pub proof: bool,
    /// The swept parameters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sweep: Option<SweepSpec>,
}

impl Experiment {
    /// The rules of each method.
    pub fn rules(&self) -> Vec<Rules> {
        let methods = self.methods.iter().zip(&self.portable.methods);
        methods.map(|(method, spec)| Rules::of(method, spec)).collect()
    }

    /// Checks that all planners are built in.
    ///
    /// # Errors
    /// Names the method whose planner is a function of the caller.
    pub fn all_built_in(&self) -> Result<(), Error> {
        let external = self.methods.iter().enumerate().find_map(|(k, m)| Some((k, m.external.as_ref()?)));
        external.map_or(Ok(()), |(k, name)| {
            let expected = "expected a planner of cdpr; cdpr.run_batch in Python takes the function itself";
            Err(Error::invalid(format!("methods[{k}].planner"), format!("found the function \"{name}\", {expected}")))
        })
    }

    /// Checks an experiment; `load` reads scene files that it refers to.
    ///
    /// # Errors
    /// Names the key, what was found and what was expected.
    pub fn new(spec: ExperimentSpec, load: impl Fn(&SceneSource) -> Result<Scene, Error>) -> Result<Self, Error> {
        if spec.version != FORMAT_VERSION {
            return Err(Error::invalid("version", format!("found {}, expected {FORMAT_VERSION}", spec.version)));
        }
        if !(1..=MOST_TRIALS).contains(&spec.trials) {
            let problem = format!("found {}, expected at least 1 and at most {MOST_TRIALS}", spec.trials);
            return Err(Error::invalid("trials", problem));
        }
        body::optional_name("name", spec.name.as_deref())?;
        for (k, test) in spec.t_tests.iter().enumerate() {
            body::name(&format!("t_tests[{k}].group"), &test.group)?;
        }
        let confidence = spec.confidence.unwrap_or(CONFIDENCE);
        sound_confidence(confidence)?;
        few_rows(&spec)?;
        let scenarios = each("scenarios", &spec.scenarios, |scenario| Scenario::all(scenario, &load))?;
        let methods = each("methods", &spec.methods, Method::new)?;
        for (number, scenario) in scenarios.iter().enumerate().flat_map(|(k, of)| of.iter().map(move |one| (k, one))) {
            if spec.history && !scenario.route.is_plain() {
                let problem = format!("found true, expected false, {}", scenario.why_whole(number));
                return Err(Error::invalid("history", problem));
            }
            each("methods", &methods, |method| method.fits(scenario, number))?;
        }
        let (random, scenarios): (Vec<_>, Vec<Scenario>) = (spec.scenarios.iter().zip(scenarios))
            .flat_map(|(spec, scenarios)| scenarios.into_iter().map(|scenario| (spec.random.clone(), scenario)))
            .unzip();
        unique("scenarios", scenarios.iter().map(|s| s.name.as_str()))?;
        let variants = || methods.iter().flat_map(|m| m.variants.iter().map(|(name, _)| name.as_str()));
        unique("methods", variants())?;
        for (k, test) in spec.t_tests.iter().enumerate() {
            for (side, [scenario, method]) in [("a", &test.a), ("b", &test.b)] {
                let place = format!("t_tests[{k}].{side}");
                known(&place, "scenario", scenario, scenarios.iter().map(|s| s.name.as_str()))?;
                known(&place, "method", method, variants())?;
            }
        }
        let group = |scenario: &Scenario, method: &Method| Group {
            scenario: scenario.name.clone(),
            methods: method.variants.iter().map(|(name, _)| name.clone()).collect(),
            sweep: method.sweep.clone(),
            turns: scenario.turns(),
        };
        let groups = scenarios.iter().flat_map(|s| methods.iter().map(move |m| group(s, m))).collect();
        let layout = Layout { groups, t_tests: spec.t_tests.clone(), confidence, history: spec.history };
        let single = |(random, scenario): (Option<RandomScenesSpec>, &Scenario)| ScenarioSpec {
            name: scenario.name.clone(),
            scene: SceneSource::Inline(Box::new(scenario.scene.spec().clone())),
            random,
            queries: Vec::new(),
            via: scenario.route.via.clone(),
            goals: scenario.route.goals.clone(),
            goal_box: scenario.route.goal_box.map(|corners| corners.map(Into::into)),
        };
        let portable =
            ExperimentSpec { scenarios: random.into_iter().zip(&scenarios).map(single).collect(), ..spec.clone() };
        let fingerprint = fingerprint(&portable, &scenarios);
        let name = spec.name.clone().unwrap_or_else(|| "experiment".to_string());
        let (seed, trials) = (spec.seed, spec.trials);
        Ok(Experiment { name, seed, trials, scenarios, methods, layout, fingerprint, portable })
    }
}

/// Checks the level of confidence intervals.
fn sound_confidence(confidence: f64) -> Result<(), Error> {
    if confidence > 0.0 && confidence < 1.0 {
        return Ok(());
    }
    Err(Error::invalid("confidence", format!("found {confidence}, expected a number between 0 and 1")))
}

/// Rejects more combinations of scenarios, methods and sweeps than tables can hold, before any is made.
fn few_rows(spec: &ExperimentSpec) -> Result<(), Error> {
    let variants = |method: &MethodSpec| {
        let sweep = method.sweep.clone().unwrap_or_default();
        let counts = [sweep.step.len(), sweep.post.len(), sweep.repeats.len()];
        counts.into_iter().map(|count| count.max(1)).fold(1, usize::saturating_mul)
    };
    let methods = spec.methods.iter().map(variants).fold(0, usize::saturating_add);
    let scenarios: usize = spec.scenarios.iter().map(|scenario| scenario.queries.len().max(1)).sum();
    if methods.saturating_mul(scenarios) <= MOST_ROWS_PER_TRIAL {
        return Ok(());
    }
    let problem = format!(
        "found {methods} including variants of sweeps, in {scenarios} scenarios; expected at most {MOST_ROWS_PER_TRIAL} \
         pairs of method and scenario"
    );
    Err(Error::invalid("methods", problem))
}

impl Layout {
    /// Checks a layout from a file: a valid confidence level, and for each group its methods and, if any, their places
    /// in a sweep.
    pub(crate) fn check(&self) -> Result<(), Error> {
        sound_confidence(self.confidence)?;
        for (k, Group { methods, sweep, .. }) in self.groups.iter().enumerate() {
            if methods.is_empty() || !(sweep.is_empty() || sweep.len() == methods.len()) {
                let problem = format!("found {} methods and {} places in a sweep", methods.len(), sweep.len());
                let expected = "expected at least one method, and as many places or none";
                return Err(Error::invalid(format!("groups[{k}]"), format!("{problem}, {expected}")));
            }
        }
        Ok(())
    }
}

impl Scenario {
    /// The scenario of a spec, or one for each of its queries.
    fn all(spec: &ScenarioSpec, load: &impl Fn(&SceneSource) -> Result<Scene, Error>) -> Result<Vec<Self>, Error> {
        body::name("name", &spec.name)?;
        let scene = load(&spec.scene).map_err(|e| e.under("scene"))?;
        if !(spec.queries.is_empty() || (spec.goals.is_empty() && spec.goal_box.is_none())) {
            let problem = "found with goals or goal_box, expected one of them: each query has its goal";
            return Err(Error::invalid("queries", problem));
        }
        if spec.queries.is_empty() {
            return Ok(vec![Scenario::new(spec.name.clone(), scene, spec)?]);
        }
        let of = |ends: &[PositionSource; 2]| {
            let scene = scene.clone().between(ends.clone().map(Some)).map_err(|e| e.below("query"))?;
            let [start, goal] = ends;
            Scenario::new(format!("{}: {start} to {goal}", spec.name), scene, spec)
        };
        each("queries", &spec.queries, of)
    }

    fn new(name: String, scene: Scene, spec: &ScenarioSpec) -> Result<Self, Error> {
        if scene.orientation_is_open() {
            let expected = "expected query.orientation: all methods plan at the same one";
            return Err(Error::invalid("scene", format!("found several orientations, {expected}")));
        }
        let goal_box = spec.goal_box.map(|corners| corners.map(Into::into));
        let route = Route { via: spec.via.clone(), goals: spec.goals.clone(), goal_box };
        route.check(&PlanOptions::default())?;
        let random = spec.random.clone().map(|random| RandomScenes::along(scene.clone(), random, &route));
        let scenario = Scenario { name, scene, route, random: random.transpose().map_err(|e| e.under("random"))? };
        scenario.check_stops()?;
        Ok(scenario)
    }

    /// Checks that start, via points and goals are known, and that a platform which may turn can do so to all orientations there.
    fn check_stops(&self) -> Result<(), Error> {
        let placed =
            |e: Error| if e.place().is_some_and(|key| key.starts_with("query.")) { e.under("scene") } else { e };
        for stops in self.route.stops(&Query::of(&self.scene)).map_err(placed)? {
            for stop in stops[1..].iter().filter(|_| self.turns()) {
                PoseSpace::of(&self.scene, [&stops[0], stop]).map_err(|e| e.under("scene"))?;
            }
        }
        Ok(())
    }

    /// Whether the platform may turn on its way.
    pub fn turns(&self) -> bool {
        let stops = self.route.stops(&Query::of(&self.scene)).unwrap_or_default().concat();
        self.scene.turning().is_some() || !self.scene.keeps_orientation(&stops)
    }

    /// Whether each trial plans and processes its path as a whole, so that no raw path can be processed in several ways: if the platform may
    /// turn, or with via points, goals or a box of goals.
    pub fn plans_whole_paths(&self) -> bool {
        self.turns() || !self.route.is_plain()
    }

    /// Why this scenario, one of those at a place in the file, plans whole paths.
    fn why_whole(&self, place: usize) -> String {
        match self.route.is_plain() {
            true => format!("since the platform of scenarios[{place}] may turn"),
            false => format!("since scenarios[{place}] has via points, goals or a box of goals"),
        }
    }
}

impl Rules {
    fn of(Method { name, options, external, .. }: &Method, spec: &MethodSpec) -> Self {
        let planner = options.planner.planner();
        Rules {
            method: name.clone(),
            planner: external.as_deref().unwrap_or(planner.name()).into(),
            options: options.planner.settings(),
            engine: options.engine.name().into(),
            interference: options.interference.name().into(),
            step: options.step,
            post: post_of(spec, external.is_some(), planner),
            repeats: repeats_of(spec),
            budget_ms: spec.budget_ms,
            proof: options.proof,
            sweep: spec.sweep.clone(),
        }
    }
}

fn decided() -> bool {
    PlanOptions::default().proof
}

fn post_of(spec: &MethodSpec, external: bool, planner: Planner) -> String {
    let usual = || if external { Post::None } else { Post::of(planner) };
    spec.post.clone().unwrap_or_else(|| usual().name().to_string())
}

fn repeats_of(spec: &MethodSpec) -> usize {
    spec.repeats.unwrap_or(RewindOptions::default().repeats)
}

impl Method {
    /// Checks that this method can plan in a scenario, which is one of those at this place in the file.
    fn fits(&self, scenario: &Scenario, place: usize) -> Result<(), Error> {
        scenario.route.check(&self.options).map_err(|e| e.under("options"))?;
        let refused =
            |key: &str, found: &str| Err(Error::invalid(key, format!("found {found}, {}", scenario.why_whole(place))));
        if scenario.plans_whole_paths() && !self.sweep.is_empty() {
            return refused("sweep", "a sweep of rewinding, expected none");
        }
        if scenario.plans_whole_paths() && self.external.is_some() {
            return refused("planner", "a function, expected a planner of cdpr");
        }
        if scenario.turns() && self.options.interference == Interference::Swept {
            let problem =
                format!("found \"swept\", expected \"exact\", since the platform of scenarios[{place}] may turn");
            return Err(Error::invalid("interference", problem));
        }
        Ok(())
    }

    fn new(spec: &MethodSpec) -> Result<Self, Error> {
        body::name("name", &spec.name)?;
        let defaults = PlanOptions::default();
        let step = spec.step.unwrap_or(defaults.step);
        // By default, experiments repeat the paper.
        let external = spec.planner.as_deref().and_then(|name| name.strip_prefix(EXTERNAL));
        external.map_or(Ok(()), |name| check_external(name, spec))?;
        let named = spec.planner.as_deref().filter(|_| external.is_none());
        let planner = chosen(named, Planner::ModifiedRrt)?;
        let options = PlanOptions {
            planner: PlannerOptions::new(planner, step, &spec.options).map_err(|e| e.under("options"))?,
            engine: chosen(spec.engine.as_deref(), defaults.engine)?,
            interference: chosen(spec.interference.as_deref(), defaults.interference)?,
            budget: spec.budget_ms.map(|ms| time_budget("budget_ms", ms, TimeUnit::Millisecond)).transpose()?,
            step,
            post: spec.post.as_deref().map(Post::named).transpose()?,
            repeats: repeats_of(spec),
            proof: spec.proof.unwrap_or(defaults.proof),
            ..defaults
        };
        let (variants, sweep) = variants(spec, external.is_some(), planner, step)?.into_iter().unzip();
        let sweep = if spec.sweep.is_some() { sweep } else { Vec::new() };
        Ok(Method { name: spec.name.clone(), options, variants, sweep, external: external.map(str::to_string) })
    }
}

/// Checks a method whose planner is a function of the caller: it has none of the options of a planner of cdpr.
fn check_external(name: &str, spec: &MethodSpec) -> Result<(), Error> {
    body::name("planner", name)?;
    let refused = |key: &str, found: &str| {
        Err(Error::invalid(key, format!("found {found} for the function \"{name}\", expected none: it has its own")))
    };
    if spec.options != PlannerSettings::default() {
        return refused("options", "options");
    }
    if spec.budget_ms.is_some() {
        return refused("budget_ms", "a time limit");
    }
    Ok(())
}

/// A rewinding mode, its name in tables, and its place in the sweep.
type Variant = ((String, Processing), Swept);

/// All combinations of a sweep, or the single rewinding mode of a method without one.
fn variants(spec: &MethodSpec, external: bool, planner: Planner, step: f64) -> Result<Vec<Variant>, Error> {
    let (post, repeats) = (post_of(spec, external, planner), repeats_of(spec));
    let sweep = spec.sweep.clone().unwrap_or_default();
    if spec.sweep.is_some() && sweep.step.is_empty() && sweep.post.is_empty() && sweep.repeats.is_empty() {
        return Err(Error::invalid("sweep", "found nothing to sweep, expected step, post or repeats"));
    }
    let or = |list: &[f64], one: f64| if list.is_empty() { vec![one] } else { list.to_vec() };
    let steps = or(&sweep.step, step);
    let posts = if sweep.post.is_empty() { vec![post] } else { sweep.post.clone() };
    let counts = if sweep.repeats.is_empty() { vec![repeats] } else { sweep.repeats.clone() };
    let digits = counts.iter().max().map_or(1, |most| most.to_string().len());
    let mut variants = Vec::new();
    for (step, post, repeats) in combinations(&steps, &posts, &counts) {
        let options = Post::named(&post)?.processing(step, repeats)?;
        let mut name = spec.name.clone();
        name += &if sweep.step.is_empty() { String::new() } else { format!(", step {step}") };
        name += &if sweep.post.is_empty() { String::new() } else { format!(", {post}") };
        name += &if sweep.repeats.is_empty() { String::new() } else { format!(", repeats {repeats:0digits$}") };
        let swept = Swept {
            of: spec.name.clone(),
            step: (!sweep.step.is_empty()).then_some(step),
            post: (!sweep.post.is_empty()).then_some(post),
            repeats: (!sweep.repeats.is_empty()).then_some(repeats),
        };
        variants.push(((name, options), swept));
    }
    Ok(variants)
}

fn combinations<'a>(
    steps: &'a [f64],
    posts: &'a [String],
    counts: &'a [usize],
) -> impl Iterator<Item = (f64, String, usize)> + 'a {
    let pairs = steps.iter().flat_map(move |step| posts.iter().map(move |post| (*step, post)));
    pairs.flat_map(move |(step, post)| counts.iter().map(move |count| (step, post.clone(), *count)))
}

fn chosen<T: Choice>(name: Option<&str>, default: T) -> Result<T, Error> {
    name.map_or(Ok(default), T::named)
}

fn each<T, U>(key: &str, list: &[T], check: impl Fn(&T) -> Result<U, Error>) -> Result<Vec<U>, Error> {
    if list.is_empty() {
        return Err(Error::invalid(key, "found none, expected at least one"));
    }
    list.iter().enumerate().map(|(k, one)| check(one).map_err(|e| e.under(&format!("{key}[{k}]")))).collect()
}

fn unique<'a>(key: &str, names: impl Iterator<Item = &'a str>) -> Result<(), Error> {
    let mut seen = std::collections::HashSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(Error::invalid(key, format!("found the name \"{name}\" twice, expected names to differ")));
        }
    }
    Ok(())
}

fn known<'a>(place: &str, what: &str, name: &str, names: impl Iterator<Item = &'a str> + Clone) -> Result<(), Error> {
    if names.clone().any(|known| known == name) {
        return Ok(());
    }
    let hint = nearest_name(name, names).map(|n| format!("; did you mean \"{n}\"?")).unwrap_or_default();
    Err(Error::invalid(place, format!("found \"{name}\", expected the name of a {what}{hint}")))
}

fn fingerprint(spec: &ExperimentSpec, scenarios: &[Scenario]) -> String {
    let of_scenario = |(scenario, spec): (&Scenario, &ScenarioSpec)| {
        let mut of = json!({"name": scenario.name, "scene": scenario.scene.spec()});
        if !scenario.route.is_plain() {
            of["route"] = json!([spec.via, spec.goals, spec.goal_box]); // absent otherwise, for fingerprints of older runs
        }
        of
    };
    let scenes: Vec<_> = scenarios.iter().zip(&spec.scenarios).map(of_scenario).collect();
    let random: Vec<_> = spec.scenarios.iter().map(|s| &s.random).collect();
    let mut rows = json!({"seed": spec.seed, "scenes": scenes, "random": random, "methods": spec.methods});
    if spec.history {
        rows["history"] = true.into(); // absent otherwise, so that fingerprints of older runs stay valid
    }
    let text = rows.to_string();
    fingerprint_of(&text)
}
