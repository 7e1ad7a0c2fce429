//! `cdpr plan`

use cdpr_core::certificate::{BoundCertificate, Certificate};
use cdpr_core::collision::path_check::{Nearest, path_length};
use cdpr_core::collision::{Kind, Violation};
use cdpr_core::geometry::{Point, Pose, wxyz};
use cdpr_core::limits::MOST_CERTIFICATE_BOXES;
use cdpr_core::model::{Member, OrientationSource, PairRule, PositionSource};
use cdpr_core::path::{length, positions};
use cdpr_core::plan::{
    Appraisal, FoundBy, Maximise, NoPath, Observer, PlanOptions, PlanResult, Planned, Post, Route, RouteFound, Widest,
    plan_route, plan_widest, plan_widest_within, replan,
};
use cdpr_core::planning::Status;
use cdpr_core::tolerances::{BOUND_GAP, SAME_TURN, TOUCH_DEPTH};
use cdpr_core::trajectory::plan_timed;
use cdpr_core::watch::{Interrupt, Watch, unless_interrupted};
use cdpr_core::words::small_length;
use cdpr_core::{Choice, Error, Scene};
use cdpr_files::PathFile;
use cdpr_view::{Contents, page};

use super::check::turns;
use super::pose::start_from_lengths;
use super::post::save_path;
use super::trajectory::{Timed, hinted, save_trajectory};
use super::view::{IN_BROWSER, form};
use crate::Answer;
use crate::args::{Format, PlanArgs};
use crate::input;
use crate::interruption::interrupted;
use crate::output::{Console, Talk, Verdict, count, is_standard_output, is_stream, orientation, position, robot_line};
use crate::output::{scene_line, short};
use crate::progress::with_progress;
use crate::target::check_message;

