//! The platform stays clear of obstacles.
//!
//! For an obstacle O and a part P of the platform the forbidden positions are O ⊕ (-P).

use super::bodies::Bodies;
use super::cable_and_body::{apart_by, too_close};
use super::exempt::Remarks;
use super::fattened::{Fattened, around, directions, fattened};
use super::physical::{Broken, Interference, Kind, PhysicalCondition, surface};
use super::region::{ForbiddenPolyhedron, Region, Scale};
use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::{
    Aabb, HalfSpace, Placed, PlacedBody, Point, Polytope, SupportMap, Swept, TriangleMesh, TurnedSweep, TurningPiece,
    Vector,
};
use crate::model::{Member, Scene};
use crate::tolerances::TOUCH_DEPTH;
use crate::watch::Watch;

/// A platform part keeps the distance `gap` from an obstacle body.
#[derive(Debug, Clone, PartialEq)]
pub struct PlatformObstacle {
    /// Index into [`Bodies::platform`].
    pub part: usize,
    /// Index into [`Bodies::obstacles`].
    pub body: usize,
    /// Required distance, m.
    pub gap: f64,
}

impl PlatformObstacle {
    /// Obstacle ⊕ (-platform part); `None` if it has no hull.
    fn difference(&self, bodies: &Bodies) -> Option<Polytope> {
        bodies.obstacles[self.body].body.sum(&bodies.platform[self.part].reflected()).ok()
    }

    /// The depth that still counts as touching, m.
    #[inline]
    fn touch(&self, bodies: &Bodies) -> f64 {
        bodies.obstacles[self.body].seam.map_or(TOUCH_DEPTH, |gap| gap.touch)
    }
}

impl PhysicalCondition for PlatformObstacle {
    fn all(scene: &Scene, bodies: &Bodies, _: usize, _: &mut Remarks, _: &Watch) -> Result<Vec<Self>, Error> {
        let mut all = Vec::new();
        for (body, obstacle) in bodies.obstacles.iter().enumerate() {
            if obstacle.ignored(scene, Member::Platform) {
                continue;
            }
            for part in 0..bodies.platform_parts {
                if obstacle.seam.is_some_and(|gap| !gap.admits(bodies.platform[part].dimension())) {
                    continue;
                }
                let gap = match obstacle.seam {
                    Some(_) => 0.0,
                    None => scene.pairs().clearance(Member::Platform, obstacle.member()),
                };
                all.push(PlatformObstacle { part, body, gap });
            }
        }
        Ok(all)
    }

    fn sentence(found: &Broken) -> String {
        found.meets("the platform", found.name(1))
    }

    fn kind(&self) -> Kind {
        Kind::PlatformObstacle
    }

    fn members(&self, bodies: &Bodies) -> Vec<Member> {
        vec![Member::Platform, bodies.obstacles[self.body].member()]
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

    fn required(&self, _: &Bodies) -> f64 {
        self.gap
    }

    fn is_about_gap(&self, bodies: &Bodies) -> bool {
        !self.closes_seam(bodies)
    }

    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let swept = Swept::new(&bodies.platform[self.part], from.coords, to - from);
        shape_distance(&swept, &bodies.obstacles[self.body].body).signed()
    }

    fn nearest_points(&self, bodies: &Bodies, position: &Point) -> Option<[Point; 2]> {
        let placed = Swept::new(&bodies.platform[self.part], position.coords, Vector::zeros());
        let found = shape_distance(&placed, &bodies.obstacles[self.body].body);
        Some([found.on_a, found.on_b])
    }

    fn boxes_apart(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let swept = bodies.platform[self.part].aabb().swept(&from.coords, &to.coords);
        let apart = swept.distance(bodies.obstacles[self.body].body.aabb());
        if apart > 0.0 { apart } else { f64::NEG_INFINITY }
    }

    fn is_rounded(&self) -> bool {
        self.gap > 0.0
    }

    #[inline]
    fn breaks(&self, bodies: &Bodies, _: Interference, from: &Point, to: &Point) -> bool {
        let (part, obstacle) = (&bodies.platform[self.part], &bodies.obstacles[self.body]);
        let bounds = part.aabb().swept(&from.coords, &to.coords);
        let swept = Swept::new(part, from.coords, to - from);
        !bounds.apart_by(obstacle.body.aabb(), self.gap)
            && too_close(&swept, &obstacle.body, self.gap, self.touch(bodies))
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let part = PlacedBody { body: &bodies.platform[self.part], at };
        let distance = shape_distance(&part, &bodies.obstacles[self.body].body).signed();
        distance - self.gap + (self.touch(bodies) - TOUCH_DEPTH)
    }

    #[inline]
    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let (part, obstacle) = (&bodies.platform[self.part], &bodies.obstacles[self.body].body);
        let reach = bodies.platform_reach[self.part];
        let bounds = Aabb::around(&piece.ends.map(|end| end.position));
        if bounds.distance(obstacle.aabb()) > self.gap + reach + piece.apart.position {
            return true;
        }
        let wanted = if self.gap > 0.0 { self.gap - TOUCH_DEPTH } else { -self.touch(bodies) };
        let swept = TurnedSweep { body: part, ends: &piece.ends };
        apart_by(&swept, obstacle, wanted + piece.sag_within(reach))
            || obstacle.facets().iter().any(|face| {
                let sag = piece.sag_within_along(reach, piece.share_along(&face.normal));
                face.height(&swept.support(&-face.normal)) >= wanted + sag
            })
    }

    fn forbidden(&self, bodies: &Bodies, gap: f64, _: &Fattened) -> Option<ForbiddenPolyhedron> {
        let sum = self.difference(bodies)?;
        if sum.has_volume() {
            return Some(ForbiddenPolyhedron::exact(around(&sum, gap)));
        }
        let fat = fattened(&sum, gap)?;
        fat.has_volume().then(|| ForbiddenPolyhedron::exact(fat.half_spaces()))
    }

    fn rounded(&self, bodies: &Bodies, _: &Fattened) -> Option<Vec<HalfSpace>> {
        if self.gap <= 0.0 {
            return None;
        }
        let sum = self.difference(bodies).filter(Polytope::has_volume)?;
        let plane = |n: Vector| HalfSpace::around(sum.vertices(), n).widened(self.gap);
        Some(directions(&sum).into_iter().map(plane).collect())
    }

    fn forbidden_inside(&self, bodies: &Bodies, fat: &Fattened) -> Option<ForbiddenPolyhedron> {
        if self.gap <= 0.0 {
            return None;
        }
        let obstacle = fat.obstacle(bodies, self.body, self.gap)?;
        let sum = obstacle.sum(&bodies.platform[self.part].reflected()).ok()?;
        sum.has_volume().then(|| ForbiddenPolyhedron::exact(sum.half_spaces()))
    }

    fn regions(&self, bodies: &Bodies, scale: &Scale, fat: &Fattened) -> Vec<Region> {
        let set = |gap: f64| self.forbidden(bodies, gap, fat);
        vec![Region::bracketed(set, [self.gap, self.touch(bodies)], scale)]
    }

    fn surfaces(&self, bodies: &Bodies, by: &Vector, within: &Aabb) -> Option<Vec<TriangleMesh>> {
        let found = self.forbidden(bodies, 0.0, &Fattened::default())?;
        Some(surface(&found, by, within).into_iter().collect())
    }
}
