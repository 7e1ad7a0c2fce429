//! Shared by tests: random bodies and cables, including degenerate ones, and slow exact oracles.

#![allow(missing_docs)]

pub mod cases;
pub mod halls;
pub mod meshes;
pub mod motions;
pub mod scenes;

use std::path::Path;
use std::sync::Mutex;

use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Polytope, Rotation, TriangleMesh, Vector};
use cdpr_core::model::spec::CableDefaultsSpec;
use cdpr_core::model::{BodySpec, CableSpec, PulleySpec, Robot, RobotSource, RobotSpec, Scene};
use cdpr_core::plan::Observer;
use cdpr_core::watch::Watch;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// How many times as many cases the oracles judge: `CDPR_VERIFY`, or 1. `make long-test` and `make verify` set it.
pub fn effort() -> u64 {
    std::env::var("CDPR_VERIFY").map_or(1, |n| n.parse().expect("CDPR_VERIFY is a number"))
}

/// A scene of `testdata/scenes`, by the name of its file.
pub fn built_scene(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/scenes").join(name).with_extension("toml");
    cdpr_files::load_scene(&path).expect("a sound scene")
}

/// A robot of `testdata/robots`, by the name of its file.
pub fn built_robot(name: &str) -> Robot {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/robots").join(name).with_extension("toml");
    cdpr_files::load_robot(&path).expect("a sound robot")
}

/// A scene in which all cables run over pulleys of this radius, m, whose cables arrive from below.
pub fn with_pulleys(scene: &Scene, radius: f64) -> Scene {
    let mut spec = scene.spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
    let pulley = Some(PulleySpec { radius, axis: [0.0, 0.0, 1.0] });
    robot.cable = Some(CableDefaultsSpec { pulley, ..robot.cable.clone().unwrap_or_default() });
    Scene::new(spec).expect("cables can leave their pulleys")
}

/// Keeps every better path that a planner reports: seconds, length and waypoints.
#[derive(Default)]
pub struct Improvements(Mutex<Vec<(f64, f64, Vec<Point>)>>);

impl Improvements {
    pub fn reported(self) -> Vec<(f64, f64, Vec<Point>)> {
        self.0.into_inner().unwrap()
    }
}

impl Observer for Improvements {
    fn improved(&self, seconds: f64, cost: f64, path: &[Point]) {
        self.0.lock().unwrap().push((seconds, cost, path.to_vec()));
    }
}

/// A robot from its outlets, attachments and tensions; the platform is a point.
pub fn point_robot(cables: &[([f64; 3], [f64; 3], [f64; 2])], mass: f64) -> Robot {
    let cable = |(outlet, attachment, tension): &([f64; 3], [f64; 3], [f64; 2])| CableSpec {
        outlet: *outlet,
        attachment: *attachment,
        tension: Some(*tension),
        ..CableSpec::default()
    };
    let platform = vec![BodySpec { vertices: Some(vec![[0.0, 0.0, -9.0]]), ..BodySpec::default() }];
    let cables = cables.iter().map(cable).collect();
    Robot::try_from(RobotSpec {
        version: None,
        name: None,
        mass: Some(mass),
        center_of_mass: None,
        inertia: None,
        platform,
        cables,
        cable: None,
        tension_distribution: None,
    })
    .expect("a sound robot")
}

pub fn rng(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

pub fn uniform(rng: &mut impl Rng, lo: f64, hi: f64) -> f64 {
    lo + (hi - lo) * rng.random::<f64>()
}

pub fn vector(rng: &mut impl Rng, half: f64) -> Vector {
    Vector::from_fn(|_, _| uniform(rng, -half, half))
}

pub fn direction(rng: &mut impl Rng) -> Vector {
    loop {
        let v = vector(rng, 1.0);
        if v.norm() > 0.1 && v.norm() < 1.0 {
            return v.normalize();
        }
    }
}

/// Whether a closed surface encloses a point: its triangles cover the whole sphere of directions around it (solid
/// angles after A. van Oosterom and J. Strackee, 1983).
pub fn encloses(mesh: &TriangleMesh, p: &Point) -> bool {
    let angle = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|i| mesh.vertices[i] - p);
        let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
        let below = la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb;
        2.0 * a.dot(&b.cross(&c)).atan2(below)
    };
    mesh.triangles.iter().map(angle).sum::<f64>() > 2.0 * std::f64::consts::PI
}

pub fn rotation(rng: &mut impl Rng) -> Rotation {
    Rotation::from_scaled_axis(direction(rng) * uniform(rng, 0.0, std::f64::consts::PI))
}

