//! How far a convex body reaches beyond a surface, proved.
//!
//! Distance changes by no more than the way, so a box reaches no farther than its middle does and half its diagonal
//! adds. Nor does it reach farther from the surface's body than from any ball inside that; of a box that a face of the
//! convex body cuts only what is behind the face counts, which is how a few boxes suffice for a large round one. Boxes
//! that may reach farthest are halved first, and those that are outside the body are left out.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::solid::SignedDistance;
use super::{Aabb, HalfSpace, Point, Vector};
use crate::error::Error;
use crate::numerics::UNDECIDED;
use crate::watch::Watch;

/// What is known of how far a body reaches.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    /// No farther than this, m.
    pub bound: f64,
    /// At least this far at this place, m.
    pub worst: Option<(f64, Point)>,
    /// What it took: boxes, and a step more for every [`TRIANGLES_PER_STEP`].
    pub steps: usize,
}

/// Triangles that take about as long to look at as a box.
const TRIANGLES_PER_STEP: usize = 8;

/// Steps between two looks at the watch.
const LOOK_STEPS: usize = 1000;

/// Until when to look.
#[derive(Debug, Clone, Copy)]
pub(super) struct Until {
    /// A bound that is low enough, m.
    pub enough: f64,
    /// Whether a place beyond [`UNDECIDED`] of that ends the search, too: the body reaches too far.
    pub or_beyond: bool,
    /// Most steps.
    pub steps: usize,
}

/// A box, how far its middle is from the surface, and how far it can reach; the planes that run through it.
struct Cuboid {
    middle: Point,
    half: Vector,
    distance: f64,
    bound: f64,
    order: usize,
    planes: Vec<u32>,
    /// A ball inside the surface's body: its middle and radius.
    ball: Option<(Point, f64)>,
}

/// What a look at a box gives; the numbers are steps.
enum Measured {
    /// It is outside the convex body.
    Outside,
    /// It reaches no farther than what is low enough.
    Settled(usize),
    /// It may reach too far; whether its middle is inside the convex body.
    Open(Cuboid, bool, usize),
}

/// Planes through a box up to which each is looked at with a ball.
const FEW_PLANES: usize = 16;

/// How far what is in a box and behind some planes reaches beyond a ball, m.
fn beyond_ball(middle: &Point, half: &Vector, planes: &[HalfSpace], through: &[u32], ball: &(Point, f64)) -> f64 {
    let (centre, radius) = *ball;
    let offset = middle - centre;
    let farthest = (offset.abs() + half).norm() - radius;
    if through.len() > FEW_PLANES {
        return farthest;
    }
    let behind = through.iter().map(|k| {
        let plane = &planes[*k as usize];
        let (along, spread) = (plane.normal.dot(&offset), plane.normal.abs().dot(half));
        let high = (along + spread).min(-plane.height(&centre));
        let along = high.abs().max((along - spread).abs());
        let beside = (0..8).map(|c| {
            let corner = offset + Vector::from_fn(|k, _| if c >> k & 1 == 1 { half[k] } else { -half[k] });
            (corner - plane.normal * plane.normal.dot(&corner)).norm_squared()
        });
        (along * along + beside.fold(0.0, f64::max)).sqrt() - radius
    });
    behind.fold(farthest, f64::min)
}

impl PartialEq for Cuboid {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cuboid {}

impl PartialOrd for Cuboid {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cuboid {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound).then(other.order.cmp(&self.order))
    }
}

/// How far the body behind planes and in a box reaches beyond a surface.
///
/// # Errors
/// The watch's.
pub(super) fn reach(
    surface: &SignedDistance,
    planes: &[HalfSpace],
    aabb: &Aabb,
    until: &Until,
    watch: &Watch,
) -> Result<Reach, Error> {
    let mut triangles = 0;
    // A box known to reach no farther than this is not looked at any more: the answer is "low enough" or a larger bound.
    let settled = if until.or_beyond { until.enough } else { f64::NEG_INFINITY };
    let mut measured = |middle: Point, half: Vector, parent: Option<(&Cuboid, f64)>, order: usize| {
        let mut through = Vec::new();
        let mut inside = true;
        let mut outside = |k: u32| {
            let plane = &planes[k as usize];
            let (height, spread) = (plane.height(&middle), plane.normal.abs().dot(&half));
            if height > -spread {
                through.push(k);
            }
            inside &= height <= 0.0;
            height > spread
        };
        let out = match parent {
            Some((parent, _)) => parent.planes.iter().any(|k| outside(*k)),
            None => (0..planes.len() as u32).any(outside),
        };
        if out {
            return Measured::Outside;
        }
        let mut ball = None;
        let mut least = f64::INFINITY;
        let above = parent.and_then(|(parent, _)| (parent.distance < 0.0).then_some((parent.middle, -parent.distance)));
        for candidate in parent.and_then(|(parent, _)| parent.ball).into_iter().chain(above) {
            let beyond = beyond_ball(&middle, &half, planes, &through, &candidate);
            if beyond < least {
                (ball, least) = (Some(candidate), beyond);
            }
        }
        let near = least <= settled || surface.within(&middle, settled - half.norm(), &mut triangles);
        let hint = parent.map_or(f64::INFINITY, |(parent, way)| parent.distance.abs() + way);
        let distance = if near { 0.0 } else { surface.counted(&middle, hint, &mut triangles).0 };
        let steps = 1 + std::mem::take(&mut triangles) / TRIANGLES_PER_STEP;
        if near {
            return Measured::Settled(steps);
        }
        let bound = (distance + half.norm()).min(least).min(parent.map_or(f64::INFINITY, |(parent, _)| parent.bound));
        Measured::Open(Cuboid { middle, half, distance, bound, order, planes: through, ball }, inside, steps)
    };
    let half = 0.5 * (aabb.max - aabb.min);
    let mut found = Reach { bound: 0.0, worst: None, steps: 0 };
    let mut order = 0;
    let mut look = 0;
    let mut open = BinaryHeap::new();
    let add = |open: &mut BinaryHeap<Cuboid>, found: &mut Reach, new: Measured| match new {
        Measured::Outside => {}
        Measured::Settled(steps) => {
            found.steps += steps;
            found.bound = settled;
        }
        Measured::Open(cuboid, inside, steps) => {
            found.steps += steps;
            if inside && found.worst.is_none_or(|(worst, _)| cuboid.distance > worst) {
                found.worst = Some((cuboid.distance, cuboid.middle));
            }
            open.push(cuboid);
        }
    };
    add(&mut open, &mut found, measured(aabb.min + half, half, None, 0));
    while let Some(top) = open.pop() {
        let worst = found.worst.map_or(0.0, |(worst, _)| worst);
        let low_enough = top.bound <= until.enough.max(if until.or_beyond { 0.0 } else { 1.1 * worst });
        let beyond = until.or_beyond && worst > UNDECIDED * until.enough;
        if low_enough || beyond || found.steps >= until.steps {
            found.bound = found.bound.max(top.bound);
            found.worst = found.worst.or(Some((top.distance, top.middle)));
            return Ok(found);
        }
        let axis = top.half.imax();
        let mut half = top.half;
        half[axis] *= 0.5;
        for side in [-half[axis], half[axis]] {
            order += 1;
            if found.steps >= look {
                watch.check()?;
                look = found.steps + LOOK_STEPS;
            }
            let mut middle = top.middle;
            middle[axis] += side;
            let new = measured(middle, half, Some((&top, half[axis])), order);
            add(&mut open, &mut found, new);
        }
    }
    Ok(found)
}
