//! Via points, several goals and boxes of goals: against paths planned one by one, and against random goals.

use std::f64::consts::FRAC_PI_2;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use cdpr_core::collision::path_check::first_invalid_segment;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Pose, Rotation, Vector, wxyz};
use cdpr_core::model::spec::TurningSpec;
use cdpr_core::model::{PositionSource, SceneSpec, StationSpec};
use cdpr_core::path::length;
use cdpr_core::plan::{Appraisal, PlanOptions, Planned, Post, Query, Route, plan, plan_route};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, StateSpace, Status, TranslationSpace};
use cdpr_core::testing;
use cdpr_core::trajectory::{Minimise, plan_timed};
use cdpr_core::watch::Watch;
use cdpr_core::{Choice, PathFile, Scene};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn compiled(scene: &Scene) -> CompiledScene {
    CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).unwrap()
}

fn via(places: &[[f64; 3]]) -> Route {
    Route { via: places.iter().map(|place| (*place).into()).collect(), ..Route::default() }
}

fn goals(places: &[[f64; 3]]) -> Route {
    Route { goals: places.iter().map(|place| (*place).into()).collect(), ..Route::default() }
}

fn into_box(least: [f64; 3], most: [f64; 3]) -> Route {
    Route { goal_box: Some([least.into(), most.into()]), ..Route::default() }
}

fn find(scene: &Scene, route: &Route) -> Planned {
    found_with(scene, route, &PlanOptions::default())
}

fn found_with(scene: &Scene, route: &Route, options: &PlanOptions) -> Planned {
    let planned = plan_route(scene, route, options, &()).unwrap();
    if planned.result.status == Status::Solved {
        let engine = compiled(&planned.scene);
        engine.ready_for(&planned.result.path).unwrap();
        assert_eq!(first_invalid_segment(&engine, &planned.result.path), None);
        assert!((planned.result.cost - length(&planned.scene, &planned.result.path)).abs() < 1e-12);
        assert!(planned.result.lower_bound.is_none_or(|bound| bound <= planned.result.cost));
        let ends = Query::of(&planned.scene).poses().unwrap();
        let path = &planned.result.path;
        assert_eq!([path[0].position, path[path.len() - 1].position], ends.map(|end| end.position));
    }
    planned
}

fn refused(scene: &Scene, route: &Route, options: &PlanOptions) -> String {
    plan_route(scene, route, options, &()).unwrap_err().to_string()
}

fn valid_places(scene: &Scene, count: usize, seed: u64) -> Vec<[f64; 3]> {
    let engine = compiled(scene);
    let space = TranslationSpace::of(engine.level().conditions());
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let valid = std::iter::repeat_with(|| space.sample(&mut rng).unwrap()).filter(|p| engine.level().state_valid(p));
    valid.take(count).map(Into::into).collect()
}

#[test]
fn every_planner_passes_its_via_points() {
    for scene in [testing::hard1(), testing::empty()] {
        for (planner, name, _) in Planner::ALL {
            let options = PlanOptions { planner: PlannerOptions::of(*planner), seed: 2, ..PlanOptions::default() };
            let places = [[0.4, 0.8, 1.5], [1.0, 1.0, 1.8], [1.6, 1.2, 1.6]];
            let planned = found_with(&scene, &via(&places), &options);
            let found = &planned.result;
            assert_eq!(found.status, Status::Solved, "{name}");
            let route = found.route.clone().unwrap();
            let passed: Vec<[f64; 3]> = route.via.iter().map(|k| found.path[*k].position.into()).collect();
            assert_eq!(passed, places, "{name}");
            assert!(route.via.is_sorted() && route.goal.is_none() && route.leg.is_none());
            // The legs are those that are planned one by one.
            let stops: Vec<Point> = [scene.start().unwrap()]
                .into_iter()
                .chain(places.map(Point::from))
                .chain([scene.goal().unwrap()])
                .collect();
            let legs =
                stops.windows(2).map(|ends| plan(Query::of(&scene).starting_at(ends[0]).to(ends[1]), &options, &()));
            let alone: Vec<_> = legs.map(|leg| leg.unwrap().result).collect();
            assert!((found.cost - alone.iter().map(|leg| leg.cost).sum::<f64>()).abs() < 1e-12, "{name}");
            let raw: f64 = alone.iter().map(|leg| leg.raw_cost).sum();
            assert!((found.raw_cost - raw).abs() < 1e-12 && found.raw_cost >= found.cost - 1e-12, "{name}");
            assert_eq!(found.stats.samples, alone.iter().map(|leg| leg.stats.samples).sum::<usize>(), "{name}");
            assert!(*planner != Planner::Anytime || found.lower_bound.unwrap() > 0.99 * found.cost);
        }
    }
}

