//! Convex parts that together cover a surface and the body it encloses.
//!
//! If the hull of a piece extends too far beyond it, the piece is cut by a plane, and so are the halves. A part
//! encloses the content of one cell of the cuts: all of the surface in it, and the corners of the cell that are inside
//! the body. Every extreme point of the intersection of body and cell is one of these, so the parts cover the body
//! wherever the cuts are; the cuts only determine how far the parts extend beyond it. A cut goes where the hull extends
//! farthest: along the largest face on that side, or else where it makes the halves smallest. Neighbours that one body
//! encloses within the tolerance are merged at the end.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use rayon::prelude::*;

use super::cell::{Cell, mean_and_axes};
use super::inner_hull::InnerHull;
use super::merge::merged;
use super::part::{Part, Task};
use super::reach::{Reach, Until, reach};
use super::surface::Piece;
use super::wrap::{Wrap, is_sound, thickened};
use super::{Aabb, HalfSpace, Point, Polytope, Vector, convex_mesh};
use crate::error::Error;
use crate::numerics::{
    CELLS_PER_PART, CLOSE, EXACT_VOLUME, FACE_SHARE, MEASURE_STEPS, MEASURE_STEPS_IN_ALL, MOST_CONVEX_CORNERS,
    MOST_REACH_STEPS, MUCH_SMALLER, ON_SURFACE, POLYGONS_BESIDES, POLYGONS_PER_TRIANGLE, REACH_STEPS_PER_PART, SHEET,
};
use crate::watch::Watch;

/// Minimum number of boxes that a proof of reach may examine, however few are left for all parts together.
const LEAST_STEPS: usize = 200;

/// Shares of the tolerance up to which neighbours are merged, one after another, while there are too many parts.
const MERGE_SHARES: [f64; 4] = [0.5, 1.0, 1.5, 2.0];

/// Number of corners up to which hulls are grown to compare cuts by volume.
const ROUGH_CORNERS: usize = 40;

/// Convex parts of a piece.
#[derive(Debug, Clone)]
pub struct ConvexParts {
    /// The parts; all have a volume.
    pub bodies: Vec<Polytope>,
    /// Upper bound of the distance of any point of a part from the piece, m.
    pub reach: f64,
}

/// Parts of a piece that extend at most `tolerance` metres beyond it (but at least four times [`SHEET`]), unless that
/// takes more than `most` parts or more proof steps than [`REACH_STEPS_PER_PART`] allows. The reach in the result
/// is valid in any case, except for a closed surface that intersects itself.
///
/// # Errors
/// The errors of the watch.
pub fn convex_parts(piece: &Piece, tolerance: f64, most: usize, watch: &Watch) -> Result<ConvexParts, Error> {
    if let Some(body) = convex(piece, watch)? {
        return Ok(ConvexParts { bodies: vec![body], reach: 0.0 });
    }
    let cutter = Cutter::new(piece, tolerance.max(4.0 * SHEET), watch)?;
    let parts = cutter.few(most)?;
    let steps = (MEASURE_STEPS_IN_ALL / parts.len().max(1)).max(MEASURE_STEPS);
    let bodies: Vec<(Polytope, f64)> =
        parts.into_par_iter().map(|part| cutter.finished(part, steps)).collect::<Result<_, _>>()?;
    let reach = bodies.iter().map(|(_, reach)| *reach).fold(0.0, f64::max);
    Ok(ConvexParts { bodies: bodies.into_iter().map(|(body, _)| body).collect(), reach })
}

/// The hull of a piece that is already convex and has few corners.
fn convex(piece: &Piece, watch: &Watch) -> Result<Option<Polytope>, Error> {
    let Some(volume) = piece.volume else { return Ok(None) };
    let points: Vec<Point> = piece.triangles.iter().flatten().copied().collect();
    let Some(mut inner) = InnerHull::new(&points) else { return Ok(None) };
    let left = inner.grow(0.5 * ON_SURFACE, MOST_CONVEX_CORNERS, watch)?;
    if left > 0.5 * ON_SURFACE || (inner.volume() - volume).abs() > EXACT_VOLUME * volume {
        return Ok(None);
    }
    watch.check()?;
    Ok(Polytope::hull_of(&inner.corners()).ok().filter(|body| is_sound(body, &inner.candidates())))
}

/// Result of examining a cell.
struct Judged {
    cell: Cell,
    part: Part,
    reach: Reach,
}

/// A cell to be examined, and its parent.
type Open = (Cell, Option<usize>);

/// An examined cell. Those that are not cut cover the body.
struct Node {
    part: Part,
    /// The parent cell.
    parent: Option<usize>,
    /// Halves that are not empty and not discarded.
    halves: usize,
    /// Whether this cell's part is among those that cover the body.
    stands: bool,
}

