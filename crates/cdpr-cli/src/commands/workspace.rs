//! `cdpr workspace`

use std::path::Path;

use cdpr_core::batch::BatchOptions;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::error::ErrorClass;
use cdpr_core::model::OrientationSource;
use cdpr_core::watch::Watch;
use cdpr_core::words::small_length;
use cdpr_core::workspace::{Ended, Part, Share, ValidAt, Workspace, WorkspaceOptions, divided, orientations_for};
use cdpr_core::{Error, Scene};
use cdpr_files::{WorkspaceFormat, workspace_bytes};
use cdpr_view::workspace_page;

use super::view::IN_BROWSER;
use crate::Answer;
use crate::args::{Format, WorkspaceArgs};
use crate::input;
use crate::output::{
    Console, Verdict, count, is_standard_output, is_stream, position, robot_line, scene_line, thousandths,
};
use crate::progress::with_progress;

pub fn run(args: &WorkspaceArgs, out: &Console) -> Result<Answer, Error> {
    if [&args.output, &args.html].iter().all(|file| file.as_deref().is_some_and(is_standard_output)) {
        let problem = "found - for both -o and --html; only one of them can be standard output";
        return Err(Error::invalid("", problem));
    }
    let out = &out.beside(args.output.as_deref()).beside(args.html.as_deref());
    let scene = input::scene(&args.scene, out)?;
    let scenes = oriented(args, &scene)?;
    let found = match proved(args, &scenes, out) {
        Err(error) if error.class() == ErrorClass::OutOfTime => {
            let why = " the time budget ran out before the first box was judged";
            match args.scene.format {
                Format::Json => out.say(&format!("nothing is proved:{why}")),
                Format::Text => out.verdict(&Verdict::no("nothing is proved:", why.to_string())),
            }
            return Ok(Answer::No);
        }
        found => found.map_err(|e| args.given.blamed(e, &args.scene.scene))?,
    };
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", found.summary())),
        Format::Text => {
            out.result(&if let [one] = &scenes[..] { scene_line(one) } else { robot_line(&scene) });
            lines(&found).iter().for_each(|line| out.result(line));
        }
    }
    if let Some(output) = &args.output {
        out.write(output, &workspace_bytes(format(output)?, &found).map_err(|e| e.at("--output"))?, "")?;
    }
    if let Some(page) = &args.html {
        let shown = workspace_page(&scene, &found).map_err(|e| e.at("--html"))?;
        out.write(page, shown.as_bytes(), IN_BROWSER)?;
    }
    let answer = if found.volume.min > 0.0 { Answer::Yes } else { Answer::No };
    std::mem::forget(found); // the end of the program frees it at once, and not box by box
    Ok(answer)
}

fn format(output: &Path) -> Result<WorkspaceFormat, Error> {
    if is_stream(output) { Ok(WorkspaceFormat::Json) } else { WorkspaceFormat::of(output) }
}

/// The scene at each orientation.
fn oriented(args: &WorkspaceArgs, scene: &Scene) -> Result<Vec<Scene>, Error> {
    if args.orientations.is_empty() {
        return Ok(vec![scene.clone()]);
    }
    let turned = |source: &OrientationSource| {
        scene.named_orientation("--orientations", source)?;
        scene.turned(source.clone())
    };
    let given: Vec<Scene> = args.orientations.iter().map(turned).collect::<Result<_, _>>()?;
    orientations_for(&given, args.valid_at).map_err(|e| e.at("--orientations"))
}

fn proved(args: &WorkspaceArgs, scenes: &[Scene], out: &Console) -> Result<Workspace, Error> {
    let options = WorkspaceOptions { resolution: args.resolution, valid_at: args.valid_at };
    let mut compiled = Vec::new();
    let divided = with_progress(out, "dividing", |stop| {
        let watch = Watch::on(stop).with_budget(args.budget_ms);
        for scene in scenes {
            compiled.push(CompiledScene::new(scene, Default::default(), Default::default(), &watch)?);
        }
        divided(&compiled.iter().collect::<Vec<_>>(), &options, &BatchOptions { threads: None, watch })
    })?;
    let mut told = Vec::new();
    for at in divided.compiled() {
        let notes = at.conditions().remarks();
        if !told.contains(&notes) {
            out.remarks(at.scene(), at.conditions());
            told.push(notes);
        }
    }
    Ok(divided.workspace())
}

