//! The gap that is proved between the best path and a bound in scenes that require wrenches.
//!
//! `cargo run --release -p cdpr-tests --example wrench_gaps -- 0.01 cogiro caroca` (gap, names of scenes)
use cdpr_core::Error;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::limits::BOUND_EFFORT;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions};
use cdpr_core::watch::Watch;
use std::sync::Arc;
use std::time::Instant;

fn main() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let gap: f64 = args[0].parse().unwrap();
    for file in &args[1..] {
        let scene = cdpr_files::load_scene(std::path::Path::new(&format!("testdata/scenes/{file}.toml")))?;
        let compiled = Arc::new(CompiledScene::new(&scene, Engine::default(), Interference::Exact, &Watch::NONE)?);
        let engine = compiled.level();
        let mut best: Option<cdpr_core::plan::PlanResult> = None;
        for seed in 0..4 {
            let planner = if seed < 3 { Planner::ModifiedRrt } else { Planner::Anytime };
            let budget = (seed == 3).then(|| std::time::Duration::from_secs(2));
            let options = PlanOptions { seed, budget, planner: PlannerOptions::of(planner), ..PlanOptions::default() };
            let r = plan(Query::of(&scene).by(&compiled), &options, &())?.result;
            if best.as_ref().is_none_or(|b| r.cost < b.cost) {
                best = Some(r)
            }
        }
        let best = best.unwrap();
        let cost = best.cost;
        let path: Vec<[f64; 3]> = best.path.iter().map(|p| p.position.into()).collect();
        println!(
            "{file}: cost {cost:.4} straight {:.4} path {path:.3?}",
            (scene.goal().unwrap() - scene.start().unwrap()).norm()
        );
        let [start, goal] = [scene.start().unwrap(), scene.goal().unwrap()];
        let clock = Instant::now();
        let forbidden = Forbidden::new(engine, [&start, &goal], &Watch::NONE)?;
        let bound = forbidden.prove(cost / (1.0 + gap), BOUND_EFFORT, &|_, _| false, &Watch::NONE)?.length;
        println!(
            "{file}: bound {bound:.4} gap {:.3} % in {:.2} s",
            100.0 * (cost / bound - 1.0),
            clock.elapsed().as_secs_f64()
        );
    }
    Ok(())
}