/// Undoes cuts, starting with those that saved the least volume, until at most `most` parts remain.
fn undo(nodes: &mut [Node], most: usize) {
    let mut standing = nodes.iter().filter(|node| node.stands).count();
    let mut whole: Vec<bool> = nodes.iter().map(|node| node.stands).collect();
    let mut missing: Vec<usize> = nodes.iter().map(|node| node.halves).collect();
    let mut saved: Vec<f64> = nodes.iter().map(|node| node.part.wrap.volume).collect();
    for node in nodes.iter() {
        if let Some(parent) = node.parent {
            saved[parent] -= node.part.wrap.volume;
        }
    }
    // A cell may be restored once its halves are; nonnegative numbers have the same order as their bit patterns.
    let mut ready: BinaryHeap<Reverse<(u64, usize)>> = BinaryHeap::new();
    let done = |k: usize, missing: &mut [usize], ready: &mut BinaryHeap<_>| {
        if let Some(parent) = nodes[k].parent {
            missing[parent] -= 1;
            if missing[parent] == 0 {
                ready.push(Reverse((saved[parent].max(0.0).to_bits(), parent)));
            }
        }
    };
    (0..nodes.len()).filter(|k| whole[*k]).for_each(|k| done(k, &mut missing, &mut ready));
    while standing > most
        && let Some(Reverse((_, k))) = ready.pop()
    {
        whole[k] = true;
        standing = standing + 1 - nodes[k].halves;
        done(k, &mut missing, &mut ready);
    }
    // Cells come before their halves.
    for k in 0..nodes.len() {
        let within = nodes[k].parent.is_some_and(|parent| whole[parent]);
        nodes[k].stands = whole[k] && !within;
        whole[k] |= within;
    }
}

struct Cutter<'a> {
    task: Task<'a>,
    aabb: Aabb,
    /// Planes of the triangles, without duplicates.
    planes: Vec<HalfSpace>,
    plane_of: Vec<u32>,
    /// Height up to which a point counts as on a plane, m.
    on_plane: f64,
}

impl<'a> Cutter<'a> {
    fn new(piece: &'a Piece, tolerance: f64, watch: &'a Watch) -> Result<Self, Error> {
        let first = piece.triangles[0][0];
        let aabb = piece
            .triangles
            .iter()
            .flatten()
            .fold(Aabb { min: first, max: first }, |b, p| Aabb { min: b.min.inf(p), max: b.max.sup(p) });
        let extent = (aabb.max - aabb.min).amax();
        let mut places: HashMap<[i64; 4], u32> = HashMap::new();
        let mut planes = Vec::new();
        let mut plane_of = Vec::with_capacity(piece.triangles.len());
        for (k, [a, b, c]) in piece.triangles.iter().enumerate() {
            if k % 4096 == 0 {
                watch.check()?;
            }
            let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or(Vector::z());
            let middle = Point::from((a.coords + b.coords + c.coords) / 3.0);
            let plane = HalfSpace::through(&middle, normal);
            let [x, y, z] = [0, 1, 2].map(|k| (1e4 * normal[k]).round() as i64);
            let height = (1e4 * normal.dot(&(middle - aabb.min)) / extent).round() as i64;
            plane_of.push(*places.entry([x, y, z, height]).or_insert_with(|| {
                planes.push(plane);
                planes.len() as u32 - 1
            }));
        }
        Ok(Cutter { task: Task { piece, tolerance, watch }, aabb, planes, plane_of, on_plane: 1e-9 * extent })
    }

    /// At most `most` parts. If that many can be close enough, they are used; otherwise more cells, which reach as far
    /// as allowed, are merged. If merging leaves too many, the cuts that gain least are undone.
    fn few(&self, most: usize) -> Result<Vec<Part>, Error> {
        let close = CLOSE * self.task.tolerance;
        let standing = |nodes: &[Node]| nodes.iter().filter(|node| node.stands).map(|node| node.part.clone()).collect();
        let parts: Vec<Part> = standing(&self.cut_up(close, (most, most), true)?);
        if parts.iter().all(|part| part.reach.is_some()) {
            return merged(&self.task, parts, close);
        }
        let mut nodes = self.cut_up(self.task.tolerance, (most.saturating_mul(CELLS_PER_PART), most), false)?;
        let parts: Vec<Part> = standing(&nodes);
        if parts.len() <= most {
            return merged(&self.task, parts, close);
        }
        if parts.iter().filter(|part| part.reach.is_none()).count() <= most {
            let mut parts = parts;
            for share in MERGE_SHARES {
                parts = merged(&self.task, parts, share * self.task.tolerance)?;
                if parts.len() <= most {
                    return Ok(parts);
                }
            }
        }
        undo(&mut nodes, most);
        merged(&self.task, standing(&nodes), self.task.tolerance)
    }

