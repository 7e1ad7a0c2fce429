//! Whether the way back is as long as the way there: pairs of stations in a hall of 12 x 8 x 6 m with 60 floating boxes,
//! several seeds each, default options. Prints the range of lengths for each pair, and how often they differ by more than 0.5 %.
//!
//! `cargo run --release -p cdpr-benches --example both_ways -- [PAIRS] [SEEDS] [BOXES]`

use std::time::Instant;

use cdpr_benches::hall;
use cdpr_core::Error;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::Vector;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::Status;
use rand::{RngExt, SeedableRng};

fn main() -> Result<(), Error> {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<usize>().expect("a whole number"));
    let [pairs, seeds, boxes] = [20, 10, 60].map(|usual| numbers.next().unwrap_or(usual));
    let scene = hall(boxes, 0.0, 0);
    let engine = engine_for(&scene, Engine::Cspace, Interference::Exact)?;
    let (low, high) = engine.conditions().position_box();
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
    let mut station = || loop {
        let place = low + (high - low).component_mul(&Vector::from_fn(|_, _| rng.random_range(0.05..0.95)));
        if engine.state_valid(&place) {
            return place;
        }
    };
    let (mut apart, mut runs, mut seconds) = (0, 0, 0.0);
    for pair in 0..pairs {
        let ends = [station(), station()];
        let mut costs = Vec::new();
        for seed in 0..seeds as u64 {
            for [start, goal] in [ends, [ends[1], ends[0]]] {
                let clock = Instant::now();
                costs.push(cost(Query { start: Some(start), goal: Some(goal), ..Query::of(&scene) }, seed)?);
                seconds += clock.elapsed().as_secs_f64();
                runs += 1;
            }
        }
        let least = costs.iter().copied().fold(f64::INFINITY, f64::min);
        let longer = costs.iter().filter(|cost| **cost > 1.005 * least).count();
        let most = costs.iter().copied().fold(0.0, f64::max);
        println!("pair {pair}: {least:.4} to {most:.4} m, {longer} of {} more than 0.5 % longer", costs.len());
        apart += longer;
    }
    println!(
        "{apart} of {runs} runs more than 0.5 % above the shortest of their pair; {:.0} ms each",
        1e3 * seconds / runs as f64
    );
    Ok(())
}

fn cost(query: Query, seed: u64) -> Result<f64, Error> {
    let found = plan(query, &PlanOptions { seed, ..PlanOptions::default() }, &())?.result;
    Ok(if found.status == Status::Solved { found.cost } else { f64::INFINITY })
}
