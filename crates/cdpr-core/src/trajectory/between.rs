//! How close a timed motion comes to its limits, at every instant and not only on a grid.
//!
//! During a time h in which the motion is smooth, a quantity f exceeds the larger of its values at both ends by at most
//! h²/8 max |f''|. [`Rates`] bounds the derivatives of the position, of the turn and of each attachment.

use std::ops::Range;

use super::curve::Curve;
use super::limits::Limits;
use super::motion::{Derivatives, Motion, Rates};
use super::timing::{Phase, Timing};
use super::winches::{Span, TensionShare, Winches, Winding};
use crate::error::Error;
use crate::geometry::Point;
use crate::numerics::{TENSION_HALVINGS, TURNING};
use crate::watch::Watch;
use crate::wrench::TensionQp;

/// A limit that a trajectory keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// Speed of the platform.
    Speed,
    /// Acceleration of the platform.
    Acceleration,
    /// Angular speed of the platform.
    TurnSpeed,
    /// Angular acceleration of the platform.
    TurnAcceleration,
    /// Jerk of the platform.
    Jerk,
    /// Speed of this cable.
    CableSpeed(usize),
    /// Acceleration of this cable.
    CableAcceleration(usize),
    /// The tensions of the cables; this one is nearest to a limit.
    Tension(usize),
}

/// A time in which the motion stays on one piece of the curve and in one phase of its progress.
struct Smooth {
    piece: usize,
    phase: Phase,
    /// s.
    time: f64,
    ends: [Motion; 2],
    rates: Rates,
}

impl Smooth {
    fn new(curve: &Curve, piece: usize, phase: Phase, time: f64) -> Self {
        Self::between(curve, piece, [phase, phase.after(time)], time)
    }

    fn between(curve: &Curve, piece: usize, [phase, end]: [Phase; 2], time: f64) -> Self {
        let ends = [Motion::on(curve, piece, &phase), Motion::on(curve, piece, &end)];
        Smooth { piece, phase, time, ends, rates: Rates::new(&curve.pieces()[piece], &phase, &end, time) }
    }

    /// How much a quantity with this bound of its second derivative exceeds its values at both ends.
    fn sag(&self, second_derivative: f64) -> f64 {
        self.time * self.time / 8.0 * second_derivative
    }

    /// What the proof that tensions exist needs.
    fn span(&self) -> Span<'_> {
        Span { ends: &self.ends, rates: &self.rates, time: self.time }
    }

    fn halves(&self, curve: &Curve) -> [Smooth; 2] {
        let half = 0.5 * self.time;
        [self.phase, self.phase.after(half)].map(|phase| Smooth::new(curve, self.piece, phase, half))
    }
}

/// Calls `visit` with the index of each of some phases and the smooth times within it.
fn for_each_smooth(curve: &Curve, timing: &Timing, phases: Range<usize>, mut visit: impl FnMut(usize, Smooth)) {
    for k in phases {
        let (phase, end) = (&timing.phases()[k], timing.end_of(k));
        // Exactly where the next phase begins, so that everything that depends on the place alone is the same for both phases.
        let to = timing.phases().get(k + 1).map_or_else(|| phase.after(end - phase.time).s, |next| next.s);
        let middle = |from: f64, to: f64| curve.piece_at(0.5 * (from + to));
        let mut now = *phase;
        let (first, last) = (curve.piece_at(phase.s), middle(to.min(curve.end()), to.min(curve.end())));
        for joint in first + 1..=last {
            let s = curve.starts()[joint];
            let leaves = timing.when(s).clamp(now.time, end);
            if s > now.s && s < to && leaves > now.time {
                visit(k, Smooth::new(curve, middle(now.s, s), now, leaves - now.time));
                now = phase.after(leaves - phase.time);
            }
        }
        if end > now.time {
            let (time, piece) = (end - now.time, middle(now.s, to));
            visit(k, Smooth::between(curve, piece, [now, Phase { s: to, ..now.after(time) }], time));
        }
    }
}

