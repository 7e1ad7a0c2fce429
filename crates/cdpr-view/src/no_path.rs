//! Why there is no path, as a picture: what can be reached, the wall around it, and the paths without an obstacle.

use cdpr_core::geometry::{Cuboid, Point};
use cdpr_core::plan::NoPath;
use serde::Serialize;

use super::blocks::{Blocks, Cut, Face, as_fine_as_allowed};
use super::xyz;

/// Walls are this share of the box of positions thick: closed boxes may be as large as half of it, and would hide what
/// lies behind.
const THICKNESS: usize = 32;

/// The contents of a page about a proof.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Shown<'a> {
    /// The culprits that close off the goal, in the order of `walls`.
    culprits: &'a [Vec<String>],
    /// The obstacles among the culprits.
    blocking: &'a [String],
    /// Volume that can be reached, m³.
    volume: f64,
    /// Volume of the box of positions, m³.
    of_volume: f64,
    /// The reachable position nearest to the goal, m.
    nearest: [f64; 3],
    /// Distance of the reachable position nearest to the goal from the goal, m.
    to_goal: f64,
    /// No path keeps a gap of more than this, m.
    margin: f64,
    /// The box of positions.
    bounds: [[f64; 3]; 2],
    /// Number of cubes along each axis of the box.
    count: usize,
    /// Surface of what can be reached.
    reachable: Vec<Face>,
    /// Surface of the boxes that each of the culprits closes beside what can be reached.
    walls: Vec<Vec<Face>>,
    /// The paths without one of the blocking obstacles.
    without: Vec<Detour<'a>>,
}

/// The path that exists without an obstacle.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Detour<'a> {
    obstacle: &'a str,
    /// Length of the path, m; `None` if there still is none.
    cost: Option<f64>,
    waypoints: Vec<[f64; 3]>,
}

/// The picture of a proof.
pub(super) fn shown(no_path: &NoPath) -> Shown<'_> {
    let NoPath { proof, culprits, blocking, .. } = no_path;
    let surfaces = |count| (reachable_faces(no_path, count), wall_faces(no_path, count));
    let (count, (reachable, walls)) =
        as_fine_as_allowed(surfaces, |(reachable, walls)| reachable.len() + walls.iter().map(Vec::len).sum::<usize>());
    Shown {
        culprits,
        blocking,
        volume: proof.reachable_volume,
        of_volume: proof.bounds.volume(),
        nearest: no_path.nearest_to_goal,
        to_goal: (proof.goal - proof.nearest_to_goal).norm(),
        margin: proof.margin,
        bounds: [xyz(&proof.bounds.low), xyz(&proof.bounds.high)],
        count,
        reachable,
        walls,
        without: no_path.without.iter().map(|(name, cost)| detour(no_path, name, *cost)).collect(),
    }
}

fn detour<'a>(no_path: &'a NoPath, obstacle: &'a str, cost: Option<f64>) -> Detour<'a> {
    let path: &[Point] = no_path.paths_without.get(obstacle).map_or(&[], |path| path);
    Detour { obstacle, cost, waypoints: path.iter().map(xyz).collect() }
}

fn reachable_faces(no_path: &NoPath, count: usize) -> Vec<Face> {
    let mut blocks = Blocks::new(&no_path.proof.bounds, count);
    no_path.proof.reachable.iter().for_each(|cell| blocks.paint(cell, Cut::AtCentres, 1));
    blocks.faces(1).remove(0)
}

fn wall_faces(no_path: &NoPath, count: usize) -> Vec<Vec<Face>> {
    let empty = || Blocks::new(&no_path.proof.bounds, count);
    let (mut open, mut walls) = (empty(), empty());
    for &index in &no_path.proof.around_start {
        open.paint(&no_path.proof.boxes[index].positions, Cut::Outwards, 1);
    }
    for (positions, culprit) in wall(no_path) {
        walls.paint(positions, Cut::Outwards, culprit as u16 + 1);
    }
    walls.keep(&open.near(count.div_ceil(THICKNESS)));
    walls.faces(no_path.culprits.len())
}

