//! The timing along a curve with stops, under all limits at every instant.

use std::ops::Range;

use rayon::prelude::*;

use super::between::{BETWEEN_CHECKS, Proved, not_held, shares, tension_shares, without_tensions};
use super::corners::{Corner, Passing};
use super::curve::Curve;
use super::fastest::{fastest, grid};
use super::jet::Jet;
use super::rows::{Row, Rows};
use super::timing::Timing;
use super::winches::Winches;
use crate::error::{Error, ErrorClass};
use crate::geometry::Point;
use crate::limits::TIMING_ROUNDS;
use crate::model::spec::MotionSpec;
use crate::tolerances::{TENSION_EXCESS, TIMING_EXCESS};
use crate::watch::Watch;

/// A curve between its stops, and the limits on grids of its parameters.
#[derive(Clone)]
pub struct Schedule<'a> {
    curve: &'a Curve,
    limits: &'a MotionSpec,
    winches: &'a Winches,
    stretches: Vec<Stretch>,
}

/// The curve between two rests.
#[derive(Clone)]
struct Stretch {
    grid: Vec<f64>,
    rows: Vec<Rows>,
}

impl Stretch {
    /// The limits on the grid of some pieces of a curve.
    fn new(
        curve: &Curve,
        pieces: Range<usize>,
        limits: &MotionSpec,
        winches: &Winches,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let places = grid(curve, pieces);
        let jets: Vec<Jet> = places.iter().map(|(piece, s)| curve.on_piece(*piece, *s)).collect();
        let mut rows = Vec::with_capacity(jets.len());
        for some in jets.chunks(BETWEEN_CHECKS) {
            watch.check()?;
            some.iter().try_for_each(|jet| winches.all_leave_pulleys(&jet.position, &jet.orientation))?;
            rows.extend(Rows::along(some, limits, winches).map_err(|k| not_held(&some[k].position))?);
        }
        if let Some(k) = unlimited_from(curve, &places, &rows) {
            return Err(unlimited(&jets[k].position));
        }
        Ok(Stretch { grid: places.into_iter().map(|(_, s)| s).collect(), rows })
    }
}

/// The first place of a stretch on which nothing limits how fast the progress accelerates: the whole stretch, or a line on which the
/// platform turns.
fn unlimited_from(curve: &Curve, places: &[(usize, f64)], rows: &[Rows]) -> Option<usize> {
    if !rows.iter().any(Rows::limits_acceleration) {
        return Some(0);
    }
    let (mut start, turns) = (0, |piece: usize| curve.pieces()[piece].turns());
    for some in places.chunk_by(|a, b| a.0 == b.0) {
        let own = start..start + some.len();
        if turns(some[0].0) && !rows[own.clone()].iter().any(Rows::limits_acceleration) {
            return Some(own.start);
        }
        start = own.end;
    }
    None
}

