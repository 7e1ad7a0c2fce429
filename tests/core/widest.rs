//! The widest path: known answers, agreement with planning at given clearances, proofs, determinism.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use cdpr_certify::check_certificate;
use cdpr_core::collision::Engine;
use cdpr_core::collision::path_check::{check_path, nearest};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::Point;
use cdpr_core::model::spec::{TurningSpec, WorkspaceSpec};
use cdpr_core::model::{ClearancesSpec, Member, OrientationSource, OrientationSpec, QuerySpec, Scene, SceneSpec};
use cdpr_core::path_file::PathFile;
use cdpr_core::plan::{
    Appraisal, FoundBy, PlanOptions, PlanResult, Query, Widest, plan, plan_widest, plan_widest_within,
};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::testing::{block, empty, hard1, hard3, paper_scene, scene, walled};
use cdpr_core::watch::Watch;
use cdpr_core::{CompiledScene, Interference, MotionSpec, Trajectory};

/// The wall of [`walled`], which is 0.9 m high and 0.1 m thick, between these ends. The platform is 0.05 m high, and its cables go up.
fn over_wall(ceiling: f64, start: [f64; 3], goal: [f64; 3]) -> SceneSpec {
    SceneSpec { query: Some(QuerySpec::between(start, goal)), ..walled(ceiling) }
}

fn planned(scene: &Scene) -> (PlanResult, Widest) {
    let found = plan_widest(scene, &PlanOptions::default(), &()).unwrap().result;
    let widest = found.widest.expect("there is a path");
    (found, widest)
}

/// Checks that the largest clearance is this one, m: the path keeps it within a millimetre, and the proof leaves no more.
#[track_caller]
fn is_widest(spec: SceneSpec, expected: f64) -> Widest {
    let scene = scene(spec);
    let (found, widest) = planned(&scene);
    let none_above = widest.none_above.unwrap();
    assert!(widest.clearance <= expected + 1e-8 && none_above >= expected, "{widest:?}, not {expected}");
    assert!(none_above - widest.clearance <= 1e-3, "{widest:?}");
    keeps(&scene, &found, widest.clearance);
    widest
}

/// Checks a path with the slow engine: in its own scene, and in that with the clearance that it is said to keep.
#[track_caller]
fn keeps(scene: &Scene, found: &PlanResult, clearance: f64) {
    let (path, ends) = (found.waypoints(), Query::of(scene).ends().unwrap());
    assert_eq!([path[0], path[path.len() - 1]], ends);
    for demanded in [0.0, clearance - 1e-8] {
        let wider = scene.with_obstacle_clearance(demanded).unwrap();
        let engine = engine_for(&wider, Engine::Gjk, Interference::Exact).unwrap();
        let report = check_path(&*engine, &path, &Watch::NONE).unwrap();
        assert!(report.valid, "{:?}", report.violations);
    }
}

#[test]
fn the_widest_path_within_a_length_is_between_the_shortest_and_the_widest() {
    for scene in [hard1(), hard3()] {
        let options = PlanOptions::default();
        let shortest = plan(&scene, &options, &()).unwrap().result.cost;
        let any = planned(&scene).1;
        let mut before = 0.0;
        for ratio in [1.0, 1.03, 4.0] {
            let found = plan_widest_within(&scene, ratio, &options, &()).unwrap().result;
            let widest = found.widest.unwrap();
            keeps(&scene, &found, widest.clearance);
            let (longest, none_above) = (widest.longest.unwrap(), widest.none_above.unwrap());
            assert!(found.cost <= longest && (longest - ratio * shortest).abs() < 1e-12, "{} {ratio}", scene.name());
            assert!(widest.clearance <= none_above && widest.clearance <= any.none_above.unwrap());
            // Lower bounds are a few per cent below the shortest paths, which is some millimetres of clearance.
            assert!(none_above - widest.clearance < 0.012, "{} {ratio}: {widest:?}", scene.name());
            assert!(widest.clearance >= before - 1e-3, "{} {ratio}: {widest:?}", scene.name());
            before = widest.clearance;
            // No path of this length with the proved clearance is found by other seeds and planners.
            let Ok(wider) = scene.with_obstacle_clearance(none_above) else { continue };
            for seed in 1..6 {
                let other = plan(&wider, &PlanOptions { seed, ..options.clone() }, &()).unwrap().result;
                assert!(other.status != Status::Solved || other.cost > longest, "{ratio}: {} {longest}", other.cost);
            }
        }
        assert!(before > any.clearance - 2e-3);
    }
}

