//! Meshes as bodies: the convex parts cover the mesh, and paths planned around them avoid its triangles.

use std::fs;
use std::path::Path;

use cdpr_core::Scene;
use cdpr_core::geometry::gjk::overlap;
use cdpr_core::geometry::{Point, Polytope, Rotation, Swept, Triangle, TriangleMesh, Vector, convex_parts, pieces};
use cdpr_core::limits::MOST_PARTS;
use cdpr_core::model::{BodySpec, MeshSource, MeshSpec, SceneSpec};
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::Status;
use cdpr_core::testing::paper_scene;
use cdpr_core::tolerances::{GAP_TOLERANCE, SHEET, TOUCH_DEPTH};
use cdpr_core::watch::Watch;
use cdpr_files::{load_mesh, load_scene, scene_from_text, text::Notation};
use cdpr_tests::meshes::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The scene of the paper with an obstacle given as text, saved in a folder.
fn scene_text(obstacle: &str, start: [f64; 3], goal: [f64; 3]) -> String {
    let mut spec = paper_scene("meshes", Vec::new());
    let query = spec.query.as_mut().unwrap();
    (query.start, query.goal) = (Some(start.into()), Some(goal.into()));
    format!("{}\n[[obstacles]]\n{obstacle}\n", toml::to_string(&spec).unwrap())
}

fn load(folder: &Path, obstacle: &str, start: [f64; 3], goal: [f64; 3]) -> Result<Scene, cdpr_core::Error> {
    let path = folder.join("scene.toml");
    fs::write(&path, scene_text(obstacle, start, goal)).unwrap();
    load_scene(&path)
}

/// No swept platform part and no swept cable meets a triangle of the mesh itself.
fn clear_of_triangles(scene: &Scene, mesh: &TriangleMesh, waypoints: &[Point]) -> bool {
    let faces: Vec<Triangle> =
        mesh.triangles.iter().map(|t| t.map(|i| mesh.vertices[i])).map(|[a, b, c]| Triangle::new(a, b, c)).collect();
    let robot = scene.robot();
    waypoints.windows(2).all(|ends| {
        let (from, to) = (ends[0].coords, ends[1].coords);
        let meets = |face: &Triangle| {
            let platform =
                robot.parts().iter().any(|part| overlap(&Swept::new(part, from, to - from), face, TOUCH_DEPTH));
            let cable = |c: &cdpr_core::model::Cable| {
                let swept = Triangle::new(c.outlet, c.attachment + from, c.attachment + to);
                overlap(&swept, face, TOUCH_DEPTH)
            };
            platform || robot.cables().iter().any(cable)
        };
        !faces.iter().any(meets)
    })
}

fn solved(scene: &Scene) -> Vec<Point> {
    let found = plan(scene, &PlanOptions::default(), &|| false).unwrap().result;
    assert_eq!(found.status, Status::Solved, "{}: {:?}", scene.name(), scene.notes());
    found.waypoints()
}

/// The scene with the hull of the mesh instead of the mesh.
fn with_hull(mesh: &TriangleMesh, start: [f64; 3], goal: [f64; 3]) -> Result<Scene, cdpr_core::Error> {
    let hull = Polytope::hull_of(&mesh.vertices).unwrap();
    let vertices = hull.vertices().iter().map(|v| [v.x, v.y, v.z]).collect();
    let mut spec = paper_scene("hull", vec![BodySpec { vertices: Some(vertices), ..BodySpec::default() }]);
    let query = spec.query.as_mut().unwrap();
    (query.start, query.goal) = (Some(start.into()), Some(goal.into()));
    Scene::new(spec)
}

