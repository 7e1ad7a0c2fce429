//! The gap that is proved between the best known path and a bound, in scenes that require wrenches, and its certificate.
//!
//! `cargo run --release -p cdpr-tests --example wrench_gaps -- 0.05 cogiro` (gap, names of scenes)

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use cdpr_core::compiled::CompiledScene;
use cdpr_core::limits::BOUND_EFFORT;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions};
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene};
use cdpr_files::load_scene;

/// Time in which the best path is sought.
const PLANNING: Duration = Duration::from_secs(2);

fn main() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [gap, scenes @ ..] = &args[..] else { panic!("a gap, and names of scenes") };
    let gap: f64 = gap.parse().expect("a gap");
    for name in scenes {
        let scene = load_scene(Path::new(&format!("testdata/scenes/{name}.toml")))?;
        let compiled = Arc::new(CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?);
        let cost = shortest(&scene, &compiled)?;
        let [start, goal] = Query::of(&scene).ends()?;
        let clock = Instant::now();
        let forbidden = Forbidden::new(compiled.level(), [&start, &goal], &Watch::NONE)?;
        let bound = forbidden.prove(cost / (1.0 + gap), BOUND_EFFORT, &|_, _| false, &Watch::NONE)?.length;
        let percent = |length: f64| 100.0 * (cost / length - 1.0);
        println!("{name}: path {cost:.4} m, bound {bound:.4} m: {:.3} % in {}", percent(bound), seconds(&clock));
        let clock = Instant::now();
        let Some(certificate) = forbidden.certificate(&scene, bound, BOUND_EFFORT, &Watch::NONE)? else {
            println!("  no certificate");
            continue;
        };
        let written = seconds(&clock);
        let text = serde_json::to_string(&certificate).expect("a certificate is JSON");
        let boxes: usize = certificate.regions.iter().map(|region| region.boxes.len()).sum();
        let weak = certificate.regions.iter().filter(|region| !region.boxes.is_empty()).count();
        let clock = Instant::now();
        let answer = match cdpr_certify::check_bound(&scene, &text, &Watch::NONE) {
            Ok(_) => "accepted".to_string(),
            Err(error) => error.to_string(),
        };
        println!(
            "  certificate of {:.3} % in {written}: {} kB, {} regions, {weak} of wrenches with {boxes} boxes; {answer} in {}",
            percent(certificate.length),
            text.len() / 1000,
            certificate.regions.len(),
            seconds(&clock)
        );
    }
    Ok(())
}

fn seconds(since: &Instant) -> String {
    format!("{:.2} s", since.elapsed().as_secs_f64())
}

/// The length of the best path of three seeds and of `anytime`, m.
fn shortest(scene: &Scene, compiled: &Arc<CompiledScene>) -> Result<f64, Error> {
    let seeded = (0..3).map(|seed| (Planner::ModifiedRrt, seed, None));
    let mut cost = f64::INFINITY;
    for (planner, seed, budget) in seeded.chain([(Planner::Anytime, 0, Some(PLANNING))]) {
        let options = PlanOptions { seed, budget, planner: PlannerOptions::of(planner), ..PlanOptions::default() };
        cost = cost.min(plan(Query::of(scene).by(compiled), &options, &())?.result.cost);
    }
    Ok(cost)
}
