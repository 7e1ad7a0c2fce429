//! Proposals for a new scene: a workspace around robot and obstacles, and a non-trivial query.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::collision::{Checker, Engine, Interference};
use crate::error::Error;
use crate::geometry::{Aabb, Point};
use crate::model::Scene;
use crate::plan::{PlanOptions, Query, engine_within, plan};
use crate::planning::{Planner, PlannerOptions, PlannerSettings, StateSpace, Status, TranslationSpace};
use crate::watch::{Interrupt, Watch};

/// Random positions drawn to find valid ones.
const DRAWN: usize = 5_000;
/// Valid positions that are considered in pairs.
const PLACES: usize = 40;
/// Pairs for which a path is searched.
const TRIALS: usize = 12;
/// Samples of each such search.
const SAMPLES: usize = 2_000;

/// The workspace of a new scene: the box around outlets and obstacles, extended down to the floor, z = 0, if all of
/// them are above it.
///
/// # Example
/// ```
/// let box_ = cdpr_core::proposal::workspace(&cdpr_core::testing::hard1());
/// assert_eq!((box_.min.z, box_.max.z), (0.0, 2.0));
/// ```
pub fn workspace(scene: &Scene) -> Aabb {
    let outlets = scene.robot().cables().iter().map(|cable| cable.outlet);
    let corners = scene.obstacles().iter().flat_map(|o| &o.parts).flat_map(|part| part.vertices().iter().copied());
    let mut whole = Aabb::around(&outlets.chain(corners).collect::<Vec<_>>());
    whole.min.z = whole.min.z.min(0.0);
    whole
}

/// A start and a goal, rounded to centimetres, between which a path exists. Pairs whose straight line is blocked and
/// that are far apart are tried first; of the pairs tried, the one with the largest ratio of path length to straight
/// distance is returned. A start or goal of the scene is kept. `None` if no pair has a path.
///
/// # Errors
/// As [`engine_within`].
pub fn query(scene: &Scene, interrupted: &Interrupt) -> Result<Option<[Point; 2]>, Error> {
    let engine = engine_within(scene, Engine::default(), Interference::default(), &Watch::on(interrupted))?;
    let places = valid_places(&*engine, interrupted)?;
    let ends = |given: Option<Point>| given.map_or(places.clone(), |end| vec![end]);
    let goals = ends(scene.goal());
    let pairs = ends(scene.start()).into_iter().flat_map(|start| goals.iter().map(move |goal| [start, *goal]));
    let mut pairs: Vec<(bool, f64, [Point; 2])> =
        pairs.map(|[a, b]| (engine.motion_valid(&a, &b), (b - a).norm(), [a, b])).collect();
    pairs.sort_by(|(free, length, _), (other_free, other, _)| free.cmp(other_free).then(other.total_cmp(length)));
    let settings = PlannerSettings { max_samples: Some(SAMPLES), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::TwoTrees, PlanOptions::default().step, &settings)?;
    let options = PlanOptions { planner, ..PlanOptions::default() };
    let mut best: Option<(f64, [Point; 2])> = None;
    for (_, straight, [start, goal]) in pairs.into_iter().take(TRIALS) {
        let found = plan(Query::of(scene).from(start).to(goal).by(&*engine), &options, &|| interrupted())?.result;
        let detour = found.cost / straight;
        if found.status == Status::Solved && best.is_none_or(|(other, _)| detour > other) {
            best = Some((detour, [start, goal]));
        }
    }
    Ok(best.map(|(_, ends)| ends))
}

fn valid_places(engine: &dyn Checker, interrupted: &Interrupt) -> Result<Vec<Point>, Error> {
    let space = TranslationSpace::of(engine.conditions());
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let mut places = Vec::new();
    for _ in 0..DRAWN {
        if interrupted() {
            return Err(Error::interrupted());
        }
        let Some(place) = space.sample(&mut rng) else { break };
        let place = place.map(|x| (x * 100.0).round() / 100.0);
        if engine.state_valid(&place) {
            places.push(place);
        }
        if places.len() == PLACES {
            break;
        }
    }
    Ok(places)
}