pub fn run(args: &PlanArgs, out: &Console) -> Result<Answer, Error> {
    let fields = args.timing.fields();
    check_message(args.trajectory.as_deref(), fields)?;
    let files = [&args.output, &args.html, &args.proof, &args.trajectory].map(|file| file.as_deref());
    if files.iter().flatten().filter(|file| is_standard_output(file)).count() > 1 {
        let problem = "found - for more than one of -o, --html, --proof and --trajectory; only one of them can be \
                       standard output";
        return Err(Error::invalid("", problem));
    }
    let out = &files.iter().fold(*out, |out, file| out.beside(*file));
    for (what, file) in [("lengths", &args.start_lengths), ("path", &args.replan)] {
        file.iter().try_for_each(|file| input::only_one_stream(("scene", &args.scene.scene), (what, file)))?;
    }
    let scene = args.tensions.in_scene(input::scene(&args.scene, out)?);
    let scene = input::between(scene, [("--start", args.start.as_deref()), ("--goal", args.route.goal())])?;
    let (args, scene) = start_from_lengths(args, scene, out)?;
    let (args, scene, before) = between_ends_of_path(args, scene)?;
    let args = &args;
    let options = args.options()?;
    let in_scene = |e: Error| args.given.blamed(e, &args.scene.scene);
    let (query, route) = (args.query(&scene)?, args.route.route(&scene)?);
    let ends_known = if route.goals.is_empty() && route.goal_box.is_none() { query.ends().map(drop) } else { Ok(()) };
    ends_known.map_err(|e| in_scene(e.with_hints(&["or pass --start X Y Z, --goal X Y Z".to_string()])))?;
    if args.maximise.is_some() && !route.goals.is_empty() {
        let problem =
            format!("found {} with --maximise, expected one: the widest path leads to one goal", route.goals.len());
        return Err(Error::invalid("--goal", problem));
    }
    let bounded = args.output.is_some() || args.scene.format == Format::Json || out.talk() != Talk::Quiet;
    let search = |stop: &Interrupt| {
        let watch = options.watch(stop);
        let reporter = Reporter { stop, out };
        let planned = match (&before, args.maximise, args.within) {
            (Some(before), ..) => replan(query, before, &options, &reporter)?,
            (None, None, _) => plan_route(query, &route, &options, &reporter)?,
            (None, Some(Maximise::Clearance), None) => plan_widest(query, &options, &reporter)?,
            (None, Some(Maximise::Clearance), Some(ratio)) => plan_widest_within(query, ratio, &options, &reporter)?,
        };
        if planned.result.status == Status::Interrupted {
            return Err(Error::interrupted()); // nothing was found that could be written
        }
        let (planned, options, timed) = timed(args, planned, &Watch::on(stop))?;
        let appraisal = planned.appraise(bounded || args.proof.is_some(), &watch)?;
        let proved = appraisal.lower_bound.unwrap_or(planned.result.cost / (1.0 + BOUND_GAP));
        let bound = match args.proof.is_some() && planned.result.status == Status::Solved {
            true if planned.result.route.is_some() => None,
            true if args.maximise.is_some() => {
                unless_interrupted(planned.width_certificate(&options, &Watch::on(stop)))?.flatten().map(Proved::Width)
            }
            true => {
                let asked = planned.scene.with_ends(args.query(&planned.scene)?.poses()?)?;
                let bound = planned.bound_certificate(proved, &accepted(&asked), &Watch::on(stop));
                unless_interrupted(bound)?.flatten().map(Proved::Length)
            }
            false => None,
        };
        Ok((planned, options, timed, appraisal, bound))
    };
    let (planned, options, timed, appraisal, certificate) =
        with_progress(out, "searching", search).map_err(in_scene)?;
    timed.iter().try_for_each(|timed| timed.fits(args.trajectory.as_deref(), fields))?;
    if let Some(compiled) = &planned.compiled {
        out.notes(&scene, compiled.conditions());
    }
    let here = if scene.orientation_is_open() { " at this orientation" } else { "" };
    let here = &format!("{}{here}", about(&route));
    let Planned { scene, result: found, compiled } = planned;
    let is_compiled = compiled.is_some();
    std::mem::forget(compiled); // the end of the program frees it at once, and not piece by piece for milliseconds
    let ends = args.query(&scene)?.poses().map_err(in_scene)?;
    let file = PathFile::planned(&scene, &options, &found, &appraisal).with_lower_bound(appraisal.lower_bound);
    let Appraisal { nearest, wrench, lower_bound: bound } = appraisal;
    match args.scene.format {
        Format::Json => {
            let mut json = serde_json::json!(file);
            timed.iter().for_each(|timed| json["trajectory"] = timed.json());
            out.result(&format!("{json:#}"));
        }
        Format::Text => {
            out.result(&(question(&scene, ends) + &via_words(&route)));
            out.verdict(&answer(&scene, is_compiled, &options, &found, &route));
            invalid_end_lines(&found).iter().for_each(|line| out.result(line));
            found.no_path.iter().flat_map(|no_path| no_path_lines(no_path)).for_each(|line| out.result(&line));
            found.widest.iter().for_each(|widest| out.result(&widest_line(widest)));
            bound.iter().for_each(|bound| out.result(&excess_line(&found, *bound, here)));
            super::check::nearest_lines(&nearest).iter().for_each(|line| out.result(line));
            wrench
                .iter()
                .flat_map(|wrench| super::check::wrench_lines(&scene, wrench))
                .for_each(|line| out.result(&line));
            timed.iter().for_each(|timed| timed.print(out));
        }
    }
    if let Some(path) = &args.output {
        save_path(path, &file, out)?;
    }
    if let Some(path) = &args.trajectory {
        match &timed {
            Some(timed) => save_trajectory(path, &timed.file, fields, out)?,
            None => {
                let reason = if found.status == Status::Solved { "interrupted" } else { "there is no path" };
                out.say(&format!("{} was not written: {reason}", path.display()));
            }
        }
    }
    if let Some(path) = &args.proof {
        match (found.no_path.as_ref().map(|no_path| &no_path.certificate), &certificate) {
            _ if !route.is_plain() => {
                let reason = "a certificate is about one start and one goal; plan each leg with --start and --goal";
                out.say(&format!("{} was not written: {reason}", path.display()));
            }
            (Some(certificate), _) => {
                out.write(path, json_line(certificate).as_bytes(), &unchecked_words(certificate.boxes.len()))?;
            }
            (None, Some(Proved::Length(certified))) => {
                out.write(path, json_line(certified).as_bytes(), &certified_words(certified, bound, here))?;
            }
            (None, Some(Proved::Width(certified))) => {
                let about = found.widest.and_then(|widest| widest.none_above).unwrap_or_default();
                let words = format!("(proves that there is no path{here} with clearance = {about})");
                out.write(path, json_line(certified).as_bytes(), &(words + &unchecked_words(certified.boxes.len())))?;
            }
            _ if found.widest.is_some() => {
                let reason = match found.widest.and_then(|widest| widest.narrow_end) {
                    _ if interrupted() => "it was interrupted".to_string(),
                    Some(end) => format!("the {} itself keeps no more", END_NAMES[end]),
                    None if args.within.is_some() => "longer paths may keep more".to_string(),
                    None if found.widest.is_some_and(|widest| widest.none_above.is_some()) => {
                        format!("none was found{here}")
                    }
                    None => "nothing was proved".to_string(),
                };
                out.say(&format!("{} was not written: no certificate of the width, since {reason}", path.display()));
            }
            _ if found.status == Status::Solved => {
                let reason = match scene.keeps_orientation(&found.path) {
                    _ if interrupted() => "it was interrupted",
                    true => "none was accepted",
                    false => "the platform turns",
                };
                out.say(&format!("{} was not written: no certificate of the length, since {reason}", path.display()));
            }
            _ => out.say(&format!("{} was not written: it was not proved that there is no path", path.display())),
        }
    }
    if interrupted() {
        let found = if found.status == Status::Solved { "; this is the best path found so far" } else { "" };
        out.say(&format!("interrupted{found}"));
    } else if let Some(path) = &args.html {
        // The planner of the page knows no via points.
        let fixed = args.is_static || !route.via.is_empty();
        let page = page(&scene.with_ends(ends)?, Contents::from(&file), form(fixed));
        out.write(path, page.as_bytes(), IN_BROWSER)?;
    }
    let told = args.maximise.is_none() && args.settings.gap.is_none() && args.scene.format == Format::Text;
    if told && scene.wrench().is_some() && bound.is_some_and(|bound| found.cost > FAR_ABOVE * bound) {
        out.say("next: this bound leaves out the required wrenches; --gap 0.05 counts them, and takes some seconds");
    }
    let turns = args.query(&scene)?.turns();
    if let (false, false, Some(obstacle)) = (turns, interrupted(), touched(args, &scene, &nearest)) {
        out.say(&format!(
            "next: the path touches {obstacle}; --maximise clearance keeps as far from obstacles as possible"
        ));
    }
    say_next(args, &scene, (&found, turns), out);
    Ok(if found.status == Status::Solved { Answer::Yes } else { Answer::No })
}

