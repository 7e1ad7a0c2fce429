//! Seams of bodies made of convex parts.
//!
//! A body is the union of its parts, and each part forbids its interior. A cable in the face shared by two parts is
//! inside the union, but in the interior of neither part. So is a cable along an inner edge, around which several parts
//! meet, and a point in an inner corner. A seam is one more convex body inside the union, around such a face, edge or
//! corner; with seams, "inside some body" and "inside the union" agree.
//!
//! All seams are built alike. Let C be a face, edge or corner, m its middle, and D a ball around m in the directions
//! across C: a segment, a disc or a ball. If the parts that contain C cover D, then hull(C ∪ D) is inside the union: each
//! of its points lies between a point of C and one of D, and a part that contains the latter contains both. The seam is
//! the hull of C and a segment, a square or an octahedron in D.
//!
//! Parts that are at most [`ON_SURFACE`] apart count as abutting. Parts without volume have no seams.

mod inner;

use std::collections::BTreeSet;

use super::{Point, Polytope, Vector};
use crate::geometry::convex::clip::clipped;
use crate::geometry::convex::hull::Facet;
use crate::tolerances::{ALONG_FACET, FLAT, ON_SURFACE, TOUCH_DEPTH};
use inner::{Inner, inner_edges_and_corners};

/// A body that closes the seam between parts.
#[derive(Debug, Clone, PartialEq)]
pub struct Seam {
    /// Inside the union of the parts, around the face, edge or corner where they meet.
    pub body: Polytope,
    /// The parts, in ascending order.
    pub between: Vec<usize>,
    /// The face, edge or corner that the seam closes.
    pub gap: Gap,
}

/// The face, edge or corner that a seam closes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// 2 for a face shared by two parts, 1 for an inner edge, 0 for an inner corner. A body with more dimensions than the
    /// gap that enters the seam also enters a part, or a seam with more dimensions.
    pub dimension: usize,
    /// Depth in the seam's body that still counts as touching, m. The body is thin towards the rim of the face or the ends
    /// of the edge, and thinner for thinner parts; this depth in it corresponds to [`TOUCH_DEPTH`] inside the face or edge.
    pub touch: f64,
}

impl Gap {
    /// Whether a body with this number of dimensions can be inside the union without entering a part or another seam.
    pub fn admits(&self, dimension: usize) -> bool {
        dimension <= self.dimension
    }
}

/// The seams between parts: of faces, then of inner edges, then of inner corners.
pub fn seams(parts: &[&Polytope]) -> Vec<Seam> {
    let neighbours = neighbours(parts);
    let mut found = Vec::new();
    for (i, beside) in neighbours.iter().enumerate() {
        for &j in beside.iter().filter(|j| **j > i) {
            let (a, b) = (parts[i], parts[j]);
            let Some(face) = shared_face(a, b) else { continue };
            let steepness = |f: &Facet| f.normal.cross(&face.1).norm();
            let body = bipyramid(&face, a, b);
            found.extend(body.map(|body| Seam::new(body, vec![i, j], 2, steepness)));
        }
    }
    let shared: BTreeSet<[usize; 2]> = found.iter().map(|seam| [seam.between[0], seam.between[1]]).collect();
    found.extend(inner_edges_and_corners(parts, &neighbours, &shared).into_iter().map(Seam::around));
    found
}

impl Seam {
    /// `steepness` is the sine of the angle between a facet of the body and the face or edge that it closes.
    fn new(body: Polytope, between: Vec<usize>, dimension: usize, steepness: impl Fn(&Facet) -> f64) -> Self {
        let touch = TOUCH_DEPTH * body.facets().iter().map(steepness).fold(1.0, f64::min);
        Seam { body, between, gap: Gap { dimension, touch } }
    }

