//! Trajectories as YAML: a ROS 2 message `trajectory_msgs/msg/JointTrajectory` whose joints are the cables. Positions
//! are lengths, commanded lengths, or angles of the motors. Effort is omitted unless requested, since controllers of
//! positions refuse a message that has it.

use std::borrow::Cow;
use std::path::Path;

use cdpr_core::choices;
use cdpr_core::error::Error;
use cdpr_core::trajectory_file::TrajectoryFile;
use serde::Serialize;

/// What the joints of a message are. Joints grow while their cable is let out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Joints {
    /// Lengths of the cables from outlet to attachment, m.
    #[default]
    Length,
    /// Commanded lengths, m.
    Command,
    /// Angles of the motors, rad.
    Angle,
}

choices!(Joints, "joints", [
    Length = "length": "lengths of the cables from outlet to attachment, m",
    Command = "command": "unstretched lengths that the winches are commanded, m",
    Angle = "angle": "angles of the motors, rad",
]);

/// What a trajectory file holds that only a ROS 2 message has room for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct MessageFields {
    /// What the joints are; lengths if it is not given.
    pub joints: Option<Joints>,
    /// Whether the message has efforts: tensions, N, or torques, N·m, if joints are angles. Controllers of positions
    /// refuse them.
    pub effort: bool,
}

impl MessageFields {
    /// The first field that is requested, as the command line calls it.
    pub fn requested(&self) -> Option<&'static str> {
        [(self.joints.is_some(), "joints"), (self.effort, "effort")]
            .into_iter()
            .find_map(|(is, name)| is.then_some(name))
    }

    /// Checks that a message can hold what is requested, before anything is printed about the motion; `path` is named.
    ///
    /// # Errors
    /// Commanded lengths, angles, tensions or torques that are not known.
    pub fn check(&self, path: &Path, file: &TrajectoryFile) -> Result<(), Error> {
        Content::of(path, file, *self).map(drop)
    }
}

/// The rows of a message.
struct Content<'a> {
    positions: &'a [Vec<f64>],
    effort: Option<&'a Vec<Vec<f64>>>,
}

impl<'a> Content<'a> {
    fn of(path: &Path, file: &'a TrajectoryFile, fields: MessageFields) -> Result<Self, Error> {
        let unknown =
            |what: &str, needs: &str| Error::file(path, format!("cannot hold {what}: they are not known; {needs}"));
        let positions = match fields.joints.unwrap_or_default() {
            Joints::Length => Ok(&file.cable_lengths),
            Joints::Command => file.commands.as_ref().ok_or_else(|| {
                unknown(
                    "commanded lengths",
                    "they need tensions and the stiffness of a cable; without stiffness, they are the lengths",
                )
            }),
            Joints::Angle => file.angles.as_ref().ok_or_else(|| {
                unknown("angles", "they need the drum of each cable, and tensions if one has stiffness")
            }),
        };
        let angles = fields.joints == Some(Joints::Angle);
        let effort = match angles {
            true => file
                .torques
                .as_ref()
                .ok_or_else(|| unknown("torques as effort", "they need tensions and the drum of each cable")),
            false => file
                .tensions
                .as_ref()
                .ok_or_else(|| unknown("tensions as effort", "they need the mass and the tension limits of the robot")),
        };
        Ok(Content { positions: positions?, effort: fields.effort.then_some(effort).transpose()? })
    }
}

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
    velocities: Cow<'a, [f64]>,
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

/// The velocities of the joints at sample `k`, which has a sample on each side: the mean of the slopes to both, each weighted by the
/// length of the other interval. Exact at constant acceleration.
fn slopes(times: &[f64], rows: &[Vec<f64>], k: usize) -> Vec<f64> {
    let (before, after) = (times[k] - times[k - 1], times[k + 1] - times[k]);
    let slope = |joint: usize| {
        let (to, from) =
            ((rows[k][joint] - rows[k - 1][joint]) / before, (rows[k + 1][joint] - rows[k][joint]) / after);
        (to * after + from * before) / (before + after)
    };
    (0..rows[k].len()).map(slope).collect()
}

