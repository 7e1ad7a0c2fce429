//! Tours: their order against brute force, their paths against checks, what cannot be visited, interrupts.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use cdpr_core::Scene;
use cdpr_core::collision::check_path;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Rotation, Vector, wxyz};
use cdpr_core::model::{OrientationSource, RobotSource, SceneSpec, StationSpec};
use cdpr_core::path::length;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, StateSpace, Status, TranslationSpace};
use cdpr_core::testing::{self, block, paper_scene};
use cdpr_core::tour::{By, Order, Tour, TourFile, TourOptions, plan_tour};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::watch::Watch;
use cdpr_core::{MotionSpec, Recorded, Trajectory, TrajectoryRules, check_trajectory};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn compiled(scene: &Scene) -> Arc<CompiledScene> {
    Arc::new(CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).unwrap())
}

fn to_one_per_cent() -> PlanOptions {
    let settings = PlannerSettings { gap: Some(0.01), ..PlannerSettings::default() };
    let usual = PlanOptions::default();
    PlanOptions { planner: PlannerOptions::new(Planner::Anytime, usual.step, &settings).unwrap(), ..usual }
}

fn tour(scene: &Scene, wanted: &TourOptions) -> Tour {
    plan_tour(&compiled(scene), wanted, &to_one_per_cent(), &|| false, &|_, _| ()).unwrap()
}

fn refused(scene: &Scene, wanted: &TourOptions) -> String {
    plan_tour(&compiled(scene), wanted, &to_one_per_cent(), &|| false, &|_, _| ()).unwrap_err().to_string()
}

fn station(name: &str, position: [f64; 3]) -> StationSpec {
    StationSpec { name: name.to_string(), position, orientation: None }
}

/// A scene with valid stations, drawn at random: "0", "1", ...
fn with_stations(scene: &Scene, count: usize, seed: u64) -> Scene {
    let engine = compiled(scene);
    let space = TranslationSpace::of(engine.level().conditions());
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let valid = std::iter::repeat_with(|| space.sample(&mut rng).unwrap()).filter(|p| engine.level().state_valid(p));
    let stations = valid.take(count).enumerate().map(|(k, p)| station(&k.to_string(), p.into())).collect();
    Scene::new(SceneSpec { stations, ..scene.spec().clone() }).unwrap()
}

/// The least sum of legs over all orders, by trying them.
fn brute_force(tour: &Tour, start: Option<usize>, returns: bool) -> f64 {
    fn rest(tour: &Tour, order: &mut Vec<usize>, left: &mut Vec<usize>, returns: bool, best: &mut f64) {
        if left.is_empty() {
            let again = order.first().filter(|_| returns);
            let whole: Vec<usize> = order.iter().chain(again).copied().collect();
            let cost = |pair: &[usize]| tour.legs.between(pair[0], pair[1]).unwrap().0.weight();
            *best = best.min(whole.windows(2).map(cost).sum());
        }
        for k in 0..left.len() {
            order.push(left.remove(k));
            rest(tour, order, left, returns, best);
            left.insert(k, order.pop().unwrap());
        }
    }
    let count = tour.legs.stations.len();
    let starts: Vec<usize> = start.map_or_else(|| (0..count).collect(), |start| vec![start]);
    let mut best = f64::INFINITY;
    for start in starts {
        let mut left = (0..count).filter(|k| *k != start).collect();
        rest(tour, &mut vec![start], &mut left, returns, &mut best);
    }
    best
}

/// The path of a tour is valid, as long as its legs, and at its stations where it should be.
fn sound(scene: &Scene, tour: &Tour) {
    let engine = compiled(scene);
    assert!(check_path(&*engine, &tour.path, &Watch::NONE).unwrap().violations.is_empty());
    assert!((length(scene, &tour.path) - tour.cost).abs() < 1e-9);
    assert!(tour.lower_bound <= tour.cost);
    assert_eq!(tour.stops.len(), tour.order.len());
    assert!(tour.stops.windows(2).all(|pair| pair[0] < pair[1]));
    for (stop, waypoint) in tour.order.iter().zip(&tour.stops) {
        assert_eq!(tour.path[*waypoint].position, tour.legs.stations[*stop].position);
    }
}