#[test]
fn what_is_no_length_is_refused_and_what_has_no_path_is_said() {
    let options = PlanOptions::default();
    for ratio in [0.99, -1.0, f64::NAN, f64::INFINITY] {
        let refused = plan_widest_within(&hard1(), ratio, &options, &()).unwrap_err().to_string();
        assert!(refused.starts_with("within: found"), "{refused}");
    }
    let closed = scene(over_wall(0.94, [0.3, 1.0, 0.3], [1.7, 1.0, 0.3]));
    let found = plan_widest_within(&closed, 1.1, &options, &()).unwrap().result;
    assert_eq!((found.status, found.widest), (Status::NoPath, None));
    let free = plan_widest_within(&empty(), 1.1, &options, &());
    assert!(free.unwrap_err().to_string().starts_with("maximise"));
    let polls = AtomicUsize::new(0);
    let count = || polls.fetch_add(1, Ordering::Relaxed);
    plan_widest_within(&hard1(), 1.05, &options, &|| count() == usize::MAX).unwrap();
    let all = polls.load(Ordering::Relaxed);
    for part in [1, 4, 7] {
        polls.store(0, Ordering::Relaxed);
        let found = plan_widest_within(&hard1(), 1.05, &options, &|| count() >= all * part / 8).unwrap().result;
        if let Some(widest) = found.widest {
            keeps(&hard1(), &found, widest.clearance);
            assert!(found.cost <= widest.longest.unwrap());
        }
    }
}

#[test]
fn under_a_ceiling_the_room_over_a_wall_decides() {
    // The bottom of the platform is at 1.05 - 0.05 = 1.00 m at most.
    let widest = is_widest(over_wall(1.05, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]), 0.10);
    assert_eq!(widest.narrow_end, None);
    is_widest(over_wall(1.0, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]), 0.05);
}

#[test]
fn between_two_pillars_their_upper_edges_decide() {
    // 0.30 m between the pillars, 0.15 m of them for the platform. Cables do not count.
    let robot = walled(2.0).robot;
    let pillars =
        vec![block("left", [0.1, 0.85, 1.9], [1.0, 0.425, 0.95]), block("right", [0.1, 0.85, 1.9], [1.0, 1.575, 0.95])];
    let spec = SceneSpec { robot, ..paper_scene("gate", pillars) };
    let workspace = WorkspaceSpec { min: [0.0; 3], max: [2.0, 2.0, 1.99] };
    let query = QuerySpec::between([0.3, 1.0, 1.9], [1.7, 1.0, 1.9]);
    let spec = SceneSpec { workspace, query: Some(query), ..spec };
    let scene = scene(SceneSpec {
        clearances: Some(ClearancesSpec { cable_obstacle: Some(0.0), ..ClearancesSpec::default() }),
        ..spec
    });
    // Between the pillars it keeps 0.075 m; at the ceiling also 0.04 m from their tops, so that their edges are the nearest.
    let room = 0.075_f64.hypot(0.04);
    let (found, widest) = planned(&scene);
    assert!((widest.clearance..=widest.none_above.unwrap()).contains(&room), "{widest:?}");
    assert!(widest.none_above.unwrap() - widest.clearance <= 1e-3);
    keeps(&scene, &found, widest.clearance);
}

#[test]
fn no_path_keeps_more_than_its_ends() {
    // The bottom of the platform starts 0.075 m above the wall.
    let start = [1.0, 1.0, 1.0];
    let widest = is_widest(over_wall(2.0, start, [0.3, 1.0, 1.2]), 0.075);
    assert_eq!(widest.narrow_end, Some(0));
    assert_eq!(is_widest(over_wall(2.0, [0.3, 1.0, 1.2], start), 0.075).narrow_end, Some(1));
}

