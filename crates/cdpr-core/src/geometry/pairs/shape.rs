//! The convex sets of the collision conditions: polytopes at rest, triangles swept by cables, prisms swept by the
//! platform. None is stored as a hull: GJK needs support points, separating axes need directions.

use super::features::Boundary;
use crate::geometry::convex::polytope::{farthest, unit_cross};
use crate::geometry::{Aabb, Point, Polytope, Vector};
use crate::tolerances::{NO_MOTION, NO_WIDTH};

/// A convex set described by its support map, which is all that GJK needs.
pub trait SupportMap {
    /// A point of the set farthest along `direction` (of any nonzero length).
    fn support(&self, direction: &Vector) -> Point;
    /// Some point of the set near its centre.
    fn center(&self) -> Point;
}

/// A convex set with the directions of its faces and edges, which exact tests need as well.
pub trait ConvexShape: SupportMap {
    /// Unit normals of the faces, up to sign; a superset is fine.
    fn normals(&self) -> impl Iterator<Item = Vector>;
    /// Unit directions of the edges, up to sign; a superset is fine.
    fn edges(&self) -> impl Iterator<Item = Vector> + Clone;
    /// The edges and faces in space.
    fn boundary(&self) -> Boundary;

    /// Whether contact is decided exactly. If not, what GJK cannot prove to be apart counts as too close, which saves the slow
    /// tests of shapes with many edges.
    fn is_exact(&self) -> bool {
        true
    }

    /// The axis-aligned box around the set.
    fn aabb(&self) -> Aabb {
        let reach = |axis: usize, sign: f64| self.support(&Vector::ith(axis, sign))[axis];
        let corner = |sign: f64| Point::new(reach(0, sign), reach(1, sign), reach(2, sign));
        Aabb { min: corner(-1.0), max: corner(1.0) }
    }
}

impl SupportMap for Point {
    #[inline]
    fn support(&self, _direction: &Vector) -> Point {
        *self
    }

    fn center(&self) -> Point {
        *self
    }
}

impl SupportMap for Polytope {
    #[inline]
    fn support(&self, direction: &Vector) -> Point {
        farthest(self.vertices(), direction)
    }

    fn center(&self) -> Point {
        self.centroid()
    }
}

impl ConvexShape for Polytope {
    fn normals(&self) -> impl Iterator<Item = Vector> {
        self.normal_axes().iter().copied()
    }

    fn edges(&self) -> impl Iterator<Item = Vector> + Clone {
        self.edge_axes().iter().copied()
    }

    fn boundary(&self) -> Boundary {
        let at = |i: usize| self.vertices()[i];
        let faces: Vec<Vec<Point>> = self.facets().iter().map(|f| f.corners.iter().map(|&i| at(i)).collect()).collect();
        let edges = if self.dimension() < 2 {
            vec![[at(0), at(self.vertices().len() - 1)]]
        } else {
            self.facets().iter().flat_map(|f| f.edges()).filter(|[i, j]| i < j).map(|[i, j]| [at(i), at(j)]).collect()
        };
        Boundary { edges, faces }
    }
}

/// The triangle a straight cable sweeps while its attachment moves along a straight line (the paper, section 3.1);
/// with equal attachments, the cable itself.
#[derive(Debug, Clone, Copy)]
pub struct Triangle {
    /// Outlet, then the attachment before and after the motion.
    pub corners: [Point; 3],
}

impl Triangle {
    /// The triangle with these corners; any of them may coincide.
    #[inline]
    pub fn new(outlet: Point, from: Point, to: Point) -> Self {
        Self { corners: [outlet, from, to] }
    }

    fn sides(&self) -> [Vector; 3] {
        let [b, p, q] = self.corners;
        [p - b, q - b, q - p]
    }
}

impl SupportMap for Triangle {
    #[inline]
    fn support(&self, direction: &Vector) -> Point {
        farthest(&self.corners, direction)
    }

    fn center(&self) -> Point {
        let [b, p, q] = self.corners;
        Point::from((b.coords + p.coords + q.coords) / 3.0)
    }
}

