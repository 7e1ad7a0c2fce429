//! Start, goal and workspace proposed for new scenes.

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::model::{BodySpec, CableSpec, QuerySpec, RobotSource, RobotSpec, Scene, SceneSpec, WrenchSpec};
use cdpr_core::new_scene::{Proposal, query, unheld, workspace};
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{StateSpace, Status, TranslationSpace};
use cdpr_core::testing::{block, paper_robot, paper_scene, scene};
use cdpr_core::watch::Watch;
use cdpr_tests::{built_robot, rng, uniform};
use rand::RngExt;

/// The paper's robot in a room with up to 16 boxes at random places.
fn room(seed: u64) -> Scene {
    let mut rng = rng(seed);
    let outlets: Vec<Point> = paper_robot().cables.iter().map(|cable| cable.outlet.into()).collect();
    let mut boxes = Vec::new();
    for k in 0..rng.random_range(6..=16) {
        let [sides, at]: [[f64; 3]; 2] =
            [[0.1, 0.6], [0.0, 2.0]].map(|[low, high]| std::array::from_fn(|_| uniform(&mut rng, low, high)));
        let near = |outlet: &Point| (0..3).all(|axis| (outlet[axis] - at[axis]).abs() < 0.5 * sides[axis] + 0.05);
        if !outlets.iter().any(near) {
            boxes.push(block(&format!("box {k}"), sides, at));
        }
    }
    scene(SceneSpec { query: None, ..paper_scene("room", boxes) })
}

/// Share of pairs of random valid positions that are joined by a straight line; `None` if there are hardly any.
fn joined_share(scene: &Scene) -> Option<f64> {
    let engine = engine_for(scene, Engine::Gjk, Interference::Exact).unwrap();
    let space = TranslationSpace::of(engine.conditions());
    let mut rng = rng(77);
    let drawn = (0..20_000).filter_map(|_| space.sample(&mut rng));
    let places: Vec<Point> = drawn.filter(|place| engine.state_valid(place)).take(200).collect();
    let free = places.chunks_exact(2).filter(|pair| engine.motion_valid(&pair[0], &pair[1])).count();
    (places.len() >= 20).then(|| free as f64 / (places.len() / 2) as f64)
}

fn solved(scene: &Scene, [start, goal]: [Point; 2]) -> bool {
    let found = plan(Query::of(scene).starting_at(start).to(goal), &PlanOptions::default(), &()).unwrap().result;
    found.status == Status::Solved
}

#[test]
fn a_query_is_found_in_every_room_where_many_pairs_are_joined() {
    let (mut open, mut hidden, mut detours) = (0, 0, 0);
    for seed in 0..50 {
        let room = room(seed);
        let many = joined_share(&room).is_some_and(|share| share >= 0.05);
        match query(&room, &Watch::NONE).unwrap() {
            Proposal::Query([start, goal]) => {
                assert!(solved(&room, [start, goal]), "{seed}");
                let engine = engine_for(&room, Engine::Gjk, Interference::Exact).unwrap();
                detours += usize::from(!engine.motion_valid(&start, &goal));
            }
            Proposal::Lacking(reason) => {
                assert!(!many, "{seed}: {reason}");
                hidden += 1;
            }
        }
        open += usize::from(many);
    }
    println!("{open} rooms with many pairs, {detours} queries with something in the way, {hidden} without a query");
    assert!(open >= 30 && detours >= 20, "{open} {detours}");
}

#[test]
fn few_valid_positions_are_found_and_given_ends_are_kept() {
    // Three limits of length leave a cell of 6 cm.
    let mut spec = SceneSpec { query: None, ..paper_scene("cell", Vec::new()) };
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the paper's robot stands in the scene") };
    for cable in &mut robot.cables[..3] {
        let length = (Point::from(cable.outlet) - Point::new(0.8, 0.9, 0.6) - Vector::from(cable.attachment)).norm();
        cable.length = Some([length - 0.03, length + 0.03]);
    }
    let cell = scene(spec);
    let engine = engine_for(&cell, Engine::Cspace, Interference::Exact).unwrap();
    let space = TranslationSpace::of(engine.conditions());
    let mut rng = rng(5);
    let hits = (0..100_000).filter(|_| engine.state_valid(&space.sample(&mut rng).unwrap())).count();
    assert!((1..20).contains(&hits), "{hits}");
    let Proposal::Query(ends) = query(&cell, &Watch::NONE).unwrap() else { panic!("the cell was not found") };
    assert!(solved(&cell, ends));

    let start = Point::new(0.3, 1.0, 0.3);
    let given = |start: [f64; 3]| {
        let query = Some(QuerySpec { start: Some(start.into()), ..QuerySpec::default() });
        scene(SceneSpec { query, ..paper_scene("pillar", vec![block("pillar", [0.3, 0.3, 1.5], [1.0, 1.0, 0.75])]) })
    };
    let Proposal::Query(ends) = query(&given(start.into()), &Watch::NONE).unwrap() else { panic!("there are many") };
    assert_eq!(ends[0], start);
    assert!(
        !engine_for(&given(start.into()), Engine::Gjk, Interference::Exact).unwrap().motion_valid(&ends[0], &ends[1])
    );
    let Proposal::Lacking(why) = query(&given([1.0, 1.0, 0.3]), &Watch::NONE).unwrap() else {
        panic!("it is in the pillar")
    };
    assert!(why.starts_with("the start is not valid: ") && why.contains("pillar"), "{why}");
}

