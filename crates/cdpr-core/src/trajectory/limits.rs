//! The limits of a motion.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::model::spec::MotionSpec;
use crate::model::{Scene, body};

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

/// The limits that a trajectory keeps; all of them are optional except `blend`. Files omit those that are not set.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Speed of the platform, m/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Acceleration of the platform, m/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<f64>,
    /// Angular speed of the platform, rad/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_speed: Option<f64>,
    /// Angular acceleration of the platform, rad/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_acceleration: Option<f64>,
    /// Jerk of the platform, m/s³.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jerk: Option<f64>,
    /// Speed of every cable, m/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_speed: Option<f64>,
    /// Acceleration of every cable, m/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cable_acceleration: Option<f64>,
    /// Largest distance between the curve and the path, m.
    pub blend: f64,
    /// Largest clearance that the motion keeps, m; if it is not set, the motion keeps all clearances of the scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance: Option<f64>,
    /// Capacity margin that the cables keep in addition to the inertia of the platform, N.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub wrench_margin: f64,
}

/// Whether a number is omitted from a file.
pub(crate) fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

impl Limits {
    /// The limits of a scene, replaced by those of `given` that are set.
    ///
    /// # Errors
    /// A number that is not positive (`blend`, `clearance` and `wrench_margin`: negative) or not finite.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{model::spec::MotionSpec, testing, trajectory::Limits};
    /// let given = MotionSpec { speed: Some(0.5), acceleration: Some(2.0), ..MotionSpec::default() };
    /// let limits = Limits::of(&testing::hard1(), &given)?;
    /// assert_eq!((limits.speed, limits.jerk, limits.blend), (Some(0.5), None, 0.0));
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn of(scene: &Scene, given: &MotionSpec) -> Result<Self, Error> {
        body::sound_motion(*given)?;
        let spec = given.over(scene.spec().motion.as_ref());
        Ok(Limits {
            speed: spec.speed,
            acceleration: spec.acceleration,
            turn_speed: spec.turn_speed,
            turn_acceleration: spec.turn_acceleration,
            jerk: spec.jerk,
            cable_speed: spec.cable_speed,
            cable_acceleration: spec.cable_acceleration,
            blend: spec.blend.or(scene.spec().clearance).unwrap_or(0.0),
            clearance: spec.clearance,
            wrench_margin: spec.wrench_margin.unwrap_or(0.0),
        })
    }

    /// The note that the speed has no limit, if neither the platform nor the cables have one.
    pub fn note(&self) -> Option<&'static str> {
        (self.speed.is_none() && self.cable_speed.is_none()).then_some(
            "neither speed nor cable_speed is limited: check that the winches reach the speeds of this motion",
        )
    }

    /// The limits of a motion that was planned earlier, for a scene; where they do not set clearances, those of the
    /// scene apply.
    ///
    /// # Errors
    /// The errors of [`Limits::of`].
    pub fn over(&self, scene: &Scene) -> Result<Self, Error> {
        let of_scene = Limits::of(scene, &MotionSpec::default())?;
        Ok(Limits { clearance: self.clearance.or(of_scene.clearance), ..*self })
    }

    /// The scene with the clearances that the motion keeps.
    ///
    /// # Errors
    /// A clearance that is negative or too large.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{model::spec::MotionSpec, testing, trajectory::Limits};
    /// let scene = testing::hard1().with_clearance(0.05)?;
    /// let limits = Limits::of(&scene, &MotionSpec { clearance: Some(0.02), ..MotionSpec::default() })?;
    /// assert_eq!(limits.scene(&scene)?.pairs().largest(), 0.02);
    /// assert_eq!(Limits::default().scene(&scene)?.pairs().largest(), 0.05);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn scene<'a>(&self, scene: &'a Scene) -> Result<Cow<'a, Scene>, Error> {
        self.clearance.map_or(Ok(Cow::Borrowed(scene)), |most| scene.with_most_clearance(most).map(Cow::Owned))
    }
}
