//! Lower bounds of the length of all paths where required wrenches close the shorter ones.

use std::sync::Arc;

use cdpr_core::collision::{Checker, Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{HalfSpace, Point, Vector};
use cdpr_core::limits::QUICK_BOUND_EFFORT;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::model::BodySpec;
use cdpr_core::model::{
    CableSpec, MarginSpec, QuerySpec, RobotSource, RobotSpec, Scene, SceneSpec, WorkspaceSpec, WrenchSpec,
};
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::Status;
use cdpr_core::testing::{block, paper_robot, paper_scene, scene};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::measures;
use cdpr_tests::with_pulleys;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

pub const EFFORT: usize = 30_000_000;

pub fn engine(scene: &Scene) -> Arc<dyn Checker> {
    engine_for(scene, Engine::default(), Interference::Exact).unwrap()
}

pub fn example(name: &str) -> Scene {
    let file = format!("{}/../testdata/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    cdpr_files::load_scene(std::path::Path::new(&file)).unwrap()
}

fn bound(scene: &Scene, enough: f64, effort: usize) -> f64 {
    let (engine, ends) = (engine(scene), [scene.start().unwrap(), scene.goal().unwrap()]);
    let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
    forbidden.prove(enough, effort, &|_, _| false, &Watch::NONE).unwrap().length
}

/// A point mass on four cables from the corners of a square of 4 m; its weight is balanced exactly below the square. The wall reaches
/// beyond one side of it, and less far beyond the middle on the other way.
fn past_a_wall(wrench: Option<WrenchSpec>) -> Scene {
    let outlets = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let cable =
        |[x, y]: [f64; 2]| CableSpec { outlet: [x, y, 3.0], tension: Some([0.0, 3000.0]), ..CableSpec::default() };
    let robot = RobotSpec {
        platform: vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }],
        cables: outlets.map(cable).to_vec(),
        ..paper_robot()
    };
    let wall = block("wall", [0.2, 2.9, 4.0], [2.0, 1.05, 1.5]);
    let spec = SceneSpec {
        workspace: WorkspaceSpec { min: [-1.0, -1.0, 0.5], max: [5.0, 5.0, 2.0] },
        robot: RobotSource::Inline(robot),
        query: Some(QuerySpec::between([1.0, 0.5, 1.0], [3.0, 0.5, 1.0])),
        ignore: (0..4).map(|k| [format!("cable {k}"), "wall".to_string()]).collect(),
        wrench,
        ..paper_scene("past a wall", vec![wall])
    };
    scene(spec)
}

#[test]
fn the_way_round_a_wall_that_wrenches_leave_open_is_worked_by_hand() {
    let round = |reach: f64| 2.0 * 0.9f64.hypot(reach) + 0.2;
    let (short, long) = (round(0.9), round(2.0));
    let without = past_a_wall(None);
    assert!((bound(&without, short, EFFORT) - short).abs() < 1e-6);
    assert!(bound(&without, long, EFFORT) < short + 1e-6);
    let with = past_a_wall(Some(WrenchSpec::default()));
    let proved = bound(&with, long - 1e-6, EFFORT);
    assert_eq!(proved, long - 1e-6);
    let too_much = bound(&with, 1.01 * long, EFFORT);
    assert!(too_much <= long + 1e-6 && too_much > short, "{too_much} {long}");
    // Little effort leaves wrenches out.
    assert!(bound(&with, long, QUICK_BOUND_EFFORT) < short + 1e-6);
}

/// The smallest box of which a polyhedron is a part: it has one face across each axis and side.
fn around(planes: &[HalfSpace]) -> [Point; 2] {
    let side = |axis: usize, sign: f64| {
        let normal = Vector::ith(axis, sign);
        sign * planes.iter().find(|plane| plane.normal == normal).expect("a side").offset
    };
    [-1.0, 1.0].map(|sign| Point::from(Vector::from_fn(|axis, _| side(axis, sign))))
}

/// Polyhedra on random ways in a scene, tried at random positions; returns how many positions were strictly inside.
fn tried(scene: &Scene, seed: u64) -> usize {
    let (engine, measures) = (engine(scene), measures(scene).unwrap());
    let ends = [scene.start().unwrap(), scene.goal().unwrap()];
    let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
    let (low, high) = engine.conditions().position_box();
    let enough = 1.9 * (ends[1] - ends[0]).norm();
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let via = |place: &Point| ends.iter().map(|end| (place - end).norm()).sum::<f64>();
    let (mut inside, mut count) = (0, 0);
    for _ in 0..300 {
        if count >= 6 {
            break;
        }
        let mut somewhere = |low: &Point, high: &Point| {
            low + (high - low).component_mul(&Vector::from_fn(|_, _| rng.random_range(0.0..1.0)))
        };
        let middle = somewhere(&low, &high);
        for hull in forbidden.lacking_on(&[ends[0], middle, ends[1]], enough, &Watch::NONE).unwrap() {
            count += 1;
            let [from, to] = around(hull.planes());
            let (from, to) = (from.sup(&low), to.inf(&high));
            for _ in 0..4000 {
                let place = somewhere(&from, &to);
                if via(&place) < enough && hull.planes().iter().all(|plane| plane.height(&place) < 0.0) {
                    inside += 1;
                    let lacks = measures.iter().any(|measure| measure.slack(&place) < measure.floor());
                    assert!(lacks, "{}: wrenches suffice at {place}", scene.name());
                }
            }
        }
    }
    inside
}

