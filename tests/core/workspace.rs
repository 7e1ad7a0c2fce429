//! Proved workspaces: volumes worked by hand, agreement with the check of positions, and the same answer on any number of threads.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use cdpr_core::batch::BatchOptions;
use cdpr_core::collision::Unproved;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Cuboid, Point, Quadratic, Vector};
use cdpr_core::model::spec::{BodySpec, CableSpec, WorkspaceSpec, WrenchSpec};
use cdpr_core::model::{OrientationSource, RobotSource, RobotSpec, Scene, SceneSpec};
use cdpr_core::testing::{self, block, paper_robot, paper_scene};
use cdpr_core::watch::Watch;
use cdpr_core::workspace::{Boxes, Ended, Interval, ValidAt, Workspace, WorkspaceOptions, orientations_for, workspace};
use cdpr_core::{Error, ErrorClass};
use cdpr_tests::{built_scene, effort, with_pulleys};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

pub fn compiled(scene: &Scene) -> CompiledScene {
    CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).unwrap()
}

fn proved_within(scene: &Scene, resolution: Option<f64>, watch: Watch) -> Result<Workspace, Error> {
    workspace(
        &[&compiled(scene)],
        &WorkspaceOptions { resolution, ..Default::default() },
        &BatchOptions { threads: None, watch },
    )
}

fn proved(scene: &Scene, resolution: f64) -> Workspace {
    proved_within(scene, Some(resolution), Watch::NONE).unwrap()
}

pub fn proved_at(scenes: &[Scene], valid_at: ValidAt, resolution: f64) -> Workspace {
    let scenes = orientations_for(scenes, valid_at).unwrap();
    let compiled: Vec<CompiledScene> = scenes.iter().map(compiled).collect();
    let options = WorkspaceOptions { resolution: Some(resolution), valid_at };
    workspace(&compiled.iter().collect::<Vec<_>>(), &options, &BatchOptions::default()).unwrap()
}

/// A scene in a box from the origin, for a point on these cables: outlets and tension limits.
pub fn point_scene(size: [f64; 3], outlets: &[[f64; 3]], obstacles: Vec<BodySpec>) -> SceneSpec {
    let cable = |outlet: &[f64; 3]| CableSpec { outlet: *outlet, tension: Some([0.0, 300.0]), ..CableSpec::default() };
    let robot = RobotSpec {
        platform: vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }],
        cables: outlets.iter().map(cable).collect(),
        ..paper_robot()
    };
    let workspace = WorkspaceSpec { min: [0.0; 3], max: size };
    SceneSpec { workspace, robot: RobotSource::Inline(robot), query: None, ..paper_scene("point", obstacles) }
}

pub fn scene(spec: SceneSpec) -> Scene {
    Scene::new(spec).unwrap()
}

/// The volume lies in the interval, which is no wider than this.
pub fn assert_volume(found: &Workspace, volume: f64, width: f64) {
    let interval = found.volume;
    let rounding = 1e-9 * found.total;
    assert!(interval.min <= volume + rounding && volume <= interval.max + rounding, "{interval:?}, not {volume}");
    assert!(interval.max - interval.min <= width, "{interval:?} is wider than {width}");
    let outside: f64 = found.shares.values().map(|share| share.volume).sum();
    assert!((found.volume.min + found.undecided + outside - found.total).abs() < rounding, "{interval:?}");
}

#[test]
fn without_obstacles_the_paper_s_robot_can_be_wherever_it_fits() {
    let found = proved(&testing::empty(), 0.1);
    assert_volume(&found, 1.85 * 1.85 * 1.95, 1e-2);
    assert!(found.shares.is_empty() && found.parts.len() == 1 && found.parts[0].start && found.parts[0].goal);
}

