//! Time to compile a scene for the cspace engine, whole and after one obstacle moved; prints the memory it takes.

use cdpr_benches::{random_scene, scattered_scene};
use cdpr_core::Scene;
use cdpr_core::collision::{CspaceEngine, Interference};
use criterion::{Criterion, criterion_group, criterion_main};

fn compiled(scene: &Scene) -> CspaceEngine {
    CspaceEngine::new(scene, Interference::Exact).expect("no wrench")
}

/// The same scene with its first obstacle a centimetre aside.
fn one_moved(scene: &Scene) -> Scene {
    let mut spec = scene.spec().clone();
    spec.obstacles[0].position.as_mut().expect("blocks have positions")[0] += 0.01;
    Scene::new(spec).expect("sound")
}

fn compile(c: &mut Criterion) {
    let mut group = c.benchmark_group("compile");
    group.sample_size(20);
    let prisms = [1, 3, 10, 100].map(|count| random_scene(count, 1, false));
    for scene in prisms.into_iter().chain([scattered_scene(1000, 1)]) {
        let count = scene.obstacles().len();
        let (engine, moved) = (compiled(&scene), one_moved(&scene));
        eprintln!("{count} obstacles: {:.1} kB", engine.bytes() as f64 * 1e-3);
        group.bench_function(format!("whole, {count}"), |b| b.iter(|| compiled(&scene)));
        group.bench_function(format!("one obstacle moved, {count}"), |b| {
            b.iter(|| engine.recompiled(&moved).expect("no wrench"))
        });
    }
    group.finish();
}

criterion_group!(benches, compile);
criterion_main!(benches);
