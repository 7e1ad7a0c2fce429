//! What a page needs to plan by itself: the planner, the scene as it can be edited, and how its path was planned.

use cdpr_core::Scene;
use serde_json::{Value, json};

use crate::Contents;

/// The script of the worker in which the planner runs.
pub const WORKER: &str = include_str!("assets/worker.js");

/// The planner: WebAssembly, deflated, in base64.
pub const MODULE: &str = include_str!("assets/planner.txt");

/// The scene with the ends of its path, and the options with which that was planned.
pub fn contents(scene: &Scene, contents: Contents) -> Value {
    let mut spec = scene.spec().clone();
    if let Some([first, .., last]) = contents.path.map(|path| &path.waypoints[..]) {
        let query = spec.query.get_or_insert_default();
        (query.start, query.goal) = (Some(*first), Some(*last));
    }
    json!({ "scene": spec, "options": contents.planning().map_or_else(|| json!({}), |planning| planning.options) })
}
