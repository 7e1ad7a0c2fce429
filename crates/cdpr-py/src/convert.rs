//! Rows of C-contiguous (n, 3) arrays as points, without a copy of the array.

use cdpr_core::geometry::Point;

/// The k-th row.
#[inline]
pub fn row(rows: &[f64], k: usize) -> Point {
    Point::from_slice(&rows[3 * k..3 * k + 3])
}

/// All rows.
pub fn points(rows: &[f64]) -> Vec<Point> {
    rows.chunks_exact(3).map(Point::from_slice).collect()
}

/// Three numbers.
pub fn point(numbers: [f64; 3]) -> Point {
    Point::from(numbers)
}
