//! Where cables come from while the platform is in a box: their outlets, or where they leave their pulleys.
//!
//! Let the attachment be at most R from where it is at the centre of a box, the wheel's radius r, and f the least free length there. The
//! wrap then differs by at most R/f. As the wrap changes, the exit moves along the cable while the cable turns by the same angle, so it
//! leaves the cable's line by at most r (R/f)²/2. As the wheel swivels, the exit moves across the line, by its distance ρₑ from the axis over the
//! attachment's distance ρ from it, times R: at most R, as ρₑ <= ρ.

use cdpr_core::Scene;
use cdpr_core::geometry::{Point, Pulley, Vector};
use cdpr_core::model::Cable;

use crate::exact::{Exact, exact};
use crate::hanging::Hanging;

/// Added to the distance of a cable's line from its origin, m: far more than rounding errors.
const MORE_SPREAD: f64 = 1e-7;

/// The centre of a wheel is farther away than its rim by more than this share of its radius, or the exit is not known exactly enough.
const LEAST_LEEWAY: f64 = 1e-6;

/// The shortest cable that has a direction, m.
const SHORTEST: f64 = 1e-7;

/// Distances are multiplied by this where rounding must not make them smaller.
pub const ABOVE: f64 = 1.0 + 1e-12;

/// A point, and how far at most a cable's line passes from it, m.
pub struct Origin {
    pub middle: Vector,
    pub spread: f64,
}

impl Origin {
    /// Where a cable comes from while its attachment is at most `reach`, m, from a place: the tighter of two bounds for a pulley, one for
    /// this box and one for all positions.
    pub fn of(scene: &Scene, cable: usize, attachment: &Vector, reach: f64) -> Self {
        let Cable { pulley, outlet, .. } = &scene.robot().cables()[cable];
        let Some(pulley) = pulley.as_ref().filter(|pulley| pulley.radius > 0.0) else {
            return Origin { middle: outlet.coords, spread: 0.0 };
        };
        let anywhere = Origin::anywhere(scene, cable);
        Origin::near(pulley, outlet, attachment, reach).filter(|near| near.spread < anywhere.spread).unwrap_or(anywhere)
    }

    /// The middle of all points where a cable can leave its pulley.
    fn anywhere(scene: &Scene, cable: usize) -> Self {
        let hanging = Hanging::of(scene, cable);
        let exits = hanging.exits();
        let middle = exits.iter().sum::<Vector>() / exits.len() as f64;
        let spread = exits.iter().map(|exit| (exit - middle).norm()).fold(0.0, f64::max) + MORE_SPREAD;
        Origin { middle, spread }
    }

    /// Where the cable leaves its pulley while its attachment is at the place.
    fn near(pulley: &Pulley, outlet: &Point, attachment: &Vector, reach: f64) -> Option<Self> {
        let (r, line) = (pulley.radius, attachment - outlet.coords);
        let height = pulley.axis.dot(&line);
        let from_axis = (line - height * pulley.axis).norm();
        let to_center = (from_axis - r).hypot(height) - reach;
        let below = (from_axis - 2.0 * r).max(0.0).hypot(height.max(0.0)) - reach;
        if !(to_center > r * (1.0 + LEAST_LEEWAY) && below >= 0.0) {
            return None;
        }
        let free = ((to_center - r) * (to_center + r)).sqrt();
        let exit = pulley.departure(outlet, &Point::from(*attachment))?.exit.coords;
        let wrapped = r * (reach / free);
        let farthest = ((exit - outlet.coords).cross(&pulley.axis).norm() + wrapped).min(2.0 * r);
        let nearest = from_axis - reach;
        let swivelled = reach * if nearest > farthest { farthest / nearest } else { 1.0 };
        let is_ahead = swivelled + wrapped < free;
        is_ahead.then_some(Origin { middle: exit, spread: swivelled + 0.5 * wrapped * (reach / free) + MORE_SPREAD })
    }

    /// How much directions to the middle, from up to `reach` around an attachment, differ at most from those of the cable, as the length of
    /// a vector; `None` if they may be any.
    pub fn astray(&self, attachment: &Vector, reach: f64) -> Option<Exact> {
        if self.spread == 0.0 {
            return Some(exact(0.0));
        }
        let distance = (self.middle - attachment).norm() - reach;
        let sine = self.spread / distance;
        // The chord of the angle.
        let chord = sine / (0.5 + 0.5 * (1.0 - sine * sine).sqrt()).sqrt();
        (distance - self.spread > SHORTEST && chord.is_finite()).then(|| exact(chord * ABOVE))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The directions to the corners, edges and faces of a cube.
    fn directions() -> impl Iterator<Item = Vector> {
        let part = |k: i32, divisor: i32| f64::from(k / divisor % 3 - 1);
        (0..27).filter_map(move |k| Vector::new(part(k, 1), part(k, 3), part(k, 9)).try_normalize(0.0))
    }

    #[test]
    fn lines_of_cables_pass_as_near_as_bounded() {
        let (outlet, axis) = (Point::new(0.1, 0.2, 0.3), Vector::z());
        let places = || [0.3, 1.0, 4.0].into_iter().flat_map(|distance| directions().map(move |to| to * distance));
        let (mut largest, mut count) = (0.0f64, 0);
        for (radius, share) in [0.02, 0.2].into_iter().flat_map(|radius| [1e-3, 0.03, 0.3].map(|share| (radius, share)))
        {
            let pulley = Pulley { radius, axis };
            for place in places() {
                let (attachment, reach) = (outlet.coords + place, share * place.norm());
                let Some(near) = Origin::near(&pulley, &outlet, &attachment, reach) else { continue };
                for way in directions() {
                    let cable = pulley.departure(&outlet, &Point::from(attachment + way * reach)).unwrap();
                    let passes = (near.middle - cable.exit.coords).cross(&cable.pull).norm();
                    assert!(passes <= near.spread, "{radius} {place} {reach} {way}: {passes} > {}", near.spread);
                    (largest, count) = (largest.max(passes / near.spread), count + 1);
                }
            }
        }
        assert!(largest > 0.9 && count > 5000, "{largest} of the bound in {count} cases");
    }
}
