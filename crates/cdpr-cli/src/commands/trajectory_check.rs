//! `cdpr check` for trajectories

use cdpr_core::model::spec::MotionSpec;
use cdpr_core::trajectory_check::{Fault, Recorded, TrajectoryReport, TrajectoryRules, check_trajectory};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::{Error, Scene};

use super::trajectory::{largest_lines, nearest_line};
use crate::Answer;
use crate::args::{Format, GivenOptions, PathArgs};
use crate::output::{Console, Verdict, count, scene_line, short};
use crate::progress::with_progress;

/// Maximum number of faults printed.
const MOST_FAULTS: usize = 16;

pub fn run(
    (args, given): (&PathArgs, &GivenOptions),
    limits: MotionSpec,
    scene: &Scene,
    motion: &Recorded,
    out: &Console,
) -> Result<Answer, Error> {
    let rules = TrajectoryRules { limits, engine: args.checker.engine, interference: args.checker.interference };
    let check = |stop: &Interrupt| check_trajectory(scene, motion, &rules, &Watch::on(stop));
    let report = with_progress(out, "checking", check).map_err(|e| given.blamed(e, &args.scene.scene))?;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(report))),
        Format::Text => {
            out.result(&scene_line(scene));
            out.verdict(&verdict(&report));
            lines(&report).iter().for_each(|line| out.result(line));
            report.notes.iter().for_each(|note| out.note(note));
        }
    }
    Ok(if report.valid { Answer::Yes } else { Answer::No })
}

fn verdict(report: &TrajectoryReport) -> Verdict {
    let TrajectoryReport { duration, length, samples, faults, .. } = report;
    let motion = format!(" {} s along {} m, {}", short(*duration), short(*length), count(*samples, "sample"));
    match report.valid {
        true => Verdict::yes("valid:", motion),
        false => Verdict::no("not valid:", format!("{motion}, {}", count(faults.len(), "fault"))),
    }
}

fn lines(report: &TrajectoryReport) -> Vec<String> {
    let TrajectoryReport { largest, faults, nearest, .. } = report;
    let mut lines = fault_lines(faults);
    lines.extend(largest_lines(largest));
    lines.push(match report.unseen_speed {
        None => "checked in exact form, also at ten instants between two samples".to_string(),
        Some(speed) => format!("checked at the samples; between them the speed may be {} m/s higher", short(speed)),
    });
    lines.extend(nearest.iter().map(nearest_line));
    lines
}

/// The first faults, and how many more there are.
pub fn fault_lines(faults: &[Fault]) -> Vec<String> {
    let more = faults.len().saturating_sub(MOST_FAULTS);
    let rest = (more > 0).then(|| format!("  {more} more, see --format json"));
    faults.iter().take(MOST_FAULTS).map(fault_line).chain(rest).collect()
}

fn fault_line(fault: &Fault) -> String {
    let during = match format!("{:.3}", fault.from) == format!("{:.3}", fault.to) {
        true => String::new(),
        false => format!(" (from {:.3} s to {:.3} s)", fault.from, fault.to),
    };
    format!("  at {:.3} s: {}{during}", fault.time, fault.message)
}
