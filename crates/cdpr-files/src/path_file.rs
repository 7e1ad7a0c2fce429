//! Path files: the JSON that planning writes, and CSV of waypoints (header `x,y,z`, m; `x,y,z,qw,qx,qy,qz` if the platform
//! turns).

use std::path::Path;

use serde::Serialize;
use serde_json::json;

use super::output::write_atomically;
use super::text::{self, extension, other_extension};
use cdpr_core::error::{Error, printable};
use cdpr_core::geometry::{Point, Pose, Rotation, wxyz};
use cdpr_core::model::OrientationSource::{self, Named};
use cdpr_core::model::Scene;
use cdpr_core::model::body;
use cdpr_core::model::spec::FORMAT_VERSION;
use cdpr_core::path::held;
pub use cdpr_core::path_file::{PathFile, SceneId};
use cdpr_core::plan::Query;
use cdpr_core::tolerances::SAME_TURN;

/// Writes a path, or its JSON, in the format given by the extension: JSON, or the waypoints as CSV.
///
/// # Errors
/// Another extension, or a file that cannot be written; nothing half-written is left.
pub fn save_path(path: impl AsRef<Path>, file: &impl Serialize) -> Result<(), Error> {
    let path = path.as_ref();
    let json = json!(file);
    let bytes = match PathFormat::of(path)? {
        PathFormat::Json => format!("{json:#}\n").into_bytes(),
        PathFormat::Csv => csv_bytes(&json)?,
    };
    write_atomically(path, &bytes)
}

/// Checks that a path can be written under this name, before any work is done.
///
/// # Errors
/// An extension that is neither .json nor .csv.
pub fn check_path_name(path: impl AsRef<Path>) -> Result<(), Error> {
    let path = path.as_ref();
    PathFormat::of(path).map(drop)
}

/// The formats of path files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathFormat {
    /// Everything that is known about the path.
    Json,
    /// The waypoints alone.
    Csv,
}

impl PathFormat {
    /// The format of a file of this name.
    fn of(path: &Path) -> Result<Self, Error> {
        match extension(path).as_deref() {
            Some("json") => Ok(Self::Json),
            Some("csv") => Ok(Self::Csv),
            _ => Err(other_extension(path, ".json or .csv")),
        }
    }

    /// The format of a text without a name, by how it begins.
    pub fn of_text(text: &str) -> Self {
        if text.trim_start().starts_with('{') { Self::Json } else { Self::Csv }
    }
}

/// The columns of a path along which the platform keeps its orientation.
const POSITION: [&str; 3] = ["x", "y", "z"];
/// The columns of a path along which the platform turns.
const POSE: [&str; 7] = ["x", "y", "z", "qw", "qx", "qy", "qz"];

fn csv_bytes(json: &serde_json::Value) -> Result<Vec<u8>, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let problem = |e: csv::Error| Error::invalid("", e.to_string());
    let waypoints: Vec<[f64; 3]> = serde_json::from_value(json["waypoints"].clone()).unwrap_or_default();
    let orientations: Option<Vec<[f64; 4]>> = serde_json::from_value(json["orientations"].clone()).unwrap_or_default();
    let columns = if orientations.is_some() { &POSE[..] } else { &POSITION };
    writer.write_record(columns).map_err(problem)?;
    let orientations = orientations.unwrap_or_default();
    for (k, waypoint) in waypoints.iter().enumerate() {
        let numbers = waypoint.iter().chain(orientations.get(k).into_iter().flatten());
        writer.write_record(numbers.map(f64::to_string)).map_err(problem)?;
    }
    writer.into_inner().map_err(|e| Error::invalid("", e.to_string()))
}

/// A path file that has been read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedPath {
    /// At least two positions, m.
    pub waypoints: Vec<Point>,
    /// The orientation at each waypoint, if the file has them.
    pub orientations: Option<Vec<Rotation>>,
    /// The whole contents of the file, if it is JSON.
    pub file: Option<PathFile>,
}

impl LoadedPath {
    /// The orientation that the file states for the whole path, if it does.
    pub fn orientation(&self) -> Option<OrientationSource> {
        let file = self.file.as_ref()?;
        let named = || file.orientation_name.clone().flatten().map(Named);
        file.orientation.map(OrientationSource::from).or_else(named)
    }

