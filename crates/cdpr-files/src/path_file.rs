//! Path files: the JSON that planning writes, and CSV of waypoints (header `x,y,z`, m).

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::output::write_atomically;
use super::text::{self, extension, other_extension};
use cdpr_core::collision::path_check::Nearest;
use cdpr_core::error::{Error, printable};
use cdpr_core::geometry::{Point, Rotation};
use cdpr_core::model::OrientationSource::{self, Named};
use cdpr_core::model::Scene;
use cdpr_core::model::body;
use cdpr_core::model::spec::FORMAT_VERSION;
use cdpr_core::plan::{PlanOptions, PlanResult};
use cdpr_core::wrench::PathWrench;

/// What a path file must hold; more keys may stand beside these, and planning writes more.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(title = "cdpr path")]
pub struct PathFile {
    /// Version of the format, 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<u32>,
    /// Positions of the platform's origin, world, m.
    pub waypoints: Vec<[f64; 3]>,
    /// How the platform is turned all the way, world-from-platform, as a unit quaternion w x y z; none is as in the scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<[f64; 4]>,
    /// Its name in the scene; without a quaternion it says which one holds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation_name: Option<String>,
    /// The scene that the path was planned for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneId>,
    /// How planning ended: solved, budget_spent, start_invalid or goal_invalid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub status: Option<String>,
    /// Length of the path, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cost: Option<f64>,
    /// The planner's path before rewinding.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub raw_waypoints: Vec<[f64; 3]>,
    /// Its length, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub raw_cost: Option<f64>,
    /// The planner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub planner: Option<String>,
}

/// Which scene a path belongs to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SceneId {
    /// Name of the scene.
    pub name: String,
    /// See [`Scene::fingerprint`].
    pub fingerprint: String,
}

/// The JSON of a planning result, its nearest approach, what is exempt, and, where the scene asks for it, its wrenches; costs
/// of unsolved ones are null.
pub fn plan_json(
    scene: &Scene,
    options: &PlanOptions,
    result: &PlanResult,
    nearest: &Nearest,
    wrench: Option<&PathWrench>,
) -> Value {
    let mut value = json!({
        "version": FORMAT_VERSION,
        "status": result.status,
        "reason": result.reason,
        "cost": finite(result.cost),
        "waypoints": rows(&result.waypoints),
        "orientation": quaternion(scene.orientation()),
        "orientation_name": scene.orientation_name(),
        "raw_cost": finite(result.raw_cost),
        "raw_waypoints": rows(&result.raw_waypoints),
        "planner": options.planner.planner(),
        "engine": options.engine,
        "interference": options.interference,
        "seed": options.seed,
        "options": options_json(options),
        "stats": result.stats,
        "history": result.history,
        "scene": scene_id(scene),
    });
    for more in [Some(json!(nearest)), wrench.map(|wrench| json!(wrench))].into_iter().flatten() {
        if let (Value::Object(all), Value::Object(more)) = (&mut value, more) {
            all.extend(more);
        }
    }
    value
}

/// All options that a path depends on; those of the planner beside those of rewinding.
fn options_json(options: &PlanOptions) -> Value {
    let mut all = json!({
        "step": options.step,
        "post": options.post(),
        "repeats": options.repeats,
        "budget_ms": options.budget.map(|b| b.as_secs_f64() * 1e3),
    });
    if let (Value::Object(all), Ok(Value::Object(own))) = (&mut all, serde_json::to_value(options.planner.settings())) {
        all.extend(own);
    }
    all
}

/// The JSON of a bare path of a scene.
pub fn path_json(scene: &Scene, waypoints: &[Point]) -> Value {
    let cost = cdpr_core::collision::path_check::path_length(waypoints);
    json!({
        "version": FORMAT_VERSION,
        "cost": cost,
        "waypoints": rows(waypoints),
        "orientation": quaternion(scene.orientation()),
        "orientation_name": scene.orientation_name(),
        "scene": scene_id(scene),
    })
}

fn quaternion(rotation: &Rotation) -> [f64; 4] {
    [rotation.w, rotation.i, rotation.j, rotation.k]
}

fn scene_id(scene: &Scene) -> SceneId {
    SceneId { name: scene.name().to_string(), fingerprint: scene.fingerprint() }
}

fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}

fn rows(points: &[Point]) -> Vec<[f64; 3]> {
    points.iter().map(|p| [p.x, p.y, p.z]).collect()
}

/// Writes a path: JSON as given, or its waypoints as CSV, by the extension.
///
/// # Errors
/// Another extension, or a file that cannot be written; nothing half-written is left.
pub fn save_path(path: &Path, json: &Value) -> Result<(), Error> {
    match is_json(path)? {
        true => write_atomically(path, format!("{json:#}\n").as_bytes()),
        false => write_atomically(path, &csv_bytes(json)?),
    }
}

/// Checks that a path can be written under this name, before the work is done.
///
/// # Errors
/// An extension that is neither .json nor .csv.
pub fn check_path_name(path: &Path) -> Result<(), Error> {
    is_json(path).map(drop)
}

/// Whether a path file of this name is JSON; else it is CSV.
fn is_json(path: &Path) -> Result<bool, Error> {
    match extension(path).as_deref() {
        Some("json") => Ok(true),
        Some("csv") => Ok(false),
        _ => Err(other_extension(path, ".json or .csv")),
    }
}