#[test]
fn the_order_is_the_best_of_all() {
    for (seed, scene) in [testing::hard1(), testing::hard3()].iter().enumerate() {
        let scene = with_stations(scene, 6, seed as u64);
        for (start, returns) in [(None, false), (None, true), (Some(3), false), (Some(3), true)] {
            let wanted = TourOptions { start: start.map(|k: usize| k.to_string()), returns, ..TourOptions::default() };
            let found = tour(&scene, &wanted);
            sound(&scene, &found);
            let best = brute_force(&found, start, returns);
            assert!((found.cost - best).abs() < 1e-9, "{start:?} {returns}: {} {best}", found.cost);
            assert!(found.cost <= 1.0101 * found.lower_bound, "{} {}", found.cost, found.lower_bound);
            assert_eq!(found.order.first(), start.as_ref().or(found.order.first()));
            assert_eq!(returns, found.order.first() == found.order.last());
        }
    }
}

#[test]
fn legs_are_what_planning_finds() {
    let scene = with_stations(&testing::hard3(), 4, 7);
    let found = tour(&scene, &TourOptions::default());
    assert_eq!(found.legs.pairs.len(), 6);
    for ([a, b], leg) in found.legs.pairs.iter().zip(&found.legs.legs) {
        let [start, goal] = [a, b].map(|k| found.legs.stations[*k].position);
        let alone = plan(Query::of(&scene).starting_at(start).to(goal), &to_one_per_cent(), &()).unwrap().result;
        assert_eq!((&leg.path, leg.cost), (&alone.path, alone.cost));
    }
}

#[test]
fn a_given_order_is_kept_and_only_its_legs_are_planned() {
    let scene = with_stations(&testing::hard1(), 5, 3);
    let names = ["4", "1", "0"].map(String::from).to_vec();
    let wanted = TourOptions { stations: Some(names), order: Order::Given, ..TourOptions::default() };
    let found = tour(&scene, &wanted);
    sound(&scene, &found);
    let order = |tour: &Tour| tour.order.iter().map(|k| tour.legs.stations[*k].name.clone()).collect::<String>();
    assert_eq!((order(&found).as_str(), found.legs.pairs.len()), ("410", 2));
    let back = tour(&scene, &TourOptions { start: Some("1".to_string()), returns: true, ..wanted.clone() });
    sound(&scene, &back);
    assert_eq!((order(&back).as_str(), back.legs.pairs.len()), ("1041", 3));
    assert!(tour(&scene, &TourOptions { order: Order::Best, ..wanted.clone() }).cost <= found.cost);
    // There and back between two stations.
    let two =
        TourOptions { stations: wanted.stations.as_ref().map(|names| names[..2].to_vec()), returns: true, ..wanted };
    let there = tour(&scene, &two);
    sound(&scene, &there);
    assert_eq!(order(&there), "414");
    assert!((there.cost - 2.0 * there.legs.legs[0].cost).abs() < 1e-12);
}

#[test]
fn many_stations_are_close_to_the_bound_for_any_number_of_threads() {
    let scene = with_stations(&testing::hard3(), 20, 11);
    let file = |threads: usize| {
        let wanted = TourOptions { returns: true, threads: Some(threads), ..TourOptions::default() };
        let found = tour(&scene, &wanted);
        sound(&scene, &found);
        assert!(found.cost <= 1.03 * found.lower_bound, "{} {}", found.cost, found.lower_bound);
        serde_json::to_string(&TourFile::of(&scene, &found)).unwrap()
    };
    let [one, two, three] = [1, 2, 3].map(file);
    assert!(one == two && two == three);
}