impl<'a> Schedule<'a> {
    /// The limits along a curve that stops at some corners.
    ///
    /// # Errors
    /// A place where the cables cannot hold the platform; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn new(
        curve: &'a Curve,
        corners: &[Corner],
        limits: &'a MotionSpec,
        winches: &'a Winches,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let stops = corners.iter().filter(|corner| corner.passing == Passing::Stop);
        let mut rests = vec![0];
        rests.extend(stops.map(|corner| curve.piece_at(corner.at)).filter(|piece| *piece > 0));
        rests.push(curve.pieces().len());
        // With a jerk limit, accelerations far above the useful ones need no limit of their own.
        let capped = limits.jerk.map(|jerk| {
            let most = MORE_THAN_USEFUL * useful_acceleration(jerk, curve.length());
            MotionSpec { acceleration: Some(limits.acceleration.map_or(most, |given| given.min(most))), ..*limits }
        });
        let capped = capped.as_ref().unwrap_or(limits);
        let stretch = |pair: &[usize]| Stretch::new(curve, pair[0]..pair[1], capped, winches, watch);
        let stretches = rests.windows(2).filter(|pair| pair[0] < pair[1]).map(stretch).collect::<Result<_, _>>()?;
        Ok(Schedule { curve, limits, winches, stretches })
    }

    /// The timing: each stretch between two rests is planned on its grid, checked between its parameters, and planned again with
    /// tighter limits where one is exceeded; finally slowed down by the excess that is left.
    ///
    /// # Errors
    /// A place where the cables cannot hold or accelerate the platform; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn timing(self, watch: &Watch) -> Result<Timing, Error> {
        let Schedule { curve, limits, winches, stretches } = self;
        let alone = |stretch: Stretch| {
            let own = Schedule { curve, limits, winches, stretches: vec![stretch] };
            match limits.jerk {
                None => own.slowed(0.0, f64::INFINITY, watch).map(|timing| timing.expect("nothing is too slow")),
                Some(jerk) => own.within_jerk(jerk, watch),
            }
        };
        let timings: Vec<Timing> = stretches.into_par_iter().map(alone).collect::<Result<_, _>>()?;
        Ok(Timing::joined(timings))
    }

    /// The timing of one stretch with a jerk limit: the fastest that is found by averaging the progress over some time.
    ///
    /// Averaging over w turns a jump of the acceleration by A into a jerk A/w. A large acceleration needs a long w, so
    /// smaller ones are tried as well, but none above J/4 (32 L/J)^⅓: over a length L, a motion from rest to rest with
    /// jerk J never reaches more. The tried accelerations do not depend on the limit, so that a looser limit does not
    /// make a motion slower.
    fn within_jerk(self, jerk: f64, watch: &Watch) -> Result<Timing, Error> {
        let useful = useful_acceleration(jerk, self.stretches[0].length());
        let given = self.limits.acceleration.unwrap_or(f64::INFINITY);
        let grid = (0..).map(|k| useful * SMALLER.powi(k)).skip_while(|a| *a > given);
        let (mut best, mut refused): (Option<Timing>, _) = (None, None);
        for acceleration in [given].into_iter().filter(|a| *a < useful).chain(grid) {
            let mut may_be_faster = false;
            for (share, coasting) in AVERAGING {
                let window = share * acceleration / jerk;
                let own = self.capped(acceleration, if coasting { ROLLING * window } else { 0.0 });
                let known = best.as_ref().map_or(f64::INFINITY, Timing::duration);
                if own.fastest()?.iter().map(Timing::duration).sum::<f64>() + window >= known {
                    continue;
                }
                may_be_faster = true;
                match own.slowed(window, known, watch) {
                    Ok(faster) => best = faster.or(best),
                    Err(error) if error.class() == ErrorClass::Input => refused = Some(error),
                    Err(error) => return Err(error),
                }
            }
            if !may_be_faster || acceleration < LEAST_TRIED * useful.min(given) {
                break;
            }
        }
        best.ok_or_else(|| refused.expect("something was tried"))
    }

    /// The limits with at most this acceleration. With a `window`, s, the speed is also limited so that a motion along
    /// the whole stretch moves at constant speed for that time, between speeding up and slowing down.
    fn capped(&self, acceleration: f64, window: f64) -> Self {
        let mut own = self.clone();
        for stretch in &mut own.stretches {
            let rolling =
                0.5 * acceleration * ((window.powi(2) + 4.0 * stretch.length() / acceleration).sqrt() - window);
            for rows in &mut stretch.rows {
                let Some(ellipse) = &mut rows.ellipse else { continue };
                ellipse.radius = ellipse.radius.min(acceleration);
                if window > 0.0 {
                    rows.linear.push(Row { a: 0.0, b: ellipse.first.norm_squared(), c: rolling * rolling });
                }
            }
        }
        own
    }

    /// The timing for one window, slowed down to keep all limits; `None` if it takes as long as a `known` one, s.
    fn slowed(mut self, window: f64, known: f64, watch: &Watch) -> Result<Option<Timing>, Error> {
        let (mut excess, mut proved) = (TENSION_EXCESS, Proved::new());
        for _ in 0..TIMING_ROUNDS {
            let timing = smoothed(&self.fastest()?, window);
            if timing.duration() >= known {
                return Ok(None); // tighter limits make it no faster
            }
            let mut shares = self.shares(&timing, window, watch)?;
            if worst(&shares) <= 1.0 + TIMING_EXCESS {
                let timing = timing.stretched(worst(&shares).sqrt());
                let lacking = without_tensions(self.curve, &timing, self.winches, &mut proved, watch)?;
                if lacking.is_empty() {
                    return Ok(Some(timing).filter(|timing| timing.duration() < known));
                }
                lacking.iter().for_each(|k| shares[*k] = 1.0 + excess);
                excess *= 2.0;
            }
            self.tighten(&timing, &shares, window);
        }
        let timing = smoothed(&self.fastest()?, window);
        let factor = worst(&self.shares(&timing, window, watch)?).sqrt();
        let timing = self.slowed_as_a_whole(&timing.stretched(factor), watch)?;
        Ok(Some(timing).filter(|timing| timing.duration() < known))
    }

    /// The timing, slowed down as a whole until it is proved that tensions exist everywhere: at rest they do.
    fn slowed_as_a_whole(&self, timing: &Timing, watch: &Watch) -> Result<Timing, Error> {
        let lacking = |factor: f64| {
            without_tensions(self.curve, &timing.stretched(factor), self.winches, &mut Proved::new(), watch)
        };
        let (mut fast, mut slow) = (1.0, 1.0);
        loop {
            match lacking(slow)?.first() {
                None => break,
                Some(phase) if slow > MOST_SLOWED => {
                    return Err(not_moved(&self.curve.at(timing.phases()[*phase].s).position));
                }
                Some(_) => (fast, slow) = (slow, slow * (1.0 + (slow - 1.0).max(LEAST_SLOWED))),
            }
        }
        while slow - fast > LEAST_SLOWED * slow {
            let middle = 0.5 * (fast + slow);
            if lacking(middle)?.is_empty() { slow = middle } else { fast = middle }
        }
        Ok(timing.stretched(slow))
    }

    /// The shares of limits that each phase of a timing uses. Without smoothing, the rows already limit tensions.
    fn shares(&self, timing: &Timing, window: f64, watch: &Watch) -> Result<Vec<f64>, Error> {
        watch.check()?;
        let shares = shares(self.curve, timing, self.limits, self.winches).into_iter().map(|(share, _)| share);
        if window == 0.0 {
            return Ok(shares.collect());
        }
        let tensions = tension_shares(self.curve, timing, self.winches, watch)?;
        Ok(shares.zip(tensions).map(|(share, tension)| share.max(tension)).collect())
    }

    /// The fastest timing of each stretch between two rests.
    fn fastest(&self) -> Result<Vec<Timing>, Error> {
        let stuck = |s| not_moved(&self.curve.at(s).position);
        self.stretches.iter().map(|stretch| fastest(&stretch.grid, &stretch.rows).map_err(stuck)).collect()
    }

    /// Divides the limits on the grid by the shares that exceed them within half a window.
    fn tighten(&mut self, timing: &Timing, shares: &[f64], window: f64) {
        let exceeded: Vec<([f64; 2], f64)> = (shares.iter().enumerate())
            .filter(|(_, share)| **share > 1.0)
            .map(|(k, share)| {
                let [start, end] = [timing.phases()[k].time - 0.5 * window, timing.end_of(k) + 0.5 * window];
                ([start, end].map(|time| timing.at(time).s), *share)
            })
            .collect();
        self.stretches.iter_mut().for_each(|stretch| stretch.tighten(&exceeded));
    }
}

