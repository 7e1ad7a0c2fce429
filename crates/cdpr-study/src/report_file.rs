//! Reads the results of a run for its report.

use std::io::BufReader;
use std::path::Path;

use crate::report::{Cost, Costs, Study};
use crate::{SummaryFile, TrialRow, TrialStatus};
use cdpr_core::error::Error;
use cdpr_core::planning::Status;
use cdpr_files::csv_cell::text_of;
use cdpr_files::text::{self, Notation};

/// Reads `summary.json` and `trials.csv` of a folder that `cdpr batch` or `cdpr merge` wrote.
///
/// # Errors
/// A missing or invalid file; the error names it.
pub fn load_study(folder: impl AsRef<Path>) -> Result<Study, Error> {
    let folder = folder.as_ref();
    let path = folder.join("summary.json");
    if !path.is_file() {
        let problem = "found no summary.json, expected the folder of a run that has ended or was interrupted";
        return Err(Error::file(folder, problem));
    }
    let summary: SummaryFile = text::parse(&text::read(&path)?, Notation::Json).map_err(|e| e.in_file(&path))?;
    Ok(Study { summary, costs: costs(&folder.join("trials.csv"))? })
}

fn costs(path: &Path) -> Result<Costs, Error> {
    let file = text::open_table(path)?;
    let mut costs = Costs::new();
    for row in csv::Reader::from_reader(BufReader::new(file)).deserialize() {
        let TrialRow { scenario, method, trial, status, raw_cost, cost, .. } =
            row.map_err(|e| Error::file(path, e.to_string()))?;
        if let (TrialStatus::Ended(Status::Solved), Some(raw), Some(cost)) = (status, raw_cost, cost) {
            let method_of_table = (text_of(&scenario).to_string(), text_of(&method).to_string());
            costs.entry(method_of_table).or_default().push(Cost { trial, raw, cost });
        }
    }
    Ok(costs)
}
