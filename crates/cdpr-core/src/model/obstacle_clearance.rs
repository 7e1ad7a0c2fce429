//! A larger clearance from obstacles, for the widest path.

use super::pairs::Member;
use super::scene::Scene;
use super::spec::{PairClearanceSpec, SceneSpec};
use crate::error::Error;

impl Scene {
    /// The scene with at least this clearance from obstacles, m, in place of its own: for all pairs of platform or cables with an
    /// obstacle that follow the key `clearance`. Kinds and pairs with a clearance of their own keep it; so do pairs within the robot,
    /// and a cable and the obstacle that carries its outlet, which no path can move apart.
    ///
    /// # Errors
    /// A clearance that is not finite or too large.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::Member;
    /// let scene = cdpr_core::testing::hard1().with_obstacle_clearance(0.1)?;
    /// assert_eq!(scene.pairs().clearance(Member::Platform, Member::Obstacle(0)), 0.1);
    /// assert_eq!(scene.pairs().clearance(Member::Cable(0), Member::Cable(1)), 0.0);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn with_obstacle_clearance(&self, clearance: f64) -> Result<Scene, Error> {
        let before = self.spec().clearance.unwrap_or(0.0);
        let mut spec = SceneSpec { clearance: Some(clearance.max(before)), ..self.spec().clone() };
        let own = spec.clearances.get_or_insert_default();
        if own.cable_obstacle.is_none() {
            let kept = self.carried().map(|between| PairClearanceSpec { between, clearance: before });
            own.pairs.extend(kept);
        }
        own.cable_cable.get_or_insert(before);
        own.cable_platform.get_or_insert(before);
        Scene::new(spec)
    }

    /// Cables and the obstacles that carry their outlets, by name, unless they have a rule of their own. An obstacle of one part
    /// touches the cable by construction, so it needs none.
    fn carried(&self) -> impl Iterator<Item = [String; 2]> {
        let pairs = self.robot().cables().iter().enumerate().flat_map(move |(i, cable)| {
            let obstacles = self.obstacles().iter().enumerate().filter(|(_, obstacle)| obstacle.parts.len() > 1);
            obstacles.map(move |(j, obstacle)| (i, cable, j, obstacle))
        });
        let carried = pairs.filter(|(i, cable, j, obstacle)| {
            let pair = [Member::Cable(*i), Member::Obstacle(*j)];
            !self.pairs().named().any(|(named, _)| named == pair)
                && obstacle.parts.iter().any(|part| !part.active_normals(&cable.outlet).is_empty())
        });
        carried.map(|(_, cable, _, obstacle)| [cable.name.clone(), obstacle.name.clone()])
    }
}
