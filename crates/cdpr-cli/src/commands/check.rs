//! `cdpr check`

use cdpr_certify::{BoundSummary, Summary};
use cdpr_core::collision::path_check::{Nearest, PathClearance, PathReport, PathViolation};
use cdpr_core::collision::{Exemption, Reason};
use cdpr_core::geometry::Pose;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::plan::{self, CheckReport, check, engine_within};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::words::{length, small_length};
use cdpr_core::wrench::{PathWrench, tensions::TensionPlace};
use cdpr_core::{Error, Scene};
use cdpr_files::LoadedPath;

use super::trajectory_check;
use crate::Answer;
use crate::args::{CheckArgs, Format, PathArgs};
use crate::input::{self, Given};
use crate::interruption::interrupted;
use crate::output::{Console, Verdict, count, degrees, robot_line, scene_line, short, thousandths};
use crate::progress::with_sign_of_life;

pub fn run(args: &CheckArgs, out: &Console) -> Result<Answer, Error> {
    let CheckArgs { path: args, limits } = args;
    if let Some(text) = cdpr_files::text::read_certificate(&args.path)? {
        return check_proof(args, &text, out);
    }
    match input::path_or_trajectory(args, out)? {
        Given::Path(found) if limits.spec() == MotionSpec::default() => check_waypoints(args, &found.0, &found.1, out),
        Given::Path(_) => {
            let problem = "found a path without times, expected a trajectory: limits are given";
            Err(Error::invalid("", problem).in_file(&args.path))
        }
        Given::Trajectory(found) => trajectory_check::run(args, limits.spec(), &found.0, &found.1, out),
    }
}

fn check_waypoints(args: &PathArgs, scene: &Scene, path: &LoadedPath, out: &Console) -> Result<Answer, Error> {
    if let Some(poses) = &path.poses {
        return check_turning(args, scene, poses, out);
    }
    let (watch, in_scene) = (Watch::on(&interrupted), |e: Error| e.in_file(&args.scene.scene));
    let engine = engine_within(scene, args.checker.engine, args.checker.interference, &watch).map_err(in_scene)?;
    out.notes(scene, engine.conditions());
    let found = check(scene, &*engine, &path.waypoints, &watch).map_err(in_scene)?;
    let CheckReport { path: report, wrench } = &found;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(found))),
        Format::Text => {
            out.result(&scene_line(scene));
            out.verdict(&verdict(report, &count(path.waypoints.len(), "waypoint")));
            report_lines(report).iter().for_each(|line| out.result(line));
            wrench.iter().flat_map(wrench_lines).for_each(|line| out.result(&line));
        }
    }
    Ok(if report.valid { Answer::Yes } else { Answer::No })
}

/// Checks a path along which the platform turns.
fn check_turning(args: &PathArgs, scene: &Scene, poses: &[Pose], out: &Console) -> Result<Answer, Error> {
    let engine = input::turning_engine(scene, &args.scene.scene, args.checker)?;
    out.notes(scene, engine.conditions());
    let check = |stop: &Interrupt| plan::check_turning(scene, &engine, poses, &Watch::on(stop));
    let found = with_sign_of_life(out, "checking", check)?;
    let CheckReport { path: report, wrench } = &found;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(found))),
        Format::Text => {
            let waypoints = format!("{}, {}", count(poses.len(), "waypoint"), turns(poses));
            out.result(&robot_line(scene));
            out.verdict(&verdict(report, &waypoints));
            report_lines(report).iter().for_each(|line| out.result(line));
            wrench.iter().flat_map(wrench_lines).for_each(|line| out.result(&line));
        }
    }
    Ok(if report.valid { Answer::Yes } else { Answer::No })
}

/// How far the platform turns on its way.
pub fn turns(poses: &[Pose]) -> String {
    let angle: f64 = poses.windows(2).map(|pair| pair[0].angle_to(&pair[1])).sum();
    format!("turns by {} in all", degrees(angle))
}

/// Checks a proof of either kind, without the code that made it.
fn check_proof(args: &PathArgs, text: &str, out: &Console) -> Result<Answer, Error> {
    let scene = input::scene(&args.scene, out)?;
    input::selects_orientation(&scene, &args.scene)?;
    input::never_turns(&scene, &args.scene)?;
    let check = |stop: &Interrupt| match cdpr_certify::is_bound(text) {
        true => bound(text, &scene, &Watch::on(stop)),
        false => no_path(text, &scene, &Watch::on(stop)),
    };
    let proved = with_sign_of_life(out, "checking", check).map_err(|e| e.in_file(&args.path))?;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", proved.answer)),
        Format::Text => {
            out.result(&scene_line(&scene));
            out.verdict(&Verdict::yes("proved:", format!(" {}", proved.what)));
            out.result(&proved.how);
        }
    }
    Ok(Answer::Yes)
}

/// What `check` prints about an accepted proof.
struct Proved {
    answer: serde_json::Value,
    what: String,
    how: String,
}