/// Under an outlet in the middle of the ceiling, a box of 1 × 1 × 0.5 m whose top is 0.75 m lower: its shadow is 4/9 d² wide at
/// depth d, up to 1.5 m, where it reaches the walls: 1.75 m³, and 2 m³ below.
#[test]
fn an_obstacle_and_its_shadow_are_taken_away() {
    let found = proved(
        &scene(point_scene([2.0; 3], &[[1.0, 1.0, 2.0]], vec![block("box", [1.0, 1.0, 0.5], [1.0, 1.0, 1.0])])),
        0.04,
    );
    assert_volume(&found, 8.0 - 3.75, 0.04);
    assert_eq!(found.causes.len(), found.shares.values().map(|share| share.culprits.len()).sum::<usize>());
    assert!(found.shares["cable-obstacle"].culprits["cable 0 / box"] > 3.0);
}

#[test]
fn a_flat_workspace_has_an_area() {
    // The platform is as long as the workspace is wide.
    let mut flat =
        point_scene([2.0, 0.2, 2.0], &[[1.0, 0.1, 2.0]], vec![block("box", [1.0, 1.0, 0.5], [1.0, 0.1, 1.0])]);
    let RobotSource::Inline(robot) = &mut flat.robot else { unreachable!() };
    robot.platform[0].vertices = Some(vec![[0.0, -0.1, 0.0], [0.0, 0.1, 0.0]]);
    let found = proved(&scene(flat), 0.02);
    // The shadow is 4/3 d wide at depth d, from 0.75 to 1.5 m: 9/8 m², and 1 m² below.
    assert_volume(&found, 4.0 - 2.125, 0.2);
    assert_eq!((found.dimension, found.unit()), (2, "m²"));
}

/// Of two cables that leave side by side and arrive crossed, no position is valid; uncrossed, every one is.
#[test]
fn cables_that_always_cross_leave_nothing() {
    let of = |sign: f64| {
        let cable = |side: f64| CableSpec {
            outlet: [1.0 + side, 1.0, 3.0],
            attachment: [0.1 * sign * side, 0.0, 0.0],
            ..CableSpec::default()
        };
        let platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
        let robot = RobotSpec { platform, cables: vec![cable(-1.0), cable(1.0)], ..paper_robot() };
        scene(SceneSpec { robot: RobotSource::Inline(robot), query: None, ..paper_scene("pair", Vec::new()) })
    };
    let crossed = proved(&of(-1.0), 0.5);
    assert_volume(&crossed, 0.0, 0.0);
    assert!((crossed.shares["cable-cable"].share - 1.0).abs() < 1e-12 && crossed.parts.is_empty());
    let uncrossed = proved(&of(1.0), 0.1);
    assert_volume(&uncrossed, uncrossed.total, 0.0);
}

/// A point mass hangs from outlets on the ceiling: its weight is balanced exactly below their polygon.
#[test]
fn a_point_mass_can_be_below_the_polygon_of_its_outlets() {
    let hung = |outlets: &[[f64; 3]]| {
        let spec = point_scene([3.0, 3.0, 1.0], outlets, Vec::new());
        proved(&scene(SceneSpec { wrench: Some(WrenchSpec::default()), ..spec }), 0.1)
    };
    let four = hung(&[[0.5, 0.5, 2.0], [2.5, 0.5, 2.0], [0.5, 2.5, 2.0], [2.5, 2.5, 2.0]]);
    assert_volume(&four, 4.0, 1.0);
    let three = hung(&[[0.0, 0.0, 2.0], [3.0, 0.0, 2.0], [0.0, 3.0, 2.0]]);
    assert_volume(&three, 4.5, 1.0);
    assert!(four.shares["wrench"].volume > 3.0 && four.shares["wrench"].culprits.is_empty());
}

#[test]
fn lengths_of_cables_bound_the_workspace() {
    let mut spec = point_scene([2.0; 3], &[[0.0; 3]], Vec::new());
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.cables[0].length = Some([1.0, 2.0]);
    let found = proved(&scene(spec), 0.05);
    let ball = |radius: f64| 4.0 / 3.0 * std::f64::consts::PI * f64::powi(radius, 3);
    assert_volume(&found, (ball(2.0) - ball(1.0)) / 8.0, 1.0);
}

