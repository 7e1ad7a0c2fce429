//! `summary.json`: statistics of each method in each scenario, and the requested comparisons.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::experiment::{Layout, Rules, Swept};
use super::origin::Origin;
use super::run::{Row, TrialRow, TrialStatus};
use super::statistics::{Comparison, Moments, paired_t_test, quantile, t_test};
use crate::experiment_spec::{Measure, TTestSpec};
use cdpr_core::Choice;
use cdpr_core::model::spec::FORMAT_VERSION;
use cdpr_core::planning::Status;

/// Contents of `summary.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SummaryFile {
    /// Version of the format, 1.
    #[serde(default)]
    pub version: u32,
    /// Name of the experiment.
    pub experiment: String,
    /// Fingerprint of the experiment.
    pub fingerprint: String,
    /// Level of confidence intervals.
    pub confidence: f64,
    /// Statistics of each method in each scenario.
    pub methods: Vec<MethodSummary>,
    /// Requested comparisons of two methods.
    pub t_tests: Vec<TestSummary>,
    /// The lengths of each method beside those of the first one of its scenario.
    #[serde(default)]
    pub pairs: Vec<PairSummary>,
    /// How the methods plan; empty in files from before 0.2.
    #[serde(default)]
    pub rules: Vec<Rules>,
    /// The programs and machines that ran the trials.
    #[serde(default)]
    pub origins: Vec<Origin>,
    /// Names of the scenarios whose platform may turn, so that lengths include its turns.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub turning: Vec<String>,
    /// Names of the scenarios whose trials have random scenes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub random: Vec<String>,
}

/// Statistics of a method in a scenario, over its solved trials.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodSummary {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the method.
    pub method: String,
    /// Place of the method in its sweep, if it is swept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sweep: Option<Swept>,
    /// Number of trials.
    pub n: usize,
    /// Number of solved trials.
    pub solved: usize,
    /// Number of trials by status.
    #[serde(default)]
    pub statuses: BTreeMap<String, usize>,
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
    /// Motions checked by the planner.
    #[serde(default)]
    pub motion_checks: Described,
    /// Time to compile a scene for the engine, s, once for each thread and scene.
    #[serde(default)]
    pub compile_seconds: Described,
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
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
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

/// A t-test and its result; `None` where it is undefined.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TestSummary {
    /// Letter of the group of comparisons.
    pub group: String,
    /// The measure that was compared.
    pub measure: Measure,
    /// Scenario and method of the first sample.
    pub a: [String; 2],
    /// Scenario and method of the second sample.
    pub b: [String; 2],
    /// How the test treats the variances.
    #[serde(default)]
    pub variances: Comparison,
    /// Statistic of the test.
    pub t: Option<f64>,
    /// Degrees of freedom.
    pub df: Option<f64>,
    /// Probability of a statistic at least as far from 0 if the means are equal.
    pub p: Option<f64>,
    /// The comparison trial by trial, if both methods are in one scenario.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub paired: Option<Paired>,
}

/// Two methods in the trials of a scenario that both have solved: trials of the same number have the same scene.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Paired {
    /// Number of trials that both methods have solved.
    pub n: usize,
    /// Number of trials in which the value of a is smaller.
    pub a_less: usize,
    /// Number of trials in which the value of b is smaller.
    pub b_less: usize,
    /// Mean of the value of a minus that of b.
    pub mean_difference: Option<f64>,
    /// The statistic of the paired t-test.
    pub t: Option<f64>,
    /// Degrees of freedom.
    pub df: Option<f64>,
    /// Probability of a statistic at least as far from 0 if the means are equal.
    pub p: Option<f64>,
}

/// The lengths of two methods in a scenario, trial by trial.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PairSummary {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the first method.
    pub a: String,
    /// Name of the other method.
    pub b: String,
    /// Comparison of the lengths.
    pub cost: Paired,
}

/// Values of the solved trials, each with the number of its trial, in increasing order.
type Sample = Vec<(usize, f64)>;

/// Gathers rows, one method of one scenario after another.
#[derive(Debug, Default)]
pub struct Summary {
    methods: Vec<MethodSummary>,
    samples: BTreeMap<(String, String, Measure), Sample>,
}

impl Summary {
    /// Adds all rows of a method in a scenario. Unsolved trials are counted but left out of the statistics.
    pub fn add(
        &mut self,
        (scenario, method): (&str, &str),
        sweep: Option<&Swept>,
        rows: impl Iterator<Item = Row>,
        confidence: f64,
    ) {
        let mut statuses: BTreeMap<String, usize> = BTreeMap::new();
        let mut gathered: [Sample; 8] = Default::default();
        for row in rows {
            *statuses.entry(row.result.status.name().to_string()).or_default() += 1;
            if row.result.status == TrialStatus::Ended(Status::Solved) {
                let trial = row.result.trial;
                let known = numbers(&row).map(|number| number.map(|number| (trial, number)));
                gathered.iter_mut().zip(known).for_each(|(sample, number)| sample.extend(number));
            }
        }
        gathered.iter_mut().for_each(|sample| sample.sort_unstable_by_key(|(trial, _)| *trial));
        let mut samples = gathered.each_ref().map(values);
        let moments = samples.each_ref().map(|sample| Moments::of(sample));
        let tested = [Measure::PlanningSeconds, Measure::PostSeconds, Measure::RawCost, Measure::Cost];
        for (measure, sample) in tested.into_iter().zip(gathered) {
            self.samples.insert((scenario.into(), method.into(), measure), sample);
        }
        let described = |k: usize| Described::of(&mut samples[k], &moments[k], confidence);
        let [planning_seconds, post_seconds, raw_cost, cost, reduction, waypoints, motion_checks, compile_seconds] =
            std::array::from_fn(described);
        self.methods.push(MethodSummary {
            scenario: scenario.into(),
            method: method.into(),
            sweep: sweep.cloned(),
            n: statuses.values().sum(),
            solved: statuses.get(Status::Solved.name()).copied().unwrap_or(0),
            statuses,
            planning_seconds,
            post_seconds,
            raw_cost,
            cost,
            reduction,
            waypoints,
            motion_checks,
            compile_seconds,
        });
    }

