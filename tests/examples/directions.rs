//! Whether `anytime` finds equally short paths from A to B and from B to A, with every seed, in halls of 60 parts.
//!
//! `cargo run --release -p cdpr-tests --example directions -- 20 10 0` (station pairs, seeds, halls by their seeds)

use cdpr_core::compiled::CompiledScene;
use cdpr_core::watch::Watch;
use std::sync::Arc;
use std::time::Instant;

use cdpr_core::Error;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::geometry::Point;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::Status;
use cdpr_tests::halls::{FULL, hall, station_pairs};

/// Largest share by which two paths between the same stations may differ.
const AGREE: f64 = 0.005;

fn main() -> Result<(), Error> {
    let numbers: Vec<u64> = std::env::args().skip(1).map(|n| n.parse().expect("whole numbers")).collect();
    let [pairs, seeds, halls @ ..] = &numbers[..] else { panic!("how many pairs and seeds, and which halls") };
    for hall in halls {
        measure(*hall, *pairs as usize, *seeds)?;
    }
    Ok(())
}

fn measure(seed: u64, pairs: usize, seeds: u64) -> Result<(), Error> {
    let scene = hall(seed, &FULL);
    let compiled = Arc::new(CompiledScene::new(&scene, Engine::default(), Interference::Exact, &Watch::NONE)?);
    println!("hall {seed}, {} parts", scene.spec().obstacles.len());
    let (mut worst, mut apart, mut times) = (1.0f64, 0, Vec::new());
    for (number, ends) in (1..=pairs).zip(station_pairs(compiled.level(), seed)) {
        let query = Query::of(&scene).by(&compiled);
        let plan_from = |[from, to]: [Point; 2], seed: u64| -> Result<_, Error> {
            let clock = Instant::now();
            let found =
                plan(query.starting_at(from).to(to), &PlanOptions { seed, ..PlanOptions::default() }, &())?.result;
            Ok((found, clock.elapsed().as_secs_f64()))
        };
        let mut costs = [Vec::new(), Vec::new()];
        let mut bound = 0.0f64;
        for seed in 0..seeds {
            for (direction, costs) in costs.iter_mut().enumerate() {
                let [a, b] = ends;
                let (found, seconds) = plan_from(if direction == 0 { [a, b] } else { [b, a] }, seed)?;
                costs.push(if found.status == Status::Solved { found.cost } else { f64::INFINITY });
                bound = bound.max(found.lower_bound.unwrap_or(0.0));
                times.push(seconds);
            }
        }
        let all = || costs.iter().flatten().copied();
        let [least, most] = [all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max)];
        let ratio = most / least;
        let over = costs.each_ref().map(|costs| costs.iter().filter(|cost| **cost > (1.0 + AGREE) * least).count());
        let [a, b] = ends.map(|end| format!("{:.2} {:.2} {:.2}", end.x, end.y, end.z));
        println!(
            "  {number:2}: {a} to {b}: {least:.4} to {most:.4} m, {:.2} %, {} and {} above; bound {bound:.3} m",
            100.0 * (ratio - 1.0),
            over[0],
            over[1]
        );
        apart += usize::from(ratio > 1.0 + AGREE);
        worst = worst.max(ratio);
    }
    times.sort_by(f64::total_cmp);
    let at = |share: f64| times[(share * (times.len() - 1) as f64) as usize];
    println!(
        "  {apart} of {pairs} pairs differ by more than {} %, the worst by {:.2} %",
        100.0 * AGREE,
        100.0 * (worst - 1.0)
    );
    println!("  seconds for each path: median {:.3}, 97 % {:.3}, most {:.3}", at(0.5), at(0.97), at(1.0));
    Ok(())
}