/// Round a pulley, a cable is longer than the line from its outlet.
#[test]
fn lengths_round_pulleys_bound_the_workspace() {
    let mut spec = point_scene([2.0; 3], &[[1.0, 1.0, 2.0]], Vec::new());
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.cables[0].length = Some([1.2, 1.7]);
    let fixed = scene(spec);
    for radius in [0.02, 0.2] {
        let scene = with_pulleys(&fixed, radius);
        let found = proved(&scene, 0.02);
        println!("{radius}: {} decided", found.decided);
        assert!(found.decided > 0.8, "{radius}: {}", found.decided);
        assert_agrees(&scene, &found, 5000 * effort());
    }
}

/// A random position of a box, or one of its corners.
fn some_position(boxes: &Boxes, k: usize, rng: &mut ChaCha8Rng) -> Point {
    let (low, high) = (boxes.lower[k], boxes.upper[k]);
    let corner = rng.random_bool(0.3);
    let share = |rng: &mut ChaCha8Rng| if corner { f64::from(u8::from(rng.random_bool(0.5))) } else { rng.random() };
    Point::from(Vector::from_fn(|axis, _| {
        let share = share(rng);
        if share == 1.0 { high[axis] } else { low[axis] + share * (high[axis] - low[axis]) }
    }))
}

/// Positions in boxes, each kind of box as often as the other, as the check of positions sees them.
fn assert_agrees(scene: &Scene, found: &Workspace, tries: u64) {
    assert_agrees_at(std::slice::from_ref(scene), ValidAt::Every, found, tries);
}

/// Positions in boxes, each kind of box as often as the other, as the check of positions sees them at several orientations.
fn assert_agrees_at(scenes: &[Scene], valid_at: ValidAt, found: &Workspace, tries: u64) {
    let compiled: Vec<CompiledScene> = scenes.iter().map(compiled).collect();
    let valid = |position: &Point| {
        let mut at = compiled.iter().map(|at| at.level().state_valid(position));
        if valid_at == ValidAt::Every { at.all(|valid| valid) } else { at.any(|valid| valid) }
    };
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    for verdict in [1, -1] {
        for (k, position) in in_boxes(&found.boxes, verdict, tries, &mut rng) {
            assert_eq!(valid(&position), verdict == 1, "{} in box {k} of {}", position, scenes[0].name());
            if let Ok(cause) = usize::try_from(found.boxes.cause[k]) {
                // Where a condition forbids a box, at the orientation that it names.
                let at = found.causes[cause].at.unwrap_or(0);
                assert!(!compiled[at].level().state_valid(&position), "{position} in box {k} of {}", scenes[0].name());
            }
        }
    }
    let [volume, error] = estimated(found, &valid, tries, &mut rng);
    let Interval { min, max } = found.volume;
    assert!(min - error <= volume && volume <= max + error, "{volume} ± {error} not from {min} to {max}");
}

/// Random positions in boxes with a verdict, with the index of the box.
pub fn in_boxes(boxes: &Boxes, verdict: i64, tries: u64, rng: &mut ChaCha8Rng) -> Vec<(usize, Point)> {
    let all: Vec<usize> = (0..boxes.len()).filter(|k| boxes.verdict[*k] == verdict).collect();
    let some = |_| {
        let k = all[rng.random_range(0..all.len())];
        (k, some_position(boxes, k, rng))
    };
    (0..if all.is_empty() { 0 } else { tries }).map(some).collect()
}

/// The volume of valid positions, by the share of random positions, and five standard deviations of it.
pub fn estimated(found: &Workspace, valid: &dyn Fn(&Point) -> bool, tries: u64, rng: &mut ChaCha8Rng) -> [f64; 2] {
    let [low, high] = [found.within.min, found.within.max].map(Point::from);
    let place = |rng: &mut ChaCha8Rng| low + (high - low).map(|side| side * rng.random::<f64>());
    let share = (0..tries).filter(|_| valid(&place(rng))).count() as f64 / tries as f64;
    let error = 5.0 * found.total * (share * (1.0 - share) / tries as f64).sqrt() + 5.0 * found.total / tries as f64;
    [share * found.total, error]
}

