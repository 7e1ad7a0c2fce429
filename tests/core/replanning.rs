//! Obstacles that move, and paths that are kept as far as they are still valid.

use std::path::Path;
use std::time::Duration;

use cdpr_core::collision::path_check::first_invalid_segment;
use cdpr_core::compiled::length;
use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::model::spec::{TurningAxis, TurningSpec};
use cdpr_core::model::{QuerySpec, SceneSpec};
use cdpr_core::path::held;
use cdpr_core::plan::{FoundBy, PlanOptions, Planned, Post, Query, plan, replan};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::testing::{block, hard1, hard3, paper_scene, scene, walled};
use cdpr_core::watch::Watch;
use cdpr_core::{CompiledScene, Engine, Interference, Scene};
use cdpr_files::load_scene;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn options() -> PlanOptions {
    let settings = PlannerSettings { max_samples: Some(2000), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::TwoTrees, PlanOptions::default().step, &settings).unwrap();
    PlanOptions { planner, ..PlanOptions::default() }
}

fn scenes() -> Vec<Scene> {
    let scene = |name| load_scene(Path::new(&format!("../testdata/scenes/{name}.toml"))).unwrap();
    ["hard1", "hard3", "cogiro", "concave", "hard3_rank6"].map(scene).to_vec()
}

/// A random obstacle of a scene, moved by at most `most` along each axis; `None` where it cannot stand.
fn one_moved(scene: &Scene, most: f64, rng: &mut ChaCha8Rng) -> Option<Scene> {
    let name = &scene.obstacles()[rng.random_range(0..scene.obstacles().len())].name;
    let by = Vector::from_fn(|_, _| rng.random_range(-most..most));
    scene.moved(name, scene.place_of(name).unwrap() + by).ok()
}

/// The path is valid for the slow engine, and leads from the first to the last waypoint of the one before.
#[track_caller]
fn is_right(planned: &Planned, before: &[Pose]) {
    let path = &planned.result.path;
    assert_eq!([path[0], path[path.len() - 1]], [before[0], before[before.len() - 1]]);
    let slow = CompiledScene::new(&planned.scene, Engine::Gjk, Interference::Exact, &Watch::NONE).unwrap();
    slow.ready_for(path).unwrap();
    assert_eq!(first_invalid_segment(&slow, path), None);
    assert!((planned.result.cost - length(&planned.scene, path)).abs() < 1e-12);
}

#[test]
fn a_moved_obstacle_is_that_of_the_changed_file() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for scene in scenes() {
        let mut stood = 0;
        for _ in 0..20 {
            let Some(moved) = one_moved(&scene, 0.3, &mut rng) else { continue };
            let fresh = Scene::new(moved.spec().clone()).unwrap().with_notes_of(&moved);
            assert_eq!(moved, fresh);
            assert_ne!(moved.fingerprint(), scene.fingerprint());
            stood += 1;
        }
        assert!(stood >= 15, "{}: {stood}", scene.name());
    }
}

#[test]
fn all_parts_of_an_obstacle_move_together() {
    let concave = &scenes()[3];
    let moved = concave.moved("table", [1.1, 0.9, 0.725].into()).unwrap();
    let [old, new] = [concave, &moved].map(|scene| scene.obstacles()[0].parts.clone());
    assert_eq!(old.len(), 5);
    for (old, new) in old.iter().zip(&new) {
        let shift = new.aabb().min - old.aabb().min;
        assert!((shift - Vector::new(0.1, -0.1, -0.1)).norm() < 1e-12, "{shift}");
    }
    assert_eq!(concave.obstacles()[1..], moved.obstacles()[1..]);
}

#[test]
fn an_obstacle_that_cannot_stand_there_is_refused() {
    let hard1 = hard1();
    let message = |name: &str, at: [f64; 3]| hard1.moved(name, at.into()).unwrap_err().to_string();
    assert!(message("pilar", [1.0, 1.0, 0.75]).contains("found none with the name \"pilar\""));
    assert!(message("pillar", [f64::NAN, 1.0, 0.75]).starts_with("position"));
    let outlet = hard1.robot().cables()[0].outlet;
    assert!(message("pillar", outlet.into()).contains("inside obstacle \"pillar\""));
}

