//! The fast, exact engine: a scene compiled to convex polyhedra in the space of positions.
//!
//! At a fixed orientation, a motion is a straight segment p(t) of positions, and a condition forbids a convex
//! polyhedron of positions ([`crate::conditions::region`]). A motion is valid if its segment, clipped against the
//! planes (`clip`), misses all polyhedra; a `grid` over the positions lists those that it can meet. Each polyhedron is
//! bracketed by two: one certainly contains the forbidden set, the other certainly lies inside it. The gjk engine
//! decides only between the two (in contact, at the rounded edges of a clearance, where two cables cross). The answers
//! are thus those of the gjk engine, at the cost of a few multiplications.
//!
//! A state is a motion of zero length. Explanations and distances are those of the gjk engine, in the world: a depth
//! within a shadow is not a physical distance. Longer motions first test the inner polyhedron of the region that last
//! rejected a motion. This hint, a relaxed atomic, is the only mutable state of an engine, and it never changes an answer.

mod grid;
mod segment_clip;

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use super::along::either_way;
use super::clearance::{self, Clearance};
use super::explain;
use super::gjk_engine::GjkEngine;
use super::validity::{Checker, Validity};
use super::violation::Violation;
use crate::conditions::{
    Condition, Conditions, Fattened, Inner, Interference, KeptPolyhedra, Piece, Polyhedron, Region, Scale,
};
use crate::error::Error;
use crate::geometry::{Cuboid, Point, Vector};
use crate::model::Scene;
use crate::simd::{INTEGERS, Kernel, Lanes, Task};
use crate::tolerances::TOUCH_DEPTH;
use crate::watch::Watch;
use grid::{Cells, FULL, Lists, Reached};
use segment_clip::{CoarsePlace, Planes, Segment, not_outside};

/// Checks the conditions of a scene at its orientation by clipping segments in the space of positions.
///
/// # Example
/// ```
/// use cdpr_core::{Interference, Validity, collision::CspaceEngine};
/// use cdpr_core::{Point, testing};
/// let engine = CspaceEngine::new(&testing::hard1(), Interference::Exact)?;
/// assert!(engine.motion_valid(&Point::new(0.3, 1.0, 0.3), &Point::new(0.3, 1.0, 0.8)));
/// assert!(!engine.motion_valid(&Point::new(0.3, 1.0, 0.3), &Point::new(1.7, 1.0, 1.7)));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug)]
pub struct CspaceEngine {
    reference: GjkEngine,
    forbidden: KeptPolyhedra,
    scale: Scale,
    /// The compiled regions of each condition, kept for [`CspaceEngine::recompiled`].
    compiled: Vec<Arc<[Compiled]>>,
    /// Planes of the outer polyhedron of each region, stored separately to stay in the cache.
    outer: Vec<Range<u32>>,
    /// Inner polyhedron and condition of each region.
    heads: Vec<Head>,
    /// The regions of each condition.
    regions_of: Vec<Range<usize>>,
    /// The conditions that motions can break outside all regions.
    beyond_regions: Vec<usize>,
    planes: Planes,
    cells: Cells,
    lists: Lists,
    /// The box of positions inside the workspace.
    low: Point,
    high: Point,
    kernel: Kernel,
    /// The region that last rejected a motion; it often rejects the next one as well. It never changes an answer.
    last_refuser: AtomicU32,
}

/// A region and the cells it overlaps.
#[derive(Debug, Clone, PartialEq)]
struct Compiled {
    region: Region,
    reached: Vec<Reached>,
}

/// Decides about motions that meet the outer polyhedron of a region.
#[derive(Debug, Clone)]
struct Head {
    /// Index of the condition that the region belongs to.
    condition: usize,
    /// Planes of the inner polyhedron.
    inner: Range<u32>,
    /// How far the planes of `inner` are moved outward, m; `None` if there is no inner polyhedron.
    widen: Option<f64>,
}

impl CspaceEngine {
    /// The engine for a scene.
    ///
    /// # Errors
    /// The errors of [`Conditions::new`].
    pub fn new(scene: &Scene, interference: Interference) -> Result<Self, Error> {
        Self::within(scene, interference, &Watch::NONE)
    }

