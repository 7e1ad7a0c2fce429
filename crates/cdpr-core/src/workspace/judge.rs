//! What is certain about a box of positions: all are valid, or one condition forbids them all.

use crate::collision::{Checker, Piece, Slack, Unproved};
use crate::conditions::PhysicalCondition;
use crate::decomposition::Oracle;
use crate::error::Error;
use crate::geometry::Cuboid;
use crate::proof::{Beyond, Regions};
use crate::watch::Watch;

/// What can forbid positions.
enum Threat {
    /// A convex piece of what a condition forbids, by its index.
    Piece(u32),
    /// A condition that may forbid positions outside of all pieces; bounds decide.
    Bound(usize),
}

/// Judges boxes by the conditions of an engine.
pub struct Judge<'a> {
    checker: &'a dyn Checker,
    pieces: Vec<Piece>,
    regions: Regions<'a>,
    /// In the order of their conditions.
    threats: Vec<Threat>,
}

/// What is not yet excluded in a box.
#[derive(Debug, Clone, Default)]
pub struct Open {
    /// The threats that may reach into it, by index.
    near: Vec<u32>,
    /// What is not proved of the required wrenches; `None` if nothing is.
    wrench: Option<Vec<Unproved>>,
}

impl Open {
    /// Only that the bounds of the judge exclude something.
    pub fn within_bounds() -> Self {
        Open { near: Vec::new(), wrench: Some(Vec::new()) }
    }

    /// Whether the required wrenches are proved.
    fn has_wrench(&self) -> bool {
        self.wrench.as_ref().is_some_and(|unproved| unproved.iter().all(|of| *of == Unproved::Nothing))
    }
}

/// The verdict on a box.
#[derive(Debug, Clone)]
pub enum Judged {
    /// All its positions are valid.
    Inside,
    /// The condition with this index forbids all its positions.
    Outside(u32),
    /// Neither is certain.
    Open(Open),
}

impl<'a> Judge<'a> {
    /// A judge of boxes within a box of positions.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn new(checker: &'a dyn Checker, bounds: Cuboid, watch: &Watch) -> Result<Self, Error> {
        let conditions = checker.conditions();
        let mut pieces = checker.pieces(watch)?.to_vec();
        let mut has_piece = vec![false; conditions.list.len()];
        pieces.iter().for_each(|piece| has_piece[piece.condition] = true);
        // An engine leaves out pieces beyond its box; they must not be mistaken for conditions that bounds have to decide.
        let (scale, fat) = (conditions.scale(), conditions.fattened());
        let mut bounds_decide = Vec::new();
        for index in 1..conditions.list.len() {
            watch.check()?;
            let regions = if has_piece[index] { Vec::new() } else { conditions.regions(index, &scale, &fat) };
            let found = conditions.pieces_of(index, regions.iter(), &fat);
            if conditions.list[index].details().exceeds_pieces() || found.len() < regions.len() {
                bounds_decide.push(index);
            }
            pieces.extend(found);
        }
        pieces.sort_by_key(|piece| piece.condition);
        let condition = |threat: &Threat| match threat {
            Threat::Piece(index) => pieces[*index as usize].condition,
            Threat::Bound(index) => *index,
        };
        let by_piece = (0..pieces.len() as u32).map(Threat::Piece);
        let mut threats: Vec<Threat> = by_piece.chain(bounds_decide.into_iter().map(Threat::Bound)).collect();
        threats.sort_by_key(condition);
        let regions = Regions::new(checker, bounds, &pieces, Beyond::Nothing);
        Ok(Judge { checker, pieces, regions, threats })
    }

    /// All that may forbid positions.
    pub fn all(&self) -> Open {
        Open { near: (0..self.threats.len() as u32).collect(), wrench: None }
    }

    /// The verdict on a box in which `open` is not yet excluded. If several conditions forbid it, the first is named.
    pub fn judged(&self, positions: &Cuboid, open: &Open) -> Judged {
        let mut near = Vec::new();
        for &threat in &open.near {
            let (reaches, forbidding) = match &self.threats[threat as usize] {
                Threat::Piece(index) => self.by_piece(*index, positions),
                Threat::Bound(condition) => self.by_bound(*condition, positions),
            };
            if let Some(condition) = forbidding {
                return Judged::Outside(condition as u32);
            }
            if reaches {
                near.push(threat);
            }
        }
        let wrench = match open.has_wrench() {
            true => Some(Vec::new()),
            false => self.checker.wrench_over(positions, open.wrench.as_deref()),
        };
        if wrench.is_none() {
            return Judged::Outside(self.wrench());
        }
        let open = Open { near, wrench };
        if open.near.is_empty() && open.has_wrench() { Judged::Inside } else { Judged::Open(open) }
    }

    /// The pieces among what is not excluded.
    pub fn pieces<'s>(&'s self, open: &'s Open) -> impl Iterator<Item = &'s Piece> {
        open.near.iter().filter_map(|threat| match &self.threats[*threat as usize] {
            Threat::Piece(index) => Some(&self.pieces[*index as usize]),
            Threat::Bound(_) => None,
        })
    }

    /// Where in a box the required wrenches are available.
    pub fn wrench_slack(&self, positions: &Cuboid, open: &Open) -> Slack {
        match open.has_wrench() {
            true => Slack { sides: Vec::new(), complete: true },
            false => self.checker.wrench_slack(positions, open.wrench.as_deref()),
        }
    }

    /// The index of wrenches, after all conditions.
    pub fn wrench(&self) -> u32 {
        self.checker.conditions().list.len() as u32
    }

    /// Whether, besides wrenches, only pieces are not excluded.
    pub fn only_pieces(&self, open: &Open) -> bool {
        open.near.iter().all(|threat| matches!(self.threats[*threat as usize], Threat::Piece(_)))
    }

    /// Whether a condition may be named as the reason: a body that closes a seam has no name of its own.
    pub fn names(&self, condition: usize) -> bool {
        !self.details(condition).closes_seam(&self.checker.conditions().bodies)
    }

    fn details(&self, condition: usize) -> &dyn PhysicalCondition {
        self.checker.conditions().list[condition].details()
    }

    /// Whether a piece may reach into a box, and its condition if it forbids all of it.
    fn by_piece(&self, index: u32, positions: &Cuboid) -> (bool, Option<usize>) {
        let piece = &self.pieces[index as usize];
        let details = self.details(piece.condition);
        // Planes bracket rounded edges; a bound by the distance comes as close to them as the box is small.
        let rounded = || details.is_rounded() && details.allows_all(&self.checker.conditions().bodies, positions);
        if !self.regions.reaches(piece, positions) || rounded() {
            return (false, None);
        }
        (true, self.regions.closes(index, piece, positions).then_some(piece.condition))
    }

    /// Whether a condition may forbid positions of a box, and the condition if it forbids all of them.
    fn by_bound(&self, condition: usize, positions: &Cuboid) -> (bool, Option<usize>) {
        let bodies = &self.checker.conditions().bodies;
        let details = self.details(condition);
        if details.allows_all(bodies, positions) {
            return (false, None);
        }
        (true, (self.names(condition) && self.regions.forbids_all(condition, positions)).then_some(condition))
    }
}
