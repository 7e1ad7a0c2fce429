//! How close a lower bound comes to the best known path, in scenes from files or random ones of the paper's kind.
//!
//! - `cargo run --release -p cdpr-tests --example shortest -- 0.001 testdata/scenes/hard1.toml` (gap, files)
//! - `... -- 0.001 100 3 6 10` (gap, scenes for each number of prisms)
//! - `... -- -0.02 100 3 6 10` (a negative gap: tries to prove more than is true; fails if that succeeds)

use cdpr_core::compiled::CompiledScene;
use std::sync::Arc;
use std::time::Instant;

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::limits::BOUND_EFFORT;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::testing::empty;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene};
use cdpr_study::{RandomScenes, RandomScenesSpec};
use rayon::prelude::*;

/// Best of this many seeds.
const SEEDS: u64 = 10;
/// Effort to prove more than is true.
const EFFORT_IN_VAIN: usize = 200_000;

fn main() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let gap: f64 = args[0].parse().expect("a gap");
    let Ok(scenes) = args[1].parse::<u64>() else {
        for file in &args[1..] {
            let scene = cdpr_files::load_scene(std::path::Path::new(file))?;
            println!("{file}: {}", bounded(&scene, gap)?.map_or("no path".into(), |found| found.line()));
        }
        return Ok(());
    };
    for count in &args[2..] {
        let spec: RandomScenesSpec = toml::from_str(&format!("count = {count}")).expect("a valid spec");
        let random = RandomScenes::new(empty(), spec)?;
        let one = |seed: u64| bounded(&random.draw(seed)?, gap);
        let found: Vec<Option<Found>> = (0..scenes).into_par_iter().map(one).collect::<Result<_, Error>>()?;
        let all: Vec<Found> = found.into_iter().flatten().collect();
        let proved = all.iter().filter(|found| found.gap() <= gap + 1e-6).count();
        println!("{count} prisms: {} scenes with a path, gap proved in {proved}", all.len());
        println!("  gap, %: {}", quantiles(all.iter().map(|found| 100.0 * found.gap()).collect()));
        println!("  ms: {}", quantiles(all.iter().map(|found| found.milliseconds).collect()));
    }
    Ok(())
}

/// A path and a bound.
struct Found {
    cost: f64,
    bound: f64,
    milliseconds: f64,
}

impl Found {
    fn gap(&self) -> f64 {
        self.cost / self.bound - 1.0
    }

    fn line(&self) -> String {
        let Found { cost, bound, milliseconds } = self;
        format!("{cost:.6} m, bound {bound:.6} m, gap {:.4} %, {milliseconds:.1} ms", 100.0 * self.gap())
    }
}

fn bounded(scene: &Scene, gap: f64) -> Result<Option<Found>, Error> {
    let compiled = Arc::new(CompiledScene::new(scene, Engine::default(), Interference::Exact, &Watch::NONE)?);
    let engine = compiled.level();
    let planner = PlannerOptions::of(Planner::Anytime);
    let mut cost = f64::INFINITY;
    for seed in 0..SEEDS {
        let options = PlanOptions { seed, planner: planner.clone(), ..PlanOptions::default() };
        let found = plan(Query::of(scene).by(&compiled), &options, &())?.result;
        if found.status == Status::NoPath {
            return Ok(None);
        }
        cost = if found.status == Status::Solved { found.cost.min(cost) } else { cost };
    }
    let [Some(start), Some(goal)] = [scene.start(), scene.goal()] else { return Ok(None) };
    if cost.is_infinite() || (goal - start).norm() > cost / (1.0 + gap.max(0.0)) {
        return Ok(None);
    }
    let clock = Instant::now();
    let effort = if gap < 0.0 { EFFORT_IN_VAIN } else { BOUND_EFFORT };
    let forbidden = Forbidden::new(engine, [&start, &goal], &Watch::NONE)?;
    let bound = forbidden.prove(cost / (1.0 + gap), effort, &|_, _| false, &Watch::NONE)?.length;
    let milliseconds = 1e3 * clock.elapsed().as_secs_f64();
    assert!(bound <= cost + 1e-6, "{}: {bound} m proved, a path has {cost} m", scene.name());
    Ok(Some(Found { cost, bound, milliseconds }))
}

fn quantiles(mut values: Vec<f64>) -> String {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| values.get((share * (values.len().max(1) - 1) as f64) as usize).copied().unwrap_or(f64::NAN);
    format!("median {:.3}, 97 % {:.3}, worst {:.3}", at(0.5), at(0.97), at(1.0))
}
