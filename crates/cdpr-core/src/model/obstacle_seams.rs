//! Seams between obstacles, for members that are checked against all of them or only some.

use std::collections::HashSet;

use super::obstacle::Obstacle;
use super::pairs::PairRules;
use crate::geometry::Polytope;
use crate::geometry::seam::{Seam, seams};
use crate::tolerances::ON_SURFACE;

/// Bodies that close the seams between parts; each lists the indices of the obstacles that it lies between.
///
/// A member that ignores an obstacle is checked only against the seams between the others. So where parts meet an
/// obstacle that some member ignores, the seams that the other parts have without it are added.
pub(super) fn obstacle_seams(obstacles: &[Obstacle], pairs: &PairRules) -> Vec<Seam> {
    let parts: Vec<(usize, &Polytope)> =
        obstacles.iter().enumerate().flat_map(|(j, o)| o.parts.iter().map(move |part| (j, part))).collect();
    let mut found = seams_between(&parts);
    let identity = |Seam { body, between, .. }: &Seam| {
        let corners = body.vertices().iter().flat_map(|v| [v.x, v.y, v.z].map(f64::to_bits));
        (between.clone(), corners.collect::<Vec<u64>>())
    };
    let mut known: HashSet<_> = found.iter().map(identity).collect();
    for ignored in pairs.ignored_obstacles() {
        let meets = |part: &Polytope| {
            let others = ignored.iter().flat_map(|&j| &obstacles[j].parts);
            others.into_iter().any(|other| !part.aabb().apart_by(other.aabb(), ON_SURFACE))
        };
        let left = parts.iter().copied().filter(|(j, part)| !ignored.contains(j) && meets(part));
        let more = seams_between(&left.collect::<Vec<_>>());
        found.extend(more.into_iter().filter(|seam| known.insert(identity(seam))));
    }
    found
}

fn seams_between(parts: &[(usize, &Polytope)]) -> Vec<Seam> {
    let mut found = seams(&parts.iter().map(|(_, part)| *part).collect::<Vec<_>>());
    for Seam { between, .. } in &mut found {
        between.iter_mut().for_each(|k| *k = parts[*k].0);
        between.dedup();
    }
    found
}
