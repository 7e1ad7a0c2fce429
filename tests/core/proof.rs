//! Proofs that there is no path, against planners and known answers.

use cdpr_certify::{Summary, check_certificate};
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, Ordering};

use cdpr_core::Error;
use cdpr_core::collision::{CspaceEngine, Interference, Validity};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Cuboid, Point, Vector};
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::model::{ClearancesSpec, PulleySpec, QuerySpec, RobotSource, Scene, SceneSpec};
use cdpr_core::plan::{FoundBy, NoPath, PlanOptions, plan};
use cdpr_core::planning::{Planner, PlannerOptions, Status};
use cdpr_core::proof::{Answer, Certificate, Content, Proof, decide, decide_with};
use cdpr_core::testing::{block, empty, hard1, scene, walled};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::measures;
use cdpr_study::{RandomScenes, RandomScenesSpec};
use cdpr_tests::built_scene;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

fn answer(scene: &Scene) -> Answer {
    let engine = engine_for(scene, Default::default(), Interference::Exact).unwrap();
    decide(&*engine, [&scene.start().unwrap(), &scene.goal().unwrap()], PROOF_EFFORT, &Watch::NONE).unwrap()
}

/// A proof, whose certificate the independent checker accepts.
fn proof(spec: SceneSpec) -> Proof {
    let scene = scene(spec);
    match answer(&scene) {
        Answer::NoPath(proof) => {
            accepted(&scene, &proof).unwrap();
            *proof
        }
        other => panic!("{other:?}"),
    }
}

fn accepted(scene: &Scene, proof: &Proof) -> Result<Summary, Error> {
    let engine = engine_for(scene, Default::default(), Interference::Exact).unwrap();
    let certificate = Certificate::of(proof, scene, &*engine);
    check_certificate(scene, &serde_json::to_string(&certificate).unwrap(), &Watch::NONE)
}

fn is_path(spec: SceneSpec) -> bool {
    matches!(answer(&scene(spec)), Answer::Path(_))
}

#[test]
fn a_wall_closes_the_way_and_is_named() {
    let mut spec = walled(0.94);
    spec.obstacles.insert(0, block("aside", [0.1, 0.1, 0.1], [0.5, 0.3, 0.05]));
    let found = proof(spec);
    assert_eq!(found.blocking, [1]);
    // The platform reaches the wall: its centre has x up to 0.875 m of 2 m, y within 0.075 m of the walls.
    let half = (0.875 - 0.075) * 1.85 * (0.915 - 0.025);
    assert!(found.reachable_volume > 0.4 * half && found.reachable_volume <= half, "{}", found.reachable_volume);
    let x = found.nearest_to_goal.x; // on the way down to the goal a cable meets the wall before the platform does
    assert!(x > 0.77 && x < 0.875, "{x}");
}

#[test]
fn slits_without_width_are_closed_and_others_are_not() {
    assert!(is_path(walled(0.96)));
    assert!(is_path(walled(0.953)));
    assert_eq!(proof(walled(0.95)).blocking, [0]);
    assert_eq!(proof(walled(0.9499)).blocking, [0]);
}

#[test]
fn proof_boxes_tile_and_closed_ones_lie_in_regions() {
    let found = proof(walled(0.94));
    let volume: f64 = found.boxes.iter().map(|b| b.positions.volume()).sum();
    assert!((volume / found.bounds.volume() - 1.0).abs() < 1e-9);
    let mut closed = 0;
    for b in &found.boxes {
        if let Content::Region(region) = b.content {
            let planes = &found.regions[region].half_spaces;
            assert!(b.positions.corners().iter().all(|corner| planes.iter().all(|plane| plane.height(corner) < 0.0)));
            closed += 1;
        }
    }
    assert!(closed > 20, "{closed}");
    let holds = |place: &Point| {
        let at = Cuboid::new(*place, *place);
        found.boxes.iter().filter(|b| b.content == Content::Open && b.positions.touches(&at)).count()
    };
    assert!(holds(&found.start) > 0 && holds(&found.goal) > 0);
}

#[test]
fn the_wall_is_the_closed_boxes_around_the_start() {
    let found = proof(walled(0.94));
    let touch = |a: usize, b: usize| found.boxes[a].positions.touches(&found.boxes[b].positions);
    let (open, closed): (Vec<usize>, Vec<usize>) =
        (0..found.boxes.len()).partition(|&k| found.boxes[k].content == Content::Open);
    let at_start = Cuboid::new(found.start, found.start);
    let mut waiting: Vec<usize> =
        open.iter().copied().filter(|&k| found.boxes[k].positions.touches(&at_start)).collect();
    let mut around = BTreeSet::new();
    while let Some(a) = waiting.pop() {
        if around.insert(a) {
            waiting.extend(open.iter().copied().filter(|&b| touch(a, b)));
        }
    }
    let wall: Vec<usize> = closed.into_iter().filter(|&b| around.iter().any(|&a| touch(a, b))).collect();
    assert!(around.len() > 20 && wall.len() > 10, "{} {}", around.len(), wall.len());
    assert_eq!((Vec::from_iter(around), wall), (found.around_start, found.wall));
}

