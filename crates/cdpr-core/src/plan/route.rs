//! Paths with via points, and paths that may end at several places.
//!
//! A path through via points is planned leg by leg. Every path through them is at least as long as the lower bounds of the legs together, so
//! the sum bounds the whole. Of several goals, those are planned that a straight line does not show to be too far. In a box
//! of goals, the path is planned to a few positions that are spread over the valid ones; its end then slides through the box, as
//! long as the path becomes shorter.

use std::sync::Arc;

use super::result::{RouteFound, Searches};
use super::{
    Observer, PlanOptions, PlanResult, Planned, Post, Processing, Query, plan, quick_bound, shorten, verified,
};
use crate::collision::{Validity, worst_first};
use crate::compiled::{CompiledScene, length};
use crate::error::{Error, ErrorClass};
use crate::geometry::{Point, Pose, Vector};
use crate::model::{PositionSource, Scene, body};
use crate::planning::Status;
use crate::watch::{Watch, in_time, unless_interrupted};

/// What a path passes, and where it may end.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Route {
    /// What it passes, in this order. A platform that turns has the orientation of the station there; at a station without one and at a
    /// position, that of the point before.
    pub via: Vec<PositionSource>,
    /// Where it may end; the goal of the query if there is none, and if there are several, where the path is shortest.
    pub goals: Vec<PositionSource>,
    /// The box in which it may end, in place of a goal: least and largest coordinates, world, m.
    pub goal_box: Option<[Point; 2]>,
}

impl Route {
    /// Whether this is a path without via points to the goal of the query.
    pub fn is_plain(&self) -> bool {
        *self == Route::default()
    }

    /// Checks what does not depend on a scene.
    ///
    /// # Errors
    /// A box of goals that is not one, or that is given beside goals; via points with a `target_cost`.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::plan::Route;
    /// use cdpr_core::{PlanOptions, Point};
    /// let route = Route { goal_box: Some([Point::new(1.0, 1.0, 1.0), Point::new(2.0, 2.0, 0.5)]), ..Route::default() };
    /// let wrong = route.check(&PlanOptions::default()).unwrap_err().to_string();
    /// assert!(wrong.ends_with("expected the smaller coordinates first"));
    /// ```
    pub fn check(&self, options: &PlanOptions) -> Result<(), Error> {
        if let Some([least, most]) = &self.goal_box {
            for (corner, key) in [(least, "goal_box[0]"), (most, "goal_box[1]")] {
                body::point(key, (*corner).into())?;
            }
            if (0..3).any(|axis| least[axis] > most[axis]) {
                let [least, most] = [least, most].map(|corner| <[f64; 3]>::from(*corner));
                let problem = format!("found {least:?} to {most:?}, expected the smaller coordinates first");
                return Err(Error::invalid("goal_box", problem));
            }
            if !self.goals.is_empty() {
                return Err(Error::invalid("goal_box", "found with a goal, expected one of the two"));
            }
        }
        if !self.via.is_empty() && options.planner.settings().target_cost.is_some() {
            let problem = "found with via points, where no leg has a length of its own; expected one of the two";
            return Err(Error::invalid("target_cost", problem));
        }
        Ok(())
    }

    /// For each goal, the poses at start, via points and goal. A box of goals counts as one goal, whose pose is left out.
    ///
    /// # Errors
    /// No start or goal; a station that is not known; coordinates that are not finite.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::Query;
    /// use cdpr_core::plan::Route;
    /// let scene = cdpr_core::testing::hard1();
    /// let route = Route { via: vec![[1.0, 1.0, 1.8].into()], ..Route::default() };
    /// let stops = route.stops(&Query::of(&scene))?;
    /// assert_eq!((stops.len(), stops[0].len(), stops[0][1].position.z), (1, 3, 1.8));
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn stops(&self, query: &Query) -> Result<Vec<Vec<Pose>>, Error> {
        let goals = match &self.goal_box {
            Some(region) => vec![PositionSource::from(region[0])],
            None => self.goals.clone(),
        };
        let to_each = |scene: &Scene| {
            let mut stops = stops(scene, query, &via_poses(scene, query, &self.via)?)?;
            stops.truncate(stops.len() - usize::from(self.goal_box.is_some()));
            Ok(stops)
        };
        scenes_to(query.scene, &goals)?.iter().map(to_each).collect()
    }
}

