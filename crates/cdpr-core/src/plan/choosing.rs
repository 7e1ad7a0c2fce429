//! Planning for scenes that list several orientations and select none.

use super::query::{Observer, Query};
use super::result::Searches;
use super::{Improved, PlanOptions, Planned, lower_bound, plan_held, plan_within};
use crate::error::{Error, ErrorClass};
use crate::geometry::Point;
use crate::planning::Status;
use crate::watch::Watch;

/// Plans at each of the scene's orientations; see [`super::plan`].
pub fn plan_choosing(query: &Query, options: &PlanOptions, observer: &dyn Observer) -> Result<Planned, Error> {
    let interrupted = || observer.interrupted();
    let observed = |seconds: f64, cost: f64, path: &[Point]| observer.improved(seconds, cost, path);
    let whole = options.watch(&interrupted);
    let choices = query.scene.choices();
    let mut best: Option<Planned> = None;
    let mut searches = Searches::default();
    for (k, scene) in choices.iter().enumerate() {
        let share = whole.left().map(|left| left / (choices.len() - k) as u32);
        let watch = Watch::on(&interrupted).with_budget(share);
        let shortest = best.as_ref().map_or(f64::INFINITY, Planned::length);
        let improved = searches.shorter_than(shortest, &observed);
        let mut found = match at_one(&Query { scene, ..*query }, options, shortest, &watch, &improved) {
            Ok(Some(found)) => found,
            Ok(None) => continue,
            Err(stopped) if stopped.class() == ErrorClass::Interrupted && best.is_some() => break,
            Err(error) => return Err(error),
        };
        searches.add(&mut found.result);
        best = Some(match best {
            Some(best) if !found.better_than(&best) => best,
            _ => found,
        });
        if interrupted() {
            break;
        }
    }
    let mut best = best.expect("the first of the orientations is always planned");
    best.result.stats = searches.stats();
    Ok(best)
}

/// Plans at one orientation; `None` if no path there can be shorter than the shortest so far.
fn at_one(
    query: &Query,
    options: &PlanOptions,
    shortest: f64,
    watch: &Watch,
    improved: &Improved,
) -> Result<Option<Planned>, Error> {
    if shortest == f64::INFINITY {
        return plan_within(query, options, watch, improved).map(Some);
    }
    if query.turns() {
        return plan_within(query, options, watch, improved).map(Some);
    }
    let Some(compiled) = query.compile(options, watch)? else { return Ok(None) };
    let [start, goal] = query.ends()?;
    if lower_bound(compiled.level(), &start, &goal, watch)? >= shortest {
        return Ok(None);
    }
    let result = plan_held(&compiled, query, options, watch, improved)?;
    Ok(Some(Planned::by(query.scene, compiled, result)))
}

impl Planned {
    /// Length of the path, m; infinite if there is none.
    pub(super) fn length(&self) -> f64 {
        if self.result.status == Status::Solved { self.result.cost } else { f64::INFINITY }
    }

    /// Whether this result is better: the shorter path or, without paths, the more informative status.
    pub(super) fn better_than(&self, other: &Planned) -> bool {
        let rank = |status: Status| match status {
            Status::Solved => 0,
            Status::BudgetSpent | Status::Interrupted => 1,
            Status::NoPath => 2,
            Status::GoalInvalid => 3,
            Status::StartInvalid => 4,
        };
        let (own, others) = (rank(self.result.status), rank(other.result.status));
        own < others || own == others && self.length() < other.length()
    }
}
