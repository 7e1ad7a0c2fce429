//! The planner inside the page: what the page asks while someone edits the scene, as JSON. Compiled to WebAssembly it
//! runs in a worker of the page.
//!
//! A [`Session`] answers one [`Request`] after the other and keeps the engine of the last scene, so that dragging the
//! start or the goal compiles nothing.

mod request;
mod session;
#[cfg(target_arch = "wasm32")]
mod worker;

pub use request::{Ask, Options, Request};
pub use session::Session;
