//! The fastest progress along a curve that keeps all limits except the jerk limit.
//!
//! Backward from the end, the largest ṡ² from which the end can still be reached is found at each parameter of a grid;
//! forward from the start, the largest acceleration that stays below it is taken. Between two parameters s̈ is constant, and
//! the limits at both hold.
//!
//! Source: H. Pham and Q.-C. Pham, "A new approach to time-optimal path parameterization based on reachability analysis",
//! IEEE Transactions on Robotics 34(3), 2018, doi:10.1109/TRO.2018.2819195.

use std::ops::Range;

use super::curve::Curve;
use super::rows::{Interval, Rows};
use super::timing::{Phase, Timing};
use crate::limits::TIMING_INTERVALS;

/// Minimum number of intervals on a line and on a bend.
const LEAST_INTERVALS: [usize; 2] = [8, 24];

/// Minimum number of intervals between two stops.
const LEAST_OF_STRETCH: f64 = 100.0;

/// The parameters of some pieces of a curve at which limits are evaluated, each with its piece. Joints are among them.
pub fn grid(curve: &Curve, pieces: Range<usize>) -> Vec<(usize, f64)> {
    let mut grid = vec![(pieces.start, curve.starts()[pieces.start])];
    let stretch = curve.starts()[pieces.end] - curve.starts()[pieces.start];
    let per_metre = (TIMING_INTERVALS as f64 / curve.end()).max(LEAST_OF_STRETCH / stretch);
    for k in pieces {
        let piece = &curve.pieces()[k];
        let count = ((piece.length * per_metre).round() as usize).max(LEAST_INTERVALS[usize::from(!piece.is_line())]);
        let [from, to] = [curve.starts()[k], curve.starts()[k + 1]];
        let at = |i: usize| if i == count { to } else { from + (to - from) * i as f64 / count as f64 };
        grid.extend((1..=count).map(|i| (k, at(i))));
    }
    grid
}

/// The fastest progress from rest to rest along a grid, given the limits at its parameters. An error is a parameter from
/// which the platform cannot move.
pub fn fastest(grid: &[f64], rows: &[Rows]) -> Result<Timing, f64> {
    let last = grid.len() - 1;
    let mut interval = Interval::default();
    let mut most = vec![0.0; grid.len()];
    for k in (1..last).rev() {
        interval.set(&rows[k], &rows[k + 1], grid[k + 1] - grid[k], most[k + 1]);
        most[k] = interval.most_x();
    }
    let mut squared = vec![0.0; grid.len()];
    for k in 0..last {
        let step = grid[k + 1] - grid[k];
        interval.set(&rows[k], &rows[k + 1], step, most[k + 1]);
        let next = squared[k] + 2.0 * step * interval.most_u(squared[k]);
        squared[k + 1] = next.clamp(0.0, most[k + 1]);
        if squared[k] + squared[k + 1] <= 0.0 {
            return Err(grid[k]);
        }
    }
    Ok(timed(grid, &squared))
}

/// The timing for squared speeds on a grid.
fn timed(grid: &[f64], squared: &[f64]) -> Timing {
    let (mut phases, mut time) = (Vec::with_capacity(grid.len()), 0.0);
    for k in 0..grid.len() - 1 {
        let step = grid[k + 1] - grid[k];
        let speeds = [squared[k].sqrt(), squared[k + 1].sqrt()];
        let acceleration = (squared[k + 1] - squared[k]) / (2.0 * step);
        phases.push(Phase { time, s: grid[k], speed: speeds[0], acceleration, jerk: 0.0 });
        time += 2.0 * step / (speeds[0] + speeds[1]);
    }
    Timing::new(phases, time)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use crate::trajectory::rows::{Ellipse, Row};

    /// A straight line of 1 m under these limits of speed and acceleration.
    fn straight(speed: f64, acceleration: f64) -> Timing {
        let grid: Vec<f64> = (0..=100).map(|k| k as f64 / 100.0).collect();
        let ellipse = Ellipse { first: Vector::x(), second: Vector::zeros(), radius: acceleration };
        let row = Row { a: 0.0, b: 1.0, c: speed * speed };
        let rows = vec![Rows { linear: vec![row], ellipse: Some(ellipse), turn: None }; grid.len()];
        fastest(&grid, &rows).unwrap()
    }

    #[test]
    fn a_straight_line_takes_the_time_of_a_trapezoid() {
        // To 1 m/s with 2 m/s² in 0.25 m, for the other 0.5 m at this speed, and down again.
        let timing = straight(1.0, 2.0);
        assert!((timing.duration() - 1.5).abs() < 1e-9, "{}", timing.duration());
        assert!((timing.at(0.75).s - 0.5).abs() < 1e-9);
        // Without reaching 2 m/s: a triangle.
        assert!((straight(2.0, 2.0).duration() - 2.0_f64.sqrt()).abs() < 1e-9);
    }
}
