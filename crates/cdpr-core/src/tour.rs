//! Tours of the stations of a scene: the paths between them, and the order with the shortest way or the least time.
//!
//! All pairs are planned, in parallel, in the scene as compiled once. A path also holds backwards, so a pair is planned once. The
//! order is then a question about lengths alone, or about the durations of motions that stop at every station ([`LegTime`]). A lower bound
//! for every tour, in any order and along any paths, follows from the lower bounds of the pairs.

mod leg_time;
mod order;
mod tour_file;

use std::sync::Arc;

use crate::batch::Told;
use crate::choices;
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::Pose;
use crate::model::spec::MotionSpec;
use crate::model::{PositionSource, Scene, Station};
use crate::path::length;
use crate::plan::{PlanOptions, Query, plan_each, quick_bound};
use crate::planning::Status;
use crate::trajectory::checked_limits;
use crate::watch::{Interrupt, Watch};
pub use leg_time::LegTime;
pub use tour_file::{PairKeys, PairTimeKeys, TourFile, TourKeys, TourTimeKeys};

use leg_time::{bounds_curves, least_duration};

use order::{Lengths, least_length, short_tour};

/// How the order of a tour is chosen.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Order {
    /// The shortest way, or the least time: proved to be so up to 12 stations, otherwise the best that a search found.
    #[default]
    Best,
    /// As the stations are listed.
    Given,
}

choices!(Order, "order", [
    Best = "best": "The order with the shortest way, or the least time",
    Given = "given": "The order in which the stations are listed",
]);

/// What makes one order better than another.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum By {
    /// The length of the way.
    #[default]
    Length,
    /// The duration of the motions along it, from rest at one station to rest at the next.
    Time,
}

choices!(By, "by", [
    Length = "length": "The length of the way",
    Time = "time": "The duration of the motions along it, from rest at one station to rest at the next",
]);

/// What a tour is to be.
#[derive(Debug, Clone, Default)]
pub struct TourOptions {
    /// Names of the stations to visit; all of the scene's if not given.
    pub stations: Option<Vec<String>>,
    /// Name of the station where it starts, one of those to visit; if none is given, and the order is free, the best one.
    pub start: Option<String>,
    /// Whether the tour returns to its start.
    pub returns: bool,
    /// How the order is chosen.
    pub order: Order,
    /// What makes one order better than another.
    pub by: By,
    /// If tours are compared by time: limits that replace those of the scene where they are set.
    pub limits: MotionSpec,
    /// Number of threads; all if not given.
    pub threads: Option<usize>,
}

/// The path between two stations.
#[derive(Debug, Clone, PartialEq)]
pub struct Leg {
    /// How planning ended.
    pub status: Status,
    /// Length of the path, m; infinite without one.
    pub cost: f64,
    /// Lower bound on the length of every path between both, m; infinite if it is certain that there is none.
    pub lower_bound: f64,
    /// The path from the first to the second; empty without one.
    pub path: Vec<Pose>,
    /// The time along the path, if tours are compared by time.
    pub time: Option<LegTime>,
}

impl Leg {
    /// What tours are compared by: seconds if they are compared by time, otherwise metres.
    pub fn weight(&self) -> f64 {
        self.time.as_ref().map_or(self.cost, |time| time.duration)
    }

    /// A lower bound of [`Leg::weight`], in the same unit.
    pub fn least_weight(&self) -> f64 {
        self.time.as_ref().map_or(self.lower_bound, |time| time.lower_bound)
    }
}

/// The legs between all pairs of stations that were planned.
#[derive(Debug, Clone, PartialEq)]
pub struct Legs {
    /// The stations, as listed.
    pub stations: Vec<Station>,
    /// Pairs of indices of stations, the smaller first.
    pub pairs: Vec<[usize; 2]>,
    /// The leg of each pair.
    pub legs: Vec<Leg>,
}

