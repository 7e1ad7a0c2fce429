//! The query of a scene: start, goal and orientations, with the names of stations and orientations looked up.

use std::sync::Arc;

use super::body::{self, Turn};
use super::spec::{OrientationSource, OrientationSpec, PositionSource, QuerySpec, SceneSpec, StationSpec};
use crate::error::{Error, nearest_name};
use crate::geometry::{Point, Rotation, wxyz};
use crate::limits::{MOST_ORIENTATIONS, MOST_STATIONS};
use crate::tolerances::SAME_TURN;

/// A named position of the platform.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// Name of the station.
    pub name: String,
    /// Position of the platform's origin, world, m.
    pub position: Point,
    /// Orientation of the platform there, if the station has its own.
    pub orientation: Option<Rotation>,
}

/// The orientations and stations of a scene.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Names {
    pub orientations: Vec<(String, Rotation)>,
    pub stations: Vec<Station>,
}

impl Names {
    pub fn new(spec: &SceneSpec) -> Result<Self, Error> {
        body::at_most("orientations", spec.orientations.len(), MOST_ORIENTATIONS)?;
        body::at_most("stations", spec.stations.len(), MOST_STATIONS)?;
        let mut names = Names { orientations: orientations(&spec.orientations)?, stations: Vec::new() };
        for (k, station) in spec.stations.iter().enumerate() {
            let station = names.checked(&format!("stations[{k}]"), station)?;
            names.stations.push(station);
        }
        Ok(names)
    }

    fn checked(
        &self,
        place: &str,
        StationSpec { name, position, orientation }: &StationSpec,
    ) -> Result<Station, Error> {
        new_name(place, name, self.stations.iter().map(|known| &known.name))?;
        let turn = |source| self.orientation(&format!("{place}.orientation"), source);
        Ok(Station {
            name: name.clone(),
            position: body::point(&format!("{place}.position"), *position)?,
            orientation: orientation.as_ref().map(turn).transpose()?,
        })
    }

    /// An orientation from its name or quaternion; an error is at `place`.
    pub fn orientation(&self, place: &str, source: &OrientationSource) -> Result<Rotation, Error> {
        let name = match source {
            OrientationSource::Quaternion(quaternion) => return body::unit_quaternion(place, *quaternion),
            OrientationSource::Named(name) => name,
        };
        let known = self.orientations.iter().find(|(other, _)| other == name);
        known.map(|(_, rotation)| *rotation).ok_or_else(|| {
            let names: Vec<&str> = self.orientations.iter().map(|(name, _)| name.as_str()).collect();
            unknown(place, name, "a quaternion [w, x, y, z] or one of the scene's orientations", &names)
        })
    }

    /// A station from its name, or a position without an orientation; an error is at `place`.
    pub fn position(&self, place: &str, source: &PositionSource) -> Result<(Point, Option<Rotation>), Error> {
        let name = match source {
            PositionSource::Coordinates(numbers) => return Ok((body::point(place, *numbers)?, None)),
            PositionSource::Named(name) => name,
        };
        let known = self.stations.iter().find(|station| station.name == *name);
        known.map(|station| (station.position, station.orientation)).ok_or_else(|| {
            let names: Vec<&str> = self.stations.iter().map(|station| station.name.as_str()).collect();
            unknown(place, name, "a position [x, y, z] or one of the scene's stations", &names)
        })
    }
}

pub(super) fn unknown(place: &str, name: &str, expected: &str, known: &[&str]) -> Error {
    let all = if known.is_empty() { "none".to_string() } else { known.join(", ") };
    let near = nearest_name(name, known.iter().copied());
    let hint = near.map(|near| format!("; did you mean \"{near}\"?")).unwrap_or_default();
    Error::invalid(place, format!("found \"{name}\", expected {expected} ({all}){hint}"))
}

fn orientations(specs: &[OrientationSpec]) -> Result<Vec<(String, Rotation)>, Error> {
    let mut all: Vec<(String, Rotation)> = Vec::new();
    for (k, OrientationSpec { name, rpy, rpy_degrees, quaternion }) in specs.iter().enumerate() {
        let place = format!("orientations[{k}]");
        new_name(&place, name, all.iter().map(|(known, _)| known))?;
        let turn = Turn { rpy: *rpy, rpy_degrees: *rpy_degrees, quaternion: *quaternion };
        all.push((name.clone(), body::turn(&place, &turn)?));
    }
    Ok(all)
}

/// Checks a name that must differ from those before it.
pub(super) fn new_name<'a>(place: &str, name: &str, mut known: impl Iterator<Item = &'a String>) -> Result<(), Error> {
    body::name(&format!("{place}.name"), name)?;
    if known.any(|other| other == name) {
        return Err(Error::invalid(format!("{place}.name"), format!("found \"{name}\", expected a unique name")));
    }
    Ok(())
}

/// What the query of a scene asks.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Asked {
    pub start: Option<Point>,
    pub goal: Option<Point>,
    /// The orientation of the scene.
    pub orientation: Rotation,
    /// Whether the query selects that orientation.
    pub selects: bool,
    /// The orientations at start and goal, where they are given.
    pub at_ends: [Option<Rotation>; 2],
    pub names: Arc<Names>,
}

impl Asked {
    /// Looks up the names in a query. If the platform does not turn on its way and the stations at both ends have the same
    /// orientation, they select it.
    pub fn new(query: Option<&QuerySpec>, turns: bool, names: Arc<Names>) -> Result<Self, Error> {
        let query = query.cloned().unwrap_or_default();
        let keyed = |key: &str, source: &Option<OrientationSource>| {
            source.as_ref().map(|source| names.orientation(&format!("query.{key}"), source)).transpose()
        };
        let placed = |key: &str, source: &Option<PositionSource>| {
            source.as_ref().map(|source| names.position(&format!("query.{key}"), source)).transpose()
        };
        let (start, goal) = (placed("start", &query.start)?, placed("goal", &query.goal)?);
        let own = [&start, &goal].map(|end| end.and_then(|(_, turn)| turn));
        let keys = [
            keyed("start_orientation", &query.start_orientation)?,
            keyed("goal_orientation", &query.goal_orientation)?,
        ];
        let at_ends = [keys[0].or(own[0]), keys[1].or(own[1])];
        let selected = match keyed("orientation", &query.orientation)? {
            None if !turns && keys == [None; 2] => match own {
                [Some(first), Some(last)] if first.angle_to(&last) <= SAME_TURN => Some(first),
                _ => None,
            },
            selected => selected,
        };
        let first = || names.orientations.first().map_or(Rotation::identity(), |(_, first)| *first);
        Ok(Asked {
            start: start.map(|(position, _)| position),
            goal: goal.map(|(position, _)| position),
            orientation: selected.unwrap_or_else(first),
            selects: selected.is_some(),
            at_ends,
            names,
        })
    }

    /// The query without the names of stations.
    pub fn spec(&self, query: Option<&QuerySpec>) -> Option<QuerySpec> {
        let quaternion = |turn: Rotation| OrientationSource::Quaternion(wxyz(&turn));
        query.map(|query| QuerySpec {
            start: self.start.map(PositionSource::from),
            goal: self.goal.map(PositionSource::from),
            orientation: query.orientation.clone().or(self.selects.then(|| quaternion(self.orientation))),
            start_orientation: query.start_orientation.clone().or(self.at_ends[0].map(quaternion)),
            goal_orientation: query.goal_orientation.clone().or(self.at_ends[1].map(quaternion)),
        })
    }
}
