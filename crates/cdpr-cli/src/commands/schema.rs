//! `cdpr schema`

use cdpr_core::Error;
use cdpr_core::io::scene_file::{Format, schema};

use crate::Answer;
use crate::args::{FileFormat, SchemaArgs};
use crate::output::result;

pub fn run(args: &SchemaArgs) -> Result<Answer, Error> {
    let of = match args.of {
        FileFormat::Scene => Format::Scene,
        FileFormat::Robot => Format::Robot,
        FileFormat::Path => Format::Path,
    };
    result(&format!("{:#}", schema(of)));
    Ok(Answer::Yes)
}
