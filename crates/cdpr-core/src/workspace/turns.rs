//! Whether all positions of a box are valid during turns: at every orientation on the way from one to the next.
//!
//! The platform turns at the centre of the box, and every other position of the box is at most half of its diagonal away: so close to this
//! motion, each condition is bounded as for a path that turns (`PhysicalCondition::kept_during_turn`), and required wrenches by how fast
//! their slack can drop.

use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Cuboid, Point, Pose, PoseMotion, Rotation, wxyz};
use crate::limits::LARGEST_SAMPLED_TURN;
use crate::model::Scene;
use crate::turning::TurningEngine;

/// The scenes, and those at even steps of the turns from each to the next.
///
/// # Errors
/// Fewer than two scenes.
pub fn on_the_way(scenes: &[Scene]) -> Result<Vec<Scene>, Error> {
    several(scenes.len())?;
    let mut all = vec![scenes[0].clone()];
    for ends in scenes.windows(2) {
        let turn = turn_at(&Point::origin(), [ends[0].orientation(), ends[1].orientation()]);
        let steps = (turn.angle / LARGEST_SAMPLED_TURN).ceil() as usize;
        for step in 1..steps {
            let orientation = turn.at(step as f64 / steps as f64).orientation;
            all.push(ends[0].clone().turned(wxyz(&orientation).into())?);
        }
        all.push(ends[1].clone());
    }
    Ok(all)
}

fn several(count: usize) -> Result<(), Error> {
    match count {
        0 | 1 => {
            Err(Error::invalid("orientations", format!("found {count}, expected at least two, between which to turn")))
        }
        _ => Ok(()),
    }
}

fn turn_at(position: &Point, [from, to]: [&Rotation; 2]) -> PoseMotion {
    Pose::new(*position, *from).toward(&Pose::new(*position, *to))
}

/// The turns from each of several orientations to the next.
pub struct Turns<'a> {
    engine: &'a TurningEngine,
    turns: Vec<[Rotation; 2]>,
}

/// What is not proved of one turn at all positions of a box.
#[derive(Debug, Clone)]
pub struct Unproved {
    /// Conditions, by index.
    conditions: Vec<u32>,
    /// Whether required wrenches are among it.
    wrench: bool,
}

impl<'a> Turns<'a> {
    /// The turns between the orientations at which a scene is compiled.
    ///
    /// # Errors
    /// Fewer than two; the errors of [`CompiledScene::turning`]; a turn that the table `[turning]` of the scene does not allow.
    pub fn new(compiled: &[&'a CompiledScene]) -> Result<Self, Error> {
        several(compiled.len())?;
        let engine = compiled[0].turning()?;
        let orientations: Vec<Rotation> = compiled.iter().map(|at| *at.scene().orientation()).collect();
        let turns: Vec<[Rotation; 2]> = orientations.windows(2).map(|ends| [ends[0], ends[1]]).collect();
        for [from, to] in &turns {
            let turn = turn_at(&Point::origin(), [from, to]).relative_to(engine.reference());
            if !engine.allows(&turn) {
                let [from, to] = [from, to].map(wxyz);
                let problem =
                    format!("found a turn from {from:?} to {to:?}, expected one that [turning] of the scene allows");
                return Err(Error::invalid("orientations", problem));
            }
        }
        Ok(Turns { engine, turns })
    }

    /// All that has to be proved, for each turn.
    pub fn all(&self) -> Vec<Unproved> {
        let conditions = (0..self.engine.conditions().list.len() as u32).collect();
        vec![Unproved { conditions, wrench: self.engine.requires_wrench() }; self.turns.len()]
    }

    /// What is still not proved in a box, for each turn; empty if nothing is left of any.
    pub fn left(&self, positions: &Cuboid, known: &[Unproved]) -> Vec<Unproved> {
        let apart = positions.half.norm();
        let left = |([from, to], known): (&[Rotation; 2], &Unproved)| {
            let turn = turn_at(&positions.center, [from, to]);
            let conditions = self.engine.unproved_near(&turn, apart, &known.conditions);
            // Wrenches take longest, so they wait until all else is proved.
            let wrench = known.wrench && !(conditions.is_empty() && self.engine.keeps_wrench_near(&turn, apart));
            Unproved { conditions, wrench }
        };
        let left: Vec<Unproved> = self.turns.iter().zip(known).map(left).collect();
        let proved = left.iter().all(|of| of.conditions.is_empty() && !of.wrench);
        if proved { Vec::new() } else { left }
    }
}
