//! How soon a path is checked and repaired after obstacles have moved, and how long it then is against one planned anew.
//!
//! `cargo run --release -p cdpr-tests --example replanning -- 1000` (moves of each scene)

use std::path::Path;
use std::time::Instant;

use cdpr_core::collision::path_check::first_invalid_segment;
use cdpr_core::geometry::{Pose, Vector};
use cdpr_core::plan::{FoundBy, PlanOptions, Query, plan, replan};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::watch::Watch;
use cdpr_core::{CompiledScene, Error, Scene};
use cdpr_files::load_scene;
use rand::seq::index::sample;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Largest move along each horizontal axis, m.
const MOVE: f64 = 0.05;

fn main() -> Result<(), Error> {
    let moves: usize = std::env::args().nth(1).map_or(1000, |text| text.parse().expect("a number of moves"));
    println!(
        "scene, bodies moved: median and 99 % in µs of compiling, checking, repairing; kept, repaired, anew, none; excess of the length"
    );
    for (name, bodies) in [("hard1", 1), ("hard3", 1), ("forest", 1), ("forest", 30)] {
        let scene = load_scene(Path::new(&format!("testdata/scenes/{name}.toml")))?;
        measured(&scene, bodies.min(scene.obstacles().len()), moves)?;
    }
    Ok(())
}

/// Prints the times of replanning after random moves.
fn measured(scene: &Scene, bodies: usize, moves: usize) -> Result<(), Error> {
    let options = PlanOptions { planner: PlannerOptions::of(Planner::TwoTrees), ..PlanOptions::default() };
    let before = plan(scene, &PlanOptions::default(), &())?.result.path;
    let compiled = CompiledScene::new(scene, options.engine, options.interference, &Watch::NONE)?;
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let (mut times, mut counts, mut excess) = ([const { Vec::new() }; 4], [0; 4], Vec::new());
    for _ in 0..moves {
        let Some(moved) = moved(scene, bodies, &mut rng) else { continue };
        let clock = Instant::now();
        let again = std::sync::Arc::new(compiled.recompiled(&moved, &Watch::NONE)?);
        times[0].push(clock.elapsed());
        let clock = Instant::now();
        let valid = first_invalid_segment(&*again, &before).is_none();
        times[1].push(clock.elapsed());
        let clock = Instant::now();
        let result = replan(Query::of(&moved).by(&again), &before, &options, &())?.result;
        if !valid && result.status == Status::Solved {
            times[2].push(clock.elapsed());
        }
        if result.status != Status::Solved {
            counts[3] += 1;
            continue;
        }
        let how = match result.found_by {
            FoundBy::Kept => 0,
            FoundBy::Repaired => 1,
            _ => 2,
        };
        counts[how] += 1;
        let clock = Instant::now();
        let fresh = plan(query(&moved, &before).by(&again), &options, &())?.result;
        times[3].push(clock.elapsed());
        excess.push(result.cost / fresh.cost - 1.0);
    }
    let at = |times: &mut Vec<std::time::Duration>, share: f64| {
        times.sort();
        times.get((share * times.len().saturating_sub(1) as f64) as usize).map_or(0.0, |time| 1e6 * time.as_secs_f64())
    };
    let row: Vec<String> =
        times.iter_mut().map(|times| format!("{:.0} {:.0}", at(times, 0.5), at(times, 0.99))).collect();
    excess.sort_by(f64::total_cmp);
    let share = |share: f64| 100.0 * excess[(share * (excess.len() - 1) as f64) as usize];
    println!(
        "{}, {bodies}: {}; {counts:?}; median {:.2} %, 95 % {:.2} %, 99 % {:.2} %, most {:.2} %; above 2 %: {}",
        scene.name(),
        row.join(", "),
        share(0.5),
        share(0.95),
        share(0.99),
        share(1.0),
        excess.iter().filter(|e| **e > 0.02).count()
    );
    Ok(())
}

fn query<'s>(scene: &'s Scene, path: &[Pose]) -> Query<'s> {
    Query::of(scene).starting_at(path[0].position).to(path[path.len() - 1].position)
}

/// The scene with some obstacles moved at random; `None` where one cannot stand.
fn moved(scene: &Scene, bodies: usize, rng: &mut ChaCha8Rng) -> Option<Scene> {
    let chosen = sample(rng, scene.obstacles().len(), bodies);
    chosen.into_iter().try_fold(scene.clone(), |scene, index| {
        let name = scene.obstacles()[index].name.clone();
        let by = Vector::new(rng.random_range(-MOVE..MOVE), rng.random_range(-MOVE..MOVE), 0.0);
        scene.moved(&name, scene.place_of(&name)? + by).ok()
    })
}
