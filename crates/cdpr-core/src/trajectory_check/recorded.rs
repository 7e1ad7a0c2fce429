//! A timed motion as samples, and what follows from differences between them.

use std::borrow::Cow;

use crate::error::Error;
use crate::geometry::{Point, Pose, Rotation, Vector};
use crate::limits::INSTANTS_BETWEEN;
use crate::model::{CommandRows, Distribution};
use crate::trajectory::{Curve, Motion, Timing};
use crate::trajectory_file::{TrajectoryFile, chord_deviation};

/// The samples of a timed motion from any source. All lists have one entry for each time, and those by cable are in the order of
/// the robot.
///
/// # Example
/// ```
/// use cdpr_core::{Point, Recorded};
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
    /// World-from-platform orientations, if the platform turns.
    pub orientations: Option<Vec<Rotation>>,
    /// Velocities of the platform's origin, m/s, if they are known.
    pub velocities: Option<Vec<Vector>>,
    /// Accelerations of the platform's origin, m/s², if they are known.
    pub accelerations: Option<Vec<Vector>>,
    /// Angular velocities, world axes, rad/s, if they are known.
    pub angular_velocities: Option<Vec<Vector>>,
    /// Angular accelerations, world axes, rad/s², if they are known.
    pub angular_accelerations: Option<Vec<Vector>>,
    /// Lengths of the cables, m, if they are known.
    pub cable_lengths: Option<Vec<Vec<f64>>>,
    /// Rates of the cable lengths, m/s, if they are known.
    pub cable_speeds: Option<Vec<Vec<f64>>>,
    /// Rates of the cable speeds, m/s², if they are known.
    pub cable_accelerations: Option<Vec<Vec<f64>>>,
    /// Tensions of the cables, N, if they are known.
    pub tensions: Option<Vec<Vec<f64>>>,
    /// Which of all tensions that balance the motion these are, if it is known.
    pub tension_distribution: Option<Distribution>,
    /// What the winches are commanded, as far as it is known.
    pub winches: CommandRows,
    /// The path that the motion follows, m, if it is known.
    pub path: Option<Vec<Point>>,
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
            orientations: file
                .orientations
                .is_some()
                .then(|| file.poses().iter().map(|pose| pose.orientation).collect()),
            velocities: vectors(&file.velocities),
            accelerations: vectors(&file.accelerations),
            angular_velocities: file.angular_velocities.as_deref().and_then(vectors),
            angular_accelerations: file.angular_accelerations.as_deref().and_then(vectors),
            cable_lengths: Some(file.cable_lengths.clone()),
            cable_speeds: Some(file.cable_speeds.clone()),
            cable_accelerations: file.cable_accelerations.clone(),
            tensions: file.tensions.clone(),
            tension_distribution: file.tension_distribution,
            winches: CommandRows {
                commands: file.commands.clone(),
                angles: file.angles.clone(),
                torques: file.torques.clone(),
            },
            path: Some(file.waypoints.iter().map(|waypoint| (*waypoint).into()).collect()),
            exact: if has_exact { Some(file.exact()?) } else { None },
        })
    }

    /// The velocities; if they are not known, the slopes of parabolas through three samples each. Such a slope is a weighted
    /// mean of the velocities between these samples, so it never exceeds the largest one.
    pub fn velocities(&self) -> Cow<'_, [Vector]> {
        let derived = || slopes(&self.times, &|k| self.mean_velocity(k));
        self.velocities.as_deref().map_or_else(|| Cow::Owned(derived()), Cow::Borrowed)
    }

    /// The accelerations; if they are not known, the slopes of the velocities, or the second derivatives of parabolas
    /// through three positions each. They are weighted means as well.
    pub fn accelerations(&self) -> Cow<'_, [Vector]> {
        match (&self.accelerations, &self.velocities) {
            (Some(accelerations), _) => Cow::Borrowed(accelerations),
            (None, Some(velocities)) => Cow::Owned(slopes(&self.times, &|k| self.mean_rate(velocities, k))),
            (None, None) => Cow::Owned(self.bending(&|k| self.mean_velocity(k))),
        }
    }

    /// The angular velocities, derived from the orientations as velocities are from positions; zero without orientations.
    pub fn angular_velocities(&self) -> Cow<'_, [Vector]> {
        let derived = || slopes(&self.times, &|k| self.mean_turn(k));
        self.angular_velocities.as_deref().map_or_else(|| Cow::Owned(derived()), Cow::Borrowed)
    }

    /// The angular accelerations, derived as accelerations are; zero without orientations.
    pub fn angular_accelerations(&self) -> Cow<'_, [Vector]> {
        match (&self.angular_accelerations, &self.angular_velocities) {
            (Some(accelerations), _) => Cow::Borrowed(accelerations),
            (None, Some(velocities)) => Cow::Owned(slopes(&self.times, &|k| self.mean_rate(velocities, k))),
            (None, None) => Cow::Owned(self.bending(&|k| self.mean_turn(k))),
        }
    }

    /// The motion at each sample of a platform that has the orientation `held` if it does not turn; the jerk is left out.
    pub fn motions(&self, held: &Rotation) -> Vec<Motion> {
        let (velocities, accelerations) = (self.velocities(), self.accelerations());
        let (turns, gains) = (self.angular_velocities(), self.angular_accelerations());
        let motion = |k: usize| Motion {
            position: self.positions[k],
            orientation: self.orientations.as_ref().map_or(*held, |orientations| orientations[k]),
            velocity: velocities[k],
            acceleration: accelerations[k],
            jerk: Vector::zeros(),
            angular_velocity: turns[k],
            angular_acceleration: gains[k],
        };
        (0..self.times.len()).map(motion).collect()
    }

    /// The poses of the samples of a platform that has the orientation `held` if it does not turn.
    pub fn poses(&self, held: &Rotation) -> Vec<Pose> {
        let turned = |k: usize| self.orientations.as_ref().map_or(*held, |orientations| orientations[k]);
        self.positions.iter().enumerate().map(|(k, position)| Pose::new(*position, turned(k))).collect()
    }

    /// The time after a sample until the next one, s.
    pub fn step(&self, k: usize) -> f64 {
        self.times[k + 1] - self.times[k]
    }

    /// The mean velocity between a sample and the next one, m/s.
    pub fn mean_velocity(&self, k: usize) -> Vector {
        (self.positions[k + 1] - self.positions[k]) / self.step(k)
    }

    /// The mean angular velocity between a sample and the next one, rad/s; zero without orientations.
    pub fn mean_turn(&self, k: usize) -> Vector {
        let Some(orientations) = &self.orientations else { return Vector::zeros() };
        let [from, to] = [k, k + 1].map(|k| Pose::new(Point::origin(), orientations[k]));
        let turn = from.toward(&to);
        turn.axis * (turn.angle / self.step(k))
    }

    /// The mean rate of some values between a sample and the next one.
    pub fn mean_rate(&self, values: &[Vector], k: usize) -> Vector {
        (values[k + 1] - values[k]) / self.step(k)
    }

    /// How much the velocity turns between a sample and the next one, m/s.
    pub fn turn(&self, k: usize) -> f64 {
        self.change(&self.velocities, &|k| self.mean_velocity(k), k)
    }

    /// How much the angular velocity changes between a sample and the next one, rad/s.
    pub fn change_of_turn(&self, k: usize) -> f64 {
        self.change(&self.angular_velocities, &|k| self.mean_turn(k), k)
    }

    fn change(&self, known: &Option<Vec<Vector>>, mean: &dyn Fn(usize) -> Vector, k: usize) -> f64 {
        match known {
            Some(rates) => (rates[k + 1] - rates[k]).norm(),
            None => {
                let last = self.times.len() - 2;
                (mean((k + 1).min(last)) - mean(k.saturating_sub(1))).norm()
            }
        }
    }

    /// How much the mean velocities change around the step from a sample to the next one, m/s, with rest before the start and
    /// after the end. Where they hardly change, no velocity can be far from them.
    pub fn bend_of_positions(&self, k: usize) -> f64 {
        self.bend(&|k| self.mean_velocity(k), k)
    }

    /// How much the mean angular velocities change around the step from a sample to the next one, rad/s, with rest
    /// before the start and after the end.
    pub fn bend_of_orientations(&self, k: usize) -> f64 {
        self.bend(&|k| self.mean_turn(k), k)
    }

    fn bend(&self, mean: &dyn Fn(usize) -> Vector, k: usize) -> f64 {
        // Counted from two steps before the start.
        let steps = 2..self.times.len() + 1;
        let around: [Vector; 5] =
            std::array::from_fn(|j| if steps.contains(&(k + j)) { mean(k + j - 2) } else { Vector::zeros() });
        around.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
    }

    /// How far points of the platform within `reach`, m, of its origin may deviate from their motion at constant rates between a
    /// sample and the next one, m.
    pub fn sag(&self, k: usize, motions: &[Motion], reach: f64) -> f64 {
        let largest = |norm: fn(&Motion) -> f64| norm(&motions[k]).max(norm(&motions[k + 1]));
        let straight = chord_deviation(self.turn(k), largest(|m| m.acceleration.norm()), self.step(k));
        if self.orientations.is_none() {
            return straight;
        }
        let gain = largest(|m| m.angular_acceleration.norm());
        straight + reach * chord_deviation(self.change_of_turn(k), gain, self.step(k))
    }

    /// The cubic curves through positions and velocities, at [`INSTANTS_BETWEEN`] instants between two samples, and for each of
    /// their steps how far the motion may be from the curve, m. `None` if the velocities are not known, or if the platform turns.
    ///
    /// A cubic has the positions and velocities of the motion at both ends. Where the two accelerations differ by at most D
    /// between them, the two positions differ by at most D h²/16 during the time h.
    pub fn smoothed(&self) -> Option<(Recorded, Vec<f64>)> {
        let velocities = self.velocities.as_ref().filter(|_| self.orientations.is_none())?;
        let accelerations = self.accelerations();
        let parts = INSTANTS_BETWEEN + 1;
        let (mut fine, mut away) = (Recorded::default(), Vec::new());
        let (mut rates, mut changes) = (Vec::new(), Vec::new());
        for k in 0..self.times.len() - 1 {
            let (h, mean) = (self.step(k), self.mean_velocity(k));
            let [before, after] = [velocities[k], velocities[k + 1]];
            // The curve is p + h (v u + b u² + c u³) with u from 0 to 1.
            let (b, c) = (mean * 3.0 - before * 2.0 - after, before + after - mean * 2.0);
            let bend = |u: f64| (b * 2.0 + c * (6.0 * u)) / h;
            let differs = [(k, 0.0), (k + 1, 1.0)].map(|(k, u)| (accelerations[k] - bend(u)).norm());
            let away_here = differs[0].max(differs[1]) * h * h / 16.0;
            for part in 0..parts {
                let u = part as f64 / parts as f64;
                fine.times.push(self.times[k] + h * u);
                fine.positions.push(self.positions[k] + (before + (b + c * u) * u) * (h * u));
                rates.push(before + (b * 2.0 + c * (3.0 * u)) * u);
                changes.push(bend(u));
                away.push(away_here);
            }
        }
        fine.times.extend(self.times.last());
        fine.positions.extend(self.positions.last());
        rates.extend(velocities.last());
        changes.extend(accelerations.last());
        Some((Recorded { velocities: Some(rates), accelerations: Some(changes), ..fine }, away))
    }

    /// Second derivatives of parabolas through three values, given the slopes between them; at both ends the value beside it.
    fn bending(&self, slope: &dyn Fn(usize) -> Vector) -> Vec<Vector> {
        let count = self.times.len();
        let inner = |k: usize| (slope(k) - slope(k - 1)) * (2.0 / (self.times[k + 1] - self.times[k - 1]));
        (0..count).map(|k| if count < 3 { Vector::zeros() } else { inner(k.clamp(1, count - 2)) }).collect()
    }
}

/// Slopes of parabolas through three values each, given the slopes between them; at both ends the slopes of lines.
fn slopes(times: &[f64], slope: &dyn Fn(usize) -> Vector) -> Vec<Vector> {
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
