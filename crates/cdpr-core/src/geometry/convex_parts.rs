//! Convex parts that together cover a surface and the body it encloses.
//!
//! A point belongs to the body if the surface winds around it: its winding number, counted along rays, is not zero. That
//! holds for surfaces that cross themselves, too. Approximate decompositions such as V-HACD do not guarantee that their
//! parts cover the body, and they cut along voxels, which leaves bulges even on an L. So pieces are cut by planes here.
//!
//! If the hull of a piece extends too far beyond it, the piece is cut by a plane, and so are the halves. A part
//! encloses the content of one cell of the cuts: all of the surface in it, and the corners of the cell that are inside
//! the body or end it. Every extreme point of the intersection of body and cell is one of these, so the parts cover the
//! body wherever the cuts are; the cuts only determine how far the parts extend beyond it. A cut goes where the hull
//! extends farthest: along the largest face on that side, or else where it makes the halves smallest. That the parts cover
//! the piece is proved at the end ([`coverage`]), and parts for which the proof fails are enlarged.
//!
//! Neighbours that one body encloses closely enough are merged. Parts stay within half the tolerance if there are few
//! enough of them then. Otherwise up to four times as many cells stay within the full tolerance and are merged, beyond the
//! tolerance if there are still too many. As a last resort, the cuts that save the least volume are undone. Cells are
//! cut in rounds and all limits are counts of steps, so the result depends neither on threads nor on time.
//!
//! A surface that encloses nothing is thickened by `SHEET`, so that its parts have volume and overlap along their seams;
//! flat ones are covered by prisms over convex polygons.
//!
//! [`coverage`]: coverage

mod cell;
mod coverage;
mod inner_hull;
mod merge;
mod part;
mod reach;
mod wrap;

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};
use std::sync::Arc;

use rayon::prelude::*;

use super::surface::MeshPiece;
use super::{Aabb, HalfSpace, Point, Polytope, Vector};
use crate::error::Error;
use crate::geometry::surface::solid::nearest_on_triangle;
use crate::limits::{
    CELLS_PER_PART, FEW_PLANES, MEASURE_STEPS, MEASURE_STEPS_IN_ALL, MOST_CONVEX_CORNERS, MOST_REACH_STEPS,
    POLYGONS_BESIDES, POLYGONS_PER_TRIANGLE, REACH_STEPS_PER_PART,
};
use crate::tolerances::{CLOSE, CORNER_PROBE, FACE_SHARE, MUCH_SMALLER, ON_SURFACE, SHEET};
use crate::watch::Watch;
use cell::{Cell, flat_excess, mean_and_axes};
use coverage::{ROOM, contain, missing, polyhedron};
use inner_hull::InnerHull;
use merge::merged;
use part::{Part, Task};
use reach::{Bounded, Reach, Until};
use wrap::{Wrap, box_around, is_sound, thickened};

/// Minimum number of boxes that a proof of reach may examine, however few are left for all parts together.
const LEAST_STEPS: usize = 200;

const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// Shares of the tolerance up to which neighbours are merged, one after another, while there are too many parts.
const MERGE_SHARES: [f64; 4] = [0.5, 1.0, 1.5, 2.0];

/// Number of corners up to which hulls are grown to compare cuts by volume.
const ROUGH_CORNERS: usize = 40;

/// Height up to which a point counts as on a plane, in relation to the largest side of the box around the piece.
const ON_PLANE: f64 = 1e-9;

/// Maximum number of times that a part is enlarged before it becomes a box around the piece.
const MOST_ENLARGED: usize = 4;

/// Convex parts of a piece.
#[derive(Debug, Clone)]
pub struct ConvexParts {
    /// The parts; all have a volume.
    pub bodies: Vec<Polytope>,
    /// Upper bound of the distance of any point of a part from the piece, m.
    pub reach: f64,
    /// Number of parts that were enlarged because the proof that they cover the piece failed.
    pub enlarged: usize,
}

