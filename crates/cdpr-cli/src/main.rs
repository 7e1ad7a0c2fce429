//! The program `cdpr`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(cdpr_cli::run(&std::env::args_os().collect::<Vec<_>>()))
}
