//! The peaks of a timed motion: its largest rates, its range of tensions, and its nearest approach.

use serde::{Deserialize, Serialize};

use super::motion::Motion;
use super::winches::Winding;
use crate::collision::path_check::{self, PathClearance, PathEngine};
use crate::error::Error;
use crate::limits::{INSTANTS_BETWEEN, LEAST_INSTANTS};
use crate::watch::Watch;

/// The largest rates of a motion, and its range of tensions.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Largest {
    /// Speed of the platform's origin, m/s.
    pub speed: f64,
    /// Acceleration of the platform's origin, m/s².
    pub acceleration: f64,
    /// Speed of a cable, m/s.
    pub cable_speed: f64,
    /// Acceleration of a cable, m/s².
    pub cable_acceleration: f64,
    /// Angular speed, rad/s, if the platform turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_speed: Option<f64>,
    /// Angular acceleration, rad/s², if the platform turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_acceleration: Option<f64>,
    /// The smallest and the largest tension of a cable at the samples, N, if tensions are known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tensions: Option<[f64; 2]>,
}

impl Largest {
    /// Takes an instant into account: the motion, whether the platform turns, and the cables.
    pub fn include(&mut self, motion: &Motion, turns: bool, windings: impl Iterator<Item = Winding>) {
        let larger = |known: Option<f64>, value: f64| turns.then(|| known.unwrap_or(0.0).max(value));
        self.speed = self.speed.max(motion.velocity.norm());
        self.acceleration = self.acceleration.max(motion.acceleration.norm());
        self.turn_speed = larger(self.turn_speed, motion.angular_velocity.norm());
        self.turn_acceleration = larger(self.turn_acceleration, motion.angular_acceleration.norm());
        for winding in windings {
            self.cable_speed = self.cable_speed.max(winding.speed.abs());
            self.cable_acceleration = self.cable_acceleration.max(winding.acceleration.abs());
        }
    }

    /// The largest rates and the range of tensions of two motions. Tensions that are known of only one are left out.
    pub fn and(&self, other: &Self) -> Self {
        let larger = |a: Option<f64>, b: Option<f64>| a.into_iter().chain(b).reduce(f64::max);
        let both = self.tensions.zip(other.tensions);
        Largest {
            speed: self.speed.max(other.speed),
            acceleration: self.acceleration.max(other.acceleration),
            cable_speed: self.cable_speed.max(other.cable_speed),
            cable_acceleration: self.cable_acceleration.max(other.cable_acceleration),
            turn_speed: larger(self.turn_speed, other.turn_speed),
            turn_acceleration: larger(self.turn_acceleration, other.turn_acceleration),
            tensions: both.map(|([least, most], [low, high])| [least.min(low), most.max(high)]),
        }
    }

    /// Takes the tensions of all cables at some instants into account, N.
    pub fn include_tensions<'a>(&mut self, rows: impl Iterator<Item = &'a [f64]>) {
        for tension in rows.flatten() {
            let [least, most] = self.tensions.unwrap_or([*tension; 2]);
            self.tensions = Some([least.min(*tension), most.max(*tension)]);
        }
    }
}

/// The nearest approach of a timed motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NearestInTime {
    /// Time of the nearest approach, s.
    pub time: f64,
    /// Gap, m; negative where bodies overlap.
    pub value: f64,
    /// The names of the bodies.
    pub culprits: Vec<String>,
}

/// The instants at which a motion that is known in exact form is measured, with the index of the sample at or before each: its
/// samples, ten or more between two of them, and a thousand or more in all.
pub fn instants(times: &[f64], duration: f64) -> impl Iterator<Item = (usize, f64)> {
    let longest = duration / LEAST_INSTANTS as f64;
    (0..times.len()).flat_map(move |k| {
        // After the motion has ended there is nothing to measure.
        let step = times.get(k + 1).map_or(0.0, |next| next.min(duration) - times[k]);
        let parts = match step > 0.0 {
            true => ((step / longest).ceil() as usize).clamp(INSTANTS_BETWEEN + 1, LEAST_INSTANTS),
            false => 1,
        };
        let time = move |part: usize| if part == 0 { times[k] } else { times[k] + step * part as f64 / parts as f64 };
        (0..parts).map(move |part| (k, time(part)))
    })
}

/// The nearest approach of motions at constant rates between states at some times.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn nearest_in_time<S>(
    engine: &(impl PathEngine<S> + ?Sized),
    times: &[f64],
    states: &[S],
    watch: &Watch,
) -> Result<Option<NearestInTime>, Error> {
    let all: Vec<usize> = (0..engine.checked_conditions().list.len()).collect();
    let found = path_check::nearest_of(engine, &all, states, watch)?;
    Ok(found.map(|found| in_time(times, found)))
}

fn in_time(times: &[f64], PathClearance { value, segment, at, culprits, .. }: PathClearance) -> NearestInTime {
    NearestInTime { time: times[segment] + at * (times[segment + 1] - times[segment]), value, culprits }
}

#[cfg(test)]
mod tests {
    use super::instants;
    use crate::limits::LEAST_INSTANTS;

    #[test]
    fn coarse_samples_are_measured_at_a_thousand_instants() {
        for times in [vec![0.0, 0.25, 0.5], vec![0.0, 1.0], vec![0.0, 10.0], vec![0.0, 0.3, 1e4, 2e4]] {
            let found: Vec<(usize, f64)> = instants(&times, 0.5).collect();
            assert!(found.iter().filter(|(_, time)| *time < 0.5).count() >= LEAST_INSTANTS, "{times:?}");
            assert!(found.windows(2).all(|pair| pair[0].1 < pair[1].1 && pair[0].0 <= pair[1].0), "{times:?}");
            let after = |k: usize, time: f64| times[k] <= time && times.get(k + 1).is_none_or(|next| time < *next);
            assert!(found.iter().all(|(k, time)| after(*k, *time)), "{times:?}");
        }
    }
}
