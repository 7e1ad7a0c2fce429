//! `cdpr check` of a task: each leg in the scene that holds then.

use std::path::Path;

use cdpr_core::geometry::Pose;
use cdpr_core::path::{self, CheckReport};
use cdpr_core::planning::Status;
use cdpr_core::task::{LegKeys, TaskFile, TaskLeg};
use cdpr_core::tolerances::{SAME_POINT, SAME_TURN};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::{Choice, Error, Scene};
use cdpr_files::{SceneId, load_waypoints, scene_of_path};

use super::task::{leg_words, reason};
use crate::Answer;
use crate::args::{Format, PathArgs};
use crate::input;
use crate::output::{Console, Verdict, count, scene_line, short};
use crate::progress::with_progress;

/// The report on a leg; `None` if it has no path.
type LegReport = Option<CheckReport>;

pub fn run(args: &PathArgs, scene: &Scene, file: &TaskFile, out: &Console) -> Result<Answer, Error> {
    let legs = file.legs(scene).map_err(|e| e.in_file(&args.path))?;
    same_scene(args, scene, &file.scene, out)?;
    let mut reports: Vec<LegReport> = Vec::new();
    for (k, (leg, keys)) in legs.legs.iter().zip(&file.legs).enumerate() {
        reports.push(checked(args, &format!("legs[{k}]"), leg, keys, out)?);
    }
    let valid = reports.iter().all(|report| report.as_ref().is_some_and(|report| report.path.valid));
    let length: f64 = reports.iter().flatten().map(|report| report.path.length).sum();
    match args.scene.format {
        Format::Json => {
            out.result(&format!("{:#}", serde_json::json!({ "valid": valid, "length": length, "legs": reports })))
        }
        Format::Text => {
            out.result(&scene_line(scene));
            let (legs, words) = (count(reports.len(), "leg"), format!(" {} m", short(length)));
            out.verdict(&match valid {
                true => Verdict::yes("valid:", format!("{words} in {legs}")),
                false => Verdict::no("not valid:", format!("{words} in {legs}, {}", faults(&reports))),
            });
            for (k, (report, keys)) in reports.iter().zip(&file.legs).enumerate() {
                lines(k, report, keys).iter().for_each(|line| out.result(line));
            }
        }
    }
    Ok(if valid { Answer::Yes } else { Answer::No })
}

/// Warns if the task was planned for another scene; refuses it with `--strict`.
fn same_scene(args: &PathArgs, scene: &Scene, planned_for: &SceneId, out: &Console) -> Result<(), Error> {
    let own = SceneId::of(scene);
    if own.fingerprint == planned_for.fingerprint {
        return Ok(());
    }
    let words = |id: &SceneId| format!("\"{}\" ({})", id.name, id.fingerprint);
    let found = format!("a task planned for another scene: {}", words(planned_for));
    if args.strict.strict {
        let problem = format!("found {found}, expected one for {}", words(&own));
        return Err(Error::invalid("scene", problem).in_file(&args.path));
    }
    out.warning(&format!("{}: {found}; the results are for {}", args.path.display(), words(&own)));
    Ok(())
}

fn checked(args: &PathArgs, place: &str, leg: &TaskLeg, keys: &LegKeys, out: &Console) -> Result<LegReport, Error> {
    if keys.status != Status::Solved.name() {
        return Ok(None);
    }
    let file = args.path.parent().unwrap_or(Path::new("")).join(&keys.path);
    let loaded = load_waypoints(&file)?;
    let (scene, warning) = scene_of_path(&leg.scene, &loaded, args.strict.strict).map_err(|e| e.in_file(&file))?;
    warning.iter().for_each(|warning| out.warning(&format!("{}: {warning}", file.display())));
    let path = loaded.path(&scene);
    joined(leg, &path).map_err(|problem| Error::invalid(format!("{place}.path"), problem).in_file(&args.path))?;
    let compiled = input::compiled(&scene, &path, &args.scene, args.checker)?;
    let check = |stop: &Interrupt| path::check(&compiled, &path, &Watch::on(stop));
    with_progress(out, "checking", check).map(Some).map_err(|e| e.in_file(&file))
}

/// Checks that a path begins and ends where its leg does, and passes what the leg passes.
fn joined(leg: &TaskLeg, path: &[Pose]) -> Result<(), String> {
    let same = |a: &Pose, b: &Pose| (a.position - b.position).norm() <= SAME_POINT && a.angle_to(b) <= SAME_TURN;
    let [first, last] = [&path[0], &path[path.len() - 1]];
    for (what, found, expected) in [("begins", first, &leg.from.pose), ("ends", last, &leg.to.pose)] {
        if !same(found, expected) {
            let [found, expected] = [found, expected].map(|pose| <[f64; 3]>::from(pose.position));
            return Err(format!(
                "found a path that {what} at {found:?}, expected {expected:?} and the orientation there"
            ));
        }
    }
    let mut rest = path.iter();
    match leg.via.iter().find(|via| !rest.any(|pose| same(pose, via))) {
        Some(via) => {
            Err(format!("found a path that does not pass {:?}, expected it there", <[f64; 3]>::from(via.position)))
        }
        None => Ok(()),
    }
}

fn faults(reports: &[LegReport]) -> String {
    let lacking = reports.iter().filter(|report| report.is_none()).count();
    let violations: usize = reports.iter().flatten().map(|report| report.path.violations.len()).sum();
    let lacking = (lacking > 0).then(|| format!("{} without a path", count(lacking, "leg")));
    let violations = (violations > 0).then(|| count(violations, "violation"));
    lacking.into_iter().chain(violations).collect::<Vec<_>>().join(", ")
}

fn lines(k: usize, report: &LegReport, keys: &LegKeys) -> Vec<String> {
    let Some(report) = report else { return vec![format!("  {}: {}", leg_words(k, keys), reason(keys))] };
    let violations = report.path.violations.iter();
    let line = |v: &cdpr_core::PathViolation| {
        let place = format!("segment {} at {:.3}", v.segment, v.violation.at);
        format!("  {}, {place}: {}", leg_words(k, keys), v.violation.sentence())
    };
    violations.map(line).collect()
}