#[test]
fn concave_obstacles_are_planned_around_through_their_hollow() {
    let folder = tempfile::tempdir().unwrap();
    let cases = [
        ("angle", angle(), [0.3, 1.0, 0.3], [1.45, 1.0, 0.4], 2),
        ("table", table(), [0.3, 1.0, 0.3], [1.7, 1.0, 1.7], 5),
        ("torus", torus(40, 16), [0.8, 1.0, 0.75], [1.2, 1.0, 1.25], 100),
        ("room", room(), [0.3, 1.0, 0.3], [1.7, 1.0, 1.7], 6),
    ];
    for (name, mesh, start, goal, most) in cases {
        write_obj(&folder.path().join(format!("{name}.obj")), &mesh, 0.001);
        let obstacle = format!("name = \"{name}\"\nmesh = \"{name}.obj\"\nunits = \"mm\"");
        let scene = load(folder.path(), &obstacle, start, goal).unwrap();
        let parts = scene.obstacles()[0].parts.len();
        assert!((2..=most).contains(&parts), "{name}: {parts} parts, {:?}", scene.notes());
        let waypoints = solved(&scene);
        assert!(clear_of_triangles(&scene, &mesh, &waypoints), "{name}");
        // The hull of the mesh, which fills the hollow, blocks every such path.
        let blocked = match with_hull(&mesh, start, goal) {
            Err(error) => error.to_string().contains("inside obstacle"),
            Ok(scene) => plan(&scene, &PlanOptions::default(), &|| false).unwrap().result.status != Status::Solved,
        };
        assert!(blocked, "{name} has no hollow");
    }
}

#[test]
fn flat_faced_polyhedra_are_filled_exactly() {
    let tilt = Rotation::from_euler_angles(0.3, -0.7, 1.1);
    for (name, mesh, count) in [("angle", angle(), 2), ("table", table(), 5), ("room", room(), 6)] {
        for mesh in [mesh.clone(), turned(&mesh, &tilt)] {
            let (pieces, faults) = pieces(&mesh, &Watch::NONE).unwrap();
            assert_eq!((pieces.len(), faults.notes().len()), (1, 0), "{name}: {faults:?}");
            let parts = convex_parts(&pieces[0], 0.01, MOST_PARTS, &Watch::NONE).unwrap();
            assert_eq!((parts.bodies.len(), parts.reach), (count, 0.0), "{name}");
        }
    }
}

/// A random point of a triangle.
fn on_triangle([a, b, c]: [Point; 3], rng: &mut ChaCha8Rng) -> Point {
    let (mut s, mut t) = (rng.random_range(0.0..1.0), rng.random_range(0.0..1.0));
    if s + t > 1.0 {
        (s, t) = (1.0 - s, 1.0 - t);
    }
    a + (b - a) * s + (c - a) * t
}

#[test]
fn parts_cover_the_mesh_within_the_stated_reach() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut holed = torus(24, 12);
    holed.triangles.retain(|t| t[0] % 7 != 3);
    let mut crumpled = torus(20, 20);
    crumpled.vertices.iter_mut().for_each(|v| *v += Vector::from_fn(|_, _| rng.random_range(-0.01..0.01)));
    let tilt = Rotation::from_euler_angles(0.3, -0.7, 1.1);
    let open_box = TriangleMesh {
        triangles: block([0.0; 3], [1.0, 2.0, 0.5]).triangles[2..].to_vec(),
        ..block([0.0; 3], [1.0, 2.0, 0.5])
    };
    for (name, mesh, tolerance) in [
        ("angle", turned(&angle(), &tilt), 0.01),
        ("table", table(), 0.05),
        ("torus", torus(40, 16), 0.03),
        ("torus, tilted", turned(&torus(24, 12), &tilt), 0.02),
        ("room", turned(&room(), &tilt), 0.1),
        ("holed", holed, 0.05),
        ("crumpled", crumpled, 0.05),
        ("inside out", inside_out(room()), 0.1),
        ("open box", turned(&open_box, &tilt), 0.02),
        ("one triangle", TriangleMesh { triangles: vec![[0, 1, 2]], vertices: angle().vertices[..3].to_vec() }, 0.01),
    ] {
        let (pieces, _) = pieces(&mesh, &Watch::NONE).unwrap();
        let parts: Vec<_> =
            pieces.iter().map(|piece| convex_parts(piece, tolerance, MOST_PARTS, &Watch::NONE).unwrap()).collect();
        let bodies = || parts.iter().flat_map(|p| &p.bodies);
        let covered = |p: &Point| bodies().any(|body| body.depth_of(p) >= -GAP_TOLERANCE);
        for triangle in &mesh.triangles {
            let corners = triangle.map(|i| mesh.vertices[i]);
            assert!(corners.iter().all(covered), "{name}");
            assert!((0..30).all(|_| covered(&on_triangle(corners, &mut rng))), "{name}");
        }
        let mut inside = 0;
        for (piece, parts) in pieces.iter().zip(&parts) {
            assert!(parts.reach <= tolerance, "{name}: {} parts reach {}", parts.bodies.len(), parts.reach);
            for body in &parts.bodies {
                let aabb = body.aabb();
                for _ in 0..200 {
                    let p = aabb.min + (aabb.max - aabb.min).map(|side| side * rng.random_range(0.0..1.0));
                    let (distance, _) = piece.distance.at(&p);
                    assert!(body.depth_of(&p) < 0.0 || distance <= parts.reach + 1e-6, "{name}: {distance}");
                    if distance < -GAP_TOLERANCE {
                        assert!(covered(&p), "{name}: {p} is inside the mesh and in no part");
                        inside += 1;
                    }
                }
            }
        }
        let solid = pieces.iter().any(|p| p.volume.is_some());
        assert_eq!(inside > 0, solid, "{name}");
    }
}