#[test]
fn a_recompiled_scene_has_the_answers_of_a_fresh_one() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for scene in scenes() {
        for (engine, kind) in [(Engine::Cspace, Interference::Exact), (Engine::Gjk, Interference::Swept)] {
            let before = CompiledScene::new(&scene, engine, kind, &Watch::NONE).unwrap();
            let moved = std::iter::from_fn(|| Some(one_moved(&scene, 0.3, &mut rng))).flatten().next().unwrap();
            let again = before.recompiled(&moved, &Watch::NONE).unwrap();
            let fresh = CompiledScene::new(&moved, engine, kind, &Watch::NONE).unwrap();
            assert!(again.is_for(engine, kind) && again.scene() == &moved);
            let (low, high) = fresh.conditions().position_box();
            let mut place = || low + Vector::from_fn(|k, _| rng.random_range(0.0..1.0) * (high[k] - low[k]));
            let mut invalid = 0;
            for _ in 0..300 {
                let [from, to] = [place(), place()];
                let valid = fresh.level().motion_valid(&from, &to);
                assert_eq!(again.level().motion_valid(&from, &to), valid);
                invalid += usize::from(!valid);
            }
            assert!(invalid > 10, "{}: {invalid}", scene.name());
        }
    }
}

#[test]
fn a_path_is_kept_repaired_or_planned_anew() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut counts = [0; 3];
    for scene in scenes() {
        let before = plan(&scene, &options(), &()).unwrap().result.path;
        for _ in 0..12 {
            let Some(moved) = one_moved(&scene, 0.15, &mut rng) else { continue };
            let planned = replan(&moved, &before, &options(), &()).unwrap();
            let result = &planned.result;
            match result.status {
                Status::Solved => is_right(&planned, &before),
                // Then planning from nothing finds no path either.
                status => assert_eq!(plan(&moved, &options(), &()).unwrap().result.status, status),
            }
            let kept = first_invalid_segment(&**planned.compiled.as_ref().unwrap(), &before).is_none();
            assert_eq!(kept, result.found_by == FoundBy::Kept && result.status == Status::Solved);
            match result.found_by {
                FoundBy::Kept => counts[0] += 1,
                FoundBy::Repaired => counts[1] += 1,
                FoundBy::Planner | FoundBy::Decision => counts[2] += 1,
            }
            if kept {
                assert!(result.cost <= length(&moved, &before) + 1e-12);
                assert_eq!((result.raw_path.as_slice(), result.stats.samples), (before.as_slice(), 0));
            }
        }
    }
    assert!(counts[0] >= 10 && counts[1] >= 10, "{counts:?}");
}

#[test]
fn waypoints_before_and_after_a_gap_remain() {
    let scene = scene(paper_scene("crate", vec![block("crate", [0.1, 0.1, 0.3], [1.8, 1.0, 0.15])]));
    let path = held(&scene, &[0.3, 0.5, 0.6, 1.4, 1.5].map(|x| Point::new(x, 1.0, 0.2)));
    let options = PlanOptions { post: Some(Post::None), ..options() };
    let way =
        |at: f64| replan(&scene.moved("crate", [at, 1.0, 0.15].into()).unwrap(), &path, &options, &()).unwrap().result;
    let kept = way(1.85);
    assert_eq!((kept.found_by, kept.path.as_slice()), (FoundBy::Kept, path.as_slice()));
    let repaired = way(1.0).path;
    assert_eq!(repaired[..3], path[..3]);
    assert_eq!(repaired[repaired.len() - 2..], path[3..]);
    assert!(repaired.len() > path.len());
    // Two waypoints are not valid, and are left out.
    let without = way(0.55);
    assert_eq!(
        (without.found_by, without.path[0], without.path.contains(&path[1])),
        (FoundBy::Repaired, path[0], false)
    );
    assert!(without.path.ends_with(&path[3..]));
    assert_eq!((way(0.3).status, way(1.5).status), (Status::StartInvalid, Status::GoalInvalid));
}

