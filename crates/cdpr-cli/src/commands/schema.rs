//! `cdpr schema`

use cdpr_core::Error;
use cdpr_core::io::schema;

use crate::Answer;
use crate::args::SchemaArgs;
use crate::output::result;

pub fn run(args: &SchemaArgs) -> Result<Answer, Error> {
    result(&format!("{:#}", schema(args.of)));
    Ok(Answer::Yes)
}
