//! The known answers of `testdata/cases`, by the command line. The library and Python run the same list.

use std::path::Path;

use crate::support::*;
use cdpr_tests::cases::{Cases, PlanCase, scene_file};
use serde_json::Value;

#[test]
fn motions() {
    for (case, engine) in each_engine(&Cases::load().motion) {
        let rule = case.interference.as_deref().unwrap_or("exact");
        let (answer, report) =
            checked(&case.scene, &[case.from, case.to], &["--engine", engine, "--interference", rule]);
        assert_eq!(answer, i32::from(case.violation.is_some()), "{}", case.name);
        assert!(case.agrees(&report["violations"][0]), "{}: {report:#}", case.name);
    }
}

#[test]
fn plans() {
    for case in Cases::load().plan {
        let found = cdpr(&arguments(&case).iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(status(&found), i32::from(case.status != "solved"), "{}: {}", case.name, stderr(&found));
        assert!(case.agrees(&json(&found)), "{}: {:#}", case.name, json(&found));
    }
}

fn arguments(case: &PlanCase) -> Vec<String> {
    let mut arguments = vec!["plan".to_string(), scene(&case.scene), "--format=json".to_string()];
    arguments.push(format!("--seed={}", case.seed));
    arguments.extend(case.planner.iter().map(|planner| format!("--planner={planner}")));
    arguments.extend(case.max_samples.iter().map(|samples| format!("--max-samples={samples}")));
    for (option, end) in [("--start", case.start), ("--goal", case.goal)] {
        if let Some(point) = end {
            arguments.push(option.to_string());
            arguments.extend(point.map(|coordinate| coordinate.to_string()));
        }
    }
    arguments
}

#[test]
fn checks() {
    for (case, engine) in each_engine(&Cases::load().check) {
        let (answer, report) = checked(&case.scene, &case.waypoints, &["--engine", engine]);
        assert_eq!(answer, i32::from(case.violation.is_some()), "{}", case.name);
        assert!(case.agrees(&report), "{}: {report:#}", case.name);
    }
}

#[test]
fn wrenches() {
    for case in Cases::load().wrench {
        let [x, y, z] = case.position.map(|coordinate| coordinate.to_string());
        let force = case.force.map(|force| format!("--force={force}"));
        let scene = scene(&case.scene);
        let mut arguments = vec!["wrench", &scene, "--format", "json", "--at", &x, &y, &z];
        arguments.extend(force.as_deref());
        let found = cdpr(&arguments);
        assert_eq!(status(&found), i32::from(!case.feasible), "{}: {}", case.name, stderr(&found));
        assert!(case.agrees(&json(&found)), "{}: {:#}", case.name, json(&found));
    }
}

fn scene(name: &str) -> String {
    scene_file(name).display().to_string()
}

fn each_engine<T>(cases: &[T]) -> impl Iterator<Item = (&T, &'static str)> {
    cases.iter().flat_map(|case| ["cspace", "gjk"].map(|engine| (case, engine)))
}

/// Exit status and report of `cdpr check` on some waypoints.
fn checked(name: &str, waypoints: &[[f64; 3]], options: &[&str]) -> (i32, Value) {
    let rows: String = waypoints.iter().map(|[x, y, z]| format!("{x},{y},{z}\n")).collect();
    let scene = scene(name);
    let arguments = [&["check", &scene, "-", "--format", "json"], options].concat();
    let found = cdpr_fed(Path::new("."), &arguments, &format!("x,y,z\n{rows}"));
    (status(&found), json(&found))
}
