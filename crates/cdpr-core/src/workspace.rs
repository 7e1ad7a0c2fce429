//! Where the platform can be at one orientation, at several or during turns, proved: boxes of positions of which all are valid, boxes of which
//! one condition forbids all, and what is left between them.
//!
//! A tree of boxes is divided level by level. A box is inside if it is outside of everything that the conditions forbid, and
//! bounds over the box show that the cables are neither too long nor too close to each other and that the required wrenches are
//! available. It is outside if a convex polyhedron of certainly forbidden positions contains it, or a bound shows that one
//! condition forbids all of it: the tests of the [proofs](crate::proof) that there is no path, without their margin. All other boxes
//! are divided, until they are small or time runs out; what is left then is undecided, except for the volumes that convex pieces
//! cut off (`cut`). So the volume of the valid positions is known to lie between two numbers.
//!
//! Subdivision with exact tests of boxes goes back to J.-P. Merlet, "Workspace-oriented methodology for designing a parallel
//! manipulator", ICRA 1996; for cables, to M. Gouttefarde, D. Daney and J.-P. Merlet, "Interval-analysis-based determination of the
//! wrench-feasible workspace of parallel cable-driven robots", IEEE Transactions on Robotics 27, 2011.

mod cut;
mod judge;
mod orientations;
mod parts;
mod report;
mod tree;
mod turns;
mod volume;

pub use orientations::{ValidAt, orientations_for};
pub use report::{Boxes, Cause, Extent, Interval, Oriented, Part, Share, Workspace};

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use web_time::Instant;

use crate::batch::{BatchOptions, Pace, answer_all};
use crate::compiled::CompiledScene;
use crate::error::{Error, ErrorClass};
use crate::geometry::Aabb;
use crate::limits::{CLOSEST_CUT, DIVIDING, MOST_WORKSPACE_BOXES, SUMMING, WORKSPACE_PARTS};
use crate::tolerances::FLAT;
use crate::watch::Watch;
use cut::{Cut, SMALL, cut};
use orientations::{Known, Orientations, Verdict};
use tree::{Kind, Tree, WHOLE};

/// How far a workspace is divided.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct WorkspaceOptions {
    /// Boxes are divided until their sides are at most this, m. By default, a 64th of the longest side of the whole, or with a
    /// deadline, as small as time allows.
    pub resolution: Option<f64>,
    /// At how many orientations positions have to be valid, if there are several.
    pub valid_at: ValidAt,
}

/// Why the division ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Ended {
    /// All boxes are decided, or as small as requested.
    Complete,
    /// Time ran out.
    Budget,
    /// The caller wanted to stop.
    Interrupted,
    /// There were too many boxes.
    TooManyBoxes,
}

/// A divided workspace, which [`Proved::workspace`] sums up.
pub struct Proved<'a> {
    /// The scene at each orientation.
    compiled: Vec<&'a CompiledScene>,
    valid_at: ValidAt,
    within: Aabb,
    tree: Tree,
    /// What is known about parts of undecided boxes.
    cuts: Vec<Cut>,
    ended: Ended,
}

impl Proved<'_> {
    /// The scene as compiled at each orientation.
    pub fn compiled(&self) -> &[&CompiledScene] {
        &self.compiled
    }
}

/// Where the platform of a scene can be, at the orientation of the scene, or at several, for each of which the scene is compiled. If
/// time runs out or the caller wants to stop, the rest is undecided.
///
/// # Errors
/// No orientation; a workspace that the platform does not fit into; a resolution that is not positive; [`Error::interrupted`] and
/// [`Error::out_of_time`] before the first box is judged.
///
/// # Example
/// ```
/// use cdpr_core::batch::BatchOptions;
/// use cdpr_core::workspace::{WorkspaceOptions, workspace};
/// use cdpr_core::{CompiledScene, Watch, testing};
/// let scene = testing::hard1();
/// let at = |scene| CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE);
/// let options = WorkspaceOptions { resolution: Some(0.2), ..WorkspaceOptions::default() };
/// let found = workspace(&[&at(scene.clone())?], &options, &BatchOptions::default())?;
/// assert!(0.0 < found.volume.min && found.volume.max < found.total);
///
/// let tilted = scene.turned([0.96, 0.28, 0.0, 0.0].into())?;
/// let both = workspace(&[&at(scene)?, &at(tilted)?], &options, &BatchOptions::default())?;
/// assert!(both.volume.min < found.volume.max);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn workspace(
    compiled: &[&CompiledScene],
    options: &WorkspaceOptions,
    batch: &BatchOptions,
) -> Result<Workspace, Error> {
    Ok(divided(compiled, options, batch)?.workspace())
}

