//! The positions that a scene forbids, from the scene alone: for each pair of bodies, convex sets of positions.

use cdpr_core::error::Error;
use cdpr_core::geometry::{Point, Polytope, Vector};
use cdpr_core::model::{Member, Scene};

use crate::cone::Cone;
use crate::exact::{Exact, Exact3, dot, exact, exact3, minus, plus, times};
use crate::hanging::{Hanging, Near, with_copies};
use crate::nearest::{between, distance, nearest, squared_distance};
use crate::polyhedron::Place;

/// A point this close to a body lies on its surface, and a body this thin is flat, m.
const ON_SURFACE: f64 = 1e-7;
/// A corner this far above a plane through three others still lies in it, m.
const COPLANAR: f64 = 1e-9;
/// A gap that is less than required by no more than this is contact, m.
pub const TOUCHING: f64 = 1e-9;
/// The witnesses of contact may be this far apart, m.
pub const ROUNDING: f64 = 1e-12;
/// Ends of cables this close are one point, m, as in the definition of a scene: such a pair of cables touches by
/// construction and forbids nothing, and cables that all end there exert no moments. A larger value would prove less, a
/// smaller one would call positions forbidden that are free. The checker in Python has the same value.
pub const SAME_END: f64 = 1e-7;

/// A point in the world that moves with the platform (its place if the platform's origin is at zero) or stays.
#[derive(Debug, Clone)]
pub struct Spot {
    at: Vector,
    moves: bool,
}

impl Spot {
    fn at(&self, position: &Vector) -> Vector {
        if self.moves { self.at + position } else { self.at }
    }
}

/// A set of forbidden positions of the platform.
#[derive(Debug)]
pub enum ForbiddenSet {
    /// Two convex hulls are closer than a distance. The set is convex unless both bodies are cables.
    Close {
        /// Corners of both hulls.
        hulls: [Vec<Spot>; 2],
        /// Required distance, m.
        required: Exact,
    },
    /// A cable that ends on a body enters it: the direction from that end to the other is below all of the body's faces
    /// that contain the end. The set is a cone, or wider if the cable can be lower than its chord.
    Enters {
        /// The end of the cable on the body.
        end: Spot,
        /// The other end of the cable.
        tip: Spot,
        /// The directions into the body.
        cone: Cone,
    },
}

impl ForbiddenSet {
    /// Whether at a position the gap is at most `margin` more than required. The answer is exact both ways: where contact at an
    /// end is excused, a false no would prove too much.
    pub fn is_near(&self, place: &Place, margin: &Exact) -> bool {
        let position = place.to_f64();
        match self {
            Self::Close { hulls, required } => {
                let weights = self.nearest_at(&position);
                let reach = (required + margin) * &place.scale;
                if reach.sign().is_lt() {
                    return false;
                }
                if self.is_near_at(&weights, place, margin) {
                    return true;
                }
                let floats = hulls.each_ref().map(|hull| hull.iter().map(|s| s.at(&position)).collect::<Vec<_>>());
                let across = between([&floats[0], &floats[1]], &weights);
                let [a, b] = hulls.each_ref().map(|hull| hull.iter().map(|s| moved(s, place)).collect::<Vec<_>>());
                if finite(&across).is_some_and(|across| are_apart(&across, [&a, &b], &reach)) {
                    return false;
                }
                let (square, whole) = squared_distance(&a, &b);
                let reach = reach * whole;
                square <= &reach * &reach
            }
            Self::Enters { end, tip, cone } => {
                let direction = minus(&moved(tip, place), &moved(end, place)); // times place.scale
                cone.is_near(&direction, &(tip.at(&position) - end.at(&position)), place, margin)
            }
        }
    }

    /// The margin for a set that both start and goal touch: the platform may touch everywhere what it touches at both
    /// ends, such as a floor that it slides on. A gap that is a little less than required is contact.
    pub fn contact(&self) -> Exact {
        match self {
            Self::Close { required, .. } if required.sign().is_gt() => exact(-TOUCHING),
            _ => exact(ROUNDING),
        }
    }