#[test]
fn a_via_point_may_be_the_start_or_come_twice() {
    let scene = testing::hard1();
    let start: [f64; 3] = scene.start().unwrap().into();
    let direct = plan(&scene, &PlanOptions::default(), &()).unwrap().result;
    let found = find(&scene, &via(&[start, start])).result;
    assert_eq!(found.status, Status::Solved);
    assert!((found.cost - direct.cost).abs() < 1e-12);
    let back = find(&scene, &via(&[[1.7, 1.0, 1.7], start])).result;
    assert!((back.cost - 3.0 * direct.cost).abs() < 1e-2 * direct.cost, "{} {}", back.cost, direct.cost);
}

#[test]
fn of_several_goals_the_one_with_the_shortest_path_is_reached() {
    let scene = testing::hard3();
    let one_per_cent = PlannerSettings { gap: Some(0.01), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, 0.1, &one_per_cent).unwrap();
    let options = PlanOptions { planner, ..PlanOptions::default() };
    for seed in 0..10 {
        let places = valid_places(&scene, 4, seed);
        let planned = found_with(&scene, &goals(&places), &options);
        let found = planned.result;
        let alone = places.iter().map(|goal| plan(Query::of(&scene).to((*goal).into()), &options, &()).unwrap().result);
        let costs: Vec<f64> = alone.map(|leg| leg.cost).collect();
        let least = costs.iter().copied().fold(f64::INFINITY, f64::min);
        assert!((found.cost - least).abs() < 1e-12, "{seed}: {} {costs:?}", found.cost);
        let goal = found.route.unwrap().goal.unwrap();
        assert_eq!(planned.scene.goal(), Some(places[goal].into()));
        assert_eq!(costs[goal], least);
        // No bound of a goal alone may be below that of all, and every path to a goal is above it.
        let bound = found.lower_bound.unwrap();
        assert!(bound <= least && bound > 0.9 * least, "{seed}: {bound} {least}");
    }
}

#[test]
fn bounds_of_long_paths_hold_for_short_ones() {
    let planner = PlannerOptions::of(Planner::Rrt);
    let poor = PlanOptions { planner, post: Some(Post::None), ..PlanOptions::default() };
    for (scene, seed) in [(testing::hard1(), 1), (testing::hard3(), 2)] {
        let places = valid_places(&scene, 3, seed);
        let goal: [f64; 3] = scene.goal().unwrap().into();
        let routes = [via(&places), goals(&places), Route { via: vec![places[0].into()], ..goals(&[places[1], goal]) }];
        for route in routes {
            let long = found_with(&scene, &route, &poor).result;
            let short = find(&scene, &route).result;
            assert!(long.cost > 1.05 * short.cost, "{} {}", long.cost, short.cost);
            let [long, short] = [long.lower_bound.unwrap(), short.cost];
            assert!(long <= short && long > 0.9 * short, "{long} {short} {route:?}");
        }
    }
}

#[test]
fn no_random_goal_in_a_box_is_nearer() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    for (scene, least, most) in [
        (testing::hard1(), [1.5, 0.8, 0.2], [1.9, 1.2, 0.4]),
        (testing::hard1(), [0.2, 0.2, 0.2], [1.8, 0.5, 1.8]),
        (testing::hard3(), [1.2, 0.6, 0.3], [1.8, 1.4, 1.6]),
        (testing::hard1(), [0.9, 0.9, 0.2], [1.9, 1.1, 1.9]), // with the pillar in it
    ] {
        let found = find(&scene, &into_box(least, most)).result;
        assert_eq!(found.status, Status::Solved);
        let end = found.path.last().unwrap().position;
        assert!((0..3).all(|axis| (least[axis]..=most[axis]).contains(&end[axis])), "{end}");
        let bound = found.lower_bound.unwrap();
        for _ in 0..40 {
            let goal = Point::from([0, 1, 2].map(|axis| rng.random_range(least[axis]..=most[axis])));
            let other = plan(Query::of(&scene).to(goal), &PlanOptions::default(), &()).unwrap().result;
            if other.status == Status::Solved {
                assert!(found.cost <= other.cost * (1.0 + 1e-6), "{} {} to {goal}", found.cost, other.cost);
                assert!(bound <= other.cost);
            }
        }
    }
}

