//! Convex parts of a mesh: they cover it, extend no farther than stated, are few, and are reproducible. These claims
//! are checked by methods that share no code with the parts: solid angles for the inside, all triangles one by one for
//! distances.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use cdpr_core::geometry::{ConvexParts, Point, Polytope, TriangleMesh, Vector, convex_parts, pieces};
use cdpr_core::limits::MOST_PARTS;
use cdpr_core::model::{BodySpec, MeshSource, MeshSpec};
use cdpr_core::testing::paper_scene;
use cdpr_core::tolerances::{GAP_TOLERANCE, MESH_TOLERANCE};
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene};
use cdpr_files::{Loader, scene_from_text, text::Notation};
use cdpr_tests::meshes::{capsule, icosphere, torus, write_obj};
use cdpr_tests::{encloses, rng};
use proptest::prelude::*;
use rand::RngExt;

fn parts_of(mesh: &TriangleMesh, tolerance: f64) -> ConvexParts {
    let (pieces, _) = pieces(mesh, &Watch::NONE).unwrap();
    assert_eq!(pieces.len(), 1);
    convex_parts(&pieces[0], tolerance, MOST_PARTS, &Watch::NONE).unwrap()
}

/// Distance of a point from a triangle: from its plane if it is above the inside, else from an edge.
fn from_triangle(p: &Point, [a, b, c]: [Point; 3]) -> f64 {
    let from_edge = |p0: Point, p1: Point| {
        let along = p1 - p0;
        let share =
            if along.norm() > 0.0 { ((p - p0).dot(&along) / along.norm_squared()).clamp(0.0, 1.0) } else { 0.0 };
        (p0 + along * share - p).norm()
    };
    let normal = (b - a).cross(&(c - a));
    let above = |p0: Point, p1: Point| normal.dot(&(p1 - p0).cross(&(p - p0))) >= 0.0;
    let edges = from_edge(a, b).min(from_edge(b, c)).min(from_edge(c, a));
    if above(a, b) && above(b, c) && above(c, a) && normal.norm() > 0.0 {
        edges.min(normal.normalize().dot(&(p - a)).abs())
    } else {
        edges
    }
}

/// Distance of a point from a mesh and all it encloses.
fn from_body(p: &Point, mesh: &TriangleMesh, closed: bool) -> f64 {
    if closed && encloses(mesh, p) {
        return 0.0;
    }
    let triangles = mesh.triangles.iter().map(|t| t.map(|i| mesh.vertices[i]));
    triangles.map(|t| from_triangle(p, t)).fold(f64::INFINITY, f64::min)
}

fn covered(bodies: &[Polytope], p: &Point) -> bool {
    bodies.iter().any(|body| body.depth_of(p) >= -GAP_TOLERANCE)
}

/// Corners of the parts and random points in them are within the stated reach; random points on the surface and inside
/// are in a part.
fn assert_honest(name: &str, mesh: &TriangleMesh, parts: &ConvexParts, closed: bool, samples: usize) {
    let mut rng = rng(11);
    let mut farthest = 0.0_f64;
    for body in &parts.bodies {
        let corners = body.vertices();
        let mut look = |p: &Point| {
            let distance = from_body(p, mesh, closed);
            farthest = farthest.max(distance);
            assert!(distance <= parts.reach + GAP_TOLERANCE, "{name}: {distance} beyond, {} stated", parts.reach);
        };
        for _ in 0..samples {
            look(&corners[rng.random_range(0..corners.len())]);
            let [p, q, r] = [0; 3].map(|_| corners[rng.random_range(0..corners.len())].coords);
            let (s, t): (f64, f64) = (rng.random_range(0.0..1.0), rng.random_range(0.0..1.0));
            look(&Point::from(p * s + (q * t + r * (1.0 - t)) * (1.0 - s)));
        }
    }
    for _ in 0..20 * samples {
        let [a, b, c] = mesh.triangles[rng.random_range(0..mesh.triangles.len())].map(|i| mesh.vertices[i]);
        let (s, t): (f64, f64) = (rng.random_range(0.0..1.0), rng.random_range(0.0..1.0));
        let p = a + ((b - a) * (1.0 - t) + (c - a) * t) * s;
        assert!(covered(&parts.bodies, &p), "{name}: {p} on the surface is in no part");
    }
    let whole = cdpr_core::geometry::Aabb::around(&mesh.vertices);
    for _ in 0..if closed { 5 * samples } else { 0 } {
        let p = whole.min + (whole.max - whole.min).map(|side| side * rng.random_range(0.0..1.0));
        assert!(!encloses(mesh, &p) || covered(&parts.bodies, &p), "{name}: {p} inside is in no part");
    }
}

