//! `cdpr post`

use std::path::Path;

use cdpr_core::collision::path_check::path_length;
use cdpr_core::geometry::Pose;
use cdpr_core::plan::{engine_within, shorten_path, shorten_poses};
use cdpr_core::turning::pose_path_length;
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::{Error, Scene};
use cdpr_files::PathFile;

use super::check::turns;
use crate::Answer;
use crate::args::{Format, PostArgs};
use crate::input;
use crate::interruption::{interrupted, writing};
use crate::output::{Console, count, is_stream, robot_line, scene_line, short};
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
    let (scene, path) = input::scene_and_path(given, out)?;
    if let Some(poses) = &path.poses {
        let found = "with a path on which the platform turns, which has its own way";
        args.given.refuse(&["--post", "--step", "--repeats"], found, "a path on which it keeps its orientation")?;
        return shorten_turning(args, &scene, poses, out);
    }
    let engine = engine_within(&scene, given.checker.engine, given.checker.interference, &Watch::on(&interrupted))
        .map_err(|e| e.in_file(&given.scene.scene))?;
    out.remarks(&scene, engine.conditions());
    let processing = args.options()?;
    let shorten = |stop: &Interrupt| shorten_path(&*engine, &path.waypoints, &processing, &Watch::on(stop));
    let shorter = with_sign_of_life(out, "shortening", shorten).map_err(|e| e.in_file(&given.path))?;
    let was = format!("was {} m with {}", short(path_length(&path.waypoints)), path.waypoints.len());
    let words = format!("{} m with {} ({was})", short(path_length(&shorter)), count(shorter.len(), "waypoint"));
    tell(args, &PathFile::of(&scene, &shorter), &[scene_line(&scene), words], out)
}

/// Shortens a path on which the platform turns, in the only way that there is.
fn shorten_turning(args: &PostArgs, scene: &Scene, poses: &[Pose], out: &Console) -> Result<Answer, Error> {
    let engine = input::turning_engine(scene, &args.path.scene.scene, args.path.checker)?;
    out.remarks(scene, engine.conditions());
    let shorten = |stop: &Interrupt| shorten_poses(scene, &engine, poses, &Watch::on(stop));
    let of_path = |e: &Error| e.place().is_some_and(|place| place.starts_with("waypoints"));
    let shorter = with_sign_of_life(out, "shortening", shorten)
        .map_err(|e| if of_path(&e) { e.in_file(&args.path.path) } else { e.in_file(&args.path.scene.scene) })?;
    let length = |poses: &[Pose]| short(pose_path_length(scene, poses));
    let was = format!("was {} m with {}", length(poses), poses.len());
    let words =
        format!("{} m with {} ({was}); {}", length(&shorter), count(shorter.len(), "waypoint"), turns(&shorter));
    tell(args, &PathFile::of_poses(scene, &shorter), &[robot_line(scene), words], out)
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
