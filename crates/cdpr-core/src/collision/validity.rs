//! The question every engine answers, and the words of its answers.

use serde::Serialize;

use super::constraint::{Constraint, Constraints};
use super::explain;
use crate::choices;
use crate::error::Error;
use crate::geometry::{HalfSpace, Point};
use crate::watch::Watch;
use crate::words::{length, small_length};
use crate::wrench::Hold;

/// Convex polyhedra, each as a list of half-spaces.
pub type Polyhedra = Vec<Vec<HalfSpace>>;

/// A convex piece of what is forbidden, bracketed.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Index of its constraint in the list.
    pub constraint: usize,
    /// Holds every position of the piece.
    pub outer: Vec<HalfSpace>,
    /// Every position inside of this polyhedron is forbidden; none if no such polyhedron is known.
    pub certain: Option<Vec<HalfSpace>>,
}

/// An engine that answers the constraints of a scene, one by one or all at once.
pub trait Checker: Validity + Send {
    /// The constraints that the engine answers.
    fn constraints(&self) -> &Constraints;

    /// How it keeps cables from each other.
    fn interference(&self) -> Interference;

    /// Whether a motion breaks the constraint at this index of the list.
    fn breaks(&self, index: usize, from: &Point, to: &Point) -> bool;

    /// Convex polyhedra of positions, open and as lists of half-spaces, whose union holds everything that geometry
    /// forbids inside the workspace, but for cables that are too long or too near each other; with a clearance they hold a
    /// little more.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn polyhedra(&self, watch: &Watch) -> Result<Polyhedra, Error> {
        super::cspace::outer_polyhedra(self.constraints(), watch)
    }

    /// Convex polyhedra of positions that are certainly forbidden, as lists of half-spaces.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn certain_polyhedra(&self, watch: &Watch) -> Result<Polyhedra, Error> {
        super::cspace::inner_polyhedra(self.constraints(), watch)
    }

    /// What [`Checker::polyhedra`] gives, with the constraint of each polyhedron and what is certainly forbidden of it.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn pieces(&self, watch: &Watch) -> Result<Vec<Piece>, Error> {
        super::cspace::pieces(self.constraints(), watch)
    }

    /// The least gap in the world over a motion, m, as in [`Clearance`]; none where there is nothing to keep away from.
    fn gap(&self, from: &Point, to: &Point) -> Option<f64> {
        explain::nearest(self.constraints(), from, to).map(|(gap, _)| gap)
    }

    /// Whether no cable meets another or the platform at a position.
    fn free_of_interference(&self, position: &Point) -> bool {
        let internal = |c: &Constraint| matches!(c, Constraint::CableCable(_) | Constraint::CablePlatform { .. });
        let mut list = self.constraints().list.iter().enumerate();
        !list.any(|(index, c)| internal(c) && self.breaks(index, position, position))
    }
}

/// How cables are kept from each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Interference {
    /// They must not meet at any instant of the motion.
    #[default]
    Exact,
    /// The triangles they sweep must be disjoint (the paper, section 3.2): safe, and stricter than needed, since the
    /// cables may pass the crossing at different times.
    Swept,
}

choices!(Interference, "interference", [
    Exact = "exact": "Cables must not meet at any instant",
    Swept = "swept": "The triangles they sweep must be disjoint: the paper's rule, stricter",
]);

/// The engines there are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Engine {
    /// Polyhedra in the space of positions: exact and fast.
    #[default]
    Cspace,
    /// GJK on swept bodies, the paper's way.
    Gjk,
}

choices!(Engine, "engine", [
    Cspace = "cspace": "Polyhedra in the space of positions: exact and fast",
    Gjk = "gjk": "GJK on swept bodies: the paper's way, the reference",
]);

/// Which condition a motion breaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// The platform leaves the workspace box.
    Workspace,
    /// A cable is longer or shorter than it can be.
    CableLength,
    /// A cable enters the platform, or comes too near a part that it is not attached to.
    CablePlatform,
    /// Two cables meet, or come too near each other.
    CableCable,
    /// The platform meets an obstacle, or comes too near it.
    PlatformObstacle,
    /// A cable meets an obstacle, or comes too near it.
    CableObstacle,
    /// The cables cannot balance the required wrenches.
    Wrench,
}

/// One broken condition of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Violation {
    /// Fraction of the motion at which it begins, 0 to 1.
    pub at: f64,
    /// The condition.
    pub kind: Kind,
    /// Who is involved, by the names of the scene.
    pub culprits: Vec<String>,
    /// Worst gap over the motion, m: between surfaces, minus a penetration depth where bodies overlap; for the workspace
    /// and the length of a cable the room left, negative outside. None where there is no such distance (wrench).
    pub gap: Option<f64>,
    /// What the gap would have to be, m.
    pub required: Option<f64>,
    /// Gap less what is required, m: never positive.
    pub margin: Option<f64>,
    /// Whether nothing is known to be broken, but that it holds could not be proved either: the slack that is left is next
    /// to nothing. Only where the kind is wrench.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub unproved: bool,
    /// What the wrenches lack, and which cables limit them; only where the kind is wrench.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub wrench: Option<WrenchLimit>,
}