/// A tour: a path through stations.
#[derive(Debug, Clone, PartialEq)]
pub struct Tour {
    /// All legs that were planned.
    pub legs: Legs,
    /// Indices of the stations in the order of the tour; the first one again at the end if it returns.
    pub order: Vec<usize>,
    /// Length, m; infinite if there is no tour.
    pub cost: f64,
    /// No tour is shorter, m, in any order or, if that is given, in this one; infinite if it is certain that there is none.
    pub lower_bound: f64,
    /// Duration and lower bound of the duration of every tour, s, with the stops at stations, if tours are compared by time; infinite as
    /// the lengths are.
    pub time: Option<[f64; 2]>,
    /// The path through all stations; empty if there is no tour.
    pub path: Vec<Pose>,
    /// For each station of `order`, the index of its waypoint.
    pub stops: Vec<usize>,
}

impl Legs {
    /// The leg between two different stations, and whether it is to be followed backwards.
    pub fn between(&self, from: usize, to: usize) -> Option<(&Leg, bool)> {
        let pair = [from.min(to), from.max(to)];
        let k = self.pairs.binary_search(&pair).ok()?;
        Some((&self.legs[k], from > to))
    }

    fn lengths(&self, of: impl Fn(&Leg) -> f64) -> Lengths {
        Lengths::new(self.stations.len(), |i, j| self.between(i, j).map_or(f64::INFINITY, |(leg, _)| of(leg)))
    }
}

/// The stations of a tour, in the order in which they are listed.
///
/// # Errors
/// Fewer than two stations, an unknown name, or one that is listed twice.
pub fn stations(scene: &Scene, names: Option<&[String]>) -> Result<Vec<Station>, Error> {
    let known = scene.stations();
    let mut listed: Vec<Station> = if names.is_none() { known.to_vec() } else { Vec::new() };
    for name in names.unwrap_or_default() {
        scene.named_position("stations", &PositionSource::Named(name.clone()))?;
        if listed.iter().any(|station| station.name == *name) {
            return Err(Error::invalid("stations", format!("found \"{name}\" twice, expected each station once")));
        }
        listed.extend(known.iter().find(|station| station.name == *name).cloned());
    }
    if listed.len() < 2 {
        let found = if listed.is_empty() { "none" } else { "one" };
        return Err(Error::invalid("stations", format!("found {found}, expected at least two: a tour has legs")));
    }
    Ok(listed)
}

/// Plans a tour of stations. `compiled` is its scene; `told` is called with the number of planned pairs.
///
/// # Errors
/// The errors of [`stations`] and [`plan_each`], a start that is not visited, a scene that selects none of its orientations.
///
/// # Example
/// ```
/// use std::sync::Arc;
/// use cdpr_core::model::{Scene, SceneSpec, StationSpec};
/// use cdpr_core::{CompiledScene, PlanOptions, TourOptions, Watch, plan_tour};
/// let station = |name: &str, x: f64, z: f64| StationSpec { name: name.to_string(), position: [x, 1.0, z], orientation: None };
/// let stations = vec![station("dock", 0.3, 0.3), station("rack", 1.7, 1.7), station("shelf", 0.3, 1.5)];
/// let scene = Scene::new(SceneSpec { stations, ..cdpr_core::testing::hard1().spec().clone() })?;
/// let compiled = Arc::new(CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?);
/// let tour = plan_tour(&compiled, &TourOptions::default(), &PlanOptions::default(), &|| false, &|_, _| ())?;
/// let names: Vec<&str> = tour.order.iter().map(|stop| tour.legs.stations[*stop].name.as_str()).collect();
/// assert_eq!(names, ["dock", "shelf", "rack"]);
/// assert!((tour.cost - 1.2 - 1.4142).abs() < 0.1 && tour.lower_bound <= tour.cost);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan_tour(
    compiled: &Arc<CompiledScene>,
    wanted: &TourOptions,
    options: &PlanOptions,
    stop: &Interrupt,
    told: &Told,
) -> Result<Tour, Error> {
    let scene = compiled.scene();
    if scene.orientation_is_open() {
        let problem = "found a scene that selects none, expected one: the legs of a tour must fit together";
        return Err(Error::invalid("orientation", problem));
    }
    let stations = stations(scene, wanted.stations.as_deref())?;
    let start = start_of(&stations, wanted)?;
    let count = stations.len();
    let pairs = match wanted.order {
        Order::Best => (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j])).collect(),
        Order::Given => consecutive(count, start.unwrap_or(0), wanted.returns),
    };
    if wanted.by == By::Time {
        let pose = |station: &Station| Pose::new(station.position, station.orientation.unwrap_or(*scene.orientation()));
        let pairs = stations.windows(2).map(|pair| (scene, [pose(&pair[0]), pose(&pair[1])]));
        checked_limits(scene, &wanted.limits, pairs)?;
    }
    let legs = planned_legs(compiled, stations, pairs, (options, wanted), stop, told)?;
    let order = match wanted.order {
        Order::Given => listed(count, start.unwrap_or(0)),
        Order::Best => best_order(&legs.lengths(Leg::weight), start, wanted.returns),
    };
    let order = closed(&order, wanted.returns);
    let bound = |of: &dyn Fn(&Leg) -> f64| match wanted.order {
        Order::Given => along(&legs, &order, of),
        Order::Best => least(&legs.lengths(of), start, wanted.returns),
    };
    let bounds = (bound(&|leg| leg.lower_bound), (wanted.by == By::Time).then(|| bound(&Leg::least_weight)));
    Ok(joined(legs, order, bounds))
}

