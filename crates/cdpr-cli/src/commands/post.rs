//! `cdpr post`

use std::path::Path;

use cdpr_core::Error;
use cdpr_core::collision::path_check::path_length;
use cdpr_core::plan::{engine_within, shorten_path};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_files::PathFile;

use crate::Answer;
use crate::args::{Format, PostArgs};
use crate::input;
use crate::interruption::{interrupted, writing};
use crate::output::{Console, count, is_stream, scene_line, short};
use crate::progress::with_sign_of_life;

/// Checks that a path can be written under this name, before any work is done.
pub fn check_path_name(path: Option<&Path>) -> Result<(), Error> {
    path.filter(|path| !is_stream(path)).map_or(Ok(()), cdpr_files::check_path_name)
}

/// Writes a path: JSON or CSV by the extension, JSON to standard output, pipes and devices.
pub fn save_path(path: &Path, file: &PathFile, out: &Console) -> Result<(), Error> {
    if is_stream(path) {
        return out.write(path, format!("{:#}\n", serde_json::json!(file)).as_bytes(), "");
    }
    let writing = writing();
    cdpr_files::save_path(path, file)?;
    drop(writing);
    out.wrote(path, "");
    Ok(())
}

pub fn run(args: &PostArgs, out: &Console) -> Result<Answer, Error> {
    check_path_name(args.output.as_deref())?;
    let out = &out.beside(args.output.as_deref());
    let given = &args.path;
    let (scene, path) = input::scene_and_level_path(given, "rewinding and string pulling are", out)?;
    let engine = engine_within(&scene, given.checker.engine, given.checker.interference, &Watch::on(&interrupted))
        .map_err(|e| e.in_file(&given.scene.scene))?;
    out.remarks(engine.conditions());
    let processing = args.options()?;
    let shorten = |stop: &Interrupt| shorten_path(&*engine, &path.waypoints, &processing, &Watch::on(stop));
    let shorter = with_sign_of_life(out, "shortening", shorten).map_err(|e| e.in_file(&given.path))?;
    let file = PathFile::of(&scene, &shorter);
    match given.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(file))),
        Format::Text => {
            out.result(&scene_line(&scene));
            out.result(&format!(
                "{} m with {} (was {} m with {})",
                short(path_length(&shorter)),
                count(shorter.len(), "waypoint"),
                short(path_length(&path.waypoints)),
                path.waypoints.len()
            ));
        }
    }
    if let Some(output) = &args.output {
        save_path(output, &file, out)?;
    }
    Ok(Answer::Yes)
}
