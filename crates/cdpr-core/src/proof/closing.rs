//! Which positions a proof may call forbidden: those within the margin of a forbidden one.

use std::sync::OnceLock;

use nalgebra::{DMatrix, DVector};

use crate::collision::{Checker, Conditions, Piece, Polyhedron};
use crate::conditions::PhysicalCondition;
use crate::decomposition::Oracle;
use crate::geometry::{Aabb, Cuboid, HalfSpace, Point, Vector, convex_mesh};
use crate::tolerances::{BOUND_MARGIN, PROOF_MARGIN, PROOF_MARGIN_USED, ROUNDING, TOUCH_DEPTH, TOUCHING_END};

/// Which positions a proof calls forbidden, besides those that are forbidden.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Beyond {
    /// Positions within [`PROOF_MARGIN`] of forbidden ones. Pairs that touch at both ends may touch everywhere, and
    /// pairs that touch at one end may touch near it.
    ProofMargin,
    /// Positions within [`BOUND_MARGIN`] of forbidden ones. Pairs that touch at either end may touch everywhere.
    BoundMargin,
    /// No others.
    Nothing,
}

impl Beyond {
    /// The margin within which positions count as forbidden, m.
    pub fn margin(self) -> f64 {
        match self {
            Beyond::ProofMargin => PROOF_MARGIN,
            Beyond::BoundMargin => BOUND_MARGIN,
            Beyond::Nothing => 0.0,
        }
    }

    /// How far regions and bounds reach beyond what is forbidden, m; negative where contact does not count either.
    fn reach(self) -> f64 {
        match self {
            Beyond::ProofMargin | Beyond::BoundMargin => self.margin() * PROOF_MARGIN_USED,
            Beyond::Nothing => CONTACT,
        }
    }
}

/// How far beyond forbidden positions those are that are deeper in them than contact, m.
const CONTACT: f64 = -2.0 * TOUCH_DEPTH;

/// Attempts to widen a polyhedron with sharp corners.
const ATTEMPTS: usize = 4;

/// Decides which cells are closed.
#[derive(Clone)]
pub struct Regions<'a> {
    checker: &'a dyn Checker,
    /// Whether all conditions of the engine count, so that it can judge motions.
    complete: bool,
    beyond: Beyond,
    bounds: Cuboid,
    /// Error of a height over a plane, m.
    rounding: f64,
    /// For each piece, its region once it is needed; `None` if it has none.
    regions: Vec<OnceLock<Option<Vec<HalfSpace>>>>,
    /// For each condition, how far beyond the forbidden positions its regions and bounds reach, m.
    reach: Vec<f64>,
    /// Conditions whose forbidden positions no piece describes.
    without_piece: Vec<usize>,
    /// Cells that touch these are not closed.
    kept_open: Vec<Cuboid>,
}

impl<'a> Regions<'a> {
    /// The regions of the pieces of an engine, and of its conditions without pieces.
    pub fn new(checker: &'a dyn Checker, bounds: Cuboid, pieces: &[Piece], beyond: Beyond) -> Self {
        let conditions = checker.conditions();
        let mut has_piece = vec![false; conditions.list.len()];
        pieces.iter().for_each(|piece| has_piece[piece.condition] = true);
        let loose = |index: &usize| {
            let condition = conditions.list[*index].details();
            let seam = condition.closes_seam(&conditions.bodies);
            !seam && (!has_piece[*index] || condition.exceeds_pieces())
        };
        Regions {
            checker,
            complete: true,
            beyond,
            bounds,
            rounding: ROUNDING * (bounds.low.coords.abs().sup(&bounds.high.coords.abs()).norm() + 1.0) + 1e-12,
            reach: vec![beyond.reach(); conditions.list.len()],
            regions: pieces.iter().map(|_| OnceLock::new()).collect(),
            without_piece: (1..conditions.list.len()).filter(loose).collect(),
            kept_open: Vec::new(),
        }
    }

