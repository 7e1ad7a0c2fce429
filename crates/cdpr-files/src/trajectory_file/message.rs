//! Trajectories as YAML: a ROS 2 message `trajectory_msgs/msg/JointTrajectory` whose joints are the cables. Positions
//! are lengths, m; velocities and accelerations are their rates. Effort is tension, N; it is omitted unless requested,
//! since controllers of positions refuse a message that has it.

use std::path::Path;

use cdpr_core::error::Error;
use cdpr_core::trajectory_file::TrajectoryFile;
use serde::Serialize;

#[derive(Serialize)]
struct JointTrajectory<'a> {
    header: Header,
    joint_names: &'a [String],
    points: Vec<JointTrajectoryPoint<'a>>,
}

#[derive(Serialize)]
struct Header {
    stamp: Time,
    frame_id: &'static str,
}

/// A time or a duration.
#[derive(Debug, PartialEq, Serialize)]
struct Time {
    sec: i32,
    nanosec: u32,
}

#[derive(Serialize)]
struct JointTrajectoryPoint<'a> {
    positions: &'a [f64],
    velocities: &'a [f64],
    accelerations: &'a [f64],
    effort: &'a [f64],
    time_from_start: Time,
}

/// Nanoseconds per second.
const NANO: u64 = 1_000_000_000;

impl Time {
    /// The nearest number of nanoseconds; `None` if there are too many seconds for the message.
    fn of(seconds: f64) -> Option<Self> {
        let nanoseconds = (seconds * NANO as f64).round() as u64;
        Some(Time { sec: i32::try_from(nanoseconds / NANO).ok()?, nanosec: (nanoseconds % NANO) as u32 })
    }
}

/// The row of a sample, or an empty one.
fn row(rows: Option<&Vec<Vec<f64>>>, k: usize) -> &[f64] {
    rows.map_or(&[], |rows| &rows[k])
}

/// Checks that a message can hold the tensions of a motion, before anything is printed about it.
///
/// # Errors
/// Tensions that are not known.
pub fn check_effort(path: &Path, file: &TrajectoryFile) -> Result<(), Error> {
    match file.tensions {
        Some(_) => Ok(()),
        None => Err(Error::file(path, "cannot hold the field effort: the tensions of this motion are not known")),
    }
}

/// A trajectory as YAML text, with its tensions if `effort` is set.
///
/// # Errors
/// A trajectory without tensions, if they are requested; one that is too long for the message, or sampled more often
/// than once in a nanosecond; `path` is named.
pub fn message(path: &Path, file: &TrajectoryFile, effort: bool) -> Result<String, Error> {
    if effort {
        check_effort(path, file)?;
    }
    let tensions = file.tensions.as_ref().filter(|_| effort);
    let point = |k: usize| {
        Some(JointTrajectoryPoint {
            positions: &file.cable_lengths[k],
            velocities: &file.cable_speeds[k],
            accelerations: row(file.cable_accelerations.as_ref(), k),
            effort: row(tensions, k),
            time_from_start: Time::of(file.times[k] - file.times[0])?,
        })
    };
    let too_long = || Error::file(path, format!("cannot be written: ROS 2 has no durations of {} s", file.duration));
    let points: Vec<JointTrajectoryPoint> =
        (0..file.times.len()).map(point).collect::<Option<_>>().ok_or_else(too_long)?;
    if points.windows(2).any(|pair| pair[0].time_from_start == pair[1].time_from_start) {
        let problem = "cannot be written: ROS 2 counts time in nanoseconds, and there is more than one sample in one; choose a lower rate";
        return Err(Error::file(path, problem));
    }
    let header = Header { stamp: Time { sec: 0, nanosec: 0 }, frame_id: "" };
    let message = JointTrajectory { header, joint_names: &file.cables, points };
    let options = serde_saphyr::ser_options! { quote_all: true };
    serde_saphyr::to_string_with_options(&message, options).map_err(|e| Error::internal(e.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::geometry::Point;
    use cdpr_core::testing::{hard1, moving};
    use serde::Deserialize;

    /// The definition of the message and of the messages in it: every field with its type, and no other.
    mod definition {
        use super::Deserialize;

        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct JointTrajectory {
            pub header: Header,
            pub joint_names: Vec<String>,
            pub points: Vec<JointTrajectoryPoint>,
        }

        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct Header {
            pub stamp: Time,
            pub frame_id: String,
        }

        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct Time {
            pub sec: i32,
            pub nanosec: u32,
        }

        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct JointTrajectoryPoint {
            pub positions: Vec<f64>,
            pub velocities: Vec<f64>,
            pub accelerations: Vec<f64>,
            pub effort: Vec<f64>,
            pub time_from_start: Time,
        }
    }

    fn upward() -> TrajectoryFile {
        moving(&hard1(), Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 3)
    }

    #[test]
    fn the_message_has_the_fields_and_types_of_its_definition() {
        let mut file = upward();
        let names = ["yes", "1e5", "12:30", "a: b", "'\"\\", "ü\n# -", "", "~"];
        file.cables = names.map(str::to_string).to_vec();
        file.cable_accelerations = Some(vec![vec![1e-7; 8]; 4]);
        file.tensions = Some(vec![vec![100.0; 8]; 4]);
        for effort in [false, true] {
            let text = message(Path::new("motion.yaml"), &file, effort).unwrap();
            let found: definition::JointTrajectory = serde_saphyr::from_str(&text).unwrap();
            assert_eq!(found.joint_names, names);
            assert_eq!(
                (found.header.frame_id.as_str(), found.header.stamp.sec, found.header.stamp.nanosec),
                ("", 0, 0)
            );
            assert_eq!(found.points.len(), 4);
            for (k, point) in found.points.iter().enumerate() {
                assert_eq!((&point.positions, &point.velocities), (&file.cable_lengths[k], &file.cable_speeds[k]));
                assert_eq!((point.accelerations.len(), point.effort.len()), (8, if effort { 8 } else { 0 }));
                let time = f64::from(point.time_from_start.sec) + 1e-9 * f64::from(point.time_from_start.nanosec);
                assert!((time - file.times[k]).abs() < 1e-9);
            }
            assert!(
                text.contains("1.0e-7") && !text.contains("1e-7"),
                "YAML 1.1 reads numbers without a point as text"
            );
        }
    }

    #[test]
    fn nanoseconds_never_make_a_second() {
        for (seconds, sec, nanosec) in [
            (0.0, 0, 0),
            (1.0 - 1e-12, 1, 0),
            (0.999_999_999_4, 0, 999_999_999),
            (0.999_999_999_6, 1, 0),
            (2.000_000_001, 2, 1),
            (2_147_483_647.0, i32::MAX, 0),
        ] {
            assert_eq!(Time::of(seconds), Some(Time { sec, nanosec }), "{seconds}");
        }
        assert_eq!(Time::of(2_147_483_648.0), None);
        let mut file = upward();
        let refused =
            |file: &TrajectoryFile, effort| message(Path::new("m.yaml"), file, effort).unwrap_err().to_string();
        assert!(refused(&file, true).starts_with("m.yaml: cannot hold the field effort"));
        file.times[3] = 1e10;
        assert!(refused(&file, false).starts_with("m.yaml: cannot be written: ROS 2 has no durations"));
        file.times[3] = file.times[2] + 1e-10;
        assert!(refused(&file, false).contains("choose a lower rate"));
    }
}
