//! Parts of any mesh cover it to the last corner: random meshes of thirty families, and all bodies made of few cubes.
//! What is inside is decided by solid angles, all triangles one by one; `CDPR_VERIFY=n` tries n times as many meshes.

use std::f64::consts::TAU;

use cdpr_core::geometry::{Aabb, HalfSpace, Point, Polytope, TriangleMesh, Vector, convex_mesh, convex_parts, pieces};
use cdpr_core::limits::MOST_PARTS;
use cdpr_core::tolerances::{GAP_TOLERANCE, MESH_TOLERANCE, SHEET};
use cdpr_core::watch::Watch;
use cdpr_tests::meshes::*;
use cdpr_tests::{effort, rng, rotation};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// How a mesh was covered.
struct Covered {
    bodies: Vec<Polytope>,
    reach: f64,
    enlarged: usize,
    solid: bool,
}

fn parts_of(mesh: &TriangleMesh) -> Covered {
    let (pieces, _) = pieces(mesh, &Watch::NONE).unwrap();
    let aabb = Aabb::around(&mesh.vertices);
    let tolerance = MESH_TOLERANCE * (aabb.max - aabb.min).amax();
    let mut covered = Covered { bodies: Vec::new(), reach: 0.0, enlarged: 0, solid: false };
    for piece in &pieces {
        let parts = convex_parts(piece, tolerance, MOST_PARTS, &Watch::NONE).unwrap();
        covered.bodies.extend(parts.bodies);
        covered.reach = covered.reach.max(parts.reach);
        covered.enlarged += parts.enlarged;
        covered.solid |= piece.volume.is_some();
    }
    covered
}

/// Number of layers around a point, from solid angles; not an integer for an open surface.
fn layers(mesh: &TriangleMesh, p: &Point) -> f64 {
    let angle = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|i| mesh.vertices[i] - p);
        let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
        let below = la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb;
        2.0 * a.dot(&b.cross(&c)).atan2(below)
    };
    mesh.triangles.iter().map(angle).sum::<f64>() / (2.0 * TAU)
}

/// Distance of a point from a triangle, by cases that share no code with the parts.
fn from_triangle(p: &Point, [a, b, c]: [Point; 3]) -> f64 {
    let from_edge = |p0: Point, p1: Point| {
        let along = p1 - p0;
        let square = along.norm_squared();
        let share = if square > 0.0 { ((p - p0).dot(&along) / square).clamp(0.0, 1.0) } else { 0.0 };
        (p0 + along * share - p).norm()
    };
    let normal = (b - a).cross(&(c - a));
    let above = |p0: Point, p1: Point| normal.dot(&(p1 - p0).cross(&(p - p0))) >= 0.0;
    let edges = from_edge(a, b).min(from_edge(b, c)).min(from_edge(c, a));
    let over = normal.norm() > 0.0 && above(a, b) && above(b, c) && above(c, a);
    if over { edges.min(normal.normalize().dot(&(p - a)).abs()) } else { edges }
}

fn share(rng: &mut ChaCha8Rng) -> f64 {
    rng.random_range(0.0..1.0)
}

fn on_triangle([a, b, c]: [Point; 3], rng: &mut ChaCha8Rng) -> Point {
    // One in four on an edge or a corner.
    let (mut s, mut t) = (share(rng), share(rng));
    match rng.random_range(0..8) {
        0 => t = 0.0,
        1 => (s, t) = (0.0, 0.0),
        _ => {}
    }
    if s + t > 1.0 {
        (s, t) = (1.0 - s, 1.0 - t);
    }
    a + (b - a) * s + (c - a) * t
}

