//! Looks for wrong proofs: random scenes with random clearances, diameters, length limits and start positions, planned without
//! proofs by all planners in turn; a path where a proof says that there is none would be a defect.
//!
//! `cargo run --release -p cdpr-tests --example no_path_study -- 100000 0` (scenes, first seed)

use cdpr_core::collision::Interference;
use cdpr_core::model::{ClearancesSpec, RobotSource, Scene};
use cdpr_core::numerics::PROOF_EFFORT;
use cdpr_core::plan::{PlanOptions, Query, engine_for, plan};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::proof::{Answer, decide};
use cdpr_core::testing::empty;
use cdpr_core::watch::Watch;
use cdpr_study::{RandomScenes, RandomScenesSpec};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const PLANNERS: [Planner; 6] =
    [Planner::Anytime, Planner::TwoTrees, Planner::RrtConnect, Planner::ModifiedRrt, Planner::Rrt, Planner::RrtStar];

fn main() -> Result<(), cdpr_core::Error> {
    let numbers: Vec<u64> = std::env::args().skip(1).map(|n| n.parse().expect("whole numbers")).collect();
    let [count, first] = numbers[..] else { panic!("how many scenes, and the first seed") };
    let mut counts = [0usize; 5];
    for seed in first..first + count {
        let Some(scene) = random_scene(seed)? else { continue };
        let engine = engine_for(&scene, Default::default(), Interference::Exact)?;
        let [Some(start), Some(goal)] = [scene.start(), scene.goal()] else { panic!("scenes have both ends") };
        if !engine.state_valid(&start) || !engine.state_valid(&goal) {
            counts[3] += 1;
            continue;
        }
        let answer = decide(&*engine, [&start, &goal], PROOF_EFFORT, &Watch::NONE)?;
        let mut planner = PlannerOptions::of(PLANNERS[seed as usize % PLANNERS.len()]);
        planner.limits_mut().max_samples = 1000;
        let options = PlanOptions { planner, seed, proof: false, ..PlanOptions::default() };
        let found = plan(Query::of(&scene).by(&*engine), &options, &())?.result;
        match (&answer, found.status) {
            (Answer::NoPath(_), Status::Solved) => {
                counts[4] += 1;
                println!("WRONG: seed {seed}, {:?}, {}", found.waypoints, serde_json::to_string(scene.spec()).unwrap());
            }
            (Answer::NoPath(_), _) => counts[1] += 1,
            (Answer::Path(_), _) => counts[0] += 1,
            (Answer::OpeningBelow(_), _) => counts[2] += 1,
        }
    }
    let [path, none, undecided, invalid, wrong] = counts;
    println!("path {path}, none {none}, undecided {undecided}, start or goal invalid {invalid}, wrong {wrong}");
    Ok(())
}

/// A scene with extras; `None` where the draw fails.
fn random_scene(seed: u64) -> Result<Option<Scene>, cdpr_core::Error> {
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
        spec.query.as_mut().expect("drawn with a query").start = Some([0.3, 1.0, 0.025]);
    }
    Ok(Scene::new(spec).ok())
}
