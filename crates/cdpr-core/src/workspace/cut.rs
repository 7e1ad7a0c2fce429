//! How much of an undecided box is certainly valid, and how much certainly forbidden, by the volumes that convex pieces cut off.
//!
//! Boxes on the surface of what is forbidden are never decided, however small. If only convex pieces reach into a box, all of it
//! but their union is valid, and the largest of their certainly forbidden parts is forbidden. Bounds of the slack of
//! wrenches cut off half-spaces likewise. For a box that one flat face crosses, the two are almost the whole box.

use super::judge::{Judge, Open};
use crate::collision::Piece;
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
    let pieces: Vec<&Piece> = judge.pieces(open).collect();
    let valid = match held {
        Some(held) if held > 0.0 => {
            let outer: Vec<&[HalfSpace]> = pieces.iter().map(|piece| piece.outer.as_slice()).collect();
            (held - of_union(&outer, positions)).max(0.0)
        }
        _ => 0.0,
    };
    let named = pieces.iter().filter(|piece| judge.names(piece.condition));
    let certain =
        named.filter_map(|piece| Some((piece.condition as u32, inside(piece.certain.as_ref()?, positions)[0])));
    let wrench = lacking.into_iter().map(|plane| (judge.wrench(), inside(&[plane], positions)[0]));
    let forbidden =
        certain.chain(wrench).filter(|(_, volume)| *volume > 0.0).reduce(|a, b| if b.1 > a.1 { b } else { a });
    Cut { valid, forbidden }
}

/// An upper bound of the volume of a box that lies in any of some polyhedra: the sum of their volumes, less what each has in common
/// with one before it (D. Hunter, "An upper bound for the probability of a union", Journal of Applied Probability 13, 1976).
fn of_union(polyhedra: &[&[HalfSpace]], positions: &Cuboid) -> f64 {
    let added = |k: usize| {
        let common = |before: &&[HalfSpace]| inside(&[before, polyhedra[k]].concat(), positions)[0];
        let most = inside(polyhedra[k], positions)[1];
        let largest = polyhedra[..k.min(MOST_PAIRS)].iter().map(common).fold(0.0, f64::max);
        (most - largest).max(0.0)
    };
    (0..polyhedra.len()).map(added).sum()
}

/// Number of polyhedra with which each is intersected.
const MOST_PAIRS: usize = 4;

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

    #[test]
    fn what_two_polyhedra_have_in_common_counts_once() {
        let cube = Cuboid::new(Point::origin(), Point::new(1.0, 1.0, 1.0));
        let below = |axis: usize| vec![HalfSpace::through(&Point::new(0.5, 0.5, 0.5), Vector::ith(axis, 1.0))];
        let (x, y, z) = (below(0), below(1), below(2));
        assert!((of_union(&[&x], &cube) - 0.5).abs() < 1e-6);
        assert!((of_union(&[&x, &y], &cube) - 0.75).abs() < 1e-6);
        let three = of_union(&[&x, &y, &z], &cube);
        assert!((0.875..=1.0 + 1e-6).contains(&three), "{three}");
    }
}
