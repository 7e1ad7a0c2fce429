//! A scene with the engines that check its motions: compiled once, and shared by everything that asks about the scene.
//!
//! Which engine judges a motion is decided here. Motions that keep the orientation of the scene are judged by one of the two exact
//! engines; those that turn by [`TurningEngine`], which is made when the first of them comes.

use std::sync::{Arc, OnceLock};

use crate::collision::path_check::PathEngine;
use crate::collision::{
    Checker, Clearance, Conditions, CspaceEngine, Engine, GjkEngine, Interference, Validity, Violation,
};
use crate::error::Error;
use crate::geometry::{Point, Pose, path_length};
use crate::model::{Distribution, Scene};
use crate::turning::{TurningEngine, pose_distance, turn_weight};
use crate::watch::Watch;
use crate::wrench::with_wrench;

/// A scene and the engines that check motions in it, from pose to pose.
///
/// # Example
/// ```
/// use cdpr_core::Validity;
/// use cdpr_core::CompiledScene;
/// use cdpr_core::{Point, Pose, Rotation, Vector};
/// use cdpr_core::Watch;
/// let scene = cdpr_core::testing::hard1();
/// let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?;
/// let yawed = |angle: f64| Pose::new(Point::new(0.3, 1.0, 0.3), Rotation::from_scaled_axis(Vector::z() * angle));
/// assert!(compiled.motion_valid(&yawed(0.0), &yawed(0.2)));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub struct CompiledScene {
    scene: Scene,
    level: Arc<dyn Checker>,
    turning: OnceLock<TurningEngine>,
    /// The engine and rule that it was compiled for; `None` for an engine of the caller.
    kind: Option<(Engine, Interference)>,
}

impl CompiledScene {
    /// Compiles a scene for motions checked by this engine and this rule for crossing cables.
    ///
    /// # Errors
    /// The errors of [`engine_within`].
    pub fn new(scene: &Scene, engine: Engine, interference: Interference, watch: &Watch) -> Result<Self, Error> {
        let level = engine_within(scene, engine, interference, watch)?;
        Ok(CompiledScene { kind: Some((engine, interference)), ..Self::with(scene, level) })
    }

    /// Compiles a scene that differs little from this one, for the engine and the rule of this one; what both have in common is not
    /// compiled again.
    ///
    /// # Errors
    /// The errors of [`engine_within`].
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{CompiledScene, Watch};
    /// let scene = cdpr_core::testing::hard3();
    /// let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?;
    /// let moved = compiled.recompiled(&scene.moved("west", [0.5, 1.0, 0.8].into())?, &Watch::NONE)?;
    /// assert_ne!(moved.scene(), compiled.scene());
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn recompiled(&self, scene: &Scene, watch: &Watch) -> Result<Self, Error> {
        let level = with_wrench(self.level.geometry_for(scene, watch)?, scene)?;
        Ok(CompiledScene { kind: self.kind, ..Self::with(scene, level.into()) })
    }

    /// A scene with an engine that was compiled for it.
    pub fn with(scene: &Scene, level: Arc<dyn Checker>) -> Self {
        CompiledScene { scene: scene.clone(), level, turning: OnceLock::new(), kind: None }
    }

    /// The same engine with another choice of tensions, which it does not depend on.
    pub fn with_tensions(&self, chosen: Distribution) -> Self {
        CompiledScene { kind: self.kind, ..Self::with(&self.scene.with_tensions(chosen), self.level.clone()) }
    }

    /// The scene that was compiled.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Whether the scene was compiled for this engine and rule.
    pub fn is_for(&self, engine: Engine, interference: Interference) -> bool {
        self.kind == Some((engine, interference))
    }

    /// The engine for motions that keep the orientation of the scene.
    pub fn level(&self) -> &dyn Checker {
        &*self.level
    }

    /// The conditions that motions keep, at the orientation of the scene.
    pub fn conditions(&self) -> &Conditions {
        self.level.conditions()
    }

