//! Cables stay clear of obstacles.
//!
//! The forbidden positions are the shadow of the obstacle seen from the outlet B, moved by minus the arm R a. If the
//! outlet is on the obstacle, they are the cone of directions below all facets that are active there.

use super::bodies::{Bodies, CableAt, ObstacleBody};
use super::cable_and_body::{CABLE, CableDemand, rounded_shadow};
use super::exempt::Remarks;
use super::fattened::Fattened;
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{ForbiddenPolyhedron, Region, Scale};
use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::{Aabb, HalfSpace, Placed, Point, Triangle, TurningPiece, Vector};
use crate::model::{Member, Scene};
use crate::watch::Watch;

/// A cable stays clear of an obstacle body.
#[derive(Debug, Clone, PartialEq)]
pub struct CableObstacle {
    /// Index of the cable.
    pub cable: usize,
    /// Index into [`Bodies::obstacles`].
    pub body: usize,
    /// How the cable must stay clear of the body.
    pub demand: CableDemand,
}

impl CableObstacle {
    /// The condition on a cable and an obstacle body, at `index` in the list.
    fn of([index, cable, body]: [usize; 3], bodies: &Bodies, clearance: f64, remarks: &mut Remarks) -> Self {
        let CableAt { outlet, radius, ref name, .. } = bodies.cables[cable];
        let obstacle = &bodies.obstacles[body];
        let with = |demand: CableDemand| CableObstacle { cable, body, demand };
        let normals = obstacle.body.active_normals(&outlet);
        if !normals.is_empty() {
            return with(CableDemand::Leave { normals });
        }
        if let Some(gap) = obstacle.seam {
            return with(CableDemand::Outside { touch: gap.touch });
        }
        let (gap, distance) =
            (clearance + radius, shape_distance(&Triangle::new(outlet, outlet, outlet), &obstacle.body).distance);
        let carries = |b: &ObstacleBody| b.between == obstacle.between && !b.body.active_normals(&outlet).is_empty();
        // A neighbouring part of the body that the winch is bolted to may be closer than the clearance.
        if distance >= gap || bodies.obstacles.iter().any(carries) {
            let pair = (index, [Member::Cable(cable), obstacle.member()]);
            return with(CableDemand::Apart { gap: remarks.kept(bodies, pair, [clearance, radius, distance]) });
        }
        remarks.notes.push(format!(
            "the outlet of {name} is {distance:.4} m from {other} and can never keep {gap:.4} m from it: every position \
             is refused; give the pair a smaller clearance in [[clearances.pairs]], or let it touch: \
             touch = [[\"{name}\", \"{other}\"]]",
            other = obstacle.name
        ));
        with(CableDemand::Apart { gap })
    }
}

