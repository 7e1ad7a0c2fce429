//! `cdpr merge`

use cdpr_core::{Error, io};

use crate::Answer;
use crate::args::MergeArgs;

pub fn run(args: &MergeArgs) -> Result<Answer, Error> {
    io::merge(&args.folders, &args.output)?;
    super::batch::print_summary(&args.output, args.format)?;
    Ok(Answer::Yes)
}