/// Most parts, and most bodies of a kind of condition, that are printed.
const MOST_LINES: usize = 5;

fn lines(found: &Workspace) -> Vec<String> {
    let unit = found.unit();
    let percent = |volume: f64| format!("{:.2} %", 100.0 * volume / found.total);
    let mut lines: Vec<String> = several(found).into_iter().collect();
    lines.extend([
        format!(
            "volume from {} to {} {unit}, {} to {} of the {} {unit} where the platform is inside the workspace",
            thousandths(found.volume.min),
            thousandths(found.volume.max),
            percent(found.volume.min),
            percent(found.volume.max),
            thousandths(found.total),
        ),
        format!(
            "decided {:.2} %, {}, the smallest with sides of {}{}",
            100.0 * found.decided,
            count(found.boxes.len(), "box"),
            small_length(found.finest),
            ended(found.ended)
        ),
    ]);
    let parts = found.parts.iter().enumerate().take(MOST_LINES);
    lines.extend(parts.map(|(k, part)| part_line(k, part, unit)));
    lines.extend(more(found.parts.len(), "part"));
    lines.extend(found.shares.iter().map(|(condition, share)| share_line(condition, share, &percent)));
    lines
}

/// At which of several orientations positions are valid.
fn several(found: &Workspace) -> Option<String> {
    let valid_at = found.valid_at?;
    let of = |name: &Option<String>, [w, x, y, z]: [f64; 4]| {
        name.clone().unwrap_or_else(|| [w, x, y, z].map(|part| format!("{part:.4}")).join(","))
    };
    let first = of(&found.orientation_name, found.orientation);
    let others = found.more_orientations.iter().map(|other| of(&other.name, other.orientation));
    let names: Vec<String> = std::iter::once(first).chain(others).collect();
    let number = count(names.len(), "orientation");
    Some(match valid_at {
        ValidAt::Every => format!("positions valid at every one of {number}: {}", names.join(", ")),
        ValidAt::Any => format!("positions valid at any of {number}: {}", names.join(", ")),
        ValidAt::Turns => {
            let ends = [&names[0], &names[names.len() - 1]].map(String::as_str).join(" to ");
            format!("positions valid during the turns from {ends}; {number} judged on the way")
        }
    })
}

fn ended(ended: Ended) -> &'static str {
    match ended {
        Ended::Complete => "",
        Ended::Budget => "; time ran out",
        Ended::Interrupted => "; interrupted",
        Ended::TooManyBoxes => "; more would not fit into memory",
    }
}

fn part_line(k: usize, part: &Part, unit: &str) -> String {
    let holds = match (part.start, part.goal) {
        (true, true) => ", with start and goal",
        (true, false) => ", with the start",
        (false, true) => ", with the goal",
        (false, false) => "",
    };
    let [min, max] = [part.extent.min, part.extent.max].map(|corner| position(&corner.into()));
    format!("part {}: {} {unit}, from {min} to {max} m{holds}", k + 1, thousandths(part.volume))
}

fn more(number: usize, thing: &str) -> Option<String> {
    (number > MOST_LINES).then(|| format!("and {} more", count(number - MOST_LINES, thing)))
}

fn share_line(condition: &str, share: &Share, percent: &dyn Fn(f64) -> String) -> String {
    let mut culprits: Vec<(&String, &f64)> = share.culprits.iter().collect();
    culprits.sort_by(|a, b| b.1.total_cmp(a.1));
    let mut told: Vec<String> =
        culprits.iter().take(MOST_LINES).map(|(names, volume)| format!("{names} {}", percent(**volume))).collect();
    told.extend(more(culprits.len(), "pair"));
    let told = if told.is_empty() { String::new() } else { format!(": {}", told.join(", ")) };
    format!("{condition} takes {}{told}", percent(share.volume))
}