/// The division of [`workspace`], which takes almost all of its time.
///
/// # Errors
/// The errors of [`workspace`].
pub fn divided<'a>(
    compiled: &[&'a CompiledScene],
    options: &WorkspaceOptions,
    batch: &BatchOptions,
) -> Result<Proved<'a>, Error> {
    let orientations = Orientations::new(compiled, options.valid_at, &batch.watch)?;
    let within = orientations.within();
    let longest = (within.max - within.min).max();
    let finest = match options.resolution {
        Some(resolution) if !(resolution > 0.0 && resolution.is_finite()) => {
            let problem = format!("found {resolution} m, expected a positive length");
            return Err(Error::invalid("resolution", problem));
        }
        Some(resolution) => resolution.max(FLAT),
        None if batch.watch.deadline.is_some() => FLAT,
        None => longest / WORKSPACE_PARTS,
    };
    let mut tree = Tree::new(within.min, within.max, finest);
    let first = BatchOptions { watch: batch.watch.part(DIVIDING), ..*batch };
    let (rest, ended) = divide(&mut tree, &orientations, &first, batch.watch.deadline)?;
    let batch = &BatchOptions { watch: leaving_time_to_sum_up(batch.watch, &tree), ..*batch };
    let (cuts, ended) = match ended {
        Ended::Interrupted => (Vec::new(), ended),
        _ if tree.dimension() < 3 => (Vec::new(), ended),
        _ => cuts(&tree, &orientations, &rest, ended, batch)?,
    };
    Ok(Proved { compiled: compiled.to_vec(), valid_at: options.valid_at, within, tree, cuts, ended })
}

/// An undecided box, and what is known of it.
type Rest = (u32, Arc<Known>);

/// What is known about parts of undecided boxes; less if time runs out or the caller wants to stop.
fn cuts(
    tree: &Tree,
    orientations: &Orientations,
    rest: &[Rest],
    ended: Ended,
    batch: &BatchOptions,
) -> Result<(Vec<Cut>, Ended), Error> {
    let mut cuts = vec![Cut::default(); rest.len()];
    let of = |k: usize, halvings: usize| cut(orientations, &tree.span(rest[k].0), &rest[k].1, halvings);
    let mut stopped = stop(answer_all(&mut cuts, |k| of(k, 0), Pace::WRENCHES, batch))?;
    // Again, ever more closely, those of which most is undecided.
    let closest = if batch.watch.deadline.is_some() { CLOSEST_CUT } else { 1 };
    for halvings in 1..=closest {
        if stopped.is_some() {
            break;
        }
        let left = |k: usize| tree.volume(rest[k].0) - cuts[k].decided();
        let mut coarse: Vec<usize> = (0..rest.len()).filter(|k| left(*k) > SMALL * tree.volume(rest[*k].0)).collect();
        coarse.sort_by(|a, b| left(*b).total_cmp(&left(*a)));
        let mut finer = vec![None; coarse.len()];
        stopped = stop(answer_all(&mut finer, |k| Some(of(coarse[k], halvings)), Pace::WRENCHES, batch))?;
        for (k, finer) in coarse.into_iter().zip(finer) {
            cuts[k] = finer.unwrap_or(std::mem::take(&mut cuts[k]));
        }
    }
    Ok((cuts, stopped.unwrap_or(ended)))
}

/// Why work ended early, if it did.
fn stop(stopped: Result<(), Error>) -> Result<Option<Ended>, Error> {
    match stopped {
        Err(error) if error.class() == ErrorClass::OutOfTime => Ok(Some(Ended::Budget)),
        Err(error) if error.class() == ErrorClass::Interrupted => Ok(Some(Ended::Interrupted)),
        other => other.map(|()| None),
    }
}

/// A watch that leaves time to sum up the boxes before its deadline.
fn leaving_time_to_sum_up<'a>(watch: Watch<'a>, tree: &Tree) -> Watch<'a> {
    let before = |deadline: Instant| deadline.checked_sub(SUMMING * tree.len() as u32).unwrap_or(deadline);
    Watch { deadline: watch.deadline.map(before), ..watch }
}

/// Judges and divides boxes, all of one size before any smaller one, as long as time is left to sum them up before `end`. Returns the
/// boxes that are left.
fn divide(
    tree: &mut Tree,
    orientations: &Orientations,
    batch: &BatchOptions,
    end: Option<Instant>,
) -> Result<(Vec<Rest>, Ended), Error> {
    let mut level = vec![(WHOLE, Arc::new(orientations.all()))];
    let mut rest = Vec::new();
    while !level.is_empty() {
        let mut verdicts: Vec<Option<Verdict>> = (0..level.len()).map(|_| None).collect();
        let judged = |k: usize| Some(orientations.judged(&tree.span(level[k].0), &level[k].1));
        let whole = leaving_time_to_sum_up(Watch { deadline: end, ..batch.watch }, tree);
        let deadline = [batch.watch.deadline, whole.deadline].into_iter().flatten().min();
        let in_time = BatchOptions { watch: Watch { deadline, ..batch.watch }, ..*batch };
        let stopped = answer_all(&mut verdicts, judged, Pace::WRENCHES, &in_time);
        let mut next = Vec::new();
        for ((node, open), verdict) in level.drain(..).zip(verdicts) {
            match verdict {
                Some(Verdict::Inside) => tree.settle(node, Kind::Inside),
                Some(Verdict::Outside(condition)) => tree.settle(node, Kind::Outside(condition)),
                Some(Verdict::Open(open)) if !tree.is_finest(node) => next.push((node, Arc::new(open))),
                Some(Verdict::Open(open)) => rest.push((node, Arc::new(open))),
                None => rest.push((node, open)),
            }
        }
        let too_many = tree.len() + 8 * next.len() > MOST_WORKSPACE_BOXES;
        let ended = stop(stopped)?.or(too_many.then_some(Ended::TooManyBoxes));
        if let Some(ended) = ended {
            rest.extend(next);
            return Ok((rest, ended));
        }
        for (node, open) in next {
            level.extend(tree.divide(node).map(|part| (part, open.clone())));
        }
    }
    Ok((rest, Ended::Complete))
}