/// Panics unless points of the surface and of the inside are in the parts, and points of the parts within their reach.
/// `clean` is a mesh with the same inside whose triangles are consistent.
fn assert_covered(name: &str, mesh: &TriangleMesh, clean: &TriangleMesh, samples: usize, rng: &mut ChaCha8Rng) {
    let found = parts_of(mesh);
    let whole = Aabb::around(&mesh.vertices);
    let extent = (whole.max - whole.min).amax();
    let room = GAP_TOLERANCE + 2e-9 * extent + 1e-15 * whole.max.coords.amax().max(whole.min.coords.amax());
    let covered = |p: &Point| found.bodies.iter().any(|body| body.depth_of(p) >= -room);
    for k in 0..samples {
        let t = mesh.triangles[if k < mesh.triangles.len() { k } else { rng.random_range(0..mesh.triangles.len()) }];
        let p = on_triangle(t.map(|i| mesh.vertices[i]), rng);
        assert!(covered(&p), "{name}: {p} on the surface is in no part");
    }
    let welded = 1e-6 * extent; // so close to the surface, welding decides
    let to_surface = |p: &Point| {
        let triangles = mesh.triangles.iter().map(|t| t.map(|i| mesh.vertices[i]));
        triangles.map(|t| from_triangle(p, t)).fold(f64::INFINITY, f64::min)
    };
    for k in 0..if found.solid { samples } else { 0 } {
        let p = if k % 2 == 0 {
            whole.min + (whole.max - whole.min).map(|side| side * share(rng))
        } else {
            // Close to a corner.
            let corner = mesh.vertices[rng.random_range(0..mesh.vertices.len())];
            corner + Vector::from_fn(|_, _| rng.random_range(-0.05..0.05)) * extent * share(rng)
        };
        if layers(clean, &p).round() != 0.0 && !covered(&p) {
            assert!(to_surface(&p) <= welded, "{name}: {p} inside is in no part");
        }
    }
    for _ in 0..samples / 10 {
        let body = &found.bodies[rng.random_range(0..found.bodies.len())];
        let corners = body.vertices();
        let [p, q, r] = [0; 3].map(|_| corners[rng.random_range(0..corners.len())].coords);
        let (s, t) = (share(rng), share(rng));
        for p in [Point::from(p), Point::from(p * s + (q * t + r * (1.0 - t)) * (1.0 - s))] {
            let inside = found.solid && layers(clean, &p).round() != 0.0;
            let distance = if inside { 0.0 } else { to_surface(&p) };
            assert!(distance <= found.reach + room + welded, "{name}: {distance} beyond, {} stated", found.reach);
        }
    }
}

fn flipped(mut mesh: TriangleMesh, rng: &mut ChaCha8Rng) -> TriangleMesh {
    for t in &mut mesh.triangles {
        if rng.random_range(0.0..1.0) < 0.15 {
            t.swap(1, 2);
        }
    }
    mesh
}

/// Divides triangles at the middle of an edge, without their neighbours: corners in the middle of edges. `closing` adds
/// triangles without area between.
fn with_corners_on_edges(mut mesh: TriangleMesh, closing: bool, rng: &mut ChaCha8Rng) -> TriangleMesh {
    for k in 0..mesh.triangles.len() {
        if rng.random_range(0..4) == 0 {
            let [a, b, c] = mesh.triangles[k];
            let middle = mesh.vertices[a] + (mesh.vertices[b] - mesh.vertices[a]) * rng.random_range(0.2..0.8);
            let m = mesh.vertices.len();
            mesh.vertices.push(middle);
            mesh.triangles[k] = [a, m, c];
            mesh.triangles.push([m, b, c]);
            if closing {
                mesh.triangles.push([a, b, m]);
            }
        }
    }
    mesh
}

/// Divides triangles close to an edge, again and again: needles.
fn with_needles(mut mesh: TriangleMesh, rng: &mut ChaCha8Rng) -> TriangleMesh {
    for _ in 0..20 {
        let k = rng.random_range(0..mesh.triangles.len());
        let [a, b, c] = mesh.triangles[k];
        let [p, q, r] = [a, b, c].map(|i| mesh.vertices[i].coords);
        let (s, t) = (10f64.powf(rng.random_range(-9.0..-1.0)), share(rng));
        let m = mesh.vertices.len();
        mesh.vertices.push(Point::from((p * t + q * (1.0 - t)) * (1.0 - s) + r * s));
        mesh.triangles[k] = [a, b, m];
        mesh.triangles.extend([[b, c, m], [c, a, m]]);
    }
    mesh
}

