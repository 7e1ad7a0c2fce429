//! Directions in which a cable enters a body that it ends on.

use cdpr_core::geometry::Vector;

use crate::exact::{Exact, Exact3, cross, dot, exact, exact3, minus, plus, times};
use crate::polyhedron::Place;

/// The vectors v with n·v at most d for all faces. All d are 0 for a straight cable from its outlet: a cone.
#[derive(Debug)]
pub struct Cone {
    /// Outward unit normals n of the body's faces that contain the end.
    normals: Vec<Vector>,
    /// How far v may be above each face, d, m: how much lower the cable can be than the straight line from its outlet; negative if
    /// it is always higher, as it may be round a pulley.
    depths: Vec<Exact>,
}

impl Cone {
    /// The vectors that, moved by one of `lower` for each of these faces, are below it.
    pub fn below(faces: Vec<Vector>, lower: &[Exact3]) -> Self {
        let depth = |normal: &Vector| {
            let depths = lower.iter().map(|by| dot(&exact3(normal), &minus(&exact3(&Vector::zeros()), by)));
            depths.reduce(|a, b| if b > a { b } else { a }).expect("a cable has a shape")
        };
        Cone { depths: faces.iter().map(depth).collect(), normals: faces }
    }

    /// Whether a vector of the cone is at most `margin` from a direction, which is given times the place's scale, and about.
    pub fn is_near(&self, direction: &Exact3, about: &Vector, place: &Place, margin: &Exact) -> bool {
        let found = self.nearest(about);
        let found = found.iter().all(|x| x.is_finite()).then(|| exact3(&found));
        found.is_some_and(|found| self.is_foot((&found, &exact(1.0)), direction, place, margin))
            || !self.is_beyond_a_face(direction, place, margin) && self.has_foot(direction, place, margin)
    }

    /// Whether a vector, given by its numerators and a positive denominator, is in the cone and at most `margin` from a direction.
    fn is_foot(&self, (foot, whole): (&Exact3, &Exact), direction: &Exact3, place: &Place, margin: &Exact) -> bool {
        let step = minus(&times(&place.scale, foot), &times(whole, direction));
        let reach = margin * &place.scale * whole;
        let below = |(normal, depth): (&Vector, &Exact)| dot(&exact3(normal), foot) <= depth * whole;
        dot(&step, &step) <= &reach * &reach && self.normals.iter().zip(&self.depths).all(below)
    }

    /// Whether a direction is farther than `margin` above a face, and so from the cone.
    fn is_beyond_a_face(&self, direction: &Exact3, place: &Place, margin: &Exact) -> bool {
        self.normals.iter().zip(&self.depths).any(|(normal, depth)| {
            let normal = exact3(normal);
            let height = dot(&normal, direction) - depth * &place.scale;
            let reach = margin * &place.scale;
            height.sign().is_gt() && &height * &height > &reach * &reach * dot(&normal, &normal)
        })
    }

