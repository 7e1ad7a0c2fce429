//! Random scenes: upright prisms that leave start and goal free (the paper, section 5 and Table 1).

use std::collections::HashSet;
use std::sync::Arc;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use cdpr_core::collision::{Engine, GjkEngine, Interference, Validity};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::error::Error;
use cdpr_core::geometry::{Aabb, Point};
use cdpr_core::limits::MOST_BODIES;
use cdpr_core::model::spec::{BodySpec, WorkspaceSpec};
use cdpr_core::model::{Scene, body};
use cdpr_core::plan::{Query, Route};
use cdpr_core::watch::Watch;

/// Random prisms to add to a scene. The defaults are the paper's: square, 0.1 to 0.3 m wide, 0.5 to 1.5 m high, on the
/// floor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RandomScenesSpec {
    /// Number of prisms.
    pub count: usize,
    /// If given, the number of prisms is random, from `count` to this number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub count_up_to: Option<usize>,
    /// Minimum and maximum width along x, m.
    #[serde(default = "paper_width")]
    pub width: [f64; 2],
    /// Minimum and maximum width along y, m; default: the same width as along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<[f64; 2]>,
    /// Minimum and maximum height, m.
    #[serde(default = "paper_height")]
    pub height: [f64; 2],
    /// The box that contains all prisms; default the workspace.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<WorkspaceSpec>,
    /// Place prisms anywhere in the region instead of on its floor.
    #[serde(default)]
    pub floating: bool,
    /// Rotate prisms about the vertical by random angles instead of aligning them with the axes.
    #[serde(default)]
    pub turned: bool,
    /// Redraw scenes in which the straight line from start to goal is free.
    #[serde(default)]
    pub redraw_straight: bool,
    /// Maximum number of draws of one prism, and of a whole scene.
    #[serde(default = "many")]
    pub attempts: usize,
}

fn paper_width() -> [f64; 2] {
    [0.1, 0.3]
}

fn paper_height() -> [f64; 2] {
    [0.5, 1.5]
}

fn many() -> usize {
    10_000
}

/// Draws scenes based on a given one, whose robot, workspace, query and obstacles are kept.
#[derive(Debug, Clone)]
pub struct RandomScenes {
    base: Scene,
    spec: RandomScenesSpec,
    region: Aabb,
    route: Route,
}