    /// The clearance from obstacles, m, that motions along the path keep: its width, if the file says that it is the widest path of
    /// this scene.
    pub fn kept(&self, scene: &Scene) -> Option<f64> {
        let file = self.file.as_ref()?;
        let of_scene = file.scene.as_ref().is_some_and(|id| id.fingerprint == scene.fingerprint());
        file.widest.filter(|_| of_scene).map(|widest| widest.clearance)
    }

    /// The path in a scene: at the orientation of the scene if the file has no orientations.
    pub fn path(&self, scene: &Scene) -> Vec<Pose> {
        let turned = |k: usize| self.orientations.as_ref().map_or(*scene.orientation(), |turns| turns[k]);
        let path: Vec<Pose> =
            self.waypoints.iter().enumerate().map(|(k, position)| Pose::new(*position, turned(k))).collect();
        // Orientations that differ from the scene's by rounding alone are no turn.
        if scene.keeps_orientation(&path) { held(scene, &self.waypoints) } else { path }
    }
}

/// Loads a path of at least two waypoints from JSON or CSV.
///
/// # Errors
/// Names the file, the key or line, what was found and what was expected.
pub fn load_waypoints(path: impl AsRef<Path>) -> Result<LoadedPath, Error> {
    let path = path.as_ref();
    let format = PathFormat::of(path)?;
    waypoints_from_text(&text::read(path)?, format).map_err(|e| e.in_file(path))
}

/// Parses a path of at least two waypoints from text.
///
/// # Errors
/// Names the key or line, what was found and what was expected.
pub fn waypoints_from_text(text: &str, format: PathFormat) -> Result<LoadedPath, Error> {
    match format {
        PathFormat::Json => from_json(text),
        PathFormat::Csv => from_csv(text),
    }
}

/// The scene at the orientation of a path, and a warning if the path was planned for another scene. The orientation is
/// the one that the scene selects, or else the one in the path file, or else the one given by its waypoints
/// ([`said_by_turns`]).
///
/// # Errors
/// A path at an orientation that the scene does not have; with `strict`, a path that was planned for another scene.
pub fn scene_of_path(scene: &Scene, path: &LoadedPath, strict: bool) -> Result<(Scene, Option<String>), Error> {
    let file = path.file.clone().unwrap_or_default();
    let named = file.orientation_name.flatten();
    let said = path.orientation().or_else(|| said_by_turns(scene, path.orientations.as_deref().unwrap_or_default()));
    scene_for(scene, said, named.as_deref(), file.scene.as_ref(), strict)
}

/// The orientation for [`scene_for`] that follows from the orientations at the waypoints of a path, if the path states
/// no other: the one that it keeps, unless the scene selects one and lets the platform turn; if it turns, the one at
/// its start if the scene selects none.
pub fn said_by_turns(scene: &Scene, turns: &[Rotation]) -> Option<OrientationSource> {
    let first = turns.first()?;
    let keeps = turns.iter().all(|turn| turn.angle_to(first) <= SAME_TURN);
    let counts =
        if keeps { !(scene.orientation_is_fixed() && Query::of(scene).turns()) } else { scene.orientation_is_open() };
    counts.then(|| wxyz(first).into())
}

/// Refuses orientations of waypoints or samples whose first one differs from the one given beside them.
///
/// # Errors
/// A different orientation at the first waypoint or sample.
pub fn begins_at(given: &Rotation, turns: &[Rotation]) -> Result<(), Error> {
    let Some(first) = turns.first().filter(|first| first.angle_to(given) > SAME_TURN) else { return Ok(()) };
    let [first, given] = [first, given].map(wxyz);
    let problem = format!(
        "found {first:?} at the start, but {given:?} is given; expected the same orientation, or none to be given"
    );
    Err(Error::invalid("orientations", problem))
}

