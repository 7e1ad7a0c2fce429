//! How fast the direction of a cable turns while its attachment moves, without knowing exactly how it moves.
//!
//! With the notation of [`super::pulley`], let the attachment move on a line at unit speed, with the components a along n, b
//! across the swivel plane (along e) and c along t; κ = sin w / ρ. The direction t turns at the rate (a/f) n + b κ e. As
//! ρ = ρₑ + f sin w with ρₑ = r (1 - cos w), κ <= 1/f: t turns no faster than that of a fixed outlet at the distance f.
//!
//! Its derivative, with w' = -a/f and the swivel rate b/ρ, is
//!
//!   -[2ac/f² + r a²/f³ + b² Q] n - 2b [c κ² + a Q] e - [a²/f² + b² κ²] t,    Q = cos w ρₑ / (f ρ²).
//!
//! Without r and Q, and with κ = 1/f, its norm is x √(4 - 3x²) / f², x² = a² + b², at most 2/√3 / f²; a smaller κ makes no
//! component larger. The rest adds r/f³ and |Q| b √(b² + 4a²) <= |Q| 2/√3. For w <= π/2, from ρ >= f sin w, |Q| <= r cos w /
//! ((1 + cos w) f³) <= r / (2f³). For w >= π/2, ρ >= ρₑ >= r, and ρₑ <= min(ρ, 2r).
//!
//! The exit, at ρₑ ρ̂ + r sin w along the axis, with ρ̂ the direction of the attachment from the axis, has the second derivative
//!
//!   [r w'' - ρₑ b² sin w / ρ²] t + [ρₑ b² cos w / ρ² - r a²/f²] n - [2 r a b sin w / (f ρ) + 2 ρₑ b ρ' / ρ²] e
//!
//! with w'' = 2ac/f² + r a²/f³ + b² cos w / (f ρ). As |2ac| <= a² + c², |2ab| <= 1 and |2bρ'| <= 1, and with g = min(1, 2r/ρ) >= ρₑ/ρ,
//! its components are at most max(r/f² + r²/f³, r/(f ρ) + g/f), r/f² + g/ρ and r/f² + g/ρ.
//!
//! The distances of the attachment from the wheel's centre, from the axis, and from the half-cylinder below the outlet to which
//! no cable leads change no faster than the attachment moves. So bounds at a place hold nearby with smaller distances. And where
//! the true outlet is off by some vector, the direction is that for an attachment off by its opposite.

use super::{Point, Pulley};
use crate::tolerances::{MIN_CABLE_LENGTH, TURNING};

/// Distances of an attachment from the places where its cable would lose its direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leeway {
    /// Radius of the wheel, m; 0 for a fixed outlet.
    radius: f64,
    /// From the wheel's centre, or the outlet, m.
    center: f64,
    /// From the half-cylinder below the outlet, m; infinite for a fixed outlet.
    below: f64,
    /// From the axis, m; infinite for a fixed outlet.
    axis: f64,
}

/// Bounds of the derivatives of a cable's direction while its attachment moves on a line at unit speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurnBounds {
    /// The first derivative, 1/m.
    pub first: f64,
    /// The second derivative, 1/m².
    pub second: f64,
}

impl Leeway {
    /// The distances of an attachment.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::{Leeway, Pulley, Vector}};
    /// let pulley = Pulley { radius: 1.0, axis: Vector::z() };
    /// let leeway = Leeway::of(Some(&pulley), &Point::origin(), &Point::new(3.0, 0.0, 1.0));
    /// assert!((leeway.free().unwrap() - 2.0).abs() < 1e-12); // √5 from the centre of a wheel of radius 1
    /// assert_eq!(leeway.within(1.3).free(), None); // so close there is the wheel
    /// let fixed = Leeway::of(None, &Point::origin(), &Point::new(3.0, 0.0, 4.0));
    /// assert_eq!(fixed.within(1.0).turning().unwrap().first, 0.25);
    /// ```
    pub fn of(pulley: Option<&Pulley>, outlet: &Point, attachment: &Point) -> Self {
        let line = attachment - outlet;
        let Some(Pulley { radius, axis }) = pulley else {
            return Leeway { radius: 0.0, center: line.norm(), below: f64::INFINITY, axis: f64::INFINITY };
        };
        let height = axis.dot(&line);
        let distance = (line - height * axis).norm();
        Leeway {
            radius: *radius,
            center: hypotenuse(distance - radius, height),
            below: hypotenuse((distance - 2.0 * radius).max(0.0), height.max(0.0)),
            axis: distance,
        }
    }

