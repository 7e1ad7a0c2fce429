//! The default plan of one scene for some seeds: `once COUNT CLEARANCE SCENE_SEED SEEDS`; COUNT 1 is hard1, 3 is hard3.
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|t| t.parse().unwrap()).collect();
    let scene = match a[0] as usize {
        1 => cdpr_core::testing::hard1(),
        3 => cdpr_core::testing::hard3(),
        count => cdpr_benches::hall(count, a[1], a[2] as u64),
    };
    let (mut sum, mut most) = (0.0f64, 0.0f64);
    for seed in 0..a[3] as u64 {
        let options = cdpr_core::plan::PlanOptions { seed, ..Default::default() };
        let found = cdpr_core::plan::plan(&scene, &options, &|| false).unwrap();
        let ms = |cost: f64| found.history.iter().find(|m| m.cost <= cost).map_or(f64::NAN, |m| m.seconds * 1e3);
        sum += found.stats.planning_seconds;
        most = most.max(found.cost);
        if a[3] < 20.0 {
            let (first, near) = (ms(f64::INFINITY), ms(1.01 * found.cost));
            println!(
                "{seed}: {:.4}, first {first:.1}, near {near:.1}, all {:.1} ms; {} samples {} checks",
                found.cost,
                found.stats.planning_seconds * 1e3,
                found.stats.samples,
                found.stats.motion_checks,
            );
        }
    }
    println!("mean {:.3} ms, longest {most:.6}", 1e3 * sum / a[3]);
}
