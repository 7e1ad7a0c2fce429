use cdpr_core::collision::{Checker, CspaceEngine, Interference, Validity};
use cdpr_core::planning::*;
use cdpr_core::postprocess::taut::*;
use rand::SeedableRng;
use std::time::Instant;
fn main() {
    for name in ["hard1", "hard3"] {
        let scene = cdpr_core::io::load_scene(format!("testdata/scenes/{name}.toml").as_ref()).unwrap();
        let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
        let space = TranslationSpace::of(engine.constraints());
        let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
        let t0 = Instant::now(); let taut = Taut::new(&engine); println!("taut new {:.3} ms", t0.elapsed().as_secs_f64()*1e3);
        let mut costs = vec![]; let mut shown = 0;
        let (mut tp, mut ts) = (0.0, 0.0);
        let n = 1000;
        let only: Option<u64> = std::env::var("SEED").ok().map(|s| s.parse().unwrap());
        for seed in 0..n { if only.is_some_and(|o| o != seed || name == "hard1") { costs.push((0.0, 0)); continue; }
            let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
            let t = Instant::now();
            let o = modified_rrt(&problem, &engine, &ModifiedRrtOptions::default(), &mut rng, &Watch::NONE).unwrap();
            tp += t.elapsed().as_secs_f64();
            let t = Instant::now();
            let bends = taut.shortened(&o.waypoints, &Watch::NONE).unwrap();
            ts += t.elapsed().as_secs_f64();
            let c: f64 = bends.windows(2).map(|p| (p[1] - p[0]).norm()).sum();
            assert!(bends.windows(2).all(|p| engine.motion_valid(&p[0], &p[1])));
            if name == "hard3" && c > 2.6562 && shown < 4 { shown += 1; println!("seed {seed} {c} {:?}", bends.iter().map(|b| [b.x, b.y, b.z]).collect::<Vec<_>>()); }
            if name == "hard3" && seed == 0 { println!("seed {seed} {c} {:?}", bends.iter().map(|b| [b.x, b.y, b.z]).collect::<Vec<_>>()); }
            costs.push((c, bends.len()));
        }
        costs.sort_by(|a, b| a.0.total_cmp(&b.0));
        println!("plan {:.3} ms taut {:.3} ms", tp / n as f64 * 1e3, ts / n as f64 * 1e3);
        println!("mean {:.5}", costs.iter().map(|c| c.0).sum::<f64>() / n as f64);
        for q in [0, 1, 5, 10, 50, 100, 200, 300, 400, 500, 600, 700, 800, 900, 950, 990, 999] {
            println!("  {q}: {:.7} {}", costs[q].0, costs[q].1);
        }
    }
}
