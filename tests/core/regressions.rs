//! Former wrong answers, each with its smallest input.

use std::time::{Duration, Instant};

use cdpr_core::collision::{Checker, Condition, Engine, GjkEngine, Interference, Kind, Validity};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Polytope, Rotation, Vector};
use cdpr_core::model::{BodySpec, CableSpec, PrismSpec, RobotSource, RobotSpec, Scene, SceneSpec, WorkspaceSpec};
use cdpr_core::plan::{Processing, shorten_held};
use cdpr_core::postprocess::RewindOptions;
use cdpr_core::testing::{block, scene, walled};
use cdpr_core::tolerances::GAP_TOLERANCE;
use cdpr_core::watch::Watch;
use cdpr_tests::{rng, rotation, uniform, vector};
use rand::RngExt;

fn part(sides: [f64; 3], position: [f64; 3]) -> BodySpec {
    BodySpec { cuboid: Some(sides), position: Some(position), ..BodySpec::default() }
}

fn cable(outlet: [f64; 3], attachment: [f64; 3]) -> CableSpec {
    CableSpec { outlet, attachment, ..CableSpec::default() }
}

fn engine(platform: Vec<BodySpec>, cables: Vec<CableSpec>, obstacles: Vec<BodySpec>, clearance: f64) -> GjkEngine {
    let robot = RobotSpec {
        version: None,
        name: None,
        mass: None,
        center_of_mass: None,
        inertia: None,
        platform,
        cables,
        cable: None,
        tension_distribution: None,
    };
    let spec = SceneSpec {
        version: 1,
        name: None,
        gravity: None,
        clearance: Some(clearance),
        ignore: Vec::new(),
        touch: Vec::new(),
        clearances: None,
        orientations: Vec::new(),
        stations: Vec::new(),
        payloads: Vec::new(),
        task: Vec::new(),
        workspace: WorkspaceSpec { min: [-100.0; 3], max: [100.0; 3] },
        robot: RobotSource::Inline(robot),
        obstacles,
        wrench: None,
        motion: None,
        turning: None,
        query: None,
    };
    GjkEngine::new(&Scene::new(spec).unwrap(), Interference::Exact).unwrap()
}

fn at(x: f64, y: f64, z: f64) -> Point {
    Point::new(x, y, z)
}

#[test]
fn a_vertex_in_the_middle_of_an_edge_costs_no_corner() {
    let base = vec![[0.5, 0.5], [0.7, 0.3], [0.3, 0.7], [-1.5, -1.5]];
    let wedge = BodySpec { prism: Some(PrismSpec { base, height: 1.0 }), ..BodySpec::default() };
    let engine =
        engine(vec![part([0.01; 3], [0.0; 3])], vec![cable([0.0, 0.0, 5.0], [0.0, 0.0, 0.005])], vec![wedge], 0.0);
    assert!(!engine.state_valid(&at(0.4, 0.2, 0.5)));
}

#[test]
fn points_in_line_across_the_longest_direction_cost_no_corner() {
    let points = [
        [0.3881223736362205, -0.1435992222049941],
        [-0.7762447472724413, 0.2871984444099885],
        [0.6368435224226434, 0.5286484484871715],
        [0.04783662763757368, -0.7055423591664449],
        [0.13940122484979756, -0.8158468928971597],
    ];
    let hull = Polytope::hull_of(&points.map(|[x, y]| at(x, y, 0.0))).unwrap();
    assert_eq!(hull.vertices().len(), 3); // the first and the fourth lie on sides
    assert!(hull.vertices().contains(&at(0.6368435224226434, 0.5286484484871715, 0.0)));
    let mut rng = rng(4);
    for _ in 0..50_000 {
        let angle = uniform(&mut rng, 0.0, std::f64::consts::TAU);
        let turn = Rotation::from_scaled_axis(Vector::z() * angle);
        let triangle = [[0.0, 0.0], [0.0, 1.0], [0.0, -1.0], [5.0, 0.0]].map(|[x, y]| turn * at(x, y, 0.0));
        assert_eq!(Polytope::hull_of(&triangle).unwrap().vertices().len(), 3);
    }
}

