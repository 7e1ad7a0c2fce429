//! The positions that a condition forbids, as convex polyhedra.
//!
//! A [`ForbiddenPolyhedron`] is exact up to rounding errors. A [`Region`] brackets it: a position outside the outer
//! polyhedron certainly satisfies the condition, one inside the inner polyhedron certainly breaks it. Positions between
//! the two (contacts, rounding errors and, with a clearance, rounded corners) are left to the gjk engine.
//!
//! The sets, for the position p of the platform at a fixed orientation R:
//!
//! | members | forbidden positions | facets |
//! |---|---|---|
//! | platform part P, obstacle O | O ⊕ (-P) | facets of the hull of all differences of corners |
//! | cable (outlet B, arm R a), obstacle | shadow of O from B, O ⊕ cone(O - B), moved by -R a | facets of O that face B; planes through B and O's silhouette |
//! | cable, platform part K off its attachment | B - (shadow of K from R a) | the same, mirrored |
//! | cable and a body that it ends on | the cone below all facets active at that end | those facets |
//! | two cables | two flat wedges; with a clearance, four-sided cones around them | four or five |
//! | length limits | inside one ball, outside another | a cube around the first; none for the second |
//!
//! Without a clearance both polyhedra have the same planes, moved outward by the rounding error of a height and inward by
//! the depth that counts as touching. With a clearance c, the inner polyhedron is the one without clearance. The outer
//! one is, for the platform, O ⊕ (-P) with its planes moved outward by c and those of a box added; for cables, the shadow
//! of the body fattened by c, since moving the planes of the shadow itself is not enough: the cone widens behind the
//! obstacle. Degenerate geometry (a plate seen edge-on, an edge in line with an outlet) only widens the gap between the
//! brackets.

use super::bodies::Bodies;
use crate::geometry::{HalfSpace, Point, Vector};
use crate::tolerances::{FATTENED, GAP_TOLERANCE, ROUNDING, SUPERSET};

/// An open convex polyhedron of positions.
#[derive(Debug, Clone, PartialEq)]
pub struct ForbiddenPolyhedron {
    /// The half-spaces; the polyhedron is their intersection.
    pub half_spaces: Vec<HalfSpace>,
    /// Sine of the largest angle by which rounding may have tilted a plane through the apex of a shadow; see
    /// [`crate::geometry::Shadow`].
    pub tilt: f64,
}

impl ForbiddenPolyhedron {
    /// A polyhedron whose planes are not tilted by rounding.
    pub fn exact(half_spaces: Vec<HalfSpace>) -> Self {
        ForbiddenPolyhedron { half_spaces, tilt: 0.0 }
    }

    /// The half-spaces moved inward by a depth that still counts as touching, m, and by rounding errors; `None` if those are too large.
    pub fn certain(&self, touch: f64, scale: &Scale) -> Option<Vec<HalfSpace>> {
        let error = self.tilt * scale.reach + scale.rounding;
        (error <= SUPERSET).then(|| widened(&self.half_spaces, -touch - error))
    }

    /// The polyhedron with a transformation applied to each plane.
    pub fn placed(&self, place: impl Fn(&HalfSpace) -> HalfSpace) -> Self {
        ForbiddenPolyhedron { half_spaces: self.half_spaces.iter().map(place).collect(), tilt: self.tilt }
    }
}

/// A convex polyhedron of positions that a condition forbids.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyhedron {
    /// Index of the condition in the list; its members are the culprits.
    pub condition: usize,
    /// The half-spaces; the polyhedron is open.
    pub half_spaces: Vec<HalfSpace>,
    /// The part that is forbidden without a clearance, if the condition requires one: what checkers of certificates know.
    pub of_contact: Option<Vec<HalfSpace>>,
}

/// A convex piece of what a condition forbids, bracketed.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Index of the condition in the list; its members are the culprits.
    pub condition: usize,
    /// Contains every position of the piece.
    pub outer: Vec<HalfSpace>,
    /// Every position inside this polyhedron is forbidden; `None` if no such polyhedron is known.
    pub certain: Option<Vec<HalfSpace>>,
}

/// The positions that one condition forbids, or a convex piece of them, bracketed.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Contains every position of the piece; `None` if no such polyhedron is known.
    pub outer: Option<Vec<HalfSpace>>,
    /// Contains only positions that break the condition: they are deeper inside the set than touching allows.
    pub inner: Inner,
}

impl Region {
    /// A region with at most an outer polyhedron.
    pub fn within(outer: Option<Vec<HalfSpace>>) -> Self {
        Region { outer, inner: Inner::Unknown }
    }

