//! Checks a path of poses: every violation with its place, and the closest approach.

use super::engine::TurningEngine;
use super::nearest::path_clearance;
use super::pose_space::{pose_distance, turn_weight};
use crate::collision::Validity;
use crate::collision::path_check::{Nearest, PathClearance, PathReport, PathViolation};
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
    let (mut valid, mut violations) = (true, Vec::new());
    for (segment, pair) in poses.windows(2).enumerate() {
        watch.check()?;
        if !engine.motion_valid(&pair[0], &pair[1]) {
            valid = false;
            let found = engine.violations(&pair[0], &pair[1]);
            violations.extend(found.into_iter().map(|violation| PathViolation { segment, violation }));
        }
    }
    let nearest = nearest_of_poses(engine, poses, watch)?;
    Ok(PathReport { valid, length: pose_path_length(scene, poses), nearest, violations })
}

/// The closest approach of a path of poses: of all pairs, of those that are not exempt, and of each exempt pair.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn nearest_of_poses(engine: &TurningEngine, poses: &[Pose], watch: &Watch) -> Result<Nearest, Error> {
    let conditions = engine.conditions();
    Nearest::by(conditions, |indices| {
        let found = path_clearance((conditions, engine.reference()), indices, poses, watch)?;
        Ok(found.map(|(segment, clearance)| PathClearance::on(segment, clearance)))
    })
}