    /// Lower bounds of the distances of all attachments up to this far away, m.
    pub fn within(self, reach: f64) -> Self {
        self.map(|distance| distance - reach)
    }

    /// Lower bounds of the distances on a way of at most this length from here to another place, m.
    pub fn between(self, other: Self, way: f64) -> Self {
        let least = |a: f64, b: f64| 0.5 * (a + b - way);
        Leeway {
            center: least(self.center, other.center),
            below: least(self.below, other.below),
            axis: least(self.axis, other.axis),
            ..self
        }
    }

    fn map(self, of: impl Fn(f64) -> f64) -> Self {
        Leeway { center: of(self.center), below: of(self.below), axis: of(self.axis), ..self }
    }

    /// A lower bound of the distance from where the cable leaves its wheel to the attachment, m; `None` if it may have no direction.
    pub fn free(&self) -> Option<f64> {
        let free = ((self.center - self.radius) * (self.center + self.radius)).sqrt();
        (self.center > self.radius && self.below >= 0.0 && free >= MIN_CABLE_LENGTH).then_some(free)
    }

    /// How fast the direction turns at most; `None` if there may be none.
    pub fn turning(&self) -> Option<TurnBounds> {
        let (free, r) = (self.free()?, self.radius);
        let axis = self.axis.max(r);
        let beside = if r > 0.0 {
            (0.5 * r / (free * free * free)).max(1.0f64.min(2.0 * r / axis) / (free * axis))
        } else {
            0.0
        };
        let square = free * free;
        Some(TurnBounds { first: 1.0 / free, second: TURNING[1] * (1.0 / square + beside) + r / (square * free) })
    }

    /// The most by which a cable's line misses the point where the cable leaves its wheel now, while the attachment moves by at most
    /// `reach`, m; `None` if the cable may have no direction there. That point is now this far from the axis, m.
    ///
    /// As the wrap grows by dw, the exit moves by r t dw, along the cable, while t turns by dw. So the exit leaves the cable's line by at most
    /// r (reach/f)²/2. As the wheel swivels, the exit moves by b ρₑ/ρ across the line; ρₑ <= ρ, and ρₑ grows by at most r dw.
    pub fn missed(&self, exit_from_axis: f64, reach: f64) -> Option<f64> {
        let (near, r) = (self.within(reach), self.radius);
        if r == 0.0 {
            return Some(0.0);
        }
        let turn = reach / near.free()?;
        let from_axis = (exit_from_axis + r * turn).min(2.0 * r);
        let swivel = reach * if near.axis > from_axis { from_axis / near.axis } else { 1.0 };
        // The exit must not come to lie behind the attachment.
        (swivel + r * turn < near.free()?).then_some(swivel + 0.5 * r * turn * turn)
    }

    /// How much the direction in the middle of a way of at most this length differs from that to the middle of the exits at both ends, as the
    /// length of a vector, if the distances are lower bounds on it; `None` if there may be none. At a fraction s of the way, the
    /// direction differs by at most 4 s (1 - s) times this from that to the point at the fraction s between the exits.
    pub fn turned_from_even(&self, way: f64) -> Option<f64> {
        let (free, r) = (self.free()?, self.radius);
        if r == 0.0 {
            return Some(0.0);
        }
        if !(self.axis > 0.0) {
            return None;
        }
        let swivel = 1.0f64.min(2.0 * r / self.axis);
        let wheel = r / (free * free);
        let along = (wheel * (1.0 + r / free)).max((r / self.axis + swivel) / free);
        let across = wheel + swivel / self.axis;
        let bend = (along * along + 2.0 * across * across).sqrt();
        let sine = 0.125 * way * way * bend / free;
        (sine < 1.0).then(|| chord(sine))
    }