#[test]
fn boxes_may_be_flat_hold_the_start_or_nothing_valid() {
    let scene = testing::hard1();
    let direct = plan(&scene, &PlanOptions::default(), &()).unwrap().result;
    let goal: [f64; 3] = scene.goal().unwrap().into();
    assert_eq!(find(&scene, &into_box(goal, goal)).result.cost, direct.cost);
    let here = find(&scene, &into_box([0.2, 0.9, 0.2], [0.4, 1.1, 0.4])).result;
    assert_eq!((here.status, here.cost, here.lower_bound), (Status::Solved, 0.0, Some(0.0)));
    let inside = find(&scene, &into_box([0.95, 0.95, 0.9], [1.05, 1.05, 1.0])).result;
    assert_eq!(inside.status, Status::GoalInvalid);
    assert!(inside.reason().unwrap().sentence().contains("pillar"));
    for wrong in [into_box([1.0, 0.0, 0.0], [0.0, 1.0, 1.0]), into_box([f64::NAN; 3], [1.0; 3])] {
        assert!(refused(&scene, &wrong, &PlanOptions::default()).starts_with("goal_box"));
    }
    let both = Route { goals: vec![goal.into()], ..into_box(goal, goal) };
    assert_eq!(refused(&scene, &both, &PlanOptions::default()), "goal_box: found with a goal, expected one of the two");
}

#[test]
fn a_route_combines_via_points_with_several_goals_and_boxes() {
    let scene = testing::hard1();
    let over = [1.0, 1.0, 1.8];
    let two = Route { via: vec![over.into()], ..goals(&[[0.3, 1.0, 0.3], [1.7, 1.0, 1.7]]) };
    let found = find(&scene, &two).result;
    assert_eq!(found.route.unwrap().goal, Some(1));
    let boxed = Route { via: vec![over.into()], ..into_box([1.5, 0.8, 0.2], [1.9, 1.2, 0.4]) };
    let found = find(&scene, &boxed).result;
    assert_eq!(found.path[found.route.clone().unwrap().via[0]].position, Point::from(over));
    let end = found.path.last().unwrap().position;
    let straight = (Point::from(over) - scene.start().unwrap()).norm() + (end - Point::from(over)).norm();
    assert!(found.cost >= straight && found.lower_bound.unwrap() <= straight);
}

#[test]
fn what_cannot_be_reached_is_named() {
    let scene = testing::hard1();
    let found = find(&scene, &via(&[[0.3, 1.0, 1.0], [1.0, 1.0, 1.0], [1.7, 1.0, 1.0]])).result;
    assert_eq!((found.status, found.route.clone().unwrap().leg), (Status::GoalInvalid, Some([1, 4])));
    assert!(found.reason().unwrap().sentence().contains("pillar") && found.nearest_valid.is_some());
    let walled = Scene::new(testing::walled(0.94)).unwrap();
    let found = find(&walled, &via(&[walled.start().unwrap().into()])).result;
    assert_eq!((found.status, found.route.unwrap().leg), (Status::NoPath, Some([1, 2])));
    let none = find(&scene, &goals(&[[1.0, 1.0, 1.0], [1.0, 1.0, 1.1]])).result;
    assert_eq!((none.status, none.route.unwrap().goal), (Status::GoalInvalid, Some(0)));
    let one = find(&scene, &goals(&[[1.0, 1.0, 1.0], [1.7, 1.0, 1.7]])).result;
    assert_eq!((one.status, one.route.unwrap().goal), (Status::Solved, Some(1)));
    let unknown = Route { via: vec![PositionSource::Named("rack".to_string())], ..Route::default() };
    assert!(refused(&scene, &unknown, &PlanOptions::default()).starts_with("via[0]: found \"rack\""));
    let settings = PlannerSettings { target_cost: Some(3.0), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, 0.1, &settings).unwrap();
    let aimed = PlanOptions { planner, ..PlanOptions::default() };
    assert!(refused(&scene, &via(&[[1.0, 1.0, 1.8]]), &aimed).starts_with("target_cost"));
}

#[test]
fn a_platform_that_turns_has_the_orientation_of_the_station_there() {
    let yawed = Rotation::from_scaled_axis(Vector::z() * 0.2);
    let station = |name: &str, position, orientation| StationSpec { name: name.to_string(), position, orientation };
    let stations =
        vec![station("turned", [0.4, 1.0, 1.5], Some(wxyz(&yawed).into())), station("plain", [1.0, 1.0, 1.8], None)];
    let turning = Some(TurningSpec::default());
    let scene = Scene::new(SceneSpec { stations, turning, ..testing::hard1().spec().clone() }).unwrap();
    let names = ["turned", "plain"].map(|name| PositionSource::Named(name.to_string()));
    let planned = find(&scene, &Route { via: names.to_vec(), ..Route::default() });
    let found = planned.result;
    assert_eq!(found.status, Status::Solved);
    let at: Vec<Pose> = found.route.unwrap().via.iter().map(|k| found.path[*k]).collect();
    assert!(at.iter().all(|pose| pose.orientation.angle_to(&yawed) < 1e-12));
    assert!(found.path.last().unwrap().orientation.angle() < 1e-12 && found.lower_bound.is_none());
    let boxed = find(&scene, &into_box([1.5, 0.8, 1.2], [1.9, 1.2, 1.4])).result;
    assert_eq!(boxed.status, Status::Solved);
}

