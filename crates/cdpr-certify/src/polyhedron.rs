//! The corners of a box cut by half-spaces, exactly.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use cdpr_core::geometry::Vector;

use crate::exact::{Exact, Exact3, cross, dot, exact, exact3, times};

/// A position as a quotient: `at` / `scale`, with a positive scale.
#[derive(Debug, Clone)]
pub struct Place {
    /// Numerators of the coordinates.
    pub at: Exact3,
    /// Common denominator of the coordinates.
    pub scale: Exact,
}

impl Place {
    /// A position of finite coordinates.
    pub fn of(position: &Vector) -> Self {
        Place { at: exact3(position), scale: exact(1.0) }
    }

    /// About the same position.
    pub fn to_f64(&self) -> Vector {
        Vector::from_fn(|k, _| self.at[k].over(&self.scale))
    }
}

/// The half-space of the x with n·x < d.
pub struct HalfSpace {
    normal: Exact3,
    offset: Exact,
}

impl HalfSpace {
    /// The half-space of four finite numbers: n, then d.
    pub fn of([x, y, z, d]: &[f64; 4]) -> Self {
        HalfSpace { normal: exact3(&Vector::new(*x, *y, *z)), offset: exact(*d) }
    }

    /// How n·x compares with d.
    fn side(&self, place: &Place) -> Ordering {
        self.height(place).sign()
    }

    /// n·x - d, times the place's scale.
    pub fn height(&self, place: &Place) -> Exact {
        dot(&self.normal, &place.at) - &self.offset * &place.scale
    }

    /// The normal n of the half-space.
    pub fn normal(&self) -> &Exact3 {
        &self.normal
    }

    /// Whether the half-space contains a closed box: the corner that is farthest along n decides.
    pub fn contains(&self, [low, high]: &[Exact3; 2]) -> bool {
        let far = |k: usize| if self.normal[k].sign().is_gt() { &high[k] } else { &low[k] };
        (0..3).map(|k| &self.normal[k] * far(k)).sum::<Exact>() < self.offset
    }
}

/// The eight corners of a box.
pub fn box_corners([low, high]: &[[f64; 3]; 2]) -> Vec<Vector> {
    let corner = |k: usize| Vector::from_fn(|axis, _| if k >> axis & 1 == 1 { high[axis] } else { low[axis] });
    (0..8).map(corner).collect()
}

/// A corner and the planes that contain it, by number.
pub struct Corner {
    /// Position of the corner.
    pub place: Place,
    /// Numbers of the planes: those of the box are 0 to 5, those of the half-spaces follow.
    pub on: BTreeSet<usize>,
}

/// All corners of the part of a box (first its least, then its largest coordinates) that lies in these half-spaces; none
/// if that part has no interior.
///
/// The box is cut by one half-space after another (the double description method). The corners of the part that remains
/// are the old ones in the half-space, and one on every edge between an old one inside and an old one outside. Two
/// corners are the ends of an edge if and only if no third corner lies on all planes that contain both.
pub fn corners(bounds: &[[f64; 3]; 2], half_spaces: &[[f64; 4]]) -> Vec<Place> {
    corners_on_planes(bounds, half_spaces).into_iter().map(|corner| corner.place).collect()
}

/// All corners of the part of a box that lies in these half-spaces, each with the planes that contain it; see
/// [`corners`].
pub fn corners_on_planes(bounds: &[[f64; 3]; 2], half_spaces: &[[f64; 4]]) -> Vec<Corner> {
    let wall = |k: usize| {
        let mut normal = [0.0; 3];
        normal[k % 3] = 1.0;
        [normal[0], normal[1], normal[2], bounds[k / 3][k % 3]]
    };
    let planes: Vec<HalfSpace> =
        (0..6).map(wall).chain(half_spaces.iter().copied()).map(|h| HalfSpace::of(&h)).collect();
    let walls = |k: usize| (0..3).map(|axis| axis + 3 * (k >> axis & 1)).collect();
    let first =
        box_corners(bounds).iter().enumerate().map(|(k, v)| Corner { place: Place::of(v), on: walls(k) }).collect();
    (6..planes.len()).fold(first, |corners, k| cut(corners, &planes, k))
}

