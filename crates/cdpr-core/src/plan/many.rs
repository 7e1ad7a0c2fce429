//! Planning of many paths in one scene.

use super::{PlanOptions, Planned, Query, plan};
use crate::batch::{Told, each_long};
use crate::error::Error;
use crate::model::PositionSource;
use crate::watch::Interrupt;

/// Plans from each start to its goal, on the requested number of threads, and returns what `finished` makes of each answer, in
/// order. The scene of the query is not compiled again for ends at its orientation; its own start and goal are not used.
///
/// An interrupt ends each search with its best path so far, or the status "interrupted".
///
/// # Errors
/// The first error of [`plan`] or `finished`; its place begins with `paths[k]`.
///
/// # Example
/// ```
/// use cdpr_core::plan::{PlanOptions, Query, plan_each};
/// let scene = cdpr_core::testing::hard1();
/// let start = [0.3, 1.0, 0.3];
/// let ends = [[1.7, 1.0, 1.7], [1.7, 1.0, 0.3]].map(|goal| [start.into(), goal.into()]);
/// let costs = plan_each(&Query::of(&scene), &ends, &PlanOptions::default(), None, &|| false, &|_, _| (), &|_, planned| Ok(planned.result.cost))?;
/// assert!((costs[0] - 2.435167).abs() < 1e-3 && costs[1] > 3.4);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn plan_each<T: Send>(
    query: &Query,
    ends: &[[PositionSource; 2]],
    options: &PlanOptions,
    threads: Option<usize>,
    stop: &Interrupt,
    told: &Told,
    finished: &(dyn Fn(usize, Planned) -> Result<T, Error> + Sync),
) -> Result<Vec<T>, Error> {
    each_long(ends.len(), threads, told, &|k| {
        let in_row = |error: Error| error.below("query").under(&format!("paths[{k}]"));
        let asked = query.scene.clone().between(ends[k].clone().map(Some)).map_err(in_row)?;
        let compiled = query.compiled.filter(|_| asked.orientation() == query.scene.orientation());
        let planned = plan(Query { scene: &asked, compiled, ..*query }, options, &|| stop()).map_err(in_row)?;
        finished(k, planned)
    })
}
