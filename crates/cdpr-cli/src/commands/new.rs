//! `cdpr new`

use std::path::Path;

use cdpr_core::geometry::Point;
use cdpr_core::wrench::Hold;
use cdpr_core::{Error, Scene};
use cdpr_files::text::Notation;
use cdpr_files::{Starter, starter_scene, starter_text};

use crate::Answer;
use crate::args::{Format, NewArgs};
use crate::output::{Console, STANDARD, is_stream, position};
use crate::progress::with_sign_of_life;

const STARTER: &str = include_str!("../../assets/starter.toml");

pub fn run(args: &NewArgs, out: &Console) -> Result<Answer, Error> {
    let Some(path) = args.output.as_ref().filter(|path| !is_stream(path)) else {
        let notation = match args.format {
            Format::Text => Notation::Toml,
            Format::Json => Notation::Json,
        };
        let scene = text(args, notation, Path::new("scene.toml"), out)?;
        out.write(args.output.as_deref().unwrap_or(Path::new(STANDARD)), scene.as_bytes(), "")?;
        return Ok(Answer::Yes);
    };
    let notation = Notation::of(path)?;
    if path.exists() && !args.force {
        return Err(Error::file(path, "already exists; choose another name or overwrite it with --force"));
    }
    out.write(path, text(args, notation, path, out)?.as_bytes(), "")?;
    out.say(&format!("next: cdpr plan {} -o path.json --html view.html", path.display()));
    Ok(Answer::Yes)
}

/// The scene in the notation for this file name.
fn text(args: &NewArgs, notation: Notation, path: &Path, out: &Console) -> Result<String, Error> {
    let Some(robot) = &args.robot else { return example(notation) };
    let end = |given: &Option<Vec<f64>>| given.as_deref().map(Point::from_slice);
    let starter = Starter {
        robot: robot.clone(),
        obstacles: args.obstacle.clone(),
        units: args.units,
        start: end(&args.start),
        goal: end(&args.goal),
    };
    let (spec, scene, solvable) =
        with_sign_of_life(out, "looking for a start and a goal", |stop| starter_scene(&starter, path, stop))?;
    tell(&scene, solvable, out);
    starter_text(&spec, notation)
}

fn example(notation: Notation) -> Result<String, Error> {
    match notation {
        Notation::Toml => Ok(STARTER.to_string()),
        Notation::Json => {
            let scene = cdpr_files::scene_from_text(STARTER, Notation::Toml, None)?;
            Ok(format!("{:#}\n", serde_json::json!(scene.spec())))
        }
    }
}

fn tell(scene: &Scene, solvable: bool, out: &Console) {
    out.in_brief(scene, scene.notes()).iter().for_each(|note| out.note(note));
    match (scene.start(), scene.goal()) {
        (Some(start), Some(goal)) if !solvable => {
            let ends = format!("from {} to {}", position(&start), position(&goal));
            out.note(&format!("a short search found no path {ends}; run cdpr plan for details"));
        }
        (Some(start), Some(goal)) => {
            out.say(&format!("query: a path from {} to {}", position(&start), position(&goal)))
        }
        _ => out.note("found no two positions with a path between them; add start and goal under [query]"),
    }
    let room = scene.workspace();
    let middle = Point::from((room.min.coords + room.max.coords) / 2.0);
    let hold = scene.wrench().and_then(|_| Hold::at(scene.robot(), scene.orientation(), &middle));
    if let Some(hold) = hold.filter(|hold| !hold.is_full()) {
        out.note(&format!("{}; no position meets the requirements of [wrench]", hold.sentence()));
    }
}
