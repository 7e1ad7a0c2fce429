//! Poses: positions and quaternions as rows of arrays, and answers about motions between them.

use cdpr_core::Error;
use cdpr_core::batch::{BatchOptions, Pace, answer_all};
use cdpr_core::collision::Validity;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Pose, Rotation, rotation_as_written};
use cdpr_core::model::{OrientationSource, PositionSource, Scene};
use pyo3::prelude::*;

use crate::convert::{point, row};

/// An orientation as the name of one of the scene's, or as a quaternion w x y z.
#[derive(FromPyObject)]
pub enum Orientation {
    Name(String),
    Quaternion([f64; 4]),
}

impl Orientation {
    pub fn of(self, scene: &Scene, place: &str) -> Result<Rotation, Error> {
        scene.named_orientation(place, &self.source())
    }

    pub fn source(self) -> OrientationSource {
        match self {
            Orientation::Name(name) => OrientationSource::Named(name),
            Orientation::Quaternion(quaternion) => OrientationSource::Quaternion(quaternion),
        }
    }
}

/// A position as the name of a station, or as coordinates, m.
#[derive(FromPyObject)]
pub enum Position {
    Name(String),
    Coordinates([f64; 3]),
}

impl From<Position> for PositionSource {
    fn from(position: Position) -> Self {
        match position {
            Position::Name(name) => PositionSource::Named(name),
            Position::Coordinates(numbers) => PositionSource::Coordinates(numbers),
        }
    }
}

/// The scene with this start and goal; errors call them "start" and "goal".
pub fn between(scene: &Scene, ends: [Option<PositionSource>; 2]) -> Result<Scene, Error> {
    scene.clone().between(ends).map_err(|error| {
        let key = error.place().and_then(|place| place.strip_prefix("query.")).map(str::to_string);
        match key {
            Some(key) => error.at(&key),
            None => error,
        }
    })
}

/// Rows of positions, (n, 3), with rows of quaternions whose length has been checked, (n, 4), or one orientation for all.
#[derive(Clone, Copy)]
pub struct PoseRows<'a> {
    positions: &'a [f64],
    quaternions: Option<&'a [f64]>,
    held: Rotation,
}

impl<'a> PoseRows<'a> {
    /// The rows of arrays; without quaternions, at the orientation of a scene.
    pub fn of(scene: &Scene, positions: &'a [f64], quaternions: Option<&'a [f64]>) -> Self {
        PoseRows { positions, quaternions, held: *scene.orientation() }
    }

    pub fn count(&self) -> usize {
        self.positions.len() / 3
    }

    pub fn pose(&self, k: usize) -> Pose {
        let turned = |rows: &[f64]| rotation_as_written([0, 1, 2, 3].map(|digit| rows[4 * k + digit]));
        Pose::new(row(self.positions, k), self.quaternions.map_or(self.held, turned))
    }

    pub fn poses(&self) -> Vec<Pose> {
        (0..self.count()).map(|k| self.pose(k)).collect()
    }
}

/// The pose at a position with a quaternion whose length has been checked or, without one, at the orientation of a scene.
pub fn pose(scene: &Scene, position: [f64; 3], quaternion: Option<[f64; 4]>) -> Pose {
    Pose::new(point(position), quaternion.map_or(*scene.orientation(), rotation_as_written))
}

/// Whether each motion from pose to pose is valid; with equal ends, whether each pose is.
pub fn motions_valid(
    engine: &CompiledScene,
    [starts, ends]: [PoseRows; 2],
    answers: &mut [bool],
    options: &BatchOptions,
) -> Result<(), Error> {
    answer_all(answers, |k| engine.motion_valid(&starts.pose(k), &ends.pose(k)), Pace::WRENCHES, options)
}

/// The signed clearance of each pose, m; infinite if there are no gaps to measure.
pub fn clearances(
    engine: &CompiledScene,
    poses: PoseRows,
    answers: &mut [f64],
    options: &BatchOptions,
) -> Result<(), Error> {
    let gap = |k| {
        let pose = poses.pose(k);
        engine.clearance(&pose, &pose).map_or(f64::INFINITY, |clearance| clearance.value)
    };
    answer_all(answers, gap, Pace::WRENCHES, options)
}
