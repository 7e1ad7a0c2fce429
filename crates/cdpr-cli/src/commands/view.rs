//! `cdpr view`

use std::path::Path;

use cdpr_core::Error;
use cdpr_core::collision::check_path;
use cdpr_core::plan::engine_within;
use cdpr_core::watch::Watch;
use cdpr_files::{LoadedPath, PathFile};
use cdpr_view::page_within;

use crate::Answer;
use crate::args::{Format, ViewArgs};
use crate::input;
use crate::interruption::interrupted;
use crate::output::{Console, is_stream, lossy};

/// What the user can do with a page.
pub const IN_BROWSER: &str = "(open it in a browser)";

pub fn run(args: &ViewArgs, out: &Console) -> Result<Answer, Error> {
    check_page_name(&args.output)?;
    let out = &out.beside(Some(&args.output));
    let watch = Watch::on(&interrupted);
    let scene = input::scene(&args.scene, out)?;
    let (scene, shown, violations) = match &args.path {
        None => (scene, None, Vec::new()),
        Some(path) => {
            let (scene, loaded) = input::path(&scene, &args.scene, path, args.strict, out)?;
            let engine = engine_within(&scene, args.checker.engine, args.checker.interference, &watch)
                .map_err(|e| e.in_file(&args.scene.scene))?;
            let report = check_path(&*engine, &loaded.waypoints, &watch)?;
            (scene, Some(shown(&loaded, report.length)), report.violations)
        }
    };
    let page = page_within(&scene, shown.as_ref(), &violations, &watch)?;
    out.write(&args.output, page.as_bytes(), IN_BROWSER)?;
    if args.scene.format == Format::Json {
        out.result(&serde_json::json!({ "page": lossy(&args.output), "violations": violations }).to_string());
    }
    Ok(Answer::Yes)
}

/// Checks that a page can be written under this name, before any work is done.
pub fn check_page_name(path: &Path) -> Result<(), Error> {
    match cdpr_files::text::extension(path).as_deref() {
        Some("html" | "htm") => Ok(()),
        _ if is_stream(path) => Ok(()),
        _ => Err(cdpr_files::text::other_extension(path, ".html")),
    }
}

/// The path as its file tells it, with the length found now.
fn shown(loaded: &LoadedPath, length: f64) -> PathFile {
    let waypoints = loaded.waypoints.iter().map(|p| (*p).into()).collect();
    PathFile { waypoints, cost: Some(length), ..loaded.file.clone().unwrap_or_default() }
}