impl ConvexShape for Triangle {
    fn normals(&self) -> impl Iterator<Item = Vector> {
        let mut sides = self.sides();
        sides.sort_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared()));
        // The two shorter sides: their differences have the smallest rounding error.
        let normal = sides[0].cross(&sides[1]);
        // If narrower than the touching tolerance, the triangle is a segment and has no face of its own.
        (normal.norm() > NO_WIDTH * sides[1].norm()).then(|| normal.normalize()).into_iter()
    }

    fn edges(&self) -> impl Iterator<Item = Vector> + Clone {
        self.sides().into_iter().filter(|side| side.norm() > 0.0).map(|side| side.normalize())
    }

    fn boundary(&self) -> Boundary {
        let [b, p, q] = self.corners;
        Boundary { edges: vec![[b, p], [b, q], [p, q]], faces: vec![vec![b, p, q]] }
    }

    #[inline]
    fn aabb(&self) -> Aabb {
        Aabb::around(&self.corners)
    }
}

/// The convex hull of copies of a point set, scaled and moved, and of further points: what a cable sweeps that can leave the
/// frame at several points.
#[derive(Debug, Clone, Copy)]
pub struct Fan<'a> {
    /// The point set; not empty.
    pub points: &'a [Point],
    /// Factor and displacement of each copy.
    pub copies: [(f64, Vector); 3],
    /// Further points.
    pub ends: [Point; 4],
}

impl Fan<'_> {
    /// A point set as it is, for [`Fan::copies`].
    pub const AS_IT_IS: (f64, Vector) = (1.0, Vector::new(0.0, 0.0, 0.0));

    /// The hull of a point set, which is not empty.
    pub fn around(points: &[Point]) -> Fan<'_> {
        Fan { points, copies: [Fan::AS_IT_IS; 3], ends: [points[0]; 4] }
    }

    fn corners(&self) -> Vec<Point> {
        let copied = self.copies.iter().flat_map(|(scale, by)| self.points.iter().map(move |p| p * *scale + by));
        copied.chain(self.ends).collect()
    }

    /// The hull; `None` if it is too close to degenerate.
    fn hull(&self) -> Option<Polytope> {
        Polytope::hull_of(&self.corners()).ok()
    }
}

impl SupportMap for Fan<'_> {
    #[inline]
    fn support(&self, direction: &Vector) -> Point {
        let end = farthest(&self.ends, direction);
        let point = farthest(self.points, direction);
        let copies = self.copies.iter().map(|(scale, by)| point * *scale + by);
        copies.fold(end, |best, p| if p.coords.dot(direction) > best.coords.dot(direction) { p } else { best })
    }

    fn center(&self) -> Point {
        let (scale, by) = self.copies[0];
        nalgebra::center(&(self.points[0] * scale + by), &self.ends[0])
    }
}

// Only distances for messages compute the hull.
impl ConvexShape for Fan<'_> {
    fn is_exact(&self) -> bool {
        false
    }

    fn normals(&self) -> impl Iterator<Item = Vector> {
        self.hull().map_or(Vec::new(), |hull| hull.normal_axes().to_vec()).into_iter()
    }

    fn edges(&self) -> impl Iterator<Item = Vector> + Clone {
        self.hull().map_or(Vec::new(), |hull| hull.edge_axes().to_vec()).into_iter()
    }

    fn boundary(&self) -> Boundary {
        if let Some(hull) = self.hull() {
            return hull.boundary();
        }
        let corners = self.corners();
        let edges = corners.iter().enumerate().flat_map(|(k, p)| corners[k..].iter().map(|q| [*p, *q])).collect();
        Boundary { edges, faces: Vec::new() }
    }
}

/// What a cable sweeps.
#[derive(Debug, Clone, Copy)]
pub enum CableSweep<'a> {
    /// A straight cable from a fixed outlet.
    Straight(Triangle),
    /// A cable that can take several shapes.
    Fan(Fan<'a>),
}