    /// The region of a condition that forbids `set(gap)`, given the gap and the depth that still counts as touching, m.
    pub fn bracketed(set: impl Fn(f64) -> Option<ForbiddenPolyhedron>, [gap, touch]: [f64; 2], scale: &Scale) -> Self {
        let error = |f: &ForbiddenPolyhedron| f.tilt * scale.reach + scale.rounding;
        let grown = |f: &ForbiddenPolyhedron| widened(&f.half_spaces, error(f));
        let region = |outer, inner| Region { outer, inner };
        let exact = set(0.0);
        let Some(certain) = exact.as_ref().filter(|f| error(f) <= SUPERSET) else {
            return region(set(gap.max(FATTENED)).as_ref().map(grown), Inner::Unknown);
        };
        if gap > 0.0 {
            let inner = Inner::Own(widened(&certain.half_spaces, -touch - error(certain)));
            return region(set(gap).as_ref().map(grown), inner);
        }
        region(Some(grown(certain)), Inner::Shrunk(-touch - 2.0 * error(certain)))
    }

    /// The region with only the planes that cut a box of positions, ordered for fast rejection.
    pub fn sorted(mut self, min: &Point, max: &Point) -> Self {
        self.outer = self.outer.map(|planes| sorted(planes, min, max));
        if let Inner::Own(planes) = &mut self.inner {
            *planes = sorted(std::mem::take(planes), min, max);
        }
        self
    }

    /// The inner polyhedron, if one is known: every position inside it breaks the condition.
    pub fn certain(&self) -> Option<Vec<HalfSpace>> {
        match &self.inner {
            Inner::Unknown => None,
            Inner::Shrunk(by) => self.outer.as_ref().map(|planes| widened(planes, *by)),
            Inner::Own(planes) => Some(planes.clone()),
        }
    }

    /// Size of the planes in bytes.
    pub fn bytes(&self) -> usize {
        let own = if let Inner::Own(planes) = &self.inner { planes.len() } else { 0 };
        (self.outer.as_ref().map_or(0, Vec::len) + own) * size_of::<HalfSpace>()
    }
}

/// Positions that certainly break a condition.
#[derive(Debug, Clone, PartialEq)]
pub enum Inner {
    /// No such set is known.
    Unknown,
    /// The outer polyhedron with its planes moved by this distance, m; negative.
    Shrunk(f64),
    /// A separate polyhedron.
    Own(Vec<HalfSpace>),
}

/// The size of the scene and its distance from the origin, to which rounding errors are proportional.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Upper bound on the cable length at positions in the box, m.
    reach: f64,
    /// Rounding error of a height above a plane, m.
    pub rounding: f64,
}

impl Scale {
    /// The scale of a scene with this box of positions.
    pub fn of(bodies: &Bodies, (min, max): (Point, Point)) -> Self {
        let corner = min.coords.abs().sup(&max.coords.abs());
        let cables = bodies.cables.iter();
        let farthest = cables.map(|c| c.outlet.coords.norm() + c.arm.norm()).fold(corner.norm(), f64::max);
        let reach = 2.0 * farthest;
        Scale { reach, rounding: ROUNDING * reach }
    }
}

/// The half-spaces that cut a box of positions, ordered so that the first ones rule out most of it: clipping tests the
/// planes in this order. Half-spaces that contain the whole box are dropped.
fn sorted(half_spaces: Vec<HalfSpace>, min: &Point, max: &Point) -> Vec<HalfSpace> {
    let (center, half) = (nalgebra::center(min, max), (max - min) * 0.5);
    let mut left: Vec<HalfSpace> =
        half_spaces.into_iter().filter(|h| h.height(&center) + h.normal.abs().dot(&half) >= -GAP_TOLERANCE).collect();
    let place = |k: usize| {
        let share = |axis: i32| ((k / SAMPLES.pow(axis as u32) % SAMPLES) as f64 + 0.5) / SAMPLES as f64;
        min + (max - min).component_mul(&Vector::new(share(0), share(1), share(2)))
    };
    // One bit for each sample position that a plane rules out.
    let ruled_out =
        |h: &HalfSpace| (0..SAMPLES.pow(3)).fold(0, |set, k| set | u64::from(h.height(&place(k)) >= 0.0) << k);
    let mut sets: Vec<u64> = left.iter().map(ruled_out).collect();
    let mut open = u64::MAX;
    let mut sorted = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let best = (0..left.len()).max_by_key(|&k| (sets[k] & open).count_ones()).expect("some are left");
        open &= !sets.swap_remove(best);
        sorted.push(left.swap_remove(best));
    }
    sorted
}

/// Sample positions along each axis: 64 in all, one per bit.
const SAMPLES: usize = 4;

/// Half-spaces with their planes moved outward by a distance, m.
pub fn widened(half_spaces: &[HalfSpace], by: f64) -> Vec<HalfSpace> {
    half_spaces.iter().map(|h| h.widened(by)).collect()
}