/// Parts of a piece that extend at most `tolerance` metres beyond it (but at least four times [`SHEET`]), unless that
/// takes more than `most` parts or more proof steps than [`REACH_STEPS_PER_PART`] allows. The reach in the result
/// is valid in any case. Walls of the piece that no part covers become parts of their own, in addition.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn convex_parts(piece: &MeshPiece, tolerance: f64, most: usize, watch: &Watch) -> Result<ConvexParts, Error> {
    let mut parts = match convex(piece, watch)? {
        Some(body) => ConvexParts { bodies: vec![body], reach: 0.0, enlarged: 0 },
        None => Cutter::new(piece, tolerance.max(4.0 * SHEET), watch)?.parts(most)?,
    };
    let on_plane = ON_PLANE * (aabb(piece).max - aabb(piece).min).amax();
    for wall in &piece.walls {
        watch.check()?;
        if !contain(&parts.bodies, wall, on_plane) {
            let wrap = Task { piece, tolerance: 4.0 * SHEET, watch }.enclosing(thickened(wall))?;
            let (body, _) = wrap.polytope();
            // The distance from a triangle is a convex function, so it is largest in a corner.
            let reach = body.vertices().iter().map(|v| (nearest_on_triangle(v, wall) - v).norm()).fold(0.0, f64::max);
            parts.reach = parts.reach.max(reach);
            parts.bodies.push(body);
        }
    }
    Ok(parts)
}

/// How far a thickened sheet extends: to the corners of a cube with an inner radius of [`SHEET`].
const SHEET_REACH: f64 = SQRT_3 * SHEET;

fn covers(body: &Polytope, p: &Point) -> bool {
    body.depth_of(p) >= -ROOM
}

fn aabb(piece: &MeshPiece) -> Aabb {
    let first = piece.triangles[0][0];
    let corners = piece.triangles.iter().flatten();
    corners.fold(Aabb { min: first, max: first }, |b, p| Aabb { min: b.min.inf(p), max: b.max.sup(p) })
}

/// The hull of a piece that is already convex and has few corners: all triangles lie on the hull's surface, and the body
/// is inside.
fn convex(piece: &MeshPiece, watch: &Watch) -> Result<Option<Polytope>, Error> {
    if piece.volume.is_none() {
        return Ok(None);
    }
    let points: Vec<Point> = piece.triangles.iter().flatten().copied().collect();
    let Some(mut inner) = InnerHull::new(&points) else { return Ok(None) };
    if inner.grow(0.5 * ON_SURFACE, MOST_CONVEX_CORNERS, watch)? > 0.5 * ON_SURFACE {
        return Ok(None);
    }
    let Ok(body) = Polytope::hull_of(&inner.corners()) else { return Ok(None) };
    if !is_sound(&body, &inner.candidates()) || !piece.distance.encloses(&body.centroid()) {
        return Ok(None);
    }
    for (k, triangle) in piece.triangles.iter().enumerate() {
        if k % 64 == 0 {
            watch.check()?;
        }
        // Depth is a concave function: a triangle is nowhere more than three times as deep as at its middle.
        let middle = Point::from(triangle.iter().map(|p| p.coords).sum::<Vector>() / 3.0);
        if body.depth_of(&middle) > ON_SURFACE || !triangle.iter().all(|p| covers(&body, p)) {
            return Ok(None);
        }
    }
    Ok(Some(body))
}

/// Result of examining a cell.
struct Judged {
    cell: Arc<Cell>,
    part: Part,
    reach: Reach,
}

/// A cell to be examined, and its parent.
type Open = (Arc<Cell>, Option<usize>);

/// An examined cell. Those that are not cut cover the body.
struct Node {
    part: Part,
    /// The cell, unless it was cut.
    cell: Option<Arc<Cell>>,
    /// The parent cell.
    parent: Option<usize>,
    /// Halves that were examined.
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

/// The parts that stand, each with the cells that it covers.
fn standing(nodes: &[Node]) -> Vec<Part> {
    let mut covered: Vec<Vec<Arc<Cell>>> = vec![Vec::new(); nodes.len()];
    for (k, node) in nodes.iter().enumerate() {
        if let Some(cell) = &node.cell {
            let above = std::iter::successors(Some(k), |k| nodes[*k].parent);
            let stands = above.into_iter().find(|k| nodes[*k].stands).expect("a part covers every cell");
            covered[stands].push(cell.clone());
        }
    }
    let parts = nodes.iter().zip(covered).filter(|(node, _)| node.stands);
    parts.map(|(node, cells)| Part { cells, ..node.part.clone() }).collect()
}

struct Cutter<'a> {
    task: Task<'a>,
    aabb: Aabb,
    /// Planes of the triangles, without duplicates.
    planes: Vec<HalfSpace>,
    plane_of: Vec<u32>,
    /// Largest side of the box around the piece, m.
    extent: f64,
    /// Height up to which a point counts as on a plane, m.
    on_plane: f64,
}

impl<'a> Cutter<'a> {
    fn new(piece: &'a MeshPiece, tolerance: f64, watch: &'a Watch) -> Result<Self, Error> {
        let aabb = aabb(piece);
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
        Ok(Cutter {
            task: Task { piece, tolerance, watch },
            aabb,
            planes,
            plane_of,
            extent,
            on_plane: ON_PLANE * extent,
        })
    }

