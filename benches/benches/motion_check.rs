//! Time of one motion check by the gjk engine: valid motions of 0.1 m in random scenes of the paper's kind.

use cdpr_benches::{random_scene, valid_motions};
use cdpr_core::collision::{GjkEngine, Interference, Validity};
use cdpr_core::geometry::Point;
use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};

const SCENES: u64 = 20;
const MOTIONS: usize = 250;

/// Engines of random scenes with `count` obstacles, each with motions that it calls valid.
fn cases(count: usize, obstacles_only: bool) -> Vec<(GjkEngine, Vec<(Point, Point)>)> {
    let case = |seed| {
        let scene = random_scene(count, seed, obstacles_only);
        let engine = GjkEngine::new(&scene, Interference::Exact).expect("no wrench");
        let motions = valid_motions(&engine, 0.1, MOTIONS, seed);
        (engine, motions)
    };
    (0..SCENES).map(case).collect()
}

fn motion_check(c: &mut Criterion) {
    let mut group = c.benchmark_group("gjk motion check");
    group.throughput(Throughput::Elements(SCENES * MOTIONS as u64));
    for (label, obstacles_only) in [("obstacles only", true), ("with self-interference", false)] {
        for count in [1, 3, 10] {
            let cases = cases(count, obstacles_only);
            group.bench_function(format!("{label}, {count} obstacles"), |b| {
                b.iter_batched(
                    || (),
                    |()| {
                        let valid = |(engine, motions): &(GjkEngine, Vec<(Point, Point)>)| {
                            motions.iter().filter(|(from, to)| engine.motion_valid(from, to)).count()
                        };
                        cases.iter().map(valid).sum::<usize>()
                    },
                    BatchSize::SmallInput,
                );
            });
        }
    }
    group.finish();
}

criterion_group!(benches, motion_check);
criterion_main!(benches);