fn moved(mut mesh: TriangleMesh, by: [f64; 3]) -> TriangleMesh {
    mesh.vertices.iter_mut().for_each(|v| *v += Vector::from(by));
    mesh
}

/// A star-shaped prism with random radii: concave.
fn star(rng: &mut ChaCha8Rng) -> TriangleMesh {
    let n = rng.random_range(5..16);
    let corner = |k: usize, radius: f64| {
        let turn = TAU * k as f64 / n as f64;
        [radius * turn.cos(), radius * turn.sin()]
    };
    let mut base: Vec<[f64; 2]> = (0..n).map(|k| corner(k, rng.random_range(0.2..1.0))).collect();
    base.push([0.0, 0.0]); // the fan's middle, a corner that no side uses
    let caps: Vec<[usize; 3]> = (0..n).map(|k| [k, (k + 1) % n, n]).collect();
    let mut mesh = prism(&base, 0.0, rng.random_range(0.1..1.0), &caps);
    let middle = base.len() - 1;
    let around = |i: &usize| i % base.len() == middle;
    // The prism closes around its middle, too: leave out the sides there.
    let sides = 2 * caps.len();
    let mut k = 0;
    mesh.triangles.retain(|t| {
        k += 1;
        k <= sides || !t.iter().any(around)
    });
    let n_base = base.len();
    mesh.triangles.extend([[n - 1, 0, n_base], [n - 1, n_base, n - 1 + n_base]]);
    mesh
}

fn random_cubes(size: i32, density: f64, rng: &mut ChaCha8Rng) -> TriangleMesh {
    let bits: Vec<bool> = (0..size.pow(3)).map(|k| k == 0 || rng.random_range(0.0..1.0) < density).collect();
    of_cubes(&|[x, y, z]| bits[((x * size + y) * size + z) as usize], [size; 3])
}

/// A sheet of random corners, closed or open, that crosses itself.
fn tangle(points: usize, triangles: usize, rng: &mut ChaCha8Rng) -> TriangleMesh {
    let vertices = (0..points).map(|_| Point::from(Vector::from_fn(|_, _| rng.random_range(-0.5..0.5)))).collect();
    let pick = |rng: &mut ChaCha8Rng| [0; 3].map(|_| rng.random_range(0..points));
    TriangleMesh { vertices, triangles: (0..triangles).map(|_| pick(rng)).collect() }
}

fn bumpy(rng: &mut ChaCha8Rng, by: f64) -> TriangleMesh {
    let mut mesh = ball(rng.random_range(5..14), rng.random_range(4..9));
    mesh.vertices.iter_mut().for_each(|v| v.coords *= 1.0 + rng.random_range(-by..by));
    mesh
}

/// A ring whose tube is wound around twice: it crosses itself.
fn crossing_itself() -> TriangleMesh {
    let mut mesh = torus(24, 8);
    for v in &mut mesh.vertices {
        let turn = (v.y - 1.0).atan2(v.x - 1.0);
        v.x += 0.5 * (2.0 * turn).cos();
        v.y += 0.3 * (3.0 * turn).sin();
    }
    mesh
}

fn open_box() -> TriangleMesh {
    let whole = block([0.0; 3], [1.0, 2.0, 0.5]);
    TriangleMesh { triangles: whole.triangles[2..].to_vec(), ..whole }
}