const SCENES: [&str; 16] = [
    "acrobot",
    "caroca",
    "closed",
    "cogiro",
    "concave",
    "empty",
    "empty_rank6",
    "forest",
    "hard1",
    "hard1_rank6",
    "hard3",
    "hard3_rank6",
    "ipanema2",
    "mpi_simulator",
    "plank",
    "turn",
];

#[test]
fn boxes_agree_with_the_check_of_positions() {
    SCENES.into_par_iter().for_each(|name| {
        let scene = built_scene(name);
        let watch = Watch::NONE.with_budget(Some(Duration::from_secs(1)));
        let found = proved_within(&scene, None, watch).unwrap();
        assert!(found.decided > 0.05, "{name}: {}", found.decided);
        assert_agrees(&scene, &found, 1000 * effort());
    });
}

/// Where a bar of 1 m fits into a room of 2 m: 1 m × 2 m along x, 2 m × 1 m along y; 1 m² for both, 3 m² for either. Of a box of
/// 1 m with a corner of the room, each orientation forbids another half: both together only a quarter.
#[test]
fn a_bar_that_may_lie_along_either_axis() {
    let mut spec = point_scene([2.0; 3], &[[1.0, 1.0, 3.0]], Vec::new());
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.platform[0].vertices = Some(vec![[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]]);
    let along_x = scene(spec);
    let along_y = along_x.turned([0.5_f64.sqrt(), 0.0, 0.0, 0.5_f64.sqrt()].into()).unwrap();
    for (valid_at, total, volume) in [(ValidAt::Every, 2.0, 2.0), (ValidAt::Any, 8.0, 6.0)] {
        for scenes in [[&along_x, &along_y], [&along_y, &along_x]] {
            let found = proved_at(&scenes.map(Scene::clone), valid_at, 0.1);
            assert!((found.total - total).abs() < 1e-6, "{}", found.total);
            assert_volume(&found, volume, 0.02);
            assert_volume(&proved_at(&scenes.map(Scene::clone), valid_at, 1.0), volume, total);
            assert_eq!((found.valid_at, found.more_orientations.len()), (Some(valid_at), 1));
            assert!(found.causes.iter().all(|cause| cause.condition == "workspace"), "{:?}", found.causes);
        }
    }
}

#[test]
fn boxes_at_several_orientations_agree_with_the_check_of_positions() {
    let tilts: [[f64; 4]; 3] = [[1.0, 0.0, 0.0, 0.0], [0.99, 0.1, 0.08, 0.05], [0.97, 0.0, 0.0, 0.24]];
    ["hard1", "turn", "plank", "cogiro", "caroca"].into_par_iter().for_each(|name| {
        let scene = built_scene(name);
        let named = scene.orientations().iter().map(|(name, _)| OrientationSource::Named(name.clone()));
        let tilted = tilts.iter().map(|tilt| {
            let norm = tilt.iter().map(|x| x * x).sum::<f64>().sqrt();
            OrientationSource::Quaternion(tilt.map(|x| x / norm))
        });
        let turned = |source| scene.turned(source).unwrap();
        let scenes: Vec<Scene> = match name {
            "turn" | "plank" => named.map(turned).collect(),
            _ => tilted.map(turned).collect(),
        };
        let resolution = if ["cogiro", "caroca"].contains(&name) { 0.6 } else { 0.25 };
        let each: Vec<Workspace> = scenes.iter().map(|scene| proved(scene, resolution)).collect();
        for valid_at in [ValidAt::Every, ValidAt::Any] {
            let found = proved_at(&scenes, valid_at, resolution);
            assert_agrees_at(&scenes, valid_at, &found, 1000 * effort());
            let bound = each.iter().map(|one| one.volume);
            match valid_at {
                ValidAt::Every => {
                    assert!(bound.fold(f64::INFINITY, |least, of| least.min(of.max)) >= found.volume.min, "{name}")
                }
                ValidAt::Any => {
                    assert!(bound.fold(0.0, |most, of| f64::max(most, of.min)) <= found.volume.max, "{name}")
                }
                ValidAt::Turns => unreachable!(),
            }
            // Larger boxes know less, but nothing else.
            for larger in [2.0, 8.0] {
                let Interval { min, max } = proved_at(&scenes, valid_at, larger * resolution).volume;
                assert!(min <= found.volume.max && found.volume.min <= max, "{name} {valid_at:?}: {min} to {max}");
            }
            println!("{name} {valid_at:?}: {:?} of {}, {:.3} decided", found.volume, found.total, found.decided);
            assert!(found.decided > 0.5, "{name} {valid_at:?}: {}", found.decided);
        }
        // The same orientation given twice leaves every box as it is; only the bounds of the volume may differ.
        let [once, twice] = [1, 2].map(|count| proved_at(&vec![scenes[0].clone(); count], ValidAt::Every, resolution));
        assert_eq!((&once.boxes.verdict, once.valid_at), (&twice.boxes.verdict, None), "{name}");
        let [one, two] = [once.volume, twice.volume];
        assert!(one.min <= two.max && two.min <= one.max, "{name} {one:?} {two:?}");
    });
}