#[test]
fn the_opening_that_every_path_passes_is_wider_than_the_only_slit() {
    let scene = scene(walled(0.953)); // the centre of the platform passes over the wall between 0.925 m and 0.928 m
    let engine = engine_for(&scene, Default::default(), Interference::Exact).unwrap();
    let ends = [&scene.start().unwrap(), &scene.goal().unwrap()];
    let mut widths = Vec::new();
    for effort in (4..18).map(|power| 1 << power) {
        match decide(&*engine, ends, effort, &Watch::NONE).unwrap() {
            Answer::OpeningBelow(width) => widths.push(width),
            Answer::Path(_) => break,
            Answer::NoPath(_) => panic!("there is a path"),
        }
    }
    let least = widths.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(widths.len() > 3 && least > 0.003 && least < 0.2, "{widths:?}");
}

#[test]
fn answers_agree_with_planners_on_random_scenes() {
    let (mut paths, mut none) = (0, 0);
    for count in [3, 6, 10] {
        let spec: RandomScenesSpec = toml::from_str(&format!("count = {count}")).unwrap();
        let scenes = RandomScenes::new(empty(), spec).unwrap();
        for seed in 1000..1030 {
            let scene = scenes.draw(seed).unwrap();
            match answer(&scene) {
                Answer::Path(path) => {
                    paths += 1;
                    let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
                    assert!(path.windows(2).all(|pair| engine.motion_valid(&pair[0], &pair[1])));
                }
                Answer::NoPath(proof) => {
                    none += 1;
                    accepted(&scene, &proof).unwrap();
                    let planner = PlannerOptions::of(Planner::TwoTrees);
                    let found = plan(&scene, &PlanOptions { planner, ..PlanOptions::default() }, &()).unwrap().result;
                    assert_ne!(found.status, Status::Solved, "count {count}, seed {seed}");
                }
                Answer::OpeningBelow(width) => panic!("count {count}, seed {seed}: undecided below {width} m"),
            }
        }
    }
    assert!(paths > 20 && none > 20, "{paths} paths, {none} without");
}

#[test]
fn a_certain_answer_survives_an_interruption() {
    let scene = scene(walled(0.94));
    let engine = engine_for(&scene, Default::default(), Interference::Exact).unwrap();
    let ends = [&scene.start().unwrap(), &scene.goal().unwrap()];
    let certain = AtomicBool::new(false);
    let stop = || certain.load(Ordering::Relaxed);
    let on_no_path = || certain.store(true, Ordering::Relaxed);
    let answer = decide_with(&*engine, ends, PROOF_EFFORT, &on_no_path, &Watch::on(&stop)).unwrap();
    let Answer::NoPath(cut_short) = answer else { panic!("there is no path") };
    let whole = proof(walled(0.94));
    assert_eq!((&cut_short.blocking, cut_short.paths_without.len()), (&whole.blocking, 1));
    assert!(cut_short.paths_without[0].is_none() && whole.paths_without[0].is_some());
    let reasons = |watch: &Watch| NoPath::of(whole.clone(), &scene, &*engine, &PlanOptions::default(), watch).unwrap();
    assert_eq!(reasons(&Watch::on(&stop)).without["wall"], None);
    assert!(reasons(&Watch::NONE).without["wall"].is_some());
}

#[test]
fn a_path_of_the_decision_says_so() {
    let scene = scene(walled(0.96)); // 1 cm to spare
    let planned = |planner: Planner, samples: usize, proof: bool| {
        let mut planner = PlannerOptions::of(planner);
        planner.limits.max_samples = samples;
        plan(&scene, &PlanOptions { planner, proof, ..PlanOptions::default() }, &()).unwrap().result
    };
    assert_eq!(planned(Planner::Rrt, 2000, false).status, Status::BudgetSpent);
    let of_decision = planned(Planner::Rrt, 2000, true);
    assert_eq!((of_decision.status, of_decision.found_by), (Status::Solved, FoundBy::Decision));
    let of_planner = planned(Planner::TwoTrees, 100_000, true);
    assert_eq!((of_planner.status, of_planner.found_by), (Status::Solved, FoundBy::Planner));
}

#[test]
fn a_clearance_closes_the_way() {
    let kept = |clearance: f64| {
        let mut spec = walled(1.05);
        spec.clearances = Some(ClearancesSpec { platform_obstacle: Some(clearance), ..ClearancesSpec::default() });
        spec
    };
    assert!(is_path(kept(0.097)));
    assert_eq!(proof(kept(0.101)).blocking, [0]);
}