/// Plans a path through via points, or to the nearest of several goals. The legs have the seed and the limits of the options each; they share
/// the budget.
///
/// # Errors
/// The errors of [`plan()`]; a station that is not known; a box of goals that is not one, or that is given beside goals; via points with a
/// `target_cost`.
///
/// # Example
/// ```
/// use cdpr_core::plan::{Route, plan_route};
/// use cdpr_core::{PlanOptions, Point};
/// let scene = cdpr_core::testing::hard1();
/// let over = Route { via: vec![[1.0, 1.0, 1.8].into()], ..Route::default() };
/// let found = plan_route(&scene, &over, &PlanOptions::default(), &())?.result;
/// assert!(found.path[found.route.unwrap().via[0]].position == Point::new(1.0, 1.0, 1.8));
/// let near = Route { goals: vec![[1.7, 1.0, 1.7].into(), [0.3, 1.0, 1.0].into()], ..Route::default() };
/// let found = plan_route(&scene, &near, &PlanOptions::default(), &())?.result;
/// assert!((found.cost - 0.7).abs() < 1e-9 && found.route.unwrap().goal == Some(1));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan_route<'q>(
    query: impl Into<Query<'q>>,
    route: &Route,
    options: &PlanOptions,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    routed(query.into(), route, options, observer, true)
}

/// Plans like [`plan_route`], but leaves out the lower bounds on the length, which may take longer than the search.
///
/// # Errors
/// The errors of [`plan_route`].
///
/// # Example
/// ```
/// use cdpr_core::PlanOptions;
/// use cdpr_core::plan::{Route, search_route};
/// let over = Route { via: vec![[1.0, 1.0, 1.8].into()], ..Route::default() };
/// let found = search_route(&cdpr_core::testing::hard1(), &over, &PlanOptions::default(), &())?.result;
/// assert!(found.cost > 1.98 && found.lower_bound.is_none()); // the straight line is 1.98 m long
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn search_route<'q>(
    query: impl Into<Query<'q>>,
    route: &Route,
    options: &PlanOptions,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    routed(query.into(), route, options, observer, false)
}

fn routed(
    query: Query,
    route: &Route,
    options: &PlanOptions,
    observer: &dyn Observer,
    bounded: bool,
) -> Result<Planned, Error> {
    if route.is_plain() {
        return plan(query, options, observer);
    }
    route.check(options)?;
    let interrupted = || observer.interrupted();
    let watch = options.watch(&interrupted);
    let scenes = match query.compiled.is_none() && query.scene.orientation_is_open() {
        true => query.scene.choices(),
        false => vec![query.scene.clone()],
    };
    let mut search = Search { route, options, observer, bounded, best: None, searches: Searches::default() };
    for (k, scene) in scenes.iter().enumerate() {
        let share = watch.left().map(|left| left / (scenes.len() - k) as u32);
        let ended = search.at_one(&Query { scene, ..query }, &Watch::on(&interrupted).with_budget(share));
        match ended {
            Err(error) if error.class() == ErrorClass::Interrupted => break,
            ended => ended?.into_iter().for_each(|found| search.keep(found)),
        }
    }
    let Some(mut best) = search.best else {
        return Ok(Planned { scene: query.scene.clone(), compiled: None, result: PlanResult::interrupted() });
    };
    best.result.stats = search.searches.stats();
    Ok(best)
}

