//! Seams of bodies made of abutting convex parts.
//!
//! A cable in the face shared by two parts is inside their union, but inside neither part. The shared face,
//! thickened to a bipyramid within the union, is one more convex part; with it, "inside some part" and
//! "inside the union" agree. Limitation: an edge line where three or more parts meet, no two of which share a face
//! around it, is not covered; this affects only a cable exactly along that line. Parts without volume have no seams.

use super::hull::Facet;
use super::{Point, Polytope, Vector};
use crate::numerics::{ALONG_FACET, FLAT, ON_SURFACE, TOUCH_DEPTH};

/// A body that closes the seam between two parts.
#[derive(Debug, Clone, PartialEq)]
pub struct Seam {
    /// Inside the union of the two parts, around the face they share.
    pub body: Polytope,
    /// The two parts.
    pub between: [usize; 2],
    /// Depth in the body that still counts as touching, m. The body is thin towards its rim, and thinner for thinner
    /// parts; this depth in it corresponds to [`TOUCH_DEPTH`] inside the rim of the shared face.
    pub touch: f64,
}

/// The seams between all pairs of parts that share a face; parts that overlap or are apart have none.
pub fn seams(parts: &[&Polytope]) -> Vec<Seam> {
    let mut found = Vec::new();
    for (i, a) in parts.iter().enumerate() {
        for (j, b) in parts.iter().enumerate().skip(i + 1) {
            let Some(face) = shared_face(a, b) else { continue };
            let steepness = |body: &Polytope| {
                let rise = |f: &Facet| f.normal.cross(&face.1).norm();
                body.facets().iter().map(rise).fold(1.0, f64::min)
            };
            let body = bipyramid(&face, a, b);
            found.extend(body.map(|body| Seam { touch: TOUCH_DEPTH * steepness(&body), body, between: [i, j] }));
        }
    }
    found
}

/// Polygon in which a facet of `a` lies against a facet of `b`.
fn shared_face(a: &Polytope, b: &Polytope) -> Option<(Vec<Point>, Vector)> {
    if !(a.has_volume() && b.has_volume()) || a.aabb().apart_by(b.aabb(), ON_SURFACE) {
        return None;
    }
    let opposite = |f: &&Facet, g: &&Facet| f.normal.dot(&g.normal) < -0.5 && lies_on(f, b, g) && lies_on(g, a, f);
    let pairs = a.facets().iter().flat_map(|f| b.facets().iter().map(move |g| (f, g)));
    for (f, _) in pairs.filter(|(f, g)| opposite(f, g)) {
        let mut polygon: Vec<Point> = f.corners.iter().map(|&i| a.vertices()[i]).collect();
        for side in b.facets().iter().filter(|g| g.normal.cross(&f.normal).norm() > ALONG_FACET) {
            polygon = clip(&polygon, side);
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

/// The part of a convex polygon under a facet's plane (Sutherland–Hodgman).
fn clip(polygon: &[Point], facet: &Facet) -> Vec<Point> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (k, p) in polygon.iter().enumerate() {
        let q = &polygon[(k + 1) % polygon.len()];
        let (hp, hq) = (facet.height(p), facet.height(q));
        if hp <= 0.0 {
            kept.push(*p);
        }
        if (hp < 0.0 && hq > 0.0) || (hp > 0.0 && hq < 0.0) {
            kept.push(p + (q - p) * (hp / (hp - hq)));
        }
    }
    kept
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
    use super::*;
    use crate::geometry::Rotation;

    fn cuboid(sides: [f64; 3], at: [f64; 3]) -> Polytope {
        Polytope::cuboid(sides).unwrap().transformed(&Rotation::identity(), &Vector::from(at))
    }

    #[test]
    fn abutting_boxes_have_one_seam_inside_their_union() {
        let parts = [cuboid([1.0, 1.0, 1.0], [0.0; 3]), cuboid([1.0, 0.5, 3.0], [1.0, 0.1, 0.0])];
        let seams = seams(&parts.each_ref());
        assert_eq!((seams.len(), seams[0].between), (1, [0, 1]));
        let body = &seams[0].body;
        assert!(body.depth_of(&Point::new(0.5, 0.1, 0.0)) > 0.05);
        for v in body.vertices() {
            assert!(parts.iter().any(|part| part.depth_of(v) > -1e-9), "{v} outside the union");
        }
    }

    #[test]
    fn boxes_that_share_an_edge_overlap_or_stand_apart_have_none() {
        let first = cuboid([1.0; 3], [0.0; 3]);
        for at in [[1.0, 1.0, 0.0], [0.5, 0.0, 0.0], [1.5, 0.0, 0.0]] {
            assert!(seams(&[&first, &cuboid([1.0; 3], at)]).is_empty(), "{at:?}");
        }
    }
}
