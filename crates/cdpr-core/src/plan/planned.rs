//! The answer to a planning query.

use std::sync::Arc;

use super::{Appraisal, NoPath, PlanOptions, PlanResult, Query, appraise};
use crate::certificate::{BoundCertificate, Certificate};
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::lower_bound::{Accepts, Forbidden};
use crate::model::Scene;
use crate::watch::{Watch, in_time};

/// The answer to a planning query.
pub struct Planned {
    /// The scene that the path is for: that of the query, at the orientation with the shortest path if it selected none.
    pub scene: Scene,
    /// The scene as compiled, for further questions about it; `None` if time ran out first.
    pub compiled: Option<Arc<CompiledScene>>,
    /// The result; counts and times are those of all searches: at each orientation, with turns and without.
    pub result: PlanResult,
}

impl Planned {
    pub(super) fn by(scene: &Scene, compiled: Arc<CompiledScene>, result: PlanResult) -> Self {
        Planned { scene: scene.clone(), compiled: Some(compiled), result }
    }

    /// The answer if time ran out before the scene was compiled.
    pub(super) fn out_of_time(scene: &Scene) -> Self {
        Planned { scene: scene.clone(), compiled: None, result: PlanResult::out_of_time() }
    }

    /// A certificate that no path of the scene is shorter than a length, m, or than the largest smaller length that can
    /// be proved and that a checker `accepts`. `None` if the checker accepts nothing, if there is no path, or if the
    /// platform turns on it.
    ///
    /// # Errors
    /// The errors of [`Forbidden::accepted_certificate`].
    pub fn bound_certificate(
        &self,
        length: f64,
        accepts: &Accepts,
        watch: &Watch,
    ) -> Result<Option<BoundCertificate>, Error> {
        let (Some(compiled), [start, .., goal]) = (&self.compiled, &self.result.path[..]) else { return Ok(None) };
        if Query::of(&self.scene).oriented([start, goal].map(|end| Some(end.orientation))).turns() {
            return Ok(None);
        }
        let ends = [&start.position, &goal.position];
        let Some(forbidden) = in_time(Forbidden::new(compiled.level(), ends, watch))? else { return Ok(None) };
        forbidden.accepted_certificate(&self.scene, length, accepts, watch)
    }

    /// The scene in which a widest path proves that there is no path: with the clearance from obstacles that none keeps. `None` if
    /// nothing is proved, if an end does not keep it itself, or if only paths of some length are meant.
    ///
    /// # Errors
    /// Never for a planned path.
    pub fn scene_without_path(&self) -> Result<Option<Scene>, Error> {
        let (Some(widest), [start, .., goal]) = (self.result.widest, &self.result.path[..]) else { return Ok(None) };
        let is_proof = widest.narrow_end.is_none() && widest.longest.is_none(); // longer paths may keep it
        let none_above = widest.none_above.filter(|_| is_proof);
        let ends = [*start, *goal];
        none_above.map(|none| self.scene.with_obstacle_clearance(none)?.with_ends(ends)).transpose()
    }

    /// The certificate that no path keeps the clearance from obstacles that a widest path leaves out. It is about
    /// [`Planned::scene_without_path`]. `None` if there is no such scene.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn width_certificate(&self, options: &PlanOptions, watch: &Watch) -> Result<Option<Certificate>, Error> {
        let Some(scene) = self.scene_without_path()? else { return Ok(None) };
        let compiled = CompiledScene::new(&scene, options.engine, options.interference, watch)?;
        let [start, goal] = Query::of(&scene).ends()?;
        let no_path = NoPath::decided(&scene, compiled.level(), [&start, &goal], options, watch)?;
        Ok(no_path.map(|no_path| no_path.certificate))
    }

    /// Measures the path that was found.
    ///
    /// # Errors
    /// The errors of [`appraise`].
    pub fn appraise(&self, bounded: bool, watch: &Watch) -> Result<Appraisal, Error> {
        match &self.compiled {
            Some(compiled) => appraise(compiled, &self.result, bounded, watch),
            None => Ok(Appraisal::default()),
        }
    }
}

impl std::fmt::Debug for Planned {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Planned").field("scene", &self.scene).field("result", &self.result).finish_non_exhaustive()
    }
}
