//! The volume of a box that lies in half-spaces.

use crate::geometry::{Aabb, Cuboid, HalfSpace, Point, convex_volume};
use crate::tolerances::{NEARLY_PARALLEL, TOUCH_DEPTH};

/// Bounds of the volume of a box that lies in all half-spaces. Each cut may move corners by [`TOUCH_DEPTH`], and leaves out what is
/// no thicker.
pub fn volume(half_spaces: &[HalfSpace], positions: &Cuboid) -> [f64; 2] {
    let half = &positions.half;
    let whole = 8.0 * half.product();
    let error = TOUCH_DEPTH * 8.0 * (half.x * half.y + half.y * half.z + half.z * half.x);
    let mut cutting: Vec<HalfSpace> = Vec::new();
    for plane in half_spaces {
        if !(positions.lowest(plane) < 0.0) {
            return [0.0, error];
        }
        if positions.highest(plane) > 0.0 {
            cutting.push(*plane);
        }
    }
    let error = (cutting.len() + 1) as f64 * error;
    let within = Aabb { min: positions.low, max: positions.high };
    let found = match cutting.as_slice() {
        [] => return [whole, whole],
        [plane] => cut_off(&[*plane], &foot(plane, &positions.center), positions),
        [a, b] => match meeting(a, b, &positions.center) {
            Some(apex) => cut_off(&[*a, *b], &apex, positions),
            None => convex_volume(&cutting, &within),
        },
        _ => convex_volume(&cutting, &within),
    };
    [(found - error).max(0.0), (found + error).min(whole)]
}

/// The point of a plane that is nearest to a point.
fn foot(plane: &HalfSpace, to: &Point) -> Point {
    to - plane.normal * plane.height(to)
}

/// A point of two planes; `None` if they are nearly parallel.
fn meeting(a: &HalfSpace, b: &HalfSpace, near: &Point) -> Option<Point> {
    let first = foot(a, near);
    let across = b.normal - a.normal * a.normal.dot(&b.normal);
    let steep = across.norm_squared();
    (steep > NEARLY_PARALLEL * NEARLY_PARALLEL).then(|| first - across * (b.height(&first) / steep))
}

/// Faces of a box: axis, and whether it is the upper one.
const FACES: [(usize, bool); 6] = [(0, false), (0, true), (1, false), (1, true), (2, false), (2, true)];

/// Corners of a face that some planes cut.
const CORNERS: usize = 8;

/// The volume of a box that lies in half-spaces, with a point that is in all their planes: the cones from there to what is left of the
/// faces of the box.
fn cut_off(half_spaces: &[HalfSpace], apex: &Point, positions: &Cuboid) -> f64 {
    let cone = |(axis, upper): (usize, bool)| {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let level = if upper { positions.half[axis] } else { -positions.half[axis] };
        let mut face = [[0.0; 2]; CORNERS];
        let signs = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        (0..4).for_each(|k| face[k] = [signs[k][0] * positions.half[u], signs[k][1] * positions.half[v]]);
        let mut count = 4;
        for plane in half_spaces {
            let middle = plane.height(&positions.center) + level * plane.normal[axis];
            let height = |p: &[f64; 2]| middle + p[0] * plane.normal[u] + p[1] * plane.normal[v];
            let (mut left, mut kept) = ([[0.0; 2]; CORNERS], 0);
            for k in 0..count {
                let (p, q) = (face[k], face[(k + 1) % count]);
                let (above, next) = (height(&p), height(&q));
                if above <= 0.0 {
                    left[kept] = p;
                    kept += 1;
                }
                if (above < 0.0 && next > 0.0) || (above > 0.0 && next < 0.0) {
                    let share = above / (above - next);
                    left[kept] = [p[0] + (q[0] - p[0]) * share, p[1] + (q[1] - p[1]) * share];
                    kept += 1;
                }
            }
            (face, count) = (left, kept);
        }
        let area: f64 =
            (0..count).map(|k| (face[k], face[(k + 1) % count])).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum();
        let outward = if upper { 1.0 } else { -1.0 };
        outward * (positions.center[axis] + level - apex[axis]) * 0.5 * area / 3.0
    };
    FACES.map(cone).iter().sum()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::geometry::Vector;

    fn below(normal: Vector, height: f64) -> HalfSpace {
        HalfSpace::through(&(Point::origin() + normal * height), normal)
    }

    #[test]
    fn the_volume_below_a_plane_is_bracketed() {
        let cube = Cuboid::new(Point::origin(), Point::new(1.0, 1.0, 1.0));
        let corner = below(Vector::repeat(1.0).normalize(), 1.0 / f64::sqrt(3.0));
        let (half, slit) = (below(Vector::z(), 0.5), below(-Vector::z(), -0.5));
        for (planes, volume) in [
            (vec![], 1.0),
            (vec![below(Vector::z(), 0.25)], 0.25),
            (vec![corner], 1.0 / 6.0),
            (vec![corner; 3], 1.0 / 6.0),
            (vec![half, slit], 0.0),
            (vec![half, below(Vector::new(0.0, 1e-9, 1.0).normalize(), 0.5)], 0.5),
            (vec![half, below(Vector::x(), 0.5)], 0.25),
            (vec![below(Vector::z(), 1.5), half, below(Vector::x(), 0.5), below(Vector::y(), 0.5)], 0.125),
            (vec![below(Vector::z(), -1.0)], 0.0),
        ] {
            let [least, most] = super::volume(&planes, &cube);
            assert!(least <= volume && volume <= most && most - least < 1e-6, "{volume}: {least} {most}");
        }
    }

    /// One or two planes by cones, the same as by cutting a polyhedron.
    #[test]
    fn cones_and_polyhedra_have_the_same_volume() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut cut = 0;
        for _ in 0..10_000 {
            let mut random = |size: f64| Vector::from_fn(|_, _| rng.random_range(-size..size));
            let (low, size) = (random(5.0), random(1.0).abs() + Vector::repeat(1e-3));
            let positions = Cuboid::new(Point::from(low), Point::from(low + size));
            let mut plane = || {
                let (normal, at) = (random(1.0).normalize(), random(1.0).component_mul(&positions.half));
                HalfSpace::through(&(positions.center + at), normal)
            };
            let (a, b) = (plane(), plane());
            let aabb = Aabb { min: positions.low, max: positions.high };
            for planes in [vec![a], vec![a, b], vec![a, a], vec![a, b, a]] {
                let ([least, most], other) = (super::volume(&planes, &positions), convex_volume(&planes, &aabb));
                let rounding = 1e-12 * positions.half.product();
                assert!(least <= other + rounding && other <= most + rounding, "{planes:?} {positions:?}");
                cut += usize::from(other > 0.0);
            }
        }
        assert!(cut > 10_000, "{cut}");
    }
}
