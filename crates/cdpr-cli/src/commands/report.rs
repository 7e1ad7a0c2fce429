//! `cdpr report`

use cdpr_core::Error;
use cdpr_study::report::page;

use super::view::IN_BROWSER;
use crate::Answer;
use crate::args::{Format, ReportArgs};
use crate::output::{Console, lossy};

pub fn run(args: &ReportArgs, out: &Console) -> Result<Answer, Error> {
    let output = args.output.clone().unwrap_or_else(|| args.folder.join("report.html"));
    let study = cdpr_study::load_study(&args.folder)?;
    let out = &out.beside(Some(&output));
    out.write(&output, page(&study).as_bytes(), IN_BROWSER)?;
    out.say(&format!("figures: python -m cdpr.figures {} -o DIR", args.folder.display()));
    if args.format == Format::Json {
        out.result(&serde_json::json!({ "page": lossy(&output) }).to_string());
    }
    Ok(Answer::Yes)
}
