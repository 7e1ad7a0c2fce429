//! The physical conditions that a motion has to keep (sections 3.1 and 3.2 of the paper), one file for each.
//!
//! A file holds everything that is known of its condition: how it follows from a scene, whom it is about, the distance that it
//! demands, that distance at a position and over a motion, whether a motion breaks it, which positions it forbids, and how a
//! violation reads. All of that is the trait [`PhysicalCondition`]; engines, meshes, pictures, string pulling and bounds ask
//! it and derive nothing themselves. The condition on wrenches stands in [`crate::wrench`].

pub mod bodies;
pub mod cable_and_body;
pub mod cable_cable;
pub mod cable_length;
pub mod cable_obstacle;
pub mod cable_platform;
pub mod exempt;
pub mod fattened;
pub mod physical;
pub mod platform_obstacle;
pub mod region;
pub mod workspace;

use rayon::prelude::*;

pub use bodies::{Bodies, CableAt, ObstacleBody};
pub use cable_and_body::Demand;
pub use cable_cable::CableCable;
pub use cable_length::CableLength;
pub use cable_obstacle::CableObstacle;
pub use cable_platform::CablePlatform;
pub use exempt::{Exemption, Reason};
pub use fattened::Fattened;
pub use physical::{Broken, Interference, Kind, PhysicalCondition};
pub use platform_obstacle::PlatformObstacle;
pub use region::{Forbidden, Inner, Piece, Polyhedron, Region, Scale};
pub use workspace::Workspace;

use crate::error::Error;
use crate::geometry::Point;
use crate::model::{Member, Scene};
use crate::watch::Watch;
use exempt::Remarks;

/// Defines [`Condition`] and what has to be done once for every condition. Each variant has the name of its type and of its
/// [`Kind`].
macro_rules! conditions {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// One condition on the position of the platform.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Condition {
            $($(#[$doc])* $name($name),)*
        }

        impl Condition {
            /// Everything that is known of it.
            #[inline]
            pub fn details(&self) -> &dyn PhysicalCondition {
                match self {
                    $(Condition::$name(condition) => condition,)*
                }
            }

            fn details_mut(&mut self) -> &mut dyn PhysicalCondition {
                match self {
                    $(Condition::$name(condition) => condition,)*
                }
            }

            /// As [`PhysicalCondition::breaks`], for engines: without a call through a table of functions.
            #[inline]
            pub fn breaks(&self, bodies: &Bodies, interference: Interference, from: &Point, to: &Point) -> bool {
                match self {
                    $(Condition::$name(condition) => condition.breaks(bodies, interference, from, to),)*
                }
            }

            /// As [`PhysicalCondition::certainly_keeps`], likewise.
            #[inline]
            pub fn certainly_keeps(&self, from: &Point, to: &Point) -> bool {
                match self {
                    $(Condition::$name(condition) => condition.certainly_keeps(from, to),)*
                }
            }

            /// All conditions of a scene, in the order of the variants.
            fn all(scene: &Scene, bodies: &Bodies, remarks: &mut Remarks, watch: &Watch) -> Result<Vec<Self>, Error> {
                let mut list = Vec::new();
                $(
                    let found = $name::all(scene, bodies, list.len(), remarks, watch)?;
                    list.extend(found.into_iter().map(Condition::$name));
                )*
                Ok(list)
            }
        }

        impl Kind {
            /// A violation of a condition of this kind in plain words.
            pub fn sentence(self, found: &Broken) -> String {
                match self {
                    $(Kind::$name => $name::sentence(found),)*
                    Kind::Wrench => "the cables cannot balance the required wrenches".to_string(),
                }
            }
        }
    };
}

// In the order in which they are checked: cheap ones first.
conditions! {
    /// The platform stays inside the workspace; the first condition of every list.
    Workspace,
    /// A cable is neither shorter nor longer than it can be.
    CableLength,
    /// A cable keeps out of a body of the platform.
    CablePlatform,
    /// Two cables keep from each other.
    CableCable,
    /// A part of the platform keeps away from an obstacle body.
    PlatformObstacle,
    /// A cable keeps away from an obstacle body.
    CableObstacle,
}

