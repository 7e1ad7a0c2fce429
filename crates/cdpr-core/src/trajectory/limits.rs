//! The limits of a motion.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::model::spec::MotionSpec;
use crate::model::{Scene, body, exceeded_clearance};

/// A limit that can determine a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// Speed of the platform.
    Speed,
    /// Acceleration of the platform.
    Acceleration,
    /// Angular speed of the platform.
    TurnSpeed,
    /// Angular acceleration of the platform.
    TurnAcceleration,
    /// Jerk of the platform.
    Jerk,
    /// Speed of a cable.
    CableSpeed,
    /// Acceleration of a cable.
    CableAcceleration,
    /// Tension of a cable.
    Tension,
}

impl Limit {
    /// The key in files, the limited quantity, and its unit. In messages, the name of a cable stands before the
    /// quantity.
    fn words(self) -> [&'static str; 3] {
        match self {
            Limit::Speed => ["speed", "speed", "m/s"],
            Limit::Acceleration => ["acceleration", "acceleration", "m/s²"],
            Limit::TurnSpeed => ["turn_speed", "angular speed", "rad/s"],
            Limit::TurnAcceleration => ["turn_acceleration", "angular acceleration", "rad/s²"],
            Limit::Jerk => ["jerk", "jerk", "m/s³"],
            Limit::CableSpeed => ["cable_speed", "speed", "m/s"],
            Limit::CableAcceleration => ["cable_acceleration", "acceleration", "m/s²"],
            Limit::Tension => ["tension", "tension", "N"],
        }
    }

    /// The key of the limit in files.
    pub fn key(self) -> &'static str {
        self.words()[0]
    }

    /// The limited quantity, and its unit.
    pub fn quantity(self) -> [&'static str; 2] {
        let [_, what, unit] = self.words();
        [what, unit]
    }
}

impl MotionSpec {
    /// The limits of a motion in a scene: these, where they are set, and those of the scene. The blend is always set.
    ///
    /// # Errors
    /// A number that is not positive (`blend`, `clearance` and `wrench_margin`: negative) or not finite.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{MotionSpec, testing};
    /// let given = MotionSpec { speed: Some(0.5), acceleration: Some(2.0), ..MotionSpec::default() };
    /// let limits = given.in_scene(&testing::hard1())?;
    /// assert_eq!((limits.speed, limits.jerk, limits.blend), (Some(0.5), None, Some(0.0)));
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn in_scene(self, scene: &Scene) -> Result<Self, Error> {
        body::sound_motion(self)?;
        let limits = self.over(scene.spec().motion.as_ref());
        let blend = limits.blend.or(scene.spec().clearance).unwrap_or(0.0);
        let wrench_margin = limits.wrench_margin.filter(|margin| *margin > 0.0);
        Ok(MotionSpec { blend: Some(blend), wrench_margin, ..limits })
    }

    /// Largest distance between the curve and the path, m.
    pub fn blend(&self) -> f64 {
        self.blend.unwrap_or(0.0)
    }

    /// Capacity margin that the cables keep in addition to the inertia of the platform, N.
    pub fn wrench_margin(&self) -> f64 {
        self.wrench_margin.unwrap_or(0.0)
    }

    /// The note that the speed has no limit, if neither the platform nor the cables have one.
    pub fn note(&self) -> Option<&'static str> {
        (self.speed.is_none() && self.cable_speed.is_none()).then_some(
            "neither speed nor cable_speed is limited: check that the winches reach the speeds of this motion",
        )
    }

    /// A scene with the clearances that the motion keeps; those of its own `[motion]` are not used.
    ///
    /// # Errors
    /// A clearance that is negative or too large.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{MotionSpec, testing};
    /// let scene = testing::hard1().with_clearance(0.05)?;
    /// let limits = MotionSpec { clearance: Some(0.02), ..MotionSpec::default() };
    /// assert_eq!(limits.moving(&scene)?.pairs().largest(), 0.02);
    /// assert_eq!(MotionSpec::default().moving(&scene)?.pairs().largest(), 0.05);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn moving<'a>(&self, scene: &'a Scene) -> Result<Cow<'a, Scene>, Error> {
        self.clearance.map_or(Ok(Cow::Borrowed(scene)), |most| scene.with_most_clearance(most).map(Cow::Owned))
    }

    /// A hint for a path that does not keep the motion's clearance, if that is larger than the scene's.
    pub(super) fn larger_clearance(&self, scene: &Scene) -> Vec<String> {
        let larger = self.clearance.and_then(|asked| Some((asked, exceeded_clearance(scene.spec(), asked)?)));
        let hint =
            |(asked, kept)| format!("the motion is to keep {asked} m (its `clearance`), paths of this scene {kept} m");
        larger.map(hint).into_iter().collect()
    }

    /// A scene with the clearances that a motion planned earlier keeps: its own if it sets them, else those of the scene's
    /// `[motion]`.
    ///
    /// # Errors
    /// A limit of the scene that is not sound, or a clearance that is negative or too large.
    pub fn moving_again<'a>(&self, scene: &'a Scene) -> Result<Cow<'a, Scene>, Error> {
        let of_scene = MotionSpec::default().in_scene(scene)?;
        MotionSpec { clearance: self.clearance.or(of_scene.clearance), ..*self }.moving(scene)
    }
}
