//! The length of a cable stays within its limits, and the cable can leave its pulley.
//!
//! The length round a pulley is a convex function of the attachment ([`Pulley`]), like the length of a straight cable: it is
//! largest at an end of a motion, and its smallest value is found by bisection on its slope. The attachment stays out of a
//! cylinder around the swivel axis, of twice the radius, that ends in a half ball above the outlet: outside, the wrap is at most
//! half a turn.

use std::f64::consts::PI;

use super::bodies::{Bodies, CableAt};
use super::exempt::Remarks;
use super::fattened::Fattened;
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{Region, Scale};
use crate::error::Error;
use crate::geometry::{Cuboid, HalfSpace, Placed, Point, Pulley, TurningPiece, Vector, segment_segment};
use crate::model::{Member, Scene};
use crate::tolerances::{MIN_CABLE_LENGTH, TOUCH_DEPTH};
use crate::watch::Watch;

/// The cable's length stays within an interval.
#[derive(Debug, Clone, PartialEq)]
pub struct CableLength {
    /// Index of the cable.
    pub cable: usize,
    /// Minimum length, m.
    pub min: f64,
    /// Maximum length, m.
    pub max: f64,
}

impl CableLength {
    /// Smallest distance of the length from its limits over a motion, m; negative outside them.
    #[inline]
    fn room(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let cable = &bodies.cables[self.cable];
        let (p, q) = (from + cable.arm, to + cable.arm);
        let Some(pulley) = &cable.pulley else {
            let longest = (p - cable.outlet).norm().max((q - cable.outlet).norm());
            let shortest = segment_segment::closest(&p, &q, &cable.outlet, &cable.outlet).distance;
            return (shortest - self.min).min(self.max - longest);
        };
        let outside = outside_wheel(pulley, &cable.outlet, [&p, &q]);
        if outside < 0.0 {
            return outside;
        }
        let longest = length(cable, &p).max(length(cable, &q));
        outside.min(self.max - longest).min(self.over_least(pulley, &cable.outlet, [&p, &q]))
    }

    /// How much longer than allowed at least the cable round a pulley is between two attachments, m.
    fn over_least(&self, pulley: &Pulley, outlet: &Point, [p, q]: [&Point; 2]) -> f64 {
        if self.min <= MIN_CABLE_LENGTH {
            return f64::INFINITY; // outside the wheel it is always longer
        }
        shortest(pulley, outlet, p, q) - self.min
    }
}

/// Length of a cable to an attachment, round its pulley if it has one, m; NaN if it cannot leave the pulley.
#[inline(never)] // for a small page
fn length(cable: &CableAt, attachment: &Point) -> f64 {
    let around = |pulley: &Pulley| pulley.departure(&cable.outlet, attachment).map_or(f64::NAN, |found| found.length);
    cable.pulley.as_ref().map_or_else(|| (attachment - cable.outlet).norm(), around)
}

/// How far attachments between two points are from where a cable cannot leave its pulley, m; negative if some are there.
#[inline(never)] // for a small page
fn outside_wheel(pulley: &Pulley, outlet: &Point, [p, q]: [&Point; 2]) -> f64 {
    let top = outlet + pulley.axis * pulley.radius;
    let far = (p - outlet).norm() + (q - outlet).norm() + pulley.radius;
    segment_segment::closest(p, q, &top, &(outlet - pulley.axis * far)).distance - keep_out(pulley)
}

/// Least distance of attachments from the swivel axis, m.
fn keep_out(pulley: &Pulley) -> f64 {
    2.0 * pulley.radius + MIN_CABLE_LENGTH
}

/// Least length round a pulley to attachments between two points from which the cable can leave it, m.
fn shortest(pulley: &Pulley, outlet: &Point, p: &Point, q: &Point) -> f64 {
    let step = q - p;
    let at = |t: f64| pulley.departure(outlet, &(p + step * t));
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        let Some(found) = at(middle) else { return f64::NEG_INFINITY };
        if found.pull.dot(&step) > 0.0 { low = middle } else { high = middle } // the length falls along the pull
    }
    let reached = [0.0, 0.5 * (low + high), 1.0].map(|t| at(t).map_or(f64::NEG_INFINITY, |found| found.length));
    reached.into_iter().fold(f64::INFINITY, f64::min)
}

/// Bisections of a motion: the slope vanishes at the minimum, so that the length there is exact up to rounding.
const BISECTIONS: u32 = 40;

impl PhysicalCondition for CableLength {
    fn all(scene: &Scene, _: &Bodies, _: usize, _: &mut Remarks, _: &Watch) -> Result<Vec<Self>, Error> {
        let limits = |(cable, model): (usize, &crate::model::Cable)| {
            let [min, max] = model.length.unwrap_or([0.0, f64::INFINITY]);
            CableLength { cable, min: min.max(MIN_CABLE_LENGTH), max }
        };
        Ok(scene.robot().cables().iter().enumerate().map(limits).collect())
    }