/// Polyhedra on nearly straight ways, tried at random positions of a narrow ellipsoid; returns how many of these were strictly inside.
fn tried_in_a_narrow_ellipsoid(scene: &Scene, seed: u64) -> usize {
    let (engine, measures) = (engine(scene), measures(scene).unwrap());
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (low, high) = engine.conditions().position_box();
    let mut inside = 0;
    for _ in 0..12 {
        let mut somewhere = || low + (high - low).component_mul(&Vector::from_fn(|_, _| rng.random_range(0.0..1.0)));
        let ends = [somewhere(), somewhere()];
        let straight = (ends[1] - ends[0]).norm();
        let enough = 1.05 * straight;
        let across = 0.5 * (enough * enough - straight * straight).sqrt();
        let mut near = || {
            let aside = Vector::from_fn(|_, _| rng.random_range(-across..across));
            ends[0] + (ends[1] - ends[0]) * rng.random_range(0.0..1.0) + aside
        };
        let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
        let hulls =
            forbidden.lacking_on(&[ends[0], ends[0] + (ends[1] - ends[0]) * 0.5, ends[1]], enough, &Watch::NONE);
        for hull in hulls.unwrap() {
            for _ in 0..2000 {
                let place = near();
                let within = (0..3).all(|axis| low[axis] < place[axis] && place[axis] < high[axis]);
                let via: f64 = ends.iter().map(|end| (place - end).norm()).sum();
                if within && via < enough && hull.planes().iter().all(|plane| plane.height(&place) < 0.0) {
                    inside += 1;
                    let lacks = measures.iter().any(|measure| measure.slack(&place) < measure.floor());
                    assert!(lacks, "{}: wrenches suffice at {place}", scene.name());
                }
            }
        }
    }
    inside
}

#[test]
fn wrenches_lack_wherever_a_short_path_can_be_in_a_polyhedron() {
    for (seed, name) in (0..).zip(["cogiro", "caroca", "mpi_simulator", "ipanema2"]) {
        let found = tried_in_a_narrow_ellipsoid(&example(name), seed);
        assert!(found > 500, "{name}: {found}");
    }
}

#[test]
fn wrenches_lack_at_random_positions_of_polyhedra() {
    let mut inside = 0;
    for (seed, name) in (0..).zip(["cogiro", "caroca", "mpi_simulator", "ipanema2", "acrobot"]) {
        let found = tried(&example(name), seed);
        assert!(found > 500 || name == "acrobot", "{name}: {found}");
        inside += found;
        // Two load cases, and the projected margins.
        let mut spec = example(name).spec().clone();
        let weight = 0.3 * example(name).robot().mass().unwrap_or(1.0) * 9.81;
        let wrench = spec.wrench.as_mut().unwrap();
        wrench.loads = Some(vec![[0.0; 6], [weight, 0.0, 0.0, 0.0, 0.0, 0.0]]);
        wrench.margin = Some(MarginSpec::Projected);
        if name == "cogiro" || name == "mpi_simulator" {
            inside += tried(&scene(spec), seed);
        }
        if name != "acrobot" {
            let found = tried(&with_pulleys(&example(name), 0.05), seed);
            assert!(found > 500, "{name} with pulleys: {found}");
        }
    }
    assert!(inside > 10_000, "{inside}");
}

#[test]
fn gaps_of_built_robots_are_proved() {
    for (name, cost, gap) in [("mpi_simulator", 7.9956, 0.02), ("ipanema2", 3.9860, 0.005)] {
        assert_eq!(bound(&example(name), cost / (1.0 + gap), EFFORT), cost / (1.0 + gap), "{name}");
    }
}

#[test]
fn no_path_among_random_obstacles_is_shorter_than_the_bound() {
    let (mut solved, mut better) = (0, 0);
    for (seed, name) in (0..).zip(["caroca", "ipanema2", "mpi_simulator"]) {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut spec = example(name).spec().clone();
        let place = spec.obstacles[0].position.as_mut().unwrap();
        (0..2).for_each(|axis| place[axis] += rng.random_range(-0.3..0.3));
        let scene = scene(spec);
        let costs = (0..4).filter_map(|seed| {
            let found = plan(&scene, &PlanOptions { seed, ..PlanOptions::default() }, &()).unwrap().result;
            (found.status == Status::Solved).then_some(found.cost)
        });
        let best = costs.fold(f64::INFINITY, f64::min);
        if best.is_infinite() {
            continue;
        }
        solved += 1;
        let proved = bound(&scene, 1.02 * best, 3_000_000);
        assert!(proved <= best + 1e-6, "{name}: {proved} {best}");
        better += usize::from(proved > bound(&scene, 1.02 * best, QUICK_BOUND_EFFORT) + 1e-3);
    }
    assert!(solved >= 2 && better >= 1, "{solved} {better}");
}
