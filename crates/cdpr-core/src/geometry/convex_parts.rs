//! Convex parts that together cover a surface and the body it encloses.
//!
//! A piece whose hull reaches too far beyond it is cut by a plane, and so are the halves. A part is the hull of what
//! lies in one cell of the cuts: all of the surface in it, and those corners of the cell that are inside the body.
//! Every extreme point of body and cell is one of these, so the parts cover the body whatever the cuts; they only
//! decide how far the parts reach beyond it. Cuts go where the hull reaches farthest: along the largest face that looks
//! there, or else square to the way to the nearest point of the body.

use std::cmp::Ordering;
use std::collections::{BinaryHeap, HashMap, VecDeque};

use super::hull::{hull_corners, hull_volume};
use super::surface::Piece;
use super::{Aabb, Facet, HalfSpace, Point, Polytope, Vector, convex_mesh};
use crate::numerics::{
    EXACT_VOLUME, FACE_SHARE, GAP_TOLERANCE, MOST_CONVEX_CORNERS, MOST_PART_CORNERS, MOST_REACH_STEPS, MUCH_SMALLER,
    ON_SURFACE, PARALLEL, REACH_STEPS_PER_PART, SHEET, SPREAD_NORMALS, UNDECIDED,
};

/// Convex parts of a piece.
#[derive(Debug, Clone)]
pub struct ConvexParts {
    /// The parts; all have volume.
    pub bodies: Vec<Polytope>,
    /// No point of a part is farther from the piece than this, m.
    pub reach: f64,
}

/// Parts of a piece that reach at most `tolerance` metres beyond it (but some [`SHEET`]), unless that takes more than
/// `most` parts, or more time to prove than [`REACH_STEPS_PER_PART`] allow.
pub fn convex_parts(piece: &Piece, tolerance: f64, most: usize) -> ConvexParts {
    if let Some(body) = convex(piece) {
        return ConvexParts { bodies: vec![body], reach: 0.0 };
    }
    let tolerance = tolerance.max(4.0 * SHEET);
    let cutter = Cutter::new(piece, most.saturating_mul(REACH_STEPS_PER_PART));
    let mut open = VecDeque::from([cutter.whole()]);
    let mut parts = ConvexParts { bodies: Vec::new(), reach: 0.0 };
    while let Some(cell) = open.pop_front() {
        let Some(body) = cutter.part(&cell) else { continue };
        let reach = match cutter.reach(&cell, &body, tolerance) {
            Reach::Within(reach) => reach,
            Reach::Beyond(void) => {
                let room = parts.bodies.len() + open.len() + 2 <= most;
                if let Some(halves) = room.then(|| cutter.cut(&cell, &body, &void)).flatten() {
                    open.extend(halves);
                    continue;
                }
                cutter.bound(&body, tolerance)
            }
        };
        parts.reach = parts.reach.max(reach);
        parts.bodies.push(body);
    }
    parts
}

/// The hull of a piece that is convex already.
fn convex(piece: &Piece) -> Option<Polytope> {
    let volume = piece.volume?;
    let points: Vec<Point> = piece.triangles.iter().flatten().copied().collect();
    let (corners, triangles) = hull_corners(&points)?;
    let same = |other: f64| (other - volume).abs() <= EXACT_VOLUME * volume;
    if corners.len() > MOST_CONVEX_CORNERS || !same(hull_volume(&corners, &triangles)) {
        return None;
    }
    Polytope::hull_of(&corners).ok().filter(|body| is_sound(body, &points))
}

/// Whether a body covers the points, and can be made again from its corners.
fn is_sound(body: &Polytope, points: &[Point]) -> bool {
    let covers = || points.iter().all(|p| body.depth_of(p) >= -0.5 * GAP_TOLERANCE);
    body.has_volume() && covers() && Polytope::from_vertices(body.vertices()).is_ok_and(|again| again.has_volume())
}

/// A flat polygon of the surface: a triangle, or what a cell holds of it.
#[derive(Clone)]
struct Polygon {
    corners: Vec<Point>,
    /// Which plane it lies in.
    plane: usize,
}

