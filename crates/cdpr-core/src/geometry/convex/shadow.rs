//! The obstacle shadow: the points where a cable from a fixed outlet cannot end, because it would pass through a body.
//!
//! Source: the paper, section 3.1 and Figure 3, which draws the region; this module computes it.
//!
//! Seen from a convex set E instead of a point, the shadow is still one convex polyhedron, K ⊕ cone(K ⊕ -E): with weights α and β
//! and μ = α μ₁ + β μ₂, the point α ((1 + μ₁) k₁ - μ₁ e₁) + β ((1 + μ₂) k₂ - μ₂ e₂) is (1 + μ) k - μ e with k between k₁ and k₂
//! and e between e₁ and e₂. Its facets are those of K that face all of E, and planes between K and E that touch both.

use super::half_space::HalfSpace;
use super::polytope::{Aabb, Facet, farthest};
use crate::geometry::{Point, Polytope, Vector};
use crate::tolerances::{GRAZING, ON_SURFACE, PARALLEL, ROUNDING};

/// A shadow as an intersection of open half-spaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Shadow {
    /// The planes through the apex and the silhouette, then the facets that face the apex.
    pub half_spaces: Vec<HalfSpace>,
    /// Sine of the largest angle by which rounding lets the body protrude from a silhouette plane.
    pub tilt: f64,
}

/// The points x for which the segment from `apex` to x meets the interior of a body: the body and everything behind it,
/// `K ⊕ cone(K - apex)`. `None` if no facet faces the apex (which is inside the body, or in the plane of a flat one).
///
/// A facet whose plane contains the apex does not face it: the planes through its other edges are equivalent.
///
/// # Example
/// ```
/// use cdpr_core::{Point, geometry::{Polytope, shadow}};
/// let cube = Polytope::cuboid([2.0; 3])?;
/// let shadow = shadow(&cube, &Point::new(0.0, 0.0, 5.0)).unwrap();
/// let hidden = |x, y, z| shadow.half_spaces.iter().all(|h| h.height(&Point::new(x, y, z)) < 0.0);
/// assert!(hidden(0.0, 0.0, -9.0) && !hidden(0.0, 0.0, 2.0));
/// assert!(hidden(1.4, 0.0, -1.0) && !hidden(1.6, 0.0, -1.0)); // the upper rim is at 4 m, the ray passes 1.5 at 6 m
/// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
/// ```
pub fn shadow(body: &Polytope, apex: &Point) -> Option<Shadow> {
    let vertices = body.vertices();
    let mut half_spaces: Vec<HalfSpace> = (silhouette(body, apex)?.iter())
        .filter_map(|&[i, j]| through_edge(apex, &vertices[i], &vertices[j]))
        .map(|normal| HalfSpace::through(apex, normal))
        .collect();
    let rays: Vec<Vector> = vertices.iter().map(|v| (v - apex).normalize()).collect();
    let tilts = half_spaces.iter().flat_map(|h| rays.iter().map(|ray| h.normal.dot(ray)));
    let tilt = tilts.fold(0.0, f64::max);
    let facing = body.facets().iter().filter(|f| f.height(apex) > GRAZING);
    half_spaces.extend(facing.map(|f| HalfSpace { normal: f.normal, offset: f.offset }));
    Some(Shadow { half_spaces, tilt })
}

/// The directions from a point or a convex set to a body, as a convex cone.
#[derive(Debug, Clone, PartialEq)]
pub struct Cone {
    /// Outward unit normals of its sides.
    normals: Vec<Vector>,
    /// Unit vectors along its edges.
    rays: Vec<Vector>,
    /// Sine of the largest angle by which rounding lets other directions protrude from a side.
    tilt: f64,
}

impl Cone {
    /// The cone of the directions from `apex` to a body; `None` if no facet faces the apex.
    pub fn around(body: &Polytope, apex: &Point) -> Option<Self> {
        let vertices = body.vertices();
        let silhouette = silhouette(body, apex)?;
        let normals = silhouette.iter().filter_map(|&[i, j]| through_edge(apex, &vertices[i], &vertices[j])).collect();
        let rays = silhouette.iter().map(|&[i, _]| (vertices[i] - apex).normalize()).collect();
        Some(Cone { normals, rays, tilt: 0.0 })
    }