#[test]
fn convex_meshes_are_taken_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let ball = |n: usize| {
        let mut ball = torus(2 * n, n);
        let angle = |k: usize, n: usize| std::f64::consts::PI * k as f64 / n as f64;
        for (k, v) in ball.vertices.iter_mut().enumerate() {
            let (u, w) = (2.0 * angle(k / n, 2 * n), angle(k % n, n - 1));
            *v = Point::new(0.3 * w.sin() * u.cos(), 0.3 * w.sin() * u.sin(), -0.3 * w.cos());
        }
        let area = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|i| ball.vertices[i]);
            (b - a).cross(&(c - a)).norm()
        };
        let is_wrapped = |t: &[usize; 3]| t.iter().any(|i| i % n == 0) && t.iter().any(|i| i % n == n - 1);
        let triangles = ball.triangles.iter().copied().filter(|t| area(t) > 1e-9 && !is_wrapped(t)).collect();
        TriangleMesh { triangles, vertices: ball.vertices.clone() }
    };
    for (name, mesh, corners) in [("block", block([0.0; 3], [0.3, 0.2, 0.1]), 8), ("ball", ball(9), 2 + 18 * 7)] {
        write_stl(&folder.path().join(format!("{name}.stl")), &mesh);
        let obstacle = format!("mesh = \"{name}.stl\"\nposition = [1.0, 1.0, 1.0]\nscale = 1.5");
        let scene = load(folder.path(), &obstacle, [0.3; 3], [1.7; 3]).unwrap();
        let obstacle = &scene.obstacles()[0];
        assert_eq!((obstacle.name.as_str(), obstacle.parts.len()), ("obstacle 0", 1));
        assert_eq!(obstacle.parts[0].vertices().len(), corners, "{name}");
        assert!((obstacle.parts[0].volume() / mesh.volume() / 1.5f64.powi(3) - 1.0).abs() < 1e-5, "{name}");
        assert!(scene.notes().is_empty(), "{:?}", scene.notes());
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3, "nothing is kept of a convex mesh");
}

#[test]
fn units_scale_and_turn_apply_to_meshes_in_files_and_in_place() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = block([0.0; 3], [1.0, 2.0, 3.0]);
    write_obj(&folder.path().join("block.obj"), &mesh, 1.0);
    let place = "units = \"in\"\nscale = 2.0\nposition = [1.0, 1.0, 0.5]\nrpy = [0.0, 0.0, 1.5707963267948966]";
    let scene = load(folder.path(), &format!("mesh = \"block.obj\"\n{place}"), [0.3; 3], [1.7; 3]).unwrap();
    let aabb = scene.obstacles()[0].parts[0].aabb();
    let inch = 0.0254;
    assert!((aabb.max - Point::new(1.0, 1.0 + 2.0 * inch, 0.5 + 6.0 * inch)).norm() < 1e-12);
    assert!((aabb.min - Point::new(1.0 - 4.0 * inch, 1.0, 0.5)).norm() < 1e-12);
    let spec =
        MeshSpec { vertices: mesh.vertices.iter().map(|v| [v.x, v.y, v.z]).collect(), triangles: mesh.triangles };
    let in_place = BodySpec { mesh: Some(MeshSource::Inline(spec)), ..BodySpec::default() };
    let mut whole: SceneSpec = paper_scene("inline", vec![in_place]);
    whole.obstacles[0].position = Some([-0.5; 3]);
    let text = |spec: &SceneSpec| serde_json::to_string(spec).unwrap();
    assert!(Scene::new(whole.clone()).is_err(), "a mesh is no convex body");
    let loaded = scene_from_text(&text(&whole), Notation::Json, None);
    assert!(loaded.unwrap_err().to_string().contains("robot.cables[0].outlet"), "the block holds an outlet");
    whole.obstacles[0].position = Some([0.5, 0.5, 0.5]);
    whole.obstacles[0].scale = Some(0.2);
    let loaded = scene_from_text(&text(&whole), Notation::Json, None).unwrap();
    let again = scene_from_text(&text(loaded.spec()), Notation::Json, None).unwrap();
    assert_eq!(again.obstacles(), loaded.obstacles());
}

