//! What every physical condition can be asked. One file implements all of it for one condition.

use serde::Serialize;

use super::bodies::Bodies;
use super::exempt::Remarks;
use super::fattened::Fattened;
use super::region::{Forbidden, Region, Scale};
use crate::choices;
use crate::error::Error;
use crate::geometry::{Aabb, HalfSpace, Point, TriangleMesh, Vector, convex_mesh};
use crate::model::{Member, Scene};
use crate::watch::Watch;
use crate::words::{length, small_length};

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
    Swept = "swept": "The triangles that they sweep must be disjoint: the paper's rule, which is stricter",
]);

/// A physical condition on where the platform may be and how it may move, at fixed orientation.
///
/// A motion is a straight line of positions of the platform's origin; a position is a motion without length. Distances are
/// between surfaces, in the world, m, and minus a depth where bodies overlap. For the workspace and for lengths they are the
/// room left, negative outside.
///
/// To add a condition, implement this in a file of its own and list it in [`super::Condition`].
pub trait PhysicalCondition {
    /// All conditions of this kind that a scene poses. They stand in the list of conditions from index `first` on.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn all(
        scene: &Scene,
        bodies: &Bodies,
        first: usize,
        remarks: &mut Remarks,
        watch: &Watch,
    ) -> Result<Vec<Self>, Error>
    where
        Self: Sized;

    /// A violation in plain words: "cable 3 meets pillar, 12.0 mm deep".
    fn sentence(found: &Broken) -> String
    where
        Self: Sized;

    /// Its kind.
    fn kind(&self) -> Kind;

    /// Whom it is about: two members, or one that it limits by itself.
    fn members(&self, bodies: &Bodies) -> Vec<Member>;

    /// Whether it is about two parts of the robot.
    fn within_robot(&self) -> bool {
        false
    }

    /// The obstacle body that it is about, as an index into [`Bodies::obstacles`].
    fn obstacle_mut(&mut self) -> Option<&mut usize> {
        None
    }

    /// Whether it is about a body that closes a seam between parts.
    fn closes_seam(&self, _: &Bodies) -> bool {
        false
    }

    /// Whether it closes a seam and `other` is about a part beside that seam. If both are broken, the other one gives the
    /// right culprit and depth.
    fn is_seam_beside(&self, _other: &dyn PhysicalCondition, _: &Bodies) -> bool {
        false
    }

    /// The least distance that keeps it, m.
    fn required(&self, bodies: &Bodies) -> f64;

    /// Whether it is about the gap between two surfaces; if not, it is about ends that touch by construction, seams, or room.
    fn is_about_gap(&self, _: &Bodies) -> bool {
        false
    }

    /// The least distance during a motion, m.
    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64;

    /// A lower bound of [`PhysicalCondition::distance`] from bounding boxes, m; minus infinity where these meet.
    fn boxes_apart(&self, _: &Bodies, _from: &Point, _to: &Point) -> f64 {
        f64::NEG_INFINITY
    }

    /// The distance that tells how badly a motion breaks it, m, where that is not the least over all positions between first
    /// and last contact.
    fn worst_distance(&self, _: &Bodies, _: Interference, _from: &Point, _to: &Point) -> Option<f64> {
        None
    }

    /// How far a position is from breaking it, m: every motion from there that is shorter keeps it, because distances change
    /// by at most the way gone. Minus infinity where no distance says that.
    fn slack(&self, bodies: &Bodies, position: &Point) -> f64 {
        self.distance(bodies, position, position) - self.required(bodies)
    }

    /// Whether a motion breaks it, by GJK or in closed form.
    fn breaks(&self, bodies: &Bodies, interference: Interference, from: &Point, to: &Point) -> bool;

    /// Whether motions can break it that stay outside of all its regions.
    fn exceeds_regions(&self, _: Interference) -> bool {
        false
    }

    /// A quick test that, if true, proves that a motion keeps it.
    fn certainly_keeps(&self, _from: &Point, _to: &Point) -> bool {
        false
    }

    /// The positions that break it, for `gap` 0 and bodies; for a larger `gap`, m, a superset of the positions where those
    /// whom it keeps apart are nearer than that.
    ///
    /// None where that has no volume, no planes that rounding leaves alone (a flat part seen edge-on), or is no polyhedron.
    fn forbidden(&self, _: &Bodies, _gap: f64, _: &Fattened) -> Option<Forbidden> {
        None
    }

    /// The positions that break its demanded distance, as half-spaces that hold them and not much more: where
    /// [`PhysicalCondition::forbidden`] sums with a cube, this rounds edges and corners off by bevels. None where there is no
    /// such polyhedron.
    fn rounded(&self, _: &Bodies, _: &Fattened) -> Option<Vec<HalfSpace>> {
        None
    }

    /// The obstacle body, and the distance from it, m, that [`PhysicalCondition::forbidden`] asks [`Fattened`] for.
    fn fattens(&self) -> Option<(usize, f64)> {
        None
    }

    /// Convex pieces of the positions that break it, bracketed; empty if it forbids nothing or only what is outside of the
    /// box of positions.
    fn regions(&self, bodies: &Bodies, scale: &Scale, fat: &Fattened) -> Vec<Region>;

    /// Whether the outer polyhedra of its regions hold much that it does not forbid.
    fn regions_are_loose(&self) -> bool {
        false
    }

    /// From the platform's origin to the point for which a region of it can be drawn in the world: the cable's end on the
    /// platform.
    fn attachment(&self, _: &Bodies) -> Vector {
        Vector::zeros()
    }

    /// Closed surfaces around what it forbids without clearance, moved by `by` and cut at a box; none if the bodies are too
    /// close to degenerate for that.
    fn surfaces(&self, bodies: &Bodies, by: &Vector, within: &Aabb) -> Option<Vec<TriangleMesh>> {
        let found = self.forbidden(bodies, 0.0, &Fattened::default());
        Some(found.and_then(|found| surface(&found, by, within)).into_iter().collect())
    }
}

/// The closed surface of a forbidden polyhedron, moved by `by` and cut at a box.
pub fn surface(found: &Forbidden, by: &Vector, within: &Aabb) -> Option<TriangleMesh> {
    let moved: Vec<HalfSpace> = found.half_spaces.iter().map(|h| h.moved(by)).collect();
    convex_mesh(&moved, within)
}

/// What a sentence about a violation is made from.
#[derive(Debug, Clone, Copy)]
pub struct Broken<'a> {
    /// Who is involved, by the names of the scene.
    pub culprits: &'a [String],
    /// Worst gap over the motion, m.
    pub gap: Option<f64>,
    /// What the gap would have to be, m.
    pub required: Option<f64>,
}

impl Broken<'_> {
    /// The name of a culprit.
    pub fn name(&self, k: usize) -> &str {
        self.culprits.get(k).map_or("?", String::as_str)
    }

    /// That two bodies meet, or come too near each other.
    pub fn meets(&self, first: &str, second: &str) -> String {
        let required = self.required.filter(|required| *required > 0.0);
        let required = required.map_or(String::new(), |required| format!(", {} required", length(required)));
        match self.gap {
            Some(gap) if gap < 0.0 => format!("{first} meets {second}, {} deep", small_length(-gap)),
            Some(gap) if gap > 0.0 => {
                format!("{first} comes too near {second}, with only {} between them{required}", small_length(gap))
            }
            _ => format!("{first} meets {second}"),
        }
    }

    /// By how much room is lacking: " by 12.0 mm".
    pub fn lacking(&self) -> String {
        self.gap.map_or(String::new(), |room| format!(" by {}", small_length(-room)))
    }
}
