//! The wrench margins and tensions of a path.

use super::along::{Place, segments};
use crate::batch::each;
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::model::Scene;
use crate::turning::TurningWrench;
use crate::watch::Watch;
use crate::wrench::report::{MarginPlace, Mark, TensionRange, even_marks};
use crate::wrench::{Loads, Measure, PathWrench, Statics, TensionQp, least_slack, limit_at, measures};

/// Number of steps into which a path is divided to find the range of tensions.
const RANGE_STEPS: f64 = 1000.0;

/// The smallest wrench margin of a path and its range of tensions; `None` if the scene requires no wrenches.
///
/// Tensions are evaluated at a thousand equal steps and at the waypoints. If the platform keeps its orientation,
/// margins are minima to within [`crate::tolerances::LEAST_SLACK_RELATIVE`]; if it turns, they are evaluated at the
/// same places as tensions, and may be smaller between them.
///
/// # Errors
/// The errors of [`measures`] and [`TurningWrench::of`]; a solver that reached no answer; [`Error::interrupted`], [`Error::out_of_time`].
pub fn wrench_of(scene: &Scene, path: &[Pose], watch: &Watch) -> Result<Option<PathWrench>, Error> {
    match scene.keeps_orientation(path) {
        true => while_held(scene, path, watch),
        false => while_turning(scene, path, watch),
    }
}

fn while_held(scene: &Scene, path: &[Pose], watch: &Watch) -> Result<Option<PathWrench>, Error> {
    let measures = measures(scene)?;
    let mut least = Vec::new();
    for measure in &measures {
        for (segment, pair) in path.windows(2).enumerate() {
            watch.check()?;
            least.push((measure, (segment, least_slack(measure, &pair[0].position, &pair[1].position))));
        }
    }
    // NaN, from a cable without direction, counts as smaller than anything.
    let rank = |value: f64| if value.is_nan() { f64::NEG_INFINITY } else { value };
    let scarcest = least.into_iter().min_by(|(_, (_, (a, _))), (_, (_, (b, _)))| rank(*a).total_cmp(&rank(*b)));
    let Some((measure, (segment, (_, at)))) = scarcest else { return Ok(None) };
    let (from, to): (Point, Point) = (path[segment].position, path[segment + 1].position);
    let limit = limit_at(measure, &(from + (to - from) * at));
    let mut cases: Vec<&Statics> = measures.iter().map(Measure::statics).collect();
    cases.dedup_by_key(|statics| statics.load_case());
    let places = places(scene, path)?;
    let tensions = each(cases.len() * places.len(), 0, &|solver: &mut TensionQp, k| {
        watch.check()?;
        cases[k / places.len()].tensions(solver, &places[k % places.len()].pose.position, None)
    })?;
    let at_places = places.iter().map(|place| (place.segment, place.at)).cycle();
    Ok(Some(PathWrench {
        min_wrench_margin: MarginPlace { value: limit.wrench_margin, segment, at, limit },
        tension_range: TensionRange::of(cases[0], at_places.zip(tensions)),
    }))
}

fn while_turning(scene: &Scene, path: &[Pose], watch: &Watch) -> Result<Option<PathWrench>, Error> {
    let Some(wrench) = TurningWrench::of(scene)? else { return Ok(None) };
    let (loads, places) = (Loads::cases(scene), places(scene, path)?);
    let found = each(places.len(), 0, &|solver: &mut TensionQp, k| {
        watch.check()?;
        let pose = &places[k].pose;
        let mut tensions = Vec::with_capacity(loads.len());
        for loads in &loads {
            let statics = Statics::new(scene.robot(), &loads.at(&pose.orientation))?;
            tensions.push(statics.tensions(solver, &pose.position, None)?);
        }
        Ok((wrench.least_at(pose), tensions))
    })?;
    let (limits, tensions): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    let at_places = || places.iter().map(|place| (place.segment, place.at));
    let of_cases = at_places().zip(tensions).flat_map(|(at, cases)| cases.into_iter().map(move |found| (at, found)));
    let known = at_places().zip(limits).filter_map(|(place, limit)| Some((place, limit?)));
    let least = known.min_by(|(_, a), (_, b)| a.order().total_cmp(&b.order()));
    let Some(((segment, at), limit)) = least else { return Ok(None) };
    Ok(Some(PathWrench {
        min_wrench_margin: MarginPlace { value: limit.wrench_margin, segment, at, limit },
        tension_range: TensionRange::of(&Statics::of(scene)?, of_cases),
    }))
}

/// Equal steps along a path, and its waypoints.
fn places(scene: &Scene, path: &[Pose]) -> Result<Vec<Place>, Error> {
    let lengths = segments(scene, path);
    let length: f64 = lengths.iter().sum();
    let mut marks = if length > 0.0 { even_marks(&lengths, length / RANGE_STEPS)? } else { Vec::new() };
    marks.extend((0..path.len()).map(|k| {
        let segment = k.min(path.len().saturating_sub(2));
        Mark { s: 0.0, segment, at: (k - segment) as f64 }
    }));
    Ok(marks.into_iter().map(|mark| Place::on(path, mark)).collect())
}
