//! The cspace engine with degenerate planes, after changes of a scene, without SIMD, and its memory.

use cdpr_core::Scene;
use cdpr_core::collision::{Checker, Conditions, CspaceEngine, Engine, GjkEngine, Interference, Validity, check_path};
use cdpr_core::geometry::{HalfSpace, Point, Vector};
use cdpr_core::model::{BodySpec, CableSpec, QuerySpec, RobotSource, RobotSpec, SceneSpec, WorkspaceSpec};
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::{StateSpace, TranslationSpace};
use cdpr_core::testing::{block, hard1, hard3, paper_scene, scene};
use cdpr_core::watch::Watch;
use cdpr_tests::scenes::Kind;
use cdpr_tests::{direction, rng, uniform};
use rand::RngExt;
use std::sync::Arc;

fn engines(scene: &Scene) -> (CspaceEngine, GjkEngine) {
    let cspace = CspaceEngine::new(scene, Interference::Exact).unwrap();
    (cspace, GjkEngine::new(scene, Interference::Exact).unwrap())
}

/// Compares both engines on many motions, on and off a lattice that contains the corners of the scene.
fn assert_agree(name: &str, spec: SceneSpec) {
    let scene = Scene::new(spec).unwrap();
    let (cspace, gjk) = engines(&scene);
    let space = TranslationSpace::of(gjk.conditions());
    let mut rng = rng(1);
    let (mut hits, mut free) = (0, 0);
    for _ in 0..4000 {
        let lattice = |rng: &mut rand_chacha::ChaCha8Rng| {
            let steps = Vector::from_fn(|_, _| f64::from(rng.random_range(0..41)) * 0.05);
            Point::from(steps.sup(&space.min.coords).inf(&space.max.coords))
        };
        let place = |rng: &mut rand_chacha::ChaCha8Rng| {
            if rng.random_bool(0.7) { lattice(rng) } else { space.sample(rng).unwrap() }
        };
        let p = place(&mut rng);
        let q = match rng.random_range(0..4) {
            0 => p,
            1 => p + direction(&mut rng) * 10f64.powf(uniform(&mut rng, -12.0, 0.0)),
            _ => place(&mut rng),
        };
        let valid = cspace.motion_valid(&p, &q);
        let why = || format!("{name}: {p} to {q}: cspace {:?}, gjk {:?}", cspace.explain(&p, &q), gjk.explain(&p, &q));
        let shallow = |checker: &dyn Checker| {
            checker.violations(&p, &q).iter().all(|v| v.margin.is_some_and(|m| m.abs() <= 1e-7))
        };
        assert!(valid == gjk.motion_valid(&p, &q) || (shallow(&cspace) && shallow(&gjk)), "{}", why());
        if valid { free += 1 } else { hits += 1 }
    }
    assert!(hits > 20 && free > 20, "{name}: {hits} hits, {free} free");
}

fn with_robot(change: impl Fn(&mut RobotSpec), obstacles: Vec<BodySpec>) -> SceneSpec {
    let mut spec = paper_scene("degenerate", obstacles);
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the paper's robot stands in the scene") };
    change(robot);
    spec
}

fn pillar() -> BodySpec {
    block("pillar", [0.3, 0.3, 1.5], [1.0, 1.0, 0.75])
}

fn hull(points: Vec<[f64; 3]>) -> BodySpec {
    BodySpec { name: Some("hull".into()), vertices: Some(points), ..BodySpec::default() }
}

fn cube(at: [f64; 3], side: f64) -> Vec<[f64; 3]> {
    let corner = |k: usize| std::array::from_fn(|axis| at[axis] + if k >> axis & 1 == 1 { side } else { 0.0 });
    (0..8).map(corner).collect()
}

