//! `cdpr schema`

use cdpr_core::Error;
use cdpr_study::schema;

use crate::Answer;
use crate::args::SchemaArgs;
use crate::output::Console;

pub fn run(args: &SchemaArgs, out: &Console) -> Result<Answer, Error> {
    out.result(&format!("{:#}", schema(args.of)));
    Ok(Answer::Yes)
}
