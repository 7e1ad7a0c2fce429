//! Experiments: random scenes.

pub mod random_scene;

pub use random_scene::{RandomScenes, RandomScenesSpec};
