//! From constraints to pairs of convex polyhedra of positions.
//!
//! A [`Region`] brackets what a constraint forbids between an outer polyhedron, outside of which a position is certainly free
//! of the constraint, and an inner one, inside of which it certainly breaks it. Between them lie rounding and contact, and,
//! with a clearance, the rounded corners: there the gjk engine decides.

use crate::collision::constraint::{CableAt, Constraint, Constraints, Demand};
use crate::collision::forbidden::{Fattened, Forbidden, forbidden_with};
use crate::geometry::{HalfSpace, Point, Vector};
use crate::numerics::{FATTENED, MIN_CABLE_LENGTH, ROUNDING, SUPERSET, TOUCH_DEPTH};

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

/// What one constraint forbids, or a convex piece of it, bracketed.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Outside of these, no position breaks the constraint by way of this piece. None: nothing is known.
    pub outer: Option<Vec<HalfSpace>>,
    /// Inside of this, every position breaks the constraint: it is more than the depth of touching inside the set.
    pub inner: Inner,
}

impl Region {
    /// The polyhedron inside of which every position breaks the constraint, if one is known.
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

/// Positions that certainly break a constraint.
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
    rounding: f64,
}

impl Scale {
    /// The scale of a scene.
    pub fn of(constraints: &Constraints) -> Self {
        let (min, max) = constraints.position_box();
        let corner = min.coords.abs().sup(&max.coords.abs());
        let cables = constraints.cables.iter();
        let farthest = cables.map(|c| c.outlet.coords.norm() + c.arm.norm()).fold(corner.norm(), f64::max);
        let reach = 2.0 * farthest;
        Scale { reach, rounding: ROUNDING * reach }
    }
}

/// The regions, within the box of positions, of the constraint at an index of the list; empty if it forbids nothing or is no matter of regions (the
/// workspace).
pub fn regions(constraints: &Constraints, index: usize, scale: &Scale, fat: &Fattened) -> Vec<Region> {
    let (min, max) = constraints.position_box();
    let mut regions = exact_regions(constraints, index, scale, fat);
    for region in &mut regions {
        region.outer = region.outer.take().map(|planes| sorted(planes, &min, &max));
        if let Inner::Own(planes) = &mut region.inner {
            *planes = sorted(std::mem::take(planes), &min, &max);
        }
    }
    regions
}

fn exact_regions(constraints: &Constraints, index: usize, scale: &Scale, fat: &Fattened) -> Vec<Region> {
    let constraint = &constraints.list[index];
    match constraint {
        Constraint::Workspace { .. } => Vec::new(),
        Constraint::CableLength { cable, min, max } => cable_length(&constraints.cables[*cable], *min, *max, scale),
        Constraint::CableCable(pair) => {
            let piece = |outer: Option<Vec<HalfSpace>>| Region { outer, inner: Inner::Unknown };
            match pair.wedges() {
                Some(wedges) => wedges.map(|w| piece(Some(widened(&w, scale.rounding)))).into(),
                None => vec![piece(None)],
            }
        }
        Constraint::PlatformObstacle { body, gap, .. } => {
            let touch = constraints.obstacles[*body].seam.unwrap_or(TOUCH_DEPTH);
            vec![bracketed(constraints, index, [*gap, touch], scale, fat)]
        }
        Constraint::CableObstacle { demand, .. } | Constraint::CablePlatform { demand, .. } => {
            let (gap, touch) = match demand {
                Demand::Apart { gap } => (*gap, TOUCH_DEPTH),
                Demand::Outside { touch } => (0.0, *touch),
                Demand::Leave { .. } => (0.0, TOUCH_DEPTH),
            };
            vec![bracketed(constraints, index, [gap, touch], scale, fat)]
        }
    }
}

/// The region of a constraint with this gap and this depth that still counts as touching.
fn bracketed(c: &Constraints, index: usize, [gap, touch]: [f64; 2], scale: &Scale, fat: &Fattened) -> Region {
    let set = |gap: f64| forbidden_with(c, &c.list[index], gap, fat);
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

fn widened(half_spaces: &[HalfSpace], by: f64) -> Vec<HalfSpace> {
    half_spaces.iter().map(|h| h.widened(by)).collect()
}

/// Too short: inside a ball, which a cube holds. Too long: outside of another, which no polyhedron does.
fn cable_length(cable: &CableAt, min: f64, max: f64, scale: &Scale) -> Vec<Region> {
    let center = cable.outlet - cable.arm;
    let faces = (0..6).map(|k| Vector::ith(k / 2, if k % 2 == 0 { 1.0 } else { -1.0 }));
    let cube = faces.map(|n| HalfSpace::through(&center, n).widened(min.max(MIN_CABLE_LENGTH) + scale.rounding));
    let short = Region { outer: Some(cube.collect()), inner: Inner::Unknown };
    let long = max.is_finite().then_some(Region { outer: None, inner: Inner::Unknown });
    std::iter::once(short).chain(long).collect()
}