#[test]
fn coplanar_facets_and_duplicate_vertices() {
    let mut points = cube([0.8, 0.8, 0.0], 0.4);
    points.extend(cube([0.8, 0.8, 0.0], 0.4));
    points.extend([[1.0, 0.8, 0.2], [1.0, 1.0, 0.4], [0.8, 0.9, 0.0]]); // on facets and edges
    assert_agree("duplicates", paper_scene("duplicates", vec![hull(points)]));
    // Two obstacles with facets in one plane, which is also the plane of the outlets (z = 0).
    let row = vec![block("a", [0.4, 0.4, 0.4], [0.6, 1.0, 0.2]), block("b", [0.4, 0.4, 0.4], [1.4, 1.0, 0.2])];
    assert_agree("coplanar", paper_scene("coplanar", row));
}

#[test]
fn platforms_without_volume() {
    let corner = |k: usize| [if k & 1 == 1 { 0.1 } else { -0.1 }, if k & 2 == 2 { 0.1 } else { -0.1 }, 0.0];
    let plate = |robot: &mut RobotSpec| {
        robot.platform = vec![hull((0..4).map(corner).collect())];
        robot.cables.iter_mut().enumerate().for_each(|(k, cable)| cable.attachment = corner(k));
    };
    assert_agree("plate", with_robot(plate, vec![pillar()]));
    let point = |robot: &mut RobotSpec| {
        robot.platform = vec![hull(vec![[0.0; 3]])];
        robot.cables.iter_mut().for_each(|cable| cable.attachment = [0.0; 3]);
    };
    assert_agree("point", with_robot(point, vec![pillar()]));
    let rod = |robot: &mut RobotSpec| {
        robot.platform = vec![hull(vec![[-0.2, 0.0, 0.0], [0.2, 0.0, 0.0]])];
        robot.cables.iter_mut().for_each(|cable| cable.attachment = [0.2, 0.0, 0.0]);
        robot.cables[0].attachment = [-0.2, 0.1, 0.05]; // off the rod
    };
    assert_agree("rod", with_robot(rod, vec![pillar()]));
}

#[test]
fn outlets_beside_obstacles() {
    // An edge in line with an outlet, an outlet in the plane of a facet, an outlet on an obstacle.
    assert_agree("edge in line", paper_scene("in line", vec![block("post", [0.4, 0.4, 1.0], [0.2, 0.2, 1.0])]));
    assert_agree("facet plane", paper_scene("plane", vec![block("wall", [0.2, 1.0, 1.0], [1.9, 1.0, 1.0])]));
    assert_agree("bolted", paper_scene("bolted", vec![block("base", [0.4, 0.4, 0.2], [1.8, 1.8, -0.1])]));
    let moved = |robot: &mut RobotSpec| robot.cables[3].outlet = [1.6, 1.7, 0.2];
    assert_agree("on its face", with_robot(moved, vec![block("base", [0.6, 0.6, 0.2], [1.7, 1.7, 0.1])]));
    let edge = |robot: &mut RobotSpec| robot.cables[3].outlet = [1.4, 1.7, 0.2];
    assert_agree("on its edge", with_robot(edge, vec![block("base", [0.6, 0.6, 0.2], [1.7, 1.7, 0.1])]));
}

#[test]
fn cables_side_by_side_crosswise_and_on_edges() {
    let parallel = |robot: &mut RobotSpec| {
        robot.cables[0].outlet = [0.5, 0.0, 2.0];
        robot.cables[1].outlet = [1.5, 0.0, 2.0];
        robot.cables[0].attachment = [-0.075, 0.0, 0.025]; // inside an edge
        robot.cables[1].attachment = [0.075, 0.0, 0.025];
    };
    assert_agree("parallel", with_robot(parallel, vec![pillar()]));
    let crosswise = |robot: &mut RobotSpec| {
        robot.cables[0].attachment = [0.05, -0.075, 0.02]; // both on the face that faces their outlets
        robot.cables[5].attachment = [-0.05, -0.075, -0.02];
    };
    assert_agree("crosswise", with_robot(crosswise, vec![pillar()]));
    let thick = |robot: &mut RobotSpec| robot.cables.iter_mut().for_each(|cable| cable.diameter = Some(0.02));
    assert_agree("thick", SceneSpec { clearance: Some(0.01), ..with_robot(thick, vec![pillar()]) });
}

