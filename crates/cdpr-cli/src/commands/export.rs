//! `cdpr export`

use cdpr_core::{Choice, Error, Recorded, Scene};
use cdpr_files::{Control, Mjcf, mjcf, save_mjcf};
use serde_json::json;

use crate::Answer;
use crate::args::{ExportArgs, Format};
use crate::input::{self, Given};
use crate::output::{Console, count, is_stream, lossy, scene_line};

pub fn run(args: &ExportArgs, out: &Console) -> Result<Answer, Error> {
    let out = &out.beside(Some(&args.output));
    let (scene, motion) = given(args, out)?;
    let blamed = |error: Error| match (error.place(), &args.motion) {
        (Some("tension" | "length"), Some(motion)) => error.in_file(input::name_of(motion)),
        _ => args.given.blamed(error, input::name_of(&args.scene.scene)),
    };
    let made = mjcf(&scene, motion.as_ref(), args.control).map_err(blamed)?;
    out.in_brief(&scene, scene.notes()).iter().chain(&made.notes).for_each(|note| out.note(note));
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", summary(args, &scene, motion.as_ref(), &made))),
        Format::Text => {
            out.result(&scene_line(&scene));
            out.result(&line(&scene, motion.as_ref(), &made, args.control));
        }
    }
    if is_stream(&args.output) {
        out.write(&args.output, made.model.as_bytes(), "")?;
    } else {
        let hint = args.motion_output().map_or(String::new(), |motion| format!("and {}", motion.display()));
        out.save(&args.output, &hint, || save_mjcf(&args.output, &made))?;
    }
    Ok(Answer::Yes)
}

/// The scene, and the motion if there is one.
fn given(args: &ExportArgs, out: &Console) -> Result<(Scene, Option<Recorded>), Error> {
    let Some(path) = &args.motion else { return Ok((input::scene(&args.scene, out)?, None)) };
    let wrong = |found: &str, hints: &[String]| {
        let error = Error::invalid("", format!("found {found}, expected a trajectory")).with_hints(hints);
        Err(error.in_file(input::name_of(path)))
    };
    match input::path_trajectory_or_proof(&args.scene, path, args.strict, out)? {
        Given::Trajectory(found) => Ok((found.0, Some(found.1.motion))),
        Given::Path(_) => wrong("a path without times", &["or time it: cdpr trajectory".to_string()]),
        Given::Proof(_) => wrong("a proof", &[]),
    }
}

fn summary(args: &ExportArgs, scene: &Scene, motion: Option<&Recorded>, made: &Mjcf) -> serde_json::Value {
    json!({
        "model": lossy(&args.output),
        "motion": args.motion_output().map(|path| lossy(&path)),
        "control": args.control,
        "cables": scene.robot().cables().len(),
        "wheels": made.wheels,
        "obstacles": scene.obstacles().len(),
        "samples": motion.map(|motion| motion.times.len()),
        "notes": made.notes,
    })
}

fn line(scene: &Scene, motion: Option<&Recorded>, made: &Mjcf, control: Control) -> String {
    let wheels = if made.wheels > 0 { format!(" round {}", count(made.wheels, "wheel")) } else { String::new() };
    let samples = motion.map_or(String::new(), |motion| format!(", {}", count(motion.times.len(), "sample")));
    let cables = count(scene.robot().cables().len(), "cable");
    format!("model: {cables}{wheels}, control {}{samples}", control.name())
}
