//! The JSON of a tour: a path file with one more key, so that everything that reads paths reads it.

use serde::Serialize;

use super::{Leg, Tour};
use crate::choice::Choice;
use crate::model::Scene;
use crate::path_file::PathFile;

/// A tour as a path file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TourFile {
    /// The path through all stations; without waypoints if there is no tour.
    #[serde(flatten)]
    pub path: PathFile,
    /// What the tour is.
    pub tour: TourKeys,
}

/// The keys of a tour.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TourKeys {
    /// Names of the stations in the order of the tour; the first one again at the end if it returns.
    pub order: Vec<String>,
    /// For each of these, the index of its waypoint.
    pub stops: Vec<usize>,
    /// Length of the tour, m; null if there is none.
    pub cost: f64,
    /// No tour is shorter, m; null if it is certain that there is none.
    pub lower_bound: f64,
    /// Duration of the tour, if tours are compared by time.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub time: Option<TourTimeKeys>,
    /// All pairs of stations that were planned.
    pub pairs: Vec<PairKeys>,
}

/// The keys of a pair of stations.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PairKeys {
    /// Names of both.
    pub between: [String; 2],
    /// How planning ended.
    pub status: String,
    /// Length of the path, m; null without one.
    pub cost: f64,
    /// No path is shorter, m; null if it is certain that there is none.
    pub lower_bound: f64,
    /// The time between both, if tours are compared by time.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub time: Option<PairTimeKeys>,
}

/// The keys of the duration of a tour.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TourTimeKeys {
    /// Duration of all motions, each from rest to rest, s; null if there is no tour.
    pub duration: f64,
    /// No tour takes less, s; null if it is certain that there is none.
    pub least_duration: f64,
}

/// The keys of the time between two stations.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PairTimeKeys {
    /// Duration of the motion, s; null without one.
    pub duration: f64,
    /// No motion takes less, s; null if it is certain that there is none.
    pub least_duration: f64,
    /// Why the path cannot be timed, if there is one.
    pub reason: Option<String>,
}

impl TourFile {
    /// A tour in a scene.
    pub fn of(scene: &Scene, tour: &Tour) -> Self {
        let name = |stop: usize| tour.legs.stations[stop].name.clone();
        let pair = |([from, to], leg): (&[usize; 2], &Leg)| PairKeys {
            between: [name(*from), name(*to)],
            status: leg.status.name().to_string(),
            cost: leg.cost,
            lower_bound: leg.lower_bound,
            time: leg.time.as_ref().map(|time| PairTimeKeys {
                duration: time.duration,
                least_duration: time.lower_bound,
                reason: time.reason.clone(),
            }),
        };
        TourFile {
            path: PathFile::of(scene, &tour.path),
            tour: TourKeys {
                order: tour.order.iter().map(|stop| name(*stop)).collect(),
                stops: tour.stops.clone(),
                cost: tour.cost,
                lower_bound: tour.lower_bound,
                time: tour.time.map(|[duration, least_duration]| TourTimeKeys { duration, least_duration }),
                pairs: tour.legs.pairs.iter().zip(&tour.legs.legs).map(pair).collect(),
            },
        }
    }
}
