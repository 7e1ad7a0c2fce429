//! How much of an undecided box is certainly valid, and how much certainly forbidden, by the volumes that convex pieces cut off.
//!
//! Boxes on the surface of what is forbidden are never decided, however small. If only convex pieces reach into a box, all of it
//! but the sum of these pieces is valid, and the largest of their certainly forbidden parts is forbidden. Bounds of the slack of
//! wrenches cut off half-spaces likewise. For a box that one flat face crosses, the two are almost the whole box.

use super::judge::{Judge, Open};
use crate::geometry::{Aabb, Cuboid, HalfSpace, convex_mesh};
use crate::tolerances::TOUCH_DEPTH;

/// Volumes of parts of a box, m³.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Cut {
    /// Certainly valid.
    pub valid: f64,
    /// Certainly forbidden, by the condition with this index.
    pub forbidden: Option<(u32, f64)>,
}

/// What is certain about parts of a box in which `open` is not excluded.
pub fn cut(judge: &Judge, positions: &Cuboid, open: &Open) -> Cut {
    let (sufficing, lacking) = judge.wrench_cuts(positions, open);
    let held = sufficing.filter(|_| judge.only_pieces(open)).map(|planes| inside(&planes, positions)[0]);
    let mut free = held.filter(|free| *free > 0.0);
    let mut forbidden: Option<(u32, f64)> = None;
    let mut forbids = |condition: u32, volume: f64| {
        if volume > forbidden.map_or(0.0, |(_, known)| known) {
            forbidden = Some((condition, volume));
        }
    };
    for piece in judge.pieces(open) {
        let [_, most] = inside(&piece.outer, positions);
        free = free.map(|free| (free - most).max(0.0)).filter(|free| *free > 0.0);
        let certain = piece.certain.as_ref().filter(|_| judge.names(piece.condition));
        forbids(piece.condition as u32, certain.map_or(0.0, |certain| inside(certain, positions)[0]));
    }
    lacking.into_iter().for_each(|plane| forbids(judge.wrench(), inside(&[plane], positions)[0]));
    Cut { valid: free.unwrap_or(0.0), forbidden }
}

/// Bounds of the volume of a box that lies in all half-spaces. Each cut may move corners by [`TOUCH_DEPTH`], and leaves out what is
/// no thicker.
fn inside(half_spaces: &[HalfSpace], positions: &Cuboid) -> [f64; 2] {
    let Cuboid { low: min, high: max, half, .. } = *positions;
    let area = 8.0 * (half.x * half.y + half.y * half.z + half.z * half.x);
    let error = (half_spaces.len() + 1) as f64 * TOUCH_DEPTH * area;
    let volume = convex_mesh(half_spaces, &Aabb { min, max }).map_or(0.0, |mesh| mesh.volume());
    [(volume - error).max(0.0), volume + error]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Vector};

    #[test]
    fn the_volume_below_a_plane_is_bracketed() {
        let cube = Cuboid::new(Point::origin(), Point::new(1.0, 1.0, 1.0));
        let below = |normal: Vector, height: f64| HalfSpace::through(&(Point::origin() + normal * height), normal);
        let corner = below(Vector::repeat(1.0).normalize(), 1.0 / f64::sqrt(3.0));
        let slit = [below(Vector::z(), 0.5), below(-Vector::z(), -0.5)];
        for (planes, volume) in
            [(vec![], 1.0), (vec![below(Vector::z(), 0.25)], 0.25), (vec![corner], 1.0 / 6.0), (slit.to_vec(), 0.0)]
        {
            let [least, most] = inside(&planes, &cube);
            assert!(least <= volume && volume <= most && most - least < 1e-6, "{volume}: {least} {most}");
        }
    }
}
