//! Certificates of lower bounds: how much of the gap to the best known path they prove, their size, and how long they take.
//!
//! - `cargo run --release -p cdpr-tests --example certificates -- 0.001 testdata/scenes/hard1.toml` (gap, files)
//! - `... -- 0.01 100 3 6` (gap, scenes for each number of prisms)
//!
//! `CERTIFICATES=folder` also writes scenes and certificates as JSON.

use std::time::Instant;

use cdpr_certify::check_bound;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::testing::empty;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene};
use cdpr_study::{RandomScenes, RandomScenesSpec};

/// Best of this many seeds.
const SEEDS: u64 = 3;
/// Effort for each certificate.
const EFFORT: usize = 10_000_000;

fn main() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let gap: f64 = args[0].parse().expect("a gap");
    let Ok(scenes) = args[1].parse::<u64>() else {
        let load = |file: &String| cdpr_files::load_scene(std::path::Path::new(file));
        return args[1..].iter().try_for_each(|file| certified(&load(file)?, gap, "file"));
    };
    for count in &args[2..] {
        let spec: RandomScenesSpec = toml::from_str(&format!("count = {count}")).expect("a valid spec");
        let random = RandomScenes::new(empty(), spec)?;
        for seed in 0..scenes {
            certified(&random.draw(seed)?, gap, &format!("{count}-{seed}"))?;
        }
    }
    Ok(())
}

fn certified(scene: &Scene, gap: f64, name: &str) -> Result<(), Error> {
    let costs = (0..SEEDS).map(|seed| plan(scene, &PlanOptions { seed, ..PlanOptions::default() }, &()));
    let mut shortest = f64::INFINITY;
    for planned in costs {
        let found = planned?.result;
        shortest = if found.waypoints().is_empty() { shortest } else { shortest.min(found.cost) };
    }
    let (Some(start), Some(goal)) = (scene.start(), scene.goal()) else { return Ok(()) };
    if shortest.is_infinite() {
        println!("{name}: no path");
        return Ok(());
    }
    let enough = shortest / (1.0 + gap);
    let engine = engine_for(scene, Engine::default(), Interference::Exact)?;
    let forbidden = Forbidden::new(&*engine, [&start, &goal], &Watch::NONE)?;
    let begin = Instant::now();
    let proved = forbidden.prove(enough, EFFORT, &|_, _| false, &Watch::NONE)?.length;
    let proving = begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    let Some(certificate) = forbidden.certificate(scene, enough, EFFORT, &Watch::NONE)? else {
        println!("{name}: no certificate; {proved} proved");
        return Ok(());
    };
    let certifying = begin.elapsed().as_secs_f64();
    let text = serde_json::to_string(&certificate).expect("finite numbers");
    let begin = Instant::now();
    let checked = check_bound(scene, &text, &Watch::NONE).map(|summary| summary.pieces);
    let checking = begin.elapsed().as_secs_f64();
    let excess = |length: f64| 100.0 * (shortest / length - 1.0);
    println!(
        "{name}: {shortest:.4} m, bound {:.4} % ({proving:.3} s), certificate {:.4} % ({certifying:.3} s), {} bytes, \
         checked in {checking:.3} s: {checked:?}",
        excess(proved),
        excess(certificate.length),
        text.len()
    );
    if let Ok(folder) = std::env::var("CERTIFICATES") {
        let written = [("bound", text), ("scene", serde_json::to_string(&scene.spec()).expect("plain data"))];
        for (kind, text) in written {
            std::fs::write(format!("{folder}/{name}.{kind}.json"), text).expect("a folder that can be written");
        }
    }
    Ok(())
}
