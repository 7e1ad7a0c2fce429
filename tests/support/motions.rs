//! What timed motions do at many instants, judged without the code that planned them.

use std::sync::Arc;

use cdpr_core::collision::{Checker, Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::model::Scene;
use cdpr_core::trajectory::Trajectory;
use cdpr_core::wrench::TensionQp;

/// The largest excess over each limit, as a share of it, and what else may be wrong with a motion.
#[derive(Debug, Clone, Copy)]
pub struct Worst {
    /// Speed, acceleration, jerk, cable speed and cable acceleration.
    pub limits: [f64; 5],
    /// Tension outside its limits, N.
    pub tension: f64,
    /// Distance from the path beyond the allowed deviation, m.
    pub deviation: f64,
    /// By how much the chord between two instants lacks a required gap, beyond what it may cut off a bend, m.
    pub depth: f64,
    /// Distance of the ends from those of the path, m.
    pub ends: f64,
}

impl Worst {
    pub const NOTHING: Worst =
        Worst { limits: [f64::NEG_INFINITY; 5], tension: 0.0, deviation: f64::NEG_INFINITY, depth: 0.0, ends: 0.0 };

    pub fn or(self, other: Worst) -> Worst {
        Worst {
            limits: std::array::from_fn(|k| self.limits[k].max(other.limits[k])),
            tension: self.tension.max(other.tension),
            deviation: self.deviation.max(other.deviation),
            depth: self.depth.max(other.depth),
            ends: self.ends.max(other.ends),
        }
    }

    /// Whether all limits are kept up to rounding, and nothing is hit.
    pub fn is_sound(&self) -> bool {
        self.limits.iter().all(|excess| *excess <= 1e-9)
            && self.tension <= 0.0
            && self.deviation <= 1e-9
            && self.depth <= 1e-9
            && self.ends <= 1e-9
    }
}

/// A motion at this many equal steps, and at instants within each bend and at the ends of each line. Collisions are judged on
/// the chords between the instants, of which there are at most a hundred thousand of equal duration.
pub fn worst(scene: &Scene, path: &[Point], motion: &Trajectory, steps: u32) -> Worst {
    let depth = deepest_chord(scene, motion, &instants(motion, steps.min(MOST_CHORDS)));
    worst_instant(path, motion, &instants(motion, steps)).or(Worst { depth, ..Worst::NOTHING })
}

fn instants(motion: &Trajectory, steps: u32) -> Vec<f64> {
    let (curve, timing) = (motion.curve(), motion.timing());
    let within = |k: usize| {
        let parts = if curve.pieces()[k].is_line() { 1 } else { PARTS };
        let [from, to] = [curve.starts()[k], curve.starts()[k + 1]];
        (0..=parts).map(move |part| from + (to - from) * f64::from(part) / f64::from(parts))
    };
    let mut times: Vec<f64> = (0..=steps).map(|k| motion.duration() * f64::from(k) / f64::from(steps)).collect();
    times.extend((0..curve.pieces().len()).flat_map(within).map(|s| timing.when(s)));
    times.sort_by(f64::total_cmp);
    times
}

/// The largest excess over limits and deviation at these instants.
fn worst_instant(path: &[Point], motion: &Trajectory, times: &[f64]) -> Worst {
    let (mut solver, mut worst) = (TensionQp::default(), Worst::NOTHING);
    let limits = motion.limits();
    let bounds = motion.winches().tension_limits().unwrap_or(&[]);
    for time in times {
        let sample = motion.sample(&mut solver, *time).unwrap();
        let now = sample.motion;
        let excess = |value: f64, limit: Option<f64>| limit.map_or(f64::NEG_INFINITY, |limit| value / limit - 1.0);
        let most = |of: fn(&cdpr_core::trajectory::Winding) -> f64| sample.windings.iter().map(of).fold(0.0, f64::max);
        let found = [
            excess(now.velocity.norm(), limits.speed),
            excess(now.acceleration.norm(), limits.acceleration),
            excess(now.jerk.norm(), limits.jerk),
            excess(most(|winding| winding.speed.abs()), limits.cable_speed),
            excess(most(|winding| winding.acceleration.abs()), limits.cable_acceleration),
        ];
        let outside = sample.tensions.iter().flatten().zip(bounds).map(|(t, [lo, hi])| (lo - t).max(t - hi));
        let (tension, deviation) = (outside.fold(0.0, f64::max), distance(&now.position, path) - limits.blend());
        worst = worst.or(Worst { limits: found, tension, deviation, ..Worst::NOTHING });
    }
    let ends = [(times[0], path[0]), (times[times.len() - 1], path[path.len() - 1])];
    let missed = ends.map(|(time, end)| (motion.at(time).position - end).norm());
    Worst { ends: missed[0].max(missed[1]), ..worst }
}

/// By how much the chords between these instants lack a required gap, beyond what they may cut off a bend, m.
fn deepest_chord(scene: &Scene, motion: &Trajectory, times: &[f64]) -> f64 {
    let scene = motion.limits().moving(scene).unwrap();
    let engines = [Engine::Cspace, Engine::Gjk].map(|engine| engine_for(&scene, engine, Interference::Exact).unwrap());
    let (curve, timing) = (motion.curve(), motion.timing());
    let ends: Vec<(f64, Point)> = times.iter().map(|time| (timing.at(*time).s, motion.at(*time).position)).collect();
    let beyond = |pair: &[(f64, Point)]| {
        let [(from, a), (to, b)] = [pair[0], pair[1]];
        // A chord may cut off as much of a bend as its curvature explains.
        let curvature = curve.pieces()[curve.piece_at(0.5 * (from + to))].derivative_bounds[1];
        depth(&engines, &a, &b) - curvature * (to - from).powi(2) / 8.0
    };
    ends.windows(2).map(beyond).fold(0.0, f64::max)
}

/// Collisions are judged on chords this fine.
const MOST_CHORDS: u32 = 100_000;

/// Parts of each bend.
const PARTS: u32 = 32;

/// By how much a motion lacks a required gap by either engine, m; infinite if something else is wrong with it.
fn depth(engines: &[Arc<dyn Checker>; 2], from: &Point, to: &Point) -> f64 {
    let depths = engines.iter().filter(|engine| !engine.motion_valid(from, to)).flat_map(|engine| {
        engine
            .violations(from, to)
            .into_iter()
            .map(|violation| violation.margin.map_or(f64::INFINITY, |margin| -margin))
    });
    depths.fold(f64::NEG_INFINITY, f64::max)
}

/// Distance of a point from a path, m.
fn distance(point: &Point, path: &[Point]) -> f64 {
    let from = |pair: &[Point]| {
        let step: Vector = pair[1] - pair[0];
        let share = ((point - pair[0]).dot(&step) / step.norm_squared()).clamp(0.0, 1.0);
        (point - (pair[0] + step * share)).norm()
    };
    path.windows(2).map(from).fold(f64::INFINITY, f64::min)
}
