//! Inner edges and corners, where parts of a body meet all around: inside the body, but in the interior of no part.

use std::f64::consts::{FRAC_PI_2, TAU};

use cdpr_certify::check_certificate;
use cdpr_core::collision::{Checker, CspaceEngine, GjkEngine, Interference, Kind, Validity};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Polytope, Pose, Rotation, Vector};
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::model::{BodySpec, CableSpec, QuerySpec, RobotSource, RobotSpec, Scene, WorkspaceSpec};
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::Status;
use cdpr_core::proof::{Answer, Certificate, decide};
use cdpr_core::testing::{block, paper_robot, paper_scene, walled};
use cdpr_core::watch::Watch;
use cdpr_tests::scenes::{body_spec, scene_with_a_cable};
use cdpr_tests::{compiled, rng, rotation, vector};

/// A box by its least and its greatest corner.
type Span = ([f64; 3], [f64; 3]);

const FOUR: [Span; 4] = [
    ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0]),
    ([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]),
    ([0.0, 0.0, 1.0], [1.0, 1.0, 2.0]),
    ([1.0, 0.0, 1.0], [2.0, 1.0, 2.0]),
];
const ON_A_LARGER_ONE: [Span; 3] =
    [([-1.0, 0.0, -1.0], [3.0, 1.0, 1.0]), ([0.0, 0.0, 1.0], [1.0, 1.0, 2.0]), ([1.0, 0.0, 1.0], [2.0, 1.0, 2.0])];

fn eight() -> Vec<Span> {
    let cube = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|k| k as f64);
    (0..8).map(|k| (cube(k), cube(k).map(|x| x + 1.0))).collect()
}

fn at(x: f64, y: f64, z: f64) -> Point {
    Point::new(x, y, z)
}

/// Where the bodies of a test are, and how they are turned.
#[derive(Clone, Copy)]
struct Place {
    turn: Rotation,
    shift: Vector,
}

impl Place {
    /// Upright, then ten tilted ones.
    fn all() -> Vec<Self> {
        let mut rng = rng(1);
        let upright = Place { turn: Rotation::identity(), shift: Vector::zeros() };
        let tilted = (0..10).map(|_| Place { turn: rotation(&mut rng), shift: vector(&mut rng, 5.0) });
        std::iter::once(upright).chain(tilted).collect()
    }

    fn of(&self, p: Point) -> Point {
        self.turn * p + self.shift
    }

    fn body(&self, name: Option<&str>, (low, high): &Span) -> BodySpec {
        let corner = |k: usize| Point::from(Vector::from_fn(|axis, _| [low, high][k >> axis & 1][axis]));
        let corners: Vec<Point> = (0..8).map(|k| self.of(corner(k))).collect();
        body_spec(name, &Polytope::hull_of(&corners).unwrap())
    }

    fn block(&self, spans: &[Span]) -> Vec<BodySpec> {
        spans.iter().map(|span| self.body(Some("block"), span)).collect()
    }

    /// Whether both engines accept a motion.
    fn free(&self, scene: &Scene, from: Point, to: Point) -> bool {
        let engines: [Box<dyn Checker>; 2] = [
            Box::new(CspaceEngine::new(scene, Interference::Exact).unwrap()),
            Box::new(GjkEngine::new(scene, Interference::Exact).unwrap()),
        ];
        let told = engines.map(|engine| {
            let valid = engine.motion_valid(&self.of(from), &self.of(to));
            assert_eq!(valid, engine.violations(&self.of(from), &self.of(to)).is_empty());
            valid
        });
        assert_eq!(told[0], told[1]);
        told[0]
    }
}

fn point() -> Vec<BodySpec> {
    vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }]
}

const IGNORE_CABLE: [[&str; 2]; 1] = [["cable", "block"]];
const IGNORE_PLATFORM: [[&str; 2]; 1] = [["platform", "block"]];

