//! `cdpr import`

use cdpr_core::Error;
use cdpr_core::io::{ImportOptions, Imported, check_robot_name, import_robot, save_imported};

use crate::Answer;
use crate::args::{Format, ImportArgs};
use crate::output::{count, result, say};

pub fn run(args: &ImportArgs) -> Result<Answer, Error> {
    check_robot_name(&args.output)?;
    let options = ImportOptions {
        bodies: args.bodies.clone(),
        cable_set: args.cable_set.clone(),
        platform: args.platform.clone().map(|mesh| (mesh, args.units)),
    };
    let found = import_robot(&args.source, &options)?;
    save_imported(&args.output, &found)?;
    match args.format {
        Format::Json => {
            let summary = serde_json::json!({
                "output": args.output,
                "robot": found.robot.name,
                "cables": found.robot.cables.len(),
                "origin": found.origin,
                "not_carried_over": found.notes,
            });
            result(&format!("{summary:#}"));
        }
        Format::Text => lines(&found).iter().for_each(|line| result(line)),
    }
    say(&format!("wrote {}", args.output.display()));
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