    /// The engine for a scene, compiled within a watch.
    ///
    /// # Errors
    /// The errors of [`Conditions::new`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn within(scene: &Scene, interference: Interference, watch: &Watch) -> Result<Self, Error> {
        let reference = GjkEngine::within(scene, interference, watch)?;
        Self::compile(reference, |_| None, watch)
    }

    /// The engine for a scene that differs little from this engine's scene; unchanged conditions are not compiled
    /// again.
    ///
    /// # Errors
    /// The errors of [`Conditions::new`]; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn recompiled(&self, scene: &Scene, watch: &Watch) -> Result<Self, Error> {
        let reference = GjkEngine::within(scene, self.reference.interference(), watch)?;
        let (old, new) = (self.reference.conditions(), reference.conditions());
        let scale = new.scale();
        let same_frame = old.bodies.cables == new.bodies.cables
            && old.bodies.platform == new.bodies.platform
            && scale == self.scale
            && self.cells == cells_for(new);
        let unchanged = if same_frame { unchanged(old, new) } else { vec![None; new.list.len()] };
        Self::compile(reference, |index| unchanged[index].map(|k| self.compiled[k].clone()), watch)
    }

    /// Compiles all conditions except those that `known` provides.
    fn compile(
        reference: GjkEngine,
        known: impl Fn(usize) -> Option<Arc<[Compiled]>> + Sync,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let conditions = reference.conditions();
        let (scale, cells, fat) = (conditions.scale(), cells_for(conditions), conditions.fattened());
        let compiled: Vec<Arc<[Compiled]>> = conditions.map(watch, |index| {
            known(index).unwrap_or_else(|| compiled(conditions, index, &scale, &cells, &fat).into())
        })?;
        let mut planes = Planes::default();
        let (mut outer, mut heads, mut regions_of) = (Vec::new(), Vec::new(), Vec::new());
        for (condition, pieces) in compiled.iter().enumerate() {
            let first = heads.len();
            for piece in pieces.iter() {
                let range = planes.add(piece.region.outer.as_deref().unwrap_or_default());
                heads.push(head(condition, &piece.region, &range, &mut planes));
                outer.push(range);
            }
            regions_of.push(first..heads.len());
        }
        let pieces = compiled.iter().flat_map(|pieces| pieces.iter());
        let lists = Lists::new(&cells, pieces.map(|piece| (&piece.region, piece.reached.as_slice())), watch)?;
        let exceeds = |index: &usize| conditions.list[*index].details().exceeds_regions(reference.interference());
        let beyond_regions = (0..conditions.list.len()).filter(exceeds).collect();
        let (min, max) = conditions.position_box();
        let touch = Vector::repeat(TOUCH_DEPTH);
        Ok(CspaceEngine {
            low: min - touch,
            high: max + touch,
            kernel: Kernel::best(),
            last_refuser: AtomicU32::new(0),
            reference,
            forbidden: KeptPolyhedra::default(),
            scale,
            compiled,
            outer,
            heads,
            regions_of,
            beyond_regions,
            planes,
            cells,
            lists,
        })
    }

    /// This engine without SIMD instructions, for comparison.
    pub fn portable(mut self) -> Self {
        self.kernel = Kernel::Portable;
        self
    }

    /// Size of the compiled scene in bytes, without the conditions themselves.
    pub fn bytes(&self) -> usize {
        let pieces = self.compiled.iter().flat_map(|pieces| pieces.iter());
        let kept = pieces.map(|p| size_of::<Compiled>() + p.reached.len() * size_of::<Reached>() + p.region.bytes());
        self.planes.bytes()
            + self.lists.bytes()
            + self.heads.capacity() * (size_of::<Head>() + size_of::<Range<u32>>())
            + kept.sum::<usize>()
    }

    /// The regions of one condition.
    fn regions(&self, index: usize) -> impl Iterator<Item = &Region> + Clone {
        self.compiled[index].iter().map(|compiled| &compiled.region)
    }

    #[inline(always)]
    fn inside(&self, p: &Point) -> bool {
        let (low, high) = (&self.low, &self.high);
        (p.x >= low.x) & (p.y >= low.y) & (p.z >= low.z) & (p.x <= high.x) & (p.y <= high.y) & (p.z <= high.z)
    }

    /// Whether a motion breaks the condition of a region within that region.
    #[inline(always)]
    fn refuses<L: Lanes>(&self, region: usize, segment: &Segment<L>, from: &Point, to: &Point) -> bool {
        let outer = self.planes.of(&self.outer[region]);
        if !segment.meets(outer, 0.0) {
            return false;
        }
        self.certainly_refuses(region, segment) || self.reference_refuses(self.heads[region].condition, from, to)
    }

    /// Whether a motion meets the inner polyhedron of a region.
    #[inline(always)]
    fn certainly_refuses<L: Lanes>(&self, region: usize, segment: &Segment<L>) -> bool {
        let head = &self.heads[region];
        if let Some(widen) = head.widen { segment.meets(self.planes.of(&head.inner), widen) } else { false }
    }

    #[cold]
    #[inline(never)]
    fn reference_refuses(&self, condition: usize, from: &Point, to: &Point) -> bool {
        self.reference.breaks(condition, from, to)
    }

    /// Whether a motion inside the box of positions breaks a condition in any region.
    #[inline(always)]
    fn refused<L: Lanes>(&self, lanes: L, from: &Point, to: &Point) -> bool {
        let segment = Segment::new(lanes, from, to);
        let start = self.cells.place(lanes, from);
        let way = lanes.sub(self.cells.place(lanes, to), start);
        let pieces = self.cells.pieces(lanes, way);
        if pieces == 1 {
            return self.refused_in(self.cells.cell(lanes, start, way), lanes, &segment, from, to).is_some();
        }
        let last = self.last_refuser.load(Ordering::Relaxed) as usize;
        if pieces > 2 && last < self.heads.len() && self.certainly_refuses(last, &segment) {
            return true;
        }
        let step = lanes.div(way, lanes.splat(pieces as f64));
        for k in 0..pieces {
            let start = lanes.add(start, lanes.mul(step, lanes.splat(k as f64)));
            if let Some(region) = self.refused_in(self.cells.cell(lanes, start, step), lanes, &segment, from, to) {
                self.last_refuser.store(region, Ordering::Relaxed);
                return true;
            }
        }
        false
    }

    /// The region, among those that overlap a cell, that rejects a motion with a piece in this cell.
    #[inline(always)]
    fn refused_in<L: Lanes>(
        &self,
        (cell, piece): (usize, [CoarsePlace; 2]),
        lanes: L,
        whole: &Segment<L>,
        from: &Point,
        to: &Point,
    ) -> Option<u32> {
        for group in self.lists.of(cell) {
            let mut open = not_outside(lanes, &group.planes, &piece);
            while open != 0 {
                let region = group.regions[open.trailing_zeros() as usize % INTEGERS];
                if region & FULL != 0 || self.refuses(region as usize, whole, from, to) {
                    return Some(region & !FULL);
                }
                open &= open - 1;
            }
        }
        None
    }

    /// Whether a motion breaks a condition outside its regions.
    fn breaks_beyond_regions(&self, from: &Point, to: &Point) -> bool {
        let list = &self.conditions().list;
        let breaks = |&index: &usize| !list[index].certainly_keeps(from, to) && self.reference_refuses(index, from, to);
        self.beyond_regions.iter().any(breaks)
    }
}

