//! Plans a scene without and with its [wrench] and prints, as CSV, places along both paths and the slack there: the
//! margin less what is demanded, negative where the demand is broken.
//!
//! `cargo run --release -p cdpr-core --example wrench_along -- testdata/scenes/cogiro.toml [seed]`

use cdpr_core::geometry::Point;
use cdpr_core::io::load_scene;
use cdpr_core::model::Scene;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::wrench::{Measure, measures};

/// Spacing of the places, m.
const SPACING: f64 = 0.01;

fn main() -> Result<(), cdpr_core::Error> {
    let mut arguments = std::env::args().skip(1);
    let scene = load_scene(arguments.next().expect("first argument: a scene file").as_ref())?;
    let seed = arguments.next().map_or(0, |n| n.parse().expect("second argument: a seed"));
    let measures = measures(&scene)?;
    let mut spec = scene.spec().clone();
    spec.wrench = None;
    println!("wrench,distance,x,y,z,slack");
    for (name, scene) in [("without", Scene::new(spec)?), ("with", scene)] {
        let path = plan(&scene, &PlanOptions { seed, ..PlanOptions::default() }, &|| false)?.waypoints;
        print(name, &path, &measures);
    }
    Ok(())
}

/// Prints the places along a path, every waypoint included.
fn print(name: &str, path: &[Point], measures: &[Measure]) {
    let mut before = 0.0;
    for (k, ends) in path.windows(2).enumerate() {
        let step = ends[1] - ends[0];
        let pieces = (step.norm() / SPACING).ceil() as usize;
        for i in usize::from(k > 0)..=pieces {
            let fraction = i as f64 / pieces as f64;
            let p = ends[0] + step * fraction;
            let slack = measures.iter().map(|measure| measure.slack(&p)).fold(f64::INFINITY, f64::min);
            let distance = before + fraction * step.norm();
            println!("{name},{distance:.4},{:.5},{:.5},{:.5},{slack:.4}", p.x, p.y, p.z);
        }
        before += step.norm();
    }
}