#[test]
fn flat_hulls_keep_every_corner() {
    let mut rng = rng(1);
    for case in 0..50_000 {
        let turn = rotation(&mut rng);
        let (w, h) = (f64::from(rng.random_range(1..9)) / 10.0, f64::from(rng.random_range(1..9)) / 10.0);
        let corners = [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]];
        let mut points = corners.to_vec();
        for _ in 0..rng.random_range(0..5) {
            let (k, t) = (rng.random_range(0..4), [0.5, 0.25, 0.1, 0.9][rng.random_range(0..4)]);
            let (a, b) = (corners[k], corners[(k + 1) % 4]);
            points.push([a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]);
        }
        let shift = rng.random_range(0..points.len());
        points.rotate_left(shift);
        let points: Vec<Point> = points.iter().map(|[x, y]| turn * at(*x, *y, 0.0)).collect();
        let hull = Polytope::hull_of(&points).unwrap();
        assert_eq!(hull.vertices().len(), 4, "case {case}: {points:?}");
    }
}

#[test]
fn solids_typed_with_any_number_of_decimals_are_bodies() {
    let turn = Rotation::from_scaled_axis(Vector::x() * 30f64.to_radians());
    for decimals in 3..16 {
        for n in 3..40 {
            let rounded = |x: f64| (x * 10f64.powi(decimals)).round() / 10f64.powi(decimals);
            let corner = |k: usize, z: f64| {
                let angle = std::f64::consts::TAU * k as f64 / n as f64;
                (turn * at(0.2 * angle.cos(), 0.2 * angle.sin(), z)).map(rounded)
            };
            let points: Vec<Point> = (0..n).flat_map(|k| [corner(k, 0.0), corner(k, 1.0)]).collect();
            let body = Polytope::hull_of(&points).unwrap_or_else(|e| panic!("{n} corners, {decimals} decimals: {e}"));
            let outside = points.iter().map(|p| -body.depth_of(p)).fold(f64::NEG_INFINITY, f64::max);
            assert!(outside < 2.1e-8, "{n} corners, {decimals} decimals: one is {outside} m outside");
        }
    }
}

#[test]
fn rotated_boxes_with_points_on_their_faces_are_bodies() {
    let mut rng = rng(2);
    for case in 0..2_000 {
        let (turn, shift) = (rotation(&mut rng), vector(&mut rng, 1.0));
        let grid = |k: usize| f64::from(k as u8 % 4) / 3.0 - 0.5;
        let on_surface = |p: &Point| p.iter().any(|x| x.abs() == 0.5);
        let points = (0..64).map(|k| at(grid(k), grid(k / 4), grid(k / 16))).filter(on_surface);
        let scale = [1.0, 1e9][case % 2];
        let rounded = |x: f64| if scale > 1.0 { (x * scale).round() / scale } else { x };
        let points: Vec<Point> = points.map(|p| (turn * p + shift).map(rounded)).collect();
        let body = Polytope::from_vertices(&points).unwrap_or_else(|e| panic!("case {case}: {e}"));
        assert!((body.volume() - 1.0).abs() < 1e-6);
    }
}

#[test]
fn an_outlet_before_a_sharp_edge_is_not_on_the_body() {
    let knife = |h: f64| BodySpec {
        vertices: Some(
            [[0.0, 0.0], [1.0, h], [1.0, -h]].iter().flat_map(|[x, z]| [[*x, -0.5, *z], [*x, 0.5, *z]]).collect(),
        ),
        ..BodySpec::default()
    };
    let near = engine(
        vec![part([0.1; 3], [0.0; 3])],
        vec![cable([-0.0009, 0.0, 0.0], [-0.05, 0.0, 0.0])],
        vec![knife(1e-4)],
        0.05,
    );
    assert!(!near.state_valid(&at(1.6, 0.0, 0.1)) && near.conditions().notes.len() == 1);
    let beside = engine(
        vec![part([0.01; 3], [0.0; 3])],
        vec![cable([-0.009, 0.4999, 0.0], [-0.005, 0.0, 0.0])],
        vec![knife(1e-5)],
        0.0,
    );
    assert!(beside.state_valid(&at(0.0135, 3.4999, 0.0)));
}