/// Checks a motion against all regions.
struct Motion<'a> {
    engine: &'a CspaceEngine,
    from: &'a Point,
    to: &'a Point,
}

impl Task for Motion<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> bool {
        self.engine.refused(lanes, self.from, self.to)
    }
}

/// Checks a motion against the regions of one condition.
struct OneCondition<'a> {
    motion: Motion<'a>,
    index: usize,
}

impl Task for OneCondition<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> bool {
        let Motion { engine, from, to } = self.motion;
        let segment = Segment::new(lanes, from, to);
        for region in engine.regions_of[self.index].clone() {
            if engine.refuses(region, &segment, from, to) {
                return true;
            }
        }
        false
    }
}

impl Clone for CspaceEngine {
    fn clone(&self) -> Self {
        Self::compile(self.reference.clone(), |index| Some(self.compiled[index].clone()), &Watch::NONE)
            .expect("nothing ends it early")
    }
}

impl Checker for CspaceEngine {
    fn conditions(&self) -> &Conditions {
        self.reference.conditions()
    }

    fn interference(&self) -> Interference {
        self.reference.interference()
    }

    fn geometry_for(&self, scene: &Scene, watch: &Watch) -> Result<Box<dyn Checker>, Error> {
        Ok(Box::new(self.recompiled(scene, watch)?))
    }

