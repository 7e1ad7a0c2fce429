//! Looks for wrong proofs: decides random scenes with random clearances, diameters, length limits and start positions.
//! Where a proof says that there is no path, all planners search for one, and finding one would be a defect.
//!
//! `cargo run --release -p cdpr-tests --example no_path_study -- 100000 0` (scenes, first seed)

use cdpr_core::compiled::CompiledScene;
use std::sync::Arc;

use cdpr_core::Error;
use cdpr_core::collision::Interference;
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::model::{ClearancesSpec, RobotSource, Scene};
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::proof::{Answer, decide};
use cdpr_core::testing::empty;
use cdpr_core::watch::Watch;
use cdpr_study::{RandomScenes, RandomScenesSpec};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

const PLANNERS: [Planner; 6] =
    [Planner::Anytime, Planner::TwoTrees, Planner::RrtConnect, Planner::ModifiedRrt, Planner::Rrt, Planner::RrtStar];

fn main() -> Result<(), Error> {
    let numbers: Vec<u64> = std::env::args().skip(1).map(|n| n.parse().expect("whole numbers")).collect();
    let [count, first] = numbers[..] else { panic!("how many scenes, and the first seed") };
    let answers: Vec<Option<Found>> =
        (first..first + count).into_par_iter().map(found).collect::<Result<_, Error>>()?;
    let number = |kind: Found| answers.iter().flatten().filter(|found| **found == kind).count();
    let [path, none, undecided] = [Found::Path, Found::NoPath, Found::Undecided].map(number);
    let [invalid, wrong] = [Found::Invalid, Found::Wrong].map(number);
    println!("path {path}, none {none}, undecided {undecided}, start or goal invalid {invalid}, wrong {wrong}");
    Ok(())
}

/// What is found of a scene.
#[derive(Clone, Copy, PartialEq)]
enum Found {
    Path,
    NoPath,
    Undecided,
    /// Start or goal is not valid.
    Invalid,
    /// A path is found where a proof says that there is none.
    Wrong,
}

/// The answer for a random scene; `None` where the draw fails.
fn found(seed: u64) -> Result<Option<Found>, Error> {
    let Some(scene) = random_scene(seed)? else { return Ok(None) };
    let compiled = Arc::new(CompiledScene::new(&scene, Default::default(), Interference::Exact, &Watch::NONE)?);
    let engine = compiled.level();
    let [Some(start), Some(goal)] = [scene.start(), scene.goal()] else { panic!("scenes have both ends") };
    if !engine.state_valid(&start) || !engine.state_valid(&goal) {
        return Ok(Some(Found::Invalid));
    }
    Ok(Some(match decide(engine, [&start, &goal], PROOF_EFFORT, &Watch::NONE)? {
        Answer::Path(_) => Found::Path,
        Answer::OpeningBelow(_) => Found::Undecided,
        Answer::NoPath(_) => {
            let solved = |planner: &Planner| solves(*planner, &scene, &compiled, seed);
            let solvers = PLANNERS.iter().map(solved).collect::<Result<Vec<bool>, Error>>()?;
            if solvers.contains(&true) { Found::Wrong } else { Found::NoPath }
        }
    }))
}

/// Whether a planner finds a path, which is printed.
fn solves(planner: Planner, scene: &Scene, compiled: &Arc<CompiledScene>, seed: u64) -> Result<bool, Error> {
    let mut planner = PlannerOptions::of(planner);
    planner.limits.max_samples = 1000;
    let options = PlanOptions { planner, seed, proof: false, ..PlanOptions::default() };
    let planned = plan(Query::of(scene).by(compiled), &options, &())?.result;
    let solved = planned.status == Status::Solved;
    if solved {
        println!("WRONG: seed {seed}, {:?}, {}", planned.waypoints(), serde_json::to_string(scene.spec()).unwrap());
    }
    Ok(solved)
}

/// A scene with extras; `None` where the draw fails.
fn random_scene(seed: u64) -> Result<Option<Scene>, Error> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let prisms = [3, 5, 7, 9][rng.random_range(0..4)];
    let turned = rng.random_range(0..4) == 0;
    let spec: RandomScenesSpec = toml::from_str(&format!("count = {prisms}\nturned = {turned}")).expect("a valid spec");
    let Ok(scene) = RandomScenes::new(empty(), spec)?.draw(seed) else { return Ok(None) };
    let mut spec = scene.spec().clone();
    if rng.random_range(0..3) == 0 {
        let mut some = || (rng.random_range(0..2) == 0).then(|| rng.random_range(0.0..0.06));
        spec.clearances = Some(ClearancesSpec {
            platform_obstacle: some(),
            cable_obstacle: some(),
            cable_platform: some(),
            cable_cable: some(),
            pairs: Vec::new(),
        });
    }
    let RobotSource::Inline(robot) = &mut spec.robot else { panic!("scenes are drawn with their robot") };
    let thick = rng.random_range(0..4) == 0;
    for cable in &mut robot.cables {
        cable.diameter = thick.then_some(0.01);
        if rng.random_range(0..20) == 0 {
            cable.length = Some([rng.random_range(0.0..1.0), rng.random_range(1.8..3.0)]);
        }
    }
    if rng.random_range(0..8) == 0 {
        // The platform rests on the floor.
        spec.query.as_mut().expect("drawn with a query").start = Some([0.3, 1.0, 0.025].into());
    }
    Ok(Scene::new(spec).ok())
}