#[test]
fn motions_along_a_facet_and_none_at_all() {
    let (cspace, gjk) = engines(&hard1());
    // The side of the pillar is at x = 1.15; the platform extends 0.075 m further.
    for (offset, free) in [(0.0, true), (1e-6, true), (-1e-6, false)] {
        let (p, q) = (Point::new(1.225 + offset, 0.9, 1.0), Point::new(1.225 + offset, 1.1, 1.0));
        for engine in [&cspace as &dyn Validity, &gjk] {
            let why = engine.violations(&p, &q);
            let platform = why.iter().any(|v| v.kind == cdpr_core::collision::Kind::PlatformObstacle);
            assert_eq!(platform, !free, "{offset}: {why:?}");
        }
    }
    for bad in [f64::NAN, f64::INFINITY, -1.0] {
        let p = Point::new(0.3, bad, 0.3);
        assert!(!cspace.state_valid(&p) && !cspace.motion_valid(&Point::new(0.3, 1.0, 0.3), &p));
    }
}

#[test]
fn a_workspace_that_leaves_a_plane_or_nothing() {
    let mut flat = paper_scene("flat", vec![pillar()]);
    flat.workspace = WorkspaceSpec { min: [0.0, 0.0, 0.0], max: [2.0, 2.0, 0.05] };
    flat.query = Some(QuerySpec::default());
    let (cspace, gjk) = engines(&scene(flat));
    let at = |x: f64, y: f64| Point::new(x, y, 0.025);
    for (p, q) in [(at(0.3, 0.3), at(0.3, 1.7)), (at(0.3, 0.3), at(1.7, 1.7)), (at(0.1, 0.1), at(0.1, 0.1))] {
        assert_eq!(cspace.motion_valid(&p, &q), gjk.motion_valid(&p, &q));
    }
    let mut none = paper_scene("none", vec![pillar()]);
    none.workspace = WorkspaceSpec { min: [0.0; 3], max: [2.0, 2.0, 0.01] };
    none.query = Some(QuerySpec::default());
    assert!(!engines(&scene(none)).0.state_valid(&at(0.3, 0.3)));
}

/// A platform that is a point, on cables given by outlet and attachment.
fn hung(cables: &[[[f64; 3]; 2]], obstacles: Vec<BodySpec>, half: [f64; 3], clearance: f64) -> Scene {
    let cable = |[outlet, attachment]: &[[f64; 3]; 2]| CableSpec {
        outlet: *outlet,
        attachment: *attachment,
        tension: None,
        ..CableSpec::default()
    };
    let mut spec = with_robot(
        |robot| {
            robot.platform = vec![hull(vec![[0.0; 3]])];
            robot.cables = cables.iter().map(cable).collect();
        },
        obstacles,
    );
    spec.workspace = WorkspaceSpec { min: half.map(|h| -h), max: half };
    spec.query = None;
    spec.clearance = Some(clearance);
    Scene::new(spec).unwrap()
}

/// The results of the gjk engine and of the cspace engine.
fn both(scene: &Scene, rule: Interference, p: [f64; 3], q: [f64; 3]) -> [bool; 2] {
    let (p, q) = (Point::from(p), Point::from(q));
    [
        GjkEngine::new(scene, rule).unwrap().motion_valid(&p, &q),
        CspaceEngine::new(scene, rule).unwrap().motion_valid(&p, &q),
    ]
}