fn cut(mut corners: Vec<Corner>, planes: &[HalfSpace], by: usize) -> Vec<Corner> {
    let sides: Vec<Ordering> = corners.iter().map(|corner| planes[by].side(&corner.place)).collect();
    if !sides.contains(&Ordering::Less) {
        return Vec::new();
    }
    let mut new = Vec::new();
    for (inside, _) in sides.iter().enumerate().filter(|(_, side)| side.is_lt()) {
        for (outside, _) in sides.iter().enumerate().filter(|(_, side)| side.is_gt()) {
            let mut on: BTreeSet<usize> = &corners[inside].on & &corners[outside].on;
            let others = corners.iter().enumerate().filter(|(k, _)| ![inside, outside].contains(k));
            if on.len() >= 2 && others.into_iter().all(|(_, third)| !on.is_subset(&third.on)) {
                let edge: Vec<&HalfSpace> = on.iter().map(|k| &planes[*k]).collect();
                let place = meeting_point(&edge, &planes[by]);
                on.insert(by);
                new.push(Corner { place, on });
            }
        }
    }
    for (corner, side) in corners.iter_mut().zip(&sides) {
        if side.is_eq() {
            corner.on.insert(by);
        }
    }
    let kept = corners.into_iter().zip(sides).filter(|(_, side)| side.is_le()).map(|(corner, _)| corner);
    kept.chain(new).collect()
}

/// The point where a plane meets the edge in which all these planes meet, by Cramer's rule for two of them.
fn meeting_point(edge: &[&HalfSpace], plane: &HalfSpace) -> Place {
    let first = edge[0];
    let found = edge[1..].iter().find_map(|second| {
        let axis = cross(&first.normal, &second.normal);
        let scale = dot(&axis, &plane.normal);
        let sign = exact(if scale.sign().is_lt() { -1.0 } else { 1.0 });
        let part = |p: &HalfSpace, a: &HalfSpace, b: &HalfSpace| times(&p.offset, &cross(&a.normal, &b.normal));
        let parts = [part(first, second, plane), part(second, plane, first), part(plane, first, second)];
        let sum = |k: usize| &parts[0][k] + &parts[1][k] + &parts[2][k];
        let at = times(&sign, &[sum(0), sum(1), sum(2)]);
        scale.sign().is_ne().then(|| Place { at, scale: scale * sign })
    });
    found.expect("planes that meet in an edge are not all parallel, and the edge has an end on either side")
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: [[f64; 3]; 2] = [[0.0; 3], [1.0; 3]];

    fn sorted(half_spaces: &[[f64; 4]]) -> Vec<[f64; 3]> {
        let mut all: Vec<[f64; 3]> = corners(&UNIT, half_spaces).iter().map(|c| c.to_f64().into()).collect();
        all.sort_by(|a, b| a.partial_cmp(b).unwrap());
        all
    }

    #[test]
    fn a_cut_corner_leaves_ten() {
        assert_eq!(corners(&UNIT, &[]).len(), 8);
        assert_eq!(corners(&UNIT, &[[1.0, 1.0, 1.0, 2.5]]).len(), 10);
        let tetrahedron = vec![[0.0; 3], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
        assert_eq!(sorted(&[[1.0, 1.0, 1.0, 1.0]]), tetrahedron);
    }

    #[test]
    fn touching_and_repeated_planes_change_nothing() {
        let half = sorted(&[[1.0, 1.0, 0.0, 1.0]]);
        assert_eq!(half.len(), 6);
        let again = [[1.0, 1.0, 0.0, 1.0], [2.0, 2.0, 0.0, 2.0], [1.0, 0.0, 0.0, 1.0], [1.0, 1.0, 1.0, 2.0]];
        assert_eq!(sorted(&again), half);
        assert_eq!(sorted(&[[0.0, 0.0, 0.0, 1.0]]).len(), 8);
    }

    #[test]
    fn flat_parts_have_no_corners() {
        for none in [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, -1.0], [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, -1.0]] {
            assert!(corners(&UNIT, &[none]).is_empty());
        }
    }

    #[test]
    fn many_cuts_of_a_ball_obey_euler() {
        let count = 60;
        let ring = |k: usize| (0.618 * k as f64 * std::f64::consts::TAU, 1.0 - (2 * k + 1) as f64 / count as f64);
        let plane = |(angle, z): (f64, f64)| {
            let across = (1.0 - z * z).sqrt();
            let n = Vector::new(across * angle.cos(), across * angle.sin(), z);
            [n.x, n.y, n.z, 0.4 + n.dot(&Vector::repeat(0.5))]
        };
        let all = corners(&UNIT, &(0..count).map(|k| plane(ring(k))).collect::<Vec<_>>());
        assert_eq!(all.len(), 2 * (count - 2)); // all corners have three faces, and every plane is a face
    }
}
