//! An engine that also checks wrench feasibility, after all cheaper checks.

use std::sync::Arc;

use super::constraint::WrenchConstraint;
use crate::collision::{
    Checker, Clearance, Conditions, Interference, Piece, Polyhedron, Slack, Unproved, Validity, Violation,
};
use crate::error::Error;
use crate::geometry::{Cuboid, Point};
use crate::model::Scene;
use crate::watch::Watch;

/// A geometric engine combined with the wrench constraint.
pub struct WrenchChecker {
    geometry: Box<dyn Checker>,
    wrench: WrenchConstraint,
}

impl WrenchChecker {
    /// Checks geometry first, then wrenches.
    pub fn new(geometry: Box<dyn Checker>, wrench: WrenchConstraint) -> Self {
        WrenchChecker { geometry, wrench }
    }
}

/// The engine of a scene from an engine that checks its geometry: one that also checks wrenches if the scene requires any.
///
/// # Errors
/// The errors of [`WrenchConstraint::of`].
pub fn with_wrench(geometry: Box<dyn Checker>, scene: &Scene) -> Result<Box<dyn Checker>, Error> {
    Ok(match WrenchConstraint::of(scene, geometry.conditions())? {
        Some(wrench) => Box::new(WrenchChecker::new(geometry, wrench)),
        None => geometry,
    })
}

impl Checker for WrenchChecker {
    fn conditions(&self) -> &Conditions {
        self.geometry.conditions()
    }

    fn interference(&self) -> Interference {
        self.geometry.interference()
    }

    fn geometry_for(&self, scene: &Scene, watch: &Watch) -> Result<Box<dyn Checker>, Error> {
        self.geometry.geometry_for(scene, watch)
    }

    fn breaks(&self, index: usize, from: &Point, to: &Point) -> bool {
        self.geometry.breaks(index, from, to)
    }

    fn certain_polyhedra(&self, watch: &Watch) -> Result<Arc<Vec<Polyhedron>>, Error> {
        self.geometry.certain_polyhedra(watch)
    }

    fn pieces(&self, watch: &Watch) -> Result<Arc<Vec<Piece>>, Error> {
        self.geometry.pieces(watch)
    }

    fn lacking_wrench(&self, positions: &Cuboid) -> Option<[f64; 6]> {
        self.wrench.lacking(positions)
    }

    fn wrench_over(&self, positions: &Cuboid, known: Option<&[Unproved]>) -> Option<Vec<Unproved>> {
        self.wrench.over(positions, known)
    }

    fn wrench_slack(&self, positions: &Cuboid, known: Option<&[Unproved]>) -> Slack {
        self.wrench.slack(positions, known)
    }

    fn first_contact(&self, from: &Point, to: &Point) -> Option<(f64, usize)> {
        self.geometry.first_contact(from, to)
    }

    fn gap(&self, from: &Point, to: &Point) -> Option<f64> {
        self.geometry.gap(from, to)
    }

    fn free_of_interference(&self, position: &Point) -> bool {
        self.geometry.free_of_interference(position)
    }
}

impl Validity for WrenchChecker {
    fn state_valid(&self, position: &Point) -> bool {
        self.geometry.state_valid(position) && self.wrench.keeps(position, position)
    }

    fn motion_valid(&self, from: &Point, to: &Point) -> bool {
        self.geometry.motion_valid(from, to) && self.wrench.keeps(from, to)
    }

    /// Facets of the available wrenches grow with the fifth power of the number of cables.
    fn may_be_slow(&self) -> bool {
        true
    }

    fn violations(&self, from: &Point, to: &Point) -> Vec<Violation> {
        let mut violations = self.geometry.violations(from, to);
        violations.extend(self.wrench.violation(from, to));
        violations.sort_by(|a, b| a.at.total_cmp(&b.at));
        violations
    }

    fn clearance(&self, from: &Point, to: &Point) -> Option<Clearance> {
        self.geometry.clearance(from, to)
    }
}
