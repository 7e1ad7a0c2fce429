fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|t| t.parse().unwrap()).collect();
    let scene = cdpr_benches::hall(a[0] as usize, a[1], a[2] as u64);
    for seed in 0..a[3] as u64 {
        let options = cdpr_core::plan::PlanOptions { seed, ..Default::default() };
        let clock = std::time::Instant::now();
        let found = cdpr_core::plan::plan(&scene, &options, &|| false).unwrap();
        let first = found.history.first().map_or(f64::NAN, |m| m.seconds * 1e3);
        println!(
            "{seed}: {:.4} in {:.1} ms, first {first:.1}, {} samples {} checks, {} milestones, search {:.1}",
            found.cost,
            clock.elapsed().as_secs_f64() * 1e3,
            found.stats.samples,
            found.stats.motion_checks,
            found.history.len(),
            found.stats.planning_seconds * 1e3
        );
    }
}