/// An intersection of half-spaces, and what lies in it.
struct Cell {
    sides: Vec<HalfSpace>,
    polygons: Vec<Polygon>,
}

struct Cutter<'a> {
    piece: &'a Piece,
    aabb: Aabb,
    /// Planes of the triangles, each once.
    planes: Vec<HalfSpace>,
    plane_of: Vec<usize>,
    /// Height up to which a point counts as on a plane, m.
    on_plane: f64,
    /// Steps that proofs of reach may still take, all together.
    steps: std::cell::Cell<usize>,
}

impl<'a> Cutter<'a> {
    fn new(piece: &'a Piece, steps: usize) -> Self {
        let points: Vec<Point> = piece.triangles.iter().flatten().copied().collect();
        let aabb = Aabb::around(&points);
        let extent = (aabb.max - aabb.min).amax();
        let mut places: HashMap<[i64; 4], usize> = HashMap::new();
        let mut planes = Vec::new();
        let mut plane_of = Vec::new();
        for [a, b, c] in &piece.triangles {
            let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or(Vector::z());
            let middle = Point::from((a.coords + b.coords + c.coords) / 3.0);
            let plane = HalfSpace::through(&middle, normal);
            let [x, y, z] = [0, 1, 2].map(|k| (1e4 * normal[k]).round() as i64);
            let height = (1e4 * normal.dot(&(middle - aabb.min)) / extent).round() as i64;
            plane_of.push(*places.entry([x, y, z, height]).or_insert_with(|| {
                planes.push(plane);
                planes.len() - 1
            }));
        }
        Cutter { piece, aabb, planes, plane_of, on_plane: 1e-9 * extent, steps: steps.into() }
    }

    fn whole(&self) -> Cell {
        let polygon = |(t, plane): (&[Point; 3], &usize)| Polygon { corners: t.to_vec(), plane: *plane };
        Cell { sides: Vec::new(), polygons: self.piece.triangles.iter().zip(&self.plane_of).map(polygon).collect() }
    }

    /// A convex body around everything in a cell; none if there is nothing.
    fn part(&self, cell: &Cell) -> Option<Polytope> {
        let mut points: Vec<Point> = cell.polygons.iter().flat_map(|p| p.corners.iter().copied()).collect();
        if self.piece.volume.is_some() && !cell.sides.is_empty() {
            let corners = convex_mesh(&cell.sides, &self.aabb).map(|mesh| mesh.vertices).unwrap_or_default();
            points.extend(corners.into_iter().filter(|v| self.piece.distance.at(v).0 < -self.on_plane));
        }
        let wrapped = if self.piece.volume.is_some() { around } else { fattened };
        (!points.is_empty()).then(|| wrapped(&points))
    }

    /// How far a part reaches beyond the piece: nowhere, or proved to be within the tolerance, or a place that is
    /// farther.
    fn reach(&self, cell: &Cell, body: &Polytope, tolerance: f64) -> Reach {
        match self.piece.volume {
            Some(_) if self.fills(cell, body) => Reach::Within(0.0),
            None if is_flat_and_full(cell) => Reach::Within(2.0 * SHEET),
            _ => self.proved_reach(body, tolerance),
        }
    }

    /// Whether a part is exactly what the body has in its cell: the surface runs nowhere through the part's inside, and
    /// the inside belongs to the body.
    fn fills(&self, cell: &Cell, body: &Polytope) -> bool {
        let on = |f: &Facet, p: &Polygon| p.corners.iter().all(|c| f.height(c).abs() <= ON_SURFACE);
        let outside = |p: &Polygon| body.facets().iter().any(|f| on(f, p));
        self.piece.distance.at(&body.centroid()).0 < 0.0 && cell.polygons.iter().all(outside)
    }

