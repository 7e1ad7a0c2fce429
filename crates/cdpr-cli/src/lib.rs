//! The command `cdpr`: plan, check and view paths of cable-driven parallel robots from the shell. The program and the Python
//! package's console script both call [`run`].

mod args;
mod commands;
mod input;
mod interruption;
mod output;
mod progress;
mod signals;
mod target;

use std::ffi::OsString;
use std::panic;

use args::{Cli, Command};
use cdpr_core::error::{caught, printable};
use cdpr_core::{Error, ErrorClass};
use clap::Parser;
use interruption::INTERRUPTED_STATUS;
use output::Console;

/// Exit status for bad input.
const BAD_INPUT_STATUS: u8 = 2;
/// Exit status for a bug in this program: EX_SOFTWARE of sysexits.h.
const BUG_STATUS: u8 = 70;

/// The answer of a command that ran to completion.
enum Answer {
    Yes,
    No,
}

/// Runs the command with its arguments, the first of which is the name of the program, and returns its exit status. Handles
/// signals from then on, and may end the process.
pub fn run(arguments: &[OsString]) -> u8 {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(asked) if !asked.use_stderr() => {
            output::print_help(&asked.render());
            return 0;
        }
        Err(error) => {
            let _ = without_control_characters(error, arguments).print();
            return BAD_INPUT_STATUS;
        }
    };
    print_panic_location();
    signals::on_request_to_stop(interruption::interrupt);
    let out = Console::new(cli.talk.level());
    cli.color.write_global();
    match caught(|| answer(cli.command, &out)) {
        Ok(_) if interruption::interrupted() => INTERRUPTED_STATUS,
        Ok(Answer::Yes) => 0,
        Ok(Answer::No) => 1,
        Err(error) => {
            out.error(&error);
            status(&error)
        }
    }
}

fn status(error: &Error) -> u8 {
    match error.class() {
        ErrorClass::Interrupted => INTERRUPTED_STATUS,
        ErrorClass::Internal => BUG_STATUS,
        ErrorClass::Input | ErrorClass::File | ErrorClass::OutOfTime => BAD_INPUT_STATUS,
    }
}

/// An error with arguments made safe for a terminal, since its message repeats them.
fn without_control_characters(error: clap::Error, arguments: &[OsString]) -> clap::Error {
    let arguments = arguments.iter().map(|argument| printable(&argument.to_string_lossy()).into_owned());
    Cli::try_parse_from(arguments).err().unwrap_or(error)
}

/// Prints only the location of a panic, since [`caught`] prints its message. With `RUST_BACKTRACE` set, Rust's own
/// output is kept.
fn print_panic_location() {
    if std::env::var_os("RUST_BACKTRACE").is_none() {
        panic::set_hook(Box::new(|bug| {
            eprintln!("cdpr: panic{}", bug.location().map_or(String::new(), |l| format!(" at {l}")))
        }));
    }
}

fn answer(command: Command, out: &Console) -> Result<Answer, Error> {
    command.check_effects()?;
    command.check_targets()?;
    match command {
        Command::Plan(args) => commands::plan::run(&args, out),
        Command::Check(args) => commands::check::run(&args, out),
        Command::Info(args) => commands::info::run(&args, out),
        Command::Post(args) => commands::post::run(&args, out),
        Command::Trajectory(args) => commands::trajectory::run(&args, out),
        Command::New(args) => commands::new::run(&args, out),
        Command::Import(args) => commands::import::run(&args, out),
        Command::Schema(args) => commands::schema::run(&args, out),
        Command::Shadows(args) => commands::shadows::run(&args, out),
        Command::Export(args) => commands::export::run(&args, out),
        Command::View(args) => commands::view::run(&args, out),
        Command::Wrench(args) => commands::wrench::run(&args, out),
        Command::Workspace(args) => commands::workspace::run(&args, out),
        Command::Tour(args) => commands::tour::run(&args, out),
        Command::Task(args) => commands::task::run(&args, out),
        Command::Pose(args) => commands::pose::run(&args, out),
        Command::Batch(args) => commands::batch::run(&args, out),
        Command::Merge(args) => commands::merge::run(&args, out),
        Command::Report(args) => commands::report::run(&args, out),
        Command::Man(args) => commands::man::run(&args, out),
        Command::Completions(args) => commands::completions::run(&args, out),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_bug_with_a_status_of_its_own() {
        let bug = caught(|| -> Result<Answer, Error> { panic!("index out of range") }).err().expect("an error");
        assert_eq!(status(&bug), 70);
        let told = bug.to_string();
        for words in ["index out of range", "bug in cdpr", "report", "version"] {
            assert!(told.contains(words), "no \"{words}\" in {told}");
        }
        assert_eq!(status(&Error::invalid("step", "found 0")), 2);
    }
}
