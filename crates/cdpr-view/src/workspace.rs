//! Where the platform can be, as a picture: the surface of what is proved inside, and what takes the rest away.

use cdpr_core::Error;
use cdpr_core::geometry::Cuboid;
use cdpr_core::workspace::{Interval, Part, Share, ValidAt, Workspace};
use serde::Serialize;

use super::blocks::{Blocks, Cut, Face, as_fine_as_allowed};

/// The contents of a page about a proved workspace.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Shown<'a> {
    /// Bounds of the volume of all valid positions, m³.
    volume: Interval,
    /// Volume of the box of positions, m³.
    total: f64,
    /// The box of positions, m.
    bounds: [[f64; 3]; 2],
    /// Number of cubes along each axis of the box.
    count: usize,
    /// Surface of what is proved inside.
    inside: Vec<Face>,
    /// Number of connected parts of what is proved inside.
    parts: usize,
    /// Whether start and goal are in different parts.
    apart: bool,
    /// What takes the rest away, the largest share first.
    taken: Vec<Taken<'a>>,
    /// Number of orientations; the scene is drawn at the first.
    orientations: usize,
    /// At how many of several orientations positions are valid.
    valid_at: Option<ValidAt>,
}

/// What a kind of condition takes away.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Taken<'a> {
    condition: &'a str,
    /// Share of the box of positions.
    share: f64,
    /// The pair of bodies that takes most of it, and its share of the box of positions.
    worst: Option<(String, f64)>,
    /// Number of pairs.
    pairs: usize,
}

/// The picture of a workspace.
///
/// # Errors
/// A flat workspace, which has no surface.
pub(super) fn shown(found: &Workspace) -> Result<Shown<'_>, Error> {
    if found.dimension < 3 {
        let problem = "found a flat one, which has no surface to draw; expected three dimensions";
        return Err(Error::invalid("workspace", problem));
    }
    let bounds = cuboid(&found.within.min, &found.within.max);
    let (count, inside) = as_fine_as_allowed(|count| inside(found, &bounds, count), Vec::len);
    let holding = |end: fn(&Part) -> bool| found.parts.iter().position(end);
    let [start, goal] = [holding(|part| part.start), holding(|part| part.goal)];
    Ok(Shown {
        volume: found.volume,
        total: found.total,
        bounds: [found.within.min, found.within.max],
        count,
        inside,
        parts: found.parts.len(),
        apart: start.is_some() && goal.is_some() && start != goal,
        taken: taken(found),
        orientations: 1 + found.more_orientations.len(),
        valid_at: found.valid_at,
    })
}

fn taken(found: &Workspace) -> Vec<Taken<'_>> {
    let taken = |(condition, share): (_, &Share)| Taken {
        condition,
        share: share.share,
        worst: worst(share).map(|(names, volume)| (names.clone(), volume / found.total)),
        pairs: share.culprits.len(),
    };
    let mut all: Vec<Taken> =
        found.shares.iter().map(|(condition, share)| taken((condition.as_str(), share))).collect();
    all.sort_by(|a, b| b.share.total_cmp(&a.share));
    all
}

/// The pair of bodies that takes most, and its volume.
fn worst(share: &Share) -> Option<(&String, &f64)> {
    share.culprits.iter().max_by(|a, b| a.1.total_cmp(b.1))
}

fn inside(found: &Workspace, bounds: &Cuboid, count: usize) -> Vec<Face> {
    let mut blocks = Blocks::new(bounds, count);
    let boxes = found.boxes.lower.iter().zip(&found.boxes.upper).zip(&found.boxes.verdict);
    let valid = boxes.filter(|(_, verdict)| **verdict == 1);
    valid.for_each(|((lower, upper), _)| blocks.paint(&cuboid(lower, upper), Cut::AtCentres, 1));
    blocks.faces(1).remove(0)
}

fn cuboid(low: &[f64; 3], high: &[f64; 3]) -> Cuboid {
    Cuboid::new((*low).into(), (*high).into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::workspace::{WorkspaceOptions, workspace};
    use cdpr_core::{CompiledScene, Watch, testing};

    #[test]
    fn drawn_volume_lies_near_the_proved_one() {
        let compiled =
            CompiledScene::new(&testing::hard1(), Default::default(), Default::default(), &Watch::NONE).unwrap();
        let options = WorkspaceOptions { resolution: Some(0.05), ..WorkspaceOptions::default() };
        let found = workspace(&[&compiled], &options, &Default::default()).unwrap();
        let shown = shown(&found).unwrap();
        // The divergence theorem: x over all faces across x.
        let part = |axis: usize| (shown.bounds[1][axis] - shown.bounds[0][axis]) / shown.count as f64;
        let signed = |&[direction, at, u0, u1, v0, v1]: &Face| {
            let x = shown.bounds[0][0] + part(0) * f64::from(at);
            let area = f64::from(u1 - u0) * part(1) * f64::from(v1 - v0) * part(2);
            if direction == 1 { x * area } else { -x * area }
        };
        let drawn: f64 = shown.inside.iter().filter(|face| face[0] < 2).map(signed).sum();
        let proved: f64 = found.parts.iter().map(|part| part.volume).sum();
        assert!((drawn / proved - 1.0).abs() < 0.01, "{drawn} of {proved}");
        assert!(!shown.apart && shown.parts == found.parts.len());
        let most = &shown.taken[0];
        assert_eq!((most.condition, most.pairs), ("cable-obstacle", 8));
        assert!(
            most.worst.as_ref().unwrap().1 < most.share && shown.taken.windows(2).all(|w| w[0].share >= w[1].share)
        );
    }
}
