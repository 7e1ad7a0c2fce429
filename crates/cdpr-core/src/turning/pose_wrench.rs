//! The wrench margins and tensions of a path of poses.

use super::pose_space::{pose_distance, turn_weight};
use super::turning_wrench::TurningWrench;
use crate::batch::each;
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::model::Scene;
use crate::watch::Watch;
use crate::wrench::tensions::{MarginPlace, Mark, RANGE_STEPS, TensionRange, even_marks};
use crate::wrench::{Loads, PathWrench, Statics, TensionQp, measures, path_wrench};

/// The wrenches of a path of poses; `None` if its scene requires none. If the platform turns, margins and tensions are those at a
/// thousand equal steps and at the waypoints; between them a margin may be smaller.
///
/// # Errors
/// As [`TurningWrench::of`]; a solver that reached no answer; [`Error::interrupted`], [`Error::out_of_time`].
pub fn wrench_of_poses(scene: &Scene, poses: &[Pose], watch: &Watch) -> Result<Option<PathWrench>, Error> {
    if scene.keeps_orientation(poses) {
        let positions: Vec<Point> = poses.iter().map(|pose| pose.position).collect();
        return path_wrench(&measures(scene)?, &positions, watch);
    }
    let Some(wrench) = TurningWrench::of(scene)? else { return Ok(None) };
    let (loads, marks) = (Loads::cases(scene), marks(scene, poses)?);
    let found = each(marks.len(), 0, &|solver: &mut TensionQp, k| {
        watch.check()?;
        let mark = &marks[k];
        let pose = poses[mark.segment].toward(&poses[(mark.segment + 1).min(poses.len() - 1)]).at(mark.at);
        let mut tensions = Vec::with_capacity(loads.len());
        for loads in &loads {
            let statics = Statics::new(scene.robot(), &loads.at(&pose.orientation))?;
            tensions.push(statics.tensions(solver, &pose.position, None)?);
        }
        Ok((wrench.least_at(&pose), tensions))
    })?;
    let (limits, tensions): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    let places = || marks.iter().map(|mark| (mark.segment, mark.at));
    let of_cases = places().zip(tensions).flat_map(|(at, cases)| cases.into_iter().map(move |found| (at, found)));
    let known = places().zip(limits).filter_map(|(place, limit)| Some((place, limit?)));
    let least = known.min_by(|(_, a), (_, b)| a.order().total_cmp(&b.order()));
    let Some(((segment, at), limit)) = least else { return Ok(None) };
    let min_wrench_margin = MarginPlace { value: limit.wrench_margin, segment, at, limit };
    let tension_range = TensionRange::of(&Statics::of(scene)?, of_cases);
    Ok(Some(PathWrench { min_wrench_margin, tension_range }))
}

/// Equal steps along a path, and its waypoints.
fn marks(scene: &Scene, poses: &[Pose]) -> Result<Vec<Mark>, Error> {
    let weight = turn_weight(scene);
    let lengths: Vec<f64> = poses.windows(2).map(|pair| pose_distance(weight, &pair[0], &pair[1])).collect();
    let length: f64 = lengths.iter().sum();
    let mut marks = if length > 0.0 { even_marks(&lengths, length / RANGE_STEPS)? } else { Vec::new() };
    marks.extend((0..poses.len()).map(|k| {
        let segment = k.min(poses.len().saturating_sub(2));
        Mark { s: 0.0, segment, at: (k - segment) as f64 }
    }));
    Ok(marks)
}