/// Plans from the start of a query through these poses to its goal, in a scene that selects an orientation; `bounded`: with a lower bound
/// on the length.
///
/// # Errors
/// The errors of [`plan()`].
pub(crate) fn plan_through(
    query: Query,
    via: &[Pose],
    options: &PlanOptions,
    observer: &dyn Observer,
    bounded: bool,
) -> Result<Planned, Error> {
    let scene = query.scene;
    let interrupted = Planned { scene: scene.clone(), compiled: None, result: PlanResult::interrupted() };
    Ok(unless_interrupted(legs_through(query, via, options, observer, bounded))?.unwrap_or(interrupted))
}

fn legs_through(
    query: Query,
    via: &[Pose],
    options: &PlanOptions,
    observer: &dyn Observer,
    bounded: bool,
) -> Result<Planned, Error> {
    let interrupted = || observer.interrupted();
    let watch = options.watch(&interrupted);
    let Some(compiled) = query.compile(options, &watch)? else { return Ok(Planned::out_of_time(query.scene)) };
    let query = Query { compiled: Some(&compiled), ..query };
    let bound_of = |found: &PlanResult| if bounded { quick_bound(&compiled, found, &watch) } else { Ok(None) };
    if via.is_empty() {
        let mut planned = plan(query, options, observer)?;
        planned.result.lower_bound = bound_of(&planned.result)?;
        planned.result.route = Some(RouteFound::default());
        return Ok(planned);
    }
    let [start, goal] = query.poses()?;
    let stops: Vec<Pose> = [start].into_iter().chain(via.iter().copied()).chain([goal]).collect();
    let legs = stops.len() - 1;
    let mut searches = Searches::default();
    let (mut path, mut raw_path, mut passed) = (vec![start], vec![start], Vec::new());
    let mut bound = Some(0.0);
    for (leg, ends) in stops.windows(2).enumerate() {
        let share = watch.left().map(|left| left / (legs - leg) as u32);
        let options = PlanOptions { budget: share, ..options.clone() };
        let part = Query { answer: None, known: None, ..query.between(&ends[0], &ends[1]) };
        let mut found = plan(part, &options, &interrupted)?.result;
        searches.add(&mut found);
        if found.status != Status::Solved {
            let route = Some(RouteFound { leg: Some([leg, legs]), ..RouteFound::default() });
            let result = PlanResult { route, stats: searches.stats(), ..found };
            return Ok(Planned::by(query.scene, compiled.clone(), result));
        }
        bound = bound.zip(bound_of(&found)?).map(|(before, own)| before + own);
        path.extend(&found.path[1..]);
        raw_path.extend(&found.raw_path[1..]);
        passed.push(path.len() - 1);
    }
    passed.pop(); // the goal
    let result = PlanResult {
        cost: length(query.scene, &path),
        raw_cost: length(query.scene, &raw_path),
        path,
        raw_path,
        lower_bound: bound,
        route: Some(RouteFound { via: passed, ..RouteFound::default() }),
        ..PlanResult::unsolved(Status::Solved, searches.stats())
    };
    Ok(Planned::by(query.scene, compiled.clone(), result))
}

/// The search for the shortest of several paths.
struct Search<'a> {
    route: &'a Route,
    options: &'a PlanOptions,
    observer: &'a dyn Observer,
    /// Whether to measure how short a path may be.
    bounded: bool,
    best: Option<Planned>,
    searches: Searches,
}

