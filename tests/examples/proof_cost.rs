//! What deciding whether there is a path costs where there is one: planning with and without it, in turns.
//!
//! `cargo run --release -p cdpr-tests --example proof_cost -- 101 hard1 hard3 forest cogiro` (seeds, scenes of testdata)

use cdpr_core::compiled::CompiledScene;
use cdpr_core::watch::Watch;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions};
use cdpr_core::{Choice, Error};

const PLANNERS: [Planner; 3] = [Planner::Anytime, Planner::TwoTrees, Planner::ModifiedRrt];

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (seeds, scenes) = arguments.split_first().expect("the number of seeds, then scenes");
    let seeds: u64 = seeds.parse().expect("a number of seeds");
    for name in scenes {
        let scene = cdpr_files::load_scene(Path::new("testdata/scenes").join(name).with_extension("toml"))?;
        let compiled = Arc::new(CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?);
        for planner in PLANNERS {
            let milliseconds = |seed: u64, proof: bool| {
                let options = PlanOptions { planner: PlannerOptions::of(planner), seed, proof, ..Default::default() };
                let clock = Instant::now();
                plan(Query::of(&scene).by(&compiled), &options, &())?;
                Ok::<f64, Error>(1e3 * clock.elapsed().as_secs_f64())
            };
            let mut times = [Vec::new(), Vec::new()];
            for seed in 0..seeds {
                times[0].push(milliseconds(seed, false)?);
                times[1].push(milliseconds(seed, true)?);
            }
            let [without, with] = times.map(median);
            println!("{name} {}: {without:.2} ms without, {with:.2} ms with the decision", planner.name());
        }
    }
    Ok(())
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