    /// How far a body reaches beyond the piece.
    ///
    /// Distance changes by at most the way, so a tetrahedron reaches no farther than its middle does and its size adds.
    /// The tetrahedron that may reach farthest is looked at first.
    fn proved_reach(&self, body: &Polytope, tolerance: f64) -> Reach {
        let mut open: BinaryHeap<Tetrahedron> = tetrahedra(body).map(|t| self.measured(t)).collect();
        let mut worst: Option<(f64, Point)> = None;
        for step in 0.. {
            let Some(top) = open.pop() else { return Reach::Within(0.0) };
            if worst.is_none_or(|(reach, _)| top.distance > reach) {
                worst = Some((top.distance, top.middle));
            }
            let (reach, place) = worst.expect("just set");
            if top.bound <= tolerance {
                return Reach::Within(top.bound.max(0.0));
            }
            let left = self.steps.get();
            let undecided = reach > UNDECIDED * tolerance && (step > 100 || top.bound < 1.2 * reach);
            if undecided || step > MOST_REACH_STEPS || left == 0 {
                return Reach::Beyond(place);
            }
            self.steps.set(left - 1);
            open.extend(halves(&top.corners).map(|t| self.measured(t)));
        }
        unreachable!("the loop has no end")
    }

    fn measured(&self, corners: [Point; 4]) -> Tetrahedron {
        let middle = Point::from(corners.iter().map(|c| c.coords).sum::<Vector>() / 4.0);
        let size = corners.iter().map(|c| (c - middle).norm()).fold(0.0, f64::max);
        let (distance, _) = self.piece.distance.at(&middle);
        Tetrahedron { corners, middle, distance, bound: distance + size }
    }

    /// How far a body reaches at most, m.
    fn bound(&self, body: &Polytope, tolerance: f64) -> f64 {
        let across = (body.aabb().max - body.aabb().min).norm();
        let mut tolerance = tolerance;
        while tolerance < across {
            tolerance *= 2.0;
            if let Reach::Within(reach) = self.proved_reach(body, tolerance) {
                return reach;
            }
        }
        across // the body touches the piece
    }

    /// Both halves of a cell, cut where its part reaches too far: along a large face that looks there; else square to
    /// the way to the nearest point if that leaves much smaller parts than across the part, which keeps their number
    /// low where a piece is bent. None if no cut leaves something on both sides.
    fn cut(&self, cell: &Cell, body: &Polytope, void: &Point) -> Option<[Cell; 2]> {
        let (distance, nearest) = self.piece.distance.at(void);
        let both = |plane: &HalfSpace| {
            let halves = parts_body(plane, body).then(|| self.halves(cell, plane))?;
            halves.iter().all(|half| !half.polygons.is_empty()).then_some(halves)
        };
        if let Some(halves) = self.face_toward(cell, void, distance).and_then(|plane| both(&plane)) {
            return Some(halves);
        }
        // Behind the nearest point there is body to be cut off; of a sheet there is only what bends around the void.
        let place = if self.piece.volume.is_some() { nearest } else { *void };
        let toward = (void - nearest).try_normalize(0.0).unwrap_or(Vector::x());
        let sides = body.aabb().max - body.aabb().min;
        let across = HalfSpace::through(&body.centroid(), Vector::ith(sides.imax(), 1.0));
        let volume = |halves: &[Cell; 2]| halves.iter().filter_map(|h| self.part(h)).map(|b| b.volume()).sum::<f64>();
        match (both(&HalfSpace::through(&place, toward)), both(&across)) {
            (Some(square), Some(across)) if volume(&square) < MUCH_SMALLER * volume(&across) => Some(square),
            (square, across) => across.or(square),
        }
    }

