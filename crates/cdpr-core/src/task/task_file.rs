//! The JSON of a task: its legs in order, what is carried and what stands where on each, and the files of their paths.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{Place, Task, TaskLeg, TaskLegs, TaskMotion, WholeMotion, same_pose, words};
use crate::choice::Choice;
use crate::error::Error;
use crate::geometry::{Point, Pose, rotation_as_written, wxyz};
use crate::model::spec::FORMAT_VERSION;
use crate::model::{Action, Scene, Stop, Stops, body, payload_index};
use crate::path_file::SceneId;

/// What the key `format` of a task contains.
pub const TASK_FORMAT: &str = "cdpr task";

/// A task as planned.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TaskFile {
    /// "cdpr task".
    pub format: String,
    /// Version of the format, 1.
    pub version: u32,
    /// The scene of the task, as it is at first.
    pub scene: SceneId,
    /// "solved", or how planning ended for the first leg without a path.
    pub status: String,
    /// Length of all paths, m; null if a leg has none.
    pub cost: Option<f64>,
    /// The legs, in order.
    pub legs: Vec<LegKeys>,
    /// What is picked and placed at the end.
    pub after: Vec<ActionKeys>,
    /// The motion through all legs, if each of them was timed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<WholeMotionKeys>,
}

/// The keys of the motion through all legs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WholeMotionKeys {
    /// The trajectory file, beside this one.
    pub file: String,
    /// When the motion has ended, s.
    pub duration: f64,
    /// What is picked and placed when, in order.
    pub actions: Vec<TimedActionKeys>,
}

/// What is done with a payload, and when: one of both keys with a name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TimedActionKeys {
    /// Time since the start of the task, s.
    pub time: f64,
    /// It is taken.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pick: Option<String>,
    /// It is set down.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
}

/// The keys of a leg.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LegKeys {
    /// Where it begins.
    pub from: PlaceKeys,
    /// Where it ends.
    pub to: PlaceKeys,
    /// What it passes without a stop.
    pub via: Vec<PlaceKeys>,
    /// What is picked and placed where it begins, before.
    pub before: Vec<ActionKeys>,
    /// Names of the payloads that are carried.
    pub carried: Vec<String>,
    /// Where each of the others stands: where it would be carried if the platform were there.
    pub standing: BTreeMap<String, PlaceKeys>,
    /// Pairs that may touch on this leg, by name.
    pub touch: Vec<[String; 2]>,
    /// The path file with the answer, beside this one.
    pub path: String,
    /// How planning ended.
    pub status: String,
    /// Why there is no path, if there is none.
    pub reason: Option<String>,
    /// Length of the path, m; null without one.
    pub cost: Option<f64>,
    /// The motion along it, if it was to be timed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<LegMotionKeys>,
}

/// The keys of the motion of a leg.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LegMotionKeys {
    /// The trajectory file, beside this one; null without a motion.
    pub file: Option<String>,
    /// Why there is none, if the leg has a path.
    pub reason: Option<String>,
    /// Duration of the motion, s; null without one.
    pub duration: Option<f64>,
    /// When it starts in the motion through all legs, s; null without that.
    pub start: Option<f64>,
    /// When it has ended there, s; null without that.
    pub end: Option<f64>,
}

/// The keys of a pose.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaceKeys {
    /// The station or payload there, if it was named.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Position of the platform's origin, world, m.
    pub position: [f64; 3],
    /// World-from-platform unit quaternion, w x y z.
    pub orientation: [f64; 4],
}

/// What is done with a payload.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ActionKeys {
    /// It is taken.
    Pick(String),
    /// It is set down.
    Place(String),
}

impl PlaceKeys {
    fn of(pose: &Pose, name: Option<&str>) -> Self {
        let (position, orientation) = (pose.position.into(), wxyz(&pose.orientation));
        PlaceKeys { name: name.map(str::to_string), position, orientation }
    }

    fn pose(&self, place: &str) -> Result<Pose, Error> {
        let position: Point = body::point(&format!("{place}.position"), self.position)?;
        body::unit_quaternion(&format!("{place}.orientation"), self.orientation)?;
        Ok(Pose::new(position, rotation_as_written(self.orientation)))
    }
}

/// The names of the files of a task, all in one folder; legs are counted from 0.
#[derive(Debug, Clone, Copy)]
pub struct TaskNames<'a> {
    /// Of the path of a leg.
    pub path: fn(usize) -> String,
    /// Of the motion of a leg.
    pub motion: fn(usize) -> String,
    /// Of the motion through all legs.
    pub whole: &'a str,
}