#[test]
fn a_cable_beside_a_seam_names_the_obstacle_it_enters() {
    let span = |name: &str, min: [f64; 3], max: [f64; 3]| {
        let sides = std::array::from_fn(|k| max[k] - min[k]);
        block(name, sides, std::array::from_fn(|k| 0.5 * (min[k] + max[k])))
    };
    let obstacles =
        vec![span("upper", [1.0, 2.0, -2.0], [3.0, 3.0, 0.0]), span("lower", [1.0, 1.0, -5.0], [4.0, 3.0, -2.0])];
    let platform = vec![part([0.1; 3], [-10.0, 0.0, 0.0])];
    let engine = engine(platform, vec![cable([-6.0, 5.0, -3.0], [4.0, 1.0, -4.0])], obstacles, 0.0);
    let violations = engine.violations(&at(-1.0, 0.0, 2.0), &at(0.0, 1.0, 2.0));
    let blamed: Vec<_> =
        violations.iter().filter(|v| v.kind == Kind::CableObstacle).map(|v| v.culprits[1].as_str()).collect();
    assert_eq!(blamed, ["lower"]);
}

#[test]
fn thin_sheets_have_seams_up_to_their_rim() {
    for thickness in [0.1, 0.01, 1e-3, 1e-4, 1e-5] {
        for cut in [1e-7, 1e-6, 1e-4, 1e-2] {
            let sheet = |z: f64| block("sheet", [1.0, 1.0, thickness], [0.0, 0.0, z]);
            let engine = engine(
                vec![part([0.01; 3], [0.0; 3])],
                vec![cable([0.5 - cut, -2.0, 0.0], [0.0, -0.005, 0.0])],
                vec![sheet(0.5 * thickness), sheet(-0.5 * thickness)],
                0.0,
            );
            assert!(!engine.state_valid(&at(0.5 - cut, 2.0, 0.0)), "thickness {thickness}, cut {cut}");
        }
    }
}

#[test]
fn slow_crossings_of_two_cables_are_detected() {
    let cables = vec![cable([0.0; 3], [0.0; 3]), cable([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])];
    let engine = engine(vec![part([0.001; 3], [0.0, 0.0, 5.0])], cables, Vec::new(), 0.0);
    assert!(!engine.motion_valid(&at(0.5, 0.5, 0.9e-9), &at(3.0, 0.5, -1.1e-9)));
}

/// The pair of cables 0 and 1 with the required distance `demanded`.
fn pair(outlets: [[f64; 3]; 2], q: [f64; 3], demanded: f64) -> GjkEngine {
    let cables = vec![cable(outlets[0], [0.0; 3]), cable(outlets[1], q)];
    engine(vec![part([1e-4; 3], [0.0, 0.0, 0.5])], cables, Vec::new(), demanded)
}

#[test]
fn a_pair_with_a_micrometre_to_spare_is_allowed() {
    let outlets = [
        [1.6246915937377624, -0.10428063745967142, -0.5220157440422368],
        [0.4860699444551666, 1.3935970245742446, -1.0043194286052795],
    ];
    let q = [0.0008738537463243161, -0.000331045722412772, 0.00035607353132065825];
    let (from, to) = (
        at(0.5882884649687306, 0.4322566985937195, 1.8638459724514762),
        at(0.49154907502135137, -0.41480869989054603, 2.0955483751388204),
    );
    assert!(pair(outlets, q, 5.13199e-4).motion_valid(&from, &to));
    assert!(!pair(outlets, q, 5.15199e-4).motion_valid(&from, &to));
}

