//! Scenes of existing robots: the shortest path around the obstacles leaves the wrench-feasible positions, the planned
//! path does not.

use std::path::Path;

use cdpr_core::collision::{Engine, Interference, Kind, check_path};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::Point;
use cdpr_core::model::Scene;
use cdpr_core::plan::{PlanOptions, PlanResult, plan};
use cdpr_core::planning::Status;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{Measure, measures};

const SEEDS: std::ops::Range<u64> = 0..5;

fn load(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/scenes").join(name).with_extension("toml");
    cdpr_files::load_scene(&path).expect("a sound scene")
}

fn planned(scene: &Scene, seed: u64) -> PlanResult {
    plan(scene, &PlanOptions { seed, ..PlanOptions::paper() }, &|| false).expect("a well-posed question").result
}

/// The smallest slack at 1001 points of each segment.
fn least_slack(measures: &[Measure], path: &[Point]) -> f64 {
    let points = path.windows(2).flat_map(|s| (0..=1000).map(|k| s[0] + (s[1] - s[0]) * (f64::from(k) / 1000.0)));
    points.flat_map(|p| measures.iter().map(move |m| m.slack(&p))).fold(f64::INFINITY, f64::min)
}

/// Plans with and without [wrench]; every path planned without it lacks `share` of the required force somewhere.
fn detour(name: &str, share: f64) {
    let scene = load(name);
    let wrench = scene.wrench().expect("a demand");
    let missing = -share * wrench.force.expect("a force ball");
    let measures = measures(&scene).unwrap();
    let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).unwrap();
    let mut spec = scene.spec().clone();
    spec.wrench = None;
    let geometry = Scene::new(spec).unwrap();
    for seed in SEEDS {
        let result = planned(&scene, seed);
        assert_eq!(result.status, Status::Solved, "{name}, seed {seed}");
        assert!(check_path(&*engine, &result.waypoints(), &Watch::NONE).unwrap().valid, "{name}, seed {seed}");
        let slack = least_slack(&measures, &result.waypoints());
        assert!(slack >= 0.0, "{name}, seed {seed}: {slack}");

        let shortest = planned(&geometry, seed);
        assert_eq!(shortest.status, Status::Solved, "{name}, seed {seed}");
        let slack = least_slack(&measures, &shortest.waypoints());
        assert!(slack < missing, "{name}, seed {seed}: {slack}");
        let report = check_path(&*engine, &shortest.waypoints(), &Watch::NONE).unwrap();
        assert!(!report.violations.is_empty(), "{name}, seed {seed}");
        assert!(report.violations.iter().all(|v| v.violation.kind == Kind::Wrench), "{name}, seed {seed}");
    }
}

#[test]
fn cogiro_stays_low_enough_below_its_outlets() {
    detour("cogiro", 0.05);
}

#[test]
fn ipanema2_goes_round_a_column_instead_of_over_it() {
    detour("ipanema2", 0.05);
}

#[test]
fn caroca_stays_low_enough_below_its_outlets() {
    detour("caroca", 0.05);
}

#[test]
fn acrobot_does_not_climb_above_its_outlets() {
    detour("acrobot", 0.05);
}

#[test]
fn the_simulator_passes_a_column_on_the_side_away_from_the_wall() {
    detour("mpi_simulator", 0.05);
}