/// The facet that limits the wrenches of a robot at a position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WrenchLimit {
    /// Margin less what is demanded; negative where something is lacking. None where a cable has no direction.
    pub wrench_margin: Option<f64>,
    /// Where it is measured, if at a point of the grid rule instead of on the motion, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<[f64; 3]>,
    /// What the cables hold there whatever their limits: rank and what follows from it. None where a cable has no
    /// direction.
    #[serde(flatten)]
    pub hold: Option<Hold>,
    /// What it is measured by: capacity, force or moment.
    pub measure: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Cables at their greatest tension there.
    pub at_greatest: Vec<String>,
    /// Cables at their least tension there.
    pub at_least: Vec<String>,
}

impl WrenchLimit {
    /// The margin as a number to order by: where there is none, it is least.
    pub fn order(&self) -> f64 {
        self.wrench_margin.unwrap_or(f64::NEG_INFINITY)
    }

    /// Whether no tensions resist some motion of the platform.
    pub fn leaves_motions_free(&self) -> bool {
        self.hold.as_ref().is_some_and(|hold| !hold.is_full())
    }

    /// In plain words: "by 12.3 N, with cable 2 at greatest tension and cable 4 at least tension".
    fn sentence(&self) -> String {
        let amount = match self.wrench_margin {
            None => return ": a cable has no direction".to_string(),
            Some(_) if self.leaves_motions_free() => {
                return self.hold.as_ref().map_or(String::new(), |hold| format!(": {}", hold.sentence()));
            }
            Some(margin) if margin < 0.0 => format!(" by {:.3} {}", -margin, self.unit),
            Some(margin) => format!(": the least {} margin found is {margin:.3e} {}", self.measure, self.unit),
        };
        let side = |cables: &[String], which: &str| {
            (!cables.is_empty()).then(|| format!("{} at {which} tension", cables.join(", ")))
        };
        let sides: Vec<String> =
            [side(&self.at_greatest, "greatest"), side(&self.at_least, "least")].into_iter().flatten().collect();
        let place = self.corner.map_or(String::new(), |[x, y, z]| {
            format!(" at the grid point ({x:.3}, {y:.3}, {z:.3}) that decides there")
        });
        if sides.is_empty() { amount + &place } else { format!("{amount}{place}, with {}", sides.join(" and ")) }
    }
}

impl Violation {
    /// The violation in plain words: "cable 3 meets pillar, 12.0 mm deep".
    pub fn sentence(&self) -> String {
        let limit = self.wrench.as_ref().map_or(String::new(), WrenchLimit::sentence);
        let what = if self.unproved {
            "it could not be proved that the cables balance the required wrenches".to_string()
        } else {
            self.gap_sentence()
        };
        what + &limit
    }

    /// A condition on distances in plain words.
    fn gap_sentence(&self) -> String {
        let name = |k: usize| self.culprits.get(k).map_or("?", String::as_str);
        let required = self.required.filter(|required| *required > 0.0);
        let required = required.map_or(String::new(), |required| format!(", {} required", length(required)));
        let meets = |first: &str, second: &str| match self.gap {
            Some(gap) if gap < 0.0 => format!("{first} meets {second}, {} deep", small_length(-gap)),
            Some(gap) if gap > 0.0 => {
                format!("{first} comes too near {second}, with only {} between them{required}", small_length(gap))
            }
            _ => format!("{first} meets {second}"),
        };
        let missing = || self.gap.map_or(String::new(), |room| format!(" by {}", small_length(-room)));
        match self.kind {
            Kind::Workspace => format!("the platform leaves the workspace{}", missing()),
            Kind::CableLength => format!("{} breaks its length limits{}", name(0), missing()),
            Kind::CablePlatform => meets(name(0), "the platform"),
            Kind::CableCable | Kind::CableObstacle => meets(name(0), name(1)),
            Kind::PlatformObstacle => meets("the platform", name(1)),
            Kind::Wrench => "the cables cannot balance the required wrenches".to_string(),
        }
    }
}

/// The nearest approach of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Clearance {
    /// Gap in the world, m.
    pub value: f64,
    /// Fraction of the motion at which it is first reached, 0 to 1.
    pub at: f64,
    /// Between whom.
    pub culprits: Vec<String>,
    /// The clearance that the pair is held to, m; 0 where it must only not touch.
    pub required: f64,
}

/// Whether a robot may be somewhere, or go somewhere in a straight line.
///
/// The state is a position of the platform's origin (world, m) at the fixed orientation of the engine; spaces with
/// rotation will bring a state type of their own. Implementations are immutable and shared between threads.
pub trait Validity<State = Point>: Sync {
    /// Whether the robot may be in a state.
    fn state_valid(&self, state: &State) -> bool;

    /// Whether it may go straight from one state to another; both ends are part of the motion.
    fn motion_valid(&self, from: &State, to: &State) -> bool;

    /// All conditions that a motion breaks, those that break first first; empty if it is valid.
    fn violations(&self, from: &State, to: &State) -> Vec<Violation>;

    /// The nearest approach of a motion to anything it must keep away from; none where there is no such thing.
    fn clearance(&self, from: &State, to: &State) -> Option<Clearance>;

    /// Whether one question may take many milliseconds. Planners then look at the clock before each, not now and then.
    fn may_be_slow(&self) -> bool {
        false
    }

    /// The first condition that a motion breaks.
    fn explain(&self, from: &State, to: &State) -> Option<Violation> {
        self.violations(from, to).into_iter().next()
    }
}
