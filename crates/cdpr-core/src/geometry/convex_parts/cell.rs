//! The content of one cell of a mesh decomposition: polygons over points, and the cutting planes.

use std::collections::{HashMap, HashSet};

use nalgebra::{Matrix3, SymmetricEigen};

use crate::error::Error;
use crate::geometry::convex::hull::flat_ring;
use crate::geometry::surface::solid::LOOK;
use crate::geometry::{Aabb, HalfSpace, Point, Vector};
use crate::tolerances::{FLAT_SHEET, ON_SURFACE};
use crate::watch::Watch;

/// Maximum number of pairs of edges that are compared to find out whether a flat surface is convex.
const MOST_RIM_STEPS: usize = 100_000_000;

/// An intersection of half-spaces, and the flat convex polygons of the surface in it.
pub(super) struct Cell {
    pub sides: Vec<HalfSpace>,
    pub points: Vec<Point>,
    /// Corners of the polygons, one polygon after another, as indices into the points.
    corners: Vec<u32>,
    /// For each polygon: its plane, and the end of its corners.
    ends: Vec<(u32, u32)>,
}

impl Cell {
    /// All triangles, with the indices of the planes that they lie in.
    pub fn whole(triangles: &[[Point; 3]], plane_of: &[u32], watch: &Watch) -> Result<Self, Error> {
        let mut cell = Cell { sides: Vec::new(), points: Vec::new(), corners: Vec::new(), ends: Vec::new() };
        let mut places: HashMap<[u64; 3], u32> = HashMap::new();
        for (k, (triangle, plane)) in triangles.iter().zip(plane_of).enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            for p in triangle {
                let points = &mut cell.points;
                cell.corners.push(*places.entry([p.x, p.y, p.z].map(f64::to_bits)).or_insert_with(|| {
                    points.push(*p);
                    points.len() as u32 - 1
                }));
            }
            cell.ends.push((*plane, cell.corners.len() as u32));
        }
        Ok(cell)
    }

    /// Number of polygons.
    pub fn count(&self) -> usize {
        self.ends.len()
    }

    /// The plane and the corners of every polygon.
    pub fn polygons(&self) -> impl Iterator<Item = (u32, &[u32])> {
        let starts = std::iter::once(0).chain(self.ends.iter().map(|(_, end)| *end as usize));
        self.ends.iter().zip(starts).map(|((plane, end), start)| (*plane, &self.corners[start..*end as usize]))
    }

    /// Twice the area of a polygon, along its normal.
    pub fn doubled_area(&self, ring: &[u32]) -> Vector {
        let spoke = |k: usize| self.points[ring[k] as usize] - self.points[ring[0] as usize];
        (1..ring.len().saturating_sub(1)).map(|k| spoke(k).cross(&spoke(k + 1))).sum()
    }

    pub fn aabb(&self) -> Aabb {
        Aabb::around(&self.points)
    }

    /// The parts behind and in front of a plane. A polygon in the plane goes to the side of its body, which the normals
    /// of the surface's planes determine; without them it goes behind.
    pub fn halves(
        &self,
        plane: &HalfSpace,
        normals: Option<&[HalfSpace]>,
        on_plane: f64,
        watch: &Watch,
    ) -> Result<[Cell; 2], Error> {
        let heights: Vec<f64> = self.points.iter().map(|p| plane.height(p)).collect();
        let before = HalfSpace { normal: -plane.normal, offset: -plane.offset };
        let mut halves = [*plane, before].map(|side| Half::new(self, side));
        for (k, (number, ring)) in self.polygons().enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            let height = |i: &u32| heights[*i as usize];
            let highest = ring.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
            let lowest = ring.iter().map(height).fold(f64::INFINITY, f64::min);
            match (highest <= on_plane, lowest >= -on_plane) {
                (true, true) => {
                    let looks_back = normals.is_some_and(|n| n[number as usize].normal.dot(&plane.normal) < 0.0);
                    halves[usize::from(looks_back)].take(number, ring);
                }
                (true, false) => halves[0].take(number, ring),
                (false, true) => halves[1].take(number, ring),
                (false, false) => {
                    halves[0].clip(number, ring, &heights, 1.0);
                    halves[1].clip(number, ring, &heights, -1.0);
                }
            }
        }
        Ok(halves.map(|half| half.cell))
    }

    /// The points behind and in front of a plane; the points where polygons cross it are in both.
    pub fn points_beside(&self, plane: &HalfSpace, on_plane: f64) -> [Vec<Point>; 2] {
        let heights: Vec<f64> = self.points.iter().map(|p| plane.height(p)).collect();
        let mut sides = [Vec::new(), Vec::new()];
        let (mut below, mut above) = (false, false);
        for (p, h) in self.points.iter().zip(&heights) {
            below |= *h < -on_plane;
            above |= *h > on_plane;
            if *h <= on_plane {
                sides[0].push(*p);
            }
            if *h >= -on_plane {
                sides[1].push(*p);
            }
        }
        if !(below && above) {
            return [Vec::new(), Vec::new()];
        }
        for (_, ring) in self.polygons() {
            for (k, i) in ring.iter().enumerate() {
                let j = ring[(k + 1) % ring.len()];
                let (here, there) = (heights[*i as usize], heights[j as usize]);
                if here < -on_plane && there > on_plane || here > on_plane && there < -on_plane {
                    let (p, q) = (self.points[*i as usize], self.points[j as usize]);
                    let crossing = p + (q - p) * (here / (here - there));
                    sides[0].push(crossing);
                    sides[1].push(crossing);
                }
            }
        }
        sides
    }
}