impl RandomScenes {
    /// Checks the specification.
    ///
    /// # Errors
    /// A size that is not an interval or does not fit into the region; a base scene without a query, or whose start or
    /// goal is not valid. The error names the key.
    ///
    /// # Example
    /// ```
    /// use cdpr_study::{RandomScenes, RandomScenesSpec};
    /// let spec: RandomScenesSpec = serde_json::from_str(r#"{"count": 3}"#).unwrap();
    /// let scenes = RandomScenes::new(cdpr_core::testing::empty(), spec)?;
    /// assert_eq!(scenes.draw(7)?.obstacles().len(), 3);
    /// assert_eq!(scenes.draw(7)?, scenes.draw(7)?);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn new(base: Scene, spec: RandomScenesSpec) -> Result<Self, Error> {
        RandomScenes::along(base, spec, &Route::default())
    }

    /// Scenes that also leave via points and goals free. In a box of goals, no position is kept free.
    ///
    /// # Errors
    /// The errors of [`RandomScenes::new`] and of [`Route::stops`]; a box of goals with `redraw_straight`.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::plan::Route;
    /// use cdpr_study::{RandomScenes, RandomScenesSpec};
    /// let spec: RandomScenesSpec = serde_json::from_str(r#"{"count": 3}"#).unwrap();
    /// let route = Route { via: vec![[1.0, 1.0, 1.5].into()], ..Route::default() };
    /// assert_eq!(RandomScenes::along(cdpr_core::testing::empty(), spec, &route)?.draw(7)?.obstacles().len(), 3);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn along(base: Scene, spec: RandomScenesSpec, route: &Route) -> Result<Self, Error> {
        let given = |key: &str, end: Option<Point>| {
            end.ok_or_else(|| Error::invalid("scene", format!("found no query.{key}, expected one")))
        };
        given("start", base.start())?;
        if route.goals.is_empty() && route.goal_box.is_none() {
            given("goal", base.goal())?;
        }
        if spec.redraw_straight && route.goal_box.is_some() {
            let problem = "found with a box of goals, to which there are many straight lines; expected one of the two";
            return Err(Error::invalid("redraw_straight", problem));
        }
        let region = match &spec.region {
            Some(region) => {
                Aabb { min: body::point("region.min", region.min)?, max: body::point("region.max", region.max)? }
            }
            None => *base.workspace(),
        };
        check_sizes(&spec, &region)?;
        let scenes = RandomScenes { base, spec, region, route: route.clone() };
        match scenes.obstruction(&scenes.base)? {
            Some(problem) => Err(Error::invalid("scene", format!("{problem}, even before obstacles are drawn"))),
            None => Ok(scenes),
        }
    }

    /// The scene for a seed. A prism that collides with the platform or a cable at start or goal is drawn again.
    ///
    /// # Errors
    /// No free scene within the allowed number of attempts; the error gives the reason of the last failure.
    pub fn draw(&self, seed: u64) -> Result<Scene, Error> {
        self.draw_within(seed, &Watch::NONE)
    }

    /// The scene for a seed, drawn within a watch; see [`RandomScenes::draw`].
    ///
    /// # Errors
    /// The errors of [`RandomScenes::draw`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn draw_within(&self, seed: u64, watch: &Watch) -> Result<Scene, Error> {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut reason = String::new();
        for _ in 0..self.spec.attempts {
            let scene = self.draw_once(&mut rng, watch)?;
            reason = match self.obstruction(&scene)? {
                Some(problem) => problem,
                None if self.spec.redraw_straight && self.straight_line_solves(&scene)? => {
                    "the straight line from start to goal is free".to_string()
                }
                None => return Ok(scene),
            };
        }
        Err(self.given_up(&reason))
    }

    fn draw_once(&self, rng: &mut ChaCha8Rng, watch: &Watch) -> Result<Scene, Error> {
        let most = self.spec.count_up_to.unwrap_or(self.spec.count);
        let count = if most > self.spec.count { rng.random_range(self.spec.count..=most) } else { self.spec.count };
        let mut spec = self.base.spec().clone();
        for name in self.free_names().take(count) {
            spec.obstacles.push(self.free_prism(name, rng, watch)?);
        }
        Scene::new(spec)
    }

    /// A prism that leaves start, via points and goals free.
    fn free_prism(&self, name: String, rng: &mut ChaCha8Rng, watch: &Watch) -> Result<BodySpec, Error> {
        let mut reason = String::new();
        for _ in 0..self.spec.attempts {
            watch.check()?;
            let prism = self.prism(name.clone(), rng);
            let mut alone = self.base.spec().clone();
            alone.obstacles = vec![prism.clone()];
            alone.ignore.retain(|pair| pair.iter().all(|name| self.base.obstacles().iter().all(|o| o.name != *name)));
            alone.wrench = None;
            match Scene::new(alone) {
                Err(problem) => reason = problem.to_string(), // such as an outlet inside the prism
                Ok(scene) => match self.obstruction(&scene)? {
                    Some(problem) => reason = problem,
                    None => return Ok(prism),
                },
            }
        }
        Err(self.given_up(&reason))
    }

    fn prism(&self, name: String, rng: &mut ChaCha8Rng) -> BodySpec {
        let mut number = |[least, largest]: [f64; 2]| least + (largest - least) * rng.random::<f64>();
        let width = number(self.spec.width);
        let depth = self.spec.depth.map_or(width, &mut number);
        let height = number(self.spec.height);
        let yaw = if self.spec.turned { number([0.0, std::f64::consts::TAU]) } else { 0.0 };
        let (sine, cosine) = (yaw.sin().abs(), yaw.cos().abs());
        let extents = [width * cosine + depth * sine, width * sine + depth * cosine, height];
        let mut position: [f64; 3] = std::array::from_fn(|axis| {
            let half = 0.5 * extents[axis];
            number([self.region.min[axis] + half, self.region.max[axis] - half])
        });
        if !self.spec.floating {
            position[2] = self.region.min.z + 0.5 * height;
        }
        BodySpec {
            name: Some(name),
            cuboid: Some([width, depth, height]),
            position: Some(position),
            rpy: self.spec.turned.then_some([0.0, 0.0, yaw]),
            ..BodySpec::default()
        }
    }

    /// Names that no obstacle of the base has.
    fn free_names(&self) -> impl Iterator<Item = String> {
        let taken: HashSet<_> =
            self.base.spec().obstacles.iter().filter_map(|obstacle| obstacle.name.as_deref()).collect();
        (0..).map(|number| format!("prism {number}")).filter(move |name| !taken.contains(name.as_str()))
    }

    /// Why start, a via point or a goal is not valid.
    fn obstruction(&self, scene: &Scene) -> Result<Option<String>, Error> {
        let compiled = CompiledScene::new(scene, Engine::Gjk, Interference::Exact, &Watch::NONE)?;
        for (goal, stops) in self.route.stops(&Query::of(scene))?.iter().enumerate() {
            compiled.ready_for(stops)?;
            if let Some(at) = stops.iter().position(|stop| !compiled.state_valid(stop)) {
                let reason = compiled.explain(&stops[at], &stops[at]);
                let reason = reason.map_or(String::new(), |violation| format!(": {}", violation.sentence()));
                return Ok(Some(format!("{} is not valid{reason}", self.stop_name(at, goal))));
            }
        }
        Ok(None)
    }

    fn stop_name(&self, at: usize, goal: usize) -> String {
        match at.checked_sub(1) {
            None => "the start".to_string(),
            Some(via) if via < self.route.via.len() => format!("via point {}", via + 1),
            Some(_) if self.route.goals.len() > 1 => format!("goal {}", goal + 1),
            Some(_) => "the goal".to_string(),
        }
    }

    fn straight_line_solves(&self, scene: &Scene) -> Result<bool, Error> {
        let geometry = GjkEngine::new(scene, Interference::Exact)?; // without the wrenches that the scene requires
        let compiled = CompiledScene::with(scene, Arc::new(geometry));
        for stops in self.route.stops(&Query::of(scene))? {
            compiled.ready_for(&stops)?;
            if stops.windows(2).all(|ends| compiled.motion_valid(&ends[0], &ends[1])) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn given_up(&self, reason: &str) -> Error {
        let problem = format!("found no free scene in {} draws; the last one failed: {reason}", self.spec.attempts);
        Error::invalid("random", problem)
    }
}

fn check_sizes(spec: &RandomScenesSpec, region: &Aabb) -> Result<(), Error> {
    body::at_most("count", spec.count, MOST_BODIES)?;
    body::at_most("count_up_to", spec.count_up_to.unwrap_or(0), MOST_BODIES)?;
    let size = region.max - region.min;
    let depth = spec.depth.unwrap_or(spec.width);
    let across = if spec.turned { spec.width[1].hypot(depth[1]) } else { 0.0 };
    let rooms =
        [("width", spec.width, across, size.x), ("depth", depth, across, size.y), ("height", spec.height, 0.0, size.z)];
    for (key, [least, largest], turned, room) in rooms {
        if !(least > 0.0 && least <= largest && largest.max(turned) <= room) {
            let problem = format!(
                "found [{least}, {largest}] m, expected [least, largest] with 0 < least <= largest, and room in the \
                 region ({room} m)"
            );
            return Err(Error::invalid(key, problem));
        }
    }
    match spec.count_up_to.filter(|most| *most < spec.count) {
        Some(most) => {
            Err(Error::invalid("count_up_to", format!("found {most}, expected at least count ({})", spec.count)))
        }
        None => Ok(()),
    }
}
