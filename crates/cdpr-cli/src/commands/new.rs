//! `cdpr new`

use std::path::Path;

use cdpr_core::Error;
use cdpr_core::geometry::Point;
use cdpr_core::watch::Watch;
use cdpr_files::text::Notation;
use cdpr_files::{NewScene, Starter, example, example_text, save_example_files, starter_scene, starter_text};

use crate::Answer;
use crate::args::{Format, NewArgs};
use crate::interruption::writing;
use crate::output::{Console, STANDARD, count, is_stream, lossy, position};
use crate::progress::with_progress;

const STARTER: &str = include_str!("../../assets/starter.toml");

pub fn run(args: &NewArgs, out: &Console) -> Result<Answer, Error> {
    if let Some(folder) = &args.example_files {
        return save_files(folder, args, out);
    }
    let Some(path) = args.output.as_ref().filter(|path| !is_stream(path)) else {
        let notation = match args.format {
            Format::Text => Notation::Toml,
            Format::Json => Notation::Json,
        };
        let (scene, _) = text(args, notation, Path::new("scene.toml"), out)?;
        out.write(args.output.as_deref().unwrap_or(Path::new(STANDARD)), scene.as_bytes(), "")?;
        return Ok(Answer::Yes);
    };
    let notation = Notation::of(path)?;
    if path.exists() && !args.force {
        return Err(Error::file(path, "already exists; choose another name or overwrite it with --force"));
    }
    let (scene, has_query) = text(args, notation, path, out)?;
    out.write(path, scene.as_bytes(), "")?;
    if args.format == Format::Json {
        out.result(&format!("{:#}", serde_json::json!({ "output": lossy(path), "query": has_query })));
    }
    out.say(&match has_query {
        true => format!("next: cdpr plan {} -o path.json --html view.html", path.display()),
        false => format!("next: cdpr info {}", path.display()),
    });
    Ok(Answer::Yes)
}

fn save_files(folder: &Path, args: &NewArgs, out: &Console) -> Result<Answer, Error> {
    let _writing = writing();
    let files = save_example_files(folder, args.force)?;
    if args.format == Format::Json {
        let names: Vec<_> = files.iter().map(|path| lossy(path)).collect();
        out.result(&format!("{:#}", serde_json::json!({ "output": lossy(folder), "files": names })));
    }
    // Those that were there already are not written again.
    out.say(&format!("{} in {}", count(files.len(), "example file"), folder.display()));
    out.say(&format!("next: cdpr import {} -o cogiro.toml", folder.join("caspr/CoGiRo").display()));
    Ok(Answer::Yes)
}

/// The scene in the notation for this file name, and whether it has a start and a goal.
fn text(args: &NewArgs, notation: Notation, path: &Path, out: &Console) -> Result<(String, bool), Error> {
    if let Some(name) = &args.example {
        return Ok((example_text(name, notation)?, example(name)?.start().is_some()));
    }
    let Some(robot) = &args.robot else { return Ok((unfilled(notation)?, true)) };
    let end = |given: &Option<Vec<f64>>| given.as_deref().map(Point::from_slice);
    let starter = Starter {
        robot: robot.clone(),
        obstacles: args.obstacle.clone(),
        units: args.units,
        start: end(&args.start),
        goal: end(&args.goal),
    };
    let new =
        with_progress(out, "looking for a start and a goal", |stop| starter_scene(&starter, path, &Watch::on(stop)))?;
    tell(&new, out);
    Ok((starter_text(&new, notation)?, new.scene.start().and(new.scene.goal()).is_some()))
}

fn unfilled(notation: Notation) -> Result<String, Error> {
    match notation {
        Notation::Toml => Ok(STARTER.to_string()),
        Notation::Json => {
            let scene = cdpr_files::scene_from_text(STARTER, Notation::Toml, None)?;
            Ok(format!("{:#}\n", serde_json::json!(scene.spec())))
        }
    }
}

fn tell(NewScene { scene, unheld, lacking, .. }: &NewScene, out: &Console) {
    out.in_brief(scene, scene.notes()).iter().for_each(|note| out.note(note));
    unheld.iter().for_each(|why| out.note(&format!("{why}; so the scene has no [wrench], which would require it")));
    match (lacking, scene.start().zip(scene.goal())) {
        (None, Some((start, goal))) => {
            out.say(&format!("query: a path from {} to {}", position(&start), position(&goal)))
        }
        (Some(why), Some(_)) => out.note(&format!("{why}; cdpr plan tells more")),
        (why, None) => {
            let why = why.iter().map(|why| format!("{why}; ")).collect::<String>();
            out.note(&format!("{why}put start and goal under [query], or use --start and --goal"))
        }
    }
}
