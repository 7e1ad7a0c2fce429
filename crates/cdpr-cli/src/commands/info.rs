//! `cdpr info`

use cdpr_core::Error;
use cdpr_core::survey::{CableShapes, ObstacleBox, Survey, survey};
use cdpr_core::watch::Watch;
use cdpr_core::words::small_length;

use super::check::exempt_lines;
use super::wrench::settling_line;
use crate::Answer;
use crate::args::{Format, SceneArgs};
use crate::input;
use crate::interruption::interrupted;
use crate::output::{Console, count, scene_line, short};

pub fn run(args: &SceneArgs, out: &Console) -> Result<Answer, Error> {
    let scene = input::scene(args, out)?;
    let survey = survey(&scene, &Watch::on(&interrupted)).map_err(|e| e.in_file(&args.scene))?;
    match args.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(survey))),
        Format::Text => {
            out.result(&scene_line(&scene));
            lines(&survey, &out.in_brief(&scene, &survey.notes)).iter().for_each(|line| out.result(line));
        }
    }
    Ok(Answer::Yes)
}

fn lines(s: &Survey, notes: &[String]) -> Vec<String> {
    let mut lines = vec![format!("parts: platform {}, obstacles {}", s.platform_parts, s.obstacle_parts)];
    if !s.orientations.is_empty() {
        let this = s.orientation_name.as_ref().map_or(format!("{:?}", s.orientation), |name| name.to_string());
        lines.push(format!("orientations: {}; everything below is for {this}", s.orientations.join(", ")));
    }
    let xyz = |p: &[f64; 3]| p.map(short).join(", ");
    lines.push(match &s.position_box {
        Some([min, max]) => format!("positions: from ({}) to ({}) m", xyz(min), xyz(max)),
        None => "positions: none, the platform does not fit into the workspace".to_string(),
    });
    lines.extend(sizes(s));
    lines.extend(shapes(s));
    if let (Some([low, high]), Some(hold)) = (s.wrench_rank, &s.hold) {
        let at_best = if low < high { format!(" (up to {high} elsewhere)") } else { String::new() };
        lines.push(format!("wrench matrix: {}{at_best}", hold.sentence()));
    }
    let pairs = |pairs: &[[String; 2]]| pairs.iter().map(|p| p.join(" and ")).collect::<Vec<_>>().join("; ");
    for (label, list) in [
        ("cables that share an end", &s.sharing_pairs),
        ("cables that always cross", &s.always_crossing_pairs),
        ("outlets on obstacles", &s.outlets_on_obstacles),
    ] {
        lines.push(format!("{label}: {}", if list.is_empty() { "none".to_string() } else { pairs(list) }));
    }
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    if let (Some(free), Some(valid)) = (s.interference_free, s.valid) {
        lines.push(format!(
            "of {}: {} without self-interference, {} valid",
            count(s.samples, "sampled position"),
            percent(free),
            percent(valid)
        ));
    }
    for (end, reason) in [("start", &s.start), ("goal", &s.goal)] {
        lines.extend(reason.iter().map(|r| format!("{end} is not valid: {}", r.sentence())));
    }
    let invalid = s.stations.iter().filter_map(|state| Some((&state.station, state.violation.as_ref()?)));
    let invalid: Vec<String> =
        invalid.map(|(name, reason)| format!("station {name} is not valid: {}", reason.sentence())).collect();
    if !s.stations.is_empty() {
        let valid = if invalid.is_empty() { "all valid".to_string() } else { format!("{} not valid", invalid.len()) };
        lines.push(format!("{}: {valid}", count(s.stations.len(), "station")));
    }
    lines.extend(invalid);
    lines.extend(s.settling.iter().map(|settling| format!("start: {}", settling_line(settling))));
    lines.extend(exempt_lines(&s.exempt.iter().map(|exemption| (exemption, None)).collect::<Vec<_>>()));
    lines.extend(notes.iter().map(|note| format!("note: {note}")));
    lines
}

/// How far cables can be from straight lines from their outlets.
fn shapes(s: &Survey) -> Option<String> {
    let most = |of: fn(&CableShapes) -> f64| s.cable_shapes.iter().max_by(|a, b| of(a).total_cmp(&of(b)));
    let (deepest, farthest) = (most(|c| c.sag)?, most(|c| c.exit)?);
    let sag = format!(
        "sag up to {} at {} (its weight is up to {} of its tension)",
        small_length(deepest.sag),
        deepest.cable,
        short(deepest.slackness)
    );
    let exit = format!("exit points within {} of their outlets", small_length(farthest.exit));
    let said = [(deepest.sag, sag), (farthest.exit, exit)].into_iter().filter(|(size, _)| *size > 0.0);
    Some(format!("shapes of cables: {}", said.map(|(_, words)| words).collect::<Vec<_>>().join(", ")))
}

/// Obstacles whose sizes are printed one by one.
const LISTED: usize = 8;

/// Cable lengths and sizes of obstacles, in which a wrong unit shows.
fn sizes(s: &Survey) -> Vec<String> {
    let [shortest, longest] = [0, 1].map(|k| s.cable_lengths.iter().map(move |range| range.length[k]));
    let (shortest, longest) = (shortest.fold(f64::INFINITY, f64::min), longest.fold(0.0, f64::max));
    let lengths = (!s.cable_lengths.is_empty())
        .then(|| format!("cable lengths: from {} to {} m at these positions", short(shortest), short(longest)));
    let size = |o: &ObstacleBox| {
        let [x, y, z] = [0, 1, 2].map(|k| short(o.max[k] - o.min[k]));
        format!("{} {x} x {y} x {z} m", o.obstacle)
    };
    let listed: Vec<String> = s.obstacle_boxes.iter().take(LISTED).map(size).collect();
    let more = s.obstacle_boxes.len().checked_sub(LISTED).filter(|more| *more > 0);
    let more = more.map_or(String::new(), |more| format!("; and {more} more"));
    let boxes = (!listed.is_empty()).then(|| format!("boxes around obstacles: {}{more}", listed.join("; ")));
    lengths.into_iter().chain(boxes).collect()
}
