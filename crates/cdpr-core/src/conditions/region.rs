//! What a condition forbids, as convex polyhedra in the space of positions.
//!
//! A [`Forbidden`] polyhedron is exact but for rounding. A [`Region`] brackets it between an outer polyhedron, outside of which
//! a position certainly keeps the condition, and an inner one, inside of which it certainly breaks it. Between them lie
//! rounding and contact, and, with a clearance, the rounded corners: there the gjk engine decides.

use super::bodies::Bodies;
use crate::geometry::{HalfSpace, Point, Vector};
use crate::numerics::{FATTENED, ROUNDING, SUPERSET};

/// An open convex polyhedron of positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Forbidden {
    /// Its half-spaces.
    pub half_spaces: Vec<HalfSpace>,
    /// Sine of the angle by which rounding may have turned a plane through the apex of a shadow; see
    /// [`crate::geometry::Shadow`].
    pub tilt: f64,
}

impl Forbidden {
    /// A polyhedron whose planes rounding has not turned.
    pub fn exact(half_spaces: Vec<HalfSpace>) -> Self {
        Forbidden { half_spaces, tilt: 0.0 }
    }

    /// The polyhedron with each of its planes put elsewhere.
    pub fn placed(&self, place: impl Fn(&HalfSpace) -> HalfSpace) -> Self {
        Forbidden { half_spaces: self.half_spaces.iter().map(place).collect(), tilt: self.tilt }
    }
}

/// A convex polyhedron of positions that a condition forbids.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyhedron {
    /// Index of the condition in the list; its members are the culprits.
    pub condition: usize,
    /// The polyhedron, open.
    pub half_spaces: Vec<HalfSpace>,
}

/// A convex piece of what a condition forbids, bracketed.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Index of the condition in the list; its members are the culprits.
    pub condition: usize,
    /// Holds every position of the piece.
    pub outer: Vec<HalfSpace>,
    /// Every position inside of this polyhedron is forbidden; none if no such polyhedron is known.
    pub certain: Option<Vec<HalfSpace>>,
}

/// What one condition forbids, or a convex piece of it, bracketed.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Outside of these, no position breaks the condition by way of this piece. None: nothing is known.
    pub outer: Option<Vec<HalfSpace>>,
    /// Inside of this, every position breaks the condition: it is more than the depth of touching inside the set.
    pub inner: Inner,
}

impl Region {
    /// A region of which only a polyhedron is known that holds it, or nothing at all.
    pub fn within(outer: Option<Vec<HalfSpace>>) -> Self {
        Region { outer, inner: Inner::Unknown }
    }

    /// The region of a condition that forbids `set(gap)`, with its gap and the depth that still counts as touching, m.
    pub fn bracketed(set: impl Fn(f64) -> Option<Forbidden>, [gap, touch]: [f64; 2], scale: &Scale) -> Self {
        let error = |f: &Forbidden| f.tilt * scale.reach + scale.rounding;
        let grown = |f: &Forbidden| widened(&f.half_spaces, error(f));
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

    /// The region with those of its planes that matter in a box of positions, sorted for quick answers.
    pub fn sorted(mut self, min: &Point, max: &Point) -> Self {
        self.outer = self.outer.map(|planes| sorted(planes, min, max));
        if let Inner::Own(planes) = &mut self.inner {
            *planes = sorted(std::mem::take(planes), min, max);
        }
        self
    }

    /// The polyhedron inside of which every position breaks the condition, if one is known.
    pub fn certain(&self) -> Option<Vec<HalfSpace>> {
        match &self.inner {
            Inner::Unknown => None,
            Inner::Shrunk(by) => self.outer.as_ref().map(|planes| widened(planes, *by)),
            Inner::Own(planes) => Some(planes.clone()),
        }
    }

    /// Bytes that the planes take.
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
    /// The outer polyhedron with its planes moved by this (negative), m.
    Shrunk(f64),
    /// A polyhedron of its own.
    Own(Vec<HalfSpace>),
}

/// How large and how far from the origin everything is: what rounding is relative to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Longest cable between positions of the box, m.
    reach: f64,
    /// Error of a height over a plane, m.
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

/// The half-spaces that matter in a box of positions, those first that rule out most of it: a plane that has the whole box
/// inside never does, and the first group of planes is asked before the others.
fn sorted(half_spaces: Vec<HalfSpace>, min: &Point, max: &Point) -> Vec<HalfSpace> {
    let (center, half) = (nalgebra::center(min, max), (max - min) * 0.5);
    let mut left: Vec<HalfSpace> =
        half_spaces.into_iter().filter(|h| h.height(&center) + h.normal.abs().dot(&half) >= 0.0).collect();
    let place = |k: usize| {
        let share = |axis: i32| ((k / SAMPLES.pow(axis as u32) % SAMPLES) as f64 + 0.5) / SAMPLES as f64;
        min + (max - min).component_mul(&Vector::new(share(0), share(1), share(2)))
    };
    // One bit for each place that a plane rules out.
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

/// Places along each axis at which planes are tried: 64 in all, one to a bit.
const SAMPLES: usize = 4;

/// Half-spaces with their planes moved outward, m.
pub fn widened(half_spaces: &[HalfSpace], by: f64) -> Vec<HalfSpace> {
    half_spaces.iter().map(|h| h.widened(by)).collect()
}