impl CableSweep<'_> {
    fn parts(&self) -> (Option<&Triangle>, Option<&Fan<'_>>) {
        match self {
            CableSweep::Straight(triangle) => (Some(triangle), None),
            CableSweep::Fan(fan) => (None, Some(fan)),
        }
    }
}

impl SupportMap for CableSweep<'_> {
    #[inline]
    fn support(&self, direction: &Vector) -> Point {
        match self {
            CableSweep::Straight(triangle) => triangle.support(direction),
            CableSweep::Fan(fan) => fan.support(direction),
        }
    }

    fn center(&self) -> Point {
        match self {
            CableSweep::Straight(triangle) => triangle.center(),
            CableSweep::Fan(fan) => fan.center(),
        }
    }
}

impl ConvexShape for CableSweep<'_> {
    fn normals(&self) -> impl Iterator<Item = Vector> {
        let (triangle, fan) = self.parts();
        triangle.into_iter().flat_map(Triangle::normals).chain(fan.into_iter().flat_map(Fan::normals))
    }

    fn edges(&self) -> impl Iterator<Item = Vector> + Clone {
        let (triangle, fan) = self.parts();
        triangle.into_iter().flat_map(Triangle::edges).chain(fan.into_iter().flat_map(Fan::edges))
    }

    fn boundary(&self) -> Boundary {
        match self {
            CableSweep::Straight(triangle) => triangle.boundary(),
            CableSweep::Fan(fan) => fan.boundary(),
        }
    }

    #[inline]
    fn is_exact(&self) -> bool {
        matches!(self, CableSweep::Straight(_))
    }

    #[inline]
    fn aabb(&self) -> Aabb {
        match self {
            CableSweep::Straight(triangle) => triangle.aabb(),
            CableSweep::Fan(fan) => fan.aabb(),
        }
    }
}

/// The set swept by a body in a straight translation: conv(K ∪ (K + d)), where `from` is the translation at the start.
#[derive(Debug, Clone, Copy)]
pub struct Swept<'a> {
    body: &'a Polytope,
    from: Vector,
    along: Vector,
}

impl<'a> Swept<'a> {
    /// `body` translated by `from`, then swept by `along`.
    #[inline]
    pub fn new(body: &'a Polytope, from: Vector, along: Vector) -> Self {
        Self { body, from, along }
    }

    fn direction(&self) -> Option<Vector> {
        (self.along.norm() > NO_MOTION).then(|| self.along.normalize())
    }
}

impl SupportMap for Swept<'_> {
    #[inline]
    fn support(&self, direction: &Vector) -> Point {
        let at = self.body.support(direction) + self.from;
        if self.along.dot(direction) > 0.0 { at + self.along } else { at }
    }

    fn center(&self) -> Point {
        self.body.centroid() + self.from + self.along * 0.5
    }
}

impl ConvexShape for Swept<'_> {
    fn normals(&self) -> impl Iterator<Item = Vector> {
        let sides = self
            .direction()
            .into_iter()
            .flat_map(|along| self.body.edge_axes().iter().filter_map(move |edge| unit_cross(edge, &along)));
        self.body.normal_axes().iter().copied().chain(sides)
    }

    fn edges(&self) -> impl Iterator<Item = Vector> + Clone {
        self.body.edge_axes().iter().copied().chain(self.direction())
    }

    fn boundary(&self) -> Boundary {
        let still = self.body.boundary();
        let moved = |p: &Point, by: &Vector| p + self.from + by;
        let ends = [Vector::zeros(), self.along];
        let mut swept = Boundary::default();
        for end in &ends {
            swept.edges.extend(still.edges.iter().map(|edge| edge.map(|p| moved(&p, end))));
            swept.faces.extend(still.faces.iter().map(|face| face.iter().map(|p| moved(p, end)).collect::<Vec<_>>()));
        }
        swept.edges.extend(self.body.vertices().iter().map(|v| ends.map(|end| moved(v, &end))));
        swept.faces.extend(still.edges.iter().map(|[p, q]| {
            let [start, end] = &ends;
            vec![moved(p, start), moved(q, start), moved(q, end), moved(p, end)]
        }));
        swept
    }
}