    /// The seam of an inner edge or corner.
    fn around(Inner { line, between, radius }: Inner) -> Self {
        let middle = line.at(0.5 * line.length);
        if line.length == 0.0 {
            let axes = [Vector::x(), Vector::y(), Vector::z()];
            return Seam::new(Polytope::octahedron(&middle, &axes.map(|axis| axis * radius)), between, 0, |_| 1.0);
        }
        let along = line.along;
        let across = along.cross(&Vector::ith(along.iamin(), 1.0)).normalize();
        let body = Polytope::octahedron(
            &middle,
            &[along * (0.5 * line.length), across * radius, along.cross(&across) * radius],
        );
        Seam::new(body, between, 1, |f| f.normal.dot(&along).abs())
    }
}

/// For each part with volume, those whose boxes touch its own, in ascending order.
fn neighbours(parts: &[&Polytope]) -> Vec<Vec<usize>> {
    let mut found = vec![Vec::new(); parts.len()];
    let mut sorted: Vec<usize> = (0..parts.len()).filter(|&k| parts[k].has_volume()).collect();
    let least = |k: usize| parts[k].aabb().min.x;
    sorted.sort_by(|&a, &b| least(a).total_cmp(&least(b)));
    for (place, &a) in sorted.iter().enumerate() {
        let end = parts[a].aabb().max.x + ON_SURFACE;
        let later = sorted[place + 1..].iter().take_while(|&&b| least(b) <= end);
        for &b in later.filter(|&&b| !parts[a].aabb().apart_by(parts[b].aabb(), ON_SURFACE)) {
            found[a].push(b);
            found[b].push(a);
        }
    }
    found.iter_mut().for_each(|beside| beside.sort_unstable());
    found
}

/// Polygon in which a facet of `a` lies against a facet of `b`.
fn shared_face(a: &Polytope, b: &Polytope) -> Option<(Vec<Point>, Vector)> {
    let opposite = |f: &&Facet, g: &&Facet| f.normal.dot(&g.normal) < -0.5 && lies_on(f, b, g) && lies_on(g, a, f);
    let pairs = a.facets().iter().flat_map(|f| b.facets().iter().map(move |g| (f, g)));
    for (f, _) in pairs.filter(|(f, g)| opposite(f, g)) {
        let mut polygon: Vec<Point> = f.corners.iter().map(|&i| a.vertices()[i]).collect();
        for side in b.facets().iter().filter(|g| g.normal.cross(&f.normal).norm() > ALONG_FACET) {
            polygon = clipped(&polygon, |p| side.height(p));
        }
        let shared = Polytope::hull_of(&polygon).ok().filter(|p| p.dimension() == 2);
        if let Some(face) = shared {
            return Some((face.vertices().to_vec(), f.normal));
        }
    }
    None
}

/// Whether the corners of facet `g` of body `b` lie in the plane of facet `f`.
fn lies_on(f: &Facet, b: &Polytope, g: &Facet) -> bool {
    g.corners.iter().all(|&i| f.height(&b.vertices()[i]).abs() <= ON_SURFACE)
}

