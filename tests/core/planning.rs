//! Planning and rewinding: the results of the study, reproducibility, and the outcomes of a run.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use cdpr_core::Choice;
use cdpr_core::collision::path_check::path_length;
use cdpr_core::collision::{Engine, GjkEngine, Interference, Validity, check_path};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::model::{BodySpec, CableSpec, QuerySpec, RobotSource, RobotSpec, Scene, SceneSpec};
use cdpr_core::plan::{PlanOptions, PlanResult, Processing, Query, plan, shorten_held, trace_rewinding};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::postprocess::{Order, RewindOptions};
use cdpr_core::testing::{block, empty, hard1, hard3, paper_robot, paper_scene, scene};
use cdpr_core::trajectory::Trajectory;
use cdpr_core::turning::TurningEngine;
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_tests::compiled;
use rand::RngExt;
use rayon::prelude::*;

const STEP: f64 = 0.1;

fn planned<'q>(query: impl Into<Query<'q>>, options: PlanOptions) -> PlanResult {
    plan(query, &options, &|| false).unwrap().result
}

/// The default planner with this number of samples.
fn samples(max_samples: usize) -> PlannerOptions {
    let mut planner = PlannerOptions::of(Planner::ModifiedRrt);
    planner.limits.max_samples = max_samples;
    planner
}

/// Every segment is valid, and so is every state in steps of a millimetre.
fn assert_valid(engine: &GjkEngine, path: &[Point]) {
    for pair in path.windows(2) {
        assert!(engine.motion_valid(&pair[0], &pair[1]));
        let steps = ((pair[1] - pair[0]).norm() / 1e-3).ceil();
        for k in 0..=steps as usize {
            assert!(engine.state_valid(&(pair[0] + (pair[1] - pair[0]) * (k as f64 / steps.max(1.0)))));
        }
    }
}

/// Mean costs of another implementation over 1000 runs: raw, and after rewinding in steps of 0.1 m.
fn mean_costs_are_near(scene: &Scene, raw: f64, rewound: f64) {
    const SEEDS: u64 = 1000;
    let engine = GjkEngine::new(scene, Interference::Exact).unwrap();
    let results: Vec<PlanResult> = (0..SEEDS)
        .into_par_iter()
        .map(|seed| planned(scene, PlanOptions { seed, step: STEP, ..PlanOptions::paper() }))
        .collect();
    for result in &results {
        assert_eq!(result.status, Status::Solved);
        assert!(result.cost <= result.raw_cost);
        assert!((path_length(&result.waypoints()) - result.cost).abs() < 1e-12);
    }
    results.par_iter().step_by(10).for_each(|result| assert_valid(&engine, &result.waypoints()));
    let mean = |cost: fn(&PlanResult) -> f64| results.iter().map(cost).sum::<f64>() / SEEDS as f64;
    let (found_raw, found) = (mean(|r| r.raw_cost), mean(|r| r.cost));
    eprintln!("{}: raw {found_raw:.3} m (expected {raw}), rewound {found:.3} m (expected {rewound})", scene.name());
    assert!((found_raw / raw - 1.0).abs() < 0.03 && (found / rewound - 1.0).abs() < 0.03);
}

/// A cube of 0.2 m beside a box, and a position where it overlaps the box by just as much as touching allows: rounding decides.
fn on_the_verge() -> (Scene, Point) {
    let mut spec = paper_scene("verge", vec![block("box", [0.4, 0.6, 0.2], [0.8, 1.3, 0.3])]);
    let robot = RobotSpec {
        platform: vec![BodySpec { cuboid: Some([0.2; 3]), ..BodySpec::default() }],
        cables: vec![CableSpec {
            attachment: [-0.1, 0.1, -0.1],
            outlet: [0.0, 2.0, 0.0],
            ..paper_robot().cables[0].clone()
        }],
        ..paper_robot()
    };
    let verge = [1.099999999, 1.66, 0.43];
    let query = QuerySpec::between([0.9, 1.3, 1.5], verge);
    (spec.robot, spec.query) = (RobotSource::Inline(robot), Some(query));
    (scene(spec), verge.into())
}

