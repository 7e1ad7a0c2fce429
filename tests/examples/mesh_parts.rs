//! Measures how long it takes to turn meshes into convex parts, how many there are, and how far they extend beyond
//! them.
//!
//! `cargo run --release -p cdpr-tests --example mesh_parts -- [NAME ...]`: all meshes, or those with these names.

use std::f64::consts::{PI, TAU};
use std::time::Instant;

use cdpr_core::geometry::{Point, TriangleMesh, Vector};
use cdpr_core::model::{BodySpec, MeshSource, MeshSpec};
use cdpr_core::testing::paper_scene;
use cdpr_files::scene_from_text;
use cdpr_files::text::Notation;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A grid that closes in both directions, or in the first only.
fn grid(around: usize, across: usize, closes: bool, at: impl Fn(f64, f64) -> [f64; 3]) -> TriangleMesh {
    let rows = if closes { across } else { across + 1 };
    let share = |k: usize, n: usize| k as f64 / n as f64;
    let places = (0..around * rows).map(|k| Point::from(at(share(k / rows, around), share(k % rows, across))));
    let index = |i: usize, j: usize| (i % around) * rows + j % rows;
    let quads = (0..around * across).map(|k| (k / across, k % across));
    let triangles = quads.flat_map(|(i, j)| {
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    TriangleMesh { vertices: places.collect(), triangles: triangles.collect() }
}

fn torus(around: usize, across: usize) -> TriangleMesh {
    grid(around, across, true, |u, v| {
        let (u, v) = (TAU * u, TAU * v);
        let reach = 0.62 + 0.1 * v.cos();
        [reach * u.cos(), reach * u.sin(), 0.1 * v.sin()]
    })
}

/// A closed surface around the z axis: radius and height as functions of the fraction from one pole to the other.
fn turned(around: usize, across: usize, outline: impl Fn(f64, f64) -> [f64; 2]) -> TriangleMesh {
    let mut mesh = grid(around, across, false, |u, v| {
        let [radius, height] = outline(u, v);
        [radius * (TAU * u).cos(), radius * (TAU * u).sin(), height]
    });
    // The corners at a pole are identified.
    let rows = across + 1;
    let pole = |i: usize| match i % rows {
        0 => 0,
        j if j == across => across,
        _ => i,
    };
    mesh.triangles.iter_mut().flatten().for_each(|i| *i = pole(*i));
    mesh.triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    mesh
}

fn sphere(around: usize, across: usize) -> TriangleMesh {
    turned(around, across, |_, v| [0.6 * (PI * v).sin(), -0.6 * (PI * v).cos()])
}

fn capsule(around: usize, across: usize) -> TriangleMesh {
    turned(around, across, |_, v| [0.2 * (PI * v).sin(), -0.2 * (PI * v).cos() + if v > 0.5 { 0.8 } else { 0.0 }])
}

fn bumpy(around: usize, across: usize) -> TriangleMesh {
    turned(around, across, |u, v| {
        let radius = 0.6 * (1.0 + 0.05 * (6.0 * TAU * u).sin() * (6.0 * PI * v).sin());
        [radius * (PI * v).sin(), -radius * (PI * v).cos()]
    })
}

fn icosphere(levels: usize) -> TriangleMesh {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut vertices: Vec<Point> = (0..12)
        .map(|k| {
            let (a, b) = (if k & 1 == 0 { 1.0 } else { -1.0 }, if k & 2 == 0 { golden } else { -golden });
            let mut v = [0.0; 3];
            (v[k / 4], v[(k / 4 + 1) % 3]) = (a, b);
            Point::from(Vector::from(v).normalize() * 0.6)
        })
        .collect();
    let side = 0.6 * 2.0 / (1.0 + golden * golden).sqrt();
    let near = |a: usize, b: usize, v: &[Point]| ((v[a] - v[b]).norm() - side).abs() < 1e-6;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b, &vertices) && near(b, c, &vertices) && near(c, a, &vertices) {
                    let [p, q, r] = [a, b, c].map(|i| vertices[i].coords);
                    let outward = (q - p).cross(&(r - p)).dot(&p) > 0.0;
                    triangles.push(if outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    for _ in 0..levels {
        let mut middles = std::collections::HashMap::new();
        let mut finer = Vec::new();
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[i, j]: [usize; 2]| {
                *middles.entry([i.min(j), i.max(j)]).or_insert_with(|| {
                    vertices.push(Point::from((vertices[i].coords + vertices[j].coords).normalize() * 0.6));
                    vertices.len() - 1
                })
            });
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    TriangleMesh { vertices, triangles }
}

fn random(triangles: usize, points: usize) -> TriangleMesh {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let vertices = (0..points).map(|_| Point::from(std::array::from_fn(|_| rng.random_range(-0.6..0.6)))).collect();
    let triangles = (0..triangles).map(|_| std::array::from_fn(|_| rng.random_range(0..points))).collect();
    TriangleMesh { vertices, triangles }
}

/// A closed surface that intersects itself over and over.
fn tangled(around: usize, across: usize) -> TriangleMesh {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let mut mesh = sphere(around, across);
    mesh.vertices.iter_mut().for_each(|v| *v += Vector::from_fn(|_, _| rng.random_range(-0.3..0.3)));
    mesh
}

fn holed(mut mesh: TriangleMesh) -> TriangleMesh {
    mesh.triangles.retain(|t| t[0] % 7 != 3);
    mesh
}

/// A name, and the function that makes its mesh.
type Case = (&'static str, fn() -> TriangleMesh);

const CASES: &[Case] = &[
    ("torus-4k", || torus(64, 32)),
    ("torus-48k", || torus(240, 100)),
    ("torus-500k", || torus(1000, 249)),
    ("bumpy-20k", || bumpy(142, 72)),
    ("bumpy-50k", || bumpy(224, 112)),
    ("bumpy-500k", || bumpy(708, 353)),
    ("sphere-20k", || sphere(142, 72)),
    ("sphere-500k", || sphere(708, 353)),
    ("icosphere-3", || icosphere(3)),
    ("icosphere-5", || icosphere(5)),
    ("capsule-20k", || capsule(142, 72)),
    ("random-500", || random(500, 83)),
    ("random-2000", || random(2000, 333)),
    ("random-20k", || random(20_000, 3333)),
    ("random-20k-dense", || random(20_000, 200)),
    ("tangled-20k", || tangled(142, 72)),
    ("open-torus-20k", || holed(torus(160, 63))),
    ("open-tangled-20k", || holed(tangled(142, 72))),
];

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    for (name, mesh) in CASES.iter().filter(|(name, _)| chosen.is_empty() || chosen.iter().any(|c| c == name)) {
        let TriangleMesh { vertices, triangles } = mesh();
        let count = triangles.len();
        let vertices = vertices.iter().map(|v| [v.x, v.y, v.z]).collect();
        let body = BodySpec { mesh: Some(MeshSource::Inline(MeshSpec { vertices, triangles })), ..BodySpec::default() };
        let body = BodySpec { position: Some([5.0; 3]), ..body };
        let text = serde_json::to_string(&paper_scene(name, vec![body])).expect("JSON");
        let started = Instant::now();
        let loaded = scene_from_text(&text, Notation::Json, None);
        let seconds = started.elapsed().as_secs_f64();
        match loaded {
            Ok(scene) => {
                let parts = &scene.obstacles()[0].parts;
                let corners = parts.iter().map(|p| p.vertices().len());
                let (sum, most) = (corners.clone().sum::<usize>(), corners.max().unwrap_or(0));
                println!(
                    "{name}: {count} triangles, {seconds:.2} s, {} parts, {sum} corners, at most {most} a part; {:?}",
                    parts.len(),
                    scene.notes()
                );
            }
            Err(error) => println!("{name}: {count} triangles, {seconds:.2} s, refused: {error}"),
        }
    }
}