    /// Cuts cells until their parts are good enough, round by round, so that the result does not depend on the order in
    /// which threads finish. If not all can be cut, those that extend farthest are, or none if only the complete set is
    /// useful. A piece that one part encloses within the tolerance is not cut.
    fn cut_up(&self, within: f64, (cells, most): (usize, usize), all: bool) -> Result<Vec<Node>, Error> {
        let mut open = vec![(Cell::whole(&self.task.piece.triangles, &self.plane_of, self.task.watch)?, None)];
        let mut nodes: Vec<Node> = Vec::new();
        let mut standing = 0;
        let mut steps = most.saturating_mul(REACH_STEPS_PER_PART);
        let mut polygons = POLYGONS_BESIDES + POLYGONS_PER_TRIANGLE * self.task.piece.triangles.len();
        while !open.is_empty() {
            polygons = polygons.saturating_sub(open.iter().map(|(cell, _)| cell.count()).sum());
            let share = (steps / open.len()).clamp(LEAST_STEPS, MOST_REACH_STEPS);
            let judge = |(cell, parent): Open| {
                let within = if parent.is_some() { within } else { self.task.tolerance };
                Ok(self.judged(cell, within, share)?.map(|judged| (judged, parent)))
            };
            let judged: Vec<Option<(Judged, Option<usize>)>> =
                open.into_par_iter().map(judge).collect::<Result<_, Error>>()?;
            let mut far = Vec::new();
            for (Judged { cell, part, reach }, parent) in judged.into_iter().flatten() {
                steps = steps.saturating_sub(reach.steps);
                standing += 1;
                if let Some(parent) = parent {
                    let whole: &mut Node = &mut nodes[parent];
                    whole.halves += 1;
                    standing -= usize::from(std::mem::take(&mut whole.stands));
                }
                if part.reach.is_none() {
                    far.push((cell, reach, nodes.len()));
                }
                nodes.push(Node { part, parent, halves: 0, stands: true });
            }
            let worst = |reach: &Reach| reach.worst.map_or(0.0, |(worst, _)| worst);
            far.sort_by(|a, b| worst(&b.1).total_cmp(&worst(&a.1)));
            let room = cells.saturating_sub(standing);
            let enough = steps > 0 && polygons > 0 && (far.len() <= room || !all);
            far.truncate(if enough { room } else { 0 });
            let cut = |(cell, reach, node): (Cell, Reach, usize)| {
                Ok(self.cut(&cell, &reach)?.map(|halves| halves.map(|half| (half, Some(node)))))
            };
            let halves: Vec<Option<[Open; 2]>> = far.into_par_iter().map(cut).collect::<Result<_, Error>>()?;
            open = halves.into_iter().flatten().flatten().collect();
        }
        Ok(nodes)
    }

    /// The part of a cell, and whether it is good enough; `None` if the cell is empty.
    fn judged(&self, cell: Cell, within: f64, steps: usize) -> Result<Option<Judged>, Error> {
        let mut points = cell.points.clone();
        if self.task.piece.volume.is_some() && !cell.sides.is_empty() {
            let corners = convex_mesh(&cell.sides, &self.aabb).map(|mesh| mesh.vertices).unwrap_or_default();
            points.extend(corners.into_iter().filter(|v| self.task.piece.distance.at(v).0 < -self.on_plane));
        }
        if points.is_empty() {
            return Ok(None);
        }
        let wrap = self.wrapped(points)?;
        if self.task.piece.volume.is_some() && self.fills(&cell, &wrap) {
            let reach = Reach { bound: 0.0, worst: None, steps: 0 };
            return Ok(Some(Judged { cell, part: Part { wrap, reach: Some(0.0) }, reach }));
        }
        let reach = self.task.proved(&wrap, within, steps)?;
        let within = (reach.bound <= within).then_some(reach.bound);
        Ok(Some(Judged { cell, part: Part { wrap, reach: within }, reach }))
    }

    /// A convex body with volume around points.
    fn wrapped(&self, points: Vec<Point>) -> Result<Wrap, Error> {
        if self.task.piece.volume.is_some() {
            self.task.enclosing(points)
        } else {
            self.task.enclosing(thickened(&points))
        }
    }

    /// The body of a part, and how far it extends beyond the piece.
    fn finished(&self, part: Part, steps: usize) -> Result<(Polytope, f64), Error> {
        let (body, proved) = part.wrap.polytope();
        let proved = part.reach.filter(|_| proved);
        if proved == Some(0.0) {
            return Ok((body, 0.0));
        }
        // The proof ended as soon as the bound was low enough; most parts extend less.
        let until = Until { enough: 0.0, or_beyond: false, steps };
        let found = reach(&self.task.piece.distance, &body.half_spaces(), body.aabb(), &until, self.task.watch)?;
        Ok((body, proved.map_or(found.bound, |reach| reach.min(found.bound))))
    }

