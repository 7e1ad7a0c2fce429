//! The numbers printed in the paper, from `paper.toml` beside this file.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

use crate::experiment_spec::Measure;

/// The numbers of the paper.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Paper {
    pub citation: String,
    experiments: Vec<Printed>,
}

/// The paper's numbers for one experiment.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Printed {
    /// Names of the experiments that repeat the paper's experiment.
    names: Vec<String>,
    pub note: String,
    #[serde(default)]
    pub means: Vec<Means>,
    #[serde(default)]
    pub p_values: BTreeMap<String, String>,
    #[serde(default)]
    pub claims: Vec<Claim>,
    /// Average difference between the two orders of rewinding, percentage points.
    pub order_gap: Option<f64>,
}

/// Mean and standard deviation of a method in a scenario.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Means {
    pub of: [String; 2],
    pub planning_seconds: Option<[f64; 2]>,
    pub post_seconds: Option<[f64; 2]>,
    pub cost: Option<[f64; 2]>,
}

/// A ratio of two means.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Claim {
    pub says: String,
    pub measure: Measure,
    pub a: [String; 2],
    pub b: [String; 2],
    #[serde(default)]
    pub less: bool,
    pub percent: f64,
}

static PAPER: LazyLock<Paper> =
    LazyLock::new(|| toml::from_str(include_str!("paper.toml")).expect("checked by a test"));

/// The paper's numbers for the experiment with this name.
pub(super) fn printed(experiment: &str) -> Option<(&'static Paper, &'static Printed)> {
    let paper = &*PAPER;
    paper
        .experiments
        .iter()
        .find(|printed| printed.names.iter().any(|name| name == experiment))
        .map(|printed| (paper, printed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentages_of_section_5_3_follow_from_table_2() {
        let (_, table2) = printed("table2").unwrap();
        let mean = |measure: Measure, of: &[String; 2]| {
            let cell = table2.means.iter().find(|cell| cell.of == *of).expect("a cell of the table");
            let number = if measure == Measure::Cost { cell.cost } else { cell.planning_seconds };
            number.expect("printed")[0]
        };
        assert_eq!((table2.means.len(), table2.claims.len(), table2.p_values.len()), (8, 8, 18));
        for claim in &table2.claims {
            let share = mean(claim.measure, &claim.a) / mean(claim.measure, &claim.b);
            let percent = 100.0 * if claim.less { 1.0 - share } else { share };
            assert!((percent - claim.percent).abs() < 0.02, "{}: {percent}", claim.says); // the table is rounded
        }
        assert!(std::ptr::eq(printed("table2_paper").unwrap().1, table2));
        assert!(printed("another").is_none() && printed("fig8").unwrap().1.order_gap == Some(0.66));
    }
}