fn start_of(stations: &[Station], wanted: &TourOptions) -> Result<Option<usize>, Error> {
    let Some(name) = &wanted.start else { return Ok(None) };
    let found = stations.iter().position(|station| station.name == *name);
    found.map(Some).ok_or_else(|| {
        let names: Vec<&str> = stations.iter().map(|station| station.name.as_str()).collect();
        Error::invalid(
            "start",
            format!("found \"{name}\", expected one of the stations of the tour ({})", names.join(", ")),
        )
    })
}

/// The stations as listed, from the start on.
fn listed(count: usize, start: usize) -> Vec<usize> {
    (0..count).map(|k| (start + k) % count).collect()
}

fn closed(order: &[usize], returns: bool) -> Vec<usize> {
    let again = order.first().filter(|_| returns);
    order.iter().chain(again).copied().collect()
}

/// The pairs of a tour in the listed order.
fn consecutive(count: usize, start: usize, returns: bool) -> Vec<[usize; 2]> {
    let order = closed(&listed(count, start), returns);
    let mut pairs: Vec<[usize; 2]> = order.windows(2).map(|leg| [leg[0].min(leg[1]), leg[0].max(leg[1])]).collect();
    pairs.sort_unstable();
    pairs.dedup(); // there and back between two stations
    pairs
}

fn planned_legs(
    compiled: &Arc<CompiledScene>,
    stations: Vec<Station>,
    pairs: Vec<[usize; 2]>,
    (options, wanted): (&PlanOptions, &TourOptions),
    stop: &Interrupt,
    told: &Told,
) -> Result<Legs, Error> {
    let scene = compiled.scene();
    let named = |k: usize| PositionSource::Named(stations[k].name.clone());
    let ends: Vec<[PositionSource; 2]> = pairs.iter().map(|[a, b]| [named(*a), named(*b)]).collect();
    let legs = plan_each(&Query::of(scene).by(compiled), &ends, options, wanted.threads, stop, told, &|_, planned| {
        let result = planned.result;
        let ends = Query::of(&planned.scene).poses()?;
        let lower_bound = match result.status {
            Status::NoPath | Status::StartInvalid | Status::GoalInvalid => f64::INFINITY,
            _ => {
                let quick = planned.compiled.as_ref().map(|compiled| quick_bound(compiled, &result, &Watch::on(stop)));
                let known = quick.transpose()?.flatten().or(result.lower_bound);
                known.unwrap_or_else(|| length(&planned.scene, &ends))
            }
        };
        let cost = if result.status == Status::Solved { result.cost } else { f64::INFINITY };
        let lower_bound = lower_bound.min(cost);
        let time = match wanted.by {
            By::Length => None,
            By::Time => {
                let limits = &wanted.limits;
                // With turns, a length contains more than what the origin moves.
                let moves =
                    !Query::of(&planned.scene).turns() && bounds_curves(&planned.scene, limits, options.interference)?;
                let length = if moves || lower_bound.is_infinite() { lower_bound } else { 0.0 };
                let least = least_duration(&planned.scene, limits, &ends, length)?;
                let compiled = planned.compiled.as_ref().unwrap_or(compiled);
                Some(LegTime::along(compiled, &result.path, limits, least, &Watch::on(stop))?)
            }
        };
        Ok(Leg { status: result.status, cost, lower_bound, path: result.path, time })
    })?;
    Ok(Legs { stations, pairs, legs })
}

