//! Time of Modified RRT with rewinding on the paper's kind of scenes, over many seeds, by either engine.

use cdpr_core::Choice;
use cdpr_core::collision::Engine;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::testing;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

fn modified_rrt(c: &mut Criterion) {
    let mut group = c.benchmark_group("modified RRT with rewinding, scene compiled and path checked");
    group.sample_size(10);
    for (scene, seeds) in [(testing::hard1(), 200u64), (testing::hard3(), 20)] {
        for engine in [Engine::Cspace, Engine::Gjk] {
            group.throughput(Throughput::Elements(seeds));
            group.bench_function(format!("{}, {}", scene.name(), engine.name()), |b| {
                b.iter(|| {
                    let options = |seed| PlanOptions { engine, seed, ..PlanOptions::paper() };
                    (0..seeds).map(|seed| plan(&scene, &options(seed), &|| false).expect("sound").cost).sum::<f64>()
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, modified_rrt);
criterion_main!(benches);
