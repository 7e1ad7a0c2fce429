//! Checks a whole path: every violation with its place, and the closest approach.

use serde::Serialize;

use super::clearance::{self, Clearance};
use super::validity::{Checker, Validity};
use super::violation::Violation;
use crate::conditions::{Conditions, Exemption};
use crate::error::Error;
use crate::geometry::Point;
pub use crate::geometry::path_length;
use crate::watch::Watch;

/// A broken condition on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathViolation {
    /// Index of the segment, from 0.
    pub segment: usize,
    /// The condition; its `at` is a fraction of the segment.
    #[serde(flatten)]
    pub violation: Violation,
}

/// The closest approach on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathClearance {
    /// Gap in the world, m.
    pub value: f64,
    /// Index of the segment, from 0.
    pub segment: usize,
    /// Fraction of the segment, 0 to 1.
    pub at: f64,
    /// The names of the members.
    pub culprits: Vec<String>,
    /// The required clearance of the pair, m; 0 if it only has to stay apart.
    pub required: f64,
}

impl PathClearance {
    /// The closest approach of a path, which is on this segment.
    pub fn on(segment: usize, Clearance { value, at, culprits, required }: Clearance) -> Self {
        PathClearance { value, segment, at, culprits, required }
    }
}

/// An exempt pair on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathExemption {
    /// The pair, and why it is exempt.
    #[serde(flatten)]
    pub exemption: Exemption,
    /// Its closest approach on the path, m; `None` for pairs that are not checked, or touch by construction.
    pub gap: Option<f64>,
}

/// The closest approach of a path, and the pairs that are exempt from the required clearance.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Nearest {
    /// The closest approach of all pairs, if there are any.
    pub min_clearance: Option<PathClearance>,
    /// The closest approach of the pairs that are not exempt, if others are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min_clearance_not_exempt: Option<PathClearance>,
    /// Pairs that are exempt from the clearance of their kind.
    pub exempt: Vec<PathExemption>,
}

impl Nearest {
    /// The exempt pairs, without measurements.
    pub fn unmeasured(conditions: &Conditions) -> Self {
        let exempt = conditions.exempt.iter().map(|e| PathExemption { exemption: e.clone(), gap: None }).collect();
        Nearest { exempt, ..Nearest::default() }
    }

    /// The closest approaches of a path; `of` returns the closest approach over the conditions with the given indices.
    ///
    /// # Errors
    /// Passes on the errors of `of`.
    pub fn by(
        conditions: &Conditions,
        of: impl Fn(&[usize]) -> Result<Option<PathClearance>, Error>,
    ) -> Result<Self, Error> {
        let all: Vec<usize> = (0..conditions.list.len()).collect();
        let mut exempt = Vec::with_capacity(conditions.exempt.len());
        for exemption in &conditions.exempt {
            let gap = of(&exemption.conditions)?.map(|clearance| clearance.value);
            exempt.push(PathExemption { exemption: exemption.clone(), gap });
        }
        let mut held = vec![true; all.len()];
        conditions.exempt.iter().flat_map(|e| &e.conditions).for_each(|&index| held[index] = false);
        let held: Vec<usize> = all.iter().copied().filter(|&index| held[index]).collect();
        let min_clearance = of(&all)?;
        let min_clearance_not_exempt = if held.len() < all.len() { of(&held)? } else { None };
        Ok(Nearest { min_clearance, min_clearance_not_exempt, exempt })
    }
}

/// The result of checking a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathReport {
    /// Whether the whole path is valid.
    pub valid: bool,
    /// Its length, m.
    pub length: f64,
    /// Its closest approaches.
    #[serde(flatten)]
    pub nearest: Nearest,
    /// All violations, in order along the path.
    pub violations: Vec<PathViolation>,
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
            continue; // many times faster than checking every condition separately
        }
        valid = false;
        let found = checker.violations(&pair[0], &pair[1]);
        violations.extend(found.into_iter().map(|violation| PathViolation { segment, violation }));
    }
    let (length, nearest) = (path_length(waypoints), nearest(checker.conditions(), waypoints, watch)?);
    Ok(PathReport { valid, length, nearest, violations })
}

/// The closest approach of a path: of all pairs, of those that are not exempt, and of each exempt pair.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn nearest(conditions: &Conditions, waypoints: &[Point], watch: &Watch) -> Result<Nearest, Error> {
    Nearest::by(conditions, |indices| nearest_of(conditions, indices, waypoints, watch))
}

/// The closest approach of a path for the conditions with these indices.
///
/// # Errors
/// As [`nearest`].
pub fn nearest_of(
    conditions: &Conditions,
    indices: &[usize],
    waypoints: &[Point],
    watch: &Watch,
) -> Result<Option<PathClearance>, Error> {
    let found = clearance::path_clearance(conditions, indices, waypoints, watch)?;
    Ok(found.map(|(segment, found)| PathClearance::on(segment, found)))
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
                let found = nearest(engine.conditions(), &path, &Watch::NONE).unwrap().min_clearance.unwrap();
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
