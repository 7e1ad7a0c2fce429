//! Answers requests, and keeps the engine of the last scene.

use std::sync::Arc;

use cdpr_core::batch::BatchOptions;
use cdpr_core::collision::{Engine, Interference, Validity, Violation, nearest_valid, worst_first};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Pose, rotation_as_written};
use cdpr_core::model::{QuerySpec, SceneSpec};
use cdpr_core::path_file::PathFile;
use cdpr_core::plan::{Appraisal, Observer, PlanOptions, Planned, Query, plan, replan};
use cdpr_core::tolerances::{PLACE_MARGIN, SAME_TURN};
use cdpr_core::watch::{TimeUnit, Watch, time_budget};
use cdpr_core::workspace::{ValidAt, WorkspaceOptions, workspace};
use cdpr_core::{Choice, Error, Scene};
use serde_json::{Value, json};
use web_time::Instant;

use super::request::{Ask, Options, Request};
use crate::{Contents, page_data};

/// Called with each better path during planning: its time in ms, cost in m and waypoints, as JSON.
pub type Improved = dyn Fn(&str) + Sync;

/// Answers one request after the other.
///
/// # Example
/// ```
/// use cdpr_view::live::Session;
/// let scene = serde_json::json!(cdpr_core::testing::hard1().spec());
/// let request = serde_json::json!({ "ask": "place", "scene": scene, "at": [1.0, 1.0, 1.0] });
/// let answer = Session::default().answer(&request.to_string(), &|_| ());
/// assert!(answer.contains("pillar"), "{answer}");
/// ```
#[derive(Default)]
pub struct Session {
    known: Option<Known>,
}

/// A scene with what was compiled for it.
struct Known {
    scene: Scene,
    compiled: Option<Compiled>,
    /// The scene of an earlier request, as compiled: while something is dragged, little differs.
    before: Option<Compiled>,
}

type Compiled = ((Engine, Interference), Arc<CompiledScene>);

impl Session {
    /// Answers a request; both are JSON. A request that cannot be answered gives `{"error": {"message", "key"}}`.
    pub fn answer(&mut self, request: &str, improved: &Improved) -> String {
        let answer = self
            .answered(request, improved)
            .unwrap_or_else(|error| json!({ "error": { "message": error.to_string(), "key": error.place() } }));
        answer.to_string()
    }

    fn answered(&mut self, request: &str, improved: &Improved) -> Result<Value, Error> {
        let problem = |e: serde_json::Error| Error::invalid("", format!("the request cannot be read: {e}"));
        let Request { scene, ask } = serde_json::from_str(request).map_err(problem)?;
        let known = self.known(scene)?;
        match ask {
            Ask::Plan { options, path, page, extras } => {
                known.plan((&options, path.as_deref()), page.then_some(extras), improved)
            }
            Ask::Page { path, extras } => Ok(
                json!({ "page": page_data(&known.scene, Contents { path: path.as_deref(), ..Contents::default() }, extras, &Watch::NONE)? }),
            ),
            Ask::Place { at, orientation } => known.place(at.into(), orientation),
            Ask::Workspace { budget_ms } => known.workspace(budget_ms),
            Ask::Toml => Ok(json!({ "toml": toml::to_string(known.scene.spec()).expect("scenes are finite") })),
        }
    }

    /// The scene of a request, with what was compiled for it.
    fn known(&mut self, spec: SceneSpec) -> Result<&mut Known, Error> {
        let ends = spec.query.clone().map(|query| [query.start, query.goal]).unwrap_or_default();
        let known = match self.known.take() {
            Some(known) if without_ends(known.scene.spec()) == without_ends(&spec) => {
                Known { scene: known.scene.between(ends)?, ..known }
            }
            known => {
                let before = known.and_then(|known| known.compiled.or(known.before));
                Known { scene: Scene::new(spec)?, compiled: None, before }
            }
        };
        Ok(self.known.insert(known))
    }
}

fn without_ends(spec: &SceneSpec) -> SceneSpec {
    let query = spec.query.clone().unwrap_or_default();
    SceneSpec { query: Some(QuerySpec { start: None, goal: None, ..query }), ..spec.clone() }
}

impl Known {
    fn plan(
        &mut self,
        (options, before): (&Options, Option<&PathFile>),
        page: Option<bool>,
        improved: &Improved,
    ) -> Result<Value, Error> {
        let options = PlanOptions::try_from(options)?;
        let (Planned { scene, result, .. }, appraisal, milliseconds) =
            self.planned(&options, before, page.is_some(), &Reporter(improved))?;
        let file = PathFile::planned(&scene, &options, &result, &appraisal).with_lower_bound(appraisal.lower_bound);
        let mut answer = json!({
            "status": result.status.name(),
            "cost": file.cost,
            "waypoints": file.waypoints,
            "milliseconds": milliseconds,
            "path": file,
        });
        if let Some(extras) = page {
            answer["page"] = page_data(&scene, Contents::from(&file), extras, &Watch::NONE)?;
        }
        Ok(answer)
    }