#[test]
fn pairs_that_may_touch_or_are_ignored_do_not_count() {
    // On the wall, the cables end 0.05 m above it and 0.025 m beside it; they touch nothing that the platform touches.
    let on_wall = over_wall(2.0, [1.0, 1.0, 0.925], [0.3, 1.0, 1.2]);
    let widest = is_widest(on_wall.clone(), 0.0);
    assert!(widest.none_above.unwrap() <= 1e-5);
    let pair = || vec![["platform".to_string(), "wall".to_string()]];
    let expected = 0.05_f64.hypot(0.025);
    is_widest(SceneSpec { touch: pair(), ..on_wall.clone() }, expected);
    is_widest(SceneSpec { ignore: pair(), ..on_wall }, expected);
}

#[test]
fn clearances_of_their_own_are_kept_and_the_others_grow() {
    let own = ClearancesSpec { platform_obstacle: Some(0.02), ..ClearancesSpec::default() };
    let scene = scene(SceneSpec { clearance: Some(0.01), clearances: Some(own), ..hard3().spec().clone() });
    let wider = scene.with_obstacle_clearance(0.3).unwrap();
    let of = |scene: &Scene, a, b| scene.pairs().clearance(a, b);
    let (obstacle, cable) = (Member::Obstacle(1), Member::Cable(2));
    assert_eq!(of(&wider, Member::Platform, obstacle), 0.02);
    assert_eq!(of(&wider, cable, obstacle), 0.3);
    assert_eq!([of(&wider, cable, Member::Cable(3)), of(&wider, cable, Member::Platform)], [0.01; 2]);
    assert_eq!(of(&scene.with_obstacle_clearance(0.001).unwrap(), cable, obstacle), 0.01); // never less than the scene asks for
}

#[test]
fn an_obstacle_that_carries_an_outlet_does_not_count_for_that_cable() {
    // The beam carries the outlet of a cable; its second part is 0.05 m from that outlet.
    let mut spec = over_wall(2.0, [0.3, 1.0, 1.2], [1.7, 1.0, 1.2]);
    spec.obstacles.push(block("beam", [0.1, 0.1, 0.1], [-0.05, -0.05, 2.05]));
    spec.obstacles.push(block("beam", [0.1, 0.1, 0.1], [-0.15, -0.05, 2.1]));
    let scene = scene(spec);
    let carried = scene.robot().cables().iter().position(|cable| cable.outlet == Point::new(0.0, 0.0, 2.0)).unwrap();
    let wider = scene.with_obstacle_clearance(0.04).unwrap();
    assert_eq!(wider.pairs().clearance(Member::Cable(carried), Member::Obstacle(1)), 0.0);
    assert_eq!(wider.pairs().clearance(Member::Cable(carried), Member::Obstacle(0)), 0.04);
    let (found, widest) = planned(&scene);
    assert!(widest.clearance > 0.05 && widest.none_above.unwrap() <= widest.clearance + 1e-3, "{widest:?}");
    keeps(&scene, &found, widest.clearance);
}

#[test]
fn the_path_keeps_what_it_says_and_the_certificate_is_accepted() {
    let scene = scene(over_wall(1.05, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]));
    let options = PlanOptions::default();
    let planned = plan_widest(&scene, &options, &()).unwrap();
    let widest = planned.result.widest.unwrap();
    let measured = planned.appraise(false, &Watch::NONE).unwrap().nearest.min_clearance.unwrap();
    assert_eq!(measured.value, widest.clearance);
    let certificate = planned.width_certificate(&options, &Watch::NONE).unwrap().unwrap();
    let text = serde_json::to_string(&certificate).unwrap();
    let without_path = planned.scene_without_path().unwrap().unwrap();
    assert_eq!(without_path.spec().clearance, widest.none_above);
    check_certificate(&without_path, &text, &Watch::NONE).unwrap();
    // With less clearance there is a path, and the certificate does not hold.
    let less = scene.with_obstacle_clearance(widest.clearance).unwrap();
    assert!(check_certificate(&less, &text, &Watch::NONE).is_err());
}

