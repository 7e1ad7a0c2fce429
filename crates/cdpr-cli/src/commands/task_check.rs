//! `cdpr check` of a task: each leg in the scene that holds then, and their motions.

use std::path::Path;

use cdpr_core::geometry::Pose;
use cdpr_core::path::{self, CheckReport};
use cdpr_core::planning::Status;
use cdpr_core::task::{LegKeys, TaskFile, TaskLeg, same_pose};
use cdpr_core::trajectory_check::TrajectoryReport;
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::{Choice, Error, Scene};
use cdpr_files::{SceneId, load_waypoints, scene_of_path};
use serde::Serialize;

use super::task::{leg_words, reason};
use super::task_motion_check::{LegMotion, of_leg, of_whole};
use super::trajectory_check::fault_lines;
use crate::Answer;
use crate::args::{CheckArgs, Format, PathArgs};
use crate::input;
use crate::output::{Console, Verdict, count, scene_line, short};
use crate::progress::with_progress;

/// The report on a leg; `None` if it has no path.
type LegReport = Option<Checked>;

/// The report on a leg with a path.
#[derive(Serialize)]
struct Checked {
    #[serde(flatten)]
    path: CheckReport,
    /// What was found about the leg's motion, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<TrajectoryReport>,
    /// Whether the leg should have a motion and has none.
    #[serde(skip)]
    untimed: bool,
}

impl Checked {
    fn valid(&self) -> bool {
        self.path.path.valid && !self.untimed && self.motion.as_ref().is_none_or(|motion| motion.valid)
    }
}

pub fn run(
    (given, args): (&CheckArgs, &PathArgs),
    scene: &Scene,
    file: &TaskFile,
    out: &Console,
) -> Result<Answer, Error> {
    let legs = file.legs(scene).map_err(|e| e.in_file(&args.path))?;
    same_scene(args, scene, &file.scene, out)?;
    let (mut reports, mut motions): (Vec<LegReport>, Vec<Option<LegMotion>>) = (Vec::new(), Vec::new());
    for (k, (leg, keys)) in legs.legs.iter().zip(&file.legs).enumerate() {
        let place = format!("legs[{k}]");
        let Some((path, report)) = checked(args, &place, leg, keys, out)? else {
            reports.push(None);
            motions.push(None);
            continue;
        };
        let limits = given.limits.spec();
        let motion = of_leg((given, &args.path), limits, (&leg.scene, &path), (&place, keys), out)?;
        let untimed = keys.motion.is_some() && motion.is_none();
        reports.push(Some(Checked {
            path: report,
            motion: motion.as_ref().map(|(_, report)| report.clone()),
            untimed,
        }));
        motions.push(motion);
    }
    of_whole(scene, &args.path, file, &motions)?;
    let valid = reports.iter().all(|report| report.as_ref().is_some_and(Checked::valid));
    let length: f64 = reports.iter().flatten().map(|report| report.path.path.length).sum();
    match args.scene.format {
        Format::Json => {
            let mut json = serde_json::json!({ "valid": valid, "length": length, "legs": reports });
            file.motion.iter().for_each(|motion| json["duration"] = motion.duration.into());
            out.result(&format!("{json:#}"));
        }
        Format::Text => {
            out.result(&scene_line(scene));
            let timed = file.motion.as_ref().map_or(String::new(), |motion| format!(", {} s", short(motion.duration)));
            let words = format!(" {} m in {}{timed}", short(length), count(reports.len(), "leg"));
            out.verdict(&match valid {
                true => Verdict::yes("valid:", words),
                false => Verdict::no("not valid:", format!("{words}, {}", faults(&reports))),
            });
            for (k, (report, keys)) in reports.iter().zip(&file.legs).enumerate() {
                lines(k, report, keys).iter().for_each(|line| out.result(line));
            }
            notes(&reports).iter().for_each(|note| out.note(note));
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

/// The path of a leg, if it has one, and the report on it.
fn checked(
    args: &PathArgs,
    place: &str,
    leg: &TaskLeg,
    keys: &LegKeys,
    out: &Console,
) -> Result<Option<(Vec<Pose>, CheckReport)>, Error> {
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
    let report = with_progress(out, "checking", check).map_err(|e| e.in_file(&file))?;
    Ok(Some((path, report)))
}

/// Checks that a path begins and ends where its leg does, and passes what the leg passes.
fn joined(leg: &TaskLeg, path: &[Pose]) -> Result<(), String> {
    let [first, last] = [&path[0], &path[path.len() - 1]];
    for (what, found, expected) in [("begins", first, &leg.from.pose), ("ends", last, &leg.to.pose)] {
        if !same_pose(found, expected) {
            let [found, expected] = [found, expected].map(|pose| <[f64; 3]>::from(pose.position));
            return Err(format!(
                "found a path that {what} at {found:?}, expected {expected:?} and the orientation there"
            ));
        }
    }
    let mut rest = path.iter();
    match leg.via.iter().find(|via| !rest.any(|pose| same_pose(pose, via))) {
        Some(via) => {
            Err(format!("found a path that does not pass {:?}, expected it there", <[f64; 3]>::from(via.position)))
        }
        None => Ok(()),
    }
}

fn faults(reports: &[LegReport]) -> String {
    let known = || reports.iter().flatten();
    let lacking = reports.iter().filter(|report| report.is_none()).count();
    let untimed = known().filter(|report| report.untimed).count();
    let violations: usize = known().map(|report| report.path.path.violations.len()).sum();
    let faults: usize = known().flat_map(|report| &report.motion).map(|motion| motion.faults.len()).sum();
    let parts = [
        (lacking > 0).then(|| format!("{} without a path", count(lacking, "leg"))),
        (untimed > 0).then(|| format!("{} without a motion", count(untimed, "leg"))),
        (violations > 0).then(|| count(violations, "violation")),
        (faults > 0).then(|| format!("{} of motions", count(faults, "fault"))),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn lines(k: usize, report: &LegReport, keys: &LegKeys) -> Vec<String> {
    let leg = leg_words(k, keys);
    let Some(report) = report else { return vec![format!("  {leg}: {}", reason(keys))] };
    let violation = |v: &cdpr_core::PathViolation| {
        let place = format!("segment {} at {:.3}", v.segment, v.violation.at);
        format!("  {leg}, {place}: {}", v.violation.sentence())
    };
    let untimed = || {
        let why = keys.motion.as_ref().and_then(|motion| motion.reason.clone()).unwrap_or_default();
        format!("  {leg}: it cannot be timed: {why}")
    };
    let faults = report.motion.iter().flat_map(|motion| fault_lines(&motion.faults));
    let violations = report.path.path.violations.iter().map(violation);
    violations.chain(report.untimed.then(untimed)).chain(faults.map(|line| format!("  {leg},{line}"))).collect()
}

/// What could not be checked on the motions; of notes that begin alike, the first.
fn notes(reports: &[LegReport]) -> Vec<&String> {
    let mut notes: Vec<&String> = Vec::new();
    for note in reports.iter().flatten().flat_map(|report| &report.motion).flat_map(|motion| &motion.notes) {
        let subject = |note: &str| note.split(':').next().map(str::to_string);
        if notes.iter().all(|known| subject(known) != subject(note)) {
            notes.push(note);
        }
    }
    notes
}
