//! The JSON of a timed trajectory as plain data. Files, the command line and the page share this one type.

mod planned;

pub(crate) use planned::default_rate;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::collision::path_check::PathViolation;
use crate::collision::{Validity, Violation};
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Point, Pose, Vector, rotation_as_written};
use crate::model::Distribution;
use crate::model::spec::MotionSpec;
use crate::path_file::SceneId;
use crate::tolerances::RECORDED_OVERLAP;
use crate::trajectory::{Largest, Limit, NearestInTime};
use crate::watch::Watch;

/// The value of [`TrajectoryFile::format`].
pub const TRAJECTORY_FORMAT: &str = "cdpr-trajectory";

/// Version of the format.
pub const TRAJECTORY_VERSION: u32 = 1;

/// Quantities of which a motion has a column for each cable.
pub const BY_CABLE: [&str; 7] = ["length", "speed", "acceleration", "tension", "command", "angle", "torque"];

/// The keys of a trajectory file. Other keys are allowed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TrajectoryFile {
    /// Name of the format, [`TRAJECTORY_FORMAT`].
    pub format: String,
    /// Version of the format, [`TRAJECTORY_VERSION`].
    pub version: u32,
    /// The scene that the trajectory was made for.
    pub scene: SceneId,
    /// Orientation held all the time, a world-from-platform unit quaternion w x y z; if the platform turns, the scene's
    /// orientation.
    pub orientation: [f64; 4],
    /// Name of the orientation in the scene.
    pub orientation_name: Option<String>,
    /// Time from start to goal, s.
    pub duration: f64,
    /// Length of the curve, m.
    pub length: f64,
    /// Samples per second.
    pub rate: f64,
    /// The limits that the trajectory keeps.
    pub limits: MotionSpec,
    /// Minimum and maximum tension of each cable, N, if tensions were limited.
    pub tension_limits: Option<Vec<[f64; 2]>>,
    /// Which of all tensions that balance the motion these are, if it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension_distribution: Option<Distribution>,
    /// The path that the curve follows, m.
    pub waypoints: Vec<[f64; 3]>,
    /// Orientation at each waypoint, if the platform turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub waypoint_orientations: Option<Vec<[f64; 4]>>,
    /// How the curve passes the waypoints between start and goal.
    pub corners: Vec<TrajectoryCorner>,
    /// Which limit determines how fast the platform moves, in order of time; gaps are possible.
    pub limiting: Vec<Limiting>,
    /// The largest rates and the range of tensions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub largest: Option<Largest>,
    /// The nearest approach, if anything can come close.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<NearestInTime>,
    /// Names of the cables.
    pub cables: Vec<String>,
    /// Times of the samples, s: from 0 to the duration or, in whole periods of `rate`, the first time after it.
    pub times: Vec<f64>,
    /// Position of the platform's origin at each time, m.
    pub positions: Vec<[f64; 3]>,
    /// Velocity of the platform's origin at each time, m/s.
    pub velocities: Vec<[f64; 3]>,
    /// Acceleration of the platform's origin at each time, m/s².
    pub accelerations: Vec<[f64; 3]>,
    /// Orientation at each time, a world-from-platform unit quaternion w x y z, if the platform turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientations: Option<Vec<[f64; 4]>>,
    /// Angular velocity of the platform at each time, world axes, rad/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angular_velocities: Option<Vec<[f64; 3]>>,
    /// Angular acceleration of the platform at each time, world axes, rad/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angular_accelerations: Option<Vec<[f64; 3]>>,
    /// Length of each cable at each time, m.
    pub cable_lengths: Vec<Vec<f64>>,
    /// Speed of each cable at each time, m/s; positive while the cable is let out.
    pub cable_speeds: Vec<Vec<f64>>,
    /// Tension of each cable at each time, N; `None` if the robot has no mass or no tension limits.
    pub tensions: Option<Vec<Vec<f64>>>,
    /// Commanded length of each cable at each time, m, if it is known; see [`Commands`](crate::model::Commands).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub commands: Option<Vec<Vec<f64>>>,
    /// Angle of each motor at each time, rad, if it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angles: Option<Vec<Vec<f64>>>,
    /// Torque about the axis of each motor at each time, N·m, if it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torques: Option<Vec<Vec<f64>>>,
    /// Acceleration of each cable at each time, m/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_accelerations: Option<Vec<Vec<f64>>>,
    /// The curve in exact form.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<Value>,
    /// The timing in exact form.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub timing: Option<Value>,
}

impl TrajectoryFile {
    /// The rows of each quantity of [`BY_CABLE`], if they are known: for each sample, one number for each cable.
    pub fn by_cable(&self) -> [Option<&Vec<Vec<f64>>>; BY_CABLE.len()] {
        [
            Some(&self.cable_lengths),
            Some(&self.cable_speeds),
            self.cable_accelerations.as_ref(),
            self.tensions.as_ref(),
            self.commands.as_ref(),
            self.angles.as_ref(),
            self.torques.as_ref(),
        ]
    }

    /// The positions of the samples as points, m.
    pub fn points(&self) -> Vec<Point> {
        self.positions.iter().map(|row| Point::from(*row)).collect()
    }

