//! Trajectory files: the JSON of a timed trajectory, read and checked; tables of samples; messages for ROS 2.

mod consistent;
mod message;
mod sampled;
mod table;

pub use consistent::check_trajectory;
pub use message::MessageFields;

use std::path::Path;

use super::output::write_atomically;
use super::path_file::{said_by_turns, scene_for};
use super::text::{self, Notation, extension, other_extension};
use cdpr_core::error::Error;
use cdpr_core::limits::MOST_TRAJECTORY_BYTES;
use cdpr_core::model::{CommandRows, Joints, OrientationSource};
use cdpr_core::trajectory_check::Recorded;
use cdpr_core::trajectory_file::{TRAJECTORY_FORMAT, TrajectoryFile};
use cdpr_core::{Choice, Scene};

/// Whether a text is JSON that says it is a trajectory.
pub fn is_trajectory(text: &str) -> bool {
    text::is_of_format(text, &[TRAJECTORY_FORMAT])
}

/// Parses a trajectory and checks it.
///
/// # Errors
/// Names the key, what was found and what was expected.
pub fn trajectory_from_text(text: &str) -> Result<TrajectoryFile, Error> {
    let file: TrajectoryFile = text::parse(text, Notation::Json)?;
    check_trajectory(&file)?;
    Ok(file)
}

/// The scene at the orientation of a trajectory, and a warning if the trajectory was made for another scene.
///
/// # Errors
/// A trajectory at an orientation that the scene does not have, or of another robot; with `strict`, one that was made
/// for another scene.
pub fn scene_of_trajectory(
    scene: &Scene,
    file: &TrajectoryFile,
    strict: bool,
) -> Result<(Scene, Option<String>), Error> {
    let orientation = Some(OrientationSource::from(file.orientation));
    let found = scene_for(scene, orientation, file.orientation_name.as_deref(), Some(&file.scene), strict)?;
    let expected = found.0.robot().cable_names();
    if expected != file.cables {
        let problem = format!("found {}, expected those of the robot: {}", file.cables.join(", "), expected.join(", "));
        return Err(Error::invalid("cables", problem));
    }
    Ok(found)
}

/// Formats in which a trajectory is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Written {
    Json,
    Csv,
    Yaml,
}

fn format_of(path: &Path) -> Result<Written, Error> {
    match extension(path).as_deref() {
        Some("json") => Ok(Written::Json),
        Some("csv") => Ok(Written::Csv),
        Some("yaml" | "yml") => Ok(Written::Yaml),
        _ => Err(other_extension(path, ".json, .csv or .yaml")),
    }
}

/// Checks that a trajectory can be written under this name, before any work is done; with `fields` as in [`save_trajectory`].
///
/// # Errors
/// An extension that is none of .json, .csv, .yaml and .yml; fields of a message with another one than the last two.
pub fn check_trajectory_name(path: impl AsRef<Path>, fields: MessageFields) -> Result<(), Error> {
    let path = path.as_ref();
    let format = format_of(path)?;
    match fields.requested() {
        Some(field) if format != Written::Yaml => {
            Err(Error::file(path, format!("cannot hold {field}, which only a ROS 2 message (.yaml) has")))
        }
        _ => Ok(()),
    }
}

/// Writes a trajectory in the format given by the extension: JSON; the samples as CSV, `t,x,y,z,qw,qx,qy,qz,vx,vy,vz,ax,ay,az`
/// and the columns of the cables; or a ROS 2 message `trajectory_msgs/msg/JointTrajectory` of the cables as YAML, with the joints and
/// efforts that `fields` requests.
///
/// # Errors
/// Another extension, fields with other formats or of quantities that are not known, or a file that cannot be written; nothing
/// half-written is left.
///
/// # Example
/// ```
/// use cdpr_core::{Point, testing};
/// use cdpr_files::{MessageFields, load_trajectory, save_trajectory};
/// # let folder = tempfile::tempdir().unwrap();
/// # let path = folder.path().join("motion.csv");
/// let motion = testing::moving(&testing::empty(), Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 4);
/// save_trajectory(&path, &motion, MessageFields::default())?;
/// assert_eq!(load_trajectory(&path)?.motion.times, motion.times);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn save_trajectory(path: impl AsRef<Path>, file: &TrajectoryFile, fields: MessageFields) -> Result<(), Error> {
    let path = path.as_ref();
    check_trajectory_name(path, fields)?;
    write_atomically(path, text_of(path, file, fields)?.as_bytes())
}

fn text_of(path: &Path, file: &TrajectoryFile, fields: MessageFields) -> Result<String, Error> {
    Ok(match format_of(path)? {
        Written::Json => trajectory_json(file),
        Written::Csv => table::table(file),
        Written::Yaml => message::message(path, file, fields)?,
    })
}