#[test]
fn length_limits_close_the_way() {
    // Where the platform reaches the top of the wall, at x = 0.875 m, two cables are 1.613 m long or less.
    let limited = |shortest: f64| {
        let mut spec = walled(2.0);
        let RobotSource::Inline(robot) = &mut spec.robot else { panic!("inline") };
        robot.cables.iter_mut().for_each(|cable| cable.length = Some([shortest, 3.0]));
        spec
    };
    assert!(is_path(limited(1.60)));
    let found = proof(limited(1.63));
    assert_eq!(found.blocking, [0]);
    assert!(found.conditions.len() >= 3, "{:?}", found.conditions); // the wall and some cables
}

#[test]
fn boxes_that_lack_wrenches_lack_them_everywhere() {
    for radius in [0.0, 0.02, 0.07] {
        let mut spec = built_scene("cogiro").spec().clone();
        let RobotSource::Inline(robot) = &mut spec.robot else { panic!("inline") };
        let pulley = (radius > 0.0).then_some(PulleySpec { radius, axis: [0.0, 0.0, 1.0] });
        robot.cables.iter_mut().for_each(|cable| cable.pulley = pulley);
        let scene = scene(spec);
        let (measures, engine) =
            (measures(&scene).unwrap(), engine_for(&scene, Default::default(), Interference::Exact).unwrap());
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut place =
            |low: &Point, high: &Point| low + Vector::from_fn(|axis, _| (high[axis] - low[axis]) * rng.random::<f64>());
        let (low, high) = engine.conditions().position_box();
        let (mut lacking, mut available) = (0, 0);
        for number in 0..2000 {
            let (center, size) = (place(&low, &high), place(&Point::origin(), &Point::new(0.3, 0.3, 0.2)).coords);
            let half = if number % 2 == 0 { size } else { 1e-3 * size }; // tiny boxes show whether the exits are known
            let positions = Cuboid::new(center - half, center + half);
            available += usize::from(measures[0].slack(&center) > 0.0);
            if engine.lacking_wrench(&positions).is_some() {
                lacking += 1;
                assert!(positions.corners().iter().all(|corner| measures[0].slack(corner) < 0.0), "{radius}");
                assert!((0..20).all(|_| measures[0].slack(&place(&positions.low, &positions.high)) < 0.0), "{radius}");
            }
        }
        assert!(lacking > 50 && available > 300, "{radius} {lacking} {available}");
    }
}

#[test]
fn a_touching_end_does_not_block() {
    let resting = |wall: bool| {
        let mut spec = walled(if wall { 0.94 } else { 1.2 });
        spec.obstacles.push(block("table", [0.3, 0.3, 0.4], [0.3, 1.0, 0.2]));
        spec.query.as_mut().unwrap().start = Some([0.3, 1.0, 0.425].into());
        spec
    };
    assert!(is_path(resting(false)));
    assert_eq!(proof(resting(true)).blocking, [0]);
}

#[test]
fn contact_at_both_ends_is_allowed_along_the_path() {
    // The attachments of cable 0 and cable 4 are 5 cm apart, so the cables are, too, at best.
    let mut spec = hard1().spec().clone();
    spec.clearance = Some(0.05);
    assert!(is_path(spec));
    // The platform slides on a table under a ceiling.
    let mut spec = empty().spec().clone();
    spec.ignore = (0..8).map(|k| [format!("cable {k}"), "table".to_string()]).collect();
    spec.obstacles = vec![block("table", [2.0, 2.0, 0.2], [1.0, 1.0, 0.1])];
    spec.workspace.max[2] = 0.25 + 1e-7;
    spec.query = Some(QuerySpec::between([0.3, 1.0, 0.225], [1.7, 1.0, 0.225]));
    assert!(!matches!(answer(&scene(spec)), Answer::NoPath(_)));
}

#[test]
fn a_straight_line_through_a_slit_without_width_is_a_path() {
    let mut spec = walled(0.95);
    spec.query = Some(QuerySpec::between([0.5, 1.0, 0.925], [1.5, 1.0, 0.925]));
    assert!(is_path(spec));
}

#[test]
fn flat_and_oddly_sized_boxes_of_positions_are_proved() {
    let ends = |start: [f64; 3], goal: [f64; 3]| Some(QuerySpec::between(start, goal));
    // 0.1 + 0.025 is not the sum in doubles; start and goal are on the floor.
    let mut spec = walled(0.94);
    spec.workspace.min = [0.0, 0.0, 0.1];
    spec.query = ends([0.3, 1.0, 0.125], [1.7, 1.0, 0.125]);
    spec.ignore = (0..4).map(|k| [format!("cable {k}"), "wall".to_string()]).collect();
    assert_eq!(proof(spec.clone()).blocking, [0]);
    spec.workspace.max[2] = 0.15;
    assert_eq!(proof(spec).blocking, [0]);
}