#[test]
fn boxes_keep_wrenches_round_pulleys() {
    for (name, resolution, least) in [("cogiro", 0.3, 0.8), ("mpi_simulator", 0.4, 0.9)] {
        let fixed = proved(&built_scene(name), resolution).decided;
        for radius in [1e-3, 0.05] {
            let scene = with_pulleys(&built_scene(name), radius);
            let found = proved(&scene, resolution);
            println!("{name}: {} decided with pulleys of {radius} m, {fixed} without", found.decided);
            assert!(found.decided > least && found.volume.min > 0.0, "{name} {radius}: {}", found.decided);
            assert!(found.shares["wrench"].volume > 0.0);
            assert_agrees(&scene, &found, 1000 * effort());
        }
    }
}

#[test]
fn boxes_keep_clearances_sag_and_pulleys() {
    for clearance in [0.005, 0.02] {
        let scene = testing::hard3().with_clearance(clearance).unwrap();
        let found = proved(&scene, 0.05);
        assert!(found.volume.min > 0.1, "{clearance}: {:?}", found.volume);
        assert_agrees(&scene, &found, 1000 * effort());
    }
    let mut spec = testing::hard1().spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    for cable in &mut robot.cables {
        (cable.diameter, cable.linear_density, cable.sag_tension) = (Some(0.004), Some(0.05), Some(20.0));
        cable.outlet_error = Some(0.002);
    }
    for scene in [scene(spec), with_pulleys(&testing::hard1(), 0.02)] {
        let found = proved(&scene, 0.05);
        assert!(found.volume.min > 0.1, "{:?}", found.volume);
        assert_agrees(&scene, &found, 1000 * effort());
    }
}

#[test]
fn the_rule_of_cells_decides_where_the_scene_asks_for_it() {
    let mut spec = built_scene("cogiro").spec().clone();
    let wrench = spec.wrench.as_mut().expect("it requires wrenches");
    (wrench.rule, wrench.grid) = (Some(cdpr_core::model::RuleSpec::Grid), Some(0.5));
    let scene = scene(spec);
    let found = proved(&scene, 0.25);
    assert!(found.volume.min > 1.0 && found.shares["wrench"].volume > 1.0, "{:?}", found.volume);
    assert_agrees(&scene, &found, 1000 * effort());
}

/// Parts are connected by valid motions through their faces, and `closed` has a proof that start and goal are apart.
#[test]
fn parts_say_which_holds_start_and_goal() {
    let found = proved(&built_scene("closed"), 0.1);
    let holding = |of: &dyn Fn(&cdpr_core::workspace::Part) -> bool| found.parts.iter().position(of);
    let (start, goal) = (holding(&|part| part.start), holding(&|part| part.goal));
    assert!(start.is_some() && goal.is_some() && start != goal, "{:?}", found.parts);
    let volumes: Vec<f64> = found.parts.iter().map(|part| part.volume).collect();
    assert!(volumes.is_sorted_by(|a, b| a >= b));
    let counted = |k: usize| found.boxes.part.iter().filter(|part| **part == k as i64).count();
    assert!(found.parts.iter().enumerate().all(|(k, part)| part.boxes == counted(k)));
}

