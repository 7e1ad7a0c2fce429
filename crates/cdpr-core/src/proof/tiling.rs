//! The boxes of a finished decomposition, as a proof lists them.

use super::closing::Regions;
use crate::decomposition::{Closed, Decomposition, Kind};
use crate::geometry::{Cuboid, HalfSpace, Point};

/// A convex polyhedron of positions within the margin of those that a condition forbids.
#[derive(Debug, Clone, PartialEq)]
pub struct ProofRegion {
    /// Index of the condition in the engine's list.
    pub condition: usize,
    /// Half-spaces whose intersection is the polyhedron, which is open.
    pub half_spaces: Vec<HalfSpace>,
}

/// A box of positions and what the proof says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProofBox {
    /// The positions in the box.
    pub positions: Cuboid,
    /// Why the box is closed, if it is.
    pub content: Content,
}

/// Why a box is closed, if it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Content {
    /// The box is open: paths may pass.
    Open,
    /// The box is inside the region with this index.
    Region(usize),
    /// A bound shows that the condition with this index forbids the whole box. Wrenches have the index after the last
    /// condition.
    Bound(usize),
}

/// The boxes of a decomposition, and the regions that close them. Cells that other conditions close count as open.
pub fn tiling(cells: &Decomposition, regions: &Regions, conditions: &[usize]) -> (Vec<ProofRegion>, Vec<ProofBox>) {
    let mut used: Vec<Option<usize>> = vec![None; cells.pieces().len()];
    let mut list = Vec::new();
    let mut content = |kind: Kind, positions: &Cuboid| match kind {
        Kind::Closed(Closed::Bound(condition)) if conditions.contains(&(condition as usize)) => {
            Content::Bound(condition as usize)
        }
        Kind::Closed(Closed::Piece(index)) => {
            let piece = &cells.pieces()[index as usize];
            if !conditions.contains(&piece.condition) {
                return Content::Open;
            }
            let Some(half_spaces) = regions.holding(index, piece, positions) else {
                return Content::Bound(piece.condition);
            };
            let region = used[index as usize].get_or_insert_with(|| {
                list.push(ProofRegion { condition: piece.condition, half_spaces: half_spaces.to_vec() });
                list.len() - 1
            });
            Content::Region(*region)
        }
        _ => Content::Open,
    };
    let boxes = cells.leaves().map(|cell| {
        let positions = cells.span(cell);
        ProofBox { positions, content: content(cells.kind(cell), &positions) }
    });
    let boxes = boxes.collect();
    (list, boxes)
}

/// The open boxes that are connected with a position, and the closed ones that touch these, by index. `boxes` are those of
/// [`tiling`].
pub fn around(position: &Point, cells: &Decomposition, boxes: &[ProofBox]) -> (Vec<usize>, Vec<usize>) {
    let leaves: Vec<u32> = cells.leaves().collect();
    let mut open = vec![false; leaves.iter().max().map_or(0, |last| *last as usize + 1)];
    for (&leaf, of) in leaves.iter().zip(boxes) {
        open[leaf as usize] = of.content == Content::Open;
    }
    let reached = cells.reached(cells.cell_at(position), &|cell| open[cell as usize]);
    let inside = |index: &usize| reached.inside[leaves[*index] as usize];
    let beside = |index: &usize| !open[leaves[*index] as usize] && reached.touched[leaves[*index] as usize];
    ((0..leaves.len()).filter(inside).collect(), (0..leaves.len()).filter(beside).collect())
}
