//! `cdpr check`

use cdpr_core::collision::check_path;
use cdpr_core::collision::path_check::{PathClearance, PathReport, PathViolation};
use cdpr_core::plan::engine_for;
use cdpr_core::{Error, io};

use crate::Answer;
use crate::args::{Format, PathArgs};
use crate::output::{count, result, say_notes, scene_line, short};

pub fn run(args: &PathArgs) -> Result<Answer, Error> {
    let scene = io::load_scene(&args.scene.scene)?;
    let path = io::load_waypoints(&args.path, Some(&scene))?;
    let engine =
        engine_for(&scene, args.checker.engine, args.checker.interference).map_err(|e| e.in_file(&args.scene.scene))?;
    say_notes(engine.constraints());
    let report = check_path(&*engine, &path.waypoints);
    match args.scene.format {
        Format::Json => result(&format!("{:#}", serde_json::json!(report))),
        Format::Text => {
            result(&scene_line(&scene));
            result(&verdict(&report, path.waypoints.len()));
            report.violations.iter().for_each(|v| result(&violation_line(v)));
            report.min_clearance.iter().for_each(|nearest| result(&nearest_line(nearest)));
        }
    }
    Ok(if report.valid { Answer::Yes } else { Answer::No })
}

fn verdict(report: &PathReport, waypoints: usize) -> String {
    let path = format!("{} m, {}", short(report.length), count(waypoints, "waypoint"));
    if report.valid {
        format!("valid: {path}")
    } else {
        format!("not valid: {path}, {}", count(report.violations.len(), "violation"))
    }
}

fn violation_line(v: &PathViolation) -> String {
    format!("  segment {} at {:.3}: {}", v.segment, v.violation.at, v.violation.sentence())
}

/// The nearest approach in words.
pub fn nearest_line(nearest: &PathClearance) -> String {
    let millimetres = nearest.value * 1e3;
    format!(
        "nearest approach {millimetres:.3} mm: {} at {:.3} of segment {}",
        nearest.culprits.join(" and "),
        nearest.at,
        nearest.segment
    )
}
