//! How far a convex body extends beyond a surface, with proof.
//!
//! Distance is 1-Lipschitz, so a box extends at most as far as its centre plus half its diagonal. A box also extends at
//! most as far beyond the surface's body as beyond any ball inside that body. If a face of the convex body cuts the
//! box, only the part behind the face counts; therefore a few boxes suffice for a large round body. Boxes that may
//! extend farthest are halved first, and boxes outside the convex body are dropped.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use nalgebra::Rotation3;

use crate::error::Error;
use crate::geometry::surface::solid::SignedDistance;
use crate::geometry::{Aabb, HalfSpace, Point, Vector};
use crate::tolerances::UNDECIDED;
use crate::watch::Watch;

/// Bounds on how far a body extends beyond a surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    /// Upper bound, m.
    pub bound: f64,
    /// Lower bound, m, attained at this point.
    pub worst: Option<(f64, Point)>,
    /// Effort: the number of boxes, plus one step for every [`TRIANGLES_PER_STEP`].
    pub steps: usize,
}

/// Number of triangles that take about as long to examine as a box.
const TRIANGLES_PER_STEP: usize = 8;

/// Steps between two checks of the watch.
const LOOK_STEPS: usize = 1000;

/// When to stop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Until {
    /// A bound that is low enough, m.
    pub enough: f64,
    /// Whether a point farther than [`UNDECIDED`] times `enough` also ends the search: the body extends too far.
    pub or_beyond: bool,
    /// Maximum number of steps.
    pub steps: usize,
}

/// A box, the distance of its centre from the surface (negative inside the body), a bound on how far it extends, and the
/// planes that cut it.
struct Cuboid {
    middle: Point,
    half: Vector,
    distance: f64,
    bound: f64,
    order: usize,
    planes: Vec<u32>,
    /// A ball inside the surface's body: its centre and radius.
    ball: Option<(Point, f64)>,
}

/// Result of examining a box; the numbers are steps.
enum Measured {
    /// The box is outside the convex body.
    Outside,
    /// The box extends no farther than the bound that is low enough.
    Settled(usize),
    /// The box may extend too far; whether its centre is inside the convex body.
    Open(Cuboid, bool, usize),
}

/// Number of planes through a box up to which each is examined with a ball.
const FEW_PLANES: usize = 16;

/// How far the part of a box behind some planes extends beyond a ball, m.
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

/// A convex body: the points behind planes and in a box.
pub(super) struct Bounded {
    pub planes: Vec<HalfSpace>,
    pub aabb: Aabb,
    /// From the axes of planes and box to those of the surface; `None` if they are the same. Boxes along a thin body
    /// are few.
    pub frame: Option<Rotation3<f64>>,
}

/// How far a convex body extends beyond a surface.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub(super) fn reach(surface: &SignedDistance, body: &Bounded, until: &Until, watch: &Watch) -> Result<Reach, Error> {
    let Bounded { planes, aabb, frame } = body;
    let placed = |p: &Point| frame.as_ref().map_or(*p, |frame| frame * p);
    let mut triangles = 0;
    // A box known to extend no farther than this is not examined again: the result is "low enough" or a larger bound.
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
        let near = least <= settled || surface.within(&placed(&middle), settled - half.norm(), &mut triangles);
        let hint = parent.map_or(f64::INFINITY, |(parent, way)| parent.distance.abs() + way);
        let mut distance = if near { 0.0 } else { surface.to_surface(&placed(&middle), hint, &mut triangles).0 };
        // The surface does not pass between the centre of the parent and a centre closer to it than the surface.
        let inside_body = match parent {
            Some((parent, way)) if way < parent.distance.abs() => parent.distance < 0.0,
            _ => !near && surface.encloses(&placed(&middle)),
        };
        if inside_body {
            distance = -distance;
        }
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
            found.worst = found.worst.or(Some((top.distance, top.middle))).map(|(far, p)| (far, placed(&p)));
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
    found.worst = found.worst.map(|(far, p)| (far, placed(&p)));
    Ok(found)
}
