//! RRT, RRT* and Modified RRT: mean costs of the study, valid paths, reproducibility, continuing after the first path.

use std::time::{Duration, Instant};

use cdpr_core::collision::{Checker, CspaceEngine, Engine, GjkEngine, Interference, Validity, path_check};
use cdpr_core::geometry::{Point, path_length};
use cdpr_core::model::Scene;
use cdpr_core::plan::{PlanOptions, PlanResult, Post, Query, plan};
use cdpr_core::planning::{
    Method, Planner, PlannerOptions, PlannerSettings, Problem, RrtOptions, RrtStarOptions, SearchLimits, Status,
    TranslationSpace, Until,
};
use cdpr_core::postprocess::StringPuller;
use cdpr_core::testing::{block, empty, hard1, hard3, paper_scene, scene};
use cdpr_core::watch::Watch;
use cdpr_core::{Choice, Error};
use cdpr_tests::Improvements;
use rand::SeedableRng;
use rayon::prelude::*;

fn planned(scene: &Scene, planner: &PlannerOptions, seed: u64) -> PlanResult {
    let options = PlanOptions { planner: planner.clone(), seed, ..PlanOptions::paper() };
    plan(scene, &options, &|| false).unwrap().result
}

fn every_planner() -> impl Iterator<Item = PlannerOptions> {
    let biased = PlannerSettings { goal_bias: Some(0.05), max_samples: Some(200_000), ..PlannerSettings::default() };
    Planner::ALL.iter().map(move |(planner, ..)| match planner {
        Planner::Rrt => PlannerOptions::new(Planner::Rrt, 0.1, &biased).unwrap(),
        other => PlannerOptions::of(*other),
    })
}

fn star(near_radius: Option<f64>) -> PlannerOptions {
    let settings = PlannerSettings { near_radius, ..PlannerSettings::default() };
    PlannerOptions::new(Planner::RrtStar, 0.1, &settings).unwrap()
}

/// Means over many seeds lie within four standard errors of those of another implementation over 1000 runs, whose
/// standard error is added to ours.
fn costs_are(scene: &Scene, planner: &PlannerOptions, raw: f64, rewound: f64) {
    const SEEDS: u64 = 200;
    let results: Vec<PlanResult> = (0..SEEDS).into_par_iter().map(|seed| planned(scene, planner, seed)).collect();
    assert!(results.iter().all(|r| r.status == Status::Solved));
    for (what, expected, cost) in
        [("raw", raw, (|r| r.raw_cost) as fn(&PlanResult) -> f64), ("rewound", rewound, |r| r.cost)]
    {
        let n = SEEDS as f64;
        let mean = results.iter().map(cost).sum::<f64>() / n;
        let variance = results.iter().map(|r| (cost(r) - mean).powi(2)).sum::<f64>() / (n - 1.0);
        let error = (variance / n + variance / 1000.0).sqrt();
        eprintln!("{} {what}: {mean:.3} ± {:.3} m, expected {expected}", scene.name(), variance.sqrt());
        assert!((mean - expected).abs() < 4.0 * error + 0.005, "{what}: {mean}, expected {expected}");
    }
}

fn raw(scene: &Scene, planner: Planner, settings: PlannerSettings, seed: u64) -> PlanResult {
    let planner = PlannerOptions::new(planner, 0.1, &settings).unwrap();
    let options = PlanOptions { planner, seed, post: Some(Post::None), proof: false, ..PlanOptions::default() };
    plan(scene, &options, &|| false).unwrap().result
}

#[test]
fn modified_rrt_with_a_goal_bias_reaches_the_goal_by_chance() {
    let biased = |scene: &Scene, bias, max_samples, seed| {
        let settings =
            PlannerSettings { goal_bias: Some(bias), max_samples: Some(max_samples), ..PlannerSettings::default() };
        raw(scene, Planner::ModifiedRrt, settings, seed)
    };
    // Without any bias, the goal is never a sample; with nothing else, it is never tried twice from the same node.
    let never = biased(&empty(), 0.0, 50, 0);
    assert_eq!((never.status, never.stats.samples, never.stats.nodes > 1), (Status::BudgetSpent, 50, true));
    let only = biased(&hard1(), 1.0, 50, 0);
    assert_eq!((only.status, only.stats.samples, only.stats.motion_checks), (Status::BudgetSpent, 50, 1));
    let engine = CspaceEngine::new(&hard1(), Interference::Exact).unwrap();
    for seed in 0..20 {
        let found = biased(&hard1(), 0.1, 20_000, seed);
        assert_eq!(found.status, Status::Solved);
        assert!(path_check::first_invalid_segment(&engine, &found.waypoints()).is_none());
        assert_eq!(biased(&hard1(), 0.1, 20_000, seed).waypoints(), found.waypoints());
    }
}

