//! `cdpr import`

use cdpr_core::Error;
use cdpr_files::{ImportOptions, Imported, robot_toml, save_imported};

use crate::Answer;
use crate::args::{Format, ImportArgs};
use crate::input::loader;
use crate::output::{Console, count, is_stream, lossy};

pub fn run(args: &ImportArgs, out: &Console) -> Result<Answer, Error> {
    let out = &out.beside(Some(&args.output));
    let options = ImportOptions {
        bodies: args.bodies.clone(),
        cable_set: args.cable_set.clone(),
        platform: args.platform.clone().map(|mesh| (mesh, args.units)),
    };
    let found = loader().import(&args.source, &options).map_err(|e| args.given.named(e).0)?;
    if is_stream(&args.output) {
        out.write(&args.output, robot_toml(&found).as_bytes(), "")?;
    } else {
        out.save(&args.output, "", || save_imported(&args.output, &found))?;
    }
    match args.format {
        Format::Json => {
            let summary = serde_json::json!({
                "output": lossy(&args.output),
                "robot": found.robot.name,
                "cables": found.robot.cables.len(),
                "origin": found.origin,
                "not_carried_over": found.notes,
            });
            out.result(&format!("{summary:#}"));
        }
        Format::Text => lines(&found).iter().for_each(|line| out.result(line)),
    }
    Ok(Answer::Yes)
}

fn lines(found: &Imported) -> Vec<String> {
    let robot = &found.robot;
    let name = robot.name.as_deref().unwrap_or("robot");
    let mass = robot.mass.map_or("no mass".to_string(), |mass| format!("{mass} kg"));
    let mut lines = vec![format!("{name}: {}, {mass}", count(robot.cables.len(), "cable"))];
    if !found.notes.is_empty() {
        lines.push("not carried over:".to_string());
        lines.extend(found.notes.iter().map(|note| format!("  {note}")));
    }
    lines
}
