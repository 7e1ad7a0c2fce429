//! How planning grows with the number of bodies: halls of 12 x 8 x 6 m with 10 to 1000 floating boxes, with and without
//! a clearance; one thread plans, all cores compile. Prints a table.
//!
//! `cargo run --release -p cdpr-benches --example halls -- [SEEDS] [BUDGET_S] [COUNT...]`

use std::time::{Duration, Instant};

use cdpr_benches::hall;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::plan::{PlanOptions, lower_bound, plan};
use cdpr_core::planning::Status;
use cdpr_core::watch::Watch;

fn main() {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<f64>().expect("a number"));
    let seeds = numbers.next().unwrap_or(3.0) as u64;
    let budget = Duration::from_secs_f64(numbers.next().unwrap_or(5.0));
    let mut counts: Vec<usize> = numbers.map(|count| count as usize).collect();
    if counts.is_empty() {
        counts = vec![10, 30, 100, 300, 1000];
    }
    println!(
        "| boxes | clearance (m) | compile (ms) | first path (ms) | within 1 % (ms) | stops by itself (ms) | excess then (%) | bound (ms) | gap (%) |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for count in counts {
        for clearance in [0.0, 0.02] {
            (0..seeds).for_each(|seed| row(count, clearance, seed, budget));
        }
    }
}

fn row(count: usize, clearance: f64, seed: u64, budget: Duration) {
    let scene = hall(count, clearance, seed);
    let milliseconds = |clock: Instant| 1e3 * clock.elapsed().as_secs_f64();
    let clock = Instant::now();
    let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).expect("sound");
    let compile = milliseconds(clock);
    let long = PlanOptions { budget: Some(budget), ..PlanOptions::default() };
    let best = plan(&scene, &long, &|| false).expect("sound").result;
    let clock = Instant::now();
    let default = plan(&scene, &PlanOptions::default(), &|| false).expect("sound").result;
    let whole = milliseconds(clock);
    if best.status != Status::Solved || default.status != Status::Solved {
        println!(
            "| {count} | {clearance} | {compile:.1} | no path: {:?}, {:?} in {whole:.1} ms",
            best.status, default.status
        );
        return;
    }
    let least = best.cost.min(default.cost);
    let at = |cost: f64| {
        let found = best.history.iter().find(|m| m.cost <= cost);
        found.map_or("-".to_string(), |m| format!("{:.1}", compile + 1e3 * m.seconds))
    };
    let clock = Instant::now();
    let bound =
        lower_bound(&*engine, &default.waypoints()[0], default.waypoints().last().expect("two ends"), &Watch::NONE);
    let bound = bound.expect("not stopped");
    println!(
        "| {count} | {clearance} | {compile:.1} | {} | {} | {whole:.1} | {:.2} | {:.1} | {:.2} |",
        at(f64::INFINITY),
        at(1.01 * least),
        100.0 * (default.cost / least - 1.0),
        milliseconds(clock),
        100.0 * (least / bound - 1.0),
    );
}