impl Search<'_> {
    /// Plans at the orientation of the query's scene; `None` if no path there can be shorter than the best so far.
    fn at_one(&mut self, query: &Query, watch: &Watch) -> Result<Option<Planned>, Error> {
        let out_of_time = || Ok(Some(Planned::out_of_time(query.scene)));
        let Some(compiled) = query.compile(self.options, watch)? else { return out_of_time() };
        let goals = match &self.route.goal_box {
            None => self.route.goals.clone(),
            Some(region) => match in_time(goals_in(&compiled, query, region, &self.route.via, watch))? {
                Some(Ok(goals)) => goals,
                Some(Err(none_valid)) => return Ok(Some(none_valid)),
                None => return out_of_time(),
            },
        };
        let scenes = scenes_to(query.scene, &goals)?;
        let via = scenes.iter().map(|scene| via_poses(scene, query, &self.route.via)).collect::<Result<Vec<_>, _>>()?;
        let straight = scenes.iter().zip(&via).map(|(scene, via)| Ok(length(scene, &stops(scene, query, via)?)));
        let straight = straight.collect::<Result<Vec<f64>, Error>>()?;
        let mut nearest: Vec<usize> = (0..scenes.len()).collect();
        nearest.sort_by(|a, b| straight[*a].total_cmp(&straight[*b]));
        let mut bound = Some(f64::INFINITY);
        let mut own: Option<Planned> = None;
        for (k, goal) in nearest.iter().copied().enumerate() {
            let shortest = self.best.iter().chain(&own).map(Planned::length).fold(f64::INFINITY, f64::min);
            if straight[goal] >= shortest {
                continue;
            }
            let share = watch.left().map(|left| left / (nearest.len() - k) as u32);
            let options = PlanOptions { budget: share, ..self.options.clone() };
            let scene = &scenes[goal];
            let shared = Some(&compiled).filter(|_| scene.orientation() == query.scene.orientation());
            let shorter = Shorter { observer: self.observer, than: shortest };
            let asked = Query { scene, compiled: shared, ..*query };
            let mut found = plan_through(asked, &via[goal], &options, &shorter, self.bounded)?;
            if let (Some(region), true) = (&self.route.goal_box, options.post != Some(Post::None)) {
                slide_end(&mut found, region, watch)?;
            }
            self.searches.add(&mut found.result);
            bound = bound.zip(bound_to_goal(&found.result, straight[goal])).map(|(others, own)| others.min(own));
            if let Some(route) = &mut found.result.route {
                route.goal = Some(goal).filter(|_| self.route.goals.len() > 1);
            }
            own = Some(match own {
                Some(best) if !found.better_than(&best) => best,
                _ => found,
            });
        }
        let Some(mut own) = own else { return Ok(None) };
        if own.result.status == Status::Solved && self.bounded {
            let bound = match &self.route.goal_box {
                Some(region) => to_box(&own, region).filter(|_| bound.is_some()),
                None => bound,
            };
            own.result.lower_bound = bound.map(|bound| bound.min(own.result.cost));
        }
        Ok(Some(own))
    }

    fn keep(&mut self, found: Planned) {
        if self.best.as_ref().is_none_or(|best| found.better_than(best)) {
            self.best = Some(found);
        }
    }
}

/// Passes on the paths that are shorter than another one.
struct Shorter<'a> {
    observer: &'a dyn Observer,
    than: f64,
}

impl Observer for Shorter<'_> {
    fn interrupted(&self) -> bool {
        self.observer.interrupted()
    }

    fn improved(&self, seconds: f64, cost: f64, path: &[Point]) {
        if cost < self.than {
            self.observer.improved(seconds, cost, path);
        }
    }
}

fn to_goal(scene: &Scene, goal: &PositionSource) -> Result<Scene, Error> {
    let start = scene.spec().query.as_ref().and_then(|query| query.start.clone());
    scene.clone().between([start, Some(goal.clone())])
}

/// The scene with each of these goals; with its own if there are none.
fn scenes_to(scene: &Scene, goals: &[PositionSource]) -> Result<Vec<Scene>, Error> {
    match goals.is_empty() {
        true => Ok(vec![scene.clone()]),
        false => goals.iter().map(|goal| to_goal(scene, goal)).collect(),
    }
}

