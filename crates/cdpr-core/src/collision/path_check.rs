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
    /// Names of the members of the pair.
    pub culprits: Vec<String>,
    /// The required clearance of the pair, m; 0 if it only has to stay apart.
    pub required: f64,
}

/// An exempt pair on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathExemption {
    /// The pair, and why it is exempt.
    #[serde(flatten)]
    pub exemption: Exemption,
    /// Closest approach of the pair on the path, m; `None` for pairs that are not checked, or touch by construction.
    pub gap: Option<f64>,
}

/// The closest approach of a path, and the pairs that are exempt from the required clearance.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Nearest {
    /// The closest approach of all pairs, if there are any.
    pub min_clearance: Option<PathClearance>,
    /// The closest approach of the pairs that are not exempt; `None` if no pair is exempt.
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
}

/// The result of checking a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathReport {
    /// Whether the whole path is valid.
    pub valid: bool,
    /// Length of the path, m.
    pub length: f64,
    /// Closest approaches of the path.
    #[serde(flatten)]
    pub nearest: Nearest,
    /// All violations, in order along the path.
    pub violations: Vec<PathViolation>,
}

/// An engine that also measures the paths whose motions it checks. The states of a path are positions, or poses if the
/// platform may turn.
pub trait PathEngine<State>: Validity<State> {
    /// The conditions that motions are checked against.
    fn checked_conditions(&self) -> &Conditions;

    /// Length of a path, m; with turns, each radian counts as the scene's weight of a turn.
    fn length(&self, path: &[State]) -> f64;

    /// The closest approach of a path, and the index of its segment, over the conditions with these indices.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    fn closest(&self, indices: &[usize], path: &[State], watch: &Watch) -> Result<Option<(usize, Clearance)>, Error>;
}

impl<E: Checker + ?Sized> PathEngine<Point> for E {
    fn checked_conditions(&self) -> &Conditions {
        self.conditions()
    }

    fn length(&self, path: &[Point]) -> f64 {
        path_length(path)
    }

    fn closest(&self, indices: &[usize], path: &[Point], watch: &Watch) -> Result<Option<(usize, Clearance)>, Error> {
        clearance::path_clearance(self.conditions(), indices, path, watch)
    }
}

/// Checks every segment of a path of at least two states.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn check_path<S>(engine: &(impl PathEngine<S> + ?Sized), path: &[S], watch: &Watch) -> Result<PathReport, Error> {
    let (mut valid, mut violations) = (true, Vec::new());
    for (segment, pair) in path.windows(2).enumerate() {
        watch.check()?;
        if engine.motion_valid(&pair[0], &pair[1]) {
            continue; // many times faster than checking every condition separately
        }
        valid = false;
        let found = engine.violations(&pair[0], &pair[1]);
        violations.extend(found.into_iter().map(|violation| PathViolation { segment, violation }));
    }
    Ok(PathReport { valid, length: engine.length(path), nearest: nearest(engine, path, watch)?, violations })
}

/// The first segment of a path that is not valid.
pub fn first_invalid_segment<S>(engine: &(impl Validity<S> + ?Sized), path: &[S]) -> Option<usize> {
    path.windows(2).position(|pair| !engine.motion_valid(&pair[0], &pair[1]))
}

/// The closest approach of a path: over all pairs, over those that are not exempt, and of each exempt pair.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn nearest<S>(engine: &(impl PathEngine<S> + ?Sized), path: &[S], watch: &Watch) -> Result<Nearest, Error> {
    let conditions = engine.checked_conditions();
    let of = |indices: &[usize]| nearest_of(engine, indices, path, watch);
    let mut exempt = Vec::with_capacity(conditions.exempt.len());
    for exemption in &conditions.exempt {
        let gap = of(&exemption.conditions)?.map(|clearance| clearance.value);
        exempt.push(PathExemption { exemption: exemption.clone(), gap });
    }
    let all: Vec<usize> = (0..conditions.list.len()).collect();
    let mut held = vec![true; all.len()];
    conditions.exempt.iter().flat_map(|e| &e.conditions).for_each(|&index| held[index] = false);
    let held: Vec<usize> = all.iter().copied().filter(|&index| held[index]).collect();
    let min_clearance = of(&all)?;
    let min_clearance_not_exempt = if held.len() < all.len() { of(&held)? } else { None };
    Ok(Nearest { min_clearance, min_clearance_not_exempt, exempt })
}

/// The closest approach of a path over the conditions with these indices.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn nearest_of<S>(
    engine: &(impl PathEngine<S> + ?Sized),
    indices: &[usize],
    path: &[S],
    watch: &Watch,
) -> Result<Option<PathClearance>, Error> {
    let found = engine.closest(indices, path, watch)?;
    Ok(found.map(|(segment, Clearance { value, at, culprits, required })| PathClearance {
        value,
        segment,
        at,
        culprits,
        required,
    }))
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
                let found = nearest(&engine, &path, &Watch::NONE).unwrap().min_clearance.unwrap();
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
