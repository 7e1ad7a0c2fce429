//! Reading and writing files: the only module that opens any.

pub mod batch_folder;
pub mod batch_tables;
mod caspr;
mod cell;
pub mod experiment_file;
mod gazebo;
pub mod import_file;
mod loader;
mod mesh_bodies;
pub mod mesh_file;
pub mod mesh_reader;
mod origin;
pub mod output;
pub mod path_file;
pub mod report_file;
pub mod scene_file;
pub mod starter_file;
pub mod tension_file;
pub mod text;
pub mod wrench_map_file;
mod xml;

pub use batch_folder::{BatchFolder, merge};
pub use batch_tables::{BatchRows, Tables};
pub use experiment_file::{experiment_from_text, load_experiment};
pub use import_file::{ImportOptions, Imported, check_robot_name, import_robot, robot_toml, save_imported};
pub use loader::Loader;
pub use mesh_file::{RegionFormat, save_regions};
pub use mesh_reader::load_mesh;
pub use origin::origin_here;
pub use output::{check_folder, check_target, is_stream, write_atomically};
pub use path_file::{
    LoadedPath, PathFile, SceneId, check_path_name, load_waypoints, path_json, plan_json, save_path, scene_for,
    scene_of_path, waypoints_from_text,
};
pub use report_file::{load_study, save_plots};
pub use scene_file::{load_robot, load_scene, robot_from_text, scene_from_text, schema};
pub use starter_file::{Starter, starter_scene, starter_text};
pub use tension_file::{check_tensions_name, lengths_csv, save_tensions, tensions_csv};
pub use text::save_table;
pub use wrench_map_file::{MapFormat, load_wrench_map, save_wrench_map, wrench_map_from_npz, wrench_map_to_npz};