#[test]
fn swept_cables_that_are_parallel_half_way() {
    // 10 mm apart where 50 mm are required; the common normal of the axes halfway is a rounding error.
    let (o, w) = ([-0.08160447454932651, 0.3, 4.0], [0.3638711867570829, -0.09945442189428133, -0.25716628767667166]);
    let q = [0.4237797607540267, -0.05240228634478725, 0.3379782824085175];
    let second = [o[0] + w[0], o[1] + w[1], o[2] + w[2]];
    let scene = hung(&[[o, [0.0; 3]], [second, q]], Vec::new(), [20.0; 3], 0.05);
    let (p, q) = (
        [-0.751042707113462, 0.13323062891473053, 1.0560967147806601],
        [-0.011251981954628731, -0.0037519844096714355, 0.9924575843674471],
    );
    assert_eq!(both(&scene, Interference::Swept, p, q), [false; 2]);
    // Parallel throughout, given with two decimals.
    let cables = [[[-1.33, 0.65, 3.0], [0.1, 0.2, -0.26]], [[-1.03, 0.72, 2.97], [0.4, 0.27, -0.29000000000000004]]];
    let (p, q) = (
        [1.7419167147301629, 1.2576838846506337, -0.8037014711059494],
        [1.9035684543789146, 1.311670146387843, -0.8063507953184006],
    );
    assert_eq!(both(&hung(&cables, Vec::new(), [3.0; 3], 0.1), Interference::Swept, p, q), [false; 2]);
}

#[test]
fn thin_obstacles_far_from_the_outlet_have_ends() {
    // A rod of 1 µm, 11 km away: nothing is hidden beyond its end.
    let slender = |x: f64, y: f64, z: f64| hull(cube_like([x, y, z]));
    let scene = hung(&[[[1.1e4, 0.0, 0.0], [0.0; 3]]], vec![slender(5e-7, 5e-7, 0.5)], [50.0; 3], 0.0);
    assert_eq!(both(&scene, Interference::Exact, [-10.0, 0.0, 20.0], [-10.0, 0.0, 20.0]), [true; 2]);
    // A blade that is 0.1 mm thick at the bottom and 5 nm at the top, 60 m away, passed 20 µm above its edge.
    let thickness = |z: f64| if z < 0.0 { 0.5e-4 } else { 2.5e-9 };
    let blade = cube_like([0.05, 1.0, 0.5]).into_iter().map(|[x, y, z]| [x, y * thickness(z), z]).collect();
    let scene = hung(&[[[60.0, 0.0, 0.0], [0.0; 3]]], vec![hull(blade)], [30.0; 3], 0.0);
    let above = [-5.0, 0.0, (0.5 + 2e-5) * 65.0 / 59.95];
    assert_eq!(both(&scene, Interference::Exact, above, above), [true; 2]);
}

fn cube_like(half: [f64; 3]) -> Vec<[f64; 3]> {
    let corner = |k: usize| std::array::from_fn(|axis| if k >> axis & 1 == 1 { half[axis] } else { -half[axis] });
    (0..8).map(corner).collect()
}

#[test]
fn a_box_of_positions_thinner_than_touching() {
    let scene = hung(&[[[0.0, 0.0, 3.0], [0.0; 3]]], vec![block("cube", [0.5; 3], [0.0; 3])], [1e-30, 1.0, 1.0], 0.0);
    assert_eq!(both(&scene, Interference::Exact, [0.0; 3], [9e-10, 0.0, 0.0]), [false; 2]);
}

#[test]
fn a_path_through_nan_is_not_valid() {
    let scene = hard1();
    let start = scene.start().unwrap();
    let path = [start, Point::new(f64::NAN, 1.0, 0.3), start];
    for engine in [&engines(&scene).0 as &dyn Checker, &engines(&scene).1] {
        assert!(!check_path(engine, &path, &Watch::NONE).unwrap().valid);
    }
}