/// With `--replan`, the path to keep, and the arguments and the scene with its ends.
fn between_ends_of_path(args: PlanArgs, scene: Scene) -> Result<(PlanArgs, Scene, Option<Vec<Pose>>), Error> {
    let Some(file) = &args.replan else { return Ok((args, scene, None)) };
    let (scene, path) = input::path_before(&scene, &args.scene, file)?;
    let ends = [path[0], path[path.len() - 1]];
    let turns = args.query(&scene)?.turns() || !scene.keeps_orientation(&path);
    let scene = scene.between(ends.map(|end| Some(end.position.into())))?;
    let [start_orientation, goal_orientation] =
        ends.map(|end| turns.then(|| OrientationSource::Quaternion(wxyz(&end.orientation))));
    Ok((PlanArgs { start_orientation, goal_orientation, ..args }, scene, Some(path)))
}

/// With `--trajectory`, the motion along the path that was found or, for the shortest time, along another one, which then
/// replaces it; and the options of the path.
fn timed(args: &PlanArgs, mut planned: Planned, watch: &Watch) -> Result<(Planned, PlanOptions, Option<Timed>), Error> {
    let options = args.options()?;
    let Some(compiled) = planned.compiled.clone().filter(|_| planned.result.status == Status::Solved) else {
        return Ok((planned, options, None));
    };
    if args.trajectory.is_none() {
        return Ok((planned, options, None));
    }
    let ends = args.query(&planned.scene)?.poses()?;
    let limits = args.timing.limits.spec();
    let found = plan_timed(&compiled, ends, planned.result.clone(), (&options, args.minimise), &limits, watch);
    let Some(found) = unless_interrupted(found.map_err(hinted))? else { return Ok((planned, options, None)) };
    let timed = unless_interrupted(Timed::planned(&compiled, &found, args.minimise, args.timing.rate, watch))?;
    planned.result = found.result;
    Ok((planned, found.options, timed))
}

