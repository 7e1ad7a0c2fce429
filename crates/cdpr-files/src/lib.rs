//! Reading and writing files: scenes, robots (also of other programs), meshes, paths, tables.

mod cable_columns;
mod caspr;
pub mod csv_cell;
mod examples;
mod gazebo;
pub mod import_file;
mod import_source;
pub mod length_file;
mod loader;
mod matrix_file;
mod mesh_bodies;
pub mod mesh_reader;
pub mod mjcf_file;
mod npz;
pub mod output;
pub mod path_file;
pub mod region_file;
pub mod scene_file;
pub mod sources;
pub mod starter_file;
mod task_file;
pub mod tension_file;
pub mod text;
pub mod trajectory_file;
mod voxels;
pub mod workspace_file;
pub mod wrench_map_file;
mod xml;

pub use examples::{example, example_names, example_text, save_example_files};
pub use import_file::{ImportOptions, Imported, import_robot, robot_toml, save_imported};
pub use length_file::{CableLengths, lengths_from_text, load_lengths};
pub use loader::Loader;
pub use matrix_file::{check_matrix_name, matrix_csv};
pub use mesh_reader::{MeshFile, load_mesh, load_mesh_file};
pub use mjcf_file::{Control, Mjcf, check_mjcf_name, mjcf, motion_of_mjcf, save_mjcf};
pub use output::{check_folder, check_target, is_stream, write_atomically};
pub use path_file::{
    LoadedPath, PathFile, PathFormat, SceneId, begins_at, check_path_name, load_waypoints, said_by_turns, save_path,
    scene_for, scene_of_path, waypoints_from_text,
};
pub use region_file::{RegionFormat, save_regions};
pub use scene_file::{load_robot, load_scene, robot_from_text, scene_from_text};
pub use sources::sources;
pub use starter_file::{NewScene, Starter, starter_scene, starter_text};
pub use task_file::{
    WholeFile, check_whole, is_task, load_if_task, page_name, remove_earlier_task, save_task, task_file, task_from_text,
};
pub use tension_file::{check_tensions_name, lengths_csv, save_tensions, tensions_csv};
pub use text::save_table;
pub use trajectory_file::{
    LoadedTrajectory, MessageFields, check_trajectory, check_trajectory_name, is_trajectory, load_if_trajectory,
    load_trajectory, loaded_if_trajectory, save_trajectory, scene_of_loaded, scene_of_trajectory, trajectory_from_text,
    trajectory_json,
};
pub use workspace_file::{WorkspaceFormat, workspace_bytes, workspace_from_json};
pub use wrench_map_file::{MapFormat, load_wrench_map, save_wrench_map, wrench_map_from_npz, wrench_map_to_npz};

/// Tests the examples in the crate's README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
