//! `cdpr check`

use cdpr_core::Error;
use cdpr_core::collision::path_check::{PathClearance, PathReport, PathViolation};
use cdpr_core::plan::{CheckReport, check, engine_within};
use cdpr_core::watch::Watch;
use cdpr_core::words::length;
use cdpr_core::wrench::{PathWrench, tensions::TensionPlace};

use crate::Answer;
use crate::args::{Format, PathArgs};
use crate::input;
use crate::output::{Console, Verdict, count, scene_line, short, thousandths};
use crate::progress::interrupted;

pub fn run(args: &PathArgs, out: &Console) -> Result<Answer, Error> {
    let (scene, path) = input::scene_and_path(args, out)?;
    let (watch, in_scene) = (Watch::on(&interrupted), |e: Error| e.in_file(&args.scene.scene));
    let engine = engine_within(&scene, args.checker.engine, args.checker.interference, &watch).map_err(in_scene)?;
    out.notes(engine.constraints());
    let found = check(&scene, &*engine, &path.waypoints, &watch).map_err(in_scene)?;
    let CheckReport { path: report, wrench } = &found;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(found))),
        Format::Text => {
            out.result(&scene_line(&scene));
            out.verdict(&verdict(report, path.waypoints.len()));
            report.violations.iter().for_each(|v| out.result(&violation_line(v)));
            report.min_clearance.iter().for_each(|nearest| out.result(&nearest_line(nearest)));
            wrench.iter().flat_map(wrench_lines).for_each(|line| out.result(&line));
        }
    }
    Ok(if report.valid { Answer::Yes } else { Answer::No })
}

fn verdict(report: &PathReport, waypoints: usize) -> Verdict {
    let path = format!(" {} m, {}", short(report.length), count(waypoints, "waypoint"));
    if report.valid {
        Verdict::yes("valid:", path)
    } else {
        Verdict::no("not valid:", format!("{path}, {}", count(report.violations.len(), "violation")))
    }
}

fn violation_line(v: &PathViolation) -> String {
    format!("  segment {} at {:.3}: {}", v.segment, v.violation.at, v.violation.sentence())
}

/// The nearest approach in words.
pub fn nearest_line(nearest: &PathClearance) -> String {
    format!(
        "nearest approach {}: {} at {:.3} of segment {}",
        length(nearest.value),
        nearest.culprits.join(" and "),
        nearest.at,
        nearest.segment
    )
}

/// The scarcest wrenches and the range of tensions in words.
pub fn wrench_lines(wrench: &PathWrench) -> Vec<String> {
    let PathWrench { min_wrench_margin: least, tension_range } = wrench;
    let place = |at: f64, segment: usize| format!("at {at:.3} of segment {segment}");
    let margin = least.value.map_or("a cable without direction".to_string(), |value| {
        format!("least {} margin {} {}", least.limit.measure, thousandths(value), least.limit.unit)
    });
    let mut lines = vec![format!("{margin} {}", place(least.at, least.segment))];
    match tension_range {
        None => lines.push("the loads cannot be balanced everywhere on it".to_string()),
        Some(range) => {
            let told = |t: &TensionPlace| format!("{:.3} N ({} {})", t.value, t.cable, place(t.at, t.segment));
            lines.push(format!("tensions from {} to {}", told(&range.min), told(&range.max)));
        }
    }
    lines
}