#[test]
fn planning_at_given_clearances_finds_nothing_wider() {
    for scene in [hard3(), scene(over_wall(1.05, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]))] {
        let (found, widest) = planned(&scene);
        keeps(&scene, &found, widest.clearance);
        for seed in 0..3 {
            let (mut low, mut high) = (0.0, 0.5);
            while high - low > 2e-4 {
                let middle = 0.5 * (low + high);
                let wider = scene.with_obstacle_clearance(middle).unwrap();
                let options =
                    PlanOptions { seed, planner: PlannerOptions::of(Planner::TwoTrees), ..PlanOptions::default() };
                let solved = plan(&wider, &options, &()).unwrap().result.status == Status::Solved;
                *(if solved { &mut low } else { &mut high }) = middle;
            }
            assert!(low < widest.none_above.unwrap() && widest.clearance >= low - 1e-3, "{low}, {widest:?}");
        }
    }
}

#[test]
fn the_pillar_of_hard1_leaves_an_eighth_of_a_metre() {
    let (found, widest) = planned(&hard1());
    assert!(widest.clearance > 0.124 && widest.none_above.unwrap() < 0.126, "{widest:?}");
    keeps(&hard1(), &found, widest.clearance);
    // The last search starts with the widest path; by itself, it would find none in 100 000 samples.
    assert!(found.found_by == FoundBy::Planner && found.stats.samples < 10_000, "{:?}", found.stats);
}

#[test]
fn the_seed_determines_the_answer_for_any_number_of_threads() {
    let scene = scene(over_wall(1.05, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]));
    for planner in [Planner::Anytime, Planner::RrtConnect, Planner::ModifiedRrt] {
        let options = PlanOptions { seed: 5, planner: PlannerOptions::of(planner), ..PlanOptions::default() };
        let answer = || {
            let mut found = plan_widest(&scene, &options, &()).unwrap().result;
            (found.stats, found.history) = (Default::default(), Vec::new());
            serde_json::to_string(&PathFile::planned(&scene, &options, &found, &Appraisal::default())).unwrap()
        };
        let first = answer();
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            assert_eq!(pool.install(answer), first, "{planner:?}, {threads} threads");
        }
    }
}

#[test]
fn without_a_path_the_answer_is_that_of_planning() {
    let none = scene(walled(0.94));
    let found = plan_widest(&none, &PlanOptions::default(), &()).unwrap().result;
    assert_eq!((found.status, found.widest), (Status::NoPath, None));
    assert_eq!(found.no_path.unwrap().blocking, ["wall"]);
    let inside = hard1();
    let query = Query::of(&inside).to(Point::new(1.0, 1.0, 1.0));
    let found = plan_widest(query, &PlanOptions::default(), &()).unwrap().result;
    assert_eq!((found.status, found.widest), (Status::GoalInvalid, None));
    assert!(!found.reasons.is_empty());
}

#[test]
fn questions_without_an_answer_are_refused() {
    let refused = |scene: &Scene, options: &PlanOptions| {
        let error = plan_widest(scene, options, &()).map(|found| found.result.status).unwrap_err();
        assert_eq!(error.place(), Some("maximise"), "{error}");
        error.to_string()
    };
    let usual = PlanOptions::default();
    assert!(refused(&empty(), &usual).contains("no pair with an obstacle"));
    assert!(refused(&hard1(), &PlanOptions { proof: false, ..usual.clone() }).contains("without proofs"));
    let turning = scene(SceneSpec { turning: Some(TurningSpec::default()), ..hard1().spec().clone() });
    assert!(refused(&turning, &usual).contains("may turn"));
}

