//! How a broken condition is reported.

use serde::Serialize;

use crate::conditions::{Broken, Kind, Shapes};
use crate::kinematics::freedom::Hold;
use crate::model::LoadCase;

/// One broken condition of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Violation {
    /// Fraction of the motion at which the violation begins, 0 to 1.
    pub at: f64,
    /// The kind of the condition.
    pub kind: Kind,
    /// Names of the members involved.
    pub culprits: Vec<String>,
    /// Worst gap over the motion, m: between surfaces, negative by the penetration depth where bodies overlap; for the
    /// workspace and the length of a cable, the distance from the limits, negative outside. Of a thick cable that ends on a
    /// body or cannot stay clear of it, only the axis must not enter it, and the gap is that of the axis. `None` if there
    /// is no such distance (wrench).
    pub gap: Option<f64>,
    /// The required gap, m; 0 for bodies that only have to stay apart.
    pub required: Option<f64>,
    /// Gap minus required gap, m: never positive.
    pub margin: Option<f64>,
    /// Whether the condition may hold but could not be proved, because almost no slack is left. Only for wrenches and
    /// motions with a turn.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub unproved: bool,
    /// What the gap of cables that are not straight lines from their outlets includes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shapes: Option<Shapes>,
    /// The shortfall of wrenches, and the cables that limit them; only for wrenches.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub wrench: Option<WrenchLimit>,
}

/// The facet that limits the wrenches of a robot at a position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WrenchLimit {
    /// Margin minus required margin; negative if it falls short. `None` where a cable has no direction.
    pub wrench_margin: Option<f64>,
    /// The grid point where the margin is measured, m, if the grid rule was applied instead of measuring along the
    /// motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<[f64; 3]>,
    /// How the cables constrain the platform at that position, regardless of tension limits: rank and its consequences.
    /// `None` where a cable has no direction.
    #[serde(flatten)]
    pub hold: Option<Hold>,
    /// The measure: capacity, force or moment.
    pub measure: &'static str,
    /// Unit of the measure.
    pub unit: &'static str,
    /// The load case that limits the wrenches, if the scene has several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load_case: Option<LoadCase>,
    /// Cables at maximum tension on the limiting facet.
    pub at_greatest: Vec<String>,
    /// Cables at minimum tension on the limiting facet.
    pub at_least: Vec<String>,
}

impl WrenchLimit {
    /// The margin as a sort key; minus infinity if there is none.
    pub fn order(&self) -> f64 {
        self.wrench_margin.unwrap_or(f64::NEG_INFINITY)
    }

    /// Whether some motion of the platform is not resisted by any tensions.
    pub fn leaves_motions_free(&self) -> bool {
        self.hold.as_ref().is_some_and(|hold| !hold.is_full())
    }

    /// Describes the shortfall: "by 12.3 N, with cable 2 at greatest tension and cable 4 at least tension".
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
        let sides = if sides.is_empty() { String::new() } else { format!(", with {}", sides.join(" and ")) };
        let case = self.load_case.map_or(String::new(), |case| format!(" ({case})"));
        format!("{amount}{place}{sides}{case}")
    }
}

/// Violations at one state, worst first: by the shortfall of a gap, m, then wrenches by their shortfall, then those
/// that are only unproved.
pub fn worst_first(mut violations: Vec<Violation>) -> Vec<Violation> {
    let group = |violation: &Violation| (violation.unproved, violation.wrench.is_some());
    let margin = |Violation { margin, wrench, .. }: &Violation| {
        margin.or_else(|| wrench.as_ref().map(WrenchLimit::order)).unwrap_or(0.0)
    };
    violations.sort_by(|a, b| group(a).cmp(&group(b)).then(margin(a).total_cmp(&margin(b))));
    violations
}

impl Violation {
    /// The violation of a condition of this kind, on these culprits, that begins at this fraction of a motion: the worst gap
    /// between surfaces and the required one, m; the required gap is not positive where only axes have to stay apart.
    pub fn of_distance(at: f64, (kind, culprits): (Kind, Vec<String>), gap: f64, required: f64) -> Self {
        let (gap, required) = if required > 0.0 { (gap, required) } else { (gap - required, 0.0) };
        let margin = (gap - required).min(0.0); // a positive difference is a rounding error: the condition is broken
        let [gap, required, margin] = [gap, required, margin].map(Some);
        Violation { at, kind, culprits, gap, required, margin, unproved: false, shapes: None, wrench: None }
    }

    /// The violation of a wrench requirement that begins at this fraction of a motion; marked as unproved if its limit is
    /// no failure.
    pub fn of_wrench(at: f64, limit: WrenchLimit) -> Self {
        let culprits = limit.at_greatest.iter().chain(&limit.at_least).cloned().collect();
        let unproved = limit.wrench_margin.is_some_and(|margin| margin >= 0.0) && !limit.leaves_motions_free();
        let wrench = Some(limit);
        Violation {
            at,
            kind: Kind::Wrench,
            culprits,
            gap: None,
            required: None,
            margin: None,
            unproved,
            shapes: None,
            wrench,
        }
    }

    /// Describes the violation: "cable 3 meets pillar, 12.0 mm deep".
    pub fn sentence(&self) -> String {
        let limit = self.wrench.as_ref().map_or(String::new(), WrenchLimit::sentence);
        let what = match (self.unproved, &self.wrench) {
            (true, Some(_)) => "it could not be proved that the cables balance the required wrenches".to_string(),
            (true, None) => self.unproved_gap(),
            _ => self.kind.sentence(&Broken { culprits: &self.culprits, gap: self.gap, required: self.required }),
        };
        what + &self.shapes.map_or(String::new(), |shapes| shapes.sentence()) + &limit
    }

    fn unproved_gap(&self) -> String {
        let culprits = self.culprits.join(" and ");
        match self.culprits.len() {
            2 => format!("it could not be proved that {culprits} stay as far apart as required"),
            _ => format!("it could not be proved that {culprits} stays within its limits"),
        }
    }
}
