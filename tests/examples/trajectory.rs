//! Trajectories along planned paths of scene files: limits at many instants, durations and computing times.
//!
//! `cargo run --release -p cdpr-tests --example trajectory -- SEEDS STEPS CLEARANCE SCENE...`: for each scene the paths of so many
//! seeds, by turns without and with the clearance, m, without and with a limit of jerk, each judged at so many instants.

use cdpr_core::geometry::Pose;
use cdpr_core::path::positions;
use cdpr_tests::compiled;
use std::path::Path;
use std::time::Instant;

use cdpr_core::Error;
use cdpr_core::model::Scene;
use cdpr_core::model::spec::{MotionSpec, SceneSpec};
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::trajectory::{Passing, Trajectory};
use cdpr_core::watch::Watch;
use cdpr_tests::motions::{Worst, worst};
use rayon::prelude::*;

const BLEND: f64 = 0.025;
const JERK: f64 = 40.0;

fn main() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [seeds, steps] = [0, 1].map(|k| args[k].parse::<u32>().expect("a number"));
    let more = Some(args[2].parse::<f64>().expect("a number"));
    for file in &args[3..] {
        let scene = cdpr_files::load_scene(Path::new(file))?;
        let without = scene.spec().clearance;
        let variants = [(without, None), (more, None), (without, Some(JERK)), (more, Some(JERK))];
        for (first, (clearance, jerk)) in (0..u64::from(seeds)).zip(variants) {
            let scene = Scene::new(SceneSpec { clearance, ..scene.spec().clone() })?;
            let own: Vec<u64> = (first..u64::from(seeds)).step_by(variants.len()).collect();
            let judged = |seed: &u64| path(&scene, *seed).map(|(scene, path)| judged(&scene, &path, jerk, steps));
            report(file, clearance, jerk, &own.par_iter().filter_map(judged).collect::<Vec<_>>());
        }
    }
    Ok(())
}

fn path(scene: &Scene, seed: u64) -> Option<(Scene, Vec<Pose>)> {
    let planned = plan(scene, &PlanOptions { seed, ..PlanOptions::default() }, &()).ok()?;
    (planned.result.path.len() > 1).then_some((planned.scene, planned.result.path))
}

struct Judged {
    worst: Worst,
    duration: f64,
    with_stops: f64,
    passings: [usize; 3],
    milliseconds: [f64; 2],
    tensions: bool,
}

fn judged(scene: &Scene, path: &[Pose], jerk: Option<f64>, steps: u32) -> Result<Judged, String> {
    let limits = MotionSpec {
        speed: Some(1.0),
        acceleration: Some(2.0),
        jerk,
        cable_speed: Some(1.0),
        cable_acceleration: Some(4.0),
        turn_speed: None,
        turn_acceleration: None,
        blend: Some(BLEND),
        clearance: None,
        wrench_margin: None,
    };
    let text = |error: Error| error.to_string();
    let start = Instant::now();
    let found = Trajectory::new(&compiled(scene), path, &limits, &Watch::NONE).map_err(text)?;
    let whole = start.elapsed();
    let (curve, corners, winches) = (found.curve().clone(), found.corners().to_vec(), found.winches().clone());
    let start = Instant::now();
    Trajectory::along(curve, corners, *found.limits(), winches, &Watch::NONE).map_err(text)?;
    let timing = start.elapsed();
    let stops = MotionSpec { blend: Some(0.0), ..limits };
    let with_stops = Trajectory::new(&compiled(scene), path, &stops, &Watch::NONE).map_err(text)?.duration();
    let count = |passing| found.corners().iter().filter(|c| c.passing == passing).count();
    Ok(Judged {
        worst: worst(scene, &positions(path), &found, steps),
        duration: found.duration(),
        with_stops,
        passings: [Passing::Rounded, Passing::Outward, Passing::Stop].map(count),
        milliseconds: [whole, timing].map(|time| 1e3 * time.as_secs_f64()),
        tensions: found.winches().tension_limits().is_some(),
    })
}

fn report(file: &str, clearance: Option<f64>, jerk: Option<f64>, results: &[Result<Judged, String>]) {
    println!("{file}, clearance {clearance:?}, jerk {jerk:?}: {} paths", results.len());
    for error in results.iter().filter_map(|result| result.as_ref().err()) {
        println!("  {error}");
    }
    let found: Vec<&Judged> = results.iter().filter_map(|result| result.as_ref().ok()).collect();
    if found.is_empty() {
        return;
    }
    let mean = |of: &dyn Fn(&Judged) -> f64| found.iter().map(|f| of(f)).sum::<f64>() / found.len() as f64;
    let (duration, with_stops) = (mean(&|f| f.duration), mean(&|f| f.with_stops));
    let passed = |k: usize| found.iter().map(|f| f.passings[k]).sum::<usize>();
    println!(
        "  {duration:.4} s, {with_stops:.4} s with a stop at each corner ({:.1} % more); corners: {} rounded, {} outward, {} stops{}",
        100.0 * (with_stops / duration - 1.0),
        passed(0),
        passed(1),
        passed(2),
        if found[0].tensions { "" } else { "; tensions not limited" }
    );
    println!(
        "  computed in {:.1} ms, of which timing {:.1}",
        mean(&|f| f.milliseconds[0]),
        mean(&|f| f.milliseconds[1])
    );
    let worst = found.iter().fold(Worst::NOTHING, |worst, f| worst.or(f.worst));
    println!("  {} {worst:?}", if worst.is_sound() { "sound:" } else { "NOT SOUND:" });
}
