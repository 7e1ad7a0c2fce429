//! Progress along a curve over time.

/// Progress during an interval of time: a polynomial of third degree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// Start of the interval, s.
    pub time: f64,
    /// The curve's parameter at the start, m.
    pub s: f64,
    /// First time derivative of the parameter at the start, m/s.
    pub speed: f64,
    /// Second time derivative of the parameter at the start, m/s².
    pub acceleration: f64,
    /// Third time derivative of the parameter, m/s³.
    pub jerk: f64,
}

impl Phase {
    /// The state of progress `time` s after the start of the interval.
    pub fn after(&self, time: f64) -> Phase {
        let Phase { s, speed, acceleration, jerk, .. } = *self;
        Phase {
            time: self.time + time,
            s: s + time * (speed + time * (acceleration / 2.0 + time * jerk / 6.0)),
            speed: speed + time * (acceleration + time * jerk / 2.0),
            acceleration: acceleration + time * jerk,
            jerk,
        }
    }
}

/// Progress along a curve, from rest to rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Timing {
    phases: Vec<Phase>,
    /// Time from start to end, s.
    duration: f64,
}

impl Timing {
    /// Progress in these phases, which follow each other; the last one ends at `duration`, s.
    pub fn new(phases: Vec<Phase>, duration: f64) -> Self {
        Timing { phases, duration }
    }

    /// The phases of the progress.
    pub fn phases(&self) -> &[Phase] {
        &self.phases
    }

    /// Time from start to end, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The end of a phase, s.
    pub fn end_of(&self, phase: usize) -> f64 {
        self.phases.get(phase + 1).map_or(self.duration, |next| next.time)
    }

    /// The state of progress at an instant; before the start or after the end, at rest there.
    pub fn at(&self, time: f64) -> Phase {
        self.phase_at(time)[1]
    }

    /// The start of the phase at an instant, and the state of progress then. Rounding never carries the state beyond the end of
    /// the phase, where the curve may change direction.
    pub fn phase_at(&self, time: f64) -> [Phase; 2] {
        let inside = time.clamp(0.0, self.duration);
        let next = self.phases.partition_point(|phase| phase.time <= inside).max(1);
        let start = self.phases[next - 1];
        let mut state = start.after(inside - start.time);
        let end = self.phases.get(next).map_or(f64::INFINITY, |next| next.s.max(start.s));
        state.s = state.s.min(end);
        if time >= self.duration {
            state.speed = 0.0;
        }
        if time != inside {
            (state.acceleration, state.jerk) = (0.0, 0.0);
        }
        [start, state]
    }

    /// The instant at which the progress reaches a parameter of the curve, s.
    pub fn when(&self, s: f64) -> f64 {
        let phase = self.phases.partition_point(|phase| phase.s <= s).saturating_sub(1);
        let start = self.phases[phase];
        let (mut low, mut high) = (0.0, self.end_of(phase) - start.time);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if start.after(middle).s <= s { low = middle } else { high = middle }
        }
        start.time + low
    }

    /// This progress, slower by a factor.
    pub fn stretched(&self, factor: f64) -> Self {
        let slower = |phase: &Phase| Phase {
            time: phase.time * factor,
            s: phase.s,
            speed: phase.speed / factor,
            acceleration: phase.acceleration / factor.powi(2),
            jerk: phase.jerk / factor.powi(3),
        };
        Timing { phases: self.phases.iter().map(slower).collect(), duration: self.duration * factor }
    }

    /// The timings one after another.
    pub fn joined(parts: impl IntoIterator<Item = Timing>) -> Self {
        let mut whole = Timing { phases: Vec::new(), duration: 0.0 };
        for part in parts {
            let start = whole.duration;
            whole.phases.extend(part.phases.iter().map(|phase| Phase { time: start + phase.time, ..*phase }));
            whole.duration += part.duration;
        }
        whole
    }

    /// The mean of the progress over the last `window` s, with rest before the start and after the end: the acceleration
    /// becomes continuous, and the duration grows by the window.
    pub fn smoothed(&self, window: f64) -> Self {
        let mut times: Vec<f64> = self.phases.iter().map(|phase| phase.time).chain([self.duration]).collect();
        times.extend(times.clone().iter().map(|time| time + window));
        times.sort_by(f64::total_cmp);
        times.dedup_by(|later, earlier| *later - *earlier <= SAME_INSTANT * self.duration);
        let (origin, last) = (self.phases[0].s, times[times.len() - 1]);
        let mut s = origin;
        let mut phases = Vec::with_capacity(times.len());
        for pair in times.windows(2) {
            let middle = 0.5 * (pair[0] + pair[1]);
            let [now, past] = [pair[0], pair[0] - window].map(|time| self.at(time));
            let [rate_now, rate_past] = [middle, middle - window].map(|time| self.rate(time));
            let speed = (now.s - past.s) / window;
            let acceleration = (self.speed(pair[0]) - self.speed(pair[0] - window)) / window;
            let phase = Phase { time: pair[0], s, speed, acceleration, jerk: (rate_now - rate_past) / window };
            s = phase.after(pair[1] - pair[0]).s;
            phases.push(phase);
        }
        Timing { phases, duration: last }
    }

    /// The speed at an instant; 0 outside.
    fn speed(&self, time: f64) -> f64 {
        if time <= 0.0 || time >= self.duration { 0.0 } else { self.at(time).speed }
    }

    /// The acceleration at an instant; 0 outside.
    fn rate(&self, time: f64) -> f64 {
        if time <= 0.0 || time >= self.duration { 0.0 } else { self.at(time).acceleration }
    }
}

/// Halvings of an interval of time: to the last digit.
const HALVINGS: usize = 60;
/// Instants closer than this share of the duration are one.
const SAME_INSTANT: f64 = 1e-13;

#[cfg(test)]
mod tests {
    use super::*;

    /// From rest to rest over 1 m, with an acceleration of 1 m/s².
    fn triangle() -> Timing {
        let phase = |time, s, speed, acceleration| Phase { time, s, speed, acceleration, jerk: 0.0 };
        Timing::new(vec![phase(0.0, 0.0, 0.0, 1.0), phase(1.0, 0.5, 1.0, -1.0)], 2.0)
    }

    #[test]
    fn smoothing_keeps_the_end_and_makes_acceleration_continuous() {
        let smooth = triangle().smoothed(0.5);
        assert!((smooth.duration() - 2.5).abs() < 1e-15);
        assert!((smooth.at(2.5).s - 1.0).abs() < 1e-15 && smooth.at(2.5).speed.abs() < 1e-15);
        for k in 1..smooth.phases().len() {
            let (before, after) = (&smooth.phases()[k - 1], &smooth.phases()[k]);
            let end = before.after(after.time - before.time);
            let steps = [end.s - after.s, end.speed - after.speed, end.acceleration - after.acceleration];
            assert!(steps.iter().all(|step| step.abs() < 1e-14), "{steps:?}");
        }
        assert!((smooth.phases()[0].jerk - 2.0).abs() < 1e-14); // 1 m/s² within half a second
    }

    #[test]
    fn twice_the_time_is_half_the_speed() {
        let slow = triangle().stretched(2.0);
        assert_eq!((slow.duration(), slow.at(2.0).speed, slow.at(1.0).acceleration), (4.0, 0.5, 0.25));
        assert!((slow.when(0.5) - 2.0).abs() < 1e-12);
    }
}