#[test]
fn the_number_of_threads_changes_nothing() {
    for name in ["hard1", "caroca"] {
        let scene = built_scene(name);
        let longest = Vector::from(proved(&scene, 100.0).within.max) - Vector::from(proved(&scene, 100.0).within.min);
        let on = |threads: usize| {
            let batch = BatchOptions { threads: Some(threads), watch: Watch::NONE };
            let options = WorkspaceOptions { resolution: Some(longest.max() / 16.0), ..Default::default() };
            serde_json::to_string(&workspace(&[&compiled(&scene)], &options, &batch).unwrap()).unwrap()
        };
        assert!(on(1) == on(2) && on(1) == on(3), "{name}");
    }
}

#[test]
fn what_is_decided_is_kept_when_time_runs_out_or_the_caller_stops() {
    let scene = built_scene("cogiro");
    let clock = Instant::now();
    let found = proved_within(&scene, None, Watch::NONE.with_budget(Some(Duration::from_millis(500)))).unwrap();
    assert!(clock.elapsed() < Duration::from_millis(1500), "{:?}", clock.elapsed());
    assert_eq!(found.ended, Ended::Budget);
    assert!(found.boxes.len() > 100 && found.decided > 0.0 && found.undecided > 0.0);
    let compiled = compiled(&scene);
    // A few polls after the first box is judged.
    let (polls, most) = (AtomicUsize::new(0), AtomicUsize::new(usize::MAX));
    let stop = || polls.fetch_add(1, Ordering::Relaxed) >= most.load(Ordering::Relaxed);
    let batch = BatchOptions { threads: None, watch: Watch::on(&stop) };
    workspace(&[&compiled], &WorkspaceOptions { resolution: Some(100.0), ..Default::default() }, &batch).unwrap();
    most.store(polls.swap(0, Ordering::Relaxed) + 10, Ordering::Relaxed);
    let found =
        workspace(&[&compiled], &WorkspaceOptions { resolution: Some(1e-3), ..Default::default() }, &batch).unwrap();
    assert_eq!(found.ended, Ended::Interrupted);
    let all: f64 = found.shares.values().map(|share| share.volume).sum::<f64>() + found.volume.max;
    assert!((all - found.total).abs() < 1e-9 * found.total);
    let at_once = || true;
    let batch = BatchOptions { threads: None, watch: Watch::on(&at_once) };
    let refused = workspace(&[&compiled], &WorkspaceOptions::default(), &batch).unwrap_err();
    assert_eq!(refused.class(), ErrorClass::Interrupted);
}

#[test]
fn bad_questions_and_damaged_files_are_refused() {
    for resolution in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = proved_within(&testing::hard1(), Some(resolution), Watch::NONE).unwrap_err().to_string();
        assert!(refused.starts_with("resolution: found "), "{refused}");
    }
    let tight = SceneSpec {
        workspace: WorkspaceSpec { min: [0.0; 3], max: [0.1; 3] },
        query: None,
        ..paper_scene("tight", Vec::new())
    };
    let refused = proved_within(&scene(tight), None, Watch::NONE).unwrap_err().to_string();
    assert!(refused.contains("does not fit"), "{refused}");
    let found = proved(&testing::hard1(), 0.5);
    let text = serde_json::to_string(&found).unwrap();
    assert_eq!(Workspace::from_json(text.as_bytes()).unwrap(), found);
    let value = || serde_json::from_str::<serde_json::Value>(&text).unwrap();
    let spoilt: [fn(&mut serde_json::Value); 6] = [
        |value| value["format"] = "path".into(),
        |value| value["boxes"]["verdict"][0] = 2.into(),
        |value| value["boxes"]["cause"] = serde_json::json!([]),
        |value| value["boxes"]["lower"][0][0] = 1e9.into(),
        |value| value["causes"] = serde_json::json!([]),
        |value| value["volume"] = 1.into(),
    ];
    for spoil in spoilt {
        let mut value = value();
        spoil(&mut value);
        assert!(Workspace::from_json(value.to_string().as_bytes()).is_err());
    }
    for end in (0..text.len()).step_by(97) {
        assert!(Workspace::from_json(&text.as_bytes()[..end]).is_err());
    }
}

