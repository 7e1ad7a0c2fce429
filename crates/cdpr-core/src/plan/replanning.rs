//! Planning with a path of an earlier scene, of which an obstacle has moved.
//!
//! Motions of the path that are still valid are kept. Each gap between them is closed by a search from the last valid waypoint
//! before it to the first one after it. The whole path is then shortened, so it may become shorter where an obstacle has gone.

use super::result::Searches;
use super::{FoundBy, Observer, PlanOptions, PlanResult, Planned, Post, Processing, Query, plan, shorten};
use crate::collision::Validity;
use crate::compiled::{CompiledScene, length};
use crate::error::Error;
use crate::geometry::Pose;
use crate::planning::Status;
use crate::watch::{Watch, in_time, unless_interrupted};

/// Plans from the first to the last waypoint of a path, and keeps what is still valid of it. If the rest cannot be repaired, the path
/// is planned anew, as by [`plan`]. The start and the goal of the query are not used.
///
/// The post-processing is that of the options or of the planner; a planner without any pulls the string.
///
/// # Errors
/// A path of fewer than two waypoints; the errors of [`plan`].
///
/// # Example
/// ```
/// use cdpr_core::plan::{FoundBy, replan};
/// use cdpr_core::{PlanOptions, Query, Status, plan};
/// let scene = cdpr_core::testing::hard3();
/// let path = plan(&scene, &PlanOptions::default(), &())?.result.path;
/// let place = scene.place_of("west").unwrap();
/// let moved = scene.moved("west", [place.x + 0.05, place.y, place.z].into())?;
/// let found = replan(&moved, &path, &PlanOptions::default(), &())?.result;
/// assert_eq!(found.status, Status::Solved);
/// assert!(matches!(found.found_by, FoundBy::Kept | FoundBy::Repaired));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn replan<'q>(
    query: impl Into<Query<'q>>,
    path: &[Pose],
    options: &PlanOptions,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    let query = query.into();
    let [start, .., goal] = path else {
        return Err(Error::invalid("path", format!("found {} waypoints, expected at least two", path.len())));
    };
    let query = query.between(start, goal);
    let interrupted = || observer.interrupted();
    let watch = options.watch(&interrupted);
    match unless_interrupted(replan_within(&query, path, options, &watch, observer))? {
        Some(planned) => Ok(planned),
        None => Ok(Planned { scene: query.scene.clone(), compiled: None, result: PlanResult::interrupted() }),
    }
}

fn replan_within(
    query: &Query,
    path: &[Pose],
    options: &PlanOptions,
    watch: &Watch,
    observer: &dyn Observer,
) -> Result<Planned, Error> {
    let Some(compiled) = query.compile(options, watch)? else { return Ok(Planned::out_of_time(query.scene)) };
    compiled.ready_for(path)?;
    let query = query.by(&compiled);
    let mut searches = Searches::default();
    let Some(whole) = in_time(mended(&query, &compiled, path, options, watch, &mut searches))?.flatten() else {
        let options = PlanOptions { budget: watch.left(), ..options.clone() };
        return plan(query, &options, observer);
    };
    let shorter = shorten(&compiled, &whole, &processing(options)?, watch);
    let shorter = unless_interrupted(in_time(shorter))?.flatten().unwrap_or_else(|| whole.clone());
    let result = PlanResult {
        found_by: if whole == path { FoundBy::Kept } else { FoundBy::Repaired },
        cost: length(query.scene, &shorter),
        path: shorter,
        raw_cost: length(query.scene, &whole),
        raw_path: whole,
        ..PlanResult::unsolved(Status::Solved, searches.stats())
    };
    Ok(Planned::by(query.scene, compiled.clone(), result))
}

/// The path with its gaps closed; `None` if an end is not valid or a gap stays open.
fn mended(
    query: &Query,
    compiled: &CompiledScene,
    path: &[Pose],
    options: &PlanOptions,
    watch: &Watch,
    searches: &mut Searches,
) -> Result<Option<Vec<Pose>>, Error> {
    if !compiled.state_valid(&path[0]) {
        return Ok(None);
    }
    let mut whole = vec![path[0]];
    let mut here = 0;
    while here + 1 < path.len() {
        watch.check()?;
        let Some(next) = (here + 1..path.len()).find(|&k| compiled.state_valid(&path[k])) else { return Ok(None) };
        if next > here + 1 || !compiled.motion_valid(&path[here], &path[next]) {
            // Without a budget of its own: the anytime planner would use it up for one gap.
            let options = PlanOptions { budget: None, post: Some(Post::None), ..options.clone() };
            let gap = query.between(&path[here], &path[next]);
            let stop = || !matches!(watch.expired(), Ok(false));
            let mut found = plan(gap, &options, &stop)?.result;
            watch.check()?;
            searches.add(&mut found);
            if found.status != Status::Solved {
                return Ok(None);
            }
            whole.extend(&found.path[1..found.path.len() - 1]);
        }
        whole.push(path[next]);
        here = next;
    }
    Ok(Some(whole))
}

fn processing(options: &PlanOptions) -> Result<Processing, Error> {
    let post = match (options.post, options.post()) {
        (None, Post::None) => Post::StringPulling,
        (_, post) => post,
    };
    post.processing(options.step, options.repeats)
}
