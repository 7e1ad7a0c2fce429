//! What a constraint forbids, as a convex polyhedron in the space of positions.
//!
//! At fixed orientation every constraint but distances and lengths forbids such polyhedra:
//!
//! - platform against obstacle O: O ⊕ (-P);
//! - cable against obstacle: the shadow of O seen from the outlet B, moved by minus the arm R a;
//! - cable against a platform part K that it is not attached to: with K standing still the cable runs from R a to B - p, so
//!   the shadow of K seen from R a, mirrored: p ∈ B - (RK ⊕ cone(RK - R a));
//! - a cable and a body that it ends on: the cone of directions below all facets that are active there.

use std::borrow::Cow;

use super::constraint::{Constraint, Constraints, Demand};
use crate::geometry::{HalfSpace, Point, Polytope, Vector, shadow};
use crate::numerics::{ON_SURFACE, PARALLEL};

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
    fn exact(half_spaces: Vec<HalfSpace>) -> Self {
        Forbidden { half_spaces, tilt: 0.0 }
    }
}

/// The positions that break a constraint, for `gap` 0 and bodies; for a larger `gap`, m, a superset of the positions where
/// those whom it keeps apart are nearer than that.
///
/// None where that has no volume, no planes that rounding leaves alone (a flat part seen edge-on), or is no polyhedron: the
/// workspace, lengths, pairs of cables (for them see [`super::cable_cable::CablePair::wedges`]).
pub fn forbidden(constraints: &Constraints, constraint: &Constraint, gap: f64) -> Option<Forbidden> {
    let c = constraints;
    match constraint {
        Constraint::PlatformObstacle { part, body, .. } => {
            let (part, obstacle) = (&c.platform[*part], &c.obstacles[*body].body);
            let differences =
                obstacle.vertices().iter().flat_map(|o| part.vertices().iter().map(move |p| o - p.coords));
            let sum = Polytope::hull_of(&differences.collect::<Vec<_>>()).ok()?;
            let fat = fattened(&sum, gap)?;
            fat.has_volume().then(|| Forbidden::exact(fat.half_spaces()))
        }
        Constraint::CableObstacle { cable, body, demand } => {
            let cable = &c.cables[*cable];
            let found = behind(&c.obstacles[*body].body, &cable.outlet, demand, gap)?;
            Some(found.placed(|h| h.moved(&-cable.arm)))
        }
        Constraint::CablePlatform { cable, body, demand } => {
            let cable = &c.cables[*cable];
            let found = behind(&c.platform[*body], &Point::from(cable.arm), demand, gap)?;
            Some(found.placed(|h| h.reflected(&cable.outlet.coords)))
        }
        Constraint::Workspace { .. } | Constraint::CableLength { .. } | Constraint::CableCable(_) => None,
    }
}

impl Forbidden {
    fn placed(&self, place: impl Fn(&HalfSpace) -> HalfSpace) -> Self {
        Forbidden { half_spaces: self.half_spaces.iter().map(place).collect(), tilt: self.tilt }
    }
}

/// Where a cable from `apex` cannot end because of a body: in its shadow, or, if it starts on the body, below the surface.
fn behind(body: &Polytope, apex: &Point, demand: &Demand, gap: f64) -> Option<Forbidden> {
    if let Demand::Leave { normals } = demand {
        return Some(Forbidden::exact(normals.iter().map(|n| HalfSpace::through(apex, *n)).collect()));
    }
    let found = shadow(&*fattened(body, gap)?, apex)?;
    Some(Forbidden { half_spaces: found.half_spaces, tilt: found.tilt })
}

/// A body that holds everything nearer than `gap` to another: its sum with a cube around the ball. None if it has no hull.
fn fattened(body: &Polytope, gap: f64) -> Option<Cow<'_, Polytope>> {
    if gap == 0.0 {
        return Some(Cow::Borrowed(body));
    }
    let corner = |k: usize| Vector::from_fn(|axis, _| if k >> axis & 1 == 1 { gap } else { -gap });
    let points: Vec<Point> = body.vertices().iter().flat_map(|p| (0..8).map(move |k| p + corner(k))).collect();
    Polytope::hull_of(&points).ok().map(Cow::Owned)
}