/// A proof that there is no path.
fn no_path(text: &str, scene: &Scene, watch: &Watch) -> Result<Proved, Error> {
    let Summary { boxes, closed, regions, margin } = cdpr_certify::check_certificate(scene, text, watch)?;
    Ok(Proved {
        answer: serde_json::json!({
            "valid": true, "boxes": boxes, "closed": closed, "regions": regions, "margin": margin,
        }),
        what: format!("no path keeps a gap of more than {}", small_length(margin)),
        how: format!("{closed} of {boxes} boxes are closed, by {}; checked exactly", count(regions, "region")),
    })
}

/// A proof that no path is shorter than a length.
fn bound(text: &str, scene: &Scene, watch: &Watch) -> Result<Proved, Error> {
    let BoundSummary { length, margin, regions, pieces } = cdpr_certify::check_bound(scene, text, watch)?;
    let counts = [count(pieces, "piece"), count(regions, "region")];
    Ok(Proved {
        answer: serde_json::json!({
            "valid": true, "lower_bound": length, "pieces": pieces, "regions": regions, "margin": margin,
        }),
        what: format!(
            "no path that keeps a gap of more than {} is shorter than {} m",
            small_length(margin),
            short(length)
        ),
        how: format!(
            "{} of edges of {}, with their labels; regions and edges checked exactly, labels with reserves far above \
             rounding errors",
            counts[0], counts[1]
        ),
    })
}

fn verdict(report: &PathReport, waypoints: &str) -> Verdict {
    let path = format!(" {} m, {waypoints}", short(report.length));
    if report.valid {
        Verdict::yes("valid:", path)
    } else {
        Verdict::no("not valid:", format!("{path}, {}", count(report.violations.len(), "violation")))
    }
}

fn report_lines(report: &PathReport) -> Vec<String> {
    report.violations.iter().map(violation_line).chain(nearest_lines(&report.nearest)).collect()
}

fn violation_line(v: &PathViolation) -> String {
    format!("  segment {} at {:.3}: {}", v.segment, v.violation.at, v.violation.sentence())
}

/// The nearest approach and the exempt pairs in words.
pub fn nearest_lines(nearest: &Nearest) -> Vec<String> {
    let line = |what: &str, nearest: &PathClearance| {
        let (gap, culprits) = (length(nearest.value), nearest.culprits.join(" and "));
        format!("{what} {gap}: {culprits} at {:.3} of segment {}", nearest.at, nearest.segment)
    };
    let Nearest { min_clearance, min_clearance_not_exempt, exempt } = nearest;
    let of_all = min_clearance.iter().map(|nearest| line("nearest approach", nearest));
    let differs = |other: &&PathClearance| Some(*other) != min_clearance.as_ref();
    let of_others = min_clearance_not_exempt.iter().filter(differs).map(|n| line("without exempt pairs", n));
    let measured: Vec<(&Exemption, Option<f64>)> = exempt.iter().map(|e| (&e.exemption, e.gap)).collect();
    of_all.chain(of_others).chain(exempt_lines(&measured)).collect()
}

/// Maximum number of exempt pairs printed; unchecked pairs are counted separately.
const MOST_EXEMPT: usize = 12;

/// Exempt pairs in words, with their nearest approach on a path, m, if there is one.
pub fn exempt_lines(exempt: &[(&Exemption, Option<f64>)]) -> Vec<String> {
    let (unchecked, checked): (Vec<&_>, Vec<&_>) = exempt.iter().partition(|(e, _)| e.reason == Reason::Ignore);
    let line = |(exemption, gap): &&(&Exemption, Option<f64>)| {
        let gap = gap.map_or(String::new(), |gap| format!(" (here {})", length(gap)));
        format!("exempt: {}{gap}", exemption.sentence())
    };
    let rest = |count: usize| count.saturating_sub(MOST_EXEMPT);
    let more = (rest(checked.len()) > 0).then(|| format!("exempt: {} more, see --format json", rest(checked.len())));
    let pairs = unchecked.iter().take(MOST_EXEMPT).map(|(exemption, _)| exemption.pair.join(" and "));
    let others = (rest(unchecked.len()) > 0).then(|| format!("{} more", rest(unchecked.len())));
    let unchecked = pairs.chain(others).collect::<Vec<_>>().join("; ");
    let unchecked = (!unchecked.is_empty()).then(|| format!("not checked against each other: {unchecked}"));
    checked.iter().take(MOST_EXEMPT).map(line).chain(more).chain(unchecked).collect()
}

/// The smallest wrench margin and the range of tensions in words.
pub fn wrench_lines(wrench: &PathWrench) -> Vec<String> {
    let PathWrench { min_wrench_margin: least, tension_range } = wrench;
    let place = |at: f64, segment: usize| format!("at {at:.3} of segment {segment}");
    let margin = least.value.map_or("a cable without direction".to_string(), |value| {
        format!("least {} margin {} {}", least.limit.measure, thousandths(value), least.limit.unit)
    });
    let mut lines = vec![format!("{margin} {}", place(least.at, least.segment))];
    match tension_range {
        None => lines.push("the loads cannot be balanced everywhere on the path".to_string()),
        Some(range) => {
            let told = |t: &TensionPlace| format!("{:.3} N ({} {})", t.value, t.cable, place(t.at, t.segment));
            lines.push(format!("tensions from {} to {}", told(&range.min), told(&range.max)));
        }
    }
    lines
}
