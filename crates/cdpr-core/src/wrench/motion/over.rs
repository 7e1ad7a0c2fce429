//! The required wrenches over a box of positions, by bounds of the slack to each facet of the measured set.
//!
//! If all facets have sufficient slack at a position, so has the whole set: where one of them has, the columns have full rank, and
//! every facet of a set of full rank is spanned by n − 1 of them. A facet that has it in a whole box need not be examined in parts of
//! the box. If one facet has negative slack, so has the set.
//!
//! The bounds of a box hold in its parts, and stay tight there for some generations. Only when they are too loose are new ones
//! computed.

mod expansion;

use std::sync::Arc;

use super::measure::Measure;
use crate::collision::{FacetBounds, Unproved};
use crate::geometry::{Cuboid, Quadratic};
use crate::limits::MOST_FACET_BOUNDS;
use expansion::{Expansion, Facets};

/// What remains unproved of a measure in a box, at most `unproved`; `None` if its slack certainly is negative everywhere in the box.
///
/// This is tighter than [`Measure::lacking`], but no certificate has it. Where the slack is negative, the outlets are the given ones,
/// which are among those within their errors.
pub fn judged(measure: &Measure, positions: &Cuboid, unproved: &Unproved) -> Option<Unproved> {
    let (mut open, mut lost) = (Vec::new(), Vec::new());
    let (known, renewed) = match unproved {
        Unproved::Nothing => return Some(Unproved::Nothing),
        Unproved::All => (None, choices(measure)),
        Unproved::Facets { known, open: before, others } => {
            let mut renewed = others.clone();
            for &k in before {
                let (cables, slack) = &known.slack[k as usize];
                let slack = slack.within(&known.positions, positions);
                if slack.greatest() < 0.0 {
                    return None;
                }
                if !(slack.least() >= 0.0) {
                    open.push(k);
                    if !(slack.staleness() < STALE) && !renewed.contains(cables) {
                        renewed.push(*cables);
                    }
                }
            }
            (Some(known), renewed)
        }
    };
    if let Some(known) = known.filter(|_| renewed.is_empty()) {
        return Some(left(known.clone(), open, lost));
    }
    let expansion = Expansion::new(measure, positions).filter(|_| !renewed.is_empty());
    let Some(expansion) = expansion else {
        return Some(if slack_suffices(measure, positions) { Unproved::Nothing } else { unproved.clone() });
    };
    let mut slack = Vec::new();
    let mut facets = Facets::default();
    for &cables in &renewed {
        if !expansion.facets(cables, &mut facets) {
            lost.push(cables);
            continue;
        }
        for side in &facets.sides {
            if side.greatest() < 0.0 {
                return None;
            }
            if !(side.least() >= 0.0) {
                slack.push((cables, *side));
            }
        }
    }
    if slack.is_empty() && open.is_empty() {
        let suffices = |sides: Vec<Quadratic>| sides.iter().all(|side| side.least() >= 0.0);
        lost.retain(|cables| !replaced(&expansion, *cables).is_some_and(suffices));
    }
    if !lost.is_empty() && slack_suffices(measure, positions) {
        return Some(Unproved::Nothing);
    }
    let kept = open.iter().filter_map(|k| Some((known?, known?.slack[*k as usize])));
    let kept = kept.filter(|(_, (cables, _))| !renewed.contains(cables));
    slack.extend(kept.map(|(known, (cables, side))| (cables, side.within(&known.positions, positions))));
    if slack.len() > MOST_FACET_BOUNDS {
        let more = slack.drain(..).map(|(cables, _)| cables);
        more.for_each(|cables| {
            if !lost.contains(&cables) {
                lost.push(cables)
            }
        });
    }
    slack.sort_by(|a, b| a.1.greatest().total_cmp(&b.1.greatest()));
    let open = (0..slack.len() as u32).collect();
    Some(left(Arc::new(FacetBounds { positions: *positions, slack }), open, lost))
}

