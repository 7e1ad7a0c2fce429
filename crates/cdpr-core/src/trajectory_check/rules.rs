//! The limits of a motion, and whether its columns fit each other.

use super::faults::{FaultKind, Faults, Instant, number};
use super::recorded::Recorded;
use crate::geometry::{Point, Vector};
use crate::numerics::{
    RECORDED_ACCELERATION, RECORDED_EXCESS, RECORDED_LENGTH, RECORDED_RATE, RECORDED_ROUNDING, SAME_TIME,
};
use crate::trajectory::{Limits, Motion, Winches};

/// The rules that a motion is checked against.
pub struct Rules<'a> {
    /// Names of the cables.
    pub names: Vec<&'a str>,
    /// Limits.
    pub limits: &'a Limits,
    /// Cables.
    pub winches: &'a Winches,
}

/// The largest values of a motion.
#[derive(Debug, Clone, Copy, Default, PartialEq, serde::Serialize)]
pub struct Largest {
    /// Speed of the platform, m/s.
    pub speed: f64,
    /// Acceleration of the platform, m/s².
    pub acceleration: f64,
    /// Speed of a cable, m/s.
    pub cable_speed: f64,
    /// Acceleration of a cable, m/s².
    pub cable_acceleration: f64,
}

/// A limited quantity at an instant.
struct Quantity<'a> {
    kind: FaultKind,
    cable: Option<&'a str>,
    value: f64,
    limit: Option<f64>,
    /// What rounding of positions may add.
    rounding: f64,
}

impl Quantity<'_> {
    fn words(&self) -> (&'static str, &'static str) {
        match self.kind {
            FaultKind::Speed => ("speed", "m/s"),
            FaultKind::Acceleration => ("acceleration", "m/s²"),
            FaultKind::Jerk => ("jerk", "m/s³"),
            FaultKind::CableSpeed => ("speed", "m/s"),
            _ => ("acceleration", "m/s²"),
        }
    }

    fn check(&self, step: usize, time: f64, faults: &mut Faults) {
        let Some(limit) = self.limit else { return };
        if self.value <= limit * (1.0 + RECORDED_EXCESS) + self.rounding {
            return;
        }
        let (what, unit) = self.words();
        let (found, limit) = (Some(self.value), Some(limit));
        let (culprits, excess) = (self.cable.as_slice(), self.value);
        faults.add(&Instant { step, time, kind: self.kind, culprits, found, limit, excess }, || {
            let of = self.cable.map_or(String::new(), |cable| format!("{cable}: "));
            format!("{of}{what} {} {unit}, limit {} {unit}", number(self.value), number(limit.unwrap_or_default()))
        });
    }
}

/// Velocity, acceleration and, if it is known, jerk of the platform at an instant.
pub struct Rates<'a> {
    /// Index of the sample.
    pub step: usize,
    /// s.
    pub time: f64,
    /// m.
    pub position: &'a Point,
    /// m/s.
    pub velocity: &'a Vector,
    /// m/s².
    pub acceleration: &'a Vector,
    /// m/s³.
    pub jerk: Option<&'a Vector>,
    /// What rounding of positions may add to velocity and acceleration.
    pub rounding: [f64; 2],
}

