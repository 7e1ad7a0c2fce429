//! Proposals for a new scene: a workspace around robot and obstacles, whether the cables can be required to hold the
//! platform, and a non-trivial query.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::Arc;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::batch::BatchOptions;
use crate::collision::many::{motions_valid, states_valid};
use crate::collision::{Checker, Engine, Interference, WrenchLimit};
use crate::compiled::{CompiledScene, engine_within};
use crate::conditions::Broken;
use crate::error::{Error, ErrorClass};
use crate::geometry::{Aabb, Point};
use crate::model::{Scene, SceneSpec};
use crate::plan::{PlanOptions, Query, plan};
use crate::planning::{Planner, PlannerOptions, PlannerSettings, StateSpace, Status, TranslationSpace};
use crate::watch::Watch;
use crate::words::count;

/// Random positions drawn to find valid ones; a tenth of them where checks are slow.
const DRAWN: usize = 50_000;
/// Positions checked at a time.
const AT_A_TIME: usize = 1_000;
/// Valid positions that are considered in pairs.
const PLACES: usize = 40;
/// Valid positions found near others, if these are few or given.
const PLACES_NEARBY: usize = 20;
/// Positions free of collisions at which the cables are tested.
const TESTED: usize = 1_000;
/// Positions at which it is found out why none is valid.
const EXPLAINED: usize = 100;
/// Pairs for which a path is searched.
const TRIALS: usize = 12;
/// Samples of the search for a path between a pair.
const SAMPLES: usize = 2_000;
/// Least freedom of the platform along each axis, as a share of the longest side of workspace or platform.
const LEAST_FREEDOM: f64 = 0.1;
/// Freedom of the platform along an axis that is widened, as a multiple of its longest side.
const FREEDOM: f64 = 2.0;

/// The workspace of a new scene: the box around outlets and obstacles, extended down to the floor, z = 0, if all of
/// them are above it. Where this leaves the platform hardly any room, as for a single cable or for outlets in a plane,
/// the box is widened.
///
/// # Example
/// ```
/// let box_ = cdpr_core::new_scene::workspace(&cdpr_core::testing::hard1());
/// assert_eq!((box_.min.z, box_.max.z), (0.0, 2.0));
/// ```
pub fn workspace(scene: &Scene) -> Aabb {
    let outlets = scene.robot().cables().iter().map(|cable| cable.outlet);
    let corners = scene.obstacles().iter().flat_map(|o| &o.parts).flat_map(|part| part.vertices().iter().copied());
    let mut whole = Aabb::around(&outlets.chain(corners).collect::<Vec<_>>());
    whole.min.z = whole.min.z.min(0.0);
    let turned = scene.robot().parts().iter().flat_map(|part| part.vertices()).map(|v| scene.orientation() * v);
    let platform = Aabb::around(&turned.collect::<Vec<_>>());
    let [whole_size, platform_size] = [whole.max - whole.min, platform.max - platform.min];
    let longest = Some(whole_size.max().max(platform_size.max())).filter(|side| *side > 0.0).unwrap_or(1.0);
    let least = LEAST_FREEDOM * longest;
    let freedom = least.max(FREEDOM * platform_size.max());
    let lacking =
        platform_size.zip_map(
            &whole_size,
            |platform, whole| {
                if whole < platform + least { platform + freedom - whole } else { 0.0 }
            },
        );
    Aabb { min: whole.min - lacking / 2.0, max: whole.max + lacking / 2.0 }
}

/// Why the wrenches that a scene requires leave no valid position among random ones that are free of collisions; `None` if
/// they leave some, or if all positions collide.
///
/// # Errors
/// [`Error::interrupted`].
pub fn unheld(scene: &Scene, watch: &Watch) -> Result<Option<String>, Error> {
    let engine = |scene: &Scene| engine_within(scene, Engine::default(), Interference::default(), watch);
    let geometry = engine(&Scene::new(SceneSpec { wrench: None, ..scene.spec().clone() })?)?;
    let whole = match engine(scene) {
        Err(error) if error.class() == ErrorClass::Input => return Ok(Some(error.to_string())),
        whole => whole?,
    };
    let given = valid(&*geometry, &ends(scene), watch)?;
    let places = valid_places(&*geometry, &given, TESTED, watch)?;
    if places.is_empty() || !valid(&*whole, &places, watch)?.is_empty() {
        return Ok(None);
    }
    let lacking = |place: &Point| whole.explain(place, place).map(|found| (*place, found));
    let found = places.iter().take(EXPLAINED).filter_map(lacking);
    let best = found.max_by(|(_, a), (_, b)| by_hold(a.wrench.as_ref(), b.wrench.as_ref()));
    let best = best.map_or(String::new(), |(Point { coords: p }, found)| {
        format!("; at ({}, {}, {}), {}", p.x, p.y, p.z, found.sentence())
    });
    Ok(Some(format!("the cables can hold the platform at none of {} free of collisions{best}", tried(places.len()))))
}