#[test]
fn round_bodies_with_a_clearance_compile_soon() {
    // If fattened before the hull, their differences would be 40,000 points, compared pair by pair for minutes.
    let ball = |count: usize, radius: f64| {
        let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
        let point = |k: usize| {
            let z = 1.0 - (2 * k + 1) as f64 / count as f64;
            let (sin, cos) = (golden * k as f64).sin_cos();
            let around = (1.0 - z * z).sqrt();
            [1.0 + radius * around * cos, 1.0 + radius * around * sin, 1.0 + radius * z]
        };
        (0..count).map(point).collect::<Vec<_>>()
    };
    let centred = |points: Vec<[f64; 3]>| points.into_iter().map(|p| p.map(|x| x - 1.0)).collect();
    let round = |robot: &mut RobotSpec| {
        robot.platform = vec![hull(centred(ball(50, 0.08)))];
        robot.cables.truncate(1);
        robot.cables[0].attachment = [0.0, 0.0, -0.2];
    };
    let spec = SceneSpec { clearance: Some(0.02), ..with_robot(round, vec![hull(ball(100, 0.3))]) };
    assert_agree("round", spec);
}

#[test]
fn the_same_answers_without_simd() {
    let mut rng = rng(11);
    for case in 0..40 {
        let kind = Kind { clearance: [0.0, 0.05][case % 2], special: true, ..Kind::default() };
        let scene = cdpr_tests::scenes::scene(&mut rng, kind);
        let fast = CspaceEngine::new(&scene, Interference::Exact).unwrap();
        let portable = fast.clone().portable();
        let space = TranslationSpace::of(fast.conditions());
        for _ in 0..500 {
            let (Some(p), Some(q)) = (space.sample(&mut rng), space.sample(&mut rng)) else { break };
            let q = p + (q - p) * 10f64.powf(uniform(&mut rng, -6.0, 0.0));
            assert_eq!(fast.motion_valid(&p, &q), portable.motion_valid(&p, &q), "case {case}: {p} to {q}");
        }
    }
}

#[test]
fn recompiling_after_a_change_gives_what_compiling_gives() {
    let place = |k: usize, shift: f64| {
        let at = [0.3 + 0.25 * (k % 6) as f64 + shift, 0.4 + 0.3 * (k / 6) as f64, 0.2];
        block(&format!("post {k}"), [0.05, 0.05, 0.4], at)
    };
    let posts = |moved: Option<usize>| (0..18).map(move |k| place(k, if moved == Some(k) { 0.07 } else { 0.0 }));
    let before = CspaceEngine::new(&scene(paper_scene("posts", posts(None).collect())), Interference::Exact).unwrap();
    let changes: Vec<Vec<BodySpec>> = vec![
        posts(None).collect(),
        posts(Some(7)).collect(),
        posts(None).skip(1).collect(),
        posts(None).rev().collect(),
        posts(None).chain([block("new", [0.1; 3], [1.8, 1.8, 1.8])]).collect(),
        Vec::new(),
    ];
    let mut rng = rng(12);
    for (k, obstacles) in changes.into_iter().enumerate() {
        for clearance in [0.0, 0.02] {
            let after = scene(SceneSpec { clearance: Some(clearance), ..paper_scene("posts", obstacles.clone()) });
            let (again, fresh) = (before.recompiled(&after, &Watch::NONE).unwrap(), engines(&after).0);
            let space = TranslationSpace::of(fresh.conditions());
            for _ in 0..2000 {
                let (p, q) = (space.sample(&mut rng).unwrap(), space.sample(&mut rng).unwrap());
                let q = p + (q - p) * 0.2;
                assert_eq!(again.motion_valid(&p, &q), fresh.motion_valid(&p, &q), "change {k}: {p} to {q}");
            }
        }
    }
}

