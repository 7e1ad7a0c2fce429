//! Lower bounds of the length of all paths, against paths and known answers.

use std::sync::Arc;

use cdpr_core::certificate::BoundCertificate;
use cdpr_core::collision::{Checker, Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::limits::QUICK_BOUND_EFFORT;
use cdpr_core::lower_bound::{Bound, Forbidden};
use cdpr_core::model::{Scene, SceneSpec};
use cdpr_core::plan::{PlanOptions, PlanResult, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::testing::{block, hard1, hard3, scene};
use cdpr_core::watch::Watch;
use rayon::prelude::*;

use crate::anytime::{platform_only, random_scenes};

/// Pairs of intervals that most tests may examine.
const EFFORT: usize = 100_000;

fn engine(scene: &Scene) -> Arc<dyn Checker> {
    engine_for(scene, Engine::default(), Interference::Exact).unwrap()
}

/// The best bound between two positions if paths up to `enough` are searched, and no path ends the search.
fn bound(scene: &Scene, ends: [Point; 2], enough: f64, effort: usize) -> f64 {
    let engine = engine(scene);
    let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
    let Bound { length, way } = forbidden.prove(enough, effort, &|_, _| false, &Watch::NONE).unwrap();
    assert!(way.is_empty());
    length
}

fn ends(scene: &Scene) -> [Point; 2] {
    [scene.start().unwrap(), scene.goal().unwrap()]
}

fn planned<'q>(query: impl Into<Query<'q>>, seed: u64) -> PlanResult {
    plan(query, &PlanOptions { seed, ..PlanOptions::default() }, &()).unwrap().result
}

fn shortest(scene: &Scene, seeds: u64) -> f64 {
    let costs = (0..seeds).map(|seed| planned(scene, seed));
    costs.filter(|found| found.status == Status::Solved).map(|found| found.cost).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_thousandth_is_proved_on_the_scenes_of_the_paper() {
    for (scene, cost) in [(hard1(), 2.435167), (hard3(), 2.656138)] {
        let proved = bound(&scene, ends(&scene), cost / 1.001, QUICK_BOUND_EFFORT);
        assert_eq!(proved, cost / 1.001);
        let closer = bound(&scene, ends(&scene), cost / 1.00001, QUICK_BOUND_EFFORT);
        assert_eq!(closer, cost / 1.00001);
    }
}

#[test]
fn four_hundredths_are_proved_in_the_forest() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../testdata/scenes/forest.toml");
    let forest = cdpr_files::load_scene(std::path::Path::new(file)).unwrap();
    let cost = 12.008727; // the best known path
    assert_eq!(bound(&forest, ends(&forest), cost / 1.04, 20_000_000), cost / 1.04);
}

#[test]
fn no_more_is_proved_than_is_true() {
    // Asked to prove more than the length of a known path, the search must not succeed.
    let asked: Vec<bool> = (0..60u64)
        .into_par_iter()
        .map(|seed| {
            let scene = random_scenes([1, 3, 6, 10][seed as usize % 4]).draw(500 + seed).unwrap();
            let cost = shortest(&scene, 3);
            if cost.is_infinite() {
                return false;
            }
            for share in [1.0, 1.001, 1.05] {
                let proved = bound(&scene, ends(&scene), share * cost, 100_000);
                assert!(proved <= cost + 1e-6, "{seed}: {proved} proved, a path has {cost}");
            }
            true
        })
        .collect();
    assert!(asked.iter().filter(|asked| **asked).count() > 30);
}

#[test]
fn most_random_scenes_are_bounded_within_a_thousandth() {
    let gaps: Vec<f64> = (0..40u64)
        .into_par_iter()
        .filter_map(|seed| {
            let scene = random_scenes([3, 6, 10][seed as usize % 3]).draw(700 + seed).unwrap();
            let cost = shortest(&scene, 1);
            cost.is_finite().then(|| cost / bound(&scene, ends(&scene), cost / 1.001, 2_000_000) - 1.0)
        })
        .collect();
    let proved = gaps.iter().filter(|gap| **gap < 0.00101).count();
    assert!(gaps.len() >= 20 && 100 * proved >= 95 * gaps.len(), "{gaps:?}");
}

#[test]
fn nested_blocks_with_common_faces_keep_their_edges() {
    // Both blocks share three faces, and so the edges between them.
    let nested = among(&[([0.2, 0.6, 0.6], [1.0, 1.0, 1.0]), ([0.2, 0.6, 0.8], [1.0, 1.2, 1.1])]);
    let ends = [Point::new(0.3, 1.0, 1.0), Point::new(1.7, 1.1, 1.0)];
    let query = Query { start: Some(ends[0]), goal: Some(ends[1]), ..Query::of(&nested) };
    let cost = (0..5).map(|seed| planned(query, seed).cost).fold(f64::INFINITY, f64::min);
    let proved = bound(&nested, ends, 1.05 * cost, EFFORT);
    assert!(proved <= cost + 1e-6 && proved > 0.999 * cost, "{proved} {cost}");
}

/// The paper's platform without cables among blocks, from one position to another.
fn among(blocks: &[([f64; 3], [f64; 3])]) -> Scene {
    platform_only(blocks.iter().map(|(size, at)| block("block", *size, *at)).collect())
}

#[test]
fn bounds_worked_by_hand() {
    // The platform is 0.15 m wide and 0.05 m high. Over a wall of 1 m from side to side it passes at 1.025 m.
    let wall = among(&[([0.1, 2.0, 1.0], [1.0, 1.0, 0.5])]);
    let [a, b] = [Point::new(0.3, 1.0, 0.3), Point::new(1.7, 1.0, 0.3)];
    let over = 2.0 * (0.7f64 - 0.125).hypot(0.725) + 0.25;
    for (share, expected) in [(0.99999, 0.99999), (1.02, 1.0)] {
        let proved = bound(&wall, [a, b], share * over, EFFORT);
        assert!((proved - expected * over).abs() < 1e-4 * over && proved < over + 1e-6, "{proved} of {over}");
    }
    // Past a free-standing pillar at its side, and past two walls that leave a slalom.
    let pillar = among(&[([0.1, 0.4, 2.0], [1.0, 1.0, 1.0])]);
    let past = 2.0 * (0.7f64 - 0.125).hypot(0.275) + 0.25;
    assert!((bound(&pillar, [a, b], 1.01 * past, EFFORT) - past).abs() < 1e-5);
    let free = among(&[]);
    assert_eq!(bound(&free, [a, b], 5.0, EFFORT), (b - a).norm());
}

#[test]
fn edges_in_line_coplanar_facets_and_touching_blocks() {
    let [a, b] = [Point::new(0.3, 1.0, 0.3), Point::new(1.7, 1.0, 0.3)];
    let over = 2.0 * (0.7f64 - 0.125).hypot(0.725) + 0.25;
    let whole = among(&[([0.1, 2.0, 1.0], [1.0, 1.0, 0.5])]);
    let reference = bound(&whole, [a, b], over, EFFORT);
    // One wall from blocks that touch, that overlap, twice, and upside down in the list.
    let touching = [([0.1, 1.0, 1.0], [1.0, 0.5, 0.5]), ([0.1, 1.0, 1.0], [1.0, 1.5, 0.5])];
    let overlapping = [([0.1, 1.2, 1.0], [1.0, 0.6, 0.5]), ([0.1, 1.2, 1.0], [1.0, 1.4, 0.5])];
    let twice = [touching[0], touching[0], touching[1], touching[1]];
    let thinner = [([0.1, 2.0, 1.0], [1.0, 1.0, 0.5]), ([0.1, 2.0, 0.5], [1.0, 1.0, 0.75])];
    for blocks in [&touching[..], &overlapping, &twice, &[touching[1], touching[0]], &thinner] {
        let proved = bound(&among(blocks), [a, b], over, EFFORT);
        assert!((proved - reference).abs() < 1e-4, "{proved} {reference}");
        let proved = bound(&among(blocks), [a, b], 1.05 * over, EFFORT);
        assert!(proved < over + 1e-6 && proved > 0.999 * over, "{proved} {over}");
    }
    // Start and goal in line with the upper edge, where the platform slides over the wall.
    let level = [Point::new(0.3, 1.0, 1.025), Point::new(1.7, 1.0, 1.025)];
    assert!((bound(&whole, level, 2.0, EFFORT) - 1.4).abs() < 1e-6);
    let along = [Point::new(0.875, 0.3, 1.025), Point::new(0.875, 1.7, 1.025)];
    assert!((bound(&whole, along, 2.0, EFFORT) - 1.4).abs() < 1e-6);
}

#[test]
fn a_one_micrometre_slit_is_passable() {
    // Two walls that leave a slit one micrometre wider than the platform, straight between start and goal.
    let half = 0.5 * (0.15 + 1e-6);
    let width = 1.0 - half;
    let slit =
        among(&[([0.1, width, 2.0], [1.0, 0.5 * width, 1.0]), ([0.1, width, 2.0], [1.0, 2.0 - 0.5 * width, 1.0])]);
    let [a, b] = [Point::new(0.3, 0.6, 0.5), Point::new(1.7, 1.4, 0.5)];
    let corner = |x: f64, y: f64| Point::new(x, y, 0.5);
    let path = [a, corner(0.875, 1.0), corner(1.125, 1.0), b];
    let judge = engine(&slit);
    assert!(path.windows(2).all(|pair| judge.motion_valid(&pair[0], &pair[1])));
    let length: f64 = path.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    let proved = bound(&slit, [a, b], 1.2 * length, EFFORT);
    assert!(proved <= length + 1e-6 && proved > 0.99 * length, "{proved} {length}");
}

#[test]
fn a_flat_workspace_has_bounds_too() {
    let mut spec: SceneSpec = among(&[([0.1, 1.0, 1.0], [1.0, 0.5, 0.5])]).spec().clone();
    spec.workspace.min[2] = 0.3 - 0.025;
    spec.workspace.max[2] = 0.3 + 0.025;
    let flat = scene(SceneSpec { query: None, ..spec });
    let [a, b] = [Point::new(0.3, 0.5, 0.3), Point::new(1.7, 0.5, 0.3)];
    let past = 2.0 * (0.7f64 - 0.125).hypot(0.575) + 0.25;
    let proved = bound(&flat, [a, b], 1.1 * past, EFFORT);
    assert!((proved - past).abs() < 1e-5, "{proved} {past}");
}

#[test]
fn bounds_hold_with_clearance_and_turned_platform() {
    for (name, least) in [("acrobot", 0.99), ("cogiro", 0.55), ("caroca", 0.75), ("concave", 0.99)] {
        let file = format!("{}/../testdata/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let scene = cdpr_files::load_scene(std::path::Path::new(&file)).unwrap();
        let found = planned(&scene, 0);
        let proved = bound(&scene, ends(&scene), 1.01 * found.cost, 4_000_000);
        assert!(proved <= found.cost + 1e-6 && proved > least * found.cost, "{name}: {proved} {}", found.cost);
    }
}

/// Paths that keep a clearance bend around larger obstacles.
#[test]
fn bounds_grow_with_the_clearance() {
    for (scene, clearances) in [(hard1(), [0.01, 0.03, 0.065, 0.1]), (hard3(), [0.002, 0.005, 0.01, 0.02])] {
        let mut before = 0.0;
        for clearance in clearances {
            let wider = scene.with_obstacle_clearance(clearance).unwrap();
            let best = shortest(&wider, 4);
            let proved = bound(&wider, ends(&wider), 1.01 * best, QUICK_BOUND_EFFORT);
            assert!(proved <= best && proved > 0.96 * best, "{}: {proved} {best} at {clearance}", scene.name());
            assert!(proved > before, "{proved} {before}");
            before = proved;
            let certificate = planned_certificate(&wider, best);
            assert!(certificate <= proved);
        }
    }
}

/// The length of an accepted certificate, m.
fn planned_certificate(scene: &Scene, length: f64) -> f64 {
    let found = plan(scene, &PlanOptions::default(), &()).unwrap();
    let written = |certificate: &BoundCertificate| serde_json::to_string(certificate).unwrap();
    let accepts = |certificate: &BoundCertificate, watch: &Watch| {
        cdpr_certify::check_bound(scene, &written(certificate), watch).is_ok()
    };
    found.bound_certificate(length, &accepts, &Watch::NONE).unwrap().expect("one is accepted").length
}

#[test]
fn a_requested_gap_ends_the_search_with_its_proof() {
    let settings = PlannerSettings { gap: Some(0.001), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
    for scene in [hard1(), hard3()] {
        let options = PlanOptions { planner: planner.clone(), ..PlanOptions::default() };
        let found = plan(&scene, &options, &()).unwrap().result;
        assert!(found.cost <= 1.001 * found.lower_bound.unwrap() + 1e-9);
    }
}

#[test]
fn interrupting_a_bound_keeps_the_best_so_far() {
    let scene = hard3();
    let engine = engine(&scene);
    let [start, goal] = ends(&scene);
    let forbidden = Forbidden::new(&*engine, [&start, &goal], &Watch::NONE).unwrap();
    let no_time = Watch::NONE.with_budget(Some(std::time::Duration::from_nanos(1)));
    let late = forbidden.prove(2.65, EFFORT, &|_, _| false, &no_time).unwrap();
    assert_eq!(late.length, (goal - start).norm());
    let stop = || true;
    assert!(forbidden.prove(2.65, EFFORT, &|_, _| false, &Watch::on(&stop)).is_err());
    let none = bound(&scene, [start, start + Vector::new(0.0, 0.0, 1e-3)], 1.0, 1000);
    assert!((none - 1e-3).abs() < 1e-12);
}