#[test]
fn cached_parts_are_used_only_if_intact() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join("angle.obj");
    write_obj(&mesh, &angle(), 1.0);
    let scene =
        |extra: &str| load(folder.path(), &format!("mesh = \"angle.obj\"\n{extra}"), [0.3; 3], [1.7; 3]).unwrap();
    let kept = || {
        let files = fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().path());
        files.filter(|p| p.to_string_lossy().ends_with(".parts.json")).collect::<Vec<_>>()
    };
    let first = scene("");
    assert_eq!(kept().len(), 1);
    let path = kept().remove(0);
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(scene(""), first);
    for broken in [
        "",
        "{}",
        &text[..text.len() / 2],
        &text.replacen("0.85", "0.95", 1),
        &text.replacen("\"sum\":\"", "\"sum\":\"0", 1),
    ] {
        assert_ne!(broken, text);
        fs::write(&path, broken).unwrap();
        assert_eq!(scene(""), first);
        assert_eq!(fs::read_to_string(&path).unwrap(), text, "made again");
    }
    scene("scale = 0.9");
    assert_eq!(kept().len(), 2);
    write_obj(&mesh, &turned(&angle(), &Rotation::from_euler_angles(0.0, 0.0, 0.01)), 1.0);
    assert_ne!(scene("").obstacles(), first.obstacles());
    // If the name is already taken by something else, nothing is cached and nothing is lost.
    kept().iter().for_each(|p| fs::remove_file(p).unwrap());
    write_obj(&mesh, &angle(), 1.0);
    fs::create_dir(&path).unwrap();
    assert_eq!(scene(""), first);
}

#[test]
fn defective_meshes_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let told = |mesh: &TriangleMesh| {
        write_obj(&folder.path().join("mesh.obj"), mesh, 1.0);
        let scene =
            load(folder.path(), "mesh = \"mesh.obj\"\nscale = 0.2\nposition = [1.0, 1.0, 1.0]", [0.3; 3], [1.7; 3]);
        scene.unwrap().notes().join("; ")
    };
    let sound = block([0.0; 3], [1.0; 3]);
    let mut holed = sound.clone();
    holed.triangles.pop();
    assert!(told(&holed).contains("3 open edges (holes)"), "{}", told(&holed));
    let mut flipped = sound.clone();
    flipped.triangles[0].swap(0, 1);
    assert!(told(&flipped).contains("the mesh was mended: 1 flipped triangle"), "{}", told(&flipped));
    assert!(told(&inside_out(sound.clone())).contains("1 piece is inside out"));
    let mut slivers = sound.clone();
    slivers.triangles.push([0, 1, 1]);
    slivers.triangles.push(slivers.triangles[0]);
    assert!(told(&slivers).contains("1 degenerate triangle, 1 doubled triangle"), "{}", told(&slivers));
    assert!(told(&angle()).contains("20 triangles in 2 convex parts, which fill it exactly"), "{}", told(&angle()));
    assert!(told(&torus(24, 12)).contains("convex parts, which reach at most"), "{}", told(&torus(24, 12)));
}