    /// The poses of the samples, at the orientation of the file if the platform does not turn.
    pub fn poses(&self) -> Vec<Pose> {
        let held = rotation_as_written(self.orientation);
        let turned = |k: usize| self.orientations.as_ref().map_or(held, |rows| rotation_as_written(rows[k]));
        self.points().into_iter().enumerate().map(|(k, position)| Pose::new(position, turned(k))).collect()
    }

    /// The path that the curve follows, as poses.
    pub fn path(&self) -> Vec<Pose> {
        let held = rotation_as_written(self.orientation);
        let turned = |k: usize| match &self.waypoint_orientations {
            Some(rows) => rows.get(k).map_or(held, |row| rotation_as_written(*row)),
            None => held,
        };
        self.waypoints.iter().enumerate().map(|(k, point)| Pose::new((*point).into(), turned(k))).collect()
    }

    /// The violations on the motions at constant rates between samples. Violations no deeper than the curve may deviate
    /// from these motions, up to [`RECORDED_OVERLAP`], are omitted, since a curve that touches an obstacle is valid; so
    /// are turns that are merely too close to be proved free. The file must have been checked.
    ///
    /// # Errors
    /// The errors of [`CompiledScene::turning`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn violations(&self, compiled: &CompiledScene, watch: &Watch) -> Result<Vec<PathViolation>, Error> {
        let (poses, reach) = (self.poses(), compiled.conditions().bodies.reach());
        compiled.ready_for(&poses)?;
        let mut violations = Vec::new();
        for (segment, pair) in poses.windows(2).enumerate() {
            watch.check()?;
            if compiled.motion_valid(&pair[0], &pair[1]) {
                continue; // many times faster than checking every condition separately
            }
            let least = -self.deviation(segment, reach).min(RECORDED_OVERLAP);
            let close = |found: &Violation| self.orientations.is_some() && found.unproved;
            let deep = |found: &Violation| !found.margin.is_some_and(|margin| margin >= least);
            let found = compiled.violations(&pair[0], &pair[1]).into_iter();
            let found = found.filter(|violation| deep(violation) && !close(violation));
            violations.extend(found.map(|violation| PathViolation { segment, violation }));
        }
        Ok(violations)
    }

    /// How far points of the platform within `reach`, m, of its origin may deviate from the motion at constant rates between a
    /// sample and the next one, m.
    fn deviation(&self, segment: usize, reach: f64) -> f64 {
        let step = self.times[segment + 1] - self.times[segment];
        let of = |rates: &[[f64; 3]], changes: &[[f64; 3]]| {
            let ends = [segment, segment + 1];
            let ([begin, end], changes) =
                (ends.map(|k| Vector::from(rates[k])), ends.map(|k| Vector::from(changes[k])));
            chord_deviation((end - begin).norm(), changes[0].norm().max(changes[1].norm()), step)
        };
        let turned = self.angular_velocities.as_ref().zip(self.angular_accelerations.as_ref());
        of(&self.velocities, &self.accelerations) + turned.map_or(0.0, |(rates, changes)| reach * of(rates, changes))
    }
}

/// How far a motion may deviate during `step` s from the straight line between its ends, m, given how much its velocity turns and
/// its acceleration at the ends: by a dt²/8 at constant acceleration, and by at most a quarter of the turn times the time if the
/// velocity turns abruptly.
pub fn chord_deviation(turn: f64, acceleration: f64, step: f64) -> f64 {
    (acceleration * step * step / 8.0).max(turn * step / 4.0)
}

/// How the curve passes a waypoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TrajectoryCorner {
    /// Index of the waypoint.
    pub waypoint: usize,
    /// How the curve passes the waypoint.
    pub kind: CornerKind,
    /// Distance between waypoint and curve, m.
    pub deviation: f64,
    /// Time at which the waypoint is passed, s.
    pub time: f64,
    /// Whether the platform begins, ends or changes a turn at the waypoint.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub turn: bool,
}

/// Ways to pass a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CornerKind {
    /// Rounded on the inner side.
    Rounded,
    /// Rounded on the outer side.
    Outward,
    /// Passed at rest: the platform stops at the corner.
    Stop,
}

/// A limit that determines the motion for some time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Limiting {
    /// Start of that time, s.
    pub from: f64,
    /// End of that time, s.
    pub to: f64,
    /// The limit that determines the motion.
    pub limit: Limit,
    /// Name of the cable that reaches the limit, for limits of cables.
    pub cable: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{block, moving, paper_scene, scene};

    #[test]
    fn deviation_of_chord_from_curve_is_no_violation() {
        // The end of the peg is 1 µm inside the side of the platform.
        let peg = block("peg", [0.05, 0.06, 0.01], [1.1 - 1e-6, 1.0, 1.0]);
        let scene = scene(paper_scene("peg", vec![peg]));
        let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE).unwrap();
        let found = |steps: usize| {
            let file = moving(&scene, Point::new(1.0, 1.0, 0.99), Point::new(1.0, 1.0, 1.01), steps);
            file.violations(&compiled, &Watch::NONE).unwrap()
        };
        // At 0.02 m/s² the curve may deviate by 25 µm between samples 0.1 s apart, and by 0.25 µm at 10 ms.
        assert_eq!(found(20), []);
        let close = found(200);
        assert!(close.iter().all(|found| found.violation.culprits == ["platform", "peg"]) && close.len() > 100);
    }
}
