//! The JSON of a path as plain data: the path files that users write, and what planning adds to them. Files, Python, the
//! command line and the page share this one type.

use std::sync::Arc;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};

use crate::choice::Choice;
use crate::collision::path_check::Nearest;
use crate::collision::{Engine, Interference, Violation};
use crate::error::Error;
use crate::geometry::{Point, Pose, Rotation, rotation_as_written, wxyz, wxyz_in_turn};
use crate::model::spec::FORMAT_VERSION;
use crate::model::{Scene, body};
use crate::path::{held, length};
use crate::plan::{Appraisal, FoundBy, NoPath, PlanOptions, PlanResult, Post, RouteFound, Stats, Widest};
use crate::planning::{Milestone, PlannerSettings, SearchTree, Status};
use crate::wrench::PathWrench;

/// The keys of a path file. Other keys are allowed, and planning writes more.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[cfg_attr(feature = "schema", schemars(title = "cdpr path"))]
pub struct PathFile {
    /// Version of the format, 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<u32>,
    /// Positions of the platform's origin, world, m.
    pub waypoints: Vec<[f64; 3]>,
    /// Orientation held along the whole path, a world-from-platform unit quaternion w x y z; default: the scene's
    /// orientation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<[f64; 4]>,
    /// Orientation at each waypoint if the platform turns, as unit quaternions w x y z; between two of them it takes the shorter
    /// turn at constant rate. `orientation` is then that of the scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientations: Option<Vec<[f64; 4]>>,
    /// Name of the orientation in the scene; selects it if `orientation` is omitted.
    // Planning writes null for an orientation without a name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation_name: Option<Option<String>>,
    /// The scene that the path was planned for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneId>,
    /// How planning ended: solved, budget_spent, no_path, start_invalid or goal_invalid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub status: Option<String>,
    /// Length of the path, m; if the platform turns, plus the weight of turns times their angles.
    // NaN without a path, which is null in JSON.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cost: Option<f64>,
    /// The planner's path before post-processing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<[f64; 3]>"))]
    pub raw_waypoints: Option<Vec<[f64; 3]>>,
    /// Length of the planner's path before post-processing, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub raw_cost: Option<f64>,
    /// Name of the planner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub planner: Option<String>,
    /// "decision" if the planner found no path but the decision whether there is a path found this one; "kept" or "repaired" if a
    /// given path is still valid as it was or after parts were planned anew; otherwise omitted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub found_by: Option<String>,
    /// How wide the path is, if the widest one was asked for: motions along it keep this width.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub widest: Option<Widest>,
    /// The other keys that planning writes; they are not read back.
    #[serde(flatten, skip_deserializing)]
    #[cfg_attr(feature = "schema", schemars(skip))]
    pub planned: Option<PlannedKeys>,
    /// The planner's search tree, for the page; not in the file.
    #[serde(skip)]
    pub tree: Arc<SearchTree<Point>>,
    /// Why there is no path, for the page; the file has it in `planned`.
    #[serde(skip)]
    pub no_path: Option<Arc<NoPath>>,
}

/// Identifies the scene of a path.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct SceneId {
    /// Name of the scene.
    pub name: String,
    /// Fingerprint of the scene; see [`Scene::fingerprint`].
    pub fingerprint: String,
}

impl SceneId {
    /// The identity of a scene.
    pub fn of(scene: &Scene) -> Self {
        SceneId { name: scene.name().to_string(), fingerprint: scene.fingerprint() }
    }
}

/// The keys of a planned path that are only written.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlannedKeys {
    /// The worst violation at an invalid start or goal.
    pub reason: Option<Violation>,
    /// All violations at an invalid start or goal, worst first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub reasons: Vec<Violation>,
    /// A valid position near an invalid start or goal, if one was found, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nearest_valid: Option<[f64; 3]>,
    /// Why there is no path, if that was proved.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "shared")]
    pub proof: Option<Arc<NoPath>>,
    /// If no path was found and none was proved impossible: every path passes an opening narrower than this, m, if
    /// known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub opening_below: Option<f64>,
    /// The engine that checked motions.
    pub engine: Engine,
    /// Rule for interference between cables.
    pub interference: Interference,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Clearance that the path keeps in addition to that of the scene, m: a timed motion may need more room.
    #[serde(skip_serializing_if = "is_zero")]
    pub added_clearance: f64,
    /// What the path passes and where it ends, if there are via points or several goals.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub route: Option<RouteFound>,
    /// All other options on which the path depends.
    pub options: OptionKeys,
    /// Counts and times.
    pub stats: Stats,
    /// When the planner's path improved, first to last.
    pub history: Vec<Milestone>,
    /// The nearest approach, and the pairs exempt from the required clearance.
    #[serde(flatten)]
    pub nearest: Nearest,
    /// The wrenches, if the scene requires wrench feasibility.
    #[serde(flatten)]
    pub wrench: Option<PathWrench>,
    /// Lower bound on the length of every path at this orientation, m; null if there was no time for it, omitted if it
    /// was not requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lower_bound: Option<Option<f64>>,
}

