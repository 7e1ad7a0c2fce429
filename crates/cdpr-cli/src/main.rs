//! `cdpr`: plan, check and look at paths of cable-driven parallel robots from the shell.

mod args;
mod commands;
mod input;
mod output;
mod progress;
mod signals;

use std::process::ExitCode;

use args::{Cli, Command, Target};
use cdpr_core::{Error, ErrorClass};
use clap::Parser;
use output::Console;
use progress::INTERRUPTED_STATUS;

/// How a command that ran to its end answers.
enum Answer {
    Yes,
    No,
}

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(asked) if !asked.use_stderr() => {
            output::print_help(&asked.render());
            return ExitCode::SUCCESS;
        }
        Err(error) => error.exit(),
    };
    signals::on_request_to_stop(progress::interrupt);
    let out = Console::new(cli.talk.level());
    cli.color.write_global();
    match run(cli.command, &out) {
        Ok(_) if progress::interrupted() => ExitCode::from(INTERRUPTED_STATUS),
        Ok(Answer::Yes) => ExitCode::SUCCESS,
        Ok(Answer::No) => ExitCode::from(1),
        Err(error) => {
            out.error(&error);
            ExitCode::from(if error.class() == ErrorClass::Interrupted { INTERRUPTED_STATUS } else { 2 })
        }
    }
}

fn run(command: Command, out: &Console) -> Result<Answer, Error> {
    command.targets().iter().try_for_each(Target::check)?;
    match command {
        Command::Plan(args) => commands::plan::run(&args, out),
        Command::Check(args) => commands::check::run(&args, out),
        Command::Info(args) => commands::info::run(&args, out),
        Command::Post(args) => commands::post::run(&args, out),
        Command::New(args) => commands::new::run(&args, out),
        Command::Import(args) => commands::import::run(&args, out),
        Command::Schema(args) => commands::schema::run(&args, out),
        Command::Shadows(args) => commands::shadows::run(&args, out),
        Command::View(args) => commands::view::run(&args, out),
        Command::Wrench(args) => commands::wrench::run(&args, out),
        Command::Batch(args) => commands::batch::run(&args, out),
        Command::Merge(args) => commands::merge::run(&args, out),
        Command::Report(args) => commands::report::run(&args, out),
        Command::Man(args) => commands::man::run(&args, out),
        Command::Completions(args) => commands::completions::run(&args, out),
    }
}