#[test]
fn rrt_with_check_goal_steps_straight_to_the_goal() {
    let settings = PlannerSettings { check_goal: true, ..PlannerSettings::default() };
    let found = raw(&empty(), Planner::Rrt, settings.clone(), 0);
    // sqrt(2) 1.4 m in steps of 0.1 m: nineteen steps, from the last of which the goal is within one step.
    assert_eq!((found.status, found.stats.samples, found.waypoints().len()), (Status::Solved, 19, 21));
    assert!((found.cost - 1.4 * 2f64.sqrt()).abs() < 1e-12);
    let going = PlannerSettings { keep_going: true, max_samples: Some(3000), ..settings.clone() };
    for (planner, settings) in [
        (Planner::Rrt, going.clone()),
        (Planner::Rrt, PlannerSettings { check_goal: false, goal_bias: Some(0.1), ..going.clone() }),
        (Planner::RrtStar, PlannerSettings { check_goal: false, goal_bias: Some(0.1), ..going }),
    ] {
        let found = raw(&hard1(), planner, settings, 1);
        let at_goal = found.tree.states.iter().filter(|state| **state == hard1().goal().unwrap()).count();
        assert!(found.status == Status::Solved && at_goal == 1, "{planner:?}: {at_goal}");
    }
    let samples = |settings: &PlannerSettings| {
        let solved = (0..20).map(|seed| raw(&hard1(), Planner::Rrt, settings.clone(), seed));
        solved.inspect(|found| assert_eq!(found.status, Status::Solved)).map(|found| found.stats.samples).sum::<usize>()
    };
    let uninformed = PlannerSettings { max_samples: Some(500_000), ..PlannerSettings::default() };
    assert!(samples(&settings) < samples(&uninformed));
}

#[test]
fn the_radius_of_rrt_star_shrinks_from_its_cap() {
    let star = |near_cap, seed| {
        raw(&hard1(), Planner::RrtStar, PlannerSettings { near_cap, ..PlannerSettings::default() }, seed)
    };
    let length = |near_cap| (0..20).map(|seed| star(near_cap, seed).cost).sum::<f64>() / 20.0;
    assert_eq!(star(Some(0.1), 3).waypoints(), star(None, 3).waypoints()); // the step
    assert!(length(Some(10.0)) < length(Some(0.2)) && length(Some(0.2)) < length(None));
}

#[test]
fn rrt_star_costs_what_the_study_says() {
    costs_are(&hard1(), &star(None), 3.83, 2.56);
    costs_are(&hard3(), &star(None), 3.85, 2.75);
}

#[test]
fn rrt_star_with_a_ball_of_30_cm_costs_what_the_study_says() {
    costs_are(&hard1(), &star(Some(0.3)), 2.751, 2.516);
    costs_are(&hard3(), &star(Some(0.3)), 2.896, 2.715);
}

#[test]
fn paths_are_valid_in_both_engines_and_trees_differ() {
    for (scene, planner) in [hard1(), hard3()].iter().flat_map(|s| every_planner().map(move |p| (s, p))) {
        let engines: [Box<dyn Checker>; 2] = [
            Box::new(GjkEngine::new(scene, Interference::Exact).unwrap()),
            Box::new(CspaceEngine::new(scene, Interference::Exact).unwrap()),
        ];
        for seed in 0..10 {
            let found = planned(scene, &planner, seed);
            assert_eq!(found.status, Status::Solved, "{planner:?}, seed {seed}");
            for path in [&found.raw_waypoints(), &found.waypoints()] {
                assert_eq!((path[0], path[path.len() - 1]), (scene.start().unwrap(), scene.goal().unwrap()));
                let valid = |pair: &[Point]| engines.iter().all(|e| e.motion_valid(&pair[0], &pair[1]));
                assert!(path.windows(2).all(valid), "{planner:?}, seed {seed}");
            }
            assert_eq!(found.waypoints(), planned(scene, &planner, seed).waypoints());
            // Compare only the tree of the anytime planner: string pulling may give the same path for any seed.
            assert_ne!(found.tree.states, planned(scene, &planner, seed + 100).tree.states);
        }
    }
}

