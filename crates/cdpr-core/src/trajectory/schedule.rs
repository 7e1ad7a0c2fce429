//! The timing along a curve with stops, under all limits at every instant.

use std::ops::Range;

use super::between::{BETWEEN_CHECKS, not_held, shares, tension_shares, without_tensions};
use super::corners::{Corner, Passing};
use super::curve::Curve;
use super::fastest::{fastest, grid};
use super::jet::Jet;
use super::limits::Limits;
use super::rows::Rows;
use super::timing::Timing;
use super::winches::Winches;
use crate::error::Error;
use crate::geometry::Point;
use crate::numerics::{TENSION_EXCESS, TIMING_EXCESS, TIMING_ROUNDS};
use crate::watch::Watch;

/// A curve between its stops, and the limits on grids of its parameters.
#[derive(Clone)]
pub struct Schedule<'a> {
    curve: &'a Curve,
    limits: &'a Limits,
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
        limits: &Limits,
        winches: &Winches,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let places = grid(curve, pieces);
        let jets: Vec<Jet> = places.iter().map(|(piece, s)| curve.on_piece(*piece, *s)).collect();
        let mut rows = Vec::with_capacity(jets.len());
        for some in jets.chunks(BETWEEN_CHECKS) {
            watch.check()?;
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
        limits: &'a Limits,
        winches: &'a Winches,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let stops = corners.iter().filter(|corner| corner.passing == Passing::Stop);
        let mut rests = vec![0];
        rests.extend(stops.map(|corner| curve.piece_at(corner.at)).filter(|piece| *piece > 0));
        rests.push(curve.pieces().len());
        let stretch = |pair: &[usize]| Stretch::new(curve, pair[0]..pair[1], limits, winches, watch);
        let stretches = rests.windows(2).filter(|pair| pair[0] < pair[1]).map(stretch).collect::<Result<_, _>>()?;
        Ok(Schedule { curve, limits, winches, stretches })
    }

    /// The timing: planned on the grid, checked between its parameters, and planned again with tighter limits where one is
    /// exceeded; finally slowed down by the excess that is left.
    ///
    /// # Errors
    /// A place where the cables cannot hold or accelerate the platform; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn timing(self, watch: &Watch) -> Result<Timing, Error> {
        let (mut best, windows): (Option<Timing>, _) = (None, self.windows());
        for (own, window) in std::iter::repeat_n(self, windows.len()).zip(windows) {
            let timing = own.slowed(window, watch)?;
            if best.as_ref().is_none_or(|best| timing.duration() < best.duration()) {
                best = Some(timing);
            }
        }
        Ok(best.expect("at least one window"))
    }

    /// The averaging times to try in order to keep the limit of jerk, s: the first suffices for a jump of the acceleration by its
    /// limit, the last for a jump from the limit to its negative. 0 without a limit of jerk.
    fn windows(&self) -> Vec<f64> {
        match (self.limits.jerk, self.limits.acceleration) {
            (Some(jerk), Some(acceleration)) => [1.0, 1.4, 2.0].map(|share| share * acceleration / jerk).to_vec(),
            _ => vec![0.0],
        }
    }

    /// The timing for one window, so slow that it keeps all limits.
    fn slowed(mut self, window: f64, watch: &Watch) -> Result<Timing, Error> {
        let mut excess = TENSION_EXCESS;
        for _ in 0..TIMING_ROUNDS {
            let timing = smoothed(&self.fastest()?, window);
            let mut shares = self.shares(&timing, window, watch)?;
            if worst(&shares) <= 1.0 + TIMING_EXCESS {
                let timing = timing.stretched(worst(&shares).sqrt());
                let lacking = without_tensions(self.curve, &timing, self.winches, watch)?;
                if lacking.is_empty() {
                    return Ok(timing);
                }
                lacking.iter().for_each(|k| shares[*k] = 1.0 + excess);
                excess *= 2.0;
            }
            self.tighten(&timing, &shares, window);
        }
        let timing = smoothed(&self.fastest()?, window);
        let slower = timing.stretched(worst(&self.shares(&timing, window, watch)?).sqrt());
        match without_tensions(self.curve, &slower, self.winches, watch)?.first() {
            None => Ok(slower),
            Some(phase) => Err(not_moved(&self.curve.at(slower.phases()[*phase].s).position)),
        }
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

impl Stretch {
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