    /// Whether a part equals the body in its cell: the surface does not pass through the part's interior, and the
    /// interior belongs to the body.
    fn fills(&self, cell: &Cell, wrap: &Wrap) -> bool {
        let on = |side: &HalfSpace, ring: &[u32]| {
            ring.iter().all(|i| side.height(&cell.points[*i as usize]).abs() <= ON_SURFACE)
        };
        let outside = |ring: &[u32]| wrap.planes.iter().any(|side| on(side, ring));
        wrap.exact
            && self.task.piece.distance.at(&wrap.middle).0 < 0.0
            && cell.polygons().all(|(_, ring)| outside(ring))
    }

    /// Both halves of a cell, cut where its part extends too far: along a large face on that side, or else where the
    /// halves become smallest. `None` if no cut leaves something on both sides.
    fn cut(&self, cell: &Cell, reach: &Reach) -> Result<Option<[Cell; 2]>, Error> {
        let Some((_, void)) = reach.worst else { return Ok(None) };
        let (distance, nearest) = self.task.piece.distance.at(&void);
        if let Some(plane) = self.face_toward(cell, &void, distance)
            && let Some(halves) = self.halves(cell, &plane)?
        {
            return Ok(Some(halves));
        }
        // The body behind the nearest point can be cut off; a sheet has only surface that bends around the void.
        let place = if self.task.piece.volume.is_some() { nearest } else { void };
        let toward = (void - nearest).try_normalize(0.0).unwrap_or(Vector::x());
        let (_, axes) = mean_and_axes(cell);
        let sides = cell.aabb();
        let along = Vector::ith((sides.max - sides.min).imax(), 1.0);
        let middle = |axis: Vector| {
            let heights = || cell.points.iter().map(|p| axis.dot(&p.coords));
            let (low, high) = (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max));
            HalfSpace { normal: axis, offset: 0.5 * (low + high) }
        };
        let mut planes = vec![middle(axes[0]), middle(axes[1]), middle(along)];
        planes.push(HalfSpace::through(&place, toward));
        let mut best: Option<(f64, HalfSpace)> = None;
        for plane in planes {
            let Some(volume) = self.volume_of_halves(cell, &plane)? else { continue };
            if best.is_none_or(|(least, _)| volume < MUCH_SMALLER * least) {
                best = Some((volume, plane));
            }
        }
        Ok(best.map(|(_, plane)| self.halves(cell, &plane)).transpose()?.flatten())
    }

    fn halves(&self, cell: &Cell, plane: &HalfSpace) -> Result<Option<[Cell; 2]>, Error> {
        let normals = self.task.piece.volume.is_some().then_some(&self.planes[..]);
        let halves = cell.halves(plane, normals, self.on_plane, self.task.watch)?;
        Ok(halves.iter().all(|half| half.count() > 0).then_some(halves))
    }

    /// Approximate volume of the hulls of both halves; `None` if one side is empty.
    fn volume_of_halves(&self, cell: &Cell, plane: &HalfSpace) -> Result<Option<f64>, Error> {
        let mut sum = 0.0;
        for side in cell.points_beside(plane, self.on_plane) {
            self.task.watch.check()?;
            if side.is_empty() {
                return Ok(None);
            }
            if let Some(mut inner) = InnerHull::new(&side) {
                inner.grow(ON_SURFACE, ROUGH_CORNERS, self.task.watch)?;
                sum += inner.volume();
            }
        }
        Ok(Some(sum))
    }

    /// The plane with the largest share of a cell's surface, among those that a point is well in front of.
    fn face_toward(&self, cell: &Cell, place: &Point, distance: f64) -> Option<HalfSpace> {
        let mut areas: HashMap<u32, f64> = HashMap::new();
        let mut total = 0.0;
        for (plane, ring) in cell.polygons() {
            let area = 0.5 * cell.doubled_area(ring).norm();
            total += area;
            *areas.entry(plane).or_default() += area;
        }
        let facing = |plane: &HalfSpace| {
            let height = plane.height(place);
            let turned = HalfSpace { normal: -plane.normal, offset: -plane.offset };
            let facing = if self.task.piece.volume.is_none() && height < 0.0 { turned } else { *plane };
            (facing.height(place) >= 0.5 * distance).then_some(facing)
        };
        let candidates = areas.into_iter().filter_map(|(k, area)| Some((area, k, facing(&self.planes[k as usize])?)));
        let largest = candidates.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))?;
        (largest.0 >= FACE_SHARE * total).then_some(largest.2)
    }
}