#[test]
fn the_widest_of_all_orientations_wins() {
    // A plate that is 0.15 m wide in one direction and 0.05 m in the other, under a ceiling.
    let upright = OrientationSource::Quaternion([0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt(), 0.0]);
    let spec = over_wall(1.15, [0.3, 1.0, 0.8], [1.7, 1.0, 0.8]);
    let named = |name: &str, quaternion: [f64; 4]| OrientationSpec {
        name: name.to_string(),
        quaternion: Some(quaternion),
        ..OrientationSpec::default()
    };
    let OrientationSource::Quaternion(turn) = upright else { unreachable!("just made") };
    let orientations = vec![named("upright", turn), named("flat", [1.0, 0.0, 0.0, 0.0])];
    let scene = scene(SceneSpec { orientations, ..spec });
    let planned = plan_widest(&scene, &PlanOptions::default(), &()).unwrap();
    let widest = planned.result.widest.unwrap();
    let at: Vec<Widest> = scene
        .choices()
        .iter()
        .filter_map(|one| plan_widest(one, &PlanOptions::default(), &()).unwrap().result.widest)
        .collect();
    let best = at.iter().map(|one| one.clearance).fold(0.0, f64::max);
    let above = at.iter().filter_map(|one| one.none_above).fold(0.0, f64::max);
    assert_eq!((widest.clearance, widest.none_above), (best, Some(above)));
    assert_eq!(planned.scene.orientation_name(), Some("flat"));
}

#[test]
fn an_interruption_keeps_the_widest_path_so_far() {
    let scene = scene(over_wall(1.05, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]));
    let polls = AtomicUsize::new(0);
    let stop_after = |most: usize| {
        polls.store(0, Ordering::Relaxed);
        let stop = || polls.fetch_add(1, Ordering::Relaxed) >= most;
        plan_widest(&scene, &PlanOptions::default(), &stop).unwrap().result
    };
    stop_after(usize::MAX);
    let all = polls.load(Ordering::Relaxed);
    let mut solved = 0;
    for most in (0..all).step_by((all / 40).max(1)) {
        let found = stop_after(most);
        match found.widest {
            None => assert_eq!(found.status, Status::Interrupted),
            Some(widest) => {
                solved += 1;
                assert!(
                    widest.clearance <= 0.1 + 1e-8 && widest.none_above.is_none_or(|none| none >= 0.1),
                    "{widest:?}"
                );
                keeps(&scene, &found, widest.clearance);
            }
        }
    }
    assert!(solved > 20, "{solved}");
}

#[test]
fn wrenches_stay_demanded() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../testdata/scenes/acrobot.toml");
    let scene = cdpr_files::Loader::new(Watch::NONE).scene(std::path::Path::new(file)).unwrap();
    let options = PlanOptions { budget: Some(std::time::Duration::from_millis(1500)), ..PlanOptions::default() };
    let planned = plan_widest(&scene, &options, &()).unwrap();
    let compiled = CompiledScene::new(&scene, Engine::Gjk, Interference::Exact, &Watch::NONE).unwrap();
    let widest = planned.result.widest.unwrap();
    assert!(check_path(compiled.level(), &planned.result.waypoints(), &Watch::NONE).unwrap().valid);
    let measured = nearest(compiled.level(), &planned.result.waypoints(), &Watch::NONE).unwrap().min_clearance.unwrap();
    assert!(measured.value <= widest.clearance && widest.clearance > 0.002, "{widest:?}");
    assert!(planned.appraise(false, &Watch::NONE).unwrap().wrench.is_some());
}

/// The way leads through a gap of a few centimetres between what the column and what the required wrenches forbid.
#[test]
fn with_wrenches_the_start_of_cogiro_decides() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../testdata/scenes/cogiro.toml");
    let scene = cdpr_files::load_scene(std::path::Path::new(file)).unwrap();
    for seed in 0..3 {
        let found = plan_widest(&scene, &PlanOptions { seed, ..PlanOptions::default() }, &()).unwrap().result;
        let widest = found.widest.unwrap();
        assert!(widest.none_above.unwrap() - widest.clearance <= 1e-3 && widest.narrow_end == Some(0), "{widest:?}");
        let wider = scene.with_obstacle_clearance(widest.clearance - 1e-8).unwrap();
        let compiled = CompiledScene::new(&wider, Engine::Gjk, Interference::Exact, &Watch::NONE).unwrap();
        assert!(check_path(compiled.level(), &found.waypoints(), &Watch::NONE).unwrap().valid);
    }
}

