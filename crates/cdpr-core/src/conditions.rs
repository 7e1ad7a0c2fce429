//! The physical conditions on a motion (sections 3.1 and 3.2 of the paper), one file per condition.
//!
//! Each file implements the trait [`PhysicalCondition`]: how the condition follows from a scene, its members, the
//! required distance, the actual distance at a position and over a motion, whether a motion breaks it, the positions it
//! forbids, and the message for a violation. Engines, meshes, figures, string pulling and bounds use only this trait.
//! The condition on wrenches is in [`crate::wrench`].

pub mod bodies;
pub mod cable_and_body;
pub mod cable_cable;
pub mod cable_length;
pub mod cable_obstacle;
pub mod cable_platform;
pub mod exempt;
pub mod fattened;
mod hanging_pair;
mod instants;
pub mod physical;
pub mod platform_obstacle;
pub mod region;
pub mod workspace;

pub use bodies::{Bodies, CableAt, ObstacleBody, Shapes};
pub use cable_and_body::CableDemand;
pub use cable_cable::CableCable;
pub use cable_length::CableLength;
pub use cable_obstacle::CableObstacle;
pub use cable_platform::CablePlatform;
pub use exempt::{Exemption, Reason};
pub use fattened::Fattened;
pub use physical::{Broken, Interference, Kind, PhysicalCondition};
pub use platform_obstacle::PlatformObstacle;
pub use region::{ForbiddenPolyhedron, Inner, Piece, Polyhedron, Region, Scale};
pub use workspace::Workspace;

use std::sync::{Arc, OnceLock};

use crate::batch::each;
use crate::error::Error;
use crate::geometry::Point;
use crate::model::{Member, Scene, doubts};
use crate::tolerances::TOUCH_DEPTH;
use crate::watch::Watch;
use exempt::Remarks;

/// Defines [`Condition`] and all code that is repeated for every condition. Each variant has the same name as its type
/// and its [`Kind`].
macro_rules! conditions {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// One condition on the position of the platform.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Condition {
            $($(#[$doc])* $name($name),)*
        }

        impl Condition {
            /// The condition as a trait object.
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

            /// Whether a motion breaks the condition: [`PhysicalCondition::breaks`], statically dispatched for engines.
            #[inline]
            pub fn breaks(&self, bodies: &Bodies, interference: Interference, from: &Point, to: &Point) -> bool {
                match self {
                    $(Condition::$name(condition) => condition.breaks(bodies, interference, from, to),)*
                }
            }

            /// A quick sufficient test that a motion keeps the condition: [`PhysicalCondition::certainly_keeps`],
            /// statically dispatched.
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
            /// Describes a violation of a condition of this kind.
            pub fn sentence(self, found: &Broken) -> String {
                match self {
                    $(Kind::$name => $name::sentence(found),)*
                    Kind::Wrench => "the cables cannot balance the required wrenches".to_string(),
                    Kind::Tilt => "the platform tilts further than the scene allows".to_string(),
                    Kind::TurningAxis => {
                        "the platform is turned about another axis than the scene allows".to_string()
                    }
                }
            }
        }
    };
}

// In the order of checking: cheap conditions first.
conditions! {
    /// The platform stays inside the workspace; the first condition of every list.
    Workspace,
    /// The length of a cable stays within its limits.
    CableLength,
    /// A cable stays clear of a platform body.
    CablePlatform,
    /// Two cables stay clear of each other.
    CableCable,
    /// A platform part stays clear of an obstacle body.
    PlatformObstacle,
    /// A cable stays clear of an obstacle body.
    CableObstacle,
}

impl Condition {
    /// This condition with obstacle bodies renumbered; `None` if its obstacle body has no new index.
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
/// Everything that does not depend on the position is computed here, once: the rotated platform and attachments, which
/// pairs touch by construction, and which pairs can never keep the required distance. Engines only evaluate the list.
#[derive(Debug, Clone, PartialEq)]
pub struct Conditions {
    /// The bodies that the conditions refer to.
    pub bodies: Bodies,
    /// The conditions, cheap ones first.
    pub list: Vec<Condition>,
    /// Pairs that are exempt from the clearance of their kind.
    pub exempt: Vec<Exemption>,
    /// Further notes for the user on how the scene is interpreted.
    pub notes: Vec<String>,
}

/// The note on a scene that lists several orientations and selects none.
fn open_orientation(scene: &Scene) -> Option<String> {
    let name = scene.orientation_name().filter(|_| scene.orientation_is_open())?;
    Some(format!(
        "the scene lists several orientations but selects none; using \"{name}\", the first (planning tries all of them)"
    ))
}

/// Number of conditions from which they are processed in parallel.
const IN_PARALLEL: usize = 256;

/// What an engine forbids, as convex polyhedra: computed when first asked for, and kept, since planner, string puller, proofs, bounds
/// and trajectories all ask for it.
#[derive(Debug, Clone, Default)]
pub struct KeptPolyhedra {
    pieces: OnceLock<Arc<Vec<Piece>>>,
    certain: OnceLock<Arc<Vec<Polyhedron>>>,
}

impl KeptPolyhedra {
    /// The pieces, computed unless they are known.
    ///
    /// # Errors
    /// Passes on the errors of `compute`; the next call then tries again.
    pub fn pieces(&self, compute: impl FnOnce() -> Result<Vec<Piece>, Error>) -> Result<Arc<Vec<Piece>>, Error> {
        kept(&self.pieces, compute)
    }