/// The scene at the orientation of a path, and a warning if the path was planned for another scene; see
/// [`scene_of_path`]. Takes the orientation of the path, its name, and the scene that it was planned for, as far as
/// these are known.
///
/// # Errors
/// The errors of [`scene_of_path`].
pub fn scene_for(
    scene: &Scene,
    orientation: Option<OrientationSource>,
    orientation_name: Option<&str>,
    planned_for: Option<&SceneId>,
    strict: bool,
) -> Result<(Scene, Option<String>), Error> {
    let own = scene.for_path_at(orientation)?;
    let another = planned_for.filter(|id| id.fingerprint != own.fingerprint());
    // The path may have been planned for this very scene at an explicitly given orientation without a name.
    if (another.is_some() || orientation_name.is_some()) && !scene.has_orientation_of(&own) {
        let names: Vec<&str> = scene.orientations().iter().map(|(name, _)| name.as_str()).collect();
        let names = if names.is_empty() { "no turn".to_string() } else { names.join(", ") };
        let turn = own.orientation();
        let turn = wxyz(turn);
        let problem = format!("found a path at {turn:?}, which is not one of the scene's orientations ({names})");
        return Err(Error::invalid("orientation", problem));
    }
    let Some(id) = another else { return Ok((own, None)) };
    let other = format!("another scene: \"{}\" ({})", printable(&id.name), printable(&id.fingerprint));
    let this = format!("\"{}\" ({})", own.name(), own.fingerprint());
    if strict {
        return Err(Error::invalid("scene", format!("found a path planned for {other}, expected one for {this}")));
    }
    Ok((own, Some(format!("the path was planned for {other}; the results are for {this}"))))
}

fn from_json(text: &str) -> Result<LoadedPath, Error> {
    if text::is_certificate(text) {
        return Err(Error::invalid("", "found a proof, expected a path"));
    }
    let file: PathFile = text::parse(text, text::Notation::Json)?;
    if let Some(version) = file.version.filter(|v| *v != FORMAT_VERSION) {
        return Err(Error::invalid("version", format!("found {version}, expected {FORMAT_VERSION}")));
    }
    let why =
        file.status.as_deref().filter(|s| *s != "solved").map_or(String::new(), |s| format!(" (its status is {s})"));
    let waypoints = checked(&file.waypoints, &why)?;
    Ok(LoadedPath { waypoints, orientations: file.turns()?, file: Some(file) })
}

fn from_csv(text: &str) -> Result<LoadedPath, Error> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header: Vec<String> = reader.headers().map_err(csv_problem)?.iter().map(str::to_string).collect();
    let turns = header == POSE;
    if header != POSITION && !turns {
        let expected = "expected \"x,y,z\" or, if the platform turns, \"x,y,z,qw,qx,qy,qz\"";
        return Err(Error::invalid("header", format!("found \"{}\", {expected}", header.join(","))));
    }
    let mut records = reader.records().map(|row| row.map_err(csv_problem));
    if !turns {
        let rows = records.map(|row| csv_row(&row?)).collect::<Result<Vec<_>, _>>()?;
        return Ok(LoadedPath { waypoints: checked(&rows, "")?, orientations: None, file: None });
    }
    let mut file = PathFile { orientations: Some(Vec::new()), ..PathFile::default() };
    records.try_for_each(|row| {
        let [x, y, z, quaternion @ ..] = csv_row::<7>(&row?)?;
        file.waypoints.push([x, y, z]);
        file.orientations.get_or_insert_default().push(quaternion);
        Ok(())
    })?;
    Ok(LoadedPath { waypoints: checked(&file.waypoints, "")?, orientations: file.turns()?, file: None })
}

fn csv_row<const N: usize>(row: &csv::StringRecord) -> Result<[f64; N], Error> {
    let problem = |problem: String| Error::invalid(line_of(row.position()), problem);
    let number = |text: &str| {
        text.parse::<f64>().map_err(|_| problem(format!("found \"{text}\", expected a number with a decimal point")))
    };
    let numbers = row.iter().map(number).collect::<Result<Vec<f64>, _>>()?;
    <[f64; N]>::try_from(numbers).map_err(|row| problem(format!("found {} numbers, expected {N}", row.len())))
}

fn line_of(position: Option<&csv::Position>) -> String {
    position.map_or(String::new(), |p| format!("line {}", p.line()))
}

fn csv_problem(error: csv::Error) -> Error {
    Error::invalid(line_of(error.position()), error.to_string())
}

fn checked(rows: &[[f64; 3]], why: &str) -> Result<Vec<Point>, Error> {
    if rows.len() < 2 {
        let found = if rows.is_empty() { "no waypoints" } else { "1 waypoint" };
        return Err(Error::invalid("waypoints", format!("found {found}{why}, expected at least two")));
    }
    rows.iter().enumerate().map(|(k, row)| body::point(&format!("waypoints[{k}]"), *row)).collect()
}
