//! The platform stays inside the workspace.

use super::bodies::Bodies;
use super::exempt::Remarks;
use super::fattened::Fattened;
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{Region, Scale};
use crate::error::Error;
use crate::geometry::{Aabb, Cuboid, Placed, Point, TurningPiece, Vector};
use crate::model::{Member, Scene};
use crate::tolerances::TOUCH_DEPTH;
use crate::watch::Watch;

/// The box of positions of the platform's origin for which every vertex stays in the workspace.
#[derive(Debug, Clone, PartialEq)]
pub struct Workspace {
    /// Smallest position, m.
    pub min: Point,
    /// Largest position, m.
    pub max: Point,
    /// The box in which every vertex of the platform must stay, m.
    pub limits: Aabb,
}

impl Workspace {
    /// The positions where the platform is inside the workspace of a scene; possibly empty (min > max).
    fn of(scene: &Scene, bodies: &Bodies) -> Self {
        let vertices = || bodies.platform.iter().flat_map(|part| part.vertices());
        let low = vertices().fold(Vector::repeat(f64::INFINITY), |low, v| low.inf(&v.coords));
        let high = vertices().fold(Vector::repeat(f64::NEG_INFINITY), |high, v| high.sup(&v.coords));
        let (mut min, mut max) = (scene.workspace().min - low, scene.workspace().max - high);
        for axis in 0..3 {
            // A platform as large as the workspace has exactly one position; rounding must not exclude it.
            if max[axis] < min[axis] && min[axis] - max[axis] <= TOUCH_DEPTH {
                let middle = 0.5 * (min[axis] + max[axis]);
                (min[axis], max[axis]) = (middle, middle);
            }
        }
        Workspace { min, max, limits: *scene.workspace() }
    }

    /// Smallest distance from the workspace limits over a motion, m; negative outside.
    #[inline]
    fn room(&self, from: &Point, to: &Point) -> f64 {
        if !from.iter().chain(to.iter()).all(|x| x.is_finite()) {
            return f64::NEG_INFINITY;
        }
        let room = |p: &Point| (p - self.min).inf(&(self.max - p)).min();
        room(from).min(room(to))
    }
}

impl PhysicalCondition for Workspace {
    fn all(scene: &Scene, bodies: &Bodies, _: usize, _: &mut Remarks, _: &Watch) -> Result<Vec<Self>, Error> {
        Ok(vec![Workspace::of(scene, bodies)])
    }

    fn sentence(found: &Broken) -> String {
        format!("the platform leaves the workspace{}", found.lacking())
    }

    fn kind(&self) -> Kind {
        Kind::Workspace
    }

    fn members(&self, _: &Bodies) -> Vec<Member> {
        vec![Member::Platform]
    }

    fn required(&self, _: &Bodies) -> f64 {
        0.0
    }

    fn distance(&self, _: &Bodies, from: &Point, to: &Point) -> f64 {
        self.room(from, to)
    }

    fn worst_distance(&self, _: &Bodies, _: Interference, from: &Point, to: &Point) -> Option<f64> {
        Some(self.room(from, to))
    }

    /// Always false, since boxes lie inside the box of positions.
    fn forbids_all(&self, _: &Bodies, _: &Cuboid, _: f64) -> bool {
        false
    }

    #[inline]
    fn breaks(&self, _: &Bodies, _: Interference, from: &Point, to: &Point) -> bool {
        self.room(from, to) < -TOUCH_DEPTH
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let Aabb { min, max } = &self.limits;
        let corners = bodies.platform.iter().flat_map(|part| part.vertices()).map(|v| at.point(&v.coords));
        corners.map(|v| (v - min).inf(&(max - v)).min()).fold(f64::INFINITY, f64::min)
    }

    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let reach = bodies.platform_reach.iter().copied().fold(0.0, f64::max);
        let Aabb { min, max } = &self.limits;
        let room = |point: &Point| (point - min).inf(&(max - point));
        if piece.ends.iter().all(|end| room(&end.position).min() > reach + piece.apart.position) {
            return true;
        }
        let share = |axis: usize| piece.share_along(&Vector::ith(axis, 1.0));
        let sags = Vector::from_fn(|axis, _| piece.sag_within_along(reach, share(axis)));
        let inside = |corner: &Point| (room(corner) - sags).min() >= -TOUCH_DEPTH;
        let mut corners = bodies.platform.iter().flat_map(|part| part.vertices());
        corners.all(|corner| piece.ends.iter().all(|end| inside(&end.point(&corner.coords))))
    }

    /// The workspace forbids only positions outside the box of positions.
    fn regions(&self, _: &Bodies, _: &Scale, _: &Fattened) -> Vec<Region> {
        Vec::new()
    }
}
