//! The length of a cable stays within its limits.

use super::bodies::Bodies;
use super::exempt::Remarks;
use super::fattened::Fattened;
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{Region, Scale};
use crate::error::Error;
use crate::geometry::{Cuboid, HalfSpace, Placed, Point, TurningPiece, Vector, segment_segment};
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
        let longest = (p - cable.outlet).norm().max((q - cable.outlet).norm());
        let shortest = segment_segment::closest(&p, &q, &cable.outlet, &cable.outlet).distance;
        (shortest - self.min).min(self.max - longest)
    }
}

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
        longest.norm() <= self.min + margin || shortest.norm() >= self.max - margin
    }

    #[inline]
    fn breaks(&self, bodies: &Bodies, _: Interference, from: &Point, to: &Point) -> bool {
        self.room(bodies, from, to) < -TOUCH_DEPTH
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let cable = &bodies.cables[self.cable];
        let length = (at.point(&cable.arm) - cable.outlet).norm();
        (length - self.min).min(self.max - length)
    }

    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let cable = &bodies.cables[self.cable];
        let [p, q] = piece.points(&cable.arm);
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

    /// Too short: inside a ball, which a cube contains. Too long: outside another ball, which no polyhedron contains.
    fn regions(&self, bodies: &Bodies, scale: &Scale, _: &Fattened) -> Vec<Region> {
        let cable = &bodies.cables[self.cable];
        let center = cable.outlet - cable.arm;
        let faces = (0..6).map(|k| Vector::ith(k / 2, if k % 2 == 0 { 1.0 } else { -1.0 }));
        let reach = self.min.max(MIN_CABLE_LENGTH) + scale.rounding;
        let cube = faces.map(|n| HalfSpace::through(&center, n).widened(reach));
        let short = Region::within(Some(cube.collect()));
        let long = self.max.is_finite().then_some(Region::within(None));
        std::iter::once(short).chain(long).collect()
    }
}