/// A family of meshes: a mesh, and one with the same inside whose triangles are consistent.
type Family = (&'static str, fn(&mut ChaCha8Rng) -> (TriangleMesh, TriangleMesh));

fn same(mesh: TriangleMesh) -> (TriangleMesh, TriangleMesh) {
    (mesh.clone(), mesh)
}

const FAMILIES: &[Family] = &[
    ("block", |rng| same(block([0.0; 3], [0; 3].map(|_| rng.random_range(0.1..1.0))))),
    ("ball", |rng| same(ball(rng.random_range(5..20), rng.random_range(4..12)))),
    ("angle", |_| same(angle())),
    ("table", |_| same(table())),
    ("torus", |rng| same(torus(rng.random_range(6..24), rng.random_range(4..10)))),
    ("star", |rng| same(star(rng))),
    ("bumpy ball", |rng| same(bumpy(rng, 0.3))),
    ("bumpy ball, nearly round", |rng| same(bumpy(rng, 0.01))),
    ("room", |_| same(room())),
    ("nested rooms", |_| {
        let hollow = inside_out(block([0.3; 3], [0.7; 3]));
        same(joined(&[room(), block([0.0; 3], [1.0; 3]), hollow, block([0.4; 3], [0.6; 3])]))
    }),
    ("dense cubes", |rng| same(random_cubes(4, 0.8, rng))),
    ("sparse cubes", |rng| same(random_cubes(3, 0.4, rng))),
    ("cubes with hollows", |rng| same(random_cubes(5, 0.93, rng))),
    ("abutting blocks", |rng| {
        let (y, z) = (rng.random_range(0.3..2.0), rng.random_range(0.3..2.0));
        let apart =
            [block([0.0; 3], [1.0; 3]), block([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]), block([2.0, 0.0, 0.0], [3.0, y, z])];
        same(joined(&apart))
    }),
    ("abutting cubes, mirrored", |_| {
        let first = block([0.0; 3], [1.0; 3]);
        let mirror = |mesh: &TriangleMesh, axis: usize| {
            let mut mesh = inside_out(mesh.clone());
            mesh.vertices.iter_mut().for_each(|v| v[axis] = 2.0 - v[axis]);
            mesh
        };
        let (second, third) = (mirror(&first, 0), mirror(&first, 1));
        let fourth = mirror(&second, 1);
        same(joined(&[first, second, third, fourth]))
    }),
    ("corners on edges", |rng| {
        let mesh = star(rng);
        (with_corners_on_edges(mesh.clone(), false, rng), mesh)
    }),
    ("corners on edges, closed", |rng| {
        let mesh = if rng.random_range(0..2) == 0 { angle() } else { star(rng) };
        (with_corners_on_edges(mesh.clone(), true, rng), mesh)
    }),
    ("needles", |rng| {
        let mesh = with_needles(angle(), rng);
        same(mesh)
    }),
    ("needles on a ball", |rng| {
        let mesh = with_needles(bumpy(rng, 0.2), rng);
        same(mesh)
    }),
    ("flipped", |rng| {
        let mesh = torus(12, 6);
        (flipped(mesh.clone(), rng), mesh)
    }),
    ("flipped cubes", |rng| {
        let mesh = random_cubes(2, 0.6, rng);
        (flipped(mesh.clone(), rng), mesh)
    }),
    ("doubled and degenerate", |rng| {
        let clean = star(rng);
        let mut mesh = clean.clone();
        for _ in 0..6 {
            let t = mesh.triangles[rng.random_range(0..mesh.triangles.len())];
            mesh.triangles.push([t[1], t[2], t[0]]);
            mesh.triangles.push([t[0], t[1], t[1]]);
        }
        (mesh, clean)
    }),
    ("single precision", |rng| {
        let mesh = turned(&moved(star(rng), [3.0, -2.0, 5.0]), &rotation(rng));
        same(TriangleMesh { vertices: mesh.vertices.iter().map(|v| v.map(|x| f64::from(x as f32))).collect(), ..mesh })
    }),
    ("crossing itself", |_| same(crossing_itself())),
    ("overlapping and joined", |rng| {
        // Two blocks that overlap and share one corner: one piece with two layers inside.
        let s = rng.random_range(0.2..0.8);
        let mut mesh = joined(&[block([0.0; 3], [1.0; 3]), block([s; 3], [2.0; 3])]);
        mesh.vertices[8] = mesh.vertices[0];
        same(mesh)
    }),
    ("open box", |_| same(open_box())),
    ("holed torus", |_| {
        let mut mesh = torus(24, 12);
        mesh.triangles.retain(|t| t[0] % 7 != 3);
        same(mesh)
    }),
    ("flat and tilted", |rng| {
        let n = rng.random_range(1..12);
        let mut mesh = tangle(n + 2, 0, rng);
        mesh.vertices.iter_mut().for_each(|v| v.z = 0.0);
        mesh.triangles = (0..n).map(|k| [k, k + 1, k + 2]).collect();
        same(mesh)
    }),
    ("open tangle", |rng| {
        let (points, triangles) = (rng.random_range(4..12), rng.random_range(1..12));
        let mut mesh = tangle(points, triangles, rng);
        mesh.triangles.retain(|[a, b, c]| a != b && b != c && c != a);
        mesh.triangles.push([0, 1, 2]);
        same(mesh)
    }),
    ("closed tangle", |rng| {
        let mut mesh = bumpy(rng, 0.2);
        mesh.vertices.iter_mut().for_each(|v| *v += Vector::from_fn(|_, _| rng.random_range(-0.3..0.3)));
        same(mesh)
    }),
];

#[test]
fn meshes_of_thirty_families_are_covered() {
    assert_eq!(FAMILIES.len(), 30);
    let per_family = 2 * effort() as usize;
    let cases: Vec<(usize, usize)> = (0..FAMILIES.len()).flat_map(|f| (0..per_family).map(move |k| (f, k))).collect();
    cases.into_par_iter().for_each(|(f, k)| {
        let (name, make) = FAMILIES[f];
        let mut rng = rng(1000 * f as u64 + k as u64);
        let (mesh, clean) = make(&mut rng);
        let scale = if k % 2 == 0 { 1.0 } else { 10f64.powf(rng.random_range(-3.0..4.0)) };
        let turn = if k % 3 == 0 { cdpr_core::geometry::Rotation::identity() } else { rotation(&mut rng) };
        let far = [1e3, -2e3, 5e2].map(|x| if k % 5 == 4 { x * scale } else { 0.0 });
        let placed = |mesh: &TriangleMesh| {
            let mut mesh = moved(turned(mesh, &turn), [0.0; 3]);
            mesh.vertices.iter_mut().for_each(|v| *v = Point::from(v.coords * scale + Vector::from(far)));
            mesh
        };
        assert_covered(&format!("{name} {k}, scale {scale}"), &placed(&mesh), &placed(&clean), 3000, &mut rng);
    });
}

/// Volume of what parts of a body have in common with each cube, and with each other.
fn assert_filled(name: &str, bodies: &[Polytope], filled: &dyn Fn([i32; 3]) -> bool, size: [i32; 3]) {
    let common = |planes: &[HalfSpace], within: &Aabb| convex_mesh(planes, within).map_or(0.0, |mesh| mesh.volume());
    let planes: Vec<Vec<HalfSpace>> = bodies.iter().map(Polytope::half_spaces).collect();
    for x in 0..size[0] {
        for y in 0..size[1] {
            for z in 0..size[2] {
                let min = Point::from([x, y, z].map(f64::from));
                let cube = Aabb { min, max: min + Vector::repeat(1.0) };
                let sum: f64 = planes.iter().map(|planes| common(planes, &cube)).sum();
                let expected = if filled([x, y, z]) { 1.0 } else { 0.0 };
                assert!((sum - expected).abs() < 1e-9, "{name}: {sum} of cube {x} {y} {z}");
            }
        }
    }
    let whole = Aabb { min: Point::origin(), max: Point::from(size.map(f64::from)) };
    for (k, a) in planes.iter().enumerate() {
        for (b, other) in planes.iter().zip(bodies).skip(k + 1) {
            if !other.aabb().apart_by(bodies[k].aabb(), 0.0) {
                let twice = common(&[&a[..], &b[..]].concat(), &whole);
                assert!(twice < 1e-9, "{name}: parts have {twice} in common");
            }
        }
    }
}

/// The union of the parts has exactly the volume of the body: it lies in its cubes, fills each, and no parts overlap.
fn assert_exact(name: &str, filled: &dyn Fn([i32; 3]) -> bool, size: [i32; 3]) -> usize {
    let found = parts_of(&of_cubes(filled, size));
    assert_eq!((found.reach, found.enlarged), (0.0, 0), "{name}: {} parts", found.bodies.len());
    assert_filled(name, &found.bodies, filled, size);
    found.bodies.len()
}

#[test]
fn every_body_of_up_to_twelve_cubes_is_filled_exactly() {
    // Every seventh, or all of them.
    let step = if effort() > 1 { 1 } else { 7 };
    let bodies: Vec<u32> = (1..1 << 12).step_by(step).collect();
    let parts: usize = bodies
        .par_iter()
        .map(|bits| {
            let filled = |[x, y, z]: [i32; 3]| bits >> (4 * x + 2 * y + z) & 1 == 1;
            assert_exact(&format!("body {bits:#b}"), &filled, [3, 2, 2])
        })
        .sum();
    println!("{} bodies, {parts} parts", bodies.len());
}

#[test]
fn bodies_of_many_cubes_are_filled_exactly() {
    let parts: usize = (0..170 * effort() as u64)
        .into_par_iter()
        .map(|seed| {
            let mut rng = rng(seed);
            let density = rng.random_range(0.2..0.95);
            let bits: Vec<bool> = (0..64).map(|k| k == 0 || rng.random_range(0.0..1.0) < density).collect();
            let filled = |[x, y, z]: [i32; 3]| bits[(16 * x + 4 * y + z) as usize];
            assert_exact(&format!("body {seed}"), &filled, [4; 3])
        })
        .sum();
    println!("{parts} parts");
}

#[test]
fn inner_walls_need_no_parts_but_fins_do() {
    let mut rng = rng(5);
    let blocks = [
        block([0.0; 3], [1.0; 3]),
        block([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]),
        block([2.0, 0.0, 0.0], [3.0, 1.134, 0.344]),
    ];
    let fin = |y: f64| {
        let corners = [[1.0, 1.0, 0.0], [1.0, y, 0.0], [1.0, y, 1.0], [1.0, 1.0, 1.0]].map(Point::from);
        TriangleMesh { vertices: corners.to_vec(), triangles: vec![[0, 1, 2], [0, 2, 3], [0, 2, 1], [0, 3, 2]] }
    };
    for (mesh, most) in [(joined(&blocks), 3), (joined(&[blocks[0].clone(), fin(1.7)]), 3)] {
        for scale in [1e-2, 1.0, 1e3] {
            for _ in 0..5 {
                let mut placed = turned(&mesh, &rotation(&mut rng));
                placed.vertices.iter_mut().for_each(|v| *v *= scale);
                let parts = parts_of(&placed);
                assert!(parts.bodies.len() <= most && parts.reach < 0.02 * 3.0 * scale, "{}", parts.bodies.len());
                assert_covered("walls", &placed, &placed, 1000, &mut rng);
            }
        }
    }
}

#[test]
fn tilted_flat_pieces_are_thin_parts_whatever_the_tolerance() {
    let mut rng = rng(6);
    let mut triangle = |k: usize| {
        let corner =
            |_| Point::from(Vector::from_fn(|_, _| rng.random_range(-1.0..1.0)) + Vector::x() * (3.0 * k as f64));
        TriangleMesh { vertices: (0..3).map(corner).collect(), triangles: vec![[0, 1, 2]] }
    };
    let (one, sixteen) = (triangle(0), (1..17).map(&mut triangle).collect::<Vec<_>>());
    for (mesh, count) in [(one, 1), (joined(&sixteen), 16)] {
        let (pieces, _) = pieces(&mesh, &Watch::NONE).unwrap();
        let parts: Vec<_> =
            pieces.iter().map(|piece| convex_parts(piece, 0.003, MOST_PARTS, &Watch::NONE).unwrap()).collect();
        assert_eq!(parts.iter().map(|parts| parts.bodies.len()).sum::<usize>(), count);
        assert!(parts.iter().all(|parts| parts.reach < 1.001 * 3f64.sqrt() * SHEET));
    }
}
