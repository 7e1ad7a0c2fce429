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
