//! Scenes and motions that the benchmarks share.

use cdpr_core::Scene;
use cdpr_core::collision::{Checker, GjkEngine, Validity};
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::planning::{StateSpace, TranslationSpace};
use cdpr_core::testing::{block, paper_scene, scene};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The paper's robot among random upright prisms (the paper, Table 1): 0.1 to 0.3 m wide, 0.5 to 1.5 m high; smaller
/// ones where there are many, so that room is left. With `obstacles_only`, cables may meet each other and the platform.
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

/// Motions of a given length that the engine calls valid.
pub fn valid_motions(engine: &GjkEngine, length: f64, count: usize, seed: u64) -> Vec<(Point, Point)> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed ^ 0x5eed);
    let space = TranslationSpace::of(engine.constraints());
    let mut motions = Vec::with_capacity(count);
    while motions.len() < count {
        let from = space.sample(&mut rng).expect("the workspace has room");
        let way = Vector::from_fn(|_, _| rng.random::<f64>() - 0.5).normalize() * length;
        if engine.motion_valid(&from, &(from + way)) {
            motions.push((from, from + way));
        }
    }
    motions
}