#[test]
fn both_engines_lead_to_the_same_path() {
    for planner in every_planner() {
        let by = |engine| {
            let options = PlanOptions { planner: planner.clone(), engine, seed: 2, ..PlanOptions::paper() };
            plan(&hard1(), &options, &|| false).unwrap().result.waypoints()
        };
        assert_eq!(by(Engine::Cspace), by(Engine::Gjk), "{planner:?}");
    }
}

#[test]
fn edges_of_rrt_are_at_most_a_step_long() {
    let settings = PlannerSettings { max_samples: Some(500_000), ..PlannerSettings::default() };
    let path = planned(&hard1(), &PlannerOptions::new(Planner::Rrt, 0.07, &settings).unwrap(), 1).raw_waypoints();
    assert!(path.windows(2).all(|pair| (pair[1] - pair[0]).norm() < 0.07 + 1e-12));
}

#[test]
fn a_goal_within_one_step_is_tried_at_once() {
    for planner in every_planner() {
        let start = Point::new(0.3, 1.0, 0.3);
        let options = PlanOptions { planner, ..PlanOptions::paper() };
        let hard1 = hard1();
        let from_there = Query::of(&hard1).starting_at(start);
        let found = plan(from_there.to(Point::new(0.35, 1.0, 0.3)), &options, &|| false).unwrap().result;
        assert_eq!((found.raw_waypoints().len(), found.stats.samples, found.stats.motion_checks), (2, 0, 1));
        assert_eq!(plan(from_there.to(start), &options, &|| false).unwrap().result.cost, 0.0);
    }
}

/// The planner continues to this cost or this number of samples.
fn going_on(planner: Planner, target_cost: Option<f64>, samples: usize) -> PlannerOptions {
    let settings = PlannerSettings {
        max_samples: Some(samples),
        keep_going: true,
        target_cost,
        near_radius: (planner == Planner::RrtStar).then_some(0.3),
        ..PlannerSettings::default()
    };
    PlannerOptions::new(planner, 0.1, &settings).unwrap()
}

#[test]
fn every_better_path_is_reported() {
    let hard1 = hard1();
    let engine = CspaceEngine::new(&hard1, Interference::Exact).unwrap();
    for (planner, name, _) in Planner::ALL {
        let options = PlanOptions { planner: going_on(*planner, None, 20_000), seed: 1, ..PlanOptions::paper() };
        let improvements = Improvements::default();
        let found = plan(&hard1, &options, &improvements).unwrap().result;
        let reported = improvements.reported();
        assert!(reported.last().is_some_and(|(_, _, path)| *path == found.raw_waypoints()), "{name}");
        assert!(found.history.iter().map(|at| (at.seconds, at.cost)).eq(reported.iter().map(|at| (at.0, at.1))));
        for (_, cost, path) in reported {
            assert!(
                (path_length(&path) - cost).abs() < 1e-12
                    && path_check::first_invalid_segment(&engine, &path).is_none()
            );
        }
    }
}

#[test]
fn keep_going_never_costs_more_and_stops_at_its_target() {
    for (planner, samples) in [(Planner::ModifiedRrt, 4000), (Planner::RrtStar, 30_000)] {
        for seed in 0..5 {
            let cost = |planner: &PlannerOptions| planned(&hard1(), planner, seed).raw_cost;
            let mut first = PlannerOptions::new(planner, 0.1, &PlannerSettings::default()).unwrap();
            if let Method::RrtStar(star) = &mut first.method {
                star.near_radius = Some(0.3);
            }
            let short = planned(&hard1(), &going_on(planner, None, samples), seed);
            assert!(short.raw_cost < cost(&first) && short.stats.samples == samples, "{planner:?}, seed {seed}");
            assert!(cost(&going_on(planner, None, 2 * samples)) <= short.raw_cost);
            let target = short.raw_cost + 1e-9;
            let reached = planned(&hard1(), &going_on(planner, Some(target), samples), seed);
            assert!(reached.raw_cost <= target && reached.stats.samples <= samples);
        }
    }
}

