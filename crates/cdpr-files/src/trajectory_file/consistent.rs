//! Whether the parts of a trajectory file fit each other.

use cdpr_core::error::Error;
use cdpr_core::model::body;
use cdpr_core::tolerances::SAME_SAMPLE;
use cdpr_core::trajectory_file::{TRAJECTORY_FORMAT, TRAJECTORY_VERSION, TrajectoryFile};

/// Beginning and end of the samples may differ from 0 and the duration by this share of the duration, due to rounding.
const ROUNDING: f64 = 1e-9;

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
    let mut limits = file.limits;
    if limits.blend.is_none() {
        return Err(Error::invalid("limits.blend", "found none, expected a number of at least 0"));
    }
    for (key, value) in limits.entries() {
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
    let (rounding, period) = (ROUNDING * duration, 1.0 / file.rate);
    let period = if period.is_finite() { period.max(0.0) } else { 0.0 };
    let (short, long) = (rounding.max(SAME_SAMPLE * period), rounding.max(period * (1.0 - SAME_SAMPLE)));
    let last_is_good = (duration - short..=duration + long).contains(&last);
    let wrong = match () {
        () if first.abs() > rounding => Some((0, first, "0 s".to_string())),
        () if !last_is_good => Some((times.len() - 1, last, format!("{duration} s, or the next whole period"))),
        () => None,
    };
    wrong.map_or(Ok(()), |(k, found, expected)| {
        let problem = format!("found {found} s, expected {expected}: samples last from 0 to the duration");
        Err(Error::invalid(format!("times[{k}]"), problem))
    })
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
    turning(file)?;
    for (key, rows) in [("cable_lengths", &file.cable_lengths), ("cable_speeds", &file.cable_speeds)] {
        by_cable(file, key, rows)?;
    }
    let optional = [
        ("tensions", &file.tensions),
        ("cable_accelerations", &file.cable_accelerations),
        ("commands", &file.commands),
        ("angles", &file.angles),
        ("torques", &file.torques),
    ];
    for (key, rows) in optional {
        rows.as_ref().map_or(Ok(()), |rows| by_cable(file, key, rows))?;
    }
    Ok(())
}

/// The samples of a platform that turns: all of them or none.
fn turning(file: &TrajectoryFile) -> Result<(), Error> {
    let rates =
        [("angular_velocities", &file.angular_velocities), ("angular_accelerations", &file.angular_accelerations)];
    let Some(orientations) = &file.orientations else {
        return match rates.iter().find(|(_, rows)| rows.is_some()) {
            Some((key, _)) => Err(Error::invalid("orientations", format!("found none, expected some beside {key}"))),
            None => Ok(()),
        };
    };
    for (key, rows) in rates {
        let missing = || Error::invalid(key, "found none, expected one for each time beside orientations");
        let rows = rows.as_ref().ok_or_else(missing)?;
        counted(key, rows.len(), file.times.len(), "time")?;
        rows.iter().enumerate().try_for_each(|(k, row)| finite(&format!("{key}[{k}]"), row))?;
    }
    counted("orientations", orientations.len(), file.times.len(), "time")?;
    quaternions("orientations", orientations)?;
    let Some(ends) = &file.waypoint_orientations else { return Ok(()) };
    counted("waypoint_orientations", ends.len(), file.waypoints.len(), "waypoint")?;
    quaternions("waypoint_orientations", ends)
}

fn quaternions(key: &str, rows: &[[f64; 4]]) -> Result<(), Error> {
    let check = |(k, row): (usize, &[f64; 4])| body::unit_quaternion(&format!("{key}[{k}]"), *row).map(drop);
    rows.iter().enumerate().try_for_each(check)
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
