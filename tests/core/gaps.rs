//! Searches that prove how much longer than the shortest path their own is at most.

use cdpr_core::collision::{Checker, CspaceEngine, Interference};
use cdpr_core::limits::{BOUND_EFFORT, QUICK_BOUND_EFFORT};
use cdpr_core::model::{BodySpec, QuerySpec, RobotSource, Scene};
use cdpr_core::plan::PlanOptions;
use cdpr_core::planning::{Method, Planner, PlannerOptions, PlannerSettings, Problem, SearchLimits, TranslationSpace};
use cdpr_core::testing::{block, hard1};
use cdpr_core::watch::Watch;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::anytime::{Ignorant, planned, platform_only, random_scenes, seeded};

#[test]
fn a_search_with_a_gap_ends_despite_rounding() {
    let most = 200_000;
    let settings = PlannerSettings { gap: Some(0.01), max_samples: Some(most), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
    // In one of these scenes the bound is proved, but multiplied by the gap it is below the cost by rounding.
    (0..102u64).into_par_iter().for_each(|seed| {
        let scene = random_scenes(3).draw(seed).unwrap();
        let found = planned(&scene, &PlanOptions { planner: planner.clone(), ..seeded(0) });
        assert!(found.stats.samples < most, "scene {seed}: {} samples", found.stats.samples);
    });
}

/// The effort for a bound must not take the time for finding a shorter path: the bound of a path that is far too long
/// never comes near it. Without a budget, an unreachable gap must not keep the search from ending either.
#[test]
fn a_gap_never_costs_the_path_and_ends() {
    let obstacles = vec![
        block("shelf", [0.25, 0.5, 0.125], [1.125, 1.125, 1.3125]),
        block("low", [0.375, 0.375, 0.375], [0.9375, 0.3125, 1.0625]),
        block("high", [0.375, 0.375, 0.375], [0.9375, 0.3125, 1.4376]),
        block("bar", [0.5, 0.125, 0.125], [0.875, 1.0625, 1.3125]),
        block("wall", [0.25, 1.25, 1.5], [0.5, 0.625, 0.75]),
    ];
    let mut spec = platform_only(obstacles).spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("an inline robot") };
    robot.platform = vec![BodySpec { cuboid: Some([0.25, 0.25, 0.125]), ..BodySpec::default() }];
    robot.cables.truncate(1);
    (robot.cables[0].outlet, robot.cables[0].attachment) = ([1.0, 1.0, 9.0], [0.0, 0.0, 0.0625]);
    spec.ignore.retain(|[cable, _]| cable == "cable 0");
    spec.query = Some(QuerySpec::between([0.375, 0.25, 1.75], [1.5, 1.5, 0.875]));
    let scene = Scene::new(spec).unwrap();
    let planned = |seed: u64, gap: Option<f64>| {
        let settings = PlannerSettings { gap, ..PlannerSettings::default() };
        let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
        planned(&scene, &PlanOptions { seed, planner, ..PlanOptions::default() })
    };
    for seed in 0..6 {
        let without = planned(seed, None).cost;
        for gap in [1e-3, 1e-5] {
            let with = planned(seed, Some(gap));
            assert!(with.cost <= without * (1.0 + 1e-9), "{seed}: {} instead of {without}", with.cost);
            assert!(
                with.lower_bound.unwrap() * (1.0 + gap) >= with.cost * (1.0 - 1e-9),
                "{seed}: {:?}",
                with.lower_bound
            );
        }
    }
}

#[test]
fn an_unprovable_gap_is_retried_then_abandoned() {
    let scene = hard1();
    let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
    let space = TranslationSpace::of(engine.conditions());
    let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
    let efforts = |max_samples: usize| {
        let (limits, method) = (SearchLimits::samples(max_samples), Method::Anytime { gap: Some(1e-6) });
        let planner = PlannerOptions { limits, method };
        let (guide, mut rng) = (Ignorant::default(), ChaCha8Rng::seed_from_u64(0));
        planner.search(&problem, &engine, &guide, &|_, _, _| {}, &mut rng, &Watch::NONE).unwrap();
        guide.efforts.into_inner().unwrap()
    };
    // Without a limit, the search ends once the greatest effort was in vain.
    let asked = efforts(usize::MAX);
    assert_eq!((asked[0], asked.last()), (QUICK_BOUND_EFFORT, Some(&BOUND_EFFORT)), "{asked:?}");
    assert!(asked.windows(2).all(|pair| pair[1] <= 3 * pair[0]), "{asked:?}");
    let greatest = asked.iter().filter(|&&effort| effort == BOUND_EFFORT).count();
    assert_eq!(greatest, 1, "{asked:?}");
    // With one, the effort grows while the search goes on.
    let asked = efforts(20_000);
    assert!(asked.len() >= 3 && asked.iter().max() >= Some(&(9 * QUICK_BOUND_EFFORT)), "{asked:?}");
}
