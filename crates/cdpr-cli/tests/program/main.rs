//! The program from outside, by topic. What measures times (`limits`) is a program of its own, which runs alone.

#[path = "../support/mod.rs"]
mod support;

mod batch;
mod cables;
mod cases;
mod cli;
mod files;
mod messages;
mod options;
mod scenes;
mod shell;
mod trajectory;