/// Compares what wrenches lack: by the rank of the wrench matrix, then by the margin.
fn by_hold(a: Option<&WrenchLimit>, b: Option<&WrenchLimit>) -> Ordering {
    let rank = |limit: Option<&WrenchLimit>| limit.and_then(|limit| limit.hold.as_ref()).map(|hold| hold.rank);
    let margin = |limit: Option<&WrenchLimit>| limit.map_or(f64::NEG_INFINITY, WrenchLimit::order);
    rank(a).cmp(&rank(b)).then(margin(a).total_cmp(&margin(b)))
}

/// A query for a new scene.
#[derive(Debug, Clone, PartialEq)]
pub enum Proposal {
    /// A start and a goal with a path between them.
    Query([Point; 2]),
    /// No query was found, for this reason.
    Lacking(String),
}

/// A start and a goal, rounded to centimetres or, in small workspaces, more finely, between which there is a path. Of the
/// pairs whose straight line is blocked and that are joined by straight lines through other positions, some that are far
/// apart are searched for the largest ratio of path length to straight distance. If there are none, the pair is the one
/// that is farthest apart on a free straight line. A start or goal of the scene is kept.
///
/// # Errors
/// The errors of [`engine_within`].
pub fn query(scene: &Scene, watch: &Watch) -> Result<Proposal, Error> {
    let compiled = Arc::new(CompiledScene::new(scene, Engine::default(), Interference::default(), watch)?);
    let engine = compiled.level();
    for (name, end) in [("start", scene.start()), ("goal", scene.goal())] {
        if let Some(found) = end.and_then(|end| engine.explain(&end, &end)) {
            return Ok(Proposal::Lacking(format!("the {name} is not valid: {}", found.sentence())));
        }
    }
    let places = valid_places(engine, &ends(scene), PLACES, watch)?;
    if places.is_empty() {
        return Ok(Proposal::Lacking(why_none(engine)));
    }
    let pairs = pairs(engine, [scene.start(), scene.goal()], &places, watch)?;
    let free = pairs.iter().filter(|pair| pair.free).max_by(|a, b| a.length().total_cmp(&b.length()));
    let mut blocked: Vec<&Pair> = pairs.iter().filter(|pair| !pair.free && (pair.joined || free.is_none())).collect();
    blocked.sort_by(|a, b| b.joined.cmp(&a.joined).then(b.length().total_cmp(&a.length())));
    blocked.truncate(TRIALS);
    let detour = largest_detour(scene, &compiled, &blocked, watch)?;
    Ok(match detour.or(free.map(|pair| pair.ends)) {
        Some(ends) => Proposal::Query(ends),
        None if ends(scene).len() == 2 => {
            Proposal::Lacking("a short search found no path from the start to the goal".to_string())
        }
        None => {
            let found = count(places.len(), "valid position");
            Proposal::Lacking(format!("found {found}, but no two with a path between them in a short search"))
        }
    })
}

/// The start and goal of a scene, as far as it has them.
fn ends(scene: &Scene) -> Vec<Point> {
    [scene.start(), scene.goal()].into_iter().flatten().collect()
}

fn tried(positions: usize) -> String {
    count(positions, "random position")
}

/// Why all positions are invalid.
fn why_none(engine: &dyn Checker) -> String {
    let space = TranslationSpace::of(engine.conditions());
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let positions = (0..EXPLAINED).map_while(|_| space.sample(&mut rng));
    let mut reasons: BTreeMap<String, usize> = BTreeMap::new();
    for found in positions.filter_map(|place| engine.explain(&place, &place)) {
        let without_numbers = Broken { culprits: &found.culprits, gap: None, required: None };
        *reasons.entry(found.kind.sentence(&without_numbers)).or_default() += 1;
    }
    match reasons.into_iter().max_by_key(|(_, times)| *times) {
        None => "the platform does not fit into the workspace".to_string(),
        Some((reason, times)) => {
            format!("found no valid position; at {times} of {}, {reason}", tried(EXPLAINED))
        }
    }
}

/// Two positions, and what is known about the way between them.
struct Pair {
    ends: [Point; 2],
    /// Whether the straight line between the positions is free.
    free: bool,
    /// Whether a path along straight lines between valid positions joins them.
    joined: bool,
}

impl Pair {
    fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).norm()
    }
}