/// Exporters write concave faces as one polygon; a fan of triangles would fill their notches.
#[test]
fn concave_polygons_of_obj_files_keep_their_notches() {
    let c = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (0, 3)];
    let corner = |z: i32| c.iter().map(move |(x, y)| format!("v {x} {y} {z}\n")).collect::<String>();
    let around =
        |from: &str, list: Vec<usize>| list.iter().fold(format!("f{from}"), |line, i| format!("{line} {i}")) + "\n";
    let n = c.len();
    let sides: String =
        (0..n).map(|i| around("", vec![i + 1, (i + 1) % n + 1, (i + 1) % n + 1 + n, i + 1 + n])).collect();
    let caps = around("", (1..=n).rev().collect()) + &around("", (n + 1..=2 * n).collect());
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("c.obj"), corner(0) + &corner(1) + &sides + &caps).unwrap();
    let scene = load(folder.path(), "mesh = \"c.obj\"", [9.0, 9.0, 9.0], [-9.0, 9.0, 9.0]).unwrap();
    let inside = |x: f64, y: f64| {
        let parts = &scene.obstacles()[0].parts;
        parts.iter().map(|part| part.depth_of(&Point::new(x, y, 0.5))).fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(scene.notes()[0].contains("which fill it exactly"), "{:?}", scene.notes());
    for (x, y) in [(0.5, 1.5), (2.5, 0.5), (2.5, 2.5), (0.9, 2.9)] {
        assert!(inside(x, y) > 0.05, "({x}, {y}) is inside: {}", inside(x, y));
    }
    for (x, y) in [(2.0, 1.5), (1.1, 1.1), (2.9, 1.9)] {
        assert!(inside(x, y) < -0.05, "({x}, {y}) is in the notch: {}", inside(x, y));
    }
}

/// A ball with many corners stays one part.
#[test]
fn a_fine_ball_is_convex() {
    let (rings, around) = (20, 40);
    let angle = |k: usize, n: usize| std::f64::consts::PI * k as f64 / n as f64;
    let at = |i: usize, j: usize| {
        let (theta, phi) = (angle(i, rings), 2.0 * angle(j % around, around));
        Point::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos())
    };
    let quads = (0..rings).flat_map(|i| (0..around).map(move |j| (i, j)));
    let pieces = quads.flat_map(|(i, j)| {
        let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        [[a, b, c], [a, c, d]]
            .into_iter()
            .enumerate()
            .filter(move |(k, _)| (i, *k) != (0, 1) && (i, *k) != (rings - 1, 0))
    });
    let corners: Vec<Point> = pieces.flat_map(|(_, t)| t).collect();
    let triangles = (0..corners.len() / 3).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let folder = tempfile::tempdir().unwrap();
    write_stl(&folder.path().join("ball.stl"), &TriangleMesh { vertices: corners, triangles });
    let scene =
        load(folder.path(), "mesh = \"ball.stl\"\nposition = [5.0, 5.0, 5.0]", [4.0; 3], [-4.0, 4.0, 4.0]).unwrap();
    assert_eq!(scene.obstacles()[0].parts.len(), 1, "{:?}", scene.notes());
}

