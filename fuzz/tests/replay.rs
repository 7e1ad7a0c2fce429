//! Runs valid files, and inputs that once revealed defects, through their readers.

use std::fs;
use std::path::PathBuf;

use cdpr_fuzz::{MEMORY, Memory, READERS, inputs, read_in_time, reader};

#[global_allocator]
static ALLOCATOR: Memory = Memory::new(std::alloc::System, MEMORY);

/// The inputs of a kind, each with its reader.
fn all(kind: &str) -> Vec<(String, PathBuf)> {
    let folders = fs::read_dir(inputs(kind)).unwrap().map(|folder| folder.unwrap().path());
    let files = folders.flat_map(|folder| {
        let name = folder.file_name().unwrap().to_string_lossy().into_owned();
        fs::read_dir(folder).unwrap().map(move |file| (name.clone(), file.unwrap().path()))
    });
    let mut files: Vec<_> = files.collect();
    files.sort();
    files
}

#[test]
fn every_reader_has_seeds() {
    let seeds = all("seeds");
    for reader in READERS {
        assert!(seeds.iter().any(|(name, _)| name == reader.name), "{}", reader.name);
    }
}

#[test]
fn seeds_and_regressions_are_read_in_time_and_memory() {
    let inputs = [all("seeds"), all("regressions")].concat();
    assert!(inputs.len() > READERS.len());
    for (name, path) in inputs {
        println!("{}", path.display()); // shown if the test fails
        read_in_time(reader(&name), fs::read(&path).unwrap());
    }
}
