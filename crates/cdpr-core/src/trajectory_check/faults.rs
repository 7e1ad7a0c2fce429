//! Faults of a motion, and when they occur.

use std::collections::HashMap;

use serde::Serialize;

use crate::trajectory::Limit;

/// Kinds of faults.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum FaultKind {
    /// The platform is farther from its path than allowed.
    Deviation,
    /// A condition of the scene is broken, such as a collision.
    Condition,
    /// The velocities do not fit the positions.
    Velocity,
    /// The angular velocities do not fit the orientations.
    AngularVelocity,
    /// The accelerations, or angular accelerations, do not fit the velocities.
    Inconsistent,
    /// The samples differ from the exact form of the motion.
    NotExact,
    /// The length of a cable is not that of the robot at this position.
    CableLength,
    /// The speed of a cable does not fit the motion of the platform.
    CableRate,
    /// The commanded length, angle or torque of a winch does not fit the length and tension of its cable.
    Command,
    /// The tensions do not balance weight, load and inertia.
    Balance,
    /// The tensions balance, but are not those that the motion or the robot names.
    TensionDistribution,
    /// No tensions within the limits balance weight, load and inertia.
    NoTensions,
    /// Less than the required wrench margin is left.
    WrenchMargin,
    /// A limit is exceeded.
    #[serde(untagged)]
    Limit(Limit),
}

impl FaultKind {
    /// Whether faults of all culprits are reported as one that names the worst: a wrong position, for example, affects
    /// all cables.
    fn is_one_of_many(self) -> bool {
        matches!(
            self,
            FaultKind::CableLength | FaultKind::CableRate | FaultKind::Command | FaultKind::TensionDistribution
        )
    }
}

/// A fault of a motion, during a time without interruption.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fault {
    /// Time of the worst instant of the fault, s.
    pub time: f64,
    /// Time of the first instant of the fault, s.
    pub from: f64,
    /// Time of the last instant of the fault, s.
    pub to: f64,
    /// Kind of the fault.
    pub kind: FaultKind,
    /// The names of those involved, such as a cable and an obstacle.
    pub culprits: Vec<String>,
    /// The value found, in SI units, if it is a number.
    pub found: Option<f64>,
    /// The largest allowed value, in SI units, if it is a number.
    pub limit: Option<f64>,
    /// Description with the value found and the one allowed, without the time.
    pub message: String,
}

/// One instant of a fault.
pub struct Instant<'a> {
    /// Index of the instant; neighbouring ones make one fault.
    pub step: usize,
    /// Time of the instant, s.
    pub time: f64,
    /// Kind of the fault.
    pub kind: FaultKind,
    /// The names of those involved.
    pub culprits: &'a [&'a str],
    /// The value found.
    pub found: Option<f64>,
    /// The largest allowed value.
    pub limit: Option<f64>,
    /// Severity, to compare instants of the same fault.
    pub excess: f64,
}

/// Collects faults and joins those of neighbouring instants.
#[derive(Default)]
pub struct Faults {
    list: Vec<Fault>,
    /// For each kind and culprits, the index of the latest fault, its last step, and its severity.
    latest: HashMap<(FaultKind, Vec<String>), (usize, usize, f64)>,
}

impl Faults {
    /// Adds an instant; `message` is called only if this is the worst one so far.
    pub fn add(&mut self, instant: &Instant, message: impl FnOnce() -> String) {
        let culprits: Vec<String> = instant.culprits.iter().map(ToString::to_string).collect();
        let key = (instant.kind, if instant.kind.is_one_of_many() { Vec::new() } else { culprits.clone() });
        if let Some((index, last, worst)) =
            self.latest.get_mut(&key).filter(|(_, last, _)| instant.step.abs_diff(*last) <= 1)
        {
            let fault = &mut self.list[*index];
            (*last, fault.to) = (instant.step, fault.to.max(instant.time));
            if instant.excess > *worst {
                *worst = instant.excess;
                (fault.time, fault.found, fault.limit) = (instant.time, instant.found, instant.limit);
                (fault.message, fault.culprits) = (message(), culprits);
            }
            return;
        }
        let time = instant.time;
        self.list.push(Fault {
            time,
            from: time,
            to: time,
            kind: instant.kind,
            culprits,
            found: instant.found.filter(|number| number.is_finite()),
            limit: instant.limit,
            message: message(),
        });
        self.latest.insert(key, (self.list.len() - 1, instant.step, instant.excess));
    }

    /// Whether there are any faults of a kind.
    pub fn any(&self, kind: FaultKind) -> bool {
        self.list.iter().any(|fault| fault.kind == kind)
    }

    /// All faults in order of time.
    pub fn sorted(mut self) -> Vec<Fault> {
        self.list.sort_by(|a, b| a.from.total_cmp(&b.from));
        self.list
    }
}

/// A number with up to six decimals.
pub fn number(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn instant(step: usize, excess: f64) -> Instant<'static> {
        let (found, limit) = (Some(1.0 + excess), Some(1.0));
        Instant { step, time: step as f64, kind: FaultKind::Limit(Limit::Speed), culprits: &[], found, limit, excess }
    }

    #[test]
    fn neighbouring_instants_are_one_fault_that_names_the_worst() {
        let mut faults = Faults::default();
        for (step, excess) in [(3, 0.1), (4, 0.3), (5, 0.2), (9, 0.1)] {
            faults.add(&instant(step, excess), || format!("{excess}"));
        }
        assert!(faults.any(FaultKind::Limit(Limit::Speed)) && !faults.any(FaultKind::Limit(Limit::Jerk)));
        let faults = faults.sorted();
        assert_eq!(faults.len(), 2);
        assert_eq!((faults[0].from, faults[0].time, faults[0].to), (3.0, 4.0, 5.0));
        assert_eq!((faults[0].found, faults[0].message.as_str()), (Some(1.3), "0.3"));
        assert_eq!(number(1.31), "1.31");
    }
}
