//! The planning query, and the observer of a search.

use std::sync::Arc;

use super::PlanOptions;
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Point, Pose, Rotation};
use crate::model::{Scene, body};
use crate::proof::Answer;
use crate::watch::{Watch, in_time};

/// A planning query: start and goal in a scene.
///
/// A scene file may contain a start and a goal; those of the query take precedence.
///
/// # Example
/// ```
/// use cdpr_core::Point;
/// use cdpr_core::{PlanOptions, Query, plan};
/// let scene = cdpr_core::testing::hard1();
/// let query = Query::from(&scene).to(Point::new(0.3, 1.0, 1.0)); // or `.starting_at(…)`
/// let found = plan(query, &PlanOptions::default(), &())?.result;
/// assert!((found.cost - 0.7).abs() < 1e-9); // nothing is in the way
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct Query<'a> {
    /// The robot and its environment.
    pub scene: &'a Scene,
    /// Start instead of the scene's, m.
    pub start: Option<Point>,
    /// Goal instead of the scene's, m.
    pub goal: Option<Point>,
    /// Orientations at start and goal instead of the scene's, for a platform that turns.
    pub orientations: [Option<Rotation>; 2],
    /// The scene as compiled earlier; the options' engine and interference rule are then ignored.
    pub compiled: Option<&'a Arc<CompiledScene>>,
    /// Whether there is a path, if that was decided earlier; planning then does not decide it again.
    pub answer: Option<&'a Answer>,
    /// A valid path from start to goal, m: the anytime planner looks for shorter ones, and it is the result if no planner finds one.
    pub known: Option<&'a [Point]>,
}

impl<'a> Query<'a> {
    /// From the scene's start to its goal.
    pub fn of(scene: &'a Scene) -> Self {
        Query { scene, start: None, goal: None, orientations: [None; 2], compiled: None, answer: None, known: None }
    }

    /// The query from another start, m.
    pub fn starting_at(self, start: Point) -> Self {
        Query { start: Some(start), ..self }
    }

    /// The query to another goal, m.
    pub fn to(self, goal: Point) -> Self {
        Query { goal: Some(goal), ..self }
    }

    /// The query from one pose to another.
    pub fn between(self, start: &Pose, goal: &Pose) -> Self {
        let turned = self.oriented([start, goal].map(|end| Some(end.orientation)));
        turned.starting_at(start.position).to(goal.position)
    }

    /// The query with other orientations at start and goal, as far as given.
    pub fn oriented(self, orientations: [Option<Rotation>; 2]) -> Self {
        Query { orientations, ..self }
    }

    /// Whether the platform may turn on its way.
    pub fn turns(&self) -> bool {
        let level = self.end_orientations().iter().all(|end| self.scene.has_orientation(end));
        self.scene.turning().is_some() || !level
    }

    fn end_orientations(&self) -> [Rotation; 2] {
        let [start, goal] = self.scene.end_orientations();
        [self.orientations[0].unwrap_or(start), self.orientations[1].unwrap_or(goal)]
    }

    /// Start and goal as poses.
    ///
    /// # Errors
    /// The errors of [`Query::ends`].
    pub fn poses(&self) -> Result<[Pose; 2], Error> {
        let ([start, goal], [at_start, at_goal]) = (self.ends()?, self.end_orientations());
        Ok([Pose::new(start, at_start), Pose::new(goal, at_goal)])
    }

    /// The query to a scene that was compiled earlier.
    pub fn by(self, compiled: &'a Arc<CompiledScene>) -> Self {
        Query { compiled: Some(compiled), ..self }
    }

    /// The scene as compiled earlier, or compiled as the options say; `None` if time runs out.
    pub(super) fn compile(&self, options: &PlanOptions, watch: &Watch) -> Result<Option<Arc<CompiledScene>>, Error> {
        match self.compiled {
            Some(compiled) => Ok(Some(compiled.clone())),
            None => {
                let compiled = CompiledScene::new(self.scene, options.engine, options.interference, watch);
                Ok(in_time(compiled)?.map(Arc::new))
            }
        }
    }

    /// Start and goal.
    ///
    /// # Errors
    /// A start or goal that is missing or not finite.
    pub fn ends(&self) -> Result<[Point; 2], Error> {
        Ok([end("start", self.start, self.scene.start())?, end("goal", self.goal, self.scene.goal())?])
    }
}

impl<'a> From<&'a Scene> for Query<'a> {
    fn from(scene: &'a Scene) -> Self {
        Query::of(scene)
    }
}

fn end(key: &str, given: Option<Point>, of_scene: Option<Point>) -> Result<Point, Error> {
    match given {
        Some(point) => body::point(key, point.into()),
        None => of_scene.ok_or_else(|| {
            let problem = format!("found none, expected a position; set query.{key} in the scene");
            Error::invalid(format!("query.{key}"), problem)
        }),
    }
}

/// Observes a search and can stop it. `()` does neither; a closure stops the search by returning true.
pub trait Observer: Sync {
    /// Whether to stop; polled often, from any thread.
    fn interrupted(&self) -> bool {
        false
    }

    /// A better path was found: seconds since the start, its length in m, its waypoints. Called on the thread that
    /// plans.
    fn improved(&self, _seconds: f64, _cost: f64, _path: &[Point]) {}
}

impl Observer for () {}

impl<F: Fn() -> bool + Sync> Observer for F {
    fn interrupted(&self) -> bool {
        self()
    }
}