fn via_poses(scene: &Scene, query: &Query, via: &[PositionSource]) -> Result<Vec<Pose>, Error> {
    let mut orientation = Query { scene, ..*query }.poses()?[0].orientation;
    let pose = |(k, source): (usize, &PositionSource)| {
        let (position, own) = scene.named_position(&format!("via[{k}]"), source)?;
        orientation = own.unwrap_or(orientation);
        Ok(Pose::new(position, orientation))
    };
    via.iter().enumerate().map(pose).collect()
}

/// Start, via points and goal.
fn stops(scene: &Scene, query: &Query, via: &[Pose]) -> Result<Vec<Pose>, Error> {
    let [start, goal] = Query { scene, ..*query }.poses()?;
    Ok([start].into_iter().chain(via.iter().copied()).chain([goal]).collect())
}

/// A lower bound on the length of every path to a goal, m; infinite if there is none. `None` if the platform may turn, or if there
/// was no time.
fn bound_to_goal(found: &PlanResult, straight: f64) -> Option<f64> {
    match found.status {
        Status::NoPath | Status::StartInvalid | Status::GoalInvalid => Some(f64::INFINITY),
        Status::Solved => found.lower_bound,
        Status::BudgetSpent | Status::Interrupted => Some(straight),
    }
}

/// A lower bound on the length of every path through the via points of this one into a box, m: straight from each to the next.
fn to_box(found: &Planned, region: &[Point; 2]) -> Option<f64> {
    let path = &found.result.path;
    let via = found.result.route.as_ref().map_or(&[][..], |route| &route.via);
    let mut stops = vec![*path.first()?];
    stops.extend(via.iter().map(|k| path[*k]));
    let last = stops.last()?.position;
    Some(length(&found.scene, &stops) + (clamped(&last, region) - last).norm())
}

/// The point of a box that is nearest to a point.
fn clamped(point: &Point, [least, most]: &[Point; 2]) -> Point {
    point.coords.zip_zip_map(&least.coords, &most.coords, |x, least, most| x.clamp(least, most)).into()
}

/// How finely a box of goals is searched for valid positions: points along each axis, until some are valid.
const POINTS: [usize; 4] = [5, 9, 17, 33];

/// Positions in a box to which paths are planned.
const MOST_GOALS: usize = 8;

/// Valid positions that are spread over a box: first the one nearest to the last stop before it, then always the one farthest
/// from those chosen. If none is valid, the answer that says so, at the point nearest to that stop.
fn goals_in(
    compiled: &Arc<CompiledScene>,
    query: &Query,
    region: &[Point; 2],
    via: &[PositionSource],
    watch: &Watch,
) -> Result<Result<Vec<PositionSource>, Planned>, Error> {
    let somewhere = to_goal(query.scene, &PositionSource::from(region[0]))?;
    let asked = Query { scene: &somewhere, ..*query };
    let [start, goal] = asked.poses()?;
    let before = via_poses(&somewhere, query, via)?.last().copied().unwrap_or(start);
    compiled.ready_for(&[before, goal])?;
    let nearest = clamped(&before.position, region);
    let valid = |position: &Point| compiled.state_valid(&Pose::new(*position, goal.orientation));
    let mut found = Vec::new();
    for count in POINTS {
        let mut grid = grid(region, count);
        grid.push(nearest);
        for position in grid {
            watch.check()?;
            found.extend(Some(position).filter(valid));
        }
        if !found.is_empty() {
            break;
        }
    }
    if found.is_empty() {
        let pose = Pose::new(nearest, goal.orientation);
        let reasons = worst_first(compiled.violations(&pose, &pose));
        let result = PlanResult { reasons, ..PlanResult::unsolved(Status::GoalInvalid, Default::default()) };
        return Ok(Err(Planned::by(&to_goal(query.scene, &nearest.into())?, compiled.clone(), result)));
    }
    let mut chosen: Vec<Point> = Vec::new();
    let mut distance: Vec<f64> = found.iter().map(|place| -(place - before.position).norm()).collect();
    while chosen.len() < MOST_GOALS.min(found.len()) {
        let next = (0..found.len()).max_by(|a, b| distance[*a].total_cmp(&distance[*b]).then(b.cmp(a)));
        let next = found[next.expect("there are some")];
        for (k, place) in found.iter().enumerate() {
            let own = (place - next).norm();
            distance[k] = if chosen.is_empty() { own } else { distance[k].min(own) };
        }
        chosen.push(next);
    }
    Ok(Ok(chosen.into_iter().map(PositionSource::from).collect()))
}