/// All texts that [`save_trajectory`] may write under this name: a message has one for each choice of fields that it can hold.
pub(super) fn trajectory_texts(path: &Path, file: &TrajectoryFile) -> Result<Vec<String>, Error> {
    let usual = text_of(path, file, MessageFields::default())?;
    if format_of(path)? != Written::Yaml {
        return Ok(vec![usual]);
    }
    let fields = Joints::ALL
        .iter()
        .flat_map(|(joints, ..)| [false, true].map(|effort| MessageFields { joints: Some(*joints), effort }));
    Ok([usual].into_iter().chain(fields.flat_map(|fields| text_of(path, file, fields))).collect())
}

/// A trajectory as JSON text, without line breaks.
pub fn trajectory_json(file: &TrajectoryFile) -> String {
    serde_json::to_string(file).expect("its numbers are finite") + "\n"
}

/// A trajectory that has been read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedTrajectory {
    /// Samples of the trajectory; cables in the order of `cables`.
    pub motion: Recorded,
    /// Names of the cables that the trajectory has columns for.
    pub cables: Vec<String>,
    /// Orientation held all the time, a unit quaternion w x y z, if it is given; if the platform turns, the scene's
    /// orientation.
    pub orientation: Option<[f64; 4]>,
    /// The whole contents of the file, if it is JSON.
    pub file: Option<TrajectoryFile>,
}

/// Loads a trajectory from JSON, or from CSV of any source with at least the columns t, x, y, z. Further columns are those
/// that [`save_trajectory`] writes.
///
/// # Errors
/// Names the file, the key or the line and column, what was found and what was expected.
pub fn load_trajectory(path: impl AsRef<Path>) -> Result<LoadedTrajectory, Error> {
    let path = path.as_ref();
    let expected = match extension(path).as_deref() {
        Some(extension @ ("json" | "csv")) => extension == "json",
        _ => return Err(other_extension(path, ".json or .csv")),
    };
    let text = text::read_at_most(path, MOST_TRAJECTORY_BYTES)?;
    loaded_trajectory(&text, expected).map_err(|e| e.in_file(path))
}

/// Loads a file that may be a trajectory; `None` if it is a path.
///
/// # Errors
/// The errors of [`load_trajectory`].
pub fn load_if_trajectory(path: impl AsRef<Path>) -> Result<Option<LoadedTrajectory>, Error> {
    let path = path.as_ref();
    if !matches!(extension(path).as_deref(), Some("json" | "csv")) {
        return Ok(None);
    }
    let text = text::read_at_most(path, MOST_TRAJECTORY_BYTES)?;
    loaded_if_trajectory(&text).map_err(|e| e.in_file(path))
}

/// A trajectory from text, if it is one: JSON that says so, or CSV with times.
///
/// # Errors
/// The errors of [`load_trajectory`].
pub fn loaded_if_trajectory(text: &str) -> Result<Option<LoadedTrajectory>, Error> {
    match (is_trajectory(text), table::is_table(text)) {
        (true, _) => loaded_trajectory(text, true).map(Some),
        (_, true) => loaded_trajectory(text, false).map(Some),
        _ => Ok(None),
    }
}

fn loaded_trajectory(text: &str, json: bool) -> Result<LoadedTrajectory, Error> {
    if json {
        let file = trajectory_from_text(text)?;
        let (motion, cables) = (Recorded::of(&file)?, file.cables.clone());
        return Ok(LoadedTrajectory { motion, cables, orientation: Some(file.orientation), file: Some(file) });
    }
    let table::Table { motion, orientation, cables } = table::read_table(text)?;
    Ok(LoadedTrajectory { motion, cables, orientation, file: None })
}

/// The scene at the orientation of a trajectory, the trajectory with its cables in the order of the robot, and a
/// warning if it was made for another scene.
///
/// # Errors
/// The errors of [`scene_of_trajectory`].
pub fn scene_of_loaded(
    scene: &Scene,
    loaded: &LoadedTrajectory,
    strict: bool,
) -> Result<(Scene, Recorded, Option<String>), Error> {
    if let Some(file) = &loaded.file {
        let (scene, warning) = scene_of_trajectory(scene, file, strict)?;
        return Ok((scene, loaded.motion.clone(), warning));
    }
    let turns = loaded.motion.orientations.as_deref().unwrap_or_default();
    let said = loaded.orientation.map(OrientationSource::from).or_else(|| said_by_turns(scene, turns));
    let (scene, warning) = scene_for(scene, said, None, None, strict)?;
    let motion = in_order(&loaded.motion, &loaded.cables, &scene.robot().cable_names())?;
    Ok((scene, motion, warning))
}

