//! Trajectories along planned paths of scene files, and how long they take to compute.
//!
//! `cargo run --release -p cdpr-tests --example trajectory -- SEEDS SCENE...`

use std::time::Instant;

use cdpr_core::Error;
use cdpr_core::model::Scene;
use cdpr_core::model::spec::{MotionSpec, SceneSpec};
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::trajectory::{Passing, Trajectory};
use cdpr_core::watch::Watch;

fn main() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let seeds: u64 = args[0].parse().expect("a number of seeds");
    for file in &args[1..] {
        for clearance in [None, Some(0.03)] {
            for seed in 0..seeds {
                one(file, clearance, seed)?;
            }
        }
    }
    Ok(())
}

fn one(file: &str, clearance: Option<f64>, seed: u64) -> Result<(), Error> {
    let scene = cdpr_files::load_scene(std::path::Path::new(file))?;
    let spec = SceneSpec { clearance: clearance.or(scene.spec().clearance), ..scene.spec().clone() };
    let scene = Scene::new(spec)?;
    let options = PlanOptions { seed, ..PlanOptions::default() };
    let planned = plan(&scene, &options, &())?;
    let scene = planned.turned.unwrap_or(scene);
    if planned.result.waypoints.len() < 2 {
        println!("{file}: no path with clearance {clearance:?}");
        return Ok(());
    }
    for jerk in if std::env::var("REPEAT").is_ok() { vec![None] } else { vec![None, Some(40.0)] } {
        let limits = MotionSpec {
            speed: Some(1.0),
            acceleration: Some(2.0),
            jerk,
            cable_speed: Some(1.0),
            cable_acceleration: Some(4.0),
            blend: clearance.or(Some(0.03)),
            wrench_margin: None,
        };
        let start = Instant::now();
        match Trajectory::new(&scene, &planned.result.waypoints, &limits, &Watch::NONE) {
            Err(error) => println!("{file} seed {seed} clearance {clearance:?}: {error}"),
            Ok(found) => {
                let ms = 1e3 * start.elapsed().as_secs_f64();
                let (curve, corners) = (found.curve().clone(), found.corners().to_vec());
                let (limits, winches) = (*found.limits(), found.winches().clone());
                let start = Instant::now();
                for _ in 0..std::env::var("REPEAT").map_or(1, |n| n.parse().unwrap()) {
                    Trajectory::along(curve.clone(), corners.clone(), limits, winches.clone(), &Watch::NONE)?;
                }
                let timing_ms = 1e3 * start.elapsed().as_secs_f64();
                let count = |passing| found.corners().iter().filter(|c| c.passing == passing).count();
                println!(
                    "{file} seed {seed} clearance {clearance:?} jerk {jerk:?}: {:.4} s for {:.3} m, corners {} rounded {} outward {} stops, {ms:.1} ms, of which timing {timing_ms:.1}",
                    found.duration(),
                    found.curve().length(),
                    count(Passing::Rounded),
                    count(Passing::Outward),
                    count(Passing::Stop),
                );
            }
        }
    }
    Ok(())
}
