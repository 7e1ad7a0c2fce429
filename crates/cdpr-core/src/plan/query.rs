//! The planning query, its result, and the observer of a search.

use std::sync::Arc;

use super::{Appraisal, PlanOptions, PlanResult, appraise, appraise_turning, engine_within};
use crate::collision::Checker;
use crate::error::Error;
use crate::geometry::{Point, Pose, Rotation};
use crate::lower_bound::{Accepts, Certificate, Forbidden};
use crate::model::{Scene, body};
use crate::proof::Answer;
use crate::turning::TurningEngine;
use crate::watch::{Watch, in_time};

/// A planning query: start and goal in a scene.
///
/// A scene file may contain a start and a goal; those of the query take precedence.
///
/// # Example
/// ```
/// use cdpr_core::geometry::Point;
/// use cdpr_core::plan::{PlanOptions, Query, plan};
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
    /// An engine compiled earlier from the scene; the options' engine and interference rule are then ignored.
    pub engine: Option<&'a Arc<dyn Checker>>,
    /// Whether there is a path, if that was decided earlier with this engine; planning then does not decide it again.
    pub answer: Option<&'a Answer>,
}

impl<'a> Query<'a> {
    /// From the scene's start to its goal.
    pub fn of(scene: &'a Scene) -> Self {
        Query { scene, start: None, goal: None, orientations: [None; 2], engine: None, answer: None }
    }

    /// The same from another start, m.
    pub fn starting_at(self, start: Point) -> Self {
        Query { start: Some(start), ..self }
    }

    /// The same to another goal, m.
    pub fn to(self, goal: Point) -> Self {
        Query { goal: Some(goal), ..self }
    }

    /// The same with other orientations at start and goal, as far as given.
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
    /// As [`Query::ends`].
    pub fn poses(&self) -> Result<[Pose; 2], Error> {
        let ([start, goal], [at_start, at_goal]) = (self.ends()?, self.end_orientations());
        Ok([Pose::new(start, at_start), Pose::new(goal, at_goal)])
    }

    /// The query with an engine compiled earlier from the scene, also where the platform turns.
    pub fn by(self, engine: &'a Arc<dyn Checker>) -> Self {
        Query { engine: Some(engine), ..self }
    }

    /// The engine of the query, or the one that is compiled as the options say; `None` if time runs out.
    pub(super) fn compiled(&self, options: &PlanOptions, watch: &Watch) -> Result<Option<Arc<dyn Checker>>, Error> {
        match self.engine {
            Some(engine) => Ok(Some(engine.clone())),
            None => in_time(engine_within(self.scene, options.engine, options.interference, watch)),
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

/// The result of planning.
pub struct Planned {
    /// The scene at the orientation with the shortest path, if the scene selected none.
    pub turned: Option<Scene>,
    /// The engine of the query, or the one that was compiled; `None` if the platform may turn, or time ran out first.
    pub engine: Option<Arc<dyn Checker>>,
    /// The engine for motions from pose to pose if the platform may turn.
    pub turning: Option<TurningEngine>,
    /// The result; counts and times are those of all searches: at each orientation, with turns and without.
    pub result: PlanResult,
}

impl Planned {
    /// A result without an engine.
    pub(super) fn without_engine(result: PlanResult) -> Self {
        Planned { turned: None, engine: None, turning: None, result }
    }

    /// The result if time ran out before there was an engine.
    pub(super) fn out_of_time() -> Self {
        Planned::without_engine(PlanResult::out_of_time())
    }

    /// A result for a platform that may turn.
    pub(super) fn turning(engine: TurningEngine, result: PlanResult) -> Self {
        Planned { turning: Some(engine), ..Planned::without_engine(result) }
    }

    /// A certificate that no path of the scene (that of the query or [`Planned::turned`]) is shorter than a length, m, or than a
    /// smaller one that can be proved and that a checker `accepts`. `None` if the checker accepts nothing, if there is no path,
    /// or if the platform may turn.
    ///
    /// # Errors
    /// As [`Forbidden::accepted_certificate`].
    pub fn bound_certificate(
        &self,
        scene: &Scene,
        length: f64,
        accepts: &Accepts,
        watch: &Watch,
    ) -> Result<Option<Certificate>, Error> {
        let (Some(engine), [start, .., goal]) = (&self.engine, &self.result.waypoints[..]) else { return Ok(None) };
        let Some(forbidden) = in_time(Forbidden::new(&**engine, [start, goal], watch))? else { return Ok(None) };
        forbidden.accepted_certificate(scene, length, accepts, watch)
    }

    /// Measures the path that was found in the scene, which is that of the query or [`Planned::turned`].
    ///
    /// # Errors
    /// As [`appraise`].
    pub fn appraise(&self, scene: &Scene, bounded: bool, watch: &Watch) -> Result<Appraisal, Error> {
        match (&self.turning, &self.engine) {
            (Some(turning), _) if !self.result.orientations.is_empty() => {
                appraise_turning(scene, turning, &self.result, watch)
            }
            (Some(turning), _) => appraise(scene, turning.level(), &self.result, false, watch),
            (None, Some(engine)) => appraise(scene, &**engine, &self.result, bounded, watch),
            (None, None) => Ok(Appraisal::default()),
        }
    }

    /// The engine that checks motions at the orientation of the scene, if one was compiled.
    pub fn checker(&self) -> Option<&dyn Checker> {
        self.engine.as_deref().or_else(|| self.turning.as_ref().map(TurningEngine::level))
    }
}

impl std::fmt::Debug for Planned {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Planned").field("turned", &self.turned).field("result", &self.result).finish_non_exhaustive()
    }
}
