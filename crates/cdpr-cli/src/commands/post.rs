//! `cdpr post`

use cdpr_core::collision::path_check::path_length;
use cdpr_core::plan::{engine_for, shorten_path};
use cdpr_core::{Error, io};

use crate::Answer;
use crate::args::{Format, PostArgs};
use crate::output::{count, result, say, say_notes, scene_line, short};
use crate::progress::with_sign_of_life;

pub fn run(args: &PostArgs) -> Result<Answer, Error> {
    args.output.as_deref().map(io::check_path_name).transpose()?;
    let given = &args.path;
    let (scene, path) = io::load_path_of(&given.scene.load()?, &given.path)?;
    let engine = engine_for(&scene, given.checker.engine, given.checker.interference)
        .map_err(|e| e.in_file(&given.scene.scene))?;
    say_notes(engine.constraints());
    let processing = args.options()?;
    let shorten = |stop: &dyn Fn() -> bool| shorten_path(&*engine, &path.waypoints, &processing, stop);
    let shorter = with_sign_of_life("shortening", shorten).map_err(|e| e.in_file(&given.path))?;
    let json = io::path_json(&scene, &shorter);
    match given.scene.format {
        Format::Json => result(&format!("{json:#}")),
        Format::Text => {
            result(&scene_line(&scene));
            result(&format!(
                "{} m with {} (was {} m with {})",
                short(path_length(&shorter)),
                count(shorter.len(), "waypoint"),
                short(path_length(&path.waypoints)),
                path.waypoints.len()
            ));
        }
    }
    if let Some(output) = &args.output {
        io::save_path(output, &json)?;
        say(&format!("wrote {}", output.display()));
    }
    Ok(Answer::Yes)
}
