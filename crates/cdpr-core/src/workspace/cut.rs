//! How much of an undecided box is certainly valid, and how much certainly forbidden, by the volumes that convex pieces cut off.
//!
//! Boxes on the surface of what is forbidden are never decided, however small. If only convex pieces reach into a box, all of it
//! but their union is valid, and their certainly forbidden parts are forbidden. Bounds of the slack of wrenches cut off half-spaces
//! likewise. For a box that one flat face crosses, the two are almost the whole box.

use super::judge::Open;
use super::orientations::{Known, Level, Orientations, ValidAt, WORKSPACE};
use super::volume::volume;
use crate::collision::Piece;
use crate::geometry::quadratic::Affine;
use crate::geometry::{Cuboid, HalfSpace, Quadratic};

/// Volumes of parts of a box, m³.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cut {
    /// Certainly valid.
    pub valid: f64,
    /// Certainly forbidden, by the conditions with these indices; no part counts twice.
    pub forbidden: Vec<(u32, f64)>,
}

impl Cut {
    fn forbid(&mut self, condition: u32, volume: f64) {
        if volume > 0.0 {
            match self.forbidden.iter_mut().find(|(known, _)| *known == condition) {
                Some((_, sum)) => *sum += volume,
                None => self.forbidden.push((condition, volume)),
            }
        }
    }

    /// What is decided, m³.
    pub fn decided(&self) -> f64 {
        self.valid + self.all_forbidden()
    }

    fn all_forbidden(&self) -> f64 {
        self.forbidden.iter().map(|(_, volume)| volume).sum()
    }

    fn add(&mut self, part: Cut) {
        self.valid += part.valid;
        part.forbidden.into_iter().for_each(|(condition, volume)| self.forbid(condition, volume));
    }
}

/// What is certain about parts of a box of which something is known; with `halvings`, the box is divided to follow curved surfaces more
/// closely.
pub fn cut(orientations: &Orientations, positions: &Cuboid, known: &Known, halvings: usize) -> Cut {
    let open: Vec<_> = orientations.open(known).collect();
    let cutting = |open: &[(&Level, &Open)]| Cutting::new(open, positions).cut_within(positions, halvings);
    match orientations.valid_at() {
        // What is valid at every orientation may be so at none between them.
        ValidAt::Turns => return Cut { valid: 0.0, ..cutting(&open) },
        ValidAt::Every => return cutting(&open),
        // At all other orientations, no position is valid.
        ValidAt::Any if open.len() == 1 => return cutting(&open),
        ValidAt::Any => {}
    }
    // At any of them: what is valid at one of them, and what is forbidden at all; of that, as much as must overlap.
    let cuts: Vec<Cut> = open.iter().map(|at| cutting(&[*at])).collect();
    let total = volume(&[], positions)[0];
    let common = cuts.iter().map(|cut| cut.all_forbidden() - total).sum::<f64>() + total;
    let mut found = Cut { valid: cuts.iter().map(|cut| cut.valid).fold(0.0, f64::max), forbidden: Vec::new() };
    if common > 0.0 {
        let share = common / cuts[0].all_forbidden();
        cuts[0].forbidden.iter().for_each(|(condition, volume)| found.forbid(*condition, share * volume));
    }
    found
}

/// Share of a box that may remain undecided without dividing it.
pub const SMALL: f64 = 0.01;

/// A box with what cuts it. Conditions have their index among those of all orientations.
struct Cutting<'a> {
    /// What of the box is inside the workspace, if only at one orientation positions may be valid.
    whole: Cuboid,
    /// Bounds of the slack of wrenches, with the conditions that require them.
    sides: Vec<(u32, Quadratic)>,
    pieces: Vec<&'a Piece>,
    /// The certainly forbidden parts of pieces that may be named as the reason.
    certain: Vec<(u32, &'a [HalfSpace])>,
    /// Whether nothing else may forbid positions.
    may_be_valid: bool,
    /// The condition on the workspace.
    outside: u32,
}

impl<'a> Cutting<'a> {
    /// What cuts a box at all of some orientations.
    fn new(open: &[(&'a Level, &'a Open)], positions: &Cuboid) -> Self {
        let part = |(level, _): &(&Level, &Open)| level.part(positions).unwrap_or(*positions);
        let whole = open.first().map_or(*positions, part);
        let mut found = Cutting {
            whole,
            sides: Vec::new(),
            pieces: Vec::new(),
            certain: Vec::new(),
            may_be_valid: true,
            outside: open.first().map_or(0, |(level, _)| level.condition(WORKSPACE as usize)),
        };
        for (level, open) in open {
            let slack = level.judge.wrench_slack(&whole, open);
            let wrench = level.condition(level.judge.wrench() as usize);
            found.may_be_valid &= slack.complete && level.judge.only_pieces(open);
            found.sides.extend(slack.sides.into_iter().map(|side| (wrench, side)));
            for piece in level.judge.pieces(open) {
                let condition = level.condition(piece.condition);
                found.pieces.push(piece);
                let certain = piece.certain.as_deref().filter(|_| level.judge.names(piece.condition));
                found.certain.extend(certain.map(|planes| (condition, planes)));
            }
        }
        found
    }

