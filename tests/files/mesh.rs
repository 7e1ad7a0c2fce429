//! Meshes cut out of a box: closed for any planes, and equal to the set that the half-spaces define.

use std::collections::BTreeSet;

use cdpr_core::geometry::{Aabb, HalfSpace, Point, Polytope, TriangleMesh, Vector, convex_mesh, shadow, wedge_mesh};
use cdpr_tests::encloses;
use proptest::prelude::*;

const UNIT: Aabb = Aabb { min: Point::new(0.0, 0.0, 0.0), max: Point::new(1.0, 1.0, 1.0) };

fn euler_characteristic(mesh: &TriangleMesh) -> i64 {
    let edges: BTreeSet<[usize; 2]> = mesh.edges().map(|[i, j]| [i.min(j), i.max(j)]).collect();
    mesh.vertices.len() as i64 - edges.len() as i64 + mesh.triangles.len() as i64
}

/// Closed, a sphere, oriented outward, and where the half-spaces and the box put it.
fn assert_sound(mesh: &TriangleMesh, half_spaces: &[HalfSpace], within: &Aabb) {
    assert!(mesh.is_watertight(), "{mesh:?}");
    assert_eq!(euler_characteristic(mesh), 2);
    assert!(mesh.volume() > 0.0);
    for v in &mesh.vertices {
        assert!((0..3).all(|k| v[k] >= within.min[k] && v[k] <= within.max[k]), "{v} outside the box");
        assert!(half_spaces.iter().all(|h| h.height(v) <= 2e-9), "{v} outside a half-space");
    }
    if let Ok(hull) = Polytope::hull_of(&mesh.vertices) {
        assert!((hull.volume() - mesh.volume()).abs() <= 1e-8 * mesh.area(), "{} {}", hull.volume(), mesh.volume());
    }
}

/// How far a point is inside all half-spaces, m.
fn depth(half_spaces: &[HalfSpace], p: &Point) -> f64 {
    -half_spaces.iter().map(|h| h.height(p)).fold(f64::NEG_INFINITY, f64::max)
}

fn unit_vector() -> impl Strategy<Value = Vector> {
    let any = prop::array::uniform3(-1.0..1.0f64).prop_map(Vector::from);
    any.prop_filter_map("no direction", |v| (v.norm() > 0.1).then(|| v.normalize()))
}

