//! Time to compile a scene for the cspace engine, in full and after one obstacle moved, and to compute the polyhedra
//! for string pulling; prints the memory used.

use cdpr_benches::{hall, random_scene, scattered_scene, scattered_with_clearance, with_ropes};
use cdpr_core::Scene;
use cdpr_core::collision::{Checker, CspaceEngine, Interference};
use cdpr_core::watch::Watch;
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};

fn compiled(scene: &Scene) -> CspaceEngine {
    CspaceEngine::new(scene, Interference::Exact).expect("no wrench")
}

/// A scene with its first obstacle moved by a centimetre.
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
        let roped = with_ropes(&scene);
        group.bench_function(format!("whole, ropes, {count}"), |b| b.iter(|| compiled(&roped)));
        group.bench_function(format!("one obstacle moved, {count}"), |b| {
            b.iter(|| engine.recompiled(&moved, &Watch::NONE).expect("no wrench"))
        });
    }
    let halls = [300, 1000].map(|count| (format!("hall of {count}"), hall(count, 0.0, 1), hall(count, 0.02, 1)));
    let scattered = ("1000 scattered".to_string(), scattered_scene(1000, 1), scattered_with_clearance(1000, 1, 0.02));
    for (name, plain, with_clearance) in halls.into_iter().chain([scattered]) {
        for (scene, clearance) in [(plain, "no"), (with_clearance, "2 cm")] {
            let engine = compiled(&scene);
            let label = format!("{name}, {clearance} clearance");
            eprintln!("{label}: {:.1} kB", engine.bytes() as f64 * 1e-3);
            group.bench_function(format!("whole, {label}"), |b| b.iter(|| compiled(&scene)));
            group.bench_function(format!("polyhedra, {label}"), |b| {
                let polyhedra = |engine: CspaceEngine| engine.pieces(&Watch::NONE).map(|pieces| (engine, pieces));
                b.iter_batched(|| compiled(&scene), polyhedra, BatchSize::LargeInput)
            });
        }
    }
    group.finish();
}

criterion_group!(benches, compile);
criterion_main!(benches);