#[test]
fn files_that_are_no_meshes_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let stl = {
        let path = folder.path().join("good.stl");
        write_stl(&path, &angle());
        fs::read(path).unwrap()
    };
    let counting = |count: u32| [&stl[..80], &count.to_le_bytes(), &stl[84..]].concat();
    let not_finite = {
        let mut bytes = stl.clone();
        bytes[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
        bytes
    };
    let scattered = |n: usize| {
        let triangle = |k: usize| format!("v {k} 0 0\nv {k}.5 0 0\nv {k} 1 0\nf -3 -2 -1\n");
        (0..n).map(triangle).collect::<String>().into_bytes()
    };
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_string();
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("a.stl", Vec::new(), "found no triangles"),
        ("a.stl", stl[..stl.len() - 10].to_vec(), "ends after 19 of 20 triangles"),
        ("a.stl", counting(u32::MAX), "ends after 20 of 4294967295 triangles, or is not an STL file"),
        ("a.stl", counting(400_000), "ends after 20 of 400000"),
        ("a.obj", b"v 0 0 0\n".repeat(1_500_001), "found more than 1500000 vertices, expected at most that many"),
        ("a.obj", [b"v 0 0 0\n".to_vec(), b"f 1 1 1\n".repeat(500_001)].concat(), "found more than 500000 triangles"),
        ("a.obj", scattered(5001), "found 5001 disconnected pieces"),
        ("a.stl", not_finite, "not finite"),
        ("a.stl", b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0".to_vec(), "three numbers (line 4)"),
        ("a.stl", b"solid\nendsolid".to_vec(), "no triangles"),
        ("a.obj", Vec::new(), "no triangles"),
        ("a.obj", (obj.clone() + "f 1 2 9\n").into_bytes(), "found the index 9, but the file has 3 vertices (line 4)"),
        ("a.obj", (obj.clone() + "f 1 2 -9\n").into_bytes(), "found the index -9, but 3 vertices precede it (line 4)"),
        ("a.obj", (obj.clone() + "f 1 2 99999999999999999999\n").into_bytes(), "expected a corner such as 7"),
        ("a.obj", (obj.replace("v 1 0 0", "v nan 0 0") + "f 1 2 3\n").into_bytes(), "not finite"),
        ("a.obj", (obj.replace("v 1 0 0", "v 1e300 0 0") + "f 1 2 3\n").into_bytes(), "expected coordinates up to"),
        ("a.obj", (obj.replace("v 1 0 0", "v 0 0 0") + "f 1 2 1\n").into_bytes(), "no triangle with an area"),
        ("a.ply", stl.clone(), "expected .stl or .obj"),
        ("b.obj", Vec::new(), "cannot be read"),
    ];
    for (name, bytes, expected) in cases {
        let path = folder.path().join(name);
        if name != "b.obj" {
            fs::write(&path, bytes).unwrap();
        }
        let error = load(folder.path(), &format!("mesh = \"{name}\""), [0.3; 3], [1.7; 3]).unwrap_err().to_string();
        assert!(error.contains(expected) && error.contains(name), "expected \"{expected}\" in: {error}");
    }
    let keys = [
        ("mesh = \"good.stl\"\nbox = [1.0, 1.0, 1.0]", "found several shapes"),
        ("box = [0.1, 0.1, 0.1]\nscale = 2.0", "obstacles[0].scale: found without a mesh"),
        ("mesh = \"good.stl\"\nscale = 0.0", "obstacles[0].scale"),
        ("mesh = \"good.stl\"\ntolerance = -1.0", "obstacles[0].tolerance"),
        ("mesh = \"good.stl\"\nunits = \"ell\"", "units"),
        (
            "mesh = { vertices = [[0.0, 0.0, 0.0]], triangles = [[0, 0, 1]] }",
            "obstacles[0].mesh: triangle 0 has a corner",
        ),
    ];
    for (keys, expected) in keys {
        let error = load(folder.path(), keys, [0.3; 3], [1.7; 3]).unwrap_err().to_string();
        assert!(error.contains(expected), "expected \"{expected}\" in: {error}");
    }
}

#[test]
fn a_flat_sheet_of_many_triangles_is_one_thin_part() {
    let n = 100;
    let vertices = (0..=n).flat_map(|i| (0..=n).map(move |j| Point::new(0.01 * i as f64, 0.02 * j as f64, 1.5)));
    let at = |i: usize, j: usize| i * (n + 1) + j;
    let quads = (0..n * n).map(|k| (k / n, k % n));
    let triangles = quads
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]);
    let mesh = TriangleMesh { vertices: vertices.collect(), triangles: triangles.collect() };
    let (pieces, _) = pieces(&mesh, &Watch::NONE).unwrap();
    let parts = convex_parts(&pieces[0], 0.01, MOST_PARTS, &Watch::NONE).unwrap();
    assert_eq!(parts.bodies.len(), 1);
    assert!((parts.bodies[0].volume() / (1.0 * 2.0 * 2.0 * SHEET) - 1.0).abs() < 1e-3);
}

#[test]
fn every_kind_of_file_gives_the_same_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let (obj, stl, text) = (folder.path().join("a.obj"), folder.path().join("a.STL"), folder.path().join("b.stl"));
    let mesh = torus(12, 8);
    write_obj(&obj, &mesh, 1.0);
    write_stl(&stl, &mesh);
    let lines = mesh.triangles.iter().map(|t| {
        let corner =
            |i: usize| format!("vertex {} {} {}\n", mesh.vertices[i].x, mesh.vertices[i].y, mesh.vertices[i].z);
        format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", t.map(corner).concat())
    });
    fs::write(&text, format!("solid\n{}endsolid\n", lines.collect::<String>())).unwrap();
    let mut header = fs::read(&stl).unwrap();
    header[..6].copy_from_slice(b"solid ");
    let named = folder.path().join("c.stl");
    fs::write(&named, header).unwrap();
    for path in [obj, stl, text, named] {
        let read = load_mesh(&path).unwrap();
        assert_eq!(read.triangles.len(), mesh.triangles.len(), "{path:?}");
        assert!((read.volume() / mesh.volume() - 1.0).abs() < 1e-5, "{path:?}");
    }
}

