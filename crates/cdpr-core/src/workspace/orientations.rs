//! What is certain about a box of positions at several orientations: positions are valid if they are so at every one of them, at any, or
//! during the turns from each to the next.

use serde::Deserialize;

use super::judge::{Judge, Judged, Open};
use super::turns::{Turns, Unproved, on_the_way};
use crate::choices;
use crate::collision::Checker;
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Aabb, Cuboid, Point};
use crate::model::Scene;
use crate::tolerances::TOUCH_DEPTH;
use crate::watch::Watch;

/// At how many of several orientations a position has to be valid.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ValidAt {
    /// At every orientation.
    #[default]
    Every,
    /// At any of the orientations.
    Any,
    /// At every orientation on the way from each to the next, by the shorter turn.
    Turns,
}

choices!(ValidAt, "valid_at", [
    Every = "every": "Positions that are valid at every orientation",
    Any = "any": "Positions that are valid at any of the orientations",
    Turns = "turns": "Positions that are valid during the turns from each orientation to the next",
]);

/// The scenes at the orientations of these, and for positions that are valid during turns, at even steps on the way from each to the
/// next: what forbids positions is looked for there.
///
/// # Errors
/// Fewer than two scenes for turns.
///
/// # Example
/// ```
/// use cdpr_core::workspace::{ValidAt, orientations_for};
/// let scene = cdpr_core::testing::hard1();
/// let turned = scene.clone().turned([0.8, 0.0, 0.0, 0.6].into())?; // by 73.7°
/// assert_eq!(orientations_for(&[scene.clone(), turned.clone()], ValidAt::Every)?.len(), 2);
/// assert_eq!(orientations_for(&[scene, turned], ValidAt::Turns)?.len(), 9);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn orientations_for(scenes: &[Scene], valid_at: ValidAt) -> Result<Vec<Scene>, Error> {
    match valid_at {
        ValidAt::Turns => on_the_way(scenes),
        ValidAt::Every | ValidAt::Any => Ok(scenes.to_vec()),
    }
}

/// Judges of one box of positions, one for each orientation.
pub struct Orientations<'a> {
    valid_at: ValidAt,
    levels: Vec<Level<'a>>,
    /// The turns between the orientations, if positions have to be valid during them.
    turns: Option<Turns<'a>>,
    within: Aabb,
}

/// A judge at one orientation.
pub struct Level<'a> {
    pub judge: Judge<'a>,
    /// Where the platform is inside the workspace of the scene.
    bounds: Cuboid,
    /// The index of its first condition among those of all orientations.
    first: u32,
}

/// What is known of a box.
pub struct Known {
    /// At each orientation.
    at: Vec<Judged>,
    /// What is not proved of the turns.
    turns: Vec<Unproved>,
}

/// The verdict on a box.
pub enum Verdict {
    /// All its positions are valid.
    Inside,
    /// No position is valid; the index of a condition that forbids them all, among those of all orientations.
    Outside(u32),
    /// Neither is certain.
    Open(Known),
}