#[test]
fn motions_near_contact_are_valid_in_both_directions() {
    let (scene, verge) = on_the_verge();
    for engine in [Engine::Cspace, Engine::Gjk].map(|engine| engine_for(&scene, engine, Interference::Exact).unwrap()) {
        let turning = TurningEngine::new(&scene, engine.clone()).unwrap();
        let turned = |p: &Point| Pose::new(*p, Rotation::from_scaled_axis(Vector::z() * std::f64::consts::FRAC_PI_2));
        let mut rng = cdpr_tests::rng(1);
        for _ in 0..3000 {
            let other = Point::new(1.0, 1.0, 1.0) + cdpr_tests::vector(&mut rng, 0.9);
            let valid = engine.motion_valid(&other, &verge);
            assert_eq!(valid, engine.motion_valid(&verge, &other), "{other}");
            let explained = [(&other, &verge), (&verge, &other)].map(|(from, to)| engine.explain(from, to).is_none());
            assert_eq!(explained, [valid; 2], "{other}");
            let [from, to] = [&other, &verge].map(turned);
            assert_eq!(turning.motion_valid(&from, &to), turning.motion_valid(&to, &from), "{other}");
        }
    }
}

#[test]
fn a_corner_is_cut_only_if_its_sides_stay_valid() {
    // Cable 0 keeps its clearance from the tetrahedron at the last waypoint up to just as much as touching allows.
    let corners = vec![
        [1.1, 0.4, 1.2000000000000002],
        [0.7612046454358541, 0.4986218872481184, 1.313276287114571],
        [1.1740826358692775, 0.90439589597132, 1.0255503252679632],
        [0.7844531236244778, 0.13735063433360561, 0.9857080071342409],
    ];
    let outlets = [[2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0]];
    let cable = |outlet: [f64; 3]| CableSpec { outlet, attachment: [0.0; 3], ..paper_robot().cables[0].clone() };
    let robot = RobotSpec {
        platform: vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }],
        cables: outlets.map(cable).to_vec(),
        ..paper_robot()
    };
    let tetrahedron =
        BodySpec { name: Some("tetrahedron".to_string()), vertices: Some(corners), ..BodySpec::default() };
    let spec = SceneSpec {
        robot: RobotSource::Inline(robot),
        clearance: Some(0.01),
        ..paper_scene("corner", vec![tetrahedron])
    };
    let engine = GjkEngine::new(&scene(spec), Interference::Exact).unwrap();
    let path = [
        [0.935523920293635, 1.7140877801287222, 1.3638465024806916],
        [1.0958196695441236, 1.4018831278592843, 0.19930253232591055],
        [0.9296917002929711, 0.8544822118041939, 1.1742292507324277],
    ];
    shorten_held(&engine, &path.map(Point::from), &Processing::StringPulling, &Watch::NONE).unwrap();
}

#[test]
fn paths_touching_obstacles_pass_the_final_check() {
    let (scene, _) = on_the_verge();
    for (planner, ..) in Planner::ALL {
        for (seed, engine) in [Engine::Cspace, Engine::Gjk].into_iter().cycle().take(6).enumerate() {
            let mut planner = PlannerOptions::of(*planner);
            planner.limits.max_samples = 500;
            let options = PlanOptions { planner, engine, seed: seed as u64, ..PlanOptions::paper() };
            planned(&scene, options); // an internal error if a segment is not valid
        }
    }
}

#[test]
fn hard1_costs_what_the_study_says() {
    mean_costs_are_near(&hard1(), 2.950, 2.621);
}

#[test]
fn hard3_costs_what_the_study_says() {
    mean_costs_are_near(&hard3(), 3.184, 2.812);
}

#[test]
fn the_same_seed_gives_the_same_path_and_another_seed_another() {
    let path = |seed| planned(&hard1(), PlanOptions { seed, ..PlanOptions::paper() }).waypoints();
    assert_eq!(path(5), path(5));
    assert_ne!(path(5), path(6));
}

#[test]
fn without_obstacles_the_path_is_the_straight_line() {
    let found = planned(&empty(), PlanOptions::default());
    assert_eq!((found.waypoints().len(), found.stats.motion_checks), (2, 1));
}