#[test]
fn least_cable_distance_is_attained_and_below_samples() {
    let mut rng = rng(3);
    for case in 0..20_000 {
        let place = |rng: &mut _| <[f64; 3]>::from(vector(rng, 2.0));
        let reach = 10f64.powf(uniform(&mut rng, -4.0, 0.0));
        let q: [f64; 3] = vector(&mut rng, reach).into();
        let engine = pair([place(&mut rng), place(&mut rng)], q, 0.0);
        let Some(Condition::CableCable(pair)) =
            engine.conditions().list.iter().find(|c| matches!(c, Condition::CableCable(_)))
        else {
            continue;
        };
        let (from, to) = (Point::from(vector(&mut rng, 2.0)), Point::from(vector(&mut rng, 2.0)));
        let (found, t) = pair.least_distance(&from, &to);
        let distance = |t: f64| pair.nearest(&(from + (to - from) * t)).distance;
        assert!(found == 0.0 || (distance(t) - found).abs() < 1e-12);
        let least = (0..=200).map(|k| distance(f64::from(k) / 200.0)).fold(f64::INFINITY, f64::min);
        assert!(found <= least + 1e-12, "case {case}: found {found}, sampled {least}");
    }
}

#[test]
fn far_away_motions_are_answered_at_once() {
    let engine = pair([[0.0; 3], [1.0, 0.0, 0.0]], [0.0, 0.2, 0.0], 0.01);
    let clock = Instant::now();
    for reach in [1e5, 1e6, 1e9] {
        let (from, to) = (at(0.3, 0.2, 1.0), at(reach, 0.7 * reach, -reach));
        assert!(!engine.motion_valid(&from, &to));
        assert!(engine.clearance(&from, &to).unwrap().value.is_finite());
        assert!(!engine.violations(&from, &to).is_empty());
    }
    assert!(clock.elapsed() < Duration::from_secs(2));
}

#[test]
fn dense_paths_are_rewound_in_bounded_time() {
    let engine =
        engine(vec![part([0.1; 3], [0.0; 3])], vec![cable([0.0, 0.0, 9.0], [0.0, 0.0, 0.05])], Vec::new(), 0.0);
    let path: Vec<Point> = (0..=4000).map(|k| at(3.0 + f64::from(k) / 400.0, 0.0, 0.0)).collect();
    let clock = Instant::now();
    let rewound = shorten_held(&engine, &path, &Processing::Rewind(RewindOptions::default()), &Watch::NONE).unwrap();
    assert_eq!((rewound[0], rewound[rewound.len() - 1]), (path[0], path[4000]));
    assert!(clock.elapsed() < Duration::from_secs(20)); // cubic time would need minutes
    let small = RewindOptions { step: 1e-9, ..RewindOptions::default() };
    let detour = [at(3.0, 0.0, 0.0), at(4.0, 1.0, 0.0), at(5.0, 0.0, 0.0)];
    let clock = Instant::now();
    let late = || clock.elapsed() > Duration::from_millis(50);
    let stopped = shorten_held(&engine, &detour, &Processing::Rewind(small.clone()), &Watch::on(&late));
    assert!(stopped.is_err() || clock.elapsed() < Duration::from_secs(1));
}

/// A scene with all its lengths multiplied.
fn scaled(scene: &Scene, factor: f64) -> Result<Scene, cdpr_core::Error> {
    let by = |x: &mut [f64; 3]| x.iter_mut().for_each(|x| *x *= factor);
    let body = |body: &mut BodySpec| {
        body.cuboid.iter_mut().chain(&mut body.position).for_each(by);
        body.vertices.iter_mut().flatten().for_each(by);
    };
    let mut spec = scene.spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot stands in place") };
    robot.platform.iter_mut().chain(&mut spec.obstacles).for_each(body);
    robot.cables.iter_mut().for_each(|cable| [&mut cable.outlet, &mut cable.attachment].into_iter().for_each(by));
    [&mut spec.workspace.min, &mut spec.workspace.max].into_iter().for_each(by);
    let scaled = |end: Option<Point>| end.map(|end| Point::from(factor * end.coords).into());
    let query = spec.query.get_or_insert_default();
    (query.start, query.goal) = (scaled(scene.start()), scaled(scene.goal()));
    Scene::new(spec)
}