/// A scene compiled with another start: the ends are those of the query.
#[test]
fn the_scene_may_have_been_compiled_with_other_ends() {
    let spec = over_wall(1.05, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]);
    let other = SceneSpec { query: Some(QuerySpec::between([0.4, 1.0, 0.6], [0.3, 1.2, 0.6])), ..spec.clone() };
    let (scene, other) = (scene(spec), scene(other));
    let compiled = CompiledScene::new(&other, Default::default(), Default::default(), &Watch::NONE).unwrap();
    let compiled = std::sync::Arc::new(compiled);
    let alone = plan_widest(&scene, &PlanOptions::default(), &()).unwrap().result;
    let shared = plan_widest(Query::of(&scene).by(&compiled), &PlanOptions::default(), &()).unwrap().result;
    assert_eq!((alone.widest, alone.path), (shared.widest, shared.path));
}

#[test]
fn a_budget_leaves_time_to_widen_within_a_length() {
    let scene = scene(over_wall(1.5, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]));
    let options = PlanOptions { budget: Some(Duration::from_secs(6)), ..PlanOptions::default() };
    let found = plan_widest_within(&scene, 1.2, &options, &()).unwrap().result;
    let widest = found.widest.unwrap();
    assert!(widest.clearance > 0.02, "{widest:?}");
    keeps(&scene, &found, widest.clearance);
    assert!(found.stats.planning_seconds > 2.9, "the first half counts too: {:?}", found.stats);
}

/// Of the second orientation no path is known beforehand.
#[test]
fn a_budget_leaves_time_to_widen_within_a_length_at_each_orientation() {
    let turned = |name: &str, angle: f64| OrientationSpec {
        name: name.to_string(),
        quaternion: Some([(angle / 2.0).cos(), 0.0, 0.0, (angle / 2.0).sin()]),
        ..OrientationSpec::default()
    };
    let spec = over_wall(1.5, [0.3, 1.0, 0.6], [1.7, 1.0, 0.6]);
    let scene = scene(SceneSpec { orientations: vec![turned("ahead", 0.0), turned("aside", 1e-3)], ..spec });
    let options = PlanOptions { budget: Some(Duration::from_secs(6)), ..PlanOptions::default() };
    let found = plan_widest_within(&scene, 1.2, &options, &()).unwrap().result;
    let widest = found.widest.unwrap();
    assert!(widest.clearance > 0.02 && widest.none_above.is_some(), "{widest:?}");
}

#[test]
fn a_motion_along_the_widest_path_keeps_its_width() {
    let limits = MotionSpec { speed: Some(1.0), acceleration: Some(1.0), blend: Some(0.3), ..MotionSpec::default() };
    let scene = hard3();
    let (found, widest) = planned(&scene);
    let compiled = CompiledScene::new(&scene, Engine::Cspace, Interference::Exact, &Watch::NONE).unwrap();
    let motion = |kept| Trajectory::keeping(&compiled, kept, &found.path, &limits, &Watch::NONE).unwrap();
    let wider = scene.with_obstacle_clearance(widest.clearance - 2e-6).unwrap();
    let slow = engine_for(&wider, Engine::Gjk, Interference::Exact).unwrap();
    let keeps = |motion: &Trajectory| {
        let places: Vec<Point> =
            (0..=2000).map(|k| motion.at(motion.duration() * k as f64 / 2000.0).position).collect();
        places.iter().all(|place| slow.state_valid(place))
    };
    let [wide, plain] = [Some(widest.clearance), None].map(motion);
    assert!(keeps(&wide) && !keeps(&plain), "round corners of the plain motion come nearer");
    assert!(wide.duration() > plain.duration());
    assert_eq!(motion(Some(0.0)).duration(), plain.duration());
}