#[test]
fn start_equal_to_goal_costs_nothing() {
    let at = Point::new(0.3, 1.0, 0.3);
    let found = planned(Query::from(&hard1()).starting_at(at).to(at), PlanOptions::paper());
    assert_eq!((found.status, found.cost, found.waypoints().len()), (Status::Solved, 0.0, 2));
}

#[test]
fn invalid_ends_are_answers_with_reasons() {
    let (inside, outside) = (Point::new(1.0, 1.0, 0.5), Point::new(-5.0, 1.0, 0.5));
    let hard1 = hard1();
    for (query, status) in [
        (Query::of(&hard1).starting_at(inside), Status::StartInvalid),
        (Query::of(&hard1).to(inside), Status::GoalInvalid),
        (Query::of(&hard1).to(outside), Status::GoalInvalid),
    ] {
        let found = planned(query, PlanOptions::paper());
        assert_eq!((found.status, found.reason().is_some(), found.waypoints().len()), (status, true, 0));
        assert!(found.cost.is_nan());
    }
}

/// A slab across the whole workspace, which blocks all paths.
fn walled() -> Scene {
    scene(paper_scene("walled", vec![block("wall", [0.05, 2.0, 2.0], [1.0, 1.0, 1.0])]))
}

/// The walled scene with cables that may pass through the wall, so that only the platform is blocked.
fn walled_platform() -> Scene {
    let mut spec = walled().spec().clone();
    spec.ignore = (0..8).map(|k| [format!("cable {k}"), "wall".to_string()]).collect();
    scene(spec)
}

#[test]
fn a_spent_budget_is_told() {
    let found = planned(&walled_platform(), PlanOptions { planner: samples(300), ..PlanOptions::paper() });
    assert_eq!((found.status, found.stats.samples), (Status::BudgetSpent, 300));
    assert!(found.raw_cost.is_nan());
}

#[test]
fn a_time_budget_and_an_interruption_end_the_search() {
    // Without the decision, which may prove in time that there is no path.
    let endless = PlanOptions { planner: samples(usize::MAX), proof: false, ..PlanOptions::paper() };
    let clock = Instant::now();
    let budget = Some(Duration::from_millis(50));
    let found = planned(&walled_platform(), PlanOptions { budget, ..endless.clone() });
    assert_eq!(found.status, Status::BudgetSpent);
    let interrupted = plan(&walled_platform(), &endless, &|| clock.elapsed() > Duration::from_millis(200));
    assert_eq!(interrupted.unwrap().result.status, Status::Interrupted);
    assert!(clock.elapsed() < Duration::from_secs(5));
}

/// Whether some work borrows this list: more hold it then than the engine and the caller.
fn borrows<T: Send + Sync>(list: &Arc<Vec<T>>, work: impl FnOnce(&Interrupt)) -> bool {
    let borrowed = AtomicBool::new(false);
    work(&|| {
        borrowed.fetch_or(Arc::strong_count(list) > 2, Ordering::Relaxed);
        false
    });
    borrowed.into_inner()
}

/// Search, bound, certificate and motion use one engine and its polyhedra: none of them makes others.
#[test]
fn a_query_is_compiled_once() {
    let scene = hard1();
    let compiled = Arc::new(compiled(&scene));
    let pieces = compiled.level().pieces(&Watch::NONE).unwrap();
    let certain = compiled.level().certain_polyhedra(&Watch::NONE).unwrap();
    let settings = PlannerSettings { gap: Some(0.01), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
    let options = PlanOptions { planner, ..PlanOptions::default() };
    let mut found = None;
    assert!(borrows(&certain, |stop| {
        found = Some(plan(Query::of(&scene).by(&compiled), &options, &|| stop()).unwrap())
    }));
    let mut planned = found.unwrap();
    assert!(Arc::ptr_eq(planned.compiled.as_ref().unwrap(), &compiled) && planned.scene == scene);
    planned.result.lower_bound = None; // so that it is bounded anew
    assert!(borrows(&certain, |stop| {
        assert!(planned.appraise(true, &Watch::on(stop)).unwrap().lower_bound.is_some())
    }));
    assert!(borrows(&certain, |stop| {
        assert!(planned.bound_certificate(2.4, &|_, _| true, &Watch::on(stop)).unwrap().is_some())
    }));
    let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), blend: Some(0.02), ..MotionSpec::default() };
    assert!(borrows(&pieces, |stop| {
        Trajectory::new(&compiled, &planned.result.path, &limits, &Watch::on(stop)).map(drop).unwrap()
    }));
    assert!(Arc::ptr_eq(&pieces, &compiled.level().pieces(&Watch::NONE).unwrap()));
}