/// A trajectory as YAML text.
///
/// Velocities and accelerations of lengths are exact. Commanded lengths also follow the tensions, whose rates are not known: the
/// velocities of commanded lengths and angles are slopes between samples, 0 at rest, and there are no accelerations.
///
/// # Errors
/// What [`MessageFields::check`] refuses; a trajectory that is too long for the message, or sampled more often than once in a
/// nanosecond; `path` is named.
pub fn message(path: &Path, file: &TrajectoryFile, fields: MessageFields) -> Result<String, Error> {
    let Content { positions, effort } = Content::of(path, file, fields)?;
    let lengths = fields.joints.unwrap_or_default() == Joints::Length;
    let last = file.times.len() - 1;
    let velocities = |k: usize| match (lengths, k) {
        (true, _) => Cow::Borrowed(&file.cable_speeds[k][..]),
        (false, k) if k == 0 || k == last => Cow::Owned(vec![0.0; file.cables.len()]),
        (false, _) => Cow::Owned(slopes(&file.times, positions, k)),
    };
    let point = |k: usize| {
        Some(JointTrajectoryPoint {
            positions: &positions[k],
            velocities: velocities(k),
            accelerations: row(file.cable_accelerations.as_ref().filter(|_| lengths), k),
            effort: row(effort, k),
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
            let fields = MessageFields { joints: None, effort };
            let text = message(Path::new("motion.yaml"), &file, fields).unwrap();
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

    fn read(file: &TrajectoryFile, joints: Joints, effort: bool) -> definition::JointTrajectory {
        let fields = MessageFields { joints: Some(joints), effort };
        serde_saphyr::from_str(&message(Path::new("m.yaml"), file, fields).unwrap()).unwrap()
    }

    #[test]
    fn joints_are_lengths_commands_or_angles() {
        let mut file = upward();
        file.times = vec![1.0, 1.3, 2.0, 2.4]; // unequal steps, and not from 0
        file.cable_accelerations = Some(vec![vec![1.0; 8]; 4]);
        let [commands, angles] = [-0.01, 3.0].map(|c| {
            let along = |t: &f64| vec![c * (1.0 + t * t); 8];
            file.times.iter().map(along).collect::<Vec<_>>()
        });
        (file.commands, file.angles) = (Some(commands.clone()), Some(angles.clone()));
        file.tensions = Some(vec![vec![100.0; 8]; 4]);
        file.torques = Some(vec![vec![0.5; 8]; 4]);
        for (joints, rows, factor, effort) in
            [(Joints::Command, &commands, -0.01, 100.0), (Joints::Angle, &angles, 3.0, 0.5)]
        {
            for (k, point) in read(&file, joints, true).points.iter().enumerate() {
                assert_eq!((&point.positions, &point.effort), (&rows[k], &vec![effort; 8]));
                assert!(point.accelerations.is_empty());
                let time = f64::from(point.time_from_start.sec) + 1e-9 * f64::from(point.time_from_start.nanosec);
                assert!((time - (file.times[k] - 1.0)).abs() < 1e-9);
                // At constant acceleration the slopes are exact; at both ends, velocities are 0.
                let expected = if k == 0 || k == 3 { 0.0 } else { factor * 2.0 * file.times[k] };
                assert!(point.velocities.iter().all(|v| (v - expected).abs() < 1e-12), "{k}: {:?}", point.velocities);
            }
            assert!(read(&file, joints, false).points.iter().all(|point| point.effort.is_empty()));
        }
        let lengths = message(Path::new("m.yaml"), &file, MessageFields::default()).unwrap();
        let named = MessageFields { joints: Some(Joints::Length), effort: false };
        assert_eq!(message(Path::new("m.yaml"), &file, named).unwrap(), lengths);
        (file.commands, file.angles, file.torques) = (None, None, None);
        for (joints, expected) in [
            (Joints::Command, "m.yaml: cannot hold commanded lengths: they are not known"),
            (Joints::Angle, "m.yaml: cannot hold angles: they are not known"),
        ] {
            let fields = MessageFields { joints: Some(joints), effort: false };
            let said = fields.check(Path::new("m.yaml"), &file).unwrap_err().to_string();
            assert!(said.starts_with(expected), "{said}");
        }
        file.angles = Some(angles);
        let fields = MessageFields { joints: Some(Joints::Angle), effort: true };
        let said = fields.check(Path::new("m.yaml"), &file).unwrap_err().to_string();
        assert!(said.starts_with("m.yaml: cannot hold torques as effort: they are not known"), "{said}");
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
        let refused = |file: &TrajectoryFile, effort| {
            message(Path::new("m.yaml"), file, MessageFields { joints: None, effort }).unwrap_err().to_string()
        };
        assert!(refused(&file, true).starts_with("m.yaml: cannot hold tensions as effort: "));
        file.times[3] = 1e10;
        assert!(refused(&file, false).starts_with("m.yaml: cannot be written: ROS 2 has no durations"));
        file.times[3] = file.times[2] + 1e-10;
        assert!(refused(&file, false).contains("choose a lower rate"));
    }
}
