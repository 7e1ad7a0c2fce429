//! Trajectory files: the JSON of a timed trajectory, read and checked.

use std::path::Path;

use serde::Deserialize;

use super::path_file::scene_for;
use super::text::{self, Notation};
use cdpr_core::Scene;
use cdpr_core::error::Error;
use cdpr_core::model::{OrientationSource, body};
use cdpr_core::numerics::MOST_TRAJECTORY_BYTES;
use cdpr_core::trajectory_file::{TRAJECTORY_FORMAT, TRAJECTORY_VERSION, TrajectoryFile};

/// Beginning and end of the samples may differ from 0 and the duration by this share of the duration, due to rounding.
const ROUNDING: f64 = 1e-9;

/// The text of a trajectory file; of other JSON files no more is said than that they are none.
///
/// # Errors
/// A file that cannot be read or is larger than [`MOST_TRAJECTORY_BYTES`].
pub fn read_trajectory(path: &Path) -> Result<Option<String>, Error> {
    if text::extension(path).as_deref() != Some("json") {
        return Ok(None);
    }
    let text = text::read_at_most(path, MOST_TRAJECTORY_BYTES)?;
    Ok(is_trajectory(&text).then_some(text))
}

/// Whether a text is JSON that says it is a trajectory.
pub fn is_trajectory(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Head {
        format: String,
    }
    text.contains(TRAJECTORY_FORMAT)
        && serde_json::from_str(text).is_ok_and(|Head { format }| format == TRAJECTORY_FORMAT)
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

/// Checks that the parts of a trajectory fit each other.
///
/// # Errors
/// Names the key, what was found and what was expected.
pub fn check_trajectory(file: &TrajectoryFile) -> Result<(), Error> {
    if file.format != TRAJECTORY_FORMAT {
        let problem = format!("found {:?}, expected {TRAJECTORY_FORMAT:?}", file.format);
        return Err(Error::invalid("format", problem));
    }
    if file.version != TRAJECTORY_VERSION {
        let problem = format!("found {}, expected {TRAJECTORY_VERSION}", file.version);
        return Err(Error::invalid("version", problem));
    }
    for (key, value) in [("duration", file.duration), ("length", file.length), ("rate", file.rate)] {
        at_least_zero(key, value)?;
    }
    limits(file)?;
    times(file)?;
    samples(file)?;
    corners(file)?;
    limiting(file)
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

fn at_least_zero(place: &str, value: f64) -> Result<(), Error> {
    match value.is_finite() && value >= 0.0 {
        true => Ok(()),
        false => Err(Error::invalid(place, format!("found {value}, expected a number of at least 0"))),
    }
}

fn finite(place: &str, row: &[f64]) -> Result<(), Error> {
    match row.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(Error::invalid(place, format!("found {value}, expected a number"))),
        None => Ok(()),
    }
}

fn counted(place: &str, found: usize, expected: usize, what: &str) -> Result<(), Error> {
    match found == expected {
        true => Ok(()),
        false => Err(Error::invalid(place, format!("found {found} entries, expected {expected}: one for each {what}"))),
    }
}

fn limits(file: &TrajectoryFile) -> Result<(), Error> {
    let limits = &file.limits;
    let given = [
        ("speed", limits.speed),
        ("acceleration", limits.acceleration),
        ("jerk", limits.jerk),
        ("cable_speed", limits.cable_speed),
        ("cable_acceleration", limits.cable_acceleration),
        ("blend", Some(limits.blend)),
        ("wrench_margin", limits.wrench_margin),
    ];
    for (key, value) in given {
        value.map_or(Ok(()), |value| at_least_zero(&format!("limits.{key}"), value))?;
    }
    let Some(tensions) = &file.tension_limits else { return Ok(()) };
    counted("tension_limits", tensions.len(), file.cables.len(), "cable")?;
    for (k, [low, high]) in tensions.iter().enumerate() {
        if !(low.is_finite() && high.is_finite() && low <= high) {
            let problem = format!("found {low} and {high}, expected a minimum and a maximum");
            return Err(Error::invalid(format!("tension_limits[{k}]"), problem));
        }
    }
    Ok(())
}

fn times(file: &TrajectoryFile) -> Result<(), Error> {
    let (times, duration) = (&file.times, file.duration);
    let [first, .., last] = times[..] else {
        return Err(Error::invalid("times", format!("found {} entries, expected at least two", times.len())));
    };
    finite("times", times)?;
    if let Some(k) = (1..times.len()).find(|&k| times[k] <= times[k - 1]) {
        let problem = format!("found {} s after {} s, expected times that increase", times[k], times[k - 1]);
        return Err(Error::invalid(format!("times[{k}]"), problem));
    }
    for (k, found, expected) in [(0, first, 0.0), (times.len() - 1, last, duration)] {
        if (found - expected).abs() > ROUNDING * duration {
            let problem = format!("found {found} s, expected {expected} s: samples last from 0 to the duration");
            return Err(Error::invalid(format!("times[{k}]"), problem));
        }
    }
    Ok(())
}

fn samples(file: &TrajectoryFile) -> Result<(), Error> {
    if file.waypoints.len() < 2 {
        let problem = format!("found {} entries, expected at least two", file.waypoints.len());
        return Err(Error::invalid("waypoints", problem));
    }
    points("waypoints", &file.waypoints)?;
    counted("positions", file.positions.len(), file.times.len(), "time")?;
    points("positions", &file.positions)?;
    for (key, rows) in [("velocities", &file.velocities), ("accelerations", &file.accelerations)] {
        counted(key, rows.len(), file.times.len(), "time")?;
        rows.iter().enumerate().try_for_each(|(k, row)| finite(&format!("{key}[{k}]"), row))?;
    }
    for (key, rows) in [("cable_lengths", &file.cable_lengths), ("cable_speeds", &file.cable_speeds)] {
        by_cable(file, key, rows)?;
    }
    file.tensions.as_ref().map_or(Ok(()), |rows| by_cable(file, "tensions", rows))
}

fn points(key: &str, rows: &[[f64; 3]]) -> Result<(), Error> {
    rows.iter().enumerate().try_for_each(|(k, row)| body::point(&format!("{key}[{k}]"), *row).map(drop))
}

fn by_cable(file: &TrajectoryFile, key: &str, rows: &[Vec<f64>]) -> Result<(), Error> {
    counted(key, rows.len(), file.times.len(), "time")?;
    rows.iter().enumerate().try_for_each(|(k, row)| {
        let place = format!("{key}[{k}]");
        counted(&place, row.len(), file.cables.len(), "cable")?;
        finite(&place, row)
    })
}

fn corners(file: &TrajectoryFile) -> Result<(), Error> {
    for (k, corner) in file.corners.iter().enumerate() {
        let place = |key: &str| format!("corners[{k}].{key}");
        if corner.waypoint >= file.waypoints.len() {
            let problem = format!("found {}, expected less than {}", corner.waypoint, file.waypoints.len());
            return Err(Error::invalid(place("waypoint"), problem));
        }
        at_least_zero(&place("deviation"), corner.deviation)?;
        instant(file, &place("time"), corner.time)?;
    }
    Ok(())
}

fn limiting(file: &TrajectoryFile) -> Result<(), Error> {
    for (k, entry) in file.limiting.iter().enumerate() {
        let place = |key: &str| format!("limiting[{k}].{key}");
        instant(file, &place("from"), entry.from)?;
        instant(file, &place("to"), entry.to)?;
        if entry.to < entry.from {
            return Err(Error::invalid(place("to"), format!("found {}, expected at least {}", entry.to, entry.from)));
        }
        if let Some(cable) = entry.cable.as_ref().filter(|cable| !file.cables.contains(cable)) {
            return Err(Error::invalid(place("cable"), format!("found {cable:?}, expected one of the cables")));
        }
    }
    Ok(())
}

fn instant(file: &TrajectoryFile, place: &str, time: f64) -> Result<(), Error> {
    let slack = ROUNDING * file.duration;
    match time >= -slack && time <= file.duration + slack {
        true => Ok(()),
        false => Err(Error::invalid(place, format!("found {time} s, expected 0 to {} s", file.duration))),
    }
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

    /// What is said of a trajectory with one value replaced, or removed if it is null and `key` has one part.
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
    fn a_missing_key_is_named() {
        let optional = ["orientation_name", "tension_limits", "tensions", "curve", "timing"];
        for key in upward().as_object().unwrap().keys().filter(|key| !optional.contains(&key.as_str())) {
            assert_eq!(said(&format!("/{key}"), Value::Null), format!("missing field `{key}`"));
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_its_key() {
        let wrong = [
            ("/version", json!(2), "version: found 2, expected 1"),
            ("/format", json!("other"), "format: found \"other\", expected \"cdpr-trajectory\""),
            ("/duration", json!(-1), "duration: found -1, expected a number of at least 0"),
            ("/times/2", json!(null), "times[2]: found null, expected a number"),
            ("/times/2", json!(0.5), "times[2]: found 0.5 s after 0.5 s, expected times that increase"),
            ("/times/4", json!(2.5), "times[4]: found 2.5 s, expected 2 s: samples last from 0 to the duration"),
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
