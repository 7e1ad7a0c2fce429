//! `cdpr post`

use std::path::Path;

use cdpr_core::Error;
use cdpr_core::geometry::Pose;
use cdpr_core::path::length;
use cdpr_core::plan::shorten;
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_files::PathFile;

use super::check::turns;
use crate::Answer;
use crate::args::{Format, PostArgs};
use crate::input;
use crate::output::{Console, count, is_stream, robot_line, scene_line, short};
use crate::progress::with_progress;

/// Writes a path: JSON or CSV by the extension, JSON to standard output, pipes and devices.
pub fn save_path(path: &Path, file: &PathFile, out: &Console) -> Result<(), Error> {
    if is_stream(path) {
        return out.write(path, format!("{:#}\n", serde_json::json!(file)).as_bytes(), "");
    }
    out.save(path, "", || cdpr_files::save_path(path, file))
}

pub fn run(args: &PostArgs, out: &Console) -> Result<Answer, Error> {
    let out = &out.beside(args.output.as_deref());
    let given = &args.path;
    let (scene, path) = input::scene_and_path(given, out)?;
    let turning = !scene.keeps_orientation(&path);
    if turning {
        let found = "with a path on which the platform turns, which is shortened by string pulling";
        args.given.refuse(&["--post", "--step", "--repeats"], found, "a path on which it keeps its orientation")?;
    }
    let compiled = input::compiled(&scene, &path, &given.scene, given.checker)?;
    out.remarks(&scene, compiled.conditions());
    let processing = args.options()?;
    let shorten = |stop: &Interrupt| shorten(&compiled, &path, &processing, &Watch::on(stop));
    let of_scene = |e: &Error| turning && !e.place().is_some_and(|place| place.starts_with("waypoints"));
    let shorter = with_progress(out, "shortening", shorten)
        .map_err(|e| if of_scene(&e) { e.in_file(&given.scene.scene) } else { e.in_file(&given.path) })?;
    let told = |path: &[Pose]| short(length(&scene, path));
    let was = format!("was {} m with {}", told(&path), path.len());
    let more = if turning { format!("; {}", turns(&shorter)) } else { String::new() };
    let words = format!("{} m with {} ({was}){more}", told(&shorter), count(shorter.len(), "waypoint"));
    let line = if turning { robot_line(&scene) } else { scene_line(&scene) };
    tell(args, &PathFile::of(&scene, &shorter), &[line, words], out)
}

/// Prints the result, as lines or JSON, and writes it.
fn tell(args: &PostArgs, file: &PathFile, lines: &[String], out: &Console) -> Result<Answer, Error> {
    match args.path.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(file))),
        Format::Text => lines.iter().for_each(|line| out.result(line)),
    }
    if let Some(output) = &args.output {
        save_path(output, file, out)?;
    }
    Ok(Answer::Yes)
}