    /// A planned path, which keeps what it can of a path `before`; its appraisal (with a lower bound if `bounded`), and how long
    /// planning took, ms.
    fn planned(
        &mut self,
        options: &PlanOptions,
        before: Option<&PathFile>,
        bounded: bool,
        observer: &dyn Observer,
    ) -> Result<(Planned, Appraisal, f64), Error> {
        let clock = Instant::now();
        let milliseconds = || 1e3 * clock.elapsed().as_secs_f64();
        let watch = options.watch(&|| false);
        let compiled = match self.scene.orientation_is_open() {
            true => None,
            false => Some(self.compiled((options.engine, options.interference))?),
        };
        let query = Query { compiled: compiled.as_ref(), ..Query::of(&self.scene) };
        let planned = match before.map(|before| self.between_the_ends(before)).transpose()?.flatten() {
            Some(before) => replan(query, &before, options, observer)?,
            None => plan(query, options, observer)?,
        };
        let milliseconds = milliseconds();
        let appraisal = planned.appraise(bounded, &watch)?;
        Ok((planned, appraisal, milliseconds))
    }

    /// The poses of a path, if it leads from the start to the goal of the scene.
    fn between_the_ends(&self, path: &PathFile) -> Result<Option<Vec<Pose>>, Error> {
        let poses = path.path(&self.scene)?;
        let ends = Query::of(&self.scene).poses()?;
        let known = !self.scene.orientation_is_open() && poses.len() > 1;
        let same = |a: &Pose, b: &Pose| a.position == b.position && a.angle_to(b) <= SAME_TURN;
        Ok(Some(poses).filter(|poses| known && same(&poses[0], &ends[0]) && same(&poses[poses.len() - 1], &ends[1])))
    }

    /// The scene, compiled for an engine.
    fn compiled(&mut self, wanted: (Engine, Interference)) -> Result<Arc<CompiledScene>, Error> {
        match &self.compiled {
            Some((known, compiled)) if *known == wanted => Ok(compiled.clone()),
            _ => {
                let compiled = match &self.before {
                    Some((known, before)) if *known == wanted => before.recompiled(&self.scene, &Watch::NONE)?,
                    _ => CompiledScene::new(&self.scene, wanted.0, wanted.1, &Watch::NONE)?,
                };
                Ok(self.compiled.insert((wanted, Arc::new(compiled))).1.clone())
            }
        }
    }

    /// The violations at a position, at the orientation of the scene or, if the platform may turn, at another one; and
    /// a valid position nearby.
    fn place(&mut self, at: Point, orientation: Option<[f64; 4]>) -> Result<Value, Error> {
        let compiled = self.compiled(Default::default())?;
        let turn = orientation.filter(|_| Query::of(&self.scene).turns());
        let turn = turn.map_or(*self.scene.orientation(), rotation_as_written);
        let pose = Pose::new(at, turn);
        compiled.ready_for(&[pose])?;
        let valid = |position: &Point| compiled.state_valid(&Pose::new(*position, turn));
        let nearest = || nearest_valid(compiled.conditions().position_box(), &at, PLACE_MARGIN, valid, &Watch::NONE);
        placed(compiled.violations(&pose, &pose), nearest)
    }

    /// Where the platform can be, as on the page of `cdpr workspace`, and how long that took, ms.
    fn workspace(&mut self, budget_ms: f64) -> Result<Value, Error> {
        let clock = Instant::now();
        let budget = time_budget("budget_ms", budget_ms, TimeUnit::Millisecond)?;
        let compiled = match self.scene.orientation_is_open() {
            false => vec![self.compiled(Default::default())?],
            true => {
                let at =
                    |scene: &Scene| CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE);
                self.scene.choices().iter().map(|scene| at(scene).map(Arc::new)).collect::<Result<_, _>>()?
            }
        };
        let options = WorkspaceOptions { resolution: None, valid_at: ValidAt::Any };
        let compiled: Vec<&CompiledScene> = compiled.iter().map(Arc::as_ref).collect();
        let watch = Watch::NONE.with_budget(Some(budget));
        let found = workspace(&compiled, &options, &BatchOptions { threads: None, watch })?;
        let shown = crate::workspace::shown(&found)?;
        Ok(json!({ "proved": shown, "decided": found.decided, "milliseconds": 1e3 * clock.elapsed().as_secs_f64() }))
    }
}

fn placed(violations: Vec<Violation>, nearest: impl FnOnce() -> Result<Option<Point>, Error>) -> Result<Value, Error> {
    let violations = worst_first(violations);
    let nearest = if violations.is_empty() { None } else { nearest()?.map(<[f64; 3]>::from) };
    Ok(json!({ "violation": violations.first(), "violations": violations, "nearest": nearest }))
}

/// Tells the page of better paths.
struct Reporter<'a>(&'a Improved);

impl Observer for Reporter<'_> {
    fn improved(&self, seconds: f64, cost: f64, path: &[Point]) {
        let waypoints: Vec<[f64; 3]> = path.iter().map(|position| (*position).into()).collect();
        (self.0)(&json!({ "milliseconds": 1e3 * seconds, "cost": cost, "waypoints": waypoints }).to_string());
    }
}
