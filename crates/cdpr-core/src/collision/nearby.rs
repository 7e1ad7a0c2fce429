//! A valid position near one that is not.

use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::watch::Watch;

/// Directions in which a valid position is sought, evenly spread over the sphere.
const DIRECTIONS: usize = 200;
/// Distances that are tried, from the smallest to the size of the workspace in equal ratios.
const DISTANCES: usize = 40;
/// The smallest distance, as a fraction of the diagonal of the workspace.
const LEAST: f64 = 1e-4;
/// Halvings of the way back toward the invalid position.
const HALVINGS: usize = 24;

/// A valid position close to one that is not, for suggestions: the first one found on spheres of growing radius, moved
/// back toward the position as far as it stays valid. Not always the closest. `None` if none was found; `positions` are
/// the corners of the box of positions.
///
/// # Example
/// ```
/// use cdpr_core::{Interference, Validity, collision::{CspaceEngine, valid_nearby}};
/// use cdpr_core::Point;
/// let engine = CspaceEngine::new(&cdpr_core::testing::hard1(), Interference::Exact)?;
/// let positions = (Point::origin(), Point::new(2.0, 2.0, 2.0));
/// let inside = Point::new(0.8, 1.0, 0.3); // in the pillar, which the platform touches at x = 0.775
/// let near = valid_nearby(positions, &inside, |position| engine.state_valid(position)).unwrap();
/// assert!(engine.state_valid(&near) && (near - inside).norm() < 0.2);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn valid_nearby(positions: (Point, Point), at: &Point, valid: impl Fn(&Point) -> bool) -> Option<Point> {
    let diagonal = (positions.1 - positions.0).norm();
    let ratio = LEAST.powf(-1.0 / (DISTANCES - 1) as f64);
    let found = (0..DISTANCES).find_map(|k| {
        let distance = diagonal * LEAST * ratio.powi(k as i32);
        directions().map(|direction| at + direction * distance).find(|position| valid(position))
    })?;
    Some(moved_back(at, found, valid))
}

/// A valid position close to one that is not, `margin` metres inside the valid positions, so that a suggestion is not
/// at the limit: all positions at that distance along the axes and diagonals are valid too. `None` if no such position
/// was found in time.
///
/// # Errors
/// [`Error::interrupted`].
pub fn nearest_valid(
    positions: (Point, Point),
    at: &Point,
    margin: f64,
    valid: impl Fn(&Point) -> bool,
    watch: &Watch,
) -> Result<Option<Point>, Error> {
    let around = || {
        let steps = (0..27).map(|k| Vector::new((k % 3) as f64 - 1.0, (k / 3 % 3) as f64 - 1.0, (k / 9) as f64 - 1.0));
        steps.filter_map(|step| step.try_normalize(0.0)).map(|direction| direction * margin)
    };
    let valid = |place: &Point| watch.check().is_ok() && valid(place);
    let roomy = |place: &Point| valid(place) && (margin == 0.0 || around().all(|step| valid(&(place + step))));
    let found = if roomy(at) { Some(*at) } else { valid_nearby(positions, at, roomy) };
    watch.expired()?;
    Ok(found)
}

/// The last valid position found by halving between an invalid and a valid one.
fn moved_back(at: &Point, found: Point, valid: impl Fn(&Point) -> bool) -> Point {
    let (mut far, mut near) = (found, *at);
    for _ in 0..HALVINGS {
        let middle = nalgebra::center(&near, &far);
        if valid(&middle) { far = middle } else { near = middle }
    }
    far
}

/// Unit vectors on a Fibonacci lattice, the axes first.
fn directions() -> impl Iterator<Item = Vector> {
    let axes = [Vector::x(), Vector::y(), Vector::z()].into_iter().flat_map(|axis| [axis, -axis]);
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let spread = (0..DIRECTIONS).map(move |k| {
        let z = 1.0 - (2 * k + 1) as f64 / DIRECTIONS as f64;
        let (sin, cos) = (golden * k as f64).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        Vector::new(radius * cos, radius * sin, z)
    });
    axes.chain(spread)
}