    /// These regions for paths between two ends. Contact that exists at both ends is allowed everywhere on a path: with
    /// a floor that the platform slides on, for example, or between cables whose ends are no farther apart than
    /// required. Contact that exists at only one end is allowed near that end.
    pub fn between(mut self, pieces: &[Piece], ends: [&Point; 2]) -> Self {
        let touched = ends.map(|end| self.touched(pieces, end));
        let everywhere = |condition: &usize| match self.beyond {
            Beyond::ProofMargin => touched.iter().all(|touched| touched.contains(condition)),
            Beyond::BoundMargin | Beyond::Nothing => true,
        };
        let allowed: Vec<usize> = touched.iter().flatten().copied().filter(everywhere).collect();
        for condition in allowed {
            self.reach[condition] = CONTACT;
        }
        self.regions = pieces.iter().map(|_| OnceLock::new()).collect();
        for (end, touched) in ends.into_iter().zip(&touched) {
            if touched.iter().any(|&condition| self.reach[condition] > 0.0) {
                let around = Vector::repeat(TOUCHING_END);
                self.kept_open.push(Cuboid::new(end - around, end + around));
            }
        }
        self
    }

    /// These regions if only the conditions for whose index `known` is true count.
    pub fn knowing(&self, known: &dyn Fn(usize) -> bool) -> Self {
        Regions {
            checker: self.checker,
            regions: self.regions.clone(),
            reach: self.reach.clone(),
            without_piece: self.without_piece.iter().copied().filter(|&condition| known(condition)).collect(),
            kept_open: self.kept_open.clone(),
            complete: (0..self.reach.len()).all(known),
            ..*self
        }
    }

    /// The conditions that a position breaks or nearly breaks.
    fn touched(&self, pieces: &[Piece], position: &Point) -> Vec<usize> {
        let at = Cuboid::new(*position, *position);
        let by_piece = pieces.iter().enumerate().filter(|(index, piece)| self.closes(*index as u32, piece, &at));
        let by_bound = self.without_piece.iter().copied().filter(|&condition| self.forbids_all(condition, &at));
        by_piece.map(|(_, piece)| piece.condition).chain(by_bound).collect()
    }

    /// The polyhedron of a piece in which all positions are within the margin of forbidden ones.
    fn region(&self, index: u32, piece: &Piece) -> Option<&[HalfSpace]> {
        let region = self.regions[index as usize].get_or_init(|| self.widened(piece));
        region.as_deref()
    }

    /// The region of a piece, if it holds a cell.
    pub fn holding(&self, index: u32, piece: &Piece, cell: &Cuboid) -> Option<&[HalfSpace]> {
        let inside = |planes: &[HalfSpace], by: f64| planes.iter().all(|plane| cell.highest(plane) < by);
        piece.certain.as_ref().filter(|certain| inside(certain, self.beyond.reach()))?;
        self.region(index, piece).filter(|planes| inside(planes, -self.rounding))
    }

    /// The polyhedron of certainly forbidden positions, widened as far as its corners stay within the margin.
    fn widened(&self, piece: &Piece) -> Option<Vec<HalfSpace>> {
        let certain = piece.certain.as_ref()?;
        let reach = self.reach[piece.condition];
        Some(if reach < 0.0 {
            certain.clone()
        } else {
            widened(self.checker, piece.condition, certain, &self.bounds, reach)
        })
    }

    fn condition(&self, piece: &Piece) -> &dyn PhysicalCondition {
        self.checker.conditions().list[piece.condition].details()
    }

    /// Whether a cell touches the surroundings of an end that must stay open.
    fn is_kept_open(&self, cell: &Cuboid) -> bool {
        self.kept_open.iter().any(|around| around.touches(cell))
    }
}

/// A polyhedron of certainly forbidden positions, with its planes moved outward so far that all its positions are within a
/// distance of forbidden ones.
fn widened(
    checker: &dyn Checker,
    condition: usize,
    certain: &[HalfSpace],
    bounds: &Cuboid,
    reach: f64,
) -> Vec<HalfSpace> {
    if checker.conditions().list[condition].details().ends_on_body() {
        return moved(certain, reach / mitre(certain));
    }
    let mut by = reach;
    for _ in 0..ATTEMPTS {
        let region = moved(certain, by);
        let Some(farthest) = farthest(checker, condition, &region, bounds) else { break };
        if farthest <= reach {
            return region;
        }
        by *= (PROOF_MARGIN_USED * reach / farthest).min(0.5);
    }
    certain.to_vec()
}

fn moved(planes: &[HalfSpace], by: f64) -> Vec<HalfSpace> {
    planes.iter().map(|plane| plane.widened(by)).collect()
}

