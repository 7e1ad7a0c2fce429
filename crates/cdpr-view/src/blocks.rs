//! Unions of boxes on a grid, and their outer faces, merged into few rectangles.

use cdpr_core::geometry::{Cuboid, Point, Vector};

/// Label of a cube that belongs to nothing.
const EMPTY: u16 = 0;

/// A rectangle of the outer surface: its direction (twice the axis, plus one on the side of larger coordinates), its
/// place along this axis, and its extent along the next axis and the one after that, in cubes.
pub(super) type Face = [u16; 6];

/// How boxes that cut through cubes are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cut {
    /// A cube belongs to the box that its centre is in: unions keep their size.
    AtCentres,
    /// A cube belongs to every box that reaches into it: thin walls keep no holes.
    Outwards,
}

/// Maximum number of faces on a page, which keeps them below 1 MB; with more of them the cubes become larger.
const MOST_FACES: usize = 40_000;
/// Numbers of cubes along each axis, finest first. With the coarsest there can never be too many faces.
pub(super) const COUNTS: [usize; 4] = [128, 64, 32, 16];

/// Surfaces in cubes, as many of them along each axis as keep the page small; and that number.
pub(super) fn as_fine_as_allowed<T>(surfaces: impl Fn(usize) -> T, faces: impl Fn(&T) -> usize) -> (usize, T) {
    let found = COUNTS.into_iter().map(|count| (count, surfaces(count))).find(|(_, found)| faces(found) <= MOST_FACES);
    found.expect("16 cubes along each axis have at most 25 000 faces")
}

/// A box divided into equally many parts along each axis, each with a label.
pub(super) struct Blocks {
    low: Point,
    parts: Vector,
    count: usize,
    labels: Vec<u16>,
}

impl Blocks {
    /// Empty blocks, `count` along each axis.
    pub(super) fn new(bounds: &Cuboid, count: usize) -> Self {
        let parts = (bounds.high - bounds.low) / count as f64;
        Blocks { low: bounds.low, parts, count, labels: vec![EMPTY; count * count * count] }
    }

    /// Gives the cubes of a box a label from 1.
    pub(super) fn paint(&mut self, positions: &Cuboid, cut: Cut, label: u16) {
        let [x, y, z] = std::array::from_fn(|axis| self.range(positions, cut, axis));
        for i in x {
            for j in y.clone() {
                for k in z.clone() {
                    let cube = self.cube([i, j, k]);
                    self.labels[cube] = label;
                }
            }
        }
    }

    /// The cubes of a box along an axis.
    fn range(&self, positions: &Cuboid, cut: Cut, axis: usize) -> std::ops::Range<usize> {
        // Far more than rounding, and far less than anyone could see.
        const NEARLY: f64 = 1e-6;
        let at = |place: &Point| (place[axis] - self.low[axis]) / self.parts[axis];
        let (low, high) = match cut {
            Cut::AtCentres => (at(&positions.low).round(), at(&positions.high).round()),
            Cut::Outwards => ((at(&positions.low) + NEARLY).floor(), (at(&positions.high) - NEARLY).ceil()),
        };
        let index = |cubes: f64| (cubes.max(0.0) as usize).min(self.count);
        index(low)..index(high)
    }

    fn cube(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.count + j) * self.count + k
    }

    /// For each cube, whether a labelled cube is at most this many cubes away along each axis.
    pub(super) fn near(&self, cubes: usize) -> Vec<bool> {
        let mut near: Vec<bool> = self.labels.iter().map(|label| *label != EMPTY).collect();
        for stride in [1, self.count, self.count * self.count] {
            let before = near.clone();
            for cube in (0..near.len()).filter(|cube| before[*cube]) {
                let along = cube / stride % self.count;
                let (back, ahead) = (along.min(cubes), (self.count - 1 - along).min(cubes));
                (cube - back * stride..=cube + ahead * stride).step_by(stride).for_each(|other| near[other] = true);
            }
        }
        near
    }

    /// Empties all cubes but these.
    pub(super) fn keep(&mut self, cubes: &[bool]) {
        self.labels.iter_mut().zip(cubes).filter(|(_, kept)| !**kept).for_each(|(label, _)| *label = EMPTY);
    }

    /// The outer faces of everything that has a label, by label.
    pub(super) fn faces(&self, labels: usize) -> Vec<Vec<Face>> {
        let mut found = vec![Vec::new(); labels];
        for direction in 0..6 {
            for layer in 0..self.count {
                let mut skin = self.skin(direction, layer);
                for (label, rectangle) in rectangles(&mut skin, self.count) {
                    let at = layer + direction % 2;
                    let [u0, u1, v0, v1] = rectangle.map(|x| x as u16);
                    found[usize::from(label) - 1].push([direction as u16, at as u16, u0, u1, v0, v1]);
                }
            }
        }
        found
    }

    /// The labels of a layer of cubes where they are seen from a direction.
    fn skin(&self, direction: usize, layer: usize) -> Vec<u16> {
        let (axis, ahead) = (direction / 2, direction % 2 == 1);
        let next = if ahead { Some(layer + 1).filter(|next| *next < self.count) } else { layer.checked_sub(1) };
        let label = |layer: usize, cell: usize| {
            let mut place = [0; 3];
            (place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]) = (layer, cell / self.count, cell % self.count);
            self.labels[self.cube(place)]
        };
        let hidden = |cell: usize| next.is_some_and(|next| label(next, cell) != EMPTY);
        (0..self.count * self.count).map(|cell| if hidden(cell) { EMPTY } else { label(layer, cell) }).collect()
    }
}

