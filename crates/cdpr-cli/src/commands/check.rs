//! `cdpr check`

use cdpr_certify::{BoundSummary, Summary};
use cdpr_core::collision::path_check::{Nearest, PathClearance, PathReport, PathViolation};
use cdpr_core::collision::{Exemption, Reason, nearest_valid, worst_first};
use cdpr_core::compiled::engine_within;
use cdpr_core::geometry::{Point, Pose};
use cdpr_core::model::Distribution;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::path::{self, CheckReport};
use cdpr_core::plan::Query;
use cdpr_core::tolerances::PLACE_MARGIN;
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::words::{length, small_length};
use cdpr_core::wrench::{PathWrench, report::TensionPlace};
use cdpr_core::{Error, Recorded, Scene};

use super::{task_check, trajectory_check};
use crate::Answer;
use crate::args::{CheckArgs, Format, LIMITS, PathArgs};
use crate::input::{self, Given};
use crate::interruption::interrupted;
use crate::output::{Console, Verdict, count, degrees, position, robot_line, scene_line, short, thousandths};
use crate::progress::with_progress;

pub fn run(args: &CheckArgs, out: &Console) -> Result<Answer, Error> {
    let limits = args.limits.spec();
    let Some(path) = &args.path else {
        return check_place(args, args.at.as_deref().expect("a path or --at is required"), out);
    };
    let files = args.of_file(path);
    if let Some(task) = cdpr_files::load_if_task(path)? {
        args.given.refuse(&["--start", "--goal"], "with a task", "a proof")?;
        if task.legs.iter().all(|leg| leg.motion.is_none()) {
            args.given.refuse(&LIMITS, "with a task without motions", "a trajectory, or a task with motions")?;
        }
        let scene = args.tensions.in_scene(input::scene(&args.scene, out)?);
        return task_check::run((args, &files), &scene, &task, out);
    }
    let given = input::path_trajectory_or_proof(&args.scene, path, args.strict, out)?;
    let wrong = |found: &str, expected: &str| {
        Err(Error::invalid("", format!("found {found}, expected {expected}")).in_file(path))
    };
    let ends_given = args.start.is_some() || args.goal.is_some();
    match given {
        Given::Path(_) if limits != MotionSpec::default() => {
            wrong("a path without times", "a trajectory: limits are given")
        }
        Given::Proof(_) if limits != MotionSpec::default() => wrong("a proof", "a trajectory: limits are given"),
        Given::Path(_) if ends_given => wrong("a path", "a proof, since --start and --goal are given"),
        Given::Trajectory(_) if ends_given => wrong("a trajectory", "a proof, since --start and --goal are given"),
        Given::Path(found) => {
            let path = found.1.path(&found.0);
            check_path(&files, &args.tensions.in_scene(found.0), &path, out)
        }
        Given::Trajectory(found) => {
            let motion = &found.1.motion;
            let named = args.tensions.tensions.or(motion.tension_distribution);
            let motion = Recorded { tension_distribution: named, ..motion.clone() };
            trajectory_check::run((&files, &args.given), limits, &found.0, &motion, out)
        }
        Given::Proof(found) => {
            let (scene, text) = *found;
            args.given.refuse(
                &["--strict", "--engine", "--interference", "--tensions"],
                "with a proof",
                "a path or a trajectory",
            )?;
            let scene = if ends_given { with_ends(args, scene)? } else { scene };
            check_proof(&files, &scene, &text, out)
        }
    }
}

/// The scene with the start and goal that a proof concerns.
fn with_ends(args: &CheckArgs, scene: Scene) -> Result<Scene, Error> {
    let scene = input::between(scene, [("--start", args.start.as_deref()), ("--goal", args.goal.as_deref())])?;
    scene.with_ends(Query::of(&scene).poses().map_err(|e| e.in_file(&args.scene.scene))?)
}

/// Checks a position: prints all violations there, and a valid position near it.
fn check_place(args: &CheckArgs, at: &[String], out: &Console) -> Result<Answer, Error> {
    let (scene, at) = input::at(at, &args.scene, input::scene(&args.scene, out)?)?;
    let at = &at;
    let (watch, in_scene) = (Watch::on(&interrupted), |e: Error| e.in_file(&args.scene.scene));
    let engine = engine_within(&scene, args.checker.engine, args.checker.interference, &watch).map_err(in_scene)?;
    out.notes(&scene, engine.conditions());
    let violations = worst_first(engine.violations(at, at));
    let margin = args.margin.unwrap_or(PLACE_MARGIN);
    let positions = engine.conditions().position_box();
    let nearest = nearest_valid(positions, at, margin, |place| engine.state_valid(place), &watch)?;
    match args.scene.format {
        Format::Json => out.result(&format!(
            "{:#}",
            serde_json::json!({
                "valid": violations.is_empty(),
                "violations": violations,
                "nearest_valid": nearest.map(<[f64; 3]>::from),
                "margin": margin,
            })
        )),
        Format::Text => {
            out.result(&scene_line(&scene));
            match violations.is_empty() {
                true => out.verdict(&Verdict::yes("valid:", format!(" the platform at {}", position(at)))),
                false => {
                    let found = format!(" the platform at {}, {}", position(at), count(violations.len(), "violation"));
                    out.verdict(&Verdict::no("not valid:", found));
                }
            }
            violations.iter().for_each(|violation| out.result(&format!("  {}", violation.sentence())));
            nearest_place(at, nearest.as_ref(), margin).iter().for_each(|line| out.result(line));
        }
    }
    Ok(if violations.is_empty() { Answer::Yes } else { Answer::No })
}