/// A robot with the last cables of the paper's robot (the upper ones first), its platform and its forces; if `point`,
/// all cables are attached at one point on top.
fn robot(cables: usize, point: bool) -> RobotSpec {
    let mut robot = paper_robot();
    robot.cables = robot.cables.split_off(8 - cables);
    if point {
        robot.cables.iter_mut().for_each(|cable| cable.attachment = [0.0, 0.0, 0.025]);
    }
    robot
}

/// The new scene of a robot.
fn new_scene(robot: RobotSpec, wrench: bool) -> Scene {
    let made = scene(SceneSpec { query: None, robot: RobotSource::Inline(robot), ..paper_scene("new", Vec::new()) });
    let around = workspace(&made);
    let mut spec = made.spec().clone();
    spec.workspace.min = around.min.into();
    spec.workspace.max = around.max.into();
    spec.wrench = wrench.then(WrenchSpec::default);
    scene(spec)
}

#[test]
fn new_workspaces_leave_room_for_one_to_eight_cables() {
    for (cables, point) in (1..=8).map(|cables| (cables, false)).chain((1..=4).map(|cables| (cables, true))) {
        let new = new_scene(robot(cables, point), false);
        let Proposal::Query(ends) = query(&new, &Watch::NONE).unwrap() else { panic!("{cables} {point}") };
        assert!(solved(&new, ends) && ends[0] != ends[1], "{cables} {point}");
    }
    // A fifth cable comes from below, and would pass through the platform.
    let Proposal::Lacking(why) = query(&new_scene(robot(5, true), false), &Watch::NONE).unwrap() else { panic!() };
    assert!(why.starts_with("found no valid position; at ") && why.ends_with("meets the platform"), "{why}");
    // In a plane, with a platform without volume; all outlets in one place on the floor, and a platform that is a point.
    let flat = |platform: BodySpec, outlets: &[[f64; 3]]| {
        let cable =
            |outlet: &[f64; 3]| CableSpec { outlet: *outlet, attachment: [0.0; 3], ..paper_robot().cables[0].clone() };
        RobotSpec { platform: vec![platform], cables: outlets.iter().map(cable).collect(), ..paper_robot() }
    };
    let plate = BodySpec { cuboid: Some([0.2, 0.0, 0.2]), ..BodySpec::default() };
    let point = BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() };
    let planar = [[0.0, 1.0, 0.0], [3.0, 1.0, 0.0], [0.0, 1.0, 2.0], [3.0, 1.0, 2.0]];
    for robot in [flat(plate, &planar), flat(point.clone(), &planar), flat(point, &[[0.0; 3]; 2])] {
        let new = new_scene(robot, false);
        let Proposal::Query(ends) = query(&new, &Watch::NONE).unwrap() else { panic!("{:?}", new.workspace()) };
        assert!(solved(&new, ends));
    }
}

#[test]
fn infeasible_wrenches_are_explained() {
    let told = |robot: RobotSpec| unheld(&new_scene(robot, true), &Watch::NONE).unwrap();
    assert_eq!(told(RobotSpec { version: None, ..built_robot("cogiro").spec().clone() }), None);
    let four = told(robot(4, false)).unwrap();
    assert!(
        four.contains("the cables can hold the platform at none of 1000 random positions free of collisions; at (")
    );
    assert!(four.contains("rank 3 of 6, underconstrained"), "{four}"); // the lines of the four cables meet in a point
    let one = told(robot(1, false)).unwrap();
    assert!(one.contains("robot.center_of_mass: found a moment"), "{one}");
    assert_eq!(told(robot(4, true)), None); // a point mass that hangs on four cables
}