    /// The cone of the directions from the hull of `sources` to a body; `None` if no facet of the difference of both faces the
    /// origin. With the body [added](Self::added_to), it is the shadow that the body casts seen from all of the hull.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::{Cone, Polytope}};
    /// let cube = Polytope::cuboid([2.0; 3])?;
    /// let above = [Point::new(-0.5, 0.0, 5.0), Point::new(0.5, 0.0, 5.0)];
    /// let shadow = Cone::from(&cube, &above).unwrap().added_to(&cube, &[]);
    /// let hidden = |x, y, z| shadow.half_spaces.iter().all(|h| h.height(&Point::new(x, y, z)) < 0.0);
    /// assert!(hidden(1.7, 0.0, -1.0) && !hidden(1.8, 0.0, -1.0)); // from (-0.5, 5) over the rim (1, 1), 1.75 at -1
    /// assert!(hidden(0.0, 1.4, -1.0) && !hidden(0.0, 1.6, -1.0)); // across, the set is a point
    /// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
    /// ```
    pub fn from(body: &Polytope, sources: &[Point]) -> Option<Self> {
        match sources {
            [apex] => Cone::around(body, apex),
            _ => Cone::across(body, sources).or_else(|| {
                let opposite: Vec<Point> = sources.iter().map(|source| -*source).collect();
                Cone::around(&body.sum(&Polytope::hull_of(&opposite).ok()?).ok()?, &Point::origin())
            }),
        }
    }

    /// The cone of the directions from `sources` to a body, from its outermost directions: between each two, one that stands out
    /// from their plane is added. `None` if no facet of the body is far enough in front of all sources.
    fn across(body: &Polytope, sources: &[Point]) -> Option<Self> {
        let corners = body.vertices();
        let difference = |along: &Vector| farthest(corners, along) - farthest(sources, &-along);
        let forward = |f: &Facet| -f.normal;
        let apart = |along: Vector| (along.dot(&difference(&-along)), along);
        let (least, along) = body.facets().iter().map(forward).map(apart).max_by(|a, b| a.0.total_cmp(&b.0))?;
        let room = Aabb::around(sources).around_both(body.aabb());
        let rounding = ROUNDING * (room.min.coords.norm() + room.max.coords.norm());
        if !(least > ACROSS * (room.max - room.min).norm()) {
            return None;
        }
        // On a plane across `along`, the direction that is farthest along `normal`, at least as far as a known one.
        let outermost = |normal: &Vector, known: Vector| {
            let mut found = known;
            loop {
                let turned = normal - along * (normal.dot(&found) / along.dot(&found));
                let next = difference(&turned);
                if !(turned.dot(&next) > rounding * turned.norm()) {
                    return found;
                }
                found = next;
            }
        };
        let origin = Point::origin();
        let side = |from: &Vector, to: &Vector| through_edge(&origin, &Point::from(*to), &Point::from(*from));
        let across = along.cross(&Vector::ith(along.iamin(), 1.0)).normalize();
        let mut ring = [across, -across].map(|normal| outermost(&normal, difference(&normal))).to_vec();
        let mut k = 0;
        while k < ring.len() && ring.len() <= corners.len() * sources.len() {
            let (from, to) = (ring[k], ring[(k + 1) % ring.len()]);
            match side(&from, &to).map(|normal| outermost(&normal, from)).filter(|found| *found != from) {
                Some(found) => ring.insert(k + 1, found),
                None => k += 1,
            }
        }
        // Of directions in one plane, only the outer two.
        let mut k = 0;
        while k < ring.len() && ring.len() > 3 {
            let beside = |by: usize| &ring[(k + by) % ring.len()];
            let stands_out = |normal: Vector| normal.dot(&ring[k]) > rounding;
            if side(beside(ring.len() - 1), beside(1)).is_none_or(stands_out) {
                k += 1;
            } else {
                ring.remove(k);
            }
        }
        let sides: Vec<Vector> = (0..ring.len()).filter_map(|k| side(&ring[k], &ring[(k + 1) % ring.len()])).collect();
        let protrudes = |normal: &Vector| normal.dot(&difference(normal)) / least;
        let tilt = sides.iter().map(protrudes).fold(0.0, f64::max);
        (sides.len() >= 3).then(|| Cone { normals: sides, rays: ring.iter().map(Vector::normalize).collect(), tilt })
    }

