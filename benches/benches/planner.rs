//! Time of Modified RRT with rewinding on the paper's kind of scenes, over many seeds.

use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::testing;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

fn modified_rrt(c: &mut Criterion) {
    let mut group = c.benchmark_group("modified RRT with rewinding, gjk");
    group.sample_size(10);
    for (scene, seeds) in [(testing::hard1(), 200u64), (testing::hard3(), 20)] {
        group.throughput(Throughput::Elements(seeds));
        group.bench_function(scene.name(), |b| {
            b.iter(|| {
                let cost = |seed| {
                    plan(&scene, &PlanOptions { seed, ..PlanOptions::default() }, &|| false).expect("sound").cost
                };
                (0..seeds).map(cost).sum::<f64>()
            });
        });
    }
    group.finish();
}

criterion_group!(benches, modified_rrt);
criterion_main!(benches);
