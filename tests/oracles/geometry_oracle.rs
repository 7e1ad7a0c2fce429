//! GJK with separating axes against clipping, an independent exact method, on difficult shapes: cables metres long and
//! down to a nanometre thin, touching, nearly parallel to a facet.

use cdpr_core::geometry::gjk::{nearer_than, overlap, shape_distance};
use cdpr_core::geometry::separating_axes::{gap_along, separation};
use cdpr_core::geometry::{ConvexShape, Point, Polytope, Rotation, Swept, Triangle, Vector};
use cdpr_core::tolerances::{GAP_TOLERANCE, TOUCH_DEPTH};
use cdpr_tests::{body, clipped, direction, effort, rng, rotation, surface_point, triangle, uniform, vector};
use rand::RngExt;

#[test]
fn cables_against_bodies_agree_with_clipping() {
    let mut rng = rng(1);
    let (many, mut hits, mut free, mut near) = (effort(), 0, 0, 0);
    for case in 0..66_667 * many {
        let obstacle = body(&mut rng);
        let shift = Vector::from_element(if case % 4 == 0 { uniform(&mut rng, -1000.0, 1000.0) } else { 0.0 });
        let corners = triangle(&mut rng, &obstacle).map(|p| p + shift);
        let obstacle = obstacle.transformed(&Rotation::identity(), &shift);
        let [b, p, q] = corners;
        let verdict = overlap(&Triangle::new(b, p, q), &obstacle, TOUCH_DEPTH);
        if !clipped(&corners, &obstacle, -GAP_TOLERANCE).is_empty() {
            hits += 1;
            assert!(verdict, "case {case}: declared free, but overlaps: {corners:?} {:?}", obstacle.vertices());
        } else if clipped(&corners, &obstacle, GAP_TOLERANCE).is_empty() {
            free += 1;
            assert!(!verdict, "case {case}: declared a hit, but apart: {corners:?} {:?}", obstacle.vertices());
        } else {
            near += 1;
        }
    }
    eprintln!("{hits} hits, {free} free, {near} within the tolerance");
    assert!(hits > 16_667 * many && free > 16_667 * many && near > 3_333 * many);
}

/// The Minkowski difference obstacle - platform as a hull: the swept platform meets the obstacle iff the path of its
/// origin meets that hull.
fn minkowski_difference(obstacle: &Polytope, platform: &Polytope) -> Polytope {
    let points: Vec<Point> =
        obstacle.vertices().iter().flat_map(|o| platform.vertices().iter().map(move |p| o - p.coords)).collect();
    Polytope::hull_of(&points).unwrap()
}

#[test]
fn swept_platforms_agree_with_cspace_clipping() {
    let mut rng = rng(2);
    let (mut hits, mut free, mut near) = (0, 0, 0);
    for case in 0..20_000 {
        let obstacle = body(&mut rng);
        let platform = match case % 4 {
            0 => Polytope::cuboid([uniform(&mut rng, 0.01, 0.4), uniform(&mut rng, 0.01, 0.4), 0.0]).unwrap(),
            1 => Polytope::cuboid([0.0, 0.0, uniform(&mut rng, 0.01, 0.4)]).unwrap(),
            _ => body(&mut rng),
        }
        .transformed(&rotation(&mut rng), &vector(&mut rng, 0.2));
        let difference = minkowski_difference(&obstacle, &platform);
        let anchor = if rng.random_bool(0.5) {
            surface_point(&mut rng, &difference)
        } else {
            Point::from(vector(&mut rng, 1.0))
        };
        let along = direction(&mut rng) * 10f64.powf(uniform(&mut rng, -6.0, 0.3));
        let from = anchor - along * uniform(&mut rng, 0.0, 1.0);
        let path = [from, from + along];
        let verdict = overlap(&Swept::new(&platform, from.coords, along), &obstacle, TOUCH_DEPTH);
        if !clipped(&path, &difference, -GAP_TOLERANCE).is_empty() {
            hits += 1;
            assert!(verdict, "case {case}: declared free, but overlaps");
        } else if clipped(&path, &difference, GAP_TOLERANCE).is_empty() {
            free += 1;
            assert!(!verdict, "case {case}: declared a hit, but apart");
        } else {
            near += 1;
        }
    }
    eprintln!("{hits} hits, {free} free, {near} within the tolerance");
    assert!(hits > 5_000 && free > 5_000 && near > 100);
}