impl TaskFile {
    /// A planned task of a scene.
    pub fn of(scene: &Scene, task: &Task, names: &TaskNames) -> Self {
        let finite = |cost: f64| Some(cost).filter(|cost| cost.is_finite());
        let mut legs: Vec<LegKeys> = task.legs.legs.iter().map(|leg| leg_keys(scene, leg)).collect();
        for (k, (leg, plan)) in legs.iter_mut().zip(&task.plans).enumerate() {
            leg.status = plan.status.name().to_string();
            leg.path = (names.path)(k);
            (leg.reason, leg.cost) = (plan.reason.clone(), finite(plan.cost));
            leg.motion = task.motion.as_ref().map(|motion| leg_motion(motion, k, names));
        }
        let actions: Vec<Vec<ActionKeys>> = legs.iter().map(|leg| leg.before.clone()).collect();
        let after = action_keys(scene, &task.legs.after);
        let whole = task.motion.as_ref().and_then(|motion| motion.whole.as_ref());
        let motion = whole.map(|whole| WholeMotionKeys::of(whole, names.whole, &actions, &after));
        TaskFile {
            format: TASK_FORMAT.to_string(),
            version: FORMAT_VERSION,
            scene: SceneId::of(scene),
            status: task.status().name().to_string(),
            cost: finite(task.cost()),
            legs,
            after,
            motion,
        }
    }

    /// The legs of this file in a scene, each with the scene that holds on it.
    ///
    /// # Errors
    /// Another format or version; legs that do not join; a payload that is not known, is picked while it is carried or elsewhere than
    /// it stands, or is placed while it is not carried; payloads that are carried or stand otherwise than the file says.
    pub fn legs(&self, scene: &Scene) -> Result<TaskLegs, Error> {
        if self.format != TASK_FORMAT {
            let problem = format!("found \"{}\", expected \"{TASK_FORMAT}\"", self.format);
            return Err(Error::invalid("format", problem));
        }
        if self.version != FORMAT_VERSION {
            return Err(Error::invalid("version", format!("found {}, expected {FORMAT_VERSION}", self.version)));
        }
        let first = self.legs.first().ok_or_else(|| Error::invalid("legs", "found none, expected at least one"))?;
        let start = first.from.pose("legs[0].from")?;
        let mut follow = Follow {
            scene,
            stands: scene.payloads().iter().map(|p| p.stands).collect(),
            here: start,
            stops: Vec::new(),
        };
        for (k, leg) in self.legs.iter().enumerate() {
            follow.leg(k, leg)?;
        }
        follow.actions("after", &self.after)?;
        let stops = Stops { start, start_name: first.from.name.clone(), stops: follow.stops };
        let legs = TaskLegs::through(scene, &stops)?;
        for (k, (leg, keys)) in legs.legs.iter().zip(&self.legs).enumerate() {
            if leg.touch != keys.touch {
                let problem = format!("found {:?}, expected {:?}, since these touch there", keys.touch, leg.touch);
                return Err(Error::invalid(format!("legs[{k}].touch"), problem));
            }
        }
        Ok(legs)
    }
}

fn leg_keys(scene: &Scene, leg: &TaskLeg) -> LegKeys {
    let place = |place: &Place| PlaceKeys::of(&place.pose, place.name.as_deref());
    let payloads = || scene.payloads().iter().zip(&leg.stands);
    let carried = payloads().filter(|(_, stands)| stands.is_none()).map(|(payload, _)| payload.name.clone());
    let standing =
        payloads().filter_map(|(payload, stands)| Some((payload.name.clone(), PlaceKeys::of(&(*stands)?, None))));
    LegKeys {
        from: place(&leg.from),
        to: place(&leg.to),
        via: leg.via.iter().map(|pose| PlaceKeys::of(pose, None)).collect(),
        before: action_keys(scene, &leg.before),
        carried: carried.collect(),
        standing: standing.collect(),
        touch: leg.touch.clone(),
        path: String::new(),
        status: String::new(),
        reason: None,
        cost: None,
        motion: None,
    }
}

fn leg_motion(motion: &TaskMotion, leg: usize, names: &TaskNames) -> LegMotionKeys {
    let times = motion.time_of(leg);
    match &motion.legs[leg] {
        Err(reason) => {
            LegMotionKeys { reason: Some(reason.clone()).filter(|r| !r.is_empty()), ..LegMotionKeys::default() }
        }
        Ok(file) => LegMotionKeys {
            file: Some((names.motion)(leg)),
            reason: None,
            duration: Some(file.duration),
            start: times.map(|[start, _]| start),
            end: times.map(|[_, end]| end),
        },
    }
}

impl WholeMotionKeys {
    /// The keys of a whole motion in this file, with what is picked and placed before each leg and at the end.
    pub fn of(whole: &WholeMotion, file: &str, before: &[Vec<ActionKeys>], after: &[ActionKeys]) -> Self {
        let timed = |(actions, time): (&[ActionKeys], f64)| {
            let keys = |action: &ActionKeys| {
                let (pick, place) = match action {
                    ActionKeys::Pick(name) => (Some(name.clone()), None),
                    ActionKeys::Place(name) => (None, Some(name.clone())),
                };
                TimedActionKeys { time, pick, place }
            };
            actions.iter().map(keys).collect::<Vec<_>>()
        };
        let times = whole.starts.iter().copied().chain([whole.end]);
        let actions = before.iter().map(Vec::as_slice).chain([after]).zip(times).flat_map(timed).collect();
        WholeMotionKeys { file: file.to_string(), duration: whole.file.duration, actions }
    }
}