/// Options of post-processing, the time budget and the settings of the planner.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OptionKeys {
    /// Step of rewinding, m.
    pub step: f64,
    /// Post-processing of the planner's path.
    pub post: Post,
    /// Number of times that rewinding ran.
    pub repeats: usize,
    /// Time limit of the call, ms.
    pub budget_ms: Option<f64>,
    /// Whether planning also decides if there is a path at all; omitted if it does.
    #[serde(skip_serializing_if = "Clone::clone")]
    pub proof: bool,
    /// Settings of the planner.
    #[serde(flatten)]
    pub settings: PlannerSettings,
}

impl PathFile {
    /// A path of a scene without a planning result. It states the orientation at each waypoint if the platform turns.
    pub fn of(scene: &Scene, path: &[Pose]) -> Self {
        let turns = !scene.keeps_orientation(path);
        PathFile {
            version: Some(FORMAT_VERSION),
            waypoints: rows(path),
            orientation: Some(wxyz(scene.orientation())),
            orientation_name: Some(scene.orientation_name().map(str::to_string)),
            orientations: turns.then(|| wxyz_in_turn(path.iter().map(|pose| &pose.orientation))),
            scene: Some(SceneId::of(scene)),
            cost: Some(length(scene, path)),
            ..PathFile::default()
        }
    }

    /// The answer that a scene has no path, for the page.
    pub fn without_path(scene: &Scene, no_path: NoPath) -> Self {
        PathFile {
            status: Some(Status::NoPath.name().to_string()),
            cost: None,
            no_path: Some(Arc::new(no_path)),
            ..PathFile::of(scene, &[])
        }
    }

    /// A planning result in a scene; `lower_bound` is left out.
    pub fn planned(scene: &Scene, options: &PlanOptions, result: &PlanResult, appraisal: &Appraisal) -> Self {
        let PlanResult { status, reasons, nearest_valid, path, cost, raw_path, raw_cost, tree, history, stats, .. } =
            result;
        let PlanResult { found_by, no_path, opening_below, .. } = result;
        let planned = PlannedKeys {
            reason: result.reason().cloned(),
            reasons: reasons.clone(),
            nearest_valid: nearest_valid.map(Into::into),
            proof: no_path.clone(),
            opening_below: *opening_below,
            engine: options.engine,
            interference: options.interference,
            seed: options.seed,
            added_clearance: result.added_clearance,
            route: result.route.clone(),
            options: OptionKeys::of(options),
            stats: *stats,
            history: history.clone(),
            nearest: appraisal.nearest.clone(),
            wrench: appraisal.wrench.clone(),
            lower_bound: None,
        };
        PathFile {
            status: Some(status.name().to_string()),
            cost: Some(*cost),
            raw_waypoints: Some(rows(raw_path)),
            raw_cost: Some(*raw_cost),
            planner: Some(options.planner.planner().name().to_string()),
            found_by: (*found_by != FoundBy::Planner).then(|| found_by.name().to_string()),
            widest: result.widest,
            planned: Some(planned),
            tree: tree.clone(),
            no_path: no_path.clone(),
            ..PathFile::of(scene, path)
        }
    }

    /// Adds the key `lower_bound`, m; null if the bound is not known.
    pub fn with_lower_bound(mut self, bound: Option<f64>) -> Self {
        self.planned.iter_mut().for_each(|planned| planned.lower_bound = Some(bound));
        self
    }

    /// The path with the orientations of the file or, if it has none, at the orientation of a scene.
    ///
    /// # Errors
    /// A number of orientations other than that of waypoints, or a quaternion that does not have length 1.
    pub fn path(&self, scene: &Scene) -> Result<Vec<Pose>, Error> {
        let Some(turns) = self.turns()? else { return Ok(held(scene, &self.points())) };
        Ok(self.points().into_iter().zip(turns).map(|(position, turn)| Pose::new(position, turn)).collect())
    }

    /// The orientation at each waypoint, if the file has them.
    ///
    /// # Errors
    /// A number of orientations other than that of waypoints, or a quaternion that does not have length 1.
    pub fn turns(&self) -> Result<Option<Vec<Rotation>>, Error> {
        let Some(orientations) = &self.orientations else { return Ok(None) };
        if orientations.len() != self.waypoints.len() {
            let problem = format!(
                "found {}, expected one for each of the {} waypoints",
                orientations.len(),
                self.waypoints.len()
            );
            return Err(Error::invalid("orientations", problem));
        }
        let turn = |(k, quaternion): (usize, &[f64; 4])| {
            body::unit_quaternion(&format!("orientations[{k}]"), *quaternion)?;
            Ok(rotation_as_written(*quaternion))
        };
        orientations.iter().enumerate().map(turn).collect::<Result<_, _>>().map(Some)
    }