/// For each phase of a timing, the largest share of a limit that it uses, and the limit. Shares are those of forces and
/// squared speeds: a motion with a share r keeps the limit if it is slowed down by √r.
pub fn shares(curve: &Curve, timing: &Timing, limits: &Limits, winches: &Winches) -> Vec<(f64, Option<Bound>)> {
    let mut shares = vec![(0.0, None); timing.phases().len()];
    for_each_smooth(curve, timing, 0..timing.phases().len(), |k, smooth| {
        for_each_share(&smooth, limits, winches, |share, bound| {
            if share > shares[k].0 {
                shares[k] = (share, Some(bound));
            }
        });
    });
    shares
}

fn for_each_share(smooth: &Smooth, limits: &Limits, winches: &Winches, mut visit: impl FnMut(f64, Bound)) {
    let [_, _, m3, m4, m5] = smooth.rates.origin;
    let largest = |norm: fn(&Motion) -> f64| norm(&smooth.ends[0]).max(norm(&smooth.ends[1]));
    if let Some(limit) = limits.speed {
        let speed = largest(|motion| motion.velocity.norm()) + smooth.sag(m3);
        visit((speed / limit).powi(2), Bound::Speed);
    }
    if let Some(limit) = limits.acceleration {
        let acceleration = largest(|motion| motion.acceleration.norm()) + smooth.sag(m4);
        visit(acceleration / limit, Bound::Acceleration);
    }
    if let Some(limit) = limits.jerk {
        let jerk = largest(|motion| motion.jerk.norm()) + smooth.sag(m5);
        visit((jerk / limit).powf(2.0 / 3.0), Bound::Jerk);
    }
    if smooth.rates.turns() {
        for_each_turn_share(smooth, limits, &mut visit);
    }
    if limits.cable_speed.is_none() && limits.cable_acceleration.is_none() {
        return;
    }
    let [start, end] = &smooth.ends;
    let held = start.orientation == end.orientation;
    for (cable, line) in winches.cables().iter().enumerate() {
        let arm = line.arm(&start.orientation);
        let before = line.winding(start, &arm);
        let after = line.winding(end, &if held { arm } else { line.arm(&end.orientation) });
        let [third, fourth] = winding_derivatives(&smooth.rates.of_point(&arm), smooth.time, &before, &after);
        if let Some(limit) = limits.cable_speed {
            let speed = before.speed.abs().max(after.speed.abs()) + smooth.sag(third);
            visit((speed / limit).powi(2), Bound::CableSpeed(cable));
        }
        if let Some(limit) = limits.cable_acceleration {
            let acceleration = before.acceleration.abs().max(after.acceleration.abs()) + smooth.sag(fourth);
            visit(acceleration / limit, Bound::CableAcceleration(cable));
        }
    }
}

fn for_each_turn_share(smooth: &Smooth, limits: &Limits, visit: &mut impl FnMut(f64, Bound)) {
    let largest = |norm: fn(&Motion) -> f64| norm(&smooth.ends[0]).max(norm(&smooth.ends[1]));
    let [_, _, jerk, snap] = smooth.rates.turn();
    if let Some(limit) = limits.turn_speed {
        let speed = largest(|motion| motion.angular_velocity.norm()) + smooth.sag(jerk);
        visit((speed / limit).powi(2), Bound::TurnSpeed);
    }
    if let Some(limit) = limits.turn_acceleration {
        let acceleration = largest(|motion| motion.angular_acceleration.norm()) + smooth.sag(snap);
        visit(acceleration / limit, Bound::TurnAcceleration);
    }
}

/// Bounds of the third and fourth time derivative of a cable's length between two instants, given those of its attachment.
fn winding_derivatives([m1, m2, m3, m4, _]: &Derivatives, time: f64, before: &Winding, after: &Winding) -> [f64; 2] {
    let shortest = 0.5 * (before.length + after.length - m1 * time);
    if !(shortest > 0.0) {
        return [f64::INFINITY; 2];
    }
    let [b1, b2, b3] = [m1, m2, m3].map(|m| *m / shortest);
    let turning =
        [TURNING[0] * b1, TURNING[1] * b1 * b1 + b2, TURNING[2] * b1.powi(3) + 3.0 * TURNING[1] * b1 * b2 + b3];
    [m3 + 2.0 * turning[0] * m2 + turning[1] * m1, m4 + 3.0 * turning[0] * m3 + 3.0 * turning[1] * m2 + turning[2] * m1]
}

