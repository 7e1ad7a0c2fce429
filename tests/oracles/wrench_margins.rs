//! Margins: the four-position kernel against the definition, worked examples, existing robots.

use cdpr_core::geometry::{Point, Rotation, Vector};
use cdpr_core::kinematics::{condition, rank, wrench_matrix};
use cdpr_core::model::Robot;
use cdpr_core::testing::paper_robot;
use cdpr_core::wrench::{CapacityMargin, Loads, Required, Statics, force_limit, moment_limit};
use cdpr_tests::{point_robot, rng};
use nalgebra::Vector6;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

fn random_robot(rng: &mut ChaCha8Rng, cables: usize) -> Robot {
    let cables: Vec<_> = (0..cables)
        .map(|_| {
            let outlet = std::array::from_fn(|_| rng.random_range(-3.0..3.0));
            let attachment = std::array::from_fn(|_| rng.random_range(-0.4..0.4));
            let least = rng.random_range(0.0..50.0);
            (outlet, attachment, [least, least + rng.random_range(1.0..2000.0)])
        })
        .collect();
    point_robot(&cables, rng.random_range(0.0..50.0))
}

#[test]
fn the_kernel_gives_the_margins_of_the_definition() {
    let mut rng = rng(1);
    let mut compared = 0;
    for round in 0..400 {
        let robot = match round % 4 {
            0 => Robot::try_from(paper_robot()).unwrap(), // rank 5 everywhere
            _ => random_robot(&mut rng, 6 + round % 3),
        };
        let length = rng.random_range(0.1..2.0);
        let statics = Statics::new(&robot, &Loads { characteristic_length: length, ..Loads::default() }).unwrap();
        let scale = statics.largest_tension();
        let required = Required::balls(rng.random_range(0.0..60.0), rng.random_range(0.0..6.0)).unwrap();
        let margin = CapacityMargin::new(statics, required).unwrap();
        let portable = margin.clone().portable();
        assert!(portable.is_portable());
        assert!(margin.is_portable() || std::env::var_os("CDPR_PORTABLE").is_none()); // `make rust-test` runs it both ways
        for _ in 0..10 {
            let positions: [Point; 4] = std::array::from_fn(|_| {
                Point::from(std::array::from_fn(|_| f64::from(rng.random_range(-20..21)) * 0.1))
            });
            let (fast, plain) = (margin.at_four(&positions), portable.at_four(&positions));
            for k in 0..4 {
                let Some(defined) = margin.limit(&positions[k]) else { continue };
                assert_eq!(fast[k].to_bits(), plain[k].to_bits());
                assert_eq!(fast[k].to_bits(), margin.at(&positions[k]).to_bits());
                let error = (fast[k] - defined.margin).abs();
                assert!(error <= 1e-9 * scale, "{} against {} at {}", fast[k], defined.margin, positions[k]);
                compared += 1;
            }
        }
    }
    assert!(compared > 15_000);
}

#[test]
fn three_orthogonal_cable_pairs_have_known_margins() {
    // A point at the origin between six outlets on the axes, 0 to 10 N each: forces fill the cube |f_i| <= 10 N.
    let axes =
        [[5.0, 0.0, 0.0], [-5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, -5.0, 0.0], [0.0, 0.0, 5.0], [0.0, 0.0, -5.0]];
    let cables: Vec<_> = axes.map(|outlet| (outlet, [0.0; 3], [0.0, 10.0])).into();
    let statics = Statics::new(&point_robot(&cables, 0.4), &Loads::default()).unwrap();
    assert!(statics.point_mass());
    let (origin, weight) = (Point::origin(), 0.4 * 9.81);
    let limit = force_limit(&statics, &origin).unwrap();
    assert!((limit.margin - (10.0 - weight)).abs() < 1e-12 && limit.normal.z > 0.999);
    assert!(moment_limit(&statics, &origin).is_none());
    let capacity = CapacityMargin::new(statics.clone(), Required::balls(2.0, 0.0).unwrap()).unwrap();
    assert!((capacity.at(&origin) - (10.0 - weight - 2.0)).abs() < 1e-12);
    assert!(CapacityMargin::new(statics, Required::balls(2.0, 0.1).unwrap()).is_err());
}

