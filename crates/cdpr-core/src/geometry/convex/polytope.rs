//! Convex polytopes of dimension 0 to 3 from vertex lists: corners, facets, edges, and the axes for exact tests.

use std::fmt;

use serde::{Serialize, Serializer};

pub use super::hull::Facet;
use super::hull::{self, Extent, Hull};
use crate::geometry::{Point, Rotation, Vector};
use crate::tolerances::{ON_SURFACE, PARALLEL, SAME_POINT};
use crate::words::small_length;

/// An axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Aabb {
    /// Smallest coordinates of the box, m.
    #[serde(serialize_with = "as_list")]
    pub min: Point,
    /// Largest coordinates of the box, m.
    #[serde(serialize_with = "as_list")]
    pub max: Point,
}

/// Serializes a point as [x, y, z].
pub(crate) fn as_list<S: Serializer>(point: &Point, serializer: S) -> Result<S::Ok, S::Error> {
    point.coords.as_slice().serialize(serializer)
}

impl Aabb {
    /// The smallest box around a nonempty list of points.
    #[inline]
    pub fn around(points: &[Point]) -> Self {
        let (mut min, mut max) = (points[0], points[0]);
        for p in &points[1..] {
            min = min.inf(p);
            max = max.sup(p);
        }
        Aabb { min, max }
    }

    /// The box widened on all sides, m.
    pub fn widened(&self, by: f64) -> Aabb {
        Aabb { min: self.min - Vector::repeat(by), max: self.max + Vector::repeat(by) }
    }

    /// The box around two boxes.
    pub fn around_both(&self, other: &Aabb) -> Aabb {
        Aabb { min: self.min.inf(&other.min), max: self.max.sup(&other.max) }
    }

    /// What two boxes have in common; `None` if they are apart.
    pub fn common(&self, other: &Aabb) -> Option<Aabb> {
        let (min, max) = (self.min.sup(&other.min), self.max.inf(&other.max));
        (0..3).all(|axis| min[axis] <= max[axis]).then_some(Aabb { min, max })
    }

    /// The greatest distance of points of two boxes, m.
    pub fn farthest(&self, other: &Aabb) -> f64 {
        (self.max - other.min).sup(&(other.max - self.min)).norm()
    }

    /// Whether the boxes are more than `gap` apart along some axis.
    #[inline]
    pub fn apart_by(&self, other: &Aabb, gap: f64) -> bool {
        (0..3).any(|k| self.min[k] - other.max[k] > gap || other.min[k] - self.max[k] > gap)
    }

    /// Distance of the boxes, m; zero if they meet.
    #[inline]
    pub fn distance(&self, other: &Aabb) -> f64 {
        (self.min - other.max).sup(&(other.min - self.max)).sup(&Vector::zeros()).norm()
    }

    /// The box swept in a translation from `from` to `to`.
    #[inline]
    pub fn swept(&self, from: &Vector, to: &Vector) -> Self {
        Aabb { min: self.min + from.inf(to), max: self.max + from.sup(to) }
    }
}

/// Why a vertex list is not a convex polytope.
#[derive(Debug, Clone, PartialEq)]
pub enum PolytopeError {
    /// No vertices at all.
    Empty,
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// Index of the vertex.
        index: usize,
    },
    /// A vertex lies strictly inside the hull of the others.
    InsideHull {
        /// Index of the vertex.
        index: usize,
        /// Depth of the vertex, m.
        depth: f64,
    },
    /// The hull is not a closed convex surface: the vertices are nearly degenerate.
    Degenerate,
}

impl fmt::Display for PolytopeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("found no vertices, expected at least one"),
            Self::NotFinite { index } => write!(f, "vertex {index} is not finite"),
            Self::InsideHull { index, depth } => write!(
                f,
                "vertex {index} lies {} inside the hull of the others; expected the corners of a convex body \
                 (split a concave one into convex parts of the same name, or remove the vertex)",
                small_length(*depth)
            ),
            Self::Degenerate => {
                f.write_str("the vertices are too close to degenerate for a convex hull; move or remove the slivers")
            }
        }
    }
}

/// A convex polytope: point, segment, flat polygon or body with volume.
#[derive(Debug, Clone, PartialEq)]
pub struct Polytope {
    vertices: Vec<Point>,
    dimension: usize,
    facets: Vec<Facet>,
    normal_axes: Vec<Vector>,
    edge_axes: Vec<Vector>,
    aabb: Aabb,
    centroid: Point,
}

impl Polytope {
    /// The polytope with these corners, in any order. Duplicates and points on the surface are dropped.
    ///
    /// # Errors
    /// A vertex that is not finite or lies strictly inside the hull of the others (deeper than
    /// [`ON_SURFACE`]), an empty list, or a nearly degenerate list.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::Polytope};
    /// let plate = Polytope::from_vertices(&[
    ///     Point::new(0.0, 0.0, 0.0), Point::new(1.0, 0.0, 0.0), Point::new(1.0, 1.0, 0.0), Point::new(0.0, 1.0, 0.0),
    ///     Point::new(0.5, 0.0, 0.0), // on an edge: accepted, dropped
    /// ])?;
    /// assert_eq!((plate.dimension(), plate.vertices().len()), (2, 4));
    /// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
    /// ```
    pub fn from_vertices(points: &[Point]) -> Result<Self, PolytopeError> {
        let body = Self::hull_of(points)?;
        match points.iter().map(|p| body.depth_of(p)).enumerate().find(|(_, depth)| *depth > ON_SURFACE) {
            Some((index, depth)) => Err(PolytopeError::InsideHull { index, depth }),
            None => Ok(body),
        }
    }