impl<'a> Orientations<'a> {
    /// The judges of several orientations, for each of which the scene is compiled.
    ///
    /// # Errors
    /// No orientation; a workspace that the platform does not fit into; the errors of [`Turns::new`]; [`Error::interrupted`],
    /// [`Error::out_of_time`].
    pub fn new(compiled: &[&'a CompiledScene], valid_at: ValidAt, watch: &Watch) -> Result<Self, Error> {
        if compiled.is_empty() {
            return Err(Error::invalid("orientations", "found none, expected at least one"));
        }
        let turns = (valid_at == ValidAt::Turns).then(|| Turns::new(compiled)).transpose()?;
        let checkers: Vec<&dyn Checker> = compiled.iter().map(|at| at.level()).collect();
        let boxes: Vec<[Point; 2]> =
            checkers.iter().map(|checker| checker.conditions().position_box().into()).collect();
        let fits = |[min, max]: &[Point; 2]| (min - max).max() <= 0.0;
        let corners = match valid_at {
            ValidAt::Every | ValidAt::Turns => boxes.iter().copied().reduce(|[a, b], [c, d]| [a.sup(&c), b.inf(&d)]),
            ValidAt::Any => boxes.iter().filter(|of| fits(of)).copied().reduce(|[a, b], [c, d]| [a.inf(&c), b.sup(&d)]),
        };
        let Some([min, max]) = corners.filter(fits) else {
            let problem = "found one that the platform does not fit into, so there are no positions";
            return Err(Error::invalid("workspace", problem));
        };
        let (mut levels, mut first) = (Vec::new(), 0);
        for (checker, corners) in checkers.iter().zip(boxes) {
            if fits(&corners) {
                let [low, high] = if valid_at == ValidAt::Any { corners } else { [min, max] };
                let bounds = Cuboid::new(low, high);
                levels.push(Level { judge: Judge::new(*checker, bounds, watch)?, bounds, first });
            }
            first += checker.conditions().list.len() as u32 + 1;
        }
        Ok(Orientations { valid_at, levels, turns, within: Aabb { min, max } })
    }

    /// The positions at which the platform is inside the workspace, at every orientation or at any; around them, if these are no box.
    pub fn within(&self) -> Aabb {
        self.within
    }

    /// All that may forbid positions.
    pub fn all(&self) -> Known {
        let at = self.levels.iter().map(|level| Judged::Open(level.judge.all())).collect();
        Known { at, turns: self.turns.as_ref().map_or_else(Vec::new, Turns::all) }
    }

    /// The verdict on a box of which something is known.
    pub fn judged(&self, positions: &Cuboid, known: &Known) -> Verdict {
        let mut found = Vec::with_capacity(known.at.len());
        for (level, known) in self.levels.iter().zip(&known.at) {
            match (level.judged(positions, known), self.valid_at) {
                (Judged::Inside, ValidAt::Any) => return Verdict::Inside,
                (Judged::Outside(condition), ValidAt::Every | ValidAt::Turns) => {
                    return Verdict::Outside(level.first + condition);
                }
                (judged, _) => found.push(judged),
            }
        }
        if let Some(turns) = &self.turns {
            let left = turns.left(positions, &known.turns);
            return if left.is_empty() { Verdict::Inside } else { Verdict::Open(Known { at: found, turns: left }) };
        }
        // What is left is inside at every orientation, or outside at every one, unless it is open.
        let open = found.iter().any(|judged| matches!(judged, Judged::Open(_)));
        match found[0] {
            _ if open => Verdict::Open(Known { at: found, turns: Vec::new() }),
            Judged::Outside(condition) => Verdict::Outside(self.levels[0].first + condition),
            _ => Verdict::Inside,
        }
    }

    /// The orientations at which nothing is certain yet, and how they count together.
    pub fn open<'k>(&'k self, known: &'k Known) -> impl Iterator<Item = (&'k Level<'a>, &'k Open)> {
        self.levels.iter().zip(&known.at).filter_map(|(level, known)| match known {
            Judged::Open(open) => Some((level, open)),
            _ => None,
        })
    }

    /// At how many orientations a position has to be valid.
    pub fn valid_at(&self) -> ValidAt {
        self.valid_at
    }
}

impl Level<'_> {
    fn judged(&self, positions: &Cuboid, known: &Judged) -> Judged {
        let Judged::Open(open) = known else { return known.clone() };
        let Some(part) = self.part(positions) else { return Judged::Outside(WORKSPACE) };
        match self.judge.judged(&part, open) {
            Judged::Inside if part != *positions => Judged::Open(Open::within_bounds()),
            judged => judged,
        }
    }

    /// What of a box is inside the workspace; all of it, if it exceeds that by rounding errors only.
    pub fn part(&self, positions: &Cuboid) -> Option<Cuboid> {
        let beyond = (self.bounds.low - positions.low).max().max((positions.high - self.bounds.high).max());
        if beyond <= TOUCH_DEPTH {
            return Some(*positions);
        }
        let (low, high) = (positions.low.sup(&self.bounds.low), positions.high.inf(&self.bounds.high));
        ((high - low).min() >= 0.0).then(|| Cuboid::new(low, high))
    }

    /// The index of a condition among those of all orientations.
    pub fn condition(&self, condition: usize) -> u32 {
        self.first + condition as u32
    }
}

/// The condition that the platform is inside the workspace.
pub const WORKSPACE: u32 = 0;
