//! Scenes and motions shared by the benchmarks.

use std::path::Path;

use cdpr_core::Scene;
use cdpr_core::collision::Checker;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::model::{CableDefaultsSpec, PulleySpec, RobotSource};
use cdpr_core::planning::{StateSpace, TranslationSpace};
use cdpr_core::testing::{block, paper_scene, scene};
use cdpr_study::{RandomScenes, RandomScenesSpec};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The paper's robot among random upright prisms (the paper, Table 1): 0.1 to 0.3 m wide, 0.5 to 1.5 m high; if there
/// are many, they are smaller, so that free space is left. With `obstacles_only`, cables may meet each other and the
/// platform.
pub fn random_scene(count: usize, seed: u64, obstacles_only: bool) -> Scene {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let shrink = if count >= 10 { [0.15, 0.3] } else { [1.0, 1.0] };
    let prism = |k: usize| {
        let width = shrink[0] * (0.1 + 0.2 * rng.random::<f64>());
        let height = shrink[1] * (0.5 + rng.random::<f64>());
        let place = |u: f64| 0.5 * width + (2.0 - width) * u;
        block(&format!("prism {k}"), [width, width, height], [place(rng.random()), place(rng.random()), 0.5 * height])
    };
    let mut spec = paper_scene("random", (0..count).map(prism).collect());
    if obstacles_only {
        let name = |k: usize| format!("cable {k}");
        let pairs = (0..8).flat_map(|i| (i + 1..8).map(move |j| [name(i), name(j)]));
        spec.ignore = pairs.chain((0..8).map(|i| [name(i), "platform".to_string()])).collect();
    }
    scene(spec)
}

/// The paper's robot among `count` small boxes anywhere in its hall, 5 to 15 mm wide.
pub fn scattered_scene(count: usize, seed: u64) -> Scene {
    scattered_with_clearance(count, seed, 0.0)
}

/// Scattered obstacles as in [`scattered_scene`], with a required clearance, m.
pub fn scattered_with_clearance(count: usize, seed: u64, clearance: f64) -> Scene {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut number = |low: f64, high: f64| low + (high - low) * rng.random::<f64>();
    let crumb = |k: usize| {
        let sides = std::array::from_fn(|_| number(0.005, 0.015));
        block(&format!("crumb {k}"), sides, std::array::from_fn(|_| number(0.02, 1.98)))
    };
    let mut spec = paper_scene("scattered", (0..count).map(crumb).collect());
    spec.clearance = Some(clearance);
    scene(spec)
}

/// The scene with ropes of 6 g/m at 20 N or more, over pulleys of 20 mm.
pub fn with_ropes(scene: &Scene) -> Scene {
    let mut spec = scene.spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
    robot.cable = Some(CableDefaultsSpec {
        linear_density: Some(0.006),
        sag_tension: Some(20.0),
        pulley: Some(PulleySpec { radius: 0.02, axis: [0.0, 0.0, 1.0] }),
        ..CableDefaultsSpec::default()
    });
    Scene::new(spec).expect("a sound scene")
}

/// How motions for a benchmark are drawn.
#[derive(Debug, Clone, Copy)]
pub enum Motions {
    /// Valid, of this length, m, in a random direction.
    Valid(f64),
    /// Between random valid states, valid or not.
    Anywhere,
}

/// Motions that start in valid states; if there are many obstacles, they are on the floor and motions stay above 0.8 m,
/// so that enough of them are valid.
pub fn motions(engine: &dyn Checker, kind: Motions, above_floor: bool, count: usize, seed: u64) -> Vec<(Point, Point)> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed ^ 0x5eed);
    let space = TranslationSpace::of(engine.conditions());
    let mut state = || loop {
        let mut state = space.sample(&mut rng).expect("the workspace has room");
        if above_floor {
            state.z = 0.8 + 1.1 * rng.random::<f64>();
        }
        if engine.state_valid(&state) {
            let way = Vector::from_fn(|_, _| rng.random::<f64>() - 0.5).normalize();
            return (state, way);
        }
    };
    let mut motions = Vec::with_capacity(count);
    while motions.len() < count {
        let (from, way) = state();
        match kind {
            Motions::Anywhere => motions.push((from, state().0)),
            Motions::Valid(length) if engine.motion_valid(&from, &(from + way * length)) => {
                motions.push((from, from + way * length));
            }
            Motions::Valid(_) => {}
        }
    }
    motions
}

/// A hall of 12 × 8 × 6 m with a half-size CoGiRo among `count` floating boxes that together occlude the same share of
/// the outlets' view for any number; the straight line from start to goal is not free.
pub fn hall(count: usize, clearance: f64, seed: u64) -> Scene {
    let forest =
        cdpr_files::load_scene(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../testdata/scenes/forest.toml")));
    let mut base = forest.expect("a sound scene").spec().clone();
    (base.obstacles, base.clearance) = (Vec::new(), Some(clearance));
    let side = (2.0 / count as f64).sqrt();
    let boxes = serde_json::json!({
        "count": count, "width": [0.5 * side, side], "depth": [0.5 * side, side], "height": [0.5 * side, side],
        "floating": true, "turned": true, "redraw_straight": true,
    });
    let boxes: RandomScenesSpec = serde_json::from_value(boxes).expect("sound boxes");
    RandomScenes::new(scene(base), boxes).and_then(|halls| halls.draw(seed)).expect("a hall")
}