#[test]
fn what_cannot_be_visited_is_named() {
    // A wall divides the box.
    let mut spec = paper_scene("divided", vec![block("wall", [0.1, 2.0, 2.0], [1.0, 1.0, 1.0])]);
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.cables.retain(|cable| cable.outlet[0] == 0.0);
    spec.stations = vec![
        station("left", [0.3, 0.5, 1.0]),
        station("left too", [0.3, 1.5, 1.0]),
        station("right", [1.7, 1.0, 1.0]),
        station("wall", [1.0, 1.0, 1.0]),
    ];
    let scene = Scene::new(spec).unwrap();
    let found = tour(&scene, &TourOptions::default());
    assert!(found.cost.is_infinite() && found.lower_bound.is_infinite());
    assert!(found.path.is_empty() && found.stops.is_empty());
    let status = |a: usize, b: usize| found.legs.between(a, b).unwrap().0.status;
    assert_eq!([status(0, 1), status(0, 3)], [Status::Solved, Status::GoalInvalid]);
    assert!(matches!(status(0, 2), Status::NoPath | Status::GoalInvalid));
    let some =
        TourOptions { stations: Some(vec!["left".to_string(), "left too".to_string()]), ..TourOptions::default() };
    assert_eq!(tour(&scene, &some).cost, 1.0);
}

#[test]
fn a_tour_turns_between_stations_of_different_orientations() {
    let yawed: OrientationSource = wxyz(&Rotation::from_scaled_axis(Vector::z() * 0.2)).into();
    let mut spec = testing::hard1().spec().clone();
    let turned = |name: &str, position| StationSpec { orientation: Some(yawed.clone()), ..station(name, position) };
    spec.stations = vec![station("a", [0.3, 1.0, 0.3]), turned("b", [0.3, 1.0, 0.8]), turned("c", [0.3, 1.0, 1.4])];
    let scene = Scene::new(spec).unwrap();
    let found = tour(&scene, &TourOptions { start: Some("a".to_string()), ..TourOptions::default() });
    sound(&scene, &found);
    assert_eq!(found.order, [0, 1, 2]);
    let angles: Vec<f64> = found.stops.iter().map(|stop| found.path[*stop].orientation.angle()).collect();
    assert!(angles[0] == 0.0 && angles[1..].iter().all(|angle| (angle - 0.2).abs() < 1e-9), "{angles:?}");
    let file = serde_json::json!(TourFile::of(&scene, &found));
    assert_eq!(file["orientations"].as_array().unwrap().len(), found.path.len());
}

#[test]
fn what_a_tour_cannot_be_is_refused() {
    let scene = with_stations(&testing::hard1(), 3, 1);
    let of = |names: &[&str], start: Option<&str>| TourOptions {
        stations: (names != ["all"]).then(|| names.iter().map(|name| name.to_string()).collect()),
        start: start.map(str::to_string),
        ..TourOptions::default()
    };
    assert!(refused(&testing::hard1(), &of(&["all"], None)).starts_with("stations: found none, expected at least two"));
    assert!(refused(&scene, &of(&[], None)).starts_with("stations: found none"));
    assert!(refused(&scene, &of(&["1"], None)).starts_with("stations: found one"));
    assert!(refused(&scene, &of(&["1", "1"], None)).starts_with("stations: found \"1\" twice"));
    assert!(refused(&scene, &of(&["1", "7"], None)).starts_with("stations: found \"7\", expected"));
    assert!(refused(&scene, &of(&["1", "2"], Some("0"))).starts_with("start: found \"0\", expected one of"));
    let level = |name: &str, turn: f64| cdpr_core::model::OrientationSpec {
        name: name.to_string(),
        rpy: Some([0.0, 0.0, turn]),
        ..Default::default()
    };
    let orientations = vec![level("level", 0.0), level("turned", 0.1)];
    let open = Scene::new(SceneSpec { orientations, ..scene.spec().clone() }).unwrap();
    assert!(refused(&open, &of(&["all"], None)).starts_with("orientation: found a scene that selects none"));
}