/// The boxes of the wall, and what closes each, as indices into the culprits.
fn wall(no_path: &NoPath) -> impl Iterator<Item = (&Cuboid, usize)> {
    let boxes = no_path.proof.wall.iter().map(|&index| &no_path.proof.boxes[index]);
    boxes.filter_map(|of| no_path.closed_by(of).map(|culprit| (&of.positions, culprit)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::COUNTS;
    use cdpr_core::geometry::path_length;
    use cdpr_core::plan::{PlanOptions, plan};
    use cdpr_core::proof::Content;
    use cdpr_core::testing::{scene, walled};
    use std::sync::Arc;

    /// Why the platform does not pass over the wall.
    fn closed() -> Arc<NoPath> {
        plan(&scene(walled(0.94)), &PlanOptions::default(), &()).unwrap().result.no_path.expect("a proof")
    }

    fn area(faces: &[Face], bounds: &[[f64; 3]; 2], count: usize) -> f64 {
        let part = |axis: usize| (bounds[1][axis] - bounds[0][axis]) / count as f64;
        let of = |&[direction, _, u0, u1, v0, v1]: &Face| {
            let axis = usize::from(direction / 2);
            f64::from(u1 - u0) * part((axis + 1) % 3) * f64::from(v1 - v0) * part((axis + 2) % 3)
        };
        faces.iter().map(of).sum()
    }

    #[test]
    fn the_wall_is_closed_by_the_culprits() {
        let no_path = closed();
        let open = no_path.proof.boxes.iter().filter(|of| of.content == Content::Open);
        assert!(open.clone().all(|of| no_path.closed_by(of).is_none()));
        assert_eq!(wall(&no_path).count(), no_path.proof.wall.len());
        assert!(wall(&no_path).all(|(_, culprit)| no_path.culprits[culprit].contains(&"wall".to_string())));
        for (positions, _) in wall(&no_path) {
            let touches = |index: &usize| no_path.proof.boxes[*index].positions.touches(positions);
            assert!(no_path.proof.around_start.iter().any(touches));
        }
    }

    #[test]
    fn the_boxes_around_the_start_hold_the_start_and_not_the_goal() {
        let NoPath { proof, .. } = &*closed();
        let holds = |place: &Point| {
            let at = Cuboid::new(*place, *place);
            proof.around_start.iter().any(|&index| proof.boxes[index].positions.touches(&at))
        };
        assert_eq!((holds(&proof.start), holds(&proof.goal)), (true, false));
        assert!(proof.around_start.iter().all(|&index| proof.boxes[index].content == Content::Open));
    }

    #[test]
    fn drawn_volume_matches_the_reachable_volume() {
        let no_path = closed();
        let found = shown(&no_path);
        assert_eq!((found.volume, found.count), (no_path.reachable_volume, COUNTS[0]));
        let volume: f64 = no_path.proof.reachable.iter().map(Cuboid::volume).sum();
        assert!((volume - found.volume).abs() < 1e-12);
        // The divergence theorem: x over all faces across x.
        let part = (found.bounds[1][0] - found.bounds[0][0]) / found.count as f64;
        let across = found.reachable.iter().filter(|face| face[0] < 2);
        let signed = |face: &Face| {
            let x = found.bounds[0][0] + part * f64::from(face[1]);
            if face[0] == 1 { x } else { -x }
        };
        let drawn: f64 = across.map(|face| signed(face) * area(&[*face], &found.bounds, found.count)).sum();
        assert!((drawn / found.volume - 1.0).abs() < 0.02, "{drawn} of {}", found.volume);
        assert!(found.walls.iter().all(|faces| area(faces, &found.bounds, found.count) > 0.1));
    }

    #[test]
    fn detours_lead_from_start_to_goal_and_are_as_long_as_they_say() {
        let no_path = closed();
        let found = shown(&no_path);
        let [detour] = &found.without[..] else { panic!("one obstacle") };
        let path: Vec<Point> = detour.waypoints.iter().map(|row| Point::from(*row)).collect();
        assert_eq!((detour.obstacle, detour.cost), ("wall", Some(path_length(&path))));
        assert_eq!((path[0], path[path.len() - 1]), (no_path.proof.start, no_path.proof.goal));
    }

    #[test]
    fn pages_stay_small_whatever_the_proof() {
        let mut no_path = NoPath::clone(&closed());
        // The worst case: every second cube.
        let bounds = no_path.proof.bounds;
        let size = (bounds.high - bounds.low) / COUNTS[0] as f64;
        let count = COUNTS[0];
        let even = (0..count * count * count)
            .map(|k| [k / count / count, k / count % count, k % count])
            .filter(|place| place.iter().sum::<usize>() % 2 == 0);
        let cube = |place: [usize; 3]| {
            let low = bounds.low + size.component_mul(&vector(place));
            Cuboid::new(low, low + size)
        };
        no_path.proof.reachable = even.map(cube).collect();
        let found = shown(&no_path);
        assert!(found.count < COUNTS[0]);
        assert!(serde_json::to_string(&found).unwrap().len() < 1_000_000);
    }

    fn vector(place: [usize; 3]) -> cdpr_core::geometry::Vector {
        place.map(|k| k as f64).into()
    }
}
