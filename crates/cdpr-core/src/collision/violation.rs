//! How a broken condition is reported.

use serde::Serialize;

use crate::conditions::{Broken, Kind};
use crate::kinematics::freedom::Hold;

/// One broken condition of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Violation {
    /// Fraction of the motion at which it begins, 0 to 1.
    pub at: f64,
    /// The condition.
    pub kind: Kind,
    /// Who is involved, by the names of the scene.
    pub culprits: Vec<String>,
    /// Worst gap over the motion, m: between surfaces, minus a penetration depth where bodies overlap; for the workspace
    /// and the length of a cable the room left, negative outside. None where there is no such distance (wrench).
    pub gap: Option<f64>,
    /// What the gap would have to be, m.
    pub required: Option<f64>,
    /// Gap less what is required, m: never positive.
    pub margin: Option<f64>,
    /// Whether the condition may hold but could not be proved: almost no slack is left. Only where the kind is wrench.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub unproved: bool,
    /// What the wrenches lack, and which cables limit them; only where the kind is wrench.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub wrench: Option<WrenchLimit>,
}

/// The facet that limits the wrenches of a robot at a position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WrenchLimit {
    /// Margin less what is demanded; negative where something is lacking. None where a cable has no direction.
    pub wrench_margin: Option<f64>,
    /// Where it is measured, if at a point of the grid rule instead of on the motion, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<[f64; 3]>,
    /// What the cables hold there whatever their limits: rank and what follows from it. None where a cable has no
    /// direction.
    #[serde(flatten)]
    pub hold: Option<Hold>,
    /// What it is measured by: capacity, force or moment.
    pub measure: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Cables at their greatest tension there.
    pub at_greatest: Vec<String>,
    /// Cables at their least tension there.
    pub at_least: Vec<String>,
}

impl WrenchLimit {
    /// The margin as a number to sort by; minus infinity where there is none.
    pub fn order(&self) -> f64 {
        self.wrench_margin.unwrap_or(f64::NEG_INFINITY)
    }

    /// Whether no tensions resist some motion of the platform.
    pub fn leaves_motions_free(&self) -> bool {
        self.hold.as_ref().is_some_and(|hold| !hold.is_full())
    }

    /// In plain words: "by 12.3 N, with cable 2 at greatest tension and cable 4 at least tension".
    fn sentence(&self) -> String {
        let amount = match self.wrench_margin {
            None => return ": a cable has no direction".to_string(),
            Some(_) if self.leaves_motions_free() => {
                return self.hold.as_ref().map_or(String::new(), |hold| format!(": {}", hold.sentence()));
            }
            Some(margin) if margin < 0.0 => format!(" by {:.3} {}", -margin, self.unit),
            Some(margin) => format!(": the least {} margin found is {margin:.3e} {}", self.measure, self.unit),
        };
        let side = |cables: &[String], which: &str| {
            (!cables.is_empty()).then(|| format!("{} at {which} tension", cables.join(", ")))
        };
        let sides: Vec<String> =
            [side(&self.at_greatest, "greatest"), side(&self.at_least, "least")].into_iter().flatten().collect();
        let place = self.corner.map_or(String::new(), |[x, y, z]| {
            format!(" at the grid point ({x:.3}, {y:.3}, {z:.3}) that decides there")
        });
        if sides.is_empty() { amount + &place } else { format!("{amount}{place}, with {}", sides.join(" and ")) }
    }
}

impl Violation {
    /// The violation in plain words: "cable 3 meets pillar, 12.0 mm deep".
    pub fn sentence(&self) -> String {
        let limit = self.wrench.as_ref().map_or(String::new(), WrenchLimit::sentence);
        let what = if self.unproved {
            "it could not be proved that the cables balance the required wrenches".to_string()
        } else {
            self.kind.sentence(&Broken { culprits: &self.culprits, gap: self.gap, required: self.required })
        };
        what + &limit
    }
}
