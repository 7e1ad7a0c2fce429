//! How far a motion is from the path that it follows.

use super::faults::{FaultKind, Faults, Instant};
use super::recorded::Recorded;
use crate::error::Error;
use crate::geometry::{Point, segment_segment};
use crate::tolerances::{RECORDED_EXCESS, RECORDED_ROUNDING};
use crate::watch::Watch;

/// Whether the platform's origin is never farther from a path than `most`, m; of a platform that turns, only the position counts.
pub fn check(motion: &Recorded, path: &[Point], most: f64, faults: &mut Faults, watch: &Watch) -> Result<(), Error> {
    let allowed = most * (1.0 + RECORDED_EXCESS) + RECORDED_ROUNDING;
    let Some(end) = path.len().checked_sub(1) else { return Ok(()) };
    let (segments, mut last) = (end.max(1), 0);
    for (step, (time, position)) in motion.times.iter().zip(&motion.positions).enumerate() {
        watch.check()?;
        // A motion goes from segment to segment, so the current or the next one is near; any other that is near enough
        // will do as well.
        let distance =
            |k: usize| segment_segment::closest(position, position, &path[k], &path[(k + 1).min(end)]).distance;
        let near = (last..segments).find(|segment| distance(*segment) <= allowed);
        if let Some(segment) = near.or_else(|| (0..last).find(|segment| distance(*segment) <= allowed)) {
            last = segment;
            continue;
        }
        let found = (0..segments).map(distance).fold(f64::INFINITY, f64::min);
        let (kind, time) = (FaultKind::Deviation, *time);
        let instant =
            Instant { step, time, kind, culprits: &[], found: Some(found), limit: Some(most), excess: found - most };
        faults.add(&instant, || {
            format!("{:.3} mm away from the path, at most {:.3} mm allowed", 1e3 * found, 1e3 * most)
        });
    }
    Ok(())
}
