//! Time of one capacity margin: eight cables, 56 pairs of facets, force and moment ball; and of a map of a million.

use cdpr_core::collision::batch::BatchOptions;
use cdpr_core::geometry::{Aabb, Point};
use cdpr_core::model::Robot;
use cdpr_core::testing::paper_robot;
use cdpr_core::wrench::{CapacityMargin, Loads, MapOptions, Required, Statics, WrenchMap};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

/// The paper's cube with the attachments crossed in x and z, which gives it all six degrees of freedom; 20 kg, balls of
/// 50 N and 5 N·m.
fn crossed() -> CapacityMargin {
    let mut spec = paper_robot();
    spec.mass = Some(20.0);
    for cable in &mut spec.cables {
        let [x, y, z] = cable.attachment;
        cable.attachment = [-x, y, -z];
    }
    spec.platform[0].cuboid = None;
    spec.platform[0].vertices = Some(vec![[0.0; 3]]);
    let robot = Robot::try_from(spec).expect("a sound robot");
    let statics = Statics::new(&robot, &Loads::default()).expect("limits and mass");
    CapacityMargin::new(statics, Required::balls(50.0, 5.0).expect("radii")).expect("no point mass")
}

fn capacity_margin(c: &mut Criterion) {
    let at = |k: usize| 0.1 + 1.8 * k as f64 / 19.0;
    let positions: Vec<[Point; 4]> = (0..2000)
        .map(|n| std::array::from_fn(|k| 4 * n + k))
        .map(|n: [usize; 4]| n.map(|n| Point::new(at(n / 400), at(n / 20 % 20), at(n % 20))))
        .collect();
    let mut group = c.benchmark_group("capacity margin, 8000 positions of a grid");
    group.throughput(Throughput::Elements(8000));
    let margin = crossed();
    for (name, margin) in [("best kernel", margin.clone()), ("portable", margin.clone().portable())] {
        group.bench_function(name, |b| {
            b.iter(|| positions.iter().flat_map(|four| margin.at_four(four)).filter(|m| *m >= 0.0).count());
        });
    }
    group.sample_size(10);
    group.bench_function("by definition", |b| {
        let limits = || positions.iter().flatten().map(|p| margin.limit(p).map_or(f64::NAN, |limit| limit.margin));
        b.iter(|| limits().filter(|m| *m >= 0.0).count());
    });
    group.finish();
}

/// A map of 100 × 100 × 100 nodes in the middle of the cube, and a coarser one with the margins by definition.
fn wrench_map(c: &mut Criterion) {
    let margin = crossed();
    let within = Aabb { min: Point::new(0.1, 0.1, 0.1), max: Point::new(1.9, 1.9, 1.9) };
    let mut group = c.benchmark_group("wrench map");
    group.sample_size(10);
    for (name, intervals, projected) in [("capacity", 99, false), ("capacity, force and moment", 19, true)] {
        let options = MapOptions { step: 1.8 / f64::from(intervals), projected };
        for threads in [1, 2] {
            let batch = BatchOptions { threads: Some(threads), interrupted: &|| false };
            let map = || WrenchMap::new(margin.statics(), margin.required(), &within, &options, &batch).expect("a map");
            let nodes = map().grid().len();
            group.throughput(Throughput::Elements(nodes as u64));
            group.bench_function(format!("{name}, {nodes} nodes, {threads} threads"), |b| b.iter(map));
        }
    }
    group.finish();
}

criterion_group!(benches, capacity_margin, wrench_map);
criterion_main!(benches);
