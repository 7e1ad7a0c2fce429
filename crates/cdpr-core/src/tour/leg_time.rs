//! How long the motion between two stations takes, and how long any must take.
//!
//! A motion run backwards has the same accelerations and tensions at the same poses, and opposite velocities; all limits are those of
//! magnitudes. So it keeps the limits if the motion does, and a pair of stations is timed once.
//!
//! The bound holds for motions from rest to rest of a platform that keeps the limits: its origin moves at least as far as the lower bound of
//! the path's length says (the curve of a motion is itself a path that keeps what the scene requires), and rates of what it moves through
//! are at most those of the limits: the length of its way, the angle of its turn and the length of each cable.

use std::borrow::Cow;

use crate::collision::Interference;
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::Pose;
use crate::model::Scene;
use crate::model::spec::MotionSpec;
use crate::trajectory::{Trajectory, Winches, unless_untimed};
use crate::watch::Watch;

/// The time from one station to another.
#[derive(Debug, Clone, PartialEq)]
pub struct LegTime {
    /// Duration of the motion along the path, s; infinite without one.
    pub duration: f64,
    /// Lower bound on the duration of every motion along every path, s; infinite if it is certain that there is none.
    pub lower_bound: f64,
    /// Why the path cannot be timed, if there is one.
    pub reason: Option<String>,
}

impl LegTime {
    /// The time along a path, which is empty if none was found; `least` is a lower bound of the duration.
    pub fn along(
        compiled: &CompiledScene,
        path: &[Pose],
        limits: &MotionSpec,
        least: f64,
        watch: &Watch,
    ) -> Result<Self, Error> {
        if path.is_empty() {
            return Ok(LegTime { duration: f64::INFINITY, lower_bound: least, reason: None });
        }
        let timed = unless_untimed(Trajectory::new(compiled, path, limits, watch))?;
        let duration = timed.as_ref().map_or(f64::INFINITY, Trajectory::duration);
        Ok(LegTime { duration, lower_bound: least.min(duration), reason: timed.err() })
    }
}

/// Whether the lower bound of paths also holds for the curves of motions: the motion keeps all clearances, and curves are proved by the rule
/// by which paths are checked.
pub fn bounds_curves(scene: &Scene, limits: &MotionSpec, interference: Interference) -> Result<bool, Error> {
    let keeps = matches!(limits.in_scene(scene)?.moving(scene)?, Cow::Borrowed(_));
    Ok(keeps && interference == Interference::Exact)
}

/// A duration that no motion between two poses goes below, s, whose platform's origin moves at least `length`, m.
pub fn least_duration(scene: &Scene, limits: &MotionSpec, ends: &[Pose; 2], length: f64) -> Result<f64, Error> {
    if length.is_infinite() {
        return Ok(f64::INFINITY);
    }
    let limits = limits.in_scene(scene)?;
    let [from, to] = ends;
    let straight = (to.position - from.position).norm();
    let way = rest_to_rest(length.max(straight), limits.speed, limits.acceleration);
    // Along the straight line between both, the acceleration begins and ends with 0 and changes by the jerk: up, down, and up again.
    let jerk = limits.jerk.map_or(0.0, |jerk| (32.0 * straight / jerk).cbrt());
    let turn = rest_to_rest(from.angle_to(to), limits.turn_speed, limits.turn_acceleration);
    let cables = match limits.cable_speed.is_some() || limits.cable_acceleration.is_some() {
        false => 0.0,
        true => {
            let winches = Winches::of(scene, &limits, ends)?;
            let wound = winches.cables().iter().map(|cable| {
                let [from, to] = [from, to].map(|end| cable.length(&end.position, &end.orientation));
                rest_to_rest((to - from).abs(), limits.cable_speed, limits.cable_acceleration)
            });
            wound.fold(0.0, f64::max)
        }
    };
    Ok(way.max(jerk).max(turn).max(cables))
}

/// The least time for a distance from rest to rest, s, with limits of the speed and of its rate.
fn rest_to_rest(distance: f64, speed: Option<f64>, acceleration: Option<f64>) -> f64 {
    let without_limit = acceleration.map_or(0.0, |acceleration| 2.0 * (distance / acceleration).sqrt());
    let Some(speed) = speed else { return without_limit };
    match acceleration {
        Some(acceleration) if speed * speed < distance * acceleration => distance / speed + speed / acceleration,
        Some(_) => without_limit,
        None => distance / speed,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Rotation, Vector};
    use crate::testing::empty;

    #[test]
    fn least_times_are_those_of_the_fastest_motions() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        close(rest_to_rest(1.0, Some(1.0), Some(2.0)), 1.5);
        close(rest_to_rest(0.25, Some(1.0), Some(2.0)), 0.5_f64.sqrt());
        close(rest_to_rest(0.5, Some(1.0), Some(2.0)), 1.0);
        close(rest_to_rest(0.5, None, Some(2.0)), 1.0);
        close(rest_to_rest(3.0, Some(2.0), None), 1.5);
        close(rest_to_rest(3.0, None, None), 0.0);
        let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
        let level = |x: f64| Pose::new(Point::new(x, 1.0, 1.0), Rotation::identity());
        let least = |limits: &MotionSpec, to: Pose, length: f64| {
            least_duration(&empty(), limits, &[level(0.5), to], length).unwrap()
        };
        close(least(&limits, level(1.5), 0.0), 1.5);
        close(least(&limits, level(1.5), 2.0), 2.5);
        assert!(least(&limits, level(1.5), f64::INFINITY).is_infinite());
        let jerk = MotionSpec { jerk: Some(4.0), ..limits };
        close(least(&jerk, level(1.5), 0.0), 2.0);
        let turned = Pose::new(level(1.5).position, Rotation::from_scaled_axis(Vector::z() * 2.0));
        let turning = MotionSpec { turn_speed: Some(0.5), turn_acceleration: Some(1.0), ..limits };
        close(least(&turning, turned, 0.0), 4.5);
        // A cable of hard1 is at most as much longer as the platform moves.
        let cables = MotionSpec { cable_speed: Some(0.1), ..limits };
        let longest = least(&cables, level(1.5), 0.0);
        assert!(longest > 5.0 && longest <= 10.0, "{longest}");
    }
}
