//! What a page needs to plan by itself: the planner, the scene as it can be edited, and how its path was planned.

use cdpr_core::Scene;
use cdpr_core::path_file::PathFile;
use serde_json::{Value, json};

/// The script of the worker in which the planner runs.
pub const WORKER: &str = include_str!("assets/worker.js");

/// The planner: WebAssembly, deflated, in base64.
pub const MODULE: &str = include_str!("assets/planner.txt");

/// The scene with the ends of its path, and the options with which that was planned.
pub fn contents(scene: &Scene, path: Option<&PathFile>) -> Value {
    let mut spec = scene.spec().clone();
    if let Some([first, .., last]) = path.map(|path| &path.waypoints[..]) {
        let query = spec.query.get_or_insert_default();
        (query.start, query.goal) = (Some(*first), Some(*last));
    }
    json!({ "scene": spec, "options": path.map_or_else(|| json!({}), options) })
}

/// The options of a planned path, as requests to the planner have them; without a time limit.
fn options(path: &PathFile) -> Value {
    let Some(planned) = &path.planned else { return json!({}) };
    let options = &planned.options;
    json!({
        "planner": path.planner,
        "seed": planned.seed,
        "engine": planned.engine,
        "interference": planned.interference,
        "post": options.post,
        "step": options.step,
        "repeats": options.repeats,
        "proof": options.proof,
        "settings": options.settings,
    })
}