/// One half of a cell, while it is being filled.
struct Half<'a> {
    whole: &'a Cell,
    cell: Cell,
    /// For each point of the whole, its index in the half.
    places: Vec<u32>,
    crossings: HashMap<[u32; 2], u32>,
}

impl<'a> Half<'a> {
    fn new(whole: &'a Cell, side: HalfSpace) -> Self {
        let sides = whole.sides.iter().copied().chain([side]).collect();
        let cell = Cell { sides, points: Vec::new(), corners: Vec::new(), ends: Vec::new() };
        Half { whole, cell, places: vec![u32::MAX; whole.points.len()], crossings: HashMap::new() }
    }

    fn push(&mut self, i: u32) {
        let place = &mut self.places[i as usize];
        if *place == u32::MAX {
            *place = self.cell.points.len() as u32;
            self.cell.points.push(self.whole.points[i as usize]);
        }
        self.cell.corners.push(*place);
    }

    fn end(&mut self, plane: u32) {
        self.cell.ends.push((plane, self.cell.corners.len() as u32));
    }

    fn take(&mut self, plane: u32, ring: &[u32]) {
        ring.iter().for_each(|i| self.push(*i));
        self.end(plane);
    }

    /// The part of a polygon where height times sign is at most zero (Sutherland–Hodgman).
    fn clip(&mut self, plane: u32, ring: &[u32], heights: &[f64], sign: f64) {
        for (k, i) in ring.iter().enumerate() {
            let j = ring[(k + 1) % ring.len()];
            let (here, there) = (sign * heights[*i as usize], sign * heights[j as usize]);
            if here <= 0.0 {
                self.push(*i);
            }
            if (here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0) {
                // From the lower index to the higher, so that neighbours compute the same point.
                let [from, to] = [*i.min(&j), *i.max(&j)];
                let [a, b] = [from, to].map(|i| heights[i as usize]);
                let [p, q] = [from, to].map(|i| self.whole.points[i as usize]);
                let points = &mut self.cell.points;
                let place = *self.crossings.entry([from, to]).or_insert_with(|| {
                    points.push(p + (q - p) * (a / (a - b)));
                    points.len() as u32 - 1
                });
                self.cell.corners.push(place);
            }
        }
        self.end(plane);
    }
}

/// How far the surface in a cell is from flat, m, if it is flat up to [`FLAT_SHEET`] and fills the convex hull of its points;
/// `None` otherwise.
///
/// Seen along the normal, all polygons turn the same way, so where edges of neighbours do not cancel, they bound the
/// region that is covered. If all that are left lie on the rim of the hull, every point within is covered equally often.
pub(super) fn flat_excess(cell: &Cell) -> Option<f64> {
    let largest = cell.polygons().map(|(_, ring)| cell.doubled_area(ring));
    let normal = largest.max_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared()))?.try_normalize(0.0)?;
    let plane = HalfSpace::through(&cell.points[0], normal);
    let excess = cell.points.iter().map(|p| plane.height(p).abs()).fold(0.0, f64::max);
    if excess > FLAT_SHEET {
        return None;
    }
    let mut left: HashSet<[u32; 2]> = HashSet::new();
    for (_, ring) in cell.polygons() {
        let turned = cell.doubled_area(ring).dot(&normal) < 0.0;
        for (k, i) in ring.iter().enumerate() {
            let j = ring[(k + 1) % ring.len()];
            let [from, to] = if turned { [j, *i] } else { [*i, j] };
            if !left.remove(&[to, from]) && !left.insert([from, to]) {
                return None; // polygons lie on each other
            }
        }
    }
    let rim = flat_ring(&cell.points)?;
    let sides = rim.iter().zip(rim.iter().cycle().skip(1));
    let sides: Vec<HalfSpace> =
        sides.filter_map(|(p, q)| Some(HalfSpace::through(p, (q - p).cross(&normal).try_normalize(0.0)?))).collect();
    let on_rim = |[i, j]: &[u32; 2]| {
        let ends = [i, j].map(|i| cell.points[*i as usize]);
        sides.iter().any(|side| ends.iter().all(|p| side.height(p).abs() <= ON_SURFACE))
    };
    (left.len() * sides.len() <= MOST_RIM_STEPS && left.iter().all(on_rim)).then_some(excess)
}

/// Mean of a cell's surface, and its principal axes, longest first.
pub(super) fn mean_and_axes(cell: &Cell) -> (Point, [Vector; 3]) {
    let (mut area, mut first, mut second) = (0.0, Vector::zeros(), Matrix3::zeros());
    let origin = cell.points[0];
    for (_, ring) in cell.polygons() {
        let share = cell.doubled_area(ring).norm();
        let sum: Vector = ring.iter().map(|i| cell.points[*i as usize] - origin).sum();
        let middle = sum / ring.len() as f64;
        area += share;
        first += middle * share;
        // The spread of the corners replaces that of the polygon, so that a few large polygons have axes, too.
        second += middle * middle.transpose() * share;
        for i in ring {
            let spoke = cell.points[*i as usize] - origin - middle;
            second += spoke * spoke.transpose() * (share / (4.0 * ring.len() as f64));
        }
    }
    if !(area > 0.0) {
        return (origin, [Vector::x(), Vector::y(), Vector::z()]);
    }
    let mean = first / area;
    let eigen = SymmetricEigen::new(second / area - mean * mean.transpose());
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
    (origin + mean, order.map(|k| eigen.eigenvectors.column(k).into_owned()))
}
