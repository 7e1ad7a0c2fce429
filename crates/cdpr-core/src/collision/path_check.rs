//! Checking a whole path: every violation with its place, and the nearest approach.

use serde::Serialize;

use super::validity::{Validity, Violation};
use crate::geometry::Point;

/// A broken condition on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathViolation {
    /// Which segment, counting from 0.
    pub segment: usize,
    /// The condition; its `at` is a fraction of the segment.
    #[serde(flatten)]
    pub violation: Violation,
}

/// The nearest approach on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathClearance {
    /// Gap in the world, m.
    pub value: f64,
    /// Which segment, counting from 0.
    pub segment: usize,
    /// Fraction of the segment, 0 to 1.
    pub at: f64,
    /// Between whom.
    pub culprits: Vec<String>,
}

/// What was found about a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathReport {
    /// Whether the whole path is valid.
    pub valid: bool,
    /// Its length, m.
    pub length: f64,
    /// Its nearest approach, if there is anything to keep away from.
    pub min_clearance: Option<PathClearance>,
    /// Everything that is wrong with it, in order along the path.
    pub violations: Vec<PathViolation>,
}

/// Length of a path, m.
pub fn path_length(waypoints: &[Point]) -> f64 {
    waypoints.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
}

/// The first segment of a path that is not valid.
pub fn first_invalid_segment(validity: &dyn Validity, waypoints: &[Point]) -> Option<usize> {
    waypoints.windows(2).position(|pair| !validity.motion_valid(&pair[0], &pair[1]))
}

/// Checks every segment of a path of at least two waypoints.
pub fn check_path(validity: &dyn Validity, waypoints: &[Point]) -> PathReport {
    let segments = || waypoints.windows(2).enumerate();
    let violations: Vec<PathViolation> = segments()
        .flat_map(|(segment, pair)| {
            let found = validity.violations(&pair[0], &pair[1]);
            found.into_iter().map(move |violation| PathViolation { segment, violation })
        })
        .collect();
    let (length, min_clearance) = (path_length(waypoints), min_clearance(validity, waypoints));
    PathReport { valid: violations.is_empty(), length, min_clearance, violations }
}

/// The nearest approach of a path to anything it must keep away from.
pub fn min_clearance(validity: &dyn Validity, waypoints: &[Point]) -> Option<PathClearance> {
    let of_segments = waypoints.windows(2).enumerate();
    let found = of_segments.filter_map(|(segment, pair)| Some((segment, validity.clearance(&pair[0], &pair[1])?)));
    let (segment, c) = found.min_by(|a, b| a.1.value.total_cmp(&b.1.value))?;
    Some(PathClearance { value: c.value, segment, at: c.at, culprits: c.culprits })
}
