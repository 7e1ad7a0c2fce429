//! Plans scenes with and without their [wrench] over many seeds; prints lengths, times, and how far the paths fall
//! short of the requirement, measured by the capacity margin.
//!
//! `cargo run --release -p cdpr-tests --example wrench_study -- 51 testdata/scenes/cogiro.toml ...`

use cdpr_core::geometry::Point;
use cdpr_core::model::{MarginSpec, Scene};
use cdpr_core::plan::{PlanOptions, PlanResult, plan};
use cdpr_core::planning::Status;
use cdpr_core::wrench::{Measure, measures};
use cdpr_files::load_scene;

fn main() -> Result<(), cdpr_core::Error> {
    let mut arguments = std::env::args().skip(1);
    let seeds: u64 = arguments.next().and_then(|n| n.parse().ok()).expect("first argument: how many seeds");
    for file in arguments {
        let scene = load_scene(&file)?;
        let mut spec = scene.spec().clone();
        // The paths are judged by the capacity margin, whatever rule a scene uses for planning.
        spec.wrench.as_mut().expect("a scene with [wrench]").margin = Some(MarginSpec::Capacity);
        let measures = measures(&Scene::new(spec.clone())?)?;
        spec.wrench = None;
        println!("{}", scene.name());
        report("with", &scene, &measures, seeds)?;
        report("without", &Scene::new(spec)?, &measures, seeds)?;
    }
    Ok(())
}

/// Plans a scene with seeds from 0 and prints a line about it.
fn report(name: &str, scene: &Scene, measures: &[Measure], seeds: u64) -> Result<(), cdpr_core::Error> {
    let run = |seed| plan(scene, &PlanOptions { seed, ..PlanOptions::paper() }, &()).map(|planned| planned.result);
    let results: Vec<PlanResult> = (0..seeds).map(run).collect::<Result<_, _>>()?;
    if let Some(reason) = results.iter().find_map(|r| r.reason()) {
        println!("  {name} [wrench]: {}", reason.sentence());
    }
    let solved: Vec<&PlanResult> = results.iter().filter(|r| r.status == Status::Solved).collect();
    let mean = |value: &dyn Fn(&PlanResult) -> f64| solved.iter().map(|r| value(r)).sum::<f64>() / solved.len() as f64;
    let most = |value: &dyn Fn(&PlanResult) -> f64| solved.iter().map(|r| value(r)).fold(f64::NEG_INFINITY, f64::max);
    let mut least: Vec<f64> = solved.iter().map(|r| least_slack(measures, &r.waypoints())).collect();
    least.sort_by(f64::total_cmp);
    println!(
        "  {name} [wrench]: {}/{seeds} solved, {:.3} m, {:.0} motion checks, planning {:.3} ms (at most {:.3}), \
         rewinding {:.3} ms, {} paths break the demand",
        solved.len(),
        mean(&|r| r.cost),
        mean(&|r| r.stats.motion_checks as f64),
        mean(&|r| r.stats.planning_seconds * 1e3),
        most(&|r| r.stats.planning_seconds * 1e3),
        mean(&|r| r.stats.post_seconds * 1e3),
        least.iter().filter(|slack| **slack < 0.0).count(),
    );
    if let (Some(first), Some(last)) = (least.first(), least.last()) {
        println!("      least slack along a path: {first:.2}, median {:.2}, {last:.2} N", least[least.len() / 2]);
    }
    Ok(())
}

/// The smallest slack at 1001 points of each segment.
fn least_slack(measures: &[Measure], path: &[Point]) -> f64 {
    let points = path.windows(2).flat_map(|s| (0..=1000).map(|k| s[0] + (s[1] - s[0]) * (f64::from(k) / 1000.0)));
    points.flat_map(|p| measures.iter().map(move |m| m.slack(&p))).fold(f64::INFINITY, f64::min)
}
