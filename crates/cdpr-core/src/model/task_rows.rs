//! The rows of a task, checked: where the platform stops, and what it picks and places there.

use super::payload::{self, Payload, index, overlap_words};
use super::query::Names;
use super::spec::{PositionSource, SceneSpec, TaskRowSpec};
use crate::error::Error;
use crate::geometry::Pose;

/// What the platform does where it stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// It takes this payload.
    Pick(usize),
    /// It sets this payload down.
    Place(usize),
}

/// Where the platform stops.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// The row of the task, from 0.
    pub row: usize,
    /// The pose there.
    pub pose: Pose,
    /// The station or the payload that the row names.
    pub name: Option<String>,
    /// Poses that it passes on its way there.
    pub via: Vec<Pose>,
    /// What it does there.
    pub action: Option<Action>,
}

/// A task: where the platform starts, and where it stops.
#[derive(Debug, Clone, PartialEq)]
pub struct Stops {
    /// Where it starts.
    pub start: Pose,
    /// The station or the payload there, if it was named.
    pub start_name: Option<String>,
    /// Where it stops, in order.
    pub stops: Vec<Stop>,
}

/// The only key of a row.
enum Row<'a> {
    Go(&'a PositionSource),
    Via(&'a PositionSource),
    Pick(&'a str),
    Place(&'a str),
}

/// Checks the rows of a task.
///
/// # Errors
/// A row without exactly one key, an unknown name, a payload that is picked while it is carried or placed while it is not, two
/// carried payloads that overlap, a start that is not known, a `via` on the way to nowhere.
pub(super) fn stops(written: &SceneSpec, names: &Names, payloads: &[Payload]) -> Result<Stops, Error> {
    let mut walk = Walk::new((written, names), payloads)?;
    for (k, spec) in written.task.iter().enumerate() {
        let place = format!("task[{k}]");
        match row(&place, spec)? {
            Row::Via(source) => walk.via(&format!("{place}.via"), source)?,
            Row::Go(source) => walk.go(k, &format!("{place}.go"), source)?,
            Row::Pick(name) => walk.pick(k, &format!("{place}.pick"), name)?,
            Row::Place(name) => walk.set_down(k, &format!("{place}.place"), name)?,
        }
    }
    if let Some((place, _)) = walk.via.first() {
        return Err(Error::invalid(place, "found the last row, expected a row go or pick after it"));
    }
    let (start, start_name) = walk.start.expect("a task has a row, and each of them leads somewhere");
    Ok(Stops { start, start_name, stops: walk.stops })
}

fn row<'a>(place: &str, spec: &'a TaskRowSpec) -> Result<Row<'a>, Error> {
    match spec {
        TaskRowSpec { go: Some(to), via: None, pick: None, place: None } => Ok(Row::Go(to)),
        TaskRowSpec { go: None, via: Some(through), pick: None, place: None } => Ok(Row::Via(through)),
        TaskRowSpec { go: None, via: None, pick: Some(name), place: None } => Ok(Row::Pick(name)),
        TaskRowSpec { go: None, via: None, pick: None, place: Some(name) } => Ok(Row::Place(name)),
        TaskRowSpec { go, via, pick, place: set } => {
            let keys =
                [("go", go.is_some()), ("via", via.is_some()), ("pick", pick.is_some()), ("place", set.is_some())];
            let found: Vec<&str> = keys.iter().filter(|(_, given)| *given).map(|(key, _)| *key).collect();
            let found = if found.is_empty() { "none".to_string() } else { found.join(" and ") };
            Err(Error::invalid(place, format!("found {found}, expected exactly one of go, via, pick and place")))
        }
    }
}

/// The state of the cell after some rows.
struct Walk<'a> {
    scene: (&'a SceneSpec, &'a Names),
    payloads: &'a [Payload],
    /// Where each payload stands; `None` while it is carried.
    stand: Vec<Option<Pose>>,
    start: Option<(Pose, Option<String>)>,
    here: Option<Pose>,
    /// What is passed on the way to the next stop, with the places of the rows.
    via: Vec<(String, &'a PositionSource)>,
    stops: Vec<Stop>,
}

impl<'a> Walk<'a> {
    fn new((written, names): (&'a SceneSpec, &'a Names), payloads: &'a [Payload]) -> Result<Self, Error> {
        let query = written.query.as_ref();
        let start = query.and_then(|query| query.start.as_ref().map(|start| (start, query.start_orientation.as_ref())));
        let start = start.map(|(start, turn)| {
            payload::pose("query.start", start, turn, (written, names)).map(|pose| (pose, name_of(start)))
        });
        let start = start.transpose()?;
        Ok(Walk {
            scene: (written, names),
            payloads,
            stand: payloads.iter().map(|payload| payload.stands).collect(),
            here: start.as_ref().map(|(pose, _)| *pose),
            start,
            via: Vec::new(),
            stops: Vec::new(),
        })
    }

    fn via(&mut self, place: &str, source: &'a PositionSource) -> Result<(), Error> {
        if self.here.is_none() {
            return Err(Error::invalid(place, "found the first row, expected query.start, or a row go before it"));
        }
        payload::pose(place, source, None, self.scene)?;
        self.via.push((place.to_string(), source));
        Ok(())
    }

    fn go(&mut self, row: usize, place: &str, source: &PositionSource) -> Result<(), Error> {
        let pose = payload::pose(place, source, None, self.scene)?;
        if self.here.is_none() {
            (self.here, self.start) = (Some(pose), Some((pose, name_of(source))));
            return Ok(());
        }
        self.stop(row, pose, name_of(source), None)
    }

    fn pick(&mut self, row: usize, place: &str, name: &str) -> Result<(), Error> {
        let k = index(place, name, self.payloads)?;
        let Some(pose) = self.stand[k] else {
            let problem = format!("found \"{name}\", which is carried already; expected one that stands");
            return Err(Error::invalid(place, problem));
        };
        let carried = self.payloads.iter().zip(&self.stand).filter(|(_, stands)| stands.is_none());
        if let Some((other, _)) = carried.into_iter().find(|(other, _)| self.payloads[k].overlaps(other)) {
            return Err(Error::invalid(place, overlap_words(&self.payloads[k], other)));
        }
        if self.here.is_none() {
            (self.here, self.start) = (Some(pose), Some((pose, Some(name.to_string()))));
        }
        self.stand[k] = None;
        self.stop(row, pose, Some(name.to_string()), Some(Action::Pick(k)))
    }

    fn set_down(&mut self, row: usize, place: &str, name: &str) -> Result<(), Error> {
        let k = index(place, name, self.payloads)?;
        if self.stand[k].is_some() {
            return Err(Error::invalid(
                place,
                format!("found \"{name}\", which is not carried then; expected a row pick before it"),
            ));
        }
        let Some(here) = self.here else {
            return Err(Error::invalid(place, "found the first row, expected query.start, or a row go before it"));
        };
        if !self.via.is_empty() {
            let problem = "found it after via; expected a row go before it, since it is set down where the platform is";
            return Err(Error::invalid(place, problem));
        }
        self.stand[k] = Some(here);
        self.stop(row, here, Some(name.to_string()), Some(Action::Place(k)))
    }

    /// Stops at a pose. What is passed on the way without an orientation of its own has that of both ends, if they have the same.
    fn stop(&mut self, row: usize, pose: Pose, name: Option<String>, action: Option<Action>) -> Result<(), Error> {
        let from = self.here.replace(pose).unwrap_or(pose);
        let same = from.orientation == pose.orientation;
        let mut via = Vec::new();
        for (place, source) in self.via.drain(..) {
            let own = self.scene.1.position(&place, source)?;
            let usual = payload::pose(&place, source, None, self.scene)?;
            via.push(match own {
                (position, None) if same => Pose::new(position, pose.orientation),
                _ => usual,
            });
        }
        self.stops.push(Stop { row, pose, name, via, action });
        Ok(())
    }
}

fn name_of(source: &PositionSource) -> Option<String> {
    match source {
        PositionSource::Named(name) => Some(name.clone()),
        PositionSource::Coordinates(_) => None,
    }
}
