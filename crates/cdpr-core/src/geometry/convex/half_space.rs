//! Convex polyhedra as intersections of half-spaces; they may be unbounded.

use crate::geometry::{Point, Polytope, Vector};

/// The open half-space of points x with `normal · x < offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSpace {
    /// Unit outward normal.
    pub normal: Vector,
    /// Distance of the bounding plane from the origin along the normal, m.
    pub offset: f64,
}

impl HalfSpace {
    /// The half-space with a bounding plane of this unit outward normal through `point`.
    pub fn through(point: &Point, normal: Vector) -> Self {
        HalfSpace { normal, offset: normal.dot(&point.coords) }
    }

    /// The smallest half-space with this unit outward normal whose closure contains all `points`.
    pub fn around(points: &[Point], normal: Vector) -> Self {
        let offset = points.iter().map(|p| normal.dot(&p.coords)).fold(f64::NEG_INFINITY, f64::max);
        HalfSpace { normal, offset }
    }

    /// Height of a point above the bounding plane, m; negative inside.
    #[inline]
    pub fn height(&self, point: &Point) -> f64 {
        self.normal.dot(&point.coords) - self.offset
    }

    /// The half-space moved.
    pub fn moved(&self, by: &Vector) -> Self {
        HalfSpace { normal: self.normal, offset: self.offset + self.normal.dot(by) }
    }

    /// The half-space reflected in a point: { 2c - x }, for `twice` = 2c.
    pub fn reflected(&self, twice: &Vector) -> Self {
        HalfSpace { normal: -self.normal, offset: self.offset - self.normal.dot(twice) }
    }

    /// The half-space with its plane moved outward, m.
    pub fn widened(&self, by: f64) -> Self {
        HalfSpace { normal: self.normal, offset: self.offset + by }
    }
}

impl Polytope {
    /// The half-spaces of the facets; their intersection is the interior of a body with volume.
    pub fn half_spaces(&self) -> Vec<HalfSpace> {
        self.facets().iter().map(|f| HalfSpace { normal: f.normal, offset: f.offset }).collect()
    }
}
