//! `cdpr completions`

use cdpr_core::Error;
use clap::CommandFactory;

use crate::Answer;
use crate::args::{Cli, CompletionsArgs};

pub fn run(args: &CompletionsArgs) -> Result<Answer, Error> {
    clap_complete::generate(args.shell, &mut Cli::command(), "cdpr", &mut std::io::stdout());
    Ok(Answer::Yes)
}