#[test]
fn a_cable_or_a_point_along_an_inner_edge_is_inside() {
    for place in Place::all() {
        for spans in [&FOUR[..], &ON_A_LARGER_ONE] {
            let scene = |outlet: Point, ignore: &[[&str; 2]]| {
                let ends = [place.of(outlet), Point::origin()];
                scene_with_a_cable(point(), ends, place.block(spans), ignore).unwrap()
            };
            let behind = scene(at(1.0, 5.0, 1.0), &IGNORE_PLATFORM);
            for y in [-1.0, 0.0, 0.5, 1.0 - 1e-8] {
                assert!(!place.free(&behind, at(1.0, y, 1.0), at(1.0, y, 1.0)), "{y}");
            }
            assert!(!place.free(&behind, at(1.0, 3.0, 1.0), at(1.0, -1.0, 1.0)));
            assert!(place.free(&behind, at(1.0, 3.0, 1.0), at(1.0, 1.0, 1.0)));
            assert!(!place.free(&scene(at(1.0, 1.0, 1.0), &[]), at(1.0, 0.0, 1.0), at(1.0, 0.0, 1.0)));

            let above = scene(at(1.0, 5.0, 5.0), &IGNORE_CABLE);
            for y in [1e-8, 0.5, 1.0 - 1e-8] {
                assert!(!place.free(&above, at(1.0, y, 1.0), at(1.0, y, 1.0)), "{y}");
            }
            for y in [-0.5, 0.0, 1.0, 1.5] {
                assert!(place.free(&above, at(1.0, y, 1.0), at(1.0, y, 1.0)), "{y}");
            }
            assert!(!place.free(&above, at(1.0, -1.0, 1.0), at(1.0, 2.0, 1.0)));
        }
    }
}

#[test]
fn a_point_where_eight_boxes_meet_is_inside() {
    for place in Place::all() {
        let scene = |spans: &[Span]| {
            let ends = [place.of(at(1.0, 5.0, 5.0)), Point::origin()];
            scene_with_a_cable(point(), ends, place.block(spans), &IGNORE_CABLE).unwrap()
        };
        let middle = at(1.0, 1.0, 1.0);
        assert!(!place.free(&scene(&eight()), middle, middle));
        assert!(place.free(&scene(&eight()[1..]), middle, middle));
    }
}

#[test]
fn a_platform_of_four_boxes_is_closed_along_its_inner_edge() {
    for place in Place::all() {
        let platform: Vec<BodySpec> = FOUR.iter().map(|span| place.body(None, span)).collect();
        for attachment in [at(1.0, 1.5, 1.0), at(1.0, 1.0, 1.0)] {
            let ends = [place.of(at(1.0, -5.0, 1.0)), place.of(attachment)];
            let scene = scene_with_a_cable(platform.clone(), ends, Vec::new(), &[]).unwrap();
            let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
            let gjk = GjkEngine::new(&scene, Interference::Exact).unwrap();
            let told = engine.violations(&Point::origin(), &Point::origin());
            assert_eq!(told.iter().map(|v| v.kind).collect::<Vec<_>>(), [Kind::CablePlatform]);
            assert!(!gjk.state_valid(&Point::origin()) && !engine.state_valid(&Point::origin()));
            let beyond = Point::from(place.turn * Vector::new(0.0, -9.0, 0.0));
            assert!(gjk.state_valid(&beyond) && engine.state_valid(&beyond));
        }
        let inside =
            scene_with_a_cable(platform.clone(), [at(9.0, 9.0, 9.0), place.of(at(1.0, 0.5, 1.0))], Vec::new(), &[]);
        assert!(inside.unwrap_err().to_string().contains("inside several abutting parts"));

        // The edge of a wedge along the inner edge.
        let wedge =
            [[1.0, 0.2, 1.0], [1.0, 0.8, 1.0], [9.0, 0.2, 1.1], [9.0, 0.8, 1.1], [9.0, 0.2, 0.9], [9.0, 0.8, 0.9]];
        let wedge = Polytope::hull_of(&wedge.map(|p| place.of(Point::from(p)))).unwrap();
        let ends = [place.of(at(1.0, 20.0, 1.0)), place.of(at(1.0, 1.0, 1.0))];
        let scene = scene_with_a_cable(platform, ends, vec![body_spec(Some("wedge"), &wedge)], &[]).unwrap();
        assert!(!GjkEngine::new(&scene, Interference::Exact).unwrap().state_valid(&Point::origin()));
        assert!(!CspaceEngine::new(&scene, Interference::Exact).unwrap().state_valid(&Point::origin()));
    }
}

