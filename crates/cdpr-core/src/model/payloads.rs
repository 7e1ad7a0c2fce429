//! The payloads of a scene and its task, checked, and the scene that they make.

use super::body;
use super::payload::{Payload, checked, loaded, with_bodies};
use super::query::Names;
use super::robot::Robot;
use super::spec::{RobotSource, SceneSpec};
use super::task_rows::{self, Stops};
use crate::error::Error;
use crate::limits::{MOST_PAYLOADS, MOST_TASK_ROWS};

/// The payloads of a scene, and its task.
#[derive(Debug, Clone, PartialEq)]
pub struct Payloads {
    /// The scene as its file has it.
    pub(super) spec: SceneSpec,
    pub(super) list: Vec<Payload>,
    pub(super) task: Option<Stops>,
}

impl Payloads {
    /// Checks the payloads and the task of a scene with this robot, and makes the scene without them: each payload is among its
    /// obstacles or on its robot.
    ///
    /// # Errors
    /// Invalid values, by key.
    pub(super) fn of(spec: SceneSpec, robot: &Robot) -> Result<(Self, SceneSpec), Error> {
        body::at_most("payloads", spec.payloads.len(), MOST_PAYLOADS)?;
        body::at_most("task", spec.task.len(), MOST_TASK_ROWS)?;
        let names = Names::new(&spec)?;
        let mut list: Vec<Payload> = Vec::new();
        for (k, payload) in spec.payloads.iter().enumerate() {
            let payload = checked(&format!("payloads[{k}]"), payload, (&spec, robot, &names), &list)?;
            list.push(payload);
        }
        let task = if spec.task.is_empty() { None } else { Some(task_rows::stops(&spec, &names, &list)?) };
        let carried: Vec<usize> = (0..list.len()).filter(|k| list[*k].stands.is_none()).collect();
        let robot = RobotSource::Inline(loaded(robot, &spec.payloads, &list, &carried));
        let plain = with_bodies(&spec, &list, robot);
        Ok((Payloads { spec, list, task }, plain))
    }
}
