//! Cable lengths, tensions and margins at equal steps along a path.

use crate::batch::{BatchOptions, Pace, answer_all};
use crate::error::Error;
use crate::geometry::{Pose, wxyz};
use crate::kinematics::cable_lengths;
use crate::model::Scene;
use crate::turning::{pose_distance, turn_weight};
use crate::watch::Watch;
use crate::wrench::report::{Mark, even_marks};
use crate::wrench::{CapacityMargin, LengthRow, Loads, Required, Statics, TensionRow};

/// A place on a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Distance along the path, m, with turns counted as by [`length`](super::length).
    pub s: f64,
    /// Index of the segment.
    pub segment: usize,
    /// Fraction of the segment, 0 to 1.
    pub at: f64,
    /// The pose at this place.
    pub pose: Pose,
}

impl Place {
    /// The pose at a mark on a path.
    pub(super) fn on(path: &[Pose], Mark { s, segment, at }: Mark) -> Self {
        let pose = path[segment].toward(&path[(segment + 1).min(path.len() - 1)]).at(at);
        Place { s, segment, at, pose }
    }
}

/// The lengths of the segments of a path, m.
pub(super) fn segments(scene: &Scene, path: &[Pose]) -> Vec<f64> {
    let weight = if scene.keeps_orientation(path) { 0.0 } else { turn_weight(scene) };
    path.windows(2).map(|pair| pose_distance(weight, &pair[0], &pair[1])).collect()
}

/// Places at equal steps along a path, and its end.
///
/// # Errors
/// A step that is not positive or gives too many places.
pub fn places(scene: &Scene, path: &[Pose], step: f64) -> Result<Vec<Place>, Error> {
    Ok(even_marks(&segments(scene, path), step)?.into_iter().map(|mark| Place::on(path, mark)).collect())
}

fn length_row(scene: &Scene, turns: bool, place: &Place) -> LengthRow {
    let Place { s, segment, at, pose } = *place;
    let lengths = cable_lengths(scene.robot(), &pose.orientation, &pose.position);
    LengthRow {
        s,
        segment,
        at,
        position: pose.position.into(),
        orientation: turns.then(|| wxyz(&pose.orientation)),
        winches: scene.robot().commands(&lengths, None),
        lengths,
    }
}

/// Poses and cable lengths at equal steps along a path, and at its end. They need neither mass nor tension limits.
///
/// # Errors
/// A step that is not positive or gives too many rows.
///
/// # Example
/// ```
/// use cdpr_core::{Point, path, testing};
/// let scene = testing::empty();
/// let up = path::held(&scene, &[Point::new(1.0, 1.0, 0.5), Point::new(1.0, 1.0, 1.5)]);
/// let rows = path::lengths_along(&scene, &up, 0.5)?;
/// assert_eq!((rows.len(), rows[0].lengths.len()), (3, 8));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn lengths_along(scene: &Scene, path: &[Pose], step: f64) -> Result<Vec<LengthRow>, Error> {
    let turns = !scene.keeps_orientation(path);
    Ok(places(scene, path, step)?.iter().map(|place| length_row(scene, turns, place)).collect())
}

/// Poses, lengths, tensions and margins at equal steps along a path, and at its end: the platform is at rest at each of them.
/// Uses all cores.
///
/// # Errors
/// A robot without mass or tension limits; a step that is not positive or gives too many rows; a reference of the wrong length; a
/// moment required of a point mass; the errors of [`Watch::check`].
///
/// # Example
/// ```
/// use cdpr_core::{Point, Pose, Rotation, Vector};
/// use cdpr_core::tensions_along;
/// use cdpr_core::{Required, Watch};
/// let scene = cdpr_core::testing::empty();
/// let at = |angle: f64| Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::from_scaled_axis(Vector::z() * angle));
/// let rows = tensions_along(&scene, &Required::default(), &[at(0.0), at(0.2)], 0.005, None, &Watch::NONE)?;
/// let last = rows.last().unwrap();
/// assert!((last.place.orientation.unwrap()[3] - 0.1f64.sin()).abs() < 1e-12);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn tensions_along(
    scene: &Scene,
    required: &Required,
    path: &[Pose],
    step: f64,
    reference: Option<&[f64]>,
    watch: &Watch,
) -> Result<Vec<TensionRow>, Error> {
    let (turns, loads) = (!scene.keeps_orientation(path), Loads::of(scene));
    let capacity_at = |loads: &Loads| CapacityMargin::new(Statics::new(scene.robot(), loads)?, required.clone());
    let (held, places) = (capacity_at(&loads)?, places(scene, path, step)?);
    let row = |k: usize| {
        let (place, pose) = (length_row(scene, turns, &places[k]), &places[k].pose);
        let mut row = match turns {
            false => TensionRow::of(&held, place, reference),
            true => TensionRow::of(&capacity_at(&loads.at(&pose.orientation))?, place, reference),
        }?;
        row.place.winches = scene.robot().commands(&row.place.lengths, row.tensions.as_deref());
        Ok(row)
    };
    let mut rows: Vec<Result<Option<TensionRow>, Error>> = (0..places.len()).map(|_| Ok(None)).collect();
    let options = BatchOptions { threads: None, watch: *watch };
    answer_all(&mut rows, |k| row(k).map(Some), Pace::WRENCHES, &options)?;
    rows.into_iter().filter_map(Result::transpose).collect()
}