#[test]
fn bad_questions_are_errors() {
    fn ask<'q>(query: impl Into<Query<'q>>, options: PlanOptions) -> String {
        plan(query, &options, &|| false).unwrap_err().to_string()
    }
    for step in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        assert!(ask(&hard1(), PlanOptions { step, ..PlanOptions::paper() }).contains("step"));
    }
    let nowhere = Point::new(f64::NAN, 0.0, 0.0);
    assert!(ask(Query::of(&hard1()).starting_at(nowhere), PlanOptions::paper()).contains("start"));
    let mut spec = paper_scene("no query", Vec::new());
    spec.query = None;
    assert!(ask(&scene(spec), PlanOptions::default()).contains("query.start"));
}

#[test]
fn a_goal_in_free_space_behind_a_turned_platform_is_planned() {
    let mut spec = hard1().spec().clone();
    let half = std::f64::consts::FRAC_PI_8;
    let turned = Some([half.cos(), 0.0, 0.0, half.sin()].into());
    spec.query = Some(QuerySpec { orientation: turned, ..spec.query.unwrap() });
    let scene = scene(spec);
    let engine = GjkEngine::new(&scene, Interference::Exact).unwrap();
    let found = planned(&scene, PlanOptions::default());
    assert_eq!(found.status, Status::Solved);
    assert_valid(&engine, &found.waypoints());
}

/// A valid random walk in hard1.
fn wandering_path(engine: &GjkEngine, seed: u64) -> Vec<Point> {
    let mut rng = cdpr_tests::rng(seed);
    let mut path = vec![Point::new(0.3, 1.0, 0.3)];
    while path.len() < 12 {
        let next = Point::from(cdpr_tests::vector(&mut rng, 0.9)) + Point::new(1.0, 1.0, 1.0).coords;
        if engine.motion_valid(&path[path.len() - 1], &next) {
            path.push(next);
        }
    }
    path
}

#[test]
fn rewinding_keeps_ends_and_validity_and_never_lengthens() {
    let engine = GjkEngine::new(&hard1(), Interference::Exact).unwrap();
    for seed in 0..60 {
        let path = wandering_path(&engine, seed);
        let cost = |options: &RewindOptions| {
            let rewound = shorten_held(&engine, &path, &Processing::Rewind(options.clone()), &Watch::NONE).unwrap();
            assert_eq!((rewound[0], rewound[rewound.len() - 1]), (path[0], path[path.len() - 1]));
            assert_valid(&engine, &rewound);
            path_length(&rewound)
        };
        let order = |order| cost(&RewindOptions { step: STEP, order, repeats: 1 });
        let (backward, forward, both) = (order(Order::Backward), order(Order::Forward), order(Order::Both));
        assert!(backward <= path_length(&path) && forward <= path_length(&path));
        assert_eq!(both, backward.min(forward));
        assert!(cost(&RewindOptions { step: STEP, order: Order::Both, repeats: 5 }) <= both);
    }
}

#[test]
fn traced_rewindings_record_true_answers() {
    let scene = hard1();
    let engine = GjkEngine::new(&scene, Interference::Exact).unwrap();
    let raw = planned(&scene, PlanOptions { seed: 1, ..PlanOptions::paper() }).raw_waypoints();
    let rewound = |path: &[Point], order| {
        let options = Processing::Rewind(RewindOptions { step: STEP, order, repeats: 1 });
        shorten_held(&engine, path, &options, &Watch::NONE).unwrap()
    };
    let traced = |path: &[Point], order| {
        let options = RewindOptions { step: STEP, order, repeats: 1 };
        trace_rewinding(&engine, path, &options, &Watch::NONE).unwrap()
    };
    for (order, first, second) in [
        (Order::Backward, Order::BackwardOnly, Order::ForwardOnly),
        (Order::Forward, Order::ForwardOnly, Order::BackwardOnly),
    ] {
        let once = traced(&raw, first);
        assert!(path_length(&once.path) < path_length(&raw));
        assert_eq!(once.path, rewound(&raw, first));
        assert_eq!(traced(&once.path, second).path, rewound(&raw, order));
        assert!(once.tries.iter().any(|t| t.valid) && once.tries.iter().any(|t| !t.valid));
        for asked in &once.tries {
            assert_eq!(asked.valid, engine.motion_valid(&asked.from, &asked.to));
        }
    }
}