    /// The waypoints as points, m.
    pub fn points(&self) -> Vec<Point> {
        self.waypoints.iter().map(|row| Point::from(*row)).collect()
    }
}

impl OptionKeys {
    fn of(options: &PlanOptions) -> Self {
        OptionKeys {
            step: options.step,
            post: options.post(),
            repeats: options.repeats,
            budget_ms: options.budget.map(|budget| budget.as_secs_f64() * 1e3),
            proof: options.proof,
            settings: options.planner.settings(),
        }
    }
}

fn shared<S: Serializer>(proof: &Option<Arc<NoPath>>, serializer: S) -> Result<S::Ok, S::Error> {
    proof.as_deref().serialize(serializer)
}

fn rows(path: &[Pose]) -> Vec<[f64; 3]> {
    path.iter().map(|pose| pose.position.into()).collect()
}

fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::plan;
    use crate::testing::hard1;
    use serde_json::{Value, json};

    fn keys(value: &Value) -> Vec<&str> {
        value.as_object().unwrap().keys().map(String::as_str).collect()
    }

    #[test]
    fn planned_files_are_read_without_write_only_keys() {
        let (scene, options) = (hard1(), PlanOptions::paper());
        let result = plan(&scene, &options, &()).unwrap().result;
        let written = json!(PathFile::planned(&scene, &options, &result, &Appraisal::default()));
        assert_eq!(written["orientation_name"], Value::Null);
        assert_eq!(written["options"]["post"], "both");
        assert!(!keys(&written).contains(&"lower_bound"));
        let read: PathFile = serde_json::from_value(written.clone()).unwrap();
        assert_eq!((read.points(), read.status.as_deref()), (result.waypoints(), Some("solved")));
        let again = json!(read);
        let users =
            ["cost", "orientation", "planner", "raw_cost", "raw_waypoints", "scene", "status", "version", "waypoints"];
        assert_eq!(keys(&again), users);
        assert!(users.iter().all(|key| again[key] == written[key]));
    }

    #[test]
    fn found_by_is_written_unless_it_is_the_planner() {
        let by = |found_by| {
            let result = PlanResult { found_by, ..PlanResult::out_of_time() };
            json!(PathFile::planned(&hard1(), &PlanOptions::default(), &result, &Appraisal::default()))
        };
        assert_eq!(by(FoundBy::Planner).get("found_by"), None);
        let read: PathFile = serde_json::from_value(by(FoundBy::Decision)).unwrap();
        assert_eq!(read.found_by.as_deref(), Some("decision"));
    }

    #[test]
    fn missing_numbers_are_null() {
        let result = PlanResult::out_of_time();
        let file = PathFile::planned(&hard1(), &PlanOptions::default(), &result, &Appraisal::default());
        let written = json!(file.with_lower_bound(None));
        for key in ["cost", "raw_cost", "lower_bound", "reason", "min_clearance"] {
            assert_eq!(written.get(key), Some(&Value::Null), "{key}");
        }
        assert_eq!((&written["status"], &written["raw_waypoints"]), (&json!("budget_spent"), &json!([])));
    }

    #[test]
    fn poses_round_trip_and_quaternions_are_normalized() {
        let turn = Rotation::from_scaled_axis(crate::geometry::Vector::new(0.1, 0.2, 0.3));
        let products = std::iter::successors(Some(turn), |last| Some(last * turn)).take(50);
        let written: Vec<[f64; 4]> = products.map(|product| wxyz(&product)).collect();
        let file = PathFile {
            waypoints: vec![[0.0; 3]; written.len()],
            orientations: Some(written.clone()),
            ..PathFile::default()
        };
        let read = file.path(&hard1()).unwrap();
        assert!(read.iter().zip(&written).all(|(pose, digits)| wxyz(&pose.orientation) == *digits));
        let rough =
            PathFile { waypoints: vec![[0.0; 3]], orientations: Some(vec![[1.0 + 1e-7, 0.0, 0.0, 0.0]]), ..file };
        assert_eq!(wxyz(&rough.path(&hard1()).unwrap()[0].orientation), [1.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn a_path_without_a_result_has_no_keys_of_one() {
        let ends = [Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3)];
        let written = json!(PathFile::of(&hard1(), &held(&hard1(), &ends)));
        assert_eq!(keys(&written), ["cost", "orientation", "orientation_name", "scene", "version", "waypoints"]);
        assert_eq!(written["cost"], 1.0);
    }
}
