//! The limits of a motion, and whether its columns fit each other.

use super::faults::{FaultKind, Faults, Instant, number};
use super::recorded::Recorded;
use crate::geometry::{Rotation, Vector};
use crate::model::spec::MotionSpec;
use crate::model::{CommandRows, Robot};
use crate::tolerances::{
    RECORDED_ACCELERATION, RECORDED_BEND, RECORDED_EXCESS, RECORDED_LENGTH, RECORDED_RATE, RECORDED_ROUNDING, SAME_TIME,
};
use crate::trajectory::{Largest, Limit, Motion, Winches};

/// The rules that a motion is checked against.
pub struct Rules<'a> {
    /// The robot.
    pub robot: &'a Robot,
    /// Names of its cables.
    pub names: Vec<&'a str>,
    /// Limits of the motion.
    pub limits: &'a MotionSpec,
    /// Its cables.
    pub winches: &'a Winches,
}

/// A limited quantity at an instant.
struct Quantity<'a> {
    of: Limit,
    cable: Option<&'a str>,
    value: f64,
    limit: Option<f64>,
    /// What rounding of positions may add.
    rounding: f64,
}

impl Quantity<'_> {
    fn check(&self, step: usize, time: f64, faults: &mut Faults) {
        let Some(limit) = self.limit else { return };
        if self.value <= limit * (1.0 + RECORDED_EXCESS) + self.rounding {
            return;
        }
        let [what, unit] = self.of.quantity();
        let (found, limit) = (Some(self.value), Some(limit));
        let (culprits, excess) = (self.cable.as_slice(), self.value);
        faults.add(&Instant { step, time, kind: FaultKind::Limit(self.of), culprits, found, limit, excess }, || {
            let whose = self.cable.map_or(String::new(), |cable| format!("{cable}: "));
            format!("{whose}{what} {} {unit}, limit {} {unit}", number(self.value), number(limit.unwrap_or_default()))
        });
    }
}

/// A recorded quantity of a cable, and what is expected.
pub struct Column<'a> {
    pub kind: FaultKind,
    pub cable: &'a str,
    pub found: f64,
    pub expected: f64,
    /// The largest allowed difference.
    pub allowed: f64,
    /// The quantity and its unit.
    pub words: [&'a str; 2],
}

impl Column<'_> {
    pub fn check(&self, step: usize, time: f64, faults: &mut Faults) {
        let Column { kind, cable, found, expected, words: [what, unit], .. } = *self;
        let excess = (found - expected).abs();
        if excess <= self.allowed {
            return;
        }
        let (culprits, of, limit) = ([cable], Some(found), Some(expected));
        faults.add(&Instant { step, time, kind, culprits: &culprits, found: of, limit, excess }, || {
            format!("{cable}: {what} {} {unit}, {} {unit} expected", number(found), number(expected))
        });
    }
}

/// A quantity of winches: its name and unit, its recorded rows, what is expected at a sample, and what is needed to know it.
struct Winch<'a> {
    words: [&'static str; 2],
    found: Option<&'a Vec<Vec<f64>>>,
    expected: Option<Vec<f64>>,
    needs: &'static str,
}

/// The motion of the platform at an instant.
pub struct Rates<'a> {
    /// Index of the sample.
    pub step: usize,
    /// Time of the sample, s.
    pub time: f64,
    /// The motion of the platform.
    pub motion: &'a Motion,
    /// Whether the jerk of the motion is known.
    pub has_jerk: bool,
    /// What rounding of positions may add to velocity and acceleration.
    pub rounding: [f64; 2],
    /// What rounding of orientations may add to angular velocity and acceleration; `None` if the platform does not turn.
    pub turn_rounding: Option<[f64; 2]>,
}

