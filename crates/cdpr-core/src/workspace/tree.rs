//! A box of positions, divided into ever smaller boxes: an octree, or a quadtree if the box is flat.
//!
//! All boxes of one depth have the same sides. A box is halved along those of its axes that are almost as long as the longest
//! one, so that boxes become about as high as they are wide.

use crate::geometry::{Cuboid, Point, Vector};
use crate::limits::WORKSPACE_HALVINGS;
use crate::tolerances::FLAT;

/// An axis is halved together with the longest one if it is at least this share of it.
const ABOUT_AS_LONG: f64 = 0.7;

/// The whole box.
pub const WHOLE: u32 = 0;

/// What is known about a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Nothing yet.
    Undecided,
    /// All its positions are valid.
    Inside,
    /// The condition with this index forbids all its positions; wrenches have the index after the last.
    Outside(u32),
    /// It is divided; the index of the first part.
    Divided(u32),
}

#[derive(Debug, Clone, Copy)]
struct Node {
    depth: u8,
    /// Place among the boxes of its depth, along each axis.
    at: [u32; 3],
    kind: Kind,
}

/// A box and its parts.
#[derive(Debug, Clone)]
pub struct Tree {
    low: Point,
    size: Vector,
    /// For each depth, how often each axis has been halved.
    halved: Vec<[u8; 3]>,
    nodes: Vec<Node>,
}

impl Tree {
    /// The undivided box between two corners. Its parts are divided until their sides are at most `finest`, m.
    pub fn new(low: Point, high: Point, finest: f64) -> Self {
        let size = high - low;
        let mut halved = vec![[0; 3]];
        loop {
            let last = halved[halved.len() - 1];
            let side = |axis: usize| if size[axis] > FLAT { half_powers(size[axis], last[axis]) } else { 0.0 };
            let longest = (0..3).map(side).fold(0.0, f64::max);
            if longest <= finest || last.contains(&WORKSPACE_HALVINGS) {
                break;
            }
            halved.push(std::array::from_fn(|axis| last[axis] + u8::from(side(axis) >= ABOUT_AS_LONG * longest)));
        }
        Tree { low, size, halved, nodes: vec![Node { depth: 0, at: [0; 3], kind: Kind::Undecided }] }
    }

    /// Number of axes along which the box extends.
    pub fn dimension(&self) -> usize {
        self.size.iter().filter(|size| **size > FLAT).count()
    }

    /// The sides of the boxes at a depth, m.
    fn sides(&self, depth: u8) -> Vector {
        Vector::from_fn(|axis, _| half_powers(self.size[axis], self.halved[usize::from(depth)][axis]))
    }

    /// Volume of a box: m³, or m² or m if the whole box is flat.
    pub fn volume(&self, node: u32) -> f64 {
        self.volume_at(self.nodes[node as usize].depth)
    }

    /// Volume of the boxes at a depth.
    pub fn volume_at(&self, depth: u8) -> f64 {
        let sides = self.sides(depth);
        (0..3).filter(|axis| self.size[*axis] > FLAT).map(|axis| sides[axis]).product()
    }

    /// Longest side of the smallest boxes, m.
    pub fn finest(&self) -> f64 {
        let deepest = self.nodes.iter().map(|node| node.depth).max();
        deepest.map_or(0.0, |depth| self.sides(depth).max())
    }

    /// The depth of a box.
    pub fn depth(&self, node: u32) -> u8 {
        self.nodes[node as usize].depth
    }

    /// Whether a box is as small as boxes become.
    pub fn is_finest(&self, node: u32) -> bool {
        usize::from(self.depth(node)) + 1 == self.halved.len()
    }

    /// Number of boxes, divided ones included.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// What is known about a box.
    pub fn kind(&self, node: u32) -> Kind {
        self.nodes[node as usize].kind
    }

    /// States what is known about a box.
    pub fn settle(&mut self, node: u32, kind: Kind) {
        self.nodes[node as usize].kind = kind;
    }

    /// The undivided boxes.
    pub fn leaves(&self) -> impl Iterator<Item = u32> {
        let undivided = |node: &u32| !matches!(self.kind(*node), Kind::Divided(_));
        (0..self.nodes.len() as u32).filter(undivided)
    }

    /// The positions of a box; coordinates are equal where boxes touch.
    pub fn span(&self, node: u32) -> Cuboid {
        let Node { depth, at, .. } = self.nodes[node as usize];
        let halved = self.halved[usize::from(depth)];
        let place = |axis: usize, steps: u32| {
            self.low[axis] + self.size[axis] * (f64::from(steps) / f64::from(1u32 << halved[axis]))
        };
        let corner = |beyond: u32| Point::from(Vector::from_fn(|axis, _| place(axis, at[axis] + beyond)));
        let flat = Vector::from_fn(|axis, _| if self.size[axis] > FLAT { 0.0 } else { self.size[axis] });
        let high = corner(1);
        Cuboid::new(corner(0), high.sup(&(corner(0) + flat)))
    }