impl PhysicalCondition for CableObstacle {
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
            for (body, obstacle) in bodies.obstacles.iter().enumerate() {
                let is_needed = obstacle.seam.is_none_or(|gap| gap.admits(CABLE));
                if is_needed && !obstacle.ignored(scene, Member::Cable(cable)) {
                    let clearance = scene.pairs().clearance(Member::Cable(cable), obstacle.member());
                    all.push(CableObstacle::of([first + all.len(), cable, body], bodies, clearance, remarks));
                }
            }
        }
        Ok(all)
    }

    fn sentence(found: &Broken) -> String {
        found.meets(found.name(0), found.name(1))
    }

    fn kind(&self) -> Kind {
        Kind::CableObstacle
    }

    fn members(&self, bodies: &Bodies) -> Vec<Member> {
        vec![Member::Cable(self.cable), bodies.obstacles[self.body].member()]
    }

    fn obstacle_mut(&mut self) -> Option<&mut usize> {
        Some(&mut self.body)
    }

    fn obstacles(&self, bodies: &Bodies) -> Vec<usize> {
        bodies.obstacles[self.body].between.clone()
    }

    fn closes_seam(&self, bodies: &Bodies) -> bool {
        bodies.obstacles[self.body].seam.is_some()
    }

    fn is_seam_beside(&self, other: &dyn PhysicalCondition, bodies: &Bodies) -> bool {
        let beside = &bodies.obstacles[self.body].between;
        self.closes_seam(bodies)
            && other.kind() == self.kind()
            && !other.closes_seam(bodies)
            && matches!(other.members(bodies)[..], [cable, Member::Obstacle(part)]
                if cable == Member::Cable(self.cable) && beside.contains(&part))
    }

    fn required(&self, bodies: &Bodies) -> f64 {
        self.demand.required(bodies.cables[self.cable].radius)
    }

    fn is_about_gap(&self, _: &Bodies) -> bool {
        self.demand.is_about_gap()
    }

    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let cable = &bodies.cables[self.cable];
        shape_distance(&cable.sweep(from, to), &bodies.obstacles[self.body].body).signed() - cable.radius
    }

    fn nearest_points(&self, bodies: &Bodies, position: &Point) -> Option<[Point; 2]> {
        let cable = &bodies.cables[self.cable];
        let found = shape_distance(&cable.sweep(position, position), &bodies.obstacles[self.body].body);
        Some([found.on_a + found.axis * cable.radius, found.on_b])
    }

    fn boxes_apart(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let cable = &bodies.cables[self.cable];
        let swept = Aabb::around(&cable.sweep(from, to).corners);
        let apart = swept.distance(bodies.obstacles[self.body].body.aabb());
        if apart > 0.0 { apart - cable.radius } else { f64::NEG_INFINITY }
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
        let along = |p: &Point| p + cable.arm - cable.outlet;
        let sweep = || cable.sweep(from, to);
        self.demand.broken_by(sweep, [along(from), along(to)], &bodies.obstacles[self.body].body)
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let CableAt { outlet, arm, .. } = &bodies.cables[self.cable];
        let end = at.point(arm);
        let cable = || Triangle::new(*outlet, end, end);
        self.demand.slack(cable, &(end - outlet), &bodies.obstacles[self.body].body)
    }

    #[inline]
    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let CableAt { outlet, arm, .. } = &bodies.cables[self.cable];
        let [from, to] = piece.points(arm);
        let sag = piece.sag(arm);
        let chord = || (Triangle::new(*outlet, from, to), sag);
        let along = |normal: &Vector| piece.sag_along(arm, piece.share_along(normal));
        self.demand.kept(chord, [from - outlet, to - outlet], along, &bodies.obstacles[self.body].body)
    }

    fn forbidden(&self, bodies: &Bodies, gap: f64, fat: &Fattened) -> Option<ForbiddenPolyhedron> {
        let cable = &bodies.cables[self.cable];
        let found = self.demand.behind(&*fat.obstacle(bodies, self.body, gap)?, &cable.outlet)?;
        Some(found.placed(|h| h.moved(&-cable.arm)))
    }

    fn rounded(&self, bodies: &Bodies, fat: &Fattened) -> Option<Vec<HalfSpace>> {
        let gap = self.demand.distance()?;
        let (cable, obstacle) = (&bodies.cables[self.cable], &bodies.obstacles[self.body].body);
        let planes = rounded_shadow(obstacle, &cable.outlet, gap, &fat.directions(bodies, self.body))?;
        Some(planes.iter().map(|h| h.moved(&-cable.arm)).collect())
    }

    fn fattens(&self) -> Option<(usize, f64)> {
        self.demand.distance().map(|gap| (self.body, gap))
    }

    fn regions(&self, bodies: &Bodies, scale: &Scale, fat: &Fattened) -> Vec<Region> {
        let set = |gap: f64| self.forbidden(bodies, gap, fat);
        vec![Region::bracketed(set, self.demand.gap_and_touch(), scale)]
    }

    fn attachment(&self, bodies: &Bodies) -> Vector {
        bodies.cables[self.cable].arm
    }
}
