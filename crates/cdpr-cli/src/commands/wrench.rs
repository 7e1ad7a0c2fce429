//! `cdpr wrench`

use std::path::Path;

use cdpr_core::batch::BatchOptions;
use cdpr_core::collision::Conditions;
use cdpr_core::geometry::{Aabb, Point, Pose, rotation_as_written};
use cdpr_core::model::Distribution;
use cdpr_core::path::{lengths_along, tensions_along};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::map::Place;
use cdpr_core::wrench::{
    LengthRow, Loads, MapOptions, Required, Settling, Statics, TensionRow, WrenchMap, WrenchReport, constraint,
    wrench_of_scene_at,
};
use cdpr_core::{Error, Scene};

use crate::Answer;
use crate::args::{Format, WrenchArgs};
use crate::input;
use crate::interruption::interrupted;
use crate::output::{Console, count, position, robot_line, scene_line, thousandths};
use crate::progress::with_progress;

pub fn run(args: &WrenchArgs, out: &Console) -> Result<Answer, Error> {
    let scene = args.tensions.in_scene(input::scene(&args.scene, out)?);
    match (&args.at, args.grid, &args.along) {
        (Some(at), _, _) => {
            let (scene, at) = input::at(at, &args.scene, scene)?;
            at_position(args, &scene, &at, out)
        }
        (_, Some(step), _) => map(args, &scene, step, out),
        (_, _, path) => along(args, &scene, path.as_deref().expect("clap asks for one of the three"), out),
    }
}

/// The required wrenches, by options or the scene.
fn required(args: &WrenchArgs, scene: &Scene) -> Result<Required, Error> {
    constraint::required_of(scene, args.force, args.moment).map_err(|e| args.given.named(e).0)
}

/// The scene's statics in its first load case, and the required wrenches.
fn asked(args: &WrenchArgs, scene: &Scene) -> Result<(Statics, Required), Error> {
    let statics = Statics::of(scene).map_err(|e| e.in_file(&args.scene.scene))?;
    Ok((statics, required(args, scene)?))
}

fn at_position(args: &WrenchArgs, scene: &Scene, at: &Point, out: &Console) -> Result<Answer, Error> {
    let report = wrench_of_scene_at(scene, &required(args, scene)?, at).map_err(|e| e.in_file(&args.scene.scene))?;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(report))),
        Format::Text => {
            out.result(&scene_line(scene));
            report_lines(&report, &position(at)).iter().for_each(|line| out.result(line));
        }
    }
    Ok(if report.feasible { Answer::Yes } else { Answer::No })
}

fn along(args: &WrenchArgs, scene: &Scene, path: &Path, out: &Console) -> Result<Answer, Error> {
    let out = &out.beside(args.output.as_deref());
    let (scene, loaded) = input::path(scene, &args.scene, path, args.strict, &|warning| out.warning(warning))?;
    let path = loaded.path(&scene);
    let demanded = scene.wrench().is_some() || args.force.is_some() || args.moment.is_some();
    match asked(args, &scene) {
        Err(lacking) if !scene.robot().knows_its_forces() && !demanded => {
            out.note(&format!("lengths only: {lacking}"));
            lengths(args, &scene, &path, out)
        }
        asked => tensions(args, &scene, asked?, &path, out),
    }
}

fn lengths(args: &WrenchArgs, scene: &Scene, path: &[Pose], out: &Console) -> Result<Answer, Error> {
    let rows = lengths_along(scene, path, args.step)?;
    let names = scene.robot().cable_names();
    let json = serde_json::json!({ "cables": names, "rows": rows });
    let summary = || {
        let mut lines = vec![path_line(scene, &rows[0]), count(rows.len(), "place")];
        lines.extend(length_lines(&names, &rows.iter().collect::<Vec<_>>()));
        lines
    };
    print_rows(args, &json, &cdpr_files::lengths_csv(&names, &rows), summary, out)?;
    Ok(Answer::Yes)
}