/// The largest acceleration that a motion from rest to rest over a length, m, reaches within a limit of jerk: J T/4 with the shortest
/// time T = (32 L/J)^⅓.
fn useful_acceleration(jerk: f64, length: f64) -> f64 {
    0.25 * jerk * (32.0 * length / jerk).cbrt()
}

/// On a bend, the acceleration across the curve may be larger than any along it.
const MORE_THAN_USEFUL: f64 = 2.0;

/// Ratio of consecutive accelerations to try, and the smallest one to try as a share of the largest.
const SMALLER: f64 = 0.8;
const LEAST_TRIED: f64 = 0.05;

/// A motion moves at constant speed for a little longer than the averaging time, since that phase begins and ends
/// between grid parameters.
const ROLLING: f64 = 1.01;

/// Averaging times to try, as a share of the time in which the jerk builds up the acceleration, and whether the motion
/// has a phase of constant speed between speeding up and slowing down. Without it, the acceleration may jump to its
/// negative.
const AVERAGING: [(f64, bool); 4] = [(1.0, true), (1.0, false), (1.4, false), (2.0, false)];

impl Stretch {
    /// Length of the stretch, m.
    fn length(&self) -> f64 {
        self.grid[self.grid.len() - 1] - self.grid[0]
    }

    /// Divides the limits between pairs of parameters by factors.
    fn tighten(&mut self, exceeded: &[([f64; 2], f64)]) {
        let (first, last) = (self.grid[0], self.grid[self.grid.len() - 1]);
        let mut factors = vec![1.0_f64; self.grid.len()];
        for ([from, to], factor) in exceeded.iter().filter(|([from, to], _)| *to > first && *from < last) {
            let from = self.grid.partition_point(|s| s <= from).saturating_sub(1);
            let to = self.grid.partition_point(|s| s < to).min(self.grid.len() - 1);
            factors[from..=to].iter_mut().for_each(|most| *most = most.max(*factor));
        }
        self.rows.iter_mut().zip(factors).for_each(|(rows, factor)| rows.tighten(factor));
    }
}

/// Steps in which a motion is slowed down as a whole, as a share, and the largest factor to try.
const LEAST_SLOWED: f64 = 1e-3;
const MOST_SLOWED: f64 = 1e4;

fn smoothed(stretches: &[Timing], window: f64) -> Timing {
    let smooth = |timing: &Timing| if window > 0.0 { timing.smoothed(window) } else { timing.clone() };
    Timing::joined(stretches.iter().map(smooth))
}

/// The largest share, at least 1.
fn worst(shares: &[f64]) -> f64 {
    shares.iter().copied().fold(1.0, f64::max)
}

fn unlimited(position: &Point) -> Error {
    let at = [position.x, position.y, position.z];
    let problem = format!(
        "found no limit on how fast the platform begins to turn at {at:?} m, where no cable changes its length; expected one"
    );
    Error::invalid("turn_acceleration", problem)
}

fn not_moved(position: &Point) -> Error {
    let at = [position.x, position.y, position.z];
    let problem =
        format!("found no tensions within the limits that accelerate the platform along the path at {at:?} m");
    Error::invalid("waypoints", problem)
}