    /// The engine for motions that turn.
    ///
    /// # Errors
    /// The interference rule `swept`, which applies only to motions without a turn; a wrench requirement that is
    /// defined for one orientation only.
    pub fn turning(&self) -> Result<&TurningEngine, Error> {
        if self.turning.get().is_none() {
            let _ = self.turning.set(TurningEngine::new(&self.scene, self.level.clone())?);
        }
        Ok(self.turning.get().expect("just made"))
    }

    /// Makes sure that there is an engine for every motion of a path.
    ///
    /// # Errors
    /// The errors of [`CompiledScene::turning`], if the platform turns on the path.
    pub fn ready_for(&self, path: &[Pose]) -> Result<(), Error> {
        if self.scene.keeps_orientation(path) { Ok(()) } else { self.turning().map(drop) }
    }

    fn is_level(&self, from: &Pose, to: &Pose) -> bool {
        [from, to].iter().all(|pose| self.scene.has_orientation(&pose.orientation))
    }
}

/// Motions that turn are refused if there is no engine for them; [`CompiledScene::ready_for`] gives the reason.
impl Validity<Pose> for CompiledScene {
    fn state_valid(&self, pose: &Pose) -> bool {
        self.motion_valid(pose, pose)
    }

    fn motion_valid(&self, from: &Pose, to: &Pose) -> bool {
        match self.is_level(from, to) {
            true => self.level.motion_valid(&from.position, &to.position),
            false => self.turning().is_ok_and(|engine| engine.motion_valid(from, to)),
        }
    }

    fn violations(&self, from: &Pose, to: &Pose) -> Vec<Violation> {
        match self.is_level(from, to) {
            true => self.level.violations(&from.position, &to.position),
            false => self.turning().map_or(Vec::new(), |engine| engine.violations(from, to)),
        }
    }

    fn clearance(&self, from: &Pose, to: &Pose) -> Option<Clearance> {
        match self.is_level(from, to) {
            true => self.level.clearance(&from.position, &to.position),
            false => self.turning().ok().and_then(|engine| engine.clearance(from, to)),
        }
    }

    fn may_be_slow(&self) -> bool {
        self.level.may_be_slow()
    }
}

impl PathEngine<Pose> for CompiledScene {
    fn checked_conditions(&self) -> &Conditions {
        self.conditions()
    }

    fn length(&self, path: &[Pose]) -> f64 {
        length(&self.scene, path)
    }

    fn closest(&self, indices: &[usize], path: &[Pose], watch: &Watch) -> Result<Option<(usize, Clearance)>, Error> {
        match self.scene.keeps_orientation(path) {
            true => self.level.closest(indices, &positions(path), watch),
            false => self.turning()?.closest(indices, path, watch),
        }
    }
}

/// Length of a path in a scene, m: the lengths of its translations plus its turns, each radian of which counts as the scene's
/// weight of a turn.
pub fn length(scene: &Scene, path: &[Pose]) -> f64 {
    if scene.keeps_orientation(path) {
        return path_length(&positions(path));
    }
    let weight = turn_weight(scene);
    path.windows(2).map(|pair| pose_distance(weight, &pair[0], &pair[1])).sum()
}

/// The positions of poses.
pub fn positions(path: &[Pose]) -> Vec<Point> {
    path.iter().map(|pose| pose.position).collect()
}

/// The engine for motions at the orientation of a scene: checks its geometry and, if required, wrench feasibility.
///
/// # Errors
/// The errors of [`Conditions::new`] and [`with_wrench`].
pub fn engine_for(scene: &Scene, engine: Engine, interference: Interference) -> Result<Arc<dyn Checker>, Error> {
    engine_within(scene, engine, interference, &Watch::NONE)
}

/// The engine for motions at the orientation of a scene, compiled within a watch.
///
/// # Errors
/// The errors of [`engine_for`]; [`Error::interrupted`], [`Error::out_of_time`].
pub fn engine_within(
    scene: &Scene,
    engine: Engine,
    interference: Interference,
    watch: &Watch,
) -> Result<Arc<dyn Checker>, Error> {
    let geometry: Box<dyn Checker> = match engine {
        Engine::Cspace => Box::new(CspaceEngine::within(scene, interference, watch)?),
        Engine::Gjk => Box::new(GjkEngine::within(scene, interference, watch)?),
    };
    Ok(with_wrench(geometry, scene)?.into())
}