/// Random planes, and difficult ones: along the axes, through corners, a few ulps apart.
fn planes() -> impl Strategy<Value = Vec<HalfSpace>> {
    let axis = (0..6usize).prop_map(|k| Vector::ith(k % 3, if k < 3 { 1.0 } else { -1.0 }));
    let diagonal = prop::array::uniform3(-1..=1i32)
        .prop_filter_map("no direction", |v| Vector::from(v.map(f64::from)).try_normalize(0.0));
    let normal = prop_oneof![unit_vector(), axis, diagonal];
    let anywhere = prop::array::uniform3(0.0..1.0f64);
    let place = prop_oneof![anywhere, prop::array::uniform3((0..=4u8).prop_map(|k| f64::from(k) * 0.25))];
    let nudge = prop_oneof![Just(0.0), Just(1e-16), Just(-1e-15), Just(1e-12), Just(3e-10), Just(1.1e-9), Just(1e-8)];
    let plane = (normal, place.prop_map(Point::from), nudge)
        .prop_map(|(normal, place, nudge)| HalfSpace::through(&place, normal).widened(nudge));
    let tilted = |h: HalfSpace, tilt: f64| HalfSpace { normal: (h.normal + Vector::repeat(tilt)).normalize(), ..h };
    prop::collection::vec(
        (plane, prop_oneof![Just(None), Just(Some(1e-16)), Just(Some(1e-11)), Just(Some(1e-9))]),
        0..12,
    )
    .prop_map(move |list| {
        list.into_iter().flat_map(|(h, twin)| [Some(h), twin.map(|t| tilted(h, t))]).flatten().collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn whatever_is_cut_off_the_rest_is_closed_and_the_right_set(
        planes in planes(),
        samples in prop::collection::vec(prop::array::uniform3(0.0..1.0f64), 20),
    ) {
        let samples: Vec<Point> = samples.into_iter().map(Point::from).collect();
        match convex_mesh(&planes, &UNIT) {
            Some(mesh) => {
                assert_sound(&mesh, &planes, &UNIT);
                for p in samples {
                    let depth = depth(&planes, &p);
                    prop_assert!(depth.abs() < 1e-7 || encloses(&mesh, &p) == (depth > 0.0), "{p} at depth {depth}");
                }
            }
            // Samples are inside the box by far more than a sliver is thick.
            None => prop_assert!(samples.iter().all(|p| depth(&planes, p) < 1e-7)),
        }
    }

    #[test]
    fn shadows_of_boxes_are_closed_and_convex(
        corner in prop::array::uniform3((0..8u8).prop_map(|k| f64::from(k) * 0.125)),
        sides in prop::array::uniform3((1..6u8).prop_map(|k| f64::from(k) * 0.1)),
        apex in prop::array::uniform3(prop_oneof![0.0..1.0f64, (0..=8u8).prop_map(|k| f64::from(k) * 0.125)]),
    ) {
        let shift = Vector::from(corner) + 0.5 * Vector::from(sides);
        let body = Polytope::cuboid(sides).unwrap().transformed(&Default::default(), &shift);
        if let Some(found) = shadow(&body, &Point::from(apex))
            && let Some(mesh) = convex_mesh(&found.half_spaces, &UNIT)
        {
            assert_sound(&mesh, &found.half_spaces, &UNIT);
            // Faces between coinciding corners are removed, so no triangle is narrower than that.
            prop_assert!(mesh.edges().all(|[i, j]| (mesh.vertices[j] - mesh.vertices[i]).norm() > 1e-9));
            prop_assert!(mesh.in_single_precision().is_watertight());
        }
    }

    #[test]
    fn wedges_have_two_sides_and_lie_in_their_plane(
        apex in prop::array::uniform3(-0.5..1.5f64), a in unit_vector(), b in unit_vector(),
    ) {
        let apex = Point::from(apex);
        if let Some(mesh) = wedge_mesh(&apex, [a, b], &UNIT) {
            prop_assert!(mesh.is_watertight() && euler_characteristic(&mesh) == 2);
            prop_assert!(mesh.volume().abs() < 1e-12 && mesh.area() > 0.0);
            let normal = a.cross(&b);
            for v in &mesh.vertices {
                let u = v - apex;
                let (s, t) = (u.cross(&b).dot(&normal), a.cross(&u).dot(&normal));
                prop_assert!(normal.dot(&u).abs() < 1e-9 && s > -1e-8 && t > -1e-8, "{v}: {s} {t}");
                prop_assert!((0..3).all(|k| v[k] > -1e-8 && v[k] < 1.0 + 1e-8));
            }
        }
    }
}

fn plane(normal: [f64; 3], offset: f64) -> HalfSpace {
    HalfSpace { normal: Vector::from(normal), offset }
}

#[test]
fn no_planes_leave_the_box() {
    let mesh = convex_mesh(&[], &UNIT).unwrap();
    assert_sound(&mesh, &[], &UNIT);
    assert_eq!((mesh.vertices.len(), mesh.triangles.len(), mesh.volume(), mesh.area()), (8, 12, 1.0, 6.0));
}

#[test]
fn planes_that_touch_a_face_an_edge_or_a_corner_change_nothing() {
    let half = 0.5f64.sqrt();
    let third = (1.0f64 / 3.0).sqrt();
    for touching in [plane([1.0, 0.0, 0.0], 1.0), plane([half, half, 0.0], 2.0 * half), plane([third; 3], 3.0 * third)]
    {
        assert_eq!(convex_mesh(&[touching; 3], &UNIT), convex_mesh(&[], &UNIT));
    }
}

#[test]
fn a_plane_through_corners_leaves_half_the_cube() {
    let half = 0.5f64.sqrt();
    let mesh = convex_mesh(&[plane([half, -half, 0.0], 0.0)], &UNIT).unwrap();
    assert_sound(&mesh, &[], &UNIT);
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (6, 8));
    assert!((mesh.volume() - 0.5).abs() < 1e-15);
}

#[test]
fn doubled_planes_cut_once() {
    let cut = plane([0.6, 0.8, 0.0], 0.7);
    let almost = plane([0.6, 0.8, 1e-14], 0.7 + 1e-14);
    assert_eq!(convex_mesh(&[cut], &UNIT), convex_mesh(&[cut, cut, almost, cut], &UNIT));
}

#[test]
fn touching_half_spaces_leave_nothing() {
    for offset in [-1.0, -1e-9, 0.0, 1e-10] {
        assert_eq!(convex_mesh(&[plane([1.0, 0.0, 0.0], offset)], &UNIT), None, "{offset}");
    }
    assert_eq!(convex_mesh(&[plane([1.0, 0.0, 0.0], 0.5), plane([-1.0, 0.0, 0.0], -0.5)], &UNIT), None);
    let empty = Aabb { min: Point::new(0.0, 0.0, 0.6), max: Point::new(1.0, 1.0, 0.5) };
    assert_eq!(convex_mesh(&[], &empty), None);
}

#[test]
fn a_thin_plate_is_a_body_still() {
    let planes = [plane([1.0, 0.0, 0.0], 0.5 + 1e-6), plane([-1.0, 0.0, 0.0], -0.5)];
    let mesh = convex_mesh(&planes, &UNIT).unwrap();
    assert_sound(&mesh, &planes, &UNIT);
    assert!((mesh.volume() - 1e-6).abs() < 1e-15);
}

#[test]
fn a_wedge_of_parallel_sides_or_beside_the_box_is_none() {
    let apex = Point::new(0.5, 0.5, 0.5);
    assert_eq!(wedge_mesh(&apex, [Vector::x(), Vector::x() * 2.0], &UNIT), None);
    assert_eq!(wedge_mesh(&Point::new(0.5, 0.5, 1.5), [Vector::x(), Vector::y()], &UNIT), None);
    assert_eq!(wedge_mesh(&apex, [Vector::x(), Vector::zeros()], &UNIT), None);
    assert_eq!(wedge_mesh(&apex, [Vector::x(), Vector::new(-1.0, 1e-11, 0.0)], &UNIT), None);
    let quarter = wedge_mesh(&apex, [Vector::x(), Vector::y()], &UNIT).unwrap();
    assert_eq!((quarter.vertices.len(), quarter.triangles.len()), (4, 4));
    assert!((quarter.area() - 0.5).abs() < 1e-12); // two sides
}
