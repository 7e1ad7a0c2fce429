//! Reads the results of a run and writes its report.

use std::fs;
use std::io::BufReader;
use std::path::Path;

use crate::report::{Cost, Costs, Plot, Study};
use crate::{SummaryFile, TrialRow, TrialStatus};
use cdpr_core::error::Error;
use cdpr_core::planning::Status;
use cdpr_files::csv_cell::text_of;
use cdpr_files::output::write_atomically;
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

/// Writes each plot as SVG and as PNG to a folder, which is created if necessary.
///
/// # Errors
/// A folder or file that cannot be written.
pub fn save_plots(folder: impl AsRef<Path>, plots: &[Plot]) -> Result<(), Error> {
    let folder = folder.as_ref();
    fs::create_dir_all(folder).map_err(|e| Error::system(folder, "cannot be created", e))?;
    for (k, plot) in plots.iter().enumerate() {
        let path = folder.join(format!("{:02}-{}", k + 1, slug(&plot.title)));
        write_atomically(path.with_extension("svg"), plot.svg().as_bytes())?;
        write_atomically(path.with_extension("png"), &png(plot))?;
    }
    Ok(())
}

fn png(plot: &Plot) -> Vec<u8> {
    let (pixels, (width, height)) = plot.pixels();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&pixels));
    written.expect("writing to memory");
    bytes
}

/// Letters and digits of a title, in lower case, joined by hyphens.
fn slug(title: &str) -> String {
    let words = title.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let slug: Vec<String> = words.map(str::to_ascii_lowercase).collect();
    slug.join("-").chars().take(80).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_plots_stay_in_their_folder() {
        assert_eq!(slug("../Hard 1, <b>: path cost"), "hard-1-b-path-cost");
    }
}