    fn sentence(found: &Broken) -> String {
        format!("{} breaks its length limits{}", found.name(0), found.lacking())
    }

    fn kind(&self) -> Kind {
        Kind::CableLength
    }

    fn members(&self, _: &Bodies) -> Vec<Member> {
        vec![Member::Cable(self.cable)]
    }

    fn required(&self, _: &Bodies) -> f64 {
        0.0
    }

    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        self.room(bodies, from, to)
    }

    fn worst_distance(&self, bodies: &Bodies, _: Interference, from: &Point, to: &Point) -> Option<f64> {
        Some(self.room(bodies, from, to))
    }

    fn forbids_all(&self, bodies: &Bodies, positions: &Cuboid, margin: f64) -> bool {
        let cable = &bodies.cables[self.cable];
        let center = cable.outlet - cable.arm;
        let longest = (positions.center - center).abs() + positions.half;
        let shortest = positions.nearest_to(&center) - center;
        // Round a pulley the cable is longer than the straight line, by at most half a turn and the width of the wheel.
        let detour = cable.pulley.map_or(0.0, |pulley| (PI + 2.0) * pulley.radius);
        let [mut least, mut most] = [shortest.norm(), longest.norm() + detour];
        let (too_short, too_long) = (self.min + margin, self.max - margin);
        if let Some(pulley) = cable.pulley.as_ref().filter(|_| least <= too_short || most >= too_long) {
            // Where cables can leave the wheel, the length changes no faster than the attachment moves.
            let (attachment, reach) = (positions.center + cable.arm, positions.half.norm());
            if outside_wheel(pulley, &cable.outlet, [&attachment; 2]) > reach {
                let length = length(cable, &attachment);
                (least, most) = (least.max(length - reach), most.min(length + reach));
            }
        }
        most <= too_short || least >= too_long
    }

    #[inline]
    fn breaks(&self, bodies: &Bodies, _: Interference, from: &Point, to: &Point) -> bool {
        self.room(bodies, from, to) < -TOUCH_DEPTH
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let cable = &bodies.cables[self.cable];
        let attachment = at.point(&cable.arm);
        if let Some(pulley) = &cable.pulley {
            let outside = outside_wheel(pulley, &cable.outlet, [&attachment; 2]);
            if outside < 0.0 {
                return outside;
            }
        }
        let length = length(cable, &attachment);
        (length - self.min).min(self.max - length)
    }

    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let cable = &bodies.cables[self.cable];
        let [p, q] = piece.points(&cable.arm);
        if let Some(pulley) = &cable.pulley {
            let sag = piece.sag(&cable.arm);
            return outside_wheel(pulley, &cable.outlet, [&p, &q]) >= sag
                && length(cable, &p).max(length(cable, &q)) <= self.max - sag + TOUCH_DEPTH
                && self.over_least(pulley, &cable.outlet, [&p, &q]) >= sag - TOUCH_DEPTH;
        }
        let (first, last) = ((p - cable.outlet).norm(), (q - cable.outlet).norm());
        let sag = piece.sag(&cable.arm) - TOUCH_DEPTH;
        // The length changes by at most the distance travelled, and by at most half of it from the nearer end.
        let quick = first.min(last) - 0.5 * piece.travel(cable.arm.norm()) >= self.min;
        let longest = first.max(last);
        longest <= self.max - sag
            && (quick || segment_segment::closest(&p, &q, &cable.outlet, &cable.outlet).distance >= self.min + sag)
    }

    fn exceeds_pieces(&self) -> bool {
        self.max.is_finite()
    }

    /// Too short: inside a ball, which a cube contains. Too long: outside another ball, which no polyhedron contains. Where the
    /// cable cannot leave its pulley: inside a prism that is open below.
    fn regions(&self, bodies: &Bodies, scale: &Scale, _: &Fattened) -> Vec<Region> {
        let cable = &bodies.cables[self.cable];
        let center = cable.outlet - cable.arm;
        let faces = (0..6).map(|k| Vector::ith(k / 2, if k % 2 == 0 { 1.0 } else { -1.0 }));
        let reach = self.min.max(MIN_CABLE_LENGTH) + scale.rounding;
        let cube = faces.map(|n| HalfSpace::through(&center, n).widened(reach));
        let short = Region::within(Some(cube.collect()));
        let long = self.max.is_finite().then_some(Region::within(None));
        let wheel = cable.pulley.map(|pulley| {
            let side = pulley.axis.cross(&Vector::ith(pulley.axis.iamin(), 1.0)).normalize();
            let across = pulley.axis.cross(&side);
            let reach = keep_out(&pulley) + scale.rounding;
            let around = [side, -side, across, -across].map(|n| HalfSpace::through(&center, n).widened(reach));
            let above = HalfSpace::through(&center, pulley.axis).widened(pulley.radius + reach);
            Region::within(Some(around.into_iter().chain([above]).collect()))
        });
        std::iter::once(short).chain(long).chain(wheel).collect()
    }
}
