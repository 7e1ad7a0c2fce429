//! Checks a path of poses: every violation with its place, and the closest approach.

use super::engine::TurningEngine;
use super::pose_space::{pose_distance, turn_weight};
use crate::collision::path_check::{Nearest, PathClearance, PathExemption, PathReport, PathViolation};
use crate::collision::{Clearance, Validity};
use crate::error::Error;
use crate::geometry::Pose;
use crate::model::Scene;
use crate::watch::Watch;

/// Length of a path of poses in a scene, m: of its translations, plus the weight of turns times their angles.
pub fn pose_path_length(scene: &Scene, poses: &[Pose]) -> f64 {
    let weight = turn_weight(scene);
    poses.windows(2).map(|pair| pose_distance(weight, &pair[0], &pair[1])).sum()
}

/// Checks every segment of a path of poses.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn check_poses(scene: &Scene, engine: &TurningEngine, poses: &[Pose], watch: &Watch) -> Result<PathReport, Error> {
    let mut violations = Vec::new();
    for (segment, pair) in poses.windows(2).enumerate() {
        watch.check()?;
        if !engine.motion_valid(&pair[0], &pair[1]) {
            let found = engine.violations(&pair[0], &pair[1]);
            violations.extend(found.into_iter().map(|violation| PathViolation { segment, violation }));
        }
    }
    let nearest = nearest_of_poses(engine, poses, watch)?;
    Ok(PathReport { valid: violations.is_empty(), length: pose_path_length(scene, poses), nearest, violations })
}

/// The closest approach of a path of poses: of all pairs, of those that are not exempt, and of each exempt pair.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn nearest_of_poses(engine: &TurningEngine, poses: &[Pose], watch: &Watch) -> Result<Nearest, Error> {
    let conditions = engine.conditions();
    let of = |counts: &dyn Fn(usize) -> bool| -> Result<Option<PathClearance>, Error> {
        let mut best: Option<PathClearance> = None;
        for (segment, pair) in poses.windows(2).enumerate() {
            watch.check()?;
            let Some(Clearance { value, at, culprits, required }) = engine.clearance_of(counts, &pair[0], &pair[1])
            else {
                continue;
            };
            if best.as_ref().is_none_or(|known| value < known.value) {
                best = Some(PathClearance { value, segment, at, culprits, required });
            }
        }
        Ok(best)
    };
    let mut exempt = Vec::with_capacity(conditions.exempt.len());
    for exemption in &conditions.exempt {
        let gap = of(&|index| exemption.conditions.contains(&index))?.map(|clearance| clearance.value);
        exempt.push(PathExemption { exemption: exemption.clone(), gap });
    }
    let held = |index: usize| !conditions.exempt.iter().any(|exemption| exemption.conditions.contains(&index));
    let min_clearance_not_exempt = if exempt.is_empty() { None } else { of(&held)? };
    Ok(Nearest { min_clearance: of(&|_| true)?, min_clearance_not_exempt, exempt })
}