/// A certificate beside a path.
enum Proved {
    /// No path is shorter.
    Length(BoundCertificate),
    /// No path is wider.
    Width(Certificate),
}

/// Prints every better path, and stops the search on request.
struct Reporter<'a> {
    stop: &'a Interrupt<'a>,
    out: &'a Console,
}

impl Observer for Reporter<'_> {
    fn interrupted(&self) -> bool {
        (self.stop)()
    }

    fn improved(&self, seconds: f64, cost: f64, path: &[Point]) {
        self.out.detail(&format!("{:9.2} ms: {} m, {}", 1e3 * seconds, short(cost), count(path.len(), "waypoint")));
    }
}

fn json_line(certificate: &impl serde::Serialize) -> String {
    serde_json::to_string(certificate).expect("its numbers are finite") + "\n"
}

/// Whether the checker accepts a certificate of a bound, so that nothing is written that `cdpr check` refuses.
fn accepted(scene: &Scene) -> impl Fn(&BoundCertificate, &Watch) -> bool + '_ {
    |certificate, watch| cdpr_certify::check_bound(scene, &json_line(certificate), watch).is_ok()
}

/// The sentence that a proof has too many boxes to be checked, if it has.
fn unchecked_words(boxes: usize) -> String {
    let words = || format!(": {boxes} boxes, but at most {MOST_CERTIFICATE_BOXES} are checked");
    if boxes > MOST_CERTIFICATE_BOXES { words() } else { String::new() }
}

/// What a certificate proves; and the bound that was printed, if that is larger.
fn certified_words(certificate: &BoundCertificate, printed: Option<f64>, here: &str) -> String {
    let [proved, printed] = [Some(certificate.length), printed].map(|length| length.map_or(String::new(), short));
    let less = !printed.is_empty() && printed != proved;
    let more = if less { format!("; the bound of {printed} m has no certificate") } else { String::new() };
    format!("(proves that no path{here} is shorter than {proved} m{more})")
}

/// The lines about a scene without a path: what removing obstacles gives, how far the platform gets, and what was
/// proved.
fn no_path_lines(no_path: &NoPath) -> Vec<String> {
    let remedies = Some(no_path.remedies()).filter(|remedies| !remedies.is_empty());
    let reach = format!(
        "the platform reaches {:.3} m³; the reachable position nearest to the goal is {}",
        no_path.reachable_volume,
        position(&no_path.nearest_to_goal.into())
    );
    let (boxes, margin) = (no_path.boxes, small_length(no_path.margin));
    let proved = format!("proved with {boxes} boxes: no path keeps a gap of more than {margin}");
    remedies.into_iter().chain([reach, proved]).collect()
}

/// The line that says how wide the path is, and how wide paths can be.
fn widest_line(widest: &Widest) -> String {
    let kept = format!("widest: keeps {} from obstacles", small_length(widest.clearance));
    let Some(none_above) = widest.none_above else { return kept + "; it is not proved how much paths can keep" };
    let reason = widest.narrow_end.map_or(String::new(), |end| format!(", since the {} does not", END_NAMES[end]));
    let meant = widest.longest.map_or(String::new(), |longest| format!(" of at most {} m", short(longest)));
    format!("{kept}; no path{meant} keeps {}{reason}", small_length(none_above))
}