/// The positions that break a constraint with a demanded distance, as half-spaces that hold them and not much more: where
/// [`forbidden`] sums with a cube, this rounds edges and corners off by bevels. None where there is no such polyhedron.
pub fn rounded(constraints: &Constraints, constraint: &Constraint) -> Option<Vec<HalfSpace>> {
    let c = constraints;
    match constraint {
        Constraint::PlatformObstacle { part, body, gap } if *gap > 0.0 => {
            let (part, obstacle) = (&c.platform[*part], &c.obstacles[*body].body);
            let differences =
                obstacle.vertices().iter().flat_map(|o| part.vertices().iter().map(move |p| o - p.coords));
            let sum = Polytope::hull_of(&differences.collect::<Vec<_>>()).ok().filter(Polytope::has_volume)?;
            Some(directions(&sum).into_iter().map(|n| HalfSpace::around(sum.vertices(), n).widened(*gap)).collect())
        }
        Constraint::CableObstacle { cable, body, demand: Demand::Apart { gap } } if *gap > 0.0 => {
            let cable = &c.cables[*cable];
            let planes = rounded_shadow(&c.obstacles[*body].body, &cable.outlet, *gap)?;
            Some(planes.iter().map(|h| h.moved(&-cable.arm)).collect())
        }
        Constraint::CablePlatform { cable, body, demand: Demand::Apart { gap } } if *gap > 0.0 => {
            let cable = &c.cables[*cable];
            let planes = rounded_shadow(&c.platform[*body], &Point::from(cable.arm), *gap)?;
            Some(planes.iter().map(|h| h.reflected(&cable.outlet.coords)).collect())
        }
        _ => None,
    }
}

/// Largest angle between the normals of neighbouring bevels, rad: a rounded edge is then exceeded by 3.5 % of its radius.
const BEVEL: f64 = std::f64::consts::FRAC_PI_6;

/// Outward normals of a body's facets, of bevels of its edges, and of its corners.
fn directions(body: &Polytope) -> Vec<Vector> {
    let facets = body.facets();
    let mut all: Vec<Vector> = facets.iter().map(|f| f.normal).collect();
    for (k, a) in facets.iter().enumerate() {
        for b in &facets[k + 1..] {
            if a.corners.iter().filter(|corner| b.corners.contains(corner)).count() >= 2 {
                all.extend(between(&a.normal, &b.normal));
            }
        }
    }
    let at =
        |corner: usize| facets.iter().filter(move |f| f.corners.contains(&corner)).map(|f| f.normal).sum::<Vector>();
    all.extend((0..body.vertices().len()).filter_map(|corner| at(corner).try_normalize(PARALLEL)));
    all
}

/// Unit vectors from one to another in even steps of at most [`BEVEL`], without both.
fn between(a: &Vector, b: &Vector) -> Vec<Vector> {
    let steps = (a.angle(b) / BEVEL).ceil().max(1.0) as usize;
    let at = |k: usize| a.slerp(b, k as f64 / steps as f64);
    (1..steps).map(at).collect()
}

/// What is hidden from a point by everything nearer than `gap` to a body: planes that face the point, and planes through it.
fn rounded_shadow(body: &Polytope, apex: &Point, gap: f64) -> Option<Vec<HalfSpace>> {
    let around = |n: Vector| HalfSpace::around(body.vertices(), n).widened(gap);
    let exact = shadow(body, apex).filter(|_| body.has_volume())?;
    let facing = directions(body).into_iter().map(around).filter(|plane| plane.height(apex) > 0.0);
    let axis = (nalgebra::Point::from(
        body.vertices().iter().map(|v| v.coords).sum::<Vector>() / body.vertices().len() as f64,
    ) - apex)
        .try_normalize(PARALLEL)?;
    let mut sides: Vec<Vector> =
        exact.half_spaces.iter().filter(|h| h.height(apex).abs() <= ON_SURFACE).map(|h| h.normal).collect();
    let across = sides.first()?.cross(&axis).try_normalize(PARALLEL)?;
    let up = axis.cross(&across);
    sides.sort_by(|a, b| f64::atan2(a.dot(&up), a.dot(&across)).total_cmp(&f64::atan2(b.dot(&up), b.dot(&across))));
    let corners = (0..sides.len()).flat_map(|k| between(&sides[k], &sides[(k + 1) % sides.len()])).collect::<Vec<_>>();
    let cone: Option<Vec<HalfSpace>> =
        sides.iter().chain(&corners).map(|n| tangent(body, apex, n, &axis, gap)).collect();
    Some(facing.chain(cone?).collect())
}

/// The plane through a point, turned from the normal `n` away from the axis just so far that it keeps `gap` from a body.
fn tangent(body: &Polytope, apex: &Point, n: &Vector, axis: &Vector, gap: f64) -> Option<HalfSpace> {
    let forward = (axis - n * n.dot(axis)).try_normalize(PARALLEL)?;
    // For normals n cos φ - forward sin φ a corner is at A cos φ - C sin φ, which must be at most -gap.
    let turn = |corner: &Point| {
        let (a, c) = (n.dot(&(corner - apex)), forward.dot(&(corner - apex)));
        let reach = a.hypot(c);
        (reach > gap).then(|| (gap / reach).asin() + f64::atan2(a, c))
    };
    let turns: Option<Vec<f64>> = body.vertices().iter().map(turn).collect();
    let most = turns?.into_iter().fold(0.0, f64::max);
    (most < std::f64::consts::FRAC_PI_2).then(|| HalfSpace::through(apex, n * most.cos() - forward * most.sin()))
}
