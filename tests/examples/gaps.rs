//! How often, and how soon, `anytime` with a gap ends with a proof, in random scenes of the paper's kind; whole calls of `plan`.
//!
//! `RAYON_NUM_THREADS=1 cargo run --release -p cdpr-tests --example gaps -- 0.01 100 3 6 10` (gap, scenes with a path for each number
//! of prisms)

use std::time::{Duration, Instant};

use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::testing::empty;
use cdpr_core::{Error, Scene};
use cdpr_study::{RandomScenes, RandomScenesSpec};

/// A search that has proved nothing after this time has failed.
const LONGEST: Duration = Duration::from_secs(20);

/// Relative rounding error of a gap.
const ROUNDING: f64 = 1e-6;

fn main() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [gap, scenes, counts @ ..] = &args[..] else { panic!("a gap, a number of scenes, and numbers of prisms") };
    let (gap, scenes): (f64, usize) = (gap.parse().expect("a gap"), scenes.parse().expect("a number of scenes"));
    for count in counts {
        let spec: RandomScenesSpec = toml::from_str(&format!("count = {count}")).expect("a valid spec");
        let random = RandomScenes::new(empty(), spec)?;
        let (mut seconds, mut proved, mut seed) = (Vec::new(), 0, 0);
        while seconds.len() < scenes {
            if let Some((time, gap_left)) = searched(&random.draw(seed)?, gap)? {
                seconds.push(time);
                proved += usize::from(gap_left <= gap * (1.0 + ROUNDING));
            }
            seed += 1;
        }
        seconds.sort_by(f64::total_cmp);
        let at = |share: f64| 1e3 * seconds[(share * (seconds.len() - 1) as f64) as usize];
        let soon = seconds.iter().filter(|time| **time <= 1.0).count();
        println!(
            "{count} prisms: {scenes} scenes with a path of {seed}; proved in {proved}, {soon} within 1 s; median {:.1} ms, 97 % {:.1} \
             ms, longest {:.1} ms",
            at(0.5),
            at(0.97),
            at(1.0)
        );
    }
    Ok(())
}

/// The time of a search in a scene, s, and the gap that it leaves; `None` if there is no path.
fn searched(scene: &Scene, gap: f64) -> Result<Option<(f64, f64)>, Error> {
    let settings = PlannerSettings { gap: Some(gap), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, PlanOptions::default().step, &settings)?;
    let options = PlanOptions { planner, budget: Some(LONGEST), ..PlanOptions::default() };
    let clock = Instant::now();
    let found = plan(Query::of(scene), &options, &())?.result;
    let seconds = clock.elapsed().as_secs_f64();
    if found.status != Status::Solved {
        return Ok(None);
    }
    let [Some(start), Some(goal)] = [scene.start(), scene.goal()] else { return Ok(None) };
    let bound = found.lower_bound.unwrap_or(0.0).max((goal - start).norm());
    Ok(Some((seconds, found.cost / bound - 1.0)))
}