#[test]
fn platforms_may_be_meshes_too() {
    let folder = tempfile::tempdir().unwrap();
    write_obj(&folder.path().join("plate.obj"), &block([-0.075, -0.075, -0.025], [0.075, 0.075, 0.025]), 0.001);
    let mut spec = paper_scene("platform", Vec::new());
    let cdpr_core::model::RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
    robot.platform[0] = BodySpec { mesh: Some(MeshSource::File("plate.obj".into())), ..BodySpec::default() };
    robot.platform[0].units = Some(cdpr_core::model::Unit::Mm);
    fs::write(folder.path().join("scene.json"), serde_json::to_string(&spec).unwrap()).unwrap();
    let scene = load_scene(folder.path().join("scene.json")).unwrap();
    assert!((scene.robot().parts()[0].volume() / (0.15 * 0.15 * 0.05) - 1.0).abs() < 1e-9);
}

/// A hall of about 50 000 triangles: walls with a floor in one piece, round columns, pipes with many sides, angles,
/// rings.
fn hall() -> TriangleMesh {
    let mut parts = vec![joined(&[
        block([-10.0, -10.0, -0.2], [10.0, 10.0, 6.0]),
        inside_out(block([-9.8, -9.8, 0.0], [9.8, 9.8, 5.8])),
    ])];
    let column = |x: f64, y: f64, sides: usize, radius: f64, height: f64| {
        let turn = |k: usize| 2.0 * std::f64::consts::PI * k as f64 / sides as f64;
        let base: Vec<_> = (0..sides).map(|k| [x + radius * turn(k).cos(), y + radius * turn(k).sin()]).collect();
        let caps: Vec<_> = (1..sides - 1).map(|k| [0, k, k + 1]).collect();
        prism(&base, 0.0, height, &caps)
    };
    let moved = |mesh: &TriangleMesh, by: Vector| TriangleMesh {
        vertices: mesh.vertices.iter().map(|v| v + by).collect(),
        ..mesh.clone()
    };
    for i in 0..14 {
        for j in 0..14 {
            let (x, y) = (-9.0 + 1.3 * f64::from(i), -9.0 + 1.3 * f64::from(j));
            if [x, y].iter().all(|c| (-1.0..3.0).contains(c)) {
                continue; // the position of the robot
            }
            parts.push(match (i + j) % 4 {
                0 => column(x, y, 48, 0.2, 3.0),
                1 => moved(&angle(), Vector::new(x - 1.2, y - 1.0, 0.5)),
                2 => joined(&[
                    column(x, y, 64, 0.1, 0.6),
                    column(x + 0.3, y, 64, 0.1, 0.6),
                    column(x, y + 0.3, 64, 0.1, 0.6),
                ]),
                _ => moved(&torus(24, 12), Vector::new(x - 1.0, y - 1.0, 1.0)),
            });
        }
    }
    joined(&parts)
}

#[test]
fn a_hall_of_many_triangles_loads_in_seconds() {
    let folder = tempfile::tempdir().unwrap();
    let hall = hall();
    assert!(hall.triangles.len() > 50_000, "{}", hall.triangles.len());
    write_stl(&folder.path().join("hall.stl"), &hall);
    let obstacle = "mesh = \"hall.stl\"\ntolerance = 0.05";
    let started = std::time::Instant::now();
    let scene = load(folder.path(), obstacle, [0.3; 3], [1.7; 3]).unwrap();
    let first = started.elapsed();
    let again = load(folder.path(), obstacle, [0.3; 3], [1.7; 3]).unwrap();
    println!(
        "{} parts, {first:?}, then {:?}: {:?}",
        scene.obstacles()[0].parts.len(),
        started.elapsed() - first,
        scene.notes()
    );
    assert_eq!(again, scene);
    assert!(first.as_secs() < 60, "{first:?}");
}
