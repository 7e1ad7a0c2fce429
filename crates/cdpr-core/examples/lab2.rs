#![allow(missing_docs)]
use cdpr_core::batch::*;
use cdpr_core::collision::{Checker, CspaceEngine, Interference, Validity};
use cdpr_core::planning::*;
use cdpr_core::postprocess::taut::*;
use rand::SeedableRng;
use rayon::prelude::*;
use std::time::Instant;
fn main() {
    for count in [3usize, 6, 10, 20] {
        let spec: RandomScenesSpec = serde_json::from_str(&format!(r#"{{"count": {count}, "redraw_straight": true}}"#)).unwrap();
        let scenes = RandomScenes::new(cdpr_core::testing::empty(), spec).unwrap();
        let rows: Vec<String> = (0..40u64).into_par_iter().map(|s| {
            let scene = scenes.draw(s + 1000).unwrap();
            let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
            let space = TranslationSpace::of(engine.constraints());
            let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
            let t0 = Instant::now(); let taut = Taut::new(&engine); println!("taut new {:.3} ms", t0.elapsed().as_secs_f64()*1e3);
            let mut costs = vec![];
            let (mut tp, mut ts) = (0.0, 0.0);
            let n = 100;
            for seed in 0..n {
                let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
                let t = Instant::now();
                let o = modified_rrt(&problem, &engine, &ModifiedRrtOptions { limits: Limits::samples(3000) }, &mut rng, &Watch::NONE).unwrap();
                tp += t.elapsed().as_secs_f64();
                if o.waypoints.is_empty() { if seed > 3 && costs.is_empty() { break } ; continue; }
                let t = Instant::now();
                let bends = taut.shortened(&o.waypoints, &Watch::NONE).unwrap();
                ts += t.elapsed().as_secs_f64();
                let c: f64 = bends.windows(2).map(|p| (p[1] - p[0]).norm()).sum();
                assert!(bends.windows(2).all(|p| engine.motion_valid(&p[0], &p[1])));
                costs.push(c);
            }
            if costs.is_empty() { return format!("{count} {s}: none  {tp:.2} s"); }
            costs.sort_by(|a, b| a.total_cmp(b));
            let best = costs[0];
            let within = |f: f64| costs.iter().filter(|c| **c <= best * f).count() as f64 / costs.len() as f64;
            let mut distinct = costs.clone();
            distinct.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
            format!("{count} {s}: best {best:.5} worst {:.5}  0.01% {:.2} 0.1% {:.2} 1% {:.2} of {} distinct {}  plan {:.3} ms taut {:.3} ms", costs[costs.len()-1], within(1.0001), within(1.001), within(1.01), costs.len(), distinct.len(), tp / n as f64 * 1e3, ts / n as f64 * 1e3)
        }).collect();
        for r in rows { println!("{r}"); }
    }
}
