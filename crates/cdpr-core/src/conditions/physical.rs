//! The interface of a physical condition. One file implements all of it for one condition.

use serde::Serialize;

use super::bodies::{Bodies, Shapes};
use super::exempt::Remarks;
use super::fattened::Fattened;
use super::region::{ForbiddenPolyhedron, Region, Scale};
use crate::choices;
use crate::error::Error;
use crate::geometry::{Aabb, Cuboid, HalfSpace, Placed, Point, TriangleMesh, TurningPiece, Vector, convex_mesh};
use crate::model::{Member, Scene};
use crate::watch::Watch;
use crate::words::{length, small_length};

/// The kind of condition that a motion breaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// The platform leaves the workspace box.
    Workspace,
    /// The length of a cable is outside its limits.
    CableLength,
    /// A cable enters the platform, or comes too close to a part that it is not attached to.
    CablePlatform,
    /// Two cables meet, or come too close to each other.
    CableCable,
    /// The platform meets an obstacle, or comes too close to it.
    PlatformObstacle,
    /// A cable meets an obstacle, or comes too close to it.
    CableObstacle,
    /// The cables cannot balance the required wrenches.
    Wrench,
    /// The platform tilts too far.
    Tilt,
    /// The platform turns about an axis other than the only allowed one.
    TurningAxis,
}

/// The rule for cables crossing each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Interference {
    /// Cables must not meet at any instant of the motion.
    #[default]
    Exact,
    /// The triangles that two cables sweep must be disjoint (the paper, section 3.2): safe, but stricter than needed,
    /// since the cables may pass the crossing at different times.
    Swept,
}

choices!(Interference, "interference", [
    Exact = "exact": "Cables must not meet at any instant",
    Swept = "swept": "The triangles that they sweep must be disjoint: the paper's rule, which is stricter",
]);

/// A physical condition on where the platform may be and how it may move, at fixed orientation.
///
/// A motion is a straight line of positions of the platform's origin; a position is a motion of zero length. Distances are
/// between surfaces, in the world, m; a negative value is the depth of an overlap. For the workspace and for cable lengths, the
/// distance is measured from the limits and is negative outside them.
///
/// To add a condition, implement this trait in a new file, add a variant of the same name to [`Kind`], and list it in
/// [`super::Condition`]. Methods without a default are required; ARCHITECTURE.md says what the compiler does not check.
pub trait PhysicalCondition {
    /// All conditions of this kind in a scene. The first of them gets the index `first` in the list of conditions.
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

    /// Describes a violation: "cable 3 meets pillar, 12.0 mm deep".
    fn sentence(found: &Broken) -> String
    where
        Self: Sized;

    /// The kind of the condition.
    fn kind(&self) -> Kind;

    /// The members of the condition: a pair, or a single member.
    fn members(&self, bodies: &Bodies) -> Vec<Member>;

    /// Whether both members belong to the robot.
    fn within_robot(&self) -> bool {
        false
    }

    /// The index of the condition's obstacle body in [`Bodies::obstacles`], if it has one.
    fn obstacle_mut(&mut self) -> Option<&mut usize> {
        None
    }

    /// The obstacles that the condition concerns, as indices into [`crate::model::Scene::obstacles`]; several for a
    /// seam between them.
    fn obstacles(&self, _: &Bodies) -> Vec<usize> {
        Vec::new()
    }

    /// Whether the condition's body closes a seam between parts.
    fn closes_seam(&self, _: &Bodies) -> bool {
        false
    }

    /// Whether this condition closes a seam and `other` concerns a part beside that seam. If both are broken, `other`
    /// gives the right culprit and depth.
    fn is_seam_beside(&self, _other: &dyn PhysicalCondition, _: &Bodies) -> bool {
        false
    }

    /// The required distance, m.
    fn required(&self, bodies: &Bodies) -> f64;

    /// Whether the condition limits the gap between two surfaces, unlike ends that touch by construction, seams, the
    /// workspace and cable lengths.
    fn is_about_gap(&self, _: &Bodies) -> bool {
        false
    }

    /// The smallest distance during a motion, m.
    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64;

    /// The points on the surfaces of the two members that are nearest to each other at a position, world, in the order
    /// of the members; where they overlap, points in the overlap. `None` if the condition does not limit a gap between
    /// two members.
    fn nearest_points(&self, _: &Bodies, _position: &Point) -> Option<[Point; 2]> {
        None
    }

    /// What the distance includes at two poses because cables can take several shapes; `None` if they cannot.
    fn shapes(&self, _: &Bodies, _ends: &[Placed; 2]) -> Option<Shapes> {
        None
    }

