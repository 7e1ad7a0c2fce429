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
        };
        TourFile {
            path: PathFile::of(scene, &tour.path),
            tour: TourKeys {
                order: tour.order.iter().map(|stop| name(*stop)).collect(),
                stops: tour.stops.clone(),
                cost: tour.cost,
                lower_bound: tour.lower_bound,
                pairs: tour.legs.pairs.iter().zip(&tour.legs.legs).map(pair).collect(),
            },
        }
    }
}