/// The sentence about a valid position near one that is not valid, or not by as much as the margin; nothing if there is
/// no need for one.
fn nearest_place(at: &Point, nearest: Option<&Point>, margin: f64) -> Option<String> {
    let inside = if margin > 0.0 { format!("{} inside", small_length(margin)) } else { "valid".to_string() };
    match nearest {
        None => Some(format!("no position that is {inside} was found near it")),
        Some(place) if place == at => None,
        Some(place) => {
            let away = small_length((place - at).norm());
            Some(format!("the nearest position found that is {inside}: {}, {away} away", position(place)))
        }
    }
}

fn check_path(args: &PathArgs, scene: &Scene, path: &[Pose], out: &Console) -> Result<Answer, Error> {
    let compiled = input::compiled(scene, path, &args.scene, args.checker)?;
    out.notes(scene, compiled.conditions());
    let check = |stop: &Interrupt| path::check(&compiled, path, &Watch::on(stop));
    let found = with_progress(out, "checking", check).map_err(|e| e.in_file(&args.scene.scene))?;
    let CheckReport { path: report, wrench } = &found;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(found))),
        Format::Text => {
            let held = scene.keeps_orientation(path);
            let turned = if held { String::new() } else { format!(", {}", turns(path)) };
            out.result(&if held { scene_line(scene) } else { robot_line(scene) });
            out.verdict(&verdict(report, &format!("{}{turned}", count(path.len(), "waypoint"))));
            report_lines(report).iter().for_each(|line| out.result(line));
            wrench.iter().flat_map(|wrench| wrench_lines(scene, wrench)).for_each(|line| out.result(&line));
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
fn check_proof(args: &PathArgs, scene: &Scene, text: &str, out: &Console) -> Result<Answer, Error> {
    input::selects_orientation(scene, &args.scene)?;
    input::never_turns(scene, &args.scene)?;
    let check = |stop: &Interrupt| match cdpr_certify::is_bound(text) {
        true => bound(text, scene, &Watch::on(stop)),
        false => no_path(text, scene, &Watch::on(stop)),
    };
    let proved = with_progress(out, "checking", check).map_err(|e| e.in_file(&args.path))?;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", proved.answer)),
        Format::Text => {
            out.result(&scene_line(scene));
            out.verdict(&Verdict::yes("proved:", format!(" {}", proved.what)));
            out.result(&proved.how);
        }
    }
    Ok(Answer::Yes)
}

/// The lines that `check` prints about an accepted proof.
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
    let BoundSummary { length, margin, regions, weak, pieces } = cdpr_certify::check_bound(scene, text, watch)?;
    let counts = [count(pieces, "piece"), count(regions, "region")];
    Ok(Proved {
        answer: serde_json::json!({
            "valid": true, "lower_bound": length, "pieces": pieces, "regions": regions, "margin": margin,
            "wrench_regions": weak,
        }),
        what: format!(
            "no path that keeps a gap of more than {}{} is shorter than {} m",
            small_length(margin),
            if weak > 0 { ", and the required wrenches," } else { "" },
            short(length)
        ),
        how: format!(
            "{} of edges of {}{}, with their labels; regions and edges checked exactly, labels with reserves far above \
             rounding errors",
            counts[0],
            counts[1],
            if weak > 0 { format!(" ({weak} where wrenches lack)") } else { String::new() },
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
pub fn wrench_lines(scene: &Scene, wrench: &PathWrench) -> Vec<String> {
    let PathWrench { min_wrench_margin: least, tension_range } = wrench;
    let place = |at: f64, segment: usize| format!("at {at:.3} of segment {segment}");
    let margin = least.value.map_or("a cable without direction".to_string(), |value| {
        format!("least {} margin {} {}", least.limit.measure, thousandths(value), least.limit.unit)
    });
    let case = least.limit.load_case.map_or(String::new(), |case| format!(" ({case})"));
    let mut lines = vec![format!("{margin} {}{case}", place(least.at, least.segment))];
    match tension_range {
        None if scene.robot().distribution() == Distribution::ClosedForm => {
            lines.push("tensions in closed form exceed a limit somewhere on the path, or there are none".to_string());
        }
        None => lines.push("the loads cannot be balanced everywhere on the path".to_string()),
        Some(range) => {
            let told =
                |t: &TensionPlace| format!("{} N ({} {})", thousandths(t.value), t.cable, place(t.at, t.segment));
            lines.push(format!("tensions from {} to {}", told(&range.min), told(&range.max)));
        }
    }
    lines
}
