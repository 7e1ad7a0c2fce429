//! Time of a trajectory: the whole of it from the path, and the timing along the curve alone, 1000 intervals.

use std::path::Path;

use cdpr_core::compiled::CompiledScene;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::trajectory::Trajectory;
use cdpr_core::watch::Watch;
use cdpr_files::load_scene;
use criterion::{Criterion, criterion_group, criterion_main};

const LIMITS: MotionSpec = MotionSpec {
    speed: Some(1.0),
    acceleration: Some(2.0),
    jerk: None,
    cable_speed: Some(1.0),
    cable_acceleration: Some(4.0),
    turn_speed: None,
    turn_acceleration: None,
    blend: Some(0.03),
    clearance: None,
    wrench_margin: None,
};

fn trajectories(c: &mut Criterion) {
    let mut group = c.benchmark_group("trajectory");
    for name in ["hard3", "cogiro"] {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/scenes").join(name).with_extension("toml");
        let scene = load_scene(&file).expect("a sound scene");
        let planned = plan(&scene, &PlanOptions::default(), &()).expect("a sound query");
        let (scene, path) = (planned.scene, planned.result.path);
        let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE);
        let compiled = compiled.expect("a sound scene");
        for (kind, jerk) in [("", None), (", limited jerk", Some(40.0))] {
            let limits = MotionSpec { jerk, ..LIMITS };
            let motion = || Trajectory::new(&compiled, &path, &limits, &Watch::NONE).expect("possible limits");
            group.bench_function(format!("{name}{kind}, from the path"), |b| b.iter(motion));
            let found = motion();
            group.bench_function(format!("{name}{kind}, timing"), |b| {
                b.iter(|| {
                    let (curve, corners, winches) = (found.curve(), found.corners(), found.winches());
                    let (curve, corners) = (curve.clone(), corners.to_vec());
                    Trajectory::along(curve, corners, *found.limits(), winches.clone(), &Watch::NONE)
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, trajectories);
criterion_main!(benches);
