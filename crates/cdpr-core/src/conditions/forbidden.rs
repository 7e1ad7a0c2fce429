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
use std::sync::OnceLock;

use super::constraint::{Constraint, Constraints, Demand};
use crate::geometry::{HalfSpace, Point, Polytope, Vector, shadow};
use crate::numerics::{FATTENED, ON_SURFACE, PARALLEL, RIGHT_ANGLE};

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
    forbidden_with(constraints, constraint, gap, &Fattened::default())
}

/// As [`forbidden`], with the obstacles that others have fattened already.
pub fn forbidden_with(c: &Constraints, constraint: &Constraint, gap: f64, fat: &Fattened) -> Option<Forbidden> {
    match constraint {
        Constraint::PlatformObstacle { part, body, .. } => {
            let sum = difference(c, *part, *body)?;
            if sum.has_volume() {
                return Some(Forbidden::exact(around(&sum, gap)));
            }
            let fat = fattened(&sum, gap)?;
            fat.has_volume().then(|| Forbidden::exact(fat.half_spaces()))
        }
        Constraint::CableObstacle { cable, body, demand } => {
            let cable = &c.cables[*cable];
            let found = match fat.obstacle(c, *body, gap) {
                Some(fat) => behind(fat.as_ref()?, &cable.outlet, demand)?,
                None => behind(&*fattened(&c.obstacles[*body].body, gap)?, &cable.outlet, demand)?,
            };
            Some(found.placed(|h| h.moved(&-cable.arm)))
        }
        Constraint::CablePlatform { cable, body, demand } => {
            let cable = &c.cables[*cable];
            let found = behind(&*fattened(&c.platform[*body], gap)?, &Point::from(cable.arm), demand)?;
            Some(found.placed(|h| h.reflected(&cable.outlet.coords)))
        }
        Constraint::Workspace { .. } | Constraint::CableLength { .. } | Constraint::CableCable(_) => None,
    }
}

/// Obstacle ⊕ (-platform part); none if it has no hull.
fn difference(c: &Constraints, part: usize, body: usize) -> Option<Polytope> {
    c.obstacles[body].body.sum(&c.platform[part].reflected()).ok()
}

/// Obstacles fattened by the distances that cables keep, each when it is first asked for: all cables share them.
#[derive(Debug, Default)]
pub struct Fattened {
    /// For each obstacle the distances that are kept from it, and the fattened body; none if that has no hull.
    bodies: Vec<Vec<(f64, OnceLock<Option<Polytope>>)>>,
    /// The [`directions`] of each obstacle.
    directions: Vec<OnceLock<Vec<Vector>>>,
}

impl Fattened {
    /// Room for what the constraints of a scene ask for.
    pub fn of(c: &Constraints) -> Self {
        let mut gaps: Vec<Vec<f64>> = vec![Vec::new(); c.obstacles.len()];
        for constraint in &c.list {
            if let Constraint::CableObstacle { body, demand: Demand::Apart { gap }, .. } = constraint
                && *gap > 0.0
            {
                gaps[*body].extend([*gap, gap.max(FATTENED)]);
            }
        }
        let room = |mut gaps: Vec<f64>| {
            gaps.sort_by(f64::total_cmp);
            gaps.dedup();
            gaps.into_iter().map(|gap| (gap, OnceLock::new())).collect()
        };
        let bodies = gaps.into_iter().map(room).collect();
        let directions = c.obstacles.iter().map(|_| OnceLock::new()).collect();
        Fattened { bodies, directions }
    }

    /// An obstacle fattened by a distance, if there is room for it; inside that, none if it has no hull.
    fn obstacle(&self, c: &Constraints, body: usize, gap: f64) -> Option<&Option<Polytope>> {
        let (_, known) = self.bodies.get(body)?.iter().find(|(known, _)| *known == gap)?;
        Some(known.get_or_init(|| fattened(&c.obstacles[body].body, gap).map(Cow::into_owned)))
    }
}

/// Half-spaces that hold everything nearer than `gap` to a body with volume: its own moved outward, and those of a box, so
/// that sharp edges do not reach far.
fn around(body: &Polytope, gap: f64) -> Vec<HalfSpace> {
    let mut half_spaces: Vec<HalfSpace> = body.half_spaces().iter().map(|h| h.widened(gap)).collect();
    if gap > 0.0 {
        for k in 0..6 {
            let normal = Vector::ith(k / 2, if k % 2 == 0 { 1.0 } else { -1.0 });
            if !half_spaces.iter().any(|h| h.normal.dot(&normal) >= 1.0) {
                half_spaces.push(HalfSpace::around(body.vertices(), normal).widened(gap));
            }
        }
    }
    half_spaces
}

impl Forbidden {
    fn placed(&self, place: impl Fn(&HalfSpace) -> HalfSpace) -> Self {
        Forbidden { half_spaces: self.half_spaces.iter().map(place).collect(), tilt: self.tilt }
    }
}

/// Where a cable from `apex` cannot end because of a body: in its shadow, or, if it starts on the body, below the surface.
fn behind(body: &Polytope, apex: &Point, demand: &Demand) -> Option<Forbidden> {
    if let Demand::Leave { normals } = demand {
        return Some(Forbidden::exact(normals.iter().map(|n| HalfSpace::through(apex, *n)).collect()));
    }
    let found = shadow(body, apex)?;
    Some(Forbidden { half_spaces: found.half_spaces, tilt: found.tilt })
}

