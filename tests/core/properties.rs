//! Properties that hold for all input, including hostile numbers: an answer or a named error, never a panic.

use cdpr_core::collision::{Checker, GjkEngine, Interference, Validity};
use cdpr_core::geometry::gjk::{overlap, shape_distance};
use cdpr_core::geometry::{Point, Polytope, Rotation, Triangle, Vector, segment_segment};
use cdpr_core::model::{BodySpec, Scene, SceneSpec};
use cdpr_core::testing::{block, paper_scene};
use cdpr_core::tolerances::{GAP_TOLERANCE, TOUCH_DEPTH};
use proptest::prelude::*;

fn coordinate() -> impl Strategy<Value = f64> {
    -2.0..2.0f64
}

fn place() -> impl Strategy<Value = Point> {
    [coordinate(), coordinate(), coordinate()].prop_map(Point::from)
}

fn turn() -> impl Strategy<Value = Rotation> {
    [coordinate(), coordinate(), coordinate()].prop_map(|v| Rotation::from_scaled_axis(Vector::from(v)))
}

/// A convex body with volume.
fn body() -> impl Strategy<Value = Polytope> {
    (prop::collection::vec(place(), 4..12), 0.1..0.6f64).prop_filter_map("no volume", |(points, scale)| {
        let points: Vec<Point> = points.iter().map(|p| Point::from(p.coords * scale)).collect();
        Polytope::hull_of(&points).ok().filter(Polytope::has_volume)
    })
}

/// Numbers that break naive code.
fn hostile() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>(),
        Just(0.0),
        Just(-0.0),
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(f64::MIN_POSITIVE),
        Just(5e-324),
        Just(1e150),
        Just(-1e150),
        Just(1e6),
        Just(1e-7),
        Just(1.0 + f64::EPSILON),
        -2.0..2.0f64,
    ]
}

