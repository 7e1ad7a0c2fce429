//! Time of one motion check with either engine, in random scenes like the paper's; one thread.

use std::cell::LazyCell;
use std::sync::Arc;

use cdpr_benches::{Motions, motions, random_scene, scattered_scene, with_ropes};
use cdpr_core::Scene;
use cdpr_core::collision::{Checker, CspaceEngine, Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::Point;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main, measurement::WallTime};

const SCENES: u64 = 20;
const MOTIONS: usize = 500;
const SHORT: Motions = Motions::Valid(0.1);

type Case = (Arc<dyn Checker>, Vec<(Point, Point)>);

/// Engines of random scenes, with motions to check for each.
fn cases(engine: Engine, kind: Motions, scenes: impl Fn(u64) -> Scene) -> Vec<Case> {
    let case = |seed| {
        let scene = scenes(seed);
        let prisms = scene.obstacles().len() >= 10 && scene.name() == "random";
        let drawn =
            motions(&CspaceEngine::new(&scene, Interference::Exact).expect("sound"), kind, prisms, MOTIONS, seed);
        (engine_for(&scene, engine, Interference::Exact).expect("sound"), drawn)
    };
    (0..SCENES).map(case).collect()
}

fn check_all(cases: &[Case]) -> usize {
    let valid = |(engine, motions): &Case| motions.iter().filter(|(from, to)| engine.motion_valid(from, to)).count();
    cases.iter().map(valid).sum()
}

/// The cases are compiled only if a filter selects their label.
fn measure(group: &mut BenchmarkGroup<WallTime>, label: String, cases: impl FnOnce() -> Vec<Case>) {
    let cases = LazyCell::new(cases);
    group.bench_function(label, |b| {
        let cases: &[Case] = &cases;
        b.iter(|| check_all(cases));
    });
}

fn motion_check(c: &mut Criterion) {
    let mut group = c.benchmark_group("motion check");
    group.throughput(Throughput::Elements(SCENES * MOTIONS as u64));
    for count in [1, 3, 10, 100] {
        let prisms = |only: bool| move |seed| random_scene(count, seed, only);
        measure(&mut group, format!("cspace, valid 0.1 m, {count}"), || cases(Engine::Cspace, SHORT, prisms(true)));
        measure(&mut group, format!("cspace, valid 0.1 m, self-interference, {count}"), || {
            cases(Engine::Cspace, SHORT, prisms(false))
        });
        let roped = |only: bool| move |seed| with_ropes(&random_scene(count, seed, only));
        measure(&mut group, format!("cspace, valid 0.1 m, ropes, {count}"), || {
            cases(Engine::Cspace, SHORT, roped(true))
        });
        measure(&mut group, format!("cspace, valid 0.1 m, ropes, self-interference, {count}"), || {
            cases(Engine::Cspace, SHORT, roped(false))
        });
        measure(&mut group, format!("cspace, anywhere, {count}"), || {
            cases(Engine::Cspace, Motions::Anywhere, prisms(true))
        });
    }
    let scattered = |seed| scattered_scene(1000, seed);
    measure(&mut group, "cspace, valid 0.1 m, 1000 scattered".into(), || cases(Engine::Cspace, SHORT, scattered));
    let roped = |seed| with_ropes(&scattered_scene(1000, seed));
    measure(&mut group, "cspace, valid 0.1 m, ropes, 1000 scattered".into(), || cases(Engine::Cspace, SHORT, roped));
    measure(&mut group, "cspace, anywhere, 1000 scattered".into(), || {
        cases(Engine::Cspace, Motions::Anywhere, scattered)
    });
    for count in [1, 3, 10] {
        let prisms = |only: bool| move |seed| random_scene(count, seed, only);
        measure(&mut group, format!("gjk, valid 0.1 m, {count}"), || cases(Engine::Gjk, SHORT, prisms(true)));
        measure(&mut group, format!("gjk, valid 0.1 m, self-interference, {count}"), || {
            cases(Engine::Gjk, SHORT, prisms(false))
        });
    }
    group.finish();
}

criterion_group!(benches, motion_check);
criterion_main!(benches);