#[test]
#[ignore = "takes long; `make long-test` runs it"]
fn round_meshes_become_few_parts_within_the_tolerance() {
    for (name, mesh, extent, most) in [
        ("icosphere", icosphere(4, 0.6), 1.2, 1),
        ("capsule", capsule(80, 40), 1.2, 1),
        ("torus", torus(64, 32), 1.44, 32),
    ] {
        let tolerance = MESH_TOLERANCE * extent;
        let parts = parts_of(&mesh, tolerance);
        println!("{name}: {} parts, reach {}", parts.bodies.len(), parts.reach);
        assert!(parts.reach <= tolerance, "{name}: {} > {tolerance}", parts.reach);
        assert!(parts.bodies.len() <= most, "{name}: {} parts", parts.bodies.len());
        assert_honest(name, &mesh, &parts, true, 20);
    }
}

/// A closed surface around the origin with random hills, hollows and corners.
fn potato(around: usize, across: usize, bumps: &[[f64; 4]]) -> TriangleMesh {
    let mut mesh = cdpr_tests::meshes::ball(around, across);
    for v in &mut mesh.vertices {
        let direction = v.coords.normalize();
        let hill = |[x, y, z, h]: &[f64; 4]| h * (-4.0 * (direction - Vector::new(*x, *y, *z)).norm_squared()).exp();
        *v = Point::from(direction * (0.5 + bumps.iter().map(hill).sum::<f64>()));
    }
    mesh
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn parts_cover_any_mesh_and_reach_as_far_as_stated(
        bumps in prop::collection::vec(prop::array::uniform4(-1.0..1.0f64), 1..4),
        (around, across) in (5..20usize, 4..12usize),
        hole in prop::option::of(0..30usize),
        tolerance in 0.005..0.1f64,
    ) {
        let bumps: Vec<[f64; 4]> = bumps.into_iter().map(|[x, y, z, h]| [x, y, z, 0.3 * h]).collect();
        let mut mesh = potato(around, across, &bumps);
        if let Some(hole) = hole {
            mesh.triangles.remove(hole % mesh.triangles.len());
        }
        let parts = parts_of(&mesh, tolerance);
        assert_honest("potato", &mesh, &parts, hole.is_none(), 5);
    }

    #[test]
    fn parts_of_random_triangles_cover_them_and_reach_as_far_as_stated(
        corners in prop::collection::vec(prop::array::uniform3(-0.5..0.5f64), 4..30),
        picks in prop::collection::vec(prop::array::uniform3(0..30usize), 1..40),
    ) {
        let n = corners.len();
        let vertices = corners.into_iter().map(Point::from).collect();
        let triangles = picks.into_iter().map(|t| t.map(|i| i % n)).collect();
        let mesh = TriangleMesh { vertices, triangles };
        let (pieces, _) = pieces(&mesh, &Watch::NONE).unwrap();
        let parts = pieces.iter().map(|p| convex_parts(p, 0.05, MOST_PARTS, &Watch::NONE).unwrap());
        let (mut bodies, mut reach) = (Vec::new(), 0.0_f64);
        for parts in parts {
            bodies.extend(parts.bodies);
            reach = reach.max(parts.reach);
        }
        if !bodies.is_empty() {
            let closed = pieces.iter().any(|p| p.volume.is_some());
            prop_assume!(!closed);
            let kept = mesh.triangles.iter().filter(|[a, b, c]| a != b && b != c && c != a).copied().collect();
            let mesh = TriangleMesh { triangles: kept, ..mesh };
            assert_honest("tangle", &mesh, &ConvexParts { bodies, reach, enlarged: 0 }, false, 3);
        }
    }
}

fn scene_text(mesh: &TriangleMesh) -> String {
    let vertices = mesh.vertices.iter().map(|v| [v.x, v.y, v.z]).collect();
    let spec = MeshSpec { vertices, triangles: mesh.triangles.clone() };
    let body =
        BodySpec { mesh: Some(MeshSource::Inline(spec)), position: Some([5.0, 5.0, 5.0]), ..BodySpec::default() };
    serde_json::to_string(&paper_scene("mesh", vec![body])).unwrap()
}

#[test]
fn parts_are_the_same_on_any_number_of_threads() {
    let text = scene_text(&potato(40, 30, &[[1.0, 0.0, 0.0, 0.3], [0.0, 1.0, 0.3, -0.2]]));
    let load = || scene_from_text(&text, Notation::Json, None).unwrap();
    let on = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(load);
    let first: Scene = load();
    for threads in [1, 2, 5] {
        assert_eq!(on(threads), first, "{threads} threads");
    }
}

#[test]
fn a_missed_tolerance_is_stated_with_numbers() {
    let mut rng = rng(3);
    let vertices = (0..60).map(|_| Point::from(std::array::from_fn(|_| rng.random_range(-1.0..1.0)))).collect();
    let triangles: Vec<[usize; 3]> = (0..300)
        .map(|_| std::array::from_fn(|_| rng.random_range(0..60)))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    let mesh = TriangleMesh { vertices, triangles };
    let started = Instant::now();
    let scene = scene_from_text(&scene_text(&mesh), Notation::Json, None).unwrap();
    println!("{:?}: {:?}", started.elapsed(), scene.notes());
    let notes = scene.notes().join("; ");
    assert!(notes.contains("the tolerance is missed in 1 piece, by up to"), "{notes}");
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
    // More cells were made than parts are allowed, and cuts were undone: the parts must still cover everything.
    let parts = parts_of(&mesh, 0.02);
    assert!((MOST_PARTS / 2..=MOST_PARTS).contains(&parts.bodies.len()), "{}", parts.bodies.len());
    assert_honest("undone", &mesh, &parts, false, 3);
}

