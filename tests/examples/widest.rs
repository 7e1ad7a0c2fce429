//! Times of the widest path.
use cdpr_core::plan::{PlanOptions, plan_widest};
use std::time::Instant;
fn main() {
    for file in std::env::args().skip(1) {
        let scene = cdpr_files::Loader::new(cdpr_core::Watch::NONE).scene(std::path::Path::new(&file)).unwrap();
        let clock = Instant::now();
        let found = plan_widest(&scene, &PlanOptions::default(), &|| clock.elapsed().as_secs() > 100);
        match found {
            Ok(found) => println!(
                "{file}: {:.3} s {:?} {:?} {} m",
                clock.elapsed().as_secs_f64(),
                found.result.status,
                found.result.widest,
                found.result.cost
            ),
            Err(error) => println!("{file}: {error}"),
        }
    }
}