/// The samples with the cables in another order.
fn in_order(motion: &Recorded, found: &[String], expected: &[&str]) -> Result<Recorded, Error> {
    if found.is_empty() {
        return Ok(motion.clone());
    }
    let order: Option<Vec<usize>> = expected.iter().map(|name| found.iter().position(|other| other == name)).collect();
    let order = order.filter(|order| order.len() == found.len()).ok_or_else(|| {
        let problem = format!("found {}, expected those of the robot: {}", found.join(", "), expected.join(", "));
        Error::invalid("cables", problem)
    })?;
    let sorted = |rows: &Option<Vec<Vec<f64>>>| {
        let row = |row: &Vec<f64>| order.iter().map(|&k| row[k]).collect();
        rows.as_ref().map(|rows| rows.iter().map(row).collect())
    };
    Ok(Recorded {
        cable_lengths: sorted(&motion.cable_lengths),
        cable_speeds: sorted(&motion.cable_speeds),
        cable_accelerations: sorted(&motion.cable_accelerations),
        tensions: sorted(&motion.tensions),
        winches: CommandRows {
            commands: sorted(&motion.winches.commands),
            angles: sorted(&motion.winches.angles),
            torques: sorted(&motion.winches.torques),
        },
        ..motion.clone()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::geometry::Point;
    use cdpr_core::testing::{empty, hard1, moving};
    use serde_json::{Value, json};

    fn upward() -> Value {
        json!(moving(&hard1(), Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 4))
    }

    /// The message about a trajectory with one value replaced, or removed if it is null and `key` has one part.
    fn said(pointer: &str, value: Value) -> String {
        let mut file = upward();
        match (pointer.rsplit_once('/'), &value) {
            (Some(("", key)), Value::Null) => drop(file.as_object_mut().unwrap().remove(key)),
            _ => *file.pointer_mut(pointer).unwrap() = value,
        }
        trajectory_from_text(&file.to_string()).unwrap_err().to_string()
    }

    #[test]
    fn a_trajectory_is_read_as_it_was_written() {
        let text = upward().to_string();
        assert!(is_trajectory(&text) && !is_trajectory("{\"name\": \"cdpr-trajectory\"}"));
        assert_eq!(json!(trajectory_from_text(&text).unwrap()), upward());
    }

    #[test]
    fn columns_of_winches_are_read_if_they_fit() {
        let read = |key: &str, rows: Value| {
            let mut file = upward();
            file[key] = rows;
            trajectory_from_text(&file.to_string())
        };
        let rows = vec![vec![0.5; 8]; 5];
        assert_eq!(read("angles", json!(rows)).unwrap().angles, Some(rows.clone()));
        assert_eq!(read("torques", json!(rows)).unwrap().torques, Some(rows));
        let wrong = [
            (json!([[1.0]]), "commands: found 1 entries, expected 5: one for each time"),
            (json!("a"), "commands: found the string \"a\", expected an array"),
        ];
        for (rows, expected) in wrong {
            let said = read("commands", rows).unwrap_err().to_string();
            assert!(said.contains(expected), "{said}");
        }
    }

    #[test]
    fn a_missing_key_is_named() {
        let optional = ["orientation_name", "tension_limits", "tensions", "cable_accelerations", "curve", "timing"];
        for key in upward().as_object().unwrap().keys().filter(|key| !optional.contains(&key.as_str())) {
            assert_eq!(said(&format!("/{key}"), Value::Null), format!("missing field `{key}`"));
        }
    }

    #[test]
    fn errors_name_the_key() {
        let wrong = [
            ("/version", json!(2), "version: found 2, expected 1"),
            ("/format", json!("other"), "format: found \"other\", expected \"cdpr-trajectory\""),
            ("/duration", json!(-1), "duration: found -1, expected a number of at least 0"),
            ("/times/2", json!(null), "times[2]: found null, expected a number"),
            ("/times/2", json!(0.5), "times[2]: found 0.5 s after 0.5 s, expected times that increase"),
            (
                "/times/4",
                json!(2.5),
                "times[4]: found 2.5 s, expected 2 s, or the next whole period: samples last from 0 to the duration",
            ),
            ("/times", json!([0.0]), "times: found 1 entries, expected at least two"),
            ("/positions", json!([[0, 0, 0]]), "positions: found 1 entries, expected 5: one for each time"),
            ("/positions/1", json!([0, 0]), "positions[1]: found 2 numbers, expected 3"),
            ("/positions/1/2", json!(1e9), "positions[1]: found 1000000000 m, expected coordinates up to 1e6 m"),
            ("/velocities", json!([]), "velocities: found 0 entries, expected 5: one for each time"),
            ("/accelerations/3/0", json!("a"), "accelerations[3][0]: found the string \"a\", expected a number"),
            ("/cable_speeds/3", json!([1.0]), "cable_speeds[3]: found 1 entries, expected 8: one for each cable"),
            ("/cable_lengths", json!([[]]), "cable_lengths: found 1 entries, expected 5: one for each time"),
            ("/tensions", json!([[1.0]]), "tensions: found 1 entries, expected 5: one for each time"),
            ("/tension_limits", json!([[1, 2]]), "tension_limits: found 1 entries, expected 8: one for each cable"),
            ("/limits/blend", json!(-0.1), "limits.blend: found -0.1, expected a number of at least 0"),
            ("/limits/blend", json!(null), "limits.blend: found none, expected a number of at least 0"),
            ("/limiting/0/to", json!(7), "limiting[0].to: found 7 s, expected 0 to 2 s"),
            ("/limiting/0/cable", json!("x"), "limiting[0].cable: found \"x\", expected one of the cables"),
            ("/waypoints", json!([[0, 0, 0]]), "waypoints: found 1 entries, expected at least two"),
        ];
        for (pointer, value, expected) in wrong {
            assert_eq!(said(pointer, value), expected);
        }
        let corner = json!([{ "waypoint": 2, "kind": "stop", "deviation": 0.0, "time": 1.0 }]);
        assert_eq!(said("/corners", corner), "corners[0].waypoint: found 2, expected less than 2");
        assert!(said("/limiting/0/limit", json!("force")).starts_with("limiting[0].limit: unknown variant `force`"));
    }

    #[test]
    fn the_extension_selects_the_format() {
        let folder = tempfile::tempdir().unwrap();
        let file = moving(&hard1(), Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 4);
        for name in ["a.json", "a.csv", "a.yaml", "a.YML"] {
            save_trajectory(folder.path().join(name), &file, MessageFields::default()).unwrap();
        }
        let load = |name: &str| load_trajectory(folder.path().join(name));
        assert_eq!(load("a.json").unwrap().file.unwrap(), file);
        // A table does not say which path the motion follows.
        let samples = |name: &str| Recorded { path: None, ..load(name).unwrap().motion };
        assert_eq!(samples("a.json"), samples("a.csv"));
        assert!(load("a.json").unwrap().motion.path.is_some() && load("a.csv").unwrap().motion.path.is_none());
        let refused = load("a.yaml").unwrap_err().to_string();
        assert!(refused.ends_with("a.yaml: found the extension .yaml, expected .json or .csv"), "{refused}");
        let refused =
            save_trajectory(folder.path().join("a.txt"), &file, MessageFields::default()).unwrap_err().to_string();
        assert!(refused.ends_with("a.txt: found the extension .txt, expected .json, .csv or .yaml"), "{refused}");
        assert!(!folder.path().join("a.txt").exists());
        assert_eq!(loaded_if_trajectory("x,y,z\n1,2,3\n").unwrap(), None);
        assert!(loaded_if_trajectory("t,x,y,z\n1,2,3\n").is_err());
    }

    #[test]
    fn cables_of_a_table_are_put_in_the_order_of_the_robot() {
        let mut file = moving(&hard1(), Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 4);
        let expected = Recorded { path: None, ..Recorded::of(&file).unwrap() };
        file.cables.reverse();
        for rows in [&mut file.cable_lengths, &mut file.cable_speeds] {
            rows.iter_mut().for_each(|row| row.reverse());
        }
        let loaded = loaded_if_trajectory(&table::table(&file)).unwrap().unwrap();
        assert_eq!(scene_of_loaded(&hard1(), &loaded, true).unwrap().1, expected);
        let unknown = LoadedTrajectory { cables: vec!["winch".to_string()], ..loaded.clone() };
        let told = scene_of_loaded(&hard1(), &unknown, true).unwrap_err().to_string();
        assert!(told.starts_with("cables: found winch, expected those of the robot: cable 0,"), "{told}");
        let tilted = LoadedTrajectory { orientation: Some([0.5, 0.0, 0.0, 0.0]), ..loaded };
        assert!(scene_of_loaded(&hard1(), &tilted, true).unwrap_err().to_string().starts_with("orientation: "));
    }

    #[test]
    fn a_trajectory_belongs_to_its_robot_and_its_scene() {
        let mut file = trajectory_from_text(&upward().to_string()).unwrap();
        assert_eq!(scene_of_trajectory(&hard1(), &file, true).unwrap().1, None);
        let warning = scene_of_trajectory(&empty(), &file, false).unwrap().1.unwrap();
        assert!(warning.contains("another scene: \"hard1\""), "{warning}");
        assert!(scene_of_trajectory(&empty(), &file, true).unwrap_err().to_string().starts_with("scene: "));
        file.cables[3] = "winch".to_string();
        let told = scene_of_trajectory(&hard1(), &file, false).unwrap_err().to_string();
        assert!(told.starts_with("cables: found cable 0, cable 1, cable 2, winch,"), "{told}");
    }
}