    /// The plane with the largest share of a cell's surface among those that a place is well in front of.
    fn face_toward(&self, cell: &Cell, place: &Point, distance: f64) -> Option<HalfSpace> {
        let mut areas: HashMap<usize, f64> = HashMap::new();
        for polygon in &cell.polygons {
            *areas.entry(polygon.plane).or_default() += area(&polygon.corners);
        }
        let total: f64 = areas.values().sum();
        let facing = |plane: &HalfSpace| {
            let height = plane.height(place);
            let turned = HalfSpace { normal: -plane.normal, offset: -plane.offset };
            let facing = if self.piece.volume.is_none() && height < 0.0 { turned } else { *plane };
            (facing.height(place) >= 0.5 * distance).then_some(facing)
        };
        let candidates = areas.into_iter().filter_map(|(k, area)| Some((area, k, facing(&self.planes[k])?)));
        let largest = candidates.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))?;
        (largest.0 >= FACE_SHARE * total).then_some(largest.2)
    }

    /// What lies behind a plane and what lies before it. A polygon in the plane goes where its body is.
    fn halves(&self, cell: &Cell, plane: &HalfSpace) -> [Cell; 2] {
        let before = HalfSpace { normal: -plane.normal, offset: -plane.offset };
        let mut halves = [*plane, before].map(|side| {
            let sides = cell.sides.iter().copied().chain([side]).collect();
            Cell { sides, polygons: Vec::new() }
        });
        for polygon in &cell.polygons {
            let heights: Vec<f64> = polygon.corners.iter().map(|p| plane.height(p)).collect();
            let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
            let (below, above) = (highest <= self.on_plane, lowest >= -self.on_plane);
            let looks_back = self.piece.volume.is_some() && self.planes[polygon.plane].normal.dot(&plane.normal) < 0.0;
            match (below, above) {
                (true, true) => halves[usize::from(looks_back)].polygons.push(polygon.clone()),
                (true, false) => halves[0].polygons.push(polygon.clone()),
                (false, true) => halves[1].polygons.push(polygon.clone()),
                (false, false) => {
                    for (half, sign) in halves.iter_mut().zip([1.0, -1.0]) {
                        let corners = clipped(&polygon.corners, &heights, sign);
                        half.polygons.push(Polygon { corners, plane: polygon.plane });
                    }
                }
            }
        }
        halves
    }
}

/// Whether a body lies on both sides of a plane.
fn parts_body(plane: &HalfSpace, body: &Polytope) -> bool {
    let heights = || body.vertices().iter().map(|v| plane.height(v));
    heights().any(|h| h > 0.0) && heights().any(|h| h < 0.0)
}

/// The part of a convex polygon where height times sign is at most zero (Sutherland–Hodgman).
fn clipped(corners: &[Point], heights: &[f64], sign: f64) -> Vec<Point> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (k, p) in corners.iter().enumerate() {
        let next = (k + 1) % corners.len();
        let (here, there) = (sign * heights[k], sign * heights[next]);
        if here <= 0.0 {
            kept.push(*p);
        }
        if (here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0) {
            kept.push(p + (corners[next] - p) * (here / (here - there)));
        }
    }
    kept
}

/// Whether what a cell holds lies in a plane and covers its hull there.
fn is_flat_and_full(cell: &Cell) -> bool {
    let points: Vec<Point> = cell.polygons.iter().flat_map(|p| p.corners.iter().copied()).collect();
    let hull = hull_corners(&points).and_then(|(corners, _)| Polytope::hull_of(&corners).ok());
    let Some(hull) = hull.filter(|body| body.dimension() == 2) else { return false };
    let whole = area(hull.vertices());
    let held: f64 = cell.polygons.iter().map(|p| area(&p.corners)).sum();
    (held - whole).abs() <= EXACT_VOLUME * whole
}

fn area(corners: &[Point]) -> f64 {
    let spoke = |k: usize| corners[k] - corners[0];
    0.5 * (1..corners.len().saturating_sub(1)).map(|k| spoke(k).cross(&spoke(k + 1))).sum::<Vector>().norm()
}

enum Reach {
    /// Nowhere farther than this, m.
    Within(f64),
    /// Farther than the tolerance here.
    Beyond(Point),
}

/// A tetrahedron of a part, the distance of its middle from the piece, and how far it can reach.
struct Tetrahedron {
    corners: [Point; 4],
    middle: Point,
    distance: f64,
    bound: f64,
}

