//! The program from outside, by topic. Tests that measure times (`limits`) are a program of their own, which runs
//! alone.

#[path = "../support/mod.rs"]
mod support;

mod batch;
mod cables;
mod cases;
mod cli;
mod files;
mod messages;
mod options;
mod pose;
mod replan;
mod scenes;
mod shell;
mod stations;
mod tasks;
mod trajectory;
mod widest;
