//! A finished run as one self-contained HTML page: tables, and the paper's numbers beside ours.

mod paper;
mod study;
mod tables;

pub use study::{Cost, Costs, Study};

use cdpr_view::escaped;

const STYLE: &str = ":root{color-scheme:light dark;--text:#1b1f24;--muted:#545c66;--line:#d5dae0}\
@media(prefers-color-scheme:dark){:root{--text:#eceff3;--muted:#a9b1bb;--line:#434b56}html{background:#14171c}}\
body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:72rem;padding:0 1rem;color:var(--text)}\
table{border-collapse:collapse;font-size:13px}th,td{padding:.2rem .6rem;border-bottom:1px solid var(--line);\
text-align:left;white-space:nowrap}th{border-bottom:2px solid var(--muted)}td.n,th.n{text-align:right;\
font-variant-numeric:tabular-nums}.wide{overflow-x:auto}\
summary{cursor:pointer;font-weight:bold;margin:.5rem 0}\
@media print{:root{--text:#000;--muted:#555;--line:#ccc}html{background:none}tr{break-inside:avoid}}";

/// A note on how to read the lengths of scenarios in which the platform may turn.
fn turns(scenarios: &[String]) -> String {
    if scenarios.is_empty() {
        return String::new();
    }
    let names: Vec<String> = scenarios.iter().map(|name| format!("\u{201c}{}\u{201d}", escaped(name))).collect();
    format!(
        "<p>The platform may turn in {}: costs there are lengths of translations plus the weight of turns times their angles, and \
         post-processing other than none shortens positions and orientations together.</p>\n",
        names.join(", ")
    )
}

/// The page; it loads nothing, has no script, and no name in the study can add markup to it.
///
/// # Example
/// ```
/// use cdpr_study::SummaryFile;
/// use cdpr_study::report::{Study, page};
/// let summary = r#"{"experiment": "<b>", "fingerprint": "", "confidence": 0.95, "methods": [], "t_tests": []}"#;
/// let summary: SummaryFile = serde_json::from_str(summary).unwrap();
/// let page = page(&Study { summary, costs: Default::default() });
/// assert!(page.starts_with("<!doctype html>") && page.contains("&lt;b&gt;") && !page.contains("<b>"));
/// ```
pub fn page(study: &Study) -> String {
    let summary = &study.summary;
    let title = escaped(&summary.experiment);
    let paper = paper::printed(&summary.experiment);
    let printed = paper.map(|(_, printed)| printed);
    let unsolved: usize = summary.methods.iter().map(|m| m.n - m.solved.min(m.n)).sum();
    let mut body = format!(
        "<h1>{title}</h1>\n<p>Statistics cover solved trials only; {unsolved} unsolved rows are left out.</p>\n"
    );
    body += &turns(&summary.turning);
    if let Some((paper, printed)) = paper {
        let (note, citation) = (escaped(&printed.note), escaped(&paper.citation));
        body += &format!("<h2>Comparison with the paper</h2>\n<p>{note} Source: {citation}.</p>\n");
        if !printed.means.is_empty() {
            body += &tables::beside(study, printed);
            body +=
                "<p>Intervals of the percentages are 95 % intervals by the delta method for independent samples.</p>\n";
            body += &tables::claims(study, printed);
        }
    }
    body += &tables::orders(study, printed);
    if !summary.t_tests.is_empty() {
        body += &format!("<h2>Two-sample t-tests</h2>\n{}", tables::t_tests(study, printed));
    }
    if !summary.pairs.is_empty() {
        body += "<h2>Lengths in the same scenes</h2>\n<p>Means of methods that solved different trials are those of different scenes. \
                 Here each method is compared with the first one of its scenario, in the trials that both solved.</p>\n";
        body += &tables::pairs(study);
    }
    body += &format!("<h2>Statistics</h2>\n{}", tables::statistics(study));
    body += &format!("<h2>How it was run</h2>\n{}{}", tables::origins(study), tables::rules(study));
    body += &format!("<p>Fingerprint {}.</p>\n", escaped(&summary.fingerprint));
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>{title} – cdpr</title>\
         <style>{STYLE}</style></head>\n<body>\n{body}</body></html>\n"
    )
}