fn motion_of(spec: &SceneSpec, from: &Point, to: &Point) -> bool {
    GjkEngine::new(&Scene::new(spec.clone()).unwrap(), Interference::Exact).unwrap().motion_valid(from, to)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn distance_is_symmetric(a in body(), b in body(), shift in place()) {
        let b = b.transformed(&Rotation::identity(), &shift.coords);
        let (forth, back) = (shape_distance(&a, &b), shape_distance(&b, &a));
        prop_assert!((forth.signed() - back.signed()).abs() < 1e-9);
        prop_assert_eq!(overlap(&a, &b, TOUCH_DEPTH), overlap(&b, &a, TOUCH_DEPTH));
    }

    #[test]
    fn distance_does_not_change_under_rigid_motion(a in body(), p in place(), q in place(), r in place(), turn in turn(), shift in place()) {
        let moved = |x: &Point| turn * x + shift.coords;
        let here = shape_distance(&Triangle::new(p, q, r), &a).signed();
        let there = shape_distance(&Triangle::new(moved(&p), moved(&q), moved(&r)), &a.transformed(&turn, &shift.coords)).signed();
        prop_assert!((here - there).abs() < 1e-9, "{here} {there}");
    }

    #[test]
    fn distance_scales(a in body(), p in place(), q in place(), scale in 0.01..100.0f64) {
        let scaled = |x: &Point| Point::from(x.coords * scale);
        let larger = Polytope::hull_of(&a.vertices().iter().map(scaled).collect::<Vec<_>>()).unwrap();
        let here = shape_distance(&Triangle::new(p, q, q), &a).signed();
        let there = shape_distance(&Triangle::new(scaled(&p), scaled(&q), scaled(&q)), &larger).signed();
        prop_assert!((here * scale - there).abs() < 1e-8 * scale.max(1.0), "{here} {there}");
    }

    #[test]
    fn closest_points_of_segments_beat_all_samples(p in place(), q in place(), r in place(), s in place()) {
        let found = segment_segment::closest(&p, &q, &r, &s);
        let at = |a: &Point, b: &Point, t: f64| a + (b - a) * t;
        prop_assert!(((at(&r, &s, found.r) - at(&p, &q, found.s)).norm() - found.distance).abs() < 1e-12);
        for i in 0..=20 {
            for j in 0..=20 {
                let (x, y) = (at(&p, &q, f64::from(i) / 20.0), at(&r, &s, f64::from(j) / 20.0));
                prop_assert!((x - y).norm() >= found.distance - 1e-12);
            }
        }
    }

    #[test]
    fn validity_is_monotone_in_clearance(from in place(), to in place(), c in 0.0..0.2f64, more in 0.0..0.2f64) {
        let mut spec = paper_scene("s", vec![block("pillar", [0.3, 0.3, 1.5], [1.0, 1.0, 0.75])]);
        let (from, to) = (from + Vector::repeat(1.0), to + Vector::repeat(1.0));
        spec.clearance = Some(c + more);
        let strict = motion_of(&spec, &from, &to);
        // Pairs that cannot keep a clearance are exempt from it, so compare only if there are none.
        let exempt = !GjkEngine::new(&Scene::new(spec.clone()).unwrap(), Interference::Exact).unwrap().conditions().exempt.is_empty();
        spec.clearance = Some(c);
        prop_assert!(exempt || !strict || motion_of(&spec, &from, &to));
    }

    #[test]
    fn a_part_of_a_valid_motion_is_valid(from in place(), to in place(), s in 0.0..1.0f64, t in 0.0..1.0f64) {
        let spec = paper_scene("s", vec![block("pillar", [0.3, 0.3, 1.5], [1.0, 1.0, 0.75])]);
        let (from, to) = (from + Vector::repeat(1.0), to + Vector::repeat(1.0));
        let part = |t: f64| from + (to - from) * t;
        prop_assert!(!motion_of(&spec, &from, &to) || motion_of(&spec, &part(s), &part(t)));
    }

    #[test]
    fn hostile_scenes_are_answered_or_refused(slips in prop::collection::vec((0..20usize, hostile()), 1..4), from in place(), to in place()) {
        // A valid scene with one to three numbers replaced: box sides, position and rotation, clearance, an outlet, an
        // attachment, a diameter, platform sides.
        let mut numbers = [0.3, 0.3, 1.5, 1.0, 1.0, 0.75, 0.0, 0.1, 0.2, 0.0, 0.0, 0.0, 0.0, 0.075, -0.075, -0.025, 0.0, 0.15, 0.15, 0.05];
        slips.iter().for_each(|(k, number)| numbers[*k] = *number);
        let (from, to) = (from + Vector::repeat(1.0), to + Vector::repeat(1.0));
        let three = |k: usize| [numbers[k], numbers[k + 1], numbers[k + 2]];
        let mut spec = paper_scene("s", vec![BodySpec { cuboid: Some(three(0)), position: Some(three(3)), rpy: Some(three(6)), ..BodySpec::default() }]);
        spec.clearance = Some(numbers[9]);
        if let cdpr_core::model::RobotSource::Inline(robot) = &mut spec.robot {
            robot.cables[0].outlet = three(10);
            robot.cables[1].attachment = three(13);
            robot.cables[2].diameter = Some(numbers[16]);
            robot.platform[0].cuboid = Some(three(17));
        }
        if let Ok(scene) = Scene::new(spec) {
            let engine = GjkEngine::new(&scene, Interference::Exact).unwrap();
            let valid = engine.motion_valid(&from, &to);
            prop_assert_eq!(valid, engine.violations(&from, &to).is_empty());
            if let Some(nearest) = engine.clearance(&from, &to) {
                prop_assert!(nearest.value.is_finite());
                prop_assert!(!valid || nearest.value > -GAP_TOLERANCE);
            }
        }
    }

    #[test]
    fn hostile_vertex_lists_are_bodies_or_errors(numbers in prop::collection::vec([hostile(), hostile(), hostile()], 0..10)) {
        let points: Vec<Point> = numbers.iter().map(|p| Point::from(*p)).collect();
        if let Ok(body) = Polytope::from_vertices(&points) {
            prop_assert!(body.vertices().len() <= points.len() && body.dimension() <= 3);
        }
    }

    #[test]
    fn nan_positions_are_never_valid(numbers in [hostile(), hostile(), hostile()]) {
        let spec = paper_scene("s", Vec::new());
        let (there, middle) = (Point::from(numbers), Point::new(1.0, 1.0, 1.0));
        let inside = numbers.iter().all(|x| (0.0..=2.0).contains(x));
        prop_assert!(inside || !motion_of(&spec, &middle, &there));
    }
}
