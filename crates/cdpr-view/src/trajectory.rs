//! A timed trajectory as the page shows it: curves over time, thinned so that none loses its extrema.

use serde::Serialize;

use cdpr_core::collision::Violation;
use cdpr_core::collision::path_check::PathViolation;
use cdpr_core::geometry::{Point, Pose, wxyz};
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::path_file::PathFile;
use cdpr_core::trajectory::{Largest, NearestInTime};
use cdpr_core::trajectory_file::{Limiting, TrajectoryCorner, TrajectoryFile};

use super::motion::unusual;
use super::quaternions;

/// Maximum number of positions on a page.
const MOST_POSITIONS: usize = 2000;
/// Maximum number of values of a curve: three per pixel.
const MOST_VALUES: usize = 1000;

/// A trajectory on a page.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Shown<'a> {
    duration: f64,
    length: f64,
    limits: &'a MotionSpec,
    tension_limits: &'a Option<Vec<[f64; 2]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    distribution: Option<&'static str>,
    limiting: Vec<Limiting>,
    corners: &'a [TrajectoryCorner],
    #[serde(skip_serializing_if = "Option::is_none")]
    largest: Option<Largest>,
    #[serde(skip_serializing_if = "Option::is_none")]
    nearest: Option<&'a NearestInTime>,
    cables: &'a [String],
    waypoints: &'a [[f64; 3]],
    /// Times of the positions, s.
    times: Vec<f64>,
    /// Positions of the platform's origin, m.
    positions: Vec<[f32; 3]>,
    /// Orientations, if the platform turns: unit quaternions w x y z, with signs such that interpolation turns the same
    /// way.
    #[serde(skip_serializing_if = "Option::is_none")]
    orientations: Option<Vec<[f32; 4]>>,
    /// Angular speed, rad/s, if the platform turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    turn_speed: Option<Curve>,
    /// Speed of the platform's origin, m/s.
    speed: Curve,
    /// Acceleration of the platform's origin, m/s².
    acceleration: Curve,
    /// Speed of each cable, m/s.
    cable_speeds: Vec<Curve>,
    /// Tension of each cable, N; empty if there are none.
    tensions: Vec<Curve>,
}

/// Values over time.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Curve {
    /// Times of the values, s; omitted if the curve has a value at every sample and the page shows the positions of all
    /// samples.
    #[serde(skip_serializing_if = "Option::is_none")]
    times: Option<Vec<f64>>,
    values: Vec<f32>,
}

/// The trajectory in the format of the page.
pub(super) fn shown(file: &TrajectoryFile) -> Shown<'_> {
    let kept = evenly(file.times.len(), MOST_POSITIONS);
    let norm = |rows: &[[f64; 3]]| curve(file, &|k| Point::from(rows[k]).coords.norm());
    let by_cable = |rows: &[Vec<f64>]| (0..file.cables.len()).map(|cable| curve(file, &|k| rows[k][cable])).collect();
    Shown {
        duration: file.duration,
        length: file.length,
        limits: &file.limits,
        tension_limits: &file.tension_limits,
        distribution: file.tension_distribution.and_then(unusual),
        limiting: merged(&file.limiting),
        corners: &file.corners,
        largest: file.largest,
        nearest: file.nearest.as_ref(),
        cables: &file.cables,
        waypoints: &file.waypoints,
        times: kept.iter().map(|&k| microseconds(file.times[k])).collect(),
        positions: kept.iter().map(|&k| file.positions[k].map(|x| x as f32)).collect(),
        orientations: kept_poses(file)
            .map(|poses| quaternions(&poses).iter().map(|turn| wxyz(turn).map(|x| x as f32)).collect()),
        turn_speed: file.angular_velocities.as_deref().map(norm),
        speed: norm(&file.velocities),
        acceleration: norm(&file.accelerations),
        cable_speeds: by_cable(&file.cable_speeds),
        tensions: file.tensions.as_deref().map_or(Vec::new(), by_cable),
    }
}

/// The positions as a path, with the waypoints as the path before it was changed.
pub(super) fn path(file: &TrajectoryFile) -> PathFile {
    let kept = evenly(file.times.len(), MOST_POSITIONS);
    PathFile {
        waypoints: kept.into_iter().map(|k| file.positions[k]).collect(),
        orientations: kept_poses(file).map(|poses| poses.iter().map(|pose| wxyz(&pose.orientation)).collect()),
        raw_waypoints: Some(file.waypoints.clone()),
        cost: Some(file.length),
        ..PathFile::default()
    }
}

