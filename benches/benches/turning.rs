//! Checks of motions with a turn: 0.1 m and 5°, valid, each a different one; by the proof, and by sampling poses every 1 mm or
//! 0.25°, whichever is finer, with the same measurements.

use std::hint::black_box;
use std::path::Path;

use cdpr_core::Scene;
use cdpr_core::collision::Validity;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Placed, Pose, Rotation, Vector};
use cdpr_core::model::SceneSpec;
use cdpr_core::planning::{StateSpace, TranslationSpace};
use cdpr_core::watch::Watch;
use cdpr_files::load_scene;
use criterion::{Criterion, criterion_group, criterion_main};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const LENGTH: f64 = 0.1;
const ANGLE: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Poses on each motion when it is sampled.
const SAMPLES: usize = 100;

fn scene(name: &str) -> Scene {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/scenes").join(name).with_extension("toml");
    load_scene(&file).expect("a sound scene")
}

fn compiled(scene: &Scene) -> CompiledScene {
    CompiledScene::new(scene, Default::default(), Default::default(), &Watch::NONE).expect("a sound scene")
}

fn without_wrench(scene: &Scene) -> Scene {
    Scene::new(SceneSpec { wrench: None, ..scene.spec().clone() }).expect("a sound scene")
}

/// Valid motions, the same each time.
fn motions(engine: &CompiledScene, count: usize) -> Vec<[Pose; 2]> {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let space = TranslationSpace::of(engine.conditions());
    let mut found = Vec::new();
    while found.len() < count {
        let direction = |rng: &mut ChaCha8Rng| Vector::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
        let Some(position) = space.sample(&mut rng) else { continue };
        let first = Rotation::from_scaled_axis(direction(&mut rng) * rng.random_range(0.0..0.2));
        let from = Pose::new(position, first * engine.scene().orientation());
        let turn = Rotation::from_scaled_axis(direction(&mut rng) * ANGLE);
        let to = Pose::new(position + direction(&mut rng) * LENGTH, turn * from.orientation);
        if engine.motion_valid(&from, &to) {
            found.push([from, to]);
        }
    }
    found
}

/// Whether all of a number of poses along a motion keep all conditions.
fn sampled(engine: &CompiledScene, [from, to]: &[Pose; 2]) -> bool {
    let (motion, conditions) = (from.toward(to), engine.conditions());
    (0..=SAMPLES).all(|k| {
        let at = Placed::new(&motion.at(k as f64 / SAMPLES as f64), engine.scene().orientation());
        conditions.list.iter().all(|condition| condition.details().slack_at(&conditions.bodies, &at) >= 0.0)
    })
}

fn turning(c: &mut Criterion) {
    let mut group = c.benchmark_group("turning");
    for name in ["hard1", "hard3", "cogiro", "forest"] {
        let engine = compiled(&without_wrench(&scene(name)));
        let motions = motions(&engine, 1000);
        let mut next = motions.iter().cycle();
        group.bench_function(format!("{name}, proved"), |b| {
            b.iter(|| {
                let [from, to] = next.next().expect("endless");
                assert!(black_box(engine.motion_valid(from, to)));
            });
        });
        if name != "forest" {
            let mut next = motions.iter().cycle();
            group.sample_size(10);
            group.bench_function(format!("{name}, sampled"), |b| {
                b.iter(|| black_box(sampled(&engine, next.next().expect("endless"))));
            });
            group.sample_size(100);
        }
    }
    let engine = compiled(&scene("cogiro"));
    let motions = motions(&engine, 200);
    let mut next = motions.iter().cycle();
    group.bench_function("cogiro, proved with wrenches", |b| {
        b.iter(|| {
            let [from, to] = next.next().expect("endless");
            assert!(black_box(engine.motion_valid(from, to)));
        });
    });
    group.finish();
}

criterion_group!(benches, turning);
criterion_main!(benches);
