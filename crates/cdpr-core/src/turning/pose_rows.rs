//! Lengths, tensions and margins along a path of poses.

use super::pose_space::{pose_distance, turn_weight};
use crate::error::Error;
use crate::geometry::{Pose, wxyz};
use crate::kinematics::cable_lengths;
use crate::model::Scene;
use crate::watch::Interrupt;
use crate::wrench::tensions::{Mark, even_marks, tension_rows};
use crate::wrench::{CapacityMargin, LengthRow, Loads, Required, Statics, TensionRow};

/// Poses at equal steps along a path, including its end, each with its row; the length of the path counts its turns.
fn places(scene: &Scene, poses: &[Pose], step: f64) -> Result<Vec<(Pose, LengthRow)>, Error> {
    let weight = turn_weight(scene);
    let lengths: Vec<f64> = poses.windows(2).map(|pair| pose_distance(weight, &pair[0], &pair[1])).collect();
    let place = |Mark { s, segment, at }| {
        let pose = poses[segment].toward(&poses[(segment + 1).min(poses.len() - 1)]).at(at);
        let (position, orientation) = (pose.position.into(), Some(wxyz(&pose.orientation)));
        let lengths = cable_lengths(scene.robot(), &pose.orientation, &pose.position);
        (pose, LengthRow { s, segment, at, position, orientation, lengths })
    };
    Ok(even_marks(&lengths, step)?.into_iter().map(place).collect())
}

/// Poses and cable lengths at equal steps along a path, including its end. They need neither mass nor tension limits.
///
/// # Errors
/// As [`crate::wrench::lengths_along`].
pub fn lengths_along_poses(scene: &Scene, poses: &[Pose], step: f64) -> Result<Vec<LengthRow>, Error> {
    Ok(places(scene, poses, step)?.into_iter().map(|(_, row)| row).collect())
}

/// Poses, lengths, tensions and margins at equal steps along a path, including its end: the statics at each pose, the platform
/// at rest. Uses all cores.
///
/// # Errors
/// As [`crate::wrench::tensions_along`].
///
/// # Example
/// ```
/// use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
/// use cdpr_core::turning::tensions_along_poses;
/// use cdpr_core::wrench::Required;
/// let scene = cdpr_core::testing::empty();
/// let at = |angle: f64| Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::from_scaled_axis(Vector::z() * angle));
/// let path = [at(0.0), at(0.2)];
/// let rows = tensions_along_poses(&scene, &Required::default(), &path, 0.005, None, &|| false)?;
/// let last = rows.last().unwrap();
/// assert!((last.place.orientation.unwrap()[3] - 0.1f64.sin()).abs() < 1e-12);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn tensions_along_poses(
    scene: &Scene,
    required: &Required,
    poses: &[Pose],
    step: f64,
    reference: Option<&[f64]>,
    interrupted: &Interrupt,
) -> Result<Vec<TensionRow>, Error> {
    let (loads, places) = (Loads::of(scene), places(scene, poses, step)?);
    let row = |k: usize| {
        let (pose, place) = &places[k];
        let statics = Statics::new(scene.robot(), &loads.at(&pose.orientation))?;
        TensionRow::of(&CapacityMargin::new(statics, required.clone())?, place.clone(), reference)
    };
    tension_rows(places.len(), row, interrupted)
}
