//! Convex polygons in a plane, clipped by half-spaces: I. E. Sutherland and G. W. Hodgman (1974). Every side keeps the
//! plane that cut it, so that corners can be traced back to the edges of a polyhedron.

use crate::geometry::{HalfSpace, Point, Vector};

/// Coordinates in a [`Frame`].
pub type Place = [f64; 2];

/// A plane with a coordinate system.
#[derive(Debug, Clone)]
pub struct Frame {
    /// A point of the plane.
    pub origin: Point,
    /// Unit vector of the first coordinate.
    pub along: Vector,
    /// Unit vector of the second coordinate.
    pub across: Vector,
}

impl Frame {
    /// A point of the plane in space.
    pub fn point(&self, place: &Place) -> Point {
        self.origin + self.along * place[0] + self.across * place[1]
    }

    /// The height over a half-space, as coefficients of a x + b y + c in the coordinates of the plane.
    pub fn height(&self, half_space: &HalfSpace) -> [f64; 3] {
        let normal = &half_space.normal;
        [normal.dot(&self.along), normal.dot(&self.across), half_space.height(&self.origin)]
    }
}

/// A corner of a polygon, and the plane that cut the side from it to the next one; `None` for a side of the original
/// polygon.
#[derive(Debug, Clone, Copy)]
pub struct Corner {
    pub place: Place,
    pub line: Option<usize>,
}

/// A convex polygon, with scratch memory for clipping.
#[derive(Debug, Default)]
pub struct Polygon {
    corners: Vec<Corner>,
    clipped: Vec<Corner>,
}

impl Polygon {
    /// Starts with a polygon whose sides have no plane.
    pub fn begin(&mut self, corners: impl IntoIterator<Item = Place>) {
        self.corners.clear();
        self.corners.extend(corners.into_iter().map(|place| Corner { place, line: None }));
    }

    /// Keeps the part where a x + b y + c is negative.
    pub fn clip(&mut self, [a, b, c]: [f64; 3], line: Option<usize>) {
        let height = |place: &Place| a * place[0] + b * place[1] + c;
        self.clipped.clear();
        for (k, from) in self.corners.iter().enumerate() {
            let to = &self.corners[(k + 1) % self.corners.len()];
            let (h, g) = (height(&from.place), height(&to.place));
            if h < 0.0 {
                self.clipped.push(*from);
            }
            if (h < 0.0) != (g < 0.0) {
                let t = h / (h - g);
                let place = [0, 1].map(|axis| from.place[axis] + t * (to.place[axis] - from.place[axis]));
                self.clipped.push(Corner { place, line: if h < 0.0 { line } else { from.line } });
            }
        }
        std::mem::swap(&mut self.corners, &mut self.clipped);
    }

    /// Corners of the polygon in order; empty if nothing is left.
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// Each corner with its predecessor.
    pub fn with_previous(&self) -> impl Iterator<Item = [Corner; 2]> {
        let count = self.corners.len();
        (0..count).map(move |k| [self.corners[(k + count - 1) % count], self.corners[k]])
    }
}
