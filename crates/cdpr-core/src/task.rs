//! Tasks: a way through stations on which the platform picks payloads and sets them down.
//!
//! A task consists of legs, each from one stop to the next. On a leg, the scene is the one that holds then: what is carried is a part of
//! the platform, everything else stands where it was set down last. Where a leg ends is known in advance, so legs are planned
//! independently of each other, in parallel, and one without a path does not keep the others from being planned.
//!
//! Where a payload is picked or placed, bodies are in contact: the platform touches the payload that stands, and the platform with the
//! payload touches what it stands on. No clearance is required of these pairs, on the legs that begin or end there only: they may touch,
//! and never overlap. A payload stands on the obstacles that it touches. While it is carried it is a part of the platform, so the
//! clearance is waived for the platform as a whole.

mod task_file;
mod task_motion;

use crate::batch::{Told, each_long};
use crate::error::Error;
use crate::geometry::{Pose, wxyz};
use crate::model::spec::PLATFORM;
use crate::model::{Action, Scene, Stop, Stops};
use crate::path_file::PathFile;
use crate::plan::{PlanOptions, PlanResult, Planned, Query, plan, plan_through};
use crate::planning::Status;
use crate::tolerances::{SAME_POINT, SAME_TURN};
use crate::watch::{Interrupt, Watch};

pub use task_file::{
    ActionKeys, LegKeys, LegMotionKeys, PlaceKeys, TASK_FORMAT, TaskFile, TaskNames, TimedActionKeys, WholeMotionKeys,
};
pub use task_motion::{TaskMotion, TaskTiming, WholeMotion};

/// A pose of the platform where a leg begins or ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// The station or payload there, if it was named.
    pub name: Option<String>,
    /// The pose.
    pub pose: Pose,
}

/// The way from one stop to the next, and the scene that holds on it.
#[derive(Debug, Clone, PartialEq)]
pub struct TaskLeg {
    /// Where it begins.
    pub from: Place,
    /// Where it ends.
    pub to: Place,
    /// What it passes without a stop.
    pub via: Vec<Pose>,
    /// What is picked and placed where it begins, before.
    pub before: Vec<Action>,
    /// Where each payload stands; `None` for those that are carried.
    pub stands: Vec<Option<Pose>>,
    /// Pairs that may touch on this leg.
    pub touch: Vec<[String; 2]>,
    /// The scene, with the ends of the leg as its start and goal.
    pub scene: Scene,
}

/// The legs of a task.
#[derive(Debug, Clone, PartialEq)]
pub struct TaskLegs {
    /// The legs, in order.
    pub legs: Vec<TaskLeg>,
    /// What is picked and placed at the end.
    pub after: Vec<Action>,
}

/// The answer to a leg.
#[derive(Debug, Clone)]
pub struct LegPlan {
    /// How planning ended.
    pub status: Status,
    /// Why there is no path, if there is none.
    pub reason: Option<String>,
    /// Length of the path, m; infinite without one.
    pub cost: f64,
    /// The path; empty without one.
    pub path: Vec<Pose>,
    /// The answer as a path file of the leg's scene.
    pub file: PathFile,
}

/// A planned task.
#[derive(Debug, Clone)]
pub struct Task {
    /// The legs of the task.
    pub legs: TaskLegs,
    /// The answer to each of them.
    pub plans: Vec<LegPlan>,
    /// The motions of the legs, if they were timed.
    pub motion: Option<TaskMotion>,
}

impl Task {
    /// [`Status::Solved`] if all legs have paths, else the status of the first one that has none.
    pub fn status(&self) -> Status {
        let unsolved = self.plans.iter().find(|plan| plan.status != Status::Solved);
        unsolved.map_or(Status::Solved, |plan| plan.status)
    }

    /// Length of all paths, m; infinite if a leg has none.
    pub fn cost(&self) -> f64 {
        self.plans.iter().map(|plan| plan.cost).sum()
    }
}

impl TaskLegs {
    /// The legs of the scene's task.
    ///
    /// # Errors
    /// A scene without a task, or payloads that cannot be carried together.
    pub fn of(scene: &Scene) -> Result<Self, Error> {
        let missing = || Error::invalid("task", "found none, expected rows with go, via, pick or place");
        Self::through(scene, scene.task().ok_or_else(missing)?)
    }

