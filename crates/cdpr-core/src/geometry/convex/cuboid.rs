//! Axis-aligned boxes of positions, with centre and half sides at hand for bounds.

use crate::geometry::{HalfSpace, Point, Vector};

/// A closed box of positions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cuboid {
    /// Smallest coordinates of the box, m.
    pub low: Point,
    /// Largest coordinates of the box, m.
    pub high: Point,
    /// Centre of the box, m.
    pub center: Point,
    /// Half the sides of the box, m.
    pub half: Vector,
}

/// An axis is halved together with the longest one if it is more than this share of it.
const ABOUT_AS_LONG: f64 = 0.7;

impl Cuboid {
    /// The box between two corners.
    pub fn new(low: Point, high: Point) -> Self {
        Cuboid { low, high, center: nalgebra::center(&low, &high), half: (high - low) * 0.5 }
    }

    /// The smallest box around some points.
    pub fn around(points: &[Point]) -> Self {
        let low = points.iter().fold(points[0], |low, p| low.inf(p));
        let high = points.iter().fold(points[0], |high, p| high.sup(p));
        Self::new(low, high)
    }

    /// Largest height of the box's points above a plane, m.
    #[inline]
    pub fn highest(&self, plane: &HalfSpace) -> f64 {
        plane.height(&self.center) + plane.normal.abs().dot(&self.half)
    }

    /// Smallest height of the box's points above a plane, m.
    #[inline]
    pub fn lowest(&self, plane: &HalfSpace) -> f64 {
        plane.height(&self.center) - plane.normal.abs().dot(&self.half)
    }

    /// The eight boxes into which the planes through the centre divide the box.
    pub fn eighths(&self) -> [Self; 8] {
        self.corners().map(|corner| Self::around(&[corner, self.center]))
    }

    /// The boxes into which the planes through the centre across its longest axes divide the box: two, four or eight, all about as
    /// long as they are wide.
    pub fn parts(&self) -> Vec<Self> {
        let is_long: [bool; 3] = std::array::from_fn(|axis| self.half[axis] > ABOUT_AS_LONG * self.half.max());
        let corners = (0..8).filter(|k| (0..3).all(|axis| is_long[axis] || k >> axis & 1 == 0));
        let part = |k: usize| {
            let (mut low, mut high) = (self.low, self.high);
            for axis in (0..3).filter(|axis| is_long[*axis]) {
                let end = if k >> axis & 1 == 0 { &mut high } else { &mut low };
                end[axis] = self.center[axis];
            }
            Self::new(low, high)
        };
        corners.map(part).collect()
    }

    /// The eight corners of the box.
    pub fn corners(&self) -> [Point; 8] {
        let ends = [self.low, self.high];
        std::array::from_fn(|k| Point::from(Vector::from_fn(|axis, _| ends[k >> axis & 1][axis])))
    }

    /// The point of the box nearest to another point, m.
    pub fn nearest_to(&self, point: &Point) -> Point {
        point.sup(&self.low).inf(&self.high)
    }

    /// Whether two boxes have a point in common.
    pub fn touches(&self, other: &Cuboid) -> bool {
        (0..3).all(|axis| self.low[axis] <= other.high[axis] && other.low[axis] <= self.high[axis])
    }

    /// Volume of the box, m³.
    pub fn volume(&self) -> f64 {
        (self.high - self.low).product()
    }
}