/// Both pyramids over the face, with apexes as far into the parts as possible.
fn bipyramid((face, normal): &(Vec<Point>, Vector), a: &Polytope, b: &Polytope) -> Option<Polytope> {
    let middle = Point::from(face.iter().map(|p| p.coords).sum::<Vector>() / face.len() as f64);
    let reach = |body: &Polytope, direction: Vector| {
        let room = body.facets().iter().filter_map(|f| {
            let speed = f.normal.dot(&direction);
            (speed > ALONG_FACET).then(|| -f.height(&middle) / speed)
        });
        middle + direction * (0.5 * room.fold(f64::INFINITY, f64::min))
    };
    let apexes = [reach(a, -normal), reach(b, *normal)];
    if apexes.iter().any(|apex| (apex - middle).norm() <= FLAT) {
        return None;
    }
    let corners: Vec<Point> = face.iter().copied().chain(apexes).collect();
    Polytope::hull_of(&corners).ok()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::geometry::Rotation;

    fn cuboid(sides: [f64; 3], at: [f64; 3]) -> Polytope {
        Polytope::cuboid(sides).unwrap().transformed(&Rotation::identity(), &Vector::from(at))
    }

    /// The box with these corners.
    fn span(min: [f64; 3], max: [f64; 3]) -> Polytope {
        cuboid(std::array::from_fn(|k| max[k] - min[k]), std::array::from_fn(|k| 0.5 * (min[k] + max[k])))
    }

    fn cube(x: i32, y: i32, z: i32) -> Polytope {
        cuboid([1.0; 3], [x, y, z].map(|k| f64::from(k) + 0.5))
    }

    fn turned(parts: &[Polytope], rng: &mut ChaCha8Rng) -> Vec<Polytope> {
        let angles = Vector::from_fn(|_, _| rng.random_range(-3.0..3.0));
        let shift = Vector::from_fn(|_, _| rng.random_range(-9.0..9.0));
        parts.iter().map(|part| part.transformed(&Rotation::from_scaled_axis(angles), &shift)).collect()
    }

    /// Parts with an error in each coordinate of each corner.
    fn rounded(parts: &[Polytope], error: f64, rng: &mut ChaCha8Rng) -> Vec<Polytope> {
        let off = |p: &Point, rng: &mut ChaCha8Rng| p.map(|x| x + rng.random_range(-error..=error));
        let part = |part: &Polytope, rng: &mut ChaCha8Rng| {
            let corners: Vec<Point> = part.vertices().iter().map(|v| off(v, rng)).collect();
            Polytope::hull_of(&corners).unwrap()
        };
        parts.iter().map(|body| part(body, rng)).collect()
    }

    fn points(list: &[[f64; 3]]) -> Vec<Point> {
        list.iter().map(|p| Point::from(*p)).collect()
    }

    /// The numbers of seams of faces, edges and corners. All are convex and inside the union.
    fn counts(parts: &[Polytope]) -> [usize; 3] {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let seams = seams(&parts.iter().collect::<Vec<_>>());
        for seam in &seams {
            let body = &seam.body;
            assert!(body.facets().iter().all(|f| body.vertices().iter().all(|v| f.height(v) < 1e-12)));
            assert!(seam.between.is_sorted() && 0.0 < seam.gap.touch && seam.gap.touch <= TOUCH_DEPTH);
            for _ in 0..200 {
                let weights: Vec<f64> = body.vertices().iter().map(|_| rng.random::<f64>().powi(3)).collect();
                let sum = body.vertices().iter().zip(&weights).map(|(v, w)| v.coords * *w).sum::<Vector>();
                let point = Point::from(sum / weights.iter().sum::<f64>());
                let is_inside = seam.between.iter().any(|&k| parts[k].depth_of(&point) > -1e-11);
                assert!(is_inside, "{point} of {seam:?}");
            }
        }
        [2, 1, 0].map(|dimension| seams.iter().filter(|seam| seam.gap.dimension == dimension).count())
    }

    /// The numbers of seams of faces, edges and corners; they do not depend on the position of the parts or on rounding errors.
    fn counts_everywhere(parts: &[Polytope]) -> [usize; 3] {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let found = counts(parts);
        for _ in 0..20 {
            let turned = turned(parts, &mut rng);
            assert_eq!(counts(&turned), found);
            assert_eq!(counts(&rounded(&turned, 1e-13, &mut rng)), found);
        }
        found
    }

    #[test]
    fn abutting_boxes_have_one_seam_inside_their_union() {
        let parts = [cuboid([1.0, 1.0, 1.0], [0.0; 3]), cuboid([1.0, 0.5, 3.0], [1.0, 0.1, 0.0])];
        let seams = seams(&parts.each_ref());
        assert_eq!((seams.len(), &seams[0].between), (1, &vec![0, 1]));
        assert!(seams[0].body.depth_of(&Point::new(0.5, 0.1, 0.0)) > 0.05);
        assert_eq!(counts_everywhere(&parts), [1, 0, 0]);
    }

    #[test]
    fn boxes_that_share_an_edge_overlap_or_stand_apart_have_none() {
        let first = cuboid([1.0; 3], [0.0; 3]);
        for at in [[1.0, 1.0, 0.0], [0.5, 0.0, 0.0], [0.5, 0.5, 0.0], [1.5, 0.0, 0.0]] {
            assert!(seams(&[&first, &cuboid([1.0; 3], at)]).is_empty(), "{at:?}");
        }
    }

    #[test]
    fn the_edge_where_four_boxes_meet_is_closed_between_its_ends() {
        let parts = [cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 0), cube(1, 1, 0)];
        assert_eq!(counts_everywhere(&parts), [4, 1, 0]);
        let seams = seams(&parts.each_ref());
        let edge = &seams[4];
        assert_eq!(edge.between, [0, 1, 2, 3]);
        for height in [2e-9, 0.5, 1.0 - 2e-9] {
            assert!(edge.body.depth_of(&Point::new(1.0, 1.0, height)) > edge.gap.touch, "{height}");
        }
        assert!(edge.body.depth_of(&Point::new(1.0, 1.0, 0.5e-9)) < edge.gap.touch);
        assert_eq!(counts_everywhere(&parts[..3]), [2, 0, 0]);
    }

    #[test]
    fn the_edge_where_two_boxes_stand_on_a_larger_one_is_closed() {
        let floor = span([-1.0, -1.0, -1.0], [3.0, 2.0, 0.0]);
        assert_eq!(counts_everywhere(&[floor, cube(0, 0, 0), cube(1, 0, 0)]), [3, 1, 0]);
    }

    #[test]
    fn an_edge_is_closed_only_where_parts_are_all_around() {
        let row = span([0.0, 0.0, 0.0], [3.0, 1.0, 1.0]);
        let behind = span([0.0, 1.0, 0.0], [3.0, 2.0, 1.0]);
        let above = span([1.0, 0.0, 1.0], [2.0, 1.0, 2.0]);
        let last = span([1.5, 1.0, 1.0], [4.0, 2.0, 2.0]);
        let parts = [row, behind, above, last];
        assert_eq!(counts_everywhere(&parts)[1], 1);
        let seams = seams(&parts.each_ref());
        let edge = seams.iter().find(|seam| seam.gap.dimension == 1).unwrap();
        let bounds = edge.body.aabb();
        assert_eq!([bounds.min.x, bounds.max.x], [1.5, 2.0]);
    }

    #[test]
    fn the_corner_where_eight_boxes_meet_is_closed() {
        let parts: Vec<Polytope> = (0..8).map(|k| cube(k & 1, k >> 1 & 1, k >> 2)).collect();
        assert_eq!(counts_everywhere(&parts), [12, 6, 1]);
        assert_eq!(counts_everywhere(&parts[..7]), [9, 3, 0]);
    }

    #[test]
    fn seams_close_where_facets_of_overlapping_parts_cross() {
        let third = std::f64::consts::TAU / 3.0;
        let slab = |k: i32| {
            let turn = Rotation::from_scaled_axis(Vector::z() * (f64::from(k) * third));
            cuboid([1.0, 4.0, 1.0], [0.5, 0.0, 0.0]).transformed(&turn, &Vector::zeros())
        };
        assert_eq!(counts_everywhere(&[slab(0), slab(1), slab(2)]), [0, 1, 0]);
        assert_eq!(counts_everywhere(&[slab(0), slab(1)]), [0, 0, 0]);
    }

    #[test]
    fn a_point_between_four_overlapping_half_spaces_is_closed() {
        let slab = |normal: [f64; 3]| {
            let turn = Rotation::rotation_between(&Vector::x(), &Vector::from(normal)).unwrap();
            cuboid([1.0, 6.0, 6.0], [0.5, 0.0, 0.0]).transformed(&turn, &Vector::zeros())
        };
        let normals = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        assert_eq!(counts_everywhere(&normals.map(slab)), [0, 0, 1]);
    }

    #[test]
    fn fans_of_tetrahedra_are_closed_around_their_common_edge() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..200 {
            let count = rng.random_range(3..9);
            let step = std::f64::consts::TAU / f64::from(count);
            let rim: Vec<[f64; 3]> = (0..count)
                .map(|k| {
                    let angle = step * (f64::from(k) + rng.random_range(-0.2..0.2));
                    let radius = rng.random_range(0.2..1.0);
                    [radius * angle.cos(), radius * angle.sin(), rng.random_range(-0.5..0.5)]
                })
                .collect();
            let sector = |k: usize| [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0], rim[k], rim[(k + 1) % rim.len()]];
            let fan: Vec<Polytope> = (0..rim.len()).map(|k| Polytope::hull_of(&points(&sector(k))).unwrap()).collect();
            let fan = turned(&fan, &mut rng);
            for error in [0.0, 1e-13] {
                let fan = rounded(&fan, error, &mut rng);
                assert_eq!(counts(&fan), [fan.len(), 1, 0]);
                assert_eq!(counts(&fan[1..])[1], 0);
            }
        }
    }

    #[test]
    fn tetrahedra_around_a_point_have_edge_and_corner_seams() {
        let ball = |rows: usize, columns: usize| {
            let at = |row: usize, column: usize| {
                let share = |k: usize, of: usize| std::f64::consts::TAU * (k % of) as f64 / of as f64;
                let (down, around) = (share(row, 2 * rows), share(column, columns));
                [down.sin() * around.cos(), down.sin() * around.sin(), down.cos()]
            };
            let cell = |k: usize| (k / columns, k % columns);
            let triangles = (0..rows * columns).map(cell).flat_map(|(row, column)| {
                let [a, b, c, d] = [(row, column), (row, column + 1), (row + 1, column), (row + 1, column + 1)];
                [(row > 0).then_some([a, b, c]), (row + 1 < rows).then_some([b, c, d])]
            });
            let tetrahedron = |corners: [(usize, usize); 3]| {
                let [a, b, c] = corners.map(|(row, column)| at(row, column));
                Polytope::hull_of(&points(&[[0.0; 3], a, b, c])).unwrap()
            };
            triangles.flatten().map(tetrahedron).collect::<Vec<_>>()
        };
        for (rows, columns) in [(2, 3), (3, 5), (4, 8)] {
            let parts = ball(rows, columns);
            let (faces, corners) = (parts.len(), (rows - 1) * columns + 2);
            assert_eq!(counts_everywhere(&parts), [faces * 3 / 2, corners, 1]);
            assert_eq!(counts(&parts[1..])[2], 0);
        }
    }

    #[test]
    fn a_part_that_the_edge_runs_through_needs_no_seam_there() {
        let parts = [cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 0), cube(1, 1, 0), cuboid([1.0; 3], [1.0, 1.0, 0.5])];
        assert_eq!(counts(&parts)[1..], [0, 0]);
    }

    #[test]
    fn redundant_parts_do_not_thin_a_seam() {
        let mut parts = vec![cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 0), cube(1, 1, 0)];
        parts.push(span([1.0, 1.0, 0.0], [1.0 + 1e-3, 1.0 + 1e-3, 1.0]));
        let seams = seams(&parts.iter().collect::<Vec<_>>());
        let edge = seams.iter().find(|seam| seam.gap.dimension == 1).unwrap();
        assert!(edge.between == [0, 1, 2, 3] && edge.body.depth_of(&Point::new(1.0, 1.0, 0.5)) > 0.1);
    }
}