    /// The legs through these stops.
    ///
    /// # Errors
    /// Payloads that cannot be carried together.
    pub fn through(scene: &Scene, stops: &Stops) -> Result<Self, Error> {
        let mut cell = Cell::new(scene, stops);
        for (k, stop) in stops.stops.iter().enumerate() {
            if cell.here.pose != stop.pose || !stop.via.is_empty() {
                cell.leave(stop, &still(&stops.stops[k..]))?;
            }
            cell.act(stop)?;
        }
        Ok(TaskLegs { legs: cell.legs, after: cell.before })
    }
}

/// What is done at the first of these stops, and at those after it without a motion between.
fn still(stops: &[Stop]) -> Vec<Action> {
    let there = |other: &&Stop| other.pose == stops[0].pose && other.via.is_empty();
    let later = stops[1..].iter().take_while(there);
    stops[..1].iter().chain(later).filter_map(|stop| stop.action).collect()
}

/// A cell at one moment of a task.
struct Cell<'a> {
    scene: &'a Scene,
    here: Place,
    stands: Vec<Option<Pose>>,
    /// What was picked and placed here.
    before: Vec<Action>,
    /// The contacts of that.
    touch: Vec<[String; 2]>,
    legs: Vec<TaskLeg>,
}

impl<'a> Cell<'a> {
    fn new(scene: &'a Scene, stops: &Stops) -> Self {
        let here = Place { name: stops.start_name.clone(), pose: stops.start };
        let stands = scene.payloads().iter().map(|payload| payload.stands).collect();
        Cell { scene, here, stands, before: Vec::new(), touch: Vec::new(), legs: Vec::new() }
    }

    /// Adds the leg to a stop, where these actions follow.
    fn leave(&mut self, stop: &Stop, then: &[Action]) -> Result<(), Error> {
        let mut touch = std::mem::take(&mut self.touch);
        for action in then {
            touch.extend(match *action {
                Action::Pick(k) => vec![self.with_platform(&self.scene.payloads()[k].name)],
                Action::Place(k) => self.ground(k, &stop.pose)?,
            });
        }
        let to = Place { name: stop.name.clone(), pose: stop.pose };
        let from = std::mem::replace(&mut self.here, to.clone());
        self.legs.push(TaskLeg {
            scene: scene_of_leg(self.scene.arranged(&self.stands, &touch)?, [from.pose, to.pose])?,
            from,
            to,
            via: stop.via.clone(),
            before: std::mem::take(&mut self.before),
            stands: self.stands.clone(),
            touch,
        });
        Ok(())
    }

    /// Does what is to be done at a stop.
    fn act(&mut self, stop: &Stop) -> Result<(), Error> {
        let Some(action) = stop.action else { return Ok(()) };
        match action {
            Action::Pick(k) => {
                let ground = self.ground(k, &stop.pose)?;
                self.touch.extend(ground);
                self.stands[k] = None;
            }
            Action::Place(k) => {
                self.touch.push(self.with_platform(&self.scene.payloads()[k].name));
                self.stands[k] = Some(stop.pose);
            }
        }
        self.before.push(action);
        Ok(())
    }

    /// What a payload stands on at a pose, each with the platform that carries it.
    fn ground(&self, payload: usize, pose: &Pose) -> Result<Vec<[String; 2]>, Error> {
        let now = self.scene.arranged(&self.stands, &[])?;
        let names = now.touched_by(&self.scene.payloads()[payload], pose);
        Ok(names.iter().map(|name| self.with_platform(name)).collect())
    }

    fn with_platform(&self, name: &str) -> [String; 2] {
        [PLATFORM.to_string(), name.to_string()]
    }
}

/// The scene of a leg: if the platform does not turn on it, at the orientation of its ends.
fn scene_of_leg(scene: Scene, ends: [Pose; 2]) -> Result<Scene, Error> {
    let [first, last] = &ends;
    let level = scene.turning().is_none() && first.orientation == last.orientation;
    let other = level && !scene.has_orientation(&first.orientation);
    let scene =
        if other || scene.orientation_is_open() { scene.turned(wxyz(&first.orientation).into())? } else { scene };
    scene.with_ends(ends)
}

/// Whether two poses are equal up to rounding errors.
pub fn same_pose(a: &Pose, b: &Pose) -> bool {
    (a.position - b.position).norm() <= SAME_POINT && a.angle_to(b) <= SAME_TURN
}