#[test]
fn an_open_orientation_is_chosen_for_the_whole_route() {
    let named = |name: &str, yaw| cdpr_core::model::OrientationSpec {
        name: name.to_string(),
        rpy: Some([0.0, 0.0, yaw]),
        ..Default::default()
    };
    let orientations = vec![named("across", FRAC_PI_2), named("along", 0.0)];
    let scene = Scene::new(SceneSpec { orientations, ..testing::hard1().spec().clone() }).unwrap();
    assert!(scene.orientation_is_open());
    let route = via(&[[0.4, 1.0, 1.6], [1.0, 1.0, 1.8]]);
    let each: Vec<f64> = scene.choices().iter().map(|scene| find(scene, &route).result.cost).collect();
    let planned = find(&scene, &route);
    let least = each.iter().copied().filter(|cost| cost.is_finite()).fold(f64::INFINITY, f64::min);
    assert!((planned.result.cost - least).abs() < 1e-12, "{each:?}");
    assert!(!planned.scene.orientation_is_open());
}

#[test]
fn an_interrupted_route_ends_with_what_it_has() {
    let scene = testing::hard3();
    let places = valid_places(&scene, 6, 3);
    let routes = [via(&places[..3]), goals(&places), into_box([1.2, 0.6, 0.3], [1.8, 1.4, 1.6])];
    for route in &routes {
        let polls = AtomicUsize::new(0);
        let count = || polls.fetch_add(1, Ordering::Relaxed);
        let whole = plan_route(&scene, route, &PlanOptions::default(), &|| count() == usize::MAX).unwrap().result;
        let all = polls.load(Ordering::Relaxed);
        for part in 0..12 {
            polls.store(0, Ordering::Relaxed);
            let stopped =
                plan_route(&scene, route, &PlanOptions::default(), &|| count() >= all * part / 12).unwrap().result;
            match stopped.status {
                Status::Solved => {
                    assert!(first_invalid_segment(&compiled(&scene), &stopped.path).is_none());
                    // The bound must hold for the path that the whole search finds.
                    assert!(stopped.lower_bound.is_none_or(|bound| bound <= whole.cost + 1e-12), "{route:?}");
                }
                status => assert_eq!(status, Status::Interrupted, "{part}"),
            }
        }
        for budget in [0, 1, 20] {
            let budget = Some(Duration::from_millis(budget));
            let found = found_with(&scene, route, &PlanOptions { budget, ..PlanOptions::default() }).result;
            assert!(matches!(found.status, Status::Solved | Status::BudgetSpent), "{:?}", found.status);
        }
    }
}

#[test]
fn files_and_motions_know_the_route() {
    let scene = testing::hard1();
    let places = [[0.4, 0.8, 1.5], [1.0, 1.0, 1.8]];
    let planned = find(&scene, &via(&places));
    let file = PathFile::planned(&scene, &PlanOptions::default(), &planned.result, &Appraisal::default());
    assert_eq!(serde_json::json!(file)["route"], serde_json::json!({"via": planned.result.route.clone().unwrap().via}));
    let direct = plan(&scene, &PlanOptions::default(), &()).unwrap().result;
    let file = PathFile::planned(&scene, &PlanOptions::default(), &direct, &Appraisal::default());
    assert!(serde_json::json!(file).get("route").is_none());
    // Every path among which the fastest is chosen passes the via points.
    let limits = cdpr_core::model::spec::MotionSpec {
        speed: Some(1.0),
        acceleration: Some(2.0),
        blend: Some(0.01),
        ..Default::default()
    };
    let (ends, compiled) = (Query::of(&scene).poses().unwrap(), planned.compiled.clone().unwrap());
    let how = (&PlanOptions::default(), Minimise::Time);
    let bound = planned.appraise(true, &Watch::NONE).unwrap().lower_bound;
    assert_eq!(bound, planned.result.lower_bound);
    let fastest = plan_timed(&compiled, ends, planned.result, how, &limits, &Watch::NONE).unwrap();
    assert!(fastest.tried > 2);
    let found = fastest.result;
    let passed: Vec<[f64; 3]> = found.route.unwrap().via.iter().map(|k| found.path[*k].position.into()).collect();
    assert_eq!(passed, places);
}