/// Random boxes of random robots, for bounds of wrenches over them.
struct Bounded {
    compiled: CompiledScene,
    measures: Vec<cdpr_core::wrench::Measure>,
    rng: ChaCha8Rng,
}

impl Bounded {
    fn new(scene: &Scene, seed: u64) -> Self {
        let mut spec = scene.spec().clone();
        (spec.obstacles, spec.clearance, spec.query) = (Vec::new(), None, None);
        let scene = Scene::new(spec).unwrap();
        let measures = cdpr_core::wrench::measures(&scene).unwrap();
        Bounded { compiled: compiled(&scene), measures, rng: ChaCha8Rng::seed_from_u64(seed) }
    }

    fn over(&self, positions: &Cuboid, known: Option<&[Unproved]>) -> Option<Vec<Unproved>> {
        self.compiled.level().wrench_over(positions, known)
    }

    /// A random box of about this share of the whole, flat along one axis every tenth time.
    fn positions(&mut self, share: f64) -> Cuboid {
        let (low, high) = self.compiled.conditions().position_box();
        let center = low + (high - low).component_mul(&Vector::from_fn(|_, _| self.rng.random_range(0.0..1.0)));
        let mut half = (high - low) * share;
        if self.rng.random_bool(0.1) {
            half[self.rng.random_range(0..3)] = 0.0;
        }
        Cuboid::new(center - half, center + half)
    }

    /// Half of a box, a quarter or an eighth.
    fn part(&mut self, positions: &Cuboid) -> Cuboid {
        let divided = Vector::from_fn(|_, _| f64::from(self.rng.random_range(-1..=1)));
        let half = positions.half.zip_map(&divided, |half, divided| if divided == 0.0 { half } else { 0.5 * half });
        let center = positions.center + half.component_mul(&divided);
        Cuboid::new(center - half, center + half)
    }

    /// A random offset from the centre of a box, in half sides, often on its surface.
    fn offset(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.rng.random_range(-1.5..1.5f64).clamp(-1.0, 1.0))
    }

    /// Whether the required wrenches are available, and whether there is no doubt that they are not.
    fn truth(&self, place: &Point) -> [bool; 2] {
        let all = |enough: &dyn Fn(f64, f64) -> bool| {
            self.measures.iter().all(|measure| enough(measure.slack(place), measure.floor()))
        };
        [all(&|slack, floor| slack >= floor), !all(&|slack, _| slack >= 0.0)]
    }

    /// Compares all that is claimed about a box with the slack at random places. Returns how often each claim was made.
    fn checked(&mut self, name: &str, positions: &Cuboid, known: Option<&[Unproved]>, places: usize) -> [usize; 4] {
        let over = self.over(positions, known);
        let proved = over.as_ref().is_some_and(|unproved| unproved.iter().all(|of| *of == Unproved::Nothing));
        let slack = self.compiled.level().wrench_slack(positions, known);
        let mut counts = [0; 4];
        for _ in 0..places {
            let x = self.offset();
            let place = positions.center + positions.half.component_mul(&Vector::from(x));
            let [enough, lacking] = self.truth(&place);
            let bounds = |side: &Quadratic| {
                let [x, y, z] = x;
                let terms = [x * x, y * y, z * z, x * y, x * z, y * z];
                let linear: f64 = side.slope.iter().zip([x, y, z]).map(|(a, b)| a * b).sum();
                let value = side.at_center + linear + side.curve.iter().zip(terms).map(|(a, b)| a * b).sum::<f64>();
                [value - side.below, value + side.above]
            };
            let claims = [
                (proved, enough),
                (over.is_none(), lacking),
                (slack.complete && slack.sides.iter().all(|side| bounds(side)[0] >= 0.0), enough),
                (slack.sides.iter().any(|side| bounds(side)[1] < 0.0), lacking),
            ];
            for (count, (claimed, holds)) in counts.iter_mut().zip(claims) {
                *count += usize::from(claimed);
                assert!(!claimed || holds, "{name}: {claims:?} at {place} in {positions:?}");
            }
        }
        counts
    }
}

