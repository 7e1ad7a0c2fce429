//! Summary of the rows of a run: statistics of each method in each scenario, and the requested comparisons.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::experiment::{Layout, Swept};
use super::run::{Row, TrialStatus};
use super::statistics::{Moments, quantile, t_test};
use crate::experiment_spec::Measure;
use cdpr_core::planning::Status;

/// Quantiles of every summary, besides median, minimum and maximum.
const QUANTILES: [(&str, f64); 4] = [("q05", 0.05), ("q25", 0.25), ("q75", 0.75), ("q95", 0.95)];

/// Gathers rows, one method of one scenario after the other.
#[derive(Debug, Default)]
pub struct Summary {
    methods: Vec<Value>,
    moments: BTreeMap<(String, String, &'static str), Moments>,
}

/// The numbers of the solved trials of a method, by name.
type Samples = [(&'static str, Vec<f64>); 6];

impl Summary {
    /// Adds all rows of a method in a scenario. Unsolved trials are counted but left out of the statistics.
    pub fn add(
        &mut self,
        (scenario, method): (&str, &str),
        sweep: Option<&Swept>,
        rows: impl Iterator<Item = Row>,
        confidence: f64,
    ) {
        let mut statuses: BTreeMap<&'static str, usize> = BTreeMap::new();
        let mut samples: Samples =
            ["planning_seconds", "post_seconds", "raw_cost", "cost", "reduction", "waypoints"].map(|m| (m, Vec::new()));
        for row in rows {
            *statuses.entry(row.status.name()).or_default() += 1;
            let reduction =
                row.raw_cost.zip(row.cost).map(|(raw, cost)| if raw > 0.0 { 1.0 - cost / raw } else { 0.0 });
            let waypoints = row.waypoints.map(|count| count as f64);
            let numbers = [row.planning_seconds, row.post_seconds, row.raw_cost, row.cost, reduction, waypoints];
            if row.status == TrialStatus::Ended(Status::Solved) {
                samples.iter_mut().zip(numbers).for_each(|((_, sample), number)| sample.extend(number));
            }
        }
        let (n, solved) = (statuses.values().sum::<usize>(), statuses.get("solved").copied().unwrap_or(0));
        let mut entry = Map::new();
        entry.insert("scenario".into(), json!(scenario));
        entry.insert("method".into(), json!(method));
        if let Some(sweep) = sweep {
            entry.insert("sweep".into(), json!(sweep));
        }
        entry.insert("n".into(), json!(n));
        entry.insert("solved".into(), json!(solved));
        entry.insert("statuses".into(), json!(statuses));
        for (measure, sample) in &mut samples {
            let moments = Moments::of(sample);
            entry.insert((*measure).into(), described(sample, &moments, confidence));
            self.moments.insert((scenario.into(), method.into(), measure), moments);
        }
        self.methods.push(Value::Object(entry));
    }

    /// The whole summary as JSON; undefined numbers are null.
    pub fn json(&self, layout: &Layout, experiment: &str, fingerprint: &str) -> Value {
        let tests: Vec<Value> = layout.t_tests.iter().map(|test| self.tested(test)).collect();
        json!({
            "version": 1,
            "experiment": experiment,
            "fingerprint": fingerprint,
            "confidence": layout.confidence,
            "methods": self.methods,
            "t_tests": tests,
        })
    }

    fn tested(&self, spec: &crate::experiment_spec::TTestSpec) -> Value {
        let none = Moments { n: 0, mean: f64::NAN, variance: f64::NAN };
        let of = |[scenario, method]: &[String; 2]| {
            let key = (scenario.clone(), method.clone(), measure_name(spec.measure));
            self.moments.get(&key).copied().unwrap_or(none)
        };
        let test = t_test(&of(&spec.a), &of(&spec.b), spec.variances);
        json!({
            "group": spec.group, "measure": spec.measure, "a": spec.a, "b": spec.b, "variances": spec.variances,
            "t": finite(test.t), "df": finite(test.df), "p": finite(test.p),
        })
    }
}

fn described(sample: &mut [f64], moments: &Moments, confidence: f64) -> Value {
    sample.sort_unstable_by(f64::total_cmp);
    let interval = moments.confidence_interval(confidence).map(finite);
    let mut entry = Map::new();
    entry.insert("mean".into(), json!(finite(moments.mean)));
    entry.insert("sd".into(), json!(finite(moments.sd())));
    entry.insert("confidence_interval".into(), json!(interval));
    entry.insert("median".into(), json!(finite(quantile(sample, 0.5))));
    entry.insert("min".into(), json!(finite(quantile(sample, 0.0))));
    for (name, p) in QUANTILES {
        entry.insert(name.into(), json!(finite(quantile(sample, p))));
    }
    entry.insert("max".into(), json!(finite(quantile(sample, 1.0))));
    Value::Object(entry)
}

fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}

fn measure_name(measure: Measure) -> &'static str {
    match measure {
        Measure::PlanningSeconds => "planning_seconds",
        Measure::PostSeconds => "post_seconds",
        Measure::RawCost => "raw_cost",
        Measure::Cost => "cost",
    }
}
