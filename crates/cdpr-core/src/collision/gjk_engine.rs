//! The paper's engine: GJK between obstacles and the swept platform and cables (sections 3.1 and 3.2). It works for any
//! convex shape, yields distances, and is the reference for faster engines.

use std::sync::Arc;

use super::along::either_way;
use super::clearance::{self, Clearance};
use super::explain;
use super::validity::{Checker, Validity};
use super::violation::Violation;
use crate::conditions::{Conditions, Interference, KeptPolyhedra, Piece, Polyhedron};
use crate::error::Error;
use crate::geometry::Point;
use crate::model::Scene;
use crate::watch::Watch;

/// Checks the conditions of a scene at its orientation by GJK.
///
/// # Example
/// ```
/// use cdpr_core::{Interference, Validity, collision::GjkEngine};
/// use cdpr_core::{Point, testing};
/// let scene = testing::hard1();
/// let engine = GjkEngine::new(&scene, Interference::Exact)?;
/// let (start, goal) = (scene.start().unwrap(), scene.goal().unwrap());
/// assert!(engine.state_valid(&start));
/// assert!(!engine.motion_valid(&start, &goal)); // the pillar stands in between
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct GjkEngine {
    conditions: Conditions,
    interference: Interference,
    forbidden: KeptPolyhedra,
}

impl GjkEngine {
    /// The engine for a scene.
    ///
    /// # Errors
    /// The errors of [`Conditions::new`].
    pub fn new(scene: &Scene, interference: Interference) -> Result<Self, Error> {
        Self::within(scene, interference, &Watch::NONE)
    }

    /// The engine for a scene, compiled within a watch.
    ///
    /// # Errors
    /// The errors of [`Conditions::within`].
    pub fn within(scene: &Scene, interference: Interference, watch: &Watch) -> Result<Self, Error> {
        let conditions = Conditions::within(scene, watch)?;
        Ok(GjkEngine { conditions, interference, forbidden: KeptPolyhedra::default() })
    }
}

impl Checker for GjkEngine {
    fn conditions(&self) -> &Conditions {
        &self.conditions
    }

    fn interference(&self) -> Interference {
        self.interference
    }

    fn geometry_for(&self, scene: &Scene, watch: &Watch) -> Result<Box<dyn Checker>, Error> {
        Ok(Box::new(GjkEngine::within(scene, self.interference, watch)?))
    }

    fn breaks(&self, index: usize, from: &Point, to: &Point) -> bool {
        let [from, to] = either_way(from, to);
        self.conditions.list[index].breaks(&self.conditions.bodies, self.interference, from, to)
    }

    fn certain_polyhedra(&self, watch: &Watch) -> Result<Arc<Vec<Polyhedron>>, Error> {
        self.forbidden.certain(|| self.conditions.certain_polyhedra(watch))
    }

    fn pieces(&self, watch: &Watch) -> Result<Arc<Vec<Piece>>, Error> {
        self.forbidden.pieces(|| self.conditions.pieces(watch))
    }
}

impl Validity for GjkEngine {
    fn state_valid(&self, position: &Point) -> bool {
        self.motion_valid(position, position)
    }

    fn motion_valid(&self, from: &Point, to: &Point) -> bool {
        let finite = from.iter().chain(to.iter()).all(|x| x.is_finite());
        let Conditions { bodies, list, .. } = &self.conditions;
        let [from, to] = either_way(from, to);
        finite && !list.iter().any(|condition| condition.breaks(bodies, self.interference, from, to))
    }

    fn violations(&self, from: &Point, to: &Point) -> Vec<Violation> {
        explain::violations(self, from, to)
    }

    fn clearance(&self, from: &Point, to: &Point) -> Option<Clearance> {
        clearance::clearance(&self.conditions, from, to)
    }
}
