//! How close a timed motion comes to its limits, at every instant and not only on a grid.
//!
//! During a time h in which the motion is smooth, a quantity f exceeds the larger of its values at both ends by at most
//! h²/8 max |f''|. [`Rates`] bounds the derivatives of the position, of the turn and of each attachment.

use std::collections::HashSet;
use std::ops::Range;

use super::curve::Curve;
use super::limits::Limit;
use super::motion::{Derivatives, Motion, Rates};
use super::timing::{Phase, Timing};
use super::winches::{Line, RecentTensions, Span, TensionShare, Winches, Winding};
use crate::error::Error;
use crate::geometry::Point;
use crate::limits::TENSION_PARTS;
use crate::model::spec::MotionSpec;
use crate::tolerances::TURNING;
use crate::watch::Watch;

/// A limit, and the index of the cable that reaches it, for limits of cables.
pub type Reached = (Limit, Option<usize>);

/// A time in which the motion stays on one piece of the curve and in one phase of its progress.
struct Smooth {
    piece: usize,
    phase: Phase,
    /// Duration, s.
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

    /// How much a quantity with this bound of its second derivative can exceed its values at both ends.
    fn sag(&self, second_derivative: f64) -> f64 {
        self.time * self.time / 8.0 * second_derivative
    }

    /// The input of the proof that tensions exist.
    fn span(&self) -> Span<'_> {
        Span { ends: &self.ends, rates: &self.rates, time: self.time }
    }

    /// The state that the proof that tensions exist depends on, as bits.
    fn state(&self) -> [u64; 6] {
        let Phase { s, speed, acceleration, jerk, .. } = self.phase;
        let [s, speed, acceleration, jerk, time] = [s, speed, acceleration, jerk, self.time].map(f64::to_bits);
        [self.piece as u64, s, speed, acceleration, jerk, time]
    }

    /// Equal parts of this time.
    fn parts(&self, curve: &Curve, count: usize) -> Vec<Smooth> {
        let at = |k: usize| self.phase.after(self.time * k as f64 / count as f64);
        let part = |k: usize| Smooth::between(curve, self.piece, [at(k), at(k + 1)], self.time / count as f64);
        (0..count).map(part).collect()
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
pub fn shares(curve: &Curve, timing: &Timing, limits: &MotionSpec, winches: &Winches) -> Vec<(f64, Option<Reached>)> {
    let mut shares = vec![(0.0, None); timing.phases().len()];
    for_each_smooth(curve, timing, 0..timing.phases().len(), |k, smooth| {
        for_each_share(&smooth, limits, winches, |share, reached| {
            if share > shares[k].0 {
                shares[k] = (share, Some(reached));
            }
        });
    });
    shares
}

fn for_each_share(smooth: &Smooth, limits: &MotionSpec, winches: &Winches, mut visit: impl FnMut(f64, Reached)) {
    let [_, _, m3, m4, m5] = smooth.rates.origin;
    let largest = |norm: fn(&Motion) -> f64| norm(&smooth.ends[0]).max(norm(&smooth.ends[1]));
    if let Some(limit) = limits.speed {
        let speed = largest(|motion| motion.velocity.norm()) + smooth.sag(m3);
        visit((speed / limit).powi(2), (Limit::Speed, None));
    }
    if let Some(limit) = limits.acceleration {
        let acceleration = largest(|motion| motion.acceleration.norm()) + smooth.sag(m4);
        visit(acceleration / limit, (Limit::Acceleration, None));
    }
    if let Some(limit) = limits.jerk {
        let jerk = largest(|motion| motion.jerk.norm()) + smooth.sag(m5);
        visit((jerk / limit).powf(2.0 / 3.0), (Limit::Jerk, None));
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
        if line.pulley.is_some() {
            let beyond = beyond_round_pulley(smooth, line);
            for (limit, of, rate, beyond) in [
                (limits.cable_speed, Limit::CableSpeed, [before.speed, after.speed], beyond[0]),
                (
                    limits.cable_acceleration,
                    Limit::CableAcceleration,
                    [before.acceleration, after.acceleration],
                    beyond[1],
                ),
            ] {
                let Some(limit) = limit else { continue };
                let share = (rate[0].abs().max(rate[1].abs()) + beyond) / limit;
                visit(if of == Limit::CableSpeed { share * share } else { share }, (of, Some(cable)));
            }
            continue;
        }
        let [third, fourth] = winding_derivatives(&smooth.rates.of_point(&arm), smooth.time, &before, &after);
        if let Some(limit) = limits.cable_speed {
            let speed = before.speed.abs().max(after.speed.abs()) + smooth.sag(third);
            visit((speed / limit).powi(2), (Limit::CableSpeed, Some(cable)));
        }
        if let Some(limit) = limits.cable_acceleration {
            let acceleration = before.acceleration.abs().max(after.acceleration.abs()) + smooth.sag(fourth);
            visit(acceleration / limit, (Limit::CableAcceleration, Some(cable)));
        }
    }
}

fn for_each_turn_share(smooth: &Smooth, limits: &MotionSpec, visit: &mut impl FnMut(f64, Reached)) {
    let largest = |norm: fn(&Motion) -> f64| norm(&smooth.ends[0]).max(norm(&smooth.ends[1]));
    let [_, _, jerk, snap] = smooth.rates.turn();
    if let Some(limit) = limits.turn_speed {
        let speed = largest(|motion| motion.angular_velocity.norm()) + smooth.sag(jerk);
        visit((speed / limit).powi(2), (Limit::TurnSpeed, None));
    }
    if let Some(limit) = limits.turn_acceleration {
        let acceleration = largest(|motion| motion.angular_acceleration.norm()) + smooth.sag(snap);
        visit(acceleration / limit, (Limit::TurnAcceleration, None));
    }
}

/// How much speed and acceleration of a cable that runs round a pulley can exceed their values at both ends; infinite if it may not
/// leave the pulley. With |t'| and |t''| bounded for its direction t, the third derivative of the length is that of t·x' twice. The
/// direction has no bounded third derivative across the axis, so the bound of the acceleration is one of first order.
fn beyond_round_pulley(smooth: &Smooth, line: &Line) -> [f64; 2] {
    let arms = smooth.ends.each_ref().map(|motion| line.arm(&motion.orientation));
    let [m1, m2, m3, ..] = smooth.rates.of_point(&arms[0]);
    let [before, after] = [0, 1].map(|k| line.leeway(&smooth.ends[k].position, &arms[k]));
    let Some(turning) = before.between(after, m1 * smooth.time).turning() else { return [f64::INFINITY; 2] };
    let third = m3 + 3.0 * turning.first * m1 * m2 + turning.second * m1.powi(3);
    [smooth.sag(third), 0.5 * smooth.time * third]
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

/// For each phase of a timing, the largest share of the slack at rest that inertia uses at the ends of the phase, over
/// all facets of the available wrenches.
///
/// # Errors
/// The errors of [`without_tensions`].
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

/// Smooth times, as bits, during which it is proved that tensions exist.
pub type Proved = HashSet<[u64; 6]>;

/// The phases of a timing in which it is not proved that tensions within their limits move the platform. Where the slack of the
/// available wrenches is large, a bound proves it; elsewhere, computed tensions do. What is already proved is not
/// proved again: one round of planning differs from the one before in few places.
///
/// # Errors
/// A place where the cables cannot hold the platform at rest; a solver that reached no answer; [`Error::interrupted`],
/// [`Error::out_of_time`].
pub fn without_tensions(
    curve: &Curve,
    timing: &Timing,
    winches: &Winches,
    proved: &mut Proved,
    watch: &Watch,
) -> Result<Vec<usize>, Error> {
    let (mut lacking, mut solver) = (Vec::new(), RecentTensions::default());
    if winches.tension_limits().is_none() {
        return Ok(lacking);
    }
    for_each_end(curve, timing, winches, watch, |k, smooth, ends| {
        let slack = [ends[0].slack, ends[1].slack];
        if slack[0].min(slack[1]) >= winches.sag(&smooth.span())
            || lacking.last() == Some(&k)
            || proved.contains(&smooth.state())
        {
            return Ok(());
        }
        watch.check()?;
        let spare = winches.spare(&smooth.span());
        if has_tensions(curve, (smooth, slack, spare), winches, &mut solver, TENSION_PARTS)? {
            proved.insert(smooth.state());
        } else {
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
        "found no tensions within the limits that hold the platform at {at:?} m, with room to prove it, expected some all along \
         the path"
    );
    Error::invalid("waypoints", problem)
}

/// Number of places that are examined between checks for interruption.
pub const BETWEEN_CHECKS: usize = 256;

/// Whether it is proved that tensions exist during a smooth time, or during all parts of it, given the slack at both
/// ends and a lower bound of the additional slack.
///
/// Slack may drop between two ends by a bound that grows with the time, and computed tensions may fall short by a bound
/// that grows with its square. So the number of parts that each proof needs is known when it fails, and the smaller one
/// is tried.
fn has_tensions(
    curve: &Curve,
    (smooth, slack, spare): (&Smooth, [f64; 2], f64),
    winches: &Winches,
    solver: &mut RecentTensions,
    most_parts: usize,
) -> Result<bool, Error> {
    let span = smooth.span();
    let left = slack[0].min(slack[1]) + spare;
    let by_slack = if left > 0.0 { winches.sag(&span) / left } else { f64::INFINITY };
    if by_slack <= 1.0 {
        return Ok(true);
    }
    let mut by_tensions = f64::INFINITY;
    if by_slack > CHEAP_PARTS {
        by_tensions = winches.hold_between(solver, &span)?;
        if by_tensions <= 1.0 {
            return Ok(true);
        }
    }
    let parts = (by_slack.min(by_tensions) * MORE_PARTS).ceil().max(2.0);
    if !(parts <= most_parts as f64) {
        return Ok(false);
    }
    let parts = smooth.parts(curve, parts as usize);
    let joints: Vec<Motion> = parts[1..].iter().map(|part| part.ends[0]).collect();
    let shares = winches.tension_shares(&joints).map_err(|k| not_held(&joints[k].position))?;
    let slacks: Vec<f64> =
        [slack[0]].into_iter().chain(shares.iter().map(|share| share.slack)).chain([slack[1]]).collect();
    for (part, slack) in parts.iter().zip(slacks.windows(2)) {
        let part = (part, [slack[0], slack[1]], spare);
        if !has_tensions(curve, part, winches, solver, most_parts / parts.len())? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Up to this many parts, a proof by slack takes less time than one by computed tensions.
const CHEAP_PARTS: f64 = 12.0;

/// Factor on the number of parts that a bound requires, since the parts differ from each other.
const MORE_PARTS: f64 = 1.1;
