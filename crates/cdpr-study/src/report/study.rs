//! The data of a report on a finished run: `summary.json` and the costs in `trials.csv`.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::experiment_spec::Measure;
use crate::{Origin, Rules, Swept};

/// The contents of `summary.json` and `trials.csv`.
#[derive(Debug, Clone)]
pub struct Study {
    /// `summary.json`
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

/// `summary.json`
#[derive(Debug, Clone, Deserialize)]
pub struct SummaryFile {
    /// Name of the experiment.
    pub experiment: String,
    /// Its fingerprint.
    pub fingerprint: String,
    /// Level of confidence intervals.
    pub confidence: f64,
    /// Statistics of each method in each scenario.
    pub methods: Vec<MethodSummary>,
    /// Comparisons.
    pub t_tests: Vec<TestSummary>,
    /// How the methods plan; empty in files from before 0.2.
    #[serde(default)]
    pub rules: Vec<Rules>,
    /// The programs and machines that ran the trials.
    #[serde(default)]
    pub origins: Vec<Origin>,
}

/// Statistics of a method in a scenario.
#[derive(Debug, Clone, Deserialize)]
pub struct MethodSummary {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the method.
    pub method: String,
    /// Its place in its sweep.
    pub sweep: Option<Swept>,
    /// Trials.
    pub n: usize,
    /// Solved trials.
    pub solved: usize,
    /// Time of the planner, s.
    pub planning_seconds: Described,
    /// Time of rewinding, s.
    pub post_seconds: Described,
    /// Length of the planner's path, m.
    pub raw_cost: Described,
    /// Length of the final path, m.
    pub cost: Described,
    /// Reduction of the path's length by post-processing, relative to the raw length.
    pub reduction: Described,
    /// Waypoints of the final path.
    pub waypoints: Described,
}

impl MethodSummary {
    /// The statistics of a measure.
    pub(super) fn of(&self, measure: Measure) -> &Described {
        match measure {
            Measure::PlanningSeconds => &self.planning_seconds,
            Measure::PostSeconds => &self.post_seconds,
            Measure::RawCost => &self.raw_cost,
            Measure::Cost => &self.cost,
        }
    }
}

/// Statistics of one measure; `None` if there are too few numbers.
#[derive(Debug, Clone, Deserialize)]
#[allow(missing_docs)] // named as in the file
pub struct Described {
    pub mean: Option<f64>,
    pub sd: Option<f64>,
    pub confidence_interval: [Option<f64>; 2],
    pub median: Option<f64>,
    pub min: Option<f64>,
    pub q05: Option<f64>,
    pub q25: Option<f64>,
    pub q75: Option<f64>,
    pub q95: Option<f64>,
    pub max: Option<f64>,
}

/// A comparison and its result.
#[derive(Debug, Clone, Deserialize)]
pub struct TestSummary {
    /// Its letter.
    pub group: String,
    /// The compared measure.
    pub measure: Measure,
    /// Scenario and method.
    pub a: [String; 2],
    /// Scenario and method.
    pub b: [String; 2],
    /// The statistic.
    pub t: Option<f64>,
    /// Degrees of freedom.
    pub df: Option<f64>,
    /// Probability.
    pub p: Option<f64>,
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
    /// Shares of trials in which they differ by more than 0.01, 1 and 5 points, %.
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