#[test]
fn a_scene_gets_the_same_answers_at_any_size_or_is_refused() {
    for scene in [cdpr_core::testing::hard1(), cdpr_core::testing::hard3()] {
        let engines = |scene: &Scene| {
            [Engine::Cspace, Engine::Gjk].map(|engine| engine_for(scene, engine, Interference::Exact).unwrap())
        };
        let own = engines(&scene);
        for factor in [1e-7, 1e-6, 1e-5, 2e-5, 1e-4, 1e-3, 1e-2, 10.0, 1e3, 1e5] {
            let other = match scaled(&scene, factor) {
                Ok(_) if factor < 5e-5 => panic!("a scene of {factor} of the size is accepted"),
                Ok(other) => engines(&other),
                Err(refused) => {
                    let told = refused.to_string();
                    assert!(factor < 1e-4, "{factor}: {told}");
                    assert!(
                        told.contains("check the units, or scale all lengths") && told.contains("1e-7 m"),
                        "{told}"
                    );
                    continue;
                }
            };
            let mut rng = rng(3);
            for _ in 0..2000 {
                let p = Point::from([0; 3].map(|_| rng.random_range(0.1..1.9)));
                let q = Point::from(p.coords * factor);
                let clearance = own[0].clearance(&p, &p).unwrap().value;
                for (own, other) in own.iter().zip(&other) {
                    let measured = other.clearance(&q, &q).unwrap().value;
                    let error = (measured - clearance * factor).abs();
                    assert!(
                        error < GAP_TOLERANCE + 1e-9 * factor,
                        "{factor}: {p}: {measured}, not {clearance} times that"
                    );
                    let sure = clearance.abs() * factor > GAP_TOLERANCE;
                    assert!(!sure || own.state_valid(&p) == other.state_valid(&q), "{factor}: {p}: {clearance}");
                }
            }
        }
    }
}

#[test]
fn what_is_too_small_is_named() {
    let scene = cdpr_core::testing::hard1();
    let with = |change: &dyn Fn(&mut SceneSpec, &mut RobotSpec)| {
        let mut spec = scene.spec().clone();
        let RobotSource::Inline(mut robot) = spec.robot.clone() else { unreachable!("the robot stands in place") };
        change(&mut spec, &mut robot);
        Scene::new(SceneSpec { robot: RobotSource::Inline(robot), ..spec })
    };
    let tiny = || BodySpec { cuboid: Some([1e-6; 3]), ..BodySpec::default() };
    for (change, words) in [
        (
            &(|s: &mut SceneSpec, _: &mut RobotSpec| s.workspace.max = [5e-5; 3])
                as &dyn Fn(&mut SceneSpec, &mut RobotSpec),
            ["workspace: found a workspace of 5e-5 m", "at least 1e-4 m"],
        ),
        (&|s, _| s.obstacles.push(tiny()), ["obstacles[1]: found an obstacle of", "at least 1e-5 m"]),
        (&|_, r| r.platform = vec![tiny()], ["robot.platform: found a platform of", "at least 1e-5 m"]),
        (
            &|_, r| r.cables.iter_mut().for_each(|c| c.outlet = c.outlet.map(|x| 1e-5 * x)),
            ["robot.cables: found outlets within a box of 2", "at least 1e-4 m"],
        ),
    ] {
        let told = with(change).unwrap_err().to_string();
        assert!(words.iter().all(|word| told.contains(word)), "{words:?} in {told}");
    }
    // A point does not count as a small body, nor does a part of a body, and one cable has no extent.
    let sliver = BodySpec {
        name: Some("pillar".into()),
        cuboid: Some([2e-6, 2e-6, 2e-6]),
        position: Some([0.85, 1.0, 0.5]),
        ..BodySpec::default()
    };
    assert!(with(&|s, _| s.obstacles.push(sliver.clone())).is_ok());
    let lone = |r: &mut RobotSpec| {
        r.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
        r.cables.truncate(1);
        r.cables[0].attachment = [0.0; 3];
    };
    assert!(with(&|_, r| lone(r)).is_ok());
}

#[test]
fn a_platform_between_wall_and_ceiling_touches_both() {
    // The top of the box of positions lies in a plane of what the wall forbids; that plane was once left out.
    let scene = scene(walled(0.95));
    let ends = [Point::new(0.5, 1.0, 0.925), Point::new(1.5, 1.0, 0.925)];
    for engine in [Engine::Cspace, Engine::Gjk] {
        assert!(engine_for(&scene, engine, Interference::Exact).unwrap().motion_valid(&ends[0], &ends[1]));
    }
}