#[test]
fn a_margin_is_the_depth_of_the_deepest_state() {
    const SAMPLES: usize = 100;
    let mut rng = rng(14);
    let mut seen = 0;
    for _ in 0..400 {
        let scene = cdpr_tests::scenes::scene(&mut rng, Kind::default());
        let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
        for _ in 0..4 {
            let p = Point::from(cdpr_tests::vector(&mut rng, 2.0));
            let q = p + direction(&mut rng) * uniform(&mut rng, 0.1, 2.0);
            let at = |k: usize| p + (q - p) * (k as f64 / SAMPLES as f64);
            let states: Vec<_> = (0..=SAMPLES).map(|k| engine.violations(&at(k), &at(k))).collect();
            let half_step = 0.5 * (q - p).norm() / SAMPLES as f64;
            for found in engine.violations(&p, &q) {
                use cdpr_core::collision::Kind::{CableObstacle, PlatformObstacle};
                if !matches!(found.kind, CableObstacle | PlatformObstacle) {
                    continue;
                }
                let same =
                    |v: &&cdpr_core::collision::Violation| (v.kind, &v.culprits) == (found.kind, &found.culprits);
                let sampled =
                    states.iter().flatten().filter(same).filter_map(|v| v.margin).fold(f64::INFINITY, f64::min);
                if sampled.is_finite() {
                    seen += 1;
                    let margin = found.margin.unwrap();
                    assert!(margin <= sampled + 1e-9 && margin >= sampled - half_step, "{sampled}, told {found:?}");
                }
            }
        }
    }
    assert!(seen > 100, "{seen}");
}

#[test]
fn a_motion_is_free_up_to_its_first_contact() {
    let mut rng = rng(15);
    let (mut contacts, mut free, mut seams) = (0, 0, 0);
    for k in 0..300 {
        let clearance = if k % 3 == 0 { 0.03 } else { 0.0 };
        let kind = Kind { clearance, special: k % 2 == 0, ..Kind::default() };
        let scene = cdpr_tests::scenes::scene(&mut rng, kind);
        let rule = if k % 4 == 0 { Interference::Swept } else { Interference::Exact };
        let engines: [Box<dyn Checker>; 2] =
            [Box::new(CspaceEngine::new(&scene, rule).unwrap()), Box::new(GjkEngine::new(&scene, rule).unwrap())];
        for _ in 0..4 {
            let p = Point::from(cdpr_tests::vector(&mut rng, 2.0));
            let q = p + direction(&mut rng) * uniform(&mut rng, 0.1, 2.0);
            for engine in &engines {
                let violations = engine.violations(&p, &q);
                let Some((t, index)) = engine.first_contact(&p, &q) else {
                    free += 1;
                    assert!(violations.is_empty() && engine.motion_valid(&p, &q));
                    continue;
                };
                let until = |t: f64| p + (q - p) * t;
                assert!(t == 0.0 || engine.motion_valid(&p, &until(t - 1e-6)), "{t}");
                assert!(engine.breaks(index, &p, &until(t)) && !engine.motion_valid(&p, &until(t)));
                let conditions = engine.conditions();
                let condition = &conditions.list[index];
                if condition.details().closes_seam(&conditions.bodies) {
                    seams += 1; // the violation is reported for a part beside it, which is met later
                    assert!(violations.iter().all(|violation| t <= violation.at));
                    continue;
                }
                contacts += 1;
                let found = (t, conditions.kind(condition), conditions.culprits(condition));
                let first = violations.into_iter().next().unwrap();
                assert_eq!(found, (first.at, first.kind, first.culprits));
            }
        }
    }
    assert!(contacts > 500 && free > 50, "{contacts} {free} {seams}");
}