    /// The convex hull of a point cloud; points inside it are dropped.
    ///
    /// # Errors
    /// The errors of [`Polytope::from_vertices`], except that points inside the hull are accepted.
    pub fn hull_of(points: &[Point]) -> Result<Self, PolytopeError> {
        if points.is_empty() {
            return Err(PolytopeError::Empty);
        }
        if let Some(index) = points.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
            return Err(PolytopeError::NotFinite { index });
        }
        let points = without_duplicates(points);
        let extent = Extent::of(&points);
        let hull = match extent.dimension {
            0 => Hull { corners: vec![points[0]], facets: Vec::new() },
            1 => hull::segment_hull(&points, &extent),
            2 => hull::polygon_hull(&points, &extent).ok_or(PolytopeError::Degenerate)?,
            _ => hull::solid_hull(&points, &extent).ok_or(PolytopeError::Degenerate)?,
        };
        Ok(Self::from_hull(hull, extent.dimension))
    }

    /// The box with these full side lengths, centred at the origin; sides may be zero.
    ///
    /// # Errors
    /// Side lengths that are not finite.
    pub fn cuboid(sides: [f64; 3]) -> Result<Self, PolytopeError> {
        let corner = |k: usize| {
            let sign = |bit: usize| if k >> bit & 1 == 1 { 0.5 } else { -0.5 };
            Point::new(sign(0) * sides[0], sign(1) * sides[1], sign(2) * sides[2])
        };
        Self::hull_of(&std::array::from_fn::<_, 8, _>(corner))
    }

    /// The octahedron with these half diagonals, which are at right angles and right-handed.
    pub(in crate::geometry) fn octahedron(middle: &Point, [a, b, c]: &[Vector; 3]) -> Self {
        let corners = vec![middle + a, middle - a, middle + b, middle - b, middle + c, middle - c];
        let facet = |k: usize| {
            let [i, j, k] = [k & 1, 2 + (k >> 1 & 1), 4 + (k >> 2)];
            Facet::through(&corners, if (i + j + k) % 2 == 0 { vec![i, j, k] } else { vec![i, k, j] })
        };
        let facets = (0..8).map(facet).collect();
        Self::from_hull(Hull { corners, facets }, 3)
    }

    pub(super) fn from_hull(hull: Hull, dimension: usize) -> Self {
        let Hull { corners: vertices, facets } = hull;
        let normals = facets.iter().map(|f| f.normal);
        let spans = if dimension == 1 { vec![[0, 1]] } else { facets.iter().flat_map(Facet::edges).collect() };
        let edges = spans.iter().map(|[i, j]| (vertices[*j] - vertices[*i]).normalize());
        let (normal_axes, edge_axes) = (distinct_axes(normals), distinct_axes(edges));
        let centroid = Point::from(vertices.iter().map(|v| v.coords).sum::<Vector>() / vertices.len() as f64);
        let aabb = Aabb::around(&vertices);
        Self { vertices, dimension, facets, normal_axes, edge_axes, aabb, centroid }
    }

    /// This body rotated, then moved.
    pub fn transformed(&self, rotation: &Rotation, translation: &Vector) -> Self {
        let vertices = self.vertices.iter().map(|v| rotation * v + translation).collect::<Vec<_>>();
        let facets = self.facets.iter().map(|f| Facet::through(&vertices, f.corners.clone())).collect();
        Self::from_hull(Hull { corners: vertices, facets }, self.dimension)
    }

    /// A box with its six planes moved outward, m; also works for other bodies with three orthogonal facets at each
    /// corner.
    pub(crate) fn with_planes_moved(&self, by: f64) -> Option<Self> {
        let at = |corner: usize| self.facets.iter().filter(move |f| f.corners.contains(&corner)).map(|f| f.normal);
        let moved = |(k, v): (usize, &Point)| v + at(k).sum::<Vector>() * by;
        let corners: Vec<Point> = self.vertices.iter().enumerate().map(moved).collect();
        let facets = self.facets.iter().map(|f| {
            let height = |&k: &usize| f.normal.dot(&corners[k].coords);
            let offset = f.corners.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
            Facet { normal: f.normal, offset, corners: f.corners.clone() }
        });
        let facets = facets.collect();
        (0..self.vertices.len())
            .all(|k| at(k).count() == 3)
            .then(|| Self::from_hull(Hull { corners, facets }, self.dimension))
    }

    /// Corners of the body, m.
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// 0 for a point, 1 for a segment, 2 for a flat polygon, 3 for a body with volume.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Whether the body has an interior.
    pub fn has_volume(&self) -> bool {
        self.dimension == 3
    }

    /// Faces: the outer faces of a solid, both sides of a polygon; empty for a segment or point.
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }

    /// Face normals of the body, one of each pair of parallel ones.
    pub fn normal_axes(&self) -> &[Vector] {
        &self.normal_axes
    }

    /// Edge directions of the body, one of each pair of parallel ones.
    pub fn edge_axes(&self) -> &[Vector] {
        &self.edge_axes
    }

    /// The axis-aligned box around the body.
    pub fn aabb(&self) -> &Aabb {
        &self.aabb
    }

    /// Mean of the body's corners.
    pub fn centroid(&self) -> Point {
        self.centroid
    }

    /// Depth of a point below the surface of a body with volume, m; negative outside, and for flat bodies.
    pub fn depth_of(&self, point: &Point) -> f64 {
        if !self.has_volume() {
            return f64::NEG_INFINITY;
        }
        -self.facets.iter().map(|f| f.height(point)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Volume of the body, m³; zero for flat bodies.
    pub fn volume(&self) -> f64 {
        if !self.has_volume() {
            return 0.0;
        }
        let cone = |f: &Facet| {
            let spoke = |k: usize| self.vertices[f.corners[k]] - self.vertices[f.corners[0]];
            let area: f64 = (1..f.corners.len() - 1).map(|k| spoke(k).cross(&spoke(k + 1)).dot(&f.normal)).sum();
            -f.height(&self.centroid) * area / 6.0
        };
        self.facets.iter().map(cone).sum()
    }
}

/// The point of a non-empty list that is farthest along `direction`.
#[inline]
pub(crate) fn farthest(points: &[Point], direction: &Vector) -> Point {
    let mut best = points[0];
    let mut reach = best.coords.dot(direction);
    for point in &points[1..] {
        let r = point.coords.dot(direction);
        if r > reach {
            (reach, best) = (r, *point);
        }
    }
    best
}

fn without_duplicates(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for p in points {
        if !kept.iter().any(|q| (q - p).norm() <= SAME_POINT) {
            kept.push(*p);
        }
    }
    kept
}

/// One unit vector for each group of parallel ones.
fn distinct_axes(directions: impl Iterator<Item = Vector>) -> Vec<Vector> {
    let mut axes: Vec<Vector> = Vec::new();
    for direction in directions {
        if axes.iter().all(|axis| unit_cross(axis, &direction).is_some()) {
            axes.push(direction);
        }
    }
    axes
}

/// Unit cross product of two unit directions; `None` if they are parallel.
pub(in crate::geometry) fn unit_cross(a: &Vector, b: &Vector) -> Option<Vector> {
    let cross = a.cross(b);
    let norm = cross.norm();
    (norm > PARALLEL).then(|| cross / norm)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[[f64; 3]]) -> Vec<Point> {
        list.iter().map(|p| Point::from(*p)).collect()
    }

    #[test]
    fn a_box_has_six_facets_eight_corners_and_its_volume() {
        let body = Polytope::cuboid([0.3, 0.2, 1.5]).unwrap();
        assert_eq!((body.facets().len(), body.vertices().len(), body.dimension()), (6, 8, 3));
        assert_eq!((body.normal_axes().len(), body.edge_axes().len()), (3, 3));
        assert!((body.volume() - 0.09).abs() < 1e-15);
    }

    #[test]
    fn duplicates_and_points_on_faces_and_edges_are_dropped() {
        let mut list = Polytope::cuboid([2.0; 3]).unwrap().vertices().to_vec();
        list.extend(points(&[[0.0, 0.0, 1.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [0.3, -1.0, 0.2]]));
        let body = Polytope::from_vertices(&list).unwrap();
        assert_eq!((body.facets().len(), body.vertices().len()), (6, 8));
    }

    #[test]
    fn a_vertex_inside_is_named_with_its_depth() {
        let mut list = Polytope::cuboid([2.0; 3]).unwrap().vertices().to_vec();
        list.push(Point::new(0.0, 0.0, 0.9));
        let error = Polytope::from_vertices(&list).unwrap_err();
        assert!(matches!(error, PolytopeError::InsideHull { index: 8, depth } if (depth - 0.1).abs() < 1e-12));
    }

    #[test]
    fn flat_bodies_have_their_dimension_and_no_volume() {
        for (sides, dimension, corners) in [([1.0, 2.0, 0.0], 2, 4), ([0.0, 0.0, 3.0], 1, 2), ([0.0; 3], 0, 1)] {
            let body = Polytope::cuboid(sides).unwrap();
            assert_eq!((body.dimension(), body.vertices().len(), body.volume()), (dimension, corners, 0.0));
        }
    }

    #[test]
    fn not_finite_is_told_by_index() {
        let list = points(&[[0.0; 3], [1.0, f64::NAN, 0.0]]);
        assert_eq!(Polytope::from_vertices(&list), Err(PolytopeError::NotFinite { index: 1 }));
        assert_eq!(Polytope::from_vertices(&[]), Err(PolytopeError::Empty));
    }
}