    /// A lower bound on the distance of the surfaces during a motion, m, also where it is more than required.
    fn clearance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        self.distance(bodies, from, to)
    }

    /// A lower bound on the distance of the surfaces at a pose, m, also where it is more than required.
    fn clearance_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        self.slack_at(bodies, at) + self.required(bodies)
    }

    /// A lower bound of [`PhysicalCondition::clearance`] from bounding boxes, m; minus infinity if they overlap.
    fn boxes_apart(&self, _: &Bodies, _from: &Point, _to: &Point) -> f64 {
        f64::NEG_INFINITY
    }

    /// The distance that measures how badly a motion breaks the condition, m, if that is not the minimum over all
    /// positions between first and last contact.
    fn worst_distance(&self, _: &Bodies, _: Interference, _from: &Point, _to: &Point) -> Option<f64> {
        None
    }

    /// How far a position is from breaking the condition, m. Every shorter motion from there keeps it, because
    /// distances change by at most the length of the motion. Minus infinity if no distance gives such a bound.
    fn slack(&self, bodies: &Bodies, position: &Point) -> f64 {
        self.distance(bodies, position, position) - self.required(bodies)
    }

    /// Whether every position of a box certainly is within `margin`, m, of one that breaks the condition. A bound:
    /// false proves nothing.
    ///
    /// The default is for conditions whose forbidden positions are convex, and so are those within a distance of them: the
    /// corners of the box decide.
    fn forbids_all(&self, bodies: &Bodies, positions: &Cuboid, margin: f64) -> bool {
        let forbidden = |position: &Point| {
            let slack = self.slack(bodies, position);
            slack.is_finite() && slack <= margin
        };
        forbidden(&positions.center) && positions.corners().iter().all(forbidden)
    }

    /// Whether every position of a box certainly keeps the condition. A bound: false proves nothing.
    fn allows_all(&self, bodies: &Bodies, positions: &Cuboid) -> bool {
        self.slack(bodies, &positions.center) >= positions.half.norm()
    }

    /// Whether a motion breaks the condition, by GJK or in closed form.
    fn breaks(&self, bodies: &Bodies, interference: Interference, from: &Point, to: &Point) -> bool;

    /// How far the condition is from being broken at a pose, m; below -[`TOUCH_DEPTH`](crate::tolerances::TOUCH_DEPTH)
    /// it is broken.
    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64;

    /// Whether a bound proves that a piece of a turning motion keeps the condition.
    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool;

    /// Whether the condition requires more than no contact, so that the positions it forbids have rounded edges and
    /// corners.
    fn is_rounded(&self) -> bool {
        false
    }

    /// Whether a cable ends on the body that it must not enter. Its distance from the body then does not show how close
    /// it is to entering.
    fn ends_on_body(&self) -> bool {
        false
    }

    /// Whether the condition forbids positions outside of all its pieces.
    fn exceeds_pieces(&self) -> bool {
        self.regions_are_loose()
    }

    /// Whether motions outside all regions of the condition can break it.
    fn exceeds_regions(&self, _: Interference) -> bool {
        false
    }

    /// A quick sufficient test that a motion keeps the condition.
    fn certainly_keeps(&self, _from: &Point, _to: &Point) -> bool {
        false
    }

    /// The positions that break the condition if `gap` is 0 and the members are bodies. For a larger `gap`, m, a
    /// superset of the positions where the members are closer than that.
    ///
    /// `None` if the set has no volume, is not a polyhedron, or has planes that rounding makes unreliable (a flat part
    /// seen edge-on).
    fn forbidden(&self, _: &Bodies, _gap: f64, _: &Fattened) -> Option<ForbiddenPolyhedron> {
        None
    }

    /// Half-spaces that closely contain the positions that break its required distance: edges and corners are rounded
    /// off by bevels, where [`PhysicalCondition::forbidden`] sums with a cube. `None` if there is no such polyhedron.
    fn rounded(&self, _: &Bodies, _: &Fattened) -> Option<Vec<HalfSpace>> {
        None
    }

    /// A polyhedron of positions that break its required distance, from bodies that are fattened from inside; it is larger than the one of
    /// positions in contact. `None` if no distance is required, or if there is no such polyhedron.
    fn forbidden_inside(&self, _: &Bodies, _: &Fattened) -> Option<ForbiddenPolyhedron> {
        None
    }

    /// The obstacle body, and the distance from it, m, that [`PhysicalCondition::forbidden`] requests from
    /// [`Fattened`].
    fn fattens(&self) -> Option<(usize, f64)> {
        None
    }

    /// Convex pieces of the positions that break the condition, bracketed; empty if it forbids nothing inside the box
    /// of positions.
    fn regions(&self, bodies: &Bodies, scale: &Scale, fat: &Fattened) -> Vec<Region>;

    /// Whether the outer polyhedra of the condition's regions are much larger than what it forbids.
    fn regions_are_loose(&self) -> bool {
        false
    }

    /// From the platform's origin to the point at which to draw the condition's regions in the world: the cable's end
    /// on the platform.
    fn attachment(&self, _: &Bodies) -> Vector {
        Vector::zeros()
    }

    /// Closed surfaces around what the condition forbids without clearance, moved by `by` and cut at a box; `None` if
    /// the bodies are too close to degenerate.
    fn surfaces(&self, bodies: &Bodies, by: &Vector, within: &Aabb) -> Option<Vec<TriangleMesh>> {
        let found = self.forbidden(bodies, 0.0, &Fattened::default());
        Some(found.and_then(|found| surface(&found, by, within)).into_iter().collect())
    }
}

/// The closed surface of a forbidden polyhedron, moved by `by` and cut at a box.
pub fn surface(found: &ForbiddenPolyhedron, by: &Vector, within: &Aabb) -> Option<TriangleMesh> {
    let moved: Vec<HalfSpace> = found.half_spaces.iter().map(|h| h.moved(by)).collect();
    convex_mesh(&moved, within)
}

/// The parts of a message about a violation.
#[derive(Debug, Clone, Copy)]
pub struct Broken<'a> {
    /// The names of the members involved.
    pub culprits: &'a [String],
    /// Worst gap over the motion, m.
    pub gap: Option<f64>,
    /// The required gap, m.
    pub required: Option<f64>,
}

impl Broken<'_> {
    /// The name of a culprit.
    pub fn name(&self, k: usize) -> &str {
        self.culprits.get(k).map_or("?", String::as_str)
    }

    /// Describes that two bodies meet, or come too close to each other.
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

    /// Describes how much is missing: " by 12.0 mm".
    pub fn lacking(&self) -> String {
        self.gap.map_or(String::new(), |room| format!(" by {}", small_length(-room)))
    }
}