#[test]
fn an_interrupt_keeps_what_was_planned() {
    let scene = with_stations(&testing::hard1(), 8, 2);
    let done = AtomicUsize::new(0);
    let wanted = TourOptions { threads: Some(1), ..TourOptions::default() };
    let stop = || done.load(Ordering::Relaxed) >= 5;
    let told = |finished: usize, total: usize| {
        assert_eq!(total, 28);
        done.fetch_max(finished, Ordering::Relaxed);
    };
    let found = plan_tour(&compiled(&scene), &wanted, &to_one_per_cent(), &stop, &told).unwrap();
    let count = |status: Status| found.legs.legs.iter().filter(|leg| leg.status == status).count();
    let (solved, interrupted) = (count(Status::Solved), count(Status::Interrupted));
    // A straight way is found before the first poll.
    assert!(solved >= 5 && interrupted > 0 && solved + interrupted == 28, "{solved} {interrupted}");
    assert!(found.cost.is_infinite() && found.lower_bound.is_finite() && found.lower_bound > 0.0);
}

fn by_time() -> TourOptions {
    let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
    TourOptions { by: By::Time, limits, ..TourOptions::default() }
}

/// The time of a trapezoid from rest to rest over this length at 1 m/s and 2 m/s².
fn trapezoid(length: f64) -> f64 {
    if length > 0.5 { length + 0.5 } else { 2.0 * (length / 2.0).sqrt() }
}

#[test]
fn the_order_by_time_is_the_fastest_of_all_and_no_motion_beats_the_bound() {
    let mut differs = false;
    for (scene, seed) in [(testing::hard1(), 5), (testing::hard3(), 6), (testing::hard3(), 9)] {
        let scene = with_stations(&scene, 6, seed);
        for (start, returns) in [(None, false), (Some(3), true)] {
            let wanted = TourOptions { start: start.map(|k: usize| k.to_string()), returns, ..by_time() };
            let found = tour(&scene, &wanted);
            sound(&scene, &found);
            let [duration, least] = found.time.unwrap();
            assert!((duration - brute_force(&found, start, returns)).abs() < 1e-9);
            assert!(least > 0.0 && least <= duration, "{least} {duration}");
            differs |= tour(&scene, &TourOptions { by: By::Length, ..wanted }).order != found.order;
            for leg in &found.legs.legs {
                let time = leg.time.as_ref().unwrap();
                let bound = trapezoid(leg.lower_bound);
                assert!((time.lower_bound - bound).abs() < 1e-9, "{} {bound}", time.lower_bound);
                // Bends within no blend are stops: each line is a trapezoid of its own.
                let lines = leg.path.windows(2).map(|line| trapezoid((line[1].position - line[0].position).norm()));
                let expected: f64 = lines.sum();
                assert!((time.duration - expected).abs() < 1e-3 * expected, "{} {expected}", time.duration);
            }
        }
    }
    assert!(differs, "corners cost time, but no order is another one by time");
}

#[test]
fn a_motion_run_backwards_keeps_the_limits() {
    let scene = with_stations(&testing::hard1(), 4, 3);
    let mut options = by_time();
    options.limits = MotionSpec { cable_speed: Some(0.7), jerk: Some(20.0), blend: Some(0.02), ..options.limits };
    let found = tour(&scene, &options);
    let engine = compiled(&scene);
    for leg in &found.legs.legs {
        let motion = Trajectory::new(&engine, &leg.path, &options.limits, &Watch::NONE).unwrap();
        let motion = TrajectoryFile::of(&engine, &leg.path, &motion, 1000.0, &Watch::NONE).unwrap();
        assert_eq!(motion.duration, leg.time.as_ref().unwrap().duration);
        let mut back = Recorded { exact: None, ..Recorded::of(&motion).unwrap() };
        back.positions.reverse();
        back.accelerations.as_mut().unwrap().reverse();
        back.velocities = back.velocities.map(|rows| rows.into_iter().rev().map(|v| -v).collect());
        for rows in [&mut back.cable_lengths, &mut back.cable_accelerations, &mut back.tensions] {
            rows.iter_mut().for_each(|rows| rows.reverse());
        }
        back.cable_speeds = back
            .cable_speeds
            .map(|rows| rows.into_iter().rev().map(|row| row.into_iter().map(|speed| -speed).collect()).collect());
        let rules = TrajectoryRules { limits: options.limits, ..TrajectoryRules::default() };
        let report = check_trajectory(&scene, &back, &rules, &Watch::NONE).unwrap();
        assert!(report.valid, "{:?}", report.faults);
    }
}