impl Rules<'_> {
    /// Checks all limits at an instant.
    pub fn at(&self, rates: &Rates, largest: &mut Largest, faults: &mut Faults) {
        let Rates { step, time, position, velocity, acceleration, jerk, rounding: [slow, late] } = *rates;
        let check = |kind, cable, value: f64, limit, rounding, faults: &mut Faults| {
            Quantity { kind, cable, value, limit, rounding }.check(step, time, faults);
            value
        };
        let limits = self.limits;
        let speed = check(FaultKind::Speed, None, velocity.norm(), limits.speed, slow, faults);
        let a = check(FaultKind::Acceleration, None, acceleration.norm(), limits.acceleration, late, faults);
        if let Some(jerk) = jerk {
            check(FaultKind::Jerk, None, jerk.norm(), limits.jerk, 0.0, faults);
        }
        let mut fastest = [speed, a, largest.cable_speed, largest.cable_acceleration];
        for (name, winding) in self.names.iter().zip(self.winches.windings(position, velocity, acceleration)) {
            let (speed, a, name) = (winding.speed.abs(), winding.acceleration.abs(), Some(*name));
            fastest[2] = check(FaultKind::CableSpeed, name, speed, limits.cable_speed, slow, faults).max(fastest[2]);
            let a = check(FaultKind::CableAcceleration, name, a, limits.cable_acceleration, late, faults);
            fastest[3] = a.max(fastest[3]);
        }
        *largest = Largest {
            speed: largest.speed.max(fastest[0]),
            acceleration: largest.acceleration.max(fastest[1]),
            cable_speed: fastest[2],
            cable_acceleration: fastest[3],
        };
    }

    /// Checks the mean rates between a sample and the next one: the motion really reaches at least these.
    pub fn means(&self, motion: &Recorded, k: usize, faults: &mut Faults) {
        let (step, time, limits) = (motion.step(k), motion.times[k], self.limits);
        let rounding = RECORDED_ROUNDING / step;
        let rate = |list: &Option<Vec<Vector>>| list.as_ref().map(|list| (list[k + 1] - list[k]).norm() / step);
        let given = [
            (FaultKind::Speed, Some(motion.mean_velocity(k).norm()), limits.speed, rounding),
            (FaultKind::Acceleration, rate(&motion.velocities), limits.acceleration, rounding),
            (FaultKind::Jerk, rate(&motion.accelerations), limits.jerk, rounding),
        ];
        for (kind, value, limit, rounding) in given {
            let Some(value) = value else { continue };
            Quantity { kind, cable: None, value, limit, rounding }.check(k, time, faults);
        }
        let [before, after] = [k, k + 1].map(|k| self.lengths(&motion.positions[k]));
        for (name, (before, after)) in self.names.iter().zip(before.zip(after)) {
            let (kind, value) = (FaultKind::CableSpeed, (after - before).abs() / step);
            Quantity { kind, cable: Some(name), value, limit: limits.cable_speed, rounding }.check(k, time, faults);
        }
    }

    fn lengths(&self, position: &Point) -> impl Iterator<Item = f64> {
        self.winches.cables().iter().map(move |cable| (position + cable.arm - cable.outlet).norm())
    }

    /// Checks that velocities and accelerations fit the positions between a sample and the next one; `most` is the largest
    /// acceleration of all samples.
    pub fn fits(&self, motion: &Recorded, velocities: &[Vector], k: usize, most: f64, faults: &mut Faults) {
        let (step, time) = (motion.step(k), motion.times[k]);
        let rounding = RECORDED_ROUNDING / step;
        let mut add = |kind, found: f64, allowed: f64, what: [&str; 3]| {
            if found <= allowed {
                return;
            }
            let (found_, limit) = (Some(found), Some(allowed));
            let instant = Instant { step: k, time, kind, culprits: &[], found: found_, limit, excess: found - allowed };
            faults.add(&instant, || {
                let [of, from, unit] = what;
                format!(
                    "{of} differ by {} {unit} from {from}, at most {} {unit} expected",
                    number(found),
                    number(allowed)
                )
            });
        };
        let middle = |list: &[Vector]| 0.5 * (list[k] + list[k + 1]);
        if motion.velocities.is_some() {
            let near = k.saturating_sub(1)..(k + 3).min(motion.times.len());
            let nearby =
                motion.accelerations.as_ref().map_or(0.0, |a| a[near].iter().map(Vector::norm).fold(0.0, f64::max));
            let found = (motion.mean_velocity(k) - middle(velocities)).norm();
            let allowed = motion.turn(k) + 0.5 * step * nearby + rounding;
            add(FaultKind::Velocity, found, allowed, ["velocities", "the change of the position", "m/s"]);
        }
        if let Some(accelerations) = &motion.accelerations {
            let found = ((velocities[k + 1] - velocities[k]) / step - middle(accelerations)).norm();
            let allowed = RECORDED_ACCELERATION * most + 4.0 * rounding / step;
            add(FaultKind::Inconsistent, found, allowed, ["accelerations", "the change of the velocity", "m/s²"]);
        }
    }

    /// Checks the columns of cables at a sample.
    pub fn cables(&self, motion: &Recorded, k: usize, faults: &mut Faults) {
        let (step, time, position) = (k, motion.times[k], &motion.positions[k]);
        let mut add = |kind, name: &str, found: f64, expected: f64, allowed: f64, words: [&str; 2]| {
            let excess = (found - expected).abs();
            if excess <= allowed {
                return;
            }
            let (culprits, found_, limit) = ([name], Some(found), Some(expected));
            faults.add(&Instant { step, time, kind, culprits: &culprits, found: found_, limit, excess }, || {
                let [what, unit] = words;
                format!("{name}: {what} {} {unit}, {} {unit} expected", number(found), number(expected))
            });
        };
        if let Some(lengths) = &motion.cable_lengths {
            for ((name, expected), found) in self.names.iter().zip(self.lengths(position)).zip(&lengths[k]) {
                add(FaultKind::CableLength, name, *found, expected, RECORDED_LENGTH, ["length", "m"]);
            }
        }
        if let (Some(speeds), Some(velocities)) = (&motion.cable_speeds, &motion.velocities) {
            let windings = self.winches.windings(position, &velocities[k], &velocities[k]);
            let allowed = RECORDED_RATE * (1.0 + velocities[k].norm());
            for ((name, winding), found) in self.names.iter().zip(windings).zip(&speeds[k]) {
                add(FaultKind::CableRate, name, *found, winding.speed, allowed, ["speed", "m/s"]);
            }
        }
    }

    /// Checks that a sample is on the exact form of the motion, given this form just before, at, and just after its time.
    pub fn exact(&self, motion: &Recorded, k: usize, exact: [Motion; 3], faults: &mut Faults) {
        let (step, time) = (k, motion.times[k]);
        let nearest = |of: &dyn Fn(&Motion) -> f64| exact.iter().map(of).fold(f64::INFINITY, f64::min);
        let rate = |list: &Option<Vec<Vector>>, of: fn(&Motion) -> Vector| {
            list.as_ref().map_or(0.0, |list| nearest(&|m| (list[k] - of(m)).norm() / (1.0 + of(m).norm())))
        };
        let found = [
            ("position", "m", nearest(&|m| (motion.positions[k] - m.position).norm())),
            ("velocity", "m/s", rate(&motion.velocities, |m| m.velocity)),
            ("acceleration", "m/s²", rate(&motion.accelerations, |m| m.acceleration)),
        ];
        for (what, unit, excess) in found {
            if excess <= RECORDED_LENGTH {
                continue;
            }
            let (found, limit) = (Some(excess), Some(RECORDED_LENGTH));
            faults.add(
                &Instant { step, time, kind: FaultKind::NotExact, culprits: &[what], found, limit, excess },
                || format!("the {what} differs by {} {unit} from that of curve and timing", number(excess)),
            );
        }
    }
}

/// Times just before, at, and just after a time, s: the acceleration may jump there.
pub fn around(time: f64) -> [f64; 3] {
    [time - SAME_TIME, time, time + SAME_TIME]
}