/// A convex body with volume around the origin: boxes, prisms, hulls of points, slabs, needles, some of them rotated.
pub fn body(rng: &mut impl Rng) -> Polytope {
    let raw = match rng.random_range(0..5) {
        0 => Polytope::cuboid(std::array::from_fn(|_| uniform(rng, 0.05, 0.6))).unwrap(),
        1 => Polytope::cuboid([uniform(rng, 0.001, 0.01), uniform(rng, 0.1, 0.6), uniform(rng, 0.1, 2.0)]).unwrap(),
        2 => prism(rng),
        3 => {
            let count = rng.random_range(4..16);
            let points: Vec<Point> = (0..count).map(|_| Point::from(direction(rng) * uniform(rng, 0.2, 0.5))).collect();
            Polytope::hull_of(&points).unwrap()
        }
        _ => Polytope::cuboid([uniform(rng, 0.002, 0.02), uniform(rng, 0.002, 0.02), uniform(rng, 0.5, 1.5)]).unwrap(),
    };
    if rng.random_bool(0.3) { raw } else { raw.transformed(&rotation(rng), &Vector::zeros()) }
}

fn prism(rng: &mut impl Rng) -> Polytope {
    let (count, radius, half) = (rng.random_range(3..9), uniform(rng, 0.05, 0.3), uniform(rng, 0.05, 0.7));
    let corner = |k: usize, z: f64| {
        let angle = std::f64::consts::TAU * k as f64 / count as f64;
        Point::new(radius * angle.cos(), radius * angle.sin(), z)
    };
    let points: Vec<Point> = (0..count).flat_map(|k| [corner(k, -half), corner(k, half)]).collect();
    Polytope::hull_of(&points).unwrap()
}

/// The part of a convex polygon where every facet's height is at most `margin`; empty if there is none.
///
/// An exact test, independent of GJK and of separating axes: with `margin = -t`, a non-empty rest proves that the
/// polygon is deeper than t inside the body; with `margin = t`, an empty rest proves a gap larger than t.
pub fn clipped(polygon: &[Point], body: &Polytope, margin: f64) -> Vec<Point> {
    let mut polygon = polygon.to_vec();
    for facet in body.facets() {
        let mut kept = Vec::new();
        for (k, p) in polygon.iter().enumerate() {
            let q = polygon[(k + 1) % polygon.len()];
            let (hp, hq) = (facet.height(p) - margin, facet.height(&q) - margin);
            if hp <= 0.0 {
                kept.push(*p);
            }
            if (hp < 0.0 && hq > 0.0) || (hp > 0.0 && hq < 0.0) {
                kept.push(p + (q - p) * (hp / (hp - hq)));
            }
        }
        polygon = kept;
        if polygon.is_empty() {
            break;
        }
    }
    polygon
}

/// A random point on the surface of a body: inside a facet, on an edge or at a corner.
pub fn surface_point(rng: &mut impl Rng, body: &Polytope) -> Point {
    let facet = &body.facets()[rng.random_range(0..body.facets().len())];
    let corner = |k: usize| body.vertices()[facet.corners[k % facet.corners.len()]];
    let k = rng.random_range(0..facet.corners.len());
    match rng.random_range(0..3) {
        0 => corner(k),
        1 => corner(k) + (corner(k + 1) - corner(k)) * uniform(rng, 0.0, 1.0),
        _ => {
            let (u, v) = (uniform(rng, 0.0, 0.5), uniform(rng, 0.0, 0.5));
            corner(0) + (corner(1) - corner(0)) * u + (corner(2) - corner(0)) * v
        }
    }
}

/// A cable's triangle near a body: random, thin, tiny, zero-length, or touching the surface nearly parallel to a facet.
pub fn triangle(rng: &mut impl Rng, body: &Polytope) -> [Point; 3] {
    let width = 10f64.powf(uniform(rng, -9.0, 0.3));
    let outlet = Point::from(direction(rng) * uniform(rng, 0.8, 4.0));
    if rng.random_bool(0.4) {
        let from = Point::from(vector(rng, 1.0));
        let to = if rng.random_bool(0.1) { from } else { from + direction(rng) * width };
        return [outlet, from, to];
    }
    // Through a point at a given tiny height above the surface, along a facet or slightly tilted.
    let facet = &body.facets()[rng.random_range(0..body.facets().len())];
    let height = match rng.random_range(0..4) {
        0 => 0.0,
        _ => 10f64.powf(uniform(rng, -10.0, -2.0)) * if rng.random_bool(0.5) { 1.0 } else { -1.0 },
    };
    let anchor = surface_point(rng, body) + facet.normal * height;
    let tilt = if rng.random_bool(0.3) { 0.0 } else { 10f64.powf(uniform(rng, -9.0, 0.0)) };
    let mut along = direction(rng);
    along -= facet.normal * facet.normal.dot(&along) * (1.0 - tilt);
    let along = along.normalize();
    let sideways = if rng.random_bool(0.5) { facet.normal.cross(&along) } else { direction(rng) };
    let from = anchor - along * uniform(rng, 0.0, 1.5);
    let to = from + sideways * if rng.random_bool(0.1) { 0.0 } else { width };
    [anchor + along * uniform(rng, 0.5, 3.0), from, to]
}

/// A scene compiled for the default engine.
pub fn compiled(scene: &Scene) -> CompiledScene {
    CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).expect("a sound scene")
}

/// Tests the program of docs/rust.md.
#[cfg(doctest)]
#[doc = include_str!("../../docs/rust.md")]
struct RustFromNothing;
