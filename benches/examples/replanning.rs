//! How soon a path is checked and repaired after obstacles have moved, and how much longer it then is than one planned anew.
//!
//! `cargo run --release -p cdpr-benches --example replanning -- 1000` (moves of each scene)

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use cdpr_benches::hall;
use cdpr_core::collision::path_check::first_invalid_segment;
use cdpr_core::geometry::Vector;
use cdpr_core::plan::{FoundBy, PlanOptions, PlanResult, Query, plan, replan};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::watch::Watch;
use cdpr_core::{CompiledScene, Error, Scene, testing};
use cdpr_files::load_scene;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Largest move along each horizontal axis, m.
const MOVE: f64 = 0.05;

fn main() -> Result<(), Error> {
    let moves: usize = std::env::args().nth(1).map_or(1000, |text| text.parse().expect("a number of moves"));
    let forest = load_scene(Path::new("testdata/scenes/forest.toml"))?;
    let scenes =
        [(testing::hard1(), 1), (testing::hard3(), 1), (forest, 1), (hall(300, 0.0, 0), 1), (hall(300, 0.0, 0), 30)];
    for (scene, bodies) in scenes {
        let mut measured = Measured::default();
        measured.moves(&scene, bodies, moves)?;
        let (name, all) = (scene.name(), scene.obstacles().len());
        println!("{name}, {bodies} of {all} moved: {}", measured.words());
    }
    Ok(())
}

/// Times in µs, and excess lengths.
#[derive(Default)]
struct Measured {
    compiling: Vec<f64>,
    checking: Vec<f64>,
    /// Of paths that are no longer valid.
    repairing: Vec<f64>,
    /// Of these paths, planned anew.
    planning: Vec<f64>,
    kept: usize,
    repaired: usize,
    anew: usize,
    without: usize,
    /// Shares by which the paths that were repaired are longer than those planned anew.
    excess: Vec<f64>,
}

impl Measured {
    fn moves(&mut self, scene: &Scene, bodies: usize, moves: usize) -> Result<(), Error> {
        let options = PlanOptions { planner: PlannerOptions::of(Planner::TwoTrees), ..PlanOptions::default() };
        let before = plan(scene, &PlanOptions::default(), &())?.result.path;
        let [start, .., goal] = &before[..] else { panic!("no path") };
        let compiled = CompiledScene::new(scene, options.engine, options.interference, &Watch::NONE)?;
        let mut rng = ChaCha8Rng::seed_from_u64(0);
        for _ in 0..moves {
            let Some(moved) = moved(scene, bodies, &mut rng) else { continue };
            let again = timed(&mut self.compiling, || compiled.recompiled(&moved, &Watch::NONE).map(Arc::new))?;
            let query = Query::of(&moved).by(&again).starting_at(start.position).to(goal.position);
            if timed(&mut self.checking, || first_invalid_segment(&*again, &before)).is_none() {
                self.kept += 1;
                continue;
            }
            let mut times = [Vec::new(), Vec::new()];
            let result = timed(&mut times[0], || replan(query, &before, &options, &()))?.result;
            if result.status != Status::Solved {
                self.without += 1;
                continue;
            }
            let fresh: PlanResult = timed(&mut times[1], || plan(query, &options, &()))?.result;
            self.repairing.append(&mut times[0]);
            self.planning.append(&mut times[1]);
            self.excess.push(result.cost / fresh.cost - 1.0);
            *if result.found_by == FoundBy::Repaired { &mut self.repaired } else { &mut self.anew } += 1;
        }
        Ok(())
    }

    fn words(&mut self) -> String {
        let [compiling, checking, repairing, planning] =
            [&mut self.compiling, &mut self.checking, &mut self.repairing, &mut self.planning]
                .map(|times| format!("{:.0} ({:.0})", at(times, 0.5), at(times, 0.99)));
        let Measured { kept, repaired, anew, without, .. } = self;
        format!(
            "compiled in {compiling} µs, checked in {checking}, repaired in {repairing}, planned anew in {planning} (median, 99 %); {kept} \
             kept, {repaired} repaired, {anew} anew, {without} without a path; repaired ones longer than planned anew by {:.2} % (99 %), \
             {:.2} % at most",
            100.0 * at(&mut self.excess, 0.99),
            100.0 * at(&mut self.excess, 1.0),
        )
    }
}

fn timed<T>(times: &mut Vec<f64>, work: impl FnOnce() -> T) -> T {
    let clock = Instant::now();
    let done = work();
    times.push(1e6 * clock.elapsed().as_secs_f64());
    done
}

/// A quantile of numbers; 0 if there are none.
fn at(numbers: &mut [f64], share: f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get((share * numbers.len().saturating_sub(1) as f64) as usize).copied().unwrap_or(0.0)
}

/// The scene with some obstacles moved at random; `None` where one cannot stand.
fn moved(scene: &Scene, bodies: usize, rng: &mut ChaCha8Rng) -> Option<Scene> {
    let mut all: Vec<usize> = (0..scene.obstacles().len()).collect();
    let (chosen, _) = all.partial_shuffle(rng, bodies);
    chosen.iter().try_fold(scene.clone(), |scene, index| {
        let name = scene.obstacles()[*index].name.clone();
        let by = Vector::new(rng.random_range(-MOVE..MOVE), rng.random_range(-MOVE..MOVE), 0.0);
        scene.moved(&name, scene.place_of(&name)? + by).ok()
    })
}