/// The lengths of a closed tour that stands for one that may begin anywhere, or at a given stop, and ends anywhere: with one more
/// stop, next to the beginning and the end. If the beginning is given, that stop is far from all others, by the second return value,
/// which the tour then contains once.
fn opened(lengths: &Lengths, start: Option<usize>) -> (Lengths, f64) {
    let count = lengths.count();
    let finite = (0..count * count).map(|k| lengths.of(k / count, k % count)).filter(|length| length.is_finite());
    let far = if start.is_some() { 1.0 + count as f64 * finite.fold(0.0, f64::max) } else { 0.0 };
    let to_extra = |k: usize| if start == Some(k) { 0.0 } else { far };
    (Lengths::new(count + 1, |i, j| if j == count { to_extra(i) } else { lengths.of(i, j) }), far)
}

fn best_order(lengths: &Lengths, start: Option<usize>, returns: bool) -> Vec<usize> {
    let count = lengths.count();
    if returns {
        let mut order = short_tour(lengths);
        let first = order.iter().position(|stop| *stop == start.unwrap_or(0)).expect("every stop is visited");
        order.rotate_left(first);
        // Both directions are equally long: that of the station that is listed first.
        if order.last() < order.get(1) {
            order[1..].reverse();
        }
        return order;
    }
    let mut order = short_tour(&opened(lengths, start).0);
    let extra = order.iter().position(|stop| *stop == count).expect("every stop is visited");
    order.rotate_left(extra);
    order.remove(0);
    // Both directions are equally long: from the given start, or from the station that is listed first.
    let backwards = match start {
        Some(start) => order.last() == Some(&start),
        None => order.last() < order.first(),
    };
    if backwards {
        order.reverse();
    }
    order
}

fn least(lengths: &Lengths, start: Option<usize>, returns: bool) -> f64 {
    if returns {
        return least_length(lengths);
    }
    let (opened, far) = opened(lengths, start);
    (least_length(&opened) - far).max(0.0)
}

fn along(legs: &Legs, order: &[usize], of: &dyn Fn(&Leg) -> f64) -> f64 {
    order.windows(2).map(|leg| legs.between(leg[0], leg[1]).map_or(f64::INFINITY, |(leg, _)| of(leg))).sum()
}

/// The tour in an order; `bounds` are those of the length and, by time, of the duration.
fn joined(legs: Legs, order: Vec<usize>, (lower_bound, least_time): (f64, Option<f64>)) -> Tour {
    let weight = along(&legs, &order, &Leg::weight);
    let cost = if weight.is_finite() { along(&legs, &order, &|leg| leg.cost) } else { f64::INFINITY };
    let time = least_time.map(|least| [weight, least.min(weight)]);
    let (mut path, mut stops) = (Vec::new(), Vec::new());
    if cost.is_finite() {
        for pair in order.windows(2) {
            let (leg, backwards) = legs.between(pair[0], pair[1]).expect("its length is finite");
            let mut way = leg.path.clone();
            if backwards {
                way.reverse();
            }
            stops.push(path.len().max(1) - 1);
            path.extend(way.into_iter().skip(usize::from(!path.is_empty())));
        }
        stops.push(path.len() - 1);
    }
    Tour { legs, order, cost, lower_bound: lower_bound.min(cost), time, path, stops }
}
