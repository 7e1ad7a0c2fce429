//! The program run from outside.

#![allow(dead_code)] // each file of tests uses some of this

use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

pub fn testdata(name: &str) -> String {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../testdata").join(name).display().to_string()
}

pub fn cdpr(arguments: &[&str]) -> Output {
    cdpr_in(Path::new("."), arguments)
}

pub fn cdpr_in(folder: &Path, arguments: &[&str]) -> Output {
    Command::cargo_bin("cdpr").unwrap().current_dir(folder).args(arguments).output().unwrap()
}

/// The program with this text as standard input.
pub fn cdpr_fed(folder: &Path, arguments: &[&str], text: &str) -> Output {
    Command::cargo_bin("cdpr").unwrap().current_dir(folder).args(arguments).write_stdin(text).output().unwrap()
}

pub fn status(output: &Output) -> i32 {
    output.status.code().expect("not killed")
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

pub fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {}{}", stdout(output), stderr(output)))
}

pub fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}