#[test]
fn the_search_tree_is_kept_and_holds_the_path() {
    let engine = CspaceEngine::new(&hard1(), Interference::Exact).unwrap();
    for planner in every_planner() {
        let found = planned(&hard1(), &planner, 4);
        let tree = &found.tree;
        assert_eq!((tree.states.len(), tree.parents.len()), (found.stats.nodes, found.stats.nodes));
        let two_trees = matches!(planner.planner(), Planner::Anytime | Planner::TwoTrees | Planner::RrtConnect);
        assert_eq!(tree.edges().count(), found.stats.nodes - if two_trees { 2 } else { 1 }); // all but the roots
        assert!(tree.edges().all(|[from, to]| engine.motion_valid(from, to)));
        if two_trees {
            continue; // the path passes from one to the other, or was made shorter
        }
        let mut node = tree.states.len() - 1;
        let mut way = vec![tree.states[node]];
        while tree.parents[node] != node {
            node = tree.parents[node];
            way.push(tree.states[node]);
        }
        way.reverse();
        assert_eq!(way, found.raw_waypoints());
    }
    let hard1 = hard1();
    let outside = Query::of(&hard1).starting_at(Point::new(9.0, 1.0, 1.0));
    assert!(plan(outside, &PlanOptions::paper(), &|| false).unwrap().result.tree.states.is_empty());
}

#[test]
fn nodes_time_and_interruption_end_every_planner() {
    let mut spec = paper_scene("walled", vec![block("wall", [0.05, 2.0, 2.0], [1.0, 1.0, 1.0])]);
    spec.ignore = (0..8).map(|k| [format!("cable {k}"), "wall".to_string()]).collect();
    let wall = scene(spec);
    for mut planner in every_planner() {
        planner.limits = SearchLimits { max_samples: usize::MAX, max_nodes: 20, until: Until::FirstPath };
        let options = PlanOptions { planner: planner.clone(), proof: false, ..PlanOptions::paper() };
        let found = plan(&wall, &options, &()).unwrap().result;
        assert_eq!((found.status, found.stats.nodes), (Status::BudgetSpent, 20));
        planner.limits.max_nodes = usize::MAX;
        let options = PlanOptions { planner, budget: Some(Duration::from_millis(30)), ..options };
        let clock = Instant::now();
        assert_eq!(plan(&wall, &options, &|| false).unwrap().result.status, Status::BudgetSpent);
        let asked = plan(&wall, &PlanOptions { budget: None, ..options }, &|| clock.elapsed().as_millis() > 100);
        let found = asked.unwrap().result;
        assert!(found.status == Status::Interrupted && found.stats.samples > 0 && clock.elapsed().as_secs() < 5);
        assert_eq!(found.unless_interrupted().unwrap_err().class(), cdpr_core::ErrorClass::Interrupted);
    }
}

#[test]
fn extreme_options_never_panic() -> Result<(), Error> {
    let scene = empty();
    let engine = CspaceEngine::new(&scene, Interference::Exact)?;
    let space = TranslationSpace::of(engine.conditions());
    let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
    for number in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e300, 5e-324] {
        let limits = SearchLimits::samples(200);
        let (step, goal_bias) = (number, number);
        let rrt = Method::Rrt(RrtOptions { step, goal_bias, check_goal: false });
        let star = Method::RrtStar(RrtStarOptions { step, goal_bias, near_radius: Some(number), near_cap: None });
        for method in [rrt, star] {
            let planner = PlannerOptions { limits, method };
            let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
            let found = planner.search(
                &problem,
                &engine,
                &StringPuller::new(&engine),
                &|_, _, _| {},
                &mut rng,
                &Watch::NONE,
            )?;
            assert!(found.samples <= 200);
            assert!(found.waypoints.windows(2).all(|pair| engine.motion_valid(&pair[0], &pair[1])));
        }
    }
    Ok(())
}