#[test]
fn negative_margins_are_distances() {
    // Three cables along the axes, 0 to 10 N each: forces fill the cube from 0 to 10 N. The weight requires +z, but the
    // cables pull towards -x, -y and -z; and one cable alone, along x, for which two directions are missing.
    let loads = |x: f64, y: f64, z: f64| Loads { gravity: Vector::new(x, y, z), ..Loads::default() };
    let three = [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 5.0]].map(|outlet| (outlet, [0.0; 3], [0.0, 10.0]));
    let margin = |cables: &[([f64; 3], [f64; 3], [f64; 2])], loads: Loads| {
        let statics = Statics::new(&point_robot(cables, 1.0), &loads).unwrap();
        force_limit(&statics, &Point::origin()).unwrap().margin
    };
    // 100 N towards the negative end of each axis must be balanced along (-1, -1, -1): the nearest available force is
    // zero.
    assert!((margin(&three, loads(100.0, 100.0, 100.0)) + 100.0 * 3.0_f64.sqrt()).abs() < 1e-9);
    // Beyond one face, one edge, one corner of the cube.
    assert!((margin(&three, loads(-13.0, -5.0, -5.0)) + 3.0).abs() < 1e-9);
    assert!((margin(&three, loads(-13.0, -14.0, -5.0)) + 5.0).abs() < 1e-9);
    assert!((margin(&three, loads(-11.0, -12.0, -12.0)) + 3.0).abs() < 1e-9);
    // Inside, the nearest face.
    assert!((margin(&three, loads(-9.0, -5.0, -4.0)) - 1.0).abs() < 1e-12);
    for [y, z] in [[3.0, 4.0], [0.0, 5.0], [-5.0, 0.0]] {
        assert!((margin(&three[..1], loads(-5.0, y, z)) + 5.0).abs() < 1e-9);
    }
}

#[test]
fn the_papers_robot_has_no_moment_margin() {
    let statics = Statics::new(&Robot::try_from(paper_robot()).unwrap(), &Loads::default()).unwrap();
    let weight_alone = CapacityMargin::new(statics.clone(), Required::default()).unwrap();
    let with_moment = CapacityMargin::new(statics.clone(), Required::balls(0.0, 1.0).unwrap()).unwrap();
    let mut rng = rng(2);
    for _ in 0..200 {
        let p = Point::from(std::array::from_fn(|_| rng.random_range(0.3..1.7)));
        assert!(weight_alone.at(&p).abs() < 1e-9 * 1000.0);
        assert!((-1.0..-0.5).contains(&with_moment.at(&p))); // it lacks yaw, or nearly does
        assert!(force_limit(&statics, &p).unwrap().margin > 0.0);
    }
}

#[test]
fn a_force_cube_has_the_margin_of_its_nearest_corner() {
    let axes =
        [[5.0, 0.0, 0.0], [-5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, -5.0, 0.0], [0.0, 0.0, 5.0], [0.0, 0.0, -5.0]];
    let cables: Vec<_> = axes.map(|outlet| (outlet, [0.0; 3], [0.0, 10.0])).into();
    let statics = Statics::new(&point_robot(&cables, 0.0), &Loads::default()).unwrap();
    let corners = vec![Vector6::new(3.0, 0.0, 0.0, 0.0, 0.0, 0.0), Vector6::new(0.0, -7.5, 0.0, 0.0, 0.0, 0.0)];
    let margin = CapacityMargin::new(statics, Required::Polytope(corners)).unwrap();
    assert!((margin.at(&Point::origin()) - 2.5).abs() < 1e-12);
}

#[test]
fn facts_of_the_robots_as_built_hold() {
    // Condition numbers and wrench closure as published with the models' geometry; all carry their weight there.
    let facts = [
        ("acrobot", [0.5, 0.5, 0.5], 6.884635942562862, false),
        ("caroca", [0.0, 0.0, 1.0], 8.700747952307106, false),
        ("cogiro", [0.0, 0.0, 2.0], 3.2696864157942307, false),
        ("ipanema2", [0.0, 0.0, 3.0], 4.6980337674243895, true),
        ("mpi_simulator", [5.9, 7.5, 4.3], 3.196463026509569, true),
    ];
    for (name, position, expected_condition, closure) in facts {
        let (robot, position) = (cdpr_tests::built_robot(name), Point::from(position));
        let w = wrench_matrix(&robot, &Rotation::identity(), &position).unwrap();
        assert_eq!(rank(&w), 6);
        assert!((condition(&w) - expected_condition).abs() < 1e-6 * expected_condition, "{name}: {}", condition(&w));
        let margin = |robot: &Robot, gravity: Vector| {
            let statics = Statics::new(robot, &Loads { gravity, ..Loads::default() }).unwrap();
            CapacityMargin::new(statics, Required::default()).unwrap().at(&position)
        };
        assert!(margin(&robot, Loads::default().gravity) >= 0.0, "{name}");
        // Wrench closure: with tensions from 0 to 1 N, the zero wrench is strictly inside the available set.
        let mut spec = robot.spec().clone();
        spec.cables.iter_mut().for_each(|cable| cable.tension = Some([0.0, 1.0]));
        let any_pull = margin(&Robot::try_from(spec).unwrap(), Vector::zeros());
        assert_eq!(any_pull > 1e-9, closure, "{name}: {any_pull}");
    }
}
