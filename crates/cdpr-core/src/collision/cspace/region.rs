//! From constraints to convex polyhedra of positions.
//!
//! At fixed orientation every constraint forbids a set of positions p, and all but distances are convex polyhedra:
//! platform against obstacle O ⊕ (-P), cable against obstacle the shadow of O seen from the outlet, moved by minus the arm,
//! cable against a platform part the mirrored shadow of that part seen from the attachment, cables that end on a body a
//! cone. A [`Region`] brackets that set between an outer polyhedron, outside of which a position is certainly free of the
//! constraint, and an inner one, inside of which it certainly breaks it. Between them lie rounding and contact, and, with
//! a clearance, the rounded corners: there the gjk engine decides.

use crate::collision::constraint::{Constraint, Constraints, Demand};
use crate::geometry::{HalfSpace, Point, Polytope, Shadow, Vector, shadow};
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
    let mut places: Vec<Point> = (0..SAMPLES.pow(3)).map(place).collect();
    let mut sorted = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let ruled_out = |h: &HalfSpace| places.iter().filter(|p| h.height(p) >= 0.0).count();
        let best = (0..left.len()).max_by_key(|&k| ruled_out(&left[k])).expect("some are left");
        places.retain(|p| left[best].height(p) < 0.0);
        sorted.push(left.swap_remove(best));
    }
    sorted
}

/// Places along each axis at which planes are tried.
const SAMPLES: usize = 4;

/// What one constraint forbids, or a convex piece of it, bracketed.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Index of the constraint in the list.
    pub constraint: usize,
    /// Outside of these, no position breaks the constraint by way of this piece. None: nothing is known.
    pub outer: Option<Vec<HalfSpace>>,
    /// Inside of this, every position breaks the constraint.
    pub inner: Inner,
}