/// A lower and an upper bound of the distance, valid however the distance was found: a plane between the shapes and a
/// point of each. If both agree, the distance is proved.
fn proves(distance: f64, on_a: &Point, on_b: &Point, a: &impl ConvexShape, b: &impl ConvexShape) -> bool {
    let axis = (on_b - on_a).normalize();
    // Points micrometres apart determine their axis only to a microradian; a face or edge pair determines it better.
    let gap = gap_along(a, b, &axis).max(separation(a, b).0);
    (distance - gap).abs() < 0.5 * GAP_TOLERANCE && ((on_b - on_a).norm() - distance).abs() < 1e-12
}

#[test]
fn distances_are_proved_by_their_witness_points() {
    let mut rng = rng(3);
    let mut apart = 0;
    for case in 0..100_000 {
        let obstacle = body(&mut rng);
        let [b, p, q] = triangle(&mut rng, &obstacle);
        let cable = Triangle::new(b, p, q);
        let found = shape_distance(&cable, &obstacle);
        if found.distance < 1e-6 {
            continue; // the axis between points this close is a rounding error
        }
        apart += 1;
        assert!(proves(found.distance, &found.on_a, &found.on_b, &cable, &obstacle), "case {case}: {found:?}");
        assert!(nearer_than(&cable, &obstacle, found.distance + GAP_TOLERANCE), "case {case}: {found:?}");
        assert!(!nearer_than(&cable, &obstacle, found.distance - GAP_TOLERANCE), "case {case}: {found:?}");
    }
    assert!(apart > 30_000);
}

#[test]
fn overlap_depth_is_the_smallest_translation_that_parts() {
    let mut rng = rng(4);
    let mut overlapping = 0;
    for case in 0..20_000 {
        let obstacle = body(&mut rng);
        let [b, p, q] = triangle(&mut rng, &obstacle);
        let found = shape_distance(&Triangle::new(b, p, q), &obstacle);
        if found.depth < 1e-6 {
            continue;
        }
        overlapping += 1;
        let moved = |by: Vector| [b + by, p + by, q + by];
        let parted = moved(-found.axis * (found.depth + 1e-6));
        assert!(clipped(&parted, &obstacle, -1e-7).is_empty(), "case {case}: still overlaps after the depth");
        for _ in 0..5 {
            let short = moved(direction(&mut rng) * (found.depth * 0.999));
            assert!(!clipped(&short, &obstacle, 1e-9).is_empty(), "case {case}: a shorter move parts them: {found:?}");
        }
    }
    assert!(overlapping > 3_000);
}

#[test]
fn any_two_dimensions_have_their_distance() {
    let corner = |x: f64, y: f64, z: f64| Point::new(x, y, z);
    let point = Polytope::from_vertices(&[corner(0.0, 0.0, 3.0)]).unwrap();
    let segment = Polytope::from_vertices(&[corner(-1.0, 0.0, 2.0), corner(1.0, 0.0, 2.0)]).unwrap();
    let plate = Polytope::cuboid([2.0, 2.0, 0.0]).unwrap();
    let cube = Polytope::cuboid([1.0; 3]).unwrap();
    for (a, b, expected) in [
        (&point, &segment, 1.0),
        (&point, &plate, 3.0),
        (&segment, &plate, 2.0),
        (&segment, &cube, 1.5),
        (&point, &point, 0.0),
    ] {
        assert!((shape_distance(a, b).distance - expected).abs() < 1e-12);
        assert!((shape_distance(b, a).distance - expected).abs() < 1e-12);
    }
    let found = shape_distance(&plate, &cube);
    assert_eq!((found.distance, (found.depth - 0.5).abs() < 1e-12), (0.0, true));
}
