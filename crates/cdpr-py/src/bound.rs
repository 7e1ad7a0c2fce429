//! Lower bounds of the length of paths, and their certificates.

use std::sync::Arc;
use std::time::Duration;

use cdpr_core::certificate::BoundCertificate;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::Point;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::path::length;
use cdpr_core::plan::{PlanOptions, Query, lower_bound, plan};
use cdpr_core::planning::{Planner, PlannerOptions, PlannerSettings, Status};
use cdpr_core::proof::no_bounded_path;
use cdpr_core::tolerances::BOUND_GAP;
use cdpr_core::watch::{Interrupt, Watch, in_time};
use cdpr_core::{Error, Scene};

use crate::convert::serialized;

/// How tight the bound should be (relative gap to a path that is searched for), how long that search may take, and whether to
/// certify the bound.
#[derive(Clone, Copy)]
pub struct Wanted {
    pub gap: Option<f64>,
    pub budget: Option<Duration>,
    pub certified: bool,
}

/// The bound, m, and the JSON of its certificate.
pub type Bounded = (f64, Option<String>);

/// The lower bound on the length of every path between two positions at any of a scene's orientations.
pub fn least_bound(scene: &Scene, ends: [&Point; 2], wanted: Wanted, stop: &Interrupt) -> Result<Bounded, Error> {
    let choices = scene.choices();
    let options = search_options(wanted, choices.len() as u32)?;
    let bound = |scene| bound_at(scene, ends, &options, wanted, stop);
    let bounds = choices.iter().map(bound).collect::<Result<Vec<Bounded>, Error>>()?;
    let least = bounds.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    Ok(least.unwrap_or((f64::INFINITY, None)))
}

/// Options of the search for a path and its bound. The orientations share the budget.
fn search_options(wanted: Wanted, orientations: u32) -> Result<PlanOptions, Error> {
    let settings =
        PlannerSettings { gap: wanted.gap.or(wanted.budget.map(|_| BOUND_GAP)), ..PlannerSettings::default() };
    let planner = PlannerOptions::new(Planner::Anytime, PlanOptions::default().step, &settings)?;
    Ok(PlanOptions { planner, budget: wanted.budget.map(|budget| budget / orientations), ..PlanOptions::default() })
}

fn bound_at(
    scene: &Scene,
    [start, goal]: [&Point; 2],
    options: &PlanOptions,
    wanted: Wanted,
    stop: &Interrupt,
) -> Result<Bounded, Error> {
    let watch = Watch::on(stop);
    let query = Query { start: Some(*start), goal: Some(*goal), ..Query::of(scene) };
    if query.turns() {
        return Ok((length(scene, &query.poses()?), None));
    }
    let compiled = Arc::new(CompiledScene::new(scene, Engine::default(), Interference::default(), &watch)?);
    let engine = compiled.level();
    let mut best = lower_bound(engine, start, goal, &watch)?;
    if (wanted.gap.is_some() || wanted.budget.is_some()) && best.is_finite() {
        let found = plan(query.by(&compiled), options, &|| stop())?.result.unless_interrupted()?;
        // The proof that there is no path has a larger margin than bounds: a path may be left that keeps only the smaller one.
        let limited = watch.with_budget(options.budget);
        let none = found.status == Status::NoPath
            && in_time(no_bounded_path(engine, [start, goal], &limited))?.unwrap_or(false);
        let otherwise = if none { f64::INFINITY } else { best };
        best = found.lower_bound.map_or(otherwise, |bound| bound.max(best));
    }
    if !wanted.certified || best.is_infinite() {
        return Ok((best, None));
    }
    let asked = scene.with_ends(query.poses()?)?;
    let accepts = |certificate: &BoundCertificate, watch: &Watch| {
        cdpr_certify::check_bound(&asked, &serialized(certificate), watch).is_ok()
    };
    let forbidden = Forbidden::new(engine, [start, goal], &watch)?;
    let certificate = forbidden.accepted_certificate(scene, best, &accepts, &watch)?;
    let proved = certificate.as_ref().map_or(best, |certificate| certificate.length);
    Ok((proved, certificate.as_ref().map(serialized)))
}
