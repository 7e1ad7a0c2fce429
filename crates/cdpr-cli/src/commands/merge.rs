//! `cdpr merge`

use cdpr_core::Error;

use crate::Answer;
use crate::args::MergeArgs;
use crate::output::Console;

pub fn run(args: &MergeArgs, out: &Console) -> Result<Answer, Error> {
    let _writing = crate::interruption::writing();
    cdpr_study::merge(&args.folders, &args.output)?;
    super::batch::print_summary(&args.output, args.format, out)?;
    Ok(Answer::Yes)
}
