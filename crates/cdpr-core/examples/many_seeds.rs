//! Plans hard1 and hard3 over many seeds and prints mean costs, motion checks and times.
//!
//! `cargo run --release -p cdpr-core --example many_seeds -- [seeds]`

use cdpr_core::plan::{PlanOptions, PlanResult, plan};
use cdpr_core::testing;

fn main() -> Result<(), cdpr_core::Error> {
    let seeds: u64 = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(1000);
    for scene in [testing::hard1(), testing::hard3()] {
        let run = |seed| plan(&scene, &PlanOptions { seed, ..PlanOptions::default() }, &|| false);
        let results: Vec<PlanResult> = (0..seeds).map(run).collect::<Result<_, _>>()?;
        let mean = |value: &dyn Fn(&PlanResult) -> f64| results.iter().map(value).sum::<f64>() / seeds as f64;
        println!(
            "{}: raw {:.3} m, final {:.3} m, {:.0} motion checks, planning {:.3} ms, rewinding {:.3} ms",
            scene.name(),
            mean(&|r| r.raw_cost),
            mean(&|r| r.cost),
            mean(&|r| r.stats.motion_checks as f64),
            mean(&|r| r.stats.planning_seconds * 1e3),
            mean(&|r| r.stats.post_seconds * 1e3),
        );
    }
    Ok(())
}