/// For each phase of a timing, the largest share of the slack at rest that its inertia uses at its ends, over all facets of
/// the available wrenches.
///
/// # Errors
/// As [`without_tensions`].
pub fn tension_shares(curve: &Curve, timing: &Timing, winches: &Winches, watch: &Watch) -> Result<Vec<f64>, Error> {
    let mut shares = vec![0.0_f64; timing.phases().len()];
    for_each_end(curve, timing, winches, watch, |k, _, ends| {
        shares[k] = shares[k].max(ends[0].share).max(ends[1].share);
        Ok(())
    })?;
    Ok(shares)
}

/// Calls `visit` with the index of each phase of a timing, the smooth times within it, and how much of the available wrenches
/// inertia uses at both ends of each.
fn for_each_end(
    curve: &Curve,
    timing: &Timing,
    winches: &Winches,
    watch: &Watch,
    mut visit: impl FnMut(usize, &Smooth, [TensionShare; 2]) -> Result<(), Error>,
) -> Result<(), Error> {
    let (mut smooths, mut motions) = (Vec::new(), Vec::new());
    let last = timing.phases().len();
    for first in (0..last).step_by(BETWEEN_CHECKS) {
        watch.check()?;
        for_each_smooth(curve, timing, first..last.min(first + BETWEEN_CHECKS), |k, smooth| {
            motions.extend(smooth.ends);
            smooths.push((k, smooth));
        });
        let shares = winches.tension_shares(&motions).map_err(|k| not_held(&motions[k].position))?;
        for ((k, smooth), ends) in smooths.iter().zip(shares.chunks_exact(2)) {
            visit(*k, smooth, [ends[0], ends[1]])?;
        }
        smooths.clear();
        motions.clear();
    }
    Ok(())
}

/// The phases of a timing in which it is not proved that tensions within their limits move the platform. Where the slack of the
/// available wrenches is large, a bound proves it; elsewhere, computed tensions do.
///
/// # Errors
/// A place where the cables cannot hold the platform at rest; a solver that reached no answer; [`Error::interrupted`],
/// [`Error::out_of_time`].
pub fn without_tensions(curve: &Curve, timing: &Timing, winches: &Winches, watch: &Watch) -> Result<Vec<usize>, Error> {
    let (mut lacking, mut solver) = (Vec::new(), TensionQp::default());
    if winches.tension_limits().is_none() {
        return Ok(lacking);
    }
    for_each_end(curve, timing, winches, watch, |k, smooth, ends| {
        let sag = winches.sag(&smooth.span());
        if ends[0].slack.min(ends[1].slack) >= sag || lacking.last() == Some(&k) {
            return Ok(());
        }
        watch.check()?;
        if !has_tensions(curve, smooth, winches, &mut solver, TENSION_HALVINGS)? {
            lacking.push(k);
        }
        Ok(())
    })?;
    Ok(lacking)
}

/// The error about a place where no tensions hold the platform at rest.
pub fn not_held(position: &Point) -> Error {
    let at = [position.x, position.y, position.z];
    let problem = format!(
        "found no tensions within the limits that hold the platform at {at:?} m, expected some all along the path"
    );
    Error::invalid("waypoints", problem)
}

/// Number of places that are examined between checks for interruption.
pub const BETWEEN_CHECKS: usize = 256;

/// Whether it is proved that tensions exist during a smooth time, or during both halves of it.
fn has_tensions(
    curve: &Curve,
    smooth: &Smooth,
    winches: &Winches,
    solver: &mut TensionQp,
    halvings: usize,
) -> Result<bool, Error> {
    if winches.hold_between(solver, &smooth.span())? {
        return Ok(true);
    }
    if halvings == 0 {
        return Ok(false);
    }
    let [first, second] = smooth.halves(curve);
    Ok(has_tensions(curve, &first, winches, solver, halvings - 1)?
        && has_tensions(curve, &second, winches, solver, halvings - 1)?)
}