/// The poses on a page, if the platform turns.
fn kept_poses(file: &TrajectoryFile) -> Option<Vec<Pose>> {
    file.orientations.as_ref()?;
    let poses = file.poses();
    Some(evenly(file.times.len(), MOST_POSITIONS).into_iter().map(|k| poses[k]).collect())
}

/// The pose at a time of a platform with these poses, between samples on the motion at constant rates.
pub(super) fn pose_at(file: &TrajectoryFile, poses: &[Pose], time: f64) -> Pose {
    let (after, share) = between(file, time);
    poses[after - 1].toward(&poses[after]).at(share)
}

/// The index of the first sample after a time, and the share of the time since the one before.
fn between(file: &TrajectoryFile, time: f64) -> (usize, f64) {
    let after = file.times.partition_point(|&other| other <= time).clamp(1, file.times.len() - 1);
    let (begin, end) = (file.times[after - 1], file.times[after]);
    (after, ((time - begin) / (end - begin)).clamp(0.0, 1.0))
}

/// A violation with its time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Event {
    /// Start of the violation, s.
    time: f64,
    #[serde(flatten)]
    violation: PathViolation,
}

/// The violations between samples as events in time: one that lasts for several samples is one event, with its worst
/// gap.
pub(super) fn events(file: &TrajectoryFile, violations: &[PathViolation]) -> Vec<Event> {
    let mut events: Vec<(Event, usize)> = Vec::new();
    for found in violations {
        let Violation { kind, culprits, gap, .. } = &found.violation;
        let same = |other: &Violation| other.kind == *kind && other.culprits == *culprits;
        let open =
            |(event, last): &&mut (Event, usize)| last.abs_diff(found.segment) <= 1 && same(&event.violation.violation);
        if let Some((event, last)) = events.iter_mut().rev().find(open) {
            *last = found.segment;
            let worst = &mut event.violation.violation.gap;
            *worst = worst.zip(*gap).map(|(a, b)| a.min(b));
            continue;
        }
        let (begin, end) = (file.times[found.segment], file.times[found.segment + 1]);
        let time = microseconds(begin + (end - begin) * found.violation.at);
        events.push((Event { time, violation: found.clone() }, found.segment));
    }
    events.into_iter().map(|(event, _)| event).collect()
}

/// A curve through a value of each sample.
fn curve(file: &TrajectoryFile, value: &dyn Fn(usize) -> f64) -> Curve {
    let kept = with_extrema(file.times.len(), value);
    let all = kept.len() == file.times.len() && kept.len() <= MOST_POSITIONS;
    Curve {
        times: (!all).then(|| kept.iter().map(|&k| microseconds(file.times[k])).collect()),
        values: kept.iter().map(|&k| short(value(k))).collect(),
    }
}

/// At most `most` indices of a list of length `count`, evenly distributed, with both ends.
fn evenly(count: usize, most: usize) -> Vec<usize> {
    if count <= most {
        return (0..count).collect();
    }
    (0..most).map(|k| k * (count - 1) / (most - 1)).collect()
}