    /// What is certain about the box: of the part of it that is inside the workspace, and the rest.
    fn cut_within(&self, positions: &Cuboid, halvings: usize) -> Cut {
        let mut found = self.cut(&self.whole, halvings);
        if self.whole != *positions {
            found.forbid(self.outside, volume(&[], positions)[0] - volume(&[], &self.whole)[1]);
        }
        found
    }

    /// What is certain about a part of the box.
    fn cut(&self, part: &Cuboid, halvings: usize) -> Cut {
        let total = volume(&[], part)[0];
        let mut sides: Vec<(u32, Affine)> = Vec::new();
        let mut found = Cut::default();
        for (wrench, side) in &self.sides {
            let side = side.within(&self.whole, part);
            if side.greatest() < 0.0 {
                found.forbid(*wrench, total);
                return found;
            }
            if !(side.least() >= 0.0) {
                sides.push((*wrench, side.affine()));
            }
        }
        if self.may_be_valid {
            let planes: Vec<HalfSpace> = sides.iter().filter_map(|(_, side)| side.sufficing(part)).collect();
            let held = volume(&planes, part)[0];
            if held > 0.0 {
                let outer: Vec<&[HalfSpace]> = self.pieces.iter().map(|piece| piece.outer.as_slice()).collect();
                found.valid = (held - of_union(&outer, &planes, part)).max(0.0);
            }
        }
        // Where no bound shows that wrenches are lacking.
        let opposite = |plane: HalfSpace| HalfSpace { normal: -plane.normal, offset: -plane.offset };
        let (mut rest, mut left) = (Vec::new(), total);
        for of_one in sides.chunk_by(|a, b| a.0 == b.0) {
            rest.extend(of_one.iter().filter_map(|(_, side)| side.lacking(part)).map(opposite));
            let now = volume(&rest, part)[1].min(left);
            found.forbid(of_one[0].0, left - now);
            left = now;
        }
        added(&self.certain, &rest, part).into_iter().for_each(|(condition, volume)| found.forbid(condition, volume));
        if halvings == 0 || sides.is_empty() || total - found.decided() <= SMALL * total {
            return found;
        }
        let mut sum = Cut::default();
        part.eighths().iter().for_each(|eighth| sum.add(self.cut(eighth, halvings - 1)));
        sum
    }
}

/// An upper bound of the volume of a box that lies in some half-spaces and in any of some polyhedra: the sum of their volumes, less
/// what each has in common with one before it (D. Hunter, "An upper bound for the probability of a union", Journal of Applied
/// Probability 13, 1976).
fn of_union(polyhedra: &[&[HalfSpace]], within: &[HalfSpace], positions: &Cuboid) -> f64 {
    let added = |k: usize| {
        let common = |before: &&[HalfSpace]| volume(&[before, polyhedra[k], within].concat(), positions)[0];
        let most = volume(&[polyhedra[k], within].concat(), positions)[1];
        let largest = polyhedra[..k.min(MOST_PAIRS)].iter().map(common).fold(0.0, f64::max);
        (most - largest).max(0.0)
    };
    (0..polyhedra.len()).map(added).sum()
}

/// Number of polyhedra with which each is intersected.
const MOST_PAIRS: usize = 4;

/// Lower bounds of the volumes that polyhedra, the largest first, add to their union, in a box and some half-spaces: less what each has
/// in common with those before it.
fn added(polyhedra: &[(u32, &[HalfSpace])], within: &[HalfSpace], positions: &Cuboid) -> Vec<(u32, f64)> {
    let sized =
        polyhedra.iter().map(|(name, planes)| (volume(&[planes, within].concat(), positions)[0], *name, *planes));
    let mut sized: Vec<_> = sized.filter(|(size, ..)| *size > 0.0).collect();
    sized.sort_by(|a, b| b.0.total_cmp(&a.0));
    sized.truncate(MOST_PAIRS);
    let more = |k: usize| {
        let (size, name, planes) = sized[k];
        let common =
            |(_, _, before): &(f64, u32, &[HalfSpace])| volume(&[before, planes, within].concat(), positions)[1];
        (name, size - sized[..k].iter().map(common).sum::<f64>())
    };
    (0..sized.len()).map(more).filter(|(_, volume)| *volume > 0.0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Vector};

    fn below(axis: usize) -> Vec<HalfSpace> {
        vec![HalfSpace::through(&Point::new(0.5, 0.5, 0.5), Vector::ith(axis, 1.0))]
    }

    #[test]
    fn what_two_polyhedra_have_in_common_counts_once() {
        let cube = Cuboid::new(Point::origin(), Point::new(1.0, 1.0, 1.0));
        let (x, y, z) = (below(0), below(1), below(2));
        assert!((of_union(&[&x], &[], &cube) - 0.5).abs() < 1e-6);
        assert!((of_union(&[&x, &y], &[], &cube) - 0.75).abs() < 1e-6);
        assert!((of_union(&[&x, &y], &y, &cube) - 0.5).abs() < 1e-6);
        let three = of_union(&[&x, &y, &z], &[], &cube);
        assert!((0.875..=1.0 + 1e-6).contains(&three), "{three}");
        let added: Vec<(u32, f64)> = added(&[(4, &x), (5, &y), (6, &z)], &[], &cube);
        let sum: f64 = added.iter().map(|(_, volume)| volume).sum();
        assert!((0.749..=0.875).contains(&sum) && added.len() == 2, "{added:?}");
    }
}