    /// The certainly forbidden polyhedra, computed unless they are known.
    ///
    /// # Errors
    /// Passes on the errors of `compute`; the next call then tries again.
    pub fn certain(
        &self,
        compute: impl FnOnce() -> Result<Vec<Polyhedron>, Error>,
    ) -> Result<Arc<Vec<Polyhedron>>, Error> {
        kept(&self.certain, compute)
    }
}

fn kept<T>(
    known: &OnceLock<Arc<Vec<T>>>,
    compute: impl FnOnce() -> Result<Vec<T>, Error>,
) -> Result<Arc<Vec<T>>, Error> {
    match known.get() {
        Some(known) => Ok(known.clone()),
        None => {
            let computed = compute()?.into();
            Ok(known.get_or_init(|| computed).clone())
        }
    }
}

impl Conditions {
    /// The conditions of a scene at its orientation.
    ///
    /// # Errors
    /// Currently never fails.
    pub fn new(scene: &Scene) -> Result<Self, Error> {
        Self::within(scene, &Watch::NONE)
    }

    /// The conditions of a scene at its orientation, computed within a watch.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn within(scene: &Scene, watch: &Watch) -> Result<Self, Error> {
        let bodies = Bodies::of(scene);
        let notes = scene.notes().iter().cloned().chain(open_orientation(scene)).chain(doubts(scene)).collect();
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

    /// The members of a condition: a pair, or a single member.
    pub fn members(&self, condition: &Condition) -> Vec<Member> {
        condition.details().members(&self.bodies)
    }

    /// The names of a condition's members.
    pub fn culprits(&self, condition: &Condition) -> Vec<String> {
        self.members(condition).iter().map(|member| self.bodies.name(*member).to_string()).collect()
    }

    /// The gap between surfaces that a condition requires, m; 0 or less if they only have to stay apart. `None` if the
    /// condition does not limit a gap: ends that touch by construction, seams, the workspace, cable lengths.
    pub fn required(&self, condition: &Condition) -> Option<f64> {
        let condition = condition.details();
        condition.is_about_gap(&self.bodies).then(|| condition.required(&self.bodies))
    }

    /// Messages for the user: the notes, and the pairs that cannot keep their required clearance.
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

    /// The scale of the scene, to which rounding errors are proportional.
    pub fn scale(&self) -> Scale {
        Scale::of(&self.bodies, self.position_box())
    }

    /// A cache for the fattened obstacles, shared by all conditions.
    pub fn fattened(&self) -> Fattened {
        Fattened::of(&self.bodies, self.list.iter().filter_map(|condition| condition.details().fattens()))
    }

    /// The positions within the box of positions that the condition at this index forbids, as bracketed convex pieces;
    /// empty for the workspace condition.
    pub fn regions(&self, index: usize, scale: &Scale, fat: &Fattened) -> Vec<Region> {
        let (min, max) = self.position_box();
        let regions = self.list[index].details().regions(&self.bodies, scale, fat);
        regions.into_iter().map(|region| region.sorted(&min, &max)).collect()
    }

    /// Convex polyhedra that contain only forbidden positions.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn certain_polyhedra(&self, watch: &Watch) -> Result<Vec<Polyhedron>, Error> {
        let (scale, fat) = (self.scale(), self.fattened());
        let inside = self.fattened().from_inside();
        self.for_each(watch, |index| {
            self.certain_polyhedra_of(index, self.regions(index, &scale, &fat).iter(), (&scale, &inside))
        })
    }

    /// Convex polyhedra of positions whose union contains everything that the conditions forbid inside the workspace, except
    /// cables that are too long or too close to each other; each with its certainly forbidden part. With a clearance, they contain
    /// slightly more.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn pieces(&self, watch: &Watch) -> Result<Vec<Piece>, Error> {
        let (scale, fat) = (self.scale(), self.fattened());
        self.for_each(watch, |index| self.pieces_of(index, self.regions(index, &scale, &fat).iter(), &fat))
    }

    /// The part of [`Conditions::certain_polyhedra`] due to one condition, given its regions.
    pub fn certain_polyhedra_of<'r>(
        &self,
        condition: usize,
        regions: impl Iterator<Item = &'r Region>,
        (scale, inside): (&Scale, &Fattened),
    ) -> Vec<Polyhedron> {
        let mut of_contact = regions.filter_map(Region::certain);
        let details = self.list[condition].details();
        let larger = details.forbidden_inside(&self.bodies, inside).and_then(|found| found.certain(TOUCH_DEPTH, scale));
        match larger {
            Some(half_spaces) => vec![Polyhedron { condition, half_spaces, of_contact: of_contact.next() }],
            None => of_contact.map(|half_spaces| Polyhedron { condition, half_spaces, of_contact: None }).collect(),
        }
    }

    /// The part of [`Conditions::pieces`] due to one condition, given its regions.
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

    /// Applies a function to the index of each condition and concatenates the results in order.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn for_each<T: Send>(&self, watch: &Watch, of: impl Fn(usize) -> Vec<T> + Sync) -> Result<Vec<T>, Error> {
        let found = self.map(watch, of)?;
        Ok(found.into_iter().flatten().collect())
    }

    /// Applies a function to the index of each condition, in parallel if there are many.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn map<T: Send>(&self, watch: &Watch, of: impl Fn(usize) -> T + Sync) -> Result<Vec<T>, Error> {
        each(self.list.len(), IN_PARALLEL, &|(), index| watch.check().map(|()| of(index)))
    }
}
