//! Tests of reading and writing files, meshes, pages and experiments.

mod array_lengths;
mod bad_input;
mod batch;
mod built_scenes;
mod hostile_files;
mod import;
mod import_whole;
mod mesh;
mod mesh_bodies;
mod mesh_coverage;
mod mesh_files;
mod mesh_mutations;
mod mesh_notes;
mod mesh_parts;
mod wrench_map;