    fn breaks(&self, index: usize, from: &Point, to: &Point) -> bool {
        let [from, to] = either_way(from, to);
        let inside = self.inside(from) && self.inside(to);
        if !inside || self.conditions().list[index].details().exceeds_regions(self.interference()) {
            return self.reference_refuses(index, from, to);
        }
        self.kernel.run(OneCondition { motion: Motion { engine: self, from, to }, index })
    }

    fn certain_polyhedra(&self, watch: &Watch) -> Result<Arc<Vec<Polyhedron>>, Error> {
        let conditions = self.conditions();
        let (scale, inside) = (conditions.scale(), conditions.fattened().from_inside());
        let of = |index: usize| conditions.certain_polyhedra_of(index, self.regions(index), (&scale, &inside));
        self.forbidden.certain(|| conditions.for_each(watch, of))
    }

    fn pieces(&self, watch: &Watch) -> Result<Arc<Vec<Piece>>, Error> {
        let (conditions, fat) = (self.conditions(), self.conditions().fattened());
        self.forbidden
            .pieces(|| conditions.for_each(watch, |index| conditions.pieces_of(index, self.regions(index), &fat)))
    }
}

impl Validity for CspaceEngine {
    fn state_valid(&self, position: &Point) -> bool {
        self.motion_valid(position, position)
    }

    fn motion_valid(&self, from: &Point, to: &Point) -> bool {
        let [from, to] = either_way(from, to);
        self.inside(from)
            && self.inside(to)
            && !self.kernel.run(Motion { engine: self, from, to })
            && !self.breaks_beyond_regions(from, to)
    }

    fn violations(&self, from: &Point, to: &Point) -> Vec<Violation> {
        explain::violations(self, from, to)
    }

    fn clearance(&self, from: &Point, to: &Point) -> Option<Clearance> {
        clearance::clearance(self.conditions(), from, to)
    }
}

/// Cells along each axis, by the number of conditions: enough that few regions share a cell, few enough to fill
/// quickly.
fn cells_for(conditions: &Conditions) -> Cells {
    let (min, max) = conditions.position_box();
    let n = match conditions.list.len() {
        0..100 => 4,
        100..1500 => 8,
        1500..6000 => 16,
        _ => 32,
    };
    let touch = Vector::repeat(TOUCH_DEPTH); // gives cells a size where the box has none
    Cells::new(min - touch, max + touch, n)
}

/// The regions of a condition that overlap the box of positions.
fn compiled(conditions: &Conditions, index: usize, scale: &Scale, cells: &Cells, fat: &Fattened) -> Vec<Compiled> {
    let condition = conditions.list[index].details();
    let piece = |region: Region| {
        let reached = match &region.outer {
            Some(outer) => cells.reached_by(outer, &region.inner),
            None => cells.reached(&|center, half| {
                !condition.allows_all(&conditions.bodies, &Cuboid::new(center - half, center + half))
            }),
        };
        Compiled { region, reached }
    };
    let pieces = conditions.regions(index, scale, fat).into_iter().map(piece);
    pieces.filter(|piece| !piece.reached.is_empty()).collect()
}

fn head(condition: usize, region: &Region, outer: &Range<u32>, planes: &mut Planes) -> Head {
    let (inner, widen) = match &region.inner {
        Inner::Unknown => (0..0, None),
        Inner::Shrunk(widen) => (outer.clone(), Some(*widen)),
        Inner::Own(half_spaces) => (planes.add(half_spaces), Some(0.0)),
    };
    Head { condition, inner, widen }
}

/// For each new condition, the index of an identical old one, provided that cables, platform and workspace are the
/// same.
fn unchanged(old: &Conditions, new: &Conditions) -> Vec<Option<usize>> {
    let (old_obstacles, new_obstacles) = (&old.bodies.obstacles, &new.bodies.obstacles);
    let same_body = |body: usize| {
        let wanted = &new_obstacles[body];
        let likely = old_obstacles.get(body).is_some_and(|o| o == wanted).then_some(body);
        likely.or_else(|| old_obstacles.iter().position(|o| o == wanted))
    };
    let bodies: Vec<Option<usize>> = (0..new_obstacles.len()).map(same_body).collect();
    // Both lists have the same order, so each search starts where the last one ended.
    let mut next = 0;
    let find = |condition: &Condition| {
        let wanted = condition.renumbered(&bodies)?;
        let found = (next..old.list.len()).chain(0..next).find(|&k| old.list[k] == wanted)?;
        next = found + 1;
        Some(found)
    };
    new.list.iter().map(find).collect()
}
