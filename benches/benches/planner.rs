//! Times of planners on scenes like the paper's, over many seeds: Modified RRT with rewinding on either engine, first
//! paths, the anytime planner until it stops, string pulling, the lower bound.

use std::sync::Arc;

use cdpr_benches::{Motions, motions};
use cdpr_core::Choice;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::model::{PositionSource, Scene};
use cdpr_core::plan::{PlanOptions, Post, Processing, Query, lower_bound, plan, plan_each, shorten_held};
use cdpr_core::planning::{Planner, PlannerOptions};
use cdpr_core::testing;
use cdpr_core::watch::Watch;
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
                    (0..seeds)
                        .map(|seed| plan(&scene, &options(seed), &|| false).expect("sound").result.cost)
                        .sum::<f64>()
                });
            });
        }
    }
    group.finish();
}

const SEEDS: u64 = 100;

fn compiled(scene: &Scene) -> Arc<CompiledScene> {
    CompiledScene::new(scene, Engine::Cspace, Interference::Exact, &Watch::NONE).expect("sound").into()
}

/// One call for each of many seeds, on a compiled engine.
fn planners(c: &mut Criterion) {
    let mut group = c.benchmark_group("one planner, engine compiled, no rewinding");
    group.sample_size(10).throughput(Throughput::Elements(SEEDS));
    for scene in [testing::hard1(), testing::hard3()] {
        let engine = compiled(&scene);
        for planner in [Planner::TwoTrees, Planner::RrtConnect, Planner::ModifiedRrt, Planner::Anytime] {
            let planner = PlannerOptions::of(planner);
            group.bench_function(format!("{}, {}", scene.name(), planner.planner().name()), |b| {
                b.iter(|| {
                    let ask = |seed| {
                        let post = Some(Post::None);
                        let options = PlanOptions { planner: planner.clone(), seed, post, ..PlanOptions::default() };
                        plan(Query::of(&scene).by(&engine), &options, &()).expect("sound").result.cost
                    };
                    (0..SEEDS).map(ask).sum::<f64>()
                });
            });
        }
    }
    group.finish();
}

/// Paths between random valid positions, each proved to be free, in one compiled scene on all cores.
fn many(c: &mut Criterion) {
    const QUERIES: usize = 500;
    let mut group = c.benchmark_group("plan_each, two-trees, engine compiled");
    group.sample_size(10).throughput(Throughput::Elements(QUERIES as u64));
    for scene in [testing::hard1(), testing::hard3()] {
        let engine = compiled(&scene);
        let ends: Vec<[PositionSource; 2]> = motions(engine.level(), Motions::Anywhere, false, QUERIES, 0)
            .into_iter()
            .map(|(start, goal)| [start.into(), goal.into()])
            .collect();
        let options = PlanOptions { planner: PlannerOptions::of(Planner::TwoTrees), ..PlanOptions::default() };
        let query = Query::of(&scene).by(&engine);
        group.bench_function(scene.name(), |b| {
            b.iter(|| {
                plan_each(&query, &ends, &options, None, &|| false, &|_, _| (), &|_, planned| Ok(planned.result.cost))
                    .expect("sound")
            });
        });
    }
    group.finish();
}

/// The paper's rewound paths, pulled taut.
fn refine(c: &mut Criterion) {
    let mut group = c.benchmark_group("refine the paper's result, engine compiled");
    group.sample_size(10).throughput(Throughput::Elements(SEEDS));
    for scene in [testing::hard1(), testing::hard3()] {
        let engine = compiled(&scene);
        let paper = |seed| {
            plan(Query::of(&scene).by(&engine), &PlanOptions { seed, ..PlanOptions::paper() }, &())
                .expect("sound")
                .result
                .waypoints()
        };
        let paths: Vec<_> = (0..SEEDS).map(paper).collect();
        group.bench_function(scene.name(), |b| {
            b.iter(|| {
                let taut = |path: &Vec<_>| {
                    shorten_held(engine.level(), path, &Processing::StringPulling, &Watch::NONE).expect("valid").len()
                };
                paths.iter().map(taut).sum::<usize>()
            });
        });
    }
    group.finish();
}

fn bounds(c: &mut Criterion) {
    let mut group = c.benchmark_group("lower bound");
    group.sample_size(10);
    for scene in [testing::hard1(), testing::hard3()] {
        let engine = compiled(&scene);
        let (start, goal) = (scene.start().expect("given"), scene.goal().expect("given"));
        group.bench_function(scene.name(), |b| {
            b.iter(|| lower_bound(engine.level(), &start, &goal, &Watch::NONE).expect("not stopped"))
        });
    }
    group.finish();
}

criterion_group!(benches, modified_rrt, planners, many, refine, bounds);
criterion_main!(benches);