const ROBOTS: [&str; 5] = ["cogiro", "caroca", "mpi_simulator", "ipanema2", "acrobot"];

/// Bounds of wrenches over random boxes, at random positions of them.
#[test]
fn bounds_over_boxes_agree_with_the_check_of_positions() {
    for (seed, name) in (11..).zip(ROBOTS) {
        let mut bounded = Bounded::new(&built_scene(name), seed);
        let mut counts = [0; 4];
        for _ in 0..2000 * effort() {
            let share = 10f64.powf(bounded.rng.random_range(-3.0..-0.8));
            let positions = bounded.positions(share);
            let found = bounded.checked(name, &positions, None, 10);
            counts.iter_mut().zip(found).for_each(|(count, more)| *count += more);
        }
        assert!(counts.iter().all(|count| *count > 30), "{name}: {counts:?}");
    }
}

/// What is proved over a box is not examined again in its parts: random ways from large boxes to small ones.
#[test]
fn bounds_over_parts_of_boxes_agree_with_the_check_of_positions() {
    for (seed, name) in (21..).zip(ROBOTS) {
        let mut bounded = Bounded::new(&built_scene(name), seed);
        let mut counts = [0; 4];
        for _ in 0..100 * effort() {
            let mut positions = bounded.positions(0.2);
            let mut known = None;
            for _ in 0..16 {
                let found = bounded.checked(name, &positions, known.as_deref(), 10);
                counts.iter_mut().zip(found).for_each(|(count, more)| *count += more);
                known = match bounded.over(&positions, known.as_deref()) {
                    Some(unproved) if unproved.iter().any(|of| *of != Unproved::Nothing) => Some(unproved),
                    _ => break,
                };
                positions = bounded.part(&positions);
            }
        }
        assert!(counts.iter().all(|count| *count > 30), "{name}: {counts:?}");
    }
}

/// Cables whose tension is given, cables side by side, corners that are required, errors of outlets, forces and moments apart.
#[test]
fn bounds_over_boxes_of_strange_robots_hold() {
    type Change = fn(&mut RobotSpec, &mut WrenchSpec);
    let strange: [(&str, Change); 6] = [
        ("tension", |robot, _| robot.cables.iter_mut().for_each(|cable| cable.tension = Some([700.0, 700.0]))),
        ("some", |robot, _| robot.cables[2].tension = Some([700.0, 700.0])),
        ("twin", |robot, _| {
            let (outlet, attachment) = (robot.cables[0].outlet, robot.cables[0].attachment);
            (robot.cables[1].outlet, robot.cables[1].attachment) = (outlet, attachment);
        }),
        ("corners", |_, wrench| {
            (wrench.force, wrench.moment) = (None, None);
            wrench.vertices =
                Some(vec![[150.0, 0.0, 0.0, 0.0, 30.0, 0.0], [-150.0, 0.0, -90.0, 20.0, 0.0, 0.0], [0.0; 6]]);
        }),
        ("errors", |robot, _| robot.cables.iter_mut().for_each(|cable| cable.outlet_error = Some(0.003))),
        ("projected", |_, wrench| wrench.margin = Some(cdpr_core::model::MarginSpec::Projected)),
    ];
    for (name, change) in strange {
        let scene = built_scene("cogiro");
        let (mut spec, mut robot) = (scene.spec().clone(), scene.robot().spec().clone());
        change(&mut robot, spec.wrench.as_mut().unwrap());
        (spec.robot, spec.query) = (RobotSource::Inline(robot), None);
        let mut bounded = Bounded::new(&Scene::new(spec).unwrap(), 31);
        let mut claimed = 0;
        for _ in 0..300 * effort() {
            let share = 10f64.powf(bounded.rng.random_range(-3.0..-0.8));
            let positions = bounded.positions(share);
            claimed += bounded.checked(name, &positions, None, 10).iter().sum::<usize>();
        }
        assert!(claimed > 30, "{name}: {claimed}");
    }
}
