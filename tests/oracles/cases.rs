//! The known answers of testdata/cases, by the library. Python and the command line run the same list.

use std::path::PathBuf;

use cdpr_core::Choice;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::geometry::Point;
use cdpr_core::plan::engine_for;
use cdpr_files::load_scene;
use serde::Deserialize;

#[derive(Deserialize)]
struct Cases {
    motion: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    scene: String,
    from: [f64; 3],
    to: [f64; 3],
    interference: Option<String>,
    valid: bool,
    kind: Option<String>,
    culprits: Option<Vec<String>>,
    at: Option<f64>,
    margin: Option<f64>,
}

#[test]
fn every_known_answer() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../testdata/cases");
    let text = std::fs::read_to_string(folder.join("cases.toml")).unwrap();
    let cases: Cases = toml::from_str(&text).unwrap();
    let mut failures = Vec::new();
    for (case, (engine, name, _)) in cases.motion.iter().flat_map(|c| Engine::ALL.iter().map(move |e| (c, *e))) {
        let interference =
            if case.interference.as_deref() == Some("swept") { Interference::Swept } else { Interference::Exact };
        let engine = engine_for(&load_scene(&folder.join(&case.scene)).unwrap(), engine, interference).unwrap();
        let (from, to) = (Point::from(case.from), Point::from(case.to));
        let found = engine.explain(&from, &to);
        let near = |expected: Option<f64>, found: Option<f64>| {
            expected.is_none_or(|e| found.is_some_and(|f| (e - f).abs() < 1e-6))
        };
        let agrees = engine.motion_valid(&from, &to) == case.valid
            && engine.motion_valid(&to, &from) == case.valid
            && found.is_none() == case.valid
            && found.as_ref().is_none_or(|v| {
                case.kind.as_deref() == serde_json::json!(v.kind).as_str()
                    && case.culprits.as_ref() == Some(&v.culprits)
                    && near(case.at, Some(v.at))
                    && near(case.margin, v.margin)
            });
        if !agrees {
            failures.push(format!("{name}, {}: {found:?}", case.name));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(cases.motion.len() >= 35);
}
