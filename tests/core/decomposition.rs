//! Paths through cells against the engines and the planners.

use cdpr_core::collision::{Checker, CspaceEngine, Interference, Kind, Validity};
use cdpr_core::decomposition::{Decomposition, Taste, Way};
use cdpr_core::geometry::Point;
use cdpr_core::model::Scene;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::testing::{block, empty, hard3, paper_scene, scene};
use cdpr_core::watch::Watch;
use cdpr_study::{RandomScenes, RandomScenesSpec};

const MEDIUM_PASSAGES: Taste = Taste { level: 4, heuristic_weight: 2.0 };
const MUCH: usize = 2_000_000;

fn engine(scene: &Scene) -> CspaceEngine {
    CspaceEngine::new(scene, Interference::Exact).unwrap()
}

fn cells(engine: &CspaceEngine) -> Decomposition {
    let (low, high) = engine.conditions().position_box();
    Decomposition::new(engine.pieces(&Watch::NONE).unwrap(), low, high)
}

fn way(scene: &Scene, taste: Taste, effort: usize) -> Way {
    let engine = engine(scene);
    let ends = [&scene.start().unwrap(), &scene.goal().unwrap()];
    cells(&engine).way(ends, &|a: &Point, b: &Point| engine.motion_valid(a, b), taste, effort, &Watch::NONE).unwrap()
}

fn length(path: &[Point]) -> f64 {
    path.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
}

#[test]
fn a_wall_across_the_workspace_leaves_no_way() {
    let wall =
        |height: f64| scene(paper_scene("wall", vec![block("wall", [0.1, 2.0, height], [1.0, 1.0, 0.5 * height])]));
    assert_eq!(way(&wall(2.0), MEDIUM_PASSAGES, MUCH), Way::None);
    assert_eq!(way(&wall(0.2), MEDIUM_PASSAGES, MUCH), Way::None); // it hides the lower outlets
    assert!(matches!(way(&empty(), MEDIUM_PASSAGES, MUCH), Way::Path(_)));
}

#[test]
fn an_outlet_near_a_corner_costs_no_piece() {
    // 10 cm of clearance; the outlet is 12.7 cm from the edge of the block, but inside the block fattened by a cube.
    let mut spec = paper_scene("near", vec![block("block", [0.4, 0.4, 0.4], [0.29, 0.29, 0.0])]);
    spec.clearance = Some(0.1);
    let engine = engine(&scene(spec));
    let pieces = engine.pieces(&Watch::NONE).unwrap();
    let cables = engine.conditions().list.iter().enumerate().filter(|(_, c)| c.details().kind() == Kind::CableObstacle);
    assert!(cables.map(|(index, _)| index).all(|index| pieces.iter().any(|piece| piece.condition == index)));
}

#[test]
fn an_interrupted_search_resumes_to_the_same_path() {
    let scene = hard3();
    let (engine, ends) = (engine(&scene), [scene.start().unwrap(), scene.goal().unwrap()]);
    let whole = way(&scene, MEDIUM_PASSAGES, MUCH);
    assert!(matches!(whole, Way::Path(_)));
    let (mut cells, mut calls) = (cells(&engine), 0);
    let found = loop {
        let free = |a: &Point, b: &Point| engine.motion_valid(a, b);
        match cells.way([&ends[0], &ends[1]], &free, MEDIUM_PASSAGES, 5, &Watch::NONE).unwrap() {
            Way::Undecided => calls += 1,
            way => break way,
        }
    };
    assert!(calls > 5, "{calls}");
    assert_eq!(found, whole);
}

#[test]
fn narrow_passage_weights_give_near_shortest_paths() {
    let Way::Path(wide) = way(&hard3(), MEDIUM_PASSAGES, MUCH) else { panic!("there is one") };
    let Way::Path(short) = way(&hard3(), Taste { level: 9, heuristic_weight: 1.0 }, MUCH) else {
        panic!("there is one")
    };
    assert!(length(&wide) > 2.656 && length(&short) < 1.15 * 2.656, "{} {}", length(&wide), length(&short));
}

#[test]
fn cell_search_agrees_with_planners_on_random_scenes() {
    let (mut paths, mut none) = (0, 0);
    for count in [3, 5, 8] {
        let spec: RandomScenesSpec = toml::from_str(&format!("count = {count}")).unwrap();
        let scenes = RandomScenes::new(empty(), spec).unwrap();
        for seed in 0..60 {
            let scene = scenes.draw(seed).unwrap();
            let engine = engine(&scene);
            let options = PlanOptions { planner: PlannerOptions::of(Planner::TwoTrees), ..PlanOptions::default() };
            match way(&scene, MEDIUM_PASSAGES, MUCH / 10) {
                Way::Path(path) => {
                    paths += 1;
                    assert!(path.windows(2).all(|pair| engine.motion_valid(&pair[0], &pair[1])));
                    assert_eq!([path.first().copied(), path.last().copied()], [scene.start(), scene.goal()]);
                }
                Way::None => {
                    none += 1;
                    let found = plan(&scene, &options, &|| false).unwrap().result;
                    assert_ne!(found.status, Status::Solved, "count {count}, seed {seed}");
                }
                Way::Undecided => {}
            }
        }
    }
    assert!(paths > 100 && none > 0, "{paths} paths, {none} without");
}