    /// The sum of a body and this cone, where the body is the one that the cone is around, or its sum with a set whose edges
    /// have the directions `edges`. Each facet is one of the body, a side of the cone moved to the body, or spanned by an edge of
    /// the set and one of the cone: a plane that an edge of the cone's body spans touches both that body and the sources, so it
    /// is a side of the cone.
    pub fn added_to(&self, body: &Polytope, edges: &[Vector]) -> Shadow {
        let vertices = body.vertices();
        let around = |n: &Vector| HalfSpace::around(vertices, *n);
        let is_side = |n: &Vector| self.rays.iter().all(|ray| n.dot(ray) <= PARALLEL);
        let mut half_spaces: Vec<HalfSpace> = self.normals.iter().map(around).collect();
        for along in edges {
            let spanned = self.rays.iter().filter_map(|ray| self.side_along(&along.cross(ray)));
            for normal in spanned.flat_map(|n| [n, -n]).filter(is_side) {
                let plane = around(&normal);
                let touching = vertices.iter().filter(|v| plane.height(v) >= -ON_SURFACE).count();
                let known = |h: &HalfSpace| (h.normal - normal).norm() <= PARALLEL;
                if touching > 1 && !half_spaces.iter().any(known) {
                    half_spaces.push(plane);
                }
            }
        }
        let facing = body.facets().iter().filter(|f| is_side(&f.normal));
        half_spaces.extend(facing.map(|f| HalfSpace { normal: f.normal, offset: f.offset }));
        let rises = |h: &HalfSpace| self.rays.iter().map(|ray| h.normal.dot(ray)).fold(f64::NEG_INFINITY, f64::max);
        let tilt = half_spaces.iter().map(rises).fold(0.0, f64::max) + self.tilt;
        Shadow { half_spaces, tilt }
    }

    /// A normal as a unit vector; `None` if it is too short to have a direction, or the cone clearly lies on both sides of its plane.
    fn side_along(&self, normal: &Vector) -> Option<Vector> {
        let (mut above, mut below) = (false, false);
        for ray in &self.rays {
            let height = normal.dot(ray);
            above |= height > PARALLEL;
            below |= height < -PARALLEL;
            if above && below {
                return None;
            }
        }
        normal.try_normalize(PARALLEL)
    }
}

/// How far a body must be in front of all sources, as a share of the extent of both, for [`Cone::across`] to be exact.
const ACROSS: f64 = 1e-3;

/// The directed edges of a body around the facets that face a point; `None` if no facet does.
fn silhouette(body: &Polytope, apex: &Point) -> Option<Vec<[usize; 2]>> {
    let facing = body.facets().iter().filter(|f| f.height(apex) > GRAZING);
    let edges: Vec<[usize; 2]> = facing.flat_map(|f| f.edges()).collect();
    let outer = edges.iter().filter(|[i, j]| !edges.contains(&[*j, *i])).copied().collect();
    (!edges.is_empty()).then_some(outer)
}