impl PartialEq for Tetrahedron {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Tetrahedron {}

impl PartialOrd for Tetrahedron {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Tetrahedron {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

/// A body as tetrahedra around its middle.
fn tetrahedra(body: &Polytope) -> impl Iterator<Item = [Point; 4]> + '_ {
    let (v, middle) = (body.vertices(), body.centroid());
    let fan = move |c: &'_ [usize]| -> Vec<[Point; 4]> {
        (1..c.len() - 1).map(|k| [middle, v[c[0]], v[c[k]], v[c[k + 1]]]).collect()
    };
    body.facets().iter().flat_map(move |f| fan(&f.corners))
}

/// A tetrahedron cut through the middle of its longest edge.
fn halves(corners: &[Point; 4]) -> [[Point; 4]; 2] {
    const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    let length = |[i, j]: [usize; 2]| (corners[j] - corners[i]).norm_squared();
    let longest = EDGES.into_iter().max_by(|a, b| length(*a).total_cmp(&length(*b))).expect("six");
    let middle = nalgebra::center(&corners[longest[0]], &corners[longest[1]]);
    longest.map(|k| {
        let mut half = *corners;
        half[k] = middle;
        half
    })
}

/// A convex body with volume around points: their hull where it has few corners, else planes that touch it.
fn around(points: &[Point]) -> Polytope {
    let Some((corners, triangles)) = hull_corners(points) else { return fattened(points) };
    let exact = || Polytope::hull_of(&corners).ok().filter(|body| is_sound(body, points));
    if corners.len() <= MOST_PART_CORNERS
        && let Some(body) = exact()
    {
        return body;
    }
    let mut faces: Vec<Vector> =
        triangles.iter().map(|[a, b, c]| (corners[*b] - corners[*a]).cross(&(corners[*c] - corners[*a]))).collect();
    faces.sort_by(|a, b| b.norm_squared().total_cmp(&a.norm_squared()));
    bounded(&corners, &faces, 0.0).filter(|body| is_sound(body, points)).unwrap_or_else(|| fattened(points))
}

/// The same with room on all sides, for points that may lie in a plane.
fn fattened(points: &[Point]) -> Polytope {
    let corners = hull_corners(points).map_or_else(|| points.to_vec(), |(corners, _)| corners);
    let hull = Polytope::hull_of(&corners).ok();
    let mut directions = Vec::new();
    for facet in hull.iter().flat_map(Polytope::facets) {
        directions.push(facet.normal);
        let edges = hull.iter().flat_map(|body| facet.edges().map(|[i, j]| body.vertices()[j] - body.vertices()[i]));
        directions.extend(edges.map(|edge| edge.cross(&facet.normal)));
    }
    let fat = bounded(&corners, &directions, SHEET).filter(|body| is_sound(body, points));
    fat.unwrap_or_else(|| bounded(points, &[], SHEET).expect("a box"))
}

/// The body between planes that touch points, moved outward by `margin`, m: the six sides of a box, and planes with
/// these normals; where there are many, one of those that are nearly the same, the first.
fn bounded(points: &[Point], normals: &[Vector], margin: f64) -> Option<Polytope> {
    let axes = [Vector::x(), Vector::y(), Vector::z()];
    let mut spread: Vec<Vector> = axes.iter().flat_map(|axis| [*axis, -axis]).collect();
    let near = if normals.len() > 4 * MOST_PART_CORNERS { SPREAD_NORMALS } else { 1.0 - PARALLEL };
    for normal in normals.iter().filter_map(|n| n.try_normalize(0.0)) {
        if spread.iter().all(|other| other.dot(&normal) < near) {
            spread.push(normal);
        }
    }
    let aabb = Aabb::around(points);
    let room = Vector::repeat(margin);
    let within = Aabb { min: aabb.min - room, max: aabb.max + room };
    let planes: Vec<HalfSpace> =
        spread.iter().skip(6).map(|normal| HalfSpace::around(points, *normal).widened(margin)).collect();
    Polytope::hull_of(&convex_mesh(&planes, &within)?.vertices).ok()
}