/// The ends of a path.
const END_NAMES: [&str; 2] = ["start", "goal"];

/// The line that says how much longer than the shortest the path can be. `here` names the orientation for which the
/// bound holds, if there is a choice.
fn excess_line(found: &PlanResult, bound: f64, here: &str) -> String {
    let cost = found.cost;
    let excess = if cost > bound { 100.0 * (cost / bound - 1.0) } else { 0.0 };
    let shorter = format!("no path{here} is shorter than {} m, so this one is at most {excess:.2} %", short(bound));
    if found.widest.is_some() { shorter + " longer than the shortest" } else { shorter + " too long" }
}

fn question(scene: &Scene, ends: [Pose; 2]) -> String {
    let [start, goal] = ends.map(|end| position(&end.position));
    if scene.keeps_orientation(&ends) {
        return format!("{}; from {start} to {goal}", scene_line(scene));
    }
    let [at_start, at_goal] = ends.map(|end| orientation(scene, &end.orientation));
    format!("{}; from {start} at {at_start} to {goal} at {at_goal}", robot_line(scene))
}

/// The via points of a path in words.
fn via_words(route: &Route) -> String {
    let place = |source: &PositionSource| match source {
        PositionSource::Named(name) => name.clone(),
        PositionSource::Coordinates(numbers) => position(&Point::from(*numbers)),
    };
    let all: Vec<String> = route.via.iter().map(place).collect();
    if all.is_empty() { String::new() } else { format!(" via {}", all.join(", ")) }
}

/// Which paths a bound is about, if they are not those from the start to the goal.
fn about(route: &Route) -> String {
    let via = if route.via.is_empty() { "" } else { " through these points" };
    let goals = match (&route.goals[..], &route.goal_box) {
        (_, Some(_)) => " into the box".to_string(),
        ([_, _, ..], _) => format!(" to any of the {}", count(route.goals.len(), "goal")),
        _ => String::new(),
    };
    format!("{via}{goals}")
}

/// The leg and the goal that an answer without a path is about, if there are several.
fn part_words(found: &PlanResult) -> String {
    let Some(RouteFound { goal, leg, .. }) = &found.route else { return String::new() };
    let leg = leg.map_or(String::new(), |[leg, legs]| format!("leg {} of {legs}: ", leg + 1));
    let goal = goal.map_or(String::new(), |goal| format!("to none of the goals; to goal {}: ", goal + 1));
    goal + &leg
}

/// Which goal or via point is not valid.
fn invalid_goal_words(scene: &Scene, found: &PlanResult, route: &Route) -> String {
    let passed = found.route.clone().unwrap_or_default();
    match (passed.leg, passed.goal, &route.goal_box) {
        (Some([leg, legs]), ..) if leg + 1 < legs => format!("via point {} is not valid", leg + 1),
        (_, Some(goal), _) => format!("no goal is valid; goal {}", goal + 1),
        (_, None, Some(_)) => "no position was found in the box that is valid; the nearest".to_string(),
        (_, None, None) => format!("the goal of {} is not valid", scene.name()),
    }
}

fn answer(scene: &Scene, is_compiled: bool, options: &PlanOptions, found: &PlanResult, route: &Route) -> Verdict {
    let reason = || found.reason().map_or(String::new(), |worst| format!(": {}", worst.sentence()));
    match found.status {
        Status::Solved => solved(scene, options, found),
        Status::BudgetSpent if !is_compiled => {
            Verdict::no("no path found", ": the time budget ran out while the scene was being compiled".to_string())
        }
        Status::BudgetSpent | Status::Interrupted => {
            let (samples, ms) = (count(found.stats.samples, "sample"), found.stats.planning_seconds * 1e3);
            let through = found.opening_below.map(|width| format!(", through openings below {}", small_length(width)));
            let through = through.unwrap_or_default();
            let rest = format!(" after {samples} ({ms:.1} ms, seed {}); there may still be one{through}", options.seed);
            Verdict::no("no path found", rest)
        }
        Status::NoPath => {
            let reason = found.no_path.as_ref().map_or(String::new(), |no_path| no_path.reason());
            Verdict::no("no path exists:", format!(" {}{reason}", part_words(found)))
        }
        Status::StartInvalid => Verdict::no("no:", format!(" the start of {} is not valid{}", scene.name(), reason())),
        Status::GoalInvalid => Verdict::no("no:", format!(" {}{}", invalid_goal_words(scene, found, route), reason())),
    }
}

