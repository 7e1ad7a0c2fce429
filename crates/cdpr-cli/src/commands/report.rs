//! `cdpr report`

use cdpr_core::report::{page, plots};
use cdpr_core::{Error, io};

use super::view::check_page_name;
use crate::Answer;
use crate::args::{Format, ReportArgs};
use crate::output::{result, say};

pub fn run(args: &ReportArgs) -> Result<Answer, Error> {
    let output = args.output.clone().unwrap_or_else(|| args.folder.join("report.html"));
    check_page_name(&output)?;
    let study = io::load_study(&args.folder)?;
    io::write_atomically(&output, page(&study).as_bytes())?;
    if let Some(folder) = &args.plots {
        io::save_plots(folder, &plots(&study))?;
    }
    match args.format {
        Format::Text => say(&format!("wrote {} (open it in a browser)", output.display())),
        Format::Json => result(&serde_json::json!({ "page": output, "plots": args.plots }).to_string()),
    }
    Ok(Answer::Yes)
}
