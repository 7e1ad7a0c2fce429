//! The planning query, its result, and the observer of a search.

use super::PlanResult;
use crate::collision::Checker;
use crate::error::Error;
use crate::geometry::Point;
use crate::model::{Scene, body};
use crate::proof::Answer;

/// A planning query: start and goal in a scene.
///
/// A scene file may contain a start and a goal; those of the query take precedence.
///
/// # Example
/// ```
/// use cdpr_core::geometry::Point;
/// use cdpr_core::plan::{PlanOptions, Query, plan};
/// let scene = cdpr_core::testing::hard1();
/// let query = Query::of(&scene).to(Point::new(0.3, 1.0, 1.0));
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
    /// An engine compiled earlier from the scene; the options' engine and interference rule are then ignored.
    pub engine: Option<&'a dyn Checker>,
    /// Whether there is a path, if that was decided earlier with this engine; planning then does not decide it again.
    pub answer: Option<&'a Answer>,
}

impl<'a> Query<'a> {
    /// From the scene's start to its goal.
    pub fn of(scene: &'a Scene) -> Self {
        Query { scene, start: None, goal: None, engine: None, answer: None }
    }

    /// The same from another start, m.
    pub fn from(self, start: Point) -> Self {
        Query { start: Some(start), ..self }
    }

    /// The same to another goal, m.
    pub fn to(self, goal: Point) -> Self {
        Query { goal: Some(goal), ..self }
    }

    /// The same, using an engine compiled earlier from the scene.
    pub fn by(self, engine: &'a dyn Checker) -> Self {
        Query { engine: Some(engine), ..self }
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

/// The result of planning.
pub struct Planned {
    /// The scene at the orientation with the shortest path, if the scene selected none.
    pub turned: Option<Scene>,
    /// The engine that was compiled; `None` if the query provided one or time ran out first.
    pub engine: Option<Box<dyn Checker>>,
    /// The result; counts and times include all orientations.
    pub result: PlanResult,
}

impl std::fmt::Debug for Planned {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Planned").field("turned", &self.turned).field("result", &self.result).finish_non_exhaustive()
    }
}