    /// Weights of the corners in the nearest points of the two hulls; none for cones.
    pub fn nearest_at(&self, position: &Vector) -> [Vec<f64>; 2] {
        let Self::Close { hulls, .. } = self else { return Default::default() };
        let at = |hull: &[Spot]| hull.iter().map(|spot| spot.at(position)).collect::<Vec<_>>();
        nearest(&at(&hulls[0]), &at(&hulls[1]))
    }

    /// Whether two points of the hulls, given by the weights of the corners, are at most `margin` farther apart than
    /// required.
    pub fn is_near_at(&self, weights: &[Vec<f64>; 2], place: &Place, margin: &Exact) -> bool {
        let Self::Close { hulls, required } = self else { return false };
        let [Some((a, all_a)), Some((b, all_b))] = [0, 1].map(|k| weighted(&hulls[k], &weights[k], place)) else {
            return false;
        };
        // The points are a / all_a and b / all_b.
        let all = &all_a * &all_b * &place.scale;
        let gap = minus(&times(&all_b, &a), &times(&all_a, &b));
        let reach = &all * &(required + margin);
        all.sign().is_gt() && reach.sign().is_ge() && dot(&gap, &gap) <= &reach * &reach
    }
}

/// The sum of weight · corner, times the place's scale, and the sum of the weights.
fn weighted(hull: &[Spot], weights: &[f64], place: &Place) -> Option<(Exact3, Exact)> {
    let mut sums = (exact3(&Vector::zeros()), exact(0.0));
    for (spot, weight) in hull.iter().zip(weights).filter(|(_, weight)| **weight != 0.0) {
        if !(weight.is_finite() && *weight >= 0.0) {
            return None;
        }
        let weight = exact(*weight);
        sums.0 = plus(&sums.0, &times(&weight, &moved(spot, place)));
        sums.1 = sums.1 + weight;
    }
    Some(sums)
}

/// Where a spot is, times the place's scale.
fn moved(spot: &Spot, place: &Place) -> Exact3 {
    let own = times(&place.scale, &exact3(&spot.at));
    if spot.moves { plus(&own, &place.at) } else { own }
}

fn finite(v: &Vector) -> Option<Exact3> {
    v.iter().all(|x| x.is_finite()).then(|| exact3(v))
}

/// Whether two hulls are farther apart than a distance, since two planes across this direction are.
fn are_apart(across: &Exact3, [a, b]: [&[Exact3]; 2], distance: &Exact) -> bool {
    let least = |points: &[Exact3], sign: f64| {
        let heights = points.iter().map(|p| dot(p, across) * exact(sign));
        heights.reduce(|x, y| if y < x { y } else { x }).expect("a body has corners")
    };
    let apart = least(a, 1.0) + least(b, -1.0);
    apart.sign().is_gt() && &apart * &apart > distance * distance * dot(across, across)
}

/// Outward unit normals of the faces of a hull that contain a point, `None` if the hull is flat. Every plane through
/// three corners is a face if no corner lies above it.
fn faces_at(point: &Vector, corners: &[Vector]) -> Option<Vec<Vector>> {
    let mut faces: Vec<Vector> = Vec::new();
    for (i, a) in corners.iter().enumerate() {
        for (j, b) in corners.iter().enumerate().skip(i + 1) {
            for c in &corners[j + 1..] {
                let normal = (b - a).cross(&(c - a));
                let Some(normal) = normal.try_normalize(1e-9 * (b - a).norm() * (c - a).norm()) else { continue };
                if !(normal.dot(&(point - a)).abs() <= ON_SURFACE) {
                    continue;
                }
                let heights = || corners.iter().map(|corner| normal.dot(&(corner - a)));
                let (low, high) = (heights().fold(0.0, f64::min), heights().fold(0.0, f64::max));
                if high - low <= ON_SURFACE {
                    return None;
                }
                let outward = if high <= COPLANAR { normal } else { -normal };
                if (high <= COPLANAR || low >= -COPLANAR) && !faces.contains(&outward) {
                    faces.push(outward);
                }
            }
        }
    }
    (!faces.is_empty()).then_some(faces)
}