fn left(known: Arc<FacetBounds>, open: Vec<u32>, others: Vec<u32>) -> Unproved {
    if open.is_empty() && others.is_empty() { Unproved::Nothing } else { Unproved::Facets { known, open, others } }
}

/// Bounds are computed anew if they are this loose.
const STALE: f64 = 0.2;

/// Whether the slack at the centre shows that it suffices in the whole box.
fn slack_suffices(measure: &Measure, positions: &Cuboid) -> bool {
    let reach = positions.half.norm();
    let slack = measure.slack(&positions.center);
    slack >= measure.floor() && slack - reach * measure.steepness(&positions.center, reach) >= measure.floor()
}

/// All choices of cables that may span a facet, as bit masks, in lexicographic order.
fn choices(measure: &Measure) -> Vec<u32> {
    fn choose(from: usize, cables: usize, left: usize, mask: u32, found: &mut Vec<u32>) {
        if left == 0 {
            return found.push(mask);
        }
        for cable in from..(cables + 1).saturating_sub(left) {
            choose(cable + 1, cables, left - 1, mask | 1 << cable, found);
        }
    }
    let mut found = Vec::new();
    choose(0, measure.statics().cables().len(), measure.rows() - 1, 0, &mut found);
    found
}

/// Adds functions such that the slack in a box, of which only `unproved` is not proved, is negative where one of them is, and suffices
/// where none of them is if this returns true.
pub fn sides(measure: &Measure, positions: &Cuboid, unproved: &Unproved, sides: &mut Vec<Quadratic>) -> bool {
    let mut renewed = match unproved {
        Unproved::Nothing => return true,
        Unproved::All => choices(measure),
        Unproved::Facets { others, .. } => others.clone(),
    };
    if let Unproved::Facets { known, open, .. } = unproved {
        for &k in open {
            let (cables, slack) = &known.slack[k as usize];
            let slack = slack.within(&known.positions, positions);
            match slack.is_loose() {
                true if renewed.contains(cables) => {}
                true => renewed.push(*cables),
                false => sides.push(slack),
            }
        }
    }
    if renewed.is_empty() {
        return !matches!(unproved, Unproved::All);
    }
    let Some(expansion) = Expansion::new(measure, positions) else { return false };
    let mut facets = Facets::default();
    let mut complete = true;
    for cables in renewed {
        if expansion.facets(cables, &mut facets) {
            sides.extend_from_slice(&facets.sides);
        } else if let Some(others) = replaced(&expansion, cables) {
            sides.extend(others);
        } else {
            complete = false;
        }
    }
    complete
}

/// Lower bounds that together replace the facets of some cables whose normal may vanish; `None` if there are none.
///
/// Let the cables without one of them, e, keep their rank. The normals orthogonal to them form a circle, and in it the slack is
/// concave between two directions orthogonal to a further cable, if the tension of e is fixed. So it is nowhere less than at those
/// directions, less what e provides there; the columns of two further cables must not have the same direction.
fn replaced(expansion: &Expansion, lost: u32) -> Option<Vec<Quadratic>> {
    let within = |mask: u32| (0..expansion.cables()).filter(move |cable| mask >> cable & 1 == 1);
    let without = |e: usize| -> Option<Vec<Quadratic>> {
        let rest = lost & !(1 << e);
        let (mut sides, mut differ) = (Vec::new(), false);
        let mut facets = Facets::default();
        for k in within(!lost) {
            if !expansion.facets(rest | 1 << k, &mut facets) {
                return None;
            }
            differ |= within(!lost).any(|other| other != k && facets.products[other].1);
            let [least, greatest] = expansion.tension(e);
            let provided = (greatest - least) * facets.products[e].0;
            let less = |side: &Quadratic| Quadratic { below: side.below + provided, above: f64::INFINITY, ..*side };
            sides.extend(facets.sides.iter().map(less));
        }
        differ.then_some(sides)
    };
    let bound = |sides: &[Quadratic]| sides.iter().map(Quadratic::least).fold(f64::INFINITY, f64::min);
    within(lost).filter_map(without).max_by(|a, b| bound(a).total_cmp(&bound(b)))
}