/// The lines about an invalid start or goal: all other violations, and a valid position nearby.
fn invalid_end_lines(found: &PlanResult) -> Vec<String> {
    let others = found.reasons.iter().skip(1).map(|violation| format!("  also: {}", violation.sentence()));
    let nearest = found.nearest_valid.map(|place| format!("a valid position near it: {}", position(&place)));
    others.chain(nearest).collect()
}

fn solved(scene: &Scene, options: &PlanOptions, found: &PlanResult) -> Verdict {
    let PlanResult { path, stats, .. } = found;
    let (before, done) = match options.post() {
        Post::None => ("", ""),
        _ if !scene.keeps_orientation(path) => ("before shortening, ", "shortening"),
        Post::StringPulling => ("before string pulling, ", "string pulling"),
        _ => ("before rewinding, ", "rewinding"),
    };
    let before = if before.is_empty() { String::new() } else { format!("{} m {before}", short(found.raw_cost)) };
    let done = if done.is_empty() { String::new() } else { format!("{done} {:.2} ms; ", stats.post_seconds * 1e3) };
    let found_by = match found.found_by {
        FoundBy::Planner => String::new(),
        FoundBy::Decision => format!("; found by the decision, not by {}", options.planner.planner().name()),
        FoundBy::Kept => "; the given path, still valid".to_string(),
        FoundBy::Repaired => "; the given path, repaired".to_string(),
    };
    let rest = format!(
        " {} m with {} ({before}{}){}{found_by}\n\
         searched {:.2} ms ({}, {}, seed {}); {done}every segment rechecked",
        short(found.cost),
        count(path.len(), "waypoint"),
        straight_words(scene, path),
        turn_words(scene, path),
        stats.planning_seconds * 1e3,
        count(stats.nodes, "node"),
        count(stats.motion_checks, "motion check"),
        options.seed,
    );
    Verdict::yes("solved:", rest)
}

/// The length of the motion straight from the first pose to the last.
fn straight_words(scene: &Scene, path: &[Pose]) -> String {
    let ends = [path[0], path[path.len() - 1]];
    let turn = if ends[0].angle_to(&ends[1]) > SAME_TURN { " with a turn" } else { "" };
    format!("{} m in a straight line{turn}", short(length(scene, &ends)))
}

/// How far the platform turns, and what this adds to the length; nothing if it keeps its orientation.
fn turn_words(scene: &Scene, path: &[Pose]) -> String {
    if scene.keeps_orientation(path) {
        return String::new();
    }
    let added = length(scene, path) - path_length(&positions(path));
    format!("; {}, which counts as {} m", turns(path), short(added))
}

/// An orientation as given on the command line.
fn words(orientation: &OrientationSource) -> String {
    match orientation {
        OrientationSource::Named(name) => format!("{name:?}"),
        OrientationSource::Quaternion(numbers) => numbers.map(|x| x.to_string()).join(","),
    }
}

