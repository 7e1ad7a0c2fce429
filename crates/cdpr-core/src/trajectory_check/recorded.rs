//! A timed motion as samples, and what follows from differences between them.

use std::borrow::Cow;

use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::trajectory::{Curve, Timing};
use crate::trajectory_file::{TrajectoryFile, chord_deviation};

/// The samples of a timed motion from any source. All lists have one entry for each time, and those by cable are in the order of
/// the robot.
///
/// # Example
/// ```
/// use cdpr_core::{geometry::Point, trajectory_check::Recorded};
/// let positions = [0.0, 0.1, 0.3].map(|x| Point::new(x, 1.0, 1.0)).to_vec();
/// let motion = Recorded { times: vec![0.0, 0.1, 0.2], positions, ..Recorded::default() };
/// let speeds: Vec<f64> = motion.velocities().iter().map(|v| (v.norm() * 1e6).round() / 1e6).collect();
/// assert_eq!(speeds, [1.0, 1.5, 2.0]);
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recorded {
    /// Times, increasing, s; at least two.
    pub times: Vec<f64>,
    /// Positions of the platform's origin, m.
    pub positions: Vec<Point>,
    /// Its velocities, m/s, if they are known.
    pub velocities: Option<Vec<Vector>>,
    /// Its accelerations, m/s², if they are known.
    pub accelerations: Option<Vec<Vector>>,
    /// Lengths of the cables, m, if they are known.
    pub cable_lengths: Option<Vec<Vec<f64>>>,
    /// Their rates, m/s, if they are known.
    pub cable_speeds: Option<Vec<Vec<f64>>>,
    /// Tensions of the cables, N, if they are known.
    pub tensions: Option<Vec<Vec<f64>>>,
    /// The motion in exact form, if it is known; its time begins at 0.
    pub exact: Option<(Curve, Timing)>,
}

impl Recorded {
    /// The samples of a trajectory file that has been checked.
    ///
    /// # Errors
    /// A curve or timing that planning does not write.
    pub fn of(file: &TrajectoryFile) -> Result<Self, Error> {
        let vectors = |rows: &[[f64; 3]]| Some(rows.iter().map(|row| Vector::from(*row)).collect());
        let has_exact = file.curve.is_some() || file.timing.is_some();
        Ok(Recorded {
            times: file.times.clone(),
            positions: file.points(),
            velocities: vectors(&file.velocities),
            accelerations: vectors(&file.accelerations),
            cable_lengths: Some(file.cable_lengths.clone()),
            cable_speeds: Some(file.cable_speeds.clone()),
            tensions: file.tensions.clone(),
            exact: if has_exact { Some(file.exact()?) } else { None },
        })
    }

    /// The velocities; if they are not known, the slopes of parabolas through three samples each. Such a slope is a weighted
    /// mean of the velocities between these samples, so it never exceeds the largest one.
    pub fn velocities(&self) -> Cow<'_, [Vector]> {
        let derived = || derivative(&self.times, &self.positions.iter().map(|p| p.coords).collect::<Vec<_>>());
        self.velocities.as_deref().map_or_else(|| Cow::Owned(derived()), Cow::Borrowed)
    }

    /// The accelerations; if they are not known, the slopes of the velocities, or the second derivatives of parabolas
    /// through three positions each. They are weighted means as well.
    pub fn accelerations(&self) -> Cow<'_, [Vector]> {
        match (&self.accelerations, &self.velocities) {
            (Some(accelerations), _) => Cow::Borrowed(accelerations),
            (None, Some(velocities)) => Cow::Owned(derivative(&self.times, velocities)),
            (None, None) => Cow::Owned(self.bending()),
        }
    }

    /// The time after a sample until the next one, s.
    pub fn step(&self, k: usize) -> f64 {
        self.times[k + 1] - self.times[k]
    }

    /// The mean velocity between a sample and the next one, m/s.
    pub fn mean_velocity(&self, k: usize) -> Vector {
        (self.positions[k + 1] - self.positions[k]) / self.step(k)
    }

    /// How much the velocity turns between a sample and the next one, m/s.
    pub fn turn(&self, k: usize) -> f64 {
        match &self.velocities {
            Some(velocities) => (velocities[k + 1] - velocities[k]).norm(),
            None => {
                let last = self.times.len() - 2;
                (self.mean_velocity((k + 1).min(last)) - self.mean_velocity(k.saturating_sub(1))).norm()
            }
        }
    }

    /// How far the motion may deviate from the straight line between a sample and the next one, m.
    pub fn sag(&self, k: usize, accelerations: &[Vector]) -> f64 {
        let acceleration = accelerations[k].norm().max(accelerations[k + 1].norm());
        chord_deviation(self.turn(k), acceleration, self.step(k))
    }

    /// Second derivatives of parabolas through three positions; at the ends those beside them.
    fn bending(&self) -> Vec<Vector> {
        let count = self.times.len();
        let inner = |k: usize| {
            let slopes = [self.mean_velocity(k - 1), self.mean_velocity(k)];
            (slopes[1] - slopes[0]) * (2.0 / (self.times[k + 1] - self.times[k - 1]))
        };
        (0..count).map(|k| if count < 3 { Vector::zeros() } else { inner(k.clamp(1, count - 2)) }).collect()
    }
}

/// Slopes of parabolas through three values each; at both ends the slopes of lines.
fn derivative(times: &[f64], values: &[Vector]) -> Vec<Vector> {
    let slope = |k: usize| (values[k + 1] - values[k]) / (times[k + 1] - times[k]);
    let last = times.len() - 1;
    let at = |k: usize| match k {
        0 => slope(0),
        k if k == last => slope(last - 1),
        k => {
            let [before, after] = [times[k] - times[k - 1], times[k + 1] - times[k]];
            (slope(k - 1) * after + slope(k) * before) / (before + after)
        }
    };
    (0..=last).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x = t² at uneven times.
    fn parabola() -> Recorded {
        let times = vec![0.0, 0.1, 0.3, 0.4];
        let positions = times.iter().map(|t| Point::new(t * t, 0.0, 0.0)).collect();
        Recorded { times, positions, ..Recorded::default() }
    }

    #[test]
    fn differences_of_a_parabola_are_exact() {
        let motion = parabola();
        for k in 1..3 {
            assert!((motion.velocities()[k].x - 2.0 * motion.times[k]).abs() < 1e-12);
        }
        assert!(motion.accelerations().iter().all(|a| (a.x - 2.0).abs() < 1e-12));
        let velocities = motion.times.iter().map(|t| Vector::new(2.0 * t, 0.0, 0.0)).collect();
        let motion = Recorded { velocities: Some(velocities), ..motion };
        assert!(motion.accelerations().iter().all(|a| (a.x - 2.0).abs() < 1e-12));
    }

    #[test]
    fn two_samples_are_a_motion_at_constant_speed() {
        let positions = vec![Point::new(0.0, 0.0, 0.0), Point::new(0.0, 0.0, 1.0)];
        let motion = Recorded { times: vec![1.0, 3.0], positions, ..Recorded::default() };
        assert_eq!(motion.velocities()[0], Vector::new(0.0, 0.0, 0.5));
        assert_eq!((motion.accelerations()[1], motion.turn(0)), (Vector::zeros(), 0.0));
    }
}