/// Outward unit normal of the plane through the apex and an edge that runs counter-clockwise around the silhouette;
/// `None` for an edge in line with the apex, which appears as a corner.
fn through_edge(apex: &Point, from: &Point, to: &Point) -> Option<Vector> {
    let (a, b) = (from - apex, to - apex);
    // The side between the closer end and the edge has the smallest rounding error.
    let (nearer, edge) = (if a.norm_squared() <= b.norm_squared() { a } else { b }, to - from);
    let cross = nearer.cross(&edge);
    let norm = cross.norm();
    (norm > PARALLEL * nearer.norm() * edge.norm()).then(|| cross / norm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::distance;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    fn random_point(rng: &mut ChaCha8Rng, size: f64) -> Point {
        Point::from(Vector::from_fn(|_, _| rng.random_range(-size..size)))
    }

    /// Sources of a cable: scattered, on a line or in a plane along the axes of boxes, on a grid with duplicates, or a point and the
    /// same point lowered.
    fn random_sources(rng: &mut ChaCha8Rng) -> Vec<Point> {
        let size = [1e-3, 0.05, 0.5][rng.random_range(0..3)];
        let kind = rng.random_range(0..5);
        let count = if kind == 4 { 2 } else { rng.random_range(2..30) };
        let source = |k: usize, rng: &mut ChaCha8Rng| {
            let p = random_point(rng, size);
            match kind {
                0 => p,
                1 => Point::new(p.x, 0.0, 0.0),
                2 => Point::new(p.x, 0.0, p.z),
                3 => Point::from(p.coords.map(|x| (2.0 * x / size).round() * size)),
                _ => Point::new(0.0, 0.0, k as f64 * -size),
            }
        };
        (0..count).map(|k| source(k, rng)).collect()
    }

    /// A box, a plate or the hull of some points, away from the origin.
    fn random_body(rng: &mut ChaCha8Rng) -> Polytope {
        let body = match rng.random_range(0..3) {
            0 => Polytope::cuboid(std::array::from_fn(|_| rng.random_range(0.05..3.0))),
            1 => Polytope::cuboid([2.0, 2.0, 0.0]),
            _ => Polytope::hull_of(&(0..12).map(|_| random_point(rng, 1.0)).collect::<Vec<_>>()),
        };
        let away = random_point(rng, 6.0);
        // On a grid, so that edges are parallel and corners in line.
        let moved = if rng.random() { away } else { Point::from(away.coords.map(f64::round)) };
        body.unwrap().transformed(&Default::default(), &moved.coords)
    }

    #[test]
    fn shadows_from_sets_are_where_the_hull_of_the_sources_and_a_point_or_a_segment_meets_the_body() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let (mut inside, mut outside) = (0, 0);
        while inside + outside < 20_000 {
            let (body, sources) = (random_body(&mut rng), random_sources(&mut rng));
            let swept = Polytope::hull_of(&sources).unwrap();
            let apart = distance(&swept, &body).distance;
            let Some(cone) = Cone::from(&body, &sources).filter(|_| apart > 1e-3) else { continue };
            // The shadow of a body that is swept is where a segment, in place of the point, makes the hull meet the body.
            let along = if rng.random() { random_point(&mut rng, 1.0).coords } else { Vector::zeros() };
            let shadow = match body.swept(&along) {
                Ok(swept) if along != Vector::zeros() => cone.added_to(&swept, &[along.normalize()]),
                _ => cone.added_to(&body, &[]),
            };
            for _ in 0..20 {
                let from = sources[rng.random_range(0..sources.len())];
                let through = body.vertices()[rng.random_range(0..body.vertices().len())];
                let aside = random_point(&mut rng, 0.3).coords * apart.min(1.0);
                let at = through + (through - from) * rng.random_range(-0.3..2.0) + aside + along * rng.random::<f64>();
                let Ok(shapes) = Polytope::hull_of(&[&sources[..], &[at, at - along]].concat()) else { continue };
                let found = distance(&shapes, &body);
                let height = shadow.half_spaces.iter().map(|h| h.height(&at)).fold(f64::NEG_INFINITY, f64::max);
                if found.distance > 1e-6 {
                    assert!(height > -1e-9, "{height} {found:?} {at} {sources:?} {body:?}");
                    outside += 1;
                } else if found.depth > 1e-6 {
                    assert!(height < 1e-9, "{height} {found:?} {at} {sources:?} {body:?}");
                    inside += 1;
                }
            }
        }
        assert!(inside > 2000 && outside > 2000, "{inside} {outside}");
    }

    #[test]
    fn cones_from_sets_are_those_around_the_difference_of_the_bodies() {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let (mut found, mut refused) = (0, 0);
        while found < 3000 {
            let (body, sources) = (random_body(&mut rng), random_sources(&mut rng));
            let opposite = Polytope::hull_of(&sources.iter().map(|p| -*p).collect::<Vec<_>>()).unwrap();
            let Ok(difference) = body.sum(&opposite) else { continue };
            let Some(around) = Cone::around(&difference, &Point::origin()) else { continue };
            let Some(across) = Cone::across(&body, &sources) else {
                refused += 1;
                continue;
            };
            found += 1;
            assert!(across.tilt < 1e-11, "{}", across.tilt);
            for v in body.vertices() {
                for direction in sources.iter().map(|source| (v - source).normalize()) {
                    let over = across.normals.iter().map(|n| n.dot(&direction)).fold(f64::NEG_INFINITY, f64::max);
                    assert!(over <= 1e-12, "{over}");
                }
            }
            for (some, others) in [(&across, &around), (&around, &across)] {
                for normal in &some.normals {
                    // A side between two directions that differ by no more than this may be left out.
                    let same = others.normals.iter().map(|n| (n - normal).norm()).fold(f64::INFINITY, f64::min);
                    assert!(same < 1e-6, "{same} {across:?} {around:?} {body:?} {sources:?}");
                }
            }
            assert!(across.normals.len() <= around.normals.len() + 1, "{across:?} {around:?}");
        }
        assert!(refused < found / 3, "{refused}");
    }
}