#[test]
#[ignore = "takes long; `make long-test` runs it"]
fn a_bumpy_ball_keeps_its_tolerance() {
    let mut mesh = cdpr_tests::meshes::ball(112, 56);
    for v in &mut mesh.vertices {
        let (around, up) = (v.y.atan2(v.x), (v.z / 0.5).clamp(-1.0, 1.0).acos());
        v.coords *= 1.0 + 0.05 * (6.0 * around).sin() * (6.0 * up).sin();
    }
    let parts = parts_of(&mesh, MESH_TOLERANCE);
    println!("{} parts, reach {}", parts.bodies.len(), parts.reach);
    assert!(parts.reach <= MESH_TOLERANCE && parts.bodies.len() <= MOST_PARTS, "{}", parts.reach);
    assert_honest("bumpy", &mesh, &parts, true, 2);
}

/// The hull of all corners of one of its parts cannot be built.
#[test]
#[ignore = "takes long; `make long-test` runs it"]
fn a_fine_torus_from_a_text_file_keeps_its_tolerance() {
    let (around, across) = (240, 100);
    let as_written = |x: f64| format!("{x:.8e}").parse::<f64>().unwrap();
    let vertex = |k: usize| {
        let turn = |k: usize, of: usize| std::f64::consts::TAU * k as f64 / of as f64;
        let (a, b) = (turn(k / across, around), turn(k % across, across));
        let reach = 1.0 + 0.3 * b.cos();
        Point::from([reach * a.cos(), reach * a.sin(), 0.3 * b.sin()].map(as_written))
    };
    let quad = |k: usize| {
        let at = |i: usize, j: usize| i % around * across + j % across;
        let (i, j) = (k / across, k % across);
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    let count = around * across;
    let mesh =
        TriangleMesh { vertices: (0..count).map(vertex).collect(), triangles: (0..count).flat_map(quad).collect() };
    let tolerance = MESH_TOLERANCE * 2.6;
    let parts = parts_of(&mesh, tolerance);
    assert!(parts.reach <= 0.5 * tolerance && parts.bodies.len() <= 200, "{} {}", parts.reach, parts.bodies.len());
}

#[test]
fn shapeless_triangles_are_refused_with_advice() {
    let mut rng = rng(1);
    let vertices = (0..3_333).map(|_| Point::from(std::array::from_fn(|_| rng.random_range(-0.6..0.6)))).collect();
    let triangles = (0..20_000).map(|_| std::array::from_fn(|_| rng.random_range(0..3_333))).collect();
    let folder = tempfile::tempdir().unwrap();
    write_obj(&folder.path().join("soup.obj"), &TriangleMesh { vertices, triangles }, 1.0);
    let body = BodySpec { mesh: Some(MeshSource::File("soup.obj".to_string())), ..BodySpec::default() };
    let text = serde_json::to_string(&paper_scene("mesh", vec![body])).unwrap();
    let error = scene_from_text(&text, Notation::Json, Some(folder.path())).unwrap_err();
    println!("{error}");
    assert_eq!(error.class(), cdpr_core::ErrorClass::Input);
    let message = error.to_string();
    for said in
        ["soup.obj: found a piece of 20000 triangles, open", "where 12.0 mm was requested", "25 % of its largest side"]
    {
        assert!(message.contains(said), "\"{said}\" in: {message}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is kept of a mesh that is refused");
}

#[test]
fn an_interrupt_ends_the_import_of_a_mesh_soon() {
    let text = scene_text(&torus(200, 100));
    for wait in [1, 100, 300, 700] {
        let stop = AtomicBool::new(false);
        let (result, late) = std::thread::scope(|scope| {
            let work = scope.spawn(|| {
                let interrupted = || stop.load(Ordering::Relaxed);
                let watch = Watch::on(&interrupted);
                Loader::new(watch).scene_from_text(&text, Notation::Json, None)
            });
            std::thread::sleep(Duration::from_millis(wait));
            stop.store(true, Ordering::Relaxed);
            let stopped = Instant::now();
            (work.join().unwrap(), stopped.elapsed())
        });
        // Parsing the text comes first and is not interrupted; other work on the machine makes threads wait.
        println!("interrupted after {wait} ms: ended {late:?} later");
        assert!(late < Duration::from_millis(1500), "{late:?}");
        assert!(result.is_err_and(|e: Error| e.class() == cdpr_core::ErrorClass::Interrupted) || wait > 500);
    }
}