#[test]
fn an_outlet_in_an_inner_corner_is_refused() {
    let place = Place::all()[0];
    let inside = scene_with_a_cable(point(), [at(1.0, 1.0, 1.0), Point::origin()], place.block(&eight()), &[]);
    assert!(inside.unwrap_err().to_string().contains("inside obstacle \"block\""));
}

#[test]
fn a_turn_that_ends_with_a_cable_along_an_inner_edge_is_refused() {
    let place = Place::all()[0];
    let ends = [at(1.0, 5.0, 1.0), at(1.0, 0.0, 0.0)];
    let scene = scene_with_a_cable(point(), ends, place.block(&FOUR), &IGNORE_PLATFORM).unwrap();
    let engine = compiled(&scene);
    let pose = |x: f64, y: f64, angle: f64| Pose::new(at(x, y, 1.0), Rotation::from_scaled_axis(Vector::z() * angle));
    let (before, along) = (pose(-9.0, 4.0, 0.0), pose(1.0, -2.0, FRAC_PI_2));
    assert!(engine.state_valid(&before) && !engine.state_valid(&along) && !engine.motion_valid(&before, &along));
    assert!(engine.state_valid(&pose(1.0, 1.0, FRAC_PI_2)));
    // The cable is certain to be inside: contact alone is also refused where poses turn, because it cannot be proved
    // free.
    let told = engine.violations(&along, &along);
    assert!(told.iter().any(|v| !v.unproved && v.gap.is_some_and(|gap| gap < -0.1)), "{} told", told.len());
}

#[test]
fn ignoring_one_obstacle_keeps_the_seams_of_others() {
    // A fifth obstacle overlaps all four around the edge; without it they still meet all around.
    let place = Place::all()[3];
    let mut bodies: Vec<BodySpec> =
        FOUR.iter().zip(["a", "b", "c", "d"]).map(|(span, name)| place.body(Some(name), span)).collect();
    bodies.push(place.body(Some("middle"), &([0.5, 0.0, 0.5], [1.5, 1.0, 1.5])));
    let ends = [place.of(at(1.0, 5.0, 1.0)), Point::origin()];
    let free = |ignore: &[[&str; 2]]| {
        let mut all: Vec<[&str; 2]> = ["a", "b", "c", "d", "middle"].map(|name| ["platform", name]).to_vec();
        all.extend(ignore);
        let scene = scene_with_a_cable(point(), ends, bodies.clone(), &all).unwrap();
        place.free(&scene, at(1.0, -1.0, 1.0), at(1.0, -1.0, 1.0))
    };
    assert!(!free(&[]) && !free(&[["cable", "middle"]]));
    assert!(free(&[["cable", "middle"], ["cable", "a"]]));
}

