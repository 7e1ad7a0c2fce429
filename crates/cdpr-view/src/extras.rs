//! Additional contents of a page: the search tree, shadows, and the wrench-feasible workspace.

use serde::Serialize;
use serde_json::{Value, json};

use super::region;
use cdpr_core::batch::each;
use cdpr_core::collision::Conditions;
use cdpr_core::error::Error;
use cdpr_core::geometry::{Aabb, Point};
use cdpr_core::model::Scene;
use cdpr_core::planning::SearchTree;
use cdpr_core::regions::{RegionOptions, Regions, regions_within};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::constraint::limit_at;
use cdpr_core::wrench::map::Grid;
use cdpr_core::wrench::{Measure, measures};

/// Maximum number of tree edges on a page, which keeps it below 2 MB; of larger trees only some are shown.
const MOST_EDGES: usize = 8000;

/// Edges of a search tree, each as the positions of its ends.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Edges {
    /// Every `stride`-th edge is shown; 1 if all are.
    every: usize,
    /// Number of edges of the tree.
    count: usize,
    /// x, y, z of both ends, edge after edge, m.
    ends: Vec<f32>,
}

/// A search tree as drawn on the page; `None` if it has no edges.
pub(super) fn tree(tree: &SearchTree<Point>) -> Option<Edges> {
    let count = tree.edges().count();
    let every = count.div_ceil(MOST_EDGES);
    let ends = || tree.edges().step_by(every).flatten().flat_map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect();
    (count > 0).then(|| Edges { every, count, ends: ends() })
}

/// Maximum number of shadow triangles on a page, which keeps it below 2 MB; beyond it shadows are omitted.
const MOST_TRIANGLES: usize = 6000;
/// Maximum number of pairs of a cable and an obstacle; beyond it shadows are not even computed.
const MOST_SHADOWS: usize = 2000;

/// The shadows of a scene in the space of attachments; `None` if there are none or too many.
pub(super) fn shadows(scene: &Scene, watch: &Watch) -> Result<Option<Value>, Error> {
    let parts: usize = scene.obstacles().iter().map(|obstacle| obstacle.parts.len()).sum();
    if parts == 0 || parts * scene.robot().cables().len() > MOST_SHADOWS {
        return Ok(None);
    }
    let found = regions_within(scene, &RegionOptions::default(), watch)?;
    let triangles: usize = found.meshes.iter().map(|region| region.mesh.triangles.len()).sum();
    Ok((1..=MOST_TRIANGLES).contains(&triangles).then(|| regions_value(&found, false)))
}

/// Regions in the format of the page; `shown` is whether they are initially visible.
pub(super) fn regions_value(regions: &Regions, shown: bool) -> Value {
    json!({ "space": regions.space, "shown": shown, "meshes": regions.meshes.iter().map(region).collect::<Vec<_>>() })
}

/// Maximum number of steps of the wrench-feasible workspace along its longest side: at most 4913 nodes.
const MOST_MAP_STEPS: f64 = 16.0;
/// With fewer steps a map would be meaningless, so the page omits it.
const LEAST_MAP_STEPS: f64 = 6.0;
/// Maximum number of positions times choices of five cables, each of which may span a facet: about two seconds on two
/// cores.
const MARGIN_WORK: f64 = 4e6;

/// Whether computing margins at this number of places would take too long.
pub(super) fn too_many_margins(scene: &Scene, places: usize) -> bool {
    places as f64 * choices(scene.robot().cables().len()) > MARGIN_WORK
}

/// Number of ways to choose five cables.
fn choices(cables: usize) -> f64 {
    (0..5).map(|k| (cables.max(5) - k) as f64 / (k + 1) as f64).product()
}

/// Number of steps of the map of a robot with this many cables; `None` if it would take too long.
fn map_steps(cables: usize) -> Option<f64> {
    let steps = ((MARGIN_WORK / choices(cables)).cbrt() - 1.0).floor();
    (steps >= LEAST_MAP_STEPS).then_some(steps.min(MOST_MAP_STEPS))
}

