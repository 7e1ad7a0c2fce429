#![allow(missing_docs)]
use cdpr_core::batch::*;
use cdpr_core::collision::{Checker, CspaceEngine, Interference, Validity};
use cdpr_core::geometry::Point;
use cdpr_core::planning::*;
use rand::{RngExt, SeedableRng};
use std::time::Instant;

struct T { p: Vec<Point>, parent: Vec<usize> }
fn nearest(t: &T, x: &Point) -> usize {
    let mut best = (f64::INFINITY, 0);
    for (i, p) in t.p.iter().enumerate() { let d = (p - x).norm_squared(); if d < best.0 { best = (d, i); } }
    best.1
}
fn classic(problem: &Problem<TranslationSpace>, v: &dyn Validity, step: f64, greedy: bool, seed: u64) -> (bool, usize, usize) {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let mut trees = [T { p: vec![problem.start], parent: vec![0] }, T { p: vec![problem.goal], parent: vec![0] }];
    let mut checks = 0;
    let mut a = 0;
    if v.motion_valid(&problem.start, &problem.goal) { return (true, 0, 1); }
    for it in 0..50000 {
        let x = problem.space.sample(&mut rng).unwrap();
        // extend a
        let grow = |t: &mut T, x: &Point, greedy: bool, checks: &mut usize| -> Option<Point> {
            let mut n = nearest(t, x);
            let mut last = None;
            loop {
                let from = t.p[n];
                let d = (x - from).norm();
                if d == 0.0 { return last; }
                let to = if d <= step { *x } else { from + (x - from) * (step / d) };
                *checks += 1;
                if !v.motion_valid(&from, &to) { return last; }
                t.p.push(to); t.parent.push(n); n = t.p.len() - 1;
                last = Some(to);
                if to == *x || !greedy { return last; }
            }
        };
        let (ta, tb) = { let (l, r) = trees.split_at_mut(1); if a == 0 { (&mut l[0], &mut r[0]) } else { (&mut r[0], &mut l[0]) } };
        if let Some(new) = grow(ta, &x, greedy, &mut checks) {
            if grow(tb, &new, true, &mut checks) == Some(new) { return (true, it, checks); }
        }
        a = 1 - a;
    }
    (false, 50000, checks)
}
fn direct(problem: &Problem<TranslationSpace>, v: &dyn Validity, most: usize, seed: u64) -> (bool, usize, usize) {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let mut trees = [T { p: vec![problem.start], parent: vec![0] }, T { p: vec![problem.goal], parent: vec![0] }];
    let mut checks = 0;
    if v.motion_valid(&problem.start, &problem.goal) { return (true, 0, 1); }
    let mut order: Vec<(f64, usize)> = vec![];
    for it in 0..200000 {
        let x = problem.space.sample(&mut rng).unwrap();
        if !v.state_valid(&x) { continue; }
        let mut hit = [None; 2];
        for k in 0..2 {
            order.clear();
            order.extend(trees[k].p.iter().enumerate().map(|(i, p)| ((p - x).norm_squared(), i)));
            let m = most.min(order.len());
            if m < order.len() { order.select_nth_unstable_by(m - 1, |a, b| a.0.total_cmp(&b.0)); }
            order[..m].sort_by(|a, b| a.0.total_cmp(&b.0));
            for &(_, i) in &order[..m] {
                checks += 1;
                if v.motion_valid(&trees[k].p[i], &x) { hit[k] = Some(i); break; }
            }
        }
        for k in 0..2 { if let Some(i) = hit[k] { trees[k].p.push(x); trees[k].parent.push(i); } }
        if hit[0].is_some() && hit[1].is_some() { return (true, it, checks); }
    }
    (false, 50000, checks)
}
fn main() {
    let mut scenes = vec![];
    for name in ["hard1", "hard3"] { scenes.push((name.to_string(), cdpr_core::io::load_scene(format!("testdata/scenes/{name}.toml").as_ref()).unwrap())); }
    for (count, s) in [(10, 28)] {
        let spec: RandomScenesSpec = serde_json::from_str(&format!(r#"{{"count": {count}, "redraw_straight": true}}"#)).unwrap();
        let r = RandomScenes::new(cdpr_core::testing::empty(), spec).unwrap();
        scenes.push((format!("{count}:{s}"), r.draw(s + 1000).unwrap()));
    }
    for (name, scene) in scenes {
        let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
        let space = TranslationSpace::of(engine.constraints());
        let problem = Problem { space, start: scene.start().unwrap(), goal: scene.goal().unwrap() };
        let n = 1000;
        let run = |label: &str, f: &dyn Fn(u64) -> (bool, usize, usize)| {
            let mut times = vec![]; let mut checks = 0; let mut fails = 0; let mut its = 0;
            for seed in 0..n { let t = Instant::now(); let r = f(seed); times.push(t.elapsed().as_secs_f64() * 1e3); checks += r.2; its += r.1; fails += usize::from(!r.0); }
            times.sort_by(f64::total_cmp);
            println!("{name:8} {label:14} samples {} median {:.4} mean {:.4} p95 {:.4} ms, checks {} fails {fails}", its / n as usize, times[n as usize / 2], times.iter().sum::<f64>() / n as f64, times[950], checks / n as usize);
        };
        for (label, step, greedy) in [("classic 1 e", 1.0, false)] {
            run(label, &|s| classic(&problem, &engine, step, greedy, s));
        }
        for most in [1, 3, 10, 1000000] { run(&format!("direct {most}"), &|s| direct(&problem, &engine, most, s)); }
        run("modified", &|s| { let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(s); let o = modified_rrt(&problem, &engine, &ModifiedRrtOptions::default(), &mut rng, &Watch::NONE).unwrap(); (o.status == Status::Solved, o.samples, o.motion_checks) });
    }
}