/// Prints what to do next; `turns` tells whether the platform may turn on its way.
fn say_next(args: &PlanArgs, asked: &Scene, (found, turns): (&PlanResult, bool), out: &Console) {
    let scene = args.scene.scene.display();
    let turned =
        args.scene.orientation.as_ref().map_or(String::new(), |turn| format!(" --orientation {}", words(turn)));
    match (found.status, &args.output) {
        (Status::Solved, Some(path)) if !is_stream(path) => {
            out.say(&format!("next: cdpr check {scene} {}{turned}", path.display()))
        }
        (Status::Solved, None) if args.trajectory.as_ref().is_some_and(|path| !is_stream(path)) => {}
        (Status::Solved, None) if args.scene.format == Format::Text => {
            out.say("next: add -o path.json to write the path, and --html view.html for a picture");
        }
        (Status::BudgetSpent, _) if found.stats.samples == 0 => out.say("next: try a larger --budget-ms"),
        (Status::BudgetSpent, _) => out.say("next: try a larger --max-samples or another --seed"),
        (Status::NoPath, _) => match &args.proof {
            _ if found.route.is_some() => {}
            Some(_) if args.start.is_some() || args.route.goal().is_some() || args.replan.is_some() => {} // `check` asks about the ends of the scene
            Some(proof) if !is_stream(proof) => {
                out.say(&format!("next: cdpr check {scene} {}{turned}", proof.display()))
            }
            Some(_) => {}
            None => out.say(&format!("next: cdpr plan {scene}{turned} --proof proof.json, and check that")),
        },
        (Status::StartInvalid | Status::GoalInvalid, _) => {
            if let Some((cables, obstacle)) = stands_beside(asked, found) {
                let pairs: Vec<String> = cables.iter().map(|cable| format!("[{cable:?}, {obstacle:?}]")).collect();
                out.say(&format!(
                    "next: only the platform may touch {obstacle}; to let {} do so as well, add {} to `touch`",
                    cables.join(", "),
                    pairs.join(", ")
                ));
            }
            let turned = if turns { " or orientation (--start-orientation, --goal-orientation)" } else { "" };
            out.say(&format!(
                "next: choose another position (--start, --goal){turned}, or inspect it: cdpr view {scene} -o view.html"
            ));
        }
        _ => {}
    }
}

/// The obstacle that a shortest path touches on its way, if no clearance is required of it.
fn touched<'a>(args: &PlanArgs, scene: &Scene, nearest: &'a Nearest) -> Option<&'a str> {
    let nearest =
        nearest.min_clearance.as_ref().filter(|nearest| nearest.value < TOUCHING && nearest.required == 0.0)?;
    let from_start = nearest.segment == 0 && nearest.at == 0.0;
    if from_start || args.maximise.is_some() || !args.route.is_plain() || args.scene.format != Format::Text {
        return None;
    }
    let is_obstacle = |name: &&String| scene.obstacles().iter().any(|obstacle| obstacle.name == **name);
    nearest.culprits.iter().find(is_obstacle).map(String::as_str)
}

/// A path is far longer than a bound if it is longer than this multiple of it.
const FAR_ABOVE: f64 = 1.05;

/// Gap below which a path touches an obstacle as far as a user is concerned, m.
const TOUCHING: f64 = 1e-5;

/// The cables and the obstacle that make start or goal invalid, if the platform may touch that obstacle: a cable attached at the
/// point of contact comes as close as the platform.
fn stands_beside<'a>(scene: &Scene, found: &'a PlanResult) -> Option<(Vec<&'a str>, &'a str)> {
    let touches = |name: &str| {
        let index = scene.obstacles().iter().position(|known| known.name == name);
        index.is_some_and(|k| scene.pairs().between(Member::Platform, Member::Obstacle(k)) == PairRule::Touch)
    };
    let beside = |reason: &&Violation| reason.kind == Kind::CableObstacle && reason.gap >= Some(-TOUCH_DEPTH);
    let pairs = found.reasons.iter().filter(beside).filter_map(|reason| match &reason.culprits[..] {
        [cable, obstacle] if touches(obstacle) => Some((cable.as_str(), obstacle.as_str())),
        _ => None,
    });
    let pairs: Vec<(&str, &str)> = pairs.collect();
    let obstacle = pairs.first()?.1;
    let mut cables: Vec<&str> = pairs.iter().filter(|(_, other)| *other == obstacle).map(|(cable, _)| *cable).collect();
    cables.sort_unstable();
    Some((cables, obstacle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_proof_that_is_too_large_to_be_checked_says_so() {
        assert_eq!(unchecked_words(MOST_CERTIFICATE_BOXES), "");
        assert_eq!(unchecked_words(1_362_383), ": 1362383 boxes, but at most 1000000 are checked");
    }
}