/// A coarse grid over the positions at which the platform is inside the workspace.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Feasible {
    origin: [f64; 3],
    step: f64,
    counts: [usize; 3],
    /// Margin beyond the required one, z fastest; `None` where it is not positive.
    margins: Vec<Option<f32>>,
    measure: &'static str,
    unit: &'static str,
}

/// The region in which a scene with `[wrench]` meets its requirements; `None` for other scenes.
///
/// # Errors
/// The errors of [`measures`]; [`Error::interrupted`], [`Error::out_of_time`].
pub(super) fn feasible(scene: &Scene, watch: &Watch) -> Result<Option<Feasible>, Error> {
    let measures = measures(scene)?;
    let Some(first) = measures.first() else { return Ok(None) };
    let (min, max) = Conditions::within(scene, watch)?.position_box();
    let longest = (max - min).max();
    let Some(steps) = map_steps(scene.robot().cables().len()).filter(|_| longest > 0.0) else { return Ok(None) };
    let grid = Grid::over(&Aabb { min, max }, longest / steps)?;
    let limit = limit_at(first, &grid.origin);
    // If one of several measures fails, the requirements are not met. The first measure's smallest margin is shown.
    let of_first = |measure: &Measure| std::mem::discriminant(measure) == std::mem::discriminant(first);
    let margin = |node: usize| {
        watch.check()?;
        let position = grid.position(node);
        let mut least = f64::INFINITY;
        for measure in &measures {
            let slack = measure.slack(&position);
            if !(slack > 0.0) {
                return Ok(None);
            }
            least = if of_first(measure) { least.min(slack) } else { least };
        }
        Ok(Some(least as f32))
    };
    let margins = each(grid.len(), 0, &|(), node| margin(node))?;
    Ok(Some(Feasible {
        origin: grid.origin.into(),
        step: grid.step,
        counts: grid.counts,
        margins,
        measure: limit.measure,
        unit: limit.unit,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::testing::{block, hard1, paper_scene, scene};

    #[test]
    fn trees_are_drawn_whole_up_to_a_size_and_evenly_thinned_beyond() {
        let line = |nodes: usize| SearchTree {
            states: (0..nodes).map(|k| Point::new(k as f64, 0.5, 2.0)).collect(),
            parents: (0..nodes).map(|k| k.saturating_sub(1)).collect(),
        };
        assert_eq!((tree(&line(0)), tree(&line(1))), (None, None)); // a root alone has no edge
        let whole = tree(&line(3)).unwrap();
        assert_eq!((whole.every, whole.count), (1, 2));
        assert_eq!(whole.ends, [0.0, 0.5, 2.0, 1.0, 0.5, 2.0, 1.0, 0.5, 2.0, 2.0, 0.5, 2.0]);
        let thinned = tree(&line(MOST_EDGES + 2)).unwrap();
        assert_eq!((thinned.every, thinned.count, thinned.ends.len()), (2, MOST_EDGES + 1, (MOST_EDGES / 2 + 1) * 6));
    }

    #[test]
    fn only_scenes_with_wrench_show_a_feasible_workspace() {
        assert_eq!(feasible(&hard1(), &Watch::NONE).unwrap(), None);
        let mut spec = hard1().spec().clone();
        spec.wrench = Some(cdpr_core::model::WrenchSpec::default());
        let found = feasible(&Scene::new(spec).unwrap(), &Watch::NONE).unwrap().unwrap();
        assert_eq!((found.counts, found.margins.len()), ([16, 16, 17], 16 * 16 * 17));
    }

    #[test]
    fn maps_of_many_cables_are_coarser_or_left_out() {
        assert_eq!([3, 8, 12, 16, 24].map(map_steps), [Some(16.0), Some(16.0), Some(16.0), Some(8.0), None]);
    }

    #[test]
    fn too_many_shadows_are_left_out() {
        assert!(shadows(&hard1(), &Watch::NONE).unwrap().is_some());
        let many = (0..300).map(|k| block(&format!("{k}"), [0.01; 3], [0.5, 0.5, 0.001 * k as f64 + 0.1])).collect();
        assert!(shadows(&scene(paper_scene("many", many)), &Watch::NONE).unwrap().is_none());
    }
}