#[test]
fn tours_by_time_are_the_same_on_any_number_of_threads_and_name_their_seconds() {
    let scene = with_stations(&testing::hard3(), 7, 4);
    let file = |threads: usize| {
        let found = tour(&scene, &TourOptions { threads: Some(threads), returns: true, ..by_time() });
        serde_json::to_value(TourFile::of(&scene, &found)).unwrap()
    };
    let (one, two) = (file(1), file(2));
    assert_eq!(one.to_string(), two.to_string());
    assert!(one["tour"]["least_duration"].as_f64() <= one["tour"]["duration"].as_f64());
    assert!(one["tour"]["pairs"][0]["duration"].as_f64() > one["tour"]["pairs"][0]["cost"].as_f64());
    let plain = serde_json::to_value(TourFile::of(&scene, &tour(&scene, &TourOptions::default()))).unwrap();
    assert!(plain["tour"].get("duration").is_none() && plain["tour"]["pairs"][0].get("duration").is_none());
}

#[test]
fn bounds_of_time_leave_out_what_a_motion_may_pass_over() {
    // A clearance that motions need not keep: their curves may be shorter than any path.
    let scene = with_stations(&testing::hard1(), 3, 8).with_clearance(0.02).unwrap();
    let looser = MotionSpec { clearance: Some(0.0), ..by_time().limits };
    // With clearances, a gap may never be reached.
    let wanted = TourOptions { limits: looser, ..by_time() };
    let found = plan_tour(&compiled(&scene), &wanted, &PlanOptions::default(), &|| false, &|_, _| ()).unwrap();
    for ([a, b], leg) in found.legs.pairs.iter().zip(&found.legs.legs).filter(|(_, leg)| leg.cost.is_finite()) {
        let [a, b] = [a, b].map(|k| found.legs.stations[*k].position);
        assert!((leg.time.as_ref().unwrap().lower_bound - trapezoid((b - a).norm())).abs() < 1e-9);
    }
    // Turns count by their angle, and lengths only as far as the origin moves.
    let yawed: OrientationSource = wxyz(&Rotation::from_scaled_axis(Vector::z() * 0.2)).into();
    let turned = StationSpec { orientation: Some(yawed), ..station("b", [0.3, 1.0, 0.8]) };
    let stations = vec![station("a", [0.3, 1.0, 0.3]), turned];
    let scene = Scene::new(SceneSpec { stations, ..testing::hard1().spec().clone() }).unwrap();
    let limits = MotionSpec { turn_speed: Some(0.1), turn_acceleration: Some(0.2), ..by_time().limits };
    let found = tour(&scene, &TourOptions { limits, ..by_time() });
    let [duration, least] = found.time.unwrap();
    assert!((least - 2.5).abs() < 1e-9 && duration >= least, "{least} {duration}");
}

#[test]
fn by_time_needs_limits_and_an_interrupt_keeps_what_was_timed() {
    let scene = with_stations(&testing::hard1(), 5, 2);
    let none = TourOptions { limits: MotionSpec::default(), ..by_time() };
    assert!(refused(&scene, &none).contains("acceleration: found no limit"), "{}", refused(&scene, &none));
    let negative = MotionSpec { speed: Some(-1.0), ..MotionSpec::default() };
    assert!(refused(&scene, &TourOptions { limits: negative, ..by_time() }).starts_with("speed: found -1"));
    let done = AtomicUsize::new(0);
    let stop = || done.load(Ordering::Relaxed) >= 3;
    let told = |finished: usize, _: usize| {
        done.fetch_max(finished, Ordering::Relaxed);
    };
    let wanted = TourOptions { threads: Some(1), ..by_time() };
    let found = plan_tour(&compiled(&scene), &wanted, &to_one_per_cent(), &stop, &told).unwrap();
    let timed = found.legs.legs.iter().filter(|leg| leg.weight().is_finite()).count();
    assert!((3..10).contains(&timed), "{timed}");
    let [duration, least] = found.time.unwrap();
    assert!(duration.is_infinite() && least.is_finite() && found.path.is_empty() && found.cost.is_infinite());
}