#[test]
fn where_no_repair_is_possible_the_proof_is_that_of_planning() {
    let query = QuerySpec::between([0.3, 1.0, 0.3], [1.7, 1.0, 0.3]);
    let open = scene(SceneSpec { query: Some(query), ..walled(2.0) });
    let path = plan(&open, &options(), &()).unwrap().result.path;
    let wall = &open.obstacles()[0].name.clone();
    let place = open.place_of(wall).unwrap();
    let closed = open.moved(wall, place + Vector::z() * 0.8).unwrap();
    let [again, fresh] = [replan(&closed, &path, &options(), &()), plan(&closed, &options(), &())]
        .map(|planned| planned.unwrap().result);
    assert_eq!(again.status, fresh.status);
}

#[test]
fn turning_paths_are_kept_or_planned_anew() {
    let turning = TurningSpec { axis: Some(TurningAxis::Fixed([0.0, 0.0, 1.0])), ..TurningSpec::default() };
    let scene = Scene::new(SceneSpec { turning: Some(turning), ..hard1().spec().clone() }).unwrap();
    let yawed =
        |position: [f64; 3], angle: f64| Pose::new(position.into(), Rotation::from_scaled_axis(Vector::z() * angle));
    let path = [yawed([0.3, 1.0, 0.3], 0.0), yawed([0.3, 1.0, 0.5], 0.2), yawed([0.4, 1.0, 0.5], 0.2)];
    let kept = replan(Query::of(&scene), &path, &options(), &()).unwrap();
    assert_eq!(kept.result.found_by, FoundBy::Kept);
    is_right(&kept, &path);
    let moved = scene.moved("pillar", [0.55, 1.0, 0.75].into()).unwrap();
    let planned = replan(Query::of(&moved), &path, &options(), &()).unwrap();
    if planned.result.status == Status::Solved {
        is_right(&planned, &path);
    }
}

#[test]
fn one_seed_gives_one_path_and_an_interrupt_none() {
    let scene = hard3();
    let before = plan(&scene, &options(), &()).unwrap().result.path;
    let place = scene.place_of("west").unwrap();
    let moved = scene.moved("west", place + Vector::new(0.1, 0.0, 0.0)).unwrap();
    let again = || replan(&moved, &before, &options(), &()).unwrap().result;
    assert_eq!(again().path, again().path);
    let stopped = replan(&moved, &before, &options(), &|| true).unwrap().result;
    assert_eq!((stopped.status, stopped.path.len()), (Status::Interrupted, 0));
    let out_of_time = PlanOptions { budget: Some(std::time::Duration::ZERO), ..options() };
    assert_eq!(replan(&moved, &before, &out_of_time, &()).unwrap().result.status, Status::BudgetSpent);
    assert!(replan(&moved, &before[..1], &options(), &()).is_err());
}

#[test]
fn an_obstacle_moves_beside_payloads() {
    let tower = load_scene(Path::new("../testdata/tasks/tower.toml")).unwrap();
    let moved = tower.moved("table", [1.6, 0.5, 0.05].into()).unwrap();
    assert_eq!(moved.place_of("table"), Some([1.6, 0.5, 0.05].into()));
    assert_eq!(moved.payloads().len(), tower.payloads().len());
    assert_eq!(Scene::new(moved.written().clone()).unwrap().with_notes_of(&moved), moved);
    let payload = &tower.payloads()[0].name;
    let refused = tower.moved(payload, [1.0, 1.0, 0.5].into()).unwrap_err().to_string();
    assert!(refused.contains("which is a payload"), "{refused}");
}

/// The anytime planner uses up a budget that it is given, and there may be several gaps.
#[test]
fn a_budget_is_not_used_up_for_the_first_gap() {
    let scene = hard3();
    let path = plan(&scene, &PlanOptions::default(), &()).unwrap().result.path;
    let place = scene.place_of("west").unwrap();
    let moved = scene.moved("west", place + Vector::new(-0.05, 0.0, 0.0)).unwrap();
    for budget in [None, Some(Duration::from_secs(60))] {
        let options = PlanOptions { budget, ..PlanOptions::default() };
        let found = replan(&moved, &path, &options, &()).unwrap();
        assert_eq!(found.result.found_by, FoundBy::Repaired, "{budget:?}");
        assert!(found.result.stats.planning_seconds < 30.0);
        is_right(&found, &path);
    }
}