#[test]
fn forbidden_polyhedra_name_the_condition_that_they_belong_to() {
    let mut rng = rng(16);
    let (mut inside, mut near_clearance) = (0, 0);
    for k in 0..60 {
        let clearance = [0.03, 0.0, 0.1][k % 3];
        let scene = cdpr_tests::scenes::scene(&mut rng, Kind { clearance, ..Kind::default() });
        let (cspace, gjk) = engines(&scene);
        let pieces = cspace.pieces(&Watch::NONE).unwrap();
        let certain = cspace.certain_polyhedra(&Watch::NONE).unwrap();
        // The engine has compiled exactly the pieces of the conditions, except for regions that contain no position.
        let of_conditions = gjk.pieces(&Watch::NONE).unwrap();
        assert!(pieces.iter().all(|piece| of_conditions.contains(piece)));
        // They are computed once.
        assert!(Arc::ptr_eq(&pieces, &cspace.pieces(&Watch::NONE).unwrap()));
        assert!(Arc::ptr_eq(&certain, &cspace.certain_polyhedra(&Watch::NONE).unwrap()));
        let space = TranslationSpace::of(gjk.conditions());
        for _ in 0..600 {
            let Some(p) = space.sample(&mut rng) else { break };
            for polyhedron in certain.iter() {
                let contains = |planes: &[HalfSpace], p: &Point| planes.iter().all(|plane| plane.height(p) < 0.0);
                let (half_spaces, of_contact) = (&polyhedron.half_spaces, &polyhedron.of_contact);
                if !contains(half_spaces, &p) {
                    assert!(!of_contact.as_ref().is_some_and(|planes| contains(planes, &p)));
                    continue;
                }
                inside += 1;
                assert!(gjk.breaks(polyhedron.condition, &p, &p));
                // The surface of the polyhedron is forbidden as well.
                let direction = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0));
                let out = |plane: &HalfSpace| -plane.height(&p) / plane.normal.dot(&direction);
                let far = half_spaces.iter().map(out).filter(|t| *t > 0.0).fold(1.0, f64::min);
                let edge = p + direction * (far * (1.0 - 1e-12));
                if contains(half_spaces, &edge) && (0..3).all(|k| (space.min[k]..=space.max[k]).contains(&edge[k])) {
                    let Conditions { bodies, list, .. } = gjk.conditions();
                    let slack = list[polyhedron.condition].details().slack(bodies, &edge);
                    // Far from its outlet, a cable may be a little inside a shadow and still touch.
                    let breaks = gjk.breaks(polyhedron.condition, &edge, &edge);
                    assert!(breaks || of_contact.is_none() && slack < 1e-8, "{edge} {slack}");
                    near_clearance += usize::from(of_contact.as_ref().is_some_and(|planes| !contains(planes, &edge)));
                }
            }
        }
    }
    assert!(inside > 1000 && near_clearance > 300, "{inside} {near_clearance}");
}

#[test]
fn both_engines_plan_the_same_path() {
    for scene in [hard1(), hard3()] {
        for seed in 0..10 {
            let of = |engine| {
                let options = PlanOptions { engine, seed, ..PlanOptions::paper() };
                let found = plan(&scene, &options, &|| false).unwrap().result;
                (found.waypoints(), found.raw_waypoints(), found.stats.motion_checks)
            };
            assert_eq!(of(Engine::Cspace), of(Engine::Gjk), "{} seed {seed}", scene.name());
        }
    }
}

#[test]
fn a_million_checks_allocate_nothing() {
    let engine = engines(&hard3()).0;
    let space = TranslationSpace::of(engine.conditions());
    let mut rng = rng(13);
    let places: Vec<Point> = (0..1001).map(|_| space.sample(&mut rng).unwrap()).collect();
    let mut free = 0;
    let counted = allocation_counter::measure(|| {
        for round in 0..1000 {
            let step = 1 + round % 7;
            free +=
                places.windows(2).filter(|w| engine.motion_valid(&w[0], &(w[0] + (w[1] - w[0]) / step as f64))).count();
        }
    });
    assert_eq!(counted.count_total, 0);
    assert!(free > 10_000, "{free}");
}

#[test]
fn a_cable_alone_in_an_empty_hall() {
    let lone = |robot: &mut RobotSpec| {
        let one = CableSpec { outlet: [1.0, 1.0, 2.0], attachment: [0.0, 0.0, 0.025], ..robot.cables[0].clone() };
        robot.cables = vec![one];
    };
    let (cspace, gjk) = engines(&scene(with_robot(lone, Vec::new())));
    for z in [0.025, 1.0, 1.975] {
        let p = Point::new(1.0, 1.0, z);
        assert_eq!(cspace.state_valid(&p), gjk.state_valid(&p), "z = {z}");
        assert_eq!(cspace.clearance(&p, &p), gjk.clearance(&p, &p));
    }
}