impl Region {
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

/// An open convex polyhedron of positions that a constraint forbids, without any clearance.
struct Forbidden {
    half_spaces: Vec<HalfSpace>,
    /// Sine of the angle by which rounding may have turned a plane that passes through the apex of a shadow.
    tilt: f64,
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
pub fn regions(constraints: &Constraints, index: usize, scale: &Scale) -> Vec<Region> {
    let (min, max) = constraints.position_box();
    let mut regions = exact_regions(constraints, index, scale);
    for region in &mut regions {
        region.outer = region.outer.take().map(|planes| sorted(planes, &min, &max));
        if let Inner::Own(planes) = &mut region.inner {
            *planes = sorted(std::mem::take(planes), &min, &max);
        }
    }
    regions
}

fn exact_regions(constraints: &Constraints, index: usize, scale: &Scale) -> Vec<Region> {
    let bracket =
        |gap: f64, touch: f64, set: &dyn Fn(f64) -> Option<Forbidden>| vec![bracketed(index, gap, touch, scale, set)];
    let c = constraints;
    match &c.list[index] {
        Constraint::Workspace { .. } => Vec::new(),
        Constraint::CableLength { cable, min, max } => cable_length(index, &c.cables[*cable], *min, *max, scale),
        Constraint::CableCable(pair) => {
            let piece = |outer: Option<Vec<HalfSpace>>| Region { constraint: index, outer, inner: Inner::Unknown };
            match pair.wedges() {
                Some(wedges) => wedges.map(|w| piece(Some(widened(&w, scale.rounding)))).into(),
                None => vec![piece(None)],
            }
        }
        Constraint::PlatformObstacle { part, body, gap } => {
            let (part, obstacle) = (&c.platform[*part], &c.obstacles[*body]);
            let touch = obstacle.seam.unwrap_or(TOUCH_DEPTH);
            bracket(*gap, touch, &|gap| platform_obstacle(part, &obstacle.body, gap))
        }
        Constraint::CableObstacle { cable, body, demand } => {
            let (cable, obstacle) = (&c.cables[*cable], &c.obstacles[*body].body);
            let moved = |half_space: &HalfSpace| half_space.moved(&-cable.arm);
            match demand {
                Demand::Leave { normals } => {
                    let cone: Vec<_> = normals.iter().map(|n| moved(&HalfSpace::through(&cable.outlet, *n))).collect();
                    bracket(0.0, TOUCH_DEPTH, &|_| Some(Forbidden { half_spaces: cone.clone(), tilt: 0.0 }))
                }
                Demand::Apart { .. } | Demand::Outside { .. } => {
                    let (gap, touch) = gap_and_touch(demand);
                    bracket(gap, touch, &|gap| shadow_of(obstacle, &cable.outlet, gap, moved))
                }
            }
        }
        Constraint::CablePlatform { cable, body, demand } => {
            let (cable, part) = (&c.cables[*cable], &c.platform[*body]);
            let mirrored = |half_space: &HalfSpace| half_space.reflected(&cable.outlet.coords);
            let attachment = Point::from(cable.arm);
            match demand {
                Demand::Leave { normals } => {
                    let at = |n: &Vector| mirrored(&HalfSpace::through(&attachment, *n));
                    let cone: Vec<_> = normals.iter().map(at).collect();
                    bracket(0.0, TOUCH_DEPTH, &|_| Some(Forbidden { half_spaces: cone.clone(), tilt: 0.0 }))
                }
                Demand::Apart { .. } | Demand::Outside { .. } => {
                    let (gap, touch) = gap_and_touch(demand);
                    bracket(gap, touch, &|gap| shadow_of(part, &attachment, gap, mirrored))
                }
            }
        }
    }
}

fn gap_and_touch(demand: &Demand) -> (f64, f64) {
    match demand {
        Demand::Apart { gap } => (*gap, TOUCH_DEPTH),
        Demand::Outside { touch } => (0.0, *touch),
        Demand::Leave { .. } => (0.0, TOUCH_DEPTH),
    }
}

/// The region of a constraint with this gap, where `set(g)` is a superset of the positions nearer than g, exact for 0.
fn bracketed(constraint: usize, gap: f64, touch: f64, scale: &Scale, set: &dyn Fn(f64) -> Option<Forbidden>) -> Region {
    let error = |f: &Forbidden| f.tilt * scale.reach + scale.rounding;
    let grown = |f: &Forbidden| widened(&f.half_spaces, error(f));
    let exact = set(0.0);
    let Some(certain) = exact.as_ref().filter(|f| error(f) <= SUPERSET) else {
        let outer = set(gap.max(FATTENED));
        return Region { constraint, outer: outer.as_ref().map(grown), inner: Inner::Unknown };
    };
    if gap > 0.0 {
        let inner = Inner::Own(widened(&certain.half_spaces, -touch - error(certain)));
        return Region { constraint, outer: set(gap).as_ref().map(grown), inner };
    }
    Region { constraint, outer: Some(grown(certain)), inner: Inner::Shrunk(-touch - 2.0 * error(certain)) }
}

fn widened(half_spaces: &[HalfSpace], by: f64) -> Vec<HalfSpace> {
    half_spaces.iter().map(|h| h.widened(by)).collect()
}

/// Positions where a part of the platform meets a body: O ⊕ (-P), fattened.
fn platform_obstacle(part: &Polytope, body: &Polytope, gap: f64) -> Option<Forbidden> {
    let differences = body.vertices().iter().flat_map(|o| part.vertices().iter().map(move |p| o - p.coords));
    let sum = Polytope::hull_of(&fattened(differences, gap)).ok().filter(Polytope::has_volume)?;
    Some(Forbidden { half_spaces: sum.half_spaces(), tilt: 0.0 })
}

/// The shadow of a body, fattened, in other coordinates; none if it has none that planes describe.
fn shadow_of(body: &Polytope, apex: &Point, gap: f64, placed: impl Fn(&HalfSpace) -> HalfSpace) -> Option<Forbidden> {
    let Shadow { half_spaces, tilt } = if gap > 0.0 {
        shadow(&Polytope::hull_of(&fattened(body.vertices().iter().copied(), gap)).ok()?, apex)?
    } else if body.dimension() >= 2 {
        shadow(body, apex)?
    } else {
        return None;
    };
    Some(Forbidden { half_spaces: half_spaces.iter().map(placed).collect(), tilt })
}

/// Points whose hull holds everything nearer than `gap` to the hull of `points`: their sum with a cube around the ball.
fn fattened(points: impl Iterator<Item = Point>, gap: f64) -> Vec<Point> {
    if gap == 0.0 {
        return points.collect();
    }
    let signs: [Vector; 8] =
        std::array::from_fn(|k| Vector::from_fn(|axis, _| if k >> axis & 1 == 1 { gap } else { -gap }));
    points.flat_map(|p| signs.map(|sign| p + sign)).collect()
}

/// Too short: inside a ball, which a cube holds. Too long: outside of another, which no polyhedron does.
fn cable_length(
    constraint: usize,
    cable: &crate::collision::constraint::CableAt,
    min: f64,
    max: f64,
    scale: &Scale,
) -> Vec<Region> {
    let center = cable.outlet - cable.arm;
    let faces = (0..6).map(|k| Vector::ith(k / 2, if k % 2 == 0 { 1.0 } else { -1.0 }));
    let cube = faces.map(|n| HalfSpace::through(&center, n).widened(min.max(MIN_CABLE_LENGTH) + scale.rounding));
    let short = Region { constraint, outer: Some(cube.collect()), inner: Inner::Unknown };
    let long = max.is_finite().then_some(Region { constraint, outer: None, inner: Inner::Unknown });
    std::iter::once(short).chain(long).collect()
}