    /// Divides a box and returns its parts.
    pub fn divide(&mut self, node: u32) -> std::ops::Range<u32> {
        let Node { depth, at, .. } = self.nodes[node as usize];
        let first = self.nodes.len() as u32;
        self.settle(node, Kind::Divided(first));
        let split = self.split(depth);
        let parts = (0..8u32).filter(|part| (0..3).all(|axis| split[axis] || part >> axis & 1 == 0));
        for part in parts {
            let at = std::array::from_fn(|axis| (at[axis] << u32::from(split[axis])) + (part >> axis & 1));
            self.nodes.push(Node { depth: depth + 1, at, kind: Kind::Undecided });
        }
        first..self.nodes.len() as u32
    }

    /// The axes along which boxes of a depth are halved.
    fn split(&self, depth: u8) -> [bool; 3] {
        let [now, next] = [0, 1].map(|more| self.halved[usize::from(depth) + more]);
        std::array::from_fn(|axis| next[axis] > now[axis])
    }

    /// The undivided box beyond a face of a box, if it is at least as large.
    pub fn beyond(&self, node: u32, axis: usize, upward: bool) -> Option<u32> {
        let Node { depth, mut at, .. } = self.nodes[node as usize];
        let halved = self.halved[usize::from(depth)];
        at[axis] = if upward { at[axis] + 1 } else { at[axis].checked_sub(1)? };
        if at[axis] >> halved[axis] != 0 {
            return None;
        }
        let mut found = WHOLE;
        loop {
            let Node { depth: reached, kind, .. } = self.nodes[found as usize];
            let Kind::Divided(first) = kind else { return Some(found) };
            if reached == depth {
                return None;
            }
            let (split, next) = (self.split(reached), self.halved[usize::from(reached) + 1]);
            let mut part = 0;
            let mut place = 1;
            for axis in (0..3).filter(|axis| split[*axis]) {
                part += place * (at[axis] >> (halved[axis] - next[axis]) & 1);
                place *= 2;
            }
            found = first + part;
        }
    }
}

/// A size after some halvings.
fn half_powers(size: f64, halvings: u8) -> f64 {
    size / f64::from(1u32 << halvings)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn divided_twice(high: Point) -> Tree {
        let mut tree = Tree::new(Point::origin(), high, 0.0);
        let parts = tree.divide(WHOLE);
        tree.divide(parts.start + 1);
        tree
    }

    #[test]
    fn parts_tile_the_box_and_know_their_neighbours() {
        for high in [Point::new(2.0, 2.0, 2.0), Point::new(4.0, 1.0, 3.0), Point::new(1.0, 2.0, 0.0)] {
            let tree = divided_twice(high);
            let whole: f64 = tree.leaves().map(|leaf| tree.volume(leaf)).sum();
            assert!((whole - high.iter().filter(|size| **size > 0.0).product::<f64>()).abs() < 1e-12);
            for (leaf, axis, upward) in tree.leaves().flat_map(|leaf| (0..6).map(move |k| (leaf, k / 2, k % 2 == 0))) {
                let (span, found) = (tree.span(leaf), tree.beyond(leaf, axis, upward));
                let mut across = span.center;
                across[axis] += if upward { span.half[axis] + 1e-6 } else { -span.half[axis] - 1e-6 };
                let holds = |other: &u32| {
                    let other = tree.span(*other);
                    (across - other.center).abs().iter().zip(other.half.iter()).all(|(d, half)| d <= half)
                };
                let larger = |other: &u32| tree.depth(*other) <= tree.depth(leaf);
                assert_eq!(found, tree.leaves().filter(holds).find(larger), "{high} {leaf} {axis} {upward}");
            }
        }
    }

    #[test]
    fn boxes_become_about_as_high_as_they_are_wide() {
        let tree = Tree::new(Point::origin(), Point::new(15.0, 11.0, 6.0), 0.1);
        let sides = tree.sides(tree.halved.len() as u8 - 1);
        assert!(sides.max() <= 0.1 && sides.max() / sides.min() < 2.0, "{sides}");
        assert_eq!(Tree::new(Point::origin(), Point::new(1.0, 1.0, 0.0), 0.25).halved, [[0; 3], [1, 1, 0], [2, 2, 0]]);
        assert_eq!(Tree::new(Point::origin(), Point::origin(), 0.0).halved.len(), 1);
    }
}
