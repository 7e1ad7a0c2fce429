//! The data of a report on a finished run: `summary.json` and the costs in `trials.csv`.

use std::collections::BTreeMap;

use crate::{MethodSummary, SummaryFile, Swept};

/// The contents of `summary.json` and `trials.csv`.
#[derive(Debug, Clone)]
pub struct Study {
    /// Contents of `summary.json`.
    pub summary: SummaryFile,
    /// Costs of the solved trials, by scenario and method.
    pub costs: Costs,
}

/// Costs by scenario and method.
pub type Costs = BTreeMap<(String, String), Vec<Cost>>;

/// The costs of a solved trial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Number of the trial.
    pub trial: usize,
    /// Length of the planner's path, m.
    pub raw: f64,
    /// Length of the final path, m.
    pub cost: f64,
}

impl Cost {
    /// Reduction of the path's length by post-processing, % of the raw length.
    pub fn reduction(&self) -> f64 {
        if self.raw > 0.0 { 100.0 * (1.0 - self.cost / self.raw) } else { 0.0 }
    }
}

/// A swept method in a scenario: the common part of its variants.
pub(super) type Family<'a> = (&'a str, &'a str);

impl Study {
    /// The summary of a method in a scenario.
    pub(super) fn method(&self, [scenario, method]: &[String; 2]) -> Option<&MethodSummary> {
        self.summary.methods.iter().find(|m| m.scenario == *scenario && m.method == *method)
    }

    /// The swept methods of each scenario, with their variants.
    pub(super) fn families(&self) -> BTreeMap<Family<'_>, Vec<(&MethodSummary, &Swept)>> {
        let mut families: BTreeMap<Family, Vec<_>> = BTreeMap::new();
        for method in &self.summary.methods {
            if let Some(sweep) = &method.sweep {
                families.entry((&method.scenario, &sweep.of)).or_default().push((method, sweep));
            }
        }
        families
    }

    /// The costs of a method in a scenario.
    pub(super) fn costs_of(&self, method: &MethodSummary) -> &[Cost] {
        self.costs.get(&(method.scenario.clone(), method.method.clone())).map_or(&[], Vec::as_slice)
    }

    /// Differences between the orders of rewinding, for each number of repeats and step.
    pub(super) fn order_gaps(&self) -> Vec<OrderGap<'_>> {
        let mut gaps = Vec::new();
        for variants in self.families().values() {
            for (backward, sweep) in variants.iter().filter(|(_, s)| s.post.as_deref() == Some("backward")) {
                let twin = |s: &Swept| {
                    s.post.as_deref() == Some("forward") && (s.step, s.repeats) == (sweep.step, sweep.repeats)
                };
                if let Some((forward, _)) = variants.iter().find(|(_, other)| twin(other)) {
                    gaps.extend(OrderGap::of(backward, self.costs_of(backward), self.costs_of(forward)));
                }
            }
        }
        gaps
    }
}

/// Differences between two orders of rewinding on the same raw paths, in percentage points of the raw length.
pub(super) struct OrderGap<'a> {
    pub backward: &'a MethodSummary,
    pub trials: usize,
    /// Mean of backward minus forward.
    pub difference: f64,
    /// Mean of the absolute differences.
    pub gap: f64,
    pub largest: f64,
    /// Shares of trials in which the two orders differ by more than 0.01, 1 and 5 points, %.
    pub beyond: [f64; 3],
    /// Gain of keeping the better result over backward first, and over forward first.
    pub gains: [f64; 2],
}

/// Thresholds for differences, percentage points; below the first, results count as equal.
pub(super) const APART: [f64; 3] = [0.01, 1.0, 5.0];

impl<'a> OrderGap<'a> {
    /// `None` without a trial that both orders solved.
    fn of(name: &'a MethodSummary, backward: &[Cost], forward: &[Cost]) -> Option<Self> {
        let known: BTreeMap<usize, f64> = forward.iter().map(|c| (c.trial, c.reduction())).collect();
        let pairs = backward.iter().filter_map(|c| Some(c.reduction() - known.get(&c.trial)?));
        let differences: Vec<f64> = pairs.collect();
        let n = differences.len() as f64;
        let mean = |of: &dyn Fn(f64) -> f64| differences.iter().map(|d| of(*d)).sum::<f64>() / n;
        (!differences.is_empty()).then(|| OrderGap {
            backward: name,
            trials: differences.len(),
            difference: mean(&|d| d),
            gap: mean(&f64::abs),
            largest: differences.iter().fold(0.0, |most, d| d.abs().max(most)),
            beyond: APART.map(|apart| 100.0 * mean(&|d| f64::from(u8::from(d.abs() > apart)))),
            gains: [mean(&|d| (-d).max(0.0)), mean(&|d| d.max(0.0))],
        })
    }
}
