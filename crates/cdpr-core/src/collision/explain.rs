//! Where and how badly a motion breaks conditions, in the same words and measures for every engine.

use super::along::{at, first_true, least_between};
use super::validity::Checker;
use super::violation::Violation;
use crate::conditions::Conditions;
use crate::geometry::{Placed, Point};

/// All conditions that a motion breaks according to an engine, in the order of first contact.
pub(super) fn violations(checker: &impl Checker, from: &Point, to: &Point) -> Vec<Violation> {
    let conditions = checker.conditions();
    let broken: Vec<usize> = (0..conditions.list.len()).filter(|&k| checker.breaks(k, from, to)).collect();
    let reported = broken.iter().filter(|&&k| !is_reported_beside(conditions, k, &broken));
    let mut violations: Vec<Violation> = reported.map(|&k| violation(checker, k, from, to)).collect();
    violations.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.kind.cmp(&b.kind)));
    merge_parts(violations)
}

/// Whether a broken condition concerns a seam while a condition on a part beside the seam is broken as well. The
/// condition on the part gives the right culprit and depth.
fn is_reported_beside(conditions: &Conditions, index: usize, broken: &[usize]) -> bool {
    let (list, bodies) = (&conditions.list, &conditions.bodies);
    let seam = list[index].details();
    seam.closes_seam(bodies) && broken.iter().any(|&other| seam.is_seam_beside(list[other].details(), bodies))
}

/// Number of intervals into which samples of a distance divide a motion.
const SAMPLES: usize = 16;

/// Where and how badly a motion breaks a condition that it is known to break.
fn violation(checker: &impl Checker, index: usize, from: &Point, to: &Point) -> Violation {
    let (conditions, condition) = (checker.conditions(), &checker.conditions().list[index]);
    // The swept set only grows, so first and last contact are found by bisection on the whole test.
    let first = first_true(|t| checker.breaks(index, from, &at(from, to, t)));
    let last = 1.0 - first_true(|t| checker.breaks(index, &at(from, to, 1.0 - t), to));
    let (details, bodies) = (condition.details(), &conditions.bodies);
    let distance_at = |p: &Point| details.distance(bodies, p, p);
    let gap = details.worst_distance(bodies, checker.interference(), from, to).unwrap_or_else(|| match from == to {
        true => distance_at(from),
        false => least_between(first, last, SAMPLES, |t| distance_at(&at(from, to, t))).value,
    });
    let members = (details.kind(), conditions.culprits(condition));
    let found = Violation::of_distance(first, members, gap, details.required(bodies));
    let ends = [from, to].map(Placed::translated);
    Violation { shapes: details.shapes(bodies, &ends), ..found }
}

/// Merges violations of the same kind and culprits: a body of several parts is one body.
fn merge_parts(violations: Vec<Violation>) -> Vec<Violation> {
    let mut merged: Vec<Violation> = Vec::new();
    for violation in violations {
        match merged.iter_mut().find(|v| v.kind == violation.kind && v.culprits == violation.culprits) {
            Some(known) => {
                if violation.margin < known.margin {
                    (known.gap, known.required, known.margin) = (violation.gap, violation.required, violation.margin);
                }
            }
            None => merged.push(violation),
        }
    }
    merged
}