fn words(pose: &Pose) -> String {
    format!("{:?} at {:?}", <[f64; 3]>::from(pose.position), wxyz(&pose.orientation))
}

/// Plans every leg of the scene's task. `told` is called with the number of planned legs and that of all legs.
///
/// An interrupt ends each search with its best path so far, or the status "interrupted".
///
/// # Errors
/// The errors of [`TaskLegs::of`] and [`plan`].
///
/// # Example
/// ```
/// use cdpr_core::model::{BodySpec, PayloadSpec, Scene, SceneSpec, TaskRowSpec};
/// use cdpr_core::{PlanOptions, Status, task::plan_task};
/// let body = BodySpec { cuboid: Some([0.1; 3]), position: Some([0.0, 0.0, -0.1]), ..BodySpec::default() };
/// let (name, at) = ("crate".to_string(), Some([1.7, 1.0, 0.3].into()));
/// let payload = PayloadSpec { name: name.clone(), body: vec![body], mass: 2.0, at, ..PayloadSpec::default() };
/// let task = vec![
///     TaskRowSpec { pick: Some(name.clone()), ..TaskRowSpec::default() },
///     TaskRowSpec { go: Some([1.7, 1.0, 1.0].into()), ..TaskRowSpec::default() },
///     TaskRowSpec { place: Some(name), ..TaskRowSpec::default() },
/// ];
/// let scene = Scene::new(SceneSpec { payloads: vec![payload], task, ..cdpr_core::testing::hard1().spec().clone() })?;
/// let task = plan_task(&scene, &PlanOptions::default(), None, &|| false, &|_, _| ())?;
/// assert_eq!((task.status(), task.plans.len()), (Status::Solved, 2));
/// assert!((task.plans[1].cost - 0.7).abs() < 1e-9);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan_task(
    scene: &Scene,
    options: &PlanOptions,
    threads: Option<usize>,
    stop: &Interrupt,
    told: &Told,
) -> Result<Task, Error> {
    let legs = TaskLegs::of(scene)?;
    let plans = each_long(legs.legs.len(), threads, told, &|k| {
        planned(&legs.legs[k], options, stop).map_err(|e| e.under(&format!("legs[{k}]")))
    })?;
    Ok(Task { legs, plans, motion: None })
}

fn planned(leg: &TaskLeg, options: &PlanOptions, stop: &Interrupt) -> Result<LegPlan, Error> {
    let query = Query::of(&leg.scene).between(&leg.from.pose, &leg.to.pose);
    let found = match leg.via.is_empty() {
        true => plan(query, options, &|| stop())?,
        false => plan_through(query, &leg.via, options, &|| stop(), true)?,
    };
    if found.result.status != Status::Solved {
        return unsolved(leg, options, &found);
    }
    let appraisal = found.appraise(true, &options.watch(stop))?;
    let file = PathFile::planned(&leg.scene, options, &found.result, &appraisal);
    let file = file.with_lower_bound(appraisal.lower_bound);
    let PlanResult { cost, path, .. } = found.result;
    Ok(LegPlan { status: Status::Solved, reason: None, cost, path, file })
}

/// The answer to a leg without a path.
fn unsolved(leg: &TaskLeg, options: &PlanOptions, found: &Planned) -> Result<LegPlan, Error> {
    let result = &found.result;
    let appraisal = found.appraise(false, &Watch::NONE)?;
    let part = result.route.as_ref().and_then(|route| route.leg);
    let of_part = |reason: String| match (result.status, part) {
        (_, None) => reason,
        (Status::GoalInvalid, Some([part, parts])) if part + 1 < parts => format!("via {}: {reason}", part + 1),
        (_, Some([part, parts])) => format!("part {} of {parts}: {reason}", part + 1),
    };
    Ok(LegPlan {
        status: result.status,
        reason: reason(result).map(of_part),
        cost: f64::INFINITY,
        path: Vec::new(),
        file: PathFile::planned(&leg.scene, options, result, &appraisal),
    })
}

/// Why there is no path, as far as that is known.
fn reason(result: &PlanResult) -> Option<String> {
    match (&result.no_path, result.reason()) {
        (Some(no_path), _) => {
            let remedies = Some(no_path.remedies()).filter(|remedies| !remedies.is_empty());
            Some([no_path.reason()].into_iter().chain(remedies).collect::<Vec<_>>().join("; "))
        }
        (None, worst) => worst.map(|worst| worst.sentence()),
    }
}