/// The bodies of a scene in the world, at its orientation, with the platform's origin at zero.
pub struct Bodies<'a> {
    scene: &'a Scene,
    /// Corners of each part of the platform.
    pub platform: Vec<Vec<Vector>>,
    /// From the platform's origin to the attachment of each cable.
    pub arms: Vec<Vector>,
}

impl<'a> Bodies<'a> {
    /// The bodies of a scene.
    pub fn of(scene: &'a Scene) -> Self {
        let turned = |p: &Point| scene.orientation() * p.coords;
        let corners = |part: &Polytope| part.vertices().iter().map(turned).collect();
        Bodies {
            scene,
            platform: scene.robot().parts().iter().map(corners).collect(),
            arms: scene.robot().cables().iter().map(|cable| turned(&cable.attachment)).collect(),
        }
    }

    /// The member with this name.
    pub fn member(&self, name: &str) -> Result<Member, Error> {
        let obstacles = (0..self.scene.obstacles().len()).map(Member::Obstacle);
        let mut all = (0..self.arms.len()).map(Member::Cable).chain([Member::Platform]).chain(obstacles);
        all.find(|member| self.scene.member_name(*member) == name).ok_or_else(|| {
            let problem = format!("found \"{name}\", expected the name of a cable or an obstacle, or \"platform\"");
            Error::invalid("", problem)
        })
    }

    /// The sets of positions that a pair of members forbids, each by two convex bodies, one of either member.
    pub fn forbidden(&self, [a, b]: [Member; 2]) -> Result<Vec<ForbiddenSet>, Error> {
        let (first, second) = (a.min(b), a.max(b)); // cables, then the platform, then obstacles
        if a == b || self.scene.pairs().ignores(a, b) {
            return Ok(Vec::new());
        }
        match (first, second) {
            (Member::Platform, Member::Obstacle(j)) => Ok(self.platform_obstacle(j)),
            (Member::Cable(i), Member::Obstacle(j)) => Ok(self.cable_obstacle(i, j)),
            (Member::Cable(i), Member::Platform) => Ok(self.cable_platform(i)),
            (Member::Cable(i), Member::Cable(j)) => Ok(self.cable_cable(i, j)),
            _ => Err(Error::invalid("", "found two obstacles, expected at least one member of the robot")),
        }
    }

    fn platform_obstacle(&self, j: usize) -> Vec<ForbiddenSet> {
        let clearance = self.scene.pairs().clearance(Member::Platform, Member::Obstacle(j));
        let pairs = self.platform.iter().flat_map(|part| self.obstacle(j).into_iter().map(move |other| (part, other)));
        let close = |(part, other): (&Vec<Vector>, Vec<Vector>)| ForbiddenSet::Close {
            hulls: [spots(part, true), spots(&other, false)],
            required: exact(clearance),
        };
        pairs.map(close).collect()
    }

    /// A part of an obstacle that carries the outlet is seen from the outlet alone, however far from there the cable can leave the
    /// frame.
    fn cable_obstacle(&self, i: usize, j: usize) -> Vec<ForbiddenSet> {
        let [outlet, attachment] = self.cable(i);
        let hanging = Hanging::of(self.scene, i);
        let clearance = self.scene.pairs().clearance(Member::Cable(i), Member::Obstacle(j));
        let parts = self.obstacle(j);
        let far: Vec<f64> = parts.iter().map(|part| distance(&[outlet.at], part)).collect();
        let mounted = far.iter().any(|far| *far <= ON_SURFACE);
        let of_part = |(part, far): (Vec<Vector>, f64)| {
            if far <= ON_SURFACE {
                let lower = [Vector::zeros(), hanging.leaving()].map(|by| exact3(&by));
                let cone = Cone::below(faces_at(&outlet.at, &part)?, &lower);
                return Some(ForbiddenSet::Enters { end: outlet.clone(), tip: attachment.clone(), cone });
            }
            let attainable = if mounted { far } else { f64::INFINITY };
            let required = kept(clearance, &[self.radius(i)], attainable);
            let Near { exits, lowered } = hanging.near(&part, clearance + self.radius(i), mounted.then_some(outlet.at));
            let ends = spots(&with_copies(&[attachment.at], &lowered), true);
            let cable = spots(&exits, false).into_iter().chain(ends).collect();
            Some(ForbiddenSet::Close { hulls: [cable, spots(&part, false)], required })
        };
        parts.into_iter().zip(far).filter_map(of_part).collect()
    }