fn action_keys(scene: &Scene, actions: &[Action]) -> Vec<ActionKeys> {
    let name = |k: usize| scene.payloads()[k].name.clone();
    let keys = |action: &Action| match *action {
        Action::Pick(k) => ActionKeys::Pick(name(k)),
        Action::Place(k) => ActionKeys::Place(name(k)),
    };
    actions.iter().map(keys).collect()
}

/// The state of the cell after some legs of a file.
struct Follow<'a> {
    scene: &'a Scene,
    stands: Vec<Option<Pose>>,
    here: Pose,
    stops: Vec<Stop>,
}

impl Follow<'_> {
    fn leg(&mut self, k: usize, leg: &LegKeys) -> Result<(), Error> {
        let place = format!("legs[{k}]");
        let [from, to] = [leg.from.pose(&format!("{place}.from"))?, leg.to.pose(&format!("{place}.to"))?];
        if !same_pose(&from, &self.here) {
            let problem = format!("found {}, expected where the leg before ends, {}", words(&from), words(&self.here));
            return Err(Error::invalid(format!("{place}.from"), problem));
        }
        self.actions(&format!("{place}.before"), &leg.before)?;
        self.holds(&place, leg)?;
        let via = leg.via.iter().enumerate().map(|(i, via)| via.pose(&format!("{place}.via[{i}]")));
        let via = via.collect::<Result<Vec<_>, _>>()?;
        if to == self.here && via.is_empty() {
            return Err(Error::invalid(format!("{place}.to"), "found where the leg begins, expected another place"));
        }
        self.here = to;
        self.stops.push(Stop { row: k, pose: to, name: leg.to.name.clone(), via, action: None });
        Ok(())
    }

    fn actions(&mut self, place: &str, actions: &[ActionKeys]) -> Result<(), Error> {
        for (i, action) in actions.iter().enumerate() {
            let (key, name) = match action {
                ActionKeys::Pick(name) => ("pick", name),
                ActionKeys::Place(name) => ("place", name),
            };
            let place = format!("{place}[{i}].{key}");
            let k = payload_index(&place, name, self.scene.payloads())?;
            let action = match (action, self.stands[k]) {
                (ActionKeys::Pick(_), Some(pose)) if same_pose(&pose, &self.here) => Action::Pick(k),
                (ActionKeys::Place(_), None) => Action::Place(k),
                (ActionKeys::Pick(_), Some(pose)) => {
                    let problem =
                        format!("found \"{name}\" at {}, but it stands at {}", words(&self.here), words(&pose));
                    return Err(Error::invalid(place, problem));
                }
                (ActionKeys::Pick(_), None) => {
                    return Err(Error::invalid(place, format!("found \"{name}\", which is carried already")));
                }
                (ActionKeys::Place(_), Some(_)) => {
                    return Err(Error::invalid(place, format!("found \"{name}\", which is not carried then")));
                }
            };
            self.stands[k] = matches!(action, Action::Place(_)).then_some(self.here);
            self.stops.push(Stop { row: 0, pose: self.here, name: None, via: Vec::new(), action: Some(action) });
        }
        Ok(())
    }

    /// Checks what a leg says about payloads.
    fn holds(&self, place: &str, leg: &LegKeys) -> Result<(), Error> {
        for name in leg.carried.iter().chain(leg.standing.keys()) {
            payload_index(place, name, self.scene.payloads())?;
        }
        for (payload, stands) in self.scene.payloads().iter().zip(&self.stands) {
            let name = &payload.name;
            let said = leg.standing.get(name).map(|keys| keys.pose(&format!("{place}.standing.{name}"))).transpose()?;
            if leg.carried.contains(name) != stands.is_none() {
                let problem = match stands {
                    None => format!("found none named \"{name}\", expected it: it was picked"),
                    Some(_) => format!("found \"{name}\", which stands then"),
                };
                return Err(Error::invalid(format!("{place}.carried"), problem));
            }
            let agrees = match (said, stands) {
                (Some(said), Some(stands)) => same_pose(&said, stands),
                (said, stands) => said.is_none() && stands.is_none(),
            };
            if !agrees {
                let [said, stands] = [said, *stands].map(|pose| pose.as_ref().map_or("nowhere".to_string(), words));
                let problem = format!("found {said}, expected {stands}, where it was set down last");
                return Err(Error::invalid(format!("{place}.standing.{name}"), problem));
            }
        }
        Ok(())
    }
}
