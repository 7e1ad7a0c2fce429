//! Scenes in which payloads are carried, or stand elsewhere.

use super::Scene;
use super::payload::{Payload, index};
use super::spec::{PayloadSpec, PositionSource, SceneSpec};
use super::task_rows::Stops;
use crate::error::Error;
use crate::geometry::{Polytope, Pose, distance, wxyz};
use crate::tolerances::ON_SURFACE;

impl Scene {
    /// What the platform can carry, in the order of the file.
    pub fn payloads(&self) -> &[Payload] {
        self.payloads.as_deref().map_or(&[], |payloads| &payloads.list)
    }

    /// What the platform is to do, if the scene says so.
    pub fn task(&self) -> Option<&Stops> {
        self.payloads.as_deref()?.task.as_ref()
    }

    /// The scene as its file has it: with payloads and task, and neither among the obstacles nor on the platform.
    pub fn written(&self) -> &SceneSpec {
        self.payloads.as_deref().map_or(self.spec(), |payloads| &payloads.spec)
    }

    /// The scene in which the platform carries a payload, without its task, which begins elsewhere.
    ///
    /// # Errors
    /// An unknown name; a payload that overlaps one that is carried already.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::{BodySpec, PayloadSpec, Scene, SceneSpec};
    /// let body = BodySpec { cuboid: Some([0.1; 3]), position: Some([0.0, 0.0, -0.075]), ..BodySpec::default() };
    /// let crate_ = PayloadSpec {
    ///     name: "crate".to_string(),
    ///     body: vec![body],
    ///     mass: 2.0,
    ///     at: Some([0.3, 0.3, 0.125].into()),
    ///     ..PayloadSpec::default()
    /// };
    /// let scene = Scene::new(SceneSpec { payloads: vec![crate_], ..cdpr_core::testing::empty().spec().clone() })?;
    /// assert_eq!((scene.obstacles().len(), scene.robot().parts().len()), (1, 1));
    /// let carried = scene.carrying("crate")?;
    /// assert_eq!((carried.obstacles().len(), carried.robot().parts().len()), (0, 2));
    /// assert_eq!(carried.placed("crate", [1.5, 1.5, 0.125].into())?.obstacles()[0].name, "crate");
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn carrying(&self, name: &str) -> Result<Scene, Error> {
        self.with_payload(name, |payload| {
            *payload = PayloadSpec { at: None, orientation: None, carried: true, ..payload.clone() }
        })
    }

    /// The scene in which a payload stands where it would be carried if the platform were at a station or position, without its task.
    ///
    /// # Errors
    /// An unknown name, or a position that is not finite.
    pub fn placed(&self, name: &str, at: PositionSource) -> Result<Scene, Error> {
        self.with_payload(name, |payload| {
            *payload = PayloadSpec { at: Some(at), orientation: None, carried: false, ..payload.clone() }
        })
    }

    fn with_payload(&self, name: &str, change: impl FnOnce(&mut PayloadSpec)) -> Result<Scene, Error> {
        let k = index("payloads", name, self.payloads())?;
        let mut spec = SceneSpec { task: Vec::new(), ..self.written().clone() };
        change(&mut spec.payloads[k]);
        Scene::new(spec)
    }

    /// The scene in which each payload stands as if the platform were at a pose, or is carried, without its task; and the pairs of
    /// these names may touch.
    ///
    /// # Errors
    /// Payloads that overlap while they are carried.
    pub(crate) fn arranged(&self, stands: &[Option<Pose>], touch: &[[String; 2]]) -> Result<Scene, Error> {
        let mut spec = SceneSpec { task: Vec::new(), ..self.written().clone() };
        for (payload, stands) in spec.payloads.iter_mut().zip(stands) {
            payload.at = stands.map(|pose| pose.position.into());
            payload.orientation = stands.map(|pose| wxyz(&pose.orientation).into());
            payload.carried = stands.is_none();
        }
        touch.iter().for_each(|pair| allow_touch(&mut spec, pair));
        Scene::new(spec)
    }

    /// The names of the obstacles that a payload touches if it stands as if the platform were at a pose.
    pub(crate) fn touched_by(&self, payload: &Payload, stands: &Pose) -> Vec<String> {
        let parts = moved_parts(payload, stands);
        let near = |other: &Polytope| {
            let apart = |part: &&Polytope| !part.aabb().apart_by(other.aabb(), 2.0 * ON_SURFACE);
            parts.iter().filter(apart).any(|part| distance(part, other).signed() <= ON_SURFACE)
        };
        let others = self.obstacles().iter().filter(|obstacle| obstacle.name != payload.name);
        others.filter(|obstacle| obstacle.parts.iter().any(near)).map(|obstacle| obstacle.name.clone()).collect()
    }
}

fn moved_parts(payload: &Payload, stands: &Pose) -> Vec<Polytope> {
    payload.parts.iter().map(|part| part.transformed(&stands.orientation, &stands.position.coords)).collect()
}

/// Waives the clearance of a pair. A pair that is not checked stays so.
fn allow_touch(spec: &mut SceneSpec, pair: &[String; 2]) {
    let same = |other: &[String; 2]| other.iter().all(|name| pair.contains(name));
    if spec.ignore.iter().chain(&spec.touch).any(same) {
        return;
    }
    if let Some(clearances) = &mut spec.clearances {
        clearances.pairs.retain(|rule| !same(&rule.between));
    }
    spec.touch.push(pair.clone());
}