#[test]
fn parts_in_a_fan_around_an_edge_close_it() {
    for count in 3..9 {
        for place in Place::all() {
            let rim = |k: i32| {
                let angle = TAU * f64::from(k) / f64::from(count) + 0.1;
                at(angle.cos(), angle.sin(), 0.3 * f64::from(k % count))
            };
            let part = |k: i32| {
                let corners = [at(0.0, 0.0, -1.0), at(0.0, 0.0, 1.0), rim(k), rim(k + 1)];
                body_spec(Some("block"), &Polytope::hull_of(&corners.map(|corner| place.of(corner))).unwrap())
            };
            let ends = [place.of(at(0.0, 0.0, 2.0)), Point::origin()];
            let free = |parts: i32| {
                let bodies = (0..parts).map(part).collect();
                let scene = scene_with_a_cable(point(), ends, bodies, &IGNORE_PLATFORM).unwrap();
                place.free(&scene, at(0.0, 0.0, -2.0), at(0.0, 0.0, -2.0))
            };
            assert!(!free(count) && free(count - 1), "{count}");
        }
    }
}

#[test]
fn a_wall_of_four_boxes_closes_the_way_as_one_box_does() {
    // The wall of `walled`, divided along its length and its height at the plane in which the platform would pass.
    let mut spec = walled(0.94);
    let wall = spec.obstacles.remove(0);
    let ([x, y, z], [dx, dy, dz]) = (wall.position.unwrap(), wall.cuboid.unwrap());
    for k in 0..4 {
        let sign = |bit: usize| if k >> bit & 1 == 1 { 0.25 } else { -0.25 };
        spec.obstacles.push(block("wall", [dx, 0.5 * dy, 0.5 * dz], [x, y + sign(0) * dy, z + sign(1) * dz]));
    }
    let scene = Scene::new(spec).unwrap();
    assert!(scene.seams().iter().any(|seam| seam.gap.dimension == 1));
    let engine = engine_for(&scene, Default::default(), Interference::Exact).unwrap();
    let ends = [&scene.start().unwrap(), &scene.goal().unwrap()];
    let Answer::NoPath(proof) = decide(&*engine, ends, PROOF_EFFORT, &Watch::NONE).unwrap() else {
        panic!("a way through the wall")
    };
    let certificate = serde_json::to_string(&Certificate::of(&proof, &scene, &*engine)).unwrap();
    check_certificate(&scene, &certificate, &Watch::NONE).unwrap();
}

#[test]
fn pulled_paths_pass_their_last_check_where_parts_share_an_edge() {
    // Bends lie where a cable touches the edge that three tetrahedra share.
    let [x, y, z] = [1.0441616304698487, 0.9403173485277375, 0.8970730550956694];
    let (low, high) = ([x, y, z], [x, y, 1.2615111196628317]);
    let rim = [
        [1.4085996950370108, y, z],
        [x, 1.3047554130948997, z],
        [0.6797235659026865, y, z],
        [x, 0.5758792839605753, z],
    ];
    let part = |k: usize| {
        let vertices = Some(vec![low, high, rim[k], rim[k + 1]]);
        BodySpec { name: Some("fan".to_string()), vertices, ..BodySpec::default() }
    };
    let outlets = [[0.0, 0.0, 2.0], [0.0, 2.0, 0.0], [0.0, 2.0, 2.0], [2.0, 2.0, 2.0]];
    let cable = |outlet: [f64; 3]| CableSpec { outlet, attachment: [0.0; 3], tension: None, ..CableSpec::default() };
    let mut spec = paper_scene("fan", (0..3).map(part).collect());
    let cables = outlets.map(cable).to_vec();
    spec.robot = RobotSource::Inline(RobotSpec { mass: None, platform: point(), cables, ..paper_robot() });
    spec.workspace = WorkspaceSpec { min: [0.0; 3], max: [2.0; 3] };
    let start = Some([1.2440234627999205, 0.3045324418598377, 0.8326124692712442].into());
    let goal = Some([1.1741927661761573, 1.728005839799787, 0.22415998496248118].into());
    spec.query = Some(QuerySpec { start, goal, ..QuerySpec::default() });
    let scene = Scene::new(spec).unwrap();
    for seed in 0..4 {
        let options = PlanOptions { seed, ..PlanOptions::default() };
        assert_eq!(plan(&scene, &options, &|| false).unwrap().result.status, Status::Solved);
    }
}
