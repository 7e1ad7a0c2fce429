//! Pairs that are exempt from the clearance of their kind. They are listed with every answer, so that no "valid" hides
//! them.

use std::collections::BTreeMap;

use serde::Serialize;

use super::bodies::Bodies;
use crate::choices;
use crate::model::{Member, PairRule, Scene};
use crate::tolerances::ATTAINED;
use crate::words::small_length;

/// Why a pair is exempt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// The pair cannot keep the distance at any position. It must still not touch, unless that is unavoidable too.
    Unattainable,
    /// The scene allows the pair to touch, but not to overlap.
    Touch,
    /// The scene excludes the pair from checking.
    Ignore,
}

choices!(Reason, "reason", [
    Unattainable = "unattainable": "The pair cannot keep the distance at any position; it must still not touch",
    Touch = "touch": "The scene lets the pair touch, but not overlap",
    Ignore = "ignore": "The scene excludes the pair from checking",
]);

/// A pair that is exempt from the clearance of its kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Exemption {
    /// The names of the members.
    pub pair: [String; 2],
    /// Why the pair is exempt.
    pub reason: Reason,
    /// The clearance that would otherwise be required, m.
    pub demanded: f64,
    /// For an unattainable distance, the largest gap between the surfaces at any position, m; negative where thick
    /// cables overlap everywhere.
    pub attainable: Option<f64>,
    /// The members of the pair, by index.
    #[serde(skip)]
    pub members: [Member; 2],
    /// Indices of the conditions on the pair's distance.
    #[serde(skip)]
    pub conditions: Vec<usize>,
}

impl Exemption {
    /// Describes the exemption: "cable 2 and cable 4 can be 100.000 mm apart at most, 200.000 mm are demanded; they
    /// must still not touch".
    pub fn sentence(&self) -> String {
        let names = self.pair.join(" and ");
        let Some(attainable) = self.attainable else {
            return match self.reason {
                Reason::Ignore => format!("{names} are not checked against each other"),
                _ => format!("{names} may touch, but not enter each other"),
            };
        };
        let (most, still) = if attainable >= 0.0 {
            (format!("can be {} apart at most", small_length(attainable)), "they must still not touch")
        } else {
            (format!("overlap by {} at best", small_length(-attainable)), "only the axes of cables are kept clear")
        };
        let demanded = match self.demanded {
            0.0 => String::new(),
            demanded => format!(", {} are demanded", small_length(demanded)),
        };
        format!("{names} {most}{demanded}; {still}")
    }
}

/// Remarks collected while the conditions of a scene are listed.
#[derive(Debug, Default)]
pub struct Remarks {
    /// Pairs that are exempt from the clearance of their kind.
    pub exempt: Vec<Exemption>,
    /// Further notes for the user on how the scene is interpreted.
    pub notes: Vec<String>,
}

impl Remarks {
    /// The distance between axes or bodies, m, that the condition at `index` requires of a pair: clearance plus radii,
    /// as far as attainable. Any shortfall is recorded.
    pub fn kept(
        &mut self,
        bodies: &Bodies,
        (index, members): (usize, [Member; 2]),
        [clearance, radii, attainable]: [f64; 3],
    ) -> f64 {
        self.exempt_if_unattainable(bodies, (index, members), [clearance, radii, attainable]);
        kept(clearance, radii, attainable)
    }

    /// Records that the condition at `index` on this pair requires less than the scene demands, if so.
    pub(super) fn exempt_if_unattainable(
        &mut self,
        bodies: &Bodies,
        (index, members): (usize, [Member; 2]),
        [clearance, radii, attainable]: [f64; 3],
    ) {
        if attains(attainable, clearance + radii) {
            return;
        }
        let attainable = attainable - radii;
        // Conditions are sorted by their first members.
        let mut latest = self.exempt.iter_mut().rev().take_while(|known| known.members[0] == members[0]);
        if let Some(known) = latest.find(|known| known.members == members) {
            known.attainable = known.attainable.map(|best| best.min(attainable));
            known.conditions.push(index);
            return;
        }
        self.exempt.push(Exemption {
            pair: members.map(|member| bodies.name(member).to_string()),
            reason: Reason::Unattainable,
            demanded: clearance,
            attainable: Some(attainable),
            members,
            conditions: vec![index],
        });
    }

    /// Lists the pairs that the scene allows to touch or excludes from checking. `held_apart(index)` gives the pair of
    /// the condition at an index if it requires a distance; there are `count` conditions.
    pub fn exempt_by_name(&mut self, scene: &Scene, count: usize, held_apart: impl Fn(usize) -> Option<[Member; 2]>) {
        let mut listed: BTreeMap<[Member; 2], Exemption> = BTreeMap::new();
        for (members, rule) in scene.pairs().named() {
            let reason = match rule {
                PairRule::Apart(_) => continue,
                PairRule::Touch => Reason::Touch,
                PairRule::Ignore => Reason::Ignore,
            };
            let exemption = Exemption {
                pair: members.map(|member| scene.member_name(member).to_string()),
                reason,
                demanded: scene.pairs().of_kind(members[0], members[1]),
                attainable: None,
                members,
                conditions: Vec::new(),
            };
            listed.insert(members, exemption);
        }
        if listed.values().any(|exemption| exemption.reason == Reason::Touch) {
            for index in 0..count {
                if let Some([a, b]) = held_apart(index)
                    && let Some(exemption) = listed.get_mut(&[a.min(b), a.max(b)])
                {
                    exemption.conditions.push(index);
                }
            }
        }
        self.exempt.extend(listed.into_values());
    }
}

/// The required distance between the axes or bodies of a pair, m: clearance plus radii if some position allows it,
/// otherwise the radii alone, so that surfaces do not touch, or 0 if even that is impossible.
pub(super) fn kept(clearance: f64, radii: f64, attainable: f64) -> f64 {
    [clearance + radii, radii].into_iter().find(|gap| attains(attainable, *gap)).unwrap_or(0.0)
}

/// Whether a pair that can be `attainable` metres apart can keep this distance.
fn attains(attainable: f64, gap: f64) -> bool {
    gap <= attainable + ATTAINED
}