fn tensions(
    args: &WrenchArgs,
    scene: &Scene,
    (statics, required): (Statics, Required),
    path: &[Pose],
    out: &Console,
) -> Result<Answer, Error> {
    let rows = tensions_along(scene, &required, path, args.step, None, &Watch::on(&interrupted));
    let rows = rows.map_err(|e| e.in_file(&args.scene.scene))?;
    let names = scene.robot().cable_names();
    let json = serde_json::json!({ "cables": names, "rows": rows });
    let free = rows.iter().find_map(|row| {
        let there = row.place.orientation.map(|turn| Loads::of(scene).at(&rotation_as_written(turn)));
        let turned = there.and_then(|loads| Statics::new(scene.robot(), &loads).ok());
        let statics = turned.as_ref().unwrap_or(&statics);
        let hold = statics.hold(&row.place.position.into()).filter(|hold| !hold.is_full())?;
        Some(format!("{}, at {:.4} m", hold.sentence(), row.place.s))
    });
    free.iter().for_each(|free| out.note(free));
    if statics.distribution() == Distribution::ClosedForm && rows.iter().any(|row| row.tensions.is_none()) {
        out.note("where there are no tensions, those in closed form exceed a limit; others may keep them (--tensions middle)");
    }
    print_rows(args, &json, &cdpr_files::tensions_csv(&names, &rows), || summary(scene, &names, &rows), out)?;
    Ok(if rows.iter().all(|row| row.tensions.is_some()) { Answer::Yes } else { Answer::No })
}

/// The first line of a summary, without the scene's orientation if the platform turns.
fn path_line(scene: &Scene, first: &LengthRow) -> String {
    if first.orientation.is_some() { robot_line(scene) } else { scene_line(scene) }
}

/// Prints rows along a path as requested: JSON, a summary if a CSV file is written, or the CSV itself.
fn print_rows(
    args: &WrenchArgs,
    json: &serde_json::Value,
    csv: &str,
    summary: impl Fn() -> Vec<String>,
    out: &Console,
) -> Result<(), Error> {
    if let Some(output) = &args.output {
        out.write(output, csv.as_bytes(), "")?;
    }
    match args.scene.format {
        Format::Json => out.result(&format!("{json:#}")),
        Format::Text if args.output.is_none() => out.result(csv.trim_end()),
        Format::Text => summary().iter().for_each(|line| out.result(line)),
    }
    Ok(())
}

fn report_lines(report: &WrenchReport, at: &str) -> Vec<String> {
    let verdict = if report.feasible { "feasible" } else { "not feasible" };
    let mut lines = vec![format!("{verdict} at {at}: capacity margin {} N", thousandths(report.capacity_margin))];
    lines.extend(report.limit.load_case.map(|case| format!("least favourable load case: {case}")));
    lines.push(report.hold.sentence());
    let moment =
        report.moment_margin.map_or("none (point mass)".to_string(), |margin| format!("{} N·m", thousandths(margin)));
    lines.push(format!("force margin {} N, moment margin {moment}", thousandths(report.force_margin)));
    lines.push(format!("limited by: {}", saturated(report)));
    match &report.tensions {
        None => {
            lines.push(match report.balanced {
                true => "tensions in closed form exceed a limit, although others keep them; cable lengths:".to_string(),
                false => "no tensions within the limits balance the loads; cable lengths:".to_string(),
            });
            let lengths = report.cables.iter().zip(&report.lengths);
            lines.extend(lengths.map(|(cable, length)| format!("  {cable}: {length:.4} m")));
        }
        Some(tensions) => {
            if !report.hold.is_full() {
                lines.push(
                    "the loads alone are balanced here, but a disturbance along a free motion is not".to_string(),
                );
            }
            lines.push(format!("{}:", tensions_in_words(report.tension_distribution)));
            let cables = report.cables.iter().zip(tensions).zip(&report.lengths);
            lines
                .extend(cables.map(|((cable, tension), length)| {
                    format!("  {cable}: {} N, {length:.4} m", thousandths(*tension))
                }));
        }
    }
    lines.extend(report.settling.as_ref().map(settling_line));
    lines
}

/// What tensions are, in words.
fn tensions_in_words(chosen: Distribution) -> &'static str {
    match chosen {
        Distribution::Middle => "tensions nearest to the middle of their limits",
        Distribution::Least => "the smallest tensions",
        Distribution::P4 => "tensions with the smallest 4-norm of deviations from the middle of their limits",
        Distribution::P8 => "tensions with the smallest 8-norm of deviations from the middle of their limits",
        Distribution::ClosedForm => "tensions in closed form, nearest to the middle of their limits",
    }
}

/// How far the platform settles, in words.
pub fn settling_line(settling: &Settling) -> String {
    let Settling { displacement, rotation } = settling;
    format!(
        "if the winches ignore the stretch of the cables, the platform settles by {:.1} mm and {:.2}°",
        1e3 * displacement,
        rotation.to_degrees()
    )
}

fn saturated(report: &WrenchReport) -> String {
    let side =
        |cables: &[String], which: &str| (!cables.is_empty()).then(|| format!("{} at {which}", cables.join(", ")));
    let sides: Vec<String> =
        [side(&report.limit.at_greatest, "greatest tension"), side(&report.limit.at_least, "least tension")]
            .into_iter()
            .flatten()
            .collect();
    if sides.is_empty() { "no cable (the set is flat)".to_string() } else { sides.join("; ") }
}

