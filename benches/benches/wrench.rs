//! Time of one capacity margin: eight cables, 56 pairs of facets, force and moment ball; and of a map of a million.

use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use cdpr_core::batch::BatchOptions;
use cdpr_core::geometry::{Aabb, Point, Vector};
use cdpr_core::model::Robot;
use cdpr_core::model::spec::PulleySpec;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::testing::paper_robot;
use cdpr_core::wrench::{CapacityMargin, Loads, MapOptions, Measure, Required, Statics, WrenchMap, certified};
use cdpr_files::{load_robot, load_scene};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

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
            let batch = BatchOptions { threads: Some(threads), ..BatchOptions::default() };
            let map = || WrenchMap::new(margin.statics(), margin.required(), &within, &options, &batch).expect("a map");
            let nodes = map().grid().len();
            group.throughput(Throughput::Elements(nodes as u64));
            group.bench_function(format!("{name}, {nodes} nodes, {threads} threads"), |b| b.iter(map));
        }
    }
    group.finish();
}

/// Certified motions of 0.1 m from feasible positions of existing robots: the accepted ones, and all.
fn certified_motions(c: &mut Criterion) {
    let mut group = c.benchmark_group("certified motion of 0.1 m");
    let hall = [[-7.0, 7.0], [-5.0, 5.0], [0.0, 5.0]];
    for (name, robot, pulleys, [force, moment], within) in [
        ("cogiro", "cogiro", None, [50.0, 5.0], hall),
        ("cogiro over pulleys", "cogiro", Some(0.03), [50.0, 5.0], hall),
        ("acrobot", "acrobot", None, [0.5, 0.05], [[0.0, 1.0]; 3]),
    ] {
        let measure = built(robot, pulleys, [force, moment]);
        let motions = motions_from_feasible(&measure, &within, 2000);
        group.throughput(Throughput::Elements(motions.len() as u64));
        group.bench_function(format!("{name}, mean"), |b| {
            b.iter(|| motions.iter().filter(|(from, to)| certified(&measure, from, to)).count());
        });
        let (from, to) = median(&measure, motions);
        group.throughput(Throughput::Elements(1));
        group.bench_function(format!("{name}, the median motion"), |b| b.iter(|| certified(&measure, &from, &to)));
    }
    group.finish();
}

/// An existing robot, with pulleys of this radius whose cables arrive from below.
fn built(name: &str, pulleys: Option<f64>, [force, moment]: [f64; 2]) -> Measure {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/robots").join(name).with_extension("toml");
    let mut spec = load_robot(&path).expect("a sound robot").spec().clone();
    for cable in &mut spec.cables {
        cable.pulley = pulleys.map(|radius| PulleySpec { radius, axis: [0.0, 0.0, 1.0] });
    }
    let robot = Robot::try_from(spec).expect("a sound robot");
    let statics = Statics::new(&robot, &Loads::default()).expect("limits and mass");
    let required = Required::balls(force, moment).expect("radii");
    Measure::Capacity(Box::new(CapacityMargin::new(statics, required).expect("no point mass")))
}

fn motions_from_feasible(measure: &Measure, within: &[[f64; 2]; 3], count: usize) -> Vec<(Point, Point)> {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut motions = Vec::new();
    while motions.len() < count {
        let from = Point::from(within.map(|[low, high]| rng.random_range(low..high)));
        let way = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0));
        if measure.slack(&from) >= 0.0 {
            motions.push((from, from + way.normalize() * 0.1));
        }
    }
    motions
}

/// The accepted motion with the median time.
fn median(measure: &Measure, mut motions: Vec<(Point, Point)>) -> (Point, Point) {
    motions.retain(|(from, to)| certified(measure, from, to));
    motions.sort_by_cached_key(|(from, to)| {
        let clock = Instant::now();
        (0..5).for_each(|_| assert!(black_box(certified(measure, from, to))));
        clock.elapsed()
    });
    motions[motions.len() / 2]
}

/// Planning on CoGiRo in its hall, certified: includes compiling, planning, rewinding, checking.
fn planning(c: &mut Criterion) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/scenes/cogiro.toml");
    let scene = load_scene(&path).expect("a sound scene");
    let mut group = c.benchmark_group("planning with wrenches, certified");
    group.sample_size(10);
    group.throughput(Throughput::Elements(50));
    group.bench_function("cogiro, 50 seeds", |b| {
        b.iter(|| {
            let options = |seed| PlanOptions { seed, ..PlanOptions::paper() };
            (0..50).map(|seed| plan(&scene, &options(seed), &|| false).expect("sound").result.cost).sum::<f64>()
        });
    });
    group.finish();
}

criterion_group!(benches, capacity_margin, wrench_map, certified_motions, planning);
criterion_main!(benches);