#[test]
fn rewinding_handles_doubled_waypoints_and_detours() {
    let engine = GjkEngine::new(&empty(), Interference::Exact).unwrap();
    let (a, b, c) = (Point::new(0.3, 1.0, 0.3), Point::new(1.0, 1.6, 1.0), Point::new(1.7, 1.0, 1.7));
    for path in [vec![a, a, b, b, c, c], vec![a, c, a, c], vec![a, a], vec![a, c]] {
        let rewound =
            shorten_held(&engine, &path, &Processing::Rewind(RewindOptions::default()), &Watch::NONE).unwrap();
        let straight = (path[path.len() - 1] - path[0]).norm();
        assert!((path_length(&rewound) - straight).abs() < 1e-9, "{path:?} gave {rewound:?}");
    }
}

#[test]
fn rewinding_refuses_a_path_in_collision_by_name() {
    let engine = GjkEngine::new(&hard1(), Interference::Exact).unwrap();
    let path = [Point::new(0.3, 1.0, 0.3), Point::new(1.7, 1.0, 1.7)];
    let error = shorten_held(&engine, &path, &Processing::Rewind(RewindOptions::default()), &Watch::NONE)
        .unwrap_err()
        .to_string();
    assert!(error.contains("waypoints[0]") && error.contains("pillar"), "{error}");
}

#[test]
fn a_report_names_segment_place_culprits_and_nearest_approach() {
    let engine = GjkEngine::new(&hard1(), Interference::Exact).unwrap();
    let path = [Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 0.4), Point::new(1.7, 1.0, 1.7)];
    let report = check_path(&engine, &path, &Watch::NONE).unwrap();
    assert!(!report.valid && report.violations.iter().all(|v| v.segment == 1));
    let platform = report.violations.iter().find(|v| v.violation.culprits == ["platform", "pillar"]).unwrap();
    // The platform's face x = p.x + 0.075 touches the pillar's side x = 0.85 at p.x = 0.775.
    assert!((platform.violation.at - (0.775 - 0.3) / 1.4).abs() < 1e-8, "{platform:?}");
    assert!(report.nearest.min_clearance.unwrap().value < -0.1);
}

#[test]
fn random_scenes_give_valid_paths_or_honest_ends() {
    let mut rng = cdpr_tests::rng(11);
    let (mut solved, mut asked) = (0, 0);
    for seed in 0..150 {
        let pillar = |k: usize| {
            let (x, y) = (rng.random::<f64>() * 1.6 + 0.2, rng.random::<f64>() * 1.6 + 0.2);
            block(&format!("p{k}"), [0.15, 0.15, 1.0], [x, y, 0.5])
        };
        let mut spec = paper_scene("random", (0..3).map(pillar).collect());
        spec.clearance = Some([0.0, 0.01][seed as usize % 2]);
        let scene = scene(spec);
        let engine = GjkEngine::new(&scene, Interference::Exact).unwrap();
        let found = planned(&scene, PlanOptions { seed, planner: samples(500), ..PlanOptions::paper() });
        // As in the paper, only scenes with free start and goal count.
        asked += usize::from(matches!(found.status, Status::Solved | Status::BudgetSpent));
        if found.status == Status::Solved {
            solved += 1;
            assert_valid(&engine, &found.waypoints());
            assert!(
                check_path(&engine, &found.waypoints(), &Watch::NONE).unwrap().nearest.min_clearance.unwrap().value
                    > scene.pairs().largest() - 1e-7
            );
        }
    }
    assert!(solved > 20 && 2 * solved > asked, "{solved} of {asked}");
}