/// The points of a grid over a box, its corners among them.
fn grid([least, most]: &[Point; 2], count: usize) -> Vec<Point> {
    let flat = |axis: usize| least[axis] == most[axis];
    let steps = [0, 1, 2].map(|axis| if flat(axis) { 1 } else { count });
    let at = |axis: usize, k: usize| {
        if k + 1 == steps[axis] {
            most[axis]
        } else {
            least[axis] + (most[axis] - least[axis]) * (k as f64 / (count - 1) as f64)
        }
    };
    let mut points = Vec::with_capacity(steps.iter().product());
    for i in 0..steps[0] {
        for j in 0..steps[1] {
            points.extend((0..steps[2]).map(|k| Point::new(at(0, i), at(1, j), at(2, k))));
        }
    }
    points
}

/// How often the end of a path slides, at most, and how often a step is halved.
const SLIDES: usize = 50;
const HALVINGS: i32 = 20;

/// Moves the end of a path through a box towards the waypoint before it, and shortens the path, for as long as it becomes shorter by more than
/// a millionth.
fn slide_end(found: &mut Planned, region: &[Point; 2], watch: &Watch) -> Result<(), Error> {
    let (Some(compiled), Status::Solved) = (found.compiled.clone(), found.result.status) else { return Ok(()) };
    let via = found.result.route.as_ref().map_or(0, |route| route.via.last().copied().unwrap_or(0));
    let fixed = found.result.path[..via].to_vec();
    let mut leg = found.result.path[via..].to_vec();
    for _ in 0..SLIDES {
        let before = length(&found.scene, &leg);
        let Some(slid) = slid(&compiled, &leg, region) else { break };
        let shorter =
            unless_interrupted(in_time(shorten(&compiled, &slid, &Processing::StringPulling, watch)))?.flatten();
        leg = shorter.unwrap_or(slid);
        if length(&found.scene, &leg) > before * (1.0 - SLIDE_WORTH) || watch.check().is_err() {
            break;
        }
    }
    let path: Vec<Pose> = fixed.into_iter().chain(leg).collect();
    verified(&*compiled, &path)?;
    let [first, .., last] = &path[..] else { return Ok(()) };
    found.scene = found.scene.with_ends([*first, *last])?;
    found.result.cost = length(&found.scene, &path);
    found.result.path = path;
    Ok(())
}

/// A path is shorter if it is so by this share.
const SLIDE_WORTH: f64 = 1e-6;

/// The path with its end closer to the waypoint before it, if it can be.
fn slid(compiled: &CompiledScene, leg: &[Pose], region: &[Point; 2]) -> Option<Vec<Pose>> {
    let [kept @ .., before, end] = leg else { return None };
    let step: Vector = clamped(&before.position, region) - end.position;
    let shorter = |step: &Vector| {
        let to = Pose::new(clamped(&(end.position + step), region), end.orientation);
        let less = (to.position - before.position).norm() < (end.position - before.position).norm();
        (less && compiled.motion_valid(before, &to)).then_some(to)
    };
    let to = (0..HALVINGS).find_map(|k| shorter(&(step * 0.5_f64.powi(k))))?;
    let moved = if to.position == before.position && to.orientation == before.orientation {
        vec![*before]
    } else {
        vec![*before, to]
    };
    Some(kept.iter().copied().chain(moved).collect())
}
