//! Cables stay clear of the platform.
//!
//! Relative to a part K of the platform, a cable runs from its attachment R a to B - p. If it is not attached to K, the
//! forbidden positions are the shadow of K seen from R a, mirrored: p ∈ B - (RK ⊕ cone(RK - R a)). If it is attached to
//! K, they are the cone of directions below all facets that are active there.
//!
//! A cable that can take several shapes lies in the hull of its attachment and a convex set E (`Envelope::lowered_exits`), which
//! takes the place of the outlet B: p ∈ E ⊕ -(RK ⊕ cone(RK - R a)).

use super::bodies::{Bodies, CableAt, Shapes};
use super::cable_and_body::{CABLE, CableDemand, rounded_shadow};
use super::exempt::Remarks;
use super::fattened::{Fattened, directions, fattened};
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{ForbiddenPolyhedron, Region, Scale};
use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::seam::Gap;
use crate::geometry::{
    CableSweep, Cone, Fan, HalfSpace, Placed, Point, Shadow, Triangle, TurningPiece, Vector, largest_distance, shadow,
};
use crate::model::{Member, Scene};
use crate::tolerances::ON_SURFACE;
use crate::watch::Watch;

/// A cable stays clear of a platform body.
#[derive(Debug, Clone, PartialEq)]
pub struct CablePlatform {
    /// Index of the cable.
    pub cable: usize,
    /// Index into [`Bodies::platform`].
    pub body: usize,
    /// How the cable must stay clear of the body.
    pub demand: CableDemand,
}

impl CablePlatform {
    /// The condition on a cable and a platform body, at `index` in the list; `None` if the cable cannot break it.
    /// `seam` is what the body closes, if it is a seam.
    fn of(
        [index, cable, body]: [usize; 3],
        bodies: &Bodies,
        seam: Option<Gap>,
        clearance: f64,
        remarks: &mut Remarks,
    ) -> Option<Self> {
        let CableAt { arm, radius, .. } = bodies.cables[cable];
        let attachment = Point::from(arm);
        let part = &bodies.platform[body];
        let distance = shape_distance(&Triangle::new(attachment, attachment, attachment), part).distance;
        let demand = match seam {
            // A plate, a segment or a point has no interior that the cable could enter.
            _ if distance <= ON_SURFACE && !part.has_volume() => return None,
            _ if distance <= ON_SURFACE => CableDemand::Leave { normals: part.active_normals(&attachment) },
            Some(gap) => CableDemand::Outside { touch: gap.touch },
            None => {
                let pair = (index, [Member::Cable(cable), Member::Platform]);
                CableDemand::Apart { gap: remarks.kept(bodies, pair, [clearance, radius, distance]) }
            }
        };
        Some(CablePlatform { cable, body, demand })
    }

    /// The apex of the cable's shadows: its attachment, in the platform's frame.
    fn apex(&self, bodies: &Bodies) -> Point {
        Point::from(bodies.cables[self.cable].arm)
    }
}

impl PhysicalCondition for CablePlatform {
    fn all(
        scene: &Scene,
        bodies: &Bodies,
        first: usize,
        remarks: &mut Remarks,
        watch: &Watch,
    ) -> Result<Vec<Self>, Error> {
        let mut all = Vec::new();
        for cable in 0..bodies.cables.len() {
            watch.check()?;
            if scene.pairs().ignores(Member::Cable(cable), Member::Platform) {
                continue;
            }
            let clearance = scene.pairs().clearance(Member::Cable(cable), Member::Platform);
            for body in 0..bodies.platform.len() {
                let seam = body.checked_sub(bodies.platform_parts).map(|k| scene.robot().seams()[k].gap);
                if seam.is_some_and(|gap| !gap.admits(CABLE)) {
                    continue;
                }
                all.extend(CablePlatform::of([first + all.len(), cable, body], bodies, seam, clearance, remarks));
            }
        }
        Ok(all)
    }

