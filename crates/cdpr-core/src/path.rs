//! Operations on paths: how long they are, whether they are free, and the cables along them.
//!
//! A path is a list of poses. Between two of them the platform moves on a straight line and turns about a fixed axis, the shorter
//! way round, both at constant rates. A translation is a path whose poses all have the orientation of the scene.

mod along;
mod wrench;

use serde::Serialize;

use crate::collision::check_path;
use crate::collision::path_check::PathReport;
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::model::Scene;
use crate::watch::Watch;
use crate::wrench::PathWrench;

pub use crate::compiled::{length, positions};
pub use along::{Place, lengths_along, places, tensions_along};
pub use wrench::wrench_of;

/// The path through these positions at the orientation of a scene.
pub fn held(scene: &Scene, positions: &[Point]) -> Vec<Pose> {
    positions.iter().map(|position| Pose::new(*position, *scene.orientation())).collect()
}

/// The complete report on a path of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckReport {
    /// Length, violations and nearest approach of the path.
    #[serde(flatten)]
    pub path: PathReport,
    /// Smallest wrench margin and range of tensions of the path, if the scene requires wrench feasibility.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub wrench: Option<PathWrench>,
}

/// Checks a path: every violation, the nearest approach and, if the scene requires it, wrench feasibility.
///
/// # Errors
/// The errors of [`CompiledScene::turning`] and [`wrench_of`].
///
/// # Example
/// ```
/// use cdpr_core::CompiledScene;
/// use cdpr_core::{check, path::held};
/// use cdpr_core::Watch;
/// let scene = cdpr_core::testing::hard1();
/// let straight = held(&scene, &[scene.start().unwrap(), scene.goal().unwrap()]);
/// let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?;
/// let report = check(&compiled, &straight, &Watch::NONE)?;
/// assert!(!report.path.valid); // a cable meets the pillar
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn check(compiled: &CompiledScene, path: &[Pose], watch: &Watch) -> Result<CheckReport, Error> {
    compiled.ready_for(path)?;
    let report = check_path(compiled, path, watch)?;
    Ok(CheckReport { path: report, wrench: wrench_of(compiled.scene(), path, watch)? })
}
