//! `cdpr`: plan, check and look at paths of cable-driven parallel robots from the shell.

mod args;
mod commands;
mod output;
mod progress;

use std::process::ExitCode;

use args::{Cli, Command};
use cdpr_core::{Error, ErrorClass};
use clap::Parser;

/// How a command that ran to its end answers.
enum Answer {
    Yes,
    No,
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    // Without a handler Ctrl-C would still end the program, only less politely.
    let _ = ctrlc::set_handler(progress::interrupt);
    match run(cli.command) {
        Ok(Answer::Yes) => ExitCode::SUCCESS,
        Ok(Answer::No) => ExitCode::from(1),
        Err(error) => {
            output::say(&format!("cdpr: {error}"));
            ExitCode::from(if error.class() == ErrorClass::Interrupted { 130 } else { 2 })
        }
    }
}

fn run(command: Command) -> Result<Answer, Error> {
    match command {
        Command::Plan(args) => commands::plan::run(&args),
        Command::Check(args) => commands::check::run(&args),
        Command::Info(args) => commands::info::run(&args),
        Command::Post(args) => commands::post::run(&args),
        Command::New(args) => commands::new::run(&args),
        Command::Import(args) => commands::import::run(&args),
        Command::Schema(args) => commands::schema::run(&args),
        Command::Shadows(args) => commands::shadows::run(&args),
        Command::View(args) => commands::view::run(&args),
        Command::Wrench(args) => commands::wrench::run(&args),
        Command::Batch(args) => commands::batch::run(&args),
        Command::Merge(args) => commands::merge::run(&args),
        Command::Report(args) => commands::report::run(&args),
        Command::Completions(args) => commands::completions::run(&args),
    }
}
