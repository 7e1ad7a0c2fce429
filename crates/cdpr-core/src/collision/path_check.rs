//! Checking a whole path: every violation with its place, and the nearest approach.

use serde::Serialize;

use super::explain;
use super::validity::{Checker, Clearance, Validity, Violation};
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
pub fn check_path(checker: &dyn Checker, waypoints: &[Point], watch: &Watch) -> Result<PathReport, Error> {
    let (mut valid, mut violations) = (true, Vec::new());
    for (segment, pair) in waypoints.windows(2).enumerate() {
        watch.check()?;
        if checker.motion_valid(&pair[0], &pair[1]) {
            continue; // many times faster than to ask every constraint
        }
        valid = false;
        let found = checker.violations(&pair[0], &pair[1]);
        violations.extend(found.into_iter().map(|violation| PathViolation { segment, violation }));
    }
    let (length, min_clearance) = (path_length(waypoints), min_clearance(checker, waypoints, watch)?);
    Ok(PathReport { valid, length, min_clearance, violations })
}

/// The nearest approach of a path to anything it must keep away from.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn min_clearance(
    checker: &dyn Checker,
    waypoints: &[Point],
    watch: &Watch,
) -> Result<Option<PathClearance>, Error> {
    let Some((segment, clearance)) = explain::path_clearance(checker.constraints(), waypoints, watch)? else {
        return Ok(None);
    };
    let Clearance { value, at, culprits } = clearance;
    Ok(Some(PathClearance { value, segment, at, culprits }))
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::collision::{GjkEngine, Interference};
    use crate::testing::{hard1, hard3};

    #[test]
    fn the_nearest_approach_of_a_path_is_that_of_its_segments() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for (scene, step) in [(hard1(), 0.02), (hard3(), 0.02), (hard1(), 0.3), (hard3(), 1.0)] {
            let engine = GjkEngine::new(&scene, Interference::Exact).unwrap();
            for start in [0.3, 1.0] {
                let mut path = vec![Point::new(start, 1.0, start)];
                for k in 0..150 {
                    path.push(path[k].map(|x| (x + step * (rng.random::<f64>() - 0.5)).clamp(0.0, 2.0)));
                }
                let found = min_clearance(&engine, &path, &Watch::NONE).unwrap().unwrap();
                let each = path.windows(2).map(|pair| engine.clearance(&pair[0], &pair[1]).unwrap());
                let each: Vec<f64> = each.map(|clearance| clearance.value).collect();
                let least = each.iter().copied().fold(f64::INFINITY, f64::min);
                assert_eq!((found.value, each[found.segment]), (least, least));
                let alone = engine.clearance(&path[found.segment], &path[found.segment + 1]).unwrap();
                assert_eq!((found.at, found.culprits), (alone.at, alone.culprits));
            }
        }
    }
}