impl Rules<'_> {
    /// Checks all limits at an instant.
    pub fn at(&self, rates: &Rates, largest: &mut Largest, faults: &mut Faults) {
        let Rates { step, time, motion, has_jerk, rounding: [slow, late], turn_rounding } = *rates;
        let check = |of, cable, value: f64, limit, rounding, faults: &mut Faults| {
            Quantity { of, cable, value, limit, rounding }.check(step, time, faults);
        };
        let limits = self.limits;
        check(Limit::Speed, None, motion.velocity.norm(), limits.speed, slow, faults);
        check(Limit::Acceleration, None, motion.acceleration.norm(), limits.acceleration, late, faults);
        if has_jerk {
            check(Limit::Jerk, None, motion.jerk.norm(), limits.jerk, 0.0, faults);
        }
        let [turn, gain] = [motion.angular_velocity.norm(), motion.angular_acceleration.norm()];
        if let Some([slow, late]) = turn_rounding {
            check(Limit::TurnSpeed, None, turn, limits.turn_speed, slow, faults);
            check(Limit::TurnAcceleration, None, gain, limits.turn_acceleration, late, faults);
        }
        let of_arms = turn_rounding.map_or([0.0; 2], |rounding| rounding.map(|of| self.reach() * of));
        let [slow, late] = [slow + of_arms[0], late + of_arms[1]];
        for (name, winding) in self.names.iter().zip(self.winches.windings(motion)) {
            let (speed, a, name) = (winding.speed.abs(), winding.acceleration.abs(), Some(*name));
            check(Limit::CableSpeed, name, speed, limits.cable_speed, slow, faults);
            check(Limit::CableAcceleration, name, a, limits.cable_acceleration, late, faults);
        }
        largest.include(motion, turn_rounding.is_some(), self.winches.windings(motion));
    }

    /// The largest distance of an attachment from the platform's origin, m.
    fn reach(&self) -> f64 {
        self.winches.cables().iter().map(|cable| cable.attachment.coords.norm()).fold(0.0, f64::max)
    }

    /// Checks the mean rates between a sample and the next one: the motion really reaches at least these.
    pub fn means(&self, motion: &Recorded, motions: &[Motion], k: usize, faults: &mut Faults) {
        let (step, time, limits) = (motion.step(k), motion.times[k], self.limits);
        let rounding = RECORDED_ROUNDING / step;
        let rate = |list: &Option<Vec<Vector>>| list.as_ref().map(|list| motion.mean_rate(list, k).norm());
        let turn = motion.orientations.is_some().then(|| motion.mean_turn(k).norm());
        let given = [
            (Limit::Speed, Some(motion.mean_velocity(k).norm()), limits.speed, rounding),
            (Limit::Acceleration, rate(&motion.velocities), limits.acceleration, rounding),
            (Limit::Jerk, rate(&motion.accelerations), limits.jerk, rounding),
            (Limit::TurnSpeed, turn, limits.turn_speed, rounding),
            (Limit::TurnAcceleration, rate(&motion.angular_velocities), limits.turn_acceleration, rounding),
        ];
        for (of, value, limit, rounding) in given {
            let Some(value) = value else { continue };
            Quantity { of, cable: None, value, limit, rounding }.check(k, time, faults);
        }
        let rounding = if turn.is_some() { rounding * (1.0 + self.reach()) } else { rounding };
        let [before, after] = [k, k + 1].map(|k| self.lengths(&motions[k]));
        for (name, (before, after)) in self.names.iter().zip(before.zip(after)) {
            let (of, value) = (Limit::CableSpeed, (after - before).abs() / step);
            Quantity { of, cable: Some(name), value, limit: limits.cable_speed, rounding }.check(k, time, faults);
        }
    }

    fn lengths(&self, motion: &Motion) -> impl Iterator<Item = f64> {
        self.winches.cables().iter().map(move |cable| cable.length(&motion.position, &motion.orientation))
    }

    /// Checks that velocities and accelerations fit the positions between a sample and the next one; `most` is the largest
    /// acceleration of all samples, and the largest angular one.
    pub fn fits(&self, motion: &Recorded, motions: &[Motion], k: usize, most: [f64; 2], faults: &mut Faults) {
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
        let near = k.saturating_sub(1)..(k + 3).min(motion.times.len());
        let nearby = |norm: fn(&Motion) -> f64| motions[near.clone()].iter().map(norm).fold(0.0, f64::max);
        let middle = |list: &[Vector]| 0.5 * (list[k] + list[k + 1]);
        let apart = |list: &[Vector], mean: Vector| (list[k] - mean).norm().max((list[k + 1] - mean).norm());
        if let Some(velocities) = &motion.velocities {
            let found = (motion.mean_velocity(k) - middle(velocities)).norm();
            let allowed = motion.turn(k) + 0.5 * step * nearby(|m| m.acceleration.norm()) + rounding;
            let words = ["velocities", "the change of the position", "m/s"];
            add(FaultKind::Velocity, found, allowed, words);
            let (found, bend) = (apart(velocities, motion.mean_velocity(k)), motion.bend_of_positions(k));
            add(FaultKind::Velocity, found, RECORDED_BEND * bend + 2.0 * rounding, words);
        }
        if let Some(velocities) = &motion.angular_velocities {
            let found = (motion.mean_turn(k) - middle(velocities)).norm();
            let allowed = motion.change_of_turn(k) + 0.5 * step * nearby(|m| m.angular_acceleration.norm()) + rounding;
            let (kind, words) =
                (FaultKind::AngularVelocity, ["angular velocities", "the change of the orientation", "rad/s"]);
            add(kind, found, allowed, words);
            let (found, bend) = (apart(velocities, motion.mean_turn(k)), motion.bend_of_orientations(k));
            add(kind, found, RECORDED_BEND * bend + 2.0 * rounding, words);
        }
        let change = |rate: fn(&Motion) -> Vector| (rate(&motions[k + 1]) - rate(&motions[k])) / step;
        let allowed = |most: f64| RECORDED_ACCELERATION * most + 4.0 * rounding / step;
        if let Some(accelerations) = &motion.accelerations {
            let found = (change(|motion| motion.velocity) - middle(accelerations)).norm();
            let words = ["accelerations", "the change of the velocity", "m/s²"];
            add(FaultKind::Inconsistent, found, allowed(most[0]), words);
        }
        if let Some(accelerations) = &motion.angular_accelerations {
            let found = (change(|motion| motion.angular_velocity) - middle(accelerations)).norm();
            let words = ["angular accelerations", "the change of the angular velocity", "rad/s²"];
            add(FaultKind::Inconsistent, found, allowed(most[1]), words);
        }
    }

    /// Checks the columns of cables at a sample.
    pub fn cables(&self, motion: &Recorded, motions: &[Motion], k: usize, faults: &mut Faults) {
        let (step, time) = (k, motion.times[k]);
        let mut add = |kind, cable, found, expected, allowed, words| {
            Column { kind, cable, found, expected, allowed, words }.check(step, time, faults);
        };
        if let Some(lengths) = &motion.cable_lengths {
            for ((name, expected), found) in self.names.iter().zip(self.lengths(&motions[k])).zip(&lengths[k]) {
                add(FaultKind::CableLength, name, *found, expected, RECORDED_LENGTH, ["length", "m"]);
            }
        }
        let of_turn = |rate: f64| self.reach() * rate;
        let turns_known = motion.orientations.is_none() || motion.angular_velocities.is_some();
        if let (Some(speeds), Some(velocities), true) = (&motion.cable_speeds, &motion.velocities, turns_known) {
            let windings = self.winches.windings(&motions[k]);
            let fastest = velocities[k].norm() + of_turn(motions[k].angular_velocity.norm());
            for ((name, winding), found) in self.names.iter().zip(windings).zip(&speeds[k]) {
                let allowed = RECORDED_RATE * (1.0 + fastest);
                add(FaultKind::CableRate, name, *found, winding.speed, allowed, ["speed", "m/s"]);
            }
        }
        let gains_known = motion.orientations.is_none() || motion.angular_accelerations.is_some() && turns_known;
        let known = motion.velocities.is_some() && gains_known;
        if let (Some(rates), Some(accelerations), true) = (&motion.cable_accelerations, &motion.accelerations, known) {
            let now = &motions[k];
            let (turn, gain) = (now.angular_velocity.norm(), now.angular_acceleration.norm());
            let fastest = accelerations[k].norm() + of_turn(gain + turn * turn) + now.velocity.norm_squared();
            for ((name, winding), found) in self.names.iter().zip(self.winches.windings(now)).zip(&rates[k]) {
                let allowed = RECORDED_RATE * (1.0 + fastest);
                add(FaultKind::CableRate, name, *found, winding.acceleration, allowed, ["acceleration", "m/s²"]);
            }
        }
        let columns = [
            (Limit::CableSpeed, &motion.cable_speeds, self.limits.cable_speed),
            (Limit::CableAcceleration, &motion.cable_accelerations, self.limits.cable_acceleration),
        ];
        for (of, rows, limit) in columns {
            for (name, value) in self.names.iter().zip(rows.iter().flat_map(|rows| &rows[k])) {
                let value = value.abs();
                Quantity { of, cable: Some(name), value, limit, rounding: 0.0 }.check(step, time, faults);
            }
        }
    }

    /// Checks what the winches are commanded at a sample.
    pub fn commands(&self, motion: &Recorded, now: &Motion, k: usize, faults: &mut Faults) {
        let per_metre = |i: usize| self.robot.cables()[i].drum.map_or(0.0, |drum| (drum.gear / drum.radius).abs());
        let of_length = |_, _| RECORDED_LENGTH;
        let of_angle = |i, _| RECORDED_LENGTH * (1.0 + per_metre(i));
        let of_torque = |_, torque: f64| RECORDED_RATE * (1.0 + torque.abs());
        let allowed: [&dyn Fn(usize, f64) -> f64; 3] = [&of_length, &of_angle, &of_torque];
        for (Winch { words, found, expected, .. }, allowed) in
            self.winch_columns(motion, now, k).into_iter().zip(allowed)
        {
            for (i, (found, expected)) in
                found.iter().flat_map(|rows| &rows[k]).zip(expected.unwrap_or_default()).enumerate()
            {
                let (kind, cable, allowed) = (FaultKind::Command, self.names[i], allowed(i, expected));
                Column { kind, cable, found: *found, expected, allowed, words }.check(k, motion.times[k], faults);
            }
        }
    }

    /// Notes on columns of winches that cannot be checked.
    pub fn unchecked_commands(&self, motion: &Recorded, start: &Motion) -> impl Iterator<Item = String> {
        let columns = self.winch_columns(motion, start, 0).into_iter();
        columns
            .filter(|column| column.found.is_some() && column.expected.is_none())
            .map(|Winch { words: [what, _], needs, .. }| format!("the {what} is not checked: that takes {needs}"))
    }

    /// The columns of winches as recorded, and what is expected at a sample.
    fn winch_columns<'m>(&self, motion: &'m Recorded, now: &Motion, k: usize) -> [Winch<'m>; 3] {
        let lengths: Vec<f64> = self.lengths(now).collect();
        let expected = self.robot.commands(&lengths, motion.tensions.as_ref().map(|rows| &rows[k][..]));
        let CommandRows { commands, angles, torques } = &motion.winches;
        let column =
            |words, found: &'m Option<_>, expected, needs| Winch { words, found: found.as_ref(), expected, needs };
        [
            column(["commanded length", "m"], commands, expected.commands, "tensions and the `stiffness` of a cable"),
            column(
                ["angle of the motor", "rad"],
                angles,
                expected.angles,
                "a `drum` of each cable, and tensions if cables stretch",
            ),
            column(["torque of the motor", "N·m"], torques, expected.torques, "tensions and a `drum` of each cable"),
        ]
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
            ("orientation", "rad", motion.orientations.as_ref().map_or(0.0, |list| nearest(&|m| angle(&list[k], m)))),
            ("angular velocity", "rad/s", rate(&motion.angular_velocities, |m| m.angular_velocity)),
            ("angular acceleration", "rad/s²", rate(&motion.angular_accelerations, |m| m.angular_acceleration)),
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

fn angle(orientation: &Rotation, motion: &Motion) -> f64 {
    orientation.angle_to(&motion.orientation)
}

/// Times just before, at, and just after a time, s: the acceleration may jump there.
pub fn around(time: f64) -> [f64; 3] {
    [time - SAME_TIME, time, time + SAME_TIME]
}
