//! The gap that is proved between the best known path and a bound, in scenes that require wrenches.
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
        let (cost, bound, seconds) = proved(&scene, gap)?;
        println!(
            "{name}: path {cost:.4} m, bound {bound:.4} m: {:.3} % in {seconds:.2} s",
            100.0 * (cost / bound - 1.0)
        );
    }
    Ok(())
}

/// The length of the best path of three seeds and of `anytime`, the largest bound up to the wanted one, m, and the time of its proof, s.
fn proved(scene: &Scene, gap: f64) -> Result<(f64, f64, f64), Error> {
    let compiled = Arc::new(CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE)?);
    let seeded = (0..3).map(|seed| (Planner::ModifiedRrt, seed, None));
    let mut cost = f64::INFINITY;
    for (planner, seed, budget) in seeded.chain([(Planner::Anytime, 0, Some(PLANNING))]) {
        let options = PlanOptions { seed, budget, planner: PlannerOptions::of(planner), ..PlanOptions::default() };
        cost = cost.min(plan(Query::of(scene).by(&compiled), &options, &())?.result.cost);
    }
    let [start, goal] = Query::of(scene).ends()?;
    let clock = Instant::now();
    let forbidden = Forbidden::new(compiled.level(), [&start, &goal], &Watch::NONE)?;
    let bound = forbidden.prove(cost / (1.0 + gap), BOUND_EFFORT, &|_, _| false, &Watch::NONE)?.length;
    Ok((cost, bound, clock.elapsed().as_secs_f64()))
}
