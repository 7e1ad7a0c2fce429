//! The paper's engine: GJK between obstacles and what platform and cables sweep (sections 3.1 and 3.2). It works for any
//! convex shape, yields distances, and is the reference for faster engines.

use super::constraint::{Constraint, Constraints, Demand};
use super::explain;
use super::validity::{Checker, Clearance, Interference, Validity, Violation};
use crate::error::Error;
use crate::geometry::gjk::{nearer_than, overlap};
use crate::geometry::{Aabb, ConvexShape, Point, Polytope, Swept, Triangle, Vector};
use crate::model::Scene;
use crate::numerics::TOUCH_DEPTH;
use crate::watch::Watch;

/// Answers the constraints of a scene at its orientation by GJK.
///
/// # Example
/// ```
/// use cdpr_core::collision::{GjkEngine, Interference, Validity};
/// use cdpr_core::{geometry::Point, testing};
/// let scene = testing::hard1();
/// let engine = GjkEngine::new(&scene, Interference::Exact)?;
/// let (start, goal) = (scene.start().unwrap(), scene.goal().unwrap());
/// assert!(engine.state_valid(&start));
/// assert!(!engine.motion_valid(&start, &goal)); // the pillar stands in between
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct GjkEngine {
    constraints: Constraints,
    interference: Interference,
}

impl GjkEngine {
    /// The engine for a scene.
    ///
    /// # Errors
    /// As [`Constraints::new`].
    pub fn new(scene: &Scene, interference: Interference) -> Result<Self, Error> {
        Self::within(scene, interference, &Watch::NONE)
    }

    /// As [`GjkEngine::new`], within a watch.
    ///
    /// # Errors
    /// As [`Constraints::within`].
    pub fn within(scene: &Scene, interference: Interference, watch: &Watch) -> Result<Self, Error> {
        Ok(GjkEngine { constraints: Constraints::within(scene, watch)?, interference })
    }

    /// Whether a motion breaks one constraint.
    pub(super) fn breaks_constraint(&self, constraint: &Constraint, from: &Point, to: &Point) -> bool {
        let c = &self.constraints;
        match constraint {
            Constraint::Workspace { .. } | Constraint::CableLength { .. } => {
                explain::room(&self.constraints, constraint, from, to) < -TOUCH_DEPTH
            }
            Constraint::CablePlatform { cable, body, demand } => {
                let cable = &c.cables[*cable];
                let along = |p: &Point| cable.outlet - (p + cable.arm);
                let sweep = || cable.sweep_seen_from_platform(from, to);
                cable_breaks(demand, sweep, [along(from), along(to)], &c.platform[*body])
            }
            Constraint::CableCable(pair) => {
                let swept = || {
                    let sweep = |cable: usize| c.cables[cable].sweep(from, to);
                    nearer_than(&sweep(pair.first), &sweep(pair.second), pair.gap.max(2.0 * TOUCH_DEPTH))
                };
                (pair.crosses(from, to))
                    || (self.interference == Interference::Swept && swept())
                    || (self.interference == Interference::Exact && pair.gap > 0.0 && pair.nearer_than_gap(from, to))
            }
            Constraint::PlatformObstacle { part, body, gap } => {
                let (part, obstacle) = (&c.platform[*part], &c.obstacles[*body]);
                let bounds = part.aabb().swept(&from.coords, &to.coords);
                let swept = Swept::new(part, from.coords, to - from);
                !bounds.apart_by(obstacle.body.aabb(), *gap)
                    && too_close(&swept, &obstacle.body, *gap, obstacle.seam.unwrap_or(TOUCH_DEPTH))
            }
            Constraint::CableObstacle { cable, body, demand } => {
                let cable = &c.cables[*cable];
                let along = |p: &Point| p + cable.arm - cable.outlet;
                let sweep = || cable.sweep(from, to);
                cable_breaks(demand, sweep, [along(from), along(to)], &c.obstacles[*body].body)
            }
        }
    }
}

impl Checker for GjkEngine {
    fn constraints(&self) -> &Constraints {
        &self.constraints
    }

    fn interference(&self) -> Interference {
        self.interference
    }

    fn breaks(&self, index: usize, from: &Point, to: &Point) -> bool {
        self.breaks_constraint(&self.constraints.list[index], from, to)
    }
}

impl Validity for GjkEngine {
    fn state_valid(&self, position: &Point) -> bool {
        self.motion_valid(position, position)
    }

    fn motion_valid(&self, from: &Point, to: &Point) -> bool {
        let finite = from.iter().chain(to.iter()).all(|x| x.is_finite());
        finite && !self.constraints.list.iter().any(|constraint| self.breaks_constraint(constraint, from, to))
    }

    fn violations(&self, from: &Point, to: &Point) -> Vec<Violation> {
        explain::violations(self, from, to)
    }

    fn clearance(&self, from: &Point, to: &Point) -> Option<Clearance> {
        explain::clearance(&self.constraints, from, to)
    }
}

/// Whether a moving cable breaks a demand: by the triangle it sweeps, or by its direction (at the start and at the end of
/// the motion) from where it ends on the body.
#[inline]
fn cable_breaks(demand: &Demand, sweep: impl FnOnce() -> Triangle, along: [Vector; 2], body: &Polytope) -> bool {
    let (gap, touch) = match demand {
        Demand::Leave { normals } => return goes_below_all(normals, along[0], along[1]),
        Demand::Apart { gap } => (*gap, TOUCH_DEPTH),
        Demand::Outside { touch } => (0.0, *touch),
    };
    let cable = sweep();
    !Aabb::around(&cable.corners).apart_by(body.aabb(), gap) && too_close(&cable, body, gap, touch)
}

#[inline]
fn too_close(a: &impl ConvexShape, b: &impl ConvexShape, gap: f64, touch: f64) -> bool {
    if gap > 0.0 { nearer_than(a, b, gap) } else { overlap(a, b, touch) }
}

/// Whether a direction that goes linearly from `start` to `end` lies below all planes through the origin at some instant.
fn goes_below_all(normals: &[Vector], start: Vector, end: Vector) -> bool {
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for normal in normals {
        let (a, b) = (normal.dot(&start) + TOUCH_DEPTH, normal.dot(&end) + TOUCH_DEPTH);
        match (a < 0.0, b < 0.0) {
            (true, true) => {}
            (false, false) => return false,
            (false, true) => low = low.max(a / (a - b)),
            (true, false) => high = high.min(a / (a - b)),
        }
    }
    low < high
}