/// A number of a cable, with its place along a path.
type Found<'a> = Option<(f64, &'a str, f64)>;

/// The smallest and the largest number, each with its cable and place.
fn extremes<'a>(numbers: impl Iterator<Item = (f64, &'a str, f64)>) -> [Found<'a>; 2] {
    let all: Vec<(f64, &str, f64)> = numbers.collect();
    [all.iter().min_by(|a, b| a.0.total_cmp(&b.0)).copied(), all.iter().max_by(|a, b| a.0.total_cmp(&b.0)).copied()]
}

fn length_lines(names: &[&str], rows: &[&LengthRow]) -> Vec<String> {
    let lengths =
        rows.iter().flat_map(|row| row.lengths.iter().zip(names).map(|(length, cable)| (*length, *cable, row.s)));
    let line = |(what, found): (&str, Found)| {
        found.map(|(length, cable, s)| format!("{what} cable {length:.4} m: {cable} at {s:.4} m"))
    };
    ["shortest", "longest"].into_iter().zip(extremes(lengths)).filter_map(line).collect()
}

fn summary(scene: &Scene, names: &[&str], rows: &[TensionRow]) -> Vec<String> {
    let balanced = rows.iter().filter(|row| row.tensions.is_some()).count();
    let tensions = rows.iter().flat_map(|row| {
        let tensions = row.tensions.iter().flatten();
        tensions.zip(names).map(|(tension, cable)| (*tension, *cable, row.place.s))
    });
    let line = |(what, found): (&str, Found)| {
        found.map(|(tension, cable, s)| format!("{what} tension {} N: {cable} at {s:.4} m", thousandths(tension)))
    };
    let scarcest = rows.iter().filter_map(|row| row.capacity_margin.map(|margin| (margin, row.place.s)));
    let mut lines = vec![path_line(scene, &rows[0].place)];
    lines.push(format!("{} places, the loads balanced at {balanced} of them", rows.len()));
    lines.extend(["least", "greatest"].into_iter().zip(extremes(tensions)).filter_map(line));
    lines.extend(
        scarcest
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(margin, s)| format!("least capacity margin {} N at {s:.4} m", thousandths(margin))),
    );
    lines.extend(length_lines(names, &rows.iter().map(|row| &row.place).collect::<Vec<_>>()));
    lines
}

fn map(args: &WrenchArgs, scene: &Scene, step: f64, out: &Console) -> Result<Answer, Error> {
    let statics = Statics::only(scene, "a map").map_err(|e| e.in_file(&args.scene.scene))?;
    let required = required(args, scene)?;
    let output = args.output.as_deref().expect("clap asks for it");
    let (min, max) = Conditions::within(scene, &Watch::on(&interrupted))?.position_box();
    if (min - max).max() > 0.0 {
        return Err(Error::invalid(
            "workspace",
            "found one that the platform does not fit into, so there are no positions",
        )
        .in_file(&args.scene.scene));
    }
    let options = MapOptions { step, projected: args.projected };
    let map = with_progress(out, "measuring", |stop| {
        let batch = BatchOptions { threads: None, watch: Watch::on(stop) };
        WrenchMap::new(&statics, &required, &Aabb { min, max }, &options, &batch)
    })
    .map_err(|e| if e.place() == Some("step") { e.at("--grid") } else { e })?;
    let found = map.summary();
    match args.scene.format {
        Format::Json => {
            let mut json = serde_json::json!(found);
            json["fingerprint"] = map.identity().fingerprint().into();
            out.result(&format!("{json:#}"));
        }
        Format::Text => {
            out.result(&scene_line(scene));
            let [nx, ny, nz] = found.grid.counts;
            let share = 100.0 * found.share;
            out.result(&format!(
                "{} of {} nodes feasible ({nx} x {ny} x {nz}), {share:.1} %",
                found.feasible, found.nodes
            ));
            out.result(&format!("feasible volume {:.3} m³", found.volume));
            let extent = found.extent.iter().map(|e| format!("from {} to {} m", position(&e.min), position(&e.max)));
            extent.for_each(|extent| out.result(&format!("its extent {extent}")));
            for (what, place) in [("least", &found.least), ("greatest", &found.greatest)] {
                let told =
                    |p: &Place| format!("{what} margin {} N at {}", thousandths(p.margin), position(&p.position));
                place.iter().for_each(|place| out.result(&told(place)));
            }
        }
    }
    out.save(output, "", || cdpr_files::save_wrench_map(output, &map))?;
    Ok(if found.feasible > 0 { Answer::Yes } else { Answer::No })
}
