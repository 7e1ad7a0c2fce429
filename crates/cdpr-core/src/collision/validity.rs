//! The interfaces that every engine implements.

use std::sync::Arc;

use super::along::{at, first_true};
use super::clearance::{self, Clearance};
use super::violation::Violation;
use crate::choices;
use crate::conditions::{Conditions, Interference, Piece, Polyhedron};
use crate::error::Error;
use crate::geometry::{Cuboid, Point, Quadratic};
use crate::model::Scene;
use crate::watch::Watch;

/// The collision engines.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Engine {
    /// Convex polyhedra in configuration space: exact and fast.
    #[default]
    Cspace,
    /// GJK on swept bodies, as in the paper.
    Gjk,
}

choices!(Engine, "engine", [
    Cspace = "cspace": "Convex polyhedra in configuration space: exact and fast",
    Gjk = "gjk": "GJK on swept bodies: the paper's method, and the reference",
]);

/// Whether a robot may be in a state, or move between two states in a straight line.
///
/// The state is a position of the platform's origin (world, m) at the fixed orientation of the engine, or a pose if the
/// platform may turn. Implementations are immutable and shared between threads.
pub trait Validity<State = Point>: Sync {
    /// Whether the robot may be in a state.
    fn state_valid(&self, state: &State) -> bool;

    /// Whether the robot may move straight from one state to another; both ends are part of the motion.
    fn motion_valid(&self, from: &State, to: &State) -> bool;

    /// All conditions that a motion breaks, in the order of first contact; empty if it is valid.
    fn violations(&self, from: &State, to: &State) -> Vec<Violation>;

    /// The closest approach of a motion to anything the robot must stay clear of; `None` if there is no such thing.
    fn clearance(&self, from: &State, to: &State) -> Option<Clearance>;

    /// Whether one check may take many milliseconds. Planners then poll the clock before each check, not only now and
    /// then.
    fn may_be_slow(&self) -> bool {
        false
    }

    /// The first condition that a motion breaks.
    fn explain(&self, from: &State, to: &State) -> Option<Violation> {
        self.violations(from, to).into_iter().next()
    }
}

/// What of a required set of wrenches is not proved to be available at all positions of a box.
#[derive(Debug, Clone, PartialEq)]
pub enum Unproved {
    /// Nothing is known.
    All,
    /// All is proved.
    Nothing,
    /// Only some facets of the available set may be too near.
    Facets {
        /// Bounds of the slack to facets over this box or one around it.
        known: Arc<FacetBounds>,
        /// The bounds that may be negative, by index.
        open: Vec<u32>,
        /// Facets without such bounds, by the cables that span them as bit masks.
        others: Vec<u32>,
    },
}

/// Bounds of the slack to facets over a box, each with the cables that span the facet as a bit mask. They may be scaled.
#[derive(Debug, Clone, PartialEq)]
pub struct FacetBounds {
    /// The box.
    pub positions: Cuboid,
    /// The bounds.
    pub slack: Vec<(u32, Quadratic)>,
}

/// Functions over a box that tell where the required wrenches are available.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Slack {
    /// Where one of them is negative, wrenches are lacking.
    pub sides: Vec<Quadratic>,
    /// Whether wrenches are available where none of them is negative.
    pub complete: bool,
}

/// An engine that checks motions against the conditions of a scene, one by one or all at once.
pub trait Checker: Validity + Send {
    /// The conditions that the engine checks.
    fn conditions(&self) -> &Conditions;

    /// The rule for cables crossing each other.
    fn interference(&self) -> Interference;

    /// An engine of this kind for the geometry of another scene; conditions that both scenes have are not compiled again.
    ///
    /// # Errors
    /// The errors of [`Conditions::new`]; [`Error::interrupted`], [`Error::out_of_time`].
    fn geometry_for(&self, scene: &Scene, watch: &Watch) -> Result<Box<dyn Checker>, Error>;

    /// Whether a motion breaks the condition at this index of the list.
    fn breaks(&self, index: usize, from: &Point, to: &Point) -> bool;

    /// Convex polyhedra that contain only forbidden positions; see [`Conditions::certain_polyhedra`]. They are computed once.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn certain_polyhedra(&self, watch: &Watch) -> Result<Arc<Vec<Polyhedron>>, Error>;

    /// Convex polyhedra that contain the forbidden positions; see [`Conditions::pieces`]. They are computed once.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn pieces(&self, watch: &Watch) -> Result<Arc<Vec<Piece>>, Error>;

    /// A direction [force; moment] in which the cables provide less than required at all positions of a box, if a bound shows
    /// that there is one.
    fn lacking_wrench(&self, _: &Cuboid) -> Option<[f64; 6]> {
        None
    }

    /// What remains unproved of the required wrenches in a box, if nothing but `known` is unproved in a box around it; `None` if they
    /// certainly are lacking at all positions of the box.
    fn wrench_over(&self, _: &Cuboid, _known: Option<&[Unproved]>) -> Option<Vec<Unproved>> {
        Some(Vec::new())
    }

    /// Where in a box the required wrenches are available, if nothing but `known` is unproved in the box.
    fn wrench_slack(&self, _: &Cuboid, _known: Option<&[Unproved]>) -> Slack {
        Slack { sides: Vec::new(), complete: true }
    }

    /// How far a motion keeps all conditions of the list, as a fraction of it, and the index of the condition that it
    /// breaks there; `None` if it keeps them all. If it breaks several at the same place, the first in the list is
    /// returned. Checks beyond the list (wrenches) are not included.
    fn first_contact(&self, from: &Point, to: &Point) -> Option<(f64, usize)> {
        if self.motion_valid(from, to) {
            return None;
        }
        let mut first: Option<(f64, usize)> = None;
        for index in 0..self.conditions().list.len() {
            let breaks_until = |t: f64| self.breaks(index, from, &at(from, to, t));
            // Conditions that hold up to the earliest contact so far need no search.
            if breaks_until(first.map_or(1.0, |(t, _)| t)) {
                let t = first_true(breaks_until);
                if first.is_none_or(|(known, _)| t < known) {
                    first = Some((t, index));
                }
            }
        }
        first
    }

    /// The smallest gap in the world over a motion, m, as in [`Clearance`]; `None` if there are no gaps to measure.
    fn gap(&self, from: &Point, to: &Point) -> Option<f64> {
        clearance::nearest(self.conditions(), from, to).map(|(gap, _)| gap)
    }

    /// Whether no cable meets another cable or the platform at a position.
    fn free_of_interference(&self, position: &Point) -> bool {
        let mut list = self.conditions().list.iter().enumerate();
        !list.any(|(index, c)| c.details().within_robot() && self.breaks(index, position, position))
    }
}