impl Condition {
    /// The same condition where obstacle bodies have other indices; none if its obstacle has none.
    pub fn renumbered(&self, obstacles: &[Option<usize>]) -> Option<Self> {
        let mut condition = self.clone();
        if let Some(body) = condition.details_mut().obstacle_mut() {
            *body = obstacles[*body]?;
        }
        Some(condition)
    }
}

/// All conditions of a scene at one orientation.
///
/// Everything that does not depend on the position is settled here, once: rotated platform and attachments, which pairs touch
/// by construction, which can never keep the demanded distance. Engines only evaluate the list.
#[derive(Debug, Clone, PartialEq)]
pub struct Conditions {
    /// What the conditions are about.
    pub bodies: Bodies,
    /// The conditions, cheap ones first.
    pub list: Vec<Condition>,
    /// Pairs that are not held to the clearance of their kind.
    pub exempt: Vec<Exemption>,
    /// What else the user should know about how the scene is taken.
    pub notes: Vec<String>,
}

/// The note on a scene that lists several orientations and selects none.
fn open_orientation(scene: &Scene) -> Option<String> {
    let name = scene.orientation_name().filter(|_| scene.orientation_is_open())?;
    Some(format!(
        "the scene lists several orientations but selects none; using \"{name}\", the first (planning tries all of them)"
    ))
}

/// Conditions from which on all cores work on them.
const IN_PARALLEL: usize = 256;

impl Conditions {
    /// The conditions of a scene at its orientation.
    ///
    /// # Errors
    /// None today.
    pub fn new(scene: &Scene) -> Result<Self, Error> {
        Self::within(scene, &Watch::NONE)
    }