/// How far the corners of a region are from what a condition forbids, m; `None` if there are none in the box.
fn farthest(checker: &dyn Checker, condition: usize, region: &[HalfSpace], bounds: &Cuboid) -> Option<f64> {
    let Conditions { bodies, list, .. } = checker.conditions();
    let body = convex_mesh(region, &Aabb { min: bounds.low, max: bounds.high })?;
    let slack = |corner: &Point| list[condition].details().slack(bodies, corner);
    Some(body.vertices.iter().map(slack).fold(f64::NEG_INFINITY, f64::max))
}

/// Corners at which moved planes meet farther out than this times their own movement are sharp.
const SHARPNESS: f64 = 4.0;

/// The planes of a certainly forbidden polyhedron, moved outward so far that all positions inside are within [`BOUND_MARGIN`] of
/// forbidden ones; not moved if it has sharp corners or one of the ends touches it. All polyhedra are moved by the same
/// distance, so that faces and edges that coincide still do.
pub fn widened_evenly(checker: &dyn Checker, polyhedron: &Polyhedron, ends: [&Point; 2]) -> Vec<HalfSpace> {
    let Polyhedron { condition, half_spaces: certain, .. } = polyhedron;
    let Conditions { bodies, list, .. } = checker.conditions();
    let details = list[*condition].details();
    let touches = |end: &&Point| {
        let is_near = !details.ends_on_body() && details.slack(bodies, end) < 2.0 * BOUND_MARGIN;
        is_near || certain.iter().all(|plane| plane.height(end) < 2.0 * BOUND_MARGIN)
    };
    let region = moved(certain, BOUND_MARGIN / SHARPNESS);
    let within_margin = || {
        if details.ends_on_body() {
            return mitre(&region) <= SHARPNESS;
        }
        let (low, high) = checker.conditions().position_box();
        farthest(checker, *condition, &region, &Cuboid::new(low, high)).is_some_and(|farthest| farthest < BOUND_MARGIN)
    };
    if !ends.iter().any(touches) && within_margin() { region } else { certain.clone() }
}

/// Distance by which the corner of a cone moves if its planes move outward by 1; infinite if they are dependent.
fn mitre(planes: &[HalfSpace]) -> f64 {
    let normals = DMatrix::from_fn(planes.len(), 3, |row, axis| planes[row].normal[axis]);
    let ones = DVector::from_element(planes.len(), 1.0);
    let shift = normals.clone().pseudo_inverse(1e-6).map(|inverse| inverse * &ones);
    match shift {
        Ok(shift) if (&normals * &shift - &ones).norm() < 1e-9 => shift.norm().max(1.0),
        _ => f64::INFINITY,
    }
}

impl Oracle for Regions<'_> {
    fn free(&self, from: &Point, to: &Point) -> bool {
        !self.complete || self.checker.motion_valid(from, to)
    }

    fn reaches(&self, piece: &Piece, cell: &Cuboid) -> bool {
        let outside = piece.outer.iter().any(|plane| cell.lowest(plane) >= 0.0);
        let condition = self.condition(piece);
        // The polyhedron around a rounded one exceeds it by so much that narrow passages would be closed.
        let is_loose = piece.certain.is_none() || condition.is_rounded();
        !(outside || is_loose && condition.allows_all(&self.checker.conditions().bodies, cell))
    }

    fn closes(&self, index: u32, piece: &Piece, cell: &Cuboid) -> bool {
        // A body that closes a seam has no name of its own; the parts beside it close the cells instead.
        if self.condition(piece).closes_seam(&self.checker.conditions().bodies) {
            return false;
        }
        let bound = piece.certain.is_none() || self.condition(piece).is_rounded();
        let closed = self.holding(index, piece, cell).is_some() || bound && self.forbids_all(piece.condition, cell);
        closed && !self.is_kept_open(cell)
    }

    fn closed_by_bound(&self, cell: &Cuboid) -> Option<u32> {
        let found = self.without_piece.iter().copied().find(|&index| self.forbids_all(index, cell));
        let besides = || self.checker.lacking_wrench(cell).map(|_| self.checker.conditions().list.len());
        found.or_else(besides).filter(|_| !self.is_kept_open(cell)).map(|index| index as u32)
    }
}

impl Regions<'_> {
    /// Whether a bound shows that a condition forbids a whole cell.
    pub fn forbids_all(&self, condition: usize, cell: &Cuboid) -> bool {
        let Conditions { bodies, list, .. } = self.checker.conditions();
        list[condition].details().forbids_all(bodies, cell, self.reach[condition])
    }
}