/// A body that holds everything nearer than `gap` to another: a box is enlarged, others are summed with a cube around the
/// ball. None if it has no hull.
fn fattened(body: &Polytope, gap: f64) -> Option<Cow<'_, Polytope>> {
    if gap == 0.0 {
        return Some(Cow::Borrowed(body));
    }
    if is_box(body) {
        return body.with_planes_moved(gap).map(Cow::Owned);
    }
    body.sum(&Polytope::cuboid([2.0 * gap; 3]).ok()?).ok().map(Cow::Owned)
}

/// Whether a body is a box, however turned.
fn is_box(body: &Polytope) -> bool {
    let axes = body.normal_axes();
    let square = |k: usize| axes[k].dot(&axes[(k + 1) % 3]).abs() <= RIGHT_ANGLE;
    body.facets().len() == 6 && body.vertices().len() == 8 && axes.len() == 3 && (0..3).all(square)
}

/// The positions that break a constraint with a demanded distance, as half-spaces that hold them and not much more: where
/// [`forbidden`] sums with a cube, this rounds edges and corners off by bevels. None where there is no such polyhedron.
pub fn rounded(constraints: &Constraints, constraint: &Constraint) -> Option<Vec<HalfSpace>> {
    rounded_with(constraints, constraint, &Fattened::default())
}

/// As [`rounded`], with what others have found of the obstacles already.
pub fn rounded_with(c: &Constraints, constraint: &Constraint, fat: &Fattened) -> Option<Vec<HalfSpace>> {
    match constraint {
        Constraint::PlatformObstacle { part, body, gap } if *gap > 0.0 => {
            let sum = difference(c, *part, *body).filter(Polytope::has_volume)?;
            Some(directions(&sum).into_iter().map(|n| HalfSpace::around(sum.vertices(), n).widened(*gap)).collect())
        }
        Constraint::CableObstacle { cable, body, demand: Demand::Apart { gap } } if *gap > 0.0 => {
            let cable = &c.cables[*cable];
            let obstacle = &c.obstacles[*body].body;
            let planes = match fat.directions.get(*body) {
                Some(known) => {
                    rounded_shadow(obstacle, &cable.outlet, *gap, known.get_or_init(|| directions(obstacle)))?
                }
                None => rounded_shadow(obstacle, &cable.outlet, *gap, &directions(obstacle))?,
            };
            Some(planes.iter().map(|h| h.moved(&-cable.arm)).collect())
        }
        Constraint::CablePlatform { cable, body, demand: Demand::Apart { gap } } if *gap > 0.0 => {
            let cable = &c.cables[*cable];
            let part = &c.platform[*body];
            let planes = rounded_shadow(part, &Point::from(cable.arm), *gap, &directions(part))?;
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
/// `directions` are those of the body.
fn rounded_shadow(body: &Polytope, apex: &Point, gap: f64, directions: &[Vector]) -> Option<Vec<HalfSpace>> {
    let around = |n: Vector| HalfSpace::around(body.vertices(), n).widened(gap);
    let exact = shadow(body, apex).filter(|_| body.has_volume())?;
    let facing = directions.iter().copied().map(around).filter(|plane| plane.height(apex) > 0.0);
    let axis = (nalgebra::Point::from(
        body.vertices().iter().map(|v| v.coords).sum::<Vector>() / body.vertices().len() as f64,
    ) - apex)
        .try_normalize(PARALLEL)?;
    let sides: Vec<Vector> =
        exact.half_spaces.iter().filter(|h| h.height(apex).abs() <= ON_SURFACE).map(|h| h.normal).collect();
    let across = sides.first()?.cross(&axis).try_normalize(PARALLEL)?;
    let up = axis.cross(&across);
    let angles = sides.iter().map(|n| f64::atan2(n.dot(&up), n.dot(&across)));
    let mut by_angle: Vec<(f64, Vector)> = angles.zip(sides.iter().copied()).collect();
    by_angle.sort_by(|a, b| a.0.total_cmp(&b.0));
    let sides: Vec<Vector> = by_angle.into_iter().map(|(_, n)| n).collect();
    let corners = (0..sides.len()).flat_map(|k| between(&sides[k], &sides[(k + 1) % sides.len()])).collect::<Vec<_>>();
    let cone: Option<Vec<HalfSpace>> =
        sides.iter().chain(&corners).map(|n| tangent(body, apex, n, &axis, gap)).collect();
    Some(facing.chain(cone?).collect())
}

/// The plane through a point, turned from the normal `n` away from the axis just so far that it keeps `gap` from a body.
fn tangent(body: &Polytope, apex: &Point, n: &Vector, axis: &Vector, gap: f64) -> Option<HalfSpace> {
    let forward = (axis - n * n.dot(axis)).try_normalize(PARALLEL)?;
    // For normals n cos φ - forward sin φ a corner is at A cos φ - C sin φ, which must be at most -gap: for a corner at the
    // distance R in this plane φ is at least asin(gap / R) + atan2(A, C). Of angles between -π/2 and π/2 the sines have the
    // same order.
    let (mut sine, mut cosine) = (0.0, 1.0);
    for corner in body.vertices() {
        let (a, c) = (n.dot(&(corner - apex)), forward.dot(&(corner - apex)));
        let reach = (a * a + c * c).sqrt();
        if !(reach > gap) {
            return None;
        }
        let (s, t) = (gap / reach, ((reach - gap) * (reach + gap)).sqrt() / reach);
        let (sin, cos) = ((s * c + t * a) / reach, (t * c - s * a) / reach);
        if !(cos > 0.0) {
            // Beyond a right angle to one side there is no such plane, to the other any will do.
            if s.asin() + f64::atan2(a, c) > 0.0 {
                return None;
            }
        } else if sin > sine {
            (sine, cosine) = (sin, cos);
        }
    }
    Some(HalfSpace::through(apex, (n * cosine - forward * sine).normalize()))
}