    /// The whole summary, without rules, origins and the names of random scenarios.
    pub fn file(self, layout: &Layout, experiment: &str, fingerprint: &str) -> SummaryFile {
        let mut turning: Vec<_> = layout.groups.iter().filter(|g| g.turns).map(|g| g.scenario.clone()).collect();
        turning.dedup(); // the groups of a scenario are neighbours
        SummaryFile {
            version: FORMAT_VERSION,
            experiment: experiment.to_string(),
            fingerprint: fingerprint.to_string(),
            confidence: layout.confidence,
            t_tests: layout.t_tests.iter().map(|test| self.tested(test)).collect(),
            pairs: self.pairs(),
            methods: self.methods,
            rules: Vec::new(),
            origins: Vec::new(),
            turning,
            random: Vec::new(),
        }
    }

    fn tested(&self, spec: &TTestSpec) -> TestSummary {
        let of = |side: &[String; 2]| self.sample(side, spec.measure);
        let moments = |side| Moments::of(&values(of(side)));
        let test = t_test(&moments(&spec.a), &moments(&spec.b), spec.variances);
        let TTestSpec { group, measure, a, b, variances } = spec.clone();
        let paired = (a[0] == b[0]).then(|| Paired::of(of(&a), of(&b)));
        TestSummary {
            group,
            measure,
            a,
            b,
            variances,
            t: finite(test.t),
            df: finite(test.df),
            p: finite(test.p),
            paired,
        }
    }

    fn sample(&self, [scenario, method]: &[String; 2], measure: Measure) -> &[(usize, f64)] {
        self.samples.get(&(scenario.clone(), method.clone(), measure)).map_or(&[], Vec::as_slice)
    }

    fn pairs(&self) -> Vec<PairSummary> {
        let mut first: BTreeMap<&str, &str> = BTreeMap::new();
        let mut pairs = Vec::new();
        for MethodSummary { scenario, method, .. } in &self.methods {
            let a = *first.entry(scenario).or_insert(method);
            if a != method {
                let of = |name: &str| self.sample(&[scenario.clone(), name.to_string()], Measure::Cost);
                let cost = Paired::of(of(a), of(method));
                pairs.push(PairSummary { scenario: scenario.clone(), a: a.into(), b: method.clone(), cost });
            }
        }
        pairs
    }
}

fn values(sample: impl AsRef<[(usize, f64)]>) -> Vec<f64> {
    sample.as_ref().iter().map(|(_, value)| *value).collect()
}

/// Numbers that differ by less than this share are equal up to rounding.
const SAME: f64 = 1e-9;

impl Paired {
    /// Compares the trials that are in both samples.
    fn of(a: &[(usize, f64)], b: &[(usize, f64)]) -> Self {
        let other = |trial: &usize| b.binary_search_by_key(trial, |(trial, _)| *trial).ok().map(|k| b[k].1);
        let pairs: Vec<(f64, f64)> = a.iter().filter_map(|(trial, value)| Some((*value, other(trial)?))).collect();
        let less = |(x, y): (f64, f64)| x < y - SAME * y.abs();
        let differences: Vec<f64> = pairs.iter().map(|(a, b)| a - b).collect();
        let moments = Moments::of(&differences);
        let test = paired_t_test(&moments);
        Paired {
            n: pairs.len(),
            a_less: pairs.iter().filter(|(a, b)| less((*a, *b))).count(),
            b_less: pairs.iter().filter(|(a, b)| less((*b, *a))).count(),
            mean_difference: finite(moments.mean),
            t: finite(test.t),
            df: finite(test.df),
            p: finite(test.p),
        }
    }
}

/// The numbers of a row in the order of [`MethodSummary`].
fn numbers(Row { result, planning_seconds, post_seconds, compile_seconds, .. }: &Row) -> [Option<f64>; 8] {
    let TrialRow { raw_cost, cost, waypoints, motion_checks, .. } = result;
    let reduced = |(raw, cost): (f64, f64)| if raw > 0.0 { 1.0 - cost / raw } else { 0.0 };
    let reduction = raw_cost.zip(*cost).map(reduced);
    let [waypoints, motion_checks] = [waypoints, motion_checks].map(|count| count.map(|count| count as f64));
    [*planning_seconds, *post_seconds, *raw_cost, *cost, reduction, waypoints, motion_checks, *compile_seconds]
}

impl Described {
    fn of(sample: &mut [f64], moments: &Moments, confidence: f64) -> Self {
        sample.sort_unstable_by(f64::total_cmp);
        let at = |p: f64| finite(quantile(sample, p));
        Described {
            mean: finite(moments.mean),
            sd: finite(moments.sd()),
            confidence_interval: moments.confidence_interval(confidence).map(finite),
            median: at(0.5),
            min: at(0.0),
            q05: at(0.05),
            q25: at(0.25),
            q75: at(0.75),
            q95: at(0.95),
            max: at(1.0),
        }
    }
}

fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}