/// The pairs of valid positions that may be start and goal; one that is given is kept.
fn pairs(
    engine: &dyn Checker,
    [start, goal]: [Option<Point>; 2],
    places: &[Point],
    watch: &Watch,
) -> Result<Vec<Pair>, Error> {
    let indices: Vec<[usize; 2]> = (0..places.len()).flat_map(|b| (0..b).map(move |a| [a, b])).collect();
    let mut free = vec![false; indices.len()];
    let motion = |k: usize| indices[k].map(|index| places[index]).into();
    motions_valid(engine, motion, &mut free, &BatchOptions { threads: None, watch: *watch })?;
    // The number of a place is that of the first one to which it is joined.
    let mut part: Vec<usize> = (0..places.len()).collect();
    for ([a, b], _) in indices.iter().zip(&free).filter(|(_, free)| **free) {
        let (kept, left) = (part[*a].min(part[*b]), part[*a].max(part[*b]));
        part.iter_mut().filter(|part| **part == left).for_each(|part| *part = kept);
    }
    let fits = |[a, b]: [Point; 2]| start.is_none_or(|start| start == a) && goal.is_none_or(|goal| goal == b);
    let pair = |([a, b], free): (&[usize; 2], &bool)| {
        let orders = [[places[*b], places[*a]], [places[*a], places[*b]]];
        let ends = orders.into_iter().find(|ends| fits(*ends))?;
        Some(Pair { ends, free: *free, joined: part[*a] == part[*b] })
    };
    Ok(indices.iter().zip(&free).filter_map(pair).collect())
}

/// The pair with the largest ratio of path length to straight distance, among those between which a path is found.
fn largest_detour(
    scene: &Scene,
    compiled: &Arc<CompiledScene>,
    pairs: &[&Pair],
    watch: &Watch,
) -> Result<Option<[Point; 2]>, Error> {
    let settings = PlannerSettings { max_samples: Some(SAMPLES), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::TwoTrees, PlanOptions::default().step, &settings)?;
    let options = PlanOptions { planner, ..PlanOptions::default() };
    let mut best: Option<(f64, [Point; 2])> = None;
    for pair in pairs {
        let [start, goal] = pair.ends;
        let found =
            plan(Query::of(scene).starting_at(start).to(goal).by(compiled), &options, &|| (watch.interrupted)())?
                .result
                .unless_interrupted()?;
        let detour = found.cost / pair.length();
        if found.status == Status::Solved && best.is_none_or(|(other, _)| detour > other) {
            best = Some((detour, pair.ends));
        }
    }
    Ok(best.map(|(_, ends)| ends))
}

/// The given positions, which are valid, and up to `most` more valid ones: drawn evenly, rounded more finely if this
/// gives too few, and then near those known.
fn valid_places(engine: &dyn Checker, given: &[Point], most: usize, watch: &Watch) -> Result<Vec<Point>, Error> {
    let space = TranslationSpace::of(engine.conditions());
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let drawn = if engine.may_be_slow() { DRAWN / 10 } else { DRAWN };
    let digits = digits(&space);
    let mut places = given.to_vec();
    let gather = |places: &mut Vec<Point>, wanted: usize, drawn: &[Point]| {
        for some in drawn.chunks(AT_A_TIME) {
            if places.len() >= wanted {
                break;
            }
            places.extend(valid(engine, some, watch)?);
            places.truncate(wanted);
        }
        Ok::<_, Error>(())
    };
    for digits in [digits, digits + 2] {
        let evenly = (0..drawn).map_while(|_| space.sample(&mut rng)).map(|place| rounded(&space, place, digits));
        gather(&mut places, given.len() + most, &evenly.collect::<Vec<_>>())?;
    }
    if !places.is_empty() && (places.len() < most || !given.is_empty()) {
        let known = places.clone();
        let near = (0..drawn / 10).filter_map(|k| space.sample_around(&known[k % known.len()], &mut rng));
        let near: Vec<Point> = near.map(|place| rounded(&space, place, digits + 2)).collect();
        gather(&mut places, known.len() + PLACES_NEARBY, &near)?;
    }
    Ok(places)
}

/// The valid ones among some positions.
fn valid(engine: &dyn Checker, places: &[Point], watch: &Watch) -> Result<Vec<Point>, Error> {
    let mut answers = vec![false; places.len()];
    states_valid(engine, |k| places[k], &mut answers, &BatchOptions { threads: None, watch: *watch })?;
    Ok(places.iter().zip(answers).filter(|(_, valid)| *valid).map(|(place, _)| *place).collect())
}

/// Decimals of positions: two, or more if the longest side of the box of positions is below 1 m.
fn digits(space: &TranslationSpace) -> i32 {
    let longest = space.largest_distance();
    (2.0 - longest.log10().floor()).clamp(2.0, 6.0) as i32
}

/// A position with this number of decimals, within the space.
fn rounded(space: &TranslationSpace, place: Point, digits: i32) -> Point {
    let scale = 10_f64.powi(digits);
    let near = place.map(|x| (x * scale).round() / scale);
    Point::from(near.coords.zip_zip_map(&space.min.coords, &space.max.coords, f64::clamp))
}