    /// At most `most` parts, proved to cover the piece.
    fn parts(&self, most: usize) -> Result<ConvexParts, Error> {
        let parts = self.few(most)?;
        let steps = (MEASURE_STEPS_IN_ALL / parts.len().max(1)).max(MEASURE_STEPS);
        let found: Vec<(Polytope, f64, bool)> =
            parts.into_par_iter().map(|part| self.finished(part, steps)).collect::<Result<_, _>>()?;
        Ok(ConvexParts {
            reach: found.iter().map(|(_, reach, _)| *reach).fold(0.0, f64::max),
            enlarged: found.iter().filter(|(.., enlarged)| *enlarged).count(),
            bodies: found.into_iter().map(|(body, ..)| body).collect(),
        })
    }

    /// At most `most` parts. If that many can be close enough, they are used; otherwise more cells, which reach as far
    /// as allowed, are merged. If merging leaves too many, the cuts that gain least are undone.
    fn few(&self, most: usize) -> Result<Vec<Part>, Error> {
        let close = CLOSE * self.task.tolerance;
        let parts = standing(&self.cut_up(close, (most, most), true)?);
        if parts.iter().all(|part| part.reach.is_some()) {
            return merged(&self.task, parts, close);
        }
        let mut nodes = self.cut_up(self.task.tolerance, (most.saturating_mul(CELLS_PER_PART), most), false)?;
        let parts = standing(&nodes);
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
        let whole = Cell::whole(&self.task.piece.triangles, &self.plane_of, self.task.watch)?;
        let mut open: Vec<Open> = vec![(Arc::new(whole), None)];
        let mut nodes: Vec<Node> = Vec::new();
        let mut standing = 0;
        let mut steps = most.saturating_mul(REACH_STEPS_PER_PART);
        let mut polygons = POLYGONS_BESIDES + POLYGONS_PER_TRIANGLE * self.task.piece.triangles.len();
        while !open.is_empty() {
            polygons = polygons.saturating_sub(open.iter().map(|(cell, _)| cell.count()).sum());
            let share = (steps / open.len()).clamp(LEAST_STEPS, MOST_REACH_STEPS);
            let judge = |(cell, parent): Open| {
                let within = if parent.is_some() { within } else { self.task.tolerance };
                Ok((self.judged(cell, within, share)?, parent))
            };
            let judged: Vec<(Judged, Option<usize>)> = open.into_par_iter().map(judge).collect::<Result<_, Error>>()?;
            let mut far = Vec::new();
            for (Judged { cell, part, reach }, parent) in judged {
                steps = steps.saturating_sub(reach.steps);
                standing += 1;
                if let Some(parent) = parent {
                    let whole: &mut Node = &mut nodes[parent];
                    whole.halves += 1;
                    standing -= usize::from(std::mem::take(&mut whole.stands));
                }
                if part.reach.is_none() {
                    far.push((cell.clone(), reach, nodes.len()));
                }
                nodes.push(Node { part, cell: Some(cell), parent, halves: 0, stands: true });
            }
            let worst = |reach: &Reach| reach.worst.map_or(0.0, |(worst, _)| worst);
            far.sort_by(|a, b| worst(&b.1).total_cmp(&worst(&a.1)));
            let room = cells.saturating_sub(standing);
            let enough = steps > 0 && polygons > 0 && (far.len() <= room || !all);
            far.truncate(if enough { room } else { 0 });
            let cut = |(cell, reach, node): (Arc<Cell>, Reach, usize)| {
                Ok(self.cut(&cell, &reach)?.map(|halves| halves.map(|half| (Arc::new(half), Some(node)))))
            };
            let halves: Vec<Option<[Open; 2]>> = far.into_par_iter().map(cut).collect::<Result<_, Error>>()?;
            open = halves.into_iter().flatten().flatten().collect();
            open.iter().filter_map(|(_, node)| *node).for_each(|node| nodes[node].cell = None);
        }
        Ok(nodes)
    }