    fn cable_platform(&self, i: usize) -> Vec<ForbiddenSet> {
        let [outlet, attachment] = self.cable(i);
        let exits = Hanging::of(self.scene, i).lowered_exits();
        let clearance = self.scene.pairs().clearance(Member::Cable(i), Member::Platform);
        let of_part = |part: &Vec<Vector>| {
            let far = distance(&[attachment.at], part);
            if far <= ON_SURFACE {
                let lower: Vec<Exact3> = exits.iter().map(|exit| minus(&exact3(exit), &exact3(&outlet.at))).collect();
                let cone = Cone::below(faces_at(&attachment.at, part)?, &lower);
                return Some(ForbiddenSet::Enters { end: attachment.clone(), tip: outlet.clone(), cone });
            }
            let required = kept(clearance, &[self.radius(i)], far);
            let cable = spots(&exits, false).into_iter().chain([attachment.clone()]).collect();
            Some(ForbiddenSet::Close { hulls: [cable, spots(part, true)], required })
        };
        self.platform.iter().filter_map(of_part).collect()
    }

    /// Straight cables from wherever they can leave the frame are among the shapes that must keep clear of each other. Cables that share
    /// an end forbid nothing. From one cable to the other, their ends are apart by two fixed vectors; so straight cables from the outlets
    /// come as near as the segment between these is to zero, wherever the platform is.
    fn cable_cable(&self, i: usize, j: usize) -> Vec<ForbiddenSet> {
        let (one, other) = (self.cable(i), self.cable(j));
        if (0..2).any(|end| (one[end].at - other[end].at).norm() <= SAME_END) {
            return Vec::new();
        }
        let clearance = self.scene.pairs().clearance(Member::Cable(i), Member::Cable(j));
        let attainable = distance(&[Vector::zeros()], &[0, 1].map(|end| other[end].at - one[end].at));
        let required = kept(clearance, &[self.radius(i), self.radius(j)], attainable);
        let shapes = |k: usize, [_, attachment]: [Spot; 2]| {
            spots(Hanging::of(self.scene, k).exits(), false).into_iter().chain([attachment]).collect()
        };
        vec![ForbiddenSet::Close { hulls: [shapes(i, one), shapes(j, other)], required }]
    }

    fn cable(&self, i: usize) -> [Spot; 2] {
        let outlet = self.scene.robot().cables()[i].outlet.coords;
        [Spot { at: outlet, moves: false }, Spot { at: self.arms[i], moves: true }]
    }

    fn radius(&self, i: usize) -> f64 {
        0.5 * self.scene.robot().cables()[i].diameter
    }

    fn obstacle(&self, j: usize) -> Vec<Vec<Vector>> {
        let corners = |part: &Polytope| part.vertices().iter().map(|v| v.coords).collect();
        self.scene.obstacles()[j].parts.iter().map(corners).collect()
    }
}

fn spots(corners: &[Vector], moves: bool) -> Vec<Spot> {
    corners.iter().map(|at| Spot { at: *at, moves }).collect()
}

/// The distance to keep between two axes or bodies: clearance plus radii; if that is not attainable, the radii alone, and if that
/// is not either, none. By the definition of a scene a distance is attainable up to a shortfall of 0.5e-9 m. Here the shortfall
/// may be no more than rounding errors, which proves less.
fn kept(clearance: f64, radii: &[f64], attainable: f64) -> Exact {
    let thick: Exact = radii.iter().map(|radius| exact(*radius)).sum();
    let mut choices = [exact(clearance) + &thick, thick].into_iter();
    choices.find(|distance| distance.to_f64() <= attainable + ROUNDING).unwrap_or(exact(0.0))
}
