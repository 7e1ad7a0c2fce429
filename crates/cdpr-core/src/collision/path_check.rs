//! Checking a whole path: every violation with its place, and the nearest approach.

use serde::Serialize;

use super::validity::{Clearance, Validity, Violation};
use crate::error::Error;
use crate::geometry::Point;
use crate::watch::Watch;

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
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn check_path(validity: &dyn Validity, waypoints: &[Point], watch: &Watch) -> Result<PathReport, Error> {
    let mut violations = Vec::new();
    for (segment, pair) in waypoints.windows(2).enumerate() {
        watch.check()?;
        let found = validity.violations(&pair[0], &pair[1]);
        violations.extend(found.into_iter().map(|violation| PathViolation { segment, violation }));
    }
    let (length, min_clearance) = (path_length(waypoints), min_clearance(validity, waypoints, watch)?);
    Ok(PathReport { valid: violations.is_empty(), length, min_clearance, violations })
}

/// The nearest approach of a path to anything it must keep away from.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn min_clearance(
    validity: &dyn Validity,
    waypoints: &[Point],
    watch: &Watch,
) -> Result<Option<PathClearance>, Error> {
    let mut nearest: Option<PathClearance> = None;
    for (segment, pair) in waypoints.windows(2).enumerate() {
        watch.check()?;
        let Some(Clearance { value, at, culprits }) = validity.clearance(&pair[0], &pair[1]) else { continue };
        if nearest.as_ref().is_none_or(|nearest| value < nearest.value) {
            nearest = Some(PathClearance { value, segment, at, culprits });
        }
    }
    Ok(nearest)
}
