//! Decides random scenes of the paper's kind; prints how many have a path, how many provably none, and how long it takes.
//!
//! `cargo run --release -p cdpr-tests --example no_path -- 1000 3 6 10` (scenes for each number of prisms)

use std::cell::Cell;
use std::time::Instant;

use cdpr_core::collision::{CspaceEngine, Interference};
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::proof::{Answer, Proof, decide_with};
use cdpr_core::testing::empty;
use cdpr_core::watch::Watch;
use cdpr_study::{RandomScenes, RandomScenesSpec};

fn main() -> Result<(), cdpr_core::Error> {
    let numbers: Vec<u64> = std::env::args().skip(1).map(|n| n.parse().expect("whole numbers")).collect();
    let (&scenes, prisms) = numbers.split_first().expect("how many scenes, then numbers of prisms");
    for &count in prisms {
        let spec: RandomScenesSpec = toml::from_str(&format!("count = {count}")).expect("a valid spec");
        let random = RandomScenes::new(empty(), spec)?;
        let (mut found, mut open, mut certain) = (Vec::new(), Vec::new(), Vec::new());
        let mut none: Vec<(f64, Box<Proof>)> = Vec::new();
        for seed in 0..scenes {
            let scene = random.draw(seed)?;
            let clock = Instant::now();
            let milliseconds = || 1e3 * clock.elapsed().as_secs_f64();
            let engine = CspaceEngine::new(&scene, Interference::Exact)?;
            let ends = [&scene.start().unwrap(), &scene.goal().unwrap()];
            let none_at = Cell::new(None);
            let on_no_path = || none_at.set(Some(milliseconds()));
            let answer = decide_with(&engine, ends, PROOF_EFFORT, &on_no_path, &Watch::NONE)?;
            let milliseconds = milliseconds();
            certain.extend(none_at.get());
            match answer {
                Answer::Path(_) => found.push(milliseconds),
                Answer::NoPath(proof) => none.push((milliseconds, proof)),
                Answer::OpeningBelow(width) => {
                    println!("  seed {seed}: undecided, openings below {width} m, {milliseconds:.1} ms");
                    open.push(milliseconds);
                }
            }
        }
        let boxes: Vec<f64> = none.iter().map(|(_, proof)| proof.boxes.len() as f64).collect();
        let blocking: Vec<f64> = none.iter().map(|(_, proof)| proof.blocking.len() as f64).collect();
        println!("{count} prisms: path {}, none {}, undecided {}", found.len(), none.len(), open.len());
        println!("  ms to a path: {}", quantiles(found));
        println!("  ms until it is certain that there is none: {}", quantiles(certain));
        println!(
            "  ms to a proof with its reasons: {}",
            quantiles(none.into_iter().map(|(milliseconds, _)| milliseconds).collect())
        );
        println!("  boxes of a proof: {}; obstacles: {}", quantiles(boxes), quantiles(blocking));
    }
    Ok(())
}

fn quantiles(mut values: Vec<f64>) -> String {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| values.get((share * (values.len().max(1) - 1) as f64) as usize).copied().unwrap_or(f64::NAN);
    format!("median {:.2}, 99 % {:.2}, worst {:.2}", at(0.5), at(0.99), at(1.0))
}