    /// Whether the cone is at most `margin` from a direction, exactly: its nearest point is the direction itself, its foot on a face,
    /// its foot on the line where two faces meet, or a point where three do.
    fn has_foot(&self, direction: &Exact3, place: &Place, margin: &Exact) -> bool {
        let scale = &place.scale; // the direction is times the scale
        let is_foot = |foot: &Exact3, whole: &Exact| self.is_foot((foot, &(whole * scale)), direction, place, margin);
        let faces: Vec<(Exact3, &Exact)> = self.normals.iter().map(exact3).zip(&self.depths).collect();
        let on_face = |(normal, depth): &(Exact3, &Exact)| {
            let square = dot(normal, normal);
            let above = dot(normal, direction) - *depth * scale;
            is_foot(&minus(&times(&square, direction), &times(&above, normal)), &square)
        };
        let on_line = |(a, da): &(Exact3, &Exact), (b, db): &(Exact3, &Exact)| {
            let line = cross(a, b);
            let square = dot(&line, &line);
            let own = plus(&times(da, &cross(b, &line)), &times(db, &cross(&line, a)));
            let foot = plus(&times(&dot(&line, direction), &line), &times(scale, &own));
            square.sign().is_gt() && is_foot(&foot, &square)
        };
        let in_corner = |[(a, da), (b, db), (c, dc)]: [&(Exact3, &Exact); 3]| {
            let volume = dot(a, &cross(b, c));
            let sign = exact(if volume.sign().is_lt() { -1.0 } else { 1.0 });
            let sum = plus(&times(da, &cross(b, c)), &plus(&times(db, &cross(c, a)), &times(dc, &cross(a, b))));
            volume.sign().is_ne() && is_foot(&times(&(&sign * scale), &sum), &volume.abs())
        };
        let pairs = || faces.iter().enumerate().flat_map(|(k, a)| faces[k + 1..].iter().map(move |b| (k, a, b)));
        is_foot(direction, &exact(1.0))
            || is_foot(&exact3(&Vector::zeros()), &exact(1.0)) // where all faces meet that have no depth
            || faces.iter().any(on_face)
            || pairs().any(|(_, a, b)| on_line(a, b))
            || self.depths.iter().any(|depth| depth.sign().is_ne())
                && pairs().any(|(k, a, b)| faces[..k].iter().any(|c| in_corner([a, b, c])))
    }

    /// About the nearest vector of the cone, and a little below each face (Hildreth's algorithm).
    fn nearest(&self, v: &Vector) -> Vector {
        let little = 1e-15 * v.amax();
        let depths: Vec<f64> = self.depths.iter().map(Exact::to_f64).collect();
        let (mut found, mut pushed) = (*v, vec![0.0; depths.len()]);
        for _ in 0..1000 {
            let before = found;
            for ((normal, depth), pushed) in self.normals.iter().zip(&depths).zip(&mut pushed) {
                let push = f64::max(normal.dot(&found) - depth + little, -*pushed);
                *pushed += push;
                found -= normal * push;
            }
            if (found - before).amax() <= 0.1 * little {
                break;
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_vector_is_found_exactly() {
        let random = |k: usize| (k as f64 * 0.754_877_666).fract() - 0.5;
        let vector = |k: usize| Vector::new(random(k), random(3 * k + 1), random(7 * k + 5)).normalize();
        let place = Place::of(&Vector::zeros());
        let (mut inside, mut slow) = (0, 0);
        for k in 0..400 {
            let faces: Vec<Vector> = (0..1 + k % 4).map(|i| vector(17 * k + i)).collect();
            let lower = [Vector::zeros(), vector(5 * k) * 0.3, vector(9 * k + 2) * 0.1].map(|by| exact3(&by));
            // Without the first one, as round a pulley, depths can be negative.
            let cone = Cone::below(faces, &lower[usize::from(k % 5 == 0 && k % 3 > 0)..1 + k % 3]);
            let direction = vector(11 * k + 3) * (0.1 + (k % 5) as f64);
            let found = cone.nearest(&direction);
            if cone.normals.iter().zip(&cone.depths).any(|(n, depth)| n.dot(&found) > depth.to_f64()) {
                slow += 1; // the guess is not good enough to compare with
                continue;
            }
            let distance = (found - direction).norm();
            let near = |margin: f64| cone.has_foot(&exact3(&direction), &place, &exact(margin));
            assert!(near(distance + 1e-9), "{k}");
            assert!(distance < 1e-9 || !near(distance - 1e-9), "{k}");
            for margin in [0.5 * distance, distance + 1e-9] {
                assert_eq!(cone.is_near(&exact3(&direction), &direction, &place, &exact(margin)), near(margin), "{k}");
            }
            inside += usize::from(distance < 1e-9);
        }
        assert!((50..300).contains(&inside) && slow < 50, "{inside} {slow}");
    }
}