/// Divides a square of labels into rectangles of one label each, and empties it: as wide as possible, then as high.
fn rectangles(skin: &mut [u16], count: usize) -> Vec<(u16, [usize; 4])> {
    let mut found = Vec::new();
    for cell in 0..skin.len() {
        let label = skin[cell];
        if label == EMPTY {
            continue;
        }
        let (u, v) = (cell / count, cell % count);
        let width = skin[cell..(u + 1) * count].iter().take_while(|other| **other == label).count();
        let row = |u: usize| u * count + v..u * count + v + width;
        let end = (u..count).find(|&u| skin[row(u)].iter().any(|other| *other != label)).unwrap_or(count);
        (u..end).for_each(|u| skin[row(u)].fill(EMPTY));
        found.push((label, [u, end, v, v + width]));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cuboid(low: [f64; 3], high: [f64; 3]) -> Cuboid {
        Cuboid::new(low.into(), high.into())
    }

    fn eight(paint: impl Fn(&mut Blocks)) -> Vec<Vec<Face>> {
        let mut blocks = Blocks::new(&cuboid([0.0; 3], [8.0; 3]), 8);
        paint(&mut blocks);
        blocks.faces(2)
    }

    #[test]
    fn a_box_has_six_faces_however_many_cubes_it_has() {
        let found = eight(|blocks| blocks.paint(&cuboid([1.0, 2.0, 3.0], [4.0, 6.0, 8.0]), Cut::AtCentres, 1));
        let faces =
            [[0, 1, 2, 6, 3, 8], [1, 4, 2, 6, 3, 8], [2, 2, 3, 8, 1, 4], [3, 6, 3, 8, 1, 4], [4, 3, 1, 4, 2, 6]];
        assert_eq!((&found[0][..5], found[0].len(), found[1].len()), (&faces[..], 6, 0));
    }

    #[test]
    fn nothing_is_drawn_between_boxes_that_touch() {
        let halves = [cuboid([0.0; 3], [4.0, 8.0, 8.0]), cuboid([4.0, 0.0, 0.0], [8.0; 3])];
        let one = eight(|blocks| halves.iter().for_each(|half| blocks.paint(half, Cut::Outwards, 1)));
        assert_eq!((one[0].len(), one[1].len()), (6, 0));
        let two =
            eight(|blocks| halves.iter().zip(1..).for_each(|(half, label)| blocks.paint(half, Cut::Outwards, label)));
        assert_eq!((two[0].len(), two[1].len()), (5, 5));
    }

    #[test]
    fn thin_boxes_vanish_or_become_as_thick_as_a_cube() {
        let thin = cuboid([2.1, 0.0, 0.0], [2.2, 8.0, 8.0]);
        assert!(eight(|blocks| blocks.paint(&thin, Cut::AtCentres, 1))[0].is_empty());
        let kept = eight(|blocks| blocks.paint(&thin, Cut::Outwards, 1));
        assert_eq!(kept[0].iter().map(|face| face[1]).collect::<Vec<_>>(), [2, 3, 0, 8, 0, 8]);
    }

    #[test]
    fn boxes_are_cut_off_at_a_distance() {
        let mut open = Blocks::new(&cuboid([0.0; 3], [8.0; 3]), 8);
        open.paint(&cuboid([0.0, 3.0, 0.0], [1.0, 4.0, 1.0]), Cut::AtCentres, 1);
        let kept = eight(|blocks| {
            blocks.paint(&cuboid([1.0, 0.0, 0.0], [8.0; 3]), Cut::AtCentres, 1);
            blocks.keep(&open.near(2));
        });
        assert_eq!(kept[0].iter().map(|face| face[1]).collect::<Vec<_>>(), [1, 3, 1, 6, 0, 3]);
    }

    #[test]
    fn boxes_within_a_cube_fill_it_together() {
        let found = eight(|blocks| {
            for part in 0..4 {
                let low = 2.0 + 0.25 * f64::from(part);
                blocks.paint(&cuboid([low, 0.0, 0.0], [low + 0.25, 1.0, 1.0]), Cut::AtCentres, 1);
            }
        });
        assert_eq!(found[0].len(), 6);
    }
}