    /// How much the direction differs at most, as the length of a vector, if the outlet is off by at most this distance, m; `None`
    /// if there may be none.
    pub fn astray(&self, error: f64) -> Option<f64> {
        if error == 0.0 {
            return Some(0.0);
        }
        let free = self.within(error).free()?;
        if self.radius > 0.0 {
            return Some((error / free).min(2.0));
        }
        Some(chord(error / self.center))
    }
}

/// As `hypot`, in a fraction of its time; squares of distances in a scene neither overflow nor vanish.
fn hypotenuse(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// The chord 2 sin(x/2) of the angle x with this sine, at most 1. A share of the sine has at most that share of the chord.
fn chord(sine: f64) -> f64 {
    sine / (0.5 + 0.5 * (1.0 - sine * sine).sqrt()).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    fn any(rng: &mut ChaCha8Rng, size: f64) -> Vector {
        Vector::from_fn(|_, _| rng.random_range(-size..size))
    }

    /// Differences of directions along lines keep the bounds, which some come close to.
    #[test]
    fn directions_turn_no_faster_than_bounded() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let (mut closest, mut tried) = ([0.0_f64; 2], 0);
        while tried < 20_000 {
            let pulley =
                Pulley { radius: 10.0_f64.powf(rng.random_range(-3.0..0.5)), axis: any(&mut rng, 1.0).normalize() };
            let (middle, h) = (Point::from(any(&mut rng, 3.0)), 1e-4);
            let step = any(&mut rng, 1.0).normalize() * h;
            let [before, here, after] =
                [middle - step, middle, middle + step].map(|p| pulley.departure(&Point::origin(), &p));
            let leeway = Leeway::of(Some(&pulley), &Point::origin(), &middle).within(h);
            let Some(TurnBounds { first, second }) = leeway.turning().filter(|bounds| bounds.first < 30.0) else {
                continue;
            };
            tried += 1;
            let [before, here, after] = [before, here, after].map(|found| found.expect("bounded").pull);
            let found =
                [(after - before).norm() / (2.0 * h) / first, (after + before - 2.0 * here).norm() / (h * h) / second];
            assert!(found[0] <= 1.0 + 1e-9 && found[1] <= 1.0 + 1e-5, "{found:?}");
            closest = [closest[0].max(found[0]), closest[1].max(found[1])];
        }
        assert!(closest[0] > 0.98 && closest[1] > 0.9, "{closest:?}");
    }

    /// Within a ball or along a way there is a direction wherever the bound says so, and it differs no more than bounded.
    #[test]
    fn bounds_around_a_place_hold() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let (mut closest, mut tried) = (0.0_f64, 0);
        while tried < 20_000 {
            let round = rng.random_bool(0.7);
            let pulley =
                Pulley { radius: 10.0_f64.powf(rng.random_range(-2.0..0.3)), axis: any(&mut rng, 1.0).normalize() };
            let place = Point::from(any(&mut rng, 3.0));
            let (error, pulley) = (10.0_f64.powf(rng.random_range(-3.0..0.3)), round.then_some(&pulley));
            let leeway = Leeway::of(pulley, &Point::origin(), &place);
            let Some(most) = leeway.astray(error) else { continue };
            tried += 1;
            let pull = |p: &Point| match pulley {
                Some(pulley) => pulley.departure(&Point::origin(), p).expect("bounded").pull,
                None => -p.coords.normalize(),
            };
            let off = place + any(&mut rng, 1.0).normalize() * error;
            let found = (pull(&off) - pull(&place)).norm();
            assert!(found <= most * (1.0 + 1e-9), "{found} {most}");
            closest = closest.max(found / most);
            let way = Leeway::between(leeway, Leeway::of(pulley, &Point::origin(), &off), error);
            if let Some(free) = way.free() {
                let between = place + (off - place) * rng.random_range(0.0..1.0);
                let own = Leeway::of(pulley, &Point::origin(), &between).free().expect("bounded");
                assert!(own >= free * (1.0 - 1e-9), "{own} {free}");
            }
        }
        assert!(closest > 0.99, "{closest}");
    }

    /// Lines of cables near a place miss the point where the cable leaves its wheel there by no more than bounded.
    #[test]
    fn lines_miss_the_exit_no_further_than_bounded() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let (mut closest, mut tried) = (0.0_f64, 0);
        while tried < 20_000 {
            let pulley =
                Pulley { radius: 10.0_f64.powf(rng.random_range(-3.0..0.5)), axis: any(&mut rng, 1.0).normalize() };
            let (outlet, place) = (Point::origin(), Point::from(any(&mut rng, 3.0)));
            let reach = 10.0_f64.powf(rng.random_range(-4.0..0.0));
            let Some(exit) = pulley.departure(&outlet, &place).map(|found| found.exit) else { continue };
            let from_axis = exit.coords.cross(&pulley.axis).norm();
            let leeway = Leeway::of(Some(&pulley), &outlet, &place);
            let Some(most) = leeway.missed(from_axis, reach) else { continue };
            tried += 1;
            let across = place.coords.cross(&pulley.axis).normalize();
            for way in [any(&mut rng, 1.0).normalize(), across, across.cross(&(exit - place)).normalize()] {
                let there = place + way * reach;
                let found = pulley.departure(&outlet, &there).expect("bounded");
                assert!((exit - there).dot(&found.pull) > 0.0);
                let missed = (exit - there).cross(&found.pull).norm();
                assert!(missed <= most * (1.0 + 1e-9) + 1e-13, "{missed} {most} {pulley:?} {place} {reach}");
                closest = closest.max(missed / (most + 1e-9));
            }
        }
        assert!(closest > 0.95, "{closest}");
    }
    /// While the attachment moves evenly, the direction stays within the bound of that to a point that moves evenly between the exits at
    /// both ends.
    #[test]
    fn directions_turn_from_even_exits_no_further_than_bounded() {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let (mut closest, mut tried) = (0.0_f64, 0);
        while tried < 20_000 {
            let pulley =
                Pulley { radius: 10.0_f64.powf(rng.random_range(-3.0..0.5)), axis: any(&mut rng, 1.0).normalize() };
            let (outlet, place) = (Point::origin(), Point::from(any(&mut rng, 3.0)));
            let way = any(&mut rng, 1.0).normalize() * 10.0_f64.powf(rng.random_range(-3.0..0.3));
            let at = |s: f64| place + way * s;
            let leeway = |s: f64| Leeway::of(Some(&pulley), &outlet, &at(s));
            let Some(most) = leeway(0.0).between(leeway(1.0), way.norm()).turned_from_even(way.norm()) else {
                continue;
            };
            tried += 1;
            let found = |s: f64| pulley.departure(&outlet, &at(s)).expect("bounded");
            let [first, last] = [0.0, 1.0].map(|s| found(s).exit);
            for s in [0.1, 0.5, rng.random_range(0.0..1.0)] {
                let even = (first + (last - first) * s - at(s)).normalize();
                let (turned, bound) = ((even - found(s).pull).norm(), 4.0 * s * (1.0 - s) * most);
                assert!(turned <= bound * (1.0 + 1e-9) + 1e-14, "{turned} {bound} {pulley:?} {place} {way} {s}");
                closest = closest.max(turned / (bound + 1e-9));
            }
        }
        assert!(closest > 0.3, "{closest}");
    }
}
