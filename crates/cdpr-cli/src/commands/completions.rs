//! `cdpr completions`

use cdpr_core::Error;
use clap::CommandFactory;

use crate::Answer;
use crate::args::{Cli, CompletionsArgs};
use crate::output::Console;

pub fn run(args: &CompletionsArgs, out: &Console) -> Result<Answer, Error> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "cdpr", &mut script);
    out.result(String::from_utf8_lossy(&script).trim_end());
    Ok(Answer::Yes)
}
