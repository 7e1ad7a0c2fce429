//! The planner inside the page, which answers what the page asks while someone edits the scene, as JSON.
//!
//! - [`Request`] is a question as plain data. `contents` gives the page what it needs to ask: the scene, and the options of a
//!   path, which [`Planning`] reads from the JSON of the path.
//! - A [`Session`] answers one request after the other and keeps the engine of the last scene, so that dragging the start or
//!   the goal compiles nothing.
//! - The crate `cdpr-live` compiles the session to WebAssembly, for a worker of the page. `MODULE` is the result, so it holds
//!   this crate as it was when `make viewer` ran.

mod planning;
mod request;
mod session;

pub use planning::Planning;
pub use request::{Ask, Options, Request};
pub use session::{Improved, Session};

use cdpr_core::Scene;
use cdpr_core::model::SceneSpec;
use serde_json::{Value, json};

use crate::Contents;

/// The script of the worker in which the planner runs.
pub(crate) const WORKER: &str = include_str!("assets/worker.js");

/// The planner: WebAssembly, deflated, in base85 as in `viewer/src/base85.js`.
pub(crate) const MODULE: &str = include_str!("assets/planner.txt");

/// The scene with the ends of its path, and the options with which that was planned.
pub(crate) fn contents(scene: &Scene, contents: Contents) -> Value {
    let mut spec = SceneSpec { query: scene.located_query(), ..scene.spec().clone() };
    if let Some([first, .., last]) = contents.path.map(|path| &path.waypoints[..]) {
        let query = spec.query.get_or_insert_default();
        (query.start, query.goal) = (Some((*first).into()), Some((*last).into()));
    }
    json!({ "scene": spec, "options": contents.planning().map_or_else(|| json!({}), |planning| planning.options) })
}