    fn sentence(found: &Broken) -> String {
        found.meets(found.name(0), "the platform")
    }

    fn kind(&self) -> Kind {
        Kind::CablePlatform
    }

    fn members(&self, _: &Bodies) -> Vec<Member> {
        vec![Member::Cable(self.cable), Member::Platform]
    }

    fn within_robot(&self) -> bool {
        true
    }

    fn closes_seam(&self, bodies: &Bodies) -> bool {
        self.body >= bodies.platform_parts
    }

    fn required(&self, bodies: &Bodies) -> f64 {
        self.demand.required(bodies.cables[self.cable].radius)
    }

    fn is_about_gap(&self, _: &Bodies) -> bool {
        self.demand.is_about_gap()
    }

    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let cable = &bodies.cables[self.cable];
        shape_distance(&cable.sweep_seen_from_platform(from, to), &bodies.platform[self.body]).signed() - cable.radius
    }

    fn shapes(&self, bodies: &Bodies, ends: &[Placed; 2]) -> Option<Shapes> {
        bodies.shapes_of(&[self.cable], ends)
    }

    fn nearest_points(&self, bodies: &Bodies, position: &Point) -> Option<[Point; 2]> {
        let cable = &bodies.cables[self.cable];
        let seen = cable.sweep_seen_from_platform(position, position);
        let found = shape_distance(&seen, &bodies.platform[self.body]);
        Some([found.on_a + found.axis * cable.radius, found.on_b].map(|point| point + position.coords))
    }

    fn slack(&self, bodies: &Bodies, position: &Point) -> f64 {
        if self.ends_on_body() {
            return f64::NEG_INFINITY;
        }
        self.distance(bodies, position, position) - self.required(bodies)
    }

    fn is_rounded(&self) -> bool {
        self.demand.distance().is_some()
    }

    fn ends_on_body(&self) -> bool {
        self.demand.ends_on_body()
    }

    #[inline]
    fn breaks(&self, bodies: &Bodies, _: Interference, from: &Point, to: &Point) -> bool {
        let cable = &bodies.cables[self.cable];
        let along = [cable.outlet - (from + cable.arm), cable.outlet - (to + cable.arm)];
        let sweep = || cable.sweep_seen_from_platform(from, to);
        self.demand.broken_by(sweep, along, |n| cable.lower_at_platform(n), &bodies.platform[self.body])
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let cable = &bodies.cables[self.cable];
        let (end, start) = (Point::from(cable.arm), at.seen(&cable.outlet));
        let lower = |n: &Vector| cable.lower_at_platform(&at.turned(n));
        match &cable.envelope {
            None => self.demand.slack(
                || Triangle::new(end, start, start),
                &(start - end),
                lower,
                &bodies.platform[self.body],
            ),
            Some(envelope) => {
                let exits: Vec<Point> = envelope.lowered_exits.vertices().iter().map(|exit| at.seen(exit)).collect();
                let fan = || Fan { points: &exits, copies: [Fan::AS_IT_IS; 3], ends: [end; 4] };
                self.demand.slack(fan, &(start - end), lower, &bodies.platform[self.body])
            }
        }
    }

    /// In the platform's frame it is the outlet that moves. Only the part of the cable that can reach the body matters, and its
    /// deviation is smaller: in proportion to its share of the cable.
    #[inline]
    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let cable = &bodies.cables[self.cable];
        let (outlet, end, body) = (&cable.outlet, Point::from(cable.arm), &bodies.platform[self.body]);
        let reach = || largest_distance(body.vertices(), &end) + self.demand.gap_and_touch()[0];
        let slowed = 0.5 * piece.travel(cable.arm.norm());
        let seen = |exit: &Point| [piece.ends[0].seen(exit), piece.ends[1].seen(exit)];
        let share = |[from, to]: &[Point; 2], reach: f64| {
            let shortest = (from - end).norm().min((to - end).norm()) - slowed;
            if shortest > reach { reach / shortest } else { 1.0 }
        };
        let [from, to] = seen(outlet);
        let across = |normal: &Vector| normal.cross(&piece.body_axis).norm();
        match &cable.envelope {
            None => {
                let sag = piece.sag_seen(outlet);
                let chord = || {
                    let share = share(&[from, to], reach());
                    (Triangle::new(end, end + (from - end) * share, end + (to - end) * share), share * sag)
                };
                let along = |normal: &Vector| piece.sag_seen_along(outlet, across(normal));
                self.demand.kept(chord, [from - end, to - end], along, body)
            }
            Some(envelope) => {
                let exits = envelope.lowered_exits.vertices();
                let deviation = exits.iter().map(|exit| piece.sag_seen(exit)).fold(0.0, f64::max);
                // How far all points between the exits are at least: along the direction to the outlet.
                let far = |k: usize| {
                    let along = ([from, to][k] - end).normalize();
                    exits.iter().map(|exit| (seen(exit)[k] - end).dot(&along)).fold(f64::INFINITY, f64::min)
                };
                let (reach, shortest) = (reach(), far(0).min(far(1)) - slowed);
                let share = if shortest > reach { reach / shortest } else { 1.0 };
                let nearer = |p: Point| end + (p - end) * share;
                let points: Vec<Point> = exits.iter().flat_map(|exit| seen(exit).map(nearer)).collect();
                let chord = || {
                    let fan = Fan { points: &points, copies: [Fan::AS_IT_IS; 3], ends: [end; 4] };
                    (CableSweep::Fan(fan), share * deviation)
                };
                // How much lower it can go than the outlet's chord: at either end of the piece, and in between.
                let along = |normal: &Vector| {
                    let below = |exit: &Point| {
                        let [a, b] = seen(exit);
                        normal.dot(&(from - a)).max(normal.dot(&(to - b))) + piece.sag_seen_along(exit, across(normal))
                    };
                    exits.iter().map(below).fold(f64::NEG_INFINITY, f64::max)
                        + piece.sag_seen_along(outlet, across(normal))
                };
                self.demand.kept(chord, [from - end, to - end], along, body)
            }
        }
    }

    fn forbidden(&self, bodies: &Bodies, gap: f64, _: &Fattened) -> Option<ForbiddenPolyhedron> {
        let cable = &bodies.cables[self.cable];
        let apex = self.apex(bodies);
        let body = fattened(&bodies.platform[self.body], gap)?;
        if let (Some(envelope), false) = (&cable.envelope, self.ends_on_body()) {
            // The opposite of the positions: the body moved by minus each exit, and everything behind.
            let exits = envelope.lowered_exits.reflected();
            let moved = body.sum(&exits).ok()?;
            let Shadow { half_spaces, tilt } = Cone::around(&body, &apex)?.added_to(&moved, exits.edge_axes());
            return Some(ForbiddenPolyhedron { half_spaces, tilt }.placed(|h| h.reflected(&Vector::zeros())));
        }
        let found = self.demand.behind(|| shadow(&body, &apex), &apex, |n| cable.lower_at_platform(n))?;
        Some(found.placed(|h| h.reflected(&cable.outlet.coords)))
    }

    fn rounded(&self, bodies: &Bodies, _: &Fattened) -> Option<Vec<HalfSpace>> {
        let gap = self.demand.distance().filter(|_| bodies.cables[self.cable].envelope.is_none())?;
        let part = &bodies.platform[self.body];
        let planes = rounded_shadow(part, &self.apex(bodies), gap, &directions(part))?;
        Some(planes.iter().map(|h| h.reflected(&bodies.cables[self.cable].outlet.coords)).collect())
    }

    fn regions(&self, bodies: &Bodies, scale: &Scale, fat: &Fattened) -> Vec<Region> {
        let set = |gap: f64| self.forbidden(bodies, gap, fat);
        vec![Region::bracketed(set, self.demand.gap_and_touch(), scale)]
    }
}