/// The indices of the least and greatest values in each of many equal parts of a list, and both ends; all of a short
/// list.
fn with_extrema(count: usize, value: &dyn Fn(usize) -> f64) -> Vec<usize> {
    if count <= MOST_VALUES {
        return (0..count).collect();
    }
    let parts = MOST_VALUES / 2 - 1;
    let mut kept = vec![0, count - 1];
    for part in 0..parts {
        let within = part * count / parts..(part + 1) * count / parts;
        let by_value = |a: &usize, b: &usize| value(*a).total_cmp(&value(*b));
        kept.extend(within.clone().min_by(by_value));
        kept.extend(within.max_by(by_value));
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// Adjacent entries of the same limit as one.
fn merged(limiting: &[Limiting]) -> Vec<Limiting> {
    let mut found: Vec<Limiting> = Vec::new();
    for entry in limiting {
        match found.last_mut() {
            Some(last) if last.limit == entry.limit && last.cable == entry.cable && last.to >= entry.from => {
                last.to = last.to.max(entry.to);
            }
            _ => found.push(entry.clone()),
        }
    }
    found
}

/// A time to the microsecond.
fn microseconds(time: f64) -> f64 {
    (time * 1e6).round() / 1e6
}

/// A number with six digits, more than a plot can show.
fn short(value: f64) -> f32 {
    format!("{value:.5e}").parse().unwrap_or(f32::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::compiled::CompiledScene;
    use cdpr_core::testing::{hard1, moving};
    use cdpr_core::trajectory::Limit;
    use cdpr_core::watch::Watch;

    const START: [f64; 3] = [0.3, 1.0, 0.3];

    fn upward(steps: usize) -> TrajectoryFile {
        moving(&hard1(), START.into(), Point::new(0.3, 1.0, 1.3), steps)
    }

    #[test]
    fn a_short_trajectory_is_shown_whole() {
        let file = upward(200);
        let shown = shown(&file);
        assert_eq!((shown.times.len(), shown.positions.len(), shown.speed.values.len()), (201, 201, 201));
        assert!(shown.speed.times.is_none() && shown.tensions.is_empty());
        assert_eq!((shown.speed.values[100], shown.acceleration.values[7]), (1.0, 1.0));
        assert_eq!((shown.cable_speeds.len(), shown.positions[200]), (8, [0.3, 1.0, 1.3]));
        assert_eq!(path(&file).raw_waypoints, Some(vec![START, [0.3, 1.0, 1.3]]));
    }

    #[test]
    fn no_curve_loses_its_extrema_to_thinning() {
        let mut file = upward(50_000);
        (file.velocities[33_333], file.velocities[12_345]) = ([9.0, 0.0, 0.0], [0.0; 3]);
        (file.cable_speeds[777][3], file.cable_speeds[40_001][3]) = (7.0, -7.0);
        let shown = shown(&file);
        assert_eq!((shown.times.len(), shown.times[0], shown.times[1999]), (2000, 0.0, 2.0));
        let at = |curve: &Curve, value: f32| {
            let times = curve.times.as_ref().unwrap();
            assert!(times.len() == curve.values.len() && times.len() <= MOST_VALUES && times.is_sorted());
            times[curve.values.iter().position(|other| *other == value).unwrap()]
        };
        assert_eq!(at(&shown.speed, 9.0), microseconds(file.times[33_333]));
        let cable = &shown.cable_speeds[3];
        assert_eq!([7.0, -7.0].map(|v| at(cable, v)), [777, 40_001].map(|k| microseconds(file.times[k])));
        for curve in [&shown.acceleration, cable] {
            let times = curve.times.as_ref().unwrap();
            assert_eq!((times[0], times[times.len() - 1]), (0.0, 2.0));
        }
    }

    #[test]
    fn positions_lie_between_samples() {
        let file = upward(4);
        for (time, z) in [(-1.0, 0.3), (0.0, 0.3), (0.25, 0.3625), (1.0, 0.8), (2.0, 1.3), (9.0, 1.3)] {
            let pose = pose_at(&file, &file.poses(), time);
            assert!((pose.position - Point::new(0.3, 1.0, z)).norm() < 1e-12, "{time}");
        }
    }

    #[test]
    fn a_lasting_violation_is_one_event() {
        let scene = hard1();
        let file = moving(&scene, START.into(), Point::new(1.7, 1.0, 1.7), 100);
        let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE).unwrap();
        let violations = file.violations(&compiled, &Watch::NONE).unwrap();
        let found = events(&file, &violations);
        assert!(found.len() < violations.len() / 3, "{} of {}", found.len(), violations.len());
        let of = |event: &&Event| event.violation.violation.culprits == ["platform", "pillar"];
        let [event] = found.iter().filter(of).collect::<Vec<_>>()[..] else { panic!("one event") };
        let worst = violations.iter().filter(|v| v.violation.culprits == ["platform", "pillar"]);
        let worst = worst.filter_map(|v| v.violation.gap).fold(f64::INFINITY, f64::min);
        assert_eq!(event.violation.violation.gap, Some(worst));
        // The platform meets the pillar at x = 0.775, after 0.475 of the 1.4 m.
        assert!((event.time - (2.0 * 0.475 / 1.4_f64).sqrt()).abs() < 1e-3, "{}", event.time);
    }

    #[test]
    fn adjacent_entries_of_the_same_limit_are_one() {
        let entry =
            |from, to, cable: &str| Limiting { from, to, limit: Limit::Tension, cable: Some(cable.to_string()) };
        let found = merged(&[entry(0.0, 1.0, "a"), entry(1.0, 2.0, "a"), entry(2.0, 3.0, "b"), entry(4.0, 5.0, "b")]);
        assert_eq!(found, [entry(0.0, 2.0, "a"), entry(2.0, 3.0, "b"), entry(4.0, 5.0, "b")]);
    }
}