#[test]
fn parts_that_abut_are_proved_by_the_parts() {
    let mut spec = walled(0.94);
    spec.obstacles =
        vec![block("wall", [0.1, 1.0, 0.9], [1.0, 0.5, 0.45]), block("wall", [0.1, 1.0, 0.9], [1.0, 1.5, 0.45])];
    assert_eq!(proof(spec).blocking, [0]);
}

#[test]
fn contact_at_one_end_closes_nothing_around_it() {
    // An end that rests on a table could be walled in by positions that nearly touch the table.
    let mut spec = walled(1.2);
    spec.obstacles = vec![block("table", [0.3, 0.3, 0.4], [0.3, 1.0, 0.2])];
    spec.query.as_mut().unwrap().start = Some([0.3, 1.0, 0.425].into());
    let scene = scene(spec);
    let engine = engine_for(&scene, Default::default(), Interference::Exact).unwrap();
    let (low, high) = engine.conditions().position_box();
    let start = scene.start().unwrap();
    let cuts: Vec<[f64; 6]> =
        (0..3).map(|k| [low[k], start[k] - 6e-7, start[k] - 2e-7, start[k] + 2e-7, start[k] + 6e-7, high[k]]).collect();
    let mut boxes = Vec::new();
    for (i, j, k) in (0..125).map(|n| (n / 25, n / 5 % 5, n % 5)) {
        let shell = [i, j, k].iter().map(|n: &i32| (n - 2).abs()).max() == Some(1);
        let [i, j, k] = [i, j, k].map(|n| n as usize);
        let span = [cuts[0][i], cuts[1][j], cuts[2][k], cuts[0][i + 1], cuts[1][j + 1], cuts[2][k + 1]];
        let mut row: Vec<serde_json::Value> = span.iter().map(|x| (*x).into()).collect();
        row.push(if shell { (-2).into() } else { (-1).into() });
        row.extend(shell.then(|| serde_json::json!(["platform", "table"])));
        boxes.push(row);
    }
    let file = serde_json::json!({
        "format": "cdpr-proof", "version": 1, "scene": scene.fingerprint(), "orientation": [1.0, 0.0, 0.0, 0.0],
        "margin": 1e-6, "start": [start.x, start.y, start.z], "goal": [1.7, 1.0, 0.3],
        "box": [[low.x, low.y, low.z], [high.x, high.y, high.z]], "regions": [], "boxes": boxes,
    });
    let refused = check_certificate(&scene, &file.to_string(), &Watch::NONE).unwrap_err().to_string();
    assert!(refused.contains("found contact there"), "{refused}");
}

/// On every worker of the pool at once; a worker that waited for a thread that needs the pool would wait forever.
#[test]
fn all_workers_of_a_pool_prove_at_once() {
    let scene = scene(walled(0.94));
    let plans = 2 * rayon::current_num_threads() as u64;
    let statuses: Vec<Status> = (0..plans)
        .into_par_iter()
        .map(|seed| plan(&scene, &PlanOptions { seed, ..PlanOptions::paper() }, &()).unwrap().result.status)
        .collect();
    assert!(statuses.iter().all(|status| *status == Status::NoPath), "{statuses:?}");
}

/// An obstacle left out of a search must leave no trace in it: no blocking obstacle is missing, and none is
/// superfluous.
#[test]
fn blocking_obstacles_match_independent_searches() {
    let spec: RandomScenesSpec = toml::from_str("count = 6").unwrap();
    let random = RandomScenes::new(empty(), spec).unwrap();
    let mut judged = 0;
    for scene in (0..60).map(|seed| random.draw(seed).unwrap()) {
        let Answer::NoPath(found) = answer(&scene) else { continue };
        let only = |kept: &dyn Fn(usize) -> bool| {
            let mut spec = scene.spec().clone();
            spec.obstacles =
                (0..).zip(spec.obstacles).filter(|(j, _)| kept(*j)).map(|(_, obstacle)| obstacle).collect();
            answer(&Scene::new(spec).unwrap())
        };
        assert!(matches!(only(&|j| found.blocking.contains(&j)), Answer::NoPath(_)));
        for (left_out, way) in found.blocking.iter().zip(&found.paths_without) {
            assert!(matches!(only(&|j| j != *left_out && found.blocking.contains(&j)), Answer::Path(_)));
            assert_eq!(matches!(only(&|j| j != *left_out), Answer::Path(_)), way.is_some());
        }
        judged += 1;
    }
    assert!(judged >= 10, "{judged}");
}