fn csv_bytes(json: &Value) -> Result<Vec<u8>, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let problem = |e: csv::Error| Error::invalid("", e.to_string());
    writer.write_record(["x", "y", "z"]).map_err(problem)?;
    let waypoints: Vec<[f64; 3]> = serde_json::from_value(json["waypoints"].clone()).unwrap_or_default();
    for waypoint in waypoints {
        writer.write_record(waypoint.map(|x| x.to_string())).map_err(problem)?;
    }
    writer.into_inner().map_err(|e| Error::invalid("", e.to_string()))
}

/// A path file that was read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedPath {
    /// At least two positions, m.
    pub waypoints: Vec<Point>,
    /// All that the file says, if it is JSON.
    pub file: Option<PathFile>,
}

/// Loads a path of at least two waypoints from JSON or CSV.
///
/// # Errors
/// Names the file, the key or line, what was found and what was expected.
pub fn load_waypoints(path: &Path) -> Result<LoadedPath, Error> {
    let json = is_json(path)?;
    waypoints_from_text(&text::read(path)?, json).map_err(|e| e.in_file(path))
}

/// A path of at least two waypoints from text, JSON or else CSV.
///
/// # Errors
/// Names the key or line, what was found and what was expected.
pub fn waypoints_from_text(text: &str, json: bool) -> Result<LoadedPath, Error> {
    if json { from_json(text) } else { from_csv(text).map(|waypoints| LoadedPath { waypoints, file: None }) }
}

/// The scene at the orientation of a path: the scene's own, or, where the scene leaves it open, the one that the path's file
/// says; and a warning if the path was planned for another scene.
///
/// # Errors
/// A path at an orientation that the scene does not have; with `strict`, a path that was planned for another scene.
pub fn scene_of_path(scene: &Scene, path: &LoadedPath, strict: bool) -> Result<(Scene, Option<String>), Error> {
    let file = path.file.clone().unwrap_or_default();
    let named = file.orientation_name;
    let said = file.orientation.map(OrientationSource::from).or(named.clone().map(Named));
    scene_for(scene, said, named.as_deref(), file.scene.as_ref(), strict)
}

/// As [`scene_of_path`], for a path that holds at this orientation, which had that name, and was planned for that scene, as
/// far as it is known.
///
/// # Errors
/// As [`scene_of_path`].
pub fn scene_for(
    scene: &Scene,
    orientation: Option<OrientationSource>,
    orientation_name: Option<&str>,
    planned_for: Option<&SceneId>,
    strict: bool,
) -> Result<(Scene, Option<String>), Error> {
    let own = scene.for_path_at(orientation)?;
    let another = planned_for.filter(|id| id.fingerprint != own.fingerprint());
    // A path may have been planned for just this scene at a turn that was asked for and has no name.
    if (another.is_some() || orientation_name.is_some()) && !scene.has_orientation_of(&own) {
        let names: Vec<&str> = scene.orientations().iter().map(|(name, _)| name.as_str()).collect();
        let names = if names.is_empty() { "no turn".to_string() } else { names.join(", ") };
        let turn = quaternion(own.orientation());
        let problem = format!("found a path at {turn:?}, which is none of the scene's orientations ({names})");
        return Err(Error::invalid("orientation", problem));
    }
    let Some(id) = another else { return Ok((own, None)) };
    let other = format!("another scene: \"{}\" ({})", printable(&id.name), printable(&id.fingerprint));
    let this = format!("\"{}\" ({})", own.name(), own.fingerprint());
    if strict {
        return Err(Error::invalid("scene", format!("found a path planned for {other}, expected one for {this}")));
    }
    Ok((own, Some(format!("the path was planned for {other}; the answer is about {this}"))))
}

fn from_json(text: &str) -> Result<LoadedPath, Error> {
    let file: PathFile = text::parse(text, text::Notation::Json)?;
    if let Some(version) = file.version.filter(|v| *v != FORMAT_VERSION) {
        return Err(Error::invalid("version", format!("found {version}, expected {FORMAT_VERSION}")));
    }
    let why =
        file.status.as_deref().filter(|s| *s != "solved").map_or(String::new(), |s| format!(" (its status is {s})"));
    let waypoints = checked(&file.waypoints, &why)?;
    Ok(LoadedPath { waypoints, file: Some(file) })
}

fn from_csv(text: &str) -> Result<Vec<Point>, Error> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header: Vec<String> = reader.headers().map_err(csv_problem)?.iter().map(str::to_string).collect();
    if header != ["x", "y", "z"] {
        return Err(Error::invalid("header", format!("found \"{}\", expected \"x,y,z\"", header.join(","))));
    }
    let rows = reader.records().map(|row| csv_row(&row.map_err(csv_problem)?)).collect::<Result<Vec<_>, _>>()?;
    checked(&rows, "")
}

fn csv_row(row: &csv::StringRecord) -> Result<[f64; 3], Error> {
    let problem = |problem: String| Error::invalid(line_of(row.position()), problem);
    let number = |text: &str| {
        text.parse::<f64>().map_err(|_| problem(format!("found \"{text}\", expected a number with a decimal point")))
    };
    let numbers = row.iter().map(number).collect::<Result<Vec<f64>, _>>()?;
    <[f64; 3]>::try_from(numbers).map_err(|row| problem(format!("found {} numbers, expected 3", row.len())))
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