    /// As [`Conditions::new`], within a watch.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn within(scene: &Scene, watch: &Watch) -> Result<Self, Error> {
        let bodies = Bodies::of(scene);
        let notes = scene.notes().iter().cloned().chain(open_orientation(scene)).collect();
        let mut remarks = Remarks { exempt: Vec::new(), notes };
        let list = Condition::all(scene, &bodies, &mut remarks, watch)?;
        remarks.exempt_by_name(scene, list.len(), |index| {
            let condition = list[index].details();
            condition.is_about_gap(&bodies).then(|| condition.members(&bodies).try_into().ok())?
        });
        let Remarks { exempt, notes } = remarks;
        Ok(Conditions { bodies, list, exempt, notes })
    }

    /// The kind of a condition.
    pub fn kind(&self, condition: &Condition) -> Kind {
        condition.details().kind()
    }

    /// Whom a condition is about: two members, or one that it limits by itself.
    pub fn members(&self, condition: &Condition) -> Vec<Member> {
        condition.details().members(&self.bodies)
    }

    /// The names of those whom a condition is about.
    pub fn culprits(&self, condition: &Condition) -> Vec<String> {
        self.members(condition).iter().map(|member| self.bodies.name(*member).to_string()).collect()
    }

    /// The gap of surfaces that a condition demands, m: 0 or less where they must only not touch; none where it is not about
    /// a gap, but about ends that touch by construction, seams, or room.
    pub fn required(&self, condition: &Condition) -> Option<f64> {
        let condition = condition.details();
        condition.is_about_gap(&self.bodies).then(|| condition.required(&self.bodies))
    }

    /// What the user should know: the notes, and which pairs cannot keep what the scene demands.
    pub fn remarks(&self) -> Vec<String> {
        let unattainable = self.exempt.iter().filter(|e| e.reason == Reason::Unattainable);
        self.notes.iter().cloned().chain(unattainable.map(Exemption::sentence)).collect()
    }

    /// The box of positions where the platform is inside the workspace; it may be empty (min > max).
    pub fn position_box(&self) -> (Point, Point) {
        match &self.list[0] {
            Condition::Workspace(workspace) => (workspace.min, workspace.max),
            _ => unreachable!("the workspace is the first condition"),
        }
    }

    /// What rounding is relative to.
    pub fn scale(&self) -> Scale {
        Scale::of(&self.bodies, self.position_box())
    }

    /// Room for the obstacles that conditions fatten; they share them.
    pub fn fattened(&self) -> Fattened {
        Fattened::of(&self.bodies, self.list.iter().filter_map(|condition| condition.details().fattens()))
    }

    /// The positions that the condition at an index of the list forbids within the box of positions, as bracketed convex
    /// pieces; empty for the workspace itself.
    pub fn regions(&self, index: usize, scale: &Scale, fat: &Fattened) -> Vec<Region> {
        let (min, max) = self.position_box();
        let regions = self.list[index].details().regions(&self.bodies, scale, fat);
        regions.into_iter().map(|region| region.sorted(&min, &max)).collect()
    }

    /// Convex polyhedra of positions whose union holds everything that the conditions forbid inside the workspace, except
    /// cables that are too long or too near each other; with a clearance they hold a little more.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn polyhedra(&self, watch: &Watch) -> Result<Vec<Polyhedron>, Error> {
        let (scale, fat) = (self.scale(), self.fattened());
        self.for_each(watch, |index| self.polyhedra_of(index, self.regions(index, &scale, &fat).iter(), &fat))
    }

    /// Convex polyhedra of positions that are certainly forbidden.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn certain_polyhedra(&self, watch: &Watch) -> Result<Vec<Polyhedron>, Error> {
        let (scale, fat) = (self.scale(), self.fattened());
        self.for_each(watch, |index| self.certain_polyhedra_of(index, self.regions(index, &scale, &fat).iter()))
    }

    /// What [`Conditions::polyhedra`] gives, with what is certainly forbidden of each.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn pieces(&self, watch: &Watch) -> Result<Vec<Piece>, Error> {
        let (scale, fat) = (self.scale(), self.fattened());
        self.for_each(watch, |index| self.pieces_of(index, self.regions(index, &scale, &fat).iter(), &fat))
    }

    /// The polyhedra of [`Conditions::polyhedra`] that one condition contributes, given its regions.
    pub fn polyhedra_of<'r>(
        &self,
        condition: usize,
        regions: impl Iterator<Item = &'r Region>,
        fat: &Fattened,
    ) -> Vec<Polyhedron> {
        let pieces = self.pieces_of(condition, regions, fat).into_iter();
        pieces.map(|piece| Polyhedron { condition, half_spaces: piece.outer }).collect()
    }

    /// The share of one condition, of which these are the regions, in [`Conditions::certain_polyhedra`].
    pub fn certain_polyhedra_of<'r>(
        &self,
        condition: usize,
        regions: impl Iterator<Item = &'r Region>,
    ) -> Vec<Polyhedron> {
        let certain = regions.filter_map(Region::certain);
        certain.map(|half_spaces| Polyhedron { condition, half_spaces }).collect()
    }

    /// The pieces of [`Conditions::pieces`] that one condition contributes, given its regions.
    pub fn pieces_of<'r>(
        &self,
        condition: usize,
        regions: impl Iterator<Item = &'r Region>,
        fat: &Fattened,
    ) -> Vec<Piece> {
        let details = self.list[condition].details();
        let mut regions = regions.peekable();
        let Some(first) = regions.peek().filter(|_| !details.regions_are_loose()) else { return Vec::new() };
        // A condition with a rounded polyhedron has one region, whose own outer polyhedron may be unknown.
        if let Some(outer) = details.rounded(&self.bodies, fat) {
            return vec![Piece { condition, outer, certain: first.certain() }];
        }
        let piece =
            |region: &Region| Some(Piece { condition, outer: region.outer.clone()?, certain: region.certain() });
        regions.filter_map(piece).collect()
    }

    /// What there is for all conditions, by their indices, in their order.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn for_each<T: Send>(&self, watch: &Watch, of: impl Fn(usize) -> Vec<T> + Sync) -> Result<Vec<T>, Error> {
        let found = self.map(watch, of)?;
        Ok(found.into_iter().flatten().collect())
    }

    /// One result for each condition, by its index, on all cores if there are many.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn map<T: Send>(&self, watch: &Watch, of: impl Fn(usize) -> T + Sync) -> Result<Vec<T>, Error> {
        let one = |index: usize| watch.check().map(|()| of(index));
        let indices = 0..self.list.len();
        if indices.len() >= IN_PARALLEL {
            indices.into_par_iter().map(one).collect()
        } else {
            indices.map(one).collect()
        }
    }
}
