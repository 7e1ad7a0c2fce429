//! One module per command.

pub mod batch;
pub mod check;
pub mod completions;
pub mod export;
pub mod import;
pub mod info;
pub mod man;
pub mod merge;
pub mod new;
pub mod plan;
pub mod pose;
pub mod post;
pub mod report;
pub mod schema;
pub mod shadows;
pub mod task;
pub mod task_check;
pub mod task_motion_check;
pub mod tour;
pub mod trajectory;
pub mod trajectory_check;
pub mod view;
pub mod workspace;
pub mod wrench;