    /// The part of a cell, and whether it is good enough.
    fn judged(&self, cell: Arc<Cell>, within: f64, steps: usize) -> Result<Judged, Error> {
        let mut points = cell.points.clone();
        if self.task.piece.volume.is_some() && !cell.sides.is_empty() {
            points.extend(self.corners_of_body(&cell));
        }
        let wrap = self.wrapped(points)?;
        let known = match self.task.piece.volume {
            Some(_) => self.fills(&cell, &wrap).then_some(0.0),
            None => flat_excess(&cell).filter(|_| wrap.exact).map(|excess| SHEET_REACH + excess),
        };
        let reach = match known {
            Some(bound) => Reach { bound, worst: None, steps: 0 },
            None => self.task.proved(&wrap, within, steps)?,
        };
        let within = (reach.bound <= within).then_some(reach.bound);
        Ok(Judged { cell, part: Part { wrap, reach: within, cells: Vec::new() }, reach })
    }

    /// The corners of a cell that end the part of the body in it. A corner on the surface does so if the body is next to
    /// it within the cell, whichever cell the surface there belongs to.
    fn corners_of_body(&self, cell: &Cell) -> Vec<Point> {
        let Some(whole) = polyhedron(cell, &self.aabb) else { return Vec::new() };
        let (middle, surface) = (whole.middle(), &self.task.piece.distance);
        let ends_body = |v: &Point| {
            let inward = middle - v;
            let step = (CORNER_PROBE * self.extent / inward.norm()).min(0.5);
            let on_surface = surface.within(v, 4.0 * self.on_plane, &mut 0);
            surface.encloses(&if on_surface { v + inward * step } else { *v })
        };
        whole.corners().filter(ends_body).collect()
    }

    /// A convex body with volume around points.
    fn wrapped(&self, points: Vec<Point>) -> Result<Wrap, Error> {
        if self.task.piece.volume.is_some() {
            self.task.enclosing(points)
        } else {
            self.task.enclosing(thickened(&points))
        }
    }

    /// The body of a part, how far it extends beyond the piece, and whether it was enlarged to cover the piece.
    fn finished(&self, part: Part, steps: usize) -> Result<(Polytope, f64, bool), Error> {
        let (mut body, proved) = part.wrap.polytope();
        let mut proved = part.reach.filter(|_| proved);
        let mut rounds = 0;
        loop {
            let missing = missing(self.task.piece, &part.cells, &body, (&self.aabb, self.on_plane), self.task.watch)?;
            if missing.is_empty() {
                break;
            }
            proved = None;
            rounds += 1;
            if rounds > MOST_ENLARGED {
                body = box_around(&self.aabb);
                break;
            }
            body = self.task.enclosing(body.vertices().iter().copied().chain(missing).collect())?.polytope().0;
        }
        if proved == Some(0.0) {
            return Ok((body, 0.0, false));
        }
        // The proof ended as soon as the bound was low enough; most parts extend less.
        let until = Until { enough: 0.0, or_beyond: false, steps };
        let bounded = Bounded { planes: body.half_spaces(), aabb: *body.aabb(), frame: None };
        let found = self.task.measured(bounded, body.vertices(), &until)?;
        Ok((body, proved.map_or(found.bound, |reach| reach.min(found.bound)), rounds > 0))
    }

    /// Whether a part equals the body in its cell: the surface does not pass through the part's interior, and the
    /// interior belongs to the body.
    fn fills(&self, cell: &Cell, wrap: &Wrap) -> bool {
        let on = |side: &HalfSpace, ring: &[u32]| {
            ring.iter().all(|i| side.height(&cell.points[*i as usize]).abs() <= ON_SURFACE)
        };
        let outside = |ring: &[u32]| wrap.planes.iter().any(|side| on(side, ring));
        wrap.exact && self.task.piece.distance.encloses(&wrap.middle) && cell.polygons().all(|(_, ring)| outside(ring))
    }

    /// Both halves of a cell, cut where its part extends too far: along a large face on that side, or else where the
    /// halves become smallest. `None` if no cut leaves surface or body on both sides.
    fn cut(&self, cell: &Cell, reach: &Reach) -> Result<Option<[Cell; 2]>, Error> {
        let Some((_, void)) = reach.worst.filter(|_| cell.count() > 0) else { return Ok(None) };
        let (distance, nearest) = self.task.piece.distance.to_surface(&void, f64::INFINITY, &mut 0);
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
        // A half without surface is all body or all void.
        let full =
            |half: &Cell| polyhedron(half, &self.aabb).is_some_and(|h| self.task.piece.distance.encloses(&h.middle()));
        Ok(halves.iter().all(|half| half.count() > 0 || full(half)).then_some(halves))
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

    /// The plane with the largest share of a cell's surface, among those that a point is well in front of; `None` if that is
    /// no more than a facet of something round.
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
        let few = self.planes.len() <= FEW_PLANES;
        (few || largest.0 >= FACE_SHARE * total).then_some(largest.2)
    }
}
